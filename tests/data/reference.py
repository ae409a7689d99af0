#!/usr/bin/env python3
"""Writes the reference signals of this folder: analytic motions, and what perfect sensors measure on them.

    reference.py            writes every file (numpy; two minutes)
    reference.py --check    compares rates, forces and increments with 50-digit arithmetic (mpmath)

It shares nothing with the library. Each motion gives latitude, longitude, height and attitude as functions of time. Their Taylor
series at each sample, in extended precision, give the angular rate against inertial space and the specific force
    f_e = r'' + 2 W x r' - g,    W Earth rate, g normal gravity by Somigliana's formula, along the ellipsoid normal;
the integrals of the series are the increments. Axes: body right-forward-up, q = z(-heading) x(pitch) y(roll) to east-north-up.

Format of NAME.packed, all integers little endian: "SINSPACK", u8 number of columns; for each: u8 length and name, u8 decimals, u8
order d, u32 number of values, then one variable-length integer (7 bits a byte, low first, zigzag) for each value: value i as its
backward difference of order min(i, d). The order is the one that packs best.
"""

import struct
import sys
from decimal import Decimal
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent
ORDER = 16


class Series:
    """Taylor series in time, at many instants: row k has the coefficients of t^k."""

    def __init__(self, rows):
        self.rows = rows

    def __add__(self, other):
        if isinstance(other, Series):
            count = min(len(self.rows), len(other.rows))
            return Series(self.rows[:count] + other.rows[:count])
        rows = self.rows.copy()
        rows[0] += other
        return Series(rows)

    def __mul__(self, other):
        if not isinstance(other, Series):
            return Series(self.rows * other)
        count = min(len(self.rows), len(other.rows))
        return Series(np.array([np.sum(self.rows[: k + 1] * other.rows[k::-1], axis=0) for k in range(count)]))

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __truediv__(self, other):
        return self * (other.power(-1) if isinstance(other, Series) else 1 / other)

    def __rtruediv__(self, other):
        return self.power(-1) * other

    def power(self, p):
        """Its power p, from a y' = p y a'."""
        a, y = self.rows, np.zeros_like(self.rows)
        y[0] = a[0] ** p
        for k in range(1, len(a)):
            y[k] = sum((p * j - (k - j)) * a[j] * y[k - j] for j in range(1, k + 1)) / (k * a[0])
        return Series(y)

    def derivative(self):
        return Series(self.rows[1:] * np.arange(1, len(self.rows))[:, None])

    def integral(self, start):
        return Series(np.vstack([start, self.rows / np.arange(1, len(self.rows) + 1)[:, None]]))

    def sin_cos(self):
        a, s, c = self.rows, np.zeros_like(self.rows), np.zeros_like(self.rows)
        s[0], c[0] = np.sin(a[0]), np.cos(a[0])
        for k in range(1, len(a)):
            s[k] = sum(j * a[j] * c[k - j] for j in range(1, k + 1)) / k
            c[k] = -sum(j * a[j] * s[k - j] for j in range(1, k + 1)) / k
        return Series(s), Series(c)

    def at(self, t):
        value = self.rows[-1]
        for row in self.rows[-2::-1]:
            value = value * t + row
        return value


class OfSeries:
    """Functions of series."""

    number = staticmethod(np.longdouble)
    pi = np.longdouble("3.14159265358979323846264338327950288")
    derivative = staticmethod(Series.derivative)

    @staticmethod
    def sin_cos(a):
        return a.sin_cos() if isinstance(a, Series) else (np.sin(a), np.cos(a))

    @staticmethod
    def root(a):
        return a.power(np.longdouble("0.5")) if isinstance(a, Series) else np.sqrt(a)

    @staticmethod
    def atan2(y, x):
        turn = (x * y.derivative() - y * x.derivative()) / (x * x + y * y)
        return turn.integral(np.arctan2(y.rows[0], x.rows[0]))

    @staticmethod
    def times(instants):
        rows = np.zeros((ORDER + 1, len(instants)), dtype=np.longdouble)
        rows[0], rows[1] = instants, 1
        return Series(rows)


