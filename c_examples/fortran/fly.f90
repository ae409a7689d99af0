! Flies a built-in scene and prints the navigation of its INS: fly patrol
program fly
  use, intrinsic :: iso_fortran_env, only: error_unit
  use sins
  implicit none

  type(c_ptr) :: scene = c_null_ptr, sim = c_null_ptr, flight = c_null_ptr
  type(sins_scene_setup) :: setup
  type(sins_flight_sample) :: sample
  type(sins_record) :: record
  character(len=64) :: name
  integer :: k, samples, every
  real(c_double) :: time_s

  if (command_argument_count() /= 1) then
    write (error_unit, "(a)") "usage: fly NAME of a built-in scene"
    stop 2
  end if
  call get_command_argument(1, name)
  if (sins_abi_version() /= SINS_HEADER_ABI) then
    write (error_unit, "(a, i0, a, i0)") "fly: the library has interface version ", sins_abi_version(), &
      ", this program needs ", SINS_HEADER_ABI
    stop 1
  end if

  call check("sins_scene_create_builtin", c_null_ptr, sins_scene_create_builtin(trim(name) // c_null_char, scene))
  call check("sins_scene_get_setup", c_null_ptr, sins_scene_get_setup(scene, setup))
  call check("sins_scene_create_flight", c_null_ptr, sins_scene_create_flight(scene, flight))
  call check("sins_scene_create_simulator", c_null_ptr, sins_scene_create_simulator(scene, sim))

  samples = floor(setup%flown_s * setup%rate_hz + 1.0e-6_c_double) + 1
  every = max(samples / 20, 1)
  print "(a10, 2a12, 3a12)", "time s", "lat deg", "long deg", "east m", "north m", "up m"
  do k = 0, samples - 1
    time_s = min(k / setup%rate_hz, setup%flown_s)
    call check("sins_flight_sample_at", c_null_ptr, sins_flight_sample_at(flight, time_s, sample))
    call check("sins_scene_prepare", c_null_ptr, sins_scene_prepare(scene, sim, 0.0_c_double, sample))
    call check("sins_push_sample", sim, sins_push_sample(sim, sample))
    call check("sins_step", sim, sins_step(sim)) ! the first step returns SINS_NEED_SAMPLE, which is not an error
    if (mod(k, every) == 0) then
      call check("sins_get_record", sim, sins_get_record(sim, record))
      print "(f10.2, 2f12.6, 3f12.3)", record%time_s, record%navigation%latitude_rad / SINS_DEG, &
        record%navigation%longitude_rad / SINS_DEG, record%navigation_errors%position_enu_m
    end if
  end do

  call check("sins_get_record", sim, sins_get_record(sim, record))
  print "(/, a)", "errors at the end, navigation - truth, east-north-up"
  print "(a16, 3es25.16e3)", "position m", record%navigation_errors%position_enu_m
  print "(a16, 3es25.16e3)", "velocity m/s", record%navigation_errors%velocity_enu_m_s
  print "(a16, 3es25.16e3)", "misalignment rad", record%navigation_errors%misalignment_enu_rad

  call check("sins_destroy", c_null_ptr, sins_destroy(sim))
  call check("sins_flight_destroy", c_null_ptr, sins_flight_destroy(flight))
  call check("sins_scene_destroy", c_null_ptr, sins_scene_destroy(scene))

contains

  ! Ends the program if a call failed: errors are negative. The library keeps the sentence of a simulator's function with the
  ! simulator. The sentences of other functions belong to the thread: argument of is c_null_ptr.
  subroutine check(call, of, status)
    character(len=*), intent(in) :: call
    type(c_ptr), intent(in) :: of
    integer(c_int32_t), intent(in) :: status

    if (status >= 0) return
    write (error_unit, "(6a)") "fly: ", call, ": ", sins_sentence(of), " ", "(" // sins_string(sins_status_string(status)) // ")"
    stop 1
  end subroutine check

end program fly
