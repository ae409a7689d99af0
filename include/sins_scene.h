/*
 * sins_scene.h - scenes and flight logs, as texts. The conventions are those of sins.h.
 *
 * A scene describes a flight, the settings of the simulator, and the planned failures of the sensors. Its text
 * form is TOML. A log is a flight as a table of samples, also as text. The host reads the files; the library parses their
 * bytes:
 *
 *     sins_scene_parse(text, size, &scene);          SINS_SCENE_HAS_FAULTS: sins_scene_get_fault() gives each fault and its place
 *     sins_play_create(scene, log, &play);           log: sins_log_parse() of the file that SINS_SCENE_TEXT_LOG names, or NULL
 *     while (sins_play_run(play, records, 100, &written) == SINS_OK)   with temperature, failures, updates and unit of the scene;
 *         ...                                                          SINS_PLAY_END: the flight is over
 *     sins_play_get_simulator(play, &sim);           for every read
 *
 * A library that was built without the feature "scenes" lacks all functions of this header. A program that calls them directly
 * does not link with such a library, or does not start. A program that loads the library at run time looks up
 * sins_scene_create by dlsym() or GetProcAddress(): if it is not found, there are no scenes. All else is the same.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_SCENE_H
#define SINS_SCENE_H

#include "sins_ensemble.h"
#include "sins_flight.h"
#include "sins_unit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Scenes. */

/** A fault of the text of a scene or of a flight log. */
typedef struct sins_fault {
    /** sizeof(sins_fault) */
    uint32_t struct_size;
    /** Flags of enum sins_error_info_flags, or'ed: which of value, minimum and maximum there are. */
    uint32_t flags;
    /** Number of faults that are reported: at most the first 200 of the text. */
    uint64_t count;
    /**
     * Line of this fault in the text of the call, from 1; 0: the fault is in a value that the scene had before the call, or in a flight
     * record as a whole.
     */
    uint64_t line;
    /**
     * Column, in characters from 1. For a flight log: number of the column of the table, from 1; 1 for a flight record. 0: the same
     * meaning as 0 in line.
     */
    uint64_t column;
    /** The value at fault, in the unit of the key that path names. */
    double value;
    /** Least allowed value, in that unit; if the sentence says "more than", the limit itself is not allowed. */
    double minimum;
    /** Greatest allowed value, in that unit; if the sentence says "less than", the limit itself is not allowed. */
    double maximum;
    /**
     * Path of the value at fault, for sins_scene_get_value(). It can also be the name of a section, such as "gyro", or of an
     * item, such as "failure[0]". Terminated. Empty for a flight log, and if the text itself is at fault.
     */
    char path[96];
    /**
     * Sentence that names key, value and limit, and the key that was probably meant; UTF-8, terminated, cut if it is
     * longer.
     */
    char sentence[256];
} sins_fault;

/** A scene. A handle is a checked key, as that of sins_sim, and never taken for one. */
typedef struct sins_scene sins_scene;

/**
 * Creates the default scene: the recommended simulator with ideal sensors, at rest for an hour at latitude 0, longitude 0,
 * height 0, sampled at 100 Hz.
 *
 * On an error *scene is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason, as for every function of
 * scenes. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes exist. Functions of scenes allocate: only sins_scene_prepare()
 * and sins_scene_prepare_ensemble() are for a real-time frame. The other functions of scenes first check that enough memory
 * is free for the call. If another thread takes this memory during the call, the process ends. sins_log_parse() does the
 * same, except that running out of memory for the samples is always SINS_ERROR_OUT_OF_MEMORY.
 */
SINS_API sins_status SINS_CALL sins_scene_create(sins_scene **scene);

/**
 * Creates a scene from its text: TOML in UTF-8, at most 1 MiB. The library does not keep the bytes.
 * sins_scene_write_keys() and sins_scene_get_key() list the keys.
 *
 * SINS_SCENE_HAS_FAULTS: the text is not a valid scene; sins_scene_get_fault() gives every fault and its place. The handle
 * is made for that only: all other functions except sins_scene_destroy() return SINS_ERROR_BAD_STATE.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 *
 * ```c
 * const char text[] = "[flight]\nbuiltin = \"patrol\"\n[gyro]\nbias_deg_h = 0.01\n";
 * sins_scene *scene = NULL;
 * sins_sim *of_scene = NULL;
 * if (sins_scene_parse(text, sizeof text - 1, &scene) == SINS_OK)
 *     sins_scene_create_simulator(scene, &of_scene);
 * sins_get_gyro(of_scene, &gyro);
 * printf("%.2f deg/h\n", gyro.bias_rad_s[0] / SINS_DEG_PER_HOUR);  // 0.01 deg/h
 * sins_destroy(of_scene);
 * sins_scene_destroy(scene);
 * ```
 */
SINS_API sins_status SINS_CALL sins_scene_parse(const char *text, size_t size, sins_scene **scene);

