"""sins.h for Python 3.9 and later, by ctypes: nothing is compiled.

    import sins

    gyro = sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0))    # fields that are not named are 0: off
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
header, but without the length after an array. NULL is None. An output is an object that the call fills: a struct, a handle, or a
number as ctypes.c_size_t(). A text is str or bytes, in a struct bytes. A status below 0 is raised as sins.Error; other statuses are
returned. Whole numbers that are too large for their type in C are truncated, as everywhere in ctypes.

An array is one of ctypes, or of numpy: sins.array(sins.record, 1000). The library works in the memory of both, without copies.

The library is the file that SINS_LIBRARY in the environment names, or else the one in the folder of this file, or the system's.

This file is written by build.rs from the Rust sources; do not edit it.
"""

import ctypes
import enum
import functools
import os
import sys
from ctypes import POINTER, c_char, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64

# Version of the interface that this header declares: a host compares it with what sins.abi_version() gives. The number
# changes if a part of the interface is removed or changes its meaning. Additions at the end do not change it.
HEADER_ABI = 1
# Major number of this release of the library, by semantic versioning.
VERSION_MAJOR = 0
# Minor number of this release.
VERSION_MINOR = 1
# Patch number of this release.
VERSION_PATCH = 0
# A buffer of this size holds every snapshot of a simulator that this release saves. For a library newer than this header
# ask sins.snapshot_size(); for an ensemble ask sins.ensemble_snapshot_size().
SNAPSHOT_MAX_SIZE = 20480
DEG = 0.017453292519943295  # degree [rad]
ARCMIN = 0.0002908882086657216  # minute of arc [rad]
ARCSEC = 4.84813681109536e-6  # second of arc [rad]
DEG_PER_HOUR = 4.84813681109536e-6  # degree per hour [rad/s]
DEG_PER_SQRT_HOUR = 0.0002908882086657216  # degree per root hour, angle random walk [rad/sqrt(s)]
STANDARD_GRAVITY = 9.80665  # g [m/s2]
MICRO_G = 9.806649999999999e-6  # millionth of g [m/s2]
MICRO_G_PER_SQRT_HZ = 9.806649999999999e-6  # micro-g per root hertz, velocity random walk [(m/s)/sqrt(s)]
PPM = 1e-6  # part per million
KNOT = 0.5144444444444445  # knot [m/s]
NMI = 1852.0  # nautical mile [m]
NMI_PER_HOUR = 0.5144444444444445  # nautical mile per hour [m/s]


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
    """Values of a sins.status: 0 is success, a negative status is an error, a positive status is neither.

    OK: The call did what it says.
    NEED_SAMPLE: There is no sample yet, or no complete interval: push the next sample.
    REQUIREMENT_NOT_MET: sins.recommend(): no options meet the requirement. The outputs hold the options that come
        closest.
    SCENE_HAS_FAULTS: The text of a scene has faults. The handle was made, but only sins.scene_get_fault() and
        sins.scene_destroy() accept it.
    GAP: The sample was accepted, or all samples of the run were flown, but there is a gap: an interval of more
        than 2.5 times each of the two before it. The library assumes that the vehicle moved during the gap: 213 m in
        1 s at 213 m/s. If the vehicle stood still while the host's clock ran on, this is wrong: see sins.move_time().
    ERROR_NULL_POINTER: A pointer is null where null is not allowed.
    ERROR_BAD_HANDLE: The handle is null, made up, destroyed, or of another kind.
    ERROR_STRUCT_SIZE: A struct_size that no release knows, or a struct of a newer release that sets a field which
        this release lacks.
    ERROR_INVALID_ARGUMENT: A value out of its range; sins.last_error() names field, value and limit.
    ERROR_BAD_STATE: A call at the wrong moment, a nested call, or a call on a handle that an abandoned call holds
        (see Threads).
    ERROR_TIME_ORDER: A sample that is not later than the one before, or off the stated sample period.
    ERROR_DISCONTINUITY: The truth jumped: a gap of more than max_gap_s, a jump of position, velocity or attitude,
        or a turn of 170 degrees or more between two samples. See sins.move_truth().
    ERROR_QUEUE_FULL: The queue of samples is full: step first.
    ERROR_DIVERGED: The solution diverged: it left its limits. The last good solution of a simulator stays
        readable; that of a run of an ensemble does not.
    ERROR_SINGULAR: Too close to a pole: the mechanization in geographic axes, or within 64 km an alignment by
        gyrocompassing.
    ERROR_BUFFER_TOO_SMALL: A buffer is too small for the result.
    ERROR_OUT_OF_MEMORY: No memory, or no free handle; on Windows too few TLS indexes (see Unloading).
    ERROR_SNAPSHOT: The bytes are not a snapshot, or are one that is damaged or of a newer release.
    ERROR_INTERNAL: A defect inside the library was caught. This handle returns this status from now on; other
        handles still work.
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
    FRAME_GEOGRAPHIC: Navigation in east-north-up, as in the paper. The mechanization returns sins.ERROR_SINGULAR
        within 6.4 km of a pole. It also returns this error if the vehicle moves in one update by more than 1 % of its
        distance to the pole. For example, at 250 m/s with updates of 1 s this is within 25 km.
    """

    FRAME_EARTH_FIXED = 0
    FRAME_GEOGRAPHIC = 1


@_exported
class scheme(enum.IntEnum):
    """Algorithms of the mechanization.

    SCHEME_EXACT: Coning, sculling and exact rotation compensation; Earth terms from the middle of the update.
    SCHEME_PAPER: The paper's equations (7)-(24), misprints corrected, approximations kept.
    SCHEME_POLYNOMIAL: As sins.SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large
        rotations within an update.
    """

    SCHEME_EXACT = 0
    SCHEME_PAPER = 1
    SCHEME_POLYNOMIAL = 2


@_exported
class vertical(enum.IntEnum):
    """What stabilizes the vertical channel.

    VERTICAL_DAMPED: Third-order loop on a barometric height, time constant 100 s. The response differs from the
        response of a continuous loop by the fraction 3.5e-5 at a sample rate of 1 Hz, and 3.5e-7 at 10 Hz. The
        difference is of second order in the sample interval.
    VERTICAL_FOLLOW_TRUTH: Height and vertical velocity set to the truth at each sample.
    VERTICAL_FREE: Nothing stabilizes the vertical channel: any error grows e-fold every 569 s.
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
    """Whether the library summarizes the true motion.

    SUMMARY_OFF: sins.get_truth_summary() is not available.
    SUMMARY_ON: sins.get_truth_summary() is available. The other outputs have the same bits as without.
    """

    SUMMARY_OFF = 0
    SUMMARY_ON = 1


@_exported
class covariance_mode(enum.IntEnum):
    """Whether the covariance of the navigation errors is propagated.

    COVARIANCE_OFF: sins.get_covariance() is not available.
    COVARIANCE_ON: The covariance is propagated along the truth; the other outputs have the same bits.
    """

    COVARIANCE_OFF = 0
    COVARIANCE_ON = 1


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
    GRAVITY_SOMIGLIANA: Somigliana's formula with the second-order height term, along the ellipsoid normal, as in
        most tools.
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

    SIGNAL_PHYSICAL: Ideal signals are the integrals of the true angular rate and specific force, so the
        navigation shows the mechanization's own error.
    SIGNAL_CLOSED_LOOP: As sins.SIGNAL_PHYSICAL, plus a small trim that keeps an error-free navigator at the truth
        for any time, even with a free vertical channel. It is for hosts that want the errors of the sensors only.
        sins.accuracy reports the size of the trim. If the initial state, a sensor or gravity has errors, the library
        also runs a second navigator without errors to compute the trim. A step then takes longer.
    """

    SIGNAL_PHYSICAL = 0
    SIGNAL_CLOSED_LOOP = 1


@_exported
class error_info_flags(enum.IntFlag):
    """Flags of a sins.error_info.

    ERROR_INFO_VALUE: The field value holds the value at fault.
    ERROR_INFO_MINIMUM: The field minimum holds the least allowed value.
    ERROR_INFO_MAXIMUM: The field maximum holds the greatest allowed value.
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
    SENSOR_ALTIMETER: The altimeter. Give 0 for the argument axis.
    """

    SENSOR_GYRO = 0
    SENSOR_ACCEL = 1
    SENSOR_ALTIMETER = 2


@_exported
class failure_kind(enum.IntEnum):
    """Kinds of failure.

    FAILURE_NONE: No failure: clears the failure that is set.
    FAILURE_STUCK: The output stays at its mean over the interval before the failure, as sins.imu reported it;
        without such an interval, at its first value. It is not flagged, because it looks like valid data.
    FAILURE_DEAD: No signal. A gyro or an accelerometer gives 0, and is flagged sins.IMU_..._INVALID, as by a
        built-in test. Without the altimeter nothing stabilizes the vertical channel of sins.VERTICAL_DAMPED; this is
        flagged sins.NAVIGATION_VERTICAL_UNAIDED.
    FAILURE_BIAS_STEP: An additional bias; its value is in the field `size`. Not flagged.
    FAILURE_SPIKES: Rectangular pulses. The field `size` is their height, duration_s their length. A pulse starts
        every interval_s; the first starts immediately. A sample of the altimeter shows the mean of the pulses over
        the sample interval. A gyro or an accelerometer is flagged only if a pulse saturates it.
    FAILURE_NOISE: Additional white noise; its density is in the field `density`. A sample of the altimeter shows
        the mean of the noise over the sample interval. Not flagged.
    FAILURE_DROP_OUTS: Sample intervals are lost: in each of them the output acts as with sins.FAILURE_DEAD.
        Either each interval is lost independently with the probability in the field `probability`, or one interval is
        lost every interval_s, the first immediately.
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
    ALIGNMENT_LEVEL_AND_GYROCOMPASS: The library computes the attitude that levelling and gyrocompassing at rest
        would find with the sensor errors at the start. It does so even if the flight starts in motion. The INS starts
        with this attitude, turned by the given and the drawn misalignment. Levelling comes first: it finds the tilt
        at which the accelerometers sense no horizontal force. Gyrocompassing then finds the heading at which the
        horizontal gyro rates point north. sins.NAVIGATION_NORTH_UNKNOWN is set if the sensor errors hide north.
        Within 64 km of a pole the start returns sins.ERROR_SINGULAR.
    """

    ALIGNMENT_GIVEN = 0
    ALIGNMENT_LEVEL_AND_GYROCOMPASS = 1


@_exported
class sample_flags(enum.IntFlag):
    """Flags of a sins.flight_sample.

    SAMPLE_ANGULAR_RATE: The sample carries angular_rate_rad_s.
    SAMPLE_SPECIFIC_FORCE: The sample carries specific_force_m_s2.
    SAMPLE_NO_VELOCITY: The sample has no velocity. The library derives it from positions. The noise of this
        velocity is 2 to 4 times the position noise of a sample, divided by the interval.
    SAMPLE_TEMPERATURE: The sample carries temperature_c.
    """

    SAMPLE_ANGULAR_RATE = 1
    SAMPLE_SPECIFIC_FORCE = 2
    SAMPLE_NO_VELOCITY = 4
    SAMPLE_TEMPERATURE = 8


@_exported
class navigation_flags(enum.IntFlag):
    """Flags of a sins.navigation.

    NAVIGATION_NEAR_POLE: Within 20 km of the Earth's axis: longitude and heading change fast there, and at the
        pole they are undefined. Quaternion, height and the errors in metres stay correct.
    NAVIGATION_VERTICAL_UNAIDED: Nothing aids the vertical channel, because of the options or because the
        altimeter has no signal: any error grows e-fold every 569 s.
    NAVIGATION_INCONSISTENT: A flag of the truth. Let d be the displacement computed from the velocities. The flag
        is set if the displacement of the positions since the previous sample differs from d by more than sqrt((0.01
        d)^2 + (1 cm)^2).
    NAVIGATION_NORTH_UNKNOWN: The alignment at the start could not find north, so any heading error is possible.
        Either the accelerometers show no force, or the error of the horizontal gyro rates is at least as large as the
        north component of the Earth rate. (If it is smaller, the heading error is below 90 degrees.) The flag stays
        until the INS starts again. Note: a real INS does not know this error. It can be sure that it has not found
        north only if its horizontal gyro rate is more than twice the north component of the Earth rate.
    """

    NAVIGATION_NEAR_POLE = 1
    NAVIGATION_VERTICAL_UNAIDED = 2
    NAVIGATION_INCONSISTENT = 4
    NAVIGATION_NORTH_UNKNOWN = 8


@_exported
class imu_flags(enum.IntFlag):
    """Flags of a sins.imu.

    IMU_GYRO_SATURATED: The mean rate of a subsample was beyond the range of a gyro.
    IMU_ACCEL_SATURATED: The mean force of a subsample was beyond the range of an accelerometer.
    IMU_GYRO_INVALID: A gyro had no signal in the interval: dead, or dropped out. The mechanization continues with
        the output 0 of this gyro.
    IMU_ACCEL_INVALID: An accelerometer had no signal in the interval: dead, or dropped out. The mechanization
        continues with the output 0 of this accelerometer.
    """

    IMU_GYRO_SATURATED = 1
    IMU_ACCEL_SATURATED = 2
    IMU_GYRO_INVALID = 4
    IMU_ACCEL_INVALID = 8


@_exported
class errors_source(enum.IntEnum):
    """The two sources of errors.

    ERRORS_NAVIGATION: Navigation minus truth: the paper's error data 2.
    ERRORS_MODEL: The error differential equations: the paper's error data 1 (sins.options.error_model).
    """

    ERRORS_NAVIGATION = 0
    ERRORS_MODEL = 1


@_exported
class errors_flags(enum.IntFlag):
    """Flags of a sins.errors.

    ERRORS_NEAR_POLE: The truth is within 20 km of the Earth's axis: the errors of longitude and heading, the up
        misalignment, and the east and north components of the velocity error have no meaning.
    ERRORS_OUTSIDE_VALIDITY: A flag of the error model: the terms that it neglects are no longer small. The
        misalignment is above 2 degrees, or the position error is above 100 km, or, at high latitude, above 3.5 % of
        the distance to the pole.
    ERRORS_NOT_COMPUTED: In a sins.record: not computed, all zero.
    """

    ERRORS_NEAR_POLE = 1
    ERRORS_OUTSIDE_VALIDITY = 2
    ERRORS_NOT_COMPUTED = 4


