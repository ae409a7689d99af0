//! Calls that no master should make. Each is refused with a status and one sentence.

use std::ffi::{CString, c_char, c_int};
use std::ptr;

use sins_fmu::get_set::*;
use sins_fmu::interface::*;
use sins_fmu::states::*;
use sins_fmu::steps::*;

use crate::support::{AT_REST, Unit, guid, inputs, reference, variables};

fn step(unit: &Unit, time_s: f64) -> c_int {
    unsafe { fmi2DoStep(unit.component, time_s, 0.01, 1) }
}

/// The only message of the unit.
fn sentence(unit: &Unit) -> String {
    let mut messages = unit.messages();
    assert_eq!(messages.len(), 1, "{messages:?}");
    messages.remove(0).2
}

#[test]
fn null_pointers() {
    let unit = Unit::flying(|_| ());
    let (component, references) = (unit.component, inputs());
    let (references, count) = (references.as_ptr(), references.len());
    let before = unit.state();
    type Call = Box<dyn Fn() -> c_int>;
    let calls: [(&str, Call); 14] = unsafe {
        [
            ("SetReal", Box::new(move || fmi2SetReal(component, references, count, ptr::null()))),
            ("SetReal", Box::new(move || fmi2SetReal(component, ptr::null(), count, AT_REST.as_ptr()))),
            ("GetReal", Box::new(move || fmi2GetReal(component, references, count, ptr::null_mut()))),
            ("GetInteger", Box::new(move || fmi2GetInteger(component, ptr::null(), 1, &mut 0))),
            ("SetInteger", Box::new(move || fmi2SetInteger(component, references, 1, ptr::null()))),
            ("GetBoolean", Box::new(move || fmi2GetBoolean(component, references, 1, ptr::null_mut()))),
            ("SetString", Box::new(move || fmi2SetString(component, references, 1, &ptr::null()))),
            ("GetString", Box::new(move || fmi2GetString(component, references, 1, ptr::null_mut()))),
            ("GetFMUstate", Box::new(move || fmi2GetFMUstate(component, ptr::null_mut()))),
            ("SetFMUstate", Box::new(move || fmi2SetFMUstate(component, ptr::null_mut()))),
            ("SerializedFMUstateSize", {
                Box::new(move || fmi2SerializedFMUstateSize(component, ptr::null_mut(), &mut 0))
            }),
            ("SerializeFMUstate", {
                Box::new(move || fmi2SerializeFMUstate(component, ptr::null_mut(), &mut 0, 1))
            }),
            ("DeSerializeFMUstate", {
                Box::new(move || fmi2DeSerializeFMUstate(component, ptr::null(), 9, &mut ptr::null_mut()))
            }),
            ("SetDebugLogging", Box::new(move || fmi2SetDebugLogging(component, 1, 1, &ptr::null()))),
        ]
    };
    for (name, call) in calls {
        assert_eq!(call(), fmi2Error, "{name}");
        let text = sentence(&unit);
        assert!(text.starts_with(&format!("fmi2{name}: ")) && text.contains("null pointer"), "{text}");
    }
    assert_eq!(unit.state(), before);
    unsafe {
        assert_eq!(fmi2SetReal(component, ptr::null(), 0, ptr::null()), fmi2OK);
        assert_eq!(fmi2FreeFMUstate(component, ptr::null_mut()), fmi2OK);
        assert_eq!(fmi2DoStep(ptr::null_mut(), 0.0, 0.0, 0), fmi2Error);
        assert_eq!(fmi2SetReal(ptr::null_mut(), ptr::null(), 0, ptr::null()), fmi2Error);
        fmi2FreeInstance(ptr::null_mut());
    }
}

#[test]
fn instances_that_are_not_made() {
    let functions = fmi2CallbackFunctions {
        logger: None,
        allocateMemory: None,
        freeMemory: None,
        stepFinished: None,
        componentEnvironment: ptr::null_mut(),
    };
    let own = CString::new(guid()).unwrap();
    let other = c"{00000000-0000-0000-0000-000000000000}";
    let make = |name: *const c_char, kind, guid: *const c_char, functions| unsafe {
        fmi2Instantiate(name, kind, guid, ptr::null(), functions, 0, 1)
    };
    assert!(make(c"a".as_ptr(), 1, other.as_ptr(), &functions).is_null(), "another guid");
    assert!(make(c"a".as_ptr(), 1, ptr::null(), &functions).is_null(), "no guid");
    assert!(make(c"a".as_ptr(), 0, own.as_ptr(), &functions).is_null(), "model exchange");
    assert!(make(c"a".as_ptr(), 1, own.as_ptr(), ptr::null()).is_null(), "no functions");
    let nameless = make(ptr::null(), 1, own.as_ptr(), &functions);
    assert!(!nameless.is_null());
    unsafe {
        assert_eq!(fmi2DoStep(nameless, 0.0, 0.0, 0), fmi2Error, "without a logger too");
        fmi2FreeInstance(nameless);
    }
}

