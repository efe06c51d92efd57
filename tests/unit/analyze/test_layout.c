// The block of a point: where its numbers lie and what they are.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "synthetic.h"

enum { REVOLUTIONS = 40, STEPS = 32 };

static const whirl_probe probes[] = {
    {.name = "disc", .x = 0, .y = 1, .vx = 4, .vy = 5},
    {.name = "journal", .x = 2, .y = 3, .vx = 6, .vy = 7, .clearance = 0.5},
};

static const whirl_system machine = {
    .dimension = 8, .period = 1.0, .contact_count = 1, .probe_count = 2, .probes = probes};

static whirl_integrate_options steps(void) {
    whirl_integrate_options options = {.steps_per_revolution = STEPS};
    return options;
}

static whirl_record_options options_for_test(void) {
    whirl_record_options options = whirl_record_default();
    options.record = REVOLUTIONS;
    options.samples_per_revolution = 16;
    options.waveform_revolutions = 3;
    options.spectra = true;
    options.growth = WHIRL_GROWTH_ALL;
    return options;
}

/// Returns true if a text has one of some words.
static bool has_one_of(const char *text, const char *const *words) {
    while (*words && !strstr(text, *words)) words++;
    return *words != NULL;
}

/// The meaning of every length and force names its convention (0-p, from the centre, ...). Amplitudes of sinusoids have
/// the convention that a reader may change (p-p, rms).
static void meanings_name_the_convention_of_lengths(void **state) {
    (void)state;
    static const char *const lengths[] = {"0-p",
                                          "from the centre",
                                          "radial",
                                          "upwards",
                                          "bearings here",
                                          "from the equilibrium to another one",
                                          "axial displacement",
                                          NULL};
    static const char *const forces[] = {"at any instant", "at rest", NULL}, *const relative[] = {"relative", NULL};
    static const char *const sinusoids[] = {"amplitude", "spectrum", "synchronous", "/axes", "/probe", "/seen", NULL};
    whirl_layout layout;
    assert_int_equal(whirl_layout_known(&layout).code, WHIRL_OK);
    for (const whirl_field *field = layout.fields; field < layout.fields + layout.field_count; field++) {
        const bool length = strcmp(field->unit, "length") == 0;
        if (length && !has_one_of(field->meaning, lengths)) fail_msg("%s says: %s", field->name, field->meaning);
        if (strcmp(field->unit, "force") == 0) assert_true(has_one_of(field->meaning, forces));
        if (strstr(field->name, "shape")) assert_true(has_one_of(field->meaning, relative));
        assert_int_equal(length && has_one_of(field->name, sinusoids), whirl_field_counting(field) == WHIRL_AMPLITUDE);
        // Only static loads, torques and stiffnesses are in SI.
        const bool at_rest = strncmp(field->name, "statics/", 8) == 0 || strstr(field->name, "torque");
        if (*field->unit == 'N') assert_true(at_rest || strstr(field->unit, "N/m"));
    }
    const whirl_field *radius = whirl_layout_field(&layout, WHIRL_FIELD_ORBIT_MAX_RADIUS);
    const whirl_field *section = whirl_layout_field(&layout, WHIRL_FIELD_POINCARE_SECTION);
    const whirl_field *lines = whirl_layout_field(&layout, WHIRL_FIELD_SPECTRUM_LINES);
    assert_int_equal(whirl_field_counting(radius), WHIRL_ZERO_TO_PEAK);
    assert_int_equal(whirl_field_counting(section), WHIRL_FROM_CENTRE);
    assert_string_equal(whirl_column_unit(section, 1), "length");
    assert_string_equal(whirl_column_unit(section, 2), "length/radian");
    assert_string_equal(whirl_column_unit(lines, 0), "1");
    assert_string_equal(whirl_column_unit(lines, 1), "length");
}

static whirl_analysis_set all_analyses(void) {
    whirl_analysis_set set = 0;
    for (const whirl_analysis *a = whirl_analyses(); a->name; a++) assert_true(whirl_analysis_add(&set, a->name));
    return set;
}

