// Reading from HDF5 without trusting the file: see items.h.
#include "h5file.h"
#include "items.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// Sets the status to "PATH WRONG" for the member `name` of `object` ("": the object itself).
static void fail_get(whirl_status *status, hid_t object, const char *name, const char *wrong) {
    char folder[160] = "";
    H5Iget_name(object, folder, sizeof folder);
    const char *slash = name[0] == '\0' || strcmp(folder, "/") == 0 ? "" : "/";
    *status = whirl_fail(WHIRL_BAD_INPUT, "%s%s%.80s %s", folder, slash, name, wrong);
}

static void fail_library(whirl_status *status, hid_t object, const char *name) {
    char reason[160], wrong[200];
    h5_reason(reason, sizeof reason);
    snprintf(wrong, sizeof wrong, "cannot be read: %s", reason);
    fail_get(status, object, name, wrong);
}

// ---------------------------------------------------------------- attributes

static hid_t open_attribute(whirl_status *status, hid_t object, const char *name) {
    if (status->code != WHIRL_OK) return H5I_INVALID_HID;
    const htri_t there = H5Aexists(object, name);
    if (there == 0) {
        fail_get(status, object, name, "is missing");
        return H5I_INVALID_HID;
    }
    const hid_t attribute = there > 0 ? H5Aopen(object, name, H5P_DEFAULT) : H5I_INVALID_HID;
    if (attribute < 0) fail_library(status, object, name);
    return attribute;
}

/// Finds the number of elements of an attribute that is a scalar (rank 0) or a list (rank 1). Returns false for others.
static bool attribute_extent(hid_t attribute, int rank, hsize_t *count) {
    const hid_t space = H5Aget_space(attribute);
    bool well = space >= 0 && H5Sget_simple_extent_type(space) == (rank == 0 ? H5S_SCALAR : H5S_SIMPLE) &&
                H5Sget_simple_extent_ndims(space) == rank;
    *count = 1;
    if (well && rank == 1) well = H5Sget_simple_extent_dims(space, count, NULL) == 1;
    if (space >= 0) H5Sclose(space);
    return well;
}

/// Returns true for the type of a text of fixed length, at most `size` bytes, as put.c writes it.
static bool is_text(hid_t type, size_t size) {
    return type >= 0 && H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
           H5Tget_strpad(type) == H5T_STR_NULLTERM && H5Tget_size(type) > 0 && H5Tget_size(type) <= size;
}

/// Returns the memory type of stored texts. HDF5 converts no characters, so it has the character set of the stored
/// type.
static hid_t memory_text(hid_t stored, size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    if (type < 0) return type;
    if (H5Tset_size(type, size) >= 0 && H5Tset_cset(type, H5Tget_cset(stored)) >= 0) return type;
    H5Tclose(type);
    return H5I_INVALID_HID;
}

static void read_number(whirl_status *status, hid_t object, const char *name, hid_t kind, hid_t memory, void *value) {
    const hid_t attribute = open_attribute(status, object, name);
    if (attribute < 0) return;
    hsize_t count;
    const hid_t type = H5Aget_type(attribute);
    if (type < 0 || H5Tequal(type, kind) <= 0 || !attribute_extent(attribute, 0, &count))
        fail_get(status, object, name, "is not a number of the expected kind");
    else if (H5Aread(attribute, memory, value) < 0)
        fail_library(status, object, name);
    if (type >= 0) H5Tclose(type);
    H5Aclose(attribute);
}

void get_number_attribute(whirl_status *status, hid_t object, const char *name, double *value) {
    read_number(status, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, value);
}

