//! The increments of a flight, given to a navigator of the host, navigate to the same bits.

use nalgebra::Vector3;
use sins::abi::*;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::scene::builtin;
use sins::sensors::TriadParameters;
use sins::{Options, Simulator};

use crate::support::{DEG_PER_HOUR, G, bits, init};

/// Latitude, longitude, height, velocity and attitude of the solution. The errors, which follow, need a truth.
fn solution(simulator: &Simulator) -> Vec<u64> {
    bits(simulator).into_iter().take(10).collect()
}

/// Flies `seconds` of a built-in flight, and beside it a navigator on the increments of the flight. The parts of an interval.
fn fly_beside(name: &str, options: &Options, seconds: f64) -> usize {
    let flight = builtin(name).unwrap().flight().unwrap();
    let one = Vector3::repeat(1.0);
    let mut flying = Simulator::new(options).unwrap();
    let bias_and_noise = |bias, random_walk, quantization| TriadParameters {
        bias_sigma: one * bias,
        random_walk: one * random_walk,
        quantization: one * quantization,
        scale_factor_sigma: one * 1e-4,
        ..Default::default()
    };
    flying.set_gyro(&bias_and_noise(DEG_PER_HOUR, 1e-6, 1e-7)).unwrap();
    flying.set_accel(&bias_and_noise(1e-4 * G, 1e-5, 1e-6)).unwrap();

    let mut own = Simulator::new(options).unwrap();
    let mut parts = 0;
    for k in 0..=(seconds * 100.0) as usize {
        flying.push_sample(&flight.sample_at(k as f64 / 100.0).unwrap()).unwrap();
        if k == 0 {
            let start = flying.truth().unwrap().unwrap();
            own.start_navigation(start.time_s, &start.navigation).unwrap();
        }
        flying.step().unwrap();
        parts = 0;
        for update in 0.. {
            let Some((increments, interval_s)) = flying.measured_update(update) else { break };
            own.push_imu(increments, interval_s).unwrap();
            parts += increments.len();
        }
        assert_eq!(solution(&own), solution(&flying), "{name}, sample {k}: {options:?}");
    }
    parts
}

#[test]
fn increments_of_a_flight_navigate_to_its_bits() {
    for name in ["aerobatics", "coning", "patrol"] {
        for frame in [Frame::EarthFixed, Frame::Geographic] {
            for scheme in [Scheme::Exact, Scheme::Polynomial, Scheme::Paper] {
                for (subsamples, updates_per_sample) in [(1, 1), (2, 3), (3, 2), (5, 16)] {
                    let vertical = VerticalMode::Free;
                    let options = Options {
                        scheme,
                        frame,
                        vertical,
                        subsamples,
                        updates_per_sample,
                        ..Default::default()
                    };
                    assert_eq!(fly_beside(name, &options, 20.0), subsamples * updates_per_sample);
                }
            }
        }
    }
}

/// The same through the C interface, whose solution at the start is made of angles and a quaternion.
#[test]
fn increments_read_by_c_functions_navigate_to_the_same_bits() {
    let flight = builtin("aerobatics").unwrap().flight().unwrap();
    let (mut flying, mut own) = (std::ptr::null_mut(), std::ptr::null_mut());
    let mut navigation = [init::<sins_navigation>(); 2];
    let mut increment = init::<sins_imu_increment>();
    // SAFETY: the pointers are of live values.
    unsafe {
        let mut options: sins_options = init();
        options.vertical = SINS_VERTICAL_FREE;
        (options.subsamples, options.updates_per_sample) = (3, 4);
        assert_eq!(sins_create(&options, &mut flying), SINS_OK);
        assert_eq!(sins_create(&options, &mut own), SINS_OK);
        for k in 0..2000 {
            let sample = sins_flight_sample::from(&flight.sample_at(f64::from(k) / 100.0).unwrap());
            assert_eq!(sins_push_sample(flying, &sample), SINS_OK);
            if k == 0 {
                assert_eq!(sins_get_truth(flying, &mut navigation[0]), SINS_OK);
                assert_eq!(sins_start_navigation(own, &navigation[0]), SINS_OK);
            }
            sins_step(flying);
            let mut update = 0;
            while sins_get_imu_update(flying, update, &mut increment) == SINS_OK {
                assert_eq!(sins_push_imu(own, &increment), SINS_OK);
                update += 1;
            }
            assert_eq!(update, if k == 0 { 0 } else { 4 });
            assert_eq!(sins_get_navigation(flying, &mut navigation[0]), SINS_OK);
            assert_eq!(sins_get_navigation(own, &mut navigation[1]), SINS_OK);
            let [a, b] = navigation.map(|n| {
                (
                    n.solution.latitude_rad,
                    n.solution.longitude_rad,
                    n.solution.height_m,
                    n.solution.velocity_enu_m_s,
                    n.solution.quaternion_nb,
                )
            });
            assert_eq!(a, b, "sample {k}");
        }
        assert_eq!(sins_get_imu_update(flying, -1, &mut increment), SINS_ERROR_INVALID_ARGUMENT);
        sins_destroy(flying);
        sins_destroy(own);
    }
}
