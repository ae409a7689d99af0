//! Places: date line, equator, any count of turns in longitude and heading, below the sea and at the edge of space.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{UnitQuaternion, Vector3};
use sins::mechanization::Frame;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorSource, Options, Simulator};

use crate::support::orbits::{Apart, Circle, about, apart_on_the_way, sample_of};
use crate::support::{DEG, options_at};

/// Flies two minutes at 50 Hz through the point that `circle` passes at the time 0.
fn flown(circle: &Circle, frame: Frame) -> Apart {
    let mut simulator = Simulator::new(&Options { frame, ..options_at(50.0) }).unwrap();
    apart_on_the_way(&mut simulator, (-60.0, 6000, 50.0), |time_s| circle.state(time_s), sample_of)
}

/// The point where the equator meets a meridian, passed with `heading_rad`.
fn on_the_equator(longitude_rad: f64, heading_rad: f64) -> UnitQuaternion<f64> {
    // From the pole along longitude 0, which is southward where it reaches the equator.
    about(Vector3::z(), longitude_rad)
        * about(Vector3::y(), FRAC_PI_2)
        * about(Vector3::z(), PI - heading_rad)
}

/// Each place is as good as another: the error is at most twice that of the same flight at 30° east, and 3 nm for the
/// rounding of coordinates.
#[test]
fn date_line_and_equator_are_no_lines() {
    let mut figures = Vec::new();
    for (what, height_m, speed_m_s) in [
        ("10 km", 10e3, 250.0),
        ("-400 m", -400.0, 50.0),
        ("-15 km", -15e3, 250.0),
        ("100 km", 100e3, 8000.0),
    ] {
        let mut largest_m = [0.0_f64; 2];
        for (frame, largest_m) in [Frame::EarthFixed, Frame::Geographic].into_iter().zip(&mut largest_m) {
            let circle = |longitude: f64, heading: f64| Circle {
                radius_m: 6_378_137.0 + height_m,
                speed_m_s,
                ..Circle::past(on_the_equator(longitude * DEG, heading * DEG), 3000.0)
            };
            for heading in [90.0, 270.0, 0.0, 45.0, 225.0] {
                let beside = flown(&circle(30.0, heading), frame);
                let line = flown(&circle(180.0, heading), frame);
                println!("{what}, {frame:?}, heading {heading}: {line}; at 30° east {beside}");
                assert!(line.position_m < 2.0 * beside.position_m + 3e-9, "{line} {beside}");
                assert!(line.velocity_m_s < 2.0 * beside.velocity_m_s + 1e-12);
                // The error of a cubic in the rotation vector begins with the fourth power of the turn in a sample; rounding is
                // left.
                assert!(line.attitude_rad < 2.0 * beside.attitude_rad + 16.0 * f64::EPSILON);
                *largest_m = largest_m.max(line.position_m);
            }
        }
        let [earth_fixed_m, geographic_m] = largest_m;
        figures.push(format!("{earth_fixed_m:.1e} m at {what} (geographic {geographic_m:.1e} m)"));
    }
    println!("figure: {}", figures.join("; "));
}

/// Longitudes of 0..2π and of many turns, headings, rolls and pitches likewise: all angles that are read are wrapped. The run is
/// the same, except for the rounding of the larger angles, 6.4e6 m times an ulp of 100 rad.
#[test]
fn turns_in_the_hosts_angles_are_nothing() {
    let (mut largest, mut most_turns) = (Apart::default(), 0.0_f64);
    for turns in [1.0, -1.0, 15.0, -15.0] {
        let circle = Circle::past(on_the_equator(-0.5, 0.3), 0.0);
        let mut simulator = Simulator::new(&options_at(50.0)).unwrap();
        let mut reported = 0;
        let sample = |time_s: f64, state: &sins::earth::state::EarthFixedState| {
            let mut sample = sample_of(time_s, state);
            reported += 1;
            if reported % 2 == 0 {
                sample.place.longitude_rad += turns * TAU;
                sample.euler.heading += turns * 100.0 * TAU;
                sample.euler.roll -= turns * TAU;
            } else {
                // The same attitude beyond the zenith.
                sample.euler.pitch = PI - sample.euler.pitch;
                sample.euler.roll += PI;
                sample.euler.heading += PI;
            }
            sample
        };
        let worst =
            apart_on_the_way(&mut simulator, (-60.0, 6000, 50.0), |time_s| circle.state(time_s), sample);
        println!("{turns} turns more: {worst}");
        // Longitude: an ulp of the largest, at either end. Attitude: an ulp of the heading. The attitude error turns gravity.
        let ulp = |angle: f64| (angle * f64::EPSILON).abs() + f64::EPSILON;
        let attitude = 2.0 * ulp(turns * 100.0 * TAU);
        assert!(worst.attitude_rad < attitude, "{worst}");
        let position = 2.0 * 6.4e6 * ulp(turns * TAU) + 0.5 * 9.8 * 120.0 * 120.0 * attitude;
        assert!(worst.position_m < position + 4e-8, "{worst} {position}");
        for solution in [simulator.truth(), simulator.navigation()] {
            let navigation = solution.unwrap().unwrap().navigation;
            assert!(navigation.place.longitude_rad.abs() <= PI);
            assert!((0.0..=TAU).contains(&navigation.euler.heading));
            assert!(navigation.euler.pitch.abs() <= FRAC_PI_2 && navigation.euler.roll.abs() <= PI);
        }
        largest = largest.worst(worst);
        most_turns = most_turns.max(100.0 * turns);
    }
    println!(
        "figure: {:.1e} m, {:.1e} rad (an ulp of {most_turns} turns)",
        largest.position_m, largest.attitude_rad
    );
}

/// Swings about north: the heading jumps from 0 to 2π, its error does not.
#[test]
fn heading_errors_are_wrapped() {
    let start = FlightStart { latitude_rad: 0.5, speed_m_s: 200.0, ..Default::default() };
    let swings = Manoeuvre::STurn { duration_s: 120.0, heading_change_rad: 0.3, turns: 6.0, ramp_s: 5.0 };
    let flight = Flight::new(&start, &[swings]).unwrap();
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    let samples: Vec<FlightSample> =
        (0..=12_000).map(|k| flight.sample_at(f64::from(k) / 100.0).unwrap()).collect();
    let wraps = samples.windows(2).filter(|w| (w[0].euler.heading - w[1].euler.heading).abs() > PI).count();
    let mut worst: f64 = 0.0;
    for sample in &samples {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        worst = worst.max(errors.heading_rad.abs());
        // An ulp of 2π on both sides of the wrap, and the misalignment over the cosine of the pitch.
        assert!(errors.heading_rad.abs() < 2.0 * TAU * f64::EPSILON + 2.0 * errors.misalignment_n.norm());
    }
    println!("figure: {worst:.1e} rad");
    assert!(wraps >= 11, "{wraps}");
}
