/// The units in which figures and pages may show their numbers, by the words that people write: "um, rpm, Hz, p-p".
#ifndef BASE_UNIT_WORDS_H
#define BASE_UNIT_WORDS_H

#include "whirl/status.h"

/// Kinds of quantities whose unit, or whose way of counting (amplitudes), a word chooses.
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
    /// Size of the unit: in SI; of frequencies in Hz; of amplitudes relative to zero-to-peak; of temperatures that of a
    /// degree. 0 for units that depend on the case (its length scale, orders of its running speed), and for systems.
    double size;
} unit_word;

/// The chosen words, one of each kind; NULL for kinds without a choice.
typedef struct unit_choice {
    const unit_word *of[UNIT_KINDS];
} unit_choice;

/// Returns all words; static, terminated by one whose word is NULL.
const unit_word *unit_words(void);

/// Returns the unit of a system of units ("US") for a kind; for UNIT_SYSTEM the unit of places along shafts and of
/// diameters. NULL if the system has none.
const unit_word *unit_of_system(const unit_word *system, unit_kind kind);

/// Reads "um, rpm, Hz, p-p": words in any order, separated by commas. "" chooses nothing. WHIRL_BAD_INPUT for an
/// unknown word, with the nearest one, and for two of a kind.
whirl_status unit_choice_read(const char *text, unit_choice *choice);

#endif
