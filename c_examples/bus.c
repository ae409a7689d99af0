/* An INS on a bus: the words of ARINC 429 that a unit sends, given to the send function of a card. This one prints them. As those of a
 * real unit, they show what was so 80 ms ago. */

#include <stdio.h>

#include "sins_unit.h"

enum { WORDS = 256, LATE = 8 /* samples of 10 ms */ };

/* In its place stands the function of the card. */
static void send_word(const sins_bus_word *word)
{
    sins_bus_label label;
    SINS_INIT(label);
    if (sins_bus_decode(word->word, 0, &label) == SINS_OK && label.status == SINS_BUS_NORMAL) {
        printf("%7.3f s  label %03o  %08lx  %s %.4f %s\n", word->time_s, (unsigned)label.label, (unsigned long)word->word, label.name,
               label.value, label.unit);
    }
}

int main(void)
{
    sins_sim *sim = NULL;
    sins_unit *unit = NULL;
    sins_gyro_params gyro;
    sins_flight_sample sample;
    sins_unit_status status[LATE]; /* a ring: the newest replaces the oldest */
    sins_unit_navigation navigation[LATE];
    sins_bus_inputs inputs;
    sins_bus_word words[WORDS];
    size_t count, i;
    int k;

    SINS_INIT(gyro);
    SINS_INIT(sample);
    for (k = 0; k < LATE; k++) {
        SINS_INIT(status[k]);
        SINS_INIT(navigation[k]);
    }
    SINS_INIT(inputs);
    SINS_INIT(words[0]);
    gyro.bias_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR;
    inputs.flags = SINS_BUS_MAGNETIC_VARIATION;
    inputs.magnetic_variation_rad = 3.0 * SINS_DEG;
    sample.latitude_rad = 48.0 * SINS_DEG;
    sample.heading_rad = 90.0 * SINS_DEG;
    if (sins_create(NULL, &sim) != SINS_OK || sins_set_gyro(sim, &gyro) != SINS_OK) {
        return 1;
    }
    if (sins_unit_create(NULL, SINS_UNIT_NAV, &unit) != SINS_OK) {
        return 1;
    }
    for (k = 0; k <= 100; k++) {
        double before_s = sample.time_s;
        sample.time_s = k / 100.0;
        if (sins_push_sample(sim, &sample) < 0 || sins_step(sim) < 0) {
            return 1;
        }
        if (k == 0 || sins_unit_update(unit, sim) != SINS_OK) {
            continue;
        }
        count = 0;
        if (k > LATE && sins_bus_words(&status[k % LATE], &navigation[k % LATE], &inputs, before_s, sample.time_s, words, WORDS, &count)) {
            return 1;
        }
        sins_unit_get_status(unit, &status[k % LATE]);
        sins_unit_get_navigation(unit, sim, &navigation[k % LATE]);
        for (i = 0; i < count && k == 100; i++) {
            send_word(&words[i]);
        }
    }
    return sins_unit_destroy(unit) == SINS_OK && sins_destroy(sim) == SINS_OK ? 0 : 1;
}
