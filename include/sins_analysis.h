/*
 * sins_analysis.h - questions about a flight: which options it needs, which effects of the sensors matter, and which errors
 * real sensors have. The conventions are those of sins.h.
 *
 * A library that was built without the feature "identify" lacks all functions sins_identify_....
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

/* The errors of real sensors. */

/** Number of parameters. */
#define SINS_IDENTIFIED_PARAMETERS 71

/** Flags of a sins_identify_request. */
typedef enum sins_identify_flags {
    /** The field shift_s holds the shift of the clock. */
    SINS_IDENTIFY_SHIFT = 1,
    /** The states of the path are kept too, which sins_identify_check() needs: 336 bytes a sample. */
    SINS_IDENTIFY_STATES = 2,
    /** Also finds the lever arm from the point of the path to the accelerometers. Not for sins_identify_check(). */
    SINS_IDENTIFY_LEVER_ARM = 4,
    /** Also finds the g-sensitivity of the gyros, each to the forces along all axes. */
    SINS_IDENTIFY_G_SENSITIVITY = 8,
    /** Also finds the scale factor asymmetry of each sensor. */
    SINS_IDENTIFY_ASYMMETRY = 16,
    /**
     * Also finds the change of each bias with temperature. The samples of the path have the temperature, linear between those that carry
     * temperature_c; a path without any is SINS_ERROR_INVALID_ARGUMENT.
     */
    SINS_IDENTIFY_TEMPERATURE = 32
} sins_identify_flags;

/** Flags of a sins_identified and of a sins_identified_parameter. */
typedef enum sins_identified_flags {
    /** The record shows it. Of the axes: the motion excludes all others. Of a parameter: the record narrows its prior to less than a half. */
    SINS_IDENTIFIED_SEEN = 1
} sins_identified_flags;

/**
 * The errors of real sensors: a path and a record of the same motion, and what was found in them. A handle is a checked key, like
 * that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
 */
typedef struct sins_identify sins_identify;

/** What is known of sensors before their record. All zero is nothing: the widest prior, clock and axes are found. */
typedef struct sins_identify_request {
    /** sizeof(sins_identify_request) */
    uint32_t struct_size;
    /** Flags of enum sins_identify_flags, or'ed. */
    uint32_t flags;
    /** Grade of the sensors, of enum sins_grade; 0: SINS_GRADE_CONSUMER, the widest. A grade that is too good moves the estimates. */
    int32_t prior;
    /** Axes of the vehicle along x, y and z of the record: 1, 2 or 3 for x, y or z, negative if reversed; all 0: they are found. */
    int32_t axes[3];
    /** With SINS_IDENTIFY_SHIFT: time of the path less time of the record, known to 10 s, -1e12 to 1e12 [s]. */
    double shift_s;
    /**
     * Frequency above which the path lacks motion, 0.001 to 1e6 [Hz], as a smoothed path does: path and record are then compared by their
     * means over a period of it. 0: by means over 0.2 s or more.
     */
    double cutoff_hz;
} sins_identify_request;

/** An increment that real sensors measured. */
typedef struct sins_recorded_increment {
    /** sizeof(sins_recorded_increment) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** End of the interval on the clock of the record, later than that of the increment before, -1e12 to 1e12 [s]. */
    double time_s;
    /** Length of the interval, 1e-6 to 60 [s]. */
    double interval_s;
    /** Integral of the measured angular rate over the interval, along x, y, z of the record [rad]. */
    double angle_rad[3];
    /** Integral of the measured specific force over the interval, likewise [m/s]. */
    double velocity_m_s[3];
} sins_recorded_increment;

/** What was found, as a whole. */
typedef struct sins_identified {
    /** sizeof(sins_identified) */
    uint32_t struct_size;
    /** Of the axes: flags of enum sins_identified_flags, or'ed. */
    uint32_t flags;
    /** Number of increments of the record. */
    uint64_t increments;
    /** Time of the record that was compared with the path [s]. */
    double used_s;
    /** Time on the clock of the record at which the parameter "clock shift" holds [s]. */
    double middle_s;
    /** Signals of the record are this matrix times the signals of the vehicle, row by row. */
    double rotation[9];
    /** Attitude of the sensor block in the vehicle, as sins_mounting_params.boresight_rad [rad]. */
    double boresight_rad[3];
    /** With SINS_IDENTIFY_TEMPERATURE: the temperature at which the biases hold, the mean of the record [deg C]; otherwise 0. */
    double reference_temperature_c;
} sins_identified;

