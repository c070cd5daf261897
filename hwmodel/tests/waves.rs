//! What the wave files say, read back with other people's readers.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use onepulse_core::dda::Preset;
use onepulse_core::parabola::Shape;
use onepulse_core::{Axis, Direction, EndRule};
use onepulse_hwmodel::trace::{
    Bench, Clock, Fst, Kind, Probe, SignalList, Tracer, Vcd, Wave, gtkw, sucl,
};
use onepulse_hwmodel::{Circuit, brm, comparison, dda, minimum_deviation, parabola, ppc};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;
use std::process::Command;

/// Every signal's changes by its full name: (time, value as text).
type Changes = BTreeMap<String, Vec<(u64, String)>>;

/// Traces a circuit to its end, as `<dir>/wave.vcd` and `<dir>/wave.fst`.
fn trace<C: Circuit<AXES> + Clone, const AXES: usize>(dir: &Path, circuit: &C, hertz: u64) {
    let mut list = SignalList::new();
    let bench = Bench::declare(&mut list, &[0; AXES]);
    let first = list.add_circuit(circuit);
    let clock = Clock::new(hertz).unwrap();
    let open = |name: &str| BufWriter::new(File::create(dir.join(name)).unwrap());
    let vcd = Vcd::new(open("wave.vcd"), &list, clock.exponent()).unwrap();
    run(Tracer::new(vcd, &list), bench.clone(), first, circuit.clone(), clock);
    let fst = Fst::new(open("wave.fst"), &list, clock.exponent()).unwrap();
    run(Tracer::new(fst, &list), bench, first, circuit.clone(), clock);
}

fn run<W: Wave, C: Circuit<AXES>, const AXES: usize>(
    mut tracer: Tracer<W>,
    mut bench: Bench,
    first: usize,
    mut circuit: C,
    clock: Clock,
) {
    let mut k = 0;
    while !circuit.done() {
        bench.clock(&mut tracer, first, &mut circuit, clock.rise(k), clock.fall(k));
        k += 1;
    }
    bench.sample(&mut tracer, first, &circuit, clock.rise(k));
    tracer.finish(clock.fall(k)).unwrap();
}

fn read(path: &Path) -> Changes {
    let mut wave = wellen::simple::read(path).unwrap();
    let vars: Vec<_> = wave
        .hierarchy()
        .all_vars()
        .map(|var| {
            let var = &wave.hierarchy()[var];
            (var.full_name(wave.hierarchy()), var.signal_ref())
        })
        .collect();
    wave.load_signals(&vars.iter().map(|(_, signal)| *signal).collect::<Vec<_>>());
    let times = wave.time_table().to_vec();
    vars.into_iter()
        .map(|(name, signal)| {
            let changes = wave
                .get_signal(signal)
                .unwrap()
                .iter_changes()
                .map(|(at, value)| (times[at as usize], value.to_string()))
                .collect();
            (name, changes)
        })
        .collect()
}

/// The value of a signal during clock period `k`, as a number.
fn value_at(changes: &Changes, name: &str, time: u64) -> i64 {
    let text = &changes[name].iter().rev().find(|(at, _)| *at <= time).unwrap().1;
    i64::from_str_radix(text, 2).unwrap()
}

#[test]
fn a_dda_line_shows_the_textbook_registers() {
    let dir = tempfile::tempdir().unwrap();
    let circuit = dda::Line::new([4, 6], 3, Preset::Zero, false).unwrap();
    trace(dir.path(), &circuit, 1_000_000);
    for file in ["wave.vcd", "wave.fst"] {
        let wave = wellen::simple::read(dir.path().join(file)).unwrap();
        let scale = wave.hierarchy().timescale().unwrap();
        assert_eq!((scale.factor, scale.unit.to_exponent()), (100, Some(-9)), "{file}");

        // 1 MHz: a clock period is 10 units of 100 ns. JR after k clocks is k·JV mod 8.
        let changes = read(&dir.path().join(file));
        for k in 0..=8_u64 {
            let at = |name: &str| value_at(&changes, name, 10 * k);
            assert_eq!(at("onepulse.dda_line.jrx"), (4 * k % 8) as i64, "{file}, clock {k}");
            assert_eq!(at("onepulse.dda_line.jry"), (6 * k % 8) as i64, "{file}, clock {k}");
            assert_eq!(at("onepulse.position_x"), (4 * k / 8) as i64, "{file}, clock {k}");
            assert_eq!(at("onepulse.position_y"), (6 * k / 8) as i64, "{file}, clock {k}");
            assert_eq!(at("onepulse.dda_line.je"), 8 - k as i64);
            let carries = k < 8 && 6 * k % 8 + 6 >= 8;
            assert_eq!(at("onepulse.pulse_y"), i64::from(carries), "{file}, clock {k}");
            assert_eq!(value_at(&changes, "onepulse.clk", 10 * k), 1);
            if k < 8 {
                assert_eq!(value_at(&changes, "onepulse.clk", 10 * k + 5), 0);
            }
        }
        assert_eq!(changes["onepulse.dda_line.jvx"], [(0, "100".to_owned())]);
    }
}

