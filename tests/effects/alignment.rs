//! Levelling and gyrocompassing with sensors of any quality. The attitude is level to rounding, the heading is the arc tangent
//! of the levelled rates, and an alignment that could not find north is flagged.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use sins::earth::state::BodyAxes;
use sins::earth::{Earth, Geodetic};
use sins::math::{Euler, rotation_quaternion, wrap_angle};
use sins::mechanization::VerticalMode;
use sins::sensors::{
    Alignment, Grade, GravityDisturbanceParameters, GravityField, InitialErrorParameters, StreamKey,
    TriadParameters,
};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator, Solution};

use crate::support::{DEG, DEG_PER_HOUR, G, options_at, resting_sample};

const ALIGNED: InitialErrorParameters = InitialErrorParameters {
    position_n: Vector3::new(0.0, 0.0, 0.0),
    velocity_n: Vector3::new(0.0, 0.0, 0.0),
    misalignment_n: Vector3::new(0.0, 0.0, 0.0),
    position_sigma_n: Vector3::new(0.0, 0.0, 0.0),
    velocity_sigma_n: Vector3::new(0.0, 0.0, 0.0),
    misalignment_sigma_n: Vector3::new(0.0, 0.0, 0.0),
    alignment: Alignment::LevelAndGyrocompass,
    alignment_s: 0.0,
};

const RATE_HZ: f64 = 100.0;

/// Simulator with the given gyros, accelerometers and initial errors.
fn simulator(gyro: &TriadParameters, accel: &TriadParameters, initial: &InitialErrorParameters) -> Simulator {
    keyed(StreamKey::default(), gyro, accel, initial)
}

fn keyed(
    key: StreamKey,
    gyro: &TriadParameters,
    accel: &TriadParameters,
    initial: &InitialErrorParameters,
) -> Simulator {
    let options = Options { key, error_model: true, ..options_at(RATE_HZ) };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
    simulator.set_initial_errors(initial).unwrap();
    simulator
}

fn biased(x: f64, y: f64, z: f64) -> TriadParameters {
    TriadParameters { bias: Vector3::new(x, y, z), ..Default::default() }
}

/// Gyros with these biases along east, north and up [°/h].
fn gyros(east: f64, north: f64, up: f64) -> TriadParameters {
    biased(east * DEG_PER_HOUR, north * DEG_PER_HOUR, up * DEG_PER_HOUR)
}

fn navigation(simulator: &Simulator) -> Solution {
    simulator.navigation().unwrap().unwrap()
}

/// The solution of the start on `sample`.
fn start(simulator: &mut Simulator, sample: &FlightSample) -> Solution {
    simulator.push_sample(sample).unwrap();
    navigation(simulator)
}

/// Horizontal acceleration that the navigator, started on `sample` at rest, computes in the second interval [m/s²], and its
/// bound. Until then two errors turn the level: the gyro error and the Earth rates that the navigator subtracts. (In the first
/// interval the velocity of a lever arm jumps by the gyro error.)
fn horizontal(simulator: &mut Simulator, sample: &FlightSample) -> (f64, f64) {
    let velocities = [0.0, 1.0, 2.0].map(|k| {
        simulator.push_sample(&FlightSample { time_s: sample.time_s + k / RATE_HZ, ..*sample }).unwrap();
        simulator.step().unwrap();
        simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.velocity_n
    });
    let imu = simulator.imu().unwrap();
    let turn = (imu.measured.angle - imu.ideal.angle).norm() + 2.0 * Earth::default().rate_rad_s / RATE_HZ;
    let force = imu.measured.velocity.norm() * RATE_HZ;
    let acceleration = (velocities[2] - velocities[1]).xy().norm() * RATE_HZ;
    // Rounding of velocities of the size of the Earth's own, 500 m/s.
    (acceleration, 1.5 * turn * force + 4.0 * f64::EPSILON * 500.0 * RATE_HZ)
}

