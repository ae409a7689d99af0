//! Flies every effect alone, all effects together, and all without those that can be left out.

use core::cmp::Ordering;

use super::contribution::Contribution;
use super::flight::{Deviation, Look, Track, difference, fly};
use super::selection::mark;
use super::{BudgetEffect, BudgetRequest, ComputedSamples, SigmaInterval};
use crate::analysis::recommend::{Refusal, SolutionError};
use crate::base::error::Error;
use crate::base::memory::room;
use crate::simulator::{ErrorParameters, Options};

/// The contribution of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BudgetRow {
    /// Which.
    pub effect: &'static BudgetEffect,
    /// Its largest contribution over the scene; of a random one 1σ, exact to first order.
    pub worst: SolutionError,
    /// At the end of the scene.
    pub end: SolutionError,
    /// The largest ratio of `worst` to a limit; 0 without limits.
    pub share: f64,
    /// Whether it is one of those that can be left out together.
    pub can_be_left_out: bool,
}

/// The budget of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Budget {
    /// Time over which errors were read, from the end of the first interval to the end of the last [s].
    pub span_s: f64,
    /// Error of the mechanization and of the samples, with no effect set: the largest of the scene, and at its end.
    pub own: (SolutionError, SolutionError),
    /// The effects that are set, the largest share of a limit first; without limits the largest position, then velocity,
    /// then attitude.
    pub rows: Vec<BudgetRow>,
    /// Error with all effects, navigation minus truth, root mean square over the runs: the largest of the scene.
    pub total: SolutionError,
    /// That error less the mechanization's own error and less the sum of all contributions, run by run: the nonlinear part.
    pub remainder: SolutionError,
    /// Change of the error with all effects if the marked rows are left out, from flights: the largest of the scene.
    pub left_out: SolutionError,
    /// Number of runs with all effects together; 1 if nothing is random.
    pub runs: u64,
    /// The 95 % interval of the root mean square of the random part of the error with all effects; 1 and 1 if nothing is random.
    pub interval: SigmaInterval,
    /// Number of flights that the call made.
    pub flights: u64,
}

/// The flights, and their number.
struct Flights<'a> {
    options: &'a Options,
    scene: &'a ComputedSamples<'a>,
    flown: u64,
}

impl Flights<'_> {
    fn fly(&mut self, parameters: &ErrorParameters, run: u64) -> Result<Vec<Deviation>, Refusal> {
        self.track(parameters, run, Look::Navigation).map(|track| track.errors)
    }

    fn track(&mut self, parameters: &ErrorParameters, run: u64, look: Look) -> Result<Track, Refusal> {
        self.flown += 1;
        fly(self.options, self.scene, parameters, run, look)
    }
}

/// The error budget of `scene`, flown with `options`, of all that `parameters` set.
///
/// Flights: 1, one for each effect, N for all together and, if anything is random, N for the random effects; with limits N
/// more, and N for each effect that did not add up. A flight takes 0.6 to 1.5 µs a sample (2.8 GHz Xeon), and memory 72 kB
/// for each run. The answer is the same on every machine.
pub fn error_budget(
    options: &Options,
    scene: &ComputedSamples<'_>,
    parameters: &ErrorParameters,
    request: &BudgetRequest,
) -> Result<Budget, Refusal> {
    options.validate()?;
    request.validate()?;
    parameters.validate()?;
    scene.validate()?;
    let instants = scene.instants();
    let mut flights = Flights { options, scene, flown: 0 };
    let Track { span_s, errors: own } = flights.track(&parameters.ideal(), 0, Look::Navigation)?;
    let is_random = BudgetEffect::set_in(parameters).any(|effect| effect.is_random);
    let runs = if is_random { request.runs } else { 1 };
    let interval = if is_random { SigmaInterval::of(runs) } else { SigmaInterval { low: 1.0, high: 1.0 } };

    // The contribution of each effect.
    let mut contributions = contributions_of(parameters, instants)?;
    let mut steady = copy(&own)?;
    for (effect, contribution) in contributions.iter_mut().filter(|(effect, _)| !effect.is_random) {
        let alone = flights.fly(&effect.alone(parameters), 0)?;
        contribution.add(differences(&alone, &own));
        add(&mut steady, differences(&alone, &own));
    }
    for (effect, contribution) in contributions.iter_mut().filter(|(effect, _)| effect.is_random) {
        contribution.add(flights.track(&effect.alone(parameters), 0, Look::Sigma)?.errors.into_iter());
    }
    // All effects together, and the remainder: the sum of the random contributions of a run is linear in its draws.
    let random = BudgetEffect::random_of(parameters);
    let (mut total, mut remainder) = (Contribution::new(instants)?, Contribution::new(instants)?);
    let mut all = room(runs as usize)?;
    for run in 0..runs {
        let mut sum = copy(&steady)?;
        if is_random {
            let drawn = flights.track(&random, run, Look::Model)?.errors;
            add(&mut sum, drawn.into_iter());
        }
        let errors = flights.fly(parameters, run)?;
        total.add(errors.iter().copied());
        remainder.add(differences(&errors, &sum));
        if request.has_limits() {
            all.push(errors);
        }
    }

    let mut rows = rows(&contributions, request)?;
    mark(&mut rows, request);
    let left_out = verify(&mut flights, parameters, request, &all, &mut rows)?;
    let mut alone = Contribution::new(instants)?;
    alone.add(own.iter().copied());
    Ok(Budget {
        span_s,
        own: (alone.worst(), alone.end()),
        rows,
        total: total.worst(),
        remainder: remainder.worst(),
        left_out,
        runs,
        interval,
        flights: flights.flown,
    })
}

