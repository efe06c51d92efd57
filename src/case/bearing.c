// Reading a single journal bearing, and its loads and speeds.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bearing_oil.h"
#include "file.h"
#include "keys.h"
#include "problem.h"
#include "settings.h"
#include "tree.h"
#include "whirl/internal/bearing_table.h"

enum { VERSION = 1 };

#define KINDS "plain|two-groove|elliptical|three-lobe|four-lobe|offset-half|tilting-4|tilting-5"

static const whirl_key file_keys[] = {
    WHOLE_KEY("bearing", "", REQUIRED, WHIRL_ANY, "version of the format, 1"),
    CHOICE_KEY("title", OPTIONAL, "", "name of the bearing, in one line"),
    UNITS_KEY,
    CITED_CHOICE_KEY("kind", OPTIONAL, KINDS, "a standard bearing, oriented for a load along -y; this or pads",
                     "Lund, Thomsen 1978; Lund 1964"),
    CHOICE_KEY("pads", OPTIONAL, "", "a list of pads"),
    CHOICE_KEY("tilting", OPTIONAL, "yes|no", "yes: the pads of the list tilt about their pivots"),
    NUMBER_KEY(
        "preload", "m", "1", OPTIONAL, WHIRL_FROM_TO(0.0, 0.99),
        "preload of the pads of a standard bearing, as a share of the clearance; plain and two-groove have none"),
    NUMBER_KEY("turned", "", "rad", DEFAULT("0"), WHIRL_ANY, "angle by which all pads are turned from x towards y"),
    NUMBER_KEY("radius", "R", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the journal; this or diameter"),
    NUMBER_KEY("diameter", "D", "m", OPTIONAL, WHIRL_POSITIVE, "diameter of the journal"),
    NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "length along the shaft"),
    NUMBER_KEY("pad_clearance", "c", "m", OPTIONAL, WHIRL_POSITIVE,
               "radial clearance of the pads, the difference of the radii of pad and journal"),
    NUMBER_KEY(
        "clearance", "c_b", "m", OPTIONAL, WHIRL_POSITIVE,
        "radial clearance of the assembled bearing, (1 - preload) times that of the pads, in place of pad_clearance"),
    NUMBER_KEY("viscosity", "mu", "Pa s", OPTIONAL, WHIRL_POSITIVE,
               "dynamic viscosity of the warm oil; this or the keys below"),
    NUMBER_KEY("kinematic_viscosity", "", "m2/s", OPTIONAL, WHIRL_POSITIVE, "viscosity over density"),
    CITED_NUMBER_KEY("grade", "ISO VG", "1", OPTIONAL, WHIRL_FROM_TO(6.5, 1500.0),
                     "viscosity class of the oil, mm2/s at 40 degC, with temperature", "ISO 3448; Walther 1931"),
    CITED_NUMBERS_KEY(
        "temperatures", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15),
        "rising temperatures of known viscosities of an oil, with Walther's law between them; in place of grade",
        "Walther 1931; ASTM D341"),
    CITED_NUMBERS_KEY("viscosities", "", "Pa s", OPTIONAL, WHIRL_POSITIVE, "viscosities at these temperatures", ""),
    NUMBER_KEY("temperature", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15),
               "temperature of the oil in the film, '50 degC'"),
    CITED_NUMBER_KEY("supply_temperature", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15),
                     "temperature of the entering oil, in place of temperature: the film has the mean temperature of "
                     "this and of the leaving oil, which carries heat_share of the power",
                     "Boswall 1928; DIN 31652"),
    NUMBER_KEY("heat_share", "kappa", "1", DEFAULT("1"), WHIRL_ABOVE_TO(0.0, 1.0),
               "share of the power that the leaving oil carries; the rest goes into the housing"),
    NUMBER_KEY("specific_heat", "c_p", "J/(kg K)", DEFAULT("1950"), WHIRL_POSITIVE, "specific heat of the oil"),
    CITED_NUMBER_KEY("kinematic_100", "", "m2/s", OPTIONAL, WHIRL_POSITIVE,
                     "kinematic viscosity at 100 degC of an oil of that grade; absent: that of viscosity index 100",
                     "ASTM D2270"),
    NUMBER_KEY("density", "rho", "kg/m3", DEFAULT("870"), WHIRL_POSITIVE, "density of the oil"),
    CITED_CHOICE_KEY("turbulence", DEFAULT("none"), "none|ng-pan|constantinescu",
                     "turbulence factors of the flows around and along and of the shear, by the local Reynolds number",
                     "Ng, Pan 1965; Constantinescu 1962"),
    NUMBER_KEY("supply_pressure", "p_s", "Pa", OPTIONAL, WHIRL_NOT_NEGATIVE,
               "pressure of the oil in the grooves between fixed pads, above that of the surroundings"),
    NUMBER_KEY("groove", "", "1", OPTIONAL, WHIRL_FROM_TO(0.0, 0.99),
               "share of the length over which grooves have that pressure; absent: .8; it falls evenly to the ends"),
    CITED_CHOICE_KEY("cavitation", DEFAULT("reynolds"), "reynolds|gumbel",
                     "reynolds: pressure and its gradient vanish where the film breaks; gumbel: the full film's "
                     "pressures below 0 are left out",
                     "Swift 1932, Stieber 1933; Guembel 1914"),
    CHOICE_KEY("load", REQUIRED, "", "load on the journal in N: a number, a list, or {from, to, points}"),
    NUMBER_KEY("load_angle", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
               "direction of the load, from x towards y; absent: along -y"),
    CHOICE_KEY("speed", REQUIRED, "", "speed of the journal: a number, a list, or {from, to, points}"),
    CHOICE_KEY("combine", DEFAULT("all"), "all|pairs",
               "all: every load at every speed; pairs: the first load at the first speed, and so on"),
    NUMBER_KEY("pad_inertia", "", "kg m2", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
               "moment of inertia of a tilting pad about its pivot"),
    NUMBER_KEY("pivot_stiffness", "k_p", "N/m", OPTIONAL, WHIRL_POSITIVE,
               "stiffness of a tilting pad's pivot along the radius; absent: rigid"),
    NUMBER_KEY("pivot_damping", "", "N s/m", OPTIONAL, WHIRL_NOT_NEGATIVE, "damping of a pivot along the radius"),
    NUMBER_KEY("pad_mass", "", "kg", OPTIONAL, WHIRL_NOT_NEGATIVE, "mass of a pad on such a pivot"),
    CITED_NUMBERS_KEY("whirl_ratio", "nu", "1", DEFAULT("1"), WHIRL_FROM_TO(0.0, 100.0),
                      "frequency of whirl over speed for the reduced coefficients of tilting pads; a list of up to 8",
                      "Parsell, Allaire, Barrett 1983"),
    NUMBER_KEY("least_film", "", "m", DEFAULT("5e-6"), WHIRL_NOT_NEGATIVE,
               "thickness of the film below which a warning appears"),
    WHOLE_KEY("fineness", "", DEFAULT("960"), WHIRL_FROM_TO(192, 3840), "volumes of the mesh around a full circle"),
};

