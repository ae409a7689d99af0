//! The table of the errors at the start: each is listed here once.
//!
//! `build.rs` makes from it the struct of the interface with the header, that of the crate, and the numbers of both. Checks, keys of
//! scene files and rows of an error budget read it.

use crate::base::parameter::Range::{OffOr, Within};
use crate::base::parameter::Shape::{Axes, Number, Vector};
use crate::base::parameter::{GIVEN, RANDOM, Row, choice, own_field as field, row};
use crate::base::units::ARCMIN;

const PI: f64 = core::f64::consts::PI;

/// Errors at the start, in the order of the struct of the interface.
#[rustfmt::skip]
pub const INITIAL: [Row; 8] = [
    row("position_n", Vector, GIVEN, "position error, east-north-up",
        field(("initial.position_enu_m", "m"), Within(-1e6, 1e6), ("position_m", "m", 1.0), "initial position"),
        "The horizontal part is laid off at the height of the solution, and sins_errors measures it at the height of the truth: with an \
            error of 100 m in height, 3 km read back 0.046 m larger."),
    row("velocity_n", Vector, GIVEN, "velocity error, east-north-up",
        field(("initial.velocity_enu_m_s", "m/s"), Within(-1e4, 1e4), ("velocity_m_s", "m/s", 1.0), "initial velocity"), ""),
    row("misalignment_n", Vector, GIVEN, "misalignment phi, a rotation vector, east-north-up",
        field(("initial.misalignment_enu_rad", "rad"), Within(-PI, PI), ("misalignment_arcmin", "arcmin", ARCMIN), "initial misalignment"),
        "Computed C = exp(-[phi x]) C0. C turns vectors from sensor axes to east-north-up. C0 is the true C. With \
            SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS or SINS_ALIGNMENT_LEVEL, C0 is the C that the alignment finds."),
    row("position_sigma_n", Axes, RANDOM, "standard deviation of the position error",
        field(("initial.position_sigma_enu_m", "m"), Within(0.0, 1e5), ("position_sigma_m", "m", 1.0), "drawn initial position"), ""),
    row("velocity_sigma_n", Axes, RANDOM, "standard deviation of the velocity error",
        field(("initial.velocity_sigma_enu_m_s", "m/s"), Within(0.0, 1e3),
            ("velocity_sigma_m_s", "m/s", 1.0), "drawn initial velocity"), ""),
    row("misalignment_sigma_n", Axes, RANDOM, "standard deviation of the misalignment",
        field(("initial.misalignment_sigma_enu_rad", "rad"), Within(0.0, 1.0),
            ("misalignment_sigma_arcmin", "arcmin", ARCMIN), "drawn initial misalignment"), ""),
    choice("alignment", ("Alignment", "sins_alignment"), ("initial.alignment", "alignment at the start"), ""),
    row("alignment_s", Number, GIVEN, "length of the alignment, at rest before the first sample; 0: without end",
        field(("initial.alignment_s", "s"), OffOr(1.0, 86_400.0), ("alignment_s", "s", 1.0), ""),
        "Tilt is found from the mean specific force, heading from the mean rate: white noise and quantization are averaged over this \
            time, and Gauss-Markov, flicker, random walk and ramp errors have their mean of this time. Dead zone and range act on the \
            mean. The temperature is that of the first sample. The flight begins with the states with which the alignment ended: ramps \
            and random walks begin at 0 when the alignment begins. An alignment without end leaves out white noise and quantization, \
            and takes the errors at the first sample for their mean. A reposition aligns again, from the present states of the sensors. \
            SINS_ALIGNMENT_GIVEN does not use it."),
];
