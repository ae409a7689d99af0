/* A C++ host: half an hour of an embedded flight, the errors that a navigation-grade INS makes on it, an exception. */

#include <cstdio>
#include <exception>
#include <utility>

#include "sins.hpp"

namespace {

/* Climb, turn, cruise; ends where the last manoeuvre does. */
sins::Flight make_flight()
{
    auto start = sins::make<sins_flight_start>();
    start.latitude_rad = 40.0 * SINS_DEG;
    start.longitude_rad = 116.4 * SINS_DEG;
    start.height_m = 3000.0;
    start.speed_m_s = 200.0;

    sins_manoeuvre manoeuvres[3];
    for (auto &manoeuvre : manoeuvres) {
        manoeuvre = sins::make<sins_manoeuvre>();
    }
    manoeuvres[0].kind = SINS_MANOEUVRE_CLIMB;
    manoeuvres[0].duration_s = 300.0;
    manoeuvres[0].ramp_s = 20.0;
    manoeuvres[0].height_change_m = 5000.0;
    manoeuvres[1].kind = SINS_MANOEUVRE_TURN;
    manoeuvres[1].heading_change_rad = 135.0 * SINS_DEG;
    manoeuvres[1].bank_rad = 25.0 * SINS_DEG;
    manoeuvres[2].kind = SINS_MANOEUVRE_STRAIGHT;
    manoeuvres[2].duration_s = 1400.0;
    return sins::Flight(start, manoeuvres, 3);
}

sins::Simulator make_simulator(double period_s)
{
    auto options = sins::make<sins_options>();
    options.sample_period_s = period_s;
    options.error_model = SINS_ERROR_MODEL_RK4;

    sins::Simulator sim(options);
    sim.set_gyro(sins::gyro_preset(SINS_GRADE_PAPER_SIMULATION2));
    sim.set_accel(sins::accel_preset(SINS_GRADE_PAPER_SIMULATION2));
    return sim;
}

void fly(const sins::Flight &flight, sins::Simulator &sim, double period_s)
{
    auto sample = sins::make<sins_flight_sample>();
    auto truth = sins::make<sins_navigation>();
    auto errors = sins::make<sins_errors>();
    const auto last = static_cast<long>(flight.duration() / period_s);

    std::printf("%8s %10s %9s %10s %10s\n", "time s", "height m", "heading", "east m", "north m");
    for (long k = 0; k <= last; k++) {
        flight.sample_at(static_cast<double>(k) * period_s, sample);
        sim.push_sample(sample);
        if (sim.step() && k % 15000 == 0 && sim.get_truth(truth) && sim.get_errors(SINS_ERRORS_NAVIGATION, errors)) {
            std::printf("%8.0f %10.1f %9.2f %10.2f %10.2f\n", truth.time_s, truth.height_m,
                        truth.heading_rad / SINS_DEG, errors.position_enu_m[0], errors.position_enu_m[1]);
        }
    }
}

} // namespace

int main()
{
    const double period_s = 0.01;

    try {
        std::printf("sins %s\n", sins::version_string());
        const sins::Flight flight = make_flight();
        sins::Simulator sim = make_simulator(period_s);
        fly(flight, sim, period_s);

        auto accuracy = sins::make<sins_accuracy>();
        if (sim.get_accuracy(accuracy)) {
            std::printf("R50 = 0.8326 sqrt(mean RER^2) = %.3f nmi/h\n", accuracy.cep_rate_m_s / SINS_NMI_PER_HOUR);
        }

        auto gyro = sins::make<sins_gyro_params>();
        gyro.markov_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR; /* without its correlation time */
        try {
            sim.set_gyro(gyro);
        } catch (const sins::Error &error) {
            std::printf("%s: %s\n", sins::status_string(error.status()), error.what());
        }
    } catch (const std::exception &error) {
        std::fprintf(stderr, "cpp_host: %s\n", error.what());
        return 1;
    }
    return 0;
}
