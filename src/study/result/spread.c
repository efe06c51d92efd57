// Statistics of a number over the samples of a study of tolerances.
#include "whirl/engine/spread.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "spread_usual.h"
#include "two_pi.h"

const double whirl_quantiles[WHIRL_QUANTILES] = {0.05, 0.25, 0.5, 0.75, 0.95};

// ---------------------------------------------------------------- numbers

void whirl_spread_text(const whirl_spread_of *of, char text[WHIRL_SPREAD_TEXT]) {
    snprintf(text, WHIRL_SPREAD_TEXT, "%.40s%s%.40s row %zu above %.17g below %.17g%s%.63s", of->field,
             *of->column ? " column " : "", of->column, of->row + 1, of->above, of->below, *of->at ? " at " : "",
             of->at);
}

/// Takes a word of at most `size` - 1 letters off a text, after blanks; false if there is none.
static bool take_word(const char **text, char *word, size_t size) {
    const char *at = *text + strspn(*text, " ");
    const size_t length = strcspn(at, " ");
    if (length == 0 || length >= size) return false;
    memcpy(word, at, length);
    word[length] = '\0';
    *text = at + length;
    return true;
}

/// Takes the number behind a key; false if there is none.
static bool take_number(const char **text, double *value) {
    char word[WHIRL_NAME_SIZE], *end;
    if (!take_word(text, word, sizeof word)) return false;
    *value = strtod(word, &end);
    return !*end && !isnan(*value);
}

bool whirl_spread_read(const char *text, whirl_spread_of *of) {
    char key[WHIRL_NAME_SIZE];
    double row = 1.0;
    *of = (whirl_spread_of){.above = -INFINITY, .below = INFINITY};
    bool good = take_word(&text, of->field, sizeof of->field);
    while (good && take_word(&text, key, sizeof key)) {
        const char *rest = text + strspn(text, " ");
        if (strcmp(key, "at") == 0) { // the rest of the text: contacts have names with blanks
            good = *rest && strlen(rest) < sizeof of->at;
            if (good) snprintf(of->at, sizeof of->at, "%s", rest);
            break;
        }
        good = strcmp(key, "column") == 0  ? take_word(&text, of->column, sizeof of->column)
               : strcmp(key, "row") == 0   ? take_number(&text, &row)
               : strcmp(key, "above") == 0 ? take_number(&text, &of->above)
               : strcmp(key, "below") == 0 ? take_number(&text, &of->below)
                                           : false;
    }
    good = good && row >= 1.0 && row <= 1e9 && row == floor(row) && of->above < of->below;
    of->row = good ? (size_t)row - 1 : 0;
    return good;
}

const char *whirl_spread_find(const whirl_spread_of *of, const whirl_layout *layout, const char *const *stations,
                              size_t station_count, const char *const *contacts, size_t contact_count,
                              whirl_spread_at *at) {
    const whirl_field *field = whirl_layout_field(layout, of->field);
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    *at = (whirl_spread_at){.field = field};
    if (!field) return "has a field that these points do not have";
    // Find the station or contact.
    const bool contact = field->extent == WHIRL_PER_CONTACT;
    const char *const *owners = contact ? contacts : stations;
    const size_t count = field->extent == WHIRL_PER_POINT ? 0 : contact ? contact_count : station_count;
    if (*of->at && count == 0) return "has `at`, and the field is of no station or contact";
    if (!*of->at && count > 1) return "lacks `at`, the station or contact of the number";
    while (*of->at && at->which < count && strcmp(owners[at->which], of->at) != 0) at->which++;
    if (*of->at && (at->which == count || at->which >= field->repeat))
        return contact ? "has `at`, which names no contact" : "has `at`, which names no station";
    // Find the row and the column.
    if (of->row >= field->rows) return "has a row that the field does not have";
    size_t column = 0;
    const bool named = whirl_field_column_names(field, names);
    while (*of->column && named && column < field->columns && strcmp(names[column], of->column) != 0) column++;
    if (*of->column && (!named || column == field->columns)) return "has a column that the field does not have";
    at->index = of->row * field->columns + column;
    return NULL;
}

