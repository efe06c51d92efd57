/// Equilibrium of pads for a journal at a given position: tilts, and displacements of yielding pivots. Included by the
/// scalar builds of tilting_pad.c and tilting_pad_yielding.c.
///
/// The moment on a pad at rest with the tilt s is M(s) = spring s + (c, d) f, where f is the force of its film. The pad
/// is stable where M changes from negative to positive. Of several such tilts the first one with a film is taken, as in
/// `whirl bearing` (pads/pads.c); for a pad with a spring, the tilt to which it moves from its present tilt. On a pivot
/// that yields by u the film's thrust equals spring u, which grows with u.
#ifndef ROTOR_PADS_SETTLE_H
#define ROTOR_PADS_SETTLE_H

#include <float.h>
#include <math.h>

#include "bracket.h"
#include "elements/films/pads_gap.h"

/// Implements element_type.paced: the rates of tilts and of yielding pivots are derivatives of first order.
static void pads_paced(const element *own, const double *states, double *out) {
    const size_t pads = (size_t)own->law, tilts = pads_are_light(own) ? pads : 2 * pads;
    for (size_t i = 0; i < own->states; i++) {
        const bool rate = i < tilts ? tilts > pads && i % 2 == 1 : (i - tilts) % 2 == 1;
        out[i] = rate ? states[i] : 0.0;
    }
}

/// Share of mu omega R L (R/c)^2 below which the force of a film carries no pad: the errors of tables are larger.
static const double pads_no_film = 1e-3;

/// Largest tilt R delta/c of the search.
static const double pads_widest = 20.0;

/// A pad at rest, for a journal at a given position.
typedef struct pads_rest {
    const kernel_view *view;
    const double *pad;
    double journal[4];          ///< position and velocity 0 in units of the pads' clearance, mirrored for a shaft that
                                ///< turns clockwise
    double begin;               ///< tilt from which the pad's motion is followed; NaN: it is not followed
    double yield[2];            ///< outward displacement of its pivot, and 0
    double tilt, film[2], size; ///< the tilt evaluated last, its film's force, and the force's size
} pads_rest;

/// Returns the sum of all moments about the pivot at a tilt.
static double pads_moment_at(pads_rest *at, double tilt) {
    pads_view_plain seen;
    at->tilt = tilt;
    pads_see_plain(at->view, at->pad, at->journal, tilt, at->yield, &seen);
    pads_film_begin_plain(at->pad[PAD_TABLE], &seen);
    pads_film_end_plain(&seen, at->film);
    at->size = hypot(at->film[0], at->film[1]);
    return pads_moments_plain(at->view, at->pad, tilt, 0.0, at->film);
}

/// Returns true if the pad does not touch the journal at a tilt, by the position in its frame, as in pads_place.
static bool pads_are_free(const pads_rest *at, double tilt) {
    static const double least = 1e-4;
    pads_view_plain seen;
    pads_see_plain(at->view, at->pad, at->journal, tilt, at->yield, &seen);
    return seen.x < 1.0 && pads_thinnest(at->pad, seen.x, seen.y) > least;
}

/// Finds the range of tilts without contact. Returns false if it is empty.
static bool pads_free_tilts(const pads_rest *at, double ends[2]) {
    pads_view_plain seen;
    pads_see_plain(at->view, at->pad, at->journal, 0.0, at->yield, &seen);
    const double middle = at->pad[PAD_ALONG_X] * seen.x + at->pad[PAD_ALONG_Y] * seen.y;
    if (!pads_are_free(at, middle)) return false;
    for (int side = 0; side < 2; side++) {
        double good = middle, bad = middle + (side ? pads_widest : -pads_widest);
        for (int k = 0; k < 60; k++) *(pads_are_free(at, 0.5 * (good + bad)) ? &good : &bad) = 0.5 * (good + bad);
        ends[side] = good;
    }
    return true;
}

/// Finds the first adjacent tilts between which the moment changes from negative to positive, with a film at both; with
/// `any` also without films. If there are no such tilts, at->tilt becomes the tilt with the weakest film.
static bool pads_bracket_tilt(pads_rest *at, const double ends[2], bool any, bracket *found) {
    enum { LOOKS = 32 };
    double last = 0.0, before = 0.0, weakest = INFINITY, best = ends[0], size = 0.0;
    for (int k = 0; k <= LOOKS; k++) {
        const double here = ends[0] + (ends[1] - ends[0]) * k / LOOKS, moment = pads_moment_at(at, here);
        const bool held = any || (size > pads_no_film && at->size > pads_no_film);
        *found = bracket_between(last, before, here, moment);
        if (k > 0 && held && before < 0.0 && moment >= 0.0) return true;
        if (at->size < weakest) weakest = at->size, best = here;
        last = here;
        before = moment;
        size = at->size;
    }
    at->tilt = best;
    return false;
}

