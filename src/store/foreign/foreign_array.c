// Types, shapes and numbers of datasets (foreign.h).
#include "foreign.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- types and shapes

/// Returns true for a real number of IEEE 754 with 2, 4 or 8 bytes, whose properties follow.
static bool type_is_real(plain_part part, size_t size) {
    static const unsigned char known[3][10] = {
        {16, 10, 5, 0, 10, 15, 0}, {32, 23, 8, 0, 23, 127, 0}, {64, 52, 11, 0, 52, 0xff, 3}};
    plain_skip(&part, 2);
    const int which = size == 2 ? 0 : size == 4 ? 1 : 2;
    const uint64_t precision = plain_number(&part, 2);
    if (part.left < 8 || (size != 2 && size != 4 && size != 8) || precision != 8 * size) return false;
    const unsigned char *place = part.at;
    return place[0] == known[which][1] && place[1] == known[which][2] && place[2] == known[which][3] &&
           place[3] == known[which][4] && place[4] == known[which][5] && place[5] == known[which][6];
}

bool foreign_type_read(foreign_file *file, plain_part part, foreign_type *out) {
    enum { WHOLE, REAL, TIME, TEXT, BITS, OPAQUE, COMPOUND, REFERENCE, CHOICE, LONG, FIXED_LIST, CLASSES };
    static const char *const described[CLASSES] = {
        "whole numbers of an unknown kind",
        "real numbers of an unknown kind",
        "times",
        "texts",
        "bits",
        "bytes",
        "records of several fields",
        "references",
        "words",
        "lists",
        "lists",
    };
    const unsigned kind = (unsigned)plain_number(&part, 1) & 15U;
    const unsigned bits = (unsigned)plain_number(&part, 3);
    *out = (foreign_type){.kind = FOREIGN_OTHER, .size = (size_t)plain_number(&part, 4)};
    if (part.short_of || out->size == 0) return foreign_fail(file, "is damaged");
    out->described = kind < CLASSES ? described[kind] : "values of an unknown kind";
    out->big = bits & 1U;
    out->is_signed = bits & 8U;
    const plain_part properties = part;
    if (kind == WHOLE) {
        plain_skip(&part, 2);
        const bool full = plain_number(&part, 2) == 8 * out->size;
        if (full && (out->size == 1 || out->size == 2 || out->size == 4 || out->size == 8)) out->kind = FOREIGN_WHOLE;
    }
    if (kind == REAL && !(bits & 0x40U) && type_is_real(properties, out->size)) out->kind = FOREIGN_REAL;
    if (kind == TEXT) out->kind = FOREIGN_TEXT;
    if (kind == LONG && (bits & 15U) == 1 && out->size == 16) out->kind = FOREIGN_LONG_TEXT, out->described = "texts";
    return true;
}

bool foreign_space_read(foreign_file *file, plain_part part, foreign_array *out) {
    enum { NOTHING = 2, GROWS = 1 };
    const unsigned version = (unsigned)plain_number(&part, 1), rank = (unsigned)plain_number(&part, 1);
    const unsigned flags = (unsigned)plain_number(&part, 1), kind = (unsigned)plain_number(&part, 1);
    if (version == 1) plain_skip(&part, 4);
    if (part.short_of || version < 1 || version > 2) return foreign_fail(file, "is damaged");
    if (rank > FOREIGN_MAX_RANK)
        return foreign_fail(file, "has %u dimensions, expected at most %d", rank, FOREIGN_MAX_RANK);
    if (version == 2 && kind == NOTHING) return foreign_fail(file, "is empty");
    out->rank = (int)rank;
    uint64_t all = 1;
    for (unsigned i = 0; i < rank; i++) {
        const uint64_t size = plain_number(&part, 8);
        if (size > 0 && all > UINT64_MAX / 64 / size) return foreign_fail(file, "is damaged");
        all *= size > 0 ? size : 1;
        out->sizes[i] = out->most[i] = size;
    }
    for (unsigned i = 0; i < rank && (flags & GROWS); i++) {
        out->most[i] = plain_number(&part, 8);
        if (out->most[i] < out->sizes[i]) return foreign_fail(file, "is damaged");
    }
    return !part.short_of || foreign_fail(file, "is damaged");
}

// ---------------------------------------------------------------- layouts