/**
 * Reads fault `index` of the scene's text, from 0 in the order of the text; fault->count is the number of faults. After
 * sins_scene_set_values() and sins_scene_set_items() the faults are those of that call; none if it succeeded.
 *
 * SINS_ERROR_INVALID_ARGUMENT: there is no such fault.
 */
SINS_API sins_status SINS_CALL sins_scene_get_fault(const sins_scene *scene, size_t index, sins_fault *fault);

/**
 * Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
 * "over_the_pole", "coning", "commuter", "rock_size", "spin_accel", "gen_nav".
 *
 * SINS_ERROR_INVALID_ARGUMENT: no scene has that name.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_builtin(const char *name, sins_scene **scene);

/**
 * Reads the name of built-in scene `index`, from 0. buffer, capacity and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: there are no more.
 */
SINS_API sins_status SINS_CALL sins_scene_builtin_name(size_t index, char *buffer, size_t capacity, size_t *needed);

/**
 * Writes the scene as commented TOML, which sins_scene_parse() reads back to the same scene, to the bit.
 *
 * needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for the size
 * only. SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_INVALID_ARGUMENT: settings that do not go together, or
 * so many manoeuvres, failures and updates that the text would have more than 1 MiB. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_write(const sins_scene *scene, char *buffer, size_t capacity,
    size_t *needed);

/**
 * Writes every section and key of a scene, one in a line, with its values, its unit and its meaning. buffer, capacity and
 * needed as in sins_scene_write().
 */
SINS_API sins_status SINS_CALL sins_scene_write_keys(char *buffer, size_t capacity, size_t *needed);

/**
 * Creates the simulator of the scene, ready for the first sample: options, sensor errors, initial errors, mounting, gravity
 * disturbance. sins_scene_prepare() sets the failures and makes the updates at their times. If the flight is not a log,
 * sins_options.sample_period_s of the simulator is 1 / rate_hz.
 *
 * SINS_ERROR_INVALID_ARGUMENT: settings that do not go together.
 * SINS_ERROR_BAD_STATE: as sins_scene_parse().
 * SINS_ERROR_OUT_OF_MEMORY: as sins_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_simulator(const sins_scene *scene, sins_sim **sim);

/**
 * Creates the flight of the scene, composed of manoeuvres or built-in, on the scene's ellipsoid. A host samples it at k / rate
 * up to sins_scene_setup.flown_s.
 *
 * SINS_ERROR_BAD_STATE: the flight of the scene is a log, whose name is SINS_SCENE_TEXT_LOG; or as sins_scene_parse().
 * Else as sins_flight_create().
 */
SINS_API sins_status SINS_CALL sins_scene_create_flight(const sins_scene *scene, sins_flight **flight);

/**
 * Destroys a scene. Simulators and flights that were created from it stay valid.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_scene_destroy(sins_scene *scene);

/**
 * Prepares the next interval: call this function before each push, and call sins_step() before you call it again. The
 * sample gets the temperature of the scene, if the scene has one. The call sets and clears the failures of the scene on sim.
 * A failure begins at the first interval that starts at or after from_s, and ends at the first interval that starts at or
 * after until_s. If the scene plans no failure of an output, the call does not touch the failure of that output.
 *
 * The call also makes the updates ([[update]]) that are due at the last sample: the first one at or after the planned time. It
 * corrects the solution as sins_correct() does; then the solution has the error of the fix. That error is a normal random number. It
 * depends only on seed and run, on the kind and on the planned time, and no other random number changes. So a simulator goes on from a
 * snapshot with the same updates. An update in a jump of the truth, or at the last sample of the flight, is not made; of
 * several updates of one kind that are due, the last one counts. A height that follows the truth is not corrected.
 *
 * flight_start_s is the time stamp of the flight's first sample. No allocation, no system call.
 *
 * SINS_ERROR_BAD_HANDLE: scene or sim is not a valid handle.
 * SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s not from -2e10 to 2e10; or, if an update is due, as
 * sins_correct().
 * SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: if an update is due, as sins_correct().
 * SINS_ERROR_BAD_STATE: as sins_scene_parse(). After any error sim has not changed.
 */
SINS_API sins_status SINS_CALL sins_scene_prepare(const sins_scene *scene, sins_sim *sim, double flight_start_s,
    sins_flight_sample *sample);

/**
 * Prepares the next interval of all runs of an ensemble, as sins_scene_prepare() does for a simulator. At an update each run has a
 * fix of its own; a run that cannot be corrected diverges. No allocation, no system call.
 *
 * SINS_ERROR_BAD_HANDLE: scene or ensemble is not a valid handle. SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or
 * flight_start_s not from -2e10 to 2e10. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_prepare_ensemble(const sins_scene *scene, sins_ensemble *ensemble,
    double flight_start_s, sins_flight_sample *sample);

/**
 * Creates the unit of the scene ([unit]). Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_BAD_STATE: the scene has no unit; or as sins_scene_parse(). SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 units exist.
 */
