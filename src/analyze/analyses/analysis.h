/// What an analysis is made of: the fields that it adds to the block of a point, and how it fills them.
#ifndef ANALYZE_ANALYSIS_H
#define ANALYZE_ANALYSIS_H

#include "whirl/engine/analyze.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum { MAX_ANALYSIS_FIELDS = 48 };

/// What the sizes of the fields depend on.
typedef struct block_shape {
    size_t dimension, station_count, contact_count, touch_count, range_count;
    size_t runout_count; ///< of all probes
    size_t samples_per_revolution;
    bool at_rest; ///< whether points are of machines at rest
    const whirl_record_options *options;
} block_shape;

/// A field before the sizes are known.
typedef struct field_plan {
    const char *name; ///< of whirl/engine/fields.h
    const char *unit; ///< as whirl_field.unit
    const char *meaning;
    whirl_extent extent;
    size_t columns;
    size_t (*rows)(const block_shape *shape); ///< NULL: one row; a field of no rows is left out
} field_plan;

/// Where an analysis writes: its fields in the order of its plan, NULL for those that were left out.
typedef struct block_view {
    const whirl_field *fields[MAX_ANALYSIS_FIELDS];
    double *block;
} block_view;

/// Rows of fields that have one for every coordinate of the state, or for every revolution of the longest orbit.
size_t rows_per_coordinate(const block_shape *shape);
size_t rows_of_longest_orbit(const block_shape *shape);

/// The numbers [rows][columns] of a field for a station or contact (0 for fields of the point);
/// NULL when the field was left out.
double *view_numbers(const block_view *view, size_t field, size_t which);

/// What the probes of a station see over the last samples of a record, x [count] and then y [count]: its waveform, and
/// runout where there is any.
void fill_seen(const whirl_record *record, size_t probe, size_t count, double *seen);

/// Writes row `row` of a field of shapes (x_cos, x_sin, y_cos, y_sin of every station) of a motion Re(v exp(i w t)), v
/// [dimension][2]: the largest displacement of any station is 1, at the instant of its peak.
void fill_shape(const whirl_system *system, const double *v, size_t row, size_t field, const block_view *view);

/// A station whose motion is smaller than this share of its distance from the centre rests: it whirls in no sense.
#define MIN_MOTION 1e-6

/// Fields of what is watched (whirl/engine/watched.h): their numbers, their plans, and how they are filled from a
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
    bool needs_waveform;       ///< options without it contradict the choice of this analysis
    whirl_growth needs_growth; ///< the least of it, likewise
    whirl_growth uses_growth;  ///< what is followed for it (whirl_analysis_needs) where it says less without
    bool uses_orbits;          ///< orbits are looked for, likewise
    whirl_status (*compute)(const whirl_record *record, const whirl_record_options *options, const block_view *view);
    /// In its place: of a machine at rest, without any motion.
    whirl_status (*compute_resting)(const whirl_resting *point, const whirl_record_options *options,
                                    const block_view *view);
    /// Likewise, of a point of a branch.
    whirl_status (*compute_trace)(const whirl_trace *trace, const whirl_record_options *options,
                                  const block_view *view);
    /// Likewise, of a torus.
    whirl_status (*compute_torus)(const whirl_torus_trace *trace, const whirl_record_options *options,
                                  const block_view *view);
    /// Optional: fills what a motion that left its bounds still has to say.
    void (*compute_diverged)(const whirl_record *record, const block_view *view);
} analysis_plan;

/// Where an analysis writes in a block of that layout.
block_view view_of(const analysis_plan *plan, const whirl_layout *layout, double *block);

extern const analysis_plan poincare_analysis, orbit_analysis, rub_analysis, waveform_analysis, spectrum_analysis,
    lyapunov_analysis, exponents_analysis, regime_analysis, winding_analysis, evidence_analysis, modes_analysis,
    unbalance_analysis, critical_speeds_analysis, stability_analysis, statics_analysis, floquet_analysis,
    trace_analysis, torus_analysis, ranges_analysis;

/// The plans, in the order of whirl_analyses().
extern const analysis_plan *const analysis_plans[];

// ---------------------------------------------------------------- lyapunov
// Means of correlated sequences with honest standard errors.

/// The mean of `values` [count] and its standard error: that of the means of 32 and of 16 blocks, the larger one, so
/// that correlation from one value to the next counts as long as it dies out within a block.
/// NaN for no values; the error is NaN for one.
whirl_estimate estimate_mean(const double *values, size_t count);

/// The mean of a sequence that is periodic or quasi-periodic, as the growth about a settled motion is, much sharper
/// than estimate_mean: a mean over whole periods or a smoothly weighted one, whichever agrees better between the two
/// halves of the sequence. The error is that disagreement: no standard error, and worth nothing for a chaotic motion.
whirl_estimate estimate_regular_mean(const double *values, size_t count, size_t period);

/// The growth of all perturbations beside what their sum must be.
typedef struct growth_balance {
    double sum, exact; ///< of all exponents, and by the divergence; NaN where it is not known
    double miss;       ///< their distance, which is an error of the integration: 0 where it is not known
    /// It is more than the standard errors and more than a thousandth of all exponents' sizes: the steps did not carry
    /// the perturbations, and no exponent means anything.
    bool failed;
} growth_balance;

/// Whether a bounded motion took all perturbations along.
bool follows_all(const whirl_record *record);

/// The means and standard errors of all growths of such a motion, exponents [dimension], and their balance; `values`
/// [growth_count] is workspace.
growth_balance gather_exponents(const whirl_record *record, whirl_estimate *exponents, double *values);

/// The sharp mean (estimate_regular_mean) of the growth of the second of all perturbations, after the first tenth of
/// the revolutions. NaN where not all were followed, or there is no memory.
whirl_estimate second_exponent(const whirl_record *record);

/// The balance alone. All zero where not all perturbations were followed, or there is no memory.
growth_balance balance_growth(const whirl_record *record);

// ---------------------------------------------------------------- spectrum
// Spectra of samples at equal angles, of computed motions and of measured ones.

/// Numbers of a row: order, x, y, forward, backward.
enum { SPECTRUM_COLUMNS = 5 };

/// Bins 0 ... of a record up to an order, below half the sampling frequency.
size_t spectrum_bins(size_t revolutions, size_t samples_per_revolution, double highest_order);

/// The spectrum of two coordinates [count] over whole revolutions; as whirl_spectrum_new. further: lines may lie above
/// the highest order.
whirl_status spectrum_of(const double *x, const double *y, size_t count, size_t samples_per_revolution,
                         double highest_order, bool further, whirl_spectrum **spectrum);

/// A row for every line [line_count][SPECTRUM_COLUMNS], and for every bin [count][SPECTRUM_COLUMNS] unless NULL.
void spectrum_rows(const whirl_spectrum *spectrum, double *lines, double *bins);

// ---------------------------------------------------------------- bearings
// Bearings alone on stations of 1 kg (WHIRL_BEARINGS_OF_IT).

/// Sets x to where the machine, whose bearings these are, is at rest: places of stations, states of the bearings.
void bearings_place(const whirl_system *alone, double *x, const whirl_system *machine, const double *rest);

#endif
