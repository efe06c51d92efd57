// Rotors saved by ROSS: converted parts, refusals, and notes about parts that are left out.
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

/// Two elements, a disc in the middle, a bearing with a table and one on a support.
static const char good[] = "ross_version = \"2.3.0\"\n"
                           "[parameters]\n"
                           "max_w = 300.0\n"
                           "[\"ShaftElement_Shaft Element 0\"]\n"
                           "L = 0.25\n"
                           "idl = 0.0\n"
                           "odl = 0.05\n"
                           "n = 0\n"
                           "tag = \"Shaft Element 0\"\n"
                           "[\"ShaftElement_Shaft Element 1\"]\n"
                           "L = 0.25\n"
                           "idl = 0.01\n"
                           "odl = 0.05\n"
                           "idr = 0.01\n"
                           "odr = 0.04\n"
                           "n = 1\n"
                           "tag = \"Shaft Element 1\"\n"
                           "[\"DiskElement_Disk 0\"]\n"
                           "n = 1\n"
                           "m = 30.0\n"
                           "Id = 0.2\n"
                           "Ip = 0.3\n"
                           "[\"BearingElement_Bearing 0\"]\n"
                           "n = 0\n"
                           "frequency = [ 0.0, 100.0, 400.0,]\n"
                           "kxx = [ 1e6, 2e6, 3e6,]\n"
                           "kxy = [ 5.0,]\n"
                           "cxx = [ 7, 7, 7,]\n"
                           "[\"BearingElement_Bearing 1\"]\n"
                           "n = 2\n"
                           "n_link = 3\n"
                           "kxx = [ 1000000,]\n"
                           "cxx = [ 0,]\n"
                           "mxx = [ 0.5,]\n"
                           "[\"BearingElement_Support\"]\n"
                           "n = 3\n"
                           "kxx = [ 8e6,]\n"
                           "kyy = [ 9e6,]\n"
                           "cxx = [ 10,]\n"
                           "[\"PointMass_Pedestal\"]\n"
                           "n = 3\n"
                           "mx = 20.0\n"
                           "my = 25.0\n"
                           "[\"ShaftElement_Shaft Element 0\".material]\n"
                           "name = \"Steel\"\n"
                           "rho = 7810.0\n"
                           "E = 211e9\n"
                           "G_s = 81.2e9\n"
                           "[\"ShaftElement_Shaft Element 1\".material]\n"
                           "name = \"Steel\"\n"
                           "rho = 7810.0\n"
                           "E = 211e9\n"
                           "G_s = 81.2e9\n";

/// Writes the good file with `from` replaced by `to`.
static void edit(const char *from, const char *to, char *text, size_t size) {
    const char *const place = strstr(good, from);
    if (!place) fail_msg("there is no '%s'", from);
    snprintf(text, size, "%.*s%s%s", (int)(place - good), good, to, place + strlen(from));
}

static void expect_refused(const char *from, const char *to, const char *message) {
    char text[4096];
    whirl_imported imported;
    edit(from, to, text, sizeof text);
    const whirl_status status = whirl_import_parse(text, strlen(text), "r.toml", &imported);
    assert_null(imported.text);
    assert_int_equal(imported.note_count, 0);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, message);
}

static void expect_line(const char *from, const char *to, const char *line) {
    char text[4096];
    whirl_imported imported;
    edit(from, to, text, sizeof text);
    const whirl_status status = whirl_import_parse(text, strlen(text), "r.toml", &imported);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    assert_int_equal(strlen(imported.text), imported.length);
    if (!strstr(imported.text, line)) fail_msg("no line '%s' in\n%s", line, imported.text);
    whirl_imported_free(&imported);
}

static const char cone[] =
    "ROSS's own frequencies are higher, by about 0.5 % where a diameter grows by half along an element and 2 % where "
    "it doubles: its cones are too stiff, those here agree with fine steps of cylinders: 'Shaft Element 1'.";

/// Checks the last note, which follows that of the good file's cone.
static void expect_note(const char *from, const char *to, const char *note) {
    char text[4096];
    whirl_imported imported;
    edit(from, to, text, sizeof text);
    const whirl_status status = whirl_import_parse(text, strlen(text), "r.toml", &imported);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    assert_int_equal(imported.note_count, note ? 2 : 1);
    if (note) assert_string_equal(imported.notes[0], note);
    assert_string_equal(imported.notes[imported.note_count - 1], cone);
    whirl_imported_free(&imported);
}

