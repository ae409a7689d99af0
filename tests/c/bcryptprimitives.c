/* Stands in for a DLL of Windows that wine 8 lacks, of which Rust's standard library imports one function and the library uses
 * none. */

#include <stddef.h>

__declspec(dllexport) int __stdcall ProcessPrng(unsigned char *bytes, size_t count)
{
    while (count > 0) {
        bytes[--count] = 4;
    }
    return 1;
}
