/* NAME.csv: one row per record. */

#ifndef RECORD_FILE_H
#define RECORD_FILE_H

#include "sins.h"
#include "whole_file.h"

/* Mean of measured less ideal signals over the time since the record before, sensor axes. */
struct sensor_errors {
    double gyro_rad_s[3];
    double accel_m_s2[3];
};

void record_file_header(struct whole_file *file);
void record_file_row(struct whole_file *file, const sins_record *record, const struct sensor_errors *sensors);

#endif
