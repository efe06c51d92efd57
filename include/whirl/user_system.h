/// Custom systems: the caller's functions give the slopes, and studies treat the system like a rotor.
///
///     whirl_user_system_new("Duffing", 2, &system);
///     whirl_user_system_parameter(system, "gamma", 0.3, "1", "0.3");
///     whirl_user_system_rates(system, duffing, NULL);
///     whirl_user_system_speed(system, "omega");
///     whirl_user_system_vary(system, "gamma", values, 512);
///     whirl_job_of_user_system(system, &job);
///     whirl_job_run(job, &result);
///
/// The equations are dx/dt = f(t, x, p), where f has a period in t, which is called a revolution; sections are taken at
/// its end. The caller's functions must depend on their arguments alone, and are called from several threads at once
/// unless the job has one thread.
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_USER_SYSTEM_H
#define WHIRL_USER_SYSTEM_H

#include <stddef.h>

#include "whirl/handles.h"
#include "whirl/job.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Equations with their parameters, and the study of them.
typedef struct whirl_user_system whirl_user_system;

/// Writes the slopes dxdt [dimension] at time t, 0 <= t < period, and state x [dimension]; p holds the parameters in
/// the order in which they were added. A result other than 0 reports a failure: the run ends with a sentence.
typedef int (*whirl_user_rates_fn)(double t, const double *x, const double *p, double *dxdt, void *context);

/// Does the same for `count` machines in lanes: number k of machine i is at [k * row + i] of x, p and dxdt, and its
/// time is t[i].
typedef int (*whirl_user_lanes_fn)(size_t count, size_t row, const double *t, const double *x, const double *p,
                                   double *dxdt, void *context);

/// Applies the derivative of the slopes to a perturbation dx [dimension]: ddxdt = (df/dx) dx.
typedef int (*whirl_user_tangent_fn)(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                                     void *context);

/// Creates a system of `dimension` coordinates, which all start from 0, with a period of 2 pi. WHIRL_BAD_INPUT for a
/// dimension of 0 or above 4096, WHIRL_NO_MEMORY. Freed by whirl_user_system_free.
whirl_status whirl_user_system_new(const char *title, size_t dimension, whirl_user_system **out);
void whirl_user_system_free(whirl_user_system *system); ///< Frees a system; accepts NULL.

/// Adds a parameter: its value in SI, its SI unit ("1" for plain numbers), and the text from which it was read. Names
/// follow the rules of case files: letters, digits and _. WHIRL_BAD_INPUT for any other name, a name in use, a value
/// that is not finite, a unit that UDUNITS does not know, and a unit that is not SI ("rpm").
whirl_status whirl_user_system_parameter(whirl_user_system *system, const char *name, double value, const char *unit,
                                         const char *text);

/// Starts coordinate `index` from a value.
whirl_status whirl_user_system_start(whirl_user_system *system, size_t index, double value);

/// Declares a coordinate to be an angle, for example of a pendulum, with a turn of `period`: the slopes have that
/// period in it. It is brought to within half a turn of 0 at the end of every revolution. A motion that returns but for
/// whole turns is periodic. Do not declare an angle that turns at a constant rate: it is time. WHIRL_BAD_INPUT for a
/// coordinate out of range, and for a period that is not above 0.
whirl_status whirl_user_system_angle(whirl_user_system *system, size_t index, double period);

/// Sets the scale of coordinate `index`, the size of it in typical motions, in its own unit: 3e5 for a pressure in Pa,
/// 1e-6 for a displacement of micrometres in m. Tolerances, perturbations, returns and the bound of divergence (the
/// options `atol` and `limit`) are multiples of it. In an oscillating system a displacement and its velocity share one
/// scale. Default: 1; or, if motions at the first, the middle and the last point of the study are below 0.01 or above
/// 100 in some coordinate, the power of two nearest to the coordinate's size. Angles have no scale. Results stay in the
/// coordinate's own unit. WHIRL_BAD_INPUT for a coordinate out of range, and for a scale that is not above 0; the run
/// returns it for the scale of an angle, and for a velocity whose displacement has another scale.
whirl_status whirl_user_system_scale(whirl_user_system *system, size_t index, double scale);

