#!/usr/bin/env python3
"""The time from a packet of a flight simulator to the answer of `sins live`, both ways through the sockets, at 60 Hz:

    cargo build --release -p sins-cli
    benches/live.py target/release/sins [SECONDS]

The packets are FlightGear's, of a level flight to the north; the sensors are those of a navigation grade.
"""

import math
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time

RATE_HZ, SPEED_M_S, MERIDIAN_M, FOOT_M = 60, 100.0, 6_335_439.327, 0.3048


def packet(tick):
    """The packet of a time [1/60 s]: version, place, angles and velocities, and zeros for the rest."""
    latitude_rad = tick / RATE_HZ * SPEED_M_S / MERIDIAN_M
    place = struct.pack(">II3d", 24, 0, 0.5, latitude_rad, 3000.0)
    motion = struct.pack(">14f", *[0.0] * 11, SPEED_M_S / FOOT_M, 0.0, 0.0)
    return (place + motion).ljust(408, b"\0")


def main():
    program, seconds = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    answers = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    answers.bind(("127.0.0.1", 0))
    answers.settimeout(10)
    with tempfile.TemporaryDirectory() as folder:
        to = f"udp:127.0.0.1:{answers.getsockname()[1]}"
        arguments = ["--from", "udp:0", "--to", to, "--rate-hz", str(RATE_HZ), "--silence-s", "2"]
        arguments += ["--preset", "navigation", "--out", folder]
        live = subprocess.Popen([program, "live", *arguments], stdout=subprocess.PIPE, text=True)
        port = int(re.search(r":(\d+) for", live.stdout.readline()).group(1))
        delays_s = []
        start_s = time.perf_counter()
        for tick in range(round(seconds * RATE_HZ)):
            time.sleep(max(0.0, start_s + tick / RATE_HZ - time.perf_counter()))
            sent_s = time.perf_counter()
            answers.sendto(packet(tick), ("127.0.0.1", port))
            if tick > 0:  # the first sample has no answer
                answers.recv(2000)
                delays_s.append(time.perf_counter() - sent_s)
        said = live.communicate()[0]
    delays_s.sort()
    median, late = (1e3 * delays_s[math.floor(part * len(delays_s))] for part in (0.5, 0.999))
    print(f"{len(delays_s)} answers; packet to answer: {median:.3f} ms (median), {late:.3f} ms (99.9 %)")
    print(re.search(r"answers +(.*)", said).group(1))


main()
