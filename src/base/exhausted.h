/// Whether memory ran out in what was called. Libraries beneath us (HDF5, UDUNITS-2, muParser) say so in ways of their
/// own, take it for another mistake, or pass over it; but malloc sets errno whoever calls it, and nobody sets it back
/// to 0.
#ifndef BASE_EXHAUSTED_H
#define BASE_EXHAUSTED_H

#include <errno.h>
#include <stdbool.h>

/// To be called before; gives what errno was.
static inline int exhausted_watch(void) {
    const int before = errno;
    errno = 0;
    return before;
}

/// ... and after. Where it is true, whatever came of the calls is not to be believed, success included. Else errno is
/// what it was before, so that watches may lie within each other.
static inline bool exhausted(int before) {
    if (errno == ENOMEM) return true;
    errno = before;
    return false;
}

#endif
