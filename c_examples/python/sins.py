"""sins.h for Python 3.9 and later, by ctypes: nothing is compiled.

    import sins

    gyro = sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0))    # what is not named is 0: off
    errors = sins.errors()
    with sins.sim() as sim:                                                # destroyed at the end
        sins.create(None, sim)
        sins.set_gyro(sim, gyro)
        for second in range(3601):
            sins.push_sample(sim, sins.flight_sample(time_s=second, latitude_rad=39.9 * sins.DEG))
            sins.step(sim)
        sins.get_errors(sim, sins.ERRORS_NAVIGATION, errors)
    print(errors.position_enu_m[0], errors.position_enu_m[1])

sins_create() of the header is sins.create() here, and SINS_DEG is sins.DEG: names, arguments and their order are those of the
header, but for the number of elements behind an array, which Python knows. NULL is None. An output is an object that the call
fills: a struct, a handle, or a number as ctypes.c_size_t(). A text is str or bytes, in a struct bytes. A status below 0 is raised
as sins.Error; the others are returned. Whole numbers that are too large for their type in C are cut, as everywhere in ctypes.

An array is one of ctypes, or of numpy: sins.array(sins.record, 1000). The library works in the memory of both; nothing is copied.

The library is the file that SINS_LIBRARY in the environment names, or else lies beside this file, or is the system's.

This file is written by build.rs from the Rust sources; do not edit it.
"""

import ctypes
import enum
import functools
import os
import sys
from ctypes import POINTER, c_char, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64

# Version of the interface that this header declares: a host compares it with what sins.abi_version() gives. It changes when
# something that was there is gone or means something else; what is added at the end does not change it.
HEADER_ABI = 1
# Release of the library, semantic versioning.
VERSION_MAJOR = 0
# See sins.VERSION_MAJOR.
VERSION_MINOR = 1
# See sins.VERSION_MAJOR.
VERSION_PATCH = 0
# A buffer of this size holds every snapshot that this release saves. For a library newer than this header ask
# sins.snapshot_size().
SNAPSHOT_MAX_SIZE = 8192
DEG = 0.017453292519943295  # degree [rad]
ARCMIN = 0.0002908882086657216  # minute of arc [rad]
ARCSEC = 4.84813681109536e-6  # second of arc [rad]
DEG_PER_HOUR = 4.84813681109536e-6  # degree an hour [rad/s]
DEG_PER_SQRT_HOUR = 0.0002908882086657216  # degree a root hour, angle random walk [rad/sqrt(s)]
STANDARD_GRAVITY = 9.80665  # g [m/s2]
MICRO_G = 9.806649999999999e-6  # millionth of g [m/s2]
MICRO_G_PER_SQRT_HZ = 9.806649999999999e-6  # white noise of force [(m/s)/sqrt(s)]
PPM = 1e-6  # part in a million
KNOT = 0.5144444444444445  # knot [m/s]
NMI = 1852.0  # nautical mile [m]
NMI_PER_HOUR = 0.5144444444444445  # nautical mile an hour [m/s]


def _load():
    """The library, of the version of the interface that this file is for."""
    beside = os.path.dirname(os.path.abspath(__file__))
    names = {"win32": ["sins.dll"], "darwin": ["libsins.dylib"]}
    names = names.get(sys.platform, [f"libsins.so.{HEADER_ABI}", "libsins.so"])
    found = [path for path in (os.path.join(beside, name) for name in names) if os.path.exists(path)]
    path = os.environ.get("SINS_LIBRARY") or (found + names)[0]
    try:
        library = ctypes.CDLL(path)
        version = library.sins_abi_version()
    except OSError as error:
        raise ImportError(
            f"the library sins cannot be loaded: {error}. Put {names[-1]} of {8 * ctypes.sizeof(ctypes.c_void_p)} bits, "
            f"as this Python has, beside {__file__}, or set SINS_LIBRARY to its path"
        ) from None
    except AttributeError:
        raise ImportError(f"{path} is not the library sins: it has no sins_abi_version()") from None
    if version != HEADER_ABI:
        raise ImportError(
            f"{path} has version {version} of the interface, {__file__} is for version {HEADER_ABI}: "
            "take both from one release"
        )
    return library


_library = _load()


class Error(Exception):
    """A call that failed: its status, the library's sentence, and in info what that is made of."""

    def __init__(self, status, sentence, info):
        super().__init__(sentence)
        self.status = status_code(status)
        self.info = info


def _exported(enumeration):
    """Makes sins.frame.FRAME_GEOGRAPHIC known as sins.FRAME_GEOGRAPHIC, as in C."""
    globals().update(enumeration.__members__)
    return enumeration


class _Struct(ctypes.Structure):
    """All zero but for the fields that are named, and struct_size, which is set."""

    __slots__ = ()  # a field that does not exist is an error

    def __init__(self, **fields):
        super().__init__(**fields)
        if hasattr(self, "struct_size"):
            self.struct_size = ctypes.sizeof(self)

    def __setattr__(self, name, value):
        given = value
        if getattr(value, "ndim", 0):  # an array of numpy; a matrix row by row
            value = tuple(value.ravel())
        try:
            super().__setattr__(name, value)
        except (IndexError, RuntimeError, TypeError) as error:
            raise TypeError(f"{type(self).__name__}.{name} = {given!r}: {error}") from None

    def __repr__(self):
        def shown(value):
            return list(value) if isinstance(value, ctypes.Array) else value

        fields = (f"{name}={shown(getattr(self, name))!r}" for name, _ in self._fields_)
        return f"sins.{type(self).__name__}({', '.join(fields)})"


class _Handle(ctypes.c_void_p):
    """Stands for nothing until a call creates it. Destroyed by close(), at the end of a with statement, or when it is dropped."""

    def close(self):
        if self:
            getattr(_library, self._destroy)(self)
            self.value = None

    __del__ = close

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


@_exported
class status_code(enum.IntEnum):
    """Values of a sins.status: 0, positive an answer of another kind, negative an error.

    OK: The call did what it says.
    NEED_SAMPLE: There is no complete interval yet: push the next sample.
    REQUIREMENT_NOT_MET: No options meet the requirement; the outputs tell the best there are.
    SCENE_HAS_FAULTS: The text of a scene has faults: the handle was made, for sins.scene_get_fault() alone.
    GAP: The sample was taken, or all samples of the run were flown, but there is a gap: an interval of more than
        2.5 times each of the two before it. It is flown as motion, the velocity times its length: 213 m for 1 s at
        213 m/s. If the host's clock ran on while the vehicle stood still, that is wrong: see sins.move_time().
    ERROR_NULL_POINTER: A pointer that must not be null is.
    ERROR_BAD_HANDLE: The handle is null, made up, destroyed, or of another kind.
    ERROR_STRUCT_SIZE: A struct_size that no release knows, or a struct of a newer release that uses what this one
        lacks.
    ERROR_INVALID_ARGUMENT: A value out of its range; sins.last_error() names field, value and limit.
    ERROR_BAD_STATE: The right call at the wrong moment, or on a handle that this thread is inside or that is held
        for ever (see Threads).
    ERROR_TIME_ORDER: A sample that is not later than the one before, or off the stated sample period.
    ERROR_DISCONTINUITY: Truth jumped: a gap, a teleport, half a turn between two samples. See sins.move_truth().
    ERROR_QUEUE_FULL: The queue of samples is full: step first.
    ERROR_DIVERGED: The solution left its representable range; the last good one stays readable.
    ERROR_SINGULAR: The geographic mechanization came within reach of a pole.
    ERROR_BUFFER_TOO_SMALL: A buffer is too small for the result.
    ERROR_OUT_OF_MEMORY: No memory, or no free handle; on Windows too few TLS indexes (see Unloading).
    ERROR_SNAPSHOT: The snapshot is damaged, foreign or newer.
    ERROR_INTERNAL: A defect inside the library was caught; this handle answers so from now on, others live.
    """

    OK = 0
    NEED_SAMPLE = 1
    REQUIREMENT_NOT_MET = 2
    SCENE_HAS_FAULTS = 3
    GAP = 4
    ERROR_NULL_POINTER = -1
    ERROR_BAD_HANDLE = -2
    ERROR_STRUCT_SIZE = -3
    ERROR_INVALID_ARGUMENT = -4
    ERROR_BAD_STATE = -5
    ERROR_TIME_ORDER = -6
    ERROR_DISCONTINUITY = -7
    ERROR_QUEUE_FULL = -8
    ERROR_DIVERGED = -9
    ERROR_SINGULAR = -10
    ERROR_BUFFER_TOO_SMALL = -11
    ERROR_OUT_OF_MEMORY = -12
    ERROR_SNAPSHOT = -13
    ERROR_INTERNAL = -99


@_exported
class frame(enum.IntEnum):
    """Axes in which the mechanization integrates.

    FRAME_EARTH_FIXED: Navigation in Earth-fixed axes: regular everywhere, poles included.
    FRAME_GEOGRAPHIC: Navigation in east-north-up, as in the paper; sins.ERROR_SINGULAR within 6.4 km of a pole,
        and where an update moves by more than 1 % of the distance to it: 25 km at 250 m/s and updates of 1 s.
    """

    FRAME_EARTH_FIXED = 0
    FRAME_GEOGRAPHIC = 1


@_exported
class scheme(enum.IntEnum):
    """Algorithms of the mechanization.

    SCHEME_EXACT: Coning, sculling and exact rotation compensation, Earth terms of the middle of the update.
    SCHEME_PAPER: The paper's equations (7)-(24), misprints mended, approximations kept.
    SCHEME_POLYNOMIAL: As sins.SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large
        rotations within an update.
    """

    SCHEME_EXACT = 0
    SCHEME_PAPER = 1
    SCHEME_POLYNOMIAL = 2


@_exported
class vertical(enum.IntEnum):
    """What holds the vertical channel.

    VERTICAL_DAMPED: Third-order loop on a barometric height, time constant 100 s. Its response is that of the
        continuous loop to second order in the interval: to 3.5e-5 at 1 Hz, 3.5e-7 at 10 Hz.
    VERTICAL_FOLLOW_TRUTH: Height and vertical velocity set to the truth at each sample.
    VERTICAL_FREE: Left to itself: any error grows by e every 569 s.
    """

    VERTICAL_DAMPED = 0
    VERTICAL_FOLLOW_TRUTH = 1
    VERTICAL_FREE = 2


@_exported
class error_model(enum.IntEnum):
    """Whether the error differential equations are integrated.

    ERROR_MODEL_OFF: No error differential equations: sins.ERRORS_MODEL is not available.
    ERROR_MODEL_RK4: The error differential equations (error data 1) by fourth-order Runge-Kutta.
    """

    ERROR_MODEL_OFF = 0
    ERROR_MODEL_RK4 = 1


@_exported
class summary(enum.IntEnum):
    """Whether the motion of the truth is summed up.

    SUMMARY_OFF: sins.get_truth_summary() is not available.
    SUMMARY_ON: The motion of the truth is summed up; the other outputs have the same bits.
    """

    SUMMARY_OFF = 0
    SUMMARY_ON = 1


@_exported
class earth(enum.IntEnum):
    """Ellipsoids.

    EARTH_WGS84: World Geodetic System 1984.
    EARTH_CGCS2000: China Geodetic Coordinate System 2000.
    EARTH_GRS80: Geodetic Reference System 1980.
    EARTH_KRASSOVSKY1940: Krassovsky 1940; Earth rate and gravitational constant as WGS-84.
    """

    EARTH_WGS84 = 0
    EARTH_CGCS2000 = 1
    EARTH_GRS80 = 2
    EARTH_KRASSOVSKY1940 = 3


@_exported
class gravity(enum.IntEnum):
    """Formulas of normal gravity.

    GRAVITY_NORMAL: Normal gravity in closed form at any height, with its north component.
    GRAVITY_SOMIGLIANA: Somigliana's formula with the second-order height term, along the ellipsoid normal, as
        most tools have it.
    """

    GRAVITY_NORMAL = 0
    GRAVITY_SOMIGLIANA = 1


@_exported
class axes(enum.IntEnum):
    """Directions of the sensor axes.

    AXES_RIGHT_FORWARD_UP: Sensor axes: x right, y forward, z up (the paper's).
    AXES_FORWARD_RIGHT_DOWN: Sensor axes: x forward, y right, z down.
    """

    AXES_RIGHT_FORWARD_UP = 0
    AXES_FORWARD_RIGHT_DOWN = 1


@_exported
class signal(enum.IntEnum):
    """Ideal signals.

    SIGNAL_PHYSICAL: Ideal signals are the integrals of the physics, so that the mechanization's own error shows.
    SIGNAL_CLOSED_LOOP: The same with a small trim that holds an error-free navigator to the truth over any time,
        the free vertical channel too: for hosts that want nothing but the sensors' errors. sins.accuracy tells how
        large it was. Where no sensor errs, that navigator is the simulator's own and nothing is computed twice.
    """

    SIGNAL_PHYSICAL = 0
    SIGNAL_CLOSED_LOOP = 1


@_exported
class error_info_flags(enum.IntFlag):
    """Flags of a sins.error_info.

    ERROR_INFO_VALUE: A value is at fault, and is in value.
    ERROR_INFO_MINIMUM: There is a least value, and minimum has it.
    ERROR_INFO_MAXIMUM: There is a greatest value, and maximum has it.
    ERROR_INFO_INTEGER: The field is an integer.
    """

    ERROR_INFO_VALUE = 1
    ERROR_INFO_MINIMUM = 2
    ERROR_INFO_MAXIMUM = 4
    ERROR_INFO_INTEGER = 8


@_exported
class sensor(enum.IntEnum):
    """Sensors that can fail.

    SENSOR_GYRO: The gyros.
    SENSOR_ACCEL: The accelerometers.
    SENSOR_ALTIMETER: The altimeter; its axis is 0.
    """

    SENSOR_GYRO = 0
    SENSOR_ACCEL = 1
    SENSOR_ALTIMETER = 2


@_exported
class failure_kind(enum.IntEnum):
    """Kinds of failure.

    FAILURE_NONE: None: clears the failure that there is.
    FAILURE_STUCK: The output holds the measured mean of the interval before, as sins.imu told it; without one its
        first value. Not flagged: it looks like data.
    FAILURE_DEAD: No signal. A gyro or an accelerometer gives 0, and is flagged sins.IMU_..._INVALID, as built-in
        tests do; without the altimeter the vertical channel is left to itself, flagged
        sins.NAVIGATION_VERTICAL_UNAIDED.
    FAILURE_BIAS_STEP: A bias of size more. Not flagged.
    FAILURE_SPIKES: Rectangular pulses of size, duration_s long, one each interval_s, the first at once; a sample
        of the altimeter shows their mean over its interval. Not flagged but where they saturate.
    FAILURE_NOISE: White noise of density more; of the altimeter its mean over the interval. Not flagged.
    FAILURE_DROP_OUTS: Sample intervals are lost: 0, and flagged as sins.FAILURE_DEAD. With probability each by
        itself, or with interval_s one in that time, the first at once.
    """

    FAILURE_NONE = 0
    FAILURE_STUCK = 1
    FAILURE_DEAD = 2
    FAILURE_BIAS_STEP = 3
    FAILURE_SPIKES = 4
    FAILURE_NOISE = 5
    FAILURE_DROP_OUTS = 6


