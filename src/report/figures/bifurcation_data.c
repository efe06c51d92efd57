// The data files of bifurcation diagrams: the dots of the section, and a line a point of the sweep.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bifurcation.h"
#include "quantities.h"

enum {
    GRID = 2000,        ///< dots nearer to each other than 1/GRID of the axis are written once
    MOST_DOTS = 100000, ///< of a figure, so that its PDF stays small
    LEAST_DOTS = 64     ///< of a point
};

/// A dot on the grid of the figure, and where in the section it comes from.
typedef struct dot {
    int x, y;
    size_t row;
} dot;

static int by_place(const void *left, const void *right) {
    const dot *a = left, *b = right;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    if (a->y != b->y) return a->y < b->y ? -1 : 1;
    return (a->row > b->row) - (a->row < b->row);
}

static int cell(double value, span range) {
    return (int)fmin(fmax(GRID * (value - range.low) / (range.high - range.low), -1.0), GRID + 1.0);
}

static void write_dots(FILE *data, const bifurcation *of, size_t point, dot *dots) {
    const numbers section = point_section(of->table, point, of->station);
    const size_t share = MOST_DOTS / (of->table->count + 1), most = share > LEAST_DOTS ? share : LEAST_DOTS;
    const size_t count = section.rows < most ? section.rows : most;
    const double length = whirl_shown_length(of->units, of->table, point), own = length / of->length;
    for (size_t k = 0; k < count; k++) {
        const size_t row = section.rows - count + k;
        dots[k] = (dot){cell(length * section.at[4 * row], of->x), cell(length * section.at[4 * row + 1], of->y), row};
    }
    qsort(dots, count, sizeof *dots, by_place);
    for (size_t k = 0; k < count; k++) {
        if (k > 0 && dots[k].x == dots[k - 1].x && dots[k].y == dots[k - 1].y) continue;
        const double *at = &section.at[4 * dots[k].row];
        fprintf(data, "%.10g %.7g %.7g\n", of->table->values[point], own * at[0], own * at[1]);
    }
}

whirl_status bifurcation_write_section(const drawing *to, const bifurcation *of, const char *name) {
    report_file file;
    const size_t rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_POINCARE_SECTION)->rows;
    dot *dots = malloc((rows + 1) * sizeof *dots);
    if (!dots) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the dots of a bifurcation diagram");
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) {
        free(dots);
        return status;
    }
    fprintf(file.stream, "# parameter (SI)  x  y (lengths in %.10g m); dots that coincide in print stand once\n",
            of->result->length_scale);
    for (size_t kind = 0; kind < bifurcation_kinds(of); kind++) {
        char kind_name[WHIRL_NAME_SIZE];
        if (!of->present[kind]) continue;
        bifurcation_kind_name(of, kind, kind_name);
        for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
            fprintf(file.stream, "\n\n# %s%s\n", kind_name,
                    of->both ? branch > 0 ? ", from the first value on" : ", from the last value on" : "");
            fprintf(file.stream, "nan nan nan\n"); // keeps the count of the blocks where a block is empty
            for (size_t i = 0; i < of->table->count; i++) {
                if (!whirl_table_done(of->table, i)) continue;
                const int side = of->table->branch[i] < 0 ? -1 : 1;
                if (bifurcation_kind(of, i) == kind && side == branch) write_dots(file.stream, of, i, dots);
            }
        }
    }
    free(dots);
    return report_file_close(&file);
}

static void write_sweep_line(FILE *data, const bifurcation *of, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(of->table, point);
    const whirl_estimate exponent = point_exponent(of->table, point);
    fprintf(data, "%.10g %d %d %.6g %.3g %.6g", of->table->values[point], (int)regime_class_of(&verdict),
            (int)verdict.confidence, exponent.value, exponent.error,
            rub_share(of->table, point, of->result->contact_count));
    const double own = whirl_shown_length(of->units, of->table, point) / of->length;
    for (size_t s = 0; s < of->result->station_count; s++)
        fprintf(data, " %.7g", own * max_radius(of->table, point, s));
    double low, high;
    bifurcation_edges(of, point, &low, &high);
    fprintf(data, " %.10g %.10g", low, high);
    if (of->table->attractors)
        fprintf(data, " %zu %.6g %.3g", of->table->attractors[point].number, 100.0 * of->table->attractors[point].share,
                100.0 * of->table->attractors[point].error);
    fputc('\n', data);
}

whirl_status bifurcation_write_sweep(const drawing *to, const bifurcation *of) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, "sweep.dat");
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream,
            "# parameter (SI)  class  confidence (0 low, 1 fair, 2 high)  exponent (1/revolution)  its error  "
            "rub share");
    for (size_t s = 0; s < of->result->station_count; s++)
        fprintf(file.stream, "  largest radius of station %zu (%.10g m)", s + 1, of->result->length_scale);
    fputs("  half-way to the points beside it (SI), below and above", file.stream);
    if (of->table->attractors) fputs("  attractor  share of the starts (%)  its error", file.stream);
    fprintf(file.stream, "\n# classes:");
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(file.stream, " %d %s;", kind, regime_class_name((regime_class)kind));
    fputc('\n', file.stream);
    for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
        bool any = false;
        size_t before = 0, last = 0;
        for (size_t i = 0; i < of->table->count; i++) {
            if ((of->table->branch[i] < 0 ? -1 : 1) != branch) continue;
            if (!whirl_table_done(of->table, i)) continue;
            const size_t slot = whirl_table_slot(of->table, i);
            if (any && (slot != before + 1 || of->table->branch[i] != of->table->branch[last]))
                fputc('\n', file.stream);
            write_sweep_line(file.stream, of, i);
            any = true;
            before = slot;
            last = i;
        }
        fputs("\n\n", file.stream);
    }
    return report_file_close(&file);
}
