//! What a mounted sensor block changes between the INS, which navigates the block, and the reference point.

use nalgebra::Vector3;

use super::Options;
use crate::earth::Earth;
use crate::mechanization::{VerticalAid, VerticalState};
use crate::mounting::{Block, MountingParameters};
use crate::signal::SignalGenerator;
use crate::state::EarthFixedState;
use crate::truth::{Recent, TruthPoint};

/// The block at `first`: its rate is the host's, else that of the first interval, else the Earth's.
pub(super) fn block_at_start(
    parameters: &MountingParameters,
    options: &Options,
    earth: &Earth,
    first: &TruthPoint,
    interval: Option<&Recent<'_>>,
) -> Block {
    let rate_b = match (first.sample.omega_ib_b, interval) {
        (Some(rate_b), _) => rate_b,
        (None, Some(recent)) => SignalGenerator::new(earth.rate_rad_s).advance(recent).angular_rate(0.0),
        (None, None) => first.to_earth.tr_mul(&Vector3::new(0.0, 0.0, earth.rate_rad_s)),
    };
    Block::new(parameters, options.axes, earth.rate_rad_s, rate_b)
}

/// `aid`, which is about the reference point, for the navigator of the block: it has the solution `block`, and with that
/// `reference_point`.
pub(super) fn aid_of_block(
    earth: &Earth,
    aid: &VerticalAid,
    block: &EarthFixedState,
    reference_point: &EarthFixedState,
) -> VerticalAid {
    if *aid == VerticalAid::None {
        return *aid;
    }
    aid.moved(&VerticalState::of(earth, reference_point), &VerticalState::of(earth, block))
}
