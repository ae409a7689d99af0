//! The box: an alignment by the inputs of the panel, to the bit as in the library.

use std::ffi::{CString, c_int};

use sins::Simulator;
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::scene::Scene;
use sins::truth::FlightSample;
use sins::unit::{Mode, Power, State, Unit as UnitOfLibrary};
use sins_fmu::get_set::{fmi2GetBoolean, fmi2GetInteger, fmi2SetBoolean, fmi2SetInteger, fmi2SetString};
use sins_fmu::interface::{fmi2Discard, fmi2Error, fmi2OK};
use sins_fmu::states::{fmi2DeSerializeFMUstate, fmi2FreeFMUstate, fmi2SetFMUstate};
use sins_fmu::steps::fmi2DoStep;

use crate::support::{AT_REST, Unit, inputs, reference, variables};

const SCENE: &str =
    "[flight]\nfile = \"log\"\n[gyro]\npreset = \"navigation\"\n[accelerometer]\npreset = \"navigation\"\n";
const BOX: &str = "[unit]\nstart = \"off\"\nalignment_s = 60\nbattery_s = 5\n";
const STEP_S: f64 = 0.125;

/// Values of an enumeration, from 1, behind the first that leaves the panel to the scene.
const ALIGN: c_int = 3;
const NAV: c_int = 4;
const BATTERY: c_int = 3;

fn flying(text: &str) -> Unit {
    Unit::flying(|unit| {
        let (place, text) = (reference("scene_text"), CString::new(text).unwrap());
        assert_eq!(unsafe { fmi2SetString(unit.component, &place, 1, &text.as_ptr()) }, fmi2OK);
    })
}

fn set(unit: &Unit, name: &str, value: c_int) -> c_int {
    unsafe { fmi2SetInteger(unit.component, &reference(name), 1, &value) }
}

fn integer(unit: &Unit, name: &str) -> c_int {
    let mut value = 0;
    assert_eq!(unsafe { fmi2GetInteger(unit.component, &reference(name), 1, &mut value) }, fmi2OK);
    value
}

fn flag(unit: &Unit, name: &str) -> bool {
    let mut value = 0;
    assert_eq!(unsafe { fmi2GetBoolean(unit.component, &reference(name), 1, &mut value) }, fmi2OK);
    value != 0
}

fn step(unit: &Unit, step: u32) -> c_int {
    unit.set_reals(&inputs(), &AT_REST);
    unsafe { fmi2DoStep(unit.component, f64::from(step) * STEP_S, STEP_S, 1) }
}

/// Outputs that the box shows, in the order of the description.
fn shown_references() -> Vec<u32> {
    variables().iter().filter(|one| one.name.starts_with("shown.")).map(|one| one.reference).collect()
}

/// The same flight by the library.
struct Library {
    scene: Scene,
    simulator: Box<[Simulator; 1]>,
    unit: UnitOfLibrary,
}

impl Library {
    fn new(text: &str) -> Self {
        let scene = Scene::parse(text.as_bytes()).unwrap();
        let simulator = scene.simulator().unwrap();
        let unit = scene.unit().unwrap().unwrap();
        Self { scene, simulator, unit }
    }

    fn step(&mut self, step: u32) {
        self.fly(f64::from(step) * STEP_S, &AT_REST);
    }

    fn fly(&mut self, time_s: f64, inputs: &[f64; 9]) {
        let [latitude_rad, longitude_rad, height_m, roll, pitch, heading, v_n @ ..] = *inputs;
        let place = Geodetic { latitude_rad, longitude_rad, height_m };
        let at_rest = FlightSample::at_rest(time_s, place, Euler { roll, pitch, heading });
        let mut sample = FlightSample { v_n: Some(v_n.into()), ..at_rest };
        let [simulator] = &mut *self.simulator;
        self.scene.prepare(simulator, 0.0, &mut sample).unwrap();
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        if time_s > 0.0 {
            self.scene.update_unit(&mut self.unit, simulator, 0.0).unwrap();
        }
    }

    fn shown(&self) -> Vec<f64> {
        let shown = self.unit.navigation(&self.simulator[0]).unwrap();
        let (place, euler) = (shown.place, shown.euler);
        [
            [place.latitude_rad, place.longitude_rad, place.height_m],
            shown.v_n.into(),
            [euler.roll, euler.pitch, euler.heading],
            shown.rate_b.into(),
            shown.force_b.into(),
        ]
        .concat()
    }
}

