// Rub: work of the unilateral contacts over the record.
#include <math.h>

#include "analysis.h"

enum { WHIRL_WATCHED_OF_CONTACTS(WATCHED_INDEX) CONTACT, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [CONTACT] = {WHIRL_FIELD_RUB_CONTACT, "1", "1: a contact closed; else 0", WHIRL_PER_POINT, 1, NULL},
    // clang-format off
    WHIRL_WATCHED_OF_CONTACTS(WATCHED_PLAN)
    // clang-format on
};

/// Sets the torque and the power of friction to 0 where there is no friction, and to NaN where the system does not
/// report them.
static void settle_friction(const whirl_record *record, size_t which, const block_view *view) {
    const double torque = record->contact_torque[which];
    const bool known = record->system && record->system->friction;
    if (known && isfinite(record->contact_most[which]) && isfinite(torque)) return;
    const double number = known && torque == 0.0 ? 0.0 : NAN;
    *view_numbers(view, WATCHED_contact_torque, which) = number;
    *view_numbers(view, WATCHED_contact_most, which) = number;
    *view_numbers(view, WATCHED_contact_power, which) = number;
}

static whirl_status rub_compute(const whirl_record *record, const whirl_record_options *options,
                                const block_view *view) {
    (void)options;
    bool touched = false;
    for (size_t which = 0; which < record->contact_count; which++) {
        touched = touched || record->contact_force[which] > 0.0;
        WHIRL_WATCHED_OF_CONTACTS(WATCHED_FILL)
        settle_friction(record, which, view);
    }
    *view_numbers(view, CONTACT, 0) = touched ? 1.0 : 0.0;
    return whirl_ok();
}

const analysis_plan rub_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute = rub_compute};
