//! `sins_log`: flight logs.

use core::ffi::c_char;
use std::sync::Arc;

use super::fault::sins_fault;
use super::log_file::read_log;
use super::{ROOM as SCENE_ROOM, ROOM_OF_ITEM, sins_scene, text_has_faults};
use crate::abi::boundary::handle::{hand_out, with_object};
use crate::abi::boundary::tables::{LOGS, SCENES, SceneText};
use crate::abi::boundary::{enter, enter_without_simulator, remember_as};
use crate::abi::failure::{
    CallError, SINS_ERROR_BAD_HANDLE, SINS_ERROR_INVALID_ARGUMENT, SINS_OK, sins_status,
};
use crate::abi::judge::{sins_judge, with_judge};
use crate::abi::memory::{Array, Output, element, interface_struct, put_if_wanted};
use crate::abi::sample::sins_flight_sample;
use crate::abi::sentence::Sentence;
use crate::abi::text::{bytes_of, chars};
use crate::base::error::{Error, Rule};
use crate::base::memory::probe;
use crate::log::{FlightLog, LogError};
use crate::scene::Scene;

/// A flight log in memory. A handle is a checked key, as that of sins_sim, and never taken for one.
#[repr(C)]
pub struct sins_log {
    _opaque: [u8; 0],
}

/// Contents of a flight log.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_log_info {
    /// sizeof(sins_log_info)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Number of samples.
    pub samples: u64,
    /// Duration from the first to the last sample [s].
    pub duration_s: f64,
    /// The comment in the first line of a log with the columns of this library, UTF-8, terminated; empty: none, or the table of another
    /// program.
    pub title: [c_char; 192],
}

interface_struct!(sins_log_info, "info", 216);

/// What the parser takes beside the samples [bytes]; a field in quotes may be longer.
const ROOM: usize = 1 << 20;

/// Reads a flight log as the [log] of a scene says: which column has which quantity, in which unit, and whether its path is smoothed; a
/// scene flies only a log that was read by its own [log]. The text is UTF-8, UTF-16 with a byte order mark, or otherwise Windows-1252.
/// NULL for scene, or a scene without [log]: comma-separated values in lines that end with LF or CR LF. The first line that is not a
/// comment (#) names the columns, in any order; columns of other names are ignored, and a row with more fields than columns
/// is a fault:
///
/// time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg, heading_rad
/// or _deg; optional: velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s, rate_z_rad_s;
/// force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c
///
/// The three velocities are all present or all absent; so are the three rates, and the three forces. Without velocities the
/// samples have SINS_SAMPLE_NO_VELOCITY. Two columns of one quantity are a fault. Frames and signs are those of
/// sins_flight_sample. A log has at least two samples, each later than the one before. The ranges of the values are checked
/// when a sample is pushed. The library does not keep the bytes. Not for a real-time frame: it allocates, 184 bytes a
/// sample, and room for the text if it is not UTF-8.
///
/// The text may also be a flight record: IGC, GPX 1.0 or 1.1, or FDR version 4 of X-Plane. Its path is smoothed; its attitude is that of
/// the FDR, of the [log], or else that of a coordinated flight without wind. Its samples are those of the path, 50 a second unless the
/// scene sets log.smooth_rate_hz, and several have the line of one fix. While it is fitted it allocates some KB a fix more.
///
/// Where the [log] names columns of other files, their values are interpolated onto the times of the rows of the text; the host gives each
/// file to the scene before, by sins_scene_give_log_file(). A fault in such a file has line 0; its sentence begins with the name, and with
/// the line if it has one.
///
/// SINS_ERROR_INVALID_ARGUMENT: the text is not a valid flight log; fault (may be NULL) gets the first fault and its place,
/// sins_last_error(NULL, ...) gives both as a sentence, and *log is unchanged.
/// SINS_ERROR_OUT_OF_MEMORY: no memory for the samples, or 4096 logs exist.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_log_parse(
    text: *const c_char,
    size: usize,
    scene: *const sins_scene,
    log: *mut *mut sins_log,
    fault: *mut sins_fault,
) -> sins_status {
    let parse = |scene: &Scene, files: &[_]| {
        if log.is_null() {
            return Err(CallError::null("log"));
        }
        // SAFETY: the host's promise.
        let output = unsafe { Output::if_wanted(fault, "fault")? };
        // SAFETY: the host's promise.
        let text = unsafe { bytes_of(text.cast(), size, "text")? };
        probe(ROOM)?;
        match read_log(scene, text, files) {
            // SAFETY: the host's promise.
            Ok(found) => unsafe { hand_out(&LOGS, log, "log", || Ok(Arc::new(found))) },
            Err(LogError::Memory(error)) => Err(error.into()),
            Err(LogError::Fault(found)) => {
                if let Some(output) = output {
                    output.write(&sins_fault::new(&found, 1));
                }
                let error =
                    Error::invalid("line", found.line, Rule::Sentence("the text is not a flight log"));
                let (line, column, reason) = (found.line, found.column, &found.sentence);
                let sentence = if line > 0 {
                    Sentence::new(format_args!("line = {line}, column {column}: {reason}"))
                } else {
                    Sentence::new(format_args!("{reason}"))
                };
                remember_as(error.into(), sentence);
                Ok(SINS_ERROR_INVALID_ARGUMENT)
            }
        }
    };
    if scene.is_null() {
        enter_without_simulator(|| {
            probe(ROOM)?;
            parse(&Box::<Scene>::default(), &[])
        })
    } else {
        with_object(&SCENES, scene, |SceneText { scene, files, .. }| {
            let scene = scene.as_ref().ok_or_else(text_has_faults)?;
            probe(SCENE_ROOM + ROOM_OF_ITEM * scene.items())?;
            parse(scene, files)
        })
    }
}

