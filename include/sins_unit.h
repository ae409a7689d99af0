/*
 * sins_unit.h - the unit: an INS as the rest of an aircraft knows it, with a mode selector, an alignment that takes its time, and a
 * status. The conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 *
 * In each frame of a host:
 *
 *     sins_push_sample(sim, &sample);
 *     sins_step(sim);
 *     sins_unit_update(unit, sim);
 *     sins_unit_get_status(unit, &status);                state, annunciators, reasons, minutes to go
 *     sins_unit_get_navigation(unit, sim, &navigation);   what the box shows: an output that is not valid is 0
 *
 * States: OFF - test - coarse alignment - fine alignment - ready - navigation; ATT: erection - attitude. docs/unit.md shows them,
 * with a day's use.
 */

#ifndef SINS_UNIT_H
#define SINS_UNIT_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Units. */

/** Times and limits of a unit. All zero, the default, is the unit that the comments describe. */
typedef struct sins_unit_params {
    /** sizeof(sins_unit_params) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Length of the test after power-up [s], 1e-3 to 1e6; 0: 5. The default is this library's. */
    double power_up_test_s;
    /**
     * Length of the coarse alignment, after which the attitude is valid [s], 1e-3 to 1e6; 0: 30. The default is
     * that of the open A320 simulator flybywiresim/aircraft.
     */
    double coarse_alignment_s;
    /**
     * Length of the whole alignment [s], 1e-3 to 1e6; 0: the default. The default is (5 + 0.002 L^2) min at the
     * latitude L in degrees: 5 min at the equator and 17 min at 78 degrees, as in the crew manual of the 737 MAX
     * (11.20.5); the formula is that of legoboyvdlp/A320-family.
     */
    double alignment_s;
    /** Length of an alignment with the stored heading [s], 1e-3 to 1e6; 0: 90. Manuals state 1 to 2 min. */
    double stored_heading_alignment_s;
    /** Length of a fast realignment [s], 1e-3 to 1e6; 0: 30. The default is that of flybywiresim/aircraft. */
    double realignment_s;
    /**
     * Length of an alignment of kind SINS_UNIT_ALIGNMENT_FAST [s], 1e-3 to 1e6; 0: 30. The default is this
     * library's.
     */
    double fast_alignment_s;
    /**
     * Time after OFF in which the unit stores position and heading [s], 1e-3 to 1e6; 0: 5. The default is that of
     * flybywiresim/aircraft.
     */
    double power_down_s;
    /**
     * Longest time at OFF after which a unit that navigated realigns instead of a whole alignment [s],
     * 1e-3 to 1e6; 0: none. It is for selectors without ALIGN. It acts only within power_down_s.
     */
    double quick_off_s;
    /**
     * Largest latitude at which the unit aligns at rest [rad], 0.01 to 1.56; 0: the default. The default is 82
     * degrees, that of flybywiresim/aircraft.
     */
    double max_latitude_rad;
    /**
     * Largest difference of latitude, and of longitude, between the entered and the stored position [rad],
     * 1e-9 to 4; 0: the default. A position further away is accepted when it is entered a second time. The default
     * is 1 degree, and this library's.
     */
    double position_tolerance_rad;
    /**
     * Largest difference between the entered latitude and that of the gyros [rad], 1e-9 to 4; 0: the default. The
     * default follows from the errors of the gyros that are set, see sins_unit_update().
     */
    double latitude_tolerance_rad;
    /**
     * Velocity of the unit beyond which an alignment stops [m/s], 1e-6 to 1000; 0: 0.15. The default is this
     * library's: a sway of 1 cm at 0.3 Hz has 0.02 m/s, taxiing at 1 kt 0.5 m/s.
     */
    double motion_threshold_m_s;
    /**
     * Distance from its place beyond which an alignment stops [m], 1e-6 to 1e6; 0: 0.2. A position that was
     * entered is dropped there, too, at the latest at 10 m. The default is this library's: a sway of 1 cm does not
     * matter, a slow start stops the alignment.
     */
    double motion_distance_m;
    /**
     * Time constant of the filter of this velocity [s], 1e-3 to 1e6; 0: 0.5. The default is that of
     * flybywiresim/aircraft.
     */
    double motion_filter_s;
    /**
     * Time from the start of an alignment in which motion is not tested [s], 1e-3 to 1e6; 0: 2. The default is
     * that of flybywiresim/aircraft.
     */
    double motion_inhibition_s;
    /**
     * Time at rest after which an alignment that was stopped starts again [s], 1e-3 to 1e6; 0: 5. The default is
     * this library's.
     */
    double still_s;
    /**
     * Ground speed of the navigation from which ALIGN ends it instead of realigning [m/s], 1e-3 to 10000; 0: the
     * default. The default is 20 kt, that of flybywiresim/aircraft.
     */
    double realignment_speed_m_s;
    /**
     * Time of straight and level flight in which ATT levels the attitude [s], 1e-3 to 1e6; 0: 30. Manuals state 20
     * to 30 s.
     */
    double erection_s;
    /**
     * Time constant with which the attitude of ATT follows the apparent vertical [s], 1e-3 to 1e6; 0: 120. The
     * default is this library's.
     */
    double erection_time_s;
    /**
     * Time without a signal of a gyro or accelerometer after which the unit fails [s], 1e-3 to 1e6; 0: 1. It is
     * the sum since the alignment, or the erection of ATT, began. The default is this library's.
     */
    double fault_s;
    /** Time that the battery lasts [s], 1e-3 to 1e6; 0: none. If 0, it lasts for ever. */
    double battery_s;
    /**
     * Least length of an alignment of kind SINS_UNIT_ALIGNMENT_IN_FLIGHT [s], 1e-3 to 1e6; 0: 180. Military
     * manuals state some minutes with turns; the default is this library's.
     */
    double in_flight_alignment_s;
    /**
     * Standard deviation of the heading at which an alignment in flight may end [rad], 1e-9 to 1; 0: the default.
     * The default is 0.1 degree, and this library's.
     */
    double in_flight_heading_rad;
    /**
     * Standard deviation of the heading above which a gyrocompass does not end [rad], 1e-9 to 4; 0: the default.
     * Until then the heading is not valid. When the time of the alignment is over, the status has
     * SINS_UNIT_REASON_NORTH_UNKNOWN. The default is 1 degree, and this library's: gyros of navigation grade reach
     * it at all latitudes up to 82 degrees, those of tactical grade at none. 4 accepts each heading.
     */
    double heading_limit_rad;
} sins_unit_params;

