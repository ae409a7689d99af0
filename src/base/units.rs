//! Units of data sheets and of navigation in SI, as in the header. A value times its unit is the value in SI.

/// Degree [rad].
pub const DEG: f64 = core::f64::consts::PI / 180.0;
/// Minute of arc [rad].
pub const ARCMIN: f64 = DEG / 60.0;
/// Second of arc [rad].
pub const ARCSEC: f64 = DEG / 3600.0;
/// Degree per hour [rad/s].
pub const DEG_PER_HOUR: f64 = DEG / 3600.0;
/// Degree per square root of an hour, for angle random walk [rad/√s].
pub const DEG_PER_SQRT_HOUR: f64 = DEG / 60.0;
/// Standard gravity [m/s²].
pub const STANDARD_GRAVITY: f64 = 9.80665;
/// One millionth of standard gravity [m/s²].
pub const MICRO_G: f64 = STANDARD_GRAVITY * 1e-6;
/// Part per million [1].
pub const PPM: f64 = 1e-6;
/// Milligal [m/s²].
pub const MILLIGAL: f64 = 1e-5;
/// Nautical mile per hour [m/s].
pub const NMI_PER_HOUR: f64 = 1852.0 / 3600.0;

/// Range of the temperatures that a host may set [°C]: from absolute zero to more than any electronics can have.
pub const TEMPERATURE_RANGE_C: (f64, f64) = (-273.15, 1000.0);
