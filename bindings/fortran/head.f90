!> The interface of the library sins for Fortran 2008: the names, the units and the documentation are those of include/sins.h,
!> whose first comment describes the rules for all functions.
!>
!> Structs. Every variable of such a type is ready to use: struct_size is set, and all other fields are zero, which is off or
!>   recommended. Where the documentation says that a pointer to a struct may be NULL, pass a fresh variable: it means the same.
!> Handles of simulators, flights, scenes and logs are of type(c_ptr). c_null_ptr is NULL.
!> Texts. A text for the library must end with a null character: "patrol" // c_null_char. A buffer for a text is a character
!>   variable, with its length as capacity. sins_string() converts a text of the library to a Fortran string.
!> Matrices. C stores matrices row by row, Fortran column by column: misalignment_rad(column, row). So
!>   gyro%misalignment_rad = transpose(matrix) sets the elements matrix(row, column). The increments of sins_imu_increment are
!>   angle_rad(axis, part).
!> Integers are signed, because Fortran has no others: a seed beyond 2**63 - 1 is a negative number. Indices of functions count
!>   from 0, as in C; arrays of Fortran count from 1.
!> Flags: iand(sample%flags, SINS_SAMPLE_TEMPERATURE) /= 0.
!>
!> This file is written by build/ from the Rust sources; do not edit it.
module sins
  use, intrinsic :: iso_c_binding
  implicit none

  !> A text of C, up to its null character: of a function (type(c_ptr)), of a field of a struct, or of a buffer.
  interface sins_string
    module procedure sins_string_of_pointer, sins_string_of_field, sins_string_of_buffer
  end interface

