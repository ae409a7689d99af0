# Instructions a step, counted by callgrind; to be sourced.

# per_step SHORT LONG COMMAND...: the difference of two runs of a command that takes the number of steps last.
per_step() {
    local short=$1 long=$2 count first second
    shift 2
    for count in "$short" "$long"; do
        first=${second:-}
        second=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" "$count" 2>&1 |
            sed -n 's/.*Collected : //p')
    done
    echo $(((second - first) / (long - short)))
}