@_exported
class grade(enum.IntEnum):
    """Grades of sensors.

    GRADE_STRATEGIC: Strategic: gyro bias 0.001 deg/h and accelerometer bias 1e-6 g, each 1 sigma (El-Sheimy and
        Youssef 2020, table 1, upper ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm
        (Airbus Astrix 200).
    GRADE_NAVIGATION: Navigation: Honeywell HG9900, brochure N61-1638. It states no accelerometer noise, so the
        preset has none: set your own.
    GRADE_TACTICAL: Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated.
    GRADE_INDUSTRIAL: Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D. It states no
        accelerometer noise, so the preset has none: set your own. The range of the sensors is 125 deg/s and 8 g; the
        angle between two axes differs from 90 deg by 0.1 deg, 1 sigma.
    GRADE_CONSUMER: Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances
        are taken as 3 sigma.
    GRADE_PAPER_SIMULATION2: The paper's simulation 2: constant gyro bias 0.01 deg/h and angle random walk 0.005
        deg/sqrt(h), constant accelerometer bias 1e-5 g and white noise 5e-6 g, taken as a density of 5e-6 g/sqrt(Hz)
        (for a bandwidth of 1 Hz, because the paper states none).
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
    MANOEUVRE_ACCELERATE: Changes the speed by speed_change_m_s in duration_s.
    MANOEUVRE_CLIMB: Changes the height by height_change_m in duration_s. Uses ramp_s.
    MANOEUVRE_TURN: Level coordinated turn by heading_change_rad (right positive) at bank_rad, with ramp_s to roll
        in and to roll out. The duration follows from these.
    MANOEUVRE_ROLL: Whole rolls along a straight path in duration_s; the field turns is their number (positive:
        right wing down).
    MANOEUVRE_LOOP: Whole vertical loops at constant speed in duration_s; the field turns is their number (nose up
        positive). Uses ramp_s.
    MANOEUVRE_S_TURN: The course swings by heading_change_rad to both sides, first to the right if it is positive.
        The field turns is the number of swings in duration_s. A swing is a full period: to one side, to the other
        side, and back. Uses ramp_s.
    MANOEUVRE_SINUSOIDS: Sum of sinusoid_count sinusoids for duration_s: patrol patterns, rocking, coning,
        vibration. Uses ramp_s.
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

    SCENE_FLIGHT_MANOEUVRES: The flight is composed of manoeuvres.
    SCENE_FLIGHT_BUILTIN: The flight is that of a built-in scene, named by sins.SCENE_TEXT_BUILTIN.
    SCENE_FLIGHT_LOG: The flight is a log, named by sins.SCENE_TEXT_LOG.
    """

    SCENE_FLIGHT_MANOEUVRES = 0
    SCENE_FLIGHT_BUILTIN = 1
    SCENE_FLIGHT_LOG = 2


@_exported
class scene_text(enum.IntEnum):
    """The texts of a scene: sins.scene_get_text(), sins.scene_set_text().

    SCENE_TEXT_TITLE: Title: the scene in a few words.
    SCENE_TEXT_LOG: Path of the flight log, relative to the scene's own folder. Setting it makes the flight a log.
    SCENE_TEXT_BUILTIN: Name of the built-in scene whose flight is flown. Setting it selects that flight.
    SCENE_TEXT_FOLDER: Folder of the output files of a program.
    SCENE_TEXT_NAME: Base name of the output files.
    SCENE_TEXT_IMU: Name of the file for the measured increments.
    """

    SCENE_TEXT_TITLE = 0
    SCENE_TEXT_LOG = 1
    SCENE_TEXT_BUILTIN = 2
    SCENE_TEXT_FOLDER = 3
    SCENE_TEXT_NAME = 4
    SCENE_TEXT_IMU = 5


@_exported
class scene_key_kind(enum.IntEnum):
    """What kind of value a key of a scene takes.

    SCENE_KEY_NUMBERS: Numbers; elements says how many.
    SCENE_KEY_WHOLE: A whole number, not negative.
    SCENE_KEY_WORD: One of several words.
    SCENE_KEY_TEXT: A text.
    SCENE_KEY_FLAG: true or false.
    """

    SCENE_KEY_NUMBERS = 0
    SCENE_KEY_WHOLE = 1
    SCENE_KEY_WORD = 2
    SCENE_KEY_TEXT = 3
    SCENE_KEY_FLAG = 4


@_exported
class scene_key_flags(enum.IntFlag):
    """Flags of a sins.scene_key.

    SCENE_KEY_IN_LIST: The key belongs to the items of a list: its section stands in double brackets.
    SCENE_KEY_LIMITS: The fields minimum and maximum are the limits of each number. Without this flag there are no
        limits, or the limits depend on other values.
    SCENE_KEY_ZERO_IS_OFF: 0 is allowed in addition to the values within the limits. It switches the quantity off.
    """

    SCENE_KEY_IN_LIST = 1
    SCENE_KEY_LIMITS = 2
    SCENE_KEY_ZERO_IS_OFF = 4


@_exported
class budget_flags(enum.IntFlag):
    """Flags of a sins.budget_row.

    BUDGET_RANDOM: The figures of the row are standard deviations (1 sigma), from linear error equations.
    BUDGET_CAN_BE_LEFT_OUT: The effect can be left out, together with all others that have this flag.
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
    """Options of a simulator. All zero (except struct_size) is the recommended simulator.

    frame: Axes of the mechanization, of enum sins.frame.
    scheme: Algorithm of the mechanization, of enum sins.scheme.
    subsamples: Number of subsamples of a mechanization update, 1 to 5; 0: 2. A subsample is one of the equal
        parts of the update; the sensors give one increment for each.
    updates_per_sample: Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (see
        "Gaps" above).
    vertical: Vertical channel, of enum sins.vertical.
    error_model: Error differential equations, of enum sins.error_model.
    earth: Ellipsoid, of enum sins.earth.
    gravity: Normal gravity, of enum sins.gravity.
    axes: Directions of the body axes and of the sensor axes, of enum sins.axes.
    signal: Ideal signals, of enum sins.signal.
    seed: Seed of all random streams.
    run: Run number. The same seed with another run number gives other random numbers. Run k of an ensemble has
        the number k.
    closed_loop_time_s: Time constant of sins.SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0:
        30 s, for which max_gap_s must be at most 7.5 s. Must be 0 with another signal.
    sample_period_s: Stated sample period, 5e-5 to max_gap_s [s]; 0: the samples' own time stamps count. With a
        stated period, each sample is at an exact multiple of the period from the first. The time stamps then serve
        only to order and to check the samples: each must be within 0.4 of a period of its multiple.
    max_gap_s: Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Use intervals of minutes only for a
        vehicle at rest. Even at rest the position error grows with the third power of the interval: within 12 h it
        reaches 0.09 m with intervals of 10 s, and 91 m with intervals of 100 s.
    max_acceleration_m_s2: Largest mean acceleration between two samples, 1e-3 to 1e6 [m/s2]; 0: 2000 m/s2. A
        larger one is rejected as a jump of the truth.
    truth_summary: Summary of the true motion, of enum sins.summary.
    covariance: Covariance of the navigation errors, of enum sins.covariance_mode.
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
        ("covariance", c_int32),
    ]


