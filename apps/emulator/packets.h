/* The samples in packets of a flight simulator: docs/live.md has their formats. Nothing here needs Windows. */
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "sins.hpp"

/* Why a packet is not flown, in the order of the texts "refused" and "refusals". */
enum class Why { ADDRESS, LENGTH, VERSION, SYNTAX, NOT_A_NUMBER, RANGE, LATE, PERIOD, JUMP, COUNT };

struct WrongPacket : std::runtime_error {
    Why why;
    WrongPacket(Why why, const std::string &what) : std::runtime_error(what), why(why) {}
};

inline double finite(const char *name, double value) {
    if (!std::isfinite(value))
        throw WrongPacket(Why::NOT_A_NUMBER, name);
    return value;
}

/* FlightGear's native packet, big-endian: angles [rad] and velocities [ft/s] are floats. */
inline sins_flight_sample native_sample(const std::string &packet) {
    auto read = [&packet](auto value, size_t at) {
        std::conditional_t<sizeof value == 8, uint64_t, uint32_t> bits = 0;
        for (size_t k = 0; k < sizeof value; k++)
            bits = bits << 8 | (unsigned char)packet[at + k];
        std::memcpy(&value, &bits, sizeof value);
        return value;
    };
    if (packet.size() != 408 && packet.size() != 552)
        throw WrongPacket(Why::LENGTH, std::to_string(packet.size()));
    const uint32_t version = read(uint32_t(), 0);
    if (version != (packet.size() == 408 ? 24 : 25))
        throw WrongPacket(Why::VERSION, std::to_string(version));
    const double FOOT_M = 0.3048;
    sins_flight_sample sample = sins::make<sins_flight_sample>();
    sample.longitude_rad = finite("longitude", read(double(), 8));
    sample.latitude_rad = finite("latitude", read(double(), 16));
    sample.height_m = finite("altitude", read(double(), 24));
    sample.roll_rad = finite("phi", read(float(), 36));
    sample.pitch_rad = finite("theta", read(float(), 40));
    sample.heading_rad = finite("psi", read(float(), 44));
    sample.velocity_enu_m_s[0] = FOOT_M * finite("v_east", read(float(), 80));
    sample.velocity_enu_m_s[1] = FOOT_M * finite("v_north", read(float(), 76));
    sample.velocity_enu_m_s[2] = -FOOT_M * finite("v_down", read(float(), 84));
    return sample;
}

/* A line: time, latitude, longitude [deg], height, velocity east, north, up, roll, pitch, heading [deg]. */
inline sins_flight_sample line_sample(const std::string &line) {
    static const char *const NAMES[] = {"time_s",          "latitude_deg",  "longitude_deg", "height_m",  "velocity_east_m_s",
                                        "velocity_north_m_s", "velocity_up_m_s", "roll_deg",      "pitch_deg", "heading_deg"};
    double values[10] = {};
    size_t count = 0, from = 0;
    for (size_t end = 0; end != line.npos; from = end + 1, count++) {
        end = line.find(',', from);
        if (count >= 10)
            continue;
        size_t first = line.find_first_not_of(" \t", from), last = line.find_last_not_of(" \t\r\n", end == line.npos ? end : end - 1);
        first += first < line.size() && line[first] == '+';
        const bool is_empty = first == line.npos || last == line.npos || last < first;
        const std::string word = is_empty ? "" : line.substr(first, last - first + 1);
        auto read = std::from_chars(word.data(), word.data() + word.size(), values[count]);
        if (word.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size())
            throw WrongPacket(Why::SYNTAX, NAMES[count] + (" = " + word.substr(0, 20)));
        finite(NAMES[count], values[count]);
    }
    if (count != 10)
        throw WrongPacket(Why::LENGTH, std::to_string(count));
    sins_flight_sample sample = sins::make<sins_flight_sample>();
    sample.time_s = values[0];
    sample.latitude_rad = values[1] * SINS_DEG;
    sample.longitude_rad = values[2] * SINS_DEG;
    sample.height_m = values[3];
    std::memcpy(sample.velocity_enu_m_s, &values[4], sizeof sample.velocity_enu_m_s);
    sample.roll_rad = values[7] * SINS_DEG;
    sample.pitch_rad = values[8] * SINS_DEG;
    sample.heading_rad = values[9] * SINS_DEG;
    return sample;
}
