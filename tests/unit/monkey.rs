//! Random use of the panel, of power, of motion and of sensors that fail: what is shown as valid is right.
//!
//! The oracle bounds each error by closed forms of what is set, 5 standard deviations of what is drawn, and what the crew entered. It knows
//! the truth, and of the unit only what it shows.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus as Random;
use sins::earth::state::Navigation;
use sins::earth::{Earth, Geodetic};
use sins::math::{Euler, rotate, wrap_angle};
use sins::sensors::{Axis, Failure, Grade, SensorOutput, TriadParameters};
use sins::unit::{
    AlignmentKind, Mode, Power, State, StoredAlignment, UnitNavigation, UnitParameters, Validity,
};

use crate::aircraft::{Aircraft, Motion, Receiver, papers_sensors};
use crate::support::{DEG, EARTH_RATE, G};

const RATE_HZ: f64 = 10.0;
const DT: f64 = 1.0 / RATE_HZ;
const SIGMAS: f64 = 5.0;
const EARTH_M: f64 = 6.37e6;

/// Bounds of the errors of a triad: of a mean, and of white noise over 1 s.
struct Triad {
    mean: f64,
    noise: f64,
    scale: f64,
}

impl Triad {
    fn of(triad: &TriadParameters, hours: f64) -> Self {
        let random = triad.bias_sigma.norm()
            + 2.0 * triad.flicker.norm()
            + triad.markov_sigma.norm()
            + triad.rate_random_walk.norm() * (3600.0 * hours).sqrt();
        let set = triad.bias.norm() + G * triad.g_sensitivity.norm();
        let elements = triad.scale_factor.norm()
            + triad.misalignment.norm()
            + SIGMAS * (triad.scale_factor_sigma.norm() + triad.misalignment_sigma.norm());
        Self { mean: set + SIGMAS * random, noise: SIGMAS * triad.random_walk.norm(), scale: elements }
    }
}

/// Bounds of the errors of what is shown.
#[derive(Debug, Clone, Copy, Default)]
struct Bounds {
    tilt: f64,
    heading: f64,
    velocity: f64,
    position: f64,
}

struct Oracle {
    gyro: Triad,
    accel: Triad,
    /// The shortest time of a gyrocompass, and half of its shortest window [s].
    compass_s: f64,
    half_window_s: f64,
    /// What the solution may err.
    solution: Bounds,
    /// What the attitude of ATT may err.
    att: Bounds,
    last: State,
    /// The heading was kept from a flight before.
    realigned: bool,
    last_truth: Option<Navigation>,
    /// How far from where the aircraft stood then the positions were that the crew entered since the unit was switched on, at most [m].
    mistake: f64,
    /// Largest difference of the stored heading from the true one in this alignment.
    stored_off: f64,
    /// Where the unit was switched on.
    switched_on: Geodetic,
}

impl Oracle {
    /// The crew has entered a position that is `mistake` [m] from where the aircraft stands.
    fn enter(&mut self, mistake: f64) {
        self.mistake = self.mistake.max(mistake);
        // A unit that is ready takes it at the end of a window.
        self.solution.position = self.solution.position.max(20.0 + mistake);
    }

    /// Largest tilt that levelling leaves: accelerometers, noise over half a window, and a start by 0.2 m.
    fn level(&self) -> f64 {
        let force = self.accel.mean + self.accel.scale * G + self.accel.noise / self.half_window_s.sqrt();
        force / G + self.gyro.mean * 30.0 + self.gyro.noise * 30f64.sqrt() + 2e-4
    }

    /// Largest heading error of an alignment at rest: a stored heading is that of the aircraft while it has not moved.
    fn heading_at_rest(&self, aircraft: &Aircraft, truth: &Navigation, t: f64) -> f64 {
        let compass = self.compass(truth.place.latitude_rad, t);
        let has_moved = metres(&self.switched_on, &truth.place) > 0.5;
        if aircraft.kind() == AlignmentKind::StoredHeading && !has_moved {
            // In gusts the aircraft was switched on with up to 0.1 degrees.
            return compass.max(self.stored_off + 4e-3 + self.gyro.mean * 1000.0);
        }
        compass
    }

