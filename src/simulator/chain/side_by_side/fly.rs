//! A block of runs over an interval.

use super::block::{Block, Report};
use super::interval::Interval;
use super::workspace::Workspace;
use crate::errors::SensorErrors;
use crate::instruction_set::{InstructionSet, Work};
use crate::mechanization::{AidOfEach, VerticalAid, check_state};
use crate::mounting;
use crate::sensors::FailingTriad;
use crate::signal::{Increment, RUNS, increment_of, put_increment};
use crate::simulator::ImuFlags;
use crate::simulator::aid::aid_vertical;

impl Block {
    /// Flies an interval.
    pub fn fly(&mut self, set: InstructionSet, interval: &Interval<'_>, workspace: &mut Workspace) {
        // The state before the interval goes into the workspace. A run that diverges is set back to it.
        core::mem::swap(&mut self.navigators, &mut workspace.navigators);
        core::mem::swap(&mut self.models, &mut workspace.models);
        (workspace.sums, workspace.reports) = (self.measured, self.reports);
        workspace.is_unaided = [interval.aid == VerticalAid::None; RUNS];
        if let VerticalAid::Barometer { height_m } = interval.aid {
            workspace.heights_m = [height_m; RUNS];
        }
        if self.disturbed.is_empty() {
            self.begin_failures(interval, workspace);
            self.sense_heights(interval, workspace);
            set.run(Sensing { block: self, interval, workspace });
            if !self.compensated.is_empty() {
                self.compensate(interval, workspace);
            }
        } else {
            self.sense_disturbed(interval, workspace);
        }
        set.run(Navigating { block: self, interval, workspace });
        for lane in 0..self.count {
            let is_good = interval.is_shared_good && workspace.is_good[lane] != 0;
            if self.diverged[lane].is_some() || !is_good {
                self.look_closely(lane, interval, workspace);
            }
        }
    }

    /// Compensates the measured increments of each run.
    #[cold]
    #[inline(never)]
    fn compensate(&mut self, interval: &Interval<'_>, workspace: &mut Workspace) {
        let rows = &mut workspace.measured[..interval.count];
        let increments = &mut workspace.compensated[..interval.count];
        for (lane, of_run) in self.compensated.iter_mut().enumerate() {
            for (increment, rows) in increments.iter_mut().zip(&*rows) {
                *increment = increment_of(rows, lane);
            }
            if let Some(compensation) = &of_run.compensation {
                compensation.apply(increments, interval.dt);
                for (rows, increment) in rows.iter_mut().zip(&*increments) {
                    put_increment(rows, lane, increment);
                }
            }
            of_run.sum_before = core::mem::replace(&mut of_run.sum, Increment::sum(increments));
        }
    }

    /// Begins the interval for the failures, if there are any.
    #[inline]
    fn begin_failures(&mut self, interval: &Interval<'_>, workspace: &mut Workspace) {
        for (triad, _) in interval.have_failed.iter().enumerate().filter(|(_, has_failed)| **has_failed) {
            workspace.failures[triad][..self.count].clone_from_slice(&self.failures[triad]);
            self.failures[triad].iter_mut().for_each(|failures| failures.begin_interval(interval.t));
        }
    }

    /// Reads the altimeters, if each run has its own.
    #[inline]
    fn sense_heights(&mut self, interval: &Interval<'_>, workspace: &mut Workspace) {
        if let (VerticalAid::Barometer { height_m }, true) = (interval.aid, interval.has_altimeters) {
            for lane in (0..self.count).filter(|lane| self.diverged[*lane].is_none()) {
                let indicated_m = self.altimeters[lane].sense(height_m, interval.t);
                workspace.put_height(lane, height_m, indicated_m);
            }
        }
    }

    /// Reads the sensors and the altimeter of each run, if gravity is not normal.
    #[cold]
    #[inline(never)]
    fn sense_disturbed(&mut self, interval: &Interval<'_>, workspace: &mut Workspace) {
        for lane in 0..self.count {
            if self.diverged[lane].is_some() {
                continue;
            }
            let compensation = self.compensation(lane);
            let (sum, navigated, flags, indicated_m) =
                self.disturbed[lane].sense(interval, &mut workspace.disturbed, lane, compensation.as_ref());
            put_increment(&mut self.measured, lane, &sum);
            if let Some(of_run) = self.compensated.get_mut(lane) {
                of_run.sum_before = core::mem::replace(&mut of_run.sum, Increment::sum(navigated));
            }
            for (rows, increment) in workspace.measured.iter_mut().zip(navigated) {
                put_increment(rows, lane, increment);
            }
            if let VerticalAid::Barometer { height_m } = interval.aid {
                workspace.put_height(lane, height_m, indicated_m);
            }
            self.reports[lane] = Report { flags, is_unaided: workspace.is_unaided[lane] };
        }
    }

