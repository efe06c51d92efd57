// Every option of a case arrives in its study, in any part of it and under any name.
#include "case_support.h"

#include <math.h>

#include "whirl/engine/study.h"

/// Returns a word or number for the key that is not its default.
static const char *other_value(const whirl_key *key, char text[WHIRL_NAME_SIZE]) {
    if (strcmp(key->name, "method") == 0) return "rodas5p";
    if (key->kind == WHIRL_KEY_CHOICE && strcmp(key->choices, "unlocated|located") == 0) return "located";
    if (key->kind == WHIRL_KEY_CHOICE && strcmp(key->name, "begin") == 0) return "linear";
    if (key->kind == WHIRL_KEY_CHOICE) return strcmp(key->fallback, "yes") == 0 ? "no" : "yes";
    const double value = strtod(key->fallback, NULL), half = value / 2.0,
                 some = key->range.high < 100.0 ? key->range.high : 100.0;
    snprintf(text, WHIRL_NAME_SIZE, "%.10g",
             value > 1.0                     ? (key->kind == WHIRL_KEY_WHOLE ? floor(half) : half)
             : value == 1.0                  ? 2.0
             : value > 0.0                   ? half
             : strcmp(key->unit, "rad") == 0 ? 0.5
                                             : some);
    return text;
}

/// Returns true for parts that are studies of their own.
static bool is_study(const char *part) {
#define NAMED(name, ...) strcmp(part, #name) == 0 ||
    return WHIRL_STUDIES_AT_REST(NAMED) false;
#undef NAMED
}

/// Returns the index of the batch of a part of a study, for a part that is given together with a sweep and has its own
/// points.
static size_t batch_of(const char *part) {
    return strcmp(part, "branch") == 0 ? 1 : strcmp(part, "motions") == 0 ? 2 : 0;
}

/// Writes a small case whose study has one key of one part.
static void with_key(const char *part, const char *key, const char *value, whirl_case **object, whirl_study *study) {
    char text[1024], line[256];
    const bool of_study = strcmp(part, "study") == 0;
    const bool placed = strcmp(key, "antinodes_of") == 0 || strcmp(key, "at") == 0 || strcmp(key, "weight") == 0;
    const char *axis = !is_study(part)              ? ""
                       : strcmp(key, "trip") == 0   ? "parameter: q, values: [1, 2], running_to: 0.1, "
                       : !placed                    ? "parameter: q, values: [1, 2], "
                       : strcmp(key, "weight") != 0 ? "running_to: 9, "
                                                    : "running_to: 9, at: yes, ";
    if (strcmp(part, "motions") == 0)
        snprintf(line, sizeof line,
                 "  unbalance: {at: yes, weight: 1, running_to: 9}\n  %s: {unbalance: unbalance, %s: %s}", part, key,
                 value);
    else if (of_study)
        snprintf(line, sizeof line, "  %s: %s", key, value);
    else
        snprintf(line, sizeof line, "  %s: {%s%s: %s}", part, axis, key, value);
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {w: 100 rad/s, q: 1}\nrotor:\n  speed: = w\n  length_scale: 1 mm\n"
             "  stations: {disc: {position: 0 m, mass: 1 kg}, a: {position: 0.4 m}, yes: {position: 0.5 m},\n"
             "    b: {position: 0.6 m}, c: {position: 1 m}}\n  elements:\n    - segment: {length: 1 m, outer: 20 mm}\n"
             "    - bearing: {at: disc, kxx: 1 MN/m}\n    - bearing: {at: a, kxx: 1 MN/m}\n"
             "    - bearing: {at: b, kxx: 1 MN/m}\n    - bearing: {at: c, kxx: 1 MN/m}\n"
             "study:\n%s%s\n",
             is_study(part) ? "" : "  sweep: {parameter: w, from: 100 rad/s, to: 200 rad/s, points: 3}\n", line);
    const whirl_status status = whirl_case_parse(text, strlen(text), "t", NULL, object);
    if (status.code != WHIRL_OK) fail_msg("%s: %s", line, status.message);
    assert_int_equal(whirl_case_study(*object, study).code, WHIRL_OK);
}

static void follow(const whirl_member *member, size_t offset) {
    for (; member->part; member++) {
        char buffer[WHIRL_NAME_SIZE], expected[WHIRL_NAME_SIZE], found[WHIRL_NAME_SIZE];
        whirl_study study;
        whirl_case *object;
        if (!member->name || !*member->part) continue;
        const char *value = other_value(&member->key, buffer);
        with_key(member->part, member->key.name, value, &object, &study);
        whirl_batch *batch = &study.batches[batch_of(member->part)];
        whirl_member_text(member, (char *)batch + offset, found);
        whirl_batch wanted = {.count = 1};
        if (member->key.kind == WHIRL_KEY_CHOICE)
            whirl_member_say(member, (char *)&wanted + offset, value);
        else
            whirl_member_set(member, (char *)&wanted + offset, strtod(value, NULL));
        whirl_member_text(member, (char *)&wanted + offset, expected);
        assert_string_equal(found, expected);
        whirl_case_free(object);
    }
}

static void every_option_arrives(void **state) {
    (void)state;
    follow(whirl_integrate_members(), offsetof(whirl_batch, integrate));
    follow(whirl_record_members(), offsetof(whirl_batch, record));
    follow(whirl_trace_members(), offsetof(whirl_batch, record.trace));
    follow(whirl_batch_members(), 0);
}

/// Returns true if a group of case files has the key.
static bool is_described(const whirl_member *member) {
    for (const whirl_group *const *group = whirl_case_groups(); *group; group++)
        if (strcmp((*group)->name, member->part) == 0) return whirl_group_key(*group, member->key.name) == &member->key;
    return false;
}

static void every_option_is_described(void **state) {
    const whirl_member *const tables[] = {whirl_integrate_members(), whirl_record_members(), whirl_trace_members(),
                                          whirl_batch_members(), whirl_probe_members()};
    (void)state;
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++)
        for (const whirl_member *member = tables[t]; member->part; member++)
            if (*member->part && !is_described(member)) fail_msg("%s of %s", member->key.name, member->part);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_option_arrives),
        cmocka_unit_test(every_option_is_described),
    };
    return cmocka_run_group_tests_name("options", tests, NULL, NULL);
}
