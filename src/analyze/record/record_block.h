/// The memory of a record.
#ifndef ANALYZE_RECORD_BLOCK_H
#define ANALYZE_RECORD_BLOCK_H

#include "archive.h"
#include "section.h"
#include "whirl/engine/analyze.h"

/// Where a motion that has settled on P-`period` after `revolution` revolutions goes on: it leaves out what is left of
/// the transient but for the last 64 revolutions, or as many as three of a period beyond 64 need.
int record_skip(const whirl_record_options *options, int revolution, size_t period);

/// An empty record for a motion of the system, all zero; NULL without memory. Freed by whirl_record_free.
whirl_record *record_new(const whirl_system *system, const whirl_integrate_options *integrate,
                         const whirl_record_options *options);

/// A motion was set upon an orbit of k <= options->record revolutions: what is recorded of these stands at the end of
/// sections and waveforms.
void record_begin_orbit(whirl_record *record, const whirl_record_options *options, size_t k);

/// Fills the rest of them, before means are scaled, with these revolutions again and again, and growths by the
/// largest multiplier of record->orbit.
void record_repeat_orbit(whirl_record *record, const whirl_record_options *options);

/// What the section holds so far: where coordinates are angles, with the points of circles in their places, whose arcs
/// are as long as the angles' differences. States that differ by whole turns are the same there. Valid until the next
/// call.
section record_points(const whirl_record *record);

/// Coordinates that turn on and on have no size and no place in the section, once the record is complete.
void record_close_turns(whirl_record *record);

/// Goes over the options and sizes that a record's meaning depends on, and over what it has gathered so far.
void record_archive(whirl_record *record, const whirl_integrate_options *integrate, const whirl_record_options *options,
                    archive *a);

/// Perturbations [count][dimension] as they are at first: a single one across all axes; of all of them the k-th is
/// sin(k theta_i), theta_i = pi i/(n + 1) for the i-th axis of n. They are orthonormal, and since sin(k
/// theta)/sin(theta) are polynomials of rising degree in cos(theta), any k axes see the first k of them as independent
/// ones: also where the motion leaves planes, or other groups of coordinates, to themselves, the fastest growth comes
/// first (along the axes, the first ones would stay in the first group). What turns on and on has axes of its own, the
/// last: made orthogonal in turn, the others never know of it, and their growth is that of the rest alone.
void record_place_perturbations(const whirl_record *record, size_t count, double *perturbations);

#endif
