// Bearings with pads: from the films of single pads to the journal's equilibrium and its stiffness.
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "pad_centred.h"
#include "reynolds.h"
#include "whirl/internal/bearing.h"

/// Step of differences in positions and tilts. Forces are exact to 1e-6 and better; differences are of fourth order.
static const double difference = 0.02;

enum { FINENESS = 960, ALONG = 24, COARSER = 4, MAX_STEPS = 60 };

/// Largest tilt R delta/c of the search.
static const double widest_tilt = 20.0;

/// Data of a solution.
typedef struct solver {
    const whirl_pads *bearing;
    pad_workspace *work;
    int coarser; ///< factor by which the grid is coarser
} solver;

static double middle_of(const whirl_pad *pad) {
    return pad->pivot + (0.5 - pad->offset) * pad->arc;
}

/// Returns the film of a pad, with its number of volumes along the arc and along half its length. Both numbers are
/// divided by s->coarser.
static pad_film film_of(const solver *s, const whirl_pad *pad) {
    const int fineness = s->bearing->fineness > 0 ? s->bearing->fineness : FINENESS;
    const double turn = 2.0 * acos(-1.0);
    const int eighths = (int)ceil(fmin(pad->arc / turn, 1.0) * fineness / 16.0), least = 6;
    const int around = 16 * (eighths < least ? least : eighths);
    return (pad_film){.arc = pad->arc,
                      .ratio = s->bearing->ratio,
                      .law = s->bearing->gumbel ? CAVITATION_GUMBEL : CAVITATION_REYNOLDS,
                      .around = around / s->coarser,
                      .along = ALONG / s->coarser,
                      .turbulence = s->bearing->turbulence,
                      .reynolds = s->bearing->reynolds,
                      .supply = s->bearing->supply,
                      .groove = s->bearing->groove};
}

/// Position and velocity of a journal relative to a pad, in the frame of the bearing.
typedef struct seen {
    double place[2], velocity[2];
} seen;

/// Computes the force of a pad's film on the journal, in the frame of the bearing.
static whirl_status force_of(const solver *s, const whirl_pad *pad, const seen *at, double force[2], pad_answer *all) {
    const double angle = middle_of(pad), c = cos(angle), sn = sin(angle);
    const double x = at->place[0] + pad->preload * cos(pad->pivot), y = at->place[1] + pad->preload * sin(pad->pivot);
    const double a = x - 2.0 * at->velocity[1], b = y + 2.0 * at->velocity[0];
    const pad_film film = film_of(s, pad);
    const pad_place place = {.x = c * x + sn * y, .y = c * y - sn * x, .a = c * a + sn * b, .b = c * b - sn * a};
    const whirl_status status = pad_solve(s->work, &film, &place, all);
    if (status.code != WHIRL_OK) return status;
    force[0] = c * all->force[0] - sn * all->force[1];
    force[1] = sn * all->force[0] + c * all->force[1];
    return status;
}

/// Computes the direction along the pad at its pivot, in the sense of the rotation.
static void tangent_of(const whirl_pad *pad, double t[2]) {
    t[0] = -sin(pad->pivot);
    t[1] = cos(pad->pivot);
}

/// Computes the outward direction at the pivot.
static void normal_of(const whirl_pad *pad, double n[2]) {
    n[0] = cos(pad->pivot);
    n[1] = sin(pad->pivot);
}

/// Computes the journal's position relative to a pad that has moved outwards.
static void before_pad(const whirl_pad *pad, const double place[2], double yield, double out[2]) {
    double n[2];
    normal_of(pad, n);
    for (int k = 0; k < 2; k++) out[k] = place[k] - yield * n[k];
}

/// Computes the journal's position relative to a tilted pad.
static seen tilted(const whirl_pad *pad, const double place[2], double tilt) {
    double t[2];
    tangent_of(pad, t);
    return (seen){.place = {place[0] - tilt * t[0], place[1] - tilt * t[1]}};
}

// ---------------------------------------------------------------- tilts