/// Adds a station: a pair of coordinates, by index, whose sections, orbits and spectra are analysed. For a single
/// coordinate y = x; a phase plane has the velocity as y. `vx` and `vy` index the derivatives of x and y, or x and y
/// themselves. The default is one station of the first two coordinates.
whirl_status whirl_user_system_station(whirl_user_system *system, const char *name, size_t x, size_t y, size_t vx,
                                       size_t vy);

/// Declares the first `displacements` coordinates to be displacements, and the same number of next ones their
/// velocities; other coordinates follow. Machines then run in lanes. Stations are of displacements. 0 takes the
/// declaration back.
whirl_status whirl_user_system_oscillates(whirl_user_system *system, size_t displacements);

/// Sets a function of the slopes of one machine. It replaces an earlier function of whirl_user_system_rates or
/// whirl_user_system_lanes. `context` is passed to it. A run first calls it once as a test, and ends with
/// WHIRL_BAD_INPUT if it changes x or p or leaves a slope unwritten, as a function with another signature does.
whirl_status whirl_user_system_rates(whirl_user_system *system, whirl_user_rates_fn rates, void *context);

/// Sets a function of the slopes of many machines; it also serves single machines, with a count of 1.
whirl_status whirl_user_system_lanes(whirl_user_system *system, whirl_user_lanes_fn rates, void *context);

/// Sets the derivative of the slopes. The default is central differences of the slopes with a step of a
/// hundred-thousandth of the state's size: exact to about 1e-9 if the slopes are smooth.
whirl_status whirl_user_system_tangent(whirl_user_system *system, whirl_user_tangent_fn tangent, void *context);

/// Sets the period, in the unit of t, above 0.
whirl_status whirl_user_system_period(whirl_user_system *system, double period);

/// Sets the period to 2 pi over a parameter, the angular frequency of the forcing.
whirl_status whirl_user_system_speed(whirl_user_system *system, const char *parameter);

/// Declares that the slopes have kinks (contact with springs, dry friction smoothed over a short way). The growth of
/// perturbations is then computed from the derivative, because two neighbouring motions would diverge by the different
/// errors of their steps. Slopes that jump (contact with dampers) have no derivative: if differences meet a jump in
/// such a system, or in one whose exponents are computed, the run ends with WHIRL_NUMERICAL_FAILURE and reports the
/// place.
whirl_status whirl_user_system_kinked(whirl_user_system *system);

/// Varies a parameter over values [count], which are copied. The first call makes a sweep; the second makes it a map,
/// with the second parameter from row to row; the third makes it a map with planes. WHIRL_BAD_INPUT for values that do
/// not rise or fall throughout.
whirl_status whirl_user_system_vary(whirl_user_system *system, const char *parameter, const double *values,
                                    size_t count);

/// Adds an analysis, by its name in case files ("poincare", "regime", "lyapunov", "orbit", "spectrum", "floquet", ...).
/// The default is the first four.
whirl_status whirl_user_system_analyze(whirl_user_system *system, const char *analysis);

/// Sets an option of computing and recording motions, as in case files: "method" "dop853", "rtol" "1e-8", "transient"
/// "500", "record" "100", "confirm" "yes"; for a sweep "carry" "up", "down" or "both". Options of branches have
/// `trace_` before the key of case files, as in results: "trace_step" "0.02", "trace_longest" "4", "trace_tori" "yes".
/// WHIRL_BAD_INPUT with the nearest name.
whirl_status whirl_user_system_set(whirl_user_system *system, const char *option, const char *value);

/// Creates a job of the system, as whirl_job_new does for a case.
whirl_status whirl_job_of_user_system(const whirl_user_system *system, whirl_job **job);

/// Sets the identity of the system's functions: a name and a version, or a checksum of their source. A journal
/// continues only with the identity with which it was begun. WHIRL_BAD_INPUT for "".
whirl_status whirl_user_system_identity(whirl_user_system *system, const char *identity);

/// Builds the result before any point is computed, for a journal (whirl_case_outline). WHIRL_BAD_INPUT for a system
/// without an identity, since a journal of other functions could not be recognized.
whirl_status whirl_user_system_outline(const whirl_user_system *system, whirl_result **outline);

