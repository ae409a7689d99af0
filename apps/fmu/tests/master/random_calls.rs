//! Calls in random order with random values, also with cut and forged states. Nothing crashes; a refused call gives one sentence
//! and changes nothing; a saved state loads to the same bytes; after an accepted step every output is finite.
//!
//! `FMU_SEQUENCES=100000 FMU_FIRST=0 cargo test --release -p sins-fmu --test master random_calls::` runs for hours, with other
//! seeds.

use std::ffi::{CString, c_int};
use std::ptr;

use sins_fmu::get_set::*;
use sins_fmu::interface::*;
use sins_fmu::states::*;
use sins_fmu::steps::*;

use crate::draws::Draws;
use crate::fnv::Fnv;
use crate::support::{AT_REST, Described, Unit, inputs, variables};

impl Draws {
    /// A number, mostly within the limits, sometimes not finite.
    fn real(&mut self, (low, high): (f64, f64)) -> f64 {
        const ODD: [f64; 9] =
            [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -f64::MAX, 5e-324, -0.0, 1e300, -1e300];
        match self.below(12) {
            0 => ODD[self.below(ODD.len())],
            1 => f64::from_bits(self.next()),
            2 => low,
            3 => high,
            4 => 0.0,
            _ => low + (high - low) * self.unit() * 10f64.powi(-(self.below(8) as i32)),
        }
    }
}

struct Master {
    random: Draws,
    unit: Unit,
    described: &'static [Described],
    outputs: Vec<u32>,
    images: Vec<Vec<u8>>,
    time_s: f64,
    calls: usize,
    refused: usize,
}

impl Master {
    fn new(seed: u64) -> Self {
        let described = variables();
        let is_output = |variable: &&Described| variable.causality == "output" && variable.element == "Real";
        let outputs = described.iter().filter(is_output).map(|variable| variable.reference).collect();
        let unit = if seed.is_multiple_of(2) { Unit::new(None) } else { Unit::flying(|_| ()) };
        let random = Draws::new(seed);
        Self { random, unit, described, outputs, images: Vec::new(), time_s: 0.0, calls: 0, refused: 0 }
    }

    /// Makes a random call and checks what holds after it.
    fn call(&mut self) {
        let before = self.unit.state();
        self.unit.messages();
        let (name, status) = self.any();
        let messages = self.unit.messages();
        self.calls += 1;
        assert!((fmi2OK..=fmi2Error).contains(&status), "{name}: {status} {messages:?}");
        if status != fmi2OK {
            self.refused += 1;
            assert_eq!(messages.len(), 1, "{name}: {messages:?}");
            assert_eq!(messages[0].0, status, "{name}");
            assert!(self.unit.state() == before, "{name} was refused and changed the unit: {messages:?}");
        } else if name == "fmi2DoStep" {
            let values = self.unit.reals(&self.outputs);
            assert!(values.iter().all(|value| value.is_finite()), "{values:?}");
        }
    }

    fn any(&mut self) -> (&'static str, c_int) {
        match self.random.below(20) {
            0..8 => self.step(),
            8..12 => self.set(),
            12 => self.get(),
            13..16 => self.keep_or_load(),
            16..18 => self.change_phase(),
            18 => self.ask(),
            _ => self.log(),
        }
    }

    /// Mostly continues from the last step at rest; otherwise random inputs, times and lengths.
    fn step(&mut self) -> (&'static str, c_int) {
        let component = self.unit.component;
        let mut values = AT_REST;
        values[3] = self.random.unit() * 0.01;
        if self.random.one_in(20) {
            let at = self.random.below(values.len());
            values[at] = self.random.real((-2.0, 2.0));
        }
        let status = self.unit.set_reals(&inputs(), &values);
        if status != fmi2OK {
            return ("fmi2SetReal", status);
        }
        let next_s = self.time_s + [0.01, 0.01, 0.02, 0.0, 0.3, -1.0, 1e4][self.random.below(7)];
        let time_s = if self.random.one_in(30) { self.random.real((-1e10, 1e10)) } else { next_s };
        let length_s = if self.random.one_in(10) { self.random.real((-1.0, 1.0)) } else { 0.01 };
        // A refused step does not undo the inputs that were set before.
        let before = self.unit.state();
        let status = unsafe { fmi2DoStep(component, time_s, length_s, 1) };
        if status == fmi2OK {
            self.time_s = time_s;
            return ("fmi2DoStep", status);
        }
        assert!(self.unit.state() == before, "a refused step changed the unit");
        assert_eq!(self.unit.messages().len(), 1);
        ("fmi2SetReal", fmi2OK)
    }

