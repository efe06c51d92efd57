#include "command.h"

#include <stdbool.h>
#include <stdio.h>

#include "found.h"

bool found_take(int key, char *argument, const struct argp_state *state, found_arguments *arguments) {
    switch (key) {
    case KEY_FOUND_UNITS:
        arguments->units = argument;
        return true;
    case KEY_FOUND_SHEET:
        arguments->sheet = argument;
        return true;
    case KEY_FOUND_FORMAT:
        if (whirl_sheet_form_of(argument, &arguments->form).code != WHIRL_OK)
            bad_argument(state, "--format is '%s', expected text, csv, latex, markdown or json", argument);
        arguments->formed = true;
        return true;
    default:
        return false;
    }
}

void found_check(const found_arguments *arguments, const struct argp_state *state) {
    whirl_shown_units shown;
    const whirl_status status = whirl_shown_units_alone(arguments->units, &shown);
    if (status.code != WHIRL_OK) bad_argument(state, "--units: %s", status.message);
    if (arguments->formed && !arguments->sheet)
        bad_argument(state, "--format needs --sheet, the table that is printed");
}

int found_print(const whirl_findings *findings, const char *title, const found_arguments *arguments) {
    const whirl_sheet *sheet;
    if (!arguments->sheet) {
        if (*title) printf("%s\n", title);
        const whirl_status status = whirl_findings_write_text(findings, stdout);
        return status.code == WHIRL_OK ? finish_output() : complain_of(&status);
    }
    whirl_status status = whirl_findings_sheet(findings, arguments->sheet, &sheet);
    if (status.code == WHIRL_OK) status = whirl_sheet_write(sheet, arguments->form, stdout);
    return status.code == WHIRL_OK ? finish_output() : complain_of(&status);
}
