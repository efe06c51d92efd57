// Movable texts of figures: none meets another text, the legend or an edge, seen by points within their boxes.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "figure_build.h"

static const double em = 0.9 * 6.5 * 2.54 / 72.0; // cm, a letter's height

/// Computes the point at given shares of a text's box, cm in its panel, as the explorer's renderer places texts.
static void point_of(const whirl_figure *figure, const whirl_panel *panel, const whirl_series *series, size_t k,
                     double along, double across, double point[2]) {
    const double wide = figure_text_width(figure, strlen(series->texts[k])), tall = 0.9 * em;
    const double width = (panel->right - panel->left) * figure->width;
    const double height = (panel->top - panel->bottom) * figure->height;
    static const double begins[] = {-0.5, -0.5, -1.0, 0.0, 0.0, 0.0}; // in widths of the text
    static const double gaps[] = {0.0, 0.0, -0.5, 0.5, 0.5, 0.5};
    static const double bottoms[] = {0.2, -1.2, 0.2, -1.2, -0.45, -0.45}; // in heights of a letter
    const double u = begins[series->side] * wide + gaps[series->side] * em + along * wide;
    double v = bottoms[series->side] * em + across * tall;
    const double angle = series->side == WHIRL_SLANTED ? 60.0 * acos(-1.0) / 180.0 : 0.0;
    // Texts on the left stand above their point.
    point[0] = width * (series->x[k] - panel->x.low) / (panel->x.high - panel->x.low) + u * cos(angle) - v * sin(angle);
    point[1] =
        height * (series->y[k] - panel->y.low) / (panel->y.high - panel->y.low) + u * sin(angle) + v * cos(angle);
}

/// Returns true if a point lies in the box of a text.
static bool is_in(const whirl_figure *figure, const whirl_panel *panel, const whirl_series *series, size_t k,
                  const double point[2]) {
    double o[2], a[2], b[2];
    point_of(figure, panel, series, k, 0.0, 0.0, o);
    point_of(figure, panel, series, k, 1.0, 0.0, a);
    point_of(figure, panel, series, k, 0.0, 1.0, b);
    const double la = hypot(a[0] - o[0], a[1] - o[1]), lb = hypot(b[0] - o[0], b[1] - o[1]);
    const double u = ((point[0] - o[0]) * (a[0] - o[0]) + (point[1] - o[1]) * (a[1] - o[1])) / la;
    const double v = ((point[0] - o[0]) * (b[0] - o[0]) + (point[1] - o[1]) * (b[1] - o[1])) / lb;
    return u > 0.0 && u < la && v > 0.0 && v < lb;
}

/// Fails where texts of a panel meet; gives how many there are.
static size_t texts_apart(const whirl_figure *figure, const whirl_panel *panel) {
    enum { STEPS = 12 };
    const double width = (panel->right - panel->left) * figure->width;
    const double height = (panel->top - panel->bottom) * figure->height;
    size_t texts = 0;
    for (size_t s = 0; s < panel->count; s++)
        for (size_t k = 0; panel->series[s]->shape == WHIRL_TEXTS && k < panel->series[s]->count; k++, texts++)
            for (int i = 0; i < STEPS * STEPS; i++) {
                double at[2];
                point_of(figure, panel, panel->series[s], k, (i % STEPS + 0.5) / STEPS, (i / STEPS + 0.5) / STEPS, at);
                assert_true(at[0] > 0.0 && at[0] < width && at[1] > 0.0 && at[1] < height);
                for (size_t t = 0; t < panel->count; t++)
                    for (size_t m = 0; panel->series[t]->shape == WHIRL_TEXTS && m < panel->series[t]->count; m++)
                        if (t != s || m != k) assert_false(is_in(figure, panel, panel->series[t], m, at));
            }
    return texts;
}

/// Makes a panel with `count` marks in the unit square, by a sequence that fills it evenly, and their numbers.
static whirl_figure *crowd(size_t count, bool movable) {
    whirl_figure *figure = calloc(1, sizeof *figure);
    assert_non_null(figure);
    figure->width = 8.5;
    figure->font = 6.5;
    whirl_panel *panel = figure_panel(figure, "crowd", 1.0, 4.0);
    axis_show(&panel->x, (span){0.0, 1.0});
    axis_show(&panel->y, (span){0.0, 1.0});
    whirl_series *marks = panel_series(figure, panel, WHIRL_DOTS, "#000000", 2.3);
    whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    texts->movable = movable;
    for (size_t k = 0; k < count; k++) {
        const double x = 0.05 + 0.9 * fmod(0.754877666 * (double)k, 1.0);
        const double y = 0.05 + 0.9 * fmod(0.569840291 * (double)k, 1.0);
        char text[16];
        snprintf(text, sizeof text, "%.5g", 1000.0 + 1.37 * (double)k);
        series_add(figure, marks, x, y);
        series_add_text(figure, texts, x, y, text);
    }
    figure_finish(figure, NULL);
    assert_false(figure->failed);
    return figure;
}