    fn set(&mut self) -> (&'static str, c_int) {
        let (component, random) = (self.unit.component, &mut self.random);
        let settable = |variable: &&Described| variable.causality != "output" && variable.element != "String";
        let all: Vec<&Described> = self.described.iter().filter(settable).collect();
        let variable = all[random.below(all.len())].clone();
        let bias = all.iter().find(|variable| variable.name == "gyro.bias_deg_h[1]").unwrap().reference;
        let reference = if random.one_in(30) { random.next() as u32 } else { variable.reference };
        // Sometimes two variables are set at once; the second one is a bias.
        let pair = [reference, bias];
        let count = if random.one_in(4) { 2 } else { 1 };
        unsafe {
            match variable.element.as_str() {
                "Real" => {
                    let limits = variable.limits.unwrap_or((-10.0, 10.0));
                    let values = [random.real(limits), random.unit()];
                    ("fmi2SetReal", fmi2SetReal(component, pair.as_ptr(), count, values.as_ptr()))
                }
                "Boolean" => {
                    let value = random.below(3) as c_int - 1;
                    ("fmi2SetBoolean", fmi2SetBoolean(component, &reference, 1, &value))
                }
                _ if random.one_in(4) => {
                    let texts =
                        ["", "patrol", "simulation2", "drone.toml", "[gyro]\nbias_deg_h = 1", "[", "飞"];
                    let text = CString::new(texts[random.below(texts.len())]).unwrap();
                    let reference = random.below(5) as u32;
                    ("fmi2SetString", fmi2SetString(component, &reference, 1, &text.as_ptr()))
                }
                _ => {
                    let value =
                        if random.one_in(4) { random.next() as c_int } else { random.below(8) as c_int };
                    ("fmi2SetInteger", fmi2SetInteger(component, &reference, 1, &value))
                }
            }
        }
    }

    fn get(&mut self) -> (&'static str, c_int) {
        let (component, random) = (self.unit.component, &mut self.random);
        let reference = random.below(400) as u32;
        let references = [0, reference];
        let (mut reals, mut integers, mut texts) = ([0.0; 2], [0; 2], [ptr::null(); 2]);
        let place = references.as_ptr();
        unsafe {
            match random.below(4) {
                0 => {
                    let status = fmi2GetReal(component, place, 2, reals.as_mut_ptr());
                    assert!(status == fmi2OK || reals == [0.0; 2], "a refused read writes nothing");
                    ("fmi2GetReal", status)
                }
                1 => ("fmi2GetInteger", fmi2GetInteger(component, place, 2, integers.as_mut_ptr())),
                2 => ("fmi2GetBoolean", fmi2GetBoolean(component, place, 2, integers.as_mut_ptr())),
                _ => ("fmi2GetString", fmi2GetString(component, place, 2, texts.as_mut_ptr())),
            }
        }
    }

