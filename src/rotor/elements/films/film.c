// The film of a journal bearing: the pass over vectors for short films on the ground, the keys, and the numbers of the
// kernels. film_finite.c has the pass for all other films.
#include "doubts.h"
#include "film_flow.h"
#include "film_ratio.h"
#include "film_tangent.h"
#include "oil.h"
#include "registry.h"
#include "whirl/engine/rotor.h"

/// Begin a film on the ground, and finish it: the first and the last phase.
static inline void begin(const element *own, const block *b, size_t k, film_work *work, size_t at) {
    const vec *number = numbers_of(b, own) + k;
    film_begin(own, b->stride, number, number[FILM_TWICE * b->stride], b->q + k, b->v + k, work, at);
}

static inline void film_finish(const element *own, const block *b, size_t k, const film_state *film) {
    const vec *number = numbers_of(b, own) + k, strength = number[FILM_STRENGTH * b->stride];
    tangent_block tangent;
    film_add(film, strength, &b->a[own->port[0] * b->stride + k], &b->a[own->port[1] * b->stride + k]);
    if (!wants_tangent(b)) return;
    film_tangent(film, strength, number[FILM_TWICE * b->stride], &tangent);
    tangent_apply(&tangent, own, b, k);
}

static void film_element_flow(const element *first, size_t count, const block *b) {
    film_flow(first, count, b, begin, film_finish);
}

const element_kernels ISA(film_kernels) = {.flow = film_element_flow};

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "turbulence.h"

enum {
    AT,
    FROM,
    COUNT,
    LAW,
    CLEARANCE,
    LOAD,
    OIL,
    TURBULENCE = OIL + OIL_KEYS,
    RADIUS,
    LENGTH,
    JOURNAL_RATIO,
    HOUSING_RATIO,
    KEY_COUNT
};
enum { CAPONE, SHORT, FINITE };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the journal"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [COUNT] = WHOLE_KEY("count", "", DEFAULT("1"), WHIRL_FROM_TO(1, 1000), "number of equal bearings at this station"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("capone"), "capone|short|finite",
                             "capone, short: short bearing, film over half the circumference; finite: Reynolds' "
                             "equation for L/D of .1 to 2, without negative pressures",
                             "Capone 1991; Reynolds 1886"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance"),
    [LOAD] = CITED_NUMBER_KEY("load", "F0", "N", OPTIONAL, WHIRL_NOT_NEGATIVE,
                              "scale F0 of the film force of one bearing, in place of viscosity, radius and length",
                              "Capone 1991"),
    OIL_ROWS(OIL, "dynamic viscosity of the oil"),
    [TURBULENCE] = CITED_CHOICE_KEY(
        "turbulence", DEFAULT("none"), "none|ng-pan|constantinescu",
        "turbulence factors of the film, for one Reynolds number, that of the clearance; needs density, radius, length",
        "Ng, Pan 1965; Constantinescu 1962"),
    [RADIUS] = NUMBER_KEY("radius", "R", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the journal"),
    [LENGTH] = NUMBER_KEY("length", "L", "m", OPTIONAL, WHIRL_POSITIVE, "length of the bearing"),
    [JOURNAL_RATIO] = NUMBER_KEY("journal_ratio", "", "1", OPTIONAL, WHIRL_ANY,
                                 "speed of the journal over the rotor's; absent: that of its shaft, 1 without one"),
    [HOUSING_RATIO] = NUMBER_KEY("housing_ratio", "", "1", OPTIONAL, WHIRL_ANY,
                                 "speed of the housing over the rotor's; absent: that of its shaft, 0 without one"),
};

static oil oil_of(const key_value *values) {
    return (oil){&values[OIL]};
}

/// Speeds that determine a film, as ratios to the rotor's: the sum of the speeds of journal and housing draws oil in,
/// their difference shears it.
typedef struct turning {
    double wedge, shear;
} turning;

static whirl_status find_turning(const key_value *values, const assembly *to, turning *out) {
    const double own =
        values[JOURNAL_RATIO].given ? values[JOURNAL_RATIO].number : to->stations[values[AT].station[0]].ratio;
    const double other = values[HOUSING_RATIO].given ? values[HOUSING_RATIO].number
                         : values[FROM].given        ? assembly_housing_ratio(to, values[FROM].station[0])
                                                     : 0.0;
    *out = (turning){own + other, own - other};
    if (out->wedge == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "draws no oil in, as its journal and housing turn against each other at one "
                                           "speed, expected another ratio, or the element squeeze");
    return whirl_ok();
}

