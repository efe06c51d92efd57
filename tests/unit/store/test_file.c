// Result files: what is written is read back; what is damaged or made to harm is refused.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "expect.h"
#include "read.h"
#include "same.h"
#include "synthetic.h"
#include "whole.h"

#include <dirent.h>
#include <errno.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// HDF5 1.10 loses memory of its own when it meets a wrong checksum.
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl*): the name that the sanitizer looks for
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libhdf5";
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl*)

/// A folder of its own for every test, with a result and the path of a file in it.
typedef struct fixture {
    char folder[64], path[128];
    whirl_result *made;
    unsigned char *bytes; ///< of the file, when `written` was called
    size_t size;
} fixture;

static int setup(void **state) {
    fixture *f = synthetic_take(1, sizeof *f);
    strcpy(f->folder, "/tmp/whirl-store-XXXXXX");
    if (!mkdtemp(f->folder)) return -1;
    snprintf(f->path, sizeof f->path, "%s/made.h5", f->folder);
    f->made = synthetic_result();
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    unlink(f->path);
    rmdir(f->folder);
    whirl_result_free(f->made);
    free(f->bytes);
    free(f);
    return 0;
}

static void written(fixture *f) {
    check(whirl_result_write(f->made, f->path));
    free(f->bytes);
    f->bytes = NULL;
    check(whole_file(f->path, &f->bytes, &f->size));
}

static size_t files_in(const char *folder) {
    size_t count = 0;
    DIR *listing = opendir(folder);
    assert_non_null(listing);
    for (const struct dirent *entry; (entry = readdir(listing));)
        if (entry->d_name[0] != '.') ++count;
    closedir(listing);
    return count;
}

// ---------------------------------------------------------------- round trips

static void reads_what_was_written(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    written(f);
    check(whirl_result_read(f->path, &read));
    assert_true(same_result(f->made, read));
    assert_int_equal(files_in(f->folder), 1);
    whirl_result_free(read);
}

static void reads_an_empty_result(void **state) {
    fixture *f = *state;
    whirl_result nothing = {0}, *read = NULL;
    char none[] = "";
    nothing.case_text = none;
    check(whirl_result_write(&nothing, f->path));
    check(whirl_result_read(f->path, &read));
    assert_true(same_result(&nothing, read));
    whirl_result_free(read);
}

static void reads_a_table_without_points(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    f->made->tables[0].count = 0;
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_read(f->path, &read));
    assert_int_equal(read->tables[0].count, 0);
    assert_true(same_result(f->made, read));
    whirl_result_free(read);
}

/// Takes all points but those out of a result in memory.
static whirl_result *with_points(whirl_result *made, const size_t *slots, size_t count) {
    whirl_table *table = &made->tables[0];
    const size_t size = table->layout.size;
    table->planned = table->count;
    table->slots = synthetic_take(count, sizeof *table->slots);
    for (size_t i = 0; i < count; ++i) {
        table->slots[i] = slots[i];
        table->values[i] = table->values[slots[i]];
        table->branch[i] = table->branch[slots[i]];
        memmove(table->blocks + i * size, table->blocks + slots[i] * size, size * sizeof(double));
    }
    table->count = count;
    return made;
}

/// The file of a stopped run has the finished points and their numbers.
static void a_partial_file_has_what_is_done(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL, *again = NULL;
    size_t done, total;
    whirl_table *sweep = &f->made->tables[0];
    f->made->partial = true;
    sweep->done = synthetic_take(sweep->count, 1);
    sweep->done[0] = sweep->done[2] = 1;
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_verify(f->made, f->path));
    check(whirl_result_read(f->path, &read));
    free(sweep->done);
    sweep->done = NULL;
    assert_true(same_result(with_points(f->made, (const size_t[]){0, 2}, 2), read));
    assert_true(whirl_result_partial(read, &done, &total));
    assert_int_equal(done, 2 + read->tables[1].count);
    assert_int_equal(total, SYNTHETIC_POINTS + read->tables[1].count);
    // A result that was read is written unchanged.
    check(whirl_result_write(read, f->path));
    check(whirl_result_verify(read, f->path));
    check(whirl_result_read(f->path, &again));
    assert_true(same_result(read, again));
    whirl_result_free(again);
    whirl_result_free(read);
}

