//! `sins recommend`: the cheapest options that meet a required accuracy on a scene.

use std::ffi::OsString;
use std::path::PathBuf;

use sins::mechanization::Scheme;
use sins::recommend::{MAX_SAMPLES, Recommendation, Requirement, Setup, recommend, step_time_ns};
use sins::truth::FlightSample;
use sins::units::ARCSEC;

use crate::failure::{Failure, Kind};
use crate::fly::FOR_LOGS;
use crate::given::{Given, Settings};
use crate::progress::Progress;
use crate::terminal::print;
use crate::units::{ANGLE, LENGTH, SPEED, brief, time_text, two_digits};

/// Finds the cheapest options that meet a required accuracy
///
/// Flies a piece of the scene with each algorithm, cheapest first, and compares it with a reference of known uncertainty.
/// Options and mounting of the scene count; sensor errors do not.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// A built-in scene (`sins scene list`), a file SCENE.toml, or a flight log LOG.csv
    #[arg(value_name = "SCENE")]
    pub scene: Option<OsString>,
    /// Uses this flight log instead of the scene's own flight
    #[arg(long, value_name = "LOG.csv")]
    pub log: Option<PathBuf>,
    #[command(flatten)]
    pub settings: Settings,
    /// Largest position error that the algorithm itself may cause; 0: no limit
    #[arg(long, value_name = "METRES", default_value_t = 0.0)]
    pub position: f64,
    /// Largest velocity error that the algorithm itself may cause; 0: no limit
    #[arg(long, value_name = "M_PER_S", default_value_t = 0.0)]
    pub velocity: f64,
    /// Largest attitude error that the algorithm itself may cause; 0: no limit
    #[arg(long, value_name = "ARCSEC", default_value_t = 0.0)]
    pub attitude: f64,
    /// Duration for which the accuracy is required [default: the whole scene]
    #[arg(long)]
    pub hours: Option<f64>,
    /// Start of the piece
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    pub from: f64,
    /// Length of the piece
    #[arg(long, value_name = "SECONDS", default_value_t = 120.0)]
    pub piece: f64,
    /// Factor by which the predicted error must be smaller than the required one
    #[arg(long, default_value_t = 2.0)]
    pub margin: f64,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let given = Given::load(order.scene.as_deref(), order.log.as_deref(), &order.settings, FOR_LOGS)?;
    let hours = order.hours.unwrap_or(given.duration_s / 3600.0);
    let requirement = Requirement {
        duration_s: (hours * 3600.0).min(if order.hours.is_some() {
            f64::INFINITY
        } else {
            Requirement::MAX_DURATION_S
        }),
        position_m: order.position,
        velocity_m_s: order.velocity,
        attitude_rad: ARCSEC * order.attitude,
        margin: order.margin,
    };
    requirement.validate()?;
    let (first, samples) = piece(order, &given)?;
    let setup = Setup { options: given.scene.simulator_options(), mounting: given.scene.errors.mounting };
    let working = Progress::working("trying the algorithms");
    let answer = recommend(&setup, &samples, &requirement).map_err(|refusal| match refusal.sample {
        Some(index) => given.refusal(first + index, &refusal.error),
        None => Failure::new(format!("{}: {}", given.origin, refusal.error)),
    })?;
    drop(working);
    let ns = step_time_ns(&setup.with(&answer.rung), &samples)?;
    print(&text(&given, &answer, ns))?;
    if answer.met {
        return Ok(());
    }
    let what = format!(
        "no options meet the requirement; with the margin, the error of these is {} times the limit",
        two_digits(answer.share)
    );
    Err(Failure::of_kind(Kind::NotMet, what))
}

/// The samples of the piece, and the number of the first.
fn piece(order: &Order, given: &Given) -> Result<(usize, Vec<FlightSample>), Failure> {
    let at = |seconds: f64| (seconds / given.period_s).round() as usize;
    let first = at(order.from.max(0.0));
    let count = (at(order.piece.max(0.0)) + 1).min(MAX_SAMPLES).min(given.count.saturating_sub(first));
    if count < 2 {
        let what = format!(
            "--from {} --piece {}: the scene has no two samples there; it lasts {:.6} s",
            order.from, order.piece, given.duration_s
        );
        return Err(Failure::new(what));
    }
    let samples = (first..first + count).map(|index| given.sample(index)).collect::<Result<_, _>>()?;
    Ok((first, samples))
}

/// The answer, as a scene has it, and what it leaves.
fn text(given: &Given, answer: &Recommendation, ns: f64) -> String {
    let scheme = match answer.rung.scheme {
        Scheme::Exact => "exact",
        Scheme::Paper => "paper",
        Scheme::Polynomial => "polynomial",
    };
    let leaves = |error: &sins::recommend::SolutionError| {
        format!(
            "{}, {}, {}",
            brief(error.position_m, LENGTH),
            brief(error.velocity_m_s, SPEED),
            brief(error.attitude_rad, ANGLE)
        )
    };
    format!(
        "# {}: {}\n[options]\nscheme = \"{scheme}\"\nsubsamples = {}\nupdates_per_sample = {}\n\n\
         leaves in {}: {}\n  of it the uncertainty of the reference: {}\na step takes {ns:.0} ns here; {} algorithms were tried\n",
        given.origin,
        given.title,
        answer.rung.subsamples,
        answer.rung.updates_per_sample,
        time_text(answer.duration_s),
        leaves(&answer.predicted),
        leaves(&answer.uncertainty),
        answer.tried,
    )
}