/// Finds the range of tilts without contact. Returns false if it is empty. The film is thinnest at an edge or, if that
/// lies between the edges, on the line to the journal.
static bool free_tilts(const whirl_pad *pad, const double place[2], double ends[2]) {
    const double before = -pad->offset * pad->arc, after = (1.0 - pad->offset) * pad->arc;
    const double c = cos(pad->pivot), sn = sin(pad->pivot);
    const double n = c * place[0] + sn * place[1] + pad->preload, along = c * place[1] - sn * place[0];
    for (int side = 0; side < 2; side++) {
        double good = along, bad = along + (side ? widest_tilt : -widest_tilt), tilt = along;
        for (int k = 0; k < 100; k++, tilt = 0.5 * (good + bad)) {
            const double y = along - tilt, angle = atan2(y, n);
            double least = fmin(1.0 - n * cos(before) - y * sin(before), 1.0 - n * cos(after) - y * sin(after));
            if (angle > before && angle < after) least = fmin(least, 1.0 - hypot(n, y));
            if (k == 0 && !(least > 0.0)) return false;
            *(least > 1e-4 ? &good : &bad) = tilt;
        }
        ends[side] = good;
    }
    return true;
}

/// Arguments of the search for a tilt.
typedef struct balance {
    const solver *s;
    const whirl_pad *pad;
    const double *place;
    double force[2];
    pad_answer all;
} balance;

/// Computes the force along the pad, which is the film's moment about the pivot.
static whirl_status along_pad(balance *b, double tilt, double *along) {
    double t[2];
    const seen at = tilted(b->pad, b->place, tilt);
    const whirl_status status = force_of(b->s, b->pad, &at, b->force, &b->all);
    tangent_of(b->pad, t);
    *along = b->force[0] * t[0] + b->force[1] * t[1];
    return status;
}

/// Finds the first adjacent tilts between which the film's moment about the pivot vanishes stably: the force along the
/// pad grows with the tilt. *loaded becomes false if there is no film.
static whirl_status bracket_tilt(balance *b, bracket *found, bool *loaded) {
    enum { LOOKS = 32 };
    double ends[2], last = 0.0, before = 0.0;
    *loaded = false;
    if (!free_tilts(b->pad, b->place, ends))
        return whirl_fail(WHIRL_BAD_INPUT, "the journal touches a pad, however that tilts");
    for (int k = 0; k <= LOOKS && !*loaded; k++) {
        const double here = ends[0] + (ends[1] - ends[0]) * k / LOOKS;
        double along;
        const whirl_status status = along_pad(b, here, &along);
        if (status.code != WHIRL_OK) return status;
        *loaded = k > 0 && before < 0.0 && along >= 0.0 && hypot(b->force[0], b->force[1]) > 0.0;
        if (*loaded) *found = bracket_between(last, before, here, along);
        last = here;
        before = along;
    }
    return whirl_ok();
}

/// Finds the tilt of a pad at rest; 0 without a film.
static whirl_status balance_pad(const solver *s, const whirl_pad *pad, const double place[2], double *tilt,
                                bool *loaded) {
    balance b = {.s = s, .pad = pad, .place = place};
    bracket found = {.a = 0.0};
    whirl_status status = bracket_tilt(&b, &found, loaded);
    *tilt = 0.0;
    for (int k = 0; *loaded && k < 100 && status.code == WHIRL_OK && bracket_width(&found) > 1e-10; k++) {
        double along;
        *tilt = bracket_next(&found);
        status = along_pad(&b, *tilt, &along);
        if (fabs(along) < 1e-12) break;
        bracket_update(&found, *tilt, along);
    }
    return status;
}

double pad_centred_tilt(const whirl_pad *pad, double ratio, bool gumbel) {
    static const double middle[2] = {0.0, 0.0};
    const whirl_pads bearing = {.count = 1, .pads = {*pad}, .ratio = ratio, .tilting = true, .gumbel = gumbel};
    solver s = {.bearing = &bearing, .coarser = COARSER};
    const pad_film film = film_of(&s, pad);
    double tilt = 0.0;
    bool loaded;
    if (pad_workspace_new(film.around, film.along, &s.work).code != WHIRL_OK) return 0.0;
    if (balance_pad(&s, pad, middle, &tilt, &loaded).code != WHIRL_OK || !loaded) tilt = 0.0;
    pad_workspace_free(s.work);
    return tilt;
}

