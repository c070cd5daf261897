//! What a module is to the bench: words that go in and words that come out on every clock.

/// A module, its parameters, and the words of a clock.
///
/// The clock itself, `i_clk`, is the bench's.
#[derive(Clone, Debug)]
pub(super) struct Ports {
    pub(super) module: &'static str,
    pub(super) parameters: Vec<(&'static str, u32)>,
    pub(super) inputs: Vec<Port>,
    pub(super) outputs: Vec<Output>,
}

/// A part of a port, of up to 64 bits: one word.
#[derive(Clone, Debug)]
pub(super) struct Port {
    pub(super) name: String,
    pub(super) low: u32,
    pub(super) width: u32,
}

/// A word that comes out, and the signal of the Rust model that it must equal. The signal's name is
/// an identifier in Verilog, and not that of a port.
#[derive(Clone, Debug)]
pub(super) struct Output {
    pub(super) signal: String,
    pub(super) port: Port,
    /// A port whose bits say which bits of this one mean anything; the others count as 0.
    pub(super) gate: Option<&'static str>,
}

impl Port {
    /// A whole port.
    pub(super) fn whole(name: impl Into<String>, width: u32) -> Self {
        Self { name: name.into(), low: 0, width }
    }

    /// A vector with a word for each axis.
    pub(super) fn each(name: &str, width: u32, axes: usize) -> Vec<Self> {
        let part = |axis| Self { name: name.to_owned(), low: axis * width, width };
        (0..axes as u32).map(part).collect()
    }
}

impl Output {
    pub(super) fn new(signal: impl Into<String>, port: Port) -> Self {
        Self { signal: signal.into(), port, gate: None }
    }

    /// The bits of a word that the port has.
    pub(super) const fn mask(&self) -> u64 {
        u64::MAX >> (64 - self.port.width)
    }
}

impl Ports {
    /// Module and parameters, as the name of a folder.
    pub(super) fn label(&self) -> String {
        let parameters = self.parameters.iter().map(|(name, value)| format!("_{name}{value}"));
        self.module.to_owned() + &parameters.collect::<String>()
    }
}