double whirl_spread_number(const whirl_result *result, const whirl_table *table, size_t point,
                           const whirl_spread_at *at) {
    const double *numbers = whirl_table_field(table, point, at->field->name, at->which);
    const char *unit = whirl_column_unit(at->field, at->index % at->field->columns);
    if (!numbers) return (double)NAN;
    const double size = strcmp(unit, "length") == 0  ? whirl_result_length_scale(result, table, point)
                        : strcmp(unit, "force") == 0 ? result->force_scale
                                                     : 1.0;
    return numbers[at->index] * size;
}

double whirl_spread_period(const whirl_spread_at *at) {
    if (strcmp(whirl_column_unit(at->field, at->index % at->field->columns), "deg") != 0) return 0.0;
    return strcmp(at->field->name, WHIRL_FIELD_UNBALANCE_INCLINATION) == 0 ? 180.0 : 360.0;
}

// ---------------------------------------------------------------- samples

/// Numbers of all machines: numbers[j * each + m] is that of machine m of sample j. NaN: none, infinite: not done.
typedef struct drawn {
    size_t samples, each;
    double *numbers;
} drawn;

/// Sums over the samples of one replicate, and of all. A and B are the first two machines of a sample. Their numbers
/// are a and b; a_i is the number of A with parameter i of B.
typedef struct sums {
    double count, first, second;              ///< values of A and B: their number, sum and sum of squares
    double pairs[WHIRL_MAX_TOLERANCES];       ///< number of samples with a, b and a_i
    double products[WHIRL_MAX_TOLERANCES];    ///< sums of b (a_i - a)
    double differences[WHIRL_MAX_TOLERANCES]; ///< sums of (a - a_i)^2
} sums;

typedef struct replicates {
    sums of[WHIRL_REPLICATES], all;
} replicates;

/// The estimates that follow from sums.
typedef struct estimates {
    double mean, variance, deviation;
    double first[WHIRL_MAX_TOLERANCES], total[WHIRL_MAX_TOLERANCES];
} estimates;

static void sums_add(sums *to, const sums *from, size_t parameters) {
    to->count += from->count;
    to->first += from->first;
    to->second += from->second;
    for (size_t i = 0; i < parameters; i++) {
        to->pairs[i] += from->pairs[i];
        to->products[i] += from->products[i];
        to->differences[i] += from->differences[i];
    }
}

/// Computes the estimates from sums: indices of first order after Saltelli et al. 2010, total ones after Jansen 1999.
static estimates estimate(const sums *of, double origin, size_t parameters) {
    const double mean = of->first / of->count, variance = of->second / of->count - mean * mean;
    estimates e = {.mean = origin + mean, .variance = fmax(variance, 0.0), .deviation = sqrt(fmax(variance, 0.0))};
    for (size_t i = 0; i < parameters; i++) {
        const double part = of->pairs[i] > 0.0 && variance > 0.0 ? 1.0 / (of->pairs[i] * variance) : (double)NAN;
        e.first[i] = of->products[i] * part;
        e.total[i] = 0.5 * of->differences[i] * part;
    }
    return e;
}

static bool spread_is_number(double x) {
    return isfinite(x);
}

/// Adds a sample to the sums of its replicate, with numbers less `origin`.
static void add_sample(const double *numbers, size_t each, double origin, sums *to) {
    const double a = numbers[0] - origin, b = each > 1 ? numbers[1] - origin : (double)NAN;
    for (size_t m = 0; m < each && m < 2; m++) {
        const double x = numbers[m] - origin;
        if (!spread_is_number(x)) continue;
        to->count += 1.0;
        to->first += x;
        to->second += x * x;
    }
    for (size_t i = 0; i + 2 < each; i++) {
        const double mixed = numbers[2 + i] - origin;
        if (!spread_is_number(a) || !spread_is_number(b) || !spread_is_number(mixed)) continue;
        to->pairs[i] += 1.0;
        to->products[i] += b * (mixed - a);
        to->differences[i] += (a - mixed) * (a - mixed);
    }
}

