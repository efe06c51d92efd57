// The JSON document, read back by Jansson.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <jansson.h>

#include "../store/synthetic.h"
#include "sample.h"

typedef struct fixture {
    whirl_result *made;
    char *text;
    json_t *document;
} fixture;

static int setup(void **state) {
    fixture *f = synthetic_take(1, sizeof *f);
    f->made = synthetic_result();
    *state = f;
    return 0;
}

static int teardown(void **state) {
    fixture *f = *state;
    json_decref(f->document);
    free(f->text);
    whirl_result_free(f->made);
    free(f);
    return 0;
}

// Writes the result and parses it: the whole text must be one document.
static void write_document(fixture *f) {
    size_t size = 0;
    json_error_t error;
    FILE *stream = open_memstream(&f->text, &size);
    assert_int_equal(whirl_result_write_json(f->made, stream).code, WHIRL_OK);
    fclose(stream);
    f->document = json_loads(f->text, JSON_REJECT_DUPLICATES, &error);
    if (!f->document) fail_msg("line %d: %s", error.line, error.text);
}

// A member by its path, "rub/contacts/rub at disc/number".
static json_t *member(json_t *object, const char *path) {
    char key[WHIRL_NAME_SIZE];
    for (; object && *path; path += *path == '/') {
        const size_t length = strcspn(path, "/");
        snprintf(key, sizeof key, "%.*s", (int)length, path);
        object = json_object_get(object, key);
        path += length;
    }
    return object;
}

// Exactly this double, or null for what is no number.
static void assert_number(json_t *value, double expected) {
    if (!isfinite(expected)) {
        assert_true(json_is_null(value));
        return;
    }
    assert_true(json_is_number(value));
    assert_true(json_number_value(value) == expected);
}

static json_t *point_of(fixture *f, size_t index) {
    return json_array_get(member(f->document, "points"), index);
}

static void says_what_it_is_of(void **state) {
    fixture *f = *state;
    write_document(f);
    assert_string_equal(json_string_value(member(f->document, "whirl")), "9.8.7");
    assert_string_equal(json_string_value(member(f->document, "title")), f->made->title);
    assert_string_equal(json_string_value(member(f->document, "table")), "sweep");
    assert_number(member(f->document, "length_scale"), 2e-4);
    assert_number(member(f->document, "speed"), 650.0);
    assert_int_equal(json_array_size(member(f->document, "points")), SYNTHETIC_POINTS);
    assert_int_equal(json_array_size(member(f->document, "detail")), 1);
}

// Given values only, the swept one with the point's own.
static void points_have_their_parameters(void **state) {
    fixture *f = *state;
    write_document(f);
    for (size_t i = 0; i < SYNTHETIC_POINTS; ++i) {
        json_t *parameters = member(point_of(f, i), "parameters");
        assert_int_equal(json_object_size(parameters), 2);
        assert_number(member(parameters, "r_k"), f->made->tables[0].values[i]);
        assert_number(member(parameters, "omega"), 650.0);
        assert_int_equal(json_integer_value(member(point_of(f, i), "branch")), f->made->tables[0].branch[i]);
    }
    assert_null(member(point_of(f, 1), "branch"));
    assert_int_equal(json_object_size(member(json_array_get(member(f->document, "detail"), 0), "parameters")), 2);
}

static void verdicts_have_words_and_evidence(void **state) {
    static const char *const regimes[] = {"periodic", "chaotic", "diverged"};
    static const char *const verdicts[] = {"P-2", "chaotic", "diverged at revolution 17"};
    fixture *f = *state;
    write_document(f);
    for (size_t i = 0; i < SYNTHETIC_POINTS; ++i) {
        json_t *point = point_of(f, i);
        assert_string_equal(json_string_value(member(point, "regime")), regimes[i]);
        assert_string_equal(json_string_value(member(point, "verdict")), verdicts[i]);
        assert_true(json_string_length(member(point, "reason")) > 0);
        assert_number(member(point, "evidence/regularity"),
                      *whirl_table_field(&f->made->tables[0], i, "regime/regularity", 0));
        const whirl_verdict verdict = whirl_table_verdict(&f->made->tables[0], i);
        assert_number(member(point, "evidence/followed"), verdict.followed);
        assert_int_equal(json_integer_value(member(point, "evidence/neighbours")), verdict.neighbours);
    }
    assert_int_equal(json_integer_value(member(point_of(f, 0), "period")), 2);
    assert_null(member(point_of(f, 0), "diverged_at"));
    assert_number(member(point_of(f, 2), "diverged_at"), 17.0);
}

