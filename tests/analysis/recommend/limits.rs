//! Requirements that nothing meets, margins, geographic axes beside a pole, and bad samples.

use sins::abi::SINS_REQUIREMENT_NOT_MET;
use sins::analysis::recommend::{Requirement, Rung, SolutionError, ladder, recommend};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, Options, Simulator};

use super::{
    CRUISE, Scene, asked_through_the_interface, navigated, reference, samples, scenes, worst_difference,
};
use crate::support::options_at;

/// The answer is the best one, and is reported so: no cheaper options use as small a share of the requirement, none a smaller one.
#[test]
fn an_impossible_requirement_gets_the_best_there_is() {
    let requirement = Requirement { attitude_rad: 1e-16, position_m: 1e-10, ..Default::default() };
    // At rest many are equally good, in aerobatics no two.
    for scene in [0, 2] {
        let Scene { name, options, samples, .. } = scenes().swap_remove(scene);
        let samples = &samples[..400];
        let start = std::time::Instant::now();
        let answer = recommend(&options.into(), samples, &requirement).unwrap();
        println!("not met: {:.0} us a sample", start.elapsed().as_secs_f64() * 1e6 / samples.len() as f64);
        let ladder = ladder(options.frame);
        assert!(!answer.met && answer.share > 1.0 && answer.tried == ladder.len(), "{name}: {answer:?}");
        let reference = reference(&options, samples);
        let shares = ladder.iter().map(|rung| {
            let error = worst_difference(&navigated(&rung.applied_to(&options), samples), &reference);
            // Over the piece itself the errors do not grow.
            requirement.share(&error.plus(&answer.uncertainty))
        });
        let rounding = 1e-12 * answer.share;
        let mut is_cheaper = true;
        for (rung, share) in ladder.iter().zip(shares) {
            if *rung == answer.rung {
                assert!((share - answer.share).abs() < rounding, "{name}: {share} is told as {answer:?}");
                is_cheaper = false;
            } else if is_cheaper {
                assert!(share > answer.share + rounding, "{name}: {rung:?} has {share}, {answer:?}");
            } else {
                assert!(share > answer.share - rounding, "{name}: {rung:?} has {share}, {answer:?}");
            }
        }
    }
}

/// No options meet a limit below all rounding, down to the smallest of numbers. The best answer does not depend on how small the
/// limit is, and its figures are finite, also after the fastest growth and with the largest margin.
#[test]
fn the_smallest_limits_get_the_best_there_is() {
    let Scene { options, samples, .. } = scenes().swap_remove(2);
    let samples = &samples[..100];
    let ask = |position_m| Requirement { position_m, ..Default::default() };
    let best = recommend(&options.into(), samples, &ask(1e-30)).unwrap();
    for limit in [1e-100, 1e-200, f64::MIN_POSITIVE, 5e-324] {
        let answer = recommend(&options.into(), samples, &ask(limit)).unwrap();
        assert_eq!(
            (answer.met, answer.rung, answer.predicted),
            (false, best.rung, best.predicted),
            "{limit:e}"
        );
        assert!(answer.share.is_finite() && answer.share > best.share, "{limit:e}: {answer:?}");
        let (status, _, cost) = asked_through_the_interface(samples, &options.into(), &ask(limit));
        assert_eq!((status, cost.share), (SINS_REQUIREMENT_NOT_MET, answer.share));
    }
    let free = Options { vertical: VerticalMode::Free, ..options };
    let hardest = Requirement { duration_s: Requirement::MAX_DURATION_S, margin: 1e6, ..ask(5e-324) };
    let answer = recommend(&free.into(), &samples[..3], &hardest).unwrap();
    assert!(!answer.met && answer.share.is_finite(), "{answer:?}");
}

/// A requirement that the margin alone decides: a larger margin makes the answer more expensive.
#[test]
fn the_margin_is_kept() {
    let Scene { options, samples, .. } = scenes().swap_remove(1);
    let answer = |margin| {
        let requirement = Requirement { position_m: 0.1, margin, ..Default::default() };
        recommend(&options.into(), &samples, &requirement).unwrap()
    };
    let two = answer(2.0);
    let more = answer(1.01 * 0.1 / two.predicted.position_m);
    assert_eq!(answer(0.99 * 0.1 / two.predicted.position_m).rung, two.rung);
    assert!(more.rung != two.rung && more.tried > two.tried, "{more:?}");
}

