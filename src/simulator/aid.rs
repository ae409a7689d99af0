//! The aid of the vertical channel: from the truth to the navigator.

use crate::earth::Earth;
use crate::mechanization::{Mechanization, VerticalAid, VerticalMode, VerticalState};
use crate::signal::mounting::Belief;
use crate::truth::TruthPoint;

/// Aid of the vertical channel at the sample `next`. `sense` gives the indicated height for the true height, if there is an
/// indication.
pub(super) fn vertical_aid(
    mode: VerticalMode,
    next: &TruthPoint,
    sense: impl FnOnce(f64) -> Option<f64>,
) -> VerticalAid {
    let height_m = next.height_m();
    match mode {
        VerticalMode::Free => VerticalAid::None,
        VerticalMode::Damped => {
            sense(height_m).map_or(VerticalAid::None, |height_m| VerticalAid::Barometer { height_m })
        }
        VerticalMode::FollowTruth => VerticalAid::Truth { height_m, velocity_up_m_s: next.velocity_up_m_s() },
    }
}

/// Aids the vertical channel of a navigator with `aid` over `t` [s]. The aid is for the reference point; a navigator with a
/// `belief` navigates the block.
pub(super) fn aid_vertical(
    navigator: &mut Mechanization,
    earth: &Earth,
    aid: &VerticalAid,
    t: f64,
    belief: Option<Belief>,
) {
    let (Some(belief), false) = (belief, *aid == VerticalAid::None) else {
        return navigator.aid_vertical(aid, t);
    };
    let block = navigator.state();
    let reference_point = VerticalState::of(earth, &belief.reference_point(&block));
    navigator.aid_vertical(&aid.moved(&reference_point, &VerticalState::of(earth, &block)), t);
}
