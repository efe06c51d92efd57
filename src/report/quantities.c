#include "quantities.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

numbers point_numbers(const whirl_table *table, size_t point, const char *field, size_t which) {
    const whirl_field *shape = whirl_layout_field(&table->layout, field);
    const double *at = whirl_table_field(table, point, field, which);
    if (!shape || !at || shape->rows == 0 || isnan(at[0])) return (numbers){0};
    return (numbers){at, shape->rows, shape->columns};
}

/// Returns the array if it has `columns` columns, without trailing rows of NaN.
static numbers array_of(const whirl_table *table, size_t point, const char *field, size_t which, size_t columns) {
    numbers found = point_numbers(table, point, field, which);
    if (found.columns != columns) return (numbers){0};
    while (found.rows > 0 && isnan(found.at[(found.rows - 1) * columns])) found.rows--;
    return found;
}

numbers point_section(const whirl_table *table, size_t point, size_t station) {
    return array_of(table, point, WHIRL_FIELD_POINCARE_SECTION, station, 4);
}

numbers point_waveform(const whirl_table *table, size_t point, size_t station) {
    return array_of(table, point, WHIRL_FIELD_WAVEFORM_SAMPLES, station, 2);
}

numbers point_spectrum(const whirl_table *table, size_t point, size_t station) {
    return array_of(table, point, WHIRL_FIELD_SPECTRUM_AMPLITUDE, station, 5);
}

double line_share(const whirl_table *table, size_t point, size_t station) {
    return whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_SHARE, station);
}

numbers point_lines(const whirl_table *table, size_t point, size_t station) {
    return array_of(table, point, WHIRL_FIELD_SPECTRUM_LINES, station, 5);
}

double point_number(const whirl_table *table, size_t point, const char *field) {
    return whirl_table_number(table, point, field, 0);
}

whirl_estimate point_exponent(const whirl_table *table, size_t point) {
    const double value = whirl_table_number(table, point, WHIRL_FIELD_LYAPUNOV_LARGEST, 0);
    if (isnan(value)) return whirl_table_verdict(table, point).exponent;
    return (whirl_estimate){value, whirl_table_number(table, point, WHIRL_FIELD_LYAPUNOV_ERROR, 0)};
}

shown_estimate estimate_shown(whirl_estimate estimate) {
    static const double least = 1e-4;
    shown_estimate shown = {estimate.value, estimate.error, 4};
    if (!isfinite(estimate.value) || !isfinite(estimate.error)) return shown;
    const double error = fmax(estimate.error, least);
    // Keep two digits of the error: one decimal more than its power of ten (0.0123: 0.012). The factor 0.995 is for
    // 0.00996, which rounds to 0.010.
    const int power = (int)floor(log10(error / 0.995));
    shown.decimals = power < -3 ? 4 : power > 1 ? 0 : 1 - power;
    const double unit = pow(10.0, -shown.decimals);
    shown.error = fmax(round(error / unit), 1.0) * unit;
    shown.value = round(estimate.value / unit) * unit + 0.0; // + 0.0: no zero with a sign
    return shown;
}

void plus_minus(char *text) {
    static const char sign[] = "\u00b1"; // two bytes, too
    for (char *at = strstr(text, "+-"); at; at = strstr(at, "+-")) {
        at[0] = sign[0];
        at[1] = sign[1];
    }
}

void reason_text(const whirl_verdict *verdict, char *text, size_t size) {
    whirl_verdict copy = *verdict;
    const shown_estimate exponent = estimate_shown(verdict->exponent);
    copy.exponent = (whirl_estimate){exponent.value, exponent.error};
    whirl_verdict_reason(&copy, text, size);
}

double max_radius(const whirl_table *table, size_t point, size_t station) {
    return whirl_table_number(table, point, WHIRL_FIELD_ORBIT_MAX_RADIUS, station);
}

double backward_share(const whirl_table *table, size_t point, size_t station) {
    return whirl_table_number(table, point, WHIRL_FIELD_ORBIT_BACKWARD, station);
}

double rub_share(const whirl_table *table, size_t point, size_t contact_count) {
    double most = (double)NAN;
    for (size_t i = 0; i < contact_count; i++)
        most = fmax(most, whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, i));
    return most;
}

bool has_rub(const whirl_table *table, size_t contact_count) {
    return contact_count > 0 && whirl_layout_field(&table->layout, WHIRL_FIELD_RUB_SHARE) != NULL;
}

bool motion_lost(const whirl_table *table, size_t point) {
    const double *block = whirl_table_done(table, point) ? whirl_table_block(table, point) : NULL;
    if (!block) return false;
    for (size_t i = 0; i < table->layout.size; i++)
        if (!isnan(block[i])) return false;
    return table->layout.size > 0;
}

size_t motions_lost(const whirl_table *table, size_t *first) {
    size_t count = 0;
    *first = table->count;
    for (size_t point = 0; point < table->count; point++)
        if (motion_lost(table, point) && count++ == 0) *first = point;
    return count;
}

const whirl_table *detail_table(const whirl_result *result) {
    const whirl_table *detail = whirl_result_role(result, WHIRL_ROLE_DETAIL);
    return detail ? detail : whirl_result_role(result, WHIRL_ROLE_POINT);
}
