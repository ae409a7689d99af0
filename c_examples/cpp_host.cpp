/* A C++ host: reads a scene from a text, reports the faults of another, changes a setting, flies half an hour and catches an
 * exception. */

#include <cstdio>
#include <exception>
#include <string>

#include "sins_scene.hpp"

namespace {

/* Climb, turn, cruise with the sensors of the paper's simulation 2. A program may read it from a file, or ask
 * sins::Scene::builtin() for one; sins::Scene::write_keys() lists every key. */
const char *const text = R"(
[flight]
latitude_deg = 40
longitude_deg = 116.4
height_m = 3000
speed_m_s = 200

[[manoeuvre]]
kind = "climb"
duration_s = 300
ramp_s = 20
height_change_m = 5000

[[manoeuvre]]
kind = "turn"
heading_change_deg = 135
bank_deg = 25

[[manoeuvre]]
kind = "straight"
duration_s = 1400

[gyro]
preset = "paper2"

[accelerometer]
preset = "paper2"

[options]
error_model = "rk4"
)";

void fly(sins::Play &play) {
    std::printf("%8s %10s %9s %10s %10s\n", "time s", "height m", "heading", "east m", "north m");
    for (auto records = play.run(4); !records.empty(); records = play.run(4)) {
        for (const sins_record &record : records) {
            const double *const error_m = record.navigation_errors.position_enu_m;
            std::printf("%8.0f %10.1f %9.2f %10.2f %10.2f\n", record.time_s, record.truth.height_m,
                        record.truth.heading_rad / SINS_DEG, error_m[0], error_m[1]);
        }
    }
}

} // namespace

int main() {
    try {
        std::printf("sins %s\n", sins::version_string());
        for (const sins_fault &fault : sins::Scene("[flight]\nspeed_ms = 200\nbuiltin = \"petrol\"\n").faults())
            std::printf("line %d: %s\n", static_cast<int>(fault.line), fault.sentence);

        sins::Scene scene{std::string(text)};
        scene.set_values("altimeter.bias_m = 10\noutput.every_s = 150"); /* the text sets no altimeter, so it was ideal */
        std::printf("%d bytes of TOML\n", static_cast<int>(scene.write().size()));

        sins::Play play(scene);
        fly(play);
        sins::Play::Lent<sins::Simulator> sim(play.simulator());
        auto accuracy = sins::make<sins_accuracy>();
        if (!sim->get_accuracy(accuracy) || !accuracy.has_rates)
            std::printf("R50: not before 84.4 min, a Schuler period\n");
        else
            std::printf("R50 = 0.8326 sqrt(mean RER^2) = %.3f nmi/h\n", accuracy.cep_rate_m_s / SINS_NMI_PER_HOUR);

        auto gyro = sins::make<sins_gyro_params>();
        gyro.markov_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR; /* without its correlation time */
        try {
            sim->set_gyro(gyro);
        } catch (const sins::Error &error) {
            std::printf("%s: %s\n", sins::status_string(error.status()), error.what());
        }
    } catch (const std::exception &error) {
        std::fprintf(stderr, "cpp_host: %s\n", error.what());
        return 1;
    }
    return 0;
}
