/// The checksum CRC-32C (Castagnoli 1993; RFC 3720, section 12.1).
#ifndef STORE_CRC32C_H
#define STORE_CRC32C_H

#include <stddef.h>
#include <stdint.h>

/// Returns the checksum of all bytes so far: `size` bytes that follow others, whose checksum is `before` (0: there are
/// none before).
uint32_t crc32c(uint32_t before, const void *bytes, size_t size);

#endif
