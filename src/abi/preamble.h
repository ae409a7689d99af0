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
