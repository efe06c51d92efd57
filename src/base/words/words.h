/// Words: members by name, lists of names, numbers and units as text, UTF-8.
#ifndef BASE_WORDS_H
#define BASE_WORDS_H

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- members
// How tables of members are written.

/// A whirl_member: `field` of STRUCT, of type WHIRL_MEMBER_<TYPE>, with the parts of its key behind the others.
#define MEMBER(STRUCT, TYPE, name, field, part, refined, ...)                                                          \
    { name, WHIRL_MEMBER_##TYPE, offsetof(STRUCT, field), part, {__VA_ARGS__, NULL}, refined }

// ---------------------------------------------------------------- name_list
// Lists of names in one text, separated by blanks or commas.

/// Takes the first name off the list (cut to WHIRL_NAME_SIZE - 1 bytes); false if it is empty.
bool name_list_next(const char **list, char name[WHIRL_NAME_SIZE]);

// ---------------------------------------------------------------- number
// Numbers as text.

enum { NUMBER_SIZE = 32 };

/// Writes a finite number with a decimal point in every locale, with the fewest of 15, 16 or 17 significant digits that
/// give the same double back: 0.1, not 0.10000000000000001. A number with at most 15 digits is written with these
/// alone.
void number_text(double value, char text[NUMBER_SIZE]);

// ---------------------------------------------------------------- unit_words
// The units in which figures and pages may show their numbers, by the words that people write: "um, rpm, Hz, p-p".

/// Kinds of units, or of counting, that a word may name.
typedef enum unit_kind {
    UNIT_LENGTH = 0,
    UNIT_SPEED,
    UNIT_FREQUENCY,
    UNIT_AMPLITUDE,
    UNIT_FORCE,
    UNIT_MASS,
    UNIT_STIFFNESS,
    UNIT_DAMPING,
    UNIT_MOMENT,
    UNIT_INERTIA,
    UNIT_UNBALANCE,
    UNIT_DENSITY,
    UNIT_PRESSURE,
    UNIT_FLOW,
    UNIT_POWER,
    UNIT_TEMPERATURE,
    UNIT_VISCOSITY,
    UNIT_WEIGHT, ///< masses of the weights that balance a rotor
    UNIT_SYSTEM, ///< default for all quantities without a unit of their own
    UNIT_KINDS
} unit_kind;

typedef struct unit_word {
    const char *word, *shown; ///< as written, and as shown
    unit_kind kind;
    /// Size in SI. 0 for lengths and frequencies of the case (the length scale, the order of the running speed), and
    /// for systems; frequencies in Hz; amplitudes relative to the zero-to-peak one; temperatures: size of a degree.
    double size;
} unit_word;

/// At most one word of each kind; NULL for kinds without a choice.
typedef struct unit_choice {
    const unit_word *of[UNIT_KINDS];
} unit_choice;

/// Returns all words; static, terminated by one whose word is NULL.
const unit_word *unit_words(void);

/// Returns the word of a system of units ("US") for a kind; for UNIT_SYSTEM that of places along shafts and of
/// diameters; NULL if it has none.
const unit_word *unit_of_system(const unit_word *system, unit_kind kind);

/// Reads "um, rpm, Hz, p-p": words in any order, separated by commas. "" chooses nothing. WHIRL_BAD_INPUT for an
/// unknown word, with the nearest one, and for two of a kind.
whirl_status unit_choice_read(const char *text, unit_choice *choice);

// ---------------------------------------------------------------- utf8
// UTF-8, as far as readers and reports need it.

/// Skips the byte order mark (Unicode 15, 23.8; YAML 1.2, 5.2) that editors of Windows write before a text in UTF-8:
/// returns the text after it and shortens `length`.
const char *utf8_skip_mark(const char *text, size_t *length);

/// Returns the size of the character at the start of `text`, 1 to 4 bytes, of which `left` may be read (at least one);
/// 0 if it is not valid: overlong forms, surrogates and truncated characters are invalid.
size_t utf8_length(const char *text, size_t left);

/// The same for a text that ends with a zero byte.
static inline size_t utf8_length_of_text(const char *text) {
    return utf8_length(text, 4);
}

/// Returns the code point of a valid character of `length` bytes.
unsigned utf8_character(const char *text, size_t length);

/// Returns true if a valid character of `length` bytes is safe to show. Unsafe are control characters (below U+0020,
/// U+007F to U+009F), which terminals obey; those that change the direction of a line (Unicode's Bidi_Control), so that
/// it reads otherwise than written; and U+2028 and U+2029, which end lines.
bool utf8_is_plain(const char *text, size_t length);

#endif
