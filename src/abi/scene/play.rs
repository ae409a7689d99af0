//! `sins_play`: a scene in flight.

use std::sync::Arc;

use super::log::{log_of, sins_log};
use super::{sins_scene, with_scene};
use crate::abi::answer::fill_or_need;
use crate::abi::boundary::handle::{hand_out, with_object};
use crate::abi::boundary::tables::{PLAYS, PlayHandles, SIMULATORS, UNITS};
use crate::abi::boundary::{enter, remember_as};
use crate::abi::failure::{CallError, SINS_NEED_SAMPLE, SINS_OK, SINS_PLAY_END, sins_status};
use crate::abi::imu::sins_imu;
use crate::abi::memory::{Array, Output, put, put_if_wanted, read};
use crate::abi::record::{RecordView, sins_record};
use crate::abi::sample::sins_flight_sample;
use crate::abi::sentence::Sentence;
use crate::abi::simulator::{pushed, sins_sim};
use crate::abi::unit::sins_unit;
use crate::abi::unit_status::{sins_unit_navigation, sins_unit_status};
use crate::base::error::{Error, check_integer};
use crate::log::FlightLog;
use crate::scene::{Itinerary, Scene, Source, Stopped, shown};
use crate::simulator::Simulator;
use crate::unit::Unit;

/// A scene in flight: its simulator, its unit if the scene has one, its samples, and the place in its plan. A handle is a checked key,
/// like that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its
/// functions.
#[repr(C)]
pub struct sins_play {
    _opaque: [u8; 0],
}

/// Runs `body` on a scene in flight with its simulator and its unit, as the inside of an exported function.
pub(super) fn with_play(
    play: *mut sins_play,
    body: impl FnOnce(
        &mut Itinerary,
        &mut Box<[Simulator; 1]>,
        Option<&mut Unit>,
    ) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&PLAYS, play, |PlayHandles { itinerary, sim, unit }| {
        let mut result = Ok(SINS_OK);
        let mut status = SINS_OK;
        let fly = |unit: Option<&mut Unit>| {
            status = SIMULATORS.with(*sim, |simulator| {
                result = body(itinerary, simulator, unit);
                Ok(SINS_OK)
            });
        };
        let of_unit = match *unit {
            Some(unit) => UNITS.with(unit, |unit| {
                fly(Some(unit));
                Ok(SINS_OK)
            }),
            None => {
                fly(None);
                SINS_OK
            }
        };
        match (of_unit, status) {
            (SINS_OK, SINS_OK) => result,
            (SINS_OK, status) => Err(CallError::of_handle(status, "simulator of the scene in flight")),
            (status, _) => Err(CallError::of_handle(status, "unit of the scene in flight")),
        }
    })
}

/// The status of a flight that stopped; the sentence has time and line.
fn stopped(stopped: &Stopped) -> sins_status {
    let Stopped { error, time_s, line } = *stopped;
    let failure = CallError::from(error);
    let sentence = match line {
        Some(line) => Sentence::new(format_args!("at {time_s} s, line {line} of the log: {failure}")),
        None => Sentence::new(format_args!("at {time_s} s: {failure}")),
    };
    remember_as(failure, sentence);
    failure.status
}

/// Makes a scene ready for its flight. The scene is copied: later changes of it, and its end, change nothing. If the flight of the
/// scene is made of manoeuvres or built in, log is NULL. If it is a log, log is that log, or NULL for a host that pushes all
/// samples; the log may be destroyed after this call.
///
/// A scene in flight is all that a host needs: sins_play_next() flies to the next sample, sins_play_run() to the end,
/// sins_play_push() to a sample of the host. Each does what the scene plans: temperature, failures and updates, as
/// sins_scene_prepare(), then push and step, then the panel and the unit, as sins_scene_update_unit().
///
/// Not for a real-time frame: it allocates. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators, units or scenes in flight exist.
/// SINS_ERROR_INVALID_ARGUMENT: settings that do not go together; or as sins_scene_get_samples().
/// SINS_ERROR_BAD_HANDLE: scene or log is not a valid handle. SINS_ERROR_BAD_STATE: as sins_scene_parse().
///
/// ```c
/// sins_scene *patrol = NULL;
/// sins_play *play = NULL;
/// sins_sim *flown = NULL;
/// sins_record ends[3];
/// size_t count = 0;
/// SINS_INIT(ends[0]);
/// sins_scene_create_builtin("patrol", &patrol);
/// sins_scene_set_values(patrol, "flight.hours = 0.1\noutput.every_s = 180");
/// sins_play_create(patrol, NULL, &play);
/// sins_play_run(play, ends, 3, &count);
/// printf("%d records, the last one at %.0f s\n", (int)count, ends[2].time_s);  // 3 records, the last one at 360 s
/// sins_play_get_simulator(play, &flown);
/// sins_get_navigation(flown, &navigation);
/// printf("%.0f s\n", navigation.time_s);  // 360 s
/// printf("%s\n", sins_status_string(sins_play_next(play)));  // SINS_PLAY_END
/// sins_play_destroy(play);
/// sins_scene_destroy(patrol);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_create(
    scene: *const sins_scene,
    log: *const sins_log,
    play: *mut *mut sins_play,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&PLAYS, play, "play", || {
                scene.check()?;
                make(scene, log_of(log)?)
            })
        }
    })
}

