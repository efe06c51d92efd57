// A journal takes points from other journals to the bit: only points of its own study, and states of unfinished points.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "expect.h"
#include "journal_points.h"
#include "whole.h"

typedef struct fixture {
    char folder[64], own[96], other[96];
    whirl_result *outline;
} fixture;

static int setup(void **state) {
    fixture *f = calloc(1, sizeof *f);
    if (!f) return -1;
    snprintf(f->folder, sizeof f->folder, "%s/whirl-take-XXXXXX", access("/dev/shm", W_OK) ? "/tmp" : "/dev/shm");
    if (!mkdtemp(f->folder)) return -1;
    snprintf(f->own, sizeof f->own, "%s/own", f->folder);
    snprintf(f->other, sizeof f->other, "%s/other", f->folder);
    f->outline = synthetic_result();
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    remove(f->own);
    remove(f->other);
    const int failed = rmdir(f->folder);
    whirl_result_free(f->outline);
    free(f);
    return failed;
}

static whirl_journal *begun(const fixture *f, const char *path) {
    whirl_journal *journal;
    check(whirl_journal_begin(path, f->outline, &journal));
    return journal;
}

/// Makes a closed journal of the points from `first` on.
static void make_other(const fixture *f, size_t first, size_t end) {
    whirl_journal *journal = begun(f, f->other);
    for (size_t i = first; i < end; ++i) check(point_write(journal, i));
    check(whirl_journal_close(journal));
}

static void points_are_taken_once(void **state) {
    const fixture *f = *state;
    unsigned char *bytes;
    size_t size, again;
    make_other(f, 1, JOURNAL_POINTS);
    whirl_journal *journal = begun(f, f->own);
    check(point_write(journal, 0));
    check(point_write(journal, 1));
    assert_true(whirl_journal_has(journal, 0, 1));
    assert_false(whirl_journal_has(journal, 0, 2));
    check(whirl_journal_take(journal, f->other));
    assert_int_equal(count_recalled(journal), JOURNAL_POINTS);
    assert_int_equal(whirl_journal_points(journal), JOURNAL_POINTS);
    assert_true(whirl_journal_has(journal, 0, 2));
    // Of no pass, no batch and no slot that there is not.
    assert_false(whirl_journal_has(journal, 2, 0) || whirl_journal_has(journal, 1000, 0));
    assert_false(whirl_journal_has(journal, 0, SYNTHETIC_POINTS));
    check(whole_file(f->own, &bytes, &size));
    free(bytes);
    check(whirl_journal_take(journal, f->other));
    check(whole_file(f->own, &bytes, &again));
    free(bytes);
    assert_int_equal(again, size);
    check(whirl_journal_close(journal));
    // They are its own from then on.
    check(whirl_journal_discard(f->other));
    assert_int_not_equal(access(f->other, F_OK), 0);
    check(whirl_journal_resume(f->own, f->outline, &journal));
    assert_int_equal(count_recalled(journal), JOURNAL_POINTS);
    check(whirl_journal_close(journal));
}

static bool is_odd(const void *context, size_t batch, size_t slot) {
    (void)context, (void)batch;
    return slot % 2 == 1;
}

static void a_part_takes_its_own(void **state) {
    const fixture *f = *state;
    const whirl_journal_part part = {is_odd, NULL};
    whirl_journal *journal;
    make_other(f, 0, JOURNAL_POINTS);
    check(whirl_journal_begin_part(f->own, f->outline, &part, &journal));
    check(whirl_journal_take(journal, f->other));
    for (size_t i = 0; i < JOURNAL_POINTS; ++i)
        assert_int_equal(point_recall(journal, i), point_make(i).slot % 2 == 1 ? 1 : 0);
    check(whirl_journal_close(journal));
    check(whirl_journal_resume_part(f->own, f->outline, &part, &journal));
    assert_int_equal(whirl_journal_look(journal).points, 1);
    check(whirl_journal_close(journal));
}

/// Only the points of the part need room on the disk.
static void a_part_reserves_less(void **state) {
    enum { MANY = 200000 };
    const fixture *f = *state;
    whirl_table *sweep = &f->outline->tables[0];
    const size_t count = sweep->count;
    double *values = sweep->values;
    int *branch = sweep->branch;
    const whirl_journal_part part = {is_odd, NULL};
    whirl_journal *whole, *half;
    struct stat one, other;
    sweep->count = MANY;
    sweep->values = calloc(MANY, sizeof *sweep->values);
    sweep->branch = calloc(MANY, sizeof *sweep->branch);
    assert_true(sweep->values && sweep->branch);
    check(whirl_journal_begin(f->own, f->outline, &whole));
    check(whirl_journal_begin_part(f->other, f->outline, &part, &half));
    assert_true(stat(f->own, &one) == 0 && stat(f->other, &other) == 0);
    if (one.st_blocks > MANY / 512) assert_true((double)other.st_blocks < 0.6 * (double)one.st_blocks);
    check(whirl_journal_close(whole));
    check(whirl_journal_close(half));
    free(sweep->values);
    free(sweep->branch);
    sweep->count = count;
    sweep->values = values;
    sweep->branch = branch;
}

