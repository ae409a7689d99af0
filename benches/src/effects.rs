//! Cost of each effect of the sensors. For `effects.sh`: `effects names` lists the effects; `effects fly NAME COUNT` flies COUNT
//! steps with this effect alone, for an instruction counter; `effects table FILE` makes the table from lines `NAME;INSTRUCTIONS`,
//! with times that are measured in turns.

mod scene;

use std::collections::BTreeMap;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use nalgebra::{Matrix3, Vector3};
use sins::sensors::{AltimeterParameters, Axis, EFFECTS, Failure, SensorOutput, TriadParameters};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Options, Simulator};

const SAMPLES: usize = 2_001;

/// Number of timings of each configuration, each right after a flight without errors. The table uses the median of the ratios,
/// which other programs on the machine disturb least.
const TURNS: usize = 200;
const TIMED_STEPS: usize = 500;

/// Sets one effect of a triad, in a size as in a laboratory.
type Setting = fn(&mut TriadParameters);

/// A row for each effect of the library's table, in its order.
const TRIAD_EFFECTS: [(&str, Setting); EFFECTS.len()] = [
    ("size effect", |p| p.lever_arm_m = Matrix3::repeat(0.02)),
    ("bandwidth", |p| p.bandwidth_hz = each(50.0)),
    ("scale factor, misalignment", |p| p.scale_factor = each(1e-4)),
    ("asymmetry", |p| p.scale_factor_asymmetry = each(1e-5)),
    ("nonlinearity, rectification", |p| p.scale_factor_nonlinearity = each(1e-6)),
    ("g-sensitivity", |p| p.g_sensitivity = Matrix3::repeat(1e-8)),
    ("temperature", |p| p.bias_temperature = each(1e-8)),
    ("bias", |p| p.bias = each(1e-6)),
    ("Gauss-Markov bias", |p| (p.markov_sigma, p.markov_time_s) = (each(1e-6), each(100.0))),
    ("flicker", |p| p.flicker = each(1e-7)),
    ("rate random walk", |p| p.rate_random_walk = each(1e-9)),
    ("ramp", |p| p.ramp = each(1e-10)),
    ("random walk", |p| p.random_walk = each(1e-6)),
    ("dead zone", |p| p.dead_zone = each(1e-7)),
    ("range", |p| p.range = each(100.0)),
    ("quantization", |p| p.quantization = each(1e-6)),
];

const ALTIMETER_EFFECTS: [(&str, AltimeterParameters); 4] = [
    ("altimeter: bias, scale factor", AltimeterParameters { bias_m: 5.0, ..NO_ERRORS }),
    ("altimeter: lag", AltimeterParameters { lag_s: 0.5, ..NO_ERRORS }),
    (
        "altimeter: Gauss-Markov error",
        AltimeterParameters { markov_sigma_m: 3.0, markov_time_s: 60.0, ..NO_ERRORS },
    ),
    ("altimeter: noise", AltimeterParameters { noise_m: 1.0, ..NO_ERRORS }),
];

/// Failures of the x gyro.
const FAILURES: [(&str, Failure); 3] = [
    ("failure: bias step", Failure::BiasStep { size: 1e-6 }),
    ("failure: noise", Failure::Noise { density: 1e-6 }),
    ("failure: stuck", Failure::Stuck),
];

const NO_ERRORS: AltimeterParameters = AltimeterParameters {
    bias_m: 0.0,
    markov_sigma_m: 0.0,
    markov_time_s: 0.0,
    noise_m: 0.0,
    scale_factor: 0.0,
    lag_s: 0.0,
};

/// The name of a simulator without errors.
const NONE: &str = "none";

fn each(value: f64) -> Vector3<f64> {
    Vector3::repeat(value)
}

/// A simulator with one effect.
struct Scene {
    name: String,
    simulator: Simulator,
    /// Failure that is set again after each reset, which clears it.
    failure: Option<Failure>,
}

fn scene(name: String, set: impl FnOnce(&mut Simulator) -> Result<(), sins::Error>) -> Option<Scene> {
    let intake = IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() };
    let mut simulator = Simulator::new(&Options { intake, ..Default::default() }).ok()?;
    // An effect that this kind of sensor does not have is refused.
    set(&mut simulator).ok()?;
    Some(Scene { name, simulator, failure: None })
}