@_exported
class alignment(enum.IntEnum):
    """How the INS finds its attitude at the start.

    ALIGNMENT_GIVEN: The INS starts with the true attitude, turned by the given and the drawn misalignment.
    ALIGNMENT_LEVEL_AND_GYROCOMPASS: The INS starts with the attitude that levelling and gyrocompassing at rest
        find with the sensor errors of the start, turned by the given and the drawn misalignment. Level first: the
        tilt at which the accelerometers sense no horizontal force. Then the heading at which the levelled rate of the
        gyros points north. sins.NAVIGATION_NORTH_UNKNOWN tells that they found none.
    """

    ALIGNMENT_GIVEN = 0
    ALIGNMENT_LEVEL_AND_GYROCOMPASS = 1


@_exported
class sample_flags(enum.IntFlag):
    """Flags of a sins.flight_sample.

    SAMPLE_ANGULAR_RATE: The sample carries angular_rate_rad_s.
    SAMPLE_SPECIFIC_FORCE: The sample carries specific_force_m_s2.
    SAMPLE_NO_VELOCITY: The sample has no velocity: it follows from position, with a noise of 2 to 4 position
        errors over the interval.
    SAMPLE_TEMPERATURE: The sample carries temperature_c.
    """

    SAMPLE_ANGULAR_RATE = 1
    SAMPLE_SPECIFIC_FORCE = 2
    SAMPLE_NO_VELOCITY = 4
    SAMPLE_TEMPERATURE = 8


@_exported
class navigation_flags(enum.IntFlag):
    """Flags of a sins.navigation.

    NAVIGATION_NEAR_POLE: Within 20 km of the Earth's axis: longitude and heading turn fast; at the pole they are
        undefined. Quaternion, height and the errors in metres stay right.
    NAVIGATION_VERTICAL_UNAIDED: Nothing aids the vertical channel, by the options or as the altimeter has no
        signal: any error grows by e every 569 s.
    NAVIGATION_INCONSISTENT: Truth: the displacement since the sample before contradicts the velocities by more
        than 1 % and 1 cm, added as squares.
    NAVIGATION_NORTH_UNKNOWN: The alignment at the start could not find north, so that any heading error is
        possible: the horizontal error of the levelled rates is not smaller than the Earth rate's north part (where it
        is smaller, the heading error is below 90 degrees), or the accelerometers show no force. The simulator knows
        that error. A real INS can be sure of it only where its levelled horizontal rate is more than twice the Earth
        rate's north part. The flag stays until the INS starts again.
    """

    NAVIGATION_NEAR_POLE = 1
    NAVIGATION_VERTICAL_UNAIDED = 2
    NAVIGATION_INCONSISTENT = 4
    NAVIGATION_NORTH_UNKNOWN = 8


@_exported
class errors_source(enum.IntEnum):
    """Where errors come from.

    ERRORS_NAVIGATION: Navigation minus truth: the paper's error data 2.
    ERRORS_MODEL: The error differential equations: the paper's error data 1 (sins.options.error_model).
    """

    ERRORS_NAVIGATION = 0
    ERRORS_MODEL = 1


@_exported
class errors_flags(enum.IntFlag):
    """Flags of a sins.errors.

    ERRORS_NEAR_POLE: Near a pole: longitude, heading and up misalignment, and east and north of the velocity,
        have lost their meaning.
    ERRORS_OUTSIDE_VALIDITY: Error model: misalignment above 2 degrees, displacement above 100 km or, at high
        latitude, above 3.5 % of the distance to the pole; what it drops is no longer small.
    ERRORS_NOT_COMPUTED: In a sins.record: not computed, all zero.
    """

    ERRORS_NEAR_POLE = 1
    ERRORS_OUTSIDE_VALIDITY = 2
    ERRORS_NOT_COMPUTED = 4


@_exported
class imu_flags(enum.IntFlag):
    """Flags of a sins.imu.

    IMU_GYRO_SATURATED: The mean rate of a sub-increment was beyond the range of a gyro.
    IMU_ACCEL_SATURATED: The mean force of a sub-increment was beyond the range of an accelerometer.
    IMU_GYRO_INVALID: A gyro had no signal in the interval: dead, or dropped out. The mechanization goes on with
        the 0 that it gave.
    IMU_ACCEL_INVALID: An accelerometer had none.
    """

    IMU_GYRO_SATURATED = 1
    IMU_ACCEL_SATURATED = 2
    IMU_GYRO_INVALID = 4
    IMU_ACCEL_INVALID = 8


@_exported
class grade(enum.IntEnum):
    """Grades of sensors.

    GRADE_STRATEGIC: Strategic: gyro drift 0.001 deg/h, accelerometer bias 1e-6 g (El-Sheimy and Youssef 2020,
        table 1, upper ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix
        200).
    GRADE_NAVIGATION: Navigation: Honeywell HG9900, brochure N61-1638. No accelerometer noise is stated.
    GRADE_TACTICAL: Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated.
    GRADE_INDUSTRIAL: Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D, which states no
        accelerometer noise: set your own. Its range is 125 deg/s and 8 g, its axes are off square by 0.1 deg, 1
        sigma.
    GRADE_CONSUMER: Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances
        are taken as 3 sigma.
    GRADE_PAPER_SIMULATION2: The paper's simulation 2: gyro bias 0.01 deg/h and angle random walk 0.005
        deg/sqrt(h), accelerometer bias 1e-5 g and white noise 5e-6 g, read as a density of 5e-6 g/sqrt(Hz) (1 Hz of
        bandwidth; the paper states none).
    """

    GRADE_STRATEGIC = 1
    GRADE_NAVIGATION = 2
    GRADE_TACTICAL = 3
    GRADE_INDUSTRIAL = 4
    GRADE_CONSUMER = 5
    GRADE_PAPER_SIMULATION2 = 6


@_exported
class manoeuvre_kind(enum.IntEnum):
    """Kinds of manoeuvre.

    MANOEUVRE_REST: At rest for duration_s; the speed must be 0.
    MANOEUVRE_STRAIGHT: Along a geodesic at constant speed and height for duration_s.
    MANOEUVRE_ACCELERATE: By speed_change_m_s in duration_s.
    MANOEUVRE_CLIMB: By height_change_m in duration_s, ramp_s.
    MANOEUVRE_TURN: Level coordinated turn by heading_change_rad (right positive) at bank_rad, ramp_s to roll in
        and out; the duration follows.
    MANOEUVRE_ROLL: turns whole rolls (right positive) in duration_s along a straight path.
    MANOEUVRE_LOOP: turns whole vertical loops (nose up positive) in duration_s at constant speed, ramp_s.
    MANOEUVRE_S_TURN: Course swings by heading_change_rad to both sides, turns times in duration_s, ramp_s.
    MANOEUVRE_SINUSOIDS: Sum of sinusoid_count sinusoids for duration_s, ramp_s: patrol patterns, rocking, coning,
        vibration.
    """

    MANOEUVRE_REST = 0
    MANOEUVRE_STRAIGHT = 1
    MANOEUVRE_ACCELERATE = 2
    MANOEUVRE_CLIMB = 3
    MANOEUVRE_TURN = 4
    MANOEUVRE_ROLL = 5
    MANOEUVRE_LOOP = 6
    MANOEUVRE_S_TURN = 7
    MANOEUVRE_SINUSOIDS = 8


@_exported
class channel(enum.IntEnum):
    """What a sinusoid of sins.MANOEUVRE_SINUSOIDS moves.

    CHANNEL_COURSE: The sinusoid moves the course [rad], with the bank of a coordinated turn.
    CHANNEL_CLIMB: The sinusoid moves the climb angle [rad].
    CHANNEL_SPEED: The sinusoid moves the speed [m/s].
    CHANNEL_ROLL: The sinusoid moves roll alone [rad].
    CHANNEL_PITCH: The sinusoid moves pitch alone [rad].
    CHANNEL_HEADING: The sinusoid moves heading alone [rad].
    """

    CHANNEL_COURSE = 0
    CHANNEL_CLIMB = 1
    CHANNEL_SPEED = 2
    CHANNEL_ROLL = 3
    CHANNEL_PITCH = 4
    CHANNEL_HEADING = 5


@_exported
class scene_flight(enum.IntEnum):
    """Where the flight of a scene comes from: sins.scene_setup.flight.

    SCENE_FLIGHT_MANOEUVRES: It is composed of manoeuvres.
    SCENE_FLIGHT_BUILTIN: That of a built-in scene, sins.SCENE_TEXT_BUILTIN.
    SCENE_FLIGHT_LOG: A flight log, sins.SCENE_TEXT_LOG.
    """

    SCENE_FLIGHT_MANOEUVRES = 0
    SCENE_FLIGHT_BUILTIN = 1
    SCENE_FLIGHT_LOG = 2


@_exported
class scene_text(enum.IntEnum):
    """The texts of a scene: sins.scene_get_text(), sins.scene_set_text().

    SCENE_TEXT_TITLE: The scene in words.
    SCENE_TEXT_LOG: Path of the flight log, as seen from the scene's own folder; setting it makes the flight a
        log.
    SCENE_TEXT_BUILTIN: Name of the built-in scene whose flight is flown; setting it makes the flight that.
    SCENE_TEXT_FOLDER: Folder of the files that a program writes.
    SCENE_TEXT_NAME: Base name of those files.
    SCENE_TEXT_IMU: File of the measured increments.
    """

    SCENE_TEXT_TITLE = 0
    SCENE_TEXT_LOG = 1
    SCENE_TEXT_BUILTIN = 2
    SCENE_TEXT_FOLDER = 3
    SCENE_TEXT_NAME = 4
    SCENE_TEXT_IMU = 5


@_exported
class budget_flags(enum.IntFlag):
    """Flags of a sins.budget_row.

    BUDGET_RANDOM: The row's figures are standard deviations (1 sigma) over the runs.
    BUDGET_CAN_BE_LEFT_OUT: The effect can be left out together with the others that are marked so.
    """

    BUDGET_RANDOM = 1
    BUDGET_CAN_BE_LEFT_OUT = 2


status = c_int32


class sim(_Handle):
    _destroy = "sins_destroy"


class ensemble(_Handle):
    _destroy = "sins_ensemble_destroy"


class flight(_Handle):
    _destroy = "sins_flight_destroy"


class scene(_Handle):
    _destroy = "sins_scene_destroy"


class log(_Handle):
    _destroy = "sins_log_destroy"


class options(_Struct):
    """How a simulator is made. All zero (but struct_size) is the recommended simulator.

    frame: Of enum sins.frame.
    scheme: Of enum sins.scheme.
    subsamples: Sub-increments of a mechanization update, 1 to 5; 0: 2.
    updates_per_sample: Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (see
        "Gaps" above).
    vertical: Of enum sins.vertical.
    error_model: Of enum sins.error_model.
    earth: Of enum sins.earth.
    gravity: Of enum sins.gravity.
    axes: Axes of gyros, accelerometers, quaternions and optional sample fields, of enum sins.axes.
    signal: Of enum sins.signal.
    seed: Seed of all random streams.
    run: Number of the run in an ensemble: same seed, other draws.
    closed_loop_time_s: Time constant of sins.SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0:
        30 s. Must be 0 without it.
    sample_period_s: Stated sample period [s]: sample k is then at exactly k periods from the first, time stamps
        only order and check, each within 0.4 of a period. 5e-5 to max_gap_s. 0: the samples' own time stamps.
    max_gap_s: Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Intervals of minutes are for vehicles
        at rest: those of 100 s cost 40 m in 12 h, longer ones many times that.
    max_acceleration_m_s2: Mean acceleration between two samples beyond which truth has jumped, 1e-3 to 1e6
        [m/s2]; 0: 2000 m/s2.
    truth_summary: Of enum sins.summary.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("frame", c_int32),
        ("scheme", c_int32),
        ("subsamples", c_int32),
        ("updates_per_sample", c_int32),
        ("vertical", c_int32),
        ("error_model", c_int32),
        ("earth", c_int32),
        ("gravity", c_int32),
        ("axes", c_int32),
        ("signal", c_int32),
        ("seed", c_uint64),
        ("run", c_uint64),
        ("closed_loop_time_s", c_double),
        ("sample_period_s", c_double),
        ("max_gap_s", c_double),
        ("max_acceleration_m_s2", c_double),
        ("truth_summary", c_int32),
        ("reserved2", c_uint32),
    ]


class flight_sample(_Struct):
    """True motion of the vehicle at an instant, as a flight simulator gives it. Velocity is trusted most: the ideal
    signals are made of velocity and attitude, position enters through gravity and curvature alone. Vibration above a
    tenth of the sample rate cannot be recovered from samples; give angular rate and specific force where you have
    them.

    flags: Flags of enum sins.sample_flags, or'ed.
    time_s: Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins.options.max_gap_s. Large
        stamps are coarse (2e-7 s at 1e9 s): state sins.options.sample_period_s with them.
    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -100 to 100 [rad]: any wrap.
    height_m: Height above the ellipsoid, -20 km to 2000 km [m].
    velocity_enu_m_s[3]: Velocity against the Earth, east-north-up, each up to 20 km/s [m/s].
    roll_rad: Roll, right wing down positive, any number of turns up to 10000 rad [rad].
    pitch_rad: Pitch, nose up positive, may go beyond 90 degrees, up to 10000 rad [rad]. From one sample to the
        next the attitude turns by less than 170 degrees, and by less than 180 degrees more or less than foreseen by
        the angular rates or else by the interval before. Whole turns that a host loses otherwise are beyond
        knowledge.
    heading_rad: Heading, clockwise from true north, any number of turns up to 10000 rad [rad].
    angular_rate_rad_s[3]: With sins.SAMPLE_ANGULAR_RATE: rate against inertial space in sensor axes at this
        instant, each up to 1000 rad/s [rad/s].
    specific_force_m_s2[3]: With sins.SAMPLE_SPECIFIC_FORCE: specific force in sensor axes at this instant, each
        up to 1e5 m/s2 [m/s2].
    temperature_c: With sins.SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant,
        -273.15 to 1000 [deg C]; straight from one sample to the next. Needed while temperature coefficients are set:
        a sample without it is then sins.ERROR_INVALID_ARGUMENT, as a flag forgotten would be an effect lost in
        silence.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("time_s", c_double),
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("velocity_enu_m_s", c_double * 3),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("heading_rad", c_double),
        ("angular_rate_rad_s", c_double * 3),
        ("specific_force_m_s2", c_double * 3),
        ("temperature_c", c_double),
    ]


