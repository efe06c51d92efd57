// Reads a part of a file from its beginning on (plain_part.h).
#include "plain_part.h"

uint64_t plain_number(plain_part *part, int bytes) {
    uint64_t value = 0;
    if (part->left < (size_t)bytes) {
        part->short_of = true;
        part->left = 0;
        return 0;
    }
    for (int i = bytes - 1; i >= 0; --i) value = value << 8 | part->at[i];
    part->at += bytes;
    part->left -= (size_t)bytes;
    return value;
}

void plain_skip(plain_part *part, size_t bytes) {
    if (part->left < bytes) {
        part->short_of = true;
        part->left = 0;
        return;
    }
    part->at += bytes;
    part->left -= bytes;
}