SINS_API sins_status SINS_CALL sins_scene_create_unit(const sins_scene *scene, sins_unit **unit);

/**
 * Does what the scene plans at the panel ([[panel]]) in the last interval of sim, and updates the unit, as sins_unit_update() does: in its
 * place after each step. flight_start_s is the time stamp of the flight's first sample. An action acts in the interval in which
 * its time is, the start of the interval included. No allocation, no system call.
 *
 * SINS_ERROR_INVALID_ARGUMENT: flight_start_s not from -2e10 to 2e10.
 * SINS_ERROR_BAD_HANDLE: scene, unit or sim is not a valid handle.
 * SINS_ERROR_BAD_STATE: an entry at the wrong moment; sins_last_error(NULL, ...) says which; the unit was updated. As sins_unit_update();
 * as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_update_unit(const sins_scene *scene, sins_unit *unit, sins_sim *sim,
    double flight_start_s);

/**
 * Reads the options of the scene. sins_scene_set_values() sets them.
 *
 * SINS_ERROR_BAD_STATE: as sins_scene_parse(), as for all functions that read or set a part of a scene.
 */
SINS_API sins_status SINS_CALL sins_scene_get_options(const sins_scene *scene, sins_options *options);

/** Where the flight of a scene comes from: sins_scene_setup.flight. */
typedef enum sins_scene_flight {
    /** The flight is composed of manoeuvres. */
    SINS_SCENE_FLIGHT_MANOEUVRES = 0,
    /** The flight is that of a built-in scene, named by SINS_SCENE_TEXT_BUILTIN. */
    SINS_SCENE_FLIGHT_BUILTIN = 1,
    /** The flight is a log, named by SINS_SCENE_TEXT_LOG. */
    SINS_SCENE_FLIGHT_LOG = 2
} sins_scene_flight;

/** Settings of a scene for its flight and its output, to be read: sins_scene_set_values() sets them. */
typedef struct sins_scene_setup {
    /** sizeof(sins_scene_setup) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Kind of the flight, of enum sins_scene_flight. */
    int32_t flight;
    /** 1: samples get the temperature below; 0: samples get no temperature. */
    int32_t has_temperature;
    /** 1: a program shows neither progress nor summary; 0: it does. */
    int32_t quiet;
    /** 1: something is random, so that two runs of the scene differ; 0: all runs are equal. */
    int32_t is_random;
    /** Duration to fly, 0.036 to 3.6e8; 0: the whole flight, or the duration of the built-in scene [s]. */
    double duration_s;
    /**
     * Duration that will be flown [s]. 0 for a log (see sins_log_info.duration_s). 0 also if duration_s is longer
     * than the flight: sins_scene_write() rejects such a scene.
     */
    double flown_s;
    /** Sample rate, 1e-3 to 2e4; 0 for a log, which has its own time stamps [Hz]. */
    double rate_hz;
    /** Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if has_temperature is 0 [deg C]. */
    double temperature_c;
    /** Rate of change of the temperature, -277 to 277 [deg C/s]. */
    double temperature_change_c_s;
    /** Spacing of the records of a program, 5e-5 to 1e7; 0: the program's choice [s]. */
    double every_s;
} sins_scene_setup;

/** Reads the settings of a scene for its flight and its output. */
SINS_API sins_status SINS_CALL sins_scene_get_setup(const sins_scene *scene, sins_scene_setup *setup);

/**
 * Reads the flight of the scene, composed of manoeuvres or built-in: its start, its manoeuvres, their number (count), and
 * how many times all of them are flown (repeat). manoeuvres[0].struct_size is the size in bytes of each element of
 * manoeuvres. start and repeat may be NULL. To ask for count only, give NULL for manoeuvres and a capacity of 0.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of manoeuvres; only count was written.
 * SINS_ERROR_BAD_STATE: the flight is a log; or as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_get_manoeuvres(const sins_scene *scene, sins_flight_start *start,
    sins_manoeuvre *manoeuvres, size_t capacity, size_t *count, size_t *repeat);

/**
 * Composes the flight of the scene of an array of count manoeuvres, all flown repeat times; count * repeat is at most 4096.
 * start->earth is ignored: the ellipsoid is that of the scene's options. If the flight was a log before, the new flight is
 * sampled at 100 Hz.
 *
 * SINS_ERROR_INVALID_ARGUMENT: as sins_flight_create(), except that heights along the path are not checked.
 */
SINS_API sins_status SINS_CALL sins_scene_set_manoeuvres(sins_scene *scene, const sins_flight_start *start,
    const sins_manoeuvre *manoeuvres, size_t count, size_t repeat);

