#include "bearing_oil.h"
#include "settings.h"

#include <math.h>

#include "mineral_oil.h"
#include "problem.h"
#include "tree.h"

enum { DYNAMIC, KINEMATIC, GRADE, TABLE, WAYS };
static const char *const ways[] = {"viscosity", "kinematic_viscosity", "grade", "temperatures"};
static const char *const warm_keys[] = {"temperature", "supply_temperature"};

static const file_node *oil_place(const setting_list *file, const char *key) {
    const setting *given = settings_find(file, key);
    return given ? given->place : file->place;
}

/// Returns the way in which the viscosity is given; WAYS, with a problem reported, if there is none or there are
/// several.
static int way_of(case_reader *reader, const setting_list *file) {
    int given = 0, last = WAYS;
    for (int i = 0; i < WAYS; i++)
        if (settings_find(file, ways[i])) given++, last = i;
    if (given == 0)
        problem_missing(reader->problems, file->place, "viscosity",
                        "is missing, expected this, kinematic_viscosity, or grade or temperatures with the "
                        "temperature of the film");
    if (given > 1)
        problem_at(reader->problems, oil_place(file, ways[last]),
                   "is given together with another one, expected one of them");
    return given == 1 ? last : WAYS;
}

/// Reports keys that belong to another way of giving the viscosity.
static void check_strays(case_reader *reader, const setting_list *file, int way) {
    static const struct {
        const char *key, *of;
        int way, other; ///< the way that the key belongs to, and a second one that also allows it
    } strays[] = {{"kinematic_100", "grade", GRADE, GRADE},
                  {"viscosities", "temperatures", TABLE, TABLE},
                  {"temperature", "grade", GRADE, TABLE},
                  {"supply_temperature", "grade or temperatures", GRADE, TABLE}};
    for (size_t i = 0; i < sizeof strays / sizeof *strays; i++)
        if (settings_find(file, strays[i].key) && way != strays[i].way && way != strays[i].other && way != WAYS)
            problem_at(reader->problems, oil_place(file, strays[i].key), "belongs to %s, which is not given",
                       strays[i].of);
}

static void read_grade(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const double own = settings_plain(reader, file, "grade") * 1e-6;
    const double hot =
        settings_find(file, "kinematic_100") ? settings_plain(reader, file, "kinematic_100") : mineral_oil_at_100(own);
    if (hot >= own) {
        problem_at(reader->problems, oil_place(file, "kinematic_100"), "is not below that at 40 degC, %g mm2/s",
                   own * 1e6);
        return;
    }
    out->oil_count = 2;
    out->oil_temperatures[0] = OIL_40_DEGREES;
    out->oil_temperatures[1] = OIL_100_DEGREES;
    out->oil_viscosities[0] = own;
    out->oil_viscosities[1] = hot;
}

static void read_table(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    // Read both lists, which belong together.
    const size_t rows = settings_list_plain(reader, file, "temperatures", out->oil_temperatures, WHIRL_MAX_LIST);
    const size_t count = settings_list_plain(reader, file, "viscosities", out->oil_viscosities, WHIRL_MAX_LIST);
    const setting *viscosities = settings_find(file, "viscosities");
    if (!viscosities)
        problem_missing(reader->problems, file->place, "viscosities", "is missing, expected one for every temperature");
    if (rows == 0 || count == 0) return;
    // Refuse lists of different lengths.
    if (rows < 2 || rows != count) {
        problem_at(reader->problems, oil_place(file, "temperatures"),
                   "has %zu numbers for %zu viscosities, expected equal numbers, two or more", rows, count);
        return;
    }
    // Keep kinematic viscosities, which fall while temperatures rise.
    for (size_t i = 0; i < rows; i++) out->oil_viscosities[i] /= out->density;
    for (size_t i = 1; i < rows; i++) {
        if (!(out->oil_temperatures[i] > out->oil_temperatures[i - 1]))
            problem_at(reader->problems, oil_place(file, "temperatures"),
                       "does not rise, expected rising temperatures");
        else if (!(out->oil_viscosities[i] < out->oil_viscosities[i - 1]))
            problem_at(reader->problems, viscosities->place, "does not fall, expected that of an oil that gets warmer");
        else
            continue;
        return;
    }
    out->oil_count = rows;
}

/// Reads the temperature of the film, or that of the oil supply.
static void read_temperature(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    const setting *own = settings_find(file, warm_keys[0]), *inlet = settings_find(file, warm_keys[1]);
    if (own && inlet)
        problem_at(reader->problems, inlet->place, "is given together with temperature, expected one of them");
    else if (!own && !inlet && !settings_misspelt(file, warm_keys[0]) && !settings_misspelt(file, warm_keys[1]))
        problem_missing(reader->problems, file->place, "temperature",
                        "is missing, expected that of the film, or supply_temperature");
    out->heated = inlet && !own;
    out->temperature = settings_plain(reader, file, warm_keys[out->heated]);
}

void bearing_oil_read(case_reader *reader, const setting_list *file, whirl_bearing *out) {
    // Read the keys that oils of every kind have.
    const int way = way_of(reader, file);
    out->density = settings_plain(reader, file, "density");
    out->heat_share = settings_plain(reader, file, "heat_share");
    out->specific_heat = settings_plain(reader, file, "specific_heat");
    out->temperature = NAN;
    check_strays(reader, file, way);
    if (settings_find(file, "heat_share") && !settings_find(file, "supply_temperature"))
        problem_at(reader->problems, oil_place(file, "heat_share"),
                   "belongs to supply_temperature, which is not given");
    // A viscosity alone holds at every temperature.
    if (way == WAYS) return;
    if (way < GRADE) {
        const double own = settings_plain(reader, file, ways[way]);
        out->viscosity = way == DYNAMIC ? own : own * out->density;
        return;
    }
    // A grade or a table gives the viscosity at the temperature of the oil.
    read_temperature(reader, file, out);
    if (way == GRADE)
        read_grade(reader, file, out);
    else
        read_table(reader, file, out);
    if (out->oil_count == 0) return;
    out->viscosity = out->density * mineral_oil_viscosity(out->oil_temperatures, out->oil_viscosities, out->oil_count,
                                                          out->temperature);
}
