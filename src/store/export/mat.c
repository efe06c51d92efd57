// Results as MAT files of version 5, compressed ("MAT-File Format", MathWorks 2023); docs/result-file.md describes
// their content.
#include "mat.h"

#include "atomic_file.h"
#include "bytes.h"
#include "shape.h"
#include "stored.h"
#include "utf8.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

#include <matio.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAT_NAME_SIZE = 64,    ///< name of a variable or member with its zero byte, as in MATLAB
    MAT_HEADER = 128,      ///< bytes before the first variable
    MAT_ELEMENT_BYTES = 96 ///< bytes of a variable, or of a text in a list, in addition to its values
};

/// Limit of a variable: MATLAB and Octave count its bytes with 31 bits.
static const size_t most_bytes = INT32_MAX;

typedef struct mat_writer {
    mat_t *mat;
    size_t most, bytes; ///< limit of a variable; bytes of the current one so far
    size_t written;     ///< number of variables written
    const char *variable, *path;
} mat_writer;

/// The struct that receives the members and attributes of a visited group.
typedef struct mat_target {
    mat_writer *writer;
    matvar_t *group;
} mat_target;

static void no_memory(whirl_status *status) {
    if (status->code == WHIRL_OK) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory to export the result");
}

// ---------------------------------------------------------------- names

static bool is_keyword(const char *name) {
    static const char *const keywords[] = {
        "break",  "case", "catch",     "classdef", "continue",   "else",   "elseif", "end",    "for", "function",
        "global", "if",   "otherwise", "parfor",   "persistent", "return", "spmd",   "switch", "try", "while"};
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; ++i)
        if (strcmp(name, keywords[i]) == 0) return true;
    return false;
}

static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Writes a valid MATLAB name: letters, digits and underscores, a letter first, no keyword.
static void valid_name(const char *raw, char name[MAT_NAME_SIZE]) {
    snprintf(name, MAT_NAME_SIZE, "%s%.58s", is_letter(raw[0]) ? "" : "x_", raw);
    for (char *c = name; *c; ++c)
        if (!is_letter(*c) && !(*c >= '0' && *c <= '9')) *c = '_';
    if (is_keyword(name)) strcat(name, "_");
}

// ---------------------------------------------------------------- values

static matvar_t *new_group(void) {
    size_t one[2] = {1, 1};
    return Mat_VarCreateStruct(NULL, 2, one, NULL, 0);
}

/// Adds a variable to a struct, which then owns it; frees it on failure.
static void add(whirl_status *status, matvar_t *group, const char *raw, matvar_t *value) {
    char name[MAT_NAME_SIZE];
    valid_name(raw, name);
    if (status->code == WHIRL_OK && Mat_VarGetStructFieldByName(group, name, 0))
        *status = whirl_fail(WHIRL_BAD_INPUT, "two members of a group are called %s in MATLAB", name);
    if (!value || (status->code == WHIRL_OK && Mat_VarAddStructField(group, name) != 0)) no_memory(status);
    if (status->code == WHIRL_OK)
        Mat_VarSetStructFieldByName(group, name, 0, value);
    else
        Mat_VarFree(value);
}

/// Converts a character of `bytes` bytes (0: invalid) to one UTF-16 unit. SciPy cannot load files with surrogate pairs,
/// so characters beyond U+FFFF become U+FFFD.
static uint16_t utf16_unit(const char *text, size_t bytes) {
    const unsigned character = bytes ? utf8_character(text, bytes) : 0xfffd;
    return character > 0xffff ? 0xfffd : (uint16_t)character;
}

static matvar_t *text_variable(const char *text, size_t width) {
    const size_t length = strnlen(text, width);
    uint16_t *units = calloc(length + 1, sizeof *units);
    if (!units) return NULL;
    size_t count = 0;
    for (size_t at = 0; at < length; ++count) {
        const size_t bytes = utf8_length(text + at, length - at);
        units[count] = utf16_unit(text + at, bytes);
        at += bytes ? bytes : 1;
    }
    size_t sizes[2] = {count > 0, count};
    matvar_t *variable = Mat_VarCreate(NULL, MAT_C_CHAR, MAT_T_UTF16, 2, sizes, units, 0);
    free(units);
    return variable;
}

