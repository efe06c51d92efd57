// Findings on bearings, seals, dampers, magnets and supports of a machine, as its case gives them: a sheet for each
// family of parts.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shown_kinds.h"
#include "whirl/internal/model.h"

#define TWO_PI 6.283185307179586476925
static const double pi = 0.5 * TWO_PI;

/// A part of the machine, which has one row.
typedef struct machine_part {
    const finder *of;
    const whirl_model *model;
    const whirl_model_element *element;
} machine_part;

/// A column of a family's sheet: the number of a key of the elements, or what a function returns for an element.
/// Numbers of keys are shown only if the case gives them, not for defaults.
typedef struct part_column {
    const char *name, *heading; ///< key and heading of the column
    whirl_quantity quantity;    ///< quantity of the numbers
    const char *unit;           ///< unit of the numbers if it is not the SI unit of the quantity; else NULL
    const char *key;            ///< key of the elements; NULL: none
    double factor;              ///< factor of the key's number; 0 means 1
    double (*number)(const machine_part *part,
                     const char *); ///< returns the number; NULL: it is that of the key
    size_t (*list)(const machine_part *part, const char *key, double numbers[WHIRL_MAX_PADS]);
    const char *between;                           ///< separator of the numbers of a list
    const char *(*text)(const machine_part *part); ///< returns the text of a cell; NULL: the column has numbers
} part_column;

// ---------------------------------------------------------------- values of elements

static const whirl_model_value *part_given(const machine_part *part, const char *key) {
    const whirl_model_value *value = whirl_model_value_of(part->element, key);
    return value && value->given ? value : NULL;
}

static double part_number(const machine_part *part, const char *key) {
    const whirl_model_value *value = part_given(part, key);
    return value && value->count == 0 ? value->number : (double)NAN;
}

/// Returns the number of a key, or its default, if the element's law is choice `law`; else NaN.
static double part_of_law(const machine_part *part, const char *key, int law) {
    const whirl_model_value *own = whirl_model_value_of(part->element, "law");
    const whirl_model_value *value = whirl_model_value_of(part->element, key);
    return own && value && own->choice == law ? value->number : (double)NAN;
}
static double part_of_first_law(const machine_part *part, const char *key) {
    return part_of_law(part, key, 0);
}
static double part_of_second_law(const machine_part *part, const char *key) {
    return part_of_law(part, key, 1);
}

/// Returns the number of equal parts at the station if there are several; else NaN.
static double part_equals(const machine_part *part, const char *key) {
    const whirl_model_value *value = part_given(part, key);
    return value && value->number > 1.0 ? value->number : (double)NAN;
}

static double part_length_ratio(const machine_part *part, const char *key) {
    return part_number(part, key) / (2.0 * part_number(part, "radius"));
}

static double part_viscosity(const machine_part *part, const char *key) {
    (void)key;
    return part->element->viscosity;
}

static double part_order(const machine_part *part, const char *key) {
    const whirl_model_value *value = part_given(part, key);
    return value && value->count > 0 ? (double)value->count - 1.0 : (double)NAN;
}

/// Appends the word of a key with choices to a text.
static void part_append_choice(const machine_part *part, const char *key, char *text, size_t size) {
    const whirl_model_value *value = whirl_model_value_of(part->element, key);
    const size_t used = strlen(text);
    if (!value || !value->key->choices || (!value->given && !*value->key->fallback)) return;
    const char *word = value->key->choices;
    for (int i = 0; i < value->choice && word; i++) word = strchr(word, '|') ? strchr(word, '|') + 1 : NULL;
    if (word) snprintf(text + used, size - used, ", %.*s", (int)strcspn(word, "|"), word);
}