/** A parameter that a record may show. */
typedef struct sins_identified_parameter {
    /** sizeof(sins_identified_parameter) */
    uint32_t struct_size;
    /** Flags of enum sins_identified_flags, or'ed. */
    uint32_t flags;
    /** Its name, such as "gyro bias x", terminated. */
    char name[48];
    /** SI unit of its figures, such as "rad/s", "1" for a ratio, terminated. */
    char unit[16];
    /** Mean [unit]. */
    double value;
    /** Lower end of its 95 % interval [unit]. */
    double low;
    /** Upper end of its 95 % interval [unit]. */
    double high;
    /** Standard deviation [unit]; 0 of noise, whose distribution is not normal. */
    double sigma;
    /** Standard deviation before the record [unit]; 0 of noise. */
    double prior;
    /** Without SINS_IDENTIFIED_SEEN: why the record does not show it, and what motion would, UTF-8, terminated. Otherwise empty. */
    char reason[192];
} sins_identified_parameter;

/**
 * Creates an empty path and an empty record. Then push the samples of the path and the increments of the record, in any order, and
 * solve. docs/identify.md says what is found, and what a record can show. Of the options, the Earth, gravity, axes and the checks of
 * samples count. In the example a simulator stands for the real sensors. NULL for options: the defaults; NULL for request: nothing is
 * known.
 *
 * Not for a real-time frame: it allocates. On an error *identify is unchanged, and sins_last_error(NULL, ...) on this thread gives the
 * reason.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range; or axes of request that are not x, y and z once each, or left-handed.
 * SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 of these handles exist.
 *
 * ```c
 * int row, axis;
 * sins_identify *identify = NULL;
 * sins_identified_parameter parameter;
 * sins_recorded_increment increment;
 * sins_imu measured;
 * sins_sim *real = NULL;
 * SINS_INIT(increment);
 * SINS_INIT(measured);
 * SINS_INIT(parameter);
 * SINS_INIT(sample);
 * for (axis = 0; axis < 3; ++axis) {
 *     gyro.random_walk_rad_sqrt_s[axis] = 0.001 * SINS_DEG_PER_SQRT_HOUR;
 *     accel.velocity_random_walk_m_s_sqrt_s[axis] = 10.0 * SINS_MICRO_G_PER_SQRT_HZ;
 * }
 * gyro.bias_rad_s[0] = 20.0 * SINS_DEG_PER_HOUR;
 * sins_create(NULL, &real);
 * sins_set_gyro(real, &gyro);
 * sins_set_accel(real, &accel);
 * sins_identify_create(NULL, NULL, &identify);
 * for (row = 0; row < 2000; ++row) {
 *     sample.time_s = 0.1 * row;
 *     sins_identify_push_samples(identify, &sample, 1);
 *     sins_push_sample(real, &sample);
 *     if (sins_step(real) == SINS_OK && sins_get_imu(real, &measured) == SINS_OK) {
 *         increment.time_s = measured.time_s;
 *         increment.interval_s = measured.interval_s;
 *         memcpy(increment.angle_rad, measured.measured_angle_rad, sizeof increment.angle_rad);
 *         memcpy(increment.velocity_m_s, measured.measured_velocity_m_s, sizeof increment.velocity_m_s);
 *         sins_identify_push_increments(identify, &increment, 1);
 *     }
 * }
 * sins_identify_solve(identify, NULL);
 * sins_identify_get_parameter(identify, 5, &parameter);
 * printf("%s: %.1f deg/h\n", parameter.name, parameter.value / SINS_DEG_PER_HOUR);  // gyro bias x: 20.0 deg/h
 * sins_identify_destroy(identify);
 * sins_destroy(real);
 * ```
 */
SINS_API sins_status SINS_CALL sins_identify_create(const sins_options *options,
    const sins_identify_request *request, sins_identify **identify);