// ---------------------------------------------------------------- derivatives

/// Computes -dF by the position (0) and by the velocity (1) of the journal, for one pad.
static whirl_status derive(const solver *s, const whirl_pad *pad, const double place[2], double tilt, double thinnest,
                           double out[2][2][2]) {
    static const double weight[] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0}, at[] = {-2.0, -1.0, 1.0, 2.0};
    const seen rest = tilted(pad, place, tilt);
    // The force is homogeneous in (A, B), and at rest (A, B) is the position relative to the pad.
    const double wedge =
        hypot(rest.place[0] + pad->preload * cos(pad->pivot), rest.place[1] + pad->preload * sin(pad->pivot));
    const double step = difference * fmin(fmax(wedge, 0.05), thinnest);
    memset(out, 0, 8 * sizeof(double));
    for (int k = 0; k < 16; k++) {
        const int which = k / 8, column = k / 4 % 2;
        seen moved = rest;
        double force[2];
        pad_answer all;
        (which ? moved.velocity : moved.place)[column] += at[k % 4] * step;
        const whirl_status status = force_of(s, pad, &moved, force, &all);
        if (status.code != WHIRL_OK) return status;
        for (int row = 0; row < 2; row++) out[which][row][column] -= weight[k % 4] * force[row] / step;
    }
    return whirl_ok();
}

/// Adds the force of the oil in a groove, which presses on the journal at the middle of the gap.
static void add_groove(const whirl_pads *bearing, size_t pad, whirl_pads_state *state) {
    const whirl_pad *before = &bearing->pads[pad];
    const double half = 0.5 * whirl_pads_gap(bearing, pad);
    const double middle = before->pivot + (1.0 - before->offset) * before->arc + half;
    // The force is 3 int int P (-cos p, -sin p). Along the axis P is constant over the share `groove` and falls
    // linearly to 0 at the ends: its mean is half of 1 + groove.
    const double size = -6.0 * bearing->supply * 0.5 * (1.0 + bearing->groove) * 2.0 * sin(half);
    state->grooves[0] += size * cos(middle);
    state->grooves[1] += size * sin(middle);
}

static void begin_look(const whirl_pads *bearing, const double place[2], whirl_pads_state *state) {
    memcpy(state->at, place, sizeof state->at);
    state->highest = state->leaving = state->drag = state->grooves[0] = state->grooves[1] = 0.0;
    for (size_t i = 0; i < bearing->count && bearing->supply > 0.0; i++) add_groove(bearing, i, state);
    memcpy(state->force, state->grooves, sizeof state->force);
    state->thinnest = INFINITY;
}

/// Solves every pad for a position of the journal, with its tilt (balanced) and its derivatives (derived) if requested.
static whirl_status look(const solver *s, const double place[2], bool balanced, bool derived, whirl_pads_state *state) {
    whirl_status status = whirl_ok();
    begin_look(s->bearing, place, state);
    for (size_t i = 0; i < s->bearing->count && status.code == WHIRL_OK; i++) {
        const whirl_pad *pad = &s->bearing->pads[i];
        double before[2], n[2], along;
        // Find the journal as the pad sees it, and the tilt of the pad in balance.
        before_pad(pad, place, state->yield[i], before);
        balance b = {.s = s, .pad = pad, .place = before};
        if (balanced && s->bearing->tilting) status = balance_pad(s, pad, before, &state->tilt[i], &state->loaded[i]);
        memset(state->of_pads[i], 0, sizeof state->of_pads[i]);
        state->load[i] = 0.0;
        if (!state->loaded[i]) state->yield[i] = 0.0;
        if (status.code != WHIRL_OK || !state->loaded[i]) continue;
        // Compute the force of the film, and its derivatives if requested.
        status = along_pad(&b, state->tilt[i], &along);
        if (status.code == WHIRL_OK && derived)
            status = derive(s, pad, before, state->tilt[i], b.all.thinnest, state->of_pads[i]);
        state->load[i] = hypot(b.force[0], b.force[1]);
        state->moment[i] = along;
        normal_of(pad, n);
        state->thrust[i] = -(b.force[0] * n[0] + b.force[1] * n[1]);
        // Update the sums and extremes over the pads.
        for (int k = 0; k < 2; k++) state->force[k] += b.force[k];
        state->thinnest = fmin(state->thinnest, b.all.thinnest);
        state->highest = fmax(state->highest, b.all.highest);
        state->leaving += b.all.leaving;
        state->drag += b.all.drag;
    }
    return status;
}

