// Findings of a balancing job: influence coefficients, weights, trial weights, vibration before and after, limits.
#include "balance_parts.h"
#include "findings_render.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "findings_build.h"
#include "unit_words.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

static const double degree = 3.14159265358979323846 / 180.0, rounding = 1e-9;

double balance_size(const double vector[2]) {
    return hypot(vector[0], vector[1]);
}

double balance_degrees(const double vector[2], double way) {
    const double angle = fmod(way * atan2(vector[1], vector[0]) / degree + 360.0, 360.0);
    return angle > 1e-9 && angle < 360.0 - 1e-9 ? angle : 0.0;
}

double balance_way_of_angles(const whirl_balance *of) {
    return of->against ? -1.0 : 1.0;
}

double balance_way_of_phases(const whirl_balance *of) {
    return of->leads ? 1.0 : -1.0;
}

void balance_static(const whirl_correction *found, double sum[2], double half[2]) {
    const double least = rounding * (balance_size(found->moment[0]) + balance_size(found->moment[1]));
    for (int c = 0; c < 2; c++) {
        sum[c] = found->moment[0][c] + found->moment[1][c];
        half[c] = 0.5 * (found->moment[0][c] - found->moment[1][c]);
    }
    if (balance_size(sum) < least) sum[0] = sum[1] = 0.0;
    if (balance_size(half) < least) half[0] = half[1] = 0.0;
}

double balance_sum(const whirl_balance *of, const whirl_correction *found) {
    double sum = 0.0;
    for (size_t p = 0; p < of->plane_count; p++) sum += balance_size(found->moment[p]);
    return sum;
}

void balance_name(const whirl_balance *of, size_t n, char *text, size_t size) {
    if (of->mode_count > 0)
        snprintf(text, size, "set %zu", n + 1);
    else
        snprintf(text, size, "%s", of->planes[n].name);
}

// ---------------------------------------------------------------- the view of a job

/// A balancing job, its result, and the units in which it is shown.
typedef struct balance_view {
    finder to;
    whirl_shown_units units;
    const whirl_balance *of;
    const whirl_balance_model *model;
    const whirl_correction *found;
    whirl_unit amplitude, influence; ///< units of vibrations, and of influence coefficients
} balance_view;

static const whirl_table balance_alone = {.name = "balance"};

/// Returns the unit of vibrations: a length in the requested unit, counted (peak, peak to peak, rms) as requested, or
/// else as in the file.
static whirl_unit amplitude_unit(const balance_view *v, const char *asked) {
    const whirl_unit *length = &v->units.of[WHIRL_QUANTITY_LENGTH];
    unit_choice choice;
    whirl_unit unit = {.size = length->size};
    if (unit_choice_read(asked, &choice).code != WHIRL_OK) choice = (unit_choice){0};
    const unit_word *word = choice.of[UNIT_AMPLITUDE];
    if (!word) word = unit_of_system(choice.of[UNIT_SYSTEM], UNIT_AMPLITUDE);
    const char *counted = v->of->counted;
    if (word && *counted) {
        unit.size *= v->of->kind / word->size;
        counted = word->shown;
    }
    snprintf(unit.name, sizeof unit.name, "%.40s%s%.7s", length->name, *counted ? " " : "", counted);
    return unit;
}

/// Returns the unit of influence coefficients: vibration over unbalance, by default in kg mm.
static whirl_unit influence_unit(const balance_view *v) {
    const whirl_unit *weight = &v->units.of[WHIRL_QUANTITY_UNBALANCE];
    whirl_unit unit = {.size = v->amplitude.size / weight->size};
    snprintf(unit.name, sizeof unit.name, "%.30s/(%.20s)", v->amplitude.name, weight->name);
    return unit;
}

