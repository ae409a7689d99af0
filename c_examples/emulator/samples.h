/* The flight of a scene, sample by sample: computed by the library, or read from a log. */
#pragma once
#include <optional>

#include "scene.h"

class Samples {
public:
    /* folder: that of the scene's file, from which a log is seen. */
    Samples(const Scene &scene, const fs::path &folder)
    {
        sins_scene_setup setup = scene->setup();
        if (setup.flight == SINS_SCENE_FLIGHT_LOG) {
            open_log(folder / wide(scene->text(SINS_SCENE_TEXT_LOG)), setup.duration_s);
            return;
        }
        flight_ = scene->create_flight();
        end_s_ = flight_->duration();
        rate_hz_ = setup.rate_hz;
        period_s = 1 / rate_hz_;
        double intervals = std::floor((setup.flown_s > 0 ? setup.flown_s : end_s_) / period_s + ROUNDING);
        count = (size_t)intervals + 1;
        duration_s = intervals * period_s;
    }

    sins_flight_sample get(size_t index) const
    {
        return log_ ? log_->sample(index) : flight_->sample_at(min((double)index / rate_hz_, end_s_));
    }

    /* Where a sample stands, for a sentence about it: the time, or the line of the log. */
    std::wstring place(size_t index) const
    {
        uint64_t line = 0;
        if (!log_) {
            return shown((double)index * period_s, 10) + L" s: ";
        }
        log_->sample(index, &line);
        return log_path.wstring() + L":" + std::to_wstring(line) + L": ";
    }

    size_t count = 0;
    double period_s = 0, duration_s = 0, start_s = 0;
    fs::path log_path; /* "": no log */

private:
    /* Rounding of times that must not take a sample away [intervals]. */
    static constexpr double ROUNDING = 1e-9;

    void open_log(const fs::path &path, double wanted_s)
    {
        log_path = path;
        try {
            log_ = sins::Log(read_file(path));
        } catch (const sins::Error &error) {
            throw Refusal(path.wstring() + L":" + told(error));
        }
        size_t samples = log_->info().samples;
        for (count = 0; count < samples; count++) {
            double time_s = log_->sample(count).time_s;
            start_s = count == 0 ? time_s : start_s;
            if (wanted_s > 0 && time_s - start_s > wanted_s * (1 + ROUNDING)) {
                break;
            }
            duration_s = time_s - start_s;
        }
        if (count < 2) {
            throw Refusal(text("no_flight"));
        }
        period_s = duration_s / (double)(count - 1);
    }

    std::optional<sins::Flight> flight_;
    std::optional<sins::Log> log_;
    double rate_hz_ = 0, end_s_ = 0;
};
