//! The effects of a budget: one line each.

use super::ErrorParameters;

/// An effect that can be set, and left out, by itself.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    /// What it is called.
    pub name: &'static str,
    /// The field of the interface that sets it; 0 there leaves it out.
    pub field: &'static str,
    /// Whether it is drawn anew each run.
    pub is_random: bool,
    is_set: fn(&ErrorParameters) -> bool,
    copy: fn(&ErrorParameters, &mut ErrorParameters),
}

const DETERMINISTIC: bool = false;
const RANDOM: bool = true;

/// Name, field, kind: where it is set, then what else belongs to it.
macro_rules! effects {
    ($($name:literal, $field:literal, $kind:ident: $($path:ident).+ $(, $($too:ident).+)*;)*) => {
        &[$(Effect {
            name: $name,
            field: $field,
            is_random: $kind,
            is_set: |from| from.$($path).+ != ErrorParameters::default().$($path).+,
            copy: |from, to| {
                to.$($path).+ = from.$($path).+;
                $(to.$($too).+ = from.$($too).+;)*
            },
        }),*]
    };
}

/// All of them, along the path of the signal.
pub static EFFECTS: &[Effect] = effects! {
    "deflection north", "gravity.deflection_north_rad", DETERMINISTIC: gravity.deflection_north.mean;
    "random deflection north", "gravity.deflection_north_sigma_rad", RANDOM: gravity.deflection_north.sigma, gravity.deflection_north.distance_m;
    "deflection east", "gravity.deflection_east_rad", DETERMINISTIC: gravity.deflection_east.mean;
    "random deflection east", "gravity.deflection_east_sigma_rad", RANDOM: gravity.deflection_east.sigma, gravity.deflection_east.distance_m;
    "gravity anomaly", "gravity.anomaly_m_s2", DETERMINISTIC: gravity.anomaly.mean;
    "random gravity anomaly", "gravity.anomaly_sigma_m_s2", RANDOM: gravity.anomaly.sigma, gravity.anomaly.distance_m;
    "gyro bandwidth", "gyro.bandwidth_hz", DETERMINISTIC: gyro.bandwidth_hz;
    "gyro scale factor", "gyro.scale_factor", DETERMINISTIC: gyro.scale_factor;
    "gyro misalignment", "gyro.misalignment_rad", DETERMINISTIC: gyro.misalignment;
    "gyro drawn scale factor", "gyro.scale_factor_sigma", RANDOM: gyro.scale_factor_sigma;
    "gyro drawn misalignment", "gyro.misalignment_sigma_rad", RANDOM: gyro.misalignment_sigma;
    "gyro asymmetry", "gyro.scale_factor_asymmetry", DETERMINISTIC: gyro.scale_factor_asymmetry;
    "gyro nonlinearity", "gyro.scale_factor_nonlinearity_s_rad", DETERMINISTIC: gyro.scale_factor_nonlinearity;
    "gyro g-sensitivity", "gyro.g_sensitivity_rad_s_per_m_s2", DETERMINISTIC: gyro.g_sensitivity;
    "gyro bias/temperature", "gyro.bias_temperature_rad_s_per_k", DETERMINISTIC: gyro.bias_temperature;
    "gyro bias/temperature squared", "gyro.bias_temperature2_rad_s_per_k2", DETERMINISTIC: gyro.bias_temperature2;
    "gyro scale/temperature", "gyro.scale_factor_temperature_per_k", DETERMINISTIC: gyro.scale_factor_temperature;
    "gyro scale/temperature squared", "gyro.scale_factor_temperature2_per_k2", DETERMINISTIC: gyro.scale_factor_temperature2;
    "gyro bias", "gyro.bias_rad_s", DETERMINISTIC: gyro.bias;
    "gyro turn-on bias", "gyro.bias_sigma_rad_s", RANDOM: gyro.bias_sigma;
    "gyro Gauss-Markov bias", "gyro.markov_sigma_rad_s", RANDOM: gyro.markov_sigma, gyro.markov_time_s;
    "gyro flicker", "gyro.flicker_rad_s", RANDOM: gyro.flicker;
    "gyro rate random walk", "gyro.rate_random_walk_rad_s_sqrt_s", RANDOM: gyro.rate_random_walk;
    "gyro ramp", "gyro.rate_ramp_rad_s2", DETERMINISTIC: gyro.ramp;
    "gyro angle random walk", "gyro.random_walk_rad_sqrt_s", RANDOM: gyro.random_walk;
    "gyro dead zone", "gyro.dead_zone_rad_s", DETERMINISTIC: gyro.dead_zone;
    "gyro range", "gyro.range_rad_s", DETERMINISTIC: gyro.range;
    "gyro quantization", "gyro.quantization_rad", DETERMINISTIC: gyro.quantization;
    "accel lever arms", "accel.lever_arm_m", DETERMINISTIC: accel.lever_arm_m;
    "accel bandwidth", "accel.bandwidth_hz", DETERMINISTIC: accel.bandwidth_hz;
    "accel scale factor", "accel.scale_factor", DETERMINISTIC: accel.scale_factor;
    "accel misalignment", "accel.misalignment_rad", DETERMINISTIC: accel.misalignment;
    "accel drawn scale factor", "accel.scale_factor_sigma", RANDOM: accel.scale_factor_sigma;
    "accel drawn misalignment", "accel.misalignment_sigma_rad", RANDOM: accel.misalignment_sigma;
    "accel asymmetry", "accel.scale_factor_asymmetry", DETERMINISTIC: accel.scale_factor_asymmetry;
    "accel nonlinearity", "accel.scale_factor_nonlinearity_s2_m", DETERMINISTIC: accel.scale_factor_nonlinearity;
    "accel vibration rectification", "accel.vibration_rectification_s2_m", DETERMINISTIC: accel.vibration_rectification_s2_m;
    "accel bias/temperature", "accel.bias_temperature_m_s2_per_k", DETERMINISTIC: accel.bias_temperature;
    "accel bias/temperature squared", "accel.bias_temperature2_m_s2_per_k2", DETERMINISTIC: accel.bias_temperature2;
    "accel scale/temperature", "accel.scale_factor_temperature_per_k", DETERMINISTIC: accel.scale_factor_temperature;
    "accel scale/temperature squared", "accel.scale_factor_temperature2_per_k2", DETERMINISTIC: accel.scale_factor_temperature2;
    "accel bias", "accel.bias_m_s2", DETERMINISTIC: accel.bias;
    "accel turn-on bias", "accel.bias_sigma_m_s2", RANDOM: accel.bias_sigma;
    "accel Gauss-Markov bias", "accel.markov_sigma_m_s2", RANDOM: accel.markov_sigma, accel.markov_time_s;
    "accel flicker", "accel.flicker_m_s2", RANDOM: accel.flicker;
    "acceleration random walk", "accel.acceleration_random_walk_m_s2_sqrt_s", RANDOM: accel.rate_random_walk;
    "accel ramp", "accel.ramp_m_s3", DETERMINISTIC: accel.ramp;
    "accel velocity random walk", "accel.velocity_random_walk_m_s_sqrt_s", RANDOM: accel.random_walk;
    "accel dead zone", "accel.dead_zone_m_s2", DETERMINISTIC: accel.dead_zone;
    "accel range", "accel.range_m_s2", DETERMINISTIC: accel.range;
    "accel quantization", "accel.quantization_m_s", DETERMINISTIC: accel.quantization;
    "altimeter lag", "altimeter.lag_s", DETERMINISTIC: altimeter.lag_s;
    "altimeter scale factor", "altimeter.scale_factor", DETERMINISTIC: altimeter.scale_factor;
    "altimeter bias", "altimeter.bias_m", DETERMINISTIC: altimeter.bias_m;
    "altimeter Gauss-Markov", "altimeter.markov_sigma_m", RANDOM: altimeter.markov_sigma_m, altimeter.markov_time_s;
    "altimeter noise", "altimeter.noise_m", RANDOM: altimeter.noise_m;
    "initial position", "initial.position_enu_m", DETERMINISTIC: initial.position_n;
    "initial velocity", "initial.velocity_enu_m_s", DETERMINISTIC: initial.velocity_n;
    "initial misalignment", "initial.misalignment_enu_rad", DETERMINISTIC: initial.misalignment_n;
    "drawn initial position", "initial.position_sigma_enu_m", RANDOM: initial.position_sigma_n;
    "drawn initial velocity", "initial.velocity_sigma_enu_m_s", RANDOM: initial.velocity_sigma_n;
    "drawn initial misalignment", "initial.misalignment_sigma_enu_rad", RANDOM: initial.misalignment_sigma_n;
    "believed lever arm", "mounting.lever_arm_error_m", DETERMINISTIC: mounting.lever_arm_error_m;
    "believed boresight", "mounting.boresight_error_rad", DETERMINISTIC: mounting.boresight_error;
};

