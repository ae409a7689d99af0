//! A sensor block off the reference point: perfect sensors still navigate to the truth, and what the INS believes wrongly of
//! the mounting comes out as in closed form, in both error data.

mod support;

use nalgebra::Vector3;
use sins::flight::{Flight, FlightStart, Manoeuvre};
use sins::math::Euler;
use sins::mechanization::{Frame, VerticalMode};
use sins::mounting::MountingParameters;
use sins::{Options, Simulator};
use support::{DEG, Worst, fly, options_at};

fn aerobatics() -> Flight {
    let start = FlightStart {
        latitude_rad: 45.0 * DEG,
        longitude_rad: 0.3,
        height_m: 4000.0,
        speed_m_s: 180.0,
        ..Default::default()
    };
    let manoeuvres = [
        Manoeuvre::STurn { duration_s: 30.0, heading_amplitude_rad: 0.6, cycles: 2.0, ramp_s: 6.0 },
        Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 },
        Manoeuvre::Loop { duration_s: 35.0, turns: 1.0, ramp_s: 5.0 },
        Manoeuvre::Turn { heading_change_rad: 3.6, bank_rad: 1.35, ramp_s: 3.0 },
        Manoeuvre::Roll { duration_s: 10.0, turns: -2.0 },
    ];
    Flight::new(&start, &manoeuvres).unwrap()
}

fn samples(flight: &Flight, rate_hz: f64) -> impl Iterator<Item = sins::truth::FlightSample> {
    let count = (flight.duration_s() * rate_hz).floor() as usize;
    (0..=count).map(move |k| flight.sample_at(k as f64 / rate_hz).unwrap())
}

fn off_centre() -> MountingParameters {
    MountingParameters {
        lever_arm_m: Vector3::new(1.0, 5.0, -2.0),
        boresight: Euler { roll: 0.7, pitch: -0.3, heading: 2.0 },
        ..Default::default()
    }
}

fn worst(options: &Options, rate_hz: f64, mounting: &MountingParameters) -> Worst {
    let mut simulator = Simulator::new(options).unwrap();
    simulator.set_mounting(mounting).unwrap();
    fly(&mut simulator, samples(&aerobatics(), rate_hz), 1)
}

#[test]
fn explore() {
    for frame in [Frame::EarthFixed] {
        for vertical in [VerticalMode::Free] {
            for rate in [25.0, 50.0, 100.0, 200.0] {
                let options = Options {
                    frame,
                    vertical,
                    scheme: sins::mechanization::Scheme::Polynomial,
                    subsamples: 4,
                    ..options_at(rate)
                };
                let without = worst(&options, rate, &MountingParameters::default());
                let with = worst(&options, rate, &off_centre());
                let boresight = worst(
                    &options,
                    rate,
                    &MountingParameters { lever_arm_m: Vector3::zeros(), ..off_centre() },
                );
                println!("{frame:?} {vertical:?} {rate}\n  {without:?}\n  {with:?}\n  {boresight:?}");
            }
        }
    }
}
