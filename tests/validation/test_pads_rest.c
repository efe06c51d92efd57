// Journals in pads that tilt, at rest: places, stiffness and stability of machines against `whirl bearing`
// (whirl_pads_rest), which solves Reynolds' equation itself where machines look tables up.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"
#include "whirl/internal/bearing.h"

static const double pi = 3.14159265358979323846;

/// The bearing of the grid: 20 mPa s, R 50 mm, L 50 mm, c 0.1 mm at 3000 rpm; mu omega R L (R/c)^2 in N.
static const double viscosity = 0.02, radius = 0.05, length = 0.05, clearance = 1e-4, speed = 100.0 * 3.14159265358979;

static double unit(void) {
    return viscosity * speed * radius * length * pow(radius / clearance, 2.0);
}

/// Pads alike, evenly around; the load is along -y, on a pad or between two.
typedef struct layout {
    const char *name;
    size_t count;
    double first, arc; ///< degrees
} layout;

static const layout layouts[] = {{"4 pads, load between", 4, 45.0, 75.0},
                                 {"4 pads, load on", 4, 0.0, 75.0},
                                 {"5 pads, load between", 5, 18.0, 60.0},
                                 {"5 pads, load on", 5, 54.0, 60.0}};

/// Inertia and springs of pads.
typedef struct tilt_case {
    const char *name;
    double inertia, stiffness;
    double pivot; ///< N/m; 0: rigid
} tilt_case;

static const tilt_case tilts[] = {{"no inertia", 0.0, 0.0, 0.0},
                                  {"inertia", 2e-4, 0.0, 0.0},
                                  {"inertia, spring", 2e-4, 2.0, 0.0},
                                  {"no inertia, stiff pivots", 0.0, 0.0, 1e9},
                                  {"inertia, stiff pivots", 2e-4, 0.0, 1e9}};

/// Returns the angle of pad i; for a load along -y the layout is symmetric about y.
static double pivot_of(const layout *of, size_t i) {
    return of->first + 360.0 * (double)i / (double)of->count;
}

/// Makes the bearing with the pad `first` listed first.
static whirl_rotor *make_listed(const layout *of, size_t first, double preload, double mass, const tilt_case *tilt,
                                double way) {
    char pivots[128] = "";
    for (size_t i = 0; i < of->count; i++)
        snprintf(pivots + strlen(pivots), sizeof pivots - strlen(pivots), "%s%.15g", i > 0 ? ", " : "",
                 pivot_of(of, (first + i) % of->count) * pi / 180.0);
    const whirl_setting pads[] = {{"at", 0, "j"},
                                  {"pivots", 0, pivots},
                                  {"arc", of->arc * pi / 180.0, NULL},
                                  {"preload", preload, NULL},
                                  {"clearance", clearance, NULL},
                                  {"viscosity", viscosity, NULL},
                                  {"radius", radius, NULL},
                                  {"length", length, NULL},
                                  {"inertia", tilt->inertia, NULL},
                                  {"tilt_stiffness", tilt->stiffness, NULL},
                                  {"pivot_stiffness", tilt->pivot, NULL},
                                  {"pad_mass", 0.4, NULL}};
    const size_t settings = sizeof pads / sizeof *pads - (tilt->pivot > 0.0 ? 0 : 2);
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(way * speed, clearance, &design));
    require_ok(whirl_design_station(design, "j", &(whirl_setting){"mass", mass, NULL}, 1));
    require_ok(whirl_design_element(design, "tilting_pad", pads, settings));
    require_ok(whirl_design_element(design, "gravity", NULL, 0));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static whirl_rotor *make(const layout *of, double preload, double mass, const tilt_case *tilt, double way) {
    return make_listed(of, 0, preload, mass, tilt, way);
}

static whirl_pads pads_of(const layout *of, double preload) {
    whirl_pads pads = {.count = of->count, .ratio = 0.5, .tilting = true, .fineness = 240};
    for (size_t i = 0; i < of->count; i++)
        pads.pads[i] = (whirl_pad){pivot_of(of, i) * pi / 180.0, of->arc * pi / 180.0, 0.5, preload};
    return pads;
}

