/* The gateway of whirl_machine, whirl_rhs, whirl_element and whirl_signals, for mkoctfile --mex and for MATLAB's mex.
 *
 * The gateway keeps machines until they or the gateway are cleared. Scripts have numbers, not pointers, of machines.
 * Each number is used only once, so that the number of a cleared machine never means another one. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "mex.h"
#include "whirl/engine.h"

enum { MAX_MACHINES = 64, MAX_ELEMENTS = 16, WORD = 256 };

typedef struct machine {
    double number;
    whirl_case *given;
    whirl_rotor *rotor;
    size_t elements;
    char names[MAX_ELEMENTS][WORD];
    whirl_rotor *alone[MAX_ELEMENTS]; /* rotors with one element each, built at the first use */
} machine;

static machine machines[MAX_MACHINES];

/* Returns a number for a machine. Numbers begin with the microseconds of the clock, so that a gateway that is loaded
 * again uses no earlier number: making a machine takes longer than a microsecond. */
static double next_number(void) {
    static double last;
    struct timespec now = {0};
    if (last == 0.0 && timespec_get(&now, TIME_UTC)) last = 1e6 * (double)now.tv_sec + (double)(now.tv_nsec / 1000);
    return ++last;
}

static void clear(machine *one) {
    for (size_t i = 0; i < one->elements; ++i) whirl_rotor_free(one->alone[i]);
    whirl_rotor_free(one->rotor);
    whirl_case_free(one->given);
    memset(one, 0, sizeof *one);
}

static void clear_all(void) {
    for (size_t i = 0; i < MAX_MACHINES; ++i) clear(&machines[i]);
}

/* Raises the error of a status. It leaves by a jump, so that the caller must have freed everything before. */
static void mex_check(whirl_status status) {
    char message[WHIRL_MESSAGE_SIZE];
    if (status.code == WHIRL_OK) return;
    snprintf(message, sizeof message, "%s", status.message);
    mexErrMsgIdAndTxt(status.code == WHIRL_BAD_INPUT ? "whirl:badInput" : "whirl:failed", "%s", message);
}

static void word_of(const mxArray *array, const char *what, char word[WORD]) {
    if (!mxIsChar(array) || mxGetString(array, word, WORD) != 0)
        mexErrMsgIdAndTxt("whirl:badInput", "%s is no text of at most %d characters", what, WORD - 1);
}

static machine *machine_of(const mxArray *array) {
    const double number = mxIsDouble(array) && mxGetNumberOfElements(array) == 1 ? mxGetScalar(array) : 0.0;
    for (size_t i = 0; i < MAX_MACHINES; ++i)
        if (machines[i].rotor && machines[i].number == number) return &machines[i];
    mexErrMsgIdAndTxt("whirl:badInput", "there is no such machine: it was cleared, or is not of whirl_machine");
    return NULL;
}

/* ---------------------------------------------------------------- machines */

static machine *free_place(void) {
    for (size_t i = 0; i < MAX_MACHINES; ++i)
        if (!machines[i].rotor) return &machines[i];
    mexErrMsgIdAndTxt("whirl:failed", "there are %d machines already: clear some by whirl_machine('clear')",
                      MAX_MACHINES);
    return NULL;
}

static void set_all(machine *one, int count, const mxArray *const settings[]) {
    for (int i = 0; i < count; ++i) {
        char word[WORD];
        word_of(settings[i], "a setting", word);
        const whirl_status status = whirl_case_assign(one->given, word);
        if (status.code != WHIRL_OK) clear(one);
        mex_check(status);
    }
}

/* Reads a case from a text or, if the text is empty, from the file `name`. */
static void read_case(machine *one, const mxArray *given, const char *name) {
    char sentences[2000] = "";
    whirl_problems problems = {0};
    char *text = mxArrayToString(given);
    const whirl_status read = text && text[0] ? whirl_case_parse(text, strlen(text), name, &problems, &one->given)
                                              : whirl_case_load(name, &problems, &one->given);
    mxFree(text);
    if (problems.count > 0) whirl_problems_text(&problems, sentences, sizeof sentences);
    whirl_problems_free(&problems);
    if (read.code == WHIRL_BAD_INPUT && sentences[0]) mexErrMsgIdAndTxt("whirl:badInput", "%s", sentences);
    mex_check(read);
}