int64_t get_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t low, int64_t high) {
    int64_t value = low;
    read_number(status, object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
    if (status->code == WHIRL_OK && (value < low || value > high)) {
        char wrong[120];
        snprintf(wrong, sizeof wrong, "is %lld, expected %lld to %lld", (long long)value, (long long)low,
                 (long long)high);
        fail_get(status, object, name, wrong);
    }
    return status->code == WHIRL_OK ? value : low;
}

/// Ends texts with a zero byte where they fill their field.
static void end_texts(char *first, size_t stride, size_t count) {
    for (size_t i = 0; i < count; ++i) first[i * stride + stride - 1] = '\0';
}

/// Removes control characters from texts of a result, which terminals and browsers show.
static void make_plain(char *first, size_t stride, size_t count) {
    for (size_t i = 0; i < count; ++i) whirl_make_plain(first + i * stride);
}

/// Reads the texts of an attribute of that rank, at most `most`; returns their number.
static size_t read_texts(whirl_status *status, hid_t object, const char *name, int rank, char *first, size_t stride,
                         size_t most) {
    const hid_t attribute = open_attribute(status, object, name);
    if (attribute < 0) return 0;
    hsize_t count = 0;
    const hid_t type = H5Aget_type(attribute), memory = memory_text(type, stride);
    if (!attribute_extent(attribute, rank, &count) || count > most)
        fail_get(status, object, name, "has an unexpected number of texts");
    else if (!is_text(type, stride))
        fail_get(status, object, name, "is not a text, or too long");
    else if (count > 0 && (memory < 0 || H5Aread(attribute, memory, first) < 0))
        fail_library(status, object, name);
    if (type >= 0) H5Tclose(type);
    if (memory >= 0) H5Tclose(memory);
    H5Aclose(attribute);
    if (status->code != WHIRL_OK) return 0;
    end_texts(first, stride, (size_t)count);
    make_plain(first, stride, (size_t)count);
    return (size_t)count;
}

void get_text_attribute(whirl_status *status, hid_t object, const char *name, char *text, size_t size) {
    read_texts(status, object, name, 0, text, size, 1);
}

size_t get_texts_attribute(whirl_status *status, hid_t object, const char *name, char *first, size_t stride,
                           size_t most) {
    return read_texts(status, object, name, 1, first, stride, most);
}

size_t get_attribute_count(whirl_status *status, hid_t object, size_t most) {
    if (status->code != WHIRL_OK) return 0;
    const int count = H5Aget_num_attrs(object);
    if (count >= 0 && (size_t)count <= most) return (size_t)count;
    fail_get(status, object, "", "has too many attributes");
    return 0;
}

void get_attribute_name(whirl_status *status, hid_t object, size_t index, char *name, size_t size) {
    if (status->code != WHIRL_OK) return;
    const ssize_t length =
        H5Aget_name_by_idx(object, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, index, name, size, H5P_DEFAULT);
    if (length < 0) fail_library(status, object, "");
    if (length >= (ssize_t)size) fail_get(status, object, "", "has an attribute whose name is too long");
}

// ---------------------------------------------------------------- groups and datasets

/// Returns true if every link of `path` ("rub/share") is a hard link: soft and external links could lead to other
/// files.
static bool only_hard_links(hid_t parent, const char *path) {
    char part[200];
    const size_t length = strlen(path);
    if (length == 0 || length >= sizeof part) return false;
    for (size_t end = 1; end <= length; ++end) {
        if (path[end] != '/' && path[end] != '\0') continue;
        memcpy(part, path, end);
        part[end] = '\0';
        H5L_info_t link;
        if (H5Lexists(parent, part, H5P_DEFAULT) <= 0 || H5Lget_info(parent, part, &link, H5P_DEFAULT) < 0 ||
            link.type != H5L_TYPE_HARD)
            return false;
    }
    return true;
}

static hid_t open_object(whirl_status *status, hid_t parent, const char *name, H5I_type_t kind) {
    if (status->code != WHIRL_OK) return H5I_INVALID_HID;
    if (!only_hard_links(parent, name)) {
        fail_get(status, parent, name, "is missing");
        return H5I_INVALID_HID;
    }
    const hid_t object = H5Oopen(parent, name, H5P_DEFAULT);
    if (object < 0) {
        fail_library(status, parent, name);
    } else if (H5Iget_type(object) != kind) {
        fail_get(status, parent, name, kind == H5I_GROUP ? "is not a group" : "is not a dataset");
        H5Oclose(object);
        return H5I_INVALID_HID;
    }
    return object;
}

hid_t get_group(whirl_status *status, hid_t parent, const char *name) {
    return open_object(status, parent, name, H5I_GROUP);
}

/// Returns true if a dataset is stored as put.c does: in chunks no larger than itself, with checksums as the only
/// filter.
static bool stored_plainly(hid_t dataset, const hsize_t *dimensions, int rank) {
    hsize_t chunk[SHAPE_MAX_RANK];
    unsigned flags, configuration;
    size_t values = 0;
    const hid_t creation = H5Dget_create_plist(dataset);
    bool well = creation >= 0 && H5Pget_layout(creation) == H5D_CHUNKED && H5Pget_nfilters(creation) == 1 &&
                H5Pget_filter2(creation, 0, &flags, &values, NULL, 0, NULL, &configuration) == H5Z_FILTER_FLETCHER32 &&
                H5Pget_chunk(creation, rank, chunk) == rank;
    for (int i = 0; well && i < rank; ++i) well = chunk[i] <= (dimensions[i] > 0 ? dimensions[i] : 1);
    if (creation >= 0) H5Pclose(creation);
    return well;
}

/// Finds the dimensions of a dataset of that rank. Returns false unless all its bytes are in the file.
static bool dataset_extent(hid_t dataset, hsize_t *dimensions, int rank) {
    const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
    bool well = space >= 0 && type >= 0 && H5Sget_simple_extent_type(space) == H5S_SIMPLE &&
                H5Sget_simple_extent_ndims(space) == rank &&
                H5Sget_simple_extent_dims(space, dimensions, NULL) == rank && stored_plainly(dataset, dimensions, rank);
    const hsize_t stored = well ? H5Dget_storage_size(dataset) : 0;
    hsize_t bytes = well ? H5Tget_size(type) : 0;
    // The check divides, since a product may overflow; with one dimension 0 the others do not matter.
    for (int i = 0; well && i < rank; ++i)
        if (dimensions[i] == 0) bytes = 0;
    for (int i = 0; well && bytes > 0 && i < rank; ++i) {
        well = bytes <= stored / dimensions[i];
        bytes *= dimensions[i];
    }
    if (space >= 0) H5Sclose(space);
    if (type >= 0) H5Tclose(type);
    return well;
}

hid_t get_dataset(whirl_status *status, hid_t parent, const char *name) {
    return open_object(status, parent, name, H5I_DATASET);
}

static int rank_of(hid_t dataset) {
    const hid_t space = H5Dget_space(dataset);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (space >= 0) H5Sclose(space);
    return rank;
}

shape get_shape(whirl_status *status, hid_t parent, const char *name, size_t most) {
    const hid_t dataset = get_dataset(status, parent, name);
    if (dataset < 0) return list_of(0);
    hsize_t sizes[SHAPE_MAX_RANK] = {0};
    const int found = rank_of(dataset);
    shape of = {.rank = found >= 1 && found <= SHAPE_AXES ? found : 1};
    bool well = dataset_extent(dataset, sizes, of.rank);
    for (int i = 0; well && i < of.rank; ++i) {
        of.sizes[i] = (size_t)sizes[i];
        most = sizes[i] > 0 ? most / of.sizes[i] : most;
        well = most > 0 || sizes[i] == 0;
    }
    if (!well) fail_get(status, parent, name, "is not a list of a sensible length");
    H5Dclose(dataset);
    return well ? of : list_of(0);
}

size_t get_length(whirl_status *status, hid_t parent, const char *name, size_t most) {
    const shape of = get_shape(status, parent, name, most);
    if (of.rank == 1) return of.sizes[0];
    fail_get(status, parent, name, "is not a list of a sensible length");
    return 0;
}

/// Checks that a dataset has these dimensions.
static void check_dimensions(whirl_status *status, hid_t dataset, const size_t *dimensions, int rank) {
    hsize_t found[SHAPE_MAX_RANK] = {0};
    bool well = dataset_extent(dataset, found, rank);
    for (int i = 0; well && i < rank; ++i) well = found[i] == dimensions[i];
    if (!well) fail_get(status, dataset, "", "has not the expected size");
}

/// Reads all values of a dataset of this shape.
static void read_list(whirl_status *status, hid_t dataset, hid_t memory, shape of, void *values) {
    check_dimensions(status, dataset, of.sizes, of.rank);
    if (status->code == WHIRL_OK && shape_count(of) > 0 &&
        H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail_library(status, dataset, "");
}

/// Checks that the type of a dataset is exactly this one.
static void check_kind(whirl_status *status, hid_t dataset, hid_t kind) {
    if (status->code != WHIRL_OK) return;
    const hid_t type = H5Dget_type(dataset);
    if (type < 0 || H5Tequal(type, kind) <= 0) fail_get(status, dataset, "", "is not of the expected kind");
    if (type >= 0) H5Tclose(type);
}

static void read_kind(whirl_status *status, hid_t parent, const char *name, hid_t kind, hid_t memory, shape of,
                      void *values) {
    const hid_t dataset = get_dataset(status, parent, name);
    check_kind(status, dataset, kind);
    if (status->code == WHIRL_OK) read_list(status, dataset, memory, of, values);
    close_dataset(dataset);
}

void get_numbers(whirl_status *status, hid_t parent, const char *name, double *values, shape of) {
    read_kind(status, parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, of, values);
}

void get_wholes(whirl_status *status, hid_t parent, const char *name, int64_t *values, shape of) {
    read_kind(status, parent, name, H5T_STD_I64LE, H5T_NATIVE_INT64, of, values);
}

// ---------------------------------------------------------------- columns

/// Reads the dimensions of a dataset's chunks, none of which is larger than that of the dataset.
static void read_chunk(hid_t dataset, int rank, hsize_t *chunk) {
    const hid_t creation = H5Dget_create_plist(dataset);
    if (creation >= 0) H5Pget_chunk(creation, rank, chunk);
    if (creation >= 0) H5Pclose(creation);
}

/// Opens the dataset of a column, whose values must be of this kind.
static void open_column(whirl_status *status, column *from, hid_t parent, const char *name, hid_t kind, hid_t memory) {
    hsize_t chunk[SHAPE_MAX_RANK] = {1, 1};
    size_t dimensions[SHAPE_MAX_RANK];
    for (int i = 0; i < from->rank; ++i) dimensions[i] = (size_t)from->dimensions[i];
    from->dataset = get_dataset(status, parent, name);
    check_kind(status, from->dataset, kind);
    if (status->code == WHIRL_OK) check_dimensions(status, from->dataset, dimensions, from->rank);
    if (status->code != WHIRL_OK) return;
    from->type = H5Tcopy(memory);
    read_chunk(from->dataset, from->rank, chunk);
    if (!column_buffer(from, chunk)) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory to read %s", name);
}

void column_open(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                 const size_t *dimensions, int rank) {
    column_lay(from, points, dimensions, rank, sizeof(double));
    open_column(status, from, parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE);
}

void column_open_singles(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                         const size_t *dimensions, int rank) {
    column_lay(from, points, dimensions, rank, sizeof(float));
    open_column(status, from, parent, name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT);
}

void column_open_wholes(whirl_status *status, column *from, hid_t parent, const char *name, shape points) {
    column_lay(from, points, points.sizes, points.rank, sizeof(int64_t));
    open_column(status, from, parent, name, H5T_STD_I64LE, H5T_NATIVE_INT64);
}

/// Reads the points from `done` on into the buffer.
static void fill_column(whirl_status *status, column *from) {
    hsize_t first[SHAPE_MAX_RANK], count[SHAPE_MAX_RANK];
    column_box(from, column_next_count(from), first, count);
    const hid_t file = H5Dget_space(from->dataset), memory = H5Screate_simple(from->rank, count, NULL);
    if (H5Sselect_hyperslab(file, H5S_SELECT_SET, first, NULL, count, NULL) < 0 ||
        H5Dread(from->dataset, from->type, memory, file, H5P_DEFAULT, from->buffer) < 0)
        fail_library(status, from->dataset, "");
    H5Sclose(memory);
    H5Sclose(file);
}

void column_get(whirl_status *status, column *from, void *numbers) {
    if (status->code != WHIRL_OK || from->size == 0) return;
    if (from->gathered == 0) fill_column(status, from);
    if (status->code != WHIRL_OK) return;
    memcpy(numbers, from->buffer + from->gathered * from->size, from->size);
    if (++from->gathered < column_next_count(from)) return;
    from->done += from->gathered;
    from->gathered = 0;
}

void column_close(column *from) {
    close_dataset(from->dataset);
    if (from->type >= 0) H5Tclose(from->type);
    free(from->buffer);
}

// ---------------------------------------------------------------- texts

/// Reads texts that follow each other without gaps.
static void read_packed_texts(whirl_status *status, hid_t parent, const char *name, char *packed, size_t size,
                              size_t count) {
    const hid_t dataset = get_dataset(status, parent, name);
    if (dataset < 0) return;
    const hid_t type = H5Dget_type(dataset), memory = memory_text(type, size);
    if (!is_text(type, size) || memory < 0)
        fail_get(status, parent, name, "is not a list of texts, or too long");
    else
        read_list(status, dataset, memory, list_of(count), packed);
    if (status->code == WHIRL_OK) end_texts(packed, size, count);
    if (memory >= 0) H5Tclose(memory);
    if (type >= 0) H5Tclose(type);
    H5Dclose(dataset);
}

void get_texts(whirl_status *status, hid_t parent, const char *name, char *first, size_t size, size_t stride,
               size_t count) {
    if (status->code != WHIRL_OK) return;
    char *packed = calloc(count ? count : 1, size);
    if (!packed) {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu texts", count);
        return;
    }
    read_packed_texts(status, parent, name, packed, size, count);
    if (status->code == WHIRL_OK) make_plain(packed, size, count);
    for (size_t i = 0; status->code == WHIRL_OK && i < count; ++i) memcpy(first + i * stride, packed + i * size, size);
    free(packed);
}

char *get_long_text(whirl_status *status, hid_t parent, const char *name, size_t most) {
    const hid_t dataset = get_dataset(status, parent, name);
    if (dataset < 0) return NULL;
    const hid_t type = H5Dget_type(dataset);
    const size_t size = is_text(type, most + 1) ? H5Tget_size(type) : 0;
    if (type >= 0) H5Tclose(type);
    H5Dclose(dataset);
    if (size == 0) {
        fail_get(status, parent, name, "is not a text, or too long");
        return NULL;
    }
    char *text = calloc(1, size);
    if (!text)
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a text of %zu bytes", size);
    else
        read_packed_texts(status, parent, name, text, size, 1);
    return text;
}
