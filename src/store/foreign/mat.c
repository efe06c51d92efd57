// MAT files before version 7.3: levels 4 and 5 (listed.h). Sections are those of MathWorks' "MAT-File Format".
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "listed.h"
#include "utf8.h"

enum { MAT_HEAD = 128, MAT_HEAD_4 = 20, MAT_MAX_DEPTH = 16, MAT_MAX_TEXT = 64, MAT_MAX_NAMES = 1 << 20 };

/// A walk through the elements of a file.
typedef struct mat_walk {
    foreign_file *file;
    listed_table *table;
    bool big;
    mat_stream *stream;
    uint64_t element, element_size;
    bool deflated;
    char path[LISTED_PATH];
} mat_walk;

static bool mat_damaged(const mat_walk *w) {
    return foreign_fail(w->file, "is damaged or cut off");
}

static uint64_t mat_whole(const unsigned char *at, size_t size, bool big) {
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++) value = value << 8U | at[big ? i : size - 1 - i];
    return value;
}

// ---------------------------------------------------------------- recognition

/// The head of a variable of level 4.
typedef struct mat_head_4 {
    bool big;
    foreign_type type;
    enum { MAT_NUMBERS, MAT_TEXT, MAT_SPARSE } kind;
    uint64_t rows, columns, name;
    bool complex;
} mat_head_4;

/// Reads the head of a variable of level 4 (its number is MOPT: machine, 0, type, kind). Returns false if it is none.
static bool mat_read_head_4(const unsigned char head[MAT_HEAD_4], mat_head_4 *out) {
    static const foreign_type types[] = {{.kind = FOREIGN_REAL, .size = 8},
                                         {.kind = FOREIGN_REAL, .size = 4},
                                         {.kind = FOREIGN_WHOLE, .size = 4, .is_signed = true},
                                         {.kind = FOREIGN_WHOLE, .size = 2, .is_signed = true},
                                         {.kind = FOREIGN_WHOLE, .size = 2},
                                         {.kind = FOREIGN_WHOLE, .size = 1}};
    for (int big = 0; big < 2; big++) {
        const uint64_t number = mat_whole(head, 4, big), type = number / 10 % 10, kind = number % 10;
        if (number / 1000 != (uint64_t)big || number / 100 % 10 != 0 || type > 5 || kind > 2) continue;
        out->big = big;
        out->type = types[type];
        out->type.big = big;
        out->kind = kind == 0 ? MAT_NUMBERS : kind == 1 ? MAT_TEXT : MAT_SPARSE;
        out->rows = mat_whole(head + 4, 4, big);
        out->columns = mat_whole(head + 8, 4, big);
        const uint64_t complex = mat_whole(head + 12, 4, big);
        out->complex = complex > 0;
        out->name = mat_whole(head + 16, 4, big);
        return complex <= 1 && out->name > 1 && out->name <= LISTED_PATH && out->rows <= INT32_MAX &&
               out->columns <= INT32_MAX;
    }
    return false;
}

/// Returns true for a head of level 5: its version, and the order of its bytes.
static bool mat_is_level_5(const byte_source *source) {
    unsigned char head[MAT_HEAD];
    if (source->size < sizeof head || source->read(source->context, 0, head, sizeof head) != 0) return false;
    const bool little = head[126] == 'I' && head[127] == 'M', big = head[126] == 'M' && head[127] == 'I';
    return (little || big) && mat_whole(head + 124, 2, big) == 0x0100 && head[0] && head[1] && head[2] && head[3];
}

bool mat_is_file(const byte_source *source) {
    unsigned char head[MAT_HEAD_4 + 1];
    mat_head_4 first;
    if (mat_is_level_5(source)) return true;
    // A file of level 4 begins with its first variable, whose name begins with a letter.
    return source->size >= sizeof head && source->read(source->context, 0, head, sizeof head) == 0 &&
           mat_read_head_4(head, &first) && isalpha(head[MAT_HEAD_4]);
}

// ---------------------------------------------------------------- names and texts

