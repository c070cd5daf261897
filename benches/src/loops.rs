//! The loops that motion firmware runs, written as plainly as they can be.

/// An integer Bresenham loop as stepper firmware has it: a counter an axis, each fed its steps and
/// relieved of the longest axis' steps when it runs over. Returns a sum that depends on every
/// pulse.
#[must_use]
pub fn firmware(end: [i32; 2]) -> u64 {
    let steps = end.map(i32::unsigned_abs);
    let events = steps[0].max(steps[1]);
    let mut counters = [events / 2; 2];
    let mut sum = 0;
    for _ in 0..events {
        for axis in 0..2 {
            counters[axis] += steps[axis];
            if counters[axis] > events {
                counters[axis] -= events;
                sum += axis as u64 + 1;
            }
        }
    }
    sum
}

/// Point-by-point comparison as a bare loop.
#[must_use]
pub fn point_by_point(end: [i32; 2]) -> u64 {
    let [xe, ye] = end.map(|c| i64::from(c.unsigned_abs()));
    let (mut f, mut sum) = (0_i64, 0);
    for _ in 0..xe + ye {
        if f >= 0 {
            f -= ye;
            sum += 1;
        } else {
            f += xe;
            sum += 2;
        }
    }
    sum
}

/// Two accumulators of 20 bits as a bare loop.
#[must_use]
pub fn accumulators(end: [i32; 2]) -> u64 {
    const BITS: u32 = 20;
    let jv = end.map(i32::unsigned_abs);
    let mut jr = [0_u32; 2];
    let mut sum = 0;
    for _ in 0..1 << BITS {
        for axis in 0..2 {
            jr[axis] += jv[axis];
            sum += u64::from(jr[axis] >> BITS) * (axis as u64 + 1);
            jr[axis] &= (1 << BITS) - 1;
        }
    }
    sum
}
