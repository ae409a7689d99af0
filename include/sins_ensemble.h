/*
 * sins_ensemble.h - ensembles: many runs of one simulator over the same samples, and the statistics of their errors. The
 * conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_ENSEMBLE_H
#define SINS_ENSEMBLE_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Ensembles. */

/**
 * An ensemble: many runs of one simulator over the same samples. A handle is a checked key, like that of a sins_sim, and is
 * never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
 */
typedef struct sins_ensemble sins_ensemble;

/**
 * Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator on which options, sensor
 * errors, initial errors, mounting, gravity disturbance and failures are set, and to which no sample was pushed. The call
 * copies it, and does not change it. Run k of the ensemble gives the same bits as a simulator with the same settings and
 * sins_options.run = k. Three options of configured have no effect: run, truth_summary and covariance.
 *
 * No run depends on another run. So different threads, processes and machines may fly ensembles of different runs, and their
 * statistics can be merged. The library starts no thread.
 *
 * What all runs share is computed once a step, and many runs are flown side by side: each takes a fraction of the time of a
 * simulator, and 1.7 to 2.6 KB of memory. A run of a small ensemble takes at most 1.1 times as long as a simulator.
 * docs/ensembles.md has the times. Not for a real-time frame: it allocates.
 *
 * After an error *ensemble is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
 *
 * SINS_ERROR_BAD_STATE: configured has taken a sample since it was created or reset, or navigates on increments.
 * SINS_ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 above 2^64 - 1.
 * SINS_ERROR_OUT_OF_MEMORY: no memory for all runs, which the call checks before it allocates; or 4096 ensembles exist.
 *
 * ```c
 * sins_sim *drawn = NULL;
 * sins_ensemble *ensemble = NULL;
 * static sins_statistics statistics;
 * sins_figures figures;
 * SINS_INIT(statistics);
 * SINS_INIT(figures);
 * SINS_INIT(sample);
 * gyro.bias_sigma_rad_s[0] = gyro.bias_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR;
 * sins_create(NULL, &drawn);
 * sins_set_gyro(drawn, &gyro);
 * sins_ensemble_create(drawn, 0, 100, &ensemble);
 * for (sample.time_s = 0.0; sample.time_s <= 60.0; sample.time_s += 1.0) {
 *     sins_ensemble_push_sample(ensemble, &sample);
 *     sins_ensemble_step(ensemble);
 * }
 * sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics);
 * sins_statistics_figures(&statistics, &figures);
 * printf("%d runs\n", (int)statistics.runs);  // 100 runs
 * sins_ensemble_destroy(ensemble);
 * sins_destroy(drawn);
 * ```
 */
SINS_API sins_status SINS_CALL sins_ensemble_create(const sins_sim *configured, uint64_t first_run, size_t runs,
    sins_ensemble **ensemble);

/**
 * Waits until the calls of other threads on this handle have returned, and destroys the ensemble. The handle is never used
 * again.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_ensemble_destroy(sins_ensemble *ensemble);

/**
 * Puts one flight sample into the queue (16 samples) of all runs.
 *
 * SINS_GAP and the errors: as sins_push_sample().
 */
SINS_API sins_status SINS_CALL sins_ensemble_push_sample(sins_ensemble *ensemble, const sins_flight_sample *sample);

/**
 * Flies one sample interval with all runs that have not diverged. No allocation, no system call.
 *
 * A run has diverged if its solution leaves its limits (SINS_ERROR_DIVERGED of sins_step()), or comes too close to a pole in
 * geographic axes (SINS_ERROR_SINGULAR). A diverged run is not flown any further, and its reads return SINS_ERROR_DIVERGED.
 * sins_ensemble_get_diverged() reports it, and sins_ensemble_get_statistics() counts it. The other runs and the truth
 * continue, even if all runs have diverged. sins_ensemble_reposition() and sins_ensemble_reset() start all runs again.
 *
 * SINS_NEED_SAMPLE: no complete interval is waiting. SINS_ERROR_SINGULAR: the truth is too close to a pole, in geographic
 * axes or for an alignment by gyrocompassing; the step is made for no run.
 */
SINS_API sins_status SINS_CALL sins_ensemble_step(sins_ensemble *ensemble);

/**
 * Pushes and steps an array of count samples. With thousands of runs this is faster than single calls. Any split of a flight
 * into calls gives the same bits as pushing and stepping sample by sample. samples[0].struct_size is the size in bytes of
 * each element of samples; struct_size of the other samples may be 0.
 *
 * SINS_GAP: all samples were flown, and at least one of them ended a gap. An error of sins_ensemble_push_sample() or
 * sins_ensemble_step() ends the call at the sample that caused the error; sins_last_error() names this sample. The samples
 * before it were flown, this sample and the rest were not. A sample that could be pushed but not flown waits in the queue.
 */
