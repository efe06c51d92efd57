/// Detection of exhausted memory in libraries (HDF5, UDUNITS-2, muParser), which report it in ways of their own, take
/// it for another mistake, or ignore it. malloc sets errno in all of them, and nobody resets it to 0.
#ifndef BASE_EXHAUSTED_H
#define BASE_EXHAUSTED_H

#include <errno.h>
#include <stdbool.h>

/// Begins a watch before a call; returns the former errno.
static inline int exhausted_watch(void) {
    const int before = errno;
    errno = 0;
    return before;
}

/// Ends a watch after the call. True: memory ran out, and no result of the calls is valid, even success. False: errno
/// is restored, so that watches can be nested.
static inline bool exhausted(int before) {
    if (errno == ENOMEM) return true;
    errno = before;
    return false;
}

#endif
