#include "option_table.h"

#include <string.h>

const struct option_section option_sections[OPTION_GROUPS] = {
    { "flight", 0, "the flight: file, builtin or [[manoeuvre]]; where it starts, with [[manoeuvre]]" },
    { "manoeuvre", 1, "one after the other; angles right and up positive" },
    { "manoeuvre.sinusoid", 1, "behind a manoeuvre of kind sinusoids, up to 6" },
    { "options", 0, "simulator" },
    { "gyro", 0, "gyro errors: preset, and what differs from it; one number for all axes or three" },
    { "accelerometer", 0, "accelerometer errors: likewise" },
    { "altimeter", 0, "altimeter errors, with the damped vertical channel" },
    { "start", 0, "errors at the start: computed less true" },
    { "mounting", 0, "where the sensor block sits, and what the INS wrongly believes of it: believed less true" },
    { "gravity", 0, "true gravity less normal gravity: constant, and random over the distance flown" },
    { "failure", 1, "of one output of a sensor, for a time; those of one output one after the other" },
    { "output", 0, "output" }
};

#define AT(member) #member, offsetof(struct settings, member)
#define MILLIGAL 1e-5
#define GRADES "ideal|strategic|navigation|tactical|industrial|consumer|paper2"

/* Section, name on the command line, key in a file, what it is, where it goes; then SI per unit and the unit. */
#define NUMBERS(group, kind, name, key, noun, member, unit, unit_text) \
    { group, kind, name, key, NULL, noun, AT(member), unit, unit_text, 0, 0 }
#define NUMBER(group, name, key, noun, member, unit, unit_text) \
    NUMBERS(group, OPTION_NUMBER, name, key, noun, member, unit, unit_text)
#define AXES(group, name, key, noun, member, unit, unit_text) \
    NUMBERS(group, OPTION_AXES, name, key, noun, member, unit, unit_text)
/* A number of the harness itself, with its limits. */
#define WITHIN(group, name, key, noun, member, unit_text, low, high) \
    { group, OPTION_NUMBER, name, key, NULL, noun, AT(member), 1, unit_text, low, high }
#define WORD(group, kind, name, key, operand, noun, member) \
    { group, kind, name, key, operand, noun, AT(member), 1, "", 0, 0 }
#define FLAG(group, name, key, noun, member, constant) \
    { group, OPTION_FLAG, name, key, "", noun, AT(member), constant, "", 0, 0 }

