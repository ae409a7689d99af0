//! Random scenes with unit, panel, updates, failures and temperature, fed with the samples of their flights: the unit flies to the bits of
//! the library.

use std::ffi::CString;
use std::sync::Arc;

use sins::ErrorSource;
use sins::scene::{FlightSource, Play, Scene, Source};
use sins::truth::FlightSample;
use sins_fmu::get_set::fmi2SetString;
use sins_fmu::interface::{fmi2Error, fmi2OK};
use sins_fmu::steps::fmi2DoStep;

use crate::random_scenes::{RandomScene, random_scene};
use crate::support::{Unit, inputs, reference, variables};

fn references(begin: &str) -> Vec<u32> {
    variables().iter().filter(|one| one.name.starts_with(begin)).map(|one| one.reference).collect()
}

fn inputs_of(sample: &FlightSample) -> [f64; 9] {
    let (place, euler, v) = (sample.place, sample.euler, sample.v_n.unwrap());
    [
        place.latitude_rad,
        place.longitude_rad,
        place.height_m,
        euler.roll,
        euler.pitch,
        euler.heading,
        v.x,
        v.y,
        v.z,
    ]
}

/// The errors of the navigation, and what the unit shows.
fn of_library(play: &Play) -> Vec<u64> {
    let (_, errors) = play.simulator().errors(ErrorSource::Navigation).unwrap().unwrap();
    let mut values =
        [errors.position_n, errors.velocity_n, errors.misalignment_n].map(<[f64; 3]>::from).concat();
    if let Some(unit) = play.unit() {
        let shown = unit.navigation(play.simulator()).unwrap();
        values.extend([shown.place.latitude_rad, shown.place.longitude_rad, shown.place.height_m]);
        values.extend(<[f64; 3]>::from(shown.v_n));
        values.extend([shown.euler.roll, shown.euler.pitch, shown.euler.heading]);
    }
    values.into_iter().map(f64::to_bits).collect()
}

#[test]
fn random_scenes_fly_to_the_bits_of_the_library() {
    let (errors, shown) = (references("errors."), references("shown."));
    let (mut units, mut stopped) = (0, 0);
    for seed in 2000..2060 {
        let RandomScene { text, log } = random_scene(seed, false);
        assert_eq!(log, None);
        let mut scene = Scene::parse(text.as_bytes()).unwrap();
        let source = Source::flight_of(&scene).unwrap();
        let count = source.samples(&scene).unwrap().unwrap().count;
        let rate_hz = scene.rate_hz;
        // The unit takes samples from outside, without a stated rate.
        scene.flight = FlightSource::Log("inputs".to_owned());
        let mut play = Play::new(Arc::new(scene), Source::Host).unwrap();
        let unit = Unit::flying(|unit| {
            let (place, text) = (reference("scene_text"), CString::new(text.as_str()).unwrap());
            assert_eq!(unsafe { fmi2SetString(unit.component, &place, 1, &text.as_ptr()) }, fmi2OK);
        });
        for index in 0..count {
            let sample = source.sample(index, rate_hz).unwrap();
            unit.set_reals(&inputs(), &inputs_of(&sample));
            let status = unsafe { fmi2DoStep(unit.component, sample.time_s, 1.0 / rate_hz, 1) };
            if let Err(error) = play.push(&sample) {
                // An entry at the wrong moment.
                assert_eq!(status, fmi2Error, "{seed}: {error}");
                stopped += 1;
                break;
            }
            assert_eq!(status, fmi2OK, "{seed}: {:?}", unit.messages());
            if index > 0 && (index % 50 == 0 || index + 1 == count) {
                let mut found = unit.reals(&errors[..9]);
                if play.unit().is_some() {
                    found.extend(&unit.reals(&shown)[..9]);
                }
                let found: Vec<u64> = found.into_iter().map(f64::to_bits).collect();
                assert_eq!(found, of_library(&play), "{seed}, sample {index}\n{text}");
            }
        }
        units += usize::from(play.unit().is_some());
    }
    println!("60 scenes: {units} units, {stopped} stopped");
    assert!(units > 15 && stopped < 15);
}
