//! Identification: parameters of sensors whose errors are known, over flights, grades, noises, clocks and axes.
//!
//! The ordinary test flies 48 records; `--features long-tests` flies 200.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use sins::analysis::identify::{
    Axes, Estimate, IdealPath, Identified, Prior, RecordedIncrement, Request, TriadEstimate, identify,
};
use sins::math::{euler_from_attitude, rotation_matrix, rotation_quaternion, rotation_vector};
use sins::scene::builtin;
use sins::sensors::{Grade, StreamKey, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::Flight;
use sins::{Options, Simulator, Step};

mod also;
mod begin;
mod check;
mod unfit;

use super::support::draws::Draws;
use super::support::{DEG, G};

/// Samples a second of path and record.
const RATE_HZ: f64 = 25.0;
/// Five minutes [s].
const MINUTES: (f64, f64) = (0.0, 300.0);
const TRIALS: u64 = if cfg!(feature = "long-tests") { 200 } else { 48 };

fn flight(name: &str) -> Flight {
    builtin(name).unwrap().flight().unwrap()
}

fn path(flight: &Flight, span_s: (f64, f64)) -> IdealPath {
    let samples = times(span_s).map(|time_s| flight.sample_at(time_s));
    IdealPath::fly(&Options::default(), samples).unwrap()
}

/// Times of the samples of a part of a flight [s].
fn times((from_s, to_s): (f64, f64)) -> impl Iterator<Item = f64> {
    (0..=((to_s - from_s) * RATE_HZ) as usize).map(move |k| from_s + k as f64 / RATE_HZ)
}

/// Sensors in a block whose axes are turned against those of the vehicle, on a clock that is behind.
struct Unit {
    gyro: TriadParameters,
    accel: TriadParameters,
    /// Signals of the block = `rotation` times those of the vehicle.
    rotation: Matrix3<f64>,
    lever_b: Vector3<f64>,
    behind_s: f64,
    run: u64,
    /// Whether samples have a temperature: [`temperature_c`].
    warms: bool,
}

/// A temperature that rises by 20 K in 400 s [°C].
fn temperature_c(time_s: f64) -> f64 {
    20.0 + 0.05 * time_s
}

impl Default for Unit {
    fn default() -> Self {
        let white = |size: f64| TriadParameters { random_walk: Vector3::repeat(size), ..Default::default() };
        Self {
            gyro: white(0.1 * DEG / 60.0),
            accel: white(100e-6 * G),
            rotation: Matrix3::identity(),
            lever_b: Vector3::zeros(),
            behind_s: 0.0,
            run: 0,
            warms: false,
        }
    }
}

impl Unit {
    fn record(&self, flight: &Flight, span_s: (f64, f64)) -> Vec<RecordedIncrement> {
        let key = StreamKey { seed: 61, run: self.run };
        let mut simulator = Simulator::new(&Options { key, ..Options::default() }).unwrap();
        simulator.set_gyro(&self.gyro).unwrap();
        simulator.set_accel(&self.accel).unwrap();
        let from_block = Rotation3::from_matrix_unchecked(self.rotation.transpose());
        let boresight = euler_from_attitude(UnitQuaternion::from_rotation_matrix(&from_block).quaternion());
        simulator
            .set_mounting(&MountingParameters { boresight, lever_arm_m: self.lever_b, ..Default::default() })
            .unwrap();
        let mut record = Vec::new();
        for time_s in times(span_s) {
            let warmth = self.warms.then(|| temperature_c(time_s));
            simulator
                .push_sample(&FlightSample { temperature_c: warmth, ..flight.sample_at(time_s).unwrap() })
                .unwrap();
            if simulator.step().unwrap() == Step::Done {
                let imu = simulator.imu().unwrap();
                let time_s = imu.time_s - self.behind_s;
                record.push(RecordedIncrement {
                    time_s,
                    interval_s: imu.interval_s,
                    increment: imu.measured,
                });
            }
        }
        record
    }
}

/// Normal numbers.
fn normal(draws: &mut Draws) -> f64 {
    (-2.0 * draws.unit().max(1e-300).ln()).sqrt() * (std::f64::consts::TAU * draws.unit()).cos()
}

/// A triad whose errors are drawn from the prior, with white noise, and in two of three cases flicker noise and a random walk that equal
/// it at some time.
fn drawn(draws: &mut Draws, bias: f64, scale_factor: f64, misalignment: f64, white: f64) -> TriadParameters {
    let mut slow = |size: f64| if draws.below(3) > 0 { size } else { 0.0 };
    let (flicker, walk) = (slow(1.0), slow(1.0));
    let time = |draws: &mut Draws, most: f64| (most.ln() * draws.unit()).exp();
    let flicker = flicker * white / (0.4413 * time(draws, 400.0)).sqrt();
    let walk = walk * white * 3f64.sqrt() / (2.0 * time(draws, 700.0));
    TriadParameters {
        bias: Vector3::from_fn(|_, _| bias * normal(draws)),
        scale_factor: Vector3::from_fn(|_, _| scale_factor * normal(draws)),
        misalignment: Matrix3::from_fn(|i, j| if i == j { 0.0 } else { misalignment * normal(draws) }),
        random_walk: Vector3::repeat(white),
        flicker: Vector3::repeat(flicker),
        rate_random_walk: Vector3::repeat(walk),
        ..Default::default()
    }
}

/// Sign of an element of \[φ×\].
fn sign(row: usize, column: usize) -> f64 {
    if (row + 1) % 3 == column { -1.0 } else { 1.0 }
}

/// Errors with scale factors on the diagonal, and the rotation φ, in the axes of the block: the misalignments of both triads have no
/// rotation in common.
fn in_block_axes(unit: &Unit, phi: Vector3<f64>) -> ([Matrix3<f64>; 2], Vector3<f64>) {
    let mut errors = [&unit.gyro, &unit.accel]
        .map(|triad| triad.misalignment + Matrix3::from_diagonal(&triad.scale_factor));
    let mut turned = rotation_quaternion(&phi);
    // Each round leaves a part as large as the errors.
    for _ in 0..8 {
        let mut common = Vector3::zeros();
        for third in 0..3 {
            for (i, j) in [((third + 1) % 3, (third + 2) % 3), ((third + 2) % 3, (third + 1) % 3)] {
                common[third] += errors.iter().map(|error| 0.25 * error[(i, j)] * sign(i, j)).sum::<f64>();
            }
        }
        let back = rotation_matrix(&rotation_quaternion(&-common));
        errors = errors.map(|error| (Matrix3::identity() + error) * back - Matrix3::identity());
        turned = rotation_quaternion(&common) * turned;
    }
    (errors, rotation_vector(&turned))
}

/// How many intervals hold of a kind of parameter.
#[derive(Default)]
struct Coverage {
    held: f64,
    of: f64,
}

impl Coverage {
    fn add(&mut self, estimate: &Estimate, truth: f64) {
        let (low, high) = estimate.interval();
        self.of += 1.0;
        self.held += f64::from(u8::from((low..=high).contains(&truth)));
    }
}

#[test]
fn intervals_hold_clocks_are_found_and_axes_are_told() {
    let flights = [
        ("aerobatics", (0.0, 300.0)),
        ("commuter", (0.0, 600.0)),
        ("patrol", (700.0, 1300.0)),
        ("racetrack", (0.0, 600.0)),
    ];
    let flown = flights.map(|(name, span_s)| (flight(name), span_s));
    let paths: Vec<IdealPath> = flown.iter().map(|(flight, span_s)| path(flight, *span_s)).collect();
    let exchanges: Vec<Matrix3<f64>> = Axes::exchanges().collect();
    let kinds = ["clock", "mounting", "bias", "scale factor", "misalignment"];
    let mut found: [Coverage; 5] = Default::default();
    let mut draws = Draws::new(61);
    for trial in 0..TRIALS {
        let (grade, gyro_white, accel_white) =
            [(Grade::Tactical, 0.05, 60.0), (Grade::Industrial, 0.15, 100.0), (Grade::Consumer, 0.3, 300.0)]
                [trial as usize % 3];
        let prior = Prior::of(grade);
        let Prior { gyro_bias, gyro_scale_factor, gyro_misalignment, .. } = prior;
        let Prior { accel_bias, accel_scale_factor, accel_misalignment, .. } = prior;
        let white = (gyro_white * DEG / 60.0, accel_white * 1e-6 * G);
        let exchange = draws.of(&exchanges);
        let phi = Vector3::from_fn(|_, _| 0.5 * DEG * normal(&mut draws));
        let unit = Unit {
            gyro: drawn(&mut draws, gyro_bias, gyro_scale_factor, gyro_misalignment, white.0),
            accel: drawn(&mut draws, accel_bias, accel_scale_factor, accel_misalignment, white.1),
            rotation: rotation_matrix(&rotation_quaternion(&phi)) * exchange,
            behind_s: draws.within(-0.08, 0.08),
            run: trial,
            ..Default::default()
        };
        let which = (trial / 3) as usize % flown.len();
        let record = unit.record(&flown[which].0, flown[which].1);
        let one = identify(&paths[which], &record, &Request { prior, ..Default::default() })
            .unwrap_or_else(|error| panic!("{trial}: {error}"));
        assert!(one.axes.is_seen && one.axes.exchange == exchange, "{trial}: {:?}", one.axes);
        let off_s = one.offset_s.value - unit.behind_s;
        // The slow noise of a consumer's gyros hides a clock in slow manoeuvres.
        let limit_s = if grade == Grade::Consumer { (4.0 * one.offset_s.sigma).max(1e-3) } else { 1e-3 };
        assert!(off_s.abs() < limit_s, "{trial} {}: {off_s} s, {:?}", flights[which].0, one.offset_s);
        found[0].add(&one.offset_s, unit.behind_s);
        let (errors, phi) = in_block_axes(&unit, phi);
        (0..3).for_each(|axis| found[1].add(&one.mounting[axis], phi[axis]));
        for (part, (triad, biases)) in
            [(&one.gyro, unit.gyro.bias), (&one.accel, unit.accel.bias)].into_iter().enumerate()
        {
            for row in 0..3 {
                found[2].add(&triad.bias[row], biases[row]);
                for column in 0..3 {
                    let kind = if row == column { 3 } else { 4 };
                    found[kind].add(&triad.elements[row][column], errors[part][(row, column)]);
                }
            }
        }
    }
    let all = found.iter().fold((0.0, 0.0), |sum, kind| (sum.0 + kind.held, sum.1 + kind.of));
    for (name, kind) in kinds.iter().zip(&found) {
        println!("{name}: {:.1} % of {} intervals hold", 100.0 * kind.held / kind.of, kind.of);
    }
    println!("all: {:.1} %", 100.0 * all.0 / all.1);
    for (name, kind) in kinds.iter().zip(&found) {
        assert!((0.90..=0.98).contains(&(kind.held / kind.of)), "{name}");
    }
    assert!((0.93..=0.97).contains(&(all.0 / all.1)), "{}", all.0 / all.1);
}

/// Jumps of less than an interval of the record (0.04 s) up to 200 s, with noise and without, are named with size and time.
#[test]
fn a_clock_that_jumps_is_named_with_size_and_time() {
    let aerobatics = flight("aerobatics");
    let path = path(&aerobatics, MINUTES);
    let mut wrong = Vec::new();
    for (part, jump_s) in [
        (0.5, 0.03),
        (0.5, 0.1),
        (0.2, 0.1),
        (0.7, -0.3),
        (0.5, 0.6),
        (0.5, -1.5),
        (0.6, 12.0),
        (0.6, -40.0),
        (0.5, 200.0),
    ] {
        let exact = TriadParameters::default();
        let noisy = Unit::default();
        for unit in [noisy, Unit { gyro: exact, accel: exact, ..Default::default() }] {
            let mut record = unit.record(&aerobatics, MINUTES);
            let row = (part * record.len() as f64) as usize;
            let change = |w: &[RecordedIncrement]| {
                (w[5].increment.angle - w[0].increment.angle).norm() / w[0].interval_s
            };
            let changes = record.windows(6).filter(|rows| change(rows) > 0.5 * DEG);
            let changes_s: Vec<f64> = changes.map(|rows| rows[5].time_s).collect();
            let at_s = record[row].time_s - record[row].interval_s;
            record[row..].iter_mut().for_each(|one| one.time_s += jump_s);
            // Stamps ascend: of a clock that goes back the rows before are lost.
            let mut place = 0;
            record.retain(|one| {
                place += 1;
                place > row || one.time_s < at_s + jump_s
            });
            let error = identify(&path, &record, &Request::default()).err();
            let answer = error.map_or("accepted".to_owned(), |error| error.to_string());
            // Where the rates do not change, no time is better than another one. Two blocks of 0.2 s.
            let last_s = changes_s.iter().rfind(|time_s| **time_s < at_s.min(at_s + jump_s)).unwrap_or(&0.0);
            let next_s = changes_s.iter().find(|time_s| **time_s > at_s).unwrap_or(&MINUTES.1);
            let (from_s, to_s) = (last_s - 0.4, next_s + jump_s + 0.4);
            let numbers: Vec<f64> = answer.split([' ', ':']).filter_map(|word| word.parse().ok()).collect();
            let &[size, time_s] = &numbers[..] else { panic!("{jump_s}: {answer}") };
            let is_named = answer.starts_with("record.time_s = ") && answer.contains("jump of the clock");
            // An eighth of an interval.
            let is_right = (size - jump_s).abs() < 0.005 && (from_s..=to_s).contains(&time_s);
            if !(is_named && is_right) {
                wrong.push(format!("{jump_s} from {from_s} to {to_s}: {answer}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// No flight is taken for another one, whose forces or turns may resemble it, and none for one in other units.
#[test]
fn a_record_of_another_flight_is_of_another_motion() {
    let spans = [
        ("aerobatics", [(0.0, 290.0), (100.0, 400.0)]),
        ("commuter", [(0.0, 290.0), (300.0, 600.0)]),
        ("patrol", [(700.0, 990.0), (800.0, 1300.0)]),
        ("racetrack", [(200.0, 490.0), (300.0, 600.0)]),
        ("rest", [(0.0, 100.0), (0.0, 290.0)]),
    ];
    let flown: Vec<_> = spans
        .into_iter()
        .flat_map(|(name, spans)| spans.map(|span_s| (name, span_s)))
        .map(|(name, span_s)| {
            let flight = flight(name);
            (name, path(&flight, span_s), Unit::default().record(&flight, span_s))
        })
        .collect();
    for (of_path, path, _) in &flown {
        for (of_record, _, record) in flown.iter().filter(|one| one.0 != *of_path) {
            let answer = identify(path, record, &Request::default());
            let answer = answer.err().map_or("accepted".to_owned(), |error| error.to_string());
            assert!(answer.contains("of another motion"), "{of_record} along {of_path}: {answer}");
        }
    }
}

/// A given shift is taken to 10 s, on a clock of any epoch; a shift that no clock has is rejected.
#[test]
fn a_given_shift_is_known_to_ten_seconds() {
    let aerobatics = flight("aerobatics");
    let path = path(&aerobatics, MINUTES);
    let unit = Unit { behind_s: -1.7e9, ..Default::default() };
    let record = unit.record(&aerobatics, MINUTES);
    let given =
        |offset_s: f64| identify(&path, &record, &Request { shift_s: Some(offset_s), ..Default::default() });
    for off_s in [0.0, 2.0, -8.0] {
        let one = given(unit.behind_s + off_s).unwrap();
        assert!((one.offset_s.value - unit.behind_s).abs() < 1e-3, "{off_s}: {:?}", one.offset_s);
    }
    for wrong_s in [unit.behind_s + 60.0, 0.0] {
        assert!(given(wrong_s).is_err(), "{wrong_s}");
    }
    assert_eq!(given(2e12).unwrap_err().to_string(), "request.shift_s = 2e12: must be from -1e12 to 1e12");
}

/// At rest only biases are seen: no scale factor, misalignment or shift is reported as if it were known.
#[test]
fn what_a_motion_does_not_show_is_not_seen() {
    let rest = flight("rest");
    let path = path(&rest, MINUTES);
    let one: Identified =
        identify(&path, &Unit::default().record(&rest, MINUTES), &Request::default()).unwrap();
    let seen =
        |triad: &TriadEstimate| triad.elements.iter().flatten().filter(|element| element.is_seen()).count();
    assert_eq!((seen(&one.gyro), one.offset_s.is_seen(), one.axes.is_seen), (0, false, false));
    assert!(one.gyro.bias.iter().all(Estimate::is_seen));
    // A record on its side, whose heading nothing shows, is a question.
    let side =
        Rotation3::from_euler_angles(std::f64::consts::FRAC_PI_2, 0.0, 0.0).into_inner().map(f64::round);
    let record = Unit { rotation: side, ..Default::default() }.record(&rest, MINUTES);
    let error = identify(&path, &record, &Request::default()).unwrap_err().to_string();
    assert!(error.contains("state them"), "{error}");
    let one = identify(&path, &record, &Request { axes: Some(side), ..Default::default() }).unwrap();
    assert_eq!(one.axes.exchange, side);
}

/// A record on a clock of its own, hours away, and of another rate, is found; without noise the parameters are exact.
#[test]
fn a_clock_of_its_own_is_found() {
    let aerobatics = flight("aerobatics");
    let path = path(&aerobatics, MINUTES);
    let gyro = TriadParameters { bias: Vector3::new(1e-4, -2e-4, 3e-4), ..Unit::default().gyro };
    let unit = Unit { gyro, behind_s: 7e5 + 0.0317, ..Default::default() };
    let record: Vec<_> = unit.record(&aerobatics, MINUTES);
    let part = &record[2000..6500];
    let one = identify(&path, part, &Request::default()).unwrap();
    assert!((one.offset_s.value - unit.behind_s).abs() < 1e-3, "{:?}", one.offset_s);
    for axis in 0..3 {
        let bias = one.gyro.bias[axis];
        assert!((bias.value - gyro.bias[axis]).abs() < 4.0 * bias.sigma, "{bias:?}");
    }
}

/// With the errors that were found removed, white noise is left: of its size, without a mean, in all six sensors.
#[test]
fn the_residual_is_the_noise() {
    let mut draws = Draws::new(9);
    let unit = Unit {
        gyro: TriadParameters {
            flicker: Vector3::zeros(),
            rate_random_walk: Vector3::zeros(),
            ..drawn(&mut draws, 30.0 * DEG / 3600.0, 3e-4, 1e-3, 0.1 * DEG / 60.0)
        },
        accel: TriadParameters {
            flicker: Vector3::zeros(),
            rate_random_walk: Vector3::zeros(),
            ..drawn(&mut draws, 1e-3 * G, 3e-4, 1e-3, 100e-6 * G)
        },
        rotation: rotation_matrix(&rotation_quaternion(&Vector3::new(0.02, -0.01, 0.03))),
        behind_s: 0.017,
        run: 3,
        ..Default::default()
    };
    let flight = flight("aerobatics");
    let (path, record) = (path(&flight, MINUTES), unit.record(&flight, MINUTES));
    let request = Request { prior: Prior::of(Grade::Tactical), ..Request::default() };
    let found = identify(&path, &record, &request).unwrap();
    let rest: Vec<_> = record.iter().filter_map(|row| found.residual(&path, row)).collect();
    assert!(record.len() - rest.len() < 3, "{} of {}", rest.len(), record.len());
    let count = rest.len() as f64;
    let span_s = count / RATE_HZ;
    for axis in 0..3 {
        for (name, white, of) in [
            (
                "gyro",
                unit.gyro.random_walk[axis],
                rest.iter().map(|one| one.angle[axis]).collect::<Vec<f64>>(),
            ),
            (
                "accelerometer",
                unit.accel.random_walk[axis],
                rest.iter().map(|one| one.velocity[axis]).collect(),
            ),
        ] {
            let sum: f64 = of.iter().sum();
            let size = (of.iter().map(|value| value * value).sum::<f64>() / count * RATE_HZ).sqrt();
            // Of 7500 rows a deviation is known to 0.8 %.
            assert!((size / white - 1.0).abs() < 0.04, "{name} {axis}: {size:e}, not {white:e}");
            assert!(sum.abs() < 3.0 * white * span_s.sqrt(), "{name} {axis}: {sum:e}");
        }
    }
    // A row outside the path has none.
    let outside = RecordedIncrement { time_s: record[0].time_s - 100.0, ..record[0] };
    assert!(found.residual(&path, &outside).is_none());
}
