"""Decodes the words that `sins fly --bus` writes, and compares them with the records of the same flight.

    arinc429.py WORDS.csv RECORDS.csv

The formats are typed from the table of a unit's manual as docs/bus.md names it, not from the library. Bit 13 of the word 270 says that the
unit navigates.
"""

import csv
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


DEG = 180 / 3.141592653589793
EXPECTED = {
    "310": lambda r: r["navigation_latitude_rad"] * DEG, "010": lambda r: r["navigation_latitude_rad"] * DEG,
    "311": lambda r: r["navigation_longitude_rad"] * DEG, "011": lambda r: r["navigation_longitude_rad"] * DEG,
    "314": lambda r: r["navigation_heading_rad"] * DEG, "044": lambda r: r["navigation_heading_rad"] * DEG,
    "324": lambda r: r["navigation_pitch_rad"] * DEG, "325": lambda r: r["navigation_roll_rad"] * DEG,
    "361": lambda r: r["navigation_height_m"] / FOOT, "365": lambda r: r["navigation_velocity_up_m_s"] * 60 / FOOT,
    "366": lambda r: r["navigation_velocity_north_m_s"] / KNOT, "367": lambda r: r["navigation_velocity_east_m_s"] / KNOT,
}


def main(words_path, records_path):
    with open(records_path, newline="") as file:
        records = {round(float(row["time_s"]) * 1000): {key: float(value) for key, value in row.items()} for row in csv.DictReader(file)}
    compared, worst, seen, navigates = 0, {}, set(), False
    with open(words_path, newline="") as file:
        for row in csv.DictReader(file):
            word, label = int(row["word"], 16), row["label"]
            assert bin(word).count("1") % 2 == 1, row
            assert word & 0xFF == int(label, 8), row
            if label == "270":
                navigates = bool(word >> 12 & 1)
            if row["status"] != "normal" or label == "270":
                continue
            value, resolution = decoded(label, word)
            seen.add(label)
            # The program writes as many digits as the resolution has.
            assert abs(value - float(row["value"])) <= 0.51 * resolution, (row, value)
            record = records.get(round(float(row["time_s"]) * 1000))
            if record is None or label not in EXPECTED or not navigates:
                continue
            miss = abs(value - EXPECTED[label](record))
            miss = abs((miss + 180) % 360 - 180) if row["unit"] == "deg" else miss
            worst[label] = max(worst.get(label, 0), miss / resolution)
            compared += 1
    assert set(worst) == set(EXPECTED), sorted(set(EXPECTED) - set(worst))
    # The records have every digit; half a step, and the rounding of the last one.
    assert all(share <= 0.5001 for share in worst.values()), worst
    # Wind and magnetic variation are inputs that the program does not have.
    assert seen == (set(BINARY) | set(DECIMAL)) - {"315", "316", "317", "320", "014", "015", "016"}, sorted(seen)
    print(f"arinc429: {compared} words of {len(worst)} labels are the records to half their resolution; {len(seen)} labels decoded")


main(*sys.argv[1:])
