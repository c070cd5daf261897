//! A twin under Icarus Verilog, with a bench in Verilog that reads and writes words as text.

use super::ports::{Port, Ports};
use super::simulator::{Pipes, Simulator, broken, build};
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, Write as _};
use std::path::Path;
use std::process::Command;

#[derive(Debug)]
pub(super) struct Icarus {
    pipes: Pipes,
    outputs: usize,
    line: String,
}

impl Icarus {
    /// Builds a twin and starts it; with a path, it writes its wave there.
    pub(super) fn start(
        rtl: &Path,
        folder: &Path,
        ports: &Ports,
        wave: Option<&Path>,
    ) -> Result<Self, String> {
        let folder = folder.join(format!("icarus_{}", ports.label()));
        fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let bench = folder.join("bench.v");
        fs::write(&bench, source(ports)).map_err(|e| format!("{}: {e}", bench.display()))?;

        let program = folder.join("bench.vvp");
        let mut iverilog = Command::new("iverilog");
        iverilog.args(["-g2005", "-s", "bench", "-y"]).arg(rtl).arg("-o").arg(&program);
        build(iverilog.arg(&bench))?;

        let mut vvp = Command::new("vvp");
        vvp.arg("-n").arg(&program);
        if let Some(wave) = wave {
            vvp.arg(format!("+wave={}", wave.display()));
        }
        let pipes = Pipes::start(&mut vvp)?;
        Ok(Self { pipes, outputs: ports.outputs.len(), line: String::new() })
    }
}

impl Simulator for Icarus {
    fn clocks(
        &mut self,
        clocks: u64,
        inputs: &[u64],
        outputs: &mut Vec<Option<u64>>,
    ) -> Result<(), String> {
        self.pipes.send(|stdin| {
            writeln!(stdin, "{clocks:x}")?;
            for word in inputs {
                writeln!(stdin, "{word:x}")?;
            }
            stdin.flush()
        })?;
        for _ in 0..clocks {
            let before = outputs.len();
            let line = loop {
                self.line.clear();
                if self.pipes.stdout.read_line(&mut self.line).map_err(broken)? == 0 {
                    return Err("vvp ended by itself".to_owned());
                }
                // Icarus itself says where the wave goes.
                if !self.line.starts_with("VCD info") {
                    break &self.line;
                }
            };
            // A digit of an unknown bit is x or X.
            outputs.extend(line.split_whitespace().map(|word| u64::from_str_radix(word, 16).ok()));
            if outputs.len() - before != self.outputs {
                return Err(format!("vvp says: {line}"));
            }
        }
        Ok(())
    }
}

/// The bench. It reads a number of clocks and their inputs, and answers with their outputs, one
/// line a clock.
///
/// Clock k rises at 2k and falls at 2k + 1, as in the model's wave. Every output is a wire with the
/// name of the model's signal, so that the waves read alike.
fn source(ports: &Ports) -> String {
    let Ports { module, parameters, inputs, outputs } = ports;
    let join = |parts: Vec<String>, between: &str| parts.join(between);
    let parameters = join(parameters.iter().map(|(n, v)| format!(".{n}({v})")).collect(), ", ");
    let ins = whole(inputs.iter());
    let outs = whole(outputs.iter().map(|output| &output.port));
    let mut declared = String::new();
    for (kind, whole) in [("reg ", &ins), ("wire", &outs)] {
        for (name, width) in whole {
            let _ = writeln!(declared, "    {kind} [{}:0] {name};", width - 1);
        }
    }
    for output in outputs {
        let Port { name, low, width } = &output.port;
        let part = |name: &str| format!("{name}[{low} +: {width}]");
        let gate = output.gate.map_or(String::new(), |gate| format!(" & {}", part(gate)));
        let (high, signal) = (width - 1, &output.signal);
        let _ = writeln!(declared, "    wire [{high}:0] {signal} = {}{gate};", part(name));
    }
    let connected = ins.iter().chain(&outs).map(|(name, _)| format!(", .{name}({name})"));
    let connected: String = connected.collect();
    let mut drive = String::new();
    for (at, Port { name, low, width }) in inputs.iter().enumerate() {
        let _ = writeln!(drive, "                {name}[{low} +: {width}] <= in_{at};");
    }
    let words = |count: usize| join((0..count).map(|at| format!("in_{at}")).collect(), ", ");
    let (read, ins) = (words(inputs.len()), inputs.len());
    let shown = join(outputs.iter().map(|output| output.signal.clone()).collect(), ", ");
    let formats = |count| join(vec!["%h".to_owned(); count], " ");
    let (format_in, format_out) = (formats(ins), formats(outputs.len()));
    format!(
        r#"`timescale 1ns/1ns
module bench;
    localparam STDIN = 32'h8000_0000, STDOUT = 32'h0000_0001;
    reg clk = 1'b1;
{declared}
    {module} #({parameters}) twin (.i_clk(clk){connected});

    initial begin : driver
        reg [8*4096-1:0] wave;
        reg [63:0] {read};
        integer clocks;
        if ($value$plusargs("wave=%s", wave)) begin
            $dumpfile(wave);
            // The signals of the bench, and none below.
            $dumpvars(1, bench);
        end
        while ($fscanf(STDIN, "%h", clocks) == 1) begin
            repeat (clocks) begin
                if ($fscanf(STDIN, "{format_in}", {read}) != {ins}) $finish(0);
                // Like any register's content, they come after the edge.
{drive}                #1 clk = 1'b0;
                $display("{format_out}", {shown});
                #1 clk = 1'b1;
            end
            $fflush(STDOUT);
        end
        $finish(0);
    end
endmodule
"#
    )
}

/// The whole ports behind some words, each once, with their widths.
fn whole<'a>(words: impl Iterator<Item = &'a Port>) -> Vec<(&'a str, u32)> {
    let mut whole: Vec<(&str, u32)> = Vec::new();
    for port in words {
        let high = port.low + port.width;
        match whole.iter_mut().find(|(name, _)| *name == port.name) {
            Some((_, width)) => *width = high.max(*width),
            None => whole.push((&port.name, high)),
        }
    }
    whole
}