// Every number of every point is there to the last bit.
static void numbers_are_those_of_the_fields(void **state) {
    static const struct {
        const char *path, *field;
        size_t which;
        double factor;
    } numbers[] = {
        {"lyapunov/largest", "lyapunov/largest", 0, 1.0},
        {"lyapunov/error", "lyapunov/error", 0, 1.0},
        {"stations/disc/max_radius", "orbit/max_radius", 0, 1.0},
        {"stations/journal/min_radius", "orbit/min_radius", 1, 1.0},
        {"stations/journal/eccentricity", "orbit/eccentricity", 1, 1.0},
        {"stations/disc/backward", "orbit/backward", 0, 1.0},
        {"rub/fraction", "rub/share", 0, 1.0},
        {"rub/contacts/rub at disc/number", "rub/number", 0, 1.0},
        {"rub/contacts/rub at disc/max_force", "rub/max_force", 0, 4225.0},
    };
    fixture *f = *state;
    write_document(f);
    for (size_t i = 0; i < SYNTHETIC_POINTS; ++i)
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; ++n)
            assert_number(member(point_of(f, i), numbers[n].path),
                          numbers[n].factor *
                              *whirl_table_field(&f->made->tables[0], i, numbers[n].field, numbers[n].which));
}

// Made finite first: where the first number is missing, so is the section.
static void sections_are_pairs(void **state) {
    fixture *f = *state;
    whirl_table *sweep = &f->made->tables[0];
    for (size_t i = 0; i < sweep->count * sweep->layout.size; ++i)
        if (!isfinite(sweep->blocks[i])) sweep->blocks[i] = 0.5;
    write_document(f);
    for (size_t i = 0; i < SYNTHETIC_POINTS; ++i) {
        json_t *journal = member(point_of(f, i), "poincare/journal");
        const double *section = whirl_table_field(sweep, i, "poincare/section", 1);
        assert_int_equal(json_array_size(journal), SYNTHETIC_RECORD);
        for (size_t n = 0; n < SYNTHETIC_RECORD; ++n) {
            assert_int_equal(json_array_size(json_array_get(journal, n)), 2);
            assert_number(json_array_get(json_array_get(journal, n), 0), section[4 * n]);
            assert_number(json_array_get(json_array_get(journal, n), 1), section[4 * n + 1]);
        }
    }
}

// Two lines, one of each sense, and the rest missing.
static void spectra_have_directions(void **state) {
    static const double lines[2][5] = {{1.0, 0.2, 0.19, 0.195, 0.005}, {0.5, 0.1, 0.08, 0.01, 0.09}};
    static const char *const directions[] = {"forward", "backward"};
    fixture *f = *state;
    whirl_table *sweep = &f->made->tables[0];
    const whirl_field *field = whirl_layout_field(&sweep->layout, "spectrum/lines");
    double *disc = sweep->blocks + field->offset;
    for (size_t i = 0; i < field->rows * field->columns; ++i) disc[i] = i < 10 ? lines[i / 5][i % 5] : (double)NAN;
    write_document(f);
    json_t *written = member(point_of(f, 0), "spectrum/disc");
    assert_int_equal(json_array_size(written), 2);
    for (size_t n = 0; n < 2; ++n) {
        json_t *line = json_array_get(written, n);
        assert_number(member(line, "order"), lines[n][0]);
        assert_number(member(line, "amplitude"), lines[n][1]);
        assert_number(member(line, "backward"), lines[n][4]);
        assert_string_equal(json_string_value(member(line, "direction")), directions[n]);
    }
}

