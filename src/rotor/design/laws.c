// Laws of elements that are evaluated when a machine is designed: annular seals, doubts, Hertz contacts, tables.
#include "black.h"
#include "doubts.h"
#include "hertz.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "design.h"
#include "registry.h"
#include "shafts.h"
#include "table.h"
#include "taylor_vortices.h"

// ---------------------------------------------------------------- black
// Equations: docs/theory.md, "Annular seal".

/// Returns the friction factor of a smooth annulus whose inner wall turns (Yamada 1962).
static double friction(double axial, double around) {
    const double turned = 7.0 * around / (8.0 * axial);
    return 0.079 * pow(axial, -0.25) * pow(1.0 + turned * turned, 0.375);
}

black_coefficients black_find(const black_seal *seal, double speed) {
    const double c = seal->clearance, surface = seal->radius * speed, inlet = 1.0 + seal->loss;
    const double thin = seal->density * c / seal->viscosity, around = thin * surface;
    double velocity = sqrt(2.0 * seal->pressure / seal->density / inlet), lambda = 0.0;
    // Each pass at least halves the error, since friction falls more slowly than 1/V.
    for (int i = 0; i < 100; i++) {
        lambda = friction(2.0 * thin * velocity, around);
        velocity = sqrt(2.0 * seal->pressure / seal->density / (inlet + 2.0 * lambda * seal->length / c));
    }
    const double s = lambda * seal->length / c, a = inlet + 2.0 * s, passing = seal->length / velocity;
    const double spring = inlet * s * s / (a * a);
    const double damper = 2.0 * s / a * (0.5 * inlet * ((1.0 + s) / a - s / (a * a)) + s / 6.0);
    const double mass = 2.0 * s / a * (0.5 * inlet * (0.5 / a - (1.0 + s) / (a * a) + s / (a * a * a)) + 1.0 / 12.0);
    const double scale = 3.14159265358979323846 * seal->radius * seal->pressure / lambda;
    // The shear along the axis is lambda rho V^2/2. The ratio of the shear around the shaft to it is that of the slip
    // to V.
    const double ratio = 0.5 - (seal->swirl - 0.5) * expm1(-s) / s, slip = surface * (1.0 - ratio);
    const double area = 6.28318530717958647692 * seal->radius * seal->length;
    return (black_coefficients){.stiffness = scale * spring,
                                .damping = scale * damper * passing,
                                .mass = scale * mass * passing * passing,
                                .ratio = ratio,
                                .velocity = velocity,
                                .reynolds = 2.0 * thin * hypot(velocity, 0.5 * surface),
                                .shear = seal->radius * area * 0.5 * lambda * seal->density * velocity * slip};
}

// ---------------------------------------------------------------- doubts
// Raises doubts about values that are probably mistakes, or outside of a law's range.

void doubt_value(const doubt_teller *to, const char *key, const char *format, ...) {
    char sentence[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    to->tell(to->context, to->element, key, sentence);
}

void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius) {
    // Bearings and dampers have 5e-4 to 5e-3 (San Andres 2010). A wrong unit is wrong by a factor of 1000.
    const double share = clearance / radius, least = 1e-4, most = 1e-2, largest = 10.0;
    if (share < least || share > most)
        doubt_value(to, key, "is %.3g times the radius, and films have %g to %g times", share, least, most);
    if (radius > largest) doubt_value(to, "radius", "is %g m, and bearings have up to %g m", radius, largest);
}

void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead) {
    // The range of the law is in theory.md, "Oil film of a short journal bearing".
    const double share = length / (2.0 * radius), most = 0.5 * (1.0 + 1e-9);
    if (share > most)
        doubt_value(to, key,
                    "is %.3g times the diameter: the short law is for up to 0.5, its force is too large beyond%s",
                    share, instead);
}

bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law) {
    const double most = FIRST_VORTICES * sqrt(radius / clearance);
    if (reynolds > most && !turbulent_law)
        doubt_value(to, "density",
                    "is so high that the flow is not laminar, as the law has it: Reynolds number %.3g, up to %.3g",
                    reynolds, most);
    if (reynolds < most && turbulent_law)
        doubt_value(to, "turbulence", "is given, and the flow is laminar: Reynolds number %.3g, below %.3g", reynolds,
                    most);
    return reynolds >= most;
}

/// Returns the speed of the shaft of an element's first station, or of the rotor if the station is on no shaft.
static double speed_at(const whirl_design *design, const design_element *own) {
    for (size_t k = 0; k < own->type->group.key_count; k++) {
        const whirl_key_kind kind = own->type->group.keys[k].kind;
        const size_t station = own->values[k].station[0];
        if ((kind != WHIRL_KEY_STATION && kind != WHIRL_KEY_STATIONS) || !own->values[k].given) continue;
        if (station >= design->station_count || !design->stations[station].values[STATION_POSITION].given) break;
        const key_value *shaft = &design->stations[station].values[STATION_SHAFT];
        const size_t at = shaft->given ? shaft->station[0] : 0;
        return at < design->shaft_count ? design->speed * design->shafts[at].values[SHAFT_RATIO].number : design->speed;
    }
    return design->speed;
}

