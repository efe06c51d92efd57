// Changes of the motion of the paper's rotor, in the calibrated reading: compared with a program in extended precision,
// and with motions that settle on both sides of every change.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_branch.h"
#include "support_check.h"
#include "support_peer.h"
#include "whirl/engine.h"
#include "whirl/engine/ensemble.h"

enum { N = 8, MAX_CHANGES = 4 };

/// A box around all motions of the rotor, in clearances.
static const double low[N] = {-1.0, -1.1, -0.6, -0.9, -0.6, -0.6, -0.6, -0.6},
                    high[N] = {1.0, 0.3, 0.6, 0.3, 0.6, 0.6, 0.6, 0.6};

// ---------------------------------------------------------------- what is expected

/// A settled motion: revolutions after which it returns (0: it does not), and times that the disc touches in these.
typedef struct settled {
    size_t returns, contacts;
} settled;

/// A special point, and the motions that are seen a little above and below it in r_k where it is one of a stable orbit.
typedef struct change {
    whirl_special kind;
    bool seen;
    settled above, below;
} change;

/// A piece of a branch: the stable orbit at r_k = `at` that it begins with, where it ends, and what lies on it.
typedef struct piece {
    double at;
    settled orbit;
    int direction;
    double from, to;
    change changes[MAX_CHANGES];
} piece;

static const piece pieces[] = {
    {0.498, {1, 0}, -1, 0.496, 0.498, {{WHIRL_NEIMARK_SACKER, true, {1, 0}, {0, 0}}}},
    {0.498, {5, 1}, 1, 0.498, 0.5, {{WHIRL_FOLD, true, {1, 0}, {5, 1}}, {WHIRL_DOUBLING, false, {0, 0}, {0, 0}}}},
    {0.493,
     {5, 1},
     -1,
     0.4905,
     0.493,
     {{WHIRL_FOLD, true, {5, 1}, {0, 0}},
      {WHIRL_DOUBLING, false, {0, 0}, {0, 0}},
      {WHIRL_DOUBLING, false, {0, 0}, {0, 0}}}},
    {0.493, {5, 0}, 1, 0.492, 0.4945, {{WHIRL_FOLD, true, {0, 0}, {5, 0}}}},
    {0.493, {5, 0}, -1, 0.4905, 0.493, {{WHIRL_FOLD, true, {5, 0}, {0, 0}}}},
    {0.457, {14, 0}, 1, 0.4562, 0.459, {{WHIRL_NEIMARK_SACKER, true, {0, 0}, {14, 0}}}},
    {0.456, {14, 0}, -1, 0.4552, 0.4575, {{WHIRL_DOUBLING, true, {14, 0}, {28, 0}}}},
    {0.42, {2, 0}, 1, 0.41, 0.425, {{WHIRL_FOLD, true, {0, 0}, {2, 0}}}},
    {0.374, {2, 0}, -1, 0.368, 0.374, {{WHIRL_DOUBLING, true, {2, 0}, {4, 0}}}},
    {0.362, {4, 1}, 1, 0.36, 0.3685, {{WHIRL_GRAZE, true, {4, 0}, {4, 1}}}},
    {0.324, {4, 1}, -1, 0.316, 0.325, {{WHIRL_DOUBLING, true, {4, 1}, {8, 2}}}},
    {0.31, {8, 1}, 1, 0.308, 0.317, {{WHIRL_GRAZE, true, {8, 2}, {8, 1}}}},
    {0.31, {8, 1}, -1, 0.3062, 0.31, {{WHIRL_GRAZE, true, {8, 1}, {8, 2}}}},
    {0.303, {4, 1}, 1, 0.302, 0.307, {{WHIRL_DOUBLING, true, {8, 2}, {4, 1}}}},
    {0.303,
     {4, 1},
     -1,
     0.2979,
     0.304,
     {{WHIRL_FOLD, false, {4, 1}, {4, 1}},
      {WHIRL_FOLD, false, {4, 1}, {4, 1}},
      {WHIRL_NEIMARK_SACKER, true, {4, 1}, {0, 0}}}},
};
enum { PIECES = sizeof pieces / sizeof *pieces };

// ---------------------------------------------------------------- what is found

/// Results of the program in extended precision, the case, and the branches of all pieces.
typedef struct known {
    peer_point points[8];
    size_t count;
    whirl_case *object;
    whirl_family family;
    case_family of_case;
    whirl_branch *branches[PIECES];
} known;

/// Finds the stable orbits at r_k.
static void collect(const known *k, double r_k, size_t starts, size_t revolutions, whirl_collection **collection) {
    whirl_collect_options options = whirl_collect_default(low, high);
    whirl_machine machine;
    options.starts = starts;
    options.most_revolutions = revolutions;
    options.longest = 14;
    require_ok(k->family.machine(k->family.context, r_k, &machine));
    require_ok(whirl_orbit_collect(machine.system, &options, collection));
    machine.release(machine.owner);
}

