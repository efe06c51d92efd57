// Jacobians for implicit methods, for the machines of all shipped cases, which have every element. Their sparsity
// contains every nonzero entry of the exact Jacobian, and kernels find the same Jacobian from unit perturbations that
// they know as such.
#include "case_support.h"

#include <math.h>

#include "isa.h"
#include "lanes.h"
#include "vector.h"
#include "whirl/engine/study.h"

/// Returns a number from -0.4 to 0.4 (xorshift, Marsaglia 2003).
static double draw(uint64_t *seed) {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return 0.8 * ((double)(*seed >> 11) * 0x1p-53 - 0.5);
}

/// Compares with the Jacobian at some states, far out and near; gives how many entries can never differ from zero.
static size_t compare(const char *name, const whirl_system *system) {
    enum { STATES = 40 };
    const size_t n = system->dimension, degrees = system->lanes->degrees, rates = n - degrees;
    bool *table = calloc(rates * n, sizeof *table);
    double *x = calloc(n * (2 * n + 1), sizeof *x), *unit = x + n, *column = unit + n * n, forcing[WHIRL_MAX_FORCING];
    uint64_t seed = 88172645463325252u;
    size_t zeros = 0;
    assert_true(table && x);
    system->lanes->depends(system->model, table);
    for (size_t i = 0; i < n; i++) unit[i * n + i] = 1.0;
    for (int s = 0; s < STATES; s++) {
        const double t = 0.157 * s, size = s % 2 ? 1.0 : 4.0; // of which contacts are open and closed
        for (size_t i = 0; i < n; i++) x[i] = size * draw(&seed);
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        system->tangent(system->model, t, forcing, x, NULL, n, unit, column);
        for (size_t j = 0; j < n; j++)
            for (size_t i = 0; i < rates; i++)
                if (!table[i * n + j] && column[j * n + degrees + i] != 0.0 && isfinite(column[j * n + degrees + i]))
                    fail_msg("%s: rate %zu depends on coordinate %zu", name, i, j);
    }
    for (size_t i = 0; i < rates * n; i++) zeros += !table[i];
    free(table);
    free(x);
    return zeros;
}

/// Compares the Jacobian from perturbations that kernels know as unit ones with that from the same perturbations as any
/// vectors, by one instruction set.
static void compare_units(const char *name, const whirl_system *system, size_t set, size_t lanes) {
    enum { STATES = 6 };
    const whirl_lanes *form = system->lanes;
    const size_t n = system->dimension, degrees = form->degrees, rates = n - degrees, sets = 1 + n;
    const size_t rows = form->number_count + sets * (degrees + 3 * rates) + 2 * system->forcing_count + 2;
    double *block = aligned_alloc(64, (rows * lanes * sizeof(double) + 63) / 64 * 64), *numbers = block;
    double *q = numbers + form->number_count * lanes, *v = q + sets * degrees * lanes, *a = v + sets * rates * lanes;
    double *b = a + sets * rates * lanes, *forcing = b + sets * rates * lanes;
    double *time = forcing + system->forcing_count * lanes, *own = calloc(form->number_count + 1, sizeof *own);
    size_t *columns = calloc(n, sizeof *columns);
    uint64_t seed = 88172645463325252u;
    assert_true(block && own && columns);
    memset(block, 0, rows * lanes * sizeof *block);
    form->numbers(system->model, own);
    for (size_t i = 0; i < form->number_count * lanes; i++) numbers[i] = own[i / lanes];
    for (size_t c = 0; c < n; c++) columns[c] = c;
    for (size_t i = 0; i < degrees * lanes; i++) q[(1 + i / lanes) * degrees * lanes + i] = 1.0;
    for (size_t i = 0; i < rates * lanes; i++) v[(1 + degrees + i / lanes) * rates * lanes + i] = 1.0;
    for (int s = 0; s < STATES; s++) {
        const double size = s % 2 ? 1.0 : 4.0;
        for (size_t i = 0; i < degrees * lanes; i++) q[i] = size * draw(&seed);
        for (size_t i = 0; i < rates * lanes; i++) v[i] = size * draw(&seed);
        for (size_t l = 0; l < lanes; l++) time[l] = 0.9 * s + 0.1 * (double)l;
        form->forcing[set](system->model, 1, 1, time, forcing);
        lanes_view view = {.model = system->model,
                           .stride = 1,
                           .vectors = 1,
                           .numbers = numbers,
                           .forcing = forcing,
                           .tangents = n,
                           .q = q,
                           .v = v,
                           .a = a};
        form->flow[set](&view);
        view.columns = columns;
        view.a = b;
        form->flow[set](&view);
        // Numbers of one column are sums of the same terms, in another order.
        for (size_t c = 0; c < sets; c++) {
            double largest = 0.0;
            for (size_t i = 0; i < rates * lanes; i++) {
                const double one = a[c * rates * lanes + i];
                if (isfinite(one)) largest = fmax(largest, fabs(one));
            }
            for (size_t i = 0; i < rates * lanes; i++) {
                const double one = a[c * rates * lanes + i], other = b[c * rates * lanes + i];
                if (isfinite(one) && !(fabs(one - other) <= 1e-13 * largest))
                    fail_msg("%s, set %zu: rate %zu by coordinate %zu is %.17g, and %.17g from a unit perturbation",
                             name, set, i / lanes, c, one, other);
            }
        }
    }
    free(block);
    free(own);
    free(columns);
}

static size_t compare_case(const char *name, whirl_case *object) {
    whirl_study study;
    whirl_machine machine;
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    const whirl_batch *batch = &study.batches[0];
    assert_int_equal(study.machine(study.family, batch, batch->values ? batch->values[0] : 0.0, &machine).code,
                     WHIRL_OK);
    const size_t zeros = compare(name, machine.system);
    for (int set = 0; set < VECTOR_ISAS; set++)
        if (isa_at(set)) compare_units(name, machine.system, (size_t)set, isa_at(set)->lanes);
    machine.release(machine.owner);
    whirl_case_free(object);
    return zeros;
}

static void cases_that_ship(void **state) {
    (void)state;
    static const char *const names[] = {
        "reference",     "paper",          "jeffcott-rub",   "rigid-rotor",  "cracked-rotor",  "seal-whirl",
        "ball-bearings", "squeeze-damper", "loose-pedestal", "second-shaft", "overhung-rotor", "compressor",
        "spindle",       "bearing-fault",  "magnetic-drop",  "pump",         "misalignment",   "tilting-pad-table"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[400];
        whirl_case *object;
        snprintf(path, sizeof path, "%s/%s.yaml", WHIRL_CASES, names[i]);
        assert_int_equal(whirl_case_load(path, NULL, &object).code, WHIRL_OK);
        const size_t zeros = compare_case(names[i], object);
        if (i == 0) assert_true(zeros > 0); // with many stations some entries are zero
    }
}

static void a_phase_of_the_shaft(void **state) {
    (void)state;
    compare_case("phase", parse_edited("    - gravity: 9.81 m/s2\n",
                                       "    - gravity: 9.81 m/s2\n"
                                       "    - force: {at: disc, amplitude: 1 N, frequency: 31 Hz, keyphasor: yes}\n"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(cases_that_ship), cmocka_unit_test(a_phase_of_the_shaft)};
    return cmocka_run_group_tests_name("depends", tests, NULL, NULL);
}
