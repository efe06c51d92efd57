// Journals: a written point comes back to the bit or not at all, whatever happens to the file.
#include <math.h>
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

#include "crc32c.h"
#include "expect.h"
#include "journal_frame.h"
#include "journal_points.h"
#include "whole.h"

typedef struct fixture {
    char folder[64], path[96];
    whirl_result *outline;
} fixture;

static int setup(void **state) {
    fixture *f = calloc(1, sizeof *f);
    if (!f) return -1;
    // Thousands of syncs: in memory, where there is such a place.
    snprintf(f->folder, sizeof f->folder, "%s/whirl-journal-XXXXXX", access("/dev/shm", W_OK) ? "/tmp" : "/dev/shm");
    if (!mkdtemp(f->folder)) return -1;
    snprintf(f->path, sizeof f->path, "%s/r.h5.journal", f->folder);
    f->outline = synthetic_result();
    unsetenv("WHIRL_ISA");
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    remove(f->path);
    const int failed = rmdir(f->folder);
    whirl_result_free(f->outline);
    free(f);
    return failed;
}

static whirl_journal *resumed(const fixture *f) {
    whirl_journal *journal;
    check(whirl_journal_resume(f->path, f->outline, &journal));
    return journal;
}

/// Makes a closed journal of the first `count` points.
static void make(const fixture *f, size_t count) {
    whirl_journal *journal;
    remove(f->path);
    check(whirl_journal_begin(f->path, f->outline, &journal));
    for (size_t i = 0; i < count; ++i) check(point_write(journal, i));
    assert_int_equal(whirl_journal_points(journal), count);
    check(whirl_journal_close(journal));
}