/// A file has nothing of a hundred thousand points that were not reached.
static void a_partial_file_is_as_large_as_its_points(void **state) {
    enum { MANY = 100000, FEW = 3 };
    fixture *f = *state;
    whirl_table *sweep = &f->made->tables[0];
    written(f);
    const size_t whole = f->size;
    double *values = synthetic_take(MANY, sizeof *values);
    int *branch = synthetic_take(MANY, sizeof *branch);
    double *blocks = synthetic_take(MANY * sweep->layout.size, sizeof *blocks);
    memcpy(values, sweep->values, FEW * sizeof *values);
    memcpy(branch, sweep->branch, FEW * sizeof *branch);
    memcpy(blocks, sweep->blocks, FEW * sweep->layout.size * sizeof *blocks);
    free(sweep->values), free(sweep->branch), free(sweep->blocks);
    sweep->values = values, sweep->branch = branch, sweep->blocks = blocks;
    sweep->count = MANY;
    sweep->done = synthetic_take(MANY, 1);
    memset(sweep->done, 1, FEW);
    f->made->partial = true;
    written(f);
    assert_true(f->size == whole);
    check(whirl_result_verify(f->made, f->path));
}

/// A result with many points has datasets of several chunks of 1 MiB.
static void reads_large_tables(void **state) {
    fixture *f = *state;
    whirl_table *table = &f->made->tables[0];
    whirl_result *read = NULL;
    free(table->values), free(table->branch), free(table->blocks);
    synthetic_fill(table, 9001);
    assert_true(table->count * 2 * 4 * SYNTHETIC_RECORD * sizeof(double) > 2 << 20);
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_read(f->path, &read));
    assert_true(same_result(f->made, read));
    whirl_result_free(read);
}

/// Maps of points in rows and columns, and planes of these, whose chunks are several planes, one plane, several rows,
/// one row, or pieces of a row, the last of which is shorter.
static void reads_maps(void **state) {
    static const struct {
        size_t row, rows, planes, numbers;
    } maps[] = {{5, 3, 0, 0},       {5, 7, 0, 1 << 15}, {7, 3, 0, 1 << 16}, {1, 4, 0, 3},       {4, 1, 0, 1 << 16},
                {5, 3, 4, 0},       {5, 3, 7, 1 << 11}, {5, 3, 7, 1 << 13}, {5, 7, 3, 1 << 15}, {7, 3, 2, 1 << 16},
                {1, 1, 5, 1 << 15}, {4, 1, 3, 1 << 15}, {1, 4, 1, 1 << 15}};
    fixture *f = *state;
    for (size_t i = 0; i < sizeof maps / sizeof *maps; ++i) {
        whirl_result *made = synthetic_result(), *read = NULL;
        synthetic_planes(&made->tables[0], maps[i].row, maps[i].rows, maps[i].planes, maps[i].numbers);
        check(whirl_result_write(made, f->path));
        check(whirl_result_verify(made, f->path));
        check(whirl_result_read(f->path, &read));
        assert_true(same_result(made, read));
        whirl_result_free(read);
        whirl_result_free(made);
    }
}

static void reads_what_is_left_of_a_map(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    synthetic_map(&f->made->tables[0], 5, 3, 0);
    with_points(f->made, (const size_t[]){0, 2, 7, 9, 13}, 5);
    f->made->partial = true;
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_read(f->path, &read));
    assert_true(same_result(f->made, read));
    whirl_result_free(read);
}

/// Files written more than a second apart are equal (HDF5 counts times in seconds).
static void same_results_are_same_files(void **state) {
    fixture *f = *state;
    written(f);
    unsigned char *first = f->bytes;
    const size_t size = f->size;
    f->bytes = NULL;
    const struct timespec pause = {.tv_sec = 1, .tv_nsec = 100000000};
    nanosleep(&pause, NULL);
    written(f);
    assert_int_equal(size, f->size);
    assert_memory_equal(first, f->bytes, size);
    free(first);
}

