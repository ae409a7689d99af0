"""X-Plane sends the truth of each frame to `sins live --format generic`: a plugin of XPPython3, in Resources/plugins/PythonPlugins."""

import math
import socket

from XPPython3 import xp

TO = ("127.0.0.1", 5500)
PLACE = ("latitude", "longitude", "elevation")
VELOCITY = ("local_vx", "local_vy", "local_vz")
ANGLES = ("true_phi", "true_theta", "true_psi")


class PythonInterface:
    def XPluginStart(self):
        names = {name: f"sim/flightmodel/position/{name}" for name in (*PLACE, *VELOCITY, *ANGLES)}
        names.update(time="sim/time/total_flight_time_sec", paused="sim/time/paused")
        self.refs = {name: xp.findDataRef(path) for name, path in names.items()}
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        return "sins live", "sins.live", "Sends the truth of each frame by UDP"

    def XPluginEnable(self):
        self.loop = xp.createFlightLoop(self.frame, phase=xp.FlightLoop_Phase_AfterFlightModel)
        xp.scheduleFlightLoop(self.loop, -1)
        return 1

    def XPluginDisable(self):
        xp.destroyFlightLoop(self.loop)

    def XPluginStop(self):
        self.socket.close()

    def frame(self, since_last, elapsed, counter, reference):
        if not xp.getDatai(self.refs["paused"]):
            self.socket.sendto(self.line().encode(), TO)
        return -1  # again in the next frame

    def line(self):
        place = [xp.getDatad(self.refs[name]) for name in PLACE]
        local = [xp.getDataf(self.refs[name]) for name in VELOCITY]
        angles = [xp.getDataf(self.refs[name]) for name in ANGLES]
        # East, north and up at the aircraft: X-Plane's local axes have these directions only where the scenery was loaded.
        axes = (axis(place, 1, 1e-3), axis(place, 0, 1e-3), axis(place, 2, 100.0))
        velocity = (sum(v * a for v, a in zip(local, direction)) for direction in axes)
        return ",".join(map(repr, (xp.getDataf(self.refs["time"]), *place, *velocity, *angles)))


def axis(place, coordinate, step):
    """The direction in local axes in which a coordinate of a place (latitude, longitude [deg], elevation [m]) grows."""
    ends = ([value + sign * step * (k == coordinate) for k, value in enumerate(place)] for sign in (1, -1))
    way = [after - before for after, before in zip(*(xp.worldToLocal(*end) for end in ends))]
    return [part / math.hypot(*way) for part in way]
