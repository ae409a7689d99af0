#!/usr/bin/env python3
"""The same motion by `sins` and by other strapdown codes: prints the table of docs/trust.md.

    python3 -m venv target/peers && target/peers/bin/pip install python-ins inu
    git clone https://github.com/Aceinna/gnss-ins-sim target/gnss-ins-sim
    cargo rustc --release --lib --crate-type cdylib
    export PYTHONPATH=target/release/bindings SINS_LIBRARY=target/release/libsins.so
    target/peers/bin/python benches/peers.py --source gnss-ins-sim=target/gnss-ins-sim

Each code gets the increments of perfect sensors at 200 Hz (as mean rates where it takes rates), and navigates for an hour. The motion is
a closed form on the ellipsoid, where the normal gravity of all codes is the same. The increments are Gauss quadratures of the exact rate
and specific force; no code computes them. A code that cannot be imported is left out. gnss-ins-sim is in no registry: --source names
its folder.

A code of another language takes the same increments from a file, which `--increments FOLDER` writes for each motion, and its end comes
back in a file, which `--end NAME=FOLDER` reads:

    swings.txt, coning.txt    start: one line: latitude, longitude [rad], height [m], velocity north, east, down [m/s], roll, pitch,
                              heading [rad]; then a line a sample: time [s], three angle increments [rad], three velocity increments
                              [m/s], forward, right, down: without its first line the file is an IMU file of KF-GINS
    swings.end, coning.end    one line: those nine values at the end, and the time a sample [us]
"""

import argparse
import importlib.metadata
import math
import pathlib
import sys
import time

import numpy as np

RATE_HZ = 200
A, E2, EARTH_RATE = 6378137.0, 6.6943799901413e-3, 7.292115e-5
GRAVITY_EQUATOR, GRAVITY_K = 9.780325335903893, 1.9318526524580992e-3  # WGS 84, Somigliana
TAU = 2 * math.pi


