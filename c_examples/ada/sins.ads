--  The interface of the library sins for Ada 2012: the names, the units and the documentation are those of include/sins.h, which
--  begins with the rules for all functions. An argument that is called record there is called the_record here.
--
--  Structs. Every variable of a record type is ready to use: struct_size is set, and all other fields are zero, which is off
--    or recommended. Where the documentation says that a pointer to a struct may be NULL, pass a fresh variable: it means
--    the same. Arrays count from 0, as in C, and matrices are (row, column).
--  Handles of simulators, flights, scenes and logs are access types that begin as null. They are never followed.
--  Texts. A text for the library is Interfaces.C.To_C ("patrol"). To_Ada and Interfaces.C.Strings.Value convert a text of the
--    library to a String.
--  Flags are Unsigned_32, or Integer_32 where those of C are: (Unsigned_32 (flags) and SINS_IMU_GYRO_INVALID) /= 0.
--
--  This file is written by build.rs from the Rust sources; do not edit it.

with Interfaces;           use Interfaces;
with Interfaces.C;         use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System;

package Sins is

   --  degree [rad]
   SINS_DEG : constant double := 1.7453292519943295e-2;
   --  minute of arc [rad]
   SINS_ARCMIN : constant double := 2.908882086657216e-4;
   --  second of arc [rad]
   SINS_ARCSEC : constant double := 4.84813681109536e-6;
   --  degree per hour [rad/s]
   SINS_DEG_PER_HOUR : constant double := 4.84813681109536e-6;
   --  degree per root hour, angle random walk [rad/sqrt(s)]
   SINS_DEG_PER_SQRT_HOUR : constant double := 2.908882086657216e-4;
   --  g [m/s2]
   SINS_STANDARD_GRAVITY : constant double := 9.80665e0;
   --  millionth of g [m/s2]
   SINS_MICRO_G : constant double := 9.806649999999999e-6;
   --  micro-g per root hertz, velocity random walk [(m/s)/sqrt(s)]
   SINS_MICRO_G_PER_SQRT_HZ : constant double := 9.806649999999999e-6;
   --  part per million
   SINS_PPM : constant double := 1.0e-6;
   --  knot [m/s]
   SINS_KNOT : constant double := 5.144444444444445e-1;
   --  nautical mile [m]
   SINS_NMI : constant double := 1.852e3;
   --  nautical mile per hour [m/s]
   SINS_NMI_PER_HOUR : constant double := 5.144444444444445e-1;

   --  Version of the interface that this header declares: a host compares it with what sins_abi_version() gives. The number
   --  changes if a part of the interface is removed or changes its meaning. Additions at the end do not change it.
   SINS_HEADER_ABI : constant := 1;
   --  Major number of this release of the library, by semantic versioning.
   SINS_VERSION_MAJOR : constant := 0;
   --  Minor number of this release.
   SINS_VERSION_MINOR : constant := 1;
   --  Patch number of this release.
   SINS_VERSION_PATCH : constant := 0;
   --  A buffer of this size holds every snapshot of a simulator that this release saves. For a library newer than this header
   --  ask sins_snapshot_size(); for an ensemble ask sins_ensemble_snapshot_size().
   SINS_SNAPSHOT_MAX_SIZE : constant := 20480;

   --  Result of a call: SINS_OK is 0, a negative status is an error, a positive status is neither. After an error nothing has
   --  changed, with the exceptions under Errors.
   subtype sins_status is Integer_32;

   --  Values of a sins_status: 0 is success, a negative status is an error, a positive status is neither.
   subtype sins_status_code is Integer_32;
   --  The call did what it says.
   SINS_OK : constant sins_status_code := 0;
   --  There is no sample yet, or no complete interval: push the next sample.
   SINS_NEED_SAMPLE : constant sins_status_code := 1;
   --  sins_recommend(): no options meet the requirement. The outputs hold the options that come closest.
   SINS_REQUIREMENT_NOT_MET : constant sins_status_code := 2;
   --  The text of a scene has faults. The handle was made, but only sins_scene_get_fault() and sins_scene_destroy() accept it.
   SINS_SCENE_HAS_FAULTS : constant sins_status_code := 3;
   --  The sample was accepted, or all samples of the run were flown, but there is a gap: an interval of more than 2.5 times
   --  each of the two before it. The library assumes that the vehicle moved during the gap: 213 m in 1 s at 213 m/s. If the
   --  vehicle stood still while the host's clock ran on, this is wrong: see sins_move_time().
   SINS_GAP : constant sins_status_code := 4;
   --  A pointer is null where null is not allowed.
   SINS_ERROR_NULL_POINTER : constant sins_status_code := -1;
   --  The handle is null, made up, destroyed, or of another kind.
   SINS_ERROR_BAD_HANDLE : constant sins_status_code := -2;
   --  A struct_size that no release knows, or a struct of a newer release that sets a field which this release lacks.
   SINS_ERROR_STRUCT_SIZE : constant sins_status_code := -3;
   --  A value out of its range; sins_last_error() names field, value and limit.
   SINS_ERROR_INVALID_ARGUMENT : constant sins_status_code := -4;
   --  A call at the wrong moment, a nested call, or a call on a handle that an abandoned call holds (see Threads).
   SINS_ERROR_BAD_STATE : constant sins_status_code := -5;
   --  A sample that is not later than the one before, or off the stated sample period.
   SINS_ERROR_TIME_ORDER : constant sins_status_code := -6;
   --  The truth jumped: a gap of more than max_gap_s, a jump of position, velocity or attitude, or a turn of 170 degrees or more
   --  between two samples. See sins_move_truth().
   SINS_ERROR_DISCONTINUITY : constant sins_status_code := -7;
   --  The queue of samples is full: step first.
   SINS_ERROR_QUEUE_FULL : constant sins_status_code := -8;
   --  The solution diverged: it left its limits. The last good solution of a simulator stays readable; that of a run of an
   --  ensemble does not.
   SINS_ERROR_DIVERGED : constant sins_status_code := -9;
   --  Too close to a pole: the mechanization in geographic axes, or within 64 km an alignment by gyrocompassing.
   SINS_ERROR_SINGULAR : constant sins_status_code := -10;
   --  A buffer is too small for the result.
   SINS_ERROR_BUFFER_TOO_SMALL : constant sins_status_code := -11;
   --  No memory, or no free handle; on Windows too few TLS indexes (see Unloading).
   SINS_ERROR_OUT_OF_MEMORY : constant sins_status_code := -12;
   --  The bytes are not a snapshot, or are one that is damaged or of a newer release.
   SINS_ERROR_SNAPSHOT : constant sins_status_code := -13;
   --  A defect inside the library was caught. This handle returns this status from now on; other handles still work.
   SINS_ERROR_INTERNAL : constant sins_status_code := -99;

   --  Axes in which the mechanization integrates.
   subtype sins_frame is Integer_32;
   --  Navigation in Earth-fixed axes: regular everywhere, poles included.
   SINS_FRAME_EARTH_FIXED : constant sins_frame := 0;
   --  Navigation in east-north-up, as in the paper. The mechanization returns SINS_ERROR_SINGULAR within 6.4 km of a pole. It
   --  also returns this error if the vehicle moves in one update by more than 1 % of its distance to the pole. For example, at
   --  250 m/s with updates of 1 s this is within 25 km.
   SINS_FRAME_GEOGRAPHIC : constant sins_frame := 1;

   --  Algorithms of the mechanization.
   subtype sins_scheme is Integer_32;
   --  Coning, sculling and exact rotation compensation; Earth terms from the middle of the update.
   SINS_SCHEME_EXACT : constant sins_scheme := 0;
   --  The paper's equations (7)-(24), misprints corrected, approximations kept.
   SINS_SCHEME_PAPER : constant sins_scheme := 1;
   --  As SINS_SCHEME_EXACT, with rate and force as polynomials through the subsamples: for large rotations within an update.
   SINS_SCHEME_POLYNOMIAL : constant sins_scheme := 2;

   --  What stabilizes the vertical channel.
   subtype sins_vertical is Integer_32;
   --  Third-order loop on a barometric height, time constant 100 s. The response differs from the response of a continuous loop
   --  by the fraction 3.5e-5 at a sample rate of 1 Hz, and 3.5e-7 at 10 Hz. The difference is of second order in the sample
   --  interval.
   SINS_VERTICAL_DAMPED : constant sins_vertical := 0;
   --  Height and vertical velocity set to the truth at each sample.
   SINS_VERTICAL_FOLLOW_TRUTH : constant sins_vertical := 1;
   --  Nothing stabilizes the vertical channel: any error grows e-fold every 569 s.
   SINS_VERTICAL_FREE : constant sins_vertical := 2;

   --  Whether the error differential equations are integrated.
   subtype sins_error_model is Integer_32;
   --  No error differential equations: SINS_ERRORS_MODEL is not available.
   SINS_ERROR_MODEL_OFF : constant sins_error_model := 0;
   --  The error differential equations (error data 1) by fourth-order Runge-Kutta.
   SINS_ERROR_MODEL_RK4 : constant sins_error_model := 1;

   --  Whether the library summarizes the true motion.
   subtype sins_summary is Integer_32;
   --  sins_get_truth_summary() is not available.
   SINS_SUMMARY_OFF : constant sins_summary := 0;
   --  sins_get_truth_summary() is available. The other outputs have the same bits as without.
   SINS_SUMMARY_ON : constant sins_summary := 1;

   --  Whether the covariance of the navigation errors is propagated.
   subtype sins_covariance_mode is Integer_32;
   --  sins_get_covariance() is not available.
   SINS_COVARIANCE_OFF : constant sins_covariance_mode := 0;
   --  The covariance is propagated along the truth; the other outputs have the same bits.
   SINS_COVARIANCE_ON : constant sins_covariance_mode := 1;

   --  Ellipsoids.
   subtype sins_earth is Integer_32;
   --  World Geodetic System 1984.
   SINS_EARTH_WGS84 : constant sins_earth := 0;
   --  China Geodetic Coordinate System 2000.
   SINS_EARTH_CGCS2000 : constant sins_earth := 1;
   --  Geodetic Reference System 1980.
   SINS_EARTH_GRS80 : constant sins_earth := 2;
   --  Krassovsky 1940; Earth rate and gravitational constant as WGS-84.
   SINS_EARTH_KRASSOVSKY1940 : constant sins_earth := 3;

   --  Formulas of normal gravity.
   subtype sins_gravity is Integer_32;
   --  Normal gravity in closed form at any height, with its north component.
   SINS_GRAVITY_NORMAL : constant sins_gravity := 0;
   --  Somigliana's formula with the second-order height term, along the ellipsoid normal, as in most tools.
   SINS_GRAVITY_SOMIGLIANA : constant sins_gravity := 1;

   --  Directions of the sensor axes.
   subtype sins_axes is Integer_32;
   --  Sensor axes: x right, y forward, z up (the paper's).
   SINS_AXES_RIGHT_FORWARD_UP : constant sins_axes := 0;
   --  Sensor axes: x forward, y right, z down.
   SINS_AXES_FORWARD_RIGHT_DOWN : constant sins_axes := 1;

   --  Ideal signals.
   subtype sins_signal is Integer_32;
   --  Ideal signals are the integrals of the true angular rate and specific force, so the navigation shows the mechanization's
   --  own error.
   SINS_SIGNAL_PHYSICAL : constant sins_signal := 0;
   --  As SINS_SIGNAL_PHYSICAL, plus a small trim that keeps an error-free navigator at the truth for any time, even with a
   --  free vertical channel. It is for hosts that want the errors of the sensors only. sins_accuracy reports the size of the
   --  trim. If the initial state, a sensor or gravity has errors, the library also runs a second navigator without errors to
   --  compute the trim. A step then takes longer.
   SINS_SIGNAL_CLOSED_LOOP : constant sins_signal := 1;

   --  Flags of a sins_error_info.
   subtype sins_error_info_flags is Unsigned_32;
   --  The field value holds the value at fault.
   SINS_ERROR_INFO_VALUE : constant sins_error_info_flags := 1;
   --  The field minimum holds the least allowed value.
   SINS_ERROR_INFO_MINIMUM : constant sins_error_info_flags := 2;
   --  The field maximum holds the greatest allowed value.
   SINS_ERROR_INFO_MAXIMUM : constant sins_error_info_flags := 4;
   --  The field is an integer.
   SINS_ERROR_INFO_INTEGER : constant sins_error_info_flags := 8;

   --  Sensors that can fail.
   subtype sins_sensor is Integer_32;
   --  The gyros.
   SINS_SENSOR_GYRO : constant sins_sensor := 0;
   --  The accelerometers.
   SINS_SENSOR_ACCEL : constant sins_sensor := 1;
   --  The altimeter. Give 0 for the argument axis.
   SINS_SENSOR_ALTIMETER : constant sins_sensor := 2;

   --  Kinds of failure.
   subtype sins_failure_kind is Integer_32;
   --  No failure: clears the failure that is set.
   SINS_FAILURE_NONE : constant sins_failure_kind := 0;
   --  The output stays at its mean over the interval before the failure, as sins_imu reported it; without such an interval, at
   --  its first value. It is not flagged, because it looks like valid data.
   SINS_FAILURE_STUCK : constant sins_failure_kind := 1;
   --  No signal. A gyro or an accelerometer gives 0, and is flagged SINS_IMU_..._INVALID, as by a built-in test. Without the
   --  altimeter nothing stabilizes the vertical channel of SINS_VERTICAL_DAMPED; this is flagged
   --  SINS_NAVIGATION_VERTICAL_UNAIDED.
   SINS_FAILURE_DEAD : constant sins_failure_kind := 2;
   --  An additional bias; its value is in the field `size`. Not flagged.
   SINS_FAILURE_BIAS_STEP : constant sins_failure_kind := 3;
   --  Rectangular pulses. The field `size` is their height, duration_s their length. A pulse starts every interval_s; the first
   --  starts immediately. A sample of the altimeter shows the mean of the pulses over the sample interval. A gyro or an
   --  accelerometer is flagged only if a pulse saturates it.
   SINS_FAILURE_SPIKES : constant sins_failure_kind := 4;
   --  Additional white noise; its density is in the field `density`. A sample of the altimeter shows the mean of the noise over
   --  the sample interval. Not flagged.
   SINS_FAILURE_NOISE : constant sins_failure_kind := 5;
   --  Sample intervals are lost: in each of them the output acts as with SINS_FAILURE_DEAD. Either each interval is lost
   --  independently with the probability in the field `probability`, or one interval is lost every interval_s, the first
   --  immediately.
   SINS_FAILURE_DROP_OUTS : constant sins_failure_kind := 6;

   --  How the INS finds its attitude at the start.
   subtype sins_alignment is Integer_32;
   --  The INS starts with the true attitude, turned by the given and the drawn misalignment.
   SINS_ALIGNMENT_GIVEN : constant sins_alignment := 0;
   --  The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
   --  start. It does so even if the flight starts in motion. The INS starts with this attitude, turned by the given and the
   --  drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense no horizontal force.
   --  Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
   --  if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
   SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS : constant sins_alignment := 1;

   --  Flags of a sins_flight_sample.
   subtype sins_sample_flags is Unsigned_32;
   --  The sample carries angular_rate_rad_s.
   SINS_SAMPLE_ANGULAR_RATE : constant sins_sample_flags := 1;
   --  The sample carries specific_force_m_s2.
   SINS_SAMPLE_SPECIFIC_FORCE : constant sins_sample_flags := 2;
   --  The sample has no velocity. The library derives it from positions. The noise of this velocity is 2 to 4 times the position
   --  noise of a sample, divided by the interval.
   SINS_SAMPLE_NO_VELOCITY : constant sins_sample_flags := 4;
   --  The sample carries temperature_c.
   SINS_SAMPLE_TEMPERATURE : constant sins_sample_flags := 8;

   --  Flags of a sins_navigation.
   subtype sins_navigation_flags is Integer_32;
   --  Within 20 km of the Earth's axis: longitude and heading change fast there, and at the pole they are undefined.
   --  Quaternion, height and the errors in metres stay correct.
   SINS_NAVIGATION_NEAR_POLE : constant sins_navigation_flags := 1;
   --  Nothing aids the vertical channel, because of the options or because the altimeter has no signal: any error grows e-fold
   --  every 569 s.
   SINS_NAVIGATION_VERTICAL_UNAIDED : constant sins_navigation_flags := 2;
   --  A flag of the truth. Let d be the displacement computed from the velocities. The flag is set if the displacement of the
   --  positions since the previous sample differs from d by more than sqrt((0.01 d)^2 + (1 cm)^2).
   SINS_NAVIGATION_INCONSISTENT : constant sins_navigation_flags := 4;
   --  The alignment at the start could not find north, so any heading error is possible. Either the accelerometers show no
   --  force, or the error of the horizontal gyro rates is at least as large as the north component of the Earth rate. (If it is
   --  smaller, the heading error is below 90 degrees.) The flag stays until the INS starts again. Note: a real INS does not know
   --  this error. It can be sure that it has not found north only if its horizontal gyro rate is more than twice the north
   --  component of the Earth rate.
   SINS_NAVIGATION_NORTH_UNKNOWN : constant sins_navigation_flags := 8;

   --  Flags of a sins_imu.
   subtype sins_imu_flags is Unsigned_32;
   --  The mean rate of a subsample was beyond the range of a gyro.
   SINS_IMU_GYRO_SATURATED : constant sins_imu_flags := 1;
   --  The mean force of a subsample was beyond the range of an accelerometer.
   SINS_IMU_ACCEL_SATURATED : constant sins_imu_flags := 2;
   --  A gyro had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of this gyro.
   SINS_IMU_GYRO_INVALID : constant sins_imu_flags := 4;
   --  An accelerometer had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of
   --  this accelerometer.
   SINS_IMU_ACCEL_INVALID : constant sins_imu_flags := 8;

   --  The two sources of errors.
   subtype sins_errors_source is Integer_32;
   --  Navigation minus truth: the paper's error data 2.
   SINS_ERRORS_NAVIGATION : constant sins_errors_source := 0;
   --  The error differential equations: the paper's error data 1 (sins_options.error_model).
   SINS_ERRORS_MODEL : constant sins_errors_source := 1;

   --  Flags of a sins_errors.
   subtype sins_errors_flags is Integer_32;
   --  The truth is within 20 km of the Earth's axis: the errors of longitude and heading, the up misalignment, and the east and
   --  north components of the velocity error have no meaning.
   SINS_ERRORS_NEAR_POLE : constant sins_errors_flags := 1;
   --  A flag of the error model: the terms that it neglects are no longer small. The misalignment is above 2 degrees, or the
   --  position error is above 100 km, or, at high latitude, above 3.5 % of the distance to the pole.
   SINS_ERRORS_OUTSIDE_VALIDITY : constant sins_errors_flags := 2;
   --  In a sins_record: not computed, all zero.
   SINS_ERRORS_NOT_COMPUTED : constant sins_errors_flags := 4;

   --  Grades of sensors.
   subtype sins_grade is Integer_32;
   --  Strategic: gyro bias 0.001 deg/h and accelerometer bias 1e-6 g, each 1 sigma (El-Sheimy and Youssef 2020, table 1, upper
   --  ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix 200).
   SINS_GRADE_STRATEGIC : constant sins_grade := 1;
   --  Navigation: Honeywell HG9900, brochure N61-1638. It states no accelerometer noise, so the preset has none: set your own.
   SINS_GRADE_NAVIGATION : constant sins_grade := 2;
   --  Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated.
   SINS_GRADE_TACTICAL : constant sins_grade := 3;
   --  Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D. It states no accelerometer noise, so the preset
   --  has none: set your own. The range of the sensors is 125 deg/s and 8 g; the angle between two axes differs from 90 deg by
   --  0.1 deg, 1 sigma.
   SINS_GRADE_INDUSTRIAL : constant sins_grade := 4;
   --  Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances are taken as 3 sigma.
   SINS_GRADE_CONSUMER : constant sins_grade := 5;
   --  The paper's simulation 2: constant gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), constant accelerometer
   --  bias 1e-5 g and white noise 5e-6 g, taken as a density of 5e-6 g/sqrt(Hz) (for a bandwidth of 1 Hz, because the paper
   --  states none).
   SINS_GRADE_PAPER_SIMULATION2 : constant sins_grade := 6;

   --  Kinds of manoeuvre.
   subtype sins_manoeuvre_kind is Integer_32;
   --  At rest for duration_s; the speed must be 0.
   SINS_MANOEUVRE_REST : constant sins_manoeuvre_kind := 0;
   --  Along a geodesic at constant speed and height for duration_s.
   SINS_MANOEUVRE_STRAIGHT : constant sins_manoeuvre_kind := 1;
   --  Changes the speed by speed_change_m_s in duration_s.
   SINS_MANOEUVRE_ACCELERATE : constant sins_manoeuvre_kind := 2;
   --  Changes the height by height_change_m in duration_s. Uses ramp_s.
   SINS_MANOEUVRE_CLIMB : constant sins_manoeuvre_kind := 3;
   --  Level coordinated turn by heading_change_rad (right positive) at bank_rad, with ramp_s to roll in and to roll out. The
   --  duration follows from these.
   SINS_MANOEUVRE_TURN : constant sins_manoeuvre_kind := 4;
   --  Whole rolls along a straight path in duration_s; the field turns is their number (positive: right wing down).
   SINS_MANOEUVRE_ROLL : constant sins_manoeuvre_kind := 5;
   --  Whole vertical loops at constant speed in duration_s; the field turns is their number (nose up positive). Uses ramp_s.
   SINS_MANOEUVRE_LOOP : constant sins_manoeuvre_kind := 6;
   --  The course swings by heading_change_rad to both sides, first to the right if it is positive. The field turns is the number
   --  of swings in duration_s. A swing is a full period: to one side, to the other side, and back. Uses ramp_s.
   SINS_MANOEUVRE_S_TURN : constant sins_manoeuvre_kind := 7;
   --  Sum of sinusoid_count sinusoids for duration_s: patrol patterns, rocking, coning, vibration. Uses ramp_s.
   SINS_MANOEUVRE_SINUSOIDS : constant sins_manoeuvre_kind := 8;

   --  What a sinusoid of SINS_MANOEUVRE_SINUSOIDS moves.
   subtype sins_channel is Integer_32;
   --  The sinusoid moves the course [rad], with the bank of a coordinated turn.
   SINS_CHANNEL_COURSE : constant sins_channel := 0;
   --  The sinusoid moves the climb angle [rad].
   SINS_CHANNEL_CLIMB : constant sins_channel := 1;
   --  The sinusoid moves the speed [m/s].
   SINS_CHANNEL_SPEED : constant sins_channel := 2;
   --  The sinusoid moves roll alone [rad].
   SINS_CHANNEL_ROLL : constant sins_channel := 3;
   --  The sinusoid moves pitch alone [rad].
   SINS_CHANNEL_PITCH : constant sins_channel := 4;
   --  The sinusoid moves heading alone [rad].
   SINS_CHANNEL_HEADING : constant sins_channel := 5;

   --  Where the flight of a scene comes from: sins_scene_setup.flight.
   subtype sins_scene_flight is Integer_32;
   --  The flight is composed of manoeuvres.
   SINS_SCENE_FLIGHT_MANOEUVRES : constant sins_scene_flight := 0;
   --  The flight is that of a built-in scene, named by SINS_SCENE_TEXT_BUILTIN.
   SINS_SCENE_FLIGHT_BUILTIN : constant sins_scene_flight := 1;
   --  The flight is a log, named by SINS_SCENE_TEXT_LOG.
   SINS_SCENE_FLIGHT_LOG : constant sins_scene_flight := 2;

   --  The texts of a scene: sins_scene_get_text(), sins_scene_set_text().
   subtype sins_scene_text is Integer_32;
   --  Title: the scene in a few words.
   SINS_SCENE_TEXT_TITLE : constant sins_scene_text := 0;
   --  Path of the flight log, relative to the scene's own folder. Setting it makes the flight a log.
   SINS_SCENE_TEXT_LOG : constant sins_scene_text := 1;
   --  Name of the built-in scene whose flight is flown. Setting it selects that flight.
   SINS_SCENE_TEXT_BUILTIN : constant sins_scene_text := 2;
   --  Folder of the output files of a program.
   SINS_SCENE_TEXT_FOLDER : constant sins_scene_text := 3;
   --  Base name of the output files.
   SINS_SCENE_TEXT_NAME : constant sins_scene_text := 4;
   --  Name of the file for the measured increments.
   SINS_SCENE_TEXT_IMU : constant sins_scene_text := 5;

   --  What kind of value a key of a scene takes.
   subtype sins_scene_key_kind is Integer_32;
   --  Numbers; elements says how many.
   SINS_SCENE_KEY_NUMBERS : constant sins_scene_key_kind := 0;
   --  A whole number, not negative.
   SINS_SCENE_KEY_WHOLE : constant sins_scene_key_kind := 1;
   --  One of several words.
   SINS_SCENE_KEY_WORD : constant sins_scene_key_kind := 2;
   --  A text.
   SINS_SCENE_KEY_TEXT : constant sins_scene_key_kind := 3;
   --  true or false.
   SINS_SCENE_KEY_FLAG : constant sins_scene_key_kind := 4;

   --  Flags of a sins_scene_key.
   subtype sins_scene_key_flags is Unsigned_32;
   --  The key belongs to the items of a list: its section stands in double brackets.
   SINS_SCENE_KEY_IN_LIST : constant sins_scene_key_flags := 1;
   --  The fields minimum and maximum are the limits of each number. Without this flag there are no limits, or the limits depend
   --  on other values.
   SINS_SCENE_KEY_LIMITS : constant sins_scene_key_flags := 2;
   --  0 is allowed in addition to the values within the limits. It switches the quantity off.
   SINS_SCENE_KEY_ZERO_IS_OFF : constant sins_scene_key_flags := 4;

   --  Flags of a sins_budget_row.
   subtype sins_budget_flags is Unsigned_32;
   --  The figures of the row are standard deviations (1 sigma), from linear error equations.
   SINS_BUDGET_RANDOM : constant sins_budget_flags := 1;
   --  The effect can be left out, together with all others that have this flag.
   SINS_BUDGET_CAN_BE_LEFT_OUT : constant sins_budget_flags := 2;

   type sins_sim_object is limited null record;
   type sins_sim is access all sins_sim_object with Convention => C;

   type sins_ensemble_object is limited null record;
   type sins_ensemble is access all sins_ensemble_object with Convention => C;

   type sins_flight_object is limited null record;
   type sins_flight is access all sins_flight_object with Convention => C;

   type sins_scene_object is limited null record;
   type sins_scene is access all sins_scene_object with Convention => C;

   type sins_log_object is limited null record;
   type sins_log is access all sins_log_object with Convention => C;

   SINS_SIZEOF_OPTIONS : constant Unsigned_32 := 104;
   SINS_SIZEOF_FLIGHT_SAMPLE : constant Unsigned_32 := 144;
   SINS_SIZEOF_ERROR_INFO : constant Unsigned_32 := 152;
   SINS_SIZEOF_GYRO_PARAMS : constant Unsigned_32 := 736;
   SINS_SIZEOF_ACCEL_PARAMS : constant Unsigned_32 := 736;
   SINS_SIZEOF_ALTIMETER_PARAMS : constant Unsigned_32 := 56;
   SINS_SIZEOF_FAILURE : constant Unsigned_32 := 56;
   SINS_SIZEOF_INITIAL_ERRORS : constant Unsigned_32 := 160;
   SINS_SIZEOF_MOUNTING : constant Unsigned_32 := 104;
   SINS_SIZEOF_GRAVITY_PARAMS : constant Unsigned_32 := 80;
   SINS_SIZEOF_RECORD_SOLUTION : constant Unsigned_32 := 112;
   SINS_SIZEOF_RECORD_ERRORS : constant Unsigned_32 := 128;
   SINS_SIZEOF_RECORD : constant Unsigned_32 := 496;
   SINS_SIZEOF_NAVIGATION : constant Unsigned_32 := 128;
   SINS_SIZEOF_IMU : constant Unsigned_32 := 216;
   SINS_SIZEOF_ERRORS : constant Unsigned_32 := 144;
   SINS_SIZEOF_ACCURACY : constant Unsigned_32 := 256;
   SINS_SIZEOF_TRUTH_SUMMARY : constant Unsigned_32 := 232;
   SINS_SIZEOF_COVARIANCE : constant Unsigned_32 := 776;
   SINS_SIZEOF_IMU_INCREMENT : constant Unsigned_32 := 264;
   SINS_SIZEOF_STATISTICS : constant Unsigned_32 := 14920;
   SINS_SIZEOF_FIGURES : constant Unsigned_32 := 936;
   SINS_SIZEOF_FLIGHT_START : constant Unsigned_32 := 72;
   SINS_SIZEOF_MANOEUVRE : constant Unsigned_32 := 240;
   SINS_SIZEOF_FAULT : constant Unsigned_32 := 408;
   SINS_SIZEOF_SCENE_SETUP : constant Unsigned_32 := 72;
   SINS_SIZEOF_PLANNED_FAILURE : constant Unsigned_32 := 80;
   SINS_SIZEOF_SCENE_KEY : constant Unsigned_32 := 592;
   SINS_SIZEOF_LOG_INFO : constant Unsigned_32 := 216;
   SINS_SIZEOF_SCENE_SAMPLES : constant Unsigned_32 := 48;
   SINS_SIZEOF_REQUIREMENT : constant Unsigned_32 := 48;
   SINS_SIZEOF_COST : constant Unsigned_32 := 96;
   SINS_SIZEOF_BUDGET_REQUEST : constant Unsigned_32 := 40;
   SINS_SIZEOF_BUDGET_ROW : constant Unsigned_32 := 152;
   SINS_SIZEOF_BUDGET : constant Unsigned_32 := 128;

   subtype sins_char_128 is char_array (0 .. 127);
   subtype sins_char_192 is char_array (0 .. 191);
   subtype sins_char_24 is char_array (0 .. 23);
   subtype sins_char_256 is char_array (0 .. 255);
   subtype sins_char_32 is char_array (0 .. 31);
   subtype sins_char_40 is char_array (0 .. 39);
   subtype sins_char_48 is char_array (0 .. 47);
   subtype sins_char_96 is char_array (0 .. 95);
   type double_array is array (size_t range <>) of aliased double with Convention => C;
   type sins_double_3 is array (0 .. 2) of double with Convention => C;
   type sins_double_3_3 is array (0 .. 2, 0 .. 2) of double with Convention => C;
   type sins_double_4 is array (0 .. 3) of double with Convention => C;
   type sins_double_5_3 is array (0 .. 4, 0 .. 2) of double with Convention => C;
   type sins_double_6 is array (0 .. 5) of double with Convention => C;
   type sins_double_9_9 is array (0 .. 8, 0 .. 8) of double with Convention => C;
   type sins_integer_32_6 is array (0 .. 5) of Integer_32 with Convention => C;
   type sins_unsigned_32_3501 is array (0 .. 3500) of Unsigned_32 with Convention => C;
   type sins_unsigned_64_18 is array (0 .. 17) of Unsigned_64 with Convention => C;
   type sins_unsigned_64_90 is array (0 .. 89) of Unsigned_64 with Convention => C;

   --  Options of a simulator. All zero (except struct_size) is the recommended simulator.
   type sins_options is record
      --  sizeof(sins_options)
      struct_size : Unsigned_32 := SINS_SIZEOF_OPTIONS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Axes of the mechanization, of enum sins_frame.
      frame : Integer_32 := 0;
      --  Algorithm of the mechanization, of enum sins_scheme.
      scheme : Integer_32 := 0;
      --  Number of subsamples of a mechanization update, 1 to 5; 0: 2. A subsample is one of the equal parts of the update; the
      --  sensors give one increment for each.
      subsamples : Integer_32 := 0;
      --  Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (see "Gaps" above).
      updates_per_sample : Integer_32 := 0;
      --  Vertical channel, of enum sins_vertical.
      vertical : Integer_32 := 0;
      --  Error differential equations, of enum sins_error_model.
      error_model : Integer_32 := 0;
      --  Ellipsoid, of enum sins_earth.
      earth : Integer_32 := 0;
      --  Normal gravity, of enum sins_gravity.
      gravity : Integer_32 := 0;
      --  Directions of the body axes and of the sensor axes, of enum sins_axes.
      axes : Integer_32 := 0;
      --  Ideal signals, of enum sins_signal.
      signal : Integer_32 := 0;
      --  Seed of all random streams.
      seed : Unsigned_64 := 0;
      --  Run number. The same seed with another run number gives other random numbers. Run k of an ensemble has the number k.
      run : Unsigned_64 := 0;
      --  Time constant of SINS_SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0: 30 s, for which max_gap_s
      --  must be at most 7.5 s. Must be 0 with another signal.
      closed_loop_time_s : double := 0.0;
      --  Stated sample period, 5e-5 to max_gap_s [s]; 0: the samples' own time stamps count. With a stated period, each
      --  sample is at an exact multiple of the period from the first. The time stamps then serve only to order and to check the
      --  samples: each must be within 0.4 of a period of its multiple.
      sample_period_s : double := 0.0;
      --  Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Use intervals of minutes only for a vehicle at rest.
      --  Even at rest the position error grows with the third power of the interval: within 12 h it reaches 0.09 m with
      --  intervals of 10 s, and 91 m with intervals of 100 s.
      max_gap_s : double := 0.0;
      --  Largest mean acceleration between two samples, 1e-3 to 1e6 [m/s2]; 0: 2000 m/s2. A larger one is rejected as a jump of
      --  the truth.
      max_acceleration_m_s2 : double := 0.0;
      --  Summary of the true motion, of enum sins_summary.
      truth_summary : Integer_32 := 0;
      --  Covariance of the navigation errors, of enum sins_covariance_mode.
      covariance : Integer_32 := 0;
   end record with Convention => C;
   type sins_options_array is array (size_t range <>) of aliased sins_options with Convention => C;

   --  True motion of the vehicle at an instant, as a flight simulator gives it. The ideal signals are computed from velocity and
   --  attitude, and from angular rate and specific force if the sample carries them. Position enters only through gravity and
   --  curvature, unless the samples have no velocity: then the velocity is derived from the positions. Vibration above a tenth
   --  of the sample rate cannot be recovered from samples; give angular rate and specific force if you have them.
   type sins_flight_sample is record
      --  sizeof(sins_flight_sample)
      struct_size : Unsigned_32 := SINS_SIZEOF_FLIGHT_SAMPLE;
      --  Flags of enum sins_sample_flags, or'ed.
      flags : Unsigned_32 := 0;
      --  Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins_options.max_gap_s. Large stamps are coarse
      --  (1.2e-7 s at 1e9 s): state sins_options.sample_period_s with them.
      time_s : double := 0.0;
      --  Geodetic latitude, -pi/2 to pi/2 [rad].
      latitude_rad : double := 0.0;
      --  Longitude, east positive, -100 to 100 [rad]; whole turns do not matter.
      longitude_rad : double := 0.0;
      --  Height above the ellipsoid, -2e4 to 2e6 [m].
      height_m : double := 0.0;
      --  Velocity against the Earth, east-north-up, each -2e4 to 2e4 [m/s].
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Roll, right wing down positive, -1e4 to 1e4 [rad]; whole turns do not matter.
      roll_rad : double := 0.0;
      --  Pitch, nose up positive, -1e4 to 1e4 [rad]; it may go beyond 90 degrees. From one sample to the next the attitude must
      --  turn by less than 170 degrees. The library predicts this turn from the angular rates of the samples, or, without
      --  rates, from the previous interval. The turn must differ from the prediction by less than 180 degrees. Additional whole
      --  turns between two samples cannot be detected.
      pitch_rad : double := 0.0;
      --  Heading, clockwise from true north, -1e4 to 1e4 [rad]; whole turns do not matter.
      heading_rad : double := 0.0;
      --  With SINS_SAMPLE_ANGULAR_RATE: angular rate of the vehicle against inertial space along the body axes at this instant,
      --  each -1000 to 1000 [rad/s].
      angular_rate_rad_s : sins_double_3 := (others => 0.0);
      --  With SINS_SAMPLE_SPECIFIC_FORCE: specific force at the reference point along the body axes at this instant, each -1e5
      --  to 1e5 [m/s2].
      specific_force_m_s2 : sins_double_3 := (others => 0.0);
      --  With SINS_SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant, -273.15 to 1000 [deg C]; linear
      --  from one sample to the next. Needed while temperature coefficients are set: the push of a sample without it then returns
      --  SINS_ERROR_INVALID_ARGUMENT, because a forgotten flag would silently disable the effect.
      temperature_c : double := 0.0;
   end record with Convention => C;
   type sins_flight_sample_array is array (size_t range <>) of aliased sins_flight_sample with Convention => C;

   --  Why a call failed: the data of which the sentence of sins_last_error() is made.
   type sins_error_info is record
      --  sizeof(sins_error_info)
      struct_size : Unsigned_32 := SINS_SIZEOF_ERROR_INFO;
      --  Flags of enum sins_error_info_flags, or'ed.
      flags : Unsigned_32 := 0;
      --  Status that the failed call returned, of enum sins_status_code; SINS_OK if no call failed.
      status : sins_status := 0;
      --  0
      reserved : Unsigned_32 := 0;
      --  Name of the field or argument at fault, such as "gyro.markov_time_s", or of a computed quantity at fault, such as
      --  "navigated position error [m]"; terminated. Empty if the call itself is at fault.
      field : sins_char_96 := (others => nul);
      --  Element of the field, from 0; -1: the field is not an array, or the whole field is at fault.
      index : Integer_64 := 0;
      --  Index of the sample in the array of the call, from 0; -1: no sample is at fault.
      sample : Integer_64 := 0;
      --  With SINS_ERROR_INFO_VALUE: the value at fault, which may be NaN or infinite; for an integer, the nearest double.
      value : double := 0.0;
      --  With SINS_ERROR_INFO_MINIMUM: the least value. If the sentence of sins_last_error() says "more than", the limit itself
      --  is not allowed.
      minimum : double := 0.0;
      --  With SINS_ERROR_INFO_MAXIMUM: the greatest value. If the sentence of sins_last_error() says "less than", the limit
      --  itself is not allowed.
      maximum : double := 0.0;
   end record with Convention => C;
   type sins_error_info_array is array (size_t range <>) of aliased sins_error_info with Convention => C;

   --  Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is an
   --  ideal triad. Signal: the angular rate. Densities do not depend on the sample rate.
   --
   --  Effects act in this order, along the path of the signal: bandwidth; then errors that depend on the signal (scale factor,
   --  misalignment, asymmetry, nonlinearity), on the true specific force (g-sensitivity, g2-sensitivity) and on temperature; then
   --  biases and noise; then dead zone, range, quantization.
   --
   --  Asymmetry, nonlinearity, dead zone and range, g2-sensitivity of the gyros, and vibration rectification of the accelerometers
   --  act on the mean signal of a subsample, whose length is dt = interval / (updates_per_sample * subsamples). The mean reduces
   --  the effect of a vibration of frequency f. With x = pi f dt, nonlinearity and rectification are too small by the fraction 1 -
   --  (sin x / x)^2. Asymmetry is too small by up to the fraction 1 - cos x, if the vibration changes the sign of the signal. If f
   --  is a tenth of the sample rate, these fractions are 0.8 % and 1.2 % with two subsamples per interval, 3.2 % and 4.9 % with
   --  one.
   type sins_gyro_params is record
      --  sizeof(sins_gyro_params)
      struct_size : Unsigned_32 := SINS_SIZEOF_GYRO_PARAMS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Constant bias, measured less true [rad/s], -100 to 100.
      bias_rad_s : sins_double_3 := (others => 0.0);
      --  Standard deviation of the turn-on bias, drawn once a run [rad/s], 0 to 100.
      bias_sigma_rad_s : sins_double_3 := (others => 0.0);
      --  Standard deviation of the first-order Gauss-Markov bias [rad/s], 0 to 100. The process is stationary from
      --  the first sample on.
      markov_sigma_rad_s : sins_double_3 := (others => 0.0);
      --  Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_rad_s is not 0.
      markov_time_s : sins_double_3 := (others => 0.0);
      --  White noise N: angle random walk [rad/sqrt(s)], 0 to 100. It is the square root of the spectral density of
      --  the noise, in the unit of the signal per sqrt(Hz).
      random_walk_rad_sqrt_s : sins_double_3 := (others => 0.0);
      --  Rate random walk K [(rad/s)/sqrt(s)], 0 to 100. It starts at 0 at the start of a run.
      rate_random_walk_rad_s_sqrt_s : sins_double_3 := (others => 0.0);
      --  Ramp R: bias that grows with time [rad/s2], -100 to 100. The bias starts at 0 when the ramp is switched on,
      --  and at sins_reset(). If R is changed in flight, the bias continues from its present value.
      rate_ramp_rad_s2 : sins_double_3 := (others => 0.0);
      --  Flicker noise, bias instability B [rad/s], 0 to 100. The process is stationary from the first sample on: the
      --  Allan deviation is flat at 0.664 B from 2 s to 50 h.
      flicker_rad_s : sins_double_3 := (others => 0.0);
      --  Scale factor error [1], -1 to 1.
      scale_factor : sins_double_3 := (others => 0.0);
      --  Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
      --  scale_factor.
      scale_factor_sigma : sins_double_3 := (others => 0.0);
      --  Scale factor error for positive signals less that for negative signals [1], -1 to 1. The error of a signal s
      --  is half of this times |s|.
      scale_factor_asymmetry : sins_double_3 := (others => 0.0);
      --  Scale factor error that grows with the size of the signal [s/rad], -1 to 1. The error of a signal s is this
      --  times s |s|.
      scale_factor_nonlinearity_s_rad : sins_double_3 := (others => 0.0);
      --  Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error of sensor i is the
      --  sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
      misalignment_rad : sins_double_3_3 := (others => (others => 0.0));
      --  Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
      --  misalignment_rad. The diagonal must be 0.
      misalignment_sigma_rad : sins_double_3_3 := (others => (others => 0.0));
      --  Drift caused by specific force, g-sensitivity: row = gyro, column = axis of the force [(rad/s)/(m/s2)],
      --  -1 to 1. The error of a gyro is the sum over the three axes of its row times the true specific force along
      --  them.
      g_sensitivity_rad_s_per_m_s2 : sins_double_3_3 := (others => (others => 0.0));
      --  Drift caused by the square of the specific force along the gyro's own axis, g2-sensitivity [(rad/s)/(m/s2)^2],
      --  -1 to 1. The rate error of gyro i is element i times the square of the true specific force along sensor axis
      --  i, at the point of the sensor block (see sins_mounting). So a positive element makes a drift in the positive
      --  sense about the axis, whatever the sign of the force. The mean force of a subsample is squared, as with
      --  nonlinearity.
      g2_sensitivity_rad_s_per_m2_s4 : sins_double_3 := (others => 0.0);
      --  Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
      --  sins_flight_sample.temperature_c less this temperature. If one of the coefficients is not 0, every sample
      --  needs a temperature, and sins_push_imu() is not available.
      reference_temperature_c : double := 0.0;
      --  Bias per kelvin [(rad/s)/K], -100 to 100. The bias is this coefficient times T.
      bias_temperature_rad_s_per_k : sins_double_3 := (others => 0.0);
      --  Bias per kelvin squared [(rad/s)/K2], -100 to 100. The bias is this coefficient times T squared.
      bias_temperature2_rad_s_per_k2 : sins_double_3 := (others => 0.0);
      --  Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this coefficient times T.
      scale_factor_temperature_per_k : sins_double_3 := (others => 0.0);
      --  Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this coefficient times T
      --  squared.
      scale_factor_temperature2_per_k2 : sins_double_3 := (others => 0.0);
      --  Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter starts in its
      --  steady state, so there is no transient in the first interval.
      bandwidth_hz : sins_double_3 := (others => 0.0);
      --  Half the dead zone: signals up to this size give 0 [rad/s], 0 to 100.
      dead_zone_rad_s : sins_double_3 := (others => 0.0);
      --  Range, where the output saturates [rad/s], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu.
      range_rad_s : sins_double_3 := (others => 0.0);
      --  Quantum (pulse weight) of the output increments [rad], 1e-15 to 1; 0: none. The remainder goes into the next
      --  increment. The quantization noise Q is quantum/sqrt(12).
      quantization_rad : sins_double_3 := (others => 0.0);
   end record with Convention => C;
   type sins_gyro_params_array is array (size_t range <>) of aliased sins_gyro_params with Convention => C;

   --  Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero
   --  is an ideal triad. Signal: the specific force. Densities do not depend on the sample rate.
   --
   --  Effects act in this order, along the path of the signal: size effect, bandwidth; then errors that depend on the signal (scale
   --  factor, misalignment, asymmetry, nonlinearity, vibration rectification) and on temperature; then biases and noise; then dead
   --  zone, range, quantization. sins_gyro_params describes the effects that act on the mean of a subsample.
   type sins_accel_params is record
      --  sizeof(sins_accel_params)
      struct_size : Unsigned_32 := SINS_SIZEOF_ACCEL_PARAMS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Constant bias, measured less true [m/s2], -10000 to 10000.
      bias_m_s2 : sins_double_3 := (others => 0.0);
      --  Standard deviation of the turn-on bias, drawn once a run [m/s2], 0 to 10000.
      bias_sigma_m_s2 : sins_double_3 := (others => 0.0);
      --  Standard deviation of the first-order Gauss-Markov bias [m/s2], 0 to 10000. The process is stationary from
      --  the first sample on.
      markov_sigma_m_s2 : sins_double_3 := (others => 0.0);
      --  Correlation time of the Gauss-Markov bias [s], 1e-9 to 1e15; needed where markov_sigma_m_s2 is not 0.
      markov_time_s : sins_double_3 := (others => 0.0);
      --  White noise N: velocity random walk [(m/s)/sqrt(s)], 0 to 10000. It is the square root of the spectral
      --  density of the noise, in the unit of the signal per sqrt(Hz).
      velocity_random_walk_m_s_sqrt_s : sins_double_3 := (others => 0.0);
      --  Acceleration random walk K [(m/s2)/sqrt(s)], 0 to 10000. It starts at 0 at the start of a run.
      acceleration_random_walk_m_s2_sqrt_s : sins_double_3 := (others => 0.0);
      --  Ramp R: bias that grows with time [m/s3], -10000 to 10000. The bias starts at 0 when the ramp is switched
      --  on, and at sins_reset(). If R is changed in flight, the bias continues from its present value.
      ramp_m_s3 : sins_double_3 := (others => 0.0);
      --  Flicker noise, bias instability B [m/s2], 0 to 10000. The process is stationary from the first sample on:
      --  the Allan deviation is flat at 0.664 B from 2 s to 50 h.
      flicker_m_s2 : sins_double_3 := (others => 0.0);
      --  Scale factor error [1], -1 to 1.
      scale_factor : sins_double_3 := (others => 0.0);
      --  Standard deviation of the turn-on scale factor error, drawn once a run [1], 0 to 1. It is added to
      --  scale_factor.
      scale_factor_sigma : sins_double_3 := (others => 0.0);
      --  Scale factor error for positive signals less that for negative signals [1], -1 to 1. The error of a signal s
      --  is half of this times |s|.
      scale_factor_asymmetry : sins_double_3 := (others => 0.0);
      --  Scale factor error that grows with the size of the signal [s2/m], -1 to 1. The error of a signal s is this
      --  times s |s|.
      scale_factor_nonlinearity_s2_m : sins_double_3 := (others => 0.0);
      --  Misalignment: row = sensor, column = axis it should not sense [rad], -1 to 1. The error of sensor i is the
      --  sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.
      misalignment_rad : sins_double_3_3 := (others => (others => 0.0));
      --  Standard deviation of each turn-on misalignment, drawn once a run [rad], 0 to 1. It is added to
      --  misalignment_rad. The diagonal must be 0.
      misalignment_sigma_rad : sins_double_3_3 := (others => (others => 0.0));
      --  Vibration rectification, the g2 term [s2/m], -1 to 1. The error is this times the square of the mean force
      --  of a subsample. So a vibration with the root mean square r causes a bias of this times r squared.
      vibration_rectification_s2_m : sins_double_3 := (others => 0.0);
      --  Lever arm of each accelerometer from the point of the sensor block, sensor axes, row = sensor (size effect)
      --  [m], -100 to 100. The point of the sensor block is where the lever arm of sins_mounting ends. If a flight
      --  starts in motion, samples without an angular rate do not show the angular acceleration of the first interval
      --  (see sins_mounting). The measured velocity is then wrong for the rest of the flight: it lacks the lever arm
      --  times the change of the angular rate in the first interval. With sins_push_imu() the angular acceleration
      --  follows from the previous increments.
      lever_arm_m : sins_double_3_3 := (others => (others => 0.0));
      --  Temperature at which the four temperature coefficients have no effect [deg C], -273.15 to 1000. T is
      --  sins_flight_sample.temperature_c less this temperature. If one of the coefficients is not 0, every sample
      --  needs a temperature, and sins_push_imu() is not available.
      reference_temperature_c : double := 0.0;
      --  Bias per kelvin [(m/s2)/K], -10000 to 10000. The bias is this coefficient times T.
      bias_temperature_m_s2_per_k : sins_double_3 := (others => 0.0);
      --  Bias per kelvin squared [(m/s2)/K2], -10000 to 10000. The bias is this coefficient times T squared.
      bias_temperature2_m_s2_per_k2 : sins_double_3 := (others => 0.0);
      --  Scale factor error per kelvin [1/K], -1 to 1. The scale factor error is this coefficient times T.
      scale_factor_temperature_per_k : sins_double_3 := (others => 0.0);
      --  Scale factor error per kelvin squared [1/K2], -1 to 1. The scale factor error is this coefficient times T
      --  squared.
      scale_factor_temperature2_per_k2 : sins_double_3 := (others => 0.0);
      --  Bandwidth, -3 dB of a second-order Butterworth filter [Hz], 1e-3 to 1e6; 0: none. The filter starts in its
      --  steady state, so there is no transient in the first interval.
      bandwidth_hz : sins_double_3 := (others => 0.0);
      --  Half the dead zone: signals up to this size give 0 [m/s2], 0 to 10000.
      dead_zone_m_s2 : sins_double_3 := (others => 0.0);
      --  Range, where the output saturates [m/s2], 1e-9 to 1e6; 0: none. Saturation is flagged in sins_imu.
      range_m_s2 : sins_double_3 := (others => 0.0);
      --  Quantum (pulse weight) of the output increments [m/s], 1e-15 to 1; 0: none. The remainder goes into the next
      --  increment. The quantization noise Q is quantum/sqrt(12).
      quantization_m_s : sins_double_3 := (others => 0.0);
   end record with Convention => C;
   type sins_accel_params_array is array (size_t range <>) of aliased sins_accel_params with Convention => C;

   --  Errors of the barometric altimeter, whose height damps the vertical channel. All zero is an ideal altimeter.
   type sins_altimeter_params is record
      --  sizeof(sins_altimeter_params)
      struct_size : Unsigned_32 := SINS_SIZEOF_ALTIMETER_PARAMS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Constant bias, -1e5 to 1e5 [m].
      bias_m : double := 0.0;
      --  Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on, 0 to 1e5 [m].
      markov_sigma_m : double := 0.0;
      --  Correlation time of the Gauss-Markov error, 1e-9 to 1e15 [s]; needed where markov_sigma_m is not 0.
      markov_time_s : double := 0.0;
      --  Standard deviation of the independent error of each sample, 0 to 1e5 [m].
      noise_m : double := 0.0;
      --  Scale factor error of the height [1], -1 to 1.
      scale_factor : double := 0.0;
      --  Time constant of the first-order lag of the static pressure, 0 to 1e6 [s].
      lag_s : double := 0.0;
   end record with Convention => C;
   type sins_altimeter_params_array is array (size_t range <>) of aliased sins_altimeter_params with Convention => C;

   --  A failure of one output of a sensor. All zero is no failure. Fields that the kind does not use must be 0. The unit u is
   --  rad/s for a gyro, m/s2 for an accelerometer, m for the altimeter.
   type sins_failure is record
      --  sizeof(sins_failure)
      struct_size : Unsigned_32 := SINS_SIZEOF_FAILURE;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Kind of the failure, of enum sins_failure_kind.
      kind : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
      --  Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the altimeter [u].
      size : double := 0.0;
      --  Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the altimeter
      --  [u sqrt(s)].
      density : double := 0.0;
      --  Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for drop-outs with a
      --  probability.
      interval_s : double := 0.0;
      --  Spikes: length of one spike, 1e-9 s to interval_s [s].
      duration_s : double := 0.0;
      --  Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1.
      probability : double := 0.0;
   end record with Convention => C;
   type sins_failure_array is array (size_t range <>) of aliased sins_failure with Convention => C;

   --  Errors with which the navigation starts: computed less true, east-north-up. Random errors with the standard deviations
   --  (sigma) are drawn once a run and added. A reset and a reposition use the same random numbers again. With
   --  SINS_VERTICAL_FOLLOW_TRUTH the errors of height and vertical velocity start at 0. Limits: position errors 1e6 m, velocity
   --  errors 1e4 m/s, their standard deviations 1e5 m and 1e3 m/s.
   type sins_initial_errors is record
      --  sizeof(sins_initial_errors)
      struct_size : Unsigned_32 := SINS_SIZEOF_INITIAL_ERRORS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Position error [m].
      position_enu_m : sins_double_3 := (others => 0.0);
      --  Velocity error [m/s].
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x]) C0. C turns vectors from sensor
      --  axes to east-north-up. C0 is the true C. With SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS, C0 is the C that the alignment
      --  finds.
      misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Standard deviation of the position error [m].
      position_sigma_enu_m : sins_double_3 := (others => 0.0);
      --  Standard deviation of the velocity error [m/s].
      velocity_sigma_enu_m_s : sins_double_3 := (others => 0.0);
      --  Standard deviation of the misalignment, 0 to 1 [rad].
      misalignment_sigma_enu_rad : sins_double_3 := (others => 0.0);
      --  Alignment at the start, of enum sins_alignment.
      alignment : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_initial_errors_array is array (size_t range <>) of aliased sins_initial_errors with Convention => C;

   --  Position and attitude of the sensor block relative to the reference point of the flight samples, and the errors of what
   --  the INS believes about them: believed = true + error, component by component. All zero is a block at the reference
   --  point, along the body axes.
   --
   --  The ideal sensors measure the motion of the block, and sensor errors act in the axes of the block: sins_imu describes
   --  the block. The INS navigates the block, and converts its solution to the reference point with the mounting that it
   --  believes: sins_navigation and sins_errors describe the reference point. Initial errors apply to the solution for the
   --  block, so at the start sins_errors can differ from them. Angular rate and specific force of a sample are those of the
   --  reference point, along body axes. The barometric height is that of the reference point too.
   --
   --  Start in motion: at the start of a moving flight, and after a reposition, samples without an angular rate do not show
   --  the angular acceleration of the first interval. The specific force of a block away from the reference point then lacks
   --  the term angular acceleration times lever arm. In the second interval this term is correct to first order in the
   --  interval's length, in the third to second order, later to third order. The navigation is not affected, because the INS
   --  starts with the velocity that the block has at the mean angular rate of the first interval. With SINS_SAMPLE_ANGULAR_RATE
   --  no term is missing.
   type sins_mounting is record
      --  sizeof(sins_mounting)
      struct_size : Unsigned_32 := SINS_SIZEOF_MOUNTING;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Lever arm from the reference point to the block, body axes (sins_options.axes), -100 to 100 [m].
      lever_arm_m : sins_double_3 := (others => 0.0);
      --  Boresight: roll, pitch and heading of the block's axes relative to the body axes [rad]. They are defined like the
      --  attitude angles of the body: positive roll right side down, positive pitch nose up, positive heading nose to the
      --  right. Each is -1e4 to 1e4; whole turns do not matter.
      boresight_rad : sins_double_3 := (others => 0.0);
      --  Believed less true lever arm, -100 to 100 [m].
      lever_arm_error_m : sins_double_3 := (others => 0.0);
      --  Believed less true boresight angles, -pi to pi [rad]. If the believed heading is too large, the heading that the INS
      --  reports is too small by the same amount.
      boresight_error_rad : sins_double_3 := (others => 0.0);
   end record with Convention => C;
   type sins_mounting_array is array (size_t range <>) of aliased sins_mounting with Convention => C;

   --  Gravity disturbance: true gravity less the normal gravity that the INS computes, at the same point. The horizontal part is
   --  the deflection of the vertical. The vertical part is called anomaly here. Each has a constant part and a random part. The
   --  random part is a first-order Gauss-Markov field along the track: correlation sigma^2 exp(-d/D) over the distance d flown
   --  over ground. At rest it does not change. All zero is normal gravity.
   --
   --  Perfect accelerometers measure the disturbance, so it is in the ideal signals of sins_imu. In the INS it acts like an
   --  accelerometer error. At rest, without a levelled start, a deflection xi makes the position error oscillate between 0 and 2
   --  R xi, where R is the Earth's radius. A levelled start (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) is tilted by the deflection.
   type sins_gravity_params is record
      --  sizeof(sins_gravity_params)
      struct_size : Unsigned_32 := SINS_SIZEOF_GRAVITY_PARAMS;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Deflection in the meridian (xi): astronomic less geodetic latitude, -0.01 to 0.01 [rad]. If positive, the true
      --  zenith lies north of the ellipsoid's normal, and the accelerometers at rest measure g times this to the north.
      deflection_north_rad : double := 0.0;
      --  Standard deviation of the random part of the deflection in the meridian, 0 to 0.01 [rad].
      deflection_north_sigma_rad : double := 0.0;
      --  Correlation distance D of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
      deflection_north_distance_m : double := 0.0;
      --  Deflection in the prime vertical (eta): astronomic less geodetic longitude, times the cosine of latitude, -0.01 to
      --  0.01 [rad]. If positive, the true zenith lies east of the ellipsoid's normal.
      deflection_east_rad : double := 0.0;
      --  Standard deviation of the random part of the deflection in the prime vertical, 0 to 0.01 [rad].
      deflection_east_sigma_rad : double := 0.0;
      --  Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
      deflection_east_distance_m : double := 0.0;
      --  Anomaly, excess of gravity, -0.1 to 0.1 [m/s2]. A milligal is 1e-5 m/s2.
      anomaly_m_s2 : double := 0.0;
      --  Standard deviation of the random part of the anomaly, 0 to 0.1 [m/s2].
      anomaly_sigma_m_s2 : double := 0.0;
      --  Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
      anomaly_distance_m : double := 0.0;
   end record with Convention => C;
   type sins_gravity_params_array is array (size_t range <>) of aliased sins_gravity_params with Convention => C;

   --  A solution within a sins_record; never grows. Fields as in sins_navigation.
   type sins_record_solution is record
      --  Geodetic latitude, -pi/2 to pi/2 [rad].
      latitude_rad : double := 0.0;
      --  Longitude, east positive, -pi to pi [rad].
      longitude_rad : double := 0.0;
      --  Height above the ellipsoid [m].
      height_m : double := 0.0;
      --  Velocity against the Earth, east-north-up [m/s].
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Roll, right wing down positive, -pi to pi [rad].
      roll_rad : double := 0.0;
      --  Pitch, nose up positive, -pi/2 to pi/2 [rad].
      pitch_rad : double := 0.0;
      --  Heading, clockwise from true north, 0 to 2 pi [rad].
      heading_rad : double := 0.0;
      --  Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes while navigating on
      --  increments.
      quaternion_nb : sins_double_4 := (others => 0.0);
      --  Flags of enum sins_navigation_flags, or'ed.
      flags : Integer_32 := 0;
      --  0
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_record_solution_array is array (size_t range <>) of aliased sins_record_solution with Convention => C;

   --  Errors within a sins_record; never grows. Fields as in sins_errors.
   type sins_record_errors is record
      --  Position error: displacement from truth along true east and north, and difference of heights [m].
      position_enu_m : sins_double_3 := (others => 0.0);
      --  Error of latitude [rad].
      latitude_rad : double := 0.0;
      --  Error of longitude, wrapped to -pi to pi [rad].
      longitude_rad : double := 0.0;
      --  Error of height [m].
      height_m : double := 0.0;
      --  Velocity error [m/s]: components of the computed velocity in the east-north-up axes at the computed position, less
      --  components of the true velocity in the axes at the true position.
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from body axes to
      --  east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
      misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Error of roll, wrapped to -pi to pi [rad].
      roll_rad : double := 0.0;
      --  Error of pitch [rad].
      pitch_rad : double := 0.0;
      --  Error of heading, wrapped to -pi to pi [rad].
      heading_rad : double := 0.0;
      --  Flags of enum sins_errors_flags, or'ed.
      flags : Integer_32 := 0;
      --  0
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_record_errors_array is array (size_t range <>) of aliased sins_record_errors with Convention => C;

   --  Truth, navigation and both errors at one instant.
   type sins_record is record
      --  sizeof(sins_record); in an array only that of the first element must be set.
      struct_size : Unsigned_32 := SINS_SIZEOF_RECORD;
      --  0
      reserved : Unsigned_32 := 0;
      --  Time [s].
      time_s : double := 0.0;
      --  The truth, as sins_get_truth() gives it.
      truth : sins_record_solution;
      --  The navigated solution, as sins_get_navigation() gives it.
      navigation : sins_record_solution;
      --  Error data 2, as sins_get_errors() gives it with SINS_ERRORS_NAVIGATION.
      navigation_errors : sins_record_errors;
      --  Error data 1, as sins_get_errors() gives it with SINS_ERRORS_MODEL; flagged SINS_ERRORS_NOT_COMPUTED while the model
      --  is off.
      model_errors : sins_record_errors;
   end record with Convention => C;
   type sins_record_array is array (size_t range <>) of aliased sins_record with Convention => C;

   --  A solution: the truth or the navigated one.
   type sins_navigation is record
      --  sizeof(sins_navigation)
      struct_size : Unsigned_32 := SINS_SIZEOF_NAVIGATION;
      --  0 (must be 0 where it is an input).
      reserved : Unsigned_32 := 0;
      --  Time [s].
      time_s : double := 0.0;
      --  Geodetic latitude, -pi/2 to pi/2 [rad].
      latitude_rad : double := 0.0;
      --  Longitude, east positive, -pi to pi [rad].
      longitude_rad : double := 0.0;
      --  Height above the ellipsoid [m].
      height_m : double := 0.0;
      --  Velocity against the Earth, east-north-up [m/s].
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Roll, right wing down positive, -pi to pi [rad].
      roll_rad : double := 0.0;
      --  Pitch, nose up positive, -pi/2 to pi/2 [rad].
      pitch_rad : double := 0.0;
      --  Heading, clockwise from true north, 0 to 2 pi [rad].
      heading_rad : double := 0.0;
      --  Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes while navigating on
      --  increments.
      quaternion_nb : sins_double_4 := (others => 0.0);
      --  Flags of enum sins_navigation_flags, or'ed.
      flags : Integer_32 := 0;
      --  0
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_navigation_array is array (size_t range <>) of aliased sins_navigation with Convention => C;

   --  Ideal and measured signals of the last interval, sensor axes.
   type sins_imu is record
      --  sizeof(sins_imu)
      struct_size : Unsigned_32 := SINS_SIZEOF_IMU;
      --  Flags of enum sins_imu_flags, or'ed.
      flags : Unsigned_32 := 0;
      --  Time of the end of the interval [s].
      time_s : double := 0.0;
      --  Length of the interval [s].
      interval_s : double := 0.0;
      --  Integral of the angular rate against inertial space, as perfect gyros measure it [rad].
      ideal_angle_rad : sins_double_3 := (others => 0.0);
      --  Integral of the specific force, as perfect accelerometers measure it [m/s].
      ideal_velocity_m_s : sins_double_3 := (others => 0.0);
      --  Integral of the angular rate that the modelled gyros measure [rad].
      measured_angle_rad : sins_double_3 := (others => 0.0);
      --  Integral of the specific force that the modelled accelerometers measure [m/s].
      measured_velocity_m_s : sins_double_3 := (others => 0.0);
      --  Mean angular rate of perfect gyros: ideal_angle_rad divided by interval_s [rad/s].
      ideal_rate_rad_s : sins_double_3 := (others => 0.0);
      --  Mean specific force of perfect accelerometers: ideal_velocity_m_s divided by interval_s [m/s2].
      ideal_force_m_s2 : sins_double_3 := (others => 0.0);
      --  Mean angular rate of the modelled gyros: measured_angle_rad divided by interval_s [rad/s].
      measured_rate_rad_s : sins_double_3 := (others => 0.0);
      --  Mean specific force of the modelled accelerometers: measured_velocity_m_s divided by interval_s [m/s2].
      measured_force_m_s2 : sins_double_3 := (others => 0.0);
   end record with Convention => C;
   type sins_imu_array is array (size_t range <>) of aliased sins_imu with Convention => C;

   --  Errors of the navigated solution, computed less true.
   type sins_errors is record
      --  sizeof(sins_errors)
      struct_size : Unsigned_32 := SINS_SIZEOF_ERRORS;
      --  0
      reserved : Unsigned_32 := 0;
      --  Time [s].
      time_s : double := 0.0;
      --  Position error: displacement from truth along true east and north, and difference of heights [m].
      position_enu_m : sins_double_3 := (others => 0.0);
      --  Error of latitude [rad].
      latitude_rad : double := 0.0;
      --  Error of longitude, wrapped to -pi to pi [rad].
      longitude_rad : double := 0.0;
      --  Error of height [m].
      height_m : double := 0.0;
      --  Velocity error [m/s]: components of the computed velocity in the east-north-up axes at the computed position, less
      --  components of the true velocity in the axes at the true position.
      velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from body axes to
      --  east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
      misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Error of roll, wrapped to -pi to pi [rad].
      roll_rad : double := 0.0;
      --  Error of pitch [rad].
      pitch_rad : double := 0.0;
      --  Error of heading, wrapped to -pi to pi [rad].
      heading_rad : double := 0.0;
      --  Flags of enum sins_errors_flags, or'ed.
      flags : Integer_32 := 0;
      --  0
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_errors_array is array (size_t range <>) of aliased sins_errors with Convention => C;

   --  Running figures of the flight since its start or last reposition; sins_move_time() and sins_move_truth() do not restart
   --  them. The figures use the errors once a second. They describe one run, not an ensemble. To get nautical miles per hour,
   --  divide a rate by SINS_NMI_PER_HOUR.
   type sins_accuracy is record
      --  sizeof(sins_accuracy)
      struct_size : Unsigned_32 := SINS_SIZEOF_ACCURACY;
      --  0
      reserved : Unsigned_32 := 0;
      --  Time [s].
      time_s : double := 0.0;
      --  Time since the start [s].
      duration_s : double := 0.0;
      --  Start of the window of the radial error rates, as time since the start: 300 [s]. Earlier rates would be initial errors
      --  divided by a very short time.
      window_start_s : double := 0.0;
      --  Number of errors (one a second) in the window of the radial error rates. While it is 0, the rates are 0.
      window_samples : Unsigned_64 := 0;
      --  Root mean square of the radial error rate, sqrt(mean RER^2), with RER = horizontal position error / time since the
      --  start [m/s].
      radial_error_rate_rms_m_s : double := 0.0;
      --  R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s].
      cep_rate_m_s : double := 0.0;
      --  R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s].
      radial_95_rate_m_s : double := 0.0;
      --  Slope of the least-squares line (with an intercept) through the horizontal position errors of the window [m/s].
      radial_error_slope_m_s : double := 0.0;
      --  Root mean square velocity error since the start, east-north-up; samples within 20 km of the Earth's axis, where east
      --  and north turn fast, are left out [m/s].
      velocity_rms_enu_m_s : sins_double_3 := (others => 0.0);
      --  Position closure: the position error now, navigation minus truth [m].
      closure_position_enu_m : sins_double_3 := (others => 0.0);
      --  Velocity closure: the velocity error now, navigation minus truth [m/s].
      closure_velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Part of the horizontal position error that the host causes, because its velocities contradict its positions [m]. Let d
      --  be the displacement from the velocities less the displacement from the positions. The field is the response of a
      --  Schuler oscillator to d; up is 0. The rest of the position error is caused by the simulator and the sensors.
      host_position_enu_m : sins_double_3 := (others => 0.0);
      --  Part of the horizontal velocity error that the host causes in this way; up is 0 [m/s].
      host_velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Displacement from the host's velocities less displacement from its positions, summed over the flight [m].
      inconsistency_enu_m : sins_double_3 := (others => 0.0);
      --  Largest difference, in one interval, between the displacement from the host's velocities and the displacement from its
      --  positions [m].
      inconsistency_max_m : double := 0.0;
      --  Number of samples flagged SINS_NAVIGATION_INCONSISTENT.
      inconsistent_samples : Unsigned_64 := 0;
      --  Number of intervals flown since the start or the last reposition.
      intervals : Unsigned_64 := 0;
      --  Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the angular rate, later than ten times closed_loop_time_s after the
      --  start [rad/s]. It shows the error of the signal generator and the mechanization themselves. 0 with physical signals.
      trim_rate_max_rad_s : double := 0.0;
      --  Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the specific force, likewise [m/s2].
      trim_force_max_m_s2 : double := 0.0;
   end record with Convention => C;
   type sins_accuracy_array is array (size_t range <>) of aliased sins_accuracy with Convention => C;

   --  Extreme values of the true motion over all intervals since the create or the last sins_reset(). Wrong units and exchanged
   --  axes give values that no vehicle has, so these figures reveal them. Attitudes in degrees turn 57 times too fast, and give
   --  arbitrary sideslips. Exchanged east and north give a sideslip, and velocities that contradict the positions. Knots instead
   --  of m/s contradict the positions too. Feet instead of metres give heights and climbs 3.3 times too large. Accelerations are
   --  means from one sample to the next. So are rates and forces, unless the samples carry them; then they are the values at the
   --  samples. Each ..._at_s is the time stamp of the sample at which the value was found.
   type sins_truth_summary is record
      --  sizeof(sins_truth_summary)
      struct_size : Unsigned_32 := SINS_SIZEOF_TRUTH_SUMMARY;
      --  0
      reserved : Unsigned_32 := 0;
      --  Number of intervals flown.
      intervals : Unsigned_64 := 0;
      --  Number of intervals that are gaps (see SINS_GAP).
      gaps : Unsigned_64 := 0;
      --  Number of samples with a speed of more than 30 m/s. Sideslip and angle of attack are taken from these only.
      fast_samples : Unsigned_64 := 0;
      --  Sum of the lengths of the intervals [s].
      flown_s : double := 0.0;
      --  Time stamp of the first sample [s].
      first_s : double := 0.0;
      --  Time stamp of the last sample [s].
      last_s : double := 0.0;
      --  Longest interval [s].
      interval_max_s : double := 0.0;
      --  Time stamp of interval_max_s [s].
      interval_max_at_s : double := 0.0;
      --  Largest rotation in an interval [rad].
      turn_max_rad : double := 0.0;
      --  Time stamp of turn_max_rad [s].
      turn_max_at_s : double := 0.0;
      --  Largest angular rate: from the attitudes against the Earth, or the samples' own rate [rad/s].
      rate_max_rad_s : double := 0.0;
      --  Time stamp of rate_max_rad_s [s].
      rate_max_at_s : double := 0.0;
      --  Largest acceleration against the Earth, from the velocities [m/s2].
      acceleration_max_m_s2 : double := 0.0;
      --  Time stamp of acceleration_max_m_s2 [s].
      acceleration_max_at_s : double := 0.0;
      --  Largest specific force: from the velocities and gravity, or the samples' own force [m/s2].
      force_max_m_s2 : double := 0.0;
      --  Time stamp of force_max_m_s2 [s].
      force_max_at_s : double := 0.0;
      --  Largest difference, in one interval, between the displacement from the positions and the displacement from the
      --  velocities (the mean of the velocities at the two ends, times the length of the interval) [m].
      inconsistency_max_m : double := 0.0;
      --  Time stamp of inconsistency_max_m [s].
      inconsistency_max_at_s : double := 0.0;
      --  Largest speed against the Earth [m/s].
      speed_max_m_s : double := 0.0;
      --  Time stamp of speed_max_m_s [s].
      speed_max_at_s : double := 0.0;
      --  Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth, positive to the right;
      --  includes wind [rad].
      sideslip_max_rad : double := 0.0;
      --  Time stamp of sideslip_max_rad [s].
      sideslip_max_at_s : double := 0.0;
      --  Angle of attack of the largest size, from the velocity against the Earth up to the forward axis, in the plane of
      --  symmetry [rad].
      attack_max_rad : double := 0.0;
      --  Time stamp of attack_max_rad [s].
      attack_max_at_s : double := 0.0;
      --  Lowest height [m].
      height_min_m : double := 0.0;
      --  Time stamp of height_min_m [s].
      height_min_at_s : double := 0.0;
      --  Highest height [m].
      height_max_m : double := 0.0;
      --  Time stamp of height_max_m [s].
      height_max_at_s : double := 0.0;
   end record with Convention => C;
   type sins_truth_summary_array is array (size_t range <>) of aliased sins_truth_summary with Convention => C;

   --  Covariance of the navigation errors over all runs of the flight, with its standard deviations and its error ellipse. The
   --  errors are those of sins_errors: east, north, up of position [m], velocity [m/s] and misalignment [rad], in this order.
   --
   --  The covariance is propagated along the truth with the linear error equations (error data 1). Both values of
   --  sins_options.frame use the equations in Earth-fixed axes; the result is the same. The covariance is taken about the mean
   --  error of all runs. It does not depend on the random numbers of this run. It contains: random initial errors; the
   --  misalignment that the alignment at the start derives from sensor errors; turn-on biases, scale factors and misalignments;
   --  Gauss-Markov, flicker, rate random walk and white noise; the random fields of gravity; the altimeter's Gauss-Markov error
   --  and noise; quantization, as white noise of the same variance. It does not contain: constant errors and failures, which
   --  change only the mean; dead zones and ranges, which are not linear. One step of the propagation is one second of flight. A
   --  parameter that is set in flight takes effect from the start of the current second. A second with at least one height of
   --  the altimeter counts as aided throughout, so drop-outs shorter than a second have no effect on the covariance. The
   --  standard deviations of the propagation are limited to 1e30 in SI units, so all outputs are finite.
   type sins_covariance is record
      --  sizeof(sins_covariance)
      struct_size : Unsigned_32 := SINS_SIZEOF_COVARIANCE;
      --  Flags of enum sins_errors_flags, or'ed: SINS_ERRORS_NEAR_POLE, and SINS_ERRORS_OUTSIDE_VALIDITY if a standard
      --  deviation exceeds the limits of that flag.
      flags : Integer_32 := 0;
      --  Time [s].
      time_s : double := 0.0;
      --  Covariance, 9 by 9, row by row. It is symmetric, and rounding cannot make a variance negative.
      covariance : sins_double_9_9 := (others => (others => 0.0));
      --  Standard deviation of the position error [m].
      position_sigma_enu_m : sins_double_3 := (others => 0.0);
      --  Standard deviation of the velocity error [m/s].
      velocity_sigma_enu_m_s : sins_double_3 := (others => 0.0);
      --  Standard deviation of the misalignment [rad].
      misalignment_sigma_enu_rad : sins_double_3 := (others => 0.0);
      --  Semi-major axis of the error ellipse (one standard deviation) of the horizontal position [m].
      ellipse_major_m : double := 0.0;
      --  Semi-minor axis of that ellipse [m].
      ellipse_minor_m : double := 0.0;
      --  Azimuth of the major axis, from north to the east, 0 up to pi [rad].
      ellipse_azimuth_rad : double := 0.0;
      --  Radius of the circle that contains the horizontal error with a probability of 50 % [m]. The error has the normal
      --  distribution of this ellipse, with the mean 0.
      cep50_m : double := 0.0;
      --  Radius of the circle that contains the horizontal error with a probability of 95 % [m].
      radial_95_m : double := 0.0;
   end record with Convention => C;
   type sins_covariance_array is array (size_t range <>) of aliased sins_covariance with Convention => C;

   --  Increments of an inertial measurement unit over an interval. The interval is divided into parts of equal length; the
   --  field count is their number.
   type sins_imu_increment is record
      --  sizeof(sins_imu_increment)
      struct_size : Unsigned_32 := SINS_SIZEOF_IMU_INCREMENT;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Length of the whole interval, 5e-5 to 10 [s].
      interval_s : double := 0.0;
      --  Number of parts, 1 to 5.
      count : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
      --  Integral of the angular rate against inertial space over each part: x, y, z of the first part, x, y, z of the second
      --  part, and so on [rad]. The rotation in each part, and in the interval, must be less than half a turn.
      angle_rad : sins_double_5_3 := (others => (others => 0.0));
      --  Integral of the specific force over each part, up to 1e4 m/s, likewise [m/s].
      velocity_m_s : sins_double_5_3 := (others => (others => 0.0));
   end record with Convention => C;
   type sins_imu_increment_array is array (size_t range <>) of aliased sins_imu_increment with Convention => C;

   --  Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the same bits
   --  however they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without pointers: send it,
   --  store it, compare its bytes. Its numbers have the byte order of the machine. A struct that is zero except for struct_size
   --  holds no runs. sins_statistics_figures() computes means, covariances and radii.
   --
   --  The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment about east,
   --  north, up, as in sins_errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24 um), 2^-29 m/s (1.9
   --  nm/s), 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262 km/s) and 4 rad, which are 2^47
   --  resolutions; the horizontal radial position error is in range below 2^25 m. There are at most 4294967295 runs, so the sums
   --  cannot overflow. Integers of 128 bits are two words, the low one first, in two's complement.
   type sins_statistics is record
      --  sizeof(sins_statistics)
      struct_size : Unsigned_32 := SINS_SIZEOF_STATISTICS;
      --  Version of the layout of the fields below: 1; 0 while there is no run.
      layout : Unsigned_32 := 0;
      --  Number of runs, including those that are left out of the sums.
      runs : Unsigned_64 := 0;
      --  Number of runs that have diverged. They are left out of the sums.
      diverged : Unsigned_64 := 0;
      --  Number of runs with a state or a horizontal radial position error outside its range. They are left out of the sums.
      out_of_range : Unsigned_64 := 0;
      --  Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are in the sums.
      outside_validity : Unsigned_64 := 0;
      --  Largest horizontal radial position error, rounded down [2^-22 m].
      largest_radial : Unsigned_64 := 0;
      --  Sum of each state, integers of 128 bits.
      sums : sins_unsigned_64_18 := (others => 0);
      --  Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row by row.
      products : sins_unsigned_64_90 := (others => 0);
      --  Numbers of runs by their horizontal radial position error. Element 0 counts those below 2^-10 m (1 mm). Element 1 +
      --  100 i + k, with i from 0 to 34 and k from 0 to 99, counts those from 2^(i-10) (1 + k/100) m up to 2^(i-10) (1 +
      --  (k+1)/100) m.
      histogram : sins_unsigned_32_3501 := (others => 0);
      --  0
      reserved : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_statistics_array is array (size_t range <>) of aliased sins_statistics with Convention => C;

   --  Figures that are computed from a sins_statistics. If there is no run, all figures are 0. If there is one run, its
   --  covariance is 0.
   type sins_figures is record
      --  sizeof(sins_figures)
      struct_size : Unsigned_32 := SINS_SIZEOF_FIGURES;
      --  0
      reserved : Unsigned_32 := 0;
      --  Number of runs, including those that are left out of the other figures.
      runs : Unsigned_64 := 0;
      --  Number of runs that have diverged. They are left out.
      diverged : Unsigned_64 := 0;
      --  Number of runs with an error outside its range. They are left out.
      out_of_range : Unsigned_64 := 0;
      --  Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are not left out.
      outside_validity : Unsigned_64 := 0;
      --  Mean position error [m].
      mean_position_enu_m : sins_double_3 := (others => 0.0);
      --  Mean velocity error [m/s].
      mean_velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Mean misalignment [rad].
      mean_misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Standard deviation of the position error, with the divisor n - 1 [m].
      sigma_position_enu_m : sins_double_3 := (others => 0.0);
      --  Standard deviation of the velocity error [m/s].
      sigma_velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Standard deviation of the misalignment [rad].
      sigma_misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Root mean square of the position error [m].
      rms_position_enu_m : sins_double_3 := (others => 0.0);
      --  Root mean square of the velocity error [m/s].
      rms_velocity_enu_m_s : sins_double_3 := (others => 0.0);
      --  Root mean square of the misalignment [rad].
      rms_misalignment_enu_rad : sins_double_3 := (others => 0.0);
      --  Covariance of the nine states of sins_statistics, with the divisor n - 1, row by row: element 9 i + j is the
      --  covariance of the states i and j, in m, m/s and rad.
      covariance : sins_double_9_9 := (others => (others => 0.0));
      --  Root mean square of the horizontal radial position error [m].
      rms_radial_m : double := 0.0;
      --  Horizontal radius that contains the positions of half of the runs [m]. It is read from the histogram, to 0.5 % of its
      --  value, or to 0.5 mm if it is below 1 mm.
      cep50_m : double := 0.0;
      --  Horizontal radius that contains the positions of 95 % of the runs [m]. It is read from the histogram as cep50_m is.
      r95_m : double := 0.0;
      --  Largest horizontal radial position error [m].
      largest_radial_m : double := 0.0;
   end record with Convention => C;
   type sins_figures_array is array (size_t range <>) of aliased sins_figures with Convention => C;

   --  Start of an embedded flight, level and straight.
   type sins_flight_start is record
      --  sizeof(sins_flight_start)
      struct_size : Unsigned_32 := SINS_SIZEOF_FLIGHT_START;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Geodetic latitude, -pi/2 to pi/2 [rad].
      latitude_rad : double := 0.0;
      --  Longitude, east positive, -100 to 100 [rad].
      longitude_rad : double := 0.0;
      --  Height above the ellipsoid, -2e4 to 2e6 [m].
      height_m : double := 0.0;
      --  Speed against the Earth, 0 to 1e4 [m/s].
      speed_m_s : double := 0.0;
      --  Course and heading, -100 to 100 [rad].
      heading_rad : double := 0.0;
      --  Roll of the body relative to the axes of the path, throughout the flight, -pi to pi [rad].
      roll_rad : double := 0.0;
      --  Pitch of the body relative to the axes of the path, throughout the flight, -pi/2 to pi/2: angle of attack, or tilt
      --  at rest [rad].
      pitch_rad : double := 0.0;
      --  Ellipsoid, of enum sins_earth, as in the options of the simulator that will fly it.
      earth : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
   end record with Convention => C;
   type sins_flight_start_array is array (size_t range <>) of aliased sins_flight_start with Convention => C;

   --  One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0.
   type sins_manoeuvre is record
      --  sizeof(sins_manoeuvre); in an array it is enough to set it in the first element and 0 in the others.
      struct_size : Unsigned_32 := SINS_SIZEOF_MANOEUVRE;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Kind of the manoeuvre, of enum sins_manoeuvre_kind.
      kind : Integer_32 := 0;
      --  Number of sinusoids, 1 to 6.
      sinusoid_count : Integer_32 := 0;
      --  Duration, 1e-3 to 1e8 [s].
      duration_s : double := 0.0;
      --  Time in which the manoeuvre builds up, and time in which it dies out, 1e-3 to 1e8; 0: 5 s [s]. If it is longer than
      --  half of the duration, half of the duration is used.
      ramp_s : double := 0.0;
      --  Change of speed; the speed must stay between 0 and 10 km/s [m/s].
      speed_change_m_s : double := 0.0;
      --  Change of height; the climb angle must stay below 64 degrees [m].
      height_change_m : double := 0.0;
      --  Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad [rad].
      heading_change_rad : double := 0.0;
      --  Bank of a turn, 1e-3 to 1.5 [rad]. If the heading change is too small to reach this bank, the turn uses a smaller
      --  bank.
      bank_rad : double := 0.0;
      --  Number of rolls or loops, a whole number from -1e4 to 1e4, not 0; or number of swings of an S-turn, 0 to 1e6.
      turns : double := 0.0;
      --  What each sinusoid moves, of enum sins_channel.
      channel : sins_integer_32_6 := (others => 0);
      --  Amplitude of each sinusoid [rad] or [m/s]: up to 10 rad; for the climb angle up to 1.5 rad; for the speed, the sum of the
      --  amplitudes is at most the speed.
      amplitude : sins_double_6 := (others => 0.0);
      --  Frequency of each sinusoid, 0 to 1000 [Hz].
      frequency_hz : sins_double_6 := (others => 0.0);
      --  Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), with t since the start of the manoeuvre [rad].
      phase_rad : sins_double_6 := (others => 0.0);
   end record with Convention => C;
   type sins_manoeuvre_array is array (size_t range <>) of aliased sins_manoeuvre with Convention => C;

   --  A fault of the text of a scene or of a flight log.
   type sins_fault is record
      --  sizeof(sins_fault)
      struct_size : Unsigned_32 := SINS_SIZEOF_FAULT;
      --  Flags of enum sins_error_info_flags, or'ed: which of value, minimum and maximum there are.
      flags : Unsigned_32 := 0;
      --  Number of faults that are reported: at most the first 200 of the text.
      count : Unsigned_64 := 0;
      --  Line of this fault in the text of the call, from 1; 0: the fault is in a value that the scene had before the call.
      line : Unsigned_64 := 0;
      --  Column, in characters from 1. For a flight log: number of the column of the table, from 1. 0: the same meaning as 0 in
      --  line.
      column : Unsigned_64 := 0;
      --  The value at fault, in the unit of the key that path names.
      value : double := 0.0;
      --  Least allowed value, in that unit; if the sentence says "more than", the limit itself is not allowed.
      minimum : double := 0.0;
      --  Greatest allowed value, in that unit; if the sentence says "less than", the limit itself is not allowed.
      maximum : double := 0.0;
      --  Path of the value at fault, for sins_scene_get_value(). It can also be the name of a section, such as "gyro", or of an
      --  item, such as "failure[0]". Terminated. Empty for a flight log, and if the text itself is at fault.
      path : sins_char_96 := (others => nul);
      --  Sentence that names key, value and limit, and the key that was probably meant; UTF-8, terminated, cut if it is
      --  longer.
      sentence : sins_char_256 := (others => nul);
   end record with Convention => C;
   type sins_fault_array is array (size_t range <>) of aliased sins_fault with Convention => C;

   --  Settings of a scene for its flight and its output.
   type sins_scene_setup is record
      --  sizeof(sins_scene_setup)
      struct_size : Unsigned_32 := SINS_SIZEOF_SCENE_SETUP;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Kind of the flight, of enum sins_scene_flight; read only: sins_scene_set_setup() ignores it.
      flight : Integer_32 := 0;
      --  1: samples get the temperature below; 0: samples get no temperature.
      has_temperature : Integer_32 := 0;
      --  1: a program shows neither progress nor summary; 0: it does.
      quiet : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
      --  Duration to fly, 0.036 to 3.6e8; 0: the whole flight, or the duration of the built-in scene [s].
      duration_s : double := 0.0;
      --  Duration that will be flown; read only [s]. 0 for a log (see sins_log_info.duration_s). 0 also if duration_s is longer
      --  than the flight: sins_scene_write() rejects such a scene.
      flown_s : double := 0.0;
      --  Sample rate, 1e-3 to 2e4; 0 for a log, which has its own time stamps [Hz].
      rate_hz : double := 0.0;
      --  Temperature of the sensors at the start of the flight, -273.15 to 1000; 0 if has_temperature is 0 [deg C].
      temperature_c : double := 0.0;
      --  Rate of change of the temperature, -277 to 277 [deg C/s].
      temperature_change_c_s : double := 0.0;
      --  Spacing of the records of a program, 5e-5 to 1e7; 0: the program's choice [s].
      every_s : double := 0.0;
   end record with Convention => C;
   type sins_scene_setup_array is array (size_t range <>) of aliased sins_scene_setup with Convention => C;

   --  A failure that a scene plans. Its fields from kind on are those of sins_failure; kind is not SINS_FAILURE_NONE.
   type sins_planned_failure is record
      --  sizeof(sins_planned_failure)
      struct_size : Unsigned_32 := SINS_SIZEOF_PLANNED_FAILURE;
      --  Must be 0.
      reserved : Unsigned_32 := 0;
      --  Sensor that fails, of enum sins_sensor.
      sensor : Integer_32 := 0;
      --  Axis that fails: 0, 1, 2 for x, y, z of the sensor axes; 0 for the altimeter.
      axis : Integer_32 := 0;
      --  Start of the failure, 0 to 1e9 since the start of the flight [s].
      from_s : double := 0.0;
      --  End of the failure, likewise; 0: the end of the flight [s].
      until_s : double := 0.0;
      --  Kind of the failure, of enum sins_failure_kind.
      kind : Integer_32 := 0;
      --  Must be 0.
      reserved2 : Unsigned_32 := 0;
      --  Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the altimeter [u].
      size : double := 0.0;
      --  Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the altimeter
      --  [u sqrt(s)].
      density : double := 0.0;
      --  Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for drop-outs with a
      --  probability.
      interval_s : double := 0.0;
      --  Spikes: length of one spike, 1e-9 s to interval_s [s].
      duration_s : double := 0.0;
      --  Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1.
      probability : double := 0.0;
   end record with Convention => C;
   type sins_planned_failure_array is array (size_t range <>) of aliased sins_planned_failure with Convention => C;

   --  A key of the scene format.
   type sins_scene_key is record
      --  sizeof(sins_scene_key)
      struct_size : Unsigned_32 := SINS_SIZEOF_SCENE_KEY;
      --  Flags of enum sins_scene_key_flags, or'ed.
      flags : Unsigned_32 := 0;
      --  Number of keys of the format.
      count : Unsigned_64 := 0;
      --  Kind of the value, of enum sins_scene_key_kind.
      kind : Integer_32 := 0;
      --  Number of numbers: 1; 3 for x, y, z; 9 for a matrix row by row; 0 for the other kinds.
      elements : Integer_32 := 0;
      --  A single number may be given in the place of all elements if this is not 0. It sets element k if bit k is set, and the
      --  other elements are 0. 0: all elements must be given.
      spread : Unsigned_32 := 0;
      --  0
      reserved : Unsigned_32 := 0;
      --  Factor from the unit of the key to SI. It is 1 if the value is not a number.
      si_per_unit : double := 0.0;
      --  Least allowed value of each number, in the unit of name. If the kinds of items have different limits, it is the widest.
      --  Other values of the scene may narrow the limits.
      minimum : double := 0.0;
      --  Greatest allowed value, likewise.
      maximum : double := 0.0;
      --  Section, such as "gyro" or "manoeuvre.sinusoid"; terminated, as all texts here.
      section : sins_char_24 := (others => nul);
      --  Name, such as "bias_deg_h": its value is in the unit of data sheets.
      name : sins_char_40 := (others => nul);
      --  Name of the key that takes the same quantity in SI, such as "bias_rad_s"; empty: name is that key.
      si_name : sins_char_40 := (others => nul);
      --  Unit of name, such as "deg/h"; empty: a pure number, or no number.
      unit : sins_char_24 := (others => nul);
      --  Unit of si_name, such as "rad/s".
      si_unit : sins_char_24 := (others => nul);
      --  Value in a scene that does not set the key, as sins_scene_get_value() gives it; empty: no value.
      default_value : sins_char_32 := (others => nul);
      --  Words that a key of SINS_SCENE_KEY_WORD takes, such as "exact|paper|polynomial".
      words : sins_char_128 := (others => nul);
      --  Items of the list that use the key. "kind=turn|s_turn" means the items in which the value of the key `kind` is one of
      --  these words. If there are several conditions, with a space between them, an item must meet all. Empty: all items.
      condition : sins_char_96 := (others => nul);
      --  Meaning, without unit.
      meaning : sins_char_128 := (others => nul);
   end record with Convention => C;
   type sins_scene_key_array is array (size_t range <>) of aliased sins_scene_key with Convention => C;

   --  Contents of a flight log.
   type sins_log_info is record
      --  sizeof(sins_log_info)
      struct_size : Unsigned_32 := SINS_SIZEOF_LOG_INFO;
      --  0
      reserved : Unsigned_32 := 0;
      --  Number of samples.
      samples : Unsigned_64 := 0;
      --  Duration from the first to the last sample [s].
      duration_s : double := 0.0;
      --  The comment in the first line of the log, UTF-8, terminated; empty: none.
      title : sins_char_192 := (others => nul);
   end record with Convention => C;
   type sins_log_info_array is array (size_t range <>) of aliased sins_log_info with Convention => C;

   --  The samples that a scene flies.
   type sins_scene_samples is record
      --  sizeof(sins_scene_samples)
      struct_size : Unsigned_32 := SINS_SIZEOF_SCENE_SAMPLES;
      --  0
      reserved : Unsigned_32 := 0;
      --  Number of samples.
      count : Unsigned_64 := 0;
      --  Number of sample intervals between two records of the program sins, at least 1. It follows from sins_scene_setup.every_s;
      --  if every_s is 0, there are about 2000 records.
      record_every : Unsigned_64 := 0;
      --  Time stamp of the first sample [s].
      start_s : double := 0.0;
      --  Time between two samples [s]; of a log, the mean.
      period_s : double := 0.0;
      --  Time from the first to the last sample [s].
      duration_s : double := 0.0;
   end record with Convention => C;
   type sins_scene_samples_array is array (size_t range <>) of aliased sins_scene_samples with Convention => C;

   --  Largest error that the algorithm itself may cause, in addition to those of the sensors, at any time within a duration.
   --  At least one limit is needed.
   type sins_requirement is record
      --  sizeof(sins_requirement)
      struct_size : Unsigned_32 := SINS_SIZEOF_REQUIREMENT;
      --  1: measure ns_per_step, in 9 rounds of about 1000 steps; 0: it is 0.
      time_steps : Unsigned_32 := 0;
      --  Duration for which the limits hold, 0 to 1e6 [s]. If it is shorter than the piece of flight that is given to
      --  sins_recommend(), it is the length of that piece.
      duration_s : double := 0.0;
      --  Limit of the position error of the algorithm: distance from the reference (see sins_recommend()) [m]; 0: none.
      position_m : double := 0.0;
      --  Limit of the velocity error of the algorithm: length of the difference from the reference [m/s]; 0: none.
      velocity_m_s : double := 0.0;
      --  Limit of the attitude error of the algorithm: angle between its attitude relative to the Earth and that of the
      --  reference [rad]; 0: none.
      attitude_rad : double := 0.0;
      --  Margin: each limit must be at least this many times the predicted error, 1 to 1e6; 0: 2.
      margin : double := 0.0;
   end record with Convention => C;
   type sins_requirement_array is array (size_t range <>) of aliased sins_requirement with Convention => C;

   --  Accuracy and cost of the recommended options.
   type sins_cost is record
      --  sizeof(sins_cost)
      struct_size : Unsigned_32 := SINS_SIZEOF_COST;
      --  0
      reserved : Unsigned_32 := 0;
      --  Duration for which the errors are predicted [s].
      duration_s : double := 0.0;
      --  Predicted position error, the largest within the duration [m].
      position_m : double := 0.0;
      --  Predicted velocity error, the largest within the duration [m/s].
      velocity_m_s : double := 0.0;
      --  Predicted attitude error against the Earth, the largest within the duration [rad].
      attitude_rad : double := 0.0;
      --  Part of position_m that is the uncertainty of the reference [m].
      reference_position_m : double := 0.0;
      --  Part of velocity_m_s that is the uncertainty of the reference [m/s].
      reference_velocity_m_s : double := 0.0;
      --  Part of attitude_rad that is the uncertainty of the reference [rad].
      reference_attitude_rad : double := 0.0;
      --  Predicted error times margin divided by its limit, the largest of the three. The requirement is met if this is at most
      --  1. A limit below 1e-100 counts as 1e-100.
      share : double := 0.0;
      --  Processor instructions of the part of a step that depends on the algorithm: a figure that is the same on every
      --  machine. The algorithms are ordered by this figure.
      instructions_per_step : double := 0.0;
      --  Time of push and step of one sample, measured in this call on this machine if time_steps is 1, else 0, with the
      --  recommended options, the mounting, and ideal sensors [ns].
      ns_per_step : double := 0.0;
      --  Number of algorithms that were tried, including the recommended one.
      tried : Unsigned_64 := 0;
   end record with Convention => C;
   type sins_cost_array is array (size_t range <>) of aliased sins_cost with Convention => C;

   --  Request for an error budget. All zero is 16 runs and no limits.
   type sins_budget_request is record
      --  sizeof(sins_budget_request)
      struct_size : Unsigned_32 := SINS_SIZEOF_BUDGET_REQUEST;
      --  1: measure the figures ns_per_step; 0: they are 0.
      time_steps : Unsigned_32 := 0;
      --  Number of runs with all effects together, if any effect is random, 8 to 1000; 0: 16.
      runs : Unsigned_64 := 0;
      --  Limit of the change of the position error, at any time of the flight, by all effects that are left out together [m];
      --  0: none.
      position_m : double := 0.0;
      --  Limit of the change of the velocity error, likewise [m/s]; 0: none.
      velocity_m_s : double := 0.0;
      --  Limit of the change of the misalignment, likewise [rad]; 0: none.
      attitude_rad : double := 0.0;
   end record with Convention => C;
   type sins_budget_request_array is array (size_t range <>) of aliased sins_budget_request with Convention => C;

   --  An effect and its contribution to the errors. The first row of a budget has the errors of the mechanization and of the
   --  samples, with no effect set.
   type sins_budget_row is record
      --  sizeof(sins_budget_row)
      struct_size : Unsigned_32 := SINS_SIZEOF_BUDGET_ROW;
      --  Flags of enum sins_budget_flags, or'ed.
      flags : Unsigned_32 := 0;
      --  Name of the effect, such as "gyro turn-on bias", terminated; in the first row "mechanization".
      effect : sins_char_32 := (others => nul);
      --  The field that sets the effect, such as "gyro.bias_sigma_rad_s", terminated; a value of 0 there leaves the effect
      --  out. Empty in the first row.
      field : sins_char_48 := (others => nul);
      --  Length of the contribution to the position error, the largest at up to 1000 instants of the flight [m].
      position_m : double := 0.0;
      --  Length of the contribution to the velocity error, the largest at these instants [m/s].
      velocity_m_s : double := 0.0;
      --  Length of the contribution to the misalignment, the largest at these instants [rad].
      attitude_rad : double := 0.0;
      --  Length of the contribution to the position error at the end of the flight [m].
      end_position_m : double := 0.0;
      --  Length of the contribution to the velocity error at the end of the flight [m/s].
      end_velocity_m_s : double := 0.0;
      --  Length of the contribution to the misalignment at the end of the flight [rad].
      end_attitude_rad : double := 0.0;
      --  The contribution divided by its limit, the largest of the three; 0 without limits.
      share : double := 0.0;
      --  Time of a step with all effects, less that of a step without this one; in the first row, time of a step with no effect
      --  set. Measured in this call on this machine if time_steps is 1, else 0 [ns]. Uncertain by 1 to 5 % of a step, more on a
      --  busy machine, so it may be negative.
      ns_per_step : double := 0.0;
   end record with Convention => C;
   type sins_budget_row_array is array (size_t range <>) of aliased sins_budget_row with Convention => C;

   --  Figures of a budget as a whole.
   type sins_budget is record
      --  sizeof(sins_budget)
      struct_size : Unsigned_32 := SINS_SIZEOF_BUDGET;
      --  0
      reserved : Unsigned_32 := 0;
      --  Duration of the evaluation: from the end of the first interval to the end of the last [s].
      duration_s : double := 0.0;
      --  Number of runs with all effects together; 1 if nothing is random.
      runs : Unsigned_64 := 0;
      --  Number of flights that the call made.
      flights : Unsigned_64 := 0;
      --  Lower end of the 95 % confidence interval of the root mean square of the random errors, divided by the root mean
      --  square over the flown runs. The fewer the runs, the wider the interval. 1 if nothing is random.
      sigma_low : double := 0.0;
      --  Upper end of that interval, divided likewise; 1 if nothing is random.
      sigma_high : double := 0.0;
      --  Position error with all effects together, root mean square over the runs, the largest in the flight [m].
      position_m : double := 0.0;
      --  Velocity error with all effects together, likewise [m/s].
      velocity_m_s : double := 0.0;
      --  Misalignment with all effects together, likewise [rad].
      attitude_rad : double := 0.0;
      --  Part of the position error that the sum of all rows does not explain [m].
      remainder_position_m : double := 0.0;
      --  Part of the velocity error that the sum of all rows does not explain [m/s].
      remainder_velocity_m_s : double := 0.0;
      --  Part of the misalignment that the sum of all rows does not explain [rad].
      remainder_attitude_rad : double := 0.0;
      --  Change of the position error if the marked effects (SINS_BUDGET_CAN_BE_LEFT_OUT) are left out, from flights of all runs
      --  without them [m].
      left_out_position_m : double := 0.0;
      --  Change of the velocity error if the marked effects are left out, likewise [m/s].
      left_out_velocity_m_s : double := 0.0;
      --  Change of the misalignment if the marked effects are left out, likewise [rad].
      left_out_attitude_rad : double := 0.0;
      --  Time of a step with all effects, measured in this call on this machine if time_steps is 1, else 0 [ns].
      ns_per_step : double := 0.0;
   end record with Convention => C;
   type sins_budget_array is array (size_t range <>) of aliased sins_budget with Convention => C;

   --  Returns the version of the interface of the loaded library: compare it with SINS_HEADER_ABI.
   function sins_abi_version return Unsigned_32
     with Import, Convention => C, External_Name => "sins_abi_version";

   --  Returns the release of the loaded library as text, such as "0.1.0". The text lives as long as the library is loaded.
   function sins_version_string return chars_ptr
     with Import, Convention => C, External_Name => "sins_version_string";

   --  Returns the name of a status code, such as "SINS_OK", or "unknown status" for any other number. The text lives as long
   --  as the library is loaded.
   function sins_status_string (status : sins_status) return chars_ptr
     with Import, Convention => C, External_Name => "sins_status_string";

   --  Creates a simulator with ideal sensors. If options is NULL, it has the recommended options.
   --
   --  On an error *sim is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason. Not for a real-time
   --  frame: it allocates.
   --
   --  SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators exist.
   function sins_create (options : sins_options; sim : in out sins_sim) return sins_status
     with Import, Convention => C, External_Name => "sins_create";

   --  Waits until the calls of other threads on this handle have returned, and destroys the simulator. The handle is never used
   --  again.
   --
   --  SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
   function sins_destroy (sim : sins_sim) return sins_status
     with Import, Convention => C, External_Name => "sins_destroy";

   --  Reads the options in effect: those of sins_create() or of the snapshot that was loaded, with the defaults in place of 0.
   function sins_get_options (sim : sins_sim; options : in out sins_options) return sins_status
     with Import, Convention => C, External_Name => "sins_get_options";

   --  Puts one flight sample into the queue (16 samples). Each sample is checked by itself and against the one before.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
   --  SINS_ERROR_TIME_ORDER: the sample is not later than the one before, or later by less than 5e-5 s, or off a stated period
   --  by more than 0.4 of the period.
   --  SINS_GAP: the sample was accepted, and the interval before it is a gap, more than 2.5 times as long as each of the two
   --  before. sins_step() flies the gap as motion: the vehicle moves by its velocity times the length of the gap. After a pause
   --  of the host in which its clock ran on, call sins_move_time() before this push; a push cannot be undone.
   --  SINS_ERROR_DISCONTINUITY: a gap of more than max_gap_s, a jump, or a turn of 170 degrees or more since the last accepted
   --  sample. After a gap each later sample is rejected, until you call sins_move_time(), sins_move_truth() or
   --  sins_reposition(). After a jump or a turn each later sample is rejected, until one fits the last accepted sample, or until
   --  you call sins_move_truth() or sins_reposition().
   --  SINS_ERROR_QUEUE_FULL: step first.
   --  SINS_ERROR_BAD_STATE: navigating on increments.
   function sins_push_sample (sim : sins_sim; sample : sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_push_sample";

   --  Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples, each
   --  later step one more. No allocation, no system call. An interval in which the host paused and its clock ran on is flown
   --  like any other: the vehicle moves by its velocity times the length of the interval. sins_push_sample() returns SINS_GAP if
   --  the interval is a gap.
   --
   --  SINS_NEED_SAMPLE: no complete interval is waiting.
   --  SINS_ERROR_DIVERGED: the step would bring the solution below a height of -500 km, above a height of 20000 km, or to a
   --  speed of more than 100 km/s. The limits apply to the solution of the sensor block, to that of the reference point, and to
   --  the error-free navigator of SINS_SIGNAL_CLOSED_LOOP.
   --  SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
   --  SINS_ERROR_BAD_STATE: navigating on increments.
   --
   --  After SINS_ERROR_DIVERGED and SINS_ERROR_SINGULAR the step is not made, and the solution before it stays readable. The
   --  samples stay in the queue, so a further sins_step() tries the same interval again. sins_reposition() or sins_reset() start
   --  anew.
   function sins_step (sim : sins_sim) return sins_status
     with Import, Convention => C, External_Name => "sins_step";

   --  Moves the time after a pause in which the host's clock ran on: the newest accepted sample gets the time stamp time_s [s], and
   --  later samples must have later stamps. time_s is the time that the clock shows when the vehicle moves again. Everything else
   --  stays: errors, noise, waiting samples, sensor processes, failures and running figures. The grid of a stated period moves
   --  along. The outputs have the same bits as those of a flight without the jump of time, if the differences between successive
   --  time stamps are the same doubles. With a stated period this is always so. (If the samples have no velocities, the
   --  differences over three samples must be the same doubles too. Durations in sins_accuracy have the rounding of the time
   --  stamps.) The host must also move its flight_start_s of sins_scene_prepare() by the same time.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9.
   --  SINS_ERROR_BAD_STATE: no sample yet, or navigating on increments, which have no time stamps.
   function sins_move_time (sim : sins_sim; time_s : double) return sins_status
     with Import, Convention => C, External_Name => "sins_move_time";

   --  Slews the vehicle: the truth jumps to the sample, and the INS keeps its errors. No interval is flown from the previous
   --  sample to this one, so the errors do not change at the slew. For both values of source, sins_get_errors() reports the same
   --  errors before and after it: position error in metres (along the truth's east and north, and in height), velocity error
   --  (components) and misalignment, to 1e-8 m, 1e-11 m/s and 1e-14 rad. Their further growth depends on gravity, latitude and
   --  velocity at the new place. Noise, sensor processes, failures, the vertical channel, the altimeter's error and running
   --  figures continue, and no random number changes. (The scale factor error of the altimeter is that of the new height.) The
   --  sensors follow the new signals immediately. Waiting samples are dropped. The time may jump too: the running figures and
   --  the grid of a stated period then move with it, as in sins_move_time(). sins_get_imu() still reports the previous interval.
   --  If the sample has no velocity, the library takes the true velocity as 0 until the next sample is pushed. The navigated
   --  velocity is then equal to the velocity error.
   --
   --  If the vehicle is within 20 km of the Earth's axis before or after the slew, the east and north components of truth and
   --  solution are not comparable. The axes of the solution are then those of the truth, turned by the shortest rotation so that
   --  up is the vertical of the solution. In these axes the components of the velocity error and of the misalignment are kept.
   --  With a mounting, the errors of the sensor block are kept. The errors of the reference point follow from them with the
   --  lever arm, the boresight and their errors, in the new attitude.
   --
   --  Before the first step there are no errors to keep, and the call acts as sins_reposition().
   --
   --  SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_reposition().
   --  SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
   --  SINS_ERROR_DIVERGED: the solution would leave its limits, or the position error is about a quarter of the Earth's
   --  circumference or more, so that no place at the sample has this error.
   function sins_move_truth (sim : sins_sim; sample : sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_move_truth";

   --  Restarts the INS after the flight simulator was reloaded: the truth jumps to the sample, and the INS starts again there
   --  with its initial errors. The initial errors have the same random numbers as at the first start. The previous errors of the
   --  INS are lost; to keep them, call sins_move_truth() (slew) or sins_move_time() (pause) instead. Noise and failures
   --  continue. Waiting samples and the running accuracy figures are dropped. The time may jump too, forward or back: the run,
   --  and the grid of a stated period, continue from the sample's time stamp. Until the next step, the reads give the state at
   --  this sample, and there is no interval to read. The call may be the first of a run: the sample is then the first one, and
   --  the next push completes an interval.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
   --  SINS_ERROR_BAD_STATE: navigating on increments.
   --
   --  This call returns SINS_OK even if no INS can start at the sample. The reads and the next step then return
   --  SINS_ERROR_SINGULAR (too close to a pole, in geographic axes or for gyrocompassing) or SINS_ERROR_DIVERGED.
   function sins_reposition (sim : sins_sim; sample : sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_reposition";

   --  Returns to the state before the first sample: the same options, the parameters as they were set last, no failures, and
   --  the random streams at their start. So the same samples and settings give the same bits. For other random numbers, create
   --  a simulator with another seed or run. To return to a moment in flight, see sins_snapshot_save().
   function sins_reset (sim : sins_sim) return sins_status
     with Import, Convention => C, External_Name => "sins_reset";

   --  Copies the sentence of the last failed call on this handle. The sentence names field, value and limit; it is UTF-8 and
   --  always terminated; it is "no error" if no call failed. With a NULL handle the function gives the last failed call of this
   --  thread that was made without a simulator (create, presets, flights, ensembles, statistics, scenes, logs, recommend,
   --  budget), or whose handle was rejected (SINS_ERROR_BAD_HANDLE, or SINS_ERROR_BAD_STATE: see Threads). A failure of this
   --  call or of sins_last_error_info() is not kept.
   --
   --  needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for the
   --  size only. SINS_ERROR_BUFFER_TOO_SMALL: the sentence was cut.
   function sins_last_error (sim : sins_sim; buffer : in out char_array; capacity : size_t;
       needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_last_error";

   --  Gives the same failure as sins_last_error(), as a struct.
   function sins_last_error_info (sim : sins_sim; info : in out sins_error_info) return sins_status
     with Import, Convention => C, External_Name => "sins_last_error_info";

   --  Sets the gyro errors: before the first sample or in flight, from the next interval on. The random numbers of other
   --  effects do not change. Random processes that were active continue.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_BAD_STATE: temperature coefficients while samples without a temperature wait, or while navigating on
   --  increments.
   function sins_set_gyro (sim : sins_sim; params : sins_gyro_params) return sins_status
     with Import, Convention => C, External_Name => "sins_set_gyro";

   --  Reads the gyro errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
   --  snapshot.
   function sins_get_gyro (sim : sins_sim; params : in out sins_gyro_params) return sins_status
     with Import, Convention => C, External_Name => "sins_get_gyro";

   --  Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The random numbers of
   --  other effects do not change. Random processes that were active continue.
   --
   --  SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().
   function sins_set_accel (sim : sins_sim; params : sins_accel_params) return sins_status
     with Import, Convention => C, External_Name => "sins_set_accel";

   --  Reads the accelerometer errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
   --  snapshot.
   function sins_get_accel (sim : sins_sim; params : in out sins_accel_params) return sins_status
     with Import, Convention => C, External_Name => "sins_get_accel";

   --  Sets the errors of the barometric altimeter, whose height damps the vertical channel (SINS_VERTICAL_DAMPED), from the next
   --  interval on.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_set_altimeter (sim : sins_sim; params : sins_altimeter_params) return sins_status
     with Import, Convention => C, External_Name => "sins_set_altimeter";

   --  Reads the errors of the altimeter that are set. May be called at any moment. After sins_snapshot_load() they are those of
   --  the snapshot.
   function sins_get_altimeter (sim : sins_sim; params : in out sins_altimeter_params) return sins_status
     with Import, Convention => C, External_Name => "sins_get_altimeter";

   --  Sets a failure of one output, as an instructor's station does: before the first sample or in flight, from the next
   --  interval on. It lasts until SINS_FAILURE_NONE clears it, or another failure of the same output replaces it. Several
   --  outputs may fail at the same time.
   --
   --  sensor is of enum sins_sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before dead
   --  zone, range and quantization. SINS_FAILURE_STUCK, SINS_FAILURE_DEAD and SINS_FAILURE_DROP_OUTS replace the output. The
   --  random numbers of other effects do not change. Sensor processes continue during a failure, and act on the output again
   --  when it is cleared. A failure acts on error data 1 and on error data 2. It does not act on the alignment at the start.
   --  sins_reposition() keeps failures. sins_reset() clears all failures, so an exercise starts again with working sensors;
   --  failures that are set again at the same intervals give the same bits.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. If a failure makes the
   --  solution diverge, sins_step() returns SINS_ERROR_DIVERGED.
   function sins_set_failure (sim : sins_sim; sensor : Integer_32; axis : Integer_32; failure : sins_failure) return sins_status
     with Import, Convention => C, External_Name => "sins_set_failure";

   --  Reads the failure of one output. May be called at any moment. After sins_snapshot_load() it is that of the snapshot.
   --  SINS_FAILURE_NONE: the output has no failure. sensor and axis as in sins_set_failure().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such output.
   function sins_get_failure (sim : sins_sim; sensor : Integer_32; axis : Integer_32;
       failure : in out sins_failure) return sins_status
     with Import, Convention => C, External_Name => "sins_get_failure";

   --  Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition until
   --  the next step. After a reposition they apply to the start at its sample.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_BAD_STATE: steps have been made.
   function sins_set_initial_errors (sim : sins_sim; errors : sins_initial_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_set_initial_errors";

   --  Reads the set errors with which the navigation starts. May be called at any moment. After sins_snapshot_load() they are
   --  those of the snapshot.
   function sins_get_initial_errors (sim : sins_sim; errors : in out sins_initial_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_get_initial_errors";

   --  Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the next
   --  step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its solution is
   --  that of the block.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_BAD_STATE: steps have been made.
   function sins_set_mounting (sim : sins_sim; mounting : sins_mounting) return sins_status
     with Import, Convention => C, External_Name => "sins_set_mounting";

   --  Reads the mounting of the sensor block that is set. May be called at any moment. After sins_snapshot_load() it is that of
   --  the snapshot.
   function sins_get_mounting (sim : sins_sim; mounting : in out sins_mounting) return sins_status
     with Import, Convention => C, External_Name => "sins_get_mounting";

   --  Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset or a
   --  reposition until the next step. A reset brings the same field back; after a reposition the field continues from its
   --  current values. The disturbance does not affect a navigator on increments, because the host's increments already contain
   --  its effect.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_BAD_STATE: steps have been made.
   function sins_set_gravity_disturbance (sim : sins_sim; params : sins_gravity_params) return sins_status
     with Import, Convention => C, External_Name => "sins_set_gravity_disturbance";

   --  Reads the parameters of the gravity disturbance that are set. May be called at any moment. After sins_snapshot_load() they
   --  are those of the snapshot.
   function sins_get_gravity_disturbance (sim : sins_sim; params : in out sins_gravity_params) return sins_status
     with Import, Convention => C, External_Name => "sins_get_gravity_disturbance";

   --  Pushes and steps an array of count samples. Writes a record after each `every` intervals, counted as in
   --  sins_accuracy.intervals. There is no record for the first sample. Any split of a flight into calls gives the same bits and
   --  the same records as pushing and stepping sample by sample.
   --
   --  samples[0].struct_size is the size in bytes of each element of samples, records[0].struct_size that of each element of
   --  records. struct_size of the other samples may be 0, that of the other records anything. every 0: no records. written (may
   --  be NULL) gets the number of records that were written, also on an error.
   --
   --  SINS_GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
   --  if sins_options.truth_summary is on, sins_truth_summary.gaps is their number.
   --  SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the records that the call would make. Nothing is flown, and written
   --  gets 0.
   --  SINS_ERROR_BAD_STATE: navigating on increments.
   --
   --  An error of sins_push_sample() or sins_step() ends the call at the sample that caused the error; sins_last_error() names
   --  this sample. The samples before it were flown, this sample and the rest were not. sins_accuracy.intervals counts the flown
   --  intervals. A sample that could be pushed but not flown waits in the queue, as after sins_step(); sins_reposition() and
   --  sins_reset() empty the queue.
   function sins_run (sim : sins_sim; samples : sins_flight_sample_array; count : size_t; every : size_t;
       records : in out sins_record_array; capacity : size_t; written : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_run";

   --  Reads the truth at the end of the last interval; before the first step, that of the first sample. If the samples have no
   --  velocity, the velocity at the first one is 0 until the second one is pushed.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
   function sins_get_truth (sim : sins_sim; truth : in out sins_navigation) return sins_status
     with Import, Convention => C, External_Name => "sins_get_truth";

   --  Reads the navigated solution for the same instant as sins_get_truth().
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: before the first step, no INS can start at the first sample with these options
   --  and initial errors.
   function sins_get_navigation (sim : sins_sim; navigation : in out sins_navigation) return sins_status
     with Import, Convention => C, External_Name => "sins_get_navigation";

   --  Reads ideal and measured signals of the last interval.
   --
   --  SINS_NEED_SAMPLE: no interval yet.
   function sins_get_imu (sim : sins_sim; imu : in out sins_imu) return sins_status
     with Import, Convention => C, External_Name => "sins_get_imu";

   --  Reads the errors of the navigated solution; source is of enum sins_errors_source.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_INVALID_ARGUMENT: no such source.
   --  SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the error model is off, as it is by default (create the simulator with
   --  sins_options.error_model), or navigating on increments.
   --  SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
   function sins_get_errors (sim : sins_sim; source : Integer_32; errors : in out sins_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_get_errors";

   --  Reads the running accuracy figures.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
   --  SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
   function sins_get_accuracy (sim : sins_sim; accuracy : in out sins_accuracy) return sins_status
     with Import, Convention => C, External_Name => "sins_get_accuracy";

   --  Reads the extreme values of the true motion. sins_reposition() and sins_move_truth() do not restart them.
   --
   --  SINS_NEED_SAMPLE: no interval yet.
   --  SINS_ERROR_BAD_STATE: sins_options.truth_summary is off, or navigating on increments, without a truth.
   function sins_get_truth_summary (sim : sins_sim; summary : in out sins_truth_summary) return sins_status
     with Import, Convention => C, External_Name => "sins_get_truth_summary";

   --  Reads the covariance of the navigation errors at the end of the last interval; before the first step, that of the start.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_BAD_STATE: sins_options.covariance is off, or navigating on increments.
   --  SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: no INS can start at the first sample.
   function sins_get_covariance (sim : sins_sim; covariance : in out sins_covariance) return sins_status
     with Import, Convention => C, External_Name => "sins_get_covariance";

   --  Reads truth, navigation and both errors of this moment in one call; before the first step, those at the first sample.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   --  SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
   --  SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
   function sins_get_record (sim : sins_sim; the_record : in out sins_record) return sins_status
     with Import, Convention => C, External_Name => "sins_get_record";

   --  Writes a record as one line of comma-separated values, without the newline. The program sins writes its files of records
   --  in this format. If record is NULL, the line has the names of the columns. The decimal numbers are exact: reading them
   --  gives the same doubles. sensor_errors is an array of count = 6 numbers: x, y, z of the mean gyro error [rad/s], then x, y,
   --  z of the mean accelerometer error [m/s2], since the previous record. NULL with count 0: all are 0. covariance adds columns
   --  of standard deviations; NULL: none. buffer, capacity and needed as in sins_last_error(); a line has at most 1600 bytes.
   --  Not for a real-time frame: it allocates.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: count is neither 6 nor 0.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory for the text.
   function sins_record_line (the_record : sins_record; sensor_errors : double_array; count : size_t; covariance : sins_covariance;
       buffer : in out char_array; capacity : size_t; needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_record_line";

   --  Starts the simulator as a navigator only: it navigates on the increments of sins_push_imu(). The argument navigation
   --  gives the start: time, position, velocity and attitude (quaternion_nb; the angles and the flags are not read). Ranges are
   --  those of a flight sample; the norm of the quaternion must be 1 within 1e-3. Initial errors that are set do not apply.
   --  There is no truth: the vertical channel is free, and flagged so, and the reads of errors and accuracy return
   --  SINS_ERROR_BAD_STATE until sins_reset().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_BAD_STATE: samples were pushed, or the navigator was started before (call sins_reset() first); or temperature
   --  coefficients are set, but increments have no temperature.
   --  SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
   function sins_start_navigation (sim : sins_sim; navigation : sins_navigation) return sins_status
     with Import, Convention => C, External_Name => "sins_start_navigation";

   --  Navigates over one interval on the host's increments. Sensor errors that are set are added to the increments. The time
   --  advances by interval_s. sins_get_imu() reports the host's increments as the ideal ones. sins_options.subsamples and
   --  updates_per_sample do not apply: the parts of the increment are the subsamples of one update.
   --
   --  SINS_ERROR_BAD_STATE: sins_start_navigation() was not called.
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a rotation of half a turn or more in a part or in the interval.
   --  SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_step(); the interval is not flown, the solution before it stays
   --  readable, and sins_reset() and sins_start_navigation() start anew.
   function sins_push_imu (sim : sins_sim; increment : sins_imu_increment) return sins_status
     with Import, Convention => C, External_Name => "sins_push_imu";

   --  Reads the size that a snapshot has now. It changes with what is set and with the number of waiting samples. These sizes
   --  are without waiting samples. Without sensor errors it is 1.3 to 2.1 KiB, by the options. With every error of gyros,
   --  accelerometers and altimeter it is up to 4.5 KiB. With mounting, gravity, temperature and failures too it is up to 5.25
   --  KiB. Each waiting sample adds up to 154 bytes, and sins_options.covariance up to 9.2 KiB.
   function sins_snapshot_size (sim : sins_sim; size : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_snapshot_size";

   --  Saves the whole simulator, at any moment: options, parameters, waiting samples, the state of every stage, and the position
   --  of each random stream. written (may be NULL) gets the size. The bytes mean the same on every platform and hold no address,
   --  so they can be kept in a file or sent to another machine. The same state gives the same bytes. No allocation, no system
   --  call.
   --
   --  Not saved: handles, and the sentence of sins_last_error(). After SINS_ERROR_DIVERGED or SINS_ERROR_SINGULAR the last
   --  good solution is saved. After SINS_ERROR_INTERNAL nothing can be saved: load an earlier snapshot into a fresh handle.
   --
   --  SINS_ERROR_BUFFER_TOO_SMALL: see sins_snapshot_size(); buffer and written are unchanged.
   function sins_snapshot_save (sim : sins_sim; buffer : System.Address; capacity : size_t;
       written : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_snapshot_save";

   --  Replaces the simulator by the saved one, including its options (see sins_get_options()). So a fresh handle of
   --  sins_create(NULL, ...) is enough. The run continues to the same bits as the saved one. size is the size that
   --  sins_snapshot_save() wrote. Not for a real-time frame: it allocates.
   --
   --  SINS_ERROR_SNAPSHOT: the bytes are not a snapshot, or are cut off, altered, or of a newer release; nothing has changed,
   --  and sins_last_error() says which it is. Later releases read the snapshots of earlier ones; the run continues to the same
   --  bits unless CHANGELOG says that the algorithms changed.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory for a second simulator.
   function sins_snapshot_load (sim : sins_sim; snapshot : System.Address; size : size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_snapshot_load";

   --  Creates an ensemble of the runs first_run to first_run + runs - 1. configured is a simulator on which options, sensor
   --  errors, initial errors, mounting, gravity disturbance and failures are set, and to which no sample was pushed. The call
   --  copies it, and does not change it. Run k of the ensemble gives the same bits as a simulator with the same settings and
   --  sins_options.run = k. Three options of configured have no effect: run, truth_summary and covariance.
   --
   --  No run depends on another run. So different threads, processes and machines may fly ensembles of different runs, and their
   --  statistics can be merged. The library starts no thread.
   --
   --  What all runs share is computed once a step, and runs are flown side by side: a run takes a fraction of the time of a
   --  simulator, and 1.7 to 2.6 KB of memory. docs/ensembles.md has the times. Not for a real-time frame: it allocates.
   --
   --  After an error *ensemble is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
   --
   --  SINS_ERROR_BAD_STATE: configured has taken a sample since it was created or reset, or navigates on increments.
   --  SINS_ERROR_INVALID_ARGUMENT: runs not from 1 to 4294967295, or first_run + runs - 1 above 2^64 - 1.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 ensembles exist.
   function sins_ensemble_create (configured : sins_sim; first_run : Unsigned_64; runs : size_t;
       ensemble : in out sins_ensemble) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_create";

   --  Waits until the calls of other threads on this handle have returned, and destroys the ensemble. The handle is never used
   --  again.
   --
   --  SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
   function sins_ensemble_destroy (ensemble : sins_ensemble) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_destroy";

   --  Puts one flight sample into the queue (16 samples) of all runs.
   --
   --  SINS_GAP and the errors: as sins_push_sample().
   function sins_ensemble_push_sample (ensemble : sins_ensemble; sample : sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_push_sample";

   --  Flies one sample interval with all runs that have not diverged. No allocation, no system call.
   --
   --  A run has diverged if its solution leaves its limits (SINS_ERROR_DIVERGED of sins_step()), or comes too close to a pole in
   --  geographic axes (SINS_ERROR_SINGULAR). A diverged run is not flown any further, and its reads return SINS_ERROR_DIVERGED.
   --  sins_ensemble_get_diverged() reports it, and sins_ensemble_get_statistics() counts it. The other runs and the truth
   --  continue, even if all runs have diverged. sins_ensemble_reposition() and sins_ensemble_reset() start all runs again.
   --
   --  SINS_NEED_SAMPLE: no complete interval is waiting. SINS_ERROR_SINGULAR: the truth is too close to a pole, in geographic
   --  axes or for an alignment by gyrocompassing; the step is made for no run.
   function sins_ensemble_step (ensemble : sins_ensemble) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_step";

   --  Pushes and steps an array of count samples. With thousands of runs this is faster than single calls. Any split of a flight
   --  into calls gives the same bits as pushing and stepping sample by sample. samples[0].struct_size is the size in bytes of
   --  each element of samples; struct_size of the other samples may be 0.
   --
   --  SINS_GAP: all samples were flown, and at least one of them ended a gap. An error of sins_ensemble_push_sample() or
   --  sins_ensemble_step() ends the call at the sample that caused the error; sins_last_error() names this sample. The samples
   --  before it were flown, this sample and the rest were not. A sample that could be pushed but not flown waits in the queue.
   function sins_ensemble_run (ensemble : sins_ensemble; samples : sins_flight_sample_array; count : size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_run";

   --  Restarts all runs, as sins_reposition() does: the truth jumps to the sample, and every run, diverged or not, starts again
   --  there with its initial errors.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
   function sins_ensemble_reposition (ensemble : sins_ensemble; sample : sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_reposition";

   --  Returns to the state before the first sample, as sins_reset() does: the same parameters, no failures, no diverged run, and
   --  the random streams at their start.
   function sins_ensemble_reset (ensemble : sins_ensemble) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_reset";

   --  Sets or clears a failure of one output in every run, as sins_set_failure() does. No allocation, no system call.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: as sins_set_failure().
   function sins_ensemble_set_failure (ensemble : sins_ensemble; sensor : Integer_32; axis : Integer_32;
       failure : sins_failure) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_set_failure";

   --  Reads the number of the first run, and how many runs there are; either pointer may be NULL.
   function sins_ensemble_get_runs (ensemble : sins_ensemble; first_run : in out Unsigned_64;
       runs : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_runs";

   --  Reads the truth, which all runs share, as sins_get_truth() does.
   --
   --  SINS_NEED_SAMPLE: no sample yet.
   function sins_ensemble_get_truth (ensemble : sins_ensemble; truth : in out sins_navigation) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_truth";

   --  Reads the navigated solution of a run, as sins_get_navigation() does. run is from first_run to first_run + runs - 1.
   --
   --  SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged (the
   --  sentence of sins_last_error() states the time of its last good solution); or as sins_get_navigation().
   --  SINS_ERROR_SINGULAR: as sins_get_navigation().
   function sins_ensemble_get_navigation (ensemble : sins_ensemble; run : Unsigned_64;
       navigation : in out sins_navigation) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_navigation";

   --  Reads the errors of the navigated solution of a run, as sins_get_errors() does; source is of enum sins_errors_source.
   --
   --  SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such run or source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL
   --  while the error model is off. SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_ensemble_get_navigation().
   function sins_ensemble_get_errors (ensemble : sins_ensemble; run : Unsigned_64; source : Integer_32;
       errors : in out sins_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_errors";

   --  Reads ideal and measured signals of the last interval of a run, as sins_get_imu() does.
   --
   --  SINS_NEED_SAMPLE: no interval yet. SINS_ERROR_INVALID_ARGUMENT: no such run. SINS_ERROR_DIVERGED: the run has diverged.
   function sins_ensemble_get_imu (ensemble : sins_ensemble; run : Unsigned_64; imu : in out sins_imu) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_imu";

   --  Reads the run number of diverged run `index`, from 0. The run numbers are in ascending order. sins_statistics.diverged is
   --  the number of diverged runs.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: index is not below the count of diverged runs.
   function sins_ensemble_get_diverged (ensemble : sins_ensemble; index : size_t; run : in out Unsigned_64) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_diverged";

   --  Reads the statistics of the errors of all runs at this moment; source is of enum sins_errors_source. sins_statistics_merge()
   --  adds those of other runs at the same moment. Within 20 km of the Earth's axis (SINS_NAVIGATION_NEAR_POLE of the truth) the up
   --  misalignment and the east and north components of the velocity error have no meaning. No allocation, no system call.
   --
   --  SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while
   --  the error model is off. SINS_ERROR_SINGULAR: before the first step, no run can start at the first sample.
   function sins_ensemble_get_statistics (ensemble : sins_ensemble; source : Integer_32;
       statistics : in out sins_statistics) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_get_statistics";

   --  Adds the runs of `other` to those of `into`. The caller makes sure that no run is in both. The sums are exact: any order
   --  and any grouping of merges gives the same bits, so the work can be split over threads, processes, machines and restarts in
   --  any way. If `into` is zero except for struct_size, it holds no runs.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or the sum would have more than 4294967295
   --  runs. into is then unchanged.
   function sins_statistics_merge (into : in out sins_statistics; other : sins_statistics) return sins_status
     with Import, Convention => C, External_Name => "sins_statistics_merge";

   --  Computes means, covariances, root mean squares and radii from statistics.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: they are damaged or of another release.
   function sins_statistics_figures (statistics : sins_statistics; figures : in out sins_figures) return sins_status
     with Import, Convention => C, External_Name => "sins_statistics_figures";

   --  Reads the size that a snapshot has now: about 1.3 to 5.25 KiB for each run, as for a simulator.
   function sins_ensemble_snapshot_size (ensemble : sins_ensemble; size : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_snapshot_size";

   --  Saves the whole ensemble, at any moment, as sins_snapshot_save() does for a simulator. written (may be NULL) gets the
   --  size. The same state gives the same bytes. No allocation, no system call.
   --
   --  SINS_ERROR_BUFFER_TOO_SMALL: see sins_ensemble_snapshot_size(); buffer and written are unchanged.
   function sins_ensemble_snapshot_save (ensemble : sins_ensemble; buffer : System.Address; capacity : size_t;
       written : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_snapshot_save";

   --  Replaces the ensemble by the saved one, including its runs and options. So the handle may be any ensemble, for example of
   --  one run. The loaded ensemble continues with the same bits as the saved one. size is the size that
   --  sins_ensemble_snapshot_save() wrote. Not for a real-time frame: it allocates.
   --
   --  SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of an ensemble, or are cut off, altered, or of a newer release; nothing
   --  has changed, and sins_last_error(NULL, ...) reports which it is. SINS_ERROR_OUT_OF_MEMORY: no memory for a second
   --  ensemble.
   function sins_ensemble_snapshot_load (ensemble : sins_ensemble; snapshot : System.Address; size : size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_ensemble_snapshot_load";

   --  Fills params with the gyro errors of a grade, of enum sins_grade. Biases, scale factor errors and misalignments are
   --  drawn at turn-on with the standard deviations that the source of the grade states; errors that it does not state are 0.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such grade.
   function sins_gyro_preset (grade : Integer_32; params : in out sins_gyro_params) return sins_status
     with Import, Convention => C, External_Name => "sins_gyro_preset";

   --  Fills params with the accelerometer errors of a grade, as sins_gyro_preset().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such grade.
   function sins_accel_preset (grade : Integer_32; params : in out sins_accel_params) return sins_status
     with Import, Convention => C, External_Name => "sins_accel_preset";

   --  Creates a flight from an array of count manoeuvres (1 to 4096). Speed, climb angle, course and bank are closed forms of time,
   --  smooth to the third derivative; the position is their integral, exact to rounding. manoeuvres[0].struct_size is the size
   --  in bytes of each element of manoeuvres.
   --
   --  Not for a real-time frame: it allocates, and integrates the path in pieces, about 15 us and 0.5 KB each. A piece of
   --  straight flight lasts up to 600 s. With a fast sinusoid of course, climb or speed, a piece is about one period. Sinusoids
   --  of roll, pitch and heading need no pieces.
   --
   --  On an error *flight is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a path that leaves the range of sins_flight_sample.height_m (the
   --  index in the sentence is that of the manoeuvre).
   --  SINS_ERROR_OUT_OF_MEMORY: no memory, more than 200000 pieces (which take 3 s), or 4096 flights exist.
   function sins_flight_create (start : sins_flight_start; manoeuvres : sins_manoeuvre_array; count : size_t;
       flight : in out sins_flight) return sins_status
     with Import, Convention => C, External_Name => "sins_flight_create";

   --  Reads the duration of the flight [s].
   function sins_flight_duration (flight : sins_flight; duration_s : in out double) return sins_status
     with Import, Convention => C, External_Name => "sins_flight_duration";

   --  Reads the sample at time_s, from 0 to the duration [s]. It is exact at any time, and times may come in any order. No
   --  allocation; 0.5 to 2 us.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a time before the start or after the end.
   function sins_flight_sample_at (flight : sins_flight; time_s : double; sample : in out sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_flight_sample_at";

   --  Destroys a flight.
   --
   --  SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
   function sins_flight_destroy (flight : sins_flight) return sins_status
     with Import, Convention => C, External_Name => "sins_flight_destroy";

   --  Creates the default scene: the recommended simulator with ideal sensors, at rest for an hour at latitude 0, longitude 0,
   --  height 0, sampled at 100 Hz.
   --
   --  On an error *scene is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason, as for every function of
   --  scenes. SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 scenes exist. Functions of scenes allocate: only sins_scene_prepare()
   --  and sins_scene_prepare_ensemble() are for a real-time frame. The other functions of scenes first check that enough memory
   --  is free for the call. If another thread takes this memory during the call, the process ends. sins_log_parse() does the
   --  same, except that running out of memory for the samples is always SINS_ERROR_OUT_OF_MEMORY.
   function sins_scene_create (scene : in out sins_scene) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_create";

   --  Creates a scene from its text: TOML in UTF-8, at most 1 MiB. The library does not keep the bytes.
   --  sins_scene_write_keys() and sins_scene_get_key() list the keys.
   --
   --  SINS_SCENE_HAS_FAULTS: the text is not a valid scene; sins_scene_get_fault() gives every fault and its place. The handle
   --  is made for that only: all other functions except sins_scene_destroy() return SINS_ERROR_BAD_STATE.
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
   function sins_scene_parse (text : char_array; size : size_t; scene : in out sins_scene) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_parse";

   --  Reads fault `index` of the scene's text, from 0 in the order of the text; fault->count is the number of faults. After
   --  sins_scene_set_values() and sins_scene_set_items() the faults are those of that call; none if it succeeded.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: there is no such fault.
   function sins_scene_get_fault (scene : sins_scene; index : size_t; fault : in out sins_fault) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_fault";

   --  Creates a built-in scene by its name: "simulation1", "simulation2", "rest", "patrol", "racetrack", "aerobatics",
   --  "over_the_pole", "coning", "commuter".
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no scene has that name.
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
   function sins_scene_create_builtin (name : char_array; scene : in out sins_scene) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_create_builtin";

   --  Reads the name of built-in scene `index`, from 0. buffer, capacity and needed as in sins_scene_write().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: there are no more.
   function sins_scene_builtin_name (index : size_t; buffer : in out char_array; capacity : size_t;
       needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_builtin_name";

   --  Writes the scene as commented TOML, which sins_scene_parse() reads back to the same scene, to the bit.
   --
   --  needed (may be NULL) gets the size of the whole text with its terminator; buffer NULL and capacity 0 ask for the size
   --  only. SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_INVALID_ARGUMENT: settings that do not go together, or
   --  so many manoeuvres and failures that the text would have more than 1 MiB. SINS_ERROR_BAD_STATE: as sins_scene_parse().
   function sins_scene_write (scene : sins_scene; buffer : in out char_array; capacity : size_t;
       needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_write";

   --  Writes every section and key of a scene, one in a line, with its values, its unit and its meaning. buffer, capacity and
   --  needed as in sins_scene_write().
   function sins_scene_write_keys (buffer : in out char_array; capacity : size_t; needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_write_keys";

   --  Creates the simulator of the scene, ready for the first sample: options, sensor errors, initial errors, mounting, gravity
   --  disturbance. sins_scene_prepare() sets the failures at their times. If the flight is not a log,
   --  sins_options.sample_period_s of the simulator is 1 / rate_hz.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: settings that do not go together.
   --  SINS_ERROR_BAD_STATE: as sins_scene_parse().
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_create().
   function sins_scene_create_simulator (scene : sins_scene; sim : in out sins_sim) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_create_simulator";

   --  Creates the flight of the scene, composed of manoeuvres or built-in, on the scene's ellipsoid. A host samples it at k / rate
   --  up to sins_scene_setup.flown_s.
   --
   --  SINS_ERROR_BAD_STATE: the flight of the scene is a log, whose name is SINS_SCENE_TEXT_LOG; or as sins_scene_parse().
   --  Else as sins_flight_create().
   function sins_scene_create_flight (scene : sins_scene; flight : in out sins_flight) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_create_flight";

   --  Destroys a scene. Simulators and flights that were created from it stay valid.
   --
   --  SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
   function sins_scene_destroy (scene : sins_scene) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_destroy";

   --  Prepares the next interval: call this function before each push, and call sins_step() before you call it again. The
   --  sample gets the temperature of the scene, if the scene has one. The call sets and clears the failures of the scene on sim.
   --  A failure begins at the first interval that starts at or after from_s, and ends at the first interval that starts at or
   --  after until_s. If the scene plans no failure of an output, the call does not touch the failure of that output.
   --  flight_start_s is the time stamp of the flight's first sample. No allocation, no system call.
   --
   --  SINS_ERROR_BAD_HANDLE: scene or sim is not a valid handle.
   --  SINS_ERROR_INVALID_ARGUMENT: a sample out of its ranges, or flight_start_s not from -2e10 to 2e10.
   --  SINS_ERROR_BAD_STATE: as sins_scene_parse().
   function sins_scene_prepare (scene : sins_scene; sim : sins_sim; flight_start_s : double;
       sample : in out sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_prepare";

   --  Prepares the next interval of all runs of an ensemble, as sins_scene_prepare() does for a simulator. No allocation, no
   --  system call.
   --
   --  SINS_ERROR_BAD_HANDLE: scene or ensemble is not a valid handle. The other errors: as sins_scene_prepare().
   function sins_scene_prepare_ensemble (scene : sins_scene; ensemble : sins_ensemble; flight_start_s : double;
       sample : in out sins_flight_sample) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_prepare_ensemble";

   --  Reads the options of the scene.
   --
   --  SINS_ERROR_BAD_STATE: as sins_scene_parse(), as for all functions that read or set a part of a scene.
   function sins_scene_get_options (scene : sins_scene; options : in out sins_options) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_options";

   --  Sets the options of the scene. As with every part, an error leaves the scene unchanged. Parts can be set in any order:
   --  whether they go together is checked when the scene is written, and when its simulator is created.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: as sins_create().
   function sins_scene_set_options (scene : sins_scene; options : sins_options) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_options";

   --  Reads the gyro errors of the scene.
   function sins_scene_get_gyro (scene : sins_scene; params : in out sins_gyro_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_gyro";

   --  Sets the gyro errors of the scene.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_gyro (scene : sins_scene; params : sins_gyro_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_gyro";

   --  Reads the accelerometer errors of the scene.
   function sins_scene_get_accel (scene : sins_scene; params : in out sins_accel_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_accel";

   --  Sets the accelerometer errors of the scene.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_accel (scene : sins_scene; params : sins_accel_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_accel";

   --  Reads the errors of the scene's altimeter.
   function sins_scene_get_altimeter (scene : sins_scene; params : in out sins_altimeter_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_altimeter";

   --  Sets the errors of the scene's altimeter.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_altimeter (scene : sins_scene; params : sins_altimeter_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_altimeter";

   --  Reads the errors with which the navigation of the scene starts.
   function sins_scene_get_initial_errors (scene : sins_scene; errors : in out sins_initial_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_initial_errors";

   --  Sets the errors with which the navigation of the scene starts.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_initial_errors (scene : sins_scene; errors : sins_initial_errors) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_initial_errors";

   --  Reads the mounting of the scene's sensor block.
   function sins_scene_get_mounting (scene : sins_scene; mounting : in out sins_mounting) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_mounting";

   --  Sets the mounting of the scene's sensor block.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_mounting (scene : sins_scene; mounting : sins_mounting) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_mounting";

   --  Reads the gravity disturbance of the scene.
   function sins_scene_get_gravity_disturbance (scene : sins_scene; params : in out sins_gravity_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_gravity_disturbance";

   --  Sets the gravity disturbance of the scene.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_gravity_disturbance (scene : sins_scene; params : sins_gravity_params) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_gravity_disturbance";

   --  Reads the settings of a scene for its flight and its output.
   function sins_scene_get_setup (scene : sins_scene; setup : in out sins_scene_setup) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_setup";

   --  Sets the settings of a scene for its flight and its output; the fields flight and flown_s are ignored.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   function sins_scene_set_setup (scene : sins_scene; setup : sins_scene_setup) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_setup";

   --  Reads the flight of the scene, composed of manoeuvres or built-in: its start, its manoeuvres, their number (count), and
   --  how many times all of them are flown (repeat). manoeuvres[0].struct_size is the size in bytes of each element of
   --  manoeuvres. start and repeat may be NULL. To ask for count only, give NULL for manoeuvres and a capacity of 0.
   --
   --  SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of manoeuvres; only count was written.
   --  SINS_ERROR_BAD_STATE: the flight is a log; or as sins_scene_parse().
   function sins_scene_get_manoeuvres (scene : sins_scene; start : in out sins_flight_start;
       manoeuvres : in out sins_manoeuvre_array; capacity : size_t; count : in out size_t;
       repeat : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_manoeuvres";

   --  Composes the flight of the scene of an array of count manoeuvres, all flown repeat times; count * repeat is at most 4096.
   --  start->earth is ignored: the ellipsoid is that of the scene's options. If the flight was a log before, the new flight is
   --  sampled at 100 Hz.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: as sins_flight_create(), except that heights along the path are not checked.
   function sins_scene_set_manoeuvres (scene : sins_scene; start : sins_flight_start; manoeuvres : sins_manoeuvre_array;
       count : size_t; repeat : size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_manoeuvres";

   --  Reads a text of the scene; which is of enum sins_scene_text. An empty text means that it is not set. buffer, capacity
   --  and needed as in sins_scene_write().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such text.
   function sins_scene_get_text (scene : sins_scene; which : Integer_32; buffer : in out char_array; capacity : size_t;
       needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_text";

   --  Sets a text of the scene; which is of enum sins_scene_text. The text is UTF-8, terminated, at most 4096 bytes. An empty
   --  text clears it, except SINS_SCENE_TEXT_LOG and SINS_SCENE_TEXT_BUILTIN, which cannot be empty.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such text, not UTF-8, too long, a control character, or no such built-in scene.
   function sins_scene_set_text (scene : sins_scene; which : Integer_32; text : char_array) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_text";

   --  Reads the number of failures that the scene plans.
   function sins_scene_get_failure_count (scene : sins_scene; count : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_failure_count";

   --  Reads planned failure `index`, from 0.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such failure.
   function sins_scene_get_failure (scene : sins_scene; index : size_t; failure : in out sins_planned_failure) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_failure";

   --  Adds a planned failure.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a failure of the same output at the same time.
   function sins_scene_add_failure (scene : sins_scene; failure : sins_planned_failure) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_add_failure";

   --  Removes all planned failures.
   function sins_scene_clear_failures (scene : sins_scene) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_clear_failures";

   --  Reads key `index` of the scene format, from 0 in the order in which a scene is written.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: there are no more.
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
   function sins_scene_get_key (index : size_t; key : in out sins_scene_key) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_key";

   --  Reads the value at a path, as it stands in the text of a scene: "gyro.bias_deg_h" (all three), "gyro.bias_deg_h[1]" (that of
   --  the y axis), "gyro.bias_rad_s" (in SI), "options.scheme", "manoeuvre[3].bank_deg", "manoeuvre[3].sinusoid[0].channel",
   --  "failure[0].kind". Places in lists begin at 0. Words and texts are in quotes. The text is empty if the scene has no such
   --  value. For example, flight.hours is empty if the scene flies the whole flight. The scene stores numbers in SI, so a number
   --  read in another unit may be rounded. The scene does not store the name of a preset, only the errors that the preset sets.
   --
   --  The paths "manoeuvre[3]" and "failure[0]" give all lines of an item, for sins_scene_set_items(). A built-in flight and a log
   --  have no such manoeuvres. buffer, capacity and needed as in sins_scene_write().
   --
   --  SINS_ERROR_INVALID_ARGUMENT: the path names no value, or the scene has no such item.
   function sins_scene_get_value (scene : sins_scene; path : char_array; buffer : in out char_array; capacity : size_t;
       needed : in out size_t) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_value";

   --  Sets up to 4096 values of the scene, all or none. values is a terminated text in UTF-8. Each line is path = value, with a
   --  path as in sins_scene_get_value(). Blank lines and lines that begin with # are ignored. A value is written as in the text of
   --  a scene, but words and texts need no quotes. An empty value (gyro.bias_deg_h =) sets the default of the key. If the path is a
   --  single element (gyro.bias_deg_h[1] =), it sets 0. If a value is set twice, the last one counts. gyro.preset replaces all
   --  errors of the gyros, accelerometer.preset those of the accelerometers, before the other lines are applied, wherever it
   --  stands. flight.file and flight.builtin replace the flight.
   --
   --  The scene is then checked as sins_scene_parse() checks a text. Set values that depend on each other in one call, such as the
   --  kind of a manoeuvre and its quantities.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: the scene would not be valid, and stays as it was. sins_scene_get_fault() gives every fault
   --  with the line in values and the path.
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
   function sins_scene_set_values (scene : sins_scene; values : char_array) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_values";

   --  Replaces all items of a list, "manoeuvre" or "failure". items is a terminated text with the items as in the text of a scene:
   --  [[manoeuvre]] and its keys, and so on. sins_scene_get_value() gives the text of one item. To add, remove or move an item,
   --  give the texts of all items that the list shall have, in order. An empty text removes all failures; for "manoeuvre" an empty
   --  text is a fault. If the flight was a built-in flight, the manoeuvres begin at its start; if it was a log, at latitude 0,
   --  longitude 0, height 0.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such list, or the scene would not be valid; it stays as it was. sins_scene_get_fault() gives
   --  every fault with the line in items and the path.
   --  SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
   function sins_scene_set_items (scene : sins_scene; list : char_array; items : char_array) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_set_items";

   --  Reads a flight log, comma-separated values in UTF-8, in lines that end with LF or CR LF. The first line that is not a
   --  comment (#) names the columns, in any order; columns of other names are ignored, and a row with more fields than columns
   --  is a fault:
   --
   --  time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m, roll_rad or _deg, pitch_rad or _deg, heading_rad
   --  or _deg; optional: velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s, rate_y_rad_s, rate_z_rad_s;
   --  force_x_m_s2, force_y_m_s2, force_z_m_s2; temperature_c
   --
   --  The three velocities are all present or all absent; so are the three rates, and the three forces. Without velocities the
   --  samples have SINS_SAMPLE_NO_VELOCITY. Two columns of one quantity are a fault. Frames and signs are those of
   --  sins_flight_sample. A log has at least two samples, each later than the one before. The ranges of the values are checked
   --  when a sample is pushed. The library does not keep the bytes. Not for a real-time frame: it allocates, 184 bytes a sample.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: the text is not a valid flight log; fault (may be NULL) gets the first fault and its place,
   --  sins_last_error(NULL, ...) gives both as a sentence, and *log is unchanged.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory for the samples, or 4096 logs exist.
   function sins_log_parse (text : char_array; size : size_t; log : in out sins_log; fault : in out sins_fault) return sins_status
     with Import, Convention => C, External_Name => "sins_log_parse";

   --  Reads the number of samples of a log, its duration and its title.
   function sins_log_get_info (log : sins_log; info : in out sins_log_info) return sins_status
     with Import, Convention => C, External_Name => "sins_log_get_info";

   --  Reads sample `index`, from 0 in the order of the log, ready for sins_push_sample(). line (may be NULL) gets its line in
   --  the text, from 1. No allocation.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: no such sample.
   function sins_log_get_sample (log : sins_log; index : size_t; sample : in out sins_flight_sample;
       line : in out Unsigned_64) return sins_status
     with Import, Convention => C, External_Name => "sins_log_get_sample";

   --  Destroys a flight log.
   --
   --  SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
   function sins_log_destroy (log : sins_log) return sins_status
     with Import, Convention => C, External_Name => "sins_log_destroy";

   --  Reads which samples the scene flies. If the flight is composed of manoeuvres or is built-in, give NULL for `log`; sample k
   --  is then sins_flight_sample_at(flight, k / rate_hz) of sins_scene_create_flight(). For a log, sample k is
   --  sins_log_get_sample(log, k); the samples end at the duration that the scene sets.
   --
   --  SINS_ERROR_INVALID_ARGUMENT: the flight is not valid, the log has no second sample within the duration, or
   --  sins_scene_setup.every_s is less than the time between two samples.
   --  SINS_ERROR_BAD_HANDLE: scene or log is not a valid handle.
   --  SINS_ERROR_BAD_STATE: the flight is a log, and log is NULL; or as sins_scene_parse().
   function sins_scene_get_samples (scene : sins_scene; log : sins_log; samples : in out sins_scene_samples) return sins_status
     with Import, Convention => C, External_Name => "sins_scene_get_samples";

   --  Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples.
   --  samples[0].struct_size is the size in bytes of each element of samples.
   --
   --  configured is a simulator as the host flies it, at any moment. The call uses only its options and its mounting, reads them at
   --  the start, and neither steps nor changes the simulator. NULL is the recommended simulator with its sensor block at the
   --  reference point. The output `options` gets the options of configured, ready for sins_create(). Only scheme, subsamples and
   --  updates_per_sample are replaced by the recommended values. The values of these three in configured do not matter.
   --
   --  The piece must contain the hardest motion of the flight: its largest rates, specific forces and vibration. A calmer piece,
   --  such as the time on the ramp, gives an answer that is false for the flight. The plainest piece is the whole flight.
   --
   --  Each algorithm flies the piece with ideal sensors in the same mounting. Its solution is compared at every sample with a
   --  reference: a solution of SINS_SCHEME_POLYNOMIAL in Earth-fixed axes with 16 updates of 5 subsamples. The uncertainty of
   --  the reference (its difference from a solution with half as many updates) is added to the error. The error is that of the
   --  algorithm only. Errors of sensors, altimeter and believed mounting, initial errors, the gravity disturbance, and
   --  contradictions within the host's samples are left out, because they act on both solutions alike. The signals are without
   --  the trim of SINS_SIGNAL_CLOSED_LOOP, which would hide the error. If the duration is longer than the piece, the call
   --  assumes that the piece is repeated. Each repetition adds the same errors with the same sign. The call assumes the worst
   --  phase of the Schuler oscillation. If the flight continues like the piece, its errors are smaller than this prediction.
   --  With SINS_VERTICAL_FREE each error is taken as a height error, which grows e-fold every 569 s.
   --
   --  Algorithms are ordered by instructions_per_step, so the same samples give the same answer on every machine; only ns_per_step
   --  differs. Not for a real-time frame: it allocates, and takes about 25 to 70 us a sample, up to 0.4 ms if nothing meets the
   --  requirement.
   --
   --  SINS_REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the algorithm that comes
   --  closest.
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
   --  SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
   --  SINS_ERROR_DIVERGED: the solution of every algorithm diverged.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory.
   --
   --  sins_last_error(NULL, ...) on this thread gives the reason and the sample.
   function sins_recommend (configured : sins_sim; samples : sins_flight_sample_array; count : size_t;
       requirement : sins_requirement; options : in out sins_options; cost : in out sins_cost) return sins_status
     with Import, Convention => C, External_Name => "sins_recommend";

   --  Computes the contribution of each effect to the errors of a flight of 2 to 1e9 samples: which effects matter, and which
   --  can be left out. samples[0].struct_size is the size in bytes of each element of samples, rows[0].struct_size that of each
   --  element of rows. struct_size of the other samples may be 0, that of the other rows anything.
   --
   --  configured is a simulator as the host flies it, at any moment. The call uses its options and all its errors: those of
   --  gyros, accelerometers and altimeter, the initial errors, and those of mounting and gravity, but not its failures. The call
   --  reads them at the start, and neither steps nor changes the simulator. NULL is the recommended simulator without errors.
   --  NULL for request is 16 runs and no limits. written and budget may be NULL.
   --
   --  Each field that sets an error is one effect. An effect is active, and has a row, if its field is not 0. These settings are
   --  not effects: the alignment, and lever_arm_m and boresight_rad of the mounting. The misalignment that
   --  SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS leaves belongs to the effect that causes this misalignment. All runs use lever_arm_m
   --  and boresight_rad. The contribution of an effect is the error (navigation less truth) of a run with this effect alone,
   --  less the error of a run with no effect. For position, velocity and misalignment the row has two lengths of the
   --  contribution. One is the largest length at up to 1000 equally spaced instants. The other is the length at the last sample.
   --  The contribution of a random effect is one standard deviation, by the covariance of a flight with this effect alone
   --  (SINS_BUDGET_RANDOM; see sins_covariance), from linear error equations. All effects together are flown in several runs,
   --  with the random numbers of the runs sins_options.run, run + 1 and so on.
   --
   --  rows[0] is the mechanization's own error, including contradictions within the samples. The effects follow, ordered by
   --  position, then velocity, then misalignment, the largest first; with limits, by their share of a limit. The remainder is
   --  the difference between the error with all effects and the sum of the rows, with the same random numbers. It comes from
   --  effects that act on each other, and is of second order in their sizes.
   --
   --  With limits, the call marks the effects that can be left out together (SINS_BUDGET_CAN_BE_LEFT_OUT). It goes through the
   --  effects in the order of their shares, the smallest first, and collects each effect that still fits. For position, velocity
   --  and misalignment separately, let D be the sum of the deterministic contributions of a collection, and R the root sum of
   --  squares of its random contributions. The collection fits if sqrt(D^2 + R^2) is at most the limit, for each limit that is
   --  given. Then the call flies all runs again without these effects. While the change (left_out) exceeds a limit, it puts back
   --  the largest of the effects that were left out.
   --
   --  The same samples give the same answer on every machine, except for the figures ns_per_step. Not for a real-time frame: it
   --  allocates, and flies the samples many times, each time in 0.6 to 1.5 us a sample. It flies them once with no effect, once
   --  for each effect, once in each run with all effects together, and, if there are random effects, once in each run with the
   --  random effects alone. With limits it flies them once more in each run, and further times if effects do not add up.
   --  time_steps adds 61 rounds of about 250 steps with no effect, with all, and without each effect.
   --
   --  SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of rows; written gets that number, and nothing is flown.
   --  (To ask for the number, give NULL for rows and a capacity of 0.)
   --  SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
   --  SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
   --  SINS_ERROR_SINGULAR: too close to a pole, in geographic axes or for gyrocompassing.
   --  SINS_ERROR_DIVERGED: a solution diverged.
   --  SINS_ERROR_OUT_OF_MEMORY: no memory.
   --
   --  sins_last_error(NULL, ...) on this thread gives the reason and the sample.
   function sins_error_budget (configured : sins_sim; samples : sins_flight_sample_array; count : size_t;
       request : sins_budget_request; rows : in out sins_budget_row_array; capacity : size_t; written : in out size_t;
       budget : in out sins_budget) return sins_status
     with Import, Convention => C, External_Name => "sins_error_budget";

end Sins;