void whirl_design_doubts(const whirl_design *design, whirl_design_tell *tell, void *context) {
    for (size_t i = 0; i < design->element_count; i++) {
        const design_element *own = &design->elements[i];
        const doubt_teller to = {tell, context, i};
        if (own->type->doubt) own->type->doubt(own->values, fabs(speed_at(design, own)), &to);
        if (own->type == &gravity_element && own->values[GRAVITY_HELD_AT].given && design->shaft_count == 0)
            doubt_value(&to, "held_at", "has no effect without a shaft of finite elements (segment)");
    }
}

// ---------------------------------------------------------------- hertz
// Hertz contacts of steel on the inner race, which has the highest pressure.

static const double pi = 3.14159265358979323846;

/// E/(1 - nu^2) of steel, Pa.
static const double modulus = 2.06e11 / (1.0 - 0.09);

double hertz_ball_load(double diameter, double race, double groove) {
    // Compute the radii of curvature along the rolling and across it; the ellipse is by the fit of Brewe, Hamrock 1977.
    const double along = 1.0 / (2.0 / diameter + 1.0 / race);
    const double across = 1.0 / (2.0 / diameter - 1.0 / (groove * diameter));
    const double radius = 1.0 / (1.0 / along + 1.0 / across), shape = 1.0339 * pow(across / along, 0.636);
    const double integral = 1.0003 + 0.5968 * along / across;
    // Half axes a = (6 k^2 E Q R/(pi E'))^(1/3) and a/k; the pressure is 3 Q/(2 pi a a/k).
    const double by_load = 6.0 * shape * shape * integral * radius / (pi * modulus);
    const double root = HERTZ_MAX_BALL * 2.0 * pi / (3.0 * shape);
    return root * root * root * by_load * by_load;
}

double hertz_roller_load(double diameter, double race, double stiffness) {
    // The approach of one contact is 3.84e-5 Q^0.9/l^0.8 mm with lengths in mm (Palmgren). Two contacts in series give
    // the stiffness.
    const double of_one = pow(2.0 * 3.84e-5, -10.0 / 9.0) * pow(1e3, 10.0 / 9.0);
    const double length = 1e-3 * pow(stiffness / of_one, 9.0 / 8.0);
    const double radius = 1.0 / (2.0 / diameter + 1.0 / race);
    return 2.0 * pi * radius * length * HERTZ_MAX_ROLLER * HERTZ_MAX_ROLLER / modulus;
}

// ---------------------------------------------------------------- table

/// Returns the slope at an end, by the parabola through three points, limited to stay monotone (Fritsch, Carlson 1980).
static double end_slope(double near, double far, double rise, double next) {
    const double slope = ((2.0 * near + far) * rise - near * next) / (near + far);
    if (slope * rise <= 0.0) return 0.0;
    return rise * next < 0.0 && fabs(slope) > 3.0 * fabs(rise) ? 3.0 * rise : slope;
}

static double width(const double *x, size_t i) {
    return x[i + 1] - x[i];
}

static double rise(const double *x, const double *y, size_t i) {
    return (y[i + 1] - y[i]) / width(x, i);
}

/// Returns the slope at an inner point: the weighted harmonic mean of the rises on both sides, 0 at an extreme.
static double slope_at(size_t count, const double *x, const double *y, size_t i) {
    if (count == 2) return rise(x, y, 0);
    if (i == 0) return end_slope(width(x, 0), width(x, 1), rise(x, y, 0), rise(x, y, 1));
    if (i == count - 1) return end_slope(width(x, i - 1), width(x, i - 2), rise(x, y, i - 1), rise(x, y, i - 2));
    const double before = rise(x, y, i - 1), after = rise(x, y, i);
    if (before * after <= 0.0) return 0.0;
    const double a = 2.0 * width(x, i) + width(x, i - 1), b = width(x, i) + 2.0 * width(x, i - 1);
    return (a + b) / (a / before + b / after);
}

bool table_rises(size_t count, const double *x) {
    for (size_t i = 1; i < count; i++)
        if (!(x[i] > x[i - 1])) return false;
    return true;
}

double table_value(size_t count, const double *x, const double *y, double at) {
    size_t i = 0;
    while (i + 2 < count && at > x[i + 1]) i++;
    const double h = width(x, i), s = (at - x[i]) / h, r = 1.0 - s;
    return y[i] * r * r * (1.0 + 2.0 * s) + y[i + 1] * s * s * (1.0 + 2.0 * r) +
           h * s * r * (r * slope_at(count, x, y, i) - s * slope_at(count, x, y, i + 1));
}
