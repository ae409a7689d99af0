/*
 * sins_flight.h - embedded flights: the library computes the samples from manoeuvres; and a judge of samples, which finds what is wrong
 * with them. The conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_FLIGHT_H
#define SINS_FLIGHT_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Embedded flights. */

/** Kinds of manoeuvre. */
typedef enum sins_manoeuvre_kind {
    /** At rest for duration_s; the speed must be 0. */
    SINS_MANOEUVRE_REST = 0,
    /** Along a geodesic at constant speed and height for duration_s. */
    SINS_MANOEUVRE_STRAIGHT = 1,
    /** Changes the speed by speed_change_m_s in duration_s. */
    SINS_MANOEUVRE_ACCELERATE = 2,
    /** Changes the height by height_change_m in duration_s. Uses ramp_s. */
    SINS_MANOEUVRE_CLIMB = 3,
    /**
     * Level coordinated turn by heading_change_rad (right positive) at bank_rad, with ramp_s to roll in and to roll out. The
     * duration follows from these.
     */
    SINS_MANOEUVRE_TURN = 4,
    /** Whole rolls along a straight path in duration_s; the field turns is their number (positive: right wing down). */
    SINS_MANOEUVRE_ROLL = 5,
    /** Whole vertical loops at constant speed in duration_s; the field turns is their number (nose up positive). Uses ramp_s. */
    SINS_MANOEUVRE_LOOP = 6,
    /**
     * The course swings by heading_change_rad to both sides, first to the right if it is positive. The field turns is the number
     * of swings in duration_s. A swing is a full period: to one side, to the other side, and back. Uses ramp_s.
     */
    SINS_MANOEUVRE_S_TURN = 7,
    /** Sum of sinusoid_count sinusoids for duration_s: patrol patterns, rocking, coning, vibration. Uses ramp_s. */
    SINS_MANOEUVRE_SINUSOIDS = 8
} sins_manoeuvre_kind;

/** What a sinusoid of SINS_MANOEUVRE_SINUSOIDS moves. */
typedef enum sins_channel {
    /** The sinusoid moves the course [rad], with the bank of a coordinated turn. */
    SINS_CHANNEL_COURSE = 0,
    /** The sinusoid moves the climb angle [rad]. */
    SINS_CHANNEL_CLIMB = 1,
    /** The sinusoid moves the speed [m/s]. */
    SINS_CHANNEL_SPEED = 2,
    /** The sinusoid moves roll alone [rad]. */
    SINS_CHANNEL_ROLL = 3,
    /** The sinusoid moves pitch alone [rad]. */
    SINS_CHANNEL_PITCH = 4,
    /** The sinusoid moves heading alone [rad]. */
    SINS_CHANNEL_HEADING = 5
} sins_channel;

/** One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0. */
typedef struct sins_manoeuvre {
    /** sizeof(sins_manoeuvre); in an array it is enough to set it in the first element and 0 in the others. */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Kind of the manoeuvre, of enum sins_manoeuvre_kind. */
    int32_t kind;
    /** Number of sinusoids, 1 to 6. */
    int32_t sinusoid_count;
    /** Duration, 1e-3 to 1e8 [s]. */
    double duration_s;
    /**
     * Time in which the manoeuvre builds up, and time in which it dies out, 1e-3 to 1e8; 0: 5 s [s]. If it is longer than
     * half of the duration, half of the duration is used.
     */
    double ramp_s;
    /** Change of speed; the speed must stay between 0 and 10 km/s [m/s]. */
    double speed_change_m_s;
    /** Change of height; the climb angle must stay below 64 degrees [m]. */
    double height_change_m;
    /** Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad [rad]. */
    double heading_change_rad;
    /**
     * Bank of a turn, 1e-3 to 1.5 [rad]. If the heading change is too small to reach this bank, the turn uses a smaller
     * bank.
     */
    double bank_rad;
    /** Number of rolls or loops, a whole number from -1e4 to 1e4, not 0; or number of swings of an S-turn, 0 to 1e6. */
    double turns;
    /** What each sinusoid moves, of enum sins_channel. */
    int32_t channel[6];
    /**
     * Amplitude of each sinusoid [rad] or [m/s]: up to 10 rad; for the climb angle up to 1.5 rad; for the speed, the sum of the
     * amplitudes is at most the speed.
     */
    double amplitude[6];
    /** Frequency of each sinusoid, 0 to 1000 [Hz]. */
    double frequency_hz[6];
    /** Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), with t since the start of the manoeuvre [rad]. */
    double phase_rad[6];
} sins_manoeuvre;

