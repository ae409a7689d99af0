//! A batch of runs over an interval.

use super::batch::{Batch, Report, State};
use super::shared::Shared;
use super::workspace::Workspace;
use crate::base::instruction_set::{InstructionSet, Work};
use crate::errors::SensorErrors;
use crate::mechanization::{AidOfEach, VerticalAid, check_state};
use crate::sensors::FailingTriad;
use crate::signal::mounting::Block;
use crate::signal::{Increment, RUNS, increment_of, put_increment};
use crate::simulator::ImuFlags;
use crate::simulator::aid::aid_vertical;

impl Batch {
    /// Flies an interval.
    pub fn fly(&mut self, set: InstructionSet, shared: &Shared<'_>, workspace: &mut Workspace) {
        // The state before the interval goes into the workspace. A run that diverges is set back to it.
        let (state, before) = (&mut self.state, &mut workspace.before);
        core::mem::swap(&mut state.navigators, &mut before.navigators);
        core::mem::swap(&mut state.models, &mut before.models);
        (before.measured, before.reports) = (state.measured, state.reports);
        workspace.is_unaided = [shared.aid == VerticalAid::None; RUNS];
        if let VerticalAid::Barometer { height_m } = shared.aid {
            workspace.heights_m = [height_m; RUNS];
        }
        if self.disturbed.is_empty() {
            self.begin_failures(shared, workspace);
            self.sense_heights(shared, workspace);
            set.run(Sensing { batch: self, shared, workspace });
            if !self.compensated.is_empty() {
                self.compensate(shared, workspace);
            }
        } else {
            self.sense_disturbed(shared, workspace);
        }
        set.run(Navigating { batch: self, shared, workspace });
        for lane in 0..self.count {
            let is_good = shared.is_good && workspace.is_good[lane] != 0;
            if self.diverged[lane].is_some() || !is_good {
                self.look_closely(lane, shared, workspace);
            }
        }
    }

    /// Compensates the measured increments of each run.
    #[cold]
    #[inline(never)]
    fn compensate(&mut self, shared: &Shared<'_>, workspace: &mut Workspace) {
        let rows = &mut workspace.measured[..shared.ideal.len()];
        let increments = &mut workspace.compensated[..shared.ideal.len()];
        for (lane, of_run) in self.compensated.iter_mut().enumerate() {
            for (increment, rows) in increments.iter_mut().zip(&*rows) {
                *increment = increment_of(rows, lane);
            }
            if let Some(compensation) = &of_run.compensation {
                compensation.apply(increments, shared.dt);
                for (rows, increment) in rows.iter_mut().zip(&*increments) {
                    put_increment(rows, lane, increment);
                }
            }
            of_run.sum_before = core::mem::replace(&mut of_run.sum, Increment::sum(increments));
        }
    }

    /// Begins the interval for the failures, if there are any.
    #[inline]
    fn begin_failures(&mut self, shared: &Shared<'_>, workspace: &mut Workspace) {
        let failures = self.state.failures.iter_mut().zip(&mut workspace.before.failures);
        for ((failures, before), _) in
            failures.zip(shared.have_failed()).filter(|(_, has_failed)| *has_failed)
        {
            before[..self.count].clone_from_slice(failures);
            failures.iter_mut().for_each(|failures| failures.begin_interval(shared.t));
        }
    }

    /// Reads the altimeters, if each run has its own.
    #[inline]
    fn sense_heights(&mut self, shared: &Shared<'_>, workspace: &mut Workspace) {
        if let (VerticalAid::Barometer { height_m }, true) = (shared.aid, shared.has_altimeters) {
            for lane in (0..self.count).filter(|lane| self.diverged[*lane].is_none()) {
                let indicated_m = self.altimeters[lane].sense(height_m, shared.t);
                workspace.put_height(lane, height_m, indicated_m);
            }
        }
    }

    /// Reads the sensors and the altimeter of each run, if gravity is not normal.
    #[cold]
    #[inline(never)]
    fn sense_disturbed(&mut self, shared: &Shared<'_>, workspace: &mut Workspace) {
        for lane in 0..self.count {
            if self.diverged[lane].is_some() {
                continue;
            }
            let compensation = self.compensation(lane);
            let (sum, navigated, flags, indicated_m) =
                self.disturbed[lane].sense(shared, &mut workspace.disturbed, lane, compensation.as_ref());
            put_increment(&mut self.state.measured, lane, &sum);
            if let Some(of_run) = self.compensated.get_mut(lane) {
                of_run.sum_before = core::mem::replace(&mut of_run.sum, Increment::sum(navigated));
            }
            for (rows, increment) in workspace.measured.iter_mut().zip(navigated) {
                put_increment(rows, lane, increment);
            }
            if let VerticalAid::Barometer { height_m } = shared.aid {
                workspace.put_height(lane, height_m, indicated_m);
            }
            self.state.reports[lane] = Report { flags, is_unaided: workspace.is_unaided[lane] };
        }
    }

    /// Checks the run at `lane`. If it is not good, it goes back to its last good solution and stays there.
    #[cold]
    #[inline(never)]
    fn look_closely(&mut self, lane: usize, shared: &Shared<'_>, workspace: &Workspace) {
        if self.diverged[lane].is_none() {
            if self.is_good(lane, shared) {
                return;
            }
            self.diverged[lane] = Some(shared.last_good);
            if let Some(disturbed) = self.disturbed.get_mut(lane) {
                disturbed.undo(shared);
            } else if shared.has_altimeters {
                self.altimeters[lane].undo();
            }
        }
        self.state.go_back(lane, &workspace.before);
        if let Some(of_run) = self.compensated.get_mut(lane) {
            of_run.sum = of_run.sum_before;
        }
        if self.disturbed.is_empty() {
            self.state.sensors_go_back(lane, &workspace.before, shared.have_failed());
        }
    }