/// Returns the kind of a part in words: "tilting pad, tilting-5", "film, short", "squeeze, short, half".
static const char *part_kind(const machine_part *part) {
    static const char *const choices[] = {"shape", "law", "film", "role"};
    char text[WHIRL_MESSAGE_SIZE];
    snprintf(text, sizeof text, "%.60s", part->element->kind);
    for (char *letter = text; *letter; letter++)
        if (*letter == '_') *letter = ' ';
    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++)
        part_append_choice(part, choices[i], text, sizeof text);
    return find_text(part->of->findings, "%s", text);
}

/// Returns the station of a part: that of its first end which is not on the ground if `first`, else that of the other
/// end.
static size_t part_station(const whirl_model_element *element, bool first) {
    const bool ground = element->station[0] == WHIRL_MODEL_NONE;
    return element->station[first == ground];
}

/// Returns the name of the housing or support of a part; "" for the ground.
static const char *part_housing(const machine_part *part) {
    const size_t other = part_station(part->element, false);
    if (other >= part->of->result->station_count) return "";
    return find_text(part->of->findings, "%s", part->of->result->stations[other].name);
}

static const char *part_along(const machine_part *part) {
    char text[WHIRL_MESSAGE_SIZE] = "";
    part_append_choice(part, "along", text, sizeof text);
    return *text ? find_text(part->of->findings, "%s", text + strlen(", ")) : "";
}

static bool part_tilts(const machine_part *part) {
    return strncmp(part_along(part), "tilt", strlen("tilt")) == 0;
}
static double part_along_lengths(const machine_part *part, const char *key) {
    return part_tilts(part) ? (double)NAN : part_number(part, key);
}
static double part_along_tilts(const machine_part *part, const char *key) {
    return part_tilts(part) ? part_number(part, key) : (double)NAN;
}

// ---------------------------------------------------------------- oil

static const char *part_oil(const machine_part *part) {
    if (part_given(part, "grade")) return find_text(part->of->findings, "ISO VG %.6g", part_number(part, "grade"));
    if (part_given(part, "temperatures")) return "viscosity by table";
    return isfinite(part->element->viscosity) ? "viscosity given" : "";
}

static const char *part_turbulence(const machine_part *part) {
    char text[WHIRL_MESSAGE_SIZE] = "";
    if (part_given(part, "turbulence")) part_append_choice(part, "turbulence", text, sizeof text);
    if (!*text || strcmp(text, ", none") == 0) return "";
    return find_text(part->of->findings, "%s", text + strlen(", "));
}

// ---------------------------------------------------------------- pads

static double part_pads(const machine_part *part, const char *key) {
    (void)key;
    return part->element->pads ? (double)part->element->pads->count : (double)NAN;
}
static double part_preload(const machine_part *part, const char *key) {
    (void)key;
    return part->element->pads ? part->element->pads->pads[0].preload : (double)NAN;
}
static double part_offset(const machine_part *part, const char *key) {
    (void)key;
    return part->element->pads ? part->element->pads->pads[0].offset : (double)NAN;
}
static double part_arc(const machine_part *part, const char *key) {
    (void)key;
    return part->element->pads ? part->element->pads->pads[0].arc * 180.0 / pi : (double)NAN;
}
static double part_assembled(const machine_part *part, const char *key) {
    return (1.0 - part_preload(part, NULL)) * part_number(part, key);
}

/// Returns an angle in degrees, from 0 to below 360, without rounding errors.
static double degrees_around(double angle) {
    const double turns = angle / (2.0 * pi), around = 360.0 * (turns - floor(turns));
    const double rounded = round(1e6 * around) / 1e6;
    return rounded >= 360.0 ? 0.0 : rounded;
}

static size_t part_pivots(const machine_part *part, const char *key, double numbers[WHIRL_MAX_PADS]) {
    const whirl_pads *pads = part->element->pads;
    (void)key;
    for (size_t i = 0; pads && i < pads->count; i++) numbers[i] = degrees_around(pads->pads[i].pivot);
    return pads ? pads->count : 0;
}

