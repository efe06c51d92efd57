/// The units in which figures and pages may show their numbers, by the words that people write: "um, rpm, Hz, p-p".
#ifndef BASE_UNIT_WORDS_H
#define BASE_UNIT_WORDS_H

#include "whirl/status.h"

/// What a word is a unit, or a way of counting, of.
typedef enum unit_kind { UNIT_LENGTH = 0, UNIT_SPEED, UNIT_FREQUENCY, UNIT_AMPLITUDE, UNIT_KINDS } unit_kind;

typedef struct unit_word {
    const char *word, *shown; ///< as it is written, and as it is shown
    unit_kind kind;
    /// Lengths in m, speeds in rad/s; 0 for those of the case (the length scale, the order of the running speed);
    /// frequencies in Hz; amplitudes over the zero-to-peak one.
    double size;
} unit_word;

/// At most one word of each kind; NULL where none was chosen.
typedef struct unit_choice {
    const unit_word *of[UNIT_KINDS];
} unit_choice;

/// All words; static, ended by one whose word is NULL.
const unit_word *unit_words(void);

/// Reads "um, rpm, Hz, p-p": words in any order, between commas. "" chooses nothing. WHIRL_BAD_INPUT, with the nearest
/// word, for one that is unknown, and for two of a kind.
whirl_status unit_choice_read(const char *text, unit_choice *choice);

#endif
