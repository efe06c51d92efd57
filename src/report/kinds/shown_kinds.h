/// Findings on tables. Each kind of table has a file in this folder, and a word in SHOWN_KINDS below.
#ifndef REPORT_SHOWN_KINDS_H
#define REPORT_SHOWN_KINDS_H

#include "findings_build.h"
#include "mode_lines.h"
#include "whirl/engine/result.h"
#include "whirl/engine/spread.h"
#include "whirl/internal/model.h"

typedef struct shown_kind {
    const char *field;         ///< field that only its tables have; NULL: any table
    const char *anchor, *name; ///< anchor and name of its section
    const char *about;         ///< introduction to all sections of the kind, written once; NULL: none
    const char *held; ///< clause after "which" on a contact that is closed at rest; NULL: "small motions do not open"
    void (*find)(const finder *of); ///< adds the findings on a table
} shown_kind;

/// Returns the kind of a table; never NULL.
const shown_kind *shown_kind_of(const whirl_table *table);

/// Returns true if a table has motions next to studies at rest (study: motions).
bool accompanying_motions(const whirl_table *table);

/// Adds the findings on the machine: weight, shafts, stations, bearings and other parts.
void find_machine(const finder *of);

/// Adds the findings on bearings, seals, dampers, magnets and supports.
void find_bearings(const finder *of, const whirl_model *model);

/// Adds the findings on the spread of a number over the samples of a table, and on its causes: the sheets "spread" and
/// "indices".
void find_spread_of(const finder *of, const whirl_spread_of *number);

/// Adds the findings on derivatives of a table's numbers with respect to parameters, if it has some.
void find_derivatives(const finder *of);

/// Adds the findings on inertias and joints of stations that twist.
void find_train(const finder *of, const whirl_model *model);

/// Adds a statement on motions without any number, for tables without verdicts.
void find_lost(const finder *of);

/// Adds statements on points beyond the range of a law, on equilibria that were not found or are not the only ones, and
/// on contacts that are closed at rest.
void find_ranges(const finder *of);

/// Adds the findings on spectral lines of motions along a parameter, below and above the synchronous one.
void find_lines(const finder *of);

/// Returns the stability of the modes at a point: 1 if one grows, -1 if all decay, 0 if the largest growth is rounding.
int shown_modes_growing(const whirl_table *table, size_t point);

// clang-format off
/// The kinds. The kind of a table is the first one whose field it has.
#define SHOWN_KINDS(kind)                                                                                              \
    kind(tolerances) kind(branches) kind(tori) kind(modes) kind(unbalance) kind(critical_speeds) kind(stability)       \
    kind(statics) kind(records) kind(runup) kind(twists) kind(fit) kind(motions)
// clang-format on
#define SHOWN_KIND(name) extern const shown_kind shown_##name;
SHOWN_KINDS(SHOWN_KIND)

/// Splits a fact of a data set, such as "label" 2: writes its name, and returns the text behind the colon ("" for
/// none).
const char *records_fact(const whirl_result *result, const char *what, size_t number, char name[WHIRL_NAME_SIZE]);

/// Returns true if the records of a data set are of runs, whose speed changes.
bool records_are_runs(const whirl_table *table);

/// Returns the largest share of the time that a contact is closed in a record; NaN for a machine without contacts.
double records_contact(const whirl_result *result, const whirl_table *table, size_t point);

/// Returns the point of a table of fits with the least sum of squares; the number of points if there is none.
size_t fit_best(const whirl_table *table);

/// Returns how far the measured numbers determine a parameter, by its row of the field fit/unknown: "yes", "hardly".
const char *fit_determined(const double *row);

/// Writes the name of a measured quantity by its row of the field fit/number: "disc x", "disc 45 deg 2X".
void fit_name_probe(const whirl_result *result, const double *row, char *name, size_t size);

/// Adds the findings on torsional modes in a table of modes: their excitations and separations.
void find_torsion(const finder *of, const mode_lines *lines);

/// An excitation of torsion: `order` times the speed of the shaft or, with `line`, times the frequency of the electric
/// line.
typedef struct torsion_excitation {
    int order;
    bool line;
} torsion_excitation;

/// Returns the number of excitations of a table: its orders, then the frequency of the line and twice that, if any.
int torsion_excitation_count(const whirl_table *table);
torsion_excitation torsion_excitation_at(const whirl_table *table, int index);

/// Returns the frequency of an excitation at a speed, both in rad/s.
double torsion_excitation_frequency(const whirl_table *table, torsion_excitation by, double speed);

/// Writes the name of a torque by its row of the fields runup/torque_of and torsion/torque_of: "motor to load",
/// "induction motor at motor", "mesh of wheel and pinion".
void torque_name(const whirl_result *result, const double *of, char *name, size_t size);

/// Writes the name of an excitation of a response to torques: "2X", "100 Hz".
void twists_name_excitation(const whirl_table *table, size_t index, char *name, size_t size);

/// Chooses the torques of a response with the largest sums, at most `most`, the largest first; returns their number.
size_t twists_choose(const whirl_table *table, size_t most, size_t *chosen);

/// Returns true for a mode with a damping ratio above WHIRL_OVERDAMPED_RATIO.
bool mode_is_overdamped(const whirl_table *table, size_t point, size_t mode);

#endif
