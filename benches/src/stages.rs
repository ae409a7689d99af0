//! An experiment that flies the stages over blocks of samples. Intake, generator and sensors do not depend on the navigator, and
//! the instructions of a step of the chain do not fit into the first-level cache. `stages` prints ratios of the time in blocks to
//! the time sample by sample, measured in turns, alone and beside a thread that also flies.

#[path = "scene.rs"]
mod scene;

use std::hint::black_box;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use sins::earth::Earth;
use sins::earth::state::BodyAxes;
use sins::mechanization::{Frame, Mechanization, Scheme, VerticalAid};
use sins::sensors::{Sensor, StreamKey, Triad, paper_simulation2};
use sins::signal::{Increment, SignalGenerator};
use sins::truth::{FlightSample, Intake, IntakeLimits};

const SAMPLES: usize = 20_000;
const PAIR_S: f64 = 0.5 * scene::PERIOD_S;
/// Samples in a block; 1 is sample by sample.
const BLOCKS: [usize; 4] = [1, 16, 32, 64];
const LARGEST: usize = 64;
const ROUNDS: usize = 41;

/// Data of each sample that a block keeps.
struct Kept {
    ideal: [[Increment; 2]; LARGEST],
    measured: [[Increment; 2]; LARGEST],
    heights_m: [f64; LARGEST],
}

struct Stages {
    intake: Intake,
    generator: SignalGenerator,
    triads: [Triad; 2],
    navigator: Mechanization,
    kept: Kept,
}

impl Stages {
    fn new(samples: &[FlightSample]) -> Self {
        let earth = Earth::default();
        let limits = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
        let mut intake = Intake::new(earth, BodyAxes::default(), limits).unwrap();
        intake.push(&samples[0]).unwrap();
        intake.take();
        let state = intake.current().unwrap().state;
        let mut triads =
            [Sensor::Gyro, Sensor::Accelerometer].map(|sensor| Triad::new(StreamKey::default(), sensor));
        let (gyro, accel) = paper_simulation2();
        triads[0].set(&gyro);
        triads[1].set(&accel);
        Self {
            intake,
            generator: SignalGenerator::new(earth.rate_rad_s),
            triads,
            navigator: Mechanization::new(earth, Frame::EarthFixed, Scheme::Exact, &state),
            kept: Kept {
                ideal: [[Increment::ZERO; 2]; LARGEST],
                measured: [[Increment::ZERO; 2]; LARGEST],
                heights_m: [0.0; LARGEST],
            },
        }
    }

    #[inline(never)]
    fn generate(&mut self, sample: &FlightSample, at: usize) {
        self.intake.push(sample).unwrap();
        if let Some(recent) = self.intake.recent() {
            self.generator.advance(&recent).integrate(&mut self.kept.ideal[at]);
        }
        self.kept.heights_m[at] = sample.place.height_m;
        self.intake.take();
    }

    #[inline(never)]
    fn sense(&mut self, at: usize) {
        let (ideal, measured) = (&self.kept.ideal[at], &mut self.kept.measured[at]);
        *measured = *ideal;
        for triad in &mut self.triads {
            triad.sense_each(ideal, PAIR_S, measured);
        }
    }

    #[inline(never)]
    fn navigate(&mut self, at: usize) {
        self.navigator.update(&self.kept.measured[at], scene::PERIOD_S);
        let aid = VerticalAid::Barometer { height_m: self.kept.heights_m[at] };
        self.navigator.aid_vertical(&aid, scene::PERIOD_S);
    }

    fn fly(&mut self, samples: &[FlightSample], block: usize) {
        for samples in samples.chunks(block) {
            samples.iter().enumerate().for_each(|(at, sample)| self.generate(sample, at));
            (0..samples.len()).for_each(|at| self.sense(at));
            (0..samples.len()).for_each(|at| self.navigate(at));
        }
    }
}

/// Median times of a sample in blocks of each length [ns].
fn times(samples: &[FlightSample]) -> [f64; BLOCKS.len()] {
    let mut ns = BLOCKS.map(|_| Vec::new());
    let mut ends = Vec::new();
    for _ in 0..ROUNDS {
        for (block, ns) in BLOCKS.iter().zip(&mut ns) {
            let mut stages = Stages::new(samples);
            let start = Instant::now();
            stages.fly(&samples[1..], *block);
            ns.push(start.elapsed().as_secs_f64() * 1e9 / (samples.len() - 1) as f64);
            ends.push(stages.navigator.state());
        }
    }
    assert!(ends.iter().all(|end| *end == ends[0]), "blocks changed the flight");
    ns.map(|mut ns| {
        ns.sort_by(f64::total_cmp);
        ns[ROUNDS / 2]
    })
}

fn report(name: &str, ns: [f64; BLOCKS.len()]) {
    print!("{name}: sample by sample {:.0} ns", ns[0]);
    for (block, ns_of_block) in BLOCKS.iter().zip(ns).skip(1) {
        print!("; blocks of {block} {:.3} of it", ns_of_block / ns[0]);
    }
    println!();
}

fn main() {
    let samples = scene::patrol(SAMPLES);
    report("alone", times(&samples));
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                let mut stages = Stages::new(&samples);
                stages.fly(&samples[1..], 1);
                black_box(&stages.navigator);
            }
        });
        report("beside a busy thread", times(&samples));
        done.store(true, Ordering::Relaxed);
    });
}
