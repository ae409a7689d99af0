//! How hard the motion of a piece is, which the call returns.

use sins::truth::FlightSample;
use sins::{Options, Simulator};

use super::{asked_through_the_interface, scenes};

/// The largest rate and force are those of the summary of the truth of a simulator that flies the samples.
#[test]
fn rate_and_force_are_those_of_the_summary_of_the_truth() {
    for scene in scenes() {
        let options = Options { truth_summary: true, ..scene.options };
        let mut simulator = Simulator::new(&options).unwrap();
        for sample in &scene.samples {
            simulator.push_sample(sample).unwrap();
            simulator.step().unwrap();
        }
        let summary = simulator.truth_summary().unwrap().unwrap();
        let (_, _, cost) =
            asked_through_the_interface(&scene.samples, &scene.options.into(), &scene.requirement);
        assert_eq!(
            (cost.rate_max_rad_s, cost.rate_max_at_s),
            (summary.rate_max.value, summary.rate_max.time_s)
        );
        assert_eq!(
            (cost.force_max_m_s2, cost.force_max_at_s),
            (summary.force_max.value, summary.force_max.time_s)
        );
        println!(
            "{}: {:.3} rad/s, {:.2} m/s2, {:.3} rad/s2",
            scene.name, cost.rate_max_rad_s, cost.force_max_m_s2, cost.vibration_max_rad_s2
        );
    }
}

/// A roll A sin(ωt) at rest has the second difference A (2 sin(ωT/2)/T)² at its peak, where a sample is. Its time is that of the sample
/// behind the peak.
#[test]
fn vibration_has_its_closed_form() {
    let scene = scenes().swap_remove(0);
    let (period_s, amplitude, omega) = (0.02, 0.01, std::f64::consts::TAU * 3.125);
    let sample = |k: u32, shakes: bool| {
        let t = f64::from(k) * period_s;
        let mut sample = FlightSample { time_s: t, ..scene.samples[0] };
        sample.euler.pitch = 0.0;
        sample.euler.roll = if shakes { amplitude * (omega * t).sin() } else { 0.0 };
        sample
    };
    let ask = |shakes: bool| {
        let samples: Vec<_> = (0..250).map(|k| sample(k, shakes)).collect();
        asked_through_the_interface(&samples, &scene.options.into(), &scene.requirement).2
    };
    let (shaken, calm) = (ask(true), ask(false));
    let rate = 2.0 * (omega * period_s / 2.0).sin() / period_s;
    let expected = amplitude * rate * rate;
    // Second differences of angles, rounded to 4 eps.
    let rounding = 4.0 * f64::EPSILON / (period_s * period_s);
    assert!((shaken.vibration_max_rad_s2 - expected).abs() < rounding, "{shaken:?} {expected}");
    // A peak is at t = (k + 1/4)/3.125 Hz or half a period later; the last sample of its two intervals follows it by one period.
    let quarters = (shaken.vibration_max_at_s - period_s) * 3.125 * 4.0;
    assert!((quarters % 2.0 - 1.0).abs() < 1e-9, "{quarters}");
    assert!(calm.vibration_max_rad_s2 < rounding && calm.rate_max_rad_s < 1e-9, "{calm:?}");
}
