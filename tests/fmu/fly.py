"""The unit in FMPy: fly.py UNIT.fmu FOLDER SINS, where SINS is the program sins. The last line reports what was checked."""

import csv
import math
import re
import resource
import subprocess
import sys
from pathlib import Path

import fmpy
from fmpy import calloc, free
from fmpy.fmi2 import (FMU2Slave, fmi2CallbackAllocateMemoryTYPE, fmi2CallbackFreeMemoryTYPE, fmi2CallbackFunctions,
                       fmi2CallbackLoggerTYPE)
from fmpy.validation import validate_fmu

FMU, FOLDER, SINS = sys.argv[1], Path(sys.argv[2]).resolve(), sys.argv[3]
checks = 0


def check(good, what):
    """Stops with `what` unless `good`."""
    global checks
    checks += 1
    if not good:
        sys.exit(f"failed: {what}")


description = fmpy.read_model_description(FMU, validate=True)  # with the schema of the standard
problems = validate_fmu(FMU)
check(not problems, f"the validator finds: {problems}")
REFERENCE = {variable.name: variable.valueReference for variable in description.modelVariables}
UNPACKED = fmpy.extract(FMU, unzipdir=str(FOLDER / "unpacked"))

MESSAGES = []


def log(_environment, _name, status, category, message):
    MESSAGES.append((status, category.decode(), message.decode()))


CALLBACKS = fmi2CallbackFunctions(
    logger=fmi2CallbackLoggerTYPE(log), allocateMemory=fmi2CallbackAllocateMemoryTYPE(calloc),
    freeMemory=fmi2CallbackFreeMemoryTYPE(free))


class Unit:
    """An instance in its initialization, with its texts, integers and reals set."""

    def __init__(self, **parameters):
        self.slave = FMU2Slave(guid=description.guid, unzipDirectory=UNPACKED,
                               modelIdentifier=description.coSimulation.modelIdentifier, instanceName="sins")
        self.slave.instantiate(callbacks=CALLBACKS)
        self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()
        for name, value in parameters.items():
            name = name.replace("__", ".")
            put = {str: self.slave.setString, int: self.slave.setInteger, float: self.slave.setReal}[type(value)]
            put([REFERENCE[name]], [value])

    def start(self):
        """Ends the initialization and returns the status."""
        return self.status(self.slave.exitInitializationMode)

    @classmethod
    def flying(cls, **parameters):
        unit = cls(**parameters)
        check(unit.start() == 0, f"the initialization: {MESSAGES[-1:]}")
        return unit

    def step(self, sample, length_s=0.0):
        """Sets the sample of a row of a log, makes the step from its time, and returns the status."""
        self.slave.setReal(INPUT_REFERENCES, sample[1:])
        return self.status(lambda: self.slave.doStep(currentCommunicationPoint=sample[0],
                                                     communicationStepSize=length_s))

    def status(self, call):
        """The status of a call: 0, or the status of the error."""
        try:
            return call() or 0
        except fmpy.fmi1.FMICallException as error:
            return error.status

    def read(self, names):
        return self.slave.getReal([REFERENCE[name] for name in names])

    def free(self):
        self.slave.freeInstance()


INPUTS = [f"truth.{name}" for name in ("latitude_rad", "longitude_rad", "height_m", "velocity_east_m_s",
                                       "velocity_north_m_s", "velocity_up_m_s", "roll_rad", "pitch_rad", "heading_rad")]
INPUT_REFERENCES = [REFERENCE[name] for name in INPUTS]
# Names in the program's records and in the unit.
COLUMNS = {"time_s": "time_of_solution_s"}
for angle in ("latitude_rad", "longitude_rad", "height_m", "velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s",
              "roll_rad", "pitch_rad", "heading_rad"):
    COLUMNS[f"navigation_{angle}"] = f"navigation.{angle}"
for kind, unit in (("position", "m"), ("velocity", "m_s"), ("misalignment", "rad")):
    for axis in ("east", "north", "up"):
        COLUMNS[f"navigation_error_{kind}_{axis}_{unit}"] = f"errors.{kind}_{axis}_{unit}"
        COLUMNS[f"model_error_{kind}_{axis}_{unit}"] = f"model_errors.{kind}_{axis}_{unit}"


def samples(path):
    with open(path) as log_file:
        rows = csv.reader(line for line in log_file if not line.startswith("#"))
        next(rows)
        return [[float(value) for value in row] for row in rows]