class flight_sample(_Struct):
    """True motion of the vehicle at an instant, as a flight simulator gives it. The ideal signals are computed from
    velocity and attitude, and from angular rate and specific force if the sample carries them. Position enters only
    through gravity and curvature, unless the samples have no velocity: then the velocity is derived from the
    positions. Vibration above a tenth of the sample rate cannot be recovered from samples; give angular rate and
    specific force if you have them.

    flags: Flags of enum sins.sample_flags, or'ed.
    time_s: Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins.options.max_gap_s. Large
        stamps are coarse (1.2e-7 s at 1e9 s): state sins.options.sample_period_s with them.
    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -100 to 100 [rad]; whole turns do not matter.
    height_m: Height above the ellipsoid, -2e4 to 2e6 [m].
    velocity_enu_m_s[3]: Velocity against the Earth, east-north-up, each -2e4 to 2e4 [m/s].
    roll_rad: Roll, right wing down positive, -1e4 to 1e4 [rad]; whole turns do not matter.
    pitch_rad: Pitch, nose up positive, -1e4 to 1e4 [rad]; it may go beyond 90 degrees. From one sample to the
        next the attitude must turn by less than 170 degrees. The library predicts this turn from the angular rates of
        the samples, or, without rates, from the previous interval. The turn must differ from the prediction by less
        than 180 degrees. Additional whole turns between two samples cannot be detected.
    heading_rad: Heading, clockwise from true north, -1e4 to 1e4 [rad]; whole turns do not matter.
    angular_rate_rad_s[3]: With sins.SAMPLE_ANGULAR_RATE: angular rate of the vehicle against inertial space along
        the body axes at this instant, each -1000 to 1000 [rad/s].
    specific_force_m_s2[3]: With sins.SAMPLE_SPECIFIC_FORCE: specific force at the reference point along the body
        axes at this instant, each -1e5 to 1e5 [m/s2].
    temperature_c: With sins.SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant,
        -273.15 to 1000 [deg C]; linear from one sample to the next. Needed while temperature coefficients are set:
        the push of a sample without it then returns sins.ERROR_INVALID_ARGUMENT, because a forgotten flag would
        silently disable the effect.
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
    """Why a call failed: the data of which the sentence of sins.last_error() is made.

    flags: Flags of enum sins.error_info_flags, or'ed.
    status: Status that the failed call returned, of enum sins.status_code; sins.OK if no call failed.
    field[96]: Name of the field or argument at fault, such as "gyro.markov_time_s", or of a computed quantity at
        fault, such as "navigated position error [m]"; terminated. Empty if the call itself is at fault.
    index: Element of the field, from 0; -1: the field is not an array, or the whole field is at fault.
    sample: Index of the sample in the array of the call, from 0; -1: no sample is at fault.
    value: With sins.ERROR_INFO_VALUE: the value at fault, which may be NaN or infinite; for an integer, the
        nearest double.
    minimum: With sins.ERROR_INFO_MINIMUM: the least value. If the sentence of sins.last_error() says "more than",
        the limit itself is not allowed.
    maximum: With sins.ERROR_INFO_MAXIMUM: the greatest value. If the sentence of sins.last_error() says "less
        than", the limit itself is not allowed.
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

    Effects act in this order, along the path of the signal: bandwidth; then errors that depend on the signal (scale
    factor, misalignment, asymmetry, nonlinearity), on the true specific force (g-sensitivity, g2-sensitivity) and on
    temperature; then biases and noise; then dead zone, range, quantization.

    Asymmetry, nonlinearity, dead zone and range, g2-sensitivity of the gyros, and vibration rectification of the
    accelerometers act on the mean signal of a subsample, whose length is dt = interval / (updates_per_sample *
    subsamples). The mean reduces the effect of a vibration of frequency f. With x = pi f dt, nonlinearity and
    rectification are too small by the fraction 1 - (sin x / x)^2. Asymmetry is too small by up to the fraction 1 -
    cos x, if the vibration changes the sign of the signal. If f is a tenth of the sample rate, these fractions are
    0.8 % and 1.2 % with two subsamples per interval, 3.2 % and 4.9 % with one.

    bias_rad_s[3]: Constant bias, measured less true [rad/s], -100 to 100.
    bias_sigma_rad_s[3]: Standard deviation of the turn-on bias, drawn once a run [rad/s], 0 to 100.
    markov_sigma_rad_s[3]: Standard deviation of the first-order Gauss-Markov bias [rad/s], 0 to 100. The process
        is stationary from the first sample on.
    markov_time_s[3]: Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_rad_s
        is not 0.
    random_walk_rad_sqrt_s[3]: White noise N: angle random walk [rad/sqrt(s)], 0 to 100. It is the square root of
        the spectral density of the noise, in the unit of the signal per sqrt(Hz).
    rate_random_walk_rad_s_sqrt_s[3]: Rate random walk K [(rad/s)/sqrt(s)], 0 to 100. It starts at 0 at the start
        of a run.
    rate_ramp_rad_s2[3]: Ramp R: bias that grows with time [rad/s2], -100 to 100. The bias starts at 0 when the
        ramp is switched on, and at sins.reset(). If R is changed in flight, the bias continues from its present
        value.
    flicker_rad_s[3]: Flicker noise, bias instability B [rad/s], 0 to 100. The process is stationary from the
        first sample on: the Allan deviation is flat at 0.664 B from 2 s to 50 h.
    scale_factor[3]: Scale factor error [1], -1 to 1.
    scale_factor_sigma[3]: Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It
        is added to scale_factor.
    scale_factor_asymmetry[3]: Scale factor error for positive signals less that for negative signals [1], -1 to
        1. The error of a signal s is half of this times |s|.
    scale_factor_nonlinearity_s_rad[3]: Scale factor error that grows with the size of the signal [s/rad], -1 to
        1. The error of a signal s is this times s |s|.
    misalignment_rad[9]: Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error
        of sensor i is the sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
    misalignment_sigma_rad[9]: Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It
        is added to misalignment_rad. The diagonal must be 0.
    g_sensitivity_rad_s_per_m_s2[9]: Drift caused by specific force, g-sensitivity: row = gyro, column = axis of
        the force [(rad/s)/(m/s2)], -1 to 1. The error of a gyro is the sum over the three axes of its row times the
        true specific force along them.
    g2_sensitivity_rad_s_per_m2_s4[3]: Drift caused by the square of the specific force along the gyro's own axis,
        g2-sensitivity [(rad/s)/(m/s2)^2], -1 to 1. The rate error of gyro i is element i times the square of the true
        specific force along sensor axis i, at the point of the sensor block (see sins.mounting). So a positive
        element makes a drift in the positive sense about the axis, whatever the sign of the force. The mean force of
        a subsample is squared, as with nonlinearity.
    reference_temperature_c: Temperature at which the four temperature coefficients have no effect [deg C],
        -273.15 to 1000. T is sins.flight_sample.temperature_c less this temperature. If one of the coefficients is
        not 0, every sample needs a temperature, and sins.push_imu() is not available.
    bias_temperature_rad_s_per_k[3]: Bias per kelvin [(rad/s)/K], -100 to 100. The bias is this coefficient times
        T.
    bias_temperature2_rad_s_per_k2[3]: Bias per kelvin squared [(rad/s)/K2], -100 to 100. The bias is this
        coefficient times T squared.
    scale_factor_temperature_per_k[3]: Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is
        this coefficient times T.
    scale_factor_temperature2_per_k2[3]: Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor
        error is this coefficient times T squared.
    bandwidth_hz[3]: Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter
        starts in its steady state, so there is no transient in the first interval.
    dead_zone_rad_s[3]: Half the dead zone: signals up to this size give 0 [rad/s], 0 to 100.
    range_rad_s[3]: Range, where the output saturates [rad/s], 1e-9 to 1e6; 0: none. Saturation is flagged in
        sins.imu.
    quantization_rad[3]: Quantum (pulse weight) of the output increments [rad], 1e-15 to 1; 0: none. The remainder
        goes into the next increment. The quantization noise Q is quantum/sqrt(12).
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

    Effects act in this order, along the path of the signal: size effect, bandwidth; then errors that depend on the
    signal (scale factor, misalignment, asymmetry, nonlinearity, vibration rectification) and on temperature; then
    biases and noise; then dead zone, range, quantization. sins.gyro_params describes the effects that act on the mean
    of a subsample.

    bias_m_s2[3]: Constant bias, measured less true [m/s2], -10000 to 10000.
    bias_sigma_m_s2[3]: Standard deviation of the turn-on bias, drawn once a run [m/s2], 0 to 10000.
    markov_sigma_m_s2[3]: Standard deviation of the first-order Gauss-Markov bias [m/s2], 0 to 10000. The process
        is stationary from the first sample on.
    markov_time_s[3]: Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_m_s2
        is not 0.
    velocity_random_walk_m_s_sqrt_s[3]: White noise N: velocity random walk [(m/s)/sqrt(s)], 0 to 10000. It is the
        square root of the spectral density of the noise, in the unit of the signal per sqrt(Hz).
    acceleration_random_walk_m_s2_sqrt_s[3]: Acceleration random walk K [(m/s2)/sqrt(s)], 0 to 10000. It starts at
        0 at the start of a run.
    ramp_m_s3[3]: Ramp R: bias that grows with time [m/s3], -10000 to 10000. The bias starts at 0 when the ramp is
        switched on, and at sins.reset(). If R is changed in flight, the bias continues from its present value.
    flicker_m_s2[3]: Flicker noise, bias instability B [m/s2], 0 to 10000. The process is stationary from the
        first sample on: the Allan deviation is flat at 0.664 B from 2 s to 50 h.
    scale_factor[3]: Scale factor error [1], -1 to 1.
    scale_factor_sigma[3]: Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It
        is added to scale_factor.
    scale_factor_asymmetry[3]: Scale factor error for positive signals less that for negative signals [1], -1 to
        1. The error of a signal s is half of this times |s|.
    scale_factor_nonlinearity_s2_m[3]: Scale factor error that grows with the size of the signal [s2/m], -1 to 1.
        The error of a signal s is this times s |s|.
    misalignment_rad[9]: Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error
        of sensor i is the sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
    misalignment_sigma_rad[9]: Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It
        is added to misalignment_rad. The diagonal must be 0.
    vibration_rectification_s2_m[3]: Vibration rectification, the g2 term [s2/m], -1 to 1. The error is this times
        the square of the mean force of a subsample. So a vibration with the root mean square r causes a bias of this
        times r squared.
    lever_arm_m[9]: Lever arm of each accelerometer from the point of the sensor block, sensor axes, row = sensor
        (size effect) [m], -100 to 100. The point of the sensor block is where the lever arm of sins.mounting ends. If
        a flight starts in motion, samples without an angular rate do not show the angular acceleration of the first
        interval (see sins.mounting). The measured velocity is then wrong for the rest of the flight: it lacks the
        lever arm times the change of the angular rate in the first interval. With sins.push_imu() the angular
        acceleration follows from the previous increments.
    reference_temperature_c: Temperature at which the four temperature coefficients have no effect [deg C],
        -273.15 to 1000. T is sins.flight_sample.temperature_c less this temperature. If one of the coefficients is
        not 0, every sample needs a temperature, and sins.push_imu() is not available.
    bias_temperature_m_s2_per_k[3]: Bias per kelvin [(m/s2)/K], -10000 to 10000. The bias is this coefficient
        times T.
    bias_temperature2_m_s2_per_k2[3]: Bias per kelvin squared [(m/s2)/K2], -10000 to 10000. The bias is this
        coefficient times T squared.
    scale_factor_temperature_per_k[3]: Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is
        this coefficient times T.
    scale_factor_temperature2_per_k2[3]: Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor
        error is this coefficient times T squared.
    bandwidth_hz[3]: Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter
        starts in its steady state, so there is no transient in the first interval.
    dead_zone_m_s2[3]: Half the dead zone: signals up to this size give 0 [m/s2], 0 to 10000.
    range_m_s2[3]: Range, where the output saturates [m/s2], 1e-9 to 1e6; 0: none. Saturation is flagged in
        sins.imu.
    quantization_m_s[3]: Quantum (pulse weight) of the output increments [m/s], 1e-15 to 1; 0: none. The remainder
        goes into the next increment. The quantization noise Q is quantum/sqrt(12).
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
    """Errors of the barometric altimeter, whose height damps the vertical channel. All zero is an ideal altimeter.

    bias_m: Constant bias, -1e5 to 1e5 [m].
    markov_sigma_m: Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on,
        0 to 1e5 [m].
    markov_time_s: Correlation time of the Gauss-Markov error, 1e-9 to 1e15 [s]; needed where markov_sigma_m is
        not 0.
    noise_m: Standard deviation of the independent error of each sample, 0 to 1e5 [m].
    scale_factor: Scale factor error of the height [1], -1 to 1.
    lag_s: Time constant of the first-order lag of the static pressure, 0 to 1e6 [s].
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
    """A failure of one output of a sensor. All zero is no failure. Fields that the kind does not use must be 0. The unit
    u is rad/s for a gyro, m/s2 for an accelerometer, m for the altimeter.

    kind: Kind of the failure, of enum sins.failure_kind.
    size: Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the
        altimeter [u].
    density: Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the
        altimeter [u sqrt(s)].
    interval_s: Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for
        drop-outs with a probability.
    duration_s: Spikes: length of one spike, 1e-9 s to interval_s [s].
    probability: Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1.
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
    """Errors with which the navigation starts: computed less true, east-north-up. Random errors with the standard
    deviations (sigma) are drawn once a run and added. A reset and a reposition use the same random numbers again.
    With sins.VERTICAL_FOLLOW_TRUTH the errors of height and vertical velocity start at 0. Limits: position errors 1e6
    m, velocity errors 1e4 m/s, their standard deviations 1e5 m and 1e3 m/s.

    position_enu_m[3]: Position error [m].
    velocity_enu_m_s[3]: Velocity error [m/s].
    misalignment_enu_rad[3]: Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x])
        C0. C turns vectors from sensor axes to east-north-up. C0 is the true C. With
        sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS, C0 is the C that the alignment finds.
    position_sigma_enu_m[3]: Standard deviation of the position error [m].
    velocity_sigma_enu_m_s[3]: Standard deviation of the velocity error [m/s].
    misalignment_sigma_enu_rad[3]: Standard deviation of the misalignment, 0 to 1 [rad].
    alignment: Alignment at the start, of enum sins.alignment.
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
    """Position and attitude of the sensor block relative to the reference point of the flight samples, and the errors of
    what the INS believes about them: believed = true + error, component by component. All zero is a block at the
    reference point, along the body axes.

    The ideal sensors measure the motion of the block, and sensor errors act in the axes of the block: sins.imu
    describes the block. The INS navigates the block, and converts its solution to the reference point with the
    mounting that it believes: sins.navigation and sins.errors describe the reference point. Initial errors apply to
    the solution for the block, so at the start sins.errors can differ from them. Angular rate and specific force of a
    sample are those of the reference point, along body axes. The barometric height is that of the reference point
    too.

    Start in motion: at the start of a moving flight, and after a reposition, samples without an angular rate do not
    show the angular acceleration of the first interval. The specific force of a block away from the reference point
    then lacks the term angular acceleration times lever arm. In the second interval this term is correct to first
    order in the interval's length, in the third to second order, later to third order. The navigation is not
    affected, because the INS starts with the velocity that the block has at the mean angular rate of the first
    interval. With sins.SAMPLE_ANGULAR_RATE no term is missing.

    lever_arm_m[3]: Lever arm from the reference point to the block, body axes (sins.options.axes), -100 to 100
        [m].
    boresight_rad[3]: Boresight: roll, pitch and heading of the block's axes relative to the body axes [rad]. They
        are defined like the attitude angles of the body: positive roll right side down, positive pitch nose up,
        positive heading nose to the right. Each is -1e4 to 1e4; whole turns do not matter.
    lever_arm_error_m[3]: Believed less true lever arm, -100 to 100 [m].
    boresight_error_rad[3]: Believed less true boresight angles, -pi to pi [rad]. If the believed heading is too
        large, the heading that the INS reports is too small by the same amount.
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
    """Gravity disturbance: true gravity less the normal gravity that the INS computes, at the same point. The horizontal
    part is the deflection of the vertical. The vertical part is called anomaly here. Each has a constant part and a
    random part. The random part is a first-order Gauss-Markov field along the track: correlation sigma^2 exp(-d/D)
    over the distance d flown over ground. At rest it does not change. All zero is normal gravity.

    Perfect accelerometers measure the disturbance, so it is in the ideal signals of sins.imu. In the INS it acts like
    an accelerometer error. At rest, without a levelled start, a deflection xi makes the position error oscillate
    between 0 and 2 R xi, where R is the Earth's radius. A levelled start (sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS) is
    tilted by the deflection.

    deflection_north_rad: Deflection in the meridian (xi): astronomic less geodetic latitude, -0.01 to 0.01 [rad].
        If positive, the true zenith lies north of the ellipsoid's normal, and the accelerometers at rest measure g
        times this to the north.
    deflection_north_sigma_rad: Standard deviation of the random part of the deflection in the meridian, 0 to 0.01
        [rad].
    deflection_north_distance_m: Correlation distance D of that random part, 1 to 1e9 [m]; needed where its
        standard deviation is not 0.
    deflection_east_rad: Deflection in the prime vertical (eta): astronomic less geodetic longitude, times the
        cosine of latitude, -0.01 to 0.01 [rad]. If positive, the true zenith lies east of the ellipsoid's normal.
    deflection_east_sigma_rad: Standard deviation of the random part of the deflection in the prime vertical, 0 to
        0.01 [rad].
    deflection_east_distance_m: Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard
        deviation is not 0.
    anomaly_m_s2: Anomaly, excess of gravity, -0.1 to 0.1 [m/s2]. A milligal is 1e-5 m/s2.
    anomaly_sigma_m_s2: Standard deviation of the random part of the anomaly, 0 to 0.1 [m/s2].
    anomaly_distance_m: Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard
        deviation is not 0.
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

    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -pi to pi [rad].
    height_m: Height above the ellipsoid [m].
    velocity_enu_m_s[3]: Velocity against the Earth, east-north-up [m/s].
    roll_rad: Roll, right wing down positive, -pi to pi [rad].
    pitch_rad: Pitch, nose up positive, -pi/2 to pi/2 [rad].
    heading_rad: Heading, clockwise from true north, 0 to 2 pi [rad].
    quaternion_nb[4]: Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes
        while navigating on increments.
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
        ("reserved2", c_uint32),
    ]


class record_errors(_Struct):
    """Errors within a sins.record; never grows. Fields as in sins.errors.

    position_enu_m[3]: Position error: displacement from truth along true east and north, and difference of
        heights [m].
    latitude_rad: Error of latitude [rad].
    longitude_rad: Error of longitude, wrapped to -pi to pi [rad].
    height_m: Error of height [m].
    velocity_enu_m_s[3]: Velocity error [m/s]: components of the computed velocity in the east-north-up axes at
        the computed position, less components of the true velocity in the axes at the true position.
    misalignment_enu_rad[3]: Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C
        turns vectors from body axes to east-north-up. In the error model it is of first order: computed C = (I - [phi
        x]) true C.
    roll_rad: Error of roll, wrapped to -pi to pi [rad].
    pitch_rad: Error of pitch [rad].
    heading_rad: Error of heading, wrapped to -pi to pi [rad].
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
        ("reserved2", c_uint32),
    ]


