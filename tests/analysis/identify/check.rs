//! The check of identified sensors on the rest of their record: right models agree in the promised part of the cases, wrong ones do not.

use sins::analysis::identify::check::{Agreement, Check, CheckRequest, Truth, check};
use sins::analysis::identify::{Prior, RecordedIncrement, Request, identify};
use sins::sensors::{Grade, TriadParameters};
use sins::{Options, truth::flight::Flight};

use super::{DEG, Draws, G, Unit, drawn, flight, times};

/// Flights and their parts [s]: half of the record is identified, the other half is checked.
const FLIGHTS: [(&str, (f64, f64)); 2] = [("aerobatics", (0.0, 400.0)), ("racetrack", (200.0, 700.0))];
const TRIALS: u64 = if cfg!(feature = "long-tests") { 200 } else { 12 };
/// Models with other noise, of each kind.
const MODELS: u64 = if cfg!(feature = "long-tests") { 8 } else { 2 };

/// A flight, its part and its truth.
fn flown((name, span_s): (&str, (f64, f64))) -> (Flight, (f64, f64), Truth) {
    let flight = flight(name);
    let truth =
        Truth::fly(&Options::default(), times(span_s).map(|time_s| flight.sample_at(time_s))).unwrap();
    (flight, span_s, truth)
}

fn halves(record: &[RecordedIncrement]) -> (&[RecordedIncrement], &[RecordedIncrement]) {
    record.split_at(record.len() / 2)
}

/// Sensors of tactical grade, by how many times as large their noise is: white noise, and with `is_slow` flicker noise and a random walk.
fn unit(draws: &mut Draws, run: u64, is_slow: bool) -> impl Fn(f64) -> Unit + use<> {
    let Prior { gyro_bias, gyro_scale_factor, gyro_misalignment, .. } = Prior::of(Grade::Tactical);
    let Prior { accel_bias, accel_scale_factor, accel_misalignment, .. } = Prior::of(Grade::Tactical);
    let gyro = drawn(draws, gyro_bias, gyro_scale_factor, gyro_misalignment, 0.1 * DEG / 60.0);
    let accel = drawn(draws, accel_bias, accel_scale_factor, accel_misalignment, 100e-6 * G);
    let behind_s = draws.within(-0.08, 0.08);
    move |noise: f64| {
        let of = |triad: &TriadParameters| TriadParameters {
            random_walk: triad.random_walk * noise,
            flicker: triad.flicker * if is_slow { noise } else { 0.0 },
            rate_random_walk: triad.rate_random_walk * if is_slow { noise } else { 0.0 },
            ..*triad
        };
        Unit { gyro: of(&gyro), accel: of(&accel), behind_s, run, ..Default::default() }
    }
}

/// Identifies the first half of `of_model`, and checks the second half of `real`.
fn checked(truth: &Truth, of_model: &[RecordedIncrement], real: &[RecordedIncrement]) -> Check {
    let prior = Prior::of(Grade::Tactical);
    let found = identify(truth.path(), halves(of_model).0, &Request { prior, ..Default::default() }).unwrap();
    let request = CheckRequest { twins: 60, ..Default::default() };
    check(truth, &found, halves(real).1, &request).unwrap()
}

#[test]
fn a_right_model_agrees_with_the_rest_of_its_record() {
    let flown = FLIGHTS.map(flown);
    let mut draws = Draws::new(7);
    let mut agreed = 0;
    for run in 0..TRIALS {
        let (flight, span_s, truth) = &flown[run as usize % 2];
        let unit = unit(&mut draws, run, true)(1.0);
        let record = unit.record(flight, *span_s);
        let found = checked(truth, &record, &record);
        agreed += u64::from(found.agreement == Agreement::Agrees);
        let line: Vec<String> = found
            .spans
            .iter()
            .map(|span| format!("{} s: {:.3} for {:.3} m", span.duration_s, span.real_m, span.predicted_m))
            .collect();
        println!("{run} {:?}: {}", found.agreement, line.join(", "));
    }
    println!("{agreed} of {TRIALS} agree");
    // Four standard deviations of a count.
    let (mean, sigma) = (0.95 * TRIALS as f64, (0.95 * 0.05 * TRIALS as f64).sqrt());
    assert!(agreed as f64 >= mean - 4.0 * sigma, "{agreed} of {TRIALS}");
}

#[test]
fn a_model_with_a_third_of_the_noise_is_too_good_and_one_with_three_times_too_bad() {
    // Long enough for 48 flights of 10 s in each half: a factor of two is beyond their scatter.
    let (flight, span_s, truth) = flown(("racetrack", (200.0, 1200.0)));
    let mut draws = Draws::new(8);
    for run in 0..MODELS {
        let of_noise = unit(&mut draws, run, false);
        let [small, real, large] = [1.0 / 3.0, 1.0, 3.0].map(|noise| of_noise(noise).record(&flight, span_s));
        let (good, bad) = (checked(&truth, &small, &real), checked(&truth, &large, &real));
        println!("{run}: {:?} {:?}", good.agreement, bad.agreement);
        assert!(matches!(good.agreement, Agreement::TooGood(1.5..6.0)), "{run}: {good:#?}");
        assert!(matches!(bad.agreement, Agreement::TooBad(1.5..6.0)), "{run}: {bad:#?}");
    }
}

/// The steps of a twin are those of the path: where the path has a fifth of the rate of the record and ends with it, no flight of a twin
/// ends behind the path.
#[test]
fn a_record_of_a_higher_rate_than_the_path_is_checked_to_its_end() {
    let (name, span_s) = FLIGHTS[1];
    let flight = flight(name);
    let samples = times(span_s).step_by(5).map(|time_s| flight.sample_at(time_s));
    let truth = Truth::fly(&Options::default(), samples).unwrap();
    let record = unit(&mut Draws::new(3), 0, false)(1.0).record(&flight, span_s);
    let found = checked(&truth, &record, &record);
    assert!(found.length_s > 248.0 && found.spans.len() == 4, "{found:?}");
}

/// A recorder writes a row late, right before the next one: both are one step.
#[test]
fn rows_that_follow_each_other_at_once_are_checked() {
    let (flight, span_s, truth) = flown(FLIGHTS[0]);
    let record = unit(&mut Draws::new(5), 0, false)(1.0).record(&flight, span_s);
    let mut late = record.clone();
    let place = 3 * record.len() / 4;
    late[place].time_s = late[place + 1].time_s - 1e-6;
    let [real_m, late_m] = [&record, &late].map(|record| checked(&truth, record, record).spans[0].real_m);
    assert!((late_m / real_m - 1.0).abs() < 0.1, "{late_m} is not {real_m}");
}
