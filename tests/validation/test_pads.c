// Bearings of fixed and of tilting pads of finite length against digits that two methods agree on:
// finite volumes to 7680 x 48, and bilinear elements, extrapolated.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/internal/bearing.h"

static const double pi = 3.14159265358979323846;
enum { FINE = 1920 };

/// Checks that coefficients agree to 2e-4 of the largest of their matrix.
static void check_matrix(const char *id, const char *what, const double expected[4], double obtained[2][2]) {
    static const char *const names[] = {"xx", "xy", "yx", "yy"};
    double largest = 0.0;
    char before[96];
    snprintf(before, sizeof before, "%s", what); // buffers of words are few
    for (int i = 0; i < 4; i++) largest = fmax(largest, fabs(expected[i]));
    for (int i = 0; i < 4; i++)
        check_within(id, words("%s%s", before, names[i]), expected[i], obtained[i / 2][i % 2], 2e-4 * largest);
}

/// Turns coefficients to the frame of Lund and Thomsen (x along the load, which is along -y), over the load.
static void turned(double of[2][2], double load, double out[2][2]) {
    out[0][0] = of[1][1] / load;
    out[0][1] = -of[1][0] / load;
    out[1][0] = -of[0][1] / load;
    out[1][1] = of[0][0] / load;
}

static whirl_pads_state rest(const whirl_pads *bearing, double load) {
    whirl_pads_state state;
    require_ok(whirl_pads_rest(bearing, (const double[]){0.0, -load}, &state));
    return state;
}

/// One pad of 360 degrees, its groove opposite to the journal: the load is what its force is there.
static void plain(void **unused) {
    static const struct {
        double ratio, eps, force[2], stiffness[4], damping[4];
    } rows[] = {
        {0.5,
         0.2,
         {-0.04020339, 0.15141827},
         {.409799, .67380, -.836177, .173146},
         {1.53005, -.402034, -.402034, 1.514183}},
        {0.5,
         0.6,
         {-0.66648939, 0.74139565},
         {4.22846, 1.1948, -2.865433, 1.095846},
         {6.1923, -2.221631, -2.221631, 2.471319}},
        {1.0,
         0.4,
         {-0.56314615, 1.08496584},
         {3.24242, 2.3782, -3.576686, 1.127977},
         {7.2978, -2.815731, -2.815731, 5.424829}},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const whirl_pads bearing = {
            .count = 1, .pads = {{0.0, 2.0 * pi, 0.5, 0.0}}, .ratio = rows[i].ratio, .fineness = FINE};
        const double load[] = {-rows[i].force[0], -rows[i].force[1]};
        whirl_pads_state state;
        require_ok(whirl_pads_rest(&bearing, load, &state));
        char what[64];
        snprintf(what, sizeof what, "plain, L/D %g, eccentricity %g: ", rows[i].ratio, rows[i].eps);
        check_within("pads-plain", words("%splace along x", what), rows[i].eps, state.at[0], 2e-6);
        check_within("pads-plain", words("%splace along y", what), 0.0, state.at[1], 2e-6);
        check_matrix("pads-plain", words("%sK", what), rows[i].stiffness, state.stiffness);
        check_matrix("pads-plain", words("%sC", what), rows[i].damping, state.damping);
    }
}

