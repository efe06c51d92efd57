// Bearings of pads: from the films of single pads to where the journal rests, and how stiffly.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "centred.h"
#include "reynolds.h"
#include "whirl/bearing.h"

/// Of places and tilts for derivatives; forces are good to 1e-6 and better, differences are of fourth order.
static const double difference = 0.02;

enum { FINENESS = 960, ALONG = 24, COARSER = 4, MOST_STEPS = 60 };

/// R delta/c, beyond which no pad is looked for.
static const double widest_tilt = 20.0;

/// What is solved with.
typedef struct solver {
    const whirl_pads *bearing;
    pad_workspace *work;
    int coarser; ///< how many times coarser the grid is
} solver;

static double middle_of(const whirl_pad *pad) {
    return pad->pivot + (0.5 - pad->offset) * pad->arc;
}

/// Volumes around a pad and along half its length; they are halved for grids before them.
static pad_film film_of(const solver *s, const whirl_pad *pad) {
    const int fineness = s->bearing->fineness > 0 ? s->bearing->fineness : FINENESS;
    const double turn = 2.0 * acos(-1.0);
    const int eighths = (int)ceil(fmin(pad->arc / turn, 1.0) * fineness / 16.0), least = 6;
    const int around = 16 * (eighths < least ? least : eighths);
    return (pad_film){.arc = pad->arc,
                      .ratio = s->bearing->ratio,
                      .law = s->bearing->gumbel ? CAVITATION_GUMBEL : CAVITATION_REYNOLDS,
                      .around = around / s->coarser,
                      .along = ALONG / s->coarser};
}

/// A journal and a pad: what the film sees, in the frame of the bearing.
typedef struct seen {
    double place[2], velocity[2];
} seen;

/// The force of a pad's film on the journal, in the frame of the bearing.
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

/// Along the pad at its pivot, with the rotation.
static void tangent_of(const whirl_pad *pad, double t[2]) {
    t[0] = -sin(pad->pivot);
    t[1] = cos(pad->pivot);
}

/// The journal as a tilted pad sees it.
static seen tilted(const whirl_pad *pad, const double place[2], double tilt) {
    double t[2];
    tangent_of(pad, t);
    return (seen){.place = {place[0] - tilt * t[0], place[1] - tilt * t[1]}};
}

// ---------------------------------------------------------------- tilts

/// The tilts between which no part of a pad touches the journal; false where there are none. The film is least at an
/// edge or, between them, on the line to the journal.
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

/// What is asked of a tilt.
typedef struct balance {
    const solver *s;
    const whirl_pad *pad;
    const double *place;
    double force[2];
    pad_answer all;
} balance;

/// The force along the pad, whose moment about the pivot it is.
static whirl_status along_pad(balance *b, double tilt, double *along) {
    double t[2];
    const seen at = tilted(b->pad, b->place, tilt);
    const whirl_status status = force_of(b->s, b->pad, &at, b->force, &b->all);
    tangent_of(b->pad, t);
    *along = b->force[0] * t[0] + b->force[1] * t[1];
    return status;
}

/// The first two of tilts between which the film has no moment about the pivot and holds the pad: the force along it
/// grows with the tilt there. False where no film does.
static whirl_status bracket_tilt(balance *b, bracket *found, bool *held) {
    enum { LOOKS = 32 };
    double ends[2], last = 0.0, before = 0.0;
    *held = false;
    if (!free_tilts(b->pad, b->place, ends))
        return whirl_fail(WHIRL_BAD_INPUT, "the journal touches a pad, however that tilts");
    for (int k = 0; k <= LOOKS && !*held; k++) {
        const double here = ends[0] + (ends[1] - ends[0]) * k / LOOKS;
        double along;
        const whirl_status status = along_pad(b, here, &along);
        if (status.code != WHIRL_OK) return status;
        *held = k > 0 && before < 0.0 && along >= 0.0 && hypot(b->force[0], b->force[1]) > 0.0;
        if (*held) *found = bracket_between(last, before, here, along);
        last = here;
        before = along;
    }
    return whirl_ok();
}