def flown(name, scene, log_path, *settings):
    """The program's records of every sample."""
    subprocess.run([SINS, "fly", scene, "--log", log_path, "--out", str(FOLDER), "--name", name, "--force", "--quiet",
                    *settings], check=True)
    with open(FOLDER / f"{name}.csv") as records:
        return [{column: float(row[column]) for column in COLUMNS} for row in csv.DictReader(records)]


def same_flight(unit, truth, records):
    """Flies `truth` and compares each record with the outputs of its time, to the bit."""
    by_time = {record["time_s"]: record for record in records}
    compared = 0
    for sample in truth:
        check(unit.step(sample) == 0, f"the sample at {sample[0]} s: {MESSAGES[-1:]}")
        values = unit.read(COLUMNS.values())
        check(values[0] == sample[0], "the outputs belong to the sample")
        record = by_time.get(sample[0])
        if record is not None:
            compared += 1
            check(list(record.values()) == values, f"the record at {sample[0]} s")
    check(compared == len(records) and compared > len(truth) / 2, f"{compared} of {len(records)} records compared")
    return compared


# Both flights equal those of the program, in every record.
AIRLINER, FIGHTER = "c_examples/flights/airliner_cruise.csv", "c_examples/flights/fighter_aerobatics.csv"
AT_REST = dict.fromkeys(INPUTS, 0.0)
truth = {path: samples(path) for path in (AIRLINER, FIGHTER)}
fighter = Unit.flying(scene_file="fighter.toml")
compared = same_flight(fighter, truth[FIGHTER],
                       flown("fighter", "c_examples/scenes/fighter.toml", FIGHTER, "--set", "output.every_s=0.01"))
# Another instance at the same time, with parameters instead of a scene.
airliner = Unit.flying(**{"gyro.preset": 3, "accelerometer.preset": 3, "options.error_model": 2, "gyro.bias_deg_h[2]": 0.02,
                   "options.seed": 7})
Path(FOLDER / "airliner.toml").write_text('[flight]\nfile = "log.csv"\n')
compared += same_flight(airliner, truth[AIRLINER],
                        flown("airliner", str(FOLDER / "airliner.toml"), AIRLINER, "--set", "output.every_s=0.02",
                              *(word for setting in ("gyro.preset=navigation", "accelerometer.preset=navigation",
                                                     "options.error_model=rk4", "gyro.bias_deg_h=[0,0.02,0]", "options.seed=7")
                                for word in ("--set", setting))))
print(f"{compared} records equal to the program's, to the bit")
fighter.free()
airliner.free()

# States: set back, through bytes, and into another instance.
flight = truth[FIGHTER]
unit = Unit.flying(scene_file="fighter.toml")
for sample in flight[:3000]:
    unit.step(sample)
state = unit.slave.getFMUstate()
image = unit.slave.serializeFMUstate(state)
for sample in flight[3000:4000]:
    unit.step(sample)
end = unit.read(COLUMNS.values())
for how in ("set", "serialized", "another instance"):
    if how == "set":
        unit.slave.setFMUstate(state)
    else:
        if how == "another instance":
            unit.free()
            unit = Unit.flying(scene_file="fighter.toml")
        unit.slave.setFMUstate(unit.slave.deSerializeFMUstate(image))
    for sample in flight[3000:4000]:
        check(unit.step(sample) == 0, f"a step behind a state ({how})")
    check(unit.read(COLUMNS.values()) == end, f"the same bits behind a state ({how})")
in_snapshot = len(image) - 100
for damaged in (image[:-1], image[:5000], b"", b"SINSFMU2", image[:in_snapshot] + bytes([image[in_snapshot] ^ 1]) + image[in_snapshot + 1:]):
    said = len(MESSAGES)
    refused = unit.status(lambda: unit.slave.deSerializeFMUstate(damaged))
    check(refused == 3 and len(MESSAGES) == said + 1, f"a damaged state of {len(damaged)} bytes is refused by one sentence")
unit.free()

# Tunable parameters and failures, set in flight.
unit = Unit.flying()
for sample in flight[:1000]:
    unit.step(sample)
MISALIGNMENT = [f"errors.misalignment_{axis}_rad" for axis in ("east", "north", "up")]
quiet = math.hypot(*unit.read(MISALIGNMENT))
unit.slave.setReal([REFERENCE["gyro.bias_deg_h[1]"]], [3600.0])
for sample in flight[1000:1200]:
    unit.step(sample)
