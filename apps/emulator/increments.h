/* The measured increments as lines. */
#pragma once
#include "lines.h"
#include "scene.h"

/* Adds a line for each part of the last interval of sim, which ends at end_s, as `sins fly` does. */
inline void add_increments(Lines &lines, const sins::Simulator &sim, double end_s) {
    std::vector<sins_imu_increment> updates(1, sins::make<sins_imu_increment>());
    size_t left = 0;
    for (; sim.get_imu_update((int32_t)updates.size() - 1, updates.back()); updates.push_back(updates.back()))
        left += updates.back().count;
    updates.pop_back();
    for (const sins_imu_increment &update : updates) {
        for (int part = 0; part < update.count; part++) {
            double time_s = end_s - (double)--left * (update.interval_s / update.count);
            std::string line = shortest(time_s) + "," + shortest(update.interval_s) + "," + std::to_string(part + 1) + "," +
                               std::to_string(update.count);
            for (const double *values : {update.angle_rad, update.velocity_m_s})
                for (int axis = 0; axis < 3; axis++)
                    line += "," + shortest(values[3 * part + axis]);
            lines.add(line);
        }
    }
}
