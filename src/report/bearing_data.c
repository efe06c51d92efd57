// Writes the result of a bearing as JSON, as CSV, and as an element of a case.
#include <math.h>
#include <stdio.h>

#include "document.h"
#include "findings_render.h"
#include "number_text.h"
#include "whirl/engine/descriptor.h"
#include "whirl/internal/bearing_table.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

static const double rpm = 3.14159265358979323846 / 30.0;

enum { FULL = 2 + 2 * WHIRL_MAX_PADS };

// ---------------------------------------------------------------- JSON

static json_t *matrix(bool *well, size_t size, size_t row_size, const double *of) {
    json_t *made = json_array();
    for (size_t r = 0; r < size; r++) {
        json_t *row = json_array();
        for (size_t c = 0; c < size; c++) document_append(well, row, document_number(of[r * row_size + c]));
        document_append(well, made, row);
    }
    return made;
}

/// Returns the warnings about a point, or about the table (point NULL).
static json_t *warnings_of(bool *well, const whirl_bearing *of, const char *units, const whirl_bearing_point *point,
                           const whirl_bearing_remark *remarks, size_t count) {
    char text[STATEMENT_SIZE];
    json_t *made = json_array();
    for (size_t i = 0; i < count; i++) {
        *well = bearing_remark_text(of, units, point, remarks[i], text) && *well;
        document_append(well, made, document_text(text));
    }
    return made;
}

static json_t *pads_of(bool *well, const whirl_bearing *of) {
    json_t *made = json_array();
    for (size_t i = 0; i < of->pads.count; i++) {
        const whirl_pad *pad = &of->pads.pads[i];
        json_t *one = json_object();
        document_put(well, one, "pivot", document_number(pad->pivot));
        document_put(well, one, "arc", document_number(pad->arc));
        document_put(well, one, "offset", document_number(pad->offset));
        document_put(well, one, "preload", document_number(pad->preload));
        document_append(well, made, one);
    }
    return made;
}

static void put_bearing(bool *well, json_t *all, const whirl_bearing *of) {
    static const char *const laws[] = {"none", "ng-pan", "constantinescu"};
    json_t *ratios = json_array();
    // Put geometry and pads.
    document_put(well, all, "title", document_text(of->title));
    document_put(well, all, "kind", document_text(of->kind));
    document_put(well, all, "tilting", json_boolean(of->pads.tilting));
    document_put(well, all, "cavitation", document_text(of->pads.gumbel ? "gumbel" : "reynolds"));
    document_put(well, all, "pads", pads_of(well, of));
    document_put(well, all, "radius", document_number(of->radius));
    document_put(well, all, "length", document_number(of->length));
    document_put(well, all, "pad_clearance", document_number(of->pad_clearance));
    document_put(well, all, "clearance", document_number(of->clearance));
    // Put oil, film model and supply.
    document_put(well, all, "viscosity", document_number(of->viscosity));
    document_put(well, all, "density", document_number(of->density));
    document_put(well, all, "temperature", document_number(of->temperature));
    document_put(well, all, "heated", json_boolean(of->heated));
    document_put(well, all, "heat_share", document_number(of->heat_share));
    document_put(well, all, "turbulence", document_text(laws[of->pads.turbulence]));
    document_put(well, all, "supply_pressure", document_number(of->supply_pressure));
    document_put(well, all, "groove", document_number(of->pads.groove));
    // Put inertia and pivots of tilting pads.
    document_put(well, all, "pad_inertia", document_number(of->inertia));
    document_put(well, all, "pivot_stiffness", document_number(of->pivot_stiffness > 0.0 ? of->pivot_stiffness : NAN));
    document_put(well, all, "pivot_damping", document_number(of->pivot_damping));
    document_put(well, all, "pad_mass", document_number(of->pad_mass));
    document_put(well, all, "load_angle", document_number(of->load_angle));
    document_put(well, all, "fineness", json_integer(of->pads.fineness));
    // Put the whirl frequency ratios for reduced coefficients.
    for (size_t i = 0; i < of->ratio_count; i++) document_append(well, ratios, document_number(of->ratios[i]));
    document_put(well, all, "whirl_ratios", ratios);
}