class record(_Struct):
    """Truth, navigation and both errors at one instant.

    time_s: Time [s].
    truth: The truth, as sins.get_truth() gives it.
    navigation: The navigated solution, as sins.get_navigation() gives it.
    navigation_errors: Error data 2, as sins.get_errors() gives it with sins.ERRORS_NAVIGATION.
    model_errors: Error data 1, as sins.get_errors() gives it with sins.ERRORS_MODEL; flagged
        sins.ERRORS_NOT_COMPUTED while the model is off.
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
    quaternion_nb[4]: Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes
        while navigating on increments.
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
    ideal_angle_rad[3]: Integral of the angular rate against inertial space, as perfect gyros measure it [rad].
    ideal_velocity_m_s[3]: Integral of the specific force, as perfect accelerometers measure it [m/s].
    measured_angle_rad[3]: Integral of the angular rate that the modelled gyros measure [rad].
    measured_velocity_m_s[3]: Integral of the specific force that the modelled accelerometers measure [m/s].
    ideal_rate_rad_s[3]: Mean angular rate of perfect gyros: ideal_angle_rad divided by interval_s [rad/s].
    ideal_force_m_s2[3]: Mean specific force of perfect accelerometers: ideal_velocity_m_s divided by interval_s
        [m/s2].
    measured_rate_rad_s[3]: Mean angular rate of the modelled gyros: measured_angle_rad divided by interval_s
        [rad/s].
    measured_force_m_s2[3]: Mean specific force of the modelled accelerometers: measured_velocity_m_s divided by
        interval_s [m/s2].
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
    position_enu_m[3]: Position error: displacement from truth along true east and north, and difference of
        heights [m].
    latitude_rad: Error of latitude [rad].
    longitude_rad: Error of longitude, wrapped to -pi to pi [rad].
    height_m: Error of height [m].
    velocity_enu_m_s[3]: Velocity error [m/s]: components of the computed velocity in the east-north-up axes at
        the computed position, less components of the true velocity in the axes at the true position.
    misalignment_enu_rad[3]: Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C
        turns vectors from body axes to east-north-up. In the error model it is of first order: computed C = (I - [phi
        x]) true C.
    roll_rad: Error of roll, wrapped to -pi to pi [rad].
    pitch_rad: Error of pitch [rad].
    heading_rad: Error of heading, wrapped to -pi to pi [rad].
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
    """Running figures of the flight since its start or last reposition; sins.move_time() and sins.move_truth() do not
    restart them. The figures use the errors once a second. They describe one run, not an ensemble. To get nautical
    miles per hour, divide a rate by sins.NMI_PER_HOUR.

    time_s: Time [s].
    duration_s: Time since the start [s].
    window_start_s: Start of the window of the radial error rates, as time since the start: 300 [s]. Earlier rates
        would be initial errors divided by a very short time.
    window_samples: Number of errors (one a second) in the window of the radial error rates. While it is 0, the
        rates are 0.
    radial_error_rate_rms_m_s: Root mean square of the radial error rate, sqrt(mean RER^2), with RER = horizontal
        position error / time since the start [m/s].
    cep_rate_m_s: R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s].
    radial_95_rate_m_s: R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s].
    radial_error_slope_m_s: Slope of the least-squares line (with an intercept) through the horizontal position
        errors of the window [m/s].
    velocity_rms_enu_m_s[3]: Root mean square velocity error since the start, east-north-up; samples within 20 km
        of the Earth's axis, where east and north turn fast, are left out [m/s].
    closure_position_enu_m[3]: Position closure: the position error now, navigation minus truth [m].
    closure_velocity_enu_m_s[3]: Velocity closure: the velocity error now, navigation minus truth [m/s].
    host_position_enu_m[3]: Part of the horizontal position error that the host causes, because its velocities
        contradict its positions [m]. Let d be the displacement from the velocities less the displacement from the
        positions. The field is the response of a Schuler oscillator to d; up is 0. The rest of the position error is
        caused by the simulator and the sensors.
    host_velocity_enu_m_s[3]: Part of the horizontal velocity error that the host causes in this way; up is 0
        [m/s].
    inconsistency_enu_m[3]: Displacement from the host's velocities less displacement from its positions, summed
        over the flight [m].
    inconsistency_max_m: Largest difference, in one interval, between the displacement from the host's velocities
        and the displacement from its positions [m].
    inconsistent_samples: Number of samples flagged sins.NAVIGATION_INCONSISTENT.
    intervals: Number of intervals flown since the start or the last reposition.
    trim_rate_max_rad_s: Largest trim that sins.SIGNAL_CLOSED_LOOP added to the angular rate, later than ten times
        closed_loop_time_s after the start [rad/s]. It shows the error of the signal generator and the mechanization
        themselves. 0 with physical signals.
    trim_force_max_m_s2: Largest trim that sins.SIGNAL_CLOSED_LOOP added to the specific force, likewise [m/s2].
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
    """Extreme values of the true motion over all intervals since the create or the last sins.reset(). Wrong units and
    exchanged axes give values that no vehicle has, so these figures reveal them. Attitudes in degrees turn 57 times
    too fast, and give arbitrary sideslips. Exchanged east and north give a sideslip, and velocities that contradict
    the positions. Knots instead of m/s contradict the positions too. Feet instead of metres give heights and climbs
    3.3 times too large. Accelerations are means from one sample to the next. So are rates and forces, unless the
    samples carry them; then they are the values at the samples. Each ..._at_s is the time stamp of the sample at
    which the value was found.

    intervals: Number of intervals flown.
    gaps: Number of intervals that are gaps (see sins.GAP).
    fast_samples: Number of samples with a speed of more than 30 m/s. Sideslip and angle of attack are taken from
        these only.
    flown_s: Sum of the lengths of the intervals [s].
    first_s: Time stamp of the first sample [s].
    last_s: Time stamp of the last sample [s].
    interval_max_s: Longest interval [s].
    interval_max_at_s: Time stamp of interval_max_s [s].
    turn_max_rad: Largest rotation in an interval [rad].
    turn_max_at_s: Time stamp of turn_max_rad [s].
    rate_max_rad_s: Largest angular rate: from the attitudes against the Earth, or the samples' own rate [rad/s].
    rate_max_at_s: Time stamp of rate_max_rad_s [s].
    acceleration_max_m_s2: Largest acceleration against the Earth, from the velocities [m/s2].
    acceleration_max_at_s: Time stamp of acceleration_max_m_s2 [s].
    force_max_m_s2: Largest specific force: from the velocities and gravity, or the samples' own force [m/s2].
    force_max_at_s: Time stamp of force_max_m_s2 [s].
    inconsistency_max_m: Largest difference, in one interval, between the displacement from the positions and the
        displacement from the velocities (the mean of the velocities at the two ends, times the length of the
        interval) [m].
    inconsistency_max_at_s: Time stamp of inconsistency_max_m [s].
    speed_max_m_s: Largest speed against the Earth [m/s].
    speed_max_at_s: Time stamp of speed_max_m_s [s].
    sideslip_max_rad: Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth,
        positive to the right; includes wind [rad].
    sideslip_max_at_s: Time stamp of sideslip_max_rad [s].
    attack_max_rad: Angle of attack of the largest size, from the velocity against the Earth up to the forward
        axis, in the plane of symmetry [rad].
    attack_max_at_s: Time stamp of attack_max_rad [s].
    height_min_m: Lowest height [m].
    height_min_at_s: Time stamp of height_min_m [s].
    height_max_m: Highest height [m].
    height_max_at_s: Time stamp of height_max_m [s].
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


class covariance(_Struct):
    """Covariance of the navigation errors over all runs of the flight, with its standard deviations and its error
    ellipse. The errors are those of sins.errors: east, north, up of position [m], velocity [m/s] and misalignment
    [rad], in this order.

    The covariance is propagated along the truth with the linear error equations (error data 1). Both values of
    sins.options.frame use the equations in Earth-fixed axes; the result is the same. The covariance is taken about
    the mean error of all runs. It does not depend on the random numbers of this run. It contains: random initial
    errors; the misalignment that the alignment at the start derives from sensor errors; turn-on biases, scale factors
    and misalignments; Gauss-Markov, flicker, rate random walk and white noise; the random fields of gravity; the
    altimeter's Gauss-Markov error and noise; quantization, as white noise of the same variance. It does not contain:
    constant errors and failures, which change only the mean; dead zones and ranges, which are not linear. One step of
    the propagation is one second of flight. A parameter that is set in flight takes effect from the start of the
    current second. A second with at least one height of the altimeter counts as aided throughout, so drop-outs
    shorter than a second have no effect on the covariance. The standard deviations of the propagation are limited to
    1e30 in SI units, so all outputs are finite.

    flags: Flags of enum sins.errors_flags, or'ed: sins.ERRORS_NEAR_POLE, and sins.ERRORS_OUTSIDE_VALIDITY if a
        standard deviation exceeds the limits of that flag.
    time_s: Time [s].
    covariance[81]: Covariance, 9 by 9, row by row. It is symmetric, and rounding cannot make a variance negative.
    position_sigma_enu_m[3]: Standard deviation of the position error [m].
    velocity_sigma_enu_m_s[3]: Standard deviation of the velocity error [m/s].
    misalignment_sigma_enu_rad[3]: Standard deviation of the misalignment [rad].
    ellipse_major_m: Semi-major axis of the error ellipse (one standard deviation) of the horizontal position [m].
    ellipse_minor_m: Semi-minor axis of that ellipse [m].
    ellipse_azimuth_rad: Azimuth of the major axis, from north to the east, 0 up to pi [rad].
    cep50_m: Radius of the circle that contains the horizontal error with a probability of 50 % [m]. The error has
        the normal distribution of this ellipse, with the mean 0.
    radial_95_m: Radius of the circle that contains the horizontal error with a probability of 95 % [m].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_int32),
        ("time_s", c_double),
        ("covariance", c_double * 81),
        ("position_sigma_enu_m", c_double * 3),
        ("velocity_sigma_enu_m_s", c_double * 3),
        ("misalignment_sigma_enu_rad", c_double * 3),
        ("ellipse_major_m", c_double),
        ("ellipse_minor_m", c_double),
        ("ellipse_azimuth_rad", c_double),
        ("cep50_m", c_double),
        ("radial_95_m", c_double),
    ]


class imu_increment(_Struct):
    """Increments of an inertial measurement unit over an interval. The interval is divided into parts of equal length;
    the field count is their number.

    interval_s: Length of the whole interval, 5e-5 to 10 [s].
    count: Number of parts, 1 to 5.
    angle_rad[15]: Integral of the angular rate against inertial space over each part: x, y, z of the first part,
        x, y, z of the second part, and so on [rad]. The rotation in each part, and in the interval, must be less than
        half a turn.
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
    zero except for struct_size holds no runs. sins.statistics_figures() computes means, covariances and radii.

    The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment
    about east, north, up, as in sins.errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24
    um), 2^-29 m/s (1.9 nm/s), 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262
    km/s) and 4 rad, which are 2^47 resolutions; the horizontal radial position error is in range below 2^25 m. There
    are at most 4294967295 runs, so the sums cannot overflow. Integers of 128 bits are two words, the low one first,
    in two's complement.

    layout: Version of the layout of the fields below: 1; 0 while there is no run.
    runs: Number of runs, including those that are left out of the sums.
    diverged: Number of runs that have diverged. They are left out of the sums.
    out_of_range: Number of runs with a state or a horizontal radial position error outside its range. They are
        left out of the sums.
    outside_validity: Number of runs whose error model is flagged sins.ERRORS_OUTSIDE_VALIDITY. They are in the
        sums.
    largest_radial: Largest horizontal radial position error, rounded down [2^-22 m].
    sums[18]: Sum of each state, integers of 128 bits.
    products[90]: Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row
        by row.
    histogram[3501]: Numbers of runs by their horizontal radial position error. Element 0 counts those below 2^-10
        m (1 mm). Element 1 + 100 i + k, with i from 0 to 34 and k from 0 to 99, counts those from 2^(i-10) (1 +
        k/100) m up to 2^(i-10) (1 + (k+1)/100) m.
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
    """Figures that are computed from a sins.statistics. If there is no run, all figures are 0. If there is one run, its
    covariance is 0.

    runs: Number of runs, including those that are left out of the other figures.
    diverged: Number of runs that have diverged. They are left out.
    out_of_range: Number of runs with an error outside its range. They are left out.
    outside_validity: Number of runs whose error model is flagged sins.ERRORS_OUTSIDE_VALIDITY. They are not left
        out.
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
        9 i + j is the covariance of the states i and j, in m, m/s and rad.
    rms_radial_m: Root mean square of the horizontal radial position error [m].
    cep50_m: Horizontal radius that contains the positions of half of the runs [m]. It is read from the histogram,
        to 0.5 % of its value, or to 0.5 mm if it is below 1 mm.
    r95_m: Horizontal radius that contains the positions of 95 % of the runs [m]. It is read from the histogram as
        cep50_m is.
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
    """Start of an embedded flight, level and straight.

    latitude_rad: Geodetic latitude, -pi/2 to pi/2 [rad].
    longitude_rad: Longitude, east positive, -100 to 100 [rad].
    height_m: Height above the ellipsoid, -2e4 to 2e6 [m].
    speed_m_s: Speed against the Earth, 0 to 1e4 [m/s].
    heading_rad: Course and heading, -100 to 100 [rad].
    roll_rad: Roll of the body relative to the axes of the path, throughout the flight, -pi to pi [rad].
    pitch_rad: Pitch of the body relative to the axes of the path, throughout the flight, -pi/2 to pi/2: angle of
        attack, or tilt at rest [rad].
    earth: Ellipsoid, of enum sins.earth, as in the options of the simulator that will fly it.
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

    kind: Kind of the manoeuvre, of enum sins.manoeuvre_kind.
    sinusoid_count: Number of sinusoids, 1 to 6.
    duration_s: Duration, 1e-3 to 1e8 [s].
    ramp_s: Time in which the manoeuvre builds up, and time in which it dies out, 1e-3 to 1e8; 0: 5 s [s]. If it
        is longer than half of the duration, half of the duration is used.
    speed_change_m_s: Change of speed; the speed must stay between 0 and 10 km/s [m/s].
    height_change_m: Change of height; the climb angle must stay below 64 degrees [m].
    heading_change_rad: Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad
        [rad].
    bank_rad: Bank of a turn, 1e-3 to 1.5 [rad]. If the heading change is too small to reach this bank, the turn
        uses a smaller bank.
    turns: Number of rolls or loops, a whole number from -1e4 to 1e4, not 0; or number of swings of an S-turn, 0
        to 1e6.
    channel[6]: What each sinusoid moves, of enum sins.channel.
    amplitude[6]: Amplitude of each sinusoid [rad] or [m/s]: up to 10 rad; for the climb angle up to 1.5 rad; for
        the speed, the sum of the amplitudes is at most the speed.
    frequency_hz[6]: Frequency of each sinusoid, 0 to 1000 [Hz].
    phase_rad[6]: Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), with t since the start of the
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

    flags: Flags of enum sins.error_info_flags, or'ed: which of value, minimum and maximum there are.
    count: Number of faults that are reported: at most the first 200 of the text.
    line: Line of this fault in the text of the call, from 1; 0: the fault is in a value that the scene had before
        the call.
    column: Column, in characters from 1. For a flight log: number of the column of the table, from 1. 0: the same
        meaning as 0 in line.
    value: The value at fault, in the unit of the key that path names.
    minimum: Least allowed value, in that unit; if the sentence says "more than", the limit itself is not allowed.
    maximum: Greatest allowed value, in that unit; if the sentence says "less than", the limit itself is not
        allowed.
    path[96]: Path of the value at fault, for sins.scene_get_value(). It can also be the name of a section, such
        as "gyro", or of an item, such as "failure[0]". Terminated. Empty for a flight log, and if the text itself is
        at fault.
    sentence[256]: Sentence that names key, value and limit, and the key that was probably meant; UTF-8,
        terminated, cut if it is longer.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("count", c_uint64),
        ("line", c_uint64),
        ("column", c_uint64),
        ("value", c_double),
        ("minimum", c_double),
        ("maximum", c_double),
        ("path", c_char * 96),
        ("sentence", c_char * 256),
    ]


class scene_setup(_Struct):
    """Settings of a scene for its flight and its output.

    flight: Kind of the flight, of enum sins.scene_flight; read only: sins.scene_set_setup() ignores it.
    has_temperature: 1: samples get the temperature below; 0: samples get no temperature.
    quiet: 1: a program shows neither progress nor summary; 0: it does.
    duration_s: Duration to fly, 0.036 to 3.6e8; 0: the whole flight, or the duration of the built-in scene [s].
    flown_s: Duration that will be flown; read only [s]. 0 for a log (see sins.log_info.duration_s). 0 also if
        duration_s is longer than the flight: sins.scene_write() rejects such a scene.
    rate_hz: Sample rate, 1e-3 to 2e4; 0 for a log, which has its own time stamps [Hz].
    temperature_c: Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if has_temperature is
        0 [deg C].
    temperature_change_c_s: Rate of change of the temperature, -277 to 277 [deg C/s].
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
    """A failure that a scene plans. Its fields from kind on are those of sins.failure; kind is not sins.FAILURE_NONE.

    sensor: Sensor that fails, of enum sins.sensor.
    axis: Axis that fails: 0, 1, 2 for x, y, z of the sensor axes; 0 for the altimeter.
    from_s: Start of the failure, 0 to 1e9 since the start of the flight [s].
    until_s: End of the failure, likewise; 0: the end of the flight [s].
    kind: Kind of the failure, of enum sins.failure_kind.
    size: Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the
        altimeter [u].
    density: Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the
        altimeter [u sqrt(s)].
    interval_s: Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for
        drop-outs with a probability.
    duration_s: Spikes: length of one spike, 1e-9 s to interval_s [s].
    probability: Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1.
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


class scene_key(_Struct):
    """A key of the scene format.

    flags: Flags of enum sins.scene_key_flags, or'ed.
    count: Number of keys of the format.
    kind: Kind of the value, of enum sins.scene_key_kind.
    elements: Number of numbers: 1; 3 for x, y, z; 9 for a matrix row by row; 0 for the other kinds.
    spread: A single number may be given in the place of all elements if this is not 0. It sets element k if bit k
        is set, and the other elements are 0. 0: all elements must be given.
    si_per_unit: Factor from the unit of the key to SI. It is 1 if the value is not a number.
    minimum: Least allowed value of each number, in the unit of name. If the kinds of items have different limits,
        it is the widest. Other values of the scene may narrow the limits.
    maximum: Greatest allowed value, likewise.
    section[24]: Section, such as "gyro" or "manoeuvre.sinusoid"; terminated, as all texts here.
    name[40]: Name, such as "bias_deg_h": its value is in the unit of data sheets.
    si_name[40]: Name of the key that takes the same quantity in SI, such as "bias_rad_s"; empty: name is that
        key.
    unit[24]: Unit of name, such as "deg/h"; empty: a pure number, or no number.
    si_unit[24]: Unit of si_name, such as "rad/s".
    default_value[32]: Value in a scene that does not set the key, as sins.scene_get_value() gives it; empty: no
        value.
    words[128]: Words that a key of sins.SCENE_KEY_WORD takes, such as "exact|paper|polynomial".
    condition[96]: Items of the list that use the key. "kind=turn|s_turn" means the items in which the value of
        the key `kind` is one of these words. If there are several conditions, with a space between them, an item must
        meet all. Empty: all items.
    meaning[128]: Meaning, without unit.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("count", c_uint64),
        ("kind", c_int32),
        ("elements", c_int32),
        ("spread", c_uint32),
        ("reserved", c_uint32),
        ("si_per_unit", c_double),
        ("minimum", c_double),
        ("maximum", c_double),
        ("section", c_char * 24),
        ("name", c_char * 40),
        ("si_name", c_char * 40),
        ("unit", c_char * 24),
        ("si_unit", c_char * 24),
        ("default_value", c_char * 32),
        ("words", c_char * 128),
        ("condition", c_char * 96),
        ("meaning", c_char * 128),
    ]


