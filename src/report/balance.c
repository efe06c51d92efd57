// What balancing found, for people and for programs.
#include "whirl/engine/balance.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report_parts.h"

static const double degree = 3.14159265358979323846 / 180.0, rpm = 3.14159265358979323846 / 30.0, um = 1e-6,
                    gram_mm = 1e-6, rounding = 1e-9;

static double size_of(const double vector[2]) {
    return hypot(vector[0], vector[1]);
}

/// From 0 to 360 degrees, of `way` (1, -1) times the angle.
static double degrees_of(const double vector[2], double way) {
    const double angle = fmod(way * atan2(vector[1], vector[0]) / degree + 360.0, 360.0);
    return angle > 1e-9 && angle < 360.0 - 1e-9 ? angle : 0.0;
}

/// What is left of a vibration; 0 where that is rounding beside the largest.
static double left_of(const whirl_correction *found, const whirl_balance_row *row) {
    const double after = size_of(row->after);
    double largest = 0.0;
    for (size_t r = 0; r < found->row_count; r++) largest = fmax(largest, size_of(found->rows[r].before));
    return after > rounding * largest && largest > 0.0 ? after : 0.0;
}

/// How whirl_correction.left counts.
static const char *left_as(const whirl_balance *of) {
    return of->least_max ? "at most" : "in the mean square";
}

static double way_of_angles(const whirl_balance *of) {
    return of->against ? -1.0 : 1.0;
}

static double way_of_phases(const whirl_balance *of) {
    return of->leads ? 1.0 : -1.0;
}

// ---------------------------------------------------------------- for people

static void print_plane(FILE *out, const whirl_balance *of, size_t p, const double moment[2]) {
    const whirl_balance_plane *plane = &of->planes[p];
    fprintf(out, "%s: %.6g g mm at %.4g deg", plane->name, size_of(moment) / gram_mm,
            degrees_of(moment, way_of_angles(of)));
    if (plane->radius > 0.0)
        fprintf(out, ", %.5g g at a radius of %.4g mm", 1e3 * size_of(moment) / plane->radius, 1e3 * plane->radius);
    if (plane->holes > 0) {
        int hole[2];
        double moments[2];
        whirl_balance_split(of, p, moment, hole, moments);
        fprintf(out, "; hole %d: %.6g g mm", hole[0], moments[0] / gram_mm);
        if (moments[1] > 0.0) fprintf(out, ", hole %d: %.6g g mm", hole[1], moments[1] / gram_mm);
    }
    fputc('\n', out);
}

/// The static part and the couple about the middle of two planes, half of the difference in each; 0 where that is
/// rounding.
static void find_static(const whirl_correction *found, double sum[2], double half[2]) {
    const double least = rounding * (size_of(found->moment[0]) + size_of(found->moment[1]));
    for (int c = 0; c < 2; c++) {
        sum[c] = found->moment[0][c] + found->moment[1][c];
        half[c] = 0.5 * (found->moment[0][c] - found->moment[1][c]);
    }
    if (size_of(sum) < least) sum[0] = sum[1] = 0.0;
    if (size_of(half) < least) half[0] = half[1] = 0.0;
}

static void print_static(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    double sum[2], half[2];
    if (of->plane_count != 2) return;
    find_static(found, sum, half);
    fprintf(out, "  static: %.6g g mm at %.4g deg; couple: %.6g g mm at %.4g deg in %s, against it in %s\n",
            size_of(sum) / gram_mm, degrees_of(sum, way_of_angles(of)), size_of(half) / gram_mm,
            degrees_of(half, way_of_angles(of)), of->planes[0].name, of->planes[1].name);
}

/// "um p-p"; "um" where the file does not say how amplitudes are counted.
static const char *um_as(const whirl_balance *of) {
    static const char *const words[] = {"um 0-p", "um p-p", "um rms"};
    for (size_t i = 0; i < 3; i++)
        if (strcmp(words[i] + 3, of->counted) == 0) return words[i];
    return "um";
}

static void print_slow_roll(FILE *out, const whirl_balance *of) {
    if (of->slow_roll_count > 0) fputs("slow roll, taken off the readings:\n", out);
    for (size_t i = 0; i < of->slow_roll_count; i++)
        fprintf(out, "  %s: %.4g %s at %.4g deg\n", of->slow_rolls[i].probe, size_of(of->slow_rolls[i].vibration) / um,
                um_as(of), degrees_of(of->slow_rolls[i].vibration, way_of_phases(of)));
}