static double middle_of(const drawn *of) {
    double sum = 0.0, count = 0.0;
    for (size_t j = 0; j < of->samples; j++)
        for (size_t m = 0; m < of->each && m < 2; m++)
            if (spread_is_number(of->numbers[j * of->each + m])) sum += of->numbers[j * of->each + m], count += 1.0;
    return count > 0.0 ? sum / count : 0.0;
}

static replicates sum_up(const drawn *of, double origin) {
    replicates r = {.all = {.count = 0.0}};
    for (size_t j = 0; j < of->samples; j++)
        add_sample(of->numbers + j * of->each, of->each, origin, &r.of[j % WHIRL_REPLICATES]);
    for (size_t i = 0; i < WHIRL_REPLICATES; i++) sums_add(&r.all, &r.of[i], of->each > 2 ? of->each - 2 : 0);
    return r;
}

/// Returns the standard error of an estimate from the estimates without one replicate each (jackknife over groups:
/// Quenouille 1956, Tukey 1958). NaN if one is missing.
static double jackknife(const double without[WHIRL_REPLICATES]) {
    const double n = WHIRL_REPLICATES;
    double mean = 0.0, sum = 0.0;
    for (size_t r = 0; r < WHIRL_REPLICATES; r++) mean += without[r] / n;
    for (size_t r = 0; r < WHIRL_REPLICATES; r++) sum += (without[r] - mean) * (without[r] - mean);
    return sqrt((n - 1.0) / n * sum);
}

/// Fills in mean, variance, deviation and indices, with their errors.
static void spread_estimate(const drawn *of, whirl_spread *s) {
    // Estimate from all replicates.
    const size_t parameters = of->each > 2 ? of->each - 2 : 0;
    const double origin = middle_of(of);
    const replicates r = sum_up(of, origin);
    const estimates whole = estimate(&r.all, origin, parameters);
    // Estimate without each replicate.
    estimates without[WHIRL_REPLICATES];
    for (size_t i = 0; i < WHIRL_REPLICATES; i++) {
        sums rest = {.count = 0.0};
        for (size_t k = 0; k < WHIRL_REPLICATES; k++)
            if (k != i) sums_add(&rest, &r.of[k], parameters);
        without[i] = estimate(&rest, origin, parameters);
    }
    // The spread of these gives the error of each number (jackknife).
    double left[WHIRL_REPLICATES];
#define ESTIMATE(to, member)                                                                                           \
    do {                                                                                                               \
        for (size_t r_ = 0; r_ < WHIRL_REPLICATES; r_++) left[r_] = without[r_].member;                                \
        (to) = (whirl_estimate){whole.member, jackknife(left)};                                                        \
    } while (0)
    ESTIMATE(s->mean, mean);
    ESTIMATE(s->variance, variance);
    ESTIMATE(s->deviation, deviation);
    s->index_count = parameters;
    for (size_t i = 0; i < parameters; i++) {
        ESTIMATE(s->indices[i].first, first[i]);
        ESTIMATE(s->indices[i].total, total[i]);
    }
#undef ESTIMATE
}

// ---------------------------------------------------------------- quantiles

/// A number of a sample with its replicate.
typedef struct ranked {
    double number;
    size_t replicate;
} ranked;

static int spread_by_number(const void *a, const void *b) {
    const ranked *x = a, *y = b;
    return (x->number > y->number) - (x->number < y->number);
}

/// Returns the quantile of sorted numbers, without those of a replicate (WHIRL_REPLICATES: of all), with lines between
/// neighbours (definition 7 of Hyndman, Fan 1996).
static double quantile_of(const ranked *sorted, size_t count, double share, size_t without) {
    size_t left = 0, seen = 0;
    for (size_t i = 0; i < count; i++) left += sorted[i].replicate != without;
    if (left == 0) return (double)NAN;
    const double at = share * (double)(left - 1), part = at - floor(at);
    const size_t low = (size_t)at;
    double below = NAN;
    for (size_t i = 0; i < count; i++) {
        if (sorted[i].replicate == without) continue;
        if (seen == low) below = sorted[i].number;
        if (seen == low && (part == 0.0 || low + 1 == left)) return below;
        if (seen == low + 1) return below + part * (sorted[i].number - below);
        seen++;
    }
    return below;
}

