// Places the movable texts of a figure: each on the first side of its point on which it meets no other text, no legend
// and no edge of the panel.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"

/// Box of a text in its panel: its corners counter-clockwise, cm from the lower left of the panel.
typedef struct text_box {
    double at[4][2];
} text_box;

/// A panel, and the boxes of its legend and texts, which further texts must not overlap.
typedef struct text_room {
    const whirl_figure *figure;
    const whirl_panel *panel;
    double width, height; ///< cm of the panel
    size_t count;         ///< number of boxes
    text_box *boxes;      ///< [count] boxes of placed texts, and of the legend
} text_room;

size_t figure_letters(const char *text) {
    size_t letters = 0;
    for (; *text; text++) letters += ((unsigned char)*text & 0xc0) != 0x80;
    return letters;
}

double figure_text_width(const whirl_figure *figure, size_t letters) {
    return 0.0195 * figure->font * (double)letters;
}

/// Returns the share of the axis below a value; NaN if a logarithmic axis cannot show it.
static double text_share(const whirl_axis *axis, double value) {
    if (axis->logarithmic) return value > 0.0 ? log(value / axis->low) / log(axis->high / axis->low) : (double)NAN;
    return (value - axis->low) / (axis->high - axis->low);
}

/// Returns the height of a letter in cm.
static double text_em(const text_room *room) {
    return 0.9 * room->figure->font * 2.54 / 72.0;
}

/// Returns the box of a text on a side of its point, with the renderers' offsets in letter heights.
static text_box text_box_of(const text_room *room, const whirl_series *series, size_t k, whirl_side side) {
    const double em = text_em(room), turn = acos(-1.0) / 3.0;
    const double wide = 1.06 * figure_text_width(room->figure, figure_letters(series->texts[k]));
    const double x = room->width * text_share(&room->panel->x, series->x[k]);
    const double y = room->height * text_share(&room->panel->y, series->y[k]);
    // Left, right, bottom and top from the point, along the text and across it.
    double box[4] = {-0.5 * wide, 0.5 * wide, 0.1 * em, 1.2 * em};
    if (side != WHIRL_ABOVE && side != WHIRL_BELOW) {
        box[0] = side == WHIRL_LEFT ? -0.5 * em - wide : 0.5 * em;
        box[1] = box[0] + wide;
    }
    if (side == WHIRL_BELOW || side == WHIRL_RIGHT) {
        box[2] = -1.4 * em;
        box[3] = -0.2 * em;
    } else if (side == WHIRL_BESIDE || side == WHIRL_SLANTED) {
        box[2] = -0.6 * em;
        box[3] = 0.6 * em;
    }
    // Its corners, for a slanted text turned by 60 degrees about the point.
    const double c = side == WHIRL_SLANTED ? cos(turn) : 1.0, s = side == WHIRL_SLANTED ? sin(turn) : 0.0;
    text_box at;
    for (int i = 0; i < 4; i++) {
        const double along = box[i == 1 || i == 2], across = box[i < 2 ? 2 : 3];
        at.at[i][0] = x + c * along - s * across;
        at.at[i][1] = y + s * along + c * across;
    }
    return at;
}

/// Returns true if an edge of one box separates it from the other box.
static bool text_edge_parts(const text_box *one, const text_box *other) {
    for (int i = 0; i < 4; i++) {
        const double *from = one->at[i], *to = one->at[(i + 1) % 4];
        bool outside = true;
        for (int k = 0; k < 4 && outside; k++)
            outside =
                (to[0] - from[0]) * (other->at[k][1] - from[1]) <= (to[1] - from[1]) * (other->at[k][0] - from[0]);
        if (outside) return true;
    }
    return false;
}

/// Returns true if two boxes overlap.
static bool text_boxes_meet(const text_box *one, const text_box *other) {
    return !text_edge_parts(one, other) && !text_edge_parts(other, one);
}

/// Finds the position of a point of a series in the panel, cm; returns false if it has none.
static bool text_place_of(const text_room *room, const whirl_series *series, size_t k, double place[2]) {
    place[0] = room->width * text_share(&room->panel->x, series->x[k]);
    place[1] = room->height * text_share(&room->panel->y, series->y[k]);
    return isfinite(place[0]) && isfinite(place[1]);
}

