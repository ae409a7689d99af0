/* Curves of any length in memory of a fixed size: each cell has the extremes of its points. */
#pragma once
#include <algorithm>
#include <vector>

/* Quantities that are drawn over time, with three components each. If there are two triples, the second
 * is drawn over the first. */
enum Channel {
    ATTITUDE_ERROR = 0,  /* roll, pitch, heading [rad]: error data 1, then error data 2 */
    VELOCITY_ERROR = 6,  /* east, north, up [m/s] */
    POSITION_ERROR = 12, /* [m] */
    ATTITUDE = 18,       /* truth, then navigation: roll, pitch, heading [rad] */
    VELOCITY = 24,       /* east, north, up [m/s] */
    PLACE = 30,          /* latitude, longitude [rad], height [m] */
    RATE = 36,           /* measured, x, y, z [rad/s] */
    FORCE = 39,          /* [m/s2] */
    TIME = 42,           /* the time itself [s] */
    CHANNELS = 43
};

struct Cell {
    double low = 1e300, high = -1e300, last = 0;
    Cell() = default;
    explicit Cell(double value) : low(value), high(value), last(value) {}
    void join(const Cell &next) {
        low = std::min(low, next.low);
        high = std::max(high, next.high);
        last = next.last;
    }
};
typedef std::vector<Cell> Cells;

class Curves {
public:
    Cells cells[CHANNELS];

    /* Adds values of a channel to the current point. */
    void put(int channel, const double *values, int count = 3) {
        for (int k = 0; k < count; k++)
            now_[channel + k].join(Cell(values[k]));
    }

    /* Ends a point, which has all values since the previous point. */
    void end_point(double time_s) {
        put(TIME, &time_s, 1);
        bool is_new = points_ == stride_;
        if (is_new && cells[TIME].size() == MOST)
            halve();
        points_ = is_new ? 1 : points_ + 1;
        for (int k = 0; k < CHANNELS; k++) {
            if (is_new)
                cells[k].emplace_back();
            cells[k].back().join(now_[k]);
            now_[k] = Cell();
        }
    }

private:
    static const size_t MOST = 2048;

    void halve() {
        for (Cells &own : cells) {
            for (size_t k = 0; k < MOST / 2; k++) {
                own[2 * k].join(own[2 * k + 1]);
                own[k] = own[2 * k];
            }
            own.resize(MOST / 2);
        }
        stride_ *= 2;
    }

    Cell now_[CHANNELS];
    size_t points_ = 1, stride_ = 1; /* points in the last cell, and in each */
};