static void fixed_pads(void **unused) {
    static const struct {
        const char *name;
        double ratio, load, x, y, stiffness[4], damping[4];
    } rows[] = {
        {"two-groove",
         .5,
         .917,
         .31354114,
         -.19954761,
         {2.1029, 4.0229, -1.3333, 1.8690},
         {7.7176, 2.1038, 2.1038, 3.3056}},
        {"two-groove",
         .5,
         .379,
         .40645939,
         -.39910856,
         {3.3125, 3.6596, -.4441, 1.7042},
         {6.7893, 1.9032, 1.9032, 1.9383}},
        {"two-groove",
         1.,
         .235,
         .34858394,
         -.29892180,
         {2.1677, 3.5821, -.8205, 1.5671},
         {7.3868, 1.9233, 1.9233, 2.2429}},
        {"elliptical",
         1.,
         .161,
         .30335146,
         -.02506156,
         {5.6229, 3.8438, -2.3191, 1.0103},
         {10.7522, -1.0159, -1.0159, 3.0761}},
        {"elliptical",
         .5,
         .4,
         .28524461,
         -.03526400,
         {7.1951, 4.0038, -3.1440, 1.1600},
         {11.5128, -1.7321, -1.7321, 3.7053}},
        {"three-lobe",
         .5,
         .3,
         .14866780,
         -.22870634,
         {4.9880, 7.3867, -1.2063, 6.5894},
         {9.8138, 3.5738, 3.5738, 8.6681}},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        whirl_pads bearing = {.ratio = rows[i].ratio, .fineness = FINE};
        double turn[2][2];
        assert_true(whirl_pads_named(rows[i].name, 0.5, &bearing));
        const double load = 1.0 / (pi * rows[i].load);
        whirl_pads_state state = rest(&bearing, load);
        char what[64];
        snprintf(what, sizeof what, "%s, L/D %g, S %g: ", rows[i].name, rows[i].ratio, rows[i].load);
        check_within("pads-fixed", words("%splace along x", what), rows[i].x, state.at[0], 2e-6);
        check_within("pads-fixed", words("%splace along y", what), rows[i].y, state.at[1], 2e-6);
        turned(state.stiffness, load, turn);
        check_matrix("pads-fixed", words("%sK c/W, ", what), rows[i].stiffness, turn);
        turned(state.damping, load, turn);
        check_matrix("pads-fixed", words("%sC c Omega/W, ", what), rows[i].damping, turn);
    }
}

/// Checks reduced coefficients of pads without inertia at a whirl ratio, over the load; off the diagonal they are 0 by
/// symmetry.
static void check_reduced(const whirl_pads *bearing, const whirl_pads_state *state, const char *what, double ratio,
                          double load, const double expected[4]) {
    double stiffness[2][2], damping[2][2];
    whirl_pads_reduced(bearing, state, ratio, 0.0, stiffness, damping);
    const double obtained[] = {stiffness[0][0], stiffness[1][1], damping[0][0], damping[1][1]};
    static const char *const names[] = {"K*xx", "K*yy", "C*xx", "C*yy"};
    for (int i = 0; i < 4; i++)
        check_within("pads-tilting", words("%s at whirl ratio %g: %s/W", what, ratio, names[i]), expected[i],
                     obtained[i] / load, 2e-4 * fmax(expected[i], 4.0));
    check_within("pads-tilting", words("%s at whirl ratio %g: K*xy/W", what, ratio), 0.0, stiffness[0][1] / load, 1e-4);
    check_within("pads-tilting", words("%s at whirl ratio %g: C*yx/W", what, ratio), 0.0, damping[1][0] / load, 1e-4);
}

static void between_pads(void **unused) {
    static const double loads[] = {.491796, .329563, .491796, 1.009564, 1.009564};
    static const double tilts[] = {-.373401, -.254982, -.158595, -.207420, -.340177};
    whirl_pads bearing = {.ratio = 0.5, .fineness = FINE};
    const double load = 1.0 / (pi * 0.5);
    (void)unused;
    assert_true(whirl_pads_named("tilting-5", 0.5, &bearing));
    whirl_pads_state state = rest(&bearing, load);
    check_within("pads-tilting", "5 pads, load between pads: Y", -.1129304, state.at[1], 2e-6);
    for (int i = 0; i < 5; i++) {
        check_within("pads-tilting", words("load between pads: load of pad %d over W", i + 1), loads[i],
                     state.load[i] / load, 1e-5);
        check_within("pads-tilting", words("load between pads: tilt of pad %d", i + 1), tilts[i], state.tilt[i], 5e-6);
    }
    check_reduced(&bearing, &state, "load between pads", 1.0, load,
                  (const double[]){6.47468, 7.60997, 7.40401, 8.13164});
    check_reduced(&bearing, &state, "load between pads", 0.5, load,
                  (const double[]){8.24631, 9.51679, 6.36039, 7.02622});
    const double held[] = {9.51625, 6.66055, -7.42027, 10.7864};
    double over[2][2];
    for (int i = 0; i < 4; i++) over[i / 2][i % 2] = state.stiffness[i / 2][i % 2] / load;
    check_matrix("pads-tilting", "load between pads, tilts held: K/W ", held, over);
}

