// Values changed in the text of a case, where parameters are used, and what the case says of them.
#include "case_support.h"

#include <math.h>

static void expect_edit(const char *text, const char *path, const char *value, const char *expected) {
    char *found = NULL;
    const whirl_status status = whirl_case_edit(text, strlen(text), path, value, &found);
    if (status.code != WHIRL_OK) print_error("%s\n", status.message);
    assert_int_equal(status.code, WHIRL_OK);
    assert_string_equal(found, expected);
    free(found);
}

static void values_change_in_place(void **state) {
    (void)state;
    expect_edit("a: 1 # one\nb:   2.5 mm   # two\n", "b", "7 m", "a: 1 # one\nb:   7 m   # two\n");
    expect_edit("p: {r: 1, s: 'x y' } # c\n", "p.s", "= r*2", "p: {r: 1, s: = r*2 } # c\n");
    expect_edit("l:\n  - film: {load: 3}\n  - film: {load: 4}\n", "l[2].film.load", "5 N",
                "l:\n  - film: {load: 3}\n  - film: {load: 5 N}\n");
    expect_edit("t: µm é # ü\nb: 1\n", "b", "2 µm", "t: µm é # ü\nb: 2 µm\n");
    expect_edit("\xEF\xBB\xBF"
                "b: 1\n",
                "b", "2",
                "\xEF\xBB\xBF"
                "b: 2\n");
    expect_edit("b: 1\r\nc: 2\r\n", "c", "3", "b: 1\r\nc: 3\r\n");
    expect_edit("a:\nb: 1\n", "a", "2", "a: 2\nb: 1\n");
}

/// A comma ends a value between braces, and ' #' begins a comment.
static void values_are_quoted_where_they_must_be(void **state) {
    (void)state;
    expect_edit("p: {r: 1, s: 2}\n", "p.r", "= min(1, 2)", "p: {r: '= min(1, 2)', s: 2}\n");
    expect_edit("p: 1\n", "p", "it's # 2", "p: 'it''s # 2'\n");
}

static void lists_are_replaced_by_lists(void **state) {
    (void)state;
    expect_edit("d: {at: [1, 0.5], n: 2} # c\n", "d.at", "[650 rad/s]", "d: {at: [650 rad/s], n: 2} # c\n");
    expect_edit("d:\n  at: [1, # ]\n    2,\n  ]\n  n: 2\n", "d.at", "[3, 4]", "d:\n  at: [3, 4]\n  n: 2\n");
    expect_edit("d:\n  at:\n    - 1\n    - 2 # two\n  n: 2\n", "d.at", "[3]", "d:\n  at: [3] # two\n  n: 2\n");
    expect_edit("d:\n  at:\n  - 1\n  - 2\n  n: 2\n", "d.at", "[3]", "d:\n  at: [3]\n  n: 2\n");
    expect_edit("d: {at: []}\n", "d.at", "[3]", "d: {at: [3]}\n");
    expect_edit("d: {n: 2}\n", "d.at", "[3]", "d: {at: [3], n: 2}\n");
}

static void missing_keys_are_added(void **state) {
    (void)state;
    expect_edit("s:\n  # first\n  a: 1\n", "s.b", "2", "s:\n  # first\n  b: 2\n  a: 1\n");
    expect_edit("s: {a: 1}\n", "s.b", "2", "s: {b: 2, a: 1}\n");
    expect_edit("s: {}\n", "s.b", "2", "s: {b: 2}\n");
    expect_edit("s:\n", "s.b", "2", "s: {b: 2}\n");
    expect_edit("s: {a: 1}\n", "s.b.c", "2", "s: {b: {c: 2}, a: 1}\n");
}

static void keys_are_taken_out(void **state) {
    (void)state;
    static const char *const edits[][3] = {
        {"s:\n  # first\n  a: 1\n  b: [1, 2] # two\n  # third\n  c: 3\n", "s.b",
         "s:\n  # first\n  a: 1\n  # third\n  c: 3\n"},
        {"s: {a: 1, b: [1, # ]\n  2], c: 3}\n", "s.b", "s: {a: 1, c: 3}\n"},
        {"s: {a: 1, b: [1, 2]}\nt: 2\n", "s.b", "s: {a: 1}\nt: 2\n"},
        {"s: {a: {d: 1},\n    b: 2}\n", "s.b", "s: {a: {d: 1}}\n"},
        {"s: {b: 1}\n", "s.b", "s: {}\n"},
        {"s:\n  a: 1\n  b:\n    - 1 # one\n    - 2 # two\n  c: 3\n", "s.b", "s:\n  a: 1\n  c: 3\n"},
        {"s:\n  a: 1\n  b:\n  - 1\n  - 2", "s.b", "s:\n  a: 1\n"},
        {"s:\n  b: |\n    1\n    2\n  c: 3\n", "s.b", "s:\n  c: 3\n"},
        {"l:\n- a: 1\n  b: 2\n", "l[1].a", "l:\n- b: 2\n"},
        {"µ: ü\r\nb: 1\r\nc: 2\r\n", "b", "µ: ü\r\nc: 2\r\n"},
        {"s: {a: 1}\n", "s.b", "s: {a: 1}\n"},
    };
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) expect_edit(edits[i][0], edits[i][1], NULL, edits[i][2]);
}

