//! A simulator of a strapdown inertial navigation system (SINS). Its input is true motion. Its outputs are the navigation of an
//! INS with the sensor errors that were set, and the errors of that navigation in two ways: navigation minus truth, and the
//! solution of the error differential equations ([`Options::error_model`], off by default).
//!
//! C and C++ hosts link the shared library and read `include/sins.h`; the functions that they call are in [`abi`]. Rust hosts
//! use [`Simulator`].
//!
//! # Data flow
//!
//! The names and equations of the paper are in brackets (Xu Jingshuo, Wang Xiaofei, Zhang Sheng, Luo Tianying, "Design of Airborne
//! SINS Digital Simulator", Ordnance Industry Automation, 2014, no. 12, doi 10.7690/bgzdh.2014.12.001).
//!
//! ```text
//!  flight simulator            FlightSample   time, position, velocity, attitude   [flight control data]
//!        |
//!        v
//!     truth                    TruthPoint     checked, on the time base, Earth-fixed
//!        |
//!        v
//!     signal                   Increment      what perfect sensors measure         [inverse navigation]
//!        |
//!        v
//!     mounting                 Increment      for a block away from the reference point
//!        |
//!        v
//!     sensors                  Increment      with their errors                    [IMU model, (1)-(3)]
//!        |        \
//!        v         \ the same errors
//!     mechanization \          Navigation     attitude, velocity, position         [SINS algorithm, (7)-(24)]
//!        |           \
//!        v            v
//!     errors::difference   errors::model
//!     [error data 2]       [error data 1, (4)-(6)]
//! ```
//!
//! Each block is a module, and each arrow is a type; the mounting is part of `signal`. `simulator` connects the blocks.
//!
//! | module | what it holds |
//! |---|---|
//! | `base` | what every block uses: mathematics, errors, tables of parameters, [`snapshot`] |
//! | [`earth`] | ellipsoid, gravity; position, velocity and attitude in their two forms ([`earth::state`]) |
//! | [`truth`] | the host's samples, checked (`truth::intake`); flights made from manoeuvres ([`truth::flight`]) |
//! | [`judge`] | the host's samples, judged before an INS flies them |
//! | `log` | a table or a record of another program becomes samples; a path that flies, made of its rows (`log::smooth`; feature `scenes`) |
//! | [`signal`] | the signal generator (inverse navigation); the block away from the reference point ([`signal::mounting`]) |
//! | [`sensors`] | the errors of gyros and accelerometers, equations (1)-(3), an effect a file (`sensors::effects`), and of the altimeter; gravity disturbance; errors at the start |
//! | [`mechanization`] | navigation on measured increments, equations (7)-(24), whose places the module lists |
//! | [`errors`] | error data 2 (`difference`) and 1 (`model`, equations (4)-(6)); the covariance of the errors along the same truth ([`errors::covariance`]); errors that the host estimated, removed ([`errors::correction`]) |
//! | `simulator` | the blocks of the paper's figure 1 put together |
//! | [`ensemble`] | many runs of one simulator over the same samples; the statistics of their errors ([`ensemble::statistics`]) |
//! | [`analysis`] | the cheapest options that meet an accuracy ([`analysis::recommend`]), the share of each effect in the errors ([`analysis::budget`]), the errors of real sensors from a record ([`analysis::identify`], feature `identify`) |
//! | [`unit`] | an INS as an aircraft knows it: modes, alignment, status; its words of ARINC 429 ([`unit::bus`]) |
//! | `scene` | a whole scene as text, its failures and updates (feature `scenes`) |
//! | [`abi`] | the C interface; its handles and locks (`abi::boundary`) |
//!
//! # Notation
//!
//! | symbol | meaning |
//! |---|---|
//! | `_n` | navigation axes: east, north, up |
//! | `_b` | sensor axes: right, forward, up; or forward, right, down ([`earth::state::BodyAxes`]). With a mounting, the axes of the vehicle |
//! | `_s` | with a mounting, the axes of the sensor block |
//! | `_e` | Earth-fixed axes: x to latitude 0, longitude 0; y to longitude 90° east; z to the north pole |
//! | `_i` | inertial axes |
//! | `q_nb` | quaternion that turns a vector from body to navigation axes; C in the paper is its matrix |
//! | `omega_ib_b` | angular rate of b relative to i, components along b \[rad/s\] |
//! | `f_b` | specific force: acceleration less gravitation, +g up at rest \[m/s²\] |
//! | φ | misalignment: computed C = (I - \[φ×\]) C \[rad\] |
//! | ψ | misalignment relative to the true, not the computed place: φ = ψ + δθ \[rad\] |
//! | eps, nabla | error of angular rate \[rad/s\] and of specific force \[m/s²\], measured less true |
//! | δ | computed less true |
//! | W, g, RM, RN | Earth rate, gravity, radii of the meridian and of the prime vertical |
//!
//! SI units and radians throughout, spelled in the names of plain numbers (`height_m`); latitude is geodetic, height above
//! the ellipsoid. Roll right wing down, pitch nose up, heading clockwise from north; the rotation sequence is heading,
//! pitch, roll.
//!
//! # Claims and their proofs
//!
//! | claim | test |
//! |---|---|
//! | increments are the integrals of rate and force | `tests/physics/reference_signals.rs` |
//! | the damped vertical channel has the response of its three poles, to second order in the interval | `tests/physics/vertical_loop.rs` |
//! | perfect sensors navigate back to the truth | `tests/physics/simulation1.rs`, `tests/physics/logged_flights.rs` |
//! | error data 1 and error data 2 agree to second order, and both agree with the closed form | `tests/physics/simulation2.rs` |
//! | every term of the error equations is the derivative of the mechanization | `tests/physics/error_equations.rs` |
//! | each scheme has its theoretical order of convergence | `tests/physics/convergence.rs` |
//! | every run obeys the invariants of physics and of the conventions | `tests/physics/invariants` |
//! | poles, the date line, vertical flight and irregular samples cost no accuracy | `tests/robustness/poles.rs`, `tests/robustness/places.rs`, `tests/robustness/attitudes`, `tests/robustness/irregular_samples.rs` |
//! | a bad sample is rejected with a message that names field, value and limit, and changes nothing | `tests/robustness/sample_limits.rs`, `tests/robustness/irregular_samples.rs` |
//! | each sensor effect equals its closed form, and acts on both error data | `tests/effects/triad`, `tests/effects/in_flight.rs` |
//! | temperature and failures equal their closed forms; a failure that is cleared has changed no random number | `tests/effects/temperature.rs`, `tests/effects/failures` |
//! | a sensor block away from the reference point navigates as accurately as one at it | `tests/effects/mounting` |
//! | a start in motion causes no spike of force, and does not disturb the navigation | `tests/physics/start_in_motion.rs` |
//! | an alignment is level to rounding with sensors of any quality, and is flagged if it found no north | `tests/effects/alignment.rs` |
//! | an alignment over a time leaves the mean errors of this time, and the flight continues with its states | `tests/effects/alignment_time.rs` |
//! | a gravity disturbance acts as its closed form | `tests/effects/gravity_disturbance.rs` |
//! | noise has the statistics of its parameters | `tests/effects/noise_statistics.rs` |
//! | the Allan deviation of noise gives its parameters back | `apps/cli/allan/tests/estimator/closure.rs`, the estimator `apps/cli/allan/tests/estimator/intervals.rs` |
//! | the same bits on every platform and for any sequence of calls | `tests/state/determinism.rs`, `tests/interface/c_side.rs`, `tests/platforms.sh`, `tests/windows.sh` |
//! | no host can damage the library, and the library does not damage its host | `tests/interface/host_machine.rs` and the table of `tests/README.md` |
//! | a run continues to the same bits from any snapshot, and damaged snapshots are rejected | `tests/state/snapshots.rs`, `tests/robustness/snapshot_damage.rs` |
//! | for any sequence of calls within the rules, no accepted step leaves a solution beyond the limits, a rejected call changes nothing, and each snapshot loads | `tests/robustness/any_use.rs` |
//! | a unit aligns as well as theory permits, and behaves as its table says at each mode, entry and fault | `tests/unit` |
//! | each word of ARINC 429 is its value to half its resolution, with the status of the unit | `tests/unit/bus.rs`, `tests/hosts/arinc429.py` |
//! | errors that the host feeds back disappear, everywhere and in every mode, and zeros change no bit | `tests/state/corrections.rs` |
//! | a planned update leaves the error of its fix, and changes no other random number | `tests/state/updates.rs` |
//! | pauses and a changed pace of the host's time change no result | `tests/state/host_time.rs` |
//! | a slew, and a pause in which the time stamps ran on, keep the errors of the INS | `tests/state/moved` |
//! | run k of an ensemble gives the same bits as the simulator with this run number, also when other runs diverge | `tests/state/ensemble`, `tests/interface/c_side.rs` |
//! | statistics have the same bits for any split of the runs, and are correct if means are large and the scatter is small | `tests/analysis/statistics.rs` |
//! | a host's wrong units are obvious in the summary of the truth | `tests/analysis/truth_summary.rs` |
//! | faults of logs are found with their reasons, and no good flight is found doubtful | `tests/analysis/judge` |
//! | recommended options meet the requirement, and cheaper ones do not | `tests/analysis/recommend` |
//! | the covariance equals the closed form at rest, the error of a run over its random number, and the spread of many runs | `tests/analysis/covariance`, `tests/analysis/covariance_runs` |
//! | contributions of effects equal their closed forms, and the effects that are marked can be left out | `tests/analysis/error_budget`, `tests/analysis/error_budget/mounting_and_gravity.rs` |
//! | of the 95 % intervals of identified errors, 93 to 97 % hold, and 90 to 98 % of each kind of parameter; clocks are right to 1 ms with industrial and better sensors, axes in all | `tests/analysis/identify.rs` |
//! | a right model of sensors agrees with the rest of its record in 90 % of the cases, one with a third of the noise is too good, one with three times the noise too bad | `tests/analysis/identify/check.rs` |
//! | geodetic conversions are accurate to a nanometre | `tests/physics/earth.rs` |
//! | every getter returns what its setter was given | `tests/state/read_back.rs` |
//! | a scene in flight gives the bits of the calls one by one, from any snapshot; a rejected sample changes nothing of what follows | `tests/interface/play.rs` |
//! | a scene that is written reads back to the same bits, and every fault of a faulty scene is reported | `tests/interface/scene_text.rs`, `tests/interface/scene_settings.rs`, `tests/interface/scene_functions.rs`, logs `tests/interface/flight_log.rs`, `tests/interface/log_mapping.rs` |
//! | hard cases are correct, or reported as beyond a limit | `tests/robustness`, with their figures in `tests/README.md` |
//! | the header agrees with the code, and no other function is exported | `tests/interface/header.rs` |
//!
//! # Example
//!
//! ```
//! use nalgebra::Vector3;
//! use sins::earth::Geodetic;
//! use sins::math::Euler;
//! use sins::sensors::TriadParameters;
//! use sins::truth::FlightSample;
//! use sins::{ErrorSource, Options, Simulator};
//!
//! // An hour at rest at 40° north with an east gyro that drifts by 0.01 °/h.
//! let mut simulator = Simulator::new(&Options::default())?;
//! let drift = Vector3::new(0.01f64.to_radians() / 3600.0, 0.0, 0.0);
//! simulator.set_gyro(&TriadParameters { bias: drift, ..Default::default() })?;
//! let place = Geodetic { latitude_rad: 0.7, longitude_rad: 2.0, height_m: 50.0 };
//! for second in 0..=3600 {
//!     simulator.push_sample(&FlightSample::at_rest(f64::from(second), place, Euler::default()))?;
//!     simulator.step()?;
//! }
//! let (time_s, errors) = simulator.errors(ErrorSource::Navigation)?.expect("an hour was flown");
//! assert_eq!(time_s, 3600.0);
//! // A level gyro drift tilts the platform: the Schuler-tuned INS is a kilometre north or south within the hour.
//! assert!(errors.position_n.y.abs() > 500.0 && errors.position_n.y.abs() < 2000.0);
//! # Ok::<(), sins::Error>(())
//! ```
//!
//! # References
//!
//! - Titterton and Weston, *Strapdown Inertial Navigation Technology*, 2nd ed., 2004
//! - Savage, "Strapdown Inertial Navigation Integration Algorithm Design", J. Guid. Control Dyn. 21, 1998
//! - Miller, "A New Strapdown Attitude Algorithm", J. Guid. Control Dyn. 6, 1983; Ignagni, "Efficient Class of Optimized
//!   Coning Compensation Algorithms", J. Guid. Control Dyn. 19, 1996
//! - Kayton and Fried, *Avionics Navigation Systems*, 2nd ed., 1997 (vertical channel)
//! - Heiskanen and Moritz, *Physical Geodesy*, 1967 (normal gravity); NIMA TR8350.2, 3rd ed., 2000 (WGS 84)
//! - IEEE Std 528-2019, IEEE Std 952-1997, IEEE Std 1293-2018 (terms of gyro and accelerometer models)
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]
#![cfg_attr(
    not(test),
    deny(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)
)]
#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "units stand in square brackets; rustdoc takes [rad] for a link"
)]

pub mod abi;
#[forbid(unsafe_code)]
pub mod analysis;
mod base;
#[forbid(unsafe_code)]
pub mod earth;
#[forbid(unsafe_code)]
pub mod ensemble;
#[forbid(unsafe_code)]
pub mod errors;
#[forbid(unsafe_code)]
pub mod judge;
#[cfg(feature = "scenes")]
#[forbid(unsafe_code)]
pub mod log;
#[forbid(unsafe_code)]
pub mod mechanization;
#[cfg(feature = "scenes")]
#[forbid(unsafe_code)]
pub mod scene;
#[forbid(unsafe_code)]
pub mod sensors;
#[forbid(unsafe_code)]
pub mod signal;
#[forbid(unsafe_code)]
mod simulator;
#[forbid(unsafe_code)]
pub mod truth;
#[forbid(unsafe_code)]
pub mod unit;

pub use base::error::{Error, ErrorKind, Rule, Value};
pub use base::{figures, math, records, snapshot, units};
pub use simulator::record;
pub use simulator::{
    ClosureFigures, ErrorParameters, ErrorSource, ImuFlags, ImuInterval, MAX_UPDATES, Options, Simulator,
    Solution, Step, TrimFigures,
};
