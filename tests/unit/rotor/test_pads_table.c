// The tables of pads, compared with the films themselves at random places, and how smooth they are.
#include <dirent.h>
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "elements/films/pads_look_up.h"
#include "pad_table_file.h"

static const double pi = 3.14159265358979323846;

enum { PLACES = 500, ROUND = 6 };

/// Returns numbers from 0 to 1, the same every time (Park and Miller 1988).
static double next(void) {
    static uint64_t seed = 1;
    seed = seed * 16807 % 2147483647;
    return (double)seed / 2147483647.0;
}

/// Looks S up in the table.
static void table_force(double table, double t, double w, double half, double force[2]) {
    pads_entry entry;
    pads_enter(table, t, w, half, false, &entry);
    pads_read(&entry, force);
}

/// Looks the force at a place up in the table.
static void look(double table, const pad_place *at, double arc, double force[2]) {
    const double cosine = cos(0.5 * arc), thickness = 1.0 - at->x;
    const double most = at->x < cosine ? (1.0 - cosine * at->x) / sin(0.5 * arc) : sqrt(1.0 - at->x * at->x);
    const double v = at->y / most, w = v / (1.0 + sqrt(1.0 - v * v));
    vec V, half, over;
    pads_polar(at->a, at->b, &V, &half, &over);
    table_force(table, sqrt(thickness), w, half, force);
    for (int n = 0; n < 2; n++) force[n] *= V / ((1.0 - v * v) * thickness * thickness);
}

static int rising(const void *one, const void *other) {
    const double a = *(const double *)one, b = *(const double *)other;
    return a < b ? -1 : a > b;
}

/// Computes errors over the largest force, in any direction, of a pad at a place where its journal may be.
static void errors(const pad_film *film, double preload, double tilt, double found[PLACES]) {
    const pad_table_key key = {.arc = film->arc, .ratio = film->ratio, .law = film->law};
    pad_workspace *work;
    double table;
    assert_int_equal(pad_table_number(&key, &table).code, WHIRL_OK);
    assert_int_equal(pad_table_hold(table, NULL).code, WHIRL_OK);
    assert_int_equal(pad_workspace_new(film->around, film->along, &work).code, WHIRL_OK);
    for (int n = 0; n < PLACES;) {
        const double r = 0.95 * (1.0 - preload) * sqrt(next()), angle = 2.0 * pi * next(), alpha = 2.0 * pi * next();
        pad_place at = {r * cos(angle) + preload, r * sin(angle) - tilt * (2.0 * next() - 1.0), cos(alpha), sin(alpha)};
        pad_answer answer;
        double largest = 0.0, force[2];
        if (pad_solve(work, film, &at, &answer).code != WHIRL_OK) continue; // it would touch
        look(table, &at, film->arc, force);
        for (int k = 0; k < ROUND; k++) {
            double other[2];
            at.a = cos(2.0 * pi * k / ROUND);
            at.b = sin(2.0 * pi * k / ROUND);
            look(table, &at, film->arc, other);
            largest = fmax(largest, hypot(other[0], other[1]));
        }
        found[n++] = hypot(force[0] - answer.force[0], force[1] - answer.force[1]) / largest;
    }
    pad_workspace_free(work);
    pad_table_release(table);
    qsort(found, PLACES, sizeof *found, rising);
}

static void test_errors(void **state) {
    // Of a pad of a tilting-pad bearing, and of half an elliptical one; on twice the mesh of the table and more.
    static const struct {
        pad_film film;
        double preload, tilt, worst;
    } pads[] = {{{.arc = 1.04719755119659774615, .ratio = 0.5, .law = CAVITATION_REYNOLDS, .around = 128, .along = 16},
                 0.4,
                 0.3,
                 1.2e-2},
                {{.arc = 2.79252680319092716487, .ratio = 0.5, .law = CAVITATION_REYNOLDS, .around = 192, .along = 16},
                 0.5,
                 0.0,
                 1.2e-2}};
    (void)state;
    for (size_t i = 0; i < sizeof pads / sizeof *pads; i++) {
        double found[PLACES];
        errors(&pads[i].film, pads[i].preload, pads[i].tilt, found);
        const double most = found[PLACES * 95 / 100], worst = found[PLACES - 1];
        print_message("pad of %.0f degrees: median %.1e, 95 %% below %.1e, worst %.1e\n", pads[i].film.arc * 180.0 / pi,
                      found[PLACES / 2], most, worst);
        assert_true(most < 1e-3);
        assert_true(worst < pads[i].worst);
    }
}

