// Findings of a single bearing: geometry, journal position, coefficients, errors and warnings.
#include "whirl/internal/bearing_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "findings_build.h"
#include "findings_render.h"
#include "taylor_vortices.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

static const double degree = 3.14159265358979323846 / 180.0;

/// Converts to degrees; rounding residues become exactly 0 (no minus sign).
static double degrees_of(double angle) {
    return fabs(angle) < 1e-9 ? 0.0 : angle / degree;
}

// ---------------------------------------------------------------- warnings

/// Lists the pads that carry no load at a point, "2, 3"; returns their number.
static size_t name_idle_pads(const whirl_bearing *of, const whirl_bearing_point *point, char *text, size_t size) {
    size_t idle = 0;
    *text = '\0';
    for (size_t i = 0; i < of->pads.count; i++) {
        if (!whirl_bearing_pad_idle(point, i)) continue;
        snprintf(text + strlen(text), size - strlen(text), "%s%zu", idle++ ? ", " : "pad", i + 1);
    }
    return idle;
}

/// Writes a temperature rise, in K or in degrees of the chosen scale.
static void phrase_warming(const finder *of, whirl_phrase *phrase, double kelvins) {
    const whirl_unit *scale = &of->units->of[WHIRL_QUANTITY_TEMPERATURE];
    whirl_unit unit = {"K", scale->size};
    if (scale->size != 1.0) unit = *scale;
    phrase_unit(of, phrase, &unit, 3, kelvins);
}

static void phrase_flow(const finder *of, const whirl_bearing *bearing, const whirl_bearing_point *point,
                        whirl_bearing_remark remark, whirl_phrase *phrase) {
    const double taylor = whirl_bearing_taylor(bearing, point), first = FIRST_VORTICES;
    if (remark == WHIRL_FILM_NOT_LAMINAR)
        phrase_text(of, phrase,
                    "the film is not laminar: Taylor's number is %.3g, above %.3g (Reynolds number %.4g); these "
                    "results are for a laminar film: add turbulence: ng-pan",
                    taylor, first, point->reynolds);
    else if (remark == WHIRL_FILM_LAMINAR)
        phrase_text(of, phrase,
                    "the film is laminar: Taylor's number is %.3g, below %.3g, but factors of turbulence are applied: "
                    "remove turbulence",
                    taylor, first);
    else if (remark == WHIRL_FILM_BETWEEN)
        phrase_text(of, phrase,
                    "the film is between laminar and turbulent: Taylor's number is %.3g, between %.3g and twice that, "
                    "where factors of turbulence are uncertain by a tenth",
                    taylor, first);
    else
        phrase_text(of, phrase, "the Reynolds number is %.3g, and factors of turbulence are for up to %.3g",
                    point->reynolds, WHIRL_MAX_REYNOLDS);
}

static void phrase_oil(const finder *of, const whirl_bearing *bearing, const whirl_bearing_point *point,
                       whirl_phrase *phrase) {
    phrase_text(of, phrase, "the film is at ");
    phrase_number(of, phrase, WHIRL_QUANTITY_TEMPERATURE, 4, point->temperature);
    phrase_text(of, phrase, ", and the viscosity of its oil is known from ");
    phrase_number(of, phrase, WHIRL_QUANTITY_TEMPERATURE, 4, bearing->oil_temperatures[0]);
    phrase_text(of, phrase, " to ");
    phrase_number(of, phrase, WHIRL_QUANTITY_TEMPERATURE, 4, bearing->oil_temperatures[bearing->oil_count - 1]);
}

static void phrase_idle(const finder *of, const whirl_bearing *bearing, const whirl_bearing_point *point,
                        whirl_phrase *phrase) {
    char pads[100];
    const bool several = name_idle_pads(bearing, point, pads, sizeof pads) > 1;
    const char *const names = pads + strlen("pad");
    if (bearing->pads.tilting)
        phrase_text(of, phrase, "no film holds pad%s %s: free to flutter, reported with a tilt of 0 and no stiffness",
                    several ? "s" : "", names);
    else
        phrase_text(of, phrase, "pad%s %s carr%s nothing", several ? "s" : "", names, several ? "y" : "ies");
}