// ---------------------------------------------------------------- rest

/// Linear response of a pad to the journal: the change r of its tilt and yield by a change dq of the journal's
/// position, r = by dq - back.
typedef struct follower {
    double t[2], n[2]; ///< directions in which tilt and yield move the pad
    double by[2][2];   ///< [tilt, yield][x, y]
    double back[2];    ///< residual of the pad's own balance
} follower;

/// Computes the response of a pad from its balance, F.t = 0 and k yield + F.n = 0 with dF = -K (dq - T dr): A dr = T' K
/// dq - b.
static follower follower_of(const whirl_pads *bearing, const whirl_pads_state *state, size_t i) {
    const double(*k)[2] = state->of_pads[i][0];
    follower out = {.back = {0.0}};
    double a[2][2], right[2][2];
    tangent_of(&bearing->pads[i], out.t);
    normal_of(&bearing->pads[i], out.n);
    const double *along[] = {out.t, out.n};
    // Set up the equations of the pad: A = T' K T + springs, with right-hand side T' K.
    for (int r = 0; r < 2; r++) {
        for (int c = 0; c < 2; c++) right[r][c] = along[r][0] * k[0][c] + along[r][1] * k[1][c];
        for (int c = 0; c < 2; c++) a[r][c] = right[r][0] * along[c][0] + right[r][1] * along[c][1];
    }
    // A pad without tilt or yield keeps only the other equation, or none.
    const bool tilts = bearing->tilting && state->loaded[i] && a[0][0] > 0.0;
    const bool yields = tilts && bearing->pivot_stiffness > 0.0;
    if (!tilts) return out;
    a[1][1] += bearing->pivot_stiffness;
    if (!yields) a[0][1] = a[1][0] = 0.0, a[1][1] = 1.0;
    const double lacking[] = {state->moment[i],
                              yields ? bearing->pivot_stiffness * state->yield[i] - state->thrust[i] : 0.0};
    const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    // Solve the 2 by 2 equations.
    for (int c = 0; c < 2; c++) {
        const double under = yields ? right[1][c] : 0.0;
        out.by[0][c] = (right[0][c] * a[1][1] - a[0][1] * under) / determinant;
        out.by[1][c] = (a[0][0] * under - a[1][0] * right[0][c]) / determinant;
    }
    out.back[0] = (lacking[0] * a[1][1] - a[0][1] * lacking[1]) / determinant;
    out.back[1] = (a[0][0] * lacking[1] - a[1][0] * lacking[0]) / determinant;
    return out;
}

/// A change of the journal's position, and of the tilts and yields of the pads.
typedef struct step {
    double place[2], tilt[WHIRL_MAX_PADS], yield[WHIRL_MAX_PADS];
} step;

/// Solves K* d = r for the journal with pads in balance, K* = K - K T by. Then computes the changes of the pads.
static step step_of(const whirl_pads *bearing, const whirl_pads_state *state, const double lacking[2]) {
    double sum[2][2] = {{0.0}}, right[2] = {lacking[0], lacking[1]};
    follower pads[WHIRL_MAX_PADS] = {{.t = {0.0}}};
    step out;
    // Eliminate the pads, which follow the journal.
    for (size_t i = 0; i < bearing->count; i++) {
        const double(*k)[2] = state->of_pads[i][0];
        const follower *pad = &pads[i];
        pads[i] = follower_of(bearing, state, i);
        for (int r = 0; r < 2; r++) {
            const double kt = k[r][0] * pad->t[0] + k[r][1] * pad->t[1], kn = k[r][0] * pad->n[0] + k[r][1] * pad->n[1];
            right[r] -= kt * pad->back[0] + kn * pad->back[1];
            for (int c = 0; c < 2; c++) sum[r][c] += k[r][c] - kt * pad->by[0][c] - kn * pad->by[1][c];
        }
    }
    // Solve for the journal.
    const double determinant = sum[0][0] * sum[1][1] - sum[0][1] * sum[1][0];
    out.place[0] = (right[0] * sum[1][1] - right[1] * sum[0][1]) / determinant;
    out.place[1] = (right[1] * sum[0][0] - right[0] * sum[1][0]) / determinant;
    // Compute how the pads follow.
    for (size_t i = 0; i < bearing->count; i++) {
        const double *d = out.place;
        out.tilt[i] = pads[i].by[0][0] * d[0] + pads[i].by[0][1] * d[1] - pads[i].back[0];
        out.yield[i] = pads[i].by[1][0] * d[0] + pads[i].by[1][1] * d[1] - pads[i].back[1];
    }
    return out;
}