    /// The tilt by a stored heading that is not that of the aircraft: the Earth turns the vertical since the last window the other way.
    fn of_stored(&self, aircraft: &Aircraft) -> f64 {
        let is_used = aircraft.kind() == AlignmentKind::StoredHeading;
        if is_used { 46.0 * EARTH_RATE * self.stored_off } else { 0.0 }
    }

    /// Largest heading error of a gyrocompass that has lasted `t` [s].
    fn compass(&self, latitude_rad: f64, t: f64) -> f64 {
        let horizontal = EARTH_RATE * latitude_rad.cos();
        let rate = self.gyro.mean + self.gyro.scale * EARTH_RATE + 1.5 * self.gyro.noise / t.sqrt();
        let accel = self.accel.noise / self.half_window_s.sqrt() + self.accel.mean;
        let of_sensors = rate / horizontal
            + self.gyro.mean * t
            + accel / G * (latitude_rad.tan().abs() + 2.0 / (horizontal * t));
        // The unit shows no heading with a standard deviation above 1 degree.
        of_sensors.min(SIGMAS * DEG)
            + 1e-3
            // Windows in which the aircraft is not quite at rest.
            + 1e-4 / (horizontal * t)
    }

    /// An interval at the end of which the unit shows `state` and the truth is `truth`; `lost` tells which triads had no signal.
    fn advance(&mut self, aircraft: &Aircraft, truth: &Navigation, lost: (bool, bool)) {
        let status = aircraft.unit.status();
        let latitude = truth.place.latitude_rad;
        let speed = truth.v_n.norm();
        let turned = self.last_truth.map_or(0.0, |last| angle_between(&last, truth));
        let accelerated = self.last_truth.map_or(0.0, |last| (truth.v_n - last.v_n).norm());
        self.last_truth = Some(*truth);
        let Bounds { tilt, heading, velocity, position } = &mut self.solution;
        let rotation = self.gyro.mean * DT
            + self.gyro.scale * (turned + EARTH_RATE * DT)
            + if lost.0 { 2.0 * turned + EARTH_RATE * DT } else { 0.0 };
        // Over a time t the noise is N √t: its growth in each interval is at most N √dt at first, and half of N dt/√t on the whole.
        let force = (G + accelerated / DT) * *tilt
            + accelerated / DT * heading.min(2.0)
            + self.accel.mean
            + self.accel.scale * (G + accelerated / DT)
            + if lost.1 { 1.5 * G } else { 0.0 };
        *tilt += rotation
            + self.gyro.noise * DT / 5.0
            + (*velocity / EARTH_M + EARTH_RATE * heading.min(2.0)) * DT;
        *heading += rotation
            + self.gyro.noise * DT / 5.0
            + (*velocity / EARTH_M * latitude.tan().abs() + EARTH_RATE * *tilt) * DT;
        *velocity += force * DT + self.accel.noise * DT / 5.0;
        *position += *velocity * DT;
        // What the crew does.
        // An alignment at once has no test.
        if status.state == State::Test || self.last == State::Off {
            self.switched_on = truth.place;
        }
        let is_aligning =
            matches!(status.state, State::CoarseAlignment | State::FineAlignment | State::Ready);
        if let Some(stored) = status.stored.filter(|_| !is_aligning || self.realigned) {
            self.stored_off = wrap_angle(stored.heading_rad - truth.euler.heading).abs();
        }
        let before = self.last;
        self.last = status.state;
        let now = status.state;
        let shows = |state| matches!(state, State::Ready | State::Navigation | State::Realignment);
        if matches!(now, State::Off | State::Test) {
            self.mistake = 0.0;
        }
        match now {
            State::Realignment => self.realigned = true,
            State::CoarseAlignment | State::Off => self.realigned = false,
            _ => {}
        }
        let level = self.level();
        let has_ended = shows(now) && !shows(before)
            || before == State::Realignment && matches!(now, State::Ready | State::Navigation)
            || now == State::Ready
                && matches!(aircraft.kind(), AlignmentKind::Gyrocompass | AlignmentKind::StoredHeading);
        if has_ended {
            let keeps_heading = self.realigned;
            let heading = match aircraft.kind() {
                _ if keeps_heading => self.solution.heading,
                AlignmentKind::InFlight => SIGMAS * 0.1 * DEG,
                // Only a simulation can make it, at once and without an error.
                AlignmentKind::Fast | AlignmentKind::Instant => level,
                _ => self.heading_at_rest(aircraft, truth, self.compass_s),
            };
            // A wrong heading turns the way of the vertical since the last window.
            let of_stored = self.of_stored(aircraft);
            let of_fixes = if aircraft.kind() == AlignmentKind::InFlight { 5e-3 } else { 0.0 };
            self.solution = Bounds {
                tilt: level + of_fixes + of_stored,
                heading,
                // Up to 31 s since the velocity was made 0, and fixes of 0.2 m/s.
                velocity: 0.2
                    + 31.0 * G * (level + of_fixes + of_stored)
                    + if of_fixes > 0.0 { 6.0 } else { 0.0 },
                position: self.mistake + 20.0 + if keeps_heading { self.solution.position } else { 0.0 },
            };
        }
        // ATT follows the apparent vertical with a time constant of 120 s; the heading turns with the Earth.
        let apparent = if self.last == State::Attitude || self.last == State::Erection {
            accelerated / DT / G
        } else {
            0.0
        };
        let level_rate = EARTH_RATE + speed / EARTH_M;
        if now == State::Erection {
            self.att = Bounds { tilt: level + 31.0 * level_rate + 0.5, ..Bounds::default() };
        }
        self.att.tilt += DT / 120.0 * (1.1 * apparent + level - self.att.tilt) + level_rate * DT + rotation;
        self.att.heading += (EARTH_RATE + speed / EARTH_M * latitude.tan().abs()) * DT
            + rotation
            + self.att.tilt * (turned + apparent * DT / 120.0);
    }