/** The texts of a scene: sins_scene_get_text(), sins_scene_set_text(). */
typedef enum sins_scene_text {
    /** Title: the scene in a few words. */
    SINS_SCENE_TEXT_TITLE = 0,
    /** Path of the flight log, relative to the scene's own folder. Setting it makes the flight a log. */
    SINS_SCENE_TEXT_LOG = 1,
    /** Name of the built-in scene whose flight is flown. Setting it selects that flight. */
    SINS_SCENE_TEXT_BUILTIN = 2,
    /** Folder of the output files of a program. */
    SINS_SCENE_TEXT_FOLDER = 3,
    /** Base name of the output files. */
    SINS_SCENE_TEXT_NAME = 4,
    /** Name of the file for the measured increments. */
    SINS_SCENE_TEXT_IMU = 5
} sins_scene_text;

/**
 * Reads a text of the scene; which is of enum sins_scene_text. An empty text means that it is not set. buffer, capacity
 * and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such text.
 */
SINS_API sins_status SINS_CALL sins_scene_get_text(const sins_scene *scene, int32_t which, char *buffer,
    size_t capacity, size_t *needed);

/**
 * Sets a text of the scene; which is of enum sins_scene_text. The text is UTF-8, terminated, at most 4096 bytes. An empty
 * text clears it, except SINS_SCENE_TEXT_LOG and SINS_SCENE_TEXT_BUILTIN, which cannot be empty.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
 */
SINS_API sins_status SINS_CALL sins_scene_set_text(sins_scene *scene, int32_t which, const char *text);

/**
 * A failure that a scene plans. Its fields from kind on are those of sins_failure; kind is not SINS_FAILURE_NONE.
 * sins_scene_set_items() sets the failures of a scene.
 */
typedef struct sins_planned_failure {
    /** sizeof(sins_planned_failure) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Sensor that fails, of enum sins_sensor. */
    int32_t sensor;
    /** Axis that fails: 0, 1, 2 for x, y, z of the sensor axes; 0 for the altimeter. */
    int32_t axis;
    /** Start of the failure, 0 to 1e9 since the start of the flight [s]. */
    double from_s;
    /** End of the failure, likewise; 0: the end of the flight [s]. */
    double until_s;
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
} sins_planned_failure;

/** Reads the number of failures that the scene plans. */
SINS_API sins_status SINS_CALL sins_scene_get_failure_count(const sins_scene *scene, size_t *count);

/**
 * Reads planned failure `index`, from 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such failure.
 */
SINS_API sins_status SINS_CALL sins_scene_get_failure(const sins_scene *scene, size_t index,
    sins_planned_failure *failure);

/* Values of a scene by their paths. */

/** What kind of value a key of a scene takes. */
typedef enum sins_scene_key_kind {
    /** Numbers; elements says how many. */
    SINS_SCENE_KEY_NUMBERS = 0,
    /** A whole number, not negative. */
    SINS_SCENE_KEY_WHOLE = 1,
    /** One of several words. */
    SINS_SCENE_KEY_WORD = 2,
    /** A text. */
    SINS_SCENE_KEY_TEXT = 3,
    /** true or false. */
    SINS_SCENE_KEY_FLAG = 4
} sins_scene_key_kind;

/** Flags of a sins_scene_key. */
typedef enum sins_scene_key_flags {
    /** The key belongs to the items of a list: its section stands in double brackets. */
    SINS_SCENE_KEY_IN_LIST = 1,
    /**
     * The fields minimum and maximum are the limits of each number. Without this flag there are no limits, or the limits depend
     * on other values.
     */
    SINS_SCENE_KEY_LIMITS = 2,
    /** 0 is allowed in addition to the values within the limits. It switches the quantity off. */
    SINS_SCENE_KEY_ZERO_IS_OFF = 4
} sins_scene_key_flags;

/** A key of the scene format. */
typedef struct sins_scene_key {
    /** sizeof(sins_scene_key) */
    uint32_t struct_size;
    /** Flags of enum sins_scene_key_flags, or'ed. */
    uint32_t flags;
    /** Number of keys of the format. */
    uint64_t count;
    /** Kind of the value, of enum sins_scene_key_kind. */
    int32_t kind;
    /** Number of numbers: 1; 3 for x, y, z; 9 for a matrix row by row; 0 for the other kinds. */
    int32_t elements;
    /**
     * A single number may be given in the place of all elements if this is not 0. It sets element k if bit k is set, and the other
     * elements are 0. 0: all elements must be given.
     */
    uint32_t spread;
    /** 0 */
    uint32_t reserved;
    /** Factor from the unit of the key to SI. It is 1 if the value is not a number. */
    double si_per_unit;
    /**
     * Least allowed value of each number, in the unit of name. If the kinds of items have different limits, it is the widest.
     * Other values of the scene may narrow the limits.
     */
    double minimum;
    /** Greatest allowed value, likewise. */
    double maximum;
    /** Section, such as "gyro" or "manoeuvre.sinusoid"; terminated, as all texts here. */
    char section[24];
    /** Name, such as "bias_deg_h": its value is in the unit of data sheets. */
    char name[40];
    /** Name of the key that takes the same quantity in SI, such as "bias_rad_s"; empty: name is that key. */
    char si_name[40];
    /** Unit of name, such as "deg/h"; empty: a pure number, or no number. */
    char unit[24];
    /** Unit of si_name, such as "rad/s". */
    char si_unit[24];
    /** Value in a scene that does not set the key, as sins_scene_get_value() gives it; empty: no value. */
    char default_value[32];
    /** Words that a key of SINS_SCENE_KEY_WORD takes, such as "exact|paper|polynomial". */
    char words[128];
    /**
     * Items of the list that use the key. "kind=turn|s_turn" means the items in which the value of the key `kind` is one of
     * these words. If there are several conditions, with a space between them, an item must meet all. Empty: all items.
     */
    char condition[96];
    /** Meaning, without unit. */
    char meaning[128];
} sins_scene_key;

