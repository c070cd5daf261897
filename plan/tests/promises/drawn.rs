//! Programs and what they run on, drawn from the bytes that a fuzzer finds.

use crate::promises::{path, program};
use arbitrary::{Arbitrary, Unstructured};
use onepulse_plan::centre_path::Compensation;
use onepulse_plan::compensation::Corners;
use onepulse_plan::{Integers, Length, Machine, ToolTable, Tools};
use std::fmt::{self, Write};

/// A program, and what it runs on.
pub(crate) struct Case {
    pub(crate) text: Vec<u8>,
    machine: Machine,
    tools: Tools,
    /// None if it is only to be read.
    compensation: Option<Compensation>,
}

impl Case {
    /// The first byte is the machine and its tools, the rest the program.
    pub(crate) fn program(data: &[u8]) -> Option<Self> {
        let (first, text) = data.split_first()?;
        let (machine, tools) = machine(*first);
        Some(Self { text: text.into(), machine, tools, compensation: None })
    }

    /// The bytes are those of a [`Drawn`].
    pub(crate) fn path(data: &[u8]) -> Option<Self> {
        let drawn = Drawn::arbitrary_take_rest(Unstructured::new(data)).ok()?;
        let (machine, _) = machine(drawn.machine);
        let compensation = Some(drawn.compensation());
        Some(Self { text: drawn.text().into(), machine, tools: drawn.tools(), compensation })
    }

    /// Panics where a promise is broken.
    pub(crate) fn check(&self) {
        program::check(&self.text, &self.machine, &self.tools);
        if let Some(compensation) = self.compensation {
            path::check(&self.text, &self.machine, &self.tools, compensation);
        }
    }
}

/// A machine with its tools. That of 0 has pulses of a hundredth of a millimetre and cutters of one.
fn machine(byte: u8) -> (Machine, Tools) {
    let pulse = [10_000_000, 1_000_000, 1000, 1, i64::MAX][usize::from(byte % 5)];
    let rest = byte / 5;
    let machine = Machine {
        integers: if rest % 2 == 0 { Integers::Pulses } else { Integers::Units },
        block_delete: rest / 2 % 2 == 1,
        ..Machine::with_pulse(Length::from_picometres(pulse))
    };
    let tools = match rest / 4 % 3 {
        0 => Tools::Radius(1.0),
        1 => table(),
        _ => Tools::Unknown,
    };
    (machine, tools)
}

fn table() -> Tools {
    Tools::Table(ToolTable::read("T1 D2.0\nT2 D6.5\nT3\nT4 D0.001\n").expect("it is right"))
}

/// A program that looks like one, and what it runs on.
#[derive(Arbitrary, Debug)]
struct Drawn {
    machine: u8,
    /// The radius of all cutters, mostly in quarters of a millimetre, or the table.
    cutter: u8,
    compensation: u8,
    parts: Vec<Part>,
}

#[derive(Arbitrary, Debug)]
enum Part {
    Block(Block),
    Contour {
        plane: u8,
        is_right: bool,
        start: [Millimetres; 2],
        approach: [Millimetres; 2],
        blocks: Vec<Block>,
        leave: [Millimetres; 2],
    },
}

/// Few and round, so that points meet often.
#[derive(Arbitrary, Clone, Copy, Debug)]
struct Millimetres(u8);

/// Of the plane that holds, its first axis and its second.
#[derive(Arbitrary, Debug)]
enum Block {
    /// Along one axis.
    Along {
        is_second: bool,
        is_incremental: bool,
        to: Millimetres,
    },
    Line {
        is_rapid: bool,
        is_incremental: bool,
        to: [Millimetres; 2],
    },
    /// From one point of a circle to one of the eight that mirrors make of it.
    Arc {
        is_clockwise: bool,
        centre: [i8; 2],
        end: u8,
    },
    ByCentre {
        is_clockwise: bool,
        to: [Millimetres; 2],
        centre: [Millimetres; 2],
    },
    ByRadius {
        is_clockwise: bool,
        to: [Millimetres; 2],
        radius: Millimetres,
    },
    /// Across the plane.
    Across(Millimetres),
    Word(u8),
    Text(String),
}

/// Words that stand alone or before a block.
const WORDS: [&str; 24] = [
    "G17\n",
    "G18\n",
    "G19\n",
    "G20 ",
    "G21 ",
    "G40 ",
    "G41 ",
    "G42 ",
    "G40\n",
    "G41 D1\n",
    "G42 D2\n",
    "G04 P0.5\n",
    "M00\n",
    "M30\n",
    "/",
    "T1 ",
    "T2\n",
    "D3 ",
    "S500 ",
    "F20 ",
    "(圆)\n",
    "; é\r\n",
    "%\n",
    "\n",
];