static void test_converted_lines(void **state) {
    (void)state;
    expect_line("", "", "    steel: {modulus: 211 GPa, shear_modulus: 81.2 GPa, density: 7810 kg/m3}\n");
    expect_line("", "", "    shaft: {material: steel, shear: cowper}\n");
    expect_line("", "", "    - segment: {length: 0.25 m, outer: 0.05 m}");
    expect_line("", "", "    - gravity: 9.8065 m/s2    # that of ROSS");
    expect_line("", "", "inner: 0.01 m, outer_end: 0.04 m,\n                inner_end: 0.01 m}");
    expect_line("", "", "    disk_0: {position: 0.25 m, mass: 30 kg, diametral: 0.2 kg.m2, polar: 0.3 kg.m2}");
    expect_line("", "", "    bearing_0: {position: 0 m}");
    expect_line("", "", "    bearing_1: {position: 0.5 m}");
    expect_line("", "", "    pedestal: {mass: 20 kg}");
    expect_line("", "", "    - bearing: {at: pedestal, mxx: 0 kg, myy: 5 kg}\n");
    expect_line("", "", "    - bearing: {at: bearing_1, from: pedestal, kxx: 1000000 N/m, mxx: 0.5 kg}\n");
    expect_line("", "", "    - bearing: {at: pedestal, kxx: 8000000 N/m, kyy: 9000000 N/m, cxx: 10 N s/m}\n");
    expect_line("", "",
                "        speeds: [0, 100, 400]\n        kxx: [1000000, 2000000, 3000000]\n        kxy: 5 N/m\n"
                "        cxx: 7 N s/m\n");
}

static void test_options_of_the_shaft(void **state) {
    static const char both[] = "idl = 0.0\nodl = 0.05\nn = 0\n";
    char text[4096];
    whirl_imported imported;
    (void)state;
    expect_line("n = 1\ntag", "n = 1\naxial_force = -20\ntag", "inner_end: 0.01 m, axial_force: -20 N}");
    expect_line("n = 1\ntag", "n = 1\nalpha = 2\ntag", "inner_end: 0.01 m, mass_damping: 2 1/s}");
    expect_line("n = 0\ntag", "n = 0\nalpha = 2\nshear_effects = false\ntag",
                "    shaft: {material: steel, shear: none, mass_damping: 2 1/s}\n");
    expect_line("n = 0\ntag", "n = 0\nalpha = 2\nshear_effects = false\ntag",
                "inner_end: 0.01 m, shear: cowper, mass_damping: 0 1/s}");
    static const char others[] = "n = 1\nbeta = 1e-5\ngyroscopic = false\nrotary_inertia = false\ntag";
    expect_line("n = 1\ntag", others, "inner_end: 0.01 m, rotary_inertia: no,");
    expect_line("n = 1\ntag", others, "gyroscopic: no, stiffness_damping: 1e-05 s}");
    // Switches of all elements.
    edit(both,
         "idl = 0.0\nodl = 0.05\nn = 0\nbeta = 1e-5\nalpha = 2\nrotary_inertia = false\ngyroscopic = false\n"
         "shear_method_calc = \"hutchinson\"\n",
         text, sizeof text);
    char *const second = strstr(text, "n = 1\ntag");
    char rest[4096];
    snprintf(rest, sizeof rest, "%s", second);
    snprintf(second, sizeof text - (size_t)(second - text), "%s%s",
             "beta = 1e-5\nalpha = 2\nrotary_inertia = false\ngyroscopic = false\nshear_method_calc = \"hutchinson\"\n",
             rest);
    assert_int_equal(whirl_import_parse(text, strlen(text), "r.toml", &imported).code, WHIRL_OK);
    assert_non_null(strstr(imported.text, "    shaft: {material: steel, shear: hutchinson, rotary_inertia: no, "));
    assert_non_null(strstr(imported.text, "gyroscopic: no,\n      mass_damping: 2 1/s, stiffness_damping: 1e-05 s}\n"));
    whirl_imported_free(&imported);
}

