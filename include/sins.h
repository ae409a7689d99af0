/*
 * sins.h - strapdown inertial navigation system (SINS) simulator, C interface.
 *
 * A flight simulator gives the library the true position, velocity and attitude as samples. The library computes what perfect
 * gyros and accelerometers would measure, adds the sensor errors that are set, navigates on the result, and reports the errors
 * of that navigation. One object, nine functions. They are all in this program, which prints "-145 m east"; the
 * examples in the comments of the functions continue it:
 *
 *     #include <stdio.h>
 *     #include "sins.h"
 *
 *     int main(void)
 *     {
 *         sins_sim *sim = NULL;
 *         sins_gyro_params gyro;
 *         sins_accel_params accel;
 *         sins_flight_sample sample;
 *         sins_navigation navigation;
 *         sins_errors errors;
 *         char reason[256] = "";
 *
 *         SINS_INIT(gyro); SINS_INIT(accel); SINS_INIT(sample); SINS_INIT(navigation); SINS_INIT(errors);
 *         gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR;
 *         sample.latitude_rad = 39.9 * SINS_DEG;
 *         sins_create(NULL, &sim);
 *         sins_set_gyro(sim, &gyro);
 *         sins_set_accel(sim, &accel);
 *         for (; sample.time_s <= 3600.0; sample.time_s += 1.0)
 *             if (sins_push_sample(sim, &sample) < 0 || sins_step(sim) < 0)
 *                 break;
 *         sins_get_navigation(sim, &navigation);
 *         if (sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) < 0)
 *             sins_last_error(sim, reason, sizeof reason, NULL);
 *         printf("%.0f m east%s\n", errors.position_enu_m[0], reason);
 *         return sins_destroy(sim);
 *     }
 *
 * Structs: SINS_INIT first. A parameter of 0 is off, or has the default that its comment gives, such as "0: 2.5 s". (In a flight
 *   sample 0 is a value.) Units are SI and radians, as the name of each field says; macros convert from data sheets.
 * Constants are enumerations. Fields and arguments hold them as 32-bit integers, whose size does not depend on the compiler.
 * Frames. Navigation axes are east-north-up. Roll is positive right wing down, pitch nose up, heading clockwise from true
 *   north; the rotation sequence is heading, pitch, roll (aerospace). Body axes are right-forward-up, or forward-right-down by
 *   sins_options.axes. Sensor axes are the axes of the sensor block: the body axes, unless sins_mounting sets a boresight.
 *   Latitude is geodetic, height is above the ellipsoid.
 * Errors: a status below 0. The call has then changed nothing; the exceptions are under "Statuses".
 * Threads. Any function may be called from any thread. Calls on one handle wait for each other. A call takes less than 48 KB of
 *   stack, sins_identify_solve() and sins_identify_check() less than 256 KB. docs/threads.md: nested calls, signal handlers,
 *   cancellation, abandoned calls, fork().
 * Unloading. Destroy every handle first, and let every call return. docs/threads.md: what a DLL leaves behind.
 * Real time. Push, step, reads and setters make no allocation and no system call. docs/threads.md has the list.
 * Host time. The time comes from the samples. docs/host_time.md: pauses, slews, gaps, faster than real time.
 * Same bits. The same options, seed, samples and settings give the same outputs bit for bit on every platform, however the
 *   samples are split into calls (times excepted, as ns_per_step of sins_cost). Each random effect has its own stream.
 *
 * Beside it: sins_flight.h, embedded flights, and a judge of samples; sins_analysis.h, which options a flight needs, which effects
 * matter, and which errors real sensors have; sins_unit.h, the unit with its modes; sins_ensemble.h, ensembles of runs; sins_scene.h,
 * scenes and flight logs; sins.hpp and its kin, classes for C++; sins_functions.h, a table of all functions for hosts that look them up.
 * build/ writes the *.h files; do not edit them.
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

/** Sets a struct to zero, and struct_size to its size: all effects are off, all options have their defaults. */
#define SINS_INIT(object) (memset(&(object), 0, sizeof(object)), (void)((object).struct_size = sizeof(object)))

/* Units: multiply by them to convert to SI, divide to convert back. */
#define SINS_DEG 0.017453292519943295              /* degree [rad] */
#define SINS_ARCMIN (SINS_DEG / 60.0)              /* minute of arc [rad] */
#define SINS_ARCSEC (SINS_DEG / 3600.0)            /* second of arc [rad] */
#define SINS_DEG_PER_HOUR (SINS_DEG / 3600.0)      /* degree per hour [rad/s] */
#define SINS_DEG_PER_SQRT_HOUR (SINS_DEG / 60.0)   /* degree per root hour, angle random walk [rad/sqrt(s)] */
#define SINS_STANDARD_GRAVITY 9.80665              /* g [m/s2] */
#define SINS_MICRO_G (SINS_STANDARD_GRAVITY * 1.0e-6)             /* millionth of g [m/s2] */
#define SINS_MICRO_G_PER_SQRT_HZ (SINS_STANDARD_GRAVITY * 1.0e-6) /* micro-g per root hertz, velocity random walk [(m/s)/sqrt(s)] */
#define SINS_PPM 1.0e-6                            /* part per million */
#define SINS_KNOT (1852.0 / 3600.0)                /* knot [m/s] */
#define SINS_NMI 1852.0                            /* nautical mile [m] */
#define SINS_NMI_PER_HOUR (1852.0 / 3600.0)        /* nautical mile per hour [m/s] */

