//! `sins recommend`: the cheapest options that meet a required accuracy on a scene.

use nalgebra::Vector3;
use sins::analysis::recommend::{
    MAX_SAMPLES, Motion, Piece as Figures, Recommendation, Requirement, Rung, Setup, SolutionError,
    recommend_by, step_time_ns,
};
use sins::math::{attitude_from_euler, relative_rotation, rotate_inverse, rotation_vector};
use sins::truth::FlightSample;
use sins::units::STANDARD_GRAVITY;

use crate::failure::{Failure, Kind};
use crate::fly::FOR_LOGS;
use crate::given::{Given, SceneArguments};
use crate::limits::{LimitArguments, of_option};
use crate::progress::Progress;
use crate::terminal::{print, quoted};
use crate::units::{brief_parts, stamp_text, time_text, two_digits};

/// Finds the cheapest options that meet a required accuracy
///
/// Flies the scene with each algorithm, cheapest first, and compares it with a reference of known uncertainty. The
/// limits are those of the errors that the algorithm itself causes, at any time; that of the attitude is relative to the Earth, so it is
/// no misalignment relative to north and east at the navigated place. Options and mounting are those of the scene.
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
    /// Start of the piece that is flown, since the first sample
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    pub from: f64,
    /// Length of the piece that is flown; it must contain the hardest motion of the scene
    /// [default: the whole scene, or the hardest parts of a long one]
    #[arg(long, value_name = "SECONDS")]
    pub piece: Option<f64>,
    /// Factor by which the predicted error must be smaller than the required one
    #[arg(long, default_value_t = 2.0)]
    pub margin: f64,
    /// Also measures the time of a step on this machine
    #[arg(long)]
    pub time_steps: bool,
}

const NO_LIMIT: &str =
    "no limit was given: expected --position METRES, --velocity M_PER_S or --attitude ARCSEC";

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = order.scene.load(FOR_LOGS)?;
    given.say_without_updates();
    let SolutionError { position_m, velocity_m_s, attitude_rad } = order.limits.errors();
    if [position_m, velocity_m_s, attitude_rad] == [0.0; 3] {
        return Err(Failure::new(NO_LIMIT));
    }
    let requirement = Requirement {
        duration_s: match order.hours {
            Some(hours) => hours * 3600.0,
            None => given.duration_s.min(Requirement::MAX_DURATION_S),
        },
        position_m,
        velocity_m_s,
        attitude_rad,
        margin: order.margin,
    };
    requirement.validate().map_err(|error| of_option(&error))?;
    let pieces = pieces(order, &given)?;
    let samples: Vec<&[FlightSample]> = pieces.iter().map(|piece| &*piece.samples).collect();
    let setup = Setup { options: given.scene.simulator_options(), mounting: given.scene.errors.mounting };
    let working = Progress::working("trying the algorithms");
    let answer = recommend_by(&setup, &samples, &requirement).map_err(|refusal| match refusal.sample {
        Some(index) => given.failure_at(pieces[refusal.piece].first + index, &refusal.error),
        None => Failure::new(format!("{}: {}", given.origin, refusal.error)),
    })?;
    drop(working);
    let timed = match order.time_steps {
        true => {
            let ns = step_time_ns(&setup.with(&answer.rung), samples[0])?;
            format!("a step takes {ns:.0} ns on this machine\n")
        }
        false => String::new(),
    };
    let judged = judged(&given, order, &pieces)?;
    let next = format!("next: `{}` flies with them\n", flight_with(&given, &answer.rung));
    print(&(text(&given, &answer, &judged) + &timed + &next))?;
    if answer.met {
        return Ok(());
    }
    let what = format!(
        "no options meet the requirement; with the margin, the error of the best options is {} times the limit",
        two_digits(answer.share)
    );
    Err(Failure::of_kind(Kind::NotMet, what))
}

/// Number of pairs of intervals at which a longer scene is searched for its hardest parts.
const SEARCHED: usize = 300_000;
/// Length of a piece of a longer scene [s].
pub const PIECE_S: f64 = 60.0;

/// A part of the scene.
struct Piece {
    /// Index of its first sample.
    first: usize,
    samples: Vec<FlightSample>,
}

impl Piece {
    /// The samples from `first` to `last`.
    fn new(given: &Given, first: usize, last: usize) -> Result<Self, Failure> {
        let samples = (first..=last).map(|index| given.sample(index)).collect::<Result<_, _>>()?;
        Ok(Self { first, samples })
    }

