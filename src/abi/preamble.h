/*
 * sins.h - strapdown inertial navigation system (SINS) simulator, C interface.
 *
 * The host gives the truth as flight samples (position, velocity, attitude). The library computes from them what perfect gyros
 * and accelerometers would measure, adds the sensor errors that are set, navigates on the result, and reports the errors of
 * that navigation:
 *
 *   sins_sim *sim = NULL;
 *   sins_create(NULL, &sim);                       recommended options; the error model is off
 *   sins_set_gyro(sim, &gyro);                     errors of the gyros; without this call they are ideal
 *   while (...) {
 *       sins_push_sample(sim, &sample);            one sample of the flight simulator
 *       if (sins_step(sim) == SINS_OK)             one interval; after the first sample: SINS_NEED_SAMPLE
 *           sins_get_navigation(sim, &navigation);
 *   }
 *   sins_destroy(sim);
 *
 * Structs. A parameter of 0 is off, or has the default that its comment gives, such as "0: 2.5 s". (In a flight sample 0 is a
 *   value.) Every struct (except the parts of a sins_record) begins with struct_size, which the caller sets to the sizeof of
 *   the struct, and a second 32-bit integer, which is 0 unless its comment says otherwise. So "sins_gyro_params gyro = { sizeof
 *   gyro };" is an ideal gyro. SINS_INIT(gyro) sets the same content. Use it if your compiler warns of missing initializers.
 *   The caller sets struct_size of output structs too. Structs grow only at their end, so old hosts run on new libraries, and
 *   new hosts on old libraries. A newer host may pass a struct with fields that an older library does not know. In an output
 *   struct the library leaves these fields unchanged. In an input struct they must be 0, or the call returns
 *   SINS_ERROR_STRUCT_SIZE.
 * Units are SI and radians, as the name of each field says. The macros below convert the units of data sheets:
 *   gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR.
 * Constants are enumerations. Fields and arguments hold them as 32-bit integers, whose size does not depend on the compiler.
 * Frames. Navigation axes are east-north-up. Roll is positive right wing down, pitch nose up, heading clockwise from true
 *   north; the rotation sequence is heading, pitch, roll (aerospace). Body axes are right-forward-up, or forward-right-down by
 *   sins_options.axes. Sensor axes are the axes of the sensor block: the body axes, unless sins_mounting sets a boresight.
 *   Latitude is geodetic, height is above the ellipsoid.
 * Errors. A function that can fail returns a sins_status, and gives data through pointers. A function that cannot fail returns
 *   its value directly.
 *   After an error nothing has changed: no state, no output, and no random number was drawn. (Exceptions: after
 *   SINS_ERROR_INTERNAL the handle cannot be used any more. sins_run() and sins_ensemble_run() keep the intervals that they
 *   flew before the error; sins_run() also keeps their records, and sets written. If a buffer is too small, functions that
 *   write a text cut it and report the size that is needed; sins_error_budget() and sins_scene_get_manoeuvres() report the
 *   number of elements that is needed. sins_log_parse(), sins_scene_set_values() and sins_scene_set_items() report faults.)
 *   Every function with a pointer argument can return SINS_ERROR_NULL_POINTER, every function with a handle
 *   SINS_ERROR_BAD_HANDLE, and every function with a struct SINS_ERROR_STRUCT_SIZE. Every function that returns a status can
 *   return SINS_ERROR_INTERNAL. The other errors of a function are listed at the function. Threads and Unloading describe
 *   further causes of SINS_ERROR_BAD_STATE and SINS_ERROR_OUT_OF_MEMORY. A positive status is not an error. With
 *   SINS_NEED_SAMPLE the output is unchanged. With SINS_REQUIREMENT_NOT_MET the output is written. With SINS_SCENE_HAS_FAULTS a
 *   handle was made. With SINS_GAP the call did everything. Test for errors by status < 0. sins_last_error() gives a sentence
 *   that names field, value and limit. sins_last_error_info() gives the same as a struct, sins_status_string() the name of the
 *   status.
 * Threads. Any function may be called from any thread. Calls on one handle wait for each other; calls on different handles never
 *   do. A call takes less than 48 KB of stack, so a thread with a stack of 64 KB is enough.
 *   Nested calls: if a thread is inside a call on a handle, and calls another function with the same handle, the second call
 *     returns SINS_ERROR_BAD_STATE, and sins_last_error(NULL, ...) has the sentence. This happens to a signal handler that
 *     interrupted a call on that handle. A signal handler may call every function that takes a simulator, except those that use
 *     the allocator: sins_destroy(), sins_snapshot_load(), sins_ensemble_create(), sins_recommend() and sins_error_budget().
 *   Abandoned calls: a call does not return if siglongjmp() leaves it, or if its thread is cancelled or terminated. It then
 *     holds its handle for ever, and the memory of the handle is never freed. Further calls of its own thread with this handle
 *     return SINS_ERROR_BAD_STATE. Calls of other threads with this handle wait for ever. On Windows, if the thread of the
 *     abandoned call was terminated, these calls return SINS_ERROR_BAD_STATE instead. The first of them returns after 0.1 s. An
 *     abandoned call does not restore the host's floating-point state.
 *   fork(): if another thread of the parent is inside a call on a handle, every call on this handle in the child returns
 *     SINS_ERROR_BAD_STATE. All other handles work in the child. A process made in another way, such as by vfork() or clone(),
 *     must make no call.
 * Unloading. Destroy every handle first, and let every call return. On Windows, a DLL that was built for windows-gnu is never
 *   unloaded: FreeLibrary() succeeds, the DLL stays in memory, and LoadLibrary() gives the same module again. The same holds
 *   for a DLL that contains the static library. The reason: Rust never frees the three or four TLS indexes (thread-local
 *   storage) that it takes when the DLL is loaded. Load the library early, before other modules have used up the indexes. At
 *   the load eight indexes must be free, because a later Rust may take more. Otherwise functions without a handle return
 *   SINS_ERROR_OUT_OF_MEMORY until eight are free. If no index is free, Windows may abort the process when a thread or the
 *   process ends.
 * Real time. Push, step, run, the reads (except sins_record_line()), the setters, reset, reposition, sins_move_time(),
 *   sins_move_truth() and sins_snapshot_save() make no allocation and no system call, unless the handle is in use in another
 *   thread. This also holds for the same functions of ensembles, and for the functions of statistics. The library prints
 *   nothing, and reads no environment variable and no file. It leaves the host's floating-point control state and x87 registers
 *   as it found them.
 * Host time. The time in a run comes from the time stamps of its samples, or from sample_period_s if it is stated. The library
 *   reads a clock only in three places: sins_recommend() and sins_error_budget() measure computing times, and the first create
 *   draws handle numbers from the clock.
 *   Pause: simply make no calls while paused. A push of the same sample again returns SINS_ERROR_TIME_ORDER and changes
 *     nothing. If the host's clock stopped during the pause, there is nothing to do. If the clock ran on, call sins_move_time()
 *     before the next push. Give it the time that the clock shows at the end of the pause. The newest accepted sample gets this
 *     time stamp, and the next sample must be later. The flight then continues as if there had been no pause. Without that
 *     call, the first push after a pause of more than max_gap_s returns SINS_ERROR_DISCONTINUITY, and so does each later one. A
 *     shorter pause is flown as motion: the vehicle moves by its velocity times the length of the pause. The push after such a
 *     pause returns SINS_GAP if the interval is a gap.
 *   Gaps: an interval is a gap if it is more than 2.5 times each of the two before it. A gap of up to max_gap_s is flown on a
 *     smooth path between its two ends: velocity and rotation are cubic polynomials of time, with the values and derivatives at
 *     the ends. The mechanization updates in the gap are as long as before the gap. If this would need more than 80 subsamples
 *     (see sins_options), the updates are longer. Attitude and velocity are correct immediately after the gap. From then on the
 *     navigated position has an additional error: the difference between the true path and the assumed path. In steady flight
 *     this difference is 0. In a weave of 4 g with a period of 8 s, sampled at 100 Hz, it is 4 cm if 1 s is lost, and 3 m if
 *     2.5 s are lost. If the samples have no velocities, the error is larger: up to 5 n^2 times the error of a sample's
 *     position, where n is the number of lost intervals. If 1 s is lost in straight flight at 50 Hz, with positions accurate to
 *     1 cm, this bound is 125 m; the error in a test is 23 m. If such an error is too large, set a smaller max_gap_s: longer
 *     gaps are then rejected.
 *   Faster or slower than real time: give samples that are farther apart in simulated time (for example ten times the interval,
 *     up to max_gap_s) or closer together (down to 5e-5 s). If sample_period_s is 0, the spacing may change from one sample to
 *     the next. If it is stated, each spacing must be a whole number of periods. Each interval is integrated as a whole. So the
 *     accuracy depends on the actual sample rate. A turn of 170 degrees or more between two samples is rejected. The library
 *     scales the random sensor noise with the length of the interval, so the density of the noise stays the same. Two
 *     parameters do not depend on the length of the interval: noise_m of the altimeter applies to each sample, and the
 *     probability of drop-outs applies to each interval.
 *   Slew: sins_move_truth() moves the vehicle to another place, and keeps the errors of the INS. sins_reposition() starts the
 *     INS anew at a place and discards its errors: it is for a flight that is reloaded, not for a pause. sins_reset() repeats
 *     the flight with the same random numbers. sins_snapshot_load() returns to a saved moment.
 * Same bits. The same options, seed, samples and settings, each set before the same interval, give the same outputs bit for bit
 *   on every platform. Reads, and the way in which samples are split into calls, do not change them. The exceptions are times:
 *   ns_per_step of sins_cost, sins_budget and sins_budget_row. Each random effect has its own stream, so switching one effect
 *   on or off leaves the random numbers of all others unchanged.
 *
 * Scenes and logs. A scene describes a flight, the settings of the simulator, and the planned failures of the sensors. Its text
 *   form is TOML. A log is a flight as a table of samples, also as text. The host reads the files; the library parses their
 *   bytes:
 *
 *     sins_scene_parse(text, size, &scene);          SINS_SCENE_HAS_FAULTS: sins_scene_get_fault() gives each fault and its place
 *     sins_scene_create_simulator(scene, &sim);      options, sensor errors, initial errors, mounting, gravity disturbance
 *     sins_scene_create_flight(scene, &flight);      or sins_log_parse() of the file that SINS_SCENE_TEXT_LOG names
 *     while (...) {
 *         sins_flight_sample_at(flight, k / rate_hz, &sample);   or sins_log_get_sample()
 *         sins_scene_prepare(scene, sim, 0.0, &sample);          temperature and failures; 0.0: time stamp of the first sample
 *         sins_push_sample(sim, &sample);
 *         sins_step(sim);
 *     }
 *
 *   A library that was built without the feature "scenes" lacks all functions sins_scene_... and sins_log_.... A program that
 *   calls them directly does not link with such a library, or does not start. A program that loads the library at run time looks
 *   up sins_scene_create by dlsym() or GetProcAddress(): if it is not found, there are no scenes. All else is the same.
 *
 * Functions by subject, in the order of this file:
 *
 * INDEX
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

/* Sets a struct to zero, and struct_size to its size: all effects are off, all options have their defaults. */
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

/*
 * A simulator. This type and the next four are handles. A handle is a key, not an address, and every call checks it. A call
 * with a handle that is null, made up, destroyed or of another kind returns SINS_ERROR_BAD_HANDLE, unless the function says
 * what null means. No key is ever used again.
 */
typedef struct sins_sim sins_sim;
/* An embedded flight: the library computes its samples from manoeuvres. */
typedef struct sins_flight sins_flight;
/* An ensemble: many runs of one simulator over the same samples. */
typedef struct sins_ensemble sins_ensemble;
/* A scene: a flight, the settings of the simulator, and the planned failures of the sensors. */
typedef struct sins_scene sins_scene;
/* A flight log: a table of samples. */
typedef struct sins_log sins_log;