/// Adds a name to the path. Returns false if it is too long, or no name that can be shown.
static bool mat_enter(mat_walk *w, const char *name, size_t length) {
    const size_t before = strlen(w->path);
    if (length == 0 || before + length + 2 > sizeof w->path || memchr(name, '/', length)) return false;
    for (size_t i = 0, some; i < length; i += some) {
        some = utf8_length(name + i, length - i);
        if (some == 0 || !utf8_is_plain(name + i, some)) return false;
    }
    snprintf(w->path + before, sizeof w->path - before, "%s%.*s", before > 0 ? "/" : "", (int)length, name);
    return true;
}

/// Adds the array of the path. Its sizes are those of HDF5 files, which MATLAB writes in reverse order.
static listed_array *mat_add(mat_walk *w, int rank, const uint64_t *sizes, const char *described) {
    listed_array *own = listed_add(w->file, w->table, w->path);
    if (!own) return NULL;
    own->item.rank = rank <= ARRAYS_MAX_RANK ? rank : 0;
    for (int i = 0; i < own->item.rank; i++) own->item.sizes[i] = (size_t)sizes[rank - 1 - i];
    own->item.numbers = !described;
    own->item.described = described ? described : "numbers";
    own->element = w->element;
    own->element_size = w->element_size;
    own->deflated = w->deflated;
    return own;
}

/// Returns true if the path is that of the unit of another variable, "x_unit"; *end is the end of that one's name.
static bool mat_is_unit(const char *path, size_t *end) {
    static const char *const words[] = {"_unit", "_units"};
    const size_t length = strlen(path);
    for (size_t i = 0; i < 2; i++) {
        *end = length > strlen(words[i]) ? length - strlen(words[i]) : 0;
        if (*end > 0 && path[*end - 1] != '/' && strcmp(path + *end, words[i]) == 0) return true;
    }
    return false;
}

/// Keeps the text of a unit, the next `count` values of the stream, in its array.
static bool mat_take_unit(mat_walk *w, listed_array *own, const foreign_type *type, uint64_t count) {
    unsigned char bytes[8];
    size_t end;
    if (!mat_is_unit(own->name, &end) || count > MAT_MAX_TEXT) return true;
    for (uint64_t i = 0; i < count; i++) {
        if (!mat_stream_take(w->file, w->stream, bytes, type->size)) return false;
        const double letter = foreign_number(type, bytes);
        if (!(letter >= ' ' && letter < 0x7f)) {
            own->item.unit[0] = '\0';
            return true;
        }
        own->item.unit[i] = (char)letter;
    }
    return true;
}

/// Gives variables the units that others name.
static void mat_join_units(listed_table *table) {
    for (size_t i = 0; i < table->count; i++) {
        listed_array *own = &table->arrays[i];
        size_t end;
        if (own->item.numbers || !*own->item.unit || !mat_is_unit(own->name, &end)) continue;
        for (size_t k = 0; k < table->count; k++) {
            listed_array *of = &table->arrays[k];
            if (strlen(of->name) == end && strncmp(of->name, own->name, end) == 0)
                memcpy(of->item.unit, own->item.unit, sizeof of->item.unit);
        }
    }
}

// ---------------------------------------------------------------- level 5

/// Kinds of data elements, and classes of arrays.
enum { MI_INT8 = 1, MI_INT32 = 5, MI_UINT32 = 6, MI_MATRIX = 14, MI_COMPRESSED = 15, MI_UTF8 = 16 };
enum { MX_CELL = 1, MX_STRUCT, MX_OBJECT, MX_CHAR, MX_SPARSE, MX_DOUBLE, MX_UINT64 = 15, MX_FUNCTION, MX_OPAQUE };

/// The tag of a data element, whose content follows.
typedef struct mat_tag {
    unsigned kind;
    uint64_t size, padded; ///< bytes of its content, and with those after it
} mat_tag;

/// Reads a tag within the next bytes of the stream, up to `end`.
static bool mat_take_tag(const mat_walk *w, uint64_t end, mat_tag *out) {
    unsigned char bytes[4];
    if (end - mat_stream_at(w->stream) < 8) return mat_damaged(w);
    if (!mat_stream_take(w->file, w->stream, bytes, 4)) return false;
    const uint64_t word = mat_whole(bytes, 4, w->big);
    out->kind = word & 0xffffU;
    out->size = word >> 16U;
    out->padded = 4; // a small element has its content in its tag
    if (out->size > 4) return mat_damaged(w);
    if (out->size == 0) {
        if (!mat_stream_take(w->file, w->stream, bytes, 4)) return false;
        out->size = mat_whole(bytes, 4, w->big);
        out->padded = (out->size + 7) / 8 * 8;
    }
    const uint64_t left = end - mat_stream_at(w->stream);
    if (out->size > left) return mat_damaged(w);
    if (out->padded > left) out->padded = left;
    return true;
}

