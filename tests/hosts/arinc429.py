"""Decodes ARINC 429 words and compares every label with what it must show.

    arinc429.py WORDS.csv RECORDS.csv IMU.csv [UNIT.csv]   words of `sins fly --bus`, with the other files of the same flight
    arinc429.py                                            words of sins_bus_words for random states, with wind and magnetic variation

The formats are typed from the table of a unit's manual as docs/bus.md names it, the quantities from their definitions; nothing is from
the library. The axes of IMU.csv are right-forward-up.
"""

import csv
import math
import random
import sys

KNOT, FOOT = 1852.0 / 3600.0, 0.3048

# Label: lowest bit from 1, number of bits, resolution, whether the highest bit is a sign.
ANGLE, RATE, FORCE = (11, 19, 180 / 2**18, True), (11, 19, 2.0**-11, True), (11, 19, 2.0**-16, True)
BINARY = {
    "310": (9, 21, 180 / 2**20, True), "311": (9, 21, 180 / 2**20, True), "312": (11, 18, 2.0**-6, False), "315": (11, 19, 2.0**-10, True),
    "335": (11, 19, 2.0**-13, True), "360": (11, 19, 0.125, True), "361": (9, 21, 0.125, True), "365": (11, 19, 0.125, True),
    "366": (11, 19, 2.0**-6, True), "367": (11, 19, 2.0**-6, True), "370": (11, 19, 2.0**-15, True), "126": (14, 15, 1.0, False),
    **{label: ANGLE for label in ("313", "314", "316", "317", "320", "321", "322", "324", "325")},
    **{label: RATE for label in ("326", "327", "330", "336", "337")},
    **{label: FORCE for label in ("323", "331", "332", "333", "362", "363", "364", "375", "376")},
}

# Label: resolution, and the digits: lowest bit from 1, number of bits, weight.
PLACE = (1 / 600, ((29, 1, 100), (25, 4, 10), (21, 4, 1), (17, 4, 10 / 60), (13, 4, 1 / 60), (9, 4, 0.1 / 60)))
TENTHS = (0.1, ((27, 2, 100), (23, 4, 10), (19, 4, 1), (15, 4, 0.1)))
WHOLE = (1.0, ((27, 2, 100), (23, 4, 10), (19, 4, 1)))
DECIMAL = {
    "010": PLACE, "011": PLACE, "012": (1.0, ((27, 3, 1000), (23, 4, 100), (19, 4, 10), (15, 4, 1))), "013": TENTHS, "014": TENTHS,
    "044": TENTHS, "015": WHOLE, "016": WHOLE, "007": (0.1, ((23, 4, 1), (19, 4, 0.1))), "351": (0.1, ((19, 4, 1), (15, 4, 0.1))),
}


def field(word, lowest, bits):
    return (word >> (lowest - 1)) & (2**bits - 1)


def decoded(label, word):
    """Value and resolution of a word with a normal status."""
    status = field(word, 30, 2)
    if label in BINARY:
        assert status == 3, f"{word:08x}"
        lowest, bits, resolution, is_signed = BINARY[label]
        count = field(word, lowest, bits)
        return (count - 2**bits if is_signed and count >> (bits - 1) else count) * resolution, resolution
    assert status in (0, 3), f"{word:08x}"
    resolution, places = DECIMAL[label]
    digits = [field(word, lowest, bits) for lowest, bits, _ in places]
    assert max(digits) <= 9, f"{word:08x}"
    value = sum(digit * weight for digit, (*_, weight) in zip(digits, places))
    return -value if status == 3 else value, resolution


# Range of the quantity, where it is not that of the number. 041 to 043 are inputs, with the digits of 010, 011 and 016.
DECIMAL |= {"041": PLACE, "042": PLACE, "043": WHOLE}
INPUT_LABELS = {"041", "042", "043"}
RANGE = {
    **{label: (-90, 90) for label in ("310", "322", "324", "010", "041")}, "011": (-180, 180), "042": (-180, 180),
    **{label: (0, 360) for label in ("013", "014", "044", "016", "043")}, **{label: (0, math.inf) for label in ("312", "315", "012", "015", "007", "351", "126")},
}


