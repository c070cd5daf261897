//! `#[kani::proof]`, `#[kani::unwind(n)]` and `#[kani::solver(name)]` where Kani itself is not
//! there to read them.

use proc_macro::{TokenStream, TokenTree};

/// A harness. Built for WebAssembly it is exported as `proof:NAME`, to be found by the prover; built
/// for tests it is a test, which runs it natively on many values.
///
/// Names of harnesses are unique in the whole crate, as those of exports are.
#[proc_macro_attribute]
pub fn proof(_attribute: TokenStream, item: TokenStream) -> TokenStream {
    let name = function_name(&item);
    with(
        item,
        &format!(
            "#[cfg(target_arch = \"wasm32\")]
             #[allow(unsafe_code)]
             #[unsafe(export_name = \"proof:{name}\")]
             extern \"C\" fn __proof_{name}() {{ {name}() }}

             #[cfg(all(test, not(target_arch = \"wasm32\")))]
             #[test]
             fn __test_{name}() {{ ::kani::native::check(\"{name}\", {name}) }}"
        ),
    )
}

/// How often the loops of a harness run at most, plus one: exported as `unwind:NAME:n`.
#[proc_macro_attribute]
pub fn unwind(attribute: TokenStream, item: TokenStream) -> TokenStream {
    exported(item, "unwind", &attribute.to_string())
}

/// The solver that does a harness best: exported as `solver:NAME:solver`.
#[proc_macro_attribute]
pub fn solver(attribute: TokenStream, item: TokenStream) -> TokenStream {
    exported(item, "solver", &attribute.to_string())
}

fn exported(item: TokenStream, what: &str, value: &str) -> TokenStream {
    let name = function_name(&item);
    with(
        item,
        &format!(
            "#[cfg(target_arch = \"wasm32\")]
             #[allow(unsafe_code)]
             #[unsafe(export_name = \"{what}:{name}:{value}\")]
             extern \"C\" fn __{what}_{name}() {{}}"
        ),
    )
}

/// The item with more source after it.
fn with(item: TokenStream, source: &str) -> TokenStream {
    match source.parse::<TokenStream>() {
        Ok(more) => item.into_iter().chain(more).collect(),
        Err(why) => error(&why.to_string()),
    }
}

/// The identifier after `fn`.
fn function_name(item: &TokenStream) -> String {
    let mut tokens = item.clone().into_iter();
    let is_fn =
        |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word.to_string() == "fn");
    if tokens.any(|token| is_fn(&token)) {
        if let Some(TokenTree::Ident(name)) = tokens.next() {
            return name.to_string();
        }
    }
    "a_harness_is_a_function".to_owned()
}

fn error(why: &str) -> TokenStream {
    format!("compile_error!({why:?});").parse().unwrap_or_default()
}
