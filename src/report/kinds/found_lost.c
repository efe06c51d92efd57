// Finding on motions that ended before their last revolution, for tables without the analysis regime, whose verdicts
// show them.
#include "quantities.h"
#include "shown_kinds.h"

void find_lost(const finder *of) {
    size_t first, done = 0;
    const size_t lost = whirl_layout_has_verdict(&of->table->layout) ? 0 : motions_lost(of->table, &first);
    if (lost == 0) return;
    for (size_t point = 0; point < of->table->count; point++) done += whirl_table_done(of->table, point);
    whirl_phrase *found = &find_statement(of, "ended early")->found;
    phrase_text(of, found, "%zu of %zu motion%s", lost, done, done == 1 ? "" : "s");
    if (*of->table->parameter) {
        phrase_text(of, found, ", first at ");
        phrase_value(of, found, 6, of->table->values[first]);
    }
    phrase_text(
        of, found,
        ": a station came to the wall of a film or seal, a coordinate beyond the limit, or the solver could not "
        "go on (analyze: regime says which); numbers are missing there");
}
