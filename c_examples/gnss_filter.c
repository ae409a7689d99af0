/*
 * gnss_filter LOG.csv [RUNS]: closes a loop around the INS. An error-state Kalman filter takes a fix of a GNSS receiver each second,
 * and the INS removes the errors that it estimates. Each run has tactical sensors with other random numbers. States, three components
 * each: position error p, velocity error u, misalignment psi, east-north-up; gyro bias bg, accelerometer bias ba, sensor axes:
 *
 *     p' = u - w x p      u' = f x psi + C ba - (2 W + w) x u + G p      psi' = -(W + w) x psi - C bg
 *
 * C turns sensor axes to east-north-up, f is the specific force, W the Earth rate, w the rate of east-north-up against the Earth, G
 * the gravity gradient. For errors below a kilometre the turn of east-north-up by p is negligible.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "sins_scene.h"
#define EACH(i, count) for (i = 0; i < (count); i++)
enum { P = 0, U = 3, PSI = 6, BG = 9, BA = 12, STATES = 15 };
enum { RATE_HZ = 100, SAMPLES_PER_STEP = 10, OUTAGE_START_S = 180, OUTAGE_END_S = 240 };
static const double FIX_SIGMA[6] = {3.0, 3.0, 5.0, 0.1, 0.1, 0.1}; /* of the receiver [m, m/s] */
static const double EARTH_RATE = 7.292115e-5, EARTH_RADIUS = 6371e3, GRAVITY = 9.8;

typedef double matrix[STATES][STATES];
typedef struct {
    matrix sigma2;               /* covariance of the errors that are left */
    double noise[STATES];        /* spectral density of the noise of each state */
    double c[3][3];              /* C at the last sample */
    double turn[3][3], force[3]; /* integrals of C [s] and of C f [m/s] since the last step of the covariance */
} filter;

/* Sums over all runs: squares of the horizontal position error and of its prediction [m2]; normalized squares of all states. */
static double before_outage2[2], after_outage2[2], nees[64];

static void require(sins_status status, const sins_sim *sim)
{
    char sentence[512] = "";
    if (status >= 0) return;
    sins_last_error(sim, sentence, sizeof sentence, NULL);
    fprintf(stderr, "gnss_filter: %s\n", sentence);
    exit(1);
}

/* A nearly normal number with the mean 0 and the standard deviation 1. */
static double normal(uint64_t *state)
{
    double sum = -6.0;
    for (int i = 0; i < 12; i++) {
        *state = *state * 6364136223846793005u + 1442695040888963407u;
        sum += (double)(*state >> 11) / 9007199254740992.0;
    }
    return sum;
}

/* m[row..][column..] += the cross product by v. */
static void add_cross(matrix m, int row, int column, const double v[3])
{
    int i;
    EACH(i, 3) {
        m[row + i][column + (i + 1) % 3] -= v[(i + 2) % 3];
        m[row + i][column + (i + 2) % 3] += v[(i + 1) % 3];
    }
}

/* out = a b' */
static void product(matrix a, matrix b, matrix out)
{
    int i, j, k;
    EACH(i, STATES) EACH(j, STATES) {
        out[i][j] = 0.0;
        EACH(k, STATES) out[i][j] += a[i][k] * b[j][k];
    }
}

