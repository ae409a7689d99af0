//! Planned updates of a scene: each leaves the error of its fix, in every door, and changes no other random number.

use std::sync::OnceLock;

use nalgebra::Vector3;
use sins::ensemble::Ensemble;
use sins::errors::NavigationErrors;
use sins::errors::correction::Correction;
use sins::scene::{FliesScene, Scene};
use sins::sensors::{Failure, SensorOutput, StreamKey};
use sins::truth::flight::Flight;
use sins::truth::{FlightSample, Pushed};
use sins::{Error, ErrorKind, ErrorSource, Simulator};

use crate::support::errors;
use crate::support::moments::{reads, snapshot};

/// The patrol with sensors of navigation grade, at 20 Hz, with further lines.
fn scene(lines: &str) -> Scene {
    let text = format!(
        "[flight]\nbuiltin = \"patrol\"\nhours = 0.05\nrate_hz = 20\n[gyro]\npreset = \"tactical\"\n\
         [accelerometer]\npreset = \"tactical\"\n[start]\nposition_sigma_m = 100\nvelocity_sigma_m_s = 1\n\
         misalignment_sigma_arcmin = 1\n{lines}"
    );
    Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Sample `k` of the flight, whose first time stamp is `start_s` [s].
fn sample(k: u32, start_s: f64) -> FlightSample {
    static FLIGHT: OnceLock<Flight> = OnceLock::new();
    let flight = FLIGHT.get_or_init(|| scene("").flight().unwrap());
    let sample = flight.sample_at(f64::from(k) / 20.0).unwrap();
    FlightSample { time_s: sample.time_s + start_s, ..sample }
}

/// Flies samples of a scene.
fn fly<F: FliesScene>(
    scene: &Scene,
    start_s: f64,
    samples: core::ops::Range<u32>,
    flown: &mut F,
    mut step: impl FnMut(&mut F, &FlightSample),
) {
    for k in samples {
        let mut sample = sample(k, start_s);
        scene.prepare(flown, start_s, &mut sample).unwrap();
        step(flown, &sample);
    }
}

fn simulator(scene: &Scene, run: u64) -> Simulator {
    let mut scene = scene.clone();
    scene.options.key.run = run;
    let [simulator] = *scene.simulator().unwrap();
    simulator
}

fn step(simulator: &mut Simulator, sample: &FlightSample) {
    simulator.push_sample(sample).unwrap();
    simulator.step().unwrap();
}

fn step_all(ensemble: &mut Ensemble, sample: &FlightSample) {
    ensemble.push_sample(sample).unwrap();
    ensemble.step().unwrap();
}

/// The errors before and after the preparation of the sample behind `time_s`.
fn around(scene: &Scene, start_s: f64, time_s: f64) -> [NavigationErrors; 2] {
    let mut simulator = simulator(scene, 3);
    let next = (time_s * 20.0).round() as u32 + 1;
    fly(scene, start_s, 0..next, &mut simulator, step);
    let before = errors(&simulator, ErrorSource::Navigation);
    fly(scene, start_s, next..next + 1, &mut simulator, |_, _| {});
    [before, errors(&simulator, ErrorSource::Navigation)]
}

/// A fix without an error leaves the rounding of a position of an Earth radius, 2 nm, and of a velocity; the other errors stay. In both
/// frames, with a mounting and far from the time 0. An update between two samples is made at the second one.
#[test]
fn a_perfect_fix_leaves_no_error() {
    let (mut share, mut turn) = (0.0f64, 0.0f64);
    let mounting = "[mounting]\nlever_arm_m = [3, -5, 1]\nlever_arm_error_mm = [100, 50, 20]\n";
    for (lines, start_s) in [("", 0.0), ("[options]\nframe = \"geographic\"\n", 1e6), (mounting, -7.3)] {
        for (kind, at_s) in [("position", 60.0), ("horizontal_position", 59.96), ("velocity", 60.0)] {
            let scene = scene(&format!("{lines}[[update]]\nkind = \"{kind}\"\nat_s = {at_s}\n"));
            let [before, after] = around(&scene, start_s, 60.0);
            let left = |of: fn(&NavigationErrors) -> Vector3<f64>| (of(&after), of(&after) - of(&before));
            let (position, moved) = left(|errors| errors.position_n);
            let (velocity, changed) = left(|errors| errors.velocity_n);
            let turned = after.misalignment_n - before.misalignment_n;
            assert!(moved.norm() > 10.0 || changed.norm() > 0.1, "{kind}: nothing was corrected");
            assert!(turned.norm() < 4e-15, "{kind}: {turned}");
            let [largest, still] = match kind {
                "velocity" => [velocity.norm() / 1e-12, moved.norm() / 1e-8],
                "position" => [position.norm() / 1e-8, changed.norm() / 1e-12],
                _ => [position.xy().norm() / 1e-8, changed.norm() / 1e-12 + moved.z.abs() / 1e-8],
            };
            assert!(largest < 1.0 && still < 1.0, "{kind} {lines}: {largest} {still}");
            (share, turn) = (share.max(largest).max(still), turn.max(turned.norm()));
        }
    }
    println!("figure: {share:.2} of 1e-8 m and 1e-12 m/s, {turn:.1e} rad (limit 4e-15 rad)");
}

/// What a scene asks of a simulator, and the time stamps at which it corrected.
struct Asked {
    stamps: Vec<f64>,
    corrected_s: Vec<f64>,
}

impl FliesScene for Asked {
    fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.stamps.push(sample.time_s);
        Ok(Pushed::Regular)
    }

    fn last_sample_time_s(&self) -> Option<f64> {
        self.stamps.last().copied()
    }

    fn last_interval_s(&self) -> Option<[f64; 2]> {
        self.stamps.last_chunk().copied()
    }

    fn correct_each(&mut self, _: &dyn Fn(StreamKey, &NavigationErrors) -> Correction) -> Result<(), Error> {
        self.corrected_s.extend(self.stamps.last());
        Ok(())
    }

    fn failure(&self, _: SensorOutput) -> Option<Failure> {
        None
    }

    fn set_failure(&mut self, _: SensorOutput, _: Option<Failure>) -> Result<(), Error> {
        Ok(())
    }
}

