#include "doubts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "design.h"
#include "registry.h"
#include "shafts.h"
#include "taylor_vortices.h"

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
static double doubt_speed(const whirl_design *design, const design_element *own) {
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
        if (own->type->doubt) own->type->doubt(own->values, fabs(doubt_speed(design, own)), &to);
        if (own->type == &gravity_element && own->values[GRAVITY_HELD_AT].given && design->shaft_count == 0)
            doubt_value(&to, "held_at", "has no effect without a shaft of finite elements (segment)");
    }
}