static whirl_status spread_quantiles(const drawn *of, whirl_spread *s) {
    ranked *sorted = malloc((2 * of->samples + 1) * sizeof *sorted);
    size_t count = 0;
    if (!sorted) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the quantiles of %zu samples", of->samples);
    for (size_t j = 0; j < of->samples; j++)
        for (size_t m = 0; m < of->each && m < 2; m++) {
            const double x = of->numbers[j * of->each + m];
            if (spread_is_number(x)) sorted[count++] = (ranked){x, j % WHIRL_REPLICATES};
        }
    qsort(sorted, count, sizeof *sorted, spread_by_number);
    s->least = count > 0 ? sorted[0].number : (double)NAN;
    s->most = count > 0 ? sorted[count - 1].number : (double)NAN;
    for (size_t q = 0; q < WHIRL_QUANTILES; q++) {
        double left[WHIRL_REPLICATES];
        for (size_t r = 0; r < WHIRL_REPLICATES; r++) left[r] = quantile_of(sorted, count, whirl_quantiles[q], r);
        s->quantiles[q].value = quantile_of(sorted, count, whirl_quantiles[q], WHIRL_REPLICATES);
        s->quantiles[q].error = jackknife(left);
    }
    free(sorted);
    return whirl_ok();
}

// ---------------------------------------------------------------- probabilities

/// Returns one end of the interval after Wilson (1927) for `hits` of `count`: the lower end for side -1, the upper end
/// for side 1.
static double wilson(double hits, double count, double side) {
    const double z = 1.959963984540054, square = z * z, share = hits / count;
    const double centre = share + 0.5 * square / count;
    const double half = z * sqrt(share * (1.0 - share) / count + 0.25 * square / (count * count));
    return fmin(fmax((centre + side * half) / (1.0 + square / count), 0.0), 1.0);
}

/// Makes a probability of the statistics of a number that is 0 or 1.
static void spread_chance(const whirl_spread *of, double count, double failed, whirl_probability *to) {
    const double all = count + failed, hits = of->mean.value * count;
    to->of = of->mean;
    to->from = all > 0.0 ? wilson(count > 0.0 ? hits : 0.0, all, -1.0) : (double)NAN;
    to->to = all > 0.0 ? wilson((count > 0.0 ? hits : 0.0) + failed, all, 1.0) : (double)NAN;
}

/// Counts the samples that are done and those of them without a number (in `s`), and the numbers that exist or are
/// missing.
static void spread_count(const drawn *of, whirl_spread *s, double *count, double *failed) {
    *count = *failed = 0.0;
    for (size_t j = 0; j < of->samples; j++) {
        const double *own = of->numbers + j * of->each;
        bool done = true, lacks = false;
        for (size_t m = 0; m < of->each; m++) done = done && !isinf(own[m]), lacks = lacks || isnan(own[m]);
        s->samples += done;
        s->failed += done && lacks;
        for (size_t m = 0; m < of->each && m < 2; m++) {
            *count += isfinite(own[m]);
            *failed += isnan(own[m]);
        }
    }
}

/// Cuts angles opposite to their circular mean (Fisher 1993): moves them by whole periods next to it. Angles without a
/// mean become missing.
static void spread_cut(const drawn *of, double period) {
    const double unit = two_pi / period, least_length = 0.2, lowest = -0.125 * period;
    double x = 0.0, y = 0.0, count = 0.0;
    for (size_t j = 0; j < of->samples; j++)
        for (size_t m = 0; m < of->each && m < 2; m++) {
            const double angle = of->numbers[j * of->each + m] * unit;
            if (!spread_is_number(angle)) continue;
            x += cos(angle), y += sin(angle), count += 1.0;
        }
    const bool known = hypot(x, y) >= least_length * count;
    double mean = atan2(y, x) / unit;
    if (mean < lowest) mean += period;
    for (size_t i = 0; i < of->samples * of->each; i++) {
        double *angle = &of->numbers[i];
        if (spread_is_number(*angle)) *angle = known ? mean + remainder(*angle - mean, period) : (double)NAN;
    }
}