/// Horizontal part of the force that the accelerometers of `simulator` sense at rest [m/s²], and its bound from rounding. The
/// attitude is that found by the start on `sample` at height 0.
fn sensed_horizontally(simulator: &mut Simulator, sample: &FlightSample) -> (f64, f64) {
    let q_nb = UnitQuaternion::new_unchecked(start(simulator, sample).navigation.q_nb);
    simulator.push_sample(&FlightSample { time_s: sample.time_s + 1.0 / RATE_HZ, ..*sample }).unwrap();
    simulator.step().unwrap();
    let imu = simulator.imu().unwrap();
    let force = imu.measured.velocity / imu.interval_s;
    ((q_nb * force).xy().norm(), 32.0 * f64::EPSILON * (force.norm() + G))
}

/// A vehicle at rest that is not level.
fn askew() -> FlightSample {
    let euler = Euler { roll: 0.4, pitch: -0.2, heading: 2.0 };
    FlightSample { euler, ..resting_sample(0.0) }
}

#[test]
fn gyros_of_any_size_leave_no_horizontal_force() {
    let (mut worst, mut limit) = (0.0, f64::MAX);
    for sample in [resting_sample(0.0), askew()] {
        for east in [0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 3e4] {
            for accel in
                [biased(1e-3 * G, 0.0, 0.0), biased(0.0, 1e-3 * G, -2e-3 * G), biased(3.0, -5.0, 1.0)]
            {
                let gyro = gyros(east, -0.3 * east, 0.2 * east);
                let (sensed, rounding) =
                    sensed_horizontally(&mut simulator(&gyro, &accel, &ALIGNED), &sample);
                let (found, bound) = horizontal(&mut simulator(&gyro, &accel, &ALIGNED), &sample);
                println!("{east} °/h, accelerometers {:.3} m/s²: {sensed:.1e} m/s²", accel.bias.norm());
                assert!(sensed < rounding, "{east} °/h: {sensed:e} m/s², bound {rounding:e}");
                assert!(found < bound, "{east} °/h: {found:e} m/s², bound {bound:e}");
                if sensed / rounding > worst / limit {
                    (worst, limit) = (sensed, rounding);
                }
            }
        }
    }
    println!("figure: {worst:.1e} m/s² (limit {limit:.1e} m/s²)");
}

/// Drawn biases and scatter of each grade, in 64 runs. An alignment averages noise out and lets a filter settle; one interval
/// does neither, so noise and filters are switched off.
#[test]
fn grades_are_level() {
    const RUNS: u64 = 64;
    let mut flagged = Vec::new();
    for grade in [Grade::Strategic, Grade::Navigation, Grade::Tactical, Grade::Industrial, Grade::Consumer] {
        // Flicker wanders within an interval; a drawn bias of its standard deviation does not.
        let steady = |triad: TriadParameters| TriadParameters {
            bias_sigma: triad.bias_sigma + triad.flicker * (6.5 * 10f64.ln() / PI).sqrt(),
            flicker: Vector3::zeros(),
            random_walk: Vector3::zeros(),
            bandwidth_hz: Vector3::zeros(),
            ..triad
        };
        let (gyro, accel) = grade.parameters();
        let (gyro, accel) = (steady(gyro), steady(accel));
        let (mut squares, mut unknown) = (0.0, 0);
        for run in 0..RUNS {
            let mut simulator = keyed(StreamKey { seed: 12, run }, &gyro, &accel, &ALIGNED);
            let (found, bound) = sensed_horizontally(&mut simulator, &askew());
            assert!(found < bound, "{grade:?}, run {run}: {found:e} m/s², bound {bound:e}");
            squares += found * found / RUNS as f64;
            unknown += u32::from(navigation(&simulator).north_unknown);
        }
        let mg = squares.sqrt() / G * 1e3;
        println!("{grade:?}: {mg:.1e} mg rms horizontally, {unknown} of {RUNS} did not find north");
        if unknown > 0 {
            let name = format!("{grade:?}").to_lowercase();
            flagged.push(format!("{unknown} of {RUNS} {name}"));
        }
    }
    println!("figure: {} runs flagged", flagged.join(" and "));
}

