//! `sins_flight`: embedded flights.

use super::boundary::{enter, enter_without_simulator, remember};
use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{Array, Output, interface_struct, put, read};
use super::options::{check_reserved, one_of, sins_options};
use super::registry::Registry;
use super::sample::sins_flight_sample;
use crate::error::{Error, Rule, check_range};
use crate::flight::{Channel, Flight, FlightStart, MAX_MANOEUVRES, MAX_SINUSOIDS, Manoeuvre, Sinusoid};

/// At rest for duration_s; the speed must be 0.
pub const SINS_MANOEUVRE_REST: i32 = 0;
/// Along a geodesic at constant speed and height for duration_s.
pub const SINS_MANOEUVRE_STRAIGHT: i32 = 1;
/// By speed_change_m_s in duration_s.
pub const SINS_MANOEUVRE_ACCELERATE: i32 = 2;
/// By height_change_m in duration_s, ramp_s.
pub const SINS_MANOEUVRE_CLIMB: i32 = 3;
/// Level coordinated turn by heading_change_rad (right positive) at bank_rad, ramp_s to roll in and out; the duration
/// follows.
pub const SINS_MANOEUVRE_TURN: i32 = 4;
/// turns whole rolls (right positive) in duration_s along a straight path.
pub const SINS_MANOEUVRE_ROLL: i32 = 5;
/// turns whole vertical loops (nose up positive) in duration_s at constant speed, ramp_s.
pub const SINS_MANOEUVRE_LOOP: i32 = 6;
/// Course swings by heading_change_rad to both sides, turns times in duration_s, ramp_s.
pub const SINS_MANOEUVRE_S_TURN: i32 = 7;
/// Sum of sinusoid_count sinusoids for duration_s, ramp_s: patrol patterns, rocking, coning, vibration.
pub const SINS_MANOEUVRE_SINUSOIDS: i32 = 8;

/// The sinusoid moves the course [rad], with the bank of a coordinated turn.
pub const SINS_CHANNEL_COURSE: i32 = 0;
/// The sinusoid moves the climb angle [rad].
pub const SINS_CHANNEL_CLIMB: i32 = 1;
/// The sinusoid moves the speed [m/s].
pub const SINS_CHANNEL_SPEED: i32 = 2;
/// The sinusoid moves roll alone [rad].
pub const SINS_CHANNEL_ROLL: i32 = 3;
/// The sinusoid moves pitch alone [rad].
pub const SINS_CHANNEL_PITCH: i32 = 4;
/// The sinusoid moves heading alone [rad].
pub const SINS_CHANNEL_HEADING: i32 = 5;

/// An embedded flight. A handle is a checked key, as that of sins_sim, and never taken for one.
#[repr(C)]
pub struct sins_flight {
    _opaque: [u8; 0],
}

/// Where an embedded flight begins, level and straight.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_flight_start {
    /// sizeof(sins_flight_start)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Geodetic latitude, -pi/2 to pi/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid, -20 km to 2000 km [m].
    pub height_m: f64,
    /// Speed against the Earth, 0 to 10 km/s [m/s].
    pub speed_m_s: f64,
    /// Course and heading [rad].
    pub heading_rad: f64,
    /// Roll of the body against the path's axes throughout the flight [rad].
    pub roll_rad: f64,
    /// Pitch of the body against the path's axes throughout the flight: angle of attack, or tilt at rest [rad].
    pub pitch_rad: f64,
    /// SINS_EARTH_..., as in the options of the simulator that will fly it.
    pub earth: i32,
    /// Must be 0.
    pub reserved2: u32,
}

interface_struct!(sins_flight_start, "start", 72);

/// One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_manoeuvre {
    /// sizeof(sins_manoeuvre); in an array it is enough to set it in the first element and 0 in the others.
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// SINS_MANOEUVRE_...
    pub kind: i32,
    /// Sinusoids, 1 to 6.
    pub sinusoid_count: i32,
    /// Duration, 1e-3 to 1e8 [s].
    pub duration_s: f64,
    /// Time in which the manoeuvre sets in, and in which it ends; at most half of it. 0: 5 s [s].
    pub ramp_s: f64,
    /// Change of speed [m/s].
    pub speed_change_m_s: f64,
    /// Change of height; the climb angle must stay below 64 degrees [m].
    pub height_change_m: f64,
    /// Change of heading, or amplitude of the swings of an S-turn [rad].
    pub heading_change_rad: f64,
    /// Bank of a turn, 1e-3 to 1.5 [rad].
    pub bank_rad: f64,
    /// Whole rolls or loops, or swings of an S-turn.
    pub turns: f64,
    /// SINS_CHANNEL_... of each sinusoid.
    pub channel: [i32; 6],
    /// Amplitude of each sinusoid [rad] or [m/s].
    pub amplitude: [f64; 6],
    /// Frequency of each sinusoid, 0 to 1000 [Hz].
    pub frequency_hz: [f64; 6],
    /// Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), t since the begin of the manoeuvre [rad].
    pub phase_rad: [f64; 6],
}

