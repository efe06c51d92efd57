// Elements' kernels in lanes compared with plain C functions of the same laws (element_laws.h): a machine of one
// element, four times, at states of all kinds. Both must give the same accelerations, and slopes of states, before they
// are timed.
//
//   bench_elements SECONDS [ELEMENT]
//
// Prints lines: ISA or C, and element; evaluations of an element a second; largest difference.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "design/black.h"
#include "element_laws.h"
#include "elements/films/film_ratio.h"
#include "isa.h"
#include "lanes.h"
#include "machines.h"
#include "peer.h"

#define TURN 6.28318530717958647693
#define SET(...) (whirl_setting[]){__VA_ARGS__}, sizeof(whirl_setting[]){__VA_ARGS__} / sizeof(whirl_setting)

enum {
    TWICE = 4,
    VECTORS = 8,
    STATES = 1024,
    MAX_BLOCKS = STATES / VECTORS,
    PLACES = 2,
    COORDINATES = 4,
    MAX_STATES = TWICE * LAW_STATES
};

/// Stations begin with a mass of 1; all laws are in the machine's units, in which the speed is 1.
typedef struct bench_element {
    const char *name, *type;
    const whirl_setting *settings;
    size_t setting_count;
    element_law *law;
    const void *numbers;
    double least, most, speed; ///< least and largest distance from the middle; largest velocity
    double states[2], fluid;   ///< least and largest state; mass of fluid added to the mass of the station
    size_t axes, state_count;
} bench_element;

// ---------------------------------------------------------------- the elements

static double random_in(double least, double most) {
    static unsigned long long state = 88172645463325252ULL;
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return least + (most - least) * (double)(state >> 11) * 0x1p-53;
}

static ring_law ring_numbers(void) {
    const double inner = TURN * 0.01 * 50.0 * 50.0 * 50.0 * 50.0 / 4e5, outer = TURN * 0.01 * 6e6 * 1.8 / (1.5 * 4e5);
    const double i = 0.01 * 50.0 * 50.0 * 50.0 * 50.0 / 4.0, o = 0.01 * 60.0 * 50.0 * 50.0 * 50.0 / (4.0 * 1.5 * 1.5);
    return (ring_law){{1.0, i, inner}, {1.5, o, outer}, inner / (inner + outer)};
}

static finite_law finite_numbers(void) {
    finite_law law = {.film = {1.0, 0.01 * 50.0 * 80.0 * 80.0 * 80.0 / 4.0, 0.0}};
    film_coefficients(0.8, law.coefficients);
    return law;
}

static rolling_law rolling_numbers(int count, int line, int oblique, int dented) {
    const double inner = 4.0, outer = 6.0, angle = 0.5, centres = 2.0, gap = 0.05, share = inner / (inner + outer);
    rolling_law law = {count,
                       line,
                       oblique,
                       dented,
                       3.0,
                       gap,
                       share,
                       centres,
                       centres * cos(angle) - gap,
                       centres * sin(angle),
                       {{0.1, 0.5, 0.2}, {0.1, 0.6, -1.0}, {0.1, 0.7, 0.0}},
                       {share, 1.0, 0.0, (1.0 - share) * share / (0.5 - share)},
                       {{0.0}}};
    for (int j = 0; j < count; j++) law.apart[j][0] = cos(TURN * j / count), law.apart[j][1] = sin(TURN * j / count);
    return law;
}

static seal_law black_numbers(void) {
    const black_seal seal = {1.0, 0.5, 0.01, 1000.0, 1e-3, 50.0, 0.5, 0.5};
    const black_coefficients of = black_find(&seal, 1.0);
    return (seal_law){seal.clearance, of.stiffness, of.damping, of.mass, of.ratio, 0.0, 0.0};
}

static blade_law blade_numbers(double power) {
    blade_law law = {LAW_BLADES, 1.1, 1.0, 3.0, power, 0.1, {{0.0}}};
    for (int j = 0; j < LAW_BLADES; j++) {
        law.apart[j][0] = cos(TURN * j / LAW_BLADES);
        law.apart[j][1] = sin(TURN * j / LAW_BLADES);
    }
    return law;
}

#define BALLS                                                                                                          \
    {"at", 0, "disc"}, {"stiffness", 3, 0}, {"clearance", 0.05, 0}, {"inner", 4, 0}, {                                 \
        "outer", 6, 0                                                                                                  \
    }
