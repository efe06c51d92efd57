// Writes a rotor of ROSS as a case.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "page.h"
#include "ross.h"
#include "whirl/engine/rotor.h"

enum { POINTS = 101, COMMENT_SIZE = 160 };

/// Speed range of the study, and operating speed, in rad/s.
typedef struct speed_range {
    double from, to, at;
    const char *why;
} speed_range;

// ---------------------------------------------------------------- speeds

/// Finds the range of speeds that all tables cover.
static void find_known(const ross_rotor *rotor, double *low, double *high) {
    const ross_bearing *lowest = NULL;
    *low = 0.0;
    *high = INFINITY;
    for (size_t i = 0; i < rotor->bearing_count; i++) {
        const ross_bearing *const bearing = &rotor->bearings[i];
        if (bearing->speed_count == 0) continue;
        if (bearing->speeds[0] >= *low) {
            *low = bearing->speeds[0];
            lowest = bearing;
        }
        *high = fmin(*high, bearing->speeds[bearing->speed_count - 1]);
    }
    if (*low < *high) return;
    field_section section = lowest->section;
    field_refuse(
        &section, lowest->axis, value_member(section.table, lowest->axis),
        "begins at %.10g rad/s, where another table ends or has ended (%.10g rad/s), expected tables with speeds "
        "in common",
        *low, *high);
}

/// Chooses the speeds of the study: those that the file names, cut to its tables; else the range of the tables; else up
/// to 10000 rpm.
static speed_range find_speeds(import_reader *reader, const ross_rotor *rotor) {
    const double usual = 10000.0 * 3.14159265358979323846 / 30.0;
    double low, high;
    speed_range range = {.why = "those that the file names"};
    find_known(rotor, &low, &high);
    if (!field_good(reader)) return range;
    // Prefer the file's own speeds.
    const bool named = rotor->most > 0.0 || rotor->rated > 0.0, known = isfinite(high);
    const double most = rotor->most > 0.0 ? rotor->most : rotor->rated > 0.0 ? 1.25 * rotor->rated : usual;
    range.from = rotor->least >= 0.0 && rotor->least < most ? rotor->least : 0.0;
    range.to = named || !known ? most : high;
    if (!named)
        range.why =
            known ? "those of the tables, as the file names no speeds" : "usual ones, as the file names no speeds";
    // Keep them within the tables.
    if (range.from < low || range.to > high) {
        range.from = fmin(fmax(range.from, low), high);
        range.to = fmax(fmin(range.to, high), low);
        if (named)
            note_add(&reader->notes, "The study's speeds are cut to those of the tables, %.6g to %.6g rad/s.", low,
                     high);
    }
    if (!(range.from < range.to)) {
        note_add(&reader->notes, "No table knows the speeds that the file names: the study takes those of the tables.");
        range.from = low;
        range.to = high;
    }
    range.at = rotor->rated >= range.from && rotor->rated <= range.to ? rotor->rated : range.to;
    return range;
}

/// Writes a speed in rpm if it is a whole number of rpm to rounding; else, and at the ends of a table, in rad/s.
static void speed_text(double speed, bool in_table, char text[QUANTITY_SIZE]) {
    const double rpm = round(speed * 30.0 / 3.14159265358979323846);
    if (!in_table && fabs(rpm * 3.14159265358979323846 / 30.0 - speed) <= 1e-12 * speed)
        page_quantity(rpm, "rpm", text);
    else
        page_quantity(speed, "rad/s", text);
}

// ---------------------------------------------------------------- head

