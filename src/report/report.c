// Writes a report: data and scripts, then the figures, then the pages.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "explorer.h"
#include "figure_kinds.h"
#include "findings_render.h"
#include "gnuplot.h"
#include "gnuplot_script.h"
#include "machine_at.h"
#include "page.h"
#include "print.h"
#include "report_file.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

/// Data of a report that is being made; report_free frees them.
typedef struct report {
    char (*folders)[FOLDER_NAME_SIZE];
    char (*paths)[FILE_PATH_SIZE];
    claim_outcome *outcomes;
    drawn_figures figures;
    whirl_shown_units *units;
    whirl_result **views;      ///< [count] results with a row for every attractor (whirl_result_by_attractor)
    whirl_findings **findings; ///< [count] findings of the views
    whirl_case **machines;     ///< [count] cases of the results (machine_of)
    size_t count;
} report;

static void report_free(report *made) {
    free(made->folders);
    free(made->paths);
    free(made->outcomes);
    free(made->figures.items);
    free(made->units);
    for (size_t r = 0; made->views && r < made->count; r++) whirl_result_view_free(made->views[r]);
    free((void *)made->views);
    for (size_t r = 0; made->findings && r < made->count; r++) whirl_findings_free(made->findings[r]);
    free((void *)made->findings);
    machines_free(made->machines, made->count);
}

/// Makes a unique folder name for every result.
static void name_folders(char (*folders)[FOLDER_NAME_SIZE], const char *const *names, size_t count) {
    for (size_t r = 0; r < count; r++) {
        char safe[FOLDER_NAME_SIZE - 24];
        safe_name(names[r], safe, sizeof safe);
        snprintf(folders[r], FOLDER_NAME_SIZE, "%s", safe);
        for (unsigned again = 2, taken = 1; taken; again++) {
            taken = 0;
            for (size_t k = 0; k < r; k++) taken |= strcmp(folders[k], folders[r]) == 0;
            if (taken) snprintf(folders[r], FOLDER_NAME_SIZE, "%s-%u", safe, again);
        }
    }
}

bool whirl_report_find(const char *const *names, size_t count, const char *directory,
                       const whirl_report_options *options, char *found, size_t size) {
    const struct {
        const char *name;
        bool written;
    } pages[] = {{"report.html", true},
                 {"explorer.html", options && options->explorer},
                 {"lateral.html", options && options->lateral},
                 {"lateral.pdf", options && options->lateral},
                 {"torsional.html", options && options->torsional},
                 {"torsional.pdf", options && options->torsional}};
    bool is_there = false;
    for (size_t i = 0; i < sizeof pages / sizeof *pages && !is_there; i++) {
        snprintf(found, size, "%s/%s", directory, pages[i].name);
        is_there = pages[i].written && report_file_there(found);
    }
    // Ignore missing memory: whirl_report_write will then fail before it writes anything.
    char(*folders)[FOLDER_NAME_SIZE] = calloc(count + 1, sizeof *folders);
    if (folders) name_folders(folders, names, count);
    for (size_t r = 0; folders && r < count && !is_there; r++) {
        snprintf(found, size, "%s/%s", directory, folders[r]);
        is_there = folder_holds_files(found);
    }
    free(folders);
    return is_there;
}

/// Writes a figure's data and script to the folder of its result.
static whirl_status write_figure(const char *folder, const whirl_figure *figure) {
    report_file file = {0};
    char name[FIGURE_FILE_SIZE];
    snprintf(name, sizeof name, "%s.dat", figure->name);
    whirl_status status = report_file_open(&file, folder, name);
    if (status.code != WHIRL_OK) return status;
    gnuplot_write_data(file.stream, figure);
    status = report_file_close(&file);
    if (status.code != WHIRL_OK) return status;
    snprintf(name, sizeof name, "%s.gp", figure->name);
    status = report_file_open(&file, folder, name);
    if (status.code != WHIRL_OK) return status;
    snprintf(name, sizeof name, "%s.dat", figure->name);
    gnuplot_write_script(file.stream, figure, figure->name, name, "png pdf");
    return report_file_close(&file);
}

