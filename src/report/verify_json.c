// Writes a verification as one JSON document.
#include "document.h"
#include "whirl/internal/verify.h"
#include "whirl/status.h"
#include "whirl/version.h"

static json_t *run_object(bool *well, const whirl_integrate_options *options, const whirl_verify_run *run) {
    json_t *object = json_object();
    document_put_members(well, object, whirl_integrate_members(), options);
    document_put(well, object, "difference", document_number(run->difference));
    document_put(well, object, "section", document_number(run->section));
    document_put(well, object, "regime", document_text(whirl_regime_name(run->verdict.regime)));
    document_put(well, object, "period", json_integer(run->verdict.period));
    document_put(well, object, "exponent", document_number(run->verdict.exponent.value));
    document_put(well, object, "exponent_error", document_number(run->verdict.exponent.error));
    return object;
}

static json_t *point_object(bool *well, const whirl_verification *v, size_t index) {
    const whirl_verify_point *point = &v->points[index];
    json_t *object = json_object(), *runs = json_array(), *order = json_object();
    if (*v->parameter) document_put(well, object, "value", document_number(point->value));
    if (*v->second) document_put(well, object, "second", document_number(point->second));
    if (*v->third) document_put(well, object, "third", document_number(point->third));
    document_put(well, object, "agreed", json_boolean(point->agreed));
    document_put(well, object, "exponent_spread", document_number(point->exponent_spread));
    for (int m = 0; m < WHIRL_VERIFY_METHODS; ++m)
        document_put(well, order, v->integrate[m][0].method, document_number(point->order[m]));
    document_put(well, object, "order", order);
    for (int m = 0; m < WHIRL_VERIFY_METHODS; ++m)
        for (int level = 0; level < WHIRL_VERIFY_LEVELS; ++level)
            document_append(well, runs, run_object(well, &v->integrate[m][level], &point->runs[m][level]));
    document_put(well, object, "runs", runs);
    return object;
}

whirl_status whirl_verification_write_json(const whirl_verification *v, FILE *stream) {
    bool well = true;
    json_t *document = json_object(), *points = json_array();
    document_put(&well, document, "whirl", document_text(WHIRL_VERSION));
    document_put(&well, document, "table", document_text(v->table));
    document_put(&well, document, "parameter", *v->parameter ? document_text(v->parameter) : json_null());
    document_put(&well, document, "revolutions", json_integer(v->revolutions));
    if (*v->film_tables) document_put(&well, document, "film_tables", document_text(v->film_tables));
    for (size_t i = 0; i < v->count; ++i) document_append(&well, points, point_object(&well, v, i));
    document_put(&well, document, "points", points);
    return document_finish(well, document, stream);
}
