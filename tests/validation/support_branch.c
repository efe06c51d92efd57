#include "support_branch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_check.h"

static whirl_status make_machine(const void *context, double value, whirl_machine *machine) {
    test_family *own = malloc(sizeof *own);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    *own = *(const test_family *)context;
    own->p[own->varied] = value;
    own->system.model = own->p;
    *machine = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

whirl_family family_of(const test_family *family) {
    return (whirl_family){make_machine, family};
}

static void release_rotor(void *rotor) {
    whirl_rotor_free(rotor);
}

static whirl_status make_rotor(const void *context, double value, whirl_machine *machine) {
    const case_family *family = context;
    whirl_rotor *rotor;
    const whirl_status status = whirl_case_rotor(family->object, family->parameter, value, &rotor);
    if (status.code != WHIRL_OK) return status;
    *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release_rotor};
    return whirl_ok();
}

whirl_family family_of_case(const case_family *family) {
    return (whirl_family){make_rotor, family};
}

whirl_system system_of(const test_family *family) {
    whirl_system system = family->system;
    system.model = family->p;
    return system;
}

whirl_orbit *find_orbit(const test_family *family, size_t revolutions, const whirl_orbit_options *options) {
    const whirl_system system = system_of(family);
    whirl_orbit *orbit = NULL;
    require_ok(whirl_orbit_find(&system, family->start, revolutions, options, &orbit));
    return orbit;
}

whirl_branch *follow_branch(const test_family *family, const whirl_orbit *start, int direction,
                            const whirl_branch_options *options) {
    const whirl_family machines = family_of(family);
    whirl_branch *branch = NULL;
    require_ok(whirl_branch_follow(&machines, start, family->p[family->varied], direction, options, &branch));
    return branch;
}

const whirl_branch_point *special_point(const whirl_branch *branch, whirl_special kind, size_t which) {
    for (size_t i = 0; i < branch->count; i++)
        if (branch->points[i].special == kind && which-- == 0) return &branch->points[i];
    return NULL;
}

size_t count_special(const whirl_branch *branch, whirl_special kind) {
    size_t count = 0;
    for (size_t i = 0; i < branch->count; i++) count += branch->points[i].special == kind;
    return count;
}

const char *special_word(whirl_special special) {
    switch (special) {
    case WHIRL_FOLD:
        return "fold";
    case WHIRL_DOUBLING:
        return "doubling";
    case WHIRL_NEIMARK_SACKER:
        return "Neimark-Sacker";
    case WHIRL_GRAZE:
        return "touch";
    default:
        return "other";
    }
}

double sum_of_logarithms(const whirl_orbit *orbit) {
    double sum = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        sum += log(hypot(orbit->multipliers[i].real, orbit->multipliers[i].imaginary));
    return sum;
}

typedef struct test_plane {
    const test_family *family;
    size_t other;
} test_plane;

static whirl_status make_in_plane(const void *context, double value, double second, whirl_machine *machine) {
    const test_plane *plane = context;
    test_family own = *plane->family;
    own.p[plane->other] = second;
    return make_machine(&own, value, machine);
}

whirl_branch *follow_curve(const test_family *family, size_t other, const whirl_branch_point *start, int direction,
                           double low, double high, const whirl_branch_options *options) {
    const test_plane plane = {family, other};
    const whirl_plane machines = {make_in_plane, &plane};
    const double bounds[2] = {low, high};
    whirl_branch *curve = NULL;
    require_ok(whirl_curve_follow(&machines, start, family->p[other], direction, bounds, options, &curve));
    return curve;
}