/// Converts an index with the last dimension fastest to one with the first dimension fastest.
static size_t by_columns(const stored_array *array, size_t at) {
    size_t place = 0, stride = array->count;
    for (int i = array->rank - 1; i >= 0; --i) {
        stride /= array->sizes[i];
        place += at % array->sizes[i] * stride;
        at /= array->sizes[i];
    }
    return place;
}

/// Makes a variable of numbers or texts with the dimensions of the file; lists become columns.
static matvar_t *new_variable(const stored_array *array) {
    static const enum matio_classes classes[] = {MAT_C_DOUBLE, MAT_C_INT64, MAT_C_CELL};
    static const enum matio_types types[] = {MAT_T_DOUBLE, MAT_T_INT64, MAT_T_CELL};
    const size_t width = array->kind == STORED_TEXTS ? sizeof(matvar_t *) : array->width;
    size_t sizes[SHAPE_MAX_RANK] = {1, 1};
    for (int i = 0; i < array->rank; ++i) sizes[i] = array->sizes[i];
    char *values = calloc(array->count + 1, width);
    for (size_t i = 0; values && i < array->count; ++i) {
        char *to = values + by_columns(array, i) * width;
        const char *from = (const char *)array->values + i * array->width;
        matvar_t *text = array->kind == STORED_TEXTS ? text_variable(from, array->width) : NULL;
        memcpy(to, array->kind == STORED_TEXTS ? (const char *)&text : from, width);
    }
    matvar_t *variable = values ? Mat_VarCreate(NULL, classes[array->kind], types[array->kind],
                                                array->rank > 2 ? array->rank : 2, sizes, values, 0)
                                : NULL;
    free(values);
    return variable;
}

static void put_array(whirl_status *status, matvar_t *group, const char *name, const stored_array *array) {
    const bool text = array->kind == STORED_TEXTS && array->rank == 0;
    add(status, group, name, text ? text_variable(array->values, array->width) : new_variable(array));
}

/// Adds the size of an array to that of its variable, before the array is read; fails if the variable becomes too
/// large.
static void count_bytes(whirl_status *status, mat_writer *writer, const stored_array *array) {
    const size_t each = array->kind == STORED_TEXTS ? 2 * array->width + MAT_ELEMENT_BYTES : array->width;
    const size_t left = writer->most - writer->bytes;
    if (status->code != WHIRL_OK) return;
    if (array->count <= left / each && array->count * each + MAT_ELEMENT_BYTES <= left)
        writer->bytes += array->count * each + MAT_ELEMENT_BYTES;
    else
        *status = whirl_fail(WHIRL_IO_ERROR,
                             "cannot write %.200s: '%.40s' is larger than the %zu bytes that a variable of a MAT file "
                             "may have: read the result file itself (h5read)",
                             writer->path, writer->variable, writer->most);
}

// ---------------------------------------------------------------- groups

static void meet_attribute(whirl_status *status, void *context, const char *name, const stored_array *array) {
    const mat_target *to = context;
    count_bytes(status, to->writer, array);
    if (status->code == WHIRL_OK) put_array(status, to->group, name, array);
}

/// Returns the attributes of an object as a struct; NULL if there are none.
static matvar_t *attributes_of(whirl_status *status, mat_writer *writer, hid_t object) {
    mat_target to = {writer, new_group()};
    if (!to.group) no_memory(status);
    stored_visit(status, object, &(stored_visitor){.attribute = meet_attribute, .context = &to});
    if (to.group && Mat_VarGetNumberOfFields(to.group) > 0) return to.group;
    Mat_VarFree(to.group);
    return NULL;
}

/// Adds the attributes of a dataset to the member `about` of its group.
static void put_about(whirl_status *status, const mat_target *to, const char *name, hid_t dataset) {
    matvar_t *said = attributes_of(status, to->writer, dataset);
    if (!said) return;
    if (!Mat_VarGetStructFieldByName(to->group, "about", 0)) add(status, to->group, "about", new_group());
    if (status->code == WHIRL_OK)
        add(status, Mat_VarGetStructFieldByName(to->group, "about", 0), name, said);
    else
        Mat_VarFree(said);
}

static matvar_t *group_variable(whirl_status *status, mat_writer *writer, hid_t group);

