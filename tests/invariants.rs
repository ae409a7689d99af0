//! What physics and the conventions demand of any run.

mod support;

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::flight::{Flight, FlightStart, Manoeuvre};
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{Alignment, AltimeterParameters, InitialErrorParameters, TriadParameters};
use sins::state::BodyAxes;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};
use support::{DEG, DEG_PER_HOUR, G, Reference, options_at, patrol, resting_sample};

fn errors(simulator: &Simulator) -> sins::errors::NavigationErrors {
    simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1
}

/// Flies all of `samples`.
fn fly(simulator: &mut Simulator, samples: impl IntoIterator<Item = FlightSample>) {
    for sample in samples {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
    }
}

fn resting(rate_hz: f64, seconds: f64) -> impl Iterator<Item = FlightSample> {
    (0..=(seconds * rate_hz) as u64).map(move |k| resting_sample(k as f64 / rate_hz))
}

/// A level error swings with 2π √(R/g) = 84.4 min (the north channel's radius, Foucault's turn taken out by the size of the
/// horizontal vector).
#[test]
fn a_velocity_error_swings_with_schulers_period() {
    let mut simulator = Simulator::new(&options_at(10.0)).unwrap();
    let velocity_n = Vector3::new(0.0, 0.1, 0.0);
    simulator.set_initial_errors(&InitialErrorParameters { velocity_n, ..Default::default() }).unwrap();
    let mut minima = Vec::new();
    let mut last = [f64::MAX; 2];
    for sample in resting(10.0, 12_000.0) {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        let speed = errors(&simulator).velocity_n.xy().norm();
        if last[1] < speed && last[1] < last[0] {
            minima.push(sample.time_s);
        }
        last = [last[1], speed];
    }
    // The speed is smallest a quarter and three quarters through.
    let period = 2.0 * (minima[1] - minima[0]);
    let earth = simulator.options().earth();
    let radius = earth.radii((39.9 * DEG).sin()).meridian_m;
    let expected = std::f64::consts::TAU * (radius / 9.8016).sqrt();
    assert!((period / expected - 1.0).abs() < 2e-3, "{period} s of {expected}");
}

#[test]
fn the_attitude_quaternion_keeps_its_norm() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let flight = patrol(3600.0);
    fly(&mut simulator, (0..360_000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()));
    let q = simulator.navigation().unwrap().unwrap().navigation.q_nb;
    assert!((q.norm() - 1.0).abs() < 1e-15, "{:e}", q.norm() - 1.0);
}

