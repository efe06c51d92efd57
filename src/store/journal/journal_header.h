/// The header of a journal's file: the identity of its study.
#ifndef STORE_JOURNAL_HEADER_H
#define STORE_JOURNAL_HEADER_H

#include "journal_file.h"
#include "whirl/status.h"

#include <stddef.h>
#include <stdint.h>

/// Identity of a journal's study (identity.h).
typedef struct journal_identity {
    char *text;
    size_t size;
} journal_identity;

/// State of a file's header.
typedef enum header_state {
    HEADER_OURS,
    HEADER_CUT,    ///< the file ends within the header of this study: a run was killed while it made the journal
    HEADER_DAMAGED ///< the header is damaged, or there is none
} header_state;

/// Writes the header and syncs. WHIRL_IO_ERROR, WHIRL_NO_MEMORY.
whirl_status journal_header_write(const journal_file *file, const journal_identity *identity);

/// Reads the header of a file of `file_size` bytes. WHIRL_BAD_INPUT, with the difference, if it is of another study.
whirl_status journal_header_look(const journal_file *file, const journal_identity *identity, uint64_t file_size,
                                 header_state *state);

/// Returns the offset of the end of the header in a journal of any study; 0 if the file is no journal, or its header is
/// damaged.
uint64_t journal_header_end(const journal_file *file, uint64_t file_size);

/// Returns the failure "PATH is no journal of this study, or its beginning is damaged".
whirl_status journal_header_missing(const journal_file *file);

#endif
