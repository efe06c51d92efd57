// The beginning of a journal's file: of which study it is.
#ifndef STORE_JOURNAL_HEADER_H
#define STORE_JOURNAL_HEADER_H

#include "journal_file.h"

/// What a journal is of (identity.h).
typedef struct journal_identity {
    char *text;
    size_t size;
} journal_identity;

/// What a file begins with.
typedef enum header_state {
    HEADER_OURS,
    HEADER_CUT,    ///< a run was killed while it made the journal: there is nothing but the beginning of our header
    HEADER_DAMAGED ///< or no header at all
} header_state;

/// Writes the header and syncs. WHIRL_IO_ERROR, WHIRL_NO_MEMORY.
whirl_status journal_header_write(const journal_file *file, const journal_identity *identity);

/// Looks at a file of `file_size` bytes. WHIRL_BAD_INPUT, with the difference, where the header is of another study.
whirl_status journal_header_look(const journal_file *file, const journal_identity *identity, uint64_t file_size,
                                 header_state *state);

/// "PATH is no journal of this study, or its beginning is damaged".
whirl_status journal_header_missing(const journal_file *file);

#endif