/// Returns the direction of the weight across the shafts, rad; NaN without weight.
static double weight_direction(const whirl_model *model) {
    for (size_t i = 0; i < model->element_count; i++) {
        const whirl_model_element *own = &model->elements[i];
        const whirl_model_value *axis = whirl_model_value_of(own, "axis");
        const whirl_model_value *size = whirl_model_value_of(own, "acceleration");
        const whirl_model_value *direction = whirl_model_value_of(own, "direction");
        if (axis && size && direction && axis->choice == 0 && size->number > 0.0) return direction->number;
    }
    return NAN;
}

/// Returns the direction of the weight relative to the pivots: "on pad 1", "between pads 1 and 2", "12 deg from pivot
/// 1"; "" without weight or pads.
static const char *part_weight(const machine_part *part) {
    static const double exact = 0.5; // degrees
    const whirl_pads *pads = part->element->pads;
    const double weight = degrees_around(weight_direction(part->model));
    size_t before = 0, after = 0;
    double behind = INFINITY, ahead = INFINITY;
    if (!pads || !isfinite(weight)) return "";
    for (size_t i = 0; i < pads->count; i++) {
        const double pivot = degrees_around(pads->pads[i].pivot);
        const double away = degrees_around((pivot - weight) * pi / 180.0), back = away > 0.0 ? 360.0 - away : 0.0;
        if (away < ahead) ahead = away, after = i;
        if (back < behind) behind = back, before = i;
    }
    const size_t nearest = ahead < behind ? after : before;
    if (fmin(ahead, behind) < exact) return find_text(part->of->findings, "on pad %zu", nearest + 1);
    if (pads->count > 1 && fabs(ahead - behind) < exact)
        return find_text(part->of->findings, "between pads %zu and %zu", before < after ? before + 1 : after + 1,
                         before < after ? after + 1 : before + 1);
    return find_text(part->of->findings, "%.3g deg from pivot %zu", fmin(ahead, behind), nearest + 1);
}

// ---------------------------------------------------------------- given coefficients

static size_t part_range(const machine_part *part, const char *key, double numbers[WHIRL_MAX_PADS]) {
    const whirl_model_value *value = part_given(part, key);
    if (!value) return 0;
    numbers[0] = value->number;
    numbers[1] = value->last;
    return value->count > 1 ? 2 : 1;
}

/// Returns a constant coefficient; an absent one along y equals the one along x.
static double part_coefficient(const machine_part *part, const char *key) {
    const whirl_model_value *value = whirl_model_value_of(part->element, key);
    const char *const same = strcmp(key, "kyy") == 0 ? "kxx" : strcmp(key, "cyy") == 0 ? "cxx" : NULL;
    if (value && !value->given && same) return part_coefficient(part, same);
    return value && value->count == 0 ? value->number : (double)NAN;
}

// ---------------------------------------------------------------- families

#define NUMBER_OF(name, heading, quantity, key, factor)                                                                \
    { name, heading, quantity, NULL, key, factor, NULL, NULL, NULL, NULL }
#define MADE_OF(name, heading, quantity, key, number)                                                                  \
    { name, heading, quantity, NULL, key, 0.0, number, NULL, NULL, NULL }
#define UNIT_OF(name, heading, unit, key)                                                                              \
    { name, heading, WHIRL_QUANTITY_NUMBER, unit, key, 0.0, NULL, NULL, NULL, NULL }
#define LIST_OF(name, heading, quantity, key, list, between)                                                           \
    { name, heading, quantity, NULL, key, 0.0, NULL, list, between, NULL }
#define TEXT_OF(name, heading, text)                                                                                   \
    { name, heading, WHIRL_QUANTITY_NUMBER, NULL, NULL, 0.0, NULL, NULL, NULL, text }
#define COEFFICIENT_OF(name, quantity)                                                                                 \
    { name, name, quantity, NULL, name, 0.0, part_coefficient, NULL, NULL, NULL }
#define END_OF_COLUMNS                                                                                                 \
    { NULL, NULL, WHIRL_QUANTITY_NUMBER, NULL, NULL, 0.0, NULL, NULL, NULL, NULL }

