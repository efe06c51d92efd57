/// A journal bearing by itself over load and speed, as `whirl bearing` computes it: from a file (YAML,
/// docs/guide/15-bearings.md) to a table of where the journal rests, stiffness, damping, film, flow and power. All in
/// SI; what it is computed with, and its frame, stand in whirl/engine/bearing.h.
#ifndef WHIRL_BEARING_TABLE_H
#define WHIRL_BEARING_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/bearing.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/stop.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// As in whirl/engine/case.h, whirl/engine/study.h and whirl/engine/figure.h.
struct whirl_problems;
struct whirl_progress;
struct whirl_figure;
struct whirl_findings;

/// Sizes of such files.
enum {
    WHIRL_MAX_WHIRL_RATIOS = 8,       ///< whirl ratios that coefficients of tilting pads are reduced at
    WHIRL_MAX_BEARING_POINTS = 10000, ///< speeds by loads
    WHIRL_MAX_REMARKS = 8             ///< warnings of a point
};

/// The Reynolds number up to which the factors of turbulence were fitted to 5 %.
#define WHIRL_MAX_REYNOLDS 30000.0

/// A warning of a point, or of the bearing as a whole; findings word it.
typedef enum whirl_bearing_remark {
    WHIRL_FILM_THIN,        ///< thinner than least_film
    WHIRL_FILM_NOT_LAMINAR, ///< and taken as laminar
    WHIRL_FILM_LAMINAR,     ///< and taken as turbulent
    WHIRL_FILM_BETWEEN,     ///< laminar and turbulent
    WHIRL_FILM_BEYOND,      ///< the range of the factors of turbulence
    WHIRL_OIL_WARMS,        ///< by much, of a viscosity that is given
    WHIRL_OIL_UNKNOWN,      ///< at such a temperature
    WHIRL_MESH_COARSE,      ///< coefficients differ on a mesh half as fine
    WHIRL_PADS_IDLE,        ///< pads carry nothing
    WHIRL_LENGTH_UNUSUAL,   ///< of the bearing, over its diameter
    WHIRL_CLEARANCE_UNUSUAL ///< of the bearing, over its radius
} whirl_bearing_remark;

/// What a file says.
typedef struct whirl_bearing {
    char title[256];            ///< in one line
    char units[64];             ///< in which numbers are shown (whirl/engine/shown.h), or ""
    char kind[WHIRL_NAME_SIZE]; ///< "two-groove", ...; "pads" of pads of its own
    whirl_pads pads;            ///< turned as they stand
    double radius, length;      ///< m, of the journal
    double pad_clearance;       ///< m, radial, of every pad: c
    double clearance;           ///< m, radial, of the bearing: (1 - preload) c of the pad with the most preload
    double viscosity, density;  ///< Pa s, at the temperature that the oil has or comes in with; kg/m3
    double temperature;   ///< K, of the film or, where that follows from the heat, of the oil that comes in; or NaN
    bool heated;          ///< the film's temperature follows from the heat
    double heat_share;    ///< of the power, that the leaving oil carries
    double specific_heat; ///< J/(kg K), of the oil
    size_t oil_count;     ///< of rows that tell its viscosity over the temperature; 0: it is constant
    double oil_temperatures[WHIRL_MAX_LIST]; ///< [oil_count] K, rising
    double oil_viscosities[WHIRL_MAX_LIST];  ///< [oil_count] m2/s, falling
    double supply_pressure;                  ///< Pa above that of the surroundings, in the grooves
    double inertia;                          ///< kg m2, of a pad about its pivot
    double pivot_stiffness, pivot_damping;   ///< N/m and N s/m along the radius; stiffness 0: rigid
    double pad_mass;                         ///< kg, of a pad on such a pivot
    double load_angle;                       ///< rad from x towards y, of the load on the journal
    double least_film;                       ///< m, below which a warning stands
    size_t ratio_count;                      ///< of whirl ratios
    double ratios[WHIRL_MAX_WHIRL_RATIOS];   ///< [ratio_count] frequency of whirl over speed
    bool pairs;                              ///< speeds and loads belong to each other; else all of both
    size_t load_count;                       ///< of different loads that the file has
    size_t count;                            ///< of points: speeds of the first load, then of the next
    double *speeds, *loads;                  ///< [count] rad/s and N; its own
} whirl_bearing;

