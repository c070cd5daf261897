//! The bench: the same clocks for a model and its twin, and every word compared.

use super::fault::Fault;
use super::ports::Ports;
use super::simulator::Simulator;

/// A twin under simulation, held against what its model shows.
///
/// The model's side runs ahead: it hands over the words of each clock, and the bench compares a
/// block of clocks at a time.
pub(super) struct Bench {
    ports: Ports,
    simulator: Box<dyn Simulator>,
    clocks: u64,
    /// The words of the block: what goes in, and what the model says comes out.
    inputs: Vec<u64>,
    expected: Vec<Option<u64>>,
    answers: Vec<Option<u64>>,
}

/// The words that a block may answer with. As text they are up to 17 bytes each, and must fit in
/// the smallest of pipes, or both sides wait for each other.
const BLOCK: usize = 900;

impl Bench {
    pub(super) fn new(ports: Ports, simulator: Box<dyn Simulator>) -> Self {
        let [expected, answers] = [Vec::new(), Vec::new()];
        Self { ports, simulator, clocks: 0, inputs: Vec::new(), expected, answers }
    }

    pub(super) const fn ports(&self) -> &Ports {
        &self.ports
    }

    /// The clocks handed over so far.
    pub(super) const fn clocks(&self) -> u64 {
        self.clocks
    }

    /// One clock: the words of all inputs, and of all outputs before the edge that ends it.
    /// Without outputs (`None`) nothing is compared.
    ///
    /// # Errors
    /// The first difference in the block that this clock may complete: clock, signal and both
    /// values; a simulator that has ended.
    pub(super) fn clock(&mut self, inputs: &[u64], outputs: Option<&[u64]>) -> Result<(), Fault> {
        debug_assert_eq!(inputs.len(), self.ports.inputs.len());
        self.inputs.extend(inputs);
        match outputs {
            Some(words) => self.expected.extend(words.iter().copied().map(Some)),
            None => self.expected.extend(self.ports.outputs.iter().map(|_| None)),
        }
        self.clocks += 1;
        if self.expected.len() + self.ports.outputs.len() > BLOCK { self.settle() } else { Ok(()) }
    }

    /// Compares the clocks that are still outstanding.
    ///
    /// # Errors
    /// As [`Bench::clock`].
    pub(super) fn settle(&mut self) -> Result<(), Fault> {
        let width = self.ports.outputs.len();
        let clocks = (self.expected.len() / width) as u64;
        if clocks == 0 {
            return Ok(());
        }
        self.answers.clear();
        self.simulator.clocks(clocks, &self.inputs, &mut self.answers)?;
        for (at, (expected, twin)) in self.expected.iter().zip(&self.answers).enumerate() {
            let output = &self.ports.outputs[at % width];
            let Some(model) = expected.map(|word| word & output.mask()) else { continue };
            if Some(model) != *twin {
                let clock = self.clocks - clocks + (at / width) as u64;
                let twin = twin.map_or("unknown".to_owned(), |word| word.to_string());
                let signal = &output.signal;
                return Err(Fault::Differs(format!(
                    "clock {clock}: {signal} is {model} in the model, {twin} in the twin"
                )));
            }
        }
        self.inputs.clear();
        self.expected.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::ports::{Output, Port};
    use super::*;

    /// Answers with what went in 16 clocks before; bits above the fourth are unknown.
    struct Delay {
        line: Vec<u64>,
    }

    impl Simulator for Delay {
        fn clocks(
            &mut self,
            clocks: u64,
            inputs: &[u64],
            outputs: &mut Vec<Option<u64>>,
        ) -> Result<(), String> {
            assert_eq!(inputs.len() as u64, clocks);
            for input in inputs {
                self.line.push(*input);
                outputs.push(Some(self.line.remove(0)).filter(|word| *word < 16));
            }
            Ok(())
        }
    }

    fn bench() -> Bench {
        let ports = Ports {
            module: "delay",
            parameters: Vec::new(),
            inputs: vec![Port::whole("i_in", 5)],
            outputs: vec![Output::new("out", Port::whole("o_out", 5))],
        };
        Bench::new(ports, Box::new(Delay { line: vec![0; 16] }))
    }

    fn message(fault: Result<(), Fault>) -> String {
        fault.unwrap_err().into()
    }

    #[test]
    fn a_difference_names_clock_signal_and_both_values() {
        let mut bench = bench();
        for k in 0..4 * BLOCK as u64 {
            // The model's words may be wider than the port.
            let expected = if k < 16 { 0 } else { (k - 16) % 16 + 32 };
            bench.clock(&[k % 16], Some(&[expected])).unwrap();
        }
        bench.clock(&[0], Some(&[3])).unwrap();
        let clock = 4 * BLOCK;
        let text = format!("clock {clock}: out is 3 in the model, 0 in the twin");
        assert_eq!(message(bench.settle()), text);
    }

    #[test]
    fn an_unknown_bit_is_a_difference_where_the_model_says_something() {
        let mut bench = bench();
        bench.clock(&[16], Some(&[0])).unwrap();
        bench.clock(&[16], Some(&[0])).unwrap();
        for _ in 2..16 {
            bench.clock(&[0], Some(&[0])).unwrap();
        }
        bench.clock(&[0], None).unwrap();
        bench.clock(&[0], Some(&[16])).unwrap();
        let text = "clock 17: out is 16 in the model, unknown in the twin";
        assert_eq!(message(bench.settle()), text);
    }
}
