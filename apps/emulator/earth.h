/* Ways on the ellipsoid of WGS 84. Nothing here needs Windows. */
#pragma once
#include <cmath>

/* Radii of curvature at a latitude [m]: M = a (1 - e2) / w3 and N = a / w with w2 = 1 - e2 sin2(latitude). */
struct Radii {
    double meridian_m, normal_m;
    explicit Radii(double latitude_rad) {
        const double A = 6378137, E2 = 6.6943799901413e-3, sin = std::sin(latitude_rad), w2 = 1 - E2 * sin * sin;
        normal_m = A / std::sqrt(w2);
        meridian_m = A * (1 - E2) / (w2 * std::sqrt(w2));
    }
};
