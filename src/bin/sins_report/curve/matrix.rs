//! The errors of the matrix: every configuration at every rate.

use std::sync::atomic::{AtomicUsize, Ordering};

use sins::recommend::{Refusal, fly};

use super::configuration::Configuration;
use super::reference::Judgement;
use super::scene::{Rate, Scene};

/// What became of a flight: its errors, or why it was refused.
pub type Outcome = Result<Judgement, Refusal>;

/// The outcome of each of `configurations` at each rate of `scene`, rate by rate.
pub fn outcomes(scene: &Scene, configurations: &[Configuration]) -> Vec<(Rate, Configuration, Outcome)> {
    let mut outcomes = Vec::new();
    for rate in &scene.rates {
        let (samples, instants) = (scene.samples_at(rate), scene.instants_at(rate));
        let flown = in_parallel(configurations, |configuration| {
            let options = rate.applied_to(&configuration.options());
            fly(&options, &samples, &instants).map(|track| scene.judge.judge(&track))
        });
        outcomes.extend(configurations.iter().zip(flown).map(|(which, outcome)| (*rate, *which, outcome)));
    }
    outcomes
}

/// `work` done with each of `items` on all cores, in their order.
pub fn in_parallel<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { return done };
            done.push((index, work(item)));
        }
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut done = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
        let join = |worker: std::thread::ScopedJoinHandle<'_, Vec<(usize, R)>>| match worker.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        };
        workers.into_iter().flat_map(join).collect::<Vec<_>>()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::embedded;
    use sins::ErrorKind;

    #[test]
    fn results_keep_the_order_of_the_items() {
        let items: Vec<u32> = (0..1000).collect();
        assert_eq!(
            in_parallel(&items, |item| item * 2),
            items.iter().map(|item| item * 2).collect::<Vec<_>>()
        );
    }

    #[test]
    fn geographic_axes_are_singular_at_the_pole() {
        let mut scene = embedded::ALL[4].scene(120.0).unwrap();
        scene.rates.retain(|rate| rate.hz == 10.0);
        let all = [Configuration::of(&Default::default()), Configuration::PAPER];
        let outcomes = outcomes(&scene, &all);
        assert!(outcomes[0].2.is_ok());
        assert_eq!(outcomes[1].2.as_ref().unwrap_err().error.kind, ErrorKind::Singular);
    }
}
