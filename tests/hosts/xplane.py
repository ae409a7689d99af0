"""PI_sins_live.py without X-Plane: its line must have the truth of an aircraft 100 km from the origin of the local axes. The axes of
this file are exact on a sphere: a rotation of Earth-centred ones."""

import importlib.util
import math
import pathlib
import sys
import types

RADIUS = 6378145.0
ORIGIN = (47.0, 8.0)
PLACE = (47.7, 9.1, 3000.0)
EAST_NORTH_UP = (120.0, -160.0, 7.5)
ANGLES = (10.0, -3.0, 143.0)


def axes(latitude, longitude):
    """East, north and up in Earth-centred axes."""
    (s, c), (sl, cl) = ((math.sin(a), math.cos(a)) for a in map(math.radians, (latitude, longitude)))
    return (-sl, cl, 0.0), (-s * cl, -s * sl, c), (c * cl, c * sl, s)


def to_local(vector):
    east, north, up = (sum(v * a for v, a in zip(vector, axis)) for axis in axes(*ORIGIN))
    return east, up, -north


def world_to_local(latitude, longitude, elevation):
    up, origin = axes(latitude, longitude)[2], axes(*ORIGIN)[2]
    return to_local([(RADIUS + elevation) * u - RADIUS * o for u, o in zip(up, origin)])


def main():
    velocity = [sum(v * axis[k] for v, axis in zip(EAST_NORTH_UP, axes(*PLACE[:2]))) for k in range(3)]
    position = "sim/flightmodel/position/"
    values = dict(zip((position + name for name in ("latitude", "longitude", "elevation")), PLACE))
    values |= dict(zip((position + name for name in ("local_vx", "local_vy", "local_vz")), to_local(velocity)))
    values |= dict(zip((position + name for name in ("true_phi", "true_theta", "true_psi")), ANGLES))
    values |= {"sim/time/total_flight_time_sec": 12.5, "sim/time/paused": 0}
    xp = types.SimpleNamespace(findDataRef=str, worldToLocal=world_to_local)
    xp.getDatad = xp.getDataf = xp.getDatai = values.__getitem__
    sys.modules["XPPython3"] = types.SimpleNamespace(xp=xp)
    path = pathlib.Path(__file__).resolve().parents[2] / "c_examples/xplane/PI_sins_live.py"
    spec = importlib.util.spec_from_file_location("plugin", path)
    plugin = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(plugin)
    interface = plugin.PythonInterface()
    interface.XPluginStart()
    sent = []
    interface.socket.close()
    interface.socket = types.SimpleNamespace(sendto=lambda line, to: sent.append(line), close=lambda: None)
    assert interface.frame(0.0, 0.0, 0, None) == -1
    values["sim/time/paused"] = 1
    interface.frame(0.0, 0.0, 0, None)
    found = [float(number) for number in sent[0].decode().split(",")]
    expected = (12.5, *PLACE, *EAST_NORTH_UP, *ANGLES)
    # The ends of an axis are 150 m apart or more; their rounding, three units of 9e-10 m, turns it by 2e-11, its bend by 5e-11.
    assert len(sent) == 1 and all(abs(f - e) < 2e-8 for f, e in zip(found, expected)), (found, expected)
    print(f"X-Plane: {math.hypot(*world_to_local(*PLACE)) / 1e3:.0f} km from the origin, the velocity in local axes "
          f"{[round(v, 1) for v in to_local(velocity)]} m/s arrives as {[round(v, 6) for v in found[4:7]]} east, north, up")


main()