/// Off, aligned by the panel, navigation, on battery until it is empty: the outputs are those of the library in each step, also behind a
/// state that was saved in the alignment.
#[test]
fn an_alignment_by_the_panel_is_that_of_the_library() {
    let text = format!("{SCENE}{BOX}");
    let (mut unit, mut library) = (flying(&text), Library::new(&text));
    let references = shown_references();
    assert_eq!(references.len(), 15);
    let position = ["panel.latitude_rad", "panel.longitude_rad"].map(reference);
    let mut states = Vec::new();
    for k in 0..900 {
        match k {
            10 => {
                set(&unit, "panel.mode", ALIGN);
                library.unit.select(Mode::Align);
            }
            100 => {
                unit.set_reals(&position, &AT_REST[..2]);
                set(&unit, "panel.position_count", 1);
                library.unit.enter_position(AT_REST[0], AT_REST[1]).unwrap();
            }
            // Another instance goes on from the middle of the alignment.
            300 => {
                let state = unit.state();
                unit = flying(&text);
                let mut handle = std::ptr::null_mut();
                unsafe {
                    let bytes = state.as_ptr().cast();
                    assert_eq!(
                        fmi2DeSerializeFMUstate(unit.component, bytes, state.len(), &mut handle),
                        fmi2OK
                    );
                    assert_eq!(fmi2SetFMUstate(unit.component, handle), fmi2OK);
                    assert_eq!(fmi2FreeFMUstate(unit.component, &mut handle), fmi2OK);
                }
                assert_eq!(unit.state(), state);
            }
            700 => {
                set(&unit, "panel.mode", NAV);
                library.unit.select(Mode::Navigate);
            }
            800 => {
                set(&unit, "panel.power", BATTERY);
                library.unit.set_power(Power::Battery);
            }
            _ => {}
        }
        assert_eq!(step(&unit, k), fmi2OK, "{k}: {:?}", unit.messages());
        library.step(k);
        assert_eq!(unit.reals(&references), library.shown(), "step {k}");
        let status = library.unit.status();
        assert_eq!(integer(&unit, "status.state"), status.state as c_int + 1, "step {k}");
        assert_eq!(unit.reals(&[reference("status.to_go_s")]), [status.to_go_s]);
        for (name, expected) in [
            ("status.align", status.align),
            ("status.fault", status.fault),
            ("status.on_battery", status.on_battery),
            ("status.no_position", status.reasons.no_position),
            ("status.battery_empty", status.reasons.battery_empty),
            ("status.valid_heading", status.validity.heading),
            ("status.valid_velocity", status.validity.velocity),
        ] {
            assert_eq!(flag(&unit, name), expected, "{name} in step {k}");
        }
        if states.last() != Some(&status.state) {
            states.push(status.state);
        }
    }
    let course = [
        State::Off,
        State::Test,
        State::CoarseAlignment,
        State::FineAlignment,
        State::Ready,
        State::Navigation,
        State::Off,
    ];
    assert_eq!(states, course);
}

/// A wide turn at 100 m/s from a point of the equator, with a fix at every eighth step: the outputs are those of the library in each
/// step, and the box navigates in the end.
#[test]
fn an_alignment_in_flight_takes_the_fixes_of_the_inputs() {
    let text = format!(
        "{SCENE}[unit]\nstart = \"off\"\nalignment = \"in_flight\"\ncoarse_alignment_s = 10\nin_flight_alignment_s = 60\n"
    );
    let (unit, mut library) = (flying(&text), Library::new(&text));
    let fix = ["latitude_rad", "longitude_rad", "height_m"].map(|name| reference(&format!("fix.{name}")));
    let of_velocity = [1, 2, 3].map(|k| reference(&format!("fix.velocity_enu_m_s[{k}]")));
    set(&unit, "panel.mode", NAV);
    library.unit.select(Mode::Navigate);
    for k in 0..800 {
        let heading = 0.1 * f64::from(k) * STEP_S;
        let (sin, cos) = heading.sin_cos();
        let (latitude_rad, longitude_rad) = (1000.0 * sin / 6_335_439.0, 1000.0 * (1.0 - cos) / 6_378_137.0);
        let (place, v_n) = ([latitude_rad, longitude_rad, 0.0], [100.0 * sin, 100.0 * cos, 0.0]);
        let values =
            [latitude_rad, longitude_rad, 0.0, (10.0f64 / 9.78).atan(), 0.0, heading, v_n[0], v_n[1], 0.0];
        unit.set_reals(&inputs(), &values);
        let has_fix = k % 8 == 0 && k > 0;
        if has_fix {
            unit.set_reals(&fix, &place);
            unit.set_reals(&of_velocity, &v_n);
            set(&unit, "fix.count", k);
        }
        assert_eq!(unsafe { fmi2DoStep(unit.component, f64::from(k) * STEP_S, STEP_S, 1) }, fmi2OK);
        library.fly(f64::from(k) * STEP_S, &values);
        if has_fix {
            let place = Geodetic { latitude_rad, longitude_rad, height_m: 0.0 };
            library.unit.push_fix(&mut library.simulator[0], place, v_n.into()).unwrap();
        }
        assert_eq!(unit.reals(&shown_references()), library.shown(), "step {k}");
    }
    assert_eq!(library.unit.status().state, State::Navigation);
}

