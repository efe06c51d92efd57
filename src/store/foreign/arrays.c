// Arrays of numbers in measured files (whirl/internal/arrays.h).
#include "whirl/internal/arrays.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "foreign.h"
#include "input.h"
#include "listed.h"
#include "utf8.h"
#include "whirl/engine/descriptor.h"

enum { ARRAYS_PATH = 1024, ARRAYS_MAX_NAMES = 10000, ARRAYS_MAX_DEPTH = 16 };

struct arrays_file {
    foreign_file foreign;
    byte_source source;
    byte_file bytes;     ///< open where its descriptor is 0 or more
    listed_table listed; ///< arrays of a file that is no HDF5 file
    char path[ARRAYS_PATH];
};

// ---------------------------------------------------------------- opening

/// Returns true if the source has the superblock of an HDF5 file, at its beginning or after a block of the user's of up
/// to `most` bytes.
static bool source_is_hdf5(const byte_source *source, uint64_t most) {
    uint64_t at;
    return foreign_find_superblock(source, most, &at) == 0 && at < source->size;
}

static bool source_is_file(const byte_source *source) {
    return source_is_hdf5(source, 4096) || mat_is_file(source) || universal_is_file(source);
}

bool arrays_is_file(const char *path) {
    byte_file *file = malloc(sizeof *file);
    if (!file || bytes_open(file, path).code != WHIRL_OK) {
        free(file);
        return false;
    }
    const bool found = source_is_file(&file->source);
    bytes_close(file);
    free(file);
    return found;
}

bool arrays_is_bytes(const void *bytes, size_t size) {
    const byte_source source = bytes_of_memory(bytes, size);
    return source_is_file(&source);
}

/// Ends a call: returns the file's status, with the path and the name of the dataset or object (unless NULL) before its
/// sentence, and clears the status in the file, so that it can be read again.
static whirl_status arrays_end(arrays_file *file, const char *name) {
    const whirl_status status = file->foreign.status;
    file->foreign.status = whirl_ok();
    file->foreign.visits = FOREIGN_MAX_VISITS;
    if (status.code == WHIRL_OK || status.code == WHIRL_NO_MEMORY) return status;
    return name ? whirl_fail(status.code, "%.150s: %.100s %.200s", file->path, name, status.message)
                : whirl_fail(status.code, "%.150s: %.300s", file->path, status.message);
}

/// Makes a file that is not open yet; NULL without memory.
static arrays_file *arrays_new(const char *path) {
    arrays_file *file = calloc(1, sizeof *file);
    if (!file) return NULL;
    file->bytes.descriptor = -1;
    snprintf(file->path, sizeof file->path, "%s", path);
    return file;
}

/// Finds the superblock of an HDF5 file, or lists the arrays of a file of another kind.
static whirl_status arrays_begin(arrays_file *file, arrays_file **out) {
    const byte_source *source = &file->source;
    file->listed.kind = source_is_hdf5(source, 4096) ? LISTED_NONE
                        : mat_is_file(source)        ? LISTED_MAT
                        : universal_is_file(source)  ? LISTED_UNIVERSAL
                                                     : LISTED_NONE;
    if (file->listed.kind == LISTED_NONE)
        foreign_open(&file->foreign, source);
    else
        file->foreign = (foreign_file){.source = source};
    if (file->listed.kind == LISTED_MAT) mat_list(&file->foreign, &file->listed);
    if (file->listed.kind == LISTED_UNIVERSAL) universal_list(&file->foreign, &file->listed);
    const whirl_status status = arrays_end(file, NULL);
    *out = status.code == WHIRL_OK ? file : NULL;
    if (status.code != WHIRL_OK) arrays_close(file);
    return status;
}

whirl_status arrays_open_bytes(const void *bytes, size_t size, const char *name, arrays_file **out) {
    arrays_file *file = arrays_new(name);
    *out = NULL;
    if (!file) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a file of numbers");
    file->source = bytes_of_memory(bytes, size);
    return arrays_begin(file, out);
}

whirl_status arrays_open(const char *path, arrays_file **out) {
    arrays_file *file = arrays_new(path);
    *out = NULL;
    if (!file) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a file of numbers");
    const whirl_status status = bytes_open(&file->bytes, path);
    if (status.code != WHIRL_OK) {
        arrays_close(file);
        return status;
    }
    file->source = file->bytes.source;
    return arrays_begin(file, out);
}

void arrays_close(arrays_file *file) {
    if (file) bytes_close(&file->bytes);
    if (file) listed_free(&file->listed);
    free(file);
}

