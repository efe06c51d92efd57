// Bearings and seals of ROSS: coefficients, constant or over the speed and the frequency of whirl.
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

/// Reads the numbers of an axis, which have to rise.
static const double *read_axis(field_section *section, const char *key, const char *what, size_t *count) {
    const field_kind kind = {key, "rad/s", WHIRL_NOT_NEGATIVE};
    const double *const numbers = field_numbers(section, &kind, count);
    for (size_t i = 1; i < *count && field_good(section->reader); i++)
        if (!(numbers[i - 1] < numbers[i]))
            field_refuse(section, key, value_member(section->table, key),
                         "goes from %.10g to %.10g rad/s, expected %s that rise", numbers[i - 1], numbers[i], what);
    return numbers;
}

/// Reads the axes of tables. From ROSS 3 on `speed` has the speeds and `frequency` the frequencies of whirl. Before,
/// `frequency` has the speeds, except for magnetic bearings.
static void read_axes(field_section *section, const char *version, ross_bearing *out) {
    const bool named = value_member(section->table, "speed"), old = value_member(section->table, "frequency");
    const bool new = strtol(version, NULL, 10) >= 3 || (named && !old) || ross_is_magnet(section);
    out->axis = new ? "speed" : "frequency";
    out->speeds = read_axis(section, out->axis, "speeds", &out->speed_count);
    if (new) out->frequencies = read_axis(section, "frequency", "frequencies", &out->frequency_count);
}

/// Returns true if all numbers are equal: one of them suffices then.
static bool is_constant(const double *numbers, size_t count) {
    for (size_t i = 1; i < count; i++)
        if (numbers[i] != numbers[0]) return false;
    return true;
}

static size_t at_least_one(size_t count) {
    return count > 0 ? count : 1;
}

/// Returns true if a table fits the axes: it is one number, a list along the only axis or along the speeds, or a row of
/// frequencies for each speed.
static bool fits(field_section *section, const char *key, size_t rows, size_t columns, const ross_bearing *out) {
    const value *at = value_member(section->table, key);
    const bool whirls = out->speed_count == 0 && out->frequency_count > 0; // a list is along the frequencies
    const size_t along = whirls ? out->frequency_count : out->speed_count;
    if (columns > 1 && columns != out->frequency_count)
        field_refuse(section, key, at, "has rows of %zu numbers, expected as many as frequency has: %zu", columns,
                     out->frequency_count);
    else if (columns > 1 && rows != at_least_one(out->speed_count))
        field_refuse(section, key, at, "has %zu rows, expected as many as speed has: %zu", rows, out->speed_count);
    else if (columns == 1 && rows > 1 && rows != along)
        field_refuse(section, key, at, "has %zu numbers, expected one, or as many as %s has: %zu", rows,
                     whirls ? "frequency" : out->axis, along);
    return field_good(section->reader);
}

/// Reads a coefficient: one number, or one for every speed and frequency.
static void read_coefficient(field_section *section, ross_coefficient which, ross_bearing *out) {
    const field_kind kind = {ross_coefficient_names[which], ross_coefficient_units[which], WHIRL_ANY};
    const size_t speeds = at_least_one(out->speed_count), frequencies = at_least_one(out->frequency_count);
    size_t rows, columns = 1;
    const double *const numbers = field_table(section, &kind, &rows, &columns);
    out->values[which] = nothing;
    if (!numbers || !fits(section, kind.key, rows, columns, out)) return;
    double *const all = field_memory(section->reader, speeds * frequencies * sizeof *all);
    const bool whirls = columns > 1 || out->speed_count == 0;
    for (size_t i = 0; i < speeds * frequencies && all; i++)
        all[i] = numbers[rows * columns == 1 ? 0 : columns > 1 ? i : whirls ? i % frequencies : i / frequencies];
    if (!all) return;
    out->values[which] = all;
    out->varies[which] = !is_constant(all, speeds * frequencies);
}

/// Copies the coefficient along x if the file has none along y.
static void as_along_x(field_section *section, ross_coefficient y, ross_coefficient x, ross_bearing *out) {
    if (value_member(section->table, ross_coefficient_names[y])) return;
    out->values[y] = out->values[x];
    out->varies[y] = out->varies[x];
}

bool ross_acts(const ross_bearing *bearing, ross_coefficient which) {
    return bearing->varies[which] || bearing->values[which][0] != 0.0;
}

/// Notes a lost cross-coupled mass: "Seal 1, 0.5 kg".
static void note_skew_mass(field_section *section, const char *tag, double lost) {
    const size_t size = strlen(tag) + 32;
    char *const text = field_memory(section->reader, size);
    if (!text) return;
    snprintf(text, size, "%s, %.6g kg", tag, lost);
    note_of(&section->reader->notes, NOTE_SKEW_MASS, text);
}

