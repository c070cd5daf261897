//! The top module of a simulation.

use super::Twin;
use std::fmt::Write;

/// The letters of the axes.
const AXES: [&str; 4] = ["x", "y", "z", "a"];

impl Twin {
    /// The module `onepulse`: the twin with its command for ever at its inputs, clocked and loaded
    /// from outside.
    ///
    /// With a wave it declares what [`Bench`](onepulse_hwmodel::trace::Bench) and the circuit
    /// trace, by the same names and at the same widths, and nothing else: direction flip-flops and
    /// position counters included, so that both sides write the same changes.
    pub(super) fn wrapper(&self, has_wave: bool) -> String {
        let bus = self.axes - 1;
        let mut text = format!(
            "module onepulse (
    input  wire clk,
    // verilator tracing_off
    input  wire load,
    output wire [{bus}:0] pulse,
    output wire done
);
    wire [{bus}:0] negative;
"
        );
        let mut ports = String::new();
        for (port, value) in &self.command {
            let _ = write!(ports, ", .{port}(64'd{value})");
        }
        if has_wave {
            text += "    // verilator tracing_on\n";
            for (axis, letter) in AXES[..self.axes].iter().enumerate() {
                text += &outputs(axis, letter);
            }
            for (port, names) in &self.shown {
                for name in *names {
                    let high = self.registers.bits(name).saturating_sub(1);
                    let _ = writeln!(text, "    wire [{high}:0] {name};");
                }
                let _ = write!(ports, ", .{port}({{{}}})", names.join(", "));
            }
        }
        let parameters: Vec<_> =
            self.parameters.iter().map(|(name, value)| format!(".{name}({value})")).collect();
        let (module, parameters) = (self.module, parameters.join(", "));
        let _ = write!(
            text,
            "    {module} #({parameters}) twin (.i_clk(clk), .i_rst(1'b0), .i_en(1'b1), \
             .i_load(load), .o_pulse(pulse), .o_negative(negative), .o_done(done){ports});
endmodule
"
        );
        text
    }
}

/// Pulse, direction and position of an axis. The direction stays between pulses.
fn outputs(axis: usize, letter: &str) -> String {
    format!(
        "    wire pulse_{letter} = pulse[{axis}];
    // verilator tracing_off
    reg  was_{letter};
    // verilator tracing_on
    wire negative_{letter} = pulse_{letter} ? negative[{axis}] : was_{letter};
    reg  signed [33:0] position_{letter};
    always @(posedge clk) begin
        was_{letter} <= negative_{letter};
        if (pulse_{letter})
            position_{letter} <= position_{letter} + (negative_{letter} ? -34'sd1 : 34'sd1);
    end
"
    )
}