/* id = whirl_mex('machine', text, name, 'r_k=0.5', ...); an empty text: the case is in the file of that name */
static void mex_make(mxArray *out[], int count, const mxArray *in[]) {
    char name[WORD];
    machine *one = free_place();
    if (count < 2 || !mxIsChar(in[0])) mexErrMsgIdAndTxt("whirl:badInput", "the case is no text");
    for (int i = 1; i < count; ++i) word_of(in[i], "a setting", name);
    word_of(in[1], "the name of the case", name);
    read_case(one, in[0], name);
    set_all(one, count - 2, in + 2);
    const whirl_status built = whirl_case_rotor(one->given, NULL, 0.0, &one->rotor);
    if (built.code != WHIRL_OK) clear(one);
    mex_check(built);
    one->number = next_number();
    out[0] = mxCreateDoubleScalar(one->number);
}

/* s = whirl_mex('about', id) */
static void about(mxArray *out[], int count, const mxArray *in[]) {
    const char *names[] = {"stations", "dimension", "speed", "clock", "length_scale"};
    if (count != 1) mexErrMsgIdAndTxt("whirl:badInput", "expected a machine");
    const whirl_rotor *rotor = machine_of(in[0])->rotor;
    const whirl_system *system = whirl_rotor_system(rotor);
    mxArray *stations = mxCreateCellMatrix(system->probe_count, 1);
    for (size_t i = 0; i < system->probe_count; ++i) mxSetCell(stations, i, mxCreateString(system->probes[i].name));
    out[0] = mxCreateStructMatrix(1, 1, 5, names);
    mxSetField(out[0], 0, "stations", stations);
    mxSetField(out[0], 0, "dimension", mxCreateDoubleScalar((double)system->dimension));
    mxSetField(out[0], 0, "speed", mxCreateDoubleScalar(whirl_rotor_speed(rotor)));
    mxSetField(out[0], 0, "clock", mxCreateDoubleScalar(whirl_rotor_clock(rotor)));
    mxSetField(out[0], 0, "length_scale", mxCreateDoubleScalar(whirl_rotor_length_scale(rotor)));
}

/* ---------------------------------------------------------------- rates and forces */

static const double *numbers_of(const mxArray *array, const char *what, size_t count) {
    if (!mxIsDouble(array) || mxIsComplex(array) || mxIsSparse(array) || mxGetNumberOfElements(array) != count)
        mexErrMsgIdAndTxt("whirl:badInput", "%s is not of %u real numbers (double)", what, (unsigned)count);
    return mxGetPr(array);
}

/* Returns the rates of all states of a rotor as a column. */
static mxArray *rates(const whirl_rotor *rotor, const mxArray *t, const mxArray *x) {
    const size_t dimension = whirl_rotor_system(rotor)->dimension;
    const double time = numbers_of(t, "t", 1)[0], *state = numbers_of(x, "x", dimension);
    mxArray *out = mxCreateDoubleMatrix(dimension, 1, mxREAL);
    mex_check(whirl_rotor_rates(rotor, time, state, mxGetPr(out)));
    return out;
}

/* dxdt = whirl_mex('rhs', id, t, x) */
static void rhs(mxArray *out[], int count, const mxArray *in[]) {
    if (count != 3) mexErrMsgIdAndTxt("whirl:badInput", "expected a machine, t and x");
    out[0] = rates(machine_of(in[0])->rotor, in[1], in[2]);
}

