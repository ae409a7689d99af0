/* As door.c, by the C++ wrapper. */

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>

#include "sins_scene.hpp"

namespace {

std::string text_of(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

template <std::size_t COUNT> void print(const double (&values)[COUNT]) {
    for (const double value : values) {
        uint64_t word;
        std::memcpy(&word, &value, sizeof word);
        std::printf(" %016" PRIx64, word);
    }
}

void fly(sins::Play &play) {
    try {
        play.finish();
    } catch (const sins::Error &error) {
        if (error.status() != SINS_ERROR_BAD_STATE)
            throw;
        std::printf(" stopped\n");
        return;
    }
    const sins_record_errors errors = play.record().navigation_errors;
    sins_unit_status status;
    sins_unit_navigation shown;
    play.shown(status, shown);
    print(errors.position_enu_m);
    print(errors.velocity_enu_m_s);
    print(errors.misalignment_enu_rad);
    print({shown.latitude_rad, shown.longitude_rad, shown.height_m});
    print(shown.velocity_enu_m_s);
    print({shown.roll_rad, shown.pitch_rad, shown.heading_rad});
    std::printf(" %" PRIu32 " %" PRId32 "\n", status.validity, status.state);
}

} // namespace

int main(int count, char **arguments) {
    for (int k = 2; k < count; k++) {
        try {
            const std::string path = std::string(arguments[1]) + "/" + arguments[k];
            const sins::Scene scene(text_of(path + ".toml"));
            std::printf("%s", arguments[k]);
            if (scene.setup().flight == SINS_SCENE_FLIGHT_LOG) {
                const sins::Log log(scene, text_of(path + ".csv"));
                sins::Play play(scene, log);
                fly(play);
            } else {
                sins::Play play(scene);
                fly(play);
            }
        } catch (const std::exception &error) {
            std::fprintf(stderr, "%s: %s\n", arguments[k], error.what());
            return 1;
        }
    }
    return 0;
}