interface_struct!(sins_manoeuvre, "manoeuvre", 240);

static FLIGHTS: Registry<Flight> = Registry::new(2);

/// Runs `body` on the flight of a handle, as the inside of an exported function.
fn with_flight(
    flight: *const sins_flight,
    body: impl FnOnce(&mut Flight) -> Result<sins_status, Failure>,
) -> sins_status {
    enter(|| FLIGHTS.with(flight.addr(), |flight| body(flight).inspect_err(|&failure| remember(failure))))
}

/// Ramp where the host gives none [s].
const DEFAULT_RAMP_S: f64 = 5.0;

impl sins_manoeuvre {
    fn to_manoeuvre(self) -> Result<Manoeuvre, Failure> {
        check_reserved("manoeuvre.reserved", self.reserved)?;
        let ramp_s = if self.ramp_s == 0.0 { DEFAULT_RAMP_S } else { self.ramp_s };
        let Self {
            duration_s, speed_change_m_s, height_change_m, heading_change_rad, bank_rad, turns, ..
        } = self;
        // Kind, manoeuvre, and which of duration, ramp, speed, height, heading, bank, turns, sinusoids it uses.
        let (manoeuvre, uses) = match self.kind {
            SINS_MANOEUVRE_REST => (Manoeuvre::Rest { duration_s }, 0b1000_0000),
            SINS_MANOEUVRE_STRAIGHT => (Manoeuvre::Straight { duration_s }, 0b1000_0000),
            SINS_MANOEUVRE_ACCELERATE => {
                (Manoeuvre::Accelerate { duration_s, speed_change_m_s }, 0b1010_0000)
            }
            SINS_MANOEUVRE_CLIMB => (Manoeuvre::Climb { duration_s, height_change_m, ramp_s }, 0b1101_0000),
            SINS_MANOEUVRE_TURN => (Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s }, 0b0100_1100),
            SINS_MANOEUVRE_ROLL => (Manoeuvre::Roll { duration_s, turns }, 0b1000_0010),
            SINS_MANOEUVRE_LOOP => (Manoeuvre::Loop { duration_s, turns, ramp_s }, 0b1100_0010),
            SINS_MANOEUVRE_S_TURN => {
                let heading_amplitude_rad = heading_change_rad;
                (Manoeuvre::STurn { duration_s, heading_amplitude_rad, cycles: turns, ramp_s }, 0b1100_1010)
            }
            SINS_MANOEUVRE_SINUSOIDS => {
                check_range(
                    "manoeuvre.sinusoid_count",
                    f64::from(self.sinusoid_count),
                    1.0,
                    MAX_SINUSOIDS as f64,
                )?;
                let count = self.sinusoid_count as usize;
                let terms = self.sinusoids(count)?;
                (Manoeuvre::Sinusoids { duration_s, ramp_s, terms, count }, 0b1100_0001)
            }
            kind => {
                let rule = Rule::Words("must be a SINS_MANOEUVRE_ constant, 0 to 8");
                return Err(Error::invalid("manoeuvre.kind", f64::from(kind), rule).into());
            }
        };
        let fields = [
            ("manoeuvre.duration_s", duration_s),
            ("manoeuvre.ramp_s", self.ramp_s),
            ("manoeuvre.speed_change_m_s", speed_change_m_s),
            ("manoeuvre.height_change_m", height_change_m),
            ("manoeuvre.heading_change_rad", heading_change_rad),
            ("manoeuvre.bank_rad", bank_rad),
            ("manoeuvre.turns", turns),
            ("manoeuvre.sinusoid_count", f64::from(self.sinusoid_count)),
        ];
        for (bit, (field, value)) in fields.into_iter().enumerate() {
            if value != 0.0 && uses & (0b1000_0000 >> bit) == 0 {
                return Err(Error::invalid(
                    field,
                    value,
                    Rule::Words("must be 0: this kind does not use it"),
                )
                .into());
            }
        }
        Ok(manoeuvre)
    }

    fn sinusoids(&self, count: usize) -> Result<[Sinusoid; MAX_SINUSOIDS], Failure> {
        const CHANNELS: [(i32, Channel); 6] = [
            (SINS_CHANNEL_COURSE, Channel::Course),
            (SINS_CHANNEL_CLIMB, Channel::Climb),
            (SINS_CHANNEL_SPEED, Channel::Speed),
            (SINS_CHANNEL_ROLL, Channel::Roll),
            (SINS_CHANNEL_PITCH, Channel::Pitch),
            (SINS_CHANNEL_HEADING, Channel::Heading),
        ];
        let none = Sinusoid { channel: Channel::Course, amplitude: 0.0, frequency_hz: 0.0, phase_rad: 0.0 };
        let mut terms = [none; MAX_SINUSOIDS];
        for (i, term) in terms.iter_mut().enumerate().take(count) {
            *term = Sinusoid {
                channel: one_of(
                    "manoeuvre.channel",
                    self.channel[i],
                    &CHANNELS,
                    "must be a SINS_CHANNEL_ constant, 0 to 5",
                )?,
                amplitude: self.amplitude[i],
                frequency_hz: self.frequency_hz[i],
                phase_rad: self.phase_rad[i],
            };
        }
        Ok(terms)
    }
}

