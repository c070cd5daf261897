//! Harnesses that are wrong on purpose: `prove --self-test` demands the right verdict on each.

use core::hint::black_box;

#[kani::proof]
fn wrong_assertion() {
    let value: u32 = kani::any();
    assert!(value != 1_234_567);
}

#[kani::proof]
fn wrong_overflow() {
    let value: i32 = kani::any();
    black_box(value + 1);
}

#[kani::proof]
fn wrong_index() {
    let place: u8 = kani::any();
    black_box([1, 2, 3][usize::from(place)]);
}

#[kani::proof]
fn wrong_division() {
    let [value, divisor]: [i32; 2] = kani::any();
    black_box(value / divisor);
}

/// Only these values, in this order, break it.
#[kani::proof]
fn wrong_order_of_values() {
    let first: u8 = kani::any();
    let second: i64 = kani::any();
    let third: bool = kani::any();
    let fourth: i16 = kani::any();
    assert!(first != 7 || second != -5_000_000_000 || !third || fourth != -3);
}

#[kani::proof]
fn wrong_contradiction() {
    let value: u32 = kani::any();
    kani::cover!(value == 7);
    kani::assume(value > 8);
    kani::assume(value < 8);
    assert!(value == 8);
}

#[kani::proof]
fn wrong_cover() {
    let value: u8 = kani::any();
    let square = u32::from(value) * u32::from(value);
    kani::cover!(square % 4 == 3);
    assert!(square % 4 < 2);
}

#[kani::proof]
fn wrong_assume_without_cover() {
    let value: u32 = kani::any_where(|value| *value > 7);
    assert!(value > 6);
}

#[kani::proof]
#[kani::unwind(4)]
fn wrong_unwind() {
    let mut left: u32 = kani::any();
    let mut steps = 0;
    while left > 0 {
        left = black_box(left) / 2;
        steps += 1;
    }
    assert!(steps <= 32);
}

#[kani::proof]
fn wrong_endless_loop() {
    let value: u32 = kani::any();
    kani::cover!(value == 7);
    // Each turn must be seen to change nothing.
    while black_box(value) == 7 {}
}