class log_info(_Struct):
    """Contents of a flight log.

    samples: Number of samples.
    duration_s: Duration from the first to the last sample [s].
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


class scene_samples(_Struct):
    """The samples that a scene flies.

    count: Number of samples.
    record_every: Number of sample intervals between two records of the program sins, at least 1. It follows from
        sins.scene_setup.every_s; if every_s is 0, there are about 2000 records.
    start_s: Time stamp of the first sample [s].
    period_s: Time between two samples [s]; of a log, the mean.
    duration_s: Time from the first to the last sample [s].
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("count", c_uint64),
        ("record_every", c_uint64),
        ("start_s", c_double),
        ("period_s", c_double),
        ("duration_s", c_double),
    ]


class requirement(_Struct):
    """Largest error that the algorithm itself may cause, in addition to those of the sensors, at any time within a
    duration. At least one limit is needed.

    time_steps: 1: measure ns_per_step, in 9 rounds of about 1000 steps; 0: it is 0.
    duration_s: Duration for which the limits hold, 0 to 1e6 [s]. If it is shorter than the piece of flight that
        is given to sins.recommend(), it is the length of that piece.
    position_m: Limit of the position error of the algorithm: distance from the reference (see sins.recommend())
        [m]; 0: none.
    velocity_m_s: Limit of the velocity error of the algorithm: length of the difference from the reference [m/s];
        0: none.
    attitude_rad: Limit of the attitude error of the algorithm: angle between its attitude relative to the Earth
        and that of the reference [rad]; 0: none.
    margin: Margin: each limit must be at least this many times the predicted error, 1 to 1e6; 0: 2.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("time_steps", c_uint32),
        ("duration_s", c_double),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
        ("margin", c_double),
    ]


class cost(_Struct):
    """Accuracy and cost of the recommended options.

    duration_s: Duration for which the errors are predicted [s].
    position_m: Predicted position error, the largest within the duration [m].
    velocity_m_s: Predicted velocity error, the largest within the duration [m/s].
    attitude_rad: Predicted attitude error against the Earth, the largest within the duration [rad].
    reference_position_m: Part of position_m that is the uncertainty of the reference [m].
    reference_velocity_m_s: Part of velocity_m_s that is the uncertainty of the reference [m/s].
    reference_attitude_rad: Part of attitude_rad that is the uncertainty of the reference [rad].
    share: Predicted error times margin divided by its limit, the largest of the three. The requirement is met if
        this is at most 1. A limit below 1e-100 counts as 1e-100.
    instructions_per_step: Processor instructions of the part of a step that depends on the algorithm: a figure
        that is the same on every machine. The algorithms are ordered by this figure.
    ns_per_step: Time of push and step of one sample, measured in this call on this machine if time_steps is 1,
        else 0, with the recommended options, the mounting, and ideal sensors [ns].
    tried: Number of algorithms that were tried, including the recommended one.
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
    """Request for an error budget. All zero is 16 runs and no limits.

    time_steps: 1: measure the figures ns_per_step; 0: they are 0.
    runs: Number of runs with all effects together, if any effect is random, 8 to 1000; 0: 16.
    position_m: Limit of the change of the position error, at any time of the flight, by all effects that are left
        out together [m]; 0: none.
    velocity_m_s: Limit of the change of the velocity error, likewise [m/s]; 0: none.
    attitude_rad: Limit of the change of the misalignment, likewise [rad]; 0: none.
    """

    __slots__ = ()
    _fields_ = [
        ("struct_size", c_uint32),
        ("time_steps", c_uint32),
        ("runs", c_uint64),
        ("position_m", c_double),
        ("velocity_m_s", c_double),
        ("attitude_rad", c_double),
    ]


class budget_row(_Struct):
    """An effect and its contribution to the errors. The first row of a budget has the errors of the mechanization and of
    the samples, with no effect set.

    flags: Flags of enum sins.budget_flags, or'ed.
    effect[32]: Name of the effect, such as "gyro turn-on bias", terminated; in the first row "mechanization".
    field[48]: The field that sets the effect, such as "gyro.bias_sigma_rad_s", terminated; a value of 0 there
        leaves the effect out. Empty in the first row.
    position_m: Length of the contribution to the position error, the largest at up to 1000 instants of the flight
        [m].
    velocity_m_s: Length of the contribution to the velocity error, the largest at these instants [m/s].
    attitude_rad: Length of the contribution to the misalignment, the largest at these instants [rad].
    end_position_m: Length of the contribution to the position error at the end of the flight [m].
    end_velocity_m_s: Length of the contribution to the velocity error at the end of the flight [m/s].
    end_attitude_rad: Length of the contribution to the misalignment at the end of the flight [rad].
    share: The contribution divided by its limit, the largest of the three; 0 without limits.
    ns_per_step: Time of a step with all effects, less that of a step without this one; in the first row, time of
        a step with no effect set. Measured in this call on this machine if time_steps is 1, else 0 [ns]. Uncertain by
        1 to 5 % of a step, more on a busy machine, so it may be negative.
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
    """Figures of a budget as a whole.

    duration_s: Duration of the evaluation: from the end of the first interval to the end of the last [s].
    runs: Number of runs with all effects together; 1 if nothing is random.
    flights: Number of flights that the call made.
    sigma_low: Lower end of the 95 % confidence interval of the root mean square of the random errors, divided by
        the root mean square over the flown runs. The fewer the runs, the wider the interval. 1 if nothing is random.
    sigma_high: Upper end of that interval, divided likewise; 1 if nothing is random.
    position_m: Position error with all effects together, root mean square over the runs, the largest in the
        flight [m].
    velocity_m_s: Velocity error with all effects together, likewise [m/s].
    attitude_rad: Misalignment with all effects together, likewise [rad].
    remainder_position_m: Part of the position error that the sum of all rows does not explain [m].
    remainder_velocity_m_s: Part of the velocity error that the sum of all rows does not explain [m/s].
    remainder_attitude_rad: Part of the misalignment that the sum of all rows does not explain [rad].
    left_out_position_m: Change of the position error if the marked effects (sins.BUDGET_CAN_BE_LEFT_OUT) are left
        out, from flights of all runs without them [m].
    left_out_velocity_m_s: Change of the velocity error if the marked effects are left out, likewise [m/s].
    left_out_attitude_rad: Change of the misalignment if the marked effects are left out, likewise [rad].
    ns_per_step: Time of a step with all effects, measured in this call on this machine if time_steps is 1, else 0
        [ns].
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
    """Returns the version of the interface of the loaded library: compare it with sins.HEADER_ABI."""


@_function(ctypes.c_char_p)
def version_string():
    """Returns the release of the loaded library as text, such as "0.1.0". The text lives as long as the library is
    loaded.
    """


@_function(ctypes.c_char_p, status)
def status_string(status):
    """Returns the name of a status code, such as "sins.OK", or "unknown status" for any other number. The text lives as
    long as the library is loaded.
    """


@_function(status, POINTER(options), _New(sim))
def create(options, sim):
    """Creates a simulator with ideal sensors. If options is NULL, it has the recommended options.

    On an error *sim is unchanged, and sins.last_error(NULL, ...) on this thread gives the reason. Not for a real-time
    frame: it allocates.

    sins.ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators exist.
    """


@_function(status, sim)
def destroy(sim):
    """Waits until the calls of other threads on this handle have returned, and destroys the simulator. The handle is
    never used again.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, sim, POINTER(options))
def get_options(sim, options):
    """Reads the options in effect: those of sins.create() or of the snapshot that was loaded, with the defaults in place
    of 0.
    """


@_function(status, sim, POINTER(flight_sample))
def push_sample(sim, sample):
    """Puts one flight sample into the queue (16 samples). Each sample is checked by itself and against the one before.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
    sins.ERROR_TIME_ORDER: the sample is not later than the one before, or later by less than 5e-5 s, or off a stated
    period by more than 0.4 of the period. sins.GAP: the sample was accepted, and the interval before it is a gap,
    more than 2.5 times as long as each of the two before. sins.step() flies the gap as motion: the vehicle moves by
    its velocity times the length of the gap. After a pause of the host in which its clock ran on, call
    sins.move_time() before this push; a push cannot be undone. sins.ERROR_DISCONTINUITY: a gap of more than
    max_gap_s, a jump, or a turn of 170 degrees or more since the last accepted sample. After a gap each later sample
    is rejected, until you call sins.move_time(), sins.move_truth() or sins.reposition(). After a jump or a turn each
    later sample is rejected, until one fits the last accepted sample, or until you call sins.move_truth() or
    sins.reposition(). sins.ERROR_QUEUE_FULL: step first. sins.ERROR_BAD_STATE: navigating on increments.
    """


@_function(status, sim)
def step(sim):
    """Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples,
    each later step one more. No allocation, no system call. An interval in which the host paused and its clock ran on
    is flown like any other: the vehicle moves by its velocity times the length of the interval. sins.push_sample()
    returns sins.GAP if the interval is a gap.

    sins.NEED_SAMPLE: no complete interval is waiting. sins.ERROR_DIVERGED: the step would bring the solution below a
    height of -500 km, above a height of 20000 km, or to a speed of more than 100 km/s. The limits apply to the
    solution of the sensor block, to that of the reference point, and to the error-free navigator of
    sins.SIGNAL_CLOSED_LOOP. sins.ERROR_SINGULAR: too close to a pole, in geographic axes. sins.ERROR_BAD_STATE:
    navigating on increments.

    After sins.ERROR_DIVERGED and sins.ERROR_SINGULAR the step is not made, and the solution before it stays readable.
    The samples stay in the queue, so a further sins.step() tries the same interval again. sins.reposition() or
    sins.reset() start anew.
    """


@_function(status, sim, c_double)
def move_time(sim, time_s):
    """Moves the time after a pause in which the host's clock ran on: the newest accepted sample gets the time stamp
    time_s [s], and later samples must have later stamps. time_s is the time that the clock shows when the vehicle
    moves again. Everything else stays: errors, noise, waiting samples, sensor processes, failures and running
    figures. The grid of a stated period moves along. The outputs have the same bits as those of a flight without the
    jump of time, if the differences between successive time stamps are the same doubles. With a stated period this is
    always so. (If the samples have no velocities, the differences over three samples must be the same doubles too.
    Durations in sins.accuracy have the rounding of the time stamps.) The host must also move its flight_start_s of
    sins.scene_prepare() by the same time.

    sins.ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9.
    sins.ERROR_BAD_STATE: no sample yet, or navigating on increments, which have no time stamps.
    """


@_function(status, sim, POINTER(flight_sample))
def move_truth(sim, sample):
    """Slews the vehicle: the truth jumps to the sample, and the INS keeps its errors. No interval is flown from the
    previous sample to this one, so the errors do not change at the slew. For both values of source, sins.get_errors()
    reports the same errors before and after it: position error in metres (along the truth's east and north, and in
    height), velocity error (components) and misalignment, to 1e-8 m, 1e-11 m/s and 1e-14 rad. Their further growth
    depends on gravity, latitude and velocity at the new place. Noise, sensor processes, failures, the vertical
    channel, the altimeter's error and running figures continue, and no random number changes. (The scale factor error
    of the altimeter is that of the new height.) The sensors follow the new signals immediately. Waiting samples are
    dropped. The time may jump too: the running figures and the grid of a stated period then move with it, as in
    sins.move_time(). sins.get_imu() still reports the previous interval. If the sample has no velocity, the library
    takes the true velocity as 0 until the next sample is pushed. The navigated velocity is then equal to the velocity
    error.

    If the vehicle is within 20 km of the Earth's axis before or after the slew, the east and north components of
    truth and solution are not comparable. The axes of the solution are then those of the truth, turned by the
    shortest rotation so that up is the vertical of the solution. In these axes the components of the velocity error
    and of the misalignment are kept. With a mounting, the errors of the sensor block are kept. The errors of the
    reference point follow from them with the lever arm, the boresight and their errors, in the new attitude.

    Before the first step there are no errors to keep, and the call acts as sins.reposition().

    sins.ERROR_INVALID_ARGUMENT, sins.ERROR_BAD_STATE: as sins.reposition().
    sins.ERROR_SINGULAR: too close to a pole, in geographic axes.
    sins.ERROR_DIVERGED: the solution would leave its limits, or the position error is about a quarter of the Earth's
    circumference or more, so that no place at the sample has this error.
    """


@_function(status, sim, POINTER(flight_sample))
def reposition(sim, sample):
    """Restarts the INS after the flight simulator was reloaded: the truth jumps to the sample, and the INS starts again
    there with its initial errors. The initial errors have the same random numbers as at the first start. The previous
    errors of the INS are lost; to keep them, call sins.move_truth() (slew) or sins.move_time() (pause) instead. Noise
    and failures continue. Waiting samples and the running accuracy figures are dropped. The time may jump too,
    forward or back: the run, and the grid of a stated period, continue from the sample's time stamp. Until the next
    step, the reads give the state at this sample, and there is no interval to read. The call may be the first of a
    run: the sample is then the first one, and the next push completes an interval.

    sins.ERROR_INVALID_ARGUMENT: as sins.push_sample().
    sins.ERROR_BAD_STATE: navigating on increments.

    This call returns sins.OK even if no INS can start at the sample. The reads and the next step then return
    sins.ERROR_SINGULAR (too close to a pole, in geographic axes or for gyrocompassing) or sins.ERROR_DIVERGED.
    """


@_function(status, sim)
def reset(sim):
    """Returns to the state before the first sample: the same options, the parameters as they were set last, no failures,
    and the random streams at their start. So the same samples and settings give the same bits. For other random
    numbers, create a simulator with another seed or run. To return to a moment in flight, see sins.snapshot_save().
    """


@_function(status, sim, _Array(c_char), POINTER(c_size_t))
def last_error(sim, buffer, needed):
    """Copies the sentence of the last failed call on this handle. The sentence names field, value and limit; it is UTF-8
    and always terminated; it is "no error" if no call failed. With a NULL handle the function gives the last failed
    call of this thread that was made without a simulator (create, presets, flights, ensembles, statistics, scenes,
    logs, recommend, budget), or whose handle was rejected (sins.ERROR_BAD_HANDLE, or sins.ERROR_BAD_STATE: see
    Threads). A failure of this call or of sins.last_error_info() is not kept.

    needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for
    the size only. sins.ERROR_BUFFER_TOO_SMALL: the sentence was cut.
    """


@_function(status, sim, POINTER(error_info))
def last_error_info(sim, info):
    """Gives the same failure as sins.last_error(), as a struct."""


@_function(status, sim, POINTER(gyro_params))
def set_gyro(sim, params):
    """Sets the gyro errors: before the first sample or in flight, from the next interval on. The random numbers of other
    effects do not change. Random processes that were active continue.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    sins.ERROR_BAD_STATE: temperature coefficients while samples without a temperature wait, or while navigating on
    increments.
    """


@_function(status, sim, POINTER(gyro_params))
def get_gyro(sim, params):
    """Reads the gyro errors that are set. May be called at any moment. After sins.snapshot_load() they are those of the
    snapshot.
    """


@_function(status, sim, POINTER(accel_params))
def set_accel(sim, params):
    """Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The random numbers
    of other effects do not change. Random processes that were active continue.

    sins.ERROR_INVALID_ARGUMENT, sins.ERROR_BAD_STATE: as sins.set_gyro().
    """


@_function(status, sim, POINTER(accel_params))
def get_accel(sim, params):
    """Reads the accelerometer errors that are set. May be called at any moment. After sins.snapshot_load() they are
    those of the snapshot.
    """


@_function(status, sim, POINTER(altimeter_params))
def set_altimeter(sim, params):
    """Sets the errors of the barometric altimeter, whose height damps the vertical channel (sins.VERTICAL_DAMPED), from
    the next interval on.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, sim, POINTER(altimeter_params))
