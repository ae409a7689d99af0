//! The host: its handles, its reads of a simulator, and its checks of every call.

use std::ptr::{null, null_mut, without_provenance_mut};

use sins::abi::*;

use crate::call;
use crate::input::{Argument, Input, Record};
use crate::motion::Motion;
use crate::snapshots::{Follower, frozen};
use crate::texts::written;
use crate::trace;

const HANDLES: usize = 3;

/// A simulator and its vehicle.
pub struct Sim {
    pub handle: *mut sins_sim,
    pub motion: Motion,
    /// The flight that replaces the motion as the source of samples, and the time in this flight [s].
    pub aboard: Option<(usize, f64)>,
    /// Whether the simulator navigates from increments.
    pub is_navigating: bool,
    /// Whether a mounting may be set. The reference point may then exceed the speed limit when the IMU block turns.
    pub is_mounted: bool,
}

pub struct Host {
    pub input: Input,
    pub sims: [Sim; HANDLES],
    pub flights: [*mut sins_flight; HANDLES],
    pub scene: *mut sins_scene,
    pub follower: Follower,
    /// Number of recommendations and budgets that this sequence may still call: each takes the time of thousands of steps.
    pub dear_calls: usize,
}

/// A struct with its size set and all other fields 0, like SINS_INIT.
pub fn init<T: Copy>() -> T {
    // SAFETY: the structs of the interface are numbers.
    let mut value: T = unsafe { std::mem::zeroed() };
    // SAFETY: struct_size comes first.
    unsafe { std::ptr::from_mut(&mut value).cast::<u32>().write(size_of::<T>() as u32) };
    value
}

/// Makes the calls of a sequence and checks what the header promises.
pub fn run(records: &[Record]) {
    trace::begin();
    let mut host = Host::new();
    for record in records {
        host.input = Input::new(record);
        host.call();
    }
    host.finish();
}

/// Makes a read: it gives finite numbers, or it fails and leaves the output unchanged.
pub fn check<T: Copy>(get: impl FnOnce(*mut T) -> sins_status) -> Option<T> {
    let mut output = Argument::of(&init::<T>());
    let status = get(output.pointer());
    if status == SINS_OK {
        assert!(output.is_finite(), "{}: infinite or no number", std::any::type_name::<T>());
        return output.value();
    }
    assert!(output.bytes == Argument::of(&init::<T>()).bytes, "an output was written by a call that failed");
    None
}

/// Makes the read number `what` of a simulator.
pub fn look(sim: *mut sins_sim, what: usize) {
    match what {
        0 => drop(check::<sins_navigation>(|truth| call!(sins_get_truth(sim, truth)))),
        1 => drop(check::<sins_errors>(|errors| call!(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, errors)))),
        2 => drop(check::<sins_errors>(|errors| call!(sins_get_errors(sim, SINS_ERRORS_MODEL, errors)))),
        3 => {
            let _ = check::<sins_imu>(|imu| call!(sins_get_imu(sim, imu)));
            let _ = check::<sins_imu_increment>(|part| call!(sins_get_imu_update(sim, 0, part)));
            let _ = check::<sins_compensation>(|found| call!(sins_get_compensation(sim, found)));
        }
        4 => drop(check::<sins_accuracy>(|accuracy| call!(sins_get_accuracy(sim, accuracy)))),
        5 => {
            if let Some(record) = check::<sins_record>(|record| call!(sins_get_record(sim, record))) {
                let line = written(|buffer, capacity, needed| {
                    call!(sins_record_line(&record, null(), 0, null(), buffer, capacity, needed))
                });
                assert!(line.is_some_and(|line| line.split(|&byte| byte == b',').count() == 51), "a line");
            }
        }
        // No check for finite numbers: the seed may have any bits.
        6 => {
            call!(sins_get_options(sim, &mut init()));
        }
        7 => drop(check::<sins_gyro_params>(|params| call!(sins_get_gyro(sim, params)))),
        8 => drop(check::<sins_accel_params>(|params| call!(sins_get_accel(sim, params)))),
        9 => drop(check::<sins_altimeter_params>(|params| call!(sins_get_altimeter(sim, params)))),
        10 => drop(check::<sins_initial_errors>(|errors| call!(sins_get_initial_errors(sim, errors)))),
        11 => drop(check::<sins_mounting>(|mounting| call!(sins_get_mounting(sim, mounting)))),
        12 => drop(check::<sins_gravity_params>(|params| call!(sins_get_gravity_disturbance(sim, params)))),
        14 => drop(check::<sins_truth_summary>(|summary| call!(sins_get_truth_summary(sim, summary)))),
        15 => drop(check::<sins_covariance>(|covariance| call!(sins_get_covariance(sim, covariance)))),
        13 => {
            check::<sins_failure>(|failure| call!(sins_get_failure(sim, SINS_SENSOR_ACCEL, 1, failure)));
        }
        _ => drop(check::<sins_navigation>(|navigation| call!(sins_get_navigation(sim, navigation)))),
    }
}

/// Makes every read.
pub fn look_at_all(sim: *mut sins_sim) {
    (0..16).for_each(|what| look(sim, what));
}

