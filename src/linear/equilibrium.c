// Static equilibrium by damped Newton steps. The load is applied in shares if the steps do not converge at once.
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equilibrium.h"
#include "exhausted.h"
#include "linear_status.h"
#include "load_path.h"
#include "matrix.h"
#include "mean.h"
#include "whirl/engine/linear.h"

/// Relative singular value below which a direction counts as a free motion and is not moved.
static const double free_direction = 1e-12;

/// A search for x with f(x) = (1 - share) f(start).
typedef struct search {
    mean_system *mean;
    double share;
    double *load;     ///< [count] f(start)
    double *weight;   ///< [count] weights of the residuals
    double *idle;     ///< [count] 1 for coordinates that are idle at the start, else 0
    double *f;        ///< [count] at x
    double *step;     ///< [count]
    double *jacobian; ///< [count][count]
    double *trial;    ///< [dimension]
} search;

static double size_of(const double *numbers, size_t count) {
    double largest = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) return (double)INFINITY;
        largest = fmax(largest, fabs(numbers[i]));
    }
    return largest;
}

static double norm_of(const search *s, const double *numbers) {
    double sum = 0.0;
    for (size_t i = 0; i < s->mean->count; i++) {
        const double own = s->weight[i] * numbers[i];
        sum += own * own;
    }
    return isfinite(sum) ? sqrt(sum) : (double)INFINITY;
}

/// Sets forces on coordinates that have a balance of their own to 0: these coordinates follow the other coordinates.
static void leave_settled(const mean_system *m, double *f) {
    for (size_t i = 0; i < m->count; i++)
        if (m->settled[m->kept[i]] != WHIRL_NOT_SETTLED) f[i] = 0.0;
}

/// Settles the coordinates that have a balance of their own, and returns the weighted residual at x.
static double residual(search *s, double *x) {
    const size_t n = s->mean->count;
    if (!mean_settle(s->mean, x)) return (double)INFINITY;
    mean_slope(s->mean, x, s->f);
    leave_settled(s->mean, s->f);
    for (size_t i = 0; i < n; i++) s->f[i] -= (1.0 - s->share) * s->load[i];
    return norm_of(s, s->f);
}

/// Keeps idle coordinates where they are, since no equation determines them. `own` becomes the eigenvalue of each.
static void hold_idle(const mean_system *m, double own, double *jacobian) {
    const size_t n = m->count;
    for (size_t i = 0; i < n; i++) {
        if (m->settled[m->kept[i]] != WHIRL_IDLE) continue;
        for (size_t k = 0; k < n; k++) jacobian[i * n + k] = jacobian[k * n + i] = 0.0;
        jacobian[i * n + i] = own;
    }
}

/// Finds the step to the zero of the linearised system, the shortest one if free motions leave a choice. *leads becomes
/// true if the step reaches the zero.
static bool find_step(search *s, const double *x, bool *leads) {
    const size_t n = s->mean->count;
    mean_jacobian(s->mean, x, s->jacobian);
    hold_idle(s->mean, 1.0, s->jacobian);
    for (size_t i = 0; i < n; i++) s->step[i] = -s->f[i];
    const double reach = 1e6 * (1.0 + size_of(x, s->mean->system->dimension));
    *leads = matrix_solve(n, s->jacobian, 1, s->step) && size_of(s->step, n) < reach;
    if (*leads) return true;
    for (size_t i = 0; i < n; i++) s->step[i] = -s->f[i];
    return matrix_solve_shortest(n, s->jacobian, free_direction, s->step, NULL);
}

static void go(const search *s, const double *x, double part, double *to) {
    memcpy(to, x, s->mean->system->dimension * sizeof *to);
    for (size_t i = 0; i < s->mean->count; i++) to[s->mean->kept[i]] += part * s->step[i];
}

