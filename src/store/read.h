// Reading a result from bytes: the core of whirl_result_read.
#ifndef STORE_READ_H
#define STORE_READ_H

#include "bytes.h"
#include "whirl/engine/result.h"

/// Receives the blocks of a result's tables, point by point. If `take` returns an error, reading ends. If it is NULL,
/// no blocks are read.
typedef struct block_taker {
    whirl_status (*take)(void *context, const whirl_table *outline, size_t table, size_t point, const double *block);
    void *context;
} block_taker;

/// Read a result; `name` is used in messages. Blocks go to `taker`, or to the tables if it is NULL. WHIRL_BAD_INPUT for
/// a file that is no result, WHIRL_IO_ERROR for one that cannot be read.
whirl_status read_result(const byte_source *source, const char *name, const block_taker *taker, whirl_result **result);
whirl_status read_file(const char *path, const block_taker *taker, whirl_result **result);

#endif
