// Statements on points beyond the range of a law, on equilibria that were not found or are not the only ones, and on
// contacts that are closed at rest.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "findings_render.h"
#include "shown_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

/// Adds the number of points and the first of them, if there is a parameter.
static void add_points(const finder *of, whirl_phrase *found, const whirl_left *left) {
    if (!*of->table->parameter) return;
    phrase_text(of, found, " (%zu of %zu points, first at ", left->points, of->table->count);
    phrase_value(of, found, 6, of->table->values[left->first]);
    phrase_text(of, found, ")");
}

/// States the points beyond validity range `index`: "film at journal: eccentricity ratio up to 0.95, to which its
/// coefficients were found; reached 0.97 (37 of 256 points, first at 6400 rpm)".
static void state_law(const finder *of, size_t index) {
    static const char most[] = " up to ";
    whirl_left left;
    char in_si[SENTENCE_SIZE], text[2 * SENTENCE_SIZE];
    if (whirl_table_left(of->table, index, &left) == 0) return;
    const char *const law = whirl_result_law_range(of->result, index), *unit = strstr(law, most);
    // Find the unit of the limit ("Pa" in "up to 4e9 Pa, ..."), which is that of the reached value.
    unit = unit ? unit + strlen(most) + strcspn(unit + strlen(most), " ,") : "";
    snprintf(in_si, sizeof in_si, "%s; reached %.4g%.*s", law, left.reached, (int)strcspn(unit, ","), unit);
    whirl_shown_sentence(of->units, in_si, text, sizeof text);
    whirl_phrase *found = &find_statement(of, "beyond its law")->found;
    phrase_text(of, found, "%s", text);
    add_points(of, found, &left);
}

/// States the points of studies at rest without an equilibrium.
static void state_no_rest(const finder *of) {
    whirl_left left;
    if (whirl_table_unfound(of->table, &left) == 0) return;
    whirl_phrase *found = &find_statement(of, "place of rest")->found;
    const bool elsewhere = isnan(left.reached);
    if (elsewhere)
        phrase_text(
            of, found,
            "it was found, but not for another machine that is needed too (its stages or seals alone, another speed); "
            "or coefficients turn with the shaft, and no periodic motion was found in its place (at low speeds a "
            "revolution is too long to be followed)");
    else
        phrase_text(of, found, "none was found: it could be followed up to %.3g %% of the static load",
                    100.0 * left.reached);
    add_points(of, found, &left);
    phrase_text(of, found, "; numbers are missing there%s",
                elsewhere ? ""
                          : ", expected a machine that its supports carry, or an initial state near where it rests");
}

/// States the points at rest with another equilibrium.
static void state_other_rest(const finder *of) {
    whirl_left left;
    if (whirl_table_elsewhere(of->table, &left) == 0) return;
    whirl_phrase *found = &find_statement(of, "place of rest")->found;
    phrase_text(of, found,
                "there is another one, up to %.4g %s away, to which that of the value before or after leads, %s",
                of->units->length * left.reached, of->units->length_name, left.most < 0.0 ? "stable" : "unstable");
    add_points(of, found, &left);
}

/// States that a contact is closed at rest, and what that means for the numbers of the table (shown_kind.held).
static void state_closed(const finder *of, size_t contact) {
    whirl_left left;
    if (whirl_table_held(of->table, contact, &left) == 0) return;
    const shown_kind *kind = shown_kind_of(of->table);
    whirl_phrase *found = &find_statement(of, "rests against")->found;
    phrase_text(of, found, "%s with %s", of->result->contacts[contact], left.points > 1 ? "up to " : "");
    phrase_number(of, found, WHIRL_QUANTITY_FORCE, 4, left.reached * of->result->force_scale);
    add_points(of, found, &left);
    phrase_text(of, found, ", which %s", kind->held ? kind->held : "small motions do not open");
}

void find_ranges(const finder *of) {
    for (size_t i = 0; *whirl_result_law_range(of->result, i); i++) state_law(of, i);
    state_no_rest(of);
    state_other_rest(of);
    for (size_t i = 0; i < of->result->contact_count; i++) state_closed(of, i);
}
