//! What a run of an ensemble takes in a step, against the single chain through `sins_run`: the errors of simulation 2, error data 2.
//! `ensemble [RUNS...]`: ratios of times that are measured in turn, the least of many; another program on the core falls on both.

mod c_scene;
mod scene;

use std::time::Instant;

use sins::abi::*;
use sins::ensemble::Ensemble;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Options, Simulator};

const STEPS: usize = 200;
const ROUNDS: usize = 40;
/// Numbers at a time: SSE2 or NEON, AVX2, AVX-512.
const WIDTHS: [usize; 3] = [2, 4, 8];

fn main() {
    let counts: Vec<usize> = std::env::args().skip(1).map(|count| count.parse().expect("a number")).collect();
    let counts = if counts.is_empty() { vec![1, 16, 64, 256, 1000, 10_000] } else { counts };
    let samples = scene::patrol(STEPS + 1);
    for runs in counts {
        compare(runs, &samples);
    }
}

fn compare(runs: usize, samples: &[FlightSample]) {
    let c_samples = c_scene::c_samples(samples);
    let options = sins_options { error_model: SINS_ERROR_MODEL_OFF, ..c_scene::c_options() };
    let sim = c_scene::simulator(&options, true);
    let template = template();
    let mut ensembles = WIDTHS.map(|width| Ensemble::of_width(&template, 0, runs, width).unwrap());
    let mut single_ns = f64::INFINITY;
    let mut ensemble_ns = [f64::INFINITY; WIDTHS.len()];
    for _ in 0..(ROUNDS * 100).div_ceil(runs + 100).max(3) {
        let start = Instant::now();
        // SAFETY: a living handle.
        unsafe {
            assert_eq!(sins_reset(sim), SINS_OK);
            c_scene::run(sim, &c_samples);
        }
        single_ns = single_ns.min(start.elapsed().as_secs_f64() * 1e9 / STEPS as f64);
        for (ensemble, least_ns) in ensembles.iter_mut().zip(&mut ensemble_ns) {
            ensemble.reset();
            let start = Instant::now();
            for sample in samples {
                ensemble.push_sample(sample).unwrap();
                ensemble.step().unwrap();
            }
            let ns = start.elapsed().as_secs_f64() * 1e9 / (STEPS * runs) as f64;
            *least_ns = least_ns.min(ns);
        }
    }
    // SAFETY: a living handle.
    unsafe { sins_destroy(sim) };
    let bytes = ensembles[0].bytes_of_run().unwrap_or_default();
    print!("{runs} runs of {bytes} bytes: single {single_ns:.0} ns");
    for (width, ns) in WIDTHS.iter().zip(ensemble_ns) {
        print!("; {width} at a time {ns:.1} ns, 1/{:.2}", single_ns / ns);
    }
    println!();
}

fn template() -> Simulator {
    let intake = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
    let (gyro, accel) = sins::sensors::paper_simulation2();
    let mut template = Simulator::new(&Options { intake, ..Options::default() }).unwrap();
    template.set_gyro(&gyro).unwrap();
    template.set_accel(&accel).unwrap();
    template
}
