#include <math.h>
#include <stdio.h>

#include "spread_usual.h"

/// Usual fields of a study: of each, the number of every station or contact, or the numbers of the first rows.
static const struct {
    const char *field, *column;
    size_t rows;
    bool derived; ///< used for derivatives only
} usual[] = {
    {WHIRL_FIELD_ORBIT_MAX_RADIUS, "", 1, false},
    {WHIRL_FIELD_ORBIT_AXIAL, "least", 1, false},
    {WHIRL_FIELD_ORBIT_AXIAL, "largest", 1, false},
    {WHIRL_FIELD_ORBIT_TWIST, "least", 1, false},
    {WHIRL_FIELD_ORBIT_TWIST, "largest", 1, false},
    {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "forward", 1, true},
    {WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, "", 1, true},
    {WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, "", 1, true},
    {WHIRL_FIELD_FLOQUET_MODULUS, "", 1, true},
    {WHIRL_FIELD_UNBALANCE_AXES, "major", 1, false},
    {WHIRL_FIELD_TRACE_SPECIAL, "", 1, true},
    {WHIRL_FIELD_MODES_FREQUENCY, "", 4, false},
    {WHIRL_FIELD_MODES_DAMPING_RATIO, "", 4, false},
    {WHIRL_FIELD_MODES_CRITICAL, "value", 1, true},
    {WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, "", 4, false},
    {WHIRL_FIELD_STABILITY_COMPLETE, "", 1, false},
    {WHIRL_FIELD_STATICS_ECCENTRICITY, "", 1, false},
    {WHIRL_FIELD_TORSION_ANGLE_SUM, "", 1, false},
    {WHIRL_FIELD_RUNUP_PEAK, "", 1, false},
    {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, "least", 1, false},
    {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, "largest", 1, false},
    {WHIRL_FIELD_RUNUP_TWIST_EXTREME, "least", 1, false},
    {WHIRL_FIELD_RUNUP_TWIST_EXTREME, "largest", 1, false},
};

bool spread_usual(const whirl_layout *layout, bool derived, size_t index, whirl_spread_of *of, size_t *which) {
    for (size_t u = 0; u < sizeof usual / sizeof *usual; u++) {
        const whirl_field *field = whirl_layout_field(layout, usual[u].field);
        if (usual[u].derived && !derived) continue;
        for (size_t k = 0; field && k < field->repeat * usual[u].rows; k++) {
            const size_t row = k % usual[u].rows;
            if (row >= field->rows || index-- > 0) continue;
            *of = (whirl_spread_of){.row = row, .above = -INFINITY, .below = INFINITY};
            *which = k / usual[u].rows;
            snprintf(of->field, sizeof of->field, "%s", field->name);
            snprintf(of->column, sizeof of->column, "%s", usual[u].column);
            return true;
        }
    }
    return false;
}
