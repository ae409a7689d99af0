//! Failures outside their ranges are refused by field, value and limit.

use sins::ImuFlags;
use sins::sensors::{Axis, Failure, SensorOutput};

use super::{rest, simulator};
use crate::support::sensed;

#[test]
fn failures_have_ranges() {
    let mut simulator = simulator();
    let gyro = SensorOutput::Gyro(Axis::X);
    for (output, failure, sentence) in [
        (gyro, Failure::BiasStep { size: 101.0 }, "failure.size = 101: must be from -100 to 100"),
        (
            SensorOutput::Altimeter,
            Failure::BiasStep { size: f64::NAN },
            "failure.size = NaN: must be a finite number",
        ),
        (
            SensorOutput::Accelerometer(Axis::Z),
            Failure::Noise { density: -1.0 },
            "failure.density = -1: must be from 0 to 10000",
        ),
        (
            gyro,
            Failure::Spikes { size: 1.0, interval_s: 0.0, duration_s: 0.1 },
            "failure.interval_s = 0: must be from 0.0001 to 1e9",
        ),
        (
            gyro,
            Failure::Spikes { size: 1.0, interval_s: 1.0, duration_s: 0.0 },
            "failure.duration_s = 0: must be from 1e-9 to 1e9",
        ),
        (
            gyro,
            Failure::Spikes { size: 1.0, interval_s: 1.0, duration_s: 2.0 },
            "failure.duration_s = 2: must be at most failure.interval_s = 1",
        ),
        (
            gyro,
            Failure::DropOuts { interval_s: 0.0, probability: 1.5 },
            "failure.probability = 1.5: must be from 0 to 1",
        ),
        (
            gyro,
            Failure::DropOuts { interval_s: 1e10, probability: 0.0 },
            "failure.interval_s = 1e10: must be from 0.0001 to 1e9",
        ),
    ] {
        assert_eq!(simulator.set_failure(output, Some(failure)).unwrap_err().to_string(), sentence);
    }
    // No failure is set.
    let imu = sensed(&mut simulator, rest(0..2))[0];
    assert_eq!((imu.measured, imu.flags), (imu.ideal, ImuFlags::default()));
}