static void test_refused(void **state) {
    (void)state;
    expect_refused("L = 0.25", "L = \"long\"",
                   "r.toml:5: [ShaftElement_Shaft Element 0] L: is \"long\", expected a number in m");
    expect_refused("L = 0.25", "L = 0",
                   "r.toml:5: [ShaftElement_Shaft Element 0] L: is 0 m, expected a number above 0 m");
    expect_refused("L = 0.25", "L = inf",
                   "r.toml:5: [ShaftElement_Shaft Element 0] L: is inf m, expected a number above 0 m");
    expect_refused("L = 0.25\n", "", "r.toml:4: [ShaftElement_Shaft Element 0] L: is missing, expected a number in m");
    expect_refused("idl = 0.0\n", "idl = 0.05\n",
                   "r.toml:6: [ShaftElement_Shaft Element 0] idl: is 0.05 m, expected less than odl, 0.05 m");
    expect_refused("n = 0\ntag", "n = 0.5\ntag",
                   "r.toml:8: [ShaftElement_Shaft Element 0] n: is 0.5, expected a whole number from 0 to 1000000");
    expect_refused("n = 0\ntag", "n = 0\nshear_effects = 1\ntag",
                   "r.toml:9: [ShaftElement_Shaft Element 0] shear_effects: is 1, expected true or false");
    expect_refused("n = 0\ntag", "n = 0\nshear_method_calc = \"mindlin\"\ntag",
                   "r.toml:9: [ShaftElement_Shaft Element 0] shear_method_calc: is \"mindlin\", expected \"cowper\" or "
                   "\"hutchinson\"");
    expect_refused(
        "n = 1\ntag", "n = 4\ntag",
        "r.toml:16: [ShaftElement_Shaft Element 1] n: is 4 after 0, expected a shaft without a gap, or couplings from "
        "node 1 to 4: other rotors of several shafts are not taken over");
    expect_refused(
        "n = 1\ntag", "n = 0\nodl2 = 3\ntag",
        "r.toml:31: [BearingElement_Bearing 1] n: is 2, expected a node of the shaft, 0 to 1, or of a point mass");
    expect_refused(
        "L = 0.25\nidl = 0.01\nodl = 0.05\nidr = 0.01\nodr = 0.04\nn = 1",
        "L = 0.2\nidl = 0.01\nodl = 0.05\nidr = 0.01\nodr = 0.04\nn = 0",
        "r.toml:11: [ShaftElement_Shaft Element 1] L: is 0.2 m, expected 0.25 m, the length of 'Shaft Element 0' "
        "on the same node 0");
    expect_refused("n = 1\nm = 30.0", "n = 3\nm = 30.0",
                   "r.toml:19: [DiskElement_Disk 0] n: is 3, expected a node of the shaft, 0 to 2");
    expect_refused("Ip = 0.3", "", "r.toml:18: [DiskElement_Disk 0] Ip: is missing, expected a number in kg m2");
    expect_refused(
        "100.0, 400.0,]", "400.0, 100.0,]",
        "r.toml:25: [BearingElement_Bearing 0] frequency: goes from 400 to 100 rad/s, expected speeds that rise");
    expect_refused(
        "kxx = [ 1e6, 2e6, 3e6,]", "kxx = [ 1e6, 2e6,]",
        "r.toml:26: [BearingElement_Bearing 0] kxx: has 2 numbers, expected one, or as many as frequency has: 3");
    expect_refused("kxx = [ 1e6, 2e6, 3e6,]\n", "",
                   "r.toml:23: [BearingElement_Bearing 0] kxx: is missing, expected numbers in N/m");
    expect_refused("n_link = 3", "n_link = 2",
                   "r.toml:31: [BearingElement_Bearing 1] n_link: is 2 as n is, expected "
                   "another node");
    expect_refused(
        "n = 3\nmx", "n = 4\nmx",
        "r.toml:31: [BearingElement_Bearing 1] n_link: is 3, expected a node of the shaft, 0 to 2, or of a point "
        "mass");
    expect_refused("my = 25.0", "my = 0.0",
                   "r.toml:40: [PointMass_Pedestal] my: is 0 kg, expected a support with a mass "
                   "above 0 kg");
    expect_refused("E = 211e9", "E = -1",
                   "r.toml:47: [ShaftElement_Shaft Element 0.material] E: is -1 Pa, expected a number above 0 Pa");
    expect_refused(
        "G_s = 81.2e9", "G_s = 70e9",
        "r.toml:48: [ShaftElement_Shaft Element 0.material] G_s: is 7e+10 Pa, expected a third of E at least, "
        "7.033333333e+10 Pa: Poisson's ratio is 0.5 at most");
    expect_refused("name = \"Steel\"", "name = 3",
                   "r.toml:45: [ShaftElement_Shaft Element 0.material] name: is 3, expected a text");
}

static void test_refused_by_name(void **state) {
    (void)state;
    expect_refused(
        "n = 0\ntag", "n = 0\ntorque = 30.0\ntag",
        "r.toml:9: [ShaftElement_Shaft Element 0] torque: is not 0, expected a shaft without torque: it couples "
        "bending in a way that is not modelled here");
    expect_refused("DiskElement_Disk 0", "GearElement_Gear 0",
                   "r.toml:18: [GearElement_Gear 0]: gears couple shafts and twist, which is not taken over");
    expect_refused("DiskElement_Disk 0", "DiscElement_Disk 0",
                   "r.toml:18: [DiscElement_Disk 0]: is a DiscElement, expected DiskElement_...");
}

/// Writes the good file with a magnetic bearing in place of the support and its coefficients; `keys` follow the keys
/// that all magnetic bearings have.
static void magnet_with(const char *keys, char text[4096]) {
    edit("BearingElement_Support\"]\n", "MagneticBearingElement_Support\"]\n", text, 4096);
    char *const head = strstr(text, "MagneticBearingElement_Support\"]\n");
    assert_non_null(head);
    char *const at = strchr(head, '\n') + 1, *const behind = strstr(at, "[\"PointMass");
    char rest[4096], own[512];
    assert_non_null(behind);
    snprintf(rest, sizeof rest, "n = 3\n%s", behind);
    snprintf(own, sizeof own, "g0 = 0.001\ni0 = 2.0\nag = 4e-4\nnw = 240\n%s\n", keys);
    snprintf(at, 4096 - (size_t)(at - text), "%s%s", own, rest);
}