static const char *base_of(const char *path) {
    const char *const slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/// Writes the title in quotes, so that YAML takes all characters of the file's name as they are.
static void put_title(FILE *out, const char *file) {
    fputs("title: 'Rotor of ", out);
    for (const char *c = base_of(file); *c; c++) {
        if (*c == '\'') fputc('\'', out);
        fputc(*c, out);
    }
    fputs("'\n", out);
}

static void put_head(FILE *out, import_reader *reader, const ross_rotor *rotor) {
    char text[256];
    snprintf(text, sizeof text,
             "Made by 'whirl import' of %.100s, a rotor saved by ROSS%s%.20s (github.com/petrobras/ross).",
             base_of(reader->file), rotor->version[0] ? " " : "", rotor->version);
    whirl_make_plain(text);
    page_comment(out, "# ", "# ", text);
    for (const note *one = reader->notes.first; one; one = one->next) page_comment(out, "# - ", "#   ", one->text);
    fputs("whirl: 1\n", out);
    put_title(out, reader->file);
}

/// Returns a thousandth of the shaft's mean radius, rounded to 1, 2 or 5 times a power of ten.
static double length_scale(const ross_rotor *rotor) {
    double area = 0.0, length = 0.0;
    for (size_t i = 0; i < rotor->piece_count; i++) {
        const ross_piece *const piece = &rotor->pieces[i];
        area += 0.25 * (piece->outer[0] + piece->outer[1]) * piece->length;
        length += piece->length;
    }
    const double exact = 1e-3 * area / length, power = pow(10.0, floor(log10(exact)));
    const double digit = exact / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

// ---------------------------------------------------------------- materials and shaft

static void pressure_text(double pressure, char text[QUANTITY_SIZE]) {
    if (pressure >= 1e8)
        page_quantity(1e-9 * pressure, "GPa", text);
    else
        page_quantity(pressure, "Pa", text);
}

static void put_materials(FILE *out, const ross_rotor *rotor, char (*names)[WHIRL_NAME_SIZE]) {
    char modulus[QUANTITY_SIZE], shear[QUANTITY_SIZE], density[QUANTITY_SIZE];
    fputs("  materials:\n", out);
    for (size_t i = 0; i < rotor->material_count; i++) {
        const ross_material *const one = &rotor->materials[i];
        ross_name(one->name, "material", names[i]);
        const size_t length = strlen(names[i]);
        bool taken = true;
        for (int number = 2; taken; number++) {
            taken = false;
            for (size_t j = 0; j < i; j++) taken = taken || strcmp(names[j], names[i]) == 0;
            if (taken) snprintf(names[i] + length, WHIRL_NAME_SIZE - length, "_%d", number);
        }
        pressure_text(one->modulus, modulus);
        pressure_text(one->shear, shear);
        page_quantity(one->density, "kg/m3", density);
        fprintf(out, "    %s: {modulus: %s, shear_modulus: %s, density: %s}\n", names[i], modulus, shear, density);
    }
}

/// Writes the modelling options of a piece: all that are not defaults, or, with `usual`, those that differ from its
/// shaft's.
static void ross_put_options(page_line *line, const ross_piece *own, const ross_piece *usual) {
    char text[QUANTITY_SIZE];
    if (!usual || own->shear != usual->shear || (own->shear && own->hutchinson != usual->hutchinson))
        page_item(line, "shear: %s", !own->shear ? "none" : own->hutchinson ? "hutchinson" : "cowper");
    if (usual ? own->rotary_inertia != usual->rotary_inertia : !own->rotary_inertia)
        page_item(line, "rotary_inertia: %s", own->rotary_inertia ? "yes" : "no");
    if (usual ? own->gyroscopic != usual->gyroscopic : !own->gyroscopic)
        page_item(line, "gyroscopic: %s", own->gyroscopic ? "yes" : "no");
    page_quantity(own->mass_damping, "1/s", text);
    if (own->mass_damping != (usual ? usual->mass_damping : 0.0)) page_item(line, "mass_damping: %s", text);
    page_quantity(own->stiffness_damping, "s", text);
    if (own->stiffness_damping != (usual ? usual->stiffness_damping : 0.0))
        page_item(line, "stiffness_damping: %s", text);
}

/// Writes "shaft", or "shaft_2" if there are several.
static void shaft_name(const ross_rotor *rotor, size_t shaft, char name[WHIRL_NAME_SIZE]) {
    snprintf(name, WHIRL_NAME_SIZE, "shaft");
    if (rotor->shaft_count > 1) snprintf(name, WHIRL_NAME_SIZE, "shaft_%zu", shaft + 1);
}

/// Returns the first piece of a shaft, which gives the shaft's options.
static const ross_piece *first_piece(const ross_rotor *rotor, size_t shaft) {
    const ross_piece *piece = rotor->pieces;
    while (piece->shaft != shaft) piece++;
    return piece;
}

static void put_shafts(FILE *out, const ross_rotor *rotor, const char *material) {
    char name[WHIRL_NAME_SIZE], head[WHIRL_NAME_SIZE + 16];
    fputs("  shafts:\n", out);
    for (size_t i = 0; i < rotor->shaft_count; i++) {
        shaft_name(rotor, i, name);
        snprintf(head, sizeof head, "    %s: {", name);
        page_line line = page_open(out, 6, head);
        if (rotor->material_count == 1) page_item(&line, "material: %s", material);
        ross_put_options(&line, first_piece(rotor, i), NULL);
        page_close(&line, "}", NULL);
    }
}

static void put_piece(FILE *out, const ross_rotor *rotor, const ross_piece *piece, bool layer, const char *material) {
    static const char *const outer[] = {"outer", "outer_end"}, *const inner[] = {"inner", "inner_end"};
    char text[QUANTITY_SIZE], comment[COMMENT_SIZE], shaft[WHIRL_NAME_SIZE];
    // Write the shaft and the length.
    page_line line = page_open(out, 16, "    - segment: {");
    shaft_name(rotor, piece->shaft, shaft);
    if (rotor->shaft_count > 1) page_item(&line, "shaft: %s", shaft);
    page_quantity(piece->length, "m", text);
    page_item(&line, "length: %s", text);
    // Write the diameters of both ends, or of one if they are equal.
    const bool conical = piece->outer[0] != piece->outer[1] || piece->inner[0] != piece->inner[1];
    for (int end = 0; end < 1 + conical; end++) {
        page_quantity(piece->outer[end], "m", text);
        page_item(&line, "%s: %s", outer[end], text);
        page_quantity(piece->inner[end], "m", text);
        if (piece->inner[0] != 0.0 || piece->inner[1] != 0.0) page_item(&line, "%s: %s", inner[end], text);
    }
    // Write the place, the material and the options.
    page_quantity(piece->start, "m", text);
    if (layer) page_item(&line, "start: %s", text);
    if (rotor->material_count > 1) page_item(&line, "material: %s", material);
    page_quantity(piece->axial_force, "N", text);
    if (piece->axial_force != 0.0) page_item(&line, "axial_force: %s", text);
    ross_put_options(&line, piece, first_piece(rotor, piece->shaft));
    // Name the element in a comment.
    snprintf(comment, sizeof comment, "%.60s, node %ld", piece->tag, piece->node);
    whirl_make_plain(comment);
    page_close(&line, "}", comment);
}

// ---------------------------------------------------------------- stations and bearings

static void put_station(FILE *out, const ross_rotor *rotor, const ross_station *at) {
    char text[QUANTITY_SIZE], head[WHIRL_NAME_SIZE + 16], comment[COMMENT_SIZE], shaft[WHIRL_NAME_SIZE];
    const bool on_shaft = at->place && at->place->shaft != ROSS_NO_SHAFT;
    snprintf(head, sizeof head, "    %s: {", at->name);
    // Write the place on the shaft.
    page_line line = page_open(out, (int)strlen(head), head);
    if (on_shaft) {
        shaft_name(rotor, at->place->shaft, shaft);
        if (rotor->shaft_count > 1) page_item(&line, "shaft: %s", shaft);
        page_quantity(at->place->position, "m", text);
        page_item(&line, "position: %s", text);
    }
    // Write the masses.
    const struct {
        const char *key, *unit;
        double number;
    } parts[] = {{"mass", "kg", fmin(at->mass[0], at->mass[1])},
                 {"diametral", "kg.m2", at->diametral},
                 {"polar", "kg.m2", at->polar}};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        page_quantity(parts[i].number, parts[i].unit, text);
        if (parts[i].number != 0.0) page_item(&line, "%s: %s", parts[i].key, text);
    }
    // Name the node in a comment.
    snprintf(comment, sizeof comment, "node %ld%s", at->node,
             on_shaft    ? ""
             : at->place ? ", on no shaft"
                         : ", a support");
    page_close(&line, "}", comment);
}

/// Writes the mass by which a support is heavier along one axis.
static void put_heavier_axis(FILE *out, const ross_station *at) {
    char text[QUANTITY_SIZE];
    if (at->mass[0] == at->mass[1]) return;
    const bool x = at->mass[0] > at->mass[1];
    page_quantity(fabs(at->mass[0] - at->mass[1]), "kg", text);
    fprintf(out, "    # The mass of %s is larger along %s\n    - bearing: {at: %s, mxx: %s, myy: %s}\n", at->name,
            x ? "x" : "y", at->name, x ? text : "0 kg", x ? "0 kg" : text);
}

static size_t table_size(const ross_bearing *bearing) {
    return (bearing->speed_count > 0 ? bearing->speed_count : 1) *
           (bearing->frequency_count > 0 ? bearing->frequency_count : 1);
}

/// Returns true if a coefficient has to be written: not if it is 0, nor along y if it equals that along x.
static bool is_said(const ross_bearing *bearing, ross_coefficient which) {
    const ross_coefficient x = which == KYY ? KXX : which == CYY ? CXX : which == MYY ? MXX : which;
    if (which == MYX) return false; // inertia is symmetric
    if (x == which) return ross_acts(bearing, which);
    if (bearing->varies[which] || bearing->varies[x]) {
        if (bearing->varies[which] != bearing->varies[x]) return true;
        for (size_t i = 0; i < table_size(bearing); i++)
            if (bearing->values[which][i] != bearing->values[x][i]) return true;
        return false;
    }
    return bearing->values[which][0] != bearing->values[x][0];
}

/// Writes "kxx: [1, 2, 3]" after `head`; numbers without unit are in SI.
static void put_list(FILE *out, const char *head, const double *numbers, size_t count) {
    char text[QUANTITY_SIZE];
    page_line line = page_open(out, (int)strlen(head), head);
    for (size_t i = 0; i < count; i++) {
        page_quantity(numbers[i], "", text);
        page_item(&line, "%s", text);
    }
    page_close(&line, "]", NULL);
}

/// Writes a coefficient as a list, or as a list of lists, one for every speed.
static void put_coefficient(FILE *out, const ross_bearing *bearing, ross_coefficient which) {
    const size_t rows = bearing->frequency_count > 0 ? bearing->speed_count : 0, columns = bearing->frequency_count;
    char head[32];
    snprintf(head, sizeof head, "        %s: [", ross_coefficient_names[which]);
    if (rows == 0) {
        put_list(out, head, bearing->values[which], table_size(bearing));
        return;
    }
    fprintf(out, "        %s:\n", ross_coefficient_names[which]);
    for (size_t i = 0; i < rows; i++) put_list(out, "          - [", bearing->values[which] + i * columns, columns);
}

/// Writes a bearing whose coefficients vary with speed or frequency, each key on its own line.
static void put_table(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    char text[QUANTITY_SIZE];
    fprintf(out, "    - bearing:\n        at: %s\n", ross_station_at(rotor, bearing->node)->name);
    if (bearing->link >= 0) fprintf(out, "        from: %s\n", ross_station_at(rotor, bearing->link)->name);
    if (bearing->seal) fputs("        role: seal\n", out);
    if (bearing->speed_count > 0) put_list(out, "        speeds: [", bearing->speeds, bearing->speed_count);
    if (bearing->frequency_count > 0)
        put_list(out, "        frequencies: [", bearing->frequencies, bearing->frequency_count);
    for (int i = KXX; i < COEFFICIENTS; i++) {
        const ross_coefficient which = (ross_coefficient)i;
        if (!is_said(bearing, which)) continue;
        page_quantity(bearing->values[which][0], ross_coefficient_units[which], text);
        if (bearing->varies[which])
            put_coefficient(out, bearing, which);
        else
            fprintf(out, "        %s: %s\n", ross_coefficient_names[which], text);
    }
}

static void put_constant(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    page_line line = page_open(out, 16, "    - bearing: {");
    ross_put_place(&line, rotor, bearing);
    if (bearing->seal) page_item(&line, "role: seal");
    for (int i = KXX; i < COEFFICIENTS; i++)
        if (is_said(bearing, (ross_coefficient)i))
            page_number(&line, ross_coefficient_names[i], bearing->values[i][0], ross_coefficient_units[i]);
    page_close(&line, "}", NULL);
}

/// Writes a comment with the film from which the coefficients were computed, as an element that can replace them.
static void put_film(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    const double numbers[] = {bearing->film->radius, bearing->film->length, bearing->film->clearance,
                              bearing->film->viscosity};
    static const char *const names[] = {"radius", "length", "clearance", "viscosity"};
    static const char *const units[] = {"m", "m", "m", "Pa s"};
    char text[QUANTITY_SIZE];
    page_quantity(bearing->film->load, "N", text);
    fprintf(out,
            "    # coefficients of the short film below under a load of %s; in motions with gravity it can replace "
            "them\n",
            text);
    fprintf(out, "    # - film: {at: %s", ross_station_at(rotor, bearing->node)->name);
    if (bearing->link >= 0) fprintf(out, ", from: %s", ross_station_at(rotor, bearing->link)->name);
    fputs(", law: short", out);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        page_quantity(numbers[i], units[i], text);
        fprintf(out, ", %s: %s", names[i], text);
    }
    fputs("}\n", out);
}

