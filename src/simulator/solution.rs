//! A solution of a simulator at an instant.

use super::Options;
use crate::earth::Earth;
use crate::earth::state::{NEAR_POLE_M, Navigation};
use crate::truth::TruthPoint;

/// Latitude [rad] up to which no solution is near a pole. At the lowest possible height, -500 km, the axis is 63 km away.
const FAR_FROM_POLE_RAD: f64 = 1.56;

/// A solution and its flags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Time [s].
    pub time_s: f64,
    /// Position, velocity, attitude.
    pub navigation: Navigation,
    /// Within 20 km of the Earth's axis: longitude and heading turn fast, at the pole they are undefined.
    pub near_pole: bool,
    /// Nothing aids the vertical channel; its error grows e-fold every 569 s.
    pub vertical_unaided: bool,
    /// The alignment at the start could not find north, and no unit has found it since: the heading may be anything.
    pub north_unknown: bool,
    /// The displacement of the truth since the previous sample contradicts its velocities.
    pub inconsistent: bool,
}

impl Solution {
    #[inline(always)]
    pub(super) fn new(earth: &Earth, time_s: f64, navigation: Navigation) -> Self {
        let near_pole = is_near_pole(earth, &navigation);
        Self {
            time_s,
            navigation,
            near_pole,
            vertical_unaided: false,
            north_unknown: false,
            inconsistent: false,
        }
    }

    /// The truth at `point`.
    pub(crate) fn of_truth(options: &Options, earth: &Earth, point: &TruthPoint) -> Self {
        Self::new(earth, point.time_s, point.navigation(earth, options.axes))
    }
}

/// Whether longitude and heading have lost their meaning.
#[inline]
fn is_near_pole(earth: &Earth, navigation: &Navigation) -> bool {
    navigation.place.latitude_rad.abs() > FAR_FROM_POLE_RAD
        && earth.distance_from_axis(navigation.place) < NEAR_POLE_M
}
