# Instructions a step, counted by callgrind; to be sourced.

. ../tests/support/need.sh
need g++ c++
need valgrind valgrind

# instructions COMMAND...: of a run that succeeds.
instructions() {
    local told
    told=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1) || {
        printf '%s\n%s: failed\n' "$told" "$*" >&2
        return 1
    }
    sed -n 's/.*Collected : //p' <<<"$told"
}

# per_step SHORT LONG COMMAND...: the difference of two runs of a command that takes the number of steps last.
per_step() {
    local short=$1 long=$2 first second
    shift 2
    first=$(instructions "$@" "$short") || return
    second=$(instructions "$@" "$long") || return
    if [ "${first:-0}" -le 0 ] || [ $(((${second:-0} - first) / (long - short))) -le 0 ]; then
        echo "$*: counted ${first:-nothing} in $short steps, ${second:-nothing} in $long" >&2
        return 1
    fi
    echo $(((second - first) / (long - short)))
}