loud = math.hypot(*unit.read(MISALIGNMENT))
check(abs(loud / math.radians(2.0) - 1.0) < 0.02, f"1 deg/s for 2 s, set in flight: {quiet} {loud} rad")
unit.slave.setReal([REFERENCE["gyro.bias_deg_h[1]"]], [0.0])
for name, value in (("failure[1].sensor", 1), ("failure[1].axis", 3), ("failure[1].kind", 3)):
    unit.slave.setInteger([REFERENCE[name]], [value])
for sample in flight[1200:1300]:
    unit.step(sample)
check(unit.slave.getBoolean([REFERENCE["flags.gyro_invalid"]])[0] or
      unit.read(["imu.delta_angle_rad[3]"])[0] == 0.0, "a gyro that fails in flight shows")
unit.free()

# Bad inputs: each has a status and one sentence, and changes nothing.
unit = Unit.flying()
bad = len(MESSAGES)
unit.slave.setReal(INPUT_REFERENCES[:2], flight[0][1:3])
check(unit.status(lambda: unit.slave.doStep(0.0, 0.01)) == 3, "unconnected truth is an error")
check("is not connected" in MESSAGES[-1][2] and len(MESSAGES) == bad + 1, f"by one sentence: {MESSAGES[bad:]}")
for sample in flight[:100]:
    check(unit.step(sample) == 0, "the flight begins")
before = unit.read(COLUMNS.values())
for field, value, word in ((3, math.nan, "height_m"), (1, 4.0, "latitude_rad"), (1, flight[100][1] + 1.0, "truth jumped"),
                           (0, -5.0, "time")):
    sample = list(flight[100])
    sample[field] = value
    bad = len(MESSAGES)
    check(unit.step(sample) == 3, f"{word} = {value} is an error")
    check(len(MESSAGES) == bad + 1, f"by one sentence: {MESSAGES[bad:]}")
    check(unit.read(COLUMNS.values()) == before, "and nothing has changed")
check(unit.step(flight[100]) == 0, "the flight goes on")
check(unit.step(flight[100]) == 0, "a step from the same time changes nothing")
moved = list(flight[100])
moved[3] += 1.0
check(unit.step(moved) == 3, "but not with other inputs")
check(unit.status(lambda: unit.slave.setReal([REFERENCE["gyro.bias_deg_h[1]"]], [1e300])) == 2, "a bias beyond its range")
check("gyro.bias" in MESSAGES[-1][2], f"its sentence: {MESSAGES[-1]}")
check(unit.status(lambda: unit.slave.setReal([99999], [1.0])) == 3, "an unknown reference")
check(unit.status(lambda: unit.slave.setReal([REFERENCE["errors.position_east_m"]], [1.0])) == 3, "an output set")
unit.free()
for parameter, value in (("scene_file", "missing.toml"), ("scene_file", "../modelDescription.xml"),
                         ("scene_file", "Zoë 飞行.toml"), ("scene_text", "[gyro]\nbais_deg_h = 1\n"),
                         ("scene_builtin", "nothing"), ("options.subsamples", 99), ("gyro.bias_deg_h[1]", math.nan)):
    unit = Unit(**{parameter: value})
    bad = len(MESSAGES)
    check(unit.start() == 3, f"{parameter} = {value!r} is refused")
    check(len(MESSAGES) == bad + 1 and re.search(parameter.split(".")[-1].split("[")[0] + "|bais", MESSAGES[-1][2]),
          f"by one sentence that names it: {MESSAGES[bad:]}")
    unit.free()

# What everybody tries first ends at once: a discarded step is repeated by FMPy for ever.
for what, options in (("no inputs", {"stop_time": 10}), ("a step of 5 s", {"stop_time": 10, "output_interval": 5, "start_values": AT_REST})):
    bad = len(MESSAGES)
    try:
        fmpy.simulate_fmu(FMU, logger=log, **options)
    except fmpy.fmi1.FMICallException as error:
        check(error.status == 3 and len(MESSAGES) == bad + 1, f"{what}: one error: {MESSAGES[bad:]}")
    else:
        check(False, f"{what}: an error")

# Many instances in sequence leave no memory.
def many(count):
    for _ in range(count):
        unit = Unit.flying(scene_file="fighter.toml")
        unit.step(flight[0])
        unit.free()
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


first = many(300)
grown = many(1000) - first
check(grown < 2000, f"1000 instances grew the process by {grown} KB")
print(f"{checks} checks passed; 1000 instances: {grown} KB")