/// A record made by hand: coordinate i in revolution n is 10 i + n. The waveform of probe s at sample j is
/// x = s + cos(2 pi j/16), y = sin(2 pi j/16).
typedef struct written_record {
    whirl_record record;
    double section[REVOLUTIONS][8], growth[REVOLUTIONS], waveform[2][2][REVOLUTIONS * 16];
    double bounds[2][8], radii[2][2], mean[4], backward[2], contact[3], spare[4];
} written_record;

static written_record *write_record(void) {
    written_record *w = calloc(1, sizeof *w);
    assert_non_null(w);
    for (size_t n = 0; n < REVOLUTIONS; n++) {
        for (size_t i = 0; i < 8; i++) w->section[n][i] = (double)(10 * i + n);
        w->growth[n] = -0.5;
    }
    for (size_t s = 0; s < 2; s++) {
        for (size_t j = 0; j < REVOLUTIONS * 16; j++) {
            w->waveform[s][0][j] = (double)s + cos(6.283185307179586 * (double)j / 16.0);
            w->waveform[s][1][j] = sin(6.283185307179586 * (double)j / 16.0);
        }
        w->radii[0][s] = 0.4 + (double)s;
        w->radii[1][s] = 0.1 + (double)s;
        w->mean[2 * s] = (double)s;
        w->backward[s] = 0.25 * (double)s;
    }
    for (size_t i = 0; i < 8; i++) {
        w->bounds[0][i] = -(double)i;
        w->bounds[1][i] = (double)i;
    }
    memcpy(w->contact, (double[]){0.125, 3.0, 0.75}, sizeof w->contact);
    w->record = (whirl_record){.dimension = 8,
                               .probe_count = 2,
                               .contact_count = 1,
                               .probes = probes,
                               .period = 1.0,
                               .section_count = REVOLUTIONS,
                               .section = w->section[0],
                               .record_count = REVOLUTIONS,
                               .growth_count = REVOLUTIONS,
                               .growth = w->growth,
                               .sample_count = REVOLUTIONS * 16,
                               .samples_per_revolution = 16,
                               .waveform = w->waveform[0][0],
                               .low = w->bounds[0],
                               .high = w->bounds[1]};
#define SPARE(array, ...) w->record.array = w->spare;
    WHIRL_WATCHED(SPARE)
#undef SPARE
    w->record.max_radius = w->radii[0];
    w->record.min_radius = w->radii[1];
    w->record.mean = w->mean;
    w->record.backward = w->backward;
    w->record.contact_share = &w->contact[0];
    w->record.contact_number = &w->contact[1];
    w->record.contact_force = &w->contact[2];
    return w;
}

/// Fields follow each other without gaps, and their names begin with an analysis.
static void fields_tile_the_block(void **state) {
    (void)state;
    const whirl_integrate_options integrate = steps();
    const whirl_record_options options = options_for_test();
    whirl_layout layout;
    assert_int_equal(whirl_layout_new(&machine, &integrate, &options, all_analyses(), &layout).code, WHIRL_OK);
    size_t end = 0;
    for (size_t f = 0; f < layout.field_count; f++) {
        const whirl_field *field = &layout.fields[f];
        assert_int_equal(field->offset, end);
        assert_ptr_equal(whirl_layout_field(&layout, field->name), field);
        assert_non_null(strchr(field->name, '/'));
        assert_true(strlen(field->unit) > 0 && strlen(field->meaning) > 0);
        assert_int_equal(field->repeat, field->extent == WHIRL_PER_STATION ? 2 : 1);
        end += field->rows * field->columns * field->repeat;
    }
    assert_int_equal(layout.size, end);
    assert_int_equal(whirl_layout_field(&layout, "poincare/section")->rows, REVOLUTIONS);
    assert_int_equal(whirl_layout_field(&layout, "waveform/samples")->rows, 3 * 16);
    assert_int_equal(whirl_layout_field(&layout, "spectrum/amplitude")->rows, 5 * REVOLUTIONS + 1);
    assert_null(whirl_layout_field(&layout, "poincare/nothing"));
}

static const double *numbers(const whirl_layout *layout, const double *block, const char *name, size_t which) {
    const whirl_field *field = whirl_layout_field(layout, name);
    assert_non_null(field);
    return block + field->offset + which * field->rows * field->columns;
}