impl Host {
    fn new() -> Self {
        let mut input = Input::new(&[0; _]);
        let mut sim = || Sim {
            handle: null_mut(),
            motion: Motion::new(&mut input, &sins_options { max_gap_s: 2.5, ..init() }),
            aboard: None,
            is_navigating: false,
            is_mounted: false,
        };
        let sims = [sim(), sim(), sim()];
        let mut host = Self {
            input,
            sims,
            flights: [null_mut(); HANDLES],
            scene: null_mut(),
            follower: Follower::default(),
            dear_calls: 1,
        };
        host.make(0, &mut Argument::of(&sins_options { error_model: SINS_ERROR_MODEL_RK4, ..init() }));
        host
    }

    /// Creates a simulator at a place, with options.
    pub fn make(&mut self, place: usize, options: &mut Argument) {
        let mut handle = null_mut();
        if call!(sins_create(options.pointer(), &mut handle)) != SINS_OK {
            assert!(handle.is_null());
            return;
        }
        self.follower.part(place, self.sims[place].handle);
        let old = std::mem::replace(&mut self.sims[place].handle, handle);
        if !old.is_null() {
            call!(sins_destroy(old));
        }
        self.set_out(place);
        (self.sims[place].is_navigating, self.sims[place].is_mounted) = (false, false);
    }

    /// Gives the simulator at a place another motion.
    pub fn set_out(&mut self, place: usize) {
        let mut options = init();
        if call!(sins_get_options(self.sims[place].handle, &mut options)) == SINS_OK {
            self.sims[place].motion = Motion::new(&mut self.input, &options);
        }
        self.sims[place].aboard = None;
    }

    /// The index of a simulator, mostly 0.
    pub fn place(&mut self) -> usize {
        let place = self.input.byte().saturating_sub(207) as usize % HANDLES;
        trace::note(|| format!("sim {place}"));
        place
    }

    pub fn flight(&mut self) -> *mut sins_flight {
        match self.input.byte() {
            0..250 => self.flights[self.input.below(HANDLES)],
            _ => without_provenance_mut(self.input.word() as usize),
        }
    }

    /// Makes a call that may change the simulator at a place. A call that fails must change nothing: the state before it
    /// is saved and compared, always if `may_fail`, otherwise sometimes.
    pub fn changing(
        &mut self,
        place: usize,
        may_fail: bool,
        call: impl Fn(*mut sins_sim) -> sins_status,
    ) -> sins_status {
        let sim = self.sims[place].handle;
        let before = (may_fail || self.input.one_in(16)).then(|| frozen(sim));
        let status = call(sim);
        match before {
            Some(before) if status != SINS_OK && status != SINS_GAP => {
                assert!(before == frozen(sim), "a call that failed changed something");
            }
            _ => {}
        }
        self.follower.follow(place, status, call);
        if status == SINS_OK && self.input.one_in(8) {
            look(sim, self.input.below(17));
        }
        status
    }

    /// [`Self::changing`] with a struct as the argument, which is sometimes altered.
    pub fn giving<T: Copy + std::fmt::Debug>(
        &mut self,
        value: T,
        call: impl Fn(*mut sins_sim, *const T) -> sins_status,
    ) -> sins_status {
        let place = self.place();
        self.giving_to(place, value, call)
    }

    pub fn giving_to<T: Copy + std::fmt::Debug>(
        &mut self,
        place: usize,
        value: T,
        call: impl Fn(*mut sins_sim, *const T) -> sins_status,
    ) -> sins_status {
        let mut argument = self.input.argument(value);
        let pointer = argument.pointer::<T>().cast_const();
        self.changing(place, argument.is_altered, |sim| call(sim, pointer))
    }

    /// Checks the limits that the header promises for a solution after SINS_OK.
    pub fn hold_to_limits(&self, place: usize) {
        let Sim { handle, is_mounted, .. } = self.sims[place];
        let navigation =
            check::<sins_navigation>(|navigation| call!(sins_get_navigation(handle, navigation)))
                .expect("an interval was navigated");
        let norm2: f64 = navigation.solution.quaternion_nb.iter().map(|q| q * q).sum();
        assert!((norm2 - 1.0).abs() < 1e-9, "norm of the quaternion [{norm2}]");
        let height = navigation.solution.height_m;
        assert!((-500.1e3..=20000.1e3).contains(&height), "height beyond its limits [{height}]");
        let speed = navigation.solution.velocity_enu_m_s.iter().map(|v| v * v).sum::<f64>().sqrt();
        assert!(is_mounted || speed <= 100e3 * (1.0 + 1e-9), "speed beyond its limit [{speed}]");
    }

    /// The last reads and comparisons.
    fn finish(&mut self) {
        self.follower.calls_left = 0;
        self.watch_follower();
        for place in 0..HANDLES {
            let sim = self.sims[place].handle;
            if !sim.is_null() {
                self.follower.compare(sim);
                look_at_all(sim);
            }
        }
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        let sims = self.sims.iter().map(|sim| sim.handle);
        // SAFETY: the functions check their handles.
        unsafe {
            for sim in sims.chain([self.follower.handle]) {
                sins_destroy(sim);
            }
            for &flight in &self.flights {
                sins_flight_destroy(flight);
            }
            sins_scene_destroy(self.scene);
        }
    }
}
