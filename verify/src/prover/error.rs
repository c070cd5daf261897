//! What can go wrong before there is a verdict.

use std::path::PathBuf;

/// Why the prover gave up.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A program that is neither unpacked nor in the PATH.
    #[error("{0} is missing: run tools/install-proof-tools")]
    MissingTool(&'static str),
    /// A program that cannot be started.
    #[error("{program} cannot be run: {source}")]
    Spawn {
        /// Its name.
        program: String,
        /// Why not.
        source: std::io::Error,
    },
    /// A program that ended with an error.
    #[error("{program} failed:\n{output}")]
    Tool {
        /// Its name.
        program: String,
        /// What it said.
        output: String,
    },
    /// A file or folder that cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// The harnesses' module is no WebAssembly.
    #[error("the module of the harnesses cannot be read: {0}")]
    Wasm(#[from] wasmparser::BinaryReaderError),
    /// The module has something that the prover gives no meaning to.
    #[error("the module of the harnesses: {0}")]
    Module(String),
    /// The C that wasm2c writes is not as expected.
    #[error("the C of wasm2c: {0}")]
    Source(String),
    /// The list of claims is at fault.
    #[error("verify/claims.toml: {0}")]
    Claims(#[from] super::claims::Error),
    /// Options that do not go together, or name what does not exist.
    #[error("{0}")]
    Options(String),
}

impl Error {
    /// For `map_err` where a file is at hand.
    pub(crate) fn file(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path, source }
    }
}
