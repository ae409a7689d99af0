//! The table of the mounting: each parameter is listed here once.
//!
//! `build.rs` makes from it the struct of the interface with the header, that of the crate, and the numbers of both. Checks, keys of
//! scene files and rows of an error budget read it.

use crate::base::parameter::Range::Within;
use crate::base::parameter::Shape::{Angles, Vector};
use crate::base::parameter::{GIVEN, Range, Row, own_field as field, row};
use crate::base::units::{ARCSEC, DEG};

const PI: f64 = core::f64::consts::PI;
const ARM: Range = Within(-100.0, 100.0);

/// Mounting of the sensor block, in the order of the struct of the interface.
#[rustfmt::skip]
pub const MOUNTING: [Row; 4] = [
    row("lever_arm_m", Vector, GIVEN, "lever arm from the reference point to the block, body axes",
        field(("mounting.lever_arm_m", "m"), ARM, ("lever_arm_m", "m", 1.0), ""), "sins_options.axes describes the body axes."),
    // The range is that of the attitude of a flight sample.
    row("boresight", Angles, GIVEN, "roll, pitch, heading of the block",
        field(("mounting.boresight_rad", "rad"), Within(-1e4, 1e4), ("boresight_deg", "deg", DEG), ""),
        "This is the boresight: the angles of the block's axes relative to the body axes. They are defined like the attitude angles of \
            the body: positive roll right side down, positive pitch nose up, positive heading nose to the right. Whole turns do not \
            matter."),
    row("lever_arm_error_m", Vector, GIVEN, "believed less true lever arm",
        field(("mounting.lever_arm_error_m", "m"), ARM, ("lever_arm_error_mm", "mm", 1e-3), "lever arm error"), ""),
    row("boresight_error", Angles, GIVEN, "believed less true roll, pitch, heading",
        field(("mounting.boresight_error_rad", "rad"), Within(-PI, PI), ("boresight_error_arcsec", "arcsec", ARCSEC), "boresight error"),
        "If the believed heading is too large, the heading that the INS reports is too small by the same amount."),
];
