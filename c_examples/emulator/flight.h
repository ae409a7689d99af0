/* A flight through the simulator: a worker thread steps, the window reads. */
#pragma once
#include <windows.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "curves.h"
#include "samples.h"

/* Lines of text in a temporary file: they may be more than fit into memory. */
class Lines {
public:
    ~Lines();
    bool open(std::wstring &why);
    bool is_open() const { return file_ != NULL; }
    bool add(const std::string &line, std::wstring &why);
    long long size() const { return size_; }
    void cut(long long size) { size_ = size; }
    bool copy(const std::wstring &path, std::wstring &why) const;

private:
    FILE *file_ = NULL;
    long long size_ = 0; /* bytes that count */
};

class Flight {
public:
    enum State { FLYING, PAUSED, FINISHED, STOPPED, FAILED };
    struct Status {
        State state;
        double time_s, duration_s, snapshot_s; /* since the start; snapshot_s: -1 without one */
        sins_record record;
        sins_accuracy accuracy;
        std::wstring sentence; /* why it failed */
    };

    ~Flight() { stop(); }
    /* Begins with the first sample; pace: times real time, 0 as fast as it goes. */
    bool start(const Scene &scene, const std::wstring &folder, double pace, std::wstring &why);
    void pace(double factor);
    void pause(bool paused);
    void stop();
    Status status() const;
    Curves curves() const;
    /* The failures of the scene as they are now: they take effect with the next interval. */
    void plan(const Scene &scene);
    bool save_snapshot(std::wstring &why);
    bool go_back(std::wstring &why);
    /* The records so far, as `sins fly` writes them; the measured increments, if the scene names a file for
     * them. */
    bool write_records(const std::wstring &path, std::wstring &why) const;
    bool write_increments(const std::wstring &path, std::wstring &why) const;
    std::wstring increments_name() const { return wide(scene_.words(SINS_SCENE_TEXT_IMU)); }
    const std::wstring &log_path() const { return samples_.log_path; }

private:
    struct Moment {      /* what goes on from sample to sample */
        size_t next = 0; /* sample */
        double angle[3] = {}, velocity[3] = {},
               time_s = 0; /* sums since the last record: sensor errors and their time */
        Point low, high;   /* since the last point of the curves */
        bool has_point = false;
        long long records = 0, increments = 0; /* bytes */
        Curves curves;
    };
    std::unique_lock<std::mutex> lock() const; /* the worker makes way for the window */
    void fly();
    bool step(std::wstring &why);
    bool add_interval(const sins_imu &imu, std::wstring &why);
    bool keep(bool is_row, std::wstring &why);
    bool keep_row(const sins_record &record, std::wstring &why);
    void add_extremes(const Point &point, int first, int last);
    void move_pace(double factor);

    Handle<sins_sim> sim_;
    Scene scene_;
    Samples samples_;
    size_t every_ = 1, points_every_ = 1;
    Moment now_, saved_;
    double saved_s_ = -1;
    std::vector<char> snapshot_;
    Lines records_, increments_;
    std::thread worker_;
    State state_ = FLYING;
    std::wstring sentence_;
    double pace_ = 0, paced_from_s_ = 0;
    ULONGLONG paced_at_ms_ = 0;
    mutable std::mutex mutex_;
    mutable std::atomic<int> waiting_{0};
    std::atomic<bool> ends_{false};
};
