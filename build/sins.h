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

@version

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

@failure

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

@sample options simulator

/* Why a call failed. */

@last_error

/* Sensor errors. */

@sensor_params altimeter_params

/* Reads. */

@solution errors imu accuracy truth_summary covariance record

/* Many samples in one call. */

@run

/* Failures of sensors. */

@sensor_failure

/* Start, mounting, gravity; presets of sensors and start. */

@sins_alignment initial_params mounting_params gravity_params preset

/* Navigation on increments, without a truth. */

@navigator

/* Corrections by the host. */

@correction

/* Snapshots. */

@snapshot

/** Sizes of the structs in bytes, the same on every platform. In languages other than C, set struct_size to these values. */
enum sins_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_H */