/// Gravity with a deflection, a height at which normal gravity itself leans, and a block that is displaced and turned: the
/// accelerometers sense what the solution expects of normal gravity at their place.
#[test]
fn gravity_and_mounting_are_levelled_with() {
    let field = |mean| GravityField { mean, ..Default::default() };
    let gravity = GravityDisturbanceParameters {
        deflection_north: field(3e-4),
        deflection_east: field(-2e-4),
        anomaly: field(1e-3),
    };
    let mounting = MountingParameters {
        lever_arm_m: Vector3::new(30.0, -20.0, 5.0),
        boresight: Euler { roll: 0.1, pitch: -0.3, heading: 1.0 },
        ..Default::default()
    };
    let place = Geodetic { height_m: 9000.0, ..resting_sample(0.0).place };
    for mounting in [MountingParameters::default(), mounting] {
        let mut simulator = simulator(&gyros(8.0, 2.0, -4.0), &biased(0.02, -0.03, 0.01), &ALIGNED);
        simulator.set_gravity_disturbance(&gravity).unwrap();
        simulator.set_mounting(&mounting).unwrap();
        let (found, bound) = horizontal(&mut simulator, &FlightSample { place, ..askew() });
        // The lean of normal gravity is 8e-6 at 9 km; the force is too long by a 300th. With an arm, gyro errors make a
        // velocity of the arm and turn this velocity with the level.
        let lean = 8e-6 / 300.0 * G;
        let error =
            simulator.imu().map(|imu| (imu.measured.angle - imu.ideal.angle).norm() * RATE_HZ).unwrap();
        let arm = mounting.lever_arm_m.norm() * error * (error + 2.0 * Earth::default().rate_rad_s);
        println!("{found:.1e} m/s², bound {:.1e}", bound + lean + arm);
        assert!(found < bound + lean + arm, "{found:e} m/s², bound {:e}", bound + lean + arm);
    }
}

/// Attitude matrix from two sensed vectors: up is along the force, east is along the cross product of the rate and up.
fn of_two_vectors(force_b: &Vector3<f64>, rate_b: &Vector3<f64>) -> Matrix3<f64> {
    let up = force_b.normalize();
    let east = rate_b.cross(&up).normalize();
    Matrix3::from_rows(&[east.transpose(), up.cross(&east).transpose(), up.transpose()])
}

/// At height 0, where normal gravity is along up, the attitude is that of the matrix of the sensed vectors.
#[test]
fn the_attitude_is_that_of_the_sensed_vectors() {
    let earth = Earth::default();
    for sample in [resting_sample(0.0), askew()] {
        for (gyro, accel) in [
            (gyros(0.01, -0.02, 0.03), biased(1e-3, 2e-3, -1e-3)),
            (gyros(3.0, 1.0, -2.0), biased(1e-2, -1e-2, 5e-2)),
            (gyros(30.0, -40.0, 10.0), biased(3.0, 4.0, -5.0)),
            (gyros(-2e4, 1e4, 3e4), biased(-8.0, 2.0, -25.0)),
        ] {
            let mut simulator = simulator(&gyro, &accel, &ALIGNED);
            let q_nb = start(&mut simulator, &sample).navigation.q_nb;
            let truth = simulator.truth().unwrap().unwrap().navigation;
            let true_bn = UnitQuaternion::new_unchecked(truth.q_nb).inverse();
            let state = truth.earth_fixed(&earth);
            let force = -(UnitQuaternion::new_unchecked(state.q_eb).inverse() * earth.gravity(&state.r_e));
            let (sin, cos) = truth.place.latitude_rad.sin_cos();
            let rate = true_bn * (Vector3::new(0.0, cos, sin) * earth.rate_rad_s);
            let expected = of_two_vectors(&(force + accel.bias), &(rate + gyro.bias));
            let found = UnitQuaternion::new_unchecked(q_nb).to_rotation_matrix();
            // Rounding is larger where the rate is nearly along the force: 4 times at the most.
            assert!((found.matrix() - expected).amax() < 1e-14, "{} {expected}", found.matrix());
        }
    }
}

