// Text that is hostile to HTML, to gnuplot and to file names; files that cannot be written; regimes; ranges of axes.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "figure_build.h"
#include "gnuplot.h"
#include "html.h"
#include "quantities.h"
#include "regimes.h"
#include "report_file.h"
#include "sample.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

/// Returns what a writer writes for a text.
static char *written(void (*writer)(FILE *, const char *), const char *text) {
    char *memory = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&memory, &size);
    assert_non_null(stream);
    writer(stream, text);
    assert_int_equal(fclose(stream), 0);
    return memory;
}

static void assert_written(void (*writer)(FILE *, const char *), const char *text, const char *expected) {
    char *found = written(writer, text);
    assert_string_equal(found, expected);
    free(found);
}

static void html_is_escaped(void **state) {
    (void)state;
    assert_written(html_text, "<script>alert(\"a\" & 'b')</script>",
                   "&lt;script&gt;alert(&quot;a&quot; &amp; &#39;b&#39;)&lt;/script&gt;");
    assert_written(html_text, "r\xc3\xb6tor \xe2\x82\xac", "r\xc3\xb6tor \xe2\x82\xac"); // valid UTF-8 stays
    // A lone continuation byte, an overlong '<', a surrogate, a cut character, an escape character.
    assert_written(html_text, "\x80", "\xef\xbf\xbd");
    assert_written(html_text, "\xc0\xbc", "\xef\xbf\xbd\xef\xbf\xbd");
    assert_written(html_text, "\xed\xa0\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    assert_written(html_text, "a\xe2\x82", "a\xef\xbf\xbd\xef\xbf\xbd");
    assert_written(html_text, "\x1b[31m", "\xef\xbf\xbd[31m");
    // U+009B, a terminal's escape sequence in one character, and an override of the direction.
    assert_written(html_text, "a\n\xc2\x9b\x31m\xe2\x80\xae", "a\n\xef\xbf\xbd\x31m\xef\xbf\xbd");
}

static void gnuplot_strings_stay_strings(void **state) {
    (void)state;
    assert_written(gnuplot_string, "it's `date` \"x\" \\n @m", "'it\xe2\x80\x99s `date` \"x\" \\n @m'");
    assert_written(gnuplot_string, "two\nlines\x80", "'two lines?'");
    assert_written(gnuplot_string, "a\xc2\x9b\xe2\x80\xae\xc3\xa9", "'a  \xc3\xa9'");
    assert_written(gnuplot_comment, "a\nsystem('x') \\", "a system('x')  ");
}

static void file_names_are_safe(void **state) {
    (void)state;
    static const char *const names[][2] = {
        {"../../etc/passwd", "etc-passwd"}, {"a b'c", "a-b-c"}, {"", "unnamed"}, {"--help", "help"},
        {"r_k=0.45", "r_k-0.45"},           {"...", "unnamed"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char safe[32];
        safe_name(names[i][0], safe, sizeof safe);
        assert_string_equal(safe, names[i][1]);
    }
    char cut[4];
    safe_name("abcdef", cut, sizeof cut);
    assert_string_equal(cut, "abc");
}

static void failing_files_say_so(void **state) {
    (void)state;
    char folder[] = "/tmp/whirl-report-XXXXXX", path[64], part[64];
    report_file file;
    assert_non_null(mkdtemp(folder));
    // A folder stands where the file should go.
    snprintf(path, sizeof path, "%s/taken", folder);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_int_equal(report_file_open(&file, folder, "taken").code, WHIRL_OK);
    fputs("text\n", file.stream);
    const whirl_status taken = report_file_close(&file);
    assert_int_equal(taken.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(taken.message, "taken"));
    snprintf(part, sizeof part, "%s/taken.part", folder);
    assert_int_not_equal(access(part, F_OK), 0);
    // No space: files may not grow beyond 100 bytes.
    struct rlimit before, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 100;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(report_file_open(&file, folder, "full").code, WHIRL_OK);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    for (int i = 0; i < 5000; i++) fputs("much text\n", file.stream);
    const whirl_status full = report_file_close(&file);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(full.code, WHIRL_IO_ERROR);
    assert_int_equal(report_file_open(&file, "/nonexistent", "x").code, WHIRL_IO_ERROR);
    rmdir(path);
    assert_int_equal(rmdir(folder), 0); // nothing is left behind
}

static void folders_are_made_with_those_above(void **state) {
    (void)state;
    char folder[] = "/tmp/whirl-report-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a/b", folder);
    assert_int_equal(folder_make(path).code, WHIRL_OK);
    assert_int_equal(folder_make(path).code, WHIRL_OK);
    assert_int_equal(folder_make("/dev/null/x").code, WHIRL_IO_ERROR);
    assert_int_equal(rmdir(path), 0);
    snprintf(path, sizeof path, "%s/a", folder);
    assert_int_equal(rmdir(path), 0);
    assert_int_equal(rmdir(folder), 0);
}

static void neighbouring_points_of_a_regime_merge(void **state) {
    (void)state;
    whirl_result *result = sample_result();
    regime_interval intervals[8];
    assert_int_equal(regime_intervals(&result->tables[0], 1, intervals, 8), 4);
    static const struct {
        const char *name;
        size_t first, last, count, rubbing;
    } expected[] = {{"P-1", 0, 5, 6, 0}, {"P-2", 6, 6, 1, 0}, {"quasi-periodic", 7, 8, 2, 0}, {"chaotic", 9, 10, 2, 2}};
    for (size_t i = 0; i < 4; i++) {
        assert_string_equal(intervals[i].name, expected[i].name);
        assert_int_equal(intervals[i].first, expected[i].first);
        assert_int_equal(intervals[i].last, expected[i].last);
        assert_int_equal(intervals[i].count, expected[i].count);
        assert_int_equal(intervals[i].rubbing, expected[i].rubbing);
    }
    // Branches do not merge, and what has no room is counted only.
    for (size_t i = 0; i < 11; i++) result->tables[0].branch[i] = i < 3 ? 1 : -1;
    assert_int_equal(regime_intervals(&result->tables[0], 1, intervals, 2), 5);
    assert_int_equal(intervals[1].branch, -1);
    assert_int_equal(intervals[1].count, 3);
    whirl_result_free(result);
}

static void axes_never_shrink_to_noise(void **state) {
    (void)state;
    span range = span_empty();
    span_widen(&range, 0.5);
    span_widen(&range, 0.5 + 1e-12);
    span_widen(&range, (double)NAN);
    span_widen(&range, (double)INFINITY);
    const span axis = span_with_margin(range, 0.1, 0.06);
    assert_true(fabs(axis.high - axis.low - 0.06) < 1e-15);
    assert_true(fabs(axis.high + axis.low - 1.0) < 1e-9);
    const span nothing = span_with_margin(span_empty(), 0.1, 0.0);
    assert_true(nothing.low == 0.0 && nothing.high == 1.0);
    assert_true(fabs(tick_step(1.0, 5) - 0.2) < 1e-15);
    assert_true(fabs(tick_step(0.9, 2) - 0.5) < 1e-15);
    assert_true(fabs(tick_step(37.0, 5) - 10.0) < 1e-12);
    assert_true(tick_step(0.0, 5) == 1.0);
}

static void errors_are_shown_with_two_digits(void **state) {
    (void)state;
    static const struct {
        double value, error;
        const char *shown;
    } cases[] = {{-0.164912, 4.9e-4, "-0.1649 +- 0.0005"},
                 {-0.165003, 3.4e-9, "-0.1650 +- 0.0001"},
                 {0.4531249, 0.00731, "0.4531 +- 0.0073"},
                 {1.23456, 0.0273, "1.235 +- 0.027"},
                 {-2.8e-5, 8e-4, "0.0000 +- 0.0008"},
                 {0.05, 0.0, "0.0500 +- 0.0001"},
                 {123.4, 31.2, "123 +- 31"},
                 {0.2, 0.0099999, "0.200 +- 0.010"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[64];
        const shown_estimate shown = estimate_shown((whirl_estimate){cases[i].value, cases[i].error});
        snprintf(text, sizeof text, "%.*f +- %.*f", shown.decimals, shown.value, shown.decimals, shown.error);
        assert_string_equal(text, cases[i].shown);
    }
    assert_true(isnan(estimate_shown((whirl_estimate){(double)NAN, (double)NAN}).value));
}

static void reasons_are_written_for_pages(void **state) {
    (void)state;
    const whirl_verdict verdict = {.regime = WHIRL_PERIODIC,
                                   .period = 2,
                                   .recurrence = 1e-11,
                                   .recurrence_period = 2,
                                   .exponent = {-0.164912, 4.9e-4}};
    char text[512];
    reason_text(&verdict, text, sizeof text);
    plus_minus(text);
    assert_non_null(strstr(text, "-0.1649 \u00b1 0.0005 per revolution"));
    assert_null(strstr(text, "+-"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(html_is_escaped),
        cmocka_unit_test(gnuplot_strings_stay_strings),
        cmocka_unit_test(file_names_are_safe),
        cmocka_unit_test(failing_files_say_so),
        cmocka_unit_test(folders_are_made_with_those_above),
        cmocka_unit_test(neighbouring_points_of_a_regime_merge),
        cmocka_unit_test(errors_are_shown_with_two_digits),
        cmocka_unit_test(reasons_are_written_for_pages),
        cmocka_unit_test(axes_never_shrink_to_noise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