/**
 * Reads key `index` of the scene format, from 0 in the order in which a scene is written.
 *
 * SINS_ERROR_INVALID_ARGUMENT: there are no more.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_get_key(size_t index, sins_scene_key *key);

/**
 * Reads the value at a path, as it stands in the text of a scene: "gyro.bias_deg_h" (all three), "gyro.bias_deg_h[1]" (that of
 * the y axis), "gyro.bias_rad_s" (in SI), "options.scheme", "manoeuvre[3].bank_deg", "manoeuvre[3].sinusoid[0].channel",
 * "failure[0].kind". Places in lists begin at 0. Words and texts are in quotes. The text is empty if the scene has no such
 * value. For example, flight.hours is empty if the scene flies the whole flight. The scene stores numbers in SI, so a number
 * read in another unit may be rounded. The scene does not store the name of a preset, only the errors that the preset sets.
 *
 * The paths "manoeuvre[3]" and "failure[0]" give all lines of an item, for sins_scene_set_items(). A built-in flight and a log
 * have no such manoeuvres. buffer, capacity and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: the path names no value, or the scene has no such item.
 */
SINS_API sins_status SINS_CALL sins_scene_get_value(const sins_scene *scene, const char *path, char *buffer,
    size_t capacity, size_t *needed);

/**
 * Sets up to 4096 values of the scene, all or none. values is a terminated text in UTF-8. Each line is path = value, with a path
 * as in sins_scene_get_value(). Blank lines and lines that begin with # are ignored. A value is written as in the text of a
 * scene, but words and texts need no quotes. An empty value (gyro.bias_deg_h =) sets the default of the key. If the path is
 * a single element (gyro.bias_deg_h[1] =), it sets 0. If a value is set twice, the last one counts. gyro.preset replaces all
 * errors of the gyros, accelerometer.preset those of the accelerometers, before the other lines are applied, wherever it
 * stands. flight.file and flight.builtin replace the flight.
 *
 * The scene is then checked as sins_scene_parse() checks a text. Set values that depend on each other in one call, such as the
 * kind of a manoeuvre and its quantities.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the scene would not be valid, and stays as it was. sins_scene_get_fault() gives every fault
 * with the line in values and the path.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_set_values(sins_scene *scene, const char *values);

/**
 * Replaces all items of a list, "manoeuvre", "failure", "update" or "panel". items is a terminated text with the items as in the
 * text of a scene: [[manoeuvre]] and its keys, and so on. sins_scene_get_value() gives the text of one item. To add, remove or move an
 * item, give the texts of all items that the list shall have, in order. An empty text removes all failures, updates or actions; for
 * "manoeuvre" an empty text is a fault. If the flight was a built-in flight, the manoeuvres begin at its start; if it was a log, at
 * latitude 0, longitude 0, height 0.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such list, or the scene would not be valid; it stays as it was. sins_scene_get_fault() gives
 * every fault with the line in items and the path.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
 */
SINS_API sins_status SINS_CALL sins_scene_set_items(sins_scene *scene, const char *list, const char *items);

/* Flight logs, and the samples of a scene. */

/**
 * Reads the name of file `index` beside the log, from 0: the files that the [log] of the scene names (file = "ATT.csv"), in alphabetical
 * order. buffer, capacity and needed as in sins_scene_write().
 *
 * SINS_ERROR_INVALID_ARGUMENT: there are no more.
 */
SINS_API sins_status SINS_CALL sins_scene_log_file_name(const sins_scene *scene, size_t index, char *buffer,
    size_t capacity, size_t *needed);

/**
 * Gives the scene the contents of a file beside the log, before sins_log_parse() joins it with the log; name is one of
 * sins_scene_log_file_name(). The bytes are copied, and kept until the scene is destroyed, the file is given again, or a file is given
 * after the [log] has ceased to name this one. Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the [log] of the scene names no such file; what was given before is unchanged.
 * SINS_ERROR_OUT_OF_MEMORY: no memory for the bytes. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_give_log_file(sins_scene *scene, const char *name, const char *text,
    size_t size);

/** A flight log in memory. A handle is a checked key, as that of sins_sim, and never taken for one. */
typedef struct sins_log sins_log;