static const part_column film_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("housing", "in", part_housing),
    MADE_OF("equal", "equal ones", WHIRL_QUANTITY_NUMBER, "count", part_equals),
    NUMBER_OF("diameter", "diameter", WHIRL_QUANTITY_DIAMETER, "radius", 2.0),
    NUMBER_OF("length", "length", WHIRL_QUANTITY_DIAMETER, "length", 1.0),
    MADE_OF("length_ratio", "length over diameter", WHIRL_QUANTITY_NUMBER, "length", part_length_ratio),
    NUMBER_OF("clearance", "radial clearance", WHIRL_QUANTITY_LENGTH, "clearance", 1.0),
    MADE_OF("assembled", "assembled radial clearance", WHIRL_QUANTITY_LENGTH, "clearance", part_assembled),
    MADE_OF("preload", "preload", WHIRL_QUANTITY_NUMBER, NULL, part_preload),
    MADE_OF("offset", "offset", WHIRL_QUANTITY_NUMBER, NULL, part_offset),
    MADE_OF("pads", "pads", WHIRL_QUANTITY_NUMBER, NULL, part_pads),
    MADE_OF("arc", "pad arc", WHIRL_QUANTITY_DEGREES, NULL, part_arc),
    LIST_OF("pivots", "pivots", WHIRL_QUANTITY_DEGREES, NULL, part_pivots, ", "),
    TEXT_OF("weight", "weight points", part_weight),
    NUMBER_OF("pivot_stiffness", "pivot stiffness", WHIRL_QUANTITY_STIFFNESS, "pivot_stiffness", 1.0),
    NUMBER_OF("outer_diameter", "diameter of outer film", WHIRL_QUANTITY_DIAMETER, "outer_radius", 2.0),
    NUMBER_OF("outer_length", "length of outer film", WHIRL_QUANTITY_DIAMETER, "outer_length", 1.0),
    NUMBER_OF("outer_clearance", "radial clearance of outer film", WHIRL_QUANTITY_LENGTH, "outer_clearance", 1.0),
    TEXT_OF("oil", "oil", part_oil),
    MADE_OF("viscosity", "viscosity", WHIRL_QUANTITY_VISCOSITY, NULL, part_viscosity),
    NUMBER_OF("temperature", "temperature of film", WHIRL_QUANTITY_TEMPERATURE, "temperature", 1.0),
    NUMBER_OF("density", "density", WHIRL_QUANTITY_DENSITY, "density", 1.0),
    NUMBER_OF("supply_temperature", "supply temperature, not used", WHIRL_QUANTITY_TEMPERATURE, "supply_temperature",
              1.0),
    NUMBER_OF("supply_pressure", "supply pressure, not used", WHIRL_QUANTITY_PRESSURE, "supply_pressure", 1.0),
    TEXT_OF("turbulence", "turbulence", part_turbulence),
    NUMBER_OF("force", "force scale", WHIRL_QUANTITY_FORCE, "load", 1.0),
    END_OF_COLUMNS,
};

static const part_column seal_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("housing", "in", part_housing),
    NUMBER_OF("diameter", "diameter", WHIRL_QUANTITY_DIAMETER, "radius", 2.0),
    NUMBER_OF("length", "length", WHIRL_QUANTITY_DIAMETER, "length", 1.0),
    NUMBER_OF("clearance", "radial clearance", WHIRL_QUANTITY_LENGTH, "clearance", 1.0),
    NUMBER_OF("stiffness", "stiffness", WHIRL_QUANTITY_STIFFNESS, "stiffness", 1.0),
    NUMBER_OF("damping", "damping", WHIRL_QUANTITY_DAMPING, "damping", 1.0),
    NUMBER_OF("mass", "mass of fluid", WHIRL_QUANTITY_MASS, "mass", 1.0),
    NUMBER_OF("ratio", "speed of fluid over shaft", WHIRL_QUANTITY_NUMBER, "ratio", 1.0),
    NUMBER_OF("pressure", "pressure drop", WHIRL_QUANTITY_PRESSURE, "pressure", 1.0),
    MADE_OF("swirl", "inlet swirl", WHIRL_QUANTITY_NUMBER, "swirl", part_of_second_law),
    MADE_OF("loss", "inlet loss", WHIRL_QUANTITY_NUMBER, "loss", part_of_second_law),
    MADE_OF("viscosity", "viscosity", WHIRL_QUANTITY_VISCOSITY, NULL, part_viscosity),
    NUMBER_OF("density", "density", WHIRL_QUANTITY_DENSITY, "density", 1.0),
    END_OF_COLUMNS,
};

