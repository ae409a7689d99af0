#include "imu_file.h"

void imu_file_header(struct whole_file *file)
{
    fputs("time_s,angle_increment_x_rad,angle_increment_y_rad,angle_increment_z_rad,"
          "velocity_increment_x_m_s,velocity_increment_y_m_s,velocity_increment_z_m_s\n",
          file->stream);
}

void imu_file_row(struct whole_file *file, const sins_imu *imu)
{
    int axis;

    fprintf(file->stream, "%.17g", imu->time_s);
    for (axis = 0; axis < 3; axis++) {
        fprintf(file->stream, ",%.17g", imu->measured_angle_rad[axis]);
    }
    for (axis = 0; axis < 3; axis++) {
        fprintf(file->stream, ",%.17g", imu->measured_velocity_m_s[axis]);
    }
    fputc('\n', file->stream);
}