/// Each planned time is made once, at the first sample at or after it, but for the rounding of the stamps; also far from the time 0,
/// where the stamps are rounded in other ways.
#[test]
fn an_update_is_made_once_at_its_time() {
    for (at_s, every) in
        [(10.0, ""), (0.3, "every_s = 0.1\n"), (0.05, "every_s = 0.05\n"), (0.72, "every_s = 0.36\n")]
    {
        let scene = scene(&format!("[[update]]\nkind = \"position\"\nat_s = {at_s}\n{every}"));
        let every_s = scene.updates[0].every_s;
        for start_s in [0.0, -7.3, 1000.1, 123_456.7, 1e5 / 3.0] {
            let mut asked = Asked { stamps: Vec::new(), corrected_s: Vec::new() };
            fly(&scene, start_s, 0..2001, &mut asked, |asked, sample| {
                asked.push_sample(sample).unwrap();
            });
            // At the last sample, at 100 s, there is no interval behind an update.
            let due = (0..).map(|k| at_s + f64::from(k) * if k > 0 { every_s } else { 0.0 });
            let due: Vec<f64> = due.take_while(|due_s| *due_s < 99.99).collect();
            assert_eq!(asked.corrected_s.len(), due.len(), "{at_s} {every} {start_s}");
            for (made_s, due_s) in asked.corrected_s.iter().zip(due) {
                let late_s = made_s - start_s - due_s;
                assert!((-1e-10..0.05 - 1e-10).contains(&late_s), "{at_s} {every} {start_s}: {late_s}");
            }
        }
    }
}

