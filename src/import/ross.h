/// A rotor from a ROSS file: the parts that are converted, in SI and checked.
///
/// Format of petrobras/ross, versions 0.x to 3.0: Rotor.save, Element.save. A section "Class_tag" is an element. Node n
/// of the shaft is between elements n - 1 and n. Elements on one node are layers. Where only couplings join two nodes,
/// one shaft ends and another begins. Nodes beyond the shafts are supports, which move along x and y. Rotation is from
/// x to y, as in whirl.
#ifndef IMPORT_ROSS_H
#define IMPORT_ROSS_H

#include <stdio.h>

#include "field.h"
#include "page.h"

typedef struct ross_material {
    const char *name; ///< as the file has it
    double density, modulus, shear;
} ross_material;

typedef struct ross_piece {
    const char *tag;
    long node;            ///< node of its left end
    size_t shaft;         ///< its shaft
    double length, start; ///< start: from the left end of its shaft
    double axial_force;
    double inner[2], outer[2]; ///< at its left and right end
    size_t material;
    bool shear, rotary_inertia, gyroscopic, hutchinson;
    double mass_damping, stiffness_damping;
    field_section section;
} ross_piece;

typedef struct ross_disc {
    const char *tag;
    long node;
    double mass, diametral, polar;
    field_section section;
} ross_disc;

typedef struct ross_point {
    const char *tag;
    long node;
    double mass[2]; ///< along x and y
    bool used;
    field_section section;
} ross_point;

/// Coefficients of bearings, in the order in which a case lists them.
typedef enum ross_coefficient {
    KXX,
    KXY,
    KYX,
    KYY,
    CXX,
    CXY,
    CYX,
    CYY,
    MXX,
    MXY,
    MYX,
    MYY,
    COEFFICIENTS
} ross_coefficient;
extern const char *const ross_coefficient_names[COEFFICIENTS];
extern const char *const ross_coefficient_units[COEFFICIENTS];

/// The magnets of both axes of a magnetic bearing, and their controller.
typedef struct ross_magnet {
    double gap, bias, area, turns, pole_angle, angle; ///< SI; angle: of the first axis, from x towards y
    double proportional, integral, derivative;        ///< A/m, A/(m s), A s/m; gains of sensor and amplifier included
    double filter;                                    ///< s, time constant of the derivative
} ross_magnet;

/// The film from which coefficients were computed (CylindricalBearing), and its load; SI.
typedef struct ross_film {
    double radius, length, clearance, viscosity, load;
} ross_film;

typedef struct ross_bearing {
    const char *tag;
    long node, link;           ///< link: node of its housing, -1: the ground
    const char *axis;          ///< key of the speeds: "frequency", from ROSS 3 on "speed"
    size_t speed_count;        ///< 0: nothing depends on the speed
    const double *speeds;      ///< rad/s, rising
    size_t frequency_count;    ///< 0: nothing depends on the frequency of whirl
    const double *frequencies; ///< rad/s, rising
    const double *values[COEFFICIENTS];
    bool varies[COEFFICIENTS]; ///< true: values are [1 or speed_count][1 or frequency_count]; false: one number
    bool seal;
    const ross_magnet *magnet; ///< in place of coefficients; NULL: none
    const ross_film *film;     ///< film of the coefficients; NULL: not in the file
    field_section section;
} ross_bearing;

/// Springs and dampers between a node and the next one, and the masses of both ends.
typedef struct ross_coupling {
    const char *tag, *end_tag[2]; ///< end_tag: left and right end
    long node;                    ///< node of the left end
    double mass[2], diametral[2], polar[2];
    double stiffness[2], damping[2]; ///< for displacements, along x and y
    double tilt, tilt_damping;       ///< for slopes, in both planes
    field_section section;
} ross_coupling;

/// A node of the shafts and couplings, which follow each other in one row.
typedef struct ross_node {
    size_t shaft;    ///< ROSS_NO_SHAFT: between couplings, or at the end of one
    double position; ///< m from the left end of its shaft
} ross_node;
#define ROSS_NO_SHAFT ((size_t)-1)

/// A node that carries something: a station of the case.
typedef struct ross_station {
    long node;
    const char *name;                 ///< valid and unique
    const char *first;                ///< tag that it is named after
    const ross_node *place;           ///< NULL: a support
    double mass[2], diametral, polar; ///< masses along x and y, and inertias, of all parts on the node
} ross_station;

typedef struct ross_rotor {
    const char *version;       ///< version of ROSS, "" if the file has none
    double least, most, rated; ///< rad/s; NAN if not in the file
    size_t material_count, piece_count, disc_count, point_count, bearing_count, coupling_count;
    ross_material *materials;
    ross_piece *pieces; ///< by their nodes, layers in the order of the file
    ross_disc *discs;
    ross_point *points;
    ross_bearing *bearings;
    ross_coupling *couplings; ///< by their nodes
    size_t shaft_count;
    long first_node, last_node; ///< range of shafts and couplings
    ross_node *nodes;           ///< [last_node - first_node + 1]
    size_t station_count;
    ross_station *stations; ///< by their nodes
} ross_rotor;

/// Reads all sections. Problems are in reader->status.
void ross_read(import_reader *reader, value *root, ross_rotor *out);

/// Reads a bearing, a seal, or any class that has coefficients. `version`: that of ROSS, which changed the keys of
/// speeds.
void ross_read_bearing(field_section *section, const char *tag, const char *version, ross_bearing *out);

/// Returns true if a section has magnets: from ROSS 2.1 on it is a BearingElement with keys of magnets, and
/// coefficients over the frequency.
bool ross_is_magnet(const field_section *section);

/// Reads a magnetic bearing. Returns false, having read nothing, for other sections and for controllers other than PID,
/// which ROSS does not save.
bool ross_read_magnetic(field_section *section, const char *tag, ross_bearing *out);

/// Reads a coupling.
void ross_read_coupling(field_section *section, const char *tag, ross_coupling *out);

/// Notes the keys of a section that were not read. computed: unread keys belong to the computation of coefficients and
/// are noted as such, not as unknown.
void ross_note_rest(field_section *section, const char *tag, bool computed);

/// Joins pieces and couplings to one row of nodes, and checks that the nodes of all other elements exist.
void ross_join(import_reader *reader, ross_rotor *rotor);

/// Makes stations of the nodes that carry something.
void ross_find_stations(import_reader *reader, ross_rotor *rotor);

/// Returns the station of a node, which must have one.
const ross_station *ross_station_at(const ross_rotor *rotor, long node);

/// Makes a word of small letters, digits, '_' and '-' from a tag, or uses `fallback` if nothing remains.
void ross_name(const char *tag, const char *fallback, char name[WHIRL_NAME_SIZE]);

/// Returns true if a coefficient of the bearing differs from 0 at any speed or frequency.
bool ross_acts(const ross_bearing *bearing, ross_coefficient which);

/// Writes the stations of a bearing: "at: ...", and "from: ..." if it has a housing.
void ross_put_place(page_line *line, const ross_rotor *rotor, const ross_bearing *bearing);

/// Writes the element of a magnetic bearing.
void ross_put_magnetic(FILE *out, const ross_rotor *rotor, const ross_bearing *bearing);

/// Writes the elements of a coupling; nothing if it resists no lateral motion.
void ross_put_coupling(FILE *out, const ross_rotor *rotor, const ross_coupling *coupling);

/// Writes the case as a new text.
whirl_status ross_write(import_reader *reader, ross_rotor *rotor, char **text, size_t *length);

#endif