/// Returns how large rounding may make the residual, from the terms of which it is a sum. The Jacobian is the one at x.
static double rounding_at(const search *s, const double *x) {
    const double of_a_term = 1e-12;
    const size_t n = s->mean->count;
    const double scale = 1.0 + size_of(x, s->mean->system->dimension);
    double squares = 0.0;
    for (size_t i = 0; i < n; i++) {
        double terms = 0.0;
        for (size_t c = 0; c < n; c++) terms += fabs(s->jacobian[i * n + c]);
        squares += s->weight[i] * s->weight[i] * terms * terms;
    }
    return of_a_term * scale * sqrt(squares);
}

/// Settles x, and returns true if it is an equilibrium of the whole load. A search may end where pads jump between two
/// balances: then the forces at x are no longer those that the search saw.
static bool balances(search *s, double *x) {
    const double of_load = 1e-6;
    s->share = 1.0;
    const double left = residual(s, x);
    if (!isfinite(left)) return false;
    mean_jacobian(s->mean, x, s->jacobian);
    return left <= of_load * norm_of(s, s->load) + rounding_at(s, x);
}

/// Returns true if f at x is the rounding error of forces that balance each other: if it is not much larger than the
/// differences between f and its linear form near x. The Jacobian is the one at x.
static bool is_rounding(search *s, const double *x) {
    static const double offsets[][2] = {
        {1e-15, 2e-15}, {-2e-14, 1e-14}, {3e-13, -1e-13}, {-1e-12, -3e-12}, {2e-11, 1e-11}};
    const size_t n = s->mean->count, d = s->mean->system->dimension;
    const double scale = 1.0 + size_of(x, d), norm = norm_of(s, s->f);
    double noise = 0.0;
    memcpy(s->step, s->f, n * sizeof *s->step);
    // Near x, subtract the linear form from f: what is left is rounding, if f is smooth.
    for (size_t k = 0; k < sizeof offsets / sizeof *offsets; k++) {
        double square = 0.0;
        memcpy(s->trial, x, d * sizeof *x);
        for (size_t i = 0; i < n; i++) s->trial[s->mean->kept[i]] += offsets[k][i % 2] * scale;
        if (!isfinite(residual(s, s->trial))) return false;
        for (size_t i = 0; i < n; i++) {
            double change = s->f[i] - s->step[i];
            for (size_t c = 0; c < n; c++)
                change -= s->jacobian[i * n + c] * (s->trial[s->mean->kept[c]] - x[s->mean->kept[c]]);
            change *= s->weight[i];
            square += change * change;
        }
        noise = fmax(noise, sqrt(square));
    }
    return norm <= 10.0 * fmin(noise, rounding_at(s, x));
}

/// Takes a step, halved until the residual falls; returns false if it does not fall.
static bool take_step(search *s, double *x, double *norm) {
    enum { MAX_HALVINGS = 20 };
    double part = 2.0;
    for (int halving = 0; halving < MAX_HALVINGS; halving++) {
        part *= 0.5;
        go(s, x, part, s->trial);
        const double next = residual(s, s->trial);
        if (!(next <= (1.0 - 0.1 * part) * *norm)) continue;
        memcpy(x, s->trial, s->mean->system->dimension * sizeof *x);
        *norm = next;
        return true;
    }
    residual(s, x);
    return false;
}

/// Runs Newton's method from x; returns false if it does not converge.
static bool equilibrium_solve(search *s, double *x) {
    enum { MAX_STEPS = 60 };
    const size_t n = s->mean->count, d = s->mean->system->dimension;
    double norm = residual(s, x);
    for (int k = 0; k < MAX_STEPS && isfinite(norm); k++) {
        bool leads;
        if (norm == 0.0) return true;
        if (!find_step(s, x, &leads)) return false;
        const double length = size_of(s->step, n), size = size_of(x, d);
        // Convergence is quadratic: after a step as short as this only rounding is left, unless the step does not reach
        // the zero.
        if (length <= 1e-9 * size + 1e-14) {
            go(s, x, 1.0, s->trial);
            const double next = residual(s, s->trial);
            if (next <= norm) memcpy(x, s->trial, d * sizeof *x);
            return leads || fmin(next, norm) <= 1e-7 * size_of(s->load, n) + 1e-12;
        }
        if (!take_step(s, x, &norm)) return is_rounding(s, x);
    }
    return false;
}

