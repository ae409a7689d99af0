#!/usr/bin/env python3
"""Packs the module sins.py and the library that it loads as a wheel: release/wheel.py MODULE LIBRARY VERSION PLATFORM FOLDER.

PLATFORM is a platform tag of Python packages, such as manylinux_2_17_x86_64 or win32. SOURCE_DATE_EPOCH is the time of all files.
"""
import base64
import hashlib
import os
import pathlib
import sys
import time
import zipfile

module, library, version, platform, folder = sys.argv[1:]
version = version.replace("-", "+", 1)  # a pre-release of Cargo as a local version
info = f"sins-{version}.dist-info"
epoch = time.gmtime(int(os.environ["SOURCE_DATE_EPOCH"]))[:6]
files = {
    "sins/__init__.py": pathlib.Path(module).read_bytes(),
    f"sins/{pathlib.Path(library).name}": pathlib.Path(library).read_bytes(),
    f"{info}/METADATA": f"""Metadata-Version: 2.1
Name: sins
Version: {version}
Summary: Strapdown inertial navigation system simulator
License: MIT OR Apache-2.0
Requires-Python: >=3.9
Provides-Extra: arrays
Requires-Dist: numpy; extra == "arrays"
""".encode(),
    f"{info}/WHEEL": f"""Wheel-Version: 1.0
Generator: sins
Root-Is-Purelib: false
Tag: py3-none-{platform}
""".encode(),
}
for name in ("LICENSE-MIT", "LICENSE-APACHE"):
    files[f"{info}/{name}"] = pathlib.Path(name).read_bytes()


def record(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


lines = "".join(record(name, content) for name, content in files.items())
files[f"{info}/RECORD"] = f"{lines}{info}/RECORD,,\n".encode()
with zipfile.ZipFile(pathlib.Path(folder) / f"sins-{version}-py3-none-{platform}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
    for name, content in files.items():
        entry = zipfile.ZipInfo(name, epoch)
        entry.external_attr = 0o644 << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        wheel.writestr(entry, content)