class error_info(_Struct):
    """Why a call failed: what the sentence of sins.last_error() is made of.

    flags: Flags of enum sins.error_info_flags, or'ed.
    status: What the call returned, of enum sins.status_code; sins.OK if none failed.
    field[96]: The field or argument at fault, "gyro.markov_time_s", or what else is measured, terminated. Empty
        if it is the call itself.
    index: Element of the field, from 0; -1: the field is no array, or all of it is at fault.
    sample: Sample of the array that the call took, from 0; -1: none.
    value: With sins.ERROR_INFO_VALUE: the value at fault, which may be no number or infinite; of an integer the
        nearest double.
    minimum: With sins.ERROR_INFO_MINIMUM: the least value. Where the sentence says "more than", that value itself
        is refused.
    maximum: With sins.ERROR_INFO_MAXIMUM: the greatest value. Where the sentence says "less than", that value
        itself is refused.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("status", status),
        ("reserved", c_uint32),
        ("field", c_char * 96),
        ("index", c_int64),
        ("sample", c_int64),
        ("value", c_double),
        ("minimum", c_double),
        ("maximum", c_double),
    ]


class gyro_params(_Struct):
    """Errors of the gyros; each array is x, y, z of the sensor axes (sins.options.axes), each matrix row by row. All
    zero is an ideal triad. Signal: the angular rate. Densities do not depend on the sample rate.

    Effects act along the path of the signal: bandwidth; then scale factor, misalignment, asymmetry and nonlinearity,
    of the signal so far, g-sensitivity, of the true specific force, and temperature; then biases and noise are added;
    then dead zone, range, quantization.

    Asymmetry, nonlinearity, dead zone and range, and the accelerometers' vibration rectification, act on the mean
    signal of a sub-increment of the length dt = interval / (updates_per_sample * subsamples). With x = pi f dt, a
    vibration of frequency f loses by that 1 - (sin x / x)^2 of its mean square (nonlinearity, rectification) and,
    where it changes sign, up to 1 - cos x of its mean size (asymmetry): at a tenth of the sample rate 0.8 % and 1.2 %
    with two sub-increments an interval, 3.3 % and 4.9 % with one.

    bias_rad_s[3]: Constant bias, measured less true [rad/s], -100 to 100.
    bias_sigma_rad_s[3]: Standard deviation of the turn-on bias, drawn once a run [rad/s], 0 to 100.
    markov_sigma_rad_s[3]: Standard deviation of the first-order Gauss-Markov bias [rad/s], 0 to 100. The process
        is stationary from the first sample on.
    markov_time_s[3]: Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_rad_s
        is not 0.
    random_walk_rad_sqrt_s[3]: White noise N: angle or velocity random walk [rad/sqrt(s)], 0 to 100. It is the
        square root of the spectral density of the noise [unit of the signal / sqrt(Hz)].
    rate_random_walk_rad_s_sqrt_s[3]: Random walk K of rate or acceleration [(rad/s)/sqrt(s)], 0 to 100. It starts
        at 0 at the start of a run.
    rate_ramp_rad_s2[3]: Ramp R: bias that grows with the time [rad/s2], -100 to 100. It starts at 0 when it is
        set.
    flicker_rad_s[3]: Flicker noise, bias instability B [rad/s], 0 to 100. The process is stationary from the
        first sample on: the Allan deviation is flat at 0.664 B from 2 s to 50 h.
    scale_factor[3]: Scale factor error [1], -1 to 1.
    scale_factor_sigma[3]: Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It
        is added to scale_factor.
    scale_factor_asymmetry[3]: Scale factor error of positive less that of negative signals [1], -1 to 1.
    scale_factor_nonlinearity_s_rad[3]: Scale factor error that grows with the size of the signal [s/rad], -1 to
        1.
    misalignment_rad[9]: Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The
        diagonal is 0.
    misalignment_sigma_rad[9]: Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It
        is added to misalignment_rad. The diagonal is 0.
    g_sensitivity_rad_s_per_m_s2[9]: Drift by specific force, g-sensitivity: row = gyro, column = axis of the
        force [(rad/s)/(m/s2)], -1 to 1. The error of a gyro is the sum over the three axes of its row times the true
        specific force along them.
    g2_sensitivity_rad_s_per_m2_s4[3]: Drift by the square of the specific force along the gyro's own axis,
        g2-sensitivity [(rad/s)/(m/s2)^2], -1 to 1. The rate that gyro i measures is too large by element i times the
        square of component i of the true specific force at the block's own point, in sensor axes: a positive element
        makes a drift in the positive sense about the axis, whatever the sign of the force. The mean force of a
        sub-increment is squared, as with nonlinearity.
    reference_temperature_c: Temperature at which the four temperature coefficients have no effect [deg C],
        -273.15 to 1000. T is sins.flight_sample.temperature_c less this. Where one of the coefficients is not 0,
        every sample needs a temperature, and sins.push_imu() is not available.
    bias_temperature_rad_s_per_k[3]: Bias per kelvin [(rad/s)/K], -100 to 100. The bias is this times T.
    bias_temperature2_rad_s_per_k2[3]: Bias per kelvin squared [(rad/s)/K2], -100 to 100. The bias is this times
        T2.
    scale_factor_temperature_per_k[3]: Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is
        this times T.
    scale_factor_temperature2_per_k2[3]: Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor
        error is this times T2.
    bandwidth_hz[3]: Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter
        is settled at the first interval.
    dead_zone_rad_s[3]: Half the dead zone: signals up to this size give 0 [rad/s], 0 to 100.
    range_rad_s[3]: Range, where the output saturates [rad/s], 1e-9 to 1e6; 0: none. Saturation is flagged in
        sins.imu.
    quantization_rad[3]: Pulse of the output increments [rad], 1e-15 to 1; 0: none. The rest is carried. The
        quantization noise Q is pulse/sqrt(12).
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bias_rad_s", c_double * 3),
        ("bias_sigma_rad_s", c_double * 3),
        ("markov_sigma_rad_s", c_double * 3),
        ("markov_time_s", c_double * 3),
        ("random_walk_rad_sqrt_s", c_double * 3),
        ("rate_random_walk_rad_s_sqrt_s", c_double * 3),
        ("rate_ramp_rad_s2", c_double * 3),
        ("flicker_rad_s", c_double * 3),
        ("scale_factor", c_double * 3),
        ("scale_factor_sigma", c_double * 3),
        ("scale_factor_asymmetry", c_double * 3),
        ("scale_factor_nonlinearity_s_rad", c_double * 3),
        ("misalignment_rad", c_double * 9),
        ("misalignment_sigma_rad", c_double * 9),
        ("g_sensitivity_rad_s_per_m_s2", c_double * 9),
        ("g2_sensitivity_rad_s_per_m2_s4", c_double * 3),
        ("reference_temperature_c", c_double),
        ("bias_temperature_rad_s_per_k", c_double * 3),
        ("bias_temperature2_rad_s_per_k2", c_double * 3),
        ("scale_factor_temperature_per_k", c_double * 3),
        ("scale_factor_temperature2_per_k2", c_double * 3),
        ("bandwidth_hz", c_double * 3),
        ("dead_zone_rad_s", c_double * 3),
        ("range_rad_s", c_double * 3),
        ("quantization_rad", c_double * 3),
    ]


class accel_params(_Struct):
    """Errors of the accelerometers; each array is x, y, z of the sensor axes (sins.options.axes), each matrix row by
    row. All zero is an ideal triad. Signal: the specific force. Densities do not depend on the sample rate.

    Effects act along the path of the signal: size effect, bandwidth; then scale factor, misalignment, asymmetry,
    nonlinearity, vibration rectification, of the signal so far, and temperature; then biases and noise are added;
    then dead zone, range, quantization. What acts on the mean of a sub-increment: see sins.gyro_params.

    bias_m_s2[3]: Constant bias, measured less true [m/s2], -10000 to 10000.
    bias_sigma_m_s2[3]: Standard deviation of the turn-on bias, drawn once a run [m/s2], 0 to 10000.
    markov_sigma_m_s2[3]: Standard deviation of the first-order Gauss-Markov bias [m/s2], 0 to 10000. The process
        is stationary from the first sample on.
    markov_time_s[3]: Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_m_s2
        is not 0.
    velocity_random_walk_m_s_sqrt_s[3]: White noise N: angle or velocity random walk [(m/s)/sqrt(s)], 0 to 10000.
        It is the square root of the spectral density of the noise [unit of the signal / sqrt(Hz)].
    acceleration_random_walk_m_s2_sqrt_s[3]: Random walk K of rate or acceleration [(m/s2)/sqrt(s)], 0 to 10000.
        It starts at 0 at the start of a run.
    ramp_m_s3[3]: Ramp R: bias that grows with the time [m/s3], -10000 to 10000. It starts at 0 when it is set.
    flicker_m_s2[3]: Flicker noise, bias instability B [m/s2], 0 to 10000. The process is stationary from the
        first sample on: the Allan deviation is flat at 0.664 B from 2 s to 50 h.
    scale_factor[3]: Scale factor error [1], -1 to 1.
    scale_factor_sigma[3]: Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It
        is added to scale_factor.
    scale_factor_asymmetry[3]: Scale factor error of positive less that of negative signals [1], -1 to 1.
    scale_factor_nonlinearity_s2_m[3]: Scale factor error that grows with the size of the signal [s2/m], -1 to 1.
    misalignment_rad[9]: Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The
        diagonal is 0.
    misalignment_sigma_rad[9]: Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It
        is added to misalignment_rad. The diagonal is 0.
    vibration_rectification_s2_m[3]: Vibration rectification, the g2 term [s2/m], -1 to 1. A vibration of RMS r
        makes a bias of this times r2.
    lever_arm_m[9]: Lever arm of each accelerometer from the block's own point, sensor axes, row = sensor (size
        effect) [m], -100 to 100. The block's own point is where the lever arm of sins.mounting ends. At the start of
        a flight in motion see sins.mounting; the velocity lacks the change of rate in the first interval for good.
        With sins.push_imu() the angular acceleration follows from the increments before.
    reference_temperature_c: Temperature at which the four temperature coefficients have no effect [deg C],
        -273.15 to 1000. T is sins.flight_sample.temperature_c less this. Where one of the coefficients is not 0,
        every sample needs a temperature, and sins.push_imu() is not available.
    bias_temperature_m_s2_per_k[3]: Bias per kelvin [(m/s2)/K], -10000 to 10000. The bias is this times T.
    bias_temperature2_m_s2_per_k2[3]: Bias per kelvin squared [(m/s2)/K2], -10000 to 10000. The bias is this times
        T2.
    scale_factor_temperature_per_k[3]: Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is
        this times T.
    scale_factor_temperature2_per_k2[3]: Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor
        error is this times T2.
    bandwidth_hz[3]: Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter
        is settled at the first interval.
    dead_zone_m_s2[3]: Half the dead zone: signals up to this size give 0 [m/s2], 0 to 10000.
    range_m_s2[3]: Range, where the output saturates [m/s2], 1e-9 to 1e6; 0: none. Saturation is flagged in
        sins.imu.
    quantization_m_s[3]: Pulse of the output increments [m/s], 1e-15 to 1; 0: none. The rest is carried. The
        quantization noise Q is pulse/sqrt(12).
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bias_m_s2", c_double * 3),
        ("bias_sigma_m_s2", c_double * 3),
        ("markov_sigma_m_s2", c_double * 3),
        ("markov_time_s", c_double * 3),
        ("velocity_random_walk_m_s_sqrt_s", c_double * 3),
        ("acceleration_random_walk_m_s2_sqrt_s", c_double * 3),
        ("ramp_m_s3", c_double * 3),
        ("flicker_m_s2", c_double * 3),
        ("scale_factor", c_double * 3),
        ("scale_factor_sigma", c_double * 3),
        ("scale_factor_asymmetry", c_double * 3),
        ("scale_factor_nonlinearity_s2_m", c_double * 3),
        ("misalignment_rad", c_double * 9),
        ("misalignment_sigma_rad", c_double * 9),
        ("vibration_rectification_s2_m", c_double * 3),
        ("lever_arm_m", c_double * 9),
        ("reference_temperature_c", c_double),
        ("bias_temperature_m_s2_per_k", c_double * 3),
        ("bias_temperature2_m_s2_per_k2", c_double * 3),
        ("scale_factor_temperature_per_k", c_double * 3),
        ("scale_factor_temperature2_per_k2", c_double * 3),
        ("bandwidth_hz", c_double * 3),
        ("dead_zone_m_s2", c_double * 3),
        ("range_m_s2", c_double * 3),
        ("quantization_m_s", c_double * 3),
    ]


class altimeter_params(_Struct):
    """Errors of the barometric height that damps the vertical channel. All zero is an ideal altimeter.

    bias_m: Constant bias, up to 1e5 m [m].
    markov_sigma_m: Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on,
        up to 1e5 m [m].
    markov_time_s: Its correlation time, 1e-9 to 1e15 [s]; needed where markov_sigma_m is not 0.
    noise_m: Standard deviation of the independent error of each sample, up to 1e5 m [m].
    scale_factor: Scale factor error of the height, -1 to 1.
    lag_s: Time constant of the first-order lag of the static pressure, up to 1e6 s [s].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bias_m", c_double),
        ("markov_sigma_m", c_double),
        ("markov_time_s", c_double),
        ("noise_m", c_double),
        ("scale_factor", c_double),
        ("lag_s", c_double),
    ]


class failure(_Struct):
    """A failure of one output of a sensor. All zero is none. What the kind does not use is 0. u is rad/s of a gyro, m/s2
    of an accelerometer, m of the altimeter.

    kind: Of enum sins.failure_kind.
    size: Bias step, spikes: size, up to 100 rad/s, 1e4 m/s2, 1e5 m [u].
    density: Noise: density as the random walk N of the sensor, up to 100, 1e4, 1e5 [u sqrt(s)].
    interval_s: Spikes: from the start of one to the next; drop-outs: from one to the next; 1e-4 to 1e9 [s].
    duration_s: Spikes: length of one, 1e-9 s to interval_s [s].
    probability: Drop-outs: probability that an interval is lost, 0 to 1, where interval_s is 0.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kind", c_int32),
        ("reserved2", c_uint32),
        ("size", c_double),
        ("density", c_double),
        ("interval_s", c_double),
        ("duration_s", c_double),
        ("probability", c_double),
    ]


class initial_errors(_Struct):
    """Errors with which the navigation starts: computed less true, east-north-up. The sigmas are drawn once a run and
    added. Where the vertical channel follows the truth, its errors start at 0. Positions up to 1e6 m, velocities up
    to 1e4 m/s, their standard deviations up to 1e5 m and 1e3 m/s.

    position_enu_m[3]: Position [m].
    velocity_enu_m_s[3]: Velocity [m/s].
    misalignment_enu_rad[3]: Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x])
        C, C from sensor axes to east-north-up, the true one or with sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS the one that
        the alignment finds.
    position_sigma_enu_m[3]: Standard deviation of position [m].
    velocity_sigma_enu_m_s[3]: Standard deviation of velocity [m/s].
    misalignment_sigma_enu_rad[3]: Standard deviation of misalignment, 0 to 1 [rad].
    alignment: Of enum sins.alignment.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("position_enu_m", c_double * 3),
        ("velocity_enu_m_s", c_double * 3),
        ("misalignment_enu_rad", c_double * 3),
        ("position_sigma_enu_m", c_double * 3),
        ("velocity_sigma_enu_m_s", c_double * 3),
        ("misalignment_sigma_enu_rad", c_double * 3),
        ("alignment", c_int32),
        ("reserved2", c_uint32),
    ]