/// Geographic axes: their own ladder, and no answer within reach of a pole.
#[test]
fn geographic_axes_have_answers_but_at_the_pole() {
    let mut scenes = scenes();
    let pole = scenes.pop().unwrap();
    let cruise = scenes.swap_remove(1);
    let options = Options { frame: Frame::Geographic, ..cruise.options };
    let answer = recommend(&options.into(), &cruise.samples, &cruise.requirement).unwrap();
    assert!(answer.met);
    let states = navigated(&answer.rung.applied_to(&options), &cruise.samples);
    let error = worst_difference(&states, &reference(&cruise.options, &cruise.samples));
    assert!(error.position_m <= cruise.requirement.position_m, "{error:?}");

    let options = Options { frame: Frame::Geographic, ..pole.options };
    let refusal = recommend(&options.into(), &pole.samples, &pole.requirement).unwrap_err();
    assert!(refusal.error.kind == ErrorKind::Singular && refusal.sample.is_some(), "{refusal}");
}

/// 250 m/s a second past 20 km off the pole turn the axes too far for one update, and not for two.
#[test]
fn geographic_axes_near_a_pole_are_given_the_updates_that_they_need() {
    let away_m = 20e3;
    let start = FlightStart {
        latitude_rad: core::f64::consts::FRAC_PI_2 - away_m / 6.4e6,
        heading_rad: core::f64::consts::FRAC_PI_2,
        speed_m_s: 250.0,
        ..CRUISE
    };
    let flight = Flight::new(&start, &[Manoeuvre::Straight { duration_s: 20.0 }]).unwrap();
    let samples = samples(&flight, 1.0, 20.0);
    let options = Options { frame: Frame::Geographic, ..options_at(1.0) };
    let one = Rung { scheme: Scheme::Exact, subsamples: 2, updates_per_sample: 1 };
    let mut simulator = Simulator::new(&one.applied_to(&options)).unwrap();
    let refused = samples.iter().find_map(|sample| {
        simulator.push_sample(sample).unwrap();
        simulator.step().err()
    });
    assert_eq!(refused.map(|error| error.kind), Some(ErrorKind::Singular));

    let requirement = Requirement { position_m: 100.0, ..Default::default() };
    let answer = recommend(&options.into(), &samples, &requirement).unwrap();
    assert!(answer.met && answer.rung.updates_per_sample > 1, "{answer:?}");
}

#[test]
fn a_bad_piece_is_refused_with_its_sample() {
    let Scene { options, samples, requirement, .. } = scenes().swap_remove(0);
    let kind = |samples: &[FlightSample]| {
        let refusal = recommend(&options.into(), samples, &requirement).unwrap_err();
        (refusal.error.kind, refusal.sample)
    };
    assert_eq!(kind(&[]), (ErrorKind::InvalidArgument, None));
    assert_eq!(kind(&samples[..1]), (ErrorKind::InvalidArgument, None));
    let mut bad = samples[..20].to_vec();
    bad[7].place.latitude_rad = 2.0;
    assert_eq!(kind(&bad), (ErrorKind::InvalidArgument, Some(7)));
    bad[7] = bad[6];
    assert_eq!(kind(&bad), (ErrorKind::TimeOrder, Some(7)));
    bad[7] = samples[7];
    bad[12].euler.roll = 3.1;
    assert_eq!(kind(&bad), (ErrorKind::Discontinuity, Some(12)));
    // Two samples are a piece.
    let easy = Requirement { position_m: 1.0, ..Default::default() };
    assert!(recommend(&options.into(), &samples[..2], &easy).unwrap().met);
}

#[test]
fn the_largest_share_counts_and_what_does_not_matter_does_not() {
    let error = SolutionError { position_m: 1.0, velocity_m_s: 0.1, attitude_rad: 1e9 };
    let requirement = Requirement { position_m: 8.0, velocity_m_s: 0.4, ..Default::default() };
    assert_eq!(requirement.share(&error), 0.5);
    assert_eq!(Requirement { margin: 4.0, ..requirement }.share(&error), 1.0);
}

#[test]
fn a_bad_field_is_named_and_one_limit_is_needed() {
    let good = Requirement { velocity_m_s: 1.0, ..Default::default() };
    assert_eq!(good.validate(), Ok(()));
    for (bad, field) in [
        (Requirement { duration_s: -1.0, ..good }, "requirement.duration_s"),
        (Requirement { duration_s: 1.1e6, ..good }, "requirement.duration_s"),
        (Requirement { position_m: f64::NAN, ..good }, "requirement.position_m"),
        (Requirement { velocity_m_s: -0.1, ..good }, "requirement.velocity_m_s"),
        (Requirement { attitude_rad: f64::INFINITY, ..good }, "requirement.attitude_rad"),
        (Requirement { margin: 0.9, ..good }, "requirement.margin"),
        (Requirement::default(), "requirement.position_m"),
    ] {
        assert_eq!(bad.validate().unwrap_err().field, field, "{bad:?}");
    }
}