/// Creates a flight of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time, smooth
/// to the third derivative; position is their integral to rounding. manoeuvres[0].struct_size tells how far apart they are.
///
/// On an error *flight is untouched, and sins_last_error(NULL, ...) on this thread tells why: SINS_ERROR_INVALID_ARGUMENT a
/// value out of its range (the index in the sentence is that of the manoeuvre), SINS_ERROR_OUT_OF_MEMORY a flight too long.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_flight_create(
    start: *const sins_flight_start,
    manoeuvres: *const sins_manoeuvre,
    count: usize,
    flight: *mut *mut sins_flight,
) -> sins_status {
    enter_without_simulator(|| {
        if flight.is_null() {
            return Err(Failure::null("flight"));
        }
        // SAFETY: the host's promise.
        let start = unsafe { read(start, "start")? };
        check_reserved("start.reserved", start.reserved)?;
        check_reserved("start.reserved2", start.reserved2)?;
        check_range("count", count as f64, 1.0, MAX_MANOEUVRES as f64)?;
        // SAFETY: the host's promise; manoeuvres are only read.
        let manoeuvres = unsafe { Array::new(manoeuvres.cast_mut(), count, "manoeuvres")? };
        let mut list = Vec::new();
        list.try_reserve_exact(count).map_err(|_| Failure::out_of_memory())?;
        for index in 0..count {
            list.push(manoeuvres.read(index)?.to_manoeuvre().map_err(|failure| failure.of_element(index))?);
        }
        let start = FlightStart {
            latitude_rad: start.latitude_rad,
            longitude_rad: start.longitude_rad,
            height_m: start.height_m,
            speed_m_s: start.speed_m_s,
            heading_rad: start.heading_rad,
            roll_rad: start.roll_rad,
            pitch_rad: start.pitch_rad,
            ellipsoid: sins_options::ellipsoid("start.earth", start.earth)?,
        };
        let key = FLIGHTS.insert(Flight::new(&start, &list)?)?;
        // SAFETY: the host's promise.
        unsafe { put(flight, core::ptr::without_provenance_mut(key), "flight")? };
        Ok(SINS_OK)
    })
}

/// Length of the flight [s].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_flight_duration(
    flight: *const sins_flight,
    duration_s: *mut f64,
) -> sins_status {
    with_flight(flight, |flight| {
        // SAFETY: the host's promise.
        unsafe { put(duration_s, flight.duration_s(), "duration_s")? };
        Ok(SINS_OK)
    })
}

/// The sample at time_s, 0 to the duration [s]: exact at any time, in any order.
///
/// SINS_ERROR_INVALID_ARGUMENT: a time before the start or after the end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_flight_sample_at(
    flight: *const sins_flight,
    time_s: f64,
    sample: *mut sins_flight_sample,
) -> sins_status {
    with_flight(flight, |flight| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(sample, "sample")? };
        output.write(&sins_flight_sample::from_sample(&flight.sample_at(time_s)?));
        Ok(SINS_OK)
    })
}

/// Destroys a flight.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_flight_destroy(flight: *mut sins_flight) -> sins_status {
    enter(|| FLIGHTS.remove(flight.addr()))
}