/// Carries x by fixed steps of Runge and Kutta's method, `steps` a revolution.
static void carry(const whirl_system *system, double *x, int revolutions, int steps) {
    static const double part[] = {0.0, 0.5, 0.5, 1.0}, weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const double h = system->period / steps, off[WHIRL_MAX_FORCING] = {0.0};
    double slope[64], at[64], sum[64];
    for (int n = 0; n < revolutions * steps; n++) {
        memset(slope, 0, sizeof slope);
        memcpy(sum, x, sizeof sum);
        for (int k = 0; k < 4; k++) {
            for (size_t i = 0; i < system->dimension; i++) at[i] = x[i] + part[k] * h * slope[i];
            system->rhs(system->model, 0.0, off, at, slope);
            for (size_t i = 0; i < system->dimension; i++) sum[i] += weight[k] * h * slope[i];
        }
        memcpy(x, sum, system->dimension * sizeof *x);
    }
}

/// Checks one place of rest: it is that of the reference to 0.01 c and stable, and that of the mirror image is its
/// mirror image to rounding.
static void check_rest(const layout *of, double preload, double load, const tilt_case *tilt, const double place[2]) {
    const double mass = load * unit() / 9.80665;
    double found[2][2];
    for (int k = 0; k < 2; k++) {
        whirl_rotor *rotor = make(of, preload, mass, tilt, k == 0 ? 1.0 : -1.0);
        const whirl_system *system = whirl_rotor_system(rotor);
        double *start = calloc(system->dimension, sizeof *start);
        whirl_modes *modes = NULL;
        whirl_rotor_complete(rotor, start);
        const whirl_status status = whirl_modes_new(system, start, &modes);
        char name[160];
        snprintf(name, sizeof name, "%s, m %g, S %.2f, %s, %s", of->name, preload, 1.0 / (pi * load), tilt->name,
                 k == 0 ? "from x to y" : "from y to x");
        require_ok(status);
        for (int c = 0; c < 2; c++) found[k][c] = modes->rest[c];
        check_within("Pads at rest", words("%s: place", name), 0.0,
                     hypot(found[k][0] - (k == 0 ? 1.0 : -1.0) * place[0], found[k][1] - place[1]), 0.01);
        assert_true(modes->growth < 0.0);
        whirl_modes_free(modes);
        free(start);
        whirl_rotor_free(rotor);
    }
    check_within("Pads at rest", "mirror image", 0.0, hypot(found[0][0] + found[1][0], found[0][1] - found[1][1]),
                 1e-9);
}

static void grid(void **unused) {
    static const double preloads[] = {0.2, 0.5}, sommerfeld[] = {0.05, 0.1, 0.2, 0.35, 0.55, 0.85, 1.2, 1.6};
    (void)unused;
    for (size_t l = 0; l < sizeof layouts / sizeof *layouts; l++)
        for (size_t p = 0; p < 2; p++) {
            whirl_pads bearing = pads_of(&layouts[l], preloads[p]);
            whirl_pads_state state;
            for (size_t s = 0; s < sizeof sommerfeld / sizeof *sommerfeld; s++)
                for (size_t t = 0; t < sizeof tilts / sizeof *tilts; t++) {
                    const double load = 1.0 / (pi * sommerfeld[s]);
                    // Tilts with the same pivots have one reference.
                    if (t == 0 || tilts[t].pivot != tilts[t - 1].pivot) {
                        bearing.pivot_stiffness = tilts[t].pivot * clearance / unit();
                        require_ok(whirl_pads_rest(&bearing, (const double[]){0.0, -load}, &state));
                    }
                    check_rest(&layouts[l], preloads[p], load, &tilts[t], state.at);
                }
        }
}

// ---------------------------------------------------------------- what rests are made of

