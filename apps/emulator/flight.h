/* A flight through the simulator: a worker thread steps, the window reads. */
#pragma once
#include <memory>
#include <mutex>
#include <thread>

#include "curves.h"
#include "increments.h"
#include "samples.h"

#include "live.h" /* after the loaded library */

class Flight {
public:
    enum State { FLYING, PAUSED, FINISHED, STOPPED, FAILED };
    struct Status {
        State state;
        double time_s, duration_s, snapshot_s; /* times since the start; snapshot_s: -1 without a snapshot */
        sins_record record;
        sins_accuracy accuracy;
        std::wstring sentence; /* the reason of a failure */
        std::optional<Traffic> traffic; /* of a live flight */
    };

    /* Begins with the first sample. pace: speed as a multiple of real time; 0: as fast as possible. live: NULL, or the packets that
     * are flown instead of the flight of the scene. */
    Flight(const Scene &scene, const fs::path &folder, double pace, const LiveSource *live)
        : scene_(scene), samples_(live == NULL ? Samples(scene, folder) : Samples()), play_(scene, samples_.log()),
          sim_(play_.simulator()), has_covariance_(sim_->options().covariance != 0), records_(sins::Simulator::record_head(has_covariance_)) {
        points_every_ = live != NULL ? 1 : (size_t)max((double)samples_.all.count / LEAST_POINTS, 1.0);
        if (!increments_name().empty())
            increments_.emplace(narrow(text("increments")));
        start_.records = records_.size();
        start_.increments = increments_ ? increments_->size() : 0;
        set_pace(pace);
        if (live != NULL) {
            live_.emplace(*live, sim_->options());
            if (!live_->is_open())
                throw refusal("cannot_listen", std::to_wstring(live->port));
        }
        worker_ = std::thread(&Flight::fly, this);
    }

    ~Flight() { stop(); }

    /* Holds the flight: the worker does not step while the lock exists. */
    std::unique_lock<std::recursive_mutex> hold() const {
        std::lock_guard<std::mutex> door(door_); /* the window takes precedence over the worker */
        return std::unique_lock<std::recursive_mutex>(mutex_);
    }

    /* Sets the pace from now on. */
    void set_pace(double pace) {
        auto held = hold();
        pace_ = pace;
        paced_from_s_ = next_s();
        paced_at_ms_ = GetTickCount64();
    }

    void pause(bool paused) {
        auto held = hold();
        state_ = state_ == FLYING && paused ? PAUSED : state_ == PAUSED && !paused ? FLYING : state_;
        set_pace(pace_);
    }

    /* Ends the worker. The flight so far stays. */
    void stop() {
        if (worker_.joinable()) {
            ends_ = true;
            worker_.join();
            if (live_ && is_under_way() && now_.next > 0 && (now_.next - 1) % samples_.all.record_every != 0)
                keep_row(record());
            if (live_)
                live_->close(); /* another flight may listen */
            state_ = is_under_way() ? STOPPED : state_;
        }
    }

    Status status() const {
        auto held = hold();
        sins_record record = sins::make<sins_record>();
        sins_accuracy accuracy = sins::make<sins_accuracy>();
        bool has_record = sim_->get_record(record);
        sim_->get_accuracy(accuracy);
        double time_s = has_record ? record.time_s - samples_.all.start_s : 0;
        Status status = {state_, time_s, live_ ? time_s : samples_.all.duration_s, saved_s_, record, accuracy, sentence_, {}};
        if (live_)
            status.traffic = live_->traffic();
        return status;
    }

    bool is_under_way() const {
        auto held = hold();
        return state_ == FLYING || state_ == PAUSED;
    }

    Curves curves() const {
        auto held = hold();
        return now_.curves;
    }

    /* Takes over the current failures of the scene, which act from the next interval on. */
    void plan(const Scene &scene) {
        auto held = hold();
        scene_.set_items("failure", scene.items("failure")); /* other settings are those of the start */
        play_.set_plan(scene_);
    }

    bool is_live() const { return live_.has_value(); }

    std::string settings() const {
        auto held = hold();
        return scene_.write();
    }

    void save_snapshot() {
        auto held = hold();
        snapshot_ = play_.save();
        now_.records = records_.size();
        now_.increments = increments_ ? increments_->size() : 0;
        saved_ = now_;
        saved_s_ = status().time_s;
    }

    void go_back() {
        auto held = hold();
        if (saved_s_ < 0)
            throw Refusal(text("no_snapshot"));
        play_.load(snapshot_);
        return_to(saved_);
        state_ = state_ == FLYING ? FLYING : PAUSED;
        set_pace(pace_);
    }

    /* Writes the records so far in the format of `sins fly`, or the measured increments. */
    void write(const fs::path &path, bool increments) {
        auto held = hold();
        (increments ? *increments_ : records_).copy(path);
    }

    /* The file that the scene names for the increments, or "". */
    fs::path increments_name() const { return wide(scene_.text(SINS_SCENE_TEXT_IMU)); }
    const fs::path &log_path() const { return samples_.log_path; }

private:
    static constexpr double LEAST_POINTS = 100000; /* least number of points of the curves */
    static constexpr int STEPS = 256;              /* steps before the window may take the lock */

    struct Moment {                                 /* state from sample to sample */
        size_t next = 0;                            /* number of the next sample */
        double sums[6] = {}, time_s = 0;            /* sums since the last record: errors of gyros, accelerometers */
        std::streamoff records = 0, increments = 0; /* sizes [bytes] */
        Curves curves;
    };