#define DENTED                                                                                                         \
    {"inner_dent", 0.1, 0}, {"inner_dent_width", 0.5, 0}, {"inner_dent_angle", 0.2, 0}, {"outer_dent", 0.1, 0},        \
        {"outer_dent_width", 0.6, 0}, {                                                                                \
        "outer_dent_angle", -1, 0                                                                                      \
    }
#define CONTACT                                                                                                        \
    {"at", 0, "disc"}, {"gap", 1, 0}, {                                                                                \
        "stiffness", 7, 0                                                                                              \
    }
#define RUBBING                                                                                                        \
    {"radius", 3, 0}, {                                                                                                \
        "friction", 0.2, 0                                                                                             \
    }
#define BLADES                                                                                                         \
    {"at", 0, "disc"}, {"blades", LAW_BLADES, 0}, {"radius", 1, 0}, {"gap", 0.1, 0}, {"stiffness", 3, 0}, {            \
        "friction", 0.1, 0                                                                                             \
    }

static void measure_all(double seconds, void (*measure)(const bench_element *, double)) {
    const ring_law ring = ring_numbers();
    const finite_law finite = finite_numbers();
    const rolling_law balls = rolling_numbers(8, 0, 0, 0), oblique = rolling_numbers(8, 0, 1, 0);
    const rolling_law rollers = rolling_numbers(12, 1, 0, 0), dents = rolling_numbers(8, 0, 0, 1);
    const seal_law black = black_numbers(), muszynska = {0.01, 3.0, 2.0, 0.25, 0.45, 2.0, 0.5};
    const contact_law hertz = {.gap = 1.0, .stiffness = 7.0, .power = 1.5};
    contact_law hunt = hertz, lankarani = hertz, lugre = hertz;
    hunt.loss = 0.3, hunt.surface = 3.0, hunt.kinetic = 0.2, hunt.slip_speed = 0.5, hunt.slips = 1;
    lankarani = hunt, lankarani.loss = 0.75 * (1.0 - 0.64) / 2.0, lankarani.friction = RUB_STRIBECK;
    lankarani.excess = 0.1, lankarani.stribeck_speed = 0.7;
    lugre = lankarani, lugre.loss = 0.0, lugre.friction = RUB_LUGRE, lugre.bristle = 10.0, lugre.bristle_damping = 0.3;
    const blade_law blades = blade_numbers(1.0), hertz_blades = blade_numbers(1.5);
    const magnet_law magnet = {0.02,       1.0, 2.0, 3.0, cos(0.125 * TURN), sin(0.125 * TURN), TURN * 3.0,
                               TURN * 2.0, 40,  5.0, 8.0, 1.0 / 0.05};
    const bench_element all[] = {
        {"floating_ring",
         "floating_ring",
         SET({"at", 0, "disc"}, {"ring", 0, "ring"}, {"inertia", 4e5, 0}, {"clearance", 1, 0}, {"radius", 50, 0},
             {"length", 50, 0}, {"viscosity", 0.01, 0}, {"outer_clearance", 1.5, 0}, {"outer_radius", 60, 0},
             {"outer_length", 50, 0}),
         ring_force,
         &ring,
         0,
         0.9,
         1.0,
         {-0.3, 0.3},
         0,
         4,
         1},
        {"film, finite",
         "film",
         SET({"at", 0, "disc"}, {"law", 0, "finite"}, {"clearance", 1, 0}, {"radius", 50, 0}, {"length", 80, 0},
             {"viscosity", 0.01, 0}),
         finite_force,
         &finite,
         0,
         0.95,
         1.0,
         {0, 0},
         0,
         2,
         0},
        {"ball_bearing, 8 balls",
         "ball_bearing",
         SET(BALLS, {"balls", 8, 0}),
         rolling_force,
         &balls,
         0,
         1,
         1,
         {0, TURN},
         0,
         2,
         1},
        {"ball_bearing, oblique",
         "ball_bearing",
         SET(BALLS, {"balls", 8, 0}, {"contact_angle", 0.5, 0}, {"centres", 2, 0}),
         rolling_force,
         &oblique,
         0,
         1,
         1,
         {0, TURN},
         0,
         2,
         1},
        {"ball_bearing, dents in races and a ball",
         "ball_bearing",
         SET(BALLS, {"balls", 8, 0}, DENTED, {"ball_dent", 0.1, 0}, {"ball_dent_width", 0.7, 0}),
         rolling_force,
         &dents,
         0,
         1,
         1,
         {0, TURN},
         0,
         2,
         4},
        {"roller_bearing, 12 rollers",
         "roller_bearing",
         SET(BALLS, {"rollers", 12, 0}),
         rolling_force,
         &rollers,
         0,
         1,
         1,
         {0, TURN},
         0,
         2,
         1},
        {"seal, black",
         "seal",
         SET({"at", 0, "disc"}, {"law", 0, "black"}, {"clearance", 0.01, 0}, {"radius", 1, 0}, {"length", 0.5, 0},
             {"density", 1000, 0}, {"viscosity", 1e-3, 0}, {"pressure", 50, 0}),
         seal_force,
         &black,
         0,
         0.008,
         0.01,
         {0, 0},
         black.mass,
         2,
         0},
        {"seal, muszynska",
         "seal",
         SET({"at", 0, "disc"}, {"clearance", 0.01, 0}, {"stiffness", 3, 0}, {"damping", 2, 0}, {"mass", 0.25, 0},
             {"ratio", 0.45, 0}, {"growth", 2, 0}, {"slowing", 0.5, 0}),
         seal_force,
         &muszynska,
         0,
         0.009,
         0.01,
         {0, 0},
         0.25,
         2,
         0},
        {"contact, Hertz", "contact", SET(CONTACT), contact_force, &hertz, 1, 1.5, 1, {0, 0}, 0, 2, 0},
        {"contact, Hunt-Crossley, smooth friction",
         "contact",
         SET(CONTACT, RUBBING, {"law", 0, "hunt_crossley"}, {"loss", 0.3, 0}, {"slip_speed", 0.5, 0}),
         contact_force,
         &hunt,
         1,
         1.5,
         1,
         {0, 0},
         0,
         2,
         0},
        {"contact, Lankarani-Nikravesh, Stribeck",
         "contact",
         SET(CONTACT, RUBBING, {"law", 0, "lankarani_nikravesh"}, {"restitution", 0.8, 0}, {"impact_speed", 2, 0},
             {"friction_law", 0, "stribeck"}, {"static_friction", 0.3, 0}, {"stribeck_speed", 0.7, 0},
             {"slip_speed", 0.5, 0}),
         contact_force,
         &lankarani,
         1,
         1.5,
         2,
         {0, 0},
         0,
         2,
         0},
        {"contact, Hertz, LuGre",
         "contact",
         SET(CONTACT, RUBBING, {"friction_law", 0, "lugre"}, {"static_friction", 0.3, 0}, {"stribeck_speed", 0.7, 0},
             {"bristle_stiffness", 10, 0}, {"bristle_damping", 0.3, 0}),
         contact_force,
         &lugre,
         1,
         1.5,
         2,
         {-0.02, 0.02},
         0,
         2,
         1},
        {"blade_rub, 12 blades", "blade_rub", SET(BLADES), blade_force, &blades, 0, 0.3, 1, {0, TURN}, 0, 2, 1},
        {"blade_rub, 12 blades, power 3/2",
         "blade_rub",
         SET(BLADES, {"power", 1.5, 0}),
         blade_force,
         &hertz_blades,
         0,
         0.3,
         1,
         {0, TURN},
         0,
         2,
         1},
        {"magnetic, PID",
         "magnetic",
         SET({"at", 0, "disc"}, {"gap", 1, 0}, {"bias", 2, 0}, {"constant", 0.02, 0}, {"pole_angle", 0, 0},
             {"max_current", 3, 0}, {"proportional", 40, 0}, {"integral", 5, 0}, {"derivative", 8, 0},
             {"derivative_filter", 0.05, 0}, {"sensor_bandwidth", 3, 0}, {"amplifier_bandwidth", 2, 0}),
         magnet_force,
         &magnet,
         0,
         0.6,
         1,
         {-2, 2},
         0,
         2,
         8},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) measure(&all[i], seconds);
}

