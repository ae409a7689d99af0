//! A flight that begins in motion, mounted off the reference point or with accelerometers off each other: its first intervals
//! know the angular acceleration only in part, and the navigation does not suffer from this.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Quaternion, Vector3};
use sins::math::{euler_from_attitude, rotate_inverse};
use sins::mechanization::Scheme;
use sins::sensors::TriadParameters;
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};
use sins::{ErrorSource, ImuInterval, Options, Simulator};

use crate::support::{self, DEG, EARTH_RATE, options_at, resting_sample};

const ARM_M: f64 = 3.4;
/// A motion in closed form at a fixed place: its attitude, and its angular rate relative to the Earth in body axes [rad/s].
struct Scene {
    name: &'static str,
    rate_hz: f64,
    frequency_hz: f64,
    attitude: fn(f64) -> (Quaternion<f64>, Vector3<f64>),
}

/// A rotation about the vertical, 64 °/s rms.
fn turntable(time_s: f64) -> (Quaternion<f64>, Vector3<f64>) {
    let (rate, turn) = (64.0 * DEG * 2f64.sqrt(), TAU * TURNTABLE.frequency_hz);
    let half = 0.5 * rate / turn * (1.0 - (turn * time_s).cos());
    (Quaternion::new(half.cos(), 0.0, 0.0, half.sin()), Vector3::new(0.0, 0.0, rate * (turn * time_s).sin()))
}

/// Coning of 0.01° at 10 Hz about horizontal axes.
fn coning(time_s: f64) -> (Quaternion<f64>, Vector3<f64>) {
    let (half, turn) = (0.005 * DEG, TAU * CONING.frequency_hz);
    let (sin, cos) = (turn * time_s).sin_cos();
    let rate =
        Vector3::new(-(2.0 * half).sin() * sin, (2.0 * half).sin() * cos, 2.0 * half.sin().powi(2)) * turn;
    (Quaternion::new(half.cos(), half.sin() * cos, half.sin() * sin, 0.0), rate)
}

const TURNTABLE: Scene =
    Scene { name: "turntable", rate_hz: 100.0, frequency_hz: 0.376, attitude: turntable };
const CONING: Scene = Scene { name: "coning", rate_hz: 1000.0, frequency_hz: 10.0, attitude: coning };

impl Scene {
    /// Angular rate against inertial space in body axes at `time_s` [rad/s].
    fn rate(&self, time_s: f64) -> Vector3<f64> {
        let (q_nb, rate_b) = (self.attitude)(time_s);
        let latitude = resting_sample(0.0).place.latitude_rad;
        rate_b + rotate_inverse(&q_nb, &(Vector3::new(0.0, latitude.cos(), latitude.sin()) * EARTH_RATE))
    }

    /// The sample `k`, with the host's angular rate or without.
    fn sample(&self, k: i32, with_rate: bool) -> FlightSample {
        let time_s = f64::from(k) / self.rate_hz;
        let euler = euler_from_attitude(&(self.attitude)(time_s).0);
        FlightSample { euler, omega_ib_b: with_rate.then(|| self.rate(time_s)), ..resting_sample(time_s) }
    }

    /// Additional mean force that an accelerometer at `place` [m] senses in interval `k` [m/s²], by three points of Gauss.
    fn sensed(&self, place: &Vector3<f64>, k: usize) -> Vector3<f64> {
        let rate = |u: f64| self.rate((k as f64 + u) / self.rate_hz);
        let node = 0.5 * 0.6f64.sqrt();
        let centripetal: Vector3<f64> = [(0.5 - node, 5.0), (0.5, 8.0), (0.5 + node, 5.0)]
            .iter()
            .map(|&(u, weight)| rate(u).cross(&rate(u).cross(place)) * (weight / 18.0))
            .sum();
        (rate(1.0) - rate(0.0)).cross(place) * self.rate_hz + centripetal
    }
}

