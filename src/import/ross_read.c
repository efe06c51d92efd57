// Reads the sections of a ROSS file, each by the function of its class.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ross.h"
#include "whirl/engine/rotor.h"

// ---------------------------------------------------------------- the shaft

static bool same_material(const ross_material *one, const ross_material *other) {
    return strcmp(one->name, other->name) == 0 && one->density == other->density && one->modulus == other->modulus &&
           one->shear == other->shear;
}

/// Reads the shear modulus, or computes it from E and Poisson's ratio.
static double read_shear(field_section *section, double modulus) {
    const field_kind shear = {"G_s", "Pa", WHIRL_POSITIVE}, poisson = {"Poisson", "1", WHIRL_FROM_TO(-0.99, 0.5)};
    if (!value_member(section->table, "G_s") && value_member(section->table, "Poisson"))
        return 0.5 * modulus / (1.0 + field_number(section, &poisson, NAN));
    (void)value_member(section->table, "Poisson"); // it follows from E and G_s
    const double found = field_number(section, &shear, NAN);
    if (field_good(section->reader) && !(found >= modulus / 3.0))
        field_refuse(section, "G_s", value_member(section->table, "G_s"),
                     "is %.10g Pa, expected a third of E at least, %.10g Pa: Poisson's ratio is 0.5 at most", found,
                     modulus / 3.0);
    return found;
}

/// Reads a piece's material and returns its index; equal materials share one.
static size_t read_material(field_section *piece, ross_rotor *out) {
    static const char expected[] = "a table with name, rho, E and G_s";
    value *const table = value_member(piece->table, "material");
    char shown[VALUE_SHOWN_SIZE];
    if (!table) field_refuse(piece, "material", NULL, "is missing, expected %s", expected);
    if (table && table->kind != VALUE_TABLE)
        field_refuse(piece, "material", table, "is %s, expected %s", value_shown(table, shown), expected);
    char *const name = field_memory(piece->reader, strlen(piece->name) + sizeof ".material");
    if (!name || !table) return 0;
    strcat(strcpy(name, piece->name), ".material");
    // Read it as the next material.
    field_section section = {piece->reader, name, table};
    const field_kind density = {"rho", "kg/m3", WHIRL_POSITIVE}, modulus = {"E", "Pa", WHIRL_POSITIVE};
    ross_material *const one = &out->materials[out->material_count];
    one->name = field_text(&section, "name", "material");
    one->density = field_number(&section, &density, NAN);
    one->modulus = field_number(&section, &modulus, NAN);
    one->shear = read_shear(&section, one->modulus);
    // Mark keys as read that only drawings and ROSS's bearings use.
    static const char *const others[] = {"color", "specific_heat", "thermal_conductivity"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) (void)value_member(table, others[i]);
    ross_note_rest(&section, name, false);
    if (!field_good(piece->reader)) return 0;
    // Keep it if no earlier one is equal.
    size_t i = 0;
    while (!same_material(&out->materials[i], one)) i++;
    if (i == out->material_count) out->material_count++;
    return i;
}

static void read_diameters(field_section *section, ross_piece *out) {
    static const char *const inner[] = {"idl", "idr"}, *const outer[] = {"odl", "odr"};
    for (int end = 0; end < 2; end++) {
        const field_kind from = {inner[end], "m", WHIRL_NOT_NEGATIVE}, to = {outer[end], "m", WHIRL_POSITIVE};
        out->inner[end] = field_number(section, &from, end ? out->inner[0] : NAN);
        out->outer[end] = field_number(section, &to, end ? out->outer[0] : NAN);
        if (field_good(section->reader) && out->inner[end] >= out->outer[end])
            field_refuse(section, inner[end], value_member(section->table, inner[end]),
                         "is %.10g m, expected less than %s, %.10g m", out->inner[end], outer[end], out->outer[end]);
    }
}

