/// Findings on tables of motions, part by part (find_motions).
#ifndef REPORT_FOUND_MOTIONS_H
#define REPORT_FOUND_MOTIONS_H

#include <stdbool.h>

#include "findings_build.h"
#include "regimes.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"

/// Returns true for a table with a single motion.
bool find_alone(const finder *of);

/// Returns true for tables whose motions are described together, as each by itself says little: those that accompany
/// studies at rest, and those without verdicts.
bool find_described_together(const whirl_table *table);

/// Adds the findings on each motion: verdicts, reasons, sizes, lines, 1X, watched numbers.
void find_points(const finder *of);

/// Adds the findings on regimes along a parameter, or of a map: ranges, numbers of points, jumps within a regime.
void find_regimes(const finder *of);

/// Adds the findings on attractors: of a basin, or of several starts for each point.
void find_attractors(const finder *of);

/// Adds the statements on motions that are described together: their number, unbalances, clearances and contacts.
void find_together(const finder *of);

/// Add columns, and fill the cells, that identify a motion: the value of the parameter, and the attractor if points
/// have several.
void sheet_points(const finder *of, whirl_sheet *sheet);
void cells_point(const finder *of, whirl_sheet *sheet, size_t point);

/// Fills a cell with the name of a regime, in its colour.
void cell_regime(const finder *of, whirl_sheet *sheet, const char *name, regime_class kind);

/// Add a column of largest exponents with their errors, and fill the cell of a motion; both are rounded to digits that
/// the error leaves.
void sheet_exponent(const finder *of, whirl_sheet *sheet);
void cell_exponent(const finder *of, whirl_sheet *sheet, size_t point);

/// The machine of a point, if it can be made.
typedef struct point_machine {
    whirl_machine machine;
    bool made;
} point_machine;

/// Returns the stations with their clearances and gaps at a point, or those of the result if the point's machine is
/// unknown. They live until point_release.
const whirl_probe *point_probes(const finder *of, size_t point, point_machine *own);
void point_release(point_machine *own);

/// Counts the starts of a table that are done, and those of them without a verdict.
void starts_count(const whirl_table *source, size_t *done, size_t *undetermined);

/// Finds the number of points of the grid that each point of a refined map stands for [count]; NULL for other tables.
/// To be freed. Returns false without memory.
bool motions_weights(const finder *of, size_t **weights);

#endif
