/* Runs a test on a thread with 64 KB of stack, including the thread's own needs. An overflow ends the program. */

#ifndef SMALL_STACK_H
#define SMALL_STACK_H

#include <pthread.h>
#include <stddef.h>

#include "check.h"

/* AddressSanitizer puts room around every variable. */
#ifdef __SANITIZE_ADDRESS__
enum { SMALL_STACK = 1024 * 1024 };
#else
enum { SMALL_STACK = 64 * 1024 };
#endif

static void *small_stack_body(void *test)
{
    (*(void (**)(void))test)();
    return NULL;
}

/* The system puts a page without access below the stack. */
static inline void on_a_stack(size_t bytes, void (*test)(void))
{
    pthread_attr_t attributes;
    pthread_t thread;
    CHECK(pthread_attr_init(&attributes) == 0);
    CHECK(pthread_attr_setstacksize(&attributes, bytes) == 0);
    CHECK(pthread_create(&thread, &attributes, small_stack_body, &test) == 0);
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK(pthread_attr_destroy(&attributes) == 0);
}

static inline void on_a_small_stack(void (*test)(void))
{
    on_a_stack(SMALL_STACK, test);
}

#endif
