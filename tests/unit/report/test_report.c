// Whole reports: what files there are, hostile names and titles, missing fields, a missing gnuplot.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <ftw.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "regimes.h"
#include "sample.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

/// Makes a folder for the test, which is the working folder while it runs.
static int enter_folder(void **state) {
    static char folder[64];
    snprintf(folder, sizeof folder, "/tmp/whirl-report-XXXXXX");
    *state = folder;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int remove_one(const char *path, const struct stat *found, int type, struct FTW *where) {
    (void)found, (void)type, (void)where;
    return remove(path);
}

static int remove_folder(void **state) {
    const int left = chdir("/");
    return left == 0 ? nftw(*state, remove_one, 8, FTW_DEPTH | FTW_PHYS) : -1;
}

static long size_of(const char *path) {
    struct stat found;
    return stat(path, &found) == 0 ? (long)found.st_size : -1;
}

/// Returns the file as a string; freed by the caller.
static char *contents(const char *path) {
    const long size = size_of(path);
    FILE *stream = fopen(path, "r");
    if (!stream || size < 0) fail_msg("%s cannot be read", path);
    char *text = sample_take((size_t)size + 1, 1);
    assert_int_equal(fread(text, 1, (size_t)size, stream), size);
    fclose(stream);
    return text;
}

static void assert_contains_text(const char *path, const char *part) {
    char *text = contents(path);
    if (!strstr(text, part)) fail_msg("'%s' is not in %s", part, path);
    free(text);
}

static void assert_lacks(const char *path, const char *part) {
    char *text = contents(path);
    if (strstr(text, part)) fail_msg("'%s' is in %s", part, path);
    free(text);
}

static bool is_png(const char *path) {
    unsigned char first[8] = {0};
    FILE *stream = fopen(path, "r");
    const bool read = stream && fread(first, 1, sizeof first, stream) == sizeof first;
    if (stream) fclose(stream);
    return read && memcmp(first, "\x89PNG\r\n\x1a\n", 8) == 0;
}

static bool gnuplot_there(void) {
    return system("gnuplot --version >/dev/null 2>&1") == 0;
}

static whirl_status report_one(const whirl_result *result, const char *name, const whirl_report_options *options) {
    return whirl_report_write(&result, &name, 1, "out", options);
}

static const whirl_claim sample_claims[] = {
    {.where = "Fig. 4",
     .says = "P-1 <b>",
     .from = 0.6,
     .to = 0.6,
     .has_regime = true,
     .regime = WHIRL_PERIODIC,
     .period = 1},
    {.where = "Fig. 5", .says = "always chaotic", .from = 0.0, .to = 1.0, .has_regime = true, .regime = WHIRL_CHAOTIC},
};

static whirl_figure *figure_of(const whirl_result *result, const char *name) {
    whirl_figure *figure;
    const whirl_status status = whirl_figure_new(result, name, NULL, &figure);
    assert_string_equal(status.message, "");
    return figure;
}

static const whirl_panel *panel_of(const whirl_figure *figure, const char *name) {
    for (size_t i = 0; i < figure->count; i++)
        if (strcmp(figure->panels[i]->name, name) == 0) return figure->panels[i];
    fail_msg("%s has no panel %s", figure->name, name);
    return NULL;
}

/// Checks that a panel has a point in a series of that shape and colour.
static void assert_point(const whirl_panel *panel, whirl_shape shape, const char *colour, double x, double y) {
    for (size_t i = 0; i < panel->count; i++) {
        const whirl_series *one = panel->series[i];
        for (size_t k = 0; k < one->count && one->shape == shape && strcmp(one->colour, colour) == 0; k++)
            if (fabs(one->x[k] - x) < 1e-9 && fabs(one->y[k] - y) < 1e-9) return;
    }
    fail_msg("%s has no %s point at %g, %g", panel->name, colour, x, y);
}

static void assert_box(const whirl_panel *panel, const char *colour, double low, double high, double top) {
    for (size_t i = 0; i < panel->count; i++) {
        const whirl_series *one = panel->series[i];
        for (size_t k = 0; k < one->count && one->shape == WHIRL_BOXES && strcmp(one->colour, colour) == 0; k++)
            if (fabs(one->x[k] - low) < 1e-9 && fabs(one->x_to[k] - high) < 1e-9 && one->y_to[k] == top) return;
    }
    fail_msg("%s has no %s box from %g to %g", panel->name, colour, low, high);
}

static void everything_is_written(void **state) {
    (void)state;
    if (!gnuplot_there()) skip();
    whirl_claim items[2];
    memcpy(items, sample_claims, sizeof items);
    const whirl_claims claims = {
        .source = "A paper", .parameter = "r_k", .station = "disc", .count = 2, .items = items};
    const whirl_report_options options = {.claims = &claims};
    whirl_result *result = sample_result();
    const whirl_status status = report_one(result, "made", &options);
    assert_string_equal(status.message, "");
    assert_int_equal(status.code, WHIRL_OK);
    static const char *const stems[] = {"bifurcation-disc", "bifurcation-journal", "r_k-0.6-disc",
                                        "r_k-0.6-journal",  "r_k-0.25-disc",       "r_k-0.25-journal"};
    for (size_t i = 0; i < sizeof stems / sizeof *stems; i++) {
        char path[128];
        snprintf(path, sizeof path, "out/made/%s.png", stems[i]);
        assert_true(is_png(path));
        snprintf(path, sizeof path, "out/made/%s.pdf", stems[i]);
        assert_true(size_of(path) > 1000 && size_of(path) < 3000000);
        snprintf(path, sizeof path, "out/made/%s.gp", stems[i]);
        assert_contains_text(path, "pdfcairo");
        snprintf(path, sizeof path, "out/made/%s.gp.log", stems[i]); // gnuplot had nothing to say
        assert_int_equal(size_of(path), -1);
    }
    assert_contains_text("out/report.html", "src=\"made/r_k-0.25-journal.png\"");
    assert_contains_text("out/report.html", "P-1 &lt;b&gt;");
    assert_contains_text("out/report.html", "What was not reproduced");
    assert_contains_text("out/report.html", "No result fully meets 1 of the 2 claims.");
    assert_contains_text("out/report.html", "chaotic at 18.2 % of 11 points"); // 2 of 11
    whirl_result_free(result);
}

/// The disc reaches a stator at 1.2, the journal has none: figures and texts show the first and not the second.
static void gaps_are_shown_where_they_are(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    assert_contains_text("out/made/bifurcation-disc.gp", "set label 'gap'");
    assert_contains_text("out/made/bifurcation-disc.dat", " 1.2\n");
    assert_lacks("out/made/bifurcation-journal.gp", "'gap'");
    assert_contains_text("out/report.html", "disc (stator at 1.2 c)");
    assert_contains_text("out/report.html", "radius / gap");
    const double *radius = whirl_table_field(&result->tables[1], 0, "orbit/max_radius", 0);
    char ratio[32];
    snprintf(ratio, sizeof ratio, ">%.4f<", *radius / 1.2);
    assert_contains_text("out/report.html", ratio);
    for (size_t s = 0; s < 2; s++) result->stations[s].gap = 0.0;
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    assert_lacks("out/made/bifurcation-disc.gp", "'gap'");
    assert_lacks("out/report.html", "radius / gap");
    whirl_result_free(result);
}

/// Stators near the orbit, far from it, and around it are drawn as the caption says.
static void stators_near_the_orbit_are_drawn(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    const double reach = *whirl_table_field(&result->tables[1], 0, "orbit/max_radius", 0);
    static const struct {
        double share;
        bool shown;
    } gaps[] = {{1.0, true}, {0.95, true}, {1.05, true}, {30.0, false}};
    for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++) {
        result->stations[0].gap = gaps[i].share * reach;
        assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
        whirl_figure *figure = figure_of(result, "r_k-0.6-disc");
        const whirl_panel *orbit = panel_of(figure, "orbit");
        bool dashed = false;
        for (size_t k = 0; k < orbit->count; k++) dashed = dashed || orbit->series[k]->dashed;
        assert_true(dashed == gaps[i].shown);
        whirl_figure_free(figure);
        char *page = contents("out/report.html");
        const char *caption = strstr(page, "r_k = 0.6, disc: P-1. (a) waveform");
        assert_non_null(caption);
        const char *end = strstr(caption, "</figcaption>"), *stator = strstr(caption, "(dashed: stator)");
        assert_true(gaps[i].shown == (stator && stator < end));
        free(page);
    }
    whirl_result_free(result);
}

