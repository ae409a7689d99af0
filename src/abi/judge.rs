//! `sins_judge`: what is wrong with the samples of a flight.

use core::ffi::c_char;

use super::boundary::handle::{hand_out, with_object};
use super::boundary::tables::JUDGES;
use super::boundary::{enter, enter_without_simulator};
use super::choice::{Choice, choices};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Array, interface_struct, put, read};
use super::options::sins_options;
use super::parameters::Parameters;
use super::sample::sins_flight_sample;
use super::sentence::Sentence;
use super::text::chars;
use crate::base::memory::{only, room};
use crate::judge::{Finding, Judge, Kind, Level, MAX_FINDINGS};
use crate::simulator::Options;

/// A judge of the samples of a flight. A handle is a checked key, like that of a sins_sim, and is never confused with one.
/// sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
#[repr(C)]
pub struct sins_judge {
    _opaque: [u8; 0],
}

include!(concat!(env!("OUT_DIR"), "/sins_finding_kind.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_finding_level.rs"));

/// Most findings of a flight.
pub const SINS_FINDINGS_MAX: usize = 32;
const _: () = assert!(SINS_FINDINGS_MAX == MAX_FINDINGS);

/// What a judge found.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_finding {
    /// sizeof(sins_finding)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// What was found, of enum sins_finding_kind.
    pub kind: i32,
    /// What it means for a flight of these samples, of enum sins_finding_level.
    pub level: i32,
    /// Number of the sample where it begins or is largest, the first is 0.
    pub sample: u64,
    /// Time stamp of that sample [s].
    pub time_s: f64,
    /// How often; 0: the whole flight.
    pub count: u64,
    /// Its figure, see enum sins_finding_kind.
    pub figure: f64,
    /// False acceleration that is flown for it; 0: none, or unknown [m/s2].
    pub acceleration_m_s2: f64,
    /// Largest horizontal error of an INS with ideal sensors for it, during the flight; 0: none, or unknown [m].
    pub ins_error_m: f64,
    /// It as a sentence, and what to do about it; UTF-8, terminated, cut if it is longer.
    pub sentence: [c_char; 384],
}

interface_struct!(sins_finding, "finding", 448);

impl sins_finding {
    fn new(finding: &Finding) -> Self {
        let Finding { kind, level, at, count, figure, acceleration_m_s2, ins_error_m, .. } = *finding;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            kind: kind.code(),
            level: level.code(),
            sample: at.row,
            time_s: at.time_s,
            count,
            figure,
            acceleration_m_s2,
            ins_error_m,
            sentence: chars(Sentence::new(format_args!("{}", finding.with_remedy())).as_str()),
        }
    }
}

/// Runs `body` on the judge of a handle, as the inside of an exported function.
pub(super) fn with_judge(
    judge: *const sins_judge,
    body: impl FnOnce(&mut Judge) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&JUDGES, judge, |judge| body(&mut judge[0]))
}

/// Creates a judge, which looks at the samples of a flight before an INS flies them, or while it does: a library that is given knots,
/// degrees, 32-bit positions or held rows computes exact errors of a flight that nobody flew. Of the options it takes the Earth, and the
/// largest acceleration. NULL: the defaults.
///
/// It takes 50 KB. Not for a real-time frame: it allocates. On an error *judge is unchanged, and sins_last_error(NULL, ...) on this thread
/// gives the reason.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_create(). SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 judges exist.
///
/// ```c
/// sins_judge *judge = NULL;
/// sins_finding found[SINS_FINDINGS_MAX];
/// size_t doubts = 0, i;
/// SINS_INIT(found[0]);
/// SINS_INIT(sample);
/// sins_judge_create(NULL, &judge);
/// for (i = 0; i < 1000; i++) {
///     sample.time_s = 0.1 * (double)i;
///     sample.latitude_rad = 100.0 * sample.time_s / 6356752.0;
///     sample.velocity_enu_m_s[1] = 100.0 * 3600.0 / 1852.0;
///     sins_judge_push(judge, &sample);
/// }
/// sins_judge_get_findings(judge, found, SINS_FINDINGS_MAX, &doubts);
/// printf("%.48s\n", found[0].sentence);  // velocity is 1.95 times the displacement (knots?)
/// sins_judge_destroy(judge);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_judge_create(
    options: *const sins_options,
    judge: *mut *mut sins_judge,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&JUDGES, judge, "judge", || {
                let options = match options.is_null() {
                    true => Options::default(),
                    false => read(options, "options")?.to_parameters()?,
                };
                options.validate()?;
                let mut place = room(1)?;
                place.push(Judge::new(options.earth(), options.intake.max_acceleration_m_s2)?);
                Ok(only(place)?)
            })
        }
    })
}

/// Looks at the next sample of the flight. A time stamp that is not later than the one before becomes a finding. No allocation, less than
/// 1 us.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range; the sample counts as not pushed.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_judge_push(
    judge: *mut sins_judge,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_judge(judge, |judge| {
        // SAFETY: the host's promise.
        judge.push(&unsafe { read(sample, "sample")? }.to_sample()?)?;
        Ok(SINS_OK)
    })
}

/// Reads what was found in the samples so far, the worst first, and their number (count), at most SINS_FINDINGS_MAX.
/// findings[0].struct_size is the size in bytes of each element of findings. To ask for count only, give NULL for findings and a capacity
/// of 0. A finding is a statistic: in a flight of less than 200 samples it may come from a few. No allocation.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of findings; only count was written.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_judge_get_findings(
    judge: *const sins_judge,
    findings: *mut sins_finding,
    capacity: usize,
    count: *mut usize,
) -> sins_status {
    with_judge(judge, |judge| {
        // SAFETY: the host's promise.
        unsafe {
            let places = Array::new(findings, capacity, "findings")?;
            let found = judge.findings();
            let number = found.clone().count();
            put(count, number, "count")?;
            if capacity == 0 && findings.is_null() {
                return Ok(SINS_OK);
            }
            if capacity < number {
                return Err(CallError::buffer("capacity", capacity, number));
            }
            for (index, finding) in found.enumerate() {
                places.write(index, &sins_finding::new(&finding))?;
            }
        }
        Ok(SINS_OK)
    })
}

/// Destroys a judge.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_judge_destroy(judge: *mut sins_judge) -> sins_status {
    enter(|| JUDGES.remove(judge.addr()))
}