/// Errors of the fixes have the standard deviations that were set, in each axis; those of two runs, two times and two kinds are
/// independent. Bounds: 4.4 standard deviations of each estimate, exceeded by one of 1e5.
#[test]
fn fixes_have_the_errors_that_were_set() {
    const RUNS: usize = 2000;
    let scene = scene(
        "[[update]]\nkind = \"position\"\nat_s = 1\nevery_s = 1\nsigma_m = [10, 20, 40]\n\
         [[update]]\nkind = \"velocity\"\nat_s = 1\nsigma_m_s = [0.1, 0.2, 0.3]\n",
    );
    let mut ensemble = Ensemble::new(&simulator(&scene, 0), 0, RUNS).unwrap();
    let mut fixes: Vec<Vec<f64>> = Vec::new();
    for (from, to) in [(0, 21), (21, 41)] {
        fly(&scene, 0.0, from..to, &mut ensemble, step_all);
        fly(&scene, 0.0, to..to + 1, &mut ensemble, |_, _| {});
        let of_run = |run| ensemble.errors(run, ErrorSource::Navigation).unwrap().unwrap().1;
        let all: Vec<NavigationErrors> = (0..RUNS as u64).map(of_run).collect();
        for axis in 0..3 {
            fixes.push(all.iter().map(|errors| errors.position_n[axis] / [10.0, 20.0, 40.0][axis]).collect());
            if from == 0 {
                fixes
                    .push(all.iter().map(|errors| errors.velocity_n[axis] / [0.1, 0.2, 0.3][axis]).collect());
            }
        }
    }
    let n = RUNS as f64;
    let mean = |of: &dyn Fn(usize) -> f64| (0..RUNS).map(of).sum::<f64>() / n;
    for (i, one) in fixes.iter().enumerate() {
        assert!(mean(&|k| one[k]).abs() < 4.4 / n.sqrt());
        let variance = mean(&|k| one[k] * one[k]);
        assert!((variance - 1.0).abs() < 4.4 * (2.0 / n).sqrt(), "{i}: {variance}");
        for other in &fixes[..i] {
            assert!(mean(&|k| one[k] * other[k]).abs() < 4.4 / n.sqrt(), "{i}");
        }
        let runs = (0..RUNS - 1).map(|k| one[k] * one[k + 1]).sum::<f64>() / (n - 1.0);
        assert!(runs.abs() < 4.4 / n.sqrt(), "{i}");
    }
}

const UPDATES: &str = "[[update]]\nkind = \"position\"\nat_s = 5\nevery_s = 2.5\nsigma_m = 10\n\
     [[update]]\nkind = \"velocity\"\nat_s = 7.5\nsigma_m_s = 0.1\n";

/// No other random number changes: the measured increments are those of the scene without updates, to the bit.
#[test]
fn updates_change_no_other_random_number() {
    let sensed = |scene: &Scene| {
        let mut increments = Vec::new();
        fly(scene, 0.0, 0..400, &mut simulator(scene, 0), |simulator, sample| {
            step(simulator, sample);
            increments.extend(simulator.imu());
        });
        increments
    };
    assert!(sensed(&scene(UPDATES)) == sensed(&scene("")));
}

/// A run of an ensemble has the bits of its simulator. A simulator goes on from a snapshot to the same bits, also at an update.
#[test]
fn every_door_gives_the_same_bits() {
    for lines in ["", "[options]\nsignal = \"closed-loop\"\n", "[gravity]\nanomaly_mgal = 30\n"] {
        let scene = scene(&format!("{lines}{UPDATES}"));
        let mut ensemble = Ensemble::new(&simulator(&scene, 0), 5, 19).unwrap();
        fly(&scene, 0.0, 0..400, &mut ensemble, step_all);
        for run in [5, 13, 23] {
            let mut alone = simulator(&scene, run);
            let mut loaded = simulator(&scene, run);
            for k in 0..400 {
                if [101, 151, 200, 201].contains(&k) {
                    loaded.load_snapshot(&snapshot(&alone)).unwrap();
                }
                fly(&scene, 0.0, k..k + 1, &mut alone, step);
                fly(&scene, 0.0, k..k + 1, &mut loaded, step);
            }
            assert!(reads(&alone) == reads(&loaded), "{run}");
            let found = ensemble.navigation(run).unwrap();
            assert!(found == alone.navigation().unwrap(), "{run} {lines}");
        }
    }
}