/// Removes keys with everything below them, in block style and in flow style.
static void keys_are_removed_with_all_below(void **state) {
    (void)state;
    static const char *const edits[][3] = {
        {"s:\n  a: {b: [1, {c: 2}]} # one\n  d: 3\n", "s.a", "s:\n  d: 3\n"},
        {"s:\n  a:\n    b:\n      c: 1\n    # last\n    e: {f: 1,\n      g: 2}\n  d: 3\n", "s.a", "s:\n  d: 3\n"},
        {"s: {a: {b: [1, # ]}\n 2]}, d: 3}\n", "s.a", "s: {d: 3}\n"},
        {"{s: {d: 3, a: {b: 1}}, t: 1}\n", "s.a", "{s: {d: 3}, t: 1}\n"},
        {"{s: {a: {b: {}}}}\n", "s.a", "{s: {}}\n"},
        {"{\"s\": {\"a\": {\"b\": [\"}\", 1]}, \"d\": 3}}", "s.a", "{\"s\": {\"d\": 3}}"},
        {"s:\n  a:\n  - b: 1\n    c: 2\n  - 3\n  d: 3\n", "s.a", "s:\n  d: 3\n"},
        {"s: {a: 1}\n", "s.b", "s: {a: 1}\n"},
    };
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        char *found = NULL;
        assert_int_equal(whirl_case_remove(edits[i][0], strlen(edits[i][0]), edits[i][1], &found).code, WHIRL_OK);
        assert_string_equal(found, edits[i][2]);
        free(found);
    }
    char *found = NULL;
    assert_int_equal(whirl_case_remove("a: [1]\n", 7, "a[1]", &found).code, WHIRL_BAD_INPUT);
    assert_null(found);
}

static void other_nodes_take_no_value(void **state) {
    (void)state;
    static const char *const wrong[][3] = {
        {"a: {b: 1}\n", "a", "2"},       {"a: [1]\n", "a", "2"},        {"a: [1]\n", "a.b", "2"},
        {"a: 1\n", "a.b", "2"},          {"a: [1\n", "a", "2"},         {"a: 1\n", "a", "2\nb: 3"},
        {"a: {b: 1}\n", "a", "[2]"},     {"a: [1, [2]]\n", "a", "[2]"}, {"a: {b: 1}\n", "a.b", "\x01"},
        {"a: {b: 1, b: 2}\n", "a", "1"}, {"a: {b: 1}\n", "a", NULL},    {"a: [1]\n", "a[1]", NULL},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char *found = NULL;
        assert_int_equal(whirl_case_edit(wrong[i][0], strlen(wrong[i][0]), wrong[i][1], wrong[i][2], &found).code,
                         WHIRL_BAD_INPUT);
        assert_null(found);
    }
}

/// The edited case is the one that --set makes.
static void an_edited_case_means_what_was_written(void **state) {
    (void)state;
    char *found = NULL;
    double value = 0.0;
    assert_int_equal(whirl_case_edit(good_case, strlen(good_case), "parameters.c", "150 um", &found).code, WHIRL_OK);
    whirl_case *object = parse_good(found);
    assert_int_equal(whirl_case_parameter(object, "c", &value).code, WHIRL_OK);
    assert_true(fabs(value - 150e-6) <= 1e-18);
    whirl_case_free(object);
    free(found);
}

typedef struct seen_uses {
    char text[1024];
} seen_uses;

static void see(void *context, const whirl_use *use) {
    seen_uses *seen = context;
    const size_t used = strlen(seen->text);
    snprintf(seen->text + used, sizeof seen->text - used, "%s%s %s %s\n", use->parameter, use->alone ? "" : "*",
             use->path, use->key->unit);
}

static void uses_are_found(void **state) {
    (void)state;
    seen_uses seen = {""};
    whirl_case *object = parse_good(good_case);
    whirl_case_uses(object, see, &seen);
    assert_string_equal(seen.text, "omega rotor.speed rad/s\n"
                                   "c rotor.length_scale m\n"
                                   "c* rotor.stations.disc.eccentricity m\n"
                                   "c rotor.elements[2].film.clearance m\n"
                                   "c* rotor.elements[3].rub.gap m\n"
                                   "kappa* rotor.elements[3].rub.stiffness N/m\n");
    whirl_case_free(object);
}

static void expect_comment(const char *line, const char *expected) {
    char comment[40];
    whirl_case *object = parse_edited("kappa: 10", line);
    whirl_case_comment(object, "kappa", comment, sizeof comment);
    assert_string_equal(comment, expected);
    whirl_case_free(object);
}

static void comments_are_those_of_the_line(void **state) {
    (void)state;
    expect_comment("kappa: 10", "");
    expect_comment("kappa: 10  # ratio, plain", "ratio, plain");
    expect_comment("kappa: 10 ## two", "two");
    expect_comment("kappa: \"10\" # quoted", "quoted");
    expect_comment("kappa: 10 #", "");
    expect_comment("kappa: 10 # 0123456789 0123456789 0123456789 0123456789",
                   "0123456789 0123456789 0123456789 012345");
    char comment[8] = "x";
    whirl_case *object = parse_good(good_case);
    whirl_case_comment(object, "nobody", comment, sizeof comment);
    assert_string_equal(comment, "");
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_change_in_place),
        cmocka_unit_test(values_are_quoted_where_they_must_be),
        cmocka_unit_test(lists_are_replaced_by_lists),
        cmocka_unit_test(missing_keys_are_added),
        cmocka_unit_test(keys_are_taken_out),
        cmocka_unit_test(keys_are_removed_with_all_below),
        cmocka_unit_test(other_nodes_take_no_value),
        cmocka_unit_test(an_edited_case_means_what_was_written),
        cmocka_unit_test(uses_are_found),
        cmocka_unit_test(comments_are_those_of_the_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