class mounting(_Struct):
    """Where the sensor block sits against the reference point of the flight samples, and what the INS wrongly believes
    of that: believed = true + error, component by component. All zero is a block at the reference point, along the
    body axes.

    The ideal sensors feel the motion of the block, and sensor errors act in its axes: sins.imu is about the block.
    The INS navigates the block and gives out the reference point with what it believes: sins.navigation and
    sins.errors are about that. Initial errors are those of the INS's solution of the block. Angular rate and specific
    force of a sample are of the reference point, along body axes; so is the barometric height.

    Where a flight begins in motion, or is repositioned, samples without an angular rate do not tell the angular
    acceleration of the first interval: the force of a block off the reference point lacks angular acceleration times
    arm there. The second interval has it to first order of its length, the third to second, later ones to third. The
    navigation does not suffer: what the next sample tells of the block's velocity, the INS has known from the start.
    With sins.SAMPLE_ANGULAR_RATE nothing is lacking.

    lever_arm_m[3]: From the reference point to the block, body axes (sins.options.axes), -100 to 100 [m].
    boresight_rad[3]: Roll, pitch and heading of the block's axes against the body axes, as those of the body
        against the horizon: right side down, nose up, nose to the right; any number of turns up to 10000 rad, as in a
        flight sample [rad].
    lever_arm_error_m[3]: Believed less true lever arm, -100 to 100 [m].
    boresight_error_rad[3]: Believed less true boresight angles, -pi to pi [rad]. A heading believed too large
        makes the heading that the INS gives out too small by as much.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("lever_arm_m", c_double * 3),
        ("boresight_rad", c_double * 3),
        ("lever_arm_error_m", c_double * 3),
        ("boresight_error_rad", c_double * 3),
    ]


class gravity_params(_Struct):
    """True gravity less the normal gravity that the INS computes: deflection of the vertical, and anomaly (strictly the
    gravity disturbance: both at the same point). Each has a constant part and a random one, a first-order
    Gauss-Markov field along the track: correlation sigma^2 exp(-d/D) over the distance d flown over ground. At rest
    it does not change. All zero is normal gravity.

    Perfect accelerometers feel it: it is in the ideal signals of sins.imu. The INS takes it for an error of its
    accelerometers: at rest, without a levelled start, a deflection makes it swing by R times the deflection to both
    sides of R times the deflection; a levelled start (sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS) leans by it.

    deflection_north_rad: Deflection in the meridian (xi): astronomic less geodetic latitude, -0.01 to 0.01 [rad].
        The true zenith lies north of the ellipsoid's normal, and the accelerometers at rest feel g times this to the
        north.
    deflection_north_sigma_rad: Standard deviation of its random part, up to 0.01 [rad].
    deflection_north_distance_m: Correlation distance D of that, 1 to 1e9 [m]; needed where the standard deviation
        is not 0.
    deflection_east_rad: Deflection in the prime vertical (eta): astronomic less geodetic longitude, times the
        cosine of latitude, -0.01 to 0.01 [rad]. The true zenith lies east of the ellipsoid's normal.
    deflection_east_sigma_rad: Standard deviation of its random part, up to 0.01 [rad].
    deflection_east_distance_m: Correlation distance of that, 1 to 1e9 [m].
    anomaly_m_s2: Anomaly, excess of gravity, -0.1 to 0.1 [m/s2]. A milligal is 1e-5 m/s2.
    anomaly_sigma_m_s2: Standard deviation of its random part, up to 0.1 [m/s2].
    anomaly_distance_m: Correlation distance of that, 1 to 1e9 [m].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("deflection_north_rad", c_double),
        ("deflection_north_sigma_rad", c_double),
        ("deflection_north_distance_m", c_double),
        ("deflection_east_rad", c_double),
        ("deflection_east_sigma_rad", c_double),
        ("deflection_east_distance_m", c_double),
        ("anomaly_m_s2", c_double),
        ("anomaly_sigma_m_s2", c_double),
        ("anomaly_distance_m", c_double),
    ]


class record_solution(_Struct):
    """A solution within a sins.record; never grows. Fields as in sins.navigation.

    latitude_rad: [rad]
    longitude_rad: [rad]
    height_m: [m]
    velocity_enu_m_s[3]: [m/s]
    roll_rad: [rad]
    pitch_rad: [rad]
    heading_rad: [rad]
    quaternion_nb[4]: Scalar first.
    flags: Flags of enum sins.navigation_flags, or'ed.
    """

    __slots__ = ()
    _fields_ = [
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("velocity_enu_m_s", c_double * 3),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("heading_rad", c_double),
        ("quaternion_nb", c_double * 4),
        ("flags", c_int32),
        ("reserved", c_uint32),
    ]


class record_errors(_Struct):
    """Errors within a sins.record; never grows. Fields as in sins.errors.

    position_enu_m[3]: [m]
    latitude_rad: [rad]
    longitude_rad: [rad]
    height_m: [m]
    velocity_enu_m_s[3]: [m/s]
    misalignment_enu_rad[3]: [rad]
    roll_rad: [rad]
    pitch_rad: [rad]
    heading_rad: [rad]
    flags: Flags of enum sins.errors_flags, or'ed.
    """

    __slots__ = ()
    _fields_ = [
        ("position_enu_m", c_double * 3),
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("velocity_enu_m_s", c_double * 3),
        ("misalignment_enu_rad", c_double * 3),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("heading_rad", c_double),
        ("flags", c_int32),
        ("reserved", c_uint32),
    ]


class record(_Struct):
    """Truth, navigation and both errors at one instant.

    time_s: Time [s].
    truth: As sins.get_truth().
    navigation: As sins.get_navigation().
    navigation_errors: As sins.get_errors() with sins.ERRORS_NAVIGATION: error data 2.
    model_errors: As sins.get_errors() with sins.ERRORS_MODEL: error data 1; flagged sins.ERRORS_NOT_COMPUTED
        while the model is off.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("time_s", c_double),
        ("truth", record_solution),
        ("navigation", record_solution),
        ("navigation_errors", record_errors),
        ("model_errors", record_errors),
    ]


class navigation(_Struct):
    """A solution: the truth or the navigated one.

    time_s: Time [s].
    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -pi to pi [rad].
    height_m: Height above the ellipsoid [m].
    velocity_enu_m_s[3]: Velocity against the Earth, east-north-up [m/s].
    roll_rad: Roll, right wing down positive, -pi to pi [rad].
    pitch_rad: Pitch, nose up positive, -pi/2 to pi/2 [rad].
    heading_rad: Heading, clockwise from true north, 0 to 2 pi [rad].
    quaternion_nb[4]: Attitude quaternion, scalar first: rotates from sensor axes to east-north-up.
    flags: Flags of enum sins.navigation_flags, or'ed.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("time_s", c_double),
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("velocity_enu_m_s", c_double * 3),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("heading_rad", c_double),
        ("quaternion_nb", c_double * 4),
        ("flags", c_int32),
        ("reserved2", c_uint32),
    ]


class imu(_Struct):
    """Ideal and measured signals of the last interval, sensor axes.

    flags: Flags of enum sins.imu_flags, or'ed.
    time_s: Time of the end of the interval [s].
    interval_s: Length of the interval [s].
    ideal_angle_rad[3]: Integral of the angular rate against inertial space, perfect gyros [rad].
    ideal_velocity_m_s[3]: Integral of the specific force, perfect accelerometers [m/s].
    measured_angle_rad[3]: What the modelled gyros give [rad].
    measured_velocity_m_s[3]: What the modelled accelerometers give [m/s].
    ideal_rate_rad_s[3]: ideal_angle_rad over the interval [rad/s].
    ideal_force_m_s2[3]: ideal_velocity_m_s over the interval [m/s2].
    measured_rate_rad_s[3]: measured_angle_rad over the interval [rad/s].
    measured_force_m_s2[3]: measured_velocity_m_s over the interval [m/s2].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("time_s", c_double),
        ("interval_s", c_double),
        ("ideal_angle_rad", c_double * 3),
        ("ideal_velocity_m_s", c_double * 3),
        ("measured_angle_rad", c_double * 3),
        ("measured_velocity_m_s", c_double * 3),
        ("ideal_rate_rad_s", c_double * 3),
        ("ideal_force_m_s2", c_double * 3),
        ("measured_rate_rad_s", c_double * 3),
        ("measured_force_m_s2", c_double * 3),
    ]


class errors(_Struct):
    """Errors of the navigated solution, computed less true.

    time_s: Time [s].
    position_enu_m[3]: Displacement from truth along true east and north, and difference of heights [m].
    latitude_rad: Latitude [rad].
    longitude_rad: Longitude, wrapped to -pi..pi [rad].
    height_m: Height [m].
    velocity_enu_m_s[3]: Velocity [m/s]: difference of the components, each in its own east-north-up.
    misalignment_enu_rad[3]: Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) C, C from
        sensor axes to east-north-up. The error model has it to first order, computed C = (I - [phi x]) C.
    roll_rad: Roll, wrapped [rad].
    pitch_rad: Pitch [rad].
    heading_rad: Heading, wrapped [rad].
    flags: Flags of enum sins.errors_flags, or'ed.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("time_s", c_double),
        ("position_enu_m", c_double * 3),
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("velocity_enu_m_s", c_double * 3),
        ("misalignment_enu_rad", c_double * 3),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("heading_rad", c_double),
        ("flags", c_int32),
        ("reserved2", c_uint32),
    ]


class accuracy(_Struct):
    """Running figures of the flight since its start or last reposition (sins.move_time() and sins.move_truth() leave
    them), errors sampled once a second. They describe one run, which is no ensemble. Divide the rates by
    sins.NMI_PER_HOUR for the unit of data sheets.

    time_s: Time [s].
    duration_s: Time since the start [s].
    window_start_s: Where the window of the radial error rates begins, in time since the start: 300 s; before,
        they are initial errors over next to nothing [s].
    window_samples: Samples in that window; the rates are 0 while there is none.
    radial_error_rate_rms_m_s: sqrt(mean RER^2); radial error rate RER = horizontal position error / time since
        the start [m/s].
    cep_rate_m_s: R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s].
    radial_95_rate_m_s: R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s].
    radial_error_slope_m_s: Slope of the straight line of least squares through the horizontal position error
        [m/s].
    velocity_rms_enu_m_s[3]: Root mean square velocity error since the start, east-north-up; without samples
        within 20 km of the Earth's axis, where east and north turn [m/s].
    closure_position_enu_m[3]: Closure: navigation minus truth now, position [m].
    closure_velocity_enu_m_s[3]: Closure: navigation minus truth now, velocity [m/s].
    host_position_enu_m[3]: Share of the horizontal position closure that the host's own inconsistency explains
        [m]: the Schuler-tuned answer to displacement by velocity less displacement by position; up is 0. Closure less
        this is the simulator's and the sensors'.
    host_velocity_enu_m_s[3]: The same of the horizontal velocity closure; up is 0 [m/s].
    inconsistency_enu_m[3]: Displacement by the host's velocities less displacement by its positions, summed over
        the flight [m].
    inconsistency_max_m: The largest of it in one interval [m].
    inconsistent_samples: Samples flagged sins.NAVIGATION_INCONSISTENT.
    intervals: Intervals flown since the start or the last reposition: one less than the samples.
    trim_rate_max_rad_s: The largest trim that sins.SIGNAL_CLOSED_LOOP added to the angular rate, from ten of its
        time constants on: the error of generator and mechanization themselves; 0 with physical signals [rad/s].
    trim_force_max_m_s2: The same of the specific force [m/s2].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("time_s", c_double),
        ("duration_s", c_double),
        ("window_start_s", c_double),
        ("window_samples", c_uint64),
        ("radial_error_rate_rms_m_s", c_double),
        ("cep_rate_m_s", c_double),
        ("radial_95_rate_m_s", c_double),
        ("radial_error_slope_m_s", c_double),
        ("velocity_rms_enu_m_s", c_double * 3),
        ("closure_position_enu_m", c_double * 3),
        ("closure_velocity_enu_m_s", c_double * 3),
        ("host_position_enu_m", c_double * 3),
        ("host_velocity_enu_m_s", c_double * 3),
        ("inconsistency_enu_m", c_double * 3),
        ("inconsistency_max_m", c_double),
        ("inconsistent_samples", c_uint64),
        ("intervals", c_uint64),
        ("trim_rate_max_rad_s", c_double),
        ("trim_force_max_m_s2", c_double),
    ]


class truth_summary(_Struct):
    """The motion of the truth in figures, over all intervals since the create or the last sins.reset(): those of wrong
    units or exchanged axes are none of a vehicle. Attitudes in degrees turn 57 times as fast and show any sideslip;
    east and north exchanged are a sideslip and a contradiction between velocity and position, as are knots for m/s;
    feet for metres are heights and climbs of 3.3 times their size. Rates, accelerations and forces are means from one
    sample to the next. Each ..._at_s is the time stamp of the sample that it came with.

    intervals: Intervals flown.
    gaps: Those of them that are gaps (see sins.GAP).
    fast_samples: Samples faster than 30 m/s: sideslip and angle of attack are of these.
    flown_s: Sum of the lengths of the intervals [s].
    first_s: Time stamps of the first and of the last sample [s].
    last_s: See first_s.
    interval_max_s: Longest interval [s].
    interval_max_at_s: When [s].
    turn_max_rad: Largest rotation in an interval [rad].
    turn_max_at_s: When [s].
    rate_max_rad_s: Largest angular rate: by the attitudes against the Earth, or the samples' own [rad/s].
    rate_max_at_s: When [s].
    acceleration_max_m_s2: Largest acceleration against the Earth, by the velocities [m/s2].
    acceleration_max_at_s: When [s].
    force_max_m_s2: Largest specific force: by the velocities and gravity, or the samples' own [m/s2].
    force_max_at_s: When [s].
    inconsistency_max_m: Largest displacement in an interval that the mean of the velocities at its ends does not
        explain [m].
    inconsistency_max_at_s: When [s].
    speed_max_m_s: Largest speed against the Earth [m/s].
    speed_max_at_s: When [s].
    sideslip_max_rad: Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth,
        to the right; wind is in it [rad].
    sideslip_max_at_s: When [s].
    attack_max_rad: Angle of attack of the largest size, from the velocity against the Earth up to the forward
        axis, in the plane of symmetry [rad].
    attack_max_at_s: When [s].
    height_min_m: Lowest height [m].
    height_min_at_s: When [s].
    height_max_m: Highest height [m].
    height_max_at_s: When [s].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("intervals", c_uint64),
        ("gaps", c_uint64),
        ("fast_samples", c_uint64),
        ("flown_s", c_double),
        ("first_s", c_double),
        ("last_s", c_double),
        ("interval_max_s", c_double),
        ("interval_max_at_s", c_double),
        ("turn_max_rad", c_double),
        ("turn_max_at_s", c_double),
        ("rate_max_rad_s", c_double),
        ("rate_max_at_s", c_double),
        ("acceleration_max_m_s2", c_double),
        ("acceleration_max_at_s", c_double),
        ("force_max_m_s2", c_double),
        ("force_max_at_s", c_double),
        ("inconsistency_max_m", c_double),
        ("inconsistency_max_at_s", c_double),
        ("speed_max_m_s", c_double),
        ("speed_max_at_s", c_double),
        ("sideslip_max_rad", c_double),
        ("sideslip_max_at_s", c_double),
        ("attack_max_rad", c_double),
        ("attack_max_at_s", c_double),
        ("height_min_m", c_double),
        ("height_min_at_s", c_double),
        ("height_max_m", c_double),
        ("height_max_at_s", c_double),
    ]


