//! Runs that are flown one by one, each by its own simulator and unit: ensembles of scenes with a unit, which the runs side by side cannot
//! fly, and a single run of any scene.

use sins::errors::NavigationErrors;
use sins::scene::Play;
use sins::unit::Validity;
use sins::{Error, ErrorKind, ErrorSource};

use super::flight::{BeyondRange, CHUNK, Work, interrupted, state_of, track};
use super::plan::{Data, Piece, Plan};
use super::results::Part;
use crate::failure::Failure;
use crate::parallel::on_threads;

/// Whether the runs of a piece of work are flown one by one.
pub fn is_single(plan: &Plan, runs: u64) -> bool {
    plan.sources.contains(&Data::Shown) || runs == 1
}

impl Work<'_> {
    /// Flies the runs of a piece one by one on `threads` threads. The results are the same with any number of threads.
    pub fn fly_singly(&self, piece: &Piece, threads: usize) -> Result<Part, Failure> {
        let (first_run, runs) = self.plan.runs_of(piece);
        let each = runs.div_ceil(threads as u64);
        let shares: Vec<(u64, u64)> = (0..runs)
            .step_by(each as usize)
            .map(|before| (first_run + before, each.min(runs - before)))
            .collect();
        let parts = on_threads(threads, &shares, |&(first_run, runs)| self.share(piece, first_run, runs));
        let mut whole: Option<Part> = None;
        for part in parts {
            let part = part?;
            match &mut whole {
                None => whole = Some(part),
                Some(whole) => whole.append(part)?,
            }
        }
        whole.ok_or_else(interrupted)
    }

    fn share(&self, piece: &Piece, first_run: u64, runs: u64) -> Result<Part, Failure> {
        let drawn_from = self.plan.runs_of(piece).0;
        let mut part = Part::new(self.plan, piece);
        part.statistics.resize(self.plan.count(), Default::default());
        part.tracks.resize(self.plan.instants.len(), 0.0);
        for run in (first_run..=u64::MAX).take(runs as usize) {
            self.single(run, (run - drawn_from) as usize, &mut part)?;
        }
        Ok(part)
    }

    /// Flies a run; `drawn` is its place among those that are drawn.
    fn single(&self, run: u64, drawn: usize, part: &mut Part) -> Result<(), Failure> {
        let Self { given, plan, .. } = self;
        if self.must_stop() {
            return Err(interrupted());
        }
        let mut play = given.play_of_run(run)?;
        let (mut has_diverged, mut beyond) = (false, BeyondRange::of(&given.scene, 1));
        let mut instants = plan.instants.iter().enumerate().peekable();
        for index in 0..given.count {
            if !has_diverged && let Err(stopped) = play.fly_next() {
                match is_of_run(&stopped.error) {
                    true => has_diverged = true,
                    false => return Err(given.stopped_at(index, &stopped.error).with(&format!("run {run}"))),
                }
            }
            if !has_diverged {
                beyond.take(play.simulator().imu().map(|imu| imu.flags));
            }
            if let Some((row, _)) = instants.next_if(|(_, instant)| **instant == index) {
                let read = self.read_single(&play, has_diverged, (row, drawn), part);
                read.map_err(|error| given.stopped_at(index, &error))?;
            }
            if index % CHUNK == 0 && index > 0 {
                self.progress.fly(CHUNK, given.period_s);
                if self.must_stop() {
                    return Err(interrupted());
                }
            }
        }
        self.progress.fly((given.count - 1) % CHUNK, given.period_s);
        let end = errors(&play, has_diverged, ErrorSource::Navigation)?;
        part.ends.push(end.as_ref().map(state_of));
        part.diverged.extend(has_diverged.then_some(run));
        for (sum, more) in part.beyond_range.iter_mut().zip(beyond.runs()) {
            *sum += more;
        }
        Ok(())
    }

    /// Adds a run to the row `row`.
    fn read_single(
        &self,
        play: &Play,
        has_diverged: bool,
        (row, drawn): (usize, usize),
        part: &mut Part,
    ) -> Result<(), Error> {
        let solution = errors(play, has_diverged, ErrorSource::Navigation)?;
        let is_shown = play.unit().is_none_or(|unit| is_valid(unit.status().validity));
        for (place, source) in self.plan.sources.iter().enumerate() {
            let found = match source {
                Data::Navigation => solution,
                Data::Shown if !is_shown && solution.is_some() => continue,
                Data::Shown => solution,
                Data::Model => errors(play, has_diverged, ErrorSource::Model)?,
            };
            let statistics = &mut part.statistics[row * self.plan.sources.len() + place];
            match &found {
                Some(errors) => statistics.add(errors)?,
                None => statistics.add_diverged()?,
            }
        }
        if let Some(path) = part.drawn.get_mut(drawn) {
            path.extend(solution.as_ref().map(state_of));
        }
        if !has_diverged && let Some(truth) = play.simulator().truth()? {
            part.tracks[row] = track(&truth.navigation);
        }
        for (inside, due) in part.inside.iter_mut().zip(&self.plan.requirements) {
            if due.index == self.plan.instants[row] {
                let state = solution.as_ref().filter(|_| is_shown).map(state_of);
                let error = state.map(|state| due.requirement.measure.of(&state, part.tracks[row]));
                *inside += u64::from(error.is_some_and(|error| error <= due.limit));
            }
        }
        Ok(())
    }
}

/// Whether an error is one of this run alone, which diverges; the truth of the others goes on.
fn is_of_run(error: &Error) -> bool {
    matches!(error.kind, ErrorKind::Diverged | ErrorKind::Singular)
        && error.field != "cosine of sample.latitude_rad"
}

/// Errors of the solution; `None`: the run has diverged.
fn errors(play: &Play, has_diverged: bool, source: ErrorSource) -> Result<Option<NavigationErrors>, Error> {
    if has_diverged {
        return Ok(None);
    }
    match play.simulator().errors(source) {
        Ok(errors) => Ok(errors.map(|(_, errors)| errors)),
        Err(error) if is_of_run(&error) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether all of the navigation is valid.
fn is_valid(validity: Validity) -> bool {
    validity.position && validity.velocity && validity.attitude && validity.heading
}