def get_altimeter(sim, params):
    """Reads the errors of the altimeter that are set. May be called at any moment. After sins.snapshot_load() they are
    those of the snapshot.
    """


@_function(status, sim, c_int32, c_int32, POINTER(failure))
def set_failure(sim, sensor, axis, failure):
    """Sets a failure of one output, as an instructor's station does: before the first sample or in flight, from the next
    interval on. It lasts until sins.FAILURE_NONE clears it, or another failure of the same output replaces it.
    Several outputs may fail at the same time.

    sensor is of enum sins.sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before
    dead zone, range and quantization. sins.FAILURE_STUCK, sins.FAILURE_DEAD and sins.FAILURE_DROP_OUTS replace the
    output. The random numbers of other effects do not change. Sensor processes continue during a failure, and act on
    the output again when it is cleared. A failure acts on error data 1 and on error data 2. It does not act on the
    alignment at the start. sins.reposition() keeps failures. sins.reset() clears all failures, so an exercise starts
    again with working sensors; failures that are set again at the same intervals give the same bits.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. If a failure makes
    the solution diverge, sins.step() returns sins.ERROR_DIVERGED.
    """


@_function(status, sim, c_int32, c_int32, POINTER(failure))
def get_failure(sim, sensor, axis, failure):
    """Reads the failure of one output. May be called at any moment. After sins.snapshot_load() it is that of the
    snapshot. sins.FAILURE_NONE: the output has no failure. sensor and axis as in sins.set_failure().

    sins.ERROR_INVALID_ARGUMENT: no such output.
    """


@_function(status, sim, POINTER(initial_errors))
def set_initial_errors(sim, errors):
    """Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition
    until the next step. After a reposition they apply to the start at its sample.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(initial_errors))
def get_initial_errors(sim, errors):
    """Reads the set errors with which the navigation starts. May be called at any moment. After sins.snapshot_load()
    they are those of the snapshot.
    """


@_function(status, sim, POINTER(mounting))
def set_mounting(sim, mounting):
    """Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the
    next step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its
    solution is that of the block.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(mounting))
def get_mounting(sim, mounting):
    """Reads the mounting of the sensor block that is set. May be called at any moment. After sins.snapshot_load() it is
    that of the snapshot.
    """


@_function(status, sim, POINTER(gravity_params))
def set_gravity_disturbance(sim, params):
    """Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset
    or a reposition until the next step. A reset brings the same field back; after a reposition the field continues
    from its current values. The disturbance does not affect a navigator on increments, because the host's increments
    already contain its effect.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    sins.ERROR_BAD_STATE: steps have been made.
    """


@_function(status, sim, POINTER(gravity_params))
def get_gravity_disturbance(sim, params):
    """Reads the parameters of the gravity disturbance that are set. May be called at any moment. After
    sins.snapshot_load() they are those of the snapshot.
    """


@_function(status, sim, _Array(flight_sample, is_input=True), c_size_t, _Array(record), POINTER(c_size_t))
def run(sim, samples, every, records, written):
    """Pushes and steps an array of count samples. Writes a record after each `every` intervals, counted as in
    sins.accuracy.intervals. There is no record for the first sample. Any split of a flight into calls gives the same
    bits and the same records as pushing and stepping sample by sample.

    samples[0].struct_size is the size in bytes of each element of samples, records[0].struct_size that of each
    element of records. struct_size of the other samples may be 0, that of the other records anything. every 0: no
    records. written (may be NULL) gets the number of records that were written, also on an error.

    sins.GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
    if sins.options.truth_summary is on, sins.truth_summary.gaps is their number. sins.ERROR_BUFFER_TOO_SMALL:
    capacity does not hold the records that the call would make. Nothing is flown, and written gets 0.
    sins.ERROR_BAD_STATE: navigating on increments.

    An error of sins.push_sample() or sins.step() ends the call at the sample that caused the error; sins.last_error()
    names this sample. The samples before it were flown, this sample and the rest were not. sins.accuracy.intervals
    counts the flown intervals. A sample that could be pushed but not flown waits in the queue, as after sins.step();
    sins.reposition() and sins.reset() empty the queue.
    """


@_function(status, sim, POINTER(navigation))
def get_truth(sim, truth):
    """Reads the truth at the end of the last interval; before the first step, that of the first sample. If the samples
    have no velocity, the velocity at the first one is 0 until the second one is pushed.

    sins.NEED_SAMPLE: no sample yet.
    sins.ERROR_BAD_STATE: navigating on increments, without a truth.
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

    sins.NEED_SAMPLE: no sample yet.
    sins.ERROR_BAD_STATE: navigating on increments, without a truth.
    sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: as sins.get_navigation().
    """


@_function(status, sim, POINTER(truth_summary))
def get_truth_summary(sim, summary):
    """Reads the extreme values of the true motion. sins.reposition() and sins.move_truth() do not restart them.

    sins.NEED_SAMPLE: no interval yet.
    sins.ERROR_BAD_STATE: sins.options.truth_summary is off, or navigating on increments, without a truth.
    """


@_function(status, sim, POINTER(covariance))
def get_covariance(sim, covariance):
    """Reads the covariance of the navigation errors at the end of the last interval; before the first step, that of the
    start.

    sins.NEED_SAMPLE: no sample yet.
    sins.ERROR_BAD_STATE: sins.options.covariance is off, or navigating on increments.
    sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: no INS can start at the first sample.
    """


@_function(status, sim, POINTER(record))
def get_record(sim, record):
    """Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first
    sample.

    sins.NEED_SAMPLE: no sample yet.
    sins.ERROR_BAD_STATE: navigating on increments, without a truth.
    sins.ERROR_SINGULAR, sins.ERROR_DIVERGED: as sins.get_navigation().
    """


@_function(status, POINTER(record), _Array(c_double, is_input=True), POINTER(covariance), _Array(c_char), POINTER(c_size_t))
def record_line(record, sensor_errors, covariance, buffer, needed):
    """Writes a record as one line of comma-separated values, without the newline. The program sins writes its files of
    records in this format. If record is NULL, the line has the names of the columns. The decimal numbers are exact:
    reading them gives the same doubles. sensor_errors is an array of count = 6 numbers: x, y, z of the mean gyro
    error [rad/s], then x, y, z of the mean accelerometer error [m/s2], since the previous record. NULL with count 0:
    all are 0. covariance adds columns of standard deviations; NULL: none. buffer, capacity and needed as in
    sins.last_error(); a line has at most 1600 bytes. Not for a real-time frame: it allocates.

    sins.ERROR_INVALID_ARGUMENT: count is neither 6 nor 0.
    sins.ERROR_OUT_OF_MEMORY: no memory for the text.
    """


@_function(status, sim, POINTER(navigation))
def start_navigation(sim, navigation):
    """Starts the simulator as a navigator only: it navigates on the increments of sins.push_imu(). The argument
    navigation gives the start: time, position, velocity and attitude (quaternion_nb; the angles and the flags are not
    read). Ranges are those of a flight sample; the norm of the quaternion must be 1 within 1e-3. Initial errors that
    are set do not apply. There is no truth: the vertical channel is free, and flagged so, and the reads of errors and
    accuracy return sins.ERROR_BAD_STATE until sins.reset().

    sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_BAD_STATE: samples were pushed, or the navigator
    was started before (call sins.reset() first); or temperature coefficients are set, but increments have no
    temperature. sins.ERROR_SINGULAR: too close to a pole, in geographic axes.
    """


@_function(status, sim, POINTER(imu_increment))
def push_imu(sim, increment):
    """Navigates over one interval on the host's increments. Sensor errors that are set are added to the increments. The
    time advances by interval_s. sins.get_imu() reports the host's increments as the ideal ones.
    sins.options.subsamples and updates_per_sample do not apply: the parts of the increment are the subsamples of one
    update.

    sins.ERROR_BAD_STATE: sins.start_navigation() was not called. sins.ERROR_INVALID_ARGUMENT: a value out of its
    range, or a rotation of half a turn or more in a part or in the interval. sins.ERROR_DIVERGED,
    sins.ERROR_SINGULAR: as sins.step(); the interval is not flown, the solution before it stays readable, and
    sins.reset() and sins.start_navigation() start anew.
    """


@_function(status, sim, POINTER(c_size_t))
def snapshot_size(sim, size):
    """Reads the size that a snapshot has now. It changes with what is set and with the number of waiting samples. These
    sizes are without waiting samples. Without sensor errors it is 1.3 to 2.1 KiB, by the options. With every error of
    gyros, accelerometers and altimeter it is up to 4.5 KiB. With mounting, gravity, temperature and failures too it
    is up to 5.25 KiB. Each waiting sample adds up to 154 bytes, and sins.options.covariance up to 9.2 KiB.
    """


@_function(status, sim, _Array(c_char), POINTER(c_size_t))
def snapshot_save(sim, buffer, written):
    """Saves the whole simulator, at any moment: options, parameters, waiting samples, the state of every stage, and the
    position of each random stream. written (may be NULL) gets the size. The bytes mean the same on every platform and
    hold no address, so they can be kept in a file or sent to another machine. The same state gives the same bytes. No
    allocation, no system call.

    Not saved: handles, and the sentence of sins.last_error(). After sins.ERROR_DIVERGED or sins.ERROR_SINGULAR the
    last good solution is saved. After sins.ERROR_INTERNAL nothing can be saved: load an earlier snapshot into a fresh
    handle.

    sins.ERROR_BUFFER_TOO_SMALL: see sins.snapshot_size(); buffer and written are unchanged.
    """


@_function(status, sim, _Array(c_char, is_input=True))
def snapshot_load(sim, snapshot):
    """Replaces the simulator by the saved one, including its options (see sins.get_options()). So a fresh handle of
    sins.create(NULL, ...) is enough. The run continues to the same bits as the saved one. size is the size that
    sins.snapshot_save() wrote. Not for a real-time frame: it allocates.

    sins.ERROR_SNAPSHOT: the bytes are not a snapshot, or are cut off, altered, or of a newer release; nothing has
    changed, and sins.last_error() says which it is. Later releases read the snapshots of earlier ones; the run
    continues to the same bits unless CHANGELOG says that the algorithms changed. sins.ERROR_OUT_OF_MEMORY: no memory
    for a second simulator.
    """


@_function(status, sim, c_uint64, c_size_t, _New(ensemble))
def ensemble_create(configured, first_run, runs, ensemble):
    """Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator on which options,
    sensor errors, initial errors, mounting, gravity disturbance and failures are set, and to which no sample was
    pushed. The call copies it, and does not change it. Run k of the ensemble gives the same bits as a simulator with
    the same settings and sins.options.run = k. Three options of configured have no effect: run, truth_summary and
    covariance.

    No run depends on another run. So different threads, processes and machines may fly ensembles of different runs,
    and their statistics can be merged. The library starts no thread.

    What all runs share is computed once a step, and runs are flown side by side: a run takes a fraction of the time
    of a simulator, and 1.7 to 2.6 KB of memory. docs/ensembles.md has the times. Not for a real-time frame: it
    allocates.

    After an error *ensemble is unchanged, and sins.last_error(NULL, ...) on this thread gives the reason.

    sins.ERROR_BAD_STATE: configured has taken a sample since it was created or reset, or navigates on increments.
    sins.ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 above 2^64 - 1.
    sins.ERROR_OUT_OF_MEMORY: no memory, or 4096 ensembles exist.
    """


