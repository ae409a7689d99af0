//! The parts of each interval, given to a navigator of the master, navigate to the bits of the unit.

use std::ffi::CString;

use nalgebra::Vector3;
use sins::Simulator;

use sins::scene::{Scene, builtin};
use sins::signal::Increment;
use sins_fmu::get_set::{fmi2GetInteger, fmi2SetString};
use sins_fmu::interface::fmi2OK;
use sins_fmu::steps::fmi2DoStep;

use crate::support::{Unit, inputs, reference};

/// Flies 20 s of aerobatics in a unit with these options, and calls `each` after each step but the first with the simulator of the
/// master, the counts of updates and of parts in an update, and the parts.
fn fly(options: &str, mut each: impl FnMut(&Unit, &mut Simulator, [i32; 2], &[Increment])) {
    let preset = "preset = \"tactical\"";
    let text = format!(
        "[flight]\nfile = \"log\"\n[options]\nvertical = \"free\"\n{options}\n[gyro]\n{preset}\n[accelerometer]\n{preset}\n"
    );
    let unit = Unit::flying(|unit| {
        let (place, text) = (reference("scene_text"), CString::new(text.as_str()).unwrap());
        assert_eq!(unsafe { fmi2SetString(unit.component, &place, 1, &text.as_ptr()) }, fmi2OK);
    });
    // The simulator of a scene with the same options gives the start; that of the master has no sensor errors.
    let [mut of_start] = *Scene::parse(text.as_bytes()).unwrap().simulator().unwrap();
    let mut own = Simulator::new(of_start.options()).unwrap();
    let flight = builtin("aerobatics").unwrap().flight().unwrap();
    let counts = ["imu.updates", "imu.parts_per_update"].map(reference);
    let of = |name: &'static str| {
        (1..=16).flat_map(move |part| (1..=3).map(move |axis| format!("imu.{name}[{part},{axis}]")))
    };
    let parts: Vec<u32> =
        of("part_angle_rad").chain(of("part_velocity_m_s")).map(|name| reference(&name)).collect();
    for k in 0..2000 {
        let sample = flight.sample_at(f64::from(k) / 100.0).unwrap();
        let v_n = sample.v_n.unwrap();
        let values = [
            sample.place.latitude_rad,
            sample.place.longitude_rad,
            sample.place.height_m,
            sample.euler.roll,
            sample.euler.pitch,
            sample.euler.heading,
            v_n.x,
            v_n.y,
            v_n.z,
        ];
        assert_eq!(unit.set_reals(&inputs(), &values), fmi2OK);
        let status = unsafe { fmi2DoStep(unit.component, sample.time_s, 0.01, 1) };
        assert_eq!(status, fmi2OK, "{:?}", unit.messages());
        let mut found = [-1; 2];
        assert_eq!(unsafe { fmi2GetInteger(unit.component, counts.as_ptr(), 2, found.as_mut_ptr()) }, fmi2OK);
        if k == 0 {
            assert_eq!(found, [0, 0]);
            of_start.push_sample(&sample).unwrap();
            let start = of_start.truth().unwrap().unwrap();
            own.start_navigation(start.time_s, &start.navigation).unwrap();
            continue;
        }
        let values: Vec<Vector3<f64>> =
            unit.reals(&parts).chunks_exact(3).map(Vector3::from_column_slice).collect();
        let (angles, velocities) = values.split_at(16);
        let parts: Vec<Increment> =
            angles.iter().zip(velocities).map(|(&angle, &velocity)| Increment { angle, velocity }).collect();
        each(&unit, &mut own, found, &parts);
    }
}

#[test]
fn parts_navigate_to_the_bits_of_the_unit() {
    for (updates, subsamples) in [(1, 2), (3, 5), (16, 1)] {
        let options = format!("updates_per_sample = {updates}\nsubsamples = {subsamples}");
        let shown = [
            "latitude_rad",
            "longitude_rad",
            "height_m",
            "velocity_east_m_s",
            "velocity_north_m_s",
            "velocity_up_m_s",
        ];
        let shown = shown.map(|name| reference(&format!("navigation.{name}")));
        let interval = reference("imu.interval_s");
        fly(&options, |unit, own, counts, parts| {
            assert_eq!(counts, [updates, subsamples]);
            let (updates, subsamples) = (updates as usize, subsamples as usize);
            let (parts, beyond) = parts.split_at(updates * subsamples);
            assert!(beyond.iter().all(|part| *part == Increment::default()));
            let update_s = unit.reals(&[interval])[0] / updates as f64;
            for update in parts.chunks_exact(subsamples) {
                own.push_imu(update, update_s).unwrap();
            }
            let solution = own.navigation().unwrap().unwrap().navigation;
            let place = [solution.place.latitude_rad, solution.place.longitude_rad, solution.place.height_m];
            let expected: Vec<f64> = place.into_iter().chain(solution.v_n.iter().copied()).collect();
            assert_eq!(unit.reals(&shown), expected);
        });
    }
}

#[test]
fn more_parts_than_the_outputs_hold_are_counted_alone() {
    fly("updates_per_sample = 4\nsubsamples = 5", |_, _, counts, parts| {
        assert_eq!(counts, [4, 5]);
        assert!(parts.iter().all(|part| *part == Increment::default()));
    });
}
