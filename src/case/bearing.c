// Reading what a journal bearing is, and the loads and speeds that it is to be computed for.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "keys.h"
#include "mineral_oil.h"
#include "problem.h"
#include "whirl/bearing_table.h"

enum { VERSION = 1 };

#define KINDS "plain|two-groove|elliptical|three-lobe|four-lobe|offset-half|tilting-4|tilting-5"

static const whirl_key file_keys[] = {
    WHOLE_KEY("bearing", "", REQUIRED, WHIRL_ANY, "version of the format, 1"),
    CHOICE_KEY("title", OPTIONAL, "", "what bearing it is, in one line"),
    CITED_CHOICE_KEY("kind", OPTIONAL, KINDS, "a usual bearing, as it stands under a load along -y; this or pads",
                     "Lund, Thomsen 1978; Lund 1964"),
    CHOICE_KEY("pads", OPTIONAL, "", "a list of pads"),
    CHOICE_KEY("tilting", OPTIONAL, "yes|no", "whether pads of such a list tilt about their pivots"),
    NUMBER_KEY("preload", "m", "1", OPTIONAL, WHIRL_FROM_TO(0.0, 0.99),
               "share of the clearance by which the pads of a kind stand nearer; plain and two-groove have none"),
    NUMBER_KEY("turned", "", "rad", DEFAULT("0"), WHIRL_ANY, "angle by which all pads stand further on, from x to y"),
    NUMBER_KEY("radius", "R", "m", OPTIONAL, WHIRL_POSITIVE, "of the journal; this or diameter"),
    NUMBER_KEY("diameter", "D", "m", OPTIONAL, WHIRL_POSITIVE, "of the journal"),
    NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "along the shaft"),
    NUMBER_KEY("pad_clearance", "c", "m", OPTIONAL, WHIRL_POSITIVE, "radial, between the radii of pad and journal"),
    NUMBER_KEY("clearance", "c_b", "m", OPTIONAL, WHIRL_POSITIVE,
               "radial, of the bearing as it stands: (1 - preload) times that of the pads; in its place"),
    NUMBER_KEY("viscosity", "mu", "Pa s", OPTIONAL, WHIRL_POSITIVE, "of the oil as warm as it is; or the keys below"),
    NUMBER_KEY("kinematic_viscosity", "", "m2/s", OPTIONAL, WHIRL_POSITIVE, "viscosity over density"),
    CITED_NUMBER_KEY("grade", "ISO VG", "1", OPTIONAL, WHIRL_FROM_TO(6.5, 1500.0),
                     "viscosity class of the oil, mm2/s at 40 degC, with temperature", "ISO 3448; Walther 1931"),
    NUMBER_KEY("temperature", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15), "of the oil in the film, '50 degC'"),
    CITED_NUMBER_KEY("kinematic_100", "", "m2/s", OPTIONAL, WHIRL_POSITIVE,
                     "at 100 degC, of an oil of that grade; absent: of viscosity index 100", "ASTM D2270"),
    NUMBER_KEY("density", "rho", "kg/m3", DEFAULT("870"), WHIRL_POSITIVE, "of the oil"),
    CITED_CHOICE_KEY("cavitation", DEFAULT("reynolds"), "reynolds|gumbel",
                     "reynolds: pressure and its gradient vanish where the film breaks; gumbel: the full film's "
                     "pressures below 0 are left out",
                     "Swift 1932, Stieber 1933; Guembel 1914"),
    CHOICE_KEY("load", REQUIRED, "", "N on the journal: a number, a list, or {from, to, points}"),
    NUMBER_KEY("load_angle", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
               "its direction, from x towards y; along -y where absent"),
    CHOICE_KEY("speed", REQUIRED, "", "of the journal: a number, a list, or {from, to, points}"),
    CHOICE_KEY("combine", DEFAULT("all"), "all|pairs",
               "all: every load at every speed; pairs: the first load at the first speed, and so on"),
    NUMBER_KEY("pad_inertia", "", "kg m2", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "of a tilting pad about its pivot"),
    {"whirl_ratio", "nu", "1", WHIRL_KEY_NUMBERS, false, "1", WHIRL_FROM_TO(0.0, 100.0), NULL,
     "frequency of whirl over speed at which coefficients of tilting pads are reduced; a list of up to 8",
     "Parsell, Allaire, Barrett 1983"},
    NUMBER_KEY("least_film", "", "m", DEFAULT("5e-6"), WHIRL_NOT_NEGATIVE, "thickness below which a warning stands"),
    WHOLE_KEY("fineness", "", DEFAULT("960"), WHIRL_FROM_TO(192, 3840), "volumes of the mesh around a full circle"),
};

