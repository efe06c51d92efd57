/// A custom system: its slopes are a function of the caller's, and it is studied as rotors are.
///
///     whirl_user_system_new("Duffing", 2, &system);
///     whirl_user_system_parameter(system, "gamma", 0.3, "1", "0.3");
///     whirl_user_system_rates(system, duffing, NULL);
///     whirl_user_system_speed(system, "omega");
///     whirl_user_system_vary(system, "gamma", values, 512);
///     whirl_job_of_user_system(system, &job);
///     whirl_job_run(job, &result);
///
/// The equations are dx/dt = f(t, x, p), where f comes back after a period of t, which is called a revolution: sections
/// are taken at its end. Functions of the caller must depend on their arguments alone, and are called from several
/// threads at once unless the job has one.
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

/// Equations with their parameters, and what is to be found out about them.
typedef struct whirl_user_system whirl_user_system;

/// Writes the slopes dxdt [dimension] at time t, from 0 to before the period, and x [dimension], with the parameters p
/// in the order in which they were given. Anything but 0 says that it failed: the run ends with a sentence.
typedef int (*whirl_user_rates_fn)(double t, const double *x, const double *p, double *dxdt, void *context);

/// The same of `count` machines side by side, in lanes: number k of machine i is at [k * row + i] of x, p and dxdt, and
/// its time at t[i].
typedef int (*whirl_user_lanes_fn)(size_t count, size_t row, const double *t, const double *x, const double *p,
                                   double *dxdt, void *context);

/// Writes the derivative of the slopes by x applied to a perturbation dx [dimension]: ddxdt = (df/dx) dx.
typedef int (*whirl_user_tangent_fn)(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                                     void *context);

/// A system of that many coordinates, all of which start from 0, with a period of 2 pi. WHIRL_BAD_INPUT for none or
/// more than 4096, WHIRL_NO_MEMORY. Freed by whirl_user_system_free.
whirl_status whirl_user_system_new(const char *title, size_t dimension, whirl_user_system **out);
void whirl_user_system_free(whirl_user_system *system); ///< Frees a system; NULL is none.

/// Adds a parameter with its value in SI, its SI unit ("1" for plain numbers) and how it was written. Names are those
/// of case files: letters, digits and _. WHIRL_BAD_INPUT for another name, one that is there, no finite value, a unit
/// that UDUNITS does not know and one that is not SI ("rpm").
whirl_status whirl_user_system_parameter(whirl_user_system *system, const char *name, double value, const char *unit,
                                         const char *text);

/// Starts coordinate `index` from a value.
whirl_status whirl_user_system_start(whirl_user_system *system, size_t index, double value);

/// Says that a coordinate is an angle, of a pendulum say, whose turn is `period`: the slopes have that period in it,
/// and it counts modulo a turn. It is brought to within half a turn of 0 at the end of every revolution, and a motion
/// that goes round and round and comes back in all else is periodic. An angle that turns at a constant rate is time.
/// WHIRL_BAD_INPUT for no such coordinate, and for a period that is not above 0.
whirl_status whirl_user_system_angle(whirl_user_system *system, size_t index, double period);

/// Says what size coordinate `index` has in motions, in its own unit: 3e5 of a pressure in Pa, 1e-6 of a displacement
/// of micrometres in m. Tolerances, perturbations, returns and the bound of divergence (the options `atol` and `limit`)
/// are counted in it. A displacement of a system that oscillates has one scale with its velocity. Coordinates without
/// one have 1 or, where motions at the first, the middle and the last point of the study are below 0.01 or above 100 in
/// some coordinate, the power of two that is nearest to their size. An angle has none. Numbers of results stay in the
/// coordinate's own unit. WHIRL_BAD_INPUT for no such coordinate, and for a scale that is not above 0; the run has it
/// where an angle, or a velocity whose displacement has another one, has a scale.
whirl_status whirl_user_system_scale(whirl_user_system *system, size_t index, double scale);

/// A pair of coordinates that is looked at together, by their indices: sections, orbits and spectra are of these. For a
/// single coordinate y = x; a phase plane has its velocity as y. `vx` and `vy` index their velocities, or themselves.
/// Without any station there is one of the first two coordinates.
whirl_status whirl_user_system_station(whirl_user_system *system, const char *name, size_t x, size_t y, size_t vx,
                                       size_t vy);

/// Says that the first `displacements` coordinates are displacements, whose slopes are the next so many, their
/// velocities; others follow. Machines then run side by side in lanes. Stations are of displacements. 0: it is not so.
whirl_status whirl_user_system_oscillates(whirl_user_system *system, size_t displacements);

