// Why motions of a table are undetermined, and what would tell them.
#include <math.h>

#include "whirl/engine/result.h"

size_t whirl_table_doubts(const whirl_table *table, whirl_doubt doubts[WHIRL_REMEDIES]) {
    size_t count = 0;
    for (size_t remedy = 0; remedy < WHIRL_REMEDIES; remedy++) {
        whirl_doubt found = {.points = 0};
        double *const factor = &found.verdict.advice.factor;
        for (size_t point = 0; point < table->count; point++) {
            if (!whirl_table_done(table, point)) continue;
            const whirl_verdict verdict = whirl_table_verdict(table, point);
            if (verdict.regime != WHIRL_UNDETERMINED || verdict.advice.remedy != remedy) continue;
            if (found.points == 0) found = (whirl_doubt){.first = point, .verdict = verdict};
            found.points++;
            *factor = fmax(*factor, verdict.advice.factor);
        }
        if (found.points > 0) doubts[count++] = found;
    }
    return count;
}
