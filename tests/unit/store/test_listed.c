// MAT files before version 7.3, written by matio, and universal files, written as their specification says: the same
// numbers, names and units are read; damaged files are refused or read, and never crash.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "foreign.h"
#include "spoiled.h"
#include "whirl/internal/arrays.h"
#include "whole.h"

#include <math.h>
#include <matio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/whirl-listed-XXXXXX";

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

/// Opens the file of `path`.
static arrays_file *opened(void) {
    arrays_file *file;
    const whirl_status status = arrays_open(path, &file);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    assert_true(arrays_is_file(path));
    return file;
}

/// Writes bytes as the file of `path`.
static void write_bytes(const void *bytes, size_t size) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void expect_failure(arrays_file *file, const char *name, size_t first, size_t count, const char *sentence) {
    const size_t from[3] = {0, first, 0}, sizes[3] = {1, count, 1};
    double numbers[16];
    char expected[400];
    const whirl_status status = arrays_read(file, name, from, sizes, numbers);
    snprintf(expected, sizeof expected, "%s%s", path, sentence);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, expected);
}

// ---------------------------------------------------------------- MAT files

enum { ROWS = 3, COLUMNS = 5, ALL = ROWS * COLUMNS };

/// The number at an index of a matrix: whole, and of any type that has a sign or none.
static int number_at(size_t i, bool is_signed) {
    return (int)(i * 17 % 101) - (is_signed ? 50 : 0);
}

/// Makes a matrix of a class whose bytes are the numbers.
#define FILL(T, is_signed)                                                                                             \
    for (size_t i = 0; i < ALL; i++) ((T *)bytes)[i] = (T)number_at(i, is_signed)

static const struct {
    const char *name;
    enum matio_classes class;
    enum matio_types type;
    bool is_signed;
} classes[] = {{"f8", MAT_C_DOUBLE, MAT_T_DOUBLE, true}, {"f4", MAT_C_SINGLE, MAT_T_SINGLE, true},
               {"i1", MAT_C_INT8, MAT_T_INT8, true},     {"u1", MAT_C_UINT8, MAT_T_UINT8, false},
               {"i2", MAT_C_INT16, MAT_T_INT16, true},   {"u2", MAT_C_UINT16, MAT_T_UINT16, false},
               {"i4", MAT_C_INT32, MAT_T_INT32, true},   {"u4", MAT_C_UINT32, MAT_T_UINT32, false},
               {"i8", MAT_C_INT64, MAT_T_INT64, true},   {"u8", MAT_C_UINT64, MAT_T_UINT64, false}};
enum { CLASSES = sizeof classes / sizeof *classes };

static matvar_t *matrix(size_t which, int options) {
    static uint64_t bytes[ALL];
    size_t sizes[] = {ROWS, COLUMNS};
    switch (classes[which].class) {
    case MAT_C_DOUBLE:
        FILL(double, true);
        break;
    case MAT_C_SINGLE:
        FILL(float, true);
        break;
    case MAT_C_INT8:
        FILL(int8_t, true);
        break;
    case MAT_C_UINT8:
        FILL(uint8_t, false);
        break;
    case MAT_C_INT16:
        FILL(int16_t, true);
        break;
    case MAT_C_UINT16:
        FILL(uint16_t, false);
        break;
    case MAT_C_INT32:
        FILL(int32_t, true);
        break;
    case MAT_C_UINT32:
        FILL(uint32_t, false);
        break;
    case MAT_C_INT64:
        FILL(int64_t, true);
        break;
    default:
        FILL(uint64_t, false);
    }
    return Mat_VarCreate(classes[which].name, classes[which].class, classes[which].type, 2, sizes, bytes, options);
}

static matvar_t *text(const char *name, const char *letters) {
    size_t sizes[] = {1, strlen(letters)};
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, sizes, (void *)(uintptr_t)letters, 0);
}

/// Reads a matrix as a whole, a row and a column of it, and a single number.
static void expect_matrix(arrays_file *file, const char *name, bool is_signed) {
    arrays_item item;
    double numbers[ALL] = {0};
    const whirl_status status = arrays_find(file, name, &item);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    // MATLAB's rows are the last dimension, as in files of version 7.3.
    assert_true(item.numbers && item.rank == 2 && item.sizes[0] == COLUMNS && item.sizes[1] == ROWS);
    for (size_t column = 0; column < COLUMNS; column++)
        for (size_t row = 0; row < ROWS; row++)
            for (size_t columns = 1; column + columns <= COLUMNS; columns++)
                for (size_t rows = 1; row + rows <= ROWS; rows++) {
                    const size_t first[] = {column, row}, count[] = {columns, rows};
                    assert_int_equal(arrays_read(file, name, first, count, numbers).code, WHIRL_OK);
                    for (size_t i = 0; i < columns; i++)
                        for (size_t k = 0; k < rows; k++)
                            assert_true(numbers[i * rows + k] ==
                                        (double)number_at((column + i) * ROWS + row + k, is_signed));
                }
}

