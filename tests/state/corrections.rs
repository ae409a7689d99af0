//! Corrections by the host: errors that are fed back disappear, zeros change no bit, and both error data agree afterwards.

use nalgebra::Vector3;
use sins::earth::state::StateErrors;
use sins::ensemble::Ensemble;
use sins::errors::NavigationErrors;
use sins::errors::correction::{Compensation, Correction};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{GravityDisturbanceParameters, GravityField, InitialErrorParameters, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::moments::{every_effect, reads, snapshot};
use crate::support::orbits::{Apart, Circle, about, navigated};
use crate::support::{DEG_PER_HOUR, G, errors, fly_through, patrol, step};

/// The correction that removes `errors` of the solution.
fn removing(errors: &NavigationErrors) -> Correction {
    let NavigationErrors { position_n, velocity_n, misalignment_n, .. } = *errors;
    Correction { errors: StateErrors { position_n, velocity_n, misalignment_n }, ..Default::default() }
}

/// Samples of the patrol at 50 Hz.
fn samples(count: usize) -> impl Iterator<Item = FlightSample> {
    let flight = patrol(600.0);
    (0..count).map(move |k| flight.sample_at(k as f64 / 50.0).unwrap())
}

fn initial(scale: f64) -> InitialErrorParameters {
    InitialErrorParameters {
        position_n: Vector3::new(3e3, -2e3, 100.0) * scale,
        velocity_n: Vector3::new(2.0, 3.0, -1.0) * scale,
        misalignment_n: Vector3::new(1e-3, -2e-3, 5e-3) * scale,
        ..Default::default()
    }
}

fn mounting() -> MountingParameters {
    MountingParameters {
        lever_arm_m: Vector3::new(3.0, -5.0, 1.0),
        boresight: sins::math::Euler { roll: 0.3, pitch: -0.2, heading: 1.1 },
        lever_arm_error_m: Vector3::new(0.1, 0.2, -0.1),
        boresight_error: sins::math::Euler { roll: 1e-3, pitch: 2e-3, heading: -1e-3 },
    }
}

/// Every frame and scheme, each vertical channel, with the closed loop and with a mounting.
fn modes() -> Vec<(Options, bool)> {
    let mut modes = Vec::new();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for scheme in [Scheme::Exact, Scheme::Paper, Scheme::Polynomial] {
            for vertical in [VerticalMode::Free, VerticalMode::Damped, VerticalMode::FollowTruth] {
                for (closed_loop_time_s, is_mounted) in [(None, false), (Some(60.0), false), (None, true)] {
                    let options = Options {
                        frame,
                        scheme,
                        vertical,
                        closed_loop_time_s,
                        error_model: true,
                        ..Default::default()
                    };
                    modes.push((options, is_mounted));
                }
            }
        }
    }
    modes
}

fn simulator(options: &Options, is_mounted: bool, scale: f64) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, accel) = every_effect();
    simulator.set_gyro(&TriadParameters { bias: gyro.bias, ..Default::default() }).unwrap();
    simulator.set_accel(&TriadParameters { bias: accel.bias, ..Default::default() }).unwrap();
    simulator.set_initial_errors(&initial(scale)).unwrap();
    if is_mounted {
        simulator.set_mounting(&mounting()).unwrap();
    }
    simulator
}

/// Position [m], velocity [m/s] and misalignment [rad] that are left.
fn left(errors: &NavigationErrors) -> [f64; 3] {
    [errors.position_n.norm(), errors.velocity_n.norm(), errors.misalignment_n.norm()]
}

