# Makes a C program from the headers that prints its sizes, offsets and constants.

function show(label, value) {
    printf "    printf(\"%%s %%.17g\\n\", \"%s\", (double)(%s));\n", label, value
}

BEGIN {
    print "#include <stdio.h>\n#include \"sins_analysis.h\"\n#include \"sins_scene.h\"\n\nint main(void)\n{"
}
/^typedef struct .* \{$/ {
    name = $3
    show("sizeof(" name ")", "sizeof(" name ")")
}
/^    [a-z].*;$/ && name != "" {
    field = $NF
    sub(/[[;].*/, "", field)
    show(name "." field, "offsetof(" name ", " field ")")
    show("sizeof(" name "." field ")", "sizeof(((" name " *)0)->" field ")")
}
/^}/ { name = "" }
/^    SINS_[A-Z0-9_]+ = / { show($1, $1) }
/^#define SINS_[A-Z0-9_]+ +[(0-9]/ { show($2, $2) }
END { print "    return 0;\n}" }
