// Couplings in rotors saved by ROSS: the resulting shafts, stations and elements, refusals and notes.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/case.h"
#include "whirl/internal/import.h"

#define STEEL "{name = \"Steel\", rho = 7810.0, E = 211e9, G_s = 81.2e9}\n"
#define PIECE(n, length) "[ShaftElement_" #n "]\nL = " #length "\nidl = 0\nodl = 0.05\nn = " #n "\nmaterial = " STEEL
#define HELD(n) "[BearingElement_" #n "]\nn = " #n "\nkxx = 1e7\n"

#define LATERAL "kt_x = 4e6\nkt_y = 4e6\nkr_x = 5e3\nkr_y = 5e3\nct_x = 60\nct_y = 60\ncr_x = 0.7\ncr_y = 0.7\n"
#define ENDS "m_l = 2.0\nm_r = 3.0\nIp_l = 0.04\nIp_r = 0.06\nId_l = 0.025\n"

/// Two pieces, a coupling, one piece; bearings at the outer ends.
static const char good[] =
    PIECE(0, 0.2) PIECE(1, 0.3) PIECE(3, 0.1) HELD(0) HELD(4) "[CouplingElement_Hub]\n" ENDS LATERAL "n = 2\n";

/// Imports the good file with `from` replaced by `to`.
static whirl_status import(const char *from, const char *to, whirl_imported *out) {
    char text[4096];
    const char *const place = strstr(good, from);
    if (!place) fail_msg("there is no '%s'", from);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(place - good), good, to, place + strlen(from));
    return whirl_import_parse(text, strlen(text), "r.toml", out);
}

static void expect(const char *from, const char *to, const char *line, bool there) {
    whirl_imported imported;
    whirl_case *object;
    const whirl_status status = import(from, to, &imported);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    if (!strstr(imported.text, line) == there) fail_msg("'%s' in\n%s", line, imported.text);
    assert_int_equal(whirl_case_parse(imported.text, imported.length, "case", NULL, &object).code, WHIRL_OK);
    whirl_case_free(object);
    whirl_imported_free(&imported);
}

static void expect_line(const char *from, const char *to, const char *line) {
    expect(from, to, line, true);
}

static void expect_none(const char *from, const char *to, const char *line) {
    expect(from, to, line, false);
}

static void expect_refused(const char *from, const char *to, const char *message) {
    whirl_imported imported;
    const whirl_status status = import(from, to, &imported);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, message);
}

static void expect_note(const char *from, const char *to, const char *note) {
    whirl_imported imported;
    const whirl_status status = import(from, to, &imported);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    assert_int_equal(imported.note_count, note ? 1 : 0);
    if (note) assert_string_equal(imported.notes[0], note);
    whirl_imported_free(&imported);
}

/// Each shaft has its own segments and stations, from its own left end.
static void test_two_shafts(void **state) {
    (void)state;
    expect_line("", "",
                "    shaft_1: {material: steel, shear: cowper}\n    shaft_2: {material: steel, shear: cowper}\n");
    expect_line("", "", "    - segment: {shaft: shaft_1, length: 0.3 m, outer: 0.05 m}");
    expect_line("", "", "    - segment: {shaft: shaft_2, length: 0.1 m, outer: 0.05 m}");
    expect_line("", "",
                "    hub_left: {shaft: shaft_1, position: 0.5 m, mass: 2 kg, diametral: 0.025 kg.m2,\n               "
                "polar: 0.04 kg.m2}");
    expect_line("", "",
                "    hub_right: {shaft: shaft_2, position: 0 m, mass: 3 kg, diametral: 0.03 kg.m2,\n                "
                "polar: 0.06 kg.m2}");
    expect_line("", "", "    node_4: {shaft: shaft_2, position: 0.1 m}");
    expect_line(
        "", "",
        "    # Hub, nodes 2 and 3\n    - coupling: {between: [hub_left, hub_right], radial: 4000000 N/m, tilt: ");
    expect_line("", "",
                "tilt: 5000 N m/rad,\n                 radial_damping: 60 N s/m, tilt_damping: 0.7 N m s/rad}\n");
    expect_none("", "", "from: hub_left");
    // Options of the second shaft are its own.
    expect_line("n = 3\n", "n = 3\nalpha = 4\n",
                "    shaft_2: {material: steel, shear: cowper, mass_damping: 4 1/s}\n");
    expect_none("n = 3\n", "n = 3\nalpha = 4\n", "0.05 m, mass_damping");
    expect_note("", "", NULL);
}

