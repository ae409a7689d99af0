//! Units of data sheets and of navigation in SI, as the header has them: multiply by them to get SI.

/// Degree [rad].
pub const DEG: f64 = core::f64::consts::PI / 180.0;
/// Minute of arc [rad].
pub const ARCMIN: f64 = DEG / 60.0;
/// Second of arc [rad].
pub const ARCSEC: f64 = DEG / 3600.0;
/// Degree an hour [rad/s].
pub const DEG_PER_HOUR: f64 = DEG / 3600.0;
/// Degree a root hour, angle random walk [rad/√s].
pub const DEG_PER_SQRT_HOUR: f64 = DEG / 60.0;
/// Standard gravity [m/s²].
pub const STANDARD_GRAVITY: f64 = 9.80665;
/// Millionth of g [m/s²].
pub const MICRO_G: f64 = STANDARD_GRAVITY * 1e-6;
/// Part in a million.
pub const PPM: f64 = 1e-6;
/// Milligal [m/s²].
pub const MILLIGAL: f64 = 1e-5;
/// Nautical mile an hour [m/s].
pub const NMI_PER_HOUR: f64 = 1852.0 / 3600.0;

/// Temperatures that a host may give [°C]: from the absolute zero to beyond any electronics.
pub const TEMPERATURE_RANGE_C: (f64, f64) = (-273.15, 1000.0);