static void on_pad(void **unused) {
    whirl_pads bearing = {.ratio = 0.5, .count = 5, .tilting = true, .fineness = FINE};
    const double load = 1.0 / (pi * 0.15);
    (void)unused;
    for (int i = 0; i < 5; i++) bearing.pads[i] = (whirl_pad){(54.0 + 72.0 * i) * pi / 180.0, pi / 3.0, 0.5, 0.3};
    whirl_pads_state state = rest(&bearing, load);
    check_within("pads-tilting", "5 pads, load on a pad: Y", -.4434533, state.at[1], 2e-6);
    static const double loads[] = {0.0, 0.0, .127425, .921247, .127425},
                        tilts[] = {0.0, 0.0, .159126, -.268819, -.684372};
    for (int i = 0; i < 5; i++) {
        check_within("pads-tilting", words("load on a pad: load of pad %d over W", i + 1), loads[i],
                     state.load[i] / load, 1e-5);
        check_within("pads-tilting", words("load on a pad: tilt of pad %d", i + 1), tilts[i], state.tilt[i], 1e-5);
    }
    check_holds("pads-tilting", "the upper two pads have no film that holds them",
                !state.loaded[0] && !state.loaded[1]);
    check_reduced(&bearing, &state, "load on a pad", 1.0, load, (const double[]){.769232, 6.9812, 1.1089, 4.41807});
    check_reduced(&bearing, &state, "load on a pad", 0.5, load, (const double[]){1.05458, 7.87454, .92321, 3.98724});
}

/// A long time from one place to the other: pads of short bearings carry what Ocvirk's closed form says.
static void short_limit(void **unused) {
    (void)unused;
    // Gumbel, closed form for L/D -> 0: f = (L/D)^2 eps/(4 (1 - eps^2)^2) (-4 eps, pi sqrt(1 - eps^2)).
    const double eps = 0.5, ratio = 0.02, q = 1.0 - eps * eps, scale = ratio * ratio * eps / (q * q);
    const double force[] = {-4.0 * eps * scale, pi * sqrt(q) * scale};
    const whirl_pads bearing = {
        .count = 1, .pads = {{pi, 2.0 * pi, 0.5, 0.0}}, .ratio = ratio, .gumbel = true, .fineness = FINE};
    whirl_pads_state state;
    require_ok(whirl_pads_rest(&bearing, (const double[]){-force[0], -force[1]}, &state));
    check_within("pads-short", "short film, L/D 0.02: eccentricity ratio", eps, hypot(state.at[0], state.at[1]), 1e-3);
    check_within("pads-short", "short film, L/D 0.02: attitude, rad", 0.0, state.at[1], 1e-3);
}

/// Every usual bearing carries loads from heavy to light; in tilting pads the journal stays on the line of the load.
static void carried(void **unused) {
    static const char *const names[] = {"plain",     "two-groove",  "elliptical", "three-lobe",
                                        "four-lobe", "offset-half", "tilting-4",  "tilting-5"};
    static const double numbers[] = {0.01, 0.1, 10.0};
    (void)unused;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            const double load = 1.0 / (pi * numbers[k]);
            whirl_pads bearing = {.ratio = 0.5, .fineness = 480};
            assert_true(whirl_pads_named(names[i], 0.5, &bearing));
            const whirl_pads_state state = rest(&bearing, load);
            check_within("pads-fixed", words("%s, S %g: the film's force over the load", names[i], numbers[k]), 1.0,
                         state.force[1] / load, 1e-6);
            if (bearing.tilting)
                check_within("pads-tilting", words("%s, S %g: place across the load", names[i], numbers[k]), 0.0,
                             state.at[0], 1e-7);
        }
}

