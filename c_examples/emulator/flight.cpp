#include "flight.h"

#include <cmath>

/* Records of a flight, where the scene does not say; and points of its curves at the least. */
static const double RECORDS = 2000, LEAST_POINTS = 100000;
/* Steps between two looks at the window. */
static const int STEPS = 256;

std::unique_lock<std::mutex> Flight::lock() const
{
    waiting_++;
    std::unique_lock<std::mutex> lock(mutex_);
    waiting_--;
    return lock;
}

bool Flight::start(const Scene &scene, const std::wstring &folder, double pace, std::wstring &why)
{
    why = told(scene_.read(scene.text()));
    if (!why.empty() || !samples_.open(scene_, folder, why)) {
        return false;
    }
    if (lib.sins_scene_create_simulator(scene_.handle(), &sim_) < 0) {
        why = last_error();
        return false;
    }
    double every_s = scene_.setup().every_s, intervals = (double)(samples_.count - 1);
    every_ =
        (size_t)std::fmax(std::round(every_s > 0 ? every_s / samples_.period_s : intervals / RECORDS), 1);
    points_every_ = (size_t)std::fmax((double)samples_.count / LEAST_POINTS, 1);
    if (!records_.open(why) || (!increments_name().empty() && !increments_.open(why))) {
        return false;
    }
    move_pace(pace);
    worker_ = std::thread(&Flight::fly, this);
    return true;
}

void Flight::fly()
{
    SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); /* the window answers first */
    while (!ends_) {
        bool waits = waiting_ > 0;
        {
            std::lock_guard<std::mutex> guard(mutex_);
            double elapsed_s = (double)(GetTickCount64() - paced_at_ms_) / 1000;
            double due_s = pace_ > 0 ? paced_from_s_ + pace_ * elapsed_s : INFINITY;
            for (int k = 0; k < STEPS && state_ == FLYING && !waits; k++) {
                if ((double)now_.next * samples_.period_s > due_s) {
                    waits = true;
                } else if (!step(sentence_)) {
                    state_ = FAILED;
                } else if (now_.next == samples_.count) {
                    state_ = FINISHED;
                }
            }
            waits = waits || state_ != FLYING;
        }
        if (waits) {
            Sleep(state_ == FLYING ? 1 : 20);
        }
    }
}

/* Flies to the next sample. */
bool Flight::step(std::wstring &why)
{
    sins_flight_sample sample = sized<sins_flight_sample>();
    sins_imu imu = sized<sins_imu>();
    size_t index = now_.next;
    if (samples_.get(index, &sample) < 0 ||
        lib.sins_scene_prepare(scene_.handle(), sim_, samples_.start_s, &sample) < 0) {
        why = samples_.place(index) + last_error();
        return false;
    }
    if (lib.sins_push_sample(sim_, &sample) < 0 || lib.sins_step(sim_) < 0) {
        why = samples_.place(index) + last_error(sim_);
        return false;
    }
    now_.next++;
    if (index > 0 && lib.sins_get_imu(sim_, &imu) == SINS_OK && !add_interval(imu, why)) {
        return false;
    }
    bool is_row = index % every_ == 0;
    return (!is_row && index % points_every_ != 0) || keep(is_row, why);
}

void Flight::pace(double factor)
{
    auto guard = lock();
    move_pace(factor);
}

/* From now on at this pace. */
void Flight::move_pace(double factor)
{
    pace_ = factor;
    paced_from_s_ = (double)now_.next * samples_.period_s;
    paced_at_ms_ = GetTickCount64();
}

void Flight::pause(bool paused)
{
    auto guard = lock();
    state_ = state_ == FLYING && paused ? PAUSED : state_ == PAUSED && !paused ? FLYING : state_;
    move_pace(pace_);
}

/* The worker ends; what was flown stays. */
void Flight::stop()
{
    if (worker_.joinable()) {
        ends_ = true;
        worker_.join();
        state_ = state_ == FLYING || state_ == PAUSED ? STOPPED : state_;
    }
}

Flight::Status Flight::status() const
{
    auto guard = lock();
    Status status = {state_,   0, samples_.duration_s, saved_s_, sized<sins_record>(), sized<sins_accuracy>(),
                     sentence_};
    if (lib.sins_get_record(sim_, &status.record) == SINS_OK) {
        status.time_s = status.record.time_s - samples_.start_s;
    }
    lib.sins_get_accuracy(sim_, &status.accuracy);
    return status;
}

Curves Flight::curves() const
{
    auto guard = lock();
    return now_.curves;
}

void Flight::plan(const Scene &scene)
{
    auto guard = lock();
    Scene planned;
    sins_planned_failure failure = sized<sins_planned_failure>(), other = failure;
    sins_failure none = sized<sins_failure>();
    planned.read(scene.text());
    /* Outputs for which the scene plans none any more are left alone by sins_scene_prepare(). */
    for (size_t k = 0; lib.sins_scene_get_failure(scene_.handle(), k, &failure) == SINS_OK; k++) {
        bool stays = false;
        for (size_t m = 0; lib.sins_scene_get_failure(planned.handle(), m, &other) == SINS_OK; m++) {
            stays = stays || (other.sensor == failure.sensor && other.axis == failure.axis);
        }
        if (!stays) {
            lib.sins_set_failure(sim_, failure.sensor, failure.axis, &none);
        }
    }
    scene_ = std::move(planned);
}

bool Flight::save_snapshot(std::wstring &why)
{
    double time_s = status().time_s;
    auto guard = lock();
    size_t size = 0;
    lib.sins_snapshot_size(sim_, &size);
    snapshot_.resize(size);
    if (lib.sins_snapshot_save(sim_, snapshot_.data(), size, &size) < 0) {
        why = last_error(sim_);
        return false;
    }
    saved_ = now_;
    saved_.records = records_.size();
    saved_.increments = increments_.size();
    saved_s_ = time_s;
    return true;
}

bool Flight::go_back(std::wstring &why)
{
    auto guard = lock();
    if (saved_s_ < 0 || lib.sins_snapshot_load(sim_, snapshot_.data(), snapshot_.size()) < 0) {
        why = saved_s_ < 0 ? text("no_snapshot") : last_error(sim_);
        return false;
    }
    now_ = saved_;
    records_.cut(now_.records);
    increments_.cut(now_.increments);
    state_ = state_ == FLYING ? FLYING : PAUSED;
    move_pace(pace_);
    return true;
}