def legal(label, word):
    """Whether a word with a normal status says what the quantity can be."""
    if label in BINARY:
        # A number without a sign has 0 in bit 29.
        value, is_legal = decoded(label, word)[0], BINARY[label][3] or field(word, 29, 1) == 0
    else:
        digits = [field(word, lowest, bits) for lowest, bits, _ in DECIMAL[label][1]]
        if max(digits) > 9 or (DECIMAL[label] is PLACE and digits[3] > 5):
            return False
        value, is_legal = decoded(label, word)[0], True
    low, high = RANGE.get(label, (-math.inf, math.inf))
    return is_legal and low <= value <= high


DEGREES = math.degrees(1.0)
GRAVITY = 9.80665


def to_vehicle(vector):
    """Right-forward-up to forward-right-down."""
    return vector[1], vector[0], -vector[2]


def accelerations(s):
    """Acceleration north, east, up [m/s2]: the specific force, turned by roll, pitch and heading, with standard gravity."""
    (x, y, z), (roll, pitch, heading) = s["force"], s["angles"]
    y, z = y * math.cos(roll) - z * math.sin(roll), y * math.sin(roll) + z * math.cos(roll)
    x, z = x * math.cos(pitch) + z * math.sin(pitch), z * math.cos(pitch) - x * math.sin(pitch)
    north, east = x * math.cos(heading) - y * math.sin(heading), x * math.sin(heading) + y * math.cos(heading)
    return north, east, -z - GRAVITY


def quantities(s):
    """What each label must show, from latitude and longitude [rad], height [m], velocity north, east, up, angles roll, pitch, heading,
    rate and force forward, right, down, wind, variation, and the times of the unit [s]."""
    (north, east, up), (roll, pitch, heading) = s["velocity"], s["angles"]
    a_north, a_east, a_up = accelerations(s)
    (p, q, r), (fx, fy, fz) = s["rate"], s["force"]
    speed = math.hypot(north, east)
    is_fast = speed >= 50 * KNOT
    track = math.atan2(east, north) if is_fast else heading
    along = {name: a_north * math.cos(angle) + a_east * math.sin(angle) for name, angle in (("track", track), ("heading", heading))}
    across = {name: a_east * math.cos(angle) - a_north * math.sin(angle) for name, angle in (("track", track), ("heading", heading))}
    work = north * a_north + east * a_east + up * a_up
    magnetic = [(angle - s["variation"]) * DEGREES for angle in (track, heading)]
    latitude, longitude = s["latitude"] * DEGREES, s["longitude"] * DEGREES
    return {
        "310": latitude, "010": latitude, "311": longitude, "011": longitude, "312": speed / KNOT, "012": speed / KNOT,
        "313": track * DEGREES, "013": track * DEGREES, "314": heading * DEGREES, "044": heading * DEGREES,
        "315": s["wind"][0] / KNOT, "015": s["wind"][0] / KNOT, "316": s["wind"][1] * DEGREES, "016": s["wind"][1] * DEGREES,
        "317": magnetic[0], "320": magnetic[1], "014": magnetic[1], "321": (track - heading) * DEGREES,
        "322": math.atan2(up, speed) * DEGREES, "323": work / math.hypot(speed, up) / GRAVITY if s["velocity"] != (0, 0, 0) else 0.0,
        "324": pitch * DEGREES, "325": roll * DEGREES, "326": q * DEGREES, "327": p * DEGREES, "330": r * DEGREES,
        "331": fx / GRAVITY, "332": fy / GRAVITY, "333": -fz / GRAVITY, "370": -fz / GRAVITY,
        "335": (a_east * north - a_north * east) / speed**2 * DEGREES if is_fast else 0.0,
        "336": (q * math.cos(roll) - r * math.sin(roll)) * DEGREES,
        "337": (p + math.tan(pitch) * (q * math.sin(roll) + r * math.cos(roll))) * DEGREES,
        "360": (up + work / GRAVITY) * 60 / FOOT, "361": s["height"] / FOOT,
        "362": along["track"] / GRAVITY, "363": across["track"] / GRAVITY, "364": a_up / GRAVITY, "365": up * 60 / FOOT,
        "366": north / KNOT, "367": east / KNOT, "375": along["heading"] / GRAVITY, "376": across["heading"] / GRAVITY,
        "007": s["to_go"] / 60, "351": s["to_go"] / 60, "126": s["in_navigation"] / 60,
    }