class imu_increment(_Struct):
    """Increments of an inertial measurement unit over an interval, in count parts of equal length.

    interval_s: Length of the whole interval, 5e-5 to 10 [s].
    count: Parts, 1 to 5.
    angle_rad[15]: Integral of the angular rate against inertial space over each part, up to 1e3 rad: x, y, z of
        the first, of the second, ... [rad].
    velocity_m_s[15]: Integral of the specific force over each part, up to 1e4 m/s, likewise [m/s].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("interval_s", c_double),
        ("count", c_int32),
        ("reserved2", c_uint32),
        ("angle_rad", c_double * 15),
        ("velocity_m_s", c_double * 15),
    ]


class statistics(_Struct):
    """Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the
    same bits however they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without
    pointers: send it, store it, compare its bytes. Its numbers have the byte order of the machine. A struct that is
    all zero but for struct_size has no run. sins.statistics_figures() computes means, covariances and radii.

    The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment
    about east, north, up, as in sins.errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24
    um), 2^-29 m/s (1.9 nm/s), 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262
    km/s) and 4 rad, which are 2^47 resolutions; the horizontal radial position error is in range below 2^25 m. There
    are at most 4294967295 runs: their sums cannot overflow. Integers of 128 bits are two words, the low one first, in
    two's complement.

    layout: Version of what follows: 1; 0 while there is no run.
    runs: Runs, those that were left out of the sums too.
    diverged: Runs that have diverged, left out of the sums.
    out_of_range: Runs with a state or a horizontal radial position error outside its range, left out of the sums.
    outside_validity: Runs within the sums whose error model is flagged sins.ERRORS_OUTSIDE_VALIDITY.
    largest_radial: Largest horizontal radial position error, rounded down [2^-22 m].
    sums[18]: Sum of each state, integers of 128 bits.
    products[90]: Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row
        by row.
    histogram[3501]: Runs by horizontal radial position error: element 0 those below 2^-10 m (1 mm), and 1 + 100 i
        + k, for i from 0 to 34 and k from 0 to 99, those from 2^(i-10) (1 + k/100) up to 2^(i-10) (1 + (k+1)/100) m.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("layout", c_uint32),
        ("runs", c_uint64),
        ("diverged", c_uint64),
        ("out_of_range", c_uint64),
        ("outside_validity", c_uint64),
        ("largest_radial", c_uint64),
        ("sums", c_uint64 * 18),
        ("products", c_uint64 * 90),
        ("histogram", c_uint32 * 3501),
        ("reserved", c_uint32),
    ]


class figures(_Struct):
    """Figures that are computed from a sins.statistics. Without a run all are 0, and the covariance of one run is 0.

    runs: Runs, those that were left out too.
    diverged: Runs that have diverged, left out.
    out_of_range: Runs with an error outside its range, left out.
    outside_validity: Runs whose error model is flagged sins.ERRORS_OUTSIDE_VALIDITY, not left out.
    mean_position_enu_m[3]: Mean position error [m].
    mean_velocity_enu_m_s[3]: Mean velocity error [m/s].
    mean_misalignment_enu_rad[3]: Mean misalignment [rad].
    sigma_position_enu_m[3]: Standard deviation of the position error, with the divisor n - 1 [m].
    sigma_velocity_enu_m_s[3]: Standard deviation of the velocity error [m/s].
    sigma_misalignment_enu_rad[3]: Standard deviation of the misalignment [rad].
    rms_position_enu_m[3]: Root mean square of the position error [m].
    rms_velocity_enu_m_s[3]: Root mean square of the velocity error [m/s].
    rms_misalignment_enu_rad[3]: Root mean square of the misalignment [rad].
    covariance[81]: Covariance of the nine states of sins.statistics, with the divisor n - 1, row by row: element
        9 i + j is that of the states i and j, in m, m/s and rad.
    rms_radial_m: Root mean square of the horizontal radial position error [m].
    cep50_m: Horizontal radius within which half of the runs are [m]: the radial error of the run with this rank,
        read from the histogram to 0.5 % of itself, below 1 mm to 0.5 mm.
    r95_m: Horizontal radius within which 95 % of the runs are [m], read from the histogram as cep50_m.
    largest_radial_m: Largest horizontal radial position error [m].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("runs", c_uint64),
        ("diverged", c_uint64),
        ("out_of_range", c_uint64),
        ("outside_validity", c_uint64),
        ("mean_position_enu_m", c_double * 3),
        ("mean_velocity_enu_m_s", c_double * 3),
        ("mean_misalignment_enu_rad", c_double * 3),
        ("sigma_position_enu_m", c_double * 3),
        ("sigma_velocity_enu_m_s", c_double * 3),
        ("sigma_misalignment_enu_rad", c_double * 3),
        ("rms_position_enu_m", c_double * 3),
        ("rms_velocity_enu_m_s", c_double * 3),
        ("rms_misalignment_enu_rad", c_double * 3),
        ("covariance", c_double * 81),
        ("rms_radial_m", c_double),
        ("cep50_m", c_double),
        ("r95_m", c_double),
        ("largest_radial_m", c_double),
    ]


class flight_start(_Struct):
    """Where an embedded flight begins, level and straight.

    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -100 to 100 [rad].
    height_m: Height above the ellipsoid, -20 km to 2000 km [m].
    speed_m_s: Speed against the Earth, 0 to 10 km/s [m/s].
    heading_rad: Course and heading, -100 to 100 [rad].
    roll_rad: Roll of the body against the path's axes throughout the flight, -pi to pi [rad].
    pitch_rad: Pitch of the body against the path's axes throughout the flight, -pi/2 to pi/2: angle of attack, or
        tilt at rest [rad].
    earth: Of enum sins.earth, as in the options of the simulator that will fly it.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("latitude_rad", c_double),
        ("longitude_rad", c_double),
        ("height_m", c_double),
        ("speed_m_s", c_double),
        ("heading_rad", c_double),
        ("roll_rad", c_double),
        ("pitch_rad", c_double),
        ("earth", c_int32),
        ("reserved2", c_uint32),
    ]


class manoeuvre(_Struct):
    """One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use
    must be 0.

    kind: Of enum sins.manoeuvre_kind.
    sinusoid_count: Sinusoids, 1 to 6.
    duration_s: Duration, 1e-3 to 1e8 [s].
    ramp_s: Time in which the manoeuvre sets in, and in which it ends; at most half of it. 0: 5 s [s].
    speed_change_m_s: Change of speed, to no less than 0 and no more than 10 km/s [m/s].
    height_change_m: Change of height; the climb angle must stay below 64 degrees [m].
    heading_change_rad: Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad
        [rad].
    bank_rad: Bank of a turn, 1e-3 to 1.5 [rad].
    turns: Whole rolls or loops, up to 1e4, or swings of an S-turn, up to 1e6.
    channel[6]: What each sinusoid moves, of enum sins.channel.
    amplitude[6]: Amplitude of each sinusoid, up to 10 rad, 1.5 rad for the climb angle, all of the speed together
        up to it [rad] or [m/s].
    frequency_hz[6]: Frequency of each sinusoid, 0 to 1000 [Hz].
    phase_rad[6]: Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), t since the begin of the
        manoeuvre [rad].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("kind", c_int32),
        ("sinusoid_count", c_int32),
        ("duration_s", c_double),
        ("ramp_s", c_double),
        ("speed_change_m_s", c_double),
        ("height_change_m", c_double),
        ("heading_change_rad", c_double),
        ("bank_rad", c_double),
        ("turns", c_double),
        ("channel", c_int32 * 6),
        ("amplitude", c_double * 6),
        ("frequency_hz", c_double * 6),
        ("phase_rad", c_double * 6),
    ]


class fault(_Struct):
    """A fault of the text of a scene or of a flight log.

    count: Faults of the text, 200 at the most.
    line: Line of this one, from 1.
    column: Column, in characters from 1; of a flight log the column of the table.
    sentence[256]: Which key, which value, which limit, and the key that was probably meant; UTF-8, terminated,
        cut where it is longer.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("count", c_uint64),
        ("line", c_uint64),
        ("column", c_uint64),
        ("sentence", c_char * 256),
    ]


class scene_setup(_Struct):
    """What a scene says of its flight and of its output.

    flight: Of enum sins.scene_flight; read only: a set call passes over it.
    has_temperature: 1: samples get the temperature below; 0: none.
    quiet: 1: a program shows neither progress nor summary; 0: it does.
    duration_s: How long to fly, 0.036 to 3.6e8; 0: the whole flight, or as long as the built-in scene [s].
    flown_s: How long that is; 0 of a log, whose length the log tells, or if duration_s is more than the flight
        has; read only [s].
    rate_hz: Sample rate, 1e-3 to 2e4; 0 of a log, which has its own time stamps [Hz].
    temperature_c: Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if there is none [deg
        C].
    temperature_change_c_s: Its change, -277 to 277 [deg C/s].
    every_s: Spacing of the records of a program, 5e-5 to 1e7; 0: the program's choice [s].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("flight", c_int32),
        ("has_temperature", c_int32),
        ("quiet", c_int32),
        ("reserved2", c_uint32),
        ("duration_s", c_double),
        ("flown_s", c_double),
        ("rate_hz", c_double),
        ("temperature_c", c_double),
        ("temperature_change_c_s", c_double),
        ("every_s", c_double),
    ]


class planned_failure(_Struct):
    """A failure that a scene plans.

    sensor: Of enum sins.sensor.
    axis: 0, 1, 2: x, y, z of the sensor axes; of the altimeter 0.
    from_s: When it begins, 0 to 1e9 since the start of the flight [s].
    until_s: When it ends, likewise; 0: at the end of the flight [s].
    kind: Of enum sins.failure_kind, but not sins.FAILURE_NONE.
    size: This and the following as in sins.failure.
    density: See sins.failure.
    interval_s: See sins.failure [s].
    duration_s: See sins.failure [s].
    probability: See sins.failure.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("sensor", c_int32),
        ("axis", c_int32),
        ("from_s", c_double),
        ("until_s", c_double),
        ("kind", c_int32),
        ("reserved2", c_uint32),
        ("size", c_double),
        ("density", c_double),
        ("interval_s", c_double),
        ("duration_s", c_double),
        ("probability", c_double),
    ]


class log_info(_Struct):
    """What a flight log holds.

    samples: Samples.
    duration_s: From the first to the last of them [s].
    title[192]: The comment in the first line of the log, UTF-8, terminated; empty: none.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("samples", c_uint64),
        ("duration_s", c_double),
        ("title", c_char * 192),
    ]


class requirement(_Struct):
    """Largest error that the algorithm itself may make, apart from those of the sensors, at any time within a duration.
    A limit of 0 is none; at least one is needed.

    duration_s: For how long, up to 1e6 [s]; 0, or less than the piece's length: for the piece.
    position_m: Distance from where the exact solution on the same signals is [m].
    velocity_m_s: Speed of the difference in velocity [m/s].
    attitude_rad: Angle between the attitudes, against the Earth [rad].
    margin: How many times the predicted error has to fit into each limit, 1 to 1e6; 0: 2.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("duration_s", c_double),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
        ("margin", c_double),
    ]


class cost(_Struct):
    """What recommended options give, and what they cost.

    duration_s: For how long the errors are predicted [s].
    position_m: Predicted error, the worst within the duration: position [m].
    velocity_m_s: Velocity [m/s].
    attitude_rad: Attitude against the Earth [rad].
    reference_position_m: The part of it that is the uncertainty of the reference: position [m].
    reference_velocity_m_s: Velocity [m/s].
    reference_attitude_rad: Attitude [rad].
    share: Predicted error times margin over its limit, the largest of the three: met up to 1. A limit below
        1e-100 counts as 1e-100.
    instructions_per_step: Instructions of a step that the algorithm has a part in, the same on every machine:
        what the algorithms are ordered by.
    ns_per_step: Measured here and now, in the options that were written, in the mounting and with ideal sensors:
        push and step of one sample [ns].
    tried: Algorithms that were tried, the recommended one among them.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("duration_s", c_double),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
        ("reference_position_m", c_double),
        ("reference_velocity_m_s", c_double),
        ("reference_attitude_rad", c_double),
        ("share", c_double),
        ("instructions_per_step", c_double),
        ("ns_per_step", c_double),
        ("tried", c_uint64),
    ]


class budget_request(_Struct):
    """What a budget is asked for. A limit of 0 is none.

    runs: Runs of each random effect, 8 to 1000; 0: 16.
    position_m: What the effects that are left out may change together at any time of the scene: position [m].
    velocity_m_s: Velocity [m/s].
    attitude_rad: Misalignment [rad].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("runs", c_uint64),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
    ]


class budget_row(_Struct):
    """An effect and what it contributes; in the first row of a budget, what the mechanization and the samples leave with
    nothing set.

    flags: Flags of enum sins.budget_flags, or'ed.
    effect[32]: Name of the effect, "gyro turn-on bias", terminated; of the first row "mechanization".
    field[48]: The field that sets it, "gyro.bias_sigma_rad_s", terminated: 0 there leaves it out. Empty in the
        first row.
    position_m: Length of the contribution to the position error, the largest of the scene [m].
    velocity_m_s: Velocity [m/s].
    attitude_rad: Misalignment [rad].
    end_position_m: The same at the end of the scene: position [m].
    end_velocity_m_s: Velocity [m/s].
    end_attitude_rad: Misalignment [rad].
    share: The largest share of a limit that the contribution takes up; 0 without limits.
    ns_per_step: Measured here and now: what a step takes with all effects less without this one; in the first row
        what it takes with nothing set [ns]. Uncertain by 1 to 5 % of a step, more on a busy machine, so that it may
        be negative.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("effect", c_char * 32),
        ("field", c_char * 48),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
        ("end_position_m", c_double),
        ("end_velocity_m_s", c_double),
        ("end_attitude_rad", c_double),
        ("share", c_double),
        ("ns_per_step", c_double),
    ]


class budget(_Struct):
    """A budget as a whole.

    duration_s: Time that was looked at: from the end of the first interval to that of the last [s].
    runs: Runs of each random effect; 1 if there is none.
    flights: Flights that were flown.
    sigma_low: A standard deviation lies with 95 % probability between its row's figure times this, ...
    sigma_high: ... and times this; both are 1 if nothing is random.
    position_m: Errors with all effects together, root mean square over the runs, the largest of the scene:
        position [m].
    velocity_m_s: Velocity [m/s].
    attitude_rad: Misalignment [rad].
    remainder_position_m: What of that the sum of all rows does not explain: position [m].
    remainder_velocity_m_s: Velocity [m/s].
    remainder_attitude_rad: Misalignment [rad].
    left_out_position_m: What the errors change by without the marked rows, flown: position [m].
    left_out_velocity_m_s: Velocity [m/s].
    left_out_attitude_rad: Misalignment [rad].
    ns_per_step: Measured here and now: what a step takes with all effects [ns].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("duration_s", c_double),
        ("runs", c_uint64),
        ("flights", c_uint64),
        ("sigma_low", c_double),
        ("sigma_high", c_double),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
        ("remainder_position_m", c_double),
        ("remainder_velocity_m_s", c_double),
        ("remainder_attitude_rad", c_double),
        ("left_out_position_m", c_double),
        ("left_out_velocity_m_s", c_double),
        ("left_out_attitude_rad", c_double),
        ("ns_per_step", c_double),
    ]


class _Text(ctypes.c_char_p):
    """An argument that is a text: str or bytes."""

    @classmethod
    def from_param(cls, value):
        value = value.encode() if isinstance(value, str) else value
        if isinstance(value, bytes) and b"\0" in value:
            raise ValueError(f"{value!r}: a text has no zero byte")
        return super().from_param(value)


class _New:
    """An argument that is a handle which stands for nothing yet."""

    def __init__(self, handle):
        self.pointer = POINTER(handle)

    def from_param(self, value):
        if value:
            raise ValueError("the handle stands for something already: close() it first")
        return self.pointer.from_param(value)


class _Array:
    """Two arguments: a pointer to elements, and their number."""

    def __init__(self, element, is_input=False):
        self.element = element
        self.is_bytes = is_input and element is c_char
        self.types = (ctypes.c_char_p if self.is_bytes else POINTER(element), c_size_t)

    def __call__(self, value):
        if value is None:
            return None, 0
        if isinstance(value, self.element):
            return value, 1
        if self.is_bytes:
            value = value.encode() if isinstance(value, str) else bytes(memoryview(value))
        elif isinstance(value, (str, bytes)):
            raise TypeError("a buffer to write into: make it by ctypes.create_string_buffer(size)")
        elif hasattr(value, "dtype"):  # of numpy
            if value.dtype != _dtype(self.element):
                raise TypeError("not an array as sins.array(sins.{0}, count) makes it".format(self.element.__name__))
            value = (self.element * value.size).from_buffer(value)
        return value, len(value)