static void print_influence(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    const size_t count = found->by_set ? of->mode_count : of->plane_count;
    fprintf(out, "influence, %s a kg mm%s%s:\n", um_as(of), *of->counted ? "" : " (amplitudes as the file has them)",
            of->by_model                ? ", by the model"
            : of->coefficient_count > 0 ? ", as the file has it"
                                        : "");
    for (size_t r = 0; r < found->row_count; r++) {
        const whirl_balance_row *row = &found->rows[r];
        const char *separator = "";
        fprintf(out, "  %s at %.6g rpm:", row->probe, row->speed / rpm);
        for (size_t n = 0; n < count; n++) {
            if (found->by_set && !found->used[n]) continue;
            fprintf(out, "%s %.5g at %.4g deg (", separator, size_of(row->influence[n]) * 1e-3 / um,
                    degrees_of(row->influence[n], way_of_phases(of)));
            if (found->by_set)
                fprintf(out, "set %zu)", n + 1);
            else
                fprintf(out, "%s)", of->planes[n].name);
            separator = ",";
        }
        fputc('\n', out);
    }
    const double difference = whirl_balance_difference(of, found);
    if (isfinite(difference))
        fprintf(out, "  the model's differ from these by up to %.3g %% of the largest\n", 100.0 * difference);
}

static void print_sets(FILE *out, const whirl_balance *of, const whirl_balance_model *model,
                       const whirl_correction *found) {
    if (found->set_count == 0) return;
    fprintf(out, "sets of weights, each of one mode and of none of the others%s:\n",
            of->keep_rigid ? ", nor of the rigid rotor" : "");
    for (size_t n = 0; n < found->set_count; n++) {
        fprintf(out, "  set %zu (%.6g rpm", n + 1, of->modes[n].speed / rpm);
        if (model && !of->modes[n].shaped) fprintf(out, ", the model's mode of %.6g rpm", model->natural[n] / rpm);
        fputs("):", out);
        for (size_t p = 0; p < of->plane_count; p++) {
            const double *own = found->sets[n][p];
            fprintf(out, "%s %s", p ? "," : "", of->planes[p].name);
            if (size_of(own) > rounding)
                fprintf(out, " %.5g at %.4g deg", size_of(own), degrees_of(own, way_of_angles(of)));
            else
                fputs(" 0", out);
        }
        if (found->used[n])
            fprintf(out, "; %.6g g mm at %.4g deg of it", size_of(found->amount[n]) / gram_mm,
                    degrees_of(found->amount[n], way_of_angles(of)));
        fputc('\n', out);
    }
}

/// What the plane or set of an unknown is called.
static void name_unknown(const whirl_balance *of, size_t n, char *text, size_t size) {
    if (of->mode_count > 0)
        snprintf(text, size, "set %zu", n + 1);
    else
        snprintf(text, size, "%s", of->planes[n].name);
}

enum { SENTENCE = 512 };

/// Why a trial weight is as large as it is, and what it does.
static void explain(const whirl_balance_model *model, const whirl_correction *found, size_t n, char text[SENTENCE]) {
    const whirl_balance_proposal *own = &found->proposals[n];
    const whirl_balance_row *row = &found->rows[own->row];
    const char *at = model && *model->bearing[own->bearing] ? model->bearing[own->bearing] : "";
    char load[WHIRL_NAME_SIZE + 96] = "a tenth of the load on the bearing";
    if (own->load > 0.0)
        snprintf(load, sizeof load, "a tenth of the %.4g N on %s%s", own->load,
                 *at ? "the bearing at " : "a bearing, half of the weight", at);
    int used = 0;
    if (own->reason == WHIRL_TRIAL_BY_FORCE)
        used = snprintf(text, SENTENCE, "its force at %.6g rpm is %s", own->speed / rpm, load);
    else if (own->reason == WHIRL_TRIAL_BY_LEAST)
        used = snprintf(text, SENTENCE, "less would not be clear at %s at %.6g rpm", row->probe, row->speed / rpm);
    else if (own->reason == WHIRL_TRIAL_BY_MOST)
        used = snprintf(text, SENTENCE, "more would change %s at %.6g rpm by more than it is", row->probe,
                        row->speed / rpm);
    else if (own->reason == WHIRL_TRIAL_BY_LIMIT)
        used =
            snprintf(text, SENTENCE, "more would take %s at %.6g rpm beyond its limit", row->probe, row->speed / rpm);
    else
        snprintf(text, SENTENCE, "nothing that was read near its speed vibrates");
    if (own->reason != WHIRL_TRIAL_BY_NOTHING && isfinite(own->change))
        snprintf(text + used, SENTENCE - (size_t)used, "; it changes %s at %.6g rpm by %.3g %%", row->probe,
                 row->speed / rpm, 100.0 * own->change);
}

