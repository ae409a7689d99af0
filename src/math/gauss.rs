//! Quadrature.

/// Nodes of Gauss-Legendre quadrature on 0..1, each of weight 1/2.
pub const GAUSS_2: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];