/// Divides each residual by the largest number in its row of the Jacobian at x, which makes it a displacement.
/// Otherwise the accelerations of a station of little mass, and their rounding, would hide all others.
static void weigh_rows(search *s, const double *x) {
    const size_t n = s->mean->count;
    mean_jacobian(s->mean, x, s->jacobian);
    for (size_t i = 0; i < n; i++) {
        const double largest = size_of(s->jacobian + i * n, n);
        s->weight[i] = largest > 0.0 && isfinite(largest) ? 1.0 / largest : 1.0;
    }
}

/// Applies the load in shares. Each search begins at the equilibrium of the previous share.
static bool bring_load_on(search *s, double *x, double *at) {
    const double least = 1.0 / 4096.0;
    const size_t d = s->mean->system->dimension;
    double done = 0.0, way = 1.0;
    while (done < 1.0) {
        s->share = fmin(1.0, done + way);
        memcpy(at, x, d * sizeof *at);
        if (equilibrium_solve(s, at)) {
            memcpy(x, at, d * sizeof *x);
            done = s->share;
            way *= 2.0;
        } else if ((way *= 0.5) < least) {
            s->share = done;
            return false;
        }
    }
    return true;
}

/// Writes the load of a probe's station. Returns the size of the load, 0 if it is not finite.
static double load_at(const mean_system *m, const double *load, const whirl_probe *probe, double force[2]) {
    force[0] = force[1] = 0.0;
    for (size_t i = 0; i < m->count; i++) {
        if (m->kept[i] == probe->vx) force[0] = load[i];
        if (m->kept[i] == probe->vy) force[1] = load[i];
    }
    const double size = hypot(force[0], force[1]);
    return isfinite(size) ? size : 0.0;
}

/// Moves journals out of the exact centre of their films, along their loads. In the centre the film's force has a kink,
/// so that Newton's method has no direction there.
static void leave_centres(const mean_system *m, const double *load, double *x) {
    const double away = 0.3, quarter = 0.7071067811865475;
    for (size_t p = 0; p < m->system->probe_count; p++) {
        const whirl_probe *probe = &m->system->probes[p];
        double force[2];
        if (!(probe->clearance > 0.0) || x[probe->x] != 0.0 || x[probe->y] != 0.0) continue;
        const double size = load_at(m, load, probe, force);
        if (size == 0.0) continue;
        const double way = whirl_probe_way(probe);
        x[probe->x] += away * probe->clearance * quarter * (force[0] - way * force[1]) / size;
        x[probe->y] += away * probe->clearance * quarter * (way * force[0] + force[1]) / size;
    }
}

/// Moves all stations along their loads, the station with the largest load by `distance` in length scales.
static void move_with_load(const mean_system *m, const double *load, double distance, double *x) {
    double largest = 0.0;
    for (size_t k = 0; k < m->count; k++) largest = fmax(largest, fabs(load[k]));
    for (size_t p = 0; p < m->system->probe_count && largest > 0.0; p++) {
        const whirl_probe *probe = &m->system->probes[p];
        for (size_t k = 0; k < m->count; k++) {
            if (m->kept[k] == probe->vx) x[probe->x] += distance * load[k] / largest;
            if (m->kept[k] == probe->vy && probe->y != probe->x) x[probe->y] += distance * load[k] / largest;
        }
    }
}

/// Moves a machine that has no stiffness at its start (within clearances) along its loads until something supports it.
/// There the whole load is applied at once.
static bool fall(search *s, const double *start, double *at) {
    enum { DOUBLINGS = 30 }; // from a millionth of the length scale to a thousand of them
    s->share = 1.0;
    for (int k = 0; k < DOUBLINGS; k++) {
        memcpy(at, start, s->mean->system->dimension * sizeof *at);
        move_with_load(s->mean, s->load, ldexp(1e-6, k), at);
        if (mean_settle(s->mean, at) && equilibrium_solve(s, at)) return true;
    }
    return false;
}

