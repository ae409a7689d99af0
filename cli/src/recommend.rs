//! `sins recommend`: the cheapest options that meet a required accuracy on a scene.

use sins::recommend::{
    MAX_SAMPLES, Recommendation, Requirement, Setup, SolutionError, recommend, step_time_ns,
};
use sins::truth::FlightSample;

use crate::curve::scheme_name;
use crate::failure::{Failure, Kind};
use crate::fly::FOR_LOGS;
use crate::given::{Given, SceneArguments};
use crate::limits::LimitArguments;
use crate::progress::Progress;
use crate::terminal::print;
use crate::units::{brief_parts, time_text, two_digits};

/// Finds the cheapest options that meet a required accuracy
///
/// Flies the scene with each algorithm, cheapest first, and compares it with a reference of known uncertainty. The
/// limits are those of the errors that the algorithm itself causes, at any time. Options and mounting are those of the scene.
/// Sensor errors, also those of --preset, do not matter.
#[derive(Debug, clap::Args)]
pub struct Order {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Duration for which the accuracy is required [default: the whole scene]
    #[arg(long)]
    pub hours: Option<f64>,
    /// Start of the piece that is flown
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    pub from: f64,
    /// Length of the piece that is flown; it must contain the hardest motion of the scene [default: to the end]
    #[arg(long, value_name = "SECONDS")]
    pub piece: Option<f64>,
    /// Factor by which the predicted error must be smaller than the required one
    #[arg(long, default_value_t = 2.0)]
    pub margin: f64,
}

const NO_LIMIT: &str =
    "no limit was given: expected --position METRES, --velocity M_PER_S or --attitude ARCSEC";

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = order.scene.load(FOR_LOGS)?;
    let hours = order.hours.unwrap_or(given.duration_s / 3600.0);
    let SolutionError { position_m, velocity_m_s, attitude_rad } = order.limits.errors();
    if [position_m, velocity_m_s, attitude_rad] == [0.0; 3] {
        return Err(Failure::new(NO_LIMIT));
    }
    let requirement = Requirement {
        duration_s: (hours * 3600.0).min(if order.hours.is_some() {
            f64::INFINITY
        } else {
            Requirement::MAX_DURATION_S
        }),
        position_m,
        velocity_m_s,
        attitude_rad,
        margin: order.margin,
    };
    requirement.validate()?;
    let (first, samples) = piece(order, &given)?;
    let setup = Setup { options: given.scene.simulator_options(), mounting: given.scene.errors.mounting };
    let working = Progress::working("trying the algorithms");
    let answer = recommend(&setup, &samples, &requirement).map_err(|refusal| match refusal.sample {
        Some(index) => given.failure_at(first + index, &refusal.error),
        None => Failure::new(format!("{}: {}", given.origin, refusal.error)),
    })?;
    drop(working);
    let ns = step_time_ns(&setup.with(&answer.rung), &samples)?;
    print(&text(&given, &answer, ns, &judged(&given, first, samples.len())))?;
    if answer.met {
        return Ok(());
    }
    let what = format!(
        "no options meet the requirement; with the margin, the error of the best options is {} times the limit",
        two_digits(answer.share)
    );
    Err(Failure::of_kind(Kind::NotMet, what))
}

/// Index of the first sample of the piece, and the samples.
fn piece(order: &Order, given: &Given) -> Result<(usize, Vec<FlightSample>), Failure> {
    let at = |seconds: f64| (seconds / given.period_s).round() as usize;
    let first = at(order.from.max(0.0));
    let rest = given.count.saturating_sub(first);
    let count = order.piece.map_or(rest, |piece_s| rest.min(at(piece_s.max(0.0)) + 1));
    let wrong = |what: &str| {
        let piece = order.piece.map_or_else(String::new, |piece_s| format!(" --piece {piece_s}"));
        let from = order.from;
        Err(Failure::new(format!("--from {from}{piece}: {what}; it lasts {:.6} s", given.duration_s)))
    };
    if count < 2 {
        return wrong("the scene has no two samples there");
    }
    if count > MAX_SAMPLES {
        return wrong(&format!(
            "{count} samples of the scene are more than {MAX_SAMPLES}; choose its hardest part with --from and --piece"
        ));
    }
    let samples = (first..first + count).map(|index| given.sample(index)).collect::<Result<_, _>>()?;
    Ok((first, samples))
}

/// The part of the scene by which the algorithms were judged.
fn judged(given: &Given, first: usize, count: usize) -> String {
    if count == given.count {
        return format!("judged by the whole scene of {:.6} s", given.duration_s);
    }
    let (from_s, piece_s) = (first as f64 * given.period_s, (count - 1) as f64 * given.period_s);
    format!(
        "judged by {piece_s:.6} s from {from_s:.6} s, of {:.6} s; true only if no other part is harder",
        given.duration_s
    )
}

/// Text of the answer: the options as in a scene, and their remaining errors.
fn text(given: &Given, answer: &Recommendation, ns: f64, judged: &str) -> String {
    let scheme = scheme_name(answer.rung.scheme);
    format!(
        "# {}: {}\n[options]\nscheme = \"{scheme}\"\nsubsamples = {}\nupdates_per_sample = {}\n\n\
         {judged}\nerror within {}: {}\n  of which uncertainty of the reference: {}\na step takes {ns:.0} ns on this machine; {} algorithms were tried\n",
        given.origin,
        given.title,
        answer.rung.subsamples,
        answer.rung.updates_per_sample,
        time_text(answer.duration_s),
        brief_parts(answer.predicted.parts()),
        brief_parts(answer.uncertainty.parts()),
        answer.tried,
    )
}
