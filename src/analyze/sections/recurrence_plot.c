// Recurrence quantification: lines of the plot of all pairs of points that are near each other (Marwan, Romano, Thiel,
// Kurths, "Recurrence plots for the analysis of complex systems", Physics Reports 438 (2007) 237, section 3.5). The
// plot itself is never stored: its diagonals and columns are scanned one by one.
#include <math.h>
#include <stdbool.h>

#include "section.h"
#include "signal_check.h"

/// Statistics of the lines along a scan.
typedef struct line_count {
    size_t shortest, now;             ///< least length that counts; length of the present line
    size_t recurring, lined, longest; ///< recurring points; those in lines that count; length of the longest line
} line_count;

static void end_line(line_count *lines) {
    if (lines->now >= lines->shortest) lines->lined += lines->now;
    if (lines->now > lines->longest) lines->longest = lines->now;
    lines->now = 0;
}

static void recurrence_plot_walk(line_count *lines, bool recurs) {
    if (!recurs) {
        end_line(lines);
        return;
    }
    lines->recurring++;
    lines->now++;
}

/// Scans the diagonals above the main one: pieces of the motion that run in parallel. Those below are the same.
static line_count diagonal_lines(const section *points, double radius, size_t shortest) {
    line_count lines = {.shortest = shortest};
    for (size_t apart = 1; apart < points->count; apart++) {
        for (size_t n = 0; n + apart < points->count; n++)
            recurrence_plot_walk(&lines, section_distance(points, n, n + apart) <= radius);
        end_line(&lines);
    }
    return lines;
}

/// Scans the columns: stretches of time over which the motion stays near a point.
static line_count vertical_lines(const section *points, double radius, size_t shortest) {
    line_count lines = {.shortest = shortest};
    for (size_t n = 0; n < points->count; n++) {
        for (size_t m = 0; m < points->count; m++)
            recurrence_plot_walk(&lines, section_distance(points, n, m) <= radius);
        end_line(&lines);
    }
    return lines;
}

whirl_status whirl_signals_recurrence(const double *points, size_t count, size_t dimension, double radius,
                                      size_t shortest, double *rate, double *determinism, double *laminarity,
                                      size_t *longest) {
    if (count > WHIRL_SIGNALS_MAX_RECURRENCES)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu points, expected at most %d to compare with one another",
                          count, WHIRL_SIGNALS_MAX_RECURRENCES);
    const whirl_status status = signal_check_points(points, count, dimension, 2);
    if (status.code != WHIRL_OK) return status;
    if (!(radius >= 0.0)) return whirl_fail(WHIRL_BAD_INPUT, "the radius is %g, expected 0 or more", radius);
    if (shortest < 2) return whirl_fail(WHIRL_BAD_INPUT, "the shortest line is %zu, expected at least 2", shortest);
    const section all = {count, dimension, points};
    const line_count diagonal = diagonal_lines(&all, radius, shortest), column = vertical_lines(&all, radius, shortest);
    const double pairs = 0.5 * (double)count * (double)(count - 1);
    *rate = (double)diagonal.recurring / pairs;
    *determinism = diagonal.recurring > 0 ? (double)diagonal.lined / (double)diagonal.recurring : (double)NAN;
    *laminarity = (double)column.lined / (double)column.recurring;
    *longest = diagonal.longest;
    return whirl_ok();
}
