//! Properties that hold for any host that keeps the rules: random hosts, with a check after each of their calls.
//!
//! 300 hosts of 120 calls here; 5000 with `cargo test -p tests --release --features long-tests --test robustness any_use:: -- --nocapture`.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::{Euler, mix};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::TriadParameters;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Options, Simulator};

use crate::support;
use crate::support::any_use::Host;
use crate::support::draws::Draws;
use crate::support::moments::{Call, reads, snapshot};

const HOSTS: u64 = if cfg!(feature = "long-tests") { 5000 } else { 300 };
const CALLS: usize = 120;

/// Makes a call and checks the result: the solution is within the limits of the interface, all numbers are finite, and a
/// refused call has changed nothing.
fn call_and_check(simulator: &mut Simulator, call: &Call, who: &str) -> bool {
    let before = (reads(simulator), snapshot(simulator));
    let answer = call.make(simulator);
    let after = reads(simulator);
    if answer.starts_with("Err") {
        assert!((after, snapshot(simulator)) == before, "{who}: {answer}");
        return false;
    }
    check(simulator, &after, &format!("{who}: {answer}"));
    true
}

/// Checks the limits of the interface, and that everything that is read is a number.
fn check(simulator: &Simulator, read: &str, who: &str) {
    assert!(!read.contains("NaN") && !read.contains("inf"), "{who}: {read}");
    let Ok(Some(solution)) = simulator.navigation() else { return };
    let navigation = solution.navigation;
    let (height_m, speed_m_s) = (navigation.place.height_m, navigation.v_n.norm());
    // Geodetic coordinates are rounded to 1e-8 m, a velocity to a few units in its last place.
    assert!(height_m > -500e3 - 1e-7 && height_m < 20_000e3 + 1e-7, "{who}: {height_m} m");
    assert!(speed_m_s < 100e3 * (1.0 + 1e-14), "{who}: {speed_m_s} m/s");
    let norm2 = navigation.q_nb.norm_squared();
    assert!((norm2 - 1.0).abs() < 1e-12, "{who}: quaternion of the squared norm {norm2}");
}

#[test]
fn no_call_is_ok_beyond_the_limits_and_a_refused_one_changes_nothing() {
    let (mut good, mut refused) = (0, 0);
    for seed in 0..HOSTS {
        let mut host = Host::new(seed);
        let mut simulator = Simulator::new(&host.options).unwrap();
        for k in 0..CALLS {
            let call = host.call();
            if call_and_check(&mut simulator, &call, &format!("host {seed}, call {k}")) {
                good += 1;
            } else {
                refused += 1;
            }
        }
    }
    println!("figure: {HOSTS} hosts of {CALLS} calls, {refused} rejected");
    assert!(good > refused && refused > 0);
}

/// After each call the simulator is saved and loaded: the loaded one gives the same reads and the same bytes. A twin that was
/// loaded some calls ago continues like its original.
#[test]
fn whatever_is_saved_loads_and_goes_on_to_the_same() {
    let mut steps = 0;
    for seed in 0..HOSTS {
        let mut host = Host::new(mix(seed));
        let mut simulator = Simulator::new(&host.options).unwrap();
        let mut twin = Simulator::new(&Options::default()).unwrap();
        twin.load_snapshot(&snapshot(&simulator)).unwrap();
        for k in 0..CALLS {
            let who = format!("host {seed}, call {k}");
            let call = host.call();
            let answer = call.make(&mut simulator);
            steps += usize::from(answer == "Ok(Done)");
            assert_eq!(call.make(&mut twin), answer, "{who}");
            let (read, saved) = (reads(&simulator), snapshot(&simulator));
            assert!(
                reads(&twin) == read && snapshot(&twin) == saved,
                "{who}: {answer}: the loaded one went elsewhere"
            );
            let mut loaded = Simulator::new(&Options::default()).unwrap();
            loaded.load_snapshot(&saved).unwrap_or_else(|error| panic!("{who}: {answer}: {error}"));
            assert!(
                reads(&loaded) == read && snapshot(&loaded) == saved,
                "{who}: {answer}: another one was loaded"
            );
            if k % 7 == 0 {
                twin = loaded;
            }
        }
    }
    println!("{HOSTS} hosts, {steps} steps");
    assert!(steps as u64 > 10 * HOSTS);
}

/// Rest at `latitude_rad`, after `k` intervals of `t` [s].
fn at_rest(k: u32, t: f64, latitude_rad: f64) -> FlightSample {
    let place = Geodetic { latitude_rad, longitude_rad: 1.0, height_m: 100.0 };
    FlightSample::at_rest(f64::from(k) * t, place, Euler::default())
}