#[test]
fn a_group_of_inputs_is_complete_or_off() {
    let unit = Unit::flying(|_| ());
    let needed =
        [0, 1, 2, reference("truth.roll_rad"), reference("truth.pitch_rad"), reference("truth.heading_rad")];
    for missing in 0..needed.len() {
        let unit = Unit::flying(|_| ());
        let others: Vec<u32> = (0..needed.len()).filter(|&at| at != missing).map(|at| needed[at]).collect();
        assert_eq!(unit.set_reals(&others, &[0.1; 5]), fmi2OK);
        assert_eq!(step(&unit, 0.0), fmi2Error);
        let name = &variables()[needed[missing] as usize].name;
        assert!(sentence(&unit).contains(&format!("{name} is not connected")), "{name}");
    }
    assert_eq!(unit.set_reals(&needed, &[0.1; 6]), fmi2OK);
    assert_eq!(step(&unit, 0.0), fmi2OK, "without velocity");
    assert_eq!(unit.set_reals(&[reference("truth.velocity_up_m_s")], &[0.0]), fmi2OK);
    assert_eq!(step(&unit, 0.01), fmi2Error);
    assert!(sentence(&unit).contains("truth.velocity_east_m_s is not connected: the velocity is incomplete"));
}

/// References of all inputs of the truth: the first reals.
fn truth() -> Vec<u32> {
    variables()
        .iter()
        .filter(|variable| variable.name.starts_with("truth."))
        .map(|variable| variable.reference)
        .collect()
}

/// A tool that sets every input: position and attitude of a flight of 200 m/s to the east in a turn of 1 °/s, and 0 for what is not
/// connected. Position and attitude errors at its end, and the messages.
fn flown_with_zeros(switches: &[(&str, bool)]) -> (Vec<f64>, Vec<String>) {
    let unit = Unit::flying(|unit| {
        for &(name, is_on) in switches {
            let status = unsafe { fmi2SetBoolean(unit.component, &reference(name), 1, &c_int::from(is_on)) };
            assert_eq!(status, fmi2OK);
        }
    });
    let (radius_m, rate_rad_s) = (200.0 / 1_f64.to_radians(), 1_f64.to_radians());
    for k in 0..3000 {
        let turned = rate_rad_s * 0.01 * f64::from(k);
        let (east_m, north_m) = (radius_m * turned.sin(), radius_m * (1.0 - turned.cos()));
        let mut inputs = vec![0.0; truth().len()];
        inputs[0] = north_m / 6_335_439.3;
        inputs[1] = east_m / 6_378_137.0;
        inputs[5] = core::f64::consts::FRAC_PI_2 - turned;
        assert_eq!(unit.set_reals(&truth(), &inputs), fmi2OK);
        assert_eq!(step(&unit, 0.01 * f64::from(k)), fmi2OK, "{:?}", unit.messages());
    }
    let errors =
        ["errors.position_east_m", "errors.position_north_m", "errors.misalignment_up_rad"].map(reference);
    (unit.reals(&errors), unit.messages().into_iter().map(|message| message.2).collect())
}

/// Inputs that are not connected and are set to 0 do not count where their parameter says so; where they count, there are warnings.
#[test]
fn zeros_of_inputs_that_are_not_connected() {
    let off = ["use_velocity", "use_rates", "use_forces", "use_temperature"].map(|name| (name, false));
    let (errors, said) = flown_with_zeros(&off);
    assert!(errors.iter().all(|error| error.abs() < 1e-3), "{errors:?}");
    assert!(said.is_empty(), "{said:?}");
    let (wrong, said) = flown_with_zeros(&[]);
    for (text, name) in said.iter().zip(["use_velocity", "use_rates", "use_forces"]) {
        assert!(
            text.ends_with(&format!("if it is not connected, set {name} to false"))
                || text.ends_with(&format!("if they are not connected, set {name} to false")),
            "{text}"
        );
    }
    assert!(said.len() == 4 && said[3].starts_with("truth: velocity contradicts the positions"), "{said:?}");
    assert!(wrong[0].abs() > 1e3, "{wrong:?}");
    println!("off {errors:?}, on {wrong:?}");
    for at in 0..off.len() {
        let others: Vec<_> =
            off.iter().enumerate().filter(|(k, _)| *k != at).map(|(_, switch)| *switch).collect();
        let (_, said) = flown_with_zeros(&others);
        assert_eq!(
            said.iter().filter(|text| text.contains(off[at].0)).count(),
            usize::from(at < 3),
            "{said:?}"
        );
        let judged = said.iter().filter(|text| text.starts_with("truth: ")).count();
        assert_eq!((said.len() - judged, judged), (usize::from(at < 3), usize::from(at == 0)), "{said:?}");
    }
}

