// Files that HDF5 itself makes, of structures that whirl does not write: they are refused before HDF5 reads them.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "h5file.h"
#include "synthetic.h"
#include "whole.h"

#include <hdf5.h>
#include <unistd.h>

/// A result's file and its bytes.
typedef struct fixture {
    char path[64];
    unsigned char *bytes;
    size_t size;
} fixture;

static void load(fixture *f) {
    free(f->bytes);
    f->bytes = NULL;
    assert_int_equal(whole_file(f->path, &f->bytes, &f->size).code, WHIRL_OK);
}

static int setup(void **state) {
    fixture *f = synthetic_take(1, sizeof *f);
    strcpy(f->path, "/tmp/whirl-plain-XXXXXX");
    const int file = mkstemp(f->path);
    if (file < 0) return -1;
    close(file);
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    unlink(f->path);
    free(f->bytes);
    free(f);
    return 0;
}

static void write_result(fixture *f) {
    whirl_result *result = synthetic_result();
    assert_int_equal(whirl_result_write(result, f->path).code, WHIRL_OK);
    whirl_result_free(result);
}

static hid_t open_for_change(const fixture *f) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    assert_true(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0);
    const hid_t file = H5Fopen(f->path, H5F_ACC_RDWR, access);
    assert_true(file >= 0);
    H5Pclose(access);
    return file;
}

// ---------------------------------------------------------------- what is put into a sound file

static void put_value(hid_t object, const char *name, hid_t type, const void *value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(attribute >= 0 && H5Awrite(attribute, type, value) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
}

/// Writes more than eight attributes, for which HDF5 itself chooses a fractal heap and a B-tree.
static void put_heap(hid_t file) {
    const hid_t group = H5Gcreate2(file, "heap", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    for (int64_t i = 0; i < 12; ++i) {
        char name[8];
        snprintf(name, sizeof name, "a%d", (int)i);
        put_value(group, name, H5T_STD_I64LE, &i);
    }
    H5Gclose(group);
}

static void put_variable_text(hid_t file) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    const char *text = "of any length";
    assert_true(H5Tset_size(type, H5T_VARIABLE) >= 0);
    put_value(file, "text", type, &text);
    H5Tclose(type);
}

static void put_short_integer(hid_t file) {
    const int32_t value = 1;
    put_value(file, "short", H5T_STD_I32LE, &value);
}

static void put_big_endian(hid_t file) {
    const double value = 1.0;
    put_value(file, "big", H5T_IEEE_F64BE, &value);
}

static void put_soft_link(hid_t file) {
    assert_true(H5Lcreate_soft("/detail", file, "soft", H5P_DEFAULT, H5P_DEFAULT) >= 0);
}

static void put_external_link(hid_t file) {
    assert_true(H5Lcreate_external("other.h5", "/", file, "external", H5P_DEFAULT, H5P_DEFAULT) >= 0);
}

/// Writes a group that is a member of itself.
static void put_ring(hid_t file) {
    assert_true(H5Lcreate_hard(file, "/detail", file, "/detail/again", H5P_DEFAULT, H5P_DEFAULT) >= 0);
}

static void put_named_type(hid_t file) {
    const hid_t type = H5Tcopy(H5T_IEEE_F64LE);
    assert_true(H5Tcommit2(file, "type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) >= 0);
    H5Tclose(type);
}

static void put_dataset(hid_t file, H5D_layout_t layout, bool deflate) {
    const hsize_t length = 4;
    const double values[4] = {1.0, 2.0, 3.0, 4.0};
    const hid_t space = H5Screate_simple(1, &length, NULL), creation = H5Pcreate(H5P_DATASET_CREATE);
    assert_true(H5Pset_layout(creation, layout) >= 0);
    if (layout == H5D_CHUNKED) assert_true(H5Pset_chunk(creation, 1, &length) >= 0);
    if (deflate) assert_true(H5Pset_deflate(creation, 6) >= 0);
    const hid_t dataset = H5Dcreate2(file, "data", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    assert_true(dataset >= 0 && H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(dataset);
    H5Pclose(creation);
    H5Sclose(space);
}

static void put_contiguous(hid_t file) {
    put_dataset(file, H5D_CONTIGUOUS, false);
}

static void put_compact(hid_t file) {
    put_dataset(file, H5D_COMPACT, false);
}

static void put_compressed(hid_t file) {
    put_dataset(file, H5D_CHUNKED, true);
}

/// Writes a growing dataset, whose chunks HDF5 finds by an extensible array.
static void put_growing(hid_t file) {
    const hsize_t length = 4, most = H5S_UNLIMITED;
    const hid_t space = H5Screate_simple(1, &length, &most), creation = H5Pcreate(H5P_DATASET_CREATE);
    assert_true(H5Pset_chunk(creation, 1, &length) >= 0 && H5Pset_fletcher32(creation) >= 0);
    const hid_t dataset = H5Dcreate2(file, "data", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    assert_true(dataset >= 0);
    H5Dclose(dataset);
    H5Pclose(creation);
    H5Sclose(space);
}

static whirl_status check_bytes(unsigned char *bytes, size_t size) {
    const byte_source source = bytes_of_memory(bytes, size);
    return plain_check(&source);
}

static void refuses_what_whirl_does_not_write(void **state) {
    static void (*const puts[])(hid_t) = {put_heap,       put_variable_text, put_short_integer, put_big_endian,
                                          put_soft_link,  put_ring,          put_external_link, put_named_type,
                                          put_contiguous, put_compact,       put_compressed,    put_growing};
    fixture *f = *state;
    for (size_t i = 0; i < sizeof puts / sizeof *puts; ++i) {
        write_result(f);
        load(f);
        assert_int_equal(check_bytes(f->bytes, f->size).code, WHIRL_OK);
        const hid_t file = open_for_change(f);
        puts[i](file);
        assert_true(H5Fclose(file) >= 0);
        load(f);
        if (check_bytes(f->bytes, f->size).code != WHIRL_BAD_INPUT) fail_msg("structure %zu is not refused", i + 1);
    }
}

/// If any byte of a header is changed, the reader stays within the file (sanitizers check it) and ends. Most changes
/// are found at once, without any checksum.
static void reader_stays_within_the_file(void **state) {
    fixture *f = *state;
    size_t refused = 0, tried = 0;
    write_result(f);
    load(f);
    for (size_t i = 12; i < f->size; ++i) {
        const unsigned char before = f->bytes[i];
        static const unsigned char changes[] = {0x01, 0x80, 0xff};
        for (size_t k = 0; k < sizeof changes; ++k, ++tried) {
            f->bytes[i] = (unsigned char)(before ^ changes[k]);
            refused += check_bytes(f->bytes, f->size).code == WHIRL_BAD_INPUT;
        }
        f->bytes[i] = before;
    }
    assert_true(refused > tried / 10);
    for (size_t size = 48; size < f->size; ++size) {
        unsigned char *cut = synthetic_take(size, 1);
        memcpy(cut, f->bytes, size);
        (void)check_bytes(cut, size);
        free(cut);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(refuses_what_whirl_does_not_write, setup, teardown),
        cmocka_unit_test_setup_teardown(reader_stays_within_the_file, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