#[test]
fn the_four_beats_read_as_words() {
    let dir = tempfile::tempdir().unwrap();
    let arc = ppc::Arc::new([5, 0], [0, 5], Direction::Ccw, 3, EndRule::Total).unwrap();
    trace(dir.path(), &arc, 4_000_000);
    let changes = read(&dir.path().join("wave.vcd"));
    let beats: Vec<_> = changes["onepulse.ppc_arc.beat"].iter().map(|(_, w)| w.as_str()).collect();
    let step = ["JUDGE", "FEED", "UPDATE", "COMPARE"];
    assert_eq!(beats[..8], [step, step].concat());
    assert_eq!(beats.len(), 41);
    // F as the textbook prints it, judged every fourth clock of 250 ns; 5 bits wide.
    let f = |k: u64| {
        let bits = value_at(&changes, "onepulse.ppc_arc.f", 1000 * k);
        if bits >= 16 { bits - 32 } else { bits }
    };
    let printed = [0, -9, -8, -5, 0, -7, 0, -5, 4, 1, 0];
    assert_eq!((0..=10).map(f).collect::<Vec<_>>(), printed);

    // FST has the same words as ASCII.
    let ascii: Vec<String> = read(&dir.path().join("wave.fst"))["onepulse.ppc_arc.beat"]
        .iter()
        .map(|(_, bits)| {
            let bytes = (0..bits.len()).step_by(8);
            bytes.map(|at| u8::from_str_radix(&bits[at..at + 8], 2).unwrap() as char).collect()
        })
        .collect();
    let ascii: Vec<_> = ascii.iter().map(|word| word.trim_matches('\0')).collect();
    assert_eq!(ascii, beats);
}

/// The signals of a circuit, read from it directly: the words by name, numbers masked.
#[derive(Default)]
struct Reading(Vec<String>);

impl Probe for Reading {
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    fn signal(&mut self, _: &'static str, kind: Kind, value: u64) {
        self.0.push(match kind {
            Kind::Word(words) => words[value as usize].to_owned(),
            _ => {
                let bits = kind.bits() as usize;
                let text = format!("{value:064b}");
                text[64 - bits..].to_owned()
            }
        });
    }
}

/// Every signal of the VCD and of the FST has, in every clock period, the circuit's value, and no
/// change repeats the value before it.
fn assert_faithful<C: Circuit<AXES> + Clone, const AXES: usize>(circuit: &C) {
    let dir = tempfile::tempdir().unwrap();
    trace(dir.path(), circuit, 500_000_000);
    let mut list = SignalList::new();
    let first = list.add_circuit(circuit);
    assert_eq!(first, 0);
    let names: Vec<_> =
        list.signals().iter().map(|s| format!("onepulse.{}.{}", C::NAME, s.name)).collect();

    let read_vcd = read(&dir.path().join("wave.vcd"));
    let mut circuit = circuit.clone();
    for k in 0.. {
        let mut reading = Reading::default();
        circuit.probe(&mut reading);
        for (name, value) in names.iter().zip(&reading.0) {
            let changes = &read_vcd[name];
            let shown = &changes.iter().rev().find(|(at, _)| *at <= 2 * k).unwrap().1;
            let width = value.len();
            assert_eq!(format!("{shown:0>width$}"), *value, "{name}, clock {k}");
        }
        if circuit.done() {
            break;
        }
        circuit.clock();
    }
    // As written: readers leave repeated values out by themselves.
    let mut last = BTreeMap::new();
    let text = File::open(dir.path().join("wave.vcd")).unwrap();
    for command in vcd::Parser::new(BufReader::new(text)) {
        let (id, value) = match command.unwrap() {
            vcd::Command::ChangeScalar(id, value) => (id, value.to_string()),
            vcd::Command::ChangeVector(id, value) => (id, value.to_string()),
            vcd::Command::ChangeString(id, value) => (id, value),
            _ => continue,
        };
        assert_ne!(last.insert(id, value.clone()), Some(value), "{id} repeats its value");
    }
    for (name, changes) in &read_vcd {
        assert!(changes.windows(2).all(|pair| pair[0].0 < pair[1].0), "{name} runs backwards");
    }

    // FST and GTKWave's own converter agree with the VCD in everything but how words are kept.
    let fst = read(&dir.path().join("wave.fst"));
    let converted = dir.path().join("converted.fst");
    let status = Command::new("vcd2fst")
        .args([dir.path().join("wave.vcd"), converted.clone()])
        .output()
        .expect("vcd2fst is needed (Debian package gtkwave)")
        .status;
    assert!(status.success(), "vcd2fst: {status}");
    let converted = read(&converted);
    assert_eq!(read_vcd.keys().collect::<Vec<_>>(), fst.keys().collect::<Vec<_>>());
    assert_eq!(read_vcd.keys().collect::<Vec<_>>(), converted.keys().collect::<Vec<_>>());
    for (name, changes) in &read_vcd {
        assert_eq!(&converted[name], changes, "{name} as vcd2fst has it");
        let times = |changes: &[(u64, String)]| changes.iter().map(|c| c.0).collect::<Vec<_>>();
        assert_eq!(times(&fst[name]), times(changes), "{name} in the FST");
        if changes.iter().all(|(_, value)| value.bytes().all(|b| b == b'0' || b == b'1')) {
            assert_eq!(&fst[name], changes, "{name} in the FST");
        }
    }
}

