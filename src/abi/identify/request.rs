//! What a host asks for.

use nalgebra::Matrix3;

use super::{
    SINS_IDENTIFY_ASYMMETRY, SINS_IDENTIFY_G_SENSITIVITY, SINS_IDENTIFY_LEVER_ARM, SINS_IDENTIFY_SHIFT,
    SINS_IDENTIFY_STATES, SINS_IDENTIFY_TEMPERATURE, sins_identify_flags, sins_identify_request,
};
use crate::abi::choice::Choice;
use crate::abi::failure::CallError;
use crate::analysis::identify::{Also, Prior, Request};
use crate::base::error::{Error, Rule, check_integer};
use crate::sensors::Grade;

const ALL_FLAGS: sins_identify_flags = SINS_IDENTIFY_SHIFT
    | SINS_IDENTIFY_STATES
    | SINS_IDENTIFY_LEVER_ARM
    | SINS_IDENTIFY_G_SENSITIVITY
    | SINS_IDENTIFY_ASYMMETRY
    | SINS_IDENTIFY_TEMPERATURE;

impl sins_identify_request {
    pub(super) fn to_request(self) -> Result<Request, CallError> {
        check_integer("request.flags", self.flags as usize, 0, u64::from(ALL_FLAGS))?;
        let prior = match self.prior {
            0 => Prior::default(),
            grade => Prior::of(Grade::of("request.prior", grade)?),
        };
        let shift_s = (self.flags & SINS_IDENTIFY_SHIFT != 0).then_some(self.shift_s);
        let cutoff_hz = Some(self.cutoff_hz).filter(|cutoff_hz| *cutoff_hz != 0.0);
        let has = |flag: sins_identify_flags| self.flags & flag != 0;
        let also = Also {
            lever_arm: has(SINS_IDENTIFY_LEVER_ARM),
            g_sensitivity: has(SINS_IDENTIFY_G_SENSITIVITY),
            asymmetry: has(SINS_IDENTIFY_ASYMMETRY),
            temperature: has(SINS_IDENTIFY_TEMPERATURE),
        };
        Ok(Request { prior, axes: exchange(self.axes)?, shift_s, cutoff_hz, also })
    }
}

/// The exchange of axes of the host's numbers; `None` if all are 0.
fn exchange(axes: [i32; 3]) -> Result<Option<Matrix3<f64>>, CallError> {
    if axes == [0; 3] {
        return Ok(None);
    }
    let mut exchange = Matrix3::zeros();
    for (row, axis) in axes.into_iter().enumerate() {
        match axis.unsigned_abs() {
            column @ 1..=3 => exchange[(row, column as usize - 1)] = f64::from(axis.signum()),
            _ => {
                let rule = Rule::Sentence("must be 1, 2 or 3 for x, y or z, negative if reversed");
                return Err(Error::invalid("request.axes", axis, rule).at(row).into());
            }
        }
    }
    Ok(Some(exchange))
}