/// The number and the place of the points of branches and tori are not known before a run: they do not belong to the
/// identity of the study, but a file has them.
static void branches_are_known_by_their_study(void **state) {
    static const char *const analyses[] = {"trace", "torus"};
    for (size_t i = 0; i < 2; ++i) {
        fixture *f = *state;
        whirl_result found = *f->made, outline = *f->made;
        whirl_table table = {0}, room;
        char difference[WHIRL_MESSAGE_SIZE];
        synthetic_traced(&table, f->made, analyses[i]);
        room = table;
        room.count = 4000;
        room.values = NULL;
        found.table_count = outline.table_count = 1;
        found.tables = &table;
        outline.tables = &room;
        assert_true(whirl_result_same_study(&found, &outline, difference, sizeof difference));
        check(whirl_result_write(&found, f->path));
        check(whirl_result_verify(&found, f->path));
        table.values[1] += 1e-9;
        assert_int_equal(whirl_result_verify(&found, f->path).code, WHIRL_IO_ERROR);
        assert_non_null(strstr(whirl_result_verify(&found, f->path).message, "point 2 of the"));
        table.values[1] = 0.2;
        table.count = 1;
        assert_int_equal(whirl_result_verify(&found, f->path).code, WHIRL_IO_ERROR);
        snprintf(room.parameter, sizeof room.parameter, "rho");
        assert_false(whirl_result_same_study(&found, &outline, difference, sizeof difference));
        free(table.values), free(table.branch), free(table.blocks);
    }
}

static void replaces_a_file(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    written(f);
    snprintf(f->made->title, sizeof f->made->title, "another");
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_read(f->path, &read));
    assert_string_equal(read->title, "another");
    whirl_result_free(read);
}

// ---------------------------------------------------------------- places that cannot be written

static void says_where_it_cannot_write(void **state) {
    fixture *f = *state;
    char path[160];
    snprintf(path, sizeof path, "%s/none/made.h5", f->folder);
    assert_says(whirl_result_write(f->made, path), WHIRL_IO_ERROR, "none: No such file or directory");
    assert_says(whirl_result_write(f->made, f->folder), WHIRL_IO_ERROR, "it is a folder");
    assert_says(whirl_result_write(f->made, ""), WHIRL_IO_ERROR, "without a name");
    assert_says(whirl_result_write(f->made, "/dev/null"), WHIRL_IO_ERROR, "no ordinary file");
    written(f);
    snprintf(path, sizeof path, "%s/made.h5", f->path);
    assert_says(whirl_result_write(f->made, path), WHIRL_IO_ERROR, "cannot write");
    assert_int_equal(files_in(f->folder), 1);
}

/// A limit on the size of files acts as a full disk does. An existing file stays as it was.
static void a_full_disk_leaves_the_old_file(void **state) {
    fixture *f = *state;
    struct rlimit before, small;
    whirl_result *read = NULL;
    written(f);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    signal(SIGXFSZ, SIG_IGN);
    for (rlim_t limit = 0; limit < f->size; limit += f->size / 5) {
        small.rlim_cur = limit;
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
        const whirl_status status = whirl_result_write(f->made, f->path);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
        assert_says(status, WHIRL_IO_ERROR, strerror(EFBIG));
        assert_int_equal(files_in(f->folder), 1);
    }
    check(whirl_result_read(f->path, &read));
    assert_true(same_result(f->made, read));
    whirl_result_free(read);
}

static void refuses_names_that_break_the_file(void **state) {
    fixture *f = *state;
    whirl_table *table = &f->made->tables[0];
    strcpy(table->name, "case");
    assert_says(whirl_result_write(f->made, f->path), WHIRL_BAD_INPUT, "'case' cannot name a table");
    strcpy(table->name, "detail");
    assert_says(whirl_result_write(f->made, f->path), WHIRL_BAD_INPUT, "'detail' cannot name a table");
    strcpy(table->name, "sweep");
    strcpy(table->layout.fields[0].name, "no slash");
    assert_says(whirl_result_write(f->made, f->path), WHIRL_BAD_INPUT, "'no slash' cannot name a field");
    assert_int_equal(files_in(f->folder), 0);
}

// ---------------------------------------------------------------- files that are no results