@_function(status, ensemble)
def ensemble_destroy(ensemble):
    """Waits until the calls of other threads on this handle have returned, and destroys the ensemble. The handle is
    never used again.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, ensemble, POINTER(flight_sample))
def ensemble_push_sample(ensemble, sample):
    """Puts one flight sample into the queue (16 samples) of all runs.

    sins.GAP and the errors: as sins.push_sample().
    """


@_function(status, ensemble)
def ensemble_step(ensemble):
    """Flies one sample interval with all runs that have not diverged. No allocation, no system call.

    A run has diverged if its solution leaves its limits (sins.ERROR_DIVERGED of sins.step()), or comes too close to a
    pole in geographic axes (sins.ERROR_SINGULAR). A diverged run is not flown any further, and its reads return
    sins.ERROR_DIVERGED. sins.ensemble_get_diverged() reports it, and sins.ensemble_get_statistics() counts it. The
    other runs and the truth continue, even if all runs have diverged. sins.ensemble_reposition() and
    sins.ensemble_reset() start all runs again.

    sins.NEED_SAMPLE: no complete interval is waiting. sins.ERROR_SINGULAR: the truth is too close to a pole, in
    geographic axes or for an alignment by gyrocompassing; the step is made for no run.
    """


@_function(status, ensemble, _Array(flight_sample, is_input=True))
def ensemble_run(ensemble, samples):
    """Pushes and steps an array of count samples. With thousands of runs this is faster than single calls. Any split of
    a flight into calls gives the same bits as pushing and stepping sample by sample. samples[0].struct_size is the
    size in bytes of each element of samples; struct_size of the other samples may be 0.

    sins.GAP: all samples were flown, and at least one of them ended a gap. An error of sins.ensemble_push_sample() or
    sins.ensemble_step() ends the call at the sample that caused the error; sins.last_error() names this sample. The
    samples before it were flown, this sample and the rest were not. A sample that could be pushed but not flown waits
    in the queue.
    """


@_function(status, ensemble, POINTER(flight_sample))
def ensemble_reposition(ensemble, sample):
    """Restarts all runs, as sins.reposition() does: the truth jumps to the sample, and every run, diverged or not,
    starts again there with its initial errors.

    sins.ERROR_INVALID_ARGUMENT: as sins.push_sample().
    """


@_function(status, ensemble)
def ensemble_reset(ensemble):
    """Returns to the state before the first sample, as sins.reset() does: the same parameters, no failures, no diverged
    run, and the random streams at their start.
    """


@_function(status, ensemble, c_int32, c_int32, POINTER(failure))
def ensemble_set_failure(ensemble, sensor, axis, failure):
    """Sets or clears a failure of one output in every run, as sins.set_failure() does. No allocation, no system call.

    sins.ERROR_INVALID_ARGUMENT: as sins.set_failure().
    """


@_function(status, ensemble, POINTER(c_uint64), POINTER(c_size_t))
def ensemble_get_runs(ensemble, first_run, runs):
    """Reads the number of the first run, and how many runs there are; either pointer may be NULL."""


@_function(status, ensemble, POINTER(navigation))
def ensemble_get_truth(ensemble, truth):
    """Reads the truth, which all runs share, as sins.get_truth() does.

    sins.NEED_SAMPLE: no sample yet.
    """


@_function(status, ensemble, c_uint64, POINTER(navigation))
def ensemble_get_navigation(ensemble, run, navigation):
    """Reads the navigated solution of a run, as sins.get_navigation() does. run is from first_run to first_run + runs -
    1.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such run. sins.ERROR_DIVERGED: the run has
    diverged (the sentence of sins.last_error() states the time of its last good solution); or as
    sins.get_navigation(). sins.ERROR_SINGULAR: as sins.get_navigation().
    """


@_function(status, ensemble, c_uint64, c_int32, POINTER(errors))
def ensemble_get_errors(ensemble, run, source, errors):
    """Reads the errors of the navigated solution of a run, as sins.get_errors() does; source is of enum
    sins.errors_source.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such run or source. sins.ERROR_BAD_STATE:
    sins.ERRORS_MODEL while the error model is off. sins.ERROR_DIVERGED, sins.ERROR_SINGULAR: as
    sins.ensemble_get_navigation().
    """


@_function(status, ensemble, c_uint64, POINTER(imu))
def ensemble_get_imu(ensemble, run, imu):
    """Reads ideal and measured signals of the last interval of a run, as sins.get_imu() does.

    sins.NEED_SAMPLE: no interval yet. sins.ERROR_INVALID_ARGUMENT: no such run. sins.ERROR_DIVERGED: the run has
    diverged.
    """


@_function(status, ensemble, c_size_t, POINTER(c_uint64))
def ensemble_get_diverged(ensemble, index, run):
    """Reads the run number of diverged run `index`, from 0. The run numbers are in ascending order.
    sins.statistics.diverged is the number of diverged runs.

    sins.ERROR_INVALID_ARGUMENT: index is not below the count of diverged runs.
    """


@_function(status, ensemble, c_int32, POINTER(statistics))
def ensemble_get_statistics(ensemble, source, statistics):
    """Reads the statistics of the errors of all runs at this moment; source is of enum sins.errors_source.
    sins.statistics_merge() adds those of other runs at the same moment. Within 20 km of the Earth's axis
    (sins.NAVIGATION_NEAR_POLE of the truth) the up misalignment and the east and north components of the velocity
    error have no meaning. No allocation, no system call.

    sins.NEED_SAMPLE: no sample yet. sins.ERROR_INVALID_ARGUMENT: no such source. sins.ERROR_BAD_STATE:
    sins.ERRORS_MODEL while the error model is off. sins.ERROR_SINGULAR: before the first step, no run can start at
    the first sample.
    """


@_function(status, POINTER(statistics), POINTER(statistics))
def statistics_merge(into, other):
    """Adds the runs of `other` to those of `into`. The caller makes sure that no run is in both. The sums are exact: any
    order and any grouping of merges gives the same bits, so the work can be split over threads, processes, machines
    and restarts in any way. If `into` is zero except for struct_size, it holds no runs.

    sins.ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or the sum would have more than
    4294967295 runs. into is then unchanged.
    """


@_function(status, POINTER(statistics), POINTER(figures))
def statistics_figures(statistics, figures):
    """Computes means, covariances, root mean squares and radii from statistics.

    sins.ERROR_INVALID_ARGUMENT: they are damaged or of another release.
    """


@_function(status, ensemble, POINTER(c_size_t))
def ensemble_snapshot_size(ensemble, size):
    """Reads the size that a snapshot has now: about 1.3 to 5.25 KiB for each run, as for a simulator."""


@_function(status, ensemble, _Array(c_char), POINTER(c_size_t))
def ensemble_snapshot_save(ensemble, buffer, written):
    """Saves the whole ensemble, at any moment, as sins.snapshot_save() does for a simulator. written (may be NULL) gets
    the size. The same state gives the same bytes. No allocation, no system call.

    sins.ERROR_BUFFER_TOO_SMALL: see sins.ensemble_snapshot_size(); buffer and written are unchanged.
    """


@_function(status, ensemble, _Array(c_char, is_input=True))
def ensemble_snapshot_load(ensemble, snapshot):
    """Replaces the ensemble by the saved one, including its runs and options. So the handle may be any ensemble, for
    example of one run. The loaded ensemble continues with the same bits as the saved one. size is the size that
    sins.ensemble_snapshot_save() wrote. Not for a real-time frame: it allocates.

    sins.ERROR_SNAPSHOT: the bytes are not a snapshot of an ensemble, or are cut off, altered, or of a newer release;
    nothing has changed, and sins.last_error(NULL, ...) reports which it is. sins.ERROR_OUT_OF_MEMORY: no memory for a
    second ensemble.
    """


@_function(status, c_int32, POINTER(gyro_params))
def gyro_preset(grade, params):
    """Fills params with the gyro errors of a grade, of enum sins.grade. Biases, scale factor errors and misalignments
    are drawn at turn-on with the standard deviations that the source of the grade states; errors that it does not
    state are 0.

    sins.ERROR_INVALID_ARGUMENT: no such grade.
    """


@_function(status, c_int32, POINTER(accel_params))
def accel_preset(grade, params):
    """Fills params with the accelerometer errors of a grade, as sins.gyro_preset().

    sins.ERROR_INVALID_ARGUMENT: no such grade.
    """


@_function(status, POINTER(flight_start), _Array(manoeuvre, is_input=True), _New(flight))
def flight_create(start, manoeuvres, flight):
    """Creates a flight from an array of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed
    forms of time, smooth to the third derivative; the position is their integral, exact to rounding.
    manoeuvres[0].struct_size is the size in bytes of each element of manoeuvres.

    Not for a real-time frame: it allocates, and integrates the path in pieces, about 15 us and 0.5 KB each. A piece
    of straight flight lasts up to 600 s. With a fast sinusoid of course, climb or speed, a piece is about one period.
    Sinusoids of roll, pitch and heading need no pieces.

    On an error *flight is unchanged, and sins.last_error(NULL, ...) on this thread gives the reason.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or a path that leaves the range of
    sins.flight_sample.height_m (the index in the sentence is that of the manoeuvre). sins.ERROR_OUT_OF_MEMORY: no
    memory, more than 200000 pieces (which take 3 s), or 4096 flights exist.
    """


@_function(status, flight, POINTER(c_double))
def flight_duration(flight, duration_s):
    """Reads the duration of the flight [s]."""


@_function(status, flight, c_double, POINTER(flight_sample))
def flight_sample_at(flight, time_s, sample):
    """Reads the sample at time_s, from 0 to the duration [s]. It is exact at any time, and times may come in any order.
    No allocation; 0.5 to 2 us.

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

    On an error *scene is unchanged, and sins.last_error(NULL, ...) on this thread gives the reason, as for every
    function of scenes. sins.ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes exist. Functions of scenes allocate: only
    sins.scene_prepare() and sins.scene_prepare_ensemble() are for a real-time frame. The other functions of scenes
    first check that enough memory is free for the call. If another thread takes this memory during the call, the
    process ends. sins.log_parse() does the same, except that running out of memory for the samples is always
    sins.ERROR_OUT_OF_MEMORY.
    """


@_function(status, _Array(c_char, is_input=True), _New(scene))
def scene_parse(text, scene):
    """Creates a scene from its text: TOML in UTF-8, at most 1 MiB. The library does not keep the bytes.
    sins.scene_write_keys() and sins.scene_get_key() list the keys.

    sins.SCENE_HAS_FAULTS: the text is not a valid scene; sins.scene_get_fault() gives every fault and its place. The
    handle is made for that only: all other functions except sins.scene_destroy() return sins.ERROR_BAD_STATE.
    sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, scene, c_size_t, POINTER(fault))
def scene_get_fault(scene, index, fault):
    """Reads fault `index` of the scene's text, from 0 in the order of the text; fault->count is the number of faults.
    After sins.scene_set_values() and sins.scene_set_items() the faults are those of that call; none if it succeeded.

    sins.ERROR_INVALID_ARGUMENT: there is no such fault.
    """


@_function(status, _Text, _New(scene))
def scene_create_builtin(name, scene):
    """Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
    "over_the_pole", "coning", "commuter".

    sins.ERROR_INVALID_ARGUMENT: no scene has that name.
    sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, c_size_t, _Array(c_char), POINTER(c_size_t))
def scene_builtin_name(index, buffer, needed):
    """Reads the name of built-in scene `index`, from 0. buffer, capacity and needed as in sins.scene_write().

    sins.ERROR_INVALID_ARGUMENT: there are no more.
    """


@_function(status, scene, _Array(c_char), POINTER(c_size_t))
def scene_write(scene, buffer, needed):
    """Writes the scene as commented TOML, which sins.scene_parse() reads back to the same scene, to the bit.

    needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for the
    size only. sins.ERROR_BUFFER_TOO_SMALL: the text was cut. sins.ERROR_INVALID_ARGUMENT: settings that do not go
    together, or so many manoeuvres and failures that the text would have more than 1 MiB. sins.ERROR_BAD_STATE: as
    sins.scene_parse().
    """


@_function(status, _Array(c_char), POINTER(c_size_t))
def scene_write_keys(buffer, needed):
    """Writes every section and key of a scene, one in a line, with its values, its unit and its meaning. buffer,
    capacity and needed as in sins.scene_write().
    """


@_function(status, scene, _New(sim))
def scene_create_simulator(scene, sim):
    """Creates the simulator of the scene, ready for the first sample: options, sensor errors, initial errors, mounting,
    gravity disturbance. sins.scene_prepare() sets the failures at their times. If the flight is not a log,
    sins.options.sample_period_s of the simulator is 1 / rate_hz.

    sins.ERROR_INVALID_ARGUMENT: settings that do not go together.
    sins.ERROR_BAD_STATE: as sins.scene_parse().
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
    """Destroys a scene. Simulators and flights that were created from it stay valid.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, scene, sim, c_double, POINTER(flight_sample))
def scene_prepare(scene, sim, flight_start_s, sample):
    """Prepares the next interval: call this function before each push, and call sins.step() before you call it again.
    The sample gets the temperature of the scene, if the scene has one. The call sets and clears the failures of the
    scene on sim. A failure begins at the first interval that starts at or after from_s, and ends at the first
    interval that starts at or after until_s. If the scene plans no failure of an output, the call does not touch the
    failure of that output. flight_start_s is the time stamp of the flight's first sample. No allocation, no system
    call.

    sins.ERROR_BAD_HANDLE: scene or sim is not a valid handle.
    sins.ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s not from -2e10 to 2e10.
    sins.ERROR_BAD_STATE: as sins.scene_parse().
    """


@_function(status, scene, ensemble, c_double, POINTER(flight_sample))
def scene_prepare_ensemble(scene, ensemble, flight_start_s, sample):
    """Prepares the next interval of all runs of an ensemble, as sins.scene_prepare() does for a simulator. No
    allocation, no system call.

    sins.ERROR_BAD_HANDLE: scene or ensemble is not a valid handle. The other errors: as sins.scene_prepare().
    """


@_function(status, scene, POINTER(options))
def scene_get_options(scene, options):
    """Reads the options of the scene.

    sins.ERROR_BAD_STATE: as sins.scene_parse(), as for all functions that read or set a part of a scene.
    """


@_function(status, scene, POINTER(options))
def scene_set_options(scene, options):
    """Sets the options of the scene. As with every part, an error leaves the scene unchanged. Parts can be set in any
    order: whether they go together is checked when the scene is written, and when its simulator is created.

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
    """Reads the mounting of the scene's sensor block."""


@_function(status, scene, POINTER(mounting))
def scene_set_mounting(scene, mounting):
    """Sets the mounting of the scene's sensor block.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(gravity_params))
def scene_get_gravity_disturbance(scene, params):
    """Reads the gravity disturbance of the scene."""


@_function(status, scene, POINTER(gravity_params))
def scene_set_gravity_disturbance(scene, params):
    """Sets the gravity disturbance of the scene.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(scene_setup))
def scene_get_setup(scene, setup):
    """Reads the settings of a scene for its flight and its output."""


