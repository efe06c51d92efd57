// The film of a short journal bearing: its pass over vectors, its keys and the numbers of its kernel.
#include "block.h"
#include "doubts.h"
#include "film_tangent.h"
#include "oil.h"
#include "registry.h"
#include "whirl/rotor.h"

/// What a film adds to vector k and its perturbations.
static void finish(const element *own, const block *b, size_t k, const film_state *film) {
    const vec *number = numbers_of(b, own) + k, strength = number[FILM_STRENGTH * b->stride];
    tangent_block tangent;
    film_add(film, strength, &b->a[own->port[0] * b->stride + k], &b->a[own->port[1] * b->stride + k]);
    if (!wants_tangent(b)) return;
    film_tangent(film, strength, number[FILM_TWICE * b->stride], &tangent);
    tangent_apply(&tangent, own, b, k);
}

/// Three vectors are in films at a time, one in each phase: the vectors of one film after those of the other.
static void flow(const element *first, size_t count, const block *b) {
    const element *begun = first, *ended = first;
    const size_t all = count * b->vectors;
    film_work work;
    for (size_t i = 0, k = 0, last = 0; i < all + 2; i++) {
        if (i < all) {
            const vec *number = numbers_of(b, begun) + k;
            film_begin(begun, b->stride, number, number[FILM_TWICE * b->stride], b->q + k, b->v + k, &work,
                       i % FILM_PLACES);
            if (++k == b->vectors) begun++, k = 0;
        }
        if (i >= 1 && i <= all) film_divide(&work, (i - 1) % FILM_PLACES);
        if (i < 2) continue;
        const vec quarter = numbers_of(b, ended)[FILM_QUARTER * b->stride + last];
        const film_state film = film_end(&work, (i - 2) % FILM_PLACES, quarter);
        finish(ended, b, last, &film);
        if (++last == b->vectors) ended++, last = 0;
    }
}

const element_kernels ISA(film_kernels) = {.flow = flow};

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, COUNT, LAW, CLEARANCE, LOAD, VISCOSITY, KINEMATIC, DENSITY, RADIUS, LENGTH, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the journal"),
    [COUNT] = WHOLE_KEY("count", "", DEFAULT("1"), WHIRL_FROM_TO(1, 1000), "equal bearings that carry this station"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("capone"), "capone",
                             "capone: short bearing, film over half the circumference", "Capone 1991"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance"),
    [LOAD] = CITED_NUMBER_KEY("load", "F0", "N", OPTIONAL, WHIRL_NOT_NEGATIVE,
                              "scale F0 of the film force of one bearing, in place of viscosity, radius and length",
                              "Capone 1991"),
    [VISCOSITY] = OIL_DYNAMIC("dynamic viscosity of the oil"),
    [KINEMATIC] = OIL_KINEMATIC,
    [DENSITY] = OIL_DENSITY,
    [RADIUS] = NUMBER_KEY("radius", "R", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the journal"),
    [LENGTH] = NUMBER_KEY("length", "L", "m", OPTIONAL, WHIRL_POSITIVE, "length of the bearing"),
};

static oil oil_of(const key_value *values) {
    return (oil){&values[VISCOSITY], &values[KINEMATIC], &values[DENSITY]};
}

static whirl_status load_scale(const key_value *values, double speed, double *load) {
    const oil own = oil_of(values);
    const bool viscous = values[VISCOSITY].given || values[KINEMATIC].given;
    double viscosity = 0.0;
    if (values[LOAD].given && (viscous || values[DENSITY].given || values[RADIUS].given || values[LENGTH].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has both load and viscosity, radius or length, expected one way");
    *load = values[LOAD].number;
    if (values[LOAD].given) return whirl_ok();
    if (!viscous || !values[RADIUS].given || !values[LENGTH].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has no complete film strength, expected load, or viscosity, radius and length");
    const whirl_status status = oil_viscosity(&own, &viscosity);
    const double length = values[LENGTH].number, clearance = values[CLEARANCE].number;
    *load = viscosity * speed * values[RADIUS].number * length * length * length / (4.0 * clearance * clearance);
    return status;
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    double load = 0.0;
    whirl_status status = load_scale(values, to->speed, &load);
    out->station = values[AT].station[0];
    out->law = values[LAW].choice;
    if (status.code == WHIRL_OK) status = assembly_find_plane(to, out->station, out->port);
    if (status.code != WHIRL_OK) return status;
    const double clearance = values[CLEARANCE].number / to->length, square = clearance * clearance;
    out->number[FILM_CLEARANCE] = clearance;
    out->number[FILM_CLEARANCE_SQUARE] = square;
    out->number[FILM_STRENGTH] =
        FILM_STRENGTH_OF_1 * square * values[COUNT].number * load / assembly_force_scale(to, out->port[0]);
    out->number[FILM_TWICE] = 2.0 / to->turn;
    out->number[FILM_QUARTER] = copysign(1.57079632679489661923, to->turn);
    return whirl_ok();
}

static void doubt(const key_value *values, double speed, const doubt_teller *to) {
    const oil own = oil_of(values);
    const double radius = values[RADIUS].number, clearance = values[CLEARANCE].number;
    if (!values[RADIUS].given) return;
    doubt_length(to, values[LENGTH].number, radius);
    doubt_clearance(to, clearance, radius);
    // Between cylinders, rho omega R c/mu up to which there are no vortices: Taylor 1923.
    const double reynolds = oil_reynolds(&own, speed, sqrt(radius * clearance)), most = 41.2 * sqrt(radius / clearance);
    if (reynolds > most)
        doubt_value(to, keys[DENSITY].name,
                    "is so high that the flow is not laminar, as the law has it: Reynolds number %.3g, up to %.3g",
                    reynolds, most);
}

static double bearing_clearance(const element *own) {
    return own->number[FILM_CLEARANCE];
}

void whirl_film_force(double x, double y, double vx, double vy, double force[2]) {
    film_work work;
    force[0] = force[1] = 0.0;
    film_place(&work, 0, 1.0, x, y, x - 2.0 * vy, y + 2.0 * vx);
    film_divide(&work, 0);
    const film_state film = film_end(&work, 0, 1.57079632679489661923);
    film_add(&film, FILM_STRENGTH_OF_1, &force[0], &force[1]);
}

KERNELS_OF_EVERY_ISA(film_kernels);

const element_type film_element = {
    .group = {"film", "the oil film of a short journal bearing", "Capone 1991", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = FILM_NUMBERS,
    .kernels = kernels,
    .build = build,
    .carries = true,
    .bearing_clearance = bearing_clearance,
    .doubt = doubt,
};
#endif
