//! Which tokens of a source are the body of which function.

use super::tokens::Token;
use std::ops::Range;

/// A function: its name, and the places of its body's tokens.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Function<'s> {
    pub(super) name: &'s str,
    pub(super) body: Range<usize>,
}

/// The functions that are in the machines as they are shipped: no tests, nothing for proofs alone.
pub(super) fn functions<'s>(tokens: &[Token<'s>]) -> Vec<Function<'s>> {
    let mut functions = Vec::new();
    let mut is_left_out = false;
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        match token.text {
            "#" => {
                let end = item_end(tokens, at + 1);
                let mut words = tokens[at..end].iter().map(|token| token.text);
                is_left_out |= words.any(|word| word == "test" || word == "\"proofs\"");
                at = end;
            }
            _ if is_left_out => {
                at = item_end(tokens, at);
                is_left_out = false;
            }
            "fn" => {
                let end = item_end(tokens, at);
                let is_brace = |place: &usize| tokens[*place].text == "{";
                if let Some(begin) = (at..end).find(is_brace) {
                    functions.push(Function { name: tokens[at + 1].text, body: begin..end });
                }
                at = end;
            }
            _ => at += 1,
        }
    }
    functions
}

/// Behind the item that begins here: its semicolon, or its braces, or an attribute's brackets.
fn item_end(tokens: &[Token<'_>], begin: usize) -> usize {
    let is_attribute = tokens.get(begin).is_some_and(|token| token.text == "[");
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(begin) {
        match token.text {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => {
                depth = depth.saturating_sub(1);
                if depth == 0 && (token.text == "}" || is_attribute) {
                    return at + 1;
                }
            }
            ";" if depth == 0 => return at + 1,
            _ => {}
        }
    }
    tokens.len()
}

#[cfg(test)]
mod tests {
    use super::functions;
    use crate::proof_mutants::tokens::tokens;

    #[test]
    fn tests_and_what_is_for_proofs_are_left_out() {
        let source = "
            #[cfg(feature = \"proofs\")] use a::b;
            impl A { #[inline] fn first(x: [u8; 2]) -> u8 { { 1 } }
            #[cfg(feature = \"proofs\")] #[must_use] fn second(x: [u8; 2]) {} fn third() {} }
            #[cfg(test)] mod tests { fn fourth() {} }";
        let names: Vec<&str> =
            functions(&tokens(source)).iter().map(|function| function.name).collect();
        assert_eq!(names, ["first", "third"]);
    }
}