static json_t *both(bool *well, const double (*of)[2][2]) {
    json_t *made = json_object();
    document_put(well, made, "stiffness", matrix(well, 2, 2, of[0][0]));
    document_put(well, made, "damping", matrix(well, 2, 2, of[1][0]));
    return made;
}

/// Writes the full stiffness (which 0) or damping (1) matrix for x, y (m), tilts (rad) and, if pivots are elastic,
/// pivot displacements (m). The film of a pad depends on (x, y) - R tilt t - displacement n, with t along the pad and n
/// outwards. unit: factor from the film's dimensionless coefficients to SI. pivot: stiffness or damping of a pivot in
/// SI, added on the diagonal of its displacement.
static void fill_full(const whirl_bearing *of, const whirl_bearing_point *point, int which, double unit, double pivot,
                      double *out) {
    const size_t pads = of->pads.count, moves = of->pivot_stiffness > 0.0 ? 2 : 1;
    for (size_t i = 0; i < (size_t)FULL * FULL; i++) out[i] = 0.0;
    for (size_t i = 0; i < pads; i++) {
        const double angle = of->pads.pads[i].pivot;
        // Journal displacement seen by the pad for unit x, y, tilt and pivot displacement.
        const double by[4][2] = {
            {1.0, 0.0}, {0.0, 1.0}, {of->radius * sin(angle), -of->radius * cos(angle)}, {-cos(angle), -sin(angle)}};
        const size_t at[] = {0, 1, 2 + i, 2 + pads + i};
        for (size_t r = 0; r < 2 + moves; r++)
            for (size_t c = 0; c < 2 + moves; c++)
                for (int k = 0; k < 4; k++)
                    out[at[r] * FULL + at[c]] +=
                        by[r][k / 2] * unit * point->state.of_pads[i][which][k / 2][k % 2] * by[c][k % 2];
        if (moves == 2) out[at[3] * FULL + at[3]] += pivot;
    }
}

static void put_tilting(bool *well, json_t *made, const whirl_bearing *of, const whirl_bearing_point *point) {
    // Scale of forces: mu N L R (R/c)^2 with the speed in rad/s.
    const double force = point->viscosity * point->speed * of->radius * of->length * (of->radius / of->pad_clearance) *
                         (of->radius / of->pad_clearance);
    json_t *reduced = json_array(), *pads = json_array(), *full = json_object();
    double matrices[2][FULL * FULL];
    // Put coefficients of the journal alone, with pads that follow at each whirl ratio.
    for (size_t i = 0; i < of->ratio_count; i++) {
        json_t *one = both(well, point->reduced[i]);
        document_put(well, one, "whirl_ratio", document_number(of->ratios[i]));
        document_append(well, reduced, one);
    }
    document_put(well, made, "reduced", reduced);
    // Put the full matrices, with coordinates of the pads.
    const size_t size = 2 + (of->pivot_stiffness > 0.0 ? 2 : 1) * of->pads.count;
    fill_full(of, point, 0, force / of->pad_clearance, of->pivot_stiffness, matrices[0]);
    fill_full(of, point, 1, force / (of->pad_clearance * point->speed), of->pivot_damping, matrices[1]);
    document_put(well, full, "stiffness", matrix(well, size, FULL, matrices[0]));
    document_put(well, full, "damping", matrix(well, size, FULL, matrices[1]));
    document_put(well, made, "full", full);
    // Put load and position of each pad.
    for (size_t i = 0; i < of->pads.count; i++) {
        json_t *one = json_object();
        document_put(well, one, "load", document_number(force * point->state.load[i]));
        document_put(well, one, "tilt", document_number(point->tilt[i]));
        document_put(well, one, "yield", document_number(point->yield[i]));
        document_put(well, one, "loaded", json_boolean(point->state.loaded[i]));
        document_append(well, pads, one);
    }
    document_put(well, made, "pads", pads);
}

