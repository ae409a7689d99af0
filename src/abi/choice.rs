//! Constants of the host: choices of an enumeration, flags, and reserved fields.

use super::failure::CallError;
use crate::base::error::{Error, Rule};

/// A choice of the library that is an enumeration of the interface.
pub(super) trait Choice: Copy + 'static {
    /// The name of the enumeration.
    const ENUMERATION: &'static str;
    /// Its constants.
    const CODES: &'static [(i32, Self)];

    /// The constant of this choice.
    fn code(self) -> i32;

    /// The choice of the host's `value` of `field`.
    fn of(field: &'static str, value: i32) -> Result<Self, CallError> {
        one_of(field, value, Self::CODES, Self::ENUMERATION)
    }
}

/// Makes a type a [`Choice`]: all that it can be, with their constants.
macro_rules! choices {
    ($enumeration:ident: $type:ty { $($choice:ident = $code:ident),* $(,)? }) => {
        impl $crate::abi::choice::Choice for $type {
            const ENUMERATION: &'static str = stringify!($enumeration);
            const CODES: &'static [(i32, Self)] = &[$(($code, Self::$choice)),*];

            fn code(self) -> i32 {
                match self { $(Self::$choice => $code,)* }
            }
        }
    };
}
pub(super) use choices;

/// The value of a field that holds a constant of `enumeration`; the constants are successive integers.
pub(super) fn one_of<T: Copy>(
    field: &'static str,
    value: i32,
    choices: &[(i32, T)],
    enumeration: &'static str,
) -> Result<T, CallError> {
    match choices.iter().find(|(code, _)| *code == value) {
        Some((_, choice)) => Ok(*choice),
        None => {
            let codes = || choices.iter().map(|&(code, _)| code);
            let (first, last) = (codes().min().unwrap_or(0), codes().max().unwrap_or(0));
            Err(Error::invalid(field, value, Rule::OneOf(enumeration, first, last)).into())
        }
    }
}

/// The number of one of `count` kinds, which a field holds as a constant of `enumeration`.
pub(super) fn of_kinds(
    field: &'static str,
    value: i32,
    count: usize,
    enumeration: &'static str,
) -> Result<usize, CallError> {
    match usize::try_from(value) {
        Ok(kind) if kind < count => Ok(kind),
        _ => Err(Error::invalid(field, value, Rule::OneOf(enumeration, 0, count as i32 - 1)).into()),
    }
}

/// The value of a field that holds a constant of an `enumeration` of two: 0 is off, 1 is on.
pub(super) fn switch(field: &'static str, value: i32, enumeration: &'static str) -> Result<bool, CallError> {
    one_of(field, value, &[(0, false), (1, true)], enumeration)
}

/// Rejects a reserved field that is not 0.
pub(super) fn check_reserved(field: &'static str, value: u32) -> Result<(), CallError> {
    if value == 0 { Ok(()) } else { Err(Error::invalid(field, value, Rule::Zero("")).into()) }
}

/// `flag` if it is set, to be or'ed with others.
#[inline(always)]
pub(super) fn flag<T: Default>(is_set: bool, flag: T) -> T {
    if is_set { flag } else { T::default() }
}
