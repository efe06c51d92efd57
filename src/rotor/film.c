// The keys of a short journal bearing's film, and the numbers of its kernel.
#define VECTOR_ISA 0
#include "film_kernel.h"
#include "whirl/rotor.h"

enum { AT, COUNT, LAW, CLEARANCE, LOAD, VISCOSITY, RADIUS, LENGTH, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station of the journal", ""},
    [COUNT] = {"count",
               "",
               "1",
               WHIRL_KEY_WHOLE,
               false,
               "1",
               {1, 1000, false, false},
               NULL,
               "equal bearings that carry this station",
               ""},
    [LAW] = {"law", "", "", WHIRL_KEY_CHOICE, false, "capone", WHIRL_ANY, "capone",
             "capone: short bearing, film over half the circumference", "Capone 1991"},
    [CLEARANCE] = {"clearance", "c", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL, "radial clearance", ""},
    [LOAD] = {"load", "F0", "N", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
              "scale F0 of the film force of one bearing, in place of viscosity, radius and length", "Capone 1991"},
    [VISCOSITY] = {"viscosity", "mu", "Pa s", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,
                   "dynamic viscosity of the oil", ""},
    [RADIUS] = {"radius", "R", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL, "radius of the journal", ""},
    [LENGTH] = {"length", "L", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL, "length of the bearing", ""},
};

static whirl_status load_scale(const key_value *values, double speed, double *load) {
    const bool design = values[VISCOSITY].given || values[RADIUS].given || values[LENGTH].given;
    if (values[LOAD].given && design)
        return whirl_fail(WHIRL_BAD_INPUT, "has both load and viscosity, radius or length, expected one way");
    *load = values[LOAD].number;
    if (values[LOAD].given) return whirl_ok();
    if (!values[VISCOSITY].given || !values[RADIUS].given || !values[LENGTH].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has no complete film strength, expected load, or viscosity, radius and length");
    const double length = values[LENGTH].number, clearance = values[CLEARANCE].number;
    *load = values[VISCOSITY].number * speed * values[RADIUS].number * length * length * length /
            (4.0 * clearance * clearance);
    return whirl_ok();
}

static whirl_status build(const key_value *values, const scales *scale, element *out) {
    double load = 0.0;
    const whirl_status status = load_scale(values, scale->speed, &load);
    if (status.code != WHIRL_OK) return status;
    const size_t station = values[AT].station[0];
    out->station[0] = station;
    out->law = values[LAW].choice;
    const double clearance = values[CLEARANCE].number / scale->length, square = clearance * clearance;
    out->number[FILM_CLEARANCE] = clearance;
    out->number[FILM_CLEARANCE_SQUARE] = square;
    out->number[FILM_STRENGTH] =
        FILM_STRENGTH_OF_1 * square * values[COUNT].number * load / (stiffness_scale(scale, station) * scale->length);
    return whirl_ok();
}

static double bearing_clearance(const element *own) {
    return own->number[FILM_CLEARANCE];
}

void whirl_film_force(double x, double y, double vx, double vy, double force[2]) {
    film_work work;
    force[0] = force[1] = 0.0;
    film_place(&work, 0, 1.0, x, y, x - 2.0 * vy, y + 2.0 * vx);
    film_divide(&work, 0);
    const film_state film = film_end(&work, 0);
    film_add(&film, FILM_STRENGTH_OF_1, &force[0], &force[1]);
}

const element_type film_element = {
    .group = {"film", "the oil film of a short journal bearing", "Capone 1991", keys, KEY_COUNT, NULL},
    .kernel = KERNEL_FILM,
    .number_count = FILM_NUMBERS,
    .build = build,
    .bearing_clearance = bearing_clearance,
};