/// Returns 1 + .0136/12 Re^.9 around, 1 + .0043/12 Re^.96 along (Ng, Pan 1965).
static double resistance(double reynolds, bool along) {
    return 1.0 + (along ? 0.0043 * pow(reynolds, 0.96) : 0.0136 * pow(reynolds, 0.9)) / 12.0;
}

/// A turbulent pad about the line of x, its journal at a place: of a very long one the highest pressure, of a very
/// short one the force, each by one quadrature (midpoints) of what Reynolds' equation is then.
static void turbulent(void **unused) {
    enum { POINTS = 200000 };
    static const double x = 0.45, y = -0.25, reynolds = 4000.0, arc = 2.6, ratio = 0.002;
    double flow = 0.0, drawn = 0.0, pressure = 0.0, highest = 0.0, force[2] = {0.0};
    whirl_pads bearing = {.count = 1,
                          .pads = {{0.0, arc, 0.5, 0.0}},
                          .ratio = 1e4,
                          .gumbel = true,
                          .fineness = FINE,
                          .turbulence = WHIRL_NG_PAN,
                          .reynolds = reynolds};
    whirl_pads_state state;
    (void)unused;
    for (int pass = 0; pass < 2; pass++) // H^3 P'/r = C - A cos p - B sin p, C so that the pressure ends at 0
        for (int i = 0; i < POINTS; i++) {
            const double p = arc * ((i + 0.5) / POINTS - 0.5), h = 1.0 - x * cos(p) - y * sin(p);
            const double over = resistance(reynolds * h, false) / (h * h * h), wedge = x * cos(p) + y * sin(p);
            if (pass == 0) {
                flow += over;
                drawn += over * wedge;
                // P = r (B cos p - A sin p)(1 - zeta^2) (L/D)^2/(2 H^3) where it is above 0.
                const double source = fmax(y * cos(p) - x * sin(p), 0.0) * resistance(reynolds * h, true) / (h * h * h);
                force[0] -= 2.0 * source * ratio * ratio * cos(p) * arc / POINTS;
                force[1] -= 2.0 * source * ratio * ratio * sin(p) * arc / POINTS;
                continue;
            }
            pressure += over * (drawn / flow - wedge) * arc / POINTS;
            highest = fmax(highest, pressure);
        }
    require_ok(whirl_pads_at(&bearing, (const double[]){x, y}, &state));
    check_within("pads-turbulent", "very long pad, Re 4000: highest pressure", highest, state.highest, 3e-5 * highest);
    bearing.ratio = ratio;
    require_ok(whirl_pads_at(&bearing, (const double[]){x, y}, &state));
    const double size = hypot(force[0], force[1]);
    for (int i = 0; i < 2; i++)
        check_within("pads-turbulent", words("very short pad, Re 4000: force %d over its size", i + 1), force[i] / size,
                     state.force[i] / size, 3e-3);
    bearing.ratio = 0.5;
    bearing.reynolds = 0.0;
    require_ok(whirl_pads_at(&bearing, (const double[]){x, y}, &state));
    bearing.turbulence = WHIRL_LAMINAR;
    whirl_pads_state laminar;
    require_ok(whirl_pads_at(&bearing, (const double[]){x, y}, &laminar));
    check_within("pads-turbulent", "Re 0, expected by a laminar film: force", laminar.force[0], state.force[0], 1e-12);
    // Concentric, the shear is that of Couette's flow alone.
    bearing.turbulence = WHIRL_NG_PAN;
    bearing.reynolds = 10000.0;
    require_ok(whirl_pads_at(&bearing, (const double[]){0.0, 0.0}, &state));
    check_within("pads-turbulent", "concentric, Re 10000: torque over the laminar one",
                 1.0 + 0.0012 * pow(10000.0, 0.94), state.drag / arc, 1e-9);
}

