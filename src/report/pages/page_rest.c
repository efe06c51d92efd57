// Critical speeds and thresholds of stability, as a table.
#include <math.h>

#include "html.h"
#include "page.h"
#include "quantities.h"

static size_t count_critical(const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t count = 0;
    for (size_t point = 0; field && point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++)
            count += isfinite(row[i * field->columns]);
    }
    return count;
}

/// Whether frequencies are known but for multiples of the speed, at any point.
static bool is_modulated(const whirl_table *table) {
    for (size_t point = 0; point < table->count; point++) {
        const double *modulo = whirl_table_field(table, point, WHIRL_FIELD_MODES_MODULO, 0);
        if (modulo && whirl_table_done(table, point) && isfinite(*modulo)) return true;
    }
    return false;
}

static void write_row(FILE *stream, const double *row, double unit) {
    static const char *const kinds[] = {"", "critical speed", "instability begins", "instability ends"};
    fprintf(stream,
            "<tr><th>%s</th><td class=\"number\">%.9g</td><td class=\"number\">%.6g</td><td class=\"number\">%.6g</td>"
            "<td class=\"number\">%.4g</td><td>%s</td></tr>\n",
            kinds[(int)row[0]], row[1] / unit, row[2] * 60.0 / 6.283185307179586, row[3] / 6.283185307179586, row[4],
            row[5] > 0.05    ? "forward"
            : row[5] < -0.05 ? "backward"
                             : "to and fro");
}

void page_critical(const page *to, size_t index) {
    const whirl_table *table = whirl_result_table(to->results[index], "modes");
    char label[UNIT_LABEL_SIZE];
    if (!table || !*table->parameter) return;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    fprintf(to->stream, "<h3 id=\"critical-%zu\">Critical speeds and stability</h3>\n", index + 1);
    if (is_modulated(table))
        fputs("<p>Coefficients turn with the shaft: frequencies are known but for multiples of its speed, and critical "
              "speeds are not told.</p>\n",
              to->stream);
    if (!field || count_critical(table) == 0) {
        fputs(
            is_modulated(table)
                ? "<p>Between the values that were looked at the machine neither loses nor regains its stability.</p>\n"
                : "<p>Between the values that were looked at no natural frequency meets the speed of the shaft, and "
                  "the machine neither loses nor regains its stability.</p>\n",
            to->stream);
        return;
    }
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    html_table(to->stream, "Critical speeds and thresholds of stability", "");
    fputs("<thead><tr><th>What</th><th class=\"number\">", to->stream);
    html_text(to->stream, label);
    fputs("</th><th class=\"number\">speed (rpm)</th><th class=\"number\">frequency (Hz)</th>"
          "<th class=\"number\">damping ratio</th><th>whirl</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (row[0] >= 1.0 && row[0] <= 3.0)
                write_row(to->stream, row, whirl_shown_parameter(&to->units[index], table->parameter).size);
    }
    fputs("</tbody></table></div>\n", to->stream);
}
