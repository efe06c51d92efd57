// The oil film of a short journal bearing, pi film (Capone 1991).
//
// Lengths in clearances, ' = d/dtau, film thickness h = 1 - x cos phi - y sin phi. With
//
//     A = x - 2y',  B = y + 2x',  C = sqrt(A^2 + B^2),  q = 1 - x^2 - y^2
//
// the film begins at alpha = atan2(-B, -A), so that cos alpha = -A/C and sin alpha = -B/C need no angle. Capone's
// G, V, S and the force on the journal (fx, fy) = -(C/q)(3xV - sin a G - 2 cos a S, 3yV + cos a G - 2 sin a S)
// become, with P = xB - yA, U = xA + yB and C^2 - U^2 = q C^2 + P^2 (which saves a cancellation near the wall),
//
//     G = (2/sqrt q)[pi/2 + atan(P/(C sqrt q))],   S = -U C/(q C^2 + P^2),   C V = (2C + P G)/q,
//     (fx, fy) = -(1/q)(3x CV + B G + 2A S, 3y CV - A G + 2B S).
//
// The scale of the force is F0 = mu omega R L (R/c)^2 (L/2R)^2 = mu omega R L^3/(4 c^2).
#include <float.h>
#include <math.h>

#include "element.h"
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

typedef struct film {
    size_t station;
    double to_clearances; ///< length scale over clearance
    double strength;      ///< count F0/(m omega^2 length)
    double clearance;     ///< in length scales
} film;

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

static whirl_status build(const key_value *values, const scales *scale, void *coefficients) {
    double load = 0.0;
    const whirl_status status = load_scale(values, scale->speed, &load);
    if (status.code != WHIRL_OK) return status;
    film *f = coefficients;
    const size_t station = values[AT].station[0];
    *f = (film){.station = station,
                .to_clearances = scale->length / values[CLEARANCE].number,
                .strength = values[COUNT].number * load / (stiffness_scale(scale, station) * scale->length),
                .clearance = values[CLEARANCE].number / scale->length};
    return whirl_ok();
}

void film_force(double x, double y, double vx, double vy, double force[2]) {
    const double pi = 3.14159265358979323846;
    const double A = x - 2.0 * vy, B = y + 2.0 * vx;
    const double q = 1.0 - x * x - y * y;
    const double CC = A * A + B * B, C = sqrt(CC);
    const double P = x * B - y * A, U = x * A + y * B;
    const double root = sqrt(q); // NaN beyond the wall: the motion then counts as diverged
    // DBL_MIN makes the film of a journal at rest in the centre (C = 0) exert no force.
    const double G = (pi + 2.0 * atan(P / (C * root + DBL_MIN))) / root;
    const double S = -U * C / (q * CC + P * P + DBL_MIN);
    const double CV3 = 3.0 * (2.0 * C + P * G) / q;
    const double scale = -1.0 / q;
    force[0] = scale * (x * CV3 + B * G + 2.0 * A * S);
    force[1] = scale * (y * CV3 - A * G + 2.0 * B * S);
}

void whirl_film_force(double x, double y, double vx, double vy, double force[2]) {
    film_force(x, y, vx, vy, force);
}

static void force(const void *coefficients, const double *forcing, const double *q, const double *v, double *a) {
    const film *f = coefficients;
    const size_t i = 2 * f->station;
    const double s = f->to_clearances;
    double unit[2];
    (void)forcing;
    film_force(s * q[i], s * q[i + 1], s * v[i], s * v[i + 1], unit);
    a[i] += f->strength * unit[0];
    a[i + 1] += f->strength * unit[1];
}

static size_t bearing_station(const void *coefficients, double *clearance) {
    const film *f = coefficients;
    *clearance = f->clearance;
    return f->station;
}

const element_type film_element = {
    .group = {"film", "the oil film of a short journal bearing", "Capone 1991", keys, KEY_COUNT, NULL},
    .size = sizeof(film),
    .build = build,
    .force = force,
    .bearing_station = bearing_station,
};
