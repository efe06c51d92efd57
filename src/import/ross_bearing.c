// Bearings and seals of ROSS: coefficients, constant or over the speed.
#include "ross.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const ross_coefficient_names[COEFFICIENTS] = {"kxx", "kxy", "kyx", "kyy", "cxx", "cxy",
                                                          "cyx", "cyy", "mxx", "mxy", "myx", "myy"};
const char *const ross_coefficient_units[COEFFICIENTS] = {"N/m",   "N/m",   "N/m", "N/m", "N s/m", "N s/m",
                                                          "N s/m", "N s/m", "kg",  "kg",  "kg",    "kg"};

static const double nothing[1] = {0.0};

/// Speeds that rise; one alone is none, for then all is constant. From ROSS 3 on they are called speed, and frequency
/// is that of an excitation, on which nothing may depend.
static void read_speeds(field_section *section, const char *version, ross_bearing *out) {
    const bool named = value_member(section->table, "speed"), old = value_member(section->table, "frequency");
    const bool new = strtol(version, NULL, 10) >= 3 || (named && !old);
    out->axis = new ? "speed" : "frequency";
    const field_kind kind = {out->axis, "rad/s", WHIRL_NOT_NEGATIVE};
    out->speeds = field_numbers(section, &kind, &out->speed_count);
    for (size_t i = 1; i < out->speed_count && field_good(section->reader); i++)
        if (!(out->speeds[i - 1] < out->speeds[i]))
            field_refuse(section, kind.key, value_member(section->table, kind.key),
                         "goes from %.10g to %.10g rad/s, expected speeds that rise", out->speeds[i - 1],
                         out->speeds[i]);
}

/// A list of numbers that are all the same says no more than one of them.
static bool is_constant(const double *numbers, size_t count) {
    for (size_t i = 1; i < count; i++)
        if (numbers[i] != numbers[0]) return false;
    return true;
}

static void read_coefficient(field_section *section, ross_coefficient which, ross_bearing *out) {
    const field_kind kind = {ross_coefficient_names[which], ross_coefficient_units[which], WHIRL_ANY};
    size_t count;
    double *const numbers = field_numbers(section, &kind, &count);
    out->values[which] = numbers ? numbers : nothing;
    if (!numbers || !field_good(section->reader)) return;
    const bool excited = !value_member(section->table, "speed") && strcmp(out->axis, "speed") == 0 &&
                         value_member(section->table, "frequency");
    if (excited && !is_constant(numbers, count))
        field_refuse(section, kind.key, value_member(section->table, kind.key),
                     "depends on frequency, which is that of an excitation from ROSS 3 on, expected coefficients over "
                     "speed");
    else if (!excited && count > 1 && count != out->speed_count)
        field_refuse(section, kind.key, value_member(section->table, kind.key),
                     "has %zu numbers, expected one, or as many as %s has: %zu", count, out->axis, out->speed_count);
    out->varies[which] = !is_constant(numbers, count);
}

/// Where the file leaves out what acts along y, it is as along x.
static void as_along_x(field_section *section, ross_coefficient y, ross_coefficient x, ross_bearing *out) {
    if (value_member(section->table, ross_coefficient_names[y])) return;
    out->values[y] = out->values[x];
    out->varies[y] = out->varies[x];
}

bool ross_acts(const ross_bearing *bearing, ross_coefficient which) {
    return bearing->varies[which] || bearing->values[which][0] != 0.0;
}

/// What is lost: "Seal 1, 0.5 kg".
static void note_skew_mass(field_section *section, const char *tag, double lost) {
    const size_t size = strlen(tag) + 32;
    char *const text = field_memory(section->reader, size);
    if (!text) return;
    snprintf(text, size, "%s, %.6g kg", tag, lost);
    note_of(&section->reader->notes, NOTE_SKEW_MASS, text);
}

/// Inertia is symmetric, as the mass matrix of whirl's bearings is by construction: of unequal cross terms the mean is
/// taken.
static void make_symmetric(field_section *section, const char *tag, ross_bearing *out) {
    const bool varies = out->varies[MXY] || out->varies[MYX];
    const size_t count = varies ? out->speed_count : 1;
    double lost = 0.0;
    double *const mean = field_memory(section->reader, count * sizeof *mean);
    for (size_t i = 0; mean && i < count; i++) {
        const double one = out->values[MXY][out->varies[MXY] ? i : 0],
                     other = out->values[MYX][out->varies[MYX] ? i : 0];
        mean[i] = 0.5 * (one + other);
        lost = fmax(lost, fabs(0.5 * (one - other)));
    }
    if (!mean || lost == 0.0) return;
    note_skew_mass(section, tag, lost);
    out->values[MXY] = out->values[MYX] = mean;
    out->varies[MXY] = out->varies[MYX] = !is_constant(mean, count);
}

/// As many speeds as a case may list.
static void thin(field_section *section, const char *tag, ross_bearing *out) {
    const size_t most = WHIRL_MAX_LIST, count = out->speed_count;
    if (count <= most) return;
    note_of(&section->reader->notes, NOTE_THINNED, tag);
    const double **const lists[COEFFICIENTS + 1] = {
        &out->speeds,      &out->values[KXX], &out->values[KXY], &out->values[KYX], &out->values[KYY],
        &out->values[CXX], &out->values[CXY], &out->values[CYX], &out->values[CYY], &out->values[MXX],
        &out->values[MXY], &out->values[MYX], &out->values[MYY]};
    for (size_t list = 0; list <= COEFFICIENTS; list++) {
        double *const kept = field_memory(section->reader, most * sizeof *kept);
        if (!kept) return;
        if (list > 0 && !out->varies[list - 1]) continue;
        for (size_t i = 0; i < most; i++) kept[i] = (*lists[list])[(i * (count - 1) + (most - 1) / 2) / (most - 1)];
        *lists[list] = kept;
    }
    out->speed_count = most;
}

/// What acts along the shaft.
static void note_axial(field_section *section, const char *tag) {
    static const char *const keys[] = {"kzz", "czz", "mzz"};
    bool found = false;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const field_kind kind = {keys[i], "SI", WHIRL_ANY};
        size_t count;
        const double *const numbers = field_numbers(section, &kind, &count);
        for (size_t j = 0; j < count; j++) found = found || numbers[j] != 0.0;
    }
    if (found) note_of(&section->reader->notes, NOTE_AXIAL, tag);
}

void ross_read_bearing(field_section *section, const char *tag, const char *version, ross_bearing *out) {
    import_reader *const reader = section->reader;
    *out = (ross_bearing){.tag = tag, .section = *section};
    out->node = field_whole(section, "n", -2);
    out->link = field_whole(section, "n_link", -1);
    read_speeds(section, version, out);
    for (int which = KXX; which < COEFFICIENTS; which++) read_coefficient(section, (ross_coefficient)which, out);
    if (!field_good(reader)) return;
    if (!value_member(section->table, "kxx")) field_refuse(section, "kxx", NULL, "is missing, expected numbers in N/m");
    as_along_x(section, KYY, KXX, out);
    as_along_x(section, CYY, CXX, out);
    as_along_x(section, MYY, MXX, out);
    make_symmetric(section, tag, out);
    bool varies = false;
    for (int which = KXX; which < COEFFICIENTS; which++) varies = varies || out->varies[which];
    if (!varies) out->speed_count = 0;
    thin(section, tag, out);
    note_axial(section, tag);
    if (value_member(section->table, "seal_leakage")) note_of(&reader->notes, NOTE_LEAKAGE, tag);
    ross_note_rest(section, tag, true);
}
