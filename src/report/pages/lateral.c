// The page of a lateral analysis: machine, model, critical speeds, modes, responses with their margins, stability, and
// the nonlinear motions beside them, with what was found first.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "machine_at.h"
#include "margins.h"
#include "motions_told.h"
#include "page.h"
#include "regimes.h"
#include "scaled.h"
#include "shown_kinds.h"
#include "whirl/case.h"

static const double rpm = 0.104719755119659774;

/// What is done with every table of a kind.
typedef void each_table(const page *to, size_t result, const whirl_table *table, void *context);

static void for_each(const page *to, const char *field, each_table *act, void *context) {
    for (size_t r = 0; r < to->count; r++)
        for (size_t t = 0; t < to->results[r]->table_count; t++) {
            const whirl_table *table = &to->results[r]->tables[t];
            if (table->count > 0 && whirl_layout_field(&table->layout, field)) act(to, r, table, context);
        }
}

static void count_table(const page *to, size_t result, const whirl_table *table, void *context) {
    (void)to, (void)result, (void)table;
    ++*(size_t *)context;
}

static size_t count_tables(const page *to, const char *field) {
    size_t count = 0;
    for_each(to, field, count_table, &count);
    return count;
}

// ---------------------------------------------------------------- what was found

static void begin_sentence(const page *to, const char *what) {
    fprintf(to->stream, "<li><strong>%s.</strong> ", what);
}

static void end_sentence(const page *to) {
    fputs("</li>\n", to->stream);
}

/// Critical speeds with damping, as far as modes were followed over the speed.
static void tell_critical(const page *to, size_t result, const whirl_table *table, void *context) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t *const told = context;
    size_t found = 0;
    (void)result;
    html_printf(to->stream, "%s%s: ", (*told)++ ? "; " : "", table->name);
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (row[0] >= 1.0 && row[0] <= 3.0)
                html_printf(to->stream, "%s%s%.5g rpm", found++ ? ", " : "",
                            row[0] < 1.5   ? ""
                            : row[0] < 2.5 ? "unstable from "
                                           : "stable from ",
                            row[2] / rpm);
    }
    if (!found) html_printf(to->stream, "none between the speeds that were looked at");
}

/// Peaks with margins, of all responses.
typedef struct peak_count {
    size_t told, held, tables;
    char worst[512]; ///< the first that fails
} peak_count;

static void count_peaks(const page *to, size_t result, const whirl_table *table, void *context) {
    peak_count *const all = context;
    margin_row rows[2 * MARGIN_PEAKS];
    all->tables += table->record.running_low > 0.0 || table->record.running_high > 0.0;
    for (size_t s = 0; s < to->results[result]->station_count; s++) {
        const size_t count = margin_rows(to->results[result], table, &to->units[result], s, rows);
        for (const margin_row *row = rows; row < rows + count; row++) {
            all->told += row->told;
            all->held += row->told && row->holds;
            if (row->told && !row->holds && !*all->worst)
                snprintf(all->worst, sizeof all->worst, "%s at %s, %.5g %s, amplification %.3g: %.100s", table->name,
                         to->results[result]->stations[s].name, row->speed, margin_speed_unit(&to->units[result]).name,
                         row->amplification, row->text);
        }
    }
}

/// The clearance of which scaled responses take most.
typedef struct tightest {
    bool any;
    double share;
    scaled_row row;
    char where[256];
} tightest;

static void find_tightest(const page *to, size_t result, const whirl_table *table, void *context) {
    tightest *const found = context;
    const whirl_result *own = to->results[result];
    scaled by;
    scaled_row *rows = calloc(own->station_count + 1, sizeof *rows);
    const size_t count = rows && scaled_of(own, table, &by) ? scaled_rows(own, table, &by, rows) : 0;
    for (size_t i = 0; i < count; i++) {
        const double share = rows[i].axis / rows[i].clearance;
        if (found->any && share <= found->share) continue;
        *found = (tightest){.any = true, .share = share, .row = rows[i]};
        snprintf(found->where, sizeof found->where, "%s (%s)", own->stations[rows[i].station].name, table->name);
    }
    free(rows);
}

/// The least decrement of the whole machine.
typedef struct least_decrement {
    double complete, decrement, ratio;
    size_t without; ///< points that have no mode
    const char *where;
} least_decrement;

static void find_decrement(const page *to, size_t result, const whirl_table *table, void *context) {
    least_decrement *const found = context;
    (void)to, (void)result;
    for (size_t point = 0; point < table->count; point++) {
        const double complete = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_COMPLETE, 0);
        found->without += whirl_table_done(table, point) && isnan(complete);
        if (!whirl_table_done(table, point) || !(complete < found->complete)) continue;
        found->complete = complete;
        found->decrement = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_DECREMENT, 0);
        found->ratio = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_LIMIT, 0) /
                       whirl_table_number(table, point, WHIRL_FIELD_STABILITY_ANTICIPATED, 0);
        found->where = table->name;
    }
}

