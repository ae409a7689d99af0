//! Failures of the altimeter, and their effect on the vertical channel that it aids.

use sins::mechanization::VerticalMode;
use sins::sensors::{Altimeter, AltimeterParameters, Failure, SensorOutput, StreamKey};
use sins::{Options, Simulator};

use super::{DT, in_flight, noisy};
use crate::support::{bits, options_at, sensed};

/// If the altimeter is dead or loses every sample, a damped vertical channel is a free one, to the bit, and is flagged so.
#[test]
fn without_an_altimeter_the_vertical_channel_is_free() {
    let options = Options { vertical: VerticalMode::Damped, ..options_at(1.0 / DT) };
    let fly_with = |options: &Options, failure| {
        let mut simulator = Simulator::new(options).unwrap();
        simulator.set_accel(&noisy()).unwrap();
        simulator.set_failure(SensorOutput::Altimeter, failure).unwrap();
        sensed(&mut simulator, in_flight(0..1000));
        let unaided = simulator.navigation().unwrap().unwrap().vertical_unaided;
        (bits(&simulator), unaided)
    };
    let (free, _) = fly_with(&Options { vertical: VerticalMode::Free, ..options }, None);
    let (damped, is_unaided) = fly_with(&options, None);
    assert!(damped != free && !is_unaided);
    for failure in [
        Failure::Dead,
        Failure::DropOuts { interval_s: 0.0, probability: 1.0 },
        Failure::DropOuts { interval_s: DT, probability: 0.0 },
    ] {
        assert_eq!(fly_with(&options, Some(failure)), (free.clone(), true), "{failure:?}");
    }
    // A bias step acts as a bias, except for rounding.
    let mut biased = Simulator::new(&options).unwrap();
    biased.set_accel(&noisy()).unwrap();
    biased.set_altimeter(&AltimeterParameters { bias_m: 64.0, ..Default::default() }).unwrap();
    sensed(&mut biased, in_flight(0..1000));
    let (stepped, is_unaided) = fly_with(&options, Some(Failure::BiasStep { size: 64.0 }));
    let height = |bits: &[u64]| f64::from_bits(bits[2]);
    // size dt / dt is rounded, a bias is not: an ulp of 64 m in each of a thousand samples, damped.
    assert!((height(&stepped) - height(&bits(&biased))).abs() < 1e-11 && !is_unaided);
}

#[test]
fn an_altimeter_sticks_at_its_last_height_and_spikes_by_their_mean() {
    let mut altimeter = Altimeter::new(StreamKey::default(), 100.0);
    altimeter.set(&AltimeterParameters { noise_m: 1.0, ..Default::default() });
    let last = altimeter.sense(101.0, 0.1);
    altimeter.set_failure(Some(Failure::Stuck));
    assert_eq!([altimeter.sense(102.0, 0.1), altimeter.sense(103.0, 0.1)], [last, last]);
    altimeter.set_failure(None);
    let mut sound = Altimeter::new(StreamKey::default(), 100.0);
    sound.set(&AltimeterParameters { noise_m: 1.0, ..Default::default() });
    let expected = [101.0, 102.0, 103.0, 104.0].map(|height_m| sound.sense(height_m, 0.1))[3];
    assert_eq!(altimeter.sense(104.0, 0.1), expected);

    let mut altimeter = Altimeter::new(StreamKey::default(), 0.0);
    altimeter.set_failure(Some(Failure::Spikes { size: 8.0, interval_s: 1.0, duration_s: 0.25 }));
    let shown = [0.5; 4].map(|dt| altimeter.sense(0.0, dt));
    assert_eq!(shown, [Some(4.0), Some(0.0), Some(4.0), Some(0.0)]);
}

/// The true height of the start is no output: the altimeter never showed it.
#[test]
fn an_altimeter_that_showed_nothing_sticks_at_the_first_value_it_shows() {
    let mut altimeter = Altimeter::new(StreamKey::default(), 100.0);
    altimeter.set_failure(Some(Failure::Dead));
    assert_eq!(altimeter.sense(110.0, 0.1), None);
    altimeter.set_failure(Some(Failure::Stuck));
    assert_eq!([120.0, 130.0].map(|height_m| altimeter.sense(height_m, 0.1)), [Some(120.0); 2]);
    altimeter.reposition(500.0);
    altimeter.set_failure(Some(Failure::Stuck));
    assert_eq!([510.0, 520.0].map(|height_m| altimeter.sense(height_m, 0.1)), [Some(510.0); 2]);
}