/// The tilt of a pad at rest; 0 where no film holds it.
static whirl_status balance_pad(const solver *s, const whirl_pad *pad, const double place[2], double *tilt,
                                bool *held) {
    balance b = {.s = s, .pad = pad, .place = place};
    bracket found = {.a = 0.0};
    whirl_status status = bracket_tilt(&b, &found, held);
    *tilt = 0.0;
    for (int k = 0; *held && k < 100 && status.code == WHIRL_OK && bracket_width(&found) > 1e-10; k++) {
        double along;
        *tilt = bracket_next(&found);
        status = along_pad(&b, *tilt, &along);
        if (fabs(along) < 1e-12) break;
        bracket_tell(&found, *tilt, along);
    }
    return status;
}

double pad_centred_tilt(const whirl_pad *pad, double ratio, bool gumbel) {
    static const double middle[2] = {0.0, 0.0};
    const whirl_pads bearing = {.count = 1, .pads = {*pad}, .ratio = ratio, .tilting = true, .gumbel = gumbel};
    solver s = {.bearing = &bearing, .coarser = COARSER};
    const pad_film film = film_of(&s, pad);
    double tilt = 0.0;
    bool held;
    if (pad_workspace_new(film.around, film.along, &s.work).code != WHIRL_OK) return 0.0;
    if (balance_pad(&s, pad, middle, &tilt, &held).code != WHIRL_OK || !held) tilt = 0.0;
    pad_workspace_free(s.work);
    return tilt;
}

// ---------------------------------------------------------------- derivatives

/// -dF by the place (0) and by the velocity (1) of the journal before one pad.
static whirl_status derive(const solver *s, const whirl_pad *pad, const double place[2], double tilt, double thinnest,
                           double out[2][2][2]) {
    static const double weight[] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0}, at[] = {-2.0, -1.0, 1.0, 2.0};
    const seen rest = tilted(pad, place, tilt);
    // The force is homogeneous in (A, B), which at rest is the place before the pad.
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

/// Every pad at a place, with its tilt where that is asked for, and its derivatives.
static whirl_status look(const solver *s, const double place[2], bool balanced, bool derived, whirl_pads_state *state) {
    whirl_status status = whirl_ok();
    memcpy(state->at, place, sizeof state->at);
    state->force[0] = state->force[1] = state->highest = state->leaving = state->drag = 0.0;
    state->thinnest = INFINITY;
    for (size_t i = 0; i < s->bearing->count && status.code == WHIRL_OK; i++) {
        const whirl_pad *pad = &s->bearing->pads[i];
        balance b = {.s = s, .pad = pad, .place = place};
        double along;
        if (balanced && s->bearing->tilting) status = balance_pad(s, pad, place, &state->tilt[i], &state->loaded[i]);
        memset(state->of_pads[i], 0, sizeof state->of_pads[i]);
        state->load[i] = 0.0;
        if (status.code != WHIRL_OK || !state->loaded[i]) continue;
        status = along_pad(&b, state->tilt[i], &along);
        if (status.code == WHIRL_OK && derived)
            status = derive(s, pad, place, state->tilt[i], b.all.thinnest, state->of_pads[i]);
        state->load[i] = hypot(b.force[0], b.force[1]);
        state->moment[i] = along;
        for (int k = 0; k < 2; k++) state->force[k] += b.force[k];
        state->thinnest = fmin(state->thinnest, b.all.thinnest);
        state->highest = fmax(state->highest, b.all.highest);
        state->leaving += b.all.leaving;
        state->drag += b.all.drag;
    }
    return status;
}

// ---------------------------------------------------------------- rest