static const whirl_key pad_keys[] = {
    NUMBER_KEY("pivot", "psi", "rad", REQUIRED, WHIRL_ANY, "position of its pivot, from x towards y"),
    NUMBER_KEY("arc", "", "rad", REQUIRED, WHIRL_ABOVE_TO(0.0, 6.2831853071795872), "length of its arc"),
    NUMBER_KEY("offset", "", "1", DEFAULT("0.5"), WHIRL_FROM_TO(0.0, 1.0), "share of the arc before the pivot"),
    NUMBER_KEY("preload", "m", "1", DEFAULT("0"), WHIRL_FROM_TO(-0.99, 0.99),
               "preload of the pad, as a share of the clearance"),
};

static const whirl_key speeds_keys[] = {
    NUMBER_KEY("from", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "first speed"),
    NUMBER_KEY("to", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "last speed"),
    WHOLE_KEY("points", "", REQUIRED, WHIRL_FROM_TO(2, WHIRL_MAX_BEARING_POINTS), "number of values, evenly spaced"),
};

static const whirl_key loads_keys[] = {
    NUMBER_KEY("from", "", "N", REQUIRED, WHIRL_POSITIVE, "first load"),
    NUMBER_KEY("to", "", "N", REQUIRED, WHIRL_POSITIVE, "last load"),
    WHOLE_KEY("points", "", REQUIRED, WHIRL_FROM_TO(2, WHIRL_MAX_BEARING_POINTS), "number of values, evenly spaced"),
};

