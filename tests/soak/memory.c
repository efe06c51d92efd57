#define _DEFAULT_SOURCE // wait4; NOLINT(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
/// Memory of many points, measured at two sizes: of a run with all the paper's analyses, journal, result file and its
/// verification included, extrapolated to a million points; and of a merge, which does not grow with their number.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "whirl/engine.h"

static const char case_text[] =
    "whirl: 1\n"
    "title: Many points\n"
    "parameters: {r_k: 0.6, c: 0.2 mm, k2: = 50*(650/0.2)^2}\n"
    "rotor:\n"
    "  speed: 650 rad/s\n"
    "  length_scale: = c\n"
    "  stations:\n"
    "    disc:    {mass: 420 kg, damping: = 0.0157509*420*650, eccentricity: = 0.08*c}\n"
    "    journal: {mass: 100 kg, damping: = 0.286154*50*650}\n"
    "  elements:\n"
    "    - shaft:   {between: [disc, journal], k1: = r_k*k2, k2: = k2, signs: paper}\n"
    "    - film:    {at: journal, count: 2, clearance: = c, load: = 0.0045*50*c*650^2}\n"
    "    - rub:     {at: disc, gap: = 1.2*c, stiffness: = 10*k2, friction: 0.1}\n"
    "    - gravity: {acceleration: = 0.115976*c*650^2}\n"
    "study:\n"
    "  sweep: {parameter: r_k, from: 1.0, to: 0.1, points: %zu, start: state}\n"
    "  initial: {disc: {y: -0.1}, journal: {y: -0.1}}\n"
    "  integrate: {method: rk4, steps_per_revolution: 64, transient: 4, record: 4, settle: no}\n"
    "  analyze: [poincare, regime, lyapunov, spectrum, orbit, rub]\n";

typedef struct places {
    char folder[64], study[96], result[96], journal[96], shard[128];
} places;

static void must(whirl_status status) {
    if (status.code == WHIRL_OK) return;
    fprintf(stderr, "%s\n", status.message);
    _exit(1);
}

/// Runs as `whirl run` does, with a table whose blocks stay with the store.
static void run(const places *at) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_result *outline, *result;
    whirl_journal *journal;
    must(whirl_case_load(at->study, &problems, &object));
    must(whirl_case_outline(object, &outline));
    must(whirl_journal_begin(at->journal, outline, &journal));
    whirl_result_free(outline);
    const whirl_run_options options = {.store = whirl_journal_store(journal), .memory = 1};
    must(whirl_case_run(object, &options, &result));
    must(whirl_result_write(result, at->result));
    must(whirl_result_verify(result, at->result));
    whirl_result_free(result);
    must(whirl_journal_remove(journal));
    whirl_case_free(object);
}

static void write_case(const places *at, const char *text, size_t points) {
    FILE *stream = fopen(at->study, "w");
    assert_non_null(stream);
    fprintf(stream, text, points);
    fclose(stream);
}

/// Returns the largest resident size in bytes of a process that does this work.
static double resident(void (*work)(const places *), const places *at) {
    struct rusage used;
    int outcome = 0;
    const pid_t child = fork();
    if (child == 0) {
        work(at);
        _exit(0);
    }
    assert_true(child > 0 && wait4(child, &outcome, 0, &used) == child);
    assert_true(WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0);
    return (double)used.ru_maxrss * 1024.0;
}

static places make_places(void) {
    places at;
    strcpy(at.folder, "/tmp/whirl-memory-XXXXXX");
    assert_non_null(mkdtemp(at.folder));
    snprintf(at.study, sizeof at.study, "%s/many.yaml", at.folder);
    snprintf(at.result, sizeof at.result, "%s/many.h5", at.folder);
    snprintf(at.journal, sizeof at.journal, "%s/many.h5.journal", at.folder);
    snprintf(at.shard, sizeof at.shard, "%s/many.h5.journal.shard-1-of-1", at.folder);
    return at;
}

static void remove_places(const places *at) {
    remove(at->study);
    remove(at->result);
    rmdir(at->folder);
}

