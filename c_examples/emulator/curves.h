/* Curves of any length in memory of one size: each cell has the extremes of what it stands for. */
#pragma once
#include <algorithm>
#include <array>
#include <vector>

/* What is drawn over time: three components each. */
enum Channel {
    ATTITUDE_ERROR = 0,  /* roll, pitch, heading [rad]: error data 2, then error data 1 */
    VELOCITY_ERROR = 6,  /* east, north, up [m/s] */
    POSITION_ERROR = 12, /* [m] */
    RATE = 18,           /* measured, x, y, z [rad/s] */
    FORCE = 21,          /* [m/s2] */
    ATTITUDE = 24,       /* truth, then navigation: roll, pitch, heading [rad] */
    VELOCITY = 30,       /* east, north, up [m/s] */
    PLACE = 36,          /* latitude, longitude [rad], height [m] */
    CHANNELS = 42
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
typedef std::array<Cell, CHANNELS> Cells;

class Curves {
public:
    /* Three values of a channel, now. */
    void put(int channel, const double *values) {
        for (int k = 0; k < 3; k++)
            now_[channel + k].join(Cell(values[k]));
    }

    /* A point ends: what was put since the point before. */
    void end_point(double time_s) {
        if (points_ == stride_ && times.size() == MOST)
            halve();
        if (points_ == stride_) {
            times.push_back(time_s);
            cells.emplace_back();
            points_ = 0;
        }
        join(cells.back(), now_);
        times.back() = time_s;
        now_ = Cells();
        points_++;
    }

    /* A channel over the times. */
    std::vector<Cell> of(int channel) const {
        std::vector<Cell> result;
        for (const Cells &own : cells)
            result.push_back(own[channel]);
        return result;
    }

    std::vector<double> last(int channel) const {
        std::vector<double> result;
        for (const Cells &own : cells)
            result.push_back(own[channel].last);
        return result;
    }

    std::vector<double> times; /* of the ends of the cells [s] */
    std::vector<Cells> cells;

private:
    static const size_t MOST = 2048;

    static void join(Cells &cells, const Cells &next) {
        for (int k = 0; k < CHANNELS; k++)
            cells[k].join(next[k]);
    }

    void halve() {
        for (size_t k = 0; k < MOST / 2; k++) {
            cells[k] = cells[2 * k];
            join(cells[k], cells[2 * k + 1]);
            times[k] = times[2 * k + 1];
        }
        times.resize(MOST / 2);
        cells.resize(MOST / 2);
        stride_ *= 2;
        points_ = stride_;
    }

    Cells now_;
    size_t points_ = 1, stride_ = 1; /* points in the last cell, and in each */
};
