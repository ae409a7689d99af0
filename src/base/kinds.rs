//! Enumerations of kinds, each of which uses some of the quantities of one flat form: that of the C interface and of scenes.

use super::error::{Error, Rule};

/// Makes an enumeration of kinds, its flat form, and the way from one to the other.
///
/// The flat form has the quantities of all kinds, each with the value that it has where nobody sets it, and `KINDS`: of each kind the
/// word of scenes and the quantities that it uses, as errors name them, at the place of its number. The numbers are those of the C
/// interface. `none` is a flat form that is of no kind; its number is 0. A kind may have one more field than numbers. If one row ends
/// with what its kind does (`acts Added`, a variant of `Acts`), all do.
macro_rules! kinds {
    (@acts $kinds:ident: $($kind:ident,)*) => {};
    (@acts $kinds:ident: $($kind:ident $acts:ident,)*) => {
        impl $kinds {
            /// What it does, as its row says.
            pub(super) fn acts(&self) -> Acts {
                match self {
                    $(Self::$kind { .. } => Acts::$acts,)*
                }
            }
        }
    };
    (
        $(#[$doc:meta])*
        $kinds:ident of $of:literal, flat $flat:ident $(none $none:literal)? {
            $($(#[$quantity_doc:meta])* $quantity:ident = $unset:expr),* $(,)?
        } $(with $extra:ident: $extra_type:ty)?
        {
            $($(#[$kind_doc:meta])*
            $kind:ident = $code:literal $word:literal $({ $($used:ident),* $(; $field:ident: $field_type:ty)? })? $(acts $acts:ident)?),* $(,)?
        }
    ) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[allow(missing_docs, reason = "the flat form describes the quantities")]
        pub enum $kinds {
            $($(#[$kind_doc])* $kind $({ $($used: f64,)* $($field: $field_type)? })?,)*
        }

        #[doc = concat!("A ", $of, " of any kind. It has the quantities of all kinds; a kind uses those that `KINDS` lists.")]
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub(crate) struct $flat {
            /// Number of the kind, which is its place in `KINDS`.
            pub kind: usize,
            $($(#[$quantity_doc])* pub $quantity: f64,)*
            $(pub $extra: $extra_type,)?
        }

        impl Default for $flat {
            fn default() -> Self {
                Self { kind: 0, $($quantity: $unset,)* $($extra: <$extra_type>::default())? }
            }
        }

        impl $flat {
            /// The names of the quantities.
            const QUANTITIES: &[&'static str] = &[$(concat!($of, ".", stringify!($quantity))),*];

            /// The kinds: word, and the quantities that the kind uses.
            pub const KINDS: &[(&'static str, &[&'static str])] = &[
                $(($none, Self::QUANTITIES),)?
                $(($word, &[$($(concat!($of, ".", stringify!($used))),*)?])),*
            ];

            /// The words of the kinds.
            #[cfg(feature = "scenes")]
            pub const WORDS: &[&'static str] = &[$($none,)? $($word),*];

            /// The quantities.
            pub fn numbers_mut(&mut self) -> [&mut f64; Self::QUANTITIES.len()] {
                [$(&mut self.$quantity),*]
            }

            /// Rejects `numbers`, the quantities of an interface in which 0 is not set, if the kind does not use one that is set.
            pub fn check_unused(&self, numbers: &[f64]) -> Result<(), $crate::base::error::Error> {
                let uses = if self.kind().is_some() { Self::KINDS[self.kind].1 } else { &[] };
                $crate::base::kinds::check_unused(uses, Self::QUANTITIES, numbers, concat!(": this ", $of, " does not use it"))
            }

            /// What it describes; `None`: it is of no kind. Quantities that the kind does not use are ignored.
            pub fn kind(&self) -> Option<$kinds> {
                match self.kind {
                    $($code => Some($kinds::$kind $({ $($used: self.$used,)* $($field: self.$field)? })?),)*
                    _ => None,
                }
            }
        }

        impl From<&$kinds> for $flat {
            fn from(from: &$kinds) -> Self {
                match *from {
                    $($kinds::$kind $({ $($used,)* $($field)? })? => {
                        Self { kind: $code, $($($used,)* $($field,)?)? ..Self::default() }
                    })*
                }
            }
        }

        $crate::base::kinds::kinds! { @acts $kinds: $($kind $($acts)?,)* }

        // The number of a kind is its place.
        const _: () = {
            let (numbers, mut place) = ([$($code),*], 0);
            while place < numbers.len() {
                assert!(
                    numbers[place] == place + $flat::KINDS.len() - numbers.len(),
                    "the rows of the kinds stand in the order of their numbers, without a gap: a new one is the last"
                );
                place += 1;
            }
        };
    };
}
pub(crate) use kinds;

/// Rejects a number that is not 0, of a quantity that is not in `uses`.
pub fn check_unused(
    uses: &[&str],
    quantities: &[&'static str],
    numbers: &[f64],
    rule: &'static str,
) -> Result<(), Error> {
    match quantities.iter().zip(numbers).find(|(of, number)| **number != 0.0 && !uses.contains(of)) {
        Some((of, number)) => Err(Error::invalid(of, *number, Rule::Zero(rule))),
        None => Ok(()),
    }
}
