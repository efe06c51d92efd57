// Options and stations have one table each: it covers all of its struct, and no option is lost on its way through a
// result file or overlooked where studies are compared.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "same.h"
#include "synthetic.h"

#include <stdio.h>
#include <unistd.h>

static size_t size_of(const whirl_member *member) {
    static const size_t sizes[] = {[WHIRL_MEMBER_WORD] = WHIRL_NAME_SIZE,
                                   [WHIRL_MEMBER_NUMBER] = sizeof(double),
                                   [WHIRL_MEMBER_WHOLE] = sizeof(int),
                                   [WHIRL_MEMBER_FLAG] = sizeof(bool),
                                   [WHIRL_MEMBER_INDEX] = sizeof(size_t)};
    return sizes[member->type];
}

static const whirl_member *at_offset(const whirl_member *table, size_t offset) {
    for (; table->part; ++table)
        if (table->name && table->offset == offset) return table;
    return NULL;
}

/// Checks that members from `offset` on fill the struct to its end, with no gaps except for alignment.
static void assert_covers(const whirl_member *table, size_t offset, size_t size) {
    const size_t widest = sizeof(double);
    while (offset < size) {
        size_t gap = 0;
        const whirl_member *next = at_offset(table, offset);
        while (!next && offset + gap < size && gap < widest) next = at_offset(table, offset + ++gap);
        if (!next && offset + gap == size && gap < widest) return;
        assert_non_null(next);
        assert_true(gap == 0 || (gap < size_of(next) && next->type != WHIRL_MEMBER_FLAG));
        offset = next->offset + size_of(next);
    }
}

static void tables_cover_their_structs(void **state) {
    (void)state;
    assert_covers(whirl_integrate_members(), 0, sizeof(whirl_integrate_options));
    assert_covers(whirl_record_members(), 0, offsetof(whirl_record_options, trace));
    assert_covers(whirl_trace_members(), 0, sizeof(whirl_trace_options));
    assert_covers(whirl_probe_members(), offsetof(whirl_probe, x),
                  offsetof(whirl_probe, runout_count)); // results have no runout
}

/// Every member has a meaning and is found by its name. One without a name shares its place with one that has a name.
static void members_describe_themselves(void **state) {
    const whirl_member *const tables[] = {whirl_integrate_members(), whirl_record_members(), whirl_probe_members()};
    (void)state;
    for (size_t t = 0; t < sizeof tables / sizeof *tables; ++t)
        for (const whirl_member *member = tables[t]; member->part; ++member) {
            assert_true(strlen(member->key.meaning) > 5);
            assert_true(member->name || at_offset(tables[t], member->offset)->name);
            if (member->name) assert_ptr_equal(whirl_member_find(tables[t], member->name), member);
        }
    assert_null(whirl_member_find(tables[0], "rto"));
}

/// Sets another valid value of the member.
static void change(const whirl_member *member, void *object) {
    const double value = whirl_member_number(member, object);
    switch (member->type) {
    case WHIRL_MEMBER_WORD:
        whirl_member_say(member, object, "euler");
        return;
    case WHIRL_MEMBER_FLAG:
        whirl_member_set(member, object, value == 0.0);
        return;
    case WHIRL_MEMBER_NUMBER:
        whirl_member_set(member, object, value == 0.0 ? 0.25 : value / 2.0);
        return;
    case WHIRL_MEMBER_WHOLE:
    case WHIRL_MEMBER_INDEX:
        whirl_member_set(member, object,
                         value > 0.0 && member->key.range.high < value + 1.0 ? value - 1.0 : value + 1.0);
        return;
    }
}

/// Changes one option of the first table after the other, in a file and in the reported difference.
static void follow_each(whirl_result *made, const whirl_result *earlier, const whirl_member *member, size_t offset) {
    char path[64];
    snprintf(path, sizeof path, "/tmp/whirl-members-%ld.h5", (long)getpid());
    for (; member->part; ++member) {
        whirl_table *table = &made->tables[0];
        const whirl_table before = *table;
        char difference[WHIRL_MESSAGE_SIZE], expected[2 * WHIRL_NAME_SIZE];
        whirl_result *read = NULL;
        if (!member->name) continue;
        change(member, (char *)table + offset);
        assert_false(same_table(&before, table));
        if (table->record.watch > 0 && table->record.watch < table->record.record)
            table->record.watch = table->record.record;
        assert_int_equal(whirl_result_write(made, path).code, WHIRL_OK);
        const whirl_status status = whirl_result_read(path, &read);
        if (status.code != WHIRL_OK) fail_msg("%s: %s", member->name, status.message);
        assert_true(same_members(whirl_integrate_members(), &read->tables[0].integrate, &table->integrate));
        assert_true(same_members(whirl_record_members(), &read->tables[0].record, &table->record));
        assert_false(whirl_result_same_study(earlier, read, difference, sizeof difference));
        snprintf(expected, sizeof expected, "%s of the %s was '", member->name, table->name);
        if (!strstr(difference, expected)) fail_msg("'%s' does not say '%s'", difference, expected);
        whirl_result_free(read);
        *table = before;
    }
    unlink(path);
}

static void every_option_is_kept_and_compared(void **state) {
    whirl_result *made = synthetic_result(), *earlier = synthetic_result();
    (void)state;
    follow_each(made, earlier, whirl_integrate_members(), offsetof(whirl_table, integrate));
    follow_each(made, earlier, whirl_record_members(), offsetof(whirl_table, record));
    whirl_result_free(made);
    whirl_result_free(earlier);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_cover_their_structs),
        cmocka_unit_test(members_describe_themselves),
        cmocka_unit_test(every_option_is_kept_and_compared),
    };
    return cmocka_run_group_tests_name("members", tests, NULL, NULL);
}