// ---------------------------------------------------------------- attributes

/// A search for an attribute, and its value.
typedef struct attribute_search {
    foreign_file *file;
    const char *name;
    char *text; ///< NULL: a number is looked for
    size_t size;
    double number;
    bool found;
} attribute_search;

/// Copies a text of an attribute that is in a heap of the file (III.E, global heap).
static void attribute_long_text(attribute_search *of, plain_part value) {
    enum { HEAD = 16 };
    plain_skip(&value, 4);
    const uint64_t address = plain_number(&value, 8), index = plain_number(&value, 4);
    unsigned char head[HEAD] = {0};
    if (value.short_of || address == 0 || !foreign_read(of->file, address, head, sizeof head)) return;
    plain_part part = {head + 8, 8, false};
    const uint64_t size = plain_number(&part, 8);
    unsigned char *block = foreign_block(of->file, address, size < HEAD ? HEAD : size, "GCOL");
    if (!block) return;
    part = (plain_part){block + HEAD, size < HEAD ? 0 : (size_t)size - HEAD, false};
    while (part.left >= HEAD) {
        const uint64_t own = plain_number(&part, 2);
        plain_skip(&part, 6);
        const uint64_t length = plain_number(&part, 8);
        if (own == 0 || length > part.left) break;
        if (own == index) {
            snprintf(of->text, of->size, "%.*s", (int)(length < of->size ? length : of->size - 1),
                     (const char *)part.at);
            break;
        }
        plain_skip(&part, (size_t)((length + 7) / 8 * 8));
    }
    free(block);
}

/// Takes an attribute (IV.A.2.m): name, type, space and value follow one another.
static bool attribute_take(void *context, plain_part part) {
    attribute_search *of = context;
    foreign_type type;
    foreign_array space = {.rank = 0};
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    const size_t name = (size_t)plain_number(&part, 2);
    size_t type_size = (size_t)plain_number(&part, 2), space_size = (size_t)plain_number(&part, 2), room = name;
    if (version == 3) plain_skip(&part, 1);
    if (version == 1) room = (room + 7) / 8 * 8;
    if (part.short_of || version < 1 || version > 3 || room > part.left || name == 0)
        return foreign_fail(of->file, "is damaged");
    const size_t length = strnlen((const char *)part.at, name);
    if (strlen(of->name) != length || memcmp(part.at, of->name, length) != 0 || (version > 1 && (flags & 3U)))
        return true;
    plain_skip(&part, room);
    const plain_part of_type = {part.at, type_size < part.left ? type_size : part.left, false};
    plain_skip(&part, version == 1 ? (type_size + 7) / 8 * 8 : type_size);
    const plain_part of_space = {part.at, space_size < part.left ? space_size : part.left, false};
    plain_skip(&part, version == 1 ? (space_size + 7) / 8 * 8 : space_size);
    if (part.short_of) return foreign_fail(of->file, "is damaged");
    if (!foreign_type_read(of->file, of_type, &type) || !foreign_space_read(of->file, of_space, &space)) return false;
    for (int i = 0; i < space.rank; i++)
        if (space.sizes[i] != 1) return false;
    if (type.size > part.left) return foreign_fail(of->file, "is damaged");
    of->found = true;
    if (of->text && type.kind == FOREIGN_TEXT)
        snprintf(of->text, of->size, "%.*s", (int)(type.size < of->size ? type.size : of->size - 1),
                 (const char *)part.at);
    if (of->text && type.kind == FOREIGN_LONG_TEXT) attribute_long_text(of, (plain_part){part.at, type.size, false});
    if (!of->text && (type.kind == FOREIGN_WHOLE || type.kind == FOREIGN_REAL))
        of->number = foreign_number(&type, part.at);
    return false;
}

/// Reads a text that is an attribute of an object; "" without one.
static void attribute_text(foreign_file *file, const foreign_object *object, const char *name, char *text,
                           size_t size) {
    attribute_search of = {.file = file, .name = name, .text = text, .size = size};
    *text = '\0';
    foreign_attributes(file, object, attribute_take, &of);
    // Names and units are shown: a text that a terminal might obey (control characters) counts as absent. A text may be
    // padded by blanks.
    for (size_t i = 0, length; text[i]; i += length) {
        length = utf8_length(text + i, strlen(text + i));
        if (utf8_is_plain(text + i, length)) continue;
        text[0] = '\0';
        break;
    }
    for (size_t end = strlen(text); end > 0 && text[end - 1] == ' ';) text[--end] = '\0';
}

