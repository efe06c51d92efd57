// Measured numbers outside of a fit: numbers in SI with their places, and refusals as those of fits.
#include "case_support.h"

#include <math.h>

#include "whirl/internal/measured.h"

static whirl_case *object;

static int open_case(void **state) {
    (void)state;
    return whirl_case_parse(good_case, strlen(good_case), "good.yaml", NULL, &object).code;
}

static int close_case(void **state) {
    (void)state;
    whirl_case_free(object);
    return 0;
}

/// Reads a table for good_case.
static whirl_status read_table(const char *text, whirl_measured_table **out) {
    return whirl_measured_read(object, "m.csv", text, strlen(text), NULL, 0, out);
}

static void expect_number(const whirl_measured_table *measured, size_t index, whirl_fit_quantity quantity, double at,
                          double value) {
    const whirl_fit_number *number = &measured->fit.numbers[index];
    assert_true(index < measured->fit.number_count);
    assert_int_equal(number->quantity, quantity);
    assert_true(fabs(number->at - at) < 1e-12);
    assert_true(fabs(number->value - value) < 1e-15);
}

/// An orbit over two revolutions keeps its instants, while a fit folds them into the revolutions of its orbits.
static void instants_are_those_of_the_table(void **state) {
    whirl_measured_table *measured;
    (void)state;
    const whirl_status status = read_table("# Orbit\nangle [deg], disc x [um], disc y [mm]\n"
                                           "0, 10, 0.02\n90, 11, 0.03\n180, 12, 0.04\n270, 13, 0.05\n"
                                           "360, 14, 0.06\n450, 15, 0.07\n",
                                           &measured);
    assert_int_equal(status.code, WHIRL_OK);
    assert_string_equal(measured->title, "Orbit");
    assert_int_equal(measured->fit.motion_count, 1);
    assert_int_equal(measured->fit.number_count, 12);
    expect_number(measured, 0, WHIRL_FIT_SAMPLE, 0.0, 10e-6);
    expect_number(measured, 1, WHIRL_FIT_SAMPLE, 0.0, 20e-6);
    expect_number(measured, 10, WHIRL_FIT_SAMPLE, 1.25, 15e-6);
    assert_true(fabs(measured->fit.numbers[1].angle - 1.5707963267948966) < 1e-12);
    whirl_measured_free(measured);
}

/// 0.5X is an order of any motion, and vectors have the speed or the parameter of their row.
static void vectors_have_the_place_of_their_row(void **state) {
    whirl_measured_table *measured;
    (void)state;
    assert_int_equal(
        read_table("speed [rpm];disc 45 0.5X [um];disc 45 0.5X lag [deg]\n600;4;90\n1200;5;0\n", &measured).code,
        WHIRL_OK);
    assert_int_equal(measured->fit.motion_count, 2);
    assert_true(fabs(measured->fit.motions[1].speed - 125.66370614359172) < 1e-9);
    expect_number(measured, 0, WHIRL_FIT_COS, 0.5, 0.0);
    expect_number(measured, 1, WHIRL_FIT_SIN, 0.5, 4e-6);
    expect_number(measured, 2, WHIRL_FIT_COS, 0.5, 5e-6);
    whirl_measured_free(measured);
    assert_int_equal(read_table("kappa,journal y [um]\n3,7\n", &measured).code, WHIRL_OK);
    assert_int_equal(measured->fit.motions[0].given_count, 1);
    assert_string_equal(measured->fit.motions[0].given[0].name, "kappa");
    assert_true(measured->fit.motions[0].given[0].value == 3.0);
    assert_int_equal(measured->fit.numbers[0].station, 1);
    whirl_measured_free(measured);
}