/// Fills in moments, indices and quantiles. Those of an angle with that period (0: none) are about its circular mean.
static whirl_status spread_describe(const drawn *of, double period, whirl_spread *s) {
    drawn cut = *of;
    double *angles = NULL;
    if (period > 0.0) {
        angles = malloc((of->samples * of->each + 1) * sizeof *angles);
        if (!angles) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu angles", of->samples);
        memcpy(angles, of->numbers, of->samples * of->each * sizeof *angles);
        cut.numbers = angles;
        spread_cut(&cut, period);
    }
    spread_estimate(&cut, s);
    const whirl_status status = spread_quantiles(&cut, s);
    free(angles);
    return status;
}

static whirl_status spread_of_drawn(const drawn *of, const whirl_spread_of *limits, double period, whirl_spread *s) {
    double count, failed;
    spread_count(of, s, &count, &failed);
    const whirl_status status = spread_describe(of, period, s);
    s->beyond = (whirl_probability){{NAN, NAN}, NAN, NAN};
    if (status.code != WHIRL_OK || !limits || (isinf(limits->above) && isinf(limits->below))) return status;
    for (size_t i = 0; i < of->samples * of->each; i++) {
        double *x = &of->numbers[i];
        if (isfinite(*x)) *x = !(*x > limits->above && *x < limits->below);
    }
    whirl_spread chance = {.samples = 0};
    spread_estimate(of, &chance);
    spread_chance(&chance, count, failed, &s->beyond);
    memcpy(s->beyond_of, chance.indices, sizeof s->beyond_of);
    return status;
}

// ---------------------------------------------------------------- of a table

/// Selects what is read from each point: a number, or 1 and 0 for an event (`chance`).
typedef struct wanted {
    const whirl_result *result;
    const whirl_table *table;
    const whirl_spread_at *at; ///< NULL: an event
    whirl_chance chance;
    const whirl_verdict *verdict;
    bool least;    ///< the least of all values is the worst
    double period; ///< period of an angle; 0: of no angle
} wanted;

static double wanted_number(const wanted *of, size_t point) {
    if (of->at) return whirl_spread_number(of->result, of->table, point, of->at);
    if (of->chance == WHIRL_CHANCE_VERDICT) {
        const whirl_verdict own = whirl_table_verdict(of->table, point);
        if (own.regime == WHIRL_UNDETERMINED || own.regime == WHIRL_NOT_JUDGED) return (double)NAN;
        return own.regime == of->verdict->regime && (own.regime != WHIRL_PERIODIC || own.period == of->verdict->period);
    }
    const whirl_field *field = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUB_SHARE);
    double touches = field ? 0.0 : (double)NAN;
    for (size_t i = 0; field && i < field->repeat; i++) {
        const double share = whirl_table_number(of->table, point, field->name, i);
        touches = isnan(share) ? share : fmax(touches, share > 0.0);
        if (isnan(share)) break;
    }
    return touches;
}

/// Returns the points by their slots [planned], table->count for those that are missing; NULL without memory.
static size_t *points_by_slot(const whirl_table *table, size_t planned) {
    size_t *points = malloc((planned + 1) * sizeof *points);
    for (size_t i = 0; points && i < planned; i++) points[i] = table->count;
    for (size_t i = 0; points && i < table->count; i++)
        if (whirl_table_done(table, i) && whirl_table_slot(table, i) < planned) points[whirl_table_slot(table, i)] = i;
    return points;
}

/// Returns the number of a machine: of its point at a place, or the worst of all its points.
static double spread_draw(const wanted *of, const size_t *points, size_t places, size_t machine, size_t place) {
    const bool all = place == WHIRL_ANYWHERE;
    double worst = NAN;
    for (size_t k = all ? 0 : place; k < (all ? places : place + 1); k++) {
        const size_t point = points[machine * places + k];
        if (point == of->table->count) return (double)INFINITY; // not done
        const double own = wanted_number(of, point);
        if (isnan(own)) return own;
        worst = isnan(worst) ? own : of->least ? fmin(worst, own) : fmax(worst, own);
    }
    return isinf(worst) ? (double)NAN : worst;
}

