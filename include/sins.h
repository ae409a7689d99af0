/*
 * sins.h - strapdown inertial navigation system (SINS) simulator, C interface.
 *
 * Truth goes in as flight samples (position, velocity, attitude); the library makes of it what perfect gyros and
 * accelerometers would sense, adds the sensor errors that are set, navigates on the result, and tells the errors:
 *
 *   sins_sim *sim = NULL;
 *   sins_create(NULL, &sim);                       recommended options: navigation minus truth, no error model
 *   sins_set_gyro(sim, &gyro);                     errors of the gyros; ideal without this
 *   while (...) {
 *       sins_push_sample(sim, &sample);            one sample of the flight simulator
 *       if (sins_step(sim) == SINS_OK)             one interval (the first needs two samples)
 *           sins_get_navigation(sim, &navigation);
 *   }
 *   sins_destroy(sim);
 *
 * Zero is off. Every struct (but the parts of a sins_record) begins with struct_size, to be set to its sizeof, and a second
 *   32-bit integer that is 0 unless told otherwise: "sins_gyro_params gyro = { sizeof gyro };" is an ideal gyro, and so is
 *   SINS_INIT(gyro), for compilers that warn of the fields left out. Output structs want their struct_size set too; what a
 *   newer host's struct has behind the fields that this library knows stays as it was. Structs grow at their end only: old
 *   hosts run on new libraries and the other way round.
 * Units are SI and radians, spelled in each field's name; the macros below turn the units of data sheets into them:
 *   gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR.
 * Constants are enumerations. Fields and arguments hold them as 32-bit integers, whose size no compiler chooses.
 * Frames. Navigation axes east-north-up. Roll right wing down, pitch nose up, heading clockwise from true north, aerospace
 *   sequence heading-pitch-roll. Sensor axes right-forward-up, or forward-right-down by sins_options.axes. Latitude geodetic,
 *   height above the ellipsoid.
 * Errors. A function that can fail returns a sins_status and gives data through pointers; one that cannot returns its value.
 *   On an error nothing changed: no state, no output, no random number drawn. (sins_run() keeps what it flew before; where a
 *   buffer is too small, sins_last_error() and sins_error_budget() report the size that is needed.)
 *   Every function that has the argument in question can return SINS_ERROR_NULL_POINTER, SINS_ERROR_BAD_HANDLE,
 *   SINS_ERROR_STRUCT_SIZE and SINS_ERROR_INTERNAL. The other errors of a function are listed at the function, or under
 *   Threads and Unloading.
 *   A positive status is no error: SINS_NEED_SAMPLE left the output as it was, SINS_REQUIREMENT_NOT_MET wrote it,
 *   SINS_SCENE_HAS_FAULTS made a handle, SINS_GAP did what was asked. Test for errors by status < 0.
 *   sins_last_error() has the sentence: which field, which value, which limit; sins_last_error_info() the same as a struct,
 *   sins_status_string() the name.
 * Threads. Any function may be called from any thread; calls on one handle wait for each other, different handles never do.
 *   A call takes less than 48 KB of stack, so a thread of 64 KB can make it.
 *   A call on a handle that its own thread is already inside is SINS_ERROR_BAD_STATE; sins_last_error(NULL, ...) has the
 *     sentence. A signal handler gets this answer if it interrupted a call on that handle. It may call every function that
 *     takes a simulator, except sins_destroy() and sins_snapshot_load(), which use the allocator.
 *   A call that never returns, because of siglongjmp() or because its thread was cancelled or terminated, holds its handle for
 *     ever. Its own thread gets SINS_ERROR_BAD_STATE from then on, and the memory stays in use. Calls of other threads wait for
 *     ever; on Windows, if the thread was terminated, they get SINS_ERROR_BAD_STATE, the first of them after 0.1 s. The
 *     floating-point state is not put back.
 *   fork(): a handle that another thread of the parent was inside is SINS_ERROR_BAD_STATE in the child. All others work there.
 *     A process made in another way, as by vfork() or clone(), makes no call.
 * Unloading. Every handle is destroyed and every call has returned before. A library that was built for windows-gnu stays in
 *   memory from its first load on, as does a module that the static library is linked into: FreeLibrary() succeeds, and
 *   LoadLibrary() gives the same module again. The reason: Rust never frees the three or four TLS indexes that it takes at the
 *   load. Load the library before others have used the indexes up. If fewer than eight are left, functions without a handle
 *   are SINS_ERROR_OUT_OF_MEMORY until there are eight. If none is left, the process may be aborted when a thread or it ends.
 * Real time. Push, step, run, the reads, the setters, reset, reposition, sins_move_time(), sins_move_truth() and
 *   sins_snapshot_save() make no allocation and no system call, unless the handle is in use in another thread; so do those of
 *   ensembles, and the functions of statistics. The library prints
 *   nothing, reads no environment and no file, and leaves the host's floating-point control state and x87 registers as it
 *   found them.
 * Host time. The time of a run is that of its time stamps; no clock enters it. (sins_recommend() and sins_error_budget() time
 *   themselves, and the first create draws the numbers of its handles from the clock.)
 *   Paused: make no call, for as long as it takes. A sample pushed again is SINS_ERROR_TIME_ORDER and changes nothing. If the
 *     stamps go on where they stopped, there is nothing to do. If the host's clock ran on, call sins_move_time() with the time at
 *     which the vehicle moves on, before the next push: the flight goes on as if there had been no pause. Without that call the
 *     first sample after a pause of more than max_gap_s is SINS_ERROR_DISCONTINUITY, and so is each after it; a shorter pause is
 *     flown as an interval, the velocity times its length, and its push answers SINS_GAP.
 *   Gaps: an interval of more than 2.5 times the two before it, up to max_gap_s, is flown in updates as long as theirs (while
 *     these have no more than 80 subsamples together, then in longer ones), on the smoothest motion between its ends. Attitude
 *     and velocity are right behind it; what that motion missed of the path stays in the position: nothing in steady flight, in
 *     a weave of 4 g and 8 s at 100 Hz 5 cm where 1 s is lost and 3 m where 2.5 s are. Without velocities a gap costs up to 5
 *     times the error of a position times the square of the number of intervals that were lost: 1 s lost in straight flight at
 *     50 Hz in positions of 1 cm 23 m. Have what is too much refused by a smaller max_gap_s.
 *   Accelerated: samples that are farther apart in simulated time, ten times dt as well as one, up to max_gap_s, from one
 *     sample to the next and back; slow motion likewise, down to 5e-5 s. With sample_period_s stated, stamps skip whole
 *     periods; other paces, and slow motion, need it 0. Each interval is integrated as one: accuracy is that of the slower
 *     sample rate as long as it lasts, a turn of 170 degrees a sample is refused at any pace, noise is that of the interval's
 *     length, and only noise_m of the altimeter and the probability of drop-outs are of each sample.
 *   Slewed: sins_move_truth(), which keeps the errors of the INS. sins_reposition() starts the INS anew at a place and discards
 *     its errors: it is for a flight that is reloaded, not for a pause. Another flight with the same draws: sins_reset(). Back to
 *     a saved moment: sins_snapshot_load().
 * Same bits. Same options, seed, parameters and samples give the same outputs bit for bit on every platform and by any call
 *   pattern; ns_per_step of sins_cost, sins_budget and sins_budget_row, times, are the exception. Each random effect
 *   has a stream of its own: switching one leaves every other draw as it was.
 *
 * Ensembles. How large the errors get, with which probability: many runs over the same samples, which differ in their draws.
 *
 *     sins_ensemble_create(sim, first_run, runs, &ensemble);    sim was set up and has taken no sample
 *     sins_ensemble_run(ensemble, samples, count);              or sins_ensemble_push_sample() and sins_ensemble_step()
 *     sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics);
 *     sins_statistics_merge(&total, &statistics);               those of other runs, in any order: the same bits
 *     sins_statistics_figures(&total, &figures);                means, covariance, RMS, CEP50, R95
 *
 *   Run k is, bit for bit, the simulator whose sins_options.run is first_run + k. Ensembles over disjoint runs depend on nothing of
 *   each other: the host flies them in as many threads, processes and machines as it has.
 *
 * Scenes and logs. A scene is a flight, the simulator that flies it and the failures on the way, as a text in TOML. A log is a
 *   flight as a table of samples, as text too. The host reads the files; the library parses their bytes:
 *
 *     sins_scene_parse(text, size, &scene);          SINS_SCENE_HAS_FAULTS: sins_scene_get_fault() tells each and its place
 *     sins_scene_create_simulator(scene, &sim);      options, sensors, start, mounting, gravity
 *     sins_scene_create_flight(scene, &flight);      or sins_log_parse() of the file that SINS_SCENE_TEXT_LOG names
 *     while (...) {
 *         sins_flight_sample_at(flight, k / rate_hz, &sample);   or sins_log_get_sample()
 *         sins_scene_prepare(scene, sim, 0.0, &sample);          temperature and failures; 0.0: time of the first sample
 *         sins_push_sample(sim, &sample);
 *         sins_step(sim);
 *     }
 *
 *   A library that was built without the feature "scenes" lacks all functions sins_scene_... and sins_log_...: a program that is
 *   linked with them does not link or does not start. A program that loads the library by itself looks up sins_scene_create,
 *   by dlsym() or GetProcAddress(): not there, no scenes. All else is the same.
 *
 * This file is written by build.rs from the Rust sources; do not edit it.
 */

#ifndef SINS_H
#define SINS_H

#include <stddef.h>
#include <string.h>

#if defined(_MSC_VER) && _MSC_VER < 1600
typedef __int32 int32_t;
typedef __int64 int64_t;
typedef unsigned __int32 uint32_t;
typedef unsigned __int64 uint64_t;
#else
#include <stdint.h>
#endif

/* Calling convention and linkage. Define SINS_STATIC when linking the static library. */
#if defined(_WIN32)
#define SINS_CALL __cdecl
#else
#define SINS_CALL
#endif
#if defined(_WIN32) && !defined(SINS_STATIC)
#define SINS_API __declspec(dllimport)
#else
#define SINS_API
#endif

/* Makes a struct the zero of its kind: everything off, or recommended. */
#define SINS_INIT(object) (memset(&(object), 0, sizeof(object)), (void)((object).struct_size = sizeof(object)))

/* Units: multiply by them to get SI, divide to get back. */
#define SINS_DEG 0.017453292519943295              /* degree [rad] */
#define SINS_ARCMIN (SINS_DEG / 60.0)              /* minute of arc [rad] */
#define SINS_ARCSEC (SINS_DEG / 3600.0)            /* second of arc [rad] */
#define SINS_DEG_PER_HOUR (SINS_DEG / 3600.0)      /* degree an hour [rad/s] */
#define SINS_DEG_PER_SQRT_HOUR (SINS_DEG / 60.0)   /* degree a root hour, angle random walk [rad/sqrt(s)] */
#define SINS_STANDARD_GRAVITY 9.80665              /* g [m/s2] */
#define SINS_MICRO_G (SINS_STANDARD_GRAVITY * 1.0e-6)             /* millionth of g [m/s2] */
#define SINS_MICRO_G_PER_SQRT_HZ (SINS_STANDARD_GRAVITY * 1.0e-6) /* white noise of force [(m/s)/sqrt(s)] */
#define SINS_PPM 1.0e-6                            /* part in a million */
#define SINS_KNOT (1852.0 / 3600.0)                /* knot [m/s] */
#define SINS_NMI 1852.0                            /* nautical mile [m] */
#define SINS_NMI_PER_HOUR (1852.0 / 3600.0)        /* nautical mile an hour [m/s] */