/// Counts the coordinates that are idle now and had stiffness at the start. With `unsaid` they become NaN in x.
static size_t count_lost(const search *s, double *x, bool unsaid) {
    const mean_system *m = s->mean;
    size_t count = 0;
    for (size_t i = 0; i < m->count; i++) {
        if (m->settled[m->kept[i]] != WHIRL_IDLE || s->idle[i] != 0.0) continue;
        if (unsaid) x[m->kept[i]] = (double)NAN;
        count++;
    }
    return count;
}

/// Replaces x by an equilibrium with films on the pads that lost theirs on the way to x. A pad with a spring may have
/// two balances, and a search that follows its tilt does not return to the film. at [dimension] is workspace.
static void regain_films(search *s, double *x, double *at) {
    const size_t d = s->mean->system->dimension;
    s->share = 1.0;
    memcpy(at, x, d * sizeof *at);
    mean_settle(s->mean, at);
    for (size_t lost = count_lost(s, at, true), left; lost > 0; lost = left) {
        if (!mean_settle(s->mean, at) || count_lost(s, at, false) >= lost || !equilibrium_solve(s, at)) return;
        if (!balances(s, at) || count_lost(s, at, false) >= lost) return;
        memcpy(x, at, d * sizeof *x);
        left = count_lost(s, at, true);
    }
}

// ---------------------------------------------------------------- one of several

/// Returns the largest real part of the eigenvalues at x, without idle coordinates; INFINITY if the eigenvalues are not
/// found. `work` [count][count + 2] is workspace.
static double growth_at(search *s, double *x, double *work) {
    const size_t n = s->mean->count;
    double *real = work + n * n, *imaginary = real + n, growth = -(double)INFINITY, size = 0.0;
    mean_settle(s->mean, x);
    mean_jacobian(s->mean, x, work);
    hold_idle(s->mean, -1.0, work);
    if (!matrix_eigen(n, work, real, imaginary, NULL)) return (double)INFINITY;
    for (size_t i = 0; i < n; i++) {
        growth = fmax(growth, real[i]);
        size = fmax(size, hypot(real[i], imaginary[i]));
    }
    return growth > 1e-9 * size ? growth : 0.0; // a coordinate that nothing holds has an eigenvalue of 0, to rounding
}

/// Moves journals to a part of their clearances, at an angle from their loads in the direction of rotation, and pads to
/// a balance with films.
static bool place_journals(const search *s, const double *start, double part, double angle, double *at) {
    const mean_system *m = s->mean;
    memcpy(at, start, m->system->dimension * sizeof *at);
    for (size_t i = 0; i < m->count; i++)
        if (m->settled[m->kept[i]] != WHIRL_NOT_SETTLED) at[m->kept[i]] = (double)NAN;
    for (size_t p = 0; p < m->system->probe_count; p++) {
        const whirl_probe *probe = &m->system->probes[p];
        double force[2];
        if (!(probe->clearance > 0.0) || probe->x == probe->y) continue;
        const double size = load_at(m, s->load, probe, force), turned = whirl_probe_way(probe) * angle;
        if (size == 0.0) continue;
        at[probe->x] = part * probe->clearance * (cos(turned) * force[0] - sin(turned) * force[1]) / size;
        at[probe->y] = part * probe->clearance * (sin(turned) * force[0] + cos(turned) * force[1]) / size;
    }
    return mean_settle(s->mean, at);
}

/// Places of the journals from which a search begins: parts of their clearances, and angles from their loads.
static const double parts[] = {0.3, 0.6, 0.8, 0.9, 0.96}, angles[] = {0.0, 0.2, -0.2, 0.4, -0.4, 0.8, -0.8, 1.4, -1.4};

