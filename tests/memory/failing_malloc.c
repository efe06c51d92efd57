// A malloc whose N-th call fails, to be preloaded:  WHIRL_FAIL_AT=N LD_PRELOAD=failing_malloc.so whirl ...
//
// WHIRL_FAIL_AT=0 fails none. WHIRL_FAIL_ALL=1 fails all later calls too, as in a process that has really reached its
// limit. WHIRL_ENOMEM_FROM=BYTES sets errno to ENOMEM in calls for so many bytes or more that succeed, as glibc's
// malloc may. WHIRL_COUNT=FILE gets the number of calls, so that it is known how many there are to fail. Every process
// counts for itself.
#include <errno.h>
#include <fcntl.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/// The C library's own, under names that it keeps for this purpose.
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

static atomic_long calls;
static long fail_at;
static bool fail_all;
static size_t enomem_from = SIZE_MAX;

__attribute__((constructor)) static void begin(void) {
    const char *at = getenv("WHIRL_FAIL_AT"), *all = getenv("WHIRL_FAIL_ALL");
    fail_at = at ? strtol(at, NULL, 10) : 0;
    const char *from = getenv("WHIRL_ENOMEM_FROM");
    fail_all = all && *all == '1';
    if (from) enomem_from = strtoul(from, NULL, 10);
    calls = 0;
}

__attribute__((destructor)) static void end(void) {
    const char *path = getenv("WHIRL_COUNT");
    char text[32];
    const int file = path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (file < 0) return;
    const int length = snprintf(text, sizeof text, "%ld\n", (long)calls);
    if (write(file, text, (size_t)length) != length) _exit(3);
    close(file);
}

static bool fails(void) {
    const long call = atomic_fetch_add(&calls, 1) + 1;
    if (fail_at <= 0 || call < fail_at || (call > fail_at && !fail_all)) return false;
    errno = ENOMEM;
    return true;
}

/// Returns memory of a size, and sets errno where that is asked for.
static void *made(void *memory, size_t size) {
    if (size >= enomem_from) errno = ENOMEM;
    return memory;
}

void *malloc(size_t size) {
    return fails() ? NULL : made(__libc_malloc(size), size);
}

void *calloc(size_t count, size_t size) {
    return fails() ? NULL : made(__libc_calloc(count, size), count * size);
}

void *realloc(void *memory, size_t size) {
    return fails() ? NULL : made(__libc_realloc(memory, size), size);
}

void *memalign(size_t alignment, size_t size) {
    return fails() ? NULL : made(__libc_memalign(alignment, size), size);
}

void *aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}

int posix_memalign(void **memory, size_t alignment, size_t size) {
    void *own = memalign(alignment, size);
    if (!own) return ENOMEM;
    *memory = own;
    return 0;
}
