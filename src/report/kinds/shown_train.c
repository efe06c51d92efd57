// Findings on the train: inertias of stations that twist, and the shafts, couplings and gears between them.
#include <math.h>

#include "shown_kinds.h"

static const whirl_unit stiffness_unit = {.name = "kN m/rad", .size = 1e3},
                        damping_unit = {.name = "N m s/rad", .size = 1.0};

static const char *train_joint_name(const finder *of, const whirl_model_joint *own) {
    char name[2 * WHIRL_NAME_SIZE + 40];
    double row[3] = {(double)own->path.kind};
    for (size_t end = 0; end < 2; end++)
        row[1 + end] = own->path.station[end] < of->result->station_count ? (double)own->path.station[end] : -1.0;
    torque_name(of->result, row, name, sizeof name);
    return find_text(of->findings, "%s", name);
}

static void train_find_stations(const finder *of, const whirl_model *model) {
    // Set up the columns.
    double sum = 0.0;
    whirl_sheet *sheet = find_sheet(of, "train", "Inertias of the train");
    sheet->about =
        "Inertias of the stations that twist, each with its part of the shaft, at the parameters of the case. A "
        "referred inertia is multiplied by the square of the station's speed over that of the rotor.";
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "ratio", "speed over the rotor's", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "inertia", "polar inertia", WHIRL_QUANTITY_INERTIA, 6);
    sheet_column(of, sheet, "referred", "referred", WHIRL_QUANTITY_INERTIA, 6);
    // Add the stations that twist, and sum up their inertias.
    for (size_t s = 0; s < model->station_count && s < of->result->station_count; s++) {
        const whirl_model_mass *own = &model->stations[s];
        if (isnan(own->twist)) continue;
        sum += own->twist * own->turns * own->turns;
        sheet_row(of, sheet);
        cell_station(of, sheet, s);
        cell_number(of, sheet, own->turns);
        cell_number(of, sheet, own->twist);
        cell_number(of, sheet, own->twist * own->turns * own->turns);
    }
    // State the sum if there are several.
    const bool any = sheet->rows > 1;
    find_sheet_end(of);
    if (any)
        phrase_number(of, &find_statement(of, "inertia of the stations that twist, referred to the rotor")->found,
                      WHIRL_QUANTITY_INERTIA, 6, sum);
}

static void train_find_joints(const finder *of, const whirl_model *model) {
    whirl_sheet *sheet = find_sheet(of, "joints", "Shafts, couplings and gears of the train");
    sheet->about =
        "Stiffness and damping against twist, at the speed of the first station. A mesh has its mean stiffness, "
        "about the axis of the first gear; pieces of a shaft between two stations are in series. The weakest "
        "section is given as the diameter of a solid round shaft with the same section modulus.";
    sheet_texts(of, sheet, "joint", "joint");
    sheet_units(of, sheet, "stiffness", "stiffness", &stiffness_unit, 6);
    sheet_units(of, sheet, "damping", "damping", &damping_unit, 5);
    sheet_units(of, sheet, "referred", "referred stiffness", &stiffness_unit, 6);
    sheet_column(of, sheet, "diameter", "weakest section", WHIRL_QUANTITY_DIAMETER, 5);
    for (const whirl_model_joint *own = model->joints; own && own < model->joints + model->joint_count; own++) {
        const double modulus = own->path.modulus;
        sheet_row(of, sheet);
        cell_text(of, sheet, train_joint_name(of, own));
        cell_number(of, sheet, own->stiffness);
        cell_number(of, sheet, own->damping);
        cell_number(of, sheet, own->stiffness * own->turns * own->turns);
        cell_number(of, sheet, modulus > 0.0 ? cbrt(modulus / 0.19634954084936207740) : (double)NAN); // pi/16
    }
    find_sheet_end(of);
}

void find_train(const finder *of, const whirl_model *model) {
    train_find_stations(of, model);
    train_find_joints(of, model);
}