/// Solves K* d = r, with pads that are held following their tilts: K* = K - K t t K/(t K t). Then the change of the
/// tilts by that of the place and by what their moments lack.
static void step_of(const whirl_pads *bearing, const whirl_pads_state *state, const double lacking[2], double move[2],
                    double turn[WHIRL_MAX_PADS]) {
    double sum[2][2] = {{0.0}}, right[2] = {lacking[0], lacking[1]}, by[WHIRL_MAX_PADS][2], back[WHIRL_MAX_PADS];
    for (size_t i = 0; i < bearing->count; i++) {
        const double(*k)[2] = state->of_pads[i][0];
        double t[2], kt[2], tk[2];
        tangent_of(&bearing->pads[i], t);
        for (int r = 0; r < 2; r++) kt[r] = k[r][0] * t[0] + k[r][1] * t[1], tk[r] = t[0] * k[0][r] + t[1] * k[1][r];
        const double tkt = t[0] * kt[0] + t[1] * kt[1];
        const bool tilts = bearing->tilting && state->loaded[i] && tkt > 0.0;
        // F.t = moment - (t K) d + (t K t) turn = 0
        back[i] = tilts ? -state->moment[i] / tkt : 0.0;
        for (int c = 0; c < 2; c++) by[i][c] = tilts ? tk[c] / tkt : 0.0;
        for (int r = 0; r < 2; r++) {
            right[r] += kt[r] * back[i];
            for (int c = 0; c < 2; c++) sum[r][c] += k[r][c] - kt[r] * by[i][c];
        }
    }
    const double determinant = sum[0][0] * sum[1][1] - sum[0][1] * sum[1][0];
    move[0] = (right[0] * sum[1][1] - right[1] * sum[0][1]) / determinant;
    move[1] = (right[1] * sum[0][0] - right[0] * sum[1][0]) / determinant;
    for (size_t i = 0; i < bearing->count; i++) turn[i] = back[i] + by[i][0] * move[0] + by[i][1] * move[1];
}

static double lack(const whirl_pads_state *state, const double load[2], double lacking[2]) {
    for (int k = 0; k < 2; k++) lacking[k] = load[k] + state->force[k];
    return hypot(lacking[0], lacking[1]) / hypot(load[0], load[1]);
}

/// Newton's method on a coarse grid, pads at rest at every step; steps are halved until less is lacking.
static whirl_status find_coarsely(const solver *s, const double load[2], whirl_pads_state *state) {
    double lacking[2], move[2], turn[WHIRL_MAX_PADS];
    whirl_status status = look(s, state->at, true, true, state);
    for (int k = 0; k < MOST_STEPS && status.code == WHIRL_OK; k++) {
        const double before = lack(state, load, lacking);
        if (before < 1e-6) return status;
        step_of(s->bearing, state, lacking, move, turn);
        whirl_pads_state next;
        double share = fmin(1.0, 0.3 / hypot(move[0], move[1]));
        for (int half = 0; half < 30; half++, share *= 0.5) {
            const double place[2] = {state->at[0] + share * move[0], state->at[1] + share * move[1]};
            next = *state;
            status = look(s, place, true, false, &next);
            if (status.code == WHIRL_OK && lack(&next, load, lacking) < before) break;
            if (status.code != WHIRL_OK && status.code != WHIRL_BAD_INPUT) return status;
        }
        if (status.code != WHIRL_OK || !(lack(&next, load, lacking) < before)) break;
        status = look(s, next.at, true, true, state);
    }
    return whirl_fail(WHIRL_NUMERICAL_FAILURE, "no place was found where the films of the bearing carry the load");
}

/// Moves the journal and the tilts of pads on the finest grid by the derivatives of the coarse one, until all balances.
static whirl_status polish(const solver *s, const double load[2], whirl_pads_state *state) {
    whirl_status status = whirl_ok();
    for (int k = 0; k < MOST_STEPS && status.code == WHIRL_OK; k++) {
        double lacking[2], move[2], turn[WHIRL_MAX_PADS], slopes[WHIRL_MAX_PADS][2][2][2];
        memcpy(slopes, state->of_pads, sizeof slopes);
        status = look(s, state->at, false, false, state);
        memcpy(state->of_pads, slopes, sizeof slopes);
        if (status.code != WHIRL_OK) break;
        lack(state, load, lacking);
        step_of(s->bearing, state, lacking, move, turn);
        double most = hypot(move[0], move[1]);
        for (int c = 0; c < 2; c++) state->at[c] += move[c];
        for (size_t i = 0; i < s->bearing->count; i++) {
            state->tilt[i] += turn[i];
            most = fmax(most, fabs(turn[i]));
        }
        if (most < 1e-9) return look(s, state->at, false, true, state);
    }
    return status.code == WHIRL_OK
               ? whirl_fail(WHIRL_NUMERICAL_FAILURE, "the place of the journal does not settle on the finest grid")
               : status;
}

