//! The table of the parameters of the altimeter: each is listed here once.
//!
//! `build.rs` makes from it the struct of the interface with the header, that of the crate, and the numbers of both. Checks, keys of
//! scene files and rows of an error budget read it.

use crate::base::parameter::Range::{TimeOf, Within};
use crate::base::parameter::Shape::Number;
use crate::base::parameter::{CORRELATION_TIMES_S, GIVEN, RANDOM, Range, Row, own_field as field, row};
use crate::base::units::PPM;

const HEIGHT_SIZE: Range = Within(0.0, 1e5);

/// Errors of the altimeter, in the order of the struct of the interface.
#[rustfmt::skip]
pub const ALTIMETER: [Row; 6] = [
    row("bias_m", Number, GIVEN, "constant bias",
        field(("altimeter.bias_m", "m"), Within(-1e5, 1e5), ("bias_m", "m", 1.0), "altimeter bias"), ""),
    row("markov_sigma_m", Number, RANDOM, "standard deviation of the Gauss-Markov error",
        field(("altimeter.markov_sigma_m", "m"), HEIGHT_SIZE, ("markov_sigma_m", "m", 1.0), "altimeter Gauss-Markov"),
        "The error is of first order, and stationary from the first sample on."),
    row("markov_time_s", Number, RANDOM, "correlation time of the Gauss-Markov error",
        field(("altimeter.markov_time_s", "s"), TimeOf("altimeter.markov_sigma_m", CORRELATION_TIMES_S.0, CORRELATION_TIMES_S.1),
            ("markov_time_s", "s", 1.0), ""), ""),
    row("noise_m", Number, RANDOM, "standard deviation of the independent error of each sample",
        field(("altimeter.noise_m", "m"), HEIGHT_SIZE, ("noise_m", "m", 1.0), "altimeter noise"), ""),
    row("scale_factor", Number, GIVEN, "scale factor error of the height",
        field(("altimeter.scale_factor", ""), Within(-1.0, 1.0), ("scale_factor_ppm", "ppm", PPM), "altimeter scale factor"), ""),
    row("lag_s", Number, GIVEN, "time constant of the lag of the static pressure",
        field(("altimeter.lag_s", "s"), Within(0.0, 1e6), ("lag_s", "s", 1.0), "altimeter lag"), "The lag is of first order."),
];