#ifdef __cplusplus
extern "C" {
#endif

/*
 * A simulator. This and the next four are handles: checked keys, never addresses. A null, made-up, destroyed or wrong-kind one is
 * answered SINS_ERROR_BAD_HANDLE, and no key is ever used again.
 */
typedef struct sins_sim sins_sim;
/* An embedded flight. */
typedef struct sins_flight sins_flight;
/* An ensemble of runs. */
typedef struct sins_ensemble sins_ensemble;
/* A scene. */
typedef struct sins_scene sins_scene;
/* A flight log. */
typedef struct sins_log sins_log;

/* Values of a sins_status: 0, positive an answer of another kind, negative an error. */
enum sins_status_code {
    /* The call did what it says. */
    SINS_OK = 0,
    /* There is no complete interval yet: push the next sample. */
    SINS_NEED_SAMPLE = 1,
    /* No options meet the requirement; the outputs tell the best there are. */
    SINS_REQUIREMENT_NOT_MET = 2,
    /* The text of a scene has faults: the handle was made, for sins_scene_get_fault() alone. */
    SINS_SCENE_HAS_FAULTS = 3,
    /*
     * The sample was taken, or all samples of the run were flown, but there is a gap: an interval of more than 2.5 times each of the
     * two before it. It is flown as motion, the velocity times its length: 213 m for 1 s at 213 m/s. If the host's clock ran on while
     * the vehicle stood still, that is wrong: see sins_move_time().
     */
    SINS_GAP = 4,
    /* A pointer that must not be null is. */
    SINS_ERROR_NULL_POINTER = -1,
    /* The handle is null, made up, destroyed, or of another kind. */
    SINS_ERROR_BAD_HANDLE = -2,
    /* A struct_size that no release knows, or a struct of a newer release that uses what this one lacks. */
    SINS_ERROR_STRUCT_SIZE = -3,
    /* A value out of its range; sins_last_error() names field, value and limit. */
    SINS_ERROR_INVALID_ARGUMENT = -4,
    /* The right call at the wrong moment, or on a handle that this thread is inside or that is held for ever (see Threads). */
    SINS_ERROR_BAD_STATE = -5,
    /* A sample that is not later than the one before, or off the stated sample period. */
    SINS_ERROR_TIME_ORDER = -6,
    /* Truth jumped: a gap, a teleport, half a turn between two samples. See sins_move_truth(). */
    SINS_ERROR_DISCONTINUITY = -7,
    /* The queue of samples is full: step first. */
    SINS_ERROR_QUEUE_FULL = -8,
    /* The solution left its representable range; the last good one stays readable. */
    SINS_ERROR_DIVERGED = -9,
    /* The geographic mechanization came within reach of a pole. */
    SINS_ERROR_SINGULAR = -10,
    /* A buffer is too small for the result. */
    SINS_ERROR_BUFFER_TOO_SMALL = -11,
    /* No memory, or no free handle; on Windows too few TLS indexes (see Unloading). */
    SINS_ERROR_OUT_OF_MEMORY = -12,
    /* The snapshot is damaged, foreign or newer. */
    SINS_ERROR_SNAPSHOT = -13,
    /* A defect inside the library was caught; this handle answers so from now on, others live. */
    SINS_ERROR_INTERNAL = -99
};

/* Axes in which the mechanization integrates. */
enum sins_frame {
    /* Navigation in Earth-fixed axes: regular everywhere, poles included. */
    SINS_FRAME_EARTH_FIXED = 0,
    /*
     * Navigation in east-north-up, as in the paper; SINS_ERROR_SINGULAR within 6.4 km of a pole, and where an update moves by more
     * than 1 % of the distance to it: 25 km at 250 m/s and updates of 1 s.
     */
    SINS_FRAME_GEOGRAPHIC = 1
};

/* Algorithms of the mechanization. */
enum sins_scheme {
    /* Coning, sculling and exact rotation compensation, Earth terms of the middle of the update. */
    SINS_SCHEME_EXACT = 0,
    /* The paper's equations (7)-(24), misprints mended, approximations kept. */
    SINS_SCHEME_PAPER = 1,
    /* As SINS_SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large rotations within an update. */
    SINS_SCHEME_POLYNOMIAL = 2
};

/* What holds the vertical channel. */
enum sins_vertical {
    /*
     * Third-order loop on a barometric height, time constant 100 s. Its response is that of the continuous loop to second order in
     * the interval: to 3.5e-5 at 1 Hz, 3.5e-7 at 10 Hz.
     */
    SINS_VERTICAL_DAMPED = 0,
    /* Height and vertical velocity set to the truth at each sample. */
    SINS_VERTICAL_FOLLOW_TRUTH = 1,
    /* Left to itself: any error grows by e every 569 s. */
    SINS_VERTICAL_FREE = 2
};

/* Whether the error differential equations are integrated. */
enum sins_error_model {
    /* No error differential equations: SINS_ERRORS_MODEL is not available. */
    SINS_ERROR_MODEL_OFF = 0,
    /* The error differential equations (error data 1) by fourth-order Runge-Kutta. */
    SINS_ERROR_MODEL_RK4 = 1
};

/* Whether the motion of the truth is summed up. */
enum sins_summary {
    /* sins_get_truth_summary() is not available. */
    SINS_SUMMARY_OFF = 0,
    /* The motion of the truth is summed up; the other outputs have the same bits. */
    SINS_SUMMARY_ON = 1
};

/* Ellipsoids. */
enum sins_earth {
    /* World Geodetic System 1984. */
    SINS_EARTH_WGS84 = 0,
    /* China Geodetic Coordinate System 2000. */
    SINS_EARTH_CGCS2000 = 1,
    /* Geodetic Reference System 1980. */
    SINS_EARTH_GRS80 = 2,
    /* Krassovsky 1940; Earth rate and gravitational constant as WGS-84. */
    SINS_EARTH_KRASSOVSKY1940 = 3
};

/* Formulas of normal gravity. */
enum sins_gravity {
    /* Normal gravity in closed form at any height, with its north component. */
    SINS_GRAVITY_NORMAL = 0,
    /* Somigliana's formula with the second-order height term, along the ellipsoid normal, as most tools have it. */
    SINS_GRAVITY_SOMIGLIANA = 1
};

/* Directions of the sensor axes. */
enum sins_axes {
    /* Sensor axes: x right, y forward, z up (the paper's). */
    SINS_AXES_RIGHT_FORWARD_UP = 0,
    /* Sensor axes: x forward, y right, z down. */
    SINS_AXES_FORWARD_RIGHT_DOWN = 1
};

/* Ideal signals. */
enum sins_signal {
    /* Ideal signals are the integrals of the physics, so that the mechanization's own error shows. */
    SINS_SIGNAL_PHYSICAL = 0,
    /*
     * The same with a small trim that holds an error-free navigator to the truth over any time, the free vertical channel too:
     * for hosts that want nothing but the sensors' errors. sins_accuracy tells how large it was. Where no sensor errs, that
     * navigator is the simulator's own and nothing is computed twice.
     */
    SINS_SIGNAL_CLOSED_LOOP = 1
};

/* Flags of a sins_error_info. */
enum sins_error_info_flags {
    /* A value is at fault, and is in value. */
    SINS_ERROR_INFO_VALUE = 1,
    /* There is a least value, and minimum has it. */
    SINS_ERROR_INFO_MINIMUM = 2,
    /* There is a greatest value, and maximum has it. */
    SINS_ERROR_INFO_MAXIMUM = 4,
    /* The field is an integer. */
    SINS_ERROR_INFO_INTEGER = 8
};

/* Sensors that can fail. */
enum sins_sensor {
    /* The gyros. */
    SINS_SENSOR_GYRO = 0,
    /* The accelerometers. */
    SINS_SENSOR_ACCEL = 1,
    /* The altimeter; its axis is 0. */
    SINS_SENSOR_ALTIMETER = 2
};

/* Kinds of failure. */
enum sins_failure_kind {
    /* None: clears the failure that there is. */
    SINS_FAILURE_NONE = 0,
    /*
     * The output holds the measured mean of the interval before, as sins_imu told it; without one its first value. Not flagged:
     * it looks like data.
     */
    SINS_FAILURE_STUCK = 1,
    /*
     * No signal. A gyro or an accelerometer gives 0, and is flagged SINS_IMU_..._INVALID, as built-in tests do; without the
     * altimeter the vertical channel is left to itself, flagged SINS_NAVIGATION_VERTICAL_UNAIDED.
     */
    SINS_FAILURE_DEAD = 2,
    /* A bias of size more. Not flagged. */
    SINS_FAILURE_BIAS_STEP = 3,
    /*
     * Rectangular pulses of size, duration_s long, one each interval_s, the first at once; a sample of the altimeter shows their
     * mean over its interval. Not flagged but where they saturate.
     */
    SINS_FAILURE_SPIKES = 4,
    /* White noise of density more; of the altimeter its mean over the interval. Not flagged. */
    SINS_FAILURE_NOISE = 5,
    /*
     * Sample intervals are lost: 0, and flagged as SINS_FAILURE_DEAD. With probability each by itself, or with interval_s one in
     * that time, the first at once.
     */
    SINS_FAILURE_DROP_OUTS = 6
};

/* How the INS finds its attitude at the start. */
enum sins_alignment {
    /* The INS starts with the true attitude, turned by the given and the drawn misalignment. */
    SINS_ALIGNMENT_GIVEN = 0,
    /*
     * The INS starts with the attitude that levelling and gyrocompassing at rest find with the sensor errors of the start, turned by
     * the given and the drawn misalignment. Level first: the tilt at which the accelerometers sense no horizontal force. Then the
     * heading at which the levelled rate of the gyros points north. SINS_NAVIGATION_NORTH_UNKNOWN tells that they found none.
     */
    SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS = 1
};

/* Flags of a sins_flight_sample. */
enum sins_sample_flags {
    /* The sample carries angular_rate_rad_s. */
    SINS_SAMPLE_ANGULAR_RATE = 1,
    /* The sample carries specific_force_m_s2. */
    SINS_SAMPLE_SPECIFIC_FORCE = 2,
    /* The sample has no velocity: it follows from position, with a noise of 2 to 4 position errors over the interval. */
    SINS_SAMPLE_NO_VELOCITY = 4,
    /* The sample carries temperature_c. */
    SINS_SAMPLE_TEMPERATURE = 8
};

/* Flags of a sins_navigation. */
enum sins_navigation_flags {
    /*
     * Within 20 km of the Earth's axis: longitude and heading turn fast; at the pole they are undefined. Quaternion, height
     * and the errors in metres stay right.
     */
    SINS_NAVIGATION_NEAR_POLE = 1,
    /* Nothing aids the vertical channel, by the options or as the altimeter has no signal: any error grows by e every 569 s. */
    SINS_NAVIGATION_VERTICAL_UNAIDED = 2,
    /* Truth: the displacement since the sample before contradicts the velocities by more than 1 % and 1 cm, added as squares. */
    SINS_NAVIGATION_INCONSISTENT = 4,
    /*
     * The alignment at the start could not find north, so that any heading error is possible: the horizontal error of the levelled
     * rates is not smaller than the Earth rate's north part (where it is smaller, the heading error is below 90 degrees), or the
     * accelerometers show no force. The simulator knows that error. A real INS can be sure of it only where its levelled
     * horizontal rate is more than twice the Earth rate's north part. The flag stays until the INS starts again.
     */
    SINS_NAVIGATION_NORTH_UNKNOWN = 8
};

/* Where errors come from. */
enum sins_errors_source {
    /* Navigation minus truth: the paper's error data 2. */
    SINS_ERRORS_NAVIGATION = 0,
    /* The error differential equations: the paper's error data 1 (sins_options.error_model). */
    SINS_ERRORS_MODEL = 1
};

/* Flags of a sins_errors. */
enum sins_errors_flags {
    /* Near a pole: longitude, heading and up misalignment, and east and north of the velocity, have lost their meaning. */
    SINS_ERRORS_NEAR_POLE = 1,
    /*
     * Error model: misalignment above 2 degrees, displacement above 100 km or, at high latitude, above 3.5 % of the distance to the
     * pole; what it drops is no longer small.
     */
    SINS_ERRORS_OUTSIDE_VALIDITY = 2,
    /* In a sins_record: not computed, all zero. */
    SINS_ERRORS_NOT_COMPUTED = 4
};

/* Flags of a sins_imu. */
enum sins_imu_flags {
    /* The mean rate of a sub-increment was beyond the range of a gyro. */
    SINS_IMU_GYRO_SATURATED = 1,
    /* The mean force of a sub-increment was beyond the range of an accelerometer. */
    SINS_IMU_ACCEL_SATURATED = 2,
    /* A gyro had no signal in the interval: dead, or dropped out. The mechanization goes on with the 0 that it gave. */
    SINS_IMU_GYRO_INVALID = 4,
    /* An accelerometer had none. */
    SINS_IMU_ACCEL_INVALID = 8
};

/* Grades of sensors. */
enum sins_grade {
    /*
     * Strategic: gyro drift 0.001 deg/h, accelerometer bias 1e-6 g (El-Sheimy and Youssef 2020, table 1, upper ends of the grade),
     * angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix 200).
     */
    SINS_GRADE_STRATEGIC = 1,
    /* Navigation: Honeywell HG9900, brochure N61-1638. No accelerometer noise is stated. */
    SINS_GRADE_NAVIGATION = 2,
    /* Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated. */
    SINS_GRADE_TACTICAL = 3,
    /*
     * Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D, which states no accelerometer noise: set your own. Its
     * range is 125 deg/s and 8 g, its axes are off square by 0.1 deg, 1 sigma.
     */
    SINS_GRADE_INDUSTRIAL = 4,
    /* Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances are taken as 3 sigma. */
    SINS_GRADE_CONSUMER = 5,
    /*
     * The paper's simulation 2: gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), accelerometer bias 1e-5 g and
     * white noise 5e-6 g, read as a density of 5e-6 g/sqrt(Hz) (1 Hz of bandwidth; the paper states none).
     */
    SINS_GRADE_PAPER_SIMULATION2 = 6
};

/* Kinds of manoeuvre. */
enum sins_manoeuvre_kind {
    /* At rest for duration_s; the speed must be 0. */
    SINS_MANOEUVRE_REST = 0,
    /* Along a geodesic at constant speed and height for duration_s. */
    SINS_MANOEUVRE_STRAIGHT = 1,
    /* By speed_change_m_s in duration_s. */
    SINS_MANOEUVRE_ACCELERATE = 2,
    /* By height_change_m in duration_s, ramp_s. */
    SINS_MANOEUVRE_CLIMB = 3,
    /*
     * Level coordinated turn by heading_change_rad (right positive) at bank_rad, ramp_s to roll in and out; the duration
     * follows.
     */
    SINS_MANOEUVRE_TURN = 4,
    /* turns whole rolls (right positive) in duration_s along a straight path. */
    SINS_MANOEUVRE_ROLL = 5,
    /* turns whole vertical loops (nose up positive) in duration_s at constant speed, ramp_s. */
    SINS_MANOEUVRE_LOOP = 6,
    /* Course swings by heading_change_rad to both sides, turns times in duration_s, ramp_s. */
    SINS_MANOEUVRE_S_TURN = 7,
    /* Sum of sinusoid_count sinusoids for duration_s, ramp_s: patrol patterns, rocking, coning, vibration. */
    SINS_MANOEUVRE_SINUSOIDS = 8
};

/* What a sinusoid of SINS_MANOEUVRE_SINUSOIDS moves. */
enum sins_channel {
    /* The sinusoid moves the course [rad], with the bank of a coordinated turn. */
    SINS_CHANNEL_COURSE = 0,
    /* The sinusoid moves the climb angle [rad]. */
    SINS_CHANNEL_CLIMB = 1,
    /* The sinusoid moves the speed [m/s]. */
    SINS_CHANNEL_SPEED = 2,
    /* The sinusoid moves roll alone [rad]. */
    SINS_CHANNEL_ROLL = 3,
    /* The sinusoid moves pitch alone [rad]. */
    SINS_CHANNEL_PITCH = 4,
    /* The sinusoid moves heading alone [rad]. */
    SINS_CHANNEL_HEADING = 5
};

/* Where the flight of a scene comes from: sins_scene_setup.flight. */
enum sins_scene_flight {
    /* It is composed of manoeuvres. */
    SINS_SCENE_FLIGHT_MANOEUVRES = 0,
    /* That of a built-in scene, SINS_SCENE_TEXT_BUILTIN. */
    SINS_SCENE_FLIGHT_BUILTIN = 1,
    /* A flight log, SINS_SCENE_TEXT_LOG. */
    SINS_SCENE_FLIGHT_LOG = 2
};

/* The texts of a scene: sins_scene_get_text(), sins_scene_set_text(). */
enum sins_scene_text {
    /* The scene in words. */
    SINS_SCENE_TEXT_TITLE = 0,
    /* Path of the flight log, as seen from the scene's own folder; setting it makes the flight a log. */
    SINS_SCENE_TEXT_LOG = 1,
    /* Name of the built-in scene whose flight is flown; setting it makes the flight that. */
    SINS_SCENE_TEXT_BUILTIN = 2,
    /* Folder of the files that a program writes. */
    SINS_SCENE_TEXT_FOLDER = 3,
    /* Base name of those files. */
    SINS_SCENE_TEXT_NAME = 4,
    /* File of the measured increments. */
    SINS_SCENE_TEXT_IMU = 5
};

/* Flags of a sins_budget_row. */
enum sins_budget_flags {
    /* The row's figures are standard deviations (1 sigma) over the runs. */
    SINS_BUDGET_RANDOM = 1,
    /* The effect can be left out together with the others that are marked so. */
    SINS_BUDGET_CAN_BE_LEFT_OUT = 2
};

/*
 * Version of the interface that this header declares: a host compares it with what sins_abi_version() gives. It changes when
 * something that was there is gone or means something else; what is added at the end does not change it.
 */
#define SINS_HEADER_ABI 1

/* Release of the library, semantic versioning. */
#define SINS_VERSION_MAJOR 0
/* See SINS_VERSION_MAJOR. */
#define SINS_VERSION_MINOR 1
/* See SINS_VERSION_MAJOR. */
#define SINS_VERSION_PATCH 0

/*
 * A buffer of this size holds every snapshot that this release saves. For a library newer than this header ask
 * sins_snapshot_size().
 */
#define SINS_SNAPSHOT_MAX_SIZE 8192

/* Result of a call: `SINS_OK`, positive an answer of another kind, negative an error. On an error nothing changed. */
typedef int32_t sins_status;

/* How a simulator is made. All zero (but struct_size) is the recommended simulator. */
typedef struct sins_options {
    /* sizeof(sins_options) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Of enum sins_frame. */
    int32_t frame;
    /* Of enum sins_scheme. */
    int32_t scheme;
    /* Sub-increments of a mechanization update, 1 to 5; 0: 2. */
    int32_t subsamples;
    /* Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (see "Gaps" above). */
    int32_t updates_per_sample;
    /* Of enum sins_vertical. */
    int32_t vertical;
    /* Of enum sins_error_model. */
    int32_t error_model;
    /* Of enum sins_earth. */
    int32_t earth;
    /* Of enum sins_gravity. */
    int32_t gravity;
    /* Axes of gyros, accelerometers, quaternions and optional sample fields, of enum sins_axes. */
    int32_t axes;
    /* Of enum sins_signal. */
    int32_t signal;
    /* Seed of all random streams. */
    uint64_t seed;
    /* Number of the run in an ensemble: same seed, other draws. */
    uint64_t run;
    /* Time constant of SINS_SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0: 30 s. Must be 0 without it. */
    double closed_loop_time_s;
    /*
     * Stated sample period [s]: sample k is then at exactly k periods from the first, time stamps only order and check,
     * each within 0.4 of a period. 5e-5 to max_gap_s. 0: the samples' own time stamps.
     */
    double sample_period_s;
    /*
     * Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Intervals of minutes are for vehicles at rest: those of
     * 100 s cost 40 m in 12 h, longer ones many times that.
     */
    double max_gap_s;
    /*
     * Mean acceleration between two samples beyond which truth has jumped, 1e-3 to 1e6 [m/s2];
     * 0: 2000 m/s2.
     */
    double max_acceleration_m_s2;
    /* Of enum sins_summary. */
    int32_t truth_summary;
    /* Must be 0. */
    uint32_t reserved2;
} sins_options;

/*
 * True motion of the vehicle at an instant, as a flight simulator gives it. Velocity is trusted most: the ideal signals
 * are made of velocity and attitude, position enters through gravity and curvature alone. Vibration above a tenth of the
 * sample rate cannot be recovered from samples; give angular rate and specific force where you have them.
 */
typedef struct sins_flight_sample {
    /* sizeof(sins_flight_sample) */
    uint32_t struct_size;
    /* Flags of enum sins_sample_flags, or'ed. */
    uint32_t flags;
    /*
     * Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins_options.max_gap_s. Large stamps are coarse
     * (2e-7 s at 1e9 s): state sins_options.sample_period_s with them.
     */
    double time_s;
    /* Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /* Longitude, east positive, -100 to 100 [rad]: any wrap. */
    double longitude_rad;
    /* Height above the ellipsoid, -20 km to 2000 km [m]. */
    double height_m;
    /* Velocity against the Earth, east-north-up, each up to 20 km/s [m/s]. */
    double velocity_enu_m_s[3];
    /* Roll, right wing down positive, any number of turns up to 10000 rad [rad]. */
    double roll_rad;
    /*
     * Pitch, nose up positive, may go beyond 90 degrees, up to 10000 rad [rad].
     * From one sample to the next the attitude turns by less than 170 degrees, and by less than 180 degrees more or less than
     * foreseen by the angular rates or else by the interval before. Whole turns that a host loses otherwise are beyond knowledge.
     */
    double pitch_rad;
    /* Heading, clockwise from true north, any number of turns up to 10000 rad [rad]. */
    double heading_rad;
    /*
     * With SINS_SAMPLE_ANGULAR_RATE: rate against inertial space in sensor axes at this instant, each up to
     * 1000 rad/s [rad/s].
     */
    double angular_rate_rad_s[3];
    /* With SINS_SAMPLE_SPECIFIC_FORCE: specific force in sensor axes at this instant, each up to 1e5 m/s2 [m/s2]. */
    double specific_force_m_s2[3];
    /*
     * With SINS_SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant, -273.15 to 1000 [deg C];
     * straight from one sample to the next. Needed while temperature coefficients are set: a sample without it is then
     * SINS_ERROR_INVALID_ARGUMENT, as a flag forgotten would be an effect lost in silence.
     */
    double temperature_c;
} sins_flight_sample;

/* Why a call failed: what the sentence of sins_last_error() is made of. */
typedef struct sins_error_info {
    /* sizeof(sins_error_info) */
    uint32_t struct_size;
    /* Flags of enum sins_error_info_flags, or'ed. */
    uint32_t flags;
    /* What the call returned, of enum sins_status_code; SINS_OK if none failed. */
    sins_status status;
    /* 0 */
    uint32_t reserved;
    /* The field or argument at fault, "gyro.markov_time_s", or what else is measured, terminated. Empty if it is the call itself. */
    char field[96];
    /* Element of the field, from 0; -1: the field is no array, or all of it is at fault. */
    int64_t index;
    /* Sample of the array that the call took, from 0; -1: none. */
    int64_t sample;
    /* With SINS_ERROR_INFO_VALUE: the value at fault, which may be no number or infinite; of an integer the nearest double. */
    double value;
    /* With SINS_ERROR_INFO_MINIMUM: the least value. Where the sentence says "more than", that value itself is refused. */
    double minimum;
    /* With SINS_ERROR_INFO_MAXIMUM: the greatest value. Where the sentence says "less than", that value itself is refused. */
    double maximum;
} sins_error_info;

/*
 * Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is an ideal
 * triad. Signal: the angular rate. Densities do not depend on the sample rate.
 *
 * Effects act along the path of the signal: bandwidth; then scale factor, misalignment, asymmetry and nonlinearity, of the
 * signal so far, g-sensitivity, of the true specific force, and temperature; then biases and noise are added; then dead zone,
 * range, quantization.
 *
 * Asymmetry, nonlinearity, dead zone and range, and the accelerometers' vibration rectification, act on the mean signal of a
 * sub-increment of the length dt = interval / (updates_per_sample * subsamples). With x = pi f dt, a vibration of frequency f loses by
 * that 1 - (sin x / x)^2 of its mean square (nonlinearity, rectification) and, where it changes sign, up to 1 - cos x of its mean size
 * (asymmetry): at a tenth of the sample rate 0.8 % and 1.2 % with two sub-increments an interval, 3.3 % and 4.9 % with one.
 */
typedef struct sins_gyro_params {
    /* sizeof(sins_gyro_params) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Constant bias, measured less true [rad/s], -100 to 100. */
    double bias_rad_s[3];
    /* Standard deviation of the turn-on bias, drawn once a run [rad/s], 0 to 100. */
    double bias_sigma_rad_s[3];
    /*
     * Standard deviation of the first-order Gauss-Markov bias [rad/s], 0 to 100. The process is stationary from
     * the first sample on.
     */
    double markov_sigma_rad_s[3];
    /* Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_rad_s is not 0. */
    double markov_time_s[3];
    /*
     * White noise N: angle or velocity random walk [rad/sqrt(s)], 0 to 100. It is the square root of the spectral
     * density of the noise [unit of the signal / sqrt(Hz)].
     */
    double random_walk_rad_sqrt_s[3];
    /* Random walk K of rate or acceleration [(rad/s)/sqrt(s)], 0 to 100. It starts at 0 at the start of a run. */
    double rate_random_walk_rad_s_sqrt_s[3];
    /* Ramp R: bias that grows with the time [rad/s2], -100 to 100. It starts at 0 when it is set. */
    double rate_ramp_rad_s2[3];
    /*
     * Flicker noise, bias instability B [rad/s], 0 to 100. The process is stationary from the first sample on: the
     * Allan deviation is flat at 0.664 B from 2 s to 50 h.
     */
    double flicker_rad_s[3];
    /* Scale factor error [1], -1 to 1. */
    double scale_factor[3];
    /*
     * Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
     * scale_factor.
     */
    double scale_factor_sigma[3];
    /* Scale factor error of positive less that of negative signals [1], -1 to 1. */
    double scale_factor_asymmetry[3];
    /* Scale factor error that grows with the size of the signal [s/rad], -1 to 1. */
    double scale_factor_nonlinearity_s_rad[3];
    /* Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The diagonal is 0. */
    double misalignment_rad[9];
    /*
     * Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
     * misalignment_rad. The diagonal is 0.
     */
    double misalignment_sigma_rad[9];
    /*
     * Drift by specific force, g-sensitivity: row = gyro, column = axis of the force [(rad/s)/(m/s2)], -1 to 1.
     * The error of a gyro is the sum over the three axes of its row times the true specific force along them.
     */
    double g_sensitivity_rad_s_per_m_s2[9];
    /*
     * Drift by the square of the specific force along the gyro's own axis, g2-sensitivity [(rad/s)/(m/s2)^2],
     * -1 to 1. The rate that gyro i measures is too large by element i times the square of component i of the true
     * specific force at the block's own point, in sensor axes: a positive element makes a drift in the positive
     * sense about the axis, whatever the sign of the force. The mean force of a sub-increment is squared, as with
     * nonlinearity.
     */
    double g2_sensitivity_rad_s_per_m2_s4[3];
    /*
     * Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
     * sins_flight_sample.temperature_c less this. Where one of the coefficients is not 0, every sample needs a
     * temperature, and sins_push_imu() is not available.
     */
    double reference_temperature_c;
    /* Bias per kelvin [(rad/s)/K], -100 to 100. The bias is this times T. */
    double bias_temperature_rad_s_per_k[3];
    /* Bias per kelvin squared [(rad/s)/K2], -100 to 100. The bias is this times T2. */
    double bias_temperature2_rad_s_per_k2[3];
    /* Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this times T. */
    double scale_factor_temperature_per_k[3];
    /* Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this times T2. */
    double scale_factor_temperature2_per_k2[3];
    /*
     * Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter is settled at
     * the first interval.
     */
    double bandwidth_hz[3];
    /* Half the dead zone: signals up to this size give 0 [rad/s], 0 to 100. */
    double dead_zone_rad_s[3];
    /* Range, where the output saturates [rad/s], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu. */
    double range_rad_s[3];
    /*
     * Pulse of the output increments [rad], 1e-15 to 1; 0: none. The rest is carried. The quantization noise Q is
     * pulse/sqrt(12).
     */
    double quantization_rad[3];
} sins_gyro_params;

/*
 * Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is
 * an ideal triad. Signal: the specific force. Densities do not depend on the sample rate.
 *
 * Effects act along the path of the signal: size effect, bandwidth; then scale factor, misalignment, asymmetry,
 * nonlinearity, vibration rectification, of the signal so far, and temperature; then biases and noise are added; then dead
 * zone, range, quantization. What acts on the mean of a sub-increment: see sins_gyro_params.
 */
typedef struct sins_accel_params {
    /* sizeof(sins_accel_params) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Constant bias, measured less true [m/s2], -10000 to 10000. */
    double bias_m_s2[3];
    /* Standard deviation of the turn-on bias, drawn once a run [m/s2], 0 to 10000. */
    double bias_sigma_m_s2[3];
    /*
     * Standard deviation of the first-order Gauss-Markov bias [m/s2], 0 to 10000. The process is stationary from
     * the first sample on.
     */
    double markov_sigma_m_s2[3];
    /* Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_m_s2 is not 0. */
    double markov_time_s[3];
    /*
     * White noise N: angle or velocity random walk [(m/s)/sqrt(s)], 0 to 10000. It is the square root of the
     * spectral density of the noise [unit of the signal / sqrt(Hz)].
     */
    double velocity_random_walk_m_s_sqrt_s[3];
    /* Random walk K of rate or acceleration [(m/s2)/sqrt(s)], 0 to 10000. It starts at 0 at the start of a run. */
    double acceleration_random_walk_m_s2_sqrt_s[3];
    /* Ramp R: bias that grows with the time [m/s3], -10000 to 10000. It starts at 0 when it is set. */
    double ramp_m_s3[3];
    /*
     * Flicker noise, bias instability B [m/s2], 0 to 10000. The process is stationary from the first sample on:
     * the Allan deviation is flat at 0.664 B from 2 s to 50 h.
     */
    double flicker_m_s2[3];
    /* Scale factor error [1], -1 to 1. */
    double scale_factor[3];
    /*
     * Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
     * scale_factor.
     */
    double scale_factor_sigma[3];
    /* Scale factor error of positive less that of negative signals [1], -1 to 1. */
    double scale_factor_asymmetry[3];
    /* Scale factor error that grows with the size of the signal [s2/m], -1 to 1. */
    double scale_factor_nonlinearity_s2_m[3];
    /* Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The diagonal is 0. */
    double misalignment_rad[9];
    /*
     * Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
     * misalignment_rad. The diagonal is 0.
     */
    double misalignment_sigma_rad[9];
    /* Vibration rectification, the g2 term [s2/m], -1 to 1. A vibration of RMS r makes a bias of this times r2. */
    double vibration_rectification_s2_m[3];
    /*
     * Lever arm of each accelerometer from the block's own point, sensor axes, row = sensor (size effect) [m],
     * -100 to 100. The block's own point is where the lever arm of sins_mounting ends. At the start of a flight in
     * motion see sins_mounting; the velocity lacks the change of rate in the first interval for good. With
     * sins_push_imu() the angular acceleration follows from the increments before.
     */
    double lever_arm_m[9];
    /*
     * Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
     * sins_flight_sample.temperature_c less this. Where one of the coefficients is not 0, every sample needs a
     * temperature, and sins_push_imu() is not available.
     */
    double reference_temperature_c;
    /* Bias per kelvin [(m/s2)/K], -10000 to 10000. The bias is this times T. */
    double bias_temperature_m_s2_per_k[3];
    /* Bias per kelvin squared [(m/s2)/K2], -10000 to 10000. The bias is this times T2. */
    double bias_temperature2_m_s2_per_k2[3];
    /* Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this times T. */
    double scale_factor_temperature_per_k[3];
    /* Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this times T2. */
    double scale_factor_temperature2_per_k2[3];
    /*
     * Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter is settled at
     * the first interval.
     */
    double bandwidth_hz[3];
    /* Half the dead zone: signals up to this size give 0 [m/s2], 0 to 10000. */
    double dead_zone_m_s2[3];
    /* Range, where the output saturates [m/s2], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu. */
    double range_m_s2[3];
    /*
     * Pulse of the output increments [m/s], 1e-15 to 1; 0: none. The rest is carried. The quantization noise Q is
     * pulse/sqrt(12).
     */
    double quantization_m_s[3];
} sins_accel_params;

/* Errors of the barometric height that damps the vertical channel. All zero is an ideal altimeter. */
typedef struct sins_altimeter_params {
    /* sizeof(sins_altimeter_params) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Constant bias, up to 1e5 m [m]. */
    double bias_m;
    /* Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on, up to 1e5 m [m]. */
    double markov_sigma_m;
    /* Its correlation time, 1e-9 to 1e15 [s]; needed where markov_sigma_m is not 0. */
    double markov_time_s;
    /* Standard deviation of the independent error of each sample, up to 1e5 m [m]. */
    double noise_m;
    /* Scale factor error of the height, -1 to 1. */
    double scale_factor;
    /* Time constant of the first-order lag of the static pressure, up to 1e6 s [s]. */
    double lag_s;
} sins_altimeter_params;

/*
 * A failure of one output of a sensor. All zero is none. What the kind does not use is 0. u is rad/s of a gyro, m/s2 of an
 * accelerometer, m of the altimeter.
 */
typedef struct sins_failure {
    /* sizeof(sins_failure) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Of enum sins_failure_kind. */
    int32_t kind;
    /* Must be 0. */
    uint32_t reserved2;
    /* Bias step, spikes: size, up to 100 rad/s, 1e4 m/s2, 1e5 m [u]. */
    double size;
    /* Noise: density as the random walk N of the sensor, up to 100, 1e4, 1e5 [u sqrt(s)]. */
    double density;
    /* Spikes: from the start of one to the next; drop-outs: from one to the next; 1e-4 to 1e9 [s]. */
    double interval_s;
    /* Spikes: length of one, 1e-9 s to interval_s [s]. */
    double duration_s;
    /* Drop-outs: probability that an interval is lost, 0 to 1, where interval_s is 0. */
    double probability;
} sins_failure;

/*
 * Errors with which the navigation starts: computed less true, east-north-up. The sigmas are drawn once a run and added.
 * Where the vertical channel follows the truth, its errors start at 0. Positions up to 1e6 m, velocities up to 1e4 m/s, their
 * standard deviations up to 1e5 m and 1e3 m/s.
 */
typedef struct sins_initial_errors {
    /* sizeof(sins_initial_errors) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Position [m]. */
    double position_enu_m[3];
    /* Velocity [m/s]. */
    double velocity_enu_m_s[3];
    /*
     * Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x]) C, C from sensor axes to
     * east-north-up, the true one or with SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS the one that the alignment finds.
     */
    double misalignment_enu_rad[3];
    /* Standard deviation of position [m]. */
    double position_sigma_enu_m[3];
    /* Standard deviation of velocity [m/s]. */
    double velocity_sigma_enu_m_s[3];
    /* Standard deviation of misalignment, 0 to 1 [rad]. */
    double misalignment_sigma_enu_rad[3];
    /* Of enum sins_alignment. */
    int32_t alignment;
    /* Must be 0. */
    uint32_t reserved2;
} sins_initial_errors;

/*
 * Where the sensor block sits against the reference point of the flight samples, and what the INS wrongly believes of that:
 * believed = true + error, component by component. All zero is a block at the reference point, along the body axes.
 *
 * The ideal sensors feel the motion of the block, and sensor errors act in its axes: sins_imu is about the block. The INS
 * navigates the block and gives out the reference point with what it believes: sins_navigation and sins_errors are about that.
 * Initial errors are those of the INS's solution of the block. Angular rate and specific force of a sample are of the reference
 * point, along body axes; so is the barometric height.
 *
 * Where a flight begins in motion, or is repositioned, samples without an angular rate do not tell the angular acceleration of the
 * first interval: the force of a block off the reference point lacks angular acceleration times arm there. The second interval has
 * it to first order of its length, the third to second, later ones to third. The navigation does not suffer: what the next
 * sample tells of the block's velocity, the INS has known from the start. With SINS_SAMPLE_ANGULAR_RATE nothing is lacking.
 */
typedef struct sins_mounting {
    /* sizeof(sins_mounting) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* From the reference point to the block, body axes (sins_options.axes), -100 to 100 [m]. */
    double lever_arm_m[3];
    /*
     * Roll, pitch and heading of the block's axes against the body axes, as those of the body against the horizon: right side
     * down, nose up, nose to the right; any number of turns up to 10000 rad, as in a flight sample [rad].
     */
    double boresight_rad[3];
    /* Believed less true lever arm, -100 to 100 [m]. */
    double lever_arm_error_m[3];
    /*
     * Believed less true boresight angles, -pi to pi [rad]. A heading believed too large makes the heading that the INS gives
     * out too small by as much.
     */
    double boresight_error_rad[3];
} sins_mounting;

/*
 * True gravity less the normal gravity that the INS computes: deflection of the vertical, and anomaly (strictly the gravity
 * disturbance: both at the same point). Each has a constant part and a random one, a first-order Gauss-Markov field along the
 * track: correlation sigma^2 exp(-d/D) over the distance d flown over ground. At rest it does not change. All zero is normal
 * gravity.
 *
 * Perfect accelerometers feel it: it is in the ideal signals of sins_imu. The INS takes it for an error of its
 * accelerometers: at rest, without a levelled start, a deflection makes it swing by R times the deflection to both sides of R
 * times the deflection; a levelled start (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) leans by it.
 */
typedef struct sins_gravity_params {
    /* sizeof(sins_gravity_params) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /*
     * Deflection in the meridian (xi): astronomic less geodetic latitude, -0.01 to 0.01 [rad]. The true zenith lies north of
     * the ellipsoid's normal, and the accelerometers at rest feel g times this to the north.
     */
    double deflection_north_rad;
    /* Standard deviation of its random part, up to 0.01 [rad]. */
    double deflection_north_sigma_rad;
    /* Correlation distance D of that, 1 to 1e9 [m]; needed where the standard deviation is not 0. */
    double deflection_north_distance_m;
    /*
     * Deflection in the prime vertical (eta): astronomic less geodetic longitude, times the cosine of latitude, -0.01 to
     * 0.01 [rad]. The true zenith lies east of the ellipsoid's normal.
     */
    double deflection_east_rad;
    /* Standard deviation of its random part, up to 0.01 [rad]. */
    double deflection_east_sigma_rad;
    /* Correlation distance of that, 1 to 1e9 [m]. */
    double deflection_east_distance_m;
    /* Anomaly, excess of gravity, -0.1 to 0.1 [m/s2]. A milligal is 1e-5 m/s2. */
    double anomaly_m_s2;
    /* Standard deviation of its random part, up to 0.1 [m/s2]. */
    double anomaly_sigma_m_s2;
    /* Correlation distance of that, 1 to 1e9 [m]. */
    double anomaly_distance_m;
} sins_gravity_params;

/* A solution within a sins_record; never grows. Fields as in sins_navigation. */
typedef struct sins_record_solution {
    /* [rad] */
    double latitude_rad;
    /* [rad] */
    double longitude_rad;
    /* [m] */
    double height_m;
    /* [m/s] */
    double velocity_enu_m_s[3];
    /* [rad] */
    double roll_rad;
    /* [rad] */
    double pitch_rad;
    /* [rad] */
    double heading_rad;
    /* Scalar first. */
    double quaternion_nb[4];
    /* Flags of enum sins_navigation_flags, or'ed. */
    int32_t flags;
    /* 0 */
    uint32_t reserved;
} sins_record_solution;

/* Errors within a sins_record; never grows. Fields as in sins_errors. */
typedef struct sins_record_errors {
    /* [m] */
    double position_enu_m[3];
    /* [rad] */
    double latitude_rad;
    /* [rad] */
    double longitude_rad;
    /* [m] */
    double height_m;
    /* [m/s] */
    double velocity_enu_m_s[3];
    /* [rad] */
    double misalignment_enu_rad[3];
    /* [rad] */
    double roll_rad;
    /* [rad] */
    double pitch_rad;
    /* [rad] */
    double heading_rad;
    /* Flags of enum sins_errors_flags, or'ed. */
    int32_t flags;
    /* 0 */
    uint32_t reserved;
} sins_record_errors;

/* Truth, navigation and both errors at one instant. */
typedef struct sins_record {
    /* sizeof(sins_record); in an array it is enough to set it in the first element and 0 in the others. */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Time [s]. */
    double time_s;
    /* As sins_get_truth(). */
    struct sins_record_solution truth;
    /* As sins_get_navigation(). */
    struct sins_record_solution navigation;
    /* As sins_get_errors() with SINS_ERRORS_NAVIGATION: error data 2. */
    struct sins_record_errors navigation_errors;
    /* As sins_get_errors() with SINS_ERRORS_MODEL: error data 1; flagged SINS_ERRORS_NOT_COMPUTED while the model is off. */
    struct sins_record_errors model_errors;
} sins_record;

/* A solution: the truth or the navigated one. */
typedef struct sins_navigation {
    /* sizeof(sins_navigation) */
    uint32_t struct_size;
    /* 0 (must be 0 where it is an input). */
    uint32_t reserved;
    /* Time [s]. */
    double time_s;
    /* Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /* Longitude, east positive, -pi to pi [rad]. */
    double longitude_rad;
    /* Height above the ellipsoid [m]. */
    double height_m;
    /* Velocity against the Earth, east-north-up [m/s]. */
    double velocity_enu_m_s[3];
    /* Roll, right wing down positive, -pi to pi [rad]. */
    double roll_rad;
    /* Pitch, nose up positive, -pi/2 to pi/2 [rad]. */
    double pitch_rad;
    /* Heading, clockwise from true north, 0 to 2 pi [rad]. */
    double heading_rad;
    /* Attitude quaternion, scalar first: rotates from sensor axes to east-north-up. */
    double quaternion_nb[4];
    /* Flags of enum sins_navigation_flags, or'ed. */
    int32_t flags;
    /* 0 */
    uint32_t reserved2;
} sins_navigation;

/* Ideal and measured signals of the last interval, sensor axes. */
typedef struct sins_imu {
    /* sizeof(sins_imu) */
    uint32_t struct_size;
    /* Flags of enum sins_imu_flags, or'ed. */
    uint32_t flags;
    /* Time of the end of the interval [s]. */
    double time_s;
    /* Length of the interval [s]. */
    double interval_s;
    /* Integral of the angular rate against inertial space, perfect gyros [rad]. */
    double ideal_angle_rad[3];
    /* Integral of the specific force, perfect accelerometers [m/s]. */
    double ideal_velocity_m_s[3];
    /* What the modelled gyros give [rad]. */
    double measured_angle_rad[3];
    /* What the modelled accelerometers give [m/s]. */
    double measured_velocity_m_s[3];
    /* ideal_angle_rad over the interval [rad/s]. */
    double ideal_rate_rad_s[3];
    /* ideal_velocity_m_s over the interval [m/s2]. */
    double ideal_force_m_s2[3];
    /* measured_angle_rad over the interval [rad/s]. */
    double measured_rate_rad_s[3];
    /* measured_velocity_m_s over the interval [m/s2]. */
    double measured_force_m_s2[3];
} sins_imu;

/* Errors of the navigated solution, computed less true. */
typedef struct sins_errors {
    /* sizeof(sins_errors) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Time [s]. */
    double time_s;
    /* Displacement from truth along true east and north, and difference of heights [m]. */
    double position_enu_m[3];
    /* Latitude [rad]. */
    double latitude_rad;
    /* Longitude, wrapped to -pi..pi [rad]. */
    double longitude_rad;
    /* Height [m]. */
    double height_m;
    /* Velocity [m/s]: difference of the components, each in its own east-north-up. */
    double velocity_enu_m_s[3];
    /*
     * Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) C, C from sensor axes to east-north-up. The error model
     * has it to first order, computed C = (I - [phi x]) C.
     */
    double misalignment_enu_rad[3];
    /* Roll, wrapped [rad]. */
    double roll_rad;
    /* Pitch [rad]. */
    double pitch_rad;
    /* Heading, wrapped [rad]. */
    double heading_rad;
    /* Flags of enum sins_errors_flags, or'ed. */
    int32_t flags;
    /* 0 */
    uint32_t reserved2;
} sins_errors;

/*
 * Running figures of the flight since its start or last reposition (sins_move_time() and sins_move_truth() leave them), errors sampled once a second. They describe one run,
 * which is no ensemble. Divide the rates by SINS_NMI_PER_HOUR for the unit of data sheets.
 */
typedef struct sins_accuracy {
    /* sizeof(sins_accuracy) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Time [s]. */
    double time_s;
    /* Time since the start [s]. */
    double duration_s;
    /*
     * Where the window of the radial error rates begins, in time since the start: 300 s; before, they are initial errors
     * over next to nothing [s].
     */
    double window_start_s;
    /* Samples in that window; the rates are 0 while there is none. */
    uint64_t window_samples;
    /* sqrt(mean RER^2); radial error rate RER = horizontal position error / time since the start [m/s]. */
    double radial_error_rate_rms_m_s;
    /* R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s]. */
    double cep_rate_m_s;
    /* R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s]. */
    double radial_95_rate_m_s;
    /* Slope of the straight line of least squares through the horizontal position error [m/s]. */
    double radial_error_slope_m_s;
    /*
     * Root mean square velocity error since the start, east-north-up; without samples within 20 km of the Earth's axis, where
     * east and north turn [m/s].
     */
    double velocity_rms_enu_m_s[3];
    /* Closure: navigation minus truth now, position [m]. */
    double closure_position_enu_m[3];
    /* Closure: navigation minus truth now, velocity [m/s]. */
    double closure_velocity_enu_m_s[3];
    /*
     * Share of the horizontal position closure that the host's own inconsistency explains [m]: the Schuler-tuned answer
     * to displacement by velocity less displacement by position; up is 0. Closure less this is the simulator's and the
     * sensors'.
     */
    double host_position_enu_m[3];
    /* The same of the horizontal velocity closure; up is 0 [m/s]. */
    double host_velocity_enu_m_s[3];
    /* Displacement by the host's velocities less displacement by its positions, summed over the flight [m]. */
    double inconsistency_enu_m[3];
    /* The largest of it in one interval [m]. */
    double inconsistency_max_m;
    /* Samples flagged SINS_NAVIGATION_INCONSISTENT. */
    uint64_t inconsistent_samples;
    /* Intervals flown since the start or the last reposition: one less than the samples. */
    uint64_t intervals;
    /*
     * The largest trim that SINS_SIGNAL_CLOSED_LOOP added to the angular rate, from ten of its time constants on: the error of
     * generator and mechanization themselves; 0 with physical signals [rad/s].
     */
    double trim_rate_max_rad_s;
    /* The same of the specific force [m/s2]. */
    double trim_force_max_m_s2;
} sins_accuracy;

/*
 * The motion of the truth in figures, over all intervals since the create or the last sins_reset(): those of wrong units or
 * exchanged axes are none of a vehicle. Attitudes in degrees turn 57 times as fast and show any sideslip; east and north
 * exchanged are a sideslip and a contradiction between velocity and position, as are knots for m/s; feet for metres are heights and
 * climbs of 3.3 times their size. Rates, accelerations and forces are means from one sample to the next. Each ..._at_s is the
 * time stamp of the sample that it came with.
 */
typedef struct sins_truth_summary {
    /* sizeof(sins_truth_summary) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Intervals flown. */
    uint64_t intervals;
    /* Those of them that are gaps (see SINS_GAP). */
    uint64_t gaps;
    /* Samples faster than 30 m/s: sideslip and angle of attack are of these. */
    uint64_t fast_samples;
    /* Sum of the lengths of the intervals [s]. */
    double flown_s;
    /* Time stamps of the first and of the last sample [s]. */
    double first_s;
    /* See first_s. */
    double last_s;
    /* Longest interval [s]. */
    double interval_max_s;
    /* When [s]. */
    double interval_max_at_s;
    /* Largest rotation in an interval [rad]. */
    double turn_max_rad;
    /* When [s]. */
    double turn_max_at_s;
    /* Largest angular rate: by the attitudes against the Earth, or the samples' own [rad/s]. */
    double rate_max_rad_s;
    /* When [s]. */
    double rate_max_at_s;
    /* Largest acceleration against the Earth, by the velocities [m/s2]. */
    double acceleration_max_m_s2;
    /* When [s]. */
    double acceleration_max_at_s;
    /* Largest specific force: by the velocities and gravity, or the samples' own [m/s2]. */
    double force_max_m_s2;
    /* When [s]. */
    double force_max_at_s;
    /* Largest displacement in an interval that the mean of the velocities at its ends does not explain [m]. */
    double inconsistency_max_m;
    /* When [s]. */
    double inconsistency_max_at_s;
    /* Largest speed against the Earth [m/s]. */
    double speed_max_m_s;
    /* When [s]. */
    double speed_max_at_s;
    /* Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth, to the right; wind is in it [rad]. */
    double sideslip_max_rad;
    /* When [s]. */
    double sideslip_max_at_s;
    /*
     * Angle of attack of the largest size, from the velocity against the Earth up to the forward axis, in the plane of
     * symmetry [rad].
     */
    double attack_max_rad;
    /* When [s]. */
    double attack_max_at_s;
    /* Lowest height [m]. */
    double height_min_m;
    /* When [s]. */
    double height_min_at_s;
    /* Highest height [m]. */
    double height_max_m;
    /* When [s]. */
    double height_max_at_s;
} sins_truth_summary;

/* Increments of an inertial measurement unit over an interval, in count parts of equal length. */
typedef struct sins_imu_increment {
    /* sizeof(sins_imu_increment) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Length of the whole interval, 5e-5 to 10 [s]. */
    double interval_s;
    /* Parts, 1 to 5. */
    int32_t count;
    /* Must be 0. */
    uint32_t reserved2;
    /*
     * Integral of the angular rate against inertial space over each part, up to 1e3 rad: x, y, z of the
     * first, of the second, ... [rad].
     */
    double angle_rad[15];
    /* Integral of the specific force over each part, up to 1e4 m/s, likewise [m/s]. */
    double velocity_m_s[15];
} sins_imu_increment;

/*
 * Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the same bits however
 * they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without pointers: send it, store it,
 * compare its bytes. Its numbers have the byte order of the machine. A struct that is all zero but for struct_size has no run.
 * sins_statistics_figures() computes means, covariances and radii.
 *
 * The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment about east, north,
 * up, as in sins_errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24 um), 2^-29 m/s (1.9 nm/s),
 * 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262 km/s) and 4 rad, which are 2^47 resolutions;
 * the horizontal radial position error is in range below 2^25 m. There are at most 4294967295 runs: their sums cannot overflow.
 * Integers of 128 bits are two words, the low one first, in two's complement.
 */
typedef struct sins_statistics {
    /* sizeof(sins_statistics) */
    uint32_t struct_size;
    /* Version of what follows: 1; 0 while there is no run. */
    uint32_t layout;
    /* Runs, those that were left out of the sums too. */
    uint64_t runs;
    /* Runs that have diverged, left out of the sums. */
    uint64_t diverged;
    /* Runs with a state or a horizontal radial position error outside its range, left out of the sums. */
    uint64_t out_of_range;
    /* Runs within the sums whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. */
    uint64_t outside_validity;
    /* Largest horizontal radial position error, rounded down [2^-22 m]. */
    uint64_t largest_radial;
    /* Sum of each state, integers of 128 bits. */
    uint64_t sums[18];
    /* Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row by row. */
    uint64_t products[90];
    /*
     * Runs by horizontal radial position error: element 0 those below 2^-10 m (1 mm), and 1 + 100 i + k, for i from 0 to 34 and k
     * from 0 to 99, those from 2^(i-10) (1 + k/100) up to 2^(i-10) (1 + (k+1)/100) m.
     */
    uint32_t histogram[3501];
    /* 0 */
    uint32_t reserved;
} sins_statistics;

/* Figures that are computed from a sins_statistics. Without a run all are 0, and the covariance of one run is 0. */
typedef struct sins_figures {
    /* sizeof(sins_figures) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Runs, those that were left out too. */
    uint64_t runs;
    /* Runs that have diverged, left out. */
    uint64_t diverged;
    /* Runs with an error outside its range, left out. */
    uint64_t out_of_range;
    /* Runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY, not left out. */
    uint64_t outside_validity;
    /* Mean position error [m]. */
    double mean_position_enu_m[3];
    /* Mean velocity error [m/s]. */
    double mean_velocity_enu_m_s[3];
    /* Mean misalignment [rad]. */
    double mean_misalignment_enu_rad[3];
    /* Standard deviation of the position error, with the divisor n - 1 [m]. */
    double sigma_position_enu_m[3];
    /* Standard deviation of the velocity error [m/s]. */
    double sigma_velocity_enu_m_s[3];
    /* Standard deviation of the misalignment [rad]. */
    double sigma_misalignment_enu_rad[3];
    /* Root mean square of the position error [m]. */
    double rms_position_enu_m[3];
    /* Root mean square of the velocity error [m/s]. */
    double rms_velocity_enu_m_s[3];
    /* Root mean square of the misalignment [rad]. */
    double rms_misalignment_enu_rad[3];
    /*
     * Covariance of the nine states of sins_statistics, with the divisor n - 1, row by row: element 9 i + j is that of the states i
     * and j, in m, m/s and rad.
     */
    double covariance[81];
    /* Root mean square of the horizontal radial position error [m]. */
    double rms_radial_m;
    /*
     * Horizontal radius within which half of the runs are [m]: the radial error of the run with this rank, read from the histogram
     * to 0.5 % of itself, below 1 mm to 0.5 mm.
     */
    double cep50_m;
    /* Horizontal radius within which 95 % of the runs are [m], read from the histogram as cep50_m. */
    double r95_m;
    /* Largest horizontal radial position error [m]. */
    double largest_radial_m;
} sins_figures;

/* Where an embedded flight begins, level and straight. */
typedef struct sins_flight_start {
    /* sizeof(sins_flight_start) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /* Longitude, east positive, -100 to 100 [rad]. */
    double longitude_rad;
    /* Height above the ellipsoid, -20 km to 2000 km [m]. */
    double height_m;
    /* Speed against the Earth, 0 to 10 km/s [m/s]. */
    double speed_m_s;
    /* Course and heading, -100 to 100 [rad]. */
    double heading_rad;
    /* Roll of the body against the path's axes throughout the flight, -pi to pi [rad]. */
    double roll_rad;
    /* Pitch of the body against the path's axes throughout the flight, -pi/2 to pi/2: angle of attack, or tilt at rest [rad]. */
    double pitch_rad;
    /* Of enum sins_earth, as in the options of the simulator that will fly it. */
    int32_t earth;
    /* Must be 0. */
    uint32_t reserved2;
} sins_flight_start;

/* One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0. */
typedef struct sins_manoeuvre {
    /* sizeof(sins_manoeuvre); in an array it is enough to set it in the first element and 0 in the others. */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Of enum sins_manoeuvre_kind. */
    int32_t kind;
    /* Sinusoids, 1 to 6. */
    int32_t sinusoid_count;
    /* Duration, 1e-3 to 1e8 [s]. */
    double duration_s;
    /* Time in which the manoeuvre sets in, and in which it ends; at most half of it. 0: 5 s [s]. */
    double ramp_s;
    /* Change of speed, to no less than 0 and no more than 10 km/s [m/s]. */
    double speed_change_m_s;
    /* Change of height; the climb angle must stay below 64 degrees [m]. */
    double height_change_m;
    /* Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad [rad]. */
    double heading_change_rad;
    /* Bank of a turn, 1e-3 to 1.5 [rad]. */
    double bank_rad;
    /* Whole rolls or loops, up to 1e4, or swings of an S-turn, up to 1e6. */
    double turns;
    /* What each sinusoid moves, of enum sins_channel. */
    int32_t channel[6];
    /*
     * Amplitude of each sinusoid, up to 10 rad, 1.5 rad for the climb angle, all of the speed together up to it [rad] or
     * [m/s].
     */
    double amplitude[6];
    /* Frequency of each sinusoid, 0 to 1000 [Hz]. */
    double frequency_hz[6];
    /* Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), t since the begin of the manoeuvre [rad]. */
    double phase_rad[6];
} sins_manoeuvre;

/* A fault of the text of a scene or of a flight log. */
typedef struct sins_fault {
    /* sizeof(sins_fault) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Faults of the text, 200 at the most. */
    uint64_t count;
    /* Line of this one, from 1. */
    uint64_t line;
    /* Column, in characters from 1; of a flight log the column of the table. */
    uint64_t column;
    /* Which key, which value, which limit, and the key that was probably meant; UTF-8, terminated, cut where it is longer. */
    char sentence[256];
} sins_fault;

/* What a scene says of its flight and of its output. */
typedef struct sins_scene_setup {
    /* sizeof(sins_scene_setup) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Of enum sins_scene_flight; read only: a set call passes over it. */
    int32_t flight;
    /* 1: samples get the temperature below; 0: none. */
    int32_t has_temperature;
    /* 1: a program shows neither progress nor summary; 0: it does. */
    int32_t quiet;
    /* Must be 0. */
    uint32_t reserved2;
    /* How long to fly, 0.036 to 3.6e8; 0: the whole flight, or as long as the built-in scene [s]. */
    double duration_s;
    /* How long that is; 0 of a log, whose length the log tells, or if duration_s is more than the flight has; read only [s]. */
    double flown_s;
    /* Sample rate, 1e-3 to 2e4; 0 of a log, which has its own time stamps [Hz]. */
    double rate_hz;
    /* Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if there is none [deg C]. */
    double temperature_c;
    /* Its change, -277 to 277 [deg C/s]. */
    double temperature_change_c_s;
    /* Spacing of the records of a program, 5e-5 to 1e7; 0: the program's choice [s]. */
    double every_s;
} sins_scene_setup;

/* A failure that a scene plans. */
typedef struct sins_planned_failure {
    /* sizeof(sins_planned_failure) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Of enum sins_sensor. */
    int32_t sensor;
    /* 0, 1, 2: x, y, z of the sensor axes; of the altimeter 0. */
    int32_t axis;
    /* When it begins, 0 to 1e9 since the start of the flight [s]. */
    double from_s;
    /* When it ends, likewise; 0: at the end of the flight [s]. */
    double until_s;
    /* Of enum sins_failure_kind, but not SINS_FAILURE_NONE. */
    int32_t kind;
    /* Must be 0. */
    uint32_t reserved2;
    /* This and the following as in sins_failure. */
    double size;
    /* See sins_failure. */
    double density;
    /* See sins_failure [s]. */
    double interval_s;
    /* See sins_failure [s]. */
    double duration_s;
    /* See sins_failure. */
    double probability;
} sins_planned_failure;

/* What a flight log holds. */
typedef struct sins_log_info {
    /* sizeof(sins_log_info) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Samples. */
    uint64_t samples;
    /* From the first to the last of them [s]. */
    double duration_s;
    /* The comment in the first line of the log, UTF-8, terminated; empty: none. */
    char title[192];
} sins_log_info;

/*
 * Largest error that the algorithm itself may make, apart from those of the sensors, at any time within a duration. A limit
 * of 0 is none; at least one is needed.
 */
typedef struct sins_requirement {
    /* sizeof(sins_requirement) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* For how long, up to 1e6 [s]; 0, or less than the piece's length: for the piece. */
    double duration_s;
    /* Distance from where the exact solution on the same signals is [m]. */
    double position_m;
    /* Speed of the difference in velocity [m/s]. */
    double velocity_m_s;
    /* Angle between the attitudes, against the Earth [rad]. */
    double attitude_rad;
    /* How many times the predicted error has to fit into each limit, 1 to 1e6; 0: 2. */
    double margin;
} sins_requirement;

/* What recommended options give, and what they cost. */
typedef struct sins_cost {
    /* sizeof(sins_cost) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* For how long the errors are predicted [s]. */
    double duration_s;
    /* Predicted error, the worst within the duration: position [m]. */
    double position_m;
    /* Velocity [m/s]. */
    double velocity_m_s;
    /* Attitude against the Earth [rad]. */
    double attitude_rad;
    /* The part of it that is the uncertainty of the reference: position [m]. */
    double reference_position_m;
    /* Velocity [m/s]. */
    double reference_velocity_m_s;
    /* Attitude [rad]. */
    double reference_attitude_rad;
    /* Predicted error times margin over its limit, the largest of the three: met up to 1. A limit below 1e-100 counts as 1e-100. */
    double share;
    /* Instructions of a step that the algorithm has a part in, the same on every machine: what the algorithms are ordered by. */
    double instructions_per_step;
    /* Measured here and now, in the options that were written, in the mounting and with ideal sensors: push and step of one sample [ns]. */
    double ns_per_step;
    /* Algorithms that were tried, the recommended one among them. */
    uint64_t tried;
} sins_cost;

/* What a budget is asked for. A limit of 0 is none. */
typedef struct sins_budget_request {
    /* sizeof(sins_budget_request) */
    uint32_t struct_size;
    /* Must be 0. */
    uint32_t reserved;
    /* Runs of each random effect, 8 to 1000; 0: 16. */
    uint64_t runs;
    /* What the effects that are left out may change together at any time of the scene: position [m]. */
    double position_m;
    /* Velocity [m/s]. */
    double velocity_m_s;
    /* Misalignment [rad]. */
    double attitude_rad;
} sins_budget_request;

/*
 * An effect and what it contributes; in the first row of a budget, what the mechanization and the samples leave with nothing
 * set.
 */
typedef struct sins_budget_row {
    /* sizeof(sins_budget_row) */
    uint32_t struct_size;
    /* Flags of enum sins_budget_flags, or'ed. */
    uint32_t flags;
    /* Name of the effect, "gyro turn-on bias", terminated; of the first row "mechanization". */
    char effect[32];
    /* The field that sets it, "gyro.bias_sigma_rad_s", terminated: 0 there leaves it out. Empty in the first row. */
    char field[48];
    /* Length of the contribution to the position error, the largest of the scene [m]. */
    double position_m;
    /* Velocity [m/s]. */
    double velocity_m_s;
    /* Misalignment [rad]. */
    double attitude_rad;
    /* The same at the end of the scene: position [m]. */
    double end_position_m;
    /* Velocity [m/s]. */
    double end_velocity_m_s;
    /* Misalignment [rad]. */
    double end_attitude_rad;
    /* The largest share of a limit that the contribution takes up; 0 without limits. */
    double share;
    /*
     * Measured here and now: what a step takes with all effects less without this one; in the first row what it takes with
     * nothing set [ns]. Uncertain by 1 to 5 % of a step, more on a busy machine, so that it may be negative.
     */
    double ns_per_step;
} sins_budget_row;

/* A budget as a whole. */
typedef struct sins_budget {
    /* sizeof(sins_budget) */
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Time that was looked at: from the end of the first interval to that of the last [s]. */
    double duration_s;
    /* Runs of each random effect; 1 if there is none. */
    uint64_t runs;
    /* Flights that were flown. */
    uint64_t flights;
    /* A standard deviation lies with 95 % probability between its row's figure times this, ... */
    double sigma_low;
    /* ... and times this; both are 1 if nothing is random. */
    double sigma_high;
    /* Errors with all effects together, root mean square over the runs, the largest of the scene: position [m]. */
    double position_m;
    /* Velocity [m/s]. */
    double velocity_m_s;
    /* Misalignment [rad]. */
    double attitude_rad;
    /* What of that the sum of all rows does not explain: position [m]. */
    double remainder_position_m;
    /* Velocity [m/s]. */
    double remainder_velocity_m_s;
    /* Misalignment [rad]. */
    double remainder_attitude_rad;
    /* What the errors change by without the marked rows, flown: position [m]. */
    double left_out_position_m;
    /* Velocity [m/s]. */
    double left_out_velocity_m_s;
    /* Misalignment [rad]. */
    double left_out_attitude_rad;
    /* Measured here and now: what a step takes with all effects [ns]. */
    double ns_per_step;
} sins_budget;

/* Sizes of the structs in bytes, the same on every platform: what struct_size is set to in other languages than C. */
enum sins_sizeof {
    SINS_SIZEOF_OPTIONS = 104,
    SINS_SIZEOF_FLIGHT_SAMPLE = 144,
    SINS_SIZEOF_ERROR_INFO = 152,
    SINS_SIZEOF_GYRO_PARAMS = 736,
    SINS_SIZEOF_ACCEL_PARAMS = 736,
    SINS_SIZEOF_ALTIMETER_PARAMS = 56,
    SINS_SIZEOF_FAILURE = 56,
    SINS_SIZEOF_INITIAL_ERRORS = 160,
    SINS_SIZEOF_MOUNTING = 104,
    SINS_SIZEOF_GRAVITY_PARAMS = 80,
    SINS_SIZEOF_RECORD_SOLUTION = 112,
    SINS_SIZEOF_RECORD_ERRORS = 128,
    SINS_SIZEOF_RECORD = 496,
    SINS_SIZEOF_NAVIGATION = 128,
    SINS_SIZEOF_IMU = 216,
    SINS_SIZEOF_ERRORS = 144,
    SINS_SIZEOF_ACCURACY = 256,
    SINS_SIZEOF_TRUTH_SUMMARY = 232,
    SINS_SIZEOF_IMU_INCREMENT = 264,
    SINS_SIZEOF_STATISTICS = 14920,
    SINS_SIZEOF_FIGURES = 936,
    SINS_SIZEOF_FLIGHT_START = 72,
    SINS_SIZEOF_MANOEUVRE = 240,
    SINS_SIZEOF_FAULT = 288,
    SINS_SIZEOF_SCENE_SETUP = 72,
    SINS_SIZEOF_PLANNED_FAILURE = 80,
    SINS_SIZEOF_LOG_INFO = 216,
    SINS_SIZEOF_REQUIREMENT = 48,
    SINS_SIZEOF_COST = 96,
    SINS_SIZEOF_BUDGET_REQUEST = 40,
    SINS_SIZEOF_BUDGET_ROW = 152,
    SINS_SIZEOF_BUDGET = 128
};

/* The version of the interface that the loaded library has: compare it with SINS_HEADER_ABI. */
SINS_API uint32_t SINS_CALL sins_abi_version(void);

/* The release of the loaded library as text, "0.1.0"; lives as long as the library is loaded. */
SINS_API const char *SINS_CALL sins_version_string(void);

/*
 * The name of a status code, "SINS_OK"; "unknown status" for a number that is none. Lives as long as the library is
 * loaded.
 */
SINS_API const char *SINS_CALL sins_status_string(sins_status status);

/* Reads the options in effect: those of the create or of the snapshot that was loaded, with the defaults in place of 0. */
SINS_API sins_status SINS_CALL sins_get_options(sins_sim *sim, struct sins_options *options);

/*
 * Creates a simulator with ideal sensors. options may be NULL: the recommended simulator.
 *
 * On an error *sim is untouched, and sins_last_error(NULL, ...) on this thread tells why. SINS_ERROR_OUT_OF_MEMORY: no
 * memory, or 4096 simulators live. Not for a real-time frame: it allocates.
 */
SINS_API sins_status SINS_CALL sins_create(const struct sins_options *options, sins_sim **sim);

/*
 * Destroys a simulator. A call on it in another thread is waited for; the handle is never used again.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_destroy(sins_sim *sim);

/*
 * Takes one flight-control sample into the queue (16 samples). Each is checked by itself and against the one before.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
 * SINS_ERROR_TIME_ORDER: not later than the one before, by less than 5e-5 s, or off a stated period by more than 0.4 of it.
 * SINS_GAP: taken, and the interval before it is a gap, of more than 2.5 times each of the two before: its sins_step() flies it as
 * motion, the velocity times its length, up to max_gap_s. After a pause of the host whose clock ran on, call sins_move_time()
 * before this push; the push cannot be taken back.
 * SINS_ERROR_DISCONTINUITY: a gap of more than max_gap_s, a jump or half a turn since the last that was taken: no other is taken
 * until one fits, or until sins_move_time() for a gap, sins_move_truth() or sins_reposition() for a jump.
 * SINS_ERROR_QUEUE_FULL: step first. SINS_ERROR_BAD_STATE: navigating on increments.
 */
SINS_API sins_status SINS_CALL sins_push_sample(sins_sim *sim, const struct sins_flight_sample *sample);

/*
 * Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples, each
 * further one one more. No allocation, no system call. An interval in which the host's clock ran on is flown like any other,
 * the velocity times its length; sins_push_sample() answers SINS_GAP for it.
 *
 * SINS_NEED_SAMPLE: no complete interval waits. SINS_ERROR_DIVERGED: the interval would lead the solution of the block, of the
 * reference point or of the closed loop's own error-free navigator beyond -500 km or
 * 20000 km of height or 100 km/s; SINS_ERROR_SINGULAR: within reach of a pole, in geographic axes. The step is not made, the
 * solution before it stays readable, and sins_reposition() or sins_reset() start anew. SINS_ERROR_BAD_STATE: navigating on
 * increments.
 */
SINS_API sins_status SINS_CALL sins_step(sins_sim *sim);

/*
 * The newest accepted sample counts as at time_s from now on [s], and the stamps of samples to come follow on it: for a pause in
 * which the host's clock ran on. time_s is where the clock was when the vehicle moved on. All else is as it was: errors, noise,
 * waiting samples, sensor processes, failures, running figures, and the stated period, whose grid moves along. A flight goes on to
 * the same bits as one whose stamps never jumped if the differences between successive stamps are the same doubles; with a stated
 * period they always are. (Without velocities the differences over three samples count too; durations in sins_accuracy are
 * rounded as the time stamps are.) flight_start_s of sins_scene_prepare() is the host's: move it by as much.
 *
 * SINS_ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9. SINS_ERROR_BAD_STATE: no sample yet, or navigating on
 * increments, which have no stamps.
 */
SINS_API sins_status SINS_CALL sins_move_time(sins_sim *sim, double time_s);

/*
 * The vehicle was slewed: truth jumps to the sample, and the INS keeps the errors that it has. No interval is flown from the
 * sample before to this one, so the errors do not grow between them. Position error in metres (along
 * the truth's east and north, and in height), velocity error (components) and misalignment that sins_get_errors() tells are those
 * before, from both sources, to 1e-8 m, 1e-11 m/s and 1e-14 rad; what comes of them is up to gravity, the latitude and the velocity
 * there. Noise, sensor processes, failures, the vertical channel, the altimeter's error (but that of its scale
 * factor, which is of the new height) and running figures go on; no draw moves. The sensors follow the new signals at once. Waiting
 * samples are dropped; time may jump too, all clocks with it, as in sins_move_time(). sins_get_imu() still tells the interval
 * before. Where the sample has no velocity, the solution has its velocity error alone until the next is pushed.
 *
 * Within 20 km of the Earth's axis, before or after, where the components along east and north of truth and solution have no
 * common meaning, errors of velocity and attitude are those in the truth's axes, turned to the solution's vertical by the shortest
 * way. With a mounting the errors kept are those of the sensor block; those of the reference point are what its arm and boresight,
 * and what is wrong of them, make of that in the new attitude.
 *
 * Before the first step there is no INS with errors: it is sins_reposition() then. SINS_ERROR_INVALID_ARGUMENT,
 * SINS_ERROR_BAD_STATE: as sins_reposition(). SINS_ERROR_SINGULAR: within reach of a pole, in geographic axes.
 * SINS_ERROR_DIVERGED: the solution would leave its range, or there is no place with such an error, a quarter of the Earth away.
 */
SINS_API sins_status SINS_CALL sins_move_truth(sins_sim *sim, const struct sins_flight_sample *sample);

/*
 * The flight simulator was reloaded: truth jumps to the sample, the INS starts again there with its initial errors. The errors that
 * it had are lost; to keep them call sins_move_truth() (slew) or sins_move_time() (pause) instead. Noise and failures go on where
 * they were. Waiting samples and the running accuracy figures are dropped. Time may jump
 * too, forward or back: the run, and the count of a stated period, go on from the sample's time stamp. What is read until the
 * next step is that of the sample; an interval to read there is none. It may be the first call of a run: the sample is then the
 * first, and the next push makes an interval.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample(). SINS_ERROR_BAD_STATE: navigating on increments. Where no INS can start
 * (a pole, in geographic axes) it is the reads and the next step that say so.
 */
SINS_API sins_status SINS_CALL sins_reposition(sins_sim *sim, const struct sins_flight_sample *sample);

/*
 * Back to before the first sample: same options, the parameters as they were set last, no failures, and the same draws again
 * from their start, so that the same samples and settings give the same bits. For other draws create a simulator with another
 * seed or run; to come back to a moment in flight, see sins_snapshot_save().
 */
SINS_API sins_status SINS_CALL sins_reset(sins_sim *sim);

/*
 * Copies the sentence of the last failed call on this handle: which field, which value, which limit. UTF-8, always
 * terminated; "no error" if none failed. With a NULL handle: that of the last failed call on this thread that has no simulator
 * (create, presets, flights, ensembles, statistics, scenes, logs, recommend, budget) or whose handle was refused (SINS_ERROR_BAD_HANDLE, or SINS_ERROR_BAD_STATE: see
 * Threads). This call and sins_last_error_info() leave no sentence where they fail themselves.
 *
 * needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for that
 * alone. SINS_ERROR_BUFFER_TOO_SMALL: the sentence was cut.
 */
SINS_API sins_status SINS_CALL sins_last_error(const sins_sim *sim, char *buffer, size_t capacity, size_t *needed);

/*
 * Reads why the last call on this handle failed, or with a NULL handle on this thread: that of which sins_last_error() has the
 * sentence.
 */
SINS_API sins_status SINS_CALL sins_last_error_info(const sins_sim *sim, struct sins_error_info *info);

/*
 * Sets the gyro errors: before the first sample or in flight, from the next interval on. The draws of other effects do not
 * move; processes that were active go on from where they are.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: temperature coefficients while samples without
 * a temperature wait, or while navigating on increments.
 */
SINS_API sins_status SINS_CALL sins_set_gyro(sins_sim *sim, const struct sins_gyro_params *params);

/* Reads the gyro errors, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_gyro(sins_sim *sim, struct sins_gyro_params *params);

/*
 * Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The draws of other
 * effects do not move; processes that were active go on from where they are.
 *
 * SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().
 */
SINS_API sins_status SINS_CALL sins_set_accel(sins_sim *sim, const struct sins_accel_params *params);

/* Reads the accelerometer errors, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_accel(sins_sim *sim, struct sins_accel_params *params);

/*
 * Sets the errors of the barometric height that damps the vertical channel (SINS_VERTICAL_DAMPED), from the next interval
 * on.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_set_altimeter(sins_sim *sim, const struct sins_altimeter_params *params);

/* Reads the errors of the altimeter, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_altimeter(sins_sim *sim, struct sins_altimeter_params *params);

/*
 * Lets one output fail, as an instructor's station does: before the first sample or in flight, from the next interval on,
 * until it is cleared by SINS_FAILURE_NONE or another failure of the same output takes its place. Several outputs may fail at
 * once.
 *
 * sensor is of enum sins_sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before dead zone,
 * range and quantization, the others replace the output. No draw of another effect moves, and what runs on behind a failure is
 * there again when it is cleared. Both error data hear of it. The alignment at the start does not see failures.
 * sins_reposition() keeps them; sins_reset() clears them all, so that an exercise begins anew with sound sensors, and failures
 * set again at the same intervals give the same bits.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. A failure that throws the
 * solution away makes sins_step() answer SINS_ERROR_DIVERGED.
 */
SINS_API sins_status SINS_CALL sins_set_failure(
    sins_sim *sim, int32_t sensor, int32_t axis, const struct sins_failure *failure);

/*
 * Reads the failure of one output: at any moment, after sins_snapshot_load() too; SINS_FAILURE_NONE if it is sound. sensor and
 * axis as in sins_set_failure().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such output.
 */
SINS_API sins_status SINS_CALL sins_get_failure(
    sins_sim *sim, int32_t sensor, int32_t axis, struct sins_failure *failure);

/*
 * Sets the errors with which the navigation starts: before the first step, after a reset or after a reposition.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_initial_errors(sins_sim *sim, const struct sins_initial_errors *errors);

/* Reads the errors with which the navigation starts, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_initial_errors(sins_sim *sim, struct sins_initial_errors *errors);

/*
 * Sets where the sensor block sits: before the first step, after a reset or after a reposition; both keep it. A navigator on
 * increments is not concerned: its solution is that of the block.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_mounting(sins_sim *sim, const struct sins_mounting *mounting);

/* Reads place and attitude of the sensor block, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_mounting(sins_sim *sim, struct sins_mounting *mounting);

/*
 * Sets true gravity less normal gravity: before the first step, after a reset or after a reposition. A reset brings the
 * same field back; after a reposition it goes on from its values there. A navigator on increments is not concerned: these have
 * felt their own gravity.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_gravity_disturbance(sins_sim *sim, const struct sins_gravity_params *params);

/* Reads the parameters of the gravity disturbance, as they were set last: at any moment, after sins_snapshot_load() too. */
SINS_API sins_status SINS_CALL sins_get_gravity_disturbance(sins_sim *sim, struct sins_gravity_params *params);

/*
 * Pushes and steps count samples, and writes a record each `every` intervals since the flight's start. Any split of a
 * flight into calls gives the same bits, records included, as pushing and stepping sample by sample.
 *
 * samples[0].struct_size tells how far apart the samples are, records[0].struct_size the records; the others' may be 0,
 * those of the records anything. every 0: no records. written (may be NULL) gets the number of records, also on an error.
 *
 * SINS_GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
 * sins_get_truth_summary() counts them.
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the records that the call would make; nothing is flown.
 * SINS_ERROR_BAD_STATE: navigating on increments. Any error of sins_push_sample() or sins_step() stops the run at the
 * sample that it concerns, which sins_last_error() names: the samples before it have been flown, this and the rest not;
 * sins_accuracy.intervals counts them. A sample that could be pushed but not flown waits in the queue, as after
 * sins_step(); sins_reposition() and sins_reset() empty it.
 */
SINS_API sins_status SINS_CALL sins_run(
    sins_sim *sim, const struct sins_flight_sample *samples, size_t count, size_t every, struct sins_record *records,
    size_t capacity, size_t *written);

/*
 * Reads the truth at the end of the last interval; before the first step, that of the first sample. Where samples have no
 * velocity, that of the first is 0 until the second is pushed.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_BAD_STATE: navigating on increments, there is no truth.
 */
SINS_API sins_status SINS_CALL sins_get_truth(sins_sim *sim, struct sins_navigation *truth);

/*
 * Reads the navigated solution for the same instant as sins_get_truth().
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: before the first step, no INS can start at the
 * first sample with these options and initial errors.
 */
SINS_API sins_status SINS_CALL sins_get_navigation(sins_sim *sim, struct sins_navigation *navigation);

/*
 * Reads ideal and measured signals of the last interval.
 *
 * SINS_NEED_SAMPLE: no interval yet.
 */
SINS_API sins_status SINS_CALL sins_get_imu(sins_sim *sim, struct sins_imu *imu);

/*
 * Reads the errors of the navigated solution; source is of enum sins_errors_source.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while
 * the error model is off, as it is by default (create the simulator with sins_options.error_model), or navigating on
 * increments. SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_get_errors(sins_sim *sim, int32_t source, struct sins_errors *errors);

/*
 * Reads the running accuracy figures.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_BAD_STATE: navigating on increments, there is no truth.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_get_accuracy(sins_sim *sim, struct sins_accuracy *accuracy);

/*
 * Reads the motion of the truth in figures; sins_reposition() and sins_move_truth() leave them.
 *
 * SINS_NEED_SAMPLE: no interval yet. SINS_ERROR_BAD_STATE: sins_options.truth_summary is off, or navigating on increments,
 * there is no truth.
 */
SINS_API sins_status SINS_CALL sins_get_truth_summary(sins_sim *sim, struct sins_truth_summary *summary);

/*
 * Reads truth, navigation and both errors of this moment at once; before the first step, of the first sample.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_BAD_STATE: navigating on increments, there is no truth.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_get_record(sins_sim *sim, struct sins_record *record);

/*
 * Starts the simulator as a navigator alone, at time, place, velocity and attitude (quaternion_nb; the angles are not
 * read) of navigation, on increments that sins_push_imu() gives. Ranges are those of a flight sample, the norm of the quaternion
 * is 1 within 1e-3; initial errors that are set do not apply. There is no truth then: the vertical channel is free and
 * flagged so, errors and accuracy are SINS_ERROR_BAD_STATE until sins_reset().
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: samples were pushed, or it was
 * started already; sins_reset() first; or temperature coefficients are set, for which increments have no temperature.
 * SINS_ERROR_SINGULAR: within reach of a pole, in geographic axes.
 */
SINS_API sins_status SINS_CALL sins_start_navigation(sins_sim *sim, const struct sins_navigation *navigation);

/*
 * Navigates over one interval on the host's increments; sensor errors that are set are added to them. The time goes on by
 * interval_s; sins_get_imu() tells the host's increments as the ideal ones.
 * sins_options.subsamples and updates_per_sample do not apply: the parts of the increment are the subsamples of one update.
 *
 * SINS_ERROR_BAD_STATE: sins_start_navigation() first. SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or half a
 * turn in a part or in the interval. SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_step(); the interval is not flown, the
 * solution before it stays readable, and sins_reset() and sins_start_navigation() start anew.
 */
SINS_API sins_status SINS_CALL sins_push_imu(sins_sim *sim, const struct sins_imu_increment *increment);

/*
 * The size that a snapshot has now, while each sample is flown as it comes: 1.3 to 2.1 KiB without sensor errors, up to 4.5 KiB
 * with every error of gyros, accelerometers and altimeter, up to 5.25 KiB with mounting, gravity, temperature and failures
 * besides; up to 154 bytes more for each sample that waits. It changes with what is set and with the samples that wait.
 */
SINS_API sins_status SINS_CALL sins_snapshot_size(sins_sim *sim, size_t *size);

/*
 * Saves the whole simulator, at any moment: options, parameters, samples that wait, the state of every block, each random
 * stream where it is. written (may be NULL) gets the size. The bytes mean the same on every platform and hold no address:
 * keep them in a file, send them to another machine. The same state gives the same bytes. No allocation, no system call.
 *
 * Not saved: handles, and the sentence of sins_last_error(). After SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR it is the last
 * good solution that is saved, after SINS_ERROR_INTERNAL nothing: load an earlier snapshot into a fresh handle.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see sins_snapshot_size(); buffer and written are as they were.
 */
SINS_API sins_status SINS_CALL sins_snapshot_save(sins_sim *sim, void *buffer, size_t capacity, size_t *written);

/*
 * Makes the simulator the one that was saved, whatever it was before: its options too, as sins_get_options() tells, so that a
 * fresh handle of sins_create(NULL, ...) will do. From there the run goes on to the same bits as the saved one did. size is
 * what sins_snapshot_save() wrote. Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are no snapshot, cut off, altered, or of a newer release; nothing has changed, and
 * sins_last_error() tells which it is. Later releases read the snapshots of earlier ones; the run goes on to the same bits
 * where CHANGELOG does not say that the algorithms changed. SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
 */
SINS_API sins_status SINS_CALL sins_snapshot_load(sins_sim *sim, const void *snapshot, size_t size);

/*
 * Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator that was set up (options, sensors,
 * initial errors, mounting, gravity, failures) and has taken no sample; it is copied and stays as it is. Run k is, bit for bit, the
 * simulator that was set up likewise with sins_options.run = first_run + k. sins_options.run and truth_summary of configured have
 * no effect.
 *
 * What a run does never depends on the other runs: ensembles over disjoint runs may be flown by different threads, processes
 * and machines, and their statistics merged. The library starts no thread.
 *
 * Each run takes some 40 KB of memory. Not for a real-time frame: it allocates.
 *
 * On an error *ensemble is untouched, and sins_last_error(NULL, ...) on this thread tells why. SINS_ERROR_BAD_STATE: configured has
 * taken a sample since it was created or reset, or navigates on increments. SINS_ERROR_INVALID_ARGUMENT: runs not from 1 to
 * 4294967295, or first_run + runs - 1 beyond 2^64 - 1. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 ensembles live.
 */
SINS_API sins_status SINS_CALL sins_ensemble_create(
    const sins_sim *configured, uint64_t first_run, size_t runs, sins_ensemble **ensemble);

/*
 * Destroys an ensemble. A call on it in another thread is waited for; the handle is never used again.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_ensemble_destroy(sins_ensemble *ensemble);

/*
 * Takes one flight-control sample into the queue (16 samples) of all runs.
 *
 * SINS_GAP and the errors: as sins_push_sample().
 */
SINS_API sins_status SINS_CALL sins_ensemble_push_sample(
    sins_ensemble *ensemble, const struct sins_flight_sample *sample);

/*
 * Flies one sample interval with all runs that have not diverged. No allocation, no system call.
 *
 * A run that cannot make the step, for which sins_step() would answer SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR, has diverged:
 * it keeps its solution before the step, takes no further part, and is reported by sins_ensemble_get_diverged() and counted by
 * sins_ensemble_get_statistics(). The others go on, and so does the truth, even if no run is left. sins_ensemble_reposition() and
 * sins_ensemble_reset() start all runs again.
 *
 * SINS_NEED_SAMPLE: no complete interval waits. SINS_ERROR_SINGULAR: the truth is within reach of a pole, in geographic axes or
 * where the alignment is a gyrocompass; the step is not made.
 */
SINS_API sins_status SINS_CALL sins_ensemble_step(sins_ensemble *ensemble);

/*
 * Pushes and steps count samples. Any split of a flight into calls gives the same bits as pushing and stepping sample by sample.
 * samples[0].struct_size tells how far apart the samples are; the others' may be 0.
 *
 * SINS_GAP: all samples were flown, and at least one of them ended a gap. Any error of sins_ensemble_push_sample() or
 * sins_ensemble_step() stops the run at the sample that it concerns, which sins_last_error() names: the samples before it have been
 * flown, this and the rest not. A sample that could be pushed but not flown waits in the queue.
 */
SINS_API sins_status SINS_CALL sins_ensemble_run(
    sins_ensemble *ensemble, const struct sins_flight_sample *samples, size_t count);

/*
 * Truth jumps to the sample, and every run starts again there with its initial errors, the diverged ones too: as
 * sins_reposition().
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
 */
SINS_API sins_status SINS_CALL sins_ensemble_reposition(
    sins_ensemble *ensemble, const struct sins_flight_sample *sample);

/* Back to before the first sample: same parameters, no failures, the same draws again from their start, no run diverged. */
SINS_API sins_status SINS_CALL sins_ensemble_reset(sins_ensemble *ensemble);

/*
 * Lets one output of every run fail, or clears its failure: as sins_set_failure().
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_set_failure().
 */
SINS_API sins_status SINS_CALL sins_ensemble_set_failure(
    sins_ensemble *ensemble, int32_t sensor, int32_t axis, const struct sins_failure *failure);

/* Reads the numbers of the first run and of the runs; either may be NULL. */
SINS_API sins_status SINS_CALL sins_ensemble_get_runs(sins_ensemble *ensemble, uint64_t *first_run, size_t *runs);

/*
 * Reads the truth, which all runs share: as sins_get_truth().
 *
 * SINS_NEED_SAMPLE: no sample yet.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_truth(sins_ensemble *ensemble, struct sins_navigation *truth);

/*
 * Reads the navigated solution of a run, first_run to first_run + runs - 1: as sins_get_navigation().
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged, and the
 * sentence has the time of its last good solution; or as sins_get_navigation(). SINS_ERROR_SINGULAR: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_navigation(
    sins_ensemble *ensemble, uint64_t run, struct sins_navigation *navigation);

/*
 * Reads the errors of the navigated solution of a run: as sins_get_errors(); source is of enum sins_errors_source.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run or source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL
 * while the error model is off. SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_ensemble_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_errors(
    sins_ensemble *ensemble, uint64_t run, int32_t source, struct sins_errors *errors);

/*
 * Reads ideal and measured signals of the last interval of a run: as sins_get_imu().
 *
 * SINS_NEED_SAMPLE: no interval yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_imu(sins_ensemble *ensemble, uint64_t run, struct sins_imu *imu);

/*
 * Reads the number of a run that has diverged: index 0 is the lowest of them, and so on. sins_statistics.diverged counts them.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no more than index runs have diverged.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_diverged(sins_ensemble *ensemble, size_t index, uint64_t *run);

/*
 * Reads the statistics of the errors of all runs at this moment; source is of enum sins_errors_source. sins_statistics_merge() adds
 * those of other runs at the same moment. Within 20 km of the Earth's axis (SINS_NAVIGATION_NEAR_POLE of the truth) velocity and
 * misalignment have no meaning. No allocation, no system call.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while
 * the error model is off. SINS_ERROR_SINGULAR: before the first step, no run can start at the first sample.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_statistics(
    sins_ensemble *ensemble, int32_t source, struct sins_statistics *statistics);

/*
 * Adds the runs of other to those of into; no run may be in both. Exactly associative and commutative: any order and any grouping
 * gives the same bits, so that work may be split over threads, processes, machines and restarts in any way. into may be all zero
 * but for struct_size: no run.
 *
 * SINS_ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or there would be more than 4294967295 runs; into
 * is as it was.
 */
SINS_API sins_status SINS_CALL sins_statistics_merge(
    struct sins_statistics *into, const struct sins_statistics *other);

/*
 * Computes means, covariances, root mean squares and radii from statistics.
 *
 * SINS_ERROR_INVALID_ARGUMENT: they are damaged or of another release.
 */
SINS_API sins_status SINS_CALL sins_statistics_figures(
    const struct sins_statistics *statistics, struct sins_figures *figures);

/* The size that a snapshot has now: some 1.3 to 5.25 KiB a run, as that of a simulator. */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_size(sins_ensemble *ensemble, size_t *size);

/*
 * Saves the whole ensemble, at any moment: as sins_snapshot_save(). written (may be NULL) gets the size. The same state gives the
 * same bytes. No allocation, no system call.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see sins_ensemble_snapshot_size(); buffer and written are as they were.
 */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_save(
    sins_ensemble *ensemble, void *buffer, size_t capacity, size_t *written);

/*
 * Makes the ensemble the one that was saved, whatever it was before: its runs and options too, so that one of any simulator and one
 * run will do. From there it goes on to the same bits as the saved one did. size is what sins_ensemble_snapshot_save() wrote. Not for
 * a real-time frame: it allocates.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are no snapshot of an ensemble, cut off, altered, or of a newer release; nothing has changed, and
 * sins_last_error(NULL, ...) reports which it is. SINS_ERROR_OUT_OF_MEMORY: no memory for a second ensemble.
 */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_load(
    sins_ensemble *ensemble, const void *snapshot, size_t size);

/*
 * Fills params with the gyro errors of a grade, of enum sins_grade. Biases, scale factor errors and misalignments are drawn at turn-on
 * with the standard deviations that the source states; what it does not state is 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such grade.
 */
SINS_API sins_status SINS_CALL sins_gyro_preset(int32_t grade, struct sins_gyro_params *params);

/*
 * Fills params with the accelerometer errors of a grade, as sins_gyro_preset().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such grade.
 */
SINS_API sins_status SINS_CALL sins_accel_preset(int32_t grade, struct sins_accel_params *params);

/*
 * Creates a flight of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time, smooth
 * to the third derivative; position is their integral to rounding. manoeuvres[0].struct_size tells how far apart they are.
 *
 * Not for a real-time frame: it allocates, and integrates the path in pieces, some 20 us and 0.5 KB each. A piece is up to 600 s
 * of straight flight, or about a period of a fast sinusoid of course, climb or speed; roll, pitch and heading need none.
 *
 * On an error *flight is untouched, and sins_last_error(NULL, ...) on this thread tells why: SINS_ERROR_INVALID_ARGUMENT a
 * value out of its range, or a height on the way out of the range of sins_flight_sample.height_m, which no simulator takes (the
 * index in the sentence is that of the manoeuvre), SINS_ERROR_OUT_OF_MEMORY no memory, more than
 * 200000 pieces (which take 3 s), or 4096 flights that live.
 */
SINS_API sins_status SINS_CALL sins_flight_create(
    const struct sins_flight_start *start, const struct sins_manoeuvre *manoeuvres, size_t count,
    sins_flight **flight);

/* Length of the flight [s]. */
SINS_API sins_status SINS_CALL sins_flight_duration(const sins_flight *flight, double *duration_s);

/*
 * The sample at time_s, 0 to the duration [s]: exact at any time, in any order. No allocation; 0.5 to 2 us.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a time before the start or after the end.
 */
SINS_API sins_status SINS_CALL sins_flight_sample_at(
    const sins_flight *flight, double time_s, struct sins_flight_sample *sample);

/*
 * Destroys a flight.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_flight_destroy(sins_flight *flight);

/*
 * Creates the default scene: the recommended simulator with ideal sensors, at rest for an hour at latitude 0, longitude 0,
 * height 0, sampled at 100 Hz.
 *
 * On an error *scene is untouched, and sins_last_error(NULL, ...) on this thread tells why, as for every function of scenes.
 * SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes live. Functions of scenes allocate: none but sins_scene_prepare() is for
 * a real-time frame. They ask for all the memory of a call first; where it runs out within the call, as another thread takes
 * it, the process ends. So it is of sins_log_parse(), but for the samples.
 */
SINS_API sins_status SINS_CALL sins_scene_create(sins_scene **scene);

/*
 * Creates the scene of a text: TOML in UTF-8, of at most 1 MiB. The bytes are not kept. sins_scene_write_keys() lists the keys.
 *
 * SINS_SCENE_HAS_FAULTS: the text is no scene; sins_scene_get_fault() tells every fault and its place. The handle is made for
 * that alone: any other function but sins_scene_destroy() answers SINS_ERROR_BAD_STATE. SINS_ERROR_OUT_OF_MEMORY: as
 * sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_parse(const char *text, size_t size, sins_scene **scene);

/*
 * Fault `index` of the scene's text, from 0 in the order of the text; fault->count tells how many there are.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such fault; the scene has none, or fewer.
 */
SINS_API sins_status SINS_CALL sins_scene_get_fault(const sins_scene *scene, size_t index, struct sins_fault *fault);

/*
 * Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
 * "over_the_pole", "coning", "commuter".
 *
 * SINS_ERROR_INVALID_ARGUMENT: no scene has that name. SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_builtin(const char *name, sins_scene **scene);

/*
 * The name of built-in scene `index`, from 0. buffer, capacity and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: there are no more.
 */
SINS_API sins_status SINS_CALL sins_scene_builtin_name(size_t index, char *buffer, size_t capacity, size_t *needed);

/*
 * Writes the scene as commented TOML, which sins_scene_parse() reads back to the same scene, to the bit.
 *
 * needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for that alone.
 * SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_INVALID_ARGUMENT: settings that do not go together, or so many
 * manoeuvres and failures that the text would have more than 1 MiB. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_write(
    const sins_scene *scene, char *buffer, size_t capacity, size_t *needed);

/*
 * Writes every section and key of a scene with what it takes, its unit and its meaning, a line each. buffer, capacity and
 * needed as in sins_scene_write().
 */
SINS_API sins_status SINS_CALL sins_scene_write_keys(char *buffer, size_t capacity, size_t *needed);

/*
 * Creates the simulator of the scene, ready for the first sample: options, sensors, start, mounting, gravity. Failures come in
 * their time by sins_scene_prepare(). Of a flight that is not a log the sample period is stated: 1 / rate.
 *
 * SINS_ERROR_INVALID_ARGUMENT: settings that do not go together. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 * SINS_ERROR_OUT_OF_MEMORY: as sins_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_simulator(const sins_scene *scene, sins_sim **sim);

/*
 * Creates the flight of the scene, composed of manoeuvres or built-in, on the scene's ellipsoid. A host samples it at k / rate
 * up to sins_scene_setup.flown_s.
 *
 * SINS_ERROR_BAD_STATE: the flight of the scene is a log, whose name is SINS_SCENE_TEXT_LOG; or as sins_scene_parse(). Else as
 * sins_flight_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_flight(const sins_scene *scene, sins_flight **flight);

/*
 * Destroys a scene. Simulators and flights that were made of it live on.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_scene_destroy(sins_scene *scene);

/*
 * Makes ready for the next interval what the scene plans over time: call it before each sample is pushed, and step before the
 * next sample. The sample gets the scene's temperature, if it plans one. Failures of the scene begin and end on sim with the first
 * interval that starts at their time or later; failures of outputs for which it plans none are left alone.
 * flight_start_s is the time stamp of the flight's first sample. No allocation, no system call.
 *
 * SINS_ERROR_BAD_HANDLE: of scene or sim. SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s not
 * from -2e10 to 2e10. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_prepare(
    const sins_scene *scene, sins_sim *sim, double flight_start_s, struct sins_flight_sample *sample);

/*
 * The same for all runs of an ensemble: as sins_scene_prepare().
 *
 * SINS_ERROR_BAD_HANDLE: of scene or ensemble. The other errors: as sins_scene_prepare().
 */
SINS_API sins_status SINS_CALL sins_scene_prepare_ensemble(
    const sins_scene *scene, sins_ensemble *ensemble, double flight_start_s, struct sins_flight_sample *sample);

/*
 * Reads the options of the scene.
 *
 * SINS_ERROR_BAD_STATE: as sins_scene_parse(), as for all functions that read or set a part of a scene.
 */
SINS_API sins_status SINS_CALL sins_scene_get_options(const sins_scene *scene, struct sins_options *options);

/*
 * Sets the options of the scene. On an error, as for every part, the scene is as it was. Parts can be set in any order:
 * whether they go together is checked where the scene is written and its simulator is created.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_create().
 */
SINS_API sins_status SINS_CALL sins_scene_set_options(sins_scene *scene, const struct sins_options *options);

/* Reads the gyro errors of the scene. */
SINS_API sins_status SINS_CALL sins_scene_get_gyro(const sins_scene *scene, struct sins_gyro_params *params);

/*
 * Sets the gyro errors of the scene.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_gyro(sins_scene *scene, const struct sins_gyro_params *params);

/* Reads the accelerometer errors of the scene. */
SINS_API sins_status SINS_CALL sins_scene_get_accel(const sins_scene *scene, struct sins_accel_params *params);

/*
 * Sets the accelerometer errors of the scene.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_accel(sins_scene *scene, const struct sins_accel_params *params);

/* Reads the errors of the scene's altimeter. */
SINS_API sins_status SINS_CALL sins_scene_get_altimeter(
    const sins_scene *scene, struct sins_altimeter_params *params);

/*
 * Sets the errors of the scene's altimeter.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_altimeter(
    sins_scene *scene, const struct sins_altimeter_params *params);

/* Reads the errors with which the navigation of the scene starts. */
SINS_API sins_status SINS_CALL sins_scene_get_initial_errors(
    const sins_scene *scene, struct sins_initial_errors *errors);

/*
 * Sets the errors with which the navigation of the scene starts.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_initial_errors(
    sins_scene *scene, const struct sins_initial_errors *errors);

/* Reads where the sensor block of the scene sits. */
SINS_API sins_status SINS_CALL sins_scene_get_mounting(const sins_scene *scene, struct sins_mounting *mounting);

/*
 * Sets where the sensor block of the scene sits.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_mounting(sins_scene *scene, const struct sins_mounting *mounting);

/* Reads true gravity less normal gravity of the scene. */
SINS_API sins_status SINS_CALL sins_scene_get_gravity_disturbance(
    const sins_scene *scene, struct sins_gravity_params *params);

/*
 * Sets true gravity less normal gravity of the scene.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_gravity_disturbance(
    sins_scene *scene, const struct sins_gravity_params *params);

/* Reads what a scene says of its flight and of its output. */
SINS_API sins_status SINS_CALL sins_scene_get_setup(const sins_scene *scene, struct sins_scene_setup *setup);

/*
 * Sets what a scene says of its flight and of its output; flight and flown_s are passed over.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_scene_set_setup(sins_scene *scene, const struct sins_scene_setup *setup);

/*
 * Reads the flight of the scene, composed of manoeuvres or built-in: start, manoeuvres, how many there are, and how many times
 * all of them are flown. manoeuvres[0].struct_size tells how far apart they are; start and repeat may be NULL, and to ask for
 * count alone manoeuvres with a capacity of 0.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the manoeuvres; count alone was written. SINS_ERROR_BAD_STATE: the flight
 * is a log; or as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_get_manoeuvres(
    const sins_scene *scene, struct sins_flight_start *start, struct sins_manoeuvre *manoeuvres, size_t capacity,
    size_t *count, size_t *repeat);

/*
 * Makes the flight of the scene one of count manoeuvres, all of them flown repeat times, 4096 together at the most. start->earth
 * is passed over: the ellipsoid is that of the scene's options. A flight that was a log is sampled at 100 Hz from then on.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_flight_create(), but for the height on the way.
 */
SINS_API sins_status SINS_CALL sins_scene_set_manoeuvres(
    sins_scene *scene, const struct sins_flight_start *start, const struct sins_manoeuvre *manoeuvres, size_t count,
    size_t repeat);

/*
 * Reads a text of the scene, which of enum sins_scene_text; an empty one is none. buffer, capacity and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such text.
 */
SINS_API sins_status SINS_CALL sins_scene_get_text(
    const sins_scene *scene, int32_t which, char *buffer, size_t capacity, size_t *needed);

/*
 * Sets a text of the scene, which of enum sins_scene_text: UTF-8, terminated, at most 4096 bytes. An empty one is none; the flight of a scene is never none.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
 */
SINS_API sins_status SINS_CALL sins_scene_set_text(sins_scene *scene, int32_t which, const char *text);

/* How many failures the scene plans. */
SINS_API sins_status SINS_CALL sins_scene_get_failure_count(const sins_scene *scene, size_t *count);

/*
 * Planned failure `index`, from 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such failure.
 */
SINS_API sins_status SINS_CALL sins_scene_get_failure(
    const sins_scene *scene, size_t index, struct sins_planned_failure *failure);

/*
 * Plans one failure more.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a failure of the same output at the same time.
 */
SINS_API sins_status SINS_CALL sins_scene_add_failure(sins_scene *scene, const struct sins_planned_failure *failure);

/* Plans no failure any more. */
SINS_API sins_status SINS_CALL sins_scene_clear_failures(sins_scene *scene);

/*
 * Reads a flight log, comma-separated values in UTF-8. The first line that is not a comment (#) names the columns, in any
 * order; columns of other names are passed over, and a row with more fields than columns is a fault:
 *
 * time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg,
 * heading_rad or _deg; if known velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s,
 * rate_z_rad_s; force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c
 *
 * Frames and signs are those of sins_flight_sample. A log has at least two samples, each later than the one before; their
 * ranges are checked where they are pushed. The bytes are not kept. Not for a real-time frame: it allocates, 184 bytes a sample.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the text is no flight log; fault (may be NULL) tells the first fault and its place, and
 * *log is untouched. SINS_ERROR_OUT_OF_MEMORY: no memory for the samples, or 4096 logs that live.
 */
SINS_API sins_status SINS_CALL sins_log_parse(
    const char *text, size_t size, sins_log **log, struct sins_fault *fault);

/* Tells how many samples a log has, how long it is, and its title. */
SINS_API sins_status SINS_CALL sins_log_get_info(const sins_log *log, struct sins_log_info *info);

/*
 * The sample `index`, from 0 in the order of the log, ready for sins_push_sample(). line (may be NULL) gets the line of the text
 * on which it stands, from 1. No allocation.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such sample.
 */
SINS_API sins_status SINS_CALL sins_log_get_sample(
    const sins_log *log, size_t index, struct sins_flight_sample *sample, uint64_t *line);

/*
 * Destroys a flight log.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_log_destroy(sins_log *log);

/*
 * Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples; all that
 * are cheaper do not meet it. samples[0].struct_size tells how far apart the samples are.
 *
 * configured is a simulator as the host flies it, at any moment of its life: its options and its mounting count. It is read at
 * the start of the call and neither stepped nor changed. NULL is the recommended simulator with its sensor block at the
 * reference point. options gets the options of configured with scheme, subsamples and updates_per_sample of the answer, ready
 * for sins_create(); what these three were does not matter.
 *
 * Each algorithm flies the piece with ideal sensors in the same mounting, and its solution is compared at every sample with that
 * of a reference, 16 updates of 5 subsamples, whose own uncertainty (what half as many updates change) is added. The error is
 * that of the algorithm alone: errors of sensors, altimeter, start, gravity and of the believed mounting move both solutions
 * alike and are left out, and so is what the host's samples contradict themselves by. SINS_SIGNAL_CLOSED_LOOP would hide the
 * error: the signals are without it. For a duration beyond the piece its errors go on as steady rates, through Schuler's
 * pendulum: more than the flight will show as long as it goes on like the piece. With SINS_VERTICAL_FREE each error counts as
 * one of height, which grows by e every 569 s.
 *
 * The order of cost is instructions_per_step, so that the same samples have the same answer on every machine and every day;
 * ns_per_step alone differs. Not for a real-time frame: it allocates, and takes some 25 to 70 us a sample, up to 0.4 ms where
 * nothing meets the requirement.
 *
 * SINS_REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the one that comes closest.
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as
 * sins_push_sample(). SINS_ERROR_SINGULAR: geographic axes within reach of a pole. SINS_ERROR_DIVERGED: the solution of every
 * algorithm left its range. SINS_ERROR_OUT_OF_MEMORY. sins_last_error(NULL, ...) on this thread tells why, and at which sample.
 */
SINS_API sins_status SINS_CALL sins_recommend(
    const sins_sim *configured, const struct sins_flight_sample *samples, size_t count,
    const struct sins_requirement *requirement, struct sins_options *options, struct sins_cost *cost);

/*
 * Tells what each effect contributes to the errors of a scene of 2 to 1e9 samples: which ones matter, and which can be left
 * out. samples[0].struct_size tells how far apart the samples are, rows[0].struct_size the rows; the others' may be 0, those
 * of the rows anything.
 *
 * configured is a simulator as the host flies it, at any moment of its life: its options and all that errs in it, of the gyros, the
 * accelerometers, the altimeter, the start, the mounting and gravity; failures do not count. It is read at the start of the call
 * and neither stepped nor changed. NULL is the recommended simulator, in which nothing errs. NULL for request is 16 runs and no
 * limits; written and budget may be NULL.
 *
 * An effect is what one field sets; it is active, and has a row, if that is not 0. (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS is
 * none: each effect brings the misalignment along that it causes; nor are lever_arm_m and boresight_rad of the mounting: all
 * runs fly with them.) Its contribution is the error, navigation less truth, of a run with this effect alone less that of a
 * run with nothing set: the length of the vector in position, in velocity and in misalignment, the largest of up to 1000
 * instants, equally spaced, and that of the last sample. Of an effect that is drawn it is the root mean square over the runs
 * sins_options.run, run + 1 and so on (SINS_BUDGET_RANDOM).
 *
 * rows[0] is the mechanization's own error, with what the samples contradict themselves by. The effects follow, the largest
 * position first, then velocity, then misalignment; with limits the largest share of a limit first. What is not the sum of
 * the rows is in the remainder, draw by draw: effects that act on each other, of second order in their sizes.
 *
 * With limits the effects are marked that can be left out together (SINS_BUDGET_CAN_BE_LEFT_OUT): from the smallest share on
 * while the sum of the deterministic contributions, and the root of the sum of squares of the random ones times sigma_high,
 * are together, root of the sum of squares, within each limit. Then all is flown again without them, in every run; while
 * what that changes, left_out, is beyond a limit, the largest of them comes back.
 *
 * But for the ns_per_step the same samples have the same answer on every machine. Not for a real-time frame: it allocates,
 * and flies 1 + each deterministic effect + runs times each random effect and all together, with limits again runs times
 * and more where effects do not add up; each flight takes 0.6 to 1.5 us a sample.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the rows; written gets how many there are, nothing is flown (rows
 * may be NULL with a capacity of 0, to ask). SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_TIME_ORDER,
 * SINS_ERROR_DISCONTINUITY: as sins_push_sample(). SINS_ERROR_SINGULAR: geographic axes, or gyrocompassing, within reach of a
 * pole. SINS_ERROR_DIVERGED: a solution left its range. SINS_ERROR_OUT_OF_MEMORY. sins_last_error(NULL, ...) on this thread
 * tells why, and at which sample.
 */
SINS_API sins_status SINS_CALL sins_error_budget(
    const sins_sim *configured, const struct sins_flight_sample *samples, size_t count,
    const struct sins_budget_request *request, struct sins_budget_row *rows, size_t capacity, size_t *written,
    struct sins_budget *budget);

#ifdef __cplusplus
}
#endif

#endif /* SINS_H */
