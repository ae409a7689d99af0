//! Runs as lists of calls, which a test may split at any call. Each uses a simulator in another way; together they use every
//! option and effect.

use nalgebra::Vector3;
use sins::Options;
use sins::earth::state::{BodyAxes, Navigation};
use sins::earth::{Ellipsoid, GravityModel};
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    Axis, Failure, GravityDisturbanceParameters, GravityField, InitialErrorParameters, SensorOutput,
    StreamKey, TriadParameters,
};
use sins::signal::Increment;
use sins::signal::mounting::MountingParameters;
use sins::truth::{FlightSample, IntakeLimits};

use super::moments::{Call, altimeter, every_effect, flown, loops, samples, setting};
use super::{options_at, resting_sample};

/// A host's run.
pub struct Run {
    pub name: &'static str,
    pub options: Options,
    pub calls: Vec<Call>,
    /// A snapshot is taken after every `every` calls.
    pub every: usize,
}

/// Options that all differ from their defaults.
pub fn unusual_options() -> Options {
    Options {
        frame: Frame::Geographic,
        scheme: Scheme::Polynomial,
        subsamples: 3,
        updates_per_sample: 2,
        vertical: VerticalMode::FollowTruth,
        error_model: true,
        ellipsoid: Ellipsoid::Krassovsky1940,
        gravity: GravityModel::Somigliana,
        axes: BodyAxes::ForwardRightDown,
        closed_loop_time_s: Some(20.0),
        key: StreamKey { seed: u64::MAX, run: 3 },
        intake: IntakeLimits { max_gap_s: 3.0, max_acceleration_m_s2: 1500.0, period_s: Some(0.01) },
        truth_summary: true,
        covariance: true,
    }
}

/// The run with every option and effect and with signals of the host.
pub fn largest() -> Run {
    let mut calls = setting();
    calls.extend(flown(loops(30, true)));
    Run { name: "largest", options: unusual_options(), calls, every: 1 }
}

