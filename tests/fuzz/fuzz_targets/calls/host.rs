//! The host: its handles, what it can see of a simulator, and what it holds every call to.

use std::ptr::{null_mut, without_provenance_mut};

use sins::abi::*;

use crate::input::{Block, Input};

const HANDLES: usize = 3;

pub struct Host<'a> {
    pub input: Input<'a>,
    sims: [*mut sins_sim; HANDLES],
    flights: [*mut sins_flight; HANDLES],
    /// Where the next plausible sample is.
    time_s: f64,
}

/// A struct of zeros that states its size, as SINS_INIT makes it.
pub fn init<T: Copy>() -> T {
    // SAFETY: the structs of the interface are numbers.
    let mut value: T = unsafe { std::mem::zeroed() };
    // SAFETY: struct_size comes first.
    unsafe { std::ptr::from_mut(&mut value).cast::<u32>().write(size_of::<T>() as u32) };
    value
}

/// A status that the interface knows and that no defect is behind.
pub fn checked(status: sins_status) -> sins_status {
    assert!((-13..=2).contains(&status), "status {status}");
    status
}

/// The whole simulator; nothing without one.
fn frozen(sim: *mut sins_sim) -> Vec<u8> {
    let mut bytes = vec![0; SINS_SNAPSHOT_MAX_SIZE];
    let (mut size, mut written) = (0, 0);
    // SAFETY: as many bytes as it says.
    unsafe {
        if checked(sins_snapshot_save(sim, bytes.as_mut_ptr().cast(), bytes.len(), &mut written)) == SINS_OK {
            assert_eq!(checked(sins_snapshot_size(sim, &mut size)), SINS_OK);
            assert_eq!(size, written);
        }
    }
    bytes.truncate(written);
    bytes
}

/// Reads all there is of a simulator: numbers.
pub fn look(sim: *mut sins_sim) {
    fn check<T: Copy>(get: impl FnOnce(*mut T) -> sins_status) {
        let mut block = Block::of(&init::<T>());
        assert!(checked(get(block.pointer())) != SINS_OK || block.is_finite(), "a number that is none");
    }
    // SAFETY: each output has as many bytes as it says.
    unsafe {
        check::<sins_navigation>(|truth| sins_get_truth(sim, truth));
        check::<sins_navigation>(|navigation| sins_get_navigation(sim, navigation));
        for source in [SINS_ERRORS_NAVIGATION, SINS_ERRORS_MODEL] {
            check::<sins_errors>(|errors| sins_get_errors(sim, source, errors));
        }
        check::<sins_imu>(|imu| sins_get_imu(sim, imu));
        check::<sins_accuracy>(|accuracy| sins_get_accuracy(sim, accuracy));
        check::<sins_record>(|record| sins_get_record(sim, record));
        // The seed is any word.
        checked(sins_get_options(sim, &mut init()));
    }
}

impl<'a> Host<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        let mut host = Self {
            input: Input::new(bytes),
            sims: [null_mut(); HANDLES],
            flights: [null_mut(); HANDLES],
            time_s: 0.0,
        };
        host.create();
        host
    }

    /// One of the host's handles, living or not, or a made-up one.
    pub fn sim(&mut self) -> *mut sins_sim {
        match self.input.byte() {
            0..200 => self.sims[0],
            200..250 => self.sims[self.input.below(HANDLES)],
            _ => without_provenance_mut(self.input.word() as usize),
        }
    }

    pub fn flight(&mut self) -> *mut sins_flight {
        match self.input.byte() {
            0..250 => self.flights[self.input.below(HANDLES)],
            _ => without_provenance_mut(self.input.word() as usize),
        }
    }

    /// The sample after the last one: east along a parallel, turning slowly.
    pub fn plausible_sample(&mut self) -> sins_flight_sample {
        self.time_s += 1.0 / 128.0;
        sins_flight_sample {
            time_s: self.time_s,
            latitude_rad: 0.7,
            longitude_rad: self.time_s * (100.0 / 6378e3),
            height_m: 1000.0,
            heading_rad: 0.1 * self.time_s,
            flags: SINS_SAMPLE_NO_VELOCITY,
            ..init()
        }
    }

    /// A call that may change `sim`: it does not when it fails.
    pub fn changing(sim: *mut sins_sim, call: impl FnOnce(*mut sins_sim) -> sins_status) {
        let before = frozen(sim);
        if checked(call(sim)) < 0 {
            assert!(before == frozen(sim), "a failed call changed something");
        } else {
            look(sim);
        }
    }

    /// [`Self::changing`] with `value`, a few words of it altered.
    pub fn giving<T: Copy>(&mut self, value: T, call: impl FnOnce(*mut sins_sim, *const T) -> sins_status) {
        let sim = self.sim();
        let mut argument = self.input.changed(value);
        Self::changing(sim, |sim| call(sim, argument.pointer()));
    }

    pub fn create(&mut self) {
        let mut options = self.input.changed(sins_options { error_model: SINS_ERROR_MODEL_RK4, ..init() });
        let place = self.input.below(HANDLES);
        let mut sim = null_mut();
        // SAFETY: as many bytes as it says.
        if checked(unsafe { sins_create(options.pointer(), &mut sim) }) == SINS_OK {
            let old = std::mem::replace(&mut self.sims[place], sim);
            if !old.is_null() {
                // SAFETY: a key.
                checked(unsafe { sins_destroy(old) });
            }
        }
    }

    /// Keeps a flight in place of another.
    pub fn keep(&mut self, flight: *mut sins_flight) {
        let place = self.input.below(HANDLES);
        let old = std::mem::replace(&mut self.flights[place], flight);
        if !old.is_null() {
            // SAFETY: a key.
            checked(unsafe { sins_flight_destroy(old) });
        }
    }

    /// A snapshot of one simulator into any: the same then, or, an altered or cut one, refused.
    pub fn thaw(&mut self) {
        let (from, to) = (self.sim(), self.sim());
        let saved = frozen(from);
        let mut snapshot = saved.clone();
        if self.input.byte() >= 128 && !snapshot.is_empty() {
            let at = usize::from(self.input.byte()) * 256 + usize::from(self.input.byte());
            let length = snapshot.len();
            match self.input.byte() {
                0 => snapshot.truncate(at % length),
                change => snapshot[at % length] ^= change,
            }
        }
        let is_whole = snapshot == saved;
        Self::changing(to, |to| {
            // SAFETY: as many bytes as it says.
            let status = unsafe { sins_snapshot_load(to, snapshot.as_ptr().cast(), snapshot.len()) };
            assert!(is_whole || status < 0, "an altered snapshot was taken");
            assert!(status < 0 || frozen(to) == saved, "another simulator than the saved one");
            status
        });
    }

    /// Every handle is destroyed, so that a leak is the library's.
    pub fn leave(self) {
        // SAFETY: keys.
        unsafe {
            for sim in self.sims {
                checked(sins_destroy(sim));
            }
            for flight in self.flights {
                checked(sins_flight_destroy(flight));
            }
        }
    }
}