/// Numbers of every class, alone and as members of structures, compressed and not.
static void classes_of_matlab_are_read(void **state) {
    (void)state;
    for (int compressed = 0; compressed < 2; compressed++) {
        mat_t *mat = Mat_CreateVer(path, NULL, MAT_FT_MAT5);
        size_t one[] = {1, 1}, size[] = {1, 4};
        uint8_t yes[] = {1, 0, 1, 1};
        double z[2][4] = {{1, 2, 3, 4}, {5, 6, 7, 8}};
        mat_complex_split_t complex = {z[0], z[1]};
        assert_non_null(mat);
        matvar_t *all[CLASSES + 8], *inner = Mat_VarCreateStruct("inner", 2, one, NULL, 0);
        matvar_t *outer = Mat_VarCreateStruct("run", 2, one, NULL, 0);
        size_t count = 0;
        for (size_t i = 0; i < CLASSES; i++) {
            all[count++] = matrix(i, 0);
            Mat_VarAddStructField(i % 2 ? inner : outer, classes[i].name);
            Mat_VarSetStructFieldByName(i % 2 ? inner : outer, classes[i].name, 0, matrix(i, 0));
        }
        Mat_VarAddStructField(outer, "inner");
        Mat_VarSetStructFieldByName(outer, "inner", 0, inner);
        Mat_VarAddStructField(outer, "f8_unit");
        Mat_VarSetStructFieldByName(outer, "f8_unit", 0, text(NULL, "um"));
        all[count++] = outer;
        all[count++] = Mat_VarCreate("yes", MAT_C_UINT8, MAT_T_UINT8, 2, size, yes, MAT_F_LOGICAL);
        all[count++] = Mat_VarCreate("z", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size, &complex, MAT_F_COMPLEX);
        all[count++] = text("f4_units", "mil");
        matvar_t *cells[] = {text(NULL, "abc")};
        all[count++] = Mat_VarCreate("cells", MAT_C_CELL, MAT_T_CELL, 2, one, cells, 0);
        for (size_t i = 0; i < count; i++) {
            assert_int_equal(Mat_VarWrite(mat, all[i], compressed ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE), 0);
            Mat_VarFree(all[i]);
        }
        Mat_Close(mat);
        arrays_file *file = opened();
        for (size_t i = 0; i < CLASSES; i++) {
            char name[64];
            expect_matrix(file, classes[i].name, classes[i].is_signed);
            snprintf(name, sizeof name, i % 2 ? "run/inner/%s" : "/run/%s", classes[i].name);
            expect_matrix(file, name, classes[i].is_signed);
            snprintf(name, sizeof name, i % 2 ? "run.inner.%s" : "run.%s", classes[i].name);
            expect_matrix(file, name, classes[i].is_signed);
        }
        arrays_item item;
        assert_int_equal(arrays_find(file, "run/f8", &item).code, WHIRL_OK);
        assert_string_equal(item.unit, "um");
        assert_int_equal(arrays_find(file, "f4", &item).code, WHIRL_OK);
        assert_string_equal(item.unit, "mil");
        const size_t first[] = {0, 0}, four[] = {4, 1};
        double numbers[4];
        assert_int_equal(arrays_read(file, "yes", first, four, numbers).code, WHIRL_OK);
        for (size_t i = 0; i < 4; i++) assert_true(numbers[i] == (double)yes[i]);
        expect_failure(file, "z", 0, 1, ": z has complex numbers, expected numbers");
        expect_failure(file, "f4_units", 0, 1, ": f4_units has texts, expected numbers");
        expect_failure(file, "cells", 0, 1, ": cells has cells, expected numbers");
        expect_failure(file, "run/iner/u1", 0, 1, " has no variable 'run/iner/u1', did you mean 'run/inner/u1'?");
        expect_failure(file, "f8", 2, 2, ": f8 has no such part");
        arrays_close(file);
    }
}

