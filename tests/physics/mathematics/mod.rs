//! The mathematics of every block: rotations, transcendental functions, compensated sums, stencils and quadrature, against
//! closed forms, published tables and the library `libm`.

mod functions;
mod rotations;
mod sums;
