"""sins.h for Python 3.9 and later, by ctypes: nothing is compiled.

    from sins import c as sins

    gyro = sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0))    # fields that are not named are 0: off
    with sins.create() as sim:                                             # destroyed at the end
        sins.set_gyro(sim, gyro)
        for second in range(3601):
            sins.push_sample(sim, sins.flight_sample(time_s=second, latitude_rad=39.9 * sins.DEG))
            sins.step(sim)
        errors = sins.get_errors(sim, sins.ERRORS_NAVIGATION)
    print(errors.position_enu_m[0], errors.position_enu_m[1])

sins_create() of the header is sins.create() here, and SINS_DEG is sins.DEG: names, arguments and their order are those of the
header, but without the length after an array. NULL is None. Outputs at the end of the arguments may be left out: the call then
returns them, one or a tuple, instead of its status: a struct, a handle, a number, a text; None if there is none yet
(sins.NEED_SAMPLE). Inputs before these outputs may be left out too if they may be None: sins.create(). An output that is given is an
object that the call fills: a struct, a handle, or a number as ctypes.c_size_t(). A text is str or bytes, in a struct bytes. Whole
numbers that are too large for their type in C are truncated, as everywhere in ctypes.

A status below 0 is raised as sins.Error, with the faults of a scene in `faults`. Other statuses are returned. If the outputs are left
out, sins.SCENE_HAS_FAULTS and sins.REQUIREMENT_NOT_MET are raised too, the latter with the outputs in `outputs`.

An array is one of ctypes, or of numpy: sins.array(sins.record, 1000). The library works in the memory of both, without copies. An
array that the library reads may also be a list of structs or numbers.

The library is the file that SINS_LIBRARY in the environment names, or else the one in the folder of this file, or the system's.

This file is written by build/ from the Rust sources; do not edit it.
"""

import ctypes
import enum
import functools
import os
import sys
from ctypes import POINTER, c_char, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64

# <constants>


def check_masks(name, value):
    """Rejects an array of numpy some of whose values are masked: the library would read what is behind the masks."""
    numpy = sys.modules.get("numpy")
    if numpy and isinstance(value, numpy.ma.MaskedArray):
        masked = numpy.ascontiguousarray(numpy.ma.getmaskarray(value)).view(bool).sum()
        if masked:
            raise ValueError(f"{name}: {masked} values are masked; fill them in, or leave their samples out")


def _load():
    """The library, of the version of the interface that this file is for."""
    beside = os.path.dirname(os.path.abspath(__file__))
    names = {"win32": ["sins.dll"], "darwin": ["libsins.dylib"]}
    names = names.get(sys.platform, [f"libsins.so.{HEADER_ABI}", "libsins.so"])
    found = [path for path in (os.path.join(beside, name) for name in names) if os.path.exists(path)]
    path = os.environ.get("SINS_LIBRARY") or (found + names)[0]
    try:
        library = ctypes.CDLL(path)
        version = library.sins_abi_version()
    except OSError as error:
        raise ImportError(
            f"the library sins cannot be loaded: {error}. Put {names[-1]} of {8 * ctypes.sizeof(ctypes.c_void_p)} bits, "
            f"as this Python has, beside {__file__}, or set SINS_LIBRARY to its path"
        ) from None
    except AttributeError:
        raise ImportError(f"{path} is not the library sins: it has no sins_abi_version()") from None
    if version != HEADER_ABI:
        raise ImportError(
            f"{path} has version {version} of the interface, {__file__} is for version {HEADER_ABI}: "
            "take both from one release"
        )
    return library


_library = _load()


class Error(Exception):
    """A call that failed: its status, the library's sentence, and in info what that is made of.

    faults: all faults of a scene whose text or whose change was rejected. outputs: the outputs of a call that did not fail, and whose
    status is not OK.
    """

    def __init__(self, status, sentence, info, faults=(), outputs=()):
        super().__init__(sentence)
        self.status = status_code(status)
        self.info = info
        self.faults = faults
        self.outputs = outputs

    def __reduce__(self):
        return type(self), (self.status, *self.args, self.info, self.faults, self.outputs), self.__dict__


def _exported(enumeration):
    """Makes sins.frame.FRAME_GEOGRAPHIC known as sins.FRAME_GEOGRAPHIC, as in C."""
    globals().update(enumeration.__members__)
    return enumeration


