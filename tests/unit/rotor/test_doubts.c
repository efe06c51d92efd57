// Values outside the range of a law, or of any such part: the warnings of each element, and valid values without one.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/rotor.h"

enum { MAX_SETTINGS = 10 };

/// An element with values, and the keys that are doubted, in order.
typedef struct example {
    const char *kind;
    whirl_setting values[MAX_SETTINGS];
    const char *doubted;
} example;

static void collect_key(void *context, size_t element, const char *key, const char *sentence) {
    char *const keys = context;
    assert_int_equal(element, 0);
    assert_true(strncmp(sentence, "is ", 3) == 0);
    snprintf(keys + strlen(keys), 64 - strlen(keys), "%s%s", *keys ? " " : "", key);
}

static void check(const example *of) {
    const whirl_setting mass = {.key = "mass", .number = 1.0};
    whirl_design *design;
    char doubted[64] = "";
    size_t count = 0;
    while (count < MAX_SETTINGS && of->values[count].key) count++;
    assert_int_equal(whirl_design_new(300.0, 1e-4, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "disc", &mass, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "ring", &mass, 1).code, WHIRL_OK);
    const whirl_status added = whirl_design_element(design, of->kind, of->values, count);
    if (added.code != WHIRL_OK) fail_msg("%s", added.message);
    whirl_design_doubts(design, collect_key, doubted);
    if (strcmp(doubted, of->doubted) != 0) fail_msg("%s doubts '%s', expected '%s'", of->kind, doubted, of->doubted);
    whirl_design_free(design);
}

#define FILM(c, r, l)                                                                                                  \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"clearance", c, NULL}, {"viscosity", 0.02, NULL}, {"radius", r, NULL}, {                   \
            "length", l, NULL                                                                                          \
        }                                                                                                              \
    }
#define FINITE(l)                                                                                                      \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"law", 0, "finite"}, {"clearance", 5e-5, NULL}, {"viscosity", 0.02, NULL},                 \
            {"radius", 0.025, NULL}, {                                                                                 \
            "length", l, NULL                                                                                          \
        }                                                                                                              \
    }
#define DAMPER(law, l)                                                                                                 \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"law", 0, law}, {"clearance", 1e-4, NULL}, {"viscosity", 0.02, NULL},                      \
            {"radius", 0.05, NULL}, {                                                                                  \
            "length", l, NULL                                                                                          \
        }                                                                                                              \
    }
#define RING(l)                                                                                                        \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"ring", 0, "ring"}, {"inertia", 4e-7, NULL}, {"viscosity", 0.02, NULL},                    \
            {"clearance", 2e-5, NULL}, {"radius", 0.005, NULL}, {"length", 0.005, NULL},                               \
            {"outer_clearance", 4e-5, NULL}, {"outer_radius", 0.008, NULL}, {                                          \
            "outer_length", l, NULL                                                                                    \
        }                                                                                                              \
    }
#define SEAL(r, n, b)                                                                                                  \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"clearance", 1e-3, NULL}, {"ratio", r, NULL}, {"growth", n, NULL}, {                       \
            "slowing", b, NULL                                                                                         \
        }                                                                                                              \
    }
#define RUB(gap)                                                                                                       \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"gap", gap, NULL}, {"stiffness", 1e6, NULL}, {"law", 0, "slip"}, {                         \
            "radius", 0.1, NULL                                                                                        \
        }                                                                                                              \
    }
#define BALLS(c)                                                                                                       \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"balls", 8, NULL}, {"stiffness", 1e10, NULL}, {"clearance", c, NULL},                      \
            {"inner", 0.02, NULL}, {                                                                                   \
            "outer", 0.03, NULL                                                                                        \
        }                                                                                                              \
    }

#define BLACK(l, drop)                                                                                                 \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"law", 0, "black"}, {"clearance", 2e-4, NULL}, {"radius", 0.05, NULL},                     \
            {"length", l, NULL}, {"density", 1000.0, NULL}, {"viscosity", 1e-3, NULL}, {                               \
            "pressure", drop, NULL                                                                                     \
        }                                                                                                              \
    }
#define DENTED(h)                                                                                                      \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"balls", 8, NULL}, {"stiffness", 1e10, NULL}, {"outer_dent", h, NULL},                     \
            {"outer_dent_width", 0.1, NULL}, {"inner", 0.02, NULL}, {                                                  \
            "outer", 0.03, NULL                                                                                        \
        }                                                                                                              \
    }
#define OBLIQUE(load)                                                                                                  \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"balls", 8, NULL}, {"stiffness", 1e10, NULL}, {"cage", 0.4, NULL},                         \
            {"contact_angle", 0.4, NULL}, {"centres", 4e-4, NULL}, {                                                   \
            "axial_load", load, NULL                                                                                   \
        }                                                                                                              \
    }