static double attribute_number(foreign_file *file, const foreign_object *object, const char *name) {
    attribute_search of = {.file = file, .name = name, .number = NAN};
    foreign_attributes(file, object, attribute_take, &of);
    return of.number;
}

// ---------------------------------------------------------------- names

/// A search for a member of a group.
typedef struct member_search {
    const char *name;
    size_t length;
    uint64_t address;
    bool found;
} member_search;

static bool member_take(void *context, const char *name, size_t length, uint64_t address) {
    member_search *of = context;
    of->found = length == of->length && memcmp(name, of->name, length) == 0;
    if (of->found) of->address = address;
    return !of->found;
}

/// Finds an object by its path. Returns false after a failure, or if there is none (file->status is good then).
static bool arrays_address(foreign_file *file, const char *path, uint64_t *address) {
    *address = file->root;
    for (const char *at = path + strspn(path, "/"); *at; at += strspn(at, "/")) {
        member_search of = {.name = at, .length = strcspn(at, "/")};
        foreign_object group;
        if (foreign_object_read(file, *address, &group)) foreign_links(file, &group, member_take, &of);
        foreign_object_free(&group);
        if (file->status.code != WHIRL_OK || !of.found) return false;
        *address = of.address;
        at += of.length;
    }
    return true;
}

/// Describes a dataset.
static void arrays_describe(foreign_file *file, const foreign_object *object, foreign_array *array, arrays_item *out) {
    char unit[ARRAYS_TEXT];
    *out = (arrays_item){.factor = 1.0};
    if (!foreign_array_read(file, object, array)) return;
    out->rank = array->rank;
    for (int i = 0; i < array->rank; i++) {
        out->sizes[i] = (size_t)array->sizes[i];
        if (out->sizes[i] != array->sizes[i]) foreign_fail(file, "has more numbers than this processor can address");
    }
    out->numbers = array->type.kind == FOREIGN_WHOLE || array->type.kind == FOREIGN_REAL;
    out->described = array->type.described;
    // MATLAB's texts are whole numbers with an attribute.
    attribute_text(file, object, "MATLAB_class", unit, sizeof unit);
    if (out->numbers && strcmp(unit, "char") == 0) out->numbers = false, out->described = "texts";
    attribute_text(file, object, "unit", out->unit, sizeof out->unit);
    if (!*out->unit) attribute_text(file, object, "units", out->unit, sizeof out->unit);
    // whirl's own numbers say what they are in SI.
    attribute_text(file, object, "SI_unit", unit, sizeof unit);
    const double factor = *unit ? attribute_number(file, object, "SI_factor") : (double)NAN;
    if (!isfinite(factor)) return;
    memcpy(out->unit, unit, sizeof unit);
    out->factor = factor;
}

/// A walk through all groups.
typedef struct name_walk {
    foreign_file *file;
    arrays_visitor visit;
    void *context;
    size_t seen;
    int depth;
    char path[ARRAYS_PATH];
    whirl_status status;
} name_walk;

static bool walk_member(void *context, const char *name, size_t length, uint64_t address) {
    name_walk *of = context;
    const size_t before = strlen(of->path);
    foreign_object object;
    if (of->seen == ARRAYS_MAX_NAMES) return false;
    if (of->depth == ARRAYS_MAX_DEPTH || before + length + 2 > sizeof of->path) return true;
    of->seen++;
    snprintf(of->path + before, sizeof of->path - before, "%s%.*s", before > 0 ? "/" : "", (int)length, name);
    if (foreign_object_read(of->file, address, &object)) {
        if (foreign_object_find(&object, FOREIGN_LAYOUT)) {
            arrays_item item;
            foreign_array array;
            arrays_describe(of->file, &object, &array, &item);
            // A dataset that cannot be understood does not matter unless it is asked for.
            if (of->file->status.code == WHIRL_BAD_INPUT)
                of->file->status = whirl_ok();
            else
                of->status = of->visit(of->context, of->path, &item);
        } else {
            of->depth++;
            foreign_links(of->file, &object, walk_member, of);
            of->depth--;
        }
    }
    foreign_object_free(&object);
    of->path[before] = '\0';
    return of->file->status.code == WHIRL_OK && of->status.code == WHIRL_OK;
}