const struct option option_table[] = {
    WORD(GROUP_FLIGHT, OPTION_TEXT, NULL, "file", "LOG.csv", "flight log, seen from the scene file's folder", log),
    WORD(GROUP_FLIGHT, OPTION_TEXT, NULL, "builtin", "NAME", "built-in flight", builtin),
    WORD(GROUP_FLIGHT, OPTION_TEXT, NULL, "title", "TEXT", "the flight in words", title),
    WITHIN(GROUP_FLIGHT, "--hours", "hours", "duration; default the scene's own", hours, "h", 1e-5, 1e5),
    WITHIN(GROUP_FLIGHT, "--rate", "rate_hz", "sample rate, default 100; a log has its own time stamps", rate_hz, "Hz",
           0.4, 1e4),
    WORD(GROUP_FLIGHT, OPTION_CHOICE, "--motion", NULL, "rest|patrol", "motion of a simulation; default patrol",
         motion),
    WITHIN(GROUP_FLIGHT, NULL, "temperature_c", "temperature of the sensors at the begin", temperature_c, "deg C",
           -273.15, 1000),
    WITHIN(GROUP_FLIGHT, NULL, "temperature_change_c_h", "its change, steady", temperature_change_c_h, "deg C/h", -1e6,
           1e6),
    NUMBER(GROUP_FLIGHT, NULL, "latitude_deg", "latitude", start.latitude_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_FLIGHT, NULL, "longitude_deg", "longitude, east positive", start.longitude_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_FLIGHT, NULL, "height_m", "height above the ellipsoid", start.height_m, 1, "m"),
    NUMBER(GROUP_FLIGHT, NULL, "speed_m_s", "speed", start.speed_m_s, 1, "m/s"),
    NUMBER(GROUP_FLIGHT, NULL, "heading_deg", "course and heading", start.heading_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_FLIGHT, NULL, "roll_deg", "roll against the path, all the way", start.roll_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_FLIGHT, NULL, "pitch_deg", "pitch against the path, all the way", start.pitch_rad, SINS_DEG, "deg"),

    WORD(GROUP_MANOEUVRE, OPTION_CHOICE, NULL, "kind",
         "rest|straight|accelerate|climb|turn|roll|loop|s_turn|sinusoids", "kind", manoeuvre.kind),
    NUMBER(GROUP_MANOEUVRE, NULL, "duration_s", "duration; of a turn it follows", manoeuvre.duration_s, 1, "s"),
    NUMBER(GROUP_MANOEUVRE, NULL, "ramp_s", "time to set in and to end; default 5", manoeuvre.ramp_s, 1, "s"),
    NUMBER(GROUP_MANOEUVRE, NULL, "speed_change_m_s", "accelerate", manoeuvre.speed_change_m_s, 1, "m/s"),
    NUMBER(GROUP_MANOEUVRE, NULL, "height_change_m", "climb", manoeuvre.height_change_m, 1, "m"),
    NUMBER(GROUP_MANOEUVRE, NULL, "heading_change_deg", "turn; s_turn to both sides", manoeuvre.heading_change_rad,
           SINS_DEG, "deg"),
    NUMBER(GROUP_MANOEUVRE, NULL, "bank_deg", "turn", manoeuvre.bank_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_MANOEUVRE, NULL, "turns", "whole rolls or loops; swings of an s_turn", manoeuvre.turns, 1, ""),

    WORD(GROUP_SINUSOID, OPTION_CHOICE, NULL, "channel", "course|climb|speed|roll|pitch|heading", "what it moves",
         sinusoid.channel),
    NUMBER(GROUP_SINUSOID, NULL, "amplitude_deg", "amplitude of an angle", sinusoid.amplitude_rad, SINS_DEG, "deg"),
    NUMBER(GROUP_SINUSOID, NULL, "amplitude_m_s", "amplitude of the speed", sinusoid.amplitude_m_s, 1, "m/s"),
    NUMBER(GROUP_SINUSOID, NULL, "frequency_hz", "frequency", sinusoid.frequency_hz, 1, "Hz"),
    NUMBER(GROUP_SINUSOID, NULL, "phase_deg", "phase at the begin of the manoeuvre", sinusoid.phase_rad, SINS_DEG,
           "deg"),

    WORD(GROUP_MODEL, OPTION_CHOICE, "--scheme", "scheme", "exact|paper|polynomial", "mechanization", options.scheme),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--frame", "frame", "earth|geographic", "axes to navigate in", options.frame),
    WORD(GROUP_MODEL, OPTION_COUNT, "--subsamples", "subsamples", "N", "sub-increments of an update, default 2",
         options.subsamples),
    WORD(GROUP_MODEL, OPTION_COUNT, "--updates", "updates_per_sample", "N", "updates in a sample interval, default 1",
         options.updates_per_sample),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--vertical", "vertical", "damped|follow|free",
         "vertical channel; default damped", options.vertical),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--error-model", "error_model", "off|rk4", "error data 1; default off",
         options.error_model),
    FLAG(GROUP_MODEL, "--no-model", NULL, "without error data 1", options.error_model, SINS_ERROR_MODEL_OFF),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--earth", "earth", "wgs84|cgcs2000|grs80|krassovsky", "ellipsoid",
         options.earth),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--gravity", "gravity", "normal|somigliana", "gravity", options.gravity),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--axes", "axes", "rfu|frd", "right-forward-up or forward-right-down",
         options.axes),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--signal", "signal", "physical|closed-loop",
         "ideal signals, or with a trim that holds an error-free navigator", options.signal),
    NUMBER(GROUP_MODEL, "--closed-loop-time", "closed_loop_time_s", "time constant of that trim, default 30",
           options.closed_loop_time_s, 1, "s"),
    WORD(GROUP_MODEL, OPTION_SEED, "--seed", "seed", "N", "seed of all random streams", options.seed),
    WORD(GROUP_MODEL, OPTION_SEED, "--run", "run", "N", "number of the run in an ensemble", options.run),
    NUMBER(GROUP_MODEL, NULL, "sample_period_s", "stated period of a log; default its own time stamps",
           options.sample_period_s, 1, "s"),
    NUMBER(GROUP_MODEL, NULL, "max_gap_s", "longest interval between samples, default 2.5", options.max_gap_s, 1, "s"),
    NUMBER(GROUP_MODEL, NULL, "max_acceleration_m_s2", "beyond it truth has jumped, default 2000",
           options.max_acceleration_m_s2, 1, "m/s2"),

    WORD(GROUP_GYRO, OPTION_GRADES, "--preset", NULL, GRADES, "errors of gyros and accelerometers to begin with",
         grades),
    WORD(GROUP_GYRO, OPTION_CHOICE, "--gyro-preset", "preset", GRADES, "errors to begin with", grades[0]),
    AXES(GROUP_GYRO, "--gyro-bias", "bias_deg_h", "bias", gyro.bias_rad_s, SINS_DEG_PER_HOUR, "deg/h"),
    AXES(GROUP_GYRO, "--gyro-bias-sigma", "bias_sigma_deg_h", "turn-on bias sigma", gyro.bias_sigma_rad_s,
         SINS_DEG_PER_HOUR, "deg/h"),
    AXES(GROUP_GYRO, "--gyro-markov-sigma", "markov_sigma_deg_h", "Markov bias sigma", gyro.markov_sigma_rad_s,
         SINS_DEG_PER_HOUR, "deg/h"),
    AXES(GROUP_GYRO, "--gyro-markov-time", "markov_time_s", "Markov bias time", gyro.markov_time_s, 1, "s"),
    AXES(GROUP_GYRO, "--gyro-arw", "random_walk_deg_sqrt_h", "angle random walk", gyro.random_walk_rad_sqrt_s,
         SINS_DEG_PER_SQRT_HOUR, "deg/sqrt(h)"),
    AXES(GROUP_GYRO, NULL, "rate_random_walk_deg_h_sqrt_h", "rate random walk", gyro.rate_random_walk_rad_s_sqrt_s,
         SINS_DEG_PER_HOUR / 60, "deg/h/sqrt(h)"),
    AXES(GROUP_GYRO, NULL, "rate_ramp_deg_h2", "rate ramp", gyro.rate_ramp_rad_s2, SINS_DEG_PER_HOUR / 3600,
         "deg/h/h"),
    AXES(GROUP_GYRO, NULL, "flicker_deg_h", "bias instability B", gyro.flicker_rad_s, SINS_DEG_PER_HOUR, "deg/h"),
    AXES(GROUP_GYRO, NULL, "quantization_arcsec", "pulse", gyro.quantization_rad, SINS_ARCSEC, "arcsec"),
    AXES(GROUP_GYRO, "--gyro-scale", "scale_factor_ppm", "scale factor error", gyro.scale_factor, SINS_PPM, "ppm"),
    AXES(GROUP_GYRO, NULL, "scale_factor_asymmetry_ppm", "scale factor asymmetry", gyro.scale_factor_asymmetry,
         SINS_PPM, "ppm"),
    AXES(GROUP_GYRO, NULL, "scale_factor_nonlinearity_ppm_per_deg_s", "scale factor nonlinearity",
         gyro.scale_factor_nonlinearity_s_rad, SINS_PPM / SINS_DEG, "ppm/(deg/s)"),
    NUMBERS(GROUP_GYRO, OPTION_CROSS, "--gyro-misalignment", "misalignment_arcsec", "misalignment",
            gyro.misalignment_rad, SINS_ARCSEC, "arcsec"),
    AXES(GROUP_GYRO, NULL, "scale_factor_sigma_ppm", "scale factor sigma", gyro.scale_factor_sigma, SINS_PPM, "ppm"),
    NUMBERS(GROUP_GYRO, OPTION_CROSS, NULL, "misalignment_sigma_arcsec", "misalignment sigma",
            gyro.misalignment_sigma_rad, SINS_ARCSEC, "arcsec"),
    NUMBERS(GROUP_GYRO, OPTION_DIAGONAL, NULL, "g_sensitivity_deg_h_per_g", "g-sensitivity",
            gyro.g_sensitivity_rad_s_per_m_s2, SINS_DEG_PER_HOUR / SINS_STANDARD_GRAVITY, "deg/h/g"),
    AXES(GROUP_GYRO, NULL, "range_deg_s", "range", gyro.range_rad_s, SINS_DEG, "deg/s"),
    AXES(GROUP_GYRO, NULL, "bandwidth_hz", "bandwidth", gyro.bandwidth_hz, 1, "Hz"),
    AXES(GROUP_GYRO, NULL, "dead_zone_deg_h", "half the dead zone", gyro.dead_zone_rad_s, SINS_DEG_PER_HOUR, "deg/h"),
    NUMBER(GROUP_GYRO, NULL, "reference_temperature_c", "temperature of no further error",
           gyro.reference_temperature_c, 1, "deg C"),
    AXES(GROUP_GYRO, NULL, "bias_temperature_deg_h_per_k", "bias per kelvin", gyro.bias_temperature_rad_s_per_k,
         SINS_DEG_PER_HOUR, "deg/h/K"),
    AXES(GROUP_GYRO, NULL, "bias_temperature2_deg_h_per_k2", "bias per kelvin squared",
         gyro.bias_temperature2_rad_s_per_k2, SINS_DEG_PER_HOUR, "deg/h/K2"),
    AXES(GROUP_GYRO, NULL, "scale_factor_temperature_ppm_per_k", "scale factor error per kelvin",
         gyro.scale_factor_temperature_per_k, SINS_PPM, "ppm/K"),
    AXES(GROUP_GYRO, NULL, "scale_factor_temperature2_ppm_per_k2", "scale factor error per kelvin squared",
         gyro.scale_factor_temperature2_per_k2, SINS_PPM, "ppm/K2"),

    WORD(GROUP_ACCEL, OPTION_CHOICE, "--accel-preset", "preset", GRADES, "errors to begin with", grades[1]),
    AXES(GROUP_ACCEL, "--accel-bias", "bias_micro_g", "bias", accel.bias_m_s2, SINS_MICRO_G, "micro-g"),
    AXES(GROUP_ACCEL, "--accel-bias-sigma", "bias_sigma_micro_g", "turn-on bias sigma", accel.bias_sigma_m_s2,
         SINS_MICRO_G, "micro-g"),
    AXES(GROUP_ACCEL, "--accel-markov-sigma", "markov_sigma_micro_g", "Markov bias sigma", accel.markov_sigma_m_s2,
         SINS_MICRO_G, "micro-g"),
    AXES(GROUP_ACCEL, "--accel-markov-time", "markov_time_s", "Markov bias time", accel.markov_time_s, 1, "s"),
    AXES(GROUP_ACCEL, "--accel-vrw", "random_walk_micro_g_sqrt_hz", "white noise",
         accel.velocity_random_walk_m_s_sqrt_s, SINS_MICRO_G_PER_SQRT_HZ, "micro-g/sqrt(Hz)"),
    AXES(GROUP_ACCEL, NULL, "acceleration_random_walk_micro_g_sqrt_h", "acceleration random walk",
         accel.acceleration_random_walk_m_s2_sqrt_s, SINS_MICRO_G / 60, "micro-g/sqrt(h)"),
    AXES(GROUP_ACCEL, NULL, "ramp_micro_g_h", "ramp", accel.ramp_m_s3, SINS_MICRO_G / 3600, "micro-g/h"),
    AXES(GROUP_ACCEL, NULL, "flicker_micro_g", "bias instability B", accel.flicker_m_s2, SINS_MICRO_G, "micro-g"),
    AXES(GROUP_ACCEL, NULL, "quantization_mm_s", "pulse", accel.quantization_m_s, 1e-3, "mm/s"),
    AXES(GROUP_ACCEL, "--accel-scale", "scale_factor_ppm", "scale factor error", accel.scale_factor, SINS_PPM, "ppm"),
    AXES(GROUP_ACCEL, NULL, "scale_factor_asymmetry_ppm", "scale factor asymmetry", accel.scale_factor_asymmetry,
         SINS_PPM, "ppm"),
    AXES(GROUP_ACCEL, NULL, "scale_factor_nonlinearity_ppm_per_g", "scale factor nonlinearity",
         accel.scale_factor_nonlinearity_s2_m, SINS_PPM / SINS_STANDARD_GRAVITY, "ppm/g"),
    NUMBERS(GROUP_ACCEL, OPTION_CROSS, "--accel-misalignment", "misalignment_arcsec", "misalignment",
            accel.misalignment_rad, SINS_ARCSEC, "arcsec"),
    AXES(GROUP_ACCEL, NULL, "scale_factor_sigma_ppm", "scale factor sigma", accel.scale_factor_sigma, SINS_PPM, "ppm"),
    NUMBERS(GROUP_ACCEL, OPTION_CROSS, NULL, "misalignment_sigma_arcsec", "misalignment sigma",
            accel.misalignment_sigma_rad, SINS_ARCSEC, "arcsec"),
    AXES(GROUP_ACCEL, NULL, "range_g", "range", accel.range_m_s2, SINS_STANDARD_GRAVITY, "g"),
    AXES(GROUP_ACCEL, NULL, "bandwidth_hz", "bandwidth", accel.bandwidth_hz, 1, "Hz"),
    AXES(GROUP_ACCEL, NULL, "dead_zone_micro_g", "half the dead zone", accel.dead_zone_m_s2, SINS_MICRO_G, "micro-g"),
    NUMBERS(GROUP_ACCEL, OPTION_MATRIX, NULL, "lever_arm_mm", "place of x, y and z sensor", accel.lever_arm_m, 1e-3,
            "mm"),
    AXES(GROUP_ACCEL, NULL, "vibration_rectification_micro_g_per_g2", "vibration rectification",
         accel.vibration_rectification_s2_m, 1e-6 / SINS_STANDARD_GRAVITY, "micro-g/g2"),
    NUMBER(GROUP_ACCEL, NULL, "reference_temperature_c", "temperature of no further error",
           accel.reference_temperature_c, 1, "deg C"),
    AXES(GROUP_ACCEL, NULL, "bias_temperature_micro_g_per_k", "bias per kelvin", accel.bias_temperature_m_s2_per_k,
         SINS_MICRO_G, "micro-g/K"),
    AXES(GROUP_ACCEL, NULL, "bias_temperature2_micro_g_per_k2", "bias per kelvin squared",
         accel.bias_temperature2_m_s2_per_k2, SINS_MICRO_G, "micro-g/K2"),
    AXES(GROUP_ACCEL, NULL, "scale_factor_temperature_ppm_per_k", "scale factor error per kelvin",
         accel.scale_factor_temperature_per_k, SINS_PPM, "ppm/K"),
    AXES(GROUP_ACCEL, NULL, "scale_factor_temperature2_ppm_per_k2", "scale factor error per kelvin squared",
         accel.scale_factor_temperature2_per_k2, SINS_PPM, "ppm/K2"),

    NUMBER(GROUP_ALTIMETER, "--baro-bias", "bias_m", "bias", altimeter.bias_m, 1, "m"),
    NUMBER(GROUP_ALTIMETER, "--baro-noise", "noise_m", "noise of each sample", altimeter.noise_m, 1, "m"),
    NUMBER(GROUP_ALTIMETER, "--baro-markov-sigma", "markov_sigma_m", "Markov error sigma", altimeter.markov_sigma_m, 1,
           "m"),
    NUMBER(GROUP_ALTIMETER, "--baro-markov-time", "markov_time_s", "Markov error time", altimeter.markov_time_s, 1,
           "s"),
    NUMBER(GROUP_ALTIMETER, "--baro-scale", "scale_factor_ppm", "scale factor error", altimeter.scale_factor, SINS_PPM,
           "ppm"),
    NUMBER(GROUP_ALTIMETER, "--baro-lag", "lag_s", "lag", altimeter.lag_s, 1, "s"),

    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-position", "position_m", "position east, north, up",
            initial.position_enu_m, 1, "m"),
    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-velocity", "velocity_m_s", "velocity east, north, up",
            initial.velocity_enu_m_s, 1, "m/s"),
    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-misalignment", "misalignment_arcmin",
            "misalignment about east, north, up", initial.misalignment_enu_rad, SINS_ARCMIN, "arcmin"),
    AXES(GROUP_START, NULL, "position_sigma_m", "position sigma", initial.position_sigma_enu_m, 1, "m"),
    AXES(GROUP_START, NULL, "velocity_sigma_m_s", "velocity sigma", initial.velocity_sigma_enu_m_s, 1, "m/s"),
    AXES(GROUP_START, NULL, "misalignment_sigma_arcmin", "misalignment sigma", initial.misalignment_sigma_enu_rad,
         SINS_ARCMIN, "arcmin"),
    WORD(GROUP_START, OPTION_CHOICE, "--alignment", "alignment", "given|gyrocompass",
         "given, or with what levelling and gyrocompassing leave", initial.alignment),

    NUMBERS(GROUP_MOUNTING, OPTION_VECTOR, NULL, "lever_arm_m", "lever arm from the reference point",
            mounting.lever_arm_m, 1, "m"),
    NUMBERS(GROUP_MOUNTING, OPTION_VECTOR, NULL, "boresight_deg", "boresight roll, pitch, heading",
            mounting.boresight_rad, SINS_DEG, "deg"),
    NUMBERS(GROUP_MOUNTING, OPTION_VECTOR, NULL, "lever_arm_error_mm", "lever arm error",
            mounting.lever_arm_error_m, 1e-3, "mm"),
    NUMBERS(GROUP_MOUNTING, OPTION_VECTOR, NULL, "boresight_error_arcsec", "boresight error",
            mounting.boresight_error_rad, SINS_ARCSEC, "arcsec"),

    NUMBER(GROUP_GRAVITY, NULL, "deflection_north_arcsec", "meridian deflection (xi)",
           gravity.deflection_north_rad, SINS_ARCSEC, "arcsec"),
    NUMBER(GROUP_GRAVITY, NULL, "deflection_north_sigma_arcsec", "meridian deflection sigma",
           gravity.deflection_north_sigma_rad, SINS_ARCSEC, "arcsec"),
    NUMBER(GROUP_GRAVITY, NULL, "deflection_north_distance_km", "meridian correlation distance",
           gravity.deflection_north_distance_m, 1e3, "km"),
    NUMBER(GROUP_GRAVITY, NULL, "deflection_east_arcsec", "prime vertical deflection (eta)",
           gravity.deflection_east_rad, SINS_ARCSEC, "arcsec"),
    NUMBER(GROUP_GRAVITY, NULL, "deflection_east_sigma_arcsec", "prime vertical deflection sigma",
           gravity.deflection_east_sigma_rad, SINS_ARCSEC, "arcsec"),
    NUMBER(GROUP_GRAVITY, NULL, "deflection_east_distance_km", "prime vertical correlation distance",
           gravity.deflection_east_distance_m, 1e3, "km"),
    NUMBER(GROUP_GRAVITY, NULL, "anomaly_mgal", "anomaly", gravity.anomaly_m_s2, MILLIGAL, "mGal"),
    NUMBER(GROUP_GRAVITY, NULL, "anomaly_sigma_mgal", "anomaly sigma", gravity.anomaly_sigma_m_s2,
           MILLIGAL, "mGal"),
    NUMBER(GROUP_GRAVITY, NULL, "anomaly_distance_km", "anomaly correlation distance", gravity.anomaly_distance_m, 1e3,
           "km"),

    WORD(GROUP_FAILURE, OPTION_CHOICE, NULL, "sensor", "gyro|accelerometer|altimeter", "what fails", failing.sensor),
    WORD(GROUP_FAILURE, OPTION_CHOICE, NULL, "axis", "x|y|z", "of a gyro or an accelerometer", failing.axis),
    WORD(GROUP_FAILURE, OPTION_CHOICE, NULL, "kind", "none|stuck|dead|bias_step|spikes|noise|drop_outs",
         "none: switched off", failure.kind),
    WITHIN(GROUP_FAILURE, NULL, "from_s", "time since the begin of the flight, default 0", failing.from_s, "s", 0, 1e9),
    WITHIN(GROUP_FAILURE, NULL, "until_s", "likewise, default the end", failing.until_s, "s", 0, 1e9),
    /* The keys of one field in the order of SINS_SENSOR_... */
    NUMBER(GROUP_FAILURE, NULL, "size_deg_h", "bias step, spikes of a gyro", failure.size, SINS_DEG_PER_HOUR, "deg/h"),
    NUMBER(GROUP_FAILURE, NULL, "size_micro_g", "likewise of an accelerometer", failure.size, SINS_MICRO_G, "micro-g"),
    NUMBER(GROUP_FAILURE, NULL, "size_m", "likewise of the altimeter", failure.size, 1, "m"),
    NUMBER(GROUP_FAILURE, NULL, "density_deg_sqrt_h", "noise of a gyro", failure.density, SINS_DEG_PER_SQRT_HOUR,
           "deg/sqrt(h)"),
    NUMBER(GROUP_FAILURE, NULL, "density_micro_g_sqrt_hz", "likewise of an accelerometer", failure.density,
           SINS_MICRO_G_PER_SQRT_HZ, "micro-g/sqrt(Hz)"),
    NUMBER(GROUP_FAILURE, NULL, "density_m_sqrt_hz", "likewise of the altimeter", failure.density, 1, "m/sqrt(Hz)"),
    NUMBER(GROUP_FAILURE, NULL, "interval_s", "spikes, drop-outs: from one to the next", failure.interval_s, 1, "s"),
    NUMBER(GROUP_FAILURE, NULL, "duration_s", "spikes: length of one", failure.duration_s, 1, "s"),
    NUMBER(GROUP_FAILURE, NULL, "probability", "drop-outs without interval_s: that a sample interval is lost",
           failure.probability, 1, ""),

    WORD(GROUP_OUTPUT, OPTION_TEXT, "--out", "folder", "DIR", "folder of the output files; default sins_out", out),
    WORD(GROUP_OUTPUT, OPTION_TEXT, "--name", "name", "NAME", "base name of the output files; default from the scene",
         name),
    WORD(GROUP_OUTPUT, OPTION_TEXT, "--imu", "imu", "FILE.csv", "also the measured increments of every sample interval",
         imu),
    WITHIN(GROUP_OUTPUT, "--every", "every_s", "spacing of the records; default about 2000 of them", every_s, "s", 5e-5,
           1e7),
    FLAG(GROUP_OUTPUT, "--quiet", "quiet", "neither progress nor summary table", quiet, 1),
    FLAG(GROUP_OUTPUT, "--help", NULL, "this page", help, 1),
    FLAG(GROUP_OUTPUT, "--keys", NULL, "the keys of a scene file", keys, 1)
};

const size_t option_table_length = sizeof option_table / sizeof option_table[0];

/* Does not compile if struct settings is too small. */
typedef char settings_hold_the_table[sizeof option_table / sizeof option_table[0] <= SETTINGS_OPTIONS
                                             && (int)OPTION_GROUPS <= (int)SETTINGS_SECTIONS ? 1 : -1];

const struct option *option_of_field(const char *field)
{
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        if (strcmp(option_table[i].field, field) == 0) {
            return &option_table[i];
        }
    }
    return NULL;
}
