#include "flight.h"

#include <cmath>

/* Records of a flight, where the scene does not say; and points of its curves at the least. */
static const double RECORDS = 2000, LEAST_POINTS = 100000;
/* Steps between two looks at the window. */
static const int STEPS = 256;

Flight::~Flight()
{
    stop();
    if (file_ != INVALID_HANDLE_VALUE) {
        CloseHandle(file_);
    }
    if (worker_ != NULL) {
        DeleteCriticalSection(&section_);
    }
}

bool Flight::start(const Scene &scene, const std::wstring &folder, double pace, std::wstring &why)
{
    std::vector<Fault> faults;
    WCHAR temporary[MAX_PATH] = L"", path[MAX_PATH] = L"";
    if (!scene_.read(scene.text(), faults) || !samples_.open(scene_, folder, why)) {
        why = faults.empty() ? why : wide(faults[0].sentence);
        return false;
    }
    double every_s = scene_.setup().every_s;
    every_ = (size_t)std::fmax(every_s > 0 ? std::round(every_s / samples_.period_s) : std::round((double)(samples_.count - 1) / RECORDS), 1);
    points_every_ = (size_t)std::fmax((double)samples_.count / LEAST_POINTS, 1);
    if (lib.sins_scene_create_simulator(scene_.handle(), &sim_) < 0) {
        why = wide(last_error());
        return false;
    }
    GetTempPathW(MAX_PATH, temporary);
    GetTempFileNameW(temporary, L"sns", 0, path);
    file_ = CreateFileW(path, GENERIC_READ | GENERIC_WRITE, 0, NULL, CREATE_ALWAYS, FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    if (file_ == INVALID_HANDLE_VALUE) {
        why = text(IDS_CANNOT_WRITE, path, system_sentence(GetLastError()));
        return false;
    }
    InitializeCriticalSection(&section_);
    pace_ = pace;
    paced_at_ms_ = GetTickCount64();
    worker_ = CreateThread(NULL, 0, thread, this, 0, NULL);
    SetThreadPriority(worker_, THREAD_PRIORITY_BELOW_NORMAL); /* the window answers first */
    return worker_ != NULL;
}

DWORD WINAPI Flight::thread(void *flight)
{
    ((Flight *)flight)->fly();
    return 0;
}

void Flight::fly()
{
    while (!ends_) {
        bool waits = waiting_ > 0;
        {
            Guard guard(*this);
            double due_s = pace_ > 0 ? paced_from_s_ + pace_ * (double)(GetTickCount64() - paced_at_ms_) / 1000 : INFINITY;
            for (int k = 0; k < STEPS && state_ == FLYING; k++) {
                if ((double)now_.next * samples_.period_s > due_s) {
                    waits = true;
                    break;
                }
                if (!step(sentence_)) {
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
    sins_flight_sample sample;
    sins_imu imu;
    size_t index = now_.next;
    SINS_INIT(sample);
    SINS_INIT(imu);
    if (samples_.get(index, &sample) < 0 || lib.sins_scene_prepare(scene_.handle(), sim_, samples_.start_s, &sample) < 0) {
        why = samples_.place(index) + wide(last_error());
        return false;
    }
    if (lib.sins_push_sample(sim_, &sample) < 0 || lib.sins_step(sim_) < 0) {
        why = samples_.place(index) + wide(last_error(sim_));
        return false;
    }
    now_.next++;
    if (index > 0 && lib.sins_get_imu(sim_, &imu) == SINS_OK) {
        Point point;
        for (int k = 0; k < 3; k++) {
            now_.angle[k] += imu.measured_angle_rad[k] - imu.ideal_angle_rad[k];
            now_.velocity[k] += imu.measured_velocity_m_s[k] - imu.ideal_velocity_m_s[k];
            point[RATE + k] = imu.measured_rate_rad_s[k];
            point[FORCE + k] = imu.measured_force_m_s2[k];
        }
        now_.time_s += imu.interval_s;
        add_extremes(point, RATE, ATTITUDE);
    }
    bool is_row = index % every_ == 0;
    return (!is_row && index % points_every_ != 0) || keep(is_row, why);
}

void Flight::add_extremes(const Point &point, int first, int last)
{
    if (!now_.has_point) {
        now_.low.fill(INFINITY);
        now_.high.fill(-INFINITY);
        now_.has_point = true;
    }
    for (int k = first; k < last; k++) {
        now_.low[k] = std::fmin(now_.low[k], point[k]);
        now_.high[k] = std::fmax(now_.high[k], point[k]);
    }
}

void Flight::pace(double factor)
{
    Guard guard(*this);
    pace_ = factor;
    paced_from_s_ = (double)now_.next * samples_.period_s;
    paced_at_ms_ = GetTickCount64();
}

void Flight::pause(bool paused)
{
    double factor;
    {
        Guard guard(*this);
        factor = pace_;
        state_ = state_ == FLYING && paused ? PAUSED : state_ == PAUSED && !paused ? FLYING : state_;
    }
    pace(factor);
}

/* The worker ends; what was flown stays. */
void Flight::stop()
{
    if (worker_ != NULL && !ends_.exchange(true)) {
        WaitForSingleObject(worker_, INFINITE);
        CloseHandle(worker_);
        state_ = state_ == FLYING || state_ == PAUSED ? STOPPED : state_;
    }
}

Flight::Status Flight::status() const
{
    Guard guard(*this);
    Status status = {state_, 0, samples_.duration_s, snapshot_.empty() ? -1 : saved_s_, {}, {}, sentence_};
    SINS_INIT(status.record);
    SINS_INIT(status.accuracy);
    if (lib.sins_get_record(sim_, &status.record) == SINS_OK) {
        status.time_s = status.record.time_s - samples_.start_s;
    }
    lib.sins_get_accuracy(sim_, &status.accuracy);
    return status;
}

void Flight::read(Curves &curves) const
{
    Guard guard(*this);
    curves = now_.curves;
}

void Flight::plan(const Scene &scene)
{
    Guard guard(*this);
    Scene planned;
    std::vector<Fault> faults;
    sins_planned_failure failure, other;
    sins_failure none;
    SINS_INIT(failure);
    SINS_INIT(other);
    SINS_INIT(none);
    if (!planned.read(scene.text(), faults)) {
        return;
    }
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
    Guard guard(*this);
    size_t size = 0;
    if (!flush(why) || lib.sins_snapshot_size(sim_, &size) < 0) {
        return false;
    }
    snapshot_.resize(size);
    lib.sins_snapshot_save(sim_, snapshot_.data(), size, &size);
    saved_ = now_;
    sins_record record;
    SINS_INIT(record);
    lib.sins_get_record(sim_, &record);
    saved_s_ = record.time_s - samples_.start_s;
    return true;
}

bool Flight::go_back(std::wstring &why)
{
    bool done = false;
    double factor;
    {
        Guard guard(*this);
        factor = pace_;
        if (!snapshot_.empty() && flush(why)) {
            done = lib.sins_snapshot_load(sim_, snapshot_.data(), snapshot_.size()) == SINS_OK;
            why = done ? L"" : wide(last_error(sim_));
        }
        if (done) {
            now_ = saved_;
            state_ = state_ == FLYING ? FLYING : PAUSED;
        }
    }
    pace(factor);
    return done;
}
