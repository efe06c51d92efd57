// The options of recording as they describe themselves, and what follows from them.
#include <limits.h>
#include <math.h>

#include "whirl/analyze.h"

#define AT(TYPE, field) .type = WHIRL_MEMBER_##TYPE, .offset = offsetof(whirl_record_options, field)

static const whirl_member members[] = {
    {"transient", AT(WHOLE, transient), .part = "integrate", .refined = true,
     .key = {"transient",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "1100",
             {0, WHIRL_MAX_TRANSIENT, false, false},
             NULL,
             "revolutions before the record",
             ""}},
    {"record", AT(WHOLE, record), .part = "integrate",
     .key = {"record",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "100",
             {1, WHIRL_MAX_RECORD, false, false},
             NULL,
             "revolutions recorded",
             ""}},
    {"watch", AT(WHOLE, watch), .part = "integrate", .refined = true,
     .key = {"watch",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "0",
             {0, WHIRL_MAX_TRANSIENT + WHIRL_MAX_RECORD, false, false},
             NULL,
             "last revolutions over which the section and the growth of a disturbance are followed, at least those "
             "recorded; 0: the record and half the transient, of that at most the larger of 1000 and record",
             ""}},
    {"settle", AT(FLAG, settle), .part = "integrate",
     .key = {"settle", "", "", WHIRL_KEY_CHOICE, false, "yes", WHIRL_ANY, "yes|no|true|false",
             "yes: the transient ends early where the motion has settled on a periodic orbit to 1e-11", ""}},
    {"waveform_revolutions", AT(WHOLE, waveform_revolutions), .part = "keep",
     .key = {"waveform",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "0",
             {0, WHIRL_MAX_RECORD, false, false},
             NULL,
             "last revolutions whose waveform is kept",
             ""}},
    {"samples_per_revolution", AT(WHOLE, samples_per_revolution), .part = "keep",
     .key = {"samples",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "64",
             {1, WHIRL_MAX_STEPS, false, false},
             NULL,
             "samples of a waveform a revolution, at least; not more than steps_per_revolution",
             ""}},
    {"highest_order", AT(NUMBER, highest_order), .part = "keep",
     .key = {"highest_order", "", "1", WHIRL_KEY_NUMBER, false, "5", WHIRL_POSITIVE, NULL,
             "spectra are kept up to this order of the speed", ""}},
    {"spectra", AT(FLAG, spectra), .part = "",
     .key = {"spectra", "", "", WHIRL_KEY_CHOICE, false, "no", WHIRL_ANY, "yes|no", "whole spectra are kept", ""}},
    {"waveform", AT(FLAG, waveform), .part = "",
     .key = {"waveforms", "", "", WHIRL_KEY_CHOICE, false, "yes", WHIRL_ANY, "yes|no", "waveforms are recorded", ""}},
    {"growth", AT(WHOLE, growth), .part = "",
     .key = {"growth",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "1",
             {0, WHIRL_GROWTH_ALL, false, false},
             NULL,
             "disturbances that are followed: 0 none, 1 one, 2 all",
             ""}},
    // What a case says anew of its details.
    {.type = WHIRL_MEMBER_WHOLE,
     .offset = offsetof(whirl_record_options, transient),
     .part = "detail",
     .key = {"transient",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "",
             {0, WHIRL_MAX_TRANSIENT, false, false},
             NULL,
             "revolutions before the record; as in integrate where absent",
             ""}},
    {.type = WHIRL_MEMBER_WHOLE,
     .offset = offsetof(whirl_record_options, record),
     .part = "detail",
     .key = {"record",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "",
             {1, WHIRL_MAX_RECORD, false, false},
             NULL,
             "revolutions recorded; as in integrate where absent",
             ""}},
    {.type = WHIRL_MEMBER_WHOLE,
     .offset = offsetof(whirl_record_options, waveform_revolutions),
     .part = "detail",
     .key = {"waveform",
             "",
             "1",
             WHIRL_KEY_WHOLE,
             false,
             "20",
             {0, WHIRL_MAX_RECORD, false, false},
             NULL,
             "last revolutions whose waveform is kept; not more than record",
             ""}},
    {.part = NULL},
};

const whirl_member *whirl_record_members(void) {
    return members;
}

whirl_record_options whirl_record_default(void) {
    whirl_record_options options = {.settle = false};
    whirl_members_default(members, &options);
    options.settle = false;
    return options;
}

int whirl_record_watch(const whirl_record_options *options) {
    enum { ENOUGH = 1000 }; // so that long transients cost no memory
    if (options->watch > 0) return options->watch;
    const int most = options->record > ENOUGH ? options->record : ENOUGH;
    const int before = options->transient / 2 < most ? options->transient / 2 : most;
    return options->record <= INT_MAX - before ? options->record + before : options->record;
}

int whirl_record_samples(const whirl_record_options *options, int steps_per_revolution) {
    const int steps = steps_per_revolution;
    const int least = options->samples_per_revolution < steps ? options->samples_per_revolution : steps;
    if (steps % least == 0) return least;
    // Divisors come in pairs.
    int found = steps;
    for (int small = 1; small <= steps / small; small++) {
        const int large = steps / small;
        if (steps % small != 0) continue;
        if (large >= least && large < found) found = large;
        if (small >= least && small < found) found = small;
    }
    return found;
}

whirl_status whirl_record_options_check(const whirl_record_options *options) {
    // What is advised may go beyond what cases may say.
    if (options->transient < 0 || options->record < 1 || options->transient > INT_MAX - options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "transient is %d and record %d revolutions, expected at least 0 and 1",
                          options->transient, options->record);
    const int watch = whirl_record_watch(options);
    if (watch < options->record || watch > options->transient + options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "watch is %d revolutions, expected record (%d) to transient + record (%d)",
                          watch, options->record, options->transient + options->record);
    if (options->waveform_revolutions < 0 || options->waveform_revolutions > options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "waveform is %d revolutions, expected 0 to record (%d)",
                          options->waveform_revolutions, options->record);
    if (options->samples_per_revolution < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "samples_per_revolution is %d, expected at least 1",
                          options->samples_per_revolution);
    if (!(options->highest_order > 0.0) || !isfinite(options->highest_order))
        return whirl_fail(WHIRL_BAD_INPUT, "the highest order of spectra is %g, expected a number above 0",
                          options->highest_order);
    return whirl_ok();
}

/// Whether all disturbances can be followed, where they are to be.
static whirl_status check_growth(const whirl_system *system, const char *name, const whirl_record_options *options) {
    const whirl_method *method;
    if (options->growth != WHIRL_GROWTH_ALL) return whirl_ok();
    if (!system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT, "the system gives no Jacobian, expected one to follow all disturbances");
    if (whirl_method_find(name, &method).code == WHIRL_OK && !method->follows)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "method %s takes no disturbances along, expected rk4, dop853 or rodas5p for all exponents",
                          name);
    return whirl_ok();
}

whirl_status whirl_record_check(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options) {
    const whirl_status status = whirl_record_options_check(options);
    return status.code == WHIRL_OK ? check_growth(system, integrate->method, options) : status;
}
