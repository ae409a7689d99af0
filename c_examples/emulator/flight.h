/* A flight through the simulator: a worker thread steps, the window reads. */
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "curves.h"
#include "lines.h"
#include "samples.h"

class Flight
{
public:
    enum State { FLYING, PAUSED, FINISHED, STOPPED, FAILED };
    struct Status {
        State state;
        double time_s, duration_s, snapshot_s; /* since the start; snapshot_s: -1 without one */
        sins_record record;
        sins_accuracy accuracy;
        std::wstring sentence; /* why it failed */
    };

    /* Begins with the first sample; pace: times real time, 0 as fast as it goes. */
    Flight(const Scene &scene, const fs::path &folder, double pace);
    ~Flight() { stop(); }
    void pace(double factor);
    void pause(bool paused);
    void stop();
    Status status() const;
    Curves curves() const;
    /* The failures of the scene as they are now: they take effect with the next interval. */
    void plan(const Scene &scene);
    void save_snapshot();
    void go_back();
    /* The records so far, as `sins fly` writes them; and what the sensors measured in each interval. */
    void write_records(const fs::path &path);
    void write_increments(const fs::path &path);
    /* The file that the scene names for the increments; "": none. */
    fs::path increments_name() const { return wide(scene_.words(SINS_SCENE_TEXT_IMU)); }
    const fs::path &log_path() const { return samples_.log_path; }

private:
    struct Moment {                                         /* what goes on from sample to sample */
        size_t next = 0;                                    /* sample */
        double angle[3] = {}, velocity[3] = {}, time_s = 0; /* sums since the last record: sensor errors */
        std::streamoff records = 0, increments = 0;         /* bytes */
        Curves curves;
    };
    std::unique_lock<std::mutex> lock() const; /* the worker makes way for the window */
    void fly();
    void step();
    void add_interval(const sins_imu &imu);
    void keep(bool is_row);
    void keep_row(const sins_record &record);
    void move_pace(double factor);
    double next_s() const { return (double)now_.next * samples_.period_s; }

    Handle<sins_sim> sim_;
    Scene scene_;
    Samples samples_;
    size_t every_, points_every_; /* samples */
    bool has_covariance_;
    Moment now_, saved_;
    double saved_s_ = -1;
    std::vector<char> snapshot_;
    Lines records_, increments_;
    State state_ = FLYING;
    std::wstring sentence_;
    double pace_ = 0, paced_from_s_ = 0;
    ULONGLONG paced_at_ms_ = 0;
    mutable std::mutex mutex_;
    mutable std::atomic<int> waiting_{0};
    std::atomic<bool> ends_{false};
    std::thread worker_;
};
