/* A program that includes the headers, for compilers with the warnings of strict projects. Compiled, not run. */

#if defined(__cplusplus) && __cplusplus >= 201103L
#include "sins_analysis.hpp"
#include "sins_scene.hpp"
#endif
#include "../../c_examples/sins_loader.h"

#if SINS_VERSION != SINS_VERSION_NUM(SINS_VERSION_MAJOR, SINS_VERSION_MINOR, SINS_VERSION_PATCH) \
    || SINS_VERSION / 1000000 != SINS_VERSION_MAJOR || SINS_VERSION_NUM(0, 9, 999) >= SINS_VERSION_NUM(0, 10, 0) \
    || SINS_VERSION_NUM(0, 999, 999) >= SINS_VERSION_NUM(1, 0, 0)
#error "releases are not in order"
#endif

int main(int count, char **arguments)
{
    sins_loader sins;
    sins_gyro_params gyro;
    sins_flight_sample samples[2];
    char message[200];

    SINS_INIT(gyro);
    SINS_INIT(samples[1]);
    gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR;
    return sins_loader_open(&sins, arguments[count - 1], message, sizeof message) && sins_loader_close(&sins) ? 0 : 1;
}
