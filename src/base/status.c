#include "whirl/status.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "lock.h"
#include "utf8.h"

// ---------------------------------------------------------------- where messages lie

/// The latest messages of all threads of the process. Equal ones share a place, so that a method that fails a thousand
/// times in one way evicts no other message.
static struct {
    uint64_t given;                     ///< messages so far
    uint64_t used[WHIRL_MESSAGES_KEPT]; ///< number of the latest message with this text; 0 without one
    uint64_t hash[WHIRL_MESSAGES_KEPT]; ///< hash of the text
    char text[WHIRL_MESSAGES_KEPT][WHIRL_MESSAGE_SIZE];
} latest;
static lock latest_lock = LOCK_OPEN;

/// FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv).
static uint64_t hash_of(const char *text) {
    uint64_t hash = 0xCBF29CE484222325U;
    for (; *text; text++) hash = (hash ^ (unsigned char)*text) * 0x100000001B3U;
    return hash;
}

/// Finds a text; returns true with its place, or false with the least recently used place.
static bool status_find(const char *text, uint64_t hash, size_t *place) {
    *place = 0;
    for (size_t i = 0; i < WHIRL_MESSAGES_KEPT; i++) {
        if (latest.used[i] < latest.used[*place]) *place = i;
        if (latest.hash[i] != hash || latest.used[i] == 0 || strcmp(latest.text[i], text) != 0) continue;
        *place = i;
        return true;
    }
    return false;
}

static const char *status_keep(const char text[WHIRL_MESSAGE_SIZE]) {
    const uint64_t hash = hash_of(text);
    size_t place;
    lock_take(&latest_lock);
    if (!status_find(text, hash, &place)) { // an existing text may be read at this moment and must not change
        latest.hash[place] = hash;
        memcpy(latest.text[place], text, strlen(text) + 1);
    }
    latest.used[place] = ++latest.given;
    lock_leave(&latest_lock);
    return latest.text[place];
}

// ---------------------------------------------------------------- statuses

whirl_status whirl_ok(void) {
    return (whirl_status){.code = WHIRL_OK, .message = ""};
}

/// Ends a sentence that was cut with "...", behind its last whole character of UTF-8.
static void status_end_cut(char text[WHIRL_MESSAGE_SIZE]) {
    memcpy(text + utf8_cut(text, WHIRL_MESSAGE_SIZE - sizeof "..."), "...", sizeof "...");
}

whirl_status whirl_fail(whirl_code code, const char *format, ...) {
    char text[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    if (vsnprintf(text, sizeof text, format, arguments) >= (int)sizeof text) status_end_cut(text);
    va_end(arguments);
    return (whirl_status){.code = code, .message = status_keep(text)};
}

const char *whirl_code_text(whirl_code code) {
    static const char *const texts[] = {
        [WHIRL_OK] = "done",
        [WHIRL_BAD_INPUT] = "bad input",
        [WHIRL_NO_MEMORY] = "out of memory",
        [WHIRL_IO_ERROR] = "input or output failed",
        [WHIRL_NUMERICAL_FAILURE] = "numerical failure",
        [WHIRL_STOPPED] = "stopped",
        [WHIRL_MISSING_PROGRAM] = "a program is missing",
    };
    return (unsigned)code < sizeof texts / sizeof *texts ? texts[code] : "unknown";
}