/**
 * Adds the next samples of the true path, at most 100000000 in all. samples[0].struct_size is the size in bytes of each element of
 * samples; struct_size of the other samples may be 0. What perfect sensors measure along the path takes 56 bytes a sample, with
 * SINS_IDENTIFY_STATES 336 bytes, with a temperature 16 more; while the memory grows, up to twice that. Not for a real-time frame: it
 * allocates.
 *
 * SINS_GAP: all samples were taken, and at least one of them ended a gap. An error of sins_push_sample() ends the call at the sample that
 * caused the error; sins_last_error(NULL, ...) names this sample. The samples before it were taken.
 * SINS_ERROR_INVALID_ARGUMENT: also a sample too many. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_push_samples(sins_identify *identify, const sins_flight_sample *samples,
    size_t count);

/**
 * Adds the next increments of the record, at most 100000000 in all, each of 64 bytes. increments[0].struct_size is the size in bytes of
 * each element of increments; struct_size of the other increments may be 0. A gap between increments is permitted. Not for a
 * real-time frame: it allocates.
 *
 * An error ends the call at the increment that caused it; sins_last_error(NULL, ...) names its field and its index. The increments before
 * it were taken.
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, a signal above 1e6 rad/s or 1e6 m/s2, or an increment too many.
 * SINS_ERROR_TIME_ORDER: an increment that is not later than the one before. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_push_increments(sins_identify *identify,
    const sins_recorded_increment *increments, size_t count);

/**
 * Finds the errors of the sensors in all samples and increments so far. More may be pushed afterwards, and solved again; what was found
 * stays until then. identified may be NULL. An hour takes about a second. Not for a real-time frame; the call takes up to 256 KB of stack.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the record does not fit the path: it is of another motion or in other units, too short, has a sensor that
 * is stuck or a clock that jumps; sins_last_error(NULL, ...) says which, with the field of the increments if it is one, and a figure of
 * its rate or force.
 * SINS_ERROR_BAD_STATE: the path has fewer than four intervals, or the fit fails without a figure. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_solve(sins_identify *identify, sins_identified *identified);

/**
 * Reads a parameter that sins_identify_solve() found. index is from 0 to SINS_IDENTIFIED_PARAMETERS - 1: shift and drift of the clock;
 * mounting x, y, z; then of the gyros: bias x, y, z, scale factor x, y, z, misalignments xy, xz, yx, yz, zx, zy, white noise x, y, z,
 * flicker x, y, z, random walk x, y, z; then the same of the accelerometers. Misalignment xy is the error of sensor x by a
 * signal along y. Last, those that a request asks for by its flags: g-sensitivities xx, xy, ... zz, asymmetries x, y, z and changes of the
 * biases with temperature x, y, z of the gyros; lever arm x, y, z, asymmetries and changes with temperature of the accelerometers. Not for
 * a real-time frame: it allocates.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such parameter. SINS_ERROR_BAD_STATE: nothing was found yet. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_get_parameter(const sins_identify *identify, size_t index,
    sins_identified_parameter *parameter);

/**
 * Writes what was found as a scene, whose sensors have it; sins_scene_parse() reads it. Its vehicle is at rest: set a flight. What the
 * record does not show is a comment. buffer, capacity and needed as in sins_last_error(). Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_BAD_STATE: nothing was found yet. SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_get_scene(const sins_identify *identify, char *buffer, size_t capacity,
    size_t *needed);

/**
 * Destroys a path, its record and what was found.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_identify_destroy(sins_identify *identify);

/** Verdicts on the model of the sensors. */
typedef enum sins_agreement {
    /** The real drift is as that of the twins. */
    SINS_AGREEMENT_AGREES = 0,
    /** The real sensors drift farther than the model. */
    SINS_AGREEMENT_TOO_GOOD = 1,
    /** The model drifts farther than the real sensors. */
    SINS_AGREEMENT_TOO_BAD = 2
} sins_agreement;

/** What a check is made with. All zero: 100 twins along an exact path. */
typedef struct sins_identify_check_request {
    /** sizeof(sins_identify_check_request) */
    uint32_t struct_size;
    /** Number of twins, 40 to 1000; 0: 100. */
    uint32_t twins;
    /** Standard deviation of the position of the path, each axis, 0 to 1e4 [m]. Each flight of a twin begins with such an error. */
    double position_m;
    /** Standard deviation of the velocity of the path, each axis, 0 to 1e3 [m/s]. */
    double velocity_m_s;
    /** Standard deviation of the tilt of the path about east and about north, 0 to 0.3 [rad]. */
    double tilt_rad;
    /** Standard deviation of the heading of the path, 0 to 0.3 [rad]. */
    double heading_rad;
} sins_identify_check_request;