/** Contents of a flight log. */
typedef struct sins_log_info {
    /** sizeof(sins_log_info) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Number of samples. */
    uint64_t samples;
    /** Duration from the first to the last sample [s]. */
    double duration_s;
    /**
     * The comment in the first line of a log with the columns of this library, UTF-8, terminated; empty: none, or the table of another
     * program.
     */
    char title[192];
} sins_log_info;

/**
 * Reads a flight log as the [log] of a scene says: which column has which quantity, in which unit, and whether its path is smoothed; a
 * scene flies only a log that was read by its own [log]. The text is UTF-8, UTF-16 with a byte order mark, or otherwise Windows-1252.
 * NULL for scene, or a scene without [log]: comma-separated values in lines that end with LF or CR LF. The first line that is not a
 * comment (#) names the columns, in any order; columns of other names are ignored, and a row with more fields than columns
 * is a fault:
 *
 * time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg, heading_rad
 * or _deg; optional: velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s, rate_z_rad_s;
 * force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c
 *
 * The three velocities are all present or all absent; so are the three rates, and the three forces. Without velocities the
 * samples have SINS_SAMPLE_NO_VELOCITY. Two columns of one quantity are a fault. Frames and signs are those of
 * sins_flight_sample. A log has at least two samples, each later than the one before. The ranges of the values are checked
 * when a sample is pushed. The library does not keep the bytes. Not for a real-time frame: it allocates, 184 bytes a
 * sample, and room for the text if it is not UTF-8.
 *
 * The text may also be a flight record: IGC, GPX 1.0 or 1.1, or FDR version 4 of X-Plane. Its path is smoothed; its attitude is that of
 * the FDR, of the [log], or else that of a coordinated flight without wind. Its samples are those of the path, 50 a second unless the
 * scene sets log.smooth_rate_hz, and several have the line of one fix. While it is fitted it allocates some KB a fix more.
 *
 * Where the [log] names columns of other files, their values are interpolated onto the times of the rows of the text; the host gives each
 * file to the scene before, by sins_scene_give_log_file(). A fault in such a file has line 0; its sentence begins with the name, and with
 * the line if it has one.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the text is not a valid flight log; fault (may be NULL) gets the first fault and its place,
 * sins_last_error(NULL, ...) gives both as a sentence, and *log is unchanged.
 * SINS_ERROR_OUT_OF_MEMORY: no memory for the samples, or 4096 logs exist.
 */
SINS_API sins_status SINS_CALL sins_log_parse(const char *text, size_t size, const sins_scene *scene, sins_log **log,
    sins_fault *fault);

/**
 * Makes a log of an array of count samples, as sins_log_parse() of a text: for hosts that have a flight in memory. samples[0].struct_size
 * is the size in bytes of each element of samples; struct_size of the other samples may be 0. A log has at least two samples, each later
 * than the one before, with values in their ranges. Its title is empty. The samples are copied. Not for a real-time frame: it allocates,
 * 176 bytes a sample.
 *
 * SINS_ERROR_INVALID_ARGUMENT: count is less than 2, or a value is out of its range; SINS_ERROR_TIME_ORDER: a sample is not later than the
 * one before. sins_last_error(NULL, ...) names the sample, and *log is unchanged.
 * SINS_ERROR_OUT_OF_MEMORY: as sins_log_parse().
 */
SINS_API sins_status SINS_CALL sins_log_create(const sins_flight_sample *samples, size_t count, sins_log **log);

/** Reads the number of samples of a log, its duration and its title. */
SINS_API sins_status SINS_CALL sins_log_get_info(const sins_log *log, sins_log_info *info);

/**
 * Reads sample `index`, from 0 in the order of the log, ready for sins_push_sample(). line (may be NULL) gets its line in
 * the text, from 1. No allocation.
 *
 * SINS_ERROR_INVALID_ARGUMENT: no such sample.
 */
SINS_API sins_status SINS_CALL sins_log_get_sample(const sins_log *log, size_t index, sins_flight_sample *sample,
    uint64_t *line);

/**
 * Looks at the samples of a log, one after the other, as sins_judge_push(). Where a coordinated flight stands in for the attitude of the
 * log, attitudes are not judged. What was wrong in the rows of a log that was smoothed is found too, as a note if the path does not have
 * it.
 *
 * SINS_ERROR_INVALID_ARGUMENT: a value out of its range, with the number of the sample; the samples before it were taken.
 * SINS_ERROR_BAD_HANDLE: judge or log is not a valid handle.
 */
SINS_API sins_status SINS_CALL sins_judge_push_log(sins_judge *judge, const sins_log *log);

/**
 * Destroys a flight log.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_log_destroy(sins_log *log);

/** The samples that a scene flies. */
typedef struct sins_scene_samples {
    /** sizeof(sins_scene_samples) */
    uint32_t struct_size;
    /** 0 */
    uint32_t reserved;
    /** Number of samples. */
    uint64_t count;
    /**
     * Number of sample intervals between two records of the program sins, at least 1. It follows from sins_scene_setup.every_s;
     * if every_s is 0, there are about 2000 records. The last sample has a record too.
     */
    uint64_t record_every;
    /** Time stamp of the first sample [s]. */
    double start_s;
    /** Time between two samples [s]; of a log, the mean. */
    double period_s;
    /** Time from the first to the last sample [s]. */
    double duration_s;
} sins_scene_samples;