/// Writes a warning about a point, or about the bearing as a whole (point NULL).
static void phrase_remark(const finder *of, const whirl_bearing *bearing, const whirl_bearing_point *point,
                          whirl_bearing_remark remark, whirl_phrase *phrase) {
    // Remarks on one point: film, oil, mesh, pads.
    switch (remark) {
    case WHIRL_FILM_THIN:
        phrase_text(of, phrase, "the film is ");
        phrase_number(of, phrase, WHIRL_QUANTITY_LENGTH, 3, point->film);
        phrase_text(of, phrase, " thin, below ");
        phrase_number(of, phrase, WHIRL_QUANTITY_LENGTH, 3, bearing->least_film);
        return;
    case WHIRL_OIL_WARMS:
        phrase_text(of, phrase, "the power would warm the leaving oil by ");
        phrase_warming(of, phrase, point->heating);
        phrase_text(of, phrase, ": is the viscosity that of the warm film?");
        return;
    case WHIRL_OIL_UNKNOWN:
        phrase_oil(of, bearing, point, phrase);
        return;
    case WHIRL_MESH_COARSE:
        phrase_text(of, phrase, "coefficients differ by %.2g %% on a mesh half as fine",
                    100.0 * fmax(point->error_stiffness, point->error_damping));
        return;
    case WHIRL_PADS_IDLE:
        phrase_idle(of, bearing, point, phrase);
        return;
    // Remarks on the bearing as a whole.
    case WHIRL_LENGTH_UNUSUAL:
        phrase_text(of, phrase, "length over diameter is %.3g, and bearings have 0.1 to 2 of it", bearing->pads.ratio);
        return;
    case WHIRL_CLEARANCE_UNUSUAL:
        phrase_text(of, phrase,
                    "the radial clearance of the pads is %.3g times the radius, and bearings have 0.0003 to 0.005 of "
                    "it: is it radial, and in the right unit?",
                    bearing->pad_clearance / bearing->radius);
        return;
    default:
        phrase_flow(of, bearing, point, remark, phrase);
    }
}

static void phrase_place(const finder *of, whirl_phrase *phrase, const whirl_bearing_point *point) {
    phrase_number(of, phrase, WHIRL_QUANTITY_SPEED, 6, point->speed);
    phrase_text(of, phrase, ", ");
    phrase_number(of, phrase, WHIRL_QUANTITY_FORCE, 6, point->load);
}

static void find_warnings(const finder *of, const whirl_bearing_table *table) {
    for (size_t k = 0; k < table->remark_count; k++)
        phrase_remark(of, table->bearing, NULL, table->remarks[k], &find_statement(of, "warning")->found);
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        for (size_t k = 0; k < point->remark_count; k++) {
            whirl_statement *own = find_statement(of, "warning");
            phrase_place(of, &own->at, point);
            phrase_remark(of, table->bearing, point, point->remarks[k], &own->found);
        }
    }
}

// ---------------------------------------------------------------- the bearing

