"""The picture of docs/fmu.md: draw.py ERRORS.csv OUT.svg. The program of docs/fmu.md writes ERRORS.csv."""

import csv
import sys

WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 640, 260, 64, 16, 36
COLOURS = {"errors.position_east_m": ("east", "#0072b2"), "errors.position_north_m": ("north", "#d55e00"),
           "errors.position_up_m": ("up", "#009e73")}

with open(sys.argv[1]) as file:
    rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)][1::100]
values = [row[name] for row in rows for name in COLOURS]
low, high = min(values), max(values)
low, high = 200 * (low // 200), 200 * -(-high // 200)
end_s = 50 * -(-rows[-1]["time_of_solution_s"] // 50)


def x(time_s):
    return LEFT + time_s / end_s * (WIDTH - LEFT - 60)


def y(value):
    return TOP + (high - value) / (high - low) * (HEIGHT - TOP - BOTTOM)


svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
       f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
for value in range(int(low), int(high) + 1, 200):
    svg.append(f'<path d="M{LEFT} {y(value):.1f}H{x(end_s):.1f}" stroke="#ddd"/>'
               f'<text x="{LEFT - 6}" y="{y(value) + 4:.1f}" text-anchor="end">{value}</text>')
for time_s in range(0, int(end_s) + 1, 50):
    svg.append(f'<text x="{x(time_s):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{time_s}</text>')
for name, (label, colour) in COLOURS.items():
    points = " ".join(f"{x(row['time_of_solution_s']):.1f},{y(row[name]):.1f}" for row in rows)
    svg.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"/>'
               f'<text x="{x(end_s) + 6:.1f}" y="{y(rows[-1][name]) + 4:.1f}" fill="{colour}">{label}</text>')
svg.append(f'<text x="{(LEFT + x(end_s)) / 2:.0f}" y="{HEIGHT - 4}" text-anchor="middle">time [s]</text>'
           f'<text x="14" y="{(TOP + HEIGHT - BOTTOM) / 2:.0f}" text-anchor="middle" transform="rotate(-90 14 '
           f'{(TOP + HEIGHT - BOTTOM) / 2:.0f})">position error [m]</text></svg>')
with open(sys.argv[2], "w") as file:
    file.write("\n".join(svg) + "\n")
