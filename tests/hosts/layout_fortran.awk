# Makes a program from sins.f90 that prints its sizes, offsets and constants.

function show(label, value) {
    shown[++count] = "  call show(\"" label "\", &\n    real(" value ", c_double))"
}

BEGIN {
    print "program layout\n  use sins\n  implicit none"
}
/^  (integer|real)\(.*, parameter :: SINS_/ { show($(NF - 2), $(NF - 2)) }
/^  type, bind\(C\) :: / {
    name = $NF
    print "  type(" name "), target :: its_" name
    show("sizeof(" name ")", "c_sizeof(its_" name ")")
}
/^    (integer|real|character|type)\(.* :: / && name != "" {
    field = $0
    sub(/.* :: /, "", field)
    sub(/[( =].*/, "", field)
    show("sizeof(" name "." field ")", "c_sizeof(its_" name "%" field ")")
    show(name "." field, "at(c_loc(its_" name "%" field ")) - at(c_loc(its_" name "))")
}
/^  end type/ { name = "" }
END {
    for (k = 1; k <= count; k++) print shown[k]
    print "contains"
    print "  integer(c_intptr_t) function at(address)"
    print "    type(c_ptr), intent(in) :: address"
    print "    at = transfer(address, at)"
    print "  end function at"
    print "  subroutine show(label, value)"
    print "    character(len=*), intent(in) :: label"
    print "    real(c_double), intent(in) :: value"
    print "    character(len=32) :: number"
    print "    write (number, \"(es25.16e3)\") value"
    print "    print \"(a, 1x, a)\", label, trim(adjustl(number))"
    print "  end subroutine show"
    print "end program layout"
}