/// A warning by its index; false past the last.
static bool warn(const whirl_balance *of, const whirl_correction *found, size_t index, char text[SENTENCE]) {
    char name[WHIRL_NAME_SIZE];
    if (found->reduced.there && index-- == 0) {
        const size_t without = found->reduced.without;
        name_unknown(of, without, name, sizeof name);
        snprintf(text, SENTENCE,
                 "%s acts nearly as the others do (significance %.2g, below %.2g after Darlow 1982; condition %.3g): "
                 "without it %.4g um are left %s in place of %.4g um",
                 name, found->significance[without], WHIRL_BALANCE_SIGNIFICANT, found->condition,
                 found->reduced.left / um, left_as(of), found->left / um);
        return true;
    }
    for (size_t n = 0; n < found->proposal_count; n++) {
        const whirl_balance_proposal *own = &found->proposals[n];
        name_unknown(of, n, name, sizeof name);
        if (own->over < found->row_count && index-- == 0) {
            const whirl_balance_row *row = &found->rows[own->over];
            snprintf(text, SENTENCE,
                     "the trial weight of %s: the model predicts %.4g um for %s at %.6g rpm, above its limit, and "
                     "%.4g um is what it has now",
                     name, size_of(own->predicted) / um, row->probe, row->speed / rpm, size_of(row->before) / um);
            return true;
        }
        if (own->unclear && index-- == 0) {
            snprintf(text, SENTENCE,
                     "the trial weight of %s changes no probe by 30 %% and 5 times its repeatability: limits allow no "
                     "more",
                     name);
            return true;
        }
    }
    return false;
}

/// The weights without the plane or set that is hardly needed.
static void print_reduced(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    char name[WHIRL_NAME_SIZE];
    if (!found->reduced.there) return;
    name_unknown(of, found->reduced.without, name, sizeof name);
    fprintf(out, "correction without %s, which leaves %.4g um %s in place of %.4g um:\n", name,
            found->reduced.left / um, left_as(of), found->left / um);
    for (size_t p = 0; p < of->plane_count; p++) {
        if (of->mode_count == 0 && p == found->reduced.without) continue;
        fputs("  ", out);
        print_plane(out, of, p, found->reduced.moment[p]);
    }
}

static void print_proposal(FILE *out, const whirl_balance *of, const whirl_correction *found, size_t n) {
    const whirl_balance_proposal *own = &found->proposals[n];
    double moment[2];
    if (of->mode_count == 0) {
        fputs("  ", out);
        print_plane(out, of, n, own->moment);
        return;
    }
    fprintf(out, "  set %zu: %.6g g mm at %.4g deg\n", n + 1, size_of(own->moment) / gram_mm,
            degrees_of(own->moment, way_of_angles(of)));
    for (size_t p = 0; p < of->plane_count; p++) {
        whirl_balance_proposed(found, n, p, moment);
        if (!(size_of(moment) > rounding * size_of(own->moment))) continue;
        fputs("    ", out);
        print_plane(out, of, p, moment);
    }
}

static void print_proposals(FILE *out, const whirl_balance *of, const whirl_balance_model *model,
                            const whirl_correction *found) {
    char text[SENTENCE];
    if (found->proposal_count == 0) return;
    fputs("trial weights that the model proposes, each where it reduces the vibration, for a run of its own:\n", out);
    for (size_t n = 0; n < found->proposal_count; n++) {
        explain(model, found, n, text);
        print_proposal(out, of, found, n);
        fprintf(out, "    %s\n", text);
    }
}

static void print_vibration(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    fprintf(out, "vibration%s:\n", found->found ? " before and, by the coefficients, after" : "");
    for (size_t r = 0; r < found->row_count; r++) {
        const whirl_balance_row *row = &found->rows[r];
        fprintf(out, "  %s at %.6g rpm: %.4g %s at %.4g deg", row->probe, row->speed / rpm, size_of(row->before) / um,
                um_as(of), degrees_of(row->before, way_of_phases(of)));
        if (found->found) fprintf(out, ", %.4g %s", left_of(found, row) / um, um_as(of));
        if (isfinite(row->worst))
            fprintf(out, " (up to %.4g %s where critical speeds are %.3g %% off the model's)", row->worst / um,
                    um_as(of), 100.0 * of->model_error);
        fputc('\n', out);
    }
}

