//! A truth that is doubtful: each reason is one warning.

use sins_fmu::interface::{fmi2OK, fmi2Terminate};
use sins_fmu::steps::fmi2DoStep;

use crate::support::{Unit, reference};

const TRUTH: [&str; 6] = [
    "truth.latitude_rad",
    "truth.longitude_rad",
    "truth.height_m",
    "truth.roll_rad",
    "truth.pitch_rad",
    "truth.heading_rad",
];

/// Flies to the north-east at 100 m/s, with a heading and a latitude that `damage` changes, at 50 Hz. The messages about the truth in
/// flight, and at its end.
fn warned(seconds: u32, damage: impl Fn(f64, &mut [f64; 6])) -> [Vec<String>; 2] {
    let unit = Unit::flying(|_| ());
    let references: Vec<u32> = TRUTH.iter().map(|name| reference(name)).collect();
    let said = || -> Vec<String> {
        unit.messages()
            .into_iter()
            .map(|message| message.2)
            .filter(|text| text.starts_with("truth: "))
            .collect()
    };
    for k in 0..50 * seconds {
        let t = f64::from(k) * 0.02;
        let north_rad = 70.0 * t / 6.37e6;
        let mut truth = [0.1 + north_rad, 0.2 + north_rad, 1000.0, 0.0, 0.03, 0.785];
        damage(t, &mut truth);
        assert_eq!(unit.set_reals(&references, &truth), fmi2OK);
        assert_eq!(unsafe { fmi2DoStep(unit.component, t, 0.02, 1) }, fmi2OK, "{:?}", unit.messages());
    }
    let in_flight = said();
    assert_eq!(unsafe { fmi2Terminate(unit.component) }, fmi2OK);
    [in_flight, said()]
}

#[test]
fn a_good_truth_gives_no_warning() {
    assert_eq!(warned(30, |_, _| ()), [[""; 0]; 2]);
}

#[test]
fn positions_of_32_bits_are_warned_of_once() {
    let single = |_: f64, truth: &mut [f64; 6]| {
        for angle in &mut truth[..2] {
            *angle = f64::from(*angle as f32);
        }
    };
    let [in_flight, at_end] = warned(30, single);
    assert!(in_flight.len() == 1 && at_end.is_empty(), "{in_flight:?} {at_end:?}");
    assert!(
        in_flight[0].contains("32-bit floats?") && in_flight[0].contains("Remedy: smooth"),
        "{in_flight:?}"
    );
    let [in_flight, at_end] = warned(3, single);
    assert!(in_flight.is_empty() && at_end.len() == 1, "{in_flight:?} {at_end:?}");
}

/// A heading that a tool interpolated by number from 359 to 1 degree: a smaller step would hide it.
#[test]
fn a_heading_that_was_interpolated_through_north_is_warned_of() {
    let through_north = |t: f64, truth: &mut [f64; 6]| {
        truth[5] = match t {
            t if t < 12.0 => 6.27,
            t if t < 13.0 => 6.27 + (t - 12.0) * (0.02 - 6.27),
            _ => 0.02,
        };
    };
    let [in_flight, _] = warned(30, through_north);
    assert!(in_flight.len() == 1 && in_flight[0].contains("interpolated through its wrap?"), "{in_flight:?}");
    assert!(in_flight[0].contains("unwrap the angle before interpolating it"), "{in_flight:?}");
}
