// Several starts of every point: how they are spread, how their motions are assigned to attractors, and how attractors
// continue from point to point; on tables that are made up.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/study.h"

// ---------------------------------------------------------------- the sequence

/// Van der Corput's numbers in bases 2 and 3, as Halton (1960) gives them.
static void halton_is_as_published(void **state) {
    static const double two[] = {0.0, 1.0 / 2, 1.0 / 4, 3.0 / 4, 1.0 / 8, 5.0 / 8, 3.0 / 8, 7.0 / 8, 1.0 / 16};
    static const double three[] = {0.0,     1.0 / 3, 2.0 / 3, 1.0 / 9, 4.0 / 9,
                                   7.0 / 9, 2.0 / 9, 5.0 / 9, 8.0 / 9, 1.0 / 27};
    (void)state;
    for (size_t i = 0; i < sizeof two / sizeof *two; i++) assert_true(whirl_halton(i, 0) == two[i]);
    for (size_t i = 0; i < sizeof three / sizeof *three; i++) assert_true(fabs(whirl_halton(i, 1) - three[i]) < 1e-15);
}

/// The sequence of Halton is even: of 2^3 x 3^2 successive points every box of an eighth by a ninth has one.
static void halton_fills_boxes(void **state) {
    int boxes[8][9] = {{0}};
    (void)state;
    for (size_t i = 1; i <= 72; i++) boxes[(int)(8.0 * whirl_halton(i, 0))][(int)(9.0 * whirl_halton(i, 1) + 1e-9)]++;
    for (int a = 0; a < 8; a++)
        for (int b = 0; b < 9; b++) assert_int_equal(1, boxes[a][b]);
}

/// The bases are the primes: number p - 1 of coordinate p is (p - 1)/p, the one after it 1/p^2.
static void coordinates_have_primes(void **state) {
    size_t coordinate = 0;
    (void)state;
    for (size_t n = 2; coordinate < WHIRL_MAX_RANGES; n++) {
        bool prime = true;
        for (size_t k = 2; k * k <= n; k++) prime = prime && n % k != 0;
        if (!prime) continue;
        assert_true(fabs(whirl_halton(n - 1, coordinate) - (double)(n - 1) / (double)n) < 1e-15);
        assert_true(fabs(whirl_halton(n, coordinate) - 1.0 / (double)(n * n)) < 1e-15);
        coordinate++;
    }
}

// ---------------------------------------------------------------- tables

enum { ROWS = 8 };

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 1, .vx = 2, .vy = 3};

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing, (void)x;
    for (int i = 0; i < 4; i++) dxdt[i] = 0.0;
}

/// Makes a table of `places` places with `starts` starts each, all undetermined.
static whirl_table make(size_t places, size_t starts, size_t row) {
    const whirl_system system = {.dimension = 4, .period = 1.0, .rhs = slope, .probe_count = 1, .probes = &probe};
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    whirl_table table = {.name = "sweep", .parameter = "p", .row = row, .starts = starts, .count = places * starts};
    table.integrate = whirl_integrate_default();
    table.record = whirl_record_default();
    table.record.record = ROWS;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&table.analyses, analyses[i]));
    const whirl_status status =
        whirl_layout_new(&system, &table.integrate, &table.record, table.analyses, &table.layout);
    assert_int_equal(WHIRL_OK, status.code);
    table.values = calloc(table.count, sizeof *table.values);
    table.branch = calloc(table.count, sizeof *table.branch);
    table.blocks = calloc(table.count * table.layout.size, sizeof *table.blocks);
    assert_true(table.values && table.branch && table.blocks);
    for (size_t i = 0; i < table.count; i++) table.values[i] = (double)(i % places);
    return table;
}

static void drop(whirl_table *table) {
    free(table->slots);
    free(table->values);
    free(table->branch);
    free(table->blocks);
}

static double *field(const whirl_table *table, size_t point, const char *name) {
    const whirl_field *found = whirl_layout_field(&table->layout, name);
    assert_non_null(found);
    return table->blocks + point * table->layout.size + found->offset;
}

/// Sets a motion of that regime about (x, 0), up to `reach` to every side.
static void go_about(const whirl_table *table, size_t point, whirl_regime regime, double x, double reach) {
    *field(table, point, "regime/code") = regime;
    double *mean = field(table, point, "orbit/mean"), *low = field(table, point, "orbit/low");
    double *high = field(table, point, "orbit/high");
    mean[0] = x;
    mean[1] = 0.0;
    for (int i = 0; i < 2; i++) {
        low[i] = mean[i] - reach;
        high[i] = mean[i] + reach;
    }
}

