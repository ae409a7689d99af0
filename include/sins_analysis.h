/*
 * sins_analysis.h - questions about a flight: which options it needs, and which effects of the sensors matter. The conventions are
 * those of sins.h.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_ANALYSIS_H
#define SINS_ANALYSIS_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which options, which effects matter. */

/**
 * Largest error that the algorithm itself may cause, in addition to those of the sensors, at any time within a duration.
 * At least one limit is needed.
 */
typedef struct sins_requirement {
    /** sizeof(sins_requirement) */
    uint32_t struct_size;
    /** 1: measure ns_per_step, in 9 rounds of about 1000 steps; 0: it is 0. */
    uint32_t time_steps;
    /**
     * Duration for which the limits hold, 0 to 1e6 [s]. If it is shorter than the piece of flight that is given to
     * sins_recommend(), it is the length of that piece.
     */
    double duration_s;
    /** Limit of the position error of the algorithm: distance from the reference (see sins_recommend()) [m]; 0: none. */
    double position_m;
    /** Limit of the velocity error of the algorithm: length of the difference from the reference [m/s]; 0: none. */
    double velocity_m_s;
    /**
     * Limit of the attitude error of the algorithm: angle between its attitude relative to the Earth and that of the
     * reference [rad]; 0: none.
     */
    double attitude_rad;
    /** Margin: each limit must be at least this many times the predicted error, 1 to 1e6; 0: 2. */
    double margin;
} sins_requirement;

/** Accuracy and cost of the recommended options. */
typedef struct sins_cost {
    /** sizeof(sins_cost) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Duration for which the errors are predicted [s]. */
    double duration_s;
    /** Predicted position error, the largest within the duration [m]. */
    double position_m;
    /** Predicted velocity error, the largest within the duration [m/s]. */
    double velocity_m_s;
    /** Predicted attitude error against the Earth, the largest within the duration [rad]. */
    double attitude_rad;
    /** Part of position_m that is the uncertainty of the reference [m]. */
    double reference_position_m;
    /** Part of velocity_m_s that is the uncertainty of the reference [m/s]. */
    double reference_velocity_m_s;
    /** Part of attitude_rad that is the uncertainty of the reference [rad]. */
    double reference_attitude_rad;
    /**
     * Predicted error times margin divided by its limit, the largest of the three. The requirement is met if this is at most
     * 1. A limit below 1e-100 counts as 1e-100.
     */
    double share;
    /**
     * Processor instructions of the part of a step that depends on the algorithm: a figure that is the same on every
     * machine. The algorithms are ordered by this figure.
     */
    double instructions_per_step;
    /**
     * Time of push and step of one sample, measured in this call on this machine if time_steps is 1, else 0, with the
     * recommended options, the mounting, and ideal sensors; 0 in WebAssembly, which has no clock [ns].
     */
    double ns_per_step;
    /** Number of algorithms that were tried, including the recommended one. */
    uint64_t tried;
    /** Largest angular rate of the samples, as in sins_truth_summary [rad/s]. */
    double rate_max_rad_s;
    /** Time stamp of rate_max_rad_s [s]. */
    double rate_max_at_s;
    /** Largest specific force of the samples, as in sins_truth_summary [m/s2]. */
    double force_max_m_s2;
    /** Time stamp of force_max_m_s2 [s]. */
    double force_max_at_s;
    /**
     * Largest vibration of the samples: change of the mean angular rate from an interval to the next, divided by the time
     * between their middles [rad/s2]; 0 for two samples.
     */
    double vibration_max_rad_s2;
    /** Time stamp of vibration_max_rad_s2: that of the last sample of the two intervals [s]. */
    double vibration_max_at_s;
} sins_cost;

