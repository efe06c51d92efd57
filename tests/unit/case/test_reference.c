// cases/reference.yaml shows every key there is, and the cases that ship can be read.
#include "case_support.h"

#include <ctype.h>

#include "../read_all.h"

/// Returns true if a text has "key:" as a word, in the case itself or in a line that is commented out (since it
/// excludes another one).
static bool shows_key(const char *text, const char *key) {
    const size_t length = strlen(key);
    for (const char *at = strstr(text, key); at; at = strstr(at + 1, key)) {
        const bool begins = at == text || strchr(" {\n-", at[-1]) != NULL;
        if (begins && at[length] == ':' && (isspace((unsigned char)at[length + 1]) || at[length + 1] == '\0'))
            return true;
    }
    return false;
}

static size_t missing_keys(const char *text, const whirl_group *group) {
    size_t missing = 0;
    const whirl_key *key;
    for (size_t k = 0; (key = whirl_group_at(group, k)) != NULL; k++) {
        if (shows_key(text, key->name)) continue;
        print_error("reference.yaml lacks %s of %s\n", key->name, group->name);
        missing++;
    }
    return missing;
}

static void the_reference_shows_every_key(void **state) {
    (void)state;
    char *text = read_all(WHIRL_CASES "/reference.yaml");
    size_t missing = missing_keys(text, whirl_station_keys());
    missing += missing_keys(text, whirl_shaft_keys());
    missing += missing_keys(text, whirl_material_keys());
    for (const whirl_group *const *group = whirl_element_groups(); *group && (*group)->name; group++) {
        missing += missing_keys(text, *group);
        if (!shows_key(text, (*group)->name)) print_error("reference.yaml lacks the element %s\n", (*group)->name);
        missing += !shows_key(text, (*group)->name);
    }
    for (const whirl_group *const *group = whirl_case_groups(); *group && (*group)->name; group++)
        missing += missing_keys(text, *group);
    assert_int_equal(missing, 0);
    assert_false(shows_key(text, "stiffnes")); // the search itself can fail
    assert_false(shows_key(text, "key"));
    free(text);
}

static void a_range_holds_every_default(void **state) {
    const whirl_key *key;
    (void)state;
    for (const whirl_group *const *group = whirl_case_groups(); *group && (*group)->name; group++)
        for (size_t k = 0; (key = whirl_group_at(*group, k)) != NULL; k++) {
            assert_false(key->required && key->fallback[0]);
            if (!key->fallback[0]) continue;
            if (key->kind == WHIRL_KEY_CHOICE)
                assert_true(key->choices[0] == '\0' || whirl_key_choice(key, key->fallback) >= 0);
            else
                assert_int_equal(whirl_key_check_number(key, strtod(key->fallback, NULL)).code, WHIRL_OK);
        }
}

static void all_cases_can_be_read(void **state) {
    (void)state;
    static const char *const names[] = {
        "reference.yaml",     "paper.yaml",          "paper-literal.yaml",    "paper-derived.yaml",
        "paper-point.yaml",   "jeffcott-rub.yaml",   "rigid-rotor.yaml",      "cracked-rotor.yaml",
        "seal-whirl.yaml",    "squeeze-damper.yaml", "second-shaft.yaml",     "ball-bearings.yaml",
        "bearing-fault.yaml", "loose-pedestal.yaml", "overhung-rotor.yaml",   "compressor.yaml",
        "spindle.yaml",       "ross-example.yaml",   "paper-changes.yaml",    "paper-map.yaml",
        "paper-basin.yaml",   "quasi-periodic.yaml", "paper-starts.yaml",     "magnetic-drop.yaml",
        "pump.yaml",          "misalignment.yaml",   "tilting-pad-table.yaml"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[400];
        snprintf(path, sizeof path, "%s/%s", WHIRL_CASES, names[i]);
        whirl_case *object = NULL;
        const whirl_status status = whirl_case_load(path, NULL, &object);
        if (status.code != WHIRL_OK) print_error("%s\n", status.message);
        assert_int_equal(status.code, WHIRL_OK);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_reference_shows_every_key),
        cmocka_unit_test(a_range_holds_every_default),
        cmocka_unit_test(all_cases_can_be_read),
    };
    return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