/// Oil under pressure in the groove of a pad before a journal in the middle: Laplace's equation, P = sum a cos(l zeta)
/// cosh(l D/L p)/cosh(l D/L arc/2), with l = (n - 1/2) pi and a = 2 P cos(l groove)/((1 - groove) l^2).
static void supplied(void **unused) {
    whirl_pads bearing = {
        .count = 1, .pads = {{0.0, 5.8, 0.5, 0.0}}, .ratio = 0.6, .fineness = FINE, .supply = 1.5, .groove = 0.75};
    const double half = 2.9, gap = pi - half;
    double force = 0.0, leaving = 0.0;
    whirl_pads_state state;
    (void)unused;
    for (int n = 1; n < 400; n++) {
        const double l = (n - 0.5) * pi, m = l / bearing.ratio, sign = n % 2 ? 1.0 : -1.0;
        const double a = bearing.supply * 2.0 * cos(l * bearing.groove) / ((1.0 - bearing.groove) * l * l);
        force -= 12.0 * a * sign / l * (m * tanh(m * half) * cos(half) + sin(half)) / (m * m + 1.0);
        leaving += a * l * sign * tanh(m * half) / m / (bearing.ratio * bearing.ratio);
    }
    require_ok(whirl_pads_at(&bearing, (const double[]){0.0, 0.0}, &state));
    const double groove = 12.0 * bearing.supply * 0.5 * (1.0 + bearing.groove) * sin(gap);
    check_within("pads-supply", "groove of 27 degrees: its force on the journal", groove, state.grooves[0], 1e-12);
    check_within("pads-supply", "film of a concentric journal: force", force, state.force[0] - state.grooves[0],
                 1e-4 * fabs(force));
    check_within("pads-supply", "film of a concentric journal: oil that leaves", leaving, state.leaving,
                 5e-3 * leaving);
    // Pressure lifts: of two grooves at the sides, the more the lower the journal lies.
    assert_true(whirl_pads_named("two-groove", 0.0, &bearing));
    for (size_t i = 0; i < 2; i++)
        check_within("pads-supply", words("gap behind pad %zu of 160 degrees", i + 1), pi / 9.0,
                     whirl_pads_gap(&bearing, i), 1e-12);
    bearing.tilting = true;
    assert_int_equal(whirl_pads_at(&bearing, (const double[]){0.0, 0.0}, &state).code, WHIRL_BAD_INPUT);
}

/// Returns the stiffness of a pad without inertia, its tilt eliminated: Z* t = 0 and t Z* = 0 leave one along the
/// radius, det Z/(t Z t). A spring at its pivot is in series.
static double complex alone(const whirl_pad *pad, double of[2][2][2], double ratio) {
    const double t[] = {-sin(pad->pivot), cos(pad->pivot)};
    double complex z[2][2], along = 0.0;
    for (int r = 0; r < 2; r++)
        for (int c = 0; c < 2; c++) {
            z[r][c] = of[0][r][c] + I * ratio * of[1][r][c];
            along += t[r] * z[r][c] * t[c];
        }
    return (z[0][0] * z[1][1] - z[0][1] * z[1][0]) / along;
}

static void check_in_series(const whirl_pads *bearing, whirl_pads_state *state, double ratio, const char *what) {
    static const char *const axes[] = {"xx", "xy", "yx", "yy"};
    const double complex spring =
        bearing->pivot_stiffness + I * ratio * bearing->pivot_damping - ratio * ratio * bearing->pad_mass;
    double complex sum[2][2] = {{0.0}};
    double stiffness[2][2], damping[2][2];
    for (size_t i = 0; i < bearing->count; i++) {
        const double n[] = {cos(bearing->pads[i].pivot), sin(bearing->pads[i].pivot)};
        const double complex film = alone(&bearing->pads[i], state->of_pads[i], ratio);
        for (int k = 0; k < 4; k++) sum[k / 2][k % 2] += film * spring / (film + spring) * n[k / 2] * n[k % 2];
    }
    whirl_pads_reduced(bearing, state, ratio, 0.0, stiffness, damping);
    for (int k = 0; k < 4; k++) {
        check_within("pads-pivots", words("%s: K* %s", what, axes[k]), creal(sum[k / 2][k % 2]),
                     stiffness[k / 2][k % 2], 1e-9);
        check_within("pads-pivots", words("%s: C* %s", what, axes[k]), cimag(sum[k / 2][k % 2]) / ratio,
                     damping[k / 2][k % 2], 1e-9);
    }
}

