//! The embedded scenes: flights in closed form that test a mechanization in different ways.

use sins::Options;
use sins::earth::Earth;
use sins::truth::FlightSample;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};

use super::reference::Judge;
use super::scene::{CurveScene, Rate};
use crate::failure::Failure;

/// Rates at which the scenes are sampled [Hz]: each divides the first.
pub const RATES_HZ: [u32; 6] = [400, 200, 100, 50, 20, 10];

/// The airliner's speed, in the cruise and across the pole [m/s].
const CRUISE_M_S: f64 = 240.0;

/// Plan of an embedded scene.
#[derive(Debug)]
pub struct Embedded {
    pub name: &'static str,
    pub title: &'static str,
    /// Highest frequency of a vibration in the scene [Hz]; 0 without vibration.
    pub highest_hz: f64,
    plan: fn(f64) -> (FlightStart, Vec<Manoeuvre>),
}

impl PartialEq for Embedded {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

pub static ALL: [Embedded; 5] = [
    Embedded { name: "rest", title: "at rest, tilted", highest_hz: 0.0, plan: rest },
    Embedded { name: "cruise", title: "airliner in cruise", highest_hz: 0.0, plan: cruise },
    Embedded { name: "aerobatics", title: "rolls, loops, 5 g turns", highest_hz: 0.0, plan: aerobatics },
    Embedded {
        name: "vibration",
        title: "coning and sculling at 4 Hz",
        highest_hz: VIBRATION_HZ,
        plan: vibration,
    },
    Embedded { name: "pole", title: "across the pole", highest_hz: 0.0, plan: pole },
];

impl Embedded {
    /// The scene, `duration_s` [s] long.
    pub fn scene(&self, duration_s: f64) -> Result<CurveScene, Failure> {
        let (start, manoeuvres) = (self.plan)(duration_s);
        let flight = Flight::new(&start, &manoeuvres)?;
        let Self { name, title, highest_hz, .. } = *self;
        Sampled { name, title, highest_hz, base: Options::default() }.scene(&flight, 0.0, duration_s)
    }
}

/// Description of a scene whose flight has a closed form.
pub struct Sampled<'a> {
    pub name: &'a str,
    pub title: &'a str,
    pub highest_hz: f64,
    pub base: Options,
}

impl Sampled<'_> {
    /// The scene of the `duration_s` [s] of `flight` from `from_s` on, a multiple of the longest sample interval.
    pub fn scene(&self, flight: &Flight, from_s: f64, duration_s: f64) -> Result<CurveScene, Failure> {
        let highest = RATES_HZ[0];
        // The epsilon keeps the last sample if rounding puts it just past the end.
        let count = (duration_s * f64::from(highest) + 1e-6).floor() as usize;
        let before = (from_s * f64::from(highest)).round() as usize;
        let samples = (before..=before + count)
            .map(|k| flight.sample_at((k as f64 / f64::from(highest)).min(flight.duration_s())))
            .collect::<Result<Vec<_>, _>>()?;
        let rates: Vec<Rate> = RATES_HZ.map(|hz| Rate::stated((highest / hz) as usize, f64::from(hz))).into();
        let judge = |instants: &[usize]| Judge::of_flight(&self.base.earth(), flight, &samples, instants);
        let judge = judge(&CurveScene::instants(samples.len(), &rates, 1))?;
        Ok(CurveScene {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            highest_hz: self.highest_hz,
            samples,
            rates,
            judge,
            base: self.base,
            warnings: Vec::new(),
        })
    }
}

/// The first `duration_s` [s] of `flight` at the lowest rate.
pub fn coarse(flight: &Flight, duration_s: f64) -> Result<(Rate, Vec<FlightSample>), Failure> {
    let hz = RATES_HZ[RATES_HZ.len() - 1];
    let count = (duration_s * f64::from(hz) + 1e-6).floor() as usize;
    let sample = |k: usize| flight.sample_at((k as f64 / f64::from(hz)).min(flight.duration_s()));
    let samples = (0..=count).map(sample).collect::<Result<Vec<_>, _>>()?;
    Ok((Rate::stated(1, f64::from(hz)), samples))
}

fn term(channel: Channel, amplitude: f64, frequency_hz: f64, phase_rad: f64) -> Sinusoid {
    Sinusoid { channel, amplitude, frequency_hz, phase_rad }
}

fn start(latitude_deg: f64, height_m: f64, speed_m_s: f64) -> FlightStart {
    let latitude_rad = latitude_deg.to_radians();
    FlightStart { latitude_rad, longitude_rad: 0.3, height_m, speed_m_s, ..Default::default() }
}

