// Residual unbalance of a balance quality grade, on two planes.
#define KERNEL_FILE "elements/loads/unbalance_grade_kernel.h"
#define KERNEL_AXES 4
#define KERNEL_STATES 0
#define KERNEL_NUMBERS RESIDUAL_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_PHASED 1

/// Numbers: newtons by cos tau and by sin tau, along x and y of the first plane, then of the second; unbalances in
/// total, in the first and in the second plane, kg m.
enum { RESIDUAL_FORCES, RESIDUAL_MOMENTS = 2 * KERNEL_AXES, RESIDUAL_NUMBERS = RESIDUAL_MOMENTS + 3 };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(unbalance_grade_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

enum { PLANES, GRADE, SERVICE_SPEED, MASS, TO_FIRST, TO_SECOND, ANGLE, SECOND_ANGLE, FACTOR, KEY_COUNT };

#define STANDARD "ISO 21940-11"

static const whirl_key keys[KEY_COUNT] = {
    [PLANES] = STATIONS_KEY("planes", REQUIRED, "the two stations of the planes that share the unbalance"),
    [GRADE] = CITED_NUMBER_KEY("grade", "G", "mm/s", REQUIRED, WHIRL_POSITIVE,
                               "balance quality grade G: speed of the centre of mass, 2.5 for G 2.5", STANDARD),
    [SERVICE_SPEED] = CITED_NUMBER_KEY("service_speed", "Omega", "rad/s", REQUIRED, WHIRL_POSITIVE,
                                       "largest speed in service, independent of the rotor's speed", STANDARD),
    [MASS] = NUMBER_KEY("mass", "m", "kg", OPTIONAL, WHIRL_POSITIVE,
                        "mass of the rotor; absent: that of the shaft of finite elements with the planes, and of its "
                        "discs and stations"),
    [TO_FIRST] = NUMBER_KEY(
        "to_first", "L_A", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
        "distance from the centre of mass to the first plane; absent: computed from the shaft of finite elements"),
    [TO_SECOND] = NUMBER_KEY("to_second", "L_B", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                             "distance from the centre of mass to the second plane, on its other side"),
    [ANGLE] = ANGLE_KEY("angle", "beta", NULL,
                        "position of the unbalance in the first plane at t = 0, from the x axis towards y"),
    [SECOND_ANGLE] = NUMBER_KEY("second_angle", "", "rad", OPTIONAL, WHIRL_ANY,
                                "position in the second plane; absent: as in the first"),
    [FACTOR] = NUMBER_KEY("factor", "", "1", DEFAULT("1"), WHIRL_NOT_NEGATIVE,
                          "share of the allowed unbalance that the rotor has"),
};

/// Computes mass and centre of a shaft, by exact moments of the distributed mass.
static void weigh(const assembly *of, size_t shaft, double *mass, double *centre) {
    double moment = 0.0;
    *mass = 0.0;
    for (size_t s = 0; s < of->station_count; s++) {
        const assembly_station *at = &of->stations[s];
        if (at->shaft != shaft) continue;
        *mass += at->mass;
        moment += at->mass * at->position + at->pull_moment;
    }
    *centre = moment / *mass;
}

/// Computes the mass, and the distances of its centre from both planes, above 0 outwards.
static whirl_status measure(const key_value *values, const assembly *to, double *mass, double distance[2]) {
    // The planes must be on one shaft of finite elements, or mass and distances must be given.
    const assembly_station *one = &to->stations[values[PLANES].station[0]],
                           *other = &to->stations[values[PLANES].station[1]];
    const bool meshed = one->shaft != NO_SHAFT && one->shaft == other->shaft;
    const bool given = values[TO_FIRST].given && values[TO_SECOND].given;
    double centre = 0.0;
    if (values[TO_FIRST].given != values[TO_SECOND].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has one of to_first and to_second, expected both or neither");
    if (!meshed && !(given && values[MASS].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has planes that do not lie on one shaft of finite elements, expected mass, "
                                           "to_first and to_second as well");
    if (meshed) weigh(to, one->shaft, mass, &centre);
    if (values[MASS].given) *mass = values[MASS].number;
    // Compute the distances, outwards.
    const double way = one->position < other->position ? 1.0 : -1.0;
    distance[0] = given ? values[TO_FIRST].number : way * (centre - one->position);
    distance[1] = given ? values[TO_SECOND].number : way * (other->position - centre);
    if (!(distance[0] >= 0.0 && distance[1] >= 0.0 && distance[0] + distance[1] > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has its centre of mass %g m from the first and %g m from the second plane, expected it "
                          "between them",
                          distance[0], distance[1]);
    return whirl_ok();
}

static whirl_status unbalance_grade_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[] = {AXIS_X, AXIS_Y};
    double mass = 0.0, distance[2] = {0.0, 0.0};
    const size_t *plane = values[PLANES].station;
    if (plane[0] == GROUND || plane[1] == GROUND || plane[0] == plane[1])
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected two stations",
                          plane[0] == plane[1] ? "both planes at one station" : "a plane on the ground");
    whirl_status status = measure(values, to, &mass, distance);
    if (status.code == WHIRL_OK) status = element_between(&values[PLANES], to, axes, 2, out);
    if (status.code != WHIRL_OK) return status;
    const double all = values[FACTOR].number * 1e-3 * values[GRADE].number * mass / values[SERVICE_SPEED].number;
    // A plane's share is the distance of the other plane from the centre of mass, divided by the sum of both distances,
    // and limited to .3 to .7.
    const double share = fmin(fmax(distance[1] / (distance[0] + distance[1]), 0.3), 0.7);
    double *moment = out->number + RESIDUAL_MOMENTS;
    moment[0] = all;
    moment[1] = share * all;
    moment[2] = (1.0 - share) * all;
    for (size_t i = 0; i < 2; i++) {
        const double force = to->balanced ? 0.0 : moment[1 + i] * to->speed * to->speed;
        const double angle = values[i == 1 && values[SECOND_ANGLE].given ? SECOND_ANGLE : ANGLE].number;
        double *own = out->number + RESIDUAL_FORCES + 4 * i;
        own[0] = own[3] = force * cos(angle);
        own[2] = force * sin(angle);
        own[1] = -own[2];
        if (!to->balanced) assembly_inertial(to, out->port[2 * i], out->port[2 * i + 1], moment[1 + i], angle);
    }
    generic_scale(out, to, 1.0);
    return status;
}

static void unbalance_grade_note(const element *own, double length, double clock, char *text, size_t size) {
    const double *of = own->number + RESIDUAL_MOMENTS;
    (void)length, (void)clock;
    snprintf(text, size,
             "by ISO 21940-11 (check which edition counts) %.12g g mm in all, %.12g in the first plane, %.12g in the "
             "second",
             1e6 * of[0], 1e6 * of[1], 1e6 * of[2]);
}

KERNELS_OF_EVERY_ISA(unbalance_grade_kernels);

const element_type unbalance_grade_element = {
    .group = {"unbalance_grade", "unbalance that a balance quality grade allows, on two planes", STANDARD, keys,
              KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = unbalance_grade_build,
    .note = unbalance_grade_note,
};
#endif