static void says_what_it_cannot_read(void **state) {
    fixture *f = *state;
    whirl_result *read = f->made;
    assert_says(whirl_result_read(f->path, &read), WHIRL_IO_ERROR, "made.h5: No such file or directory");
    assert_null(read);
    assert_says(whirl_result_read(f->folder, &read), WHIRL_IO_ERROR, "it is a folder");
    FILE *stream = fopen(f->path, "w");
    fputs("whirl: 1\n", stream);
    fclose(stream);
    assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "is not an HDF5 file");
}

static void refuses_other_hdf5_files(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    assert_true(H5Fclose(H5Fcreate(f->path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) >= 0);
    assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "not one that whirl wrote");
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    assert_true(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0);
    assert_true(H5Fclose(H5Fcreate(f->path, H5F_ACC_TRUNC, H5P_DEFAULT, access)) >= 0);
    assert_true(H5Pclose(access) >= 0);
    assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "/format is missing");
}

static whirl_status read_bytes(unsigned char *bytes, size_t size, whirl_result **read) {
    const byte_source source = bytes_of_memory(bytes, size);
    return read_result(&source, "bytes", NULL, read);
}

static void refuses_every_truncation(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    written(f);
    for (size_t size = 0; size < f->size; ++size) {
        // A block of its own, so that reading past the end is seen.
        unsigned char *cut = synthetic_take(size, 1);
        memcpy(cut, f->bytes, size);
        assert_int_equal(read_bytes(cut, size, &read).code, WHIRL_BAD_INPUT);
        free(cut);
    }
}

/// Flips bits of all bytes that are used: the checksums find the error, or the result is the same.
static void flip_bits(fixture *f, size_t step) {
    size_t refused = 0, tried = 0;
    written(f);
    for (size_t i = 0; i < f->size; i += step, ++tried) {
        const unsigned char before = f->bytes[i];
        whirl_result *read = NULL;
        f->bytes[i] = (unsigned char)(before ^ (1u << tried % 8));
        const whirl_status status = read_bytes(f->bytes, f->size, &read);
        if (status.code == WHIRL_OK)
            assert_true(same_result(f->made, read));
        else
            ++refused;
        whirl_result_free(read);
        f->bytes[i] = before;
    }
    assert_true(refused > tried / 4);
}

static void few_flipped_bits_are_found(void **state) {
    flip_bits(*state, 131);
}

/// WHIRL_TEST_EVERY=1 tries all bytes.
static void every_flipped_bit_is_found(void **state) {
    const char *every = getenv("WHIRL_TEST_EVERY");
    flip_bits(*state, every ? (size_t)strtol(every, NULL, 10) : 13);
}

// ---------------------------------------------------------------- files with sound checksums that claim nonsense

/// Opens the file for changes by HDF5's own means.
static hid_t open_for_change(const fixture *f) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    assert_true(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0);
    const hid_t file = H5Fopen(f->path, H5F_ACC_RDWR, access);
    assert_true(file >= 0);
    H5Pclose(access);
    return file;
}

static void change_whole(const fixture *f, const char *object, const char *attribute, int64_t value) {
    const hid_t file = open_for_change(f);
    const hid_t owner = H5Oopen(file, object, H5P_DEFAULT), changed = H5Aopen(owner, attribute, H5P_DEFAULT);
    assert_true(H5Awrite(changed, H5T_NATIVE_INT64, &value) >= 0);
    H5Aclose(changed);
    H5Oclose(owner);
    assert_true(H5Fclose(file) >= 0);
}