SINS_API sins_status SINS_CALL sins_ensemble_run(sins_ensemble *ensemble, const sins_flight_sample *samples,
    size_t count);

/**
 * Restarts all runs, as sins_reposition() does: the truth jumps to the sample, and every run, diverged or not, starts again
 * there with its initial errors.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
 */
SINS_API sins_status SINS_CALL sins_ensemble_reposition(sins_ensemble *ensemble, const sins_flight_sample *sample);

/**
 * Returns to the state before the first sample, as sins_reset() does: the same parameters, no failures, no diverged run, and
 * the random streams at their start.
 */
SINS_API sins_status SINS_CALL sins_ensemble_reset(sins_ensemble *ensemble);

/**
 * Sets or clears a failure of one output in every run, as sins_set_failure() does. No allocation, no system call.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_set_failure().
 */
SINS_API sins_status SINS_CALL sins_ensemble_set_failure(sins_ensemble *ensemble, int32_t sensor, int32_t axis,
    const sins_failure *failure);

/**
 * Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the same bits however
 * they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without pointers: send it, store it,
 * compare its bytes. Its numbers have the byte order of the machine. A struct that is zero except for struct_size holds no
 * runs. sins_statistics_figures() computes means, covariances and radii.
 *
 * The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment about east, north,
 * up, as in sins_errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24 um), 2^-29 m/s (1.9 nm/s),
 * 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262 km/s) and 4 rad, which are 2^47 resolutions;
 * the horizontal radial position error is in range below 2^25 m. There are at most 4294967295 runs, so the sums cannot
 * overflow. Integers of 128 bits are two words, the low one first, in two's complement.
 */
typedef struct sins_statistics {
    /** sizeof(sins_statistics) */
    uint32_t struct_size;
    /** Version of the layout of the fields below: 1; 0 while there is no run. */
    uint32_t layout;
    /** Number of runs, including those that are left out of the sums. */
    uint64_t runs;
    /** Number of runs that have diverged. They are left out of the sums. */
    uint64_t diverged;
    /** Number of runs with a state or a horizontal radial position error outside its range. They are left out of the sums. */
    uint64_t out_of_range;
    /** Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are in the sums. */
    uint64_t outside_validity;
    /** Largest horizontal radial position error, rounded down [2^-22 m]. */
    uint64_t largest_radial;
    /** Sum of each state, integers of 128 bits. */
    uint64_t sums[18];
    /** Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row by row. */
    uint64_t products[90];
    /**
     * Numbers of runs by their horizontal radial position error. Element 0 counts those below 2^-10 m (1 mm). Element 1 +
     * 100 i + k, with i from 0 to 34 and k from 0 to 99, counts those from 2^(i-10) (1 + k/100) m up to 2^(i-10) (1 +
     * (k+1)/100) m.
     */
    uint32_t histogram[3501];
    /** 0 */
    uint32_t reserved;
} sins_statistics;

/** Reads the number of the first run, and how many runs there are; either pointer may be NULL. */
SINS_API sins_status SINS_CALL sins_ensemble_get_runs(sins_ensemble *ensemble, uint64_t *first_run, size_t *runs);

