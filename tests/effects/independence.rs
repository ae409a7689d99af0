//! No effect changes another one: if an effect is missing, or is switched off, on or to other values in flight, all others
//! continue bit for bit, with the same draws.
//!
//! A triad adds its effects in a fixed order, so its output can be composed to the bit from triads that have one effect each:
//! the effects of the signal act on it first, each additive effect is computed alone without a signal, and the effects of the
//! output act on the sum. A triad with one effect knows nothing of the others.

use nalgebra::{Matrix3, Vector3};
use sins::mechanization::VerticalMode;
use sins::sensors::{
    Altimeter, AltimeterParameters, EffectPlace, InitialErrorParameters, PARAMETERS, Parameter, Sensor,
    StreamKey, Triad, TriadParameters,
};
use sins::signal::Increment;
use sins::{Options, Simulator};

use EffectPlace::{Added, OfOutput, OfSignal};

use crate::support::{one_unit_of, one_unit_of_each, options_at, patrol};

const KEY: StreamKey = StreamKey { seed: 20140601, run: 3 };

/// Rows of the table whose parameters are one effect each, except for temperature: `temperature.rs` tests it.
fn effects() -> impl Iterator<Item = usize> {
    let has_effect = |row: &usize| {
        let Parameter { name, gyro, accel, .. } = &PARAMETERS[*row];
        !name.contains("temperature") && gyro.or(*accel).is_some_and(|field| !field.effect.is_empty())
    };
    (0..PARAMETERS.len()).filter(has_effect)
}

/// Where the effect of a row acts. The bias and the one that is drawn are one constant.
fn group(effect: usize) -> EffectPlace {
    let row = &PARAMETERS[effect];
    let sensor = if row.gyro.is_some() { Sensor::Gyro } else { Sensor::Accelerometer };
    let mut triad = Triad::new(KEY, sensor);
    triad.set(&one_unit_of(sensor, 1.0, |other| other.name == row.name || other.is_time_of(row.name)));
    let places: Vec<EffectPlace> = triad.effect_places().collect();
    assert_eq!(places.len(), 1, "{}", row.name);
    places[0]
}

/// Copies the parameters of one effect.
fn take(effect: usize, from: &TriadParameters, to: &mut TriadParameters) {
    for ((parameter, from), to) in PARAMETERS.iter().zip(from.numbers()).zip(to.numbers_mut()) {
        if parameter.name == PARAMETERS[effect].name || parameter.is_time_of(PARAMETERS[effect].name) {
            to.copy_from_slice(from);
        }
    }
}

/// All effects of a sensor times `scale`, except for temperature and failures: `temperature.rs` and `failures.rs` test them.
fn everything(sensor: Sensor, scale: f64) -> TriadParameters {
    let each = |x: f64, y: f64, z: f64| Vector3::new(x, y, z) * scale;
    let matrix = Matrix3::new(1.0, 2.0, -3.0, 4.0, -5.0, 6.0, 7.0, -8.0, 9.0) * scale;
    let mut misalignment = matrix * 1e-5;
    misalignment.fill_diagonal(0.0);
    let parameters = TriadParameters {
        bias: each(1e-3, -2e-3, 3e-3),
        bias_sigma: each(1e-3, 1e-3, 2e-3),
        markov_sigma: each(2e-3, 1e-3, 3e-3),
        markov_time_s: each(100.0, 1.0, 0.01),
        random_walk: each(1e-4, 2e-4, 3e-4),
        rate_random_walk: each(1e-4, 3e-4, 2e-4),
        ramp: each(1e-4, -1e-4, 3e-4),
        flicker: each(1e-3, 2e-3, 1e-3),
        quantization: each(1e-5, 2e-5, 3e-5),
        scale_factor: each(1e-3, -1e-3, 2e-3),
        scale_factor_asymmetry: each(1e-3, 2e-3, -1e-3),
        scale_factor_nonlinearity: each(1e-3, -2e-3, 1e-3),
        misalignment,
        range: each(0.9, 1.5, 8.0),
        bandwidth_hz: each(30.0, 20.0, 10.0),
        dead_zone: each(1e-2, 2e-2, 1e-2),
        scale_factor_sigma: each(1e-3, 2e-3, 1e-3),
        misalignment_sigma: misalignment.abs(),
        ..one_unit_of_each(sensor, scale)
    };
    let parameters = match sensor {
        Sensor::Gyro => TriadParameters { g_sensitivity: matrix * 1e-5, ..parameters },
        Sensor::Accelerometer => TriadParameters {
            lever_arm_m: matrix * 1e-2,
            vibration_rectification_s2_m: each(1e-4, 2e-4, 3e-4),
            ..parameters
        },
    };
    parameters.validate(sensor).unwrap();
    parameters
}