ANGLES = {"310", "311", "010", "011", "313", "314", "013", "014", "044", "016", "316", "317", "320", "321", "322", "324", "325"}


class Comparison:
    """Words against what they must show."""

    def __init__(self):
        self.worst, self.compared = {}, 0

    def add(self, label, value, resolution, expected):
        if label not in ANGLES:
            if label in BINARY:
                _, bits, _, is_signed = BINARY[label]
                low, high = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if is_signed else (0, 2**bits - 1)
            else:
                low, high = 0, sum((9 if bits == 4 else 2**bits - 1) * weight for _, bits, weight in DECIMAL[label][1]) / resolution
            expected = min(max(expected, low * resolution), high * resolution)
        miss = abs(value - expected)
        if label in ANGLES:
            assert label not in ("013", "014", "044", "016") or 0 <= value < 360, (label, value)
            miss = abs((miss + 180) % 360 - 180)
        # The ninth digit of the value is the rounding of its text and of this computation.
        share = (miss - 1e-9 * abs(expected)) / resolution
        self.worst[label] = max(self.worst.get(label, 0), share)
        self.compared += 1

    def report(self, labels):
        assert set(self.worst) == set(labels), sorted(set(labels) ^ set(self.worst))
        assert all(share <= 0.5001 for share in self.worst.values()), self.worst
        print(f"arinc429: {self.compared} words of {len(self.worst)} labels show what they must to half their resolution")


def rows(path):
    with open(path, newline="") as file:
        yield from csv.DictReader(file)


def milliseconds(row):
    return round(float(row["time_s"]) * 1000)


def states(records_path, imu_path, unit_path=None):
    """The state at each record, by its time [ms]. Without a file of the unit, it navigates from 0 s on."""
    records = {milliseconds(row): row for row in rows(records_path)}
    sums = {}
    for row in rows(imu_path):
        # A part may end before its update: its time is that of the last one.
        end = round((float(row["time_s"]) + float(row["update_s"]) * (1 - int(row["part"]) / int(row["parts"]))) * 1000)
        if end in records:
            parts = sums.setdefault(end, [0.0] * 6)
            for k, name in enumerate(f"{kind}_{axis}" for kind in ("angle_increment", "velocity_increment") for axis in "xyz"):
                parts[k] += float(row[name + ("_rad" if k < 3 else "_m_s")]) / float(row["update_s"])
    found, since = {}, None
    navigates = ({"time_s": time / 1000, "state": "navigation", "to_go_s": 0} for time in sorted(records))
    for row in rows(unit_path) if unit_path else navigates:
        time = milliseconds(row)
        since = (time if since is None else since) if row["state"] == "navigation" else None
        if time not in records or time not in sums:
            continue
        value = {name.removeprefix("navigation_"): float(text) for name, text in records[time].items() if name.startswith("navigation_")}
        found[time] = {
            "navigates": since is not None, "height": value["height_m"],
            "latitude": value["latitude_rad"], "longitude": value["longitude_rad"],
            "velocity": tuple(value[f"velocity_{name}_m_s"] for name in ("north", "east", "up")),
            "angles": tuple(value[f"{name}_rad"] for name in ("roll", "pitch", "heading")),
            "rate": to_vehicle(sums[time][:3]), "force": to_vehicle(sums[time][3:]),
            "wind": (0.0, 0.0), "variation": 0.0, "to_go": float(row["to_go_s"]),
            "in_navigation": 0.0 if since is None else (time - since) / 1000,
        }
    return found


INPUTS = {"315", "316", "317", "320", "014", "015", "016"}
TIMES = {"007", "351"}