static const part_column rolling_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("housing", "in", part_housing),
    NUMBER_OF("balls", "balls", WHIRL_QUANTITY_NUMBER, "balls", 1.0),
    NUMBER_OF("rollers", "rollers", WHIRL_QUANTITY_NUMBER, "rollers", 1.0),
    MADE_OF("rows", "rows", WHIRL_QUANTITY_NUMBER, "rows", part_equals),
    NUMBER_OF("inner", "diameter of inner race", WHIRL_QUANTITY_DIAMETER, "inner", 2.0),
    NUMBER_OF("outer", "diameter of outer race", WHIRL_QUANTITY_DIAMETER, "outer", 2.0),
    NUMBER_OF("contact_angle", "contact angle", WHIRL_QUANTITY_DEGREES, "contact_angle", 360.0 / TWO_PI),
    NUMBER_OF("clearance", "radial play, preload below 0", WHIRL_QUANTITY_LENGTH, "clearance", 1.0),
    NUMBER_OF("axial_load", "axial load of a row", WHIRL_QUANTITY_FORCE, "axial_load", 1.0),
    NUMBER_OF("damping", "damping", WHIRL_QUANTITY_DAMPING, "damping", 1.0),
    END_OF_COLUMNS,
};

static const part_column magnet_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("housing", "in", part_housing),
    NUMBER_OF("gap", "air gap", WHIRL_QUANTITY_LENGTH, "gap", 1.0),
    UNIT_OF("bias", "bias current", "A", "bias"),
    UNIT_OF("max_current", "largest current", "A", "max_current"),
    UNIT_OF("constant", "force constant", "N m2/A2", "constant"),
    NUMBER_OF("turns", "turns", WHIRL_QUANTITY_NUMBER, "turns", 1.0),
    UNIT_OF("area", "area of a pole", "m2", "area"),
    {"pole_angle", "angle of poles", WHIRL_QUANTITY_DEGREES, NULL, "pole_angle", 360.0 / TWO_PI, part_of_first_law,
     NULL, NULL, NULL},
    UNIT_OF("current_stiffness", "force over current", "N/A", "current_stiffness"),
    NUMBER_OF("displacement_stiffness", "negative stiffness", WHIRL_QUANTITY_STIFFNESS, "displacement_stiffness", 1.0),
    UNIT_OF("proportional", "proportional gain", "A/m", "proportional"),
    UNIT_OF("integral", "integral gain", "A/(m s)", "integral"),
    UNIT_OF("derivative", "derivative gain", "A s/m", "derivative"),
    UNIT_OF("derivative_filter", "filter of the derivative", "s", "derivative_filter"),
    MADE_OF("filter_order", "order of the filter", WHIRL_QUANTITY_NUMBER, "denominator", part_order),
    NUMBER_OF("sensor_bandwidth", "corner of sensor", WHIRL_QUANTITY_FREQUENCY, "sensor_bandwidth", TWO_PI),
    NUMBER_OF("amplifier_bandwidth", "corner of amplifier", WHIRL_QUANTITY_FREQUENCY, "amplifier_bandwidth", TWO_PI),
    END_OF_COLUMNS,
};