@_function(status, scene, POINTER(scene_setup))
def scene_set_setup(scene, setup):
    """Sets the settings of a scene for its flight and its output; the fields flight and flown_s are ignored.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range.
    """


@_function(status, scene, POINTER(flight_start), _Array(manoeuvre), POINTER(c_size_t), POINTER(c_size_t))
def scene_get_manoeuvres(scene, start, manoeuvres, count, repeat):
    """Reads the flight of the scene, composed of manoeuvres or built-in: its start, its manoeuvres, their number
    (count), and how many times all of them are flown (repeat). manoeuvres[0].struct_size is the size in bytes of each
    element of manoeuvres. start and repeat may be NULL. To ask for count only, give NULL for manoeuvres and a
    capacity of 0.

    sins.ERROR_BUFFER_TOO_SMALL: capacity is less than the number of manoeuvres; only count was written.
    sins.ERROR_BAD_STATE: the flight is a log; or as sins.scene_parse().
    """


@_function(status, scene, POINTER(flight_start), _Array(manoeuvre, is_input=True), c_size_t)
def scene_set_manoeuvres(scene, start, manoeuvres, repeat):
    """Composes the flight of the scene of an array of count manoeuvres, all flown repeat times; count * repeat is at
    most 4096. start->earth is ignored: the ellipsoid is that of the scene's options. If the flight was a log before,
    the new flight is sampled at 100 Hz.

    sins.ERROR_INVALID_ARGUMENT: as sins.flight_create(), except that heights along the path are not checked.
    """


@_function(status, scene, c_int32, _Array(c_char), POINTER(c_size_t))
def scene_get_text(scene, which, buffer, needed):
    """Reads a text of the scene; which is of enum sins.scene_text. An empty text means that it is not set. buffer,
    capacity and needed as in sins.scene_write().

    sins.ERROR_INVALID_ARGUMENT: no such text.
    """


@_function(status, scene, c_int32, _Text)
def scene_set_text(scene, which, text):
    """Sets a text of the scene; which is of enum sins.scene_text. The text is UTF-8, terminated, at most 4096 bytes. An
    empty text clears it, except sins.SCENE_TEXT_LOG and sins.SCENE_TEXT_BUILTIN, which cannot be empty.

    sins.ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
    """


@_function(status, scene, POINTER(c_size_t))
def scene_get_failure_count(scene, count):
    """Reads the number of failures that the scene plans."""


@_function(status, scene, c_size_t, POINTER(planned_failure))
def scene_get_failure(scene, index, failure):
    """Reads planned failure `index`, from 0.

    sins.ERROR_INVALID_ARGUMENT: no such failure.
    """


@_function(status, scene, POINTER(planned_failure))
def scene_add_failure(scene, failure):
    """Adds a planned failure.

    sins.ERROR_INVALID_ARGUMENT: a value out of its range, or a failure of the same output at the same time.
    """


@_function(status, scene)
def scene_clear_failures(scene):
    """Removes all planned failures."""


@_function(status, c_size_t, POINTER(scene_key))
def scene_get_key(index, key):
    """Reads key `index` of the scene format, from 0 in the order in which a scene is written.

    sins.ERROR_INVALID_ARGUMENT: there are no more.
    sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, scene, _Text, _Array(c_char), POINTER(c_size_t))
def scene_get_value(scene, path, buffer, needed):
    """Reads the value at a path, as it stands in the text of a scene: "gyro.bias_deg_h" (all three),
    "gyro.bias_deg_h[1]" (that of the y axis), "gyro.bias_rad_s" (in SI), "options.scheme", "manoeuvre[3].bank_deg",
    "manoeuvre[3].sinusoid[0].channel", "failure[0].kind". Places in lists begin at 0. Words and texts are in quotes.
    The text is empty if the scene has no such value. For example, flight.hours is empty if the scene flies the whole
    flight. The scene stores numbers in SI, so a number read in another unit may be rounded. The scene does not store
    the name of a preset, only the errors that the preset sets.

    The paths "manoeuvre[3]" and "failure[0]" give all lines of an item, for sins.scene_set_items(). A built-in flight
    and a log have no such manoeuvres. buffer, capacity and needed as in sins.scene_write().

    sins.ERROR_INVALID_ARGUMENT: the path names no value, or the scene has no such item.
    """


@_function(status, scene, _Text)
def scene_set_values(scene, values):
    """Sets up to 4096 values of the scene, all or none. values is a terminated text in UTF-8. Each line is path = value,
    with a path as in sins.scene_get_value(). Blank lines and lines that begin with # are ignored. A value is written
    as in the text of a scene, but words and texts need no quotes. An empty value (gyro.bias_deg_h =) sets the default
    of the key. If the path is a single element (gyro.bias_deg_h[1] =), it sets 0. If a value is set twice, the last
    one counts. gyro.preset replaces all errors of the gyros, accelerometer.preset those of the accelerometers, before
    the other lines are applied, wherever it stands. flight.file and flight.builtin replace the flight.

    The scene is then checked as sins.scene_parse() checks a text. Set values that depend on each other in one call,
    such as the kind of a manoeuvre and its quantities.

    sins.ERROR_INVALID_ARGUMENT: the scene would not be valid, and stays as it was. sins.scene_get_fault() gives every
    fault with the line in values and the path. sins.ERROR_OUT_OF_MEMORY: as sins.scene_create().
    """


@_function(status, scene, _Text, _Text)
def scene_set_items(scene, list, items):
    """Replaces all items of a list, "manoeuvre" or "failure". items is a terminated text with the items as in the text
    of a scene: [[manoeuvre]] and its keys, and so on. sins.scene_get_value() gives the text of one item. To add,
    remove or move an item, give the texts of all items that the list shall have, in order. An empty text removes all
    failures; for "manoeuvre" an empty text is a fault. If the flight was a built-in flight, the manoeuvres begin at
    its start; if it was a log, at latitude 0, longitude 0, height 0.

    sins.ERROR_INVALID_ARGUMENT: no such list, or the scene would not be valid; it stays as it was.
    sins.scene_get_fault() gives every fault with the line in items and the path. sins.ERROR_OUT_OF_MEMORY: as
    sins.scene_create().
    """


@_function(status, _Array(c_char, is_input=True), _New(log), POINTER(fault))
def log_parse(text, log, fault):
    """Reads a flight log, comma-separated values in UTF-8, in lines that end with LF or CR LF. The first line that is
    not a comment (#) names the columns, in any order; columns of other names are ignored, and a row with more fields
    than columns is a fault:

    time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg,
    heading_rad or _deg; optional: velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s,
    rate_z_rad_s; force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c

    The three velocities are all present or all absent; so are the three rates, and the three forces. Without
    velocities the samples have sins.SAMPLE_NO_VELOCITY. Two columns of one quantity are a fault. Frames and signs are
    those of sins.flight_sample. A log has at least two samples, each later than the one before. The ranges of the
    values are checked when a sample is pushed. The library does not keep the bytes. Not for a real-time frame: it
    allocates, 184 bytes a sample.

    sins.ERROR_INVALID_ARGUMENT: the text is not a valid flight log; fault (may be NULL) gets the first fault and its
    place, sins.last_error(NULL, ...) gives both as a sentence, and *log is unchanged. sins.ERROR_OUT_OF_MEMORY: no
    memory for the samples, or 4096 logs exist.
    """


@_function(status, log, POINTER(log_info))
def log_get_info(log, info):
    """Reads the number of samples of a log, its duration and its title."""


@_function(status, log, c_size_t, POINTER(flight_sample), POINTER(c_uint64))
def log_get_sample(log, index, sample, line):
    """Reads sample `index`, from 0 in the order of the log, ready for sins.push_sample(). line (may be NULL) gets its
    line in the text, from 1. No allocation.

    sins.ERROR_INVALID_ARGUMENT: no such sample.
    """


@_function(status, log)
def log_destroy(log):
    """Destroys a flight log.

    sins.ERROR_BAD_HANDLE: null, made up, or destroyed before.
    """


@_function(status, scene, log, POINTER(scene_samples))
def scene_get_samples(scene, log, samples):
    """Reads which samples the scene flies. If the flight is composed of manoeuvres or is built-in, give NULL for `log`;
    sample k is then sins.flight_sample_at(flight, k / rate_hz) of sins.scene_create_flight(). For a log, sample k is
    sins.log_get_sample(log, k); the samples end at the duration that the scene sets.

    sins.ERROR_INVALID_ARGUMENT: the flight is not valid, the log has no second sample within the duration, or
    sins.scene_setup.every_s is less than the time between two samples.
    sins.ERROR_BAD_HANDLE: scene or log is not a valid handle.
    sins.ERROR_BAD_STATE: the flight is a log, and log is NULL; or as sins.scene_parse().
    """


@_function(status, sim, _Array(flight_sample, is_input=True), POINTER(requirement), POINTER(options), POINTER(cost))
def recommend(configured, samples, requirement, options, cost):
    """Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples.
    samples[0].struct_size is the size in bytes of each element of samples.

    configured is a simulator as the host flies it, at any moment. The call uses only its options and its mounting,
    reads them at the start, and neither steps nor changes the simulator. NULL is the recommended simulator with its
    sensor block at the reference point. The output `options` gets the options of configured, ready for sins.create().
    Only scheme, subsamples and updates_per_sample are replaced by the recommended values. The values of these three
    in configured do not matter.

    The piece must contain the hardest motion of the flight: its largest rates, specific forces and vibration. A
    calmer piece, such as the time on the ramp, gives an answer that is false for the flight. The plainest piece is
    the whole flight.

    Each algorithm flies the piece with ideal sensors in the same mounting. Its solution is compared at every sample
    with a reference: a solution of sins.SCHEME_POLYNOMIAL in Earth-fixed axes with 16 updates of 5 subsamples. The
    uncertainty of the reference (its difference from a solution with half as many updates) is added to the error. The
    error is that of the algorithm only. Errors of sensors, altimeter and believed mounting, initial errors, the
    gravity disturbance, and contradictions within the host's samples are left out, because they act on both solutions
    alike. The signals are without the trim of sins.SIGNAL_CLOSED_LOOP, which would hide the error. If the duration is
    longer than the piece, the call assumes that the piece is repeated. Each repetition adds the same errors with the
    same sign. The call assumes the worst phase of the Schuler oscillation. If the flight continues like the piece,
    its errors are smaller than this prediction. With sins.VERTICAL_FREE each error is taken as a height error, which
    grows e-fold every 569 s.

    Algorithms are ordered by instructions_per_step, so the same samples give the same answer on every machine; only
    ns_per_step differs. Not for a real-time frame: it allocates, and takes about 25 to 70 us a sample, up to 0.4 ms
    if nothing meets the requirement.

    sins.REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the algorithm that
    comes closest. sins.ERROR_INVALID_ARGUMENT: a value out of its range. sins.ERROR_TIME_ORDER,
    sins.ERROR_DISCONTINUITY: as sins.push_sample(). sins.ERROR_SINGULAR: too close to a pole, in geographic axes.
    sins.ERROR_DIVERGED: the solution of every algorithm diverged. sins.ERROR_OUT_OF_MEMORY: no memory.

    sins.last_error(NULL, ...) on this thread gives the reason and the sample.
    """


@_function(status, sim, _Array(flight_sample, is_input=True), POINTER(budget_request), _Array(budget_row), POINTER(c_size_t), POINTER(budget))
def error_budget(configured, samples, request, rows, written, budget):
    """Computes the contribution of each effect to the errors of a flight of 2 to 1e9 samples: which effects matter, and
    which can be left out. samples[0].struct_size is the size in bytes of each element of samples, rows[0].struct_size
    that of each element of rows. struct_size of the other samples may be 0, that of the other rows anything.

    configured is a simulator as the host flies it, at any moment. The call uses its options and all its errors: those
    of gyros, accelerometers and altimeter, the initial errors, and those of mounting and gravity, but not its
    failures. The call reads them at the start, and neither steps nor changes the simulator. NULL is the recommended
    simulator without errors. NULL for request is 16 runs and no limits. written and budget may be NULL.

    Each field that sets an error is one effect. An effect is active, and has a row, if its field is not 0. These
    settings are not effects: the alignment, and lever_arm_m and boresight_rad of the mounting. The misalignment that
    sins.ALIGNMENT_LEVEL_AND_GYROCOMPASS leaves belongs to the effect that causes this misalignment. All runs use
    lever_arm_m and boresight_rad. The contribution of an effect is the error (navigation less truth) of a run with
    this effect alone, less the error of a run with no effect. For position, velocity and misalignment the row has two
    lengths of the contribution. One is the largest length at up to 1000 equally spaced instants. The other is the
    length at the last sample. The contribution of a random effect is one standard deviation, by the covariance of a
    flight with this effect alone (sins.BUDGET_RANDOM; see sins.covariance), from linear error equations. All effects
    together are flown in several runs, with the random numbers of the runs sins.options.run, run + 1 and so on.

    rows[0] is the mechanization's own error, including contradictions within the samples. The effects follow, ordered
    by position, then velocity, then misalignment, the largest first; with limits, by their share of a limit. The
    remainder is the difference between the error with all effects and the sum of the rows, with the same random
    numbers. It comes from effects that act on each other, and is of second order in their sizes.

    With limits, the call marks the effects that can be left out together (sins.BUDGET_CAN_BE_LEFT_OUT). It goes
    through the effects in the order of their shares, the smallest first, and collects each effect that still fits.
    For position, velocity and misalignment separately, let D be the sum of the deterministic contributions of a
    collection, and R the root sum of squares of its random contributions. The collection fits if sqrt(D^2 + R^2) is
    at most the limit, for each limit that is given. Then the call flies all runs again without these effects. While
    the change (left_out) exceeds a limit, it puts back the largest of the effects that were left out.

    The same samples give the same answer on every machine, except for the figures ns_per_step. Not for a real-time
    frame: it allocates, and flies the samples many times, each time in 0.6 to 1.5 us a sample. It flies them once
    with no effect, once for each effect, once in each run with all effects together, and, if there are random
    effects, once in each run with the random effects alone. With limits it flies them once more in each run, and
    further times if effects do not add up. time_steps adds 61 rounds of about 250 steps with no effect, with all, and
    without each effect.

    sins.ERROR_BUFFER_TOO_SMALL: capacity is less than the number of rows; written gets that number, and nothing is
    flown. (To ask for the number, give NULL for rows and a capacity of 0.) sins.ERROR_INVALID_ARGUMENT: a value out
    of its range. sins.ERROR_TIME_ORDER, sins.ERROR_DISCONTINUITY: as sins.push_sample(). sins.ERROR_SINGULAR: too
    close to a pole, in geographic axes or for gyrocompassing. sins.ERROR_DIVERGED: a solution diverged.
    sins.ERROR_OUT_OF_MEMORY: no memory.

    sins.last_error(NULL, ...) on this thread gives the reason and the sample.
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