/// Makes a log of an array of count samples, as sins_log_parse() of a text: for hosts that have a flight in memory. samples[0].struct_size
/// is the size in bytes of each element of samples; struct_size of the other samples may be 0. A log has at least two samples, each later
/// than the one before, with values in their ranges. Its title is empty. The samples are copied. Not for a real-time frame: it allocates,
/// 176 bytes a sample.
///
/// SINS_ERROR_INVALID_ARGUMENT: count is less than 2, or a value is out of its range; SINS_ERROR_TIME_ORDER: a sample is not later than the
/// one before. sins_last_error(NULL, ...) names the sample, and *log is unchanged.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_log_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_log_create(
    samples: *const sins_flight_sample,
    count: usize,
    log: *mut *mut sins_log,
) -> sins_status {
    enter_without_simulator(|| {
        if log.is_null() {
            return Err(CallError::null("log"));
        }
        let mut made = FlightLog::with_room(count)?;
        // SAFETY: the host's promise; samples are only read.
        let samples = unsafe { Array::new(samples.cast_mut(), count, "samples")? };
        for index in 0..count {
            made.append(samples.sample(index)?).map_err(|error| CallError::from(error).of_sample(index))?;
        }
        // SAFETY: the host's promise.
        unsafe { hand_out(&LOGS, log, "log", || Ok(Arc::new(made))) }
    })
}

/// The log of a handle; `None`: null.
pub(super) fn log_of(log: *const sins_log) -> Result<Option<Arc<FlightLog>>, CallError> {
    if log.is_null() {
        return Ok(None);
    }
    let mut found = None;
    let status = LOGS.with(log.addr(), |log| {
        found = Some(log.clone());
        Ok(SINS_OK)
    });
    found.map(Some).ok_or_else(|| CallError::of_handle(status, "log"))
}

/// Reads the number of samples of a log, its duration and its title.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_log_get_info(
    log: *const sins_log,
    info: *mut sins_log_info,
) -> sins_status {
    with_object(&LOGS, log, |log| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(info, "info")? };
        Ok(output.write(&sins_log_info {
            struct_size: size_of::<sins_log_info>() as u32,
            reserved: 0,
            samples: log.samples().len() as u64,
            duration_s: log.duration_s(),
            title: chars(&log.title),
        }))
    })
}

/// Reads sample `index`, from 0 in the order of the log, ready for sins_push_sample(). line (may be NULL) gets its line in
/// the text, from 1. No allocation.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_log_get_sample(
    log: *const sins_log,
    index: usize,
    sample: *mut sins_flight_sample,
    line: *mut u64,
) -> sins_status {
    with_object(&LOGS, log, |log| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(sample, "sample")? };
        let found = element(log.samples(), index, "must be less than the number of samples of the log:")?;
        output.write(&sins_flight_sample::from(found));
        // SAFETY: the host's promise.
        unsafe { put_if_wanted(line, log.line(index).unwrap_or_default()) };
        Ok(SINS_OK)
    })
}

/// Looks at the samples of a log, one after the other, as sins_judge_push(). Where a coordinated flight stands in for the attitude of the
/// log, attitudes are not judged. What was wrong in the rows of a log that was smoothed is found too, as a note if the path does not have
/// it.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, with the number of the sample; the samples before it were taken.
/// SINS_ERROR_BAD_HANDLE: judge or log is not a valid handle.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_judge_push_log(
    judge: *mut sins_judge,
    log: *const sins_log,
) -> sins_status {
    with_judge(judge, |judge| {
        let log = log_of(log)?.ok_or_else(|| CallError::of_handle(SINS_ERROR_BAD_HANDLE, "log"))?;
        let judged = log.judge(judge, log.samples().len());
        judged.map_err(|(index, error)| CallError::from(error).of_sample(index))?;
        Ok(SINS_OK)
    })
}

/// Destroys a flight log.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_log_destroy(log: *mut sins_log) -> sins_status {
    enter(|| LOGS.remove(log.addr()))
}
