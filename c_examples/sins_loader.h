/*
 * sins_loader.h - loads libsins.so or sins.dll at run time, without an import library:
 *
 *   sins_loader sins;
 *   char message[512];
 *   if (!sins_loader_open(&sins, "sins.dll", message, sizeof message)) {
 *       puts(message);
 *   } else {
 *       sins.sins_create(NULL, &sim);              every function of sins.h is a member of the same name
 *       ...
 *       sins_loader_close(&sins);                  after the last call of the last thread
 *   }
 *
 * For C99, C++98 and later. Copy it into your program; it needs the headers *.h of include. On Linux with a C library older than
 * glibc 2.34 link with -ldl.
 */

#ifndef SINS_LOADER_H
#define SINS_LOADER_H

#include <stdio.h>
#include <string.h>

#if defined(_WIN32)
#include <windows.h>
typedef HMODULE sins_loader_library;
typedef FARPROC sins_loader_address;
#else
#include <dlfcn.h>
typedef void *sins_loader_library;
typedef void *sins_loader_address;
#endif

#include "sins_functions.h"

#if defined(_MSC_VER) && _MSC_VER < 1900 /* Visual Studio 2013 and before */
#define SINS_LOADER_INLINE static __inline
#define SINS_LOADER_PRINT _snprintf
#else
#define SINS_LOADER_INLINE static inline
#define SINS_LOADER_PRINT snprintf
#endif

typedef struct sins_loader {
    sins_loader_library library;
    /* 0: a library without the feature "scenes"; the functions of sins_scene.h are NULL. */
    int has_scenes;
    /* 0: a library without the feature "identify"; the functions sins_identify_... are NULL. */
    int has_identify;
#define SINS_LOADER_MEMBER(result, name, arguments) result(SINS_CALL *name) arguments;
    SINS_FUNCTIONS(SINS_LOADER_MEMBER)
#undef SINS_LOADER_MEMBER
} sins_loader;

#if defined(_WIN32)

/* Windows shows no message box if the file is not a DLL. */
SINS_LOADER_INLINE sins_loader_library sins_loader_load(const char *path, char *message, size_t size)
{
    const int bits = sizeof(void *) * 8;
    wchar_t wide[1024];
    sins_loader_library library;
    UINT mode;
    DWORD error;

    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, sizeof wide / sizeof wide[0]) == 0) {
        SINS_LOADER_PRINT(message, size, "%s: the path is not UTF-8, or is longer than 1023 characters", path);
        return NULL;
    }
    mode = SetErrorMode(SEM_FAILCRITICALERRORS);
    library = LoadLibraryW(wide);
    error = GetLastError();
    SetErrorMode(mode);
    if (library == NULL && error == ERROR_MOD_NOT_FOUND) {
        SINS_LOADER_PRINT(message, size, "%s: no such file, or a DLL that it needs is missing (Windows error %lu)", path, error);
    } else if (library == NULL && error == ERROR_BAD_EXE_FORMAT) {
        SINS_LOADER_PRINT(message, size, "%s: not a DLL for programs of %d bits, as this one is (Windows error %lu)", path,
                          bits, error);
    } else if (library == NULL) {
        SINS_LOADER_PRINT(message, size, "%s: cannot be loaded (Windows error %lu)", path, error);
    }
    return library;
}

SINS_LOADER_INLINE sins_loader_address sins_loader_look_up(sins_loader_library library, const char *name)
{
    return GetProcAddress(library, name);
}

SINS_LOADER_INLINE int sins_loader_unload(sins_loader_library library)
{
    return FreeLibrary(library) != 0;
}

#else

SINS_LOADER_INLINE sins_loader_library sins_loader_load(const char *path, char *message, size_t size)
{
    sins_loader_library library = dlopen(path, RTLD_NOW | RTLD_LOCAL);

    if (library == NULL) {
        SINS_LOADER_PRINT(message, size, "%s", dlerror()); /* names the path */
    }
    return library;
}

