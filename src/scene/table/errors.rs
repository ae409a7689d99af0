//! What stands beside the gyros and accelerometers: `[altimeter]`, `[start]`, `[mounting]`, `[gravity]`.

use super::super::key::{Key, Section, Target};
use super::choice;
use super::sensors::of_rows;
use crate::sensors::{self, Alignment, INITIAL};
use crate::signal::mounting;

const S: Section = Section::Start;

pub const ALTIMETER: &[Key] = &of_rows(Section::Altimeter, &sensors::ALTIMETER);
pub const MOUNTING: &[Key] = &of_rows(Section::Mounting, &mounting::MOUNTING);
pub const GRAVITY: &[Key] = &of_rows(Section::Gravity, &sensors::GRAVITY);

pub const START: &[Key] = &{
    let [errors @ .., _, _] = of_rows(S, &INITIAL);
    errors
};

pub const ALIGNMENT: &[Key] = &[
    choice!(S, "alignment", "alignment: given attitude, levelling and gyrocompassing, or levelling with the true heading",
        "initial.alignment" => scene.errors.initial.alignment, Alignment::WORDS),
    of_rows(S, &INITIAL)[7],
];
