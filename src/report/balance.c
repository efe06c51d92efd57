// What balancing found, for people and for programs.
#include "whirl/balance.h"

#include <math.h>
#include <stdio.h>

#include "document.h"

static const double degree = 3.14159265358979323846 / 180.0, rpm = 3.14159265358979323846 / 30.0, um = 1e-6,
                    gram_mm = 1e-6;

static double size_of(const double vector[2]) {
    return hypot(vector[0], vector[1]);
}

/// From 0 to 360 degrees, of `way` (1, -1) times the angle.
static double degrees_of(const double vector[2], double way) {
    const double angle = fmod(way * atan2(vector[1], vector[0]) / degree + 360.0, 360.0);
    return angle < 360.0 - 1e-9 ? angle : 0.0;
}

/// What is left of a vibration; 0 where that is rounding beside the largest.
static double left_of(const whirl_correction *found, const whirl_balance_row *row) {
    const double after = size_of(row->after);
    double largest = 0.0;
    for (size_t r = 0; r < found->row_count; r++) largest = fmax(largest, size_of(found->rows[r].before));
    return after > 1e-9 * largest && largest > 0.0 ? after : 0.0;
}

static double way_of_angles(const whirl_balance *of) {
    return of->against ? -1.0 : 1.0;
}

static double way_of_phases(const whirl_balance *of) {
    return of->leads ? 1.0 : -1.0;
}

// ---------------------------------------------------------------- for people

static void print_plane(FILE *out, const whirl_balance *of, size_t p, const double moment[2]) {
    const whirl_balance_plane *plane = &of->planes[p];
    fprintf(out, "  %s: %.6g g mm at %.4g deg", plane->name, size_of(moment) / gram_mm,
            degrees_of(moment, way_of_angles(of)));
    if (plane->radius > 0.0)
        fprintf(out, ", %.5g g at a radius of %.4g mm", 1e3 * size_of(moment) / plane->radius, 1e3 * plane->radius);
    if (plane->holes > 0) {
        int hole[2];
        double moments[2];
        whirl_balance_split(of, p, moment, hole, moments);
        fprintf(out, "; hole %d: %.6g g mm", hole[0], moments[0] / gram_mm);
        if (moments[1] > 0.0) fprintf(out, ", hole %d: %.6g g mm", hole[1], moments[1] / gram_mm);
    }
    fputc('\n', out);
}

/// The static part and the couple about the middle of two planes, half of the difference in each.
static void print_static(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    if (of->plane_count != 2) return;
    double sum[2], half[2];
    for (int c = 0; c < 2; c++) {
        sum[c] = found->moment[0][c] + found->moment[1][c];
        half[c] = 0.5 * (found->moment[0][c] - found->moment[1][c]);
    }
    fprintf(out, "  static: %.6g g mm at %.4g deg; couple: %.6g g mm at %.4g deg in %s, against it in %s\n",
            size_of(sum) / gram_mm, degrees_of(sum, way_of_angles(of)), size_of(half) / gram_mm,
            degrees_of(half, way_of_angles(of)), of->planes[0].name, of->planes[1].name);
}

whirl_status whirl_balance_write_summary(const whirl_balance *of, const whirl_correction *found, FILE *out) {
    if (*of->title) fprintf(out, "%s\n", of->title);
    fprintf(out, "angles are told %s the rotation from the mark, phases as %s\n", of->against ? "against" : "with",
            of->leads ? "leads" : "lags");
    fputs("influence, um a kg mm (amplitudes as the file has them):\n", out);
    for (size_t r = 0; r < found->row_count; r++) {
        const whirl_balance_row *row = &found->rows[r];
        fprintf(out, "  %s at %.6g rpm:", row->probe, row->speed / rpm);
        for (size_t p = 0; p < of->plane_count; p++)
            fprintf(out, "%s %.5g at %.4g deg (%s)", p ? "," : "", size_of(row->influence[p]) * 1e-3 / um,
                    degrees_of(row->influence[p], way_of_phases(of)), of->planes[p].name);
        fputc('\n', out);
    }
    fputs("correction:\n", out);
    for (size_t p = 0; p < of->plane_count; p++) print_plane(out, of, p, found->moment[p]);
    print_static(out, of, found);
    fputs("vibration before and, by the coefficients, after:\n", out);
    for (size_t r = 0; r < found->row_count; r++) {
        const whirl_balance_row *row = &found->rows[r];
        fprintf(out, "  %s at %.6g rpm: %.4g um at %.4g deg, %.4g um\n", row->probe, row->speed / rpm,
                size_of(row->before) / um, degrees_of(row->before, way_of_phases(of)), left_of(found, row) / um);
    }
    const double allowed = whirl_balance_allowed(of);
    if (isfinite(allowed))
        fprintf(
            out,
            "residual unbalance allowed in all by ISO 21940-11, grade G %.4g (check which edition counts): %.6g g mm\n",
            of->grade, allowed / gram_mm);
    return whirl_ok();
}

// ---------------------------------------------------------------- for programs

static json_t *vector(bool *well, const double of[2], const char *size, double way) {
    json_t *made = json_object();
    document_put(well, made, size, document_number(size_of(of)));
    document_put(well, made, "angle", document_number(degree * degrees_of(of, way)));
    return made;
}

static json_t *row_of(bool *well, const whirl_balance *of, const whirl_balance_row *row) {
    json_t *made = json_object(), *influence = json_object();
    document_put(well, made, "probe", document_text(row->probe));
    document_put(well, made, "speed", document_number(row->speed));
    document_put(well, made, "before", vector(well, row->before, "amplitude", way_of_phases(of)));
    document_put(well, made, "after", vector(well, row->after, "amplitude", way_of_phases(of)));
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(well, influence, of->planes[p].name,
                     vector(well, row->influence[p], "amplitude", way_of_phases(of)));
    document_put(well, made, "influence", influence);
    return made;
}

whirl_status whirl_balance_write_json(const whirl_balance *of, const whirl_correction *found, FILE *out) {
    bool well = true;
    json_t *all = json_object(), *planes = json_object(), *rows = json_array();
    document_put(&well, all, "title", document_text(of->title));
    document_put(&well, all, "angles", document_text(of->against ? "against" : "with"));
    document_put(&well, all, "phases", document_text(of->leads ? "lead" : "lag"));
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(&well, planes, of->planes[p].name, vector(&well, found->moment[p], "moment", way_of_angles(of)));
    document_put(&well, all, "correction", planes);
    for (size_t r = 0; r < found->row_count; r++) document_append(&well, rows, row_of(&well, of, &found->rows[r]));
    document_put(&well, all, "vibration", rows);
    document_put(&well, all, "allowed", document_number(whirl_balance_allowed(of)));
    if (document_write(well, all, out) && fputc('\n', out) != EOF) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON, or it cannot be written");
}