/// A point of the table. What does not hold or is not known is NaN.
typedef struct whirl_bearing_point {
    double speed, load;                 ///< rad/s, N
    bool found;                         ///< else all that follows is NaN
    char failure[200];                  ///< why it was not found, or ""
    whirl_pads_state state;             ///< without dimensions
    double sommerfeld;                  ///< mu N D L (R/c)^2/W, N in revolutions a second, c of a pad
    double eccentricity, attitude;      ///< m; rad from the load to the journal, with the rotation
    double film, pressure, flow, power; ///< m, Pa, m3/s that leave at both ends, W
    double heating;                     ///< K by which that flow would warm, if it took all of the power
    double viscosity, temperature;      ///< Pa s, K: of the film; the temperature NaN where it is not known
    double outlet;                      ///< K at which oil leaves, where that follows from the heat; else NaN
    double reynolds;                    ///< number, of the clearance: density speed R c/mu
    double stiffness[2][2];             ///< N/m, pads held
    double damping[2][2];               ///< N s/m, pads held
    /// [whirl ratio][0: stiffness, 1: damping] reduced ones; of fixed pads the same at all.
    double reduced[WHIRL_MAX_WHIRL_RATIOS][2][2][2];
    double
        critical_mass; ///< kg, of a rigid rotor a bearing, above which it whirls by itself; inf: never; of fixed pads
    double whirl;      ///< whirl ratio there
    double tilt[WHIRL_MAX_PADS];                     ///< rad
    double yield[WHIRL_MAX_PADS];                    ///< m, outwards, of pads on pivots that yield
    double error_place;                              ///< m, by which the journal's place differs on a mesh half as fine
    double error_stiffness, error_damping;           ///< the same of coefficients, over the largest of them
    size_t remark_count;                             ///< of warnings
    whirl_bearing_remark remarks[WHIRL_MAX_REMARKS]; ///< [remark_count]
} whirl_bearing_point;

/// A table.
typedef struct whirl_bearing_table {
    const whirl_bearing *bearing;                    ///< borrowed
    size_t count;                                    ///< of points
    whirl_bearing_point *points;                     ///< [count]
    size_t remark_count;                             ///< of warnings of the bearing as a whole
    whirl_bearing_remark remarks[WHIRL_MAX_REMARKS]; ///< [remark_count]
} whirl_bearing_table;

/// How a table is computed.
typedef struct whirl_bearing_options {
    int threads; ///< 0: one for every core; they change no bit
    /// Called now and then, from one thread at a time; points count as those at rest do. NULL: none.
    void (*progress)(void *context, const struct whirl_progress *progress);
    void *context;          ///< handed to progress; borrowed
    const whirl_stop *stop; ///< true: points that have not begun are left out; NULL: never
} whirl_bearing_options;

/// Reads a file. Problems as for cases. Freed by whirl_bearing_free.
whirl_status whirl_bearing_load(const char *path, struct whirl_problems *problems, whirl_bearing **bearing);

/// The same from memory; `name` stands for the file in messages.
whirl_status whirl_bearing_parse(const char *text, size_t length, const char *name, struct whirl_problems *problems,
                                 whirl_bearing **bearing);

/// Frees it; NULL is none.
void whirl_bearing_free(whirl_bearing *bearing);

/// The groups of keys of such a file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_bearing_groups(void);

/// Computes all points; one that has no solution says so and is no failure. The bearing stays as long as the table.
/// options: NULL, or how. WHIRL_NO_MEMORY; WHIRL_STOPPED. Freed by whirl_bearing_table_free.
whirl_status whirl_bearing_solve(const whirl_bearing *bearing, const whirl_bearing_options *options,
                                 whirl_bearing_table **table);

/// Frees it; NULL is none.
void whirl_bearing_table_free(whirl_bearing_table *table);

/// What was found, in the units that `units` or else the file says (whirl_shown_units_alone). Borrows the table. Freed
/// by whirl_findings_free. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT for words that are no units.
whirl_status whirl_bearing_findings(const whirl_bearing_table *table, const char *units,
                                    struct whirl_findings **findings);

/// Taylor's number of a point: its Reynolds number by the root of clearance over radius.
double whirl_bearing_taylor(const whirl_bearing *bearing, const whirl_bearing_point *point);

/// Whether a pad carries nothing at a point.
bool whirl_bearing_pad_idle(const whirl_bearing_point *point, size_t pad);

/// Writes all of it as one JSON object, in SI and radians, and its findings. WHIRL_NO_MEMORY.
whirl_status whirl_bearing_write_json(const whirl_bearing_table *table, const char *units, FILE *stream);

/// Writes it as CSV: a heading, a row a point, in SI and radians; coefficients at the first whirl ratio.
whirl_status whirl_bearing_write_csv(const whirl_bearing_table *table, FILE *stream);

/// Writes the coefficients at the first whirl ratio over the speed as an element `bearing` at a station, to be put into
/// the list of elements of a case; with `over_frequency` those of pads that tilt over the speed and the frequency of
/// whirl, from 0 to the highest speed. WHIRL_BAD_INPUT with a sentence where points are not of one load a speed, speeds
/// do not rise or are more than a list may have, or a point has no solution.
whirl_status whirl_bearing_write_element(const whirl_bearing_table *table, const char *station, bool over_frequency,
                                         FILE *stream);

/// Reduced coefficients of a point at any whirl ratio, [0: stiffness, 1: damping], N/m and N s/m; of fixed pads those
/// of the point.
void whirl_bearing_reduced(const whirl_bearing *bearing, const whirl_bearing_point *point, double ratio,
                           double out[2][2][2]);

/// Makes a figure: "curves" over the speed or, where there is one, over the load (NULL stands for it, too),
/// "sommerfeld", the same without dimensions over the Sommerfeld number, or "locus", the places of the journal in the
/// clearance; in the units that `units` or else the file says. WHIRL_BAD_INPUT for another name, and words that are no
/// units. Freed by whirl_figure_free.
whirl_status whirl_bearing_figure(const whirl_bearing_table *table, const char *name, const char *units,
                                  struct whirl_figure **figure);

#ifdef __cplusplus
}
#endif
#endif
