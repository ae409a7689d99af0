//! `sins_identify_check`: whether real sensors drift as the sensors that were found in their record do.

use super::fields::in_fields;
use super::{sins_identify, with_identify};
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::memory::{Output, interface_struct, read};
use crate::analysis::identify::check::{Agreement, Check, CheckRequest, Span, TruthSigma};
use crate::base::error::check_integer;

/// Verdicts on the model of the sensors.
pub type sins_agreement = i32;

/// The real drift is as that of the twins.
pub const SINS_AGREEMENT_AGREES: sins_agreement = 0;
/// The real sensors drift farther than the model.
pub const SINS_AGREEMENT_TOO_GOOD: sins_agreement = 1;
/// The model drifts farther than the real sensors.
pub const SINS_AGREEMENT_TOO_BAD: sins_agreement = 2;

/// What a check is made with. All zero: 100 twins along an exact path.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct sins_identify_check_request {
    /// sizeof(sins_identify_check_request)
    pub struct_size: u32,
    /// Number of twins, 40 to 1000; 0: 100.
    pub twins: u32,
    /// Standard deviation of the position of the path, each axis, 0 to 1e4 [m]. Each flight of a twin begins with such an error.
    pub position_m: f64,
    /// Standard deviation of the velocity of the path, each axis, 0 to 1e3 [m/s].
    pub velocity_m_s: f64,
    /// Standard deviation of the tilt of the path about east and about north, 0 to 0.3 [rad].
    pub tilt_rad: f64,
    /// Standard deviation of the heading of the path, 0 to 0.3 [rad].
    pub heading_rad: f64,
}

interface_struct!(sins_identify_check_request, "request", 40);

/// The result of a check as a whole.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_identified_check {
    /// sizeof(sins_identified_check)
    pub struct_size: u32,
    /// Verdict of the duration that is farthest off, of enum sins_agreement.
    pub agreement: i32,
    /// How many times as far the real sensors drift (SINS_AGREEMENT_TOO_GOOD) or the model drifts (SINS_AGREEMENT_TOO_BAD); else 1 [1].
    pub factor: f64,
    /// Length of the part of the record that was checked [s].
    pub length_s: f64,
    /// Number of twins.
    pub twins: u64,
    /// Number of durations.
    pub spans: u64,
    /// Shortest duration that is left out because half of the flights of the record or of a twin diverge; longer ones are too [s]; 0: none.
    pub diverged_s: f64,
}

interface_struct!(sins_identified_check, "check", 48);

/// Flights of one duration. A drift is the horizontal distance from the path at the end of a flight; it is infinite if the flight diverged.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_identified_span {
    /// sizeof(sins_identified_span)
    pub struct_size: u32,
    /// Verdict on this duration, of enum sins_agreement.
    pub agreement: i32,
    /// As sins_identified_check.factor [1].
    pub factor: f64,
    /// The duration [s].
    pub duration_s: f64,
    /// Number of flights.
    pub flights: u64,
    /// Number of flights that do not overlap.
    pub apart: u64,
    /// Median drift of the flights on the record as it is [m].
    pub free_m: f64,
    /// Median drift with the errors removed that were found [m].
    pub real_m: f64,
    /// Lower end of the 95 % interval of real_m: order statistics, for the number of flights that do not overlap [m].
    pub real_low_m: f64,
    /// Upper end of that interval [m].
    pub real_high_m: f64,
    /// Root mean square of the drifts with the errors removed [m].
    pub real_rms_m: f64,
    /// Median drift of the flights of a twin: geometric mean of the twins [m].
    pub predicted_m: f64,
    /// Lower end of the interval of predicted_m that 95 % of the twins keep at all durations together [m].
    pub predicted_low_m: f64,
    /// Upper end of that interval [m].
    pub predicted_high_m: f64,
    /// Root mean square of the drifts of all flights of all twins [m].
    pub predicted_rms_m: f64,
}

interface_struct!(sins_identified_span, "span", 112);

