/* The program's allocator, which the library uses too. It counts, and it fails on demand. For glibc. */

#ifndef ALLOCATOR_H
#define ALLOCATOR_H

#include <errno.h>
#include <malloc.h>
#include <stddef.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *memory);

/* Number of allocated blocks, of all threads. */
static long allocator_living;
/* Bytes of these blocks. */
static long allocator_bytes;
/* The most that they were at a time, and the largest of them. */
static long allocator_peak, allocator_largest;
/* Calls of this thread, including free(). */
static __thread long allocator_calls;
/* Number of allocations of this thread that still succeed; negative: all. */
static __thread long allocator_good = -1;
/* Number of allocations of this thread before one that fails alone; negative: none. */
static __thread long allocator_before = -1;

static inline int allocator_refuses(void)
{
    allocator_calls++;
    if (allocator_before >= 0 && allocator_before-- == 0) {
        return 1;
    }
    if (allocator_good > 0) {
        allocator_good--;
        return 0;
    }
    return allocator_good == 0;
}

/* Size of a block [bytes]. 0 with AddressSanitizer: its malloc_usable_size() knows only the blocks of its own allocator. */
static inline long allocator_size(void *memory)
{
#ifdef __SANITIZE_ADDRESS__
    (void)memory;
    return 0;
#else
    return (long)malloc_usable_size(memory);
#endif
}

/* Notes a block of `size` bytes, with which all blocks have `bytes`. One thread at a time looks at the figures. */
static inline void allocator_note(long size, long bytes)
{
    allocator_peak = bytes > allocator_peak ? bytes : allocator_peak;
    allocator_largest = size > allocator_largest ? size : allocator_largest;
}

static inline void *allocator_counted(void *memory)
{
    long size = allocator_size(memory);
    __atomic_add_fetch(&allocator_living, memory != NULL, __ATOMIC_RELAXED);
    allocator_note(size, __atomic_add_fetch(&allocator_bytes, size, __ATOMIC_RELAXED));
    return memory;
}

void *malloc(size_t size)
{
    return allocator_refuses() ? NULL : allocator_counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size)
{
    return allocator_refuses() ? NULL : allocator_counted(__libc_calloc(count, size));
}

void *realloc(void *memory, size_t size)
{
    if (allocator_refuses()) {
        return NULL;
    }
    if (memory != NULL) {
        long before = allocator_size(memory);
        void *grown = __libc_realloc(memory, size);
        long after = allocator_size(grown);
        __atomic_add_fetch(&allocator_bytes, grown == NULL ? 0 : after - before, __ATOMIC_RELAXED);
        allocator_note(after, allocator_bytes + before); /* Both blocks, while the contents move. */
        return grown;
    }
    return allocator_counted(__libc_malloc(size));
}

int posix_memalign(void **memory, size_t alignment, size_t size)
{
    void *made = allocator_refuses() ? NULL : allocator_counted(__libc_memalign(alignment, size));
    if (made == NULL) {
        return ENOMEM;
    }
    *memory = made;
    return 0;
}

void free(void *memory)
{
    allocator_calls++;
    __atomic_sub_fetch(&allocator_living, memory != NULL, __ATOMIC_RELAXED);
    __atomic_sub_fetch(&allocator_bytes, allocator_size(memory), __ATOMIC_RELAXED);
    __libc_free(memory);
}

#endif
