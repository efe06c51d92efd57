// Units of figures: chosen by the command, by the result, or by its case; and how symbols are set.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "figure_build.h"
#include "gnuplot_script.h"
#include "machine_at.h"
#include "sample.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

static whirl_shown_units units_for(const whirl_result *result, const char *asked) {
    whirl_shown_units units;
    assert_int_equal(whirl_result_shown_units(result, asked, &units).code, WHIRL_OK);
    return units;
}

static void assert_labels(const whirl_shown_units *units, const char *length, const char *amplitude) {
    char label[UNIT_LABEL_SIZE];
    units_length_label(units, WHIRL_FROM_CENTRE, "x", label, sizeof label);
    assert_string_equal(label, length);
    units_length_label(units, WHIRL_AMPLITUDE, "amplitude", label, sizeof label);
    assert_string_equal(label, amplitude);
}

/// The clearance c = 0.2 mm is the length scale of the sample.
static void lengths(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    whirl_shown_units units = units_for(result, "");
    assert_labels(&units, "x / c", "amplitude / c (0-p)");
    units = units_for(result, "p-p");
    assert_labels(&units, "x / c", "amplitude / c (p-p)");
    assert_true(units.amplitude == 2.0);
    units = units_for(result, "um, p-p");
    assert_labels(&units, "x (\u00b5m)", "amplitude (\u00b5m p-p)");
    assert_true(fabs(units.length - 200.0) < 1e-11);
    units = units_for(result, "mil");
    assert_true(fabs(units.length * 25.4e-6 - 200e-6) < 1e-18);
    result->parameter_count = 1; // the scale has no name any more
    units = units_for(result, "");
    assert_labels(&units, "x (mm)", "amplitude (mm 0-p)");
    assert_true(fabs(units.length - 0.2) < 1e-15);
    units = units_for(result, "scale");
    assert_labels(&units, "x / (0.2 mm)", "amplitude / (0.2 mm) (0-p)");
    whirl_result_free(result);
}

/// The units of the command replace those of the result, kind by kind; a word of a file that is no unit has no effect.
static void units_of_command_and_result(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    assert_int_equal(whirl_result_add_fact(result, "units", "um, Hz").code, WHIRL_OK);
    whirl_shown_units units = units_for(result, "mil, rms");
    assert_labels(&units, "x (mil)", "amplitude (mil rms)");
    assert_true(fabs(units_order(&units, 100.0 * acos(-1.0)) - 50.0) < 1e-12); // 50 turns a second
    assert_true(isnan(units_order(&units, (double)NAN)));
    // A system that is asked for leaves nothing of the result's own words; one of the result's own fills in the rest.
    units = units_for(result, "US");
    assert_labels(&units, "x (mil)", "amplitude (mil p-p)");
    units = units_for(result, "SI");
    assert_labels(&units, "x / c", "amplitude / c (0-p)");
    assert_int_equal(whirl_result_add_fact(result, "units", "um, US").code, WHIRL_OK);
    units = units_for(result, "0-p");
    assert_labels(&units, "x (\u00b5m)", "amplitude (\u00b5m 0-p)");
    assert_int_equal(whirl_result_add_fact(result, "units", "um, <b>").code, WHIRL_OK);
    units = units_for(result, "");
    assert_labels(&units, "x / c", "amplitude / c (0-p)");
    assert_true(isnan(units_order(&units, 100.0)));
    whirl_result_free(result);
}

static void parameters(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    char label[UNIT_LABEL_SIZE];
    whirl_table *detail = &result->tables[1];
    snprintf(detail->parameter, sizeof detail->parameter, "omega");
    result->parameters[0] = (whirl_parameter){"omega", "rad/s", "6000 rpm", 200.0 * acos(-1.0)};
    detail->values[0] = 100.0 * acos(-1.0);
    whirl_shown_units units = units_for(result, "");
    units_point_label(&units, detail, 0, label, sizeof label);
    assert_string_equal(label, "omega = 3000 rpm");
    units = units_for(result, "rad/s");
    units_point_label(&units, detail, 0, label, sizeof label);
    assert_string_equal(label, "omega = 314.159 rad/s");
    whirl_result_free(result);
}