/**
 * Reads which samples the scene flies. If the flight is composed of manoeuvres or is built-in, give NULL for `log`; sample k
 * is then sins_flight_sample_at(flight, k / rate_hz) of sins_scene_create_flight(). For a log, sample k is
 * sins_log_get_sample(log, k); the samples end at the duration that the scene sets.
 *
 * SINS_ERROR_INVALID_ARGUMENT: the flight is not valid, the log has no second sample within the duration, or
 * sins_scene_setup.every_s is less than the time between two samples.
 * SINS_ERROR_BAD_HANDLE: scene or log is not a valid handle.
 * SINS_ERROR_BAD_STATE: the flight is a log, and log is NULL; or as sins_scene_parse().
 */
SINS_API sins_status SINS_CALL sins_scene_get_samples(const sins_scene *scene, const sins_log *log,
    sins_scene_samples *samples);

/* Scenes in flight. */

/**
 * A scene in flight: its simulator, its unit if the scene has one, its samples, and the place in its plan. A handle is a checked key,
 * like that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its
 * functions.
 */
typedef struct sins_play sins_play;

/**
 * Makes a scene ready for its flight. The scene is copied: later changes of it, and its end, change nothing. If the flight of the
 * scene is made of manoeuvres or built in, log is NULL. If it is a log, log is that log, or NULL for a host that pushes all
 * samples; the log may be destroyed after this call.
 *
 * A scene in flight is all that a host needs: sins_play_next() flies to the next sample, sins_play_run() to the end,
 * sins_play_push() to a sample of the host. Each does what the scene plans: temperature, failures and updates, as
 * sins_scene_prepare(), then push and step, then the panel and the unit, as sins_scene_update_unit().
 *
 * Not for a real-time frame: it allocates. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators, units or scenes in flight exist.
 * SINS_ERROR_INVALID_ARGUMENT: settings that do not go together; or as sins_scene_get_samples().
 * SINS_ERROR_BAD_HANDLE: scene or log is not a valid handle. SINS_ERROR_BAD_STATE: as sins_scene_parse().
 *
 * ```c
 * sins_scene *patrol = NULL;
 * sins_play *play = NULL;
 * sins_sim *flown = NULL;
 * sins_record ends[3];
 * size_t count = 0;
 * SINS_INIT(ends[0]);
 * sins_scene_create_builtin("patrol", &patrol);
 * sins_scene_set_values(patrol, "flight.hours = 0.1\noutput.every_s = 180");
 * sins_play_create(patrol, NULL, &play);
 * sins_play_run(play, ends, 3, &count);
 * printf("%d records, the last one at %.0f s\n", (int)count, ends[2].time_s);  // 3 records, the last one at 360 s
 * sins_play_get_simulator(play, &flown);
 * sins_get_navigation(flown, &navigation);
 * printf("%.0f s\n", navigation.time_s);  // 360 s
 * printf("%s\n", sins_status_string(sins_play_next(play)));  // SINS_PLAY_END
 * sins_play_destroy(play);
 * sins_scene_destroy(patrol);
 * ```
 */
SINS_API sins_status SINS_CALL sins_play_create(const sins_scene *scene, const sins_log *log, sins_play **play);

/**
 * Flies to the next sample of the scene. The first call takes the first sample, which begins the first interval. No allocation, no
 * system call.
 *
 * SINS_PLAY_END: there is no further sample; nothing was flown.
 * SINS_GAP: as sins_push_sample().
 * SINS_ERROR_BAD_STATE: the scene is flown on samples of the host, or an entry at the panel came at the wrong moment; the interval was
 * flown. The errors of sins_push_sample() and sins_step(). The sentence of sins_last_error(NULL, ...) begins with the time stamp of the
 * sample, and its line if the flight is a log. After an error of a push or a step the next call tries the same interval again.
 * SINS_ERROR_BAD_HANDLE: play is not a valid handle, or its simulator or its unit was destroyed.
 */
SINS_API sins_status SINS_CALL sins_play_next(sins_play *play);

/**
 * Flies to a sample of the host, in place of the scene's next one: for a flight simulator, a cockpit, a stream of packets. The times of
 * the scene count from the first sample. The simulator is that of sins_scene_create_simulator(): a scene whose flight is not a log states
 * the period 1 / rate_hz. A sample that is rejected changes nothing of what later samples lead to. No allocation, no system call.
 *
 * SINS_GAP, and the errors: as sins_play_next().
 */
SINS_API sins_status SINS_CALL sins_play_push(sins_play *play, const sins_flight_sample *sample);