pub fn runs() -> Vec<Run> {
    let model = Options { error_model: true, ..Options::default() };
    let mut runs = vec![
        Run {
            name: "at rest",
            options: Options::default(),
            calls: flown((0..25).map(|k| resting_sample(f64::from(k) * 0.02))),
            every: 1,
        },
        Run {
            name: "loops without an error",
            options: options_at(100.0),
            calls: flown(loops(30, false)),
            every: 1,
        },
        largest(),
    ];

    // Intervals of 0.5 s, until after the window of the radial error rate, with every effect and the default options.
    let mut calls = setting();
    calls.extend(flown(samples(700, 0.5)));
    runs.push(Run { name: "every effect for minutes", options: model, calls, every: 101 });

    // Samples are lost soon after the start, and soon after each other: a gap is recognised from the intervals before it.
    let lost = [2..5, 20..30, 33..36, 37..60];
    let kept = (0..70).zip(samples(70, 0.01)).filter(|(k, _)| !lost.iter().any(|range| range.contains(k)));
    let mut calls = setting();
    calls.extend(flown(kept.map(|(_, sample)| sample)));
    runs.push(Run { name: "gaps", options: model, calls, every: 1 });

    // The paper's scheme, free vertical channel, no velocities, uneven stamps.
    let uneven = samples(60, 0.01).enumerate().map(|(k, mut sample)| {
        sample.time_s += 0.002 * ((k * 37 % 7) as f64 / 7.0);
        FlightSample { v_n: None, ..sample }
    });
    let options = Options { scheme: Scheme::Paper, vertical: VerticalMode::Free, ..model };
    runs.push(Run { name: "positions alone", options, calls: flown(uneven), every: 1 });

    // The first sensor error is set in flight, and the closed loop's own navigator separates from the INS. Effects are
    // removed and set again.
    let (gyro, accel) = every_effect();
    let mut calls = flown(samples(50, 0.01));
    calls.insert(70, Call::Gyro(TriadParameters::default()));
    calls.insert(60, Call::Altimeter(altimeter()));
    calls.insert(50, Call::Accel(accel));
    calls.insert(40, Call::Gyro(gyro));
    calls.insert(90, Call::Gyro(gyro));
    let options = Options { closed_loop_time_s: Some(30.0), ..model };
    runs.push(Run { name: "sensors that change", options, calls, every: 1 });

    // Samples in bursts: the queue is full, and one sample is too many.
    let mut calls = setting();
    for burst in samples(51, 0.01).collect::<Vec<_>>().chunks(17) {
        calls.extend(burst.iter().map(|sample| Call::Push(*sample)));
        calls.extend((0..18).map(|_| Call::Step));
    }
    runs.push(Run {
        name: "bursts",
        options: Options { frame: Frame::Geographic, ..model },
        calls,
        every: 1,
    });

    // A reposition, a rejected call and a reset, with samples in the queue.
    let mut calls = setting();
    calls.extend(flown(samples(15, 0.01)));
    let elsewhere: Vec<FlightSample> = loops(20, true).collect();
    calls.push(Call::Push(elsewhere[0]));
    calls.push(Call::Reposition(elsewhere[0]));
    calls.push(Call::Initial(InitialErrorParameters::default()));
    calls.extend(flown(elsewhere.into_iter().skip(1)));
    calls.push(Call::Reset);
    calls.extend(flown(samples(15, 0.01)));
    runs.push(Run { name: "slewed and reset", options: model, calls, every: 1 });

    // Slews and pauses in flight, which keep the errors: with samples in the queue, twice in a row, and without velocities.
    for (name, options) in [
        ("moved", Options { truth_summary: true, ..model }),
        ("moved, periods stated", Options { closed_loop_time_s: Some(20.0), ..unusual_options() }),
    ] {
        let mut calls = setting();
        calls.extend(flown(samples(15, 0.01)));
        let elsewhere: Vec<FlightSample> = loops(40, false).collect();
        let later = |sample: &FlightSample| FlightSample { time_s: sample.time_s + 1e6, ..*sample };
        calls.push(Call::Push(samples(16, 0.01).last().unwrap()));
        calls.push(Call::MoveTime(1.7e9));
        calls.push(Call::MoveTruth(elsewhere[0]));
        calls.push(Call::MoveTruth(elsewhere[0]));
        calls.extend(flown(elsewhere[1..10].iter().copied()));
        calls.push(Call::Push(elsewhere[10]));
        calls.push(Call::Push(elsewhere[11]));
        calls.push(Call::MoveTime(elsewhere[11].time_s + 1e6));
        calls.extend(flown(elsewhere[12..30].iter().map(later)));
        calls.push(Call::MoveTruth(FlightSample { v_n: None, ..elsewhere[30] }));
        calls.extend(flown(elsewhere[31..].iter().map(|sample| FlightSample { v_n: None, ..*sample })));
        runs.push(Run { name, options, calls, every: 1 });
    }

    for (name, closed_loop_time_s) in
        [("a troubled block", None), ("a troubled block in a closed loop", Some(30.0))]
    {
        runs.push(Run {
            name,
            options: Options { closed_loop_time_s, ..model },
            calls: troubled_block(),
            every: 1,
        });
    }

    // Navigation from increments, without a truth.
    let (gyro, accel) = every_effect();
    let place = samples(1, 0.01).next().unwrap();
    let navigation = Navigation::new(
        place.place,
        place.v_n.unwrap(),
        sins::math::attitude_from_euler(&place.euler),
        BodyAxes::default(),
    );
    let mut calls = vec![Call::Gyro(gyro), Call::Accel(accel), Call::Start(-5.0, Box::new(navigation))];
    calls.extend((0..30).map(|k| {
        let increment =
            Increment { angle: Vector3::new(1e-3, 2e-4, -1e-3), velocity: Vector3::new(0.01, 0.0, 0.0981) };
        Call::Imu(vec![increment; 1 + k % 5], 0.01)
    }));
    calls.push(Call::Reset);
    calls.extend(flown(samples(5, 0.01)));
    runs.push(Run { name: "navigator alone", options: Options::default(), calls, every: 1 });
    runs
}

