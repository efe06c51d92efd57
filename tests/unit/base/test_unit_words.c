// Names of units of figures: their meaning, and messages for unknown ones.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "unit_words.h"
#include "whirl/status.h"

static void words_are_read_in_any_order(void **state) {
    (void)state;
    unit_choice choice;
    assert_int_equal(unit_choice_read("Hz,p-p , um,  rpm", &choice).code, WHIRL_OK);
    assert_string_equal(choice.of[UNIT_LENGTH]->word, "um");
    assert_string_equal(choice.of[UNIT_SPEED]->word, "rpm");
    assert_string_equal(choice.of[UNIT_FREQUENCY]->word, "Hz");
    assert_string_equal(choice.of[UNIT_AMPLITUDE]->word, "p-p");
    assert_true(fabs(choice.of[UNIT_SPEED]->size * 30.0 / acos(-1.0) - 1.0) < 1e-15);
    assert_int_equal(unit_choice_read("mil", &choice).code, WHIRL_OK);
    assert_true(choice.of[UNIT_LENGTH]->size == 25.4e-6 && !choice.of[UNIT_SPEED]);
    assert_int_equal(unit_choice_read(" ", &choice).code, WHIRL_OK);
    for (int kind = 0; kind < UNIT_KINDS; kind++) assert_null(choice.of[kind]);
}

static void mistakes_are_named(void **state) {
    (void)state;
    static const struct {
        const char *text, *message;
    } rows[] = {
        {"um, rmp", "'rmp' is no unit of figures, did you mean rpm?"},
        {"furlong",
         "'furlong' is no unit of figures, expected some of scale, m, mm, um, in, mil, rad/s, rpm, order, Hz, "
         "cpm, 0-p, p-p, rms, N, kN, lbf, kg, lbm, N/m, N/mm, MN/m, lbf/in, N s/m, kN s/m, lbf s/in, N m, lbf in, kg "
         "m2, "
         "lbm in2, kg mm, g mm, oz in, kg/m3, lbm/ft3, Pa, MPa, bar, psi, l/min, gpm, W, kW, hp, K, degC, degF, mPa s, "
         "cP, reyn, g, oz, SI, US"},
        {"um, mil", "um and mil are both for lengths, expected one of them"},
        {"US, SI", "US and SI are both for systems of units, expected one of them"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        unit_choice choice;
        const whirl_status status = unit_choice_read(rows[i].text, &choice);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_string_equal(status.message, rows[i].message);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(words_are_read_in_any_order),
                                       cmocka_unit_test(mistakes_are_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