static void a_million_points_fit(void **state) {
    enum { FEW = 2000, MANY = 30000 };
    const places at = make_places();
    (void)state;
    write_case(&at, case_text, FEW);
    const double few = resident(run, &at);
    write_case(&at, case_text, MANY);
    const double many = resident(run, &at);
    const double point = (many - few) / (MANY - FEW), table = 256e6;
    remove_places(&at);
    printf("%d points: %.0f MB, %d points: %.0f MB: %.0f bytes a point\n", FEW, few / 1e6, MANY, many / 1e6, point);
    // A table stays in memory as long as it is smaller than this.
    assert_true(few + 1e6 * point + table < 2e9);
}

// ---------------------------------------------------------------- merging

static const char map_text[] = "whirl: 1\n"
                               "parameters: {omega: 1 rad/s, kappa: 10}\n"
                               "rotor:\n"
                               "  speed: = omega\n"
                               "  length_scale: 1 m\n"
                               "  stations: {disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}}\n"
                               "  elements: [shaft: {between: [disc, ground], k1: = kappa, k2: 1 N/m}]\n"
                               "study:\n"
                               "  map:\n"
                               "    x: {parameter: omega, from: 1, to: 4, points: 700}\n"
                               "    y: {parameter: kappa, from: 5, to: 20, points: %zu}\n"
                               "  integrate: {method: rk4, transient: 10, record: 10}\n"
                               "  analyze: [regime]\n";

static whirl_case *load(const places *at, whirl_result **outline) {
    whirl_problems problems = {0};
    whirl_case *object;
    must(whirl_case_load(at->study, &problems, &object));
    must(whirl_case_outline(object, outline));
    return object;
}

/// Writes the journal of a shard that has all points, whose numbers cost nothing to compute.
static void fill_shard(const places *at) {
    enum { DIMENSION = 4 };
    static double block[4096];
    const double end[DIMENSION] = {0};
    whirl_result *outline;
    whirl_journal *journal;
    whirl_case *object = load(at, &outline);
    must(whirl_journal_begin(at->shard, outline, &journal));
    const whirl_point_store *store = whirl_journal_store(journal);
    const whirl_table *table = outline->tables;
    assert_true(table->layout.size <= sizeof block / sizeof *block);
    for (size_t i = 0; i < table->count; i++)
        must(store->keep(store->context, 0, i, block, table->layout.size, end, DIMENSION));
    whirl_result_free(outline);
    must(whirl_journal_close(journal));
    whirl_case_free(object);
}

/// Merges as `whirl merge` does.
static void merge(const places *at) {
    whirl_result *outline, *result;
    whirl_journal *journal;
    whirl_case *object = load(at, &outline);
    must(whirl_journal_begin(at->journal, outline, &journal));
    whirl_result_free(outline);
    must(whirl_journal_take(journal, at->shard));
    must(whirl_journal_discard(at->shard));
    const whirl_run_options options = {.store = whirl_journal_store(journal), .memory = 1, .gather = true};
    must(whirl_case_run(object, &options, &result));
    must(whirl_result_write(result, at->result));
    must(whirl_result_verify(result, at->result));
    whirl_result_free(result);
    must(whirl_journal_remove(journal));
    whirl_case_free(object);
}

/// From so many points on that whole chunks of the result are under way at both sizes: 131072 numbers are one. What
/// every point had of its own at the time of writing would be 12 MB more.
static void a_merge_does_not_grow(void **state) {
    enum { ROW = 700, FEW = 200, MANY = 400 };
    (void)state;
#ifdef SANITIZED
    skip(); // what is freed stays in memory for a while
#endif
    const places at = make_places();
    write_case(&at, map_text, FEW);
    resident(fill_shard, &at);
    const double few = resident(merge, &at);
    write_case(&at, map_text, MANY);
    resident(fill_shard, &at);
    const double many = resident(merge, &at);
    remove_places(&at);
    printf("a merge of %d points: %.1f MB, of %d points: %.1f MB\n", FEW * ROW, few / 1e6, MANY * ROW, many / 1e6);
    assert_true(many - few < 5e6);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_million_points_fit), cmocka_unit_test(a_merge_does_not_grow)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
