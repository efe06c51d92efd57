/// Descriptors: tables in which elements, stations and study settings describe their keys. One table drives case
/// reading, error messages, `whirl describe`, result metadata and the documentation.
#ifndef WHIRL_DESCRIPTOR_H
#define WHIRL_DESCRIPTOR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Kinds of values of a key.
typedef enum whirl_key_kind {
    WHIRL_KEY_NUMBER = 0, ///< a quantity with a unit (SI inside); a plain number if the unit is "1"
    WHIRL_KEY_WHOLE,      ///< a whole number
    WHIRL_KEY_CHOICE,     ///< one of the words in `choices`
    WHIRL_KEY_STATION,    ///< the name of a station
    WHIRL_KEY_STATIONS,   ///< two stations, "a, b"; one may be "ground" if the meaning says so
    WHIRL_KEY_NUMBERS,    ///< a number as above, a list of up to WHIRL_MAX_LIST numbers, or up to that many lists of
                          ///< equal length
    WHIRL_KEY_NAME        ///< a name of the kind in `choices`: "shafts" or "materials"
} whirl_key_kind;

/// Sizes of lists and names in cases.
enum {
    WHIRL_MAX_LIST = 32, ///< most numbers of a list
    WHIRL_NAME_SIZE = 64 ///< bytes of a name (station, parameter, method, ...) with its terminating zero
};

/// A range, in the unit of the key; -INFINITY and INFINITY for no bound.
typedef struct whirl_range {
    double low, high;         ///< the bounds
    bool low_open, high_open; ///< the bound itself is excluded
} whirl_range;

/// Description of a key of a case file.
typedef struct whirl_key {
    const char *name;     ///< as written in a case file
    const char *symbol;   ///< as in the literature, "" if it has none
    const char *unit;     ///< UDUNITS spelling of the SI unit ("N s/m"), "1" for a plain number, "" for words
    whirl_key_kind kind;  ///< kind of its values
    bool required;        ///< true if it has no default
    const char *fallback; ///< default as text in `unit` ("0", "rk4"); "" if it is required or has none
    whirl_range range;    ///< allowed numbers
    /// Words of a choice, separated by '|' ("" if `meaning` lists them); the kind of a name; NULL for other kinds.
    const char *choices;
    const char *meaning; ///< one line
    const char *source;  ///< author, year, equation; "" if nothing is cited
    const char *of;      ///< the key of its group without which it has no effect (the size, for an angle); or NULL
} whirl_key;

/// The range of all numbers.
#define WHIRL_ANY                                                                                                      \
    { -INFINITY, INFINITY, false, false }
/// Above 0.
#define WHIRL_POSITIVE                                                                                                 \
    { 0.0, INFINITY, true, false }
/// 0 and above.
#define WHIRL_NOT_NEGATIVE                                                                                             \
    { 0.0, INFINITY, false, false }
/// Both bounds included.
#define WHIRL_FROM_TO(low, high)                                                                                       \
    { low, high, false, false }
/// The lower bound excluded.
#define WHIRL_ABOVE_TO(low, high)                                                                                      \
    { low, high, true, false }

/// Types of members of a struct.
typedef enum whirl_member_type {
    WHIRL_MEMBER_WORD = 0, ///< char [WHIRL_NAME_SIZE]
    WHIRL_MEMBER_NUMBER,   ///< double
    WHIRL_MEMBER_WHOLE,    ///< int, or an enumeration
    WHIRL_MEMBER_FLAG,     ///< bool
    WHIRL_MEMBER_INDEX     ///< size_t
} whirl_member_type;

/// Description of a member of a struct: an option of a run, a number of a station. The owner of the struct has one
/// table, ended by a member without a part; cases, results, journals and exports walk it.
typedef struct whirl_member {
    const char *name;       ///< name in results and programs; NULL if an earlier member has the same offset
    whirl_member_type type; ///< type of the member
    size_t offset;          ///< in the struct
    const char *part;       ///< the group of a case file that has its key; "" if cases cannot set it
    /// The key in cases; unit, range and meaning are always given. In a case, "yes", "true" and the key's own name set
    /// a flag. If the key has no default, a case without it leaves the member unchanged.
    whirl_key key;
    bool refined; ///< true if whirl_advice_apply may change the member; results of refined points then contain it
} whirl_member;

/// A group of keys: an element, the station, a part of the study.
typedef struct whirl_group {
    const char *name;      ///< as written in a case file
    const char *meaning;   ///< one line
    const char *source;    ///< "" if nothing is cited
    const whirl_key *keys; ///< [key_count]
    size_t key_count;      ///< number of keys
    /// The key that a scalar in place of the mapping sets (`gravity: 9.81 m/s2`), or NULL.
    const char *shorthand;
    /// Tables whose members of this part follow the keys, ended by NULL; or NULL.
    const whirl_member *(*const *tables)(void);
} whirl_group;

/// Returns a key of a group by index from 0, those of its tables included; NULL past the last.
const whirl_key *whirl_group_at(const whirl_group *group, size_t index);

/// Returns the key of that name, or NULL.
const whirl_key *whirl_group_key(const whirl_group *group, const char *name);

/// Returns the member of that name, or NULL.
const whirl_member *whirl_member_find(const whirl_member *table, const char *name);

/// Returns the value of a member of the struct at `object`, 0 or 1 for a flag; not for WHIRL_MEMBER_WORD.
double whirl_member_number(const whirl_member *member, const void *object);

/// Sets a member other than WHIRL_MEMBER_WORD; the value must suit its type.
void whirl_member_set(const whirl_member *member, void *object, double value);

/// Sets a word (cut to WHIRL_NAME_SIZE - 1 bytes) or a flag from the word in a case.
void whirl_member_say(const whirl_member *member, void *object, const char *word);

/// Writes a member of any type as text: a word, true or false, or a number with the fewest digits that restore it.
void whirl_member_text(const whirl_member *member, const void *object, char text[WHIRL_NAME_SIZE]);

/// Sets all members that have a name and a default to their defaults.
void whirl_members_default(const whirl_member *table, void *object);

/// Returns WHIRL_BAD_INPUT with a sentence ("rtol is 0, expected a number above 0 and at most 1") if a number of the
/// struct is out of its range.
whirl_status whirl_members_check(const whirl_member *table, const void *object);

/// Returns WHIRL_BAD_INPUT with a sentence ("is -3 kg, expected a number above 0 kg") if the number is not finite, out
/// of the key's range or, for WHIRL_KEY_WHOLE, not whole.
whirl_status whirl_key_check_number(const whirl_key *key, double value);

/// Returns the index of `word` among the key's choices, or -1.
int whirl_key_choice(const whirl_key *key, const char *word);

/// Returns the name nearest to `word` among `count` candidates (Damerau-Levenshtein, at least one and at most a third
/// of its letters wrong), or NULL. Borrowed from the candidates.
const char *whirl_nearest_name(const char *word, const char *const *names, size_t count);

#ifdef __cplusplus
}
#endif
#endif
