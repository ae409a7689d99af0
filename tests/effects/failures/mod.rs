//! Failures that an instructor sets, each against its closed form.

mod altimeter;
mod in_flight;
mod ranges;

use nalgebra::Vector3;
use sins::sensors::{Axis, Failure, SensorOutput, TriadParameters};
use sins::truth::FlightSample;
use sins::{ErrorSource, ImuFlags, ImuInterval, Options, Simulator};

use crate::support::{DEG, EARTH_RATE, G, options_at, patrol, resting_sample, sensed};

const EPS: f64 = f64::EPSILON;
const DT: f64 = 0.01;
fn simulator() -> Simulator {
    Simulator::new(&Options { error_model: true, ..options_at(1.0 / DT) }).unwrap()
}

/// Effects that draw in each interval or depend on the previous one.
fn noisy() -> TriadParameters {
    let one = Vector3::repeat(1.0);
    TriadParameters {
        bias_sigma: one * 1e-6,
        markov_sigma: one * 1e-6,
        markov_time_s: one * 10.0,
        random_walk: one * 1e-6,
        rate_random_walk: one * 1e-8,
        flicker: one * 1e-6,
        ramp: one * 1e-6,
        bandwidth_hz: one * 20.0,
        ..Default::default()
    }
}

fn noisy_simulator() -> Simulator {
    let mut simulator = simulator();
    simulator.set_gyro(&noisy()).unwrap();
    simulator.set_accel(&noisy()).unwrap();
    simulator
}

/// Level at rest, heading north: sensor axes are east-north-up.
fn rest(samples: core::ops::Range<u32>) -> impl Iterator<Item = FlightSample> {
    samples.map(|k| resting_sample(f64::from(k) * DT))
}

fn in_flight(samples: core::ops::Range<u32>) -> Vec<FlightSample> {
    let flight = patrol(2400.0);
    samples.map(|k| flight.sample_at(1000.0 + f64::from(k) * DT).unwrap()).collect()
}

const INVALID_GYRO: ImuFlags =
    ImuFlags { gyro_saturated: false, accel_saturated: false, gyro_invalid: true, accel_invalid: false };

/// A dead gyro at rest gives 0 where the Earth's rate should be, and so drifts by -Ω cos L: in a minute the misalignment about
/// north is Ω cos L t, except for terms of Ω² t². The differential equations include the failure.
#[test]
fn a_dead_gyro_at_rest_drifts_by_the_earths_rate() {
    let mut simulator = simulator();
    simulator.set_failure(SensorOutput::Gyro(Axis::Y), Some(Failure::Dead)).unwrap();
    let seconds = 60.0;
    let intervals = sensed(&mut simulator, rest(0..6001));
    let north = EARTH_RATE * (39.9 * DEG).cos();
    for imu in &intervals {
        assert_eq!((imu.measured.angle.y, imu.flags), (0.0, INVALID_GYRO));
        assert!((imu.ideal.angle.y - north * DT).abs() < 1e-9 * north * DT);
        assert_eq!((imu.measured.angle.x, imu.measured.velocity), (imu.ideal.angle.x, imu.ideal.velocity));
    }
    for source in [ErrorSource::Navigation, ErrorSource::Model] {
        let (_, errors) = simulator.errors(source).unwrap().unwrap();
        // φ' = -eps, and φ turns with the Earth. The tilt's velocity error changes φ at the Schuler rate, by (t/806 s)²/2.
        let expected = north * seconds;
        let second_order = expected * (EARTH_RATE * seconds + 0.5 * (seconds / 806.0).powi(2));
        assert!((errors.misalignment_n.y - expected).abs() < second_order, "{errors:?}");
    }
}

/// Before a bias step the signals are those of sound sensors, to the bit. From the next interval on the difference is
/// size × time. After the step is cleared, the measured signals are again those of sound sensors, to the bit.
#[test]
fn a_bias_step_begins_with_the_next_interval_and_goes_without_a_trace() {
    let mut sound = noisy_simulator();
    let expected = sensed(&mut sound, in_flight(0..300));
    for (output, size) in [(SensorOutput::Gyro(Axis::X), 0.01), (SensorOutput::Accelerometer(Axis::Z), -0.5)]
    {
        let mut failing = noisy_simulator();
        let mut found = sensed(&mut failing, in_flight(0..100));
        failing.set_failure(output, Some(Failure::BiasStep { size })).unwrap();
        found.extend(sensed(&mut failing, in_flight(100..200)));
        failing.set_failure(output, None).unwrap();
        found.extend(sensed(&mut failing, in_flight(200..300)));
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            if !(99..199).contains(&k) {
                assert_eq!(found, expected, "{k}");
                continue;
            }
            let angle = found.measured.angle - expected.measured.angle;
            let velocity = found.measured.velocity - expected.measured.velocity;
            let (step, other) = match output {
                SensorOutput::Gyro(_) => (angle - Vector3::x() * (size * DT), velocity),
                _ => (velocity - Vector3::z() * (size * DT), angle),
            };
            assert_eq!(other, Vector3::zeros(), "{k}");
            // Two sub-increments and their sum, rounded at a tenth of a m/s.
            assert!(step.amax() < 4.0 * EPS * (size * DT).abs().max(G * DT), "{k}: {step:?}");
        }
    }
}

