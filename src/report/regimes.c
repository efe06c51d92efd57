#include "regimes.h"
#include "whirl/engine/result.h"

#include <stdio.h>
#include <string.h>

#include "quantities.h"

enum { SHORT_INTERVAL = 3 };

static const struct {
    const char *name, *colour;
} classes[CLASS_COUNT] = {
    [CLASS_P1] = {"P-1", "#366EFB"},
    [CLASS_P2] = {"P-2", "#1FBADD"},
    [CLASS_P4] = {"P-4", "#1D7257"},
    [CLASS_OTHER_PERIOD] = {"other P-k", "#664406"},
    [CLASS_QUASI_PERIODIC] = {"quasi-periodic", "#CC0892"},
    [CLASS_CHAOTIC] = {"chaotic", "#000000"},
    [CLASS_UNDETERMINED] = {"undetermined", "#9A9F95"},
    [CLASS_DIVERGED] = {"diverged", "#FB8D41"},
    [CLASS_NOT_JUDGED] = {"not judged", "#9A9F95"}, // the colour of undetermined: no figure shows both
};

regime_class regime_class_of(const whirl_verdict *verdict) {
    switch (verdict->regime) {
    case WHIRL_PERIODIC:
        return verdict->period == 1   ? CLASS_P1
               : verdict->period == 2 ? CLASS_P2
               : verdict->period == 4 ? CLASS_P4
                                      : CLASS_OTHER_PERIOD;
    case WHIRL_QUASI_PERIODIC:
        return CLASS_QUASI_PERIODIC;
    case WHIRL_CHAOTIC:
        return CLASS_CHAOTIC;
    case WHIRL_DIVERGING:
        return CLASS_DIVERGED;
    case WHIRL_NOT_JUDGED:
        return CLASS_NOT_JUDGED;
    default:
        return CLASS_UNDETERMINED;
    }
}

const char *regime_class_name(regime_class kind) {
    return classes[kind].name;
}

const char *regime_class_colour(regime_class kind) {
    return classes[kind].colour;
}

const char *attractor_colour(size_t number) {
    // The colours of Okabe and Ito, in an order in which neighbours also differ in lightness.
    static const char *const colours[ATTRACTOR_COLOURS] = {"#0072B2", "#E69F00", "#56B4E9", "#009E73",
                                                           "#CC79A7", "#D55E00", "#F0E442", "#000000"};
    return colours[(number - 1) % ATTRACTOR_COLOURS];
}

void regime_name(const whirl_verdict *verdict, char *text, size_t size) {
    if (verdict->regime == WHIRL_PERIODIC)
        whirl_verdict_name(verdict, text, size);
    else
        snprintf(text, size, "%s", whirl_regime_name(verdict->regime));
}

size_t regime_group(const regime_interval *intervals, size_t count) {
    size_t end = 0;
    while (end < count && intervals[end].count < SHORT_INTERVAL && intervals[end].branch == intervals[0].branch) end++;
    return end >= 2 ? end : 1;
}

void regime_group_name(const regime_interval *group, size_t count, char *text, size_t size) {
    size_t used = (size_t)snprintf(text, size, "%s%s", count > 1 ? "changing: " : "", group[0].name);
    for (size_t i = 1; i < count; i++) {
        bool named = false;
        for (size_t k = 0; k < i; k++) named = named || strcmp(group[k].name, group[i].name) == 0;
        if (!named && used < size) used += (size_t)snprintf(text + used, size - used, ", %s", group[i].name);
    }
}

size_t regime_intervals(const whirl_table *table, size_t contact_count, regime_interval *intervals, size_t most) {
    size_t count = 0;
    regime_interval now = {0};
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, i);
        char name[sizeof now.name];
        regime_name(&verdict, name, sizeof name);
        if (now.count == 0 || whirl_table_slot(table, i) != whirl_table_slot(table, now.last) + 1 ||
            strcmp(name, now.name) != 0 || table->branch[i] != now.branch) {
            if (now.count > 0 && count++ < most) intervals[count - 1] = now;
            now = (regime_interval){.kind = regime_class_of(&verdict), .first = i, .branch = table->branch[i]};
            memcpy(now.name, name, sizeof name);
        }
        now.last = i;
        now.count++;
        now.rubbing += rub_share(table, i, contact_count) > 0.0;
    }
    if (now.count > 0 && count++ < most) intervals[count - 1] = now;
    return count;
}
