//! How a struct of the interface holds parameters of the crate: `sins_options`, `sins_gyro_params` and so on.

use super::failure::CallError;
use super::memory::Struct;

/// A struct that holds parameters.
pub(super) trait Parameters: Struct {
    /// The parameters.
    type Own;

    /// The struct with `parameters`.
    fn from_parameters(parameters: &Self::Own) -> Self;

    /// The parameters that the struct holds.
    fn to_parameters(self) -> Result<Self::Own, CallError>;
}

/// Declares a struct of a table with its name in messages and its first size, and makes parameters of it and back: `$copy` copies
/// the numbers of one to the other. A choice has a field `$choice` of the interface and its place in the parameters.
macro_rules! params {
    ($type:ident, $name:literal, $first_size:expr, $own:ty, $copy:ident $(, $choice:ident: $place:ident)?) => {
        $crate::abi::memory::interface_struct!($type, $name, $first_size);

        impl $crate::abi::parameters::Parameters for $type {
            type Own = $own;

            fn to_parameters(self) -> Result<$own, $crate::abi::failure::CallError> {
                $crate::abi::choice::check_reserved(concat!($name, ".reserved"), self.reserved)?;
                let mut parameters = <$own>::default();
                $copy(self.numbers(), parameters.numbers_mut());
                $(
                    $crate::abi::choice::check_reserved(concat!($name, ".reserved2"), self.reserved2)?;
                    let choice = concat!($name, ".", stringify!($choice));
                    parameters.$place = $crate::abi::choice::Choice::of(choice, self.$choice)?;
                )?
                Ok(parameters)
            }

            fn from_parameters(parameters: &$own) -> Self {
                let mut params = Self { struct_size: size_of::<Self>() as u32, ..Self::default() };
                $copy(parameters.numbers(), params.numbers_mut());
                $(params.$choice = $crate::abi::choice::Choice::code(parameters.$place);)?
                params
            }
        }
    };
}
pub(super) use params;