/// Errors that were read and fed back are gone, to the rounding of a position of an Earth radius, 2 nm, and of the velocity of the
/// Earth, 465 m/s.
#[test]
fn errors_that_are_fed_back_are_gone() {
    let mut worst = [0.0_f64; 3];
    for (options, is_mounted) in modes() {
        let mut simulator = simulator(&options, is_mounted, 1.0);
        fly_through(&mut simulator, samples(150));
        let found = errors(&simulator, ErrorSource::Navigation);
        assert!(found.position_n.norm() > 3000.0 && found.misalignment_n.norm() > 4e-3);
        simulator.correct(&removing(&found)).unwrap();
        let left = left(&errors(&simulator, ErrorSource::Navigation));
        assert!(left[0] < 1e-8 && left[1] < 1e-12 && left[2] < 4e-15, "{left:?}: {options:?}");
        worst = core::array::from_fn(|k| worst[k].max(left[k]));
    }
    let [m, m_s, rad] = worst;
    println!("figure: {m:.1e} m, {m_s:.1e} m/s, {rad:.1e} rad (limits 1e-8 m, 1e-12 m/s, 4e-15 rad)");
}

/// After a correction error data 1 and 2 agree as before, to second order in the errors: a tenth of the errors leaves a hundredth.
#[test]
fn both_error_data_take_the_same_correction() {
    for (options, is_mounted) in modes() {
        let apart = |scale: f64| {
            let mut simulator = simulator(&options, is_mounted, scale);
            if is_mounted {
                simulator
                    .set_mounting(&MountingParameters {
                        lever_arm_error_m: mounting().lever_arm_error_m * scale,
                        boresight_error: Default::default(),
                        ..mounting()
                    })
                    .unwrap();
            }
            let none = TriadParameters::default();
            simulator.set_gyro(&none).unwrap();
            simulator.set_accel(&none).unwrap();
            fly_through(&mut simulator, samples(100));
            let mut correction = removing(&errors(&simulator, ErrorSource::Navigation));
            let StateErrors { position_n, velocity_n, misalignment_n } = &mut correction.errors;
            *position_n *= 0.3;
            *velocity_n *= -0.7;
            *misalignment_n *= 1.5;
            correction.sensors.gyro_bias = Vector3::new(1.0, -2.0, 3.0) * (1e-6 * scale);
            correction.sensors.accel_scale_factor = Vector3::new(2.0, -1.0, 1.0) * (1e-5 * scale);
            simulator.correct(&correction).unwrap();
            fly_through(&mut simulator, samples(200).skip(100));
            let (navigated, model) =
                (errors(&simulator, ErrorSource::Navigation), errors(&simulator, ErrorSource::Model));
            assert!(model.position_n.norm() >= 2000.0 * scale, "{options:?}");
            [
                navigated.position_n - model.position_n,
                navigated.velocity_n - model.velocity_n,
                navigated.misalignment_n - model.misalignment_n,
            ]
        };
        // Without errors the scheme's own errors are left.
        let own = apart(0.0);
        let beyond_own = |scale: f64| {
            let found = apart(scale);
            [0, 1, 2].map(|k| (found[k] - own[k]).norm())
        };
        let (one, tenth) = (beyond_own(1.0), beyond_own(0.1));
        // The model takes the axes at the block for those at the reference point: they differ by the arm over the Earth's radius.
        let by_arm = if is_mounted { mounting().lever_arm_m.norm() / 6.3e6 } else { 0.0 };
        let rounding = [1e-8 + by_arm * 400.0, 1e-10 + by_arm, 1e-13 + by_arm * 1e-3];
        for k in 0..3 {
            let ratio = one[k] / tenth[k];
            let is_second_order = (70.0..140.0).contains(&ratio) || tenth[k] < rounding[k];
            assert!(is_second_order, "{k}: {} and {}: {is_mounted} {options:?}", one[k], tenth[k]);
        }
    }
}

