use super::{Claims, Error};

const CLAIM: &str = r#"
[[claim]]
id = "P1"
statement = "s"
domain = "d"
machine = "ppc/line"
harnesses = ["line_*", "other"]
"#;

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(ToString::to_string).collect()
}

fn check(harnesses: &[&str], machines: &[&str]) -> Result<(), Error> {
    let files = names(&["ppc/line", "ppc/arc"]);
    Claims::read(CLAIM)?.check(&names(harnesses), &files, &names(machines))
}

#[test]
fn claims_that_fit_what_there_is() {
    assert_eq!(check(&["line_step", "line_done", "other"], &["ppc/line"]), Ok(()));
}

#[test]
fn names_that_lead_nowhere() {
    let error = check(&["line_step"], &["ppc/line"]);
    let (id, harness) = ("P1".to_owned(), "other".to_owned());
    assert_eq!(error, Err(Error::NoHarness { id, harness }));
    let error = check(&["line_step", "other", "arc_step"], &["ppc/line"]);
    assert_eq!(error, Err(Error::Unclaimed("arc_step".to_owned())));
    let error = check(&["line_step", "other"], &["ppc/arc", "ppc/line"]);
    assert_eq!(error, Err(Error::Unguarded("ppc/arc".to_owned())));
    let claims = Claims::read(CLAIM).unwrap();
    let error = claims.check(&names(&["line_step", "other"]), &[], &[]);
    let (id, machine) = ("P1".to_owned(), "ppc/line".to_owned());
    assert_eq!(error, Err(Error::NoMachine { id, machine }));
}

#[test]
fn lists_at_fault() {
    let twice = format!("{CLAIM}{CLAIM}");
    assert!(matches!(Claims::read(&twice), Err(Error::Twice { .. })));
    let without_search = format!("{CLAIM}false_with = \"3 pulses\"");
    assert!(matches!(Claims::read(&without_search), Err(Error::NoSearch { .. })));
    let test = format!("{CLAIM}tests = [\"no_package\"]");
    assert!(matches!(Claims::read(&test), Err(Error::TestForm { .. })));
    let unknown = format!("{CLAIM}harness = [\"line\"]");
    let Err(Error::Form(why)) = Claims::read(&unknown) else { panic!("unknown keys are refused") };
    assert!(why.contains("unknown field `harness`"), "{why}");
}