type Contributions = Vec<(&'static BudgetEffect, Contribution)>;

fn contributions_of(parameters: &ErrorParameters, instants: usize) -> Result<Contributions, Error> {
    let mut contributions = room(BudgetEffect::set_in(parameters).count())?;
    for effect in BudgetEffect::set_in(parameters) {
        contributions.push((effect, Contribution::new(instants)?));
    }
    Ok(contributions)
}

fn differences(errors: &[Deviation], from: &[Deviation]) -> impl Iterator<Item = Deviation> {
    errors.iter().zip(from).map(|(errors, from)| difference(errors, from))
}

fn add(sum: &mut [Deviation], more: impl Iterator<Item = Deviation>) {
    sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
}

fn copy(deviations: &[Deviation]) -> Result<Vec<Deviation>, Error> {
    let mut copy = room(deviations.len())?;
    copy.extend_from_slice(deviations);
    Ok(copy)
}

/// The rows, sorted, none marked.
fn rows(contributions: &Contributions, request: &BudgetRequest) -> Result<Vec<BudgetRow>, Error> {
    let mut rows = room(contributions.len())?;
    rows.extend(contributions.iter().map(|(effect, contribution)| {
        let worst = contribution.worst();
        let share = request.share(&worst);
        BudgetRow { effect, worst, end: contribution.end(), share, can_be_left_out: false }
    }));
    let size =
        |row: &BudgetRow| [row.share, row.worst.position_m, row.worst.velocity_m_s, row.worst.attitude_rad];
    rows.sort_unstable_by(|a: &BudgetRow, b| {
        let orders = size(b).into_iter().zip(size(a)).map(|(b, a)| b.total_cmp(&a));
        let by_size = orders.fold(Ordering::Equal, Ordering::then);
        by_size.then(a.effect.field.cmp(b.effect.field))
    });
    Ok(rows)
}

/// Flies without the marked rows, and removes the mark of the largest until the change of `all` is within the limits.
fn verify(
    flights: &mut Flights<'_>,
    parameters: &ErrorParameters,
    request: &BudgetRequest,
    all: &[Vec<Deviation>],
    rows: &mut [BudgetRow],
) -> Result<SolutionError, Refusal> {
    while rows.iter().any(|row| row.can_be_left_out) {
        let mut kept = *parameters;
        rows.iter().filter(|row| row.can_be_left_out).for_each(|row| row.effect.leave_out(&mut kept));
        let mut change = Contribution::new(flights.scene.instants())?;
        for (run, all) in all.iter().enumerate() {
            change.add(differences(all, &flights.fly(&kept, run as u64)?));
        }
        if request.share(&change.worst()) <= 1.0 {
            return Ok(change.worst());
        }
        if let Some(largest) = rows.iter_mut().find(|row| row.can_be_left_out) {
            largest.can_be_left_out = false;
        }
    }
    Ok(SolutionError::default())
}