impl Effect {
    /// Those that `parameters` set, in order.
    pub fn set_in(parameters: &ErrorParameters) -> impl Iterator<Item = &'static Self> {
        EFFECTS.iter().filter(|effect| (effect.is_set)(parameters))
    }

    /// `parameters` with nothing but this effect.
    pub(super) fn alone(&self, parameters: &ErrorParameters) -> ErrorParameters {
        let mut alone = parameters.ideal();
        (self.copy)(parameters, &mut alone);
        alone
    }

    /// Takes this effect out of `parameters`.
    pub(super) fn leave_out(&self, parameters: &mut ErrorParameters) {
        (self.copy)(&ErrorParameters::default(), parameters);
    }
}

impl PartialEq for Effect {
    fn eq(&self, other: &Self) -> bool {
        self.field == other.field
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::math::Euler;
    use crate::mounting::MountingParameters;
    use crate::sensors::{
        Alignment, AltimeterParameters, GravityDisturbanceParameters, GravityField, InitialErrorParameters,
        TriadParameters,
    };

    /// Every field, spelled out: a new one does not compile until it stands here, and fails until it has its line.
    fn everything() -> ErrorParameters {
        let (ones, matrix) = (Vector3::repeat(1.0), Matrix3::repeat(1.0));
        let angles = Euler { roll: 1.0, pitch: 1.0, heading: 1.0 };
        let field = GravityField { mean: 1.0, sigma: 1.0, distance_m: 1.0 };
        let triad = TriadParameters {
            bias: ones,
            bias_sigma: ones,
            markov_sigma: ones,
            markov_time_s: ones,
            random_walk: ones,
            rate_random_walk: ones,
            ramp: ones,
            flicker: ones,
            quantization: ones,
            scale_factor: ones,
            scale_factor_asymmetry: ones,
            scale_factor_nonlinearity: ones,
            misalignment: matrix,
            g_sensitivity: matrix,
            range: ones,
            bandwidth_hz: ones,
            dead_zone: ones,
            lever_arm_m: matrix,
            vibration_rectification_s2_m: ones,
            reference_temperature_c: 20.0,
            bias_temperature: ones,
            bias_temperature2: ones,
            scale_factor_temperature: ones,
            scale_factor_temperature2: ones,
            scale_factor_sigma: ones,
            misalignment_sigma: matrix,
        };
        let nothing = TriadParameters::default();
        let of_gyros = TriadParameters {
            lever_arm_m: nothing.lever_arm_m,
            vibration_rectification_s2_m: nothing.vibration_rectification_s2_m,
            ..triad
        };
        let of_accelerometers = TriadParameters { g_sensitivity: nothing.g_sensitivity, ..triad };
        ErrorParameters {
            gyro: of_gyros,
            accel: of_accelerometers,
            altimeter: AltimeterParameters {
                bias_m: 1.0,
                markov_sigma_m: 1.0,
                markov_time_s: 1.0,
                noise_m: 1.0,
                scale_factor: 1.0,
                lag_s: 1.0,
            },
            initial: InitialErrorParameters {
                position_n: ones,
                velocity_n: ones,
                misalignment_n: ones,
                position_sigma_n: ones,
                velocity_sigma_n: ones,
                misalignment_sigma_n: ones,
                alignment: Alignment::LevelAndGyrocompass,
            },
            mounting: MountingParameters {
                lever_arm_m: ones,
                boresight: angles,
                lever_arm_error_m: ones,
                boresight_error: angles,
            },
            gravity: GravityDisturbanceParameters {
                deflection_north: field,
                deflection_east: field,
                anomaly: field,
            },
        }
    }

    #[test]
    fn every_field_belongs_to_one_effect() {
        let all = everything();
        assert_eq!(Effect::set_in(&all).count(), EFFECTS.len());
        assert_eq!(Effect::set_in(&all.ideal()).count(), 0);
        let (mut together, mut left) = (all.ideal(), all);
        for effect in EFFECTS {
            let set: Vec<&Effect> = Effect::set_in(&effect.alone(&all)).collect();
            assert_eq!(set, [effect]);
            (effect.copy)(&all, &mut together);
            effect.leave_out(&mut left);
        }
        assert_eq!(together, all);
        assert_eq!(left, all.ideal());
    }

    #[test]
    fn names_and_fields_are_distinct_and_fit_the_interface() {
        for (index, effect) in EFFECTS.iter().enumerate() {
            // char effect[32], field[48] with a terminator.
            assert!(effect.name.len() < 32 && effect.field.len() < 48, "{}", effect.name);
            for other in &EFFECTS[..index] {
                assert!(effect.name != other.name && effect.field != other.field, "{}", effect.name);
            }
        }
    }

    /// A correlation time or distance without a standard deviation is no effect, nor is a mounting that is believed.
    #[test]
    fn what_is_off_is_no_effect() {
        let mut parameters = ErrorParameters::default();
        parameters.gyro.markov_time_s.x = 100.0;
        parameters.accel.bias.y = -0.0;
        parameters.gravity.anomaly.distance_m = 1e4;
        parameters.mounting.lever_arm_m.x = 5.0;
        parameters.mounting.boresight.heading = 1.0;
        assert_eq!(Effect::set_in(&parameters).count(), 0);
    }
}