static whirl_status check(const whirl_pads *bearing) {
    const double turn = 2.0 * acos(-1.0);
    if (bearing->count == 0 || bearing->count > WHIRL_MAX_PADS)
        return whirl_fail(WHIRL_BAD_INPUT, "a bearing has %zu pads, expected 1 to %d", bearing->count, WHIRL_MAX_PADS);
    if (!(bearing->ratio > 0.0) || !isfinite(bearing->ratio))
        return whirl_fail(WHIRL_BAD_INPUT, "length over diameter is %g, expected a number above 0", bearing->ratio);
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

whirl_status whirl_pads_rest(const whirl_pads *bearing, const double load[2], whirl_pads_state *state) {
    solver s = {.bearing = bearing, .coarser = 1};
    whirl_status status = check(bearing);
    *state = (whirl_pads_state){.thinnest = NAN};
    if (status.code == WHIRL_OK && !(hypot(load[0], load[1]) > 0.0))
        status = whirl_fail(WHIRL_BAD_INPUT, "the load on a bearing is 0, expected one above");
    if (status.code != WHIRL_OK) return status;
    pad_film widest = {.around = 0};
    for (size_t i = 0; i < bearing->count; i++) {
        const pad_film film = film_of(&s, &bearing->pads[i]);
        if (film.around > widest.around) widest = film;
        state->loaded[i] = true;
    }
    status = pad_workspace_new(widest.around, widest.along, &s.work);
    if (status.code != WHIRL_OK) return status;
    s.coarser = COARSER;
    status = find_coarsely(&s, load, state);
    s.coarser = bearing->halved ? 2 : 1;
    if (status.code == WHIRL_OK) status = polish(&s, load, state);
    add_up(bearing, state);
    pad_workspace_free(s.work);
    return status;
}

// ---------------------------------------------------------------- reduced coefficients

void whirl_pads_reduced(const whirl_pads *bearing, const whirl_pads_state *state, double ratio, double inertia,
                        double stiffness[2][2], double damping[2][2]) {
    memcpy(stiffness, state->stiffness, sizeof state->stiffness);
    memcpy(damping, state->damping, sizeof state->damping);
    for (size_t i = 0; i < bearing->count && bearing->tilting; i++) {
        // Z = Z_qq - Z_qs Z_sq/Z_ss, Z_qs = -Z t, Z_sq = -t Z, Z_ss = t Z t - ratio^2 I (real and imaginary parts).
        const double(*k)[2] = state->of_pads[i][0], (*c)[2] = state->of_pads[i][1];
        double t[2], real[2][2] = {{0.0}}, imaginary[2][2] = {{0.0}}, ss[2] = {-ratio * ratio * inertia, 0.0};
        tangent_of(&bearing->pads[i], t);
        for (int r = 0; r < 2; r++)
            for (int s = 0; s < 2; s++) {
                real[0][r] += k[r][s] * t[s], imaginary[0][r] += ratio * c[r][s] * t[s];
                real[1][r] += t[s] * k[s][r], imaginary[1][r] += ratio * t[s] * c[s][r];
                ss[0] += t[r] * k[r][s] * t[s], ss[1] += ratio * t[r] * c[r][s] * t[s];
            }
        const double over = ss[0] * ss[0] + ss[1] * ss[1];
        if (!state->loaded[i] || !(over > 0.0)) continue;
        for (int r = 0; r < 2; r++)
            for (int s = 0; s < 2; s++) {
                const double x = real[0][r] * real[1][s] - imaginary[0][r] * imaginary[1][s];
                const double y = real[0][r] * imaginary[1][s] + imaginary[0][r] * real[1][s];
                stiffness[r][s] -= (x * ss[0] + y * ss[1]) / over;
                if (ratio != 0.0) damping[r][s] -= (y * ss[0] - x * ss[1]) / over / ratio;
            }
    }
}

// ---------------------------------------------------------------- usual bearings

bool whirl_pads_named(const char *name, double preload, whirl_pads *out) {
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
