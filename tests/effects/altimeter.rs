//! The barometric altimeter.

use sins::sensors::{Altimeter, AltimeterParameters, StreamKey};

#[test]
fn an_ideal_altimeter_shows_the_height() {
    let mut altimeter = Altimeter::new(StreamKey::default(), 100.0);
    assert_eq!(altimeter.sense(123.456, 0.01), Some(123.456));
}

#[test]
fn in_a_steady_climb_the_lag_is_climb_rate_times_time_constant() {
    let mut altimeter = Altimeter::new(StreamKey::default(), 0.0);
    altimeter.set(&AltimeterParameters { lag_s: 2.0, bias_m: 5.0, scale_factor: 0.01, ..Default::default() });
    let mut shown = 0.0;
    for step in 1..=1000 {
        shown = altimeter.sense(10.0 * 0.1 * f64::from(step), 0.1).unwrap();
    }
    // 1000 m minus 10 m/s times 2 s (e^-50 of the start remains), plus 1 %, plus the bias.
    assert!((shown - (980.0 * 1.01 + 5.0)).abs() < 1e-9, "{shown}");
}
