//! What stands beside the gyros and accelerometers: `[altimeter]`, `[start]`, `[mounting]`, `[gravity]`.

use super::super::key::{Key, Place, Section, Shape, Target, one, vector};
use super::sensors::of_rows;
use super::{choice, number, si, unit};
use crate::sensors::Alignment;
use crate::surroundings;
use crate::units::ARCMIN;

const S: Section = Section::Start;

pub const ALTIMETER: &[Key] = &of_rows(Section::Altimeter, &surroundings::ALTIMETER);
pub const MOUNTING: &[Key] = &of_rows(Section::Mounting, &surroundings::MOUNTING);
pub const GRAVITY: &[Key] = &of_rows(Section::Gravity, &surroundings::GRAVITY);

pub const START: &[Key] = &[
    super::sensors::START,
    number!(S, Shape::Vector, "position_m", si("m"), "position east, north, up",
        "initial.position_enu_m" => vector(scene.errors.initial.position_n)),
    number!(S, Shape::Vector, "velocity_m_s", si("m/s"), "velocity east, north, up",
        "initial.velocity_enu_m_s" => vector(scene.errors.initial.velocity_n)),
    number!(S, Shape::Vector, "misalignment_arcmin", unit("arcmin", ARCMIN, "rad"), "misalignment about east, north, up",
        "initial.misalignment_enu_rad" => vector(scene.errors.initial.misalignment_n)),
    number!(S, Shape::Axes, "position_sigma_m", si("m"), "standard deviation of the position",
        "initial.position_sigma_enu_m" => vector(scene.errors.initial.position_sigma_n)),
    number!(S, Shape::Axes, "velocity_sigma_m_s", si("m/s"), "standard deviation of the velocity",
        "initial.velocity_sigma_enu_m_s" => vector(scene.errors.initial.velocity_sigma_n)),
    number!(S, Shape::Axes, "misalignment_sigma_arcmin", unit("arcmin", ARCMIN, "rad"), "standard deviation of the misalignment",
        "initial.misalignment_sigma_enu_rad" => vector(scene.errors.initial.misalignment_sigma_n)),
    choice!(S, "alignment", "alignment: given attitude, levelling and gyrocompassing, or levelling with the true heading",
        "initial.alignment" => scene.errors.initial.alignment, Alignment::WORDS),
    number!(S, Shape::Number, "alignment_s", si("s"), "length of the alignment, at rest before the first sample; 0: without end",
        "initial.alignment_s" => one(scene.errors.initial.alignment_s)),
];