/// Level, heading north, gyro biases alone: the heading error is -atan2(east, W cos L + north). It is below 90° while the
/// horizontal gyro error is below W cos L, and the solution is flagged where it is not.
#[test]
fn the_heading_is_the_arc_tangent_and_flagged_where_it_may_be_any() {
    let north_rate = Earth::default().rate_rad_s * (39.9 * DEG).cos();
    let mut flagged = 0;
    for size in [0.0, 0.1, 0.9, 0.999, 1.001, 1.5, 1.999, 2.001, 1e3] {
        for direction in 0..12 {
            let (sin, cos) = (f64::from(direction) * 30.0 * DEG + 0.1).sin_cos();
            let (east, north) = (size * north_rate * sin, size * north_rate * cos);
            let mut simulator =
                simulator(&biased(east, north, 5.0 * north_rate), &Default::default(), &ALIGNED);
            let solution = start(&mut simulator, &resting_sample(0.0));
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            let expected = -east.atan2(north_rate + north);
            // Where bias and Earth rate nearly cancel, the direction of their sum has 1e3 times the rounding.
            let off = wrap_angle(errors.heading_rad - expected);
            assert!(off.abs() < 1e-12, "{} {expected}", errors.heading_rad);
            assert!(solution.north_unknown || expected.abs() < 90.0 * DEG, "{expected}");
            assert_eq!(solution.north_unknown, size > 1.0, "{size} in direction {direction}");
            flagged += u32::from(solution.north_unknown);
        }
    }
    assert_eq!(flagged, 5 * 12);
}

/// To first order φ = (-nabla_n/g, nabla_e/g, tan L nabla_e/g - eps_e/(W cos L)). The second order is the product of the rotations,
/// and in the heading also the products of the gyro errors with the heading error and with the tilt.
#[test]
fn small_errors_follow_the_linear_law_to_second_order() {
    let earth = Earth::default();
    let sample = resting_sample(0.0);
    let g = earth.gravity(&earth.to_earth_fixed(&sample.place)).norm();
    let (sin, cos) = sample.place.latitude_rad.sin_cos();
    let (north, up) = (earth.rate_rad_s * cos, earth.rate_rad_s * sin);
    for size in [1e-2, 1e-3, 1e-4, 1e-6] {
        let (eps, nabla) =
            (Vector3::new(0.5, 0.3, -0.4) * north * size, Vector3::new(0.3, -0.5, 0.4) * g * size);
        let mut simulator =
            simulator(&biased(eps.x, eps.y, eps.z), &biased(nabla.x, nabla.y, nabla.z), &ALIGNED);
        start(&mut simulator, &sample);
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        let level = Vector3::new(-nabla.y / g, nabla.x / g, 0.0);
        let linear = level + Vector3::z() * ((up * level.y - eps.x) / north);
        let (largest, off) = (linear.norm() + eps.norm() / north, (errors.misalignment_n - linear).norm());
        println!("{size:e}: {:.3e} rad, off the linear law by {off:.1e} rad", linear.norm());
        assert!(off < 2.0 * largest * largest + 1e-15, "{off:e}");
        assert!(size < 1e-3 || off > 0.01 * largest * largest, "{off:e}: no second order is left to be seen");
    }
}

/// Each given misalignment, also a large one, is relative to the attitude that the alignment finds.
#[test]
fn a_given_misalignment_is_one_of_the_aligned_attitude() {
    let (gyro, accel) = (gyros(12.0, -3.0, 5.0), biased(0.5, -0.3, 0.1));
    let aligned = start(&mut simulator(&gyro, &accel, &ALIGNED), &askew()).navigation.q_nb;
    for given in [Vector3::new(1e-3, -2e-3, 3e-3), Vector3::new(0.5, -1.0, 2.0), Vector3::new(0.0, 0.0, 3.1)]
    {
        let initial = InitialErrorParameters { misalignment_n: given, ..ALIGNED };
        let found = start(&mut simulator(&gyro, &accel, &initial), &askew()).navigation.q_nb;
        let expected: Quaternion<f64> = rotation_quaternion(&-given) * aligned;
        let off = (found - expected).norm().min((found + expected).norm());
        assert!(off < 1e-14, "{found} {expected}");
    }
}