fn rest(duration_s: f64) -> (FlightStart, Vec<Manoeuvre>) {
    let start = FlightStart { heading_rad: 0.8, roll_rad: 0.1, pitch_rad: 0.05, ..start(45.0, 100.0, 0.0) };
    (start, vec![Manoeuvre::Rest { duration_s }])
}

/// Gentle turns, climbs and changes of speed, with the slow rocking of a large aircraft: a roll each 6 s, a pitch each 9 s.
fn cruise(duration_s: f64) -> (FlightStart, Vec<Manoeuvre>) {
    let terms = [
        term(Channel::Course, 0.4, 1.0 / 900.0, 0.0),
        term(Channel::Climb, 0.01, 1.0 / 240.0, 0.0),
        term(Channel::Speed, 4.0, 1.0 / 150.0, 0.0),
        term(Channel::Roll, 0.01, 1.0 / 6.0, 0.0),
        term(Channel::Pitch, 0.004, 1.0 / 9.0, 1.0),
        term(Channel::Heading, 0.003, 1.0 / 6.0, 1.3),
    ];
    let start = FlightStart { heading_rad: 1.0, ..start(50.0, 10e3, CRUISE_M_S) };
    (start, vec![Manoeuvre::Sinusoids { duration_s, ramp_s: 30.0, sinusoids: Sinusoids::of(&terms) }])
}

/// Two minutes of manoeuvres, repeated: rolls of up to 160 °/s, loops and turns of 4 to 5 g.
fn aerobatics(duration_s: f64) -> (FlightStart, Vec<Manoeuvre>) {
    let pass = [
        Manoeuvre::STurn { duration_s: 30.0, heading_change_rad: 0.6, turns: 2.0, ramp_s: 6.0 },
        Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 },
        Manoeuvre::Loop { duration_s: 35.0, turns: 1.0, ramp_s: 5.0 },
        Manoeuvre::Turn { heading_change_rad: 3.6, bank_rad: 1.35, ramp_s: 3.0 },
        Manoeuvre::Roll { duration_s: 10.0, turns: -2.0 },
    ];
    // The bank sets the duration of a turn, so a last straight fills the remaining time.
    let mut manoeuvres = Vec::new();
    for _ in 0..(duration_s / 110.0).ceil() as usize {
        manoeuvres.extend(pass);
    }
    manoeuvres.push(Manoeuvre::Straight { duration_s });
    (start(45.0, 4e3, 180.0), manoeuvres)
}

const VIBRATION_HZ: f64 = 4.0;

/// Coning of 0.1° in roll and pitch, and a forward acceleration of 0.13 g in step with the pitch: 1e-3 m/s² of sculling.
fn vibration(duration_s: f64) -> (FlightStart, Vec<Manoeuvre>) {
    let quarter = std::f64::consts::FRAC_PI_2;
    let terms = [
        term(Channel::Roll, 1.7e-3, VIBRATION_HZ, 0.0),
        term(Channel::Pitch, 1.7e-3, VIBRATION_HZ, quarter),
        term(Channel::Speed, 0.05, VIBRATION_HZ, 0.0),
        term(Channel::Course, 0.2, 1.0 / 300.0, 0.0),
    ];
    let sum = Manoeuvre::Sinusoids { duration_s, ramp_s: 10.0, sinusoids: Sinusoids::of(&terms) };
    (start(40.0, 3e3, 100.0), vec![sum])
}

/// Straight and level flight with the pole half way.
fn pole(duration_s: f64) -> (FlightStart, Vec<Manoeuvre>) {
    let height_m = 10e3;
    // The meridian near the pole is taken as a circle with the polar radius of curvature, which is 400 m short in 4°.
    let to_pole_rad = 0.5 * duration_s * CRUISE_M_S / (Earth::default().radii(1.0).meridian_m + height_m);
    (start(90.0 - to_pole_rad.to_degrees(), height_m, CRUISE_M_S), vec![Manoeuvre::Straight { duration_s }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_flies_at_every_rate() {
        for embedded in &ALL {
            let scene = embedded.scene(120.0).unwrap();
            assert_eq!(scene.samples.len(), 120 * 400 + 1);
            assert_eq!(scene.rates.len(), 6);
            assert!(scene.duration_s() == 120.0, "{}", scene.name);
        }
    }

    #[test]
    fn the_pole_is_half_way() {
        let scene = ALL[4].scene(120.0).unwrap();
        let latitude = |k: usize| scene.samples[k].place.latitude_rad;
        let highest = (0..scene.samples.len()).max_by(|&a, &b| latitude(a).total_cmp(&latitude(b))).unwrap();
        assert!(highest.abs_diff(60 * 400) < 400, "{highest}");
        assert!(latitude(highest) > 89.99f64.to_radians());
    }
}