/// Returns the Reynolds number rho |difference of speeds| R c/mu.
static double reynolds_of(const key_value *values, double speed) {
    const oil own = oil_of(values);
    return oil_reynolds(&own, speed, sqrt(values[RADIUS].number * values[CLEARANCE].number));
}

/// Returns the factors of a turbulent film; 1 for a laminar one.
static turbulent_factors factors_of(const key_value *values, double speed) {
    return turbulent_resistance((whirl_turbulence)values[TURBULENCE].choice, reynolds_of(values, speed));
}

static whirl_status load_scale(const key_value *values, const assembly *to, double *load) {
    // Find how the strength of the film is given: by a load, or by an oil and the sizes.
    const oil own = oil_of(values);
    const bool viscous = oil_given(&own);
    double viscosity = 0.0;
    bool oily = values[RADIUS].given || values[LENGTH].given;
    for (int key = OIL; key < OIL + OIL_SUPPLY_TEMPERATURE; key++) oily = oily || values[key].given;
    if (values[LOAD].given && oily)
        return whirl_fail(WHIRL_BAD_INPUT, "has both load and viscosity, radius or length, expected one way");
    if (values[TURBULENCE].choice && (values[LOAD].given || !values[OIL + OIL_DENSITY].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has turbulence and an unknown Reynolds number, expected viscosity, "
                                           "density, radius and length");
    // Use the load, which is proportional to the speed.
    *load = values[LOAD].number;
    if (values[LOAD].given && to->speed == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has a load F0 in proportion to the speed, and the rotor stands still, "
                                           "expected viscosity, radius and length, or a speed above 0");
    if (values[LOAD].given) return whirl_ok();
    // Use the viscosity at the film's temperature.
    if (!viscous || !values[RADIUS].given || !values[LENGTH].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has neither load nor all of viscosity, radius and length, expected one of the two");
    const whirl_status status = oil_viscosity(&own, &viscosity);
    const double length = values[LENGTH].number, clearance = values[CLEARANCE].number;
    *load = viscosity * to->pace * values[RADIUS].number * length * length * length / (4.0 * clearance * clearance);
    return status;
}

/// Sets the constants of its drag. With a scale F0 in place of the oil, the shear is unknown and only the couple acts.
static void set_drag(const key_value *values, const assembly *to, const turning *turns, element *out) {
    const oil own = oil_of(values);
    const double radius = values[RADIUS].number, clearance = values[CLEARANCE].number;
    double viscosity = 0.0;
    out->fluid = (fluid_drag){.turbulence = values[TURBULENCE].choice,
                              .turns = {0.5 * (turns->wedge + turns->shear), 0.5 * (turns->wedge - turns->shear)},
                              .housing = values[FROM].given ? values[FROM].station[0] : GROUND};
    if (!values[JOURNAL_RATIO].given) out->fluid.spool[0] = to->stations[values[AT].station[0]].spool;
    if (!values[HOUSING_RATIO].given && values[FROM].given)
        out->fluid.spool[1] = to->stations[values[FROM].station[0]].spool;
    if (values[LOAD].given || oil_viscosity(&own, &viscosity).code != WHIRL_OK) return;
    out->fluid.shear = values[COUNT].number * 6.28318530717958647692 * viscosity * radius * radius * radius *
                       values[LENGTH].number / clearance;
    out->fluid.reynolds = reynolds_of(values, 1.0);
}

/// Sets the additional numbers of films of finite length, and of films in moving housings.
static void build_finite(const key_value *values, const assembly *to, const turbulent_factors *by, element *out) {
    double *number = out->number;
    const double square = number[FILM_CLEARANCE_SQUARE], scale = assembly_force_scale(to, out->port[0]);
    out->type = &film_finite_type;
    for (int i = 0; i < 2; i++)
        number[FILM_REACTION_X + i] =
            out->port[2 + i] == NO_COORDINATE ? 0.0 : scale / assembly_force_scale(to, out->port[2 + i]);
    number[FILM_OVER_CLEARANCE] = 1.0 / number[FILM_CLEARANCE];
    number[FILM_OVER_FOLD] = 1.0 / (square * FILM_FOLD);
    number[FILM_TURNS] = copysign(0.63661977236758134308, number[FILM_QUARTER]);
    if (out->law != FILM_OF_FINITE_LENGTH) return;
    // Dividing axial and circumferential flow by two factors is equivalent to another length.
    number[FILM_LENGTH] = values[LENGTH].number / (2.0 * values[RADIUS].number) * sqrt(by->along / by->around);
    film_coefficients(number[FILM_LENGTH], number + FILM_COEFFICIENT);
}

static whirl_status film_build(const key_value *values, assembly *to, element *out) {
    double load = 0.0;
    turning turns = {1.0, 1.0};
    whirl_status status = load_scale(values, to, &load);
    out->law = values[LAW].choice == FINITE ? FILM_OF_FINITE_LENGTH : 0;
    if (status.code == WHIRL_OK && out->law && values[LOAD].given)
        status = whirl_fail(WHIRL_BAD_INPUT, "has law finite and load, expected viscosity, radius and length");
    if (status.code == WHIRL_OK) status = find_turning(values, to, &turns);
    // The kernels and scales require a journal that moves in the plane.
    if (status.code == WHIRL_OK) status = assembly_find_plane(to, values[AT].station[0], out->port);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    const double clearance = values[CLEARANCE].number / to->length, square = clearance * clearance;
    const turbulent_factors by = factors_of(values, fabs(to->speed * turns.shear));
    const double speed = turns.wedge, strength = fabs(speed) * values[COUNT].number * load * by.along;
    set_drag(values, to, &turns, out);
    out->number[FILM_CLEARANCE] = clearance;
    out->number[FILM_CLEARANCE_SQUARE] = square;
    out->number[FILM_STRENGTH] = FILM_STRENGTH_OF_1 * square * strength / assembly_force_scale(to, out->port[0]);
    out->number[FILM_TWICE] = 2.0 / (to->turn * speed);
    out->number[FILM_QUARTER] = copysign(1.57079632679489661923, to->turn * speed);
    // A ratio that is given may pass 1 in a sweep, whose machines must all have one structure: it takes the variant
    // even at 1.
    const bool ratios = values[JOURNAL_RATIO].given || values[HOUSING_RATIO].given || speed != 1.0;
    if (out->law || values[FROM].given || ratios) build_finite(values, to, &by, out);
    return whirl_ok();
}

/// Raises a doubt about a ratio L/D beyond the table.
static void doubt_ratio(const doubt_teller *to, double ratio) {
    if (ratio < FILM_SHORTEST * (1.0 - 1e-9) || ratio > FILM_LONGEST * (1.0 + 1e-9))
        doubt_value(to, keys[LENGTH].name, "is %.3g times the diameter: the law is for %g to %g", ratio, FILM_SHORTEST,
                    FILM_LONGEST);
}

/// Raises a doubt about the force's error, percent, from factors of one Reynolds number instead of the local one. Ng
/// and Pan's errors are for plain films of L/D 1/4 to 1 at eccentricity ratios of .3, .5 and .8.
static void doubt_factors(const doubt_teller *to, double reynolds) {
    static const double rows[][4] = {
        {500, 2, 4, 10}, {1000, 3, 7, 17}, {2000, 5, 12, 30}, {5000, 9, 20, 57}, {10000, 11, 26, 84}};
    size_t i = 0;
    while (i + 1 < sizeof rows / sizeof *rows && reynolds > 1.01 * rows[i][0]) i++;
    doubt_value(to, keys[TURBULENCE].name,
                "has factors of one Reynolds number, %.3g: the force errs by up to %g %% at an eccentricity ratio of "
                ".3, %g %% at .5, %g %% at .8; pad_bearing has local ones",
                reynolds, rows[i][1], rows[i][2], rows[i][3]);
}

static void film_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double radius = values[RADIUS].number, clearance = values[CLEARANCE].number;
    if (!values[RADIUS].given) return;
    if (values[LAW].choice == FINITE)
        doubt_ratio(to, values[LENGTH].number / (2.0 * radius));
    else
        doubt_length(to, keys[LENGTH].name, values[LENGTH].number, radius, ", or use law: finite");
    doubt_clearance(to, keys[CLEARANCE].name, clearance, radius);
    const double reynolds = reynolds_of(values, speed);
    const bool turbulent_law = values[TURBULENCE].choice != 0;
    if (doubt_flow(to, reynolds, radius, clearance, turbulent_law) && turbulent_law) doubt_factors(to, reynolds);
}

static double film_clearance(const element *own) {
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
    .group = {"film", "the oil film of a journal bearing", "Capone 1991; Reynolds 1886", keys, KEY_COUNT, NULL, NULL},
    .number_count = FILM_NUMBERS,
    .variant = &film_finite_type,
    .kernels = kernels,
    .build = film_build,
    .carries = true,
    .drag = film_drag,
    .bearing_clearance = film_clearance,
    .doubt = film_doubt,
};
#endif
