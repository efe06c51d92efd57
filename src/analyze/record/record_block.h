/// The memory of a record.
#ifndef ANALYZE_RECORD_BLOCK_H
#define ANALYZE_RECORD_BLOCK_H

#include <stddef.h>

#include "archive.h"
#include "section.h"

/// Returns the revolution at which a motion continues that has settled on P-`period` after `revolution` revolutions. It
/// skips the rest of the transient except for the last 64 revolutions. For a period above 64 it keeps three periods
/// less the record, if that is more. Revolutions that are not watched are skipped in any case.
int record_skip(const whirl_record_options *options, int revolution, size_t period);

/// Makes an empty record for a motion of the system, all zero. NULL without memory. Freed by whirl_record_free.
whirl_record *record_new(const whirl_system *system, const whirl_integrate_options *integrate,
                         const whirl_record_options *options);

/// Prepares the record of a motion on an orbit of k <= options->record revolutions, which are recorded at the end of
/// sections and waveforms.
void record_begin_orbit(whirl_record *record, const whirl_record_options *options, size_t k);

/// Fills the rest of the record from these k revolutions: repeats them in sections and waveforms, multiplies sums to
/// match, and sets all growths by the largest multiplier of record->orbit. Must be called before sums become means.
void record_repeat_orbit(whirl_record *record, const whirl_record_options *options);

/// Returns the section so far. An angle is replaced by a point on a circle whose arcs are as long as the angles'
/// differences, so that states that differ by whole turns agree. Valid until the next call.
section record_points(const whirl_record *record);

/// Clears coordinates that turn from a complete record: they have no size and no place in the section.
void record_close_turns(whirl_record *record);

/// Archives (saves or restores) the options and sizes that a record's meaning depends on, and its content so far.
void record_archive(whirl_record *record, const whirl_integrate_options *integrate, const whirl_record_options *options,
                    archive *a);

/// Sets the initial perturbations [count][dimension]. A single perturbation has a part along every axis. If all are
/// carried, the k-th one is sin(k theta_i) along the i-th of n axes, with theta_i = pi i/(n + 1). These are
/// orthonormal. Since sin(k theta)/sin(theta) are polynomials of rising degree in cos(theta), the first k perturbations
/// are independent along any k axes. So the fastest growth comes first, even if the motion decouples planes or other
/// groups of coordinates. Coordinates that turn have axes of their own, which come last, so that orthogonalization in
/// this order never mixes the other perturbations with them.
void record_place_perturbations(const whirl_record *record, size_t count, double *perturbations);

#endif
