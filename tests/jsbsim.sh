#!/usr/bin/env bash
# A live flight simulator as host: builds c_examples/jsbsim, flies its script, and checks the results of the INS.
# SINS_LIB_DIR: as in c_examples/jsbsim/build.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

status=0
c_examples/jsbsim/build.sh || status=$?
if [ "$status" -eq 2 ]; then
    could_not "JSBSim" "its source distribution cannot be had from PyPI"
    report_not_run
    exit 0
fi
[ "$status" -eq 0 ]

out=target/jsbsim/out
mkdir -p "$out"
perfect="ins/grade=0 ins/pauses=0 ins/slews=0 ins/replays=0 ins/gyro-failure=0"

# fly NAME [PROPERTY=VALUE]...: writes NAME.csv, NAME_truth.csv and the host's messages. No sample may be rejected.
fly() {
    local name=$1
    shift
    target/jsbsim/host target/jsbsim/source c_examples/jsbsim/flight.xml "$out/$name" "$@" >"$out/$name.txt"
    grep -q ', 0 samples refused$' "$out/$name.txt" || fail "$name: samples were refused, see $out/$name.txt"
}

fail() {
    echo "jsbsim: $*" >&2
    exit 1
}

# closed NAME: with perfect sensors, the INS agrees with the truth within the sum of
# - the difference of JSBSim's velocities and positions: the positions are third-order Adams-Bashforth sums of the velocities. The
#   sum has an error of 3/8 h d2 at each end, where d2 is the largest second difference of the velocities;
# - the norm of JSBSim's quaternions, which is 1 to 1e-10. Velocities depend on its fourth power: 4e-10 of the path;
# - the effect of a misalignment phi on gravity, g phi t^2 / 2, which is the error of the INS itself. phi must stay below a
#   thousandth of the drift of the best grade of gyros, 0.001 deg/h.
closed() {
    awk -F, -v name="$1" '
        function length3(a, b, c) { return sqrt(a * a + b * b + c * c) }
        function larger(a, b) { return a > b ? a : b }
        FNR == 1 { file++; next }
        file == 1 {
            if (FNR == 2) start = $1
            if (FNR > 2) path += length3($5, $6, $7) * (h = $1 - end)
            if (FNR > 3) d2 = larger(d2, length3($5 - 2 * e1 + e2, $6 - 2 * n1 + n2, $7 - 2 * u1 + u2))
            end = $1; e2 = e1; n2 = n1; u2 = u1; e1 = $5; n1 = $6; u1 = $7
        }
        file == 2 {
            found = larger(found, length3($5, $6, $7))
            phi = larger(phi, length3($11, $12, $13))
        }
        END {
            t = end - start
            bound = 2 * 3 / 8 * h * d2 + 4e-10 * path + 9.80665 * phi * t * t / 2
            drift = 0.001 * 3.14159265 / 180 / 3600 * t
            printf "%s: %.0f s, %.1f km: %.2g m of %.2g m, %.2g rad of %.2g rad\n", name, t, path / 1000, found, bound,
                phi, drift / 1000
            exit !(found > 0 && found < bound && phi > 0 && phi < drift / 1000)
        }' "$out/$1_truth.csv" "$out/$1.csv" || fail "$1 does not close"
}

# force NAME J2: JSBSim's specific force equals that of perfect accelerometers, except for the difference of two gravity models.
# This difference is the J2 that the flight switches off in JSBSim, at 29.44 degrees of geocentric latitude, and J4, which JSBSim
# lacks: at most 5 J4 g (a/r)^4 = 1.2e-4 m/s2, at a pole. A wrong axis, sign or unit would give errors of metres per second squared.
force() {
    awk -v name="$1" -v j2="$2" '/^JSBSim.s force m\/s2 / {
        latitude = 29.44 * 3.14159265 / 180
        north = -9.79 * 3 * j2 * sin(latitude) * cos(latitude)
        up = -9.79 * 1.5 * j2 * (1 - 3 * sin(latitude) ^ 2)
        off = sqrt($4 * $4 + ($5 - north) ^ 2 + ($6 - up) ^ 2)
        printf "%s: force %.2g m/s2, expected %.2g m/s2, off by %.2g of 1.2e-4 m/s2\n", name, sqrt($5 * $5 + $6 * $6),
            sqrt(north * north + up * up), off
        good = off < 1.2e-4
    } END { exit !good }' "$out/$1.txt" || fail "$1: JSBSim's force is not that of the INS"
}

# Burning fuel moves the centre of gravity. On the ground JSBSim moves its position by this amount without a velocity.
echo "== perfect sensors close on the truth, from the air, from the ground, and in a gravity without J2"
fly air $perfect ins/start-s=60
closed air
force air 0
fly ground $perfect propulsion/fuel_freeze=1
closed ground
fly round_earth $perfect propulsion/fuel_freeze=1 simulation/gravity-model=0
closed round_earth
force round_earth 1.08263e-3

echo "== pause, slew, snapshot and a gyro's failure"
fly all
grep -q 'paused for 5 s' "$out/all.txt" || fail "there was no pause"
grep -q '3000 frames again, to the same bits' "$out/all.txt" || fail "the flight from the snapshot has other bits"

fly no_pause ins/pauses=0
cmp "$out/all.csv" "$out/no_pause.csv" || fail "the pause changed the flight"

start=$(date +%s%N)
fly fast ins/pace=60
milliseconds=$((($(date +%s%N) - start) / 1000000))
cmp "$out/all.csv" "$out/fast.csv" || fail "the pace changed the flight"
echo "615 s in $milliseconds ms, at pace 60"
[ "$milliseconds" -ge $((615000 / 60)) ] || fail "the flight is faster than its pace"

