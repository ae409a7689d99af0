#!/usr/bin/env python3
"""Packs columns of a CSV of smooth signals into a few percent of their size, for the tests.

usage: pack.py OUTPUT.packed INPUT.csv COLUMN:DECIMALS [COLUMN:DECIMALS ...]

Each column is rounded to a fixed number of decimals and written as variable-length differences of the order that packs
best. Format, all integers little endian: "SINSPACK", u8 number of columns; for each: u8 length and name, u8 decimals,
u8 order d, u32 number of values, then one variable-length integer (7 bits a byte, low first, zigzag) for each value: value i
as its backward difference of order min(i, d). `tests/support/mod.rs` reads it.
"""

import struct
import sys
from decimal import Decimal


def varint(n):
    z = n << 1 if n >= 0 else (-n << 1) - 1
    out = bytearray()
    while z >= 128:
        out.append(z & 127 | 128)
        z >>= 7
    out.append(z)
    return bytes(out)


def differences(values, order):
    d = list(values)
    for k in range(order):
        d = d[: k + 1] + [d[i] - d[i - 1] for i in range(k + 1, len(d))]
    return d


def main():
    output, source, *columns = sys.argv[1:]
    lines = [line.strip().split(",") for line in open(source) if line.strip() and not line.startswith("#")]
    header, rows = lines[0], lines[1:]
    blob = bytearray(b"SINSPACK" + struct.pack("<B", len(columns)))
    for column in columns:
        name, decimals = column.split(":")
        scale = Decimal(10) ** int(decimals)
        values = [int((Decimal(row[header.index(name)]) * scale).to_integral_value()) for row in rows]
        packed = [b"".join(map(varint, differences(values, order))) for order in range(9)]
        order = min(range(9), key=lambda k: len(packed[k]))
        blob += struct.pack("<B", len(name)) + name.encode()
        blob += struct.pack("<BBI", int(decimals), order, len(values)) + packed[order]
    open(output, "wb").write(blob)


main()