/// Follows branches of periodic orbits, stable or not, over a parameter between two bounds, instead of computing
/// motions: the table "branch", as the part `branch` of a case. Branches begin at the orbits on which motions settle at
/// the values `at` [count], which are copied, or at `from` if count is 0; the last call counts. With the option
/// "trace_rest" "yes", for a system without forcing in time, they are branches of equilibria, and of the orbits that
/// begin at their Hopf points; the search for the first equilibrium begins at the start. WHIRL_BAD_INPUT for an unknown
/// name, bounds that are equal or not finite, and values beyond them; the run returns it if parameters are also varied
/// or analyses chosen, and if no orbit is found.
whirl_status whirl_user_system_branch(whirl_user_system *system, const char *parameter, double from, double to,
                                      const double *at, size_t count);

/// Also follows the special points of the branches over a second parameter, from its value to both bounds, in the table
/// "curves". WHIRL_BAD_INPUT as above, and if the value is not between the bounds.
whirl_status whirl_user_system_curves(whirl_user_system *system, const char *parameter, double from, double to);

// ---------------------------------------------------------------- motions over time

/// Returns a number that passes 0 where an event happens, in a state x [dimension] at time t.
typedef double (*whirl_user_event_fn)(double t, const double *x, const double *p, void *context);

/// Writes the state after an event to `after`, which begins as a copy of x, the state before it. A result other than 0
/// reports a failure.
typedef int (*whirl_user_reset_fn)(double t, const double *x, const double *p, double *after, void *context);

/// Adds an event of motions over time: when `value` passes 0, rising (passing 1), falling (-1) or both ways (0).
/// Motions are followed up to that instant, found to the last digits, and continue in the state that `reset` writes
/// (NULL: the same); or end there (ends 1). Studies accept no events. WHIRL_BAD_INPUT for a NULL value, another
/// passing, an end with a reset, and more than 64 events; WHIRL_NO_MEMORY.
whirl_status whirl_user_system_event(whirl_user_system *system, const char *name, whirl_user_event_fn value,
                                     int passing, whirl_user_reset_fn reset, int ends, void *context);

/// A motion over time.
typedef struct whirl_user_motion whirl_user_motion;

/// End of a motion over time.
typedef enum whirl_user_end {
    WHIRL_USER_DONE,        ///< at its last instant
    WHIRL_USER_EVENT,       ///< at an event that ends it
    WHIRL_USER_ACCUMULATED, ///< events of one kind came faster and faster, until no time was left between them, or a
                            ///< reset holds the motion where its event happens
    WHIRL_USER_DIVERGED,    ///< it left the bound (option `limit`, in scales)
    WHIRL_USER_STUCK        ///< the solver could not go on
} whirl_user_end;

/// Follows one motion from its start at times[0], at instants [count] that rise. The system needs no period; its slopes
/// may depend on time in any way. Options: `method` (an adaptive one; dop853 in place of others), `rtol`, `atol`,
/// `limit`. Angles are not brought back. Events are searched for at least twice in each step of the method: two that
/// cancel between two searches are missed. WHIRL_BAD_INPUT for instants that do not rise; WHIRL_NUMERICAL_FAILURE with
/// a sentence if a function fails; WHIRL_NO_MEMORY. Freed by whirl_user_motion_free.
whirl_status whirl_user_system_follow(const whirl_user_system *system, const double *times, size_t count,
                                      whirl_user_motion **out);
void whirl_user_motion_free(whirl_user_motion *motion); ///< Frees a motion; accepts NULL.

/// Returns the states [*count][dimension] at the instants that were reached; at the instant of an event, the state
/// before it. They last as long as the motion.
const double *whirl_user_motion_states(const whirl_user_motion *motion, size_t *count);

/// Returns the number of events that happened.
size_t whirl_user_motion_events(const whirl_user_motion *motion);

/// Writes event `index` of the motion: its number among the events of the system, from 0, its time, and the states
/// [dimension] before and after it, which last as long as the motion. Returns 0 past the last event, else 1.
int whirl_user_motion_event(const whirl_user_motion *motion, size_t index, size_t *which, double *time,
                            const double **before, const double **after);

/// Returns the end of the motion (whirl_user_end), and writes its time and a sentence ("" at the last instant), which
/// lasts as long as the motion.
int whirl_user_motion_end(const whirl_user_motion *motion, double *time, const char **words);

#ifdef __cplusplus
}
#endif
#endif
