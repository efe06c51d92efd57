// Arrays in HDF5 files, read without the library: the same numbers as the library reads, of every storage that it has;
// and damaged files, which are refused or read, and never crash.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "foreign.h"
#include "spoiled.h"
#include "whirl/internal/arrays.h"
#include "whole.h"

#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/whirl-arrays-XXXXXX";

static int setup(void **state) {
    (void)state;
    const int file = mkstemp(path);
    if (file >= 0) close(file);
    return file < 0;
}

static int teardown(void **state) {
    (void)state;
    return unlink(path);
}

/// Begins a file in the oldest format, or in the newest one.
static hid_t begin_file(bool newest, hsize_t user_block) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS), creation = H5Pcreate(H5P_FILE_CREATE);
    const H5F_libver_t version = newest ? H5F_LIBVER_LATEST : H5F_LIBVER_EARLIEST;
    assert_true(H5Pset_libver_bounds(access, version, H5F_LIBVER_LATEST) >= 0);
    assert_true(H5Pset_userblock(creation, user_block) >= 0);
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access);
    assert_true(file >= 0);
    H5Pclose(access);
    H5Pclose(creation);
    return file;
}

/// Storage of a dataset.
typedef struct storage {
    int rank;
    hsize_t sizes[3], most[3], chunk[3]; ///< chunk[0] 0: contiguous, or compact
    bool compact;
    int filters; ///< 1: shuffle and deflate, 2: checksums, 3: all
} storage;

/// Writes whole numbers from -120 to 120 as a type of the file, in a order that is no pattern.
static void write_dataset(hid_t file, const char *name, const storage *how, hid_t type) {
    const hid_t space = H5Screate_simple(how->rank, how->sizes, how->most[0] > 0 ? how->most : NULL);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    if (how->chunk[0] > 0) assert_true(H5Pset_chunk(creation, how->rank, how->chunk) >= 0);
    if (how->compact) assert_true(H5Pset_layout(creation, H5D_COMPACT) >= 0);
    if (how->filters & 1) assert_true(H5Pset_shuffle(creation) >= 0 && H5Pset_deflate(creation, 6) >= 0);
    if (how->filters & 2) assert_true(H5Pset_fletcher32(creation) >= 0);
    const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    assert_true(dataset >= 0);
    size_t count = 1;
    for (int i = 0; i < how->rank; i++) count *= (size_t)how->sizes[i];
    double *values = malloc(count * sizeof *values);
    for (size_t i = 0; i < count; i++) values[i] = (double)(i * 7919 % 241) - 120.0;
    assert_true(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    free(values);
    H5Dclose(dataset);
    H5Pclose(creation);
    H5Sclose(space);
}

/// Expects the numbers that the library reads, in all and in an inner part.
static void expect_same(const char *name, const storage *how) {
    arrays_file *file;
    arrays_item item;
    size_t count[3], first[3], part[3], all = 1, some = 1;
    for (int i = 0; i < how->rank; i++) {
        count[i] = (size_t)how->sizes[i];
        first[i] = count[i] / 3;
        part[i] = count[i] - count[i] / 2;
        all *= count[i];
        some *= part[i];
    }
    double *theirs = malloc(all * sizeof *theirs), *ours = malloc(all * sizeof *ours);
    const hid_t same = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), dataset = H5Dopen2(same, name, H5P_DEFAULT);
    assert_true(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, theirs) >= 0);
    H5Dclose(dataset);
    H5Fclose(same);
    const whirl_status opened = arrays_open(path, &file);
    assert_string_equal(opened.code == WHIRL_OK ? "" : opened.message, "");
    assert_int_equal(arrays_find(file, name, &item).code, WHIRL_OK);
    assert_int_equal(item.rank, how->rank);
    const size_t zeros[3] = {0};
    const whirl_status status = arrays_read(file, name, zeros, count, ours);
    assert_string_equal(status.code == WHIRL_OK ? "" : status.message, "");
    assert_memory_equal(theirs, ours, all * sizeof *ours);
    assert_int_equal(arrays_read(file, name, first, part, ours).code, WHIRL_OK);
    for (size_t i = 0; i < some; i++) {
        size_t left = i, at = 0, step = 1;
        for (int d = how->rank - 1; d >= 0; d--) {
            at += (first[d] + left % part[d]) * step;
            left /= part[d];
            step *= count[d];
        }
        assert_true(ours[i] == theirs[at]);
    }
    arrays_close(file);
    free(theirs);
    free(ours);
}

