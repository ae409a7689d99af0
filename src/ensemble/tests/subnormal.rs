//! Random parameters so small that a product with a draw is 0 in some runs, and that a square is 0.

use crate::base::error::Error;
use crate::ensemble::Ensemble;
use crate::mechanization::VerticalMode;
use crate::sensors::{PARAMETERS, Sensor, StreamKey};
use crate::signal::RUNS;
use crate::simulator::{ErrorParameters, ErrorSource, Options, Simulator};
use crate::simulator::{rows, with_time};
use crate::truth::FlightSample;
use crate::truth::flight::{Flight, FlightStart, Manoeuvre};

/// The smallest numbers, 1 to 4 units in the last place; and numbers whose squares are 0, or subnormal.
const SIZES: [f64; 7] = [5e-324, 1e-323, 1.5e-323, 2e-323, 1e-310, 1e-162, 1e-157];

/// Two batches, and runs without lanes behind them.
const COUNT: usize = 2 * RUNS + 3;

/// The field of each random parameter of each table.
fn random() -> Vec<&'static str> {
    let of_triad =
        |sensor| PARAMETERS.iter().filter(|row| row.is_random).filter_map(move |row| row.of(sensor));
    let triads = [Sensor::Gyro, Sensor::Accelerometer].into_iter().flat_map(of_triad);
    let fields = triads.chain(rows().filter(|row| row.is_random).map(|row| row.field));
    fields.filter(|field| field.range.needed_by().is_none()).map(|field| field.path).collect()
}

/// Sets a parameter, with a correlation time or distance of 100.
fn set(errors: &mut ErrorParameters, field: &str, size: f64) {
    for path in with_time(field) {
        errors.numbers_of(path).for_each(|number| *number = if path == field { size } else { 100.0 });
    }
    // An off-diagonal parameter is 0 on the diagonal.
    while let Err(Error { field, index: Some(index), .. }) = errors.validate() {
        errors.numbers_of(field).nth(index).into_iter().for_each(|number| *number = 0.0);
    }
}

fn samples() -> Vec<FlightSample> {
    let start = FlightStart { latitude_rad: 0.7, height_m: 3e3, speed_m_s: 200.0, ..Default::default() };
    let flight = Flight::new(&start, &[Manoeuvre::Roll { duration_s: 10.0, turns: 1.0 }]).unwrap();
    (0..4).map(|k| flight.sample_at(0.1 * f64::from(k)).unwrap()).collect()
}

fn simulator(errors: &ErrorParameters, run: u64) -> Simulator {
    let options = Options { vertical: VerticalMode::Damped, covariance: run == 0, ..Default::default() };
    let mut simulator =
        Simulator::new(&Options { key: StreamKey { run, ..options.key }, ..options }).unwrap();
    errors.set_to(&mut simulator).unwrap();
    simulator
}

/// Single runs, the covariance, and an ensemble of `errors`: all are numbers, and run k has the bits of the simulator.
fn fly(errors: &ErrorParameters, samples: &[FlightSample], who: &str) {
    let mut ensemble = Ensemble::new(&simulator(errors, 0), 0, COUNT).unwrap();
    let mut singles: Vec<Simulator> = (0..COUNT).map(|run| simulator(errors, run as u64)).collect();
    for sample in samples {
        ensemble.push_sample(sample).unwrap();
        ensemble.step().unwrap();
        for single in &mut singles {
            single.push_sample(sample).unwrap();
            single.step().unwrap();
        }
    }
    for (run, single) in singles.iter_mut().enumerate() {
        let own = single.errors(ErrorSource::Navigation).unwrap().unwrap();
        let of_run = ensemble.errors(run as u64, ErrorSource::Navigation).unwrap().unwrap();
        assert_eq!(own, of_run, "{who}: run {run}");
        assert_eq!(
            single.imu().unwrap().measured,
            ensemble.imu(run as u64).unwrap().unwrap().measured,
            "{who}"
        );
        assert!(own.1.position_n.iter().all(|error| error.abs() < 1.0), "{who}: run {run}");
    }
    let sigma = singles[0].covariance().unwrap().unwrap().1.sigma();
    assert!(sigma.iter().all(|sigma| *sigma < 1.0), "{who}: {sigma:?}");
    let mut bytes = vec![0; ensemble.snapshot_size()];
    ensemble.save_snapshot(&mut bytes).unwrap();
    ensemble.load_snapshot(&bytes).unwrap();
}

#[test]
fn subnormal_random_parameters_fly_alone_and_together() {
    let (samples, random) = (samples(), random());
    assert!(random.len() > 15, "{}", random.len());
    for size in SIZES {
        let mut together = ErrorParameters::default();
        for field in &random {
            let mut alone = ErrorParameters::default();
            [&mut alone, &mut together].into_iter().for_each(|errors| set(errors, field, size));
            fly(&alone, &samples, &format!("{field} = {size:e}"));
        }
        fly(&together, &samples, &format!("all = {size:e}"));
    }
}