/// Computes the residual of the journal's balance. Returns it together with that of the pivots, divided by the load.
static double lack(const whirl_pads *bearing, const whirl_pads_state *state, const double load[2], double lacking[2]) {
    double sum = 0.0;
    for (int k = 0; k < 2; k++) lacking[k] = load[k] + state->force[k], sum += lacking[k] * lacking[k];
    for (size_t i = 0; i < bearing->count && bearing->pivot_stiffness > 0.0; i++)
        if (state->loaded[i]) sum += pow(bearing->pivot_stiffness * state->yield[i] - state->thrust[i], 2.0);
    return sqrt(sum) / hypot(load[0], load[1]);
}

/// Moves journal and pads by a share of a step.
static void go(const whirl_pads *bearing, const step *by, double share, whirl_pads_state *state) {
    for (int c = 0; c < 2; c++) state->at[c] += share * by->place[c];
    for (size_t i = 0; i < bearing->count; i++) {
        state->tilt[i] += share * by->tilt[i];
        state->yield[i] += share * by->yield[i];
    }
}

/// Solves the first position of a search. For tilting pads without preload it is slightly towards the load from the
/// centre, where their films carry nothing.
static whirl_status look_first(const solver *s, const double load[2], whirl_pads_state *state) {
    const whirl_status status = look(s, state->at, true, true, state);
    bool loaded = false;
    for (size_t i = 0; i < s->bearing->count; i++) loaded = loaded || state->loaded[i];
    if (status.code != WHIRL_OK || loaded) return status;
    for (int c = 0; c < 2; c++) state->at[c] += 1e-3 * load[c] / hypot(load[0], load[1]);
    return look(s, state->at, true, true, state);
}

/// Finds the equilibrium by Newton's method on a coarse grid, with pads in balance at every step. Steps are halved
/// until the residual falls.
static whirl_status find_coarsely(const solver *s, const double load[2], whirl_pads_state *state) {
    double lacking[2];
    whirl_status status = look_first(s, load, state);
    for (int k = 0; k < MAX_STEPS && status.code == WHIRL_OK; k++) {
        const double before = lack(s->bearing, state, load, lacking);
        if (before < 1e-6) return status;
        const step move = step_of(s->bearing, state, lacking);
        whirl_pads_state next;
        double share = fmin(1.0, 0.3 / hypot(move.place[0], move.place[1]));
        for (int half = 0; half < 30; half++, share *= 0.5) {
            next = *state;
            go(s->bearing, &move, share, &next);
            status = look(s, next.at, true, false, &next);
            if (status.code == WHIRL_OK && lack(s->bearing, &next, load, lacking) < before) break;
            if (status.code != WHIRL_OK && status.code != WHIRL_BAD_INPUT) return status;
        }
        if (status.code != WHIRL_OK || !(lack(s->bearing, &next, load, lacking) < before)) break;
        *state = next;
        status = look(s, state->at, true, true, state);
    }
    return whirl_fail(WHIRL_NUMERICAL_FAILURE, "no place was found where the films of the bearing carry the load");
}

