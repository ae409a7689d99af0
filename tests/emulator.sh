#!/usr/bin/env bash
# SINS_Emulator under wine and Xvfb, 64 and 32 bits: its flights equal `sins fly` with the scene that it saved, it reports each
# unusable file in one sentence, and its fields accept any text. Pictures of its pages in both languages are in target/emulator.
#
#     tests/emulator.sh          both word sizes
#     tests/emulator.sh 64       64 bits; with the other word size only start, rejected files and export
#
# SINS_DLL_DIR: a folder with 64/sins.dll and 32/sins.dll, used instead of building them. A SINS_Emulator.exe in the same folder as
# a sins.dll is used too. SINS_LIB_DIR: a folder with a program sins to use.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/wine.sh
. tests/support/built.sh
. tests/support/pe.sh

whole=${1:-64 32}
font=/usr/share/fonts/truetype/wqy/wqy-microhei.ttc
need xvfb Xvfb
need imagemagick import
need fonts-wqy-microhei "$font"
build_program
sins=$built/sins

# screen SIZE: starts a screen of this size, which all later programs use.
display_file=$(mktemp)
screen=
screen() {
    [ -z "$screen" ] || kill "$screen"
    : >"$display_file"
    Xvfb -displayfd 4 -screen 0 "$1x24" 4>"$display_file" 2>/dev/null &
    screen=$!
    until [ -s "$display_file" ]; do sleep 0.2; done
    export DISPLAY=:$(cat "$display_file")
}
trap 'kill $screen; rm -f "$display_file"' EXIT

# path FILE: the path of FILE in wine.
path() {
    echo "Z:$(realpath -m "$1" | tr / '\\')"
}

fail() {
    echo "tests/emulator.sh: $*" >&2
    exit 1
}

# emulator OPTION...: the program of this word size.
emulator() {
    timeout 300 "$wine" "$folder/SINS_Emulator.exe" "$@"
}

# refuses WHAT SENTENCE OPTION...: the program ends with status 1 and SENTENCE.
refuses() {
    local status=0
    emulator "${@:3}" /quit 2>"$folder/sentence" || status=$?
    [ "$status" -eq 1 ] || fail "$1: ends with $status"
    grep -q "$2" "$folder/sentence" || { cat "$folder/sentence"; fail "$1: says something else"; }
    echo "$1: $(head -c 200 "$folder/sentence" | tr -d '\r' | head -1)"
}

# drive DRIVER COMMAND [FOLDER] -- OPTION...: starts the program with these options; DRIVER operates its dialogs.
drive() {
    local command=() program
    while [ "$1" != -- ]; do command+=("$1"); shift; done
    shift
    emulator "$@" &
    program=$!
    "$wine" "$folder/${command[0]}.exe" "${command[@]:1}" >"$folder/said" || { cat "$folder/said"; fail "${command[*]}"; }
    tr -d '\r' <"$folder/said"
    wait "$program"
}

# fonts: sets a font for dialogs, because wine has none.
fonts() {
    local name
    for name in "MS Shell Dlg" "MS Shell Dlg 2" Tahoma; do
        "$wine" reg add 'HKLM\Software\Microsoft\Windows NT\CurrentVersion\FontSubstitutes' /v "$name" /d "WenQuanYi Micro Hei" /f >/dev/null
    done
}

# live: flies on packets. Ideal sensors end within 1.2 mm: exact samples with these losses leave 0.61 mm (tests/emulator/live.cpp), and
# a velocity of 170 m/s as a float is off by at most 9.3e-6 m/s, which is 0.56 mm in the minute.
live() {
    drive live fly "$(path "$folder/sins.dll")" -- /language en /scene rest /export "$(path "$folder/flown/live")"
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^navigation_error_position/) own[k] }
        NR > 1 { rows++; square = 0; for (k in own) square += $k * $k; time_s = $1 }
        END {
            printf "by packets: %d records, %s s, %.2g m\n", rows, time_s, sqrt(square)
            exit !(rows > 50 && time_s == 60 && square < 1.2e-3 ^ 2)
        }' "$folder/flown/live/flight.csv" || fail "ideal sensors do not return to the truth of packets"
    drive live again "$(path "$folder/sins.dll")" -- /language en /scene rest /export "$(path "$folder/flown/live")"
    # The records are those of the flight that begins where the aircraft was moved to.
    awk -F, 'NR == 2 { from_s = $1 } END { exit !(NR == 3 && from_s == 1002.1 && $1 == 1003.1) }' "$folder/flown/live/flight.csv" ||
        { cut -d, -f1 "$folder/flown/live/flight.csv"; fail "the records of a flight that was moved"; }
}

