// Rub: what the unilateral contacts did over the record.
#include "analysis.h"

enum { CONTACT, SHARE, NUMBER, MAX_FORCE, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [CONTACT] = {"contact", "1", "1 where anything touched, else 0", WHIRL_PER_POINT, 1, NULL},
    [SHARE] = {"share", "1", "share of the time in contact", WHIRL_PER_CONTACT, 1, NULL},
    [NUMBER] = {"number", "1", "times that contact began", WHIRL_PER_CONTACT, 1, NULL},
    [MAX_FORCE] = {"max_force", "force", "largest normal force", WHIRL_PER_CONTACT, 1, NULL},
};

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    (void)options;
    bool touched = false;
    for (size_t c = 0; c < record->contact_count; c++) {
        touched = touched || record->contact_force[c] > 0.0;
        *view_numbers(view, SHARE, c) = record->contact_share[c];
        *view_numbers(view, NUMBER, c) = record->contact_number[c];
        *view_numbers(view, MAX_FORCE, c) = record->contact_force[c];
    }
    *view_numbers(view, CONTACT, 0) = touched ? 1.0 : 0.0;
    return whirl_ok();
}

const analysis_plan rub_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute = compute};