/// The letters of a plane's coordinates, its centre's, and of the axis across it.
const LETTERS: [[char; 5]; 3] =
    [['X', 'Y', 'I', 'J', 'Z'], ['Z', 'X', 'K', 'I', 'Y'], ['Y', 'Z', 'J', 'K', 'X']];

impl Drawn {
    fn tools(&self) -> Tools {
        match self.cutter {
            0..250 => Tools::Radius(f64::from(self.cutter % 50) / 4.0),
            250 => table(),
            251..254 => Tools::Radius(f64::from(self.cutter - 250) / 3.0),
            254 => Tools::Radius(1e7),
            255 => Tools::Radius(0.001),
        }
    }

    fn compensation(&self) -> Compensation {
        match self.compensation % 3 {
            0 => Compensation::C(Corners::Straight),
            1 => Compensation::C(Corners::Arcs),
            _ => Compensation::B,
        }
    }

    fn text(&self) -> String {
        let mut text = Text { text: "F100\n".into(), plane: 0 };
        for part in &self.parts {
            match part {
                Part::Block(block) => text.block(block),
                Part::Contour { plane, is_right, start, approach, blocks, leave } => {
                    text.plane = usize::from(plane % 3);
                    let _ = writeln!(text.text, "G{}", 17 + text.plane);
                    text.line("G00 G90", *start);
                    text.line(if *is_right { "G42 G01" } else { "G41 G01" }, *approach);
                    blocks.iter().for_each(|block| text.block(block));
                    text.line("G40 G01 G90", *leave);
                }
            }
        }
        text.text
    }
}

/// A program as it is written.
struct Text {
    text: String,
    plane: usize,
}

impl Text {
    fn line(&mut self, words: &str, [x, y]: [Millimetres; 2]) {
        let [first, second, ..] = LETTERS[self.plane];
        let _ = writeln!(self.text, "{words} {first}{x} {second}{y}");
    }

    fn block(&mut self, block: &Block) {
        let [first, second, i, j, across] = LETTERS[self.plane];
        let mode = |is_incremental| if is_incremental { "G91" } else { "G90" };
        let arc = |is_clockwise| if is_clockwise { "G02" } else { "G03" };
        let _ = match block {
            Block::Along { is_second, is_incremental, to } => {
                let letter = if *is_second { second } else { first };
                writeln!(self.text, "{} G01 {letter}{to}", mode(*is_incremental))
            }
            Block::Line { is_rapid, is_incremental, to: [x, y] } => {
                let rapid = if *is_rapid { "G00" } else { "G01" };
                writeln!(self.text, "{} {rapid} {first}{x} {second}{y}", mode(*is_incremental))
            }
            Block::Arc { is_clockwise, centre, end } => {
                let [a, b] = centre.map(|c| i32::from(c) % 16);
                let (x, y) = (-a, -b);
                let ends = [(x, y), (-x, -y), (-y, x), (y, -x), (y, x), (-y, -x), (x, -y), (-x, y)];
                let (x_end, y_end) = ends[usize::from(end % 8)];
                let (dx, dy) = (x_end - x, y_end - y);
                let arc = arc(*is_clockwise);
                writeln!(self.text, "G91 {arc} {first}{dx}. {second}{dy}. {i}{a}. {j}{b}.")
            }
            Block::ByCentre { is_clockwise, to: [x, y], centre: [a, b] } => {
                let arc = arc(*is_clockwise);
                writeln!(self.text, "{arc} {first}{x} {second}{y} {i}{a} {j}{b}")
            }
            Block::ByRadius { is_clockwise, to: [x, y], radius } => {
                let arc = arc(*is_clockwise);
                writeln!(self.text, "{arc} {first}{x} {second}{y} R{radius}")
            }
            Block::Across(to) => writeln!(self.text, "G01 {across}{to}"),
            Block::Word(word) => {
                let word = usize::from(*word) % WORDS.len();
                self.plane = if word < 3 { word } else { self.plane };
                write!(self.text, "{}", WORDS[word])
            }
            Block::Text(text) => writeln!(self.text, "{text}"),
        };
    }
}

impl fmt::Display for Millimetres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let whole = i32::from(self.0 % 32) - 16;
        let decimals = ["", "", "", "", "", "5", "001", "333333333"][usize::from(self.0 / 32)];
        write!(f, "{whole}.{decimals}")
    }
}
