//! The wave that the model writes of a run.

use onepulse_hwmodel::trace::{SignalList, Tracer, Vcd};
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

/// The time axis counts nanoseconds, as that of the Icarus bench does.
const EXPONENT: i8 = -9;

/// When clock k rises; it falls one later.
pub(super) const fn rise(k: u64) -> u64 {
    2 * k
}

/// A wave being written, with one circuit after another.
#[derive(Debug)]
pub(super) struct ModelWave {
    tracer: Tracer<Vcd<BufWriter<File>>>,
    clocks: u64,
}

impl ModelWave {
    /// The wave of these signals, of which the first is the clock, `clk`.
    pub(super) fn create(path: &Path, list: &SignalList) -> Result<Self, String> {
        let text = |e: std::io::Error| format!("{}: {e}", path.display());
        let out = BufWriter::new(File::create(path).map_err(text)?);
        let vcd = Vcd::new(out, list, EXPONENT).map_err(text)?;
        Ok(Self { tracer: Tracer::new(vcd, list), clocks: 0 })
    }

    /// One clock with what `show` shows the tracer.
    pub(super) fn clock(&mut self, show: impl FnOnce(&mut Tracer<Vcd<BufWriter<File>>>)) {
        let rise = rise(self.clocks);
        self.tracer.at(rise);
        self.tracer.set(0, 1);
        show(&mut self.tracer);
        self.tracer.at(rise + 1);
        self.tracer.set(0, 0);
        self.clocks += 1;
    }

    pub(super) fn finish(self) -> Result<(), String> {
        let end = rise(self.clocks);
        self.tracer.finish(end).map(drop).map_err(|e| format!("the model's wave: {e}"))
    }
}
