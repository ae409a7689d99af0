//! Times of each stage and of the whole chain: `cargo bench --manifest-path benches/Cargo.toml`.
//!
//! Compare figures only within one run: the speed of the machine differs between runs.

#[path = "src/c_scene.rs"]
mod c_scene;
#[path = "src/scene.rs"]
mod scene;

use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use sins::abi::*;
use sins::earth::Earth;
use sins::earth::state::{BodyAxes, StateErrors};
use sins::errors::{ErrorModel, SensorErrors};
use sins::mechanization::{Frame, Mechanization, Scheme, VerticalAid};
use sins::sensors::{Sensor, StreamKey, Triad, paper_simulation2};
use sins::signal::{Increment, SignalGenerator};
use sins::truth::{FlightSample, Intake, IntakeLimits, Recent, TruthPoint};

const STEPS: usize = 1000;

fn limits() -> IntakeLimits {
    IntakeLimits { period_s: Some(scene::PERIOD_S), ..Default::default() }
}

fn points(samples: &[FlightSample]) -> Vec<TruthPoint> {
    let mut intake = Intake::new(Earth::default(), BodyAxes::default(), limits()).unwrap();
    let mut points = Vec::new();
    for sample in samples {
        intake.push(sample).unwrap();
        intake.take();
        points.extend(intake.current().copied());
    }
    points
}

fn recent(points: &[TruthPoint], k: usize) -> Recent<'_> {
    Recent { next: &points[k], current: &points[k - 1], before: [Some(&points[k - 2]), Some(&points[k - 3])] }
}

/// One step of each stage of the chain.
fn stages(criterion: &mut Criterion) {
    let earth = Earth::default();
    let samples = scene::patrol(STEPS + 3);
    let points = points(&samples);
    let mut group = criterion.benchmark_group("stage");
    group.throughput(Throughput::Elements(STEPS as u64));

    group.bench_function("intake", |bencher| {
        bencher.iter_batched_ref(
            || Intake::new(earth, BodyAxes::default(), limits()).unwrap(),
            |intake| {
                for sample in &samples[..STEPS] {
                    intake.push(black_box(sample)).unwrap();
                    intake.take();
                }
            },
            BatchSize::SmallInput,
        );
    });

    let mut increments = [[Increment::ZERO; 2]; STEPS];
    group.bench_function("signal generator", |bencher| {
        bencher.iter(|| {
            let mut generator = SignalGenerator::new(earth.rate_rad_s);
            for k in 3..STEPS + 3 {
                generator.advance(&recent(&points, k)).integrate(&mut increments[k - 3]);
            }
            black_box(&increments);
        });
    });

    let (gyro, accel) = paper_simulation2();
    let mut noisy = increments;
    group.bench_function("sensors of simulation 2", |bencher| {
        let mut triads =
            [Sensor::Gyro, Sensor::Accelerometer].map(|sensor| Triad::new(StreamKey::default(), sensor));
        triads[0].set(&gyro);
        triads[1].set(&accel);
        bencher.iter(|| {
            for (noisy, ideal) in noisy.as_flattened_mut().iter_mut().zip(increments.as_flattened()) {
                noisy.angle = triads[0].sense(ideal, 0.5 * scene::PERIOD_S);
                noisy.velocity = triads[1].sense(ideal, 0.5 * scene::PERIOD_S);
            }
            black_box(&noisy);
        });
    });

    for (name, frame, scheme) in [
        ("mechanization, exact, Earth-fixed", Frame::EarthFixed, Scheme::Exact),
        ("mechanization, exact, geographic", Frame::Geographic, Scheme::Exact),
        ("mechanization, paper, geographic", Frame::Geographic, Scheme::Paper),
        ("mechanization, polynomial, Earth-fixed", Frame::EarthFixed, Scheme::Polynomial),
    ] {
        group.bench_function(name, |bencher| {
            bencher.iter_batched_ref(
                || Mechanization::new(earth, frame, scheme, &points[2].state),
                |mechanization| {
                    for pair in &increments {
                        mechanization.update(black_box(pair), scene::PERIOD_S);
                    }
                },
                BatchSize::SmallInput,
            );
        });
    }

    group.bench_function("barometric loop", |bencher| {
        bencher.iter_batched_ref(
            || Mechanization::new(earth, Frame::EarthFixed, Scheme::Exact, &points[2].state),
            |mechanization| {
                for _ in 0..STEPS {
                    mechanization.aid_vertical(
                        black_box(&VerticalAid::Barometer { height_m: 8000.0 }),
                        scene::PERIOD_S,
                    );
                }
            },
            BatchSize::SmallInput,
        );
    });

    for (name, frame) in
        [("error model, Earth-fixed", Frame::EarthFixed), ("error model, geographic", Frame::Geographic)]
    {
        let zero = Vector3::zeros();
        let start = StateErrors { position_n: zero, velocity_n: zero, misalignment_n: zero };
        let small = Vector3::repeat(1e-8);
        let errors =
            SensorErrors { gyro_b: small, accel_b: small, gyro_change_b: small, accel_change_b: small };
        let motion = SignalGenerator::new(earth.rate_rad_s).advance(&recent(&points, 3));
        group.bench_function(name, |bencher| {
            let mut model =
                ErrorModel::new(earth, frame, &points[2].vertical(), &points[2].state.v_e, &start);
            bencher.iter(|| {
                for _ in 0..STEPS {
                    model.advance(
                        black_box(&motion),
                        &points[3],
                        &errors,
                        &VerticalAid::Barometer { height_m: 8000.0 },
                        None,
                    );
                }
            });
        });
    }
    group.finish();
}

/// The whole chain through the C interface with simulation 2's errors and both error data, and the cost of each of these.
fn chain(criterion: &mut Criterion) {
    let samples = c_scene::c_samples(&scene::patrol(STEPS + 1));
    let full = c_scene::c_options();
    let mut group = criterion.benchmark_group("chain");
    group.throughput(Throughput::Elements(STEPS as u64));
    let off = SINS_ERROR_MODEL_OFF;
    for (name, options, noisy) in [
        ("sins_run, simulation 2, both error data", full, true),
        ("sins_run, simulation 2, error data 2", sins_options { error_model: off, ..full }, true),
        ("sins_run, ideal sensors, error data 2", sins_options { error_model: off, ..full }, false),
        (
            "sins_run, ideal sensors, free vertical channel",
            sins_options { error_model: off, vertical: SINS_VERTICAL_FREE, ..full },
            false,
        ),
    ] {
        let sim = c_scene::simulator(&options, noisy);
        group.bench_function(name, |bencher| {
            // SAFETY: a valid handle.
            bencher.iter(|| unsafe {
                assert_eq!(sins_reset(sim), SINS_OK);
                c_scene::run(sim, &samples);
            });
        });
        // SAFETY: a valid handle.
        unsafe { sins_destroy(sim) };
    }

    let sim = c_scene::simulator(&full, true);
    group.bench_function("push, step, read navigation and both errors", |bencher| {
        // SAFETY: a valid handle at the start of a flight.
        bencher.iter(|| unsafe {
            assert_eq!(sins_reset(sim), SINS_OK);
            c_scene::push_step_read(sim, &samples, || ());
        });
    });
    group.finish();

    // Cost of a call without its work: a step without a sample to fly.
    criterion.bench_function("call", |bencher| {
        // SAFETY: a valid handle.
        bencher.iter(|| unsafe { sins_step(black_box(sim)) });
    });
    // SAFETY: a valid handle.
    unsafe { sins_destroy(sim) };
}

criterion_group!(benches, stages, chain);
criterion_main!(benches);