static bool read_method(field_section *section) {
    const char *const method = field_text(section, "shear_method_calc", "cowper");
    const bool hutchinson = strcmp(method, "hutchinson") == 0;
    if (!hutchinson && strcmp(method, "cowper") != 0)
        field_refuse(section, "shear_method_calc", value_member(section->table, "shear_method_calc"),
                     "is \"%.40s\", expected \"cowper\" or \"hutchinson\"", method);
    return hutchinson;
}

/// Notes where ROSS computes a different shaft from the same numbers.
static void note_differences(note_list *notes, const ross_piece *piece) {
    const bool conical = piece->inner[0] != piece->inner[1] || piece->outer[0] != piece->outer[1];
    if (piece->axial_force != 0.0 && piece->stiffness_damping != 0.0) note_of(notes, NOTE_AXIAL_DAMPING, piece->tag);
    if (piece->shear && piece->hutchinson) note_of(notes, NOTE_HUTCHINSON, piece->tag);
    if (!piece->rotary_inertia && piece->gyroscopic) note_of(notes, NOTE_ROTARY, piece->tag);
    if (conical) note_of(notes, NOTE_CONE, piece->tag);
}

static void read_piece(field_section *section, const char *tag, ross_rotor *out) {
    const field_kind length = {"L", "m", WHIRL_POSITIVE}, torque = {"torque", "N m", WHIRL_ANY},
                     force = {"axial_force", "N", WHIRL_ANY}, alpha = {"alpha", "1/s", WHIRL_NOT_NEGATIVE},
                     beta = {"beta", "s", WHIRL_NOT_NEGATIVE};
    ross_piece *const piece = &out->pieces[out->piece_count++];
    *piece = (ross_piece){.tag = tag, .section = *section};
    // Read the geometry.
    piece->node = field_whole(section, "n", -2);
    piece->length = field_number(section, &length, NAN);
    read_diameters(section, piece);
    // Read load, model and damping.
    piece->axial_force = field_number(section, &force, 0.0);
    piece->shear = field_truth(section, "shear_effects", true);
    piece->rotary_inertia = field_truth(section, "rotary_inertia", true);
    piece->gyroscopic = field_truth(section, "gyroscopic", true);
    piece->hutchinson = read_method(section);
    piece->mass_damping = field_number(section, &alpha, 0.0);
    piece->stiffness_damping = field_number(section, &beta, 0.0);
    if (field_number(section, &torque, 0.0) != 0.0)
        field_refuse(
            section, "torque", value_member(section->table, "torque"),
            "is not 0, expected a shaft without torque: it couples bending in a way that is not modelled here");
    // Note where this model differs.
    note_differences(&section->reader->notes, piece);
    piece->material = read_material(section, out);
    ross_note_rest(section, tag, false);
}

// ---------------------------------------------------------------- parts on the shaft

static void read_disc(field_section *section, const char *tag, ross_rotor *out) {
    const field_kind mass = {"m", "kg", WHIRL_NOT_NEGATIVE}, diametral = {"Id", "kg m2", WHIRL_NOT_NEGATIVE},
                     polar = {"Ip", "kg m2", WHIRL_NOT_NEGATIVE};
    ross_disc *const disc = &out->discs[out->disc_count++];
    *disc = (ross_disc){.tag = tag, .section = *section};
    disc->node = field_whole(section, "n", -2);
    disc->mass = field_number(section, &mass, NAN);
    disc->diametral = field_number(section, &diametral, NAN);
    disc->polar = field_number(section, &polar, NAN);
    ross_note_rest(section, tag, false);
}