static void a_crowd_stands_apart(void **state) {
    (void)state;
    size_t before = 0;
    for (size_t count = 1; count <= 128; count *= 2) {
        whirl_figure *figure = crowd(count, true);
        const size_t texts = texts_apart(figure, figure->panels[0]);
        // A few have room, all of them; of more there are never fewer.
        assert_true(texts <= count && texts >= before && (count > 16 || texts == count));
        before = texts;
        whirl_figure_free(figure);
    }
    assert_true(before >= 24); // 5 letters, 0.57 cm by 0.24 cm, in 7.2 cm by 4 cm: 200 at the very most
}

static void texts_that_fit_stay(void **state) {
    (void)state;
    whirl_figure *moved = crowd(2, true), *fixed = crowd(2, false);
    const whirl_panel *one = moved->panels[0], *other = fixed->panels[0];
    assert_true(one->count == 2 && other->count == 2);
    for (size_t k = 0; k < 2; k++) assert_true(one->series[1]->x[k] == other->series[1]->x[k]);
    assert_int_equal(one->series[1]->side, WHIRL_ABOVE);
    whirl_figure_free(moved);
    whirl_figure_free(fixed);
}

/// A text at an edge (0: right, 1: top) is placed on one of the sides that have room.
static void texts_at_edges_stand_inside(void **state) {
    (void)state;
    for (int edge = 0; edge < 2; edge++) {
        whirl_figure *figure = calloc(1, sizeof *figure);
        assert_non_null(figure);
        figure->width = 8.5;
        figure->font = 6.5;
        whirl_panel *panel = figure_panel(figure, "p", 1.0, 4.0);
        axis_show(&panel->x, (span){0.0, 1.0});
        axis_show(&panel->y, (span){0.0, 1.0});
        whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
        texts->movable = true;
        series_add_text(figure, texts, edge ? 0.5 : 1.0, edge ? 1.0 : 0.5, "12345");
        figure_finish(figure, NULL);
        assert_int_equal(texts_apart(figure, panel), 1);
        assert_true(panel->series[0]->count == 0 && panel->series[1]->count == 1);
        assert_int_equal(panel->series[1]->side, edge ? WHIRL_BELOW : WHIRL_LEFT);
        whirl_figure_free(figure);
    }
}

static void legends_and_fixed_texts_are_kept_clear(void **state) {
    (void)state;
    whirl_figure *figure = calloc(1, sizeof *figure);
    assert_non_null(figure);
    figure->width = 8.5;
    figure->font = 6.5;
    whirl_panel *panel = figure_panel(figure, "p", 1.0, 4.0);
    panel->keyed = true;
    axis_show(&panel->x, (span){0.0, 1.0});
    axis_show(&panel->y, (span){0.0, 1.0});
    panel_named(figure, panel, WHIRL_LINE, "a line of the legend", "#000000", 0.8);
    whirl_series *fixed = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    texts->movable = true;
    series_add_text(figure, fixed, 0.5, 0.5, "fixed");
    series_add_text(figure, texts, 0.51, 0.51, "moves");
    series_add_text(figure, texts, 0.9, 0.9, "moves");
    figure_finish(figure, NULL);
    assert_int_equal(texts_apart(figure, panel), 3);
    // Below the legend's one line, 0.3 cm.
    for (size_t s = 0; s < panel->count; s++)
        for (size_t k = 0; panel->series[s]->shape == WHIRL_TEXTS && k < panel->series[s]->count; k++)
            for (int i = 0; i < 4; i++) {
                double at[2];
                point_of(figure, panel, panel->series[s], k, i % 2, i / 2, at);
                assert_true(at[1] < 4.0 - 0.29);
            }
    whirl_figure_free(figure);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_crowd_stands_apart), cmocka_unit_test(texts_that_fit_stay),
                                       cmocka_unit_test(texts_at_edges_stand_inside),
                                       cmocka_unit_test(legends_and_fixed_texts_are_kept_clear)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