SINS_LOADER_INLINE sins_loader_address sins_loader_look_up(sins_loader_library library, const char *name)
{
    return dlsym(library, name);
}

SINS_LOADER_INLINE int sins_loader_unload(sins_loader_library library)
{
    return dlclose(library) == 0;
}

#endif

/* Writes the address of a function to a function pointer. C has no cast between these types that all compilers accept. */
SINS_LOADER_INLINE int sins_loader_find(sins_loader_library library, const char *name, void *pointer)
{
    sins_loader_address address = sins_loader_look_up(library, name);

    memcpy(pointer, &address, sizeof address);
    return address != NULL;
}

/* Finds all functions of the library. Returns the name of the first one that is missing, or NULL if none is missing. */
SINS_LOADER_INLINE const char *sins_loader_find_all(sins_loader *loader)
{
#define SINS_LOADER_FIND(result, name, arguments)                       \
    if (!sins_loader_find(loader->library, #name, &loader->name)) {     \
        return #name;                                                   \
    }
    SINS_FUNCTIONS_ENGINE(SINS_LOADER_FIND)
    loader->has_scenes = sins_loader_look_up(loader->library, "sins_scene_create") != NULL;
    if (loader->has_scenes) {
        SINS_FUNCTIONS_SCENES(SINS_LOADER_FIND)
    }
    loader->has_identify = sins_loader_look_up(loader->library, "sins_identify_create") != NULL;
    if (loader->has_identify) {
        SINS_FUNCTIONS_IDENTIFY(SINS_LOADER_FIND)
    }
#undef SINS_LOADER_FIND
    return NULL;
}

/* Unloads the library, and makes all members 0. Returns 1, and 0 if the system reports a failure. */
SINS_LOADER_INLINE int sins_loader_close(sins_loader *loader)
{
    int done = loader->library == NULL || sins_loader_unload(loader->library);

    memset(loader, 0, sizeof *loader);
    return done;
}

/*
 * Loads the library of this path, UTF-8 on Windows too, and finds its functions. The system searches for a path without a
 * folder: LoadLibrary() in the program's folder first, dlopen() only in LD_LIBRARY_PATH and among the system's libraries.
 *
 * Returns 1 if the library is loaded. Returns 0 if the file is missing, is not a library, is for programs of another word size, is
 * not sins, has another version of the interface than sins.h, or is older than sins.h and lacks a function. Then message has the
 * reason, nothing stays loaded, and all members are 0. A message is cut to size bytes, which must not be 0.
 */
SINS_LOADER_INLINE int sins_loader_open(sins_loader *loader, const char *path, char *message, size_t size)
{
    const char *lacks;
    unsigned long version;

    memset(loader, 0, sizeof *loader);
    message[0] = '\0';
    loader->library = sins_loader_load(path, message, size);
    if (loader->library == NULL) {
        message[size - 1] = '\0'; /* _snprintf() leaves it out */
        return 0;
    }
    if (!sins_loader_find(loader->library, "sins_abi_version", &loader->sins_abi_version) ||
        !sins_loader_find(loader->library, "sins_version_string", &loader->sins_version_string)) {
        SINS_LOADER_PRINT(message, size, "%s: a library, but not sins", path);
    } else if ((version = loader->sins_abi_version()) != SINS_HEADER_ABI) {
        SINS_LOADER_PRINT(message, size, "%s: sins %s has version %lu of the interface, this program needs version %d", path,
                          loader->sins_version_string(), version, SINS_HEADER_ABI);
    } else if ((lacks = sins_loader_find_all(loader)) != NULL) {
        SINS_LOADER_PRINT(message, size, "%s: sins %s is older than this program: it has no function %s", path,
                          loader->sins_version_string(), lacks);
    } else {
        return 1;
    }
    message[size - 1] = '\0';
    sins_loader_close(loader);
    return 0;
}

#endif