# Motions: latitude, longitude [rad], height [m], roll, pitch, heading [rad] at the time t [s].


def around(c, latitude, longitude, east, north):
    """A place `east` and `north` [m] of another one, along its circles of latitude and longitude."""
    n, lat, lon = c.number, c.number(latitude) * c.pi / 180, c.number(longitude) * c.pi / 180
    return lat + north / n("6.37e6"), lon + east / (n("6.37e6") * c.sin_cos(lat)[1])


def fig8(c, t):
    n = c.number
    w = 2 * c.pi / 130
    sin, cos = c.sin_cos(t * w)
    sin2, cos2 = c.sin_cos(t * (2 * w))
    a, b = n(4500), n(1900)
    ve, vn, ae, an = cos * (a * w), cos2 * (2 * b * w), sin * (-a * w * w), sin2 * (-4 * b * w * w)
    climb = c.sin_cos(t * n("0.1"))
    flutter, _ = c.sin_cos(t * (2 * c.pi))
    speed2 = ve * ve + vn * vn
    bank = (vn * ae - ve * an) / (c.root(speed2) * n("9.8"))
    latitude, longitude = around(c, "40", "116", sin * a, sin2 * b)
    roll = c.atan2(bank, bank * 0 + 1) + flutter * n("3e-4")
    pitch = climb[1] * n("0.08") + flutter * n("5e-4") + n("0.035")
    return latitude, longitude, climb[0] * 150 + 3000, roll, pitch, c.atan2(ve, vn)


def loop(c, t):
    n = c.number
    sin, cos = c.sin_cos(t * n("0.25"))
    latitude, longitude = around(c, "35", "100", sin * 400, sin * (400 * c.root(n(3))))
    zero = sin * 0
    return latitude, longitude, cos * -800 + 4800, zero, t * n("0.25"), zero + c.pi / 6


def scurve(c, t):
    n = c.number
    w, course = n("0.4"), (n("0.34202"), n("0.93969"))
    sin, cos = c.sin_cos(t * w)
    climb = c.sin_cos(t * n("0.1"))
    across, speed = n(49) / (w * w), n(300)
    east = t * (speed * course[0]) + sin * (across * course[1])
    north = t * (speed * course[1]) - sin * (across * course[0])
    ve = cos * (across * w * course[1]) + speed * course[0]
    vn = cos * (-across * w * course[0]) + speed * course[1]
    latitude, longitude = around(c, "20", "10", east, north)
    return latitude, longitude, climb[0] * 160 + 5000, sin * n("1.2"), climb[1] * n("0.05"), c.atan2(ve, vn)


def cone1(c, t):
    n = c.number
    w = 4 * c.pi
    sin, cos = c.sin_cos(t * w)
    vibration = n("0.7") / (w * w)
    along = t * 300 - cos * vibration
    root3 = c.root(n(3))
    latitude, longitude = around(c, "30", "50", along * (root3 / 2), along / 2)
    # The attitude of heading 60 and pitch 2 degrees, turned by a rotation vector of 1 degree in the plane of y and z.
    s, k = c.sin_cos(c.pi / 360)
    zero = sin * 0
    cone = [zero + k, zero, cos * s, sin * -s]
    heading, pitch = zero + c.pi / 3, zero + c.pi / 90
    q = product(quaternion(c, zero, pitch, heading), cone)
    return latitude, longitude, t - sin * vibration + 8000, *angles(c, q)


def polar(c, t):
    """Behind the pole the latitude goes on beyond 90 degrees, and north is the direction of flight; `rows` mends this."""
    n = c.number
    swing, climb, weave = (c.sin_cos(t * n(rate)) for rate in ("0.3", "0.05", "0.2"))
    latitude = (t - 600) * n("3.90625e-5") + c.pi / 2
    height = climb[0] * 200 + 9000
    return latitude, t * 0 + c.pi / 9, height, swing[0] * n("0.1"), swing[0] * n("0.04") + n("0.035"), weave[0] * n("0.05")


