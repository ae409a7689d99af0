#include "flight.h"

#include <cmath>

/* Records of a flight, where the scene does not say; and points of its curves at the least. */
static const double RECORDS = 2000, LEAST_POINTS = 100000;
/* Steps between two looks at the window. */
static const int STEPS = 256;

/* The columns of a file of records, as `sins fly` writes it. */
static const char COLUMNS[] =
    "time_s,truth_latitude_rad,truth_longitude_rad,truth_height_m,truth_velocity_east_m_s,truth_velocity_north_m_s,"
    "truth_velocity_up_m_s,truth_roll_rad,truth_pitch_rad,truth_heading_rad,navigation_latitude_rad,navigation_longitude_rad,"
    "navigation_height_m,navigation_velocity_east_m_s,navigation_velocity_north_m_s,navigation_velocity_up_m_s,"
    "navigation_roll_rad,navigation_pitch_rad,navigation_heading_rad,navigation_error_position_east_m,"
    "navigation_error_position_north_m,navigation_error_position_up_m,navigation_error_velocity_east_m_s,"
    "navigation_error_velocity_north_m_s,navigation_error_velocity_up_m_s,navigation_error_misalignment_east_rad,"
    "navigation_error_misalignment_north_rad,navigation_error_misalignment_up_rad,navigation_error_roll_rad,"
    "navigation_error_pitch_rad,navigation_error_heading_rad,navigation_error_flags,model_error_position_east_m,"
    "model_error_position_north_m,model_error_position_up_m,model_error_velocity_east_m_s,model_error_velocity_north_m_s,"
    "model_error_velocity_up_m_s,model_error_misalignment_east_rad,model_error_misalignment_north_rad,"
    "model_error_misalignment_up_rad,model_error_roll_rad,model_error_pitch_rad,model_error_heading_rad,model_error_flags,"
    "gyro_error_x_rad_s,gyro_error_y_rad_s,gyro_error_z_rad_s,accel_error_x_m_s2,accel_error_y_m_s2,accel_error_z_m_s2\n";

/* Holds the lock of a flight; the worker makes way for the window. */
class Guard {
public:
    explicit Guard(const Flight &flight) : flight_(flight)
    {
        flight_.waiting_++;
        EnterCriticalSection(&flight_.section_);
        flight_.waiting_--;
    }
    ~Guard() { LeaveCriticalSection(&flight_.section_); }

private:
    const Flight &flight_;
};

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

/* Attitude, velocity and place of a solution, beside those of another in the curves. */
static void put(Point &point, int channel, const double *values)
{
    for (int k = 0; k < 3; k++) {
        point[channel + k] = values[k];
    }
}

static void put(Point &point, int side, const sins_record_solution &solution)
{
    put(point, ATTITUDE + side, &solution.roll_rad);
    put(point, VELOCITY + side, solution.velocity_enu_m_s);
    put(point, PLACE + side, &solution.latitude_rad);
}

static void put(Point &point, int side, const sins_record_errors &errors)
{
    put(point, ATTITUDE_ERROR + side, &errors.roll_rad);
    put(point, VELOCITY_ERROR + side, errors.velocity_enu_m_s);
    put(point, POSITION_ERROR + side, errors.position_enu_m);
}

static void append(std::string &line, const double *values, int count)
{
    for (int k = 0; k < count; k++) {
        line += "," + shortest(values[k]);
    }
}

/* Takes a point for the curves, and a row for the file. */
bool Flight::keep(bool is_row, std::wstring &why)
{
    sins_record record;
    Point point;
    SINS_INIT(record);
    if (lib.sins_get_record(sim_, &record) < 0) {
        why = wide(last_error(sim_));
        return false;
    }
    point.fill(0);
    put(point, 0, record.navigation_errors);
    put(point, 3, record.model_errors);
    put(point, 0, record.truth);
    put(point, 3, record.navigation);
    add_extremes(point, 0, RATE);
    add_extremes(point, ATTITUDE, CHANNELS);
    if (now_.time_s > 0) {
        put(point, RATE, &now_.high[RATE]);
        put(point, FORCE, &now_.high[FORCE]);
        now_.curves.add(record.time_s - samples_.start_s, now_.low, now_.high, point);
        now_.has_point = false;
    }
    if (!is_row) {
        return true;
    }
    std::string line = now_.next == 1 ? COLUMNS : "";
    line += shortest(record.time_s);
    for (const sins_record_solution *solution : {&record.truth, &record.navigation}) {
        append(line, &solution->latitude_rad, 3);
        append(line, solution->velocity_enu_m_s, 3);
        append(line, &solution->roll_rad, 3);
    }
    for (const sins_record_errors *errors : {&record.navigation_errors, &record.model_errors}) {
        append(line, errors->position_enu_m, 3);
        append(line, errors->velocity_enu_m_s, 3);
        append(line, errors->misalignment_enu_rad, 3);
        append(line, &errors->roll_rad, 3);
        line += "," + std::to_string(errors->flags);
    }
    for (double *sum : {now_.angle, now_.velocity}) {
        for (int k = 0; k < 3; k++) {
            double mean = now_.time_s > 0 ? sum[k] / now_.time_s : 0;
            append(line, &mean, 1);
            sum[k] = 0;
        }
    }
    now_.time_s = 0;
    return write(line + "\n", why);
}

bool Flight::write(const std::string &bytes, std::wstring &why)
{
    buffer_ += bytes;
    return buffer_.size() < 1 << 16 || flush(why);
}

bool Flight::flush(std::wstring &why)
{
    DWORD written = 0;
    LARGE_INTEGER at;
    at.QuadPart = now_.written;
    if (!SetFilePointerEx(file_, at, NULL, FILE_BEGIN) || !WriteFile(file_, buffer_.data(), (DWORD)buffer_.size(), &written, NULL)
        || written != buffer_.size()) {
        why = text(IDS_CANNOT_WRITE, L"temporary file", system_sentence(GetLastError()));
        return false;
    }
    now_.written += written;
    buffer_.clear();
    return true;
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

bool Flight::write_records(const std::wstring &path, std::wstring &why) const
{
    Guard guard(*this);
    if (!const_cast<Flight *>(this)->flush(why)) {
        return false;
    }
    long long at = 0;
    return write_file(path, [&] {
        LARGE_INTEGER from;
        std::string piece((size_t)min(now_.written - at, 1ll << 20), '\0');
        DWORD read = 0;
        from.QuadPart = at;
        if (!SetFilePointerEx(file_, from, NULL, FILE_BEGIN) || !ReadFile(file_, &piece[0], (DWORD)piece.size(), &read, NULL)) {
            read = 0;
        }
        at += read;
        piece.resize(read);
        return piece;
    }, why);
}
