//! Each field of a triad.

use sins::sensors::{PARAMETERS, Parameter, Sensor, TriadParameters};
use sins::truth::FlightSample;
use sins::{ErrorKind, Simulator};

use super::SUBNORMAL;
use crate::support::{options_at, resting_sample};

/// Name of a parameter in the errors of these sensors, and whether it may be negative.
fn name_and_sign(parameter: &Parameter, sensor: Sensor) -> (&'static str, bool) {
    parameter.of(sensor).map_or((parameter.name, true), |field| (field.path, field.range.ends().0 < 0.0))
}

/// Every number of a triad is one of a parameter of the table.
#[test]
fn the_table_has_every_number_of_a_triad() {
    let count: usize = PARAMETERS.iter().map(|parameter| parameter.shape.count()).sum();
    assert_eq!(count * size_of::<f64>(), size_of::<TriadParameters>());
    let numbers = TriadParameters::default().numbers().map(<[f64]>::len);
    assert!(numbers.into_iter().eq(PARAMETERS.iter().map(|parameter| parameter.shape.count())));
}

/// Each field: a value that is not a number, infinite, beyond its range or of the wrong sign is refused with name, element
/// and value. Subnormal numbers pass or are refused as too small; where they pass they change nothing visible.
#[test]
fn each_field_of_a_triad_at_its_ends() {
    for (row, parameter) in PARAMETERS.iter().enumerate() {
        let fields = [Sensor::Gyro, Sensor::Accelerometer].map(|sensor| name_and_sign(parameter, sensor));
        for element in 0..parameter.shape.count() {
            let index = (parameter.shape.count() > 1).then(|| parameter.shape.place(element));
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, -1e-3, SUBNORMAL] {
                let mut set = TriadParameters::default();
                set.numbers_mut()[row][element] = value;
                let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
                let before = format!("{simulator:?}");
                let outcomes = [simulator.set_gyro(&set), simulator.set_accel(&set)];
                let is_beyond = !value.is_finite() || value.abs() > 1e200;
                for (outcome, (name, signed)) in outcomes.iter().zip(fields) {
                    if is_beyond || (value < 0.0 && !signed) {
                        let error = outcome.unwrap_err();
                        assert_eq!(error.kind, ErrorKind::InvalidArgument, "{name}");
                        assert_eq!((error.field, error.index), (name, index), "{error}");
                        let bits = error.value.map(|value| value.as_f64().to_bits());
                        assert_eq!(bits, Some(value.to_bits()), "{error}");
                    }
                }
                if outcomes.iter().all(Result::is_err) {
                    assert_eq!(before, format!("{simulator:?}"), "{fields:?} {value}");
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
                    assert!(off < 1e-300, "{fields:?}: {off:e}");
                }
                assert!(off.is_finite());
            }
        }
    }
}
