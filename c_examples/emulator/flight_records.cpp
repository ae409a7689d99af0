/* What is kept of a flight: points of its curves, and the lines of its files, as `sins fly` writes them. */
#include <cmath>

#include "flight.h"

Lines::~Lines()
{
    if (file_ != NULL) {
        fclose(file_);
    }
}

bool Lines::open(std::wstring &why)
{
    WCHAR folder[MAX_PATH] = L"", path[MAX_PATH] = L"";
    GetTempPathW(MAX_PATH, folder);
    GetTempFileNameW(folder, L"sns", 0, path);
    file_ = _wfopen(path, L"w+bD"); /* D: deleted when it is closed */
    why = file_ != NULL ? L"" : text("cannot_write", {path, L""});
    return file_ != NULL;
}

bool Lines::add(const std::string &line, std::wstring &why)
{
    bool is_behind = _ftelli64(file_) == size_ || _fseeki64(file_, size_, SEEK_SET) == 0;
    if (!is_behind || fwrite(line.data(), 1, line.size(), file_) != line.size()) {
        why = text("cannot_write", {text("temporary_file"), L""});
        return false;
    }
    size_ += (long long)line.size();
    return true;
}

bool Lines::copy(const std::wstring &path, std::wstring &why) const
{
    auto write = [this](FILE *to) {
        char piece[65536];
        _fseeki64(file_, 0, SEEK_SET);
        for (long long rest = size_; rest > 0;) {
            size_t size = fread(piece, 1, (size_t)min(rest, (long long)sizeof piece), file_);
            if (size == 0 || fwrite(piece, 1, size, to) != size) {
                return false;
            }
            rest -= (long long)size;
        }
        return _fseeki64(file_, size_, SEEK_SET) == 0;
    };
    return write_file(path, write, why);
}

/* The first line of the records. */
static std::string columns()
{
    static const char *const TRIPLES[] = {"x y z", "east north up", "roll pitch heading"};
    static const struct {
        const char *name, *unit;
        int axes; /* of TRIPLES */
    } ERRORS[] = {
        {"position_", "_m", 1}, {"velocity_", "_m_s", 1}, {"misalignment_", "_rad", 1}, {"", "_rad", 2}};
    std::string line = "time_s";
    auto add = [&](const std::string &before, int axes, const std::string &behind) {
        for (const std::string &axis : split(TRIPLES[axes], " ")) {
            line += "," + before + axis + behind;
        }
    };
    for (const std::string side : {"truth_", "navigation_"}) {
        line += "," + side + "latitude_rad," + side + "longitude_rad," + side + "height_m";
        add(side + "velocity_", 1, "_m_s");
        add(side, 2, "_rad");
    }
    for (const std::string side : {"navigation_error_", "model_error_"}) {
        for (const auto &error : ERRORS) {
            add(side + error.name, error.axes, error.unit);
        }
        line += "," + side + "flags";
    }
    add("gyro_error_", 0, "_rad_s");
    add("accel_error_", 0, "_m_s2");
    return line + "\n";
}

static const char INCREMENTS[] =
    "time_s,angle_increment_x_rad,angle_increment_y_rad,angle_increment_z_rad,"
    "velocity_increment_x_m_s,velocity_increment_y_m_s,velocity_increment_z_m_s\n";

static void put(Point &point, int channel, const double *values)
{
    std::copy(values, values + 3, &point[(size_t)channel]);
}

static void append(std::string &line, const double *values)
{
    for (int k = 0; k < 3; k++) {
        line += "," + shortest(values[k]);
    }
}

void Flight::add_extremes(const Point &point, int first, int last)
{
    if (!now_.has_point) {
        now_.low.fill(INFINITY);
        now_.high.fill(-INFINITY);
        now_.has_point = true;
    }
    for (size_t k = (size_t)first; k < (size_t)last; k++) {
        now_.low[k] = std::fmin(now_.low[k], point[k]);
        now_.high[k] = std::fmax(now_.high[k], point[k]);
    }
}

