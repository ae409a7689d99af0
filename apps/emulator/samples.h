/* The flight of a scene, sample by sample: computed by the library, or read from a log. */
#pragma once
#include <optional>

#include "scene.h"

class Samples {
public:
    /* folder: the folder of the scene's file, to which the path of a log is relative. */
    Samples(const Scene &scene, const fs::path &folder) : rate_hz_(scene.setup().rate_hz) {
        if (scene.setup().flight != SINS_SCENE_FLIGHT_LOG) {
            flight_ = scene.create_flight();
            all = scene.samples();
            return;
        }
        log_path = folder / wide(scene.text(SINS_SCENE_TEXT_LOG));
        try {
            Scene joined = scene; // which gets the files beside the log
            for (const std::string &name : scene.log_file_names())
                joined.give_log_file(name, read_file(log_path.parent_path() / wide(name)));
            log_ = sins::Log(joined, read_file(log_path));
            all = scene.samples(log_->handle());
        } catch (const sins::Error &error) {
            throw Refusal(log_path.wstring() + L": " + told(error));
        }
    }

    /* The samples of a live flight, which are not known before they come. */
    Samples() : all(sins::make<sins_scene_samples>()), rate_hz_(0) {
        all.count = SIZE_MAX;
        all.record_every = 1;
    }

    sins_flight_sample get(size_t index) const {
        return log_ ? log_->sample(index) : flight_->sample_at((double)index / rate_hz_);
    }

    /* The log, or NULL. */
    const sins_log *log() const { return log_ ? log_->handle() : NULL; }

    /* The place of a sample for a sentence about it: its time, or its line in the log. */
    std::wstring place(size_t index) const {
        uint64_t line = 0;
        if (!log_)
            return shown((double)index * all.period_s, 10) + L" s: ";
        log_->sample(index, &line);
        return log_path.wstring() + L":" + std::to_wstring(line) + L": ";
    }

    sins_scene_samples all;
    fs::path log_path; /* "" without a log */

private:
    std::optional<sins::Flight> flight_;
    std::optional<sins::Log> log_;
    double rate_hz_;
};
