// Squares that are divided where labels differ, on a plane whose labels are known at every point.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "squares.h"

/// Labels over a plane, and the points that squares have requested so far.
typedef struct field {
    squares plane;
    int *labels;
    unsigned char *known, *asked;
    double *widths;
    size_t count, rounds;
} field;

static bool differ(const void *context, size_t a, size_t b) {
    const field *f = context;
    return f->labels[a] < 0 || f->labels[a] != f->labels[b];
}

/// Returns the label at a place: a disc and a thin slanting tongue that reaches into it, both in units of the plane's
/// width; points on a small spot are in doubt.
static int label_at(double x, double y) {
    if (hypot(x - 0.8, y - 0.2) < 0.02) return -1;
    if (fabs(y - 0.15 - 0.6 * x) < 0.006 && x < 0.7) return 2;
    return hypot(x - 0.4, y - 0.55) < 0.3 ? 1 : 0;
}

static void make(field *f, size_t columns, size_t rows, size_t width) {
    const size_t count = columns * rows;
    *f = (field){.plane = {.columns = columns, .rows = rows, .width = width, .differ = differ, .context = f},
                 .labels = calloc(count, sizeof(int)),
                 .known = calloc(count, 1),
                 .asked = calloc(count, 1),
                 .widths = calloc(count, sizeof(double)),
                 .count = count};
    assert_true(f->labels && f->known && f->asked && f->widths);
    f->plane.known = f->known;
    const double size = (double)(columns > rows ? columns : rows) - 1.0;
    for (size_t i = 0; i < count; i++)
        f->labels[i] = label_at((double)(i % columns) / size, (double)(i / columns) / size);
}

static void destroy(field *f) {
    free(f->labels);
    free(f->known);
    free(f->asked);
    free(f->widths);
}

/// Refines the first squares of one of `shares` shares (from 0): makes the points known that they request, until they
/// request no new one.
static void refine(field *f, size_t share, size_t shares) {
    f->plane.alone = shares > 1;
    for (bool more = true; more; f->rounds++) {
        for (size_t i = share; i < squares_count(&f->plane); i += shares)
            assert_true(squares_ask(&f->plane, i, f->asked));
        more = memcmp(f->asked, f->known, f->count) != 0;
        memcpy(f->known, f->asked, f->count);
    }
    for (size_t i = share; i < squares_count(&f->plane); i += shares)
        assert_true(squares_widths(&f->plane, i, f->widths));
}

static size_t asked(const field *f) {
    size_t count = 0;
    for (size_t i = 0; i < f->count; i++) count += f->asked[i];
    return count;
}

/// Labels every point: with its own label if it was requested, else with that of its undivided square.
static void paint(const field *f, int *painted) {
    const size_t columns = f->plane.columns, rows = f->plane.rows;
    for (size_t i = 0; i < f->count; i++) painted[i] = 99;
    for (size_t i = 0; i < f->count; i++) {
        const size_t w = (size_t)f->widths[i];
        for (size_t y = i / columns; y < rows && (y < i / columns + w || (y + 1 == rows && y == i / columns + w)); y++)
            for (size_t x = i % columns;
                 x < columns && (x < i % columns + w || (x + 1 == columns && x == i % columns + w)); x++)
                painted[y * columns + x] = f->labels[i];
    }
    for (size_t i = 0; i < f->count; i++)
        if (f->asked[i]) painted[i] = f->labels[i];
}

static bool is_on_a_boundary(const field *f, size_t i) {
    const size_t columns = f->plane.columns, x = i % columns, y = i / columns;
    return (x > 0 && f->labels[i - 1] != f->labels[i]) || (x + 1 < columns && f->labels[i + 1] != f->labels[i]) ||
           (y > 0 && f->labels[i - columns] != f->labels[i]) ||
           (y + 1 < f->plane.rows && f->labels[i + columns] != f->labels[i]);
}

// ---------------------------------------------------------------- tests

/// A disc, and a tongue that is thinner than all but the smallest squares: every point on a boundary is computed, every
/// other point gets its right label, and the number of computed points is in proportion to the boundary.
static void boundaries_are_known_to_the_finest_width(void **state) {
    field f;
    (void)state;
    make(&f, 257, 257, 16);
    refine(&f, 0, 1);
    int *painted = calloc(f.count, sizeof *painted);
    paint(&f, painted);
    size_t boundary = 0;
    for (size_t i = 0; i < f.count; i++) {
        assert_int_equal(painted[i], f.labels[i]);
        if (!is_on_a_boundary(&f, i)) continue;
        assert_true(f.asked[i]);
        boundary++;
    }
    // The bound is measured: the corners of first squares, and four points for each point on a boundary. (At worst a
    // point on a boundary would need 4 squares of each of 4 widths, with 9 points each.)
    const size_t first = 17 * 17;
    assert_true(boundary > 1000 && asked(&f) > boundary);
    assert_true(asked(&f) < first + 4 * boundary);
    assert_true(asked(&f) * 5 < f.count);
    free(painted);
    destroy(&f);
}

