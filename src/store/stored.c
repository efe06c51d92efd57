#include "stored.h"
#include "bytes.h"
#include "shape.h"

#include "exhausted.h"
#include "h5file.h"
#include "read.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_BYTES = 256 };

bool stored_is_group(hid_t object) {
    return H5Iget_type(object) == H5I_GROUP;
}

static whirl_status damaged(const char *name) {
    return whirl_fail(WHIRL_BAD_INPUT, "%.200s cannot be read: the file is damaged", name);
}

static void name_of(hid_t object, char name[NAME_BYTES]) {
    name[0] = '\0';
    H5Iget_name(object, name, NAME_BYTES);
}

// ---------------------------------------------------------------- values

/// Finds the kind and shape of an array by its type and space, which it closes.
static bool describe(hid_t type, hid_t space, stored_array *array) {
    *array = (stored_array){.count = 1};
    hsize_t sizes[SHAPE_MAX_RANK];
    const int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
    bool well = type >= 0 && rank >= 0 && rank <= SHAPE_MAX_RANK && H5Sget_simple_extent_dims(space, sizes, NULL) >= 0;
    if (well) {
        const H5T_class_t class = H5Tget_class(type);
        array->kind = class == H5T_FLOAT ? STORED_NUMBERS : class == H5T_INTEGER ? STORED_WHOLES : STORED_TEXTS;
        array->width = class == H5T_STRING ? H5Tget_size(type) : sizeof(double);
        array->single = class == H5T_FLOAT && H5Tget_size(type) < sizeof(double);
        array->rank = rank;
        well = array->width > 0 && (class == H5T_FLOAT || class == H5T_INTEGER || class == H5T_STRING);
    }
    for (int i = 0; well && i < rank; ++i) {
        array->sizes[i] = (size_t)sizes[i];
        well = sizes[i] == 0 || array->count <= SIZE_MAX / 16 / sizes[i] / array->width;
        array->count *= well ? (size_t)sizes[i] : 1;
    }
    if (space >= 0) H5Sclose(space);
    if (type >= 0) H5Tclose(type);
    return well;
}

/// Returns the type of values in memory: that of the file for texts, else double or int64.
static hid_t memory_type(const stored_array *array, hid_t stored) {
    return array->kind == STORED_TEXTS ? stored : array->kind == STORED_NUMBERS ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
}

static bool make_room(whirl_status *status, stored_array *array, const char *name) {
    array->values = calloc(array->count ? array->count : 1, array->width);
    if (!array->values) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the values of %.200s", name);
    return array->values;
}

void stored_outline(whirl_status *status, hid_t dataset, stored_array *outline) {
    char name[NAME_BYTES];
    *outline = (stored_array){0};
    if (status->code != WHIRL_OK) return;
    name_of(dataset, name);
    const hid_t type = H5Dget_type(dataset);
    const size_t width = H5Tget_size(type);
    const bool well = describe(type, H5Dget_space(dataset), outline);
    if (!well || width == 0 || H5Dget_storage_size(dataset) / width < outline->count) *status = damaged(name);
}

void stored_read(whirl_status *status, hid_t dataset, stored_array *array) {
    char name[NAME_BYTES];
    stored_outline(status, dataset, array);
    if (status->code != WHIRL_OK) return;
    name_of(dataset, name);
    const hid_t type = H5Dget_type(dataset);
    if (make_room(status, array, name) && array->count > 0 &&
        H5Dread(dataset, memory_type(array, type), H5S_ALL, H5S_ALL, H5P_DEFAULT, array->values) < 0)
        *status = damaged(name);
    H5Tclose(type);
    if (status->code != WHIRL_OK) stored_free(array);
}

void stored_free(stored_array *array) {
    free(array->values);
    *array = (stored_array){0};
}

// ---------------------------------------------------------------- visits

typedef struct visit {
    whirl_status *status;
    const stored_visitor *visitor;
} visit;

static herr_t meet_member(hid_t group, const char *name, const H5L_info_t *link, void *data) {
    const visit *now = data;
    const hid_t object = link->type == H5L_TYPE_HARD ? H5Oopen(group, name, H5P_DEFAULT) : H5I_INVALID_HID;
    if (object < 0) *now->status = damaged(name);
    if (object >= 0) now->visitor->member(now->status, now->visitor->context, name, object);
    if (object >= 0) H5Oclose(object);
    return now->status->code == WHIRL_OK ? 0 : 1;
}

static herr_t meet_attribute(hid_t object, const char *name, const H5A_info_t *unused, void *data) {
    const visit *now = data;
    stored_array array;
    (void)unused;
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT), type = H5Aget_type(attribute);
    const bool well = describe(H5Aget_type(attribute), H5Aget_space(attribute), &array);
    if (!well || (make_room(now->status, &array, name) && array.count > 0 &&
                  H5Aread(attribute, memory_type(&array, type), array.values) < 0))
        *now->status = damaged(name);
    if (now->status->code == WHIRL_OK) now->visitor->attribute(now->status, now->visitor->context, name, &array);
    stored_free(&array);
    if (type >= 0) H5Tclose(type);
    if (attribute >= 0) H5Aclose(attribute);
    return now->status->code == WHIRL_OK ? 0 : 1;
}