/// Past either pole, with a solution on the other side of the pole or beside it.
///
/// The solution alone shows the longitude, by its own distance m from the axis along the truth's meridian. A rounding of some
/// nanometres turns the corrected solution by its share of m about the axis.
#[test]
fn errors_at_the_poles_are_removed() {
    let (mut largest, mut across) = (0.0_f64, 0);
    for place in [0.0, core::f64::consts::PI].map(|angle| about(Vector3::x(), angle)) {
        for (offset_m, scale) in [(0.0, 1e-6), (0.0, 0.01), (0.01, 0.3), (10.0, 0.003), (700.0, 0.3)] {
            let circle = Circle::past(place, offset_m);
            let options = Options { error_model: true, ..Default::default() };
            let mut simulator = simulator(&options, false, scale);
            // The errors begin 60 km from the pole, where the axes of truth and solution are still alike.
            for k in -4800..400 {
                let sample = circle.sample(f64::from(k) / 20.0);
                step(&mut simulator, &sample);
                if k % 7 != 0 || k < -400 {
                    continue;
                }
                let mut corrected = simulator.clone();
                let found = errors(&corrected, ErrorSource::Navigation);
                let (solution, truth) = (navigated(&corrected), circle.state(sample.time_s));
                let m2 = solution.r_e.xy().norm_squared() - found.position_n.x.powi(2);
                let distance_m = m2.max(1e-12).sqrt();
                across += u32::from(solution.r_e.xy().dot(&truth.r_e.xy()) < 0.0);
                corrected.correct(&removing(&found)).unwrap();
                let apart = Apart::new(&navigated(&corrected), &truth);
                let turn_rad = 4e-15 + 1e-8 / distance_m;
                let share = apart.position_m / (1e-8 + found.position_n.norm() * turn_rad);
                assert!(share < 1.0, "{offset_m} m, error {scale}, {k}: {apart}, {turn_rad}");
                assert!(apart.velocity_m_s < 1e-12 + 250.0 * turn_rad && apart.attitude_rad < turn_rad);
                largest = largest.max(share);
            }
        }
    }
    assert!(across > 10 && largest > 0.01, "{across} {largest}");
    println!("figure: {largest:.2} of 1e-8 m and the errors times the rounding of the longitude");
}

/// Zeros change no bit of what is read or saved. Nor does a rejected correction.
#[test]
fn zeros_and_rejected_corrections_change_nothing() {
    let options = Options { error_model: true, covariance: true, ..Default::default() };
    let mut simulator = simulator(&options, true, 1.0);
    let none = Correction::default();
    assert_eq!(simulator.correct(&none).unwrap_err().kind, ErrorKind::BadState);
    fly_through(&mut simulator, samples(20));
    let before = (reads(&simulator), snapshot(&simulator));
    simulator.correct(&none).unwrap();
    let bad = |change: fn(&mut Correction)| {
        let mut bad = Correction::default();
        change(&mut bad);
        bad
    };
    for (correction, field) in [
        (
            bad(|c| c.errors.position_n.y = 1.1e6),
            "correction.position_enu_m[1] = 1100000: must be from -1000000 to 1000000",
        ),
        (bad(|c| c.errors.velocity_n.x = f64::NAN), "correction.velocity_enu_m_s[0] = NaN"),
        (bad(|c| c.errors.misalignment_n.z = -3.2), "correction.misalignment_enu_rad[2] = -3.2"),
        (bad(|c| c.sensors.gyro_bias.x = 101.0), "compensation.gyro_bias_rad_s[0] = 101"),
        (bad(|c| c.sensors.gyro_scale_factor.y = 0.6), "compensation.gyro_scale_factor[1] = 0.6"),
        (bad(|c| c.sensors.accel_bias.z = f64::INFINITY), "compensation.accel_bias_m_s2[2]"),
        (bad(|c| c.sensors.accel_scale_factor.x = -0.51), "compensation.accel_scale_factor[0]"),
    ] {
        let error = simulator.correct(&correction).unwrap_err();
        assert_eq!(error.kind, ErrorKind::InvalidArgument);
        assert!(error.to_string().starts_with(field), "{error}");
    }
    assert!((reads(&simulator), snapshot(&simulator)) == before);
}

