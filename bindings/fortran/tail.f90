
contains

  !> The sentence of the last error on a simulator, or with c_null_ptr of this thread: sins_last_error() as a text.
  function sins_sentence(sim) result(sentence)
    type(c_ptr), intent(in) :: sim
    character(len=:), allocatable :: sentence
    character(len=1024) :: buffer
    integer(c_size_t) :: needed

    buffer = c_null_char
    if (sins_last_error(sim, buffer, len(buffer, c_size_t), needed) < 0) buffer = "no sentence" // c_null_char
    sentence = sins_string(buffer)
  end function sins_sentence

  function sins_string_of_pointer(text) result(string)
    type(c_ptr), intent(in) :: text
    character(len=:), allocatable :: string
    character(kind=c_char), pointer :: characters(:)
    integer :: length

    length = 0
    do
      call c_f_pointer(text, characters, [length + 1])
      if (characters(length + 1) == c_null_char) exit
      length = length + 1
    end do
    string = sins_string_of_field(characters)
  end function sins_string_of_pointer

  pure function sins_string_of_field(characters) result(string)
    character(kind=c_char), intent(in) :: characters(:)
    character(len=:), allocatable :: string
    character(len=size(characters)) :: text
    integer :: k

    do k = 1, size(characters)
      text(k:k) = characters(k)
    end do
    string = sins_string_of_buffer(text)
  end function sins_string_of_field

  pure function sins_string_of_buffer(buffer) result(string)
    character(len=*), intent(in) :: buffer
    character(len=:), allocatable :: string

    string = buffer(:index(buffer // c_null_char, c_null_char) - 1)
  end function sins_string_of_buffer

end module sins