    void fly() {
        SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); /* the window takes precedence */
        while (!ends_) {
            { std::lock_guard<std::mutex> door(door_); }
            std::unique_lock<std::recursive_mutex> held(mutex_);
            double elapsed_s = (double)(GetTickCount64() - paced_at_ms_) / 1000;
            double due_s = pace_ > 0 ? paced_from_s_ + pace_ * elapsed_s : INFINITY;
            int k = 0;
            for (; k < STEPS && state_ == FLYING && is_due(due_s); k++)
                step();
            held.unlock();
            if (k < STEPS)
                Sleep(1);
        }
    }

    /* Whether the next sample is due, or its packet has come. */
    bool is_due(double due_s) {
        if (!live_)
            return next_s() <= due_s;
        passed_ = live_->next(sample_);
        return passed_.has_value();
    }

    void return_to(const Moment &moment) {
        now_ = moment;
        records_.cut(now_.records);
        if (increments_)
            increments_->cut(now_.increments);
    }

    /* Flies to the next sample. */
    void step() {
        try {
            if (passed_ == Passed::BEGINS) { /* the first packet, or the aircraft was moved */
                play_.load(begun_);
                return_to(start_);
                samples_.all.start_s = sample_.time_s;
            }
            live_ ? play_.push(sample_) : play_.next();
            keep(now_.next++);
            state_ = now_.next == samples_.all.count ? FINISHED : FLYING;
        } catch (const std::exception &error) {
            sentence_ = (live_ ? shown(sample_.time_s, 10) + L" s: " : samples_.place(now_.next)) + told_in_flight(error);
            state_ = FAILED;
        }
    }

    void keep(size_t index) {
        sins_imu imu = sins::make<sins_imu>();
        if (index > 0 && sim_->get_imu(imu))
            keep_interval(imu);
        if (live_ && index == 1) { /* without a wish of the scene, a record each second, as `sins live` */
            double every_s = scene_.setup().every_s > 0 ? scene_.setup().every_s : 1;
            samples_.all.record_every = (uint64_t)max(std::round(every_s / imu.interval_s), 1.0);
        }
        bool is_row = index % samples_.all.record_every == 0 || index + 1 == samples_.all.count;
        if (is_row || index % points_every_ == 0) {
            const sins_record now = record();
            keep_point(now);
            if (index > 0) /* rates begin with the first interval */
                now_.curves.end_point(now.time_s - samples_.all.start_s);
            if (is_row)
                keep_row(now);
        }
    }

    sins_record record() const {
        sins_record record = sins::make<sins_record>();
        sim_->get_record(record);
        return record;
    }

    /* Stores the output of the sensors over an interval. */
    void keep_interval(const sins_imu &imu) {
        for (int k = 0; k < 3; k++) {
            now_.sums[k] += imu.measured_angle_rad[k] - imu.ideal_angle_rad[k];
            now_.sums[3 + k] += imu.measured_velocity_m_s[k] - imu.ideal_velocity_m_s[k];
        }
        now_.time_s += imu.interval_s;
        now_.curves.put(RATE, imu.measured_rate_rad_s);
        now_.curves.put(FORCE, imu.measured_force_m_s2);
        if (increments_)
            add_increments(*increments_, *sim_, imu.time_s);
    }

    void keep_point(const sins_record &record) {
        for (int k = 0; k < 2; k++) {
            const sins_record_errors &errors = k == 0 ? record.model_errors : record.navigation_errors;
            const sins_record_solution &solution = k == 0 ? record.truth : record.navigation;
            now_.curves.put(ATTITUDE_ERROR + 3 * k, &errors.roll_rad);
            now_.curves.put(VELOCITY_ERROR + 3 * k, errors.velocity_enu_m_s);
            now_.curves.put(POSITION_ERROR + 3 * k, errors.position_enu_m);
            now_.curves.put(ATTITUDE + 3 * k, &solution.roll_rad);
            now_.curves.put(VELOCITY + 3 * k, solution.velocity_enu_m_s);
            now_.curves.put(PLACE + 3 * k, &solution.latitude_rad);
        }
    }

    void keep_row(const sins_record &record) {
        sins_covariance covariance = sins::make<sins_covariance>();
        bool has_covariance = has_covariance_ && sim_->get_covariance(covariance);
        std::vector<double> means(now_.sums, now_.sums + 6);
        for (double &mean : means)
            mean /= now_.time_s > 0 ? now_.time_s : 1;
        records_.add(sins::Simulator::record_line(record, means, has_covariance ? &covariance : NULL));
        std::fill(now_.sums, now_.sums + 6, 0.0);
        now_.time_s = 0;
    }

    double next_s() const { return (double)now_.next * samples_.all.period_s; }

    Scene scene_;
    Samples samples_;
    sins::Play play_;
    mutable sins::Play::Lent<sins::Simulator> sim_;
    const std::vector<unsigned char> begun_ = play_.save(); /* before the first sample */
    bool has_covariance_;
    size_t points_every_; /* interval of points [samples] */
    Moment start_, now_, saved_;
    double saved_s_ = -1;
    std::vector<unsigned char> snapshot_;
    Lines records_;
    std::optional<Lines> increments_;
    std::optional<Live> live_;
    std::optional<Passed> passed_; /* the last packet that is flown, and its sample */
    sins_flight_sample sample_ = sins::make<sins_flight_sample>();
    State state_ = FLYING;
    std::wstring sentence_;
    double pace_ = 0, paced_from_s_ = 0;
    ULONGLONG paced_at_ms_ = 0;
    mutable std::mutex door_;
    mutable std::recursive_mutex mutex_;
    std::atomic<bool> ends_{false};
    std::thread worker_;
};
