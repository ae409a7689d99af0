//! Scenes and flight logs through their C functions: read, flown, changed, written.

use std::ffi::{CStr, CString, c_char};
use std::fs;
use std::ptr::{null, null_mut, with_exposed_provenance_mut};

use sins::abi::*;

use crate::support::{init, project_file};

fn file(name: &str) -> Vec<u8> {
    fs::read(project_file("c_examples").join(name)).unwrap()
}

pub fn parsed(text: &[u8]) -> (sins_status, *mut sins_scene) {
    let mut scene = null_mut();
    // SAFETY: a text with its size, and a place for a handle.
    (unsafe { sins_scene_parse(text.as_ptr().cast(), text.len(), &mut scene) }, scene)
}

/// The text that a function writes into a buffer.
fn text_of(write: impl Fn(*mut c_char, usize, *mut usize) -> sins_status) -> String {
    let mut needed = 0;
    assert_eq!(write(null_mut(), 0, &mut needed), SINS_OK);
    let mut buffer = vec![0_u8; needed];
    assert_eq!(write(buffer.as_mut_ptr().cast(), needed, &mut needed), SINS_OK);
    CStr::from_bytes_with_nul(&buffer).unwrap().to_str().unwrap().to_owned()
}

/// Flies `count` samples of a scene and returns the bits of the last record.
fn flown(
    scene: *mut sins_scene,
    count: usize,
    mut sample_of: impl FnMut(usize, *mut sins_flight_sample),
) -> Vec<u64> {
    let mut sim = null_mut();
    let (mut sample, mut record, mut start_s) = (init::<sins_flight_sample>(), init::<sins_record>(), 0.0);
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_create_simulator(scene, &mut sim), SINS_OK);
        for k in 0..count {
            sample_of(k, &mut sample);
            start_s = if k == 0 { sample.time_s } else { start_s };
            assert_eq!(sins_scene_prepare(scene, sim, start_s, &mut sample), SINS_OK);
            assert_eq!(sins_push_sample(sim, &sample), SINS_OK);
            assert!(sins_step(sim) >= SINS_OK);
        }
        assert_eq!(sins_get_record(sim, &mut record), SINS_OK);
        assert_eq!(sins_destroy(sim), SINS_OK);
        (0..size_of::<sins_record>() / 8)
            .map(|k| core::ptr::from_ref(&record).cast::<u64>().add(k).read())
            .collect()
    }
}

/// Flies the first 120 s of the scene of a text.
fn flown_text(text: &[u8]) -> Vec<u64> {
    let (status, scene) = parsed(text);
    assert_eq!(status, SINS_OK);
    let mut setup = init::<sins_scene_setup>();
    let mut flight = null_mut();
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_get_setup(scene, &mut setup), SINS_OK);
        assert_eq!(sins_scene_create_flight(scene, &mut flight), SINS_OK);
        let period_s = 1.0 / setup.rate_hz;
        let record = flown(scene, (120.0 / period_s) as usize, |k, sample| {
            assert_eq!(sins_flight_sample_at(flight, k as f64 * period_s, sample), SINS_OK);
        });
        assert_eq!(sins_flight_destroy(flight), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
        record
    }
}

#[test]
fn a_scene_that_was_written_flies_to_the_same_bits() {
    for name in ["scenes/drone.toml", "scenes/trainer.toml"] {
        let text = file(name);
        let (_, scene) = parsed(&text);
        // SAFETY: a living handle and a buffer with its size.
        let written =
            text_of(|buffer, size, needed| unsafe { sins_scene_write(scene, buffer, size, needed) });
        assert_eq!(flown_text(&text), flown_text(written.as_bytes()), "{name}");
        // SAFETY: a living handle.
        assert_eq!(unsafe { sins_scene_destroy(scene) }, SINS_OK);
    }
}

