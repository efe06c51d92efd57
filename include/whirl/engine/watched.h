/// Quantities observed at every instant of a motion: each is one line of these lists. Lanes, records, the fields of the
/// analyses `orbit` and `rub` and everything that walks fields (results, CSV, JSON, reports, the explorer) follow from
/// them. src/integrate/kernels/watched_kernel.h computes the values of an instant.
#ifndef WHIRL_WATCHED_H
#define WHIRL_WATCHED_H

#include "whirl/engine/fields.h"

/// Extent of a quantity: one value for each of these.
typedef enum whirl_extent { WHIRL_PER_POINT = 0, WHIRL_PER_STATION, WHIRL_PER_CONTACT } whirl_extent;

/// Operations over the values of all instants.
typedef enum whirl_fold {
    WHIRL_LARGEST = 0, ///< the largest value
    WHIRL_SMALLEST,    ///< the smallest value
    WHIRL_MEAN,        ///< the mean; until a record is closed, the sum
    WHIRL_SUM          ///< the sum
} whirl_fold;

/// X(array, extent, columns, fold, square, name, unit, meaning): an array [stations or contacts][columns] and its
/// field, with name, unit and meaning as in whirl_field. square: instants give squares, and the root is taken at the
/// end, so that a mean is a root mean square.
#define WHIRL_WATCHED_OF_STATIONS(X)                                                                                   \
    X(max_radius, WHIRL_PER_STATION, 1, WHIRL_LARGEST, true, WHIRL_FIELD_ORBIT_MAX_RADIUS, "length",                   \
      "largest distance from the centre (0-p)")                                                                        \
    X(min_radius, WHIRL_PER_STATION, 1, WHIRL_SMALLEST, true, WHIRL_FIELD_ORBIT_MIN_RADIUS, "length",                  \
      "smallest distance from the centre (0-p)")                                                                       \
    X(mean, WHIRL_PER_STATION, 2, WHIRL_MEAN, false, WHIRL_FIELD_ORBIT_MEAN, "length", "x, y (from the centre)")       \
    X(backward, WHIRL_PER_STATION, 1, WHIRL_MEAN, false, WHIRL_FIELD_ORBIT_BACKWARD, "1",                              \
      "share of the time of whirl against the rotation (about x = y = 0, not about the middle; missing at rest)")
/// Quantities of contacts, in the same form.
#define WHIRL_WATCHED_OF_CONTACTS(X)                                                                                   \
    X(contact_share, WHIRL_PER_CONTACT, 1, WHIRL_MEAN, false, WHIRL_FIELD_RUB_SHARE, "1",                              \
      "share of the time in contact")                                                                                  \
    X(contact_number, WHIRL_PER_CONTACT, 1, WHIRL_SUM, false, WHIRL_FIELD_RUB_NUMBER, "1", "times that contact began") \
    X(contact_force, WHIRL_PER_CONTACT, 1, WHIRL_LARGEST, false, WHIRL_FIELD_RUB_MAX_FORCE, "force",                   \
      "largest normal force (at any instant)")                                                                         \
    X(contact_torque, WHIRL_PER_CONTACT, 1, WHIRL_MEAN, false, WHIRL_FIELD_RUB_TORQUE, "N m",                          \
      "mean torque of the friction on the shaft, against its rotation (missing where the radius is not known)")        \
    X(contact_most, WHIRL_PER_CONTACT, 1, WHIRL_LARGEST, false, WHIRL_FIELD_RUB_MAX_TORQUE, "N m",                     \
      "largest torque of the friction (at any instant)")                                                               \
    X(contact_power, WHIRL_PER_CONTACT, 1, WHIRL_MEAN, false, WHIRL_FIELD_RUB_POWER, "W",                              \
      "mean power that the friction takes")
/// All quantities.
#define WHIRL_WATCHED(X) WHIRL_WATCHED_OF_STATIONS(X) WHIRL_WATCHED_OF_CONTACTS(X)

/// The array of a quantity, as a member of a struct.
#define WHIRL_WATCHED_ARRAY(array, ...) double *array;
/// The arrays of all quantities.
#define WHIRL_WATCHED_ARRAYS WHIRL_WATCHED(WHIRL_WATCHED_ARRAY)

/// Number of values of a quantity.
#define WHIRL_WATCHED_SIZE(extent, columns, stations, contacts)                                                        \
    ((columns) * ((extent) == WHIRL_PER_STATION ? (stations) : (contacts)))

#endif