    fn check(&self, aircraft: &Aircraft, truth: &Navigation, shown: &UnitNavigation, seed: u64) {
        let status = aircraft.unit.status();
        let context =
            || format!("seed {seed}, {:.1} s: {status:?}\nshown {shown:?}\ntruth {truth:?}", shown.time_s);
        let bounds = match status.state {
            State::Attitude => self.att,
            State::FineAlignment if aircraft.kind() == AlignmentKind::InFlight => {
                Bounds { tilt: SIGMAS * 0.5 * DEG, heading: SIGMAS * 0.1 * DEG, ..Bounds::default() }
            }
            State::FineAlignment => Bounds {
                tilt: self.level() + 46.0 * EARTH_RATE + self.of_stored(aircraft),
                heading: self.heading_at_rest(aircraft, truth, 40.0),
                ..Bounds::default()
            },
            _ => self.solution,
        };
        let Euler { roll, pitch, heading } = shown.euler;
        let tilt = wrap_angle(roll - truth.euler.roll).abs().max((pitch - truth.euler.pitch).abs());
        if shown.validity.attitude {
            assert!(tilt <= bounds.tilt.max(1e-9), "tilt {tilt} of {}: {}", bounds.tilt, context());
        }
        if shown.validity.heading {
            // A heading that the sensors cannot find may be anything.
            let off = wrap_angle(heading - truth.euler.heading).abs();
            assert!(
                off <= bounds.heading + bounds.tilt,
                "heading {off} of {}: {}",
                bounds.heading,
                context()
            );
        }
        if shown.validity.velocity {
            let off = (shown.v_n - truth.v_n).norm();
            assert!(off <= bounds.velocity, "velocity {off} of {}: {}", bounds.velocity, context());
            let off = (shown.place.height_m - truth.place.height_m).abs();
            assert!(off <= bounds.position, "height {off} of {}: {}", bounds.position, context());
        }
        if shown.validity.position {
            let off = metres(&shown.place, &truth.place);
            assert!(off <= bounds.position, "position {off} of {}: {}", bounds.position, context());
        }
    }
}

