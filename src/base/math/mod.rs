//! The mathematics that every block uses: rotations, compensated sums, derivative stencils, and the only place
//! where transcendental functions are called.

mod arc_tangent;
mod compensated;
mod euler;
mod gauss;
mod mix;
mod pair;
mod quantile;
mod rotation;
mod sine;
mod stencil;
mod transcendental;

pub use arc_tangent::atan2_of_two;
pub use compensated::{Compensated, two_product, two_sum};
pub use euler::{Euler, attitude_from_euler, attitude_from_half_angles, euler_from_attitude};
pub use gauss::{GAUSS_2, GAUSS_3, GAUSS_4, GAUSS_5};
pub use mix::{SPLIT_MIX_STEP, mix};
pub use pair::{Pair, VectorPair};
pub use quantile::wilson_hilferty;
pub use rotation::{
    AxisTurn, RotationSeries, axis_cross, inverse_right_jacobian, quarter_square, relative_rotation,
    right_jacobian, rotate, rotate_inverse, rotated_z, rotation_increment, rotation_increment_by,
    rotation_matrix, rotation_quaternion, rotation_vector,
};
pub use sine::{nearest_integer, sin_cos_each, sin_cos_each_inlined};
pub use stencil::end_derivative_weights;
pub use transcendental::{asin, atan, atan2, exp, exp_m1, hypot, ln, sin_cos, tan, tanh, wrap_angle};