static whirl_status view_begin(balance_view *v, const whirl_balance *of, const whirl_balance_model *model,
                               const whirl_correction *found, const char *units) {
    const char *const asked = units ? units : of->units;
    *v = (balance_view){.of = of, .model = model, .found = found};
    const whirl_status status = whirl_shown_units_alone(asked, &v->units);
    if (status.code != WHIRL_OK) return status;
    v->amplitude = amplitude_unit(v, asked);
    v->influence = influence_unit(v);
    v->to = (finder){find_begin(), &v->units, NULL, &balance_alone, NULL};
    return v->to.findings ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
}

/// Returns the residual vibration of a row; 0 if it is a rounding error of the largest vibration.
static double left_of(const whirl_correction *found, const whirl_balance_row *row) {
    const double after = balance_size(row->after);
    double largest = 0.0;
    for (size_t r = 0; r < found->row_count; r++) largest = fmax(largest, balance_size(found->rows[r].before));
    return after > rounding * largest && largest > 0.0 ? after : 0.0;
}

static void phrase_amplitude(const balance_view *v, whirl_phrase *phrase, double value) {
    phrase_unit(&v->to, phrase, &v->amplitude, 4, value);
}

/// Writes a probe and a speed: "p2 at 3000 rpm".
static void phrase_row(const balance_view *v, whirl_phrase *phrase, const char *probe, double speed) {
    phrase_text(&v->to, phrase, "%s at ", probe);
    phrase_number(&v->to, phrase, WHIRL_QUANTITY_SPEED, 6, speed);
}

static void phrase_moment(const balance_view *v, whirl_phrase *phrase, const double moment[2]) {
    phrase_number(&v->to, phrase, WHIRL_QUANTITY_RESIDUAL, 6, balance_size(moment));
    phrase_text(&v->to, phrase, " at %.4g deg", balance_degrees(moment, balance_way_of_angles(v->of)));
}

/// Writes the vibration that remains if a plane or weight set is left out: "2.028 um in the mean square in place
/// of 1.067 um".
static void phrase_left(const balance_view *v, whirl_phrase *phrase) {
    phrase_amplitude(v, phrase, v->found->reduced.left);
    phrase_text(&v->to, phrase, " %s in place of ", v->of->least_max ? "at most" : "in the mean square");
    phrase_amplitude(v, phrase, v->found->left);
}

// ---------------------------------------------------------------- sentences

/// Writes the limit of a trial weight's force: a tenth of the load on a bearing.
static void phrase_load(const balance_view *v, const whirl_balance_proposal *own, whirl_phrase *phrase) {
    const char *at = v->model && *v->model->bearing[own->bearing] ? v->model->bearing[own->bearing] : "";
    if (!(own->load > 0.0)) {
        phrase_text(&v->to, phrase, "a tenth of the load on the bearing");
        return;
    }
    phrase_text(&v->to, phrase, "a tenth of the ");
    phrase_number(&v->to, phrase, WHIRL_QUANTITY_FORCE, 4, own->load);
    phrase_text(&v->to, phrase, " on %s%s", *at ? "the bearing at " : "a bearing, half of the weight", at);
}

/// Writes why a trial weight has its size, and its expected effect.
static void phrase_reason(const balance_view *v, size_t n, whirl_phrase *phrase) {
    const finder *to = &v->to;
    const whirl_balance_proposal *own = &v->found->proposals[n];
    if (own->reason == WHIRL_TRIAL_BY_NOTHING) {
        phrase_text(to, phrase, "no vibration was read near its speed");
        return;
    }
    // State what limits the size: a force, the least clear change, the largest change, or a limit of vibration.
    const whirl_balance_row *row = &v->found->rows[own->row];
    if (own->reason == WHIRL_TRIAL_BY_FORCE) {
        phrase_text(to, phrase, "its force at ");
        phrase_number(to, phrase, WHIRL_QUANTITY_SPEED, 6, own->speed);
        phrase_text(to, phrase, " is ");
        phrase_load(v, own, phrase);
    } else {
        phrase_text(to, phrase,
                    own->reason == WHIRL_TRIAL_BY_MIN   ? "a smaller one would not be clear at "
                    : own->reason == WHIRL_TRIAL_BY_MAX ? "a larger one would change "
                                                        : "a larger one would take ");
        phrase_row(v, phrase, row->probe, row->speed);
        phrase_text(to, phrase, "%s",
                    own->reason == WHIRL_TRIAL_BY_MIN   ? ""
                    : own->reason == WHIRL_TRIAL_BY_MAX ? " by more than its vibration"
                                                        : " beyond its limit");
    }
    // Add the expected change at that row.
    if (!isfinite(own->change)) return;
    phrase_text(to, phrase, "; this weight changes ");
    phrase_row(v, phrase, row->probe, row->speed);
    phrase_text(to, phrase, " by ");
    phrase_number(to, phrase, WHIRL_QUANTITY_PERCENT, 3, 100.0 * own->change);
}

