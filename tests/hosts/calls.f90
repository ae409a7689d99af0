! The same calls as in calls.c.
program calls
  use sins
  implicit none

  integer, parameter :: count = 121
  integer(c_size_t), parameter :: every = 30, capacity = 5
  type(c_ptr) :: sim = c_null_ptr, second = c_null_ptr, flight = c_null_ptr
  type(sins_flight_sample) :: samples(count)
  character(kind=c_char), target :: bytes(SINS_SNAPSHOT_MAX_SIZE)
  type(sins_options) :: options
  type(sins_gyro_params) :: gyro
  type(sins_flight_start) :: start
  type(sins_manoeuvre) :: manoeuvres(2)
  type(sins_record) :: records(capacity)
  type(sins_navigation) :: navigation
  type(sins_error_info) :: info
  character(len=64) :: name
  real(c_double) :: matrix(3, 3)
  integer(c_size_t) :: written, needed
  integer :: k

  call check(sins_scene_builtin_name(1_c_size_t, name, len(name, c_size_t), needed))
  call show(sins_string(name), real(needed, c_double))

  start%latitude_rad = 0.7_c_double
  start%speed_m_s = 100.0_c_double
  manoeuvres(1)%kind = SINS_MANOEUVRE_STRAIGHT
  manoeuvres(1)%duration_s = 5.0_c_double
  manoeuvres(2)%kind = SINS_MANOEUVRE_ROLL
  manoeuvres(2)%duration_s = 10.0_c_double
  manoeuvres(2)%turns = 1.0_c_double
  call check(sins_flight_create(start, manoeuvres, 2_c_size_t, flight))
  do k = 1, count
    call check(sins_flight_sample_at(flight, (k - 1) / 8.0_c_double, samples(k)))
  end do

  options%scheme = SINS_SCHEME_POLYNOMIAL
  options%subsamples = 3
  call check(sins_create(options, sim))
  matrix = 0
  matrix(1, 2) = 1.0e-3_c_double
  matrix(3, 1) = 2.0e-3_c_double
  gyro%misalignment_rad = transpose(matrix)
  call check(sins_set_gyro(sim, gyro))
  call check(sins_run(sim, samples, int(count, c_size_t), every, records, capacity, written))
  call show("written", real(written, c_double))
  do k = 1, int(written)
    call show("time", records(k)%time_s)
    call show("velocity", records(k)%navigation_errors%velocity_enu_m_s(2))
    call show("misalignment", records(k)%navigation_errors%misalignment_enu_rad(3))
  end do

  call check(sins_snapshot_save(sim, c_loc(bytes), size(bytes, kind=c_size_t), needed))
  call show("snapshot", real(needed, c_double))
  call check(sins_create(options, second))
  call check(sins_snapshot_load(second, c_loc(bytes), needed))
  call check(sins_get_navigation(second, navigation))
  call show("quaternion", navigation%quaternion_nb(4))

  matrix(3, 2) = 2.0_c_double
  gyro%misalignment_rad = transpose(matrix)
  call show("refused", real(sins_set_gyro(sim, gyro), c_double))
  call check(sins_last_error_info(sim, info))
  call show(sins_string(info%field), real(info%index, c_double))

  call check(sins_destroy(sim))
  call check(sins_destroy(second))
  call check(sins_flight_destroy(flight))

contains

  subroutine show(label, value)
    character(len=*), intent(in) :: label
    real(c_double), intent(in) :: value

    print "(a, 1x, es25.16e3)", label, value
  end subroutine show

  subroutine check(status)
    integer(sins_status), intent(in) :: status

    if (status >= 0) return
    print "(2a)", "calls: ", sins_string(sins_status_string(status))
    stop 1
  end subroutine check

end program calls
