//! The ports of each module.

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
}

/// A part of an output port, and the signal of the circuit that it must equal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Output {
    pub(super) signal: &'static str,
    pub(super) port: &'static str,
    pub(super) low: u32,
    pub(super) width: u32,
}

impl Engine {
    pub(super) const ALL: [Self; 7] = [
        Self::DdaLine,
        Self::DdaLine4,
        Self::DdaArc,
        Self::DdaCentredArc,
        Self::PpcLine,
        Self::PpcArc,
        Self::BrmLine,
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
        }
    }

    /// The number of axes.
    pub(super) const fn axes(self) -> usize {
        match self {
            Self::DdaLine4 => 4,
            _ => 2,
        }
    }

    /// Whether the module has the parameter AXES.
    pub(super) const fn has_axes(self) -> bool {
        matches!(self, Self::DdaLine | Self::DdaLine4 | Self::BrmLine)
    }

    /// The command's ports, in the order in which the stimulus gives their values.
    pub(super) const fn inputs(self) -> &'static [&'static str] {
        match self {
            Self::DdaLine | Self::DdaLine4 => &["i_jv", "i_preset", "i_je", "i_negative"],
            Self::DdaArc => &[
                "i_jvx",
                "i_jvy",
                "i_preset",
                "i_unit",
                "i_quadrant",
                "i_crossings",
                "i_cw",
                "i_jex",
                "i_jey",
            ],
            Self::DdaCentredArc => &[
                "i_x",
                "i_y",
                "i_jrx",
                "i_jry",
                "i_unit",
                "i_quadrant",
                "i_crossings",
                "i_cw",
                "i_jex",
                "i_jey",
            ],
            Self::PpcLine => {
                &["i_end_x", "i_end_y", "i_negative", "i_rule", "i_larger_is_y", "i_e"]
            }
            Self::PpcArc => &[
                "i_cx",
                "i_cy",
                "i_quadrant",
                "i_crossings",
                "i_cw",
                "i_jex",
                "i_jey",
                "i_rule",
                "i_larger_is_y",
                "i_e",
            ],
            Self::BrmLine => &["i_value", "i_negative"],
        }
    }

    /// The outputs after `o_pulse`, `o_negative` and `o_done`, which all have.
    pub(super) fn outputs(self, bits: u32) -> Vec<Output> {
        let n = bits;
        let whole = |signal, port, width| Output { signal, port, low: 0, width };
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
                whole("at_end_x", "o_x_at_end", 1),
                whole("at_end_y", "o_y_at_end", 1),
                whole("stands_x", "o_x_stands", 1),
                whole("stands_y", "o_y_stands", 1),
                whole("stepping_out", "o_stepping_out", 1),
                whole("nx", "o_nx", 1),
                whole("ny", "o_ny", 1),
                whole("shrinks_x", "o_x_shrinks", 1),
                whole("shrinks_y", "o_y_shrinks", 1),
            ]
        };
        let each = |signals: &[&'static str], port| -> Vec<Output> {
            let part = |(signal, axis): (&&'static str, u32)| Output {
                signal,
                port,
                low: axis * n,
                width: n,
            };
            signals.iter().zip(0..).map(part).collect()
        };
        let mut outputs = Vec::new();
        match self {
            Self::DdaLine | Self::DdaLine4 => {
                outputs.extend(each(&["jvx", "jvy", "jvz", "jva"][..self.axes()], "o_jv"));
                outputs.extend(each(&["jrx", "jry", "jrz", "jra"][..self.axes()], "o_jr"));
                outputs.push(whole("je", "o_je", n + 1));
            }
            Self::DdaArc => {
                outputs.push(whole("beat", "o_beat", 1));
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
                outputs.push(whole("sum", "o_sum", n + 2));
                for (signal, port) in
                    [("x", "o_x"), ("y", "o_y"), ("jrx", "o_jrx"), ("jry", "o_jry")]
                {
                    outputs.push(whole(signal, port, n));
                }
                outputs.extend(sweep());
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
            }
            Self::PpcArc => {
                outputs.push(whole("beat", "o_beat", 2));
                outputs.push(whole("fx", "o_fx", 1));
                outputs.push(whole("f", "o_f", n + 2));
                outputs.push(whole("cx", "o_cx", n));
                outputs.push(whole("cy", "o_cy", n));
                outputs.extend(sweep());
                outputs.push(whole("e", "o_e", n + 4));
            }
            Self::BrmLine => {
                outputs.push(whole("tg", "o_tg", 1));
                outputs.push(whole("divider", "o_divider", n));
                outputs.extend(each(&["value_x", "value_y"], "o_value"));
                outputs.push(whole("stages", "o_stages", n));
                outputs.push(whole("overflow", "o_overflow", 1));
            }
        }
        outputs
    }
}
