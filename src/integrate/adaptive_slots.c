// Assigns lanes to slots.
#include "adaptive_lanes.h"

/// Copies a lane into a slot, or back.
static void exchange(const adaptive_lanes *lanes, size_t slot, size_t lane, bool back) {
    for (size_t i = 0; i < lanes->exchanged_count; i++) {
        const lane_rows *rows = &lanes->exchanged[i];
        if (back && rows->constant) continue;
        if (rows->observed && lanes->watched[slot] < 0.5) continue;
        for (size_t r = 0; r < rows->rows; r++) {
            double *own = &rows->own[r * lanes->slots + slot], *theirs = &rows->theirs[r * lanes->lane_count + lane];
            if (back)
                *theirs = *own;
            else
                *own = *theirs;
        }
    }
}

static void leave(const adaptive_lanes *lanes, size_t slot) {
    size_t *lane = &lanes->queue->slot_lane[slot];
    if (*lane == NO_LANE) return;
    exchange(lanes, slot, *lane, true);
    *lane = NO_LANE;
}

/// Gives a free slot to the next lane that has a machine and has not ended. Returns false if no lane waits.
static bool enter(const adaptive_lanes *lanes, size_t slot) {
    lane_queue *queue = lanes->queue;
    while (queue->next < queue->count) {
        const size_t place = queue->next++, lane = queue->order[place];
        if (!lanes->machines[lane]) continue;
        lanes->watched[slot] = place < queue->observed ? 1.0 : 0.0;
        exchange(lanes, slot, lane, false);
        if (lanes->ended[slot] != WHIRL_BOUNDED) continue;
        queue->slot_lane[slot] = lane;
        lanes->from[slot] = lanes->parts ? lanes->parts[2 * lane] : 0.0;
        lanes->until[slot] = lanes->parts ? lanes->parts[2 * lane + 1] : lanes->period;
        lanes->starting[slot] = 1.0;
        return true;
    }
    return false;
}

bool adaptive_fill(const adaptive_lanes *lanes) {
    bool any = false;
    for (size_t slot = 0; slot < lanes->slots; slot++) {
        if (lanes->running[slot] > 0.5) continue;
        leave(lanes, slot);
        if (enter(lanes, slot)) any = true;
    }
    return any;
}