@functools.lru_cache(maxsize=None)
def _dtype(struct):
    import numpy  # needed for arrays of numpy alone

    return numpy.dtype(struct)


def _fail(status, sim):
    """Raises what the library says of the last call: of a simulator, or of this thread."""
    sentence, info = ctypes.create_string_buffer(1024), error_info()
    length = ctypes.sizeof(sentence)
    if _library.sins_last_error(sim, sentence, c_size_t(length), None) not in (status_code.OK, status_code.ERROR_BUFFER_TOO_SMALL):
        sim = None  # a refused handle remembers nothing; the thread does
        _library.sins_last_error(sim, sentence, c_size_t(length), None)
    _library.sins_last_error_info(sim, ctypes.byref(info))
    raise Error(status, sentence.value.decode(errors="replace"), info)


def _function(result, *kinds):
    """The function of the library that has the name of the one below; it takes the arguments, and what is below documents them."""

    def declare(described):
        name = "sins_" + described.__name__
        foreign = getattr(_library, name, None)
        if foreign is None:
            def missing(*_):
                raise NotImplementedError(f"the library has no {name}(): it is older, or built without the feature scenes")

            return functools.wraps(described)(missing)

        has_arrays = any(isinstance(kind, _Array) for kind in kinds)
        first = described.__code__.co_varnames[:1]
        foreign.restype = result
        foreign.argtypes = [one for kind in kinds for one in (kind.types if isinstance(kind, _Array) else (kind,))]

        @functools.wraps(described)
        def call(*arguments):
            given = arguments
            if has_arrays:
                if len(arguments) != len(kinds):
                    raise TypeError(f"{described.__name__}() takes {len(kinds)} arguments, {len(arguments)} were given")
                given = []
                for kind, value in zip(kinds, arguments):
                    given += kind(value) if isinstance(kind, _Array) else (value,)
            answer = foreign(*given)
            if result is status and answer < 0:
                _fail(answer, arguments[0] if first == ("sim",) else None)
            return answer.decode() if isinstance(answer, bytes) else answer

        return call

    return declare


@_function(c_uint32)
def abi_version():
    """The version of the interface that the loaded library has: compare it with sins.HEADER_ABI."""


@_function(ctypes.c_char_p)
def version_string():
    """The release of the loaded library as text, "0.1.0"; lives as long as the library is loaded."""


@_function(ctypes.c_char_p, status)
def status_string(status):
    """The name of a status code, "sins.OK"; "unknown status" for a number that is none. Lives as long as the library is
    loaded.
    """


@_function(status, sim, POINTER(options))
def get_options(sim, options):
    """Reads the options in effect: those of the create or of the snapshot that was loaded, with the defaults in place of
    0.
    """


@_function(status, POINTER(options), _New(sim))
def create(options, sim):
    """Creates a simulator with ideal sensors. options may be NULL: the recommended simulator.

    On an error *sim is untouched, and sins.last_error(NULL, ...) on this thread tells why. sins.ERROR_OUT_OF_MEMORY:
    no memory, or 4096 simulators live. Not for a real-time frame: it allocates.
    """


@_function(status, sim)
def destroy(sim):
    """Destroys a simulator. A call on it in another thread is waited for; the handle is never used again.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, sim, POINTER(flight_sample))
def push_sample(sim, sample):
    """Takes one flight-control sample into the queue (16 samples). Each is checked by itself and against the one before.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
    sins.ERROR_TIME_ORDER: not later than the one before, by less than 5e-5 s, or off a stated period by more than 0.4
    of it. sins.GAP: taken, and the interval before it is a gap, of more than 2.5 times each of the two before: its
    sins.step() flies it as motion, the velocity times its length, up to max_gap_s. After a pause of the host whose
    clock ran on, call sins.move_time() before this push; the push cannot be taken back. sins.ERROR_DISCONTINUITY: a
    gap of more than max_gap_s, a jump or half a turn since the last that was taken: no other is taken until one fits,
    or until sins.move_time() for a gap, sins.move_truth() or sins.reposition() for a jump. sins.ERROR_QUEUE_FULL:
    step first. sins.ERROR_BAD_STATE: navigating on increments.
    """


@_function(status, sim)
def step(sim):
    """Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples,
    each further one one more. No allocation, no system call. An interval in which the host's clock ran on is flown
    like any other, the velocity times its length; sins.push_sample() answers sins.GAP for it.

    sins.NEED_SAMPLE: no complete interval waits. sins.ERROR_DIVERGED: the interval would lead the solution of the
    block, of the reference point or of the closed loop's own error-free navigator beyond -500 km or 20000 km of
    height or 100 km/s; sins.ERROR_SINGULAR: within reach of a pole, in geographic axes. The step is not made, the
    solution before it stays readable, and sins.reposition() or sins.reset() start anew. sins.ERROR_BAD_STATE:
    navigating on increments.
    """


@_function(status, sim, c_double)
def move_time(sim, time_s):
    """The newest accepted sample counts as at time_s from now on [s], and the stamps of samples to come follow on it:
    for a pause in which the host's clock ran on. time_s is where the clock was when the vehicle moved on. All else is
    as it was: errors, noise, waiting samples, sensor processes, failures, running figures, and the stated period,
    whose grid moves along. A flight goes on to the same bits as one whose stamps never jumped if the differences
    between successive stamps are the same doubles; with a stated period they always are. (Without velocities the
    differences over three samples count too; durations in sins.accuracy are rounded as the time stamps are.)
    flight_start_s of sins.scene_prepare() is the host's: move it by as much.

    sins.ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9. sins.ERROR_BAD_STATE: no sample yet, or
    navigating on increments, which have no stamps.
    """


@_function(status, sim, POINTER(flight_sample))
def move_truth(sim, sample):
    """The vehicle was slewed: truth jumps to the sample, and the INS keeps the errors that it has. No interval is flown
    from the sample before to this one, so the errors do not grow between them. Position error in metres (along the
    truth's east and north, and in height), velocity error (components) and misalignment that sins.get_errors() tells
    are those before, from both sources, to 1e-8 m, 1e-11 m/s and 1e-14 rad; what comes of them is up to gravity, the
    latitude and the velocity there. Noise, sensor processes, failures, the vertical channel, the altimeter's error
    (but that of its scale factor, which is of the new height) and running figures go on; no draw moves. The sensors
    follow the new signals at once. Waiting samples are dropped; time may jump too, all clocks with it, as in
    sins.move_time(). sins.get_imu() still tells the interval before. Where the sample has no velocity, the solution
    has its velocity error alone until the next is pushed.

    Within 20 km of the Earth's axis, before or after, where the components along east and north of truth and solution
    have no common meaning, errors of velocity and attitude are those in the truth's axes, turned to the solution's
    vertical by the shortest way. With a mounting the errors kept are those of the sensor block; those of the
    reference point are what its arm and boresight, and what is wrong of them, make of that in the new attitude.

    Before the first step there is no INS with errors: it is sins.reposition() then. sins.ERROR_INVALID_ARGUMENT,
    sins.ERROR_BAD_STATE: as sins.reposition(). sins.ERROR_SINGULAR: within reach of a pole, in geographic axes.
    sins.ERROR_DIVERGED: the solution would leave its range, or there is no place with such an error, a quarter of the
    Earth away.
    """


@_function(status, sim, POINTER(flight_sample))
def reposition(sim, sample):
    """The flight simulator was reloaded: truth jumps to the sample, the INS starts again there with its initial errors.
    The errors that it had are lost; to keep them call sins.move_truth() (slew) or sins.move_time() (pause) instead.
    Noise and failures go on where they were. Waiting samples and the running accuracy figures are dropped. Time may
    jump too, forward or back: the run, and the count of a stated period, go on from the sample's time stamp. What is
    read until the next step is that of the sample; an interval to read there is none. It may be the first call of a
    run: the sample is then the first, and the next push makes an interval.

    sins.ERROR_INVALID_ARGUMENT: as sins.push_sample(). sins.ERROR_BAD_STATE: navigating on increments. Where no INS
    can start (a pole, in geographic axes) it is the reads and the next step that say so.
    """


@_function(status, sim)
def reset(sim):
    """Back to before the first sample: same options, the parameters as they were set last, no failures, and the same
    draws again from their start, so that the same samples and settings give the same bits. For other draws create a
    simulator with another seed or run; to come back to a moment in flight, see sins.snapshot_save().
    """


@_function(status, sim, _Array(c_char), POINTER(c_size_t))
def last_error(sim, buffer, needed):
    """Copies the sentence of the last failed call on this handle: which field, which value, which limit. UTF-8, always
    terminated; "no error" if none failed. With a NULL handle: that of the last failed call on this thread that has no
    simulator (create, presets, flights, ensembles, statistics, scenes, logs, recommend, budget) or whose handle was
    refused (sins.ERROR_BAD_HANDLE, or sins.ERROR_BAD_STATE: see Threads). This call and sins.last_error_info() leave
    no sentence where they fail themselves.

    needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for
    that alone. sins.ERROR_BUFFER_TOO_SMALL: the sentence was cut.
    """


@_function(status, sim, POINTER(error_info))
def last_error_info(sim, info):
    """Reads why the last call on this handle failed, or with a NULL handle on this thread: that of which
    sins.last_error() has the sentence.
    """


@_function(status, sim, POINTER(gyro_params))
def set_gyro(sim, params):
    """Sets the gyro errors: before the first sample or in flight, from the next interval on. The draws of other effects
    do not move; processes that were active go on from where they are.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: temperature coefficients while
    samples without a temperature wait, or while navigating on increments.
    """


@_function(status, sim, POINTER(gyro_params))
def get_gyro(sim, params):
    """Reads the gyro errors, as they were set last: at any moment, after sins.snapshot_load() too."""


@_function(status, sim, POINTER(accel_params))
def set_accel(sim, params):
    """Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The draws of other
    effects do not move; processes that were active go on from where they are.

    sins.ERROR_INVALID_ARGUMENT, sins.ERROR_BAD_STATE: as sins.set_gyro().
    """


@_function(status, sim, POINTER(accel_params))
def get_accel(sim, params):
    """Reads the accelerometer errors, as they were set last: at any moment, after sins.snapshot_load() too."""


@_function(status, sim, POINTER(altimeter_params))
def set_altimeter(sim, params):
    """Sets the errors of the barometric height that damps the vertical channel (sins.VERTICAL_DAMPED), from the next
    interval on.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, sim, POINTER(altimeter_params))
def get_altimeter(sim, params):
    """Reads the errors of the altimeter, as they were set last: at any moment, after sins.snapshot_load() too."""


@_function(status, sim, c_int32, c_int32, POINTER(failure))
def set_failure(sim, sensor, axis, failure):
    """Lets one output fail, as an instructor's station does: before the first sample or in flight, from the next
    interval on, until it is cleared by sins.FAILURE_NONE or another failure of the same output takes its place.
    Several outputs may fail at once.

    sensor is of enum sins.sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before
    dead zone, range and quantization, the others replace the output. No draw of another effect moves, and what runs
    on behind a failure is there again when it is cleared. Both error data hear of it. The alignment at the start does
    not see failures. sins.reposition() keeps them; sins.reset() clears them all, so that an exercise begins anew with
    sound sensors, and failures set again at the same intervals give the same bits.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. A failure that
    throws the solution away makes sins.step() answer sins.ERROR_DIVERGED.
    """


@_function(status, sim, c_int32, c_int32, POINTER(failure))
def get_failure(sim, sensor, axis, failure):
    """Reads the failure of one output: at any moment, after sins.snapshot_load() too; sins.FAILURE_NONE if it is sound.
    sensor and axis as in sins.set_failure().

    sins.ERROR_INVALID_ARGUMENT: no such output.
    """


@_function(status, sim, POINTER(initial_errors))
def set_initial_errors(sim, errors):
    """Sets the errors with which the navigation starts: before the first step, after a reset or after a reposition.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(initial_errors))
def get_initial_errors(sim, errors):
    """Reads the errors with which the navigation starts, as they were set last: at any moment, after
    sins.snapshot_load() too.
    """


@_function(status, sim, POINTER(mounting))
def set_mounting(sim, mounting):
    """Sets where the sensor block sits: before the first step, after a reset or after a reposition; both keep it. A
    navigator on increments is not concerned: its solution is that of the block.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(mounting))
def get_mounting(sim, mounting):
    """Reads place and attitude of the sensor block, as they were set last: at any moment, after sins.snapshot_load()
    too.
    """


