/* The aircraft of SINS_Emulator flies from take-off to landing: ideal sensors return to its truth, its limits hold, and it touches the
 * ground gently. */
#include <cstdio>
#include <cstdlib>

#include "../../apps/emulator/aircraft.h"
#include "sins.hpp"

static void require(bool holds, const char *what) {
    if (!holds) {
        std::fprintf(stderr, "aircraft: %s\n", what);
        std::exit(1);
    }
}

int main() {
    /* What the pilot wants, until when [s]: bank and pitch [deg], throttle. On the ground a bank steers. */
    struct Leg {
        double until_s, bank_deg, pitch_deg, throttle;
    };
    const Leg LEGS[] = {{10, 0, 0, 0},     {20, 10, 0, 0.05},   {30, 0, 0, 0.1},   {70, 0, 12, 0.4},  {130, 25, 5, 0.5}, {200, 90, 0, 0.6},
                        {260, 0, 0, 1},    {300, -40, 15, 0.9}, {330, 0, 0, 0.5},  {500, 10, -20, 0.3}, {600, 0, -20, 0},  {700, 0, 0, 0}};
    const double DT = 0.02;
    sins_flight_sample start = sins::make<sins_flight_sample>();
    start.latitude_rad = 47 * SINS_DEG;
    start.height_m = 400;
    Aircraft aircraft(start);
    sins::Simulator sim;
    const Leg *leg = LEGS;
    double top_m = 0, sink_m_s = 0, lift_off_m_s = 0, bank = 0;
    bool was_on_ground = true, is_consistent = true;
    for (int k = 0; k * DT <= 700; k++) {
        sins_flight_sample sample = aircraft.sample(k * DT);
        sim.push_sample(sample);
        sim.step();
        sins_navigation navigation = sins::make<sins_navigation>();
        if (k > 0) {
            sim.get_navigation(navigation);
            is_consistent = is_consistent && (navigation.flags & SINS_NAVIGATION_INCONSISTENT) == 0;
        }
        top_m = std::max(top_m, sample.height_m);
        bank = std::max(bank, std::fabs(sample.roll_rad));
        if (aircraft.is_on_ground() != was_on_ground) {
            (was_on_ground ? lift_off_m_s : sink_m_s) = was_on_ground ? aircraft.speed_m_s() : -sample.velocity_enu_m_s[2];
            was_on_ground = !was_on_ground;
        }
        require(sample.height_m > 399.5, "it flies below the ground");
        leg += k * DT >= leg->until_s && leg->until_s < 700;
        auto towards = [](double wanted_deg, double now) { return std::clamp((wanted_deg * SINS_DEG - now) / 0.05, -1.0, 1.0); };
        aircraft.fly({towards(leg->bank_deg, sample.roll_rad), towards(leg->pitch_deg, sample.pitch_rad), leg->throttle}, DT);
    }
    sins_errors errors = sins::make<sins_errors>();
    sim.get_errors(SINS_ERRORS_NAVIGATION, errors);
    const double *p = errors.position_enu_m, closure_m = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    std::printf("aircraft: lifts off at %.1f m/s, climbs to %.0f m, banks by %.1f deg, touches down with %.2f m/s, stands at %.2f m/s; "
                "ideal sensors are %.1e m off\n",
                lift_off_m_s, top_m, bank / SINS_DEG, sink_m_s, aircraft.speed_m_s(), closure_m);
    require(lift_off_m_s >= 60 && top_m > 1000, "it does not take off");
    require(was_on_ground && sink_m_s < 0.3 && aircraft.speed_m_s() < 0.1, "it does not land");
    require(bank < 62 * SINS_DEG && bank > 59 * SINS_DEG, "it does not bank as far as it may");
    require(is_consistent, "its velocities are not those of its positions");
    /* The mean of the velocities at both ends of a step is off by h^2/12 of the change of their change. Over the flight that adds up to
     * h^2/12 times the largest acceleration there was at an end of a manoeuvre, 20 m/s2, for each of its 30. */
    require(closure_m < 30 * 20 * DT * DT / 12, "ideal sensors do not return to its truth");
    return 0;
}