static void put_bearing(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    char comment[COMMENT_SIZE];
    snprintf(comment, sizeof comment, "%.60s, node %ld", bearing->tag, bearing->node);
    whirl_make_plain(comment);
    page_comment(out, "    # ", "    # ", comment);
    (bearing->magnet ? ross_put_magnetic : table_size(bearing) > 1 ? put_table : put_constant)(out, rotor, bearing);
    if (bearing->film) put_film(out, rotor, bearing);
}

// ---------------------------------------------------------------- the whole case

/// Returns true if every shaft has at least two bearings with a stiffness along y, none of them magnetic. The rotor
/// then has a position of rest under its weight, which changes neither modes nor responses.
static bool is_carried(const ross_rotor *rotor) {
    for (size_t s = 0; s < rotor->shaft_count; s++) {
        size_t bearings = 0;
        for (size_t i = 0; i < rotor->bearing_count; i++) {
            const ross_bearing *const own = &rotor->bearings[i];
            const ross_station *const at = ross_station_at(rotor, own->node);
            if (own->magnet) return false;
            if (own->seal || !at->place || at->place->shaft != s) continue;
            bool stiff = true;
            for (size_t k = 0; k < (own->varies[KYY] ? table_size(own) : 1); k++)
                stiff = stiff && own->values[KYY][k] > 0.0;
            bearings += stiff;
        }
        if (bearings < 2) return false;
    }
    return true;
}

