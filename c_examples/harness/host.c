#ifndef _WIN32
#define _POSIX_C_SOURCE 200809L
#endif

#include "host.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#include <direct.h>
#include <io.h>
#include <windows.h>
#define SEPARATORS "/\\"
#else
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#define SEPARATORS "/"
#endif

static volatile sig_atomic_t interrupted;

static void on_interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

int host_interrupted(void)
{
    return interrupted != 0;
}

#ifdef _WIN32

double host_seconds(void)
{
    LARGE_INTEGER ticks, ticks_per_second;

    QueryPerformanceFrequency(&ticks_per_second);
    QueryPerformanceCounter(&ticks);
    return (double)ticks.QuadPart / (double)ticks_per_second.QuadPart;
}

int host_has_terminal(void)
{
    return _isatty(_fileno(stderr)) != 0;
}

void host_catch_interrupt(void)
{
    signal(SIGINT, on_interrupt); /* for one signal only */
}

static int make_one_directory(const char *path)
{
    return _mkdir(path);
}

int host_replace_file(const char *from, const char *to)
{
    if (MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING)) {
        return 0;
    }
    errno = GetLastError() == ERROR_ACCESS_DENIED ? EACCES : EIO;
    return -1;
}

#else

double host_seconds(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

int host_has_terminal(void)
{
    return isatty(STDERR_FILENO);
}

void host_catch_interrupt(void)
{
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = on_interrupt;
    action.sa_flags = (int)(SA_RESTART | SA_RESETHAND);
    sigaction(SIGINT, &action, NULL);
}

static int make_one_directory(const char *path)
{
    return mkdir(path, 0777);
}

int host_replace_file(const char *from, const char *to)
{
    return rename(from, to);
}

#endif

int host_make_directory(const char *path)
{
    char upper[1024];
    size_t length = strlen(path), i;

    if (length >= sizeof upper) {
        errno = ENAMETOOLONG;
        return -1;
    }
    memcpy(upper, path, length + 1);
    for (i = 1; i < length; i++) {
        if (strchr(SEPARATORS, upper[i]) != NULL) {
            char separator = upper[i];
            upper[i] = '\0';
            make_one_directory(upper); /* what is missing above shows at the last one */
            upper[i] = separator;
        }
    }
    return make_one_directory(path) == 0 || errno == EEXIST ? 0 : -1;
}