static void test_magnets(void **state) {
    static const struct {
        const char *keys, *line; ///< "!": what it is refused with
    } cases[] = {
        {"kp_pid = 2.0\nk_sense = 5e3", "proportional: 10000 A/m}"},
        {"kp_pid = [2.0, 2.0]\nk_amp = 3.0", "proportional: 6 A/m}"},
        {"kp_pid = 2.0\nkd_pid = 0.01\nn_f = 5e3", "derivative_filter: 0.0002 s}"},
        {"kp_pid = 2.0\nkd_pid = 0.01", "derivative_filter: 0.0001 s}"},
        {"kp_pid = 2.0\nalpha = -0.3", "pole_angle: 0.3 rad"},
        {"kp_pid = 0.0\nkxx = 8e6\ncxx = 10.0", "Controllers other than PID"},
        {"kp_pid = 2.0\nkxx = [8e6, 9e6]\ncxx = 10.0\nfrequency = [1, 10]", "frequencies: [1, 10"},
        {"kp_pid = [2.0, 3.0]", "!kp_pid: is 2 A/m along one axis and 3 along another, expected one number for both"},
        {"kp_pid = 1e308\nk_amp = 1e308", "!kp_pid: is infinite times the gains k_amp and k_sense"},
        {"kp_pid = 1.0\nk_amp = 0.0", "!k_amp: times k_sense is 0"},
        {"kp_pid = 1.0\nalpha = 2.0", "!alpha: is 2 rad"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[4096];
        whirl_imported imported;
        magnet_with(cases[i].keys, text);
        const whirl_status status = whirl_import_parse(text, strlen(text), "r.toml", &imported);
        const char *const said = status.code == WHIRL_OK ? imported.text : status.message;
        const bool refused = *cases[i].line == '!';
        if (refused != (status.code == WHIRL_BAD_INPUT) || !strstr(said, cases[i].line + refused))
            fail_msg("%s: expected %s, got %s", cases[i].keys, cases[i].line, said);
        whirl_imported_free(&imported);
    }
}

/// A film whose dimensions are in the file is written as a comment next to its coefficients.
static void test_film(void **state) {
    (void)state;
    expect_line("BearingElement_Support\"]\n",
                "CylindricalBearing_Support\"]\nweight = 525.0\nbearing_length = 0.03\njournal_diameter = 0.1\n"
                "radial_clearance = 1e-4\noil_viscosity = 0.1\n",
                "    # coefficients of the short film below under a load of 525 N; in motions with gravity it can "
                "replace them\n"
                "    # - film: {at: pedestal, law: short, radius: 0.05 m, length: 0.03 m, clearance: 0.0001 m, "
                "viscosity: 0.1 Pa s}\n");
}

/// Checks that a file is refused with a sentence, or gives a valid case.
static void expect_good_or_refused(const char *text, size_t length) {
    whirl_imported imported;
    const whirl_status status = whirl_import_parse(text, length, "r.toml", &imported);
    if (status.code != WHIRL_OK) {
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_memory_equal(status.message, "r.toml:", 7);
        return;
    }
    whirl_case *object = NULL;
    const whirl_status read = whirl_case_parse(imported.text, imported.length, "case", NULL, &object);
    if (read.code != WHIRL_OK) fail_msg("%s in\n%s", read.message, imported.text);
    whirl_case_free(object);
    whirl_imported_free(&imported);
}

/// Files in which any byte is left out or replaced by a byte that has a meaning in TOML are refused or valid.
static void test_broken_bytes(void **state) {
    static const char marks[] = "[]{}=.,\"'#\n\\ -";
    char text[sizeof good];
    (void)state;
    for (size_t at = 0; at + 1 < sizeof good; at++) {
        memcpy(text, good, sizeof good);
        text[at] = marks[at % (sizeof marks - 1)];
        expect_good_or_refused(text, sizeof good - 1);
        memmove(text + at, good + at + 1, sizeof good - 1 - at);
        expect_good_or_refused(text, sizeof good - 2);
    }
}

/// Files in which any value is replaced by an unusual number are refused or valid.
static void test_strange_numbers(void **state) {
    static const char *const numbers[] = {"0", "-1", "1e-30", "1e-9", "1e9", "1e30", "1e300", "nan"};
    char text[sizeof good + 16];
    (void)state;
    for (const char *c = strstr(good, "= "); c; c = strstr(c + 1, "= ")) {
        const char *const from = c + (c[2] == '[' ? 4 : 2), *const to = from + strcspn(from, ",\n");
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            snprintf(text, sizeof text, "%.*s%s%s", (int)(from - good), good, numbers[i], to);
            expect_good_or_refused(text, strlen(text));
        }
    }
}