/// Writes gravity as in static analyses of ROSS, for horizontal shafts: as a comment if the rotor is not carried.
static void put_gravity(FILE *out, const ross_rotor *rotor) {
    if (is_carried(rotor))
        fputs("    - gravity: 9.8065 m/s2    # that of ROSS, for statics: responses do not depend on it\n", out);
    else
        fputs("    # - gravity: 9.8065 m/s2    # that of ROSS, for statics of a rotor that rests on its bearings\n",
              out);
}

static void put_rotor(FILE *out, const ross_rotor *rotor, char (*names)[WHIRL_NAME_SIZE]) {
    char text[QUANTITY_SIZE];
    page_quantity(1e6 * length_scale(rotor), "um", text);
    fprintf(out, "\nrotor:\n  speed: = speed\n  length_scale: %s    # near a thousandth of the shaft's radius\n", text);
    put_materials(out, rotor, names);
    put_shafts(out, rotor, names[0]);
    fputs("  stations:    # those of a shaft may have eccentricity: ROSS saves no unbalance\n", out);
    for (size_t i = 0; i < rotor->station_count; i++) put_station(out, rotor, &rotor->stations[i]);
    fputs("  elements:    # plain numbers are in SI: rad/s, N/m, N s/m, kg\n", out);
    put_gravity(out, rotor);
    for (size_t i = 0; i < rotor->piece_count; i++) {
        const ross_piece *const piece = &rotor->pieces[i];
        put_piece(out, rotor, piece, i > 0 && piece[-1].node == piece->node, names[piece->material]);
    }
    for (size_t i = 0; i < rotor->bearing_count; i++) put_bearing(out, rotor, &rotor->bearings[i]);
    for (size_t i = 0; i < rotor->coupling_count; i++) ross_put_coupling(out, rotor, &rotor->couplings[i]);
    for (size_t i = 0; i < rotor->station_count; i++) put_heavier_axis(out, &rotor->stations[i]);
}

