//! A scene in flight gives the bits of the calls one by one, in Rust and in C, from any snapshot; a rejected sample changes nothing.

use std::ffi::c_void;
use std::ptr::{null, null_mut};
use std::sync::Arc;

use sins::abi::*;
use sins::log::FlightLog;
use sins::scene::{Play, Scene, Source};
use sins::snapshot::{SnapshotOf, seal};
use sins::truth::FlightSample;
use sins::unit::Unit;
use sins::{ErrorKind, Simulator, Step};

use crate::scene_functions::parsed;
use crate::support::init;
use crate::support::moments::reads;
use crate::support::scenes::{Coverage, FlownScene, named_scenes, random_scene};

/// A scene with its log, if its flight is one.
struct Given {
    name: String,
    scene: Arc<Scene>,
    log: Option<(Arc<FlightLog>, String)>,
}

impl From<FlownScene> for Given {
    fn from(made: FlownScene) -> Self {
        let scene = made.scene();
        let log = made.log.map(|text| (Arc::new(scene.read_log(text.as_bytes()).unwrap()), text));
        Self { name: made.name, scene: Arc::new(scene), log }
    }
}

impl Given {
    fn random(seed: u64) -> Self {
        Self::from(random_scene(seed, true))
    }

    fn source(&self) -> Source {
        match &self.log {
            Some((log, _)) => Source::Log(log.clone()),
            None => Source::flight_of(&self.scene).unwrap(),
        }
    }

    fn play(&self) -> Play {
        Play::new(self.scene.clone(), self.source()).unwrap()
    }

    fn samples(&self) -> Vec<FlightSample> {
        let source = self.source();
        let count = source.samples(&self.scene).unwrap().unwrap().count;
        (0..count).map(|index| source.sample(index, &self.scene).unwrap()).collect()
    }
}

/// All that can be read of a flight.
fn moment(simulator: &Simulator, unit: Option<&Unit>) -> String {
    let shown = unit.map(|unit| (unit.status(), unit.navigation(simulator)));
    format!("{} {shown:?}", reads(simulator))
}

/// What a flight leads to: what can be read every hundredth sample and at its end, and the error that ended it, with its sample.
#[derive(Debug, PartialEq)]
struct Outcome {
    moments: Vec<String>,
    error: Option<(usize, String)>,
}

/// Flies by the calls one by one.
fn by_calls(given: &Given) -> Outcome {
    let [mut simulator] = *given.scene.simulator().unwrap();
    let mut unit = given.scene.unit().unwrap();
    let samples = given.samples();
    let mut outcome = Outcome { moments: Vec::new(), error: None };
    for (index, sample) in samples.iter().enumerate() {
        let mut sample = *sample;
        let start_s = samples[0].time_s;
        let mut fly = || {
            given.scene.prepare(&mut simulator, start_s, &mut sample)?;
            simulator.push_sample(&sample)?;
            match (simulator.step()?, &mut unit) {
                (Step::Done, Some(unit)) => given.scene.update_unit(unit, &mut simulator, start_s),
                _ => Ok(()),
            }
        };
        if let Err(error) = fly() {
            outcome.error = Some((index, error.to_string()));
            break;
        }
        if index % 100 == 99 {
            outcome.moments.push(moment(&simulator, unit.as_ref()));
        }
    }
    outcome.moments.push(moment(&simulator, unit.as_ref()));
    outcome
}

/// Flies by the player, which a snapshot after the sample `saved` replaces by another.
fn by_play(given: &Given, saved: usize) -> Outcome {
    let mut play = given.play();
    let mut outcome = Outcome { moments: Vec::new(), error: None };
    for index in 0.. {
        match play.fly_next() {
            Ok(Some(_)) => {}
            Ok(None) => break,
            Err(stopped) => {
                let samples = given.samples();
                assert_eq!(stopped.time_s, samples[index].time_s);
                assert_eq!(stopped.line, given.log.as_ref().and_then(|(log, _)| log.line(index)));
                outcome.error = Some((index, stopped.error.to_string()));
                break;
            }
        }
        if index % 100 == 99 {
            outcome.moments.push(moment(play.simulator(), play.unit()));
        }
        if index == saved {
            let mut bytes = vec![0; play.snapshot_size()];
            assert_eq!(play.save_snapshot(&mut bytes), Ok(bytes.len()));
            assert!(bytes.len() <= SINS_PLAY_SNAPSHOT_MAX_SIZE);
            play = given.play();
            play.load_snapshot(&bytes).unwrap();
            let mut again = vec![0; play.snapshot_size()];
            play.save_snapshot(&mut again).unwrap();
            assert_eq!(bytes, again, "{}", given.name);
        }
    }
    outcome.moments.push(moment(play.simulator(), play.unit()));
    outcome
}

#[test]
fn every_scene_flies_to_the_bits_of_its_calls() {
    for given in named_scenes([100.0, 200.0]).into_iter().map(Given::from) {
        let calls = by_calls(&given);
        assert_eq!(calls.error, None, "{}", given.name);
        let count = given.samples().len();
        assert!(by_play(&given, count / 3) == calls, "{}", given.name);
    }
}

