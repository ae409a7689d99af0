//! Errors of the reference point, from those of a sensor block that is mounted off it.

use nalgebra::Vector3;

use super::geometry::LocalGeometry;
use super::{ErrorModel, StartErrors};
use crate::mounting::Block;
use crate::truth::TruthPoint;

impl ErrorModel {
    /// With the believed arm l~ and its velocity u~ against inertial axes, and what the mounting has wrong by itself (`_m`),
    /// ```text
    /// δr = δr_s + ψ×l~ + δr_m
    /// δv = δv_s + ψ×u~ + δv_m - W×(δr - δr_s)
    /// ψ  = ψ_s + ψ_m
    /// ```
    /// in Earth-fixed terms: the local axes that belong to a solution lean with its position.
    pub(super) fn of_reference_point(&self, truth: &TruthPoint, block: &Block) -> StartErrors {
        let mounting = block.errors();
        let state = block.state(truth);
        let local = LocalGeometry::new(&self.earth, &self.earth.vertical(&state.r_e));
        let from_body = |v_b: &Vector3<f64>| local.in_local_axes(&(truth.to_earth * v_b));

        let at_block = self.in_local_terms(&local, &state.v_e);
        let axes = local.rotation_of_axes(&at_block.position_n);
        let psi = at_block.misalignment_n - axes;
        let earth_rate = Vector3::new(0.0, local.cos, local.sin) * self.earth.rate_rad_s;
        let displacement = psi.cross(&from_body(&mounting.arm_b)) + from_body(&mounting.position_b);
        let velocity = at_block.velocity_n
            + axes.cross(&local.in_local_axes(&state.v_e))
            + psi.cross(&from_body(&mounting.arm_rate_b))
            + from_body(&mounting.velocity_b)
            - earth_rate.cross(&displacement);

        let position_n = at_block.position_n + displacement;
        let axes = local.rotation_of_axes(&position_n);
        StartErrors {
            position_n,
            velocity_n: velocity - axes.cross(&local.in_local_axes(&truth.state.v_e)),
            misalignment_n: psi + from_body(&mounting.misalignment_b) + axes,
        }
    }
}