fn make(scene: &Scene, log: Option<Arc<FlightLog>>) -> Result<PlayHandles, CallError> {
    let source = match log {
        Some(log) => Source::Log(log),
        None if scene.is_log() => Source::Host,
        None => Source::flight_of(scene)?,
    };
    let itinerary = Itinerary::new(Arc::new(scene.clone()), source)?;
    let unit = scene.unit()?;
    // What this owns is destroyed if the unit finds no place.
    let mut made = PlayHandles { itinerary, sim: SIMULATORS.insert(scene.simulator()?)?, unit: None };
    made.unit = unit.map(|unit| UNITS.insert(unit)).transpose()?;
    Ok(made)
}

/// Flies to the next sample of the scene. The first call takes the first sample, which begins the first interval. No allocation, no
/// system call.
///
/// SINS_PLAY_END: there is no further sample; nothing was flown.
/// SINS_GAP: as sins_push_sample().
/// SINS_ERROR_BAD_STATE: the scene is flown on samples of the host, or an entry at the panel came at the wrong moment; the interval was
/// flown. The errors of sins_push_sample() and sins_step(). The sentence of sins_last_error(NULL, ...) begins with the time stamp of the
/// sample, and its line if the flight is a log. After an error of a push or a step the next call tries the same interval again.
/// SINS_ERROR_BAD_HANDLE: play is not a valid handle, or its simulator or its unit was destroyed.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_next(play: *mut sins_play) -> sins_status {
    with_play(play, |itinerary, simulator, unit| {
        Ok(match itinerary.fly_next(&mut simulator[0], unit) {
            Ok(Some(flown)) => pushed(flown),
            Ok(None) => SINS_PLAY_END,
            Err(error) => stopped(&error),
        })
    })
}

/// Flies to a sample of the host, in place of the scene's next one: for a flight simulator, a cockpit, a stream of packets. The times of
/// the scene count from the first sample. The simulator is that of sins_scene_create_simulator(): a scene whose flight is not a log states
/// the period 1 / rate_hz. A sample that is rejected changes nothing of what later samples lead to. No allocation, no system call.
///
/// SINS_GAP, and the errors: as sins_play_next().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_push(
    play: *mut sins_play,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_play(play, |itinerary, simulator, unit| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? }.to_sample()?;
        Ok(match itinerary.push(&mut simulator[0], unit, &sample) {
            Ok(flown) => pushed(flown),
            Err(error) => stopped(&error),
        })
    })
}

/// Flies until the array of records is full, or to the end. There is a record of the first sample, of the last one, and in between as
/// far apart as the scene says (sins_scene_samples.record_every), those of the files of the program sins. capacity 0: no records; the
/// call flies to the end. A host that shows its progress, or that can be interrupted, calls the function again and again with a few
/// records each. written (may be NULL) gets the number of records, also on an error. No allocation.
///
/// SINS_OK: the array is full. SINS_PLAY_END: the flight is over. The errors of sins_play_next().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_run(
    play: *mut sins_play,
    records: *mut sins_record,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    let mut done = 0;
    let status = with_play(play, |itinerary, simulator, mut unit| {
        let [simulator] = &mut **simulator;
        // SAFETY: the host's promise.
        let records = unsafe { Array::new(records, capacity, "records")? };
        loop {
            match itinerary.fly_next(simulator, unit.as_deref_mut()) {
                Ok(Some(_)) => {}
                Ok(None) => return Ok(SINS_PLAY_END),
                Err(error) => return Ok(stopped(&error)),
            }
            if capacity > 0 && itinerary.is_due() {
                fill_or_need::<RecordView>(simulator, &records.output(done)?)?;
                done += 1;
                if done == capacity {
                    return Ok(SINS_OK);
                }
            }
        }
    });
    // SAFETY: the host's promise.
    unsafe { put_if_wanted(written, done) };
    status
}