#define COUNT(keys) (sizeof(keys) / sizeof *(keys))
static const whirl_group file_group = {
    "bearing", "a file on a journal bearing by itself", "Reynolds 1886", file_keys, COUNT(file_keys), NULL, NULL};
static const whirl_group pad_group = {"pad", "a pad of a journal bearing", "Lund 1964", pad_keys, COUNT(pad_keys), NULL,
                                      NULL};
static const whirl_group speeds_group = {"speeds", "speeds in equal steps", "", speeds_keys, COUNT(speeds_keys), NULL,
                                         NULL};
static const whirl_group loads_group = {"loads", "loads in equal steps", "", loads_keys, COUNT(loads_keys), NULL, NULL};

/// Group of the keys of a bearing file in descriptions; its name differs from that of the element `bearing`.
static const whirl_group described_group = {
    "bearing_file", "a file on a journal bearing by itself", "Reynolds 1886", file_keys, COUNT(file_keys), NULL, NULL};

const whirl_group *const *whirl_bearing_groups(void) {
    static const whirl_group *const groups[] = {&described_group, &pad_group, &speeds_group, &loads_group, NULL};
    return groups;
}

static const file_node *bearing_place(const setting_list *file, const char *key) {
    const setting *given = settings_find(file, key);
    return given ? given->place : file->place;
}

/// Requires exactly one of two keys; returns 1 or 2 for the given one, 0 after a problem.
static int one_of(case_reader *reader, const setting_list *file, const char *one, const char *other) {
    const setting *first = settings_find(file, one), *second = settings_find(file, other);
    if (first && second)
        problem_at(reader->problems, second->place, "is given together with %s, expected one of them", one);
    else if (!first && !second && !settings_misspelt(file, one) && !settings_misspelt(file, other))
        problem_missing(reader->problems, file->place, one, "is missing, expected this or %s", other);
    return first && second ? 0 : first ? 1 : second ? 2 : 0;
}

// ---------------------------------------------------------------- pads

static void read_pads(case_reader *reader, const file_node *list, whirl_bearing *out) {
    char shown[SHOWN_SIZE];
    if (list->kind != NODE_LIST || list->count == 0 || list->count > WHIRL_MAX_PADS) {
        problem_at(reader->problems, list, "is %s, expected a list of 1 to %d pads",
                   list->kind == NODE_LIST ? list->count ? "a longer list" : "an empty list" : node_shown(list, shown),
                   WHIRL_MAX_PADS);
        return;
    }
    for (const file_node *at = list->first; at; at = at->next) {
        setting_list item;
        settings_read(reader, at, &pad_group, &item);
        out->pads.pads[out->pads.count++] = (whirl_pad){.pivot = settings_plain(reader, &item, "pivot"),
                                                        .arc = settings_plain(reader, &item, "arc"),
                                                        .offset = settings_plain(reader, &item, "offset"),
                                                        .preload = settings_plain(reader, &item, "preload")};
    }
}

static void check_overlap(case_reader *reader, const file_node *list, const whirl_pads *pads) {
    size_t one, other;
    if (whirl_pads_overlap(pads, &one, &other))
        problem_at(reader->problems, list, "has pad %zu over pad %zu, expected pads next to each other", other + 1,
                   one + 1);
}

