//! Where the values of a native run come from.

use fastrand::Rng;

/// A source of values, and what it has given so far.
#[derive(Default)]
pub(super) struct Source {
    kind: Kind,
    drawn: Vec<u64>,
}

#[derive(Default)]
enum Kind {
    #[default]
    None,
    Random(Rng),
    Enumeration {
        width: u32,
        choices: Vec<Choice>,
    },
    Replay,
}

/// One draw of an enumeration: which of how many.
#[derive(Clone, Copy)]
pub(super) struct Choice {
    index: u64,
    count: u64,
}

impl Source {
    pub(super) const fn none() -> Self {
        Self { kind: Kind::None, drawn: Vec::new() }
    }

    pub(super) fn random(seed: u64) -> Self {
        Self { kind: Kind::Random(Rng::with_seed(seed)), drawn: Vec::new() }
    }

    /// The run of an enumeration that begins with these choices and goes on with first ones.
    pub(super) const fn enumeration(width: u32, choices: Vec<Choice>) -> Self {
        Self { kind: Kind::Enumeration { width, choices }, drawn: Vec::new() }
    }

    /// Draws are answered from the end of this list, so it is turned round.
    pub(super) fn replay(mut values: Vec<u64>) -> Self {
        values.reverse();
        Self { kind: Kind::Replay, drawn: values }
    }

    pub(super) fn drawn(self) -> Vec<u64> {
        self.drawn
    }

    /// The choices of the enumeration's next run; none after the last.
    pub(super) fn next_choices(self) -> Option<Vec<Choice>> {
        let Kind::Enumeration { mut choices, .. } = self.kind else { return None };
        // A run that was rejected early has not come to the choices after its last draw.
        choices.truncate(self.drawn.len());
        while let Some(last) = choices.last_mut() {
            last.index += 1;
            if last.index < last.count {
                return Some(choices);
            }
            choices.pop();
        }
        None
    }

    pub(super) fn given(&mut self, value: u64) -> u64 {
        if self.is_replay() { self.draw(u64::BITS, false) } else { value }
    }

    pub(super) const fn is_replay(&self) -> bool {
        matches!(self.kind, Kind::Replay)
    }

    pub(super) fn draw(&mut self, bits: u32, is_signed: bool) -> u64 {
        let at = self.drawn.len();
        let value = match &mut self.kind {
            Kind::None => 0,
            Kind::Replay => return self.drawn.pop().unwrap_or(0),
            Kind::Random(random) => drawn_at_random(random, bits, is_signed),
            Kind::Enumeration { width, choices } => {
                let width = bits.min(*width);
                if at == choices.len() {
                    choices.push(Choice { index: 0, count: 1 << width });
                }
                let index = choices[at].index;
                if is_signed { sign_extended(index, width, bits) } else { index }
            }
        };
        self.drawn.push(value);
        value
    }
}

/// Of every width up to the full one alike, and often a boundary: what fails, fails there.
fn drawn_at_random(random: &mut Rng, bits: u32, is_signed: bool) -> u64 {
    let width = random.u32(1..=bits);
    let value = match random.u8(0..8) {
        0 => 0,
        1 => 1,
        2 => mask(width),
        3 => 1 << (width - 1),
        4 => mask(width - 1),
        _ => random.u64(..) & mask(width),
    };
    if is_signed { sign_extended(value, width, bits) } else { value }
}

/// A two's complement number of `width` bits as one of `bits` bits.
const fn sign_extended(value: u64, width: u32, bits: u32) -> u64 {
    let shift = 64 - width;
    ((value << shift) as i64 >> shift) as u64 & mask(bits)
}

const fn mask(bits: u32) -> u64 {
    match bits {
        0 => 0,
        _ => u64::MAX >> (64 - bits),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn enumeration_comes_to_every_pair_once() {
        let mut seen = Vec::new();
        let mut choices = Vec::new();
        loop {
            let mut source = Source::enumeration(2, choices);
            // The second draw is made for some values of the first only.
            let first = source.draw(8, true) as u8 as i8;
            let second = if first < 0 { None } else { Some(source.draw(1, false)) };
            seen.push((first, second));
            match source.next_choices() {
                Some(next) => choices = next,
                None => break,
            }
        }
        seen.sort_unstable();
        let expected =
            [(-2, None), (-1, None), (0, Some(0)), (0, Some(1)), (1, Some(0)), (1, Some(1))];
        assert_eq!(seen, expected);
    }

    #[test]
    fn random_values_fit_their_width() {
        let mut source = Source::random(1);
        for _ in 0..10_000 {
            assert!(source.draw(16, false) <= 0xffff);
            assert!(source.draw(16, true) <= 0xffff);
            assert!(source.draw(1, false) <= 1);
        }
    }
}