/// A universal file has the numbers of a table, and bytes of another kind under such a name are refused.
static void bytes_of_other_files_are_tables(void **state) {
    static const char file[] = "    -1\n    58\nNONE\nNONE\nNONE\nNONE\nNONE\n"
                               "    1         0    0         0       disc         0   1       NONE         0   0\n"
                               "         2         3         1  0.00000e+00  2.50000e-01  0.00000e+00\n"
                               "        17    0    0    0 NONE                 s\n"
                               "         8    0    0    0 NONE                 um\n"
                               "         0    0    0    0 NONE                 NONE\n"
                               "         0    0    0    0 NONE                 NONE\n"
                               "  1.00000e+00  2.00000e+00  4.00000e+00\n    -1\n";
    whirl_measured_table *measured;
    (void)state;
    assert_int_equal(whirl_measured_read(object, "m.uff", file, sizeof file - 1, NULL, 0, &measured).code, WHIRL_OK);
    assert_int_equal(measured->fit.number_count, 3);
    expect_number(measured, 0, WHIRL_FIT_WAVEFORM, 0.0, 1e-6);
    expect_number(measured, 2, WHIRL_FIT_WAVEFORM, 0.5, 4e-6);
    whirl_measured_free(measured);
    // It is known by its bytes, whatever its name is.
    assert_int_equal(whirl_measured_read(object, "m.txt", file, sizeof file - 1, NULL, 0, &measured).code, WHIRL_OK);
    whirl_measured_free(measured);
    whirl_status status = whirl_measured_read(object, "m.uff", file, sizeof file - 20, NULL, 0, &measured);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "m.uff: dataset 58 number 1, line 13: is cut off");
    static const char *const names[] = {"m.h5", "m.HDF5", "m.mat", "m.uff", "m.unv"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char expected[80];
        snprintf(expected, sizeof expected, "%s: is no HDF5, MAT or universal file", names[i]);
        status = whirl_measured_read(object, names[i], "0", i % 2, NULL, 0, &measured);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_string_equal(status.message, expected);
        assert_null(measured);
    }
}

/// Columns are chosen from a file by their names; a column of pulses says when the mark is at the x axis.
static void columns_are_chosen(void **state) {
    static const csv_chosen chosen[] = {{"time [ms]", "t"}, {"disc x [um]", "CH1"}, {"keyphasor", "column 2"}};
    static const csv_chosen wrong[] = {{"time [s]", "t"}, {"disc x [um]", "CH2"}};
    char text[8192] = "t,mark [V],CH1,of no use\n";
    whirl_measured_table *measured;
    csv_listed *columns;
    size_t count;
    (void)state;
    // A pulse rises through half of its height at 12.5 ms, and every 20 ms from then on.
    for (int i = 0; i < 200; i++) {
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%d,%d,%d,7\n", i, i % 20 >= 13 && i % 20 < 16, i);
    }
    assert_int_equal(whirl_measured_read(object, "m.csv", text, strlen(text), chosen, 3, &measured).code, WHIRL_OK);
    assert_int_equal(measured->fit.number_count, 200);
    expect_number(measured, 0, WHIRL_FIT_WAVEFORM, -12.5e-3, 0.0);
    expect_number(measured, 100, WHIRL_FIT_WAVEFORM, 87.5e-3, 100e-6);
    assert_true(fabs(measured->fit.motions[0].speed - 314.15926535897932) < 1e-9);
    whirl_measured_free(measured);
    const whirl_status status = whirl_measured_read(object, "m.csv", text, strlen(text), wrong, 2, &measured);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message,
                        "m.csv: there is no column 'CH2', expected one of 't', 'mark', 'CH1', 'of no use'");
    // The columns of a file are listed.
    assert_int_equal(csv_list("m.csv", text, strlen(text), &columns, &count).code, WHIRL_OK);
    assert_int_equal(count, 4);
    assert_string_equal(columns[1].name, "mark");
    assert_string_equal(columns[1].unit, "V");
    assert_int_equal(columns[3].count, 200);
    free(columns);
    assert_int_equal(csv_list("m.mat", text, strlen(text), &columns, &count).code, WHIRL_BAD_INPUT);
    assert_null(columns);
}

/// A refusal has one sentence with the file, the line, the column, what was found and what is expected.
static void refusals_have_their_place(void **state) {
    static const char *const tables[][2] = {
        {"time [s], disk x [um]\n0, 1\n", "m.csv:1:11: 'disk' is no station, did you mean disc?"},
        {"time [s], disc x\n0, 1\n", "m.csv:1:11: this column has no unit, expected one in brackets: [um]"},
        {"time [s], disc x [um]\n0, 1\n0.1, one\n", "m.csv:3:6: 'one' is no number"},
        {"disc x [um]\n1\n",
         "m.csv:1:1: there is no column 'angle [deg]', 'time [s]', 'speed [rpm]' or of a parameter"},
        {"", "m.csv:1:1: there is no row of numbers, expected a line of headings and some"},
    };
    whirl_measured_table *measured;
    (void)state;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        const whirl_status status = read_table(tables[i][0], &measured);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_string_equal(status.message, tables[i][1]);
        assert_null(measured);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_chosen),
        cmocka_unit_test(instants_are_those_of_the_table),
        cmocka_unit_test(vectors_have_the_place_of_their_row),
        cmocka_unit_test(bytes_of_other_files_are_tables),
        cmocka_unit_test(refusals_have_their_place),
    };
    return cmocka_run_group_tests(tests, open_case, close_case);
}
