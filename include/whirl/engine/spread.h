/// Spreads: statistics of a result number over the samples of a study of tolerances.
#ifndef WHIRL_SPREAD_H
#define WHIRL_SPREAD_H

#include "whirl/engine/lyapunov.h"
#include "whirl/engine/result.h"
#include "whirl/engine/tolerances.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Size of the text of whirl_spread_text.
enum { WHIRL_SPREAD_TEXT = 4 * WHIRL_NAME_SIZE };

/// Selects a number that every point has, with its limits.
typedef struct whirl_spread_of {
    char field[WHIRL_NAME_SIZE];  ///< name of the field
    char column[WHIRL_NAME_SIZE]; ///< name of its column, "" for the first
    size_t row;                   ///< row of the field, from 0
    char at[WHIRL_NAME_SIZE];     ///< station or contact, "" for a number of the point
    double above, below;          ///< limits in SI between which the number has to be; infinite: none
} whirl_spread_of;

/// Writes a selection as a text for whirl_spread_read: "unbalance/axes column major row 1 above -inf below 5e-05 at
/// disc".
void whirl_spread_text(const whirl_spread_of *of, char text[WHIRL_SPREAD_TEXT]);

/// Reads such a text; all parts but the field may be missing. Returns false for any other text.
bool whirl_spread_read(const char *text, whirl_spread_of *of);

/// Place of a number in the blocks of a table.
typedef struct whirl_spread_at {
    const whirl_field *field; ///< its field, of the layout
    size_t which, index;      ///< station or contact; index within the field's array
} whirl_spread_at;

/// Finds the place of a number in a layout, by the names of stations and contacts in the order of the field. Returns
/// NULL if found, else a clause that says what is missing; static text.
const char *whirl_spread_find(const whirl_spread_of *of, const whirl_layout *layout, const char *const *stations,
                              size_t station_count, const char *const *contacts, size_t contact_count,
                              whirl_spread_at *at);

/// Finds the place of a number in a table of a result. Returns false if there is none, or memory is exhausted.
bool whirl_spread_place(const whirl_result *result, const whirl_table *table, const whirl_spread_of *of,
                        whirl_spread_at *at);

/// Returns the period of a number that is an angle, in its unit: 360 for lags and attitudes, 180 for the inclination of
/// an axis; 0 for other numbers.
double whirl_spread_period(const whirl_spread_at *at);

/// Number of quantiles of a spread: of the probabilities 0.05, 0.25, 0.5, 0.75 and 0.95.
enum { WHIRL_QUANTILES = 5 };
/// The probabilities of these quantiles.
extern const double whirl_quantiles[WHIRL_QUANTILES];

/// A probability with its standard error and a 95 % interval (Wilson 1927, for as many independent samples). Samples
/// without a number widen the interval on both sides.
typedef struct whirl_probability {
    whirl_estimate of; ///< the probability
    double from, to;   ///< the interval
} whirl_probability;

/// Sensitivity indices of a parameter: the part of the variance that it causes alone, and together with others.
typedef struct whirl_index {
    whirl_estimate first, total; ///< alone, and with others
} whirl_index;

/// Statistics of a number. For an angle (whirl_spread_period) the circle is cut opposite to the circular mean, which is
/// taken from -45 to 315 degrees, so that statistics may be below 0 or above 360. They are missing if the mean
/// resultant length is below 0.2, since samples then lie all around, and at WHIRL_ANYWHERE. Limits are of the angle
/// itself. Errors are standard errors, from the replicates of the samples. Estimates without a meaning are NaN.
typedef struct whirl_spread {
    size_t samples, failed;                      ///< samples that are done; samples among them without the number
    double least, most;                          ///< extremes of all samples
    whirl_estimate mean, variance, deviation;    ///< moments; the deviation is the root of the variance
    whirl_estimate quantiles[WHIRL_QUANTILES];   ///< at whirl_quantiles
    whirl_probability beyond;                    ///< probability that the number is outside its limits
    size_t index_count;                          ///< number of parameters with indices; 0: none
    whirl_index indices[WHIRL_MAX_TOLERANCES];   ///< indices of the number
    whirl_index beyond_of[WHIRL_MAX_TOLERANCES]; ///< indices of the probability to be outside the limits
} whirl_spread;

/// Place of whirl_table_spread for the worst of all values of the parameter: the largest number of a sample, or with a
/// lower limit alone the least.
#define WHIRL_ANYWHERE ((size_t)-1)

/// Returns the number of a point in SI; NaN if it has none.
double whirl_spread_number(const whirl_result *result, const whirl_table *table, size_t point,
                           const whirl_spread_at *at);

/// Finds the statistics of a number over the first `samples` samples (0: all) of a table of samples, at a value of its
/// parameter by its place from 0, or WHIRL_ANYWHERE. WHIRL_BAD_INPUT for other tables, WHIRL_NO_MEMORY.
whirl_status whirl_table_spread(const whirl_result *result, const whirl_table *table, const whirl_spread_of *of,
                                size_t place, size_t samples, whirl_spread *spread);

/// Events whose probability whirl_table_chance computes.
typedef enum whirl_chance {
    WHIRL_CHANCE_VERDICT, ///< a verdict: regime and period
    WHIRL_CHANCE_TOUCH    ///< any contact is closed at some time
} whirl_chance;

/// Finds the probability of a verdict (its regime, and its period if it is periodic), or of a contact. Its number in
/// `spread` is 1 for samples with the event and 0 for others, so that indices are those of the probability. Samples
/// without a verdict count as failed. Errors as whirl_table_spread.
whirl_status whirl_table_chance(const whirl_table *table, whirl_chance chance, const whirl_verdict *verdict,
                                size_t place, size_t samples, whirl_spread *spread);

/// Writes selection number `index`, from 0, of a table: those of the case (facts "limit 1", ...) that the table has, or
/// the usual ones. Returns false past the last.
bool whirl_table_asked(const whirl_result *result, const whirl_table *table, size_t index, whirl_spread_of *of);

/// Writes selection number `index`, from 0, of the numbers of a table whose derivatives are in the field
/// "sensitivity/slopes": those of the case (facts "derived 1", ...) that the table has, or the usual ones. Returns
/// false past the last.
bool whirl_table_derived(const whirl_result *result, const whirl_table *table, size_t index, whirl_spread_of *of);

/// Returns true for a field of motions whose numbers have derivatives.
bool whirl_motion_is_derived(const char *field);

/// Writes the name of a parameter with a tolerance, by index from 0 (facts "tolerance 1", ...), to `name`, and returns
/// it; "" past the last.
const char *whirl_result_tolerance(const whirl_result *result, size_t index, char name[WHIRL_NAME_SIZE]);

#ifdef __cplusplus
}
#endif
#endif
