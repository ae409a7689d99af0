//! Limits of errors on the command line.

use sins::Error;
use sins::analysis::recommend::SolutionError;
use sins::units::ARCSEC;

use crate::failure::Failure;

/// Limits in the units of a person.
#[derive(Debug, clap::Args)]
pub struct LimitArguments {
    /// Limit of the position error; 0: none
    #[arg(long, value_name = "METRES", default_value_t = 0.0)]
    position: f64,
    /// Limit of the velocity error; 0: none
    #[arg(long, value_name = "M_PER_S", default_value_t = 0.0)]
    velocity: f64,
    /// Limit of the attitude error; 0: none
    #[arg(long, value_name = "ARCSEC", default_value_t = 0.0)]
    attitude: f64,
}

impl LimitArguments {
    /// The limits in SI.
    pub fn errors(&self) -> SolutionError {
        SolutionError {
            position_m: self.position,
            velocity_m_s: self.velocity,
            attitude_rad: ARCSEC * self.attitude,
        }
    }
}

/// The sentence of `error` about a field of a request, with the option of the command line that sets the field, in its unit.
pub fn of_option(error: &Error) -> Failure {
    let (option, unit_si) = match error.field.rsplit('.').next().unwrap_or_default() {
        "runs" => ("--runs", 1.0),
        "position_m" => ("--position", 1.0),
        "velocity_m_s" => ("--velocity", 1.0),
        "attitude_rad" => ("--attitude", ARCSEC),
        "margin" => ("--margin", 1.0),
        "duration_s" => ("--hours", 3600.0),
        _ => (error.field, 1.0),
    };
    Failure::new(Error { field: option, ..error.in_unit(unit_si) }.to_string())
}