static void refuses_claims(void **state) {
    static const struct {
        const char *object, *attribute;
        int64_t value;
        const char *words;
    } claims[] = {
        {"/", "format_version", 3, "format version 3"},
        {"/", "format_version", 1, "format version 1, this whirl reads version 2: compute it again"},
        {"/sweep", "points", 2, "is 2, expected 3 to"},
        {"/sweep", "points", INT64_MAX, "expected 3 to"},
        {"/sweep", "steps_per_revolution", 0, "expected 1 to"},
        {"/sweep", "steps_per_revolution", 2147483647, "is 2147483647, expected 1 to 16777216"},
        {"/sweep", "samples_per_revolution", 2147483647, "expected 1 to 16777216"},
        {"/sweep", "transient", -1, "expected 0 to"},
        {"/sweep", "transient", 2147483647, "expected 0 to 1000000000"},
        {"/sweep", "record", 2147483647, "expected 1 to 100000000"},
        {"/sweep", "watch", 2147483647, "expected 0 to 1100000000"},
        {"/sweep", "waveform_revolutions", 1000, "expected 0 to"},
        {"/sweep", "growth", 3, "expected 0 to 2"},
        {"/detail/made/array", "rows", INT64_MAX, "expected 0 to"},
        {"/detail/made/array", "rows", 2147483647, "more numbers than the file has"},
        {"/detail/made/array", "rows", 4, "not the expected size"},
        {"/detail/made/array", "columns", 0, "expected 1 to"},
        {"/detail/made/nothing", "columns", 0, "expected 1 to"},
        {"/detail/made/array", "repeat", 3, "expected 2 to 2"},
        {"/sweep/regime/code", "rows", 0, "expected 1 x 1"},
        {"/sweep/spectrum/lines", "columns", 1, "expected 16 x 5"},
    };
    fixture *f = *state;
    for (size_t i = 0; i < sizeof claims / sizeof *claims; ++i) {
        whirl_result *read = NULL;
        written(f);
        change_whole(f, claims[i].object, claims[i].attribute, claims[i].value);
        assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, claims[i].words);
        assert_null(read);
    }
}

static void change_text(const fixture *f, const char *object, const char *attribute, const char *text) {
    const hid_t file = open_for_change(f), owner = H5Oopen(file, object, H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    assert_true(H5Tset_size(type, strlen(text) + 1) >= 0 && H5Tset_cset(type, H5T_CSET_UTF8) >= 0);
    assert_true(H5Adelete(owner, attribute) >= 0);
    const hid_t changed = H5Acreate2(owner, attribute, type, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Awrite(changed, type, text) >= 0);
    H5Aclose(changed);
    H5Sclose(space);
    H5Tclose(type);
    H5Oclose(owner);
    assert_true(H5Fclose(file) >= 0);
}

/// Terminals obey escape characters, also those of two bytes (U+009B), and overrides turn what is read.
static void words_are_plain_when_they_are_read(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    written(f);
    change_text(f, "/", "title", "\x1b]0;owned\x07 \xc2\x9b\x33\x31m red \xe2\x80\xae turned Poincar\xc3\xa9 \xff");
    change_text(f, "/provenance", f->made->facts[0].name, "one\ntwo");
    check(whirl_result_read(f->path, &read));
    assert_string_equal(read->title, "?]0;owned? ?31m red ? turned Poincar\xc3\xa9 ?");
    // An attribute that is replaced comes last.
    assert_string_equal(read->facts[read->fact_count - 1].value, "one?two");
    whirl_result_free(read);
}

/// Texts of a program may be cut within a letter, and are the same when they are read.
static void words_that_are_not_plain_are_verified(void **state) {
    fixture *f = *state;
    snprintf(f->made->title, sizeof f->made->title, "cut \x1b[1m \xc3");
    snprintf(f->made->parameters[0].text, sizeof f->made->parameters[0].text, "1\n2");
    check(whirl_result_write(f->made, f->path));
    check(whirl_result_verify(f->made, f->path));
}

static void refuses_impossible_points(void **state) {
    static const int64_t lists[][SYNTHETIC_POINTS] = {{0, 1, 2}, {1, 1, 2}, {2, 1, 3}, {1, 2, 4}, {1, 2, INT64_MIN}};
    fixture *f = *state;
    for (size_t i = 0; i < sizeof lists / sizeof *lists; ++i) {
        whirl_result *read = NULL;
        written(f);
        const hid_t file = open_for_change(f), points = H5Dopen2(file, "/sweep/point", H5P_DEFAULT);
        assert_true(H5Dwrite(points, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, lists[i]) >= 0);
        H5Dclose(points);
        assert_true(H5Fclose(file) >= 0);
        assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "/sweep/point holds");
    }
}