/// A parameter is shown in the unit that is chosen for its kind, by the factors of NIST SP 811. Without a choice
/// it is shown as the case writes it; temperatures, whose units differ by an offset, too, are shown in K.
static void parameters_in_chosen_units(void **state) {
    static const struct {
        const char *si, *written, *unit;
        double shown; ///< of 1 in SI
    } kinds[] = {{"N/m", "1 N/m", "lbf/in", 1.0 / 175.1268},
                 {"N s/m", "1 N s/m", "lbf s/in", 1.0 / 175.1268},
                 {"kg", "1 kg", "lbm", 1.0 / 0.45359237},
                 {"N", "1 N", "lbf", 1.0 / 4.448222},
                 {"N m", "1 N m", "lbf in", 1.0 / 0.1129848},
                 {"kg m", "1 kg m", "oz in", 1.0 / 7.200778e-4},
                 {"kg m2", "1 kg m2", "lbm in2", 1.0 / 2.926397e-4},
                 {"Pa", "1 Pa", "psi", 1.0 / 6894.757},
                 {"Pa s", "1 Pa s", "cP", 1000.0},
                 {"kg/m3", "1 kg/m3", "lbm/ft3", 1.0 / 16.01846},
                 {"rad/s", "1 rad/s", "rpm", 9.549297},
                 {"m", "1 m", "mil", 1.0 / 25.4e-6},
                 {"K", "300 K", "K", 1.0},
                 {"rad", "1 rad", "rad", 1.0}};
    (void)state;
    whirl_result *result = sample_result();
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        whirl_parameter *own = &result->parameters[0];
        *own = (whirl_parameter){"omega", "", "", 1.0};
        snprintf(own->unit, sizeof own->unit, "%s", kinds[i].si);
        snprintf(own->text, sizeof own->text, "%s", kinds[i].written);
        whirl_shown_units units = units_for(result, "US");
        whirl_unit unit = whirl_shown_parameter(&units, "omega");
        assert_string_equal(unit.name, kinds[i].unit);
        assert_true(fabs(1.0 / unit.size - kinds[i].shown) < 4e-7 * kinds[i].shown);
        units = units_for(result, "");
        unit = whirl_shown_parameter(&units, "omega");
        assert_string_equal(unit.name, kinds[i].si);
    }
    // A word for another kind chooses nothing of it; units of their own have none.
    snprintf(result->parameters[0].unit, sizeof result->parameters[0].unit, "N/m");
    snprintf(result->parameters[0].text, sizeof result->parameters[0].text, "1 N/m");
    whirl_shown_units units = units_for(result, "lbf, psi");
    assert_string_equal(whirl_shown_parameter(&units, "omega").name, "N/m");
    units = units_for(result, "N/mm");
    assert_string_equal(whirl_shown_parameter(&units, "omega").name, "N/mm");
    whirl_result_free(result);
}

/// The weight of a machine in inches: 9.80665 / 0.0254 in/s2, once or twice in a sentence; words stay as they are.
static void weight_in_chosen_units(void **state) {
    static const struct {
        const char *fact, *units, *expected;
    } weights[] = {{"9.80665 m/s2 across the shafts", "", "9.80665 m/s2 across the shafts"},
                   {"9.80665 m/s2 across the shafts", "US", "386.089 in/s2 across the shafts"},
                   {"8.49281 m/s2 along the shafts, which lean, and 4.90332 m/s2 across", "US",
                    "334.363 in/s2 along the shafts, which lean, and 193.044 in/s2 across"},
                   {"none: gravity is 0", "US", "none: gravity is 0"}};
    (void)state;
    for (size_t i = 0; i < sizeof weights / sizeof *weights; i++) {
        char text[256];
        whirl_result *result = sample_result();
        assert_int_equal(whirl_result_add_fact(result, "weight", weights[i].fact).code, WHIRL_OK);
        const whirl_shown_units units = units_for(result, weights[i].units);
        whirl_shown_sentence(&units, weights[i].fact, text, sizeof text);
        assert_string_equal(text, weights[i].expected);
        whirl_shown_sentence(&units, weights[i].fact, text, 8); // what does not fit is cut
        assert_true(strlen(text) < 8);
        whirl_result_free(result);
    }
}

