/* The number of free TLS indexes of a Windows process. */

#ifndef TLS_INDEXES_LEFT_H
#define TLS_INDEXES_LEFT_H

#include <windows.h>

static inline int tls_indexes_left(void)
{
    static DWORD indexes[4096];
    int count = 0, i;
    while ((indexes[count] = TlsAlloc()) != TLS_OUT_OF_INDEXES) {
        count++;
    }
    for (i = 0; i < count; i++) {
        TlsFree(indexes[i]);
    }
    return count;
}

#endif
