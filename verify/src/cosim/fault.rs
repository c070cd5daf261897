//! Why a comparison ended early.

/// What went wrong. Only a difference counts where a mutant is to be found.
#[derive(Debug)]
pub(super) enum Fault {
    /// Model and twin are not equal.
    Differs(String),
    /// They could not be compared: a tool, a file or a pipe failed.
    Broken(String),
}

impl Fault {
    /// The same with the place put before.
    pub(super) fn within(self, place: &str) -> Self {
        match self {
            Self::Differs(why) => Self::Differs(format!("{place}: {why}")),
            Self::Broken(why) => Self::Broken(format!("{place}: {why}")),
        }
    }
}

impl From<String> for Fault {
    fn from(why: String) -> Self {
        Self::Broken(why)
    }
}

impl From<Fault> for String {
    fn from((Fault::Differs(why) | Fault::Broken(why)): Fault) -> Self {
        why
    }
}