#[test]
fn a_log_flies_with_its_scene() {
    let (status, scene) = parsed(&file("scenes/fighter.toml"));
    assert_eq!(status, SINS_OK);
    let text = file("flights/fighter_aerobatics.csv");
    let (mut log, mut info) = (null_mut(), init::<sins_log_info>());
    // SAFETY: living handles, structs of the interface, a text with its size.
    unsafe {
        let name = text_of(|buffer, size, needed| {
            sins_scene_get_text(scene, SINS_SCENE_TEXT_LOG, buffer, size, needed)
        });
        assert_eq!(name, "../flights/fighter_aerobatics.csv");
        assert_eq!(sins_log_parse(text.as_ptr().cast(), text.len(), null(), &mut log, null_mut()), SINS_OK);
        assert_eq!(sins_log_get_info(log, &mut info), SINS_OK);
        assert_eq!((info.samples, info.duration_s), (30_001, 300.0));
        let mut line = 0;
        let record = flown(scene, 3_001, |k, sample| {
            assert_eq!(sins_log_get_sample(log, k, sample, &mut line), SINS_OK);
        });
        // Word 1 of the record, after its size, is its time.
        assert_eq!((f64::from_bits(record[1]), line), (30.0, 3_004));
        assert_eq!(sins_log_get_sample(log, 30_001, &mut init(), &mut line), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_log_destroy(log), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

/// All samples of a log.
fn samples_of(log: *const sins_log) -> Vec<sins_flight_sample> {
    let mut info = init::<sins_log_info>();
    // SAFETY: a living handle and structs of the interface.
    unsafe {
        assert_eq!(sins_log_get_info(log, &mut info), SINS_OK);
        let sample = |index| {
            let mut sample = init();
            assert_eq!(sins_log_get_sample(log, index, &mut sample, null_mut()), SINS_OK);
            sample
        };
        (0..info.samples as usize).map(sample).collect()
    }
}

/// The signals of all intervals of a scene in flight, in pieces.
fn signals(scene: *const sins_scene, log: *const sins_log, piece: usize) -> Vec<[f64; 6]> {
    let (mut play, mut found) = (null_mut(), Vec::new());
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_play_create(scene, log, &mut play), SINS_OK);
        loop {
            let (mut imu, mut written) = (vec![init::<sins_imu>(); piece], 0);
            let status = sins_play_run_imu(play, imu.as_mut_ptr(), piece, &mut written);
            found.extend(imu[..written].iter().map(|one| {
                let mut both = [0.0; 6];
                both[..3].copy_from_slice(&one.measured_angle_rad);
                both[3..].copy_from_slice(&one.measured_velocity_m_s);
                both
            }));
            if status != SINS_OK {
                assert_eq!(status, SINS_PLAY_END);
                break;
            }
            assert_eq!(written, piece);
        }
        assert_eq!(sins_play_destroy(play), SINS_OK);
    }
    found
}

#[test]
fn a_log_of_samples_flies_as_that_of_their_text_and_gives_the_signals_of_each_interval() {
    let (_, scene) = parsed(&file("scenes/fighter.toml"));
    let text = file("flights/fighter_aerobatics.csv");
    let (mut parsed_log, mut log, mut play, mut sim) = (null_mut(), null_mut(), null_mut(), null_mut());
    // SAFETY: living handles, structs of the interface, a text and an array with their sizes.
    unsafe {
        assert_eq!(
            sins_log_parse(text.as_ptr().cast(), text.len(), null(), &mut parsed_log, null_mut()),
            SINS_OK
        );
        let mut samples = samples_of(parsed_log);
        samples.truncate(2000);
        assert_eq!(sins_log_create(samples.as_ptr(), samples.len(), &mut log), SINS_OK);
        assert_eq!(sins_scene_set_values(scene, c"flight.hours = 0.005".as_ptr()), SINS_OK);
        let expected = signals(scene, parsed_log, 7);
        assert_eq!(expected.len(), 1800);
        assert!(expected == signals(scene, log, 1000));
        // They are those of sins_get_imu() after each interval.
        assert_eq!(sins_play_create(scene, log, &mut play), SINS_OK);
        assert_eq!(sins_play_get_simulator(play, &mut sim), SINS_OK);
        assert_eq!(sins_play_next(play), SINS_OK);
        for one in &expected[..100] {
            let mut imu = init::<sins_imu>();
            assert_eq!(sins_play_next(play), SINS_OK);
            assert_eq!(sins_get_imu(sim, &mut imu), SINS_OK);
            assert!(one[..3] == imu.measured_angle_rad && one[3..] == imu.measured_velocity_m_s);
        }
        assert_eq!(sins_play_run_imu(play, &mut init(), 0, null_mut()), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_play_destroy(play), SINS_OK);
        for handle in [parsed_log, log] {
            assert_eq!(sins_log_destroy(handle), SINS_OK);
        }
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

#[test]
fn samples_that_make_no_log_are_named() {
    let good = [0.0, 1.0, 2.0].map(|time_s| sins_flight_sample { time_s, ..init() });
    let refused = |samples: &[sins_flight_sample], expected, words: &str| {
        let mut log = null_mut();
        let mut sentence = [0; 512];
        // SAFETY: structs of the interface, an array and a buffer with their sizes.
        unsafe {
            assert_eq!(sins_log_create(samples.as_ptr(), samples.len(), &mut log), expected);
            sins_last_error(null(), sentence.as_mut_ptr(), sentence.len(), null_mut());
        }
        let sentence = crate::support::text(&sentence);
        assert!(log.is_null() && sentence.contains(words), "{sentence}");
    };
    refused(&good[..1], SINS_ERROR_INVALID_ARGUMENT, "count = 1");
    refused(&[good[0], good[2], good[1]], SINS_ERROR_TIME_ORDER, "(samples[2])");
    refused(&[good[0], good[0]], SINS_ERROR_TIME_ORDER, "(samples[1])");
    refused(
        &[good[0], sins_flight_sample { latitude_rad: f64::NAN, ..good[1] }],
        SINS_ERROR_INVALID_ARGUMENT,
        "latitude_rad",
    );
}

#[test]
fn a_text_with_faults_makes_a_handle_for_these_alone() {
    let (status, scene) = parsed(b"[flight]\nbuiltin = \"rest\"\n[gyro]\nbais_deg_h = 1\nrange_deg_s = -1\n");
    assert_eq!(status, SINS_SCENE_HAS_FAULTS);
    let (mut fault, mut sim) = (init::<sins_fault>(), null_mut());
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_get_fault(scene, 1, &mut fault), SINS_OK);
        assert_eq!((fault.count, fault.line, fault.column), (2, 5, 1));
        let sentence = CStr::from_ptr(fault.sentence.as_ptr()).to_str().unwrap();
        assert!(sentence.starts_with("gyro.range_deg_s[0] = -1: must be 0 for none, or from"), "{sentence}");
        assert_eq!(sins_scene_get_fault(scene, 2, &mut fault), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_scene_create_simulator(scene, &mut sim), SINS_ERROR_BAD_STATE);
        assert_eq!(sins_scene_get_options(scene, &mut init()), SINS_ERROR_BAD_STATE);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_ERROR_BAD_HANDLE);
        assert_eq!(sins_scene_destroy(with_exposed_provenance_mut(3)), SINS_ERROR_BAD_HANDLE);
    }
}