/// Makes all statistics missing except the probability to be beyond limits: of several angles none is the worst.
static void spread_forget(whirl_spread *s) {
    const whirl_estimate none = {NAN, NAN};
    s->least = s->most = (double)NAN;
    s->mean = s->variance = s->deviation = none;
    for (size_t q = 0; q < WHIRL_QUANTILES; q++) s->quantiles[q] = none;
    for (size_t i = 0; i < s->index_count; i++) s->indices[i] = (whirl_index){none, none};
}

static whirl_status spread_table(const wanted *of, const whirl_spread_of *limits, size_t place, size_t samples,
                                 whirl_spread *spread) {
    const whirl_table *table = of->table;
    const size_t places = whirl_table_places(table), planned = whirl_table_planned(table);
    const size_t all = (size_t)table->tolerances.samples;
    drawn own = {.samples = samples == 0 || samples > all ? all : samples,
                 .each = whirl_tolerance_each(&table->tolerances)};
    *spread = (whirl_spread){.samples = 0};
    if (all == 0 || (place != WHIRL_ANYWHERE && place >= places))
        return whirl_fail(WHIRL_BAD_INPUT, "the table %.60s has no samples there", table->name);
    size_t *points = points_by_slot(table, planned);
    own.numbers = malloc((own.samples * own.each + 1) * sizeof *own.numbers);
    whirl_status status = points && own.numbers
                              ? whirl_ok()
                              : whirl_fail(WHIRL_NO_MEMORY, "no memory for the numbers of %zu samples", own.samples);
    for (size_t m = 0; status.code == WHIRL_OK && m < own.samples * own.each; m++)
        own.numbers[m] = (m + 1) * places <= planned ? spread_draw(of, points, places, m, place) : (double)INFINITY;
    if (status.code == WHIRL_OK) status = spread_of_drawn(&own, limits, of->period, spread);
    if (of->period > 0.0 && place == WHIRL_ANYWHERE) spread_forget(spread);
    free(points);
    free(own.numbers);
    return status;
}

/// Finds a number in the table of a result.
static const char *find_in_result(const whirl_result *result, const whirl_table *table, const whirl_spread_of *of,
                                  whirl_spread_at *at, whirl_status *status) {
    const size_t count = result->station_count + result->contact_count;
    const char **names = malloc((count + 1) * sizeof *names);
    const char *lacks = "";
    if (names) {
        for (size_t i = 0; i < result->station_count; i++) names[i] = result->stations[i].name;
        for (size_t i = 0; i < result->contact_count; i++) names[result->station_count + i] = result->contacts[i];
        lacks = whirl_spread_find(of, &table->layout, names, result->station_count, names + result->station_count,
                                  result->contact_count, at);
    } else {
        *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the names of stations");
    }
    free((void *)names);
    return lacks;
}

bool whirl_spread_place(const whirl_result *result, const whirl_table *table, const whirl_spread_of *of,
                        whirl_spread_at *at) {
    whirl_status status = whirl_ok();
    return !find_in_result(result, table, of, at, &status);
}

whirl_status whirl_table_spread(const whirl_result *result, const whirl_table *table, const whirl_spread_of *of,
                                size_t place, size_t samples, whirl_spread *spread) {
    whirl_spread_at at;
    whirl_status status = whirl_ok();
    const char *lacks = find_in_result(result, table, of, &at, &status);
    if (status.code != WHIRL_OK) return status;
    if (lacks) return whirl_fail(WHIRL_BAD_INPUT, "the number %.80s %s", of->field, lacks);
    const wanted own = {.result = result,
                        .table = table,
                        .at = &at,
                        .least = isinf(of->below) && !isinf(of->above),
                        .period = whirl_spread_period(&at)};
    return spread_table(&own, of, place, samples, spread);
}

