/// Finds the frames of a journal, also in a damaged file.
#ifndef STORE_JOURNAL_SCAN_H
#define STORE_JOURNAL_SCAN_H

#include "bytes.h"
#include "journal_frame.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Called for every sound frame, in the order of the file; `offset` is that of its payload.
typedef void (*journal_found)(void *context, const frame_head *head, uint64_t offset);

typedef struct journal_scan {
    uint64_t end;   ///< end of the last valid frame, or the beginning of the scan
    size_t frames;  ///< number of sound frames
    size_t damaged; ///< number of gaps between valid frames that hold other bytes, and of frames with a wrong checksum
    bool torn;      ///< the last frame is incomplete, as after a kill
} journal_scan;

/// Looks for frames from `from` on, and counts them; `found` may be NULL. After a damaged frame it continues at the
/// next valid one. Returns 0, or the errno of a read.
int journal_search(const byte_source *bytes, uint64_t from, journal_found found, void *context, journal_scan *scan);

#endif
