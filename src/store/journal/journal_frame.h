// The bytes of a journal: a header, then one frame a point. Whole numbers and doubles are little-endian.
//
//   header   16 bytes  "whirl journal 1\n"
//             8        length of the identity
//             4        CRC-32C of the 24 bytes before
//                      the identity: what is computed, as text (identity.h)
//             4        CRC-32C of all before
//
//   frame     8 bytes  magic
//             8        hash of the identity, so that a frame never counts for another study
//             8        slot of the point in its table
//             8        length of the payload
//             4        batch
//             4        CRC-32C of the 36 bytes before
//                      payload: the point's block, then its last state, from which a carried point starts
//             4        CRC-32C of head and payload
#ifndef STORE_JOURNAL_FRAME_H
#define STORE_JOURNAL_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    JOURNAL_LEAD = 28, ///< bytes of the header before the identity
    JOURNAL_HEAD = 40, ///< bytes of a frame before the payload
    JOURNAL_TAIL = 4   ///< the checksum at the end of both
};

/// Beginning of a frame. It has a byte that no UTF-8 text has, and line ends, which copying as a text changes.
extern const unsigned char journal_magic[8];

typedef struct frame_head {
    uint64_t identity, slot, size; ///< identity: its hash; size: bytes of the payload
    uint32_t batch;
} frame_head;

/// Returns the hash of an identity, FNV-1a of 64 bits.
uint64_t journal_hash(const char *identity, size_t size);

/// Return the bytes of a whole header for an identity of `size` bytes, and write it to `to`.
size_t header_size(size_t size);
void header_put(unsigned char *to, const char *identity, size_t size);

/// Reads the length of the identity from the first JOURNAL_LEAD bytes. Returns false if they are no header.
bool header_lead(const unsigned char *from, uint64_t *size);

/// Returns true if the checksum of a whole header is right.
bool header_is_sound(const unsigned char *from, size_t size);

/// Return the bytes of a frame for a block of `size` doubles and a state of `dimension` doubles, and write it to `to`.
size_t frame_size(size_t size, size_t dimension);
void frame_put(unsigned char *to, const frame_head *head, const double *block, size_t size, const double *end,
               size_t dimension);

/// Write the parts of a frame: the head of JOURNAL_HEAD bytes, doubles of a payload (returns their end), and the
/// checksum of JOURNAL_TAIL bytes.
void frame_head_put(unsigned char *to, const frame_head *head);
unsigned char *frame_numbers_put(unsigned char *to, const double *from, size_t count);
void frame_checksum_put(unsigned char *to, uint32_t sum);

/// Reads the head of a frame, JOURNAL_HEAD bytes; returns false if they are no head of a frame.
bool frame_head_get(const unsigned char *from, frame_head *head);

/// Reads the checksum at the end of a frame.
uint32_t frame_checksum(const unsigned char *tail);

/// Reads doubles of a payload.
void frame_numbers(const unsigned char *from, double *to, size_t count);

#endif