static json_t *point_of(bool *well, const whirl_bearing *of, const char *units, const whirl_bearing_point *point) {
    json_t *made = json_object(), *error = json_object(), *place = json_array();
    // Put the speed, the load and whether an equilibrium was found.
    document_put(well, made, "speed", document_number(point->speed));
    document_put(well, made, "load", document_number(point->load));
    document_put(well, made, "sommerfeld", document_number(point->sommerfeld));
    document_put(well, made, "found", json_boolean(point->found));
    document_put(well, made, "failure", document_text(point->failure));
    // Put the journal's place, and film, flow and power there.
    for (int k = 0; k < 2; k++)
        document_append(well, place, document_number(point->found ? of->pad_clearance * point->state.at[k] : NAN));
    document_put(well, made, "place", place);
    document_put(well, made, "eccentricity", document_number(point->eccentricity));
    document_put(well, made, "eccentricity_ratio", document_number(point->eccentricity / of->pad_clearance));
    document_put(well, made, "attitude", document_number(point->attitude));
    document_put(well, made, "film", document_number(point->film));
    document_put(well, made, "pressure", document_number(point->pressure));
    document_put(well, made, "flow", document_number(point->flow));
    document_put(well, made, "power", document_number(point->power));
    document_put(well, made, "heating", document_number(point->heating));
    document_put(well, made, "viscosity", document_number(point->viscosity));
    document_put(well, made, "temperature", document_number(point->temperature));
    document_put(well, made, "outlet", document_number(point->outlet));
    document_put(well, made, "reynolds", document_number(point->reynolds));
    // Put coefficients and the limit of stability.
    document_put(well, made, "stiffness", matrix(well, 2, 2, point->reduced[0][0][0]));
    document_put(well, made, "damping", matrix(well, 2, 2, point->reduced[0][1][0]));
    if (of->pads.tilting && point->found) put_tilting(well, made, of, point);
    document_put(well, made, "critical_mass", document_number(point->critical_mass));
    document_put(well, made, "critical_whirl_ratio", document_number(point->whirl));
    // Put estimated errors and warnings.
    document_put(well, error, "place", document_number(point->error_place));
    document_put(well, error, "stiffness", document_number(point->error_stiffness));
    document_put(well, error, "damping", document_number(point->error_damping));
    document_put(well, made, "error", error);
    document_put(well, made, "warnings", warnings_of(well, of, units, point, point->remarks, point->remark_count));
    return made;
}

whirl_status whirl_bearing_write_json(const whirl_bearing_table *table, const char *units, FILE *out) {
    bool well = true;
    whirl_findings *findings;
    const whirl_status status = whirl_bearing_findings(table, units, &findings);
    if (status.code != WHIRL_OK) return status;
    json_t *all = json_object(), *points = json_array();
    put_bearing(&well, all, table->bearing);
    for (size_t i = 0; i < table->count; i++)
        document_append(&well, points, point_of(&well, table->bearing, units, &table->points[i]));
    document_put(&well, all, "points", points);
    document_put(&well, all, "warnings",
                 warnings_of(&well, table->bearing, units, NULL, table->remarks, table->remark_count));
    document_put(&well, all, "statements", statements_json(&well, findings));
    document_put(&well, all, "sheets", sheets_json(&well, findings));
    whirl_findings_free(findings);
    if (document_write(well, all, out) && fputc('\n', out) != EOF) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON, or it cannot be written");
}

// ---------------------------------------------------------------- CSV

static void bearing_put_number(FILE *out, double value, const char *end) {
    char text[NUMBER_SIZE] = "";
    if (isfinite(value)) number_text(value, text);
    fprintf(out, "%s%s", text, end);
}