#[test]
fn every_circuit_is_traced_faithfully() {
    assert_faithful(&dda::Line::new([-5, 13, 7], 5, Preset::Half, true).unwrap());
    let full = [-25, 0];
    assert_faithful(&dda::Arc::new(full, full, Direction::Cw, 6, Preset::Full, false).unwrap());
    assert_faithful(&dda::CentredArc::new([7, -24], [-24, 7], Direction::Ccw, 7, true).unwrap());
    assert_faithful(&ppc::Line::new([-9, 4], 5, EndRule::PerAxis).unwrap());
    assert_faithful(&ppc::Arc::new(full, full, Direction::Ccw, 5, EndRule::Larger).unwrap());
    assert_faithful(&brm::Line::new([10, -6], 4).unwrap());
    assert_faithful(&comparison::Arc::new(full, [0, 25], Direction::Cw, 5).unwrap());
    assert_faithful(&minimum_deviation::Arc::new([3, 4], [5, 1], Direction::Ccw, 4).unwrap());
    assert_faithful(&comparison::Line::new([-9, 15], 4).unwrap());
    assert_faithful(&minimum_deviation::Line::new([-9, 4, 13], 4).unwrap());
    let shape = Shape::new(Axis::Y, -2, [-8, -15]).unwrap();
    assert_faithful(&parabola::Ppc::new(shape, 4).unwrap());
}

/// An FST file is written in sections; GTKWave's own reader and wellen find in all of them what the
/// VCD has.
#[test]
fn a_long_wave_is_the_same_in_every_section() {
    let dir = tempfile::tempdir().unwrap();
    let circuit = dda::Line::new([90_001, -53_003], 17, Preset::Half, false).unwrap();
    trace(dir.path(), &circuit, 500_000_000);
    let fst = dir.path().join("wave.fst");
    let sections = u64::from_be_bytes(std::fs::read(&fst).unwrap()[65..73].try_into().unwrap());
    assert!(sections > 2, "{sections}");

    let converted = dir.path().join("converted.vcd");
    let status = Command::new("fst2vcd")
        .arg("-f")
        .arg(&fst)
        .arg("-o")
        .arg(&converted)
        .output()
        .expect("fst2vcd is needed (Debian package gtkwave)")
        .status;
    assert!(status.success(), "fst2vcd: {status}");
    let vcd = read(&dir.path().join("wave.vcd"));
    for file in [fst, converted] {
        let other = read(&file);
        assert_eq!(vcd.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
        for (name, changes) in &vcd {
            let is_equal = changes.len() == other[name].len() && changes == &other[name];
            assert!(is_equal, "{name} in {}", file.display());
        }
    }
}

#[test]
fn the_layout_names_every_signal_of_the_wave() {
    let circuit = ppc::Line::new([5, 3], 3, EndRule::Total).unwrap();
    let mut list = SignalList::new();
    Bench::declare(&mut list, &[0; 2]);
    list.add_circuit(&circuit);
    let layout = gtkw("wave.vcd", &list, 10.0);
    let shown: Vec<_> = layout.lines().filter(|line| line.starts_with("onepulse.")).collect();
    assert_eq!(shown.len(), list.signals().len());
    assert!(shown.contains(&"onepulse.ppc_line.f[3:0]"), "{layout}");
    assert!(shown.contains(&"onepulse.ppc_line.beat"), "{layout}");
    assert!(layout.starts_with("[dumpfile] \"wave.vcd\"\n"));

    let commands = sucl("wave.vcd", &list);
    let shown: Vec<_> = commands.lines().filter(|line| line.starts_with("variable_add ")).collect();
    assert_eq!(shown.len(), list.signals().len());
    let beat = "variable_add onepulse.ppc_line.beat\nitem_focus j\nitem_set_format String\n";
    assert!(commands.contains(beat), "{commands}");
    assert!(sucl("wave.fst", &list).contains(&beat.replace("String", "ASCII")));
}

#[test]
fn what_no_viewer_could_show_is_refused() {
    let refused = |list: &SignalList| Vcd::new(Vec::new(), list, -9).err().map(|e| e.to_string());
    let mut twice = SignalList::new();
    twice.add("clk", Kind::Bit);
    twice.add("clk", Kind::Bit);
    assert_eq!(refused(&twice).as_deref(), Some("two signals are named .clk"));
    let mut blank = SignalList::new();
    blank.add("a b", Kind::Bit);
    assert!(refused(&blank).is_some());
    let mut wide = SignalList::new();
    wide.add("j", Kind::Unsigned(65));
    assert!(refused(&wide).is_some());

    let mut list = SignalList::new();
    list.add("clk", Kind::Bit);
    assert!(Vcd::new(Vec::new(), &list, 1).is_err());
    let mut vcd = Vcd::new(Vec::new(), &list, -9).unwrap();
    vcd.time(5).unwrap();
    assert!(vcd.time(5).is_err());
}