class _Struct(ctypes.Structure):
    """All zero but for the fields that are named, and struct_size, which is set."""

    __slots__ = ()  # a field that does not exist is an error

    def __init__(self, **fields):
        super().__init__(**fields)
        if hasattr(self, "struct_size"):
            self.struct_size = ctypes.sizeof(self)

    def __setattr__(self, name, value):
        given = value
        check_masks(f"{type(self).__name__}.{name}", value)
        if getattr(value, "ndim", 0):  # an array of numpy; a matrix row by row
            value = tuple(value.ravel())
        try:
            length = getattr(getattr(self, name), "_length_", None)  # of an array
            if length is not None and len(value) != length:
                raise TypeError(f"expected {length} elements, not {len(value)}")
            super().__setattr__(name, value)
        except (IndexError, RuntimeError, TypeError) as error:
            raise TypeError(f"{type(self).__name__}.{name} = {given!r}: {error}") from None

    def __reduce__(self):
        return type(self).from_buffer_copy, (bytes(self),)

    def __repr__(self):
        def shown(value):
            return list(value) if isinstance(value, ctypes.Array) else value

        fields = (f"{name}={shown(getattr(self, name))!r}" for name, _ in self._fields_)
        return f"sins.{type(self).__name__}({', '.join(fields)})"


class _Handle(ctypes.c_void_p):
    """Stands for nothing until a call creates it. Destroyed by close(), at the end of a with statement, or when it is dropped; one that
    another object lends is not."""

    is_lent = False

    def close(self):
        if self and not self.is_lent:
            getattr(_library, self._destroy)(self)
            self.value = None

    __del__ = close

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __reduce_ex__(self, _):
        raise TypeError(f"a sins.{type(self).__name__} can be neither copied nor pickled: it stands for one object of the library")


# <types>


class _Text(ctypes.c_char_p):
    """An argument that is a text: str or bytes."""

    @classmethod
    def from_param(cls, value):
        value = value.encode() if isinstance(value, str) else value
        if isinstance(value, bytes) and b"\0" in value:
            raise ValueError(f"{value!r}: a text has no zero byte")
        return super().from_param(value)


class _Out:
    """An argument that the call fills: a number or a struct."""

    def __init__(self, kind):
        self.kind = kind
        self.pointer = POINTER(kind)

    def from_param(self, value):
        return self.pointer.from_param(value)

    def make(self):
        return self.kind()

    def result(self, made):
        return made if isinstance(made, ctypes.Structure) else made.value


class _New(_Out):
    """An argument that is a handle which stands for nothing yet."""

    def result(self, made):
        return made

    def from_param(self, value):
        if value:
            raise ValueError("the handle stands for something already: close() it first")
        return self.pointer.from_param(value)


class _Lent(_New):
    """An argument that is a handle which belongs to another object: it is not destroyed here."""

    def make(self):
        made = self.kind()
        made.is_lent = True
        return made


class _MayBeNone:
    """An argument that may be None: a struct or a handle. It may be left out if only outputs follow."""

    def __init__(self, kind):
        self.pointer = kind
        self.from_param = kind.from_param

    def make(self):
        return None


class _Array:
    """Two arguments: a pointer to elements, and their number."""

    def __init__(self, element, is_input=False):
        self.element = element
        self.is_input = is_input
        self.is_bytes = is_input and element is c_char
        self.types = (ctypes.c_char_p if self.is_bytes else POINTER(element), c_size_t)

    def __call__(self, value):
        if value is None:
            return None, 0
        if isinstance(value, self.element):
            return value, 1
        if self.is_input and isinstance(value, (list, tuple)):
            if issubclass(self.element, _Struct) and not all(isinstance(one, self.element) for one in value):
                raise TypeError(f"not a list of sins.{self.element.__name__}")
            return (self.element * len(value))(*value), len(value)
        if self.is_bytes:
            value = value.encode() if isinstance(value, str) else bytes(memoryview(value))
        elif isinstance(value, (str, bytes)):
            raise TypeError("a buffer to write into: make it by ctypes.create_string_buffer(size)")
        elif hasattr(value, "dtype"):  # of numpy
            check_masks(f"array of sins.{self.element.__name__}", value)
            if value.dtype != _dtype(self.element):
                raise TypeError("not an array as sins.array(sins.{0}, count) makes it".format(self.element.__name__))
            value = (self.element * value.size).from_buffer(value)
        return value, len(value)


@functools.lru_cache(maxsize=None)
def _dtype(struct):
    import numpy  # needed for arrays of numpy alone

    return numpy.dtype(struct)