/// The slopes by a function for one machine; the last call of this and the next counts. `context` is handed to it. A
/// run calls it once more, at the start, and ends with WHIRL_BAD_INPUT where it changes x or p or leaves a slope
/// unwritten, as a function of another form does.
whirl_status whirl_user_system_rates(whirl_user_system *system, whirl_user_rates_fn rates, void *context);

/// ... or by one for many machines. One machine is then many of one.
whirl_status whirl_user_system_lanes(whirl_user_system *system, whirl_user_lanes_fn rates, void *context);

/// The derivative of the slopes. Without it differences of the slopes are taken to both sides, each a
/// hundred-thousandth of the state's size away: exact to about 1e-9 where the slopes are smooth.
whirl_status whirl_user_system_tangent(whirl_user_system *system, whirl_user_tangent_fn tangent, void *context);

/// The period, in the unit of t: a number above 0 ...
whirl_status whirl_user_system_period(whirl_user_system *system, double period);

/// ... or 2 pi over a parameter, the angular frequency of what forces the system.
whirl_status whirl_user_system_speed(whirl_user_system *system, const char *parameter);

/// Says that slopes have kinks (contacts of springs, dry friction smoothed over a short way): the growth of
/// perturbations then follows the derivative, for two motions side by side would be told apart by the lengths of their
/// steps. Slopes that jump (contacts with dampers) have none: where differences meet a jump of such a system, or of one
/// whose exponents are asked for, the run ends with WHIRL_NUMERICAL_FAILURE, which says where.
whirl_status whirl_user_system_kinked(whirl_user_system *system);

/// Varies a parameter over values [count], which are copied: called once it makes a sweep, twice a map with the second
/// parameter from row to row, a third time one with planes. WHIRL_BAD_INPUT where they do not rise or fall throughout.
whirl_status whirl_user_system_vary(whirl_user_system *system, const char *parameter, const double *values,
                                    size_t count);

/// What is found out, by names as in case files ("poincare", "regime", "lyapunov", "orbit", "spectrum", "floquet",
/// ...); without any the first four.
whirl_status whirl_user_system_analyze(whirl_user_system *system, const char *analysis);

/// An option of how motions are computed and recorded, as case files have it: "method" "dop853", "rtol" "1e-8",
/// "transient" "500", "record" "100", "confirm" "yes", and "carry" "up", "down" or "both" of a sweep. Those of branches
/// have `trace_` before the key that case files have, as in results: "trace_step" "0.02", "trace_longest" "4",
/// "trace_tori" "yes". WHIRL_BAD_INPUT with the nearest name.
whirl_status whirl_user_system_set(whirl_user_system *system, const char *option, const char *value);

/// A job of the system, as whirl_job_new gives one of a case.
whirl_status whirl_job_of_user_system(const whirl_user_system *system, whirl_job **job);

/// Says what tells the functions of this system from others: a name and a version, or a checksum of their source. A
/// journal goes on with the functions that it was begun with and with no others. WHIRL_BAD_INPUT for "".
whirl_status whirl_user_system_identity(whirl_user_system *system, const char *identity);

/// The result before any point is computed, for a journal (whirl_case_outline). WHIRL_BAD_INPUT where the system has no
/// identity: a journal of other functions would pass for its own.
whirl_status whirl_user_system_outline(const whirl_user_system *system, whirl_result **outline);

/// Follows branches of periodic orbits, stable or not, over a parameter between two bounds, in the place of motions:
/// the table "branch", as a case's part `branch` has it. They begin where motions settle at the values at [count],
/// which are copied, or at `from` where count is 0; the last call counts. With the option "trace_rest" "yes" they are
/// branches of equilibria, and of the orbits that begin at their Hopf points, of a system that nothing drives in time:
/// the first is looked for from the start. WHIRL_BAD_INPUT for another name, bounds that are equal or not finite, and
/// values that lie beyond them; the run has it where parameters vary or analyses are chosen besides, and where no orbit
/// is found.
whirl_status whirl_user_system_branch(whirl_user_system *system, const char *parameter, double from, double to,
                                      const double *at, size_t count);

/// Follows besides, in the table "curves", the special points of the branches over a second parameter, from its value
/// to both bounds. WHIRL_BAD_INPUT as above, and where the value does not lie between them.
whirl_status whirl_user_system_curves(whirl_user_system *system, const char *parameter, double from, double to);

#ifdef __cplusplus
}
#endif
#endif
