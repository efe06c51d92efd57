/// Functions that build findings: they begin statements and sheets, and add to them piece by piece. A failed allocation
/// is noted (whirl_findings.failed), and later calls do nothing.
#ifndef REPORT_FINDINGS_BUILD_H
#define REPORT_FINDINGS_BUILD_H

#include "whirl/engine/case.h"
#include "whirl/internal/findings.h"

/// A table of a result for which findings are made.
typedef struct finder {
    whirl_findings *findings;
    const whirl_shown_units *units; ///< units of the result
    const whirl_result *result;     ///< the result with each attractor once (whirl_result_by_attractor)
    const whirl_table *table;
    const whirl_case *machine; ///< case of the result (machine_of), or NULL
} finder;

/// Makes empty findings, freed by whirl_findings_free; NULL without memory.
whirl_findings *find_begin(void);

/// Returns complete findings in *findings. If `made` is NULL or an allocation failed, frees `made`, sets *findings to
/// NULL and returns WHIRL_NO_MEMORY.
whirl_status find_made(whirl_findings *made, whirl_findings **findings);

/// Returns the word before the colon of a name such as "spread:FIELD at STATION", which requests a sheet about one
/// number of the points: "spread", "indices" or "probabilities" (static text). NULL for other names.
const char *findings_asked_spread(const char *name);

/// Makes the findings on the number that such a name contains. Errors of whirl_findings_new, and WHIRL_BAD_INPUT for an
/// unknown number.
whirl_status findings_of_spread(const whirl_result *result, const char *units, const char *name,
                                whirl_findings **findings);

/// Finds the first and the last computed point; returns 0 if there is none, 1 if they are one point, else 2.
size_t find_ends(const whirl_table *table, size_t ends[2]);

/// Returns a formatted text that lives as long as the findings; "" without memory.
const char *find_text(whirl_findings *findings, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Begins a statement; never NULL. Texts are static, or from find_text. The pointer is valid until the next statement
/// begins.
whirl_statement *find_statement(const finder *of, const char *what);

/// Begins a statement about a point, with the value of the parameter there; returns its phrase `found`.
whirl_phrase *find_at(const finder *of, size_t point, const char *what);

/// Begins a statement with a judgement, the first word of its phrase `judged`.
whirl_statement *find_judgement(const finder *of, const char *what, const char *clause, whirl_judgement judgement);

/// Append to a phrase: a text, a number with the unit of its quantity, a number with a given unit, a value of the
/// table's parameter.
void phrase_text(const finder *of, whirl_phrase *phrase, const char *format, ...) __attribute__((format(printf, 3, 4)));
void phrase_number(const finder *of, whirl_phrase *phrase, whirl_quantity quantity, int digits, double value);
void phrase_unit(const finder *of, whirl_phrase *phrase, const whirl_unit *unit, int digits, double value);
void phrase_value(const finder *of, whirl_phrase *phrase, int digits, double value);

/// Sets the value of the parameter for which a statement holds; does nothing in a table without a parameter.
void statement_value(const finder *of, whirl_statement *statement, size_t point);

/// Begins a sheet; never NULL. The pointer is valid until the next sheet begins.
whirl_sheet *find_sheet(const finder *of, const char *name, const char *title);

/// Removes the last sheet if it has no rows.
void find_sheet_end(const finder *of);

/// Add columns before the first row.
void sheet_column(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, whirl_quantity quantity,
                  int digits);
void sheet_units(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, const whirl_unit *unit,
                 int digits); ///< numbers with a given unit
void sheet_list(const finder *of, whirl_sheet *sheet, const char *key, const char *heading, whirl_quantity quantity,
                int digits, const char *between); ///< several numbers in each cell
void sheet_list_units(const finder *of, whirl_sheet *sheet, const char *key, const char *heading,
                      const whirl_unit *unit, int digits, const char *between); ///< several numbers with a given unit
void sheet_texts(const finder *of, whirl_sheet *sheet, const char *key, const char *heading); ///< texts
void sheet_values(const finder *of, whirl_sheet *sheet, const char *heading,
                  int digits); ///< values of the parameter, if any
/// Reduces a sheet with equal rows for two points to the rows of the first, without a value of the parameter, and adds
/// a sentence to its text. For quantities that usually do not depend on the parameter.
void sheet_once(const finder *of, whirl_sheet *sheet);

/// Adds columns kxx, kxy, kyx, kyy, cxx, ... for stiffness and damping of a bearing. headings [8]: static; NULL: the
/// keys themselves.
void sheet_coefficients(const finder *of, whirl_sheet *sheet, const char *const *headings);

/// Begin a row, then fill every column by one of these functions. Numbers that are not finite leave their cell empty;
/// texts are static, or from find_text.
void sheet_row(const finder *of, whirl_sheet *sheet);
void cell_number(const finder *of, whirl_sheet *sheet, double number);
void cell_numbers(const finder *of, whirl_sheet *sheet, size_t count, const double *numbers);
void cell_text(const finder *of, whirl_sheet *sheet, const char *text);
void cell_station(const finder *of, whirl_sheet *sheet, size_t station);
void cell_colour(const finder *of, whirl_sheet *sheet, const char *colour); ///< colours the last cell; static text
void cell_value(const finder *of, whirl_sheet *sheet,
                size_t point); ///< value of the parameter; empty in a table without a parameter

#endif