#[test]
fn random_scenes_say_all_that_a_scene_can_say() {
    let mut coverage = Coverage::default();
    (0..300).for_each(|seed| coverage.add(&random_scene(seed, true).text));
    named_scenes([100.0, 100.0]).iter().for_each(|scene| coverage.add(&scene.text));
    assert_eq!(coverage.missing(), [""; 0]);
}

#[test]
fn random_scenes_fly_to_the_bits_of_their_calls() {
    let (mut logs, mut units, mut stopped) = (0, 0, 0);
    for seed in 0..300 {
        let given = Given::random(seed);
        let calls = by_calls(&given);
        logs += usize::from(given.log.is_some());
        units += usize::from(given.scene.unit.start.is_some());
        if let Some((_, error)) = &calls.error {
            stopped += 1;
            println!("{}: {error}", given.name);
        }
        assert!(by_play(&given, (seed as usize * 37) % 1200) == calls, "{}", given.name);
    }
    println!(
        "300 random scenes: {logs} logs, {units} units, {stopped} stopped by an entry at the wrong moment"
    );
    assert!(logs > 60 && units > 100 && stopped > 5 && stopped < 100);
}

/// What is left out of a plan is found: without its updates a scene ends elsewhere.
#[test]
fn a_player_that_forgets_the_updates_is_found() {
    let with_updates = (0..).map(Given::random).find(|given| {
        given.scene.updates.iter().any(|planned| planned.at_s < 30.0) && by_calls(given).error.is_none()
    });
    let given = with_updates.unwrap();
    let mut scene = (*given.scene).clone();
    scene.updates.clear();
    let forgetful = Given { scene: Arc::new(scene), log: given.log.clone(), name: String::new() };
    assert!(by_play(&forgetful, usize::MAX).moments.last() != by_calls(&given).moments.last());
}

#[test]
fn rejected_samples_change_nothing_of_what_follows() {
    for seed in 0..40 {
        let given = Given::random(seed);
        let (mut clean, mut disturbed) = (given.play(), given.play());
        for (index, sample) in given.samples().iter().enumerate() {
            let good = clean.push(sample);
            if index % 7 == 3 {
                for bad in [
                    FlightSample { time_s: sample.time_s - 5.0, ..*sample },
                    FlightSample { time_s: f64::NAN, ..*sample },
                    FlightSample { time_s: sample.time_s + 100.0, ..*sample },
                ] {
                    assert!(disturbed.push(&bad).is_err());
                }
            }
            assert_eq!(disturbed.push(sample), good);
            if good.is_err() {
                break;
            }
        }
        let moments = [&clean, &disturbed].map(|play| moment(play.simulator(), play.unit()));
        assert!(moments[0] == moments[1], "{}", given.name);
    }
}

/// The records of `sins_play_run`, in pieces of `piece`, with a snapshot after the first, and the status that ended it.
fn by_c(given: &Given, piece: usize) -> (Vec<Vec<u64>>, sins_status, String) {
    let mut record = [init::<sins_record>(); 8];
    let (mut log, mut play, mut other) = (null_mut(), null_mut(), null_mut());
    let (status, scene) = parsed(given.scene.write().as_bytes());
    assert_eq!(status, SINS_OK);
    let mut records = Vec::new();
    // SAFETY: living handles, texts and arrays with their sizes.
    let ended = unsafe {
        if let Some((_, text)) = &given.log {
            assert_eq!(
                sins_log_parse(text.as_ptr().cast(), text.len(), scene, &mut log, null_mut()),
                SINS_OK
            );
        }
        assert_eq!(sins_play_create(scene, log, &mut play), SINS_OK);
        assert_eq!(sins_play_create(scene, log, &mut other), SINS_OK);
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
        let ended = loop {
            let mut written = 0;
            let status = sins_play_run(play, record.as_mut_ptr(), piece, &mut written);
            for one in &record[..written] {
                let words = core::ptr::from_ref(one).cast::<u64>();
                records.push((1..size_of::<sins_record>() / 8).map(|k| words.add(k).read()).collect());
            }
            if status != SINS_OK {
                break status;
            }
            assert_eq!(written, piece);
            let (mut bytes, mut size) = (vec![0_u8; SINS_PLAY_SNAPSHOT_MAX_SIZE], 0);
            let buffer: *mut c_void = bytes.as_mut_ptr().cast();
            assert_eq!(sins_play_snapshot_save(play, buffer, bytes.len(), &mut size), SINS_OK);
            assert_eq!(sins_play_snapshot_load(other, buffer, size), SINS_OK);
            core::mem::swap(&mut play, &mut other);
        };
        let (mut sentence, mut needed) = ([0; 512], 0);
        sins_last_error(null(), sentence.as_mut_ptr(), sentence.len(), &mut needed);
        let sentence = if ended < 0 { crate::support::text(&sentence) } else { String::new() };
        assert_eq!(sins_play_destroy(play), SINS_OK);
        assert_eq!(sins_play_destroy(other), SINS_OK);
        let _ = sins_log_destroy(log);
        (ended, sentence)
    };
    (records, ended.0, ended.1)
}