def pole_static(c, t):
    zero = t * 0
    degrees = (zero + c.pi / 180 * angle for angle in (90, 0, 5, 2, 30))
    latitude, longitude, roll, pitch, heading = degrees
    return latitude, longitude, zero + 100, roll, pitch, heading


# Name: motion, period [s], number of samples.
MOTIONS = {
    "fig8": (fig8, "0.01", 12001),
    "loop": (loop, "0.01", 6001),
    "scurve": (scurve, "0.01", 6001),
    "cone1": (cone1, "0.01", 3001),
    "polar": (polar, "0.05", 14401),
    "pole_static": (pole_static, "0.01", 1001),
}
# Gyro bias [deg/h] and accelerometer bias [g] of the biased flights, with the signs + - + and + + -.
BIASED = {"fig8": ("0.01", "1e-5"), "loop": ("1", "1e-3")}


def product(p, q):
    (a, b, c, d), (e, f, g, h) = p, q
    return [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def rotated(q, v):
    return product(product(q, [v[0] * 0, *v]), conjugate(q))[1:]


def about(c, axis, angle):
    sin, cos = c.sin_cos(angle * (c.number(1) / 2))
    q = [cos, sin * 0, sin * 0, sin * 0]
    q[axis] = sin
    return q


def quaternion(c, roll, pitch, heading):
    return product(product(about(c, 3, -heading), about(c, 1, pitch)), about(c, 2, roll))


def angles(c, q):
    """Roll, pitch, heading of a quaternion."""
    w, x, y, z = q
    forward = (2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x))
    level = c.root(forward[0] * forward[0] + forward[1] * forward[1])
    roll = c.atan2(2 * (w * y - x * z), w * w - x * x - y * y + z * z)
    return roll, c.atan2(forward[2], level), c.atan2(forward[0], forward[1])


class Earth:
    """WGS 84."""

    def __init__(self, c):
        n, self.c = c.number, c
        self.a, f, self.rate = n("6378137"), 1 / n("298.257223563"), n("7.292115e-5")
        gm = n("3.986004418e14")
        self.e2, self.f = f * (2 - f), f
        self.m = self.rate**2 * self.a**3 * (1 - f) / gm
        # Normal gravity at the equator and k, NIMA TR8350.2, to all their digits.
        self.equator, self.k = n("9.7803253359"), n("0.00193185265241")

    def position(self, sin, cos, longitude, h):
        sin_lon, cos_lon = self.c.sin_cos(longitude)
        normal = self.a / self.c.root(1 - sin * sin * self.e2)
        level = (normal + h) * cos
        return [level * cos_lon, level * sin_lon, (normal * (1 - self.e2) + h) * sin]

    def gravity(self, sin, h):
        sin2 = sin * sin
        root = self.c.root(1 - sin2 * self.e2)
        on_ellipsoid = (1 + sin2 * self.k) * self.equator / root
        return on_ellipsoid * (1 - h * (2 / self.a) * (1 + self.f + self.m - sin2 * (2 * self.f)) + h * h * (3 / self.a**2))


def axes(c, latitude, longitude):
    """East-north-up to Earth-fixed axes: about up by 90 degrees, about y by the colatitude, about z by the longitude."""
    quarter = c.pi / 2
    return product(product(about(c, 3, longitude), about(c, 2, quarter - latitude)), about(c, 3, latitude * 0 + quarter))


def state(c, motion, t):
    """Position, quaternion from body to Earth-fixed axes, gravity; Earth-fixed axes."""
    latitude, longitude, h, roll, pitch, heading = motion(c, t)
    earth = Earth(c)
    sin, cos = c.sin_cos(latitude)
    to_earth = axes(c, latitude, longitude)
    q_eb = product(to_earth, quaternion(c, roll, pitch, heading))
    up = rotated(to_earth, [latitude * 0, latitude * 0, latitude * 0 + 1])
    gravity = earth.gravity(sin, h)
    return earth, earth.position(sin, cos, longitude, h), q_eb, to_earth, [-gravity * axis for axis in up]