/** A buffer of this size holds every snapshot of a unit that this release saves. */
#define SINS_UNIT_SNAPSHOT_MAX_SIZE 2048

/** Positions of the mode selector. */
typedef enum sins_unit_mode {
    /** Off. */
    SINS_UNIT_OFF = 0,
    /**
     * Alignment. An aligned unit is ready and waits for SINS_UNIT_NAV. In navigation, at a ground speed below
     * realignment_speed_m_s, it is a fast realignment; at a higher speed the navigation is lost.
     */
    SINS_UNIT_ALIGN = 1,
    /** Navigation, after an alignment if the unit is not aligned. */
    SINS_UNIT_NAV = 2,
    /** Attitude, and a heading that was entered. Navigation is lost. */
    SINS_UNIT_ATT = 3
} sins_unit_mode;

/** Supplies of power. */
typedef enum sins_unit_power {
    /** The aircraft. */
    SINS_UNIT_POWER_AIRCRAFT = 0,
    /** The battery, which lasts battery_s. */
    SINS_UNIT_POWER_BATTERY = 1,
    /** None: the unit is off at once, and stores nothing. */
    SINS_UNIT_POWER_NONE = 2
} sins_unit_power;

/** Kinds of alignment. */
typedef enum sins_unit_alignment {
    /** Levelling and gyrocompassing on the measured increments. */
    SINS_UNIT_ALIGNMENT_GYROCOMPASS = 0,
    /**
     * Levelling on the measured increments, with the stored heading. Without one, and when the aircraft has moved since the unit was
     * switched on, a gyrocompass.
     */
    SINS_UNIT_ALIGNMENT_STORED_HEADING = 1,
    /**
     * Only in a simulation: after fast_alignment_s the unit has the true state, with the errors of sins_initial_errors that need no
     * alignment, drawn for this run. The vehicle may move. Until then only rates and forces are valid. An entered position is not used.
     */
    SINS_UNIT_ALIGNMENT_FAST = 2,
    /** The same at once, without a test after power-up. */
    SINS_UNIT_ALIGNMENT_INSTANT = 3,
    /** In flight, on positions and velocities of another sensor: see sins_unit_push_fix(). */
    SINS_UNIT_ALIGNMENT_IN_FLIGHT = 4
} sins_unit_alignment;

