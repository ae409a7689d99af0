//! Corrections by the master: each change of the counter removes the errors of the inputs once, to the bit as in the library.

use std::ffi::{CString, c_int};

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::earth::state::StateErrors;
use sins::errors::correction::{Compensation, Correction};
use sins::math::Euler;
use sins::scene::Scene;
use sins::truth::FlightSample;
use sins::{ErrorSource, Simulator};
use sins_fmu::get_set::{fmi2SetInteger, fmi2SetString};
use sins_fmu::interface::{fmi2Error, fmi2OK};
use sins_fmu::states::{fmi2DeSerializeFMUstate, fmi2FreeFMUstate, fmi2SetFMUstate};
use sins_fmu::steps::fmi2DoStep;

use crate::support::{AT_REST, Unit, inputs, reference, variables};

/// The references of all variables whose names begin so, in their order.
fn references(begin: &str) -> Vec<u32> {
    let is_it = |name: &str| name.starts_with(begin) && name != "correction.count";
    variables().iter().filter(|variable| is_it(&variable.name)).map(|variable| variable.reference).collect()
}

/// A unit and the library with the same settings, errors and samples.
struct Both {
    unit: Unit,
    scene: Scene,
    simulator: Box<[Simulator; 1]>,
    steps: u32,
    correction: Vec<u32>,
    /// Outputs of the errors and of the compensation.
    outputs: [Vec<u32>; 2],
}

impl Both {
    /// `lines` follow in the text of the scene.
    fn new(lines: &str) -> Self {
        let begin = "[flight]\nfile = \"log\"\n[start]\nposition_m = [1000, 0, 0]\n[gyro]\nbias_deg_h = [0.5, 0, 0]\n";
        let text = format!("{begin}{lines}");
        let unit = Unit::flying(|unit| {
            let (place, text) = (reference("scene_text"), CString::new(text.as_str()).unwrap());
            assert_eq!(unsafe { fmi2SetString(unit.component, &place, 1, &text.as_ptr()) }, fmi2OK);
        });
        let scene = Scene::parse(text.as_bytes()).unwrap();
        let simulator = scene.simulator().unwrap();
        let outputs = ["errors.", "compensation."].map(references);
        Self { unit, scene, simulator, steps: 0, correction: references("correction."), outputs }
    }

    fn sample(&self) -> (f64, FlightSample) {
        let time_s = f64::from(self.steps) / 128.0;
        let [latitude_rad, longitude_rad, height_m, roll, pitch, heading, ..] = AT_REST;
        let place = Geodetic { latitude_rad, longitude_rad, height_m };
        (time_s, FlightSample::at_rest(time_s, place, Euler { roll, pitch, heading }))
    }

    fn step_unit(&mut self) -> c_int {
        let (time_s, _) = self.sample();
        self.unit.set_reals(&inputs(), &AT_REST);
        unsafe { fmi2DoStep(self.unit.component, time_s, 1.0 / 128.0, 1) }
    }

    /// Steps both and compares their outputs to the bit.
    fn step(&mut self) {
        assert_eq!(self.step_unit(), fmi2OK, "{:?}", self.unit.messages());
        let (_, mut sample) = self.sample();
        let [simulator] = &mut *self.simulator;
        self.scene.prepare(simulator, 0.0, &mut sample).unwrap();
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        self.steps += 1;
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        let found = self.unit.reals(&self.outputs[0]);
        let expected: Vec<f64> = [errors.position_n, errors.velocity_n, errors.misalignment_n]
            .iter()
            .flat_map(|three| three.iter().copied())
            .chain([errors.roll_rad, errors.pitch_rad, errors.heading_rad])
            .collect();
        assert_eq!(found, expected);
        let Compensation { gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor } =
            simulator.compensation();
        let compensation: Vec<f64> = [gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor]
            .iter()
            .flat_map(|three| three.iter().copied())
            .collect();
        assert_eq!(self.unit.reals(&self.outputs[1]), compensation);
    }

    fn count(&self, count: i32) {
        let place = reference("correction.count");
        assert_eq!(unsafe { fmi2SetInteger(self.unit.component, &place, 1, &count) }, fmi2OK);
    }

