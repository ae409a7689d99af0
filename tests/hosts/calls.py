"""The same calls as in calls.c."""

import numpy
from sins import c as sins

RECORDS = 5


def show(label, value):
    print(label, repr(float(value)))


name = sins.scene_builtin_name(1)
show(name, len(name) + 1)

start = sins.flight_start(latitude_rad=0.7, speed_m_s=100)
straight = sins.manoeuvre(kind=sins.MANOEUVRE_STRAIGHT, duration_s=5)
roll = sins.manoeuvre(kind=sins.MANOEUVRE_ROLL, duration_s=10, turns=1)
flight = sins.flight_create(start, [straight, roll])
samples = sins.samples_at(flight, numpy.arange(121) / 8)

options = sins.options(scheme=sins.SCHEME_POLYNOMIAL, subsamples=3)
sim = sins.create(options)
matrix = numpy.zeros((3, 3))
matrix[0, 1] = 1e-3
matrix[2, 0] = 2e-3
gyro = sins.gyro_params(misalignment_rad=matrix)
sins.set_gyro(sim, gyro)
records = sins.array(sins.record, RECORDS)
written = sins.run(sim, samples, 30, records)
show("written", written)
for record in records[:written]:
    show("time", record["time_s"])
    show("velocity", record["navigation_errors"]["velocity_enu_m_s"][1])
    show("misalignment", record["navigation_errors"]["misalignment_enu_rad"][2])

saved = sins.snapshot(sim)
show("snapshot", len(saved))
second = sins.create(options)
sins.snapshot_load(second, saved)
show("quaternion", sins.get_navigation(second).quaternion_nb[3])

gyro.misalignment_rad[7] = 2
try:
    sins.set_gyro(sim, gyro)
except sins.Error as error:
    show("refused", error.status)
    show(error.info.field.decode(), error.info.index)