static bool is_end_of_table(const ross_rotor *rotor, double speed) {
    for (size_t i = 0; i < rotor->bearing_count; i++) {
        const ross_bearing *const one = &rotor->bearings[i];
        if (one->speed_count > 0 && (one->speeds[0] == speed || one->speeds[one->speed_count - 1] == speed))
            return true;
    }
    return false;
}

static void put_case(FILE *out, import_reader *reader, const ross_rotor *rotor, const speed_range *range,
                     char (*names)[WHIRL_NAME_SIZE]) {
    char text[QUANTITY_SIZE], to[QUANTITY_SIZE];
    put_head(out, reader, rotor);
    speed_text(range->at, is_end_of_table(rotor, range->at), text);
    fprintf(out, "\nparameters:\n  speed: %s    # of %.10g to %.10g rad/s: %s\n", text, range->from, range->to,
            range->why);
    put_rotor(out, rotor, names);
    speed_text(range->from, is_end_of_table(rotor, range->from), text);
    speed_text(range->to, is_end_of_table(rotor, range->to), to);
    fprintf(out, "\nstudy:\n  modes: {parameter: speed, from: %s, to: %s, points: %d}\n", text, to, POINTS);
}

whirl_status ross_write(import_reader *reader, ross_rotor *rotor, char **text, size_t *length) {
    *text = NULL;
    const speed_range range = find_speeds(reader, rotor);
    char(*const names)[WHIRL_NAME_SIZE] = field_memory(reader, (rotor->material_count + 1) * sizeof *names);
    note_finish(&reader->notes);
    if (reader->notes.no_memory && field_good(reader))
        reader->status = whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", reader->file);
    if (!field_good(reader)) return reader->status;
    FILE *const out = open_memstream(text, length);
    if (!out) return whirl_fail(WHIRL_NO_MEMORY, "no memory to write the case of %.200s", reader->file);
    put_case(out, reader, rotor, &range, names);
    const bool failed = ferror(out) != 0;
    if (fclose(out) == 0 && !failed && *text) return whirl_ok();
    free(*text);
    *text = NULL;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to write the case of %.200s", reader->file);
}
