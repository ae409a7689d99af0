"""The package sins for Python: its flights, ensembles and increments have the bits of the program's, and what is wrong is told.

Needs SINS_LIBRARY, PYTHONPATH, numpy, pandas and matplotlib, and the program sins as the first argument: see tests/hosts.sh.
"""

import copy
import doctest
import io
import json
import os
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from concurrent.futures import ProcessPoolExecutor
from unittest import mock

import numpy as np
import pandas
import sins
from sins import c

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCENES = PROJECT / "c_examples/scenes"
PROGRAM = sys.argv.pop(1)
GRADE = {"gyro": "navigation", "accel": "navigation", "start": "navigation"}
DAY = (SCENES / "day.toml").read_text()
NOISE = {"gyro": {"random_walk_deg_sqrt_h": 0.05}, "accel": {"random_walk_micro_g_sqrt_hz": 50}}
# All that takes settings.
FLIES = [sins.fly, sins.Flight, sins.ensemble, sins.budget, lambda *flown, **settings: sins.recommend(*flown, position_m=1, **settings)]
LONG = {"hours": 20, "options": {"scheme": "polynomial", "subsamples": 5, "updates_per_sample": 16}}
CORRECTIONS = ["position_enu_m", "velocity_enu_m_s", "misalignment_enu_rad", "gyro_bias_rad_s", "gyro_scale_factor", "accel_bias_m_s2",
               "accel_scale_factor"]


