// Special points of branches in words.
#include <math.h>
#include <stdio.h>

#include "two_pi.h"
#include "whirl/engine/analyze.h"

const char *whirl_special_name(whirl_special special) {
    static const char *const names[] = {
        "", "fold", "branching", "period doubling", "Neimark-Sacker", "Hopf", "grazing",
    };
    return special >= WHIRL_REGULAR && special <= WHIRL_GRAZE ? names[special] : "";
}

void whirl_orbit_name(const whirl_orbit *orbit, char *text, size_t size) {
    if (orbit->period == 0.0)
        snprintf(text, size, "equilibrium");
    else if (orbit->revolutions == 0)
        snprintf(text, size, "limit cycle");
    else
        snprintf(text, size, "P-%zu", orbit->revolutions);
}

const char *whirl_branch_end_text(whirl_branch_end end) {
    static const char *const texts[] = {
        [WHIRL_END_OF_RANGE] = "the bound is reached",
        [WHIRL_END_OF_POINTS] = "there are as many points as were asked for",
        [WHIRL_END_CLOSED] = "it comes back to where it began",
        [WHIRL_END_LOST] = "no orbit is found beyond",
        [WHIRL_END_HALVED] = "its orbits close after half their time, at a doubling of another branch",
        [WHIRL_END_STOPPED] = "it was stopped",
        [WHIRL_END_MIRRORED] = "its orbits become their own mirror images, at a pitchfork of another branch",
    };
    return end >= WHIRL_END_OF_RANGE && end <= WHIRL_END_MIRRORED ? texts[end] : "";
}

/// Returns the word for the criticality of a special point. On curves over two parameters only Hopf points have one.
static const char *sense_of(const whirl_branch_point *point) {
    if (point->criticality < 0.0) return ", supercritical";
    if (point->criticality > 0.0) return ", subcritical";
    return isnan(point->second) ? ", criticality not known" : "";
}

void whirl_special_text(const whirl_branch_point *point, char *text, size_t size) {
    const whirl_orbit *orbit = point->orbit;
    const char *sense = sense_of(point);
    switch (point->special) {
    case WHIRL_REGULAR:
        snprintf(text, size, "%s", "");
        return;
    case WHIRL_FOLD:
        snprintf(text, size, "the branch turns back");
        return;
    case WHIRL_BRANCHING:
        snprintf(text, size, "another branch crosses or begins");
        return;
    case WHIRL_DOUBLING:
        snprintf(text, size, "orbits of twice the period begin%s", sense);
        return;
    case WHIRL_NEIMARK_SACKER:
        snprintf(text, size, "a torus begins, %.6g turns round it in a revolution%s",
                 orbit->revolutions > 0 ? point->angle / (two_pi * (double)orbit->revolutions) : point->angle / two_pi,
                 sense);
        return;
    case WHIRL_HOPF:
        snprintf(text, size, "whirl of %.6g orders begins%s", point->angle, sense);
        return;
    case WHIRL_GRAZE:
        snprintf(text, size, "a contact begins or ends, or two become one");
        return;
    }
}
