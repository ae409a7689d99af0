#include "option_table.h"

#define AT(member) offsetof(struct settings, member)

/* Name, operand, what it is, where it goes; of numbers also unit, its name and the limits in it. */
#define WORD(group, kind, name, operand, noun, member) \
    { group, kind, name, operand, noun, "", AT(member), 0, 0, 1, 0, 0 }
#define COUNT(name, operand, noun, member, high) \
    { GROUP_MODEL, OPTION_COUNT, name, operand, noun, "", AT(member), 0, 0, 1, 1, high }
#define NUMBERS(group, kind, name, operand, noun, member, unit, unit_text, low, high) \
    { group, kind, name, operand, noun, unit_text, AT(member), 0, 0, unit, low, high }
#define MARKOV(group, name, operand, noun, member, time, count, unit, unit_text, high) \
    { group, OPTION_MARKOV, name, operand, noun, unit_text, AT(member), AT(time), count, unit, 0, high }

const struct option option_table[] = {
    WORD(GROUP_RUN, OPTION_TEXT, "--out", "DIR", "folder of the output files; default sins_out", out),
    WORD(GROUP_RUN, OPTION_TEXT, "--name", "NAME", "base name of the output files; default from the scene", name),
    WORD(GROUP_RUN, OPTION_TEXT, "--imu", "FILE.csv", "also the measured increments of every sample interval", imu),
    NUMBERS(GROUP_RUN, OPTION_NUMBER, "--hours", "H", "duration; default the scene's own",
            hours, 1, "h", 1e-5, 1e5),
    NUMBERS(GROUP_RUN, OPTION_NUMBER, "--rate", "HZ", "sample rate, default 100; a log has its own time stamps",
            rate_hz, 1, "Hz", 0.4, 1e4),
    NUMBERS(GROUP_RUN, OPTION_NUMBER, "--every", "SECONDS", "spacing of the records; default about 2000 of them",
            every_s, 1, "s", 5e-5, 1e7),
    WORD(GROUP_RUN, OPTION_CHOICE, "--motion", "rest|patrol", "motion of a simulation; default patrol", motion),
    WORD(GROUP_RUN, OPTION_SEED, "--seed", "N", "seed of all random streams", options.seed),
    WORD(GROUP_RUN, OPTION_SEED, "--run", "N", "number of the run in an ensemble", options.run),
    WORD(GROUP_RUN, OPTION_FLAG, "--quiet", "", "neither progress nor summary table", quiet),
    WORD(GROUP_RUN, OPTION_FLAG, "--help", "", "this page", help),

    WORD(GROUP_MODEL, OPTION_CHOICE, "--scheme", "exact|paper|polynomial", "mechanization", options.scheme),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--frame", "earth|geographic", "axes to navigate in", options.frame),
    COUNT("--subsamples", "N", "sub-increments of an update, default 2", options.subsamples, 5),
    COUNT("--updates", "N", "updates in a sample interval, default 1", options.updates_per_sample, 16),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--vertical", "damped|follow|free", "vertical channel; default follow",
         options.vertical),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--gravity", "normal|somigliana", "gravity", options.gravity),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--earth", "wgs84|cgcs2000|grs80|krassovsky", "ellipsoid", options.earth),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--axes", "rfu|frd", "right-forward-up or forward-right-down", options.axes),
    WORD(GROUP_MODEL, OPTION_CHOICE, "--signal", "physical|closed-loop",
         "ideal signals, or with a trim that holds an error-free navigator", options.signal),
    NUMBERS(GROUP_MODEL, OPTION_NUMBER, "--closed-loop-time", "S", "time constant of that trim, default 30",
            options.closed_loop_time_s, 1, "s", 1, 1e4),
    WORD(GROUP_MODEL, OPTION_FLAG, "--no-model", "", "without error data 1", no_model),

    WORD(GROUP_GYRO, OPTION_PRESET, "--preset", "paper2", "gyro and accelerometer errors of simulation2", gyro),
    NUMBERS(GROUP_GYRO, OPTION_AXES, "--gyro-bias", "DEG_PER_HOUR", "bias",
            gyro.bias_rad_s, SINS_DEG_PER_HOUR, "deg/h", -1e7, 1e7),
    NUMBERS(GROUP_GYRO, OPTION_AXES, "--gyro-bias-sigma", "DEG_PER_HOUR", "turn-on bias sigma",
            gyro.bias_sigma_rad_s, SINS_DEG_PER_HOUR, "deg/h", 0, 1e7),
    NUMBERS(GROUP_GYRO, OPTION_AXES, "--gyro-arw", "DEG_PER_SQRT_HOUR", "angle random walk",
            gyro.random_walk_rad_sqrt_s, SINS_DEG_PER_SQRT_HOUR, "deg/sqrt(h)", 0, 1e5),
    MARKOV(GROUP_GYRO, "--gyro-markov", "SIGMA_DEG_PER_HOUR,TIME_S", "Markov bias sigma",
           gyro.markov_sigma_rad_s, gyro.markov_time_s, 3, SINS_DEG_PER_HOUR, "deg/h", 1e7),
    NUMBERS(GROUP_GYRO, OPTION_AXES, "--gyro-scale", "PPM", "scale factor error",
            gyro.scale_factor, SINS_PPM, "ppm", -1e6, 1e6),
    NUMBERS(GROUP_GYRO, OPTION_MATRIX, "--gyro-misalignment", "ARCSEC", "misalignment",
            gyro.misalignment_rad, SINS_ARCSEC, "arcsec", -2e5, 2e5),

    NUMBERS(GROUP_ACCEL, OPTION_AXES, "--accel-bias", "MICRO_G", "bias",
            accel.bias_m_s2, SINS_MICRO_G, "micro-g", -1e9, 1e9),
    NUMBERS(GROUP_ACCEL, OPTION_AXES, "--accel-bias-sigma", "MICRO_G", "turn-on bias sigma",
            accel.bias_sigma_m_s2, SINS_MICRO_G, "micro-g", 0, 1e9),
    NUMBERS(GROUP_ACCEL, OPTION_AXES, "--accel-vrw", "MICRO_G_PER_SQRT_HZ", "white noise",
            accel.velocity_random_walk_m_s_sqrt_s, SINS_MICRO_G_PER_SQRT_HZ, "micro-g/sqrt(Hz)", 0, 1e8),
    MARKOV(GROUP_ACCEL, "--accel-markov", "SIGMA_MICRO_G,TIME_S", "Markov bias sigma",
           accel.markov_sigma_m_s2, accel.markov_time_s, 3, SINS_MICRO_G, "micro-g", 1e9),
    NUMBERS(GROUP_ACCEL, OPTION_AXES, "--accel-scale", "PPM", "scale factor error",
            accel.scale_factor, SINS_PPM, "ppm", -1e6, 1e6),
    NUMBERS(GROUP_ACCEL, OPTION_MATRIX, "--accel-misalignment", "ARCSEC", "misalignment",
            accel.misalignment_rad, SINS_ARCSEC, "arcsec", -2e5, 2e5),

    NUMBERS(GROUP_ALTIMETER, OPTION_NUMBER, "--baro-bias", "M", "bias",
            altimeter.bias_m, 1, "m", -1e5, 1e5),
    NUMBERS(GROUP_ALTIMETER, OPTION_NUMBER, "--baro-noise", "M", "noise of each sample",
            altimeter.noise_m, 1, "m", 0, 1e5),
    MARKOV(GROUP_ALTIMETER, "--baro-markov", "SIGMA_M,TIME_S", "Markov error sigma",
           altimeter.markov_sigma_m, altimeter.markov_time_s, 1, 1, "m", 1e5),
    NUMBERS(GROUP_ALTIMETER, OPTION_NUMBER, "--baro-scale", "PPM", "scale factor error",
            altimeter.scale_factor, SINS_PPM, "ppm", -1e6, 1e6),
    NUMBERS(GROUP_ALTIMETER, OPTION_NUMBER, "--baro-lag", "S", "lag",
            altimeter.lag_s, 1, "s", 0, 1e4),

    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-position", "E,N,U", "position",
            initial.position_enu_m, 1, "m", -1e6, 1e6),
    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-velocity", "E,N,U", "velocity",
            initial.velocity_enu_m_s, 1, "m/s", -1e4, 1e4),
    NUMBERS(GROUP_START, OPTION_VECTOR, "--initial-misalignment", "E,N,U", "misalignment",
            initial.misalignment_enu_rad, SINS_ARCMIN, "arcmin", -10800, 10800),
    WORD(GROUP_START, OPTION_CHOICE, "--alignment", "given|gyrocompass", "alignment", initial.alignment)
};

const size_t option_table_length = sizeof option_table / sizeof option_table[0];

size_t option_elements(const struct option *option, const size_t **which)
{
    static const size_t in_turn[3] = { 0, 1, 2 };
    static const size_t off_diagonal[6] = { 1, 2, 3, 5, 6, 7 };

    *which = option->kind == OPTION_MATRIX ? off_diagonal : in_turn;
    switch (option->kind) {
    case OPTION_NUMBER:
        return 1;
    case OPTION_MARKOV:
        return option->count;
    case OPTION_AXES:
    case OPTION_VECTOR:
        return 3;
    case OPTION_MATRIX:
        return 6;
    default:
        return 0;
    }
}
