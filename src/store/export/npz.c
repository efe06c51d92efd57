// Results as NumPy's archives: a zip of .npy files (NumPy Enhancement Proposal 1, format version 1.0), named as the
// datasets of the result file. docs/result-file.md says what is in them.
#include "store.h"
#include "whirl/engine/result.h"
#include "words.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

enum {
    PATH_BYTES = 700, ///< of a name in the archive
    NPY_ALIGN = 64,   ///< the values begin at a multiple of it
    NPY_PREFIX = 10,  ///< magic, version and the length of the header
    PIECE_BYTES = 1 << 20,
    CHARACTER_BYTES = 4, ///< of a text, in UTF-32
};

typedef struct npz_writer {
    zipFile zip;
    const char *path;
    char folder[PATH_BYTES]; ///< of the group that is visited: "", "sweep/", "sweep/orbit/"
} npz_writer;

static void cannot_write(whirl_status *status, const npz_writer *writer) {
    if (status->code == WHIRL_OK)
        *status = whirl_fail(WHIRL_IO_ERROR, "cannot write %.300s: the disk may be full", writer->path);
}

// ---------------------------------------------------------------- texts

/// Characters of a text in at most `width` bytes, at most so many; a byte that is no UTF-8 counts as '?'.
static size_t decode(const char *text, size_t width, uint32_t *characters) {
    const size_t length = strnlen(text, width);
    size_t count = 0;
    for (size_t at = 0; at < length; ++count) {
        const size_t bytes = utf8_length(text + at, length - at);
        if (characters) characters[count] = bytes ? utf8_character(text + at, bytes) : '?';
        at += bytes ? bytes : 1;
    }
    return count;
}

/// Texts as NumPy has them: all as wide as the longest, in UTF-32. Replaces the values.
static void to_characters(whirl_status *status, stored_array *texts) {
    const char *from = texts->values;
    size_t longest = 1;
    for (size_t i = 0; i < texts->count; ++i) {
        const size_t length = decode(from + i * texts->width, texts->width, NULL);
        if (length > longest) longest = length;
    }
    uint32_t *characters = calloc(texts->count * longest + 1, CHARACTER_BYTES);
    if (!characters) {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu texts", texts->count);
        return;
    }
    for (size_t i = 0; i < texts->count; ++i)
        (void)decode(from + i * texts->width, texts->width, characters + i * longest);
    free(texts->values);
    texts->values = characters;
    texts->width = longest * CHARACTER_BYTES;
}

// ---------------------------------------------------------------- entries

/// The header of an .npy file; gives its length.
static size_t npy_header(const stored_array *array, char text[256]) {
    static const char magic[8] = {'\x93', 'N', 'U', 'M', 'P', 'Y', 1, 0};
    char type[32], sizes[160] = "";
    snprintf(type, sizeof type,
             array->kind == STORED_TEXTS     ? "<U%zu"
             : array->kind == STORED_NUMBERS ? "<f8"
                                             : "<i8",
             array->width / CHARACTER_BYTES);
    for (int i = 0; i < array->rank; ++i) {
        const size_t length = strlen(sizes);
        snprintf(sizes + length, sizeof sizes - length, "%s%zu%s", i ? " " : "", array->sizes[i],
                 i + 1 < array->rank || i == 0 ? "," : "");
    }
    size_t length =
        NPY_PREFIX + (size_t)snprintf(text + NPY_PREFIX, 256 - NPY_PREFIX,
                                      "{'descr': '%s', 'fortran_order': False, 'shape': (%s), }", type, sizes);
    while ((length + 1) % NPY_ALIGN != 0) text[length++] = ' ';
    text[length++] = '\n';
    for (size_t i = 0; i < sizeof magic; ++i) text[i] = magic[i];
    text[8] = (char)((length - NPY_PREFIX) & 0xff);
    text[9] = (char)((length - NPY_PREFIX) >> 8);
    return length;
}

static bool write_values(zipFile zip, const stored_array *array) {
    const char *values = array->values;
    const size_t size = array->count * array->width;
    for (size_t at = 0; at < size; at += PIECE_BYTES) {
        const size_t left = size - at, piece = left < PIECE_BYTES ? left : PIECE_BYTES;
        if (zipWriteInFileInZip(zip, values + at, (unsigned)piece) != ZIP_OK) return false;
    }
    return true;
}