    /// Checks the run at `lane`. If it is not good, it goes back to its last good solution and stays there.
    #[cold]
    #[inline(never)]
    fn look_closely(&mut self, lane: usize, interval: &Interval<'_>, workspace: &Workspace) {
        if self.diverged[lane].is_none() {
            if self.is_good(lane, interval) {
                return;
            }
            self.diverged[lane] = Some(interval.last_good);
            if let Some(disturbed) = self.disturbed.get_mut(lane) {
                disturbed.undo(interval);
            } else if interval.has_altimeters {
                self.altimeters[lane].undo();
            }
        }
        for (navigators, before) in self.navigators.iter_mut().zip(&workspace.navigators) {
            navigators.go_back(lane, before);
        }
        for (models, before) in self.models.iter_mut().zip(&workspace.models) {
            models.go_back(lane, before);
        }
        self.measured.iter_mut().zip(&workspace.sums).for_each(|(row, before)| row[lane] = before[lane]);
        self.reports[lane] = workspace.reports[lane];
        if let Some(of_run) = self.compensated.get_mut(lane) {
            of_run.sum = of_run.sum_before;
        }
        if self.disturbed.is_empty() {
            self.gyro.go_back(lane, &workspace.gyro);
            self.accel.go_back(lane, &workspace.accel);
            for (triad, _) in interval.have_failed.iter().enumerate().filter(|(_, has_failed)| **has_failed) {
                self.failures[triad][lane].clone_from(&workspace.failures[triad][lane]);
            }
        }
    }

    /// Whether all solutions of a run are within their limits.
    fn is_good(&self, lane: usize, interval: &Interval<'_>) -> bool {
        let navigator = self.navigator(lane, interval.earth, interval.options);
        let mounting = interval.mounting_of(&self.navigated(lane));
        let is_reference_point_good = |mounting: mounting::Block| {
            check_state(interval.earth, &mounting.belief().reference_point(&navigator.state())).is_ok()
        };
        interval.is_shared_good && navigator.check().is_ok() && mounting.is_none_or(is_reference_point_good)
    }
}

/// The sensors of a block in an interval.
struct Sensing<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Sensing<'_> {
    /// Normal numbers need table look-ups. With AVX-512 the compiler uses gather instructions, which take 4.7 ns for a number of a
    /// run; single loads take 2.8 ns (Cascade Lake).
    const IN_EIGHTS: bool = false;

    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Block { gyro, accel, measured: sums, reports, failures, .. } = block;
        let [gyro_failures, accel_failures] = failures;
        let Workspace {
            gyro: gyro_before, accel: accel_before, measured, saturated: marks, is_unaided, ..
        } = workspace;
        let (gyro, accel) = ((gyro, gyro_before), (accel, accel_before));
        let &Interval { imperfections, shared, dt, count, have_failed: [gyro_failed, accel_failed], .. } =
            interval;
        let measured = &mut measured[..count];

        *marks = [[0; RUNS]; 2];
        imperfections.gyro.sense_block(&shared[0], dt, gyro, gyro_failures, measured, &mut marks[0]);
        imperfections.accel.sense_block(&shared[1], dt, accel, accel_failures, measured, &mut marks[1]);
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

/// The navigators and error models of a block in an interval.
struct Navigating<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Navigating<'_> {
    const IN_EIGHTS: bool = true;

    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Workspace { navigators: before, models: models_before, measured, scratch, .. } = workspace;
        let Workspace { heights_m, is_unaided, is_good, disturbed, .. } = workspace;
        let &Interval { earth, options, t, count, aid, .. } = interval;
        let Block { navigators, models, measured: sums, compensated, .. } = block;
        let ([navigators], [before]) = (&mut **navigators, &**before) else { return };
        let (measured, sums) = (&measured[..count], &*sums);
        let aid = match aid {
            VerticalAid::None => AidOfEach::None,
            VerticalAid::Truth { height_m, velocity_up_m_s } => AidOfEach::Truth { height_m, velocity_up_m_s },
            _ if is_unaided.contains(&true) => AidOfEach::Some { heights_m, is_none: is_unaided },
            VerticalAid::Barometer { .. } => AidOfEach::Barometer { heights_m },
        };
        let kind = (earth, options.scheme);
        let compensated = &*compensated;
        let mounting_of = |lane: usize| {
            let sum = compensated.get(lane).map_or_else(|| increment_of(sums, lane), |of_run| of_run.sum);
            interval.mounting_of(&sum)
        };
        navigators.navigate(
            (before, interval.shift_e.as_ref()),
            kind,
            options.subsamples,
            measured,
            t,
            scratch,
        );
        if interval.mounting.is_none() {
            navigators.aid_vertical(kind, &aid, t, is_good);
        } else {
            navigators.each(kind, |lane, navigator| {
                let belief = mounting_of(lane).map(|mounting| mounting.belief());
                aid_vertical(navigator, earth, &aid.at(lane), t, belief);
            });
            *is_good = [0; RUNS];
        }
        for ((models, before), interval_of_models) in
            models.iter_mut().zip(models_before).zip(&interval.model)
        {
            if !block.disturbed.is_empty() {
                let errors: &[SensorErrors; RUNS] = &disturbed.errors;
                models.advance_one_by_one(before, interval_of_models, &aid, |lane| {
                    (errors[lane], mounting_of(lane))
                });
            } else if interval.mounting.is_some() {
                models.advance_one_by_one(before, interval_of_models, &aid, |lane| {
                    (interval_of_models.errors(measured, lane), mounting_of(lane))
                });
            } else {
                models.advance(before, interval_of_models, measured, &aid);
            }
        }
    }
}