def signals(c, motion, t):
    """Angular rate and specific force in body axes, velocity east-north-up."""
    earth, r, q, to_earth, g = state(c, motion, t)
    v = [c.derivative(x) for x in r]
    a = [c.derivative(x) for x in v]
    turned = product(conjugate(q), [c.derivative(x) for x in q])[1:]
    of_earth = rotated(conjugate(q), [r[0] * 0, r[0] * 0, r[0] * 0 + earth.rate])
    rate = [2 * x + y for x, y in zip(turned, of_earth)]
    coriolis = [v[1] * (-2 * earth.rate), v[0] * (2 * earth.rate), v[2] * 0]
    force = rotated(conjugate(q), [x + y - z for x, y, z in zip(a, coriolis, g)])
    return rate, force, rotated(conjugate(to_earth), v)


def rows(name):
    """Series of the motion, and the columns of its truth."""
    motion, period, count = MOTIONS[name]
    c = OfSeries
    t = c.times(np.arange(count) * np.longdouble(period))
    latitude, longitude, h, roll, pitch, heading = (x.rows[0] for x in motion(c, t))
    rate, force, velocity = signals(c, motion, t)
    ve, vn, vu = (x.rows[0] for x in velocity)
    # Beyond the pole.
    beyond = latitude > c.pi / 2
    latitude, longitude = np.where(beyond, c.pi - latitude, latitude), longitude + beyond * c.pi
    heading, ve, vn = heading + beyond * c.pi, np.where(beyond, -ve, ve), np.where(beyond, -vn, vn)
    # Upside down.
    pitch = np.remainder(pitch + c.pi, 2 * c.pi) - c.pi
    over = np.abs(pitch) > c.pi / 2
    pitch = np.where(over, np.sign(pitch) * c.pi - pitch, pitch)
    roll, heading = roll + over * c.pi, np.remainder(heading + over * c.pi, 2 * c.pi)
    columns = [("time_s", t.rows[0], 6), ("latitude_rad", latitude, 16), ("longitude_rad", longitude, 16), ("height_m", h, 11)]
    columns += [(f"velocity_{axis}_m_s", v, 14) for axis, v in zip(("east", "north", "up"), (ve, vn, vu))]
    columns += [("roll_rad", roll, 16), ("pitch_rad", pitch, 16), ("heading_rad", heading, 16)]
    columns += [(f"rate_{axis}_rad_s", x.rows[0], 16) for axis, x in zip("xyz", rate)]
    columns += [(f"force_{axis}_m_s2", x.rows[0], 15) for axis, x in zip("xyz", force)]
    return rate, force, columns


def increments(series, half):
    """Integrals over each half of the intervals: the first one from the sample on, the second one up to the next sample."""
    whole = series.integral(np.zeros(series.rows.shape[1], dtype=np.longdouble))
    behind, before = whole.at(half)[:-1], -whole.at(-half)[1:]
    return np.column_stack([behind, before]).ravel()


def integer(value, decimals):
    return int(Decimal(np.format_float_positional(value, unique=False, precision=24)).scaleb(decimals).to_integral_value())


def varint(n):
    z = n << 1 if n >= 0 else (-n << 1) - 1
    out = bytearray()
    while z >= 128:
        out.append(z & 127 | 128)
        z >>= 7
    out.append(z)
    return bytes(out)


def pack(name, columns):
    blob = bytearray(b"SINSPACK" + struct.pack("<B", len(columns)))
    for column, values, decimals in columns:
        differences, packed = [integer(value, decimals) for value in values], []
        for order in range(9):
            packed.append(b"".join(map(varint, differences)))
            differences = differences[: order + 1] + [b - a for a, b in zip(differences[order:], differences[order + 1 :])]
        order = min(range(9), key=lambda k: len(packed[k]))
        blob += struct.pack("<B", len(column)) + column.encode()
        blob += struct.pack("<BBI", decimals, order, len(values)) + packed[order]
    (FOLDER / f"{name}.packed").write_bytes(blob)