# The truth of a flight without a slew is a flight log. The C host of the other examples flies it to the same bits.
fly log ins/slews=0 ins/gyro-failure=0
cat >"$out/log.toml" <<'SCENE'
[flight]
file = "log_truth.csv"
[gyro]
preset = "navigation"
[accelerometer]
preset = "navigation"
[options]
axes = "frd"
sample_period_s = 0.01
SCENE
cc -O2 -Iinclude c_examples/harness.c -o target/jsbsim/harness -Ltarget/jsbsim -l:libsins.so.1 '-Wl,-rpath,$ORIGIN' -lm
cmp <(target/jsbsim/harness "$out/log.toml" | awk '/^(position m|velocity m.s|misalignment rad) / { print $4 }') \
    <(tail -n 1 "$out/log.csv" | cut -d, -f 5-13 | tr , '\n') || fail "the log of the flight has other bits"
echo "the log of the flight: the same bits"

# The truth moves by 5 km in one frame, and the error stays the same. In the other 99 frames of this second the error of position
# grows by the error of velocity. The altimeter also changes the error of height, which is not checked.
awk -F, '
    function size(x) { return x < 0 ? -x : x }
    $1 > 199 && $1 < 200 { longitude = $3; for (i = 5; i < 11; i++) before[i] = $i }
    $1 > 200 && $1 < 201 {
        moved = ($3 - longitude) * 6378137
        for (i = 5; i < 7; i++) {
            step = size($i - before[i] - (before[i + 3] + $(i + 3)) / 2 * 0.99)
            bad += step > size($(i + 3) - before[i + 3])
            largest = step > largest ? step : largest
        }
    }
    END {
        printf "slewed by %.0f m: the error of position goes on by its velocity to %.1g m\n", moved, largest
        exit !(moved > 4000 && !bad)
    }' "$out/all.csv" || fail "the slew changed the error"

# A step b of the yaw gyro for T turns the INS by b cos(roll) cos(pitch) T about the vertical, except for its square and for the
# effect of the Earth's rotation.
fly sound ins/gyro-failure=0
cmp <(awk -F, '$1 < 400' "$out/all.csv") <(awk -F, '$1 < 400' "$out/sound.csv") || fail "the failure begins too early"
awk -F, '
    FNR == 1 { file++; next }
    file == 1 && $1 > 400.005 && $1 < 460.005 { turned += 1.745329252e-4 * cos($8) * cos($9) * 0.01 }
    $1 > 460 && $1 < 461 && file == 2 { found = $13 }
    $1 > 460 && $1 < 461 && file == 3 { found -= $13 }
    END {
        bound = turned * turned + 7.292115e-5 * 60 * turned
        printf "gyro failure: turned by %.5f mrad, expected %.5f, within %.5f\n", found * 1e3, turned * 1e3, bound * 1e3
        exit !(found - turned < bound && turned - found < bound)
    }' "$out/all_truth.csv" "$out/all.csv" "$out/sound.csv" || fail "the failure does not show"
# JSBSim's own packets of FlightGear's format, while the host writes the same frames as doubles: positions are the same to the bit but
# for the rounding of their text, velocities and angles to half a unit in the last place of a float, heights to the difference of
# JSBSim's two altitudes. The flight begins on the wheels, so its closure is not that of the air.
echo "== live: packets by UDP are the frames of the host, and the log flies to the same bits"
cargo build --quiet -p sins-cli
program=$PWD/target/debug/sins
rm -rf "$out/live"
"$program" live --from udp:0 --rate-hz 100 --silence-s 3 --record log.csv --out "$out/live" >"$out/live.txt" 2>&1 &
live=$!
for _ in $(seq 100); do
    grep -q '^listening' "$out/live.txt" && break
    sleep 0.1
done
port=$(sed -n 's/^listening at udp:127.0.0.1:\([0-9]*\).*/\1/p' "$out/live.txt")
sed "s|<use aircraft|<output name=\"127.0.0.1\" type=\"FLIGHTGEAR\" port=\"$port\" protocol=\"UDP\" rate=\"100\"/>&|" \
    c_examples/jsbsim/flight.xml >"$out/live.xml"
target/jsbsim/host target/jsbsim/source "$out/live.xml" "$out/sender" $perfect ins/pace=20 >"$out/sender.txt"
wait "$live"
grep -E '^  (packets|refused|period)' "$out/live.txt"
grep -qx '  refused  *none' "$out/live.txt" || fail "packets were refused"
awk -F, '
    function size(x) { return x < 0 ? -x : x }
    /^(#|time_s)/ { next }
    FILENAME ~ /log.csv$/ { for (i = 1; i < 11; i++) sent[int($1 * 100 + 0.5), i] = $i; next }
    {
        key = int($1 * 100 + 0.5)
        if (!((key, 2) in sent)) {
            lost++
            next
        }
        frames++
        for (i = 2; i < 4; i++) bad += size(sent[key, i] - $i) > 2.5e-16 * size($i)
        for (i = 5; i < 11; i++) bad += size(sent[key, i] - $i) > size($i) / 16777216 + 1e-15
        height = size(sent[key, 4] - $4) > height ? size(sent[key, 4] - $4) : height
    }
    END {
        printf "%d frames, %d lost, %d other values, heights %.4f m apart\n", frames, lost, bad, height
        exit !(frames > 59000 && !bad && height < 0.01)
    }' "$out/live/log.csv" "$out/sender_truth.csv" || fail "the packets are not the frames"
(cd "$out" && "$program" fly live/log.toml --quiet --out live)
cmp "$out/live/live.csv" "$out/live/log_replay.csv" || fail "the replay has other bits"
report_not_run
