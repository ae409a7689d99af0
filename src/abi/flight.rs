//! `sins_flight`: embedded flights.

use super::boundary::handle::{hand_out, with_object};
use super::boundary::tables::FLIGHTS;
use super::boundary::{enter, enter_without_simulator};
use super::failure::{CallError, sins_status};
use super::manoeuvre::sins_manoeuvre;
use super::memory::{Array, Output, put, read};
use super::parameters::{Parameters, params};
use super::sample::sins_flight_sample;
use crate::base::error::check_integer;
use crate::base::memory::room;
use crate::base::rows::copy;
use crate::truth::flight::{Flight, FlightStart, MAX_MANOEUVRES, Manoeuvre};

/// An embedded flight. A handle is a checked key, as that of sins_sim, and never taken for one.
#[repr(C)]
pub struct sins_flight {
    _opaque: [u8; 0],
}

include!(concat!(env!("OUT_DIR"), "/start_params.rs"));

params!(sins_flight_start, "start", 72, FlightStart, copy, earth: ellipsoid);

/// Creates a flight from an array of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time,
/// smooth to the third derivative; the position is their integral, exact to rounding. manoeuvres[0].struct_size is the size
/// in bytes of each element of manoeuvres.
///
/// Not for a real-time frame: it allocates, and integrates the path in pieces, about 15 us and 0.5 KB each. A piece of
/// straight flight lasts up to 600 s. With a fast sinusoid of course, climb or speed, a piece is about one period. Sinusoids
/// of roll, pitch and heading need no pieces.
///
/// On an error *flight is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a path that leaves the range of sins_flight_sample.height_m (the
/// index in the sentence is that of the manoeuvre).
/// SINS_ERROR_OUT_OF_MEMORY: no memory, more than 200000 pieces (which take 3 s), or 4096 flights exist.
///
/// ```c
/// sins_flight_start start;
/// sins_manoeuvre turn;
/// sins_flight *flight = NULL;
/// double duration_s = 0.0;
/// SINS_INIT(start);
/// SINS_INIT(turn);
/// start.speed_m_s = 200.0;
/// turn.kind = SINS_MANOEUVRE_TURN;
/// turn.heading_change_rad = 90.0 * SINS_DEG;
/// turn.bank_rad = 30.0 * SINS_DEG;
/// turn.ramp_s = 5.0;
/// sins_flight_create(&start, &turn, 1, &flight);
/// sins_flight_duration(flight, &duration_s);
/// printf("%.0f s\n", duration_s);  // 60 s
/// sins_flight_destroy(flight);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_flight_create(
    start: *const sins_flight_start,
    manoeuvres: *const sins_manoeuvre,
    count: usize,
    flight: *mut *mut sins_flight,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&FLIGHTS, flight, "flight", || {
                let (start, list) = read_flight(start, manoeuvres, count)?;
                Ok(Flight::new(&start, &list)?)
            })
        }
    })
}

/// The start and the manoeuvres of a host, checked each by itself.
///
/// # Safety
/// As the exported functions: each pointer is null or points to a struct, `manoeuvres` to `count` of them.
pub(super) unsafe fn read_flight(
    start: *const sins_flight_start,
    manoeuvres: *const sins_manoeuvre,
    count: usize,
) -> Result<(FlightStart, Vec<Manoeuvre>), CallError> {
    // SAFETY: as this function.
    let start = unsafe { read(start, "start")? }.to_parameters()?;
    check_integer("count", count, 1, MAX_MANOEUVRES as u64)?;
    // SAFETY: as this function; manoeuvres are only read.
    let manoeuvres = unsafe { Array::new(manoeuvres.cast_mut(), count, "manoeuvres")? };
    let mut list = room(count)?;
    for index in 0..count {
        list.push(manoeuvres.read(index)?.to_manoeuvre().map_err(|failure| failure.of_element(index))?);
    }
    Ok((start, list))
}

/// Reads the duration of the flight [s].
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_flight_duration(
    flight: *const sins_flight,
    duration_s: *mut f64,
) -> sins_status {
    with_object(&FLIGHTS, flight, |flight| {
        // SAFETY: the host's promise.
        unsafe { put(duration_s, flight.duration_s(), "duration_s") }
    })
}

/// Reads the sample at time_s, from 0 to the duration [s]. It is exact at any time, and times may come in any order. No
/// allocation; 0.5 to 2 us.
///
/// SINS_ERROR_INVALID_ARGUMENT: a time before the start or after the end.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_flight_sample_at(
    flight: *const sins_flight,
    time_s: f64,
    sample: *mut sins_flight_sample,
) -> sins_status {
    with_object(&FLIGHTS, flight, |flight| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(sample, "sample")? };
        Ok(output.write(&sins_flight_sample::from(&flight.sample_at(time_s)?)))
    })
}

/// Destroys a flight.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_flight_destroy(flight: *mut sins_flight) -> sins_status {
    enter(|| FLIGHTS.remove(flight.addr()))
}