static void put(unsigned char **at, uint64_t value, size_t size, bool big) {
    for (size_t i = 0; i < size; i++) *(*at)++ = (unsigned char)(value >> 8 * (big ? size - 1 - i : i));
}

/// Writes a file of level 5 with a row of whole numbers of 2 bytes, kept as bytes, and a row of real numbers.
static size_t write_level_5(unsigned char *to, bool big) {
    unsigned char *at = to;
    at += snprintf((char *)to, 125, "%-124s", "MATLAB 5.0 MAT-file, by hand");
    put(&at, 0x0100, 2, big);
    *at++ = big ? 'M' : 'I', *at++ = big ? 'I' : 'M';
    for (int real = 0; real < 2; real++) {
        put(&at, 14, 4, big);
        put(&at, (uint64_t)(real ? 72 : 48), 4, big); // bytes of the matrix
        put(&at, 6, 4, big), put(&at, 8, 4, big);
        put(&at, real ? 6 : 10, 4, big), put(&at, 0, 4, big); // class, double or int16
        put(&at, 5, 4, big), put(&at, 8, 4, big);
        put(&at, 1, 4, big), put(&at, real ? 3 : 4, 4, big); // sizes
        put(&at, 1U << 16U | 1U, 4, big);                    // a name of one letter is in the tag
        *at++ = real ? 'r' : 'w';
        put(&at, 0, 3, big);
        if (real) {
            put(&at, 9, 4, big), put(&at, 24, 4, big);
            for (int i = 0; i < 3; i++) {
                const double value = 0.1 * i - 0.1;
                uint64_t bits;
                memcpy(&bits, &value, sizeof bits);
                put(&at, bits, 8, big);
            }
        } else {
            put(&at, 4U << 16U | 1U, 4, big); // bytes with a sign: four of them fit in the tag
            for (int i = 0; i < 4; i++) *at++ = (unsigned char)(100 * i - 128);
        }
    }
    return (size_t)(at - to);
}

/// Writes a file of level 4 with a column of each type.
static size_t write_level_4(unsigned char *to, bool big) {
    static const size_t sizes[] = {8, 4, 4, 2, 2, 1};
    unsigned char *at = to;
    for (uint64_t type = 0; type < 6; type++) {
        put(&at, (big ? 1000U : 0U) + 10 * type, 4, big);
        put(&at, 3, 4, big), put(&at, 1, 4, big), put(&at, 0, 4, big), put(&at, 3, 4, big);
        *at++ = 't', *at++ = (unsigned char)('0' + type), *at++ = '\0';
        for (int i = 0; i < 3; i++) {
            const int value = 50 * i - (type < 4 ? 60 : 0);
            const double eight = value;
            const float four = (float)value;
            uint64_t bits = (uint64_t)(int64_t)value;
            uint32_t low;
            memcpy(&low, &four, sizeof low);
            if (type == 0) memcpy(&bits, &eight, sizeof bits);
            if (type == 1) bits = low;
            put(&at, bits, sizes[type], big);
        }
    }
    return (size_t)(at - to);
}

/// Files of both orders of bytes, level 4, and numbers that are kept in fewer bytes than their class has.
static void orders_of_bytes_and_level_4_are_read(void **state) {
    unsigned char bytes[1024];
    double numbers[4];
    (void)state;
    for (int big = 0; big < 2; big++) {
        const size_t first[] = {0, 0}, four[] = {4, 1}, three[] = {3, 1}, row[] = {1, 3};
        write_bytes(bytes, write_level_5(bytes, big));
        arrays_file *file = opened();
        assert_int_equal(arrays_read(file, "w", first, four, numbers).code, WHIRL_OK);
        for (int i = 0; i < 4; i++) assert_true(numbers[i] == (double)(int8_t)(unsigned char)(100 * i - 128));
        assert_int_equal(arrays_read(file, "r", first, three, numbers).code, WHIRL_OK);
        for (int i = 0; i < 3; i++) assert_true(numbers[i] == 0.1 * i - 0.1);
        arrays_close(file);
        write_bytes(bytes, write_level_4(bytes, big));
        file = opened();
        for (int type = 0; type < 6; type++) {
            const char name[] = {'t', (char)('0' + type), '\0'};
            assert_int_equal(arrays_read(file, name, first, row, numbers).code, WHIRL_OK);
            for (int i = 0; i < 3; i++) assert_true(numbers[i] == 50.0 * i - (type < 4 ? 60.0 : 0.0));
        }
        arrays_close(file);
    }
}