class Motion:
    """Latitude swings, longitude grows, the body swings about all axes; with `vibration` it also cones by 0.2 degrees at 8 Hz."""

    def __init__(self, vibration):
        self.vibration = vibration

    def swings(self, t, terms):
        """Value and rate of a sum of sinusoids: degrees, Hz, phase in turns."""
        value = sum(math.radians(a) * np.sin(TAU * (f * t + p)) for a, f, p in terms)
        rate = sum(math.radians(a) * TAU * f * np.cos(TAU * (f * t + p)) for a, f, p in terms)
        return value, rate

    def place(self, t):
        """Latitude, longitude, and their rates; the second derivative of the latitude."""
        w, amplitude = TAU / 1200, math.radians(0.3)
        latitude = math.radians(40) + amplitude * np.sin(w * t)
        rate = math.radians(2.5e-3)
        return latitude, math.radians(116) + rate * t, amplitude * w * np.cos(w * t), rate, -amplitude * w * w * np.sin(w * t)

    def euler(self, t):
        """Roll, pitch, heading, each with its rate."""
        cone = [(0.2, 8.0, 0.0)] if self.vibration else []
        across = [(0.2, 8.0, 0.25)] if self.vibration else []
        return (self.swings(t, [(25, 1 / 23, 0.0), *cone]), self.swings(t, [(5, 1 / 11, 0.1), *across]),
                self.swings(t, [(30, 1 / 37, 0.0)]))

    def dcm(self, t):
        """Body (forward, right, down) to north-east-down; an array of matrices for an array of times."""
        (roll, _), (pitch, _), (heading, _) = self.euler(t)
        (sr, sp, sh), (cr, cp, ch) = (np.sin([roll, pitch, heading]), np.cos([roll, pitch, heading]))
        return np.moveaxis(np.array([[ch * cp, ch * sp * sr - sh * cr, ch * sp * cr + sh * sr],
                                     [sh * cp, sh * sp * sr + ch * cr, sh * sp * cr - ch * sr], [-sp, cp * sr, cp * cr]]), (0, 1), (-2, -1))

    def velocity(self, t):
        """North, east, down."""
        latitude, _, latitude_rate, longitude_rate, _ = self.place(t)
        square = 1 - E2 * np.sin(latitude) ** 2
        prime = A / np.sqrt(square)
        meridian = prime * (1 - E2) / square
        return np.stack([meridian * latitude_rate, prime * np.cos(latitude) * longitude_rate, 0 * latitude], -1)

    def signals(self, t):
        """Angular rate against inertial space and specific force, body axes."""
        latitude, _, north_rate, east_rate, change = self.place(t)
        sin, cos = np.sin(latitude), np.cos(latitude)
        square = 1 - E2 * sin**2
        prime = A / np.sqrt(square)
        meridian = prime * (1 - E2) / square
        # d meridian/d latitude = 3 e^2 meridian sin cos/square; d(prime cos)/d latitude = -meridian sin.
        north = 3 * E2 * meridian * sin * cos / square * north_rate**2 + meridian * change
        east = -meridian * sin * north_rate * east_rate
        gravity = GRAVITY_EQUATOR * (1 + GRAVITY_K * sin**2) / np.sqrt(square)
        earth = EARTH_RATE * np.stack([cos, 0 * cos, -sin], -1)
        transport = np.stack([east_rate * cos, -north_rate, -east_rate * sin], -1)
        force = np.stack([north, east, -gravity], -1) + np.cross(2 * earth + transport, self.velocity(t))
        (roll, roll_rate), (pitch, pitch_rate), (_, heading_rate) = self.euler(t)
        body = np.stack([roll_rate - heading_rate * np.sin(pitch),
                         pitch_rate * np.cos(roll) + heading_rate * np.cos(pitch) * np.sin(roll),
                         -pitch_rate * np.sin(roll) + heading_rate * np.cos(pitch) * np.cos(roll)], -1)
        turn = np.swapaxes(self.dcm(t), -1, -2)
        to_body = lambda vectors: np.einsum("...ij,...j->...i", turn, vectors)
        return body + to_body(earth + transport), to_body(force)

    def increments(self, count):
        """Integrals of both signals over the intervals: Gauss' rule with 5 nodes, exact to rounding for 5 ms of these motions."""
        nodes, weights = np.polynomial.legendre.leggauss(5)
        begin = np.arange(count) / RATE_HZ
        sums = [np.zeros((count, 3)), np.zeros((count, 3))]
        for node, weight in zip(nodes, weights):
            for sum_, signal in zip(sums, self.signals(begin + (1 + node) / 2 / RATE_HZ)):
                sum_ += signal * (weight / 2 / RATE_HZ)
        return sums

    def errors(self, t, latitude, longitude, velocity_ned, dcm):
        """Horizontal position [m], velocity [m/s], attitude [arcsec] of a solution."""
        truth = self.place(t)
        north = (latitude - truth[0]) * A
        east = (longitude - truth[1]) * A * math.cos(truth[0])
        turn = dcm @ self.dcm(t).T
        skew = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
        return math.hypot(north, east), math.hypot(*(velocity_ned - self.velocity(t))[:2]), np.linalg.norm(skew) * 206264.8