@_function(status, sim, POINTER(gravity_params))
def set_gravity_disturbance(sim, params):
    """Sets true gravity less normal gravity: before the first step, after a reset or after a reposition. A reset brings
    the same field back; after a reposition it goes on from its values there. A navigator on increments is not
    concerned: these have felt their own gravity.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(gravity_params))
def get_gravity_disturbance(sim, params):
    """Reads the parameters of the gravity disturbance, as they were set last: at any moment, after sins.snapshot_load()
    too.
    """


@_function(status, sim, _Array(flight_sample, is_input=True), c_size_t, _Array(record), POINTER(c_size_t))
def run(sim, samples, every, records, written):
    """Pushes and steps count samples, and writes a record each `every` intervals since the flight's start. Any split of
    a flight into calls gives the same bits, records included, as pushing and stepping sample by sample.

    samples[0].struct_size tells how far apart the samples are, records[0].struct_size the records; the others' may be
    0, those of the records anything. every 0: no records. written (may be NULL) gets the number of records, also on
    an error.

    sins.GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
    sins.get_truth_summary() counts them. sins.ERROR_BUFFER_TOO_SMALL: capacity does not hold the records that the
    call would make; nothing is flown. sins.ERROR_BAD_STATE: navigating on increments. Any error of sins.push_sample()
    or sins.step() stops the run at the sample that it concerns, which sins.last_error() names: the samples before it
    have been flown, this and the rest not; sins.accuracy.intervals counts them. A sample that could be pushed but not
    flown waits in the queue, as after sins.step(); sins.reposition() and sins.reset() empty it.
    """


@_function(status, sim, POINTER(navigation))
def get_truth(sim, truth):
    """Reads the truth at the end of the last interval; before the first step, that of the first sample. Where samples
    have no velocity, that of the first is 0 until the second is pushed.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_BAD_STATE: navigating on increments, there is no truth.
    """


@_function(status, sim, POINTER(navigation))
def get_navigation(sim, navigation):
    """Reads the navigated solution for the same instant as sins.get_truth().

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: before the first step, no INS can start
    at the first sample with these options and initial errors.
    """


@_function(status, sim, POINTER(imu))
def get_imu(sim, imu):
    """Reads ideal and measured signals of the last interval.

    sins.NEED_SAMPLE: no interval yet.
    """


@_function(status, sim, c_int32, POINTER(errors))
def get_errors(sim, source, errors):
    """Reads the errors of the navigated solution; source is of enum sins.errors_source.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such source. sins.ERROR_BAD_STATE:
    sins.ERRORS_MODEL while the error model is off, as it is by default (create the simulator with
    sins.options.error_model), or navigating on increments. sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: as
    sins.get_navigation().
    """


@_function(status, sim, POINTER(accuracy))
def get_accuracy(sim, accuracy):
    """Reads the running accuracy figures.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_BAD_STATE: navigating on increments, there is no truth.
    sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: as sins.get_navigation().
    """


@_function(status, sim, POINTER(truth_summary))
def get_truth_summary(sim, summary):
    """Reads the motion of the truth in figures; sins.reposition() and sins.move_truth() leave them.

    sins.NEED_SAMPLE: no interval yet. sins.ERROR_BAD_STATE: sins.options.truth_summary is off, or navigating on
    increments, there is no truth.
    """


@_function(status, sim, POINTER(record))
def get_record(sim, record):
    """Reads truth, navigation and both errors of this moment at once; before the first step, of the first sample.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_BAD_STATE: navigating on increments, there is no truth.
    sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: as sins.get_navigation().
    """


@_function(status, sim, POINTER(navigation))
def start_navigation(sim, navigation):
    """Starts the simulator as a navigator alone, at time, place, velocity and attitude (quaternion_nb; the angles are
    not read) of navigation, on increments that sins.push_imu() gives. Ranges are those of a flight sample, the norm
    of the quaternion is 1 within 1e-3; initial errors that are set do not apply. There is no truth then: the vertical
    channel is free and flagged so, errors and accuracy are sins.ERROR_BAD_STATE until sins.reset().

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: samples were pushed, or it was
    started already; sins.reset() first; or temperature coefficients are set, for which increments have no
    temperature. sins.ERROR_SINGULAR: within reach of a pole, in geographic axes.
    """


@_function(status, sim, POINTER(imu_increment))
def push_imu(sim, increment):
    """Navigates over one interval on the host's increments; sensor errors that are set are added to them. The time goes
    on by interval_s; sins.get_imu() tells the host's increments as the ideal ones. sins.options.subsamples and
    updates_per_sample do not apply: the parts of the increment are the subsamples of one update.

    sins.ERROR_BAD_STATE: sins.start_navigation() first. sins.ERROR_INVALID_ARGUMENT: a value out of its range, or
    half a turn in a part or in the interval. sins.ERROR_DIVERGED, sins.ERROR_SINGULAR: as sins.step(); the interval
    is not flown, the solution before it stays readable, and sins.reset() and sins.start_navigation() start anew.
    """


@_function(status, sim, POINTER(c_size_t))
def snapshot_size(sim, size):
    """The size that a snapshot has now, while each sample is flown as it comes: 1.3 to 2.1 KiB without sensor errors, up
    to 4.5 KiB with every error of gyros, accelerometers and altimeter, up to 5.25 KiB with mounting, gravity,
    temperature and failures besides; up to 154 bytes more for each sample that waits. It changes with what is set and
    with the samples that wait.
    """


@_function(status, sim, _Array(c_char), POINTER(c_size_t))
def snapshot_save(sim, buffer, written):
    """Saves the whole simulator, at any moment: options, parameters, samples that wait, the state of every block, each
    random stream where it is. written (may be NULL) gets the size. The bytes mean the same on every platform and hold
    no address: keep them in a file, send them to another machine. The same state gives the same bytes. No allocation,
    no system call.

    Not saved: handles, and the sentence of sins.last_error(). After sins.ERROR_DIVERGED or sins.ERROR_SINGULAR it is
    the last good solution that is saved, after sins.ERROR_INTERNAL nothing: load an earlier snapshot into a fresh
    handle.

    sins.ERROR_BUFFER_TOO_SMALL: see sins.snapshot_size(); buffer and written are as they were.
    """


@_function(status, sim, _Array(c_char, is_input=True))
def snapshot_load(sim, snapshot):
    """Makes the simulator the one that was saved, whatever it was before: its options too, as sins.get_options() tells,
    so that a fresh handle of sins.create(NULL, ...) will do. From there the run goes on to the same bits as the saved
    one did. size is what sins.snapshot_save() wrote. Not for a real-time frame: it allocates.

    sins.ERROR_SNAPSHOT: the bytes are no snapshot, cut off, altered, or of a newer release; nothing has changed, and
    sins.last_error() tells which it is. Later releases read the snapshots of earlier ones; the run goes on to the
    same bits where CHANGELOG does not say that the algorithms changed. sins.ERROR_OUT_OF_MEMORY: no memory for a
    second simulator.
    """


@_function(status, sim, c_uint64, c_size_t, _New(ensemble))
def ensemble_create(configured, first_run, runs, ensemble):
    """Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator that was set up
    (options, sensors, initial errors, mounting, gravity, failures) and has taken no sample; it is copied and stays as
    it is. Run k is, bit for bit, the simulator that was set up likewise with sins.options.run = first_run + k.
    sins.options.run and truth_summary of configured have no effect.

    What a run does never depends on the other runs: ensembles over disjoint runs may be flown by different threads,
    processes and machines, and their statistics merged. The library starts no thread.

    Each run takes some 40 KB of memory. Not for a real-time frame: it allocates.

    On an error *ensemble is untouched, and sins.last_error(NULL, ...) on this thread tells why. sins.ERROR_BAD_STATE:
    configured has taken a sample since it was created or reset, or navigates on increments.
    sins.ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 beyond 2^64 - 1.
    sins.ERROR_OUT_OF_MEMORY: no memory, or 4096 ensembles live.
    """


@_function(status, ensemble)
def ensemble_destroy(ensemble):
    """Destroys an ensemble. A call on it in another thread is waited for; the handle is never used again.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, ensemble, POINTER(flight_sample))
def ensemble_push_sample(ensemble, sample):
    """Takes one flight-control sample into the queue (16 samples) of all runs.

    sins.GAP and the errors: as sins.push_sample().
    """


@_function(status, ensemble)
def ensemble_step(ensemble):
    """Flies one sample interval with all runs that have not diverged. No allocation, no system call.

    A run that cannot make the step, for which sins.step() would answer sins.ERROR_DIVERGED or sins.ERROR_SINGULAR,
    has diverged: it keeps its solution before the step, takes no further part, and is reported by
    sins.ensemble_get_diverged() and counted by sins.ensemble_get_statistics(). The others go on, and so does the
    truth, even if no run is left. sins.ensemble_reposition() and sins.ensemble_reset() start all runs again.

    sins.NEED_SAMPLE: no complete interval waits. sins.ERROR_SINGULAR: the truth is within reach of a pole, in
    geographic axes or where the alignment is a gyrocompass; the step is not made.
    """


@_function(status, ensemble, _Array(flight_sample, is_input=True))
def ensemble_run(ensemble, samples):
    """Pushes and steps count samples. Any split of a flight into calls gives the same bits as pushing and stepping
    sample by sample. samples[0].struct_size tells how far apart the samples are; the others' may be 0.

    sins.GAP: all samples were flown, and at least one of them ended a gap. Any error of sins.ensemble_push_sample()
    or sins.ensemble_step() stops the run at the sample that it concerns, which sins.last_error() names: the samples
    before it have been flown, this and the rest not. A sample that could be pushed but not flown waits in the queue.
    """


@_function(status, ensemble, POINTER(flight_sample))
def ensemble_reposition(ensemble, sample):
    """Truth jumps to the sample, and every run starts again there with its initial errors, the diverged ones too: as
    sins.reposition().

    sins.ERROR_INVALID_ARGUMENT: as sins.push_sample().
    """


@_function(status, ensemble)
def ensemble_reset(ensemble):
    """Back to before the first sample: same parameters, no failures, the same draws again from their start, no run
    diverged.
    """


@_function(status, ensemble, c_int32, c_int32, POINTER(failure))
def ensemble_set_failure(ensemble, sensor, axis, failure):
    """Lets one output of every run fail, or clears its failure: as sins.set_failure().

    sins.ERROR_INVALID_ARGUMENT: as sins.set_failure().
    """


@_function(status, ensemble, POINTER(c_uint64), POINTER(c_size_t))
def ensemble_get_runs(ensemble, first_run, runs):
    """Reads the numbers of the first run and of the runs; either may be NULL."""


@_function(status, ensemble, POINTER(navigation))
def ensemble_get_truth(ensemble, truth):
    """Reads the truth, which all runs share: as sins.get_truth().

    sins.NEED_SAMPLE: no sample yet.
    """


@_function(status, ensemble, c_uint64, POINTER(navigation))
def ensemble_get_navigation(ensemble, run, navigation):
    """Reads the navigated solution of a run, first_run to first_run + runs - 1: as sins.get_navigation().

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such run. sins.ERROR_DIVERGED: the run has
    diverged, and the sentence has the time of its last good solution; or as sins.get_navigation().
    sins.ERROR_SINGULAR: as sins.get_navigation().
    """


@_function(status, ensemble, c_uint64, c_int32, POINTER(errors))
def ensemble_get_errors(ensemble, run, source, errors):
    """Reads the errors of the navigated solution of a run: as sins.get_errors(); source is of enum sins.errors_source.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such run or source. sins.ERROR_BAD_STATE:
    sins.ERRORS_MODEL while the error model is off. sins.ERROR_DIVERGED, sins.ERROR_SINGULAR: as
    sins.ensemble_get_navigation().
    """


@_function(status, ensemble, c_uint64, POINTER(imu))
def ensemble_get_imu(ensemble, run, imu):
    """Reads ideal and measured signals of the last interval of a run: as sins.get_imu().

    sins.NEED_SAMPLE: no interval yet. sins.ERROR_INVALID_ARGUMENT: no such run. sins.ERROR_DIVERGED: the run has
    diverged.
    """


@_function(status, ensemble, c_size_t, POINTER(c_uint64))
def ensemble_get_diverged(ensemble, index, run):
    """Reads the number of a run that has diverged: index 0 is the lowest of them, and so on. sins.statistics.diverged
    counts them.

    sins.ERROR_INVALID_ARGUMENT: no more than index runs have diverged.
    """


@_function(status, ensemble, c_int32, POINTER(statistics))
def ensemble_get_statistics(ensemble, source, statistics):
    """Reads the statistics of the errors of all runs at this moment; source is of enum sins.errors_source.
    sins.statistics_merge() adds those of other runs at the same moment. Within 20 km of the Earth's axis
    (sins.NAVIGATION_NEAR_POLE of the truth) velocity and misalignment have no meaning. No allocation, no system call.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such source. sins.ERROR_BAD_STATE:
    sins.ERRORS_MODEL while the error model is off. sins.ERROR_SINGULAR: before the first step, no run can start at
    the first sample.
    """


@_function(status, POINTER(statistics), POINTER(statistics))
def statistics_merge(into, other):
    """Adds the runs of other to those of into; no run may be in both. Exactly associative and commutative: any order and
    any grouping gives the same bits, so that work may be split over threads, processes, machines and restarts in any
    way. into may be all zero but for struct_size: no run.

    sins.ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or there would be more than
    4294967295 runs; into is as it was.
    """


@_function(status, POINTER(statistics), POINTER(figures))
def statistics_figures(statistics, figures):
    """Computes means, covariances, root mean squares and radii from statistics.

    sins.ERROR_INVALID_ARGUMENT: they are damaged or of another release.
    """


@_function(status, ensemble, POINTER(c_size_t))
def ensemble_snapshot_size(ensemble, size):
    """The size that a snapshot has now: some 1.3 to 5.25 KiB a run, as that of a simulator."""


@_function(status, ensemble, _Array(c_char), POINTER(c_size_t))
def ensemble_snapshot_save(ensemble, buffer, written):
    """Saves the whole ensemble, at any moment: as sins.snapshot_save(). written (may be NULL) gets the size. The same
    state gives the same bytes. No allocation, no system call.

    sins.ERROR_BUFFER_TOO_SMALL: see sins.ensemble_snapshot_size(); buffer and written are as they were.
    """


@_function(status, ensemble, _Array(c_char, is_input=True))
def ensemble_snapshot_load(ensemble, snapshot):
    """Makes the ensemble the one that was saved, whatever it was before: its runs and options too, so that one of any
    simulator and one run will do. From there it goes on to the same bits as the saved one did. size is what
    sins.ensemble_snapshot_save() wrote. Not for a real-time frame: it allocates.

    sins.ERROR_SNAPSHOT: the bytes are no snapshot of an ensemble, cut off, altered, or of a newer release; nothing
    has changed, and sins.last_error(NULL, ...) reports which it is. sins.ERROR_OUT_OF_MEMORY: no memory for a second
    ensemble.
    """


@_function(status, c_int32, POINTER(gyro_params))
def gyro_preset(grade, params):
    """Fills params with the gyro errors of a grade, of enum sins.grade. Biases, scale factor errors and misalignments
    are drawn at turn-on with the standard deviations that the source states; what it does not state is 0.

    sins.ERROR_INVALID_ARGUMENT: no such grade.
    """


@_function(status, c_int32, POINTER(accel_params))
def accel_preset(grade, params):
    """Fills params with the accelerometer errors of a grade, as sins.gyro_preset().

    sins.ERROR_INVALID_ARGUMENT: no such grade.
    """


@_function(status, POINTER(flight_start), _Array(manoeuvre, is_input=True), _New(flight))
def flight_create(start, manoeuvres, flight):
    """Creates a flight of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time,
    smooth to the third derivative; position is their integral to rounding. manoeuvres[0].struct_size tells how far
    apart they are.

    Not for a real-time frame: it allocates, and integrates the path in pieces, some 20 us and 0.5 KB each. A piece is
    up to 600 s of straight flight, or about a period of a fast sinusoid of course, climb or speed; roll, pitch and
    heading need none.

    On an error *flight is untouched, and sins.last_error(NULL, ...) on this thread tells why:
    sins.ERROR_INVALID_ARGUMENT a value out of its range, or a height on the way out of the range of
    sins.flight_sample.height_m, which no simulator takes (the index in the sentence is that of the manoeuvre),
    sins.ERROR_OUT_OF_MEMORY no memory, more than 200000 pieces (which take 3 s), or 4096 flights that live.
    """


@_function(status, flight, POINTER(c_double))
def flight_duration(flight, duration_s):
    """Length of the flight [s]."""


@_function(status, flight, c_double, POINTER(flight_sample))
def flight_sample_at(flight, time_s, sample):
    """The sample at time_s, 0 to the duration [s]: exact at any time, in any order. No allocation; 0.5 to 2 us.

    sins.ERROR_INVALID_ARGUMENT: a time before the start or after the end.
    """


@_function(status, flight)
def flight_destroy(flight):
    """Destroys a flight.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, _New(scene))
def scene_create(scene):
    """Creates the default scene: the recommended simulator with ideal sensors, at rest for an hour at latitude 0,
    longitude 0, height 0, sampled at 100 Hz.

    On an error *scene is untouched, and sins.last_error(NULL, ...) on this thread tells why, as for every function of
    scenes. sins.ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes live. Functions of scenes allocate: none but
    sins.scene_prepare() is for a real-time frame. They ask for all the memory of a call first; where it runs out
    within the call, as another thread takes it, the process ends. So it is of sins.log_parse(), but for the samples.
    """


@_function(status, _Array(c_char, is_input=True), _New(scene))
def scene_parse(text, scene):
    """Creates the scene of a text: TOML in UTF-8, of at most 1 MiB. The bytes are not kept. sins.scene_write_keys()
    lists the keys.

    sins.SCENE_HAS_FAULTS: the text is no scene; sins.scene_get_fault() tells every fault and its place. The handle is
    made for that alone: any other function but sins.scene_destroy() answers sins.ERROR_BAD_STATE.
    sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, scene, c_size_t, POINTER(fault))
def scene_get_fault(scene, index, fault):
    """Fault `index` of the scene's text, from 0 in the order of the text; fault->count tells how many there are.

    sins.ERROR_INVALID_ARGUMENT: no such fault; the scene has none, or fewer.
    """


