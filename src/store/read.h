// Reading a result: what whirl_result_read does once it has the bytes.
#ifndef STORE_READ_H
#define STORE_READ_H

#include "store.h"
#include "whirl/engine/result.h"

/// Takes the blocks of a result's tables, point by point. An error ends the reading. Without `take` no number is read.
typedef struct block_taker {
    whirl_status (*take)(void *context, const whirl_table *outline, size_t table, size_t point, const double *block);
    void *context;
} block_taker;

/// `name` stands for the file in messages. Blocks go to the taker and the tables have none, or without one (NULL) into
/// the tables. WHIRL_BAD_INPUT for whatever is not a result, WHIRL_IO_ERROR for what cannot be read.
whirl_status read_result(const byte_source *source, const char *name, const block_taker *taker, whirl_result **result);
whirl_status read_file(const char *path, const block_taker *taker, whirl_result **result);

#endif
