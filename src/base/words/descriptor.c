#include "whirl/engine/descriptor.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST_WORD = 63 };

/// Writes the unit with a blank before it, " kg"; nothing for plain numbers and words.
static void unit_suffix(const char *unit, char *text, size_t size) {
    const bool plain = unit[0] == '\0' || strcmp(unit, "1") == 0;
    snprintf(text, size, "%s%s", plain ? "" : " ", plain ? "" : unit);
}

/// Writes which numbers a key expects: "a number above 0 kg", "a whole number from 1 to 1000", "a finite number".
static void describe_range(const whirl_key *key, char *text, size_t size) {
    const whirl_range *range = &key->range;
    const bool low = range->low > -INFINITY, high = range->high < INFINITY;
    const char *noun = key->kind == WHIRL_KEY_WHOLE ? "a whole number" : low || high ? "a number" : "a finite number";
    char unit[WHIRL_MESSAGE_SIZE / 4];
    unit_suffix(key->unit, unit, sizeof unit);
    if (low && high && !range->low_open && !range->high_open)
        snprintf(text, size, "%s from %.10g to %.10g%s", noun, range->low, range->high, unit);
    else if (low && high)
        snprintf(text, size, "%s %s %.10g and %s %.10g%s", noun, range->low_open ? "above" : "of at least", range->low,
                 range->high_open ? "below" : "at most", range->high, unit);
    else if (low)
        snprintf(text, size, "%s %s %.10g%s", noun, range->low_open ? "above" : "of at least", range->low, unit);
    else if (high)
        snprintf(text, size, "%s %s %.10g%s", noun, range->high_open ? "below" : "of at most", range->high, unit);
    else
        snprintf(text, size, "%s%s%s", noun, unit[0] ? " of" : "", unit);
}

static bool in_range(const whirl_range *range, double value) {
    const bool above = range->low_open ? value > range->low : value >= range->low;
    const bool below = range->high_open ? value < range->high : value <= range->high;
    return above && below;
}

whirl_status whirl_key_check_number(const whirl_key *key, double value) {
    const bool whole = key->kind != WHIRL_KEY_WHOLE || value == floor(value);
    if (isfinite(value) && whole && in_range(&key->range, value)) return whirl_ok();
    char expected[WHIRL_MESSAGE_SIZE / 2], unit[WHIRL_MESSAGE_SIZE / 4];
    describe_range(key, expected, sizeof expected);
    unit_suffix(key->unit, unit, sizeof unit);
    return whirl_fail(WHIRL_BAD_INPUT, "is %.10g%s, expected %s", value, unit, expected);
}

int whirl_key_choice(const whirl_key *key, const char *word) {
    const size_t length = strlen(word);
    int index = 0;
    for (const char *choice = key->choices; choice && length > 0; index++) {
        const size_t end = strcspn(choice, "|");
        if (end == length && strncmp(choice, word, length) == 0) return index;
        choice = choice[end] ? choice + end + 1 : NULL;
    }
    return -1;
}

static size_t descriptor_least(size_t a, size_t b) {
    return a < b ? a : b;
}

/// Returns the Damerau-Levenshtein distance in its restricted form (optimal string alignment): the number of
/// insertions, deletions, substitutions and swaps of neighbours.
static size_t spelling_distance(const char *a, size_t a_length, const char *b, size_t b_length) {
    size_t before[LONGEST_WORD + 1] = {0}, last[LONGEST_WORD + 1], now[LONGEST_WORD + 1];
    for (size_t j = 0; j <= b_length; j++) last[j] = j;
    for (size_t i = 1; i <= a_length; i++) {
        now[0] = i;
        for (size_t j = 1; j <= b_length; j++) {
            const size_t replaced = last[j - 1] + (a[i - 1] != b[j - 1]);
            now[j] = descriptor_least(replaced, descriptor_least(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = descriptor_least(now[j], before[j - 2] + 1);
        }
        memcpy(before, last, sizeof last);
        memcpy(last, now, sizeof now);
    }
    return last[b_length];
}

const char *whirl_nearest_name(const char *word, const char *const *names, size_t count) {
    const size_t length = strlen(word);
    if (length == 0 || length > LONGEST_WORD) return NULL;
    size_t best = (length < 3 ? 1 : length / 3) + 1;
    const char *nearest = NULL;
    for (size_t n = 0; n < count; n++) {
        const size_t other = strlen(names[n]);
        if (other == 0 || other > LONGEST_WORD) continue;
        const size_t distance = spelling_distance(word, length, names[n], other);
        if (distance >= best) continue;
        best = distance;
        nearest = names[n];
    }
    return nearest;
}