/**
 * Reads the truth, which all runs share, as sins_get_truth() does.
 *
 * SINS_NEED_SAMPLE: no sample yet.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_truth(sins_ensemble *ensemble, sins_navigation *truth);

/**
 * Reads the navigated solution of a run, as sins_get_navigation() does. run is from first_run to first_run + runs - 1.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged (the
 * sentence of sins_last_error() states the time of its last good solution); or as sins_get_navigation().
 * SINS_ERROR_SINGULAR: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_navigation(sins_ensemble *ensemble, uint64_t run,
    sins_navigation *navigation);

/**
 * Reads the errors of the navigated solution of a run, as sins_get_errors() does; source is of enum sins_errors_source.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run or source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL
 * while the error model is off. SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_ensemble_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_errors(sins_ensemble *ensemble, uint64_t run, int32_t source,
    sins_errors *errors);

/**
 * Reads the errors of all runs into an array, as sins_ensemble_get_errors() does for one: element k is run first_run + k. A run that
 * has diverged or cannot start is flagged SINS_ERRORS_NOT_COMPUTED, and its errors are 0. errors[0].struct_size is the size in bytes
 * of each element of errors; that of the other elements may be anything. No allocation, no system call.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the
 * error model is off. SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of runs. SINS_ERROR_SINGULAR: before the first
 * step, no run can start at the first sample.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_all_errors(sins_ensemble *ensemble, int32_t source,
    sins_errors *errors, size_t capacity);

/**
 * Reads ideal and measured signals of the last interval of a run, as sins_get_imu() does.
 *
 * SINS_NEED_SAMPLE: no interval yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_imu(sins_ensemble *ensemble, uint64_t run, sins_imu *imu);

/**
 * Reads the run number of diverged run `index`, from 0. The run numbers are in ascending order. sins_statistics.diverged is
 * the number of diverged runs.
 *
 * SINS_ERROR_INVALID_ARGUMENT: index is not below the count of diverged runs.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_diverged(sins_ensemble *ensemble, size_t index, uint64_t *run);

/**
 * Removes errors of one run, as sins_correct() does. The first compensation of sensors in each group of 16 runs allocates.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such run; or as sins_correct(). SINS_ERROR_DIVERGED: the run has diverged; or as
 * sins_correct(). SINS_ERROR_BAD_STATE, SINS_ERROR_SINGULAR: as sins_correct(). SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_ensemble_correct(sins_ensemble *ensemble, uint64_t run,
    const sins_correction *correction);

/**
 * Reads the compensation in force of one run, as sins_get_compensation() does.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_compensation(sins_ensemble *ensemble, uint64_t run,
    sins_compensation *compensation);

/** Whether a requirement is met: "95 % of the flights are within 2 km". */
typedef enum sins_decision {
    /** The interval of the fraction contains the required fraction. sins_verdict.more_runs runs more would decide. */
    SINS_DECISION_UNDECIDED = 0,
    /** Met: the whole interval is above the required fraction. */
    SINS_DECISION_MET = 1,
    /** Not met: the whole interval is below the required fraction. */
    SINS_DECISION_NOT_MET = 2
} sins_decision;

/**
 * Figures that are computed from a sins_statistics. If there is no run, all figures are 0. If there is one run, its
 * covariance is 0.
 */
typedef struct sins_figures {
    /** sizeof(sins_figures) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Number of runs, including those that are left out of the other figures. */
    uint64_t runs;
    /** Number of runs that have diverged. They are left out. */
    uint64_t diverged;
    /** Number of runs with an error outside its range. They are left out. */
    uint64_t out_of_range;
    /** Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are not left out. */
    uint64_t outside_validity;
    /** Mean position error [m]. */
    double mean_position_enu_m[3];
    /** Mean velocity error [m/s]. */
    double mean_velocity_enu_m_s[3];
    /** Mean misalignment [rad]. */
    double mean_misalignment_enu_rad[3];
    /** Standard deviation of the position error, with the divisor n - 1 [m]. */
    double sigma_position_enu_m[3];
    /** Standard deviation of the velocity error [m/s]. */
    double sigma_velocity_enu_m_s[3];
    /** Standard deviation of the misalignment [rad]. */
    double sigma_misalignment_enu_rad[3];
    /** Root mean square of the position error [m]. */
    double rms_position_enu_m[3];
    /** Root mean square of the velocity error [m/s]. */
    double rms_velocity_enu_m_s[3];
    /** Root mean square of the misalignment [rad]. */
    double rms_misalignment_enu_rad[3];
    /**
     * Covariance of the nine states of sins_statistics, with the divisor n - 1, row by row: element 9 i + j is the
     * covariance of the states i and j, in m, m/s and rad.
     */
    double covariance[81];
    /** Root mean square of the horizontal radial position error [m]. */
    double rms_radial_m;
    /**
     * Horizontal radius that contains the positions of half of the runs [m]. It is read from the histogram, to 0.5 % of its
     * value, or to 0.5 mm if it is below 1 mm.
     */
    double cep50_m;
    /** Horizontal radius that contains the positions of 95 % of the runs [m]. It is read from the histogram as cep50_m is. */
    double r95_m;
    /** Largest horizontal radial position error [m]. */
    double largest_radial_m;
} sins_figures;

/**
 * Whether the runs of a sins_statistics meet a requirement. The numbers of runs are exact, so they and the decision do not depend
 * on how the runs were split.
 */