/// A bearing between both shafts may have different coefficients along x and y.
static void test_unequal(void **state) {
    static const char sum[] = "radial: 0 N/m, tilt: 5000 N m/rad";
    (void)state;
    expect_line("kt_y = 4e6", "kt_y = 3e6", sum);
    expect_line("kt_y = 4e6", "kt_y = 3e6",
                "    - bearing: {at: hub_right, from: hub_left, role: other, kxx: 4000000 N/m, kyy: 3000000 N/m,\n"
                "                cxx: 60 N s/m, cyy: 60 N s/m}\n");
    expect_none("kt_y = 4e6", "kt_y = 3e6", "radial_damping");
    expect_line("ct_x = 60\n", "", sum);
    expect_line("ct_x = 60\n", "", "kyy: 4000000 N/m,\n                cxx: 0 N s/m, cyy: 60 N s/m}\n");
    expect_line(LATERAL, "kt_x = 4e6\n",
                "    - bearing: {at: hub_right, from: hub_left, role: other, kxx: 4000000 N/m, kyy: 0 N/m}\n");
    expect_none(LATERAL, "kt_x = 4e6\n", "coupling:");
}

/// Couplings may follow each other, be parallel to a piece of shaft, or have a free end.
static void test_places(void **state) {
    static const char more[] = "kt_x = 4e6\nkt_y = 4e6\nm_l = 1\nm_r = 1\nIp_l = 0.01\nIp_r = 0.02\n";
    char text[1024];
    (void)state;
    snprintf(text, sizeof text, "[CouplingElement_Free]\n%sn = 4\n[CouplingElement_Hub]", more);
    expect_line("[CouplingElement_Hub]", text,
                "    free_right: {mass: 1 kg, diametral: 0.01 kg.m2, polar: 0.02 kg.m2}");
    expect_line("[CouplingElement_Hub]", text, "# node 5, on no shaft\n");
    expect_line("[CouplingElement_Hub]", text, "{between: [node_4, free_right], radial: 4000000 N/m}");
    snprintf(text, sizeof text, "[CouplingElement_Sleeve]\n%sn = 1\n[CouplingElement_Hub]", more);
    expect_line("[CouplingElement_Hub]", text, "    sleeve_left: {shaft: shaft_1, position: 0.2 m, mass: 1 kg");
    expect_line("[CouplingElement_Hub]", text, "{between: [sleeve_left, sleeve_right], radial: 4000000 N/m}");
    expect_line("[CouplingElement_Hub]", text, "    sleeve_right: {shaft: shaft_1, position: 0.5 m, mass: 3 kg");
    // A spacer: the node between two couplings is a weight by itself.
    snprintf(text, sizeof text, "[CouplingElement_Spacer]\n%sn = 3\n%s", more, PIECE(4, 0.1));
    expect_line(PIECE(3, 0.1), text, "    hub_right: {mass: 4 kg, diametral: 0.035 kg.m2, polar: 0.07 kg.m2}");
    expect_line(PIECE(3, 0.1), text, "    node_4: {shaft: shaft_2, position: 0 m, mass: 1 kg");
}