/** An embedded flight. A handle is a checked key, as that of sins_sim, and never taken for one. */
typedef struct sins_flight sins_flight;

/** Start of an embedded flight, level and straight. */
typedef struct sins_flight_start {
    /** sizeof(sins_flight_start) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Geodetic latitude of the start [rad], -pi/2 to pi/2. */
    double latitude_rad;
    /** Longitude of the start, east positive [rad], -100 to 100. */
    double longitude_rad;
    /** Height of the start above the ellipsoid [m], -20000 to 2e6. */
    double height_m;
    /** Speed at the start against the Earth [m/s], 0 to 10000. */
    double speed_m_s;
    /** Course and heading at the start [rad], -100 to 100. */
    double heading_rad;
    /** Roll of the body relative to the axes of the path, throughout the flight [rad], -pi to pi. */
    double roll_rad;
    /**
     * Pitch of the body relative to the axes of the path, throughout the flight [rad], -pi/2 to pi/2. It is the
     * angle of attack, or the tilt at rest.
     */
    double pitch_rad;
    /** Ellipsoid, of enum sins_earth. It is that of the options of the simulator that will fly it. */
    int32_t earth;
    /** Must be 0. */
    uint32_t reserved2;
} sins_flight_start;

/**
 * Creates a flight from an array of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time,
 * smooth to the third derivative; the position is their integral, exact to rounding. manoeuvres[0].struct_size is the size
 * in bytes of each element of manoeuvres.
 *
 * Not for a real-time frame: it allocates, and integrates the path in pieces, about 15 us and 0.5 KB each. A piece of
 * straight flight lasts up to 600 s. With a fast sinusoid of course, climb or speed, a piece is about one period. Sinusoids
 * of roll, pitch and heading need no pieces.
 *
 * On an error *flight is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a path that leaves the range of sins_flight_sample.height_m (the
 * index in the sentence is that of the manoeuvre).
 * SINS_ERROR_OUT_OF_MEMORY: no memory, more than 200000 pieces (which take 3 s), or 4096 flights exist.
 *
 * ```c
 * sins_flight_start start;
 * sins_manoeuvre turn;
 * sins_flight *flight = NULL;
 * double duration_s = 0.0;
 * SINS_INIT(start);
 * SINS_INIT(turn);
 * start.speed_m_s = 200.0;
 * turn.kind = SINS_MANOEUVRE_TURN;
 * turn.heading_change_rad = 90.0 * SINS_DEG;
 * turn.bank_rad = 30.0 * SINS_DEG;
 * turn.ramp_s = 5.0;
 * sins_flight_create(&start, &turn, 1, &flight);
 * sins_flight_duration(flight, &duration_s);
 * printf("%.0f s\n", duration_s);  // 60 s
 * sins_flight_destroy(flight);
 * ```
 */
SINS_API sins_status SINS_CALL sins_flight_create(const sins_flight_start *start, const sins_manoeuvre *manoeuvres,
    size_t count, sins_flight **flight);

/** Reads the duration of the flight [s]. */
SINS_API sins_status SINS_CALL sins_flight_duration(const sins_flight *flight, double *duration_s);

/**
 * Reads the sample at time_s, from 0 to the duration [s]. It is exact at any time, and times may come in any order. No
 * allocation; 0.5 to 2 us.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a time before the start or after the end.
 */
SINS_API sins_status SINS_CALL sins_flight_sample_at(const sins_flight *flight, double time_s,
    sins_flight_sample *sample);

/**
 * Destroys a flight.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_flight_destroy(sins_flight *flight);

/* Judges of samples. */

/** Most findings of a flight. */
#define SINS_FINDINGS_MAX 32