def run_sins(motion, angle, velocity, subsamples=2, held=False):
    """Some samples are the subsamples of an update. The vertical channel is free, or `held`: at height 0 after each update."""
    from sins import c as sins
    flip = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]])  # north-east-down to east-north-up
    options = sins.options(gravity=sins.GRAVITY_SOMIGLIANA, axes=sins.AXES_FORWARD_RIGHT_DOWN)
    latitude, longitude, *_ = motion.place(0.0)
    w, x, y, z = quaternion(flip @ motion.dcm(0.0))
    start = sins.navigation(latitude_rad=latitude, longitude_rad=longitude, quaternion_nb=(w, x, y, z),
                            velocity_enu_m_s=tuple(flip @ motion.velocity(0.0)))
    sim = sins.sim()
    sins.create(options, sim)
    sins.start_navigation(sim, start)
    increment = sins.imu_increment(interval_s=subsamples / RATE_HZ, count=subsamples)
    end, error = sins.navigation(), sins.correction()
    angles, velocities = (table.reshape(-1, 3 * subsamples) for table in (angle, velocity))
    for k in range(len(angles)):
        increment.angle_rad[:3 * subsamples] = angles[k]
        increment.velocity_m_s[:3 * subsamples] = velocities[k]
        sins.push_imu(sim, increment)
        if held:
            sins.get_navigation(sim, end)
            error.position_enu_m[2], error.velocity_enu_m_s[2] = end.height_m, end.velocity_enu_m_s[2]
            sins.correct(sim, error)
    sins.get_navigation(sim, end)
    dcm = flip @ matrix(end.quaternion_nb)
    return end.latitude_rad, end.longitude_rad, flip @ np.array(end.velocity_enu_m_s), dcm


def run_pyins(motion, angle, velocity):
    import pandas
    from pyins import strapdown, transform, util
    latitude, longitude, *_ = motion.place(0.0)
    (roll, _), (pitch, _), (heading, _) = motion.euler(0.0)
    start = pandas.Series([*np.degrees([latitude, longitude]), 0.0, *motion.velocity(0.0), *np.degrees([roll, pitch, heading])],
                          index=util.TRAJECTORY_COLS, name=0.0)
    # It wants the increment before the first one, too.
    before = motion.signals(np.array([-0.5 / RATE_HZ]))
    table = np.vstack([np.hstack(before) / RATE_HZ, np.hstack([angle, velocity])])
    imu = pandas.DataFrame(table, index=np.arange(len(table)) / RATE_HZ, columns=util.GYRO_COLS + util.ACCEL_COLS)
    integrator = strapdown.Integrator(start, with_altitude=False)
    integrator.integrate(strapdown.compute_increments_from_imu(imu, "increment"))
    end = integrator.get_pva()
    latitude, longitude = np.radians(end[["lat", "lon"]].to_numpy())
    return latitude, longitude, end[["VN", "VE", "VD"]].to_numpy(), transform.mat_from_rph(end[["roll", "pitch", "heading"]])


def run_inu(motion, angle, velocity):
    import inu
    latitude, longitude, *_ = motion.place(0.0)
    (roll, _), (pitch, _), (heading, _) = motion.euler(0.0)
    rates = [np.vstack([table, table[-1:]]) * RATE_HZ for table in (velocity, angle)]  # the solution is that before each sample
    place, speed, euler = inu.mech(*rates, np.array([latitude, longitude, 0.0]), motion.velocity(0.0), np.array([roll, pitch, heading]),
                                   1 / RATE_HZ, hae_t=np.zeros(len(rates[0])), show_progress=False)
    return place[-1, 0], place[-1, 1], speed[-1], from_euler(*euler[-1])


def run_gnss_ins_sim(motion, angle, velocity):
    from demo_algorithms.free_integration import FreeIntegration
    latitude, longitude, *_ = motion.place(0.0)
    (roll, _), (pitch, _), (heading, _) = motion.euler(0.0)
    body_velocity = motion.dcm(0.0).T @ motion.velocity(0.0)
    code = FreeIntegration(np.array([latitude, longitude, 0.0, *body_velocity, heading, pitch, roll]))
    rates = [np.vstack([table, table[-1:]]) * RATE_HZ for table in (angle, velocity)]
    code.run([0, RATE_HZ, *rates])
    heading, pitch, roll = code.att[-1]
    return code.pos[-1, 0], code.pos[-1, 1], code.vel[-1], from_euler(roll, pitch, heading)


def from_euler(roll, pitch, heading):
    motion = Motion(False)
    motion.euler = lambda t: ((roll, 0), (pitch, 0), (heading, 0))
    return motion.dcm(0.0)