/**
 * Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples.
 * samples[0].struct_size is the size in bytes of each element of samples. docs/accuracy.md, "Which options", says which piece to
 * give, which error is judged, and how it is predicted beyond the piece.
 *
 * configured is a simulator as the host flies it, at any moment. The call uses only its options and its mounting, reads them at
 * the start, and neither steps nor changes the simulator. NULL is the recommended simulator with its sensor block at the
 * reference point. The output `options` gets the options of configured, ready for sins_create(). Only scheme, subsamples and
 * updates_per_sample are replaced by the recommended values. The values of these three in configured do not matter.
 *
 * Not for a real-time frame: it allocates, and takes about 18 to 70 us a sample, 0.1 to 0.4 ms if nothing meets the requirement.
 * time_steps adds 5 to 100 ms. The same samples give the same answer on every machine; only ns_per_step differs.
 *
 * SINS_REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the algorithm that comes
 * closest.
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
 * SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
 * SINS_ERROR_DIVERGED: the solution of every algorithm diverged.
 * SINS_ERROR_OUT_OF_MEMORY: no memory.
 *
 * sins_last_error(NULL, ...) on this thread gives the reason and the sample.
 */
SINS_API sins_status SINS_CALL sins_recommend(const sins_sim *configured, const sins_flight_sample *samples,
    size_t count, const sins_requirement *requirement, sins_options *options, sins_cost *cost);

/** Flags of a sins_budget_row. */
typedef enum sins_budget_flags {
    /** The figures of the row are standard deviations (1 sigma), from linear error equations. */
    SINS_BUDGET_RANDOM = 1,
    /** The effect can be left out, together with all others that have this flag. */
    SINS_BUDGET_CAN_BE_LEFT_OUT = 2
} sins_budget_flags;

/**
 * An effect and its contribution to the errors. The first row of a budget has the errors of the mechanization and of the
 * samples, with no effect set.
 */
typedef struct sins_budget_row {
    /** sizeof(sins_budget_row) */
    uint32_t struct_size;
    /** Flags of enum sins_budget_flags, or'ed. */
    uint32_t flags;
    /** Name of the effect, such as "gyro turn-on bias", terminated; in the first row "mechanization". */
    char effect[32];
    /**
     * The field that sets the effect, such as "gyro.bias_sigma_rad_s", terminated; a value of 0 there leaves the effect
     * out. Empty in the first row.
     */
    char field[48];
    /** Length of the contribution to the position error, the largest at up to 1000 instants of the flight [m]. */
    double position_m;
    /** Length of the contribution to the velocity error, the largest at these instants [m/s]. */
    double velocity_m_s;
    /** Length of the contribution to the misalignment, the largest at these instants [rad]. */
    double attitude_rad;
    /** Length of the contribution to the position error at the end of the flight [m]. */
    double end_position_m;
    /** Length of the contribution to the velocity error at the end of the flight [m/s]. */
    double end_velocity_m_s;
    /** Length of the contribution to the misalignment at the end of the flight [rad]. */
    double end_attitude_rad;
    /** The contribution divided by its limit, the largest of the three; 0 without limits. */
    double share;
    /**
     * Time of a step with all effects, less that of a step without this one; in the first row, time of a step with no effect
     * set. Measured in this call on this machine if time_steps is 1, else 0 [ns]. Uncertain by 1 to 5 % of a step, more on a busy machine,
     * so it may be negative.
     */
    double ns_per_step;
} sins_budget_row;

/** Figures of a budget as a whole. */
typedef struct sins_budget {
    /** sizeof(sins_budget) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Time from the first sample to the end of the last interval [s]. */
    double duration_s;
    /** Number of runs with all effects together; 1 if nothing is random. */
    uint64_t runs;
    /** Number of flights that the call made. */
    uint64_t flights;
    /**
     * Lower end of the 95 % confidence interval of the root mean square of the random errors, divided by the root mean
     * square over the flown runs. The fewer the runs, the wider the interval. 1 if nothing is random.
     */
    double sigma_low;
    /** Upper end of that interval, divided likewise; 1 if nothing is random. */
    double sigma_high;
    /** Position error with all effects together, root mean square over the runs, the largest in the flight [m]. */
    double position_m;
    /** Velocity error with all effects together, likewise [m/s]. */
    double velocity_m_s;
    /** Misalignment with all effects together, likewise [rad]. */
    double attitude_rad;
    /** Part of the position error that the sum of all rows does not explain [m]. */
    double remainder_position_m;
    /** Part of the velocity error that the sum of all rows does not explain [m/s]. */
    double remainder_velocity_m_s;
    /** Part of the misalignment that the sum of all rows does not explain [rad]. */
    double remainder_attitude_rad;
    /**
     * Change of the position error if the marked effects (SINS_BUDGET_CAN_BE_LEFT_OUT) are left out, from flights of all runs
     * without them [m].
     */
    double left_out_position_m;
    /** Change of the velocity error if the marked effects are left out, likewise [m/s]. */
    double left_out_velocity_m_s;
    /** Change of the misalignment if the marked effects are left out, likewise [rad]. */
    double left_out_attitude_rad;
    /** Time of a step with all effects, measured in this call on this machine if time_steps is 1, else 0 [ns]. */
    double ns_per_step;
} sins_budget;

