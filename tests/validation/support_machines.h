/// One small machine for every element of the registry, as a case that can be written in several ways of which physics
/// knows nothing: in the mirror, in another order, by another length scale, in other units.
#ifndef SUPPORT_MACHINES_H
#define SUPPORT_MACHINES_H

#include <stdbool.h>
#include <stddef.h>

/// Properties of machines, for the tests that do not apply to them.
enum {
    MACHINE_TURNS = 1,   ///< coefficients that turn with the shaft: no limit of speed 0, no response about rest
    MACHINE_NO_REST = 2, ///< nothing at rest or at speed 0
    MACHINE_SHARP = 4,   ///< forces that jump, or contacts that are not located: methods agree to the step alone
    MACHINE_SLOW = 8,    ///< two slow rates near each other: growth of a copy is a mean of both by its direction
    MACHINE_TWISTS = 16, ///< both stations twist, too
    MACHINE_AXIAL = 32   ///< both stations twist and move along the shaft, too
};

/// A machine of one element, between a rotor and a stator on springs. In its text `@40` is an angle of 40 degrees and
/// `~3` a number, both as they are in the machine or in its mirror image by x -> -x.
typedef struct element_machine {
    const char *name, *element;
    unsigned flags;
} element_machine;

/// All of them; the list ends with one without a name.
extern const element_machine element_machines[];

/// A unit, and what it is in another one: 1 unit = factor other.
typedef struct unit_pair {
    const char *unit, *other;
    double factor;
} unit_pair;

/// Systems of units; each ends with a pair without a unit.
extern const unit_pair units_inch[], units_feet[], units_millimetre[], units_si[];

/// Form in which the case of a machine is written.
typedef struct machine_view {
    bool mirrored;          ///< as seen in a mirror, by x -> -x; it turns clockwise
    bool reversed;          ///< stations and elements in the other order
    const char *length;     ///< length scale; NULL: 0.1 mm
    const unit_pair *units; ///< NULL: as it stands in the list
} machine_view;

enum { MACHINE_TEXT = 8192 };

/// Writes the case of a machine with a study, whose parameter n is the speed.
void machine_text(const element_machine *of, machine_view as, const char *study, char text[MACHINE_TEXT]);

#endif
