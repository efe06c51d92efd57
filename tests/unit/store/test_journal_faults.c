// Every call of the operating system fails in turn while a journal and a result are written: acknowledged points are
// not lost, and no unreadable file remains.
#define _GNU_SOURCE // fallocate
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cmocka.h>

#include "journal_points.h"
#include "same.h"

// ---------------------------------------------------------------- calls that fail on demand

enum { SHORT_WRITE = -1, NEVER = -1 };

/// The call that fails, counted from 0; with which errno, or SHORT_WRITE; and whether all later ones fail too.
static struct {
    int calls, failing, reason;
    bool for_good;
} fault = {.failing = NEVER};

static bool strikes(void) {
    const int call = fault.calls++;
    return fault.failing != NEVER && (call == fault.failing || (fault.for_good && call > fault.failing));
}

/// Returns true if the call fails, with errno set; a call that writes nothing cannot be short.
static bool fails(void) {
    if (!strikes() || fault.reason == SHORT_WRITE) return false;
    errno = fault.reason;
    return true;
}

/// Returns true if a call fails that no signal interrupts on a local disk.
static bool fails_for_good(void) {
    return fails() && errno != EINTR;
}

/// Replacements of functions of the C library, for everything that is linked here.
ssize_t pwrite(int file, const void *bytes, size_t size, off_t offset) {
    if (strikes()) {
        if (fault.reason != SHORT_WRITE) {
            errno = fault.reason;
            return -1;
        }
        size = size > 1 ? size / 2 : size;
    }
    return syscall(SYS_pwrite64, file, bytes, size, offset);
}

ssize_t pread(int file, void *bytes, size_t size, off_t offset) {
    if (strikes()) {
        if (fault.reason != SHORT_WRITE) {
            errno = fault.reason;
            return -1;
        }
        size = size > 1 ? size / 2 : size;
    }
    return syscall(SYS_pread64, file, bytes, size, offset);
}

int fdatasync(int file) {
    return fails() ? -1 : (int)syscall(SYS_fdatasync, file);
}

int fsync(int file) {
    return fails_for_good() ? -1 : (int)syscall(SYS_fsync, file);
}

int ftruncate(int file, off_t size) {
    return fails() ? -1 : (int)syscall(SYS_ftruncate, file, size);
}

int fallocate(int file, int mode, off_t offset, off_t size) {
    return fails() ? -1 : (int)syscall(SYS_fallocate, file, mode, offset, size);
}

int rename(const char *from, const char *to) {
    return fails_for_good() ? -1 : (int)syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to);
}

