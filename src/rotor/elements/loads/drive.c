// The drive of the shaft in a run-up: a motor and a load. It acts on no coordinate of a station.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "table.h"

enum { SHAFT, INERTIA, AT, TORQUE, NO_LOAD, SPEEDS, TORQUES, LOAD_AT, LOAD, LINEAR, QUADRATIC, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [SHAFT] = NAME_KEY("shaft", OPTIONAL, "shafts",
                       "shaft with a speed of its own that it turns; absent: the rotor's own shaft"),
    [INERTIA] = NUMBER_KEY("inertia", "J", "kg m2", OPTIONAL, WHIRL_POSITIVE,
                           "polar moment of inertia of all that turns, about axes through its centres of mass; "
                           "required unless stations twist, whose own inertia counts"),
    [AT] = STATION_KEY("at", OPTIONAL,
                       "station of the motor; required if stations twist; absent: it turns the shaft as a whole"),
    [TORQUE] = NUMBER_KEY("torque", "T", "N m", OPTIONAL, WHIRL_ANY, "torque of the motor at standstill"),
    [NO_LOAD] = CITED_NUMBER_KEY("no_load_speed", "", "rad/s", OPTIONAL, WHIRL_POSITIVE,
                                 "speed at which the torque has fallen linearly to 0; absent: the torque is constant",
                                 "Kononenko 1969"),
    [SPEEDS] = CITED_NUMBERS_KEY(
        "speeds", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
        "rising speeds at which `torques` are given, in place of torque; between them monotone cubics",
        "Fritsch, Butland 1984"),
    [TORQUES] =
        CITED_NUMBERS_KEY("torques", "", "N m", OPTIONAL, WHIRL_ANY, "torques of the motor at these speeds", ""),
    [LOAD_AT] = STATION_KEY("load_at", OPTIONAL, "station of the load; absent: that of the motor"),
    [LOAD] =
        NUMBER_KEY("load", "", "N m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "torque of dry friction against the rotation"),
    [LINEAR] = NUMBER_KEY("load_linear", "", "N m s", DEFAULT("0"), WHIRL_ANY, "load torque divided by the speed"),
    [QUADRATIC] = NUMBER_KEY("load_quadratic", "b", "N m s2", DEFAULT("0"), WHIRL_ANY,
                             "load torque divided by the square of the speed, as of fans and pumps"),
};

static whirl_status drive_build(const key_value *values, assembly *to, element *out) {
    const key_value *speeds = &values[SPEEDS], *torques = &values[TORQUES];
    // Check that there is one drive, whose torque is a line or a table.
    const size_t spool = values[SHAFT].given ? to->spool_of_shaft[values[SHAFT].station[0]] : 0;
    shaft_drive *drive = spool > 0 ? &to->spool_drives[spool - 1] : &to->drive;
    (void)out;
    if (values[SHAFT].given && spool == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "turns a shaft whose speed follows the rotor's, expected a shaft with the "
                                           "key speed, or no shaft");
    if (drive->given) return whirl_fail(WHIRL_BAD_INPUT, "is a second drive of its shaft, expected one");
    if (spool > 0 && (values[AT].given || values[LOAD_AT].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and turns a shaft of its own as a whole, expected one of them",
                          values[AT].given ? "at" : "load_at");
    if (speeds->given != torques->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s alone, expected speeds and torques together",
                          speeds->given ? "speeds" : "torques");
    if (speeds->given && (values[TORQUE].given || values[NO_LOAD].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and a table of torques, expected one of them",
                          values[TORQUE].given ? "torque" : "no_load_speed");
    if (speeds->given && (speeds->count < 2 || speeds->count != torques->count || speeds->rows > 1 ||
                          !table_rises(speeds->count, speeds->list)))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %zu speeds and %zu torques, expected as many of both, at least 2, the "
                          "speeds rising",
                          speeds->count, torques->count);
    if (values[NO_LOAD].given && !values[TORQUE].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no_load_speed without torque, expected both");
    // Check the stations of the motor and of its load.
    const size_t at = values[AT].given ? values[AT].station[0] : NO_STATION;
    for (int key = AT; key <= LOAD_AT; key += LOAD_AT - AT) {
        const size_t station = values[key].given ? values[key].station[0] : NO_STATION;
        if (station == NO_STATION || to->stations[station].spool == 0) continue;
        return whirl_fail(WHIRL_BAD_INPUT,
                          "acts on '%s', whose shaft has a speed of its own, expected shaft: %s in place of %s",
                          to->stations[station].name, to->spools[to->stations[station].spool - 1].name, keys[key].name);
    }
    whirl_status status = assembly_turns(to, at);
    if (status.code == WHIRL_OK && values[LOAD_AT].given) status = assembly_turns(to, values[LOAD_AT].station[0]);
    if (status.code != WHIRL_OK) return status;
    // Copy the drive to the assembly.
    *drive = (shaft_drive){.given = true,
                           .at = at,
                           .load_at = values[LOAD_AT].given ? values[LOAD_AT].station[0] : at,
                           .inertia = values[INERTIA].given ? values[INERTIA].number : 0.0,
                           .torque = values[TORQUE].given ? values[TORQUE].number : 0.0,
                           .no_load = values[NO_LOAD].given ? values[NO_LOAD].number : 0.0,
                           .count = speeds->given ? speeds->count : 0,
                           .load = values[LOAD].number,
                           .linear = values[LINEAR].number,
                           .quadratic = values[QUADRATIC].number};
    for (size_t i = 0; i < drive->count; i++) {
        drive->speeds[i] = speeds->list[i];
        drive->torques[i] = torques->list[i];
    }
    return whirl_ok();
}

double drive_torque(const shaft_drive *drive, double speed) {
    if (drive->count > 0) {
        const double low = drive->speeds[0], high = drive->speeds[drive->count - 1];
        return table_value(drive->count, drive->speeds, drive->torques, fmin(fmax(speed, low), high));
    }
    return drive->no_load > 0.0 ? drive->torque * (1.0 - speed / drive->no_load) : drive->torque;
}

double drive_load(const shaft_drive *drive, double speed, double slip) {
    const double share = slip > 0.0 ? fmin(fmax(speed / slip, -1.0), 1.0) : 1.0;
    return drive->load * share + speed * (drive->linear + drive->quadratic * fabs(speed));
}

double drive_highest(const shaft_drive *drive) {
    return drive->count > 0 ? drive->speeds[drive->count - 1] : drive->no_load;
}

const element_type drive_element = {
    .group = {"drive", "what turns the shaft in a run-up: the torque of a motor over the speed, and a load",
              "Sommerfeld 1902; Kononenko 1969", keys, KEY_COUNT, NULL, NULL},
    .build = drive_build,
};
#endif
