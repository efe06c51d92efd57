// Messages of failures: how long they last, alone and among threads.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "first_error.h"
#include "whirl/status.h"

static void statuses_are_small(void **state) {
    (void)state;
    assert_int_equal(sizeof(whirl_status), 2 * sizeof(void *));
    assert_int_equal(whirl_ok().code, WHIRL_OK);
    assert_string_equal(whirl_ok().message, "");
}

static void sentences_are_cut(void **state) {
    char longest[2 * WHIRL_MESSAGE_SIZE];
    (void)state;
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    const whirl_status status = whirl_fail(WHIRL_IO_ERROR, "%s", longest);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_int_equal(strlen(status.message), WHIRL_MESSAGE_SIZE - 1);
    assert_memory_equal(status.message, longest, WHIRL_MESSAGE_SIZE - 4);
    assert_string_equal(status.message + WHIRL_MESSAGE_SIZE - 4, "...");
    // One of just that length is whole.
    longest[WHIRL_MESSAGE_SIZE - 1] = '\0';
    assert_string_equal(whirl_fail(WHIRL_IO_ERROR, "%s", longest).message, longest);
    // No character of several bytes is cut, wherever it stands.
    static const char *const characters[] = {"\u00b5", "\u20ac", "\U0001F600"};
    for (size_t i = 0; i < 3; i++)
        for (size_t before = 0; before < 4; before++) {
            const size_t width = strlen(characters[i]);
            memset(longest, 'x', before);
            size_t used = before;
            for (; used + width < sizeof longest; used += width) memcpy(longest + used, characters[i], width);
            longest[used] = '\0';
            const char *said = whirl_fail(WHIRL_IO_ERROR, "%s", longest).message;
            const size_t length = strlen(said) - 3;
            assert_string_equal(said + length, "...");
            assert_memory_equal(said, longest, length);
            assert_int_equal((length - before) % width, 0);
            assert_true(length + width > WHIRL_MESSAGE_SIZE - 4);
        }
}

static void equal_sentences_are_one(void **state) {
    const whirl_status held = whirl_fail(WHIRL_BAD_INPUT, "held %d", 1);
    (void)state;
    for (int i = 0; i < 10 * WHIRL_MESSAGES_KEPT; i++) {
        const whirl_status again = whirl_fail(WHIRL_NUMERICAL_FAILURE, "the step fell below %g", 1e-12);
        assert_int_equal(again.code, WHIRL_NUMERICAL_FAILURE);
    }
    assert_string_equal(held.message, "held 1");
}

static void a_sentence_outlasts_so_many_others(void **state) {
    const whirl_status held = whirl_fail(WHIRL_BAD_INPUT, "held %d", 2);
    (void)state;
    for (int i = 0; i < WHIRL_MESSAGES_KEPT - 1; i++) whirl_fail(WHIRL_BAD_INPUT, "other %d", i);
    assert_string_equal(held.message, "held 2");
    // Its age is that of its latest use.
    assert_ptr_equal(whirl_fail(WHIRL_BAD_INPUT, "held 2").message, held.message);
    for (int i = 0; i < WHIRL_MESSAGES_KEPT - 1; i++) whirl_fail(WHIRL_BAD_INPUT, "yet another %d", i);
    assert_string_equal(held.message, "held 2");
    whirl_fail(WHIRL_BAD_INPUT, "one too many");
    assert_string_not_equal(held.message, "held 2");
}

static void a_message_may_quote_another(void **state) {
    whirl_status status = whirl_fail(WHIRL_BAD_INPUT, "is 3, expected 4");
    (void)state;
    status = whirl_fail(status.code, "key %s", status.message);
    assert_string_equal(status.message, "key is 3, expected 4");
}

static void the_first_error_stays(void **state) {
    first_error error = {WHIRL_OK, ""};
    const whirl_status good = whirl_ok(), first = whirl_fail(WHIRL_IO_ERROR, "the first");
    (void)state;
    first_error_note(&error, &good);
    assert_string_equal(first_error_status(&error).message, "");
    first_error_note(&error, &first);
    for (int i = 0; i < 2 * WHIRL_MESSAGES_KEPT; i++) {
        const whirl_status later = whirl_fail(WHIRL_BAD_INPUT, "later %d", i);
        first_error_note(&error, &later);
    }
    assert_int_equal(first_error_status(&error).code, WHIRL_IO_ERROR);
    assert_string_equal(first_error_status(&error).message, "the first");
}

// ---------------------------------------------------------------- threads

enum { THREADS = 4, FAILURES = 20000, DIFFERENT = WHIRL_MESSAGES_KEPT / THREADS - 1 };

/// Fails in as many ways as all threads may have at a time, and reads every message after the next one was made.
static void *fail_often(void *context) {
    const int number = *(const int *)context;
    const char *before = "";
    char expected[64] = "";
    for (int i = 0; i < FAILURES; i++) {
        const whirl_status status = whirl_fail(WHIRL_BAD_INPUT, "thread %d failed %d", number, i % DIFFERENT);
        if (strcmp(before, expected) != 0) return context;
        snprintf(expected, sizeof expected, "thread %d failed %d", number, i % DIFFERENT);
        before = status.message;
    }
    return NULL;
}

static void threads_fail_side_by_side(void **state) {
    pthread_t threads[THREADS];
    int numbers[THREADS];
    (void)state;
    for (int i = 0; i < THREADS; i++) {
        numbers[i] = i;
        assert_int_equal(pthread_create(&threads[i], NULL, fail_often, &numbers[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        void *wrong;
        assert_int_equal(pthread_join(threads[i], &wrong), 0);
        assert_null(wrong);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statuses_are_small),          cmocka_unit_test(sentences_are_cut),
        cmocka_unit_test(equal_sentences_are_one),     cmocka_unit_test(a_sentence_outlasts_so_many_others),
        cmocka_unit_test(a_message_may_quote_another), cmocka_unit_test(the_first_error_stays),
        cmocka_unit_test(threads_fail_side_by_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