/// The parameters of the effects of `group` alone.
fn of_group(parameters: &TriadParameters, group: EffectPlace) -> TriadParameters {
    let mut part = TriadParameters::default();
    effects()
        .filter(|effect| self::group(*effect) == group)
        .for_each(|effect| take(effect, parameters, &mut part));
    part
}

fn without(parameters: &TriadParameters, effect: usize) -> TriadParameters {
    let mut rest = *parameters;
    take(effect, &TriadParameters::default(), &mut rest);
    rest
}

/// A triad composed of triads that share nothing.
struct Parts {
    sensor: Sensor,
    of_the_signal: Triad,
    additive: Vec<Triad>,
    of_the_output: Triad,
}

impl Parts {
    fn new(sensor: Sensor) -> Self {
        let triad = || Triad::new(KEY, sensor);
        let is_added = |effect: &usize| matches!(group(*effect), Added(_));
        let additive = effects().filter(is_added).map(|_| triad()).collect();
        Self { sensor, of_the_signal: triad(), additive, of_the_output: triad() }
    }

    /// Sets only the parts whose parameters change.
    fn set(&mut self, from: &TriadParameters, to: &TriadParameters) {
        let set = |triad: &mut Triad, group: EffectPlace| {
            if of_group(from, group) != of_group(to, group) {
                triad.set(&of_group(to, group));
            }
        };
        set(&mut self.of_the_signal, OfSignal);
        self.additive.iter_mut().enumerate().for_each(|(index, triad)| set(triad, Added(index)));
        set(&mut self.of_the_output, OfOutput);
    }

    fn sense(&mut self, ideal: &Increment, dt: f64) -> Vector3<f64> {
        let sensed = self.of_the_signal.sense(ideal, dt);
        let sum = self.additive.iter_mut().fold(sensed, |sum, triad| sum + triad.sense(&Increment::ZERO, dt));
        let sum = match self.sensor {
            Sensor::Gyro => Increment { angle: sum, ..Increment::ZERO },
            Sensor::Accelerometer => Increment { velocity: sum, ..Increment::ZERO },
        };
        self.of_the_output.sense(&sum, dt)
    }
}

/// A signal that is mostly within the range and sometimes within the dead zone, and the length of its increment [s].
fn signal(step: usize) -> (Increment, f64) {
    let t = step as f64;
    let rates = Vector3::new((0.3 * t).sin(), (0.7 * t).cos(), (0.11 * t).sin() * 2.0);
    let forces = Vector3::new((0.2 * t).cos() * 1.5, (0.5 * t).sin(), 6.0 + (0.13 * t).cos() * 4.0);
    let dt = [0.01, 0.006, 0.013][step / 40 % 3];
    (Increment { angle: rates * dt, velocity: forces * dt }, dt)
}

/// Runs a triad and its parts through a sequence of parameters, each for the given number of steps, and compares their bits.
fn compare(name: &str, sensor: Sensor, sequence: &[(TriadParameters, usize)]) {
    let (mut whole, mut parts) = (Triad::new(KEY, sensor), Parts::new(sensor));
    let (mut before, mut step) = (TriadParameters::default(), 0);
    for (parameters, steps) in sequence {
        parts.set(&before, parameters);
        whole.set(parameters);
        before = *parameters;
        for _ in 0..*steps {
            let (ideal, dt) = signal(step);
            assert_eq!(whole.sense(&ideal, dt), parts.sense(&ideal, dt), "{sensor:?}, {name}, step {step}");
            step += 1;
        }
    }
}

