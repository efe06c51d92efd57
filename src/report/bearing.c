// What was computed of a bearing, for people.
#include "whirl/engine/bearing_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180.0, rpm = 3.14159265358979323846 / 30.0, um = 1e-6,
                    zero_degrees = 273.15;

/// What bearings need not have.
static void print_more(const whirl_bearing *of, FILE *out) {
    static const char *const laws[] = {"", "Ng and Pan", "Constantinescu"};
    if (of->pads.turbulence != WHIRL_LAMINAR) fprintf(out, "turbulent, factors of %s\n", laws[of->pads.turbulence]);
    if (of->supply_pressure > 0.0)
        fprintf(out, "oil in the grooves at %.4g bar over %.3g of the length\n", 1e-5 * of->supply_pressure,
                of->pads.groove);
    if (of->pivot_stiffness > 0.0) fprintf(out, "pivots of %.4g MN/m along the radius\n", 1e-6 * of->pivot_stiffness);
    if (of->heated)
        fprintf(out,
                "the film is as warm as the mean of the oil that comes in and that which leaves, with %.3g %% of "
                "the power\n",
                100.0 * of->heat_share);
}

static void print_bearing(const whirl_bearing *of, FILE *out) {
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < of->pads.count; i++) {
        least = fmin(least, of->pads.pads[i].preload);
        most = fmax(most, of->pads.pads[i].preload);
    }
    if (*of->title) fprintf(out, "%s\n", of->title);
    fprintf(out, "%s: %zu %s pad%s, D %.6g mm, L %.6g mm (L/D %.4g), radial clearance %.6g um of the pads", of->kind,
            of->pads.count, of->pads.tilting ? "tilting" : "fixed", of->pads.count > 1 ? "s" : "", 2e3 * of->radius,
            1e3 * of->length, of->pads.ratio, of->pad_clearance / um);
    if (most != 0.0) fprintf(out, ", %.6g um of the bearing", of->clearance / um);
    if (least != most) fprintf(out, " (preloads %.4g to %.4g)", least, most);
    if (least == most && most != 0.0) fprintf(out, " (preload %.4g)", most);
    fprintf(out, "\nviscosity %.5g mPa s", 1e3 * of->viscosity);
    if (of->oil_count > 0)
        fprintf(out, " at %.4g degC%s", of->temperature - zero_degrees, of->heated ? ", where oil comes in" : "");
    fprintf(out, ", %s; load at %.5g deg from x towards y\n",
            of->pads.gumbel ? "pressures below 0 left out (Guembel)" : "film breaks without a slope (Reynolds)",
            of->load_angle / degree);
    print_more(of, out);
}

/// What rounding leaves of 0 has no sign.
static double degrees_of(double angle) {
    return fabs(angle) < 1e-9 ? 0.0 : angle / degree;
}

static void print_place(const whirl_bearing_point *point, FILE *out) {
    fprintf(out, "%10.6g %10.6g", point->speed / rpm, point->load);
}

static void print_states(const whirl_bearing_table *table, FILE *out) {
    const whirl_bearing *of = table->bearing;
    fputs("S = mu N D L (R/c)^2/W and e/c with the clearance of the pads; attitude from the load to the journal, with "
          "the rotation\n",
          out);
    fprintf(out, "%10s %10s %9s %8s %9s %8s %9s %9s %9s%s%s\n", "speed", "load", "S", "e/c", "attitude", "film",
            "pressure", "flow", "power", of->pads.tilting ? "" : "  crit. mass   whirl",
            of->heated ? "      film" : "");
    fprintf(out, "%10s %10s %9s %8s %9s %8s %9s %9s %9s%s%s\n", "rpm", "N", "1", "1", "deg", "um", "MPa", "l/min", "kW",
            of->pads.tilting ? "" : "          kg       1", of->heated ? "      degC" : "");
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        print_place(point, out);
        if (!point->found) {
            fprintf(out, "  not found: %s\n", point->failure);
            continue;
        }
        fprintf(out, " %9.4g %8.4f %9.2f %8.4g %9.4g %9.4g %9.4g", point->sommerfeld,
                point->eccentricity / of->pad_clearance, degrees_of(point->attitude), point->film / um,
                1e-6 * point->pressure, 6e4 * point->flow, 1e-3 * point->power);
        if (!of->pads.tilting && isfinite(point->critical_mass))
            fprintf(out, "  %10.5g  %6.4f", point->critical_mass, point->whirl);
        else if (!of->pads.tilting)
            fputs("        none       -", out);
        if (of->heated) fprintf(out, " %9.2f", point->temperature - zero_degrees);
        fputc('\n', out);
    }
}

static void print_coefficients(const whirl_bearing_table *table, size_t ratio, FILE *out) {
    static const char *const names[] = {"Kxx", "Kxy", "Kyx", "Kyy", "Cxx", "Cxy", "Cyx", "Cyy"};
    const whirl_bearing *of = table->bearing;
    fputs("stiffness (MN/m) and damping (kN s/m)", out);
    if (of->pads.tilting) fprintf(out, ", pads following at whirl ratio %.4g", of->ratios[ratio]);
    fprintf(out, ":\n%10s %10s", "rpm", "N");
    for (int k = 0; k < 8; k++) fprintf(out, " %9s", names[k]);
    fputc('\n', out);
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        if (!point->found) continue;
        print_place(point, out);
        for (int k = 0; k < 8; k++)
            fprintf(out, " %9.4g", point->reduced[ratio][k / 4][k / 2 % 2][k % 2] * (k < 4 ? 1e-6 : 1e-3));
        fputc('\n', out);
    }
}

static void print_errors(const whirl_bearing_table *table, FILE *out) {
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
    if (known)
        fprintf(
            out,
            "error, against a mesh half as fine: place %.2g um, stiffness %.2g %%, damping %.2g %% of the largest\n",
            place / um, 100.0 * stiffness, 100.0 * damping);
}

static void print_warnings(const whirl_bearing_table *table, FILE *out) {
    enum { MOST = 20 };
    size_t told = 0, left = 0;
    for (size_t k = 0; k < table->remark_count; k++) fprintf(out, "warning: %s\n", table->remarks[k]);
    for (size_t i = 0; i < table->count; i++) {
        const whirl_bearing_point *point = &table->points[i];
        for (size_t k = 0; k < point->remark_count; k++)
            if (told++ < MOST)
                fprintf(out, "warning at %.6g rpm, %.6g N: %s\n", point->speed / rpm, point->load, point->remarks[k]);
            else
                left++;
    }
    if (left) fprintf(out, "and %zu warnings more, which --json and --csv tell\n", left);
}

whirl_status whirl_bearing_write_summary(const whirl_bearing_table *table, FILE *out) {
    const whirl_bearing *of = table->bearing;
    print_bearing(of, out);
    print_states(table, out);
    for (size_t k = 0; k < (of->pads.tilting ? of->ratio_count : 1); k++) print_coefficients(table, k, out);
    print_errors(table, out);
    print_warnings(table, out);
    return whirl_ok();
}
