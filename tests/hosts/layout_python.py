"""Prints every size, offset and constant of sins.py, like the program of layout_c.awk does for the header."""

import ctypes

from sins import c as sins

for name, value in list(vars(sins).items()):
    if isinstance(value, type) and issubclass(value, sins._Struct) and value is not sins._Struct:
        print(f"sizeof(sins_{name})", ctypes.sizeof(value))
        print(f"SINS_SIZEOF_{name.upper()}", ctypes.sizeof(value))
        for field, _ in value._fields_:
            print(f"sins_{name}.{field}", getattr(value, field).offset)
            print(f"sizeof(sins_{name}.{field})", getattr(value, field).size)
    elif isinstance(value, (int, float)) and name.isupper():
        print(f"SINS_{name}", repr(float(value)))