/// Reads a point mass; `m` counts only without mx, my and mz.
static void read_point(field_section *section, const char *tag, ross_rotor *out) {
    static const char *const along[] = {"mx", "my"};
    ross_point *const point = &out->points[out->point_count++];
    *point = (ross_point){.tag = tag, .section = *section};
    point->node = field_whole(section, "n", -2);
    const field_kind whole = {"m", "kg", WHIRL_NOT_NEGATIVE}, axial = {"mz", "kg", WHIRL_NOT_NEGATIVE};
    const bool split =
        value_member(section->table, "mx") || value_member(section->table, "my") || value_member(section->table, "mz");
    const double mass = field_number(section, &whole, split ? 0.0 : NAN);
    for (int axis = 0; axis < 2; axis++) {
        const field_kind kind = {along[axis], "kg", WHIRL_NOT_NEGATIVE};
        point->mass[axis] = field_number(section, &kind, split ? NAN : mass);
    }
    const double mz = field_number(section, &axial, point->mass[0]);
    if (mz != point->mass[0] && mz != point->mass[1] && mz != 0.0)
        note_of(&section->reader->notes, NOTE_AXIAL_MASS, tag);
    ross_note_rest(section, tag, false);
}

static void read_bearing(field_section *section, const char *tag, ross_rotor *out) {
    ross_bearing *const bearing = &out->bearings[out->bearing_count];
    if (ross_read_magnetic(section, tag, bearing)) {
        out->bearing_count++;
        return;
    }
    ross_read_bearing(section, tag, out->version, bearing);
    bool acts = false;
    for (int which = KXX; which < COEFFICIENTS; which++) acts = acts || ross_acts(bearing, (ross_coefficient)which);
    out->bearing_count += acts;
    if (!acts && field_good(section->reader)) note_of(&section->reader->notes, NOTE_NOTHING_LATERAL, tag);
}

static void read_seal(field_section *section, const char *tag, ross_rotor *out) {
    const size_t before = out->bearing_count;
    read_bearing(section, tag, out);
    for (size_t i = before; i < out->bearing_count; i++) out->bearings[i].seal = true;
}

static void read_coupling(field_section *section, const char *tag, ross_rotor *out) {
    ross_read_coupling(section, tag, &out->couplings[out->coupling_count++]);
}

// ---------------------------------------------------------------- sections

typedef void read_section(field_section *section, const char *tag, ross_rotor *out);

typedef struct ross_class {
    const char *name;
    read_section *read;  ///< NULL: not taken over
    const char *instead; ///< why not
} ross_class;

static const ross_class classes[] = {
    {"ShaftElement", read_piece, NULL},
    {"DiskElement", read_disc, NULL},
    {"BearingElement", read_bearing, NULL},
    {"SealElement", read_seal, NULL},
    {"PointMass", read_point, NULL},
    {"MagneticBearingElement", read_bearing, NULL},
    {"CouplingElement", read_coupling, NULL},
    {"GearElement", NULL, "gears couple shafts and twist, which is not taken over"},
    {"GearElementTVMS", NULL, "gears couple shafts and twist, which is not taken over"},
};
enum { CLASSES = sizeof classes / sizeof *classes };

/// Finds the class by the first `length` letters of a section's name: ShaftElement for "ShaftElement_Shaft Element 0",
/// and for "ShaftElement6DoF_..." of older files.
static const ross_class *find_class(const char *name, size_t length) {
    static const char old[] = "6DoF";
    if (length > 4 && strncmp(name + length - 4, old, 4) == 0) length -= 4;
    for (size_t i = 0; i < CLASSES; i++)
        if (strlen(classes[i].name) == length && strncmp(name, classes[i].name, length) == 0) return &classes[i];
    return NULL;
}

/// Reads a section of an unknown class as a bearing if it has coefficients.
static void read_unknown(field_section *section, size_t length, const char *tag, ross_rotor *out) {
    const char *names[CLASSES];
    char word[64];
    if (section->table->kind == VALUE_TABLE && value_member(section->table, "kxx")) {
        read_bearing(section, tag, out);
        return;
    }
    for (size_t i = 0; i < CLASSES; i++) names[i] = classes[i].name;
    snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : sizeof word - 1), section->name);
    const char *const nearest = whirl_nearest_name(word, names, CLASSES);
    field_refuse(section, NULL, section->table,
                 nearest ? "is a %s, expected %s_..."
                         : "is a %s, expected ShaftElement, DiskElement, BearingElement, SealElement, PointMass, "
                           "CouplingElement, or a class with coefficients (kxx)",
                 word, nearest);
}

