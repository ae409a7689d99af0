//! The budgets of the scenes.

use sins::analysis::budget::{Budget, BudgetEffect, BudgetRequest, Costs, error_budget, step_costs_ns};
use sins::analysis::recommend::{Refusal, SolutionError};

use super::scene::BudgetScene;
use crate::failure::Failure;
use crate::given::of_sample;
use crate::parallel::in_parallel;
use crate::progress::Progress;
use crate::terminal::say;

/// Number of steps between two updates of the progress.
const PROGRESS_STEPS: usize = 1024;

/// Number of flights of a budget, except for the flights that find effects which do not add up ([`error_budget`]).
fn flights(scene: &BudgetScene, request: &BudgetRequest) -> usize {
    let count = |is_random| {
        BudgetEffect::set_in(&scene.parameters).filter(|effect| effect.is_random == is_random).count()
    };
    let (steady, random) = (count(false), count(true));
    let runs = if random == 0 { 1 } else { request.runs as usize };
    1 + steady + random + runs * (1 + usize::from(random > 0) + usize::from(request.has_limits()))
}

/// A scene's budget.
pub struct Survey {
    pub name: String,
    pub title: String,
    pub request: BudgetRequest,
    pub budget: Budget,
    /// Times of a step, if they are wanted.
    pub costs: Option<Costs>,
    /// What is doubtful in the flight data, and what is not flown, in sentences.
    pub warnings: Vec<String>,
}

/// Kind of a line of chart and table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Deterministic,
    Random,
    /// Error of the mechanization.
    Own,
    /// Error of all effects together, or the part of it that the sum of the effects does not explain.
    Together,
}

/// A line of chart and table.
#[derive(Debug, Clone, PartialEq)]
pub struct BudgetLine {
    pub name: &'static str,
    /// Key of a scene that sets the effect; empty for other lines.
    pub key: String,
    pub kind: Kind,
    pub worst: SolutionError,
    /// Error at the end of the scene, if it is known.
    pub end: Option<SolutionError>,
    pub can_be_left_out: bool,
    /// Time that a step saves without the effect; for other lines, time of a step with no effect or with all effects [ns], if they were
    /// timed.
    pub cost_ns: Option<f64>,
}

impl Survey {
    /// Computes the budgets of all scenes on all cores, then, if wanted, measures the times of their steps, one scene after the other.
    pub fn of_all(
        scenes: &[BudgetScene],
        request: &BudgetRequest,
        time_steps: bool,
    ) -> Result<Vec<Self>, Failure> {
        scenes.iter().for_each(|scene| say(&format!("{}: {}", scene.name, scene.title)));
        let steps = scenes.iter().map(|scene| flights(scene, request) * scene.count).sum();
        let progress = Progress::flying("flying each effect alone", steps, false);
        let budgets = in_parallel(scenes, |scene| {
            let sample = |index: usize| {
                if index.is_multiple_of(PROGRESS_STEPS) {
                    progress.fly(PROGRESS_STEPS.min(scene.count - index), scene.period_s);
                }
                scene.sample(index)
            };
            let flown = sins::analysis::budget::ComputedSamples { count: scene.count, sample: &sample };
            error_budget(&scene.options, &flown, &scene.parameters, request)
        });
        drop(progress);
        let surveyed = scenes.iter().zip(budgets).map(|(scene, budget)| {
            let refused = |refusal: Refusal| {
                Failure::new(format!("{}: {}", scene.place(refusal.sample), of_sample(&refusal.error)))
            };
            let budget = budget.map_err(refused)?;
            let costs = if time_steps { Some(costs(scene, &budget)?) } else { None };
            let (name, title) = (scene.name.clone(), scene.title.clone());
            let warnings = scene.warnings();
            Ok(Self { name, title, request: *request, budget, costs, warnings })
        });
        surveyed.collect()
    }