/// The covariance stays that of an INS without corrections, and says so, also after a snapshot; until the INS starts anew.
#[test]
fn the_covariance_leaves_corrections_out_and_says_so() {
    let options = Options { covariance: true, ..Default::default() };
    let (mut corrected, mut free) = (simulator(&options, false, 1.0), simulator(&options, false, 1.0));
    for simulator in [&mut corrected, &mut free] {
        simulator
            .set_initial_errors(&InitialErrorParameters {
                position_sigma_n: Vector3::repeat(10.0),
                misalignment_sigma_n: Vector3::repeat(1e-3),
                ..Default::default()
            })
            .unwrap();
        fly_through(simulator, samples(200));
    }
    corrected.correct(&some_correction(1)).unwrap();
    for simulator in [&mut corrected, &mut free] {
        fly_through(simulator, samples(400).skip(200));
    }
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&snapshot(&corrected)).unwrap();
    let read = |simulator: &mut Simulator| simulator.covariance().unwrap().unwrap().1;
    let [found, loaded, expected] = [&mut corrected, &mut loaded, &mut free].map(read);
    assert!(expected.matrix[(0, 0)] >= 100.0 && !expected.without_corrections);
    assert!(found.matrix == expected.matrix && found.without_corrections && loaded == found);
    corrected.reset();
    fly_through(&mut corrected, samples(3));
    assert!(!read(&mut corrected).without_corrections);
}

/// Constant biases and scale factors that are compensated exactly leave perfect sensors: the navigation is that of ideal ones.
#[test]
fn known_sensor_errors_are_compensated() {
    let compensation = Compensation {
        gyro_bias: Vector3::new(1.0, -2.0, 3.0) * DEG_PER_HOUR,
        gyro_scale_factor: Vector3::new(1e-3, -2e-3, 3e-3),
        accel_bias: Vector3::new(1e-3, -2e-3, 1e-3) * G,
        accel_scale_factor: Vector3::new(-1e-3, 2e-3, 1e-3),
    };
    let triad = |bias: Vector3<f64>, scale: Vector3<f64>| TriadParameters {
        bias,
        scale_factor: scale,
        ..Default::default()
    };
    let mut worst = 0.0f64;
    for (frame, is_mounted) in [(Frame::EarthFixed, false), (Frame::Geographic, true)] {
        let options =
            Options { frame, error_model: true, vertical: VerticalMode::Free, ..Default::default() };
        let mut simulator = Simulator::new(&options).unwrap();
        if is_mounted {
            simulator
                .set_mounting(&MountingParameters {
                    lever_arm_error_m: Vector3::zeros(),
                    boresight_error: Default::default(),
                    ..mounting()
                })
                .unwrap();
        }
        fly_through(&mut simulator, samples(2));
        let gyro = triad(compensation.gyro_bias, compensation.gyro_scale_factor);
        let accel = triad(compensation.accel_bias, compensation.accel_scale_factor);
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        // In two parts, which are added.
        let mut half = Correction { sensors: compensation, ..Default::default() };
        for value in [&mut half.sensors.gyro_bias, &mut half.sensors.accel_bias] {
            *value *= 0.5;
        }
        simulator.correct(&half).unwrap();
        let rest = Compensation {
            gyro_bias: half.sensors.gyro_bias,
            accel_bias: half.sensors.accel_bias,
            ..Default::default()
        };
        simulator.correct(&Correction { sensors: rest, ..Default::default() }).unwrap();
        assert_eq!(simulator.compensation(), compensation);
        fly_through(&mut simulator, samples(3000).skip(2));
        let imu = simulator.imu().unwrap();
        let [raw, compensated] = [imu.measured, imu.compensated].map(|sum| sum.minus(&imu.ideal));
        assert!(raw.velocity.norm() > 1e-4 && compensated.velocity.norm() < 1e-15, "{compensated:?}");
        for source in [ErrorSource::Navigation, ErrorSource::Model] {
            // A minute of patrol without errors leaves micrometres; with these it would leave more than 10 m.
            let found = errors(&simulator, source).position_n.norm();
            assert!(found < 1e-4, "{source:?}: {found}");
            worst = worst.max(found);
        }
        simulator.reset();
        assert_eq!(simulator.compensation(), Compensation::default());
    }
    println!("figure: {worst:.1e} m (limit 1e-4 m)");
}