static void numbers_are_in_place(void **state) {
    (void)state;
    const whirl_integrate_options integrate = steps();
    const whirl_record_options options = options_for_test();
    whirl_layout layout;
    assert_int_equal(whirl_layout_new(&machine, &integrate, &options, all_analyses(), &layout).code, WHIRL_OK);
    written_record *w = write_record();
    double *block = malloc(layout.size * sizeof *block);
    assert_non_null(block);
    assert_int_equal(whirl_analyze(&w->record, &options, all_analyses(), &layout, block).code, WHIRL_OK);
    const double section[] = {20.0 + 7.0, 30.0 + 7.0, 60.0 + 7.0, 70.0 + 7.0};
    for (size_t c = 0; c < 4; c++)
        assert_near(numbers(&layout, block, "poincare/section", 1)[7 * 4 + c], section[c], 0.0);
    assert_near(*numbers(&layout, block, "orbit/max_radius", 1), 1.4, 0.0);
    assert_near(*numbers(&layout, block, "orbit/min_radius", 0), 0.1, 0.0);
    assert_near(*numbers(&layout, block, "orbit/eccentricity", 1), 2.8, 1e-15);
    assert_true(isnan(*numbers(&layout, block, "orbit/eccentricity", 0)));
    assert_near(numbers(&layout, block, "orbit/low", 1)[1], -3.0, 0.0);
    assert_near(numbers(&layout, block, "orbit/high", 1)[0], 2.0, 0.0);
    assert_near(*numbers(&layout, block, "orbit/backward", 1), 0.25, 0.0);
    assert_near(*numbers(&layout, block, "rub/contact", 0), 1.0, 0.0);
    assert_near(*numbers(&layout, block, "rub/share", 0), 0.125, 0.0);
    assert_near(*numbers(&layout, block, "rub/number", 0), 3.0, 0.0);
    assert_near(*numbers(&layout, block, "rub/max_force", 0), 0.75, 0.0);
    assert_near(numbers(&layout, block, "waveform/samples", 1)[2 * 4], 1.0 + cos(6.283185307179586 * 4.0 / 16.0),
                1e-12);
    assert_near(numbers(&layout, block, "waveform/samples", 1)[2 * 4 + 1], 1.0, 1e-12);
    const double line[] = {1.0, 1.0, 1.0, 1.0, 0.0}; // a forward circle, once a revolution
    for (size_t c = 0; c < 5; c++) {
        assert_near(numbers(&layout, block, "spectrum/lines", 1)[c], line[c], 1e-8);
        assert_near(numbers(&layout, block, "spectrum/amplitude", 1)[5 * REVOLUTIONS + c], line[c], 1e-5);
    }
    assert_true(isnan(numbers(&layout, block, "spectrum/lines", 1)[5]));
    assert_near(*numbers(&layout, block, "lyapunov/largest", 0), -0.5, 1e-15);
    free(block);
    free(w);
}

/// The verdict comes back from the block as it was given.
static void verdicts_come_back(void **state) {
    (void)state;
    const map_system system = {
        .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {3.5}, .start = {0.3}};
    whirl_record *record = record_map(&system, 2000, 400, REVOLUTIONS);
    const whirl_integrate_options integrate = steps();
    const whirl_record_options options = options_for_test();
    whirl_analysis_set set = 0;
    assert_true(whirl_analysis_add(&set, "regime"));
    assert_false(whirl_analysis_add(&set, "regimes"));
    whirl_layout layout;
    assert_int_equal(whirl_layout_new(&machine, &integrate, &options, set, &layout).code, WHIRL_OK);
    double block[64];
    assert_true(layout.size <= 64);
    assert_int_equal(whirl_analyze(record, &options, set, &layout, block).code, WHIRL_OK);
    const whirl_verdict judged = whirl_judge(record), back = whirl_block_verdict(&layout, block);
    assert_int_equal(judged.regime, WHIRL_PERIODIC);
    assert_int_equal(back.regime, judged.regime);
    assert_int_equal(back.period, 4);
    assert_int_equal(back.recurrence_period, judged.recurrence_period);
    assert_near(back.recurrence, judged.recurrence, 0.0);
    assert_near(back.recurrence_trend, judged.recurrence_trend, 0.0);
    assert_near(back.regularity, judged.regularity, 0.0);
    assert_near(back.exponent.value, judged.exponent.value, 0.0);
    assert_near(back.exponent.error, judged.exponent.error, 0.0);
    assert_int_equal(back.agreement, judged.agreement);
    assert_int_equal(back.confidence, WHIRL_FAIR);
    assert_int_equal(back.advice.remedy, judged.advice.remedy);
    assert_near(back.advice.factor, judged.advice.factor, 0.0);
    assert_false(back.confirmed);
    whirl_block_confirm(&layout, block, &judged);
    const whirl_verdict confirmed = whirl_block_verdict(&layout, block);
    assert_true(confirmed.confirmed);
    assert_int_equal(confirmed.confidence, judged.agreement);
    assert_int_equal(confirmed.other_regime, WHIRL_PERIODIC);
    assert_int_equal(confirmed.other_period, 4);
    assert_near(confirmed.recurrence, judged.recurrence, 0.0);
    const whirl_layout empty = {0};
    const whirl_verdict none = whirl_block_verdict(&empty, block);
    assert_int_equal(none.regime, WHIRL_NOT_JUDGED);
    assert_true(isnan(none.exponent.value) && isnan(none.recurrence));
    free(record);
}