    fn last(&self) -> usize {
        self.first + self.samples.len() - 1
    }

    fn start_s(&self, given: &Given) -> f64 {
        given.time_s(self.first)
    }

    fn duration_s(&self, given: &Given) -> f64 {
        given.time_s(self.last()) - self.start_s(given)
    }
}

/// The parts of the scene by which the algorithms are judged.
fn pieces(order: &Order, given: &Given) -> Result<Vec<Piece>, Failure> {
    let wrong = |what: &str| {
        let piece = order.piece.map_or_else(String::new, |piece_s| format!(" --piece {piece_s}"));
        let from = order.from;
        Err(Failure::new(format!("--from {from}{piece}: {what}; it lasts {}", stamp_text(given.duration_s))))
    };
    if !(0.0..=given.duration_s).contains(&order.from) || order.piece.is_some_and(|piece_s| piece_s.is_nan())
    {
        return wrong("the piece must begin in the scene");
    }
    let end = given.count - 1;
    let first = given.index_at(order.from);
    let last = order.piece.map_or(end, |piece_s| given.index_at(order.from + piece_s));
    if last <= first {
        return wrong("the scene has no two samples there");
    }
    let count = last - first + 1;
    if order.piece.is_some() && count > MAX_SAMPLES {
        return wrong(&format!("the piece has {count} samples, more than {MAX_SAMPLES}"));
    }
    let latest_s = given.time_s(end) - PIECE_S;
    if order.piece.is_some() || count <= MAX_SAMPLES || latest_s <= given.time_s(first) {
        return Ok(vec![Piece::new(given, first, last)?]);
    }
    let parts = hardest_parts(given, first, last)?;
    parts.into_iter().map(|(first, last)| Piece::new(given, first, last)).collect()
}

/// First and last sample of the hardest parts of the scene between two samples that are more than a piece apart: one for the largest of
/// each of [`HARD`], which is in its middle.
pub fn hardest_parts(given: &Given, first: usize, last: usize) -> Result<Vec<(usize, usize)>, Failure> {
    let latest_s = given.time_s(last) - PIECE_S;
    let begin_s = |at: usize| (given.time_s(at) - PIECE_S / 2.0).clamp(given.time_s(first), latest_s);
    let mut parts = hardest(given, first, last - first + 1)?.map(|(_, at)| {
        let begin = given.index_at(begin_s(at)).min(last - 1);
        (begin, given.index_at(begin_s(at) + PIECE_S).clamp(begin + 1, begin + MAX_SAMPLES - 1))
    });
    parts.sort_unstable();
    let mut parts = parts.to_vec();
    parts.dedup();
    Ok(parts)
}

/// What makes a part of the scene hard.
const HARD: [&str; 4] = ["rate", "specific force", "vibration", "coning"];

/// The largest of each of [`HARD`] at up to [`SEARCHED`] pairs of intervals from sample `first` on, and the index of the pair.
///
/// Coning, and sculling in units of g, is a mean over the length of a piece: of the product of the turns of a pair, and of the turn with
/// the change of velocity. Its error grows with the time, however slow and gentle the motion is at each moment.
fn hardest(given: &Given, first: usize, count: usize) -> Result<[(f64, usize); 4], Failure> {
    let options = given.scene.simulator_options();
    let mut worst = [(0.0, first); 4];
    let (mut part, mut products) = (0, [Vector3::zeros(); 2]);
    for index in (first..first + count - 2).step_by(count.div_ceil(SEARCHED)) {
        let samples = [given.sample(index)?, given.sample(index + 1)?, given.sample(index + 2)?];
        let pair = Figures::new(&options, &samples).map_err(|refusal| {
            given.failure_at(index + refusal.sample.unwrap_or_default(), &refusal.error)
        })?;
        let now = (given.time_s(index) / PIECE_S) as usize;
        if now != part {
            (part, products) = (now, [Vector3::zeros(); 2]);
        }
        products.iter_mut().zip(turn_products(&samples)).for_each(|(sum, product)| *sum += product);
        let [rate, force, vibration] = pair.motion.values();
        let coning = products[0].norm() + products[1].norm();
        for (worst, value) in worst.iter_mut().zip([rate, force, vibration, coning]) {
            if value > worst.0 {
                *worst = (value, index);
            }
        }
    }
    Ok(worst)
}

