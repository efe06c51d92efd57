#include "content.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "plan.h"
#include "whirl/engine/linear.h"

/// An eigenvalue in SI.
typedef struct eigenvalue {
    double real, imaginary;
} eigenvalue;

/// Returns the modes of a rotor; NULL without an equilibrium, or with rotating coefficients.
static whirl_modes *modes_of(const whirl_rotor *rotor) {
    const whirl_system *system = whirl_rotor_system(rotor);
    double *start = calloc(system->dimension, sizeof *start);
    whirl_modes *modes = NULL;
    if (start) {
        whirl_rotor_complete(rotor, start);
        if (whirl_modes_new(system, start, &modes).code != WHIRL_OK) modes = NULL;
    }
    free(start);
    if (!modes || modes->period == 0.0) return modes;
    whirl_modes_free(modes);
    return NULL;
}

/// Returns eigenvalue `index` in SI: modes first, then real eigenvalues.
static eigenvalue fits_eigenvalue(const whirl_modes *modes, size_t index, double clock) {
    if (index >= modes->count) return (eigenvalue){clock * modes->reals[index - modes->count], 0.0};
    return (eigenvalue){clock * modes->modes[index].real, clock * modes->modes[index].imaginary};
}

/// Finds the eigenvalue of the machine with tables at a whirl frequency that is nearest to `near`. Returns false if
/// there is none.
static bool by_tables(const case_content *content, valuation *v, eigenvalue near, eigenvalue *out) {
    const machine_choice choice = {.stages = 1.0, .asynchronous = true, .frequency = near.imaginary};
    whirl_rotor *rotor;
    double least = INFINITY;
    if (machine_build_with(&content->machine, v, 0.0, &choice, &rotor).code != WHIRL_OK) return false;
    whirl_modes *modes = whirl_rotor_hold(rotor, NULL).code == WHIRL_OK ? modes_of(rotor) : NULL;
    for (size_t i = 0; modes && i < modes->count + modes->real_count; i++) {
        const eigenvalue own = fits_eigenvalue(modes, i, whirl_rotor_clock(rotor));
        const double apart = hypot(own.real - near.real, own.imaginary - near.imaginary);
        if (apart < least) least = apart, *out = own;
    }
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
    return isfinite(least);
}

/// Returns true for a growing mode; growth within rounding counts as stable.
static bool grows(eigenvalue own, double clock) {
    return own.real > 1e-9 * (fabs(own.imaginary) + clock);
}

/// Returns the index of the eigenvalue with the largest real part below that of `last`; SIZE_MAX if there is none.
static size_t next_stable(const whirl_modes *modes, double clock, double last) {
    size_t best = SIZE_MAX;
    for (size_t i = 0; i < modes->count + modes->real_count; i++) {
        const double real = fits_eigenvalue(modes, i, clock).real;
        if (real < last && (best == SIZE_MAX || real > fits_eigenvalue(modes, best, clock).real)) best = i;
    }
    return best;
}

/// Compares the least stable eigenvalues of the functions with those of the tables, until a doubt is found.
static void fits_compare(const case_content *content, valuation *v, const whirl_rotor *moving,
                         const whirl_system *tables, char doubt[WHIRL_MESSAGE_SIZE]) {
    enum { LOOKS = 4 };
    whirl_modes *modes = modes_of(moving);
    const double clock = whirl_rotor_clock(moving);
    const double low = tables->frequencies[0], high = tables->frequencies[tables->frequency_count - 1];
    const double turn = 6.283185307179586476925;
    double last = INFINITY;
    for (int look = 0; look < LOOKS && modes && !*doubt; look++) {
        // Take the next eigenvalue of the machine with functions, by falling real part.
        const size_t index = next_stable(modes, clock, last);
        if (index == SIZE_MAX) break;
        const eigenvalue own = fits_eigenvalue(modes, index, clock);
        const bool known = own.imaginary >= low && own.imaginary <= high;
        eigenvalue other = {0.0, 0.0};
        last = own.real;
        // Raise the doubt if the eigenvalue grows at a frequency beyond the tables, or if its stability differs from
        // that with the tables.
        if (!known && grows(own, clock))
            snprintf(
                doubt, WHIRL_MESSAGE_SIZE,
                "with the rational functions that replace its bearings' tables in motions the machine is unstable, "
                "by %.4g 1/s at %.4g Hz, beyond the tables (%.4g Hz to %.4g Hz)",
                own.real, own.imaginary / turn, low / turn, high / turn);
        else if (known && by_tables(content, v, own, &other) && grows(own, clock) != grows(other, clock))
            snprintf(doubt, WHIRL_MESSAGE_SIZE,
                     "with the rational functions that replace its bearings' tables in motions a mode at %.4g Hz has "
                     "the exponent %.4g 1/s, and %.4g 1/s with the tables themselves: one is stable, the other is not",
                     own.imaginary / turn, own.real, other.real);
    }
    whirl_modes_free(modes);
}

