//! Each row of the table of sensor parameters, alone: its effect acts on the sensor; it scatters from run to run exactly if the table
//! says so, and then has a covariance; ensembles, snapshots and rejected steps know its state. An effect that is missing in one of
//! these places fails here.

use nalgebra::Vector3;
use sins::ensemble::Ensemble;
use sins::mechanization::VerticalMode;
use sins::sensors::{InitialErrorParameters, PARAMETERS, Parameter, Sensor, StreamKey, TriadParameters};
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, Options, Simulator, Step};

use crate::support::{DEG, one_unit_of};

const RUNS: u64 = 3;

/// The parameter alone, and the correlation time that it needs.
fn alone(parameter: &Parameter, sensor: Sensor, scale: f64) -> TriadParameters {
    one_unit_of(sensor, scale, |row| row.name == parameter.name || row.is_time_of(parameter.name))
}

fn simulator(options: &Options, run: u64, sensor: Sensor, triad: &TriadParameters) -> Simulator {
    let key = StreamKey { run, ..options.key };
    let mut simulator = Simulator::new(&Options { key, ..*options }).unwrap();
    // The solution leaves its limits, at -500 km, after 7 s.
    let falling = InitialErrorParameters {
        position_n: Vector3::new(0.0, 0.0, -433e3),
        velocity_n: Vector3::new(0.0, 0.0, -1e4),
        ..Default::default()
    };
    simulator.set_initial_errors(&falling).unwrap();
    match sensor {
        Sensor::Gyro => simulator.set_gyro(triad).unwrap(),
        Sensor::Accelerometer => simulator.set_accel(triad).unwrap(),
    }
    simulator
}

/// A roll, while the temperature changes.
fn samples() -> Vec<FlightSample> {
    let start =
        FlightStart { latitude_rad: 40.0 * DEG, height_m: 3000.0, speed_m_s: 200.0, ..Default::default() };
    let manoeuvres =
        [Manoeuvre::Straight { duration_s: 2.0 }, Manoeuvre::Roll { duration_s: 8.0, turns: 1.0 }];
    let flight = Flight::new(&start, &manoeuvres).unwrap();
    let sample = |k: u32| {
        let time_s = 0.1 * f64::from(k);
        FlightSample { temperature_c: Some(30.0 + time_s), ..flight.sample_at(time_s).unwrap() }
    };
    (0..=100).map(sample).collect()
}

/// Flies to the step that is rejected, because the solution diverges. Returns what the sensors measured until then.
fn fly(simulator: &mut Simulator, samples: &[FlightSample]) -> Vec<Increment> {
    let mut measured = Vec::new();
    for sample in samples {
        simulator.push_sample(sample).unwrap();
        let before = snapshot(simulator);
        match simulator.step() {
            Ok(Step::Done) => measured.push(simulator.imu().unwrap().measured),
            Ok(Step::NeedSample) => {}
            Err(error) => {
                assert_eq!(error.kind, ErrorKind::Diverged);
                assert!(snapshot(simulator) == before, "a rejected step changed a state");
                return measured;
            }
        }
    }
    unreachable!("the solution falls below its limits")
}

fn snapshot(simulator: &Simulator) -> Vec<u8> {
    let mut bytes = vec![0; simulator.snapshot_size()];
    simulator.save_snapshot(&mut bytes).unwrap();
    bytes
}

#[test]
fn every_parameter_acts_wherever_sensors_are_simulated() {
    let samples = samples();
    let options = Options { vertical: VerticalMode::Free, covariance: true, ..Default::default() };
    let flown = |run: u64, sensor: Sensor, triad: &TriadParameters| {
        let mut simulator = simulator(&options, run, sensor, triad);
        let measured = fly(&mut simulator, &samples);
        (simulator, measured)
    };
    let ideal = flown(0, Sensor::Gyro, &TriadParameters::default()).1;
    assert!((60..90).contains(&ideal.len()), "{} intervals", ideal.len());

    let rows = [Sensor::Gyro, Sensor::Accelerometer]
        .into_iter()
        .flat_map(|sensor| PARAMETERS.iter().map(move |row| (row, sensor)))
        .filter(|(row, sensor)| row.of(*sensor).is_some_and(|field| !field.effect.is_empty()));
    let mut count = 0;
    for (row, sensor) in rows {
        let who = format!("{sensor:?} {}", row.name);
        // One unit of data sheets, or a dead zone and a bandwidth that this flight shows.
        let scales = [1.0, 1e4].map(|scale| alone(row, sensor, scale));
        let triad = scales.iter().filter(|triad| triad.validate(sensor).is_ok());
        let triad = triad.clone().find(|triad| flown(0, sensor, triad).1 != ideal);
        let triad = triad.unwrap_or_else(|| panic!("{who} has no effect"));

        let singles: Vec<_> = (0..RUNS).map(|run| flown(run, sensor, triad).1).collect();
        assert_eq!(singles[1] != singles[0], row.is_random, "{who}: scatters from run to run");

        let mut ensemble = Ensemble::new(&simulator(&options, 0, sensor, triad), 0, RUNS as usize).unwrap();
        for (k, sample) in samples[..=ideal.len()].iter().enumerate() {
            ensemble.push_sample(sample).unwrap();
            ensemble.step().unwrap();
            for run in (0..RUNS).filter(|_| k > 0) {
                let of_run = ensemble.imu(run).unwrap().unwrap().measured;
                assert_eq!(of_run, singles[run as usize][k - 1], "{who}: run {run} of an ensemble");
            }
        }

        let mut first_half = simulator(&options, 0, sensor, triad);
        for sample in &samples[..30] {
            first_half.push_sample(sample).unwrap();
            first_half.step().unwrap();
        }
        let mut loaded = Simulator::new(&Options::default()).unwrap();
        loaded.load_snapshot(&snapshot(&first_half)).unwrap();
        assert_eq!(fly(&mut loaded, &samples[30..]), singles[0][29..], "{who}: from a snapshot");

        let mut single = flown(0, sensor, triad).0;
        let sigma = single.covariance().unwrap().unwrap().1.sigma();
        // The covariance takes the roundings of a quantization for noise.
        let has_covariance = row.is_random || row.name == "quantization";
        assert_eq!(sigma.iter().any(|sigma| *sigma > 0.0), has_covariance, "{who}: covariance {sigma:?}");
        count += 1;
    }
    println!("figure: {count} parameters");
}