static void meet_member(whirl_status *status, void *context, const char *name, hid_t object) {
    const mat_target *to = context;
    if (stored_is_group(object)) {
        add(status, to->group, name, group_variable(status, to->writer, object));
        return;
    }
    stored_array array;
    stored_outline(status, object, &array);
    if (array.single) return; // signals of a data set are left out: they are larger than a variable may be
    count_bytes(status, to->writer, &array);
    stored_read(status, object, &array);
    if (status->code == WHIRL_OK) put_array(status, to->group, name, &array);
    stored_free(&array);
    put_about(status, to, name, object);
}

/// Returns a group as a struct of its members; its attributes are in the member `attributes`.
// NOLINTNEXTLINE(misc-no-recursion)
static matvar_t *group_variable(whirl_status *status, mat_writer *writer, hid_t group) {
    mat_target to = {writer, new_group()};
    if (!to.group) no_memory(status);
    stored_visit(status, group, &(stored_visitor){.member = meet_member, .context = &to});
    matvar_t *said = attributes_of(status, writer, group);
    if (said) add(status, to.group, "attributes", said);
    return to.group;
}

// ---------------------------------------------------------------- the file

static void write_variable(whirl_status *status, mat_writer *writer, const char *raw, matvar_t *variable) {
    char name[MAT_NAME_SIZE];
    valid_name(raw, name);
    if (variable) variable->name = strdup(name);
    if (!variable || !variable->name) no_memory(status);
    if (status->code == WHIRL_OK && Mat_VarWrite(writer->mat, variable, MAT_COMPRESSION_ZLIB) != 0)
        *status = whirl_fail(WHIRL_IO_ERROR, "cannot write the variable %.60s to %.250s", name, writer->path);
    Mat_VarFree(variable);
    writer->written += 1;
}

static void meet_group(whirl_status *status, void *context, const char *name, hid_t object) {
    mat_writer *writer = context;
    writer->variable = name;
    writer->bytes = 0;
    write_variable(status, writer, name, group_variable(status, writer, object));
}

static void write_root(whirl_status *status, void *context, hid_t root) {
    mat_writer *writer = context;
    stored_visit(status, root, &(stored_visitor){.member = meet_group, .context = writer});
    writer->variable = "attributes";
    writer->bytes = 0;
    if (status->code == WHIRL_OK) write_variable(status, writer, "attributes", attributes_of(status, writer, root));
}

/// Checks that the variables fill the file to its end: matio does not report a full disk.
static whirl_status check_written(const mat_writer *writer, const atomic_file *out) {
    byte_file file;
    size_t variables = 0;
    uint64_t at = MAT_HEADER;
    const whirl_status status = bytes_open(&file, out->temporary);
    if (status.code != WHIRL_OK) return status;
    uint32_t tag[2]; // kind, and the bytes that follow
    while (at + sizeof tag <= file.source.size && file.source.read(file.source.context, at, tag, sizeof tag) == 0) {
        at += sizeof tag + tag[1];
        ++variables;
    }
    const bool whole = at == file.source.size && variables == writer->written;
    bytes_close(&file);
    return whole ? whirl_ok() : whirl_fail(WHIRL_IO_ERROR, "cannot write %.300s: the disk may be full", out->path);
}

whirl_status mat_export(const char *result, const char *path, size_t most) {
    atomic_file out;
    mat_writer writer = {.most = most, .path = path};
    whirl_status status = atomic_file_open(&out, path);
    if (status.code != WHIRL_OK) return status;
    writer.mat = Mat_CreateVer(out.temporary, "MATLAB 5.0 MAT-file, written by whirl", MAT_FT_MAT5);
    status =
        writer.mat ? stored_open(result, write_root, &writer) : whirl_fail(WHIRL_IO_ERROR, "cannot write %.300s", path);
    if (writer.mat && Mat_Close(writer.mat) != 0 && status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_IO_ERROR, "cannot write %.300s: the disk may be full", path);
    if (status.code == WHIRL_OK) status = check_written(&writer, &out);
    if (status.code == WHIRL_OK) return atomic_file_commit(&out);
    atomic_file_discard(&out);
    return status;
}

whirl_status whirl_result_export_mat(const char *result, const char *path) {
    return mat_export(result, path, most_bytes);
}
