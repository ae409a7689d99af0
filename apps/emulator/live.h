/* Which packets of a flight simulator are flown, and the socket that they come to. `sins live` (apps/cli/src/live) decides in the
 * same way. Only the socket needs Windows. */
#pragma once
#ifdef _WIN32
#include <winsock2.h>
#endif

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "earth.h"
#include "packets.h"

/* Where packets come to, and what they are. */
struct LiveSource {
    bool has_time = false; /* false: FlightGear's native packets; true: lines with their own time */
    int port = 5500;
    double rate_hz = 120; /* of packets without a time; FlightGear's model has this rate by default */
};

/* What became of a packet that is not refused: it begins a flight, continues it, or is one of a pause, whose time is left out. */
enum class Passed { BEGINS, FOLLOWS, STANDS };

/* Passes samples in the order of their time, as a pure function of the packets. */
class Gate {
public:
    /* options: those of the simulator that flies the samples. period_s: of packets without a time, otherwise 0. */
    Gate(sins_options options, double period_s) : period_s_(period_s), max_gap_s_(options.max_gap_s) {
        options.frame = SINS_FRAME_EARTH_FIXED; /* ideal sensors, which can navigate wherever a sample can be */
        options.signal = SINS_SIGNAL_PHYSICAL;
        options.closed_loop_time_s = 0;
        options.vertical = SINS_VERTICAL_DAMPED;
        options.subsamples = options.updates_per_sample = 1;
        options.error_model = options.truth_summary = options.covariance = 0;
        check_ = sins::Simulator(options);
    }

    /* Takes the next sample and sets its time in the flight. */
    Passed take(sins_flight_sample &sample) {
        if (!last_)
            return begin(sample);
        within_range(sample);
        const double *v = sample.velocity_enu_m_s;
        const bool stands = same(sample, *last_), pauses = stands && std::hypot(v[0], v[1], v[2]) >= LEAST_SPEED_M_S;
        if (period_s_ > 0) {
            const double count = periods(*last_, sample);
            if (!(count >= -max_gap_s_ / period_s_))
                return jumped(sample, count < 0 ? "the position went back" : "a way that the velocity does not explain");
            if (count < 0)
                throw WrongPacket(Why::LATE, std::to_string((long)count) + " periods");
            if (count == 0)
                return Passed::STANDS;
            sample.time_s = period_s_ * (std::round(last_->time_s / period_s_) + count);
        } else if (sample.time_s <= last_->time_s) {
            if (sample.time_s == last_->time_s && stands)
                return Passed::STANDS;
            const std::string what = "time_s = " + std::to_string(sample.time_s);
            if (last_->time_s - sample.time_s > max_gap_s_)
                return jumped(sample, what);
            throw WrongPacket(Why::LATE, what);
        } else if (pauses) {
            paused_s_ += sample.time_s - last_->time_s;
            last_ = sample;
            return Passed::STANDS;
        }
        const sins_flight_sample packet = sample;
        try {
            sample.time_s -= paused_s_;
            check_.push_sample(sample);
            check_.step();
        } catch (const sins::Error &error) {
            sample = packet;
            if (error.status() == SINS_ERROR_TIME_ORDER)
                throw WrongPacket(Why::PERIOD, error.what());
            return jumped(sample, error.what());
        }
        last_ = packet;
        jumps_ = 0;
        return Passed::FOLLOWS;
    }

private:
    static constexpr double LEAST_SPEED_M_S = 2; /* below it the way does not tell the time */
    static constexpr int JUMPS = 3;              /* so many in a row are no wrong packets: the aircraft was moved */

    static bool same(const sins_flight_sample &one, const sins_flight_sample &other) {
        return one.latitude_rad == other.latitude_rad && one.longitude_rad == other.longitude_rad && one.height_m == other.height_m &&
               one.roll_rad == other.roll_rad && one.pitch_rad == other.pitch_rad && one.heading_rad == other.heading_rad;
    }

    /* The number of periods from one packet to the next, n = d v / (v2 T): d is the way, v the mean velocity. At rest n is 1. NaN: the
     * velocity does not explain the way. */
    double periods(const sins_flight_sample &from, const sins_flight_sample &to) const {
        const double middle = (from.latitude_rad + to.latitude_rad) / 2;
        const double east = std::remainder(to.longitude_rad - from.longitude_rad, 360 * SINS_DEG) * std::cos(middle);
        const double north = to.latitude_rad - from.latitude_rad;
        const Radii radii(middle);
        const double way[3] = {east * (radii.normal_m + from.height_m), north * (radii.meridian_m + from.height_m),
                               to.height_m - from.height_m};
        double mean[3], speed2 = 0, along = 0, aside2 = 0;
        for (int k = 0; k < 3; k++) {
            mean[k] = (from.velocity_enu_m_s[k] + to.velocity_enu_m_s[k]) / 2;
            speed2 += mean[k] * mean[k];
            along += way[k] * mean[k];
        }
        if (std::sqrt(speed2) < LEAST_SPEED_M_S)
            return std::hypot(way[0], way[1], way[2]) < 1 ? 1 : NAN;
        for (int k = 0; k < 3; k++)
            aside2 += std::pow(way[k] - mean[k] * along / speed2, 2);
        const double limit_m = 1 + 0.1 * std::fabs(along) / std::sqrt(speed2); /* a turn in which packets were lost bends the way */
        return std::sqrt(aside2) > limit_m ? NAN : std::round(along / (speed2 * period_s_));
    }

