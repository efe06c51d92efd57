// Checks of machines whose speed changes, and machines made at several speeds.
#include <string.h>

#include "running_rotor.h"

/// Checks the torques of a machine, and what they turn.
static whirl_status running_check_torques(const whirl_rotor *rotor) {
    size_t stations[MAX_TORQUES + 2], count = 0;
    const bool twists = rotor->twist_count > 0;
    if (twists && rotor->aside != NO_STATION)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "nothing joins the twist of station '%s' to the shaft that is driven, expected a coupling, "
                          "a gear or a spring",
                          rotor->probes[rotor->aside].name);
    if (twists && rotor->drive.inertia > 0.0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "the drive has an inertia and stations twist, whose own inertia counts, expected one of them");
    if (!twists && !(rotor->drive.inertia > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "torques turn the shaft and its inertia is not known, expected an element "
                                           "drive with inertia");
    if (!twists) return whirl_ok();
    if (rotor->grounded)
        return whirl_fail(WHIRL_BAD_INPUT, "a spring holds a twist to the ground, and torques turn the shaft, expected "
                                           "none");
    if (rotor->drive.given) stations[count++] = rotor->drive.at;
    if (rotor->drive.given) stations[count++] = rotor->drive.load_at;
    for (size_t i = 0; i < rotor->torque_count; i++) stations[count++] = rotor->torques[i].station;
    for (size_t i = 0; i < count; i++)
        if (stations[i] == NO_STATION || rotor->twists[stations[i]].coordinate == NO_COORDINATE)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "stations twist and a torque acts on the shaft as a whole, expected a station that "
                              "twists (at)");
    return whirl_ok();
}

whirl_status whirl_running_check(const whirl_system *system, bool driven) {
    const whirl_rotor *rotor = rotor_of_system(system);
    if (!rotor)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine is no rotor, expected stations and elements, whose shaft turns");
    if (rotor->phase)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "sections of the machine are taken by the %s, expected those of its shaft (keyphasor: no)",
                          rotor->keyphasor);
    if (rotor->spool_count > 0 && rotor->twist_count > 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine has stations that twist and shaft '%s' with a speed of its own, expected one of "
                          "them",
                          rotor->spools[0].name);
    if (driven) return running_check_torques(rotor);
    if (rotor->twist_count > 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine has stations that twist, and a rate changes its speed, expected no rate but "
                          "torques, or stations without twist (moves: xy, x or y)");
    return whirl_ok();
}

whirl_status whirl_running_check_change(const whirl_system *system, const whirl_system *changed) {
    const whirl_rotor *rotor = rotor_of_system(system), *other = rotor_of_system(changed);
    if (rotor && other && rotor->lanes.alike(rotor, other) && rotor->length == other->length &&
        system->torque_count == changed->torque_count)
        return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "the change gives the machine other parts or another length scale, expected "
                                       "other numbers of the same parts");
}

/// Returns true if the coupling by mass between the same coordinates of both machines differs.
static bool running_couples_otherwise(const whirl_rotor *one, const whirl_rotor *other) {
    const coupling *a = &one->coupled, *b = &other->coupled;
    return a->count > 0 && a->count == b->count &&
           memcmp(a->share, b->share, a->count * a->count * sizeof *a->share) != 0;
}

whirl_status running_check_machine(const running_rotor *r, const whirl_machine *machine) {
    const whirl_status status = whirl_running_check(machine->system, r->driven);
    if (status.code != WHIRL_OK) return status;
    const whirl_rotor *rotor = rotor_of_system(machine->system);
    if (machine->system->frequency_count > 0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "a bearing has coefficients over frequencies of whirl, expected a machine that moves in time");
    if (r->rotor && running_couples_otherwise(r->rotor, rotor))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "masses between stations (the fluid of a seal in a housing that moves) differ between %.6g "
                          "and %.6g rad/s, expected the same at all speeds of a run, or a housing that stands",
                          rotor->speed, r->rotor->speed);
    if (r->rotor && !r->rotor->lanes.alike(r->rotor, rotor))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine has other parts at %.6g rad/s than at %.6g rad/s, expected the same at all "
                          "speeds of its run",
                          rotor->speed, r->rotor->speed);
    return whirl_ok();
}

whirl_status running_sample(const running_rotor *r, whirl_machine_at *make, const void *context, size_t count,
                            const double *w, const double *spools, double *out) {
    const size_t numbers = r->rotor->lanes.number_count;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        whirl_machine machine = {.system = NULL};
        double speeds[WHIRL_MAX_SPOOLS] = {0.0};
        for (size_t k = 0; k < r->spool_count; k++)
            speeds[k] = r->unit * (spools ? spools[i * r->spool_count + k] : r->spools[k].highest);
        status = make(context, w[i] * r->unit, r->spool_count > 0 ? speeds : NULL, &machine);
        if (status.code != WHIRL_OK) return status;
        status = running_check_machine(r, &machine);
        if (status.code == WHIRL_OK)
            memcpy(out + i * numbers, rotor_of_system(machine.system)->numbers, numbers * sizeof *out);
        if (machine.release) machine.release(machine.owner);
    }
    return status;
}
