#include "note.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

enum { NOTE_SIZE = 800, NAMES_SIZE = 320 };

/// The sentence of each kind; %s stands for the tags of the sections.
static const char *const sentences[NOTE_KINDS] = {
    [NOTE_DRAWING] = "Colours and scale factors, which only drawings use, are left out.",
    [NOTE_AXIAL] =
        "Axial coefficients (kzz, czz, mzz) are left out, for imported rotors move across their shafts alone: %s.",
    [NOTE_AXIAL_MASS] = "Masses along the shaft (mz) that differ from mx are left out, for imported rotors move across "
                        "their shafts alone: %s.",
    [NOTE_LEAKAGE] = "The leakage of seals is left out: %s.",
    [NOTE_NOTHING_LATERAL] = "Sections without lateral coefficients are left out: %s.",
    [NOTE_SKEW_MASS] =
        "Modes here may be damped otherwise than in ROSS: unequal added masses mxy and myx become their mean, since "
        "inertia is symmetric here. Half of their difference, given after each name, is lost. On a mode that whirls at "
        "omega it acts like a damping of omega times this mass; compare that with cxx: %s.",
    [NOTE_THINNED] = "Tables of more speeds than a bearing takes here are thinned, evenly: %s.",
    [NOTE_EXTRA] = "Keys for the computation of coefficients are left out; the coefficients of the file are used: %s.",
    [NOTE_UNKNOWN] = "Keys that are not known here are left out: %s.",
    [NOTE_AXIAL_DAMPING] = "whirl applies beta to the stiffness without the axial force: %s.",
    [NOTE_COUPLING_AXIAL] = "Axial and torsional coefficients of couplings (kt_z, kr_z, ct_z, cr_z) are left out, for "
                            "imported rotors move across their shafts alone: %s.",
    [NOTE_COUPLING_LENGTH] = "Lengths and diameters of couplings (L, o_d) are left out; no force depends on them, in "
                             "ROSS neither: %s.",
    [NOTE_COUPLING_LOOSE] =
        "Couplings without lateral coefficients join nothing here; their masses are taken over: %s.",
    [NOTE_HUTCHINSON] =
        "ROSS's own frequencies are lower, by 0.1 to 0.5 % in the first mode of shafts 20 to 5 times as long as thick, "
        "by more in higher ones: its shear factor has 1 + nu where Hutchinson's has (1 + nu)^2: %s.",
    [NOTE_ROTARY] =
        "ROSS's own modes are faster forward and slower backward, by some 0.1 % at 3000 rpm and 0.5 % at 10 000 rpm: "
        "it keeps the gyroscopic moments of shafts without rotary inertia, which have none here: %s.",
    [NOTE_CONE] =
        "ROSS's own frequencies are higher, by about 0.5 % where a diameter grows by half along an element and 2 % "
        "where it doubles: its cones are too stiff, those here agree with fine steps of cylinders: %s.",
    [NOTE_MAGNETIC] =
        "Magnetic bearings have their magnets and their controller here, and modes have its poles; ROSS's own modes "
        "use linear coefficients instead. Limits of the current are not in the file: %s.",
    [NOTE_MAGNETIC_TABLE] = "Controllers other than PID are not in the file: these magnetic bearings have "
                            "the file's coefficients over the frequency of whirl instead: %s.",
    [NOTE_MAGNETIC_FILTER] = "Derivatives of controllers without a filter get the default filter of ROSS 2.1, "
                             "10 000 rad/s: %s.",
};

static void add_text(note_list *to, char *text) {
    whirl_make_plain(text);
    note *const one = arena_take(to->arena, sizeof *one);
    const char *const copy = arena_text(to->arena, text, strlen(text));
    to->no_memory = to->no_memory || !one || !copy;
    if (!one || !copy) return;
    one->text = copy;
    *(to->last ? &to->last->next : &to->first) = one;
    to->last = one;
    to->count++;
}

void note_add(note_list *to, const char *format, ...) {
    char text[NOTE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    add_text(to, text);
}

void note_of(note_list *to, note_kind kind, const char *tag) {
    note_tags *const tags = &to->tags[kind];
    const size_t most = sizeof tags->first / sizeof *tags->first;
    if (tags->count < most) tags->first[tags->count] = tag;
    tags->count++;
}

/// Writes the tags as "'A', 'B', 'C' and 4 more".
static void list_tags(const note_tags *tags, char names[NAMES_SIZE]) {
    const size_t most = sizeof tags->first / sizeof *tags->first;
    size_t used = 0;
    for (size_t i = 0; i < tags->count && i < most; i++)
        used += (size_t)snprintf(names + used, NAMES_SIZE - used, "%s'%.80s'", i ? ", " : "", tags->first[i]);
    if (tags->count > most) snprintf(names + used, NAMES_SIZE - used, " and %zu more", tags->count - most);
}

void note_finish(note_list *to) {
    char names[NAMES_SIZE], text[NOTE_SIZE];
    for (int kind = 0; kind < NOTE_KINDS; kind++) {
        if (to->tags[kind].count == 0) continue;
        list_tags(&to->tags[kind], names);
        const char *const place = strstr(sentences[kind], "%s");
        if (place)
            snprintf(text, sizeof text, "%.*s%s%s", (int)(place - sentences[kind]), sentences[kind], names, place + 2);
        else
            snprintf(text, sizeof text, "%s", sentences[kind]);
        add_text(to, text);
    }
}
