/// Memory of a run of many points with all the paper's analyses, journal, result file and its verification included:
/// measured at two sizes, and what that means for a million points.
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

#include "whirl/whirl.h"

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
    char folder[64], study[96], result[96], journal[96];
} places;

static void must(whirl_status status) {
    if (status.code == WHIRL_OK) return;
    fprintf(stderr, "%s\n", status.message);
    _exit(1);
}

/// What `whirl run` does, with a table that is to stay with the keeper.
static void run(const places *at) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_result *outline, *result;
    whirl_journal *journal;
    must(whirl_case_load(at->study, &problems, &object));
    must(whirl_case_outline(object, &outline));
    must(whirl_journal_begin(at->journal, outline, &journal));
    whirl_result_free(outline);
    const whirl_run_options options = {.keeper = whirl_journal_keeper(journal), .memory = 1};
    must(whirl_case_run(object, &options, &result));
    must(whirl_result_write(result, at->result));
    must(whirl_result_verify(result, at->result));
    whirl_result_free(result);
    must(whirl_journal_remove(journal));
    whirl_case_free(object);
}

/// The largest resident size in bytes of a process that runs a sweep of `points`.
static double resident(const places *at, size_t points) {
    struct rusage used;
    int outcome;
    FILE *stream = fopen(at->study, "w");
    assert_non_null(stream);
    fprintf(stream, case_text, points);
    fclose(stream);
    const pid_t child = fork();
    if (child == 0) {
        run(at);
        _exit(0);
    }
    assert_true(child > 0 && waitpid(child, &outcome, 0) == child);
    assert_true(WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0);
    remove(at->result);
    // The largest of all children so far: the larger run is to come last.
    assert_int_equal(getrusage(RUSAGE_CHILDREN, &used), 0);
    return (double)used.ru_maxrss * 1024.0;
}

static void a_million_points_fit(void **state) {
    enum { FEW = 2000, MANY = 12000 };
    places at;
    (void)state;
    strcpy(at.folder, "/tmp/whirl-memory-XXXXXX");
    assert_non_null(mkdtemp(at.folder));
    snprintf(at.study, sizeof at.study, "%s/many.yaml", at.folder);
    snprintf(at.result, sizeof at.result, "%s/many.h5", at.folder);
    snprintf(at.journal, sizeof at.journal, "%s/many.h5.journal", at.folder);
    const double few = resident(&at, FEW), many = resident(&at, MANY);
    const double point = (many - few) / (MANY - FEW), table = 256e6;
    remove(at.study);
    rmdir(at.folder);
    printf("%d points: %.0f MB, %d points: %.0f MB: %.0f bytes a point\n", FEW, few / 1e6, MANY, many / 1e6, point);
    // A table stays in memory as long as it is smaller than this.
    assert_true(few + 1e6 * point + table < 2e9);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_million_points_fit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