/// Returns true if a mark (larger than the dots of a section) is in a box or within half a letter of it: the text would
/// seem to name that mark. Marks at the text's own point do not count.
static bool text_covers_mark(const text_room *room, const text_box *box, const double own[2]) {
    const double em = text_em(room);
    double at[2];
    for (size_t s = 0; s < room->panel->count; s++) {
        const whirl_series *series = room->panel->series[s];
        for (size_t k = 0; k < series->count && series->shape == WHIRL_DOTS && series->size > 1.5; k++) {
            if (!text_place_of(room, series, k, at) || hypot(at[0] - own[0], at[1] - own[1]) < 0.6 * em) continue;
            const double low[] = {at[0] - 0.6 * em, at[1] - 0.6 * em}, high[] = {at[0] + 0.6 * em, at[1] + 0.6 * em};
            const text_box mark = {{{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}};
            if (text_boxes_meet(box, &mark)) return true;
        }
    }
    return false;
}

/// Returns true if a line crosses a box.
static bool text_covers_line(const text_room *room, const text_box *box) {
    double a[2], b[2];
    for (size_t s = 0; s < room->panel->count; s++) {
        const whirl_series *series = room->panel->series[s];
        for (size_t k = 1; k < series->count && series->shape == WHIRL_LINE; k++) {
            if (!text_place_of(room, series, k - 1, a) || !text_place_of(room, series, k, b)) continue;
            const text_box piece = {{{a[0], a[1]}, {b[0], b[1]}, {a[0], a[1]}, {b[0], b[1]}}};
            if ((a[0] != b[0] || a[1] != b[1]) && text_boxes_meet(&piece, box)) return true;
        }
    }
    return false;
}

/// Returns true if a box is inside the panel and meets no other box.
static bool text_is_free(const text_room *room, const text_box *box) {
    for (int i = 0; i < 4; i++)
        if (!(box->at[i][0] >= 0.0 && box->at[i][0] <= room->width && box->at[i][1] >= 0.0 &&
              box->at[i][1] <= room->height))
            return false;
    for (size_t i = 0; i < room->count; i++)
        if (text_boxes_meet(box, &room->boxes[i])) return false;
    return true;
}

/// Reserves the box of the legend inside a panel, at its upper right.
static void text_keep_legend(text_room *room) {
    const whirl_figure *figure = room->figure;
    double wide = 0.0, longest = 0.0;
    for (size_t s = 0; s < room->panel->count; s++) {
        if (!*room->panel->series[s]->name) continue;
        const double own = 0.65 + figure_text_width(figure, figure_letters(room->panel->series[s]->name));
        wide += own;
        longest = fmax(longest, own);
    }
    if (!room->panel->keyed || wide == 0.0) return;
    const double across = fmin(wide, fmax(longest, room->width));
    const double low = room->height - 0.046 * figure->font * ceil(wide / across), left = room->width - across;
    room->boxes[room->count++] =
        (text_box){{{left, low}, {room->width, low}, {room->width, room->height}, {left, room->height}}};
}

/// Finds a free side for a text, trying the side of its series first: a side on which it covers neither lines nor
/// marks, else one on which it covers only lines, else any.
static bool text_find_side(text_room *room, const whirl_series *series, size_t k, whirl_side *found) {
    static const whirl_side others[] = {WHIRL_ABOVE, WHIRL_BELOW, WHIRL_RIGHT, WHIRL_LEFT, WHIRL_BESIDE, WHIRL_SLANTED};
    enum { OTHERS = sizeof others / sizeof *others };
    double own[2];
    if (!text_place_of(room, series, k, own)) return false;
    for (int covered = 0; covered < 3; covered++)
        for (int i = -1; i < OTHERS; i++) {
            const whirl_side side = i < 0 ? series->side : others[i];
            const text_box box = text_box_of(room, series, k, side);
            if (!text_is_free(room, &box) || (covered < 2 && text_covers_mark(room, &box, own)) ||
                (covered < 1 && text_covers_line(room, &box)))
                continue;
            room->boxes[room->count++] = box;
            *found = side;
            return true;
        }
    return false;
}

/// Places the texts of a movable series. Texts that need another side move to a series for that side; texts without a
/// free side are left out.
static void text_place_series(whirl_figure *figure, whirl_panel *panel, text_room *room, whirl_series *series) {
    whirl_series *moved[WHIRL_BESIDE + 1] = {[0] = NULL};
    size_t kept = 0;
    for (size_t k = 0; k < series->count; k++) {
        whirl_side side;
        char *text = series->texts[k];
        if (text_find_side(room, series, k, &side)) {
            if (side == series->side) {
                series->x[kept] = series->x[k];
                series->y[kept] = series->y[k];
                series->texts[kept++] = text;
                continue;
            }
            if (!moved[side]) moved[side] = panel_series(figure, panel, WHIRL_TEXTS, series->colour, series->size);
            if (moved[side]) moved[side]->side = side;
            series_add_text(figure, moved[side], series->x[k], series->y[k], text);
        }
        free(text);
    }
    series->count = kept;
}

void figure_place_texts(whirl_figure *figure, whirl_panel *panel) {
    // Count the texts; do nothing if none is movable.
    size_t texts = 0;
    bool any = false;
    for (size_t s = 0; s < panel->count; s++) {
        if (panel->series[s]->shape != WHIRL_TEXTS) continue;
        texts += panel->series[s]->count;
        any = any || panel->series[s]->movable;
    }
    if (!any) return;
    text_room room = {.figure = figure,
                      .panel = panel,
                      .width = (panel->right - panel->left) * figure->width,
                      .height = (panel->top - panel->bottom) * figure->height,
                      .boxes = malloc((texts + 1) * sizeof *room.boxes)};
    figure->failed = figure->failed || !room.boxes;
    if (!room.boxes) return;
    // Reserve the boxes of the legend and of all other texts.
    text_keep_legend(&room);
    const size_t count = panel->count; // text_place_series adds series after these
    for (size_t s = 0; s < count; s++) {
        const whirl_series *series = panel->series[s];
        for (size_t k = 0; k < series->count && series->shape == WHIRL_TEXTS && !series->movable; k++) {
            const text_box box = text_box_of(&room, series, k, series->side);
            if (isfinite(box.at[0][0]) && isfinite(box.at[0][1])) room.boxes[room.count++] = box;
        }
    }
    // Place the movable texts.
    for (size_t s = 0; s < count; s++)
        if (panel->series[s]->movable) text_place_series(figure, panel, &room, panel->series[s]);
    free(room.boxes);
}
