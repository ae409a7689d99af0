"""Decodes the words that `sins fly --bus` writes, and compares them with the records of the same flight.

    arinc429.py WORDS.csv RECORDS.csv

The formats are typed from docs/bus.md, not from the library: binary words have their sign in bit 29 and their highest data bit in bit 28;
decimal words have their digits in groups of four bits below bit 29; bit 13 of the word 270 says that the unit navigates.
"""

import csv
import sys

KNOT, FOOT = 1852.0 / 3600.0, 0.3048

# Label: data bits with sign, resolution, whether it is an angle; None: unsigned.
BINARY = {
    "310": (21, 180 / 2**20, True), "311": (21, 180 / 2**20, True), "314": (19, 180 / 2**18, True), "324": (19, 180 / 2**18, True),
    "325": (19, 180 / 2**18, True), "361": (21, 0.125, False), "365": (19, 0.125, False), "366": (19, 2.0**-6, False),
    "367": (19, 2.0**-6, False),
}


def binary(word, bits, resolution):
    field = (word >> (29 - bits)) & (2**bits - 1)
    return (field - 2**bits if field >> (bits - 1) else field) * resolution


def digits(word, *places):
    """Decimal digits: (lowest bit from 1, number of bits)."""
    return [(word >> (lowest - 1)) & (2**bits - 1) for lowest, bits in places]


def degrees_minutes(word):
    hundreds, tens, units, ten_minutes, minutes, tenths = digits(word, (29, 1), (25, 4), (21, 4), (17, 4), (13, 4), (9, 4))
    value = 100 * hundreds + 10 * tens + units + (10 * ten_minutes + minutes + tenths / 10) / 60
    return -value if (word >> 29) & 3 == 3 else value


def heading(word):
    hundreds, tens, units, tenths = digits(word, (27, 2), (23, 4), (19, 4), (15, 4))
    return 100 * hundreds + 10 * tens + units + tenths / 10


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
    compared, worst, navigates = 0, {}, False
    with open(words_path, newline="") as file:
        for row in csv.DictReader(file):
            word, label = int(row["word"], 16), row["label"]
            assert bin(word).count("1") % 2 == 1, row
            assert word & 0xFF == int(label, 8), row
            if label == "270":
                navigates = bool(word >> 12 & 1)
            record = records.get(round(float(row["time_s"]) * 1000))
            if row["status"] != "normal" or record is None or label not in EXPECTED or not navigates:
                continue
            if label in BINARY:
                bits, resolution, is_angle = BINARY[label]
                assert (word >> 29) & 3 == 3, row
                value = binary(word, bits, resolution)
            elif label == "044":
                value, resolution, is_angle = heading(word), 0.1, True
            else:
                value, resolution, is_angle = degrees_minutes(word), 1 / 600, True
            miss = abs(value - EXPECTED[label](record))
            miss = abs((miss + 180) % 360 - 180) if is_angle else miss
            worst[label] = max(worst.get(label, 0), miss / resolution)
            compared += 1
    assert set(worst) == set(EXPECTED), sorted(set(EXPECTED) - set(worst))
    # The records have every digit; half a step, and the rounding of the last one.
    assert all(share <= 0.5001 for share in worst.values()), worst
    print(f"arinc429: {compared} words of {len(worst)} labels are the records to half their resolution")


main(*sys.argv[1:])