/// A light aircraft in turbulence, 20 s after take-off.
fn light_aircraft(rate_hz: f64) -> impl Fn(i32) -> FlightSample {
    let start = FlightStart { latitude_rad: 0.8, height_m: 500.0, speed_m_s: 50.0, ..Default::default() };
    let wave = |channel, degrees: f64, frequency_hz, phase_rad| Sinusoid {
        channel,
        amplitude: degrees * DEG,
        frequency_hz,
        phase_rad,
    };
    let terms = [
        wave(Channel::Roll, 1.0, 0.7, 0.3),
        wave(Channel::Roll, 0.05, 2.3, 1.0),
        wave(Channel::Pitch, 0.5, 0.5, 2.0),
        wave(Channel::Pitch, 0.05, 1.7, 0.1),
        wave(Channel::Heading, 0.3, 0.9, 1.5),
    ];
    let turbulence = Manoeuvre::Sinusoids { duration_s: 40.0, ramp_s: 5.0, sinusoids: Sinusoids::of(&terms) };
    let flight = Flight::new(&start, &[turbulence]).unwrap();
    move |k| flight.sample_at(20.0 + f64::from(k) / rate_hz).unwrap()
}

fn mounting() -> MountingParameters {
    MountingParameters { lever_arm_m: Vector3::new(0.6, -0.8, 0.0) * ARM_M, ..Default::default() }
}

/// Places of accelerometers that are as far off each other as in a hand-sized block [m].
const PLACES_M: Matrix3<f64> = Matrix3::new(0.03, -0.05, 0.02, 0.05, 0.04, -0.03, -0.04, 0.05, 0.03);

/// The signals of the intervals between samples `from` and `to`, flown from `from` on.
fn flown(
    simulator: &mut Simulator,
    sample: impl Fn(i32) -> FlightSample,
    from: i32,
    to: i32,
) -> Vec<ImuInterval> {
    support::sensed(simulator, (from..=to).map(sample))
}

/// Largest |ω'| [rad/s²], |ω''| [rad/s³] and |ω'''| [rad/s⁴] of a flight with these signals.
fn changes_of_rate(signals: &[ImuInterval]) -> [f64; 3] {
    let mut rates: Vec<Vector3<f64>> = signals.iter().map(|imu| imu.ideal.angle / imu.interval_s).collect();
    [0, 1, 2].map(|_| {
        rates = rates.windows(2).map(|pair| (pair[1] - pair[0]) / signals[0].interval_s).collect();
        rates.iter().map(|change| change.norm()).fold(0.0, f64::max)
    })
}

/// Compares the forces of the first intervals with those of a flight that was always there [m/s²]. The bounds are what four
/// samples and fewer cannot know. The first interval has only a mean rate: it lacks all of ω'. In the second three samples make
/// a parabola of the angle: its rates at both ends differ by h² ω''/2 too much, and four samples in the third by h³ ω'''/3.
fn check_start(
    name: &str,
    arm_m: f64,
    started: &[Vector3<f64>],
    always: &[Vector3<f64>],
    changes: [f64; 3],
    h: f64,
) {
    let error: Vec<f64> = started.iter().zip(always).map(|(a, b)| (a - b).norm()).collect();
    let [first, second, third] = changes;
    println!(
        "{name}: {:.3} {:.4} {:.1e} {:.1e} m/s² of up to {:.3}",
        error[0],
        error[1],
        error[2],
        error[3],
        first * arm_m
    );
    // Terms that turn with the rate are of the next order.
    assert!(error[0] < arm_m * (first + h * second), "{error:?}");
    assert!(error[1] < arm_m * (h * second / 2.0 + h * h * third), "{error:?}");
    assert!(error[2] < arm_m * h * h * third / 2.0, "{error:?}");
    // Roundings of a rate, over h.
    assert!(error[3..].iter().all(|error| *error < arm_m * 4e-15 / h), "{error:?}");
}

fn forces(signals: &[ImuInterval]) -> Vec<Vector3<f64>> {
    signals.iter().map(|imu| imu.ideal.velocity / imu.interval_s).collect()
}

/// Errors of the size effect alone [m/s²].
fn effects(signals: &[ImuInterval]) -> Vec<Vector3<f64>> {
    signals.iter().map(|imu| (imu.measured.velocity - imu.ideal.velocity) / imu.interval_s).collect()
}