/// Makes a machine of that bearing alone, with its journal at a place.
static whirl_rotor *make_alone(const char *kind, const whirl_setting *settings, size_t count) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, clearance, &design));
    require_ok(whirl_design_station(design, "j", &(whirl_setting){"mass", 1.0, NULL}, 1));
    require_ok(whirl_design_element(design, kind, settings, count));
    whirl_design_bearings(design, WHIRL_BEARINGS_ALONE, 0.0);
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Coefficients of pads that follow once a revolution: those of whirl_pads_reduced to 3 % of the largest, which is what
/// the slopes of tables err by.
static void condensed(void **unused) {
    static const double inertias[] = {0.0, 2e-4}, load = 0.6;
    const layout *of = &layouts[2];
    (void)unused;
    whirl_pads bearing = pads_of(of, 0.5);
    whirl_pads_state state;
    require_ok(whirl_pads_rest(&bearing, (const double[]){0.0, -load}, &state));
    for (size_t i = 0; i < 2; i++) {
        const whirl_setting pads[] = {{"at", 0, "j"},
                                      {"shape", 0, "tilting-5"},
                                      {"preload", 0.5, NULL},
                                      {"clearance", clearance, NULL},
                                      {"viscosity", viscosity, NULL},
                                      {"radius", radius, NULL},
                                      {"length", length, NULL},
                                      {"inertia", inertias[i], NULL}};
        whirl_rotor *rotor = make_alone("tilting_pad", pads, sizeof pads / sizeof *pads);
        const whirl_system *system = whirl_rotor_system(rotor);
        const whirl_machine alone = {
            .system = system, .clock = whirl_rotor_clock(rotor), .speed = whirl_rotor_speed(rotor)};
        double *x = calloc(system->dimension, sizeof *x), found[8], k[2][2], c[2][2];
        x[0] = state.at[0];
        x[1] = state.at[1];
        require_ok(whirl_bearing_coefficients(&alone, x, found));
        whirl_pads_reduced(&bearing, &state, 1.0,
                           inertias[i] * speed * pow(clearance, 3.0) / (viscosity * length * pow(radius, 5.0)), k, c);
        for (size_t n = 0; n < 8; n++) {
            const double *of_kind = n < 4 ? k[0] : c[0], size = unit() / clearance / (n < 4 ? 1.0 : speed);
            check_within("Pads at rest", words("pads that follow, inertia %g: coefficient %zu", inertias[i], n),
                         size * of_kind[n % 4], found[n], 0.03 * size * fmax(of_kind[0], of_kind[3]));
        }
        free(x);
        whirl_rotor_free(rotor);
    }
}

/// The least film is that of the pads' own shape: of fixed pads by whirl_pads_at, of tilting ones by whirl_pads_rest.
static void least_film(void **unused) {
    static const struct {
        const char *shape;
        double preload;
    } fixed[] = {
        {"two-groove", 0.0}, {"elliptical", 0.5}, {"three-lobe", 0.5}, {"four-lobe", 0.6}, {"offset-half", 0.5}};
    static const double places[][2] = {{0.1, -0.2}, {0.3, 0.05}, {-0.15, 0.1}};
    (void)unused;
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++) {
        const whirl_setting settings[] = {{"at", 0, "j"},
                                          {"shape", 0, fixed[i].shape},
                                          {"preload", fixed[i].preload, NULL},
                                          {"clearance", clearance, NULL},
                                          {"viscosity", viscosity, NULL},
                                          {"radius", radius, NULL},
                                          {"length", length, NULL}};
        whirl_rotor *rotor = make_alone("pad_bearing", settings, sizeof settings / sizeof *settings);
        const whirl_system *system = whirl_rotor_system(rotor);
        whirl_pads bearing = {.ratio = 0.5, .fineness = 240};
        assert_true(whirl_pads_named(fixed[i].shape, fixed[i].preload, &bearing));
        for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
            whirl_pads_state state;
            whirl_film_gap gap;
            const double x[4] = {places[k][0], places[k][1], 0.0, 0.0};
            require_ok(whirl_pads_at(&bearing, places[k], &state));
            assert_true(system->film(system->model, x, 0, &gap));
            check_within("Pads at rest", words("least film of %s at (%g, %g)", fixed[i].shape, x[0], x[1]),
                         state.thinnest, gap.least, 2e-3);
            // A journal that goes on in that direction touches at the wall.
            const double over = gap.wall / hypot(x[0], x[1]), at[4] = {over * x[0], over * x[1], 0.0, 0.0};
            assert_true(system->film(system->model, at, 0, &gap));
            check_within("Pads at rest", words("film at the wall of %s", fixed[i].shape), 0.0, gap.least, 1e-12);
        }
        whirl_rotor_free(rotor);
    }
    const whirl_pads bearing = pads_of(&layouts[2], 0.2);
    whirl_pads_state state;
    require_ok(whirl_pads_rest(&bearing, (const double[]){0.0, -0.6}, &state));
    whirl_rotor *rotor = make(&layouts[2], 0.2, 0.6 * unit() / 9.80665, &tilts[1], 1.0);
    const whirl_system *system = whirl_rotor_system(rotor);
    double *x = calloc(system->dimension, sizeof *x);
    whirl_film_gap gap;
    require_ok(whirl_equilibrium(system, x));
    assert_true(system->film(system->model, x, 0, &gap));
    check_within("Pads at rest", "least film of pads that tilt", state.thinnest, gap.least, 2e-3);
    assert_int_equal(gap.pads, 5);
    for (size_t i = 0; i < gap.pads; i++) assert_int_equal(gap.held[i], state.loaded[i]);
    free(x);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- motions, and forces that balance without a load