whirl_status whirl_bearing_write_csv(const whirl_bearing_table *table, const char *units, FILE *out) {
    // Remarks are written in the units in which results are shown, numbers in SI.
    whirl_shown_units shown;
    const whirl_status status = whirl_shown_units_alone(units ? units : table->bearing->units, &shown);
    if (status.code != WHIRL_OK) return status;
    const whirl_bearing *of = table->bearing;
    char text[STATEMENT_SIZE];
    // Write the names of the columns.
    fputs("speed (rad/s),load (N),sommerfeld,eccentricity ratio,attitude (rad),x (m),y (m),film (m),pressure (Pa),"
          "flow (m3/s),power (W),kxx (N/m),kxy (N/m),kyx (N/m),kyy (N/m),cxx (N s/m),cxy (N s/m),cyx (N s/m),"
          "cyy (N s/m),critical mass (kg),error of place (m),error of stiffness,error of damping,"
          "viscosity (Pa s),temperature (K),warnings\n",
          out);
    for (size_t i = 0; i < table->count; i++) {
        // Write the numbers of each point.
        const whirl_bearing_point *point = &table->points[i];
        const double c = point->found ? of->pad_clearance : NAN;
        const double row[] = {point->speed,
                              point->load,
                              point->sommerfeld,
                              point->eccentricity / of->pad_clearance,
                              point->attitude,
                              c * point->state.at[0],
                              c * point->state.at[1],
                              point->film,
                              point->pressure,
                              point->flow,
                              point->power};
        for (size_t k = 0; k < sizeof row / sizeof *row; k++) bearing_put_number(out, row[k], ",");
        for (int k = 0; k < 8; k++) bearing_put_number(out, point->reduced[0][k / 4][k / 2 % 2][k % 2], ",");
        bearing_put_number(out, point->critical_mass, ",");
        bearing_put_number(out, point->error_place, ",");
        bearing_put_number(out, point->error_stiffness, ",");
        bearing_put_number(out, point->error_damping, ",");
        bearing_put_number(out, point->viscosity, ",");
        bearing_put_number(out, point->temperature, ",");
        // Write failure and remarks in the last column.
        fprintf(out, "\"%s", point->failure);
        for (size_t k = 0; k < point->remark_count; k++) {
            if (!bearing_remark_text(of, units, point, point->remarks[k], text))
                return whirl_fail(WHIRL_NO_MEMORY, "no memory for the warnings of a bearing");
            fprintf(out, "%s%s", k ? "; " : "", text);
        }
        fputs("\"\n", out);
    }
    return ferror(out) ? whirl_fail(WHIRL_IO_ERROR, "a table of a bearing cannot be written") : whirl_ok();
}

// ---------------------------------------------------------------- an element

static whirl_status check_table(const whirl_bearing_table *table) {
    const whirl_bearing *of = table->bearing;
    if (!of->pairs && of->load_count != 1)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "an element has one load a speed, and there are %zu: expected one load, or combine: pairs",
                          of->load_count);
    if (table->count > WHIRL_MAX_LIST)
        return whirl_fail(WHIRL_BAD_INPUT, "an element has up to %d speeds, and there are %zu", WHIRL_MAX_LIST,
                          table->count);
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        if (!point->found)
            return whirl_fail(WHIRL_BAD_INPUT, "at %.6g rpm there are no coefficients: %.200s", point->speed / rpm,
                              point->failure);
        if (i > 0 && !(point->speed > table->points[i - 1].speed))
            return whirl_fail(WHIRL_BAD_INPUT, "speeds do not rise: %.6g rpm after %.6g rpm", point->speed / rpm,
                              table->points[i - 1].speed / rpm);
    }
    return whirl_ok();
}