/// A run that stopped after four points of the sweep has a report.
static void partial_results_say_so(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    whirl_table *sweep = &result->tables[0];
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    sweep->done = sample_take(sweep->count, 1);
    memset(sweep->done, 1, 4);
    for (size_t i = 4 * sweep->layout.size; i < sweep->count * sweep->layout.size; i++) sweep->blocks[i] = (double)NAN;
    result->tables[1].done = sample_take(2, 1);
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    assert_contains_text("out/report.html", "when 4 of 13 points were done");
    assert_contains_text("out/report.html", "P-1 from 1 to 0.7");
    assert_lacks("out/made/bifurcation-disc.gp", "undetermined'");
    assert_int_equal(size_of("out/made/r_k-0.6-disc.gp"), -1);
    whirl_result_free(result);
}

/// The confidence of every verdict stands under the diagram, in the data and in the table of points.
static void confidence_is_shown(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    whirl_table *sweep = &result->tables[0], *detail = &result->tables[1];
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    for (size_t i = 0; i < sweep->count; i++) *sample_field(sweep, i, "regime/confidence", 0) = (double)(i % 3);
    *sample_field(detail, 0, "regime/confidence", 0) = WHIRL_HIGH;
    *sample_field(detail, 0, "regime/other_code", 0) = WHIRL_PERIODIC;
    *sample_field(detail, 0, "regime/other_period", 0) = 3;
    *sample_field(detail, 1, "regime/confidence", 0) = WHIRL_LOW;
    *sample_field(detail, 1, "regime/advice", 0) = WHIRL_LONGER_TRANSIENT;
    *sample_field(detail, 1, "regime/advice_factor", 0) = 2;
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    whirl_figure *figure = figure_of(result, "bifurcation-disc");
    assert_box(panel_of(figure, "confidence"), "#A8A8A8", 0.85, 0.95, 2.0);
    assert_box(panel_of(figure, "confidence"), "#DCDCDC", 0.75, 0.85, 3.0);
    assert_box(panel_of(figure, "confidence"), "#D55E00", 0.05, 0.15, 1.0);
    assert_point(panel_of(figure, "exponent"), WHIRL_DOTS, regime_class_colour(CLASS_P1), 0.9, -0.1);
    assert_point(panel_of(figure, "exponent"), WHIRL_DOTS, regime_class_colour(CLASS_CHAOTIC), 0.1, 0.4);
    assert_point(panel_of(figure, "exponent"), WHIRL_BARS, "#9A9A9A", 0.1, 0.39);
    assert_point(panel_of(figure, "radius"), WHIRL_LINE, "#0072B2", 0.8, 0.8);
    assert_point(panel_of(figure, "contact"), WHIRL_LINE, "#0072B2", 0.1, 4.0);
    whirl_figure_free(figure);
    assert_contains_text("out/report.html", "<td>high</td><td>P-3</td>");
    assert_contains_text("out/report.html", "<td>let it run 2 times as long</td>");
    whirl_result_free(result);
}

