/* The flight of a scene, sample by sample: computed by the library, or read from a log. */
#pragma once
#include "scene.h"

class Samples {
public:
    /* folder: that of the scene's file, from which a log is seen. */
    bool open(const Scene &scene, const std::wstring &folder, std::wstring &why);
    sins_status get(size_t index, sins_flight_sample *sample) const;
    /* Where a sample stands, for a sentence about it: the time, or the line of the log. */
    std::wstring place(size_t index) const;

    size_t count = 0;
    double period_s = 0, duration_s = 0, start_s = 0;
    std::wstring log_path; /* "": no log */

private:
    bool open_log(const Scene &scene, const std::wstring &folder, std::wstring &why);
    Handle<sins_flight> flight_;
    Handle<sins_log> log_;
    double rate_hz_ = 0, end_s_ = 0;
};