    /// Root sum of squares of the contributions of all effects: at least the largest of them, while all effects together may be less in
    /// the runs that are flown.
    pub fn root_sum_of_squares(&self) -> SolutionError {
        let of = |part: fn(&SolutionError) -> f64| {
            self.budget.rows.iter().map(|row| part(&row.worst).powi(2)).sum::<f64>().sqrt()
        };
        SolutionError {
            position_m: of(|error| error.position_m),
            velocity_m_s: of(|error| error.velocity_m_s),
            attitude_rad: of(|error| error.attitude_rad),
        }
    }

    /// Lines of the effects (the largest first), of the mechanization, of the unexplained remainder, of the root sum
    /// of squares, and of all effects together.
    pub fn lines(&self) -> Vec<BudgetLine> {
        let Budget { own, rows, total, remainder, .. } = &self.budget;
        let costs = self.costs.as_ref();
        let effects = rows.iter().enumerate().map(|(place, row)| BudgetLine {
            name: row.effect.name,
            key: sins::scene::key_of_field(row.effect.field).unwrap_or_default(),
            kind: if row.effect.is_random { Kind::Random } else { Kind::Deterministic },
            worst: row.worst,
            end: Some(row.end),
            can_be_left_out: row.can_be_left_out,
            cost_ns: costs.map(|costs| costs.saved_ns[place]),
        });
        let other = |name, kind, worst, end, cost_ns| BudgetLine {
            name,
            key: String::new(),
            kind,
            worst,
            end,
            can_be_left_out: false,
            cost_ns,
        };
        let mut lines: Vec<BudgetLine> = effects.collect();
        lines.push(other("mechanization", Kind::Own, own.0, Some(own.1), costs.map(|costs| costs.own_ns)));
        lines.push(other("not their sum", Kind::Together, *remainder, None, None));
        let sum = self.root_sum_of_squares();
        lines.push(other("root sum of squares", Kind::Together, sum, None, None));
        lines.push(other("all together", Kind::Together, *total, None, costs.map(|costs| costs.total_ns)));
        lines
    }
}

/// Times of a step of `scene` with and without the effects of its budget.
fn costs(scene: &BudgetScene, budget: &Budget) -> Result<Costs, Failure> {
    let sample = |index| scene.sample(index);
    let flown = sins::analysis::budget::ComputedSamples { count: scene.count, sample: &sample };
    let _timing = Progress::working(format!("timing a step of {}", scene.name));
    let effects = budget.rows.iter().map(|row| row.effect);
    Ok(step_costs_ns(&scene.options, &flown, &scene.parameters, effects)?)
}

#[cfg(test)]
pub mod tests {
    use sins::analysis::budget::{BudgetRow, EFFECTS, SigmaInterval};

    use super::*;

    fn error(position_m: f64) -> SolutionError {
        SolutionError { position_m, velocity_m_s: 1e-3 * position_m, attitude_rad: 0.0 }
    }

    /// A budget of two effects: a bias of more than a kilometre, and a random one of half a metre.
    pub fn made() -> Survey {
        let row = |field: &str, position_m: f64, can_be_left_out| BudgetRow {
            effect: EFFECTS.iter().find(|effect| effect.field == field).unwrap(),
            worst: error(position_m),
            end: error(position_m),
            share: position_m,
            can_be_left_out,
        };
        Survey {
            name: "a<b".into(),
            title: "made & flown".into(),
            request: BudgetRequest { limits: error(1.0), ..Default::default() },
            budget: Budget {
                span_s: 600.0,
                own: (error(1e-7), error(1e-8)),
                rows: vec![row("gyro.bias_rad_s", 1234.0, false), row("gyro.bias_sigma_rad_s", 0.5, true)],
                total: error(1234.1),
                remainder: error(0.0),
                left_out: error(0.5),
                runs: 16,
                interval: SigmaInterval::of(16),
                flights: 51,
            },
            costs: Some(Costs { own_ns: 600.0, total_ns: 640.0, saved_ns: vec![30.0, 10.4] }),
            warnings: Vec::new(),
        }
    }
}
