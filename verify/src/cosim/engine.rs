//! The engines and the ports of each.

use super::ports::{Output, Port, Ports};

/// A module of the twin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Engine {
    DdaLine,
    DdaLine4,
    DdaArc,
    DdaCentredArc,
    PpcLine,
    PpcArc,
    BrmLine,
    MinimumDeviationLine,
    MinimumDeviationLine4,
    ComparisonLine,
    ComparisonArc,
    MinimumDeviationArc,
    ParabolaPpc,
}

impl Engine {
    pub(super) const ALL: [Self; 13] = [
        Self::DdaLine,
        Self::DdaLine4,
        Self::DdaArc,
        Self::DdaCentredArc,
        Self::PpcLine,
        Self::PpcArc,
        Self::BrmLine,
        Self::MinimumDeviationLine,
        Self::MinimumDeviationLine4,
        Self::ComparisonLine,
        Self::ComparisonArc,
        Self::MinimumDeviationArc,
        Self::ParabolaPpc,
    ];

    /// The Verilog module.
    pub(super) const fn module(self) -> &'static str {
        match self {
            Self::DdaLine | Self::DdaLine4 => "dda_line",
            Self::DdaArc => "dda_arc",
            Self::DdaCentredArc => "dda_centred_arc",
            Self::PpcLine => "ppc_line",
            Self::PpcArc => "ppc_arc",
            Self::BrmLine => "brm_line",
            Self::MinimumDeviationLine | Self::MinimumDeviationLine4 => "minimum_deviation_line",
            Self::ComparisonLine => "comparison_line",
            Self::ComparisonArc => "comparison_arc",
            Self::MinimumDeviationArc => "minimum_deviation_arc",
            Self::ParabolaPpc => "parabola_ppc",
        }
    }

    /// The number of axes.
    pub(super) const fn axes(self) -> usize {
        match self {
            Self::DdaLine4 | Self::MinimumDeviationLine4 => 4,
            _ => 2,
        }
    }

    /// Whether the module has the parameter AXES.
    const fn has_axes(self) -> bool {
        match self {
            Self::DdaLine | Self::DdaLine4 | Self::BrmLine => true,
            Self::MinimumDeviationLine | Self::MinimumDeviationLine4 => true,
            Self::DdaArc | Self::DdaCentredArc | Self::PpcLine | Self::PpcArc => false,
            Self::ComparisonLine | Self::ComparisonArc => false,
            Self::MinimumDeviationArc | Self::ParabolaPpc => false,
        }
    }

    /// The module as the bench sees it, in registers of `bits` bits. The inputs are `i_rst`, `i_load`
    /// and `i_en`, then the command in the order in which the stimulus gives its words.
    pub(super) fn ports(self, bits: u32) -> Ports {
        let mut parameters = vec![("N", bits)];
        if self.has_axes() {
            parameters.push(("AXES", self.axes() as u32));
        }
        let mut inputs = ["i_rst", "i_load", "i_en"].map(|name| Port::whole(name, 1)).to_vec();
        inputs.extend(self.command(bits));
        let axes = self.axes() as u32;
        // A direction means something where there is a pulse.
        let negative = Output::new("negative", Port::whole("o_negative", axes));
        let mut outputs = vec![
            Output::new("pulse", Port::whole("o_pulse", axes)),
            Output { gate: Some("o_pulse"), ..negative },
            Output::new("done", Port::whole("o_done", 1)),
        ];
        outputs.extend(self.registers(bits));
        Ports { module: self.module(), parameters, inputs, outputs }
    }

    /// What the word of an output is after a reset: that of a sweep in its last quadrant, the first,
    /// and at its end.
    pub(super) fn after_reset(signal: &str) -> u64 {
        let is_set = matches!(signal, "done" | "fx" | "last" | "feeds_nx" | "stepping_out");
        u64::from(is_set || signal.starts_with("at_end_") || signal.starts_with("stands_"))
    }

    /// The command's ports.
    fn command(self, bits: u32) -> Vec<Port> {
        let n = bits;
        let whole = Port::whole;
        let sweep = [
            whole("i_quadrant", 2),
            whole("i_crossings", 3),
            whole("i_cw", 1),
            whole("i_jex", n + 2),
            whole("i_jey", n + 2),
        ];
        let end = |e| [whole("i_rule", 2), whole("i_larger_is_y", 1), whole("i_e", e)];
        let mut inputs = Vec::new();
        match self {
            Self::DdaLine | Self::DdaLine4 => {
                inputs.extend(Port::each("i_jv", n, self.axes()));
                inputs.extend([whole("i_preset", n), whole("i_je", n + 1)]);
                inputs.push(whole("i_negative", self.axes() as u32));
            }
            Self::DdaArc => {
                inputs.extend(["i_jvx", "i_jvy", "i_preset", "i_unit"].map(|name| whole(name, n)));
                inputs.extend(sweep);
            }
            Self::DdaCentredArc => {
                let names = ["i_x", "i_y", "i_jrx", "i_jry", "i_unit"];
                inputs.extend(names.map(|name| whole(name, n)));
                inputs.extend(sweep);
            }
            Self::ComparisonLine => {
                inputs.extend(["i_end_x", "i_end_y"].map(|name| whole(name, n)));
                inputs.extend([whole("i_d", n + 2), whole("i_negative", 2)]);
            }
            Self::ComparisonArc | Self::MinimumDeviationArc => {
                inputs.extend(["i_cx", "i_cy"].map(|name| whole(name, n)));
                inputs.extend(sweep);
            }
            Self::ParabolaPpc => {
                inputs.extend(["i_p", "i_end_along", "i_end_across"].map(|name| whole(name, n)));
                inputs.extend([whole("i_axis_is_y", 1), whole("i_negative", 2)]);
            }
            Self::PpcLine => {
                inputs.extend(["i_end_x", "i_end_y"].map(|name| whole(name, n)));
                inputs.push(whole("i_negative", 2));
                inputs.extend(end(n + 1));
            }
            Self::PpcArc => {
                inputs.extend(["i_cx", "i_cy"].map(|name| whole(name, n)));
                inputs.extend(sweep);
                inputs.extend(end(n + 4));
            }
            Self::BrmLine => {
                inputs.extend(Port::each("i_value", n, self.axes()));
                inputs.push(whole("i_negative", self.axes() as u32));
            }
            Self::MinimumDeviationLine | Self::MinimumDeviationLine4 => {
                inputs.extend(Port::each("i_end", n, self.axes()));
                inputs.extend(Port::each("i_rest", n, self.axes()));
                inputs.extend(Port::each("i_d", n + 2, self.axes()));
                inputs.push(whole("i_steps", n));
                inputs.push(whole("i_negative", self.axes() as u32));
            }
        }
        inputs
    }

    /// The outputs after pulse, negative and done, which all have.
    fn registers(self, bits: u32) -> Vec<Output> {
        let n = bits;
        let whole = |signal, port, width| Output::new(signal, Port::whole(port, width));
        let sweep = || {
            [
                whole("quadrant", "o_quadrant", 2),
                whole("crossings", "o_crossings", 3),
                whole("cw", "o_cw", 1),
                whole("jex", "o_jex", n + 2),
                whole("jey", "o_jey", n + 2),
                whole("last", "o_last", 1),
                whole("towards_is_y", "o_towards_is_y", 1),
                whole("feeds_nx", "o_feeds_nx", 1),
                whole("feeds_ny", "o_feeds_ny", 1),
                whole("at_end_x", "o_at_end_x", 1),
                whole("at_end_y", "o_at_end_y", 1),
                whole("stands_x", "o_stands_x", 1),
                whole("stands_y", "o_stands_y", 1),
                whole("stepping_out", "o_stepping_out", 1),
                whole("nx", "o_nx", 1),
                whole("ny", "o_ny", 1),
                whole("shrinks_x", "o_shrinks_x", 1),
                whole("shrinks_y", "o_shrinks_y", 1),
            ]
        };
        let each = |signals: &[&'static str], port, width| -> Vec<Output> {
            let parts = Port::each(port, width, signals.len());
            signals.iter().zip(parts).map(|(signal, part)| Output::new(*signal, part)).collect()
        };
        // The sign flip-flops, whether there is a pulse or not.
        let signs = |axes: usize| -> Vec<Output> {
            let parts = Port::each("o_negative", 1, axes);
            let signals = ["negative_x", "negative_y", "negative_z", "negative_a"];
            signals.iter().zip(parts).map(|(signal, part)| Output::new(*signal, part)).collect()
        };
        let rule = || [whole("rule", "o_rule", 2), whole("larger_is_y", "o_larger_is_y", 1)];
        let mut outputs = Vec::new();
        match self {
            Self::DdaLine | Self::DdaLine4 => {
                outputs.extend(each(&["jvx", "jvy", "jvz", "jva"][..self.axes()], "o_jv", n));
                outputs.extend(each(&["jrx", "jry", "jrz", "jra"][..self.axes()], "o_jr", n));
                outputs.push(whole("je", "o_je", n + 1));
                outputs.extend(signs(self.axes()));
            }
            Self::DdaArc => {
                outputs.push(whole("beat", "o_beat", 1));
                outputs.push(whole("unit", "o_unit", n));
                outputs.push(whole("sumx", "o_sumx", n + 1));
                outputs.push(whole("sumy", "o_sumy", n + 1));
                for (signal, port) in
                    [("jvx", "o_jvx"), ("jvy", "o_jvy"), ("jrx", "o_jrx"), ("jry", "o_jry")]
                {
                    outputs.push(whole(signal, port, n));
                }
                outputs.extend(sweep());
            }
            Self::DdaCentredArc => {
                outputs.push(whole("beat", "o_beat", 2));
                outputs.push(whole("unit", "o_unit", n));
                outputs.push(whole("sum", "o_sum", n + 2));
                for (signal, port) in
                    [("x", "o_x"), ("y", "o_y"), ("jrx", "o_jrx"), ("jry", "o_jry")]
                {
                    outputs.push(whole(signal, port, n));
                }
                outputs.extend(sweep());
            }
            Self::ComparisonLine => {
                outputs.push(whole("d", "o_d", n + 2));
                for (signal, port) in
                    [("end_x", "o_end_x"), ("end_y", "o_end_y"), ("jex", "o_jex"), ("jey", "o_jey")]
                {
                    outputs.push(whole(signal, port, n));
                }
                outputs.extend(signs(2));
            }
            Self::ComparisonArc | Self::MinimumDeviationArc => {
                for (signal, port) in
                    [("beat", "o_beat"), ("due_x", "o_due_x"), ("due_y", "o_due_y")]
                {
                    outputs.push(whole(signal, port, 1));
                }
                outputs.push(whole("f", "o_f", n + 2));
                outputs.push(whole("cx", "o_cx", n));
                outputs.push(whole("cy", "o_cy", n));
                outputs.extend(sweep());
            }
            Self::ParabolaPpc => {
                outputs.push(whole("f", "o_f", n + 2));
                outputs.push(whole("v", "o_v", n));
                outputs.push(whole("p", "o_p", n));
                outputs.push(whole("je_along", "o_je_along", n));
                outputs.push(whole("je_across", "o_je_across", n));
                outputs.push(whole("axis_is_y", "o_axis_is_y", 1));
                outputs.extend(signs(2));
            }
            Self::PpcLine => {
                outputs.push(whole("beat", "o_beat", 2));
                outputs.push(whole("fx", "o_fx", 1));
                outputs.push(whole("f", "o_f", n + 1));
                for (signal, port) in
                    [("end_x", "o_end_x"), ("end_y", "o_end_y"), ("jex", "o_jex"), ("jey", "o_jey")]
                {
                    outputs.push(whole(signal, port, n));
                }
                outputs.push(whole("e", "o_e", n + 1));
                outputs.extend(signs(2));
                outputs.extend(rule());
            }
            Self::PpcArc => {
                outputs.push(whole("beat", "o_beat", 2));
                outputs.push(whole("fx", "o_fx", 1));
                outputs.push(whole("f", "o_f", n + 2));
                outputs.push(whole("cx", "o_cx", n));
                outputs.push(whole("cy", "o_cy", n));
                outputs.extend(sweep());
                outputs.push(whole("e", "o_e", n + 4));
                outputs.extend(rule());
            }
            Self::BrmLine => {
                outputs.push(whole("tg", "o_tg", 1));
                outputs.push(whole("divider", "o_divider", n));
                outputs.extend(each(&["value_x", "value_y"], "o_value", n));
                outputs.push(whole("stages", "o_stages", n));
                outputs.push(whole("overflow", "o_overflow", 1));
                outputs.extend(signs(2));
            }
            Self::MinimumDeviationLine | Self::MinimumDeviationLine4 => {
                let ends = &["end_x", "end_y", "end_z", "end_a"][..self.axes()];
                let rests = &["rest_x", "rest_y", "rest_z", "rest_a"][..self.axes()];
                outputs.extend(each(&["dx", "dy", "dz", "da"][..self.axes()], "o_d", n + 2));
                outputs.extend(each(ends, "o_end", n));
                outputs.extend(each(rests, "o_rest", n));
                outputs.push(whole("steps", "o_steps", n));
                outputs.extend(signs(self.axes()));
            }
        }
        outputs
    }
}