/// Reads the filters of chunks (IV.A.2.l).
static bool array_filters(foreign_file *file, plain_part part, foreign_array *out) {
    const unsigned version = (unsigned)plain_number(&part, 1), count = (unsigned)plain_number(&part, 1);
    if (version < 1 || version > 2 || count > FOREIGN_MAX_FILTERS) return foreign_fail(file, "is damaged");
    plain_skip(&part, version == 1 ? 6 : 0);
    for (unsigned i = 0; i < count; i++) {
        foreign_filter *own = &out->filters[out->filter_count++];
        own->id = (unsigned)plain_number(&part, 2);
        size_t name = version == 1 || own->id >= 256 ? (size_t)plain_number(&part, 2) : 0;
        plain_skip(&part, 2);
        const size_t values = (size_t)plain_number(&part, 2);
        if (version == 1) name = (name + 7) / 8 * 8;
        plain_skip(&part, name);
        for (size_t k = 0; k < values && !part.short_of; k++) {
            const unsigned value = (unsigned)plain_number(&part, 4);
            if (k == 0) own->size = value;
        }
        if (version == 1 && values % 2 > 0) plain_skip(&part, 4);
    }
    return !part.short_of || foreign_fail(file, "is damaged");
}

/// Checks the sizes of a chunk, the last of which is that of a value.
static bool array_chunk(foreign_file *file, plain_part *part, unsigned rank, int bytes, foreign_array *out) {
    enum { MAX_CHUNK = 1 << 30, MANY = 1 << 24, LARGEST_RATIO = 1100 };
    if ((int)rank != out->rank + 1) return foreign_fail(file, "is damaged");
    uint64_t all = 1;
    for (unsigned i = 0; i < rank; i++) {
        const uint64_t length = plain_number(part, bytes);
        if (length == 0 || length > MAX_CHUNK || all > MAX_CHUNK / length)
            return foreign_fail(file, "is damaged, or has chunks of more than 1 GiB");
        all *= length;
        if (i + 1 < rank) out->chunk[i] = length;
        if (i + 1 == rank && length != out->type.size) return foreign_fail(file, "is damaged");
    }
    // Deflate makes chunks at most a thousand times smaller.
    if (all > MANY && all / LARGEST_RATIO > file->source->size) return foreign_fail(file, "is damaged");
    out->chunk_bytes = (size_t)all;
    return true;
}

/// Reads a layout of chunks of version 4 (IV.A.2.i).
static bool array_chunks(foreign_file *file, plain_part *part, foreign_array *out) {
    enum { WHOLE_EDGES = 1, SINGLE_FILTERED = 2 };
    static const unsigned char parameters[] = {0, 0, 1, 5, 6};
    const unsigned flags = (unsigned)plain_number(part, 1), rank = (unsigned)plain_number(part, 1);
    const unsigned width = (unsigned)plain_number(part, 1);
    if (width < 1 || width > 8) return foreign_fail(file, "is damaged");
    if (!array_chunk(file, part, rank, (int)width, out)) return false;
    const unsigned index = (unsigned)plain_number(part, 1);
    if (index < 1 || index > 5) return foreign_fail(file, "is damaged");
    out->index = index == 1   ? FOREIGN_SINGLE
                 : index == 2 ? FOREIGN_IMPLICIT
                 : index == 3 ? FOREIGN_FIXED
                 : index == 4 ? FOREIGN_EXTENSIBLE
                              : FOREIGN_TREE_2;
    out->whole_edges = flags & WHOLE_EDGES;
    out->size = out->chunk_bytes;
    out->single_filtered = index == 1 && (flags & SINGLE_FILTERED);
    if (out->single_filtered) {
        out->size = plain_number(part, 8);
        out->mask = (unsigned)plain_number(part, 4);
    }
    plain_skip(part, parameters[index - 1]);
    out->address = plain_number(part, 8);
    return true;
}

static bool array_layout(foreign_file *file, plain_part part, foreign_array *out) {
    enum { COMPACT, CONTIGUOUS, CHUNKED, VIRTUAL };
    const unsigned version = (unsigned)plain_number(&part, 1), kind = (unsigned)plain_number(&part, 1);
    if (version < 3 || version > 4) return foreign_fail(file, "is stored as HDF5 before 1.6.3 did");
    if (kind == VIRTUAL) return foreign_fail(file, "is a virtual dataset, expected one with numbers of its own");
    if (kind == COMPACT) {
        out->layout = FOREIGN_COMPACT;
        const size_t size = (size_t)plain_number(&part, 2);
        if (size > part.left) return foreign_fail(file, "is damaged");
        out->compact = (plain_part){part.at, size, false};
    } else if (kind == CONTIGUOUS) {
        out->layout = FOREIGN_CONTIGUOUS;
        out->address = plain_number(&part, 8);
        out->size = plain_number(&part, 8);
    } else if (kind == CHUNKED) {
        out->layout = FOREIGN_CHUNKED;
        const unsigned rank = version == 3 ? (unsigned)plain_number(&part, 1) : 0;
        if (version == 3) out->address = plain_number(&part, 8);
        if (!(version == 3 ? array_chunk(file, &part, rank, 4, out) : array_chunks(file, &part, out))) return false;
    } else {
        return foreign_fail(file, "is damaged");
    }
    return !part.short_of || foreign_fail(file, "is damaged");
}

