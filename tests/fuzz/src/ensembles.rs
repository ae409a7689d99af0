//! Ensembles: a flight of a few runs, and the single simulator that one of the runs must equal; statistics and snapshots of
//! the ensemble, also altered ones.

use std::ptr::{null, null_mut, without_provenance_mut};

use sins::abi::*;

use crate::call;
use crate::host::{Host, check, init};
use crate::input::{Argument, Input};
use crate::motion::Motion;
use crate::settings::{
    some_accel, some_altimeter, some_correction, some_gyro, some_initial_errors, some_options,
};

const SAMPLES: usize = 12;

/// Two simulators that differ only in the run; `None` if the options are rejected.
fn two_alike(input: &mut Input, run: u64) -> Option<[*mut sins_sim; 2]> {
    let options = some_options(input);
    let (gyro, accel) = (some_gyro(input), some_accel(input));
    let (altimeter, initial) = (some_altimeter(input), some_initial_errors(input));
    let make = |run: u64| {
        let mut sim = null_mut();
        if call!(sins_create(&sins_options { run, ..options }, &mut sim)) != SINS_OK {
            return None;
        }
        call!(sins_set_gyro(sim, &gyro));
        call!(sins_set_accel(sim, &accel));
        call!(sins_set_altimeter(sim, &altimeter));
        call!(sins_set_initial_errors(sim, &initial));
        Some(sim)
    };
    Some([make(options.run)?, make(run)?])
}

fn saved(ensemble: *mut sins_ensemble) -> Vec<u8> {
    let (mut size, mut written) = (0, 0);
    assert_eq!(call!(sins_ensemble_snapshot_size(ensemble, &mut size)), SINS_OK);
    let mut bytes = vec![0_u8; size];
    let status =
        call!(sins_ensemble_snapshot_save(ensemble, bytes.as_mut_ptr().cast(), bytes.len(), &mut written));
    assert!(status == SINS_OK && written == size, "a snapshot of another size");
    bytes
}

fn load(ensemble: *mut sins_ensemble, snapshot: &[u8]) -> sins_status {
    call!(sins_ensemble_snapshot_load(ensemble, snapshot.as_ptr().cast(), snapshot.len()))
}

impl Host {
    /// An ensemble from its creation to its end.
    pub fn fly_ensemble(&mut self) {
        let runs = 1 + self.input.below(3);
        let first_run = self.input.pick(&[0, 1, 1 << 40, u64::MAX - 3, u64::MAX - 2]);
        let run = first_run.saturating_add(self.input.below(runs) as u64);
        let Some([template, single]) = two_alike(&mut self.input, run) else { return };
        let mut ensemble = null_mut();
        let status = call!(sins_ensemble_create(template, first_run, runs, &mut ensemble));
        let fits = first_run.checked_add(runs as u64 - 1).is_some();
        assert_eq!(status, if fits { SINS_OK } else { SINS_ERROR_INVALID_ARGUMENT });
        if fits {
            self.fly_beside(ensemble, single, run);
            self.look_at_statistics(ensemble);
            self.freeze(ensemble, template);
            call!(sins_ensemble_reset(ensemble));
            assert_eq!(call!(sins_ensemble_destroy(ensemble)), SINS_OK);
        }
        assert_eq!(call!(sins_destroy(template)), SINS_OK);
        assert_eq!(call!(sins_destroy(single)), SINS_OK);
        self.misuse_ensemble(ensemble);
    }