/**
 * A unit. A handle is a checked key, like that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same
 * thread gives the failures of its functions.
 */
typedef struct sins_unit sins_unit;

/** A fix of another sensor, such as a receiver of satellite navigation: position and velocity of the reference point of the samples. */
typedef struct sins_unit_fix {
    /** sizeof(sins_unit_fix) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Geodetic latitude, -pi/2 to pi/2 [rad]. */
    double latitude_rad;
    /** Longitude, east positive, -2 pi to 2 pi [rad]. */
    double longitude_rad;
    /** Height above the ellipsoid, -1e5 to 1e6 [m]. */
    double height_m;
    /** Velocity against the Earth, east-north-up, each -1e4 to 1e4 [m/s]. */
    double velocity_enu_m_s[3];
} sins_unit_fix;

/**
 * Creates a unit. If params is NULL, all are 0, the defaults. mode is SINS_UNIT_OFF; or SINS_UNIT_NAV for a unit that navigates
 * already, with the start of its simulator.
 *
 * A unit works with one simulator, which the host creates and sets as without a unit. In each frame the host pushes a sample, makes a
 * step, and calls sins_unit_update().
 *
 * After an error *unit is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason. Not for a real-time frame: it
 * allocates.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: mode is SINS_UNIT_ALIGN or SINS_UNIT_ATT.
 * SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 units exist.
 *
 * ```c
 * sins_sim *inertial = NULL;
 * sins_unit *unit = NULL;
 * sins_unit_status unit_status;
 * SINS_INIT(unit_status);
 * SINS_INIT(sample);
 * sample.latitude_rad = 40.0 * SINS_DEG;
 * sins_create(NULL, &inertial);
 * sins_unit_create(NULL, SINS_UNIT_OFF, &unit);
 * sins_unit_select(unit, SINS_UNIT_NAV);
 * for (sample.time_s = 0.0; sample.time_s <= 600.0; sample.time_s += 1.0) {
 *     sins_push_sample(inertial, &sample);
 *     if (sins_step(inertial) == SINS_OK) sins_unit_update(unit, inertial);
 *     if (sample.time_s == 60.0) sins_unit_enter_position(unit, 40.0 * SINS_DEG, 0.0);
 * }
 * sins_unit_get_status(unit, &unit_status);
 * printf("navigates: %d\n", unit_status.state == SINS_UNIT_STATE_NAVIGATION);  // navigates: 1
 * sins_unit_destroy(unit);
 * sins_destroy(inertial);
 * ```
 */
SINS_API sins_status SINS_CALL sins_unit_create(const sins_unit_params *params, int32_t mode, sins_unit **unit);

/**
 * Waits until the calls of other threads on this handle have returned, and destroys the unit. The handle is never used again.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_unit_destroy(sins_unit *unit);

/**
 * Sets times and limits. May be called at any moment; they act at once.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_unit_set_params(sins_unit *unit, const sins_unit_params *params);

/** Reads times and limits, as they were set. */
SINS_API sins_status SINS_CALL sins_unit_get_params(sins_unit *unit, sins_unit_params *params);

/**
 * Turns the mode selector, of enum sins_unit_mode. The unit follows with the next sins_unit_update().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such mode.
 */
SINS_API sins_status SINS_CALL sins_unit_select(sins_unit *unit, int32_t mode);

/**
 * Sets the supply of power, of enum sins_unit_power. The unit follows with the next sins_unit_update().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such supply.
 */
SINS_API sins_status SINS_CALL sins_unit_set_power(sins_unit *unit, int32_t power);

/**
 * Sets how the unit aligns, of enum sins_unit_alignment. With another kind an alignment in progress begins anew, and a unit that is ready
 * aligns again. A realignment is the same with each kind.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such kind.
 */
SINS_API sins_status SINS_CALL sins_unit_set_alignment(sins_unit *unit, int32_t kind);

/** Presses the button of the panel's test: the status has SINS_UNIT_IN_TEST for power_up_test_s. Nothing else changes. */
SINS_API sins_status SINS_CALL sins_unit_press_test(sins_unit *unit);