/// All storages, in both formats: those of numbers in a row, and all indexes of chunks.
static void numbers_are_those_of_the_library(void **state) {
    static const storage all[] = {
        {.rank = 1, .sizes = {100}},
        {.rank = 1, .sizes = {100}, .compact = true},
        {.rank = 2, .sizes = {40, 7}},
        {.rank = 3, .sizes = {5, 4, 9}},
        // One chunk, chunks of a fixed array, and enough of them for pages.
        {.rank = 1, .sizes = {100}, .chunk = {100}},
        {.rank = 1, .sizes = {100}, .chunk = {100}, .filters = 1},
        {.rank = 2, .sizes = {40, 7}, .chunk = {9, 4}},
        {.rank = 2, .sizes = {40, 7}, .chunk = {9, 4}, .filters = 3},
        {.rank = 2, .sizes = {40, 7}, .most = {50, 20}, .chunk = {9, 4}},
        {.rank = 3, .sizes = {5, 4, 9}, .chunk = {2, 3, 4}, .filters = 2},
        {.rank = 1, .sizes = {5000}, .chunk = {1}},
        {.rank = 1, .sizes = {5000}, .chunk = {2}, .filters = 1},
        // Extensible arrays: few chunks, and so many that there are secondary blocks and pages.
        {.rank = 1, .sizes = {100}, .most = {H5S_UNLIMITED}, .chunk = {7}},
        {.rank = 1, .sizes = {100}, .most = {H5S_UNLIMITED}, .chunk = {7}, .filters = 1},
        {.rank = 2, .sizes = {40, 7}, .most = {H5S_UNLIMITED, 7}, .chunk = {3, 2}, .filters = 3},
        {.rank = 2, .sizes = {7, 40}, .most = {9, H5S_UNLIMITED}, .chunk = {2, 3}},
        {.rank = 1, .sizes = {20000}, .most = {H5S_UNLIMITED}, .chunk = {1}},
        {.rank = 1, .sizes = {20000}, .most = {H5S_UNLIMITED}, .chunk = {1}, .filters = 2},
        {.rank = 1, .sizes = {140000}, .most = {H5S_UNLIMITED}, .chunk = {1}},
        // Trees: two dimensions that may grow.
        {.rank = 2, .sizes = {40, 17}, .most = {H5S_UNLIMITED, H5S_UNLIMITED}, .chunk = {3, 2}},
        {.rank = 2, .sizes = {40, 17}, .most = {H5S_UNLIMITED, H5S_UNLIMITED}, .chunk = {3, 2}, .filters = 3},
        {.rank = 2, .sizes = {60, 50}, .most = {H5S_UNLIMITED, H5S_UNLIMITED}, .chunk = {1, 1}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        for (int newest = 0; newest < 2; newest++) {
            const hid_t file = begin_file(newest, 0);
            write_dataset(file, "numbers", &all[i], H5T_IEEE_F64LE);
            H5Fclose(file);
            expect_same("numbers", &all[i]);
        }
}

/// All types of numbers, and a file that begins after 512 bytes of somebody else's.
static void types_are_converted(void **state) {
    static const storage how = {.rank = 1, .sizes = {300}, .chunk = {64}, .filters = 1};
    const hid_t half = H5Tcopy(H5T_IEEE_F32LE);
    assert_true(H5Tset_fields(half, 15, 10, 5, 0, 10) >= 0 && H5Tset_size(half, 2) >= 0 && H5Tset_ebias(half, 15) >= 0);
    const struct {
        const char *name;
        hid_t type;
    } types[] = {{"f8", H5T_IEEE_F64LE}, {"F8", H5T_IEEE_F64BE}, {"f4", H5T_IEEE_F32LE}, {"F4", H5T_IEEE_F32BE},
                 {"f2", half},           {"i1", H5T_STD_I8LE},   {"i2", H5T_STD_I16LE},  {"I2", H5T_STD_I16BE},
                 {"i4", H5T_STD_I32LE},  {"i8", H5T_STD_I64LE},  {"I8", H5T_STD_I64BE},  {"u1", H5T_STD_U8LE},
                 {"u2", H5T_STD_U16LE},  {"U4", H5T_STD_U32BE},  {"u8", H5T_STD_U64LE}};
    (void)state;
    const hid_t file = begin_file(false, 512);
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) write_dataset(file, types[i].name, &how, types[i].type);
    H5Fclose(file);
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) expect_same(types[i].name, &how);
    H5Tclose(half);
}

