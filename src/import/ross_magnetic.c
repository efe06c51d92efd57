// Magnetic bearings of ROSS: magnets, and the controller of both axes.
#include "ross.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/// Keys of linear coefficients, which follow from the other keys.
static const char *const computed[] = {"kxx", "kxy", "kyx", "kyy", "kzz", "cxx", "cxy",       "cyx",  "cyy",
                                       "czz", "mxx", "mxy", "myx", "myy", "mzz", "frequency", "speed"};

/// Reads a number that ROSS may list for each axis. It must be equal for both, which share one controller here.
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

/// Default corner frequency of derivatives in rad/s, from ROSS 2.1 on. Earlier versions had none, which no real
/// controller achieves.
static const double usual = 1e4;

/// Reads a gain and multiplies it by those of amplifier and sensor.
static double read_gain(field_section *section, const field_kind *kind, double gain) {
    const double number = gain * read_common(section, kind, 0.0);
    if (!isfinite(number))
        field_refuse(section, kind->key, value_member(section->table, kind->key),
                     "is infinite times the gains k_amp and k_sense, expected smaller gains");
    return number;
}

/// Reads the controller k_p + k_i/s + k_d s/(1 + s/n_f).
static void read_controller(field_section *section, ross_magnet *out) {
    const double gain = read_common(section, &(field_kind){"k_amp", "1", WHIRL_ANY}, 1.0) *
                        read_common(section, &(field_kind){"k_sense", "1", WHIRL_ANY}, 1.0);
    out->filter = 1.0 / read_common(section, &(field_kind){"n_f", "rad/s", WHIRL_FROM_TO(1e-3, 1e12)}, usual);
    out->proportional = read_gain(section, &(field_kind){"kp_pid", "A/m", WHIRL_ANY}, gain);
    out->integral = read_gain(section, &(field_kind){"ki_pid", "A/(m s)", WHIRL_ANY}, gain);
    out->derivative = read_gain(section, &(field_kind){"kd_pid", "A s/m", WHIRL_ANY}, gain);
    if (gain == 0.0)
        field_refuse(section, "k_amp", value_member(section->table, "k_amp"),
                     "times k_sense is 0, expected gains of a controller that acts");
}

/// Returns the value of a key, or its first item if it is a list; NULL without one.
static const value *first_of(const field_section *section, const char *key) {
    const value *const at = value_member(section->table, key);
    return at && at->kind == VALUE_LIST ? at->first : at;
}

static double first_number(const field_section *section, const char *key, double fallback) {
    const value *const at = first_of(section, key);
    return at && at->kind == VALUE_NUMBER ? at->number : fallback;
}

bool ross_is_magnet(const field_section *section) {
    static const char *const keys[] = {"g0", "i0", "ag", "nw"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (!value_member(section->table, keys[i])) return false;
    return true;
}

static bool has_gains(const field_section *section) {
    static const char *const keys[] = {"kp_pid", "ki_pid", "kd_pid"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const value *const at = first_of(section, keys[i]);
        if (at && at->kind != VALUE_NOTHING && !(at->kind == VALUE_NUMBER && at->number == 0.0)) return true;
    }
    return false;
}

/// Returns true if the stiffness in the file is that of magnet and PID at the first frequency. Otherwise ROSS used
/// another controller, which it does not save.
static bool is_controlled_so(const field_section *section, const ross_magnet *magnet) {
    const double w = first_number(section, "frequency", 0.0), lag = w * magnet->filter;
    const double by_current = 4e-7 * 3.14159265358979323846 * magnet->turns * magnet->turns * magnet->area *
                              magnet->bias * cos(magnet->pole_angle) / (magnet->gap * magnet->gap);
    const double by_place = by_current * magnet->bias / magnet->gap;
    const double active = by_current * (magnet->proportional + magnet->derivative * w * lag / (1.0 + lag * lag));
    const double stiffness = first_number(section, "kxx", active - by_place);
    return fabs(stiffness - (active - by_place)) <= 1e-6 * (fabs(active) + by_place);
}

bool ross_read_magnetic(field_section *section, const char *tag, ross_bearing *out) {
    if (!ross_is_magnet(section) || !has_gains(section)) return false;
    ross_magnet *const magnet = field_memory(section->reader, sizeof *magnet);
    *out = (ross_bearing){.tag = tag, .section = *section, .magnet = magnet};
    if (!magnet) return true;
    // Read the nodes and the magnets.
    out->node = field_whole(section, "n", -2);
    out->link = field_whole(section, "n_link", -1);
    magnet->gap = read_common(section, &(field_kind){"g0", "m", WHIRL_POSITIVE}, NAN);
    magnet->bias = read_common(section, &(field_kind){"i0", "A", WHIRL_POSITIVE}, NAN);
    magnet->area = read_common(section, &(field_kind){"ag", "m2", WHIRL_POSITIVE}, NAN);
    magnet->turns = read_common(section, &(field_kind){"nw", "1", WHIRL_POSITIVE}, NAN);
    magnet->pole_angle =
        fabs(read_common(section, &(field_kind){"alpha", "rad", WHIRL_FROM_TO(-1.5, 1.5)}, 0.39269908));
    // Before ROSS 2.1 magnets were along x and y.
    magnet->angle = read_common(section, &(field_kind){"sensors_axis_rotation", "rad", WHIRL_ANY}, 0.0);
    // Read the controller, and reject one that is not in the file.
    read_controller(section, magnet);
    if (field_good(section->reader) && !is_controlled_so(section, magnet)) return false;
    // Mark computed coefficients as read, and note the changes.
    for (size_t i = 0; i < sizeof computed / sizeof *computed; i++) (void)value_member(section->table, computed[i]);
    note_of(&section->reader->notes, NOTE_MAGNETIC, tag);
    if (magnet->derivative != 0.0 && !value_member(section->table, "n_f"))
        note_of(&section->reader->notes, NOTE_MAGNETIC_FILTER, tag);
    ross_note_rest(section, tag, false);
    return true;
}

// ---------------------------------------------------------------- in a case

static void put_gain(page_line *line, const char *key, double gain, const char *unit) {
    if (gain != 0.0) page_number(line, key, gain, unit);
}

void ross_put_magnetic(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing) {
    const ross_magnet *const magnet = bearing->magnet;
    page_line line = page_open(out, 17, "    - magnetic: {");
    ross_put_place(&line, rotor, bearing);
    page_number(&line, "angle", magnet->angle, "rad");
    page_number(&line, "gap", magnet->gap, "m");
    page_number(&line, "bias", magnet->bias, "A");
    page_number(&line, "turns", magnet->turns, "");
    page_number(&line, "area", magnet->area, "m2");
    page_number(&line, "pole_angle", magnet->pole_angle, "rad");
    put_gain(&line, "proportional", magnet->proportional, "A/m");
    put_gain(&line, "integral", magnet->integral, "A/(m s)");
    put_gain(&line, "derivative", magnet->derivative, "A s/m");
    if (magnet->derivative != 0.0) page_number(&line, "derivative_filter", magnet->filter, "s");
    page_close(&line, "}", NULL);
}