/**
 * Enters the present position: latitude, -pi/2 to pi/2 [rad], and longitude, -2 pi to 2 pi [rad]. A gyrocompass and an alignment with
 * the stored heading need it. If it is further from the stored position than position_tolerance_rad, it is not taken, and the
 * status has SINS_UNIT_REASON_POSITION_DISAGREES; the same position is taken when it is entered again.
 *
 * A position holds as long as the aircraft stands within motion_distance_m, at most 10 m, of where it was entered. Beyond it the unit
 * drops it, and the status has SINS_UNIT_REASON_NO_POSITION until the new one is entered; a realignment then keeps the position of the
 * navigation.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 * SINS_ERROR_BAD_STATE: the unit neither aligns nor is ready.
 */
SINS_API sins_status SINS_CALL sins_unit_enter_position(sins_unit *unit, double latitude_rad, double longitude_rad);

/**
 * Enters the heading of the mode ATT, -2 pi to 2 pi [rad]. The gyros carry it on. They measure the rotation of the Earth and the motion
 * over it too, so the heading drifts by Omega sin(latitude) + v_east tan(latitude)/R: 13 deg/h at rest at 60 degrees, 27 deg/h with
 * 250 m/s to the east there. A magnetic heading that is entered remains one.
 *
 * SINS_ERROR_INVALID_ARGUMENT: out of its range.
 * SINS_ERROR_BAD_STATE: the attitude of ATT is not valid.
 */
SINS_API sins_status SINS_CALL sins_unit_enter_heading(sins_unit *unit, double heading_rad);

/**
 * Sets what the unit stored when it was last switched off. An alignment with the stored heading takes the heading for that of the aircraft
 * when the unit was switched on: latitude, -pi/2 to pi/2, longitude, -pi to pi, and true heading, 0 to 2 pi
 * [rad]. A new unit has nothing stored. sins_unit_status has what a host may keep from one session to the next.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 */
SINS_API sins_status SINS_CALL sins_unit_set_stored(sins_unit *unit, double latitude_rad, double longitude_rad,
    double heading_rad);

/**
 * Takes the last step of the simulator: to be called after each step that was made. The unit reads the measured increments of the
 * step, and corrects the solution of the simulator, as sins_correct() does, in three cases: an alignment ends; a realignment ends;
 * while the unit does not navigate, once a minute, so that the solution stays near the truth. Truth, modelled sensors and random
 * numbers do not change. No allocation, no system call.
 *
 * docs/unit.md, "The alignment", has the equations of the alignment, of its heading error, and of the tests of motion and latitude.
 * An alignment that the test of motion stops starts anew after still_s at rest, and asks for the position if the aircraft has left its
 * place. After the first failure of the test of the latitude the position must be entered again; after the second the unit fails. A
 * gyrocompass whose heading has a standard deviation above heading_limit_rad goes on, with SINS_UNIT_REASON_NORTH_UNKNOWN. A
 * realignment of an aircraft that reaches realignment_speed_m_s loses the navigation.
 *
 * Signals: an interval in which a gyro or accelerometer has no signal shows no rates, and an alignment begins anew. When the sum of
 * such intervals since the alignment began is more than fault_s, the unit fails. Until then, attitude and heading are wrong by up to the
 * rotation in them, the velocity by up to the force times their length.
 *
 * If the truth jumps (sins_reposition(), sins_move_truth(), sins_reset()), an alignment or the erection of ATT starts anew, and the
 * position must be entered again. If the time does not continue from the last update (a pause that is not reported, an interval without
 * an update), it starts anew, too.
 *
 * SINS_ERROR_BAD_STATE: the simulator has made no step, or the unit has taken this step already.
 * SINS_ERROR_BAD_HANDLE: sim is not a simulator.
 * The errors of sins_correct(): the simulator rejects a correction. The unit has noted the interval and tries again with the next.
 */
SINS_API sins_status SINS_CALL sins_unit_update(sins_unit *unit, sins_sim *sim);

/**
 * Takes a fix at the time of the last sins_unit_update() with the same sim, for an alignment of kind SINS_UNIT_ALIGNMENT_IN_FLIGHT.
 * In every other state, and for other kinds, the call changes nothing, so a host may push each fix, for instance one a second.
 * No allocation, no system call.
 *
 * Roll and pitch are shown from the second window of coarse_alignment_s on, when their standard deviation is below 0.5 deg. The
 * alignment ends with the first window behind in_flight_alignment_s at whose end the standard deviation of the heading is at most
 * in_flight_heading_rad: docs/unit.md, "The alignment in flight", has the equations. Then attitude, position, height and velocity
 * become those that the window and its last fix show, and the call corrects the solution of the simulator, as sins_correct() does.
 * Until then, after this time, the status has SINS_UNIT_REASON_TURNS_NEEDED. A unit that waits at SINS_UNIT_ALIGN aligns on. A unit
 * of this kind whose selector is turned from SINS_UNIT_NAV to SINS_UNIT_ALIGN in flight aligns again. The unit does not judge fixes:
 * a wrong one that bounds a window stays in the sum, so that the alignment ends late or never, until it is begun anew.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_HANDLE: sim is not a simulator.
 * The errors of sins_correct(): the simulator rejects the correction; the unit has not taken the fix.
 */