static const whirl_rotor *element_of(machine *one, const char *name) {
    for (size_t i = 0; i < one->elements; ++i)
        if (strcmp(one->names[i], name) == 0) return one->alone[i];
    if (one->elements == MAX_ELEMENTS)
        mexErrMsgIdAndTxt("whirl:failed",
                          "whirl_element has been used for %d elements of this machine, which is the most",
                          MAX_ELEMENTS);
    mex_check(whirl_case_element(one->given, name, &one->alone[one->elements]));
    snprintf(one->names[one->elements], WORD, "%s", name);
    return one->alone[one->elements++];
}

/* f = whirl_mex('element', id, name, t, x) */
static void element(mxArray *out[], int count, const mxArray *in[]) {
    char name[WORD];
    if (count != 4) mexErrMsgIdAndTxt("whirl:badInput", "expected a machine, the name of an element, t and x");
    word_of(in[1], "the name of an element", name);
    mxArray *all = rates(element_of(machine_of(in[0]), name), in[2], in[3]);
    const size_t half = mxGetNumberOfElements(all) / 2;
    out[0] = mxCreateDoubleMatrix(half, 1, mxREAL);
    memcpy(mxGetPr(out[0]), mxGetPr(all) + half, half * sizeof(double));
    mxDestroyArray(all);
}

/* ---------------------------------------------------------------- signals of data sets */

static size_t whole_of(const mxArray *array) {
    const double number = mxIsDouble(array) && mxGetNumberOfElements(array) == 1 ? mxGetScalar(array) : -1.0;
    if (!(number >= 0.0 && number < 9e15)) mexErrMsgIdAndTxt("whirl:badInput", "expected a number of records");
    return (size_t)number;
}

/* sizes = whirl_mex('signals', file): records, channels, samples
 * s = whirl_mex('signals', file, first, count): single [samples][channels][count], as they lie in memory */
static void signals(mxArray *out[], int count, const mxArray *in[]) {
    size_t sizes[3];
    if ((count != 1 && count != 3) || !mxIsChar(in[0])) mexErrMsgIdAndTxt("whirl:badInput", "expected a file");
    const size_t first = count == 3 ? whole_of(in[1]) : 0, records = count == 3 ? whole_of(in[2]) : 0;
    char *file = mxArrayToString(in[0]);
    whirl_status status = whirl_signals_shape(file, sizes);
    if (status.code == WHIRL_OK && count == 1) {
        out[0] = mxCreateDoubleMatrix(1, 3, mxREAL);
        for (size_t i = 0; i < 3; ++i) mxGetPr(out[0])[i] = (double)sizes[i];
    } else if (status.code == WHIRL_OK) {
        const mwSize dimensions[] = {sizes[2], sizes[1], records <= sizes[0] ? records : 0};
        out[0] = mxCreateNumericArray(3, dimensions, mxSINGLE_CLASS, mxREAL);
        status = whirl_signals_read(file, first, records, (float *)mxGetData(out[0]));
    }
    mxFree(file);
    mex_check(status);
}

void mexFunction(int out_count, mxArray *out[], int count, const mxArray *in[]) {
    char word[WORD];
    (void)out_count;
    mexAtExit(clear_all);
    if (count < 1)
        mexErrMsgIdAndTxt("whirl:badInput",
                          "this is the gateway of whirl_machine, whirl_rhs, whirl_element and whirl_signals");
    /* Call the function that the first argument names. */
    word_of(in[0], "the first argument", word);
    if (strcmp(word, "machine") == 0)
        mex_make(out, count - 1, in + 1);
    else if (strcmp(word, "about") == 0)
        about(out, count - 1, in + 1);
    else if (strcmp(word, "rhs") == 0)
        rhs(out, count - 1, in + 1);
    else if (strcmp(word, "element") == 0)
        element(out, count - 1, in + 1);
    else if (strcmp(word, "signals") == 0)
        signals(out, count - 1, in + 1);
    else if (strcmp(word, "clear") == 0 && count == 2)
        clear(machine_of(in[1]));
    else if (strcmp(word, "clear") == 0)
        clear_all();
    else
        mexErrMsgIdAndTxt("whirl:badInput", "unknown: %s", word);
}
