#!/usr/bin/env python3
"""The flights of c_examples/gnss_filter.c with the feedback filter of pyins (PyPI: python-ins), on the same increments and fixes:

    benches/gnss_pyins.py LOG.csv [RUNS]      prints what gnss_filter prints, and the time of the filter alone
"""

import sys
import time

import numpy
import pandas
from sins import c as sins
from pyins import filters, inertial_sensor, measurements

OUTAGE_S = (180, 240)
FIX_SIGMA = numpy.array([3.0, 3.0, 5.0, 0.1, 0.1, 0.1])
TO_FRD = numpy.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])  # and from east-north-up to north-east-down


class Normal:
    """The generator of gnss_filter.c."""

    def __init__(self, state):
        self.state = state

    def __call__(self):
        total = -6.0
        for _ in range(12):
            self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
            total += (self.state >> 11) / 9007199254740992.0
        return total


def simulate(log, run):
    """Increments, fixes, the start of the INS, and the standard deviations of the sensors."""
    normal = Normal(12345 + 1000003 * run)
    gyro, accel, initial = sins.gyro_params(), sins.accel_params(), sins.initial_errors()
    sins.gyro_preset(sins.GRADE_TACTICAL, gyro)
    sins.accel_preset(sins.GRADE_TACTICAL, accel)
    sigma = gyro.bias_sigma_rad_s[0], accel.bias_sigma_m_s2[0]
    noise = gyro.random_walk_rad_sqrt_s[0], accel.velocity_random_walk_m_s_sqrt_s[0]
    for i in range(3):
        initial.position_sigma_enu_m[i], initial.velocity_sigma_enu_m_s[i] = 3.0, 0.1
        initial.misalignment_sigma_enu_rad[i] = 5e-3 if i == 2 else 1e-3
        gyro.bias_rad_s[i] = sigma[0] * normal()
        accel.bias_m_s2[i] = sigma[1] * normal()
        gyro.bias_sigma_rad_s[i] = accel.bias_sigma_m_s2[i] = 0.0
    options, navigation, imu = sins.options(), sins.navigation(), sins.imu()
    options.vertical, options.run = sins.VERTICAL_FREE, run
    increments, fixes = [], []
    with sins.sim() as sim:
        sins.create(options, sim)
        sins.set_gyro(sim, gyro)
        sins.set_accel(sim, accel)
        sins.set_initial_errors(sim, initial)
        for k, row in enumerate(log):
            sample = sins.flight_sample()
            sample.time_s, sample.latitude_rad, sample.longitude_rad, sample.height_m = row[:4]
            sample.velocity_enu_m_s[:] = row[4:7]
            sample.roll_rad, sample.pitch_rad, sample.heading_rad = row[7:10]
            sins.push_sample(sim, sample)
            sins.step(sim)
            if k == 0:
                sins.get_navigation(sim, navigation)
                continue
            sins.get_imu(sim, imu)
            angle, velocity = TO_FRD @ imu.measured_angle_rad[:], TO_FRD @ imu.measured_velocity_m_s[:]
            increments.append([row[0], imu.interval_s, *angle, *velocity])
            if k % 100 == 0 and not OUTAGE_S[0] < k // 100 <= OUTAGE_S[1]:
                error = FIX_SIGMA * [normal() for _ in range(6)]
                north, east = 6.3674e6 + row[3], (6.388e6 + row[3]) * numpy.cos(row[1])
                place = row[1] + error[1] / north, row[2] + error[0] / east
                fixes.append([row[0], *numpy.degrees(place), row[3] + error[2], *(TO_FRD @ (row[4:7] + error[3:]))])
    return increments, fixes, navigation, sigma, noise


def fly(log, run):
    """Position error east and north, and its predicted variance, each second; the time of the filter."""
    increments, fixes, start, sigma, noise = simulate(log, run)
    names = ["lat", "lon", "alt", "VN", "VE", "VD", "roll", "pitch", "heading"]
    angles = numpy.degrees([start.latitude_rad, start.longitude_rad, start.roll_rad, start.pitch_rad, start.heading_rad])
    velocity = TO_FRD @ start.velocity_enu_m_s[:]
    pva = pandas.Series([*angles[:2], start.height_m, *velocity, *angles[2:]], index=names, name=log[0][0])
    columns = ["dt", "theta_x", "theta_y", "theta_z", "dv_x", "dv_y", "dv_z"]
    table = numpy.array(increments)
    increments = pandas.DataFrame(table[:, 1:], index=table[:, 0], columns=columns)
    table = numpy.array(fixes)
    fixes = pandas.DataFrame(table[:, 1:], index=table[:, 0], columns=names[:6])
    position, speed = measurements.Position(fixes, 3.0), measurements.NedVelocity(fixes, 0.1)
    position.R = numpy.diag(FIX_SIGMA[:3] ** 2)
    models = [inertial_sensor.EstimationModel(bias_sd=bias, noise=walk) for bias, walk in zip(sigma, noise)]
    begin = time.perf_counter()
    found = filters.run_feedback_filter(pva, 3.0, 0.1, numpy.degrees(1e-3), numpy.degrees(5e-3), increments, *models,
                                        measurements=[position, speed])
    took_s = time.perf_counter() - begin
    seconds = log[100::100]
    there = found.trajectory.iloc[100::100]
    north = (numpy.radians(there.lat.values) - seconds[:, 1]) * (6.3674e6 + seconds[:, 3])
    east = (numpy.radians(there.lon.values) - seconds[:, 2]) * (6.388e6 + seconds[:, 3]) * numpy.cos(seconds[:, 1])
    sd = found.trajectory_sd[["north", "east"]]
    variance = numpy.interp(seconds[:, 0], sd.index, (sd.values**2).sum(axis=1))
    return north**2 + east**2, variance, took_s


def main():
    log = numpy.genfromtxt(sys.argv[1], delimiter=",", skip_header=3)
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    errors, variances, times_s = zip(*(fly(log, run) for run in range(runs)))
    error, variance = numpy.mean(errors, axis=0), numpy.mean(variances, axis=0)
    fixed, end = slice(0, OUTAGE_S[0]), OUTAGE_S[1] - 1
    ratio = numpy.sqrt(error[fixed].mean() / variance[fixed].mean())
    print(f"{runs} runs of pyins: horizontal position, rms error / predicted: {ratio:.4f}; {error[fixed].mean()**0.5:.2f} m")
    print(f"after 60 s without fixes: {error[end]**0.5:.2f} m, predicted {variance[end]**0.5:.2f} m")
    print(f"time of a run: {min(times_s):.2f} s")


main()
