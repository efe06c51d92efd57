// Couplings of ROSS: springs and dampers between a node and the next one, and the masses of both ends.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "page.h"
#include "ross.h"

enum { LEFT, RIGHT, ENDS };

// ---------------------------------------------------------------- reading

/// Names both ends: those of "Coupling 0" are "Coupling 0 left" and "Coupling 0 right".
static void name_ends(field_section *section, ross_coupling *out) {
    static const char *const sides[ENDS] = {" left", " right"};
    for (int end = LEFT; end < ENDS; end++) {
        const size_t size = strlen(out->tag) + strlen(sides[end]) + 1;
        char *const text = field_memory(section->reader, size);
        if (text) snprintf(text, size, "%s%s", out->tag, sides[end]);
        out->end_tag[end] = text;
    }
}

/// Reads the masses of the ends. A diametral inertia of 0 means half the polar one, as in ROSS.
static void read_ends(field_section *section, ross_coupling *out) {
    static const char *const masses[ENDS] = {"m_l", "m_r"}, *const polars[ENDS] = {"Ip_l", "Ip_r"},
                             *const diametrals[ENDS] = {"Id_l", "Id_r"};
    for (int end = LEFT; end < ENDS; end++) {
        const field_kind mass = {masses[end], "kg", WHIRL_NOT_NEGATIVE},
                         polar = {polars[end], "kg m2", WHIRL_NOT_NEGATIVE},
                         diametral = {diametrals[end], "kg m2", WHIRL_NOT_NEGATIVE};
        out->mass[end] = field_number(section, &mass, NAN);
        out->polar[end] = field_number(section, &polar, NAN);
        out->diametral[end] = field_number(section, &diametral, 0.0);
        if (out->diametral[end] == 0.0) out->diametral[end] = 0.5 * out->polar[end];
    }
}

/// Reads a tilt coefficient, which must be the same in both planes.
static double read_tilt(field_section *section, const char *const keys[2], const char *unit) {
    double along[2];
    for (int axis = 0; axis < 2; axis++) {
        const field_kind kind = {keys[axis], unit, WHIRL_NOT_NEGATIVE};
        along[axis] = field_number(section, &kind, 0.0);
    }
    if (along[0] != along[1])
        field_refuse(section, keys[1], value_member(section->table, keys[1]),
                     "is %.10g %s and %s is %.10g, expected equal numbers: a coupling here resists tilts "
                     "alike in both planes",
                     along[1], unit, keys[0], along[0]);
    return along[0];
}

/// Returns true if the file has axial or torsional coefficients.
static bool has_axial(field_section *section) {
    static const field_kind kinds[] = {{"kt_z", "N/m", WHIRL_ANY},
                                       {"kr_z", "N m/rad", WHIRL_ANY},
                                       {"ct_z", "N s/m", WHIRL_ANY},
                                       {"cr_z", "N m s/rad", WHIRL_ANY}};
    bool found = false;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        found = field_number(section, &kinds[i], 0.0) != 0.0 || found;
    return found;
}

static bool joins(const ross_coupling *coupling) {
    double sum = coupling->tilt + coupling->tilt_damping;
    for (int axis = 0; axis < 2; axis++) sum += coupling->stiffness[axis] + coupling->damping[axis];
    return sum > 0.0;
}

void ross_read_coupling(field_section *section, const char *tag, ross_coupling *out) {
    static const char *const stiff[] = {"kt_x", "kt_y"}, *const damped[] = {"ct_x", "ct_y"};
    static const char *const tilt[] = {"kr_x", "kr_y"}, *const tilt_damping[] = {"cr_x", "cr_y"};
    note_list *const notes = &section->reader->notes;
    *out = (ross_coupling){.tag = tag, .section = *section};
    out->node = field_whole(section, "n", -2);
    name_ends(section, out);
    read_ends(section, out);
    for (int axis = 0; axis < 2; axis++) {
        const field_kind stiffness = {stiff[axis], "N/m", WHIRL_NOT_NEGATIVE},
                         damping = {damped[axis], "N s/m", WHIRL_NOT_NEGATIVE};
        out->stiffness[axis] = field_number(section, &stiffness, 0.0);
        out->damping[axis] = field_number(section, &damping, 0.0);
    }
    out->tilt = read_tilt(section, tilt, "N m/rad");
    out->tilt_damping = read_tilt(section, tilt_damping, "N m s/rad");
    if (has_axial(section)) note_of(notes, NOTE_COUPLING_AXIAL, tag);
    const bool long_one = value_member(section->table, "L"), thick = value_member(section->table, "o_d");
    if (long_one || thick) note_of(notes, NOTE_COUPLING_LENGTH, tag);
    if (field_good(section->reader) && !joins(out)) note_of(notes, NOTE_COUPLING_LOOSE, tag);
    ross_note_rest(section, tag, false);
}

// ---------------------------------------------------------------- writing

/// Writes the coefficients that are equal along x and y, and the tilts.
static void put_round(FILE *out, const ross_coupling *coupling, const char *const ends[2], bool equal) {
    page_line line = page_open(out, 17, "    - coupling: {");
    page_item(&line, "between: [%s, %s]", ends[0], ends[1]);
    page_number(&line, "radial", equal ? coupling->stiffness[0] : 0.0, "N/m");
    if (coupling->tilt > 0.0) page_number(&line, "tilt", coupling->tilt, "N m/rad");
    if (equal && coupling->damping[0] > 0.0) page_number(&line, "radial_damping", coupling->damping[0], "N s/m");
    if (coupling->tilt_damping > 0.0) page_number(&line, "tilt_damping", coupling->tilt_damping, "N m s/rad");
    page_close(&line, "}", NULL);
}

/// Writes the coefficients that differ along x and y.
static void put_unequal(FILE *out, const ross_coupling *coupling, const char *const ends[2]) {
    static const char *const stiffness[] = {"kxx", "kyy"}, *const damping[] = {"cxx", "cyy"};
    page_line line = page_open(out, 16, "    - bearing: {");
    page_item(&line, "at: %s", ends[1]);
    page_item(&line, "from: %s", ends[0]);
    page_item(&line, "role: other");
    for (int axis = 0; axis < 2; axis++) page_number(&line, stiffness[axis], coupling->stiffness[axis], "N/m");
    for (int axis = 0; axis < 2 && coupling->damping[0] + coupling->damping[1] > 0.0; axis++)
        page_number(&line, damping[axis], coupling->damping[axis], "N s/m");
    page_close(&line, "}", NULL);
}

void ross_put_coupling(FILE *out, const ross_rotor *rotor, const ross_coupling *coupling) {
    const char *const ends[] = {ross_station_at(rotor, coupling->node)->name,
                                ross_station_at(rotor, coupling->node + 1)->name};
    const bool equal = coupling->stiffness[0] == coupling->stiffness[1] && coupling->damping[0] == coupling->damping[1];
    const bool tilts = coupling->tilt > 0.0 || coupling->tilt_damping > 0.0;
    char comment[160];
    if (!joins(coupling)) return;
    snprintf(comment, sizeof comment, "%.60s, nodes %ld and %ld", coupling->tag, coupling->node, coupling->node + 1);
    whirl_make_plain(comment);
    page_comment(out, "    # ", "    # ", comment);
    if (equal || tilts) put_round(out, coupling, ends, equal);
    if (!equal) put_unequal(out, coupling, ends);
}