impl sins_identify_check_request {
    fn to_request(self) -> CheckRequest {
        let Self { position_m, velocity_m_s, tilt_rad, heading_rad, .. } = self;
        let truth = TruthSigma { position_m, velocity_m_s, tilt_rad, heading_rad };
        let usual = CheckRequest::default();
        let twins = if self.twins == 0 { usual.twins } else { self.twins as usize };
        CheckRequest { twins, truth, ..usual }
    }
}

/// A verdict and its factor.
fn numbers(agreement: &Agreement) -> (sins_agreement, f64) {
    match agreement {
        Agreement::Agrees => (SINS_AGREEMENT_AGREES, 1.0),
        Agreement::TooGood(factor) => (SINS_AGREEMENT_TOO_GOOD, *factor),
        Agreement::TooBad(factor) => (SINS_AGREEMENT_TOO_BAD, *factor),
    }
}

impl sins_identified_check {
    fn new(check: &Check) -> Self {
        let (agreement, factor) = numbers(&check.agreement);
        Self {
            struct_size: size_of::<Self>() as u32,
            agreement,
            factor,
            length_s: check.length_s,
            twins: check.twins as u64,
            spans: check.spans.len() as u64,
            diverged_s: check.diverged_s.unwrap_or(0.0),
        }
    }
}

impl sins_identified_span {
    fn new(span: &Span) -> Self {
        let (agreement, factor) = numbers(&span.agreement);
        Self {
            struct_size: size_of::<Self>() as u32,
            agreement,
            factor,
            duration_s: span.duration_s,
            flights: span.flights as u64,
            apart: span.apart as u64,
            free_m: span.free_m,
            real_m: span.real_m,
            real_low_m: span.real_interval_m.0,
            real_high_m: span.real_interval_m.1,
            real_rms_m: span.real_rms_m,
            predicted_m: span.predicted_m,
            predicted_low_m: span.predicted_interval_m.0,
            predicted_high_m: span.predicted_interval_m.1,
            predicted_rms_m: span.predicted_rms_m,
        }
    }
}

/// Finds the errors of the sensors in the first half of the increments that the path has, and checks in the other half how far the sensors
/// drift: as sins identify --check. The other half is navigated from many starts, with the errors removed that were found. Twins, sensors
/// that are drawn from what was found, fly the same starts. What was found is then that of the first half. docs/identify.md explains the
/// verdict. The handle must have SINS_IDENTIFY_STATES. request may be NULL: as all zero; check may be NULL.
///
/// Not for a real-time frame: during the call it allocates up to 72 bytes an increment, 200 bytes a sample and some MB, and it flies each
/// twin, which takes seconds to minutes. The call takes up to 256 KB of stack. On an error, what was found and what was checked stays.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range; the record does not fit the path, as sins_identify_solve(); or a half of it is
/// shorter than 20 s.
/// SINS_ERROR_BAD_STATE: the handle lacks SINS_IDENTIFY_STATES, the path has fewer than four intervals, the fit fails without a figure, or
/// half of the flights of 10 s diverge. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_check(
    identify: *mut sins_identify,
    request: *const sins_identify_check_request,
    check: *mut sins_identified_check,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::if_wanted(check, "check")? };
        let request = match request.is_null() {
            true => CheckRequest::default(),
            // SAFETY: the host's promise.
            false => unsafe { read(request, "request")? }.to_request(),
        };
        let checked = feed.check(&request).map_err(in_fields)?;
        if let Some(output) = output {
            output.write(&sins_identified_check::new(checked));
        }
        Ok(SINS_OK)
    })
}

/// Reads the flights of a duration that the last sins_identify_check() made. index is from 0 to sins_identified_check.spans - 1: 10, 30,
/// 60, 120, 300, 600 s.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such duration. SINS_ERROR_BAD_STATE: nothing was checked yet.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_get_span(
    identify: *const sins_identify,
    index: usize,
    span: *mut sins_identified_span,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(span, "span")? };
        let spans = &feed.checked()?.spans;
        check_integer("index", index, 0, spans.len() as u64 - 1)?;
        let Some(one) = spans.get(index) else { return Err(CallError::internal()) };
        Ok(output.write(&sins_identified_span::new(one)))
    })
}
