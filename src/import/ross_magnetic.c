// Magnetic bearings of ROSS: magnets, and the controller of both axes.
#include "ross.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/// What the file has besides: linear coefficients, which follow from the rest.
static const char *const computed[] = {"kxx", "kxy", "kyx", "kyy", "kzz", "cxx", "cxy",       "cyx",  "cyy",
                                       "czz", "mxx", "mxy", "myx", "myy", "mzz", "frequency", "speed"};

/// A number that ROSS may have for each axis: here both have one controller.
static double read_common(field_section *section, const field_kind *kind, double fallback) {
    const value *const at = value_member(section->table, kind->key);
    size_t count;
    if (!at || at->kind != VALUE_LIST) return field_number(section, kind, fallback);
    const double *const numbers = field_numbers(section, kind, &count);
    for (size_t i = 1; numbers && i < count; i++)
        if (numbers[i] != numbers[0])
            field_refuse(section, kind->key, at,
                         "is %.10g %s along one axis and %.10g along another, expected one number for both", numbers[0],
                         kind->unit, numbers[i]);
    return numbers && count > 0 ? numbers[0] : fallback;
}

static const double *read_orders(field_section *section, const char *key, size_t *count) {
    enum { ORDERS = 7 }; // up to the sixth
    const field_kind kind = {key, "SI", WHIRL_ANY};
    const double *const numbers = field_numbers(section, &kind, count);
    if (numbers && *count > ORDERS)
        field_refuse(section, key, value_member(section->table, key),
                     "has %zu coefficients, expected a transfer function up to the sixth order", *count);
    return numbers;
}

/// rad/s: the corner of derivatives from ROSS 2 on where nothing is said; before they had none, which no controller
/// does.
static const double usual = 1e4;

/// A transfer function, or k_p + k_i/s + k_d s/(1 + s/n_f); gains of sensor and amplifier multiply either.
static void read_controller(field_section *section, const char *tag, ross_magnet *out) {
    const double gain = read_common(section, &(field_kind){"k_amp", "1", WHIRL_ANY}, 1.0) *
                        read_common(section, &(field_kind){"k_sense", "1", WHIRL_ANY}, 1.0);
    const double filter = read_common(section, &(field_kind){"n_f", "rad/s", WHIRL_POSITIVE}, INFINITY);
    out->gain = gain;
    out->proportional = gain * read_common(section, &(field_kind){"kp_pid", "A/m", WHIRL_ANY}, 0.0);
    out->integral = gain * read_common(section, &(field_kind){"ki_pid", "A/(m s)", WHIRL_ANY}, 0.0);
    out->derivative = gain * read_common(section, &(field_kind){"kd_pid", "A s/m", WHIRL_ANY}, 0.0);
    out->filter = 1.0 / (isfinite(filter) ? filter : usual);
    if (!isfinite(filter) && out->derivative != 0.0) note_of(&section->reader->notes, NOTE_MAGNETIC_FILTER, tag);
    out->numerator = read_orders(section, "controller_transfer_function_num", &out->numerator_count);
    out->denominator = read_orders(section, "controller_transfer_function_den", &out->denominator_count);
    const value *const function = value_member(section->table, "controller_transfer_function");
    const bool told = out->numerator && out->denominator;
    if (function && function->kind != VALUE_NOTHING && !told)
        field_refuse(section, "controller_transfer_function", function,
                     "has no numbers that are known here, expected controller_transfer_function_num and _den");
    else if (!told && out->proportional == 0.0 && out->integral == 0.0 && out->derivative == 0.0)
        field_refuse(section, "kp_pid", value_member(section->table, "kp_pid"),
                     "is 0 or missing, and so are ki_pid and kd_pid, expected a controller");
}

void ross_read_magnetic(field_section *section, const char *tag, ross_bearing *out) {
    ross_magnet *const magnet = field_memory(section->reader, sizeof *magnet);
    *out = (ross_bearing){.tag = tag, .section = *section, .magnet = magnet};
    if (!magnet) return;
    out->node = field_whole(section, "n", -2);
    out->link = field_whole(section, "n_link", -1);
    magnet->gap = read_common(section, &(field_kind){"g0", "m", WHIRL_POSITIVE}, NAN);
    magnet->bias = read_common(section, &(field_kind){"i0", "A", WHIRL_POSITIVE}, NAN);
    magnet->area = read_common(section, &(field_kind){"ag", "m2", WHIRL_POSITIVE}, NAN);
    magnet->turns = read_common(section, &(field_kind){"nw", "1", WHIRL_POSITIVE}, NAN);
    magnet->pole_angle = read_common(section, &(field_kind){"alpha", "rad", WHIRL_FROM_TO(0, 1.5)}, 0.39269908);
    // Before ROSS 2 magnets stood along x and y.
    magnet->angle = read_common(section, &(field_kind){"sensors_axis_rotation", "rad", WHIRL_ANY}, 0.0);
    read_controller(section, tag, magnet);
    for (size_t i = 0; i < sizeof computed / sizeof *computed; i++) (void)value_member(section->table, computed[i]);
    note_of(&section->reader->notes, NOTE_MAGNETIC, tag);
    ross_note_rest(section, tag, false);
}

// ---------------------------------------------------------------- in a case

static void item(page_line *line, const char *key, double number, const char *unit) {
    char text[QUANTITY_SIZE];
    if (number == 0.0) return;
    page_quantity(number, unit, text);
    page_item(line, "%s: %s", key, text);
}

static void list(page_line *line, const char *key, const double *numbers, size_t count, double factor) {
    char text[8 * QUANTITY_SIZE] = "", one[QUANTITY_SIZE];
    for (size_t i = 0; i < count; i++) {
        page_quantity(factor * numbers[i], "", one);
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", i ? ", " : "", one);
    }
    page_item(line, "%s: [%s]", key, text);
}

void ross_put_magnetic(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    const ross_magnet *const magnet = bearing->magnet;
    char angle[QUANTITY_SIZE];
    page_line line = page_open(out, 17, "    - magnetic: {");
    page_quantity(magnet->angle, "rad", angle);
    page_item(&line, "at: %s", ross_station_at(rotor, bearing->node)->name);
    if (bearing->link >= 0) page_item(&line, "from: %s", ross_station_at(rotor, bearing->link)->name);
    page_item(&line, "angle: %s", angle);
    item(&line, "gap", magnet->gap, "m");
    item(&line, "bias", magnet->bias, "A");
    item(&line, "turns", magnet->turns, "");
    item(&line, "area", magnet->area, "m2");
    page_quantity(magnet->pole_angle, "rad", angle);
    page_item(&line, "pole_angle: %s", angle);
    if (magnet->numerator && magnet->denominator) {
        list(&line, "numerator", magnet->numerator, magnet->numerator_count, magnet->gain);
        list(&line, "denominator", magnet->denominator, magnet->denominator_count, 1.0);
    } else {
        item(&line, "proportional", magnet->proportional, "A/m");
        item(&line, "integral", magnet->integral, "A/(m s)");
        item(&line, "derivative", magnet->derivative, "A s/m");
        if (magnet->derivative != 0.0) item(&line, "derivative_filter", magnet->filter, "s");
    }
    page_close(&line, "}", NULL);
}