@_function(status, _Text, _New(scene))
def scene_create_builtin(name, scene):
    """Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
    "over_the_pole", "coning", "commuter".

    sins.ERROR_INVALID_ARGUMENT: no scene has that name. sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, c_size_t, _Array(c_char), POINTER(c_size_t))
def scene_builtin_name(index, buffer, needed):
    """The name of built-in scene `index`, from 0. buffer, capacity and needed as in sins.scene_write().

    sins.ERROR_INVALID_ARGUMENT: there are no more.
    """


@_function(status, scene, _Array(c_char), POINTER(c_size_t))
def scene_write(scene, buffer, needed):
    """Writes the scene as commented TOML, which sins.scene_parse() reads back to the same scene, to the bit.

    needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for that
    alone. sins.ERROR_BUFFER_TOO_SMALL: the text was cut. sins.ERROR_INVALID_ARGUMENT: settings that do not go
    together, or so many manoeuvres and failures that the text would have more than 1 MiB. sins.ERROR_BAD_STATE: as
    sins.scene_parse().
    """


@_function(status, _Array(c_char), POINTER(c_size_t))
def scene_write_keys(buffer, needed):
    """Writes every section and key of a scene with what it takes, its unit and its meaning, a line each. buffer,
    capacity and needed as in sins.scene_write().
    """


@_function(status, scene, _New(sim))
def scene_create_simulator(scene, sim):
    """Creates the simulator of the scene, ready for the first sample: options, sensors, start, mounting, gravity.
    Failures come in their time by sins.scene_prepare(). Of a flight that is not a log the sample period is stated: 1
    / rate.

    sins.ERROR_INVALID_ARGUMENT: settings that do not go together. sins.ERROR_BAD_STATE: as sins.scene_parse().
    sins.ERROR_OUT_OF_MEMORY: as sins.create().
    """


@_function(status, scene, _New(flight))
def scene_create_flight(scene, flight):
    """Creates the flight of the scene, composed of manoeuvres or built-in, on the scene's ellipsoid. A host samples it
    at k / rate up to sins.scene_setup.flown_s.

    sins.ERROR_BAD_STATE: the flight of the scene is a log, whose name is sins.SCENE_TEXT_LOG; or as
    sins.scene_parse(). Else as sins.flight_create().
    """


@_function(status, scene)
def scene_destroy(scene):
    """Destroys a scene. Simulators and flights that were made of it live on.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, scene, sim, c_double, POINTER(flight_sample))
def scene_prepare(scene, sim, flight_start_s, sample):
    """Makes ready for the next interval what the scene plans over time: call it before each sample is pushed, and step
    before the next sample. The sample gets the scene's temperature, if it plans one. Failures of the scene begin and
    end on sim with the first interval that starts at their time or later; failures of outputs for which it plans none
    are left alone. flight_start_s is the time stamp of the flight's first sample. No allocation, no system call.

    sins.ERROR_BAD_HANDLE: of scene or sim. sins.ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s
    not from -2e10 to 2e10. sins.ERROR_BAD_STATE: as sins.scene_parse().
    """


@_function(status, scene, ensemble, c_double, POINTER(flight_sample))
def scene_prepare_ensemble(scene, ensemble, flight_start_s, sample):
    """The same for all runs of an ensemble: as sins.scene_prepare().

    sins.ERROR_BAD_HANDLE: of scene or ensemble. The other errors: as sins.scene_prepare().
    """


@_function(status, scene, POINTER(options))
def scene_get_options(scene, options):
    """Reads the options of the scene.

    sins.ERROR_BAD_STATE: as sins.scene_parse(), as for all functions that read or set a part of a scene.
    """


@_function(status, scene, POINTER(options))
def scene_set_options(scene, options):
    """Sets the options of the scene. On an error, as for every part, the scene is as it was. Parts can be set in any
    order: whether they go together is checked where the scene is written and its simulator is created.

    sins.ERROR_INVALID_ARGUMENT: as sins.create().
    """


@_function(status, scene, POINTER(gyro_params))
def scene_get_gyro(scene, params):
    """Reads the gyro errors of the scene."""


@_function(status, scene, POINTER(gyro_params))
def scene_set_gyro(scene, params):
    """Sets the gyro errors of the scene.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(accel_params))
def scene_get_accel(scene, params):
    """Reads the accelerometer errors of the scene."""


@_function(status, scene, POINTER(accel_params))
def scene_set_accel(scene, params):
    """Sets the accelerometer errors of the scene.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(altimeter_params))
def scene_get_altimeter(scene, params):
    """Reads the errors of the scene's altimeter."""


@_function(status, scene, POINTER(altimeter_params))
def scene_set_altimeter(scene, params):
    """Sets the errors of the scene's altimeter.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(initial_errors))
def scene_get_initial_errors(scene, errors):
    """Reads the errors with which the navigation of the scene starts."""


@_function(status, scene, POINTER(initial_errors))
def scene_set_initial_errors(scene, errors):
    """Sets the errors with which the navigation of the scene starts.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(mounting))
def scene_get_mounting(scene, mounting):
    """Reads where the sensor block of the scene sits."""


@_function(status, scene, POINTER(mounting))
def scene_set_mounting(scene, mounting):
    """Sets where the sensor block of the scene sits.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(gravity_params))
def scene_get_gravity_disturbance(scene, params):
    """Reads true gravity less normal gravity of the scene."""


@_function(status, scene, POINTER(gravity_params))
def scene_set_gravity_disturbance(scene, params):
    """Sets true gravity less normal gravity of the scene.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(scene_setup))
def scene_get_setup(scene, setup):
    """Reads what a scene says of its flight and of its output."""


@_function(status, scene, POINTER(scene_setup))
def scene_set_setup(scene, setup):
    """Sets what a scene says of its flight and of its output; flight and flown_s are passed over.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(flight_start), _Array(manoeuvre), POINTER(c_size_t), POINTER(c_size_t))
def scene_get_manoeuvres(scene, start, manoeuvres, count, repeat):
    """Reads the flight of the scene, composed of manoeuvres or built-in: start, manoeuvres, how many there are, and how
    many times all of them are flown. manoeuvres[0].struct_size tells how far apart they are; start and repeat may be
    NULL, and to ask for count alone manoeuvres with a capacity of 0.

    sins.ERROR_BUFFER_TOO_SMALL: capacity does not hold the manoeuvres; count alone was written. sins.ERROR_BAD_STATE:
    the flight is a log; or as sins.scene_parse().
    """


@_function(status, scene, POINTER(flight_start), _Array(manoeuvre, is_input=True), c_size_t)
def scene_set_manoeuvres(scene, start, manoeuvres, repeat):
    """Makes the flight of the scene one of count manoeuvres, all of them flown repeat times, 4096 together at the most.
    start->earth is passed over: the ellipsoid is that of the scene's options. A flight that was a log is sampled at
    100 Hz from then on.

    sins.ERROR_INVALID_ARGUMENT: as sins.flight_create(), but for the height on the way.
    """


@_function(status, scene, c_int32, _Array(c_char), POINTER(c_size_t))
def scene_get_text(scene, which, buffer, needed):
    """Reads a text of the scene, which of enum sins.scene_text; an empty one is none. buffer, capacity and needed as in
    sins.scene_write().

    sins.ERROR_INVALID_ARGUMENT: no such text.
    """


@_function(status, scene, c_int32, _Text)
def scene_set_text(scene, which, text):
    """Sets a text of the scene, which of enum sins.scene_text: UTF-8, terminated, at most 4096 bytes. An empty one is
    none; the flight of a scene is never none.

    sins.ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
    """


@_function(status, scene, POINTER(c_size_t))
def scene_get_failure_count(scene, count):
    """How many failures the scene plans."""


@_function(status, scene, c_size_t, POINTER(planned_failure))
def scene_get_failure(scene, index, failure):
    """Planned failure `index`, from 0.

    sins.ERROR_INVALID_ARGUMENT: no such failure.
    """


@_function(status, scene, POINTER(planned_failure))
def scene_add_failure(scene, failure):
    """Plans one failure more.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or a failure of the same output at the same time.
    """


@_function(status, scene)
def scene_clear_failures(scene):
    """Plans no failure any more."""


@_function(status, _Array(c_char, is_input=True), _New(log), POINTER(fault))
def log_parse(text, log, fault):
    """Reads a flight log, comma-separated values in UTF-8. The first line that is not a comment (#) names the columns,
    in any order; columns of other names are passed over, and a row with more fields than columns is a fault:

    time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg,
    heading_rad or _deg; if known velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s,
    rate_z_rad_s; force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c

    Frames and signs are those of sins.flight_sample. A log has at least two samples, each later than the one before;
    their ranges are checked where they are pushed. The bytes are not kept. Not for a real-time frame: it allocates,
    184 bytes a sample.

    sins.ERROR_INVALID_ARGUMENT: the text is no flight log; fault (may be NULL) tells the first fault and its place,
    and *log is untouched. sins.ERROR_OUT_OF_MEMORY: no memory for the samples, or 4096 logs that live.
    """


@_function(status, log, POINTER(log_info))
def log_get_info(log, info):
    """Tells how many samples a log has, how long it is, and its title."""


@_function(status, log, c_size_t, POINTER(flight_sample), POINTER(c_uint64))
def log_get_sample(log, index, sample, line):
    """The sample `index`, from 0 in the order of the log, ready for sins.push_sample(). line (may be NULL) gets the line
    of the text on which it stands, from 1. No allocation.

    sins.ERROR_INVALID_ARGUMENT: no such sample.
    """


@_function(status, log)
def log_destroy(log):
    """Destroys a flight log.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, sim, _Array(flight_sample, is_input=True), POINTER(requirement), POINTER(options), POINTER(cost))
def recommend(configured, samples, requirement, options, cost):
    """Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples;
    all that are cheaper do not meet it. samples[0].struct_size tells how far apart the samples are.

    configured is a simulator as the host flies it, at any moment of its life: its options and its mounting count. It
    is read at the start of the call and neither stepped nor changed. NULL is the recommended simulator with its
    sensor block at the reference point. options gets the options of configured with scheme, subsamples and
    updates_per_sample of the answer, ready for sins.create(); what these three were does not matter.

    Each algorithm flies the piece with ideal sensors in the same mounting, and its solution is compared at every
    sample with that of a reference, 16 updates of 5 subsamples, whose own uncertainty (what half as many updates
    change) is added. The error is that of the algorithm alone: errors of sensors, altimeter, start, gravity and of
    the believed mounting move both solutions alike and are left out, and so is what the host's samples contradict
    themselves by. sins.SIGNAL_CLOSED_LOOP would hide the error: the signals are without it. For a duration beyond the
    piece its errors go on as steady rates, through Schuler's pendulum: more than the flight will show as long as it
    goes on like the piece. With sins.VERTICAL_FREE each error counts as one of height, which grows by e every 569 s.

    The order of cost is instructions_per_step, so that the same samples have the same answer on every machine and
    every day; ns_per_step alone differs. Not for a real-time frame: it allocates, and takes some 25 to 70 us a
    sample, up to 0.4 ms where nothing meets the requirement.

    sins.REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the one that comes
    closest. sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_TIME_ORDER, sins.ERROR_DISCONTINUITY:
    as sins.push_sample(). sins.ERROR_SINGULAR: geographic axes within reach of a pole. sins.ERROR_DIVERGED: the
    solution of every algorithm left its range. sins.ERROR_OUT_OF_MEMORY. sins.last_error(NULL, ...) on this thread
    tells why, and at which sample.
    """


@_function(status, sim, _Array(flight_sample, is_input=True), POINTER(budget_request), _Array(budget_row), POINTER(c_size_t), POINTER(budget))
def error_budget(configured, samples, request, rows, written, budget):
    """Tells what each effect contributes to the errors of a scene of 2 to 1e9 samples: which ones matter, and which can
    be left out. samples[0].struct_size tells how far apart the samples are, rows[0].struct_size the rows; the others'
    may be 0, those of the rows anything.

    configured is a simulator as the host flies it, at any moment of its life: its options and all that errs in it, of
    the gyros, the accelerometers, the altimeter, the start, the mounting and gravity; failures do not count. It is
    read at the start of the call and neither stepped nor changed. NULL is the recommended simulator, in which nothing
    errs. NULL for request is 16 runs and no limits; written and budget may be NULL.

    An effect is what one field sets; it is active, and has a row, if that is not 0.
    (sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS is none: each effect brings the misalignment along that it causes; nor are
    lever_arm_m and boresight_rad of the mounting: all runs fly with them.) Its contribution is the error, navigation
    less truth, of a run with this effect alone less that of a run with nothing set: the length of the vector in
    position, in velocity and in misalignment, the largest of up to 1000 instants, equally spaced, and that of the
    last sample. Of an effect that is drawn it is the root mean square over the runs sins.options.run, run + 1 and so
    on (sins.BUDGET_RANDOM).

    rows[0] is the mechanization's own error, with what the samples contradict themselves by. The effects follow, the
    largest position first, then velocity, then misalignment; with limits the largest share of a limit first. What is
    not the sum of the rows is in the remainder, draw by draw: effects that act on each other, of second order in
    their sizes.

    With limits the effects are marked that can be left out together (sins.BUDGET_CAN_BE_LEFT_OUT): from the smallest
    share on while the sum of the deterministic contributions, and the root of the sum of squares of the random ones
    times sigma_high, are together, root of the sum of squares, within each limit. Then all is flown again without
    them, in every run; while what that changes, left_out, is beyond a limit, the largest of them comes back.

    But for the ns_per_step the same samples have the same answer on every machine. Not for a real-time frame: it
    allocates, and flies 1 + each deterministic effect + runs times each random effect and all together, with limits
    again runs times and more where effects do not add up; each flight takes 0.6 to 1.5 us a sample.

    sins.ERROR_BUFFER_TOO_SMALL: capacity does not hold the rows; written gets how many there are, nothing is flown
    (rows may be NULL with a capacity of 0, to ask). sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    sins.ERROR_TIME_ORDER, sins.ERROR_DISCONTINUITY: as sins.push_sample(). sins.ERROR_SINGULAR: geographic axes, or
    gyrocompassing, within reach of a pole. sins.ERROR_DIVERGED: a solution left its range. sins.ERROR_OUT_OF_MEMORY.
    sins.last_error(NULL, ...) on this thread tells why, and at which sample.
    """


def text(function, *arguments):
    """What a function writes into a buffer: sins.text(sins.scene_write, scene)."""
    needed = c_size_t()
    function(*arguments, None, needed)
    buffer = ctypes.create_string_buffer(needed.value)
    function(*arguments, buffer, needed)
    return buffer.value.decode()


def array(struct, count):
    """An array of numpy, all zero and with each struct_size set. Its columns are the fields: samples["time_s"]."""
    import numpy

    made = numpy.zeros(count, _dtype(struct))
    made["struct_size"] = ctypes.sizeof(struct)
    return made


def samples_at(flight, times_s):
    """The samples of a flight at these times, as an array of numpy."""
    samples = array(flight_sample, len(times_s))
    each = (flight_sample * len(times_s)).from_buffer(samples)
    for time_s, sample in zip(times_s, each):
        flight_sample_at(flight, time_s, sample)
    return samples


def fly(sim, samples, every=1):
    """Flies an array of samples by run(); an array of the record of each `every` intervals."""
    records = array(record, len(samples) // every + 1 if every else 0)
    written = c_size_t()
    run(sim, samples, every, records, written)
    return records[: written.value]