/// Distance of two places at the surface [m].
fn metres(one: &Geodetic, other: &Geodetic) -> f64 {
    let at = |place: &Geodetic| Earth::default().to_earth_fixed(&Geodetic { height_m: 0.0, ..*place });
    (at(one) - at(other)).norm()
}

/// Angle by which the attitude has turned.
fn angle_between(one: &Navigation, other: &Navigation) -> f64 {
    [Vector3::x(), Vector3::y(), Vector3::z()]
        .iter()
        .map(|axis| (rotate(&one.q_nb, axis) - rotate(&other.q_nb, axis)).norm())
        .fold(0.0, f64::max)
}

/// One life of a unit.
fn live(seed: u64) -> [u64; 5] {
    let mut draws = Random::seed_from_u64(seed);
    let each = [
        Default::default(),
        papers_sensors(),
        Grade::Strategic.parameters(),
        Grade::Navigation.parameters(),
        Grade::Tactical.parameters(),
        Grade::Industrial.parameters(),
    ];
    let sensors = each[draws.random_range(0..each.len())];
    let latitude_deg = [0.0, 20.0, -45.0, 60.0, 70.0, -81.0][draws.random_range(0..6)];
    let mut aircraft = Aircraft::new(latitude_deg, seed, RATE_HZ, &sensors);
    aircraft.roll_rate = 20.0 * DEG;
    // Every other unit aligns in two minutes, so that it does so often.
    let alignment_s = [0.0, 120.0][draws.random_range(0..2)];
    let parameters = UnitParameters { alignment_s, ..Default::default() };
    aircraft.unit.set_parameters(&parameters).unwrap();
    let (compass_s, half_window_s) = if alignment_s > 0.0 { (100.0, 3.0) } else { (250.0, 5.0) };
    let mut oracle = Oracle {
        compass_s,
        half_window_s,
        gyro: Triad::of(&sensors.0, 1.0),
        accel: Triad::of(&sensors.1, 1.0),
        solution: Bounds::default(),
        att: Bounds::default(),
        last: State::Off,
        realigned: false,
        last_truth: None,
        mistake: 0.0,
        stored_off: 0.0,
        switched_on: Geodetic::default(),
    };
    let mut valid = [0; 5];
    let mut failed = None;
    // A crew that enters a position often, or seldom, so that it is old when the alignment ends.
    let is_eager = draws.random_range(0..2) == 0;
    for _ in 0..draws.random_range(20..40) {
        // Mostly what a crew does, at times anything.
        match draws.random_range(0..15) {
            0..=4 => aircraft.unit.select([Mode::Align, Mode::Navigate][draws.random_range(0..2)]),
            5 => aircraft.unit.select(Mode::Attitude),
            6 => aircraft.unit.select(Mode::Off),
            7 => aircraft
                .unit
                .set_power([Power::Aircraft, Power::Battery, Power::None][draws.random_range(0..3)]),
            8 => aircraft.unit.set_power(Power::Aircraft),
            9 | 10 => {
                use AlignmentKind::{Fast, Gyrocompass, InFlight, Instant, StoredHeading};
                let kinds = [Gyrocompass, Gyrocompass, StoredHeading, InFlight, InFlight, Fast, Instant];
                aircraft.set_alignment(kinds[draws.random_range(0..kinds.len())]);
            }
            11 => {
                let output = [
                    SensorOutput::Gyro(Axis::Z),
                    SensorOutput::Gyro(Axis::X),
                    SensorOutput::Accelerometer(Axis::Y),
                    SensorOutput::Accelerometer(Axis::Z),
                ];
                let steps = if draws.random_range(0..2) == 0 { 60 } else { 600 };
                failed = Some((output[draws.random_range(0..4)], draws.random_range(0.02..0.5), steps));
            }
            12 if aircraft.unit.status().state == State::Off => {
                let Geodetic { latitude_rad, longitude_rad, .. } = aircraft.place();
                let heading_rad = aircraft.heading().rem_euclid(std::f64::consts::TAU);
                aircraft
                    .unit
                    .set_stored(Some(StoredAlignment { latitude_rad, longitude_rad, heading_rad }))
                    .unwrap();
            }
            13 => {
                let sigma_m_s = draws.random_range(0.0..0.2);
                aircraft.receiver = Some(Receiver::new(seed, 3.0, sigma_m_s));
            }
            _ => aircraft.receiver = None,
        }
        let motion = match (draws.random_range(0..10), aircraft.speed() > 0.0) {
            (0..=4, false) => Motion::Rest,
            (5, false) => Motion::Sway,
            (0..=2, true) => Motion::Drive { acceleration: 3.0, to: 0.0 },
            (3 | 4, true) => Motion::Turn(3.0 * DEG),
            (5, true) => Motion::Turn(-DEG),
            (6, _) => Motion::Drive { acceleration: 0.02, to: 2.0 },
            (7, _) => Motion::Drive { acceleration: 0.5, to: 6.0 },
            (8, _) => Motion::Drive { acceleration: 0.5, to: 1.0 },
            _ => Motion::Drive { acceleration: 2.0, to: 90.0 },
        };
        let steps = draws.random_range(0..1500) * if draws.random_range(0..4) == 0 { 4 } else { 1 };
        for step in 0..steps {
            if let Some((output, probability, steps)) = failed {
                let is_lost = draws.random::<f64>() < probability && step < steps;
                aircraft.simulator.set_failure(output, is_lost.then_some(Failure::Dead)).unwrap();
            }
            // The crew enters position and heading at any moment, also in motion; every fourth position with a mistake.
            if draws.random_range(0..if is_eager { 100 } else { 20_000 }) == 0 {
                let mut claimed = aircraft.place();
                if draws.random_range(0..4) == 0 {
                    claimed.latitude_rad += draws.random_range(-1e-4..1e-4);
                    claimed.longitude_rad += draws.random_range(-1e-4..1e-4);
                }
                if aircraft.unit.enter_position(claimed.latitude_rad, claimed.longitude_rad).is_ok() {
                    oracle.enter(metres(&claimed, &aircraft.place()));
                }
            }
            if draws.random_range(0..500) == 0
                && aircraft.unit.enter_heading(wrap_angle(aircraft.heading())).is_ok()
            {
                oracle.att.heading = oracle.att.tilt;
            }
            aircraft.go(motion, DT);
            let Some(imu) = aircraft.simulator.imu() else { continue };
            let truth = aircraft.simulator.truth().unwrap().unwrap().navigation;
            oracle.advance(&aircraft, &truth, (imu.flags.gyro_invalid, imu.flags.accel_invalid));
            let shown = aircraft.navigation();
            assert!(!(shown.validity.rates && (imu.flags.gyro_invalid || imu.flags.accel_invalid)));
            oracle.check(&aircraft, &truth, &shown, seed);
            let Validity { rates, attitude, heading, position, velocity } = shown.validity;
            for (count, is_valid) in valid.iter_mut().zip([rates, attitude, heading, position, velocity]) {
                *count += u64::from(is_valid);
            }
        }
        if failed.take().is_some() {
            for output in SensorOutput::ALL {
                aircraft.simulator.set_failure(output, None).unwrap();
            }
        }
    }
    valid
}

#[test]
fn whatever_is_done_what_is_shown_as_valid_is_right() {
    let seeds = if cfg!(feature = "long-tests") { 5000 } else { 500 };
    let lives = |first: u64| {
        let mut valid = [0; 5];
        for seed in (first..seeds).step_by(2) {
            valid.iter_mut().zip(live(seed)).for_each(|(sum, count)| *sum += count);
        }
        valid
    };
    let mut valid = [0; 5];
    std::thread::scope(|scope| {
        for half in [0, 1].map(|first| scope.spawn(move || lives(first))) {
            let counts = half.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            valid.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
    });
    println!(
        "valid frames: rates {}, attitude {}, heading {}, position {}, velocity {}",
        valid[0], valid[1], valid[2], valid[3], valid[4]
    );
    // Each output was often shown.
    assert!(valid.iter().all(|count| *count > 100_000), "{valid:?}");
}
