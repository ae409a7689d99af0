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
        let at_block = LocalGeometry::new(&self.earth, &self.earth.vertical(&state.r_e));
        let StartErrors { position_n, velocity_n, misalignment_n } =
            self.in_local_terms(&at_block, &state.v_e);
        let lean_e = at_block.in_earth_axes(&at_block.rotation_of_axes(&position_n));
        let psi_e = at_block.in_earth_axes(&misalignment_n) - lean_e;

        let from_body = |v_b: &Vector3<f64>| truth.to_earth * v_b;
        let displacement_e = psi_e.cross(&from_body(&mounting.arm_b)) + from_body(&mounting.position_b);
        let position_e = at_block.in_earth_axes(&position_n) + displacement_e;
        let velocity_e = at_block.in_earth_axes(&velocity_n)
            + lean_e.cross(&state.v_e)
            + psi_e.cross(&from_body(&mounting.arm_rate_b))
            + from_body(&mounting.velocity_b)
            - Vector3::new(0.0, 0.0, self.earth.rate_rad_s).cross(&displacement_e);
        let psi_e = psi_e + from_body(&mounting.misalignment_b);

        let at_point = LocalGeometry::new(&self.earth, &truth.vertical());
        let position_n = at_point.in_local_axes(&position_e);
        let lean_n = at_point.rotation_of_axes(&position_n);
        let v_n = at_point.in_local_axes(&truth.state.v_e);
        StartErrors {
            position_n,
            velocity_n: at_point.in_local_axes(&velocity_e) - lean_n.cross(&v_n),
            misalignment_n: at_point.in_local_axes(&psi_e) + lean_n,
        }
    }
}
