// Axes of figures whose numbers are infinite, not numbers, or as large as numbers can be: they have finite ends and
// ticks.
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "figure_build.h"

static void expect_finite(const whirl_axis *axis) {
    assert_true(isfinite(axis->low) && isfinite(axis->high) && axis->low < axis->high);
    assert_true(axis->tick_count <= 60);
    for (size_t i = 0; i < axis->tick_count; i++) assert_true(isfinite(axis->ticks[i]));
}

/// Finishes a figure of one panel with two points, with given or missing axes.
static void finish(double first, double second, bool said, const char *log) {
    whirl_figure *figure = calloc(1, sizeof *figure);
    assert_non_null(figure);
    figure->width = 12.0;
    figure->font = 7.0;
    whirl_panel *panel = figure_panel(figure, "x", 1.0, 4.0);
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#000000", 1.0);
    series_add(figure, line, first, second);
    series_add(figure, line, second, first);
    series_add(figure, line, 2.0, 3.0);
    if (said) {
        axis_show(&panel->x, (span){first, second});
        panel->y.low = first;
        panel->y.high = second;
        panel->y.logarithmic = log != NULL;
    }
    snprintf(figure->scale.label, sizeof figure->scale.label, "numbers");
    figure->scale.low = first;
    figure->scale.high = second;
    figure_finish(figure, log);
    expect_finite(&panel->x);
    expect_finite(&panel->y);
    for (size_t i = 0; i < figure->scale.tick_count; i++) assert_true(isfinite(figure->scale.ticks[i]));
    whirl_figure_free(figure);
}

static void ends_are_finite(void **state) {
    const double values[] = {-INFINITY, -DBL_MAX, -1.0, 0.0, DBL_TRUE_MIN, 1e-300, 1.0, 1e300, DBL_MAX, INFINITY, NAN};
    enum { VALUES = sizeof values / sizeof *values };
    static const char *const logs[] = {NULL, "x", "xy"};
    (void)state;
    for (size_t i = 0; i < VALUES; i++)
        for (size_t k = 0; k < VALUES; k++)
            for (int said = 0; said < 2; said++)
                for (size_t log = 0; log < 3; log++) finish(values[i], values[k], said, logs[log]);
}

/// Axes are those of the finite numbers; infinite ones are left out.
static void finite_numbers_are_shown(void **state) {
    (void)state;
    whirl_axis axis = {.low = 0.0};
    axis_show(&axis, (span){1.0, INFINITY});
    assert_true(isnan(axis.low) && isnan(axis.high));
    axis_show(&axis, (span){1.0, 4.0});
    assert_true(axis.low == 1.0 && axis.high == 4.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends_are_finite), cmocka_unit_test(finite_numbers_are_shown)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