static void find_shape(const finder *of, const whirl_bearing *bearing) {
    // Find the range of preloads.
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < bearing->pads.count; i++) {
        least = fmin(least, bearing->pads.pads[i].preload);
        most = fmax(most, bearing->pads.pads[i].preload);
    }
    // Describe pads, diameter, length and clearances.
    whirl_phrase *phrase = &find_statement(of, "bearing")->found;
    phrase_text(of, phrase, "%s: %zu %s pad%s, D ", bearing->kind, bearing->pads.count,
                bearing->pads.tilting ? "tilting" : "fixed", bearing->pads.count > 1 ? "s" : "");
    phrase_number(of, phrase, WHIRL_QUANTITY_DIAMETER, 6, 2.0 * bearing->radius);
    phrase_text(of, phrase, ", L ");
    phrase_number(of, phrase, WHIRL_QUANTITY_DIAMETER, 6, bearing->length);
    phrase_text(of, phrase, " (L/D %.4g), radial clearance ", bearing->pads.ratio);
    phrase_number(of, phrase, WHIRL_QUANTITY_LENGTH, 6, bearing->pad_clearance);
    phrase_text(of, phrase, " of the pads");
    // With preload, the clearance of the bearing is not that of its pads.
    if (most != 0.0) {
        phrase_text(of, phrase, ", ");
        phrase_number(of, phrase, WHIRL_QUANTITY_LENGTH, 6, bearing->clearance);
        phrase_text(of, phrase, " of the bearing");
    }
    if (least != most) phrase_text(of, phrase, " (preloads %.4g to %.4g)", least, most);
    if (least == most && most != 0.0) phrase_text(of, phrase, " (preload %.4g)", most);
    phrase_text(of, phrase, "; load at %.5g deg from x towards y", degrees_of(bearing->load_angle));
}

static void find_oil(const finder *of, const whirl_bearing *bearing) {
    static const char *const laws[] = {"", "Ng and Pan", "Constantinescu"};
    // State the viscosity, and the temperature for which it is known.
    whirl_phrase *phrase = &find_statement(of, "oil")->found;
    phrase_text(of, phrase, "viscosity ");
    phrase_number(of, phrase, WHIRL_QUANTITY_VISCOSITY, 5, bearing->viscosity);
    if (bearing->oil_count > 0) {
        phrase_text(of, phrase, " at ");
        phrase_number(of, phrase, WHIRL_QUANTITY_TEMPERATURE, 4, bearing->temperature);
        if (bearing->heated) phrase_text(of, phrase, ", where oil comes in");
    }
    // State pressure and size of supply grooves.
    if (bearing->supply_pressure > 0.0) {
        phrase = &find_statement(of, "grooves")->found;
        phrase_text(of, phrase, "oil at ");
        phrase_number(of, phrase, WHIRL_QUANTITY_PRESSURE, 4, bearing->supply_pressure);
        phrase_text(of, phrase, " over %.3g of the length", bearing->pads.groove);
    }
    // State where the film ends, its turbulence and its heat balance.
    phrase = &find_statement(of, "film")->found;
    phrase_text(of, phrase,
                bearing->pads.gumbel ? "pressures below 0 left out (Guembel)"
                                     : "ends where the pressure gradient is 0 (Reynolds)");
    if (bearing->pads.turbulence != WHIRL_LAMINAR)
        phrase_text(of, phrase, "; turbulent, factors of %s", laws[bearing->pads.turbulence]);
    if (bearing->heated)
        phrase_text(of, phrase,
                    "; at the mean temperature of entering and leaving oil, which carries %.3g %% of the power",
                    100.0 * bearing->heat_share);
    // State the stiffness of the pads' pivots.
    if (bearing->pivot_stiffness > 0.0) {
        phrase = &find_statement(of, "pivots")->found;
        phrase_number(of, phrase, WHIRL_QUANTITY_STIFFNESS, 4, bearing->pivot_stiffness);
        phrase_text(of, phrase, " along the radius");
    }
}