/// kg m in all planes together.
static double sum_of(const whirl_balance *of, const whirl_correction *found) {
    double sum = 0.0;
    for (size_t p = 0; p < of->plane_count; p++) sum += size_of(found->moment[p]);
    return sum;
}

static void print_grade(FILE *out, const whirl_balance *of, const whirl_correction *found) {
    const double allowed = whirl_balance_allowed(of), sum = sum_of(of, found);
    if (!isfinite(allowed)) return;
    fprintf(out,
            "residual unbalance allowed in all by ISO 21940-11, grade G %.4g (check which edition counts): %.6g g mm\n",
            of->grade, allowed / gram_mm);
    if (found->found)
        fprintf(out, "these weights as a residual unbalance: %.6g g mm in all, G %.4g, %s\n", sum / gram_mm,
                of->grade * sum / allowed, sum <= allowed ? "within the grade" : "beyond the grade");
}

whirl_status whirl_balance_write_summary(const whirl_balance *of, const whirl_balance_model *model,
                                         const whirl_correction *found, FILE *out) {
    char text[SENTENCE];
    if (*of->title) fprintf(out, "%s\n", of->title);
    fprintf(out, "angles are told %s the rotation from the mark, phases as %s\n", of->against ? "against" : "with",
            of->leads ? "leads" : "lags");
    print_slow_roll(out, of);
    if (found->found) print_influence(out, of, found);
    print_sets(out, of, model, found);
    if (found->found) {
        fputs(of->least_max ? "correction, by which the largest vibration is the least:\n" : "correction:\n", out);
        for (size_t p = 0; p < of->plane_count; p++) {
            fputs("  ", out);
            print_plane(out, of, p, found->moment[p]);
        }
        print_static(out, of, found);
        print_reduced(out, of, found);
    }
    print_proposals(out, of, model, found);
    print_vibration(out, of, found);
    print_grade(out, of, found);
    for (size_t i = 0; warn(of, found, i, text); i++) fprintf(out, "warning: %s\n", text);
    return whirl_ok();
}

// ---------------------------------------------------------------- for programs

static json_t *vector(bool *well, const double of[2], const char *size, double way) {
    json_t *made = json_object();
    document_put(well, made, size, document_number(size_of(of)));
    document_put(well, made, "angle", document_number(degree * degrees_of(of, way)));
    return made;
}

/// A vector for every plane.
static json_t *by_plane(bool *well, const whirl_balance *of, const double (*vectors)[2], const char *size, double way) {
    json_t *made = json_object();
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(well, made, of->planes[p].name, vector(well, vectors[p], size, way));
    return made;
}

static json_t *row_of(bool *well, const whirl_balance *of, const whirl_correction *found,
                      const whirl_balance_row *row) {
    json_t *made = json_object();
    const double way = way_of_phases(of);
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
    json_t *made = vector(well, found->moment[p], "moment", way_of_angles(of)), *holes = json_array();
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
        document_put(well, made, "mass", document_number(size_of(found->moment[p]) / of->planes[p].radius));
    document_put(well, made, "holes", holes);
    return made;
}

static json_t *set_of(bool *well, const whirl_balance *of, const whirl_balance_model *model,
                      const whirl_correction *found, size_t n) {
    json_t *made = json_object();
    const double way = way_of_angles(of);
    document_put(well, made, "speed", document_number(of->modes[n].speed));
    if (model && !of->modes[n].shaped) document_put(well, made, "natural", document_number(model->natural[n]));
    document_put(well, made, "weights", by_plane(well, of, found->sets[n], "weight", way));
    if (found->used[n]) document_put(well, made, "amount", vector(well, found->amount[n], "moment", way));
    return made;
}