/// Moves the journal and the tilts of pads until all forces balance on the finest grid, with the derivatives of the
/// coarse grid.
static whirl_status polish(const solver *s, const double load[2], whirl_pads_state *state) {
    whirl_status status = whirl_ok();
    for (int k = 0; k < MAX_STEPS && status.code == WHIRL_OK; k++) {
        double lacking[2], slopes[WHIRL_MAX_PADS][2][2][2];
        memcpy(slopes, state->of_pads, sizeof slopes);
        status = look(s, state->at, false, false, state);
        memcpy(state->of_pads, slopes, sizeof slopes);
        if (status.code != WHIRL_OK) break;
        lack(s->bearing, state, load, lacking);
        const step move = step_of(s->bearing, state, lacking);
        double most = hypot(move.place[0], move.place[1]);
        go(s->bearing, &move, 1.0, state);
        for (size_t i = 0; i < s->bearing->count; i++) most = fmax(most, fmax(fabs(move.tilt[i]), fabs(move.yield[i])));
        if (most < 1e-9) return look(s, state->at, false, true, state);
    }
    return status.code == WHIRL_OK
               ? whirl_fail(WHIRL_NUMERICAL_FAILURE, "the place of the journal does not settle on the finest grid")
               : status;
}

static whirl_status pads_check(const whirl_pads *bearing) {
    const double turn = 2.0 * acos(-1.0);
    // Check the bearing as a whole.
    if (bearing->count == 0 || bearing->count > WHIRL_MAX_PADS)
        return whirl_fail(WHIRL_BAD_INPUT, "a bearing has %zu pads, expected 1 to %d", bearing->count, WHIRL_MAX_PADS);
    if (!(bearing->ratio > 0.0) || !isfinite(bearing->ratio))
        return whirl_fail(WHIRL_BAD_INPUT, "length over diameter is %g, expected a number above 0", bearing->ratio);
    if (!(bearing->reynolds >= 0.0 && isfinite(bearing->reynolds)))
        return whirl_fail(WHIRL_BAD_INPUT, "the Reynolds number is %g, expected 0 or more", bearing->reynolds);
    if (!(bearing->supply >= 0.0 && bearing->groove >= 0.0 && bearing->groove < 1.0))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "grooves have a pressure of %g over a share of the length of %g, expected 0 or more over less "
            "than 1",
            bearing->supply, bearing->groove);
    if (bearing->supply > 0.0 && bearing->tilting)
        return whirl_fail(WHIRL_BAD_INPUT, "pads that tilt have no grooves, expected no pressure in them");
    if (!(bearing->pivot_stiffness >= 0.0 && bearing->pivot_damping >= 0.0 && bearing->pad_mass >= 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "a pivot has a stiffness of %g, a damping of %g, a mass of %g, expected 0 or "
                          "more",
                          bearing->pivot_stiffness, bearing->pivot_damping, bearing->pad_mass);
    // Check each pad.
    for (size_t i = 0; i < bearing->count; i++) {
        const whirl_pad *pad = &bearing->pads[i];
        if (!(pad->arc > 0.0 && pad->arc <= turn * (1.0 + 1e-12)))
            return whirl_fail(WHIRL_BAD_INPUT, "pad %zu has an arc of %g rad, expected at most a turn", i + 1,
                              pad->arc);
        if (!(pad->offset >= 0.0 && pad->offset <= 1.0))
            return whirl_fail(WHIRL_BAD_INPUT, "pad %zu has an offset of %g, expected 0 to 1", i + 1, pad->offset);
        if (!(pad->preload > -1.0 && pad->preload < 1.0))
            return whirl_fail(WHIRL_BAD_INPUT, "pad %zu has a preload of %g, expected less than 1", i + 1,
                              pad->preload);
    }
    return whirl_ok();
}

/// Returns the angle from the end of one pad to the beginning of another, 0 to a turn.
static double angle_to(const whirl_pad *pad, const whirl_pad *next) {
    const double turn = 6.283185307179586476925;
    const double end = pad->pivot + (1.0 - pad->offset) * pad->arc, start = next->pivot - next->offset * next->arc;
    const double angle = fmod(fmod(start - end, turn) + turn, turn);
    return turn - angle < 1e-9 ? 0.0 : angle;
}