static bool is_preloaded(const whirl_pads *pads) {
    return pads->count > 0 && pads->pads[0].preload != 0.0;
}

static void read_kind(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const char *kind = settings_word(file, "kind");
    const setting *preload = settings_find(file, "preload");
    if (!kind || !settings_find(file, "kind")->good) return;
    snprintf(out->kind, sizeof out->kind, "%s", kind);
    whirl_pads_named(kind, 0.5, &out->pads);
    const bool takes = is_preloaded(&out->pads);
    if (takes && !preload && !settings_misspelt(file, "preload"))
        problem_missing(reader->problems, file->place, "preload", "is missing, expected that of %s pads", kind);
    if (!takes && preload)
        problem_at(reader->problems, preload->place, "is given, but a %s bearing has no preload", kind);
    const double own = settings_plain(reader, file, "preload");
    whirl_pads_named(kind, takes ? own : 0.0, &out->pads);
    const setting *tilting = settings_find(file, "tilting");
    if (tilting)
        problem_at(reader->problems, tilting->place, "is given, but the kind %s determines whether pads tilt", kind);
}

static void read_shape(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const int which = one_of(reader, file, "kind", "pads");
    if (which == 1) read_kind(reader, file, out);
    if (which == 2) {
        snprintf(out->kind, sizeof out->kind, "pads");
        read_pads(reader, bearing_place(file, "pads"), out);
        check_overlap(reader, bearing_place(file, "pads"), &out->pads);
        out->pads.tilting = settings_yes(file, "tilting");
        if (!settings_find(file, "tilting") && !settings_misspelt(file, "tilting"))
            problem_missing(reader->problems, file->place, "tilting", "is missing, expected yes or no");
        if (settings_find(file, "preload"))
            problem_at(reader->problems, bearing_place(file, "preload"), "is given, and pads have their own");
    }
    const double turned = settings_plain(reader, file, "turned");
    for (size_t i = 0; i < out->pads.count; i++) out->pads.pads[i].pivot += turned;
    out->pads.gumbel = strcmp(settings_word(file, "cavitation"), "gumbel") == 0;
    const double fineness = settings_plain(reader, file, "fineness");
    out->pads.fineness = isfinite(fineness) ? 16 * (int)ceil(fineness / 16.0) : 0;
}

static void read_turbulence(const setting_list *file, whirl_bearing *out) {
    const char *law = settings_word(file, "turbulence");
    out->pads.turbulence = strcmp(law, "ng-pan") == 0           ? WHIRL_NG_PAN
                           : strcmp(law, "constantinescu") == 0 ? WHIRL_CONSTANTINESCU
                                                                : WHIRL_LAMINAR;
}

/// Reports a key that has no effect without another one.
static void check_belongs(case_reader *reader, const setting_list *file, const char *key, const char *to) {
    const setting *given = settings_find(file, key);
    if (given && !settings_find(file, to) && !settings_misspelt(file, to))
        problem_at(reader->problems, given->place, "belongs to %s, which is not given", to);
}

static void read_grooves(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const setting *pressure = settings_find(file, "supply_pressure");
    check_belongs(reader, file, "groove", "supply_pressure");
    out->pads.groove = settings_find(file, "groove") ? settings_plain(reader, file, "groove") : 0.8;
    if (!pressure) return;
    out->supply_pressure = settings_plain(reader, file, "supply_pressure");
    if (out->pads.tilting)
        problem_at(reader->problems, pressure->place,
                   "is given, and pads that tilt have no grooves: their housing has one pressure all around");
    for (size_t i = 0; i < out->pads.count && !out->pads.tilting; i++) {
        const double gap = whirl_pads_gap(&out->pads, i) * 180.0 / 3.14159265358979323846;
        if (gap > 90.0)
            problem_at(
                reader->problems, pressure->place,
                "is given, and behind pad %zu there are %.4g degrees without a pad, expected grooves of at most 90 "
                "degrees",
                i + 1, gap);
    }
}

