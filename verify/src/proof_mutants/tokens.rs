//! As much of Rust's lexical structure as it takes to tell code from comments and text.

/// A word, a number, a text, or an operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token<'s> {
    pub(super) text: &'s str,
    /// Its first byte.
    pub(super) at: usize,
}

/// Operators of more than one character, the longest first.
const OPERATORS: [&str; 24] = [
    "<<=", ">>=", "..=", "->", "=>", "==", "!=", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/=",
    "%=", "&=", "|=", "^=", "<<", ">>", "::", "..", "/*",
];

/// The tokens of a source, without its comments.
pub(super) fn tokens(source: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = source[at..].chars().next() {
        let rest = &source[at..];
        let length = if first.is_whitespace() {
            first.len_utf8()
        } else if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            comment(rest)
        } else {
            let length = length(rest, first);
            tokens.push(Token { text: &rest[..length], at });
            length
        };
        at += length;
    }
    tokens
}

/// The length of a block comment, others inside it included.
fn comment(rest: &str) -> usize {
    let mut depth = 0_usize;
    let mut at = 0;
    while at < rest.len() {
        let ahead = &rest.as_bytes()[at..];
        if ahead.starts_with(b"/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if ahead.starts_with(b"*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                return at;
            }
        } else {
            at += 1;
        }
    }
    rest.len()
}

fn length(rest: &str, first: char) -> usize {
    let word =
        |text: &str| text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    match first {
        '"' => quoted(rest, '"'),
        '\'' => {
            let mut after = rest.chars().skip(1);
            let is_lifetime = after.next() != Some('\\') && after.next() != Some('\'');
            if is_lifetime { 1 + word(&rest[1..]) } else { quoted(rest, '\'') }
        }
        _ if first.is_alphanumeric() || first == '_' => word(rest),
        _ => OPERATORS
            .iter()
            .find(|operator| rest.starts_with(**operator))
            .map_or(first.len_utf8(), |operator| operator.len()),
    }
}

/// The length of a text or a character in quotes.
fn quoted(rest: &str, quote: char) -> usize {
    let mut is_escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        if c == quote && !is_escaped {
            return at + 1;
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::tokens;

    #[test]
    fn comments_are_left_out_and_texts_are_one_token() {
        let source =
            "/// - a\nfn f<'a>(x: &'a str) -> u8 { /* x /* - */ */ x-=1; '\\'' \"-\\\"\" }";
        let texts: Vec<&str> = tokens(source).iter().map(|token| token.text).collect();
        let expected = [
            "fn",
            "f",
            "<",
            "'a",
            ">",
            "(",
            "x",
            ":",
            "&",
            "'a",
            "str",
            ")",
            "->",
            "u8",
            "{",
            "x",
            "-=",
            "1",
            ";",
            "'\\''",
            "\"-\\\"\"",
            "}",
        ];
        assert_eq!(texts, expected);
    }
}
