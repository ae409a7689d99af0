//! Each field of a triad.

use sins::sensors::TriadParameters;
use sins::truth::FlightSample;
use sins::{ErrorKind, Simulator};

use super::SUBNORMAL;
use super::support::{options_at, resting_sample};

type Set = fn(&mut TriadParameters) -> &mut [f64];

/// Each field of a triad: its name with gyros and with accelerometers, and whether it may be negative.
const FIELDS: [(Set, &str, &str, bool); 26] = [
    (|p| p.bias.as_mut_slice(), "bias_rad_s", "bias_m_s2", true),
    (|p| p.bias_sigma.as_mut_slice(), "bias_sigma_rad_s", "bias_sigma_m_s2", false),
    (|p| p.markov_sigma.as_mut_slice(), "markov_sigma_rad_s", "markov_sigma_m_s2", false),
    (|p| p.markov_time_s.as_mut_slice(), "markov_time_s", "markov_time_s", false),
    (|p| p.random_walk.as_mut_slice(), "random_walk_rad_sqrt_s", "velocity_random_walk_m_s_sqrt_s", false),
    (
        |p| p.rate_random_walk.as_mut_slice(),
        "rate_random_walk_rad_s_sqrt_s",
        "acceleration_random_walk_m_s2_sqrt_s",
        false,
    ),
    (|p| p.ramp.as_mut_slice(), "rate_ramp_rad_s2", "ramp_m_s3", true),
    (|p| p.flicker.as_mut_slice(), "flicker_rad_s", "flicker_m_s2", false),
    (|p| p.quantization.as_mut_slice(), "quantization_rad", "quantization_m_s", false),
    (|p| p.scale_factor.as_mut_slice(), "scale_factor", "scale_factor", true),
    (|p| p.scale_factor_asymmetry.as_mut_slice(), "scale_factor_asymmetry", "scale_factor_asymmetry", true),
    (
        |p| p.scale_factor_nonlinearity.as_mut_slice(),
        "scale_factor_nonlinearity_s_rad",
        "scale_factor_nonlinearity_s2_m",
        true,
    ),
    (|p| p.misalignment.as_mut_slice(), "misalignment_rad", "misalignment_rad", true),
    (
        |p| p.g_sensitivity.as_mut_slice(),
        "g_sensitivity_rad_s_per_m_s2",
        "g_sensitivity_rad_s_per_m_s2",
        true,
    ),
    (|p| p.range.as_mut_slice(), "range_rad_s", "range_m_s2", false),
    (|p| p.bandwidth_hz.as_mut_slice(), "bandwidth_hz", "bandwidth_hz", false),
    (|p| p.dead_zone.as_mut_slice(), "dead_zone_rad_s", "dead_zone_m_s2", false),
    (|p| p.lever_arm_m.as_mut_slice(), "lever_arm_m", "lever_arm_m", true),
    (
        |p| p.vibration_rectification_s2_m.as_mut_slice(),
        "vibration_rectification_s2_m",
        "vibration_rectification_s2_m",
        true,
    ),
    (
        |p| std::slice::from_mut(&mut p.reference_temperature_c),
        "reference_temperature_c",
        "reference_temperature_c",
        true,
    ),
    (
        |p| p.bias_temperature.as_mut_slice(),
        "bias_temperature_rad_s_per_k",
        "bias_temperature_m_s2_per_k",
        true,
    ),
    (
        |p| p.bias_temperature2.as_mut_slice(),
        "bias_temperature2_rad_s_per_k2",
        "bias_temperature2_m_s2_per_k2",
        true,
    ),
    (
        |p| p.scale_factor_temperature.as_mut_slice(),
        "scale_factor_temperature_per_k",
        "scale_factor_temperature_per_k",
        true,
    ),
    (
        |p| p.scale_factor_temperature2.as_mut_slice(),
        "scale_factor_temperature2_per_k2",
        "scale_factor_temperature2_per_k2",
        true,
    ),
    (|p| p.scale_factor_sigma.as_mut_slice(), "scale_factor_sigma", "scale_factor_sigma", false),
    (|p| p.misalignment_sigma.as_mut_slice(), "misalignment_sigma_rad", "misalignment_sigma_rad", false),
];

/// Every number of a triad is in a field of the table.
const _: () = {
    let (vectors, matrices, numbers) = (21, 4, 1);
    assert!(vectors + matrices + numbers == FIELDS.len());
    assert!((3 * vectors + 9 * matrices + numbers) * size_of::<f64>() == size_of::<TriadParameters>());
};

/// Each field: not a number, infinite, beyond its range or of the wrong sign is refused by its name, element and value;
/// subnormal numbers pass or are refused as too small, and where they pass they change nothing visible.
#[test]
fn each_field_of_a_triad_at_its_ends() {
    for (field, gyro_name, accel_name, signed) in FIELDS {
        let names = [format!("gyro.{gyro_name}"), format!("accel.{accel_name}")];
        let count = field(&mut TriadParameters::default()).len();
        for element in 0..count {
            // The interface has matrices row by row, and no index for a single number.
            let index = match count {
                9 => Some(element % 3 * 3 + element / 3),
                3 => Some(element),
                _ => None,
            };
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, -1e-3, SUBNORMAL] {
                let mut set = TriadParameters::default();
                field(&mut set)[element] = value;
                let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
                let before = format!("{simulator:?}");
                let outcomes = [simulator.set_gyro(&set), simulator.set_accel(&set)];
                if !value.is_finite() || value.abs() > 1e200 || (value < 0.0 && !signed) {
                    for (outcome, name) in outcomes.iter().zip(&names) {
                        let error = outcome.unwrap_err();
                        assert_eq!(error.kind, ErrorKind::InvalidArgument, "{name}");
                        assert_eq!((error.field, error.index), (name.as_str(), index), "{error}");
                        assert_eq!(
                            error.value.map(|value| value.as_f64().to_bits()),
                            Some(value.to_bits()),
                            "{error}"
                        );
                    }
                    assert_eq!(before, format!("{simulator:?}"), "{names:?} {value}");
                    continue;
                }
                for k in 0..20 {
                    let sample =
                        FlightSample { temperature_c: Some(20.0), ..resting_sample(f64::from(k) / 100.0) };
                    simulator.push_sample(&sample).unwrap();
                    simulator.step().unwrap();
                }
                let imu = simulator.imu().unwrap();
                let off = (imu.measured.velocity - imu.ideal.velocity).norm()
                    + (imu.measured.angle - imu.ideal.angle).norm();
                if value == SUBNORMAL {
                    assert!(off < 1e-300 || outcomes.iter().all(Result::is_err), "{names:?}: {off:e}");
                }
                assert!(off.is_finite());
            }
        }
    }
}
