/// Whole files as bytes.
#ifndef TEST_STORE_WHOLE_H
#define TEST_STORE_WHOLE_H

#include "bytes.h"

#include <stdlib.h>

/// Reads a file; `bytes` is to be freed.
static inline whirl_status whole_file(const char *path, unsigned char **bytes, size_t *size) {
    byte_file file;
    *bytes = NULL;
    *size = 0;
    whirl_status status = bytes_open(&file, path);
    if (status.code != WHIRL_OK) return status;
    *size = (size_t)file.source.size;
    *bytes = malloc(*size + 1);
    if (!*bytes || file.source.read(file.source.context, 0, *bytes, *size) != 0)
        status = whirl_fail(WHIRL_IO_ERROR, "cannot read %s", path);
    bytes_close(&file);
    return status;
}

#endif
