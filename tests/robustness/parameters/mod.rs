//! Parameters at and beyond the ends of their ranges: zero, subnormal, huge, not a number; correlation times from 1e-6 of a
//! step to 1e12 s.
//!
//! 400 random simulators here; 20 000 with
//! `cargo test -p tests --release --features long-tests --test robustness parameters:: -- --nocapture`.

mod fields;

use nalgebra::{Matrix3, Vector3};
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{Alignment, AltimeterParameters, InitialErrorParameters, Sensor, TriadParameters};
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::moments::{reads, snapshot};
use crate::support::{options_at, resting_sample};

const RUNS: u32 = if cfg!(feature = "long-tests") { 20_000 } else { 400 };

const SUBNORMAL: f64 = 5e-324;

/// Marsaglia's xorshift. The figures of 20 000 simulators in `tests/README.md` depend on it.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % count
    }

    fn of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// Mostly zero; otherwise any size within the limits.
    fn vector(&mut self, low: f64, high: f64) -> Vector3<f64> {
        if self.below(3) > 0 {
            return Vector3::zeros();
        }
        self.each(low, high)
    }

    fn each(&mut self, low: f64, high: f64) -> Vector3<f64> {
        let sizes = [0.0, SUBNORMAL, 1e-310, 1e-300, 1e-15, 1e-6, 1e-3, 1.0, -1.0, 1e2, 1e4, -1e4, 1e6];
        Vector3::from_fn(|_, _| f64::clamp(self.of(&sizes), low, high))
    }

    fn matrix(&mut self, limit: f64) -> Matrix3<f64> {
        let rows = [0; 3].map(|_| self.vector(-limit, limit).transpose());
        Matrix3::from_rows(&rows)
    }

    /// A set that passes the check.
    fn triad(&mut self, sensor: Sensor) -> TriadParameters {
        let limit = if sensor == Sensor::Gyro { 100.0 } else { 1e4 };
        loop {
            let mut set = TriadParameters {
                bias: self.vector(-limit, limit),
                bias_sigma: self.vector(0.0, limit),
                markov_sigma: self.vector(0.0, limit),
                markov_time_s: Vector3::from_fn(|_, _| self.of(&[1e-9, 1e-6, 1e-3, 1.0, 1e6, 1e12, 1e15])),
                random_walk: self.vector(0.0, limit),
                rate_random_walk: self.vector(0.0, limit),
                ramp: self.vector(-limit, limit),
                flicker: self.vector(0.0, limit),
                quantization: self.vector(0.0, 1.0),
                scale_factor: self.vector(-1.0, 1.0),
                scale_factor_asymmetry: self.vector(-1.0, 1.0),
                scale_factor_nonlinearity: self.vector(-1.0, 1.0),
                range: self.vector(0.0, 1e6),
                bandwidth_hz: self.vector(0.0, 1e6),
                dead_zone: self.vector(0.0, limit),
                scale_factor_sigma: self.vector(0.0, 1.0),
                ..Default::default()
            };
            match sensor {
                Sensor::Gyro => set.g_sensitivity = self.matrix(1.0),
                Sensor::Accelerometer => {
                    set.vibration_rectification_s2_m = self.vector(-1.0, 1.0);
                    set.lever_arm_m = self.matrix(100.0);
                }
            }
            if set.validate(sensor).is_ok() {
                return set;
            }
        }
    }

    fn simulator(&mut self) -> (Simulator, f64) {
        let rate_hz = self.of(&[1.0, 10.0, 1000.0]);
        let options = Options {
            frame: self.of(&[Frame::EarthFixed, Frame::Geographic]),
            scheme: self.of(&[Scheme::Exact, Scheme::Paper, Scheme::Polynomial]),
            vertical: self.of(&[VerticalMode::Damped, VerticalMode::Free, VerticalMode::FollowTruth]),
            error_model: true,
            subsamples: 1 + self.below(5),
            updates_per_sample: self.of(&[1, 1, 3]),
            closed_loop_time_s: self.of(&[None, Some(30.0)]),
            ..options_at(rate_hz)
        };
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&self.triad(Sensor::Gyro)).unwrap();
        simulator.set_accel(&self.triad(Sensor::Accelerometer)).unwrap();
        let altimeter = AltimeterParameters {
            bias_m: self.of(&[0.0, 1e5, -1e5, SUBNORMAL]),
            markov_sigma_m: self.of(&[0.0, 1e5, SUBNORMAL]),
            markov_time_s: self.of(&[1e-9, 1.0, 1e15]),
            noise_m: self.of(&[0.0, 1e5]),
            scale_factor: self.of(&[0.0, -1.0, 1.0]),
            lag_s: self.of(&[0.0, SUBNORMAL, 1e-300, 1.0, 1e6]),
        };
        simulator.set_altimeter(&altimeter).unwrap();
        if self.below(3) == 0 {
            let pi = std::f64::consts::PI;
            let initial = InitialErrorParameters {
                position_n: self.each(-1e6, 1e6),
                velocity_n: self.each(-1e4, 1e4),
                misalignment_n: self.each(-pi, pi),
                alignment: self.of(&[Alignment::Given, Alignment::LevelAndGyrocompass]),
                ..Default::default()
            };
            simulator.set_initial_errors(&initial).unwrap();
        }
        (simulator, rate_hz)
    }
}

