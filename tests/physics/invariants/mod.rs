//! Properties that physics and the conventions demand of any run.

mod closed_loop;
mod refusals;

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::earth::state::BodyAxes;
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{Alignment, AltimeterParameters, InitialErrorParameters, TriadParameters};
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator};

use crate::support::{DEG, DEG_PER_HOUR, G, fly_through, options_at, patrol, resting_sample};

fn errors(simulator: &Simulator) -> sins::errors::NavigationErrors {
    simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1
}

fn resting(rate_hz: f64, seconds: f64) -> impl Iterator<Item = FlightSample> {
    (0..=(seconds * rate_hz) as u64).map(move |k| resting_sample(k as f64 / rate_hz))
}

/// A level error swings with 2π √(R/g) = 84.4 min (R is the north channel's radius; the size of the horizontal vector removes
/// Foucault's turn).
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
    // The speed is smallest at a quarter and at three quarters of the period.
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
    fly_through(&mut simulator, (0..360_000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()));
    let q = simulator.navigation().unwrap().unwrap().navigation.q_nb;
    assert!((q.norm() - 1.0).abs() < 1e-15, "{:e}", q.norm() - 1.0);
}

/// The damped channel estimates and removes an accelerometer bias; it follows a barometer bias.
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
    // Coriolis made a Schuler swing of the climb, 1e-2 m/s; it acts back as 2 W v over the loop's λ² = 1e-4.
    assert!((error.position_n.z - 20.0).abs() < 1.5e-4 * 1e-2 / 1e-4, "{}", error.position_n.z);
    // The bias is estimated and removed; Coriolis, 2 W v of the swing, is within the tolerance.
    assert!(error.velocity_n.z.abs() < 1e-5, "{}", error.velocity_n.z);
    // On the way the bias raised the channel above the barometer.
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
        fly_through(
            &mut simulator,
            (0..60_000).map(|k| flight.sample_at(300.0 + f64::from(k) / 100.0).unwrap()),
        );
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

/// Sensor axes forward-right-down sense the same motion on other axes, and navigate alike.
#[test]
fn both_conventions_of_sensor_axes_navigate_alike() {
    let flight = patrol(1200.0);
    let run = |axes| {
        let mut simulator = Simulator::new(&Options { axes, ..options_at(100.0) }).unwrap();
        fly_through(&mut simulator, (0..3000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()));
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
    fly_through(
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

/// Levelling and gyrocompassing with biased sensors gives the misalignment at which the errors at rest do not grow.
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
    // Level: φ = nabla / g; azimuth: the arc tangent of the levelled rates.
    let north = 7.292_115e-5 * (39.9 * DEG).cos();
    let level = 1e-4 * G / 9.801_6;
    let drift = 0.01 * DEG_PER_HOUR;
    // The levelled rates are those of the gyros and the tilt's share of the upward rate.
    let of_up = (north * (39.9 * DEG).tan() + drift) * level;
    let azimuth = -(drift - of_up).atan2(north + drift + of_up);
    // Level first, then azimuth: in one rotation vector half of their product turns the tilt.
    assert!(
        (error.misalignment_n.xy() - Vector3::repeat(level).xy()).norm() < 1e-8 + level * azimuth.abs(),
        "{}",
        error.misalignment_n
    );
    let off = (error.misalignment_n.z - azimuth).abs();
    assert!(off < 1e-8 + level * level, "{} {azimuth}", error.misalignment_n.z);
    // In balance: after a minute the velocity is that of the north gyro's drift alone, g·eps·t²/2 = 0.9 mm/s. Out of balance
    // 1e-4 g would make it 60 mm/s.
    fly_through(&mut simulator, resting(10.0, 60.0).skip(1));
    assert!(errors(&simulator).velocity_n.xy().norm() < 1.5e-3, "{}", errors(&simulator).velocity_n);
}

/// A gyro that is wrong by more than half a turn an update: the attitude has no meaning, but it keeps its norm.
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
        fly_through(&mut simulator, resting(10.0, 60.0));
        let q = simulator.navigation().unwrap().unwrap().navigation.q_nb;
        assert!((q.norm() - 1.0).abs() < 1e-15, "{scheme:?} {frame:?}: {}", q.norm());
    }
}
