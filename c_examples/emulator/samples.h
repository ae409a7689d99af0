/* The flight of a scene, sample by sample: computed by the library, or read from a log. */
#pragma once
#include <cmath>

#include "scene.h"

class Samples {
public:
    /* folder: that of the scene's file, from which a log is seen. */
    void open(const Scene &scene, const fs::path &folder)
    {
        sins_scene_setup setup = scene.setup();
        if (setup.flight == SINS_SCENE_FLIGHT_LOG) {
            open_log(folder / wide(scene.words(SINS_SCENE_TEXT_LOG)), setup.duration_s);
            return;
        }
        check(lib.sins_scene_create_flight(scene.handle(), &flight_));
        check(lib.sins_flight_duration(flight_, &end_s_));
        rate_hz_ = setup.rate_hz;
        period_s = 1 / rate_hz_;
        double intervals = std::floor((setup.flown_s > 0 ? setup.flown_s : end_s_) / period_s + ROUNDING);
        count = (size_t)intervals + 1;
        duration_s = intervals * period_s;
    }

    sins_status get(size_t index, sins_flight_sample *sample) const
    {
        return log_ != NULL
                   ? lib.sins_log_get_sample(log_, index, sample, NULL)
                   : lib.sins_flight_sample_at(flight_, min((double)index / rate_hz_, end_s_), sample);
    }

    /* Where a sample stands, for a sentence about it: the time, or the line of the log. */
    std::wstring place(size_t index) const
    {
        sins_flight_sample sample = sized<sins_flight_sample>();
        uint64_t line = 0;
        if (log_ == NULL) {
            return shown((double)index * period_s, 10) + L" s: ";
        }
        lib.sins_log_get_sample(log_, index, &sample, &line);
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
        sins_fault fault = sized<sins_fault>();
        sins_log_info info = sized<sins_log_info>();
        sins_flight_sample sample = sized<sins_flight_sample>();
        std::string bytes = read_file(path);
        log_path = path;
        if (lib.sins_log_parse(bytes.data(), bytes.size(), &log_, &fault) < 0) {
            std::wstring place = L":" + std::to_wstring(fault.line) + L":" + std::to_wstring(fault.column);
            throw Refusal{path.wstring() +
                          (fault.line > 0 ? place + L": " + told(fault.sentence) : L": " + last_error())};
        }
        lib.sins_log_get_info(log_, &info);
        for (count = 0; count < info.samples; count++) {
            lib.sins_log_get_sample(log_, count, &sample, NULL);
            start_s = count == 0 ? sample.time_s : start_s;
            if (wanted_s > 0 && sample.time_s - start_s > wanted_s * (1 + ROUNDING)) {
                break;
            }
            duration_s = sample.time_s - start_s;
        }
        if (count < 2) {
            throw Refusal{text("no_flight")};
        }
        period_s = duration_s / (double)(count - 1);
    }

    Handle<sins_flight> flight_;
    Handle<sins_log> log_;
    double rate_hz_ = 0, end_s_ = 0;
};
