#include "record_file.h"

void record_file_header(struct whole_file *file)
{
    fputs("time_s,"
          "truth_latitude_rad,truth_longitude_rad,truth_height_m,"
          "truth_velocity_east_m_s,truth_velocity_north_m_s,truth_velocity_up_m_s,"
          "truth_roll_rad,truth_pitch_rad,truth_heading_rad,"
          "nav_latitude_rad,nav_longitude_rad,nav_height_m,"
          "nav_velocity_east_m_s,nav_velocity_north_m_s,nav_velocity_up_m_s,"
          "nav_roll_rad,nav_pitch_rad,nav_heading_rad,"
          "error2_position_east_m,error2_position_north_m,error2_position_up_m,"
          "error2_velocity_east_m_s,error2_velocity_north_m_s,error2_velocity_up_m_s,"
          "error2_misalignment_east_rad,error2_misalignment_north_rad,error2_misalignment_up_rad,"
          "error2_roll_rad,error2_pitch_rad,error2_heading_rad,error2_flags,"
          "error1_position_east_m,error1_position_north_m,error1_position_up_m,"
          "error1_velocity_east_m_s,error1_velocity_north_m_s,error1_velocity_up_m_s,"
          "error1_misalignment_east_rad,error1_misalignment_north_rad,error1_misalignment_up_rad,"
          "error1_roll_rad,error1_pitch_rad,error1_heading_rad,error1_flags,"
          "gyro_error_x_rad_s,gyro_error_y_rad_s,gyro_error_z_rad_s,"
          "accel_error_x_m_s2,accel_error_y_m_s2,accel_error_z_m_s2\n",
          file->stream);
}

static void numbers(FILE *stream, const double *values, size_t count)
{
    size_t i;

    for (i = 0; i < count; i++) {
        fprintf(stream, ",%.17g", values[i]);
    }
}

static void solution_fields(FILE *stream, const sins_record_solution *solution)
{
    numbers(stream, &solution->latitude_rad, 1);
    numbers(stream, &solution->longitude_rad, 1);
    numbers(stream, &solution->height_m, 1);
    numbers(stream, solution->velocity_enu_m_s, 3);
    numbers(stream, &solution->roll_rad, 1);
    numbers(stream, &solution->pitch_rad, 1);
    numbers(stream, &solution->heading_rad, 1);
}

static void error_fields(FILE *stream, const sins_record_errors *errors)
{
    numbers(stream, errors->position_enu_m, 3);
    numbers(stream, errors->velocity_enu_m_s, 3);
    numbers(stream, errors->misalignment_enu_rad, 3);
    numbers(stream, &errors->roll_rad, 1);
    numbers(stream, &errors->pitch_rad, 1);
    numbers(stream, &errors->heading_rad, 1);
    fprintf(stream, ",%d", (int)errors->flags);
}

void record_file_row(struct whole_file *file, const sins_record *record, const struct sensor_errors *sensors)
{
    fprintf(file->stream, "%.17g", record->time_s);
    solution_fields(file->stream, &record->truth);
    solution_fields(file->stream, &record->navigation);
    error_fields(file->stream, &record->navigation_errors);
    error_fields(file->stream, &record->model_errors);
    numbers(file->stream, sensors->gyro_rad_s, 3);
    numbers(file->stream, sensors->accel_m_s2, 3);
    fputc('\n', file->stream);
}
