/*
 * sins_flight.h - embedded flights: the library computes the samples from manoeuvres. The conventions are those of sins.h.
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

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_flight_sizeof {
    SINS_SIZEOF_FLIGHT_START = 72,
    SINS_SIZEOF_MANOEUVRE = 240
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_FLIGHT_H */