/** The result of a check as a whole. */
typedef struct sins_identified_check {
    /** sizeof(sins_identified_check) */
    uint32_t struct_size;
    /** Verdict of the duration that is farthest off, of enum sins_agreement. */
    int32_t agreement;
    /** How many times as far the real sensors drift (SINS_AGREEMENT_TOO_GOOD) or the model drifts (SINS_AGREEMENT_TOO_BAD); else 1 [1]. */
    double factor;
    /** Length of the part of the record that was checked [s]. */
    double length_s;
    /** Number of twins. */
    uint64_t twins;
    /** Number of durations. */
    uint64_t spans;
    /** Shortest duration that is left out because half of the flights of the record or of a twin diverge; longer ones are too [s]; 0: none. */
    double diverged_s;
} sins_identified_check;

/** Flights of one duration. A drift is the horizontal distance from the path at the end of a flight; it is infinite if the flight diverged. */
typedef struct sins_identified_span {
    /** sizeof(sins_identified_span) */
    uint32_t struct_size;
    /** Verdict on this duration, of enum sins_agreement. */
    int32_t agreement;
    /** As sins_identified_check.factor [1]. */
    double factor;
    /** The duration [s]. */
    double duration_s;
    /** Number of flights. */
    uint64_t flights;
    /** Number of flights that do not overlap. */
    uint64_t apart;
    /** Median drift of the flights on the record as it is [m]. */
    double free_m;
    /** Median drift with the errors removed that were found [m]. */
    double real_m;
    /** Lower end of the 95 % interval of real_m: order statistics, for the number of flights that do not overlap [m]. */
    double real_low_m;
    /** Upper end of that interval [m]. */
    double real_high_m;
    /** Root mean square of the drifts with the errors removed [m]. */
    double real_rms_m;
    /** Median drift of the flights of a twin: geometric mean of the twins [m]. */
    double predicted_m;
    /** Lower end of the interval of predicted_m that 95 % of the twins keep at all durations together [m]. */
    double predicted_low_m;
    /** Upper end of that interval [m]. */
    double predicted_high_m;
    /** Root mean square of the drifts of all flights of all twins [m]. */
    double predicted_rms_m;
} sins_identified_span;

/**
 * Finds the errors of the sensors in the first half of the increments that the path has, and checks in the other half how far the sensors
 * drift: as sins identify --check. The other half is navigated from many starts, with the errors removed that were found. Twins, sensors
 * that are drawn from what was found, fly the same starts. What was found is then that of the first half. docs/identify.md explains the
 * verdict. The handle must have SINS_IDENTIFY_STATES. request may be NULL: as all zero; check may be NULL.
 *
 * Not for a real-time frame: during the call it allocates up to 72 bytes an increment, 200 bytes a sample and some MB, and it flies each
 * twin, which takes seconds to minutes. The call takes up to 256 KB of stack. On an error, what was found and what was checked stays.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range; the record does not fit the path, as sins_identify_solve(); or a half of it is
 * shorter than 20 s.
 * SINS_ERROR_BAD_STATE: the handle lacks SINS_IDENTIFY_STATES, the path has fewer than four intervals, the fit fails without a figure, or
 * half of the flights of 10 s diverge. SINS_ERROR_OUT_OF_MEMORY: no memory.
 */
SINS_API sins_status SINS_CALL sins_identify_check(sins_identify *identify,
    const sins_identify_check_request *request, sins_identified_check *check);

/**
 * Reads the flights of a duration that the last sins_identify_check() made. index is from 0 to sins_identified_check.spans - 1: 10, 30,
 * 60, 120, 300, 600 s.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such duration. SINS_ERROR_BAD_STATE: nothing was checked yet.
 */
SINS_API sins_status SINS_CALL sins_identify_get_span(const sins_identify *identify, size_t index,
    sins_identified_span *span);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_analysis_sizeof {
    SINS_SIZEOF_REQUIREMENT = 48,
    SINS_SIZEOF_COST = 144,
    SINS_SIZEOF_BUDGET_REQUEST = 40,
    SINS_SIZEOF_BUDGET_ROW = 152,
    SINS_SIZEOF_BUDGET = 128,
    SINS_SIZEOF_IDENTIFY_REQUEST = 40,
    SINS_SIZEOF_RECORDED_INCREMENT = 72,
    SINS_SIZEOF_IDENTIFIED = 136,
    SINS_SIZEOF_IDENTIFIED_PARAMETER = 304,
    SINS_SIZEOF_IDENTIFY_CHECK_REQUEST = 40,
    SINS_SIZEOF_IDENTIFIED_CHECK = 48,
    SINS_SIZEOF_IDENTIFIED_SPAN = 112
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ANALYSIS_H */