def quaternion(dcm):
    """Scalar first, of a rotation of less than half a turn."""
    w = math.sqrt(1 + np.trace(dcm)) / 2
    return w, (dcm[2, 1] - dcm[1, 2]) / 4 / w, (dcm[0, 2] - dcm[2, 0]) / 4 / w, (dcm[1, 0] - dcm[0, 1]) / 4 / w


def matrix(q):
    w, x, y, z = q
    return np.array([[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]])


def run_sins_4(motion, angle, velocity):
    return run_sins(motion, angle, velocity, 4)


def run_sins_held(motion, angle, velocity):
    return run_sins(motion, angle, velocity, held=True)


def run_sins_4_held(motion, angle, velocity):
    return run_sins(motion, angle, velocity, 4, held=True)


CODES = {"sins": run_sins, "sins, 4 subsamples": run_sins_4, "sins, height held": run_sins_held,
         "sins, 4 subsamples, height held": run_sins_4_held, "pyins": run_pyins, "inu": run_inu, "gnss-ins-sim": run_gnss_ins_sim}


def version_of(name, folder):
    name = {"pyins": "python-ins"}.get(name, name)
    if name.startswith("sins"):
        from sins import c as sins
        return sins.version_string()
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return f"(source {folder})"


def state(motion, t):
    """The line of a file: place, velocity and attitude."""
    latitude, longitude, *_ = motion.place(t)
    return [latitude, longitude, 0.0, *motion.velocity(t), *(float(angle) for angle, _ in motion.euler(t))]


def write(folder, short, motion, count):
    times = np.arange(1, count + 1) / RATE_HZ
    with open(folder / f"{short}.txt", "w") as file:
        print(*map(repr, map(float, state(motion, 0.0))), file=file)
        np.savetxt(file, np.column_stack([times, *motion.increments(count)]), fmt="%.17g")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", action="append", default=[], metavar="NAME=FOLDER", help="a folder with the source of a code")
    parser.add_argument("--increments", type=pathlib.Path, metavar="FOLDER", help="write the increments there, and do nothing else")
    parser.add_argument("--end", action="append", default=[], metavar="NAME=FOLDER", help="a folder with the ends of another code")
    parser.add_argument("--hours", type=float, default=1.0)
    arguments = parser.parse_args()
    folders = dict(source.split("=", 1) for source in arguments.source)
    ends = dict(end.split("=", 1) for end in arguments.end)
    sys.path += folders.values()
    count = round(arguments.hours * 3600 * RATE_HZ) // 4 * 4
    motions = (("swings", "swings", Motion(False)), ("coning", "swings, coning of 0.2° at 8 Hz", Motion(True)))
    if arguments.increments:
        arguments.increments.mkdir(parents=True, exist_ok=True)
        for short, _, motion in motions:
            write(arguments.increments, short, motion, count)
        return
    print("| motion | code | position error [m] | velocity [m/s] | attitude [arcsec] | time a sample [us] |\n|---|---|---|---|---|---|")
    for short, name, motion in motions:
        def row(code, errors, microseconds):
            figures = " | ".join(f"{figure:.1e}" for figure in errors)
            print(f"| {name} | {code} | {figures} | {microseconds:.1f} |", flush=True)

        increments = motion.increments(count)
        for code, run in CODES.items():
            try:
                if code == "pyins":
                    run(motion, *(table[:10] for table in increments))  # compiles
                began = time.perf_counter()
                end = run(motion, *increments)
            except ImportError as error:
                print(f"{code}: {error}", file=sys.stderr)
                continue
            seconds = time.perf_counter() - began
            version = version_of(code, folders.get(code))
            row(f"{code} {version}", motion.errors(count / RATE_HZ, *end), 1e6 * seconds / count)
        for code, folder in ends.items():
            latitude, longitude, _, *velocity, roll, pitch, heading, microseconds = np.loadtxt(f"{folder}/{short}.end")
            errors = motion.errors(count / RATE_HZ, latitude, longitude, np.array(velocity), from_euler(roll, pitch, heading))
            row(code, errors, microseconds)


if __name__ == "__main__":
    main()