static void phrase_needless(const balance_view *v, whirl_phrase *phrase) {
    const whirl_correction *found = v->found;
    char name[WHIRL_NAME_SIZE];
    balance_name(v->of, found->reduced.without, name, sizeof name);
    phrase_text(&v->to, phrase,
                "%s acts nearly as the others do (significance %.2g, below %.2g after Darlow 1982; condition %.3g): "
                "without it ",
                name, found->significance[found->reduced.without], WHIRL_BALANCE_SIGNIFICANT, found->condition);
    phrase_amplitude(v, phrase, found->reduced.left);
    phrase_text(&v->to, phrase, " are left %s in place of ", v->of->least_max ? "at most" : "in the mean square");
    phrase_amplitude(v, phrase, found->left);
}

/// Writes a warning by its index; returns false past the last.
static bool phrase_warning(const balance_view *v, size_t index, whirl_phrase *phrase) {
    const whirl_correction *found = v->found;
    char name[WHIRL_NAME_SIZE];
    // The first warning says that a plane or set could be left out.
    if (found->reduced.there && index-- == 0) {
        phrase_needless(v, phrase);
        return true;
    }
    // Each trial weight may have a warning of its limit, and one of an unclear effect.
    for (size_t n = 0; n < found->proposal_count; n++) {
        const whirl_balance_proposal *own = &found->proposals[n];
        balance_name(v->of, n, name, sizeof name);
        if (own->over < found->row_count && index-- == 0) {
            const whirl_balance_row *row = &found->rows[own->over];
            phrase_text(&v->to, phrase, "the trial weight of %s: the model predicts ", name);
            phrase_amplitude(v, phrase, balance_size(own->predicted));
            phrase_text(&v->to, phrase, " for ");
            phrase_row(v, phrase, row->probe, row->speed);
            phrase_text(&v->to, phrase, ", above its limit, and ");
            phrase_amplitude(v, phrase, balance_size(row->before));
            phrase_text(&v->to, phrase, " is what it has now");
            return true;
        }
        if (own->unclear && index-- == 0) {
            phrase_text(&v->to, phrase,
                        "the trial weight of %s changes no probe by 30 %% and 5 times its repeatability: limits allow "
                        "no more",
                        name);
            return true;
        }
    }
    return false;
}

static bool phrase_taken(balance_view *v, const whirl_phrase *phrase, char text[STATEMENT_SIZE]) {
    const bool well = !v->to.findings->failed;
    if (well) whirl_phrase_text(phrase, text, STATEMENT_SIZE);
    whirl_findings_free(v->to.findings);
    return well;
}

bool balance_reason_text(const whirl_balance *of, const whirl_balance_model *model, const whirl_correction *found,
                         const char *units, size_t n, char text[STATEMENT_SIZE]) {
    balance_view v;
    whirl_phrase phrase = {0};
    *text = '\0';
    if (view_begin(&v, of, model, found, units).code != WHIRL_OK) return false;
    phrase_reason(&v, n, &phrase);
    return phrase_taken(&v, &phrase, text);
}

bool balance_warning_text(const whirl_balance *of, const whirl_correction *found, const char *units, size_t index,
                          char text[STATEMENT_SIZE]) {
    balance_view v;
    whirl_phrase phrase = {0};
    *text = '\0';
    if (view_begin(&v, of, NULL, found, units).code != WHIRL_OK) return false;
    phrase_warning(&v, index, &phrase);
    return phrase_taken(&v, &phrase, text);
}

