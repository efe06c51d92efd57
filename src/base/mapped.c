#define _DEFAULT_SOURCE // madvise; NOLINT(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
#include "mapped.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/// A file-backed array, in the list of its owner.
struct whirl_mapped {
    whirl_mapped *next;
    void *array;
    size_t bytes;
};

/// Opens a file without a name that vanishes with its descriptor; -1 if that fails.
static int nameless_file(void) {
    char path[4096];
    const char *wanted = getenv("TMPDIR"), *folder = wanted && *wanted ? wanted : "/var/tmp";
    if (snprintf(path, sizeof path, "%s/whirl-XXXXXX", folder) >= (int)sizeof path) return -1;
    const int file = mkstemp(path);
    if (file >= 0) unlink(path);
    return file;
}

/// Maps zeros and reserves their space on the disk: writing a page for which the disk has no space would kill the
/// program. NULL if the disk is full.
static void *map_file(size_t bytes) {
    const int file = nameless_file();
    if (file < 0) return NULL;
    void *array = MAP_FAILED;
    if (posix_fallocate(file, 0, (off_t)bytes) == 0)
        array = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return array == MAP_FAILED ? NULL : array;
}

void *mapped_make(whirl_mapped **mapped, size_t count, size_t size) {
    if (count == 0 || count > PTRDIFF_MAX / size) return NULL;
    whirl_mapped *one = malloc(sizeof *one);
    void *array = one ? map_file(count * size) : NULL;
    if (!array) {
        free(one);
        return NULL;
    }
    *one = (whirl_mapped){*mapped, array, count * size};
    *mapped = one;
    return array;
}

void *mapped_take(whirl_mapped **mapped, size_t count, size_t size, size_t least) {
    const int before = errno;
    void *array = count >= least / size ? mapped_make(mapped, count, size) : NULL;
    if (array) return array;
    errno = before; // a failed file is no lack of memory
    return calloc(count > 0 ? count : 1, size);
}

void mapped_drop(whirl_mapped **mapped, void *array) {
    whirl_mapped **link = mapped;
    while (*link && (*link)->array != array) link = &(*link)->next;
    whirl_mapped *one = *link;
    if (!one) {
        free(array);
        return;
    }
    *link = one->next;
    munmap(one->array, one->bytes);
    free(one);
}

void mapped_evict(const whirl_mapped *mapped) {
    for (const whirl_mapped *one = mapped; one; one = one->next) madvise(one->array, one->bytes, MADV_DONTNEED);
}

void mapped_free(whirl_mapped *mapped) {
    while (mapped) mapped_drop(&mapped, mapped->array);
}