bool foreign_array_read(foreign_file *file, const foreign_object *object, foreign_array *out) {
    enum { SHARED = 2 };
    const foreign_message *space = foreign_object_find(object, FOREIGN_DATASPACE);
    const foreign_message *type = foreign_object_find(object, FOREIGN_DATATYPE);
    const foreign_message *layout = foreign_object_find(object, FOREIGN_LAYOUT);
    const foreign_message *filters = foreign_object_find(object, FOREIGN_FILTERS);
    *out = (foreign_array){.rank = 0};
    if (!space || !type || !layout) return foreign_fail(file, "is damaged");
    if ((space->flags | layout->flags | (filters ? filters->flags : 0)) & SHARED)
        return foreign_fail(file, "shares its shape with other datasets, which whirl does not read");
    if (type->flags & SHARED)
        out->type = (foreign_type){.kind = FOREIGN_OTHER, .size = 1, .described = "values of a named type"};
    else if (!foreign_type_read(file, type->content, &out->type))
        return false;
    if (!foreign_space_read(file, space->content, out)) return false;
    if (out->type.kind != FOREIGN_WHOLE && out->type.kind != FOREIGN_REAL) return true;
    if (filters && !array_filters(file, filters->content, out)) return false;
    return array_layout(file, layout->content, out);
}

// ---------------------------------------------------------------- numbers

/// Returns the value of a real number of 2 bytes.
static double value_of_half(unsigned bits) {
    const int exponent = (int)(bits >> 10U & 31U);
    const double mantissa = bits & 1023U, sign = bits >> 15U ? -1.0 : 1.0;
    if (exponent == 31) return mantissa > 0.0 ? (double)NAN : sign * (double)INFINITY;
    return sign * (exponent > 0 ? ldexp(1024.0 + mantissa, exponent - 25) : ldexp(mantissa, -24));
}