SINS_API sins_status SINS_CALL sins_unit_push_fix(sins_unit *unit, sins_sim *sim, const sins_unit_fix *fix);

/**
 * Saves the whole unit; its simulator has a snapshot of its own. written (may be NULL) gets the size. The same state gives the same
 * bytes, on every platform. No allocation, no system call.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see SINS_UNIT_SNAPSHOT_MAX_SIZE; buffer and written are unchanged.
 */
SINS_API sins_status SINS_CALL sins_unit_snapshot_save(sins_unit *unit, void *buffer, size_t capacity,
    size_t *written);

/**
 * Replaces the unit by the saved one, including its parameters. It continues to the same bits with the simulator of the same moment.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of a unit, or are cut off, altered, or of a newer release; nothing has changed.
 */
SINS_API sins_status SINS_CALL sins_unit_snapshot_load(sins_unit *unit, const void *snapshot, size_t size);

/** What a unit is doing. */
typedef enum sins_unit_state {
    /** Off: it shows nothing. */
    SINS_UNIT_STATE_OFF = 0,
    /** The test after power-up. */
    SINS_UNIT_STATE_TEST = 1,
    /** Alignment without an attitude yet; also while the unit moves and cannot align. */
    SINS_UNIT_STATE_COARSE_ALIGNMENT = 2,
    /**
     * Alignment, with an attitude; from its half on with a heading, if a latitude was entered, or is stored and the aircraft stands where
     * the unit was switched on, and the sensors show north as accurately as heading_limit_rad. In flight it begins when the first windows
     * show an attitude, and the heading is valid when it is as accurate as in_flight_heading_rad. An alignment of kind
     * SINS_UNIT_ALIGNMENT_FAST shows neither.
     */
    SINS_UNIT_STATE_FINE_ALIGNMENT = 3,
    /** Aligned: it waits for SINS_UNIT_NAV, and continues to align. Its velocity is valid if it was aligned in flight. */
    SINS_UNIT_STATE_READY = 4,
    /** Navigation. */
    SINS_UNIT_STATE_NAVIGATION = 5,
    /** Fast realignment of a parked aircraft: velocity and tilt are removed, the heading is kept. An entered position is taken. */
    SINS_UNIT_STATE_REALIGNMENT = 6,
    /** ATT: levelling. The aircraft should fly straight and level. */
    SINS_UNIT_STATE_ERECTION = 7,
    /**
     * ATT: attitude by the gyros, which slowly follows the apparent vertical. In a long turn it follows a false one. It lags behind the
     * vertical by erection_time_s times the rate of the Earth and of the motion over it: 0.5 deg at rest on the equator.
     */
    SINS_UNIT_STATE_ATTITUDE = 8,
    /** Failed: it shows nothing until it is switched off. */
    SINS_UNIT_STATE_FAULT = 9,
    /** Switched off: it has stored position and heading, if they were valid. */
    SINS_UNIT_STATE_POWER_DOWN = 10
} sins_unit_state;

/** Flags of a sins_unit_status: annunciators, and what else is on. */
typedef enum sins_unit_annunciators {
    /** ALIGN is lit. */
    SINS_UNIT_ALIGN_LIT = 1,
    /** ALIGN flashes: something must be done, see the reasons. */
    SINS_UNIT_ALIGN_FLASHES = 2,
    /** NAV RDY. */
    SINS_UNIT_NAV_READY = 4,
    /** FAULT. */
    SINS_UNIT_FAULT = 8,
    /** ON BATT. */
    SINS_UNIT_ON_BATTERY = 16,
    /** The test after power-up, or that of the panel, is on. */
    SINS_UNIT_IN_TEST = 32,
    /** The field found_latitude_rad of the status holds a value. */
    SINS_UNIT_HAS_FOUND_LATITUDE = 64,
    /** The fields stored_... of the status hold values. */
    SINS_UNIT_HAS_STORED = 128
} sins_unit_annunciators;