/* Adds the interval that ends with this attitude to the integrals; imu is NULL at the start. */
static void add_interval(filter *f, const sins_navigation *navigation, const sins_imu *imu)
{
    const double *q = navigation->quaternion_nb, w = q[0], x = q[1], y = q[2], z = q[3];
    const double c[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    int i, j;
    EACH(i, 3) EACH(j, 3) {
        double mean = 0.5 * (f->c[i][j] + c[i][j]);
        f->c[i][j] = c[i][j];
        if (imu != NULL) {
            f->turn[i][j] += mean * imu->interval_s;
            f->force[i] += mean * imu->compensated_velocity_m_s[j];
        }
    }
}

/* A step of the covariance over t [s]: F P F' + Q with F = I + A + A A / 2. */
static void propagate(filter *f, const sins_navigation *navigation, double t)
{
    matrix a = {{0.0}}, transition, work;
    const double *v = navigation->velocity_enu_m_s;
    double east = v[0] / EARTH_RADIUS * t, north = v[1] / EARTH_RADIUS * t, latitude = navigation->latitude_rad;
    double earth[3] = {0.0, EARTH_RATE * cos(latitude) * t, EARTH_RATE * sin(latitude) * t};
    double rate[3] = {north, -east, -east * tan(latitude)}, turn[3];
    int i, j, k;
    add_cross(a, U, PSI, f->force);
    for (j = P; j <= PSI; j += 3) {
        EACH(i, 3) turn[i] = rate[i] - (j == PSI ? 1.0 : j == U ? 2.0 : 0.0) * earth[i];
        add_cross(a, j, j, turn);
    }
    EACH(i, 3) {
        a[P + i][U + i] = t;
        a[U + i][P + i] = GRAVITY / EARTH_RADIUS * t * (i == 2 ? 2.0 : -1.0);
        f->force[i] = 0.0;
        EACH(j, 3) {
            a[U + i][BA + j] = f->turn[i][j];
            a[PSI + i][BG + j] = -f->turn[i][j];
            f->turn[i][j] = 0.0;
        }
    }
    EACH(i, STATES) EACH(j, STATES) {
        transition[i][j] = (i == j) + a[i][j];
        EACH(k, STATES) transition[i][j] += 0.5 * a[i][k] * a[k][j];
    }
    product(transition, f->sigma2, work);
    product(transition, work, f->sigma2);
    EACH(i, STATES) f->sigma2[i][i] += f->noise[i] * t;
}

/* A fix: the receiver sees six errors, one after the other. Then the INS removes the estimate. */
static void fix(filter *f, sins_sim *sim, const double seen[6])
{
    sins_correction correction;
    double x[STATES] = {0.0}, row[STATES], variance, miss;
    int n, i, j;
    EACH(n, 6) {
        EACH(i, STATES) row[i] = f->sigma2[n][i];
        variance = row[n] + FIX_SIGMA[n] * FIX_SIGMA[n];
        for (i = STATES - 1, miss = seen[n] - x[n]; i >= 0; i--) x[i] += row[i] / variance * miss;
        EACH(i, STATES) EACH(j, STATES) f->sigma2[i][j] -= row[i] * row[j] / variance;
    }
    SINS_INIT(correction);
    EACH(i, 3) {
        correction.position_enu_m[i] = x[P + i];
        correction.velocity_enu_m_s[i] = x[U + i];
        correction.misalignment_enu_rad[i] = x[PSI + i];
        correction.gyro_bias_rad_s[i] = x[BG + i];
        correction.accel_bias_m_s2[i] = x[BA + i];
    }
    require(sins_correct(sim, &correction), sim);
}

/* e' P^-1 e, by the Cholesky factor of P. */
static double normalized_square(filter *f, double e[STATES])
{
    matrix l;
    double sum = 0.0;
    int i, j, k;
    EACH(i, STATES) {
        EACH(j, i + 1) {
            l[i][j] = f->sigma2[i][j];
            EACH(k, j) l[i][j] -= l[i][k] * l[j][k];
            l[i][j] = i == j ? sqrt(l[i][j]) : l[i][j] / l[j][j];
        }
        EACH(k, i) e[i] -= l[i][k] * e[k];
        sum += pow(e[i] /= l[i][i], 2.0);
    }
    return sum;
}

/* Sample k was flown: runs the filter, and each second compares the errors that are left with their covariance. */
static void after_step(filter *f, sins_sim *sim, size_t k, uint64_t *random, const sins_gyro_params *gyro,
                       const sins_accel_params *accel)
{
    sins_navigation navigation; sins_imu imu; sins_errors errors; sins_compensation found;
    int i, second = (int)(k / RATE_HZ);
    double seen[6], left[STATES], *sums = second == OUTAGE_END_S ? after_outage2 : before_outage2;
    SINS_INIT(navigation); SINS_INIT(imu); SINS_INIT(errors); SINS_INIT(found);
    require(sins_get_navigation(sim, &navigation), sim);
    add_interval(f, &navigation, sins_get_imu(sim, &imu) == SINS_OK ? &imu : NULL);
    if (k > 0 && k % SAMPLES_PER_STEP == 0) propagate(f, &navigation, (double)SAMPLES_PER_STEP / RATE_HZ);
    if (k == 0 || k % RATE_HZ != 0) return;
    if (second <= OUTAGE_START_S || second > OUTAGE_END_S) {
        /* The receiver shows the truth with noise: INS less receiver is the error of the INS less this noise. */
        require(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors), sim);
        EACH(i, 3) seen[i] = errors.position_enu_m[i] - FIX_SIGMA[i] * normal(random);
        EACH(i, 3) seen[3 + i] = errors.velocity_enu_m_s[i] - FIX_SIGMA[3 + i] * normal(random);
        fix(f, sim, seen);
    }
    require(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors), sim);
    require(sins_get_compensation(sim, &found), sim);
    EACH(i, 3) {
        left[P + i] = errors.position_enu_m[i];
        left[U + i] = errors.velocity_enu_m_s[i];
        left[PSI + i] = errors.misalignment_enu_rad[i];
        left[BG + i] = gyro->bias_rad_s[i] - found.gyro_bias_rad_s[i];
        left[BA + i] = accel->bias_m_s2[i] - found.accel_bias_m_s2[i];
    }
    if (second <= OUTAGE_START_S || second == OUTAGE_END_S)
        sums[0] += left[0] * left[0] + left[1] * left[1], sums[1] += f->sigma2[0][0] + f->sigma2[1][1];
    if (second % 10 == 0 && second / 10 < 64) nees[second / 10] += normalized_square(f, left) / STATES;
}

