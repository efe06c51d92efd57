#include "pads_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "doubts.h"
#include "elements/films/pads_look_up.h"
#include "oil.h"
#include "pad_centred.h"
#include "pad_table.h"
#include "pad_tables.h"
#include "turbulence.h"
#include "whirl/internal/bearing.h"

static oil oil_of(const key_value *values) {
    return (oil){&values[PADS_OIL]};
}

/// Returns the Reynolds number rho omega R c/mu.
static double reynolds_of(const key_value *values, double speed) {
    const oil own = oil_of(values);
    return oil_reynolds(&own, speed, sqrt(values[PADS_RADIUS].number * values[PADS_CLEARANCE].number));
}

/// Returns the name of the usual bearing of a choice, in the order of the keys' tables.
static const char *shape_name(bool tilting, int choice) {
    static const char *const fixed[] = {"two-groove", "elliptical", "three-lobe", "four-lobe", "offset-half"};
    static const char *const free[] = {"tilting-4", "tilting-5"};
    return tilting ? free[choice] : fixed[choice];
}

/// Reads the pads as the keys give them, for a shaft that turns from x to y.
static whirl_status read_pads(const key_value *values, bool tilting, whirl_pads *out) {
    const key_value *pivots = &values[PADS_PIVOTS];
    const double preload = values[PADS_PRELOAD].number;
    *out = (whirl_pads){.ratio = values[PADS_LENGTH].number / (2.0 * values[PADS_RADIUS].number),
                        .tilting = tilting,
                        .gumbel = values[PADS_CAVITATION].choice == 1,
                        .turbulence = (whirl_turbulence)values[PADS_TURBULENCE].choice};
    // Use a usual shape by its name.
    if (values[PADS_SHAPE].given == pivots->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected a usual shape or pivots",
                          pivots->given ? "both shape and pivots" : "neither shape nor pivots");
    if (values[PADS_SHAPE].given) {
        if (values[PADS_ARC].given || values[PADS_OFFSET].given)
            return whirl_fail(WHIRL_BAD_INPUT, "has %s and shape, expected pivots with it",
                              values[PADS_ARC].given ? "arc" : "offset");
        whirl_pads_named(shape_name(tilting, values[PADS_SHAPE].choice), preload, out);
        if (values[PADS_PRELOAD].given && preload != 0.0 && out->pads[0].preload == 0.0)
            return whirl_fail(WHIRL_BAD_INPUT, "has a preload, which a two-groove bearing has not");
        return whirl_ok();
    }
    // Otherwise, place equal pads at the given pivots.
    if (!values[PADS_ARC].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has pivots without arc, expected the length of the pads");
    out->count = pivots->count > 0 ? pivots->count : 1;
    if (out->count > MAX_PADS || pivots->rows > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu pivots, expected a list of at most %d", out->count, MAX_PADS);
    for (size_t i = 0; i < out->count; i++)
        out->pads[i] = (whirl_pad){.pivot = pivots->count > 0 ? pivots->list[i] : pivots->number,
                                   .arc = values[PADS_ARC].number,
                                   .offset = values[PADS_OFFSET].number,
                                   .preload = preload};
    size_t one, other;
    if (!whirl_pads_overlap(out, &one, &other)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "has pad %zu over pad %zu, expected pads next to each other", other + 1,
                      one + 1);
}

whirl_status pads_of_keys(const key_value *values, bool tilting, bool clockwise, whirl_pads *out) {
    const whirl_status status = read_pads(values, tilting, out);
    for (size_t i = 0; i < out->count; i++) {
        // Usual shapes are defined for shafts that turn from x to y; for other shafts they are mirrored.
        const bool mirrored = clockwise && values[PADS_SHAPE].given;
        if (mirrored) out->pads[i].pivot = 3.14159265358979323846 - out->pads[i].pivot;
        out->pads[i].pivot += values[PADS_TURNED].number;
    }
    return status;
}

static int by_pivot(const void *a, const void *b) {
    const double turn = 6.28318530717958647692;
    const double one = ((const whirl_pad *)a)->pivot, other = ((const whirl_pad *)b)->pivot;
    const double apart = one - turn * floor(one / turn) - (other - turn * floor(other / turn));
    return (apart > 0.0) - (apart < 0.0);
}

/// Writes the numbers of one pad, whose angles are for a shaft that turns from x to y. light: it tilts without inertia.
static whirl_status put_pad(const whirl_pads *bearing, const whirl_pad *pad, bool light, double *number) {
    const double lead = (0.5 - pad->offset) * pad->arc, middle = pad->pivot + lead;
    number[PAD_COSINE] = cos(middle);
    number[PAD_SINE] = sin(middle);
    // The pivot's direction in the frame of the middle is at -lead.
    number[PAD_SHIFT_X] = pad->preload * cos(lead);
    number[PAD_SHIFT_Y] = -pad->preload * sin(lead);
    number[PAD_ALONG_X] = sin(lead);
    number[PAD_ALONG_Y] = cos(lead);
    number[PAD_HALF_COSINE] = cos(0.5 * pad->arc);
    number[PAD_OVER_HALF_SINE] = 1.0 / sin(0.5 * pad->arc);
    const pad_table_key key = {.arc = pad->arc,
                               .ratio = bearing->ratio,
                               .law = bearing->gumbel ? CAVITATION_GUMBEL : CAVITATION_REYNOLDS,
                               .turbulence = bearing->turbulence,
                               .reynolds = bearing->reynolds,
                               .lead = light ? lead : 0.0};
    return pad_table_number(&key, &number[PAD_TABLE]);
}

/// Rounds a Reynolds number to that of a table. Turbulent tables are 2 percent apart.
static double nearest_table(double reynolds) {
    const double step = log(1.02);
    return reynolds > 0.0 ? exp(step * round(log(reynolds) / step)) : 0.0;
}

/// Returns the factor that converts films of the table's Reynolds number to that of the bearing: the ratio of the
/// circumferential factors.
static double to_the_table(const key_value *values, double reynolds, double table) {
    const whirl_turbulence law = (whirl_turbulence)values[PADS_TURBULENCE].choice;
    return turbulent_resistance(law, reynolds).around / turbulent_resistance(law, table).around;
}

/// Computes the ratio of the journal's speed to the rotor's.
static whirl_status journal_ratio(const key_value *values, const assembly *to, double *ratio) {
    *ratio = to->stations[values[PADS_AT].station[0]].ratio;
    if (*ratio == 0.0) return whirl_fail(WHIRL_BAD_INPUT, "has a journal that does not turn, expected one that does");
    if (!values[PADS_FROM].given) return whirl_ok();
    const assembly_station *housing = &to->stations[values[PADS_FROM].station[0]];
    if ((housing->shaft == NO_SHAFT && !housing->lumped) || housing->ratio == 0.0) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "has its pads on a shaft that turns, expected a housing that does not turn; use "
                                       "film with housing_ratio if it does");
}

/// Returns the scale of a film's force, mu omega R L (R/c)^2, N.
static double strength_of(const key_value *values, double viscosity, double speed) {
    const double share = values[PADS_RADIUS].number / values[PADS_CLEARANCE].number;
    return viscosity * speed * values[PADS_RADIUS].number * values[PADS_LENGTH].number * share * share;
}

/// Least damping of a pad's tilt. Without it, a pad that lost its film would keep its rate of tilt until its edge is in
/// the journal. least_damper is in units of mu R^3 L (R/c)^2/c. soonest, for pads without inertia that have a spring,
/// is the least angle, rad, by which the shaft turns while the spring returns the pad.
static const double least_damper = 3e-4, soonest = 0.1;

static void put_tilts(const key_value *values, const assembly *to, double turn, double strength, double *number) {
    const double inertia = values[PADS_INERTIA].number, clock = to->clock, radius = values[PADS_RADIUS].number;
    if (inertia == 0.0) {
        const double over = values[PADS_CLEARANCE].number / (radius * radius * strength);
        number[PADS_TILT_FORCE] = 1.0;
        number[PADS_TILT_SPRING] = values[PADS_SPRING].number * over;
        number[PADS_TILT_DAMPER] = fmax(values[PADS_DAMPER].number * clock * over,
                                        fmax(least_damper, soonest * number[PADS_TILT_SPRING]) / turn);
        return;
    }
    number[PADS_TILT_FORCE] = radius * radius * strength / (values[PADS_CLEARANCE].number * inertia * clock * clock);
    number[PADS_TILT_SPRING] = values[PADS_SPRING].number / (inertia * clock * clock);
    number[PADS_TILT_DAMPER] =
        fmax(values[PADS_DAMPER].number / (inertia * clock), number[PADS_TILT_FORCE] * least_damper / turn);
}

/// Writes the numbers of yielding pivots.
static whirl_status put_yields(const key_value *values, const assembly *to, double strength, element *out) {
    const bool yields = values[PADS_PIVOT].given;
    const double mass = values[PADS_MASS].number, clock = to->clock;
    if (!yields && (values[PADS_PIVOT_DAMPER].given || values[PADS_MASS].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s without pivot_stiffness, expected that, too",
                          values[PADS_MASS].given ? "pad_mass" : "pivot_damping");
    if (!yields) return whirl_ok();
    if (!values[PADS_MASS].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has pivot_stiffness without pad_mass, expected that of a pad, too");
    out->type = &tilting_pad_yielding_type;
    out->states += 2 * (size_t)out->law;
    out->number[PADS_YIELD_FORCE] = strength / (values[PADS_CLEARANCE].number * mass * clock * clock);
    out->number[PADS_YIELD_SPRING] = values[PADS_PIVOT].number / (mass * clock * clock);
    out->number[PADS_YIELD_DAMPER] = values[PADS_PIVOT_DAMPER].number / (mass * clock);
    return whirl_ok();
}

whirl_status pads_build(const key_value *values, bool tilting, assembly *to, element *out) {
    const oil own = oil_of(values);
    whirl_pads bearing = {.count = 0};
    double viscosity, ratio;
    // Read and check the keys.
    whirl_status status = journal_ratio(values, to, &ratio);
    if (status.code == WHIRL_OK) status = pads_of_keys(values, tilting, ratio * to->turn < 0.0, &bearing);
    if (status.code == WHIRL_OK && !(bearing.ratio >= 0.02 && bearing.ratio <= 20.0))
        status =
            whirl_fail(WHIRL_BAD_INPUT, "is %.3g times as long as its diameter, expected 0.02 to 20", bearing.ratio);
    if (status.code == WHIRL_OK) status = oil_viscosity(&own, &viscosity);
    if (status.code == WHIRL_OK && bearing.turbulence != WHIRL_LAMINAR && !values[PADS_OIL + OIL_DENSITY].given)
        status =
            whirl_fail(WHIRL_BAD_INPUT, "has turbulence and an unknown Reynolds number, expected the oil's density");
    if (status.code == WHIRL_OK) status = element_in_housing(&values[PADS_AT], &values[PADS_FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    // Compute the scales: sense of rotation, strength of the film, Reynolds number of the table.
    const double turn = ratio * to->turn, sign = copysign(1.0, turn), speed = fabs(ratio * to->speed);
    const double reynolds = reynolds_of(values, speed);
    const bool light = tilting && values[PADS_INERTIA].number == 0.0;
    bearing.reynolds = bearing.turbulence == WHIRL_LAMINAR ? 0.0 : nearest_table(reynolds);
    const double strength = strength_of(values, viscosity, fabs(ratio * to->pace)) *
                            to_the_table(values, reynolds, nearest_table(reynolds));
    out->law = (int)bearing.count;
    out->states = !tilting ? 0 : light ? bearing.count : 2 * bearing.count;
    out->number[PADS_OVER_CLEARANCE] = to->length / values[PADS_CLEARANCE].number;
    out->number[PADS_CLEARANCE_UNIT] = values[PADS_CLEARANCE].number / to->length;
    out->number[PADS_TWICE] = 2.0 / fabs(turn);
    out->number[PADS_SIGN] = sign;
    const double radius = values[PADS_RADIUS].number, size = radius * radius * radius * values[PADS_LENGTH].number;
    out->fluid = (fluid_drag){.shear = values[PADS_COUNT].number * 6.28318530717958647692 * viscosity * size /
                                       values[PADS_CLEARANCE].number,
                              .reynolds = reynolds_of(values, 1.0),
                              .turbulence = values[PADS_TURBULENCE].choice,
                              .turns = {ratio, 0.0},
                              .spool = {to->stations[values[PADS_AT].station[0]].spool, 0},
                              .housing = GROUND};
    // Sort pads around the journal, so that no result depends on the order in which they are given.
    if (values[PADS_PIVOTS].given) qsort(bearing.pads, bearing.count, sizeof *bearing.pads, by_pivot);
    // Compute the numbers of the pads, of their tilts and of their yields.
    for (size_t i = 0; i < bearing.count && status.code == WHIRL_OK; i++) {
        whirl_pad pad = bearing.pads[i];
        pad.pivot *= sign;
        status = put_pad(&bearing, &pad, light, out->number + PADS_FIRST + i * PAD_NUMBERS);
    }
    if (tilting) put_tilts(values, to, fabs(turn), strength, out->number);
    if (tilting && status.code == WHIRL_OK) status = put_yields(values, to, strength, out);
    // Compute the factors that convert the film's force to the accelerations of the ports.
    for (size_t port = 0; port < 4; port++)
        out->number[PADS_NUMBERS + port] =
            out->port[port] == NO_COORDINATE
                ? 0.0
                : values[PADS_COUNT].number * strength / assembly_force_scale(to, out->port[port]);
    return status;
}

void pads_begin(const element *own, double *states) {
    const double *pad = own->number + PADS_FIRST;
    const pad_table_key key = pad_table_key_of(pad[PAD_TABLE]);
    const double lead = atan2(pad[PAD_ALONG_X], pad[PAD_ALONG_Y]);
    const whirl_pad alone = {
        .arc = key.arc, .offset = 0.5 - lead / key.arc, .preload = hypot(pad[PAD_SHIFT_X], pad[PAD_SHIFT_Y])};
    const double tilt = pad_centred_tilt(&alone, key.ratio, key.law == CAVITATION_GUMBEL);
    for (size_t p = 0; p < (size_t)own->law; p++)
        states[pads_are_light(own) ? p : 2 * p] = own->number[PADS_CLEARANCE_UNIT] * tilt;
}

static double table_of(const element *own, size_t pad) {
    return own->number[PADS_FIRST + pad * PAD_NUMBERS + PAD_TABLE];
}

whirl_status pads_hold(const element *own, const whirl_stop *stop) {
    whirl_status status = whirl_ok();
    size_t held = 0;
    while (held < (size_t)own->law && status.code == WHIRL_OK) {
        status = pad_table_hold(table_of(own, held), stop);
        held += status.code == WHIRL_OK;
    }
    while (status.code != WHIRL_OK && held > 0) pad_table_release(table_of(own, --held));
    return status;
}

void pads_release(const element *own) {
    for (size_t p = 0; p < (size_t)own->law; p++) pad_table_release(table_of(own, p));
}

void pads_note(const element *own, double length, double clock, char *text, size_t size) {
    (void)length, (void)clock;
    // The errors were measured over positions in pads of 40 to 160 degrees with L/D 0.25 to 2.
    snprintf(
        text, size,
        "films of %d pads by tables: the force errs by less than 0.1 %% of a pad's largest at 95 %% of places, by up "
        "to 1.1 %% where a film begins",
        own->law);
}

/// Returns the clearance as assembled, c (1 - preload). Around fixed pads the journal can move at least that far in
/// every direction.
double pads_clearance(const element *own) {
    const double *pad = own->number + PADS_FIRST;
    return (1.0 - hypot(pad[PAD_SHIFT_X], pad[PAD_SHIFT_Y])) / own->number[PADS_OVER_CLEARANCE];
}

void pads_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double radius = values[PADS_RADIUS].number, clearance = values[PADS_CLEARANCE].number;
    const double ratio = values[PADS_LENGTH].number / (2.0 * radius);
    doubt_clearance(to, "clearance", clearance, radius);
    if (ratio < 0.1 || ratio > 2.0)
        doubt_value(to, "length", "is %.3g times the diameter, and bearings of pads have 0.1 to 2 times", ratio);
    doubt_flow(to, reynolds_of(values, speed), radius, clearance, values[PADS_TURBULENCE].choice != 0);
}
