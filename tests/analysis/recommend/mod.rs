//! The recommended options meet the requirement, and no cheaper ones do; what is predicted for hours holds.

mod growth;
mod mounting;

use crate::support::{DEG, interface_sample, options_at};
use sins::abi::{
    SINS_OK, SINS_REQUIREMENT_NOT_MET, sins_cost, sins_create, sins_destroy, sins_flight_sample,
    sins_mounting, sins_options, sins_recommend, sins_requirement, sins_set_mounting, sins_status,
};
use sins::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid};
use sins::math::{relative_rotation, rotation_vector};
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::recommend::{Requirement, Rung, Setup, SolutionError, ladder, recommend, step_time_ns};
use sins::state::EarthFixedState;
use sins::truth::FlightSample;
use sins::{ErrorKind, Options, Simulator};

const CRUISE: FlightStart = FlightStart {
    latitude_rad: 40.0 * DEG,
    longitude_rad: 2.0,
    height_m: 8000.0,
    speed_m_s: 200.0,
    heading_rad: 0.3,
    roll_rad: 0.0,
    pitch_rad: 0.0,
    ellipsoid: sins::earth::Ellipsoid::Wgs84,
};
const REST: FlightStart = FlightStart { speed_m_s: 0.0, height_m: 100.0, pitch_rad: 0.1, ..CRUISE };

fn sinusoids(duration_s: f64, moves: [(Channel, f64, f64, f64); 3]) -> Manoeuvre {
    let mut terms =
        [Sinusoid { channel: Channel::Roll, amplitude: 0.0, frequency_hz: 1.0, phase_rad: 0.0 }; 6];
    for (term, (channel, amplitude, frequency_hz, phase_rad)) in terms.iter_mut().zip(moves) {
        *term = Sinusoid { channel, amplitude, frequency_hz, phase_rad };
    }
    Manoeuvre::Sinusoids { duration_s, ramp_s: 2.0, terms, count: 3 }
}

fn samples(flight: &Flight, rate_hz: f64, duration_s: f64) -> Vec<FlightSample> {
    (0..=(duration_s * rate_hz) as u64).map(|k| flight.sample_at(k as f64 / rate_hz).unwrap()).collect()
}

/// The answer of the C function to a host whose simulator has default options, a stated rate and a mounting: scheme, subsamples,
/// updates.
fn asked_through_the_interface(
    samples: &[FlightSample],
    setup: &Setup,
    requirement: &Requirement,
) -> (sins_status, [i32; 3], sins_cost) {
    let samples: Vec<sins_flight_sample> = samples.iter().map(interface_sample).collect();
    let requirement = sins_requirement {
        struct_size: size_of::<sins_requirement>() as u32,
        reserved: 0,
        duration_s: requirement.duration_s,
        position_m: requirement.position_m,
        velocity_m_s: requirement.velocity_m_s,
        attitude_rad: requirement.attitude_rad,
        margin: requirement.margin,
    };
    // SAFETY: structs of numbers; the pointers are those of locals.
    unsafe {
        let (mut options, mut mounting, mut cost): (sins_options, sins_mounting, sins_cost) =
            std::mem::zeroed();
        options.struct_size = size_of::<sins_options>() as u32;
        options.sample_period_s = setup.options.intake.period_s.unwrap();
        mounting.struct_size = size_of::<sins_mounting>() as u32;
        mounting.lever_arm_m = setup.mounting.lever_arm_m.into();
        cost.struct_size = size_of::<sins_cost>() as u32;
        let mut configured = std::ptr::null_mut();
        assert_eq!(sins_create(&options, &mut configured), SINS_OK);
        assert_eq!(sins_set_mounting(configured, &mounting), SINS_OK);
        let (samples, count) = (samples.as_ptr(), samples.len());
        let status = sins_recommend(configured, samples, count, &requirement, &mut options, &mut cost);
        assert_eq!(sins_destroy(configured), SINS_OK);
        (status, [options.scheme, options.subsamples, options.updates_per_sample], cost)
    }
}

struct Scene {
    name: &'static str,
    options: Options,
    samples: Vec<FlightSample>,
    requirement: Requirement,
}