double foreign_number(const foreign_type *type, const unsigned char *at) {
    uint64_t bits = 0;
    for (size_t i = 0; i < type->size; i++) bits = bits << 8U | at[type->big ? i : type->size - 1 - i];
    if (type->kind == FOREIGN_WHOLE) {
        const uint64_t sign = (uint64_t)1 << (8 * type->size - 1);
        if (!type->is_signed || !(bits & sign)) return (double)bits;
        return -(double)(~(bits | ~(sign | (sign - 1))) + 1);
    }
    if (type->size == 2) return value_of_half((unsigned)bits);
    if (type->size == 4) {
        const uint32_t low = (uint32_t)bits;
        float single;
        memcpy(&single, &low, sizeof single);
        return (double)single;
    }
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/// Steps to the next place of a box, the last dimension fastest; false after the last one.
static bool next_place(int rank, const uint64_t *low, const uint64_t *high, uint64_t *place) {
    for (int i = rank - 1; i >= 0; i--) {
        if (++place[i] < high[i]) return true;
        place[i] = low[i];
    }
    return false;
}

/// Reads the numbers of a row of the last dimension.
static bool take_row(foreign_file *file, const foreign_array *array, uint64_t at, size_t count, double *out) {
    enum { SOME = 4096 };
    unsigned char bytes[SOME * 8];
    const size_t size = array->type.size;
    for (size_t done = 0; done < count;) {
        const size_t some = count - done < SOME ? count - done : SOME;
        const uint64_t from = at + done * size;
        if (array->layout == FOREIGN_COMPACT) {
            if (from > array->compact.left || some * size > array->compact.left - from)
                return foreign_fail(file, "is damaged");
            memcpy(bytes, array->compact.at + from, some * size);
        } else {
            if (from > array->size || some * size > array->size - from) return foreign_fail(file, "is damaged");
            if (!foreign_read(file, array->address + from, bytes, some * size)) return false;
        }
        for (size_t i = 0; i < some; i++) out[done + i] = foreign_number(&array->type, bytes + i * size);
        done += some;
    }
    return true;
}

/// Reads numbers that follow one another in the file.
static bool take_rows(foreign_file *file, const foreign_array *array, const uint64_t *low, const uint64_t *high,
                      double *out) {
    uint64_t place[FOREIGN_MAX_RANK + 1] = {0};
    const int rank = array->rank;
    const size_t row = rank > 0 ? (size_t)(high[rank - 1] - low[rank - 1]) : 1;
    if (array->layout == FOREIGN_CONTIGUOUS && array->address == PLAIN_NOWHERE)
        return foreign_fail(file, "was never written");
    for (int i = 0; i < rank; i++) place[i] = low[i];
    do {
        uint64_t at = 0;
        for (int i = 0; i < rank; i++) at = at * array->sizes[i] + place[i];
        if (!take_row(file, array, at * array->type.size, row, out)) return false;
        out += row;
    } while (rank > 1 && next_place(rank - 1, low, high, place));
    return true;
}

/// Copies the numbers of a chunk that belong to the part.
static void take_from_chunk(const foreign_array *array, const uint64_t *chunk, const uint64_t *low,
                            const uint64_t *high, const unsigned char *bytes, double *out) {
    uint64_t from[FOREIGN_MAX_RANK], to[FOREIGN_MAX_RANK], place[FOREIGN_MAX_RANK];
    const int rank = array->rank;
    for (int i = 0; i < rank; i++) {
        const uint64_t start = chunk[i] * array->chunk[i], end = start + array->chunk[i];
        from[i] = place[i] = start > low[i] ? start : low[i];
        to[i] = end < high[i] ? end : high[i];
    }
    do {
        uint64_t inside = 0, outside = 0;
        for (int i = 0; i < rank; i++) {
            inside = inside * array->chunk[i] + (place[i] - chunk[i] * array->chunk[i]);
            outside = outside * (high[i] - low[i]) + (place[i] - low[i]);
        }
        const uint64_t row = to[rank - 1] - from[rank - 1];
        for (uint64_t k = 0; k < row; k++)
            out[outside + k] = foreign_number(&array->type, bytes + (inside + k) * array->type.size);
        place[rank - 1] = from[rank - 1];
    } while (rank > 1 && next_place(rank - 1, from, to, place));
}

/// Reads the numbers of chunks.
static bool take_chunks(foreign_file *file, const foreign_array *array, const uint64_t *low, const uint64_t *high,
                        double *out) {
    uint64_t from[FOREIGN_MAX_RANK], to[FOREIGN_MAX_RANK], place[FOREIGN_MAX_RANK];
    for (int i = 0; i < array->rank; i++) {
        from[i] = place[i] = low[i] / array->chunk[i];
        to[i] = (high[i] - 1) / array->chunk[i] + 1;
    }
    do {
        foreign_chunk found;
        bool edge = false;
        for (int i = 0; i < array->rank; i++) edge = edge || (place[i] + 1) * array->chunk[i] > array->sizes[i];
        file->visits = FOREIGN_MAX_VISITS;
        if (!foreign_chunk_find(file, array, place, &found))
            return foreign_fail(file, "has parts that were never written");
        const bool plain = array->filter_count == 0 || (array->whole_edges && edge);
        if (found.size > ((uint64_t)1 << 31U) || (plain && found.size != array->chunk_bytes))
            return foreign_fail(file, "is damaged");
        if (!foreign_inside(file, found.address, found.size)) return foreign_fail(file, "is damaged or cut off");
        unsigned char *bytes = malloc((size_t)found.size + 1);
        if (!bytes) return foreign_no_memory(file);
        if (!foreign_read(file, found.address, bytes, (size_t)found.size)) {
            free(bytes);
            return false;
        }
        if (!plain) bytes = foreign_unfilter(file, array, found.mask, bytes, (size_t)found.size);
        if (!bytes) return false;
        take_from_chunk(array, place, low, high, bytes, out);
        free(bytes);
    } while (next_place(array->rank, from, to, place));
    return true;
}

bool foreign_values(foreign_file *file, const foreign_array *array, const size_t *first, const size_t *count,
                    double *out) {
    uint64_t low[FOREIGN_MAX_RANK] = {0}, high[FOREIGN_MAX_RANK] = {0};
    for (int i = 0; i < array->rank; i++) {
        low[i] = first[i];
        high[i] = (uint64_t)first[i] + count[i];
        if (count[i] == 0) return true;
        if (high[i] > array->sizes[i] || high[i] < low[i]) return foreign_fail(file, "has no such part");
    }
    if (array->layout == FOREIGN_CHUNKED && array->rank > 0) return take_chunks(file, array, low, high, out);
    return take_rows(file, array, low, high, out);
}