/// Imports the good file in the format of ROSS 3 with another table; expects a line of the case, or the message.
static void expect_of_3(const char *table, const char *line, const char *message) {
    static const char old[] = "frequency = [ 0.0, 100.0, 400.0,]\nkxx = [ 1e6, 2e6, 3e6,]";
    char text[4096], whole[4096];
    whirl_imported imported;
    edit("2.3.0", "3.0.0", text, sizeof text);
    const char *const place = strstr(text, old);
    assert_non_null(place);
    snprintf(whole, sizeof whole, "%.*s%s%s", (int)(place - text), text, table, place + strlen(old));
    const whirl_status status = whirl_import_parse(whole, strlen(whole), "r.toml", &imported);
    if (line ? status.code != WHIRL_OK : strcmp(status.message, message) != 0) fail_msg("%s", status.message);
    const size_t notes =
        line && strstr(line, "frequencies") ? 2 : 1; // about the rational function of a table in motions
    if (line && (!strstr(imported.text, line) || imported.note_count != notes)) fail_msg("%s", imported.text);
    whirl_imported_free(&imported);
}

/// Motions use a rational function in place of such a table; if none can be fitted, the reason is given.
static void in_time(void **state) {
    static const struct {
        const char *table, *note;
    } tables[] = {
        {"frequency = [ 0, 100, 200, 400, 600, 800,]\nkxx = [ 1e6, 1.01e6, 1.02e6, 1.03e6, 1.035e6, 1.04e6,]",
         "In motions at the speed of the case a rational function replaces a table over frequencies of whirl: "
         "bearing at bearing_0: in time 4 poles, off its table by "},
        {"frequency = [ 0, 100, 400,]\nkxx = [ 1e6, 8e6, 3e6,]",
         "Motions at the speed of the case are refused: bearing differs from its table by "}};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        static const char old[] = "frequency = [ 0.0, 100.0, 400.0,]\nkxx = [ 1e6, 2e6, 3e6,]\nkxy = [ 5.0,]\ncxx = [ "
                                  "7, 7, 7,]";
        char text[4096], whole[4096];
        whirl_imported imported;
        edit("2.3.0", "3.0.0", text, sizeof text);
        const char *const place = strstr(text, old);
        assert_non_null(place);
        snprintf(whole, sizeof whole, "%.*s%s\ncxx = [7]%s", (int)(place - text), text, tables[i].table,
                 place + strlen(old));
        const whirl_status status = whirl_import_parse(whole, strlen(whole), "r.toml", &imported);
        if (status.code != WHIRL_OK) fail_msg("%s", status.message);
        assert_int_equal(imported.note_count, 2);
        if (strncmp(imported.notes[1], tables[i].note, strlen(tables[i].note)) != 0) fail_msg("%s", imported.notes[1]);
        whirl_imported_free(&imported);
    }
}

/// From ROSS 3 on the speeds are called speed, and frequency is that of whirl.
static void ross3(void **state) {
    (void)state;
    expect_of_3("speed = [ 0.0, 100.0, 400.0,]\nkxx = [ 1e6, 2e6, 3e6,]", "        speeds: [0, 100, 400]\n", NULL);
    expect_of_3("speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1e6, 1e6], [2e6, 2e6], [3e6, 3e6] ]",
                "        kxx: [1000000, 2000000, 3000000]\n", NULL);
    expect_of_3("speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1e6, 1e6], [2e6, 9e6], [3e6, 3e6] ]",
                "        speeds: [0, 100, 400]\n        frequencies: [50, 90]\n        kxx:\n"
                "          - [1000000, 1000000]\n          - [2000000, 9000000]\n          - [3000000, 3000000]\n",
                NULL);
    expect_of_3("speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1e6, 2e6], [1e6, 2e6], [1e6, 2e6] ]",
                "        frequencies: [50, 90]\n        kxx: [1000000, 2000000]\n", NULL);
    expect_of_3("speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1e6, 1e6], [2e6, 9e6] ]", NULL,
                "r.toml:27: [BearingElement_Bearing 0] kxx: has 2 rows, expected as many as speed has: 3");
    expect_of_3(
        "speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1e6], [2e6, 9e6], [3e6] ]", NULL,
        "r.toml:27: [BearingElement_Bearing 0] kxx: has a row of 2 numbers after one of 1, expected equal rows");
    expect_of_3("speed = [ 0, 100, 400,]\nfrequency = [ 50, 90,]\nkxx = [ [1, 2, 3], [2, 2, 2], [1, 1, 1] ]", NULL,
                "r.toml:27: [BearingElement_Bearing 0] kxx: has rows of 3 numbers, expected as many as frequency has: "
                "2");
    expect_of_3("frequency = [ 90, 50,]\nkxx = [ 1e6, 2e6,]", NULL,
                "r.toml:25: [BearingElement_Bearing 0] frequency: goes from 90 to 50 rad/s, expected frequencies that "
                "rise");
    expect_of_3("speed = [ 0, 100,]\nkxx = [ 1e6, 2e6, 3e6,]", NULL,
                "r.toml:26: [BearingElement_Bearing 0] kxx: has 3 numbers, expected one, or as many as speed has: 2");
    expect_of_3("frequency = [ 0, 100, 400,]\nkxx = [ 1e6, 2e6, 3e6,]",
                "        frequencies: [0, 100, 400]\n        kxx: [1000000, 2000000, 3000000]\n", NULL);
    expect_of_3("frequency = [ 0, 100, 400,]\nkxx = [ 1e6, 2e6,]", NULL,
                "r.toml:26: [BearingElement_Bearing 0] kxx: has 2 numbers, expected one, or as many as frequency has: "
                "3");
}