static const part_column coefficient_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("housing", "in", part_housing),
    COEFFICIENT_OF("kxx", WHIRL_QUANTITY_STIFFNESS),
    COEFFICIENT_OF("kxy", WHIRL_QUANTITY_STIFFNESS),
    COEFFICIENT_OF("kyx", WHIRL_QUANTITY_STIFFNESS),
    COEFFICIENT_OF("kyy", WHIRL_QUANTITY_STIFFNESS),
    COEFFICIENT_OF("cxx", WHIRL_QUANTITY_DAMPING),
    COEFFICIENT_OF("cxy", WHIRL_QUANTITY_DAMPING),
    COEFFICIENT_OF("cyx", WHIRL_QUANTITY_DAMPING),
    COEFFICIENT_OF("cyy", WHIRL_QUANTITY_DAMPING),
    NUMBER_OF("mxx", "mxx", WHIRL_QUANTITY_MASS, "mxx", 1.0),
    NUMBER_OF("mxy", "mxy", WHIRL_QUANTITY_MASS, "mxy", 1.0),
    NUMBER_OF("myy", "myy", WHIRL_QUANTITY_MASS, "myy", 1.0),
    LIST_OF("speeds", "table over speeds", WHIRL_QUANTITY_SPEED, "speeds", part_range, " to "),
    LIST_OF("frequencies", "table over frequencies of whirl", WHIRL_QUANTITY_FREQUENCY, "frequencies", part_range,
            " to "),
    NUMBER_OF("whirl_ratio", "whirl ratio", WHIRL_QUANTITY_NUMBER, "whirl_ratio", 1.0),
    END_OF_COLUMNS,
};

static const part_column support_columns[] = {
    TEXT_OF("kind", "kind", part_kind),
    TEXT_OF("other", "to", part_housing),
    TEXT_OF("along", "along", part_along),
    MADE_OF("stiffness", "stiffness", WHIRL_QUANTITY_STIFFNESS, "stiffness", part_along_lengths),
    NUMBER_OF("branch", "stiffness in series with the damper", WHIRL_QUANTITY_STIFFNESS, "branch", 1.0),
    MADE_OF("damping", "damping", WHIRL_QUANTITY_DAMPING, "damping", part_along_lengths),
    MADE_OF("tilt_stiffness", "stiffness a radian", WHIRL_QUANTITY_MOMENT, "stiffness", part_along_tilts),
    NUMBER_OF("gap", "play to either side", WHIRL_QUANTITY_LENGTH, "gap", 1.0),
    END_OF_COLUMNS,
};

/// A family of parts, which share a sheet: parts of certain roles whose elements have a certain key.
typedef struct part_family {
    const char *name, *title;
    const char *key; ///< key of its elements
    unsigned roles;  ///< bits of the roles
    bool between;    ///< includes elements between two stations, except links between places of shafts
    const part_column *columns;
} part_family;

#define ANY_ROLE (~0U)

static const part_family families[] = {
    {"journal_bearings", "Journal bearings and squeeze films", "viscosity", ~(1U << WHIRL_ROLE_DRAG), false,
     film_columns},
    {"rolling_bearings", "Rolling bearings", "cage", ANY_ROLE, false, rolling_columns},
    {"magnetic_bearings", "Magnetic bearings", "bias", ANY_ROLE, false, magnet_columns},
    {"seals", "Seals", "clearance", 1U << WHIRL_ROLE_DRAG, false, seal_columns},
    {"linear_bearings", "Bearings and seals by their coefficients", "kxx", ANY_ROLE, false, coefficient_columns},
    {"supports", "Springs and mounts of supports", "damping", 1U << WHIRL_ROLE_SUPPORT | 1U << WHIRL_ROLE_LINK, true,
     support_columns},
};
enum { FAMILIES = sizeof families / sizeof *families };

static bool on_shaft(const whirl_model *model, size_t station) {
    return station < model->station_count && model->stations[station].shaft != WHIRL_MODEL_NONE;
}