/// Every number that can be read.
fn readings(simulator: &Simulator) -> Vec<f64> {
    let solution = simulator.navigation().unwrap().unwrap();
    let navigation = &solution.navigation;
    let (place, euler) = (&navigation.place, &navigation.euler);
    let mut all = vec![solution.time_s, place.latitude_rad, place.longitude_rad, place.height_m];
    all.extend([euler.roll, euler.pitch, euler.heading]);
    all.extend(navigation.v_n.iter().chain(navigation.q_nb.coords.iter()));
    for source in [ErrorSource::Navigation, ErrorSource::Model] {
        let (_, errors) = simulator.errors(source).unwrap().unwrap();
        all.extend(errors.position_n.iter().chain(&errors.velocity_n).chain(&errors.misalignment_n));
        all.extend([errors.latitude_rad, errors.longitude_rad]);
        all.extend([errors.roll_rad, errors.pitch_rad, errors.heading_rad]);
    }
    if let Some(imu) = simulator.imu() {
        all.extend(imu.ideal.angle.iter().chain(&imu.ideal.velocity));
        all.extend(imu.measured.angle.iter().chain(&imu.measured.velocity));
    }
    let (_, accuracy, closure) = simulator.accuracy().unwrap().unwrap();
    all.extend([accuracy.radial_error_rate_rms_m_s, accuracy.radial_error_slope_m_s]);
    all.extend(accuracy.velocity_rms_n.iter().chain(&closure.host_position_n).chain(&closure.position_n));
    let trim = simulator.trim().unwrap().unwrap();
    all.extend([trim.rate_rad_s, trim.force_m_s2]);
    all
}

/// With any parameters, all that is read is a number until the solution leaves its range. This end is reported, and the refused
/// step has changed nothing: not what is read, not a byte of a snapshot, and not the next step with other sensors.
#[test]
fn any_parameters_are_bounded_or_refused() {
    let mut random = Random(88_172_645_463_325_252);
    let (mut flown, mut diverged, mut singular) = (0, 0, 0);
    for run in 0..RUNS {
        let (mut simulator, rate_hz) = random.simulator();
        let latitude_rad = random.of(&[0.0, 0.7, -1.5, 1.57, std::f64::consts::FRAC_PI_2]);
        let place = Geodetic { latitude_rad, longitude_rad: 3.0, height_m: 1e4 };
        let (mut refused, mut ways) = (None, None);
        for k in 0..300 {
            let time_s = f64::from(k) / rate_hz;
            let euler = Euler { roll: 2.0 * time_s, pitch: 1.0, heading: 2.0 };
            simulator.push_sample(&FlightSample::at_rest(time_s, place, euler)).unwrap();
            let before = simulator.clone();
            if let Err(error) = simulator.step() {
                for mut after in [before, simulator.clone()].map(Box::new) {
                    let now = (reads(&after), after.ideal_increments().to_vec(), snapshot(&after));
                    for sensor in [Simulator::set_gyro, Simulator::set_accel] {
                        sensor(&mut after, &TriadParameters::default()).unwrap();
                    }
                    let onward = (format!("{:?}", after.step()), reads(&after), snapshot(&after));
                    let ways = ways.get_or_insert_with(|| (now.clone(), onward.clone()));
                    assert!(*ways == (now, onward), "run {run}");
                }
                refused = Some(error.kind);
                break;
            }
            if k > 0 {
                let all = readings(&simulator);
                assert!(all.iter().all(|value| value.is_finite()), "run {run}, step {k}: {all:?} {before:?}");
            }
        }
        match refused {
            None => flown += 1,
            Some(ErrorKind::Diverged) => diverged += 1,
            Some(ErrorKind::Singular) => singular += 1,
            Some(kind) => panic!("run {run}: {kind:?}"),
        }
    }
    println!("figure: {flown} flown, {diverged} diverged, {singular} singular, no NaN, no infinity");
    assert!(flown > RUNS / 10 && diverged > RUNS / 10, "{flown} {diverged}");
}