/// Finds the adjacent tilts between which a pad comes to rest that starts at at->begin and follows its moment. Returns
/// false if it reaches contact.
static bool pads_follow_tilt(pads_rest *at, const double ends[2], bracket *found) {
    const double width = ends[1] - ends[0];
    double here = fmin(fmax(at->begin, ends[0]), ends[1]), moment = pads_moment_at(at, here), step = width / 4096.0;
    const double side = moment < 0.0 ? 1.0 : -1.0, end = ends[moment < 0.0];
    *found = bracket_between(here, moment, here, moment);
    while (moment * side < 0.0) {
        if (here == end) return false;
        const double last = here, before = moment;
        here = step < fabs(end - here) ? here + side * step : end;
        moment = pads_moment_at(at, here);
        *found = bracket_between(last, before, here, moment);
        step = fmin(2.0 * step, width / 64.0);
    }
    return true;
}

/// Returns true if at->begin is an unstable balance of the pad around a fixed journal. The pad may stay there if the
/// journal moves as well.
static bool pads_are_held(pads_rest *at, const double ends[2]) {
    const double aside = 1e-6 * (ends[1] - ends[0]), rounding = 1e-8;
    if (!(at->begin - aside > ends[0] && at->begin + aside < ends[1])) return false;
    const double above = pads_moment_at(at, at->begin + aside), below = pads_moment_at(at, at->begin - aside);
    const double moment = pads_moment_at(at, at->begin);
    return above < below && fabs(moment) <= rounding * fabs(at->view->number[PADS_TILT_SPRING] * at->begin);
}

/// Finds the pad's equilibrium tilt, at->tilt, and its film's force. A pad with a spring has an equilibrium even
/// without a film: it is followed from its present tilt, so that the tilt does not jump while the journal moves. *idle
/// becomes true if there is no film at this tilt. Returns false if the pad touches the journal at every tilt.
static bool pads_settle_tilt(pads_rest *at, bool *idle) {
    double ends[2];
    bracket between;
    if (!pads_free_tilts(at, ends)) return false;
    const bool follows = at->view->number[PADS_TILT_SPRING] != 0.0 && isfinite(at->begin);
    if (follows && pads_are_held(at, ends)) {
        *idle = !(at->size > pads_no_film);
        return true;
    }
    const bool found = (follows && pads_follow_tilt(at, ends, &between)) ||
                       pads_bracket_tilt(at, ends, false, &between) || pads_bracket_tilt(at, ends, true, &between);
    for (int k = 0; k < 200 && found; k++) {
        const double tilt = bracket_next(&between), moment = pads_moment_at(at, tilt);
        if (moment == 0.0 || !(tilt > fmin(between.a, between.b) && tilt < fmax(between.a, between.b))) break;
        bracket_update(&between, tilt, moment);
        if (bracket_width(&between) <= 2.0 * DBL_EPSILON * fabs(tilt)) break;
    }
    if (!found) pads_moment_at(at, at->tilt);
    *idle = !(at->size > pads_no_film);
    return true;
}

#if PADS_YIELD
/// Returns the net inward force on a pad whose pivot is displaced outwards by u, at its equilibrium tilt; minus
/// infinity if the pad touches the journal.
static double pads_back(pads_rest *at, double u, bool *idle) {
    at->yield[0] = u;
    if (!pads_settle_tilt(at, idle)) return -INFINITY;
    const double outwards = at->pad[PAD_ALONG_Y] * at->film[0] - at->pad[PAD_ALONG_X] * at->film[1];
    return at->view->number[PADS_YIELD_SPRING] * u + at->view->number[PADS_YIELD_FORCE] * outwards;
}

/// Finds the pad's equilibrium on a yielding pivot.
static bool pads_settle_pad(pads_rest *at, bool *idle) {
    // Bracket the pivot's displacement at which its spring holds the film's force.
    double low = 0.0, high = 0.0, step = 1e-3;
    double back = pads_back(at, 0.0, idle), below = back, above = back;
    for (int k = 0; k < 40 && below > 0.0; k++, step *= 2.0) below = pads_back(at, low = -step, idle);
    for (int k = 0; k < 40 && above < 0.0; k++, step *= 2.0) above = pads_back(at, high = step, idle);
    if (below > 0.0 || above < 0.0) return false;
    // Narrow the bracket until the film at its lower end is not broken.
    for (int k = 0; k < 60 && isinf(below); k++) {
        const double middle = 0.5 * (low + high);
        back = pads_back(at, middle, idle);
        if (back < 0.0)
            low = middle, below = back;
        else
            high = middle, above = back;
    }
    // Narrow the bracket.
    bracket between = bracket_between(low, below, high, above);
    for (int k = 0; k < 200 && back != 0.0; k++) {
        const double u = bracket_next(&between);
        if (!(u > low && u < high) || bracket_width(&between) <= 4.0 * DBL_EPSILON * fabs(u)) break;
        back = pads_back(at, u, idle);
        bracket_update(&between, u, back);
    }
    return true;
}
#else
static bool pads_settle_pad(pads_rest *at, bool *idle) {
    return pads_settle_tilt(at, idle);
}
#endif

