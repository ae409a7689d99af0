"""Packs the module that build.rs wrote, and the library that it loads, as a wheel for any Python of a platform.

Without the variables SINS_WHEEL_BINDINGS (the folder `bindings` of a build), SINS_WHEEL_LIBRARY and SINS_WHEEL_PLATFORM (a platform tag)
of release/package.sh, cargo builds both for this machine.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target"))
NAMES = {"win32": "sins.dll", "darwin": "libsins.dylib"}
VERSION = re.search('^version = "(.*)"', (PROJECT / "Cargo.toml").read_text(), re.MULTILINE).group(1)


def built():
    """The folder of the module, and the library."""
    if "SINS_WHEEL_LIBRARY" in os.environ:
        return pathlib.Path(os.environ["SINS_WHEEL_BINDINGS"]), pathlib.Path(os.environ["SINS_WHEEL_LIBRARY"])
    subprocess.run(["cargo", "rustc", "--release", "--lib", "--crate-type", "cdylib"], cwd=PROJECT, check=True)
    return TARGET / "release/bindings", TARGET / "release" / NAMES.get(sys.platform, "libsins.so")


class Build(build_py):
    def run(self):
        bindings, library = built()
        folder = pathlib.Path(self.build_lib) / "sins"
        # Without the modes of a checkout, which a wheel would have.
        ignore = shutil.ignore_patterns("__pycache__")
        shutil.copytree(bindings / "sins", folder, ignore=ignore, copy_function=shutil.copyfile)
        shutil.copyfile(library, folder / library.name)


class Wheel(bdist_wheel):
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", os.environ.get("SINS_WHEEL_PLATFORM") or super().get_tag()[2]

    def egg2dist(self, egginfo_path, distinfo_path):
        super().egg2dist(egginfo_path, distinfo_path)
        for name in ("LICENSE-MIT", "LICENSE-APACHE"):
            shutil.copyfile(PROJECT / name, pathlib.Path(distinfo_path) / name)


class Binary(Distribution):
    def has_pure_modules(self):
        return True

    def has_ext_modules(self):
        return True


work = TARGET / "python"
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
setup(
    version=VERSION.replace("-", "+", 1),  # a pre-release of Cargo as a local version
    packages=[],
    distclass=Binary,
    cmdclass={"build_py": Build, "bdist_wheel": Wheel},
    options={"build": {"build_base": str(work / "build")}, "egg_info": {"egg_base": str(work)}},
)