/// Makes a field of the detail, one number a point, one of another name.
static void rename_field(whirl_result *result, const char *from, const char *to, double value) {
    whirl_layout *layout = &result->tables[1].layout;
    *sample_field(&result->tables[1], 0, from, 0) = value;
    for (size_t f = 0; f < layout->field_count; f++)
        if (strcmp(layout->fields[f].name, from) == 0) snprintf(layout->fields[f].name, WHIRL_NAME_SIZE, "%s", to);
}

static void exponents_are_listed_with_their_sum(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    assert_lacks("out/report.html", "Kaplan-Yorke");
    rename_field(result, "regime/recurrence", "exponents/values", -0.1234);
    rename_field(result, "regime/regularity", "exponents/errors", 0.002);
    rename_field(result, "lyapunov/largest", "exponents/sum", -0.1234);
    rename_field(result, "lyapunov/error", "exponents/sum_exact", -0.12345);
    rename_field(result, "regime/recurrence_trend", "exponents/dimension", 1.5);
    assert_int_equal(report_one(result, "made", &options).code, WHIRL_MISSING_PROGRAM);
    assert_contains_text("out/report.html", "<td>-0.1234 \u00b1 0.0020</td><td class=\"number\">-0.1234</td>"
                                            "<td class=\"number\">-0.12345</td><td class=\"number\">1.5</td>");
    whirl_result_free(result);
}