// Missing numbers are null, never a word that is no JSON.
static void missing_numbers_are_null(void **state) {
    fixture *f = *state;
    synthetic_set(&f->made->tables[0], 0, "rub/contact", NAN);
    synthetic_set(&f->made->tables[0], 0, "orbit/max_radius", INFINITY);
    write_document(f);
    assert_true(json_is_null(member(point_of(f, 0), "rub/contact")));
    assert_true(json_is_null(member(point_of(f, 0), "stations/disc/max_radius")));
}

static void contact_is_true_or_false(void **state) {
    fixture *f = *state;
    synthetic_set(&f->made->tables[0], 0, "rub/contact", 0.0);
    synthetic_set(&f->made->tables[0], 1, "rub/contact", 1.0);
    write_document(f);
    assert_true(json_is_false(member(point_of(f, 0), "rub/contact")));
    assert_true(json_is_true(member(point_of(f, 1), "rub/contact")));
}

/// The six P-1 points of the sweep move by 0.001 from one to the next, but by 0.3 from the third to the fourth.
static void jumps_are_reported(void **state) {
    fixture *f = *state;
    whirl_result_free(f->made);
    f->made = sample_result();
    whirl_table *sweep = &f->made->tables[0];
    for (size_t i = 0; i < 6; i++)
        for (size_t s = 0; s < 2; s++) {
            const double shift = s == 1 ? 0.0 : 0.001 * (double)i + (i > 2 ? 0.299 : 0.0);
            const double bounds[][2] = {{shift, 0.0}, {shift - 0.3, -0.3}, {shift + 0.3, 0.3}};
            static const char *const fields[] = {"orbit/mean", "orbit/low", "orbit/high"};
            for (size_t k = 0; k < 3; k++) memcpy(sample_field(sweep, i, fields[k], s), bounds[k], sizeof bounds[k]);
        }
    write_document(f);
    json_t *jumps = member(f->document, "jumps/sweep");
    assert_int_equal(json_array_size(jumps), 1);
    json_t *jump = json_array_get(jumps, 0);
    assert_number(member(jump, "from"), sweep->values[2]);
    assert_number(member(jump, "to"), sweep->values[3]);
    assert_string_equal(json_string_value(member(jump, "station")), "disc");
    assert_true(fabs(json_real_value(member(jump, "change")) - 0.5) < 1e-12);
    assert_true(fabs(json_real_value(member(jump, "usual")) - 0.001 / 0.6) < 1e-12);
}

/// A byte that is not UTF-8 becomes a question mark.
static void texts_become_utf8(void **state) {
    fixture *f = *state;
    strcpy(f->made->title, "r\xf6tor");
    write_document(f);
    assert_string_equal(json_string_value(member(f->document, "title")), "r?tor");
}

static void a_stream_that_fails_is_an_error(void **state) {
    fixture *f = *state;
    FILE *full = fopen("/dev/full", "w");
    assert_non_null(full);
    const whirl_status status = whirl_result_write_json(f->made, full);
    fclose(full);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "No space left"));
}

int main(void) {
#define WITH_RESULT(test) cmocka_unit_test_setup_teardown(test, setup, teardown)
    const struct CMUnitTest tests[] = {
        WITH_RESULT(says_what_it_is_of),
        WITH_RESULT(points_have_their_parameters),
        WITH_RESULT(verdicts_have_words_and_evidence),
        WITH_RESULT(numbers_are_those_of_the_fields),
        WITH_RESULT(sections_are_pairs),
        WITH_RESULT(spectra_have_directions),
        WITH_RESULT(missing_numbers_are_null),
        WITH_RESULT(contact_is_true_or_false),
        WITH_RESULT(jumps_are_reported),
        WITH_RESULT(texts_become_utf8),
        WITH_RESULT(a_stream_that_fails_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
