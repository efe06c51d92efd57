// Descriptors: look-up, ranges, choices and spelling.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "keys.h"

static const whirl_key keys[] = {
    NUMBER_KEY("mass", "m", "kg", REQUIRED, WHIRL_POSITIVE, ""),
    WHOLE_KEY("count", "", DEFAULT("1"), WHIRL_FROM_TO(1, 1000), ""),
    CHOICE_KEY("law", DEFAULT("paper"), "paper|slip|none", ""),
    {"share", "", "1", WHIRL_KEY_NUMBER, false, "0", {0, 1, false, true}, NULL, "", "", NULL},
    NUMBER_KEY("depth", "", "m", DEFAULT("0"), WHIRL_FROM_TO(-INFINITY, 0), ""),
    NUMBER_KEY("angle", "", "rad", DEFAULT("0"), WHIRL_ANY, ""),
};
static const whirl_group group = {"thing", "", "", keys, sizeof keys / sizeof *keys, NULL, NULL};

static void keys_are_found_by_name(void **state) {
    (void)state;
    assert_ptr_equal(whirl_group_key(&group, "law"), &keys[2]);
    assert_null(whirl_group_key(&group, "la"));
    assert_null(whirl_group_key(&group, "laws"));
    assert_null(whirl_group_key(&group, ""));
}

static void expect_refusal(const char *name, double value, const char *message) {
    const whirl_status status = whirl_key_check_number(whirl_group_key(&group, name), value);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, message);
}

static void expect_accepted(const char *name, double value) {
    assert_int_equal(whirl_key_check_number(whirl_group_key(&group, name), value).code, WHIRL_OK);
}

static void numbers_are_held_to_their_range(void **state) {
    (void)state;
    expect_accepted("mass", 1e-300);
    expect_refusal("mass", 0.0, "is 0 kg, expected a number above 0 kg");
    expect_refusal("mass", -3.0, "is -3 kg, expected a number above 0 kg");
    expect_refusal("mass", INFINITY, "is inf kg, expected a number above 0 kg");
    expect_accepted("share", 0.0);
    expect_refusal("share", 1.0, "is 1, expected a number of at least 0 and below 1");
    expect_accepted("depth", 0.0);
    expect_refusal("depth", 1e-3, "is 0.001 m, expected a number of at most 0 m");
    expect_accepted("angle", -7.0);
    expect_refusal("angle", -INFINITY, "is -inf rad, expected a finite number of rad");
    assert_int_equal(whirl_key_check_number(&keys[5], NAN).code, WHIRL_BAD_INPUT);
}

static void whole_numbers_are_whole(void **state) {
    (void)state;
    expect_accepted("count", 1.0);
    expect_accepted("count", 1000.0);
    expect_refusal("count", 2.5, "is 2.5, expected a whole number from 1 to 1000");
    expect_refusal("count", 0.0, "is 0, expected a whole number from 1 to 1000");
    expect_refusal("count", 1001.0, "is 1001, expected a whole number from 1 to 1000");
}

static void choices_have_indices(void **state) {
    (void)state;
    assert_int_equal(whirl_key_choice(&keys[2], "paper"), 0);
    assert_int_equal(whirl_key_choice(&keys[2], "slip"), 1);
    assert_int_equal(whirl_key_choice(&keys[2], "none"), 2);
    assert_int_equal(whirl_key_choice(&keys[2], "pap"), -1);
    assert_int_equal(whirl_key_choice(&keys[2], "paper|slip"), -1);
    assert_int_equal(whirl_key_choice(&keys[2], ""), -1);
    assert_int_equal(whirl_key_choice(&keys[0], "paper"), -1);
}

static void misspelt_names_are_recognised(void **state) {
    (void)state;
    static const char *const names[] = {"mass", "damping", "eccentricity", "eccentricity_angle", "k1", "k2"};
    const size_t count = sizeof names / sizeof *names;
    assert_string_equal(whirl_nearest_name("mas", names, count), "mass");                  // one letter missing
    assert_string_equal(whirl_nearest_name("msas", names, count), "mass");                 // neighbours swapped
    assert_string_equal(whirl_nearest_name("damping_", names, count), "damping");          // one too many
    assert_string_equal(whirl_nearest_name("ecentricitty", names, count), "eccentricity"); // two errors in 12 letters
    assert_string_equal(whirl_nearest_name("damp1gn", names, count), "damping");           // 2 in 7 are within a third
    assert_string_equal(whirl_nearest_name("k2", names, count), "k2");                     // the exact one before k1
    assert_null(whirl_nearest_name("ma", names, 1));                                       // two missing, one allowed
    assert_null(whirl_nearest_name("stiffness", names, count));
    assert_null(whirl_nearest_name("", names, count));
    assert_null(whirl_nearest_name("mass", names, 0));
}

static void long_words_are_no_names(void **state) {
    (void)state;
    char word[300];
    memset(word, 'a', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    const char *const names[] = {word, "aaaa"};
    assert_null(whirl_nearest_name(word, names, 2));
    assert_string_equal(whirl_nearest_name("aaab", names, 2), "aaaa");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_are_found_by_name),        cmocka_unit_test(numbers_are_held_to_their_range),
        cmocka_unit_test(whole_numbers_are_whole),       cmocka_unit_test(choices_have_indices),
        cmocka_unit_test(misspelt_names_are_recognised), cmocka_unit_test(long_words_are_no_names),
    };
    return cmocka_run_group_tests_name("descriptor", tests, NULL, NULL);
}