def program(*arguments):
    """The records that the program writes."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, "fly", *arguments, "--quiet", "--out", folder, "--name", "flight"], check=True, cwd=PROJECT)
        return pandas.read_csv(f"{folder}/flight.csv", comment="#", float_precision="round_trip")


def log(name):
    return pandas.read_csv(PROJECT / "c_examples/flights" / name, comment="#", float_precision="round_trip")


class Flights(unittest.TestCase):
    def same(self, run, expected):
        found = run.dataframe()
        shared = [name for name in expected if name in found]
        self.assertGreater(len(shared), 20, list(expected))
        pandas.testing.assert_frame_equal(found[shared], expected[shared].astype(float), check_exact=True)

    def test_a_title_is_that_of_what_flies(self):
        titled, hour = "simulation2", {"hours": 0.02}
        for added in ({}, {"options": {"subsamples": 3}}, {"hours": 0.01, "gyro": "tactical"}):
            self.assertEqual(sins.fly("aerobatics", **added).title, "Loops, rolls, S-turns, climbs, turns at 70 degrees of bank")
        self.assertEqual(sins.fly("aerobatics", flight={"speed_m_s": 190}).title, "aerobatics")
        self.assertNotIn("0.01", sins.fly(titled, **hour, gyro={"bias_deg_h": 5}).title)
        self.assertEqual(sins.fly(titled, **hour, flight={"title": "Mine"}).title, "Mine")
        rest = "[flight]\nbuiltin = 'rest'\nhours = 0.7\nrate_hz = 50\ntitle = '747 at rest, 50 Hz'\n"
        for flight, title in (({"hours": 0.01}, "747 at rest, 50 Hz"), ({"rate_hz": 10}, "rest")):
            self.assertEqual(sins.fly(rest, flight=flight).title, title)

    def test_flies_as_the_program(self):
        settings = {"gyro": {"preset": "tactical", "bias_deg_h": [1, 2, 3]}, "options": {"seed": 7, "error_model": "rk4"}}
        sets = ["gyro.preset=tactical", "gyro.bias_deg_h=[1,2,3]", "options.seed=7", "options.error_model=rk4"]
        self.same(sins.fly("patrol", hours=0.2, every_s=1, **settings),
                  program("patrol", "--hours", "0.2", "--set", "output.every_s=1", *(word for one in sets for word in ("--set", one))))
        for scene in sorted(SCENES.glob("*.toml")):
            with self.subTest(scene.name), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of large errors
                hours = 1 if scene.name == "patrol.toml" else None
                run = sins.fly(scene, hours)
                self.same(run, program(str(scene), *(["--hours", "1"] if hours else [])))
                self.assertEqual(len(run.position_error_m), len(run))

    def test_a_flight_record_flies_as_by_the_program(self):
        point = '<trkpt lat="{}" lon="{}"><ele>{}</ele><time>2026-07-25T12:{:02}:{:02}Z</time></trkpt>'
        points = "".join(point.format(48 + 1e-4 * k, 11 + 1e-6 * k * k, 500 + k, k // 60, k % 60) for k in range(120))
        with tempfile.TemporaryDirectory() as folder:
            record = pathlib.Path(folder) / "track.gpx"
            record.write_text(f'<gpx version="1.1"><trk><trkseg>{points}</trkseg></trk></gpx>')
            run = sins.fly(record, gyro="tactical", every_s=1)
            self.same(run, program(str(record), "--set", "gyro.preset=tactical", "--set", "output.every_s=1"))

    def test_files_beside_the_log_are_joined(self):
        """Flies as the table that has all columns."""
        rows = [[0.1 * k, 48, 11 + 1e-6 * k, 500, 1, 2, 90] for k in range(50)]
        quantities = ("time", "latitude", "longitude", "height", "roll", "pitch", "heading")
        with tempfile.TemporaryDirectory() as folder:
            for name, columns in {"POS": (0, 1, 2, 3), "ATT": (0, 4, 5, 6), "ALL": range(7)}.items():
                lines = [",".join(quantities[place] for place in columns)] + [",".join(str(row[place]) for place in columns) for row in rows]
                (pathlib.Path(folder) / f"{name}.csv").write_text("\n".join(lines) + "\n")
            runs = []
            for name, part in (("POS", ', file = "ATT.csv"'), ("ALL", "")):
                keys = [f'{key} = {{ col = "{key}"{part if place > 3 else ""} }}\n' for place, key in enumerate(quantities)]
                scene = pathlib.Path(folder) / f"{name}.toml"
                scene.write_text(f'[flight]\nfile = "{name}.csv"\n[log]\n{"".join(keys)}')
                runs.append(sins.fly(scene, every_s=1, **GRADE))
            self.assertTrue((runs[0].records == runs[1].records).all())
            beside = pathlib.Path(folder) / "ATT.csv"
            beside.unlink()
            self.assertRaisesRegex(FileNotFoundError, "ATT.csv", lambda: sins.fly(pathlib.Path(folder) / "POS.toml"))
            # Nothing but a plain file in the folder of the log is read.
            beside.mkdir()
            self.assertRaisesRegex(ValueError, "ATT.csv: is no plain file", lambda: sins.fly(pathlib.Path(folder) / "POS.toml"))
            beside.rmdir()
            if os.name == "posix":
                beside.symlink_to(PROJECT / "README.md")
                self.assertRaisesRegex(ValueError, "ATT.csv: is a link to another folder", lambda: sins.fly(pathlib.Path(folder) / "POS.toml"))
                beside.unlink()
                beside.symlink_to("ALL.csv")
                self.assertTrue((sins.fly(pathlib.Path(folder) / "POS.toml", every_s=1, **GRADE).records == runs[0].records).all())

    def test_a_trajectory_flies_as_the_log(self):
        flown = PROJECT / "c_examples/flights/fighter_aerobatics.csv"
        frame = log(flown.name)
        expected = sins.fly(flown, every_s=1, **GRADE).records
        self.assertTrue((sins.fly(sins.trajectory(frame), every_s=1, **GRADE).records == expected).all())
        renamed = sins.trajectory({f"my {name}": frame[name] for name in frame}, **{name: f"my {name}" for name in frame})
        self.assertTrue((sins.fly(renamed, every_s=1, **GRADE).records == expected).all())
        arrays = sins.trajectory(**{name: frame[name].to_numpy() for name in frame})
        self.assertTrue((sins.fly(arrays, every_s=1, **GRADE).records == expected).all())
        structured = sins.trajectory(frame.to_records(index=False))
        self.assertTrue((structured.samples == arrays.samples).all())

    def test_quantities_of_a_trajectory(self):
        """Degrees, numbers for all samples, rates, forces and temperature come to their fields."""
        times = np.arange(3.0)
        made = sins.trajectory(time_s=times, latitude_deg=[10, 20, 30], longitude_rad=0.5, height_m=1, roll_deg=4, pitch_deg=5,
                               heading_deg=[350, 0, 10], rate_x_rad_s=times, rate_y_rad_s=1, rate_z_rad_s=2, force_x_m_s2=3,
                               force_y_m_s2=4, force_z_m_s2=times, temperature_c=-40, judge="off").samples
        np.testing.assert_array_equal(np.rad2deg(made["latitude_rad"]).round(12), [10, 20, 30])
        np.testing.assert_array_equal(made["longitude_rad"], 0.5)
        np.testing.assert_array_equal(made["angular_rate_rad_s"], [[0, 1, 2], [1, 1, 2], [2, 1, 2]])
        np.testing.assert_array_equal(made["specific_force_m_s2"], [[3, 4, 0], [3, 4, 1], [3, 4, 2]])
        np.testing.assert_array_equal(made["temperature_c"], -40)
        self.assertEqual(set(made["flags"]), {c.SAMPLE_NO_VELOCITY | c.SAMPLE_ANGULAR_RATE | c.SAMPLE_SPECIFIC_FORCE | c.SAMPLE_TEMPERATURE})

    def test_a_matrix_is_taken_by_its_rows(self):
        """Nine numbers, three rows, an array."""
        nine = [0, 1, 2, 3, 0, 5, 6, 7, 0]
        rows = [nine[row : row + 3] for row in (0, 3, 6)]
        flown = [sins.fly("racetrack", hours=0.01, gyro={"misalignment_arcsec": value}) for value in (nine, rows, np.array(rows))]
        for run in flown[1:]:
            self.assertTrue((run.records == flown[0].records).all())
        with self.assertRaisesRegex(sins.Error, "gyro.misalignment_arcsec"):
            sins.fly("racetrack", hours=0.01, gyro={"misalignment_arcsec": rows[:2]})

    def test_times_are_dates_or_lengths_of_time_too(self):
        """With and without a zone, over the end of summer time, as columns and as the index of a table."""
        columns = {"latitude_deg": 48, "longitude_deg": 11, "height_m": 1.0, "roll_rad": 0, "pitch_rad": 0, "heading_rad": 0}
        dates = pandas.date_range("2026-10-25 00:59:50", periods=200, freq="100ms", tz="UTC")
        local = dates.tz_convert("Europe/Berlin")
        lengths = pandas.timedelta_range("5s", periods=200, freq="100ms")
        for times, first in [(dates, 0), (local, 0), (pandas.Series(local), 0), (dates.tz_localize(None), 0),
                             (dates.tz_localize(None).to_numpy().astype("datetime64[us]"), 0), (lengths, 5), (lengths.to_numpy(), 5)]:
            with self.subTest(type(times), first=first):
                made = sins.trajectory(time_s=times, **columns)
                np.testing.assert_allclose(made.samples["time_s"], first + np.arange(200) / 10, atol=1e-9)
        frame = pandas.DataFrame({name: np.full(200, float(value)) for name, value in columns.items()}, index=local)
        np.testing.assert_allclose(sins.trajectory(frame).samples["time_s"], np.arange(200) / 10, atol=1e-9)
        with self.assertRaisesRegex(TypeError, "no time_s"):
            sins.trajectory(frame.reset_index(drop=True))

    def test_what_flies_is_judged(self):
        """Trajectories and logs: a warning at the line of the user, an error, or nothing; the findings are those of the program."""
        times = np.arange(0, 60, 0.1)
        north = {"time_s": times, "latitude_deg": 48 + np.rad2deg(100 * times / 6.37e6), "longitude_deg": 11, "height_m": 500,
                 "roll_deg": 0, "pitch_deg": 0, "heading_deg": 0, "velocity_east_m_s": 0, "velocity_up_m_s": 0}
        good, knots = {**north, "velocity_north_m_s": 100}, {**north, "velocity_north_m_s": 194.4}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertNotIn("unusable", {finding.level for finding in sins.trajectory(**good, judge="strict").findings})
            judged = sins.trajectory(**knots, judge="off")
        with self.assertWarnsRegex(sins.LogWarning, "^unusable: velocity is 1.94 times the displacement .knots") as warned:
            sins.trajectory(**knots)
        self.assertEqual(warned.filename, __file__)
        with self.assertRaisesRegex(ValueError, "^unusable: velocity is 1.94 times"):
            sins.trajectory(**knots, judge="strict")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "knots.csv"
            frame = pandas.DataFrame({name: np.broadcast_to(value, len(times)) for name, value in knots.items()})
            frame.to_csv(path, index=False)
            with self.assertWarnsRegex(sins.LogWarning, "knots") as warned:
                sins.fly(path)
            self.assertEqual(warned.filename, __file__)
            said = subprocess.run([PROGRAM, "log", path, "--json"], capture_output=True, check=False).stdout
        found = [one for one in json.loads(said)["findings"] if one["kind"]]
        self.assertEqual([(one["level"], one["kind"], one["sample"], one["figure"]) for one in found],
                         [(one.level, one.kind, one.sample, one.figure) for one in judged.findings])
        for one, other in zip(found, judged.findings):
            self.assertEqual(f"{one['sentence']}. Remedy: {one['remedy']}", other.sentence)
        radians = {**north, "latitude_deg": np.deg2rad(north["latitude_deg"]), "longitude_deg": np.deg2rad(11), "velocity_north_m_s": 100}
        with self.assertWarnsRegex(sins.LogWarning, "radians are latitude_rad"):
            sins.trajectory(**radians)

    def test_what_is_wrong_is_told(self):
        good = {"time_s": np.arange(3.0), "latitude_rad": 0.1, "longitude_rad": 0.2, "height_m": 1.0, "roll_rad": 0, "pitch_rad": 0,
                "heading_rad": 0}
        sins.trajectory(**good)
        lacking = {name: good[name] for name in good if name != "height_m"}
        for error, sentence, call in [
            (sins.Error, "bais_deg_h; did you mean bias_deg_h", lambda: sins.fly("patrol", gyro={"bais_deg_h": 1})),
            (sins.Error, r"range_deg_s\[0\] = -1: must be", lambda: sins.fly("patrol", gyro={"range_deg_s": -1})),
            (sins.Error, "no such section: giro; did you mean gyro", lambda: sins.fly("patrol", giro={"bias_deg_h": 1})),
            (sins.Error, r"'patrl': must be a built-in scene \(.*patrol.*\), or a file", lambda: sins.fly("patrl")),
            (ValueError, "seconds = -5: must be more than 0", lambda: sins.Flight("patrol", hours=0.01).fly(-5)),
            (FileNotFoundError, "none.toml", lambda: sins.fly("none.toml")),
            (FileNotFoundError, "none.csv", lambda: sins.fly("none.csv")),
            (TypeError, "expected a dict of keys", lambda: sins.fly("patrol", gyro=3)),
            (TypeError, "latitude_degree; did you mean latitude_deg", lambda: sins.trajectory(**good, latitude_degree=3)),
            (TypeError, "no height_m: name", lambda: sins.trajectory(**lacking)),
            (KeyError, "height_m: the data has no column 'h'", lambda: sins.trajectory({}, height_m="h", **lacking)),
            (TypeError, "height_m: not numbers", lambda: sins.trajectory(**lacking, height_m=["a", "b", "c"])),
            (ValueError, r"height_m has the shape \(2,\): expected \(3,\)", lambda: sins.trajectory(**lacking, height_m=[1, 2])),
            (TypeError, "no velocity_up_m_s", lambda: sins.trajectory(**good, velocity_east_m_s=1, velocity_north_m_s=1)),
            (TypeError, "give one of them", lambda: sins.trajectory({**good, "latitude_deg": good["time_s"]})),
            (sins.Error, r"height_m = NaN.*samples\[0\]", lambda: sins.trajectory(**lacking, height_m=float("nan"))),
            (sins.Error, r"later.*samples\[2\]", lambda: sins.trajectory(**{**good, "time_s": [0, 1, 1]})),
            (sins.Error, "count = 1", lambda: sins.trajectory(**{**good, "time_s": [0]})),
            (ValueError, r"time_s has the shape \(\)", lambda: sins.trajectory(**{**good, "time_s": 1.0})),
            (ValueError, "runs = 0: must be from 1 to", lambda: sins.ensemble("patrol", runs=0)),
            (ValueError, "times = 1: must be from 2 to", lambda: sins.ensemble("patrol", times=1, **GRADE)),
            (ValueError, "threads = 0: must be from 1 to", lambda: sins.ensemble("patrol", threads=0, **GRADE)),
            (TypeError, "runs = 2.5: must be a whole number", lambda: sins.ensemble("patrol", runs=2.5, **GRADE)),
            (ValueError, "runs = -1: must be from 0 to", lambda: sins.budget("patrol", hours=0.01, runs=-1, **GRADE)),
            (TypeError, "accelerometer.bias_micro_g is given twice",
             lambda: sins.fly("patrol", accel={"bias_micro_g": 1}, accelerometer={"bias_micro_g": 2})),
            (TypeError, "output.every_s is given twice", lambda: sins.fly("patrol", every_s=1, output={"every_s": 2})),
            (TypeError, "flight.hours is given twice", lambda: sins.fly("patrol", hours=1, flight={"hours": 2})),
            (TypeError, "height_m: not numbers: .*dates", lambda: sins.trajectory(**lacking, height_m=pandas.date_range("2026", periods=3))),
            (TypeError, "time_s: not numbers: 1 times are missing",
             lambda: sins.trajectory(**{**good, "time_s": np.array(["2026-01-01", "NaT", "2026-01-03"], "datetime64[s]")})),
            (ValueError, "judge = 'loud': must be 'warn', 'strict' or 'off'", lambda: sins.trajectory(**good, judge="loud")),
            (TypeError, "height_m: not numbers: complex", lambda: sins.trajectory(**lacking, height_m=np.array([1j, 2, 3]))),
            (ValueError, "at most 360000", lambda: sins.recommend("patrol", hours=48, position_m=1)),
        ]:
            with self.subTest(sentence):
                self.assertRaisesRegex(error, sentence, call)

    def test_a_section_that_does_not_exist_is_told_without_keys_too(self):
        for function in FLIES:
            for settings in ({"foo": {}}, {"foo": {"bar": 1}}, {"foo": "navigation"}):
                with self.subTest(function.__name__, **settings), self.assertRaisesRegex(sins.Error, "^no such section: foo"):
                    function("patrol", hours=0.01, **settings)
        self.assertEqual(len(sins.fly("patrol", hours=0.01, gyro={}, accel={}, output={"name": "x"}, every_s=1)), 37)

    def test_masked_values_are_rejected_wherever_numbers_are_given(self):
        masked, whole = np.ma.array([1.0, 2.0, 3.0], mask=[0, 0, 1]), np.ma.array([1.0, 2.0, 3.0])
        columns = {"time_s": np.arange(3.0), "latitude_rad": 0.1, "longitude_rad": 0.2, "height_m": 1.0, "roll_rad": 0, "pitch_rad": 0,
                   "heading_rad": 0}
        names = [name for name in [name for name, *_ in sins._scene._QUANTITIES] if not name.endswith("_deg")]
        every = {name: columns.get(name, 0.0) for name in names}
        every["height_m"] = whole
        self.assertEqual(len(sins.trajectory(**every)), 3)
        table = np.ma.array(np.zeros(3, [(name, float) for name in columns]))
        for name in names:
            with self.subTest(name), self.assertRaisesRegex(ValueError, f"^{name}: 1 values are masked"):
                sins.trajectory(**{**every, name: masked})
        for name in columns:
            with self.subTest(table=name), self.assertRaisesRegex(ValueError, f"^{name}: 1 values are masked"):
                table.mask = False
                table[name][1] = np.ma.masked
                sins.trajectory(table)
        for function in FLIES:
            with self.subTest(function.__name__), self.assertRaisesRegex(ValueError, "gyro.bias_deg_h: 1 values are masked"):
                function("patrol", hours=0.01, gyro={"bias_deg_h": masked})
            with self.subTest(function.__name__), self.assertRaisesRegex(ValueError, "flight.hours: 1 values are masked"):
                function("patrol", hours=np.ma.masked)
        with sins.Flight("patrol", hours=0.01) as flight:
            flight.fly(1.0)
            for name in CORRECTIONS:
                with self.subTest(name), self.assertRaisesRegex(ValueError, f"^{name}: 1 values are masked"):
                    flight.correct(**{name: masked})
            flight.correct(gyro_bias_rad_s=np.ma.array([0.0, 0.0, 0.0]))

    def test_arrays_are_settings(self):
        expected = sins.fly("patrol", hours=0.01, gyro={"bias_deg_h": [1, 2, 3]}, options={"seed": 3}).records
        for bias in (np.array([1.0, 2.0, 3.0]), (1, 2, 3), pandas.Series([1, 2, 3]), [np.float64(1), np.array(2), 3]):
            self.assertTrue((sins.fly("patrol", hours=np.array(0.01), gyro={"bias_deg_h": bias}, options={"seed": np.int64(3)}).records
                             == expected).all())

    def test_plots_and_words(self):
        run = sins.fly("racetrack", hours=0.05, options={"error_model": "rk4"}, **GRADE)
        for figure in (run.plot(), sins.ensemble("racetrack", hours=0.05, runs=5, **GRADE).envelope_plot()):
            drawn = io.BytesIO()
            figure.savefig(drawn, format="png")
            self.assertGreater(len(drawn.getvalue()), 10_000)
            self.assertEqual(len(figure.axes), 3)
        self.assertIn("m off at the end", repr(run))
        self.assertIn("cockpit.csv': 394.38 s, ", repr(sins.fly(SCENES / "cockpit.toml")))

    def test_the_import_is_light(self):
        code = "import sins, sys; print(sorted({'numpy', 'ctypes', 'pandas', 'matplotlib'} & set(sys.modules)), dir(sins))"
        found = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
        self.assertTrue(found.startswith("[] "), found)
        for name in sins.__all__:
            self.assertIsNotNone(getattr(sins, name).__doc__, name)
        self.assertRaisesRegex(AttributeError, "in sins.c", lambda: sins.create)


    def test_the_version_is_that_of_the_library(self):
        self.assertEqual(sins.__version__, c.version_string())
        self.assertIn("__version__", dir(sins))
        said = subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, text=True).stdout
        self.assertIn(sins.__version__, said.split())


class Copies(unittest.TestCase):
    """Of every class of the package: a copy is one that works alone, or a TypeError."""

    WAYS = [copy.copy, copy.deepcopy,
            *(lambda made, protocol=protocol: pickle.loads(pickle.dumps(made, protocol)) for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1))]

    def test_each_class(self):
        truth = sins.trajectory(log("fighter_aerobatics.csv"))
        drawn = sins.ensemble("racetrack", hours=0.01, runs=3, **GRADE)

        with sins.Flight("aerobatics", hours=0.02, flight={"rate_hz": 25}, options={"subsamples": 1}, **NOISE) as flight:
            identified = sins.identify("aerobatics", flight.fly(), hours=0.02, flight={"rate_hz": 25})
        checked = identified.check(twins=40)

        def record(run):
            return [run.records.tobytes(), repr(run)]

        uses = {
            "Run": (sins.fly("racetrack", hours=0.01, **GRADE), record),
            "Ensemble": (drawn, lambda one: [one.position_error_m.tobytes(), one.first_run, repr(one)]),
            "Figures": (drawn.figures(), repr),
            "Trajectory": (truth, lambda one: record(sins.fly(one, **GRADE))),
            "Finding": (sins.Finding("note", "gaps", 1, 0.5, 2, 3.0, 0.0, 0.0, "two gaps"), str),
            "Budget": (sins.budget("racetrack", hours=0.01, gyro={"bias_deg_h": 1}), lambda one: [str(one), bytes(one.whole)]),
            "Identified": (identified, lambda one: [str(one), one.scene(), one.rotation.tolist(), one["gyro bias x"]]),
            "Parameter": (identified.parameters[0], str),
            "Check": (checked, str),
            "Span": (checked.spans[0], str),
            "Recommendation": (sins.recommend("aerobatics", hours=0.01, position_m=1), lambda one: [one.options, bytes(one.cost)]),
        }
        every = {name for name in sins.__all__ if isinstance(getattr(sins, name), type)}
        self.assertEqual(every, {*uses, "Flight", "Error", "LogWarning"})
        for name, (made, use) in uses.items():
            expected = use(made)
            for copies in self.WAYS:
                with self.subTest(name):
                    other = copies(made)
                    self.assertIs(type(other), type(made))
                    self.assertEqual(use(other), expected)
                    del other
                    self.assertEqual(use(made), expected)

    def test_a_flight_has_no_copy(self):
        with sins.Flight("racetrack", hours=0.01, **GRADE) as flight:
            for copies in self.WAYS:
                self.assertRaisesRegex(TypeError, "a sins.Flight can be neither copied nor pickled", copies, flight)
                self.assertRaisesRegex(TypeError, "a sins.scene can be neither copied nor pickled", copies, sins._scene.Scene("patrol", None, {}).handle)
            self.assertEqual(len(flight.fly()), round(36 / flight.period_s))

    def test_errors_come_back_from_processes(self):
        for arguments in ({"gyro": {"bias_deg_h": 1e12}}, {"gyro": {"bais": 1, "bies": 2}}, {"foo": {}}):
            with self.assertRaises(sins.Error) as here:
                sins.fly("patrol", **arguments)
            with ProcessPoolExecutor(1) as pool, self.assertRaises(sins.Error) as there:
                pool.submit(sins.fly, "patrol", **arguments).result()
            self.assertEqual((str(there.exception), there.exception.status), (str(here.exception), here.exception.status))
            self.assertEqual(list(map(bytes, there.exception.faults)), list(map(bytes, here.exception.faults)))


class Interrupts(unittest.TestCase):
    """Ctrl-C is answered while the library computes. Each call would take more than 20 s; 5 s is for a busy machine."""

    def setUp(self):
        # Python sets none if the process was started with the signal ignored, as shells do in the background.
        signal.signal(signal.SIGINT, signal.default_int_handler)

    def interrupted(self, call):
        def press():
            pressed.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        pressed, self.before = [], set(threading.enumerate())
        timer = threading.Timer(0.7, press)
        timer.start()
        try:
            self.assertRaises(KeyboardInterrupt, call)
        finally:
            timer.cancel()
        self.assertLess(time.monotonic() - pressed[0], 5)

    def ended(self):
        """The threads of an interrupted call end too."""
        began = time.monotonic()
        while new := set(threading.enumerate()) - self.before:
            self.assertLess(time.monotonic() - began, 15, new)
            time.sleep(0.01)

    def at_rest(self, samples):
        return sins.trajectory(time_s=np.arange(samples) / 100, latitude_deg=40, longitude_deg=10, height_m=0, roll_deg=0, pitch_deg=0,
                               heading_deg=0)

    def test_flights(self):
        for settings in (LONG, {"hours": 20, "every_s": 3600, "options": {"error_model": "rk4", "covariance": True}}):
            self.interrupted(lambda: sins.fly("racetrack", **settings, **GRADE))
            self.ended()

    def test_a_flight_in_stretches_goes_on_from_where_it_was_interrupted(self):
        with sins.Flight("racetrack", **LONG, **GRADE) as flight, sins.Flight("racetrack", **LONG, **GRADE) as other:
            self.interrupted(lambda: flight.fly(70_000))
            at_s = flight.record["time_s"]
            self.assertLess(at_s, 60_000)
            other.fly(at_s)
            self.assertEqual(other.record, flight.record)
            self.assertEqual(flight.fly(2.0).tobytes(), other.fly(2.0).tobytes())

    def test_ensembles(self):
        update = '\n[[update]]\nkind = "position"\nat_s = 60\nsigma_m = 10\n'
        scenes = {"plain": "racetrack", "unit": DAY, "plan": f'[flight]\nbuiltin = "racetrack"\n{update}'}
        for name, flown in scenes.items():
            for times in (2, 200):
                with self.subTest(name, times=times):
                    self.interrupted(lambda: sins.ensemble(flown, hours=1, runs=2000, times=times, **GRADE))
                    self.ended()

    def test_analyses(self):
        flown = self.at_rest(2_000_000)
        before = flown.samples.copy()
        self.interrupted(lambda: sins.budget(flown, runs=100, **GRADE))
        self.ended()
        self.assertTrue((flown.samples == before).all())
        flown = self.at_rest(360_000)
        self.interrupted(lambda: sins.recommend(flown, position_m=1e-12))

    def test_the_size_of_pieces_changes_no_bit(self):
        def flown():
            with sins.Flight("racetrack", hours=0.01, **GRADE) as flight:
                return [flight.fly().tobytes(), flight.record.tobytes(), sins.fly("racetrack", hours=0.01, every_s=0.05, **GRADE).records.tobytes(),
                        sins.ensemble("racetrack", hours=0.01, runs=5, threads=2, times=9, **GRADE).position_error_m.tobytes()]

        expected = flown()
        for intervals in (1, 7, 100):
            with mock.patch("sins._flight.INTERVALS", intervals), mock.patch("sins._ensemble.INTERVALS", intervals):
                self.assertEqual(flown(), expected)

    def test_an_error_of_an_ensemble_names_the_sample_of_the_flight(self):
        frame = log("fighter_aerobatics.csv")
        frame.loc[20_000:, "latitude_rad"] += 0.1
        truth = sins.trajectory(frame, judge="off")
        self.assertRaisesRegex(sins.Error, r"\(samples\[20000\]\)$", sins.ensemble, truth, runs=3, **GRADE)


class Ensembles(unittest.TestCase):
    def test_equal_runs_are_refused_as_by_the_program(self):
        """One run, and each random thing alone, is flown."""
        failure = '\n[[failure]]\nsensor = "gyro"\naxis = "x"\nkind = "noise"\ndensity_deg_sqrt_h = 1\nfrom_s = 6\n'
        update = '\n[[update]]\nkind = "position"\nat_s = 6\nsigma_m = 1\n'
        head = '[flight]\nbuiltin = "racetrack"\nhours = 0.01\n'
        for scene, is_random in ((head, False), (head + "[gyro]\nbias_deg_h = 1\n", False), (head + "[gyro]\nbias_sigma_deg_h = 1\n", True),
                                 (head + "[altimeter]\nnoise_m = 1\n", True), (head + failure, True), (head + update, True),
                                 (head + update.replace("sigma_m = 1", "sigma_m = 0"), False)):
            with self.subTest(scene), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder, "scene.toml")
                path.write_text(scene)
                by_program = subprocess.run([PROGRAM, "ensemble", path, "--runs", "2", "--quiet", "--out", folder], capture_output=True, text=True)
                self.assertEqual(by_program.returncode == 0, is_random, by_program.stderr)
                self.assertEqual(len(sins.ensemble(path, runs=1)), 1)
                if is_random:
                    self.assertGreater(np.ptp(sins.ensemble(path, runs=2).position_error_m[:, -1, 0]), 0)
                else:
                    self.assertIn("nothing is random in this scene: all runs would be equal", by_program.stderr)
                    self.assertRaisesRegex(ValueError, "nothing is random in this scene: all runs would be equal", sins.ensemble, path, runs=2)

    def test_run_k_is_the_flight_with_run_k(self):
        failure = '\n[[failure]]\nsensor = "gyro"\naxis = "x"\nkind = "stuck"\nfrom_s = 60\n'
        scenes = {
            "plain": ("racetrack", {"hours": 0.05, "altimeter": {"bias_m": 1, "noise_m": 1}, **GRADE}),
            "log": (PROJECT / "c_examples/flights/fighter_aerobatics.csv", GRADE),
            "unit and panel": (DAY, {"hours": 0.3}),
            "plan": ('[flight]\nbuiltin = "racetrack"\nhours = 0.05\n[gyro]\npreset = "tactical"\n' + failure, {}),
        }
        for name, (scene, settings) in scenes.items():
            with self.subTest(name):
                drawn = sins.ensemble(scene, runs=5, times=7, threads=2, **settings)
                again = sins.ensemble(scene, runs=5, times=7, threads=1, **settings)
                self.assertTrue(np.array_equal(drawn.position_error_m, again.position_error_m))
                self.assertEqual(drawn.position_error_m.shape, (5, len(drawn.time_s), 3))
                self.assertGreater(np.ptp(drawn.position_error_m[:, -1, 0]), 0.0)
                for run in (0, 3):
                    one = sins.fly(scene, **{**settings, "options": {"run": drawn.first_run + run}}, every_s=sins.Flight(scene, **settings).period_s)
                    at = np.searchsorted(one.time_s, drawn.time_s)
                    for of_all, of_one in ((drawn.position_error_m, one.position_error_m),
                                           (drawn.velocity_error_m_s, one.velocity_error_m_s),
                                           (drawn.misalignment_rad, one.misalignment_rad)):
                        np.testing.assert_array_equal(of_all[run], of_one[at])

    def test_progress_is_shown_if_it_is_asked_for(self):
        progress = sins._calls.Progress("flying", 8)
        texts = [progress.text(3.0)]
        for parts in (2, 5, 1):
            progress.add(parts)
            texts.append(progress.text(3.0))
        self.assertEqual(texts, ["flying: 0 %", "flying: 25 %, 9 s left", "flying: 87 %, 1 s left", "flying: 100 %"])

        def shown(call):
            # Each look at the clock is a second later, so a short flight shows lines too.
            with mock.patch("time.monotonic", mock.Mock(side_effect=range(10**6))), mock.patch("sys.stderr", io.StringIO()) as errors:
                call()
            return errors.getvalue()

        flown = {"hours": 0.03, **GRADE}
        for scene, settings in (("racetrack", {}), (DAY, {"threads": 1})):
            lines = shown(lambda: sins.ensemble(scene, runs=16, progress=True, **settings, **flown)).split("\r")
            self.assertEqual(lines[0] + lines[-1] + lines[-2].strip(), "", "the line is gone at the end")
            parts = [int(re.fullmatch(r"flying 16 runs: (\d+) %(, \d+ s left)?", line.rstrip())[1]) for line in lines[1:-2]]
            self.assertEqual(parts, sorted(parts))
            self.assertTrue(parts)
        lines = shown(lambda: sins.budget("racetrack", progress=True, **flown)).split("\r")
        self.assertRegex(lines[1], r"^flying each effect alone, \d+ s$")
        for quiet in (lambda: sins.ensemble("racetrack", runs=4, **flown), lambda: sins.budget("racetrack", **flown)):
            self.assertEqual(shown(quiet), "")

    def test_diverged_runs_are_nan_and_warned_of(self):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            drawn = sins.ensemble("racetrack", hours=0.5, runs=6, times=30, options={"vertical": "free"},
                                  accel={"bias_sigma_micro_g": [0, 0, 3e4]})
        lost = np.isnan(drawn.position_error_m).any(axis=2)
        self.assertEqual([str(one.message) for one in said], [f"{lost[:, -1].sum()} of 6 runs diverged; their errors are NaN"])
        self.assertFalse(lost[:, 0].any() or (lost[:, :-1] & ~lost[:, 1:]).any())
        self.assertEqual(drawn.figures().runs, 6 - lost[:, -1].sum())
        drawn.position_error_m[:] = np.nan
        self.assertRaisesRegex(ValueError, "no run is left", drawn.figures)

    def test_intervals_hold(self):
        """Intervals of 95 % contain the truth in 95 % of draws of a known distribution: within 4 standard deviations of the share."""
        generator, trials = np.random.default_rng(1), 2000
        for runs in (10, 50, 300):
            held = np.zeros(3)
            for _ in range(trials):
                errors = generator.normal(size=(runs, 1, 3))
                figures = sins.Ensemble(np.zeros(1), {field: errors for field in ("position_enu_m", "velocity_enu_m_s",
                                                                                "misalignment_enu_rad")}, 0, "").figures()
                low, high = figures.rms_position_interval_enu_m
                held += [figures.cep50_interval_m[0] <= 1.177410 <= figures.cep50_interval_m[1],
                         figures.r95_interval_m[0] <= 2.447747 <= figures.r95_interval_m[1], low[0] <= 1 <= high[0]]
            with self.subTest(runs=runs):
                self.assertGreaterEqual(held.min() / trials, 0.95 - 4 * np.sqrt(0.05 * 0.95 / trials), held / trials)


class Increments(unittest.TestCase):
    def test_increments_are_those_of_each_interval(self):
        with sins.Flight("racetrack", hours=0.01, **GRADE) as flight:
            parts = []
            while len(imu := flight.fly(3.0)):
                parts.append(imu)
        whole = np.concatenate(parts)
        with c.scene_create_builtin("racetrack") as scene:
            c.scene_set_values(scene, "flight.hours = 0.01\ngyro.preset = navigation\naccelerometer.preset = navigation\n"
                                      "start.preset = navigation")
            with c.play_create(scene, None) as play:
                c.play_next(play)
                for one in whole:
                    c.play_next(play)
                    imu = c.get_imu(c.play_get_simulator(play))
                    np.testing.assert_array_equal(one["measured_angle_rad"], imu.measured_angle_rad)
                    np.testing.assert_array_equal(one["measured_velocity_m_s"], imu.measured_velocity_m_s)
                self.assertEqual(c.play_next(play), c.PLAY_END)

    def test_the_record_before_the_first_stretch_is_that_of_the_start(self):
        with sins.Flight("racetrack", hours=0.01, **GRADE) as flight:
            self.assertEqual(flight.record, sins.fly("racetrack", hours=0.01, **GRADE).records[0])
            self.assertEqual(len(flight.fly()), round(36 / flight.period_s))

    def test_a_correction_removes_errors(self):
        with sins.Flight("racetrack", hours=0.02, **GRADE) as flight:
            flight.fly(30.0)
            before = flight.record["navigation_errors"]
            flight.correct(**{name: before[name] for name in ("position_enu_m", "velocity_enu_m_s", "misalignment_enu_rad")})
            after = flight.record["navigation_errors"]
            for name in ("position_enu_m", "velocity_enu_m_s", "misalignment_enu_rad"):
                self.assertLess(np.abs(after[name]).max(), 1e-4 * np.abs(before[name]).max(), name)


    def test_a_wrong_correction_is_told_and_changes_nothing(self):
        with sins.Flight("racetrack", hours=0.01, **GRADE) as flight:
            flight.fly(3.0)
            before = flight.record
            for name in CORRECTIONS:
                for value, error, sentence in (
                    ([0, 0], ValueError, rf"^{name} has the shape \(2,\): expected \(3,\)"),
                    ([0, 0, 0, 0], ValueError, rf"^{name} has the shape \(4,\)"),
                    ([[0, 0, 0]], ValueError, rf"^{name} has the shape \(1, 3\)"),
                    (1.0, ValueError, rf"^{name} has the shape \(\)"),
                    ([], ValueError, rf"^{name} has the shape \(0,\)"),
                    (None, (TypeError, ValueError), rf"^{name}"),
                    ("abc", TypeError, rf"^{name}: not numbers"),
                    ([0, 0, 1j], TypeError, rf"^{name}: not numbers"),
                    ([0, float("nan"), 0], sins.Error, rf"{name}\[1\] = NaN: must be"),
                    ([0, 0, 1e300], sins.Error, rf"{name}\[2\] = 1e300: must be"),
                ):
                    with self.subTest(name, value=value), self.assertRaisesRegex(error, sentence):
                        flight.correct(**{name: value})
                self.assertRaisesRegex(TypeError, f"no such error: {name}s; did you mean {name}", flight.correct, **{f"{name}s": [0, 0, 0]})
            self.assertRaisesRegex(TypeError, "no such error: struct_size", flight.correct, struct_size=[0, 0, 0])
            self.assertEqual(flight.record, before)


class Analysis(unittest.TestCase):
    def test_a_budget_names_the_effect_that_was_set(self):
        budget = sins.budget("racetrack", hours=0.1, gyro={"bias_deg_h": 1}, accel={"scale_factor_ppm": 100})
        self.assertEqual(budget.effects[0], "mechanization")
        self.assertEqual(set(budget.effects[1:]), {"gyro bias", "accel scale factor"})
        self.assertEqual(len(str(budget).splitlines()), 4)
        self.assertAlmostEqual(budget.whole.position_m / np.hypot(*budget.rows["position_m"][1:]), 1, delta=0.5)

    def test_a_recommendation_flies(self):
        found = sins.recommend("aerobatics", hours=0.02, position_m=1, duration_s=3600)
        self.assertTrue(found.is_met)
        sins.fly("aerobatics", hours=0.02, options=found.options)
        self.assertFalse(sins.recommend("aerobatics", hours=0.02, position_m=1e-12, duration_s=3600).is_met)


class Identification(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = {"hours": 0.05, "flight": {"rate_hz": 25}}
        sensors = {"gyro": {**NOISE["gyro"], "bias_deg_h": [0, 30, 0]}, "accel": {**NOISE["accel"], "bias_micro_g": [0, 0, 2000]}}
        with sins.Flight("aerobatics", options={"subsamples": 1}, **sensors, **cls.path) as flight:
            cls.imu = flight.fly()

    def as_dict(self, **changed):
        imu = {"time_s": self.imu["time_s"], "angle_rad": self.imu["measured_angle_rad"], "velocity_m_s": self.imu["measured_velocity_m_s"]}
        return {name: value for name, value in {**imu, **changed}.items() if value is not None}

    def test_errors_that_were_set_come_back(self):
        found = sins.identify("aerobatics", self.imu, **self.path)
        self.assertEqual((len(found.parameters), found.rotation.shape), (c.IDENTIFIED_PARAMETERS - 24, (3, 3)))
        for name, truth in (("clock shift", 0), ("gyro bias y", 30 * c.DEG_PER_HOUR), ("accelerometer bias z", 2000 * c.MICRO_G)):
            one = found[name]
            self.assertTrue(one.is_seen and not one.reason, one)
            self.assertLess(abs(one.value - truth), 4 * one.sigma, one)
            self.assertAlmostEqual(one.interval[1] - one.value, 1.96 * one.sigma)
        self.assertTrue(all(one.is_seen != bool(one.reason) for one in found.parameters))
        self.assertIn("gyro bias y: ", str(found))
        self.assertRaisesRegex(KeyError, "the parameters are clock shift, ", lambda: found["gyro bias"])
        run = sins.fly(found.scene(), hours=0.01)
        self.assertGreater(abs(run.position_error_m[-1]).max(), 1)
        figure, drawn = found.plot(), io.BytesIO()
        figure.savefig(drawn, format="png")
        self.assertGreater(len(drawn.getvalue()), 10_000)
        # Every parameter that has a prior about 0 is one line with its own name, and its interval is in standard deviations of the prior.
        names = [label.get_text() for axis in figure.axes for label in axis.get_yticklabels()]
        self.assertEqual(sorted(names), sorted(one.name for one in found.parameters if one.prior > 0 and one.name != "clock shift"))
        lines = [line.get_xdata() for axis in figure.axes for line in axis.lines if len(line.get_xdata()) == 2]
        self.assertEqual(len(lines), len(names))
        for name, ends in zip(names, lines):
            self.assertTrue(np.allclose(np.array(ends) * found[name].prior, found[name].interval), name)

    def test_what_is_asked_for_beside_comes_back(self):
        g_sensitivity = 5 * c.DEG_PER_HOUR / c.STANDARD_GRAVITY
        sensors = {"gyro": {**NOISE["gyro"], "g_sensitivity_deg_h_per_g": [0, 5, 0, 0, 0, 0, 0, 0, 0]}, "accel": NOISE["accel"]}
        mounting = {"lever_arm_m": [0.3, 0, -0.2]}
        with sins.Flight("aerobatics", options={"subsamples": 1}, mounting=mounting, **sensors, **self.path) as flight:
            imu = flight.fly()
        found = sins.identify("aerobatics", imu, also=["lever_arm", "g_sensitivity"], **self.path)
        self.assertEqual((len(found.parameters), found.reference_temperature_c), (c.IDENTIFIED_PARAMETERS - 12, None))
        for name, truth in (("accelerometer lever arm x", 0.3), ("accelerometer lever arm z", -0.2), ("gyro g-sensitivity xy", g_sensitivity)):
            self.assertTrue(found[name].is_seen and abs(found[name].value - truth) < 4 * found[name].sigma, found[name])
        self.assertRaisesRegex(sins.Error, "record.lever_arm_m|increments", sins.identify, "aerobatics", imu, **self.path)
        self.assertRaisesRegex(sins.Error, "request.also.lever_arm", found.check)
        self.assertEqual(len(sins.identify("aerobatics", self.imu, also="asymmetry", **self.path).parameters), c.IDENTIFIED_PARAMETERS - 18)

    def test_a_change_with_temperature_comes_back(self):
        times = np.arange(6001) / 20
        columns = {"latitude_deg": 40, "longitude_deg": 10, "height_m": 0, "roll_deg": 3, "pitch_deg": 2, "heading_deg": 50}
        warm = sins.trajectory(time_s=times, temperature_c=20 + times / 15, **columns)
        gyro = {**NOISE["gyro"], "bias_temperature_deg_h_per_k": [0, 40, 0], "reference_temperature_c": 25}
        with sins.Flight(warm, options={"subsamples": 1}, gyro=gyro, accel=NOISE["accel"]) as flight:
            imu = flight.fly()
        found = sins.identify(warm, imu, also="temperature")
        self.assertEqual(len(found.parameters), c.IDENTIFIED_PARAMETERS - 18)
        self.assertLess(abs(found.reference_temperature_c - 30), 0.1)
        one = found["gyro bias/temperature y"]
        self.assertTrue(one.is_seen and abs(one.value - 40 * c.DEG_PER_HOUR) < 4 * one.sigma, one)
        self.assertLess(abs(found["gyro bias y"].value - 200 * c.DEG_PER_HOUR), 4 * found["gyro bias y"].sigma)
        self.assertTrue(sins.fly(found.scene(), hours=0.01))
        self.assertRaisesRegex(sins.Error, "gyros that drift by much, as with temperature", sins.identify, warm, imu)
        steady = sins.trajectory(time_s=times, **columns)
        self.assertRaisesRegex(sins.Error, "request.also.temperature: needs samples", sins.identify, steady, imu, also="temperature")

    def test_a_record_of_another_clock_and_other_axes(self):
        turned = self.as_dict(time_s=self.imu["time_s"] - 5.0, rate_rad_s=None)
        for name in ("angle_rad", "velocity_m_s"):
            x, y, z = turned[name].T
            turned[name] = pandas.DataFrame({"y": y, "x": x, "z": -z})
        for known in ({}, {"axes": "y x -z", "shift_s": 4.0, "prior": "tactical"}):
            found = sins.identify("aerobatics", turned, **known, **self.path)
            self.assertLess(abs(found["clock shift"].value - 5.0), 4 * found["clock shift"].sigma)
            self.assertLess(abs(found.rotation - [[0, 1, 0], [1, 0, 0], [0, 0, -1]]).max(), 0.01)
            self.assertTrue(found.axes_are_seen)

    def test_rates_are_their_integrals_and_a_trajectory_is_its_scene(self):
        interval_s = float(np.median(np.diff(self.imu["time_s"])))
        rates = self.as_dict(angle_rad=None, velocity_m_s=None, rate_rad_s=self.imu["measured_angle_rad"] / interval_s,
                             force_m_s2=self.imu["measured_velocity_m_s"] / interval_s)
        rows = np.zeros(len(self.imu), [("time_s", float), ("rate_rad_s", float, 3), ("force_m_s2", float, 3)])
        for name in rows.dtype.names:
            rows[name] = rates[name]
        expected, found, same = (sins.identify("aerobatics", imu, **self.path) for imu in (self.imu, rates, rows))
        self.assertEqual(same.parameters, found.parameters)
        for one, other in zip(expected.parameters, found.parameters):
            self.assertAlmostEqual(other.value, one.value, delta=1e-3 * max(one.sigma, abs(one.value)))

    def test_the_check_is_that_of_the_program_and_of_c(self):
        path = {"hours": 0.08, "flight": {"rate_hz": 50}}
        settings = ["--set", "flight.hours=0.08", "--set", "flight.rate_hz=50"]
        with tempfile.TemporaryDirectory() as folder:
            def run(*arguments):
                return subprocess.run([PROGRAM, *arguments], check=True, cwd=folder, capture_output=True, text=True).stdout

            run("fly", "aerobatics", "--preset", "tactical", *settings, "--set", "options.subsamples=1", "--imu", "record.csv", "--out", ".")
            said = json.loads(run("identify", "aerobatics", *settings, "--imu", "record.csv", "--prior", "industrial", "--check", "--twins", "40",
                                  "--truth-sigma", "velocity_m_s=0.003", "--json"))
            rows = pandas.read_csv(f"{folder}/record.csv", comment="#", float_precision="round_trip")
        imu = {"time_s": rows["time_s"], "interval_s": said["interval_s"],
               "angle_rad": rows[[f"angle_increment_{axis}_rad" for axis in "xyz"]],
               "velocity_m_s": rows[[f"velocity_increment_{axis}_m_s" for axis in "xyz"]]}
        found = sins.identify("aerobatics", imu, prior="industrial", **path)
        checked = found.check(twins=40, velocity_m_s=0.003)
        expected = said["check"]
        self.assertEqual(len(checked.spans), 3)
        for one, same in [(checked, expected), *zip(checked.spans, expected["spans"])]:
            for name, value in same.items():
                if name.endswith(("low_m", "high_m")):
                    low, high = getattr(one, f"{name.split('_')[0]}_interval_m")
                    self.assertEqual(low if name.endswith("low_m") else high, value, name)
                elif name != "spans":
                    self.assertEqual(getattr(one, name), value, name)
        self.assertTrue(checked.sentence.endswith(", with the errors of the path that were given"), checked.sentence)
        self.assertEqual(str(checked).count("\n"), 3)
        # The same calls in C.
        scene = c.scene_create_builtin("aerobatics")
        c.scene_set_values(scene, "flight.hours = 0.08\nflight.rate_hz = 50")
        options = c.scene_get_options(scene)
        options.sample_period_s = 1 / 50
        handle = c.identify_create(options, c.identify_request(flags=c.IDENTIFY_STATES, prior=c.GRADE_INDUSTRIAL))
        count = c.scene_get_samples(scene, None).count
        c.identify_push_samples(handle, c.samples_at(c.scene_create_flight(scene), np.arange(count) / 50))
        record = c.array(c.recorded_increment, len(rows))
        for name in imu:
            record[name] = imu[name]
        c.identify_push_increments(handle, record)
        whole = c.identify_check(handle, c.identify_check_request(twins=40, velocity_m_s=0.003))
        self.assertEqual((whole.spans, whole.length_s, whole.twins), (3, expected["length_s"], 40))
        for index, one in enumerate(expected["spans"]):
            span = c.identify_get_span(handle, index)
            same = {name: getattr(span, name) for name in one if name != "verdict"}
            self.assertEqual({**same, "verdict": one["verdict"]}, one)
        # The whole record is what is identified again: neither a check nor a copy changes what was found.
        self.assertEqual(pickle.loads(pickle.dumps(found)).check(twins=40, velocity_m_s=0.003), checked)
        exact = found.check(twins=40)
        self.assertLess(exact.spans[0].predicted_m, checked.spans[0].predicted_m)
        self.assertEqual((exact.verdict, exact.sentence), ("agrees", "the prediction agrees with the record"))
        for error, sentence, arguments in [
            (ValueError, "twins = 0: must be from 40 to 1000", {"twins": 0}),
            (ValueError, "twins = 39: must be from 40 to 1000", {"twins": 39}),
            (ValueError, "twins = 4294967336: must be from 40 to 1000", {"twins": 2**32 + 40}),
            (sins.Error, "request.tilt_rad = 2: must be from 0 to 0.3", {"tilt_rad": 2}),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                found.check(**arguments)

    def test_what_is_wrong_is_named(self):
        rows = len(self.imu)
        for error, sentence, arguments in [
            (ValueError, "prior = 'best': must be strategic, ", {"prior": "best"}),
            (ValueError, "axes = 'x y': must be x, y and z once each", {"axes": "x y"}),
            (ValueError, "also = 'noise': must be lever_arm, g_sensitivity, asymmetry or temperature", {"also": ["noise"]}),
            (sins.Error, "request.axes: must be a signed exchange of axes without reflection", {"axes": "x y -z"}),
            (sins.Error, "request.shift_s = NaN", {"shift_s": float("nan")}),
            (sins.Error, "no such section: foo", {"foo": {}}),
            (TypeError, "no time_s", {"imu": {}}),
            (TypeError, "give one of rate_rad_s and angle_rad", {"imu": self.as_dict(angle_rad=None)}),
            (TypeError, "give one of force_m_s2 and velocity_m_s", {"imu": self.as_dict(force_m_s2=np.zeros((rows, 3)))}),
            (ValueError, rf"angle_rad has the shape \({rows},\): expected \({rows}, 3\)", {"imu": self.as_dict(angle_rad=np.zeros(rows))}),
            (ValueError, r"time_s has the shape \(1,\)", {"imu": self.as_dict(time_s=[0.0])}),
            (ValueError, r"interval_s has the shape \(2,\)", {"imu": self.as_dict(interval_s=[0.1, 0.1])}),
            (TypeError, "velocity_m_s: not numbers", {"imu": self.as_dict(velocity_m_s="abc")}),
            (sins.Error, r"increments.angle_rad\[0\] = NaN: must be a finite number \(increments\[0\]\)", {"imu": self.as_dict(angle_rad=np.full((rows, 3), np.nan))}),
            (sins.Error, r"increments.time_s = 0: must be later than the increment before, at 0 \(increments\[1\]\)", {"imu": self.as_dict(time_s=np.zeros(rows), interval_s=0.04)}),
            (sins.Error, r"increments.angle_rad = 57.\d+: size of the rates", {"imu": self.as_dict(angle_rad=57.3 * self.imu["measured_angle_rad"])}),
            (sins.Error, "increments = 50: must be at least 100", {"imu": self.imu[:50]}),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                sins.identify("aerobatics", arguments.pop("imu", self.imu), **arguments, **self.path)


class Page(unittest.TestCase):
    def test_the_page_prints_what_it_says(self):
        page = PROJECT / "docs/python.md"
        examples = "\n".join(re.findall("```python\n(.*?)```", page.read_text(), re.DOTALL))
        test = doctest.DocTestParser().get_doctest(examples, {}, page.name, str(page), 0)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "c_examples").symlink_to(PROJECT / "c_examples")
            os.chdir(folder)
            try:
                said = io.StringIO()
                ran = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test, out=said.write)
            finally:
                os.chdir(before)
        self.assertEqual(ran.failed, 0, said.getvalue())
        self.assertGreater(ran.attempted, 20)


if __name__ == "__main__":
    unittest.main()
