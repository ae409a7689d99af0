//! Alignment in flight, on the fixes of another sensor.

use nalgebra::Vector3;
use sins::math::wrap_angle;
use sins::sensors::{StreamKey, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::unit::{AlignmentKind, Mode, State, Status, Unit, UnitParameters};
use sins::{Options, Simulator};

use crate::aircraft::{Aircraft, Motion, Receiver, papers_sensors};
use crate::support::{DEG, DEG_PER_HOUR, G};

const CRUISE: Motion = Motion::Drive { acceleration: 2.0, to: 200.0 };

/// In flight at 200 m/s, with the unit switched on behind the take-off.
fn in_flight(latitude_deg: f64, run: u64, sensors: &(TriadParameters, TriadParameters)) -> Aircraft {
    let mut aircraft = Aircraft::new(latitude_deg, run, 20.0, sensors);
    switch_on(&mut aircraft);
    aircraft
}

fn switch_on(aircraft: &mut Aircraft) {
    aircraft.roll_rate = 20.0 * DEG;
    aircraft.go(CRUISE, 120.0);
    aircraft.unit.set_alignment(AlignmentKind::InFlight);
    aircraft.unit.select(Mode::Align);
}

/// Two turns by 90 degrees, to one side and to the other.
const COURSE: [(Motion, f64); 5] = [
    (CRUISE, 40.0),
    (Motion::Turn(3.0 * DEG), 30.0),
    (CRUISE, 60.0),
    (Motion::Turn(-3.0 * DEG), 30.0),
    (CRUISE, 40.0),
];

fn turns(aircraft: &mut Aircraft) -> Status {
    COURSE.iter().for_each(|(motion, seconds)| _ = aircraft.go(*motion, *seconds));
    aircraft.unit.status()
}

/// With ideal sensors and fixes the attitude, position and velocity are those of the truth, at any latitude.
#[test]
fn with_ideal_sensors_and_fixes_nothing_is_left() {
    for latitude_deg in [0.0, -45.0, 89.0] {
        let mut aircraft = in_flight(latitude_deg, 0, &Default::default());
        aircraft.receiver = Some(Receiver::new(1, 0.0, 0.0));
        let status = turns(&mut aircraft);
        assert_eq!(status.state, State::Ready, "{latitude_deg}: {status:?}");
        aircraft.unit.select(Mode::Navigate);
        aircraft.go(CRUISE, 1.0);
        assert_eq!(aircraft.unit.status().state, State::Navigation);
        let errors = aircraft.errors();
        let sizes = [errors.position_n, errors.velocity_n, errors.misalignment_n].map(|of| of.norm());
        println!("{latitude_deg}: {sizes:?}");
        // The last window ended up to 30 s ago. At 89 degrees the way of constant heading is bent, and the velocities of the samples are
        // not quite those of the positions.
        let position_m = if latitude_deg == 89.0 { 0.2 } else { 0.01 };
        assert!(sizes[0] < position_m && sizes[1] < 1e-3 && sizes[2] < 1e-5, "{latitude_deg}: {sizes:?}");
    }
}

/// Ideal sensors, fixes with white errors of the velocity: the heading error of 400 runs. Windows share their fixes, so with the horizontal
/// change of velocity h of a window, and σ of a fix, its variance is σ² Σ|h_k - h_{k+1}|²/(Σ|h|²)²; h is 0 before the first window and
/// behind the last.
#[test]
fn the_heading_error_is_that_of_theory() {
    let sigma_m_s = 0.1;
    let runs = 400;
    let (mut squares, mut tilts) = (0.0, 0.0);
    for run in 0..runs {
        let mut aircraft = in_flight(40.0, run, &Default::default());
        aircraft.receiver = Some(Receiver::new(run, 0.0, sigma_m_s));
        assert_eq!(turns(&mut aircraft).state, State::Ready);
        let errors = aircraft.errors().misalignment_n;
        squares += errors.z * errors.z / runs as f64;
        tilts += errors.xy().norm_squared() / (2 * runs) as f64;
    }
    // The test after power-up takes 5 s, and the first fix comes up to 1 s later. The alignment ends 180 s behind it.
    let mut aircraft = in_flight(40.0, 0, &Default::default());
    let mut velocities = Vec::new();
    aircraft.until(CRUISE, State::CoarseAlignment, 6.0);
    for (motion, seconds) in COURSE {
        for _ in 0..(seconds - if velocities.is_empty() { 5.0 } else { 0.0 }) as usize {
            velocities.push(200.0 * Vector3::new(aircraft.heading().sin(), aircraft.heading().cos(), 0.0));
            aircraft.go(motion, 1.0);
        }
    }
    let changes: Vec<_> =
        velocities.iter().step_by(30).collect::<Vec<_>>().windows(2).map(|v| v[1] - v[0]).collect();
    let (first, last) = (changes[0], changes[changes.len() - 1]);
    let between = changes.windows(2).map(|h| (h[1] - h[0]).norm_squared()).sum::<f64>();
    let shown = changes.iter().map(Vector3::norm_squared).sum::<f64>();
    let theory = sigma_m_s * (first.norm_squared() + between + last.norm_squared()).sqrt() / shown;
    let ratio = squares.sqrt() / theory;
    println!("heading {:.2e} rad, {ratio:.3} of theory; tilt {:.2e} rad", squares.sqrt(), tilts.sqrt());
    assert!((ratio - 1.0).abs() < 3.0 / (2.0 * runs as f64).sqrt(), "{ratio}");
}

/// Sensors and receivers of several grades.
#[test]
fn an_alignment_with_real_sensors_leaves_what_they_let() {
    let each = Vector3::repeat;
    let tactical = (
        TriadParameters {
            bias: each(1.0 * DEG_PER_HOUR),
            random_walk: each(0.1 * DEG / 60.0),
            ..Default::default()
        },
        TriadParameters { bias: each(1e-3 * G), ..Default::default() },
    );
    for (name, sensors) in [("paper", papers_sensors()), ("tactical", tactical)] {
        let (mut heading, mut tilt) = (0.0, 0.0);
        for run in 0..20 {
            let mut aircraft = in_flight(40.0, run, &sensors);
            aircraft.receiver = Some(Receiver::new(run, 3.0, 0.05));
            assert_eq!(turns(&mut aircraft).state, State::Ready);
            let errors = aircraft.errors().misalignment_n;
            heading += errors.z * errors.z / 20.0;
            tilt += errors.xy().norm_squared() / 40.0;
        }
        let (heading, tilt) = (f64::sqrt(heading), f64::sqrt(tilt));
        println!("{name}: heading {heading:.2e} rad, tilt {tilt:.2e} rad");
        assert!(heading < 1e-3 && tilt < 1.2 * sensors.1.bias.x / G + 1e-4, "{name}");
    }
}

/// A heading is shown as valid only when enough windows have confirmed it: two of them agree by chance now and then.
#[test]
fn a_heading_that_becomes_valid_is_as_accurate_as_the_limit() {
    let limit = 0.1 * DEG;
    let (mut squares, mut worst, mut count) = (0.0, 0.0f64, 0);
    for run in 0..400 {
        let mut aircraft = in_flight(40.0, run, &papers_sensors());
        aircraft.receiver = Some(Receiver::new(run, 3.0, 0.1));
        for (motion, seconds) in COURSE {
            let steps = seconds as usize;
            let Some(error) = (0..steps).find_map(|_| {
                let status = aircraft.go(motion, 1.0);
                status
                    .validity
                    .heading
                    .then(|| wrap_angle(aircraft.navigation().euler.heading - aircraft.heading()))
            }) else {
                continue;
            };
            squares += error * error;
            worst = worst.max(error.abs());
            count += 1;
            break;
        }
    }
    let rms = (squares / f64::from(count)).sqrt();
    println!(
        "{count} headings: {:.4} deg rms when they become valid, worst {:.3} deg",
        rms / DEG,
        worst / DEG
    );
    assert!(count > 380 && rms < limit && worst < 5.0 * limit, "{rms} {worst}");
}

/// Straight flight shows no heading that is good enough; the crew is told, flies a turn, and the unit is ready.
#[test]
fn without_turns_it_waits_for_them() {
    let mut aircraft = in_flight(40.0, 3, &papers_sensors());
    let status = aircraft.go(CRUISE, 60.0);
    assert!(status.reasons.no_position && !status.align_flashes && status.state == State::CoarseAlignment);
    aircraft.receiver = Some(Receiver::new(3, 3.0, 0.1));
    let status = aircraft.go(CRUISE, 190.0);
    assert!(status.state == State::FineAlignment && status.align_flashes, "{status:?}");
    assert!(status.reasons.turns_needed && !status.reasons.no_position && !status.validity.heading);
    assert!(status.validity.attitude && (aircraft.navigation().euler.roll).abs() < 0.01);
    aircraft.go(Motion::Turn(3.0 * DEG), 30.0);
    let status = aircraft.go(CRUISE, 60.0);
    assert!(status.state == State::Ready && status.reasons == Default::default(), "{status:?}");
}

/// A block away from the reference point: its own motion in the turns is not taken for a turned heading. What is left is the change of
/// the rate within half an interval, times the arm, against the change of velocity in a turn: 0.35 rad/s² · 25 ms · 10 m of 280 m/s.
#[test]
fn a_lever_arm_does_not_turn_the_heading() {
    let mut aircraft = Aircraft::new(40.0, 0, 20.0, &Default::default());
    let lever_arm_m = Vector3::new(3.0, 10.0, -2.0);
    aircraft.simulator.set_mounting(&MountingParameters { lever_arm_m, ..Default::default() }).unwrap();
    switch_on(&mut aircraft);
    aircraft.receiver = Some(Receiver::new(1, 0.0, 0.0));
    assert_eq!(turns(&mut aircraft).state, State::Ready);
    aircraft.unit.select(Mode::Navigate);
    aircraft.go(CRUISE, 1.0);
    let errors = aircraft.errors();
    println!("{:.2e} rad, {:.2e} m/s", errors.misalignment_n.norm(), errors.velocity_n.norm());
    assert!(errors.misalignment_n.norm() < 3e-4 && errors.velocity_n.norm() < 1e-2);
}

/// A receiver that falls silent is reported after a minute. The attitude goes on by the gyros, with the Earth and the way.
#[test]
fn without_further_fixes_the_attitude_goes_on_and_the_unit_says_what_it_lacks() {
    let mut aircraft = in_flight(40.0, 0, &Default::default());
    aircraft.receiver = Some(Receiver::new(1, 0.0, 0.0));
    for (motion, seconds) in &COURSE[..4] {
        aircraft.go(*motion, *seconds);
    }
    aircraft.go(CRUISE, 2.0);
    aircraft.receiver = None;
    let status = aircraft.go(CRUISE, 58.0);
    assert!(status.state == State::FineAlignment && !status.reasons.no_position && status.validity.heading);
    let shown = aircraft.navigation().euler;
    let heading = wrap_angle(shown.heading - aircraft.heading()).abs();
    println!("after 58 s: roll {:.1e}, pitch {:.1e}, heading {heading:.1e} rad", shown.roll, shown.pitch);
    assert!(shown.roll.abs().max(shown.pitch.abs()).max(heading) < 1e-5);
    let status = aircraft.go(CRUISE, 4.0);
    assert!(status.reasons.no_position && status.align_flashes, "{status:?}");
}

/// Fixes that show no motion, and gyros that are too poor for straight flight: the unit says that it needs turns.
#[test]
fn it_says_that_it_needs_turns_whatever_the_fixes_are() {
    let mut aircraft = in_flight(40.0, 0, &Default::default());
    aircraft.receiver = None;
    let place = aircraft.place();
    for second in 0..250 {
        aircraft.go(CRUISE, 1.0);
        aircraft.unit.push_fix(&mut aircraft.simulator, place, each(0.0)).unwrap();
        // The test after power-up takes 5 s, and the least length is 180 s.
        let needs_turns = aircraft.unit.status().reasons.turns_needed;
        assert!((184..187).contains(&second) || needs_turns == (second > 185), "{second}");
    }
    let poor = TriadParameters { bias: each(DEG_PER_HOUR), ..Default::default() };
    let mut aircraft = in_flight(40.0, 0, &(poor, Default::default()));
    aircraft.receiver = Some(Receiver::new(1, 0.0, 0.01));
    let status = aircraft.go(CRUISE, 1800.0);
    assert!(status.reasons.turns_needed && status.state == State::FineAlignment, "{status:?}");
    turns(&mut aircraft);
    assert_eq!(aircraft.unit.status().state, State::Ready);
    assert!(aircraft.errors().misalignment_n.z.abs() < 0.1 * DEG);
}

/// An alignment at rest that motion has stopped is forgotten by one in flight.
#[test]
fn motion_is_no_reason_in_flight() {
    let mut aircraft = in_flight(40.0, 0, &Default::default());
    aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
    aircraft.go(CRUISE, 40.0);
    assert!(aircraft.go(Motion::Turn(3.0 * DEG), 40.0).reasons.motion);
    aircraft.unit.set_alignment(AlignmentKind::InFlight);
    assert!(!aircraft.go(CRUISE, 1.0).reasons.motion);
}

/// A unit that navigates may be aligned anew in flight; for another kind of alignment the navigation would be lost.
#[test]
fn align_in_flight_aligns_anew() {
    let mut aircraft = in_flight(40.0, 4, &papers_sensors());
    aircraft.receiver = Some(Receiver::new(4, 3.0, 0.1));
    turns(&mut aircraft);
    aircraft.unit.select(Mode::Navigate);
    aircraft.go(CRUISE, 1800.0);
    assert!(aircraft.unit.status().validity.velocity);
    let before = aircraft.errors().position_n.xy().norm();
    aircraft.unit.select(Mode::Align);
    let status = aircraft.go(CRUISE, 1.0);
    assert!(status.state == State::CoarseAlignment && !status.reasons.motion, "{status:?}");
    assert_eq!(turns(&mut aircraft).state, State::Ready);
    let after = aircraft.errors().position_n.xy().norm();
    println!("position {before:.0} m, behind a new alignment {after:.1} m");
    assert!(before > 100.0 && after < 15.0);
}

/// A fix that is out of range is refused by name; a fix that is not needed changes nothing.
#[test]
fn fixes_are_checked_and_only_taken_when_needed() {
    let mut aircraft = in_flight(40.0, 5, &papers_sensors());
    aircraft.go(CRUISE, 10.0);
    let (before, place) = (aircraft.unit, aircraft.place());
    for (v_n, field) in
        [(Vector3::new(0.0, f64::NAN, 0.0), "fix.velocity_enu_m_s"), (each(1.1e4), "fix.velocity_enu_m_s")]
    {
        let error = aircraft.unit.push_fix(&mut aircraft.simulator, place, v_n).unwrap_err();
        assert!(error.field == field && aircraft.unit == before, "{error}");
    }
    let too_high = sins::earth::Geodetic { height_m: 2e6, ..place };
    let error = aircraft.unit.push_fix(&mut aircraft.simulator, too_high, each(0.0)).unwrap_err();
    assert_eq!(error.field, "fix.height_m");
    aircraft.unit.set_alignment(AlignmentKind::Gyrocompass);
    let before = aircraft.unit;
    aircraft.unit.push_fix(&mut aircraft.simulator, place, each(0.0)).unwrap();
    assert!(aircraft.unit == before);
}

fn each(number: f64) -> Vector3<f64> {
    Vector3::repeat(number)
}

/// The times of the parameters hold: the least length, then the end of the window, which lasts at least as long as the coarse alignment.
#[test]
fn its_times_and_limits_are_those_of_the_parameters() {
    for (coarse_alignment_s, length_s) in [(10.0, 90.0), (40.0, 120.0)] {
        let mut aircraft = in_flight(40.0, 6, &Default::default());
        let parameters =
            UnitParameters { in_flight_alignment_s: 90.0, coarse_alignment_s, ..Default::default() };
        aircraft.unit.set_parameters(&parameters).unwrap();
        aircraft.receiver = Some(Receiver::new(6, 0.0, 0.01));
        aircraft.go(Motion::Turn(3.0 * DEG), 60.0);
        let seconds = 60.0 + aircraft.until(CRUISE, State::Ready, 90.0);
        // The test after power-up takes 5 s.
        assert!((seconds - 5.0 - length_s).abs() < 1.2, "{seconds}");
    }
}

/// Turns of 60 degrees of bank, entered within 2 s, with the sensors of the paper: rolls from sample to sample are taken in as the
/// mechanization does. With fixes without errors the attitude is right to the accelerometers' bias, and with noisy ones, also of coarse
/// samples, to the limit up to which it is shown.
#[test]
fn hard_turns_show_no_other_attitude_than_soft_ones() {
    let manoeuvres: Vec<_> = (0..30)
        .flat_map(|turn| {
            let heading_change_rad = if turn % 2 == 0 { 0.7 } else { -0.7 };
            let turn = Manoeuvre::Turn { heading_change_rad, bank_rad: 60.0 * DEG, ramp_s: 2.0 };
            [turn, Manoeuvre::Straight { duration_s: 5.0 }]
        })
        .collect();
    let start =
        FlightStart { latitude_rad: 40.0 * DEG, height_m: 3000.0, speed_m_s: 200.0, ..Default::default() };
    let flight = Flight::new(&start, &manoeuvres).unwrap();
    // As much again for what the mechanization of 10 Hz misses in these rolls.
    let bias = 2.0 * 2f64.sqrt() * papers_sensors().1.bias.x / G;
    for (rate_hz, sigma_m_s, limit) in [(10, 0.0, bias), (10, 0.2, 0.5 * DEG), (2, 0.2, 0.5 * DEG)] {
        let (mut squares, mut count) = (0.0, 0.0);
        for run in 0..20 {
            let options = Options { key: StreamKey { seed: 1, run }, ..Options::default() };
            let mut simulator = Simulator::new(&options).unwrap();
            let (gyro, accel) = papers_sensors();
            simulator.set_gyro(&gyro).unwrap();
            simulator.set_accel(&accel).unwrap();
            let mut unit = Unit::new(&UnitParameters::default(), Mode::Off).unwrap();
            unit.select(Mode::Align);
            unit.set_alignment(AlignmentKind::InFlight);
            let mut receiver = Receiver::new(run, 0.0, sigma_m_s);
            for k in 0..flight.duration_s() as usize * rate_hz {
                simulator.push_sample(&flight.sample_at(k as f64 / rate_hz as f64).unwrap()).unwrap();
                if simulator.step().unwrap() != sins::Step::Done {
                    continue;
                }
                unit.update(&mut simulator).unwrap();
                let truth = simulator.truth().unwrap().unwrap().navigation;
                if k % rate_hz == 0 {
                    let v_n = truth.v_n + receiver.errors(sigma_m_s);
                    unit.push_fix(&mut simulator, truth.place, v_n).unwrap();
                }
                let shown = unit.navigation(&simulator).unwrap();
                if shown.validity.attitude {
                    squares += (shown.euler.roll - truth.euler.roll).powi(2)
                        + (shown.euler.pitch - truth.euler.pitch).powi(2);
                    count += 1.0;
                }
            }
        }
        let rms = f64::sqrt(squares / count);
        println!("{rate_hz} Hz, {sigma_m_s} m/s: {count} frames, {:.4} deg rms", rms / DEG);
        assert!(count > 20.0 * 200.0 * rate_hz as f64 && rms < limit, "{rate_hz} Hz: {rms} rad");
    }
}