// ---------------------------------------------------------------- statements

static void find_conventions(const balance_view *v) {
    const whirl_balance *of = v->of;
    phrase_text(&v->to, &find_statement(&v->to, "angles")->found, "%s the rotation from the mark, phases as %s",
                of->against ? "against" : "with", of->leads ? "leads" : "lags");
    if (!*of->counted)
        phrase_text(&v->to, &find_statement(&v->to, "amplitudes")->found,
                    "as the file has them, which does not say 0-p, p-p or rms");
    if (!v->found->found) return;
    if (of->by_model || of->coefficient_count > 0)
        phrase_text(&v->to, &find_statement(&v->to, "influence")->found,
                    of->by_model ? "by the model" : "as the file has it");
    const double difference = whirl_balance_difference(of, v->found);
    if (isfinite(difference))
        phrase_text(&v->to, &find_statement(&v->to, "influence by the model")->found,
                    "differs by up to %.3g %% of the largest from that of runs", 100.0 * difference);
}

static void find_correction_statements(const balance_view *v) {
    const whirl_balance *of = v->of;
    double sum[2], half[2];
    if (!v->found->found) return;
    // Name the criterion, and for two planes the static part and the couple.
    if (of->least_max)
        phrase_text(&v->to, &find_statement(&v->to, "correction")->found, "minimizes the largest vibration");
    if (of->plane_count == 2) {
        balance_static(v->found, sum, half);
        whirl_phrase *phrase = &find_statement(&v->to, "static part of the correction")->found;
        phrase_moment(v, phrase, sum);
        phrase = &find_statement(&v->to, "couple of the correction")->found;
        phrase_moment(v, phrase, half);
        phrase_text(&v->to, phrase, " in %s, the opposite in %s", of->planes[0].name, of->planes[1].name);
    }
    // State how far off the vibration may be, and what a simpler correction would leave.
    if (v->found->row_count > 0 && isfinite(v->found->rows[0].worst))
        phrase_text(&v->to, &find_statement(&v->to, "vibration after, at most")->found,
                    "where critical speeds are %.3g %% off the model's", 100.0 * of->model_error);
    if (v->found->reduced.there) {
        char name[WHIRL_NAME_SIZE];
        balance_name(of, v->found->reduced.without, name, sizeof name);
        const char *const what = find_text(v->to.findings, "correction without %s", name);
        whirl_phrase *phrase = &find_statement(&v->to, what)->found;
        phrase_text(&v->to, phrase, "leaves ");
        phrase_left(v, phrase);
    }
}

static void find_grade(const balance_view *v) {
    const whirl_balance *of = v->of;
    const double allowed = whirl_balance_allowed(of), sum = balance_sum(of, v->found);
    if (!isfinite(allowed)) return;
    const bool within = sum <= allowed;
    whirl_statement *own = v->found->found ? find_judgement(&v->to, "residual unbalance of the rotor as it is",
                                                            "ISO 21940-11", within ? WHIRL_HOLDS : WHIRL_FAILS)
                                           : find_statement(&v->to, "residual unbalance");
    phrase_text(&v->to, &own->asked, "grade G %.4g of ISO 21940-11 (check which edition counts), ", of->grade);
    phrase_number(&v->to, &own->asked, WHIRL_QUANTITY_RESIDUAL, 6, allowed);
    phrase_text(&v->to, &own->asked, " in all");
    own->clause = "ISO 21940-11";
    if (!v->found->found) return;
    phrase_text(&v->to, &own->found, "G %.4g, ", of->grade * sum / allowed);
    phrase_number(&v->to, &own->found, WHIRL_QUANTITY_RESIDUAL, 6, sum);
    phrase_text(&v->to, &own->found, " in all by these weights");
    phrase_text(&v->to, &own->judged, ", %s the grade", within ? "within" : "beyond");
}