/// Temperature coefficients, an IMU block away from the reference point, and disturbed gravity.
fn troubles(triad: TriadParameters) -> (TriadParameters, Vec<Call>) {
    let three = |scale: f64| Vector3::new(1.0, -0.7, 0.4) * scale;
    let triad = TriadParameters {
        reference_temperature_c: 20.0,
        bias_temperature: three(1e-6),
        scale_factor_temperature2: three(1e-7),
        ..triad
    };
    let mounting = MountingParameters {
        lever_arm_m: three(2.0),
        boresight: Euler { roll: 0.1, pitch: -0.2, heading: 1.0 },
        lever_arm_error_m: three(0.01),
        boresight_error: Euler { roll: 1e-3, pitch: 0.0, heading: -2e-3 },
    };
    let field = GravityField { mean: 2e-5, sigma: 5e-5, distance_m: 30e3 };
    let gravity = GravityDisturbanceParameters {
        deflection_north: field,
        deflection_east: GravityField { sigma: 0.0, ..field },
        anomaly: field,
    };
    (triad, vec![Call::Mounting(mounting), Call::Gravity(gravity)])
}

/// The samples with a temperature that rises at each sample.
fn warming(samples: impl Iterator<Item = FlightSample>) -> impl Iterator<Item = FlightSample> {
    samples
        .enumerate()
        .map(|(k, sample)| FlightSample { temperature_c: Some(15.0 + 0.1 * k as f64), ..sample })
}

/// Everything that can be set at once, with a random failure of each output and the options of the largest snapshot.
pub fn everything_at_once() -> Run {
    let mut calls = setting();
    let (gyro, accel) = every_effect();
    let (gyro, beside) = troubles(gyro);
    calls.extend([Call::Gyro(gyro), Call::Accel(troubles(accel).0)]);
    calls.extend(beside);
    let axes = [Axis::X, Axis::Y, Axis::Z];
    let outputs = axes.map(SensorOutput::Gyro).into_iter().chain(axes.map(SensorOutput::Accelerometer));
    let failure = Some(Failure::Noise { density: 1e-5 });
    calls.extend(outputs.chain([SensorOutput::Altimeter]).map(|output| Call::Failure(output, failure)));
    calls.extend(flown(warming(loops(30, true))));
    Run { name: "everything at once", options: unusual_options(), calls, every: 1 }
}

/// An IMU block away from the reference point in disturbed gravity, with a changing temperature, and failures that begin and end.
fn troubled_block() -> Vec<Call> {
    let (triad, first) = troubles(TriadParameters::default());
    let mut calls = flown(warming(samples(70, 0.01)));
    let outputs = [
        SensorOutput::Gyro(Axis::X),
        SensorOutput::Gyro(Axis::Z),
        SensorOutput::Accelerometer(Axis::Y),
        SensorOutput::Altimeter,
    ];
    let failures = [
        Failure::Noise { density: 1e-5 },
        Failure::Spikes { size: 1e-3, interval_s: 0.05, duration_s: 0.013 },
        Failure::DropOuts { interval_s: 0.0, probability: 0.3 },
        Failure::DropOuts { interval_s: 0.07, probability: 0.0 },
        Failure::Stuck,
        Failure::Dead,
        Failure::BiasStep { size: 1e-4 },
    ];
    for (k, failure) in failures.into_iter().enumerate() {
        calls.insert(25 + 12 * k, Call::Failure(outputs[(k + 1) % 4], None));
        calls.insert(32 + 12 * k, Call::Failure(outputs[k % 4], Some(failure)));
    }
    first.into_iter().chain([Call::Gyro(triad), Call::Accel(triad)]).chain(calls).collect()
}