/// What the motions of the machine do to clearances, and what stands beside them.
static void tell_motions(const page *to, size_t result, const whirl_table *table, void *context) {
    size_t *const told = context;
    char text[MOTIONS_TOLD_SIZE];
    whirl_case *machine = machine_of(to->results[result]);
    motions_told(machine, to->results[result], table, text);
    html_printf(to->stream, "%s%s: %s", (*told)++ ? " " : "", table->name, text);
    whirl_case_free(machine);
}

static void write_found(const page *to) {
    peak_count peaks = {.told = 0};
    tightest close = {.any = false};
    least_decrement least = {.complete = INFINITY};
    size_t told = 0;
    fputs("<section id=\"found\">\n<h2>1. What was found</h2>\n<ol>\n", to->stream);
    begin_sentence(to, "Critical speeds with damping");
    for_each(to, WHIRL_FIELD_MODES_CRITICAL, tell_critical, &told);
    fputs(told ? "." : "Not looked for (study: modes over the speed).", to->stream);
    end_sentence(to);
    begin_sentence(to, "Separation margins");
    for_each(to, WHIRL_FIELD_UNBALANCE_PROBE, count_peaks, &peaks);
    if (peaks.tables == 0)
        fputs("Not told: no response to unbalance has its running speeds (running_from, running_to).", to->stream);
    else if (peaks.told == 0)
        fputs("No peak has an amplification of 2.5 or more: no margin is asked for.", to->stream);
    else if (peaks.told == peaks.held)
        html_printf(to->stream, "All %zu peaks of which a margin is asked for have it.", peaks.told);
    else
        html_printf(to->stream, "%zu of %zu peaks lack the margin that is asked for; first %s.",
                    peaks.told - peaks.held, peaks.told, peaks.worst);
    end_sentence(to);
    begin_sentence(to, "Clearances");
    for_each(to, WHIRL_FIELD_UNBALANCE_CLEARANCE, find_tightest, &close);
    if (close.any)
        html_printf(
            to->stream,
            "Responses scaled to the vibration limit take at most %.3g %% of a diametral clearance, at %s at %.5g "
            "rpm, 75 %% allowed: %s.",
            100.0 * close.share, close.where, close.row.speed / rpm, close.row.holds ? "holds" : "fails");
    else
        fputs("Not told: no station with a clearance, or no running speeds with points between them.", to->stream);
    end_sentence(to);
    begin_sentence(to, "Stability");
    for_each(to, WHIRL_FIELD_STABILITY_COMPLETE, find_decrement, &least);
    if (isfinite(least.complete)) {
        html_printf(to->stream,
                    "The least logarithmic decrement is %.3g with seals and impellers (%s), %.3g with bearings "
                    "and stages",
                    least.complete, least.where, least.decrement);
        if (least.ratio == 0.0)
            fputs(", below 0 without any cross coupling", to->stream);
        else if (isfinite(least.ratio))
            html_printf(to->stream, ", whose cross coupling is at its limit when it is %.3g times as large",
                        least.ratio);
        fputs(least.complete > 0.1 ? "; above 0.1: holds." : "; not above 0.1: fails.", to->stream);
        if (least.without > 0) html_printf(to->stream, " At %zu points there is no such mode.", least.without);
    } else if (least.without > 0) {
        fputs("No mode was found that does not go backward.", to->stream);
    } else {
        fputs("Not looked for (study: stability).", to->stream);
    }
    end_sentence(to);
    begin_sentence(to, "Nonlinear motions");
    told = 0;
    for_each(to, WHIRL_FIELD_REGIME_CODE, tell_motions, &told);
    if (!told) fputs("Not computed (study: motions beside these).", to->stream);
    end_sentence(to);
    fputs("</ol>\n</section>\n", to->stream);
}

// ---------------------------------------------------------------- chapters

static void write_table(const page *to, size_t result, const whirl_table *table, void *context) {
    const shown_kind *kind = shown_kind_of(table);
    char fact[2 * WHIRL_NAME_SIZE];
    (void)context;
    snprintf(fact, sizeof fact, "%s with", table->name);
    const char *with = whirl_result_fact(to->results[result], fact);
    fputs("<h3>", to->stream);
    html_printf(to->stream, "%s%s%s", table->name, *with ? ", with " : "", with);
    fputs("</h3>\n", to->stream);
    for (size_t i = 0; i < to->figures->count; i++)
        if (to->figures->items[i].table == table) page_figure(to, &to->figures->items[i]);
    if (kind && kind->section && (*table->parameter || kind->single)) kind->section(to, result, table);
}

/// A chapter is of all tables that have a field.
typedef struct chapter {
    const char *title, *about, *field;
} chapter;