// ---------------------------------------------------------------- universal files

/// A record to be written.
typedef struct record {
    const char *first, *entity; ///< line 1, name of the response's point
    int node, direction, type;  ///< type: 2 and 4 real, 5 and 6 complex
    bool even, binary, big;
    int axis; ///< 17 time, 18 frequency
    const char *axis_unit, *unit;
} record;

enum { POINTS = 11 };

static double abscissa_at(size_t i, const record *of) {
    return of->even ? 0.5 + 0.25 * (double)i : 0.5 + 0.25 * (double)(i * i);
}

/// Numbers that five decimals hold, so that all forms keep them.
static double real_at(size_t i, const record *of) {
    return ((double)i - 4.0) * (of->direction + 10.0) / 8.0;
}

static double imaginary_at(size_t i) {
    return 3.0 - 0.5 * (double)i;
}

static void put_real(unsigned char **at, double value, size_t size, bool big) {
    const float four = (float)value;
    uint32_t low;
    uint64_t bits;
    memcpy(&low, &four, sizeof low);
    memcpy(&bits, &value, sizeof bits);
    put(at, size == 4 ? low : bits, size, big);
}

/// Writes a dataset 58 or 58b; returns its end.
static unsigned char *write_record(unsigned char *to, const record *of) {
    const bool complex = of->type >= 5, doubled = of->type == 4 || of->type == 6;
    const size_t each = (complex ? 2 : 1) + (of->even ? 0 : 1), size = doubled ? 8 : 4;
    char *text = (char *)to;
    text += sprintf(text, "    -1\n    58");
    if (of->binary)
        text +=
            sprintf(text, "b%6d%6d%12d%12zu%6d%6d%12d%12d", of->big ? 2 : 1, 2, 11, each * size * POINTS, 0, 0, 0, 0);
    text += sprintf(text, "\n%-80s\nNONE\n30-NOV-26 10:00:00\nNONE\nNONE\n", of->first);
    text += sprintf(text, "%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d\n", 1, 0, 0, 0, of->entity, of->node, of->direction,
                    "NONE", 0, 0);
    text += sprintf(text, "%10d%10d%10d%13.5E%13.5E%13.5E\n", of->type, POINTS, of->even, of->even ? 0.5 : 0.0,
                    of->even ? 0.25 : 0.0, 0.0);
    text += sprintf(text, "%10d%5d%5d%5d %-20s %-20s\n", of->axis, 0, 0, 0, "NONE", of->axis_unit);
    text += sprintf(text, "%10d%5d%5d%5d %-20s %-20s\n", 8, 0, 0, 0, "Displacement", of->unit);
    for (int i = 0; i < 2; i++) text += sprintf(text, "%10d%5d%5d%5d %-20s %-20s\n", 0, 0, 0, 0, "NONE", "NONE");
    unsigned char *at = (unsigned char *)text;
    size_t written = 0;
    for (size_t i = 0; i < POINTS; i++) {
        const double values[] = {abscissa_at(i, of), real_at(i, of), imaginary_at(i)};
        for (size_t k = of->even ? 1 : 0; k < (complex ? 3U : 2U); k++) {
            if (of->binary) {
                put_real(&at, values[k], size, of->big);
                continue;
            }
            at += sprintf((char *)at, doubled && k > 0 ? "%20.12E" : "%13.5E", values[k]);
            written++;
            const size_t line = !doubled ? 6 : of->even ? 4 : complex ? 3 : 4;
            if (written % line == 0) *at++ = '\n';
        }
    }
    if (!of->binary && at[-1] != '\n') *at++ = '\n';
    at += sprintf((char *)at, of->binary ? "\n    -1\n" : "    -1\n");
    return at;
}