void stored_visit(whirl_status *status, hid_t object, const stored_visitor *visitor) {
    visit now = {status, visitor};
    if (status->code == WHIRL_OK && visitor->member && stored_is_group(object) &&
        H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, NULL, meet_member, &now) < 0)
        *status = damaged("a group");
    if (status->code == WHIRL_OK && visitor->attribute &&
        H5Aiterate2(object, H5_INDEX_CRT_ORDER, H5_ITER_INC, NULL, meet_attribute, &now) < 0)
        *status = damaged("an attribute");
}

// ---------------------------------------------------------------- data that readers of a result do not need

/// Bytes of a dataset that are read at a time, unless a row is longer.
enum { SOME_BYTES = 1 << 22 };

/// Reads all rows of a dataset, some at a time, so that HDF5 checks their checksums.
static void check_rows(whirl_status *status, hid_t dataset) {
    char name[NAME_BYTES];
    stored_array array;
    stored_outline(status, dataset, &array);
    if (status->code != WHIRL_OK || array.rank == 0) return;
    // Skip fields, which have an attribute "extent": they have been read.
    const hsize_t all = array.sizes[0], row = all > 0 ? array.count / all * array.width : 0;
    if (row == 0 || H5Aexists(dataset, "extent") > 0) return;
    // Read as many rows at a time as fit into SOME_BYTES.
    name_of(dataset, name);
    const hsize_t fit = SOME_BYTES / row, some = fit < 1 ? 1 : fit < all ? fit : all;
    const hid_t type = H5Dget_type(dataset), space = H5Dget_space(dataset);
    hsize_t first[SHAPE_MAX_RANK] = {0}, count[SHAPE_MAX_RANK];
    for (int i = 0; i < array.rank; i++) count[i] = array.sizes[i];
    char *rows = malloc(some * row);
    if (!rows) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the values of %.200s", name);
    for (; first[0] < all && status->code == WHIRL_OK; first[0] += some) {
        count[0] = all - first[0] < some ? all - first[0] : some;
        const hid_t memory = H5Screate_simple(array.rank, count, NULL);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, first, NULL, count, NULL);
        if (H5Dread(dataset, memory_type(&array, type), memory, space, H5P_DEFAULT, rows) < 0) *status = damaged(name);
        H5Sclose(memory);
    }
    free(rows);
    H5Sclose(space);
    H5Tclose(type);
}

static void check_member(whirl_status *status, void *context, const char *name, hid_t object) {
    const stored_visitor *again = context;
    (void)name;
    if (stored_is_group(object))
        stored_visit(status, object, again);
    else
        check_rows(status, object);
}

static void check_attribute(whirl_status *status, void *context, const char *name, const stored_array *array) {
    (void)status, (void)context, (void)name, (void)array;
}

void stored_check_unread(whirl_status *status, hid_t file) {
    stored_visitor visitor = {check_member, check_attribute, &visitor};
    const hid_t root = status->code == WHIRL_OK ? H5Gopen2(file, "/", H5P_DEFAULT) : H5I_INVALID_HID;
    if (root < 0) return;
    stored_visit(status, root, &visitor);
    H5Gclose(root);
}

// ---------------------------------------------------------------- the file

static whirl_status walk(const byte_source *source, const char *path, stored_writer write, void *context) {
    const int before = exhausted_watch();
    const h5_errors errors = h5_quiet();
    h5_bytes bytes;
    hid_t file;
    whirl_status status = h5_open(&bytes, source, &file);
    const hid_t root = status.code == WHIRL_OK ? H5Gopen2(file, "/", H5P_DEFAULT) : H5I_INVALID_HID;
    if (status.code == WHIRL_OK) write(&status, context, root);
    if (root >= 0) H5Gclose(root);
    if (exhausted(before) && status.code != WHIRL_IO_ERROR)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to export %.250s", path);
    h5_close(&bytes, file);
    if (status.code == WHIRL_OK) h5_loud(errors); // else quiet, see read_result
    if (bytes.reason) return whirl_fail(WHIRL_IO_ERROR, "cannot read %.250s: %s", path, strerror(bytes.reason));
    if (status.code != WHIRL_BAD_INPUT) return status;
    return whirl_fail(WHIRL_BAD_INPUT, "%.120s: %.250s", path, status.message);
}

whirl_status stored_open(const char *path, stored_writer write, void *context) {
    byte_file file;
    whirl_status status = bytes_open(&file, path);
    if (status.code != WHIRL_OK) return status;
    status = walk(&file.source, path, write, context);
    bytes_close(&file);
    return status;
}
