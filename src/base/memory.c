// Allocation that sets errno only where it fails. The linker passes calls of malloc, calloc and realloc here
// (cmake/layers.cmake).
//
// glibc's malloc may set ENOMEM and succeed, where the heap cannot grow in place but elsewhere. In whirl ENOMEM means
// that memory ran out in the thread (exhausted.h).
#include <errno.h>
#include <stddef.h>

// The linker asks for these reserved names. NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)

/// The functions of the C library; weak, since programs that take libwhirl.a may link without these options.
extern void *__real_malloc(size_t size) __attribute__((weak));
extern void *__real_calloc(size_t count, size_t size) __attribute__((weak));
extern void *__real_realloc(void *memory, size_t size) __attribute__((weak));

void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);

/// Returns memory, and restores errno unless memory is NULL.
static void *allocated(void *memory, int before) {
    if (memory) errno = before;
    return memory;
}

void *__wrap_malloc(size_t size) {
    const int before = errno;
    return allocated(__real_malloc(size), before);
}

void *__wrap_calloc(size_t count, size_t size) {
    const int before = errno;
    return allocated(__real_calloc(count, size), before);
}

void *__wrap_realloc(void *memory, size_t size) {
    const int before = errno;
    return allocated(__real_realloc(memory, size), before);
}

// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