#[test]
fn categories_of_messages() {
    let unit = Unit::flying(|_| ());
    let error = c"logStatusError".as_ptr();
    let switch = |on, names: &[*const c_char]| unsafe {
        fmi2SetDebugLogging(unit.component, on, names.len(), names.as_ptr())
    };
    assert_eq!(switch(0, &[error]), fmi2OK);
    assert_eq!(step(&unit, 0.0), fmi2Error);
    assert!(unit.messages().is_empty(), "switched off");
    assert_eq!(switch(1, &[error]), fmi2OK);
    assert_eq!(step(&unit, 0.0), fmi2Error);
    assert_eq!(unit.messages()[0].1, "logStatusError");
    assert_eq!(switch(1, &[c"logEvents".as_ptr()]), fmi2Error);
    assert!(sentence(&unit).contains("logEvents"));

    // A gap is a warning.
    assert_eq!(unit.set_reals(&inputs(), &AT_REST), fmi2OK);
    assert_eq!(step(&unit, 0.0), fmi2OK);
    assert_eq!(step(&unit, 0.01), fmi2OK);
    assert_eq!(step(&unit, 0.6), fmi2OK);
    let (status, category, text) = unit.messages().remove(0);
    assert_eq!((status, category.as_str()), (fmi2Warning, "logStatusWarning"), "{text}");
    assert_eq!(switch(0, &[]), fmi2OK);
    assert_eq!(step(&unit, 1.2), fmi2OK);
    assert!(unit.messages().is_empty(), "all off");
}

/// A turn beyond 0.1 rad in a step gives one warning; smaller turns give none.
#[test]
fn a_large_turn_is_reported_once() {
    let unit = Unit::flying(|_| ());
    for (index, heading) in [0.0, 0.09, 0.18, 0.29, 0.40].into_iter().enumerate() {
        let mut inputs_now = AT_REST;
        inputs_now[5] = heading;
        assert_eq!(unit.set_reals(&inputs(), &inputs_now), fmi2OK);
        assert_eq!(step(&unit, 0.1 * index as f64), fmi2OK, "{:?}", unit.messages());
        let said: Vec<_> = unit.messages().into_iter().map(|message| (message.1, message.2)).collect();
        assert_eq!(said.len(), usize::from(index == 3), "{said:?}");
        assert!(
            said.iter().all(|(category, text)| category == "logStatusWarning" && text.contains("0.11 rad"))
        );
    }
}

#[test]
fn calls_out_of_place() {
    let unit = Unit::new(None);
    unsafe {
        assert_eq!(fmi2DoStep(unit.component, 0.0, 0.01, 1), fmi2Error);
        assert_eq!(fmi2ExitInitializationMode(unit.component), fmi2Error);
        assert_eq!(fmi2Terminate(unit.component), fmi2Error);
        assert_eq!(fmi2CancelStep(unit.component), fmi2Error);
        assert_eq!(unit.messages().len(), 4);
        assert_eq!(fmi2EnterInitializationMode(unit.component), fmi2OK);
        assert_eq!(fmi2SetupExperiment(unit.component, 0, 0.0, 0.0, 0, 0.0), fmi2Error);
        assert_eq!(fmi2ExitInitializationMode(unit.component), fmi2OK);
        assert_eq!(fmi2Terminate(unit.component), fmi2OK);
        assert_eq!(fmi2DoStep(unit.component, 0.0, 0.01, 1), fmi2Error);
        assert_eq!(fmi2Reset(unit.component), fmi2OK);
        assert_eq!(fmi2EnterInitializationMode(unit.component), fmi2OK);
    }
}

/// The limits in the description are the limits of the library: values at them are accepted, values beyond are refused.
#[test]
fn limits_of_sensor_parameters() {
    let described = variables();
    let of_gyro = described.iter().filter(|variable| {
        ["gyro.", "accelerometer."].iter().any(|section| variable.name.starts_with(section))
            && variable.element == "Real"
    });
    let mut tried = 0;
    for variable in of_gyro {
        let (low, high) = variable.limits.unwrap_or_else(|| panic!("{} has limits", variable.name));
        // A Gauss-Markov process needs both its size and its correlation time, and the diagonal of the misalignment is 0.
        if variable.name.contains("markov") || variable.name.contains("misalignment") {
            continue;
        }
        let unit = Unit::flying(|_| ());
        for value in [high, low] {
            assert_eq!(unit.set_reals(&[variable.reference], &[value]), fmi2OK, "{}: {value}", variable.name);
        }
        for value in [high + high.abs() * 1e-9, low - low.abs().max(1.0)] {
            let status = unit.set_reals(&[variable.reference], &[value]);
            assert_eq!(status, fmi2Discard, "{}: {value}", variable.name);
        }
        tried += 1;
    }
    assert!(tried > 100, "{tried}");
}

