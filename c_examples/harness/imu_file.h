/* The log of the IMU: one row per sample interval. */

#ifndef IMU_FILE_H
#define IMU_FILE_H

#include "sins.h"
#include "whole_file.h"

void imu_file_header(struct whole_file *file);

/* The time is that of the end of the interval. */
void imu_file_row(struct whole_file *file, const sins_imu *imu);

#endif
