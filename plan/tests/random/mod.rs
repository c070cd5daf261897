//! Random cases, and how often they were of which kind.

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Debug;

/// Runs a test on random cases.
pub(crate) fn run<T: Debug>(
    cases: u32,
    strategy: &impl Strategy<Value = T>,
    test: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases) };
    if let Err(error) = TestRunner::new(config).run(strategy, test) {
        panic!("{error}");
    }
}

/// How often each thing happened.
#[derive(Default)]
pub(crate) struct Counts(RefCell<BTreeMap<&'static str, u32>>);

impl Counts {
    pub(crate) fn add(&self, what: &'static str, many: u32) {
        *self.0.borrow_mut().entry(what).or_default() += many;
    }

    /// Each thing happened at least so often.
    pub(crate) fn check(&self, least: &[(&str, u32)]) {
        let counts = self.0.borrow();
        for (what, least) in least {
            let found = counts.get(what).copied().unwrap_or(0);
            assert!(found >= *least, "{what}: {found} in {counts:?}");
        }
    }
}