/// Brute force: the four corners of every undivided square are computed and have equal labels, none of them in doubt.
static void squares_that_are_left_agree(void **state) {
    field f;
    (void)state;
    make(&f, 129, 65, 32);
    refine(&f, 0, 1);
    for (size_t i = 0; i < f.count; i++) {
        const size_t w = (size_t)f.widths[i], x = i % 129, y = i / 129;
        if (w < 2) continue;
        const size_t right = x + w < 129 ? x + w : 128, top = y + w < 65 ? y + w : 64;
        const size_t corners[] = {i, y * 129 + right, top * 129 + x, top * 129 + right};
        for (size_t c = 0; c < 4; c++) {
            assert_true(f.asked[corners[c]]);
            assert_true(f.labels[corners[c]] >= 0 && f.labels[corners[c]] == f.labels[i]);
        }
    }
    destroy(&f);
}

/// Every point of the plane is computed or lies in an undivided square: also if the last squares are smaller, in planes
/// of one row or column, and with one square that is larger than the plane.
static void squares_make_the_plane(void **state) {
    static const size_t sizes[][3] = {{100, 71, 16}, {18, 17, 16}, {40, 1, 8}, {1, 40, 8},
                                      {7, 5, 64},    {1, 1, 4},    {2, 2, 2}};
    (void)state;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        field f;
        make(&f, sizes[s][0], sizes[s][1], sizes[s][2]);
        refine(&f, 0, 1);
        int *painted = calloc(f.count, sizeof *painted);
        paint(&f, painted);
        for (size_t i = 0; i < f.count; i++) {
            assert_int_not_equal(painted[i], 99);
            if (squares_is_corner(&f.plane, i)) assert_true(f.asked[i]);
        }
        free(painted);
        destroy(&f);
    }
}

/// First squares that are `alone` request points of their own, whichever points other shares made known. The points of
/// all shares are a subset of those of a joint refinement. A joint refinement that starts from them ends with the same
/// points and widths.
static void shares_make_the_whole(void **state) {
    field whole, alone;
    (void)state;
    make(&whole, 200, 141, 16);
    refine(&whole, 0, 1);
    make(&alone, 200, 141, 16);
    for (size_t k = 0; k < 3; k++) refine(&alone, k, 3);
    assert_true(asked(&alone) < asked(&whole));
    unsigned char *together = calloc(whole.count, 1);
    for (size_t share = 0; share < 3; share++) {
        field part;
        make(&part, 200, 141, 16);
        refine(&part, share, 3);
        for (size_t i = 0; i < part.count; i++) {
            bool own = false;
            for (size_t k = share; k < squares_count(&part.plane); k += 3) own = own || squares_has(&part.plane, k, i);
            assert_true(!part.asked[i] || own);
            together[i] |= part.asked[i];
            assert_true(!part.asked[i] || whole.asked[i]);
        }
        destroy(&part);
    }
    assert_memory_equal(together, alone.asked, whole.count);
    refine(&alone, 0, 1);
    assert_memory_equal(alone.asked, whole.asked, whole.count);
    assert_memory_equal(alone.widths, whole.widths, whole.count * sizeof(double));
    free(together);
    destroy(&whole);
    destroy(&alone);
}

/// The order in which points become known does not matter: in g a few become known at a time, the last ones first.
static void the_order_does_not_matter(void **state) {
    field f, g;
    (void)state;
    make(&f, 129, 129, 32);
    make(&g, 129, 129, 32);
    refine(&f, 0, 1);
    for (bool more = true; more;) {
        for (size_t i = 0; i < squares_count(&g.plane); i++) assert_true(squares_ask(&g.plane, i, g.asked));
        more = false;
        for (size_t i = g.count, few = 40; i-- > 0 && few > 0;) {
            if (!g.asked[i] || g.known[i]) continue;
            g.known[i] = 1;
            more = true;
            few--;
        }
    }
    assert_memory_equal(f.asked, g.asked, f.count);
    destroy(&f);
    destroy(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boundaries_are_known_to_the_finest_width),
        cmocka_unit_test(squares_that_are_left_agree),
        cmocka_unit_test(squares_make_the_plane),
        cmocka_unit_test(shares_make_the_whole),
        cmocka_unit_test(the_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