double whirl_pads_gap(const whirl_pads *bearing, size_t pad) {
    double least = INFINITY;
    for (size_t i = 0; i < bearing->count; i++) least = fmin(least, angle_to(&bearing->pads[pad], &bearing->pads[i]));
    return least;
}

bool whirl_pads_overlap(const whirl_pads *bearing, size_t *one, size_t *other) {
    const double turn = 6.283185307179586476925;
    for (size_t i = 0; i < bearing->count; i++)
        for (size_t k = 0; k < bearing->count; k++) {
            const whirl_pad *pad = &bearing->pads[i], *over = &bearing->pads[k];
            const double start = pad->pivot - pad->offset * pad->arc, next = over->pivot - over->offset * over->arc;
            const double apart = fmod(fmod(next - start, turn) + turn, turn);
            if (i == k || !(apart < pad->arc - 1e-9) || (apart == 0.0 && k < i)) continue;
            *one = i;
            *other = k;
            return true;
        }
    return false;
}

static void add_up(const whirl_pads *bearing, whirl_pads_state *state) {
    memset(state->stiffness, 0, sizeof state->stiffness);
    memset(state->damping, 0, sizeof state->damping);
    for (size_t i = 0; i < bearing->count; i++)
        for (int r = 0; r < 2; r++)
            for (int c = 0; c < 2; c++) {
                state->stiffness[r][c] += state->of_pads[i][0][r][c];
                state->damping[r][c] += state->of_pads[i][1][r][c];
            }
}

/// Allocates the workspace for the finest grid of the widest pad.
static whirl_status workspace_of(const whirl_pads *bearing, pad_workspace **work) {
    const solver s = {.bearing = bearing, .coarser = 1};
    pad_film widest = {.around = 0};
    for (size_t i = 0; i < bearing->count; i++) {
        const pad_film film = film_of(&s, &bearing->pads[i]);
        if (film.around > widest.around) widest = film;
    }
    return pad_workspace_new(widest.around, widest.along, work);
}

static void load_all(const whirl_pads *bearing, whirl_pads_state *state) {
    *state = (whirl_pads_state){.thinnest = NAN};
    for (size_t i = 0; i < bearing->count; i++) state->loaded[i] = true;
}

whirl_status whirl_pads_at(const whirl_pads *bearing, const double place[2], whirl_pads_state *state) {
    solver s = {.bearing = bearing, .coarser = bearing->halved ? 2 : 1};
    whirl_status status = pads_check(bearing);
    if (status.code == WHIRL_OK) status = workspace_of(bearing, &s.work);
    if (status.code != WHIRL_OK) return status;
    load_all(bearing, state);
    status = look(&s, place, true, true, state);
    add_up(bearing, state);
    pad_workspace_free(s.work);
    return status;
}

whirl_status whirl_pads_rest(const whirl_pads *bearing, const double load[2], whirl_pads_state *state) {
    solver s = {.bearing = bearing, .coarser = COARSER};
    whirl_status status = pads_check(bearing);
    if (status.code == WHIRL_OK && !(hypot(load[0], load[1]) > 0.0))
        status = whirl_fail(WHIRL_BAD_INPUT, "the load on a bearing is 0, expected one above");
    if (status.code == WHIRL_OK) status = workspace_of(bearing, &s.work);
    *state = (whirl_pads_state){.thinnest = NAN};
    if (status.code != WHIRL_OK) return status;
    load_all(bearing, state);
    status = find_coarsely(&s, load, state);
    s.coarser = bearing->halved ? 2 : 1;
    if (status.code == WHIRL_OK) status = polish(&s, load, state);
    add_up(bearing, state);
    pad_workspace_free(s.work);
    return status;
}

// ---------------------------------------------------------------- reduced coefficients