#ifdef __cplusplus
extern "C" {
#endif

/* Version. */

/**
 * Version of the interface that this header declares: a host compares it with what sins_abi_version() gives. The number
 * changes if a part of the interface is removed or changes its meaning. Additions at the end do not change it.
 */
#define SINS_HEADER_ABI 1

/** Major number of this release of the library, by semantic versioning. */
#define SINS_VERSION_MAJOR 0

/** Minor number of this release. */
#define SINS_VERSION_MINOR 1

/** Patch number of this release. */
#define SINS_VERSION_PATCH 0

/** Returns the version of the interface of the loaded library: compare it with SINS_HEADER_ABI. */
SINS_API uint32_t SINS_CALL sins_abi_version(void);

/** Returns the release of the loaded library as text, such as "0.1.0". The text lives as long as the library is loaded. */
SINS_API const char *SINS_CALL sins_version_string(void);

/** A release as one number, for the preprocessor: `#if SINS_VERSION_NUM(0, 2, 0) <= SINS_VERSION`. Each part is below 1000. */
#define SINS_VERSION_NUM(major, minor, patch) (((major) * 1000 + (minor)) * 1000 + (patch))

/** This release as one number. */
#define SINS_VERSION SINS_VERSION_NUM(SINS_VERSION_MAJOR, SINS_VERSION_MINOR, SINS_VERSION_PATCH)

/*
 * Statuses. A function that can fail returns a sins_status, and gives data through pointers. A function that cannot fail
 * returns its value directly. Test for errors by status < 0. After an error nothing has changed: no state, no output, and no
 * random number was drawn. Exceptions: after SINS_ERROR_INTERNAL the handle cannot be used any more. sins_run() and
 * sins_ensemble_run() keep the intervals that they flew before the error; sins_run() also keeps their records, and sets
 * written. sins_identify_push_samples() and sins_identify_push_increments() keep what they took before the error. If a buffer is
 * too small, functions that write a text cut it and report the size that is needed; sins_error_budget() and
 * sins_scene_get_manoeuvres() report the number of elements that is needed. sins_log_parse(), sins_scene_set_values() and
 * sins_scene_set_items() report faults.
 *
 * A positive status is not an error. With SINS_NEED_SAMPLE the output is unchanged. With SINS_REQUIREMENT_NOT_MET the output is
 * written. With SINS_SCENE_HAS_FAULTS a handle was made. With SINS_GAP the call did everything.
 *
 * Every function with a pointer argument can return SINS_ERROR_NULL_POINTER, every function with a handle
 * SINS_ERROR_BAD_HANDLE, and every function with a struct SINS_ERROR_STRUCT_SIZE. Every function that returns a status can
 * return SINS_ERROR_INTERNAL. The other errors of a function are listed at the function. docs/threads.md describes further
 * causes of SINS_ERROR_BAD_STATE and SINS_ERROR_OUT_OF_MEMORY. sins_last_error() gives a sentence that names field, value and
 * limit, sins_last_error_info() the same as a struct, sins_status_string() the name of the status.
 */

/** Values of a sins_status: 0 is success, a negative status is an error, a positive status is neither. */
typedef enum sins_status_code {
    /** The call did what it says. */
    SINS_OK = 0,
    /** There is no sample yet, or no complete interval: push the next sample. */
    SINS_NEED_SAMPLE = 1,
    /** sins_recommend(): no options meet the requirement. The outputs hold the options that come closest. */
    SINS_REQUIREMENT_NOT_MET = 2,
    /** The text of a scene has faults. The handle was made, but only sins_scene_get_fault() and sins_scene_destroy() accept it. */
    SINS_SCENE_HAS_FAULTS = 3,
    /**
     * The sample was accepted, or all samples of the run were flown, but there is a gap: an interval of more than 2.5 times
     * each of the two before it. The library assumes that the vehicle moved during the gap: 213 m in 1 s at 213 m/s. If the
     * vehicle stood still while the host's clock ran on, this is wrong: see sins_move_time().
     */
    SINS_GAP = 4,
    /** sins_play_next(), sins_play_run(): the scene has no further sample. Nothing was flown, or all of it. */
    SINS_PLAY_END = 5,
    /** A pointer is null where null is not allowed. */
    SINS_ERROR_NULL_POINTER = -1,
    /** The handle is null, made up, destroyed, or of another kind. */
    SINS_ERROR_BAD_HANDLE = -2,
    /** A struct_size that no release knows, or a struct of a newer release that sets a field which this release lacks. */
    SINS_ERROR_STRUCT_SIZE = -3,
    /** A value out of its range; sins_last_error() names field, value and limit. */
    SINS_ERROR_INVALID_ARGUMENT = -4,
    /** A call at the wrong moment, a nested call, or a call on a handle that an abandoned call holds (see Threads). */
    SINS_ERROR_BAD_STATE = -5,
    /** A sample that is not later than the one before, or off the stated sample period. */
    SINS_ERROR_TIME_ORDER = -6,
    /**
     * The truth jumped: a gap of more than max_gap_s, a jump of position, velocity or attitude, or a turn of 170 degrees or more
     * between two samples. See sins_move_truth().
     */
    SINS_ERROR_DISCONTINUITY = -7,
    /** The queue of samples is full: step first. */
    SINS_ERROR_QUEUE_FULL = -8,
    /**
     * The solution diverged: it left its limits. The last good solution of a simulator stays readable; that of a run of an
     * ensemble does not.
     */
    SINS_ERROR_DIVERGED = -9,
    /** Too close to a pole: the mechanization in geographic axes, or within 64 km an alignment by gyrocompassing. */
    SINS_ERROR_SINGULAR = -10,
    /** A buffer is too small for the result. */
    SINS_ERROR_BUFFER_TOO_SMALL = -11,
    /** No memory, or no free handle; on Windows too few TLS indexes (see Unloading). */
    SINS_ERROR_OUT_OF_MEMORY = -12,
    /** The bytes are not a snapshot, or are one that is damaged or of a newer release. */
    SINS_ERROR_SNAPSHOT = -13,
    /**
     * A defect inside the library was caught. Each handle that the call could have changed returns this status from now on. Other handles
     * still work, also a simulator that the call only reads, such as the template of sins_ensemble_create().
     */
    SINS_ERROR_INTERNAL = -99
} sins_status_code;

/**
 * Result of a call: SINS_OK is 0, a negative status is an error, a positive status is neither. After an error nothing has
 * changed, with the exceptions under Statuses.
 */
typedef int32_t sins_status;

/**
 * Returns the name of a status code, such as "SINS_OK", or "unknown status" for any other number. The text lives as long
 * as the library is loaded.
 */
SINS_API const char *SINS_CALL sins_status_string(sins_status status);

/*
 * Structs. Every struct (except the parts of a sins_record) begins with struct_size, which the caller sets to the sizeof of the
 * struct, and a second 32-bit integer, which is 0 unless its comment says otherwise. So "sins_gyro_params gyro = { sizeof gyro
 * };" is an ideal gyro. SINS_INIT(gyro) sets the same content. The caller sets struct_size of output structs too. Structs grow
 * only at their end, so old hosts run on new libraries, and new hosts on old libraries. A newer host may pass a struct with
 * fields that an older library does not know. In an output struct the library leaves these fields unchanged. In an input
 * struct they must be 0, or the call returns SINS_ERROR_STRUCT_SIZE.
 *
 * Handles. A handle is a key, not an address, and every call checks it. A call with a handle that is null, made up, destroyed
 * or of another kind returns SINS_ERROR_BAD_HANDLE, unless the function says what null means. No key is ever used again.
 */

/* Samples, options, and the simulator. */

/** Flags of a sins_flight_sample. */
typedef enum sins_sample_flags {
    /** The sample carries angular_rate_rad_s. */
    SINS_SAMPLE_ANGULAR_RATE = 1,
    /** The sample carries specific_force_m_s2. */
    SINS_SAMPLE_SPECIFIC_FORCE = 2,
    /**
     * The sample has no velocity. The library derives it from positions. The noise of this velocity is 2 to 4 times the position
     * noise of a sample, divided by the interval.
     */
    SINS_SAMPLE_NO_VELOCITY = 4,
    /** The sample carries temperature_c. */
    SINS_SAMPLE_TEMPERATURE = 8
} sins_sample_flags;

/**
 * True motion of the vehicle at an instant, as a flight simulator gives it. The ideal signals are computed from velocity and
 * attitude, and from angular rate and specific force if the sample carries them. Position enters only through gravity and
 * curvature, unless the samples have no velocity: then the velocity is derived from the positions. Vibration above a tenth
 * of the sample rate cannot be recovered from samples; give angular rate and specific force if you have them.
 */
typedef struct sins_flight_sample {
    /** sizeof(sins_flight_sample) */
    uint32_t struct_size;
    /** Flags of enum sins_sample_flags, or'ed. */
    uint32_t flags;
    /**
     * Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins_options.max_gap_s. Large stamps are coarse
     * (1.2e-7 s at 1e9 s): state sins_options.sample_period_s with them.
     */
    double time_s;
    /** Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /** Longitude, east positive, -100 to 100 [rad]; whole turns do not matter. */
    double longitude_rad;
    /** Height above the ellipsoid, -2e4 to 2e6 [m]. */
    double height_m;
    /** Velocity against the Earth, east-north-up, each -2e4 to 2e4 [m/s]. */
    double velocity_enu_m_s[3];
    /**
     * Roll, right wing down positive, -1e4 to 1e4 [rad]; whole turns do not matter. So angles in degrees are accepted, too:
     * sins_truth_summary reveals them.
     */
    double roll_rad;
    /**
     * Pitch, nose up positive, -1e4 to 1e4 [rad]; it may go beyond 90 degrees. From one sample to the next the attitude must
     * turn by less than 170 degrees. The library predicts this turn from the angular rates of the samples, or, without
     * rates, from the previous interval. The turn must differ from the prediction by less than 180 degrees. Additional whole
     * turns between two samples cannot be detected.
     */
    double pitch_rad;
    /** Heading, clockwise from true north, -1e4 to 1e4 [rad], not degrees (see roll_rad); whole turns do not matter. */
    double heading_rad;
    /**
     * With SINS_SAMPLE_ANGULAR_RATE: angular rate of the vehicle against inertial space along the body axes at this instant,
     * each -1000 to 1000 [rad/s].
     */
    double angular_rate_rad_s[3];
    /**
     * With SINS_SAMPLE_SPECIFIC_FORCE: specific force at the reference point along the body axes at this instant, each -1e5
     * to 1e5 [m/s2].
     */
    double specific_force_m_s2[3];
    /**
     * With SINS_SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant, -273.15 to 1000 [deg C]; linear
     * from one sample to the next. Needed while temperature coefficients are set: the push of a sample without it then returns
     * SINS_ERROR_INVALID_ARGUMENT, because a forgotten flag would silently disable the effect.
     */
    double temperature_c;
} sins_flight_sample;

/** Axes in which the mechanization integrates. */
typedef enum sins_frame {
    /** Navigation in Earth-fixed axes: regular everywhere, poles included. */
    SINS_FRAME_EARTH_FIXED = 0,
    /**
     * Navigation in east-north-up, as in the paper. The mechanization returns SINS_ERROR_SINGULAR within 6.4 km of a pole. It
     * also returns this error if the vehicle moves in one update by more than 1 % of its distance to the pole. For example, at
     * 250 m/s with updates of 1 s this is within 25 km.
     */
    SINS_FRAME_GEOGRAPHIC = 1
} sins_frame;

/** Algorithms of the mechanization. */
typedef enum sins_scheme {
    /** Coning, sculling and exact rotation compensation; Earth terms from the middle of the update. */
    SINS_SCHEME_EXACT = 0,
    /** The paper's equations (7)-(24), misprints corrected, approximations kept. */
    SINS_SCHEME_PAPER = 1,
    /** As SINS_SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large rotations within an update. */
    SINS_SCHEME_POLYNOMIAL = 2
} sins_scheme;

/** What stabilizes the vertical channel. */
typedef enum sins_vertical {
    /**
     * Third-order loop on a barometric height, time constant 100 s. Its response to an error of the vertical accelerometer differs
     * from that of a continuous loop by the fraction 3.5e-5 at a sample rate of 1 Hz, and its response to an initial velocity error by
     * 6.5e-4. Both are of second order in the sample interval: 3.5e-7 and 6.5e-6 at 10 Hz.
     */
    SINS_VERTICAL_DAMPED = 0,
    /** Height and vertical velocity set to the truth at each sample. */
    SINS_VERTICAL_FOLLOW_TRUTH = 1,
    /** Nothing stabilizes the vertical channel: any error grows e-fold every 569 s. */
    SINS_VERTICAL_FREE = 2
} sins_vertical;

/** Whether the error differential equations are integrated. */
typedef enum sins_error_model {
    /** No error differential equations: SINS_ERRORS_MODEL is not available. */
    SINS_ERROR_MODEL_OFF = 0,
    /** The error differential equations (error data 1) by fourth-order Runge-Kutta. */
    SINS_ERROR_MODEL_RK4 = 1
} sins_error_model;

/** Whether the library summarizes the true motion. */
typedef enum sins_summary {
    /** sins_get_truth_summary() is not available. */
    SINS_SUMMARY_OFF = 0,
    /** sins_get_truth_summary() is available. The other outputs have the same bits as without. */
    SINS_SUMMARY_ON = 1
} sins_summary;

/** Whether the covariance of the navigation errors is propagated. */
typedef enum sins_covariance_mode {
    /** sins_get_covariance() is not available. */
    SINS_COVARIANCE_OFF = 0,
    /** The covariance is propagated along the truth; the other outputs have the same bits. */
    SINS_COVARIANCE_ON = 1
} sins_covariance_mode;

/** Ellipsoids. */
typedef enum sins_earth {
    /** World Geodetic System 1984. */
    SINS_EARTH_WGS84 = 0,
    /** China Geodetic Coordinate System 2000. */
    SINS_EARTH_CGCS2000 = 1,
    /** Geodetic Reference System 1980. */
    SINS_EARTH_GRS80 = 2,
    /** Krassovsky 1940; Earth rate and gravitational constant as WGS-84. */
    SINS_EARTH_KRASSOVSKY1940 = 3
} sins_earth;

/** Formulas of normal gravity. */
typedef enum sins_gravity {
    /** Normal gravity in closed form at any height, with its north component. */
    SINS_GRAVITY_NORMAL = 0,
    /** Somigliana's formula with the second-order height term, along the ellipsoid normal, as in most tools. */
    SINS_GRAVITY_SOMIGLIANA = 1
} sins_gravity;

/** Directions of the sensor axes. */
typedef enum sins_axes {
    /** Sensor axes: x right, y forward, z up (the paper's). */
    SINS_AXES_RIGHT_FORWARD_UP = 0,
    /** Sensor axes: x forward, y right, z down. */
    SINS_AXES_FORWARD_RIGHT_DOWN = 1
} sins_axes;

/** Ideal signals. */
typedef enum sins_signal {
    /**
     * Ideal signals are the integrals of the true angular rate and specific force, so the navigation shows the mechanization's
     * own error.
     */
    SINS_SIGNAL_PHYSICAL = 0,
    /**
     * As SINS_SIGNAL_PHYSICAL, plus a small trim that keeps an error-free navigator at the truth for any time, even with a
     * free vertical channel. It is for hosts that want the errors of the sensors only. sins_accuracy reports the size of the
     * trim. If the initial state, a sensor or gravity has errors, the library also runs a second navigator without errors to
     * compute the trim. A step then takes longer.
     */
    SINS_SIGNAL_CLOSED_LOOP = 1
} sins_signal;

/** Options of a simulator. All zero (except struct_size) is the recommended simulator. */
typedef struct sins_options {
    /** sizeof(sins_options) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Axes of the mechanization, of enum sins_frame. */
    int32_t frame;
    /** Algorithm of the mechanization, of enum sins_scheme. */
    int32_t scheme;
    /**
     * Number of subsamples of a mechanization update, 1 to 5; 0: 2. A subsample is one of the equal parts of the update; the
     * sensors give one increment for each.
     */
    int32_t subsamples;
    /** Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (docs/host_time.md). */
    int32_t updates_per_sample;
    /** Vertical channel, of enum sins_vertical. */
    int32_t vertical;
    /** Error differential equations, of enum sins_error_model. */
    int32_t error_model;
    /** Ellipsoid, of enum sins_earth. */
    int32_t earth;
    /** Normal gravity, of enum sins_gravity. */
    int32_t gravity;
    /** Directions of the body axes and of the sensor axes, of enum sins_axes. */
    int32_t axes;
    /** Ideal signals, of enum sins_signal. */
    int32_t signal;
    /** Seed of all random streams. */
    uint64_t seed;
    /** Run number. The same seed with another run number gives other random numbers. Run k of an ensemble has the number k. */
    uint64_t run;
    /**
     * Time constant of SINS_SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0: 30 s, for which max_gap_s
     * must be at most 7.5 s. Must be 0 with another signal.
     */
    double closed_loop_time_s;
    /**
     * Stated sample period, 5e-5 to max_gap_s [s]; 0: the samples' own time stamps count. With a stated period, each
     * sample is at an exact multiple of the period from the first. The time stamps then serve only to order and to check the
     * samples: each must be within 0.4 of a period of its multiple.
     */
    double sample_period_s;
    /**
     * Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Use intervals of minutes only for a vehicle at rest.
     * Even at rest the position error grows with the third power of the interval: within 12 h it reaches 0.09 m with
     * intervals of 10 s, and 91 m with intervals of 100 s.
     */
    double max_gap_s;
    /**
     * Largest mean acceleration between two samples, 1e-3 to 1e6 [m/s2]; 0: 2000 m/s2. Velocities that need a larger one are
     * rejected as a jump of the truth; without velocities, displacements that need a larger one and 10 m more.
     */
    double max_acceleration_m_s2;
    /** Summary of the true motion, of enum sins_summary. */
    int32_t truth_summary;
    /** Covariance of the navigation errors, of enum sins_covariance_mode. */
    int32_t covariance;
} sins_options;

/**
 * A simulator. A handle is a checked key, never an address: a null, made-up or destroyed one is answered
 * SINS_ERROR_BAD_HANDLE. Any function may be called from any thread; calls on one handle wait for each other, calls on
 * different handles never do.
 */
typedef struct sins_sim sins_sim;

/**
 * Creates a simulator with ideal sensors. If options is NULL, it has the recommended options.
 *
 * On an error *sim is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason. Not for a real-time
 * frame: it allocates.
 *
 * SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators exist.
 *
 * ```c
 * sins_options options;
 * sins_sim *detailed = NULL;
 * SINS_INIT(options);
 * options.error_model = SINS_ERROR_MODEL_RK4;
 * sins_create(&options, &detailed);
 * sins_get_options(detailed, &options);
 * printf("%d subsamples\n", (int)options.subsamples);  // 2 subsamples
 * sins_destroy(detailed);
 * ```
 */
SINS_API sins_status SINS_CALL sins_create(const sins_options *options, sins_sim **sim);

/**
 * Waits until the calls of other threads on this handle have returned, and destroys the simulator. The handle is never used
 * again.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 *
 * ```c
 * sins_sim *other = NULL;
 * sins_create(NULL, &other);
 * printf("%s\n", sins_status_string(sins_destroy(other)));  // SINS_OK
 * printf("%s\n", sins_status_string(sins_destroy(other)));  // SINS_ERROR_BAD_HANDLE
 * ```
 */
SINS_API sins_status SINS_CALL sins_destroy(sins_sim *sim);

/** Reads the options in effect: those of sins_create() or of the snapshot that was loaded, with the defaults in place of 0. */
SINS_API sins_status SINS_CALL sins_get_options(sins_sim *sim, sins_options *options);

/**
 * Puts one flight sample into the queue (16 samples). Each sample is checked by itself and against the one before.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
 * SINS_ERROR_TIME_ORDER: the sample is not later than the one before, or later by less than 5e-5 s, or off a stated period
 * by more than 0.4 of the period.
 * SINS_GAP: the sample was accepted, and the interval before it is a gap, more than 2.5 times as long as each of the two
 * before. sins_step() flies the gap as motion: the vehicle moves by its velocity times the length of the gap. After a pause
 * of the host in which its clock ran on, call sins_move_time() before this push; a push cannot be undone.
 * SINS_ERROR_DISCONTINUITY: a gap of more than max_gap_s, a jump, or a turn of 170 degrees or more since the last accepted
 * sample. After a gap each later sample is rejected, until you call sins_move_time(), sins_move_truth() or
 * sins_reposition(). After a jump or a turn each later sample is rejected, until one fits the last accepted sample, or until
 * you call sins_move_truth() or sins_reposition().
 * SINS_ERROR_QUEUE_FULL: step first.
 * SINS_ERROR_BAD_STATE: navigating on increments.
 *
 * ```c
 * printf("%s\n", sins_status_string(sins_push_sample(sim, &sample)));  // SINS_OK
 * printf("%s\n", sins_status_string(sins_push_sample(sim, &sample)));  // SINS_ERROR_TIME_ORDER
 * ```
 */
SINS_API sins_status SINS_CALL sins_push_sample(sins_sim *sim, const sins_flight_sample *sample);

/**
 * Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples, each
 * later step one more. No allocation, no system call. An interval in which the host paused and its clock ran on is flown
 * like any other: the vehicle moves by its velocity times the length of the interval. sins_push_sample() returns SINS_GAP if
 * the interval is a gap.
 *
 * SINS_NEED_SAMPLE: no complete interval is waiting.
 * SINS_ERROR_DIVERGED: the step would bring the solution below a height of -500 km, above a height of 20000 km, or to a
 * speed of more than 100 km/s. The limits apply to the solution of the sensor block, to that of the reference point, and to
 * the error-free navigator of SINS_SIGNAL_CLOSED_LOOP.
 * SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
 * SINS_ERROR_BAD_STATE: navigating on increments.
 *
 * After SINS_ERROR_DIVERGED and SINS_ERROR_SINGULAR the step is not made, and the solution before it stays readable. The
 * samples stay in the queue, so a further sins_step() tries the same interval again. sins_reposition() or sins_reset() start
 * anew.
 *
 * ```c
 * while (sins_step(sim) == SINS_OK) {
 *     sins_get_navigation(sim, &navigation);
 *     printf("%.0f s\n", navigation.time_s);  // 3601 s
 * }
 * ```
 */
SINS_API sins_status SINS_CALL sins_step(sins_sim *sim);

/**
 * Moves the time after a pause in which the host's clock ran on: the newest accepted sample gets the time stamp time_s [s], and
 * later samples must have later stamps. time_s is the time that the clock shows when the vehicle moves again. Everything else
 * stays: errors, noise, waiting samples, sensor processes, failures and running figures. The grid of a stated period moves
 * along. The outputs have the same bits as those of a flight without the jump of time, if the differences between successive
 * time stamps are the same doubles. With a stated period this is always so. (If the samples have no velocities, the
 * differences over three samples must be the same doubles too. Durations in sins_accuracy have the rounding of the time
 * stamps.) The host must also move its flight_start_s of sins_scene_prepare() by the same time.
 *
 * SINS_ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9.
 * SINS_ERROR_BAD_STATE: no sample yet, or navigating on increments, which have no time stamps.
 */
SINS_API sins_status SINS_CALL sins_move_time(sins_sim *sim, double time_s);

/**
 * Slews the vehicle: the truth jumps to the sample, and the INS keeps its errors. No interval is flown from the previous
 * sample to this one, so the errors do not change at the slew. For both values of source, sins_get_errors() reports the same
 * errors before and after it: position error in metres (along the truth's east and north, and in height), velocity error
 * (components) and misalignment, to 1e-8 m, 1e-11 m/s and 1e-14 rad. Their further growth depends on gravity, latitude and
 * velocity at the new place. Noise, sensor processes, failures, the vertical channel, the altimeter's error and running
 * figures continue, and no random number changes. (The scale factor error of the altimeter is that of the new height.) The
 * sensors follow the new signals immediately. Waiting samples are dropped. The time may jump too: the running figures and
 * the grid of a stated period then move with it, as in sins_move_time(). sins_get_imu() still reports the previous interval.
 * If the sample has no velocity, the library takes the true velocity as 0 until the next sample is pushed. The navigated
 * velocity is then equal to the velocity error.
 *
 * If the vehicle is within 20 km of the Earth's axis before or after the slew, the east and north components of truth and
 * solution are not comparable. The axes of the solution are then those of the truth, turned by the shortest rotation so that
 * up is the vertical of the solution. In these axes the components of the velocity error and of the misalignment are kept.
 * With a mounting, the errors of the sensor block are kept. The errors of the reference point follow from them with the
 * lever arm, the boresight and their errors, in the new attitude.
 *
 * Before the first step there are no errors to keep, and the call acts as sins_reposition().
 *
 * SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_reposition().
 * SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
 * SINS_ERROR_DIVERGED: the solution would leave its limits, or the position error is about a quarter of the Earth's
 * circumference or more, so that no place at the sample has this error.
 */
SINS_API sins_status SINS_CALL sins_move_truth(sins_sim *sim, const sins_flight_sample *sample);

/**
 * Restarts the INS after the flight simulator was reloaded: the truth jumps to the sample, and the INS starts again there
 * with its initial errors. The initial errors have the same random numbers as at the first start. The previous errors of the
 * INS are lost; to keep them, call sins_move_truth() (slew) or sins_move_time() (pause) instead. Noise and failures
 * continue. Waiting samples and the running accuracy figures are dropped. The time may jump too, forward or back: the run,
 * and the grid of a stated period, continue from the sample's time stamp. Until the next step, the reads give the state at
 * this sample, and there is no interval to read. The call may be the first of a run: the sample is then the first one, and
 * the next push completes an interval.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
 * SINS_ERROR_BAD_STATE: navigating on increments.
 *
 * This call returns SINS_OK even if no INS can start at the sample. The reads and the next step then return
 * SINS_ERROR_SINGULAR (too close to a pole, in geographic axes or for gyrocompassing) or SINS_ERROR_DIVERGED.
 */
SINS_API sins_status SINS_CALL sins_reposition(sins_sim *sim, const sins_flight_sample *sample);

/**
 * Returns to the state before the first sample: the same options, the parameters as they were set last, no failures, and
 * the random streams at their start. So the same samples and settings give the same bits. For other random numbers, create
 * a simulator with another seed or run. To return to a moment in flight, see sins_snapshot_save().
 */
SINS_API sins_status SINS_CALL sins_reset(sins_sim *sim);

/* Why a call failed. */

/** Flags of a sins_error_info. */
typedef enum sins_error_info_flags {
    /** The field value holds the value at fault. */
    SINS_ERROR_INFO_VALUE = 1,
    /** The field minimum holds the least allowed value. */
    SINS_ERROR_INFO_MINIMUM = 2,
    /** The field maximum holds the greatest allowed value. */
    SINS_ERROR_INFO_MAXIMUM = 4,
    /** The field is an integer. */
    SINS_ERROR_INFO_INTEGER = 8
} sins_error_info_flags;

/** Why a call failed: the data of which the sentence of sins_last_error() is made. */
typedef struct sins_error_info {
    /** sizeof(sins_error_info) */
    uint32_t struct_size;
    /** Flags of enum sins_error_info_flags, or'ed. */
    uint32_t flags;
    /** Status that the failed call returned, of enum sins_status_code; SINS_OK if no call failed. */
    sins_status status;
    /** 0 */
    uint32_t reserved;
    /**
     * Name of the field or argument at fault, such as "gyro.markov_time_s", or of a computed quantity at fault, such as
     * "navigated position error [m]"; terminated. Empty if the call itself is at fault.
     */
    char field[96];
    /** Element of the field, from 0; -1: the field is not an array, or the whole field is at fault. */
    int64_t index;
    /** Index of the sample or of the recorded increment in the array of the call, from 0; -1: none is at fault. */
    int64_t sample;
    /** With SINS_ERROR_INFO_VALUE: the value at fault, which may be NaN or infinite; for an integer, the nearest double. */
    double value;
    /**
     * With SINS_ERROR_INFO_MINIMUM: the least value. If the sentence of sins_last_error() says "more than", the limit itself
     * is not allowed.
     */
    double minimum;
    /**
     * With SINS_ERROR_INFO_MAXIMUM: the greatest value. If the sentence of sins_last_error() says "less than", the limit
     * itself is not allowed.
     */
    double maximum;
} sins_error_info;

/**
 * Copies the sentence of the last failed call on this handle. The sentence names field, value and limit; it is UTF-8 and
 * always terminated; it is "no error" if no call failed. With a NULL handle the function gives the last failed call of this
 * thread that was made without a simulator (create, presets, flights, ensembles, statistics, scenes, logs, recommend,
 * budget). A call whose handle was rejected (SINS_ERROR_BAD_HANDLE, or SINS_ERROR_BAD_STATE: see Threads) keeps no sentence, as its
 * status says why. A failure of this call or of sins_last_error_info() is not kept.
 *
 * needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for the
 * size only. SINS_ERROR_BUFFER_TOO_SMALL: the sentence was cut.
 *
 * ```c
 * gyro.markov_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR;
 * if (sins_set_gyro(sim, &gyro) < 0) {
 *     sins_last_error(sim, reason, sizeof reason, NULL);
 *     printf("%s\n", reason);  // gyro.markov_time_s[1] = 0: must be from 1e-9 to 1e15 where gyro.markov_sigma_rad_s is not 0
 * }
 * gyro.markov_sigma_rad_s[1] = 0.0;
 * ```
 */
SINS_API sins_status SINS_CALL sins_last_error(const sins_sim *sim, char *buffer, size_t capacity, size_t *needed);

/** Gives the same failure as sins_last_error(), as a struct. */
SINS_API sins_status SINS_CALL sins_last_error_info(const sins_sim *sim, sins_error_info *info);

/* Sensor errors. */

/**
 * Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is an ideal
 * triad. Signal: the angular rate. Densities do not depend on the sample rate.
 *
 * Effects act in this order, along the path of the signal: bandwidth; then errors that depend on the signal (scale factor,
 * misalignment, asymmetry, nonlinearity), on the true specific force (g-sensitivity, g2-sensitivity) and on temperature; then
 * biases and noise; then dead zone, range, quantization.
 *
 * Asymmetry, nonlinearity, dead zone and range, g2-sensitivity of the gyros, and vibration rectification of the accelerometers
 * act on the mean signal of a subsample, whose length is dt = interval / (updates_per_sample * subsamples). The mean reduces the
 * effect of a vibration of frequency f. With x = pi f dt, nonlinearity and rectification are too small by the fraction 1 - (sin
 * x / x)^2. Asymmetry is too small by up to the fraction 1 - cos x, if the vibration changes the sign of the signal. If f is a
 * tenth of the sample rate, these fractions are 0.8 % and 1.2 % with two subsamples per interval, 3.2 % and 4.9 % with one.
 */
typedef struct sins_gyro_params {
    /** sizeof(sins_gyro_params) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Constant bias, measured less true [rad/s], -100 to 100. */
    double bias_rad_s[3];
    /** Standard deviation of the turn-on bias, drawn once a run [rad/s], 0 to 100. */
    double bias_sigma_rad_s[3];
    /**
     * Standard deviation of the first-order Gauss-Markov bias [rad/s], 0 to 100. The process is stationary from
     * the first sample on.
     */
    double markov_sigma_rad_s[3];
    /** Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_rad_s is not 0. */
    double markov_time_s[3];
    /**
     * White noise N: angle random walk [rad/sqrt(s)], 0 to 100. It is the square root of the spectral density of
     * the noise, in the unit of the signal per sqrt(Hz).
     */
    double random_walk_rad_sqrt_s[3];
    /** Rate random walk K [(rad/s)/sqrt(s)], 0 to 100. It starts at 0 at the start of a run. */
    double rate_random_walk_rad_s_sqrt_s[3];
    /**
     * Ramp R: bias that grows with time [rad/s2], -100 to 100. The bias starts at 0 when the ramp is switched on,
     * and at sins_reset(). If R is changed in flight, the bias continues from its present value.
     */
    double rate_ramp_rad_s2[3];
    /**
     * Flicker noise, bias instability B [rad/s], 0 to 100. The process is stationary from the first sample on: the
     * Allan deviation is flat at 0.664 B from 2 s to 50 h.
     */
    double flicker_rad_s[3];
    /** Scale factor error [1], -1 to 1. */
    double scale_factor[3];
    /**
     * Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
     * scale_factor.
     */
    double scale_factor_sigma[3];
    /**
     * Scale factor error for positive signals less that for negative signals [1], -1 to 1. The error of a signal s
     * is half of this times |s|.
     */
    double scale_factor_asymmetry[3];
    /**
     * Scale factor error that grows with the size of the signal [s/rad], -1 to 1. The error of a signal s is this
     * times s |s|.
     */
    double scale_factor_nonlinearity_s_rad[3];
    /**
     * Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error of sensor i is the
     * sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
     */
    double misalignment_rad[9];
    /**
     * Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
     * misalignment_rad. The diagonal must be 0.
     */
    double misalignment_sigma_rad[9];
    /**
     * Drift caused by specific force, g-sensitivity: row = gyro, column = axis of the force [(rad/s)/(m/s2)],
     * -1 to 1. The error of a gyro is the sum over the three axes of its row times the true specific force along
     * them.
     */
    double g_sensitivity_rad_s_per_m_s2[9];
    /**
     * Drift caused by the square of the specific force along the gyro's own axis, g2-sensitivity [(rad/s)/(m/s2)^2],
     * -1 to 1. The rate error of gyro i is element i times the square of the true specific force along sensor axis
     * i, at the point of the sensor block (see sins_mounting). So a positive element makes a drift in the positive
     * sense about the axis, whatever the sign of the force. The mean force of a subsample is squared, as with
     * nonlinearity.
     */
    double g2_sensitivity_rad_s_per_m2_s4[3];
    /**
     * Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
     * sins_flight_sample.temperature_c less this temperature. If one of the coefficients is not 0, every sample
     * needs a temperature, and sins_push_imu() is not available.
     */
    double reference_temperature_c;
    /** Bias per kelvin [(rad/s)/K], -100 to 100. The bias is this coefficient times T. */
    double bias_temperature_rad_s_per_k[3];
    /** Bias per kelvin squared [(rad/s)/K2], -100 to 100. The bias is this coefficient times T squared. */
    double bias_temperature2_rad_s_per_k2[3];
    /** Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this coefficient times T. */
    double scale_factor_temperature_per_k[3];
    /**
     * Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this coefficient times T
     * squared.
     */
    double scale_factor_temperature2_per_k2[3];
    /**
     * Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter starts in its
     * steady state, so there is no transient in the first interval.
     */
    double bandwidth_hz[3];
    /** Half the dead zone: signals up to this size give 0 [rad/s], 0 to 100. */
    double dead_zone_rad_s[3];
    /** Range, where the output saturates [rad/s], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu. */
    double range_rad_s[3];
    /**
     * Quantum (pulse weight) of the output increments [rad], 1e-15 to 1; 0: none. The remainder goes into the next
     * increment. The quantization noise Q is quantum/sqrt(12).
     */
    double quantization_rad[3];
} sins_gyro_params;

/**
 * Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is
 * an ideal triad. Signal: the specific force. Densities do not depend on the sample rate.
 *
 * Effects act in this order, along the path of the signal: size effect, bandwidth; then errors that depend on the signal (scale
 * factor, misalignment, asymmetry, nonlinearity, vibration rectification) and on temperature; then biases and noise; then dead
 * zone, range, quantization. sins_gyro_params describes the effects that act on the mean of a subsample.
 */
typedef struct sins_accel_params {
    /** sizeof(sins_accel_params) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Constant bias, measured less true [m/s2], -10000 to 10000. */
    double bias_m_s2[3];
    /** Standard deviation of the turn-on bias, drawn once a run [m/s2], 0 to 10000. */
    double bias_sigma_m_s2[3];
    /**
     * Standard deviation of the first-order Gauss-Markov bias [m/s2], 0 to 10000. The process is stationary from
     * the first sample on.
     */
    double markov_sigma_m_s2[3];
    /** Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_m_s2 is not 0. */
    double markov_time_s[3];
    /**
     * White noise N: velocity random walk [(m/s)/sqrt(s)], 0 to 10000. It is the square root of the spectral
     * density of the noise, in the unit of the signal per sqrt(Hz).
     */
    double velocity_random_walk_m_s_sqrt_s[3];
    /** Acceleration random walk K [(m/s2)/sqrt(s)], 0 to 10000. It starts at 0 at the start of a run. */
    double acceleration_random_walk_m_s2_sqrt_s[3];
    /**
     * Ramp R: bias that grows with time [m/s3], -10000 to 10000. The bias starts at 0 when the ramp is switched
     * on, and at sins_reset(). If R is changed in flight, the bias continues from its present value.
     */
    double ramp_m_s3[3];
    /**
     * Flicker noise, bias instability B [m/s2], 0 to 10000. The process is stationary from the first sample on:
     * the Allan deviation is flat at 0.664 B from 2 s to 50 h.
     */
    double flicker_m_s2[3];
    /** Scale factor error [1], -1 to 1. */
    double scale_factor[3];
    /**
     * Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
     * scale_factor.
     */
    double scale_factor_sigma[3];
    /**
     * Scale factor error for positive signals less that for negative signals [1], -1 to 1. The error of a signal s
     * is half of this times |s|.
     */
    double scale_factor_asymmetry[3];
    /**
     * Scale factor error that grows with the size of the signal [s2/m], -1 to 1. The error of a signal s is this
     * times s |s|.
     */
    double scale_factor_nonlinearity_s2_m[3];
    /**
     * Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error of sensor i is the
     * sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
     */
    double misalignment_rad[9];
    /**
     * Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
     * misalignment_rad. The diagonal must be 0.
     */
    double misalignment_sigma_rad[9];
    /**
     * Vibration rectification, the g2 term [s2/m], -1 to 1. The error is this times the square of the mean force
     * of a subsample. So a vibration with the root mean square r causes a bias of this times r squared.
     */
    double vibration_rectification_s2_m[3];
    /**
     * Lever arm of each accelerometer from the point of the sensor block, sensor axes, row = sensor (size effect)
     * [m], -100 to 100. The point of the sensor block is where the lever arm of sins_mounting ends. If a flight
     * starts in motion, samples without an angular rate do not show the angular acceleration of the first interval
     * (see sins_mounting). The measured velocity is then wrong for the rest of the flight: it lacks the lever arm
     * times the change of the angular rate in the first interval. With sins_push_imu() the angular acceleration
     * follows from the previous increments.
     */
    double lever_arm_m[9];
    /**
     * Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
     * sins_flight_sample.temperature_c less this temperature. If one of the coefficients is not 0, every sample
     * needs a temperature, and sins_push_imu() is not available.
     */
    double reference_temperature_c;
    /** Bias per kelvin [(m/s2)/K], -10000 to 10000. The bias is this coefficient times T. */
    double bias_temperature_m_s2_per_k[3];
    /** Bias per kelvin squared [(m/s2)/K2], -10000 to 10000. The bias is this coefficient times T squared. */
    double bias_temperature2_m_s2_per_k2[3];
    /** Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this coefficient times T. */
    double scale_factor_temperature_per_k[3];
    /**
     * Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this coefficient times T
     * squared.
     */
    double scale_factor_temperature2_per_k2[3];
    /**
     * Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter starts in its
     * steady state, so there is no transient in the first interval.
     */
    double bandwidth_hz[3];
    /** Half the dead zone: signals up to this size give 0 [m/s2], 0 to 10000. */
    double dead_zone_m_s2[3];
    /** Range, where the output saturates [m/s2], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu. */
    double range_m_s2[3];
    /**
     * Quantum (pulse weight) of the output increments [m/s], 1e-15 to 1; 0: none. The remainder goes into the next
     * increment. The quantization noise Q is quantum/sqrt(12).
     */
    double quantization_m_s[3];
} sins_accel_params;

/**
 * Sets the gyro errors: before the first sample or in flight, from the next interval on. The random numbers of other
 * effects do not change. Random processes that were active continue.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: temperature coefficients while samples without a temperature wait, or while navigating on
 * increments.
 *
 * ```c
 * gyro.bias_rad_s[2] = 0.02 * SINS_DEG_PER_HOUR;
 * gyro.random_walk_rad_sqrt_s[0] = 0.005 * SINS_DEG_PER_SQRT_HOUR;
 * gyro.scale_factor[0] = 100.0 * SINS_PPM;
 * printf("%s\n", sins_status_string(sins_set_gyro(sim, &gyro)));  // SINS_OK
 * ```
 */
SINS_API sins_status SINS_CALL sins_set_gyro(sins_sim *sim, const sins_gyro_params *params);

/**
 * Reads the gyro errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
 * snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_gyro(sins_sim *sim, sins_gyro_params *params);

/**
 * Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The random numbers of
 * other effects do not change. Random processes that were active continue.
 *
 * SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().
 *
 * ```c
 * accel.bias_m_s2[1] = 50.0 * SINS_MICRO_G;
 * printf("%s\n", sins_status_string(sins_set_accel(sim, &accel)));  // SINS_OK
 * ```
 */
SINS_API sins_status SINS_CALL sins_set_accel(sins_sim *sim, const sins_accel_params *params);

/**
 * Reads the accelerometer errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
 * snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_accel(sins_sim *sim, sins_accel_params *params);

/** Errors of the barometric altimeter, whose height damps the vertical channel. All zero is an ideal altimeter. */
typedef struct sins_altimeter_params {
    /** sizeof(sins_altimeter_params) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Constant bias [m], -1e5 to 1e5. */
    double bias_m;
    /**
     * Standard deviation of the Gauss-Markov error [m], 0 to 1e5. The error is of first order, and stationary from
     * the first sample on.
     */
    double markov_sigma_m;
    /** Correlation time of the Gauss-Markov error [s], 1e-9 to 1e15; needed where markov_sigma_m is not 0. */
    double markov_time_s;
    /** Standard deviation of the independent error of each sample [m], 0 to 1e5. */
    double noise_m;
    /** Scale factor error of the height [1], -1 to 1. */
    double scale_factor;
    /** Time constant of the lag of the static pressure [s], 0 to 1e6. The lag is of first order. */
    double lag_s;
} sins_altimeter_params;

/**
 * Sets the errors of the barometric altimeter, whose height damps the vertical channel (SINS_VERTICAL_DAMPED), from the next
 * interval on.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_set_altimeter(sins_sim *sim, const sins_altimeter_params *params);

/**
 * Reads the errors of the altimeter that are set. May be called at any moment. After sins_snapshot_load() they are those of
 * the snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_altimeter(sins_sim *sim, sins_altimeter_params *params);

/* Reads. */

/** Flags of a sins_navigation. */
typedef enum sins_navigation_flags {
    /**
     * Within 20 km of the Earth's axis: longitude and heading change fast there, and at the pole they are undefined.
     * Quaternion, height and the errors in metres stay correct.
     */
    SINS_NAVIGATION_NEAR_POLE = 1,
    /**
     * Nothing aids the vertical channel, because of the options or because the altimeter has no signal: any error grows e-fold
     * every 569 s.
     */
    SINS_NAVIGATION_VERTICAL_UNAIDED = 2,
    /**
     * The positions and the velocities of the samples contradict each other. Let d be the displacement computed from the velocities.
     * The flag is set if the displacement of the positions since the previous sample differs from d by more than
     * sqrt((0.01 d)^2 + (1 cm)^2). The truth and the navigation have it.
     */
    SINS_NAVIGATION_INCONSISTENT = 4,
    /**
     * The alignment at the start could not find north, so any heading error is possible. Either the accelerometers show no
     * force, or the error of the horizontal gyro rates is at least as large as the north component of the Earth rate. (If it is
     * smaller, the heading error is below 90 degrees.) The flag stays until the INS starts again, or a sins_unit corrects the
     * solution. Note: a real INS does not know this error. It can be sure that it has not found north only if its horizontal
     * gyro rate is more than twice the north component of the Earth rate.
     */
    SINS_NAVIGATION_NORTH_UNKNOWN = 8
} sins_navigation_flags;

/** A solution: the truth or the navigated one. */
typedef struct sins_navigation {
    /** sizeof(sins_navigation) */
    uint32_t struct_size;
    /** 0 (must be 0 where it is an input). */
    uint32_t reserved;
    /** Time [s]. */
    double time_s;
    /** Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /** Longitude, east positive, -pi to pi [rad]. */
    double longitude_rad;
    /** Height above the ellipsoid [m]. */
    double height_m;
    /** Velocity against the Earth, east-north-up [m/s]. */
    double velocity_enu_m_s[3];
    /** Roll, right wing down positive, -pi to pi [rad]. */
    double roll_rad;
    /** Pitch, nose up positive, -pi/2 to pi/2 [rad]. */
    double pitch_rad;
    /** Heading, clockwise from true north, 0 to 2 pi [rad]. */
    double heading_rad;
    /**
     * Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes while navigating on
     * increments.
     */
    double quaternion_nb[4];
    /** Flags of enum sins_navigation_flags, or'ed. */
    int32_t flags;
    /** 0 */
    uint32_t reserved2;
} sins_navigation;

/** A solution within a sins_record; never grows. Fields as in sins_navigation. */
typedef struct sins_record_solution {
    /** Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /** Longitude, east positive, -pi to pi [rad]. */
    double longitude_rad;
    /** Height above the ellipsoid [m]. */
    double height_m;
    /** Velocity against the Earth, east-north-up [m/s]. */
    double velocity_enu_m_s[3];
    /** Roll, right wing down positive, -pi to pi [rad]. */
    double roll_rad;
    /** Pitch, nose up positive, -pi/2 to pi/2 [rad]. */
    double pitch_rad;
    /** Heading, clockwise from true north, 0 to 2 pi [rad]. */
    double heading_rad;
    /**
     * Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes while navigating on
     * increments.
     */
    double quaternion_nb[4];
    /** Flags of enum sins_navigation_flags, or'ed. */
    int32_t flags;
    /** 0 */
    uint32_t reserved2;
} sins_record_solution;

/**
 * Reads the truth at the end of the last interval; before the first step, that of the first sample. If the samples have no
 * velocity, the velocity at the first one is 0 until the second one is pushed.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
 */
SINS_API sins_status SINS_CALL sins_get_truth(sins_sim *sim, sins_navigation *truth);

/**
 * Reads the navigated solution for the same instant as sins_get_truth().
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: before the first step, no INS can start at the first sample with these options
 * and initial errors.
 *
 * ```c
 * sins_get_navigation(sim, &navigation);
 * printf("%.1f deg north\n", navigation.latitude_rad / SINS_DEG);  // 39.9 deg north
 * ```
 */
SINS_API sins_status SINS_CALL sins_get_navigation(sins_sim *sim, sins_navigation *navigation);

/** The two sources of errors. */
typedef enum sins_errors_source {
    /** Navigation minus truth: the paper's error data 2. */
    SINS_ERRORS_NAVIGATION = 0,
    /** The error differential equations: the paper's error data 1 (sins_options.error_model). */
    SINS_ERRORS_MODEL = 1
} sins_errors_source;

/** Flags of a sins_errors. */
typedef enum sins_errors_flags {
    /**
     * The truth is within 20 km of the Earth's axis: the errors of longitude and heading, the up misalignment, and the east and
     * north components of the velocity error have no meaning.
     */
    SINS_ERRORS_NEAR_POLE = 1,
    /**
     * A flag of the error model: the terms that it neglects are no longer small. The misalignment is above 2 degrees, or the
     * position error is above 100 km, or, at high latitude, above 3.5 % of the distance to the pole.
     */
    SINS_ERRORS_OUTSIDE_VALIDITY = 2,
    /** Not computed, all zero: in a sins_record; of a run that has diverged or cannot start, in sins_ensemble_get_all_errors(). */
    SINS_ERRORS_NOT_COMPUTED = 4,
    /**
     * In a sins_covariance: since the start sins_correct() has corrected the INS. The covariance is that of an INS without
     * corrections.
     */
    SINS_ERRORS_WITHOUT_CORRECTIONS = 8
} sins_errors_flags;

/** Errors of the navigated solution, computed less true. */
typedef struct sins_errors {
    /** sizeof(sins_errors) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Time [s]. */
    double time_s;
    /** Position error: displacement from truth along true east and north, and difference of heights [m]. */
    double position_enu_m[3];
    /** Error of latitude [rad]. */
    double latitude_rad;
    /** Error of longitude, wrapped to -pi to pi [rad]. */
    double longitude_rad;
    /** Error of height [m]. */
    double height_m;
    /**
     * Velocity error [m/s]: components of the computed velocity in the east-north-up axes at the computed position, less
     * components of the true velocity in the axes at the true position.
     */
    double velocity_enu_m_s[3];
    /**
     * Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from body axes to
     * east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
     */
    double misalignment_enu_rad[3];
    /** Error of roll, wrapped to -pi to pi [rad]. */
    double roll_rad;
    /** Error of pitch [rad]. */
    double pitch_rad;
    /** Error of heading, wrapped to -pi to pi [rad]. */
    double heading_rad;
    /** Flags of enum sins_errors_flags, or'ed. */
    int32_t flags;
    /** 0 */
    uint32_t reserved2;
} sins_errors;

/** Errors within a sins_record; never grows. Fields as in sins_errors. */
typedef struct sins_record_errors {
    /** Position error: displacement from truth along true east and north, and difference of heights [m]. */
    double position_enu_m[3];
    /** Error of latitude [rad]. */
    double latitude_rad;
    /** Error of longitude, wrapped to -pi to pi [rad]. */
    double longitude_rad;
    /** Error of height [m]. */
    double height_m;
    /**
     * Velocity error [m/s]: components of the computed velocity in the east-north-up axes at the computed position, less
     * components of the true velocity in the axes at the true position.
     */
    double velocity_enu_m_s[3];
    /**
     * Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from body axes to
     * east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
     */
    double misalignment_enu_rad[3];
    /** Error of roll, wrapped to -pi to pi [rad]. */
    double roll_rad;
    /** Error of pitch [rad]. */
    double pitch_rad;
    /** Error of heading, wrapped to -pi to pi [rad]. */
    double heading_rad;
    /** Flags of enum sins_errors_flags, or'ed. */
    int32_t flags;
    /** 0 */
    uint32_t reserved2;
} sins_record_errors;

/**
 * Reads the errors of the navigated solution; source is of enum sins_errors_source.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_INVALID_ARGUMENT: no such source.
 * SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the error model is off, as it is by default (create the simulator with
 * sins_options.error_model), or navigating on increments.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 *
 * ```c
 * sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors);
 * printf("%.2f nmi north\n", errors.position_enu_m[1] / SINS_NMI);  // -0.72 nmi north
 * ```
 */
SINS_API sins_status SINS_CALL sins_get_errors(sins_sim *sim, int32_t source, sins_errors *errors);

/** Flags of a sins_imu. */
typedef enum sins_imu_flags {
    /** The mean rate of a subsample was beyond the range of a gyro. */
    SINS_IMU_GYRO_SATURATED = 1,
    /** The mean force of a subsample was beyond the range of an accelerometer. */
    SINS_IMU_ACCEL_SATURATED = 2,
    /** A gyro had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of this gyro. */
    SINS_IMU_GYRO_INVALID = 4,
    /**
     * An accelerometer had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of
     * this accelerometer.
     */
    SINS_IMU_ACCEL_INVALID = 8
} sins_imu_flags;

/** Ideal and measured signals of the last interval, sensor axes. */
typedef struct sins_imu {
    /** sizeof(sins_imu) */
    uint32_t struct_size;
    /** Flags of enum sins_imu_flags, or'ed. */
    uint32_t flags;
    /** Time of the end of the interval [s]. */
    double time_s;
    /** Length of the interval [s]. */
    double interval_s;
    /** Integral of the angular rate against inertial space, as perfect gyros measure it [rad]. */
    double ideal_angle_rad[3];
    /** Integral of the specific force, as perfect accelerometers measure it [m/s]. */
    double ideal_velocity_m_s[3];
    /** Integral of the angular rate that the modelled gyros measure [rad]. */
    double measured_angle_rad[3];
    /** Integral of the specific force that the modelled accelerometers measure [m/s]. */
    double measured_velocity_m_s[3];
    /** measured_angle_rad after the compensation of sins_correct() [rad]. The INS navigates on the compensated increments. */
    double compensated_angle_rad[3];
    /** measured_velocity_m_s after the compensation of sins_correct() [m/s]. */
    double compensated_velocity_m_s[3];
    /** Mean angular rate of perfect gyros: ideal_angle_rad divided by interval_s [rad/s]. */
    double ideal_rate_rad_s[3];
    /** Mean specific force of perfect accelerometers: ideal_velocity_m_s divided by interval_s [m/s2]. */
    double ideal_force_m_s2[3];
    /** Mean angular rate of the modelled gyros: measured_angle_rad divided by interval_s [rad/s]. */
    double measured_rate_rad_s[3];
    /** Mean specific force of the modelled accelerometers: measured_velocity_m_s divided by interval_s [m/s2]. */
    double measured_force_m_s2[3];
} sins_imu;

/**
 * Reads ideal and measured signals of the last interval. They are sums: for own navigation, sins_get_imu_update() reads the
 * parts on which the INS navigates.
 *
 * SINS_NEED_SAMPLE: no interval yet.
 */
SINS_API sins_status SINS_CALL sins_get_imu(sins_sim *sim, sins_imu *imu);

/**
 * Running figures of the flight since its start or last reposition; sins_move_time() and sins_move_truth() do not restart
 * them. The figures use the errors once a second. They describe one run, not an ensemble. To get nautical miles per hour,
 * divide a rate by SINS_NMI_PER_HOUR.
 */
typedef struct sins_accuracy {
    /** sizeof(sins_accuracy) */
    uint32_t struct_size;
    /**
     * 1: duration_s is at least a Schuler period, 5064 s (84.4 min), and the window has errors. 0: the errors still swing back, so the
     * rates RER, R50 and R95 depend on the moment, and a display leaves them out. The time in which a unit aligns counts, and so do
     * errors that sins_correct() removed: then the rates are not figures of the INS alone.
     */
    uint32_t has_rates;
    /** Time [s]. */
    double time_s;
    /** Time since the start [s]. */
    double duration_s;
    /**
     * Start of the window of the radial error rates, as time since the start: 300 [s]. Earlier rates would be initial errors
     * divided by a very short time.
     */
    double window_start_s;
    /** Number of errors (one a second) in the window of the radial error rates. While it is 0, the rates are 0. */
    uint64_t window_samples;
    /**
     * Root mean square of the radial error rate, sqrt(mean RER^2), with RER = horizontal position error / time since the
     * start [m/s].
     */
    double radial_error_rate_rms_m_s;
    /** R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s]. */
    double cep_rate_m_s;
    /** R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s]. */
    double radial_95_rate_m_s;
    /** Slope of the least-squares line (with an intercept) through the horizontal position errors of the window [m/s]. */
    double radial_error_slope_m_s;
    /**
     * Root mean square velocity error since the start, east-north-up; samples within 20 km of the Earth's axis, where east
     * and north turn fast, are left out [m/s].
     */
    double velocity_rms_enu_m_s[3];
    /** Position closure: the position error now, navigation minus truth [m]. */
    double closure_position_enu_m[3];
    /** Velocity closure: the velocity error now, navigation minus truth [m/s]. */
    double closure_velocity_enu_m_s[3];
    /**
     * Part of the horizontal position error that the host causes, because its velocities contradict its positions [m]. Let d
     * be the displacement from the velocities less the displacement from the positions. The field is the response of a
     * Schuler oscillator to d; up is 0. The rest of the position error is caused by the simulator and the sensors.
     */
    double host_position_enu_m[3];
    /** Part of the horizontal velocity error that the host causes in this way; up is 0 [m/s]. */
    double host_velocity_enu_m_s[3];
    /** Displacement from the host's velocities less displacement from its positions, summed over the flight [m]. */
    double inconsistency_enu_m[3];
    /**
     * Largest difference, in one interval, between the displacement from the host's velocities and the displacement from its
     * positions [m].
     */
    double inconsistency_max_m;
    /** Number of samples flagged SINS_NAVIGATION_INCONSISTENT. */
    uint64_t inconsistent_samples;
    /** Number of intervals flown since the start or the last reposition. */
    uint64_t intervals;
    /**
     * Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the angular rate, later than ten times closed_loop_time_s after the
     * start [rad/s]. It shows the error of the signal generator and the mechanization themselves. 0 with physical signals.
     */
    double trim_rate_max_rad_s;
    /** Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the specific force, likewise [m/s2]. */
    double trim_force_max_m_s2;
} sins_accuracy;

/**
 * Reads the running accuracy figures.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_get_accuracy(sins_sim *sim, sins_accuracy *accuracy);

/**
 * Extreme values of the true motion over all intervals since the create or the last sins_reset(). Wrong units and exchanged
 * axes give values that no vehicle has, so these figures reveal them. Attitudes in degrees turn 57 times too fast, and give
 * arbitrary sideslips. Exchanged east and north give a sideslip, and velocities that contradict the positions. Knots instead
 * of m/s contradict the positions too. Feet instead of metres give heights and climbs 3.3 times too large. Accelerations are
 * means from one sample to the next. So are rates and forces, unless the samples carry them; then they are the values at the
 * samples. Each ..._at_s is the time stamp of the sample at which the value was found. A judge (sins_judge_create() in sins_flight.h)
 * draws the conclusions.
 */
typedef struct sins_truth_summary {
    /** sizeof(sins_truth_summary) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Number of intervals flown. */
    uint64_t intervals;
    /** Number of intervals that are gaps (see SINS_GAP). */
    uint64_t gaps;
    /** Number of samples with a speed of more than 30 m/s. Sideslip and angle of attack are taken from these only. */
    uint64_t fast_samples;
    /** Sum of the lengths of the intervals [s]. */
    double flown_s;
    /** Time stamp of the first sample [s]. */
    double first_s;
    /** Time stamp of the last sample [s]. */
    double last_s;
    /** Longest interval [s]. */
    double interval_max_s;
    /** Time stamp of interval_max_s [s]. */
    double interval_max_at_s;
    /** Largest rotation in an interval [rad]. */
    double turn_max_rad;
    /** Time stamp of turn_max_rad [s]. */
    double turn_max_at_s;
    /** Largest angular rate: from the attitudes against the Earth, or the samples' own rate [rad/s]. */
    double rate_max_rad_s;
    /** Time stamp of rate_max_rad_s [s]. */
    double rate_max_at_s;
    /** Largest acceleration against the Earth, from the velocities [m/s2]. */
    double acceleration_max_m_s2;
    /** Time stamp of acceleration_max_m_s2 [s]. */
    double acceleration_max_at_s;
    /** Largest specific force: from the velocities and gravity, or the samples' own force [m/s2]. */
    double force_max_m_s2;
    /** Time stamp of force_max_m_s2 [s]. */
    double force_max_at_s;
    /**
     * Largest difference, in one interval, between the displacement from the positions and the displacement from the
     * velocities (the mean of the velocities at the two ends, times the length of the interval) [m].
     */
    double inconsistency_max_m;
    /** Time stamp of inconsistency_max_m [s]. */
    double inconsistency_max_at_s;
    /** Largest speed against the Earth [m/s]. */
    double speed_max_m_s;
    /** Time stamp of speed_max_m_s [s]. */
    double speed_max_at_s;
    /**
     * Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth, positive to the right;
     * includes wind [rad].
     */
    double sideslip_max_rad;
    /** Time stamp of sideslip_max_rad [s]. */
    double sideslip_max_at_s;
    /**
     * Angle of attack of the largest size, from the velocity against the Earth up to the forward axis, in the plane of
     * symmetry [rad].
     */
    double attack_max_rad;
    /** Time stamp of attack_max_rad [s]. */
    double attack_max_at_s;
    /** Lowest height [m]. */
    double height_min_m;
    /** Time stamp of height_min_m [s]. */
    double height_min_at_s;
    /** Highest height [m]. */
    double height_max_m;
    /** Time stamp of height_max_m [s]. */
    double height_max_at_s;
} sins_truth_summary;

/**
 * Reads the extreme values of the true motion. sins_reposition() and sins_move_truth() do not restart them.
 *
 * SINS_NEED_SAMPLE: no interval yet.
 * SINS_ERROR_BAD_STATE: sins_options.truth_summary is off, or navigating on increments, without a truth.
 */
SINS_API sins_status SINS_CALL sins_get_truth_summary(sins_sim *sim, sins_truth_summary *summary);

/**
 * Covariance of the navigation errors over all runs of the flight, with its standard deviations and its error ellipse. The errors
 * are those of sins_errors: east, north, up of position [m], velocity [m/s] and misalignment [rad], in this order.
 *
 * The covariance is propagated along the truth with the linear error equations (error data 1). Both values of
 * sins_options.frame use the equations in Earth-fixed axes; the result is the same. The covariance is taken about the mean
 * error of all runs. It does not depend on the random numbers of this run, except for random drop-outs of the altimeter: it takes
 * those of this run. It contains: random initial errors; the misalignment that the alignment at the start derives from sensor
 * errors; turn-on biases, scale factors and misalignments; Gauss-Markov, flicker, rate random walk and white noise; the random
 * fields of gravity; the altimeter's Gauss-Markov error and noise; quantization, as white noise of the same variance; failures of
 * gyros and accelerometers: a dead or stuck sensor has no random errors, the noise of a failure is added, random drop-outs count
 * with their mean effect and the scatter of what they lose. It does not contain: constant errors, bias steps and spikes, which
 * change only the mean; the value that a stuck sensor holds; failures of the altimeter other than lost heights; dead zones and
 * ranges, which are not linear. One step of the propagation is one second of flight. A parameter that is set in flight takes effect
 * from the start of the current second, a failure by its share of this second. A second with at least one height of the altimeter
 * counts as aided throughout, so drop-outs shorter than a second have no effect on the covariance. The
 * standard deviations of the propagation are limited to 1e30 in SI units, so all outputs are finite.
 */
typedef struct sins_covariance {
    /** sizeof(sins_covariance) */
    uint32_t struct_size;
    /**
     * Flags of enum sins_errors_flags, or'ed: SINS_ERRORS_NEAR_POLE, SINS_ERRORS_WITHOUT_CORRECTIONS, and
     * SINS_ERRORS_OUTSIDE_VALIDITY if a standard deviation, or an error of this run, exceeds the limits of that flag, or if the mean
     * error by random drop-outs, over all runs, has exceeded them since the start.
     */
    int32_t flags;
    /** Time [s]. */
    double time_s;
    /** Covariance, 9 by 9, row by row. It is symmetric, and rounding cannot make a variance negative. */
    double covariance[81];
    /** Standard deviation of the position error [m]. */
    double position_sigma_enu_m[3];
    /** Standard deviation of the velocity error [m/s]. */
    double velocity_sigma_enu_m_s[3];
    /** Standard deviation of the misalignment [rad]. */
    double misalignment_sigma_enu_rad[3];
    /** Semi-major axis of the error ellipse (one standard deviation) of the horizontal position [m]. */
    double ellipse_major_m;
    /** Semi-minor axis of that ellipse [m]. */
    double ellipse_minor_m;
    /** Azimuth of the major axis, from north to the east, 0 up to pi [rad]. */
    double ellipse_azimuth_rad;
    /**
     * Radius of the circle that contains the horizontal error with a probability of 50 % [m]. The error has the normal
     * distribution of this ellipse, with the mean 0.
     */
    double cep50_m;
    /** Radius of the circle that contains the horizontal error with a probability of 95 % [m]. */
    double radial_95_m;
} sins_covariance;

/**
 * Reads the covariance of the navigation errors at the end of the last interval; before the first step, that of the start.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_BAD_STATE: sins_options.covariance is off, or navigating on increments.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: no INS can start at the first sample.
 */
SINS_API sins_status SINS_CALL sins_get_covariance(sins_sim *sim, sins_covariance *covariance);

/** Truth, navigation and both errors at one instant. */
typedef struct sins_record {
    /** sizeof(sins_record); in an array only that of the first element must be set. */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Time [s]. */
    double time_s;
    /** The truth, as sins_get_truth() gives it. */
    sins_record_solution truth;
    /** The navigated solution, as sins_get_navigation() gives it. */
    sins_record_solution navigation;
    /** Error data 2, as sins_get_errors() gives it with SINS_ERRORS_NAVIGATION. */
    sins_record_errors navigation_errors;
    /**
     * Error data 1, as sins_get_errors() gives it with SINS_ERRORS_MODEL; flagged SINS_ERRORS_NOT_COMPUTED while the model
     * is off.
     */
    sins_record_errors model_errors;
} sins_record;

/**
 * Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first sample.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 * SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_get_record(sins_sim *sim, sins_record *record);

/**
 * Writes a record as one line of comma-separated values, without the newline. The program sins writes its files of records
 * in this format. If record is NULL, the line has the names of the columns. The decimal numbers are exact: reading them
 * gives the same doubles. sensor_errors is an array of count = 6 numbers: x, y, z of the mean gyro error [rad/s], then x, y,
 * z of the mean accelerometer error [m/s2], since the previous record. NULL with count 0: all are 0. covariance adds columns
 * of standard deviations; NULL: none. buffer, capacity and needed as in sins_last_error(); a line has at most 1600 bytes.
 * No allocation.
 *
 * SINS_ERROR_INVALID_ARGUMENT: count is neither 6 nor 0.
 */
SINS_API sins_status SINS_CALL sins_record_line(const sins_record *record, const double *sensor_errors, size_t count,
    const sins_covariance *covariance, char *buffer, size_t capacity, size_t *needed);

/* Many samples in one call. */

/**
 * Pushes and steps an array of count samples. Writes a record after each `every` intervals, counted as in
 * sins_accuracy.intervals. There is no record for the first sample. Any split of a flight into calls gives the same bits and
 * the same records as pushing and stepping sample by sample.
 *
 * samples[0].struct_size is the size in bytes of each element of samples, records[0].struct_size that of each element of
 * records. struct_size of the other samples may be 0, that of the other records anything. every 0: no records. written (may
 * be NULL) gets the number of records that were written, also on an error.
 *
 * SINS_GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
 * if sins_options.truth_summary is on, sins_truth_summary.gaps is their number.
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the records that the call would make. Nothing is flown, and written
 * gets 0.
 * SINS_ERROR_BAD_STATE: navigating on increments.
 *
 * An error of sins_push_sample() or sins_step() ends the call at the sample that caused the error; sins_last_error() names
 * this sample. The samples before it were flown, this sample and the rest were not. sins_accuracy.intervals counts the flown
 * intervals. A sample that could be pushed but not flown waits in the queue, as after sins_step(); sins_reposition() and
 * sins_reset() empty the queue.
 *
 * ```c
 * sins_flight_sample minute[61];
 * sins_record records[6];
 * sins_sim *still = NULL;
 * size_t k, written = 0;
 * SINS_INIT(records[0]);
 * for (k = 0; k <= 60; k++) {
 *     SINS_INIT(minute[k]);
 *     minute[k].time_s = (double)k;
 * }
 * sins_create(NULL, &still);
 * sins_run(still, minute, 61, 10, records, 6, &written);
 * printf("%d records\n", (int)written);  // 6 records
 * sins_destroy(still);
 * ```
 */
SINS_API sins_status SINS_CALL sins_run(sins_sim *sim, const sins_flight_sample *samples, size_t count, size_t every,
    sins_record *records, size_t capacity, size_t *written);

/* Failures of sensors. */

/** Sensors that can fail. */
typedef enum sins_sensor {
    /** The gyros. */
    SINS_SENSOR_GYRO = 0,
    /** The accelerometers. */
    SINS_SENSOR_ACCEL = 1,
    /** The altimeter. Give 0 for the argument axis. */
    SINS_SENSOR_ALTIMETER = 2
} sins_sensor;

/** Kinds of failure. */
typedef enum sins_failure_kind {
    /** No failure: clears the failure that is set. */
    SINS_FAILURE_NONE = 0,
    /**
     * The output stays at its mean over the interval before the failure, as sins_imu reported it; without such an interval, at
     * its first value. It is not flagged, because it looks like valid data.
     */
    SINS_FAILURE_STUCK = 1,
    /**
     * No signal. A gyro or an accelerometer gives 0, and is flagged SINS_IMU_..._INVALID, as by a built-in test. Without the
     * altimeter nothing stabilizes the vertical channel of SINS_VERTICAL_DAMPED; this is flagged
     * SINS_NAVIGATION_VERTICAL_UNAIDED.
     */
    SINS_FAILURE_DEAD = 2,
    /** An additional bias; its value is in the field `size`. Not flagged. */
    SINS_FAILURE_BIAS_STEP = 3,
    /**
     * Rectangular pulses. The field `size` is their height, duration_s their length. A pulse starts every interval_s; the first
     * starts immediately. A sample of the altimeter shows the mean of the pulses over the sample interval. A gyro or an
     * accelerometer is flagged only if a pulse saturates it.
     */
    SINS_FAILURE_SPIKES = 4,
    /**
     * Additional white noise; its density is in the field `density`. A sample of the altimeter shows the mean of the noise over
     * the sample interval. Not flagged.
     */
    SINS_FAILURE_NOISE = 5,
    /**
     * Sample intervals are lost: in each of them the output acts as with SINS_FAILURE_DEAD. Either each interval is lost
     * independently with the probability in the field `probability`, or one interval is lost every interval_s, the first
     * immediately.
     */
    SINS_FAILURE_DROP_OUTS = 6
} sins_failure_kind;

/**
 * A failure of one output of a sensor. All zero is no failure. Fields that the kind does not use must be 0. The unit u is
 * rad/s for a gyro, m/s2 for an accelerometer, m for the altimeter.
 */
typedef struct sins_failure {
    /** sizeof(sins_failure) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Kind of the failure, of enum sins_failure_kind. */
    int32_t kind;
    /** Must be 0. */
    uint32_t reserved2;
    /** Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the altimeter [u]. */
    double size;
    /**
     * Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the altimeter
     * [u sqrt(s)].
     */
    double density;
    /**
     * Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for drop-outs with a
     * probability.
     */
    double interval_s;
    /** Spikes: length of one spike, 1e-9 s to interval_s [s]. */
    double duration_s;
    /** Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1. */
    double probability;
} sins_failure;

/**
 * Sets a failure of one output, as an instructor's station does: before the first sample or in flight, from the next
 * interval on. It lasts until SINS_FAILURE_NONE clears it, or another failure of the same output replaces it. Several
 * outputs may fail at the same time.
 *
 * sensor is of enum sins_sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before dead
 * zone, range and quantization. SINS_FAILURE_STUCK, SINS_FAILURE_DEAD and SINS_FAILURE_DROP_OUTS replace the output. The
 * random numbers of other effects do not change. Sensor processes continue during a failure, and act on the output again
 * when it is cleared. A failure acts on error data 1 and on error data 2. It does not act on the alignment at the start.
 * sins_reposition() keeps failures. sins_reset() clears all failures, so an exercise starts again with working sensors;
 * failures that are set again at the same intervals give the same bits.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. If a failure makes the
 * solution diverge, sins_step() returns SINS_ERROR_DIVERGED.
 */
SINS_API sins_status SINS_CALL sins_set_failure(sins_sim *sim, int32_t sensor, int32_t axis,
    const sins_failure *failure);

/**
 * Reads the failure of one output. May be called at any moment. After sins_snapshot_load() it is that of the snapshot.
 * SINS_FAILURE_NONE: the output has no failure. sensor and axis as in sins_set_failure().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such output.
 */
SINS_API sins_status SINS_CALL sins_get_failure(sins_sim *sim, int32_t sensor, int32_t axis, sins_failure *failure);

/* Start, mounting, gravity; presets of sensors and start. */

/** How the INS finds its attitude at the start. */
typedef enum sins_alignment {
    /** The INS starts with the true attitude, turned by the given and the drawn misalignment. */
    SINS_ALIGNMENT_GIVEN = 0,
    /**
     * The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
     * start. It does so even if the flight starts in motion. A vehicle that then is tilted by more than 10 degrees was level, with the
     * heading that it has. The INS starts with this attitude, turned by the given and the
     * drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense the reaction to normal gravity. At
     * height this is not quite along the ellipsoid's normal: its horizontal part is 7.5 micro-g at 9 km and 45 degrees.
     * Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
     * if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
     */
    SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS = 1,
    /**
     * The library computes the attitude that levelling at rest would find with the sensor errors at the start, with the true heading:
     * the heading of a unit whose gyros cannot find north comes from another sensor. The INS starts with this attitude, turned by the
     * given and the drawn misalignment, whose part about up is the heading error. Any latitude.
     */
    SINS_ALIGNMENT_LEVEL = 2
} sins_alignment;

/**
 * Errors with which the navigation starts: computed less true, east-north-up. Random errors with the standard deviations
 * (sigma) are drawn once a run and added. A reset and a reposition use the same random numbers again. With
 * SINS_VERTICAL_FOLLOW_TRUTH the errors of height and vertical velocity start at 0.
 */
typedef struct sins_initial_errors {
    /** sizeof(sins_initial_errors) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /**
     * Position error, east-north-up [m], -1e6 to 1e6. The horizontal part is laid off at the height of the
     * solution, and sins_errors measures it at the height of the truth: with an error of 100 m in height, 3 km read
     * back 0.046 m larger.
     */
    double position_enu_m[3];
    /** Velocity error, east-north-up [m/s], -10000 to 10000. */
    double velocity_enu_m_s[3];
    /**
     * Misalignment phi, a rotation vector, east-north-up [rad], -pi to pi. Computed C = exp(-[phi x]) C0. C turns
     * vectors from sensor axes to east-north-up. C0 is the true C. With SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS or
     * SINS_ALIGNMENT_LEVEL, C0 is the C that the alignment finds.
     */
    double misalignment_enu_rad[3];
    /** Standard deviation of the position error [m], 0 to 1e5. */
    double position_sigma_enu_m[3];
    /** Standard deviation of the velocity error [m/s], 0 to 1000. */
    double velocity_sigma_enu_m_s[3];
    /** Standard deviation of the misalignment [rad], 0 to 1. */
    double misalignment_sigma_enu_rad[3];
    /** Alignment at the start, of enum sins_alignment. */
    int32_t alignment;
    /** Must be 0. */
    uint32_t reserved2;
    /**
     * Length of the alignment, at rest before the first sample [s], 1 to 86400; 0: without end. Tilt is found from
     * the mean specific force, heading from the mean rate: white noise and quantization are averaged over this time,
     * and Gauss-Markov, flicker, random walk and ramp errors have their mean of this time. Dead zone and range act
     * on the mean. The temperature is that of the first sample. The flight begins with the states with which the
     * alignment ended: ramps and random walks begin at 0 when the alignment begins. An alignment without end leaves
     * out white noise and quantization, and takes the errors at the first sample for their mean. A reposition aligns
     * again, from the present states of the sensors. SINS_ALIGNMENT_GIVEN does not use it.
     */
    double alignment_s;
} sins_initial_errors;

/**
 * Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition until
 * the next step. After a reposition they apply to the start at its sample.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_initial_errors(sins_sim *sim, const sins_initial_errors *errors);

/**
 * Reads the set errors with which the navigation starts. May be called at any moment. After sins_snapshot_load() they are
 * those of the snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_initial_errors(sins_sim *sim, sins_initial_errors *errors);

/**
 * Position and attitude of the sensor block relative to the reference point of the flight samples, and the errors of what
 * the INS believes about them: believed = true + error, component by component. All zero is a block at the reference
 * point, along the body axes.
 *
 * The ideal sensors measure the motion of the block, and sensor errors act in the axes of the block: sins_imu describes
 * the block. The INS navigates the block, and converts its solution to the reference point with the mounting that it
 * believes: sins_navigation and sins_errors describe the reference point. Initial errors apply to the solution for the
 * block, so at the start sins_errors can differ from them. Angular rate and specific force of a sample are those of the
 * reference point, along body axes. The barometric height is that of the reference point too.
 *
 * Start in motion: at the start of a moving flight, and after a reposition, samples without an angular rate do not show
 * the angular acceleration of the first interval. The specific force of a block away from the reference point then lacks
 * the term angular acceleration times lever arm. In the second interval this term is correct to first order in the
 * interval's length, in the third to second order, later to third order. The navigation is not affected, because the INS
 * starts with the velocity that the block has at the mean angular rate of the first interval. With SINS_SAMPLE_ANGULAR_RATE
 * no term is missing.
 */
typedef struct sins_mounting {
    /** sizeof(sins_mounting) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /**
     * Lever arm from the reference point to the block, body axes [m], -100 to 100. sins_options.axes describes the
     * body axes.
     */
    double lever_arm_m[3];
    /**
     * Roll, pitch, heading of the block [rad], -10000 to 10000. This is the boresight: the angles of the block's
     * axes relative to the body axes. They are defined like the attitude angles of the body: positive roll right
     * side down, positive pitch nose up, positive heading nose to the right. Whole turns do not matter.
     */
    double boresight_rad[3];
    /** Believed less true lever arm [m], -100 to 100. */
    double lever_arm_error_m[3];
    /**
     * Believed less true roll, pitch, heading [rad], -pi to pi. If the believed heading is too large, the heading
     * that the INS reports is too small by the same amount.
     */
    double boresight_error_rad[3];
} sins_mounting;

/**
 * Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the next
 * step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its solution is
 * that of the block.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_mounting(sins_sim *sim, const sins_mounting *mounting);

/**
 * Reads the mounting of the sensor block that is set. May be called at any moment. After sins_snapshot_load() it is that of
 * the snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_mounting(sins_sim *sim, sins_mounting *mounting);

/**
 * Gravity disturbance: true gravity less the normal gravity that the INS computes, at the same point. The horizontal part is
 * the deflection of the vertical. The vertical part is called anomaly here. Each has a constant part and a random part. The
 * random part is a first-order Gauss-Markov field along the track: correlation sigma^2 exp(-d/D) over the distance d flown
 * over ground; D is the correlation distance. At rest it does not change. All zero is normal gravity.
 *
 * Perfect accelerometers measure the disturbance, so it is in the ideal signals of sins_imu. In the INS it acts like an
 * accelerometer error. At rest, without a levelled start, a deflection xi makes the position error oscillate between 0 and 2
 * R xi, where R is the Earth's radius. A levelled start (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) is tilted by the deflection.
 */
typedef struct sins_gravity_params {
    /** sizeof(sins_gravity_params) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /**
     * Deflection in the meridian (xi) [rad], -0.01 to 0.01. It is the astronomic less the geodetic latitude. If
     * positive, the true zenith lies north of the ellipsoid's normal, and the accelerometers at rest measure g times
     * this to the north.
     */
    double deflection_north_rad;
    /** Standard deviation of the random part of the deflection in the meridian [rad], 0 to 0.01. */
    double deflection_north_sigma_rad;
    /**
     * Correlation distance of the random part of the deflection in the meridian [m], 1 to 1e9; needed where
     * deflection_north_sigma_rad is not 0.
     */
    double deflection_north_distance_m;
    /**
     * Deflection in the prime vertical (eta) [rad], -0.01 to 0.01. It is the astronomic less the geodetic
     * longitude, times the cosine of latitude. If positive, the true zenith lies east of the ellipsoid's normal.
     */
    double deflection_east_rad;
    /** Standard deviation of the random part of the deflection in the prime vertical [rad], 0 to 0.01. */
    double deflection_east_sigma_rad;
    /**
     * Correlation distance of the random part of the deflection in the prime vertical [m], 1 to 1e9; needed where
     * deflection_east_sigma_rad is not 0.
     */
    double deflection_east_distance_m;
    /** Anomaly, excess of gravity [m/s2], -0.1 to 0.1. A milligal is 1e-5 m/s2. */
    double anomaly_m_s2;
    /** Standard deviation of the random part of the anomaly [m/s2], 0 to 0.1. */
    double anomaly_sigma_m_s2;
    /**
     * Correlation distance of the random part of the anomaly [m], 1 to 1e9; needed where anomaly_sigma_m_s2 is not
     * 0.
     */
    double anomaly_distance_m;
} sins_gravity_params;

/**
 * Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset or a
 * reposition until the next step. A reset brings the same field back; after a reposition the field continues from its
 * current values. The disturbance does not affect a navigator on increments, because the host's increments already contain
 * its effect.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: steps have been made.
 */
SINS_API sins_status SINS_CALL sins_set_gravity_disturbance(sins_sim *sim, const sins_gravity_params *params);

/**
 * Reads the parameters of the gravity disturbance that are set. May be called at any moment. After sins_snapshot_load() they
 * are those of the snapshot.
 */
SINS_API sins_status SINS_CALL sins_get_gravity_disturbance(sins_sim *sim, sins_gravity_params *params);

/** Grades of sensors. */
typedef enum sins_grade {
    /**
     * Strategic: gyro bias 0.001 deg/h and accelerometer bias 1e-6 g, each 1 sigma (El-Sheimy and Youssef 2020, table 1, upper
     * ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix 200). The table states 30 to 100 m/h
     * for this grade, which holds in straight flight. In turns the scale factor dominates. From a perfect start, the CEP after an hour is
     * 190 m on the built-in racetrack, and 35 m without the scale factor error. On the built-in patrol it is 1.6 km and 38 m.
     */
    SINS_GRADE_STRATEGIC = 1,
    /** Navigation: Honeywell HG9900, brochure N61-1638. It states no accelerometer noise, so the preset has none: set your own. */
    SINS_GRADE_NAVIGATION = 2,
    /** Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated. */
    SINS_GRADE_TACTICAL = 3,
    /**
     * Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D. It states no accelerometer noise, so the preset
     * has none: set your own. The range of the sensors is 125 deg/s and 8 g; the angle between two axes differs from 90 deg by
     * 0.1 deg, 1 sigma.
     */
    SINS_GRADE_INDUSTRIAL = 4,
    /** Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances are taken as 3 sigma. */
    SINS_GRADE_CONSUMER = 5,
    /**
     * The paper's simulation 2: constant gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), constant accelerometer
     * bias 1e-5 g and white noise 5e-6 g, taken as a density of 5e-6 g/sqrt(Hz) (for a bandwidth of 1 Hz, because the paper
     * states none).
     */
    SINS_GRADE_PAPER_SIMULATION2 = 6
} sins_grade;

/**
 * Fills params with the gyro errors of a grade, of enum sins_grade. Biases, scale factor errors and misalignments are
 * drawn at turn-on with the standard deviations that the source of the grade states; errors that it does not state are 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such grade.
 */
SINS_API sins_status SINS_CALL sins_gyro_preset(int32_t grade, sins_gyro_params *params);

/**
 * Fills params with the accelerometer errors of a grade, as sins_gyro_preset().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such grade.
 */
SINS_API sins_status SINS_CALL sins_accel_preset(int32_t grade, sins_accel_params *params);

/**
 * Fills errors with the errors of the start of a grade. The position is that of GPS: 8 m horizontally and 13 m vertically, 95 %
 * (Standard Positioning Service Performance Standard, 2020). Strategic and navigation grade level and gyrocompass for 10 minutes
 * (Boeing 737 MAX: 5 to 17 minutes). The other grades level for 30 s, and their heading is that of a magnetic compass, 1 sigma:
 * tactical 1 deg (Caruso, Honeywell), industrial 2 deg, consumer 4 deg (Tomasch and Winer 2018). The paper states no errors of
 * the start: all are 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such grade.
 */
SINS_API sins_status SINS_CALL sins_initial_preset(int32_t grade, sins_initial_errors *errors);

/* Navigation on increments, without a truth. */

/**
 * Increments of an inertial measurement unit over an interval. The interval is divided into parts of equal length; the
 * field count is their number.
 */
typedef struct sins_imu_increment {
    /** sizeof(sins_imu_increment) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Length of the whole interval, 5e-5 to 10 [s]. */
    double interval_s;
    /** Number of parts, 1 to 5. */
    int32_t count;
    /** Must be 0. */
    uint32_t reserved2;
    /**
     * Integral of the angular rate against inertial space over each part: x, y, z of the first part, x, y, z of the second
     * part, and so on [rad]. The rotation in each part, and in the interval, must be less than half a turn.
     */
    double angle_rad[15];
    /** Integral of the specific force over each part, up to 1e4 m/s, likewise [m/s]. */
    double velocity_m_s[15];
} sins_imu_increment;

/**
 * Reads the increments on which the INS navigated in one update of the last interval: those of the modelled sensors, after the
 * compensation of sins_correct().
 * The argument update counts the updates of the interval from 0. Their number is sins_options.updates_per_sample, or more in an
 * interval of several periods. Each update has sins_options.subsamples parts; its interval_s is the interval divided by the
 * number of updates. A navigator of the host that gets all updates of each interval by sins_push_imu() has the solution of the INS
 * to the last bit, if the INS had no errors at the start, no mounting, SINS_VERTICAL_FREE, SINS_SIGNAL_PHYSICAL and no gravity
 * disturbance, and the navigator started from sins_get_truth() before the first step. With errors at the start it starts from
 * sins_get_navigation(), whose angles are rounded. With a mounting the parts are the signals of the sensor block. The parts do
 * not contain the aid of the vertical channel. sins_push_imu() rejects updates shorter than 5e-5 s.
 *
 * SINS_NEED_SAMPLE: the last interval has no such update, or there is none: before the first step, and while the simulator navigates on
 * increments.
 * SINS_ERROR_INVALID_ARGUMENT: update is negative.
 *
 * ```c
 * int update;
 * sins_imu_increment increment;
 * SINS_INIT(increment);
 * for (update = 0; sins_get_imu_update(sim, update, &increment) == SINS_OK; ++update) {
 *     printf("%d parts of %g s\n", increment.count, increment.interval_s);  // 2 parts of 1 s
 * }
 * ```
 */
SINS_API sins_status SINS_CALL sins_get_imu_update(sins_sim *sim, int32_t update, sins_imu_increment *increment);

/**
 * Starts the simulator as a navigator only: it navigates on the increments of sins_push_imu(). The argument navigation
 * gives the start: time, position, velocity and attitude (quaternion_nb; the angles and the flags are not read). Ranges are
 * those of a flight sample; the norm of the quaternion must be 1 within 1e-3. Initial errors that are set do not apply.
 * There is no truth: the vertical channel is free, and flagged so, and the reads of errors and accuracy return
 * SINS_ERROR_BAD_STATE until sins_reset().
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: samples were pushed, or the navigator was started before (call sins_reset() first); or temperature
 * coefficients are set, but increments have no temperature.
 * SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
 */
SINS_API sins_status SINS_CALL sins_start_navigation(sins_sim *sim, const sins_navigation *navigation);

/**
 * Navigates over one interval on the host's increments. Sensor errors that are set are added to the increments. The time
 * advances by interval_s. sins_get_imu() reports the host's increments as the ideal ones. sins_options.subsamples and
 * updates_per_sample do not apply: the parts of the increment are the subsamples of one update.
 *
 * SINS_ERROR_BAD_STATE: sins_start_navigation() was not called.
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a rotation of half a turn or more in a part or in the interval.
 * SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_step(); the interval is not flown, the solution before it stays
 * readable, and sins_reset() and sins_start_navigation() start anew.
 */
SINS_API sins_status SINS_CALL sins_push_imu(sins_sim *sim, const sins_imu_increment *increment);

/* Corrections by the host. */

/**
 * Errors that the host estimated, for example with a Kalman filter or by a fix, and that the INS removes. All zero, the default,
 * changes nothing.
 *
 * The first three fields are errors of the solution, in the definitions of sins_errors: a sins_errors that is copied into them
 * leaves no error but rounding. They may have any size within their limits. The other fields are errors of the sensors, along the
 * sensor axes. They are added to the compensation in force, which sins_get_compensation() reads. From the next interval on the
 * INS navigates on compensated increments: (measured - bias * time) / (1 + scale factor), axis by axis. The sums must stay within
 * 100 rad/s, 1e4 m/s2, and 0.5 for scale factors.
 */
typedef struct sins_correction {
    /** sizeof(sins_correction) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /**
     * Position error: displacement along true east and north, and difference of heights, -1e6 to 1e6 [m]. The true place is
     * the corrected one. Near a pole two places can have this displacement; that which turns the attitude less is taken.
     */
    double position_enu_m[3];
    /** Velocity error, -1e4 to 1e4 [m/s]. */
    double velocity_enu_m_s[3];
    /** Misalignment phi, a rotation vector, each -pi to pi [rad]. */
    double misalignment_enu_rad[3];
    /** Gyro bias, added to the compensation in force [rad/s]. */
    double gyro_bias_rad_s[3];
    /** Scale factor error of the gyros, added to the compensation in force [1]. */
    double gyro_scale_factor[3];
    /** Accelerometer bias, added to the compensation in force [m/s2]. */
    double accel_bias_m_s2[3];
    /** Scale factor error of the accelerometers, added to the compensation in force [1]. */
    double accel_scale_factor[3];
} sins_correction;

/** Compensation of the measured increments in force: the sum of all corrections since the start. */
typedef struct sins_compensation {
    /** sizeof(sins_compensation) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Gyro bias [rad/s]. */
    double gyro_bias_rad_s[3];
    /** Scale factor error of the gyros [1]. */
    double gyro_scale_factor[3];
    /** Accelerometer bias [m/s2]. */
    double accel_bias_m_s2[3];
    /** Scale factor error of the accelerometers [1]. */
    double accel_scale_factor[3];
} sins_compensation;

/**
 * Removes errors that the host estimated. May be called between any two steps, and between the calls of sins_push_imu(). The
 * solution, its errors and error data 1 are corrected at once. The truth, the modelled sensors and their random numbers do not
 * change, and the loop of the vertical channel keeps its state. With a mounting the errors are those of the reference point, as
 * in sins_errors. A reposition, a reset and sins_start_navigation() begin without a compensation. No allocation, no system call.
 *
 * The covariance of sins_get_covariance() remains that of an INS without corrections: SINS_ERRORS_WITHOUT_CORRECTIONS.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value or a sum out of its range; or, within the position error of a pole, no place has this
 * displacement.
 * SINS_ERROR_BAD_STATE: no step was made yet.
 * SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: the corrected solution would be beyond the limits of sins_step(). After any error
 * nothing has changed.
 *
 * ```c
 * sins_correction correction;
 * int axis;
 * SINS_INIT(correction);
 * for (axis = 0; axis < 3; ++axis) correction.position_enu_m[axis] = errors.position_enu_m[axis];
 * sins_correct(sim, &correction);
 * sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors);
 * printf("%.2f nmi north\n", errors.position_enu_m[1] / SINS_NMI);  // 0.00 nmi north
 * ```
 */
SINS_API sins_status SINS_CALL sins_correct(sins_sim *sim, const sins_correction *correction);

/** Reads the compensation in force. It is zero before the first step. After sins_snapshot_load() it is that of the snapshot. */
SINS_API sins_status SINS_CALL sins_get_compensation(sins_sim *sim, sins_compensation *compensation);

/* Snapshots. */

/**
 * A buffer of this size holds every snapshot of a simulator that this release saves. For a library newer than this header
 * ask sins_snapshot_size(); for an ensemble ask sins_ensemble_snapshot_size().
 */
#define SINS_SNAPSHOT_MAX_SIZE 24576

/**
 * Reads the size that a snapshot has now. It changes with what is set and with the number of waiting samples. These sizes
 * are without waiting samples. Without sensor errors it is 1.3 to 2.1 KiB, by the options. With every error of gyros,
 * accelerometers and altimeter it is up to 4.5 KiB. With mounting, gravity, temperature and failures too it is up to 5.25
 * KiB. Each waiting sample adds up to 154 bytes, and sins_options.covariance up to 9.2 KiB.
 */
SINS_API sins_status SINS_CALL sins_snapshot_size(sins_sim *sim, size_t *size);

/**
 * Saves the whole simulator, at any moment: options, parameters, waiting samples, the state of every stage, and the position
 * of each random stream. written (may be NULL) gets the size. The bytes mean the same on every platform and hold no address,
 * so they can be kept in a file or sent to another machine. The same state gives the same bytes. No allocation, no system
 * call.
 *
 * Not saved: handles, and the sentence of sins_last_error(). After SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR the last
 * good solution is saved. After SINS_ERROR_INTERNAL nothing can be saved: load an earlier snapshot into a fresh handle.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see sins_snapshot_size(); buffer and written are unchanged.
 *
 * ```c
 * static unsigned char frozen[SINS_SNAPSHOT_MAX_SIZE];
 * size_t size = 0;
 * sins_snapshot_save(sim, frozen, sizeof frozen, &size);
 * sins_reset(sim);
 * sins_snapshot_load(sim, frozen, size);
 * sins_get_navigation(sim, &navigation);
 * printf("back at %.0f s\n", navigation.time_s);  // back at 3601 s
 * ```
 */
SINS_API sins_status SINS_CALL sins_snapshot_save(sins_sim *sim, void *buffer, size_t capacity, size_t *written);

/**
 * Replaces the simulator by the saved one, including its options (see sins_get_options()). So a fresh handle of
 * sins_create(NULL, ...) is enough. The run continues to the same bits as the saved one. size is the size that
 * sins_snapshot_save() wrote. Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are not a snapshot, or are cut off, altered, or of a newer release; nothing has changed,
 * and sins_last_error() says which it is. Later releases read the snapshots of earlier ones; the run continues to the same
 * bits unless CHANGELOG says that the algorithms changed.
 * SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
 */
SINS_API sins_status SINS_CALL sins_snapshot_load(sins_sim *sim, const void *snapshot, size_t size);

/** Sizes of the structs in bytes, the same on every platform. In languages other than C, set struct_size to these values. */
enum sins_sizeof {
    SINS_SIZEOF_OPTIONS = 104,
    SINS_SIZEOF_FLIGHT_SAMPLE = 144,
    SINS_SIZEOF_ERROR_INFO = 152,
    SINS_SIZEOF_GYRO_PARAMS = 736,
    SINS_SIZEOF_ACCEL_PARAMS = 736,
    SINS_SIZEOF_ALTIMETER_PARAMS = 56,
    SINS_SIZEOF_NAVIGATION = 128,
    SINS_SIZEOF_ERRORS = 144,
    SINS_SIZEOF_IMU = 264,
    SINS_SIZEOF_ACCURACY = 256,
    SINS_SIZEOF_TRUTH_SUMMARY = 232,
    SINS_SIZEOF_COVARIANCE = 776,
    SINS_SIZEOF_RECORD_SOLUTION = 112,
    SINS_SIZEOF_RECORD_ERRORS = 128,
    SINS_SIZEOF_RECORD = 496,
    SINS_SIZEOF_FAILURE = 56,
    SINS_SIZEOF_INITIAL_ERRORS = 168,
    SINS_SIZEOF_MOUNTING = 104,
    SINS_SIZEOF_GRAVITY_PARAMS = 80,
    SINS_SIZEOF_IMU_INCREMENT = 264,
    SINS_SIZEOF_CORRECTION = 176,
    SINS_SIZEOF_COMPENSATION = 104
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_H */