/// A refused parameter is named as in the description: elements from 1, matrices by row and column, failures by their slot.
#[test]
fn refused_parameters_have_their_names() {
    let unit = Unit::flying(|_| ());
    for (name, value, words) in [
        ("gyro.bias_deg_h[1]", 1e9, " = 1e9: must be from -2.06264e7 to 2.06264e7"),
        ("gyro.misalignment_arcsec[2,3]", 1e9, ""),
        ("gyro.misalignment_arcsec[2,2]", 9.0, " = 9: must be 0 on the diagonal"),
    ] {
        assert_eq!(unit.set_reals(&[reference(name)], &[value]), fmi2Discard, "{name}");
        let said = sentence(&unit);
        assert!(said.starts_with(&format!("fmi2SetReal: {name}{words}")), "{said}");
    }
    assert_eq!(
        unsafe { fmi2SetInteger(unit.component, [reference("failure[3].kind")].as_ptr(), 1, [2].as_ptr()) },
        fmi2OK
    );
    assert_eq!(unit.set_reals(&[reference("failure[3].from_s")], &[-1.0]), fmi2Discard);
    assert_eq!(sentence(&unit), "fmi2SetReal: failure[3].from_s = -1: must be from 0 to 1e9");
}

/// A state with any damaged bit, or without its end, is refused and changes nothing.
#[test]
fn damaged_states_are_refused() {
    let unit = Unit::flying(|_| {});
    unit.set_reals(&inputs(), &AT_REST);
    for k in 0..3 {
        assert_eq!(step(&unit, 0.01 * f64::from(k)), fmi2OK);
    }
    let good = unit.state();
    let load = |state: &[u8]| unsafe {
        let mut image = ptr::null_mut();
        fmi2DeSerializeFMUstate(unit.component, state.as_ptr().cast(), state.len(), &mut image)
    };
    for at in (0..good.len()).step_by(41).chain(good.len() - 8..good.len()) {
        let mut damaged = good.clone();
        damaged[at] ^= 1 << (at % 8);
        assert_ne!(load(&damaged), fmi2OK, "byte {at} of {}", good.len());
        assert_ne!(load(&good[..at]), fmi2OK);
    }
    assert!(unit.state() == good);
}

/// Without a box, an entry at the panel gives a warning.
#[test]
fn an_entry_without_a_box_is_a_warning() {
    let unit = Unit::flying(|_| {});
    unit.set_reals(&inputs(), &AT_REST);
    assert_eq!((step(&unit, 0.0), step(&unit, 0.01)), (fmi2OK, fmi2OK));
    let count = reference("panel.position_count");
    assert_eq!(unsafe { fmi2SetInteger(unit.component, &count, 1, &1) }, fmi2OK);
    assert!(unit.messages().is_empty());
    assert_eq!(step(&unit, 0.02), fmi2OK);
    assert_eq!(
        sentence(&unit),
        "panel.position_count: nothing is entered: without unit.start there is no box"
    );
}

/// Messages about a sample have the names of the inputs.
#[test]
fn refused_samples_have_their_names() {
    let unit = Unit::flying(|_| {});
    for (place, value, words) in [
        (
            0,
            47.5,
            "truth.latitude_rad = 47.5: must be from -1.5707963277948966 to 1.5707963277948966; is it in degrees?",
        ),
        (2, 3e6, "truth.height_m = 3000000: must be from -20000 to 2000000"),
        (7, 3e4, "truth.velocity_north_m_s = 30000: must be from -20000 to 20000"),
    ] {
        let mut values = AT_REST;
        values[place] = value;
        unit.set_reals(&inputs(), &values);
        assert_eq!(step(&unit, 0.0), fmi2Error);
        assert!(sentence(&unit).ends_with(words), "{words}");
    }
    unit.set_reals(&inputs(), &AT_REST);
    assert_eq!((step(&unit, 0.0), step(&unit, 9.0)), (fmi2OK, fmi2Error));
    assert!(
        sentence(&unit).contains("currentCommunicationPoint = 9: the gap after the last accepted sample")
    );
}
