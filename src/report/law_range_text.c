#include <math.h>
#include <stdio.h>
#include <string.h>

#include "law_range_text.h"
#include "shown_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

/// Adds the number of points and the first of them, if there is a parameter.
static void add_points(const whirl_shown_units *units, const whirl_table *table, const whirl_left *left,
                       char text[RANGE_TEXT_SIZE]) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    const size_t used = strlen(text);
    if (*table->parameter)
        snprintf(text + used, RANGE_TEXT_SIZE - used, " (%zu of %zu points, first at %.6g%s%s)", left->points,
                 table->count, table->values[left->first] / unit.size, *unit.name ? " " : "", unit.name);
}

bool law_range_text(const whirl_shown_units *units, const whirl_table *table, size_t index,
                    char text[RANGE_TEXT_SIZE]) {
    static const char most[] = " up to ";
    whirl_left left;
    char said[RANGE_TEXT_SIZE];
    if (whirl_table_left(table, index, &left) == 0) return false;
    const char *const law = whirl_result_law_range(units->result, index), *unit = strstr(law, most);
    // Find the unit of the limit ("Pa" in "up to 4e9 Pa, ..."), which is that of the reached value.
    unit = unit ? unit + strlen(most) + strcspn(unit + strlen(most), " ,") : "";
    snprintf(said, sizeof said, "%s; reached %.4g%.*s", law, left.reached, (int)strcspn(unit, ","), unit);
    whirl_shown_sentence(units, said, text, RANGE_TEXT_SIZE);
    add_points(units, table, &left, text);
    return true;
}

bool no_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]) {
    whirl_left left;
    if (whirl_table_unfound(table, &left) == 0) return false;
    if (isnan(left.reached))
        snprintf(
            text, RANGE_TEXT_SIZE,
            "it was found, but not for another machine that is needed too (its stages or seals alone, another speed); "
            "or coefficients turn with the shaft, and no periodic motion was found in its place (at low speeds a "
            "revolution is too long to be followed)");
    else
        snprintf(text, RANGE_TEXT_SIZE, "none was found: it could be followed up to %.3g %% of the static load",
                 100.0 * left.reached);
    add_points(units, table, &left, text);
    const size_t used = strlen(text);
    snprintf(text + used, RANGE_TEXT_SIZE - used, "; numbers are missing there%s",
             isnan(left.reached) ? ""
                                 : ", expected a machine that its supports carry, or an initial state near where it "
                                   "rests");
    return true;
}

bool other_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]) {
    whirl_left left;
    if (whirl_table_elsewhere(table, &left) == 0) return false;
    snprintf(text, RANGE_TEXT_SIZE,
             "there is another one, up to %.4g %s away, to which that of the value before or after leads, %s",
             units->length * left.reached, units->length_name, left.most < 0.0 ? "stable" : "unstable");
    add_points(units, table, &left, text);
    return true;
}

bool closed_contact_text(const whirl_shown_units *units, const whirl_table *table, size_t contact,
                         char text[RANGE_TEXT_SIZE]) {
    whirl_left left;
    if (whirl_table_held(table, contact, &left) == 0) return false;
    const whirl_unit *const force = &units->of[WHIRL_QUANTITY_FORCE];
    snprintf(text, RANGE_TEXT_SIZE, "%s with %s%.4g %s", units->result->contacts[contact],
             left.points > 1 ? "up to " : "", left.reached * units->result->force_scale / force->size, force->name);
    add_points(units, table, &left, text);
    const shown_kind *kind = shown_kind_of(table);
    const size_t used = strlen(text);
    snprintf(text + used, RANGE_TEXT_SIZE - used, ", which %s",
             kind && kind->held ? kind->held : "small motions leave as it is there");
    return true;
}