# views: what pages show. Errors of ideal sensors are rounding, and their curves are flat, because each axis has a least range. Error
# data 1 is shown with the error model alone: its colour, its row among the values, its box.
views() {
    local model quantity axis height file orange has_data1
    "$sins" scene write simulation2 --set flight.hours=0.1 >"$folder/flown/start.toml"
    drive views start -- /language en /scene "$(path "$folder/flown/start.toml")"
    for model in off rk4; do
        has_data1=$([ $model = off ] && echo 0 || echo 1)
        mkdir -p "$folder/$model"
        "$sins" scene write simulation1 --set flight.hours=0.1 --set options.error_model=$model >"$folder/flown/$model.toml"
        drive views errors "$(path "$folder/$model")" -- /language en /scene "$(path "$folder/flown/$model.toml")"
        for quantity in 0 1 2; do
            file=$folder/$model/errors$quantity.png
            for axis in 0 1 2; do
                height=$(convert "$file" -crop "925x190+62+$((223 * axis + 19))" +repage -fill black +opaque '#0046A0' \
                    -fill white -opaque '#0046A0' -trim -format %h info:)
                [ "$height" -le 4 ] || fail "$file: rounding fills panel $axis with $height pixels"
            done
            orange=$(convert "$file" -fill black +opaque '#FF963C' -format '%[fx:mean > 0]' info:)
            [ "$orange" -eq "$has_data1" ] || fail "$file: error data 1 with error model $model"
        done
        grep -q "^values $((12 + has_data1)), error data 1 $has_data1" "$folder/said" || fail "values with error model $model"
    done
    drive views print -- /language en /scene "$(path "$folder/flown/off.toml")"
    drive views cockpit -- /language en /scene rest
}

# watch NAME DRIVER COMMAND -- OPTION...: makes a picture of each page that the driver shows.
watch() {
    local line program watched
    emulator "${@:5}" &
    program=$!
    coproc driver { "$wine" "$folder/$2.exe" "$3"; }
    watched=$driver_PID
    while read -r line <&"${driver[0]}"; do
        line=${line%$'\r'}
        [ "${line% *}" = page ] || fail "$line"
        import -window root "$folder/$1_${line#page }.png"
        echo >&"${driver[1]}"
    done 2>/dev/null
    wait "$watched" || true
    wait "$program"
}

# pictures LANGUAGE [NAME]: makes pictures of each page and dialog.
pictures() {
    watch "$1${2:-}" driver pages -- /language "$1" /scene "$(path "$folder/flown/trainer.toml")" /run
    [ -f "$folder/$1${2:-}_manoeuvre.png" ] || fail "not all pages were shown"
}