/// Products of the turn from the first sample to the second with that from the second to the third, and with the change of velocity.
fn turn_products(samples: &[FlightSample; 3]) -> [Vector3<f64>; 2] {
    let [before, now, next] = [0, 1, 2].map(|k| attitude_from_euler(&samples[k].euler));
    let turn = |from, to| rotation_vector(&relative_rotation(from, to));
    let (first, second) = (turn(&before, &now), turn(&now, &next));
    let change = match [0, 1, 2].map(|k| samples[k].v_n) {
        [Some(before), Some(now), Some(next)] => [now - before, next - now].map(|v| v / STANDARD_GRAVITY),
        _ => [Vector3::zeros(); 2],
    };
    let of_body = |v| rotate_inverse(&now, &v);
    [first.cross(&second), first.cross(&of_body(change[1])) - second.cross(&of_body(change[0]))]
}

/// What the algorithms were judged by, and whether another part of the scene is harder than a piece that was chosen.
fn judged(given: &Given, order: &Order, pieces: &[Piece]) -> Result<String, Failure> {
    let whole = stamp_text(given.duration_s);
    if pieces.iter().any(|piece| piece.samples.len() == given.count) {
        return Ok(format!("judged by the whole scene of {whole}"));
    }
    let (first, piece) = (&pieces[0], stamp_text(pieces[0].duration_s(given)));
    if order.piece.is_some() || order.from > 0.0 && pieces.len() == 1 {
        let own = first.first..first.last() + 1;
        let of_piece = hardest(given, first.first, first.samples.len())?;
        let harder = HARD
            .into_iter()
            .zip(hardest(given, 0, given.count)?.into_iter().zip(of_piece))
            .filter(|(_, ((value, at), (of_piece, _)))| value > of_piece && !own.contains(at))
            .map(|(name, ((_, at), _))| format!("a larger {name} at {}", stamp_text(given.time_s(at))))
            .collect::<Vec<_>>();
        let verdict = match harder.is_empty() {
            true => "no other part is harder".to_owned(),
            false => format!("may not hold elsewhere, with {}", harder.join(", ")),
        };
        let from = stamp_text(first.start_s(given));
        return Ok(format!("judged by {piece} from {from}, of {whole}: {verdict}"));
    }
    let begins: Vec<_> = pieces.iter().map(|piece| stamp_text(piece.start_s(given))).collect();
    Ok(format!(
        "judged by {} of {piece}, at {}, of {whole}: the largest rate, force, vibration and coning",
        if pieces.len() == 1 { "1 piece".to_owned() } else { format!("{} pieces", pieces.len()) },
        begins.join(", ")
    ))
}

/// The command that flies the scene with the options of `rung`.
fn flight_with(given: &Given, rung: &Rung) -> String {
    let scene = quoted(given.origin.trim_end_matches(" (built in)"));
    let (scheme, subsamples, updates) = (rung.scheme.word(), rung.subsamples, rung.updates_per_sample);
    let settings = [
        format!("scheme={scheme}"),
        format!("subsamples={subsamples}"),
        format!("updates_per_sample={updates}"),
    ];
    let settings = settings.map(|setting| format!(" --set options.{setting}")).concat();
    format!("sins fly {scene}{settings}")
}

/// Text of the answer: the options as in a scene, and their remaining errors.
fn text(given: &Given, answer: &Recommendation, judged: &str) -> String {
    let Motion { rate_max, force_max, vibration_max } = answer.motion;
    let scheme = answer.rung.scheme.word();
    let since = |time_s: f64| stamp_text((time_s - given.start_s).max(0.0));
    format!(
        "# {}: {}\n[options]\nscheme = \"{scheme}\"\nsubsamples = {}\nupdates_per_sample = {}\n\n\
         {judged}\n  largest rate {} deg/s at {}, specific force {} m/s2 at {}, vibration {} deg/s2 at {}\n\
         error within {}: {}\n  of which uncertainty of the reference: {}\n{} tried\n",
        given.origin,
        given.title,
        answer.rung.subsamples,
        answer.rung.updates_per_sample,
        two_digits(rate_max.value.to_degrees()),
        since(rate_max.time_s),
        two_digits(force_max.value),
        since(force_max.time_s),
        two_digits(vibration_max.value.to_degrees()),
        since(vibration_max.time_s),
        time_text(answer.duration_s),
        brief_parts(answer.predicted.parts()),
        brief_parts(answer.uncertainty.parts()),
        if answer.tried == 1 {
            "1 algorithm was".to_owned()
        } else {
            format!("{} algorithms were", answer.tried)
        },
    )
}