static const part_family *family_of(const whirl_model *model, const whirl_model_element *element) {
    for (const part_family *own = families; own < families + FAMILIES; own++) {
        if (!(own->roles >> element->role & 1U) || !whirl_model_value_of(element, own->key)) continue;
        const bool joins = model->shaft_count == 0 || (on_shaft(model, element->station[0]) && //
                                                       on_shaft(model, element->station[1]));
        return own->between && joins && element->role == WHIRL_ROLE_LINK ? NULL : own;
    }
    return NULL;
}

// ---------------------------------------------------------------- sheets

static void family_columns(const finder *of, whirl_sheet *sheet, const part_family *family) {
    sheet_texts(of, sheet, "station", "station");
    for (const part_column *own = family->columns; own->name; own++) {
        const whirl_unit unit = {.size = 1.0};
        if (own->text) {
            sheet_texts(of, sheet, own->name, own->heading);
        } else if (own->between) {
            sheet_list(of, sheet, own->name, own->heading, own->quantity, 6, own->between);
        } else if (own->unit) {
            whirl_unit named = unit;
            snprintf(named.name, sizeof named.name, "%s", own->unit);
            sheet_units(of, sheet, own->name, own->heading, &named, 6);
        } else {
            sheet_column(of, sheet, own->name, own->heading, own->quantity, 6);
        }
    }
}

static void family_row(const machine_part *part, whirl_sheet *sheet, const part_family *family) {
    const finder *of = part->of;
    sheet_row(of, sheet);
    cell_station(of, sheet, part_station(part->element, true));
    for (const part_column *own = family->columns; own->name; own++) {
        double numbers[WHIRL_MAX_PADS];
        if (own->text) {
            cell_text(of, sheet, own->text(part));
        } else if (own->list) {
            cell_numbers(of, sheet, own->list(part, own->key, numbers), numbers);
        } else {
            const double number = own->number ? own->number(part, own->key) : part_number(part, own->key);
            cell_number(of, sheet, (own->factor != 0.0 ? own->factor : 1.0) * number);
        }
    }
}

/// States the stations of bearings whose geometry or oil the case does not give, and the missing data.
static void find_unknown(const finder *of, const whirl_model *model) {
    char given[WHIRL_MESSAGE_SIZE] = "", by_force[WHIRL_MESSAGE_SIZE] = "";
    for (size_t i = 0; i < model->element_count; i++) {
        const machine_part part = {of, model, &model->elements[i]};
        if (part.element->role != WHIRL_ROLE_BEARING || part.element->station[0] >= of->result->station_count) continue;
        const bool linear = whirl_model_value_of(part.element, "kxx") != NULL;
        if (!linear && !part_given(&part, "load")) continue;
        char *list = linear ? given : by_force;
        const size_t used = strlen(list);
        snprintf(list + used, WHIRL_MESSAGE_SIZE - used, "%s%.60s", used ? ", " : "",
                 of->result->stations[part.element->station[0]].name);
    }
    if (*given)
        phrase_text(of, &find_statement(of, "bearings")->found,
                    "%s: the case gives coefficients; diameter, length, clearance, oil and place of rest are not known",
                    given);
    if (*by_force)
        phrase_text(of, &find_statement(of, "bearings")->found,
                    "%s: the case gives the force scale of the film; diameter, length and oil are not known", by_force);
}

void find_bearings(const finder *of, const whirl_model *model) {
    find_unknown(of, model);
    for (const part_family *family = families; family < families + FAMILIES; family++) {
        whirl_sheet *sheet = find_sheet(of, family->name, family->title);
        sheet->about = "At the parameters of the case; its conditions and sweeps may have others.";
        family_columns(of, sheet, family);
        for (size_t i = 0; i < model->element_count; i++) {
            const machine_part part = {of, model, &model->elements[i]};
            const size_t station = part_station(part.element, true);
            if (station < of->result->station_count && family_of(model, part.element) == family)
                family_row(&part, sheet, family);
        }
        find_sheet_end(of);
    }
}