/// Rest, cruise with a turn, aerobatics, vibration, passage of a pole.
fn scenes() -> Vec<Scene> {
    let scene = |name, start: &FlightStart, manoeuvres: &[Manoeuvre], rate_hz, requirement| {
        let flight = Flight::new(start, manoeuvres).unwrap();
        let options = Options { vertical: VerticalMode::Damped, ..options_at(rate_hz) };
        Scene { name, options, samples: samples(&flight, rate_hz, flight.duration_s()), requirement }
    };
    let nothing = Requirement::default();
    vec![
        scene(
            "rest",
            &REST,
            &[Manoeuvre::Rest { duration_s: 120.0 }],
            50.0,
            Requirement { velocity_m_s: 4e-11, ..nothing },
        ),
        scene(
            "cruise",
            &CRUISE,
            &[
                Manoeuvre::Straight { duration_s: 60.0 },
                Manoeuvre::Turn { heading_change_rad: 0.7, bank_rad: 0.4, ramp_s: 5.0 },
                Manoeuvre::Straight { duration_s: 30.0 },
            ],
            50.0,
            Requirement { position_m: 0.1, ..nothing },
        ),
        scene(
            "aerobatics",
            &CRUISE,
            &[
                Manoeuvre::Roll { duration_s: 4.0, turns: 1.0 },
                Manoeuvre::Loop { duration_s: 25.0, turns: 1.0, ramp_s: 5.0 },
                Manoeuvre::Turn { heading_change_rad: -3.0, bank_rad: 1.3, ramp_s: 2.0 },
                Manoeuvre::Roll { duration_s: 5.0, turns: -2.0 },
            ],
            50.0,
            Requirement { position_m: 5e-6, velocity_m_s: 0.01, attitude_rad: 1e-3, ..nothing },
        ),
        scene(
            "vibration",
            &CRUISE,
            &[sinusoids(
                60.0,
                [
                    (Channel::Roll, 0.02, 6.0, 0.0),
                    (Channel::Pitch, 0.02, 6.0, 1.57),
                    (Channel::Climb, 0.005, 4.0, 0.3),
                ],
            )],
            100.0,
            Requirement { attitude_rad: 1e-8, ..nothing },
        ),
        scene(
            "pole",
            &FlightStart { latitude_rad: 89.9 * DEG, heading_rad: 0.01, ..CRUISE },
            &[
                Manoeuvre::Straight { duration_s: 60.0 },
                Manoeuvre::Turn { heading_change_rad: 1.0, bank_rad: 0.5, ramp_s: 4.0 },
            ],
            50.0,
            Requirement { position_m: 1e-7, attitude_rad: 2e-12, ..nothing },
        ),
    ]
}

/// The navigated states, one a step; on the public simulator alone.
fn navigated(options: &Options, samples: &[FlightSample]) -> Vec<EarthFixedState> {
    navigated_by(&mut Simulator::new(options).unwrap(), samples)
}

fn navigated_by(simulator: &mut Simulator, samples: &[FlightSample]) -> Vec<EarthFixedState> {
    let earth = simulator.options().earth();
    let mut states = Vec::new();
    for sample in samples {
        simulator.push_sample(sample).unwrap();
        if simulator.step().unwrap() == sins::Step::Done {
            let solution = simulator.navigation().unwrap().unwrap();
            states.push(solution.navigation.earth_fixed(&earth));
        }
    }
    states
}

fn told(error: &SolutionError) -> String {
    let SolutionError { position_m, velocity_m_s, attitude_rad } = error;
    format!("{position_m:.1e} m, {velocity_m_s:.1e} m/s, {attitude_rad:.1e} rad")
}

fn reference(options: &Options, samples: &[FlightSample]) -> Vec<EarthFixedState> {
    let finest = Rung { scheme: Scheme::Polynomial, subsamples: 5, updates_per_sample: 16 };
    navigated(&finest.applied_to(options), samples)
}

fn worst_difference(states: &[EarthFixedState], reference: &[EarthFixedState]) -> SolutionError {
    assert_eq!(states.len(), reference.len());
    let mut worst = SolutionError::default();
    for (state, reference) in states.iter().zip(reference) {
        let rotation = rotation_vector(&relative_rotation(&reference.q_eb, &state.q_eb)).norm();
        worst.position_m = worst.position_m.max((state.r_e - reference.r_e).norm());
        worst.velocity_m_s = worst.velocity_m_s.max((state.v_e - reference.v_e).norm());
        worst.attitude_rad = worst.attitude_rad.max(rotation);
    }
    worst
}