/// Sets an orbit of k revolutions whose section is at x, x + gap, ..., and begins `skip` revolutions later.
static void orbit(const whirl_table *table, size_t point, int k, double x, double gap, int skip) {
    go_about(table, point, WHIRL_PERIODIC, x, 2.0);
    *field(table, point, "regime/period") = k;
    double *section = field(table, point, "poincare/section");
    for (int row = 0; row < ROWS; row++) section[4 * row] = x + gap * ((row + skip) % k);
}

static whirl_coexistence tell(const whirl_table *table) {
    whirl_coexistence found;
    const whirl_status status = whirl_table_coexistence(table, &found);
    assert_int_equal(WHIRL_OK, status.code);
    return found;
}

// ---------------------------------------------------------------- one place

/// An orbit of two revolutions in both phases is one attractor. Chaotic motions whose records differ somewhat are one,
/// chaos elsewhere is another one. A motion without a verdict has no attractor but counts as a start.
static void attractors_of_a_point_are_distinguished(void **state) {
    static const size_t labels[] = {1, 2, 1, 0, 3, 2, 1, 4};
    static const size_t counts[] = {3, 2, 1, 1};
    whirl_table table = make(1, 8, 0);
    (void)state;
    orbit(&table, 0, 2, 1.0, 0.1, 0);
    go_about(&table, 1, WHIRL_CHAOTIC, 0.0, 2.0);
    orbit(&table, 2, 2, 1.0, 0.1, 1);
    orbit(&table, 4, 1, 1.0, 0.0, 0);
    go_about(&table, 5, WHIRL_CHAOTIC, 0.1, 2.1);
    orbit(&table, 6, 2, 1.0005, 0.1, 0);
    go_about(&table, 7, WHIRL_CHAOTIC, 5.0, 2.0);
    whirl_coexistence found = tell(&table);
    assert_int_equal(1, found.places);
    assert_int_equal(4, found.attractors);
    assert_int_equal(4, found.count);
    for (size_t i = 0; i < 8; i++) assert_int_equal(labels[i], found.labels[i]);
    for (size_t k = 0; k < 4; k++) {
        const double share = (double)counts[k] / 8.0;
        assert_int_equal(counts[k], found.items[k].starts);
        assert_int_equal(8, found.items[k].of);
        assert_int_equal(4, found.items[k].coexisting);
        assert_true(found.items[k].share == share);
        assert_true(fabs(found.items[k].error - sqrt(share * (1.0 - share) / 8.0)) < 1e-15);
    }
    assert_null(whirl_coexistence_at(&found, &table, 3));
    assert_ptr_equal(&found.items[1], whirl_coexistence_at(&found, &table, 5));
    whirl_coexistence_free(&found);
    drop(&table);
}

/// An orbit of 2 revolutions that is reported as one of 4, with the same section, is the same attractor; one of 3 is
/// another.
static void multiples_of_an_orbit_are_the_same(void **state) {
    static const size_t labels[] = {1, 1, 2, 3};
    whirl_table table = make(1, 4, 0);
    (void)state;
    orbit(&table, 0, 2, 1.0, 0.1, 0);
    orbit(&table, 1, 2, 1.0, 0.1, 1);
    *field(&table, 1, "regime/period") = 4.0;
    orbit(&table, 2, 4, 1.0, 0.1, 0);
    orbit(&table, 3, 3, 1.0, 0.1, 0);
    whirl_coexistence found = tell(&table);
    for (size_t i = 0; i < 4; i++) assert_int_equal(labels[i], found.labels[i]);
    whirl_coexistence_free(&found);
    drop(&table);
}

// ---------------------------------------------------------------- along a sweep

enum { PLACES = 6 };

static size_t label(const whirl_coexistence *found, size_t start, size_t place) {
    return found->labels[start * PLACES + place];
}