static void pivots(void **unused) {
    whirl_pads bearing = {.ratio = 0.5, .fineness = 480}, moved;
    const double load = 1.0 / (pi * 0.5);
    double rigid[2][2], soft[2][2], damping[2][2];
    (void)unused;
    assert_true(whirl_pads_named("tilting-5", 0.5, &bearing));
    whirl_pads_state stiff = rest(&bearing, load);
    whirl_pads_reduced(&bearing, &stiff, 1.0, 0.0, rigid, damping);
    bearing.pivot_stiffness = 1e8;
    whirl_pads_state state = rest(&bearing, load);
    whirl_pads_reduced(&bearing, &state, 1.0, 0.0, soft, damping);
    check_within("pads-pivots", "very stiff pivots: place, expected by rigid ones", stiff.at[1], state.at[1], 1e-6);
    for (int k = 0; k < 2; k++)
        check_within("pads-pivots", words("very stiff pivots: K* %s over that of rigid ones", k ? "yy" : "xx"), 1.0,
                     soft[k][k] / rigid[k][k], 1e-6);
    bearing.pivot_stiffness = 4.0; // about as stiff as the films
    bearing.pivot_damping = 0.3;
    bearing.pad_mass = 0.2;
    state = rest(&bearing, load);
    moved = bearing;
    moved.pivot_stiffness = 0.0;
    for (size_t i = 0; i < bearing.count; i++) {
        check_within("pads-pivots", words("pad %zu: spring's force, that of the film", i + 1), state.thrust[i],
                     bearing.pivot_stiffness * state.yield[i], 1e-8);
        moved.pads[i].preload -= state.yield[i];
    }
    whirl_pads_state same = rest(&moved, load);
    check_within("pads-pivots", "place, expected by rigid pivots further out", same.at[1], state.at[1], 1e-8);
    check_in_series(&bearing, &state, 1.0, "whirl ratio 1");
    check_in_series(&bearing, &state, 0.5, "whirl ratio .5");
    // The softest springs are all that is left: k sum n n' = 5/2 k.
    bearing.pivot_stiffness = 1e-6;
    bearing.pivot_damping = bearing.pad_mass = 0.0;
    whirl_pads_reduced(&bearing, &state, 1.0, 0.0, soft, damping);
    for (int k = 0; k < 2; k++)
        check_within("pads-pivots", words("very soft pivots: K* %s over 5/2 k", k ? "yy" : "xx"), 1.0,
                     soft[k][k] / 2.5e-6, 1e-5);
}

static void refused(void **unused) {
    whirl_pads_state state;
    whirl_pads bearing = {.ratio = 0.5};
    const double load[] = {0.0, -1.0};
    (void)unused;
    assert_int_equal(whirl_pads_rest(&bearing, load, &state).code, WHIRL_BAD_INPUT);
    assert_false(whirl_pads_named("round", 0.0, &bearing));
    assert_true(whirl_pads_named("elliptical", 0.5, &bearing));
    assert_int_equal(whirl_pads_rest(&bearing, (const double[]){0.0, 0.0}, &state).code, WHIRL_BAD_INPUT);
    bearing.ratio = -1.0;
    assert_int_equal(whirl_pads_rest(&bearing, load, &state).code, WHIRL_BAD_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain),     cmocka_unit_test(fixed_pads),  cmocka_unit_test(between_pads),
        cmocka_unit_test(on_pad),    cmocka_unit_test(short_limit), cmocka_unit_test(carried),
        cmocka_unit_test(turbulent), cmocka_unit_test(supplied),    cmocka_unit_test(pivots),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests_name("pads", tests, NULL, NULL);
}