static void set_bytes(const fixture *f, const unsigned char *bytes, size_t size) {
    FILE *file = fopen(f->path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

// ---------------------------------------------------------------- parts

/// CRC-32C has the values of RFC 3720, appendix B.4, and the usual check value of nine digits.
static void checksums_are_those_of_the_standard(void **state) {
    unsigned char bytes[32] = {0};
    (void)state;
    assert_int_equal(crc32c(0, bytes, 32), 0x8a9136aa);
    memset(bytes, 0xff, 32);
    assert_int_equal(crc32c(0, bytes, 32), 0x62a8ab43);
    for (unsigned char i = 0; i < 32; ++i) bytes[i] = i;
    assert_int_equal(crc32c(0, bytes, 32), 0x46dd794e);
    assert_int_equal(crc32c(crc32c(0, bytes, 13), bytes + 13, 19), 0x46dd794e);
    assert_int_equal(crc32c(0, "123456789", 9), 0xe3069283);
}

static void written_points_are_recalled(void **state) {
    fixture *f = *state;
    whirl_journal *journal;
    check(whirl_journal_begin(f->path, f->outline, &journal));
    assert_int_equal(count_recalled(journal), 0);
    check(point_write(journal, 3));
    check(point_write(journal, 1));
    check(whirl_journal_close(journal));
    journal = resumed(f);
    const whirl_journal_found found = whirl_journal_look(journal);
    assert_true(found.points == 2 && found.damaged == 0 && !found.torn);
    assert_true(!point_recall(journal, 0) && point_recall(journal, 1) && !point_recall(journal, 2));
    assert_true(point_recall(journal, 3));
    check(point_write(journal, 0));
    check(point_write(journal, 2));
    check(whirl_journal_close(journal));
    journal = resumed(f);
    assert_int_equal(count_recalled(journal), JOURNAL_POINTS);
    check(whirl_journal_remove(journal));
    assert_int_not_equal(access(f->path, F_OK), 0);
}

// ---------------------------------------------------------------- points under way

static void save_state(whirl_journal *journal, size_t worker, size_t slot, double revolutions, const char *text) {
    const whirl_point_store *store = whirl_journal_store(journal);
    const whirl_point_state states[] = {{0, slot, revolutions, text, strlen(text) + 1}, {1, 0, 5.0, "detail", 7}};
    store->save(store->context, worker, states, 2);
}

static void expect_state(whirl_journal *journal, size_t batch, size_t slot, const char *text) {
    const whirl_point_store *store = whirl_journal_store(journal);
    size_t size = 0;
    double revolutions = 0.0;
    char *found = store->saved(store->context, batch, slot, &revolutions, &size);
    if (!text) {
        assert_null(found);
        return;
    }
    assert_non_null(found);
    assert_true(size == strlen(text) + 1 && revolutions >= 5.0);
    assert_string_equal(found, text);
    free(found);
}

/// The newest state of a motion counts, of any thread and run; a damaged one is not used.
static void states_come_back(void **state) {
    fixture *f = *state;
    whirl_journal *journal;
    char first[200], second[200];
    snprintf(first, sizeof first, "%s-0", f->path);
    snprintf(second, sizeof second, "%s-4", f->path);
    check(whirl_journal_begin(f->path, f->outline, &journal));
    save_state(journal, 0, 2, 10.0, "old");
    save_state(journal, 0, 2, 30.0, "far");
    save_state(journal, 3, 2, 20.0, "near");
    check(whirl_journal_close(journal));
    journal = resumed(f);
    expect_state(journal, 0, 2, "far");
    expect_state(journal, 1, 0, "detail");
    expect_state(journal, 0, 1, NULL);
    save_state(journal, 0, 2, 40.0, "further");
    expect_state(journal, 0, 2, "far"); // of earlier runs
    check(whirl_journal_close(journal));
    assert_int_equal(access(second, F_OK), 0);
    FILE *file = fopen(second, "r+b");
    assert_true(file && fseek(file, 50, SEEK_SET) == 0 && fputc('F', file) == 'F' && fclose(file) == 0);
    journal = resumed(f);
    expect_state(journal, 0, 2, "far");
    check(whirl_journal_remove(journal));
    assert_true(access(first, F_OK) != 0 && access(second, F_OK) != 0);
}

/// A run that begins anew does not use saved states, and neither does another study.
static void states_of_other_runs_are_not_taken(void **state) {
    fixture *f = *state;
    whirl_journal *journal;
    char states[200], aside[200];
    snprintf(states, sizeof states, "%s-1", f->path);
    snprintf(aside, sizeof aside, "%s/aside", f->folder);
    check(whirl_journal_begin(f->path, f->outline, &journal));
    save_state(journal, 0, 2, 10.0, "old");
    check(whirl_journal_close(journal));
    remove(f->path);
    check(whirl_journal_begin(f->path, f->outline, &journal));
    expect_state(journal, 0, 2, NULL);
    save_state(journal, 0, 2, 10.0, "old");
    check(whirl_journal_close(journal));
    remove(f->path);
    f->outline->parameters[0].value += 1.0;
    check(whirl_journal_begin(f->path, f->outline, &journal));
    save_state(journal, 1, 2, 10.0, "other");
    check(whirl_journal_close(journal));
    f->outline->parameters[0].value -= 1.0;
    assert_int_equal(rename(states, aside), 0);
    make(f, 1);
    assert_int_equal(rename(aside, states), 0);
    journal = resumed(f);
    expect_state(journal, 0, 2, NULL);
    check(whirl_journal_remove(journal));
}

// ---------------------------------------------------------------- what does not fit

static void blocks_of_another_size_are_not_taken(void **state) {
    fixture *f = *state;
    double block[BLOCK_SIZE + 1], end[STATE_SIZE];
    make(f, 2);
    whirl_journal *journal = resumed(f);
    const whirl_point_store *store = whirl_journal_store(journal);
    assert_false(store->recall(store->context, 0, 1, block, BLOCK_SIZE + 1, end, STATE_SIZE));
    assert_false(store->recall(store->context, 0, 1, block, BLOCK_SIZE - 1, end, STATE_SIZE));
    assert_false(store->recall(store->context, 0, 99, block, BLOCK_SIZE, end, STATE_SIZE));
    assert_false(store->recall(store->context, 9, 0, block, BLOCK_SIZE, end, STATE_SIZE));
    assert_says(store->keep(store->context, 0, 99, block, 1, end, 1), WHIRL_BAD_INPUT, "no place for point 99");
    check(whirl_journal_close(journal));
}

static void one_run_at_a_time(void **state) {
    fixture *f = *state;
    whirl_journal *first, *second;
    assert_says(whirl_journal_resume(f->path, f->outline, &second), WHIRL_BAD_INPUT, "there is no journal");
    check(whirl_journal_begin(f->path, f->outline, &first));
    assert_says(whirl_journal_begin(f->path, f->outline, &second), WHIRL_BAD_INPUT, "is there already");
    assert_says(whirl_journal_resume(f->path, f->outline, &second), WHIRL_BAD_INPUT, "another run is writing");
    assert_null(second);
    check(whirl_journal_close(first));
    check(whirl_journal_close(resumed(f)));
}

/// The journal of a run that ended before its first point counts as vacant. One with points, with states or of another
/// study does not.
static void empty_journals_are_vacant(void **state) {
    const fixture *f = *state;
    whirl_journal *journal;
    check(whirl_journal_begin(f->path, f->outline, &journal));
    assert_false(whirl_journal_vacant(f->path)); // a run is writing it
    check(whirl_journal_close(journal));
    assert_true(whirl_journal_vacant(f->path));
    check(whirl_journal_discard(f->path));
    assert_false(whirl_journal_vacant(f->path));
    check(whirl_journal_begin(f->path, f->outline, &journal));
    save_state(journal, 0, 1, 17.0, "half");
    check(whirl_journal_close(journal));
    assert_false(whirl_journal_vacant(f->path));
    check(whirl_journal_discard(f->path));
    make(f, 1);
    assert_false(whirl_journal_vacant(f->path));
    set_bytes(f, (const unsigned char *)"a letter", 8);
    assert_false(whirl_journal_vacant(f->path));
}

static void places_that_take_no_journal(void **state) {
    fixture *f = *state;
    whirl_journal *journal;
    assert_says(whirl_journal_begin("/tmp/no/such/folder.journal", f->outline, &journal), WHIRL_IO_ERROR,
                "No such file");
    assert_says(whirl_journal_resume(f->folder, f->outline, &journal), WHIRL_IO_ERROR, "Is a directory");
    assert_int_equal(mkfifo(f->path, 0600), 0);
    assert_says(whirl_journal_resume(f->path, f->outline, &journal), WHIRL_BAD_INPUT, "no ordinary file");
}

// ---------------------------------------------------------------- of another study

static void refuse(const fixture *f, const char *words) {
    whirl_journal *journal;
    assert_says(whirl_journal_resume(f->path, f->outline, &journal), WHIRL_BAD_INPUT, words);
    assert_null(journal);
}

static void differences_are_named(void **state) {
    fixture *f = *state;
    whirl_result *study = f->outline;
    make(f, 2);
    strcpy(study->case_text, "whirl: 1\ntitle: other # by hand\n");
    refuse(f, "line 2 of the case was 'title: made # by hand' and is 'title: other # by hand'");
    strcpy(study->case_text, "whirl: 1\n");
    refuse(f, "line 2 of the case was 'title: made # by hand' and is no longer there");
    strcpy(study->case_text, "whirl: 1\ntitle: made # by hand\nmore: 1\n");
    refuse(f, "line 3 of the case is new: 'more: 1'");
    strcpy(study->case_text, "whirl: 1\ntitle: made # by hand\n");
    study->parameters[1].value = 660.0;
    refuse(f, "parameter omega was '650 rad/s' and is '660 rad/s'");
    study->parameters[1].value = 650.0;
    study->tables[0].values[1] = nextafter(study->tables[0].values[1], 1.0);
    refuse(f, "points of the sweep was");
    study->tables[0].values[1] = nextafter(study->tables[0].values[1], 0.0);
    study->tables[0].integrate.steps_per_revolution = 512;
    refuse(f, "steps_per_revolution of the sweep was '1024' and is '512'");
    study->tables[0].integrate.steps_per_revolution = 1024;
    study->tables[1].record.transient = 8;
    refuse(f, "transient of the detail was '7' and is '8'");
    study->tables[1].record.transient = 7;
    setenv("WHIRL_ISA", "scalar", 1);
    whirl_journal *journal;
    const whirl_status status = whirl_journal_resume(f->path, f->outline, &journal);
    if (status.code != WHIRL_OK) // on a processor that fuses
        assert_says(status, WHIRL_BAD_INPUT, "arithmetic was 'fused multiply-add' and is 'without");
    else
        check(whirl_journal_close(journal));
    unsetenv("WHIRL_ISA");
    journal = resumed(f);
    assert_int_equal(count_recalled(journal), 2);
    check(whirl_journal_close(journal));
}

static void frames_of_another_study_do_not_count(void **state) {
    fixture *f = *state;
    unsigned char *ours, *theirs;
    size_t our_size, their_size;
    make(f, 1);
    check(whole_file(f->path, &ours, &our_size));
    f->outline->parameters[1].value = 651.0; // an identity of the same length
    make(f, JOURNAL_POINTS);
    check(whole_file(f->path, &theirs, &their_size));
    f->outline->parameters[1].value = 650.0;
    const size_t frame = frame_size(BLOCK_SIZE, STATE_SIZE), tail = their_size - JOURNAL_POINTS * frame;
    assert_int_equal(our_size, tail + frame);
    // Our header and point, then theirs.
    memcpy(theirs, ours, our_size);
    set_bytes(f, theirs, their_size);
    whirl_journal *journal = resumed(f);
    assert_int_equal(count_recalled(journal), 1);
    check(whirl_journal_close(journal));
    free(ours);
    free(theirs);
}

// ---------------------------------------------------------------- damage

/// Continues from the points that are known, as a run would; returns their number.
static int go_on(const fixture *f) {
    whirl_journal *journal = resumed(f);
    int known = 0;
    for (size_t i = 0; i < JOURNAL_POINTS; ++i) {
        const int one = point_recall(journal, i);
        if (!one) check(point_write(journal, i));
        known += one;
    }
    check(whirl_journal_close(journal));
    journal = resumed(f);
    assert_int_equal(count_recalled(journal), JOURNAL_POINTS);
    check(whirl_journal_close(journal));
    return known;
}

/// A kill may cut the last write at any byte.
static void every_cut_loses_no_whole_point(void **state) {
    fixture *f = *state;
    unsigned char *bytes;
    size_t size;
    make(f, JOURNAL_POINTS);
    check(whole_file(f->path, &bytes, &size));
    const size_t frame = frame_size(BLOCK_SIZE, STATE_SIZE), header = size - JOURNAL_POINTS * frame;
    for (size_t cut = 0; cut <= size; ++cut) {
        set_bytes(f, bytes, cut);
        whirl_journal *journal = resumed(f);
        const whirl_journal_found found = whirl_journal_look(journal);
        const size_t whole = cut < header ? 0 : (cut - header) / frame;
        assert_int_equal(found.points, whole);
        assert_int_equal(found.damaged, 0);
        assert_true(found.torn == (cut > header && (cut - header) % frame != 0));
        check(whirl_journal_close(journal));
        assert_int_equal(go_on(f), (int)whole);
    }
    free(bytes);
}

/// If any byte is changed, in each bit in turn, at most its point is lost, and the loss is reported.
static void every_flipped_byte_costs_one_point_at_most(void **state) {
    fixture *f = *state;
    unsigned char *bytes;
    size_t size;
    make(f, JOURNAL_POINTS);
    check(whole_file(f->path, &bytes, &size));
    const size_t header = size - JOURNAL_POINTS * frame_size(BLOCK_SIZE, STATE_SIZE);
    for (size_t i = 0; i < size; ++i) {
        const unsigned char before = bytes[i];
        bytes[i] = (unsigned char)(before ^ (i % 9 == 8 ? 0xffu : 1u << i % 9));
        set_bytes(f, bytes, size);
        bytes[i] = before;
        whirl_journal *journal = resumed(f);
        const whirl_journal_found found = whirl_journal_look(journal);
        assert_int_equal(found.points, i < header ? JOURNAL_POINTS : JOURNAL_POINTS - 1);
        assert_true(found.damaged == 1 || found.torn);
        check(whirl_journal_close(journal));
        assert_int_equal(go_on(f), (int)found.points);
        // A mended header is sound again.
        journal = resumed(f);
        if (i < header) assert_int_equal(whirl_journal_look(journal).damaged, 0);
        check(whirl_journal_close(journal));
    }
    free(bytes);
}

/// Ranges of bytes may be lost, moved or filled with zeros, as a file system may leave them.
static void lost_stretches_cost_their_points_only(void **state) {
    fixture *f = *state;
    unsigned char *bytes;
    size_t size;
    make(f, JOURNAL_POINTS);
    check(whole_file(f->path, &bytes, &size));
    const size_t frame = frame_size(BLOCK_SIZE, STATE_SIZE), header = size - JOURNAL_POINTS * frame;
    unsigned char *changed = malloc(size + 64);
    assert_non_null(changed);
    // The second frame is missing; some bytes are too many before the third.
    memcpy(changed, bytes, header + frame);
    memset(changed + header + frame, 0xf7, 21);
    memcpy(changed + header + frame + 21, bytes + header + 2 * frame, 2 * frame);
    set_bytes(f, changed, header + 3 * frame + 21);
    whirl_journal *journal = resumed(f);
    assert_int_equal(whirl_journal_look(journal).points, 3);
    assert_int_equal(whirl_journal_look(journal).damaged, 1);
    check(whirl_journal_close(journal));
    // Zeros from the middle of the second frame into the third.
    memcpy(changed, bytes, size);
    memset(changed + header + frame + frame / 2, 0, frame);
    set_bytes(f, changed, size);
    assert_int_equal(go_on(f), 2);
    // Zeros at the end: a torn tail.
    memset(changed, 0, size + 64);
    memcpy(changed, bytes, header + 2 * frame);
    set_bytes(f, changed, size + 64);
    journal = resumed(f);
    assert_true(whirl_journal_look(journal).torn);
    check(whirl_journal_close(journal));
    assert_int_equal(go_on(f), 2);
    free(changed);
    free(bytes);
}

static void a_frame_that_changes_later_is_not_recalled(void **state) {
    fixture *f = *state;
    make(f, JOURNAL_POINTS);
    whirl_journal *journal = resumed(f);
    FILE *file = fopen(f->path, "r+b");
    assert_non_null(file);
    assert_int_equal(fseek(file, -20, SEEK_END), 0);
    assert_int_equal(fputc('x', file), 'x');
    assert_int_equal(fclose(file), 0);
    assert_int_equal(point_recall(journal, JOURNAL_POINTS - 1), 0);
    assert_int_equal(count_recalled(journal), JOURNAL_POINTS - 1);
    check(whirl_journal_close(journal));
}

static void other_files_are_left_alone(void **state) {
    static const char *const texts[] = {"not a journal at all\n", "whirl journal 2\nof a later version", "w"};
    fixture *f = *state;
    for (size_t i = 0; i < 2; ++i) {
        unsigned char *bytes;
        size_t size;
        set_bytes(f, (const unsigned char *)texts[i], strlen(texts[i]));
        refuse(f, "is no journal of this study");
        check(whole_file(f->path, &bytes, &size));
        assert_int_equal(size, strlen(texts[i]));
        assert_memory_equal(bytes, texts[i], size);
        free(bytes);
    }
    // The beginning of a header is what a run leaves that is killed at once.
    set_bytes(f, (const unsigned char *)texts[2], 1);
    assert_int_equal(go_on(f), 0);
}

int main(void) {
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(checksums_are_those_of_the_standard),
        IN_FOLDER(written_points_are_recalled),
        IN_FOLDER(states_come_back),
        IN_FOLDER(states_of_other_runs_are_not_taken),
        IN_FOLDER(blocks_of_another_size_are_not_taken),
        IN_FOLDER(one_run_at_a_time),
        IN_FOLDER(empty_journals_are_vacant),
        IN_FOLDER(places_that_take_no_journal),
        IN_FOLDER(differences_are_named),
        IN_FOLDER(frames_of_another_study_do_not_count),
        IN_FOLDER(every_cut_loses_no_whole_point),
        IN_FOLDER(every_flipped_byte_costs_one_point_at_most),
        IN_FOLDER(lost_stretches_cost_their_points_only),
        IN_FOLDER(a_frame_that_changes_later_is_not_recalled),
        IN_FOLDER(other_files_are_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
