/// Tables of a journal bearing over load and speed, as `whirl bearing` computes them from a file (YAML,
/// docs/guide/15-bearings.md): equilibrium of the journal, stiffness, damping, film, flow and power. All in SI; method
/// and frame of reference are those of whirl/internal/bearing.h.
#ifndef WHIRL_BEARING_TABLE_H
#define WHIRL_BEARING_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/stop.h"
#include "whirl/internal/bearing.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Declared in whirl/engine/case.h, study.h, figure.h and findings.h.
struct whirl_problems;
struct whirl_progress;
struct whirl_figure;
struct whirl_findings;

/// Limits of bearing files.
enum {
    WHIRL_MAX_WHIRL_RATIOS = 8,       ///< whirl ratios at which coefficients of tilting pads are reduced
    WHIRL_MAX_BEARING_POINTS = 10000, ///< speeds times loads
    WHIRL_MAX_REMARKS = 8             ///< warnings of a point
};

/// Reynolds number up to which the factors of turbulence fit to 5 %.
#define WHIRL_MAX_REYNOLDS 30000.0

/// Warnings of a point, or of the bearing as a whole; findings give the sentences.
typedef enum whirl_bearing_remark {
    WHIRL_FILM_THIN,        ///< film thinner than least_film
    WHIRL_FILM_NOT_LAMINAR, ///< film is not laminar, but computed as laminar
    WHIRL_FILM_LAMINAR,     ///< film is laminar, but computed as turbulent
    WHIRL_FILM_BETWEEN,     ///< film is between laminar and turbulent
    WHIRL_FILM_BEYOND,      ///< film is beyond the range of the factors of turbulence
    WHIRL_OIL_WARMS,        ///< oil warms much, at a given viscosity
    WHIRL_OIL_UNKNOWN,      ///< viscosity is unknown at such a temperature
    WHIRL_MESH_COARSE,      ///< coefficients differ on a mesh half as fine
    WHIRL_PADS_IDLE,        ///< pads without a load
    WHIRL_LENGTH_UNUSUAL,   ///< unusual length of the bearing over its diameter
    WHIRL_CLEARANCE_UNUSUAL ///< unusual clearance of the bearing over its radius
} whirl_bearing_remark;

/// A bearing file.
typedef struct whirl_bearing {
    char title[256];            ///< in one line
    char units[64];             ///< units in which numbers are shown (whirl/internal/shown.h), or ""
    char kind[WHIRL_NAME_SIZE]; ///< "two-groove", ...; "pads" for pads given one by one
    whirl_pads pads;            ///< rotated to their angles in the machine
    double radius, length;      ///< m, of the journal
    double pad_clearance;       ///< m, radial, of every pad: c
    double clearance;           ///< m, radial, of the bearing: (1 - preload) c of the pad with the most preload
    double viscosity, density;  ///< Pa s, at the given or the supply temperature; kg/m3
    double temperature;         ///< K, of the film or, if that follows from the heat, of the supplied oil; or NaN
    bool heated;                ///< the film's temperature follows from the heat
    double heat_share;          ///< share of the power that the leaving oil carries
    double specific_heat;       ///< J/(kg K), of the oil
    size_t oil_count;           ///< rows of viscosity over temperature; 0: it is constant
    double oil_temperatures[WHIRL_MAX_LIST]; ///< [oil_count] K, rising
    double oil_viscosities[WHIRL_MAX_LIST];  ///< [oil_count] m2/s, falling
    double supply_pressure;                  ///< Pa above ambient, in the grooves
    double inertia;                          ///< kg m2, of a pad about its pivot
    double pivot_stiffness, pivot_damping;   ///< N/m and N s/m along the radius; stiffness 0: rigid
    double pad_mass;                         ///< kg, of a pad on such a pivot
    double load_angle;                       ///< rad from x towards y, of the load on the journal
    double least_film;                       ///< m, threshold of a warning
    size_t ratio_count;                      ///< number of whirl ratios
    double ratios[WHIRL_MAX_WHIRL_RATIOS];   ///< [ratio_count] frequency of whirl over speed
    bool pairs;                              ///< speeds and loads are pairs; else all combinations
    size_t load_count;                       ///< number of different loads in the file
    size_t count;                            ///< number of points: all speeds of the first load, then of the next
    double *speeds, *loads;                  ///< [count] rad/s and N; owned
} whirl_bearing;