    /// Makes the same calls on both. All reads of the run must equal those of the simulator.
    fn fly_beside(&mut self, ensemble: *mut sins_ensemble, single: *mut sins_sim, run: u64) {
        let mut options = init();
        call!(sins_get_options(single, &mut options));
        let mut motion = Motion::new(&mut self.input, &options);
        let mut lost = false;
        for k in 0..SAMPLES {
            motion = motion.next(&mut self.input);
            let mut sample = motion.sample();
            if k == SAMPLES / 2 && self.input.one_in(4) {
                let mut failure: sins_failure = init();
                failure.fields.kind = SINS_FAILURE_STUCK;
                let (sensor, axis) = (self.input.pick(&[0, 1, 3]), self.input.below(3) as i32);
                let status = call!(sins_ensemble_set_failure(ensemble, sensor, axis, &failure));
                assert_eq!(status, call!(sins_set_failure(single, sensor, axis, &failure)));
            }
            if k > 1 && self.input.one_in(8) {
                let correction = some_correction(&mut self.input);
                let of_run = call!(sins_ensemble_correct(ensemble, run, &correction));
                assert!(lost || of_run == call!(sins_correct(single, &correction)), "another answer");
                let of_run = check::<sins_compensation>(|found| {
                    call!(sins_ensemble_get_compensation(ensemble, run, found))
                });
                let of_single =
                    check::<sins_compensation>(|found| call!(sins_get_compensation(single, found)));
                let bytes = |found: Option<sins_compensation>| found.map(|found| Argument::of(&found).bytes);
                assert!(lost || bytes(of_run) == bytes(of_single), "another compensation");
            }
            let prepared =
                call!(sins_scene_prepare_ensemble(self.scene, ensemble, sample.time_s, &mut sample));
            if prepared == SINS_OK {
                call!(sins_scene_prepare(self.scene, single, sample.time_s, &mut motion.sample()));
            }
            let answers = match self.input.byte() {
                0..8 if lost => break,
                0..8 => (
                    call!(sins_ensemble_reposition(ensemble, &sample)),
                    call!(sins_reposition(single, &sample)),
                ),
                8..16 if !lost => (
                    call!(sins_ensemble_run(ensemble, &sample, 1)),
                    call!(sins_run(single, &sample, 1, 0, null_mut(), 0, null_mut())),
                ),
                _ => {
                    let pushed = call!(sins_ensemble_push_sample(ensemble, &sample));
                    assert!(lost || pushed == call!(sins_push_sample(single, &sample)), "another answer");
                    let stepped = call!(sins_ensemble_step(ensemble));
                    (stepped, if lost { stepped } else { call!(sins_step(single)) })
                }
            };
            lost |= answers.0 >= 0 && [SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR].contains(&answers.1);
            assert!(lost || answers.0 == answers.1 || answers.0 == SINS_ERROR_SINGULAR, "another answer");
            if answers.0 < 0 {
                break;
            }
            self.compare(ensemble, single, run, lost);
        }
    }

    fn compare(&self, ensemble: *mut sins_ensemble, single: *mut sins_sim, run: u64, lost: bool) {
        let mut of_run = [init::<sins_navigation>(); 2];
        let status = call!(sins_ensemble_get_navigation(ensemble, run, &mut of_run[0]));
        if lost {
            assert_eq!(status, SINS_ERROR_DIVERGED);
            return;
        }
        assert_eq!(status, call!(sins_get_navigation(single, &mut of_run[1])));
        assert!(Argument::of(&of_run[0]).bytes == Argument::of(&of_run[1]).bytes, "another solution");
        for source in [SINS_ERRORS_NAVIGATION, SINS_ERRORS_MODEL] {
            let of_run =
                check::<sins_errors>(|errors| call!(sins_ensemble_get_errors(ensemble, run, source, errors)));
            let of_single = check::<sins_errors>(|errors| call!(sins_get_errors(single, source, errors)));
            let bytes = |errors: Option<sins_errors>| errors.map(|errors| Argument::of(&errors).bytes);
            assert!(bytes(of_run) == bytes(of_single), "other errors");
            let (mut first, mut runs) = (0, 0);
            call!(sins_ensemble_get_runs(ensemble, &mut first, &mut runs));
            let mut all = vec![init::<sins_errors>(); runs];
            let status = call!(sins_ensemble_get_all_errors(ensemble, source, all.as_mut_ptr(), runs));
            let of_all = (status == SINS_OK).then(|| all[(run - first) as usize]);
            // A run that has no errors does not keep the others from being read.
            let of_all = of_all.filter(|errors| errors.errors.flags != SINS_ERRORS_NOT_COMPUTED);
            assert!(bytes(of_all) == bytes(of_single), "other errors among those of all runs");
        }
        let of_run = check::<sins_imu>(|imu| call!(sins_ensemble_get_imu(ensemble, run, imu)));
        let of_single = check::<sins_imu>(|imu| call!(sins_get_imu(single, imu)));
        let bytes = |imu: Option<sins_imu>| imu.map(|imu| Argument::of(&imu).bytes);
        assert!(bytes(of_run) == bytes(of_single), "other signals");
        check::<sins_navigation>(|truth| call!(sins_ensemble_get_truth(ensemble, truth)));
    }