/// Replaces unequal added masses mxy and myx by their mean, since the mass matrix of whirl's bearings is symmetric, and
/// notes the loss.
static void make_symmetric(field_section *section, const char *tag, ross_bearing *out) {
    const bool varies = out->varies[MXY] || out->varies[MYX];
    const size_t count = varies ? at_least_one(out->speed_count) * at_least_one(out->frequency_count) : 1;
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

/// Returns the index of the i-th of `kept` evenly spaced places out of `count`, both ends included; 0 if one is kept.
static size_t kept_place(size_t i, size_t kept, size_t count) {
    return kept == 1 ? 0 : (i * (count - 1) + (kept - 1) / 2) / (kept - 1);
}

/// Thins all tables evenly to `speeds` speeds and `frequencies` frequencies.
static void keep(field_section *section, size_t speeds, size_t frequencies, ross_bearing *out) {
    const size_t all_speeds = at_least_one(out->speed_count), all_frequencies = at_least_one(out->frequency_count);
    for (int which = KXX; which < COEFFICIENTS; which++) {
        double *const kept =
            out->varies[which] ? field_memory(section->reader, speeds * frequencies * sizeof *kept) : NULL;
        for (size_t i = 0; i < speeds * frequencies && kept; i++)
            kept[i] = out->values[which][kept_place(i / frequencies, speeds, all_speeds) * all_frequencies +
                                         kept_place(i % frequencies, frequencies, all_frequencies)];
        if (kept) out->values[which] = kept;
    }
    double *const places = field_memory(section->reader, (speeds + frequencies) * sizeof *places);
    for (size_t i = 0; i < speeds && places && out->speed_count > 0; i++)
        places[i] = out->speeds[kept_place(i, speeds, all_speeds)];
    for (size_t i = 0; i < frequencies && places && out->frequency_count > 0; i++)
        places[speeds + i] = out->frequencies[kept_place(i, frequencies, all_frequencies)];
    out->speeds = places;
    out->frequencies = places ? places + speeds : NULL;
    out->speed_count = speeds > 1 ? speeds : 0;
    out->frequency_count = frequencies > 1 ? frequencies : 0;
}

/// Removes an axis along which nothing varies, and places beyond the number that a case may list.
static void thin(field_section *section, const char *tag, ross_bearing *out) {
    const size_t speeds = at_least_one(out->speed_count), frequencies = at_least_one(out->frequency_count);
    const size_t most = WHIRL_MAX_LIST;
    bool along_speeds = false, along_frequencies = false;
    for (int which = KXX; which < COEFFICIENTS; which++)
        for (size_t i = 0; i < speeds * frequencies && out->varies[which]; i++) {
            const double *const at = out->values[which];
            along_speeds = along_speeds || at[i] != at[i % frequencies];
            along_frequencies = along_frequencies || at[i] != at[i - i % frequencies];
        }
    const size_t kept[] = {!along_speeds   ? 1
                           : speeds < most ? speeds
                                           : most,
                           !along_frequencies   ? 1
                           : frequencies < most ? frequencies
                                                : most};
    if ((along_speeds && kept[0] < speeds) || (along_frequencies && kept[1] < frequencies))
        note_of(&section->reader->notes, NOTE_THINNED, tag);
    keep(section, kept[0], kept[1], out);
}

/// Notes axial coefficients, which are not converted.
static void note_axial(field_section *section, const char *tag) {
    static const char *const keys[] = {"kzz", "czz", "mzz"};
    bool found = false;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const field_kind kind = {keys[i], "SI", WHIRL_ANY};
        size_t rows, columns = 1;
        const double *const numbers = field_table(section, &kind, &rows, &columns);
        for (size_t j = 0; numbers && j < rows * columns; j++) found = found || numbers[j] != 0.0;
    }
    if (found) note_of(&section->reader->notes, NOTE_AXIAL, tag);
}

/// Reads the film of a CylindricalBearing: an isothermal short film under a load, with the dimensions in the file.
static void read_film(field_section *section, ross_bearing *out) {
    static const char *const keys[] = {"journal_diameter", "bearing_length", "radial_clearance", "oil_viscosity",
                                       "weight"};
    double numbers[5];
    for (size_t i = 0; i < 5; i++) {
        const value *const at = value_member(section->table, keys[i]);
        if (!at || at->kind != VALUE_NUMBER || !(at->number > 0.0) || !isfinite(at->number)) return;
        numbers[i] = at->number;
    }
    ross_film *const film = field_memory(section->reader, sizeof *film);
    if (!film) return;
    *film = (ross_film){0.5 * numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
    out->film = film;
}

void ross_read_bearing(field_section *section, const char *tag, const char *version, ross_bearing *out) {
    import_reader *const reader = section->reader;
    *out = (ross_bearing){.tag = tag, .section = *section};
    out->node = field_whole(section, "n", -2);
    out->link = field_whole(section, "n_link", -1);
    read_axes(section, version, out);
    for (int which = KXX; which < COEFFICIENTS; which++) read_coefficient(section, (ross_coefficient)which, out);
    if (!field_good(reader)) return;
    if (!value_member(section->table, "kxx")) field_refuse(section, "kxx", NULL, "is missing, expected numbers in N/m");
    as_along_x(section, KYY, KXX, out);
    as_along_x(section, CYY, CXX, out);
    as_along_x(section, MYY, MXX, out);
    make_symmetric(section, tag, out);
    thin(section, tag, out);
    note_axial(section, tag);
    read_film(section, out);
    if (ross_is_magnet(section)) note_of(&reader->notes, NOTE_MAGNETIC_TABLE, tag);
    if (value_member(section->table, "seal_leakage")) note_of(&reader->notes, NOTE_LEAKAGE, tag);
    ross_note_rest(section, tag, true);
}