/** What was found, and what the figure of the finding is. */
typedef enum sins_finding_kind {
    /** Time stamps that are not later than the one before; figure: number of them. */
    SINS_FINDING_TIME_ORDER = 0,
    /** A time stamp much nearer to the one before than the others; figure: the shortest interval [s]. */
    SINS_FINDING_NEAR_STAMPS = 1,
    /** Intervals of more than 2.5 times each of the two before; figure: the longest [s]. */
    SINS_FINDING_GAPS = 2,
    /** Time in milliseconds or microseconds; figure: speed as if it was in seconds [m/s]. */
    SINS_FINDING_TIME_UNIT = 3,
    /** Time stamps that scatter about a steady clock; figure: their scatter [s]. */
    SINS_FINDING_STAMP_JITTER = 4,
    /** Positions in coarse steps; figure: the step [m]. */
    SINS_FINDING_COARSE_POSITIONS = 5,
    /** Positions with noise, without velocities; figure: noise of a component [m]. */
    SINS_FINDING_NOISY_POSITIONS = 6,
    /** Velocities with noise; figure: noise of a component [m/s]. */
    SINS_FINDING_NOISY_VELOCITIES = 7,
    /** Rows that repeat the position of the row before, while the vehicle moves; figure: share of the moving rows [1]. */
    SINS_FINDING_HELD_ROWS = 8,
    /** A position beside the path of its neighbours; figure: the largest distance [m]. */
    SINS_FINDING_SPIKE = 9,
    /** An acceleration that few vehicles have; figure: the largest [m/s²]. */
    SINS_FINDING_ACCELERATION = 10,
    /** Rows at the start that hold a value from before the first fix, such as 0, from which the next row jumps; figure: number of rows. */
    SINS_FINDING_NOT_YET_FIXED = 11,
    /** Velocity in another unit or axes than its name says; figure: size of the velocity over that of the displacement [1]. */
    SINS_FINDING_VELOCITY_UNIT = 12,
    /** Velocity that is no multiple of the displacement; figure: the unexplained share of the displacement [1]. */
    SINS_FINDING_VELOCITY_CONTRADICTS = 13,
    /** Velocity that contradicts the positions at some times; figure: the largest unexplained displacement [m]. */
    SINS_FINDING_VELOCITY_AT_TIMES = 14,
    /** Velocity up that is a multiple of the climb; figure: climb over velocity up [1]. */
    SINS_FINDING_VERTICAL_UNIT = 15,
    /** Heading with another sign or unit, or a path that is mirrored against it; figure: how well it follows the track as it is, 0 to 1. */
    SINS_FINDING_HEADING_UNIT = 16,
    /** Heading off the track by a constant angle; figure: the angle [rad]. */
    SINS_FINDING_HEADING_OFF_TRACK = 17,
    /** An angle that sweeps through a whole turn backwards: it was interpolated through its wrap; figure: the largest false rate [rad/s]. */
    SINS_FINDING_ANGLE_THROUGH_WRAP = 18,
    /** Roll with the wrong sign, or in radians; figure: its slope on the bank that the turns need [1]. */
    SINS_FINDING_ROLL_SIGN = 19,
    /** Roll that the turns do not explain; figure: its slope on the bank that the turns need [1]. */
    SINS_FINDING_ROLL_UNEXPLAINED = 20,
    /** Pitch with the wrong sign, or in radians; figure: its slope on the angle of the path [1]. */
    SINS_FINDING_PITCH_SIGN = 21,
    /** A nose that points below the path; figure: mean of pitch less angle of the path [rad]. */
    SINS_FINDING_ATTACK_NEGATIVE = 22,
    /** Height in feet; figure: slope of pitch on the angle of the path [1]. */
    SINS_FINDING_HEIGHT_UNIT = 23,
    /**
     * Attitude, heading or roll that stays the same to the last bit while the track turns, or an attitude of 0, 0, 0 for a while; figure:
     * the largest turn of the track, or how far the attitude is from 0 beside it [rad].
     */
    SINS_FINDING_ATTITUDE_HELD = 24,
    /** Attitude that follows the turns late; figure: the delay, negative if it is early [s]. */
    SINS_FINDING_ATTITUDE_LATE = 25,
    /** Attitude with noise; figure: noise of an angle [rad]. */
    SINS_FINDING_NOISY_ATTITUDE = 26,
    /** Velocity that follows the positions late; figure: the delay, negative if it is early [s]. */
    SINS_FINDING_VELOCITY_LATE = 27,
    /** Attitude in steps; figure: the step of an angle [rad]. */
    SINS_FINDING_COARSE_ATTITUDE = 28,
    /** Columns of a log that are not read contradict what flies; figure: number of them. */
    SINS_FINDING_UNREAD_CONTRADICTS = 29,
    /** Level flight above the air: height in a smaller unit than metres; figure: the height [m]. */
    SINS_FINDING_HEIGHT_ABOVE_AIR = 30,
    /** Roll, or pitch above the path, that is far off in straight flight; figure: the angle [rad]. */
    SINS_FINDING_ATTITUDE_TURNED = 31
} sins_finding_kind;

