/* Libraries loaded at run time. */

#ifndef LOADER_H
#define LOADER_H

#if defined(_WIN32)

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

static inline void *open_library(const char *path)
{
    return LoadLibraryA(path);
}

static inline int close_library(void *library)
{
    return FreeLibrary(library) != 0;
}

static inline void *symbol(void *library, const char *name)
{
    return (void *)GetProcAddress(library, name);
}

/* How many TLS indexes the process has left. */
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

#else

#include <dlfcn.h>
#include <stdio.h>

static inline void *open_library(const char *path)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
    }
    return library;
}

static inline int close_library(void *library)
{
    return dlclose(library) == 0;
}

static inline void *symbol(void *library, const char *name)
{
    return dlsym(library, name);
}

#endif

#endif