def _fail(status, sim, scene=None):
    """Raises what the library says of the last call: of a simulator, or of this thread; and of a change of a scene, its first fault."""
    sentence, info = ctypes.create_string_buffer(1024), error_info()
    _library.sins_last_error_info(sim, ctypes.byref(info))
    if info.status == status:
        _library.sins_last_error(sim, sentence, c_size_t(ctypes.sizeof(sentence)), None)
        text = sentence.value.decode(errors="replace")
        if scene and "sins_scene_get_fault" in text:
            _fail_of_faults(status, scene, info)
        raise Error(status, text, info)
    # A call whose handle was rejected keeps no sentence.
    raise Error(status, status_string(status), error_info(status=status))


def _fail_of_faults(status, scene, info):
    """Raises the first fault of a scene, with all of them."""
    faults = []
    try:
        while True:
            faults.append(scene_get_fault(scene, len(faults)))
    except Error:
        pass  # there are no more
    first, more = faults[0], len(faults) - 1
    more = f" (and {more} more: see faults)" if more else ""
    raise Error(status, f"line {first.line}, column {first.column}: {first.sentence.decode()}{more}", info, faults)


def _make(described, kinds, given):
    """What stands for the arguments behind the first `given` that were left out: outputs, and None where that is allowed."""
    for name, kind in list(zip(described.__code__.co_varnames, kinds))[given:]:
        if not isinstance(kind, (_Out, _MayBeNone)):
            raise TypeError(f"{described.__name__}(): missing argument: {name}")
    return [kind.make() for kind in kinds[given:]]


def _found(status, outputs, made):
    """What is returned for outputs that were left out."""
    found = tuple(kind.result(one) for kind, one in zip(outputs, made) if isinstance(kind, _Out))
    if status == status_code.SCENE_HAS_FAULTS:
        _fail_of_faults(status, found[0], error_info(status=status))
    if status == status_code.REQUIREMENT_NOT_MET:
        sentence = "no options meet the requirement; the outputs of this error are the options that come closest"
        raise Error(status, sentence, error_info(status=status), outputs=found)
    return None if status == status_code.NEED_SAMPLE else found[0] if len(found) == 1 else found


def _function(result, *kinds):
    """The function of the library that has the name of the one below; it takes the arguments, and what is below documents them."""

    def declare(described):
        name = "sins_" + described.__name__
        foreign = getattr(_library, name, None)
        if foreign is None:
            def missing(*_):
                raise NotImplementedError(f"the library has no {name}(): it is older, or built without the feature scenes")

            return functools.wraps(described)(missing)

        first = described.__code__.co_varnames[:1]
        is_text = kinds[-2:-1] and isinstance(kinds[-2], _Array) and described.__code__.co_varnames[-1] == "needed"
        foreign.restype = result
        foreign.argtypes = [one for kind in kinds for one in (kind.types if isinstance(kind, _Array) else (kind,))]

        @functools.wraps(described)
        def call(*arguments):
            if len(arguments) > len(kinds):
                raise TypeError(f"{described.__name__}() takes {len(kinds)} arguments, {len(arguments)} were given")
            if is_text and len(arguments) == len(kinds) - 2:
                return _text(call, arguments)
            outputs = kinds[len(arguments):]
            made = _make(described, kinds, len(arguments))
            given = []
            for kind, value in zip(kinds, (*arguments, *made)):
                given += kind(value) if isinstance(kind, _Array) else (value,)
            answer = foreign(*given)
            if result is status and answer < 0:
                _fail(answer, *(arguments[0] if first == (name,) else None for name in ("sim", "scene")))
            if outputs:
                return _found(answer, outputs, made)
            return answer.decode() if isinstance(answer, bytes) else answer

        return call

    return declare


# <functions>


def _text(function, arguments):
    """The text that a function writes into a buffer."""
    buffer = ctypes.create_string_buffer(function(*arguments, None))
    function(*arguments, buffer)
    return buffer.value.decode()


def snapshot(sim):
    """The bytes that snapshot_save() writes."""
    buffer = ctypes.create_string_buffer(snapshot_size(sim))
    return buffer[: snapshot_save(sim, buffer)]


def array(struct, count):
    """An array of numpy, all zero and with each struct_size set. Its columns are the fields: samples["time_s"]."""
    import numpy

    made = numpy.zeros(count, _dtype(struct))
    made["struct_size"] = ctypes.sizeof(struct)
    return made


def samples_at(flight, times_s):
    """The samples of a flight at these times, as an array of numpy."""
    samples = array(flight_sample, len(times_s))
    each = (flight_sample * len(times_s)).from_buffer(samples)
    for time_s, sample in zip(times_s, each):
        flight_sample_at(flight, time_s, sample)
    return samples


def fly(sim, samples, every=1):
    """Flies an array of samples by run(); an array of the record of each `every` intervals."""
    records = array(record, len(samples) // every + 1 if every else 0)
    return records[: run(sim, samples, every, records)]
