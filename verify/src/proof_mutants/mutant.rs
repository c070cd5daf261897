//! Every small change of the machines' code.

use super::functions::functions;
use super::tokens::{Token, tokens};

/// One small change of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Mutant {
    /// From the repository's root.
    pub(super) file: String,
    pub(super) function: String,
    /// What is replaced, and by what.
    at: usize,
    from: String,
    to: String,
    pub(super) number: usize,
    /// The line as it is, and as it becomes.
    pub(super) line: String,
    pub(super) changed: String,
}

/// What a machine says of itself: the specification, which harnesses assume and assert.
const SPECIFICATION: [&str; 7] = [
    "invariant",
    "invariant_given",
    "bounds_hold",
    "completes",
    "counters_hold",
    "dividers_hold",
    "passed",
];

/// Each operator that stands between two operands, and what is put in its place: its contrary, and
/// for an order also what differs at the boundary alone.
const OPERATORS: [(&str, &[&str]); 16] = [
    ("+", &["-"]),
    ("-", &["+"]),
    ("+=", &["-="]),
    ("-=", &["+="]),
    ("<", &[">=", "<="]),
    ("<=", &[">", "<"]),
    (">", &["<=", ">="]),
    (">=", &["<", ">"]),
    ("==", &["!="]),
    ("!=", &["=="]),
    ("&&", &["||"]),
    ("||", &["&&"]),
    ("<<", &[">>"]),
    (">>", &["<<"]),
    ("&", &["|"]),
    ("%", &["/"]),
];

impl Mutant {
    /// All mutants of a file, and how many were left out because they are in the specification.
    pub(super) fn of_file(file: &str, source: &str) -> (Vec<Self>, usize) {
        let tokens = tokens(source);
        let mut mutants = Vec::new();
        let mut specified = 0;
        for function in functions(&tokens) {
            for place in function.body {
                let changes = changes(source, &tokens, place);
                if SPECIFICATION.contains(&function.name) {
                    specified += changes.len();
                    continue;
                }
                let new = |to: &&str| Self::new(file, function.name, source, tokens[place], to);
                mutants.extend(changes.iter().map(new));
            }
        }
        (mutants, specified)
    }

    fn new(file: &str, function: &str, source: &str, token: Token<'_>, to: &str) -> Self {
        let Token { text: from, at } = token;
        let begin = source[..at].rfind('\n').map_or(0, |end| end + 1);
        let end = source[at..].find('\n').map_or(source.len(), |end| at + end);
        let changed = [&source[begin..at], to, &source[at + from.len()..end]].concat();
        Self {
            file: file.to_owned(),
            function: function.to_owned(),
            at,
            from: from.to_owned(),
            to: to.to_owned(),
            number: source[..begin].matches('\n').count() + 1,
            line: source[begin..end].trim().to_owned(),
            changed: changed.trim().to_owned(),
        }
    }

    /// The whole file with the change.
    pub(super) fn applied(&self, source: &str) -> String {
        let mut changed = source.to_owned();
        changed.replace_range(self.at..self.at + self.from.len(), &self.to);
        changed
    }

    /// For messages, and to know it again.
    pub(super) fn name(&self) -> String {
        format!("{}:{}: {} -> {}", self.file, self.number, self.line, self.changed)
    }
}

/// What is put in the place of a token. The source is formatted: operators between two operands have
/// space on both sides, and nothing else that looks like one has.
fn changes(source: &str, tokens: &[Token<'_>], place: usize) -> &'static [&'static str] {
    let token = tokens[place];
    let before = source[..token.at].ends_with(char::is_whitespace);
    let after = source[token.at + token.text.len()..].starts_with(char::is_whitespace);
    if before && after {
        let found = OPERATORS.into_iter().find(|(from, _)| *from == token.text);
        return found.map_or(&[], |(_, to)| to);
    }
    let is_next = |text: &str| tokens.get(place + 1).is_some_and(|next| next.text == text);
    let is_prefix = before || source[..token.at].ends_with(['(', '[', '=']);
    match token.text {
        "-" if !after => &[""],
        // Behind a name it is a macro's.
        "!" if !after && is_prefix => &[""],
        // The sign of a pulse, last in a table's row.
        "1" if tokens[place - 1].text == "," && is_next(")") => &["-1"],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::Mutant;

    #[test]
    fn operators_are_changed_and_nothing_that_looks_like_them() {
        let source = "
            /// a - b
            fn f<'a>(x: Option<u8>) -> u8 {
                let y: Vec<&'a u8> = x.map(|c| -c).collect::<Vec<_>>();
                if y >= 1 && !(x == *y) { a += b - -1 } else { (X, 1) }
            }
            fn invariant(&self) -> bool { self.f <= 1 }";
        let (mutants, specified) = Mutant::of_file("a.rs", source);
        assert_eq!(specified, 2);
        let tos: Vec<(&str, &str)> =
            mutants.iter().map(|mutant| (&*mutant.from, &*mutant.to)).collect();
        let expected = [
            ("-", ""),
            (">=", "<"),
            (">=", ">"),
            ("&&", "||"),
            ("!", ""),
            ("==", "!="),
            ("+=", "-="),
            ("-", "+"),
            ("-", ""),
            ("1", "-1"),
        ];
        assert_eq!(tos, expected);
        assert_eq!(mutants[0].number, 4);
        assert_eq!(mutants[0].changed, "let y: Vec<&'a u8> = x.map(|c| c).collect::<Vec<_>>();");
        assert!(mutants[1].applied(source).contains("if y < 1 && !(x"));
    }
}