/// After a divergence only the regime is known.
static void divergence(void **state) {
    (void)state;
    const whirl_integrate_options integrate = steps();
    const whirl_record_options options = options_for_test();
    whirl_layout layout;
    assert_int_equal(whirl_layout_new(&machine, &integrate, &options, all_analyses(), &layout).code, WHIRL_OK);
    const whirl_record record = {
        .dimension = 8, .motion = WHIRL_DIVERGED, .diverged_at = 17.0, .probe_count = 2, .probes = probes};
    double *block = malloc(layout.size * sizeof *block);
    assert_non_null(block);
    assert_int_equal(whirl_analyze(&record, &options, all_analyses(), &layout, block).code, WHIRL_OK);
    assert_true(isnan(*numbers(&layout, block, "rub/contact", 0)));
    assert_true(isnan(*numbers(&layout, block, "orbit/max_radius", 1)));
    assert_true(isnan(*numbers(&layout, block, "lyapunov/largest", 0)));
    const whirl_verdict verdict = whirl_block_verdict(&layout, block);
    assert_int_equal(verdict.regime, WHIRL_DIVERGING);
    assert_near(verdict.diverged_at, 17.0, 0.0);
    free(block);
}

/// Fields without numbers are left out; options without the data that the chosen analyses need are refused.
static void options_decide(void **state) {
    (void)state;
    const whirl_integrate_options integrate = steps();
    whirl_record_options options = options_for_test();
    options.spectra = false;
    options.waveform_revolutions = 0;
    whirl_system free_machine = machine;
    free_machine.contact_count = 0;
    whirl_layout layout;
    assert_int_equal(whirl_layout_new(&free_machine, &integrate, &options, all_analyses(), &layout).code, WHIRL_OK);
    assert_null(whirl_layout_field(&layout, "spectrum/amplitude"));
    assert_null(whirl_layout_field(&layout, "waveform/samples"));
    assert_null(whirl_layout_field(&layout, "rub/share"));
    assert_non_null(whirl_layout_field(&layout, "rub/contact"));
    whirl_record_options wrong[6];
    for (size_t i = 0; i < 6; i++) wrong[i] = options;
    wrong[0].waveform = false;
    wrong[1].growth = WHIRL_GROWTH_LARGEST;
    wrong[2].record = 0;
    wrong[3].waveform_revolutions = REVOLUTIONS + 1;
    wrong[4].highest_order = NAN;
    wrong[5].samples_per_revolution = 0;
    for (size_t i = 0; i < 6; i++) {
        const whirl_status status = whirl_layout_new(&machine, &integrate, &wrong[i], all_analyses(), &layout);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_true(strlen(status.message) > 20);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields_tile_the_block), cmocka_unit_test(numbers_are_in_place),
        cmocka_unit_test(verdicts_come_back),    cmocka_unit_test(divergence),
        cmocka_unit_test(options_decide),        cmocka_unit_test(meanings_name_the_convention_of_lengths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
