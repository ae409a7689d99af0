//! Structs that hold what a simulator or a scene is set to.

use super::failure::Failure;
use super::memory::Struct;

/// A struct that holds parameters.
pub(super) trait Parameters: Struct {
    /// The parameters.
    type Own;

    /// The struct with `parameters`.
    fn from_parameters(parameters: &Self::Own) -> Self;

    /// The parameters that the struct holds.
    fn to_parameters(self) -> Result<Self::Own, Failure>;
}
