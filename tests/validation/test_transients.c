// Transient chaos: how many chaotic transients are called chaotic with high confidence, and how many lasting motions
// keep it. If theory does not give the final regime of a motion, it is followed for fifty times as long.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "lorenz.h"
#include "support_check.h"
#include "support_rotor.h"
#include "whirl/engine/study.h"

enum { TRANSIENT = 1100, RECORD = 100, IN_THE_END = 60000 };

/// A machine with the start that it has in the ensemble.
typedef struct member {
    whirl_rotor *rotor; ///< or NULL
    whirl_system system;
    double p[1], start[4];
} member;

static void release(void *owner) {
    member *m = owner;
    whirl_rotor_free(m->rotor);
    free(m);
}

static double spread(double value, double factor) {
    return fmod(0.5 + value * factor, 1.0);
}

/// Makes Lorenz' system between r = 22 and 24: chaos ends at an equilibrium, the later the closer to 24.06 (Sparrow
/// 1982).
static member *lorenz(double value) {
    static const whirl_probe probe = {.name = "x"};
    member *m = calloc(1, sizeof *m);
    assert_non_null(m);
    m->p[0] = 22.0 + 2.0 * spread(value, 0.7548776662466927);
    for (int i = 0; i < 3; i++) m->start[i] = 1.0 + 9.0 * spread(value, 0.5698402909980532 + 0.1 * i);
    m->system = (whirl_system){.dimension = 3,
                               .period = 1.0,
                               .rhs = lorenz_rhs,
                               .tangent = lorenz_tangent,
                               .model = m->p,
                               .probe_count = 1,
                               .probes = &probe};
    return m;
}

/// Makes Lorenz' system beyond r = 24.74: all motions are chaotic up to about 30.1 (Sparrow 1982).
static member *lasting_lorenz(double value) {
    member *m = lorenz(value);
    m->p[0] = 25.0 + 5.0 * spread(value, 0.7548776662466927);
    return m;
}

/// Makes case C4 between its chaos at w = 3.3 and its P-4 at 3.8.
static member *rub(double value) {
    member *m = calloc(1, sizeof *m);
    assert_non_null(m);
    const rub_case c = {.speed = 3.5 + 0.2 * spread(value, 0.7548776662466927),
                        .zeta = 0.1,
                        .kappa = 10.0,
                        .eccentricity = 0.9,
                        .friction = 0.05,
                        .weight = 0.5};
    m->rotor = make_rub_rotor(&c);
    m->system = *whirl_rotor_system(m->rotor);
    m->start[0] = 0.3 * spread(value, 0.5698402909980532);
    m->start[1] = -0.3 * spread(value, 0.3819660112501051);
    return m;
}

typedef struct family {
    const char *name;
    member *(*make)(double value);
    int steps;
    size_t members, quick; ///< in a soak, and else
    bool all_end;          ///< by theory; else by a long run
    bool coexists;         ///< with a stable orbit close by, so that what lasts is doubted, too
} family;

static whirl_status make_machine(const void *context, const whirl_batch *batch, double value, whirl_machine *machine) {
    const family *f = context;
    (void)batch;
    member *m = f->make(value);
    const whirl_system *system = m->rotor ? whirl_rotor_system(m->rotor) : &m->system;
    *machine = (whirl_machine){.system = system, .start = m->start, .owner = m, .release = release};
    return whirl_ok();
}

static whirl_record_options watched(int transient) {
    whirl_record_options options = whirl_record_default();
    options.transient = transient;
    options.record = RECORD;
    options.watch = 650;
    options.waveform = false;
    return options;
}

static bool ends(const family *f, double value, const whirl_integrate_options *integrate) {
    whirl_record_options options = watched(IN_THE_END);
    whirl_machine machine;
    whirl_record *record;
    options.settle = true;
    if (f->all_end) return true;
    require_ok(make_machine(f, NULL, value, &machine));
    require_ok(whirl_record_motion(machine.system, integrate, &options, machine.start, NULL, &record));
    const whirl_verdict verdict = whirl_judge(record);
    whirl_record_free(record);
    machine.release(machine.owner);
    return verdict.regime != WHIRL_CHAOTIC;
}

typedef struct tally {
    int high, kept; ///< by two tolerances; and after copies were followed
} tally;

/// Judges fifteen points at a time, so that every chaotic one is followed (there are too few neighbours to decide).
static void judge(const family *f, size_t first, size_t count, double refine, tally sums[2]) {
    double values[15];
    whirl_result *result;
    whirl_study study = {.batch_count = 1, .machine = make_machine, .family = f, .refine = {.revolutions = refine}};
    whirl_batch *batch = &study.batches[0];
    *batch = (whirl_batch){.name = "points", .parameter = "i", .count = count, .values = values, .confirm = true};
    for (size_t i = 0; i < count; i++) values[i] = (double)(first + i);
    batch->integrate = whirl_integrate_default();
    batch->integrate.steps_per_revolution = f->steps;
    batch->record = watched(TRANSIENT);
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    require_ok(whirl_study_run(&study, &(whirl_run_options){.threads = 2}, &result));
    for (size_t i = 0; i < count; i++) {
        const whirl_verdict v = whirl_table_verdict(result->tables, i);
        const bool sound = v.regime == WHIRL_CHAOTIC && v.agreement == WHIRL_HIGH && v.other_regime == WHIRL_CHAOTIC;
        const bool followed = v.followed > 0.0, stayed = followed && v.later_regime == WHIRL_CHAOTIC;
        if (!sound || !(followed || v.confidence == WHIRL_HIGH)) continue;
        tally *sum = &sums[ends(f, values[i], &batch->integrate)];
        sum->high++;
        sum->kept += v.confidence == WHIRL_HIGH && stayed;
    }
    whirl_result_free(result);
}

static void check(const family *f, double refine) {
    const size_t members = getenv("WHIRL_SOAK") ? f->members : f->quick;
    tally sums[2] = {{0, 0}, {0, 0}};
    for (size_t first = 0; first < members; first += 15)
        judge(f, first, members - first < 15 ? members - first : 15, refine, sums);
    printf(
        "transients | %s%s, %zu motions | - | lasting chaos: %d high, %d when followed; transients: %d high, %d when "
        "followed | - | -\n",
        f->name, refine > 0.0 ? ", refined" : "", members, sums[0].high, sums[0].kept, sums[1].high, sums[1].kept);
    if (!f->coexists) assert_int_equal(sums[0].kept, sums[0].high); // what lasts is not doubted
    assert_int_equal(sums[1].kept, 0);
}

static family families[] = {
    {"Lorenz, r = 22 to 24", lorenz, 128, 120, 15, true, false},
    {"Lorenz, r = 25 to 30", lasting_lorenz, 128, 60, 4, false, false},
    {"rub C4, w = 3.5 to 3.7", rub, 512, 60, 0, false, true},
};

static void transients(void **state) {
    const family *f = *state;
    check(f, 0.0);
    if (getenv("WHIRL_SOAK")) check(f, 2e6);
}

int main(void) {
    enum { COUNT = sizeof families / sizeof *families };
    struct CMUnitTest tests[COUNT];
    for (size_t i = 0; i < COUNT; i++)
        tests[i] = (struct CMUnitTest){families[i].name, transients, NULL, NULL, &families[i]};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
