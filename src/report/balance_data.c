// Result of a balancing job as JSON.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "balance_parts.h"
#include "document.h"
#include "findings_render.h"
#include "whirl/engine/descriptor.h"
#include "whirl/internal/findings.h"
#include "whirl/status.h"

static const double degree = 3.14159265358979323846 / 180.0;

static json_t *vector(bool *well, const double of[2], const char *size, double way) {
    json_t *made = json_object();
    document_put(well, made, size, document_number(balance_size(of)));
    document_put(well, made, "angle", document_number(degree * balance_degrees(of, way)));
    return made;
}

/// Returns a JSON object with a vector for every plane, by the plane's name. `size` is the key of a vector's length,
/// `way` the sense of its angle (1 or -1).
static json_t *by_plane(bool *well, const whirl_balance *of, const double (*vectors)[2], const char *size, double way) {
    json_t *made = json_object();
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(well, made, of->planes[p].name, vector(well, vectors[p], size, way));
    return made;
}

static json_t *row_of(bool *well, const whirl_balance *of, const whirl_correction *found,
                      const whirl_balance_row *row) {
    json_t *made = json_object();
    const double way = balance_way_of_phases(of);
    document_put(well, made, "probe", document_text(row->probe));
    document_put(well, made, "speed", document_number(row->speed));
    document_put(well, made, "before", vector(well, row->before, "amplitude", way));
    if (found->found) document_put(well, made, "after", vector(well, row->after, "amplitude", way));
    if (isfinite(row->worst)) document_put(well, made, "worst", document_number(row->worst));
    if (row->model) document_put(well, made, "model", by_plane(well, of, row->model->influence, "amplitude", way));
    if (!found->found) return made;
    if (!found->by_set) {
        document_put(well, made, "influence", by_plane(well, of, row->influence, "amplitude", way));
        return made;
    }
    json_t *sets = json_array();
    for (size_t n = 0; n < found->set_count; n++)
        document_append(well, sets, found->used[n] ? vector(well, row->influence[n], "amplitude", way) : json_null());
    document_put(well, made, "influence_of_sets", sets);
    return made;
}

static json_t *plane_of(bool *well, const whirl_balance *of, const whirl_correction *found, size_t p) {
    json_t *made = vector(well, found->moment[p], "moment", balance_way_of_angles(of)), *holes = json_array();
    int hole[2];
    double moments[2];
    if (of->planes[p].holes > 0) {
        whirl_balance_split(of, p, found->moment[p], hole, moments);
        for (int k = 0; k < 2 && (k == 0 || moments[k] > 0.0); k++) {
            json_t *one = json_object();
            document_put(well, one, "hole", json_integer(hole[k]));
            document_put(well, one, "moment", document_number(moments[k]));
            document_append(well, holes, one);
        }
    }
    if (of->planes[p].radius > 0.0)
        document_put(well, made, "mass", document_number(balance_size(found->moment[p]) / of->planes[p].radius));
    document_put(well, made, "holes", holes);
    return made;
}

static json_t *set_of(bool *well, const whirl_balance *of, const whirl_balance_model *model,
                      const whirl_correction *found, size_t n) {
    json_t *made = json_object();
    const double way = balance_way_of_angles(of);
    document_put(well, made, "speed", document_number(of->modes[n].speed));
    if (model && !of->modes[n].shaped) document_put(well, made, "natural", document_number(model->natural[n]));
    document_put(well, made, "weights", by_plane(well, of, found->sets[n], "weight", way));
    if (found->used[n]) document_put(well, made, "amount", vector(well, found->amount[n], "moment", way));
    return made;
}

static json_t *proposal_of(bool *well, const whirl_balance *of, const whirl_balance_model *model,
                           const whirl_correction *found, const char *units, size_t n) {
    static const char *const reasons[] = {"force", "least", "most", "limit", "nothing"};
    const whirl_balance_proposal *own = &found->proposals[n];
    json_t *made = vector(well, own->moment, "moment", balance_way_of_angles(of));
    double weights[WHIRL_MAX_PLANES][2];
    char text[STATEMENT_SIZE];
    *well = balance_reason_text(of, model, found, units, n, text) && *well;
    for (size_t p = 0; p < of->plane_count; p++) whirl_balance_proposed(found, n, p, weights[p]);
    if (of->mode_count > 0)
        document_put(well, made, "set", json_integer((json_int_t)n + 1));
    else
        document_put(well, made, "plane", document_text(of->planes[n].name));
    document_put(well, made, "weights",
                 by_plane(well, of, (const double(*)[2])weights, "moment", balance_way_of_angles(of)));
    document_put(well, made, "reason", document_text(reasons[own->reason]));
    document_put(well, made, "sentence", document_text(text));
    document_put(well, made, "change", document_number(own->change));
    return made;
}