/** What a finding means for a flight of these samples. */
typedef enum sins_finding_level {
    /** It is true, and harms little. */
    SINS_LEVEL_NOTE = 0,
    /** The flight is not that of the vehicle in every respect: the errors of an INS on it are to be doubted. */
    SINS_LEVEL_DOUBTFUL = 1,
    /** The errors of an INS on this flight say nothing. */
    SINS_LEVEL_UNUSABLE = 2
} sins_finding_level;

/**
 * A judge of the samples of a flight. A handle is a checked key, like that of a sins_sim, and is never confused with one.
 * sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
 */
typedef struct sins_judge sins_judge;

/** What a judge found. */
typedef struct sins_finding {
    /** sizeof(sins_finding) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** What was found, of enum sins_finding_kind. */
    int32_t kind;
    /** What it means for a flight of these samples, of enum sins_finding_level. */
    int32_t level;
    /** Number of the sample where it begins or is largest, the first is 0. */
    uint64_t sample;
    /** Time stamp of that sample [s]. */
    double time_s;
    /** How often; 0: the whole flight. */
    uint64_t count;
    /** Its figure, see enum sins_finding_kind. */
    double figure;
    /** False acceleration that is flown for it; 0: none, or unknown [m/s2]. */
    double acceleration_m_s2;
    /** Largest horizontal error of an INS with ideal sensors for it, during the flight; 0: none, or unknown [m]. */
    double ins_error_m;
    /** It as a sentence, and what to do about it; UTF-8, terminated, cut if it is longer. */
    char sentence[384];
} sins_finding;

/**
 * Creates a judge, which looks at the samples of a flight before an INS flies them, or while it does: a library that is given knots,
 * degrees, 32-bit positions or held rows computes exact errors of a flight that nobody flew. Of the options it takes the Earth, and the
 * largest acceleration. NULL: the defaults.
 *
 * It takes 50 KB. Not for a real-time frame: it allocates. On an error *judge is unchanged, and sins_last_error(NULL, ...) on this thread
 * gives the reason.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_create(). SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 judges exist.
 *
 * ```c
 * sins_judge *judge = NULL;
 * sins_finding found[SINS_FINDINGS_MAX];
 * size_t doubts = 0, i;
 * SINS_INIT(found[0]);
 * SINS_INIT(sample);
 * sins_judge_create(NULL, &judge);
 * for (i = 0; i < 1000; i++) {
 *     sample.time_s = 0.1 * (double)i;
 *     sample.latitude_rad = 100.0 * sample.time_s / 6356752.0;
 *     sample.velocity_enu_m_s[1] = 100.0 * 3600.0 / 1852.0;
 *     sins_judge_push(judge, &sample);
 * }
 * sins_judge_get_findings(judge, found, SINS_FINDINGS_MAX, &doubts);
 * printf("%.48s\n", found[0].sentence);  // velocity is 1.95 times the displacement (knots?)
 * sins_judge_destroy(judge);
 * ```
 */
SINS_API sins_status SINS_CALL sins_judge_create(const sins_options *options, sins_judge **judge);

/**
 * Looks at the next sample of the flight. A time stamp that is not later than the one before becomes a finding. No allocation, less than
 * 1 us.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range; the sample counts as not pushed.
 */
SINS_API sins_status SINS_CALL sins_judge_push(sins_judge *judge, const sins_flight_sample *sample);

/**
 * Reads what was found in the samples so far, the worst first, and their number (count), at most SINS_FINDINGS_MAX.
 * findings[0].struct_size is the size in bytes of each element of findings. To ask for count only, give NULL for findings and a capacity
 * of 0. A finding is a statistic: in a flight of less than 200 samples it may come from a few. No allocation.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of findings; only count was written.
 */
SINS_API sins_status SINS_CALL sins_judge_get_findings(const sins_judge *judge, sins_finding *findings,
    size_t capacity, size_t *count);

/**
 * Destroys a judge.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_judge_destroy(sins_judge *judge);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_flight_sizeof {
    SINS_SIZEOF_FLIGHT_START = 72,
    SINS_SIZEOF_MANOEUVRE = 240,
    SINS_SIZEOF_FINDING = 448
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_FLIGHT_H */