static const chapter chapters[] = {
    {"Weight and loads of bearings",
     "The weight carried by each bearing, sag and bending moments; what elevations couplings ask for.",
     WHIRL_FIELD_STATICS_LOAD},
    {"Undamped critical speed map",
     "Critical speeds of the machine without damping, over the stiffness of its supports where the study says so.",
     WHIRL_FIELD_CRITICAL_SPEEDS_SPEED},
    {"Damped modes",
     "Natural frequencies over the speed (Campbell diagram), critical speeds with damping, thresholds of stability, "
     "and "
     "shapes.",
     WHIRL_FIELD_MODES_FREQUENCY},
    {"Response to unbalance",
     "Amplitudes and lags that probes see, amplification factors and separation margins of the peaks, and responses "
     "scaled "
     "to the vibration limit beside clearances.",
     WHIRL_FIELD_UNBALANCE_AMPLITUDE},
    {"Stability", "Logarithmic decrements with bearings, stages, seals and impellers.", WHIRL_FIELD_STABILITY_BASIC},
    {"Nonlinear motions", "Motions in the real films with contacts, computed in time and judged.",
     WHIRL_FIELD_REGIME_CODE},
};
enum { CHAPTERS = sizeof chapters / sizeof *chapters, FIRST_CHAPTER = 3 };

static void write_chapter(const page *to, size_t index) {
    const chapter *own = &chapters[index];
    fprintf(to->stream, "<section id=\"chapter-%zu\">\n<h2>%zu. %s</h2>\n<p>%s</p>\n", index, index + FIRST_CHAPTER,
            own->title, own->about);
    if (count_tables(to, own->field) > 0)
        for_each(to, own->field, write_table, NULL);
    else
        fputs("<p>Not asked for.</p>\n", to->stream);
    fputs("</section>\n", to->stream);
}

// ---------------------------------------------------------------- machine and model

static void write_stations(const page *to, const whirl_result *result) {
    html_table(to->stream, "Stations", "");
    fputs("<thead><tr><th>station</th><th class=\"number\">position along its shaft (m)</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        fputs("<tr><th>", to->stream);
        html_text(to->stream, station->name);
        fputs("</th>", to->stream);
        if (station->shaft > 0)
            fprintf(to->stream, "<td class=\"number\">%.6g</td></tr>\n", station->position);
        else
            fputs("<td>on no shaft of finite elements</td></tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
}

static void write_shafts(const page *to, const whirl_case *machine) {
    whirl_shaft_summary shafts[WHIRL_MAX_SHAFTS];
    size_t count = 0;
    if (!machine || whirl_case_shafts(machine, shafts, &count).code != WHIRL_OK) return;
    for (const whirl_shaft_summary *shaft = shafts; shaft < shafts + count; shaft++) {
        fputs("<p>", to->stream);
        html_printf(to->stream, "Shaft %s: %.6g m, %.6g kg, %zu finite elements (Timoshenko) between %zu nodes",
                    shaft->name, shaft->length, shaft->mass, shaft->elements, shaft->nodes);
        if (shaft->reduced)
            html_printf(
                to->stream,
                ", reduced to its stations and %zu of %zu modes a plane: frequencies of the free shaft err by %.1g, "
                "displacements by forces by %.1g",
                shaft->modes, shaft->all_modes, shaft->frequency_error, shaft->flexibility_error);
        fputs(".</p>\n", to->stream);
    }
}

static void write_machine(const page *to) {
    fputs("<section id=\"machine\">\n<h2>2. Machine and model</h2>\n", to->stream);
    for (size_t r = 0; r < to->count; r++) {
        const whirl_result *result = to->results[r];
        whirl_case *machine = machine_of(result);
        fputs("<h3>", to->stream);
        html_text(to->stream, *result->title ? result->title : to->names[r]);
        fputs("</h3>\n", to->stream);
        for (size_t i = 0; *whirl_result_warning(result, i); i++) {
            fputs("<p><strong>Warning:</strong> ", to->stream);
            html_text(to->stream, whirl_result_warning(result, i));
            fputs("</p>\n", to->stream);
        }
        write_shafts(to, machine);
        write_stations(to, result);
        page_parameters(to, r);
        whirl_case_free(machine);
    }
    fputs("</section>\n", to->stream);
}

// ---------------------------------------------------------------- the whole

static void write_appendix(const page *to) {
    fprintf(to->stream, "<section id=\"appendix\">\n<h2>%d. Appendix</h2>\n", CHAPTERS + FIRST_CHAPTER);
    fputs("<p>Clauses are those of API 617 as whirl's documentation has them; which edition counts is for the user to "
          "check. Amplitudes say whether they are zero to peak (0-p) or peak to peak (p-p).</p>\n",
          to->stream);
    for (size_t r = 0; r < to->count; r++) {
        page_computed(to, r);
        page_provenance(to, r);
        if (!to->results[r]->case_text) continue;
        fputs("<h3>The case</h3>\n<pre class=\"whole-case\">", to->stream);
        html_text(to->stream, to->results[r]->case_text);
        fputs("</pre>\n", to->stream);
    }
    fputs("</section>\n", to->stream);
}

void lateral_write(const page *to) {
    char title[512];
    const char *of = to->count == 1 && *to->results[0]->title ? to->results[0]->title : to->names[0];
    snprintf(title, sizeof title, "Lateral analysis: %.400s", to->count > 0 ? of : "");
    page_head(to, title);
    fputs("<p class=\"soft\">Written by whirl.</p>\n</header>\n<main>\n", to->stream);
    write_found(to);
    write_machine(to);
    for (size_t i = 0; i < CHAPTERS; i++) write_chapter(to, i);
    write_appendix(to);
    fputs("</main>\n</body>\n</html>\n", to->stream);
}