/// The result is the position error of perfect sensors at the end [m].
fn check_scene(name: &str, rate_hz: f64, sample: &dyn Fn(i32) -> FlightSample) -> f64 {
    let options = Options { scheme: Scheme::Polynomial, subsamples: 4, ..options_at(rate_hz) };
    let mounted = || {
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_mounting(&mounting()).unwrap();
        simulator
    };
    let (last, earlier) = (200, 10);
    let signals = flown(&mut mounted(), sample, -earlier, last);
    let always_signals = &signals[earlier as usize..];
    let changes = changes_of_rate(&signals[3..]);
    let mut simulator = mounted();
    let started = flown(&mut simulator, sample, 0, last);
    check_start(name, ARM_M, &forces(&started), &forces(always_signals), changes, 1.0 / rate_hz);

    // A reposition is a start, to the bit, and so is a start from a queue that was filled before.
    let mut repositioned = mounted();
    flown(&mut repositioned, sample, -earlier, 50);
    repositioned.reposition(&sample(0)).unwrap();
    assert_eq!(flown(&mut repositioned, sample, 1, last), started);
    let mut queued = mounted();
    for k in 0..=15 {
        queued.push_sample(&sample(k)).unwrap();
    }
    for expected in &started[..15] {
        queued.step().unwrap();
        assert_eq!(queued.imu().unwrap(), *expected);
    }

    // Perfect sensors navigate to the truth, except for eight roundings of a position in Earth-fixed axes.
    let errors = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1;
    println!("{name}: {:.1e} m, {:.1e} m/s", errors.position_n.norm(), errors.velocity_n.norm());
    assert!(errors.position_n.norm() < 8e-9 && errors.velocity_n.norm() < 1e-9, "{errors:?}");

    let with_size_effect = |from| {
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_accel(&TriadParameters { lever_arm_m: PLACES_M, ..Default::default() }).unwrap();
        flown(&mut simulator, sample, from, last)
    };
    let always = effects(&with_size_effect(-earlier));
    let reach_m = PLACES_M.norm();
    check_start(
        &format!("{name}, size effect"),
        reach_m,
        &effects(&with_size_effect(0)),
        &always[earlier as usize..],
        changes,
        1.0 / rate_hz,
    );
    errors.position_n.norm()
}

#[test]
fn a_start_in_motion_makes_no_spike() {
    let mut off_m = check_scene("light aircraft", 100.0, &light_aircraft(100.0));
    for scene in [TURNTABLE, CONING] {
        off_m = off_m.max(check_scene(scene.name, scene.rate_hz, &|k| scene.sample(k, false)));
    }
    let decays = "the missing term decays from interval to interval";
    println!("figure: {decays}; position of perfect sensors {off_m:.1e} m (limit 8e-9 m)");
}

/// With the host's rates the mean of ω'×r is known from the first interval on, to rounding. The mean of ω×(ω×r) comes from the
/// mean rate and its change, too small by (Ω h)⁴/720 at a frequency Ω; the cubic of the rate errs by as much again.
#[test]
fn the_hosts_rates_tell_the_first_interval() {
    for scene in [TURNTABLE, CONING] {
        let angle = TAU * scene.frequency_hz / scene.rate_hz;
        for subsamples in [1, 2, 5] {
            let options = Options { subsamples, ..options_at(scene.rate_hz) };
            let mut simulator = Simulator::new(&options).unwrap();
            simulator.set_accel(&TriadParameters { lever_arm_m: PLACES_M, ..Default::default() }).unwrap();
            let effects = effects(&flown(&mut simulator, |k| scene.sample(k, true), 0, 20));
            let wrong = effects.iter().enumerate().map(|(k, effect)| {
                let expected =
                    Vector3::from_fn(|axis, _| scene.sensed(&PLACES_M.row(axis).transpose(), k)[axis]);
                (effect - expected).norm() / expected.norm()
            });
            let wrong: Vec<f64> = wrong.collect();
            let worst = wrong.iter().copied().fold(0.0, f64::max);
            println!(
                "{}, {subsamples} subsamples: {:.1e} of the effect in interval 1, {worst:.1e} at worst",
                scene.name, wrong[0]
            );
            assert!(worst < angle.powi(4) / 360.0, "{worst}");
        }
    }
}