/** Reasons why a unit is not ready, or has failed. */
typedef enum sins_unit_reasons {
    /** No position was entered, or the aircraft has left the place where it was; in flight: no fix came for a minute. */
    SINS_UNIT_REASON_NO_POSITION = 1,
    /** The entered position is too far from the stored one. Enter it again, or another one. */
    SINS_UNIT_REASON_POSITION_DISAGREES = 2,
    /** The gyros find another latitude than the entered one. Enter the position again. */
    SINS_UNIT_REASON_LATITUDE_DISAGREES = 4,
    /** The unit moves. The alignment starts anew at rest. */
    SINS_UNIT_REASON_MOTION = 8,
    /** The latitude is beyond max_latitude_rad. */
    SINS_UNIT_REASON_LATITUDE_TOO_HIGH = 16,
    /** A gyro or an accelerometer had no signal for fault_s. */
    SINS_UNIT_REASON_NO_SIGNAL = 32,
    /** The battery is empty. */
    SINS_UNIT_REASON_BATTERY_EMPTY = 64,
    /** In flight: in_flight_alignment_s is over, and the heading is not accurate enough yet. Turns or changes of speed show it. */
    SINS_UNIT_REASON_TURNS_NEEDED = 128,
    /**
     * The time of a gyrocompass is over, and the standard deviation of its heading is above heading_limit_rad: the sensors are too poor
     * to find north here. The alignment goes on. In SINS_UNIT_STATE_NAVIGATION: the simulator has started with
     * SINS_NAVIGATION_NORTH_UNKNOWN, and no unit has aligned it. Only rates, forces, roll and pitch are valid.
     */
    SINS_UNIT_REASON_NORTH_UNKNOWN = 256
} sins_unit_reasons;

/** Outputs of a unit that are valid. */
typedef enum sins_unit_validity {
    /** Angular rates and specific forces. */
    SINS_UNIT_VALID_RATES = 1,
    /** Roll and pitch. */
    SINS_UNIT_VALID_ATTITUDE = 2,
    /** Heading. */
    SINS_UNIT_VALID_HEADING = 4,
    /** Latitude and longitude. */
    SINS_UNIT_VALID_POSITION = 8,
    /** Velocity and height. */
    SINS_UNIT_VALID_VELOCITY = 16
} sins_unit_validity;

/** What a unit reports of itself. */
typedef struct sins_unit_status {
    /** sizeof(sins_unit_status) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** What it is doing, of enum sins_unit_state. */
    int32_t state;
    /** Position of the mode selector, of enum sins_unit_mode. */
    int32_t mode;
    /** Annunciators of enum sins_unit_annunciators, or'ed. */
    uint32_t annunciators;
    /** Reasons of enum sins_unit_reasons, or'ed. */
    uint32_t reasons;
    /** Valid outputs of enum sins_unit_validity, or'ed. */
    uint32_t validity;
    /** Whole minutes to the end of the alignment, rounded up; 0: none is in progress. */
    int32_t minutes_to_go;
    /** Time to the end of the alignment, the realignment or the erection [s]; 0: none is in progress, or it waits, see the reasons. */
    double to_go_s;
    /** Time in navigation since the last alignment [s]. */
    double in_navigation_s;
    /** With SINS_UNIT_HAS_FOUND_LATITUDE: magnitude of the latitude that the gyros found in the last alignment [rad]. */
    double found_latitude_rad;
    /** With SINS_UNIT_HAS_STORED: stored latitude [rad]. */
    double stored_latitude_rad;
    /** With SINS_UNIT_HAS_STORED: stored longitude [rad]. */
    double stored_longitude_rad;
    /** With SINS_UNIT_HAS_STORED: stored true heading [rad]. */
    double stored_heading_rad;
} sins_unit_status;

/** What a unit shows. An output that is not valid is 0; none is ever NaN. */
typedef struct sins_unit_navigation {
    /** sizeof(sins_unit_navigation) */
    uint32_t struct_size;
    /** Valid outputs of enum sins_unit_validity, or'ed. */
    uint32_t validity;
    /** Time of the last update [s]. */
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
    /** Heading, clockwise from true north, 0 to 2 pi [rad]. In ATT from the north of the heading that was entered. */
    double heading_rad;
    /** Measured angular rate against inertial space, body axes [rad/s]: the mean over the last interval. */
    double angular_rate_rad_s[3];
    /** Measured specific force, body axes [m/s2]: the mean over the last interval. */
    double specific_force_m_s2[3];
} sins_unit_navigation;