static void read_element(import_reader *reader, value *table, ross_rotor *out) {
    const char *const mark = strchr(table->key, '_');
    const size_t length = mark ? (size_t)(mark - table->key) : strlen(table->key);
    field_section section = {reader, table->key, table};
    const ross_class *const class = find_class(table->key, length);
    char shown[VALUE_SHOWN_SIZE];
    if (table->kind != VALUE_TABLE) {
        field_refuse(&section, NULL, table, "is %s, expected a section of a rotor saved by ROSS",
                     value_shown(table, shown));
        return;
    }
    const char *const tag = field_text(&section, "tag", mark ? mark + 1 : table->key);
    if (!class)
        read_unknown(&section, length, tag, out);
    else if (class->read)
        class->read(&section, tag, out);
    else
        field_refuse(&section, NULL, table, "%s", class->instead);
}

/// Reads the speeds for which the rotor is made.
static void read_parameters(import_reader *reader, value *root, ross_rotor *out) {
    value *const table = value_member(root, "parameters");
    out->least = out->most = out->rated = NAN;
    if (!table || table->kind != VALUE_TABLE) return;
    field_section section = {reader, "parameters", table};
    static const char *const keys[] = {"min_w", "max_w", "rated_w"};
    double *const places[] = {&out->least, &out->most, &out->rated};
    for (int i = 0; i < 3; i++) {
        const field_kind kind = {keys[i], "rad/s", WHIRL_NOT_NEGATIVE};
        if (value_member(table, keys[i])) *places[i] = field_number(&section, &kind, NAN);
    }
    if (out->least > out->most)
        field_refuse(&section, "min_w", value_member(table, "min_w"),
                     "is %.10g rad/s, expected at most max_w, %.10g rad/s", out->least, out->most);
    ross_note_rest(&section, "parameters", false);
}

static bool is_element(const value *one) {
    return one->key[0] != '_' && strcmp(one->key, "parameters") != 0 && strcmp(one->key, "ross_version") != 0;
}

/// Allocates for each kind of element as many as the file has sections.
static bool ross_make_room(import_reader *reader, const value *root, ross_rotor *out) {
    size_t count = 1;
    for (const value *one = root->first; one; one = one->next) count += is_element(one);
    if (count > WHIRL_MAX_ELEMENTS) {
        reader->status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: has %zu sections, expected at most %d elements",
                                    reader->file, count - 1, WHIRL_MAX_ELEMENTS - 1);
        return false;
    }
    out->materials = field_memory(reader, (count + 1) * sizeof *out->materials);
    out->pieces = field_memory(reader, count * sizeof *out->pieces);
    out->discs = field_memory(reader, count * sizeof *out->discs);
    out->points = field_memory(reader, count * sizeof *out->points);
    out->bearings = field_memory(reader, count * sizeof *out->bearings);
    out->couplings = field_memory(reader, count * sizeof *out->couplings);
    return field_good(reader);
}

void ross_read(import_reader *reader, value *root, ross_rotor *out) {
    *out = (ross_rotor){.version = ""};
    if (root->kind != VALUE_TABLE || !ross_make_room(reader, root, out)) {
        if (field_good(reader))
            reader->status =
                whirl_fail(WHIRL_BAD_INPUT, "%.200s: has no sections, expected a rotor saved by ROSS", reader->file);
        return;
    }
    const value *const version = value_member(root, "ross_version");
    if (version && version->kind == VALUE_TEXT) out->version = version->text;
    read_parameters(reader, root, out);
    for (value *one = root->first; one && field_good(reader); one = one->next)
        if (is_element(one)) read_element(reader, one, out);
    if (field_good(reader) && out->piece_count == 0)
        reader->status = whirl_fail(WHIRL_BAD_INPUT,
                                    "%.200s: has no section [ShaftElement_...], expected a rotor that "
                                    "ROSS has saved (Rotor.save)",
                                    reader->file);
}
