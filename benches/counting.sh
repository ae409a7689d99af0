# Counts the instructions of a step by callgrind; to be sourced.

. ../tests/support/need.sh
need g++ c++
need valgrind valgrind

# instructions COMMAND...: prints the number of instructions of the command, which has to succeed.
instructions() {
    local reported
    reported=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1) || {
        printf '%s\n%s: failed\n' "$reported" "$*" >&2
        return 1
    }
    sed -n 's/.*Collected : //p' <<<"$reported"
}

# per_step SHORT LONG COMMAND...: instructions of a step, from two runs of a command whose last argument is the number of steps.
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
