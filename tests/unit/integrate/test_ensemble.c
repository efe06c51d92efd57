// Machines that were removed from an ensemble are not evaluated, and the others do not change.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/ensemble.h"
#include "whirl/engine/rotor.h"

enum { DIMENSION = 4, LANES = 5, ALONE = 6, TOGETHER = 4 };

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

// ---------------------------------------------------------------- machines that must not be evaluated after their
// removal

/// A rotor that rubs in every revolution, and a copy of its system whose functions can be taken away.
typedef struct machine {
    whirl_rotor *rotor;
    whirl_system system;
} machine;

static machine *machine_new(double eccentricity, double damping) {
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", eccentricity, NULL}};
    const whirl_setting shaft[] = {{"between", 0.0, "disc, ground"}, {"k1", 1.0, NULL}};
    const whirl_setting rub[] = {{"at", 0.0, "disc"},
                                 {"gap", 1.0, NULL},
                                 {"stiffness", 10.0, NULL},
                                 {"friction", 0.05, NULL},
                                 {"damping", damping, NULL}};
    const whirl_setting gravity[] = {{"acceleration", 0.5, NULL}};
    whirl_design *design;
    machine *own = calloc(1, sizeof *own);
    assert_non_null(own);
    must(whirl_design_new(1.0, 1.0, &design));
    must(whirl_design_station(design, "disc", disc, sizeof disc / sizeof *disc));
    must(whirl_design_element(design, "shaft", shaft, sizeof shaft / sizeof *shaft));
    must(whirl_design_element(design, "rub", rub, sizeof rub / sizeof *rub - (damping == 0.0)));
    must(whirl_design_element(design, "gravity", gravity, 1));
    must(whirl_rotor_new(design, &own->rotor));
    whirl_design_free(design);
    own->system = *whirl_rotor_system(own->rotor);
    return own;
}

static void rhs_of_removed(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing, (void)x, (void)dxdt;
    fail_msg("a machine was asked for its forces after it was removed");
}
static void rhs_on_sides_of_removed(const void *model, double t, const double *forcing, const double *x,
                                    const double *sides, double *dxdt) {
    (void)sides;
    rhs_of_removed(model, t, forcing, x, dxdt);
}
static void switches_of_removed(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t, (void)x, (void)values;
    fail_msg("a machine was asked for its switches after it was removed");
}
static void contacts_of_removed(const void *model, const double *x, double *force) {
    (void)model, (void)x, (void)force;
    fail_msg("a machine was asked for its contacts after it was removed");
}

/// Frees the rotor of a removed machine. Its system remains, with functions that fail the test when they are called.
static void machine_forbid(machine *own) {
    whirl_rotor_free(own->rotor);
    own->rotor = NULL;
    own->system.rhs = rhs_of_removed;
    own->system.rhs_on_sides = rhs_on_sides_of_removed;
    own->system.switches = switches_of_removed;
    own->system.contacts = contacts_of_removed;
}

static void machine_free(machine *own) {
    whirl_rotor_free(own->rotor);
    free(own);
}

// ---------------------------------------------------------------- ways to carry them

typedef struct way {
    const char *method;
    bool located;
    double damping; ///< of the contact: then normal forces are asked of the machine itself
} way;

static const way ways[] = {{"rk4", false, 0.0},     {"rk4", false, 0.3},    {"rk4", true, 0.0},
                           {"rk4", true, 0.3},      {"dop853", false, 0.0}, {"dop853", false, 0.3},
                           {"rodas5p", false, 0.0}, {"rodas5p", false, 0.3}};
static const char *const sets[] = {"scalar", "simd128", "fma", "avx2", "avx512"};
enum { WAYS = sizeof ways / sizeof *ways, SETS = sizeof sets / sizeof *sets };

/// Makes the ensemble; NULL if the processor lacks the instruction set.
static whirl_ensemble *ensemble_by(const way *by, const char *set, const whirl_system *system) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *lanes;
    strcpy(options.method, by->method);
    options.located = by->located;
    options.steps_per_revolution = 64;
    setenv("WHIRL_ISA", set, 1);
    const bool there = whirl_ensemble_new(system, &options, LANES, &lanes).code == WHIRL_OK;
    unsetenv("WHIRL_ISA");
    return there ? lanes : NULL;
}

