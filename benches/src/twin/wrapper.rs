//! The top module of a simulation with a wave.

use super::{AXES, Twin};
use std::fmt::Write;

impl Twin {
    /// A module `onepulse` with those ports of the twin that are driven and looked at from outside.
    ///
    /// Below it are what [`Bench`](onepulse_hwmodel::trace::Bench) and the circuit trace, at the
    /// same widths, and nothing else: direction flip-flops and position counters included, so that
    /// both sides write the same changes.
    pub(super) fn wrapper(&self) -> String {
        let bus = self.axes - 1;
        let mut text = "module onepulse (
    input  wire i_clk,
    // verilator tracing_off
"
        .to_owned();
        let mut ports = String::new();
        let inputs = ["i_rst", "i_en", "i_load"].map(str::to_owned).into_iter();
        for port in inputs.chain(self.command.iter().map(|(port, _)| port.clone())) {
            let _ = writeln!(text, "    input  wire [63:0] {port},");
            let _ = write!(ports, ", .{port}({port})");
        }
        let _ = write!(
            text,
            "    output wire [{bus}:0] o_pulse,
    output wire o_done
);
    wire [{bus}:0] negative;
    // verilator tracing_on
"
        );
        for (axis, letter) in AXES[..self.axes].iter().enumerate() {
            text += &outputs(axis, letter);
        }
        for (port, names) in &self.shown {
            for name in names {
                let high = self.registers.bits(name).saturating_sub(1);
                let _ = writeln!(text, "    wire [{high}:0] {};", in_wrapper(name));
            }
            let names: Vec<_> = names.iter().map(|name| in_wrapper(name)).collect();
            // The directions are a register of some modules, and shown as that.
            if port == "o_negative" {
                let _ = writeln!(text, "    assign {{{}}} = negative;", names.join(", "));
            } else {
                let _ = write!(ports, ", .{port}({{{}}})", names.join(", "));
            }
        }
        let (module, parameters) = (self.module, &self.parameters);
        let parameters: Vec<_> =
            parameters.iter().map(|(name, value)| format!(".{name}({value})")).collect();
        let _ = write!(
            text,
            "    {module} #({}) twin (.i_clk(i_clk), .o_pulse(o_pulse), .o_negative(negative), \
             .o_done(o_done){ports});
endmodule
",
            parameters.join(", ")
        );
        text
    }
}

/// The name of a circuit's signal beside those of the bench.
fn in_wrapper(name: &str) -> String {
    if name.starts_with("negative_") { format!("register_{name}") } else { name.to_owned() }
}

/// Pulse, direction and position of an axis. The direction stays between pulses.
fn outputs(axis: usize, letter: &str) -> String {
    format!(
        "    wire pulse_{letter} = o_pulse[{axis}];
    // verilator tracing_off
    reg  was_{letter};
    // verilator tracing_on
    wire negative_{letter} = pulse_{letter} ? negative[{axis}] : was_{letter};
    reg  signed [33:0] position_{letter};
    always @(posedge i_clk) begin
        was_{letter} <= negative_{letter};
        if (pulse_{letter})
            position_{letter} <= position_{letter} + (negative_{letter} ? -34'sd1 : 34'sd1);
    end
"
    )
}