/// The records of a flight by the calls one by one in C, those of all samples after which one is due.
fn records_by_calls(given: &Given) -> (Vec<Vec<u64>>, Option<(usize, String)>) {
    let mut play = given.play();
    let (mut due, mut index) = (Vec::new(), 0);
    let error = loop {
        match play.fly_next() {
            Ok(Some(_)) if play.itinerary().is_due() => due.push(index),
            Ok(Some(_)) => {}
            Ok(None) => break None,
            Err(stopped) => break Some((index, stopped.to_string())),
        }
        index += 1;
    };
    let (_, scene) = parsed(given.scene.write().as_bytes());
    let (mut sim, mut unit, mut records) = (null_mut(), null_mut(), Vec::new());
    let samples = given.samples();
    // SAFETY: living handles and structs of the interface.
    unsafe {
        assert_eq!(sins_scene_create_simulator(scene, &mut sim), SINS_OK);
        let has_unit = sins_scene_create_unit(scene, &mut unit) == SINS_OK;
        for (index, sample) in samples.iter().enumerate().take(due.last().map_or(0, |last| last + 1)) {
            let (mut sample, start_s) = (sins_flight_sample::from(sample), samples[0].time_s);
            assert_eq!(sins_scene_prepare(scene, sim, start_s, &mut sample), SINS_OK);
            assert!(sins_push_sample(sim, &sample) >= SINS_OK);
            if sins_step(sim) == SINS_OK && has_unit {
                assert_eq!(sins_scene_update_unit(scene, unit, sim, start_s), SINS_OK);
            }
            if due.contains(&index) {
                let mut record = init::<sins_record>();
                assert_eq!(sins_get_record(sim, &mut record), SINS_OK);
                let words = core::ptr::from_ref(&record).cast::<u64>();
                records.push((1..size_of::<sins_record>() / 8).map(|k| words.add(k).read()).collect());
            }
        }
        sins_destroy(sim);
        sins_unit_destroy(unit);
        sins_scene_destroy(scene);
    }
    (records, error)
}

#[test]
fn the_c_functions_fly_to_the_bits_of_the_calls() {
    for seed in 0..60 {
        let mut given = Given::random(seed);
        let mut scene = (*given.scene).clone();
        scene.output.every_s = Some(5.0);
        given.scene = Arc::new(scene);
        let (records, error) = records_by_calls(&given);
        assert!(!records.is_empty());
        for piece in [1, 3, 8] {
            let (found, status, sentence) = by_c(&given, piece);
            assert!(found == records, "{}: {} and {} records", given.name, found.len(), records.len());
            assert_eq!(status < 0, error.is_some(), "{}: {status}", given.name);
            assert_eq!(sentence, error.as_ref().map_or("", |(_, sentence)| sentence.as_str()));
        }
    }
}

#[test]
fn a_snapshot_that_is_damaged_or_of_another_scene_is_rejected_and_changes_nothing() {
    let with_unit = (0..)
        .map(Given::random)
        .find(|given| given.scene.unit.start.is_some() && by_calls(given).error.is_none());
    let given = with_unit.unwrap();
    let mut play = given.play();
    (0..500).for_each(|_| assert!(play.fly_next().unwrap().is_some()));
    let saved = |play: &Play| {
        let mut bytes = vec![0; play.snapshot_size()];
        play.save_snapshot(&mut bytes).unwrap();
        bytes
    };
    let bytes = saved(&play);
    assert!(play.save_snapshot(&mut vec![0; bytes.len() - 1]).is_err());
    for at in (0..bytes.len()).step_by(7) {
        let mut altered = bytes.clone();
        altered[at] ^= 0x10;
        for damaged in [&altered[..], &bytes[..at]] {
            assert_eq!(play.load_snapshot(damaged).unwrap_err().kind, ErrorKind::Snapshot, "byte {at}");
        }
        // The numbers themselves, with a right checksum: rejected, or a scene in flight that can be saved and flown.
        if at >= 24 {
            seal(&mut altered, SnapshotOf::Play);
            let mut other = given.play();
            if other.load_snapshot(&altered).is_ok() {
                let _ = other.fly_next();
                saved(&other);
            }
        }
    }
    let mut of_simulator = vec![0; play.simulator().snapshot_size()];
    play.simulator().save_snapshot(&mut of_simulator).unwrap();
    assert!(play.load_snapshot(&of_simulator).unwrap_err().to_string().contains("one of a simulator"));
    assert_eq!(saved(&play), bytes);
    type Change = fn(&mut Scene);
    let changes: [(Change, &str); 3] = [
        (|scene| scene.options.key.run += 1, "other options, or of another run"),
        (|scene| scene.unit.start = None, "is there or not"),
        (|scene| scene.duration_s = Some(20.0), "more than the scene has"),
    ];
    for (change, words) in changes {
        let mut scene = (*given.scene).clone();
        change(&mut scene);
        let mut other = Play::new(Arc::new(scene), given.source()).unwrap();
        let error = other.load_snapshot(&bytes).unwrap_err();
        assert!(error.kind == ErrorKind::Snapshot && error.to_string().contains(words), "{error}");
    }
}