static const double start[DIMENSION] = {0.1, -0.2, 0.0, 0.0};

static void revolve(whirl_ensemble *lanes, size_t count, int revolutions) {
    const whirl_ensemble_observe watch = {.extremes = true};
    for (int i = 0; i < revolutions; i++) whirl_ensemble_revolve(lanes, count, &watch);
}

/// Carries a machine without others in the lanes.
static void carry_alone(const way *by, const char *set, double eccentricity, int revolutions, double *x) {
    machine *own = machine_new(eccentricity, by->damping);
    whirl_ensemble *lanes = ensemble_by(by, set, &own->system);
    must(whirl_ensemble_load(lanes, 0, &own->system, start));
    revolve(lanes, 1, revolutions);
    whirl_ensemble_state(lanes, 0, x);
    whirl_ensemble_free(lanes);
    machine_free(own);
}

static void expect_same(const whirl_ensemble *lanes, size_t lane, const double *expected) {
    double x[DIMENSION];
    whirl_ensemble_state(lanes, lane, x);
    assert_memory_equal(x, expected, sizeof x);
}

static double eccentricity_of(size_t number) {
    return 0.9 + 0.02 * (double)number;
}

// ---------------------------------------------------------------- some are observed

/// Observes every third lane: the results are the same whether other lanes are observed or not, and so are the states.
static void observe_every_third(const way *by, const char *set) {
    machine *own[LANES];
    bool third[LANES];
    const whirl_ensemble_observe all = {.extremes = true}, some = {.extremes = true, .lanes = third};
    machine *structure = machine_new(1.0, by->damping);
    whirl_ensemble *ensembles[] = {ensemble_by(by, set, &structure->system), ensemble_by(by, set, &structure->system)};
    for (size_t i = 0; ensembles[0] && i < LANES; i++) {
        third[i] = i % 3 == 1;
        own[i] = machine_new(eccentricity_of(i), by->damping);
        for (int w = 0; w < 2; w++) must(whirl_ensemble_load(ensembles[w], i, &own[i]->system, start));
    }
    for (int n = 0; ensembles[0] && n < TOGETHER; n++) {
        whirl_ensemble_revolve(ensembles[0], LANES, &all);
        whirl_ensemble_revolve(ensembles[1], LANES, &some);
    }
    for (size_t i = 0; ensembles[0] && i < LANES; i++) {
        double x[DIMENSION], low[2][DIMENSION], share[2];
        whirl_ensemble_state(ensembles[0], i, x);
        expect_same(ensembles[1], i, x);
        for (int w = 0; w < 2; w++) {
            const whirl_ensemble_seen seen = {.low = low[w], .contact_share = &share[w]};
            whirl_ensemble_read(ensembles[w], i, &seen);
        }
        if (third[i]) assert_memory_equal(low[0], low[1], sizeof low[0]);
        if (third[i]) assert_true(low[0][0] < 0.0 && share[0] > 0.0 && share[0] == share[1]);
        machine_free(own[i]);
    }
    for (int w = 0; w < 2; w++) whirl_ensemble_free(ensembles[w]);
    machine_free(structure);
}

static void test_observed_lanes_are_independent(void **state) {
    (void)state;
    for (size_t w = 0; w < WAYS; w++)
        for (size_t s = 0; s < SETS; s++) observe_every_third(&ways[w], sets[s]);
}

// ---------------------------------------------------------------- machines leave

/// Frees the lanes one after the other: the last lane moves to the first place, whose machine is freed at once.
static void leave_one_by_one(const way *by, const char *set) {
    machine *own[LANES];
    size_t who[LANES];
    machine *structure = machine_new(1.0, by->damping);
    whirl_ensemble *lanes = ensemble_by(by, set, &structure->system);
    int revolutions = TOGETHER;
    for (size_t i = 0; lanes && i < LANES; i++) {
        who[i] = i;
        own[i] = machine_new(eccentricity_of(i), by->damping);
        must(whirl_ensemble_load(lanes, i, &own[i]->system, start));
    }
    if (lanes) revolve(lanes, LANES, TOGETHER);
    for (size_t used = LANES - 1; lanes && used > 0; used--, revolutions += ALONE) {
        double expected[DIMENSION];
        whirl_ensemble_move(lanes, used, 0);
        machine_forbid(own[who[0]]);
        who[0] = who[used];
        revolve(lanes, used, ALONE);
        carry_alone(by, set, eccentricity_of(who[0]), revolutions + ALONE, expected);
        expect_same(lanes, 0, expected);
    }
    if (lanes) {
        double expected[DIMENSION];
        whirl_ensemble_unload(lanes, 0);
        machine_forbid(own[who[0]]);
        must(whirl_ensemble_load(lanes, 1, &structure->system, start));
        revolve(lanes, 2, ALONE); // the first is empty
        carry_alone(by, set, 1.0, ALONE, expected);
        expect_same(lanes, 1, expected);
        for (size_t i = 0; i < LANES; i++) machine_free(own[i]);
    }
    whirl_ensemble_free(lanes);
    machine_free(structure);
}