static void test_no_machine(void **state) {
    (void)state;
    expect_refused("L = 0.25\nidl = 0.01", "L = 1e-12\nidl = 0.01",
                   "r.toml: converts to an invalid case: rotor: stations 'disk_0' and 'bearing_1' lie on the same "
                   "place of a shaft");
    expect_refused("n = 1\ntag", "n = 1\naxial_force = -1e9\ntag",
                   "r.toml: converts to an invalid case: rotor: shaft 1 gives way between its stations: its axial "
                   "force buckles it");
}

static void test_no_rotor(void **state) {
    static const struct {
        const char *text, *message;
    } files[] = {
        {"", "r.toml: has no section [ShaftElement_...], expected a rotor that ROSS has saved (Rotor.save)"},
        {"{}", "r.toml: has no section [ShaftElement_...], expected a rotor that ROSS has saved (Rotor.save)"},
        {"a = 1\n", "r.toml:1: [a]: is 1, expected a section of a rotor saved by ROSS"},
        {"{\"a\": null}", "r.toml: [a]: is null, expected a section of a rotor saved by ROSS"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        whirl_imported imported;
        const whirl_status status = whirl_import_parse(files[i].text, strlen(files[i].text), "r.toml", &imported);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_string_equal(status.message, files[i].message);
    }
    static const char *const broken[][2] = {{"a = \n", "r.toml:1: is no TOML: "},
                                            {"[a]\n[a]\n", "r.toml:2: is no TOML: "},
                                            {"[\n", "r.toml:1: is no TOML: "},
                                            {"[}", "r.toml:1: is no TOML: "},
                                            {"a = 1\n[[[1]]]\n", "r.toml:2: is no TOML: "},
                                            {"{\n\"a\": }", "r.toml:2: is no JSON: "},
                                            {"{\"a\": 1, \"a\": 2}", "r.toml:1: is no JSON: "}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        whirl_imported imported;
        const whirl_status status = whirl_import_parse(broken[i][0], strlen(broken[i][0]), "r.toml", &imported);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        if (strncmp(status.message, broken[i][1], strlen(broken[i][1])) != 0) fail_msg("%s", status.message);
    }
}

#define SKEW_MASS                                                                                                      \
    "Modes here may be damped otherwise than in ROSS: unequal added masses mxy and myx become their mean, since "      \
    "inertia is symmetric here. Half of their difference, given after each name, is lost. On a mode that whirls at "   \
    "omega it acts like a damping of omega times this mass; compare that with cxx: "
#define HUTCHINSON                                                                                                     \
    "ROSS's own frequencies are lower, by 0.1 to 0.5 % in the first mode of shafts 20 to 5 times as long as thick, "   \
    "by more in higher ones: its shear factor has 1 + nu where Hutchinson's has (1 + nu)^2: "
#define ROTARY                                                                                                         \
    "ROSS's own modes are faster forward and slower backward, by some 0.1 % at 3000 rpm and 0.5 % at 10 000 rpm: "     \
    "it keeps the gyroscopic moments of shafts without rotary inertia, which have none here: "

static void test_notes(void **state) {
    (void)state;
    expect_note("", "", NULL);
    expect_note("m = 30.0", "m = 30.0\ncolor = \"red\"",
                "Colours and scale factors, which only drawings use, are left out.");
    expect_note("n = 3\nkxx", "n = 3\nkzz = [ 1,]\nkxx",
                "Axial coefficients (kzz, czz, mzz) are left out, for imported rotors move across their shafts alone: "
                "'Support'.");
    expect_note("n = 3\nkxx", "n = 3\nkzz = [ 0,]\nkxx", NULL);
    expect_note("BearingElement_Support\"]", "SealElement_Support\"]\nseal_leakage = 0.1",
                "The leakage of seals is left out: 'Support'.");
    expect_note(
        "BearingElement_Support\"]", "LabyrinthSeal_Support\"]\nn_teeth = 16",
        "Keys for the computation of coefficients are left out; the coefficients of the file are used: 'Support'.");
    expect_note("m = 30.0", "m = 30.0\nbore = 1",
                "Keys that are not known here are left out: 'bore of DiskElement_Disk 0'.");
    expect_note("m = 30.0", "m = 30.0\nbore = 1\nkeyway = 2\nhub = 3\nrim = 4",
                "Keys that are not known here are left out: 'bore of DiskElement_Disk 0', 'keyway of DiskElement_Disk "
                "0', 'hub of DiskElement_Disk 0' and 1 more.");
    expect_note("my = 25.0", "my = 25.0\nmz = 7",
                "Masses along the shaft (mz) that differ from mx are left out, for imported rotors move across their "
                "shafts alone: 'Pedestal'.");
    expect_note("mxx = [ 0.5,]", "mxx = [ 0.5,]\nmxy = [ 0.1,]\nmyx = [ 0.3,]", SKEW_MASS "'Bearing 1, 0.1 kg'.");
    expect_note("kxx = [ 1e6, 2e6, 3e6,]", "kxx = [ 1e6, 2e6, 3e6,]\nmxx = 9\nmxy = [ 1, 2, 3,]\nmyx = [ -1, 0, -5,]",
                SKEW_MASS "'Bearing 0, 4 kg'.");
    expect_note("mxx = [ 0.5,]", "mxx = [ 0.5,]\nmxy = [ 0.1,]\nmyx = [ 0.1,]", NULL);
    expect_line("mxx = [ 0.5,]", "mxx = [ 0.5,]\nmxy = [ 0.1,]\nmyx = [ 0.3,]", "mxx: 0.5 kg, mxy: 0.2 kg}");
    expect_note("[\"BearingElement_Support",
                "[\"ThrustPad_Collar\"]\nn = 2\nkxx = [ 0,]\ncxx = [ 0,]\nkzz = [ 0,]\n"
                "[\"BearingElement_Support",
                "Sections without lateral coefficients are left out: 'Collar'.");
}

/// Notes name what ROSS computes differently from the same numbers.
static void test_differences(void **state) {
    (void)state;
    expect_note("n = 1\ntag", "n = 1\nshear_method_calc = \"hutchinson\"\ntag", HUTCHINSON "'Shaft Element 1'.");
    expect_note("n = 1\ntag", "n = 1\nshear_effects = false\nshear_method_calc = \"hutchinson\"\ntag", NULL);
    expect_note("n = 1\ntag", "n = 1\nrotary_inertia = false\ntag", ROTARY "'Shaft Element 1'.");
    expect_note("n = 1\ntag", "n = 1\nrotary_inertia = false\ngyroscopic = false\ntag", NULL);
    // A bore that widens is a cone as well.
    char text[4096];
    whirl_imported imported;
    edit("idr = 0.01\nodr = 0.04", "idr = 0.02\nodr = 0.05", text, sizeof text);
    assert_int_equal(whirl_import_parse(text, strlen(text), "r.toml", &imported).code, WHIRL_OK);
    assert_int_equal(imported.note_count, 1);
    assert_string_equal(imported.notes[0], cone);
    whirl_imported_free(&imported);
    edit("idr = 0.01\nodr = 0.04", "idr = 0.01\nodr = 0.05", text, sizeof text);
    assert_int_equal(whirl_import_parse(text, strlen(text), "r.toml", &imported).code, WHIRL_OK);
    assert_int_equal(imported.note_count, 0);
    whirl_imported_free(&imported);
}

static void test_speeds(void **state) {
    (void)state;
    expect_line("", "", "  speed: 300 rad/s    # of 0 to 300 rad/s: those that the file names\n");
    expect_line("max_w = 300.0\n", "rated_w = 209.43951023931953\nmax_w = 300.0\n", "  speed: 2000 rpm ");
    expect_line("max_w = 300.0\n", "",
                "  speed: 400 rad/s    # of 0 to 400 rad/s: those of the tables, as the file names no speeds\n");
    expect_note("max_w = 300.0\n", "max_w = 500.0\n",
                "The study's speeds are cut to those of the tables, 0 to 400 rad/s.");
    expect_line("max_w = 300.0\n", "max_w = 500.0\n", "  speed: 400 rad/s ");
    expect_line("max_w = 300.0", "min_w = 10\nmax_w = 300", "# of 10 to 300 rad/s");
    expect_refused("max_w = 300.0", "min_w = 400\nmax_w = 300",
                   "r.toml:3: [parameters] min_w: is 400 rad/s, expected at most max_w, 300 rad/s");
    expect_refused(
        "n = 2\nn_link = 3\nkxx = [ 1000000,]",
        "n = 2\nn_link = 3\nfrequency = [ 500, 600,]\nkxx = [ 1000000, 2000000,]",
        "r.toml:32: [BearingElement_Bearing 1] frequency: begins at 500 rad/s, where another table ends or has "
        "ended (400 rad/s), expected tables with speeds in common");
}

/// Names of stations are valid and unique, whatever the tags.
static void test_names(void **state) {
    (void)state;
    expect_line("BearingElement_Support", "BearingElement_Disk 0", "    disk_0: {position: 0.25 m");
    expect_line("PointMass_Pedestal", "PointMass_Disk 0", "    disk_0_2: {mass: 20 kg}");
    expect_line("PointMass_Pedestal", "PointMass_ground", "    ground_2: {mass: 20 kg}");
    expect_line("PointMass_Pedestal", "PointMass_4711", "    node_3: {mass: 20 kg}");
    expect_line("PointMass_Pedestal", "PointMass_\\u00c4, {x: y} #", "    x_y: {mass: 20 kg}");
    expect_line("\"BearingElement_Support\"", "\"BearingElement_a\\nwhirl: 2\"", "    # a?whirl: 2, node 3\n");
}

/// A rotor as TOML and as JSON (with null for keys that TOML leaves out) gives the same case.
static void test_json(void **state) {
    static const char toml[] = "[ShaftElement_1]\nL = 1\nidl = 0\nodl = 0.1\nn = 0\n"
                               "[ShaftElement_1.material]\nname = \"a\"\nrho = 1\nE = 3\nG_s = 1\n";
    static const char json[] =
        "\n{\"_note\": \"...\", \"parameters\": {\"min_w\": null},\n\"ShaftElement_1\": {\"L\": 1.0, "
        "\"idl\": 0, \"odl\": 1e-1, \"idr\": null, \"n\": 0,\n\"material\": {\"name\": \"a\", \"rho\": 1, "
        "\"E\": 3, \"G_s\": 1}}}";
    whirl_imported one, other;
    (void)state;
    assert_int_equal(whirl_import_parse(toml, strlen(toml), "r", &one).code, WHIRL_OK);
    assert_int_equal(whirl_import_parse(json, strlen(json), "r", &other).code, WHIRL_OK);
    assert_string_equal(one.text, other.text);
    assert_non_null(strstr(one.text, "    left_end: {position: 0 m}"));
    assert_non_null(strstr(one.text, "    right_end: {position: 1 m}"));
    whirl_imported_free(&one);
    whirl_imported_free(&other);
}

/// More speeds than a bearing takes are thinned, both ends kept.
static void test_long_tables(void **state) {
    char table[2048] = "frequency = [ ", list[1024] = "kxx = [ ";
    (void)state;
    for (int i = 0; i < 63; i++) {
        snprintf(table + strlen(table), sizeof table - strlen(table), "%d, ", i * 10);
        snprintf(list + strlen(list), sizeof list - strlen(list), "%d, ", i * 10 + 1);
    }
    strcat(strcat(strcat(table, "]\n"), list), "]");
    static const char from[] =
        "frequency = [ 0.0, 100.0, 400.0,]\nkxx = [ 1e6, 2e6, 3e6,]\nkxy = [ 5.0,]\ncxx = [ 7, 7, 7,]";
    expect_note(from, table, "Tables of more speeds than a bearing takes here are thinned, evenly: 'Bearing 0'.");
    expect_line(from, table, "speeds: [0, 20, 40, 60,");
    expect_line(from, table, " 580, 600, 620]\n");
    expect_line(from, table, "kxx: [1, 21, 41, 61,");
}

static void test_deep_and_large(void **state) {
    const size_t size = (1 << 24) + 2;
    char *const text = malloc(size);
    whirl_imported imported;
    (void)state;
    for (int json = 0; json < 2; json++) {
        memset(text, '[', 100000);
        if (json) memcpy(text, "{\"a\":", 5);
        if (!json) memcpy(text, "a = [", 5);
        const whirl_status status = whirl_import_parse(text, 100000, "r", &imported);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
    }
    memset(text, '\n', size);
    const whirl_status status = whirl_import_parse(text, size, "r", &imported);
    assert_string_equal(status.message, "r: is larger than 16 MiB, expected a rotor saved by ROSS");
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_converted_lines),
        cmocka_unit_test(test_options_of_the_shaft),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_refused_by_name),
        cmocka_unit_test(test_magnets),
        cmocka_unit_test(test_film),
        cmocka_unit_test(test_no_rotor),
        cmocka_unit_test(test_notes),
        cmocka_unit_test(test_differences),
        cmocka_unit_test(test_speeds),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_json),
        cmocka_unit_test(test_long_tables),
        cmocka_unit_test(test_deep_and_large),
        cmocka_unit_test(test_broken_bytes),
        cmocka_unit_test(test_strange_numbers),
        cmocka_unit_test(test_no_machine),
        cmocka_unit_test(ross3),
        cmocka_unit_test(in_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
