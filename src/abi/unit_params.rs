//! `sins_unit_params`.

use super::parameters::params;
use crate::surroundings::copy;
use crate::unit::UnitParameters;

include!(concat!(env!("OUT_DIR"), "/unit_params.rs"));

params!(sins_unit_params, "unit", 184, UnitParameters, copy);