/* What the sensors gave over an interval. */
bool Flight::add_interval(const sins_imu &imu, std::wstring &why)
{
    Point point;
    for (int k = 0; k < 3; k++) {
        now_.angle[k] += imu.measured_angle_rad[k] - imu.ideal_angle_rad[k];
        now_.velocity[k] += imu.measured_velocity_m_s[k] - imu.ideal_velocity_m_s[k];
    }
    now_.time_s += imu.interval_s;
    put(point, RATE, imu.measured_rate_rad_s);
    put(point, FORCE, imu.measured_force_m_s2);
    add_extremes(point, RATE, ATTITUDE);
    if (!increments_.is_open()) {
        return true;
    }
    std::string line = (now_.next == 2 ? INCREMENTS : "") + shortest(imu.time_s);
    append(line, imu.measured_angle_rad);
    append(line, imu.measured_velocity_m_s);
    return increments_.add(line + "\n", why);
}

/* Takes a point for the curves, and a row for the file. */
bool Flight::keep(bool is_row, std::wstring &why)
{
    sins_record record = sized<sins_record>();
    Point point;
    if (lib.sins_get_record(sim_, &record) < 0) {
        why = last_error(sim_);
        return false;
    }
    for (int k = 0; k < 2; k++) {
        const sins_record_errors &errors = k == 0 ? record.navigation_errors : record.model_errors;
        const sins_record_solution &solution = k == 0 ? record.truth : record.navigation;
        put(point, ATTITUDE_ERROR + 3 * k, &errors.roll_rad);
        put(point, VELOCITY_ERROR + 3 * k, errors.velocity_enu_m_s);
        put(point, POSITION_ERROR + 3 * k, errors.position_enu_m);
        put(point, ATTITUDE + 3 * k, &solution.roll_rad);
        put(point, VELOCITY + 3 * k, solution.velocity_enu_m_s);
        put(point, PLACE + 3 * k, &solution.latitude_rad);
    }
    add_extremes(point, 0, RATE);
    add_extremes(point, ATTITUDE, CHANNELS);
    if (now_.time_s > 0) {
        put(point, RATE, &now_.high[RATE]);
        put(point, FORCE, &now_.high[FORCE]);
        now_.curves.add(record.time_s - samples_.start_s, now_.low, now_.high, point);
        now_.has_point = false;
    }
    return !is_row || keep_row(record, why);
}

bool Flight::keep_row(const sins_record &record, std::wstring &why)
{
    std::string line = (now_.next == 1 ? columns() : "") + shortest(record.time_s);
    for (const sins_record_solution *solution : {&record.truth, &record.navigation}) {
        append(line, &solution->latitude_rad);
        append(line, solution->velocity_enu_m_s);
        append(line, &solution->roll_rad);
    }
    for (const sins_record_errors *errors : {&record.navigation_errors, &record.model_errors}) {
        append(line, errors->position_enu_m);
        append(line, errors->velocity_enu_m_s);
        append(line, errors->misalignment_enu_rad);
        append(line, &errors->roll_rad);
        line += "," + std::to_string(errors->flags);
    }
    for (double *sum : {now_.angle, now_.velocity}) {
        double mean[3] = {};
        for (int k = 0; k < 3 && now_.time_s > 0; k++) {
            mean[k] = sum[k] / now_.time_s;
        }
        append(line, mean);
        std::fill(sum, sum + 3, 0.0);
    }
    now_.time_s = 0;
    return records_.add(line + "\n", why);
}

bool Flight::write_records(const std::wstring &path, std::wstring &why) const
{
    auto guard = lock();
    return records_.copy(path, why);
}

bool Flight::write_increments(const std::wstring &path, std::wstring &why) const
{
    auto guard = lock();
    return increments_.copy(path, why);
}
