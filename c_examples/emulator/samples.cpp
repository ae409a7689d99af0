#include "samples.h"

#include <cmath>

/* Rounding of times that must not take a sample away [intervals]. */
static const double ROUNDING = 1e-9;

bool Samples::open(const Scene &scene, const std::wstring &folder, std::wstring &why)
{
    sins_scene_setup setup = scene.setup();
    if (setup.flight == SINS_SCENE_FLIGHT_LOG) {
        return open_log(scene, folder, why);
    }
    if (lib.sins_scene_create_flight(scene.handle(), &flight_) < 0 ||
        lib.sins_flight_duration(flight_, &end_s_) < 0) {
        why = last_error();
        return false;
    }
    rate_hz_ = setup.rate_hz;
    period_s = 1 / rate_hz_;
    double intervals = std::floor((setup.flown_s > 0 ? setup.flown_s : end_s_) / period_s + ROUNDING);
    count = (size_t)intervals + 1;
    duration_s = intervals * period_s;
    return true;
}

bool Samples::open_log(const Scene &scene, const std::wstring &folder, std::wstring &why)
{
    std::wstring file = wide(scene.words(SINS_SCENE_TEXT_LOG));
    std::string bytes;
    sins_fault fault = sized<sins_fault>();
    sins_log_info info = sized<sins_log_info>();
    sins_flight_sample sample = sized<sins_flight_sample>();
    double wanted_s = scene.setup().duration_s;
    log_path = is_absolute(file) ? file : folder + file;
    if (!read_file(log_path, bytes, why)) {
        return false;
    }
    if (lib.sins_log_parse(bytes.data(), bytes.size(), &log_, &fault) < 0) {
        std::wstring place = L":" + std::to_wstring(fault.line) + L":" + std::to_wstring(fault.column);
        why = log_path + (fault.line > 0 ? place + L": " + told(fault.sentence) : L": " + last_error());
        return false;
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
    period_s = count > 1 ? duration_s / (double)(count - 1) : 0;
    why = count > 1 ? L"" : text("no_flight");
    return count > 1;
}

sins_status Samples::get(size_t index, sins_flight_sample *sample) const
{
    return log_ != NULL ? lib.sins_log_get_sample(log_, index, sample, NULL)
                        : lib.sins_flight_sample_at(flight_, min((double)index / rate_hz_, end_s_), sample);
}

std::wstring Samples::place(size_t index) const
{
    sins_flight_sample sample = sized<sins_flight_sample>();
    uint64_t line = 0;
    if (log_ == NULL) {
        return shown((double)index * period_s, 10) + L" s: ";
    }
    lib.sins_log_get_sample(log_, index, &sample, &line);
    return log_path + L":" + std::to_wstring(line) + L": ";
}
