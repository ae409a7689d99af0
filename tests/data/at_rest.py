#!/usr/bin/env python3
"""Prints the fixture of `tests/physics/simulation2.rs`: the errors of an INS at rest, by 50-digit arithmetic (mpmath).

On a sphere of radius R, psi' = -w x psi - eps, r'' = nabla + g up x psi - 2 w_up up x r' - g/R r, level channels only;
psi east-north-up [rad], r east and north [m], w the Earth rate. phi = psi + (-rN, rE, rE tan(latitude))/R. The matrix exponential
solves it, which shares nothing with the closed form under test.
"""

from mpmath import expm, matrix, mp, mpf, pi, sin, cos, tan

mp.dps = 50
DEG = pi / 180
W, R, G = mpf("7.292115e-5"), mpf(6374390), mpf("9.8015")
EPS, NABLA = mpf("0.01") * DEG / 3600, mpf("1e-5") * mpf("9.80665")
LATITUDE = mpf("39.9") * DEG

north, up = W * cos(LATITUDE), W * sin(LATITUDE)
# psiE, psiN, psiU, rE, rN, vE, vN, 1
F = matrix(8, 8)
for row, terms in [
    (0, {1: up, 2: -north, 7: -EPS}),
    (1, {0: -up, 7: -EPS}),
    (2, {0: north, 7: -EPS}),
    (3, {5: 1}),
    (4, {6: 1}),
    (5, {1: -G, 3: -G / R, 6: 2 * up, 7: NABLA}),
    (6, {0: G, 4: -G / R, 5: -2 * up, 7: NABLA}),
]:
    for column, value in terms.items():
        F[row, column] = value

for hours in (1, 48):
    x = expm(F * hours * 3600)[:, 7]
    phi = (x[0] - x[4] / R, x[1] + x[3] / R, x[2] + x[3] * tan(LATITUDE) / R)
    print(f"{hours} h: phi", *(mp.nstr(value / DEG * 3600, 6) for value in phi), "arcsec; velocity",
          *(mp.nstr(x[k], 6) for k in (5, 6)), "m/s; position", *(mp.nstr(x[k], 8) for k in (3, 4)), "m")