/// Dropped from the middle of a lightly preloaded bearing a journal comes to where it rests; pads above it lose their
/// films on the way.
static void dropped(void **unused) {
    static const double masses[] = {400.0, 1600.0};
    (void)unused;
    for (size_t i = 0; i < 2; i++) {
        whirl_rotor *rotor = make(&layouts[2], 0.2, masses[i], &tilts[1], i == 0 ? 1.0 : -1.0);
        const whirl_system *system = whirl_rotor_system(rotor);
        double x[64] = {0.0}, rest[64] = {0.0};
        whirl_rotor_complete(rotor, x);
        carry(system, x, 5, 16000);
        require_ok(whirl_equilibrium(system, rest));
        check_within("Pads at rest", words("%g kg dropped: place after 5 revolutions", masses[i]), 0.0,
                     hypot(x[0] - rest[0], x[1] - rest[1]), 1e-4);
        whirl_rotor_free(rotor);
    }
}

/// Preloaded balls and rollers without a load rest in the middle, at any speed, in any unit of length.
static void preloaded(void **unused) {
    static const double speeds[] = {1e-3, 0.1, 1.0, 100.0}, scales[] = {1e-4, 1e-9, 1.0};
    static const char *const kinds[] = {"ball_bearing", "roller_bearing"};
    (void)unused;
    for (size_t i = 0; i < 2 * 4 * 3; i++) {
        const double rate = speeds[i % 4], scale = scales[i / 4 % 3];
        const whirl_setting rolling[] = {{"at", 0, "j"},
                                         {i / 12 ? "rollers" : "balls", 8, NULL},
                                         {"stiffness", i / 12 ? 1e8 : 1e10, NULL},
                                         {"clearance", -5e-6, NULL},
                                         {"cage", 0.4, NULL}};
        const whirl_setting spring[] = {{"between", 0, "j, ground"}, {"stiffness", 1e6, NULL}};
        whirl_design *design;
        whirl_rotor *rotor;
        require_ok(whirl_design_new(rate, scale, &design));
        require_ok(whirl_design_station(design, "j", &(whirl_setting){"mass", 10.0, NULL}, 1));
        require_ok(whirl_design_element(design, kinds[i / 12], rolling, 5));
        require_ok(whirl_design_element(design, "spring", spring, 2));
        require_ok(whirl_rotor_new(design, &rotor));
        whirl_design_free(design);
        double x[16] = {0.0};
        require_ok(whirl_equilibrium(whirl_rotor_system(rotor), x));
        check_within("Pads at rest", words("%s without load at %g rad/s, m", kinds[i / 12], rate), 0.0,
                     scale * hypot(x[0], x[1]), 1e-15);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- pads on springs

/// Makes 220 kg in five pads on springs of 2 kN m/rad at 8000 rpm, pushed across by a seal of q, N/m. Above the journal
/// a pad on its spring has equilibria with a film and without one.
static whirl_rotor *make_pushed(double q, double way, double scale) {
    const double across = way * q;
    const whirl_setting pads[] = {{"at", 0, "j"},
                                  {"shape", 0, "tilting-5"},
                                  {"preload", 0.3, NULL},
                                  {"clearance", 144.78e-6, NULL},
                                  {"radius", 57.15e-3, NULL},
                                  {"length", 57.15e-3, NULL},
                                  {"viscosity", 11e-3, NULL},
                                  {"tilt_stiffness", 2000.0, NULL}};
    const whirl_setting seal[] = {{"at", 0, "j"}, {"role", 0, "seal"}, {"kxy", across, NULL}, {"kyx", -across, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(way * 8000.0 * pi / 30.0, scale, &design));
    require_ok(whirl_design_station(design, "j", &(whirl_setting){"mass", 220.0, NULL}, 1));
    require_ok(whirl_design_element(design, "tilting_pad", pads, sizeof pads / sizeof *pads));
    require_ok(whirl_design_element(design, "bearing", seal, sizeof seal / sizeof *seal));
    require_ok(whirl_design_element(design, "gravity", NULL, 0));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Carries x, which begins near the equilibrium, for 30 revolutions, and returns its final distance from there.
static void check_comes_back(const whirl_system *system, const double *rest, double *x, double q, const char *from) {
    carry(system, x, 30, 400);
    check_within("Pads at rest", words("pads on springs, %g MN/m: place after 30 revolutions from %s", 1e-6 * q, from),
                 0.0, hypot(x[0] - rest[0], x[1] - rest[1]), 1e-5);
}

/// Machines whose equilibrium was not found while tilts jumped from one balance to the other: it is found at the place
/// where motions settle, for the mirror image and in any unit of length, too. From 8 MN/m on there are two equilibria,
/// and motions from the middle settle at the other one.
static void springs(void **unused) {
    enum { PUSHES = 14 };
    (void)unused;
    for (size_t i = 0; i < PUSHES; i++) {
        const double q = 1e6 * (4.0 + 0.5 * (double)i), unit_of[] = {144.78e-6, 144.78e-6, 1e-3}, way[] = {1, -1, 1};
        double place[3][2];
        for (size_t k = 0; k < 3; k++) {
            whirl_rotor *rotor = make_pushed(q, way[k], unit_of[k]);
            const whirl_system *system = whirl_rotor_system(rotor);
            double start[64] = {0.0}, rest[64];
            whirl_modes *modes;
            whirl_rotor_complete(rotor, start);
            require_ok(whirl_modes_new(system, start, &modes));
            assert_true(modes->growth < 0.0);
            memcpy(rest, modes->rest, system->dimension * sizeof *rest);
            whirl_modes_free(modes);
            for (size_t c = 0; c < 2; c++) place[k][c] = rest[c] * unit_of[k] / unit_of[0];
            if (k == 0 && q < 8e6) check_comes_back(system, rest, start, q, "the middle");
            memcpy(start, rest, sizeof start);
            start[0] += 1e-3;
            if (k == 0 && q >= 8e6) check_comes_back(system, rest, start, q, "a push");
            whirl_rotor_free(rotor);
        }
        check_within("Pads at rest", "pads on springs, mirror image", 0.0,
                     hypot(place[0][0] + place[1][0], place[0][1] - place[1][1]), 1e-9);
        check_within("Pads at rest", "pads on springs, another unit of length", 0.0,
                     hypot(place[0][0] - place[2][0], place[0][1] - place[2][1]), 1e-9);
    }
}

/// Of two equilibria a machine stays at the nearer one: a motion from the middle settles without the film of a pad that
/// has one in the equilibrium of `springs`.
static void kept(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_pushed(8e6, 1.0, 144.78e-6);
    const whirl_system *system = whirl_rotor_system(rotor);
    double x[64] = {0.0}, rest[64] = {0.0}, other[64] = {0.0};
    whirl_rotor_complete(rotor, x);
    memcpy(other, x, sizeof other);
    carry(system, x, 40, 400);
    memcpy(rest, x, sizeof rest);
    require_ok(whirl_equilibrium(system, rest));
    require_ok(whirl_equilibrium(system, other));
    check_within("Pads at rest", "pads on springs, place from where a motion has settled", 0.0,
                 hypot(rest[0] - x[0], rest[1] - x[1]), 1e-6);
    assert_true(hypot(rest[0] - other[0], rest[1] - other[1]) > 0.03);
    whirl_rotor_free(rotor);
}

/// Returns the largest force that is left at rest, in weights of the journal.
static double left_at(const whirl_rotor *rotor, const double *rest) {
    const whirl_system *system = whirl_rotor_system(rotor);
    const double off[WHIRL_MAX_FORCING] = {0.0}, weight = 9.80665 / (clearance * speed * speed);
    double slope[64], left = 0.0;
    system->rhs(system->model, 0.0, off, rest, slope);
    for (size_t i = 0; i < system->dimension; i++) left = fmax(left, fabs(slope[i]));
    return left / weight;
}

/// Places of rest in which a pad has a tilt that it keeps only together with a journal that gives way, by another
/// search: Newton's method in all coordinates from every combination of the pads' balances, stable or not, before
/// journals on a grid of 0.05 clearances. Of several places the one with the least growth.
static const struct {
    size_t bearing;
    double place[2];
} together[] = {{9, {0.34610, -0.59844}},  {17, {0.77657, -0.57070}}, {19, {0.52745, -0.62721}},
                {21, {0.33160, -0.39494}}, {23, {0.27380, -0.44155}}, {41, {0.39325, -0.77891}},
                {49, {0.79540, -0.77366}}, {51, {0.51664, -0.80434}}, {53, {0.41587, -0.57726}},
                {55, {0.26845, -0.60580}}, {61, {0.59647, -0.56775}}, {63, {0.44697, -0.59893}}};

/// Tells whether the journal of bearing i is pushed: one in four, such that every layout meets every stiffness of the
/// springs once.
static bool is_pushed(size_t i) {
    return (i % 4 + i / 8 + 2 * (i / 4)) % 4 == 0;
}

/// Pads on springs: every bearing has an equilibrium, at which no force is left. The order in which pads are listed
/// changes no bit. A journal that is pushed off a stable equilibrium comes back.
static void listed(void **unused) {
    static const double preloads[] = {0.0, 0.2}, stiffness[] = {500.0, 2000.0, 8000.0, 30000.0},
                        masses[] = {400.0, 1500.0};
    size_t rests = 0;
    (void)unused;
    for (size_t i = 0; i < 4 * 2 * 4 * 2; i++) {
        const layout *of = &layouts[i % 4];
        const double preload = preloads[i / 4 % 2], mass = masses[i / 32];
        const tilt_case tilt = {"springs", 2e-4, stiffness[i / 8 % 4], 0.0};
        double first[64] = {0.0};
        const size_t listings[] = {0, 1 + i / 4 % (of->count - 1)}; // as in `layouts`, and with another pad first
        for (size_t k = 0; k < 2; k++) {
            whirl_rotor *rotor = make_listed(of, listings[k], preload, mass, &tilt, 1.0);
            const whirl_system *system = whirl_rotor_system(rotor);
            double start[64] = {0.0};
            whirl_modes *modes = NULL;
            char name[160];
            snprintf(name, sizeof name, "%s, m %g, %g N m/rad, %g kg", of->name, preload, tilt.stiffness, mass);
            whirl_rotor_complete(rotor, start);
            const whirl_status status = whirl_modes_new(system, start, &modes);
            require_ok(status);
            if (k == 0) {
                rests++;
                memcpy(first, modes->rest, system->dimension * sizeof *first);
                check_within("Pads at rest", words("%s: force left", name), 0.0, left_at(rotor, first), 1e-6);
                for (size_t t = 0; t < sizeof together / sizeof *together; t++)
                    if (together[t].bearing == i)
                        check_within("Pads at rest", words("%s: place by another search", name), 0.0,
                                     hypot(first[0] - together[t].place[0], first[1] - together[t].place[1]), 2e-5);
                memcpy(start, first, sizeof start);
                start[0] += 1e-4;
                if (mass < 1000.0 && modes->growth < -0.1 && is_pushed(i)) {
                    carry(system, start, 20, 16000);
                    check_within("Pads at rest", words("%s, pushed off: distance left", name), 0.0,
                                 hypot(start[0] - first[0], start[1] - first[1]), 1e-7);
                }
            }
            assert_memory_equal(first, modes->rest, system->dimension * sizeof *first);
            whirl_modes_free(modes);
            whirl_rotor_free(rotor);
        }
    }
    assert_int_equal(rests, 64);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grid),    cmocka_unit_test(condensed), cmocka_unit_test(least_film), cmocka_unit_test(dropped),
        cmocka_unit_test(springs), cmocka_unit_test(kept),      cmocka_unit_test(preloaded),  cmocka_unit_test(listed),
    };
    return cmocka_run_group_tests_name("pads at rest", tests, NULL, NULL);
}