whirl_status arrays_visit(arrays_file *file, arrays_visitor visit, void *context) {
    if (file->listed.kind != LISTED_NONE) {
        whirl_status status = whirl_ok();
        for (size_t i = 0; i < file->listed.count && status.code == WHIRL_OK; i++)
            status = visit(context, file->listed.arrays[i].name, &file->listed.arrays[i].item);
        return status;
    }
    name_walk of = {.file = &file->foreign, .visit = visit, .context = context, .status = whirl_ok()};
    foreign_object root;
    if (foreign_object_read(&file->foreign, file->foreign.root, &root))
        foreign_links(&file->foreign, &root, walk_member, &of);
    foreign_object_free(&root);
    const whirl_status status = arrays_end(file, NULL);
    return status.code != WHIRL_OK ? status : of.status;
}

/// Names of a file's datasets.
typedef struct name_table {
    size_t count, capacity;
    char **names;
} name_table;

static whirl_status keep_name(void *context, const char *name, const arrays_item *item) {
    name_table *of = context;
    (void)item;
    if (of->count == of->capacity) {
        const size_t capacity = of->capacity ? 2 * of->capacity : 64;
        char **names = realloc(of->names, capacity * sizeof *names);
        if (!names) return whirl_fail(WHIRL_NO_MEMORY, "no memory for names");
        of->names = names;
        of->capacity = capacity;
    }
    of->names[of->count] = strdup(name);
    if (!of->names[of->count]) return whirl_fail(WHIRL_NO_MEMORY, "no memory for names");
    of->count++;
    return whirl_ok();
}

/// Fails for a dataset that is not there, with the nearest name or some of them.
static whirl_status arrays_missing(arrays_file *file, const char *name) {
    name_table all = {.count = 0};
    char text[WHIRL_MESSAGE_SIZE] = "";
    whirl_status status = arrays_visit(file, keep_name, &all);
    if (status.code != WHIRL_NO_MEMORY) {
        enum { SOME = 6 };
        const char *nearest = whirl_nearest_name(name, (const char *const *)all.names, all.count);
        if (nearest) snprintf(text, sizeof text, "did you mean '%.100s'?", nearest);
        for (size_t i = 0; !nearest && i < all.count && i < SOME; i++) {
            const size_t used = strlen(text);
            snprintf(text + used, sizeof text - used, "%s%.60s", i ? ", " : "expected one of ", all.names[i]);
        }
        if (!nearest && all.count > SOME) snprintf(text + strlen(text), sizeof text - strlen(text), ", ...");
        const int kind = (int)file->listed.kind;
        status = whirl_fail(WHIRL_BAD_INPUT, "%.150s has no %s '%.100s'%s%.300s", file->path,
                            kind == LISTED_MAT         ? "variable"
                            : kind == LISTED_UNIVERSAL ? "record"
                                                       : "dataset",
                            name, *text ? ", " : "", text);
    }
    for (size_t i = 0; i < all.count; i++) free(all.names[i]);
    free(all.names);
    return status;
}

/// Reads any object, which is to be freed in any case. Returns false if there is none of that name, or after a failure,
/// which stays in file->foreign.status.
static bool arrays_object(arrays_file *file, const char *name, foreign_object *object) {
    uint64_t address;
    *object = (foreign_object){0};
    return arrays_address(&file->foreign, name, &address) && foreign_object_read(&file->foreign, address, object);
}

/// Finds an array of a file that is no HDF5 file.
static whirl_status arrays_listed(arrays_file *file, const char *name, listed_array *out) {
    const bool found =
        file->listed.kind == LISTED_MAT ? mat_find(&file->listed, name, out) : universal_find(&file->listed, name, out);
    return found ? whirl_ok() : arrays_missing(file, name);
}

/// Opens a dataset; the object is to be freed in any case.
static whirl_status arrays_dataset(arrays_file *file, const char *name, foreign_object *object) {
    const bool found = arrays_object(file, name, object);
    const whirl_status status = arrays_end(file, NULL);
    if (status.code != WHIRL_OK) return status;
    if (!found) return arrays_missing(file, name);
    return foreign_object_find(object, FOREIGN_LAYOUT)
               ? whirl_ok()
               : whirl_fail(WHIRL_BAD_INPUT, "%.150s: %.100s is a group, expected a dataset", file->path, name);
}

