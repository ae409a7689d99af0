! Flies a built-in scene and prints the navigation of its INS: fly patrol
program fly
  use, intrinsic :: iso_fortran_env, only: error_unit
  use sins
  implicit none

  type(c_ptr) :: scene = c_null_ptr, play = c_null_ptr
  type(sins_scene_samples) :: samples
  type(sins_record) :: record(1)
  character(len=64) :: name, spacing
  integer(c_int32_t) :: status
  integer(c_size_t) :: written

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

  call check("sins_scene_create_builtin", sins_scene_create_builtin(trim(name) // c_null_char, scene))
  call check("sins_scene_get_samples", sins_scene_get_samples(scene, c_null_ptr, samples))
  write (spacing, "(a, es22.15)") "output.every_s = ", max(samples%duration_s / 20, samples%period_s)
  call check("sins_scene_set_values", sins_scene_set_values(scene, trim(spacing) // c_null_char))
  call check("sins_play_create", sins_play_create(scene, c_null_ptr, play))

  print "(a10, 2a12, 3a12)", "time s", "lat deg", "long deg", "east m", "north m", "up m"
  do ! from record to record: with the temperature, the failures, the updates and the unit of the scene
    status = sins_play_run(play, record, 1_c_size_t, written)
    call check("sins_play_run", status)
    if (written == 1) then
      print "(f10.2, 2f12.6, 3f12.3)", record(1)%time_s, record(1)%navigation%latitude_rad / SINS_DEG, &
        record(1)%navigation%longitude_rad / SINS_DEG, record(1)%navigation_errors%position_enu_m
    end if
    if (status == SINS_PLAY_END) exit
  end do

  print "(/, a)", "errors at the end, navigation - truth, east-north-up"
  print "(a16, 3es25.16e3)", "position m", record(1)%navigation_errors%position_enu_m
  print "(a16, 3es25.16e3)", "velocity m/s", record(1)%navigation_errors%velocity_enu_m_s
  print "(a16, 3es25.16e3)", "misalignment rad", record(1)%navigation_errors%misalignment_enu_rad

  call check("sins_play_destroy", sins_play_destroy(play))
  call check("sins_scene_destroy", sins_scene_destroy(scene))

contains

  ! Ends the program if a call failed: errors are negative. The sentences of scenes belong to the thread, so their simulator is
  ! c_null_ptr.
  subroutine check(call, status)
    character(len=*), intent(in) :: call
    integer(c_int32_t), intent(in) :: status

    if (status >= 0) return
    write (error_unit, "(6a)") "fly: ", call, ": ", sins_sentence(c_null_ptr), " ", &
      "(" // sins_string(sins_status_string(status)) // ")"
    stop 1
  end subroutine check

end program fly