/** Reads what the unit reports. No allocation, no system call. */
SINS_API sins_status SINS_CALL sins_unit_get_status(sins_unit *unit, sins_unit_status *status);

/**
 * Reads what the unit shows. sim is the simulator of the last sins_unit_update(). In navigation and realignment, and while the
 * unit is ready, its valid attitude, position and velocity are those of sins_get_navigation(). No allocation, no system call.
 *
 * SINS_ERROR_BAD_HANDLE: sim is not a simulator.
 * SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: in these states, as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_unit_get_navigation(sins_unit *unit, const sins_sim *sim,
    sins_unit_navigation *navigation);

/* Words of ARINC 429. */

/** Flags of a sins_bus_inputs. */
typedef enum sins_bus_flags {
    /** The fields wind_... hold values. */
    SINS_BUS_WIND = 1,
    /** The field magnetic_variation_rad holds a value. */
    SINS_BUS_MAGNETIC_VARIATION = 2,
    /**
     * The bits of the label are reversed: the lowest byte of 310 is hexadecimal 13. ARINC 429 sends the most significant bit of the label
     * first, and calls it bit 1. Without this flag that bit is the highest of the lowest byte, which is then the number of the label, c8;
     * with it, that bit is the lowest of the word. The manual of a card says which order it takes. 45 degrees of latitude are e40000c8,
     * reversed e4000013.
     */
    SINS_BUS_REVERSED_LABEL = 4
} sins_bus_flags;

/** Statuses of a word. */
typedef enum sins_bus_word_status {
    /** The value is valid. */
    SINS_BUS_NORMAL = 0,
    /** There is no value. */
    SINS_BUS_NO_COMPUTED_DATA = 1,
    /** The equipment is in its test. */
    SINS_BUS_FUNCTIONAL_TEST = 2,
    /** The equipment has failed. A decimal word has no such status: it then says "no computed data". */
    SINS_BUS_FAILURE_WARNING = 3,
    /**
     * The status bits say normal, but the data are no value of the label: a decimal digit above its greatest value, or a value out of
     * the range of the quantity. No word is encoded so.
     */
    SINS_BUS_ILLEGAL_VALUE = 4
} sins_bus_word_status;

/** What a host knows beside the unit. All zero, or NULL: nothing; the words that need it say "no computed data". */
typedef struct sins_bus_inputs {
    /** sizeof(sins_bus_inputs) */
    uint32_t struct_size;
    /** Must be 0. */
    uint32_t reserved;
    /** Flags of enum sins_bus_flags, or'ed. */
    uint32_t flags;
    /** Source/destination identifier of the words, 0 to 3. Words whose data need these bits have none. */
    uint32_t source;
    /** Axes of the simulator, of enum sins_axes. */
    int32_t axes;
    /** Must be 0. */
    uint32_t reserved2;
    /** Wind speed, 0 to 500 [m/s]. */
    double wind_speed_m_s;
    /** Direction from which the wind blows, clockwise from true north, -10 to 10 [rad]. */
    double wind_direction_rad;
    /** Magnetic variation, east positive, -3.2 to 3.2 [rad]. */
    double magnetic_variation_rad;
} sins_bus_inputs;

/** A word and its time. */
typedef struct sins_bus_word {
    /** sizeof(sins_bus_word) */
    uint32_t struct_size;
    /** Number of the label: 200 is the octal 310. */
    uint32_t label;
    /**
     * The word: the label in the lowest byte, in the order of SINS_BUS_REVERSED_LABEL. From bit 9 of ARINC 429 on, bit n is bit n - 1 of
     * the integer, from 0.
     */
    uint32_t word;
    /** 0 */
    uint32_t reserved;
    /** Time of the word [s]. */
    double time_s;
} sins_bus_word;

