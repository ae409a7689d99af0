//! The flights: threads fly pieces of work. The results of a piece are added as a whole or not at all.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use nalgebra::Vector3;
use sins::earth::state::Navigation;
use sins::ensemble::Ensemble;
use sins::errors::NavigationErrors;
use sins::scene::Scene;
use sins::{Error, ErrorKind, ErrorSource, ImuFlags};

use super::checkpoint::Checkpoint;
use super::plan::{Data, Piece, Plan};
use super::results::{Part, Results, State};
use super::single::is_single;
use crate::failure::{Failure, Kind};
use crate::given::Given;
use crate::interrupt;
use crate::parallel::on_threads;
use crate::progress::Progress;

/// Number of intervals between two checks of the signals and of the state of other threads.
pub const CHUNK: usize = 64;

/// Steps and time of this execution of the program, for the speed.
pub struct FlyingTime {
    /// Steps of single runs.
    pub steps: u64,
    pub seconds: f64,
}

/// Data that all threads share.
pub struct Work<'a> {
    pub given: &'a Given,
    pub plan: &'a Plan,
    pub progress: Progress,
    /// Threads for each piece of work.
    threads: usize,
    results: Mutex<(&'a mut Results, &'a mut Checkpoint)>,
    /// A thread has failed, or the user has asked for the end.
    is_over: AtomicBool,
}

/// Flies the blocks that `results` lacks on `threads` threads. After an interruption, or if a piece fails, the checkpoint has the
/// blocks that are done.
pub fn fly(
    given: &Given,
    plan: &Plan,
    threads: usize,
    results: &mut Results,
    checkpoint: &mut Checkpoint,
    quiet: bool,
) -> Result<FlyingTime, Failure> {
    let pieces = Plan::pieces(&results.missing(), threads);
    let runs: u64 = pieces.iter().map(|piece| plan.runs_of(piece).1).sum();
    let steps = runs * (given.count as u64 - 1);
    let progress = Progress::flying(format!("flying {runs} runs"), steps as usize, quiet);
    let results = Mutex::new((results, checkpoint));
    let of_piece = (threads / pieces.len().max(1)).max(1);
    let work = Work { given, plan, progress, threads: of_piece, results, is_over: AtomicBool::new(false) };
    let began = Instant::now();
    let ended = on_threads(threads, &pieces, |piece| work.piece(piece));
    let seconds = began.elapsed().as_secs_f64();
    // A thread that failed has stopped the others, which report that they were interrupted.
    let (interrupted, failed): (Vec<Failure>, Vec<Failure>) =
        ended.into_iter().filter_map(Result::err).partition(|failure| failure.kind() == Kind::Interrupted);
    match failed.into_iter().chain(interrupted).next() {
        None => Ok(FlyingTime { steps, seconds }),
        Some(failure) => {
            let (results, checkpoint) = &mut *work.results();
            if results.done.contains(&true) {
                checkpoint.write(plan, results)?;
            }
            Err(failure)
        }
    }
}

impl<'a> Work<'a> {
    fn results(&self) -> MutexGuard<'_, (&'a mut Results, &'a mut Checkpoint)> {
        self.results.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn piece(&self, piece: &Piece) -> Result<(), Failure> {
        let done = self.fly(piece).and_then(|part| {
            let (results, checkpoint) = &mut *self.results();
            results.add(piece, part)?;
            checkpoint.write_in_time(self.plan, results);
            Ok(())
        });
        if done.is_err() {
            self.is_over.store(true, Ordering::Relaxed);
        }
        done
    }

    fn fly(&self, piece: &Piece) -> Result<Part, Failure> {
        let Self { given, plan, .. } = self;
        let (first_run, runs) = plan.runs_of(piece);
        if self.must_stop() {
            return Err(interrupted());
        }
        if is_single(plan, runs) {
            return self.fly_singly(piece, self.threads);
        }
        let mut ensemble = Ensemble::new(&given.scene.simulator()?[0], first_run, runs as usize)?;
        let mut part = Part::new(plan, piece);
        let mut itinerary = given.itinerary()?;
        let mut instants = plan.instants.iter().copied().peekable();
        let mut beyond = BeyondRange::of(&given.scene, runs);
        for index in 0..given.count {
            let taken = itinerary.take(&mut ensemble, &given.sample(index)?);
            taken.map_err(|error| given.stopped_at(index, &error))?;
            if index > 0 {
                ensemble.step().map_err(|error| given.stopped_at(index, &error))?;
                beyond.take(ensemble.imu_flags());
            }
            if instants.next_if_eq(&index).is_some() {
                self.read(&ensemble, index, &mut part).map_err(|error| given.stopped_at(index, &error))?;
            }
            if index % CHUNK == 0 && index > 0 {
                self.progress.fly(CHUNK * runs as usize, given.period_s);
                if self.must_stop() {
                    return Err(interrupted());
                }
            }
        }
        self.progress.fly((given.count - 1) % CHUNK * runs as usize, given.period_s);
        for run in first_run..=first_run + (runs - 1) {
            part.ends.push(state(&ensemble, run)?);
        }
        part.diverged = ensemble.diverged().collect();
        part.beyond_range = beyond.runs();
        Ok(part)
    }