static bool is_like(const whirl_orbit *orbit, settled like) {
    return orbit->revolutions == like.returns && orbit->touches[0].intervals == like.contacts;
}

/// Returns the stable orbit at the beginning of a piece, of those on which motions settle there.
static const whirl_orbit *beginning(const piece *p, const whirl_collection *collection) {
    for (size_t i = 0; i < collection->count; i++)
        if (is_like(collection->orbits[i], p->orbit)) return collection->orbits[i];
    fail_msg("no stable P-%zu with %zu contacts at r_k = %g", p->orbit.returns, p->orbit.contacts, p->at);
    return NULL;
}

static whirl_branch_options options_of(const piece *p) {
    whirl_branch_options options = whirl_branch_default(p->from, p->to);
    options.step = 0.05;
    options.most_step = 0.2;
    options.most_points = 40;
    return options;
}

static void follow_piece(const known *k, const piece *p, whirl_branch **branch) {
    const whirl_branch_options options = options_of(p);
    whirl_collection *collection;
    collect(k, p->at, p->at > 0.49 ? 64 : 8, 2200, &collection);
    require_ok(whirl_branch_follow(&k->family, beginning(p, collection), p->at, p->direction, &options, branch));
    whirl_collection_free(collection);
}

static int follow_pieces(void **state) {
    known *k = calloc(1, sizeof *k);
    assert_non_null(k);
    *state = k;
    assert_true(
        run_peer(getenv("WHIRL_SOAK") ? REFERENCE : "cat " REFERENCES "/paper_rotor.txt", k->points, 8, &k->count));
    require_ok(whirl_case_load(WHIRL_CASES "/paper.yaml", NULL, &k->object));
    k->of_case = (case_family){k->object, "r_k"};
    k->family = family_of_case(&k->of_case);
    for (size_t i = 0; i < PIECES; i++) follow_piece(k, &pieces[i], &k->branches[i]);
    return 0;
}

static int forget_pieces(void **state) {
    known *k = *state;
    for (size_t i = 0; i < PIECES; i++) whirl_branch_free(k->branches[i]);
    whirl_case_free(k->object);
    free(k);
    return 0;
}

/// Returns the index of the next special point of a branch from `i` on; the number of points if there is none.
static size_t next_special(const whirl_branch *branch, size_t i) {
    while (i < branch->count && branch->points[i].special == WHIRL_REGULAR) i++;
    return i;
}

static size_t count_changes(const piece *p) {
    size_t count = 0;
    while (count < MAX_CHANGES && p->changes[count].kind != WHIRL_REGULAR) count++;
    return count;
}

// ---------------------------------------------------------------- tests

/// Every piece has the expected changes, in their order.
static void changes_are_named(void **state) {
    const known *k = *state;
    for (size_t i = 0; i < PIECES; i++) {
        const whirl_branch *branch = k->branches[i];
        size_t at = next_special(branch, 0);
        for (size_t c = 0; c < count_changes(&pieces[i]); c++, at = next_special(branch, at + 1)) {
            if (at >= branch->count) fail_msg("piece %zu has %zu changes", i, c);
            check_text("changes", words("P-%zu, r_k = %.10f", pieces[i].orbit.returns, branch->points[at].value),
                       special_word(pieces[i].changes[c].kind), special_word(branch->points[at].special));
        }
    }
}

/// Returns the value of the same point by orbits of another tolerance in more segments, from the regular point before
/// it.
static double value_at_other_tolerance(const known *k, const piece *p, const whirl_branch *branch, size_t at) {
    const whirl_branch_point *point = &branch->points[at], *before = point;
    whirl_branch_options options = options_of(p);
    whirl_branch *again;
    while (before->special != WHIRL_REGULAR) before--;
    const int direction = before[1].value > before->value ? 1 : -1;
    options.orbit.integrate.rtol = 1e-11;
    options.orbit.integrate.atol = 1e-13;
    options.orbit.tolerance = 1e-11;
    options.most_points = 8;
    require_ok(whirl_branch_follow(&k->family, before->orbit, before->value, direction, &options, &again));
    double nearest = INFINITY;
    for (size_t i = 0; i < again->count; i++)
        if (again->points[i].special == point->special &&
            fabs(again->points[i].value - point->value) < fabs(nearest - point->value))
            nearest = again->points[i].value;
    whirl_branch_free(again);
    return nearest;
}