    /// Sets the inputs of a correction.
    fn set(&self, correction: &Correction) {
        let StateErrors { position_n, velocity_n, misalignment_n } = &correction.errors;
        let Compensation { gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor } =
            &correction.sensors;
        let all = [
            position_n,
            velocity_n,
            misalignment_n,
            gyro_bias,
            gyro_scale_factor,
            accel_bias,
            accel_scale_factor,
        ];
        let values: Vec<f64> = all.iter().flat_map(|three| three.iter().copied()).collect();
        assert_eq!(self.unit.set_reals(&self.correction, &values), fmi2OK);
    }
}

#[test]
fn a_change_of_the_counter_corrects_once() {
    let mut both = Both::new("");
    // The first sample takes the counter as it is.
    both.count(7);
    for _ in 0..50 {
        both.step();
    }
    let east_m = |both: &Both| both.unit.reals(&both.outputs[0])[0];
    assert!((east_m(&both) - 1000.0).abs() < 1.0);
    let (_, found) = both.simulator[0].errors(ErrorSource::Navigation).unwrap().unwrap();
    let correction = Correction {
        errors: StateErrors {
            position_n: found.position_n,
            velocity_n: found.velocity_n,
            misalignment_n: found.misalignment_n,
        },
        sensors: Compensation {
            gyro_bias: Vector3::new(2e-6, 0.0, 0.0),
            accel_scale_factor: Vector3::new(0.0, 1e-5, 2e-5),
            ..Default::default()
        },
    };
    both.set(&correction);
    both.step(); // the inputs alone correct nothing
    both.count(-3);
    let state = both.unit.state();
    both.simulator[0].correct(&correction).unwrap();
    both.step();
    assert!(east_m(&both).abs() < 1.0);
    for _ in 0..10 {
        both.step();
    }
    let end = both.unit.state();
    // The state from before the correction continues to the same bytes.
    let (component, mut image) = (both.unit.component, std::ptr::null_mut());
    unsafe {
        assert_eq!(
            fmi2DeSerializeFMUstate(component, state.as_ptr().cast(), state.len(), &mut image),
            fmi2OK
        );
        assert_eq!(fmi2SetFMUstate(component, image), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(component, &mut image), fmi2OK);
    }
    both.steps -= 11;
    for _ in 0..11 {
        assert_eq!(both.step_unit(), fmi2OK);
        both.steps += 1;
    }
    assert!(both.unit.state() == end);
}

#[test]
fn a_correction_that_is_rejected_changes_nothing() {
    let mut both = Both::new("");
    both.step();
    both.count(1);
    let before = both.unit.state();
    both.unit.messages();
    assert_eq!(both.step_unit(), fmi2Error);
    let said = both.unit.messages();
    assert!(said[0].2.contains("before the first step") && both.unit.state() == before, "{said:?}");
    both.count(0);
    for _ in 0..3 {
        both.step();
    }
    let mut far = Correction::default();
    far.errors.position_n.y = 2e6;
    both.set(&far);
    both.count(1);
    let before = both.unit.state();
    assert_eq!(both.step_unit(), fmi2Error);
    let said = both.unit.messages();
    assert!(said[0].2.contains("correction.position_north_m = 2000000: must be from"), "{said:?}");
    assert!(both.unit.state() == before);
    far.errors.position_n.y = 0.0;
    far.sensors.accel_bias.x = 2e4;
    both.set(&far);
    assert_eq!(both.step_unit(), fmi2Error);
    let said = both.unit.messages();
    let words = "compensation.accelerometer_bias_m_s2[1] = 20000: must be from";
    assert!(said[0].2.contains(words), "{said:?}");
    both.set(&Correction::default());
    both.step();
}

#[test]
fn updates_of_a_scene_are_made() {
    let mut both = Both::new("[[update]]\nkind = \"position\"\nat_s = 0.25\nsigma_m = 5\n");
    let mut east_m = Vec::new();
    for _ in 0..40 {
        both.step();
        east_m.push(both.unit.reals(&both.outputs[0])[0]);
    }
    // The interval behind that of the update shows it.
    assert!(east_m[32] > 990.0 && east_m[33].abs() < 50.0, "{east_m:?}");
}
