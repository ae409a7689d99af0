//! Flies a number of steps, for an instruction counter: the difference between two numbers of steps is the cost of a step.
//! `steps WHAT COUNT`: WHAT = simulation2 | ideal | free through `sins_run`; reads: simulation 2 with push, step, and read
//! navigation and both errors, each a call; SCHEME,SUBSAMPLES,UPDATES,FRAME (exact,2,1,Earth-fixed) by push and step of the Rust
//! simulator; or save | load: as many snapshots of simulation 2 in flight.

mod c_scene;
mod scene;

use std::ptr::null_mut;
use std::time::Instant;

use sins::abi::*;
use sins::mechanization::{Frame, Scheme};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Options, Simulator};

/// Samples that are made whatever the count, as far as it goes: outside of what is counted.
const SAMPLES: usize = 20_001;
const FEW_SAMPLES: usize = 2_001;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let what = arguments.get(1).map(String::as_str).unwrap_or_default();
    let count = arguments.get(2).and_then(|count| count.parse::<usize>().ok());
    match (what, options(what), count) {
        ("simulation2" | "reads" | "ideal" | "free", _, Some(count)) => run(what, count),
        ("save" | "load", _, Some(count)) => snapshots(what == "load", count),
        (_, Some(options), Some(count)) => {
            let samples = scene::patrol(FEW_SAMPLES);
            push_and_step(&options, &samples[..=count.min(samples.len() - 1)]);
        }
        _ => {
            eprintln!(
                "usage: steps simulation2|reads|ideal|free|save|load|SCHEME,SUBSAMPLES,UPDATES,FRAME COUNT"
            );
            std::process::exit(2);
        }
    }
}

fn snapshots(load: bool, count: usize) {
    let (gyro, accel) = sins::sensors::paper_simulation2();
    let mut simulator = Simulator::new(&Options { error_model: true, ..Options::default() }).unwrap();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
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

/// The options that `what` spells.
fn options(what: &str) -> Option<Options> {
    let mut words = what.split(',');
    let mut word = || words.next();
    let (scheme, subsamples, updates, frame) = (word()?, word()?, word()?, word()?);
    let (subsamples, updates_per_sample) = (subsamples.parse().ok()?, updates.parse().ok()?);
    let scheme = match scheme {
        "paper" => Scheme::Paper,
        "exact" => Scheme::Exact,
        "polynomial" => Scheme::Polynomial,
        _ => return None,
    };
    let frame = match frame {
        "Earth-fixed" => Frame::EarthFixed,
        "geographic" => Frame::Geographic,
        _ => return None,
    };
    let intake = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
    Some(Options { scheme, subsamples, updates_per_sample, frame, intake, ..Default::default() })
}

fn push_and_step(options: &Options, samples: &[FlightSample]) {
    let simulator = Simulator::new(options);
    assert!(simulator.is_ok_and(|mut simulator| {
        samples.iter().all(|sample| simulator.push_sample(sample).is_ok() && simulator.step().is_ok())
    }));
}

fn run(what: &str, count: usize) {
    let samples = c_scene::c_samples(&scene::patrol(if count < FEW_SAMPLES { FEW_SAMPLES } else { SAMPLES }));
    let mut options = c_scene::c_options();
    let noisy = matches!(what, "simulation2" | "reads");
    if !noisy {
        options.error_model = SINS_ERROR_MODEL_OFF;
    }
    if what == "free" {
        options.vertical = SINS_VERTICAL_FREE;
    }
    // SAFETY: structs of their own size, as many samples as are stated.
    unsafe {
        let mut sim = null_mut();
        assert_eq!(sins_create(&options, &mut sim), SINS_OK);
        if noisy {
            let mut gyro: sins_gyro_params = core::mem::zeroed();
            gyro.struct_size = size_of::<sins_gyro_params>() as u32;
            let mut accel: sins_accel_params = core::mem::zeroed();
            accel.struct_size = size_of::<sins_accel_params>() as u32;
            assert_eq!(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &mut gyro), SINS_OK);
            assert_eq!(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, &mut accel), SINS_OK);
            assert_eq!(sins_set_gyro(sim, &gyro), SINS_OK);
            assert_eq!(sins_set_accel(sim, &accel), SINS_OK);
        }
        let samples = &samples[..=count.min(samples.len() - 1)];
        if what == "reads" {
            push_step_read(sim, samples);
        } else {
            assert_eq!(sins_run(sim, samples.as_ptr(), samples.len(), 0, null_mut(), 0, null_mut()), SINS_OK);
        }
        assert_eq!(sins_destroy(sim), SINS_OK);
    }
}

/// # Safety
/// `sim` is a living handle.
unsafe fn push_step_read(sim: *mut sins_sim, samples: &[sins_flight_sample]) {
    // SAFETY: structs of their own size.
    unsafe {
        let mut navigation: sins_navigation = core::mem::zeroed();
        navigation.struct_size = size_of::<sins_navigation>() as u32;
        let mut errors: sins_errors = core::mem::zeroed();
        errors.struct_size = size_of::<sins_errors>() as u32;
        for sample in samples {
            sins_push_sample(sim, sample);
            sins_step(sim);
            sins_get_navigation(sim, &mut navigation);
            sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &mut errors);
            sins_get_errors(sim, SINS_ERRORS_MODEL, &mut errors);
        }
        assert!(errors.time_s > 0.0);
    }
}