def of_flight(words_path, *paths):
    found, comparison, seen = states(*paths), Comparison(), set()
    for row in rows(words_path):
        word, label = int(row["word"], 16), row["label"]
        assert bin(word).count("1") % 2 == 1, row
        assert word & 0xFF == int(label, 8), row
        if row["status"] != "normal" or label == "270":
            continue
        value, resolution = decoded(label, word)
        seen.add(label)
        # The program writes as many digits as the resolution has.
        assert abs(value - float(row["value"])) <= 0.51 * resolution, (row, value)
        state = found.get(milliseconds(row))
        if state and (state["navigates"] or label in TIMES):
            comparison.add(label, value, resolution, quantities(state)[label])
    assert not seen & INPUTS, "the program has no wind and no magnetic variation"
    comparison.report((set(BINARY) | set(DECIMAL)) - INPUTS - INPUT_LABELS)


def of_states():
    """Every label for random states, those beyond the range of a word, too."""
    from sins import c as sins

    draw, comparison = random.Random(429), Comparison()
    status, navigation, inputs = sins.unit_status(), sins.unit_navigation(), sins.bus_inputs()
    words = (sins.bus_word * 4000)(*(sins.bus_word() for _ in range(4000)))
    for trial in range(400):
        scale = 10 ** draw.uniform(-2, 0.5)
        vector = lambda size: tuple(draw.uniform(-size, size) * scale for _ in range(3))
        state = {
            "latitude": draw.uniform(-1, 1) * math.pi / 2, "longitude": draw.uniform(-1, 1) * math.pi, "height": draw.uniform(-500, 30000),
            "velocity": vector(300.0), "rate": vector(1.0), "force": vector(40.0), "variation": draw.uniform(-1, 1) * math.pi,
            "angles": (draw.uniform(-3.1, 3.1), draw.uniform(-1.5, 1.5), draw.uniform(0, 6.28)),
            "wind": (draw.uniform(0, 200), draw.uniform(0, 6.28)), "to_go": draw.uniform(0, 590), "in_navigation": draw.uniform(0, 2e5),
        }
        north, east, up = state["velocity"]
        status.state = sins.UNIT_STATE_NAVIGATION
        status.validity = navigation.validity = 31
        status.to_go_s, status.in_navigation_s = state["to_go"], state["in_navigation"]
        navigation.latitude_rad, navigation.longitude_rad = state["latitude"], state["longitude"]
        navigation.height_m = state["height"]
        navigation.velocity_enu_m_s[:] = east, north, up
        navigation.roll_rad, navigation.pitch_rad, navigation.heading_rad = state["angles"]
        navigation.angular_rate_rad_s[:] = to_vehicle(state["rate"])
        navigation.specific_force_m_s2[:] = to_vehicle(state["force"])
        inputs.flags = sins.BUS_WIND | sins.BUS_MAGNETIC_VARIATION
        inputs.wind_speed_m_s, inputs.wind_direction_rad = state["wind"]
        inputs.magnetic_variation_rad = state["variation"]
        count = sins.bus_words(status, navigation, inputs, 0.0, 0.5, words)
        expected = quantities(state)
        for word in words[:count]:
            label = f"{word.label:03o}"
            assert bin(word.word).count("1") % 2 == 1 and word.word & 0xFF == word.label
            if label != "270":
                value, resolution = decoded(label, word.word)
                comparison.add(label, value, resolution, expected[label])
    comparison.report((set(BINARY) | set(DECIMAL)) - INPUT_LABELS)


def of_words():
    """Random words of every label: legal or not, and the value of those that are."""
    from sins import c as sins

    draw, found, illegal = random.Random(310), sins.bus_label(), 0
    labels = sorted(set(BINARY) | set(DECIMAL))
    for trial in range(40_000):
        label = labels[trial % len(labels)]
        status = 3 if label in BINARY else draw.choice((0, 3))
        word = draw.getrandbits(31) & ~0x600000FF | status << 29 | int(label, 8)
        word |= (bin(word).count("1") + 1) % 2 << 31
        sins.bus_decode(word, 0, found)
        if legal(label, word):
            value, resolution = decoded(label, word)
            assert found.status == sins.BUS_NORMAL and abs(found.value - value) < 1e-6 * resolution, (label, hex(word), found.value)
        else:
            assert found.status == sins.BUS_ILLEGAL_VALUE and math.isnan(found.value), (label, hex(word), found.value)
            illegal += 1
    print(f"arinc429: {trial + 1} random words, {illegal} of them illegal")


if len(sys.argv) > 1:
    of_flight(*sys.argv[1:])
else:
    of_states()
    of_words()
