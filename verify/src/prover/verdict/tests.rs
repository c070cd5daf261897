use super::super::data::Data;
use super::{Trace, Verdict, trace, verdict};
use crate::prover::module::{Cover, Harness, Module};
use std::collections::BTreeSet;

fn module() -> Module {
    let mut data = Data::default();
    data.add(2048, b"a.rs").unwrap();
    let covers = vec![Cover { file: 2048, length: 4, line: 9 }];
    Module { harnesses: Vec::new(), covers, data, table: 0 }
}

fn harness(covers: &[usize], assumes: usize) -> Harness {
    let covers: BTreeSet<usize> = covers.iter().copied().collect();
    Harness { name: "h".to_owned(), unwind: None, solver: None, covers, assumes }
}

/// What CBMC prints, with the given changes of status, and more properties.
fn printed(changes: &[(&str, &str)], more: &str) -> String {
    let mut properties = String::new();
    for (name, text, status) in [
        ("check_h.assertion.1", "end", "FAILURE"),
        ("check_other.assertion.1", "end", "SUCCESS"),
        ("w2c_kani_fail.assertion.1", "panic", "SUCCESS"),
        ("wasm_rt_trap.assertion.1", "trap", "SUCCESS"),
        ("w2c_kani_cover.assertion.1", "cover 0", "FAILURE"),
        ("w2c_kani_cover.assertion.2", "known cover", "SUCCESS"),
    ] {
        let change = changes.iter().find(|(of, _)| *of == text || *of == name);
        let status = change.map_or(status, |(_, status)| *status);
        if status != "missing" {
            properties.push_str(&format!(
                r#"{{"description":"{text}","property":"{name}","status":"{status}"}},"#
            ));
        }
    }
    let properties = format!("{properties}{more}");
    let properties = properties.trim_end_matches(',');
    format!(
        r#"[{{"program":"CBMC 6.6.0"}},
        {{"messageText":"converting SSA","messageType":"STATUS-MESSAGE"}},
        {{"result":[{properties}]}},{{"cProverStatus":"failure"}}]"#
    )
}

fn of(changes: &[(&str, &str)], more: &str) -> Verdict {
    verdict(&module(), &harness(&[0], 1), &printed(changes, more)).0
}

fn is_unclear(verdict: &Verdict) -> bool {
    matches!(verdict, Verdict::Unclear(_))
}

#[test]
fn a_proof_is_all_of_it() {
    assert_eq!(verdict(&module(), &harness(&[0], 1), &printed(&[], "")), (Verdict::Proved, 1));
}

#[test]
fn failures_are_told_by_their_property() {
    let Verdict::Fails { property, text } = of(&[("panic", "FAILURE")], "") else { panic!() };
    assert_eq!((property.as_str(), text.as_str()), ("w2c_kani_fail.assertion.1", "panic"));
    assert!(matches!(of(&[("trap", "FAILURE")], ""), Verdict::Fails { .. }));
}

#[test]
fn what_is_not_met_is_vacuous() {
    let Verdict::Vacuous(why) = of(&[("cover 0", "SUCCESS")], "") else { panic!() };
    assert!(why.contains("a.rs:9"), "{why}");
    // The end of another harness does not stand for this one's.
    let ends = [("check_h.assertion.1", "SUCCESS"), ("check_other.assertion.1", "FAILURE")];
    assert!(matches!(of(&ends, ""), Verdict::Vacuous(_)));
    let uncovered = verdict(&module(), &harness(&[], 1), &printed(&[("cover 0", "SUCCESS")], ""));
    assert!(matches!(uncovered.0, Verdict::Vacuous(_)));
    let nothing_assumed =
        verdict(&module(), &harness(&[], 0), &printed(&[("cover 0", "SUCCESS")], ""));
    assert_eq!(nothing_assumed.0, Verdict::Proved);
}

#[test]
fn nothing_unclear_is_a_proof() {
    for text in ["end", "panic", "trap", "cover 0", "known cover"] {
        assert!(is_unclear(&of(&[(text, "missing")], "")), "{text} missing");
        assert!(is_unclear(&of(&[(text, "UNKNOWN")], "")), "{text} unknown");
    }
    let loops = r#"{"description":"unwinding assertion loop 0","property":"f.unwind.0","status":"FAILURE"}"#;
    let Verdict::Unclear(why) = of(&[], loops) else { panic!() };
    assert!(why.contains("unwound"), "{why}");
    let other = loops.replace("unwinding assertion loop 0", "dereferenced function pointer");
    assert!(is_unclear(&of(&[], &other)));
    assert!(is_unclear(&of(&[("known cover", "FAILURE")], "")));
}

#[test]
fn output_that_breaks_off_or_complains() {
    let judged = |output: &str| verdict(&module(), &harness(&[0], 1), output).0;
    let whole = printed(&[], "");
    assert!(is_unclear(&judged(&whole[..whole.len() - 1])));
    assert!(is_unclear(&judged("[]")));
    assert!(is_unclear(&judged("")));
    let without_end = whole.replace(r#"{"cProverStatus":"failure"}"#, r#"{"program":""}"#);
    assert!(is_unclear(&judged(&without_end)));
    assert!(is_unclear(&judged(&whole.replace("\"failure\"}]", "\"error\"}]"))));
    let warned = whole.replace("STATUS-MESSAGE", "WARNING");
    assert!(is_unclear(&judged(&warned)));
    let silent = whole.replace("converting SSA", "the solver is not available");
    assert!(is_unclear(&judged(&silent)));
}

#[test]
fn values_in_the_order_drawn() {
    let step = |hidden, lhs: &str, binary: &str| {
        format!(
            r#"{{"stepType":"assignment","hidden":{hidden},"lhs":"{lhs}","value":{{"binary":"{binary}"}}}}"#
        )
    };
    let steps = [
        step(true, "drawn_32", "00000000"),
        step(false, "drawn_32", "00000111"),
        step(false, "var_i0", "00000001"),
        step(false, "drawn_64", &"1".repeat(64)),
        step(false, "panic_location", "1000"),
        r#"{"stepType":"failure"}"#.to_owned(),
    ];
    let failed = format!(
        r#"{{"description":"panic","property":"p","status":"FAILURE","trace":[{}]}}"#,
        steps.join(",")
    );
    let expected = Trace { values: vec![7, u64::MAX], location: Some(8) };
    assert_eq!(trace(&printed(&[("panic", "missing")], &failed)), Ok(expected));
    assert!(trace(&printed(&[], "")).is_err());
}
