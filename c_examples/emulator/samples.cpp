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
    if (lib.sins_scene_create_flight(scene.handle(), &flight_) < 0 || lib.sins_flight_duration(flight_, &end_s_) < 0) {
        why = wide(last_error());
        return false;
    }
    rate_hz_ = setup.rate_hz;
    period_s = 1 / rate_hz_;
    double flown_s = setup.flown_s > 0 ? setup.flown_s : end_s_;
    double intervals = std::floor(flown_s / period_s + ROUNDING);
    count = (size_t)intervals + 1;
    duration_s = intervals * period_s;
    return true;
}

bool Samples::open_log(const Scene &scene, const std::wstring &folder, std::wstring &why)
{
    std::wstring file = wide(scene.words(SINS_SCENE_TEXT_LOG));
    bool is_absolute = file.find_first_of(L"/\\") == 0 || (file.size() > 1 && file[1] == L':');
    std::string bytes;
    sins_fault fault;
    sins_log_info info;
    SINS_INIT(fault);
    SINS_INIT(info);
    log_path = is_absolute ? file : folder + file;
    if (!read_file(log_path, bytes, why)) {
        return false;
    }
    sins_status status = lib.sins_log_parse(bytes.data(), bytes.size(), &log_, &fault);
    if (status < 0) {
        why = log_path + (fault.line > 0 ? L":" + std::to_wstring(fault.line) + L":" + std::to_wstring(fault.column) + L": " + wide(fault.sentence)
                                         : L": " + wide(last_error()));
        return false;
    }
    lib.sins_log_get_info(log_, &info);
    double wanted_s = scene.setup().duration_s;
    sins_flight_sample sample;
    SINS_INIT(sample);
    for (count = 0; count < info.samples; count++) {
        lib.sins_log_get_sample(log_, count, &sample, NULL);
        start_s = count == 0 ? sample.time_s : start_s;
        if (wanted_s > 0 && sample.time_s - start_s > wanted_s * (1 + ROUNDING)) {
            break;
        }
        duration_s = sample.time_s - start_s;
    }
    period_s = count > 1 ? duration_s / (double)(count - 1) : 0;
    why = count > 1 ? L"" : text(IDS_NO_FLIGHT);
    return count > 1;
}

sins_status Samples::get(size_t index, sins_flight_sample *sample) const
{
    return log_ != NULL ? lib.sins_log_get_sample(log_, index, sample, NULL)
                        : lib.sins_flight_sample_at(flight_, min((double)index / rate_hz_, end_s_), sample);
}

std::wstring Samples::place(size_t index) const
{
    sins_flight_sample sample;
    uint64_t line = 0;
    if (log_ == NULL) {
        return shown((double)index * period_s, 10) + L" s: ";
    }
    SINS_INIT(sample);
    lib.sins_log_get_sample(log_, index, &sample, &line);
    return log_path + L":" + std::to_wstring(line) + L": ";
}
