//! Flies a number of steps, for an instruction counter: the cost of a step is the difference of the counts of two runs, divided
//! by the difference of their numbers of steps.
//!
//! `steps WHAT COUNT`, where WHAT is one of:
//! - `simulation2`, `ideal`, `free`: through `sins_run`;
//! - `calls`: simulation 2 with push and step, each in a call of its own;
//! - `reads`: as `calls`, and reads navigation and both errors, each in a call of its own;
//! - `nav`, `align`, `att`: as `reads`, with the update of a unit in this mode; `shown`: as `nav`, with its status and what it shows;
//! - `record`: as `calls`, and reads truth, navigation and both errors in one call;
//! - `SCHEME,SUBSAMPLES,UPDATES,FRAME` (`exact,2,1,earth`): by push and step of the Rust simulator;
//! - `runs,N`, `runs,N,WIDTH` or `runs,N,WIDTH,FRAME`: simulation 2 in an ensemble of N runs, with instructions for WIDTH numbers;
//! - `save`, `load`: COUNT snapshots of simulation 2 in flight.

mod c_scene;
mod scene;

use std::time::Instant;

use sins::abi::*;
use sins::ensemble::Ensemble;
use sins::mechanization::{Frame, Scheme};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Error, Options, Simulator};

/// Number of samples that are made, independent of the number of steps, so that a difference of counts does not contain making
/// them.
const SAMPLES: usize = 20_001;
const FEW_SAMPLES: usize = 2_001;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let what = arguments.get(1).map(String::as_str).unwrap_or_default();
    let count = arguments.get(2).and_then(|count| count.parse::<usize>().ok());
    match (what, options(what), count) {
        ("simulation2" | "calls" | "reads" | "record" | "ideal" | "free", _, Some(count)) => run(what, count),
        ("nav" | "shown" | "align" | "att", _, Some(count)) => run(what, count),
        ("save" | "load", _, Some(count)) => snapshots(what == "load", count),
        (_, _, Some(count)) if what.starts_with("runs,") => ensemble(&what["runs,".len()..], count),
        (_, Some(options), Some(count)) => {
            let samples = scene::patrol(FEW_SAMPLES);
            push_and_step(&options, &samples[..=count]);
        }
        _ => {
            eprintln!(
                "usage: steps simulation2|calls|reads|nav|shown|align|att|record|ideal|free|save|load|runs,N[,WIDTH[,FRAME]]|SCHEME,SUBSAMPLES,UPDATES,FRAME COUNT"
            );
            std::process::exit(2);
        }
    }
}

/// Flies an ensemble that `what` describes: its number of runs, the width and the frame.
fn ensemble(what: &str, count: usize) {
    let words: Vec<&str> = what.split(',').collect();
    let runs = words[0].parse().expect("a number of runs");
    let width = words.get(1).map_or(usize::MAX, |width| width.parse().expect("a width"));
    let frame = words.get(2).and_then(|frame| Frame::of_word(frame)).unwrap_or_default();
    let samples = scene::patrol(FEW_SAMPLES);
    let mut ensemble = Ensemble::of_width(&simulation2(frame), 0, runs, width).unwrap();
    ensemble.run(count + 1, |index| Ok::<_, Error>(samples[index])).unwrap();
}

/// A simulator with the errors of simulation 2 and both error data.
fn simulation2(frame: Frame) -> Simulator {
    let (gyro, accel) = sins::sensors::paper_simulation2();
    let mut simulator = Simulator::new(&Options { error_model: true, frame, ..Options::default() }).unwrap();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator
}

fn snapshots(load: bool, count: usize) {
    let mut simulator = simulation2(Frame::default());
    for sample in scene::patrol(100) {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
    }
    let mut bytes = vec![0; simulator.snapshot_size()];
    simulator.save_snapshot(&mut bytes).unwrap();
    let start = Instant::now();
    for _ in 0..count {
        if load {
            simulator.load_snapshot(&bytes).unwrap();
        } else {
            simulator.save_snapshot(&mut bytes).unwrap();
        }
    }
    println!("{} bytes, {:.2} us each", bytes.len(), start.elapsed().as_secs_f64() * 1e6 / count as f64);
}

