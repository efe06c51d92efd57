// Writes attributes and datasets to an HDF5 file (items.h).
#include "h5file.h"
#include "items.h"

#include <stdlib.h>
#include <string.h>

enum {
    CHUNK_BYTES = 1 << 20, ///< approximate limit of a chunk, so that parts of large results are read quickly
    PATH_SIZE = 256
};

static void fail_put(whirl_status *status, const char *name) {
    char reason[200];
    h5_reason(reason, sizeof reason);
    *status = whirl_fail(WHIRL_IO_ERROR, "cannot store %s: %s", name, reason);
}

/// Returns the type of texts of up to `length` bytes, ended by 0. All texts are UTF-8; datasets are not marked so,
/// since Octave's `load` cannot read datasets of UTF-8.
static hid_t text_type(size_t length, H5T_cset_t letters) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    if (type < 0) return type;
    if (H5Tset_size(type, length + 1) < 0 || H5Tset_cset(type, letters) < 0) {
        H5Tclose(type);
        return H5I_INVALID_HID;
    }
    return type;
}

static const char *text_at(texts list, size_t index) {
    return list.first + index * list.stride;
}

static size_t longest(texts list) {
    size_t length = 0;
    for (size_t i = 0; i < list.count; ++i) {
        const size_t here = strlen(text_at(list, i));
        if (here > length) length = here;
    }
    return length;
}

/// Returns the texts one after the other in fields of `size` bytes, filled with 0; to be freed.
static char *pack_texts(texts list, size_t size) {
    char *packed = calloc(list.count ? list.count : 1, size);
    if (!packed) return NULL;
    for (size_t i = 0; i < list.count; ++i) strcpy(packed + i * size, text_at(list, i));
    return packed;
}

static void put_attribute(whirl_status *status, hid_t object, const char *name, hid_t file_type, hid_t memory_type,
                          hid_t space, const void *values) {
    if (status->code != WHIRL_OK) return;
    const hid_t attribute = H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0 || H5Awrite(attribute, memory_type, values) < 0) fail_put(status, name);
    if (attribute >= 0) H5Aclose(attribute);
}

static void put_scalar(whirl_status *status, hid_t object, const char *name, hid_t file_type, hid_t memory_type,
                       const void *value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    put_attribute(status, object, name, file_type, memory_type, space, value);
    H5Sclose(space);
}

void put_text_attribute(whirl_status *status, hid_t object, const char *name, const char *text) {
    if (status->code != WHIRL_OK) return;
    const hid_t type = text_type(strlen(text), H5T_CSET_UTF8);
    put_scalar(status, object, name, type, type, text);
    H5Tclose(type);
}

