// Why motions of a table are undetermined, and what would tell them.
#include <math.h>

#include "whirl/result.h"

size_t whirl_table_doubts(const whirl_table *table, whirl_doubt doubts[WHIRL_REMEDIES]) {
    size_t count = 0;
    for (size_t remedy = 0; remedy < WHIRL_REMEDIES; remedy++) {
        whirl_doubt found = {.remedy = (whirl_remedy)remedy};
        for (size_t point = 0; point < table->count; point++) {
            if (!whirl_table_done(table, point)) continue;
            const whirl_verdict verdict = whirl_table_verdict(table, point);
            if (verdict.regime != WHIRL_UNDETERMINED || verdict.advice.remedy != found.remedy) continue;
            if (found.points++ == 0) found.first = point;
            found.factor = fmax(found.factor, verdict.advice.factor);
        }
        if (found.points > 0) doubts[count++] = found;
    }
    return count;
}