/// One attractor drifts and doubles its period twice. A second one coexists with it for a while. At place 3 nothing is
/// known, and after it the motion is somewhere else.
static void attractors_go_on_along_a_sweep(void **state) {
    whirl_table table = make(PLACES, 2, 0);
    (void)state;
    for (size_t start = 0; start < 2; start++) {
        const size_t at = start * PLACES;
        orbit(&table, at + 0, 1, 1.0, 0.0, 0);
        orbit(&table, at + 4, 4, 1.4, 0.1, 0);
        orbit(&table, at + 5, 1, 9.0, 0.0, 0);
    }
    orbit(&table, 1, 1, 1.2, 0.0, 0);
    orbit(&table, 2, 2, 1.3, 0.2, 0);
    orbit(&table, PLACES + 1, 1, -1.5, 0.0, 0);
    orbit(&table, PLACES + 2, 1, -1.4, 0.0, 0);
    whirl_coexistence found = tell(&table);
    assert_int_equal(3, found.attractors);
    assert_int_equal(7, found.count);
    for (size_t place = 0; place < 5; place++) assert_int_equal(place == 3 ? 0 : 1, label(&found, 0, place));
    assert_int_equal(1, label(&found, 1, 0));
    // As many starts lead to the two others in all: the one that comes first has the smaller number.
    assert_int_equal(2, label(&found, 1, 1));
    assert_int_equal(2, label(&found, 1, 2));
    assert_int_equal(3, label(&found, 0, 5));
    assert_int_equal(3, label(&found, 1, 5));
    assert_int_equal(2, whirl_coexistence_at(&found, &table, 1)->coexisting);
    whirl_coexistence_free(&found);
    drop(&table);
}

/// An attractor continues to the nearer of two candidates; one at half of the motion's extent, 4 here, is too far.
static void the_nearest_goes_on(void **state) {
    whirl_table table = make(3, 2, 0);
    (void)state;
    orbit(&table, 0, 1, 0.0, 0.0, 0);
    orbit(&table, 3, 1, 0.0, 0.0, 0);
    orbit(&table, 1, 1, 0.9, 0.0, 0);
    orbit(&table, 4, 1, -1.0, 0.0, 0);
    orbit(&table, 2, 1, 2.95, 0.0, 0);
    orbit(&table, 5, 1, -2.95, 0.0, 0);
    whirl_coexistence found = tell(&table);
    assert_int_equal(found.labels[0], found.labels[1]);
    assert_int_not_equal(found.labels[0], found.labels[4]);
    assert_int_not_equal(found.labels[1], found.labels[2]);
    assert_int_equal(found.labels[4], found.labels[5]);
    assert_int_equal(3, found.attractors);
    whirl_coexistence_free(&found);
    drop(&table);
}

/// A period may be multiplied, and motions may become periodic; an orbit of 2 revolutions does not become one of 3.
static void periods_are_multiplied(void **state) {
    static const struct {
        int one, other;
        size_t attractors;
    } cases[] = {{2, 3, 2}, {2, 4, 1}, {3, 1, 1}, {4, 6, 2}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        whirl_table table = make(2, 1, 0);
        orbit(&table, 0, cases[i].one, 0.0, 0.1, 0);
        orbit(&table, 1, cases[i].other, 0.0, 0.1, 0);
        whirl_coexistence found = tell(&table);
        assert_int_equal(cases[i].attractors, found.attractors);
        whirl_coexistence_free(&found);
        go_about(&table, 1, WHIRL_QUASI_PERIODIC, 0.0, 2.0);
        found = tell(&table);
        assert_int_equal(1, found.attractors);
        whirl_coexistence_free(&found);
        drop(&table);
    }
}

/// Missing points, as in the file of a stopped run, leave the others at their places.
static void partial_tables_have_their_places(void **state) {
    static const size_t slots[] = {0, 2, 4, 5, 7};
    whirl_table table = make(5, 1, 0);
    (void)state;
    table.starts = 2;
    table.planned = 8;
    table.slots = calloc(5, sizeof *table.slots);
    assert_non_null(table.slots);
    memcpy(table.slots, slots, sizeof slots);
    for (size_t i = 0; i < 5; i++) orbit(&table, i, 1, slots[i] == 7 ? 1.5 : 0.0, 0.0, 0);
    whirl_coexistence found = tell(&table);
    assert_int_equal(4, found.places);
    assert_int_equal(4, found.count);
    assert_int_equal(0, whirl_table_place(&table, 2));
    assert_int_equal(2, whirl_coexistence_at(&found, &table, 0)->of);
    assert_int_equal(1, whirl_coexistence_at(&found, &table, 1)->of);
    assert_true(whirl_coexistence_at(&found, &table, 2)->share == 1.0);
    whirl_coexistence_free(&found);
    drop(&table);
}

// ---------------------------------------------------------------- maps

/// Round a cusp one attractor of a place becomes the other one of the same place: they keep two numbers all the same.
static void two_of_a_place_have_two_numbers(void **state) {
    whirl_table table = make(4, 2, 2);
    static const double around[] = {0.0, 0.25, 0.75, 0.5};
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        orbit(&table, i, 1, around[i], 0.0, 0);
        orbit(&table, 4 + i, 1, i == 0 ? 1.0 : around[i], 0.0, 0);
    }
    whirl_coexistence found = tell(&table);
    assert_int_equal(5, found.count);
    assert_int_equal(2, found.attractors);
    assert_int_not_equal(found.labels[0], found.labels[4]);
    whirl_coexistence_free(&found);
    drop(&table);
}