/// Reads the unit of a variable of MATLAB from another one, the text `x_unit`; "" without one.
static void arrays_unit_of_matlab(arrays_file *file, const char *name, char unit[ARRAYS_TEXT]) {
    enum { MAX_TEXT = 64 };
    static const char *const words[] = {"_unit", "_units"};
    char other[ARRAYS_PATH];
    double letters[MAX_TEXT];
    for (size_t k = 0; k < 2 && !*unit; k++) {
        foreign_object object;
        foreign_array array = {.rank = 0};
        arrays_item item = {.numbers = true};
        snprintf(other, sizeof other, "%s%s", name, words[k]);
        if (arrays_object(file, other, &object) && foreign_object_find(&object, FOREIGN_LAYOUT))
            arrays_describe(&file->foreign, &object, &array, &item);
        const size_t rows = item.rank == 2 ? item.sizes[0] : 0, columns = item.rank == 2 ? item.sizes[1] : 0;
        const size_t first[] = {0, 0}, count[] = {rows, columns};
        const bool text = item.described && strcmp(item.described, "texts") == 0 && array.type.kind == FOREIGN_WHOLE;
        if (text && rows <= MAX_TEXT && columns == 1 && foreign_values(&file->foreign, &array, first, count, letters)) {
            size_t length = 0;
            while (length < rows && letters[length] >= ' ' && letters[length] < 0x7f) length++;
            for (size_t i = 0; length == rows && i < rows; i++) unit[i] = (char)letters[i], unit[i + 1] = '\0';
        }
        foreign_object_free(&object);
        arrays_end(file, NULL);
    }
}

whirl_status arrays_find(arrays_file *file, const char *name, arrays_item *out) {
    foreign_object object;
    foreign_array array;
    *out = (arrays_item){.factor = 1.0};
    if (file->listed.kind != LISTED_NONE) {
        listed_array own;
        const whirl_status found = arrays_listed(file, name, &own);
        if (found.code == WHIRL_OK) *out = own.item;
        return found;
    }
    whirl_status status = arrays_dataset(file, name, &object);
    if (status.code == WHIRL_OK) {
        arrays_describe(&file->foreign, &object, &array, out);
        status = arrays_end(file, name);
        if (status.code == WHIRL_OK && !*out->unit) arrays_unit_of_matlab(file, name, out->unit);
    }
    foreign_object_free(&object);
    return status;
}

/// Reads a part of an array of a file that is no HDF5 file.
static whirl_status arrays_read_listed(arrays_file *file, const char *name, const size_t *first, const size_t *count,
                                       double *out) {
    listed_array own;
    const whirl_status status = arrays_listed(file, name, &own);
    if (status.code != WHIRL_OK) return status;
    if (!own.item.numbers)
        foreign_fail(&file->foreign, "has %s, expected numbers", own.item.described);
    else if (file->listed.kind == LISTED_MAT)
        mat_values(&file->foreign, &file->listed, &own, first, count, out);
    else
        universal_values(&file->foreign, &file->listed, &own, first, count, out);
    return arrays_end(file, name);
}

whirl_status arrays_read(arrays_file *file, const char *name, const size_t *first, const size_t *count, double *out) {
    if (file->listed.kind != LISTED_NONE) return arrays_read_listed(file, name, first, count, out);
    foreign_object object;
    foreign_array array;
    whirl_status status = arrays_dataset(file, name, &object);
    if (status.code == WHIRL_OK) {
        if (foreign_array_read(&file->foreign, &object, &array)) {
            if (array.type.kind == FOREIGN_WHOLE || array.type.kind == FOREIGN_REAL)
                foreign_values(&file->foreign, &array, first, count, out);
            else
                foreign_fail(&file->foreign, "has %s, expected numbers", array.type.described);
        }
        status = arrays_end(file, name);
    }
    foreign_object_free(&object);
    return status;
}

// ---------------------------------------------------------------- attributes of objects and files

whirl_status arrays_text(arrays_file *file, const char *object, const char *attribute, char *text, size_t size) {
    foreign_object own;
    *text = '\0';
    if (file->listed.kind != LISTED_NONE) return whirl_ok();
    if (arrays_object(file, object, &own)) attribute_text(&file->foreign, &own, attribute, text, size);
    foreign_object_free(&own);
    return arrays_end(file, object);
}

whirl_status arrays_number(arrays_file *file, const char *object, const char *attribute, double *out) {
    foreign_object own;
    *out = NAN;
    if (file->listed.kind != LISTED_NONE) return whirl_ok();
    if (arrays_object(file, object, &own)) *out = attribute_number(&file->foreign, &own, attribute);
    foreign_object_free(&own);
    return arrays_end(file, object);
}

bool arrays_is_foreign(const char *path) {
    arrays_file *file;
    char format[ARRAYS_TEXT] = "whirl result";
    if (!arrays_is_file(path) || arrays_open(path, &file).code != WHIRL_OK) return false;
    const whirl_status status = arrays_text(file, "/", "format", format, sizeof format);
    arrays_close(file);
    return status.code == WHIRL_OK && strcmp(format, "whirl result") != 0;
}
