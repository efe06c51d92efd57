/// The rotor of a case: stations and elements with their settings, from which rotors are built.
#ifndef CASE_MACHINE_H
#define CASE_MACHINE_H

#include "settings.h"
#include "whirl/engine/rotor.h"
#include "whirl/internal/line.h"
#include "whirl/internal/model.h"

/// Parts that have names.
typedef struct named_list {
    size_t count;
    setting_list *items;
    const char **names; ///< [count]
} named_list;

typedef struct machine_parts {
    setting_list rotor; ///< speed and length scale
    named_list stations, shafts, materials;
    size_t element_count;
    setting_list *elements;
    const file_node *elements_place;
} machine_parts;

/// Reads `rotor:`.
void machine_read(case_reader *reader, const file_node *where, bool may_stand_still, machine_parts *result);

/// Reports everything that prevents building a machine from the case's values. Call it only without problems so far.
void machine_check(case_reader *reader, valuation *v, const machine_parts *machine);

/// Applies formula_settle to all settings of the machine.
void machine_settle(valuation *v, machine_parts *machine);

/// Builds a rotor with the values of `valuation` at the speed of the case; in_time: as whirl_design_in_time does. The
/// rotor is an outline (whirl_rotor_outline), here and in the functions below.
whirl_status machine_build(const machine_parts *machine, valuation *v, bool in_time, whirl_rotor **rotor);

/// Changes to a machine for a variant.
typedef struct machine_choice {
    size_t placed_count;
    const whirl_placed *placed; ///< [placed_count] unbalances that replace those of the machine; none: they stay
    whirl_drag drag;            ///< seals and impellers to include
    size_t drag_at;             ///< station of the seals and impellers, if only one station's are included
    double stages;              ///< factor of stages
    bool in_time;               ///< the machine is to move: coefficients over the frequency of whirl get states
    size_t spool_count;         ///< speeds of the shafts that have their own; 0: those of their keys
    const double *spool_speeds; ///< [spool_count] as in whirl_design_spools
    bool spools_vary;           ///< likewise
    bool asynchronous;          ///< true: coefficients that depend on the frequency of whirl are those at `frequency`
    double frequency;           ///< frequency of whirl, rad/s
} machine_choice;

/// Builds the machine like machine_build, at a speed and with the changes of a variant.
whirl_status machine_build_with(const machine_parts *machine, valuation *v, double speed, const machine_choice *choice,
                                whirl_rotor **rotor);

/// Builds the machine like machine_build, with springs of a stiffness (N/m) in place of the bearings, or with the
/// bearings alone on stations of 1 kg.
whirl_status machine_build_on_springs(const machine_parts *machine, valuation *v, double speed, whirl_bearings what,
                                      double stiffness, whirl_rotor **rotor);
whirl_status machine_build_bearings(const machine_parts *machine, valuation *v, double speed, whirl_rotor **rotor);

/// Runs the static analysis, as whirl_design_statics does; out and influence are for all stations.
whirl_status machine_statics(const machine_parts *machine, valuation *v, const char *couplings,
                             whirl_station_statics *out, double *influence);

/// Finds the line of the shafts, as whirl_design_line does; `choice` as in machine_build_with.
whirl_status machine_line(const machine_parts *machine, valuation *v, double speed, const machine_choice *choice,
                          const char *couplings, whirl_shaft_line *out);

/// Finds how weight acts, as whirl_design_weight does.
whirl_status machine_weight(const machine_parts *machine, valuation *v, whirl_weight *out);

/// Reports doubts, as whirl_design_doubts does.
whirl_status machine_doubts(const machine_parts *machine, valuation *v, whirl_design_tell *tell, void *context);

/// Builds the machine of whirl_case_element.
whirl_status machine_build_element(const machine_parts *machine, valuation *v, const char *element,
                                   whirl_rotor **rotor);

/// Finds the model, as whirl_design_model does.
whirl_status machine_model(const machine_parts *machine, valuation *v, whirl_model *out);

/// Summarizes shafts, as whirl_design_shafts does.
whirl_status machine_shafts(const machine_parts *machine, valuation *v, whirl_shaft_summary *out, size_t *count);

/// Reports settings of single elements that contradict each other, independently of other problems.
void machine_check_alone(case_reader *reader, const machine_parts *machine);

/// Writes advice for a word that is no station: the nearest station or all of them, and ground if that is allowed.
void machine_advise(const machine_parts *machine, const char *word, bool ground, char advice[WHY_SIZE]);

/// Returns the index of the part of a name; the number of parts if there is none.
size_t named_find(const named_list *in, const char *name);

#endif