    /// Keeps the state, or loads a kept state: whole, cut, or forged.
    fn keep_or_load(&mut self) -> (&'static str, c_int) {
        if self.images.is_empty() || self.random.one_in(3) {
            let image = self.unit.state();
            if self.images.len() > 4 {
                let at = self.random.below(5);
                self.images.swap_remove(at);
            }
            self.images.push(image);
            return ("fmi2GetFMUstate", fmi2OK);
        }
        let at = self.random.below(self.images.len());
        let mut image = self.images[at].clone();
        let is_whole = match self.random.below(4) {
            0 => {
                image.truncate(self.random.below(image.len()));
                false
            }
            1 => {
                let end = image.len() - 8;
                for _ in 0..=self.random.below(3) {
                    let at = self.random.below(end);
                    image[at] = self.random.next() as u8;
                }
                // With the right hash, or it would be refused before it is read.
                let hash = Fnv::of(&image[..end]);
                image[end..].copy_from_slice(&hash.to_le_bytes());
                false
            }
            _ => true,
        };
        let mut state = ptr::null_mut();
        let component = self.unit.component;
        let status = unsafe { fmi2DeSerializeFMUstate(component, image.as_ptr(), image.len(), &mut state) };
        if status != fmi2OK {
            assert!(!is_whole, "a state of this unit is taken: {:?}", self.unit.messages());
            assert!(state.is_null());
            return ("fmi2DeSerializeFMUstate", status);
        }
        let status = unsafe { fmi2SetFMUstate(component, state) };
        assert_eq!(unsafe { fmi2FreeFMUstate(component, &mut state) }, fmi2OK);
        if status == fmi2OK && is_whole {
            assert!(self.unit.state() == image, "a state saves to itself");
        }
        ("fmi2SetFMUstate", status)
    }

    fn change_phase(&mut self) -> (&'static str, c_int) {
        let component = self.unit.component;
        let start_s = self.random.real((0.0, 1e6));
        unsafe {
            match self.random.below(10) {
                0 => ("fmi2SetupExperiment", fmi2SetupExperiment(component, 0, 0.0, start_s, 0, 0.0)),
                1 => ("fmi2Terminate", fmi2Terminate(component)),
                2 => ("fmi2Reset", fmi2Reset(component)),
                3..6 => ("fmi2EnterInitializationMode", fmi2EnterInitializationMode(component)),
                _ => ("fmi2ExitInitializationMode", fmi2ExitInitializationMode(component)),
            }
        }
    }

    fn ask(&mut self) -> (&'static str, c_int) {
        let (component, kind) = (self.unit.component, self.random.below(5) as c_int);
        let (mut real, mut whole, mut text) = (0.0, 0, ptr::null());
        unsafe {
            match self.random.below(6) {
                0 => ("fmi2GetRealStatus", fmi2GetRealStatus(component, kind, &mut real)),
                1 => ("fmi2GetBooleanStatus", fmi2GetBooleanStatus(component, kind, &mut whole)),
                2 => ("fmi2GetStatus", fmi2GetStatus(component, kind, &mut whole)),
                3 => ("fmi2GetIntegerStatus", fmi2GetIntegerStatus(component, kind, &mut whole)),
                4 => ("fmi2GetStringStatus", fmi2GetStringStatus(component, kind, &mut text)),
                _ => ("fmi2CancelStep", fmi2CancelStep(component)),
            }
        }
    }

    /// Switches warnings. Errors stay on, because the test counts them.
    fn log(&mut self) -> (&'static str, c_int) {
        let names = [c"logStatusWarning".as_ptr(), c"logAll".as_ptr()];
        let (on, name) = (self.random.below(2) as c_int, names[self.random.below(2)]);
        ("fmi2SetDebugLogging", unsafe { fmi2SetDebugLogging(self.unit.component, on, 1, &name) })
    }
}

#[test]
fn random_calls() {
    let setting = |name: &str, default: u64| {
        std::env::var(name).map_or(default, |value| value.parse().expect("a whole number"))
    };
    let (first, sequences) = (setting("FMU_FIRST", 0), setting("FMU_SEQUENCES", 60));
    let (mut calls, mut refused, mut steps) = (0, 0, 0);
    for seed in first..first + sequences {
        println!("seed {seed}"); // shown if it fails
        let mut master = Master::new(seed);
        for _ in 0..200 {
            let before = master.time_s;
            master.call();
            steps += usize::from(master.time_s != before);
        }
        calls += master.calls;
        refused += master.refused;
    }
    println!("{calls} calls, {refused} refused, {steps} steps from seeds {first} on");
    assert!(refused > calls / 20 && steps > calls / 50, "{calls} calls, {refused} refused, {steps} steps");
}