def write(name):
    rate, force, truth = rows(name)
    half = np.longdouble(MOTIONS[name][1]) / 2
    pack(f"{name}_truth", truth)
    parts = [(f"angle_{axis}_rad", increments(x, half), 17) for axis, x in zip("xyz", rate)]
    parts += [(f"velocity_{axis}_m_s", increments(x, half), 16) for axis, x in zip("xyz", force)]
    pack(f"{name}_increments", parts)
    if name in BIASED:
        write_biased(name, rate, force)


class OfNumbers(OfSeries):
    """Functions of extended numbers."""

    atan2 = staticmethod(np.arctan2)


def write_biased(name, rate, force):
    """Navigates with biased sensors, height and vertical velocity held to the truth: extrapolated midpoint rule of order 8."""
    c, n = OfNumbers, np.longdouble
    motion, period, count = MOTIONS[name]
    earth, step = Earth(c), n(period)
    t = OfSeries.times(np.arange(count) * step)
    height = motion(OfSeries, t)[2]
    truth = state(OfSeries, motion, t)
    speeds = signals(OfSeries, motion, t)[2]
    gyro, accel = (n(size) * unit for size, unit in zip(BIASED[name], (c.pi / 180 / 3600, n("9.80665"))))
    inputs = np.stack([x.rows[:ORDER - 3] for x in (*rate, *force, height, height.derivative())])
    bias = np.array([gyro, -gyro, gyro, accel, accel, -accel, 0, 0], dtype=n)[:, None]

    def slope(y, sensed):
        latitude, _, ve, vn, *q = y
        h, vu = sensed[6:]
        sin, cos = c.sin_cos(latitude)
        w2 = 1 - sin * sin * earth.e2
        normal = earth.a / np.sqrt(w2)
        meridian = normal * (1 - earth.e2) / w2
        north, east = vn / (meridian + h), ve / (normal + h)
        up = east * sin / cos
        of_earth = (earth.rate * cos, earth.rate * sin)
        # Rates of east-north-up against inertial space, and with the Earth's rate twice.
        frame = (-north, east + of_earth[0], up + of_earth[1])
        twice = (-north, east + 2 * of_earth[0], up + 2 * of_earth[1])
        f = rotated(q, sensed[3:6])
        turned = product(q, [0, *sensed[:3]])
        framed = product([0, *frame], q)
        return np.array([
            north,
            east / cos,
            f[0] - (twice[1] * vu - twice[2] * vn),
            f[1] - (twice[2] * ve - twice[0] * vu),
            *((x - y) / 2 for x, y in zip(turned, framed)),
        ])

    def stepped(y, k, parts):
        h = step / parts
        at = [sum(inputs[:, p, k] * (h * j) ** p for p in range(inputs.shape[1])) + bias[:, 0] for j in range(parts + 1)]
        before, now = y, y + h * slope(y, at[0])
        for j in range(1, parts):
            before, now = now, before + 2 * h * slope(now, at[j])
        return (before + now + h * slope(now, at[parts])) / 2

    def first(values):
        return np.array([x.rows[0, 0] for x in values])

    latitude, longitude, _, roll, pitch, heading = first(motion(OfSeries, t))
    y = np.array([latitude, longitude, *first(speeds)[:2], *quaternion(c, roll, pitch, heading)])
    lines = []
    for k in range(count):
        if k % round(1 / float(step)) == 0:
            lines.append(compared(c, earth, y, [x.rows[:, k] for x in (height, height.derivative())], truth, speeds, k))
        if k < count - 1:
            table = []
            for row, parts in enumerate((2, 4, 6, 8)):
                table.append([stepped(y, k, parts)])
                for column in range(1, row + 1):
                    ratio = (n(parts) / (2, 4, 6, 8)[row - column]) ** 2 - 1
                    table[row].append(table[row][-1] + (table[row][-1] - table[row - 1][column - 1]) / ratio)
            y = table[-1][-1]
    names = [f"{what}_{axis}_{unit}" for what, unit in (("position", "m"), ("velocity", "m_s"), ("misalignment", "rad"))
             for axis in ("east", "north", "up")]
    text = "# Navigation minus truth by the exact nonlinear equations, height and vertical velocity held to the truth; gyro bias "
    text += f"{BIASED[name][0]} deg/h (+ - +), accelerometer bias {BIASED[name][1]} g (+ + -), axes right-forward-up.\n"
    text += ",".join(["time_s", *names]) + "\n"
    text += "".join(f"{k}," + ",".join(f"{x:.9e}" for x in line) + "\n" for k, line in enumerate(lines))
    (FOLDER / f"{name}_biased_errors.csv").write_text(text)


