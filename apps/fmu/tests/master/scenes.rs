//! The scenes of the repository and random ones with unit, panel, updates, failures, temperature and logs, fed with the samples of their
//! flights: the unit flies to the bits of the library.

use std::ffi::CString;
use std::sync::Arc;

use sins::ErrorSource;
use sins::scene::{FlightSource, Play, Source};
use sins::truth::FlightSample;
use sins_fmu::get_set::fmi2SetString;
use sins_fmu::interface::{fmi2Error, fmi2OK};
use sins_fmu::steps::fmi2DoStep;

use crate::flown_scenes::{FlownScene, named_scenes, random_scene};
use crate::support::{Unit, reference, variables};

fn references(begin: &str) -> Vec<u32> {
    variables().iter().filter(|one| one.name.starts_with(begin)).map(|one| one.reference).collect()
}

/// The inputs that a sample has, and their values.
fn inputs_of(sample: &FlightSample) -> (Vec<u32>, Vec<f64>) {
    let (place, euler) = (sample.place, sample.euler);
    let groups = [
        Some(vec![
            place.latitude_rad,
            place.longitude_rad,
            place.height_m,
            euler.roll,
            euler.pitch,
            euler.heading,
        ]),
        sample.v_n.map(|v_n| v_n.as_slice().to_vec()),
        sample.omega_ib_b.map(|rate| rate.as_slice().to_vec()),
        sample.f_b.map(|force| force.as_slice().to_vec()),
        sample.temperature_c.map(|temperature_c| vec![temperature_c]),
    ];
    let (mut references, mut values) = (Vec::new(), Vec::new());
    for (first, group) in [0, 6, 9, 12, 15].into_iter().zip(groups) {
        for (reference, value) in (first..).zip(group.into_iter().flatten()) {
            references.push(reference);
            values.push(value);
        }
    }
    (references, values)
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
fn scenes_fly_to_the_bits_of_the_library() {
    let random = 60;
    let mut scenes = named_scenes([700.0, 60.0]);
    scenes.extend((2000..2000 + random).map(|seed| random_scene(seed, true)));
    let (mut units, mut stopped) = (0, 0);
    for scene in &scenes {
        let (has_unit, has_stopped) = flies_alike(scene);
        units += u64::from(has_unit);
        stopped += u64::from(has_stopped);
    }
    println!("{} scenes: {units} units, {stopped} stopped", scenes.len());
    assert!(units > random / 4 && stopped < random / 4);
}

/// Whether the scene has a unit, and whether an entry at the wrong moment ended its flight.
fn flies_alike(given: &FlownScene) -> (bool, bool) {
    let (errors, shown) = (references("errors."), references("shown."));
    let FlownScene { name, text, .. } = given;
    let own = given.scene();
    let source = given.source(&own);
    let count = source.samples(&own).unwrap().unwrap().count;
    let has_velocities = source.sample(1, &own).unwrap().v_n.is_some();
    let (mut scene, rate_hz) = (own.clone(), own.rate_hz);
    // The unit takes samples from outside, without a stated rate.
    scene.flight = FlightSource::Log("inputs".to_owned());
    let mut play = Play::new(Arc::new(scene), Source::Host).unwrap();
    let has_unit = play.unit().is_some();
    let unit = Unit::flying(|unit| {
        let (place, text) = (reference("scene_text"), CString::new(text.as_str()).unwrap());
        assert_eq!(unsafe { fmi2SetString(unit.component, &place, 1, &text.as_ptr()) }, fmi2OK);
    });
    for index in 0..count {
        let mut sample = source.sample(index, &own).unwrap();
        // A master has velocities in all samples or in none, also where the first sample of a log gets one.
        sample.v_n = sample.v_n.filter(|_| has_velocities);
        let (references, values) = inputs_of(&sample);
        assert_eq!(unit.set_reals(&references, &values), fmi2OK);
        let status = unsafe { fmi2DoStep(unit.component, sample.time_s, 1.0 / rate_hz, 1) };
        if let Err(error) = play.push(&sample) {
            // An entry at the wrong moment.
            assert!(status == fmi2Error && error.to_string().contains("panel"), "{name}: {error}");
            return (has_unit, true);
        }
        assert_eq!(status, fmi2OK, "{name}, sample {index}: {:?}", unit.messages());
        if index > 0 && (index % 1000 == 0 || index + 1 == count) {
            let mut found = unit.reals(&errors[..9]);
            if has_unit {
                found.extend(&unit.reals(&shown)[..9]);
            }
            let found: Vec<u64> = found.into_iter().map(f64::to_bits).collect();
            assert_eq!(found, of_library(&play), "{name}, sample {index}\n{text}");
        }
    }
    (has_unit, false)
}