/// The flag stays until a reset or a reposition with better sensors, also in a snapshot. It is never set without gyrocompassing.
#[test]
fn the_flag_stays_as_long_as_the_alignment() {
    let (poor, good) = (gyros(40.0, 0.0, 0.0), gyros(0.1, 0.0, 0.0));
    let ideal = TriadParameters::default();
    let mut flying = simulator(&poor, &ideal, &ALIGNED);
    assert!(start(&mut flying, &resting_sample(0.0)).north_unknown);
    for k in 1..5 {
        flying.push_sample(&resting_sample(f64::from(k) / RATE_HZ)).unwrap();
        flying.step().unwrap();
        assert!(navigation(&flying).north_unknown && !flying.truth().unwrap().unwrap().north_unknown);
    }
    flying.set_gyro(&good).unwrap();
    let mut bytes = vec![0; flying.snapshot_size()];
    flying.save_snapshot(&mut bytes).unwrap();
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&bytes).unwrap();
    for simulator in [&mut flying, &mut loaded] {
        assert!(navigation(simulator).north_unknown, "better gyros in flight find no north");
        simulator.reposition(&resting_sample(10.0)).unwrap();
        assert!(!navigation(simulator).north_unknown);
    }
    let given = InitialErrorParameters { alignment: Alignment::Given, ..ALIGNED };
    assert!(!start(&mut simulator(&poor, &ideal, &given), &resting_sample(0.0)).north_unknown);
}

/// Sensors that sense nothing of the Earth: its rate is within the gyros' dead zone, its gravity within the accelerometers'.
#[test]
fn sensors_that_show_nothing_find_nothing() {
    let dead = |zone: f64| TriadParameters { dead_zone: Vector3::repeat(zone), ..Default::default() };
    let ideal = TriadParameters::default();
    for sample in [resting_sample(0.0), askew()] {
        for (gyro, accel) in [(dead(1e-3), ideal), (ideal, dead(20.0)), (dead(1e-3), dead(20.0))] {
            let mut simulator = simulator(&gyro, &accel, &ALIGNED);
            let solution = start(&mut simulator, &sample);
            assert!(solution.north_unknown);
            assert!(solution.navigation.q_nb.coords.iter().all(|part| part.is_finite()));
        }
    }
    // A bias that cancels more than gravity: the alignment is level, but upside down.
    let mut upside_down = simulator(&ideal, &biased(0.0, 0.0, -3.0 * G), &ALIGNED);
    let solution = start(&mut upside_down, &resting_sample(0.0));
    let up_n = UnitQuaternion::new_unchecked(solution.navigation.q_nb) * -Vector3::z();
    // The heading of the upside-down attitude is the opposite one.
    assert!(solution.north_unknown && (up_n - Vector3::z()).norm() < 8.0 * f64::EPSILON, "{up_n}");
}

/// Ideal sensors find the truth to the bit.
#[test]
fn ideal_sensors_find_the_truth() {
    for sample in [resting_sample(0.0), askew()] {
        let ideal = TriadParameters::default();
        let found = start(&mut simulator(&ideal, &ideal, &ALIGNED), &sample);
        assert_eq!(found, start(&mut simulator(&ideal, &ideal, &Default::default()), &sample));
    }
}