/// All eight forms of the specification, as text and in both orders of bytes.
static void forms_of_universal_files_are_read(void **state) {
    unsigned char bytes[8192];
    (void)state;
    for (int form = 0; form < 24; form++) {
        static const int types[] = {2, 4, 5, 6};
        const record own = {.first = "NONE",
                            .entity = "disc",
                            .node = 7,
                            .direction = 1,
                            .type = types[form % 4],
                            .even = form / 4 % 2,
                            .binary = form / 8 > 0,
                            .big = form / 8 > 1,
                            .axis = 17,
                            .axis_unit = "NONE",
                            .unit = "MM"};
        const bool complex = own.type >= 5;
        write_bytes(bytes, (size_t)(write_record(bytes, &own) - bytes));
        arrays_file *file = opened();
        arrays_item item;
        assert_int_equal(arrays_find(file, "time", &item).code, WHIRL_OK);
        assert_string_equal(item.unit, "s");
        assert_int_equal(arrays_find(file, "disc x", &item).code, WHIRL_OK);
        assert_string_equal(item.unit, "mm");
        assert_true(item.rank == 1 && item.sizes[0] == POINTS && item.numbers);
        double numbers[6][POINTS];
        static const char *const names[] = {
            "time", "disc x", "disc x/real", "disc x/imaginary", "disc x lag", "record 1/amplitude"};
        for (size_t first = 0; first < 3; first++) {
            const size_t count = POINTS - 2 * first;
            for (size_t k = 0; k < (complex ? 6U : 2U); k++)
                assert_int_equal(arrays_read(file, names[k], &first, &count, numbers[k]).code, WHIRL_OK);
            for (size_t i = 0; i < count; i++) {
                const double re = real_at(first + i, &own), im = imaginary_at(first + i);
                assert_true(numbers[0][i] == abscissa_at(first + i, &own));
                assert_true(numbers[1][i] == (complex ? hypot(re, im) : re));
                if (!complex) continue;
                assert_true(numbers[2][i] == re && numbers[3][i] == im && numbers[5][i] == numbers[1][i]);
                const double lag = numbers[4][i] * atan(1.0) / 45.0; // z = amplitude exp(-j lag)
                assert_true(fabs(numbers[1][i] * cos(lag) - re) < 1e-14 * (1.0 + numbers[1][i]) &&
                            fabs(numbers[1][i] * sin(lag) + im) < 1e-14 * (1.0 + numbers[1][i]));
            }
        }
        arrays_close(file);
    }
}

/// Keeps the names that are handed over, one after another.
static whirl_status keep_name(void *context, const char *name, const arrays_item *item) {
    char *names = context;
    snprintf(names + strlen(names), 400 - strlen(names), "%s[%s] ", name, item->unit);
    return whirl_ok();
}

/// Writes records and returns their names.
static void expect_names(const record *records, size_t count, const char *expected) {
    unsigned char bytes[32768], *at = bytes;
    char names[400] = "";
    // Other datasets are skipped, and so is what lies between.
    at += sprintf((char *)at, "    -1\r\n   151\r\nsome model\r\n    -1\r\n");
    for (size_t i = 0; i < count; i++) at = write_record(at, &records[i]);
    write_bytes(bytes, (size_t)(at - bytes));
    arrays_file *file = opened();
    assert_int_equal(arrays_visit(file, keep_name, names).code, WHIRL_OK);
    assert_string_equal(names, expected);
    arrays_close(file);
}

/// Names of records from points, directions and lines; several abscissas; several records of a point.
static void records_have_names(void **state) {
    (void)state;
    const record one = {"NONE", "disc", 1, 1, 4, true, false, false, 17, "sec", "um"};
    record many[] = {one, one, one, one, one, one};
    many[1].direction = -2;
    many[2] = (record){"keyphasor", "NONE", 0, 0, 2, true, true, false, 17, "s", "V"};
    many[3] = (record){"NONE", "NONE", 12, 2, 6, false, true, true, 17, "S", "NONE"};
    many[4] = one;
    many[5] = (record){"NONE", "NONE", 0, 4, 4, true, false, false, 17, "s", "RAD"};
    expect_names(many, 3, "time[s] disc x[um] disc 270[um] keyphasor[V] ");
    expect_names(many, 4,
                 "disc x/time[s] disc x[um] disc 270/time[s] disc 270[um] keyphasor/time[s] keyphasor[V] "
                 "12 y/time[s] 12 y[] 12 y lag[deg] ");
    many[3] = many[5];
    expect_names(many, 5, "time[s] disc x[um] disc 270[um] keyphasor[V] record/4[rad] disc x/5[um] ");
    many[0].axis = many[1].axis = 18;
    many[0].axis_unit = many[1].axis_unit = "NONE";
    expect_names(many, 2, "frequency[Hz] disc x[um] disc 270[um] ");
}

