// Finding the frames of a journal, whatever has become of its bytes.
#ifndef STORE_JOURNAL_SCAN_H
#define STORE_JOURNAL_SCAN_H

#include "bytes.h"
#include "journal_frame.h"

/// Called for every sound frame, in the order of the file; `offset` is that of its payload.
typedef void (*journal_found)(void *context, const frame_head *head, uint64_t offset);

typedef struct journal_scan {
    uint64_t end;   ///< of the last sound frame, or where the search began
    size_t frames;  ///< sound ones
    size_t damaged; ///< stretches of bytes between sound frames, or sound-looking frames, that are not what was written
    bool torn;      ///< the last frame is cut off, as a kill leaves it
} journal_scan;

/// Looks for frames from `from` on. After a bad one it goes on at the next good one. 0, or the errno of a read.
int journal_search(const byte_source *bytes, uint64_t from, journal_found found, void *context, journal_scan *scan);

#endif
