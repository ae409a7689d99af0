//! What is flown, sample by sample: the paper's patrol, or a log.

use sins::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid};
use sins::mechanization::VerticalMode;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Error, Options};

use super::command::Flown;
use crate::failure::Failure;
use crate::flight_log;
use crate::units::time_text;

/// Samples of the patrol in a second.
const RATE_HZ: f64 = 100.0;

enum Source {
    Flight(Flight),
    Log(Vec<FlightSample>),
}

/// A scene.
pub struct Scene {
    pub name: String,
    pub title: String,
    pub options: Options,
    pub count: usize,
    source: Source,
}

impl Scene {
    pub fn new(flown: &Flown) -> Result<Self, Failure> {
        match flown {
            Flown::Patrol(duration_s) => {
                let intake = IntakeLimits { period_s: Some(1.0 / RATE_HZ), ..Default::default() };
                Ok(Self {
                    name: "simulation2".to_owned(),
                    title: format!("patrol of {} at {RATE_HZ} Hz", time_text(*duration_s)),
                    // As sins_harness simulation2 flies.
                    options: Options { vertical: VerticalMode::FollowTruth, intake, ..Default::default() },
                    count: (duration_s * RATE_HZ).round() as usize + 1,
                    source: Source::Flight(patrol(*duration_s)?),
                })
            }
            Flown::Log(path) => {
                let samples = flight_log::read(path)?;
                let span_s = samples[samples.len() - 1].time_s - samples[0].time_s;
                Ok(Self {
                    name: flight_log::name(path),
                    title: format!("flight of {}", time_text(span_s)),
                    options: Options::default(),
                    count: samples.len(),
                    source: Source::Log(samples),
                })
            }
        }
    }

    /// The sample `index`.
    pub fn sample(&self, index: usize) -> Result<FlightSample, Error> {
        match &self.source {
            Source::Flight(flight) => flight.sample_at((index as f64 / RATE_HZ).min(flight.duration_s())),
            Source::Log(samples) => Ok(samples[index]),
        }
    }
}

/// The patrol of `sins_harness simulation2`: at 200 m/s in eights of 560 s, gentler than that of the tests.
fn patrol(duration_s: f64) -> Result<Flight, Error> {
    let term = |channel, amplitude, period_s: f64| Sinusoid {
        channel,
        amplitude,
        frequency_hz: 1.0 / period_s,
        phase_rad: 0.0,
    };
    let terms = [
        // The first zero of J0 closes the eights.
        term(Channel::Course, 2.404_825_557_695_773, 560.0),
        term(Channel::Climb, 0.02, 903.0),
        term(Channel::Speed, 4.0, 1370.0),
        term(Channel::Roll, 0.25f64.to_radians(), 5.3),
        term(Channel::Pitch, 0.2f64.to_radians(), 7.7),
        term(Channel::Pitch, 0.0, 7.7),
    ];
    // The ramp keeps the bank below 30° while the eights set in; a short flight must not shorten it.
    let ramp_s = 300.0;
    let manoeuvre =
        Manoeuvre::Sinusoids { duration_s: duration_s.max(4.0 * ramp_s), ramp_s, terms, count: 5 };
    let start = FlightStart {
        latitude_rad: 40f64.to_radians(),
        longitude_rad: 116.4f64.to_radians(),
        height_m: 8000.0,
        speed_m_s: 200.0,
        ..Default::default()
    };
    Flight::new(&start, &[manoeuvre])
}