/// Eliminates a pad, which follows the journal: subtracts Z T (T' Z T + D)^-1 T' Z from z, where T = (t, n) and D has
/// the pad's springs and inertia.
static void pads_eliminate_pad(const whirl_pads *bearing, const whirl_pad *pad, const double complex own[2][2],
                               double ratio, double inertia, double complex z[2][2]) {
    const bool yields = bearing->pivot_stiffness > 0.0;
    const size_t count = yields ? 2 : 1;
    double along[2][2];
    double complex zt[2][2], tz[2][2], a[2][2] = {{-ratio * ratio * inertia, 0.0}, {0.0, 1.0}};
    // Compute Z T, T' Z and T' Z T + D.
    tangent_of(pad, along[0]);
    normal_of(pad, along[1]);
    if (yields)
        a[1][1] = bearing->pivot_stiffness - ratio * ratio * bearing->pad_mass + I * ratio * bearing->pivot_damping;
    for (size_t k = 0; k < count; k++)
        for (int r = 0; r < 2; r++) {
            zt[k][r] = own[r][0] * along[k][0] + own[r][1] * along[k][1];
            tz[k][r] = along[k][0] * own[0][r] + along[k][1] * own[1][r];
        }
    for (size_t r = 0; r < count; r++)
        for (size_t c = 0; c < count; c++) a[r][c] += tz[r][0] * along[c][0] + tz[r][1] * along[c][1];
    // Subtract Z T (T' Z T + D)^-1 T' Z.
    const double complex determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    if (!(cabs(determinant) > 0.0)) return;
    const double complex inverse[2][2] = {{a[1][1] / determinant, -a[0][1] / determinant},
                                          {-a[1][0] / determinant, a[0][0] / determinant}};
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < count; k++)
            for (int r = 0; r < 2; r++)
                for (int c = 0; c < 2; c++) z[r][c] -= zt[i][r] * inverse[i][k] * tz[k][c];
}

void whirl_pads_reduced(const whirl_pads *bearing, const whirl_pads_state *state, double ratio, double inertia,
                        double stiffness[2][2], double damping[2][2]) {
    // At frequency 0 take the limit of damping, for which the terms of first order suffice.
    const double at = ratio != 0.0 ? ratio : 1e-6;
    double complex z[2][2];
    for (int r = 0; r < 2; r++)
        for (int c = 0; c < 2; c++) z[r][c] = state->stiffness[r][c] + I * at * state->damping[r][c];
    for (size_t i = 0; i < bearing->count && bearing->tilting; i++) {
        double complex own[2][2];
        for (int r = 0; r < 2; r++)
            for (int c = 0; c < 2; c++) own[r][c] = state->of_pads[i][0][r][c] + I * at * state->of_pads[i][1][r][c];
        if (state->loaded[i])
            pads_eliminate_pad(bearing, &bearing->pads[i], (const double complex(*)[2])own, at, inertia, z);
    }
    for (int r = 0; r < 2; r++)
        for (int c = 0; c < 2; c++) {
            stiffness[r][c] = creal(z[r][c]);
            damping[r][c] = cimag(z[r][c]) / at;
        }
}

// ---------------------------------------------------------------- usual bearings

bool whirl_pads_named(const char *name, double preload, whirl_pads *out) {
    // Angles are in degrees from the x axis, for a load along -y.
    static const double degree = 0.017453292519943295;
    static const struct {
        const char *name;
        size_t count;
        double first, arc, offset;
        bool preloaded, tilting;
    } known[] = {
        {"plain", 1, 270.0, 360.0, 0.5, false, false},    {"two-groove", 2, 90.0, 160.0, 0.5, false, false},
        {"elliptical", 2, 90.0, 160.0, 0.5, true, false}, {"three-lobe", 3, 90.0, 100.0, 0.5, true, false},
        {"four-lobe", 4, 45.0, 70.0, 0.5, true, false},   {"offset-half", 2, 90.0 + 80.0, 160.0, 1.0, true, false},
        {"tilting-4", 4, 45.0, 80.0, 0.5, true, true},    {"tilting-5", 5, 18.0, 60.0, 0.5, true, true},
    };
    // Distribute the pads evenly around the journal.
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strcmp(known[i].name, name) != 0) continue;
        out->count = known[i].count;
        out->tilting = known[i].tilting;
        for (size_t k = 0; k < out->count; k++)
            out->pads[k] = (whirl_pad){.pivot = (known[i].first + 360.0 * (double)k / (double)out->count) * degree,
                                       .arc = known[i].arc * degree,
                                       .offset = known[i].offset,
                                       .preload = known[i].preloaded ? preload : 0.0};
        return true;
    }
    return false;
}