/// Correlation times of 1e-6 of a step, where the process is white with the density 2σ²τ, to 1e12 s, where it is a constant: the
/// variance of its mean over a step is that of the theory, and the second draw is as good as the first.
#[test]
fn correlation_times_from_a_millionth_of_a_step_to_1e12_seconds() {
    let dt = 0.01;
    let (mut least, mut most, mut sigmas) = (f64::MAX, 0.0_f64, 0.0_f64);
    for time_s in [1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e12] {
        let mut simulator = Simulator::new(&Options { subsamples: 1, ..options_at(100.0) }).unwrap();
        let set = TriadParameters {
            markov_sigma: Vector3::repeat(1e-3),
            markov_time_s: Vector3::repeat(time_s),
            ..Default::default()
        };
        simulator.set_gyro(&set).unwrap();
        let (mut squares, mut count, mut first, mut last) = (0.0, 0.0, Vector3::zeros(), Vector3::zeros());
        for k in 0..20_000 {
            simulator.push_sample(&resting_sample(f64::from(k) * dt)).unwrap();
            simulator.step().unwrap();
            if let Some(imu) = simulator.imu() {
                last = (imu.measured.angle - imu.ideal.angle) / dt;
                if count == 0.0 {
                    first = last;
                }
                squares += last.norm_squared();
                count += 3.0;
            }
        }
        let a: f64 = dt / time_s;
        if a < 1e-6 {
            // A constant, except for σ √(2 t/τ) after t = 200 s; five standard deviations along each axis.
            let change = 1e-3 * (2.0 * 200.0 / time_s).sqrt();
            println!(
                "correlation time {time_s:e} s: changed by {:.0e} of itself",
                (last - first).norm() / 1e-3
            );
            assert!((last - first).norm() < 5.0 * 3f64.sqrt() * change, "{first} {last}");
            assert!(first.amax() > 0.0 && first.amax() < 5.0 * 1e-3, "{first}");
            continue;
        }
        // Means over steps have the variance 2σ²(a - 1 + e^-a)/a². Neighbours correlate by (1 - e^-a)²/(2(a - 1 + e^-a));
        // each further step multiplies this by e^-a. A sum of squares has a variance by the sum of the correlations' squares.
        let mean = a + (-a).exp_m1();
        let neighbours = (-a).exp_m1().powi(2) / (2.0 * mean);
        let independent = count / (1.0 - 2.0 * neighbours.powi(2) / (-2.0 * a).exp_m1());
        let ratio = squares / count / (1e-6 * 2.0 * mean / (a * a));
        let sigma = (2.0 / independent).sqrt();
        println!(
            "correlation time {time_s:e} s: variance {ratio:.3} of the theory's, {sigma:.3} to be expected"
        );
        let off = (ratio - 1.0).abs();
        assert!(off < 5.0 * sigma, "{ratio}");
        (least, most, sigmas) = (least.min(off), most.max(off), sigmas.max(off / sigma));
    }
    let [least, most] = [least, most].map(|off| 100.0 * off);
    println!("figure: {least:.1} to {most:.1} %, at most {sigmas:.1} standard deviations (limit 5)");
}