/// One entry of the archive, with no time of day, so that equal results are equal archives.
static void put_entry(whirl_status *status, npz_writer *writer, const char *name, stored_array *array) {
    char entry[PATH_BYTES], header[256];
    if (status->code == WHIRL_OK && array->kind == STORED_TEXTS) to_characters(status, array);
    if (status->code != WHIRL_OK) return;
    if (snprintf(entry, sizeof entry, "%s%s.npy", writer->folder, name) >= (int)sizeof entry) {
        *status = whirl_fail(WHIRL_BAD_INPUT, "%.200s has too long a name", name);
        return;
    }
    const zip_fileinfo timeless = {.tmz_date = {.tm_mday = 1, .tm_year = 1980}};
    const int large = array->count * array->width > UINT32_MAX / 2;
    const size_t length = npy_header(array, header);
    if (zipOpenNewFileInZip64(writer->zip, entry, &timeless, NULL, 0, NULL, 0, NULL, Z_DEFLATED, Z_DEFAULT_COMPRESSION,
                              large) != ZIP_OK) {
        cannot_write(status, writer);
        return;
    }
    bool well =
        zipWriteInFileInZip(writer->zip, header, (unsigned)length) == ZIP_OK && write_values(writer->zip, array);
    well = zipCloseFileInZip(writer->zip) == ZIP_OK && well;
    if (!well) cannot_write(status, writer);
}

static void meet_attribute(whirl_status *status, void *context, const char *name, const stored_array *array) {
    npz_writer *writer = context;
    char attribute[PATH_BYTES];
    stored_array copy = *array;
    const size_t size = array->count * array->width;
    copy.values = malloc(size + 1);
    if (!copy.values) {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %.200s", name);
        return;
    }
    memcpy(copy.values, array->values, size);
    snprintf(attribute, sizeof attribute, "@%s", name);
    put_entry(status, writer, attribute, &copy);
    stored_free(&copy);
}

static void meet_member(whirl_status *status, void *context, const char *name, hid_t object);

/// The attributes of what the folder of the writer names, "sweep/orbit/max_radius@unit".
static void put_attributes(whirl_status *status, npz_writer *writer, hid_t object) {
    stored_visit(status, object, &(stored_visitor){.attribute = meet_attribute, .context = writer});
}

/// Appends to the folder of the writer; gives its length before, at which it is cut off again.
static size_t enter(whirl_status *status, npz_writer *writer, const char *name) {
    const size_t length = strlen(writer->folder), room = sizeof writer->folder - length;
    if (snprintf(writer->folder + length, room, "%s", name) >= (int)room && status->code == WHIRL_OK)
        *status = whirl_fail(WHIRL_BAD_INPUT, "%.200s has too long a name", name);
    return length;
}

static void meet_member(whirl_status *status, void *context, const char *name, hid_t object) {
    npz_writer *writer = context;
    stored_array array;
    const bool group = stored_is_group(object);
    if (!group) {
        stored_read(status, object, &array);
        put_entry(status, writer, name, &array);
        stored_free(&array);
    }
    const size_t length = enter(status, writer, name);
    put_attributes(status, writer, object);
    if (group) (void)enter(status, writer, "/");
    if (group) stored_visit(status, object, &(stored_visitor){.member = meet_member, .context = writer});
    writer->folder[length] = '\0';
}

// ---------------------------------------------------------------- the file

static void write_root(whirl_status *status, void *context, hid_t root) {
    npz_writer *writer = context;
    put_attributes(status, writer, root);
    stored_visit(status, root, &(stored_visitor){.member = meet_member, .context = writer});
}

whirl_status whirl_result_export_npz(const char *result, const char *path) {
    atomic_file out;
    npz_writer writer = {.path = path};
    whirl_status status = atomic_file_open(&out, path);
    if (status.code != WHIRL_OK) return status;
    writer.zip = zipOpen64(out.temporary, APPEND_STATUS_CREATE);
    status =
        writer.zip ? stored_open(result, write_root, &writer) : whirl_fail(WHIRL_IO_ERROR, "cannot write %.300s", path);
    if (writer.zip && zipClose(writer.zip, NULL) != ZIP_OK) cannot_write(&status, &writer);
    if (status.code == WHIRL_OK) return atomic_file_commit(&out);
    atomic_file_discard(&out);
    return status;
}