whirl_status whirl_table_chance(const whirl_table *table, whirl_chance chance, const whirl_verdict *verdict,
                                size_t place, size_t samples, whirl_spread *spread) {
    static const whirl_spread_of half = {.above = -INFINITY, .below = 0.5};
    const wanted own = {.table = table, .chance = chance, .verdict = verdict};
    return spread_table(&own, &half, place, samples, spread);
}

// ---------------------------------------------------------------- what is asked

const char *whirl_result_tolerance(const whirl_result *result, size_t index, char name[WHIRL_NAME_SIZE]) {
    char fact[WHIRL_NAME_SIZE];
    snprintf(fact, sizeof fact, "tolerance %zu", index + 1);
    const char *text = whirl_result_fact(result, fact);
    snprintf(name, WHIRL_NAME_SIZE, "%.*s", (int)strcspn(text, ":"), text);
    return name;
}

/// Returns true if a usual number is that of an axial displacement or twist at a station that never moves so.
static bool asked_lacks(const whirl_table *table, const whirl_spread_of *of, size_t which) {
    if (!strstr(of->field, "axial") && !strstr(of->field, "twist")) return false;
    for (size_t point = 0; point < table->count; point++) {
        const double *number = whirl_table_field(table, point, of->field, which);
        if (number && !isnan(*number)) return false;
    }
    return true;
}

/// Gives the numbers that facts ("limit 1", ...) ask of a table, or the usual ones, by index.
static bool asked_number(const whirl_result *result, const whirl_table *table, const char *asks, bool derived,
                         size_t index, whirl_spread_of *of) {
    // Count the numbers that the case asks for.
    char fact[WHIRL_NAME_SIZE];
    whirl_spread_at at;
    whirl_status status = whirl_ok();
    snprintf(fact, sizeof fact, "%s 1", asks);
    const bool some = *whirl_result_fact(result, fact) != '\0';
    for (size_t i = 0; some; i++) {
        snprintf(fact, sizeof fact, "%s %zu", asks, i + 1);
        if (!whirl_spread_read(whirl_result_fact(result, fact), of)) return false;
        if (!find_in_result(result, table, of, &at, &status) && index-- == 0) return true;
    }
    // Without any, count the usual fields of each station or contact.
    for (size_t i = 0;; i++) {
        size_t which;
        if (!spread_usual(&table->layout, derived, i, of, &which)) return false;
        const whirl_extent extent = whirl_layout_field(&table->layout, of->field)->extent;
        if (extent == WHIRL_PER_STATION && which < result->station_count)
            snprintf(of->at, sizeof of->at, "%s", result->stations[which].name);
        else if (extent == WHIRL_PER_CONTACT && which < result->contact_count)
            snprintf(of->at, sizeof of->at, "%s", result->contacts[which]);
        // Derivatives are stored by the indices of all usual numbers.
        if (!derived && asked_lacks(table, of, which)) continue;
        if (index-- == 0) return true;
    }
}

bool whirl_table_asked(const whirl_result *result, const whirl_table *table, size_t index, whirl_spread_of *of) {
    return asked_number(result, table, "limit", false, index, of);
}

bool whirl_table_derived(const whirl_result *result, const whirl_table *table, size_t index, whirl_spread_of *of) {
    const whirl_field *numbers = whirl_layout_field(&table->layout, WHIRL_FIELD_SENSITIVITY_NUMBERS);
    return numbers && index < numbers->rows && asked_number(result, table, "derived", true, index, of);
}

bool whirl_motion_is_derived(const char *field) {
    static const char *const all[] = {
        WHIRL_FIELD_ORBIT_MAX_RADIUS,     WHIRL_FIELD_ORBIT_MIN_RADIUS,           WHIRL_FIELD_ORBIT_MEAN,
        WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG,   WHIRL_FIELD_FLOQUET_MODULUS,
        WHIRL_FIELD_ORBIT_AXIAL,          WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, WHIRL_FIELD_SPECTRUM_AXIAL_LAG,
        WHIRL_FIELD_ORBIT_TWIST,          WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, WHIRL_FIELD_SPECTRUM_TWIST_LAG};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(field, all[i]) == 0) return true;
    return false;
}
