/// Descriptors: how elements, stations and study settings describe their keys. One table drives case reading,
/// error messages, `whirl describe`, result metadata and the documentation.
#ifndef WHIRL_DESCRIPTOR_H
#define WHIRL_DESCRIPTOR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum whirl_key_kind {
    WHIRL_KEY_NUMBER = 0, ///< a quantity with a unit (SI inside), or a plain number where unit is "1"
    WHIRL_KEY_WHOLE,      ///< a whole number
    WHIRL_KEY_CHOICE,     ///< one of the words in `choices`
    WHIRL_KEY_STATION,    ///< the name of a station
    WHIRL_KEY_STATIONS,   ///< two stations, "a, b"; one of them may be "ground" where the meaning says so
    WHIRL_KEY_NUMBERS     ///< a number as above, or a list of at most WHIRL_MAX_LIST
} whirl_key_kind;

enum { WHIRL_MAX_LIST = 32 };

/// A range: bounds are in the unit of the key; -INFINITY and INFINITY where there is none.
typedef struct whirl_range {
    double low, high;
    bool low_open, high_open; ///< the bound itself is excluded
} whirl_range;

typedef struct whirl_key {
    const char *name;   ///< as written in a case file
    const char *symbol; ///< as in the literature, "" where there is none
    const char *unit;   ///< UDUNITS spelling of the SI unit ("N s/m"), "1" for a plain number, "" for words
    whirl_key_kind kind;
    bool required;
    const char *fallback; ///< default as text in `unit` ("0", "rk4"); "" where it is required or has none
    whirl_range range;
    /// Words of a choice, separated by '|'; "" where the meaning says what may stand; NULL for other kinds.
    const char *choices;
    const char *meaning; ///< one line
    const char *source;  ///< author, year, equation; "" where there is nothing to cite
} whirl_key;

/// Ranges for the tables.
#define WHIRL_ANY                                                                                                      \
    { -INFINITY, INFINITY, false, false }
#define WHIRL_POSITIVE                                                                                                 \
    { 0.0, INFINITY, true, false }
#define WHIRL_NOT_NEGATIVE                                                                                             \
    { 0.0, INFINITY, false, false }

/// A group of keys: an element, the station, a part of the study.
typedef struct whirl_group {
    const char *name;    ///< as written in a case file
    const char *meaning; ///< one line
    const char *source;  ///< "" where there is nothing to cite
    const whirl_key *keys;
    size_t key_count;
    /// Name of the key that is meant when a scalar stands in place of the mapping (`gravity: 9.81 m/s2`), or NULL.
    const char *shorthand;
} whirl_group;

/// The key of that name, or NULL.
const whirl_key *whirl_group_key(const whirl_group *group, const char *name);

/// WHIRL_BAD_INPUT with a sentence ("is -3 kg, expected a number above 0 kg") when the number is not finite, out of
/// the key's range or, for WHIRL_KEY_WHOLE, not whole.
whirl_status whirl_key_check_number(const whirl_key *key, double value);

/// Index of `word` among the key's choices, or -1.
int whirl_key_choice(const whirl_key *key, const char *word);

/// The name among `count` candidates that is nearest to `word` (Damerau-Levenshtein, at most a third of its
/// letters wrong, at least one), or NULL. Candidates are borrowed.
const char *whirl_nearest_name(const char *word, const char *const *names, size_t count);

#ifdef __cplusplus
}
#endif
#endif
