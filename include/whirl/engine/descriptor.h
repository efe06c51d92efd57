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

/// What may stand for a key.
typedef enum whirl_key_kind {
    WHIRL_KEY_NUMBER = 0, ///< a quantity with a unit (SI inside), or a plain number where unit is "1"
    WHIRL_KEY_WHOLE,      ///< a whole number
    WHIRL_KEY_CHOICE,     ///< one of the words in `choices`
    WHIRL_KEY_STATION,    ///< the name of a station
    WHIRL_KEY_STATIONS,   ///< two stations, "a, b"; one of them may be "ground" where the meaning says so
    WHIRL_KEY_NUMBERS,    ///< a number as above, or a list of at most WHIRL_MAX_LIST, or of so many equal lists
    WHIRL_KEY_NAME        ///< a name of what `choices` says: "shafts" or "materials"
} whirl_key_kind;

/// Sizes of what cases say.
enum {
    WHIRL_MAX_LIST = 32, ///< numbers of a list at most
    WHIRL_NAME_SIZE = 64 ///< bytes of a name of a station, parameter, method, ... with its end
};

/// A range: bounds are in the unit of the key; -INFINITY and INFINITY where there is none.
typedef struct whirl_range {
    double low, high;         ///< the bounds
    bool low_open, high_open; ///< the bound itself is excluded
} whirl_range;

/// A key of a case file as it describes itself.
typedef struct whirl_key {
    const char *name;     ///< as written in a case file
    const char *symbol;   ///< as in the literature, "" where there is none
    const char *unit;     ///< UDUNITS spelling of the SI unit ("N s/m"), "1" for a plain number, "" for words
    whirl_key_kind kind;  ///< what may stand for it
    bool required;        ///< it has no default
    const char *fallback; ///< default as text in `unit` ("0", "rk4"); "" where it is required or has none
    whirl_range range;    ///< of the number
    /// Words of a choice, separated by '|'; "" where the meaning says what may stand; what a name is of; NULL for other
    /// kinds.
    const char *choices;
    const char *meaning; ///< one line
    const char *source;  ///< author, year, equation; "" where there is nothing to cite
    const char *of;      ///< the key of its group without which it has no effect (an angle without its size); or NULL
} whirl_key;

/// Ranges for the tables.
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

/// What lies at the place of a member.
typedef enum whirl_member_type {
    WHIRL_MEMBER_WORD = 0, ///< char [WHIRL_NAME_SIZE]
    WHIRL_MEMBER_NUMBER,   ///< double
    WHIRL_MEMBER_WHOLE,    ///< int, or an enumeration
    WHIRL_MEMBER_FLAG,     ///< bool
    WHIRL_MEMBER_INDEX     ///< size_t
} whirl_member_type;

/// A member of a struct as it describes itself: an option of a run, a number of a station. What owns the struct has
/// one table, ended by a member without a part; cases, results, journals and exports walk it.
typedef struct whirl_member {
    const char *name;       ///< as results and programs have it; NULL where an earlier one has the same place
    whirl_member_type type; ///< of what lies there
    size_t offset;          ///< in the struct
    const char *part;       ///< the group of a case file where its key stands; "" where no case says it
    /// With unit, range and meaning also where no case says it. A flag is set by "yes", "true" and its own name. No
    /// default: it stays as it is where a case does not say it.
    whirl_key key;
    bool refined; ///< an advice may change it (whirl_advice_apply): results of refined points have it
} whirl_member;

/// A group of keys: an element, the station, a part of the study.
typedef struct whirl_group {
    const char *name;      ///< as written in a case file
    const char *meaning;   ///< one line
    const char *source;    ///< "" where there is nothing to cite
    const whirl_key *keys; ///< [key_count]
    size_t key_count;      ///< of keys
    /// Name of the key that is meant when a scalar stands in place of the mapping (`gravity: 9.81 m/s2`), or NULL.
    const char *shorthand;
    /// Tables whose members of this part stand here too, behind the keys, ended by NULL; or NULL.
    const whirl_member *(*const *tables)(void);
} whirl_group;

/// The keys of a group by index from 0, those of its tables included; NULL past the last.
const whirl_key *whirl_group_at(const whirl_group *group, size_t index);

/// The key of that name, or NULL.
const whirl_key *whirl_group_key(const whirl_group *group, const char *name);

/// The member of that name, or NULL.
const whirl_member *whirl_member_find(const whirl_member *table, const char *name);

/// The value of a member of any type but WHIRL_MEMBER_WORD in the struct at `object`, 0 or 1 of a flag.
double whirl_member_number(const whirl_member *member, const void *object);

/// Sets such a member; the value must be one of its type.
void whirl_member_set(const whirl_member *member, void *object, double value);

/// Sets a word (cut to WHIRL_NAME_SIZE - 1 bytes) or a flag by what a case says of it.
void whirl_member_say(const whirl_member *member, void *object, const char *word);

/// The text of any member: a word, true or false, or a number with the fewest digits that give it back.
void whirl_member_text(const whirl_member *member, const void *object, char text[WHIRL_NAME_SIZE]);

/// Sets all members that have a name and a default to it.
void whirl_members_default(const whirl_member *table, void *object);

/// WHIRL_BAD_INPUT with a sentence ("rtol is 0, expected a number above 0 and at most 1") when a number of the struct
/// is out of its range.
whirl_status whirl_members_check(const whirl_member *table, const void *object);

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