static void two_tolerances_agree(void **state) {
    const known *k = *state;
    for (size_t i = 0; i < PIECES; i++)
        for (size_t at = next_special(k->branches[i], 0); at < k->branches[i]->count;
             at = next_special(k->branches[i], at + 1)) {
            const whirl_branch_point *point = &k->branches[i]->points[at];
            check_within("changes",
                         words("P-%zu, %s: r_k by rtol 1e-11", pieces[i].orbit.returns, special_word(point->special)),
                         point->value, value_at_other_tolerance(k, &pieces[i], k->branches[i], at), 1e-8);
        }
}

/// The published digits are those of a program in extended precision, whose own motion closes there.
static void digits_are_confirmed(void **state) {
    peer_point points[8];
    size_t count;
    (void)state;
    assert_true(run_peer(REFERENCE " confirm < " REFERENCES "/paper_rotor.txt", points, 8, &count));
    for (size_t i = 0; i < count; i++) {
        const char *name = words("%s at r_k = %.12f", points[i].kind, points[i].numbers[0]);
        check_within("changes", words("%s, in extended precision: it closes", name), 0.0, points[i].numbers[1], 1e-13);
        check_within("changes", words("%s, in extended precision: what vanishes there", name), 0.0,
                     points[i].numbers[2], 1e-12);
    }
}

/// Returns the special point of that kind, of all pieces, that is nearest to r_k; INFINITY without one.
static double nearest_change(const known *k, const char *kind, double r_k) {
    double nearest = INFINITY;
    for (size_t i = 0; i < PIECES; i++)
        for (size_t at = 0; at < k->branches[i]->count; at++) {
            const whirl_branch_point *point = &k->branches[i]->points[at];
            if (point->special != WHIRL_REGULAR && strcmp(special_word(point->special), kind) == 0 &&
                fabs(point->value - r_k) < fabs(nearest - r_k))
                nearest = point->value;
        }
    return nearest;
}

static void the_second_program_agrees(void **state) {
    const known *k = *state;
    assert_int_equal(k->count, 6);
    for (size_t i = 0; i < k->count; i++) {
        const double r_k = k->points[i].numbers[0];
        check_within("changes", words("%s: r_k in extended precision", k->points[i].kind), r_k,
                     nearest_change(k, k->points[i].kind, r_k), 1e-8);
    }
}

/// Motions settle on the orbits that begin at every doubling, and on the torus at P-1's Neimark-Sacker point: none is
/// reported as subcritical.
static void orbits_that_begin_are_stable(void **state) {
    const known *k = *state;
    size_t reported = 0;
    for (size_t i = 0; i < PIECES; i++) {
        const whirl_branch_point *point = &k->branches[i]->points[next_special(k->branches[i], 0)];
        const whirl_special kind = pieces[i].changes[0].kind;
        if ((kind != WHIRL_DOUBLING && i > 0) || pieces[i].orbit.returns > 8) continue;
        reported += !isnan(point->criticality);
        check_holds("changes",
                    words("%s at %.6f: not reported as subcritical (%.3g)", special_word(kind), point->value,
                          point->criticality),
                    !(point->criticality > 0.0));
    }
    assert_true(reported >= 4);
}

// ---------------------------------------------------------------- brute force

/// A motion near a special point, and the expected settled motion.
typedef struct motion {
    char *name;
    settled expected, found;
    whirl_machine machine;
    const double *start; ///< of the orbit at the point
    double from[N];
} motion;

enum { MAX_MOTIONS = 2 * PIECES * MAX_CHANGES };

typedef struct brute_force {
    const known *known;
    whirl_ensemble *ensemble;
    motion motions[MAX_MOTIONS];
    size_t count;
} brute_force;

/// Returns the distance from a special point at which motions are compared. After the doubling from 14 revolutions the
/// next one is nearer than 1e-3.
static double aside_of(settled above, settled below) {
    return above.returns == 14 && below.returns == 28 ? 5e-5 : 5e-4;
}

/// Adds two motions, above and below each special point of a stable orbit.
static void add_motions(brute_force *b, const piece *p, const whirl_branch *branch) {
    size_t at = next_special(branch, 0);
    for (size_t c = 0; c < count_changes(p); c++, at = next_special(branch, at + 1)) {
        const change *expected = &p->changes[c];
        const whirl_branch_point *point = &branch->points[at];
        const double aside = aside_of(expected->above, expected->below);
        for (int side = 1; side >= -1 && expected->seen; side -= 2) {
            motion *m = &b->motions[b->count++];
            m->name = strdup(
                words("%s at %.6f: a motion at r_k %+.0e", special_word(expected->kind), point->value, side * aside));
            m->expected = side > 0 ? expected->above : expected->below;
            m->start = point->orbit->nodes;
            require_ok(b->known->family.machine(b->known->family.context, point->value + side * aside, &m->machine));
        }
    }
}