/// Error data 1 starts from the same errors as error data 2. Within its validity both agree to second order; outside it is flagged.
#[test]
fn the_error_model_starts_from_the_same_errors_and_is_flagged_beyond_its_validity() {
    for (east, is_valid) in
        [(0.01, true), (0.1, true), (0.3, true), (1.0, false), (10.0, false), (100.0, false)]
    {
        let mut simulator = simulator(&gyros(east, 0.0, 0.0), &biased(1e-3 * G, 0.0, 0.0), &ALIGNED);
        for k in 0..=3000 {
            simulator.push_sample(&resting_sample(f64::from(k) / RATE_HZ)).unwrap();
            simulator.step().unwrap();
            let both = [ErrorSource::Navigation, ErrorSource::Model]
                .map(|source| simulator.errors(source).unwrap().unwrap().1);
            let apart = (both[0].misalignment_n - both[1].misalignment_n).norm();
            if k == 0 {
                assert!(apart < 1e-15, "{apart:e}");
            }
            assert_eq!(both[1].outside_validity, !is_valid, "{east} °/h, {k}");
            if is_valid {
                let (t, size) = (f64::from(k) / RATE_HZ, both[0].misalignment_n.norm());
                let apart = (both[0].velocity_n - both[1].velocity_n).norm();
                assert!(apart < G * size * size * t + 1e-9, "{east} °/h after {t} s: {apart:e} m/s");
            }
        }
    }
}

/// The damped vertical channel, which does not follow the truth, starts from the same solution.
#[test]
fn the_vertical_channel_does_not_matter() {
    let (gyro, accel) = (gyros(5.0, 1.0, 0.0), biased(0.1, 0.2, 0.3));
    let follow = start(&mut simulator(&gyro, &accel, &ALIGNED), &askew());
    let options = Options { vertical: VerticalMode::Damped, ..options_at(RATE_HZ) };
    let mut damped = Simulator::new(&options).unwrap();
    damped.set_gyro(&gyro).unwrap();
    damped.set_accel(&accel).unwrap();
    damped.set_initial_errors(&ALIGNED).unwrap();
    assert_eq!(start(&mut damped, &askew()), follow);
}

/// A vehicle that begins its flight in a bank was not aligned in it: its misalignment is that of a level one with its heading. At rest, and
/// with a small tilt, its own attitude counts.
#[test]
fn a_flight_that_begins_in_a_bank_was_aligned_level() {
    let misalignment = |roll: f64, pitch: f64, speed: f64, body_axes| {
        let options = Options { axes: body_axes, ..options_at(RATE_HZ) };
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&gyros(0.02, 0.03, -0.05)).unwrap();
        simulator.set_accel(&biased(1e-3 * G, -2e-3 * G, 5e-4 * G)).unwrap();
        simulator.set_initial_errors(&ALIGNED).unwrap();
        let place = Geodetic { latitude_rad: 0.7, longitude_rad: 0.2, height_m: 1000.0 };
        let euler = Euler { roll, pitch, heading: 1.1 };
        let mut sample = FlightSample::at_rest(0.0, place, euler);
        sample.v_n = Some(Vector3::new(speed, 0.5 * speed, 0.0));
        simulator.push_sample(&sample).unwrap();
        simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n
    };
    for axes in [BodyAxes::RightForwardUp, BodyAxes::ForwardRightDown] {
        let level = misalignment(0.0, 0.0, 0.0, axes);
        for (roll, pitch) in [(30.0, 4.0), (-60.0, 0.0), (0.0, 45.0), (170.0, 10.0)] {
            let banked = misalignment(roll * DEG, pitch * DEG, 60.0, axes);
            assert!((banked - level).norm() < 1e-12, "{axes:?} {roll} {pitch}: {banked:?}, level {level:?}");
            let at_rest = misalignment(roll * DEG, pitch * DEG, 0.0, axes);
            assert!((at_rest - level).norm() > 1e-4, "{axes:?} {roll} {pitch}: {at_rest:?}");
        }
        let tilts = [0.0, 60.0].map(|speed| misalignment(5.0 * DEG, 3.0 * DEG, speed, axes));
        assert!((tilts[0] - tilts[1]).norm() < 1e-12 && (tilts[0] - level).norm() > 1e-5);
    }
}