static const whirl_key pad_keys[] = {
    NUMBER_KEY("pivot", "psi", "rad", REQUIRED, WHIRL_ANY, "where its pivot is, from x towards y"),
    NUMBER_KEY("arc", "", "rad", REQUIRED, WHIRL_ABOVE_TO(0.0, 6.2831853071795872), "its length"),
    NUMBER_KEY("offset", "", "1", DEFAULT("0.5"), WHIRL_FROM_TO(0.0, 1.0), "share of the arc before the pivot"),
    NUMBER_KEY("preload", "m", "1", DEFAULT("0"), WHIRL_FROM_TO(-0.99, 0.99),
               "share of the clearance by which it stands nearer at the pivot"),
};

static const whirl_key speeds_keys[] = {
    NUMBER_KEY("from", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "the first"),
    NUMBER_KEY("to", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "the last"),
    WHOLE_KEY("points", "", REQUIRED, WHIRL_FROM_TO(2, WHIRL_MAX_BEARING_POINTS), "how many, evenly spaced"),
};

static const whirl_key loads_keys[] = {
    NUMBER_KEY("from", "", "N", REQUIRED, WHIRL_POSITIVE, "the first"),
    NUMBER_KEY("to", "", "N", REQUIRED, WHIRL_POSITIVE, "the last"),
    WHOLE_KEY("points", "", REQUIRED, WHIRL_FROM_TO(2, WHIRL_MAX_BEARING_POINTS), "how many, evenly spaced"),
};

#define COUNT(keys) (sizeof(keys) / sizeof *(keys))
static const whirl_group file_group = {
    "bearing", "a file on a journal bearing by itself", "Reynolds 1886", file_keys, COUNT(file_keys), NULL, NULL};
static const whirl_group pad_group = {"pad", "a pad of a journal bearing", "Lund 1964", pad_keys, COUNT(pad_keys), NULL,
                                      NULL};
static const whirl_group speeds_group = {"speeds", "speeds in equal steps", "", speeds_keys, COUNT(speeds_keys), NULL,
                                         NULL};
static const whirl_group loads_group = {"loads", "loads in equal steps", "", loads_keys, COUNT(loads_keys), NULL, NULL};

/// The same by a name of its own beside the element `bearing`.
static const whirl_group described_group = {
    "bearing_file", "a file on a journal bearing by itself", "Reynolds 1886", file_keys, COUNT(file_keys), NULL, NULL};

const whirl_group *const *whirl_bearing_groups(void) {
    static const whirl_group *const groups[] = {&described_group, &pad_group, &speeds_group, &loads_group, NULL};
    return groups;
}

static const file_node *place_of(const setting_list *file, const char *key) {
    const setting *given = settings_find(file, key);
    return given ? given->place : file->place;
}