#define CONTACT(gap, e)                                                                                                \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"gap", gap, NULL}, {"stiffness", 1e8, NULL}, {"law", 0, "lankarani_nikravesh"},            \
            {"restitution", e, NULL}, {"impact_speed", 0.2, NULL}, {"friction", 0.1, NULL}, {                          \
            "radius", 0.1, NULL                                                                                        \
        }                                                                                                              \
    }
#define BRISTLES(damping)                                                                                              \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"gap", 1e-3, NULL}, {"stiffness", 1e8, NULL}, {"friction_law", 0, "lugre"},                \
            {"friction", 0.1, NULL}, {"static_friction", 0.2, NULL}, {"stribeck_speed", 0.01, NULL},                   \
            {"bristle_stiffness", 1e4, NULL}, {"bristle_damping", damping, NULL}, {                                    \
            "radius", 0.1, NULL                                                                                        \
        }                                                                                                              \
    }
#define MAGNETS(bias)                                                                                                  \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"turns", 120, NULL}, {"area", 4e-4, NULL}, {"gap", 5e-4, NULL}, {"bias", bias, NULL}, {    \
            "proportional", 2e4, NULL                                                                                  \
        }                                                                                                              \
    }
#define BLADES(extension)                                                                                              \
    {                                                                                                                  \
        {"at", 0, "disc"}, {"blades", 5, NULL}, {"radius", 0.3, NULL}, {"gap", 1e-3, NULL}, {"stiffness", 0, "1e6"}, { \
            "extension", 0, #extension                                                                                 \
        }                                                                                                              \
    }

static void every_element_doubts_what_it_is_not_for(void **unused) {
    (void)unused;
    static const example examples[] = {
        {"film", FILM(5e-5, 0.025, 0.025), ""}, // L/D = 0.5 itself is within
        {"film", FILM(5e-5, 0.025, 0.026), "length"},
        {"film", FILM(70.0, 35.0, 1.0), "clearance radius"}, // mm left out
        {"film", FILM(0.07, 35.0, 1.0), "radius"},           // ... of all but the clearance
        {"film", FILM(5e-5, 35.0, 1.0), "clearance radius"},
        {"film", FILM(1e-3, 0.025, 0.2), "length clearance"},
        {"film", FINITE(0.1), ""},
        {"film", FINITE(0.0049), "length"},
        {"film", FINITE(0.11), "length"},
        {"floating_ring", RING(0.008), ""},
        {"floating_ring", RING(0.009), "outer_length"},
        {"squeeze", DAMPER("short", 0.05), ""},
        {"squeeze", DAMPER("short", 0.06), "length"},
        {"squeeze", DAMPER("long", 0.2), ""}, // sealed ends
        {"seal", SEAL(0.48, 3.0, 1.0), ""},
        {"seal", SEAL(0.6, 2.0, 0.5), "ratio"},
        {"seal", SEAL(0.4, 4.0, 1.5), "growth slowing"},
        {"seal", BLACK(0.05, 1e6), ""},
        {"seal", BLACK(0.06, 1e6), "length"},
        {"seal", BLACK(0.05, 1e9), "pressure"},
        {"rub", RUB(1e-3), ""},
        {"rub", RUB(0.2), "gap"},
        {"contact", CONTACT(1e-3, 0.95), ""},
        {"contact", CONTACT(0.2, 0.95), "gap"},
        {"contact", CONTACT(1e-3, 0.7), "restitution"},
        {"contact", BRISTLES(1e-3), ""},
        {"contact", BRISTLES(0.3), "bristle_damping"},
        {"magnetic", MAGNETS(3.0), ""},
        {"magnetic", MAGNETS(30.0), "bias"},
        {"blade_rub", BLADES(1e-4), ""},
        {"blade_rub", BLADES(2e-3), "extension"},
        {"ball_bearing", BALLS(1e-5), ""},
        {"ball_bearing", BALLS(-1e-3), "clearance"},
        {"ball_bearing", DENTED(3e-4), "outer_dent"},
        {"ball_bearing", OBLIQUE(300.0), ""},
        {"ball_bearing", OBLIQUE(1e6), "axial_load"},
    };
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) check(&examples[i]);
}

/// Without a radius the length cannot be doubted.
static void a_film_by_its_load_is_not_doubted(void **unused) {
    (void)unused;
    const example by_load = {"film", {{"at", 0, "disc"}, {"clearance", 1.0, NULL}, {"load", 100.0, NULL}}, ""};
    check(&by_load);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_element_doubts_what_it_is_not_for),
                                       cmocka_unit_test(a_film_by_its_load_is_not_doubted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