static void find_reasons(const balance_view *v) {
    char name[WHIRL_NAME_SIZE];
    for (size_t n = 0; n < v->found->proposal_count; n++) {
        balance_name(v->of, n, name, sizeof name);
        phrase_reason(v, n, &find_statement(&v->to, find_text(v->to.findings, "trial weight of %s", name))->found);
    }
}

static void find_warnings(const balance_view *v) {
    whirl_phrase phrase = {0};
    for (size_t i = 0; phrase_warning(v, i, &phrase); i++) {
        find_statement(&v->to, "warning")->found = phrase;
        phrase.count = 0;
    }
}

// ---------------------------------------------------------------- sheets

static const char *phase_word(const balance_view *v) {
    return v->of->leads ? "lead" : "lag";
}

static void cell_phase(const balance_view *v, whirl_sheet *sheet, const double vector[2]) {
    cell_number(&v->to, sheet, balance_degrees(vector, balance_way_of_phases(v->of)));
}

static void cell_angle(const balance_view *v, whirl_sheet *sheet, const double vector[2]) {
    cell_number(&v->to, sheet, balance_degrees(vector, balance_way_of_angles(v->of)));
}

static void find_slow_roll(const balance_view *v) {
    const finder *to = &v->to;
    whirl_sheet *sheet = find_sheet(to, "slow-roll", "Slow roll, subtracted from the readings");
    sheet_texts(to, sheet, "probe", "probe");
    sheet_units(to, sheet, "amplitude", "amplitude", &v->amplitude, 4);
    sheet_column(to, sheet, "phase", phase_word(v), WHIRL_QUANTITY_DEGREES, 4);
    for (size_t i = 0; i < v->of->slow_roll_count; i++) {
        const whirl_balance_vibration *roll = &v->of->slow_rolls[i];
        sheet_row(to, sheet);
        cell_text(to, sheet, find_text(to->findings, "%s", roll->probe));
        cell_number(to, sheet, balance_size(roll->vibration));
        cell_phase(v, sheet, roll->vibration);
    }
    find_sheet_end(to);
}