/**
 * Flies until the array of records is full, or to the end. There is a record of the first sample, of the last one, and in between as
 * far apart as the scene says (sins_scene_samples.record_every), those of the files of the program sins. capacity 0: no records; the
 * call flies to the end. A host that shows its progress, or that can be interrupted, calls the function again and again with a few
 * records each. written (may be NULL) gets the number of records, also on an error. No allocation.
 *
 * SINS_OK: the array is full. SINS_PLAY_END: the flight is over. The errors of sins_play_next().
 */
SINS_API sins_status SINS_CALL sins_play_run(sins_play *play, sins_record *records, size_t capacity, size_t *written);

/**
 * Flies until the array is full, or to the end, with the signals of each interval, as sins_get_imu() reads them: for a host's own
 * navigator or filter, which gets the increments of a whole stretch in one call. Corrections of sins_correct() act from the next call on.
 * The first sample of a flight begins the first interval, and has no element. imu[0].struct_size is the size in bytes of each element of
 * imu; that of the other elements may be anything. written (may be NULL) gets the number of elements, also on an error. No allocation, no
 * system call.
 *
 * SINS_OK: the array is full. SINS_PLAY_END: the flight is over. SINS_ERROR_INVALID_ARGUMENT: capacity is 0. The errors of
 * sins_play_next().
 */
SINS_API sins_status SINS_CALL sins_play_run_imu(sins_play *play, sins_imu *imu, size_t capacity, size_t *written);

/**
 * Takes over what another scene plans, from the next interval on: temperature, failures, updates, the panel, as an instructor changes them
 * in flight. Failures that are no longer planned end. Flight, options, errors of the sensors and unit stay. The scene is copied. Not for
 * a real-time frame: it allocates.
 *
 * SINS_ERROR_INVALID_ARGUMENT: settings that do not go together. SINS_ERROR_BAD_HANDLE: play or scene is not a valid handle.
 * SINS_ERROR_BAD_STATE: as sins_scene_parse(). After an error nothing has changed.
 */
SINS_API sins_status SINS_CALL sins_play_set_plan(sins_play *play, const sins_scene *scene);

/**
 * Lends the simulator, for every read, and for corrections, repositions and what else a host does between two samples. The handle
 * belongs to play: it is destroyed with it. Do not push samples and make steps with it.
 */
SINS_API sins_status SINS_CALL sins_play_get_simulator(sins_play *play, sins_sim **sim);

/**
 * Lends the unit, for every read, and for a panel of the host. The handle belongs to play: it is destroyed with it. Do not call
 * sins_unit_update() with it.
 *
 * SINS_ERROR_BAD_STATE: the scene has no unit.
 */
SINS_API sins_status SINS_CALL sins_play_get_unit(sins_play *play, sins_unit **unit);

/**
 * Reads what the INS shows: status and navigation of the unit, as sins_unit_get_status() and sins_unit_get_navigation(). Without a unit
 * the INS navigates: the navigation is that of sins_get_navigation(), all valid but rates and forces. status (may be NULL) and
 * navigation (may be NULL). No allocation, no system call.
 *
 * SINS_NEED_SAMPLE: no interval was flown. SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
 */
SINS_API sins_status SINS_CALL sins_play_get_shown(sins_play *play, sins_unit_status *status,
    sins_unit_navigation *navigation);

/**
 * Destroys a scene in flight with its simulator and its unit.
 *
 * SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
 */
SINS_API sins_status SINS_CALL sins_play_destroy(sins_play *play);

/** A buffer of this size holds every snapshot of a scene in flight that this release saves. */
#define SINS_PLAY_SNAPSHOT_MAX_SIZE 27648

/**
 * Saves the whole: the simulator, the unit, and the place in the plan. written (may be NULL) gets the size. The same state gives the same
 * bytes, on every platform. No allocation, no system call.
 *
 * SINS_ERROR_BUFFER_TOO_SMALL: see SINS_PLAY_SNAPSHOT_MAX_SIZE; buffer and written are unchanged.
 */
SINS_API sins_status SINS_CALL sins_play_snapshot_save(sins_play *play, void *buffer, size_t capacity,
    size_t *written);

/**
 * Continues from a snapshot, to the same bits. play was made of the same scene, and of the same log if the flight is one; it may have
 * flown elsewhere. Handles that it lends stay valid. Not for a real-time frame: it allocates.
 *
 * SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of a scene in flight, or are cut off, altered, of a newer release, or of a scene with
 * other options or another run; nothing has changed.
 * SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
 */
SINS_API sins_status SINS_CALL sins_play_snapshot_load(sins_play *play, const void *snapshot, size_t size);

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_scene_sizeof {
    SINS_SIZEOF_FAULT = 408,
    SINS_SIZEOF_SCENE_SETUP = 72,
    SINS_SIZEOF_PLANNED_FAILURE = 80,
    SINS_SIZEOF_SCENE_KEY = 592,
    SINS_SIZEOF_LOG_INFO = 216,
    SINS_SIZEOF_SCENE_SAMPLES = 48
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_SCENE_H */
