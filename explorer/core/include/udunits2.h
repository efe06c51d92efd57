/// The part of UDUNITS-2 that src/case needs, for a build without it: the same functions with the same meaning and
/// results (explorer/tests/units.sh compares them). Units are those of the library's database, compiled in
/// (unit_table.c).
#ifndef EXPLORER_UDUNITS2_H
#define EXPLORER_UDUNITS2_H

#include <stdarg.h>
#include <stddef.h>

typedef struct ut_system ut_system;
typedef struct ut_unit ut_unit;
typedef struct cv_converter cv_converter;
typedef enum ut_encoding { UT_ASCII = 0, UT_UTF8 = 2 } ut_encoding;
enum { UT_DEFINITION = 8 };
typedef enum ut_status { UT_SUCCESS = 0, UT_NO_MEMORY } ut_status;
typedef int (*ut_error_message_handler)(const char *format, va_list arguments);

int ut_ignore(const char *format, va_list arguments);
ut_error_message_handler ut_set_error_message_handler(ut_error_message_handler handler);

/// Returns the units of the database; ignores `path`. Static: never freed.
ut_system *ut_read_xml(const char *path);

/// Parses a product of names with prefixes and whole powers; NULL for other texts. Freed by ut_free.
ut_unit *ut_parse(const ut_system *system, const char *text, ut_encoding encoding);
ut_unit *ut_get_dimensionless_unit_one(const ut_system *system);
ut_status ut_unmap_name_to_unit(ut_system *system, const char *name, ut_encoding encoding);
ut_status ut_map_name_to_unit(const char *name, ut_encoding encoding, const ut_unit *unit);
ut_unit *ut_divide(const ut_unit *numerator, const ut_unit *denominator);
ut_unit *ut_scale(double factor, const ut_unit *unit);
/// Returns 1 for a dimensionless unit, which includes angles, else 0.
int ut_is_dimensionless(const ut_unit *unit);
/// Writes the unit in base units, "0.001 m2.kg.s-3". Returns the number of bytes, like snprintf.
int ut_format(const ut_unit *unit, char *text, size_t size, unsigned options);
void ut_free(ut_unit *unit);

/// Returns a converter from numbers in `from` to numbers in `to`, or NULL if the units are of different kinds. Free it
/// with cv_free.
cv_converter *ut_get_converter(ut_unit *from, ut_unit *to);
double cv_convert_double(const cv_converter *converter, double value);
void cv_free(cv_converter *converter);

#endif