// ---------------------------------------------------------------- machines and their states

static whirl_rotor *machine_of(const bench_element *of) {
    whirl_design *design;
    whirl_rotor *rotor;
    must(whirl_design_new(1.0, 1.0, &design));
    must(whirl_design_station(design, "disc", &(whirl_setting){"mass", 1, 0}, 1));
    if (of->axes == COORDINATES) must(whirl_design_station(design, "ring", &(whirl_setting){"mass", 1, 0}, 1));
    for (int i = 0; i < TWICE; i++) must(whirl_design_element(design, of->type, of->settings, of->setting_count));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// One state as the law takes it: displacements and velocities of a place relative to the next, and the element's
/// states.
typedef struct state {
    double d[COORDINATES], w[COORDINATES], s[LAW_STATES];
} state;

static state random_state(const bench_element *of) {
    state out;
    for (size_t a = 0; a < COORDINATES; a += 2) {
        const double r = random_in(of->least, of->most), angle = random_in(0.0, TURN);
        out.d[a] = r * cos(angle);
        out.d[a + 1] = r * sin(angle);
        out.w[a] = random_in(-of->speed, of->speed);
        out.w[a + 1] = random_in(-of->speed, of->speed);
    }
    for (size_t i = 0; i < LAW_STATES; i++) out.s[i] = random_in(of->states[0], of->states[1]);
    return out;
}

/// Data of one benchmark: blocks of lanes, each with arrays of vectors as kernels take them, and the same states one by
/// one.
typedef struct bench {
    const bench_element *of;
    const whirl_lanes *lanes;
    lanes_view view[MAX_BLOCKS];
    const isa *on;
    size_t blocks, width, count; ///< blocks; lanes of a block; states of all blocks
    size_t degrees, rows;        ///< rows of velocities; rows of velocities and states
    double *a, *rates;           ///< slopes of the last block; of the last single state
    state *states;               ///< [count]
} bench;

static double *aligned(size_t count) {
    enum { LINE = 64 };
    void *block = aligned_alloc(LINE, (count * sizeof(double) + LINE - 1) / LINE * LINE);
    if (!block) must((whirl_status){.code = WHIRL_NO_MEMORY, .message = "no memory"});
    memset(block, 0, count * sizeof(double));
    return block;
}

/// Returns an absolute displacement: rows 0 and 1, of the journal, are relative to rows 2 and 3, of its ring.
static double placed(const double *d, size_t row) {
    return row < 2 ? d[row] + d[row + 2] : d[row];
}

static void fill_lane(const bench *b, double *q, double *v, const state *at, size_t lane) {
    const size_t own = b->of->state_count;
    for (size_t row = 0; row < b->degrees; row++) {
        q[row * b->width + lane] = b->of->axes == COORDINATES ? placed(at->d, row) : at->d[row];
        v[row * b->width + lane] = b->of->axes == COORDINATES ? placed(at->w, row) : at->w[row];
    }
    for (size_t i = 0; i < TWICE * own; i++) v[(b->degrees + i) * b->width + lane] = at->s[i % own];
}

static bench bench_new(const bench_element *of, const whirl_rotor *rotor) {
    bench b = {.of = of, .lanes = whirl_rotor_system(rotor)->lanes};
    must(isa_choose(&b.on));
    b.width = VECTORS * b.on->lanes;
    b.count = STATES; // for every instruction set, since C computes the same states
    b.blocks = STATES / b.width;
    b.degrees = b.lanes->degrees;
    b.rows = b.degrees + b.lanes->states;
    b.states = calloc(b.count, sizeof *b.states);
    if (!b.states) must((whirl_status){.code = WHIRL_NO_MEMORY, .message = "no memory"});
    b.a = aligned(b.rows * b.width);
    double *numbers = aligned(b.lanes->number_count * b.width), *forcing = aligned(COORDINATES * b.width);
    double *own = aligned(b.lanes->number_count);
    b.lanes->numbers(rotor, own);
    for (size_t i = 0; i < b.lanes->number_count * b.width; i++) numbers[i] = own[i / b.width];
    for (size_t i = 0; i < b.width; i++) forcing[i] = 1.0;
    for (size_t block = 0; block < b.blocks; block++) {
        double *q = aligned(b.degrees * b.width), *v = aligned(b.rows * b.width);
        for (size_t lane = 0; lane < b.width; lane++) {
            state *at = &b.states[block * b.width + lane];
            *at = random_state(of);
            fill_lane(&b, q, v, at, lane);
            // The law of a ring takes the difference of both displacements.
            for (size_t a = 0; a < 2 && of->axes == COORDINATES; a++) {
                at->d[a] = q[a * b.width + lane] - q[(a + 2) * b.width + lane];
                at->w[a] = v[a * b.width + lane] - v[(a + 2) * b.width + lane];
            }
        }
        b.view[block] =
            (lanes_view){rotor, VECTORS, VECTORS, numbers, b.lanes->places, forcing, NULL, 0, q, v, b.a, NULL};
    }
    free(own);
    return b;
}

static void bench_free(bench *b) {
    for (size_t block = 0; block < b->blocks; block++) free((void *)b->view[block].q), free((void *)b->view[block].v);
    free((void *)b->view[0].numbers), free((void *)b->view[0].forcing);
    free(b->a), free(b->states);
}

// ---------------------------------------------------------------- proof and measurement

static void in_lanes(const bench *b, size_t block) {
    b->lanes->flow[b->on->number](&b->view[block]);
}

/// Computes the accelerations and the slopes of one state in plain C: out [degrees + states].
static void one_by_one(const bench *b, const state *at, double *out) {
    double sum[COORDINATES] = {0.0}, force[COORDINATES];
    const bench_element *of = b->of;
    for (size_t i = 0; i < TWICE; i++) {
        of->law(of->numbers, at->d, at->w, at->s, force, out + b->degrees + i * of->state_count);
        for (size_t a = 0; a < of->axes; a++) sum[a] += force[a];
    }
    const double over = 1.0 / (1.0 + TWICE * of->fluid);
    for (size_t a = 0; a < b->degrees; a++) out[a] = over * (a < 2 ? sum[a] : sum[a] - sum[a - 2]);
}

/// Returns the largest of all accelerations.
static double largest_size(const bench *b) {
    double largest = 0.0, out[COORDINATES + MAX_STATES];
    for (size_t i = 0; i < b->count; i++) {
        one_by_one(b, &b->states[i], out);
        for (size_t row = 0; row < b->degrees; row++) largest = fmax(largest, fabs(out[row]));
    }
    return largest;
}

/// Returns the largest difference of an acceleration over the largest one of its state, at least a hundredth of the
/// largest of all (for contacts that barely touch), or of a slope over 1 plus the slope.
static double largest_difference(const bench *b) {
    double worst = 0.0, out[COORDINATES + MAX_STATES];
    const double least = 1e-2 * largest_size(b);
    for (size_t i = 0; i < b->count; i++) {
        const size_t lane = i % b->width;
        if (lane == 0) in_lanes(b, i / b->width);
        one_by_one(b, &b->states[i], out);
        double size = least;
        for (size_t row = 0; row < b->degrees; row++) size = fmax(size, fabs(out[row]));
        for (size_t row = 0; row < b->rows; row++) {
            const double apart = fabs(out[row] - b->a[row * b->width + lane]);
            const double of = row < b->degrees ? size : 1.0 + fabs(out[row]);
            if (!(apart <= worst * of)) worst = of > 0.0 ? apart / of : INFINITY;
        }
    }
    return worst;
}

static void tell(const char *who, const bench_element *of, double rate, double apart) {
    printf("%s, %s\t%.6g\t%.3g\n", who, of->name, rate, apart);
}

static bool failed;
static const char *wanted; ///< beginning of the names that are measured; NULL: all

/// Measures evaluations a second: the best of rounds that go through all states.
static void measure(const bench_element *of, double seconds) {
    if (wanted && strncmp(of->name, wanted, strlen(wanted)) != 0) return;
    whirl_rotor *rotor = machine_of(of);
    bench b = bench_new(of, rotor);
    const double apart = largest_difference(&b), all = TWICE * (double)b.count;
    double best[2] = {0.0}, out[COORDINATES + MAX_STATES], kept = 0.0;
    for (double begun = peer_clock(); peer_clock() - begun < seconds;) {
        const double start = peer_clock();
        for (int i = 0; i < 8; i++)
            for (size_t block = 0; block < b.blocks; block++) in_lanes(&b, block);
        const double middle = peer_clock();
        for (size_t i = 0; i < b.count; i++) one_by_one(&b, &b.states[i], out), kept += out[0];
        const double end = peer_clock();
        best[0] = fmax(best[0], 8.0 * all / (middle - start));
        best[1] = fmax(best[1], all / (end - middle));
    }
    if (!(apart < 1e-12)) fprintf(stderr, "bench: %s differs by %.1e from its law in C\n", of->name, apart);
    if (!(apart < 1e-12) || isnan(kept)) failed = true;
    tell(b.on->name, of, best[0], apart);
    tell("C", of, best[1], apart);
    bench_free(&b);
    whirl_rotor_free(rotor);
}

int main(int argc, char **argv) {
    if (argc > 2) wanted = argv[2];
    measure_all(peer_seconds(argc, argv), measure);
    return failed;
}