/// Puts another object in the place of /sweep/values.
static void replace_values(const fixture *f, hid_t type, int rank, hsize_t length, bool checksums) {
    const hsize_t dimensions[2] = {length, 1}, chunk[2] = {length < 1024 ? length : 1024, 1};
    const hid_t file = open_for_change(f);
    assert_true(H5Ldelete(file, "/sweep/values", H5P_DEFAULT) >= 0);
    const hid_t space = H5Screate_simple(rank, dimensions, NULL), creation = H5Pcreate(H5P_DATASET_CREATE);
    assert_true(H5Pset_chunk(creation, rank, chunk) >= 0);
    if (checksums) assert_true(H5Pset_fletcher32(creation) >= 0);
    const hid_t dataset = H5Dcreate2(file, "/sweep/values", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    assert_true(dataset >= 0);
    H5Dclose(dataset);
    H5Pclose(creation);
    H5Sclose(space);
    assert_true(H5Fclose(file) >= 0);
}

static void refuses_other_datasets(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    const struct {
        hid_t type;
        int rank;
        hsize_t length;
        bool checksums;
        const char *words;
    } datasets[] = {
        {H5T_IEEE_F64LE, 1, (hsize_t)1 << 40, true, "/sweep/values"}, // nothing of it is stored
        {H5T_IEEE_F64LE, 1, SYNTHETIC_POINTS, false, "what whirl does not write"},
        {H5T_IEEE_F64LE, 2, SYNTHETIC_POINTS, true, "/sweep/values"},
        {H5T_IEEE_F32LE, 1, SYNTHETIC_POINTS, true, "/sweep/values"},
        {H5T_IEEE_F32BE, 1, SYNTHETIC_POINTS, true, "what whirl does not write"},
        {H5T_STD_I64LE, 1, SYNTHETIC_POINTS, true, "/sweep/values"},
    };
    for (size_t i = 0; i < sizeof datasets / sizeof *datasets; ++i) {
        written(f);
        replace_values(f, datasets[i].type, datasets[i].rank, datasets[i].length, datasets[i].checksums);
        assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, datasets[i].words);
    }
}

static void follows_no_links_elsewhere(void **state) {
    fixture *f = *state;
    whirl_result *read = NULL;
    written(f);
    hid_t file = open_for_change(f);
    assert_true(H5Ldelete(file, "/sweep/values", H5P_DEFAULT) >= 0);
    assert_true(H5Lcreate_external(f->path, "/detail/values", file, "/sweep/values", H5P_DEFAULT, H5P_DEFAULT) >= 0);
    assert_true(H5Fclose(file) >= 0);
    assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "what whirl does not write");
    written(f);
    file = open_for_change(f);
    assert_true(H5Ldelete(file, "/sweep", H5P_DEFAULT) >= 0);
    assert_true(H5Lcreate_soft("/detail", file, "/sweep", H5P_DEFAULT, H5P_DEFAULT) >= 0);
    assert_true(H5Fclose(file) >= 0);
    assert_says(whirl_result_read(f->path, &read), WHIRL_BAD_INPUT, "what whirl does not write");
}

int main(void) {
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        IN_FOLDER(reads_what_was_written),
        IN_FOLDER(reads_an_empty_result),
        IN_FOLDER(reads_a_table_without_points),
        IN_FOLDER(a_partial_file_has_what_is_done),
        IN_FOLDER(a_partial_file_is_as_large_as_its_points),
        IN_FOLDER(reads_large_tables),
        IN_FOLDER(reads_maps),
        IN_FOLDER(reads_what_is_left_of_a_map),
        IN_FOLDER(same_results_are_same_files),
        IN_FOLDER(branches_are_known_by_their_study),
        IN_FOLDER(replaces_a_file),
        IN_FOLDER(says_where_it_cannot_write),
        IN_FOLDER(a_full_disk_leaves_the_old_file),
        IN_FOLDER(refuses_names_that_break_the_file),
        IN_FOLDER(says_what_it_cannot_read),
        IN_FOLDER(refuses_other_hdf5_files),
        IN_FOLDER(refuses_every_truncation),
        IN_FOLDER(few_flipped_bits_are_found),
        IN_FOLDER(every_flipped_bit_is_found),
        IN_FOLDER(refuses_claims),
        IN_FOLDER(refuses_impossible_points),
        IN_FOLDER(words_are_plain_when_they_are_read),
        IN_FOLDER(words_that_are_not_plain_are_verified),
        IN_FOLDER(refuses_other_datasets),
        IN_FOLDER(follows_no_links_elsewhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