/// Lines of a figure do not run over points that were not computed.
static void curves_break_where_points_are_missing(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    whirl_table *sweep = &result->tables[0];
    sweep->done = sample_take(sweep->count, 1);
    memset(sweep->done, 1, sweep->count);
    sweep->done[2] = sweep->done[3] = 0;
    whirl_figure *figure = figure_of(result, "bifurcation-disc");
    const whirl_panel *radius = panel_of(figure, "radius");
    const whirl_series *line = radius->series[radius->count - 1];
    assert_int_equal(line->shape, WHIRL_LINE);
    assert_true(line->x[1] == 0.9 && isnan(line->x[2]) && fabs(line->x[3] - 0.6) < 1e-12);
    whirl_figure_free(figure);
    whirl_result_free(result);
}

static void figures_can_be_drawn_again(void **state) {
    (void)state;
    if (!gnuplot_there()) skip();
    whirl_result *result = sample_result();
    assert_int_equal(report_one(result, "made", NULL).code, WHIRL_OK);
    assert_int_equal(remove("out/made/bifurcation-disc.png"), 0);
    assert_int_equal(system("cd out/made && sed -i 's/^show_title = 0/show_title = 1/' bifurcation-disc.gp && "
                            "gnuplot bifurcation-disc.gp"),
                     0);
    assert_true(is_png("out/made/bifurcation-disc.png"));
    whirl_result_free(result);
}

/// Names as a hostile result file may hold them: everything that gnuplot, HTML or a path could take for its own.
static void hostile_names_do_nothing(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    snprintf(result->title, sizeof result->title,
             "\"; system(\"touch pwned\") `touch pwned` </title><script>x</script>");
    snprintf(result->case_name, sizeof result->case_name, "<img src=x onerror=alert(1)>");
    snprintf(result->stations[0].name, WHIRL_NAME_SIZE, "'; system('touch pwned') #");
    snprintf(result->stations[1].name, WHIRL_NAME_SIZE, "../`touch pwned`\\");
    for (size_t t = 0; t < 2; t++)
        snprintf(result->tables[t].parameter, WHIRL_NAME_SIZE, "'.system('touch pwned').'\n!touch pwned\n");
    snprintf(result->parameters[0].name, WHIRL_NAME_SIZE, "%s", result->tables[0].parameter);
    snprintf(result->parameters[0].unit, WHIRL_NAME_SIZE, "`touch pwned`");
    snprintf(result->parameters[1].name, WHIRL_NAME_SIZE, "c'.`touch pwned`} %%s @m");
    free(result->case_text);
    result->case_text = sample_take(1, 64);
    strcpy(result->case_text, "</pre><script>x</script>");
    const whirl_status status = report_one(result, "../../a <b> \"c\"", NULL);
    if (gnuplot_there()) assert_string_equal(status.message, "");
    assert_int_equal(system("test -z \"$(find . -name 'pwned*')\""), 0);
    char *page = contents("out/report.html");
    assert_null(strstr(page, "<script"));
    assert_null(strstr(page, "<img src=x"));
    assert_null(strstr(page, "\"c\""));
    free(page);
    // One folder in it, with a harmless name.
    assert_int_equal(system("test \"$(ls out)\" = \"$(printf 'a--b---c-\\nreport.html')\""), 0);
    whirl_result_free(result);
}