/// A scene without a unit has no box: the panel does nothing, and the outputs of the navigation are the same.
#[test]
fn without_a_box_the_panel_does_nothing() {
    let [one, other] = [false, true].map(|is_pressed| {
        let unit = flying(SCENE);
        if is_pressed {
            set(&unit, "panel.mode", NAV);
            set(&unit, "panel.position_count", 5);
        }
        for k in 0..20 {
            assert_eq!(step(&unit, k), fmi2OK);
        }
        assert_eq!((integer(&unit, "status.state"), flag(&unit, "status.valid_position")), (1, false));
        let outputs = variables();
        let outputs = outputs.iter().filter(|one| one.causality == "output" && one.element == "Real");
        unit.reals(&outputs.map(|one| one.reference).collect::<Vec<_>>())
    });
    assert_eq!(one, other);
}

/// An entry that the box refuses is said and flown on; a selector position that does not exist is an error that changes nothing.
#[test]
fn refused_entries_are_said() {
    let unit = flying(&format!("{SCENE}{BOX}"));
    for k in 0..4 {
        assert_eq!(step(&unit, k), fmi2OK);
    }
    unit.messages();
    for (name, k, words) in [
        ("panel.position_count", 4, "panel.position_count: nothing is entered: "),
        ("panel.heading_count", 5, "panel.heading_count: nothing is entered: "),
    ] {
        set(&unit, name, 1);
        assert_eq!(step(&unit, k), fmi2OK);
        let messages = unit.messages();
        assert!(messages.len() == 1 && messages[0].2.contains(words), "{messages:?}");
    }
    set(&unit, "panel.position_count", 2);
    set(&unit, "panel.heading_count", 2);
    set(&unit, "fix.count", 2); // no alignment in flight: nothing is to be said
    assert_eq!(step(&unit, 6), fmi2OK);
    let messages = unit.messages();
    assert!(messages.len() == 2, "each refused entry is said: {messages:?}");
    let before = unit.state();
    for wrong in [0, 6, c_int::MIN, c_int::MAX] {
        let status = set(&unit, "panel.mode", wrong);
        let refused = if status == fmi2OK { step(&unit, 7) } else { status };
        assert!([fmi2Error, fmi2Discard].contains(&refused), "{wrong}");
        assert!(unit.messages()[0].2.contains("panel.mode"), "{wrong}");
    }
    set(&unit, "panel.mode", 1);
    // A number out of its range is an error in any state, and names the input.
    for (count, name, wrong) in [
        ("panel.position_count", "panel.latitude_rad", 1.6),
        ("panel.position_count", "panel.longitude_rad", f64::NAN),
        ("panel.heading_count", "panel.heading_rad", 6.3),
        ("fix.count", "fix.latitude_rad", 1.6),
        ("fix.count", "fix.velocity_enu_m_s[2]", f64::NAN),
    ] {
        set(&unit, count, 3);
        unit.set_reals(&[reference(name)], &[wrong]);
        assert_eq!(step(&unit, 7), fmi2Error, "{name}");
        let messages = unit.messages();
        assert!(messages[0].2.contains(&format!("{name} = {wrong}: must be")), "{messages:?}");
        unit.set_reals(&[reference(name)], &[0.0]);
        set(&unit, count, 2);
    }
    assert_eq!(unit.reals(&shown_references()), vec![0.0; 15]);
    unit.set_reals(&inputs(), &AT_REST);
    assert_eq!(unit.state(), before);
    // The test is shown as long as it is pressed.
    let on = 1;
    unsafe { fmi2SetBoolean(unit.component, &reference("panel.test"), 1, &on) };
    assert_eq!(step(&unit, 7), fmi2OK);
    assert!(flag(&unit, "status.in_test"));
}
