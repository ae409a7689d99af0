//! Time of a step of a run in an ensemble, compared with the single chain through `sins_run`: the errors of simulation 2, error
//! data 2 alone and with error data 1. `ensemble [RUNS...]`: ratios of times that are measured in turns, from the undisturbed
//! rounds of many.

#[expect(dead_code, reason = "another program reads navigation and errors, too")]
mod c_scene;
mod scene;

use sins::abi::*;
use sins::ensemble::Ensemble;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Error, Options, Simulator};

/// Samples of the flight, which is flown once.
const SAMPLES: usize = 40_001;
/// Number of steps of all runs together in a round.
const ROUND: usize = 2000;
/// Smallest number of samples in a round, which an ensemble flies at once.
const FEWEST_STEPS: usize = 32;
/// Number of values in a vector of SSE2 or NEON, AVX2, AVX-512.
const WIDTHS: [usize; 3] = [2, 4, 8];

fn main() {
    let counts: Vec<usize> = std::env::args().skip(1).map(|count| count.parse().expect("a number")).collect();
    let counts = if counts.is_empty() { vec![1, 16, 64, 256, 1000, 10_000] } else { counts };
    let samples = scene::patrol(SAMPLES);
    for error_model in [false, true] {
        println!("{}", if error_model { "error data 1 and 2" } else { "error data 2" });
        for &runs in &counts {
            compare(runs, error_model, &samples);
        }
    }
}

fn compare(runs: usize, error_model: bool, samples: &[FlightSample]) {
    let c_samples = c_scene::c_samples(samples);
    let error_data_1 = if error_model { SINS_ERROR_MODEL_RK4 } else { SINS_ERROR_MODEL_OFF };
    let options = sins_options { error_model: error_data_1, ..c_scene::c_options() };
    let sim = c_scene::simulator(&options, true);
    let template = template(error_model);
    let mut ensembles = WIDTHS.map(|width| Ensemble::of_width(&template, 0, runs, width).unwrap());
    let (mut single_ns, mut ensemble_ns) = (Vec::new(), WIDTHS.map(|_| Vec::new()));
    // A number of steps of the single chain that takes about the same time.
    let steps = (ROUND / runs).max(FEWEST_STEPS);
    let single_steps = (steps * runs / 4).clamp(4, ROUND);
    let rounds = (SAMPLES - 1) / single_steps.max(steps + 1);
    for round in 0..rounds.clamp(1, (300 * ROUND / (steps * runs)).clamp(20, 300)) {
        let of_single = &c_samples[round * single_steps..][..single_steps];
        let start_s = processor_s();
        // SAFETY: a valid handle.
        unsafe { c_scene::run(sim, of_single) };
        single_ns.push((processor_s() - start_s) * 1e9 / single_steps as f64);
        for (ensemble, ns) in ensembles.iter_mut().zip(&mut ensemble_ns) {
            // The first step loads the runs into the cache and is not timed: a host flies only one ensemble.
            fly(ensemble, &samples[round * (steps + 1)..][..1]);
            let start_s = processor_s();
            fly(ensemble, &samples[round * (steps + 1) + 1..][..steps]);
            ns.push((processor_s() - start_s) * 1e9 / (steps * runs) as f64);
        }
    }
    // SAFETY: a valid handle.
    unsafe { sins_destroy(sim) };
    let single_ns = undisturbed(single_ns);
    let bytes = ensembles[0].bytes_of_run();
    print!("{runs} runs of {bytes} bytes: single {single_ns:.0} ns");
    for (width, ns) in WIDTHS.iter().zip(ensemble_ns) {
        let ns = undisturbed(ns);
        print!("; {width} at a time {ns:.1} ns, 1/{:.2}", single_ns / ns);
    }
    println!();
}

/// Processor time of this thread [s], because other programs may be busy. For Linux.
fn processor_s() -> f64 {
    #[repr(C)]
    struct Time {
        s: i64,
        ns: i64,
    }
    unsafe extern "C" {
        fn clock_gettime(clock: i32, time: *mut Time) -> i32;
    }
    const CLOCK_THREAD_CPUTIME_ID: i32 = 3;
    let mut time = Time { s: 0, ns: 0 };
    // SAFETY: the C library's function, with room for its answer.
    unsafe { clock_gettime(CLOCK_THREAD_CPUTIME_ID, &mut time) };
    time.s as f64 + 1e-9 * time.ns as f64
}

fn fly(ensemble: &mut Ensemble, samples: &[FlightSample]) {
    ensemble.run(samples.len(), |index| Ok::<_, Error>(samples[index])).unwrap();
}

/// The time that a tenth of the rounds do not reach. The first round, in which the flight starts, does not count.
fn undisturbed(mut ns: Vec<f64>) -> f64 {
    ns.remove(0);
    ns.sort_by(f64::total_cmp);
    ns[ns.len() / 10]
}

fn template(error_model: bool) -> Simulator {
    let intake = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
    let (gyro, accel) = sins::sensors::paper_simulation2();
    let mut template = Simulator::new(&Options { intake, error_model, ..Options::default() }).unwrap();
    template.set_gyro(&gyro).unwrap();
    template.set_accel(&accel).unwrap();
    template
}