    /// Figures of the statistics and of altered statistics: each call gives finite numbers or fails.
    fn look_at_statistics(&mut self, ensemble: *mut sins_ensemble) {
        let (mut statistics, mut runs) = (init::<sins_statistics>(), 0);
        call!(sins_ensemble_get_runs(ensemble, null_mut(), &mut runs));
        let source = self.input.pick(&[SINS_ERRORS_NAVIGATION, SINS_ERRORS_NAVIGATION, SINS_ERRORS_MODEL, 2]);
        if call!(sins_ensemble_get_statistics(ensemble, source, &mut statistics)) != SINS_OK {
            assert!(statistics == init::<sins_statistics>(), "an output was written by a call that failed");
            return;
        }
        assert_eq!(statistics.runs, runs as u64);
        let mut diverged = 0;
        while call!(sins_ensemble_get_diverged(ensemble, diverged, &mut 0)) == SINS_OK {
            diverged += 1;
        }
        assert!(diverged as u64 <= statistics.diverged, "runs that diverged without being counted");
        let mut added = init::<sins_statistics>();
        let mut all = vec![init::<sins_errors>(); runs];
        if call!(sins_ensemble_get_all_errors(ensemble, source, all.as_mut_ptr(), runs)) == SINS_OK {
            for errors in &all {
                assert_eq!(call!(sins_statistics_add(&mut added, errors)), SINS_OK);
            }
            assert!(added == statistics, "other statistics of the runs one by one");
        }
        let mut twice = init::<sins_statistics>();
        for _ in 0..2 {
            assert_eq!(call!(sins_statistics_merge(&mut twice, &statistics)), SINS_OK);
        }
        assert_eq!(twice.runs, 2 * statistics.runs);
        check::<sins_figures>(|figures| call!(sins_statistics_figures(&twice, figures)));
        let (radius_m, percent) = (self.input.within((-1.0, 1e5)), self.input.within((-10.0, 110.0)));
        check::<sins_verdict>(|verdict| call!(sins_meets(&twice, radius_m, percent, verdict)));

        let alterations = 1 + self.input.below(3);
        let mut altered = self.input.altered(statistics, alterations);
        let pointer = altered.pointer::<sins_statistics>();
        let good =
            check::<sins_figures>(|figures| call!(sins_statistics_figures(pointer, figures))).is_some();
        let before = twice;
        let mut errors = self.input.altered(init::<sins_errors>(), alterations);
        call!(sins_statistics_add(&mut added, errors.pointer::<sins_errors>()));
        check::<sins_figures>(|figures| call!(sins_statistics_figures(&added, figures)));
        let merged = call!(sins_statistics_merge(&mut twice, pointer)) == SINS_OK;
        assert!(merged || before == twice, "a merge that failed changed something");
        assert!(good || !merged, "statistics without figures were taken");
    }

    /// A snapshot loads into any other ensemble, which then equals the saved one. A snapshot with one altered byte is rejected.
    fn freeze(&mut self, ensemble: *mut sins_ensemble, template: *mut sins_sim) {
        let mut other = null_mut();
        assert_eq!(call!(sins_ensemble_create(template, 4, 1, &mut other)), SINS_OK);
        let before = saved(other);
        let mut snapshot = saved(ensemble);
        let at = self.input.word() as usize % snapshot.len();
        snapshot[at] ^= 1 << self.input.below(8);
        assert_eq!(load(other, &snapshot), SINS_ERROR_SNAPSHOT);
        assert!(saved(other) == before, "a call that failed changed something");
        let snapshot = saved(ensemble);
        assert_eq!(load(other, &snapshot), SINS_OK);
        assert!(saved(other) == snapshot, "another ensemble than the saved one");
        assert_eq!(call!(sins_ensemble_destroy(other)), SINS_OK);
    }

    /// Calls with invalid handles.
    fn misuse_ensemble(&mut self, dead: *mut sins_ensemble) {
        assert_eq!(call!(sins_ensemble_step(dead)), SINS_ERROR_BAD_HANDLE);
        let made_up = without_provenance_mut(self.input.word() as usize);
        assert_eq!(call!(sins_ensemble_reset(made_up)), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_ensemble_destroy(self.sims[0].handle.cast())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_ensemble_create(null(), 0, 1, &mut null_mut())), SINS_ERROR_BAD_HANDLE);
        assert_eq!(call!(sins_statistics_merge(null_mut(), null())), SINS_ERROR_NULL_POINTER);
    }
}