/// Pulses of 20 ms each half second: 20 pulses in ten seconds. Each fills two intervals and has the area 0.02 s × size.
#[test]
fn a_spike_train_has_its_count_and_area() {
    let size = 0.125;
    let mut simulator = simulator();
    let train = |interval_s, duration_s| Some(Failure::Spikes { size, interval_s, duration_s });
    simulator.set_failure(SensorOutput::Accelerometer(Axis::Y), train(0.5, 0.02)).unwrap();
    let errors: Vec<f64> = sensed(&mut simulator, rest(0..1001))
        .iter()
        .map(|imu| imu.measured.velocity.y - imu.ideal.velocity.y)
        .collect();
    let area: f64 = errors.iter().sum();
    assert!((area - 20.0 * 0.02 * size).abs() < 1000.0 * EPS * size, "{area}");
    // Ends of pulses and of intervals coincide, except for the rounding of a thousand sums of time.
    let spiked: Vec<usize> = (0..1000).filter(|&k| errors[k] > 0.5 * size * DT).collect();
    let expected: Vec<usize> = (0..1000).filter(|k| k % 50 < 2).collect();
    assert_eq!(spiked, expected);

    // Pulses out of step with the intervals, some within a sub-increment: after each interval the area follows the closed form.
    simulator.set_failure(SensorOutput::Accelerometer(Axis::Y), train(0.0137, 0.0011)).unwrap();
    let mut area = 0.0;
    for (k, imu) in sensed(&mut simulator, rest(1001..2001)).iter().enumerate() {
        area += imu.measured.velocity.y - imu.ideal.velocity.y;
        let t = (k + 1) as f64 * DT;
        let whole = (t / 0.0137).floor();
        let expected = size * (whole * 0.0011 + (t - whole * 0.0137).min(0.0011));
        assert!((area - expected).abs() < 2000.0 * EPS * 10.0 * size, "{k}: {area} {expected}");
    }
}

/// The sum of squares of n increments of added noise is N² Σdt times a chi-square number of n degrees of freedom. Each axis of each
/// sensor has draws of its own.
#[test]
fn a_noise_burst_has_its_density() {
    let density = 1e-4;
    let mut sound = noisy_simulator();
    let mut failing = noisy_simulator();
    let outputs =
        [SensorOutput::Gyro(Axis::X), SensorOutput::Gyro(Axis::Z), SensorOutput::Accelerometer(Axis::X)];
    for output in outputs {
        failing.set_failure(output, Some(Failure::Noise { density })).unwrap();
    }
    let n = 20_000_u32;
    let expected = sensed(&mut sound, rest(0..n + 1));
    let found = sensed(&mut failing, rest(0..n + 1));
    let noise = |pick: fn(&ImuInterval) -> f64| -> Vec<f64> {
        found.iter().zip(&expected).map(|(found, expected)| pick(found) - pick(expected)).collect()
    };
    let series = [
        noise(|imu| imu.measured.angle.x),
        noise(|imu| imu.measured.angle.z),
        noise(|imu| imu.measured.velocity.x),
    ];
    let variance = density * density * DT;
    for (i, a) in series.iter().enumerate() {
        let chi_square = a.iter().map(|x| x * x).sum::<f64>() / variance;
        let sigmas = (chi_square - f64::from(n)) / (2.0 * f64::from(n)).sqrt();
        assert!(sigmas.abs() < 5.0, "{i}: {sigmas}");
        for b in &series[i + 1..] {
            let product = a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / variance;
            assert!(product.abs() < 5.0 * f64::from(n).sqrt(), "{i}: {product}");
        }
    }
    // A second burst continues with new draws: it does not repeat the first.
    let mut again = noisy_simulator();
    let mut first = Vec::new();
    for samples in [0..101, 101..201] {
        again.set_failure(outputs[0], Some(Failure::Noise { density })).unwrap();
        first.extend(sensed(&mut again, rest(samples)));
    }
    assert_eq!(first, found_with(&outputs[..1], density, 200));
}