static void read_pivots(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    static const char *const keys[] = {"pad_inertia", "pivot_stiffness", "pivot_damping", "pad_mass"};
    double *const numbers[] = {&out->inertia, &out->pivot_stiffness, &out->pivot_damping, &out->pad_mass};
    for (size_t i = 0; i < COUNT(keys); i++) {
        const setting *given = settings_find(file, keys[i]);
        if (given) *numbers[i] = settings_plain(reader, file, keys[i]);
        if (given && out->pads.count > 0 && !out->pads.tilting)
            problem_at(reader->problems, given->place, "is given, and the pads do not tilt");
        else if (i > 1)
            check_belongs(reader, file, keys[i], "pivot_stiffness");
    }
}

static void read_size(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const int by = one_of(reader, file, "radius", "diameter");
    out->radius = by == 1 ? settings_plain(reader, file, "radius") : 0.5 * settings_plain(reader, file, "diameter");
    out->length = settings_plain(reader, file, "length");
    out->pads.ratio = out->length / (2.0 * out->radius);
    double most = 0.0, least = 1.0;
    for (size_t i = 0; i < out->pads.count; i++) {
        most = fmax(most, out->pads.pads[i].preload);
        least = fmin(least, out->pads.pads[i].preload);
    }
    const int of = one_of(reader, file, "pad_clearance", "clearance");
    if (of == 2 && out->pads.count > 0 && least != most)
        problem_at(reader->problems, bearing_place(file, "clearance"),
                   "is given for pads with different preloads, expected pad_clearance in its place");
    out->pad_clearance = of == 1 ? settings_plain(reader, file, "pad_clearance")
                                 : settings_plain(reader, file, "clearance") / (1.0 - most);
    out->clearance = (1.0 - most) * out->pad_clearance;
    if (out->pad_clearance >= 0.05 * out->radius)
        problem_at(reader->problems, bearing_place(file, of == 1 ? "pad_clearance" : "clearance"),
                   "makes a clearance of pads of %.3g times the radius, expected less than 0.05",
                   out->pad_clearance / out->radius);
}

// ---------------------------------------------------------------- loads and speeds

/// Reads the numbers of a key: one, a list, or a range; NULL with *count 0 after a problem.
static double *numbers_of(case_reader *reader, const setting_list *file, const char *name, const whirl_group *range,
                          size_t *count) {
    // Find the key, and how its numbers are given.
    const setting *given = settings_find(file, name);
    const whirl_key *key = &range->keys[0];
    char shown[SHOWN_SIZE];
    setting_list steps;
    *count = 0;
    if (!given) return NULL;
    const file_node *place = given->place;
    const bool list = place->kind == NODE_LIST;
    // Refuse lists that are empty or too long.
    if (list && (place->count == 0 || place->count > WHIRL_MAX_BEARING_POINTS)) {
        problem_at(reader->problems, place, "has %zu numbers, expected 1 to %d", place->count,
                   WHIRL_MAX_BEARING_POINTS);
        return NULL;
    }
    // Make memory for the numbers.
    if (place->kind == NODE_MAPPING) settings_read(reader, place, range, &steps);
    const double points = place->kind == NODE_MAPPING ? settings_plain(reader, &steps, "points") : NAN;
    const size_t most = list ? place->count : isfinite(points) ? (size_t)points : 1;
    double *out = arena_take(reader->arena, most * sizeof *out);
    reader->no_memory = reader->no_memory || !out;
    if (!out) return NULL;
    // Fill in a range: equal steps from one end to the other.
    if (place->kind == NODE_MAPPING) {
        const double from = settings_plain(reader, &steps, "from"), to = settings_plain(reader, &steps, "to");
        for (size_t i = 0; i < most && isfinite(points); i++)
            out[i] = i + 1 == most ? to : from + (to - from) * (double)i / (points - 1.0);
        *count = isfinite(points) ? most : 0;
        return out;
    }
    // Read one number, or each of a list.
    for (const file_node *at = list ? place->first : place; at; at = list ? at->next : NULL) {
        number_formula value = {.number = NAN};
        if (formula_read(reader, at, key, &value) && value.expression)
            problem_at(reader->problems, at, "is %s, expected a number, no expression", node_shown(at, shown));
        out[(*count)++] = value.number;
    }
    return out;
}