static void find_influence(const balance_view *v) {
    const finder *to = &v->to;
    const whirl_correction *found = v->found;
    const size_t count = found->by_set ? v->of->mode_count : v->of->plane_count;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(to, "influence", "Influence coefficients");
    sheet_texts(to, sheet, "probe", "probe");
    sheet_column(to, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_texts(to, sheet, "of", "of");
    sheet_units(to, sheet, "amplitude", "amplitude", &v->influence, 5);
    sheet_column(to, sheet, "phase", phase_word(v), WHIRL_QUANTITY_DEGREES, 4);
    // Add a row for each reading and each plane, or each used set.
    for (size_t r = 0; r < found->row_count && found->found; r++)
        for (size_t n = 0; n < count; n++) {
            const whirl_balance_row *row = &found->rows[r];
            char name[WHIRL_NAME_SIZE];
            if (found->by_set && !found->used[n]) continue;
            balance_name(v->of, n, name, sizeof name);
            sheet_row(to, sheet);
            cell_text(to, sheet, find_text(to->findings, "%s", row->probe));
            cell_number(to, sheet, row->speed);
            cell_text(to, sheet, find_text(to->findings, "%s", found->by_set ? name : v->of->planes[n].name));
            cell_number(to, sheet, balance_size(row->influence[n]));
            cell_phase(v, sheet, row->influence[n]);
        }
    find_sheet_end(to);
}

static void find_sets(const balance_view *v) {
    const finder *to = &v->to;
    const whirl_correction *found = v->found;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(to, "sets",
                                    v->of->keep_rigid ? "Sets of weights, each of one mode, of none of "
                                                        "the others and not of the rigid rotor"
                                                      : "Sets of weights, each of one mode and of none of "
                                                        "the others");
    sheet_column(to, sheet, "set", "set", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(to, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(to, sheet, "natural", "the model's mode of", WHIRL_QUANTITY_SPEED, 6);
    sheet_texts(to, sheet, "plane", "plane");
    sheet_column(to, sheet, "weight", "weight", WHIRL_QUANTITY_NUMBER, 5);
    sheet_column(to, sheet, "angle", "angle", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(to, sheet, "amount", "times", WHIRL_QUANTITY_RESIDUAL, 6);
    sheet_column(to, sheet, "amount_angle", "turned by", WHIRL_QUANTITY_DEGREES, 4);
    // Add a row for each set and plane: its weight at unit amount, then how much of the set is used.
    for (size_t n = 0; n < found->set_count; n++)
        for (size_t p = 0; p < v->of->plane_count; p++) {
            const double *own = found->sets[n][p];
            const bool none = !(balance_size(own) > rounding);
            sheet_row(to, sheet);
            cell_number(to, sheet, (double)n + 1.0);
            cell_number(to, sheet, v->of->modes[n].speed);
            cell_number(to, sheet, v->model && !v->of->modes[n].shaped ? v->model->natural[n] : (double)NAN);
            cell_text(to, sheet, find_text(to->findings, "%s", v->of->planes[p].name));
            cell_number(to, sheet, none ? 0.0 : balance_size(own));
            cell_number(to, sheet, none ? 0.0 : balance_degrees(own, balance_way_of_angles(v->of)));
            if (!found->used[n]) continue;
            cell_number(to, sheet, balance_size(found->amount[n]));
            cell_angle(v, sheet, found->amount[n]);
        }
    find_sheet_end(to);
}

static void sheet_weights(const balance_view *v, whirl_sheet *sheet) {
    const finder *to = &v->to;
    sheet_texts(to, sheet, "plane", "plane");
    sheet_column(to, sheet, "moment", "moment", WHIRL_QUANTITY_RESIDUAL, 6);
    sheet_column(to, sheet, "angle", "angle", WHIRL_QUANTITY_DEGREES, 4);
    sheet_column(to, sheet, "mass", "mass", WHIRL_QUANTITY_WEIGHT, 5);
    sheet_column(to, sheet, "radius", "at a radius of", WHIRL_QUANTITY_DIAMETER, 4);
    sheet_column(to, sheet, "hole", "hole", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(to, sheet, "hole_moment", "there", WHIRL_QUANTITY_RESIDUAL, 6);
    sheet_column(to, sheet, "second_hole", "and hole", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(to, sheet, "second_hole_moment", "there", WHIRL_QUANTITY_RESIDUAL, 6);
}

static void cells_weight(const balance_view *v, whirl_sheet *sheet, size_t p, const double moment[2]) {
    const finder *to = &v->to;
    const whirl_balance_plane *plane = &v->of->planes[p];
    int hole[2];
    double moments[2];
    cell_text(to, sheet, find_text(to->findings, "%s", plane->name));
    cell_number(to, sheet, balance_size(moment));
    cell_angle(v, sheet, moment);
    cell_number(to, sheet, plane->radius > 0.0 ? balance_size(moment) / plane->radius : (double)NAN);
    cell_number(to, sheet, plane->radius > 0.0 ? plane->radius : (double)NAN);
    if (plane->holes <= 0) return;
    whirl_balance_split(v->of, p, moment, hole, moments);
    for (size_t k = 0; k < 2 && (k == 0 || moments[k] > 0.0); k++) {
        cell_number(to, sheet, (double)hole[k]);
        cell_number(to, sheet, moments[k]);
    }
}

static void find_correction(const balance_view *v) {
    const finder *to = &v->to;
    const whirl_correction *found = v->found;
    char name[WHIRL_NAME_SIZE];
    if (!found->found) return;
    whirl_sheet *sheet = find_sheet(to, "correction", "Correction");
    sheet_weights(v, sheet);
    for (size_t p = 0; p < v->of->plane_count; p++) {
        sheet_row(to, sheet);
        cells_weight(v, sheet, p, found->moment[p]);
    }
    if (!found->reduced.there) return;
    balance_name(v->of, found->reduced.without, name, sizeof name);
    sheet = find_sheet(to, "without", find_text(to->findings, "Correction without %s", name));
    sheet_weights(v, sheet);
    for (size_t p = 0; p < v->of->plane_count; p++) {
        if (v->of->mode_count == 0 && p == found->reduced.without) continue;
        sheet_row(to, sheet);
        cells_weight(v, sheet, p, found->reduced.moment[p]);
    }
    find_sheet_end(to);
}

static void find_proposals(const balance_view *v) {
    const finder *to = &v->to;
    const whirl_correction *found = v->found;
    const bool sets = v->of->mode_count > 0;
    // Set up the columns.
    whirl_sheet *sheet =
        find_sheet(to, "proposals", "Trial weights that the model proposes, each for a run of its own");
    sheet->about = "Each stands where it reduces the vibration.";
    if (sets) {
        sheet_column(to, sheet, "set", "set", WHIRL_QUANTITY_NUMBER, 3);
        sheet_column(to, sheet, "amount", "times", WHIRL_QUANTITY_RESIDUAL, 6);
        sheet_column(to, sheet, "amount_angle", "turned by", WHIRL_QUANTITY_DEGREES, 4);
    }
    sheet_weights(v, sheet);
    // Add a row for each proposal; for a set, one for each plane with a weight.
    for (size_t n = 0; n < found->proposal_count; n++) {
        const whirl_balance_proposal *own = &found->proposals[n];
        double moment[2];
        for (size_t p = 0; p < v->of->plane_count; p++) {
            whirl_balance_proposed(found, n, p, moment);
            if (sets ? !(balance_size(moment) > rounding * balance_size(own->moment)) : p != n) continue;
            sheet_row(to, sheet);
            if (sets) {
                cell_number(to, sheet, (double)n + 1.0);
                cell_number(to, sheet, balance_size(own->moment));
                cell_angle(v, sheet, own->moment);
            }
            cells_weight(v, sheet, p, sets ? moment : own->moment);
        }
    }
    find_sheet_end(to);
}

static void find_vibration(const balance_view *v) {
    const finder *to = &v->to;
    const whirl_correction *found = v->found;
    // Set up the columns.
    whirl_sheet *sheet =
        find_sheet(to, "vibration", found->found ? "Vibration before and, by the coefficients, after" : "Vibration");
    sheet_texts(to, sheet, "probe", "probe");
    sheet_column(to, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_units(to, sheet, "before", "before", &v->amplitude, 4);
    sheet_column(to, sheet, "phase", phase_word(v), WHIRL_QUANTITY_DEGREES, 4);
    sheet_units(to, sheet, "after", "after", &v->amplitude, 4);
    sheet_units(to, sheet, "worst", "after, at most", &v->amplitude, 4);
    // Add a row for each reading.
    for (size_t r = 0; r < found->row_count; r++) {
        const whirl_balance_row *row = &found->rows[r];
        sheet_row(to, sheet);
        cell_text(to, sheet, find_text(to->findings, "%s", row->probe));
        cell_number(to, sheet, row->speed);
        cell_number(to, sheet, balance_size(row->before));
        cell_phase(v, sheet, row->before);
        cell_number(to, sheet, found->found ? left_of(found, row) : (double)NAN);
        cell_number(to, sheet, row->worst);
    }
    find_sheet_end(to);
}

whirl_status whirl_balance_findings(const whirl_balance *of, const whirl_balance_model *model,
                                    const whirl_correction *found, const char *units, whirl_findings **findings) {
    balance_view v;
    *findings = NULL;
    const whirl_status status = view_begin(&v, of, model, found, units);
    if (status.code != WHIRL_OK) return status;
    find_conventions(&v);
    find_grade(&v);
    find_correction_statements(&v);
    find_reasons(&v);
    find_warnings(&v);
    find_slow_roll(&v);
    find_influence(&v);
    find_sets(&v);
    find_correction(&v);
    find_proposals(&v);
    find_vibration(&v);
    return find_made(v.to.findings, findings);
}