/// Adds a note unless it exists; drops its last clause if there is no space.
static whirl_status add_fit(whirl_result *result, const char *at, char *note) {
    char name[WHIRL_NAME_SIZE], text[2 * WHIRL_MESSAGE_SIZE];
    size_t index = 0;
    const size_t room = sizeof result->facts->value - strlen(at) - 4;
    if (strlen(note) > room && strrchr(note, ';')) *strrchr(note, ';') = '\0';
    for (; *whirl_result_fit(result, index); index++)
        if (strstr(whirl_result_fit(result, index), note)) return whirl_ok();
    snprintf(name, sizeof name, "fit %zu", index + 1);
    snprintf(text, sizeof text, "%s%s%s%s", note, *at ? " (" : "", at, *at ? ")" : "");
    return whirl_result_add_fact(result, name, text);
}

static whirl_status fits_warn(const case_content *content, valuation *v, const whirl_rotor *tables, const char *at,
                              whirl_result *result, char doubt[WHIRL_MESSAGE_SIZE]) {
    char note[WHIRL_MESSAGE_SIZE];
    whirl_rotor *moving;
    whirl_status status = machine_build(&content->machine, v, true, &moving);
    if (status.code == WHIRL_OK) status = whirl_rotor_hold(moving, NULL);
    if (status.code != WHIRL_OK) {
        whirl_rotor_free(moving);
        return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    }
    for (size_t i = 0; status.code == WHIRL_OK && whirl_rotor_note(moving, i, note); i++)
        status = add_fit(result, at, note);
    if (status.code == WHIRL_OK) fits_compare(content, v, moving, whirl_rotor_system(tables), doubt);
    whirl_rotor_free(moving);
    return status;
}

/// Returns true if an element has a table over the frequency of whirl. Most cases have none, and no machine is built
/// for them.
static bool has_tables(const machine_parts *machine) {
    for (size_t i = 0; i < machine->element_count; i++)
        if (settings_find(&machine->elements[i], "frequencies")) return true;
    return false;
}

whirl_status case_tell_fits(const case_content *content, const whirl_given *given, size_t count, whirl_result *result,
                            char doubt[WHIRL_MESSAGE_SIZE]) {
    char at[PLAN_GIVEN_TEXT] = "";
    whirl_rotor *tables = NULL;
    valuation v;
    *doubt = '\0';
    if (!has_tables(&content->machine)) return whirl_ok();
    const int before = exhausted_watch();
    whirl_status status = valuation_open(&v, &content->parameters, given, count);
    if (status.code == WHIRL_OK) status = machine_build(&content->machine, &v, false, &tables);
    if (count > 0) given_text(&content->parameters, given, count, at, sizeof at);
    if (status.code == WHIRL_OK && whirl_rotor_system(tables)->frequency_count > 0)
        status = fits_warn(content, &v, tables, at, result, doubt);
    whirl_rotor_free(tables);
    valuation_close(&v);
    if (exhausted(before)) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compare tables with functions");
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}
