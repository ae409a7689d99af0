/* What is kept of a flight: points of its curves, and the records of its file. */
#include <cmath>

#include "flight.h"

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
