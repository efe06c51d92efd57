// Blocks of data that scripts for gnuplot name by their index: of series with breaks, and of such with nothing else.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "figure_build.h"
#include "gnuplot_script.h"

/// Returns the number of the block from which the script plots the n-th series.
static long index_of(const char *script, size_t n) {
    const char *at = script;
    for (size_t k = 0; at && k <= n; k++) at = strstr(at + (k > 0), "data index ");
    return at ? strtol(at + strlen("data index "), NULL, 10) : -1;
}

/// Returns the first number of a block. As in gnuplot two empty lines or more end a block, and a block without numbers
/// does not count.
static double first_of(const char *data, long block) {
    long found = -1, empty = 2;
    for (const char *line = data; *line; line += strcspn(line, "\n") + 1) {
        if (*line == '\n') empty++;
        if (*line == '\n' || *line == '#') continue;
        if (empty >= 2 && ++found == block) return strtod(line, NULL);
        empty = 0;
    }
    return NAN;
}

static void breaks_move_no_block(void **state) {
    static const double all[][6] = {{NAN, NAN, NAN, NAN, NAN, NAN},
                                    {1.0, NAN, NAN, NAN, 1.5, NAN},
                                    {NAN, NAN, 2.0, 2.5, NAN, NAN},
                                    {3.0, 3.1, 3.2, 3.3, 3.4, 3.5}};
    (void)state;
    for (int shape = 0; shape < 2; shape++) {
        whirl_figure *figure = calloc(1, sizeof *figure);
        assert_non_null(figure);
        figure->width = 12.0;
        figure->font = 7.0;
        whirl_panel *panel = figure_panel(figure, "x", 1.0, 4.0);
        for (size_t s = 0; s < 4; s++) {
            whirl_series *series = panel_series(figure, panel, shape ? WHIRL_AREA : WHIRL_LINE, "#000000", 1.0);
            for (size_t k = 0; k < 6; k++)
                shape ? series_add_to(figure, series, all[s][k], 1.0, 2.0) : series_add(figure, series, all[s][k], 1.0);
        }
        figure_finish(figure, NULL);
        char *data = NULL, *script = NULL;
        size_t sizes[2];
        FILE *streams[] = {open_memstream(&data, &sizes[0]), open_memstream(&script, &sizes[1])};
        gnuplot_write_data(streams[0], figure);
        gnuplot_write_script(streams[1], figure, "figure", "figure.dat", "png");
        for (int i = 0; i < 2; i++) assert_int_equal(fclose(streams[i]), 0);
        // The first series has nothing to draw; each of the others begins with its own number.
        for (size_t s = 1; s < 4; s++) assert_true(first_of(data, index_of(script, s - 1)) == (double)s);
        assert_int_equal(index_of(script, 3), -1);
        assert_true(isnan(first_of(data, 3)));
        free(data);
        free(script);
        whirl_figure_free(figure);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(breaks_move_no_block)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
