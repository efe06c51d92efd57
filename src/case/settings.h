/// A mapping of the file, read by the table of its group.
#ifndef CASE_SETTINGS_H
#define CASE_SETTINGS_H

#include "keys.h"
#include "parameters.h"
#include "quantity.h"

enum { SETTINGS_MAX = 64 };

/// A key and its value in the file.
typedef struct setting {
    const whirl_key *key;
    const file_node *place;
    bool good;            ///< no problem was found; the following members are valid only then
    number_formula value; ///< value of numbers
    bool scaled;      ///< the value has the unit that schema_scaled_unit names, and is still to be divided by its scale
    const char *word; ///< value of choices, texts, stations, lists ("a, b"); else NULL
    struct setting *entries;        ///< [entry_count] entries of a list with expressions, instead of `word`; or NULL
    size_t entry_count, row_length; ///< number of entries, row by row
} setting;

typedef struct setting_list {
    const char *name; ///< name of a station, or kind of an element
    const whirl_group *group;
    const file_node *place;
    bool sound; ///< for an element: no problem was found
    size_t count;
    setting *items;
} setting_list;

/// Reads a mapping (or, for groups with a shorthand, a scalar; an empty value is an empty mapping) and reports unknown,
/// missing and wrong keys. Numbers with unit "" and parts of the file are left to the caller: only `place` is set.
void settings_read(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *result);

/// Reads a mapping in which every value is a list of two numbers, into lists of lower ends and upper ends with the same
/// keys.
void settings_read_ranges(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *low,
                          setting_list *high);

/// Returns true if an absent key was misspelt, which has been reported.
bool settings_misspelt(const setting_list *settings, const char *key);

/// Returns the setting of a key if it is given, else NULL.
const setting *settings_find(const setting_list *settings, const char *key);

/// Returns the numbers of a setting as settings: the entries of a list with expressions, else the setting itself; and
/// their number.
size_t setting_numbers(const setting *item, const setting **first);

/// Returns the size of the text of a list with expressions; 1 for other lists.
size_t setting_list_size(const setting *item);

/// Writes the numbers of a list with expressions as rotors read them: "1, 2; 3, 4". Errors as valuation_number.
whirl_status setting_list_text(valuation *v, const setting *item, char *text);

/// Evaluates expressions and reports values that are missing or out of range. Returns false if there are any.
bool settings_check(case_reader *reader, valuation *v, const setting_list *settings);

/// Returns the value of a number, not yet divided by its scale, or the key's default. Only after settings_check.
double settings_number(valuation *v, const setting_list *settings, const char *key);

/// Returns the value of a number in a file without parameters, where expressions are problems. An absent key has its
/// default, or NaN.
double settings_plain(case_reader *reader, const setting_list *settings, const char *key);

/// Reads the numbers of a list, or a single number, or the default, in a file without parameters. Returns their number,
/// at most `most`; more are a problem. 0 if there is none, or one is wrong.
size_t settings_list_plain(case_reader *reader, const setting_list *settings, const char *key, double *out,
                           size_t most);

/// Returns the word of a choice, or the key's default.
const char *settings_word(const setting_list *settings, const char *key);

/// Returns true if the word of a choice (or its default) is yes or true.
bool settings_yes(const setting_list *settings, const char *key);

/// Sets the members of `object` that `table` describes to the values of their keys, or their defaults. Only after
/// settings_check.
void settings_take(valuation *v, const setting_list *settings, const whirl_member *table, void *object);

/// Reads a text of at most `size` - 1 bytes, with blanks in place of tabs and line breaks. Anything else is a problem
/// and gives "".
void settings_text(case_reader *reader, const setting_list *settings, const char *key, char *text, size_t size);

/// Reads the units in which numbers are shown, words of base/words/unit_words.c; other words are a problem and give "".
void settings_units(case_reader *reader, const setting_list *settings, char *text, size_t size);

/// The key of files of one subject that settings_units reads.
#define UNITS_KEY                                                                                                      \
    CHOICE_KEY("units", OPTIONAL, "",                                                                                  \
               "units of the output, such as mil, psi, lbf, or all of a system (US, SI), as `units` of a study; "      \
               "absent: um, rpm, N and the like")

/// Writes "did you mean WORD?" with the nearest of the names, or "expected one of ..." with all of them.
void describe_names(const char *word, const char *const *names, size_t count, char text[WHY_SIZE]);

#endif
