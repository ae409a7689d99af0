/* Curves of any length in memory of one size: each cell has the extremes of the points that it stands for. */
#pragma once
#include <array>
#include <cstddef>
#include <vector>

/* What is drawn over time: three components each, but for the time. */
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

typedef std::array<double, CHANNELS> Point;

struct Cell {
    double low, high, last;
};

class Curves {
public:
    /* The point at a time; low and high are of all that happened since the point before. */
    void add(double time_s, const Point &low, const Point &high, const Point &last);
    const std::vector<double> &times() const { return times_; } /* of the ends of the cells [s] */
    std::vector<Cell> channel(int channel) const;
    std::vector<double> last(int channel) const; /* of each cell */

private:
    void halve();
    std::vector<double> times_;
    std::vector<std::array<Cell, CHANNELS>> cells_;
    size_t points_ = 0, stride_ = 1; /* points in the last cell, and in each */
};
