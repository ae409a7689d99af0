//! The recommended options meet the requirement, and no cheaper ones do; the predictions for hours hold.

mod growth;
mod limits;
mod motion;
mod mounting;

use sins::abi::{
    SINS_OK, sins_cost, sins_create, sins_destroy, sins_flight_sample, sins_mounting, sins_options,
    sins_recommend, sins_requirement, sins_set_mounting, sins_status,
};
use sins::analysis::recommend::{Requirement, Rung, Setup, SolutionError, ladder, recommend, step_time_ns};
use sins::earth::state::EarthFixedState;
use sins::math::{relative_rotation, rotation_vector};
use sins::mechanization::{Scheme, VerticalMode};
use sins::truth::FlightSample;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};
use sins::{Options, Simulator};

use crate::support::{DEG, options_at};

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
    let terms = moves.map(|(channel, amplitude, frequency_hz, phase_rad)| Sinusoid {
        channel,
        amplitude,
        frequency_hz,
        phase_rad,
    });
    Manoeuvre::Sinusoids { duration_s, ramp_s: 2.0, sinusoids: Sinusoids::of(&terms) }
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
    let samples: Vec<sins_flight_sample> = samples.iter().map(Into::into).collect();
    let requirement = sins_requirement {
        struct_size: size_of::<sins_requirement>() as u32,
        time_steps: 0,
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
        assert_eq!(cost.ns_per_step, 0.0, "steps were not to be timed");
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

/// The navigated states, one for each step, by the public simulator alone.
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

/// Without any margin the answer is within the requirement, and everything cheaper is beyond it.
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
        // The prediction is no less than the actual error.
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

#[test]
fn the_same_piece_has_the_same_answer() {
    let Scene { options, samples, requirement, .. } = scenes().swap_remove(2);
    let first = recommend(&options.into(), &samples, &requirement).unwrap();
    assert_eq!(recommend(&options.into(), &samples, &requirement), Ok(first));
    // Options that are replaced, that draw, or that would hide the error have no effect.
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

/// The test does not depend on timing noise: sixteen times the updates take longer.
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