/// Without any margin: the answer is within the requirement, everything cheaper is beyond it.
#[test]
fn the_answer_meets_the_requirement_and_nothing_cheaper_does() {
    let mut answers: Vec<Rung> = Vec::new();
    for Scene { name, options, samples, requirement } in scenes() {
        let start = std::time::Instant::now();
        let answer = recommend(&options.into(), &samples, &requirement).unwrap();
        let us_per_sample = start.elapsed().as_secs_f64() * 1e6 / samples.len() as f64;
        assert!(answer.met && answer.share <= 1.0, "{name}: {answer:?}");
        let reference = reference(&options, &samples);
        let error =
            |rung: &Rung| worst_difference(&navigated(&rung.applied_to(&options), &samples), &reference);
        let plain = Requirement { margin: 1.0, ..requirement };
        let own = error(&answer.rung);
        assert!(plain.share(&own) <= 1.0, "{name}: {own:?}");
        let (status, [scheme, subsamples, updates], cost) =
            asked_through_the_interface(&samples, &options.into(), &requirement);
        assert_eq!(status, SINS_OK);
        // SINS_SCHEME_... in the order of `Scheme`.
        assert_eq!(scheme, answer.rung.scheme as i32);
        assert_eq!(subsamples as usize, answer.rung.subsamples);
        assert_eq!(updates as usize, answer.rung.updates_per_sample);
        assert_eq!(cost.position_m, answer.predicted.position_m);
        assert_eq!(cost.tried, answer.tried as u64);
        // Told no less than what it is.
        assert!(own.position_m <= answer.predicted.position_m);
        assert!(own.velocity_m_s <= answer.predicted.velocity_m_s);
        assert!(own.attitude_rad <= answer.predicted.attitude_rad);
        let cheaper: Vec<Rung> =
            ladder(options.frame).into_iter().take_while(|rung| *rung != answer.rung).collect();
        assert_eq!(cheaper.len() + 1, answer.tried);
        let mut next_cheaper = SolutionError::default();
        for rung in &cheaper {
            let error = error(rung);
            assert!(plain.share(&error) > 1.0, "{name}: {rung:?} does too: {error:?}");
            next_cheaper = error;
        }
        println!(
            "{name}: {:?}: {}; next cheaper: {}; {} tried, {us_per_sample:.0} us a sample",
            answer.rung,
            told(&own),
            told(&next_cheaper),
            answer.tried,
        );
        answers.push(answer.rung);
    }
    for (index, answer) in answers.iter().enumerate() {
        assert!(!answers[..index].contains(answer), "five scenes, five answers: {answers:?}");
    }
}

/// The best there is, and told so: nothing cheaper takes up as small a share of the requirement, nothing at all a smaller one.
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
            // Over the piece itself nothing grows.
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

/// Nothing meets a limit beyond all rounding, down to the smallest of numbers. The best there is does not depend on how small it is,
/// and what is told of it are numbers, after the fastest growth and with the largest margin too.
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

/// A requirement that the margin alone decides: with more of it the answer costs more.
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

#[test]
fn the_same_piece_has_the_same_answer() {
    let Scene { options, samples, requirement, .. } = scenes().swap_remove(2);
    let first = recommend(&options.into(), &samples, &requirement).unwrap();
    assert_eq!(recommend(&options.into(), &samples, &requirement), Ok(first));
    // What is replaced, what draws and what would hide the error takes no part.
    let other = Options {
        scheme: Scheme::Paper,
        subsamples: 5,
        updates_per_sample: 16,
        error_model: true,
        closed_loop_time_s: Some(30.0),
        key: sins::sensors::StreamKey { seed: 7, run: 1 },
        ..options
    };
    assert_eq!(recommend(&other.into(), &samples, &requirement), Ok(first));
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

/// Nothing to do with a margin of noise: sixteen times the updates take longer.
#[test]
fn more_work_takes_more_time() {
    let Scene { options, samples, .. } = scenes().swap_remove(1);
    let time = |scheme, subsamples, updates_per_sample| {
        let rung = Rung { scheme, subsamples, updates_per_sample };
        step_time_ns(&Setup::from(options).with(&rung), &samples[..200])
    };
    let (short, long) = (time(Scheme::Exact, 1, 1).unwrap(), time(Scheme::Polynomial, 5, 16).unwrap());
    assert!(short > 0.0 && long > 2.0 * short, "{short} ns, {long} ns");
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
