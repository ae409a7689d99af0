/* The library, loaded by the program itself: sins.hpp calls the functions that the loader found. */
#pragma once
#include "../../c_examples/sins_loader.h"

inline sins_loader lib;

namespace sins {
/* Within the namespace, these pointers hide the functions that sins.h declares, because this program is not
 linked with the library. */
#define BY_LOADER(result, name, arguments) inline result(SINS_CALL *&name) arguments = lib.name;
SINS_FUNCTIONS(BY_LOADER)
#undef BY_LOADER
} // namespace sins

#include "sins_analysis.hpp"
#include "sins_scene.hpp"