typedef struct sins_verdict {
    /** sizeof(sins_verdict) */
    uint32_t struct_size;
    /** One of enum sins_decision. */
    int32_t decision;
    /** Number of all runs. Runs that diverged or are out of range are outside the limit. */
    uint64_t runs;
    /** Number of runs that are within the limit. */
    uint64_t inside;
    /**
     * Number of further runs of which the histogram does not show whether they are within the limit: those in the bucket that
     * contains the limit, less than 1 % from it. The decision holds wherever they are.
     */
    uint64_t near_limit;
    /**
     * Number of further runs that would decide if the fraction of runs within the limit stayed as it is. 0: it is decided.
     * UINT64_MAX: without a run, or if the fraction is the required one.
     */
    uint64_t more_runs;
    /**
     * Lower end of the interval that contains the true fraction of runs within the limit with 95 % confidence (Wilson's score
     * interval) [1].
     */
    double fraction_low;
    /** Upper end of this interval [1]. */
    double fraction_high;
} sins_verdict;

/**
 * Reads the statistics of the errors of all runs at this moment; source is of enum sins_errors_source. sins_statistics_merge() adds
 * those of other runs at the same moment. Within 20 km of the Earth's axis (SINS_NAVIGATION_NEAR_POLE of the truth) the up
 * misalignment and the east and north components of the velocity error have no meaning. No allocation, no system call.
 *
 * SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while
 * the error model is off. SINS_ERROR_SINGULAR: before the first step, no run can start at the first sample.
 */
SINS_API sins_status SINS_CALL sins_ensemble_get_statistics(sins_ensemble *ensemble, int32_t source,
    sins_statistics *statistics);

/**
 * Adds one run, whose errors are `errors`, to `statistics`: for runs that simulators fly one by one. sins_statistics without runs is zero
 * except for struct_size. With the flag SINS_ERRORS_NOT_COMPUTED the run counts as diverged. The errors may be any numbers: a run whose
 * errors are out of the range of the sums is counted in out_of_range. No allocation, no system call.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the statistics are damaged or of another release, or have 4294967295 runs. They are then unchanged.
 */
SINS_API sins_status SINS_CALL sins_statistics_add(sins_statistics *statistics, const sins_errors *errors);

/**
 * Adds the runs of `other` to those of `into`. The caller makes sure that no run is in both. The sums are exact: any order
 * and any grouping of merges gives the same bits, so the work can be split over threads, processes, machines and restarts in
 * any way. If `into` is zero except for struct_size, it holds no runs.
 *
 * SINS_ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or the sum would have more than 4294967295
 * runs. into is then unchanged.
 */
SINS_API sins_status SINS_CALL sins_statistics_merge(sins_statistics *into, const sins_statistics *other);

/**
 * Computes means, covariances, root mean squares and radii from statistics.
 *
 * SINS_ERROR_INVALID_ARGUMENT: they are damaged or of another release.
 */
SINS_API sins_status SINS_CALL sins_statistics_figures(const sins_statistics *statistics, sins_figures *figures);

/**
 * Decides whether `percent` of the runs have a horizontal radial position error of at most `radius_m`. The requirement 0.8 nmi/h
 * CEP after 2 hours is: 50 %, 2 * 0.8 * SINS_NMI. 0 < percent < 100; 0 < radius_m <= 33554432.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a number is out of its range, or the statistics are damaged or of another release.
 */
SINS_API sins_status SINS_CALL sins_meets(const sins_statistics *statistics, double radius_m, double percent,
    sins_verdict *verdict);

/** Reads the size that a snapshot has now: about 1.3 to 5.25 KiB for each run, as for a simulator. */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_size(sins_ensemble *ensemble, size_t *size);

/**
 * Saves the whole ensemble, at any moment, as sins_snapshot_save() does for a simulator. written (may be NULL) gets the
 * size. The same state gives the same bytes. No allocation, no system call.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see sins_ensemble_snapshot_size(); buffer and written are unchanged.
 */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_save(sins_ensemble *ensemble, void *buffer, size_t capacity,
    size_t *written);

/**
 * Replaces the ensemble by the saved one, including its runs and options. So the handle may be any ensemble, for example of
 * one run. The loaded ensemble continues with the same bits as the saved one. size is the size that
 * sins_ensemble_snapshot_save() wrote. Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of an ensemble, or are cut off, altered, or of a newer release; nothing
 * has changed, and sins_last_error(NULL, ...) reports which it is. SINS_ERROR_OUT_OF_MEMORY: no memory for a second
 * ensemble.
 */
SINS_API sins_status SINS_CALL sins_ensemble_snapshot_load(sins_ensemble *ensemble, const void *snapshot,
    size_t size);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_ensemble_sizeof {
    SINS_SIZEOF_STATISTICS = 14920,
    SINS_SIZEOF_FIGURES = 936,
    SINS_SIZEOF_VERDICT = 56
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ENSEMBLE_H */
