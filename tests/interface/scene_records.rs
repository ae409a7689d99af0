//! The samples that a scene flies, and a record as a line of a file.

use std::ptr::null_mut;

use sins::abi::*;
use sins::record::{COLUMNS, SIGMA_COLUMNS};
use sins::scene::{Scene, builtin};

use crate::support::{init, text};

/// The program `sins` and every host count the same samples. Rounding does not remove a sample, and a log
/// ends with the duration of the scene.
#[test]
fn the_samples_of_a_flight_and_of_a_log_are_counted() {
    let rate = |rate_hz: &str| {
        let mut scene = builtin("rest").unwrap();
        scene.set(&[("flight.hours", "0.01"), ("flight.rate_hz", rate_hz)]).unwrap();
        scene.samples(None).unwrap()
    };
    assert_eq!((rate("100").count, rate("100").duration_s, rate("3").count), (3601, 36.0, 109));
    let mut scene = Scene::default();
    assert_eq!(
        scene.samples(None).map(|samples| scene.record_every(samples.count, samples.period_s)),
        Ok(Ok(180))
    );
    scene.set(&[("output.every_s", "0.001")]).unwrap();
    let sentence = scene.record_every(11, 0.01).unwrap_err().to_string();
    assert_eq!(sentence, "output.every_s = 0.001: must be at least the sample interval, 0.01");
    let log = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    let log: String = log.to_owned()
        + &(0..11).map(|k| format!("{},0,0,0,0,0,0\n", 5.0 + f64::from(k))).collect::<String>();
    let log = sins::log::FlightLog::parse(log.as_bytes()).unwrap();
    scene.set(&[("flight.file", "a.csv")]).unwrap();
    assert!(scene.samples(None).is_err());
    let samples = scene.samples(Some(&log)).unwrap();
    assert_eq!((samples.count, samples.start_s, samples.period_s, samples.duration_s), (11, 5.0, 1.0, 10.0));
    scene.duration_s = Some(4.0 * (1.0 - 1e-10));
    assert_eq!(scene.samples(Some(&log)).unwrap().count, 5);
    scene.duration_s = Some(0.5);
    let sentence = scene.samples(Some(&log)).unwrap_err().to_string();
    assert_eq!(sentence, "flight.duration_s = 0.5: the log has no second sample within this time");
}

/// A line has one value for each name of the head line, and each value reads back to the bit.
#[test]
fn a_record_is_a_line_of_a_file() {
    let line = |record: *const sins_record, sensors: &[f64], covariance: *const sins_covariance| {
        let mut buffer = vec![0; 2048];
        let (place, size) = (buffer.as_mut_ptr(), buffer.len());
        // SAFETY: structs of the interface or null, numbers with their count, a buffer with its size.
        let status = unsafe {
            sins_record_line(record, sensors.as_ptr(), sensors.len(), covariance, place, size, null_mut())
        };
        assert_eq!(status, SINS_OK);
        text(&buffer)
    };
    let mut record = init::<sins_record>();
    record.time_s = 0.1;
    record.truth.heading_rad = -1e-300;
    record.navigation.latitude_rad = core::f64::consts::FRAC_PI_3;
    record.model_errors.flags = SINS_ERRORS_NOT_COMPUTED;
    record.truth.velocity_enu_m_s = [f64::NEG_INFINITY, -f64::MIN_POSITIVE, f64::MIN];
    let mut covariance = init::<sins_covariance>();
    covariance.misalignment_sigma_enu_rad = [0.0, 0.0, 4e-5];
    let none = core::ptr::null();
    for (covariance, columns) in
        [(none, COLUMNS.len()), (&raw const covariance, COLUMNS.len() + SIGMA_COLUMNS.len())]
    {
        let names = line(core::ptr::null(), &[], covariance);
        let names: Vec<&str> = names.split(',').collect();
        let values = line(&record, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.5], covariance);
        let values: Vec<f64> = values.split(',').map(|value| value.parse().unwrap()).collect();
        assert_eq!((names.len(), values.len()), (columns, columns));
        for (name, value) in [
            ("time_s", 0.1),
            ("truth_heading_rad", -1e-300),
            ("truth_velocity_east_m_s", f64::NEG_INFINITY),
            ("truth_velocity_north_m_s", -f64::MIN_POSITIVE),
            ("truth_velocity_up_m_s", f64::MIN),
            ("navigation_latitude_rad", core::f64::consts::FRAC_PI_3),
            ("model_error_flags", 4.0),
            ("gyro_error_x_rad_s", 1.0),
            ("accel_error_z_m_s2", 6.5),
            ("sigma_misalignment_up_rad", 4e-5),
        ] {
            let found = names.iter().position(|other| *other == name).map(|index| values[index].to_bits());
            let is_sigma = name.starts_with("sigma");
            assert!(found == Some(f64::to_bits(value)) || is_sigma && columns == COLUMNS.len(), "{name}");
        }
    }
    // SAFETY: as above.
    let status = unsafe { sins_record_line(&record, [0.0; 5].as_ptr(), 5, none, null_mut(), 0, &mut 0) };
    assert_eq!(status, SINS_ERROR_INVALID_ARGUMENT);
}
