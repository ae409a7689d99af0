/* An aircraft to be flown by stick and throttle: a point mass that flies where its nose points, without wind. It banks to turn, taxies on
 * the ground, takes off and lands. Nothing here needs Windows. */
#pragma once
#include <algorithm>
#include <cmath>

#include "earth.h"
#include "sins.h"

/* What the pilot does: roll to the right and pitch up from -1 to 1, throttle from 0 to 1. */
struct Stick {
    double roll, pitch, throttle;
};

struct AircraftLimits {
    double roll_rate = 45 * SINS_DEG, pitch_rate = 8 * SINS_DEG, taxi_rate = 15 * SINS_DEG; /* [rad/s] */
    double bank = 60 * SINS_DEG, pitch = 20 * SINS_DEG;                                    /* [rad] */
    double speed_m_s = 250, take_off_m_s = 60;       /* at full throttle; least speed in the air */
    double acceleration_m_s2 = 4, gravity_m_s2 = 9.8; /* for a larger or smaller speed; for turns */
};

class Aircraft {
public:
    /* Begins at the place, the heading and the speed of a sample. Below the least speed in the air it stands on the ground. */
    explicit Aircraft(const sins_flight_sample &start, const AircraftLimits &limits = {}) : limits_(limits), now_(start) {
        const double *v = start.velocity_enu_m_s;
        speed_ = std::min(std::hypot(v[0], v[1]), limits_.speed_m_s);
        bool flies = speed_ >= limits_.take_off_m_s;
        speed_ = flies ? speed_ : 0;
        ground_m_ = flies ? 0 : start.height_m;
        now_.roll_rad = now_.pitch_rad = 0;
        move(now_.velocity_enu_m_s);
    }

    bool is_on_ground() const { return now_.height_m < ground_m_ + CONTACT_M; }
    double speed_m_s() const { return speed_; }
    double throttle() const { return speed_ / limits_.speed_m_s; } /* that keeps the speed */

    /* The truth now; velocities are those of its positions. */
    sins_flight_sample sample(double time_s) const {
        sins_flight_sample sample = now_;
        sample.time_s = time_s;
        return sample;
    }

    /* Flies for dt, at most 0.1 s. */
    void fly(const Stick &stick, double dt) {
        const bool is_on_ground = this->is_on_ground(), rotates = speed_ >= limits_.take_off_m_s && stick.pitch > 0;
        const double least = is_on_ground ? 0 : limits_.take_off_m_s;
        double wanted = std::max(stick.throttle * limits_.speed_m_s, least) - speed_;
        double before[3], roll = stick.roll * limits_.roll_rate, pitch = stick.pitch * limits_.pitch_rate;
        wanted = std::clamp(wanted / SETTLING_S, -limits_.acceleration_m_s2, limits_.acceleration_m_s2);
        follow(acceleration_, wanted, dt);
        if (is_on_ground && !rotates)
            roll = pitch = 0;
        const double bank = is_on_ground ? 0 : limits_.bank, up = is_on_ground && !rotates ? 0 : limits_.pitch;
        /* The descent flares out, so that the ground is touched gently. */
        const double sink = std::max(now_.height_m - ground_m_, 0.0) / FLARE_S / std::max(speed_, 1.0);
        const double down = is_on_ground && !rotates ? 0 : std::min(limits_.pitch, std::asin(std::min(sink, 1.0)));
        follow(roll_rate_, within(roll, now_.roll_rad, -bank, bank), dt);
        follow(pitch_rate_, within(pitch, now_.pitch_rad, -down, up), dt);
        const double turning = is_on_ground ? stick.roll * limits_.taxi_rate * std::min(speed_ / 5, 1.0)
                                            : limits_.gravity_m_s2 * std::tan(now_.roll_rad) / std::max(speed_, 1.0);
        follow(heading_rate_, turning, dt);
        move(before);
        speed_ = std::max(speed_ + acceleration_ * dt, 0.0);
        now_.roll_rad += roll_rate_ * dt;
        now_.pitch_rad += pitch_rate_ * dt;
        now_.heading_rad = std::remainder(now_.heading_rad + heading_rate_ * dt, 360 * SINS_DEG);
        move(now_.velocity_enu_m_s);
        travel(before, dt);
    }

private:
    static constexpr double CONTACT_M = 0.3, SETTLING_S = 2, LAG_S = 0.2, FLARE_S = 3;

    /* A rate that brings an angle into its limits. */
    static double within(double rate, double angle, double low, double high) {
        return std::clamp(rate, (low - angle) / (2 * LAG_S), (high - angle) / (2 * LAG_S));
    }

    static void follow(double &value, double wanted, double dt) { value += (wanted - value) * (1 - std::exp(-dt / LAG_S)); }

    void move(double *velocity_enu_m_s) const {
        const double level = speed_ * std::cos(now_.pitch_rad);
        velocity_enu_m_s[0] = level * std::sin(now_.heading_rad);
        velocity_enu_m_s[1] = level * std::cos(now_.heading_rad);
        velocity_enu_m_s[2] = speed_ * std::sin(now_.pitch_rad);
    }

    /* Moves by the mean of the velocities at both ends. */
    void travel(const double *before, double dt) {
        double way[3];
        for (int k = 0; k < 3; k++)
            way[k] = (before[k] + now_.velocity_enu_m_s[k]) / 2 * dt;
        const double height = now_.height_m + way[2] / 2;
        const double middle = now_.latitude_rad + way[1] / 2 / (Radii(now_.latitude_rad).meridian_m + height);
        const Radii radii(middle);
        now_.latitude_rad += way[1] / (radii.meridian_m + height);
        now_.longitude_rad += way[0] / ((radii.normal_m + height) * std::max(std::cos(middle), 1e-3));
        now_.longitude_rad = std::remainder(now_.longitude_rad, 360 * SINS_DEG);
        now_.height_m += way[2];
    }

    AircraftLimits limits_;
    sins_flight_sample now_;
    double speed_ = 0, ground_m_ = 0, acceleration_ = 0, roll_rate_ = 0, pitch_rate_ = 0, heading_rate_ = 0;
};
