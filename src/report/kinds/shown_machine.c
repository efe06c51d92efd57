// Findings on the machine, as its case gives it: weight, shafts with their sections, stations, and parts.
#include <math.h>

#include "findings_render.h"
#include "shown_kinds.h"

static void machine_find_shafts(const finder *of, const whirl_model *model, const whirl_shaft_summary *shafts,
                                size_t count) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "shafts", "Shafts of finite elements");
    sheet->about = "Timoshenko elements. Reduced shafts keep their stations and some modes of a plane; the errors are "
                   "those against the full model: of the lowest free-free frequencies, and of static displacements.";
    sheet_texts(of, sheet, "shaft", "shaft");
    sheet_column(of, sheet, "length", "length", WHIRL_QUANTITY_POSITION, 6);
    sheet_column(of, sheet, "mass", "mass", WHIRL_QUANTITY_MASS, 6);
    sheet_column(of, sheet, "total", "with what is on it", WHIRL_QUANTITY_MASS, 6);
    sheet_column(of, sheet, "centre", "centre of mass at", WHIRL_QUANTITY_POSITION, 6);
    sheet_column(of, sheet, "elements", "elements", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "nodes", "nodes", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "modes", "modes kept", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "all_modes", "of all modes", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "frequency_error", "error of frequencies", WHIRL_QUANTITY_NUMBER, 1);
    sheet_column(of, sheet, "flexibility_error", "error of displacements", WHIRL_QUANTITY_NUMBER, 1);
    // Add a row for each shaft; those that are not reduced have no modes and errors.
    for (const whirl_shaft_summary *own = shafts; own < shafts + count; own++) {
        const whirl_model_total *total = &model->shafts[own - shafts];
        const double last[] = {(double)own->modes, (double)own->all_modes, own->frequency_error,
                               own->flexibility_error};
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", own->name));
        cell_number(of, sheet, own->length);
        cell_number(of, sheet, own->mass);
        cell_number(of, sheet, total->mass);
        cell_number(of, sheet, total->centre);
        cell_number(of, sheet, (double)own->elements);
        cell_number(of, sheet, (double)own->nodes);
        for (size_t i = 0; i < sizeof last / sizeof *last; i++)
            cell_number(of, sheet, own->reduced ? last[i] : (double)NAN);
    }
    find_sheet_end(of);
}

static void machine_find_sections(const finder *of, const whirl_model *model, const whirl_shaft_summary *shafts) {
    // Set up the columns.
    static const char *const keys[] = {"outer", "outer_end", "inner", "inner_end"};
    static const char *const headings[] = {"outer diameter", "outer at its end", "inner diameter", "inner at its end"};
    whirl_sheet *sheet = find_sheet(of, "sections", "Sections of the shafts");
    sheet_texts(of, sheet, "shaft", "shaft");
    sheet_column(of, sheet, "from", "from", WHIRL_QUANTITY_POSITION, 6);
    sheet_column(of, sheet, "to", "to", WHIRL_QUANTITY_POSITION, 6);
    sheet_column(of, sheet, "length", "length", WHIRL_QUANTITY_DIAMETER, 6);
    for (size_t i = 0; i < 4; i++) sheet_column(of, sheet, keys[i], headings[i], WHIRL_QUANTITY_DIAMETER, 6);
    sheet_column(of, sheet, "mass", "mass", WHIRL_QUANTITY_MASS, 6);
    // Add a row for each section; a cylinder has no second pair of diameters.
    for (const whirl_model_section *own = model->sections; own < model->sections + model->section_count; own++) {
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", shafts[own->shaft].name));
        cell_number(of, sheet, own->from);
        cell_number(of, sheet, own->to);
        cell_number(of, sheet, own->to - own->from);
        cell_number(of, sheet, own->outer[0]);
        cell_number(of, sheet, own->outer[1] != own->outer[0] ? own->outer[1] : (double)NAN);
        cell_number(of, sheet, own->inner[0]);
        cell_number(of, sheet, own->inner[1] != own->inner[0] ? own->inner[1] : (double)NAN);
        cell_number(of, sheet, own->mass);
    }
    find_sheet_end(of);
}

static void machine_find_stations(const finder *of, const whirl_model *model, const whirl_shaft_summary *shafts,
                                  size_t count) {
    // Set up the columns; a single shaft needs no name.
    whirl_sheet *sheet = find_sheet(of, "stations", "Stations");
    sheet->about = "Masses and inertias in addition to those of the shaft, at the parameters of the case.";
    sheet_texts(of, sheet, "station", "station");
    if (count > 1) sheet_texts(of, sheet, "shaft", "shaft");
    sheet_column(of, sheet, "position", "position along its shaft", WHIRL_QUANTITY_POSITION, 6);
    sheet_column(of, sheet, "mass", "mass", WHIRL_QUANTITY_MASS, 6);
    sheet_column(of, sheet, "polar", "polar inertia", WHIRL_QUANTITY_INERTIA, 6);
    sheet_column(of, sheet, "diametral", "diametral inertia", WHIRL_QUANTITY_INERTIA, 6);
    // Add the stations with a mass or on a shaft; stations that only twist are in the sheet of the train.
    for (size_t s = 0; s < model->station_count && s < of->result->station_count; s++) {
        const whirl_model_mass *own = &model->stations[s];
        const bool on_shaft = own->shaft < count;
        if (!on_shaft && own->mass == 0.0) continue;
        sheet_row(of, sheet);
        cell_station(of, sheet, s);
        if (count > 1) cell_text(of, sheet, on_shaft ? find_text(of->findings, "%s", shafts[own->shaft].name) : "");
        cell_number(of, sheet, on_shaft ? own->position : (double)NAN);
        cell_number(of, sheet, own->mass);
        cell_number(of, sheet, own->polar);
        cell_number(of, sheet, own->diametral);
    }
    find_sheet_end(of);
}

void find_machine(const finder *of) {
    whirl_model model;
    whirl_shaft_summary shafts[WHIRL_MAX_SHAFTS];
    size_t count = 0;
    char weight[SENTENCE_SIZE];
    whirl_shown_sentence(of->units, whirl_result_fact(of->result, "weight"), weight, sizeof weight);
    if (*weight) phrase_text(of, &find_statement(of, "weight")->found, "%s", weight);
    if (!of->machine || whirl_case_model(of->machine, &model).code != WHIRL_OK) return;
    if (whirl_case_shafts(of->machine, shafts, &count).code != WHIRL_OK || count != model.shaft_count) count = 0;
    machine_find_shafts(of, &model, shafts, count);
    if (count > 0) machine_find_sections(of, &model, shafts);
    machine_find_stations(of, &model, shafts, count);
    find_bearings(of, &model);
    find_train(of, &model);
    whirl_model_free(&model);
}