int unlink(const char *path) {
    return fails_for_good() ? -1 : (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
}

int open(const char *path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return fails_for_good() ? -1 : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

/// Replaces fflush, at which a stream is written to the disk.
int fflush(FILE *stream) {
    if (stream != stdout && stream != stderr && stream && fails_for_good()) return EOF;
    return fflush_unlocked(stream);
}

static void arm(int failing, int reason, bool for_good) {
    fault.calls = 0;
    fault.failing = failing;
    fault.reason = reason;
    fault.for_good = for_good;
}

static void disarm(void) {
    fault.failing = NEVER;
}

// ---------------------------------------------------------------- a run

typedef struct fixture {
    char folder[64], journal[96], result[96];
    whirl_result *made;
} fixture;

static int setup(void **state) {
    fixture *f = calloc(1, sizeof *f);
    if (!f) return -1;
    snprintf(f->folder, sizeof f->folder, "%s/whirl-faults-XXXXXX", access("/dev/shm", W_OK) ? "/tmp" : "/dev/shm");
    if (!mkdtemp(f->folder)) return -1;
    snprintf(f->result, sizeof f->result, "%s/r.h5", f->folder);
    snprintf(f->journal, sizeof f->journal, "%s/r.h5.journal", f->folder);
    f->made = synthetic_result();
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", f->folder);
    const int failed = system(command);
    whirl_result_free(f->made);
    free(f);
    return failed;
}

/// The steps that a run completed. `written` includes a verification: the file has every number of the result.
typedef struct run_steps {
    bool begun, acknowledged[JOURNAL_POINTS], closed, written, removed;
} run_steps;

static bool well(whirl_status status) {
    if (status.code != WHIRL_OK && !status.message[0]) fail_msg("an error without a sentence");
    return status.code == WHIRL_OK;
}

/// Begins or continues a journal, writes the points that it lacks, and ends as `whirl run` does; an error ends the run.
static run_steps run(const fixture *f) {
    run_steps t = {0};
    whirl_journal *journal;
    const bool there = access(f->journal, F_OK) == 0;
    if (!well(there ? whirl_journal_resume(f->journal, f->made, &journal)
                    : whirl_journal_begin(f->journal, f->made, &journal)))
        return t;
    t.begun = true;
    bool going = true;
    for (size_t i = 0; i < JOURNAL_POINTS && going; ++i)
        going = t.acknowledged[i] = point_recall(journal, i) || well(point_write(journal, i));
    t.written = going && well(whirl_result_write(f->made, f->result)) && well(whirl_result_verify(f->made, f->result));
    if (t.written)
        t.removed = well(whirl_journal_remove(journal));
    else
        t.closed = well(whirl_journal_close(journal));
    return t;
}

static void expect_whole_result(const fixture *f) {
    whirl_result *read;
    const whirl_status status = whirl_result_read(f->result, &read);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    assert_true(same_result(f->made, read));
    whirl_result_free(read);
}

/// Checks that no acknowledged point is lost, and that an existing result is whole.
static void expect_safe(const fixture *f, const run_steps *t) {
    whirl_journal *journal;
    if (access(f->result, F_OK) == 0) expect_whole_result(f);
    if (t->written) assert_int_equal(access(f->result, F_OK), 0);
    if (access(f->journal, F_OK) != 0) {
        assert_true(!t->begun || t->written);
        return;
    }
    const whirl_status status = whirl_journal_resume(f->journal, f->made, &journal);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    for (size_t i = 0; i < JOURNAL_POINTS; ++i)
        if (t->acknowledged[i]) assert_int_equal(point_recall(journal, i), 1);
    assert_int_equal(whirl_journal_look(journal).damaged, 0);
    assert_int_equal(whirl_journal_close(journal).code, WHIRL_OK);
}

static void clean(const fixture *f) {
    remove(f->result);
    remove(f->journal);
}

static const char *const reasons[] = {"ENOSPC", "EIO", "EINTR", "short"};
static const int numbers[] = {ENOSPC, EIO, EINTR, SHORT_WRITE};

/// Returns true under `make soak`, which tries full and broken disks; other runs try one of them, since both take the
/// same paths.
static bool soaking(void) {
    return getenv("WHIRL_SOAK") != NULL;
}

/// Returns the step from one failing call to the next; under sanitizers, which look at memory alone, it is 3.
static int stride(void) {
    return getenv("WHIRL_SANITIZED") ? 3 : 1;
}

/// Checks the outcome: interruptions and short writes are no failures.
static void expect_outcome(const run_steps *t, int reason) {
    if (reason == SHORT_WRITE || reason == EINTR) assert_true(t->written && t->removed);
}

static void every_call_fails_once(void **state) {
    const fixture *f = *state;
    for (int kind = 0; kind < 4; ++kind) {
        if (numbers[kind] == EIO && !soaking()) continue;
        int failing = 0;
        for (bool struck = true; struck; failing += stride()) {
            clean(f);
            arm(failing, numbers[kind], false);
            const run_steps t = run(f);
            struck = fault.calls > failing;
            disarm();
            expect_outcome(&t, numbers[kind]);
            expect_safe(f, &t);
            const run_steps again = run(f);
            assert_true(again.written && again.removed);
        }
        printf("%s: %d calls\n", reasons[kind], failing - stride());
        assert_true(failing > 15);
    }
}

/// A disk that is full stays full; one that is broken stays broken.
static void every_call_and_all_later_ones_fail(void **state) {
    const fixture *f = *state;
    for (int kind = 0; kind < (soaking() ? 2 : 1); ++kind) {
        int failing = 0;
        for (bool struck = true; struck; failing += stride()) {
            clean(f);
            arm(failing, numbers[kind], true);
            const run_steps t = run(f);
            struck = fault.calls > failing;
            disarm();
            expect_safe(f, &t);
            const run_steps again = run(f);
            assert_true(again.written && again.removed);
        }
        assert_true(failing > 15);
    }
}

/// If any call of a continued run fails, the points of the earlier run stay.
static void every_call_fails_while_going_on(void **state) {
    const fixture *f = *state;
    for (int kind = soaking() ? 0 : 1; kind < 4; ++kind) {
        int failing = 0;
        for (bool struck = true; struck; failing += stride()) {
            whirl_journal *journal;
            clean(f);
            assert_true(well(whirl_journal_begin(f->journal, f->made, &journal)));
            assert_true(well(point_write(journal, 0)) && well(point_write(journal, 2)));
            assert_true(well(whirl_journal_close(journal)));
            // A torn frame that must be cut off.
            FILE *file = fopen(f->journal, "ab");
            assert_true(file && fputs("\xf7point\r\n and so on", file) >= 0 && fclose(file) == 0);
            arm(failing, numbers[kind], false);
            run_steps t = run(f);
            struck = fault.calls > failing;
            disarm();
            expect_outcome(&t, numbers[kind]);
            t.acknowledged[0] = t.acknowledged[2] = t.begun = true;
            expect_safe(f, &t);
            const run_steps again = run(f);
            assert_true(again.written && again.removed);
        }
        assert_true(failing > 15);
    }
}

/// A point that a full disk refused is written as soon as there is room, and so are the points after it.
static void a_refused_point_is_written_again(void **state) {
    const fixture *f = *state;
    whirl_journal *journal;
    clean(f);
    assert_true(well(whirl_journal_begin(f->journal, f->made, &journal)));
    assert_true(well(point_write(journal, 0)));
    arm(0, ENOSPC, true);
    const whirl_status full = point_write(journal, 1);
    assert_int_equal(full.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(full.message, "No space left"));
    assert_non_null(strstr(full.message, f->journal));
    assert_int_equal(point_write(journal, 2).code, WHIRL_IO_ERROR);
    assert_int_equal(whirl_journal_points(journal), 1);
    disarm();
    assert_true(well(whirl_journal_close(journal)));
    assert_true(well(whirl_journal_resume(f->journal, f->made, &journal)));
    assert_int_equal(count_recalled(journal), 3);
    assert_true(well(whirl_journal_remove(journal)));
}

static void a_full_disk_is_found_before_the_run(void **state) {
    const fixture *f = *state;
    whirl_journal *journal;
    clean(f);
    arm(1, ENOSPC, false); // after open
    const whirl_status status = whirl_journal_begin(f->journal, f->made, &journal);
    disarm();
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "no room for the points of the run"));
    assert_int_not_equal(access(f->journal, F_OK), 0);
}