    /// Whether all solutions of a run are within their limits.
    fn is_good(&self, lane: usize, shared: &Shared<'_>) -> bool {
        let navigator = self.navigator(lane, shared.earth, shared.options);
        let mounting = shared.mounting_of(&self.navigated(lane));
        let is_reference_point_good = |mounting: Block| {
            check_state(shared.earth, &mounting.belief().reference_point(&navigator.state())).is_ok()
        };
        shared.is_good && navigator.check().is_ok() && mounting.is_none_or(is_reference_point_good)
    }
}

/// The sensors of a batch in an interval.
struct Sensing<'a> {
    batch: &'a mut Batch,
    shared: &'a Shared<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Sensing<'_> {
    /// Normal numbers need table look-ups. With AVX-512 the compiler uses gather instructions, which take 4.7 ns for a number of a
    /// run; single loads take 2.8 ns (Cascade Lake).
    const IN_EIGHTS: bool = false;

    #[inline(always)]
    fn run(self) {
        let Self { batch, shared, workspace } = self;
        let State { gyro, accel, measured: sums, reports, failures, .. } = &mut batch.state;
        let [gyro_failures, accel_failures] = failures;
        let Workspace { before, measured, saturated: marks, is_unaided, .. } = workspace;
        let (gyro, accel) = ((gyro, &mut before.gyro), (accel, &mut before.accel));
        let &Shared { imperfections, inputs, dt, ideal, .. } = shared;
        let [gyro_failed, accel_failed] = shared.have_failed();
        let measured = &mut measured[..ideal.len()];

        *marks = [[0; RUNS]; 2];
        imperfections.gyro.sense_batch(&inputs[0], dt, gyro, gyro_failures, measured, &mut marks[0]);
        imperfections.accel.sense_batch(&inputs[1], dt, accel, accel_failures, measured, &mut marks[1]);
        for (lane, report) in reports.iter_mut().enumerate() {
            let is_silent =
                |failures: &[FailingTriad]| failures.get(lane).is_some_and(FailingTriad::are_silent);
            *report = Report {
                flags: ImuFlags {
                    gyro_saturated: marks[0][lane] != 0,
                    accel_saturated: marks[1][lane] != 0,
                    gyro_invalid: gyro_failed && is_silent(gyro_failures),
                    accel_invalid: accel_failed && is_silent(accel_failures),
                },
                is_unaided: is_unaided[lane],
            };
        }
        for i in 0..6 {
            let mut sum = [0.0; RUNS];
            for rows in measured.iter() {
                for lane in 0..RUNS {
                    sum[lane] += rows[i][lane];
                }
            }
            sums[i] = sum;
        }
    }
}

/// The navigators and error models of a batch in an interval.
struct Navigating<'a> {
    batch: &'a mut Batch,
    shared: &'a Shared<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Navigating<'_> {
    const IN_EIGHTS: bool = true;

    #[inline(always)]
    fn run(self) {
        let Self { batch, shared, workspace } = self;
        let Workspace { before, measured, scratch, heights_m, is_unaided, is_good, disturbed, .. } =
            workspace;
        let &Shared { earth, options, t, ideal, aid, .. } = shared;
        let State { navigators, models, measured: sums, .. } = &mut batch.state;
        let ([navigators], [navigators_before]) = (&mut **navigators, &*before.navigators) else { return };
        let (measured, sums, compensated) = (&measured[..ideal.len()], &*sums, &*batch.compensated);
        let aid = match aid {
            VerticalAid::None => AidOfEach::None,
            VerticalAid::Truth { height_m, velocity_up_m_s } => {
                AidOfEach::Truth { height_m, velocity_up_m_s }
            }
            _ if is_unaided.contains(&true) => AidOfEach::Some { heights_m, is_none: is_unaided },
            VerticalAid::Barometer { .. } => AidOfEach::Barometer { heights_m },
        };
        let kind = (earth, options.scheme);
        let mounting_of = |lane: usize| {
            let sum = compensated.get(lane).map_or_else(|| increment_of(sums, lane), |of_run| of_run.sum);
            shared.mounting_of(&sum)
        };
        navigators.navigate(
            (navigators_before, shared.shift_e.as_ref()),
            kind,
            options.subsamples,
            measured,
            t,
            scratch,
        );
        if shared.mounting.is_none() {
            navigators.aid_vertical(kind, &aid, t, is_good);
        } else {
            navigators.each(kind, |lane, navigator| {
                let belief = mounting_of(lane).map(|mounting| mounting.belief());
                aid_vertical(navigator, earth, &aid.at(lane), t, belief);
            });
            *is_good = [0; RUNS];
        }
        for ((models, before), interval) in models.iter_mut().zip(&before.models).zip(&shared.model) {
            if !batch.disturbed.is_empty() {
                let errors: &[SensorErrors; RUNS] = &disturbed.errors;
                models.advance_one_by_one(before, interval, &aid, |lane| (errors[lane], mounting_of(lane)));
            } else if shared.mounting.is_some() {
                models.advance_one_by_one(before, interval, &aid, |lane| {
                    (interval.errors(measured, lane), mounting_of(lane))
                });
            } else {
                models.advance(before, interval, measured, &aid);
            }
        }
    }
}
