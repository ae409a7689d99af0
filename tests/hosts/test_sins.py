"""sins.py compared with the header (names and types from a C parser), and its behaviour.

Needs SINS_LIBRARY, PYTHONPATH, pycparser and numpy: see tests/hosts.sh.
"""

import copy
import ctypes
import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
from sins import c as sins
from pycparser import CParser, c_ast

HEADER = pathlib.Path(__file__).resolve().parents[2] / "include/sins_functions.h"  # includes all others
DECLARATIONS = "".join(
    (HEADER.parent / f"{name}.h").read_text()
    for name in ("sins", "sins_flight", "sins_analysis", "sins_unit", "sins_ensemble", "sins_scene")
)
COMPILER = os.environ.get("CC", "cc")
# Words of the system's headers that pycparser does not know; sins.h does not use them.
GNU = ["__attribute__(x)", "__asm__(x)", "__extension__", "__restrict"]


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


# The ways to copy an object.
COPIES = [copy.copy, copy.deepcopy,
          *(lambda made, protocol=protocol: pickle.loads(pickle.dumps(made, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1))]


def classes(base):
    """The classes of the module that are made of another one."""
    return [one for one in vars(sins).values() if isinstance(one, type) and issubclass(one, base) and one is not base]


def plain(name):
    return name[len("sins_"):]


NUMBERS = {"double": "f8", "int32_t": "i4", "uint32_t": "u4", "int64_t": "i8", "uint64_t": "u8",
           "size_t": f"u{ctypes.sizeof(ctypes.c_size_t)}", "sins_status": "i4", "void": "char"}


def of_header(kind):
    """A type of the header as a word. void counts as bytes, like char."""
    if isinstance(kind, c_ast.PtrDecl):
        return of_header(kind.type) + "*"
    if isinstance(kind, c_ast.ArrayDecl):
        return f"{of_header(kind.type)}[{kind.dim.value}]"
    name = kind.type.name if isinstance(kind.type, c_ast.Struct) else kind.type.names[-1]
    return NUMBERS.get(name, name)


def of_module(kind):
    """A type of ctypes as a word of the same form."""
    if isinstance(kind, (sins._Out, sins._MayBeNone)):
        return of_module(kind.pointer)
    if issubclass(kind, ctypes.Array):
        return f"{of_module(kind._type_)}[{kind._length_}]"
    if issubclass(kind, sins._Handle):
        return f"sins_{kind.__name__}*"
    if issubclass(kind, ctypes.Structure):
        return f"sins_{kind.__name__}"
    if issubclass(kind, ctypes.c_char_p):
        return "char*"
    if issubclass(kind, ctypes.c_char):
        return "char"
    if issubclass(kind, ctypes._Pointer):
        return of_module(kind._type_) + "*"
    sign = "f" if kind is ctypes.c_double else "i" if kind(-1).value < 0 else "u"
    return f"{sign}{ctypes.sizeof(kind)}"


class Header(unittest.TestCase):
    """The module has everything that an independent parser finds in the header."""

    @classmethod
    def setUpClass(cls):
        without = [f"-D{word}=" for word in GNU]
        text = run(COMPILER, "-std=c99", "-E", "-P", *without, HEADER)
        cls.structs, cls.functions = {}, {}
        for item in CParser().parse(text, str(HEADER)).ext:
            kind = getattr(item, "type", None)
            if isinstance(kind, c_ast.FuncDecl) and item.name.startswith("sins_"):
                cls.functions[item.name] = kind
            inner = getattr(kind, "type", kind) if isinstance(item, c_ast.Typedef) else kind
            if isinstance(inner, c_ast.Struct) and inner.decls and inner.name and inner.name.startswith("sins_"):
                cls.structs[inner.name] = inner.decls

    def test_the_parser_found_all(self):
        declared = re.findall(r"SINS_CALL (sins_\w+)\(", DECLARATIONS)
        self.assertGreater(len(declared), 80)
        self.assertEqual(sorted(declared), sorted(self.functions))
        sizes = re.findall(r"    SINS_SIZEOF_\w+ = ", DECLARATIONS)
        self.assertEqual(len(sizes), len(self.structs))

    def test_fields(self):
        for name, fields in self.structs.items():
            reported = [(field, of_module(kind)) for field, kind in getattr(sins, plain(name))._fields_]
            self.assertEqual(reported, [(field.name, of_header(field.type)) for field in fields], name)

    def test_functions(self):
        for name, declaration in self.functions.items():
            documented, foreign = getattr(sins, plain(name)), getattr(sins._library, name)
            self.assertTrue(documented.__doc__, name)
            self.assertEqual(of_module(foreign.restype), of_header(declaration.type), name)
            arguments = [of_header(one.type) for one in declaration.args.params]
            reported = [of_module(kind) for kind in foreign.argtypes] or ["char"]  # (void)
            self.assertEqual(reported, arguments, name)


class Calls(unittest.TestCase):
    def setUp(self):
        self.samples = sins.array(sins.flight_sample, 101)
        self.samples["time_s"] = numpy.arange(101)
        self.samples["latitude_rad"] = 39.9 * sins.DEG
        self.sim = sins.sim()
        sins.create(None, self.sim)
        sins.set_gyro(self.sim, sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0)))

    def test_arrays_of_numpy_are_the_memory_that_the_library_reads_and_writes(self):
        records = sins.array(sins.record, 20)
        column, written = records["navigation_errors"]["position_enu_m"], ctypes.c_size_t()
        sins.run(self.sim, self.samples, 10, records, written)
        self.assertEqual(written.value, 10)
        self.assertTrue(column[:10].all() and not column[10:].any())
        by_steps, last = sins.sim(), sins.record()
        sins.create(None, by_steps)
        sins.set_gyro(by_steps, sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0)))
        for sample in (sins.flight_sample * 101).from_buffer(self.samples):
            sins.push_sample(by_steps, sample)
            sins.step(by_steps)
        sins.get_record(by_steps, last)
        self.assertEqual(bytes(last), records[9].tobytes())
        sins.reset(self.sim)
        self.assertEqual(sins.fly(self.sim, self.samples, 10).tobytes(), records[:10].tobytes())
        sins.reset(self.sim)
        self.assertEqual(len(sins.fly(self.sim, self.samples, 0)), 0)

    def test_outputs_that_are_left_out_are_returned(self):
        self.assertIsNone(sins.get_navigation(self.sim), "there is none yet")
        self.assertEqual(sins.get_errors(self.sim, sins.ERRORS_NAVIGATION), None)
        records = sins.array(sins.record, 11)
        self.assertEqual(sins.run(self.sim, self.samples, 10, records), 10)
        errors = sins.errors()
        self.assertEqual(sins.get_errors(self.sim, sins.ERRORS_NAVIGATION, errors), sins.OK)
        self.assertEqual(bytes(sins.get_errors(self.sim, sins.ERRORS_NAVIGATION)), bytes(errors))
        with sins.ensemble_create(sins.create(None), 5, 7) as ensemble:
            self.assertEqual(sins.ensemble_get_runs(ensemble), (5, 7))
        requirement = sins.requirement(position_m=10)
        options, cost = sins.recommend(self.sim, self.samples, requirement)
        self.assertGreater(options.subsamples * cost.tried, 0)
        self.assertEqual(sins.scene_get_failure_count(sins.scene_create_builtin("patrol")), 0)
        self.assertEqual(sins.scene_builtin_name(0), sins._text(sins.scene_builtin_name, (0,)))
        self.assertEqual(sins.last_error(self.sim), "no error")
        self.assertRaisesRegex(TypeError, r"get_errors\(\): missing argument: source", sins.get_errors, self.sim)
        self.assertRaisesRegex(sins.Error, "options.frame = 7", sins.create, sins.options(frame=7))

    def test_lists_are_arrays_that_the_library_reads(self):
        start = sins.flight_start(latitude_rad=0.7, speed_m_s=100)
        straight = sins.manoeuvre(kind=sins.MANOEUVRE_STRAIGHT, duration_s=5)
        roll = sins.manoeuvre(kind=sins.MANOEUVRE_ROLL, duration_s=10, turns=1)
        self.assertEqual(sins.flight_duration(sins.flight_create(start, [straight, roll, straight])), 20)
        self.assertRaises(TypeError, sins.flight_create, start, [straight, start])
        samples = [sins.flight_sample(time_s=second, latitude_rad=0.7) for second in range(3)]
        self.assertEqual(sins.run(self.sim, samples, 0, None), 0)
        self.assertEqual(sins.get_truth(self.sim).time_s, 2)

    def test_a_wrong_array_does_not_reach_the_library(self):
        short, written = sins.array(sins.record, 3), ctypes.c_size_t()
        for samples in (self.samples[::2], short, self.samples.tolist(), numpy.zeros(144, "u1")):
            self.assertRaises((TypeError, ctypes.ArgumentError), sins.run, self.sim, samples, 1, None, None)
        with self.assertRaises(sins.Error) as caught:
            sins.run(self.sim, self.samples, 10, short, written)
        self.assertEqual(caught.exception.status, sins.ERROR_BUFFER_TOO_SMALL)
        self.assertRaises(TypeError, sins.run, self.sim, self.samples, 10)
        self.assertRaises(TypeError, sins.run, self.sim, self.samples, 10, short, written, 1)
        self.assertRaises((TypeError, ctypes.ArgumentError), sins.run, self.sim, self.samples, 10, [sins.record()] * 20, None)
        self.assertRaises(TypeError, sins.snapshot_save, self.sim, bytes(sins.SNAPSHOT_MAX_SIZE), None)

    def test_fields_of_structs(self):
        matrix = numpy.arange(9.0).reshape(3, 3)
        self.assertEqual(sins.gyro_params(misalignment_rad=matrix).misalignment_rad[3], matrix[1, 0])
        self.assertEqual(sins.gyro_params(reference_temperature_c=matrix[0, 2]).reference_temperature_c, 2)
        with self.assertRaisesRegex(TypeError, r"gyro_params.bias_rad_s = \(1, 2, 3, 4\)"):
            sins.gyro_params(bias_rad_s=(1, 2, 3, 4))
        self.assertRaises(AttributeError, sins.gyro_params, bais_rad_s=(0, 0, 0))

    def test_an_array_in_a_struct_gets_all_its_elements(self):
        """Of every array of every struct; fewer would leave the others 0 without a word."""
        checked = 0
        for struct in classes(sins._Struct):
            for name, kind in struct._fields_:
                if not issubclass(kind, ctypes.Array) or kind._type_ is ctypes.c_char:
                    continue
                elements = [kind._type_()] * kind._length_
                self.assertEqual(len(getattr(struct(**{name: tuple(elements)}), name)), kind._length_)
                for wrong in (elements[1:], elements + elements[:1], (), 0.0):
                    with self.assertRaisesRegex(TypeError, rf"^{struct.__name__}\.{name} = "):
                        struct(**{name: tuple(wrong) if isinstance(wrong, list) else wrong})
                checked += 1
        self.assertGreater(checked, 100)

    def test_masked_values_do_not_reach_the_library(self):
        masked = numpy.ma.array([1.0, 2.0, 3.0], mask=[False, True, False])
        with self.assertRaisesRegex(ValueError, "gyro_params.bias_rad_s: 1 values are masked"):
            sins.gyro_params(bias_rad_s=masked)
        self.assertEqual(sins.gyro_params(bias_rad_s=numpy.ma.array([1.0, 2.0, 3.0])).bias_rad_s[1], 2)
        samples = numpy.ma.array(self.samples)
        sins.run(self.sim, samples, 0, None)
        samples["height_m"][3] = numpy.ma.masked
        with self.assertRaisesRegex(ValueError, "array of sins.flight_sample: 1 values are masked"):
            sins.log_create(samples)

    def test_copies(self):
        """A handle has no copy: it would destroy what the other stands for. A struct is copied."""
        for handle in classes(sins._Handle):
            for made in (handle(), handle(12345)):
                made.is_lent = True  # 12345 is not destroyed
                for copies in COPIES:
                    with self.assertRaisesRegex(TypeError, f"a sins.{handle.__name__} can be neither copied nor pickled"):
                        copies(made)
                    with self.assertRaisesRegex(TypeError, f"a sins.{handle.__name__} can be neither copied nor pickled"):
                        copies([{"in": made}]) if copies is not copy.copy else copies(made)
        for struct in classes(sins._Struct):
            made = struct.from_buffer_copy(bytes(range(256)) * (ctypes.sizeof(struct) // 256 + 1))
            for copies in COPIES:
                other = copies(made)
                self.assertIs(type(other), struct)
                self.assertEqual(bytes(other), bytes(made))
                ctypes.memset(ctypes.addressof(other), 0, 4)
                self.assertNotEqual(bytes(other), bytes(made), "it has the same memory")

    def test_an_error_is_pickled_as_it_is(self):
        faulty = '[flight]\nbuiltin = "rest"\n[gyro]\nbais_deg_h = 1\nbias_deg_h = "x"\n'
        for call in (lambda: sins.scene_parse(faulty), lambda: sins.step(sins.sim()),
                     lambda: sins.recommend(self.sim, self.samples, sins.requirement(position_m=1e-12))):
            with self.assertRaises(sins.Error) as caught:
                call()
            error = caught.exception
            error.args = (f"new words: {error}",)
            error.note = 3
            for copies in COPIES:
                other = copies(error)
                self.assertEqual((type(other), str(other), other.status, other.note), (type(error), str(error), error.status, 3))
                self.assertEqual(bytes(other.info), bytes(error.info))
                for of_other, of_error in ((other.faults, error.faults), (other.outputs, error.outputs)):
                    self.assertEqual(list(map(bytes, of_other)), list(map(bytes, of_error)))

    def test_an_error_has_the_sentence_and_its_parts(self):
        with self.assertRaises(sins.Error) as caught:
            sins.set_gyro(self.sim, sins.gyro_params(bias_rad_s=(0, 1e9, 0)))
        error = caught.exception
        self.assertEqual(str(error), "gyro.bias_rad_s[1] = 1e9: must be from -100 to 100")
        self.assertEqual((error.status, error.info.index, error.info.maximum), (sins.ERROR_INVALID_ARGUMENT, 1, 100))
        # Errors of the thread, not of a simulator.
        with self.assertRaisesRegex(sins.Error, "options.frame = 7"):
            sins.create(sins.options(frame=7), sins.sim())
        with self.assertRaisesRegex(sins.Error, "SINS_ERROR_BAD_HANDLE") as caught:
            sins.step(sins.sim())
        self.assertEqual((caught.exception.info.status, caught.exception.info.field), (sins.ERROR_BAD_HANDLE, b""))
        with self.assertRaisesRegex(sins.Error, "requirement"):
            sins.recommend(self.sim, self.samples, sins.requirement(), sins.options(), sins.cost())
        self.assertRaises(ctypes.ArgumentError, sins.step, sins.flight())

    def test_handles_are_destroyed(self):
        with sins.sim() as sim:
            sins.create(None, sim)
            key = sim.value
        self.assertFalse(sim)
        with self.assertRaises(sins.Error) as caught:
            sins.reset(sins.sim(key))
        self.assertEqual(caught.exception.status, sins.ERROR_BAD_HANDLE)
        for _ in range(5000):  # more than can exist at once
            sins.create(None, sins.sim())

    def test_texts(self):
        scene, fault = sins.scene(), sins.fault()
        sins.scene_create_builtin("patrol", scene)
        self.assertRaises(ctypes.ArgumentError, sins.scene_create_builtin, "patrol", scene)
        text = sins.scene_write(scene)
        scene.close()
        self.assertEqual(sins.scene_parse(text, scene), sins.OK)
        self.assertEqual(sins.scene_write(scene), text)
        scene.close()
        faulty = '[flight]\nbuiltin = "rest"\n[gyro]\nbais_deg_h = 1\n'
        self.assertEqual(sins.scene_parse(faulty, scene), sins.SCENE_HAS_FAULTS)
        sins.scene_get_fault(scene, 0, fault)
        self.assertEqual(fault.line, 4)
        self.assertRaises(ctypes.ArgumentError, sins.scene_create_builtin, "patrol\0", sins.scene())

    def test_a_faulty_scene_is_raised(self):
        faulty = '[flight]\nbuiltin = "rest"\n[gyro]\nbais_deg_h = 1\nbias_deg_h = "x"\n'
        with self.assertRaises(sins.Error) as caught:
            sins.scene_parse(faulty)
        error = caught.exception
        self.assertEqual(str(error), "line 4, column 1: no such key: bais_deg_h; did you mean bias_deg_h? (and 1 more: see faults)")
        self.assertEqual((error.status, [fault.line for fault in error.faults]), (sins.SCENE_HAS_FAULTS, [4, 5]))
        scene = sins.scene_parse(faulty.split("[gyro]")[0])
        for change, line in (("gyro.bais_deg_h = 1", 1), ("gyro.bias_deg_h = 1\n\nflight.hours = 1e9", 3)):
            with self.assertRaisesRegex(sins.Error, f"^line {line}, column 1: ") as caught:
                sins.scene_set_values(scene, change)
            self.assertEqual((caught.exception.status, len(caught.exception.faults)), (sins.ERROR_INVALID_ARGUMENT, 1))
        # The faults of a change are not those of a later call.
        with self.assertRaisesRegex(sins.Error, "^index = 3: must be less than the number of failures") as caught:
            sins.scene_get_failure(scene, 3)
        self.assertEqual(caught.exception.faults, ())

    def test_inputs_that_may_be_none_may_be_left_out(self):
        with sins.create() as sim, sins.create(None) as other:
            self.assertEqual(bytes(sins.get_gyro(sim)), bytes(sins.get_gyro(other)))
        with self.assertRaisesRegex(TypeError, r"unit_create\(\): missing argument: mode"):
            sins.unit_create()

    def test_a_requirement_that_is_not_met_is_raised(self):
        with self.assertRaises(sins.Error) as caught:
            sins.recommend(self.sim, self.samples, sins.requirement(position_m=1e-12))
        options, cost = caught.exception.outputs
        self.assertEqual(caught.exception.status, sins.REQUIREMENT_NOT_MET)
        self.assertGreater(cost.share, 1)
        self.assertIn(options.subsamples, range(1, 9))

    def test_a_snapshot_goes_on(self):
        sins.fly(self.sim, self.samples[:50])
        copy = sins.create(None)
        sins.snapshot_load(copy, bytearray(sins.snapshot(self.sim)))
        ends = [sins.fly(sim, self.samples[50:]).tobytes() for sim in (self.sim, copy)]
        self.assertEqual(*ends)


class Play(unittest.TestCase):
    def test_handles_that_are_lent_stay(self):
        with sins.scene_create_builtin("patrol") as scene:
            sins.scene_set_values(scene, 'flight.hours = 0.01\nunit.start = "nav"')
            play = sins.play_create(scene, None)
        self.assertEqual((sins.play_next(play), sins.play_next(play)), (sins.OK, sins.OK))
        for read in (sins.play_get_simulator, sins.play_get_unit):
            lent = read(play)
            lent.close()
            del lent
        with sins.play_get_simulator(play) as sim:
            self.assertEqual(sins.get_record(sim).time_s, 0.01)
        status, shown = sins.play_get_shown(play)
        self.assertEqual((status.state, shown.time_s), (sins.UNIT_STATE_NAVIGATION, 0.01))
        records = sins.array(sins.record, 5000)
        count = sins.play_run(play, records)
        self.assertEqual((records["time_s"][count - 1], sins.play_next(play)), (36.0, sins.PLAY_END))


class Loading(unittest.TestCase):
    """The messages of an import with an unusable library."""

    def imported(self, library, then=""):
        environment = {**os.environ, "SINS_LIBRARY": str(library)}
        done = subprocess.run([sys.executable, "-c", f"from sins import c as sins; {then}"], env=environment, capture_output=True, text=True)
        return done.stderr.strip().splitlines()[-1] if done.returncode else ""

    def stub(self, version):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source, library = pathlib.Path(folder.name) / "stub.c", pathlib.Path(folder.name) / "stub.so"
        source.write_text(f"unsigned sins_abi_version(void) {{ return {version}; }}\n")
        run(COMPILER, "-shared", "-fPIC", source, "-o", library)
        return library

    def test_messages(self):
        self.assertEqual(self.imported(sins._library._name), "")
        self.assertRegex(self.imported("/none/libsins.so"), "ImportError: .*/none/libsins.so.*SINS_LIBRARY")
        self.assertRegex(self.imported(__file__), "ImportError: .*cannot be loaded: .*test_sins.py")
        self.assertRegex(self.imported("libc.so.6"), "ImportError: libc.so.6 is not the library sins")
        self.assertRegex(self.imported(self.stub(7)), "ImportError: .* version 7 of the interface, .* version 1")

    def test_a_library_that_lacks_functions(self):
        library = self.stub(sins.HEADER_ABI)
        self.assertEqual(self.imported(library), "")
        self.assertRegex(self.imported(library, "sins.scene_create(sins.scene())"), "no sins_scene_create")


if __name__ == "__main__":
    unittest.main()
