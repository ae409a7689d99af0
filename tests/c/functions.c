/* Every row of the table of functions fits its declaration in the header. Compiled, not run. */

#include "sins_functions.h"

#define POINTER(result, name, arguments) result(SINS_CALL *name) arguments;
#define ADDRESS(result, name, arguments) name,

struct functions {
    SINS_FUNCTIONS(POINTER)
};

extern const struct functions all;
const struct functions all = { SINS_FUNCTIONS(ADDRESS) };