/// A point of a table. NaN: not valid or not known.
typedef struct whirl_bearing_point {
    double speed, load;                 ///< rad/s, N
    bool found;                         ///< false: the members below are NaN
    char failure[200];                  ///< reason why no equilibrium was found, or ""
    whirl_pads_state state;             ///< dimensionless
    double sommerfeld;                  ///< mu N D L (R/c)^2/W, N in revolutions per second, c of a pad
    double eccentricity, attitude;      ///< m; rad from the load to the journal, with the rotation
    double film, pressure, flow, power; ///< m, Pa, m3/s that leave at both ends, W
    double heating;                     ///< K, temperature rise of that flow if it carried all of the power
    double viscosity, temperature;      ///< Pa s, K: of the film; the temperature NaN if not known
    double outlet;                      ///< K, of the leaving oil if that follows from the heat; else NaN
    double reynolds;                    ///< number, of the clearance: density speed R c/mu
    double stiffness[2][2];             ///< N/m, with fixed tilts
    double damping[2][2];               ///< N s/m, with fixed tilts
    /// [whirl ratio][0: stiffness, 1: damping] reduced coefficients; for fixed pads equal at all ratios.
    double reduced[WHIRL_MAX_WHIRL_RATIOS][2][2][2];
    /// kg, of a rigid rotor per bearing, above which it is unstable; inf: never; fixed pads only.
    double critical_mass;
    double whirl;                          ///< whirl ratio at that mass
    double tilt[WHIRL_MAX_PADS];           ///< rad
    double yield[WHIRL_MAX_PADS];          ///< m, outwards, of pads on flexible pivots
    double error_place;                    ///< m, difference of the journal's position on a mesh half as fine
    double error_stiffness, error_damping; ///< difference of coefficients on that mesh, over the largest of them
    size_t remark_count;                   ///< number of warnings
    whirl_bearing_remark remarks[WHIRL_MAX_REMARKS]; ///< [remark_count]
} whirl_bearing_point;

/// A table of points.
typedef struct whirl_bearing_table {
    const whirl_bearing *bearing;                    ///< borrowed
    size_t count;                                    ///< number of points
    whirl_bearing_point *points;                     ///< [count]
    size_t remark_count;                             ///< number of warnings of the bearing as a whole
    whirl_bearing_remark remarks[WHIRL_MAX_REMARKS]; ///< [remark_count]
} whirl_bearing_table;

/// Options of computing a table.
typedef struct whirl_bearing_options {
    int threads; ///< 0: one per core; their number changes no bit
    /// Receives progress now and then, from one thread at a time; points count as those of studies at rest do. NULL:
    /// none.
    void (*progress)(void *context, const struct whirl_progress *progress);
    void *context;          ///< passed to progress; borrowed
    const whirl_stop *stop; ///< true: points that have not begun are skipped; NULL: never
} whirl_bearing_options;

/// Reads a bearing file. Problems as for cases. Freed by whirl_bearing_free.
whirl_status whirl_bearing_load(const char *path, struct whirl_problems *problems, whirl_bearing **bearing);

/// Does the same from memory; `name` is the file's name in messages.
whirl_status whirl_bearing_parse(const char *text, size_t length, const char *name, struct whirl_problems *problems,
                                 whirl_bearing **bearing);

/// Frees a bearing file; accepts NULL.
void whirl_bearing_free(whirl_bearing *bearing);

/// Returns the groups of keys of such a file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_bearing_groups(void);

/// Computes all points. A point without a solution has `found` false and is not an error. The bearing must outlive the
/// table. options: NULL for the defaults. WHIRL_NO_MEMORY; WHIRL_STOPPED. Freed by whirl_bearing_table_free.
whirl_status whirl_bearing_solve(const whirl_bearing *bearing, const whirl_bearing_options *options,
                                 whirl_bearing_table **table);

/// Frees a table; accepts NULL.
void whirl_bearing_table_free(whirl_bearing_table *table);

/// Builds findings, in the units of `units`, or else of the file (whirl_shown_units_alone). Borrows the table. Freed by
/// whirl_findings_free. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_bearing_findings(const whirl_bearing_table *table, const char *units,
                                    struct whirl_findings **findings);

/// Returns Taylor's number of a point: its Reynolds number times the root of clearance over radius.
double whirl_bearing_taylor(const whirl_bearing *bearing, const whirl_bearing_point *point);

/// Returns true if a pad carries no load at a point.
bool whirl_bearing_pad_idle(const whirl_bearing_point *point, size_t pad);

/// Writes the table as one JSON object, in SI and radians, with its findings. WHIRL_NO_MEMORY.
whirl_status whirl_bearing_write_json(const whirl_bearing_table *table, const char *units, FILE *stream);

/// Writes the table as CSV: a heading, a row a point, in SI and radians; coefficients at the first whirl ratio.
/// Warnings are in the units of `units`, or else of the file. WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_bearing_write_csv(const whirl_bearing_table *table, const char *units, FILE *stream);

/// Writes the coefficients at the first whirl ratio over speed as an element `bearing` at a station, for the list of
/// elements of a case; with `over_frequency` those of tilting pads over speed and frequency of whirl, from 0 to the
/// highest speed. WHIRL_BAD_INPUT with a sentence if a speed has several loads, speeds do not rise or are more than a
/// list may have, or a point has no solution.
whirl_status whirl_bearing_write_element(const whirl_bearing_table *table, const char *station, bool over_frequency,
                                         FILE *stream);

/// Computes the reduced coefficients of a point at any whirl ratio, [0: stiffness, 1: damping], N/m and N s/m; for
/// fixed pads those of the point.
void whirl_bearing_reduced(const whirl_bearing *bearing, const whirl_bearing_point *point, double ratio,
                           double out[2][2][2]);

/// Builds a figure: "curves" over speed, or over load if the speed is constant (also for NULL); "sommerfeld",
/// dimensionless over the Sommerfeld number; or "locus", the positions of the journal in the clearance. Units are those
/// of `units`, or else of the file. WHIRL_BAD_INPUT for another name, and words that are not units. Freed by
/// whirl_figure_free.
whirl_status whirl_bearing_figure(const whirl_bearing_table *table, const char *name, const char *units,
                                  struct whirl_figure **figure);

#ifdef __cplusplus
}
#endif
#endif