/// Writes the significance of each plane or weight set, and the correction without the least significant one.
static void put_reduced(bool *well, json_t *all, const whirl_balance *of, const whirl_correction *found) {
    char name[WHIRL_NAME_SIZE];
    json_t *significance = json_object(), *without = json_object();
    for (size_t n = 0; n < (of->mode_count > 0 ? of->mode_count : of->plane_count); n++) {
        balance_name(of, n, name, sizeof name);
        document_put(well, significance, name, document_number(found->significance[n]));
    }
    document_put(well, all, "least", document_text(of->least_max ? "max" : "squares"));
    document_put(well, all, "left", document_number(found->left));
    document_put(well, all, "condition", document_number(found->condition));
    document_put(well, all, "significance", significance);
    if (!found->reduced.there) {
        json_decref(without);
        return;
    }
    balance_name(of, found->reduced.without, name, sizeof name);
    document_put(well, without, "name", document_text(name));
    document_put(well, without, "left", document_number(found->reduced.left));
    document_put(well, without, "correction",
                 by_plane(well, of, found->reduced.moment, "moment", balance_way_of_angles(of)));
    document_put(well, all, "without", without);
}

static void put_correction(bool *well, json_t *all, const whirl_balance *of, const whirl_correction *found) {
    const double allowed = whirl_balance_allowed(of), sum = balance_sum(of, found), way = balance_way_of_angles(of);
    double whole[2], half[2];
    json_t *planes = json_object();
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(well, planes, of->planes[p].name, plane_of(well, of, found, p));
    document_put(well, all, "correction", planes);
    document_put(well, all, "unbalance", document_number(sum));
    put_reduced(well, all, of, found);
    if (isfinite(allowed)) document_put(well, all, "grade", document_number(of->grade * sum / allowed));
    if (of->plane_count != 2) return;
    balance_static(found, whole, half);
    document_put(well, all, "static", vector(well, whole, "moment", way));
    document_put(well, all, "couple", vector(well, half, "moment", way));
}

static void put_warnings(bool *well, json_t *warnings, const whirl_balance *of, const whirl_correction *found,
                         const char *units) {
    char text[STATEMENT_SIZE] = "";
    for (size_t i = 0; *well; i++) {
        *well = balance_warning_text(of, found, units, i, text);
        if (!*text) return;
        document_append(well, warnings, document_text(text));
    }
}

whirl_status whirl_balance_write_json(const whirl_balance *of, const whirl_balance_model *model,
                                      const whirl_correction *found, const char *units, FILE *out) {
    bool well = true;
    whirl_findings *findings;
    const whirl_status status = whirl_balance_findings(of, model, found, units, &findings);
    if (status.code != WHIRL_OK) return status;
    json_t *all = json_object(), *rows = json_array(), *sets = json_array(), *trials = json_array(),
           *warnings = json_array();
    // Begin with the conventions of the readings.
    document_put(&well, all, "title", document_text(of->title));
    document_put(&well, all, "angles", document_text(of->against ? "against" : "with"));
    document_put(&well, all, "amplitudes", *of->counted ? document_text(of->counted) : json_null());
    document_put(&well, all, "phases", document_text(of->leads ? "lead" : "lag"));
    if (of->slow_roll_count > 0) {
        json_t *rolls = json_array();
        for (size_t i = 0; i < of->slow_roll_count; i++) {
            json_t *one = vector(&well, of->slow_rolls[i].vibration, "amplitude", balance_way_of_phases(of));
            document_put(&well, one, "probe", document_text(of->slow_rolls[i].probe));
            document_append(&well, rolls, one);
        }
        document_put(&well, all, "slow_roll", rolls);
    }
    // Collect the correction, rows, sets, proposals and warnings.
    if (found->found) put_correction(&well, all, of, found);
    for (size_t r = 0; r < found->row_count; r++)
        document_append(&well, rows, row_of(&well, of, found, &found->rows[r]));
    for (size_t n = 0; n < found->set_count; n++) document_append(&well, sets, set_of(&well, of, model, found, n));
    for (size_t n = 0; n < found->proposal_count; n++)
        document_append(&well, trials, proposal_of(&well, of, model, found, units, n));
    put_warnings(&well, warnings, of, found, units);
    // Put the collected parts in, then statements and sheets as data.
    document_put(&well, all, "vibration", rows);
    document_put(&well, all, "sets", sets);
    document_put(&well, all, "proposals", trials);
    document_put(&well, all, "warnings", warnings);
    document_put(&well, all, "difference", document_number(whirl_balance_difference(of, found)));
    document_put(&well, all, "allowed", document_number(whirl_balance_allowed(of)));
    document_put(&well, all, "statements", statements_json(&well, findings));
    document_put(&well, all, "sheets", sheets_json(&well, findings));
    whirl_findings_free(findings);
    if (document_write(well, all, out) && fputc('\n', out) != EOF) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON, or it cannot be written");
}
