/// A mapping of the file, read by the table of its group.
#ifndef CASE_SETTINGS_H
#define CASE_SETTINGS_H

#include "parameters.h"
#include "whirl/engine/bearing_table.h"
#include "whirl/engine/rotor.h"

enum { SETTINGS_MAX = 64 };

/// One key with what stands there.
typedef struct setting {
    const whirl_key *key;
    const file_node *place;
    bool good;               ///< no problem was found; what follows counts only then
    number_formula value;    ///< of numbers
    bool scaled;             ///< the value has the unit that schema_scaled_unit names: it is to be divided by its scale
    const char *word;        ///< of choices, texts, stations and lists ("a, b"); NULL for numbers and parts of the file
    struct setting *entries; ///< [entry_count] of a list in which expressions stand, in place of `word`; or NULL
    size_t entry_count, row_length; ///< of these, row after row
} setting;

typedef struct setting_list {
    const char *name; ///< of a station, or the kind of an element
    const whirl_group *group;
    const file_node *place;
    bool sound; ///< of an element: no problem was found while it was read
    size_t count;
    setting *items;
} setting_list;

/// Reads a mapping (or, for groups with a shorthand, a scalar; nothing counts as an empty mapping) and reports unknown,
/// missing and wrong keys. Numbers whose unit is "" and parts of the file are left to the caller: only `place` is set.
void settings_read(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *result);

/// Reads a mapping whose every value is a list of two numbers: the lower ends and the upper ends, in lists with the
/// same keys.
void settings_read_ranges(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *low,
                          setting_list *high);

/// Whether a key that is absent stands there misspelt, which has been said.
bool settings_misspelt(const setting_list *settings, const char *key);

/// The setting of a key if it was given, else NULL.
const setting *settings_find(const setting_list *settings, const char *key);

/// The numbers of a setting, each as a setting: the entries of a list in which expressions stand, else the setting
/// alone. Returns how many there are.
size_t setting_numbers(const setting *item, const setting **first);

/// Room for the text of a list in which expressions stand; 1 of others.
size_t setting_list_size(const setting *item);

/// Writes the numbers of such a list as rotors read them: "1, 2; 3, 4". Errors as valuation_number.
whirl_status setting_list_text(valuation *v, const setting *item, char *text);

/// Evaluates expressions and reports the ones that have no value or one out of range. false when any has.
bool settings_check(case_reader *reader, valuation *v, const setting_list *settings);

/// The value of a number, not yet divided by its scale, or the key's default. Only after settings_check.
double settings_number(valuation *v, const setting_list *settings, const char *key);

/// The value of a number in a file without parameters: an expression is a problem. What is absent has its default, NaN
/// without one.
double settings_plain(case_reader *reader, const setting_list *settings, const char *key);

/// The numbers of a list, or the one that stands for it or is its default, in a file without parameters: how many of at
/// most `most`; more are a problem. 0 where it is absent without a default, or wrong.
size_t settings_list_plain(case_reader *reader, const setting_list *settings, const char *key, double *out,
                           size_t most);

/// The word of a choice, or the key's default.
const char *settings_word(const setting_list *settings, const char *key);

/// Whether the word of a choice (or its default) is yes or true.
bool settings_yes(const setting_list *settings, const char *key);

/// Sets the members of a struct whose part this is to what was given, or their defaults. Only after settings_check.
void settings_take(valuation *v, const setting_list *settings, const whirl_member *table, void *object);

/// A text of at most `size` - 1 bytes without line breaks; a problem and "" otherwise.
void settings_text(case_reader *reader, const setting_list *settings, const char *key, char *text, size_t size);

/// The units in which numbers are shown, words of base/words/unit_words.c; a problem and "" otherwise.
void settings_units(case_reader *reader, const setting_list *settings, char *text, size_t size);

/// The key of files of one subject that settings_units reads.
#define UNITS_KEY                                                                                                      \
    CHOICE_KEY("units", OPTIONAL, "",                                                                                  \
               "units of what is printed, such as mil, psi, lbf, or all of a system (US, SI), as `units` of a study; " \
               "absent: um, rpm, N and the like")

/// "did you mean WORD?" with the nearest of the names, or "expected one of ..." with all of them.
void describe_names(const char *word, const char *const *names, size_t count, char text[WHY_SIZE]);

// ---------------------------------------------------------------- bearing_oil
// The oil of a bearing by itself: its viscosity, and what makes it warm.

/// Reads what a file says of it; problems where that is not complete, or said twice.
void bearing_oil_read(case_reader *reader, const setting_list *file, whirl_bearing *out);

// ---------------------------------------------------------------- balance_readings
// Readings of a file on balancing in a table of its own.

/// Reads comma-separated values (or values between semicolons or tabs) under headings that are keys of the group, with
/// units behind them ("amplitude [um]"): the list of mappings that would stand in their place. NULL after a problem;
/// problems, of which the reader has none before, are of the table.
const file_node *balance_readings(case_reader *reader, const char *path, const whirl_group *group);

/// Reports problems of a table where the file names it, each with its line and column in the table.
void balance_take_problems(case_reader *reader, const file_node *where, const whirl_problems *of);

// ---------------------------------------------------------------- file
// Files that are read by tables of keys: the steps that all of them go through.

/// What makes something of the root of a file.
typedef void file_read_fn(case_reader *reader, const file_node *root, void *into);

/// Reads a text with a reader whose arena and problems are set; problems come in the order of the file, with what
/// stands there. `name` stands for the file in messages.
whirl_status file_read(case_reader *reader, const char *text, size_t length, const char *name, file_read_fn *read,
                       void *into);

/// Files other than cases: they have no parameters.
typedef struct file_kind {
    const whirl_group *group; ///< of their keys, by the name of the first, which holds the version
    int version;              ///< that is read
    size_t size;              ///< of what is made of one
    /// Fills it, all zero before, from the settings of the file.
    void (*fill)(case_reader *reader, const setting_list *file, void *into);
    void (*release)(void *made);
} file_kind;

/// Makes what a file says, in memory or at a path: *made, NULL after a failure. problems: NULL, or takes what is wrong.
whirl_status file_parse(const file_kind *kind, const char *text, size_t length, const char *name,
                        whirl_problems *problems, void **made);
whirl_status file_load(const file_kind *kind, const char *path, whirl_problems *problems, void **made);

#endif
