// Bytes of a MAT file, or of an element that it has compressed, read one after another (listed.h).
#include "listed.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { STREAM_IN = 1 << 14, STREAM_OUT = 1 << 16 };

struct mat_stream {
    uint64_t address;    ///< of the element
    uint64_t next, left; ///< bytes of the file that are not read yet
    uint64_t at;         ///< bytes taken and skipped
    bool deflated, ended;
    z_stream inflater;
    size_t from, ready; ///< bytes in `out`
    unsigned char in[STREAM_IN], out[STREAM_OUT];
};

bool mat_stream_open(foreign_file *file, mat_stream **stream, uint64_t address, uint64_t size, bool deflated) {
    mat_stream_close(*stream);
    mat_stream *own = *stream = calloc(1, sizeof *own);
    if (!own) return foreign_no_memory(file);
    own->address = own->next = address;
    own->left = size;
    if (!foreign_inside(file, address, size)) return foreign_fail(file, "is damaged or cut off");
    if (deflated && inflateInit(&own->inflater) != Z_OK) return foreign_no_memory(file);
    own->deflated = deflated;
    return true;
}

void mat_stream_close(mat_stream *stream) {
    if (stream && stream->deflated) inflateEnd(&stream->inflater);
    free(stream);
}

uint64_t mat_stream_at(const mat_stream *stream) {
    return stream->at;
}

bool mat_stream_is(const mat_stream *stream, uint64_t address, bool deflated) {
    return stream && stream->address == address && stream->deflated == deflated;
}

/// Reads the next bytes of the file.
static bool stream_read(foreign_file *file, mat_stream *stream, unsigned char *to, size_t most, size_t *size) {
    *size = stream->left < most ? (size_t)stream->left : most;
    if (!foreign_read(file, stream->next, to, *size)) return false;
    stream->next += *size;
    stream->left -= *size;
    return true;
}

/// Fills the empty buffer. After the end of a compressed element it stays empty.
static bool stream_fill(foreign_file *file, mat_stream *stream) {
    stream->from = stream->ready = 0;
    if (!stream->deflated) return stream_read(file, stream, stream->out, STREAM_OUT, &stream->ready);
    z_stream *z = &stream->inflater;
    z->next_out = stream->out;
    z->avail_out = STREAM_OUT;
    while (z->avail_out > 0 && !stream->ended) {
        size_t size = z->avail_in;
        if (size == 0) {
            if (!stream_read(file, stream, stream->in, STREAM_IN, &size)) return false;
            z->next_in = stream->in;
            z->avail_in = (uInt)size;
        }
        const int outcome = size > 0 ? inflate(z, Z_NO_FLUSH) : Z_DATA_ERROR;
        if (outcome == Z_MEM_ERROR) return foreign_no_memory(file);
        if (outcome != Z_OK && outcome != Z_STREAM_END)
            return foreign_fail(file, "is damaged: what it has compressed cannot be read");
        stream->ended = outcome == Z_STREAM_END;
    }
    stream->ready = STREAM_OUT - z->avail_out;
    return true;
}

/// Takes the next bytes; `to` may be NULL to drop them.
static bool stream_move(foreign_file *file, mat_stream *stream, unsigned char *to, uint64_t size) {
    while (size > 0) {
        if (stream->ready == 0 && !stream_fill(file, stream)) return false;
        if (stream->ready == 0) return foreign_fail(file, "is damaged or cut off");
        const size_t some = size < stream->ready ? (size_t)size : stream->ready;
        if (to) {
            memcpy(to, stream->out + stream->from, some);
            to += some;
        }
        stream->from += some;
        stream->ready -= some;
        stream->at += some;
        size -= some;
    }
    return true;
}

bool mat_stream_take(foreign_file *file, mat_stream *stream, void *to, size_t size) {
    return stream_move(file, stream, to, size);
}

bool mat_stream_skip(foreign_file *file, mat_stream *stream, uint64_t size) {
    if (stream->deflated || size <= stream->ready) return stream_move(file, stream, NULL, size);
    const uint64_t far = size - stream->ready;
    if (far > stream->left) return foreign_fail(file, "is damaged or cut off");
    stream->at += size;
    stream->next += far;
    stream->left -= far;
    stream->ready = 0;
    return true;
}

bool mat_stream_finish(foreign_file *file, mat_stream *stream) {
    while (stream->deflated && !stream->ended)
        if (!stream_fill(file, stream)) return false;
    return true;
}
