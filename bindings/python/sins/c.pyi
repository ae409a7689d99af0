# The names of sins.h. Their documentation is in the module: help(sins.c.create).
from typing import Any

class Error(Exception):
    status: int
    info: Any
    faults: Any
    outputs: Any

def check_masks(name: str, value: Any) -> None: ...

def __getattr__(name: str) -> Any: ...