/** Request for an error budget. All zero is 16 runs and no limits. */
typedef struct sins_budget_request {
    /** sizeof(sins_budget_request) */
    uint32_t struct_size;
    /** 1: measure the figures ns_per_step; 0: they are 0. */
    uint32_t time_steps;
    /** Number of runs with all effects together, if any effect is random, 8 to 1000; 0: 16. */
    uint64_t runs;
    /**
     * Limit of the change of the position error, at any time of the flight, by all effects that are left out together [m];
     * 0: none.
     */
    double position_m;
    /** Limit of the change of the velocity error, likewise [m/s]; 0: none. */
    double velocity_m_s;
    /** Limit of the change of the misalignment, likewise [rad]; 0: none. */
    double attitude_rad;
} sins_budget_request;

/**
 * Computes the contribution of each effect to the errors of a flight of 2 to 1e9 samples: which effects matter, and which
 * can be left out. samples[0].struct_size is the size in bytes of each element of samples, rows[0].struct_size that of each
 * element of rows. struct_size of the other samples may be 0, that of the other rows anything. docs/effects.md, "Which effects
 * matter", defines the contributions, their remainder, and what is left out.
 *
 * configured is a simulator as the host flies it, at any moment. The call uses its options and all its errors: those of
 * gyros, accelerometers and altimeter, the initial errors, and those of mounting and gravity, but not its failures. The call
 * reads them at the start, and neither steps nor changes the simulator. NULL is the recommended simulator without errors.
 * NULL for request is 16 runs and no limits. written and budget may be NULL.
 *
 * rows[0] is the mechanization's own error. A row for each field that sets an error and is not 0 follows, ordered by position,
 * then velocity, then misalignment, the largest first; with limits, by their share of a limit.
 *
 * Not for a real-time frame: it allocates, and flies the samples many times, each time in 0.8 to 1.8 us a sample with the
 * recommended options, in 11 us with SINS_SCHEME_POLYNOMIAL, 5 subsamples and 16 updates. time_steps adds 0.05 to 0.6 s with
 * three effects. The same samples give the same answer on every machine, except for the figures ns_per_step.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of rows; written gets that number, and nothing is flown.
 * (To ask for the number, give NULL for rows and a capacity of 0.)
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
 * SINS_ERROR_SINGULAR: too close to a pole, in geographic axes or for gyrocompassing.
 * SINS_ERROR_DIVERGED: a solution diverged.
 * SINS_ERROR_BAD_STATE: a sample became invalid during the call. To end the call, another thread may set struct_size of samples to 1,
 * and nothing else.
 * SINS_ERROR_OUT_OF_MEMORY: no memory.
 *
 * sins_last_error(NULL, ...) on this thread gives the reason and the sample.
 */
SINS_API sins_status SINS_CALL sins_error_budget(const sins_sim *configured, const sins_flight_sample *samples,
    size_t count, const sins_budget_request *request, sins_budget_row *rows, size_t capacity, size_t *written,
    sins_budget *budget);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_analysis_sizeof {
    SINS_SIZEOF_REQUIREMENT = 48,
    SINS_SIZEOF_COST = 144,
    SINS_SIZEOF_BUDGET_REQUEST = 40,
    SINS_SIZEOF_BUDGET_ROW = 152,
    SINS_SIZEOF_BUDGET = 128
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ANALYSIS_H */
