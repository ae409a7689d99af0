# Changes comments into the form that doxygen reads. The preamble keeps its lines.
1s|.*|/** @file\n@verbatim|
1,/^ \*\//s|^ \*/$|@endverbatim */|
1,/^@endverbatim/s|^ \* ?||
s|^(#define .*)/\*|\1/**<|