/// Reads the content of an element of at most `most` bytes.
static bool mat_take_content(const mat_walk *w, const mat_tag *tag, void *to, size_t most) {
    if (tag->size > most) return mat_damaged(w);
    return mat_stream_take(w->file, w->stream, to, (size_t)tag->size) &&
           mat_stream_skip(w->file, w->stream, tag->padded - tag->size);
}

/// Returns the type of the numbers of a data element; its size is 0 if it has none.
static foreign_type mat_type(unsigned kind, bool big) {
    static const struct {
        unsigned char size;
        bool real, is_signed;
    } kinds[] = {{0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {2, 0, 1}, {2, 0, 0}, {4, 0, 1}, {4, 0, 0}, {4, 1, 1}, {0, 0, 0},
                 {8, 1, 1}, {0, 0, 0}, {0, 0, 0}, {8, 0, 1}, {8, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    if (kind >= sizeof kinds / sizeof *kinds) return (foreign_type){.size = 0};
    return (foreign_type){.kind = kinds[kind].real ? FOREIGN_REAL : FOREIGN_WHOLE,
                          .size = kinds[kind].size,
                          .big = big,
                          .is_signed = kinds[kind].is_signed};
}

static bool mat_matrix(mat_walk *w, uint64_t size, const char *name, size_t length, int depth);

/// Walks through the members of a structure.
static bool mat_members(mat_walk *w, uint64_t end, int depth) {
    unsigned char bytes[4];
    mat_tag tag;
    if (!mat_take_tag(w, end, &tag)) return false;
    if (tag.kind != MI_INT32 || tag.size != 4) return mat_damaged(w);
    if (!mat_take_content(w, &tag, bytes, sizeof bytes)) return false;
    const uint64_t room = mat_whole(bytes, 4, w->big);
    if (!mat_take_tag(w, end, &tag)) return false;
    if (room == 0 || tag.kind != MI_INT8 || tag.size > MAT_MAX_NAMES || tag.size % room > 0) return mat_damaged(w);
    const size_t count = (size_t)(tag.size / room);
    char *names = malloc((size_t)tag.size + 1);
    if (!names) return foreign_no_memory(w->file);
    bool good = mat_take_content(w, &tag, names, (size_t)tag.size);
    for (size_t i = 0; i < count && good; i++) {
        const char *name = names + i * room;
        good = mat_take_tag(w, end, &tag) && (tag.kind == MI_MATRIX || mat_damaged(w)) &&
               mat_matrix(w, tag.size, name, strnlen(name, (size_t)room), depth + 1);
    }
    free(names);
    return good;
}

/// Lists an array whose flags, sizes and name were read; its values follow.
static bool mat_values_of(mat_walk *w, uint64_t end, unsigned class, bool complex, int rank, const uint64_t *sizes,
                          int depth) {
    static const char *const others[] = {
        [MX_CELL] = "cells",    [MX_STRUCT] = "several structures", [MX_OBJECT] = "objects",
        [MX_CHAR] = "texts",    [MX_SPARSE] = "sparse numbers",     [MX_FUNCTION] = "a function",
        [MX_OPAQUE] = "objects"};
    uint64_t all = 1;
    for (int i = 0; i < rank; i++) {
        if (sizes[i] > 0 && all > UINT64_MAX / 64 / sizes[i]) return mat_damaged(w);
        all *= sizes[i];
    }
    if (class == MX_STRUCT && all == 1 && depth < MAT_MAX_DEPTH) return mat_members(w, end, depth);
    const bool numbers = class >= MX_DOUBLE && class <= MX_UINT64;
    const char *described = class >= 1 && class <= MX_OPAQUE ? others[class] : "values of an unknown kind";
    if (numbers) described = complex ? "complex numbers" : rank > ARRAYS_MAX_RANK ? "too many dimensions" : NULL;
    listed_array *own = mat_add(w, rank, sizes, described);
    if (!own) return false;
    if (all == 0 || (!numbers && class != MX_CHAR)) return true;
    mat_tag tag;
    if (!mat_take_tag(w, end, &tag)) return false;
    own->type = mat_type(tag.kind, w->big);
    own->at = mat_stream_at(w->stream);
    if (class == MX_CHAR)
        return own->type.size == 0 || tag.size / own->type.size < all || mat_take_unit(w, own, &own->type, all);
    if (own->type.size == 0 || tag.kind >= MI_MATRIX || tag.size != all * own->type.size) return mat_damaged(w);
    return true;
}

/// Lists an array, or the members of a structure. The content of its element is the next `size` bytes. A name that is
/// not given is in the element.
static bool mat_matrix(mat_walk *w, uint64_t size, const char *name, size_t length, int depth) {
    enum { MAX_RANK = 32 };
    unsigned char flags[8] = {0}, dimensions[4 * MAX_RANK];
    char own[LISTED_PATH + 8];
    uint64_t sizes[MAX_RANK];
    mat_tag tag;
    const uint64_t end = mat_stream_at(w->stream) + size;
    const size_t before = strlen(w->path);
    if (size == 0) return true;
    // Read flags, sizes and name.
    if (!mat_take_tag(w, end, &tag)) return false;
    if (tag.kind != MI_UINT32 || tag.size != sizeof flags) return mat_damaged(w);
    if (!mat_take_content(w, &tag, flags, sizeof flags)) return false;
    const unsigned word = (unsigned)mat_whole(flags, 4, w->big), class = word & 0xffU;
    int rank = 0;
    if (class != MX_OPAQUE) {
        if (!mat_take_tag(w, end, &tag)) return false;
        if (tag.kind != MI_INT32 || tag.size % 4 > 0 || !mat_take_content(w, &tag, dimensions, sizeof dimensions))
            return mat_damaged(w);
        rank = (int)(tag.size / 4);
        for (int i = 0; i < rank; i++) {
            sizes[i] = mat_whole(dimensions + 4 * (size_t)i, 4, w->big);
            if (sizes[i] > INT32_MAX) return mat_damaged(w);
        }
    }
    if (!mat_take_tag(w, end, &tag)) return false;
    if (tag.kind != MI_INT8 && tag.kind != MI_UTF8) return mat_damaged(w);
    const bool fits = tag.size < LISTED_PATH;
    if (fits && !mat_take_content(w, &tag, own, sizeof own)) return false;
    if (!name) name = own, length = fits ? strnlen(own, (size_t)tag.size) : 0;
    // A variable without a name has what objects of MATLAB keep for themselves.
    if (fits && mat_enter(w, name, length)) {
        if (!mat_values_of(w, end, class, word & 0x800U, rank, sizes, depth)) return false;
        w->path[before] = '\0';
    }
    return mat_stream_skip(w->file, w->stream, end - mat_stream_at(w->stream));
}

/// Lists what a compressed element has.
static bool mat_compressed(mat_walk *w) {
    mat_tag tag;
    if (!mat_take_tag(w, UINT64_MAX, &tag)) return false;
    if (tag.kind == MI_MATRIX && !mat_matrix(w, tag.size, NULL, 0, 0)) return false;
    return mat_stream_finish(w->file, w->stream);
}

static bool mat_list_5(mat_walk *w) {
    unsigned char head[MAT_HEAD];
    if (!foreign_read(w->file, 0, head, sizeof head)) return false;
    w->big = head[126] == 'M';
    for (uint64_t at = sizeof head; at < w->file->source->size;) {
        unsigned char tag[8];
        if (!foreign_read(w->file, at, tag, sizeof tag)) return false;
        const uint64_t kind = mat_whole(tag, 4, w->big), size = mat_whole(tag + 4, 4, w->big);
        at += sizeof tag;
        w->element = at;
        w->element_size = size;
        w->deflated = kind == MI_COMPRESSED;
        if (!mat_stream_open(w->file, &w->stream, at, size, w->deflated)) return false;
        if (w->deflated ? !mat_compressed(w) : kind == MI_MATRIX && !mat_matrix(w, size, NULL, 0, 0)) return false;
        at += size;
    }
    return true;
}

// ---------------------------------------------------------------- level 4

static bool mat_list_4(mat_walk *w) {
    for (uint64_t at = 0; at < w->file->source->size;) {
        unsigned char bytes[MAT_HEAD_4];
        char name[LISTED_PATH];
        mat_head_4 head;
        if (!foreign_read(w->file, at, bytes, sizeof bytes)) return false;
        if (!mat_read_head_4(bytes, &head)) return mat_damaged(w);
        at += sizeof bytes;
        if (!foreign_read(w->file, at, name, (size_t)head.name)) return false;
        at += head.name;
        const uint64_t count = head.rows * head.columns, size = count * head.type.size * (head.complex ? 2 : 1);
        w->element = at;
        w->element_size = size;
        if (!mat_stream_open(w->file, &w->stream, at, size, false)) return false;
        if (mat_enter(w, name, strnlen(name, (size_t)head.name))) {
            const uint64_t sizes[] = {head.rows, head.columns};
            const char *described = head.kind == MAT_TEXT     ? "texts"
                                    : head.kind == MAT_SPARSE ? "sparse numbers"
                                    : head.complex            ? "complex numbers"
                                                              : NULL;
            listed_array *own = mat_add(w, 2, sizes, described);
            if (!own) return false;
            own->type = head.type;
            if (head.kind == MAT_TEXT && !mat_take_unit(w, own, &own->type, count)) return false;
            w->path[0] = '\0';
        }
        at += size;
    }
    return true;
}

bool mat_list(foreign_file *file, listed_table *table) {
    mat_walk w = {.file = file, .table = table};
    const bool good = mat_is_level_5(file->source) ? mat_list_5(&w) : mat_list_4(&w);
    mat_stream_close(w.stream);
    if (good) mat_join_units(table);
    return good;
}

// ---------------------------------------------------------------- numbers

bool mat_find(const listed_table *table, const char *name, listed_array *out) {
    name += strspn(name, "/");
    for (size_t i = 0; i < table->count; i++) {
        const char *own = table->arrays[i].name, *at = name;
        // Members may be written as MATLAB does, "run.x".
        while (*own && (*own == *at || (*own == '/' && *at == '.'))) own++, at++;
        if (*own || *at) continue;
        *out = table->arrays[i];
        return true;
    }
    return false;
}

/// Takes the next numbers of the stream.
static bool mat_take_numbers(foreign_file *file, mat_stream *stream, const foreign_type *type, size_t count,
                             double *out) {
    enum { SOME = 1024 };
    unsigned char bytes[SOME * 8];
    for (size_t done = 0; done < count;) {
        const size_t some = count - done < SOME ? count - done : SOME;
        if (!mat_stream_take(file, stream, bytes, some * type->size)) return false;
        for (size_t i = 0; i < some; i++) out[done + i] = foreign_number(type, bytes + i * type->size);
        done += some;
    }
    return true;
}

bool mat_values(foreign_file *file, listed_table *table, const listed_array *array, const size_t *first,
                const size_t *count, double *out) {
    const arrays_item *item = &array->item;
    uint64_t place[ARRAYS_MAX_RANK] = {0};
    const int rank = item->rank;
    for (int i = 0; i < rank; i++) {
        if (first[i] > item->sizes[i] || count[i] > item->sizes[i] - first[i])
            return foreign_fail(file, "has no such part");
        if (count[i] == 0) return true;
        place[i] = first[i];
    }
    // Rows of the last dimension follow one another in the file: the stream never goes back within an array.
    const size_t row = rank > 0 ? count[rank - 1] : 1;
    for (int i = rank - 1; i >= 0;) {
        uint64_t at = 0;
        for (int k = 0; k < rank; k++) at = at * item->sizes[k] + place[k];
        at = array->at + at * array->type.size;
        if ((!mat_stream_is(table->stream, array->element, array->deflated) || mat_stream_at(table->stream) > at) &&
            !mat_stream_open(file, &table->stream, array->element, array->element_size, array->deflated))
            return false;
        if (!mat_stream_skip(file, table->stream, at - mat_stream_at(table->stream)) ||
            !mat_take_numbers(file, table->stream, &array->type, row, out))
            return false;
        out += row;
        // Step to the next row.
        for (i = rank - 2; i >= 0; i--) {
            if (++place[i] < first[i] + count[i]) break;
            place[i] = first[i];
        }
    }
    return true;
}