/// Writes rising whirl frequencies from 0 to the highest speed to out [WHIRL_MAX_LIST], and returns their number. All
/// computed speeds are among them, so that synchronous coefficients are exact.
static size_t frequencies_of(const whirl_bearing_table *table, double *out) {
    enum { EVEN = 12 };
    const double top = table->points[table->count - 1].speed;
    const size_t even = table->count + EVEN <= WHIRL_MAX_LIST ? EVEN : WHIRL_MAX_LIST - table->count;
    size_t count = 0, next = 0;
    for (size_t i = 0; i < even; i++) {
        const double frequency = top * (double)i / (double)EVEN;
        for (; next < table->count && table->points[next].speed <= frequency; next++)
            out[count++] = table->points[next].speed;
        if (count == 0 || frequency > out[count - 1] * 1.001) out[count++] = frequency;
    }
    for (; next < table->count; next++) out[count++] = table->points[next].speed;
    return count;
}

static void put_list(FILE *out, const char *name, const double *numbers, size_t count) {
    fprintf(out, "        %s: [", name);
    for (size_t i = 0; i < count; i++) bearing_put_number(out, numbers[i], i + 1 < count ? ", " : "]\n");
}

/// Writes the table of coefficient k: for each speed a list over the frequencies.
static void put_sheet(FILE *out, const whirl_bearing_table *table, const double *frequencies, size_t count, int k) {
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        fputs(i > 0 ? ",\n              [" : table->count > 1 ? "[[" : "[", out);
        for (size_t f = 0; f < count; f++) {
            double all[2][2][2];
            whirl_bearing_reduced(table->bearing, point, frequencies[f] / point->speed, all);
            bearing_put_number(out, all[k / 4][k / 2 % 2][k % 2], f + 1 < count ? ", " : "]");
        }
    }
    fputs(table->count > 1 ? "]\n" : "\n", out);
}

static void put_coefficients(FILE *out, const whirl_bearing_table *table, bool over_frequency) {
    static const char *const names[] = {"kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"};
    double frequencies[WHIRL_MAX_LIST], speeds[WHIRL_MAX_LIST];
    const size_t count = over_frequency ? frequencies_of(table, frequencies) : 0;
    for (size_t i = 0; i < table->count; i++) speeds[i] = table->points[i].speed;
    if (table->count > 1) put_list(out, "speeds", speeds, table->count);
    if (count > 0) put_list(out, "frequencies", frequencies, count);
    for (int k = 0; k < 8; k++) {
        fprintf(out, "        %s: %s", names[k], count == 0 && table->count > 1 ? "[" : "");
        if (count > 0) put_sheet(out, table, frequencies, count, k);
        for (size_t i = 0; i < table->count && count == 0; i++)
            bearing_put_number(out, table->points[i].reduced[0][k / 4][k / 2 % 2][k % 2],
                               i + 1 < table->count ? ", "
                               : i > 0              ? "]\n"
                                                    : "\n");
    }
}

whirl_status whirl_bearing_write_element(const whirl_bearing_table *table, const char *station, bool over_frequency,
                                         FILE *out) {
    const whirl_bearing *of = table->bearing;
    const whirl_status status = check_table(table);
    if (status.code != WHIRL_OK) return status;
    const bool over = over_frequency && of->pads.tilting;
    fprintf(out, "    # %s bearing by `whirl bearing`%s; SI, in rad/s, N/m and N s/m\n    - bearing:\n        at: %s\n",
            of->kind,
            over               ? ", over the frequency of whirl"
            : of->pads.tilting ? ", pads following at one whirl ratio"
                               : "",
            station);
    put_coefficients(out, table, over);
    if (of->pads.tilting && !over) {
        fputs("        whirl_ratio: ", out);
        bearing_put_number(out, of->ratios[0], "\n");
    }
    return ferror(out) ? whirl_fail(WHIRL_IO_ERROR, "an element of a bearing cannot be written") : whirl_ok();
}