/// Writes a figure and adds it to the list of the page.
static whirl_status draw_figure(report *made, const drawing *of, const figure_place *place, size_t result) {
    whirl_figure *figure;
    whirl_status status = figure_make(of, place, NULL, &figure);
    if (status.code != WHIRL_OK) return status;
    status = write_figure(made->paths[result], figure);
    drawn_figure *own = &made->figures.items[made->figures.count++];
    *own = (drawn_figure){.result = result, .table = place->table, .name = place->name, .whole = place->kind->whole};
    memcpy(own->caption, figure->caption, sizeof own->caption);
    whirl_figure_free(figure);
    return status;
}

static whirl_status draw_result(report *made, const whirl_result *result, size_t index) {
    const drawing of = {result, &made->units[index], made->machines[index]};
    figure_list list = {.count = 0};
    whirl_status status = folder_make_own(made->paths[index]);
    if (status.code == WHIRL_OK) status = figures_list(&of, &list);
    drawn_figure *items = realloc(made->figures.items, (made->figures.count + list.count + 1) * sizeof *items);
    if (items)
        made->figures.items = items;
    else if (status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu figures", list.count);
    for (size_t i = 0; i < list.count && status.code == WHIRL_OK; i++)
        status = draw_figure(made, &of, &list.items[i], index);
    free(list.items);
    return status;
}

static whirl_status write_figures(report *made, const whirl_result *const *results, size_t count,
                                  const char *directory) {
    for (size_t r = 0; r < count; r++) {
        const int length = snprintf(made->paths[r], FILE_PATH_SIZE, "%s/%s", directory, made->folders[r]);
        if (length < 0 || length >= FILE_PATH_SIZE)
            return whirl_fail(WHIRL_IO_ERROR, "the path %.200s... is too long", directory);
        whirl_status status = draw_result(made, results[r], r);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}

/// Runs all scripts. Each figure of the list then has a flag that it was drawn.
static whirl_status report_draw(report *made, const char *program) {
    const size_t count = made->figures.count;
    gnuplot_job *jobs = calloc(count + 1, sizeof *jobs);
    char(*scripts)[FIGURE_FILE_SIZE] = calloc(count + 1, sizeof *scripts);
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu figures", count);
    if (jobs && scripts) {
        for (size_t i = 0; i < count; i++) {
            const drawn_figure *what = &made->figures.items[i];
            snprintf(scripts[i], sizeof scripts[i], "%s.gp", what->name.name);
            jobs[i] = (gnuplot_job){made->paths[what->result], scripts[i], false};
        }
        status = gnuplot_run(program, jobs, count);
        for (size_t i = 0; i < count; i++) made->figures.items[i].drawn = jobs[i].drawn;
    }
    free(jobs);
    free(scripts);
    return status;
}

static void report_compare(report *made, const whirl_result *const *results, size_t count, const whirl_claims *claims) {
    for (size_t c = 0; c < claims->count; c++)
        for (size_t r = 0; r < count; r++)
            claim_compare(claims, &claims->items[c], results[r], &made->outcomes[c * count + r]);
}

/// Writes a document of an analysis, or (ANALYSES) the report.
static whirl_status write_page(const report *made, const whirl_result *const *results, const char *const *names,
                               size_t count, const char *directory, const whirl_report_options *options,
                               analysis_kind kind) {
    // Open the file: the report, or a document named after its kind.
    report_file file = {0};
    char name[64] = "report.html";
    if (kind != ANALYSES) snprintf(name, sizeof name, "%s.html", analysis_names[kind]);
    const whirl_status status = report_file_open(&file, directory, name);
    if (status.code != WHIRL_OK) return status;
    bool failed = false;
    // Collect the content of the page.
    const page to = {
        .stream = file.stream,
        .results = results,
        .names = names,
        .folders = (const char(*)[FOLDER_NAME_SIZE])made->folders,
        .count = count,
        .claims = options->claims,
        .outcomes = made->outcomes,
        .figures = &made->figures,
        .units = made->units,
        .findings = made->findings,
        .machines = (const whirl_case *const *)made->machines,
        .failed = &failed,
        .explorer = options->explorer != NULL,
        .printed = kind != ANALYSES,
    };
    // Write the page, and drop it if memory was missing.
    if (kind != ANALYSES)
        analysis_write(&to, kind);
    else
        page_write(&to);
    if (!failed) return report_file_close(&file);
    report_file_drop(&file);
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the page of a report");
}

/// Writes the page of an analysis, and the same page as a PDF. Fails with WHIRL_MISSING_PROGRAM without weasyprint.
static whirl_status write_analysis(const report *made, const whirl_result *const *results, const char *const *names,
                                   size_t count, const char *directory, const whirl_report_options *options,
                                   analysis_kind kind) {
    char from[64], to[64];
    snprintf(from, sizeof from, "%s.html", analysis_names[kind]);
    snprintf(to, sizeof to, "%s.pdf", analysis_names[kind]);
    const whirl_status status = write_page(made, results, names, count, directory, options, kind);
    return status.code == WHIRL_OK ? document_print(options->weasyprint, directory, from, to) : status;
}

static whirl_status report_make(report *made, const whirl_result *const *results, const char *const *names,
                                size_t count, const char *directory, const whirl_report_options *options) {
    whirl_status status = folder_make(directory);
    if (status.code == WHIRL_OK) status = write_figures(made, results, count, directory);
    if (status.code != WHIRL_OK) return status;
    const whirl_status drawn = report_draw(made, options->gnuplot);
    if (drawn.code == WHIRL_NO_MEMORY) return drawn;
    if (options->claims) report_compare(made, results, count, options->claims);
    status = write_page(made, results, names, count, directory, options, ANALYSES);
    if (status.code == WHIRL_OK && options->explorer)
        status = explorer_write(options->explorer, results, (const whirl_case *const *)made->machines, names, count,
                                directory, options->units);
    if (status.code == WHIRL_OK && options->lateral)
        status = write_analysis(made, results, names, count, directory, options, ANALYSIS_LATERAL);
    if (status.code == WHIRL_OK && options->torsional)
        status = write_analysis(made, results, names, count, directory, options, ANALYSIS_TORSIONAL);
    return status.code == WHIRL_OK ? drawn : status;
}

/// Makes the views of results.
static whirl_status view_results(report *made, const whirl_result *const *results) {
    whirl_status status = whirl_ok();
    for (size_t r = 0; r < made->count && status.code == WHIRL_OK; r++)
        status = whirl_result_by_attractor(results[r], &made->views[r]);
    return status;
}

whirl_status whirl_report_write(const whirl_result *const *results, const char *const *names, size_t count,
                                const char *directory, const whirl_report_options *options) {
    static const whirl_report_options none = {0};
    if (!options) options = &none;
    const size_t claims = options->claims ? options->claims->count : 0;
    report made = {
        .folders = calloc(count + 1, sizeof *made.folders),
        .paths = calloc(count + 1, sizeof *made.paths),
        .outcomes = calloc(claims * count + 1, sizeof *made.outcomes),
        .units = calloc(count + 1, sizeof *made.units),
        .views = calloc(count + 1, sizeof(whirl_result *)),
        .findings = calloc(count + 1, sizeof(whirl_findings *)),
        .count = count,
    };
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a report of %zu results", count);
    // Make views, cases, units and findings of all results, then the files.
    if (made.folders && made.paths && made.outcomes && made.units && made.views && made.findings)
        status = view_results(&made, results);
    if (status.code == WHIRL_OK) status = machines_of(results, count, &made.machines);
    for (size_t r = 0; r < count && status.code == WHIRL_OK; r++)
        status = whirl_result_shown_units(results[r], options->units, &made.units[r]);
    for (size_t r = 0; r < count && status.code == WHIRL_OK; r++)
        status = findings_of(made.views[r], &made.units[r], made.machines[r], &made.findings[r]);
    if (status.code == WHIRL_OK) {
        name_folders(made.folders, names, count);
        status = report_make(&made, (const whirl_result *const *)made.views, names, count, directory, options);
    }
    report_free(&made);
    return status;
}