static void test_removed_machines_are_not_evaluated(void **state) {
    (void)state;
    for (size_t set = 0; set < SETS; set++)
        for (size_t by = 0; by < WAYS; by++) leave_one_by_one(&ways[by], sets[set]);
}

static void test_a_machine_that_moves_nowhere_stays(void **state) {
    (void)state;
    machine *own = machine_new(1.0, 0.0);
    whirl_ensemble *lanes = ensemble_by(&ways[2], "scalar", &own->system);
    double expected[DIMENSION];
    must(whirl_ensemble_load(lanes, 0, &own->system, start));
    whirl_ensemble_move(lanes, 0, 0);
    revolve(lanes, 1, ALONE);
    carry_alone(&ways[2], "scalar", 1.0, ALONE, expected);
    expect_same(lanes, 0, expected);
    whirl_ensemble_free(lanes);
    machine_free(own);
}

/// The machines must have contacts: otherwise the ensemble would not call their functions.
static void test_the_rotor_rubs(void **state) {
    (void)state;
    machine *own = machine_new(eccentricity_of(0), 0.0);
    whirl_ensemble *lanes = ensemble_by(&ways[2], "scalar", &own->system);
    double begun;
    const whirl_ensemble_seen seen = {.contact_number = &begun};
    must(whirl_ensemble_load(lanes, 0, &own->system, start));
    revolve(lanes, 1, TOGETHER + ALONE);
    whirl_ensemble_read(lanes, 0, &seen);
    assert_true(begun >= TOGETHER + ALONE);
    whirl_ensemble_free(lanes);
    machine_free(own);
}

// ---------------------------------------------------------------- lanes that integrators carry

/// Observations of an integrator's motion, gathered by hand.
typedef struct gathered {
    const whirl_system *system;
    double low[DIMENSION], high[DIMENSION], sum, samples[4];
    double instants, closed, begun, force;
    bool touching;
} gathered;

static void gather(void *context, double t, const double *x) {
    gathered *g = context;
    double force;
    (void)t;
    for (int i = 0; i < DIMENSION; i++) {
        g->low[i] = fmin(g->low[i], x[i]);
        g->high[i] = fmax(g->high[i], x[i]);
    }
    g->system->contacts(g->system->model, x, &force);
    g->sum += x[0];
    if ((int)++g->instants % 16 == 0) g->samples[((int)g->instants / 16 - 1) % 4] = x[1];
    if (force > 0.0) {
        g->closed++;
        if (!g->touching) g->begun++;
    }
    g->force = fmax(g->force, force);
    g->touching = force > 0.0;
}

/// Samples of coordinate 1 of both lanes.
typedef struct sampled {
    const whirl_ensemble *ensemble;
    size_t count;
    double of[4][2];
} sampled;

static void sample_on_two_threads(void *context) {
    sampled *s = context;
    memcpy(s->of[s->count++], whirl_ensemble_coordinate(s->ensemble, 1), sizeof *s->of);
}

static void expect_gathered(const whirl_ensemble *lanes, size_t lane, const gathered *g) {
    double low[DIMENSION], high[DIMENSION], sum[2], closed, begun, force;
    const whirl_ensemble_seen seen = {.low = low,
                                      .high = high,
                                      .mean = sum,
                                      .contact_share = &closed,
                                      .contact_number = &begun,
                                      .contact_force = &force};
    whirl_ensemble_read(lanes, lane, &seen);
    assert_memory_equal(low, g->low, sizeof low);
    assert_memory_equal(high, g->high, sizeof high);
    assert_true(sum[0] == g->sum && closed == g->closed && begun == g->begun && force == g->force);
    assert_true(g->begun >= 1.0);
}