fn some_correction(k: usize) -> Correction {
    let one = Vector3::new(1.0, -2.0, 0.5) * (k as f64 + 1.0);
    Correction {
        errors: StateErrors { position_n: one * 10.0, velocity_n: one * 0.1, misalignment_n: one * 1e-4 },
        sensors: Compensation {
            gyro_bias: one * 1e-7,
            gyro_scale_factor: one * 1e-5,
            accel_bias: one * 1e-4,
            accel_scale_factor: one * 1e-5,
        },
    }
}

/// A run that is saved and loaded between corrections continues to the same bits, also on increments.
#[test]
fn a_snapshot_holds_the_corrections() {
    for (options, is_mounted) in modes() {
        let mut simulator = simulator(&options, is_mounted, 1.0);
        let mut loaded = Simulator::new(&Options::default()).unwrap();
        for (k, sample) in samples(60).enumerate() {
            step(&mut simulator, &sample);
            if k % 20 == 10 {
                simulator.correct(&some_correction(k)).unwrap();
            }
            if k == 35 {
                loaded.load_snapshot(&snapshot(&simulator)).unwrap();
                assert!(reads(&loaded) == reads(&simulator));
                assert_eq!(loaded.compensation(), simulator.compensation());
                assert_ne!(loaded.compensation(), Compensation::default());
            }
            if k > 35 {
                step(&mut loaded, &sample);
                if k % 20 == 10 {
                    loaded.correct(&some_correction(k)).unwrap();
                }
            }
        }
        assert!(reads(&loaded) == reads(&simulator), "{options:?}");
        assert!(snapshot(&loaded) == snapshot(&simulator), "{options:?}");
    }
}

/// Each run of an ensemble that is corrected gives the bits of the simulator with its number, and leaves the others alone.
#[test]
fn corrected_runs_equal_corrected_simulators() {
    for (options, is_mounted) in modes() {
        for is_disturbed in [false, true] {
            let make = |run: u64| {
                let mut options = options;
                options.key.run = run;
                let mut simulator = simulator(&options, is_mounted, 1.0);
                let one = Vector3::repeat(1.0);
                let noisy =
                    TriadParameters { bias_sigma: one * 1e-6, random_walk: one * 1e-6, ..Default::default() };
                simulator.set_gyro(&noisy).unwrap();
                if is_disturbed {
                    let anomaly = GravityField { mean: 2e-4, sigma: 1e-4, distance_m: 1e4 };
                    let gravity = GravityDisturbanceParameters { anomaly, ..Default::default() };
                    simulator.set_gravity_disturbance(&gravity).unwrap();
                }
                simulator
            };
            let mut ensemble = Ensemble::new(&make(3), 3, 19).unwrap();
            assert_eq!(ensemble.correct(3, &some_correction(0)).unwrap_err().kind, ErrorKind::BadState);
            let mut alone = [3, 7, 21].map(make);
            for (k, sample) in samples(40).enumerate() {
                ensemble.push_sample(&sample).unwrap();
                ensemble.step().unwrap();
                alone.iter_mut().for_each(|simulator| step(simulator, &sample));
                if k == 10 || k == 25 {
                    for (place, run) in [(1, 7), (2, 21)] {
                        ensemble.correct(run, &some_correction(k)).unwrap();
                        alone[place].correct(&some_correction(k)).unwrap();
                    }
                }
                if k > 0 {
                    for (simulator, run) in alone.iter().zip([3, 7, 21]) {
                        let of_run = (
                            ensemble.navigation(run).unwrap(),
                            ensemble.imu(run).unwrap(),
                            ensemble.errors(run, ErrorSource::Model).unwrap(),
                            ensemble.compensation(run).unwrap(),
                        );
                        let expected = (
                            simulator.navigation().unwrap(),
                            simulator.imu(),
                            simulator.errors(ErrorSource::Model).unwrap(),
                            simulator.compensation(),
                        );
                        assert_eq!(of_run, expected, "run {run}, sample {k}, {options:?}");
                    }
                }
            }
            assert_eq!(
                ensemble.correct(22, &some_correction(0)).unwrap_err().kind,
                ErrorKind::InvalidArgument
            );
            ensemble.reset();
            assert_eq!(ensemble.compensation(7).unwrap(), Compensation::default());
        }
    }
}
