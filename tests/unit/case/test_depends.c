// The sparsity that machines report to implicit methods contains every nonzero entry of the exact Jacobian, for the
// machines of all shipped cases, which have every element.
#include "case_support.h"

#include <math.h>

#include "lanes.h"
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

static size_t compare_case(const char *name, whirl_case *object) {
    whirl_study study;
    whirl_machine machine;
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    const whirl_batch *batch = &study.batches[0];
    assert_int_equal(study.machine(study.family, batch, batch->values ? batch->values[0] : 0.0, &machine).code,
                     WHIRL_OK);
    const size_t zeros = compare(name, machine.system);
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