/// Second differences of the force across nodes do not jump: the spline has two continuous derivatives.
static void test_smooth(void **state) {
    const pad_table_key key = {.arc = 1.04719755119659774615, .ratio = 0.5, .law = CAVITATION_REYNOLDS};
    const double step = 1e-6;
    double table;
    (void)state;
    assert_int_equal(pad_table_number(&key, &table).code, WHIRL_OK);
    assert_int_equal(pad_table_hold(table, NULL).code, WHIRL_OK);
    for (int along = 0; along < 3; along++) {
        const double node[] = {PAD_MIN_T + 9 * PAD_STEP_T, 3 * PAD_STEP_W, 5 * PAD_STEP_ALPHA};
        double force[7][2];
        for (int k = 0; k < 7; k++) {
            double at[] = {0.8, 0.1, 0.5};
            at[along] = node[along] + step * (k - 3);
            table_force(table, at[0], at[1], 0.5 * at[2], force[k]);
        }
        for (int n = 0; n < 2; n++) {
            const double before = force[0][n] - 2.0 * force[1][n] + force[2][n];
            const double after = force[4][n] - 2.0 * force[5][n] + force[6][n];
            // Third derivatives are some 1e3 at most; second ones, which must not jump, some 10.
            assert_true(fabs(after - before) < 4.0 * step * step * step * 1e4 + 4e-15);
        }
    }
    pad_table_release(table);
}

/// Makes a folder for the tables of this test. The film is the cheapest one.
static void own_cache(char folder[64]) {
    strcpy(folder, "/tmp/whirl-tables-XXXXXX");
    assert_non_null(mkdtemp(folder));
    assert_int_equal(setenv("XDG_CACHE_HOME", folder, 1), 0);
}

static const pad_table_key cheap = {.arc = 0.5, .ratio = 0.2, .law = CAVITATION_GUMBEL};

static void *make_table(void *table) {
    assert_int_equal(pad_table_hold(*(double *)table, NULL).code, WHIRL_OK);
    return NULL;
}

/// A thread that is asked to stop makes no table, and the next one does. Threads that make a table together make that
/// of one thread.
static void test_together(void **state) {
    const pad_film film = pad_table_film(&cheap);
    const whirl_stop stop = true;
    char folder[64];
    pthread_t threads[3];
    pad_workspace *work;
    double table;
    (void)state;
    own_cache(folder);
    assert_int_equal(pad_table_number(&cheap, &table).code, WHIRL_OK);
    assert_int_equal(pad_table_hold(table, &stop).code, WHIRL_STOPPED);
    assert_false(pad_table_file_is_there(&cheap));
    for (size_t i = 0; i < 3; i++) assert_int_equal(pthread_create(&threads[i], NULL, make_table, &table), 0);
    for (size_t i = 0; i < 3; i++) pthread_join(threads[i], NULL);
    assert_true(pad_table_file_is_there(&cheap));
    pad_table *alone = pad_table_empty();
    assert_non_null(alone);
    assert_int_equal(pad_workspace_new(film.around, film.along, &work).code, WHIRL_OK);
    for (int t = PAD_T_NODES - 1; t >= 0; t--) assert_int_equal(pad_table_fill(alone, &film, work, t).code, WHIRL_OK);
    pad_table_splines(alone);
    assert_memory_equal(alone->coefficients, pad_table_of(table)->coefficients, sizeof alone->coefficients);
    pad_workspace_free(work);
    free(alone);
    for (size_t i = 0; i < 3; i++) pad_table_release(table);
}

/// A file of another program's forces with a valid checksum is not used as a table, and neither is a FIFO, which must
/// not block.
static void test_files(void **state) {
    char folder[64], path[512];
    bool found;
    (void)state;
    own_cache(folder);
    pad_table *table = pad_table_empty();
    double number;
    assert_non_null(table);
    assert_int_equal(pad_table_number(&cheap, &number).code, WHIRL_OK);
    assert_int_equal(pad_table_hold(number, NULL).code, WHIRL_OK);
    memcpy(table->coefficients, pad_table_of(number)->coefficients, sizeof table->coefficients);
    pad_table_release(number);
    pad_table_file_write(&cheap, table);
    assert_int_equal(pad_table_file_read(&cheap, table, &found).code, WHIRL_OK);
    assert_true(found);
    for (size_t i = 0; i < PAD_COEFFICIENTS; i++) table->coefficients[i] *= 1.0 + 1e-6;
    pad_table_file_write(&cheap, table);
    assert_int_equal(pad_table_file_read(&cheap, table, &found).code, WHIRL_OK);
    assert_false(found);
    snprintf(path, sizeof path, "%s/whirl", folder);
    DIR *list = opendir(path);
    const struct dirent *entry;
    assert_non_null(list);
    while ((entry = readdir(list)) != NULL)
        if (strncmp(entry->d_name, "pad-", 4) == 0) snprintf(path, sizeof path, "%s/whirl/%s", folder, entry->d_name);
    closedir(list);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_int_equal(pad_table_file_read(&cheap, table, &found).code, WHIRL_OK);
    assert_false(found);
    free(table);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_errors), cmocka_unit_test(test_smooth),
                                       cmocka_unit_test(test_together), cmocka_unit_test(test_files)};
    return cmocka_run_group_tests_name("tables of pads", tests, NULL, NULL);
}
