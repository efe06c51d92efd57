// Whole files as bytes.
#ifndef STORE_BYTES_H
#define STORE_BYTES_H

#include "whirl/status.h"

#include <stddef.h>

// Reads an ordinary file; `bytes` is to be freed. WHIRL_IO_ERROR with path and reason.
whirl_status bytes_read(const char *path, unsigned char **bytes, size_t *size);

#endif