/// Flies until the array is full, or to the end, with the signals of each interval, as sins_get_imu() reads them: for a host's own
/// navigator or filter, which gets the increments of a whole stretch in one call. Corrections of sins_correct() act from the next call on.
/// The first sample of a flight begins the first interval, and has no element. imu[0].struct_size is the size in bytes of each element of
/// imu; that of the other elements may be anything. written (may be NULL) gets the number of elements, also on an error. No allocation, no
/// system call.
///
/// SINS_OK: the array is full. SINS_PLAY_END: the flight is over. SINS_ERROR_INVALID_ARGUMENT: capacity is 0. The errors of
/// sins_play_next().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_run_imu(
    play: *mut sins_play,
    imu: *mut sins_imu,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    let mut done = 0;
    let status = with_play(play, |itinerary, simulator, mut unit| {
        let [simulator] = &mut **simulator;
        check_integer("capacity", capacity, 1, u64::MAX)?;
        // SAFETY: the host's promise.
        let imu = unsafe { Array::new(imu, capacity, "imu")? };
        while done < capacity {
            match itinerary.fly_next(simulator, unit.as_deref_mut()) {
                Ok(Some(_)) => {}
                Ok(None) => return Ok(SINS_PLAY_END),
                Err(error) => return Ok(stopped(&error)),
            }
            if let Some(signals) = simulator.imu() {
                imu.write(done, &sins_imu::from(&signals))?;
                done += 1;
            }
        }
        Ok(SINS_OK)
    });
    // SAFETY: the host's promise.
    unsafe { put_if_wanted(written, done) };
    status
}

/// Takes over what another scene plans, from the next interval on: temperature, failures, updates, the panel, as an instructor changes them
/// in flight. Failures that are no longer planned end. Flight, options, errors of the sensors and unit stay. The scene is copied. Not for
/// a real-time frame: it allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: settings that do not go together. SINS_ERROR_BAD_HANDLE: play or scene is not a valid handle.
/// SINS_ERROR_BAD_STATE: as sins_scene_parse(). After an error nothing has changed.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_set_plan(
    play: *mut sins_play,
    scene: *const sins_scene,
) -> sins_status {
    let mut plan = None;
    let status = with_scene(scene, |scene| {
        scene.check()?;
        plan = Some(scene.clone());
        Ok(SINS_OK)
    });
    match plan {
        None => status,
        Some(plan) => with_play(play, |itinerary, simulator, _| {
            itinerary.set_plan(&mut simulator[0], &plan)?;
            Ok(SINS_OK)
        }),
    }
}

/// Lends the simulator, for every read, and for corrections, repositions and what else a host does between two samples. The handle
/// belongs to play: it is destroyed with it. Do not push samples and make steps with it.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_get_simulator(
    play: *mut sins_play,
    sim: *mut *mut sins_sim,
) -> sins_status {
    with_object(&PLAYS, play, |play| {
        // SAFETY: the host's promise.
        unsafe { put(sim, core::ptr::without_provenance_mut(play.sim), "sim") }
    })
}

/// Lends the unit, for every read, and for a panel of the host. The handle belongs to play: it is destroyed with it. Do not call
/// sins_unit_update() with it.
///
/// SINS_ERROR_BAD_STATE: the scene has no unit.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_get_unit(
    play: *mut sins_play,
    unit: *mut *mut sins_unit,
) -> sins_status {
    with_object(&PLAYS, play, |play| {
        let key = play.unit.ok_or_else(|| Error::bad_state("the scene has no unit: set unit.start"))?;
        // SAFETY: the host's promise.
        unsafe { put(unit, core::ptr::without_provenance_mut(key), "unit") }
    })
}

/// Reads what the INS shows: status and navigation of the unit, as sins_unit_get_status() and sins_unit_get_navigation(). Without a unit
/// the INS navigates: the navigation is that of sins_get_navigation(), all valid but rates and forces. status (may be NULL) and
/// navigation (may be NULL). No allocation, no system call.
///
/// SINS_NEED_SAMPLE: no interval was flown. SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_get_shown(
    play: *mut sins_play,
    status: *mut sins_unit_status,
    navigation: *mut sins_unit_navigation,
) -> sins_status {
    with_play(play, |_, simulator, unit| {
        // SAFETY: the host's promise.
        let (status, navigation) =
            unsafe { (Output::if_wanted(status, "status")?, Output::if_wanted(navigation, "navigation")?) };
        let Some(found) = shown(&simulator[0], unit.as_deref())? else { return Ok(SINS_NEED_SAMPLE) };
        status.map(|output| output.write(&(&found.status).into()));
        navigation.map(|output| output.write(&(&found.navigation).into()));
        Ok(SINS_OK)
    })
}

/// Destroys a scene in flight with its simulator and its unit.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_play_destroy(play: *mut sins_play) -> sins_status {
    enter(|| PLAYS.remove(play.addr()))
}
