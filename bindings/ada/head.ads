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
--  This file is written by build/ from the Rust sources; do not edit it.

with Interfaces;           use Interfaces;
with Interfaces.C;         use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System;

package Sins is