    /// Takes the statistics of this instant, the errors of the runs that are drawn, and counts the runs within the limits that are
    /// due.
    fn read(&self, ensemble: &Ensemble, index: usize, part: &mut Part) -> Result<(), Error> {
        for source in &self.plan.sources {
            let source = match source {
                Data::Model => ErrorSource::Model,
                Data::Navigation | Data::Shown => ErrorSource::Navigation,
            };
            part.statistics.push(ensemble.statistics(source)?);
        }
        for (path, run) in part.drawn.iter_mut().zip(ensemble.first_run()..=u64::MAX) {
            path.extend(state(ensemble, run)?);
        }
        let track_rad = ensemble.truth().map_or(0.0, |truth| track(&truth.navigation));
        part.tracks.push(track_rad);
        for (inside, due) in part.inside.iter_mut().zip(&self.plan.requirements) {
            if due.index != index {
                continue;
            }
            for run in (ensemble.first_run()..=u64::MAX).take(ensemble.runs()) {
                let error = state(ensemble, run)?.map(|state| due.requirement.measure.of(&state, track_rad));
                *inside += u64::from(error.is_some_and(|error| error <= due.limit));
            }
        }
        Ok(())
    }

    pub fn must_stop(&self) -> bool {
        self.is_over.load(Ordering::Relaxed) || interrupt::is_asked()
    }
}

/// Whether gyros and accelerometers were ever beyond their range, of each run; of no run, if the scene has no ranges.
pub struct BeyondRange(Vec<[bool; 2]>);

impl BeyondRange {
    pub fn of(scene: &Scene, runs: u64) -> Self {
        let has_range =
            [&scene.errors.gyro, &scene.errors.accel].iter().any(|triad| triad.range != Vector3::zeros());
        Self(vec![[false; 2]; if has_range { runs as usize } else { 0 }])
    }

    /// Takes the flags of an interval of each run.
    pub fn take(&mut self, flags: impl IntoIterator<Item = ImuFlags>) {
        for ([gyro, accel], flags) in self.0.iter_mut().zip(flags) {
            *gyro |= flags.gyro_saturated;
            *accel |= flags.accel_saturated;
        }
    }

    /// Number of runs for gyros, and for accelerometers.
    pub fn runs(&self) -> [u64; 2] {
        [0, 1].map(|sensor| self.0.iter().filter(|run| run[sensor]).count() as u64)
    }
}

/// Least horizontal speed of a track [m/s].
pub const LEAST_SPEED: f64 = 1.0;

/// Direction of the track from north to east [rad]: that of the horizontal velocity, or the heading below [`LEAST_SPEED`].
pub fn track(truth: &Navigation) -> f64 {
    let (east, north) = (truth.v_n.x, truth.v_n.y);
    if east.hypot(north) < LEAST_SPEED { truth.euler.heading } else { east.atan2(north) }
}

/// Current errors of a run; `None` if the statistics count the run as diverged.
fn state(ensemble: &Ensemble, run: u64) -> Result<Option<State>, Error> {
    match ensemble.errors(run, ErrorSource::Navigation) {
        Ok(errors) => Ok(errors.map(|(_, errors)| state_of(&errors))),
        Err(error) if matches!(error.kind, ErrorKind::Diverged | ErrorKind::Singular) => Ok(None),
        Err(error) => Err(error),
    }
}

/// The numbers of errors.
pub fn state_of(errors: &NavigationErrors) -> State {
    let parts = [errors.position_n, errors.velocity_n, errors.misalignment_n];
    std::array::from_fn(|k| parts[k / 3][k % 3])
}

/// Failure of a thread that was stopped. The flag stops the other threads; the user reads only the first of all failures.
pub fn interrupted() -> Failure {
    Failure::of_kind(Kind::Interrupted, "")
}