/// Intervals at rest with noise on these outputs from the start.
fn found_with(outputs: &[SensorOutput], density: f64, intervals: u32) -> Vec<ImuInterval> {
    let mut simulator = noisy_simulator();
    for &output in outputs {
        simulator.set_failure(output, Some(Failure::Noise { density })).unwrap();
    }
    sensed(&mut simulator, rest(0..intervals + 1))
}

/// At rest each drop-out of the vertical accelerometer loses g T. Drop-outs each 0.25 s are 40 in ten seconds, the first at
/// once. Random drop-outs are the given share, within five standard deviations. Only a lost interval is 0 and flagged.
#[test]
fn drop_outs_lose_their_mass() {
    let n = 1000;
    for (failure, least, most) in [
        (Failure::DropOuts { interval_s: 0.25, probability: 0.0 }, 40, 40),
        (Failure::DropOuts { interval_s: 1e-3, probability: 0.0 }, n, n),
        // 30 ± 5 √(1000 × 0.03 × 0.97)
        (Failure::DropOuts { interval_s: 0.0, probability: 0.03 }, 4, 56),
        (Failure::DropOuts { interval_s: 0.0, probability: 1.0 }, n, n),
        (Failure::DropOuts { interval_s: 0.0, probability: 0.0 }, 0, 0),
    ] {
        let mut simulator = simulator();
        simulator.set_failure(SensorOutput::Accelerometer(Axis::Z), Some(failure)).unwrap();
        let intervals = sensed(&mut simulator, rest(0..n as u32 + 1));
        let lost = intervals.iter().filter(|imu| imu.flags.accel_invalid).count();
        assert!((least..=most).contains(&lost), "{failure:?}: {lost}");
        let mut velocity = 0.0;
        let mut g_t = 0.0;
        for imu in &intervals {
            assert_eq!(imu.measured.velocity.z == 0.0, imu.flags.accel_invalid);
            assert!(!imu.flags.gyro_invalid);
            velocity += imu.measured.velocity.z - imu.ideal.velocity.z;
            g_t = imu.ideal.velocity.z;
        }
        // Gravity at rest is the same in each interval, except for the rounding of the generator.
        assert!((velocity + lost as f64 * g_t).abs() < 1e-12 * n as f64 * g_t, "{failure:?}: {velocity}");
        if failure == (Failure::DropOuts { interval_s: 0.25, probability: 0.0 }) {
            assert!(intervals.iter().enumerate().all(|(k, imu)| imu.flags.accel_invalid == (k % 25 == 0)));
        }
    }
}

/// A stuck output repeats the last value that it showed; without one, the first value that it shows. It is not flagged.
#[test]
fn a_stuck_output_holds_the_last_value() {
    let mut simulator = noisy_simulator();
    let before = sensed(&mut simulator, in_flight(0..100));
    simulator.set_failure(SensorOutput::Gyro(Axis::X), Some(Failure::Stuck)).unwrap();
    let last = before[98].measured.angle.x;
    for imu in sensed(&mut simulator, in_flight(100..200)) {
        assert!((imu.measured.angle.x - last).abs() <= 4.0 * EPS * last.abs());
        assert!((imu.ideal.angle.x - last).abs() > 1e-9, "the flight goes on");
        assert_eq!(imu.flags, ImuFlags::default());
    }
    let mut simulator = noisy_simulator();
    simulator.set_failure(SensorOutput::Accelerometer(Axis::Y), Some(Failure::Stuck)).unwrap();
    let stuck = sensed(&mut simulator, in_flight(0..100));
    let first = stuck[0].measured.velocity.y;
    assert!(first != 0.0 && stuck.iter().all(|imu| imu.measured.velocity.y == first));
}

/// Bias steps pass through the range and the quantization; a failure that replaces the output does not.
#[test]
fn failures_act_in_their_place_in_the_order() {
    let one = Vector3::repeat(1.0);
    let mut simulator = simulator();
    let parameters =
        TriadParameters { range: one * 0.5, quantization: one * 2.0_f64.powi(-12), ..Default::default() };
    simulator.set_gyro(&parameters).unwrap();
    simulator.set_failure(SensorOutput::Gyro(Axis::Z), Some(Failure::BiasStep { size: 1.0 })).unwrap();
    simulator.set_failure(SensorOutput::Gyro(Axis::X), Some(Failure::Dead)).unwrap();
    let imu = sensed(&mut simulator, rest(0..2))[0];
    assert!(imu.flags.gyro_saturated && imu.flags.gyro_invalid);
    let pulses = imu.measured.angle.z * 2.0_f64.powi(12);
    // Half a rad/s for 10 ms is 20.48 pulses, 10.24 in each half of the interval: the rest is carried over.
    assert_eq!((pulses, imu.measured.angle.x), (20.0, 0.0));
}