static void test_refused(void **state) {
    (void)state;
    expect_refused("kr_y = 5e3", "kr_y = 6e3",
                   "r.toml:34: [CouplingElement_Hub] kr_y: is 6000 N m/rad and kr_x is 5000, expected equal numbers: "
                   "a coupling here resists tilts alike in both planes");
    expect_refused("cr_y = 0.7\n", "",
                   "r.toml:25: [CouplingElement_Hub] cr_y: is 0 N m s/rad and cr_x is 0.7, expected equal numbers: "
                   "a coupling here resists tilts alike in both planes");
    expect_refused("kt_x = 4e6", "kt_x = -4e6",
                   "r.toml:31: [CouplingElement_Hub] kt_x: is -4000000 N/m, expected a number of at least 0 N/m");
    expect_refused("m_r = 3.0\n", "", "r.toml:25: [CouplingElement_Hub] m_r: is missing, expected a number in kg");
    expect_refused(
        "n = 2\n", "n = 6\n",
        "r.toml:17: [ShaftElement_3] n: is 3 after 1, expected a shaft without a gap, or couplings from node "
        "2 to 3: other rotors of several shafts are not taken over");
    expect_refused(
        "[CouplingElement_Hub]",
        "[CouplingElement_Far]\nm_l = 1\nm_r = 1\nIp_l = 1\nIp_r = 1\nn = 5\n[CouplingElement_Hub]",
        "r.toml:30: [CouplingElement_Far] n: is 5, expected a coupling between nodes of the shaft, 0 to 4, or "
        "next to them");
    expect_refused(
        "[CouplingElement_Hub]",
        "[CouplingElement_End]\nm_l = 1\nm_r = 0\nIp_l = 1\nIp_r = 1\nn = 4\n[CouplingElement_Hub]",
        "r.toml:27: [CouplingElement_End] m_r: is 0 kg at node 5, where there is no shaft, expected a number "
        "above 0 kg");
    expect_refused("[CouplingElement_Hub]",
                   "[CouplingElement_End]\nm_l = 1\nm_r = 1\nIp_l = 1\nIp_r = 0\nn = 4\n[CouplingElement_Hub]",
                   "r.toml:29: [CouplingElement_End] Ip_r: is 0 kg m2 at node 5, where there is no shaft, expected a "
                   "number above 0 kg m2");
}

static void test_notes(void **state) {
    (void)state;
    expect_note("ct_x", "kr_z = 3e5\nct_x",
                "Axial and torsional coefficients of couplings (kt_z, kr_z, ct_z, cr_z) are left out, for imported "
                "rotors move across their shafts alone: 'Hub'.");
    expect_note("ct_x", "ct_z = 3\nct_x",
                "Axial and torsional coefficients of couplings (kt_z, kr_z, ct_z, cr_z) are left out, for imported "
                "rotors move across their shafts alone: 'Hub'.");
    expect_note("ct_x", "kt_z = 0\nct_x", NULL);
    expect_note("ct_x", "L = 0.2\no_d = 0.2\nct_x",
                "Lengths and diameters of couplings (L, o_d) are left out; no force depends on them, in ROSS neither: "
                "'Hub'.");
    expect_note(LATERAL, "",
                "Couplings without lateral coefficients join nothing here; their masses are taken over: 'Hub'.");
    expect_none(LATERAL, "", "coupling:");
    expect_line(LATERAL, "", "    hub_right: {shaft: shaft_2, position: 0 m, mass: 3 kg");
}

/// Checks that a file is refused with a sentence, or gives a valid case.
static void expect_good_or_refused(const char *text) {
    whirl_imported imported;
    whirl_case *object = NULL;
    const whirl_status status = whirl_import_parse(text, strlen(text), "r.toml", &imported);
    if (status.code != WHIRL_OK) {
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_memory_equal(status.message, "r.toml:", 7);
        return;
    }
    const whirl_status read = whirl_case_parse(imported.text, imported.length, "case", NULL, &object);
    if (read.code != WHIRL_OK) fail_msg("%s in\n%s", read.message, imported.text);
    whirl_case_free(object);
    whirl_imported_free(&imported);
}

/// Files in which any number of the coupling, nodes among them, is replaced are refused or valid.
static void test_strange_numbers(void **state) {
    static const char *const numbers[] = {"0", "1", "3", "4", "5", "-1", "1e-30", "1e30", "1e308", "nan", "1000000"};
    char text[sizeof good + 16];
    (void)state;
    for (const char *c = strstr(strstr(good, "[Coupling"), "= "); c; c = strstr(c + 1, "= ")) {
        const char *const from = c + 2, *const to = from + strcspn(from, "\n");
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            snprintf(text, sizeof text, "%.*s%s%s", (int)(from - good), good, numbers[i], to);
            expect_good_or_refused(text);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_two_shafts), cmocka_unit_test(test_unequal), cmocka_unit_test(test_places),
        cmocka_unit_test(test_refused),    cmocka_unit_test(test_notes),   cmocka_unit_test(test_strange_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