static void read_points(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    // Read loads and speeds.
    size_t loads, speeds;
    const double *load = numbers_of(reader, file, "load", &loads_group, &loads);
    const double *speed = numbers_of(reader, file, "speed", &speeds_group, &speeds);
    out->pairs = strcmp(settings_word(file, "combine"), "pairs") == 0;
    out->load_count = loads;
    if (loads == 0 || speeds == 0) return;
    // Refuse pairs of unequal numbers, and too many combinations.
    if (out->pairs && loads != speeds)
        problem_at(reader->problems, bearing_place(file, "combine"),
                   "has %zu loads and %zu speeds, expected equal numbers", loads, speeds);
    if (!out->pairs && loads * speeds > WHIRL_MAX_BEARING_POINTS)
        problem_at(reader->problems, bearing_place(file, "load"),
                   "makes %zu points with %zu speeds, expected at most %d", loads * speeds, speeds,
                   WHIRL_MAX_BEARING_POINTS);
    if ((out->pairs && loads != speeds) || loads * speeds > WHIRL_MAX_BEARING_POINTS * (out->pairs ? loads : 1)) return;
    // Combine them: pair by pair, or every load with every speed.
    const size_t count = out->pairs ? speeds : loads * speeds;
    out->speeds = malloc(count * sizeof *out->speeds);
    out->loads = malloc(count * sizeof *out->loads);
    reader->no_memory = reader->no_memory || !out->speeds || !out->loads;
    if (!out->speeds || !out->loads) return;
    out->count = count;
    for (size_t i = 0; i < count; i++) {
        out->speeds[i] = speed[i % speeds];
        out->loads[i] = load[out->pairs ? i : i / speeds];
    }
}

static void read_ratios(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    out->ratio_count = settings_list_plain(reader, file, "whirl_ratio", out->ratios, WHIRL_MAX_WHIRL_RATIOS);
}

static void bearing_fill(case_reader *reader, const setting_list *file, void *into) {
    whirl_bearing *out = into;
    settings_text(reader, file, "title", out->title, sizeof out->title);
    settings_units(reader, file, out->units, sizeof out->units);
    read_shape(reader, file, out);
    read_size(reader, file, out);
    bearing_oil_read(reader, file, out);
    read_turbulence(file, out);
    read_grooves(reader, file, out);
    read_points(reader, file, out);
    read_ratios(reader, file, out);
    out->load_angle = settings_plain(reader, file, "load_angle");
    read_pivots(reader, file, out);
    out->least_film = settings_plain(reader, file, "least_film");
}

static void bearing_release(void *made) {
    whirl_bearing_free(made);
}

static const file_kind bearing_kind = {&file_group, VERSION, sizeof(whirl_bearing), bearing_fill, bearing_release};

whirl_status whirl_bearing_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                                 whirl_bearing **out) {
    void *made;
    const whirl_status status = file_parse(&bearing_kind, text, length, name, problems, &made);
    *out = made;
    return status;
}

whirl_status whirl_bearing_load(const char *path, whirl_problems *problems, whirl_bearing **bearing) {
    void *made;
    const whirl_status status = file_load(&bearing_kind, path, problems, &made);
    *bearing = made;
    return status;
}

void whirl_bearing_free(whirl_bearing *bearing) {
    if (!bearing) return;
    free(bearing->speeds);
    free(bearing->loads);
    free(bearing);
}
