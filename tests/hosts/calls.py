"""The same calls as in calls.c."""

import ctypes

import numpy
import sins

RECORDS = 5


def show(label, value):
    print(label, repr(float(value)))


name = sins.text(sins.scene_builtin_name, 1)
show(name, len(name) + 1)

flight, sim, second = sins.flight(), sins.sim(), sins.sim()
start = sins.flight_start(latitude_rad=0.7, speed_m_s=100)
straight = sins.manoeuvre(kind=sins.MANOEUVRE_STRAIGHT, duration_s=5)
roll = sins.manoeuvre(kind=sins.MANOEUVRE_ROLL, duration_s=10, turns=1)
sins.flight_create(start, (sins.manoeuvre * 2)(straight, roll), flight)
samples = sins.samples_at(flight, numpy.arange(121) / 8)

options = sins.options(scheme=sins.SCHEME_POLYNOMIAL, subsamples=3)
sins.create(options, sim)
matrix = numpy.zeros((3, 3))
matrix[0, 1] = 1e-3
matrix[2, 0] = 2e-3
gyro = sins.gyro_params(misalignment_rad=matrix)
sins.set_gyro(sim, gyro)
records, written = sins.array(sins.record, RECORDS), ctypes.c_size_t()
sins.run(sim, samples, 30, records, written)
show("written", written.value)
for record in records[: written.value]:
    show("time", record["time_s"])
    show("velocity", record["navigation_errors"]["velocity_enu_m_s"][1])
    show("misalignment", record["navigation_errors"]["misalignment_enu_rad"][2])

buffer, size = ctypes.create_string_buffer(sins.SNAPSHOT_MAX_SIZE), ctypes.c_size_t()
sins.snapshot_save(sim, buffer, size)
show("snapshot", size.value)
sins.create(options, second)
sins.snapshot_load(second, buffer[: size.value])
navigation = sins.navigation()
sins.get_navigation(second, navigation)
show("quaternion", navigation.quaternion_nb[3])

gyro.misalignment_rad[7] = 2
try:
    sins.set_gyro(sim, gyro)
except sins.Error as error:
    show("refused", error.status)
    show(error.info.field.decode(), error.info.index)
