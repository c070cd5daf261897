//! What the remainder registers hold before the first accumulation.

use super::Register;

/// Remainder register preset (余数寄存器预置数).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Preset {
    /// 000…0.
    #[default]
    Zero,
    /// Half load (半加载): 100…0, one half of the register's range.
    Half,
    /// Full load (全加载): 111…1, the largest content of the register.
    Full,
}

impl Preset {
    /// The content of the remainder register.
    #[must_use]
    pub const fn value(self, register: Register) -> u64 {
        match self {
            Self::Zero => 0,
            Self::Half => register.modulus() / 2,
            Self::Full => register.modulus() - 1,
        }
    }
}
