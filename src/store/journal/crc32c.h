/// The checksum CRC-32C (Castagnoli 1993; RFC 3720, section 12.1).
#ifndef STORE_CRC32C_H
#define STORE_CRC32C_H

#include <stddef.h>
#include <stdint.h>

/// Checksum of bytes that follow others with the checksum `before`; 0 if there are none.
uint32_t crc32c(uint32_t before, const void *bytes, size_t size);

#endif