fn each_effect(test: impl Fn(&str, Sensor, usize)) {
    for sensor in [Sensor::Gyro, Sensor::Accelerometer] {
        for effect in effects().filter(|effect| PARAMETERS[*effect].of(sensor).is_some()) {
            assert_ne!(without(&everything(sensor, 1.0), effect), everything(sensor, 1.0));
            test(PARAMETERS[effect].name, sensor, effect);
        }
    }
}

#[test]
fn a_missing_effect_leaves_all_others() {
    each_effect(|name, sensor, effect| {
        compare(name, sensor, &[(without(&everything(sensor, 1.0), effect), 300)]);
    });
}

#[test]
fn an_effect_switched_off_on_and_over_in_flight_leaves_all_others() {
    each_effect(|name, sensor, effect| {
        let on = everything(sensor, 1.0);
        let off = without(&on, effect);
        let mut other = on;
        take(effect, &everything(sensor, 0.7), &mut other);
        compare(name, sensor, &[(on, 50), (off, 60), (on, 70), (other, 50), (off, 1), (other, 50)]);
    });
}

/// The comparison detects each effect, also with one data-sheet unit of it: a triad with the effect gives something else than a triad
/// without it. Pulses and a dead zone would hide small effects behind them.
#[test]
fn each_effect_shows() {
    each_effect(|name, sensor, effect| {
        let hides = |name: &str| ["quantization", "dead_zone"].contains(&name);
        let mut everything = everything(sensor, 1.0);
        for other in effects().filter(|other| hides(PARAMETERS[*other].name) && *other != effect) {
            everything = without(&everything, other);
        }
        if !hides(name) {
            take(effect, &one_unit_of_each(sensor, 1.0), &mut everything);
        }
        let mut triads = [everything, without(&everything, effect)].map(|parameters| {
            let mut triad = Triad::new(KEY, sensor);
            triad.set(&parameters);
            triad
        });
        let differs = (0..300).any(|step| {
            let (ideal, dt) = signal(step);
            let [with, without] = triads.each_mut().map(|triad| triad.sense(&ideal, dt));
            with != without
        });
        assert!(differs, "{sensor:?}, {name}");
    });
}

/// The altimeter's effects: those of the height without the random ones, then each of the two random ones at zero height.
#[test]
fn the_altimeter_likewise() {
    let all = AltimeterParameters {
        bias_m: 5.0,
        markov_sigma_m: 3.0,
        markov_time_s: 2.0,
        noise_m: 1.0,
        scale_factor: 1e-3,
        lag_s: 0.5,
    };
    let zero = AltimeterParameters::default();
    let offs: [fn(&mut AltimeterParameters); 5] = [
        |p| p.bias_m = 0.0,
        |p| p.markov_sigma_m = 0.0,
        |p| p.noise_m = 0.0,
        |p| p.scale_factor = 0.0,
        |p| p.lag_s = 0.0,
    ];
    for (index, switch_off) in offs.iter().enumerate() {
        let mut off = all;
        switch_off(&mut off);
        for sequence in [vec![off], vec![all, off, all, off]] {
            let mut whole = Altimeter::new(KEY, 0.0);
            let mut parts = [(); 3].map(|()| Altimeter::new(KEY, 0.0));
            for (turn, p) in sequence.iter().enumerate() {
                whole.set(p);
                let AltimeterParameters { markov_sigma_m, markov_time_s, noise_m, .. } = *p;
                parts[0].set(&AltimeterParameters { markov_sigma_m: 0.0, noise_m: 0.0, ..*p });
                parts[1].set(&AltimeterParameters { markov_sigma_m, markov_time_s, ..zero });
                parts[2].set(&AltimeterParameters { noise_m, ..zero });
                for step in 0..50 {
                    let height = 100.0 * (0.1 * f64::from(step)).sin();
                    let shown = |altimeter: &mut Altimeter, height| altimeter.sense(height, 0.1).unwrap();
                    let [of_the_height, markov, noise] = &mut parts;
                    let parts = shown(of_the_height, height) + shown(markov, 0.0) + shown(noise, 0.0);
                    assert_eq!(shown(&mut whole, height), parts, "{index}, {turn}, {step}");
                }
            }
        }
    }
}