/// Lets all motions settle, side by side, from a start next to the orbit.
static void settle_motions(brute_force *b) {
    enum { REVOLUTIONS = 5000 };
    whirl_integrate_options options = whirl_integrate_default();
    strcpy(options.method, "dop853");
    options.rtol = 1e-9;
    options.atol = 1e-12;
    require_ok(whirl_ensemble_new(b->motions[0].machine.system, &options, b->count, &b->ensemble));
    for (size_t k = 0; k < b->count; k++) {
        motion *m = &b->motions[k];
        for (size_t i = 0; i < N; i++) m->from[i] = 1.001 * m->start[i];
        require_ok(whirl_ensemble_load(b->ensemble, k, m->machine.system, m->from));
    }
    for (int n = 0; n < REVOLUTIONS; n++) whirl_ensemble_revolve(b->ensemble, b->count, NULL);
}

/// Finds after how many revolutions each motion returns, and how many times it touches in these.
static void watch_motions(brute_force *b) {
    enum { LONGEST = 40 };
    for (size_t k = 0; k < b->count; k++) {
        whirl_ensemble_state(b->ensemble, k, b->motions[k].from);
        whirl_ensemble_forget(b->ensemble, k);
    }
    for (size_t n = 1; n <= LONGEST; n++) {
        whirl_ensemble_revolve(b->ensemble, b->count, &(whirl_ensemble_observe){.extremes = true});
        for (size_t k = 0; k < b->count; k++) {
            motion *m = &b->motions[k];
            double x[N], contacts[1], away = 0.0;
            whirl_ensemble_state(b->ensemble, k, x);
            for (size_t i = 0; i < N; i++) away = fmax(away, fabs(x[i] - m->from[i]));
            if (away >= 1e-5 || m->found.returns > 0) continue;
            whirl_ensemble_read(b->ensemble, k, &(whirl_ensemble_seen){.contact_number = contacts});
            m->found = (settled){n, (size_t)contacts[0]};
        }
    }
}

static const char *in_words(settled s) {
    return s.returns == 0 ? "does not return" : words("P-%zu, %zu contacts", s.returns, s.contacts);
}

/// Motions on both sides of a special point are those of the two pieces that meet there.
static void motions_change_there(void **state) {
    static brute_force b;
    const known *k = *state;
    b.known = k;
    for (size_t i = 0; i < PIECES; i++) add_motions(&b, &pieces[i], k->branches[i]);
    settle_motions(&b);
    watch_motions(&b);
    for (size_t i = 0; i < b.count; i++) {
        motion *m = &b.motions[i];
        check_text("changes", m->name, in_words(m->expected), in_words(m->found));
        free(m->name);
        m->machine.release(m->machine.owner);
    }
    whirl_ensemble_free(b.ensemble);
}

/// All stable orbits at one value are found: the orbit that rubs next to the main one and to the locked torus, one of
/// seven revolutions where the diagram has none, and two between the folds of the orbit of four.
static void several_orbits_at_one_value(void **state) {
    const known *k = *state;
    const whirl_branch *last = k->branches[PIECES - 1];
    const size_t fold = next_special(last, 0);
    const double between = 0.5 * (last->points[fold].value + last->points[next_special(last, fold + 1)].value);
    const struct {
        double r_k;
        size_t starts, revolutions;
        settled orbits[2];
    } rows[] = {{0.498, 64, 2200, {{1, 0}, {5, 1}}},
                {0.493, 64, 2200, {{5, 0}, {5, 1}}},
                {0.58, 64, 2200, {{1, 0}, {7, 3}}},
                {between, 16, 9000, {{4, 1}, {4, 1}}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        whirl_collection *collection;
        bool met[2] = {false, false};
        collect(k, rows[i].r_k, rows[i].starts, rows[i].revolutions, &collection);
        for (size_t n = 0; n < collection->count; n++)
            for (size_t j = 0; j < 2; j++)
                if (!met[j] && is_like(collection->orbits[n], rows[i].orbits[j])) {
                    met[j] = true;
                    break;
                }
        check_holds("changes",
                    words("r_k = %.6f: P-%zu with %zu and P-%zu with %zu contacts are stable", rows[i].r_k,
                          rows[i].orbits[0].returns, rows[i].orbits[0].contacts, rows[i].orbits[1].returns,
                          rows[i].orbits[1].contacts),
                    collection->count == 2 && met[0] && met[1]);
        whirl_collection_free(collection);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes_are_named),
                                       cmocka_unit_test(two_tolerances_agree),
                                       cmocka_unit_test(digits_are_confirmed),
                                       cmocka_unit_test(the_second_program_agrees),
                                       cmocka_unit_test(orbits_that_begin_are_stable),
                                       cmocka_unit_test(motions_change_there),
                                       cmocka_unit_test(several_orbits_at_one_value)};
    return cmocka_run_group_tests(tests, follow_pieces, forget_pieces);
}