static json_t *proposal_of(bool *well, const whirl_balance *of, const whirl_balance_model *model,
                           const whirl_correction *found, size_t n) {
    static const char *const reasons[] = {"force", "least", "most", "limit", "nothing"};
    const whirl_balance_proposal *own = &found->proposals[n];
    json_t *made = vector(well, own->moment, "moment", way_of_angles(of));
    double weights[WHIRL_MAX_PLANES][2];
    char text[SENTENCE];
    explain(model, found, n, text);
    for (size_t p = 0; p < of->plane_count; p++) whirl_balance_proposed(found, n, p, weights[p]);
    if (of->mode_count > 0)
        document_put(well, made, "set", json_integer((json_int_t)n + 1));
    else
        document_put(well, made, "plane", document_text(of->planes[n].name));
    document_put(well, made, "weights", by_plane(well, of, (const double(*)[2])weights, "moment", way_of_angles(of)));
    document_put(well, made, "reason", document_text(reasons[own->reason]));
    document_put(well, made, "sentence", document_text(text));
    document_put(well, made, "change", document_number(own->change));
    return made;
}

/// How needed each plane or set is, and the correction without the one that hardly is.
static void put_reduced(bool *well, json_t *all, const whirl_balance *of, const whirl_correction *found) {
    char name[WHIRL_NAME_SIZE];
    json_t *significance = json_object(), *without = json_object();
    for (size_t n = 0; n < (of->mode_count > 0 ? of->mode_count : of->plane_count); n++) {
        name_unknown(of, n, name, sizeof name);
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
    name_unknown(of, found->reduced.without, name, sizeof name);
    document_put(well, without, "name", document_text(name));
    document_put(well, without, "left", document_number(found->reduced.left));
    document_put(well, without, "correction", by_plane(well, of, found->reduced.moment, "moment", way_of_angles(of)));
    document_put(well, all, "without", without);
}

static void put_correction(bool *well, json_t *all, const whirl_balance *of, const whirl_correction *found) {
    const double allowed = whirl_balance_allowed(of), sum = sum_of(of, found), way = way_of_angles(of);
    double whole[2], half[2];
    json_t *planes = json_object();
    for (size_t p = 0; p < of->plane_count; p++)
        document_put(well, planes, of->planes[p].name, plane_of(well, of, found, p));
    document_put(well, all, "correction", planes);
    document_put(well, all, "unbalance", document_number(sum));
    put_reduced(well, all, of, found);
    if (isfinite(allowed)) document_put(well, all, "grade", document_number(of->grade * sum / allowed));
    if (of->plane_count != 2) return;
    find_static(found, whole, half);
    document_put(well, all, "static", vector(well, whole, "moment", way));
    document_put(well, all, "couple", vector(well, half, "moment", way));
}

whirl_status whirl_balance_write_json(const whirl_balance *of, const whirl_balance_model *model,
                                      const whirl_correction *found, FILE *out) {
    bool well = true;
    char text[SENTENCE];
    json_t *all = json_object(), *rows = json_array(), *sets = json_array(), *trials = json_array(),
           *warnings = json_array();
    document_put(&well, all, "title", document_text(of->title));
    document_put(&well, all, "angles", document_text(of->against ? "against" : "with"));
    document_put(&well, all, "amplitudes", *of->counted ? document_text(of->counted) : json_null());
    document_put(&well, all, "phases", document_text(of->leads ? "lead" : "lag"));
    if (of->slow_roll_count > 0) {
        json_t *rolls = json_array();
        for (size_t i = 0; i < of->slow_roll_count; i++) {
            json_t *one = vector(&well, of->slow_rolls[i].vibration, "amplitude", way_of_phases(of));
            document_put(&well, one, "probe", document_text(of->slow_rolls[i].probe));
            document_append(&well, rolls, one);
        }
        document_put(&well, all, "slow_roll", rolls);
    }
    if (found->found) put_correction(&well, all, of, found);
    for (size_t r = 0; r < found->row_count; r++)
        document_append(&well, rows, row_of(&well, of, found, &found->rows[r]));
    for (size_t n = 0; n < found->set_count; n++) document_append(&well, sets, set_of(&well, of, model, found, n));
    for (size_t n = 0; n < found->proposal_count; n++)
        document_append(&well, trials, proposal_of(&well, of, model, found, n));
    for (size_t i = 0; warn(of, found, i, text); i++) document_append(&well, warnings, document_text(text));
    document_put(&well, all, "vibration", rows);
    document_put(&well, all, "sets", sets);
    document_put(&well, all, "proposals", trials);
    document_put(&well, all, "warnings", warnings);
    document_put(&well, all, "difference", document_number(whirl_balance_difference(of, found)));
    document_put(&well, all, "allowed", document_number(whirl_balance_allowed(of)));
    if (document_write(well, all, out) && fputc('\n', out) != EOF) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON, or it cannot be written");
}