/// Accepted biases of any size, in any scheme, frame and vertical channel, at intervals up to the longest: each step is within
/// the limits or refused.
#[test]
fn absurd_biases_are_flown_within_the_limits_or_refused() {
    let mut draws = Draws::new(11);
    let (mut flown, mut refused) = (0, 0);
    for round in 0..10 * HOSTS {
        let t = draws.of(&[0.1, 1.0, 2.5, 2.5, 100.0, 1e3]);
        let options = Options {
            frame: draws.of(&[Frame::EarthFixed, Frame::Geographic]),
            scheme: draws.of(&[Scheme::Exact, Scheme::Paper, Scheme::Polynomial]),
            subsamples: 1 + draws.below(5),
            vertical: draws.of(&[VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free]),
            closed_loop_time_s: draws.one_in(3).then_some(4e3),
            intake: IntakeLimits { max_gap_s: t, ..Default::default() },
            ..Default::default()
        };
        let mut simulator = Simulator::new(&options).unwrap();
        let mut bias = |size: f64| Vector3::from_fn(|_, _| draws.within(-size, size));
        let gyro = TriadParameters { bias: bias(100.0), ..Default::default() };
        let accel = TriadParameters { bias: bias(2000.0), ..Default::default() };
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        let latitude_rad = draws.of(&[0.0, 0.7, -1.5]);
        for k in 0..20 {
            simulator.push_sample(&at_rest(k, t, latitude_rad)).unwrap();
            if !call_and_check(&mut simulator, &Call::Step, &format!("round {round}, step {k}, {t} s")) {
                refused += 1;
                break;
            }
            flown += 1;
        }
    }
    println!("{flown} steps flown, {refused} rounds refused");
    assert!(flown > 1000 && refused > 100);
}

/// Gyros biased by 100 rad/s turn 250 rad in an interval; the second-order terms of the paper's scheme make 100 km/s of it.
#[test]
fn the_papers_scheme_diverges_where_its_second_order_does() {
    let options = Options { scheme: Scheme::Paper, vertical: VerticalMode::Free, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    let gyro = TriadParameters { bias: Vector3::new(100.0, 0.0, 0.0), ..Default::default() };
    let accel = TriadParameters { bias: Vector3::new(0.0, 500.0, 0.0), ..Default::default() };
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator.push_sample(&at_rest(0, 2.5, 0.7)).unwrap();
    simulator.push_sample(&at_rest(1, 2.5, 0.7)).unwrap();
    // ½ θ×V of 250 rad and 1250 m/s.
    let error = simulator.step().unwrap_err();
    assert_eq!(error.kind, sins::ErrorKind::Diverged);
    assert!(
        (error.value.unwrap().as_f64() - 0.5 * 250.0 * 1250.0).abs() < 0.02 * 0.5 * 250.0 * 1250.0,
        "{error}"
    );
}

/// A roll of ±36° at 1 Hz with the host's rates at 100 Hz and up to 1.2 s lost: the rates do not predict the turn over the gap.
/// The simulator is saved and loaded right after the gap, and until the gap is forgotten.
#[test]
fn a_snapshot_right_behind_a_gap_loads() {
    for lost in [0, 40, 60, 75, 100, 120] {
        for waiting in [0, 1, 2, 5] {
            let options = Options { vertical: VerticalMode::FollowTruth, ..Default::default() };
            let mut simulator = Simulator::new(&options).unwrap();
            for k in 0..100_u32 {
                let time_s = f64::from(if k < 50 { k } else { k + lost }) * 0.01;
                let phase = std::f64::consts::TAU * time_s;
                let amplitude = 36.0 * support::DEG;
                let mut sample = at_rest(0, 1.0, 0.7);
                sample.time_s = time_s;
                sample.euler.roll = amplitude * phase.sin();
                sample.omega_ib_b =
                    Some(Vector3::new(0.0, amplitude * std::f64::consts::TAU * phase.cos(), 0.0));
                simulator.push_sample(&sample).unwrap();
                if k as usize >= waiting {
                    simulator.step().unwrap();
                }
                let saved = snapshot(&simulator);
                let mut loaded = Simulator::new(&Options::default()).unwrap();
                loaded
                    .load_snapshot(&saved)
                    .unwrap_or_else(|error| panic!("{lost} lost, sample {k}: {error}"));
                assert!(snapshot(&loaded) == saved && reads(&loaded) == reads(&simulator));
            }
        }
    }
}

/// The longest gap that a host may allow, with stamps since 1970: a stamp is a multiple of 2.4e-7 s there.
#[test]
fn a_snapshot_of_the_longest_interval_loads() {
    let options = Options {
        intake: IntakeLimits { max_gap_s: 1e3, ..Default::default() },
        error_model: true,
        vertical: VerticalMode::FollowTruth,
        ..Default::default()
    };
    let mut simulator = Simulator::new(&options).unwrap();
    let accel = TriadParameters {
        lever_arm_m: nalgebra::Matrix3::identity() * 0.1,
        random_walk: Vector3::repeat(1e-6),
        ..Default::default()
    };
    simulator.set_accel(&accel).unwrap();
    for k in 0..12 {
        let mut sample = at_rest(0, 1.0, 0.7);
        sample.time_s = 1_700_000_000.123_456_7 + f64::from(k) * 1_000.000_000_2;
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        let saved = snapshot(&simulator);
        let mut loaded = Simulator::new(&Options::default()).unwrap();
        loaded.load_snapshot(&saved).unwrap();
        assert!(snapshot(&loaded) == saved && reads(&loaded) == reads(&simulator));
    }
    assert!(simulator.imu().unwrap().interval_s > 1e3);
}