def compared(c, earth, y, vertical, truth, speeds, k):
    """Position, velocity, misalignment of the solution less those of the truth; east-north-up of the truth."""
    height, climb = (x[0] for x in vertical)
    latitude, longitude, ve, vn, *q_nb = y
    sin, cos = c.sin_cos(latitude)
    to_earth = axes(c, latitude, longitude)
    _, r, q, true_axes, _ = truth
    r, q, true_axes = ([x.rows[0, k] for x in part] for part in (r, q, true_axes))
    velocity = rotated(true_axes, [x.rows[0, k] for x in speeds])
    local = lambda v: rotated(conjugate(true_axes), v)
    turn = product(product(to_earth, q_nb), conjugate(q))
    half = np.arctan2(np.sqrt(sum(x * x for x in turn[1:])), turn[0])
    size = 2 * half / np.sin(half) if half != 0 else 2
    return [
        *local([a - b for a, b in zip(earth.position(sin, cos, longitude, height), r)]),
        *local([a - b for a, b in zip(rotated(to_earth, [ve, vn, climb]), velocity)]),
        *local([-x * size for x in turn[1:]]),
    ]


def check():
    """Rates, forces and increments by numerical differentiation and quadrature of the same motions with 50 digits."""
    import mpmath as mp

    mp.mp.dps = 50

    class OfDigits:
        number, pi, root, atan2 = staticmethod(mp.mpf), mp.pi, staticmethod(mp.sqrt), staticmethod(mp.atan2)

        @staticmethod
        def sin_cos(a):
            return mp.sin(a), mp.cos(a)

    def exact(motion, t):
        earth, _, q, _, g = state(OfDigits, motion, t)

        def differences(part, order):
            count = 3 if part == 1 else 4
            return [mp.diff(lambda s: state(OfDigits, motion, s)[part][k], t, order) for k in range(count)]

        v, a = differences(1, 1), differences(1, 2)
        coriolis = [-2 * earth.rate * v[1], 2 * earth.rate * v[0], 0]
        of_earth = rotated(conjugate(q), [mp.mpf(0), mp.mpf(0), earth.rate])
        turned = product(conjugate(q), differences(2, 1))[1:]
        return [2 * x + y for x, y in zip(turned, of_earth)] + rotated(
            conjugate(q), [x + y - z for x, y, z in zip(a, coriolis, g)]
        )

    for name, (motion, period, count) in MOTIONS.items():
        rate, force, _ = rows(name)
        half = np.longdouble(period) / 2
        parts = [increments(x, half) for x in (*rate, *force)]
        largest = [mp.mpf(0)] * 4
        for k in (0, count // 3, count - 2):
            t, h = mp.mpf(period) * k, mp.mpf(period) / 2
            ours = [mp.mpf(str(x.rows[0, k])) for x in (*rate, *force)]
            sums = [mp.quad(lambda s: exact(motion, s)[i], [t, t + h], maxdegree=3) for i in range(6)]
            for i, (one, other) in enumerate(zip(exact(motion, t), ours)):
                largest[i // 3] = max(largest[i // 3], abs(one - other))
            for i, (one, other) in enumerate(zip(sums, (mp.mpf(str(x[2 * k])) for x in parts))):
                largest[2 + i // 3] = max(largest[2 + i // 3], abs(one - other))
        print(f"{name}: rate {float(largest[0]):.0e} rad/s, force {float(largest[1]):.0e} m/s2,",
              f"increments {float(largest[2]):.0e} rad, {float(largest[3]):.0e} m/s")
        assert largest[0] < 1e-16 and largest[1] < 1e-14 and largest[2] < 1e-18 and largest[3] < 1e-16, name


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        check()
    else:
        for motion_name in MOTIONS:
            write(motion_name)