static void a_journal_in_use_is_read_and_not_removed(void **state) {
    const fixture *f = *state;
    whirl_journal *other = begun(f, f->other), *journal = begun(f, f->own);
    check(point_write(other, 2));
    assert_true(whirl_journal_in_use(f->other));
    check(whirl_journal_take(journal, f->other));
    assert_int_equal(count_recalled(journal), 1);
    check(point_write(other, 3));
    check(whirl_journal_take(journal, f->other));
    assert_int_equal(count_recalled(journal), 2);
    assert_says(whirl_journal_discard(f->other), WHIRL_BAD_INPUT, "another run is writing");
    check(whirl_journal_close(other));
    assert_false(whirl_journal_in_use(f->other));
    check(whirl_journal_close(journal));
}

static void other_studies_are_refused(void **state) {
    const fixture *f = *state;
    make_other(f, 0, 2);
    f->outline->parameters[1].value = 660.0;
    whirl_journal *journal = begun(f, f->own);
    assert_says(whirl_journal_take(journal, f->other), WHIRL_BAD_INPUT,
                "other is of another study: parameter omega was '650 rad/s' and is '660 rad/s'");
    assert_int_equal(count_recalled(journal), 0);
    FILE *file = fopen(f->other, "wb");
    assert_true(file && fputs("not a journal at all\n", file) >= 0 && fclose(file) == 0);
    assert_says(whirl_journal_take(journal, f->other), WHIRL_BAD_INPUT, "is no journal of this study");
    assert_says(whirl_journal_take(journal, f->folder), WHIRL_BAD_INPUT, "is no ordinary file");
    remove(f->other);
    assert_says(whirl_journal_take(journal, f->other), WHIRL_BAD_INPUT, "there is no journal");
    check(whirl_journal_close(journal));
}

/// If a journal is cut or damaged at any byte, its valid part is used, and no wrong number.
static void valid_parts_are_used(void **state) {
    const fixture *f = *state;
    unsigned char *bytes;
    size_t size;
    make_other(f, 0, JOURNAL_POINTS);
    check(whole_file(f->other, &bytes, &size));
    for (size_t at = 0; at < size; at += 7) {
        bytes[at] ^= 0x10u;
        FILE *file = fopen(f->other, "wb");
        assert_true(file && fwrite(bytes, 1, size - (at / 7) % 3, file) == size - (at / 7) % 3 && fclose(file) == 0);
        remove(f->own);
        whirl_journal *journal = begun(f, f->own);
        check(whirl_journal_take(journal, f->other));
        assert_true(count_recalled(journal) >= JOURNAL_POINTS - 2);
        check(whirl_journal_close(journal));
        bytes[at] ^= 0x10u;
    }
    free(bytes);
}

static void states_are_taken(void **state) {
    const fixture *f = *state;
    double revolutions = 0.0;
    size_t size;
    whirl_journal *other = begun(f, f->other);
    const whirl_point_state far = {0, 2, 30.0, "far", 4};
    whirl_journal_store(other)->save(whirl_journal_store(other)->context, 1, &far, 1);
    check(whirl_journal_close(other));
    whirl_journal *journal = begun(f, f->own);
    const whirl_point_store *store = whirl_journal_store(journal);
    assert_null(store->saved(store->context, 0, 2, &revolutions, &size));
    check(whirl_journal_take(journal, f->other));
    char *found = store->saved(store->context, 0, 2, &revolutions, &size);
    assert_non_null(found);
    assert_true(size == 4 && revolutions == 30.0);
    assert_string_equal(found, "far");
    free(found);
    check(whirl_journal_discard(f->other)); // its states, too: the folder must be empty in the end
    check(whirl_journal_remove(journal));
}

int main(void) {
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        IN_FOLDER(points_are_taken_once),     IN_FOLDER(a_part_takes_its_own),
        IN_FOLDER(a_part_reserves_less),      IN_FOLDER(a_journal_in_use_is_read_and_not_removed),
        IN_FOLDER(other_studies_are_refused), IN_FOLDER(valid_parts_are_used),
        IN_FOLDER(states_are_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