/// Failures of universal files say the record and the line.
static void other_universal_files_are_refused(void **state) {
    static const record one = {"NONE", "disc", 1, 1, 4, true, false, false, 17, "s", "um"};
    unsigned char bytes[8192];
    arrays_file *file;
    char expected[200];
    (void)state;
    const size_t size = (size_t)(write_record(bytes, &one) - bytes);
    write_bytes(bytes, size);
    file = opened();
    const size_t first = 3, many = POINTS;
    double numbers[POINTS];
    assert_int_equal(arrays_read(file, "disc x", &first, &many, numbers).code, WHIRL_BAD_INPUT);
    expect_failure(file, "disk x", 0, 1, " has no record 'disk x', did you mean 'disc x'?");
    expect_failure(file, "record 2", 0, 1, " has no record 'record 2', expected one of time, disc x");
    arrays_close(file);
    // Spoil a number, and cut the file off.
    for (int i = 0; i < 7; i++) bytes[size - 40 + (size_t)i] = (unsigned char)"  1.2.3"[i];
    write_bytes(bytes, size);
    file = opened();
    const size_t zero = 0;
    const whirl_status status = arrays_read(file, "disc x", &zero, &many, numbers);
    snprintf(expected, sizeof expected, "%s: disc x dataset 58 number 1, line 16: a number cannot be read", path);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, expected);
    arrays_close(file);
    write_bytes(bytes, 700);
    assert_int_equal(arrays_open(path, &file).code, WHIRL_BAD_INPUT);
    write_bytes("    -1\n   151\nnothing\n    -1\n", 29);
    const whirl_status none = arrays_open(path, &file);
    snprintf(expected, sizeof expected, "%s: has no dataset 58, expected functions over time, frequency or speed",
             path);
    assert_string_equal(none.message, expected);
}

// ---------------------------------------------------------------- damage

/// Cuts a file off at every length, changes every byte in several ways, and several bytes at once.
static void spoil(const unsigned char *bytes, size_t size) {
    enum { MUTANTS = 3000 };
    static const unsigned char masks[] = {0xff, 0x80, 0x01, 0x10};
    uint64_t random = 88172645463325252U;
    unsigned char *changed = malloc(size);
    assert_non_null(changed);
    for (size_t length = 0; length < size; length++) spoiled_read(bytes, length, "a.mat");
    for (size_t i = 0; i < size * sizeof masks; i++) {
        memcpy(changed, bytes, size);
        changed[i % size] ^= masks[i / size];
        spoiled_read(changed, size, "a.mat");
    }
    for (int mutant = 0; mutant < MUTANTS; mutant++) {
        memcpy(changed, bytes, size);
        spoiled_mutate(changed, size, mutant, &random);
        spoiled_read(changed, size, "a.mat");
    }
    free(changed);
}

static void damage_is_no_crash(void **state) {
    unsigned char bytes[16384], *at = bytes;
    (void)state;
    for (int big = 0; big < 2; big++) {
        spoil(bytes, write_level_5(bytes, big));
        spoil(bytes, write_level_4(bytes, big));
    }
    record own = {"NONE", "disc", 1, 1, 6, false, false, false, 17, "s", "um"};
    at = write_record(at, &own);
    own.binary = true, own.even = true, own.type = 2;
    spoil(bytes, (size_t)(write_record(at, &own) - bytes));
    // A structure with a text, compressed and not.
    for (int compressed = 0; compressed < 2; compressed++) {
        unsigned char *whole = NULL;
        size_t one[] = {1, 1}, size;
        mat_t *mat = Mat_CreateVer(path, NULL, MAT_FT_MAT5);
        matvar_t *outer = Mat_VarCreateStruct("run", 2, one, NULL, 0);
        assert_non_null(mat);
        for (size_t i = 0; i < 3; i++) {
            Mat_VarAddStructField(outer, classes[i].name);
            Mat_VarSetStructFieldByName(outer, classes[i].name, 0, matrix(i, 0));
        }
        Mat_VarAddStructField(outer, "f8_unit");
        Mat_VarSetStructFieldByName(outer, "f8_unit", 0, text(NULL, "um"));
        assert_int_equal(Mat_VarWrite(mat, outer, compressed ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE), 0);
        Mat_VarFree(outer);
        Mat_Close(mat);
        assert_int_equal(whole_file(path, &whole, &size).code, WHIRL_OK);
        spoil(whole, size);
        free(whole);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classes_of_matlab_are_read),        cmocka_unit_test(orders_of_bytes_and_level_4_are_read),
        cmocka_unit_test(forms_of_universal_files_are_read), cmocka_unit_test(records_have_names),
        cmocka_unit_test(other_universal_files_are_refused), cmocka_unit_test(damage_is_no_crash),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