/// Points with different length scales are shown with their own; a parameter that changes no scale is not one.
static void points_have_scales(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    char label[UNIT_LABEL_SIZE];
    whirl_table *detail = &result->tables[1];
    snprintf(detail->parameter, sizeof detail->parameter, "c");
    detail->length_scales = sample_take(detail->count, sizeof *detail->length_scales);
    for (size_t i = 0; i < detail->count; i++)
        detail->length_scales[i] = detail->values[i] = 2e-4 + 1e-4 * (double)(i + 1);
    whirl_shown_units units = units_for(result, "um");
    assert_labels(&units, "x (\u00b5m)", "amplitude (\u00b5m 0-p)");
    assert_true(fabs(whirl_shown_length(&units, NULL, 0) - 200.0) < 1e-9);
    assert_true(fabs(whirl_shown_length(&units, &result->tables[0], 0) - 200.0) < 1e-9);
    assert_true(fabs(whirl_shown_length(&units, detail, 0) - 300.0) < 1e-9);
    assert_false(whirl_shown_one_length(&units, detail));
    units_parameter_label(&units, "c", label, sizeof label);
    assert_string_equal(label, "c (\u00b5m)");
    units = units_for(result, "");
    assert_labels(&units, "x / c", "amplitude / c (0-p)");
    assert_true(whirl_shown_length(&units, detail, 0) == 1.0);
    detail->values[0] = 7e-4; // c varies by itself
    units = units_for(result, "");
    assert_true(units_for(result, "").ratio == false);
    units_length_label(&units, WHIRL_FROM_CENTRE, "x", label, sizeof label);
    assert_null(strstr(label, "/ c"));
    whirl_result_free(result);
}

/// Returns the sample as a result of that case, with a sweep over `parameter` whose last point is at `value`.
static whirl_result *result_of(const char *text, const char *parameter, double value) {
    whirl_result *result = sample_result();
    whirl_table *sweep = &result->tables[0];
    free(result->case_text);
    result->case_text = strdup(text);
    snprintf(sweep->parameter, sizeof sweep->parameter, "%s", parameter);
    sweep->values[3] = value;
    return result;
}

/// Gap and clearance of a point follow the parameter, in the length scale of that point.
static void walls(void **state) {
    (void)state;
    static const char text[] =
        "whirl: 1\nparameters: {g: 1 mm}\n"
        "rotor:\n  speed: 100 rad/s\n  length_scale: = 2*g\n"
        "  stations: {disc: {mass: 1 kg}, journal: {mass: 1 kg}}\n"
        "  elements: [shaft: {between: [disc, ground], k1: 1 N/m},\n"
        "    film: {at: journal, clearance: 3 mm, viscosity: 0.02 Pa s, length: 12 mm, radius: 25 mm},\n"
        "    rub: {at: disc, gap: = 3*g, stiffness: 1 N/m}]\n"
        "study: {sweep: {parameter: g, from: 1 mm, to: 2 mm, points: 4}}\n";
    whirl_result *result = result_of(text, "g", 2e-3);
    const whirl_table *sweep = &result->tables[0];
    result->parameters[0] = (whirl_parameter){"g", "m", "1 mm", 1e-3};
    result->parameter_count = 1;
    whirl_case *machine;
    assert_int_equal(WHIRL_OK, machine_of(result, &machine).code);
    assert_non_null(machine);
    assert_true(fabs(machine_walls_at(machine, result, sweep, 3, 0).gap - 1.5) < 1e-14);
    assert_true(machine_walls_at(machine, result, sweep, 3, 0).clearance == 0.0);
    assert_true(fabs(machine_walls_at(machine, result, sweep, 3, 1).clearance - 0.75) < 1e-14);
    whirl_case_free(machine);
    assert_true(machine_walls_at(NULL, result, sweep, 3, 0).gap == result->stations[0].gap);
    whirl_result_free(result);
}