/// Error data 1 takes the same updates: with a tenth of the errors it is a hundredth off error data 2.
#[test]
fn both_error_data_take_the_same_updates() {
    let apart = |sigma: f64| {
        let text = format!(
            "[flight]\nbuiltin = \"patrol\"\nhours = 0.05\nrate_hz = 20\n[options]\nerror_model = \"rk4\"\n[start]\n\
             position_m = [{}, 0, 0]\n[[update]]\nkind = \"position\"\nat_s = 5\nevery_s = 2.5\nsigma_m = {}\n\
             [[update]]\nkind = \"velocity\"\nat_s = 6\nsigma_m_s = {}\n",
            1e4 * sigma,
            1e4 * sigma,
            10.0 * sigma
        );
        let scene = Scene::parse(text.as_bytes()).unwrap();
        let mut simulator = simulator(&scene, 0);
        fly(&scene, 0.0, 0..400, &mut simulator, step);
        let [navigated, model] =
            [ErrorSource::Navigation, ErrorSource::Model].map(|source| errors(&simulator, source).position_n);
        assert!(model.norm() >= 1e3 * sigma);
        navigated - model
    };
    let own = apart(0.0);
    let (one, tenth) = ((apart(1.0) - own).norm(), (apart(0.1) - own).norm());
    assert!((70.0..140.0).contains(&(one / tenth)), "{one} {tenth}");
}

/// An error beyond the limits of a correction is rejected, and changes nothing. Of an ensemble that run diverges, and the others go on.
#[test]
fn a_run_that_cannot_be_corrected_diverges() {
    // The limit of a velocity error is 1e4 m/s; half of the runs are beyond it.
    let scene = scene("velocity_m_s = [10000, 0, 0]\n[[update]]\nkind = \"velocity\"\nat_s = 0.1\n");
    let mut ensemble = Ensemble::new(&simulator(&scene, 0), 0, 40).unwrap();
    fly(&scene, 0.0, 0..10, &mut ensemble, step_all);
    let diverged: Vec<u64> = ensemble.diverged().collect();
    assert!((5..35).contains(&diverged.len()), "{diverged:?}");
    for run in 0..40 {
        let mut alone = simulator(&scene, run);
        fly(&scene, 0.0, 0..3, &mut alone, step);
        let mut prepared = alone.clone();
        match scene.prepare(&mut prepared, 0.0, &mut sample(3, 0.0)) {
            Ok(()) => {
                fly(&scene, 0.0, 3..10, &mut alone, step);
                assert!(ensemble.navigation(run).unwrap() == alone.navigation().unwrap(), "{run}");
            }
            Err(error) => {
                assert!(diverged.contains(&run), "{run}");
                let expected = (ErrorKind::InvalidArgument, "correction.velocity_enu_m_s");
                assert_eq!((error.kind, error.field), expected);
                assert!(snapshot(&prepared) == snapshot(&alone));
            }
        }
    }
}

/// In the vertical channel that follows the truth the height has no error, and a fix brings none.
#[test]
fn a_height_that_follows_the_truth_takes_no_fix() {
    let scene = scene(
        "[options]\nvertical = \"follow\"\n[[update]]\nkind = \"position\"\nat_s = 60\nsigma_m = 100\n",
    );
    let [before, after] = around(&scene, 0.0, 60.0);
    let [raised, moved] = [2, 0].map(|axis| (after.position_n[axis] - before.position_n[axis]).abs());
    assert!(raised < 1e-8 && moved > 1.0, "{raised} {moved}");
}