/// Return the index of a pad's tilt, and of its outward displacement, among the states.
static size_t pads_tilt_state(const element *own, size_t pad) {
    return pads_are_light(own) ? pad : 2 * pad;
}
static size_t pads_yield_state(const element *own, size_t pad) {
    return (pads_are_light(own) ? 1 : 2) * (size_t)own->law + 2 * pad;
}

/// Returns true if a pad without film may stay at a tilt: there is no film and no spring there, either.
static bool pads_may_stay(const pads_rest *at, double tilt) {
    pads_rest there = *at;
    if (at->view->number[PADS_TILT_SPRING] != 0.0 || !pads_are_free(at, tilt)) return false;
    pads_moment_at(&there, tilt);
    return there.size <= pads_no_film;
}

/// Implements element_type.settle.
static bool pads_settle(const element *own, const double *q, double *states, bool *idle) {
    const kernel_view view = {.stride = 1, .number = own->number};
    const double over = own->number[PADS_OVER_CLEARANCE], unit = own->number[PADS_CLEARANCE_UNIT];
    bool settled = true;
    for (size_t p = 0; p < (size_t)own->law && settled; p++) {
        const size_t tilt = pads_tilt_state(own, p), yield = pads_yield_state(own, p);
        pads_rest at = {.view = &view, .pad = own->number + PADS_FIRST + p * PAD_NUMBERS, .begin = over * states[tilt]};
        bool alone = false;
        pads_journal(own, q, at.journal);
        settled = pads_settle_pad(&at, &alone);
        if (!alone || !pads_may_stay(&at, over * states[tilt])) states[tilt] = unit * at.tilt;
        idle[tilt] = alone;
        if (!pads_are_light(own)) idle[tilt + 1] = alone, states[tilt + 1] = 0.0;
        if (!PADS_YIELD) continue;
        // A pad without a film bounces freely on its pivot; the small forces that tables have there are errors, not
        // damping.
        idle[yield] = idle[yield + 1] = alone;
        states[yield] = unit * at.yield[0];
        states[yield + 1] = 0.0;
    }
    return settled;
}

/// Implements element_type.film, for pads with a film. Tilting pads give way, so that the wall is contact with the
/// pivots; yielding pivots have no wall.
static void pads_film(const element *own, const double *q, const double *states, element_film *out) {
    const kernel_view view = {.stride = 1, .number = own->number};
    const double over = own->number[PADS_OVER_CLEARANCE], unit = own->number[PADS_CLEARANCE_UNIT];
    out->least = INFINITY;
    out->wall = PADS_YIELD ? 0.0 : INFINITY;
    out->pads = (size_t)own->law;
    for (size_t p = 0; p < (size_t)own->law; p++) {
        pads_rest at = {.view = &view, .pad = own->number + PADS_FIRST + p * PAD_NUMBERS};
        double place[2];
        pads_view_plain seen;
        pads_journal(own, q, at.journal);
        if (PADS_YIELD) at.yield[0] = over * states[pads_yield_state(own, p)];
        pads_moment_at(&at, over * states[pads_tilt_state(own, p)]);
        pads_see_plain(&view, at.pad, at.journal, at.tilt, at.yield, &seen);
        out->held[p] = at.size > pads_no_film;
        if (out->held[p]) out->least = fmin(out->least, unit * pads_thinnest(at.pad, seen.x, seen.y));
        // Compute the distance along the pivot's radius. The preload moves the pad's centre along it.
        pads_in_frame(at.pad, at.journal, place);
        const double c = at.pad[PAD_ALONG_Y], s = -at.pad[PAD_ALONG_X],
                     beyond = hypot(at.pad[PAD_SHIFT_X], at.pad[PAD_SHIFT_Y]);
        const double outwards = c * (place[0] - at.pad[PAD_SHIFT_X]) + s * (place[1] - at.pad[PAD_SHIFT_Y]);
        const double radius = hypot(at.journal[0], at.journal[1]);
        if (outwards > 0.0) out->wall = fmin(out->wall, unit * (1.0 - beyond) * radius / outwards);
    }
}

#endif
