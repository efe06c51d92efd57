/// An analysis: the fields that it adds to the block of a point, and how it fills them.
#ifndef ANALYZE_ANALYSIS_H
#define ANALYZE_ANALYSIS_H

#include "whirl/engine/analyze.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum { MAX_ANALYSIS_FIELDS = 96 };

/// Quantities that determine the sizes of the fields.
typedef struct block_shape {
    size_t dimension, station_count, contact_count, touch_count, range_count;
    size_t runout_count; ///< harmonics of the runout of all probes
    size_t samples_per_revolution;
    bool at_rest;                        ///< points are of machines at rest
    bool twists, axial;                  ///< true if stations twist; true if stations move along their shafts
    bool also_twists;                    ///< true if stations twist that also move otherwise
    size_t torque_count;                 ///< as whirl_system.torque_count
    size_t run_shaft_count;              ///< as whirl_system.shaft_count
    size_t excitation_count, path_count; ///< as in whirl_system.torsion
    const whirl_record_options *options;
} block_shape;

/// Description of a field, made before the numbers of its rows are known.
typedef struct field_plan {
    const char *name; ///< a name of whirl/engine/fields.h
    const char *unit; ///< as whirl_field.unit
    const char *meaning;
    whirl_extent extent;
    size_t columns;
    size_t (*rows)(const block_shape *shape); ///< NULL: one row; a field of no rows is left out
} field_plan;

/// The fields of an analysis in a block, in the order of its plan; NULL for those that were left out.
typedef struct block_view {
    const whirl_field *fields[MAX_ANALYSIS_FIELDS];
    double *block;
} block_view;

/// Returns the rows of a field which has one row for every coordinate of the state, or for every revolution of the
/// longest orbit.
size_t rows_per_coordinate(const block_shape *shape);
size_t rows_of_longest_orbit(const block_shape *shape);

/// Returns the rows of a field of axial displacements: 1, or 0 if no station moves along its shaft. Such a field has no
/// dimension of rows (whirl_analysis_has_rows).
size_t rows_of_axial(const block_shape *shape);

/// Returns likewise the rows of a field of the twists of stations that also move otherwise.
size_t rows_of_twist(const block_shape *shape);

/// Writes the least and largest x or y (axis: 0 or 1) that a probe reports over bounds of the state [dimension].
void probe_bounds(const whirl_probe *probe, const double *low, const double *high, size_t axis, double out[2]);

/// Returns the numbers [rows][columns] of a field for a station or contact (0 for fields of the point), or NULL if the
/// field was left out.
double *view_numbers(const block_view *view, size_t field, size_t which);

/// Fills in a station's waveform over the last samples of a record, x [count] and then y [count], with the runout of
/// its probes, if any.
void fill_seen(const whirl_record *record, size_t probe, size_t count, double *seen);

/// Largest amplitude so far of a motion Re(x exp(i w t)), with the cosine and sine of its phase; starts as 0, 1, 0.
typedef struct shape_peak {
    double size, cos, sin;
} shape_peak;

/// Makes the amplitude x [2] (real, imaginary part) the peak if it is larger; of equal amplitudes the first is kept.
void shape_peak_note(shape_peak *peak, const double *x);

/// Writes an amplitude relative to the peak, out [2]: its values at the instant of the peak and a quarter of a period
/// later.
void shape_peak_write(const shape_peak *peak, const double *x, double *out);

/// Writes row `row` of a field of shapes (x_cos, x_sin, y_cos, y_sin of every station) of a motion Re(v exp(i w t)), v
/// [dimension][2]: the largest displacement of any station is 1, at the instant of its peak.
void fill_shape(const whirl_system *system, const double *v, size_t row, size_t field, const block_view *view);

/// A station whose motion is smaller than this share of its distance from the centre rests and has no sense of whirl.
#define MIN_MOTION 1e-6

/// Fields of what is watched (whirl/engine/watched.h): their indices, their plans, and how they are filled from a
/// record.
#define WATCHED_INDEX(array, ...) WATCHED_##array,
#define WATCHED_PLAN(array, extent, columns, fold, square, name, unit, meaning)                                        \
    [WATCHED_##array] = {name, unit, meaning, extent, columns, NULL},
#define WATCHED_FILL(array, extent, columns, ...)                                                                      \
    memcpy(view_numbers(view, WATCHED_##array, which), record->array + (columns)*which, (columns) * sizeof(double));

/// An analysis. `compute` is called for bounded motions only, on fields full of NaN.
typedef struct analysis_plan {
    const field_plan *fields;
    size_t field_count;
    bool needs_waveform;       ///< the analysis rejects options without it
    whirl_growth needs_growth; ///< the analysis rejects options with less growth
    whirl_growth uses_growth;  ///< growth to be followed for it; with less, some of its fields are missing
    bool uses_orbits;          ///< orbits are searched for it; without them, some of its fields are missing
    whirl_status (*compute)(const whirl_record *record, const whirl_record_options *options, const block_view *view);
    /// For machines at rest, called instead of `compute`. WHIRL_NUMERICAL_FAILURE: the point has no equilibrium, and
    /// its numbers are missing; WHIRL_BAD_INPUT ends the run, and `whirl check` reports it beforehand.
    whirl_status (*compute_resting)(const whirl_resting *point, const whirl_record_options *options,
                                    const block_view *view);
    /// Optional: does the same for several points, where computing them together is faster. Skips points with an error
    /// in statuses [count], and writes the statuses of the others.
    void (*compute_resting_together)(size_t count, const whirl_resting *points, const whirl_record_options *options,
                                     const block_view *views, whirl_status *statuses);
    /// For a point of a branch, called instead of `compute`.
    whirl_status (*compute_trace)(const whirl_trace *trace, const whirl_record_options *options,
                                  const block_view *view);
    /// For a point of a branch of tori, called instead of `compute`.
    whirl_status (*compute_torus)(const whirl_torus_trace *trace, const whirl_record_options *options,
                                  const block_view *view);
    /// Optional: refuses systems that it cannot analyse. WHIRL_BAD_INPUT.
    whirl_status (*check_system)(const whirl_system *system);
    /// Optional: fills the fields that a diverged motion still has.
    void (*compute_diverged)(const whirl_record *record, const block_view *view);
} analysis_plan;

/// Locates the fields of an analysis in a block of a layout.
block_view view_of(const analysis_plan *plan, const whirl_layout *layout, double *block);

extern const analysis_plan poincare_analysis, orbit_analysis, rub_analysis, waveform_analysis, spectrum_analysis,
    lyapunov_analysis, exponents_analysis, regime_analysis, winding_analysis, evidence_analysis, floquet_analysis,
    trace_analysis, torus_analysis, ranges_analysis;
#define PLAN_AT_REST(name, ...) extern const analysis_plan name##_analysis;
WHIRL_STUDIES_AT_REST(PLAN_AT_REST)

/// The plans, in the order of whirl_analyses().
extern const analysis_plan *const analysis_plans[];

#endif