/// A motion after three revolutions, with its observations and, where one is followed, its perturbation.
typedef struct carried {
    double x[DIMENSION], vector[DIMENSION], growth;
    gathered seen;
} carried;

static void carry_by_integrator(const whirl_system *system, const whirl_integrate_options *options, size_t followed,
                                carried *out) {
    whirl_integrator *integrator;
    double force;
    *out = (carried){.vector = {1.0}, .seen = {.system = system}};
    for (int i = 0; i < DIMENSION; i++) out->seen.low[i] = INFINITY, out->seen.high[i] = -INFINITY;
    memcpy(out->x, start, sizeof out->x);
    system->contacts(system->model, start, &force);
    out->seen.touching = force > 0.0;
    must(whirl_integrator_new(system, options, &integrator));
    if (followed > 0) must(whirl_integrator_follow(integrator, followed));
    for (int i = 0; i < 3; i++) {
        whirl_perturbations set = {.count = 1, .vectors = out->vector, .growth = &out->growth};
        if (followed > 0)
            whirl_integrator_carry(integrator, out->x, &set, gather, &out->seen);
        else
            whirl_integrator_revolve(integrator, out->x, gather, &out->seen);
    }
    whirl_integrator_free(integrator);
}

static void carry_in_lanes(whirl_ensemble *lanes, size_t followed, sampled *samples, carried out[2]) {
    const whirl_ensemble_observe watch = {
        .extremes = true, .stride = 16, .sample = sample_on_two_threads, .context = samples};
    for (int i = 0; i < 3; i++) {
        whirl_perturbations beside[2];
        for (size_t l = 0; l < 2 && followed > 0; l++) {
            beside[l] = (whirl_perturbations){.count = 1, .vectors = out[l].vector, .growth = &out[l].growth};
            whirl_ensemble_carry(lanes, l, &beside[l]);
        }
        samples->count = 0;
        whirl_ensemble_revolve(lanes, 2, &watch);
        assert_int_equal(samples->count, 4);
    }
    for (size_t l = 0; l < 2; l++) whirl_ensemble_state(lanes, l, out[l].x);
}

/// Checks that three revolutions of two machines give the states and observations of an integrator, to the bit.
static void expect_lanes_of_integrators(const char *method, size_t followed) {
    machine *own[2] = {machine_new(eccentricity_of(0), 0.0), machine_new(eccentricity_of(1), 0.1)};
    whirl_integrate_options options = whirl_integrate_default();
    carried alone[2], found[2] = {{.vector = {1.0}}, {.vector = {1.0}}};
    whirl_ensemble *lanes;
    strcpy(options.method, method);
    options.steps_per_revolution = 64;
    must(whirl_ensemble_alone(&own[0]->system, &options, 2, followed, &lanes));
    assert_int_equal(whirl_ensemble_lanes(lanes), 2);
    for (size_t l = 0; l < 2; l++) must(whirl_ensemble_load(lanes, l, &own[l]->system, start));
    sampled samples = {.ensemble = lanes};
    carry_in_lanes(lanes, followed, &samples, found);
    for (size_t l = 0; l < 2; l++) {
        carry_by_integrator(&own[l]->system, &options, followed, &alone[l]);
        assert_memory_equal(found[l].x, alone[l].x, sizeof alone[l].x);
        assert_memory_equal(found[l].vector, alone[l].vector, sizeof alone[l].vector);
        assert_true(found[l].growth == alone[l].growth);
        expect_gathered(lanes, l, &alone[l].seen);
        for (int n = 0; n < 4; n++) assert_true(samples.of[n][l] == alone[l].seen.samples[n]);
    }
    // The second one moves into the lane of the first with all its observations, and continues there.
    whirl_ensemble_move(lanes, 1, 0);
    expect_gathered(lanes, 0, &alone[1].seen);
    whirl_ensemble_revolve(lanes, 2, NULL);
    assert_int_equal(whirl_ensemble_motion(lanes, 0), WHIRL_BOUNDED);
    whirl_ensemble_free(lanes);
    for (int l = 0; l < 2; l++) machine_free(own[l]);
}