/// 1 m of height error grows with cosh(t/τ), τ = 569.3 s; Coriolis, (2 W cos L)² against 2 g/R, takes up to 0.2 % of the rate,
/// over 6.3 of it.
#[test]
fn the_free_vertical_channel_grows_as_theory_says() {
    let options = Options { vertical: VerticalMode::Free, ..options_at(10.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let position_n = Vector3::new(0.0, 0.0, 1.0);
    simulator.set_initial_errors(&InitialErrorParameters { position_n, ..Default::default() }).unwrap();
    let solution = |simulator: &Simulator| simulator.navigation().unwrap().unwrap();
    for (seconds, sample) in resting(10.0, 3600.0).enumerate() {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        if seconds == 36_000 {
            let expected = (3600.0_f64 / 569.3).cosh();
            let height = errors(&simulator).position_n.z;
            assert!((height / expected - 1.0).abs() < 6.3 * 2e-3, "{height} m of {expected}");
        }
    }
    assert!(solution(&simulator).vertical_unaided);
}

/// The diverged solution is refused before it overflows; the last good one stays readable, and a reposition recovers.
#[test]
fn a_diverged_solution_is_refused_and_recovers() {
    let options = Options { vertical: VerticalMode::Free, ..options_at(1.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let position_n = Vector3::new(0.0, 0.0, 1000.0);
    simulator.set_initial_errors(&InitialErrorParameters { position_n, ..Default::default() }).unwrap();
    let mut refused = None;
    for sample in resting(1.0, 40_000.0) {
        simulator.push_sample(&sample).unwrap();
        if let Err(error) = simulator.step() {
            refused = Some((sample, error));
            break;
        }
    }
    let (sample, error) = refused.unwrap();
    assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
    let before = simulator.navigation().unwrap().unwrap();
    assert!(before.navigation.place.height_m.is_finite());
    assert_eq!(simulator.step().unwrap_err().kind, ErrorKind::Diverged);
    assert_eq!(simulator.navigation().unwrap().unwrap(), before, "nothing moved");
    simulator.set_initial_errors(&InitialErrorParameters::default()).unwrap_err();
    simulator.reposition(&sample).unwrap();
    simulator.set_initial_errors(&InitialErrorParameters::default()).unwrap();
    assert!(errors(&simulator).position_n.norm() < 1e-6);
}

/// The damped channel: an accelerometer bias is found and taken out, a barometer bias is followed.
#[test]
fn the_damped_channel_follows_the_barometer_and_finds_the_bias() {
    let options = Options { vertical: VerticalMode::Damped, ..options_at(10.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let bias = Vector3::new(0.0, 0.0, 1e-3 * G);
    simulator.set_accel(&TriadParameters { bias, ..Default::default() }).unwrap();
    simulator.set_altimeter(&AltimeterParameters { bias_m: 20.0, ..Default::default() }).unwrap();
    let mut highest: f64 = 0.0;
    for sample in resting(10.0, 3000.0) {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        highest = highest.max(errors(&simulator).position_n.z);
    }
    let error = errors(&simulator);
    // Coriolis made a Schuler swing of the climb, 1e-2 m/s; it comes back as 2 W v over the loop's λ² = 1e-4.
    assert!((error.position_n.z - 20.0).abs() < 1.5e-4 * 1e-2 / 1e-4, "{}", error.position_n.z);
    // The loop corrects at the end of each interval: there the velocity is half of what the bias makes in one.
    assert!((error.velocity_n.z + 0.5 * bias.z * 0.1).abs() < 1e-5, "{}", error.velocity_n.z);
    // On the way the bias pulled it above the barometer.
    assert!(highest > 25.0, "{highest}");
}

/// Small errors add up: the response to two of them is the sum of the responses.
#[test]
fn small_errors_superpose() {
    let bias = |gyro: f64, accel: f64| {
        let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
        let parameters = |value: f64| TriadParameters {
            bias: Vector3::new(value, -value, 0.5 * value),
            ..Default::default()
        };
        simulator.set_gyro(&parameters(gyro)).unwrap();
        simulator.set_accel(&parameters(accel)).unwrap();
        let flight = patrol(1200.0);
        fly(&mut simulator, (0..60_000).map(|k| flight.sample_at(300.0 + f64::from(k) / 100.0).unwrap()));
        errors(&simulator)
    };
    let (gyro, accel) = (0.1 * DEG_PER_HOUR, 1e-4 * G);
    let both = bias(gyro, accel);
    let (first, second) = (bias(gyro, 0.0), bias(0.0, accel));
    let sum = first.position_n + second.position_n;
    // Products of the two: misalignment of 1e-4 rad times displacement.
    let bound = 2.0 * first.misalignment_n.norm().max(second.misalignment_n.norm()) * sum.norm() + 1e-6;
    assert!((both.position_n - sum).norm() < bound, "{} {sum}", both.position_n);
    assert!(sum.norm() > 50.0);
}

/// The pole, passed exactly and by 30 m: position errors like anywhere else. Geographic axes refuse in time.
#[test]
fn the_pole_is_passed_like_anywhere_else() {
    let samples = Reference::load("polar").truth.samples(false);
    let options = Options { vertical: VerticalMode::FollowTruth, ..options_at(20.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let mut near_pole = 0;
    for sample in &samples {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        let error = errors(&simulator);
        assert!(error.position_n.norm() < 1e-4, "{}: {}", sample.time_s, error.position_n);
        near_pole += u64::from(simulator.navigation().unwrap().unwrap().near_pole);
    }
    // 20 km to either side at 250 m/s, 20 Hz.
    assert!((near_pole as f64 / 3200.0 - 1.0).abs() < 0.05, "{near_pole}");

    let mut geographic = Simulator::new(&Options { frame: Frame::Geographic, ..options }).unwrap();
    let refused = samples.iter().find_map(|sample| {
        geographic.push_sample(sample).unwrap();
        geographic.step().err().map(|error| (sample, error))
    });
    let (sample, error) = refused.unwrap();
    assert_eq!(error.kind, ErrorKind::Singular, "{error}");
    // The geographic axes were still right when they gave up, 6.4 km from the pole.
    assert!(((90.0 * DEG - sample.place.latitude_rad) * 6.4e6 - 6.4e3).abs() < 50.0);
    assert!(errors(&geographic).position_n.norm() < 1e-3, "{}", errors(&geographic).position_n);
}

#[test]
fn a_great_circle_past_the_pole_keeps_its_accuracy_at_every_distance() {
    for past_m in [30.0, 1.0, 1e-3] {
        let start = FlightStart {
            latitude_rad: 89.0 * DEG,
            height_m: 9000.0,
            speed_m_s: 250.0,
            // Aimed past the pole by the angle over the way to it.
            heading_rad: past_m / 111_694.0,
            ..Default::default()
        };
        let flight = Flight::new(&start, &[Manoeuvre::Straight { duration_s: 900.0 }]).unwrap();
        let mut simulator = Simulator::new(&options_at(50.0)).unwrap();
        let mut closest = f64::MAX;
        for k in 0..=45_000 {
            let sample = flight.sample_at(f64::from(k) / 50.0).unwrap();
            closest = closest.min((90.0 * DEG - sample.place.latitude_rad) * 6.4e6);
            simulator.push_sample(&sample).unwrap();
            simulator.step().unwrap();
        }
        assert!(closest < past_m + 3.0);
        assert!(errors(&simulator).position_n.norm() < 1e-5, "{past_m}: {}", errors(&simulator).position_n);
    }
}

/// Sensor axes forward-right-down sense the same motion on other axes, and navigate alike.
#[test]
fn both_conventions_of_sensor_axes_navigate_alike() {
    let flight = patrol(1200.0);
    let run = |axes| {
        let mut simulator = Simulator::new(&Options { axes, ..options_at(100.0) }).unwrap();
        fly(&mut simulator, (0..3000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()));
        (simulator.imu().unwrap().ideal, simulator.navigation().unwrap().unwrap().navigation)
    };
    let (rfu, first) = run(BodyAxes::RightForwardUp);
    let (frd, second) = run(BodyAxes::ForwardRightDown);
    let exchanged = |v: Vector3<f64>| Vector3::new(v.y, v.x, -v.z);
    assert!((rfu.angle - exchanged(frd.angle)).norm() < 1e-15);
    assert!((rfu.velocity - exchanged(frd.velocity)).norm() < 1e-13);
    assert!(rfu.velocity.z > 0.09, "up feels gravity");
    assert!((first.euler.heading - second.euler.heading).abs() < 1e-12);
    assert!((first.place.latitude_rad - second.place.latitude_rad).abs() < 1e-15);
}

/// At rest perfect gyros sense the Earth's rate and perfect accelerometers gravity upward.
#[test]
fn perfect_sensors_at_rest_sense_the_earth() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let place = Geodetic { latitude_rad: 30.0 * DEG, longitude_rad: 1.0, height_m: 0.0 };
    fly(
        &mut simulator,
        (0..10).map(|k| FlightSample::at_rest(f64::from(k) / 100.0, place, Euler::default())),
    );
    let imu = simulator.imu().unwrap();
    let rate = imu.ideal.angle / imu.interval_s;
    let w = 7.292_115e-5;
    let error = rate - Vector3::new(0.0, w * (30.0 * DEG).cos(), w * 0.5);
    assert!(error.norm() < 1e-19, "{error}");
    let force = imu.ideal.velocity / imu.interval_s;
    // Somigliana at 30°.
    assert!((force - Vector3::new(0.0, 0.0, 9.793_247_2)).norm() < 1e-6, "{force}");
}

/// Only positions: velocity follows from them, and the flight still closes.
#[test]
fn a_log_without_velocities_closes() {
    let flight = patrol(1200.0);
    let mut simulator = Simulator::new(&options_at(50.0)).unwrap();
    let samples = (0..=30_000).map(|k| {
        let sample = flight.sample_at(300.0 + f64::from(k) / 50.0).unwrap();
        FlightSample { v_n: None, ..sample }
    });
    fly(&mut simulator, samples);
    let error = errors(&simulator);
    // The first two velocities are means over an interval: T/2 of the acceleration, 5 m/s², once.
    assert!(error.velocity_n.norm() < 0.06, "{}", error.velocity_n);
    // Against the true velocity too.
    let truth = flight.sample_at(900.0).unwrap();
    let navigated = simulator.navigation().unwrap().unwrap().navigation;
    assert!((navigated.v_n - truth.v_n.unwrap()).norm() < 0.06);
    assert!(error.position_n.norm() < 0.06 * 600.0);
}

/// Stamps that jitter by a third of the interval, a lost sample of ten, longitudes beyond π: the physics is the same.
#[test]
fn irregular_samples_close_as_regular_ones() {
    let flight = patrol(1200.0);
    let options = Options { vertical: VerticalMode::FollowTruth, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    for k in 0..60_000_u32 {
        if k % 10 == 7 {
            continue;
        }
        let jitter = (f64::from(k * 7919 % 100) / 100.0 - 0.5) * 0.0066;
        let mut sample = flight.sample_at(300.01 + f64::from(k) / 100.0 + jitter).unwrap();
        sample.place.longitude_rad += if k % 2 == 0 { 0.0 } else { std::f64::consts::TAU };
        sample.euler.heading -= if k % 3 == 0 { std::f64::consts::TAU } else { 0.0 };
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
    }
    assert!(errors(&simulator).position_n.norm() < 1e-5, "{}", errors(&simulator).position_n);
    assert!(errors(&simulator).velocity_n.norm() < 1e-7);
}

/// Across the date line, both ways.
#[test]
fn the_date_line_is_no_line() {
    for heading_rad in [90.0 * DEG, 270.0 * DEG] {
        let start = FlightStart {
            longitude_rad: std::f64::consts::PI - 0.001 * heading_rad.sin(),
            latitude_rad: 0.3,
            speed_m_s: 250.0,
            heading_rad,
            ..Default::default()
        };
        let flight = Flight::new(&start, &[Manoeuvre::Straight { duration_s: 60.0 }]).unwrap();
        let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
        fly(&mut simulator, (0..=6000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()));
        let truth = simulator.truth().unwrap().unwrap().navigation.place;
        assert!((truth.longitude_rad.signum() - heading_rad.sin().signum()).abs() > 1.0, "it was crossed");
        assert!(errors(&simulator).position_n.norm() < 1e-7);
        assert!(errors(&simulator).longitude_rad.abs() < 1e-14);
    }
}

/// Levelling and gyrocompassing with biased sensors: the misalignment that holds the errors at rest still.
#[test]
fn an_alignment_with_the_sensors_leaves_them_balanced() {
    let mut simulator = Simulator::new(&options_at(10.0)).unwrap();
    let gyro = TriadParameters { bias: Vector3::repeat(0.01 * DEG_PER_HOUR), ..Default::default() };
    let accel = TriadParameters { bias: Vector3::new(1e-4 * G, -1e-4 * G, 0.0), ..Default::default() };
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    let initial = InitialErrorParameters { alignment: Alignment::LevelAndGyrocompass, ..Default::default() };
    simulator.set_initial_errors(&initial).unwrap();
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let error = errors(&simulator);
    // Level: φ = nabla / g; azimuth: the east gyro over the Earth's horizontal rate, and the level error's share.
    let north = 7.292_115e-5 * (39.9 * DEG).cos();
    let level = 1e-4 * G / 9.801_6;
    assert!(
        (error.misalignment_n.xy() - Vector3::repeat(level).xy()).norm() < 1e-8,
        "{}",
        error.misalignment_n
    );
    let azimuth = -0.01 * DEG_PER_HOUR / north + (39.9 * DEG).tan() * level;
    assert!((error.misalignment_n.z - azimuth).abs() < 1e-8, "{} {azimuth}", error.misalignment_n.z);
    // In balance: after a minute the velocity is that of the north gyro's drift alone, g·eps·t²/2 = 0.9 mm/s; out of
    // balance 1e-4 g would make 60 mm/s of it.
    fly(&mut simulator, resting(10.0, 60.0).skip(1));
    assert!(errors(&simulator).velocity_n.xy().norm() < 1.5e-3, "{}", errors(&simulator).velocity_n);
}

#[test]
fn navigation_alone_and_flight_do_not_mix() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    assert_eq!(simulator.step().unwrap(), Step::NeedSample);
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let start = simulator.truth().unwrap().unwrap().navigation;
    assert_eq!(simulator.start_navigation(0.0, &start).unwrap_err().kind, ErrorKind::BadState);
    simulator.reset();
    simulator.start_navigation(0.0, &start).unwrap();
    assert_eq!(simulator.push_sample(&resting_sample(0.0)).unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(simulator.errors(ErrorSource::Navigation).unwrap_err().kind, ErrorKind::BadState);
    assert!(simulator.navigation().unwrap().unwrap().vertical_unaided);
}

/// A gyro that is wrong by more than half a turn an update: the attitude is nonsense, but remains one.
#[test]
fn turns_beyond_half_a_turn_an_update_keep_the_norm() {
    for (scheme, frame) in [
        (Scheme::Exact, Frame::EarthFixed),
        (Scheme::Exact, Frame::Geographic),
        (Scheme::Paper, Frame::EarthFixed),
    ] {
        let mut simulator = Simulator::new(&Options { scheme, frame, ..Default::default() }).unwrap();
        let bias = Vector3::new(50.0, 0.0, 0.0);
        simulator.set_gyro(&TriadParameters { bias, ..Default::default() }).unwrap();
        fly(&mut simulator, resting(10.0, 60.0));
        let q = simulator.navigation().unwrap().unwrap().navigation.q_nb;
        assert!((q.norm() - 1.0).abs() < 1e-15, "{scheme:?} {frame:?}: {}", q.norm());
    }
}

/// A step beyond the limits is refused before anything has changed: the solution, and the draws of its noise.
#[test]
fn a_step_out_of_range_is_not_made() {
    let wild = TriadParameters {
        bias: Vector3::new(0.0, 0.0, 1e4),
        random_walk: Vector3::repeat(1.0),
        ..Default::default()
    };
    let mut simulator =
        Simulator::new(&Options { vertical: VerticalMode::Free, ..Default::default() }).unwrap();
    simulator.set_accel(&wild).unwrap();
    let mut samples = resting(1.0, 1000.0);
    let error = loop {
        simulator.push_sample(&samples.next().unwrap()).unwrap();
        if let Err(error) = simulator.step() {
            break error;
        }
    };
    assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
    let before = (simulator.navigation().unwrap(), simulator.imu(), simulator.accuracy().unwrap());
    assert!(before.0.unwrap().navigation.v_n.norm() < 100e3);
    assert_eq!(simulator.step(), Err(error), "and again");
    assert_eq!((simulator.navigation().unwrap(), simulator.imu(), simulator.accuracy().unwrap()), before);

    // The refused steps drew nothing: another simulator that never tried has the same noise from here on.
    let mut other = Simulator::new(simulator.options()).unwrap();
    other.set_accel(&wild).unwrap();
    fly(&mut other, resting(1.0, simulator.intervals() as f64));
    assert_eq!(other.intervals(), simulator.intervals());
    for simulator in [&mut simulator, &mut other] {
        simulator.reposition(&resting(1.0, 1.0).next().unwrap()).unwrap();
        fly(simulator, resting(1.0, 3.0).skip(1));
    }
    assert_eq!(simulator.imu(), other.imu());
}

/// A first step that cannot be made leaves the simulator before its first step.
#[test]
fn a_refused_first_step_leaves_the_start_open() {
    let options = Options { frame: Frame::Geographic, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    let near_pole = |time_s: f64, latitude_rad: f64| FlightSample {
        place: Geodetic { latitude_rad, longitude_rad: 0.0, height_m: 0.0 },
        ..resting(1.0, 1.0).next().map(|sample| FlightSample { time_s, ..sample }).unwrap()
    };
    let limit = core::f64::consts::FRAC_PI_2 - 1e-3;
    simulator.push_sample(&near_pole(0.0, limit - 1e-6)).unwrap();
    simulator.push_sample(&near_pole(1.0, limit + 1e-6)).unwrap();
    assert_eq!(simulator.step().unwrap_err().kind, ErrorKind::Singular);
    assert!(!simulator.has_started());
    simulator.set_initial_errors(&InitialErrorParameters::default()).unwrap();
}

/// The loop's gains are those of its poles in steps of any length.
#[test]
fn the_damped_channel_is_stable_at_any_interval() {
    for interval_s in [1.0, 20.0, 60.0, 300.0] {
        let intake = IntakeLimits { max_gap_s: interval_s, ..Default::default() };
        let mut simulator = Simulator::new(&Options { intake, ..Default::default() }).unwrap();
        let position_n = Vector3::new(0.0, 0.0, 10.0);
        simulator.set_initial_errors(&InitialErrorParameters { position_n, ..Default::default() }).unwrap();
        fly(&mut simulator, resting(1.0 / interval_s, 100.0 * interval_s.max(100.0)));
        let height = errors(&simulator).position_n.z;
        assert!(height.abs() < 1e-3, "{interval_s} s: {height} m");
    }
}

/// The trim is that of an error-free navigator: neither sensor errors nor when they come can move it, to the bit; and what it
/// adds to the errors of the sensors is nothing.
#[test]
fn the_closed_loop_does_not_see_the_sensors() {
    let flight = patrol(600.0);
    let samples = || (0..=60_000).map(|k| flight.sample_at(f64::from(k) * 0.01).unwrap());
    let (gyro, accel) = sins::sensors::paper_simulation2();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let physical = Options { frame, ..options_at(100.0) };
        let closed = Options { closed_loop_time_s: Some(30.0), ..physical };
        let fly_with_errors_from = |options: &Options, from: Option<usize>| {
            let mut simulator = Simulator::new(options).unwrap();
            for (k, sample) in samples().enumerate() {
                if from == Some(k) {
                    simulator.set_gyro(&gyro).unwrap();
                    simulator.set_accel(&accel).unwrap();
                }
                simulator.push_sample(&sample).unwrap();
                simulator.step().unwrap();
            }
            (simulator.trim().unwrap().unwrap(), errors(&simulator))
        };
        let (ideal, _) = fly_with_errors_from(&closed, None);
        assert!(ideal.force_m_s2 > 0.0 && ideal.rate_rad_s < 1e-12, "{frame:?} {ideal:?}");
        for from in [0, 30_000] {
            let (trim, closed) = fly_with_errors_from(&closed, Some(from));
            let (none, physical) = fly_with_errors_from(&physical, Some(from));
            assert_eq!((trim, none), (ideal, sins::TrimFigures::default()), "{frame:?} {from}");
            let difference = (closed.position_n - physical.position_n).norm();
            assert!(difference < 1e-5, "{frame:?} {from}: {difference} m of {}", physical.position_n.norm());
        }
    }
}

#[test]
fn the_time_constant_of_the_closed_loop_is_checked() {
    for (closed_loop_time_s, max_gap_s) in [(0.5, 0.1), (2e4, 0.1), (9.9, 2.5), (f64::NAN, 0.1)] {
        let intake = IntakeLimits { max_gap_s, ..Default::default() };
        let closed_loop_time_s = Some(closed_loop_time_s);
        let error =
            Simulator::new(&Options { closed_loop_time_s, intake, ..Default::default() }).unwrap_err();
        assert_eq!((error.kind, error.field), (ErrorKind::InvalidArgument, "options.closed_loop_time_s"));
    }
}