static void fly(const sins_log *log, uint64_t run)
{
    sins_sim *sim = NULL;
    sins_options options; sins_gyro_params gyro; sins_accel_params accel; sins_initial_errors initial; sins_flight_sample sample;
    filter f = {{{0.0}}, {0.0}, {{0.0}}, {{0.0}}, {0.0}};
    uint64_t random = 12345 + 1000003 * run;
    size_t k;
    int i, state;
    SINS_INIT(options); SINS_INIT(gyro); SINS_INIT(accel); SINS_INIT(initial); SINS_INIT(sample);
    options.vertical = SINS_VERTICAL_FREE;
    options.run = run;
    require(sins_create(&options, &sim), NULL);
    require(sins_gyro_preset(SINS_GRADE_TACTICAL, &gyro), NULL);
    require(sins_accel_preset(SINS_GRADE_TACTICAL, &accel), NULL);
    EACH(i, 3) {
        /* The program draws the biases itself, because it compares them with the estimates. */
        double sigma[5] = {3.0, 0.1, i == 2 ? 5e-3 : 1e-3, gyro.bias_sigma_rad_s[i], accel.bias_sigma_m_s2[i]};
        EACH(state, 5) f.sigma2[3 * state + i][3 * state + i] = sigma[state] * sigma[state];
        initial.position_sigma_enu_m[i] = sigma[0];
        initial.velocity_sigma_enu_m_s[i] = sigma[1];
        initial.misalignment_sigma_enu_rad[i] = sigma[2];
        gyro.bias_rad_s[i] = sigma[3] * normal(&random);
        accel.bias_m_s2[i] = sigma[4] * normal(&random);
        gyro.bias_sigma_rad_s[i] = accel.bias_sigma_m_s2[i] = 0.0;
        f.noise[PSI + i] = pow(gyro.random_walk_rad_sqrt_s[i], 2.0);
        f.noise[U + i] = pow(accel.velocity_random_walk_m_s_sqrt_s[i], 2.0);
    }
    require(sins_set_gyro(sim, &gyro), sim);
    require(sins_set_accel(sim, &accel), sim);
    require(sins_set_initial_errors(sim, &initial), sim);
    for (k = 0; sins_log_get_sample(log, k, &sample, NULL) == SINS_OK; k++) {
        require(sins_push_sample(sim, &sample), sim);
        require(sins_step(sim), sim);
        after_step(&f, sim, k, &random, &gyro, &accel);
    }
    require(sins_destroy(sim), NULL);
}

int main(int count, char **arguments)
{
    static char text[1 << 23];
    FILE *file = count > 1 ? fopen(arguments[1], "rb") : NULL;
    size_t size = file != NULL ? fread(text, 1, sizeof text, file) : 0;
    int runs = count > 2 ? atoi(arguments[2]) : 20, k;
    double least = 1e9, most = 0.0;
    sins_log *log = NULL;
    require(sins_log_parse(text, size, NULL, &log, NULL), NULL);
    EACH(k, runs) fly(log, (uint64_t)k);
    for (k = 1; k < 64 && nees[k] > 0.0; k++) least = fmin(least, nees[k] / runs), most = fmax(most, nees[k] / runs);
    printf("%d runs: horizontal position, rms error / predicted: %.4f\n", runs, sqrt(before_outage2[0] / before_outage2[1]));
    printf("after 60 s without fixes: %.2f m, predicted %.2f m; NEES/15 at %d moments: %.3f to %.3f\n",
           sqrt(after_outage2[0] / runs), sqrt(after_outage2[1] / runs), k - 1, least, most);
    return file != NULL ? fclose(file) : 1;
}