/** A label of the table, with a decoded value where a function gives one. */
typedef struct sins_bus_label {
    /** sizeof(sins_bus_label) */
    uint32_t struct_size;
    /** Number of the label: 200 is the octal 310. */
    uint32_t label;
    /** Name, terminated: "ground speed". */
    char name[40];
    /** Unit of the value, terminated: "kt"; empty: a pure number, or single bits. */
    char unit[8];
    /** Value of the lowest bit or digit, in the unit. */
    double resolution;
    /** Time from one word to the next [s]; 0: an input, which the unit does not send. */
    double interval_s;
    /** Value of a decoded word, in the unit; 0 from sins_bus_get_label(); NaN if the data are no value of the label. */
    double value;
    /** Status of a decoded word, of enum sins_bus_word_status. The value counts only with SINS_BUS_NORMAL. */
    int32_t status;
    /** 0 */
    uint32_t reserved;
    /** Least value that a word of the label may have, in the unit. */
    double minimum;
    /** Greatest value that a word of the label may have, in the unit. */
    double maximum;
} sins_bus_label;

/**
 * Gives the words that are due after from_s and not after to_s, in the order of their times, into words[0] to words[*count - 1].
 * from_s is from -1e10 to 1e10 s, to_s from from_s to 10 s later. A time that is before a multiple of a millisecond by no more than
 * four roundings, 4 * DBL_EPSILON times itself, counts as the multiple. status and navigation are those of sins_unit_get_status()
 * and sins_unit_get_navigation(). Each label is sent at the multiples of its interval. A unit that is off sends nothing. A value
 * beyond the range of its label is the end of the range; angles of any direction wrap.
 *
 * The words show what navigation holds. A real unit is some 80 ms late: a host that wants that keeps status and navigation for this
 * time. A simulator without a panel sends words too, with a unit that was created with SINS_UNIT_NAV.
 *
 * inputs may be NULL. count gets the number of words that are due. With capacity 0, words may be NULL. No allocation, no system call.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: more words are due than capacity; *count has their number, and words the first ones.
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
 *
 * ```c
 * sins_unit_status bus_status;
 * sins_unit_navigation bus_navigation;
 * sins_bus_word word;
 * sins_bus_label label;
 * size_t word_count = 0;
 * SINS_INIT(bus_status);
 * SINS_INIT(bus_navigation);
 * SINS_INIT(word);
 * SINS_INIT(label);
 * bus_status.state = SINS_UNIT_STATE_NAVIGATION;
 * bus_navigation.validity = SINS_UNIT_VALID_POSITION;
 * bus_navigation.latitude_rad = 45.0 * SINS_DEG;
 * sins_bus_words(&bus_status, &bus_navigation, NULL, 0.09, 0.1, &word, 1, &word_count);
 * sins_bus_decode(word.word, 0, &label);
 * printf("label %o: %08lx, %g %s\n", (unsigned)label.label, (unsigned long)word.word, label.value, label.unit);  // label 310: e40000c8, 45 deg
 * ```
 */
SINS_API sins_status SINS_CALL sins_bus_words(const sins_unit_status *status, const sins_unit_navigation *navigation,
    const sins_bus_inputs *inputs, double from_s, double to_s, sins_bus_word *words, size_t capacity, size_t *count);

/**
 * Reads row `index` of the table of labels, from 0: what a unit sends, and the three inputs behind it.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such row.
 */
SINS_API sins_status SINS_CALL sins_bus_get_label(size_t index, sins_bus_label *label);

/**
 * Decodes a word of the table: its label, its value and its status. The status is SINS_BUS_ILLEGAL_VALUE and the value NaN if the status
 * bits say normal, but the data are no value of the label: a decimal digit above 9, 75 minutes, 99 degrees of latitude, a minus sign
 * where the range begins at 0. If the status is SINS_BUS_NORMAL, the host may give the value of an input, set latitude (041), set
 * longitude (042) or set heading (043), to sins_unit_enter_position() or sins_unit_enter_heading(); these do not accept NaN. flags is 0,
 * or SINS_BUS_REVERSED_LABEL.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the parity of the word is even, or the table does not have its label. sins_last_error() says which, and
 * whether there is a label with the bits in the other order.
 */
SINS_API sins_status SINS_CALL sins_bus_decode(uint32_t word, uint32_t flags, sins_bus_label *label);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_unit_sizeof {
    SINS_SIZEOF_UNIT_PARAMS = 200,
    SINS_SIZEOF_UNIT_FIX = 56,
    SINS_SIZEOF_UNIT_STATUS = 80,
    SINS_SIZEOF_UNIT_NAVIGATION = 136,
    SINS_SIZEOF_BUS_INPUTS = 48,
    SINS_SIZEOF_BUS_WORD = 24,
    SINS_SIZEOF_BUS_LABEL = 104
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_UNIT_H */