static void test_lanes_of_integrators(void **state) {
    (void)state;
    expect_lanes_of_integrators("rk4", 0);
    expect_lanes_of_integrators("dop853", 1);
    expect_lanes_of_integrators("rodas5p", 0);
    expect_lanes_of_integrators("cvode-adams", 1);
}

/// A machine with other coordinates or contacts is refused.
static void test_lanes_of_integrators_have_one_shape(void **state) {
    (void)state;
    machine *own = machine_new(eccentricity_of(0), 0.0);
    const whirl_integrate_options options = whirl_integrate_default();
    whirl_system other = own->system;
    whirl_ensemble *lanes;
    other.contact_count = 0;
    must(whirl_ensemble_alone(&own->system, &options, 1, 0, &lanes));
    assert_int_equal(whirl_ensemble_load(lanes, 0, &other, start).code, WHIRL_BAD_INPUT);
    whirl_ensemble_free(lanes);
    machine_free(own);
}

// ---------------------------------------------------------------- parts of the period, with perturbations

enum { PARTS = 3, COLUMNS = DIMENSION * DIMENSION };

/// End of a part of the period: the state, the perturbations, the volume.
typedef struct flown {
    double x[DIMENSION], columns[COLUMNS], volume;
} flown;

static whirl_integrate_options exact_options(void) {
    whirl_integrate_options options = whirl_integrate_default();
    strcpy(options.method, "dop853");
    options.rtol = 1e-12;
    options.atol = 1e-14;
    return options;
}

static flown unit_at(const double *x) {
    flown from = {.volume = 0.0};
    memcpy(from.x, x, sizeof from.x);
    for (int i = 0; i < DIMENSION; i++) from.columns[i * (DIMENSION + 1)] = 1.0;
    return from;
}

/// Carries `count` states over parts of the period side by side, in place; false where there is no such set.
static bool carry_parts(const char *set, const whirl_system *system, size_t count, const double *from,
                        const double *length, flown *all) {
    const whirl_integrate_options options = exact_options();
    whirl_perturbations beside[LANES];
    whirl_ensemble *lanes;
    setenv("WHIRL_ISA", set, 1);
    const bool there = whirl_ensemble_flow(system, &options, count, DIMENSION, &lanes).code == WHIRL_OK;
    unsetenv("WHIRL_ISA");
    for (size_t i = 0; i < count && there; i++) {
        must(whirl_ensemble_load(lanes, i, system, all[i].x));
        whirl_ensemble_part(lanes, i, from[i], length[i]);
        beside[i] = (whirl_perturbations){.count = DIMENSION, .vectors = all[i].columns};
        whirl_ensemble_carry(lanes, i, &beside[i]);
    }
    if (!there) return false;
    whirl_ensemble_revolve(lanes, count, NULL);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(whirl_ensemble_motion(lanes, i), WHIRL_BOUNDED);
        whirl_ensemble_state(lanes, i, all[i].x);
        all[i].volume = beside[i].volume;
    }
    whirl_ensemble_free(lanes);
    return true;
}

/// Carries the machine over the whole period by an integrator.
static flown fly_by_integrator(const whirl_system *system, const double *x) {
    const whirl_integrate_options options = exact_options();
    whirl_integrator *integrator;
    flown own = unit_at(x);
    whirl_perturbations beside = {.count = DIMENSION, .vectors = own.columns};
    must(whirl_integrator_new(system, &options, &integrator));
    must(whirl_integrator_follow(integrator, DIMENSION));
    assert_int_equal(whirl_integrator_carry(integrator, own.x, &beside, NULL, NULL), WHIRL_BOUNDED);
    own.volume = beside.volume;
    whirl_integrator_free(integrator);
    return own;
}

static void expect_near(const flown *a, const flown *b) {
    for (int i = 0; i < DIMENSION; i++) assert_true(fabs(a->x[i] - b->x[i]) < 1e-10);
    for (int i = 0; i < COLUMNS; i++) assert_true(fabs(a->columns[i] - b->columns[i]) < 1e-8);
    assert_true(fabs(a->volume - b->volume) < 1e-9);
}