#[test]
fn what_is_set_is_given_back_and_a_bad_value_changes_nothing() {
    let mut scene = null_mut();
    // SAFETY: living handles, terminated texts, structs of the interface.
    unsafe {
        assert_eq!(sins_scene_create_builtin(c"patrol".as_ptr(), &mut scene), SINS_OK);
        let set = |values: &CStr| sins_scene_set_values(scene, values.as_ptr());
        let mut setup = init::<sins_scene_setup>();
        assert_eq!(sins_scene_get_setup(scene, &mut setup), SINS_OK);
        assert_eq!(
            (setup.flight, setup.flown_s, setup.rate_hz),
            (SINS_SCENE_FLIGHT_MANOEUVRES, 3600.0, 100.0)
        );
        assert_eq!(set(c"flight.duration_s = 1e9"), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(set(c"flight.duration_s = 60"), SINS_OK);
        assert_eq!(sins_scene_get_setup(scene, &mut setup), SINS_OK);
        assert_eq!((setup.duration_s, setup.flown_s), (60.0, 60.0));
        let items = |from_s: u32| {
            let item = |from_s| {
                format!(
                    "[[failure]]\nsensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\nfrom_s = {from_s}\nuntil_s = {}\n",
                    from_s + 10
                )
            };
            CString::new(item(10) + &item(from_s)).unwrap()
        };
        let plan = |items: CString| sins_scene_set_items(scene, c"failure".as_ptr(), items.as_ptr());
        assert_eq!(plan(items(30)), SINS_OK);
        assert_eq!(plan(items(19)), SINS_ERROR_INVALID_ARGUMENT, "they overlap");
        let (mut count, mut failure) = (0, init::<sins_planned_failure>());
        assert_eq!(sins_scene_get_failure_count(scene, &mut count), SINS_OK);
        assert_eq!(sins_scene_get_failure(scene, 1, &mut failure), SINS_OK);
        assert_eq!((count, failure.from_s, failure.until_s), (2, 30.0, 40.0));
        assert_eq!(sins_scene_get_failure(scene, 2, &mut failure), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

#[test]
fn prepare_rejects_what_no_push_takes_and_changes_nothing() {
    let text =
        b"[flight]\nbuiltin = \"rest\"\n[[failure]]\nsensor = \"altimeter\"\nkind = \"dead\"\nfrom_s = 0\n";
    let (status, scene) = parsed(text);
    assert_eq!(status, SINS_OK);
    let (mut sim, mut failure) = (null_mut(), init::<sins_failure>());
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_create_simulator(scene, &mut sim), SINS_OK);
        let mut sample = init::<sins_flight_sample>();
        for time_s in [0.0, 0.01] {
            sample.time_s = time_s;
            assert_eq!(sins_scene_prepare(scene, sim, 0.0, &mut sample), SINS_OK);
            assert_eq!(sins_push_sample(sim, &sample), SINS_OK);
        }
        let cases =
            [(f64::NAN, 0.02, 0.0), (f64::INFINITY, 0.02, 0.0), (0.0, f64::NAN, 0.0), (0.0, 0.02, 2.0)];
        for (start_s, time_s, latitude_rad) in cases {
            (sample.time_s, sample.latitude_rad) = (time_s, latitude_rad);
            assert_eq!(sins_scene_prepare(scene, sim, start_s, &mut sample), SINS_ERROR_INVALID_ARGUMENT);
            assert_eq!(sins_get_failure(sim, SINS_SENSOR_ALTIMETER, 0, &mut failure), SINS_OK);
            assert_eq!(failure.fields.kind, SINS_FAILURE_DEAD);
        }
        assert_eq!(sins_destroy(sim), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

/// The sentence of the last failure on this thread.
fn last_error() -> String {
    // SAFETY: a buffer with its size, and a place for the size that is needed.
    text_of(|buffer, capacity, needed| unsafe { sins_last_error(null_mut(), buffer, capacity, needed) })
}

#[test]
fn a_message_names_the_field_that_the_caller_set() {
    let (mut scene, start, mut rest) = (null_mut(), init::<sins_flight_start>(), init::<sins_manoeuvre>());
    rest.duration_s = 60.0;
    let refused = |status: sins_status, expected: &str| {
        assert_eq!((status, last_error().as_str()), (SINS_ERROR_INVALID_ARGUMENT, expected));
    };
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_create(&mut scene), SINS_OK);
        refused(
            sins_scene_set_manoeuvres(scene, &start, &rest, 1, 4097),
            "repeat = 4097: must be from 1 to 4096",
        );
        // At the second repetition, the speed would become negative.
        let mut brake = init::<sins_manoeuvre>();
        (brake.kind, brake.duration_s, brake.speed_change_m_s) = (SINS_MANOEUVRE_ACCELERATE, 60.0, -60.0);
        let fast = sins_flight_start { speed_m_s: 100.0, ..start };
        assert_eq!(sins_scene_set_manoeuvres(scene, &fast, &brake, 1, 2), SINS_ERROR_INVALID_ARGUMENT);
        assert!(last_error().contains("[0] = "), "{}", last_error());
        refused(
            sins_scene_set_text(scene, SINS_SCENE_TEXT_NAME, c"a/b".as_ptr()),
            "text: must be a name without a folder; output.folder has that",
        );
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

/// The program `sins` rejects them too.
#[test]
fn records_closer_than_the_samples_of_a_log_are_rejected() {
    let (mut scene, mut log, mut samples) = (null_mut(), null_mut(), init::<sins_scene_samples>());
    let text = c"time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n";
    // SAFETY: texts with their sizes, handles of these calls, places for the results.
    unsafe {
        assert_eq!(sins_scene_create(&mut scene), SINS_OK);
        assert_eq!(sins_log_parse(text.as_ptr(), text.count_bytes(), null(), &mut log, null_mut()), SINS_OK);
        for (every_s, status) in [(c"0.4", SINS_ERROR_INVALID_ARGUMENT), (c"2", SINS_OK)] {
            let values =
                [c"flight.file = a.csv\noutput.every_s = ".to_bytes(), every_s.to_bytes_with_nul()].concat();
            assert_eq!(sins_scene_set_values(scene, values.as_ptr().cast()), SINS_OK);
            assert_eq!(sins_scene_get_samples(scene, log, &mut samples), status);
        }
        assert_eq!((samples.count, samples.record_every), (2, 2));
        assert_eq!(last_error(), "output.every_s = 0.4: must be at least the sample interval, 1");
        assert_eq!(sins_log_destroy(log), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
}

#[test]
fn the_fault_of_a_log_is_the_last_error_until_another_call_fails() {
    let mut log = null_mut();
    let text =
        c"time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad\n0,north,0,0,0,0,0\n";
    // SAFETY: a text with its size, and a place for a handle.
    let parse = |log: *mut *mut sins_log| unsafe {
        sins_log_parse(text.as_ptr(), text.count_bytes(), null(), log, null_mut())
    };
    let expected = "line = 2, column 2: latitude_rad: expected a finite number, found \"north\"";
    assert_eq!(parse(&mut log), SINS_ERROR_INVALID_ARGUMENT);
    assert_eq!((log.is_null(), last_error().as_str()), (true, expected));
    assert_eq!(parse(null_mut()), SINS_ERROR_NULL_POINTER);
    assert_eq!(last_error(), "log: must not be null");
    assert_eq!(parse(&mut log), SINS_ERROR_INVALID_ARGUMENT);
    // SAFETY: the function rejects an invalid handle.
    assert_eq!(unsafe { sins_log_destroy(null_mut()) }, SINS_ERROR_BAD_HANDLE);
    assert_eq!(last_error(), expected, "the status says why a handle was rejected");
}

#[test]
fn an_enumeration_is_named_by_its_type() {
    let (mut sim, mut options) = (null_mut(), init::<sins_options>());
    options.truth_summary = 2;
    // SAFETY: options that state their size, and a place for a handle.
    assert_eq!(unsafe { sins_create(&options, &mut sim) }, SINS_ERROR_INVALID_ARGUMENT);
    assert_eq!(last_error(), "options.truth_summary = 2: must be of enum sins_summary, 0 to 1");
}

/// A table with columns of its own flies by the `[log]` of its scene, smoothed if that says so, and never by another.
#[test]
fn a_scene_flies_only_a_log_that_was_read_by_its_own_section() {
    let own = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
    let foreign = "t,lat,lon,ft,roll,pitch,yaw\n";
    let table = |header: &str, unit_m: f64| {
        (0..400).fold(header.to_owned(), |text, k| {
            let time_s = f64::from(k) / 10.0;
            let height = (500.0 + 0.01 * f64::from(k % 2)) / unit_m;
            text + &format!("{time_s},{},11,{height},0,0,0\n", 48.0 + 1e-4 * time_s)
        })
    };
    let columns = "[log]\ntime = \"t\"\nlatitude = \"lat\"\nlongitude = \"lon\"\nheight = { col = \"ft\", unit = \"ft\" }\n\
                   roll = \"roll\"\npitch = \"pitch\"\nheading = \"yaw\"\n";
    let smooth = format!("{columns}smooth = \"auto\"\n");
    let mut heights = Vec::new();
    for (section, text) in
        [("", table(own, 1.0)), (columns, table(foreign, 0.3048)), (&smooth, table(foreign, 0.3048))]
    {
        let (status, scene) = parsed(format!("[flight]\nfile = \"a.csv\"\n{section}").as_bytes());
        assert_eq!(status, SINS_OK);
        let [mut log, mut other, mut play, mut refused] = [null_mut(); 4].map(|_: *mut ()| null_mut::<()>());
        // SAFETY: living handles, structs of the interface and texts with their sizes.
        unsafe {
            let read = |text: &str, scene, log: *mut *mut ()| {
                sins_log_parse(text.as_ptr().cast(), text.len(), scene, log.cast(), null_mut())
            };
            assert_eq!(read(&text, scene, &mut log), SINS_OK);
            assert_eq!(sins_play_create(scene, log.cast(), (&raw mut play).cast()), SINS_OK);
            let mut records = vec![init::<sins_record>(); 5000];
            let mut written = 0;
            assert_eq!(sins_play_run(play.cast(), records.as_mut_ptr(), 5000, &mut written), SINS_PLAY_END);
            let spread = records[..written].iter().map(|record| record.truth.height_m);
            heights.push((written, spread.clone().fold(0.0, f64::max) - spread.fold(1e9, f64::min)));
            if !section.is_empty() {
                assert_eq!(read(&table(own, 1.0), null(), &mut other), SINS_OK);
                let status = sins_play_create(scene, other.cast(), (&raw mut refused).cast());
                assert_eq!((status, refused), (SINS_ERROR_BAD_STATE, null_mut()));
                let mut sentence = [0; 512];
                sins_last_error(null(), sentence.as_mut_ptr(), sentence.len(), null_mut());
                let sentence = crate::support::text(&sentence);
                assert!(sentence.contains("the log was not read by the [log] of the scene"), "{sentence}");
                assert_eq!(sins_log_destroy(other.cast()), SINS_OK);
            }
            assert_eq!(sins_play_destroy(play.cast()), SINS_OK);
            assert_eq!(sins_log_destroy(log.cast()), SINS_OK);
            assert_eq!(sins_scene_destroy(scene), SINS_OK);
        }
    }
    let [(_, plain_m), (_, mapped_m), (_, smooth_m)] = heights[..] else { unreachable!() };
    assert!((plain_m - 0.01).abs() < 1e-6 && (mapped_m - plain_m).abs() < 1e-6, "{heights:?}");
    assert!(smooth_m < 0.3 * plain_m, "{heights:?}");
}