static void missing_gnuplot_leaves_scripts_and_page(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"}, by_path = {.gnuplot = "./no-such-gnuplot"};
    const whirl_status status = report_one(result, "made", &options);
    assert_int_equal(status.code, WHIRL_MISSING_PROGRAM);
    assert_non_null(strstr(status.message, "no-such-gnuplot"));
    assert_true(size_of("out/made/bifurcation-disc.gp") > 0);
    assert_true(size_of("out/made/r_k-0.25-journal.dat") > 0);
    assert_contains_text("out/report.html", "was not drawn");
    assert_int_equal(report_one(result, "made", &by_path).code, WHIRL_MISSING_PROGRAM);
    whirl_result_free(result);
}

static void failing_gnuplot_is_reported(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_report_options options = {.gnuplot = "false"};
    const whirl_status status = report_one(result, "made", &options);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "bifurcation-disc.gp"));
    assert_true(size_of("out/report.html") > 0);
    whirl_result_free(result);
}

/// A sweep of regimes alone, in which one point diverged, without contacts, has a report.
static void absent_numbers_are_left_out(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    whirl_table *detail = &result->tables[1];
    for (size_t i = 0; i < detail->layout.size; i++) detail->blocks[i] = (double)NAN;
    sample_verdict(detail, 0, WHIRL_DIVERGING, 0, 0);
    *sample_field(detail, 0, "regime/diverged_at", 0) = 17.0;
    whirl_field *spectrum = &detail->layout.fields[0];
    for (size_t f = 0; f < detail->layout.field_count; f++)
        if (strcmp(detail->layout.fields[f].name, "spectrum/amplitude") == 0) spectrum = &detail->layout.fields[f];
    snprintf(spectrum->name, sizeof spectrum->name, "unknown/field");
    result->contact_count = 0;
    const whirl_status status = report_one(result, "made", NULL);
    if (gnuplot_there()) assert_string_equal(status.message, "");
    assert_int_equal(size_of("out/made/r_k-0.6-disc.gp"), -1); // nothing to draw of a motion that left its bounds
    assert_true(size_of("out/made/r_k-0.25-disc.gp") > 0);
    assert_lacks("out/made/r_k-0.25-disc.gp", "panel spectrum");
    assert_contains_text("out/report.html", "diverged at revolution 17");
    result->table_count = 0; // frees of the tables are skipped: they are given back below
    assert_true(report_one(result, "empty", NULL).code == WHIRL_OK || !gnuplot_there());
    assert_contains_text("out/report.html", "A rotor made by hand");
    result->table_count = 2;
    whirl_result_free(result);
}

static void results_of_one_name_keep_apart(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    const whirl_result *const both[] = {result, result};
    const char *const names[] = {"a b", "a-b"};
    const whirl_report_options options = {.gnuplot = "no-such-gnuplot"};
    assert_int_equal(whirl_report_write(both, names, 2, "out/deep", &options).code, WHIRL_MISSING_PROGRAM);
    assert_true(size_of("out/deep/a-b/bifurcation-disc.dat") > 0);
    assert_true(size_of("out/deep/a-b-2/bifurcation-disc.dat") > 0);
    assert_int_equal(whirl_report_write(both, names, 2, "/dev/null/x", &options).code, WHIRL_IO_ERROR);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(everything_is_written, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(gaps_are_shown_where_they_are, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(stators_near_the_orbit_are_drawn, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(partial_results_say_so, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(confidence_is_shown, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(exponents_are_listed_with_their_sum, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(curves_break_where_points_are_missing, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(figures_can_be_drawn_again, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(hostile_names_do_nothing, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(missing_gnuplot_leaves_scripts_and_page, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(failing_gnuplot_is_reported, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(absent_numbers_are_left_out, enter_folder, remove_folder),
        cmocka_unit_test_setup_teardown(results_of_one_name_keep_apart, enter_folder, remove_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