/// Verifying sees any difference between the result and its file.
static void a_file_that_differs_is_found(void **state) {
    const fixture *f = *state;
    clean(f);
    assert_true(well(whirl_result_write(f->made, f->result)));
    assert_true(well(whirl_result_verify(f->made, f->result)));
    double *number = &f->made->tables[0].blocks[f->made->tables[0].layout.size + 3];
    const double before = *number;
    *number = -before;
    whirl_status status = whirl_result_verify(f->made, f->result);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "point 2 of the sweep differs"));
    *number = before;
    f->made->facts[0].value[0]++;
    assert_non_null(strstr(whirl_result_verify(f->made, f->result).message, "the provenance"));
    f->made->facts[0].value[0]--;
    f->made->stations[1].clearance = 2;
    assert_non_null(strstr(whirl_result_verify(f->made, f->result).message, "the stations"));
    f->made->stations[1].clearance = 1;
    assert_true(well(whirl_result_verify(f->made, f->result)));
    clean(f);
    assert_int_equal(whirl_result_verify(f->made, f->result).code, WHIRL_IO_ERROR);
}

/// The result of a stopped run lists its points.
static void partial_results_are_written_and_read(void **state) {
    const fixture *f = *state;
    whirl_table *sweep = &f->made->tables[0];
    size_t done, total;
    clean(f);
    sweep->done = calloc(sweep->count, 1);
    assert_non_null(sweep->done);
    sweep->done[1] = 1;
    assert_true(well(whirl_result_write(f->made, f->result)));
    assert_true(well(whirl_result_verify(f->made, f->result)));
    whirl_result *read;
    assert_true(well(whirl_result_read(f->result, &read)));
    assert_true(whirl_result_partial(read, &done, &total));
    assert_true(done == 2 && total == JOURNAL_POINTS);
    assert_int_equal(read->tables[0].count, 1);
    assert_int_equal(whirl_table_slot(&read->tables[0], 0), 1);
    assert_true(whirl_table_done(&read->tables[0], 0) && whirl_table_done(&read->tables[1], 0));
    whirl_result_free(read);
    sweep->done[0] = 1;
    assert_non_null(strstr(whirl_result_verify(f->made, f->result).message, "points of the sweep was '2"));
    // As many points of the same values, but others of the study.
    sweep->values[2] = sweep->values[1];
    sweep->branch[2] = sweep->branch[1];
    sweep->done[0] = sweep->done[1] = 0;
    sweep->done[2] = 1;
    assert_non_null(strstr(whirl_result_verify(f->made, f->result).message, "point 3 of the sweep differs"));
}

int main(void) {
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        IN_FOLDER(every_call_fails_once),
        IN_FOLDER(every_call_and_all_later_ones_fail),
        IN_FOLDER(every_call_fails_while_going_on),
        IN_FOLDER(a_refused_point_is_written_again),
        IN_FOLDER(a_full_disk_is_found_before_the_run),
        IN_FOLDER(a_file_that_differs_is_found),
        IN_FOLDER(partial_results_are_written_and_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