# check ARCH BITS OTHER: runs all tests, or the part that the usage above states. OTHER: word size of the DLL that must be rejected.
check() {
    folder=$PWD/target/emulator/$2
    rm -rf "$folder"
    mkdir -p "$folder/flown"
    # A wine server of earlier tests may have a desktop without a screen.
    "$WINESERVER" -k 2>/dev/null || true
    screen 1000x740
    if [ -e "${SINS_DLL_DIR:-}/$2/SINS_Emulator.exe" ]; then
        cp "$SINS_DLL_DIR/$2/SINS_Emulator.exe" "$folder"
    else
        apps/emulator/build.sh "$1" "$folder"
    fi
    for driver in driver controls views; do
        "$1-w64-mingw32-gcc" -std=c99 -Wall -Wextra -Wno-unused-function -Werror -O1 -o "$folder/$driver.exe" \
            "tests/emulator/$driver.c" -luser32 -static
    done
    "$1-w64-mingw32-gcc" -std=c99 -D__USE_MINGW_ANSI_STDIO=1 -Wall -Wextra -Wno-unused-function -Werror -O1 -Iinclude \
        -o "$folder/live.exe" tests/emulator/live.c -luser32 -lws2_32 -static
    check_pe "$folder/SINS_Emulator.exe" "$1" advapi32.dll comctl32.dll comdlg32.dll gdi32.dll gdiplus.dll kernel32.dll \
        msvcrt.dll shell32.dll user32.dll winmm.dll ws2_32.dll
    fonts

    refuses "no DLL" "sins.dll: no such file"
    echo text >"$folder/sins.dll"
    refuses "a text as DLL" "sins.dll: not a DLL"
    if [ -n "${SINS_DLL_DIR:-}" ]; then
        cp "$SINS_DLL_DIR/$3/sins.dll" "$folder"
        refuses "the DLL of the other word size" "sins.dll: not a DLL for programs of $2 bits"
        cp "$SINS_DLL_DIR/$2/sins.dll" "$folder"
    else
        release/windows.sh "$1" "$folder"
    fi
    head -c 5000 "$folder/SINS_Emulator.exe" >"$folder/binary.toml"
    cp "$folder/binary.toml" "$folder/binary.csv"
    printf '[flight]\nfile = "binary.csv"\n' >"$folder/log.toml"
    refuses "a binary file as scene" "binary.toml:" /scene "$(path "$folder/binary.toml")"
    refuses "a binary file as log" "binary.csv:" /scene "$(path "$folder/log.toml")" /run

    # With the command line: the measured increments, standard deviations, and a title of 4,000 letters.
    "$sins" scene write simulation2 --set flight.hours=0.1 --set options.covariance=on >"$folder/flown/increments.toml"
    { printf 'title = "'; head -c 4000 /dev/zero | tr '\0' x; printf '"\n'; } >"$folder/title"
    sed -i -e '/^title = /d' -e "/^\[flight\]/r $folder/title" "$folder/flown/increments.toml"
    printf '[output]\nimu = "imu.csv"\n' >>"$folder/flown/increments.toml"
    emulator /scene "$(path "$folder/flown/increments.toml")" /run /export "$(path "$folder/flown/records")" /quit
    "$sins" fly "$folder/flown/increments.toml" --out "$folder/flown/expected" --quiet
    grep -q sigma_position_east_m "$folder/flown/expected/increments.csv" || fail "no standard deviations to compare"
    cmp "$folder/flown/expected/increments.csv" "$folder/flown/records/increments.csv"
    cmp "$folder/flown/expected/imu.csv" "$folder/flown/records/imu.csv"
    # A unit with its panel, updates, failures and temperature, a log.
    local name
    for name in day resets trainer fighter; do
        emulator /scene "$(path "c_examples/scenes/$name.toml")" /run /export "$(path "$folder/flown/records")" /quit
        "$sins" fly "c_examples/scenes/$name.toml" --out "$folder/flown/expected" --quiet
        cmp "$folder/flown/expected/$name.csv" "$folder/flown/records/$name.csv"
    done
    if ! grep -qw "$2" <<<"$whole"; then
        echo "$2 bits: starts, rejects and exports"
        return
    fi

    # With the dialogs: one hour of the paper's simulation 2.
    "$sins" scene write simulation2 >"$folder/flown/simulation2.toml"
    sed -i 's/^hours = 48/hours = 2/' "$folder/flown/simulation2.toml"
    drive driver fly 1 -- /language en /scene "$(path "$folder/flown/simulation2.toml")" /export "$(path "$folder/flown/records")"
    grep -q '^hours = 1 ' "$folder/flown/simulation2.toml" || fail "the scene was not saved with its hour"
    "$sins" scene write simulation2 | sed 's/^hours = 48/hours = 1/' | cmp - "$folder/flown/simulation2.toml"
    "$sins" fly "$folder/flown/simulation2.toml" --out "$folder/flown/expected" --quiet
    cmp "$folder/flown/expected/simulation2.csv" "$folder/flown/records/simulation2.csv"

    # A failure that is set in flight is in the saved scene, and this scene flies to the same bits.
    cp "$folder/flown/simulation2.toml" "$folder/flown/exercise.toml"
    drive driver exercise -- /language en /scene "$(path "$folder/flown/exercise.toml")" /export "$(path "$folder/flown/records")"
    grep -q '^\[\[failure\]\]' "$folder/flown/exercise.toml" || fail "the failure is not in the scene"
    "$sins" fly "$folder/flown/exercise.toml" --out "$folder/flown/expected" --quiet
    cmp "$folder/flown/expected/exercise.csv" "$folder/flown/records/exercise.csv"

    # A scene made in the dialogs: a manoeuvre with a sinusoid before the rest, a preset, a value in SI, and another value for one
    # axis.
    "$sins" scene write rest >"$folder/flown/edit.toml"
    drive driver edit -- /language en /scene "$(path "$folder/flown/edit.toml")"
    "$sins" scene check "$folder/flown/edit.toml"
    tr -d '\n' <"$folder/flown/edit.toml" | grep -Eq 'kind = "sinusoids".*channel = "roll".*amplitude_deg = 5 .*kind = "rest"' ||
        fail "edit.toml has other manoeuvres"
    # 1e-6 rad/s are 0.2063 deg/h.
    grep -Eq 'bias_deg_h = \[0.2062648[0-9]*, 0.4125296[0-9]*, 0.2062648[0-9]*\]' "$folder/flown/edit.toml" || fail "another bias"
    grep -q 'bias_sigma_deg_h = ' "$folder/flown/edit.toml" || fail "edit.toml has no preset"

    # File dialogs, drag and drop, clipboard; studies that are cancelled; a sentence of the library in Chinese.
    cp c_examples/scenes/{trainer,fighter}.toml "$folder/flown"
    sed -i "s|\.\./flights|$PWD/c_examples/flights|" "$folder/flown/fighter.toml"
    cp "$folder/log.toml" "$folder/flown"
    cp "$(ls c_examples/flights/*.csv | head -1)" "$folder/flown/log.csv"
    drive driver files "$(path "$folder/flown")" -- /language en
    cmp "$folder/flown/exercise.toml" "$folder/flown/again.toml"
    cmp "$folder/flown/expected/exercise.csv" "$folder/flown/new.csv"
    [ "$(identify -format %k "$folder/flown/again.png")" -gt 10 ] || fail "again.png shows nothing"
    drive driver keys -- /language en /scene rest
    drive driver studies -- /language en /scene patrol
    drive driver stick -- /language en /scene rest
    live
    views
    drive driver sentence -- /language zh
    [ "$(grep -c '须' "$folder/said")" -eq 2 ] || fail "a sentence is not in Chinese: of a text, of a struct"

    # Tool tips, the tab key, letters; a change of the language in flight; recommended options; the wheel; the library in use, two
    # windows.
    for language in en zh; do
        letters=$(sed -n 's/^    POPUP ".*&\(.\).*/\1/p' "apps/emulator/menu_$language.rc" | tr -d '\n' | tr a-z A-Z)
        [ -n "$letters" ] || fail "no letters in the menu"
        drive controls reach "$letters" -- /language "$language"
    done
    "$sins" scene write simulation2 --set flight.hours=2 >"$folder/flown/switched.toml"
    watch language controls language -- /language en /scene "$(path "$folder/flown/switched.toml")" /export "$(path "$folder/flown/records")"
    "$sins" fly "$folder/flown/switched.toml" --out "$folder/flown/expected" --quiet
    cmp "$folder/flown/expected/switched.csv" "$folder/flown/records/switched.csv"
    echo "the language changed in flight"
    cp "$folder/flown/switched.toml" "$folder/flown/adopted.toml"
    drive controls adopt -- /language en /scene "$(path "$folder/flown/adopted.toml")"
    "$sins" scene check "$folder/flown/adopted.toml"
    grep -Eq '^(scheme|subsamples|updates_per_sample) = ' "$folder/flown/adopted.toml" || fail "the scene has no recommended options"
    drive controls wheel "$(path "$folder/flown")" -- /language en /scene "$(path "$folder/flown/increments.toml")"
    ! cmp -s "$folder/flown/whole.png" "$folder/flown/near.png" || fail "the wheel does not zoom"
    cmp "$folder/flown/whole.png" "$folder/flown/far.png"
    drive controls dll -- /language en

    # Two programs at once, with the command line: failures, temperature, a log.
    for scene in trainer fighter; do
        emulator /scene "$(path "$folder/flown/$scene.toml")" /run /export "$(path "$folder/flown/records")" \
            /picture "$(path "$folder/$scene.png")" /quit &
    done
    for scene in trainer fighter; do
        "$sins" fly "$folder/flown/$scene.toml" --out "$folder/flown/expected" --quiet
    done
    for job in $(jobs -p | grep -v "^$screen$"); do wait "$job"; done
    for scene in trainer fighter; do
        cmp "$folder/flown/expected/$scene.csv" "$folder/flown/records/$scene.csv"
        [ "$(identify -format %k "$folder/$scene.png")" -gt 10 ] || fail "$scene.png shows nothing"
    done
    pictures en
    pictures zh
    [ -n "$dots_seen" ] || dots
    echo "$2 bits: flown as sins flies, to the byte; pictures in $folder"
}

# dots: makes pictures on a small screen and on screens of 144 and 192 dots per inch, each with its own registry. With one word
# size only.
dots_seen=
dots() {
    local dots before=$WINEPREFIX
    dots_seen=1
    "$WINESERVER" -k || true
    screen 800x600
    # The first program on a new screen may get the size of the previous screen.
    emulator /scene "$(path "$folder/flown/increments.toml")" /run /quit
    pictures en _small
    for dots in 144 192; do
        "$WINESERVER" -k || true
        export WINEPREFIX=$before.$dots
        screen $((10 * dots + 40))x$((7 * dots + 60))
        mkdir -p "$WINEPREFIX"
        fonts 2>/dev/null # wine creates its folder and prints messages
        "$wine" reg add 'HKCU\Control Panel\Desktop' /v LogPixels /t REG_DWORD /d "$dots" /f >/dev/null
        "$WINESERVER" -k || true
        pictures zh "_$dots"
    done
    "$WINESERVER" -k || true
    export WINEPREFIX=$before
}

if have_wine x86_64; then check x86_64 64 32; fi
if have_wine i686; then
    if fetch_screen32; then check i686 32 64; else could_not "SINS_Emulator in 32 bits" "no screen for 32-bit wine"; fi
fi
report_not_run