/// One of two keys, and not both; 0, or 1 and 2 for the one that is given.
static int one_of(case_reader *reader, const setting_list *file, const char *one, const char *other) {
    const setting *first = settings_find(file, one), *second = settings_find(file, other);
    if (first && second)
        problem_at(reader->problems, second->place, "stands beside %s, expected one of them", one);
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
        problem_at(reader->problems, list, "has pad %zu over pad %zu, expected pads beside each other", other + 1,
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
    if (!takes && preload) problem_at(reader->problems, preload->place, "is given, and a %s bearing has none", kind);
    const double own = settings_plain(reader, file, "preload");
    whirl_pads_named(kind, takes ? own : 0.0, &out->pads);
    const setting *tilting = settings_find(file, "tilting");
    if (tilting)
        problem_at(reader->problems, tilting->place, "is given, and whether pads of the kind %s tilt is known", kind);
}

static void read_shape(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const int which = one_of(reader, file, "kind", "pads");
    if (which == 1) read_kind(reader, file, out);
    if (which == 2) {
        snprintf(out->kind, sizeof out->kind, "pads");
        read_pads(reader, place_of(file, "pads"), out);
        check_overlap(reader, place_of(file, "pads"), &out->pads);
        out->pads.tilting = settings_yes(file, "tilting");
        if (!settings_find(file, "tilting") && !settings_misspelt(file, "tilting"))
            problem_missing(reader->problems, file->place, "tilting", "is missing, expected yes or no");
        if (settings_find(file, "preload"))
            problem_at(reader->problems, place_of(file, "preload"), "is given, and pads have their own");
    }
    const double turned = settings_plain(reader, file, "turned");
    for (size_t i = 0; i < out->pads.count; i++) out->pads.pads[i].pivot += turned;
    out->pads.gumbel = strcmp(settings_word(file, "cavitation"), "gumbel") == 0;
    const double fineness = settings_plain(reader, file, "fineness");
    out->pads.fineness = isfinite(fineness) ? 16 * (int)ceil(fineness / 16.0) : 0;
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
        problem_at(reader->problems, place_of(file, "clearance"),
                   "is of pads that have several preloads, expected pad_clearance in its place");
    out->pad_clearance = of == 1 ? settings_plain(reader, file, "pad_clearance")
                                 : settings_plain(reader, file, "clearance") / (1.0 - most);
    out->clearance = (1.0 - most) * out->pad_clearance;
    if (out->pad_clearance >= 0.05 * out->radius)
        problem_at(reader->problems, place_of(file, of == 1 ? "pad_clearance" : "clearance"),
                   "makes a clearance of pads of %.3g times the radius, expected less than 0.05",
                   out->pad_clearance / out->radius);
}

static void read_oil(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    static const char *const keys[] = {"viscosity", "kinematic_viscosity", "grade"};
    size_t given = 0, last = 0;
    for (size_t i = 0; i < COUNT(keys); i++)
        if (settings_find(file, keys[i])) given++, last = i;
    out->density = settings_plain(reader, file, "density");
    const double own = settings_plain(reader, file, keys[last]), warm = settings_plain(reader, file, "temperature");
    if (given == 0)
        problem_missing(reader->problems, file->place, "viscosity",
                        "is missing, expected this, kinematic_viscosity, or grade with temperature");
    else if (given > 1)
        problem_at(reader->problems, place_of(file, keys[last]), "stands beside another one, expected one of them");
    if (given != 1) return;
    if (last < 2 && (settings_find(file, "temperature") || settings_find(file, "kinematic_100")))
        problem_at(reader->problems,
                   place_of(file, settings_find(file, "temperature") ? "temperature" : "kinematic_100"),
                   "belongs to grade, which is not given");
    if (last == 2 && !settings_find(file, "temperature"))
        problem_missing(reader->problems, file->place, "temperature", "is missing, expected that of the film");
    out->viscosity = own;
    if (last == 1) out->viscosity = own * out->density;
    if (last != 2) return;
    const double hot = settings_find(file, "kinematic_100") ? settings_plain(reader, file, "kinematic_100")
                                                            : mineral_oil_at_100(own * 1e-6);
    if (hot >= own * 1e-6)
        problem_at(reader->problems, place_of(file, "kinematic_100"), "is not below that at 40 degC, %g mm2/s", own);
    else
        out->viscosity = out->density * mineral_oil_viscosity(own * 1e-6, hot, warm);
}

// ---------------------------------------------------------------- loads and speeds

/// The numbers that stand for a key: one, a list, or a range; NULL with *count 0 after a problem.
static double *numbers_of(case_reader *reader, const setting_list *file, const char *name, const whirl_group *range,
                          size_t *count) {
    const setting *given = settings_find(file, name);
    const whirl_key *key = &range->keys[0];
    char shown[SHOWN_SIZE];
    setting_list steps;
    *count = 0;
    if (!given) return NULL;
    const file_node *place = given->place;
    const bool list = place->kind == NODE_LIST;
    if (list && (place->count == 0 || place->count > WHIRL_MAX_BEARING_POINTS)) {
        problem_at(reader->problems, place, "has %zu numbers, expected 1 to %d", place->count,
                   WHIRL_MAX_BEARING_POINTS);
        return NULL;
    }
    if (place->kind == NODE_MAPPING) settings_read(reader, place, range, &steps);
    const double points = place->kind == NODE_MAPPING ? settings_plain(reader, &steps, "points") : NAN;
    const size_t most = list ? place->count : isfinite(points) ? (size_t)points : 1;
    double *out = arena_take(reader->arena, most * sizeof *out);
    reader->no_memory = reader->no_memory || !out;
    if (!out) return NULL;
    if (place->kind == NODE_MAPPING) {
        const double from = settings_plain(reader, &steps, "from"), to = settings_plain(reader, &steps, "to");
        for (size_t i = 0; i < most && isfinite(points); i++)
            out[i] = i + 1 == most ? to : from + (to - from) * (double)i / (points - 1.0);
        *count = isfinite(points) ? most : 0;
        return out;
    }
    for (const file_node *at = list ? place->first : place; at; at = list ? at->next : NULL) {
        number_formula value = {.number = NAN};
        if (formula_read(reader, at, key, &value) && value.expression)
            problem_at(reader->problems, at, "is %s, expected a number, no expression", node_shown(at, shown));
        out[(*count)++] = value.number;
    }
    return out;
}

static void read_points(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    size_t loads, speeds;
    const double *load = numbers_of(reader, file, "load", &loads_group, &loads);
    const double *speed = numbers_of(reader, file, "speed", &speeds_group, &speeds);
    out->pairs = strcmp(settings_word(file, "combine"), "pairs") == 0;
    out->load_count = loads;
    if (loads == 0 || speeds == 0) return;
    if (out->pairs && loads != speeds)
        problem_at(reader->problems, place_of(file, "combine"), "has %zu loads and %zu speeds, expected as many", loads,
                   speeds);
    if (!out->pairs && loads * speeds > WHIRL_MAX_BEARING_POINTS)
        problem_at(reader->problems, place_of(file, "load"), "makes %zu points with %zu speeds, expected at most %d",
                   loads * speeds, speeds, WHIRL_MAX_BEARING_POINTS);
    if ((out->pairs && loads != speeds) || loads * speeds > WHIRL_MAX_BEARING_POINTS * (out->pairs ? loads : 1)) return;
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
    const setting *given = settings_find(file, "whirl_ratio");
    out->ratio_count = 1;
    out->ratios[0] = 1.0;
    if (!given || !given->good) return;
    if (!given->word) {
        out->ratios[0] = settings_plain(reader, file, "whirl_ratio");
        return;
    }
    if (given->place->count > WHIRL_MAX_WHIRL_RATIOS) {
        problem_at(reader->problems, given->place, "has %zu numbers, expected 1 to %d", given->place->count,
                   WHIRL_MAX_WHIRL_RATIOS);
        return;
    }
    const char *text = given->word;
    for (out->ratio_count = 0; text; out->ratio_count++) {
        out->ratios[out->ratio_count] = strtod(text, NULL);
        text = strchr(text, ',');
        if (text) text++;
    }
}

static void fill(case_reader *reader, const setting_list *file, void *into) {
    whirl_bearing *out = into;
    settings_text(reader, file, "title", out->title, sizeof out->title);
    read_shape(reader, file, out);
    read_size(reader, file, out);
    read_oil(reader, file, out);
    read_points(reader, file, out);
    read_ratios(reader, file, out);
    out->load_angle = settings_plain(reader, file, "load_angle");
    out->inertia = settings_plain(reader, file, "pad_inertia");
    out->least_film = settings_plain(reader, file, "least_film");
    if (settings_find(file, "pad_inertia") && out->pads.count > 0 && !out->pads.tilting)
        problem_at(reader->problems, place_of(file, "pad_inertia"), "is given, and the pads do not tilt");
}

static void release(void *made) {
    whirl_bearing_free(made);
}

static const file_kind bearing_kind = {&file_group, VERSION, sizeof(whirl_bearing), fill, release};

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