void put_number_attribute(whirl_status *status, hid_t object, const char *name, double value) {
    put_scalar(status, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void put_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t value) {
    put_scalar(status, object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

void put_texts_attribute(whirl_status *status, hid_t object, const char *name, texts list) {
    if (status->code != WHIRL_OK) return;
    const size_t size = longest(list) + 1;
    char *packed = pack_texts(list, size);
    if (!packed) {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory to store %s", name);
        return;
    }
    const hsize_t count = list.count;
    const hid_t type = text_type(size - 1, H5T_CSET_UTF8), space = H5Screate_simple(1, &count, NULL);
    put_attribute(status, object, name, type, type, space, packed);
    H5Sclose(space);
    H5Tclose(type);
    free(packed);
}

hid_t put_group(whirl_status *status, hid_t parent, const char *name) {
    if (status->code != WHIRL_OK) return H5I_INVALID_HID;
    const hid_t creation = H5Pcreate(H5P_GROUP_CREATE);
    hid_t group = H5I_INVALID_HID;
    if (h5_keep_plain(creation) >= 0 && H5Pset_link_phase_change(creation, H5_MAX_COMPACT, 0) >= 0 &&
        H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED) >= 0)
        group = H5Gcreate2(parent, name, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (group < 0) fail_put(status, name);
    H5Pclose(creation);
    return group;
}

void close_group(hid_t group) {
    if (group >= 0) H5Gclose(group);
}

/// Chooses the dimensions of chunks: halves those of the dataset, from the first on and down to 1, until a chunk is
/// small enough.
static void choose_chunk(hsize_t *chunk, const hsize_t *dimensions, int rank, size_t element) {
    double bytes = (double)element;
    for (int i = 0; i < rank; ++i) {
        chunk[i] = dimensions[i] > 0 ? dimensions[i] : 1;
        bytes *= (double)chunk[i];
    }
    for (int i = 0; i < rank; ++i)
        while (bytes > CHUNK_BYTES && chunk[i] > 1) {
            bytes *= (double)((chunk[i] + 1) / 2) / (double)chunk[i];
            chunk[i] = (chunk[i] + 1) / 2;
        }
}

/// Makes a dataset without values.
static hid_t make_dataset(whirl_status *status, hid_t parent, const char *name, hid_t type, const hsize_t *dimensions,
                          int rank) {
    if (status->code != WHIRL_OK) return H5I_INVALID_HID;
    hsize_t chunk[SHAPE_MAX_RANK];
    choose_chunk(chunk, dimensions, rank, H5Tget_size(type));
    const hid_t space = H5Screate_simple(rank, dimensions, NULL);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    hid_t dataset = H5I_INVALID_HID;
    if (H5Pset_chunk(creation, rank, chunk) >= 0 && H5Pset_fletcher32(creation) >= 0 && h5_keep_plain(creation) >= 0)
        dataset = H5Dcreate2(parent, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (dataset < 0) fail_put(status, name);
    H5Pclose(creation);
    H5Sclose(space);
    return dataset;
}

/// Writes a whole dataset. `unit` is NULL for texts.
static void put_list(whirl_status *status, hid_t parent, const char *name, hid_t file_type, hid_t memory_type, shape of,
                     const void *values, const char *unit) {
    hsize_t dimensions[SHAPE_AXES];
    for (int i = 0; i < of.rank; ++i) dimensions[i] = of.sizes[i];
    const hid_t dataset = make_dataset(status, parent, name, file_type, dimensions, of.rank);
    if (status->code == WHIRL_OK && shape_count(of) > 0 &&
        H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail_put(status, name);
    if (unit) put_text_attribute(status, dataset, "unit", unit);
    close_dataset(dataset);
}

void close_dataset(hid_t dataset) {
    if (dataset >= 0) H5Dclose(dataset);
}

void put_texts(whirl_status *status, hid_t parent, const char *name, texts list) {
    if (status->code != WHIRL_OK) return;
    const size_t size = longest(list) + 1;
    char *packed = pack_texts(list, size);
    if (!packed) {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory to store %s", name);
        return;
    }
    const hid_t type = text_type(size - 1, H5T_CSET_ASCII);
    put_list(status, parent, name, type, type, list_of(list.count), packed, NULL);
    H5Tclose(type);
    free(packed);
}

void put_wholes(whirl_status *status, hid_t parent, const char *name, const int64_t *values, shape of) {
    put_list(status, parent, name, H5T_STD_I64LE, H5T_NATIVE_INT64, of, values, "1");
}

void put_numbers(whirl_status *status, hid_t parent, const char *name, const double *values, shape of,
                 const char *unit) {
    put_list(status, parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, of, values, unit);
}

/// Makes the group of `name` ("rub/share"). HDF5 could do so by itself, but would store the time of day.
static void put_group_above(whirl_status *status, hid_t parent, const char *name) {
    char group[PATH_SIZE];
    const char *slash = strchr(name, '/');
    if (status->code != WHIRL_OK || !slash || (size_t)(slash - name) >= sizeof group) return;
    memcpy(group, name, (size_t)(slash - name));
    group[slash - name] = '\0';
    if (H5Lexists(parent, group, H5P_DEFAULT) <= 0) close_group(put_group(status, parent, group));
}

// ---------------------------------------------------------------- columns: datasets that are written point by point

static void begin_column(whirl_status *status, column *out, hid_t parent, const char *name, hid_t type) {
    out->dataset = make_dataset(status, parent, name, type, out->dimensions, out->rank);
    if (status->code != WHIRL_OK) return;
    hsize_t chunk[SHAPE_MAX_RANK] = {1};
    choose_chunk(chunk, out->dimensions, out->rank, H5Tget_size(type));
    if (!column_buffer(out, chunk)) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory to store %s", name);
}

static void put_make_column(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                            const size_t *dimensions, int rank, bool single) {
    column_lay(out, points, dimensions, rank, single ? sizeof(float) : sizeof(double));
    put_group_above(status, parent, name);
    if (status->code == WHIRL_OK) out->type = H5Tcopy(single ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE);
    begin_column(status, out, parent, name, single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE);
}

void column_of_numbers(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit) {
    put_make_column(status, out, parent, name, points, dimensions, rank, false);
    put_text_attribute(status, out->dataset, "unit", unit);
}

void column_of_singles(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit) {
    put_make_column(status, out, parent, name, points, dimensions, rank, true);
    put_text_attribute(status, out->dataset, "unit", unit);
}

void column_of_wholes(whirl_status *status, column *out, hid_t parent, const char *name, shape points) {
    column_lay(out, points, points.sizes, points.rank, sizeof(int64_t));
    if (status->code == WHIRL_OK) out->type = H5Tcopy(H5T_NATIVE_INT64);
    begin_column(status, out, parent, name, H5T_STD_I64LE);
    put_text_attribute(status, out->dataset, "unit", "1");
}

void column_of_texts(whirl_status *status, column *out, hid_t parent, const char *name, shape points, size_t size) {
    column_lay(out, points, points.sizes, points.rank, size);
    if (status->code == WHIRL_OK) out->type = text_type(size - 1, H5T_CSET_ASCII);
    begin_column(status, out, parent, name, out->type);
}

/// Writes the points that have gathered: a whole chunk, except at the end.
static void flush_column(whirl_status *status, column *out) {
    hsize_t first[SHAPE_MAX_RANK], count[SHAPE_MAX_RANK];
    if (status->code != WHIRL_OK || out->gathered == 0) return;
    column_box(out, out->gathered, first, count);
    out->done += out->gathered;
    out->gathered = 0;
    if (out->size == 0) return;
    const hid_t file = H5Dget_space(out->dataset), memory = H5Screate_simple(out->rank, count, NULL);
    if (H5Sselect_hyperslab(file, H5S_SELECT_SET, first, NULL, count, NULL) < 0 ||
        H5Dwrite(out->dataset, out->type, memory, file, H5P_DEFAULT, out->buffer) < 0)
        fail_put(status, "the numbers of the points");
    H5Sclose(memory);
    H5Sclose(file);
}

void column_put(whirl_status *status, column *out, const void *point) {
    if (status->code != WHIRL_OK) return;
    memcpy(out->buffer + out->gathered * out->size, point, out->size);
    if (++out->gathered == column_next_count(out)) flush_column(status, out);
}

void column_end(whirl_status *status, column *out) {
    flush_column(status, out);
    close_dataset(out->dataset);
    if (out->type >= 0) H5Tclose(out->type);
    free(out->buffer);
}