/// Replaces an equilibrium that is unstable, or none (`found` false), by a stable one, which is searched from other
/// places of the journals. If there was no equilibrium, takes an unstable one, too. Pads, and therefore machines on
/// them, have several balances. Returns true if x is an equilibrium.
static bool prefer_stable(search *s, bool found, const double *start, double *x, double *at) {
    const size_t n = s->mean->count, d = s->mean->system->dimension;
    double *work = malloc((n * (n + 2) + 1) * sizeof *work);
    double growth = !work ? 0.0 : found ? growth_at(s, x, work) : (double)INFINITY;
    s->share = 1.0;
    for (size_t a = 0; a < sizeof angles / sizeof *angles; a++)
        for (size_t p = 0; p < sizeof parts / sizeof *parts && growth > 0.0; p++) {
            if (!place_journals(s, start, parts[p], angles[a], at) || !equilibrium_solve(s, at) || !balances(s, at))
                continue;
            double apart = 0.0;
            for (size_t i = 0; i < d; i++) apart = fmax(apart, fabs(at[i] - x[i]));
            if (found && apart <= 1e-6) continue;
            const double own = growth_at(s, at, work);
            if (own > 0.0 && found) continue;
            memcpy(x, at, d * sizeof *x);
            growth = own;
            found = true;
        }
    free(work);
    return found;
}

/// Returns the largest clearance of a journal; 0 if there is none.
static double largest_clearance(const whirl_system *system) {
    double largest = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) largest = fmax(largest, system->probes[p].clearance);
    return largest;
}

/// Finds an equilibrium by following all coordinates at once over the share of the load, from the same places of the
/// journals. The other searches balance the tilts of pads for a fixed journal. They miss equilibria in which the tilt
/// of a pad on a spring is stable only because the journal can move with it. Of several equilibria the one with the
/// least growth is taken.
static bool search_paths(search *s, const double *start, double *x, double *at) {
    const size_t n = s->mean->count, d = s->mean->system->dimension;
    const double unit = largest_clearance(s->mean->system);
    double *work = malloc((n * (n + 2) + 1) * sizeof *work), least = (double)INFINITY;
    for (size_t a = 0; a < sizeof angles / sizeof *angles && unit > 0.0; a++)
        for (size_t p = 0; p < sizeof parts / sizeof *parts && work && least > 0.0; p++) {
            if (!place_journals(s, start, parts[p], angles[a], at) || !load_path_follow(s->mean, unit, at)) continue;
            const double growth = balances(s, at) ? growth_at(s, at, work) : (double)INFINITY;
            if (!(growth < least)) continue;
            memcpy(x, at, d * sizeof *x);
            least = growth;
        }
    free(work);
    return isfinite(least);
}

// ---------------------------------------------------------------- the whole