/// A rotor that rubs, with forces that jump and without, is carried in one lane over the whole period, and over its
/// parts one after the other.
static void test_parts_agree_with_integrators(void **state) {
    (void)state;
    for (int damped = 0; damped < 2; damped++) {
        machine *own = machine_new(eccentricity_of(0), 0.3 * damped);
        const double period = own->system.period, whole = 0.0;
        const double from[PARTS] = {0.0, 0.2 * period, 0.7 * period};
        const double length[PARTS] = {0.2 * period, 0.5 * period, 0.3 * period};
        const flown known = fly_by_integrator(&own->system, start);
        flown once = unit_at(start), parts = unit_at(start);
        assert_true(carry_parts("scalar", &own->system, 1, &whole, &period, &once));
        expect_near(&once, &known);
        for (int i = 0; i < PARTS; i++) {
            const double before = parts.volume;
            assert_true(carry_parts("scalar", &own->system, 1, &from[i], &length[i], &parts));
            parts.volume += before;
        }
        expect_near(&parts, &known);
        machine_free(own);
    }
}

/// Neighbours and, where multiply-adds are fused, widths change no bit.
static void test_parts_are_independent(void **state) {
    (void)state;
    machine *own = machine_new(eccentricity_of(0), 0.0);
    const double period = own->system.period, from[LANES] = {0.0, 1.0, 2.0, 3.0, 4.0};
    const double length[LANES] = {period, 0.3 * period, 0.2 * period, 0.5 * period, 0.1 * period};
    flown first[LANES];
    bool known = false;
    for (int set = 0; set < SETS; set++) {
        flown together[LANES];
        for (int i = 0; i < LANES; i++) together[i] = unit_at(start);
        if (!carry_parts(sets[set], &own->system, LANES, from, length, together)) continue;
        for (int i = 0; i < LANES; i++) {
            flown alone = unit_at(start);
            assert_true(carry_parts(sets[set], &own->system, 1, &from[i], &length[i], &alone));
            assert_memory_equal(&alone, &together[i], sizeof alone);
        }
        if (set >= 2 && known) assert_memory_equal(first, together, sizeof first);
        if (set >= 2) memcpy(first, together, sizeof first);
        known = known || set >= 2;
    }
    machine_free(own);
}

/// The method rodas5p carries parts of a period in lanes without perturbations, and reaches the state of dop853. Other
/// methods refuse parts.
static void test_parts_by_other_methods(void **state) {
    (void)state;
    machine *own = machine_new(eccentricity_of(0), 0.3);
    whirl_integrate_options options = exact_options();
    const double period = own->system.period;
    const flown known = fly_by_integrator(&own->system, start);
    double x[DIMENSION];
    whirl_ensemble *lanes;
    assert_int_equal(whirl_ensemble_flow(&own->system, &options, 1, DIMENSION + 1, &lanes).code, WHIRL_BAD_INPUT);
    strcpy(options.method, "rk4");
    assert_int_equal(whirl_ensemble_flow(&own->system, &options, 1, 0, &lanes).code, WHIRL_BAD_INPUT);
    strcpy(options.method, "rodas5p");
    assert_false(whirl_ensemble_flows(&own->system, &options));
    assert_int_equal(whirl_ensemble_flow(&own->system, &options, 1, 1, &lanes).code, WHIRL_BAD_INPUT);
    must(whirl_ensemble_flow(&own->system, &options, 1, 0, &lanes));
    must(whirl_ensemble_load(lanes, 0, &own->system, start));
    for (int part = 0; part < 2; part++) {
        whirl_ensemble_part(lanes, 0, part * 0.4 * period, (0.4 + 0.2 * part) * period);
        whirl_ensemble_revolve(lanes, 1, NULL);
        assert_int_equal(whirl_ensemble_motion(lanes, 0), WHIRL_BOUNDED);
    }
    whirl_ensemble_state(lanes, 0, x);
    for (int i = 0; i < DIMENSION; i++) assert_true(fabs(x[i] - known.x[i]) < 1e-9);
    whirl_ensemble_free(lanes);
    machine_free(own);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_rotor_rubs),
        cmocka_unit_test(test_observed_lanes_are_independent),
        cmocka_unit_test(test_removed_machines_are_not_evaluated),
        cmocka_unit_test(test_a_machine_that_moves_nowhere_stays),
        cmocka_unit_test(test_lanes_of_integrators),
        cmocka_unit_test(test_lanes_of_integrators_have_one_shape),
        cmocka_unit_test(test_parts_agree_with_integrators),
        cmocka_unit_test(test_parts_are_independent),
        cmocka_unit_test(test_parts_by_other_methods),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