/// The options that `what` describes.
fn options(what: &str) -> Option<Options> {
    let mut words = what.split(',');
    let mut word = || words.next();
    let (scheme, subsamples, updates, frame) = (word()?, word()?, word()?, word()?);
    let (subsamples, updates_per_sample) = (subsamples.parse().ok()?, updates.parse().ok()?);
    let (scheme, frame) = (Scheme::of_word(scheme)?, Frame::of_word(frame)?);
    let intake = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
    Some(Options { scheme, subsamples, updates_per_sample, frame, intake, ..Default::default() })
}

fn push_and_step(options: &Options, samples: &[FlightSample]) {
    let mut simulator = Simulator::new(options).unwrap();
    for sample in samples {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
    }
}

fn run(what: &str, count: usize) {
    let samples = c_scene::c_samples(&scene::patrol(if count < FEW_SAMPLES { FEW_SAMPLES } else { SAMPLES }));
    let mut options = c_scene::c_options();
    let noisy = !matches!(what, "ideal" | "free");
    if !noisy {
        options.error_model = SINS_ERROR_MODEL_OFF;
    }
    if what == "free" {
        options.vertical = SINS_VERTICAL_FREE;
    }
    let samples = &samples[..=count];
    let sim = c_scene::simulator(&options, noisy);
    // SAFETY: a valid handle at the start of a flight.
    unsafe {
        match what {
            "calls" => c_scene::push_step(sim, samples, || ()),
            "reads" => c_scene::push_step_read(sim, samples, || ()),
            "nav" | "shown" => push_step_unit(sim, samples, SINS_UNIT_NAV, what == "shown"),
            "align" => push_step_unit(sim, samples, SINS_UNIT_ALIGN, false),
            "att" => push_step_unit(sim, samples, SINS_UNIT_ATT, false),
            "record" => push_step_record(sim, samples),
            _ => c_scene::run(sim, samples),
        }
        assert_eq!(sins_destroy(sim), SINS_OK);
    }
}

/// Flies the samples with push and step, and reads truth, navigation and both errors in one call.
///
/// # Safety
/// `sim` is a valid handle at the start of a flight.
unsafe fn push_step_record(sim: *mut sins_sim, samples: &[sins_flight_sample]) {
    // SAFETY: a struct of its own size.
    unsafe {
        let mut record: sins_record = core::mem::zeroed();
        record.struct_size = size_of::<sins_record>() as u32;
        c_scene::push_step(sim, samples, || assert_eq!(sins_get_record(sim, &mut record), SINS_OK));
    }
}

/// Flies the samples as `reads`, with a unit in `mode`.
///
/// # Safety
/// `sim` is a valid handle at the start of a flight.
unsafe fn push_step_unit(sim: *mut sins_sim, samples: &[sins_flight_sample], mode: i32, reads: bool) {
    // SAFETY: structs of their own size.
    unsafe {
        let mut params: sins_unit_params = core::mem::zeroed();
        params.struct_size = size_of::<sins_unit_params>() as u32;
        // The aircraft flies: ALIGN continues all the same.
        (params.motion_threshold_m_s, params.power_up_test_s, params.erection_s) = (1e3, 1e-3, 1e-3);
        let mut status: sins_unit_status = core::mem::zeroed();
        status.struct_size = size_of::<sins_unit_status>() as u32;
        let mut shown: sins_unit_navigation = core::mem::zeroed();
        shown.struct_size = size_of::<sins_unit_navigation>() as u32;
        let mut unit = core::ptr::null_mut();
        let start = if mode == SINS_UNIT_NAV { SINS_UNIT_NAV } else { SINS_UNIT_OFF };
        assert_eq!(sins_unit_create(&params, start, &mut unit), SINS_OK);
        assert_eq!(sins_unit_select(unit, mode), SINS_OK);
        let mut began = false;
        c_scene::push_step_read(sim, samples, || {
            if began {
                assert_eq!(sins_unit_update(unit, sim), SINS_OK);
            }
            if began && reads {
                assert_eq!(sins_unit_get_status(unit, &mut status), SINS_OK);
                assert_eq!(sins_unit_get_navigation(unit, sim, &mut shown), SINS_OK);
            }
            began = true;
        });
        assert_eq!(sins_unit_destroy(unit), SINS_OK);
    }
}