/// The speed follows the parameter through the case's own expressions, with what --set changed.
static void speeds(void **state) {
    (void)state;
    static const char text[] =
        "whirl: 1\nparameters: {ratio: 0.5, critical: 100 rad/s}\n"
        "rotor:\n  speed: = ratio*critical\n  length_scale: 1 mm\n"
        "  stations: {disc: {mass: 1 kg}}\n  elements: [shaft: {between: [disc, ground], k1: 1 N/m}]\n"
        "study: {sweep: {parameter: ratio, from: 0.5, to: 2, points: 4}}\n";
    whirl_result *result = result_of(text, "ratio", 1.5);
    whirl_table *sweep = &result->tables[0];
    result->parameters[0] = (whirl_parameter){"ratio", "1", "0.5", 0.5};
    result->parameters[1] = (whirl_parameter){"critical", "rad/s", "300 rad/s", 300.0};
    whirl_case *machine;
    assert_int_equal(WHIRL_OK, machine_of(result, &machine).code);
    assert_non_null(machine);
    assert_true(fabs(machine_clock(machine, result, sweep, 3) - 450.0) < 1e-12);
    whirl_case_free(machine);
    strcpy(result->case_text, "whirl: 1\n"); // no case
    assert_int_equal(WHIRL_OK, machine_of(result, &machine).code);
    assert_null(machine);
    assert_true(isnan(machine_clock(NULL, result, sweep, 3)));
    *sweep->parameter = '\0';
    assert_true(machine_clock(NULL, result, sweep, 3) == 650.0);
    whirl_result_free(result);
}

static void symbols_are_in_italics(void **state) {
    (void)state;
    static const struct {
        const char *name, *symbol, *markup;
    } rows[] = {{"r_k", "$r_{k}$", "{/:Italic r}_{k}"},
                {"k2", "$k_{2}$", "{/:Italic k}_{2}"},
                {"omega", "$\u03c9$", "{/:Italic \u03c9}"},
                {"r_delta", "$r_{\u03b4}$", "{/:Italic r}_{\u03b4}"},
                {"omega_n", "$\u03c9_{n}$", "{/:Italic \u03c9}_{n}"},
                {"load", "load", "load"},
                {"oil_film", "oil_film", "oil\\_film"},
                {"x2a", "x2a", "x2a"},
                {"a^{b}", "a^{b}", "a\\^\\{b\\}"}};
    char text[SYMBOL_SIZE];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        symbol_of(rows[i].name, text, sizeof text);
        assert_string_equal(text, rows[i].symbol);
        gnuplot_markup(rows[i].symbol, text, sizeof text);
        assert_string_equal(text, rows[i].markup);
    }
    gnuplot_markup("@&~\\_", text, 21);
    assert_string_equal(text, "\\@\\&\\~"); // never cut within an escape
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths),
        cmocka_unit_test(units_of_command_and_result),
        cmocka_unit_test(parameters),
        cmocka_unit_test(parameters_in_chosen_units),
        cmocka_unit_test(weight_in_chosen_units),
        cmocka_unit_test(points_have_scales),
        cmocka_unit_test(walls),
        cmocka_unit_test(speeds),
        cmocka_unit_test(symbols_are_in_italics),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