static void put_text(hid_t object, const char *name, const char *text, bool variable) {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, variable ? H5T_VARIABLE : strlen(text));
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Awrite(attribute, type, variable ? (const void *)&text : text) >= 0);
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(space);
}

static whirl_status count_name(void *context, const char *name, const arrays_item *item) {
    (void)name;
    *(size_t *)context += item->numbers;
    return whirl_ok();
}

/// Hundreds of names in a group, groups in groups, and more attributes than a header has room for.
static void names_and_attributes_are_found(void **state) {
    enum { MANY = 300 };
    static const storage how = {.rank = 1, .sizes = {3}};
    char name[64], text[ARRAYS_TEXT];
    (void)state;
    for (int newest = 0; newest < 2; newest++) {
        const hid_t file = begin_file(newest, 0),
                    group = H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        for (int i = 0; i < MANY; i++) {
            snprintf(name, sizeof name, "a rather long name of channel %d", i);
            write_dataset(group, name, &how, H5T_IEEE_F64LE);
        }
        const hid_t inner = H5Gcreate2(group, "inner", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        write_dataset(inner, "x", &how, H5T_IEEE_F64LE);
        const hid_t x = H5Dopen2(inner, "x", H5P_DEFAULT);
        for (int i = 0; i < 40; i++) {
            snprintf(name, sizeof name, "attribute %d", i);
            put_text(x, name, i % 2 ? "odd" : "even", i % 3 == 0);
        }
        put_text(x, "unit", "um", newest);
        H5Dclose(x);
        H5Gclose(inner);
        H5Gclose(group);
        H5Fclose(file);
        arrays_file *read;
        arrays_item item;
        size_t count = 0;
        assert_int_equal(arrays_open(path, &read).code, WHIRL_OK);
        assert_int_equal(arrays_visit(read, count_name, &count).code, WHIRL_OK);
        assert_int_equal(count, MANY + 1);
        for (int i = 0; i < MANY; i++) {
            snprintf(name, sizeof name, "run/a rather long name of channel %d", i);
            assert_int_equal(arrays_find(read, name, &item).code, WHIRL_OK);
        }
        assert_int_equal(arrays_find(read, "/run/inner/x", &item).code, WHIRL_OK);
        assert_string_equal(item.unit, "um");
        for (int i = 0; i < 40; i++) {
            snprintf(name, sizeof name, "attribute %d", i);
            assert_int_equal(arrays_text(read, "run/inner/x", name, text, sizeof text).code, WHIRL_OK);
            assert_string_equal(text, i % 2 ? "odd" : "even");
        }
        arrays_close(read);
    }
}

static void expect_failure(arrays_file *file, const char *name, size_t first, size_t count, const char *sentence) {
    const size_t from[3] = {first, 0, 0}, sizes[3] = {count, 1, 1};
    double numbers[16];
    char expected[400];
    const whirl_status status = arrays_read(file, name, from, sizes, numbers);
    snprintf(expected, sizeof expected, "%s%s", path, sentence);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, expected);
}

