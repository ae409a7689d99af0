# Changes the comments of a header into the form that doxygen reads. The preamble keeps its lines. Each comment that begins a subject
# begins a group.

# Begins the group of a comment: its title is the text before the first colon or full stop.
function begin(text) {
    match(text, /[.:]/)
    title = substr(text, 1, RSTART - 1)
    rest = substr(text, RSTART + 1)
    name = tolower(FILENAME "_" title)
    gsub(/^.*\/|[^a-z_]+/, "_", name)
    printf "%s/** @defgroup %s %s\n *%s\n", (is_open ? "/** @} */\n" : ""), name, title, rest
    is_open = 1
}

NR == 1 { print "/** @file\n@verbatim"; in_preamble = 1; next }
in_preamble && /^ \*\/$/ { print "@endverbatim */"; in_preamble = 0; next }
in_preamble { sub(/^ \* ?/, ""); print; next }

/^\/\* .*\*\/$/ { sub(/^\/\* /, ""); sub(/ \*\/$/, ""); begin($0); print " * @{ */"; next }
/^\/\*$/ { getline; sub(/^ \* /, ""); begin($0); in_subject = 1; next }
in_subject && /^ \*\/$/ { print " * @{ */"; in_subject = 0; next }

is_open && /^#ifdef __cplusplus/ { print "/** @} */"; is_open = 0 }
/^#define .*\/\*/ { sub(/\/\*/, "/**<") }
{ print }
