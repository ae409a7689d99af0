/* Replaces a DLL that wine 8 lacks. Rust's standard library for *-pc-windows-gnu imports one function of it, which the tests of
 * the program need. The released files do not need it (release/windows.sh). */

#include <stddef.h>

__declspec(dllexport) int __stdcall ProcessPrng(unsigned char *bytes, size_t count)
{
    while (count > 0) {
        bytes[--count] = 4;
    }
    return 1;
}