    Passed begin(sins_flight_sample &sample) {
        if (period_s_ > 0)
            sample.time_s = 0;
        within_range(sample);
        check_.reposition(sample);
        last_ = sample;
        paused_s_ = 0;
        jumps_ = 0;
        return Passed::BEGINS;
    }

    Passed jumped(sins_flight_sample &sample, const std::string &what) {
        if (++jumps_ < JUMPS)
            throw WrongPacket(Why::JUMP, what);
        return begin(sample);
    }

    /* A flight may begin at any sample that is valid in itself. */
    void within_range(const sins_flight_sample &sample) {
        try {
            scratch_.reposition(sample);
        } catch (const sins::Error &error) {
            throw WrongPacket(Why::RANGE, error.what());
        }
    }

    double period_s_, max_gap_s_, paused_s_ = 0;
    int jumps_ = 0;
    sins::Simulator check_, scratch_; /* what passes check_ is accepted by the simulator that flies */
    std::optional<sins_flight_sample> last_; /* with the time of its packet */
};

/* What the packets were so far. */
struct Traffic {
    uint64_t flown = 0, standing = 0, refused[(size_t)Why::COUNT] = {}; /* standing: since the last one that was flown */
    Why newest = Why::COUNT; /* the last reason that is new, and its first packet */
    std::string what;
    bool is_silent = false; /* no packet has come for two seconds */
};

/* Takes packets of one sender: the first one whose packet is good. */
class Intake {
public:
    Intake(const LiveSource &source, const sins_options &options)
        : has_time_(source.has_time), gate_(options, source.has_time ? 0 : 1 / source.rate_hz) {}

    /* What becomes of a packet; without a value, it is refused. */
    std::optional<Passed> take(const std::string &packet, uint64_t sender, sins_flight_sample &sample) {
        try {
            if (sender_ && *sender_ != sender)
                throw WrongPacket(Why::ADDRESS, std::to_string(sender & 0xffff));
            sample = has_time_ ? line_sample(packet) : native_sample(packet);
            const Passed passed = gate_.take(sample);
            sender_ = sender;
            traffic.flown += passed != Passed::STANDS;
            traffic.standing = passed == Passed::STANDS ? traffic.standing + 1 : 0;
            return passed;
        } catch (const WrongPacket &wrong) {
            if (++traffic.refused[(size_t)wrong.why] == 1) {
                traffic.newest = wrong.why;
                traffic.what = wrong.what();
            }
            return {};
        }
    }

    Traffic traffic;

private:
    bool has_time_;
    Gate gate_;
    std::optional<uint64_t> sender_; /* address and port */
};

#ifdef _WIN32
/* The packets that come to a port from this machine. */
class Live {
public:
    Live(const LiveSource &source, const sins_options &options) : intake_(source, options) {
        WSADATA data;
        WSAStartup(MAKEWORD(2, 2), &data);
        sockaddr_in place = {};
        place.sin_family = AF_INET;
        place.sin_port = htons((u_short)source.port);
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        u_long polled = 1;
        int size = 1 << 18; /* bytes: half a second of packets at 1000 Hz; Windows 7 keeps 8 KiB by default */
        socket_ = socket(AF_INET, SOCK_DGRAM, IPPROTO_UDP);
        setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, (const char *)&size, sizeof size);
        ioctlsocket(socket_, FIONBIO, &polled);
        is_open_ = bind(socket_, (const sockaddr *)&place, sizeof place) == 0;
    }
    Live(const Live &) = delete;
    ~Live() {
        close();
        WSACleanup();
    }

    bool is_open() const { return is_open_; } /* false after the constructor: GetLastError() has the reason */

    void close() { closesocket(std::exchange(socket_, INVALID_SOCKET)); }

    /* The next sample that is flown, if its packet has come: BEGINS or FOLLOWS. */
    std::optional<Passed> next(sins_flight_sample &sample) {
        sockaddr_in from;
        for (int k = 0; k < MOST; k++) {
            int from_size = sizeof from, size = recvfrom(socket_, buffer_.data(), (int)buffer_.size(), 0, (sockaddr *)&from, &from_size);
            if (size < 0)
                break;
            came_ms_ = GetTickCount64();
            uint64_t sender = (uint64_t)ntohl(from.sin_addr.s_addr) << 16 | ntohs(from.sin_port);
            std::optional<Passed> passed = intake_.take(std::string(buffer_.data(), size), sender, sample);
            if (passed && passed != Passed::STANDS)
                return passed;
        }
        return {};
    }

    Traffic traffic() const {
        Traffic traffic = intake_.traffic;
        traffic.is_silent = GetTickCount64() > came_ms_ + 2000;
        return traffic;
    }

private:
    static const int MOST = 256; /* packets before the window may take the flight */

    Intake intake_;
    SOCKET socket_;
    std::vector<char> buffer_ = std::vector<char>(1 << 16);
    ULONGLONG came_ms_ = 0; /* when the last packet came */
    bool is_open_;
};
#endif