/// The drawn part of each initial error is the same whether the others are drawn, given or absent.
#[test]
fn initial_errors_likewise() {
    let (given, sigma) = (Vector3::new(1.0, -2.0, 3.0), Vector3::new(3.0, 2.0, 1.0) * 0.1);
    let all = InitialErrorParameters {
        position_n: given,
        velocity_n: given,
        misalignment_n: given,
        position_sigma_n: sigma,
        velocity_sigma_n: sigma,
        misalignment_sigma_n: sigma,
        ..Default::default()
    };
    let zero = InitialErrorParameters::default();
    let drawn = all.draw(KEY);
    let position = InitialErrorParameters { position_n: given, position_sigma_n: sigma, ..zero }.draw(KEY);
    let velocity = InitialErrorParameters { velocity_n: given, velocity_sigma_n: sigma, ..zero }.draw(KEY);
    let misalignment =
        InitialErrorParameters { misalignment_n: given, misalignment_sigma_n: sigma, ..zero }.draw(KEY);
    assert_eq!(drawn.position_n, position.position_n);
    assert_eq!(drawn.velocity_n, velocity.velocity_n);
    assert_eq!(drawn.misalignment_n, misalignment.misalignment_n);
    assert!(drawn.position_n != given && drawn.velocity_n != given && drawn.misalignment_n != given);
    assert_eq!(position.velocity_n, Vector3::zeros());
    // One axis alone.
    let one = InitialErrorParameters { position_sigma_n: Vector3::y() * sigma.y, ..zero }.draw(KEY);
    let two = InitialErrorParameters { position_sigma_n: Vector3::new(9.0, sigma.y, 0.0), ..zero }.draw(KEY);
    assert_eq!(one.position_n.y, two.position_n.y);
}

/// Gyros and accelerometers of a simulator measure the same, whatever is set in the other blocks before or during the flight.
#[test]
fn the_blocks_of_a_simulator_likewise() {
    let flight = patrol(100.0);
    let samples: Vec<_> = (0..150).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()).collect();
    let set = |simulator: &mut Simulator, sensor: Sensor, scale: f64| {
        // At its limit an accelerometer would show only the limit.
        let parameters = TriadParameters { range: Vector3::zeros(), ..everything(sensor, scale) };
        match sensor {
            Sensor::Gyro => simulator.set_gyro(&parameters).unwrap(),
            Sensor::Accelerometer => simulator.set_accel(&parameters).unwrap(),
        }
    };
    let options = Options { key: KEY, vertical: VerticalMode::Damped, ..options_at(100.0) };
    let set_altimeter = |simulator: &mut Simulator, noise_m: f64| {
        simulator
            .set_altimeter(&AltimeterParameters { noise_m, lag_s: noise_m, ..Default::default() })
            .unwrap();
    };
    for (sensor, other) in [(Sensor::Gyro, Sensor::Accelerometer), (Sensor::Accelerometer, Sensor::Gyro)] {
        // How large the other blocks' errors are: before the flight, then at each third of it.
        let measured = |scales: [f64; 3]| -> Vec<Vector3<f64>> {
            let mut simulator = Simulator::new(&options).unwrap();
            set(&mut simulator, sensor, 0.1);
            let initial =
                InitialErrorParameters { position_sigma_n: Vector3::repeat(scales[0]), ..Default::default() };
            simulator.set_initial_errors(&initial).unwrap();
            let mut measured = Vec::new();
            for (k, sample) in samples.iter().enumerate() {
                if k % 50 == 0 {
                    set(&mut simulator, other, scales[k / 50]);
                    set_altimeter(&mut simulator, scales[k / 50]);
                }
                simulator.push_sample(sample).unwrap();
                simulator.step().unwrap();
                measured.extend(simulator.imu().map(|imu| match sensor {
                    Sensor::Gyro => imu.measured.angle,
                    Sensor::Accelerometer => imu.measured.velocity,
                }));
            }
            measured
        };
        let alone = measured([0.0; 3]);
        assert_eq!(alone.len(), samples.len() - 1);
        for scales in [[0.1; 3], [0.1, 0.0, 0.1], [0.0, 0.1, 0.2]] {
            assert_eq!(measured(scales), alone, "{sensor:?}, {scales:?}");
        }
    }
}