/// Datasets that are not there, or have no numbers, are refused with a sentence.
static void other_things_are_refused(void **state) {
    static const storage how = {.rank = 1, .sizes = {3}};
    (void)state;
    const hid_t file = begin_file(false, 0), group = H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    write_dataset(group, "displacement", &how, H5T_IEEE_F64LE);
    const hsize_t three = 3;
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate_simple(1, &three, NULL);
    const hid_t pair = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(pair, "a", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(pair, "b", 8, H5T_NATIVE_DOUBLE);
    H5Tset_size(type, 5);
    H5Dclose(H5Dcreate2(group, "names", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Dclose(H5Dcreate2(group, "pairs", pair, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Dclose(H5Dcreate2(group, "nothing", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Tclose(pair);
    H5Tclose(type);
    H5Sclose(space);
    H5Gclose(group);
    H5Fclose(file);
    arrays_file *read;
    assert_int_equal(arrays_open(path, &read).code, WHIRL_OK);
    expect_failure(read, "run/displacment", 0, 3,
                   " has no dataset 'run/displacment', did you mean 'run/displacement'?");
    expect_failure(read, "speed", 0, 3,
                   " has no dataset 'speed', expected one of run/displacement, run/names, run/nothing, run/pairs");
    expect_failure(read, "run", 0, 3, ": run is a group, expected a dataset");
    expect_failure(read, "run/names", 0, 3, ": run/names has texts, expected numbers");
    expect_failure(read, "run/pairs", 0, 3, ": run/pairs has records of several fields, expected numbers");
    expect_failure(read, "run/nothing", 0, 3, ": run/nothing was never written");
    expect_failure(read, "run/displacement", 2, 2, ": run/displacement has no such part");
    arrays_close(read);
}

// ---------------------------------------------------------------- damage

/// Files that are cut off anywhere, and files with changed bytes.
static void damage_is_no_crash(void **state) {
    static const storage several[] = {
        {.rank = 1, .sizes = {30}, .chunk = {4}, .filters = 3},
        {.rank = 1, .sizes = {30}, .most = {H5S_UNLIMITED}, .chunk = {1}},
        {.rank = 2, .sizes = {6, 5}, .most = {H5S_UNLIMITED, H5S_UNLIMITED}, .chunk = {2, 2}},
        {.rank = 2, .sizes = {6, 5}, .chunk = {2, 2}},
        {.rank = 1, .sizes = {10}, .compact = true},
    };
    enum { MUTANTS = 4000 };
    uint64_t random = 88172645463325252U;
    (void)state;
    for (int newest = 0; newest < 2; newest++) {
        unsigned char *bytes = NULL;
        size_t size;
        char name[32];
        const hid_t file = begin_file(newest, 0);
        for (int i = 0; i < 12; i++) {
            snprintf(name, sizeof name, "dataset %d", i);
            write_dataset(file, name, &several[(size_t)i % (sizeof several / sizeof *several)], H5T_IEEE_F32LE);
        }
        const hid_t last = H5Dopen2(file, name, H5P_DEFAULT);
        put_text(last, "unit", "um", true);
        H5Dclose(last);
        H5Fclose(file);
        assert_int_equal(whole_file(path, &bytes, &size).code, WHIRL_OK);
        for (size_t length = 0; length < size; length += length < 1000 ? 7 : 131) spoiled_read(bytes, length, "a.h5");
        unsigned char *changed = malloc(size);
        for (int mutant = 0; mutant < MUTANTS; mutant++) {
            memcpy(changed, bytes, size);
            spoiled_mutate(changed, size, mutant, &random);
            spoiled_read(changed, size, "a.h5");
        }
        free(changed);
        free(bytes);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_those_of_the_library),
        cmocka_unit_test(types_are_converted),
        cmocka_unit_test(names_and_attributes_are_found),
        cmocka_unit_test(other_things_are_refused),
        cmocka_unit_test(damage_is_no_crash),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