/// A column of a map is followed across its rows, and the end of a row is no neighbour of the beginning of the next.
static void maps_are_followed_along_both_axes(void **state) {
    whirl_table table = make(6, 2, 3);
    static const double x[] = {0.0, 5.0, 10.0, 0.2, 5.2, 10.2};
    (void)state;
    for (size_t start = 0; start < 2; start++)
        for (size_t i = 0; i < 6; i++) orbit(&table, start * 6 + i, 1, x[i], 0.0, 0);
    orbit(&table, 2, 1, 0.1, 0.0, 0); // as at the beginning of the next row
    whirl_coexistence found = tell(&table);
    assert_int_equal(4, found.attractors);
    for (size_t i = 0; i < 3; i++) assert_int_equal(found.labels[6 + i], found.labels[9 + i]);
    assert_int_not_equal(found.labels[2], found.labels[3]);
    whirl_coexistence_free(&found);
    drop(&table);
}

// ---------------------------------------------------------------- views

/// A view has every attractor once at every place, in the order of their numbers; of a map one at every place. A view
/// of a view has the same points, and lives and ends by itself.
static void views_have_attractors_once(void **state) {
    (void)state;
    for (size_t row = 0; row <= PLACES; row += PLACES) {
        whirl_table table = make(PLACES, 3, row);
        const whirl_result result = {.table_count = 1, .tables = &table};
        whirl_result *view, *again;
        size_t done, total;
        for (size_t i = 0; i < table.count; i++) orbit(&table, i, 1, i < PLACES ? -1.0 : 1.0, 0.0, 0);
        assert_int_equal(WHIRL_OK, whirl_result_by_attractor(&result, &view).code);
        assert_int_equal(WHIRL_OK, whirl_result_by_attractor(view, &again).code);
        const whirl_table *shown = &view->tables[0], *twice = &again->tables[0];
        assert_int_equal(shown->count, twice->count);
        assert_memory_equal(shown->chosen, twice->chosen, shown->count * sizeof *shown->chosen);
        assert_memory_equal(shown->branch, twice->branch, shown->count * sizeof *shown->branch);
        assert_true(shown->chosen != twice->chosen && shown->attractors != twice->attractors);
        whirl_result_view_free(again);
        assert_int_equal(row ? PLACES : 2 * PLACES, shown->count);
        assert_int_equal(PLACES, whirl_table_places(shown));
        for (size_t i = 0; i < shown->count; i++) {
            assert_int_equal(i % PLACES, whirl_table_place(shown, i));
            assert_true(shown->values[i] == (double)(i % PLACES));
            assert_int_equal(i < PLACES ? 1 : 2, shown->attractors[i].number);
            assert_int_equal(i < PLACES ? 2 : 1, shown->attractors[i].starts);
            assert_int_equal(row ? 0 : shown->attractors[i].number, shown->branch[i]);
            assert_true(whirl_table_field(shown, i, "poincare/section", 0)[0] == (i < PLACES ? 1.0 : -1.0));
        }
        assert_false(whirl_result_partial(view, &done, &total));
        assert_int_equal(table.count, total);
        whirl_result_view_free(view);
        drop(&table);
    }
}

/// All n starts miss an attractor to which a share p of starts leads with the probability (1 - p)^n.
static void missed_shares(void **state) {
    (void)state;
    for (size_t n = 1; n < 100; n += 7) assert_true(fabs(pow(1.0 - whirl_missed_share(n), (double)n) - 0.05) < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(halton_is_as_published),
        cmocka_unit_test(halton_fills_boxes),
        cmocka_unit_test(coordinates_have_primes),
        cmocka_unit_test(attractors_of_a_point_are_distinguished),
        cmocka_unit_test(multiples_of_an_orbit_are_the_same),
        cmocka_unit_test(attractors_go_on_along_a_sweep),
        cmocka_unit_test(the_nearest_goes_on),
        cmocka_unit_test(periods_are_multiplied),
        cmocka_unit_test(partial_tables_have_their_places),
        cmocka_unit_test(two_of_a_place_have_two_numbers),
        cmocka_unit_test(maps_are_followed_along_both_axes),
        cmocka_unit_test(views_have_attractors_once),
        cmocka_unit_test(missed_shares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