fn scenes() -> Vec<Scene> {
    let parameters = |set: Setting| {
        let mut parameters = TriadParameters::default();
        set(&mut parameters);
        parameters
    };
    let gyro = |&(name, set): &(&str, Setting)| {
        scene(format!("gyro {name}"), |simulator| simulator.set_gyro(&parameters(set)))
    };
    let accel = |&(name, set): &(&str, Setting)| {
        scene(format!("accel {name}"), |simulator| simulator.set_accel(&parameters(set)))
    };
    let altimeter = |&(name, parameters): &(&str, AltimeterParameters)| {
        scene(name.to_owned(), |simulator| simulator.set_altimeter(&parameters))
    };
    let failing = |&(name, failure): &(&str, Failure)| {
        scene(name.to_owned(), |_| Ok(())).map(|scene| Scene { failure: Some(failure), ..scene })
    };
    let none = scene(NONE.to_owned(), |_| Ok(()));
    none.into_iter()
        .chain(TRIAD_EFFECTS.iter().flat_map(|effect| gyro(effect).into_iter().chain(accel(effect))))
        .chain(ALTIMETER_EFFECTS.iter().filter_map(altimeter))
        .chain(FAILURES.iter().filter_map(failing))
        .collect()
}

/// Flies `samples` from the start; returns the time.
fn fly(Scene { simulator, failure, .. }: &mut Scene, samples: &[FlightSample]) -> Option<Duration> {
    simulator.reset();
    simulator.set_failure(SensorOutput::Gyro(Axis::X), *failure).ok()?;
    let start = Instant::now();
    for sample in samples {
        simulator.push_sample(sample).ok()?;
        simulator.step().ok()?;
    }
    Some(start.elapsed())
}

/// Samples with a temperature.
fn warm(count: usize) -> Vec<FlightSample> {
    let patrol = scene::patrol(count).into_iter();
    patrol.map(|sample| FlightSample { temperature_c: Some(20.0), ..sample }).collect()
}

/// The table of the instructions `counted` and of the times.
fn table(counted: &BTreeMap<&str, i64>) -> Option<()> {
    let samples = warm(TIMED_STEPS);
    let mut plain = scene(NONE.to_owned(), |_| Ok(()))?;
    let mut shortest = Duration::MAX;
    let mut ratios: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for _ in 0..TURNS {
        for scene in &mut scenes() {
            let before = fly(&mut plain, &samples)?;
            let time = fly(scene, &samples)?;
            shortest = shortest.min(before);
            ratios.entry(scene.name.clone()).or_default().push(time.as_secs_f64() / before.as_secs_f64());
        }
    }
    ratios.values_mut().for_each(|ratios| ratios.sort_by(f64::total_cmp));
    let plain_ns = shortest.as_nanos() as f64 / TIMED_STEPS as f64;
    let ns = |name: &str| ratios.get(name).map(|ratios| (ratios[TURNS / 2] - 1.0) * plain_ns);
    let cell = |name: &str| {
        let instructions = counted.get(name)? - counted.get(NONE)?;
        Some(format!("{instructions} | {:.0}", ns(name)?))
    };
    let or_blank = |name: &str| cell(name).unwrap_or_else(|| "|".to_owned());
    println!("| effect | gyros: instructions | ns | accelerometers: instructions | ns |");
    println!("|---|---|---|---|---|");
    for (name, _) in TRIAD_EFFECTS {
        println!(
            "| {name} | {} | {} |",
            or_blank(&format!("gyro {name}")),
            or_blank(&format!("accel {name}"))
        );
    }
    let others = ALTIMETER_EFFECTS.map(|(name, _)| name).into_iter().chain(FAILURES.map(|(name, _)| name));
    for name in others {
        println!("| {name} | {} | | |", cell(name)?);
    }
    println!("\nA step without errors: {} instructions, {:.0} ns.", counted.get(NONE)?, plain_ns);
    Some(())
}

fn run(arguments: &[&str]) -> Option<()> {
    match arguments {
        ["names"] => scenes().iter().for_each(|scene| println!("{}", scene.name)),
        ["fly", name, count] => {
            let samples = warm(SAMPLES);
            let count: usize = count.parse().ok()?;
            let mut scene = scenes().into_iter().find(|scene| scene.name == *name)?;
            fly(&mut scene, samples.get(..count)?)?;
        }
        ["table", file] => {
            let text = std::fs::read_to_string(file).ok()?;
            let counted = text.lines().map(|line| {
                line.rsplit_once(';').and_then(|(name, count)| Some((name, count.parse().ok()?)))
            });
            table(&counted.collect::<Option<_>>()?)?;
        }
        _ => return None,
    }
    Some(())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match run(&arguments) {
        Some(()) => ExitCode::SUCCESS,
        None => {
            eprintln!("usage: effects names|fly NAME COUNT|table FILE");
            ExitCode::from(2)
        }
    }
}
