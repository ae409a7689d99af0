//! Which fields of a part are kept, so that none can be forgotten.

use super::{ANY, Reader, Writer};
use crate::base::error::Error;
use crate::base::math::Euler;

/// A part of the simulator that a snapshot keeps.
pub(crate) trait Stored {
    fn save(&self, to: &mut Writer<'_>);
    /// Reads the values of a part, which was created with the same options and parameters.
    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error>;
}

/// Makes a struct [`Stored`]. Every field is named in one of two lists: the compiler rejects a struct with a field that is in neither.
///
/// `field: limit` is one number or several, each finite and within ±limit when it is read. A `field` without a limit is `Stored`
/// itself.
/// A `rebuilt` field follows from the options, the parameters or other fields. It keeps the value with which the part was created,
/// and the closure after `then` may change it, or reject the part, when the other fields are read.
macro_rules! stored {
    (
        $type:ident { $($field:ident $(: $limit:expr)?),* $(,)? }
        $(rebuilt { $($rebuilt:ident),* $(,)? })?
        $(then $then:expr)?
    ) => {
        #[allow(unused_variables, reason = "a part may keep nothing")]
        impl $crate::base::snapshot::Stored for $type {
            fn save(&self, to: &mut $crate::base::snapshot::Writer<'_>) {
                let Self { $($field,)* $($($rebuilt: _,)*)? } = self;
                $($crate::base::snapshot::stored!(@save $field, to $(, $limit)?);)*
            }

            fn load(&mut self, from: &mut $crate::base::snapshot::Reader<'_>) -> Result<(), $crate::base::error::Error> {
                let Self { $($field,)* $($($rebuilt: _,)*)? } = self;
                $(
                    from.enter(concat!("snapshot: ", stringify!($type), ".", stringify!($field)));
                    $crate::base::snapshot::stored!(@load $field, from $(, $limit)?)?;
                )*
                $(
                    let then: fn(&mut Self, &$crate::base::snapshot::Reader<'_>) -> Result<(), $crate::base::error::Error> = $then;
                    then(self, from)?;
                )?
                Ok(())
            }
        }
    };
    (@save $field:ident, $to:ident) => { $crate::base::snapshot::Stored::save($field, $to) };
    (@save $field:ident, $to:ident, $limit:expr) => { $crate::base::snapshot::Numbers::save($field, $to) };
    (@load $field:ident, $from:ident) => { $crate::base::snapshot::Stored::load($field, $from) };
    (@load $field:ident, $from:ident, $limit:expr) => { $crate::base::snapshot::Numbers::load($field, $from, $limit) };
}
pub(crate) use stored;

/// Makes an enumeration [`Stored`] as numbers, with the words of its variants in scenes. The numbers are part of the format: never use
/// one again for another variant.
macro_rules! codes {
    ($type:ident { $($variant:ident = $code:literal $word:literal),* $(,)? }) => {
        #[cfg(feature = "scenes")]
        impl $type {
            /// The words of scenes and programs, with what each means.
            pub const WORDS: [(&'static str, Self); [$($code),*].len()] = [$(($word, Self::$variant)),*];

            /// The word of this one.
            pub const fn word(&self) -> &'static str {
                match self { $(Self::$variant => $word,)* }
            }

            /// What `word` means.
            pub fn of_word(word: &str) -> Option<Self> {
                Self::WORDS.into_iter().find(|(known, _)| *known == word).map(|(_, one)| one)
            }
        }

        impl $crate::base::snapshot::Stored for $type {
            fn save(&self, to: &mut $crate::base::snapshot::Writer<'_>) {
                to.word(match self { $(Self::$variant => $code,)* });
            }

            fn load(&mut self, from: &mut $crate::base::snapshot::Reader<'_>) -> Result<(), $crate::base::error::Error> {
                *self = match from.word()? {
                    $($code => Self::$variant,)*
                    code => {
                        let rule = $crate::base::error::Rule::Sentence("is not a value that this release knows");
                        return Err(from.refused(code as u64, rule));
                    }
                };
                Ok(())
            }
        }
    };
}
pub(crate) use codes;

/// Makes an enumeration of parts [`Stored`]. The options choose one of the parts.
macro_rules! variants {
    ($type:ident { $($variant:ident),* $(,)? }) => {
        impl $crate::base::snapshot::Stored for $type {
            fn save(&self, to: &mut $crate::base::snapshot::Writer<'_>) {
                match self { $(Self::$variant(part) => part.save(to),)* }
            }

            fn load(&mut self, from: &mut $crate::base::snapshot::Reader<'_>) -> Result<(), $crate::base::error::Error> {
                match self { $(Self::$variant(part) => part.load(from),)* }
            }
        }
    };
}
pub(crate) use variants;

stored!(Euler { roll: ANY, pitch: ANY, heading: ANY });

impl Stored for bool {
    fn save(&self, to: &mut Writer<'_>) {
        to.flag(*self);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        *self = from.flag()?;
        Ok(())
    }
}

/// Parts whose number is known: of an array, or one or none that the options call for.
impl<T: Stored> Stored for [T] {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        self.iter().for_each(|part| part.save(to));
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.iter_mut().try_for_each(|part| part.load(from))
    }
}

impl<T: Stored, const N: usize> Stored for [T; N] {
    #[inline]
    fn save(&self, to: &mut Writer<'_>) {
        self.as_slice().save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.as_mut_slice().load(from)
    }
}

impl<T: Stored + Default> Stored for Option<T> {
    fn save(&self, to: &mut Writer<'_>) {
        to.flag(self.is_some());
        if let Some(part) = self {
            part.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        *self = if from.flag()? {
            let mut part = T::default();
            part.load(from)?;
            Some(part)
        } else {
            None
        };
        Ok(())
    }
}