static void find_pads(const finder *of, const whirl_bearing *bearing) {
    whirl_sheet *sheet = find_sheet(of, "pads", "Pads");
    sheet_column(of, sheet, "pad", "pad", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(of, sheet, "pivot", "pivot", WHIRL_QUANTITY_DEGREES, 5);
    sheet_column(of, sheet, "arc", "arc", WHIRL_QUANTITY_DEGREES, 5);
    sheet_column(of, sheet, "offset", "share of the arc before the pivot", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "preload", "preload", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t i = 0; i < bearing->pads.count; i++) {
        const whirl_pad *pad = &bearing->pads.pads[i];
        sheet_row(of, sheet);
        cell_number(of, sheet, (double)i + 1.0);
        cell_number(of, sheet, degrees_of(pad->pivot));
        cell_number(of, sheet, degrees_of(pad->arc));
        cell_number(of, sheet, pad->offset);
        cell_number(of, sheet, pad->preload);
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- over load and speed

static void sheet_place(const finder *of, whirl_sheet *sheet) {
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(of, sheet, "load", "load", WHIRL_QUANTITY_FORCE, 6);
}

static void cells_place(const finder *of, whirl_sheet *sheet, const whirl_bearing_point *point) {
    sheet_row(of, sheet);
    cell_number(of, sheet, point->speed);
    cell_number(of, sheet, point->load);
}

static void find_rest(const finder *of, const whirl_bearing_table *table) {
    const whirl_bearing *bearing = table->bearing;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "rest", "Where the journal rests");
    sheet->about = "S = mu N D L (R/c)^2/W and e/c with the clearance of the pads; attitude from the load to the "
                   "journal, with the rotation; above the critical mass a rigid rotor whirls by itself.";
    sheet_place(of, sheet);
    sheet_column(of, sheet, "sommerfeld", "S", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "eccentricity_ratio", "e/c", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "attitude", "attitude", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(of, sheet, "film", "film", WHIRL_QUANTITY_LENGTH, 4);
    sheet_column(of, sheet, "pressure", "pressure", WHIRL_QUANTITY_PRESSURE, 4);
    sheet_column(of, sheet, "flow", "flow", WHIRL_QUANTITY_FLOW, 4);
    sheet_column(of, sheet, "power", "power", WHIRL_QUANTITY_POWER, 4);
    sheet_column(of, sheet, "critical_mass", "critical mass", WHIRL_QUANTITY_MASS, 5);
    sheet_column(of, sheet, "critical_whirl_ratio", "whirl ratio", WHIRL_QUANTITY_NUMBER, 4);
    sheet_column(of, sheet, "temperature", "film at", WHIRL_QUANTITY_TEMPERATURE, 4);
    sheet_texts(of, sheet, "failure", "not found");
    // Add a row for each pair of speed and load.
    char failure[SENTENCE_SIZE];
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        const double mass = bearing->pads.tilting ? (double)NAN : point->critical_mass;
        cells_place(of, sheet, point);
        cell_number(of, sheet, point->sommerfeld);
        cell_number(of, sheet, point->eccentricity / bearing->pad_clearance);
        cell_number(of, sheet, degrees_of(point->attitude));
        cell_number(of, sheet, point->film);
        cell_number(of, sheet, point->pressure);
        cell_number(of, sheet, point->flow);
        cell_number(of, sheet, point->power);
        cell_number(of, sheet, mass);
        cell_number(of, sheet, isfinite(mass) ? point->whirl : (double)NAN);
        cell_number(of, sheet, bearing->heated ? point->temperature : (double)NAN);
        whirl_shown_sentence(of->units, point->failure, failure, sizeof failure);
        cell_text(of, sheet, find_text(of->findings, "%s", failure));
    }
    find_sheet_end(of);
}

static void find_coefficients(const finder *of, const whirl_bearing_table *table) {
    static const char *const names[] = {"Kxx", "Kxy", "Kyx", "Kyy", "Cxx", "Cxy", "Cyx", "Cyy"};
    const whirl_bearing *bearing = table->bearing;
    const size_t ratios = bearing->pads.tilting ? bearing->ratio_count : 1;
    whirl_sheet *sheet = find_sheet(of, "coefficients", "Stiffness and damping");
    if (bearing->pads.tilting) sheet->about = "Tilting pads follow the whirl of the journal at the whirl ratio.";
    sheet_place(of, sheet);
    if (bearing->pads.tilting) sheet_column(of, sheet, "whirl_ratio", "whirl ratio", WHIRL_QUANTITY_NUMBER, 4);
    sheet_coefficients(of, sheet, names);
    for (size_t r = 0; r < ratios; r++)
        for (size_t i = 0; i < table->count; i++) {
            const whirl_bearing_point *point = &table->points[i];
            if (!point->found) continue;
            cells_place(of, sheet, point);
            if (bearing->pads.tilting) cell_number(of, sheet, bearing->ratios[r]);
            for (size_t k = 0; k < 8; k++) cell_number(of, sheet, point->reduced[r][k / 4][k / 2 % 2][k % 2]);
        }
    find_sheet_end(of);
}

/// States the number of points without a critical mass: there a rigid rotor of any mass is stable.
static void find_stable(const finder *of, const whirl_bearing_table *table) {
    size_t found = 0, stable = 0;
    for (size_t i = 0; i < table->count; i++) {
        found += table->points[i].found;
        stable += table->points[i].found && isinf(table->points[i].critical_mass);
    }
    if (!table->bearing->pads.tilting && stable > 0)
        phrase_text(of, &find_statement(of, "critical mass")->found,
                    "none at %zu of %zu points: a rigid rotor of any mass is stable there", stable, found);
}

static void find_errors(const finder *of, const whirl_bearing_table *table) {
    double place = 0.0, stiffness = 0.0, damping = 0.0;
    size_t known = 0;
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        if (isnan(point->error_place)) continue;
        known++;
        place = fmax(place, point->error_place);
        stiffness = fmax(stiffness, point->error_stiffness);
        damping = fmax(damping, point->error_damping);
    }
    if (known == 0) return;
    whirl_phrase *phrase = &find_statement(of, "error, against a mesh half as fine")->found;
    phrase_text(of, phrase, "place ");
    phrase_number(of, phrase, WHIRL_QUANTITY_LENGTH, 2, place);
    phrase_text(of, phrase, ", stiffness ");
    phrase_number(of, phrase, WHIRL_QUANTITY_PERCENT, 2, 100.0 * stiffness);
    phrase_text(of, phrase, ", damping ");
    phrase_number(of, phrase, WHIRL_QUANTITY_PERCENT, 2, 100.0 * damping);
    phrase_text(of, phrase, " of the largest");
}

// ---------------------------------------------------------------- all

static const whirl_table bearing_alone = {.name = "bearing"};

whirl_status whirl_bearing_findings(const whirl_bearing_table *table, const char *units, whirl_findings **findings) {
    whirl_shown_units shown;
    *findings = NULL;
    const whirl_status status = whirl_shown_units_alone(units ? units : table->bearing->units, &shown);
    if (status.code != WHIRL_OK) return status;
    const finder of = {find_begin(), &shown, NULL, &bearing_alone, NULL};
    if (of.findings) {
        find_shape(&of, table->bearing);
        find_oil(&of, table->bearing);
        find_stable(&of, table);
        find_errors(&of, table);
        find_warnings(&of, table);
        find_pads(&of, table->bearing);
        find_rest(&of, table);
        find_coefficients(&of, table);
    }
    return find_made(of.findings, findings);
}

bool bearing_remark_text(const whirl_bearing *bearing, const char *units, const whirl_bearing_point *point,
                         whirl_bearing_remark remark, char text[STATEMENT_SIZE]) {
    whirl_shown_units shown;
    whirl_phrase phrase = {0};
    *text = '\0';
    if (whirl_shown_units_alone(units ? units : bearing->units, &shown).code != WHIRL_OK) return false;
    const finder of = {find_begin(), &shown, NULL, &bearing_alone, NULL};
    if (!of.findings) return false;
    phrase_remark(&of, bearing, point, remark, &phrase);
    const bool well = !of.findings->failed;
    if (well) whirl_phrase_text(&phrase, text, STATEMENT_SIZE);
    whirl_findings_free(of.findings);
    return well;
}