/// Finds the equilibrium from x on. The load is applied in shares if necessary. *share becomes the part of the load up
/// to which the equilibrium was followed.
static whirl_status rest_follow(mean_system *m, double *x, double *share) {
    const size_t n = m->count, d = m->system->dimension;
    double *block = calloc(5 * n + n * n + 4 * d + 1, sizeof *block);
    if (!block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the equilibrium of %zu coordinates", d);
    search s = {.mean = m,
                .load = block,
                .f = block + n,
                .step = block + 2 * n,
                .weight = block + 3 * n,
                .idle = block + 4 * n,
                .jacobian = block + 5 * n,
                .trial = block + 5 * n + n * n};
    // Compute the load at the start; the weights of all residuals are 1 at first.
    double *at = s.trial + d, *start = at + d, *begin = start + d;
    memcpy(at, x, d * sizeof *x);
    memcpy(begin, x, d * sizeof *x);
    mean_settle(m, at);
    for (size_t i = 0; i < n; i++) {
        s.weight[i] = 1.0;
        s.idle[i] = m->settled[m->kept[i]] == WHIRL_IDLE;
    }
    mean_slope(m, x, s.load);
    leave_centres(m, s.load, x);
    // Begin the search at x, with journals out of their centres.
    bool starts = mean_settle(m, x);
    mean_slope(m, x, s.load);
    leave_settled(m, s.load);
    starts = starts && isfinite(norm_of(&s, s.load));
    memcpy(start, x, d * sizeof *x);
    // Apply the load in shares; if that fails, again with residuals weighed as displacements.
    bool found = starts && bring_load_on(&s, x, at);
    *share = starts ? s.share : 0.0;
    if (starts && !found) {
        weigh_rows(&s, start);
        found = bring_load_on(&s, start, at);
        *share = fmax(*share, s.share);
        if (found) memcpy(x, start, d * sizeof *x);
    }
    // A machine without stiffness at the start falls until something supports it.
    if (starts && !found && *share == 0.0) {
        found = fall(&s, start, at);
        if (found) memcpy(x, at, d * sizeof *x);
    }
    if (found) regain_films(&s, x, at);
    if (starts && m->system->settle) {
        found = prefer_stable(&s, found && balances(&s, x), begin, x, at);
        found = found || search_paths(&s, begin, x, at);
    }
    free(block);
    if (found) return whirl_ok();
    if (!starts)
        return whirl_fail(WHIRL_NUMERICAL_FAILURE,
                          "no equilibrium was searched for: forces are not finite where the search "
                          "begins, expected a start inside every clearance");
    return whirl_fail(WHIRL_NUMERICAL_FAILURE,
                      "no equilibrium was found: it could be followed up to %.3g %% of the static load from the start, "
                      "expected a machine that its supports carry, or an initial state near where it rests",
                      100.0 * *share);
}

whirl_status rest_find(mean_system *m, double *x) {
    double share;
    return rest_follow(m, x, &share);
}

double whirl_equilibrium_share(const whirl_system *system, const double *start) {
    mean_system mean;
    void *block;
    double share = 0.0, *x = malloc((system->dimension + 1) * sizeof *x);
    if (x && mean_begin(&mean, system, &block).code == WHIRL_OK) {
        memcpy(x, start, system->dimension * sizeof *x);
        rest_follow(&mean, x, &share);
        free(block);
    }
    free(x);
    return share;
}

whirl_status whirl_equilibrium(const whirl_system *system, double *x) {
    mean_system mean;
    void *block;
    const int before = exhausted_watch();
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code == WHIRL_OK) status = rest_find(&mean, x);
    free(block);
    return linear_status(before, status, system->dimension);
}

whirl_status whirl_rest_contacts(const whirl_system *system, const double *x, double *force) {
    mean_system mean;
    void *block;
    if (!system->contacts || system->contact_count == 0) return whirl_ok();
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    double *work = calloc(system->contact_count, sizeof *work);
    if (work)
        mean_contacts(&mean, x, force, work);
    else
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the forces of %zu contacts", system->contact_count);
    free(work);
    free(block);
    return status;
}

whirl_status whirl_rest_slope(const whirl_system *system, const double *x, double *slope, double *jacobian) {
    // Take the mean system, without coordinates that turn.
    const size_t d = system->dimension;
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    const size_t n = mean.count;
    // Compute its slope and Jacobian.
    double *own = calloc(n + n * n + 1, sizeof *own);
    if (own) {
        mean_slope(&mean, x, own);
        mean_jacobian(&mean, x, own + n);
        memset(slope, 0, d * sizeof *slope);
        memset(jacobian, 0, d * d * sizeof *jacobian);
    }
    // Copy them to the places of the kept coordinates; the other coordinates keep 0.
    for (size_t i = 0; own && i < n; i++) {
        slope[mean.kept[i]] = own[i];
        for (size_t k = 0; k < n; k++) jacobian[mean.kept[i] * d + mean.kept[k]] = own[n + i * n + k];
    }
    if (!own) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the Jacobian of %zu coordinates", d);
    free(own);
    free(block);
    return status;
}
