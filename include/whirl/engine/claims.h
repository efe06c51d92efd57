/// Claims: statements of a paper or a measurement about a rotor, for comparison with results.
#ifndef WHIRL_CLAIMS_H
#define WHIRL_CLAIMS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Maximum number of lines of a spectrum or orders of whirl in a claim, and of kinds of special points of branches.
enum { WHIRL_MAX_CLAIM_LINES = 8, WHIRL_MAX_CLAIM_KINDS = 6 };

/// Durations of contact.
typedef enum whirl_claim_contact {
    WHIRL_CONTACT_NEVER = 0, ///< at no time
    WHIRL_CONTACT_SOME,      ///< at some time or always
    WHIRL_CONTACT_AT_TIMES,  ///< at some time and not always: partial rub
    WHIRL_CONTACT_ALWAYS     ///< always: full annular rub
} whirl_claim_contact;

/// Kinds of special points in a claim.
typedef struct whirl_claim_kinds {
    size_t count;                              ///< number of kinds
    whirl_special list[WHIRL_MAX_CLAIM_KINDS]; ///< in the order of the file
} whirl_claim_kinds;

/// A statement (of a paper, a measurement) about a point or a range of a parameter. Parts that are not stated are not
/// compared.
typedef struct whirl_claim {
    char where[WHIRL_NAME_SIZE];         ///< "Fig. 4"
    char says[400];                      ///< the statement in words
    double from, to;                     ///< value or range of the parameter; from = to for one point
    bool has_regime;                     ///< true if a regime is stated
    whirl_regime regime;                 ///< the stated regime
    int period;                          ///< 0: any
    int curves;                          ///< closed curves of a quasi-periodic section; 0: any
    bool has_contact;                    ///< true if contact is stated
    whirl_claim_contact contact;         ///< the stated contact
    bool has_dry_whip, dry_whip;         ///< true if dry whip is stated, and the statement
    size_t line_count;                   ///< number of lines
    double lines[WHIRL_MAX_CLAIM_LINES]; ///< orders that the spectrum shows
    bool only_lines;                     ///< true if the spectrum has no other lines
    bool has_band;                       ///< true if a band is stated
    double band[2];                      ///< orders that bound the large lines below the running speed
    bool has_largest;                    ///< true if the order of the largest line is stated
    double largest[2];                   ///< orders that bound it
    bool has_whirl;                      ///< true if a direction is stated
    char whirl[WHIRL_NAME_SIZE];         ///< "forward", "backward"
    whirl_claim_kinds changes;           ///< special points that branches have in the range
    whirl_claim_kinds unchanged;         ///< special points that branches do not have in the range
    int sense;          ///< sense of the first of the changes: -1 supercritical, 1 subcritical, 0 not stated
    size_t order_count; ///< number of orders
    double orders[WHIRL_MAX_CLAIM_LINES]; ///< orders, one of which the whirl that begins at the first Hopf point has
    int regions;                 ///< number of pieces of the curve of Hopf points, each of one sense; 0: not stated
    char given[WHIRL_NAME_SIZE]; ///< a parameter of the case; "" for results of all its values
    double given_from, given_to; ///< its values for which the claim is stated
} whirl_claim;

/// A list of claims with its source.
typedef struct whirl_claims {
    char source[400];                ///< the paper or measurement
    char parameter[WHIRL_NAME_SIZE]; ///< parameter of the claims
    char station[WHIRL_NAME_SIZE];   ///< station of the spectra
    size_t count;                    ///< number of items
    whirl_claim *items;              ///< [count]
} whirl_claims;

/// Reads a claims file (YAML, see cases/paper-claims.yaml). Problems as for cases. Freed by whirl_claims_free.
whirl_status whirl_claims_load(const char *path, whirl_problems *problems, whirl_claims **claims);

/// Frees claims; accepts NULL.
void whirl_claims_free(whirl_claims *claims);

/// Returns the groups of keys of a claims file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_claims_groups(void);

/// Outcomes of comparing a claim with a result.
typedef enum whirl_agreement {
    WHIRL_NOT_COMPARED = 0, ///< the result has nothing to compare
    WHIRL_AGREES,           ///< in everything stated
    WHIRL_AGREES_PARTLY,    ///< in a part of it, or along a part of the range
    WHIRL_DISAGREES         ///< in nothing
} whirl_agreement;

/// Compares a claim with a result; writes the findings in words (at most `size` bytes).
whirl_agreement whirl_claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                                    char *found, size_t size);

#ifdef __cplusplus
}
#endif
#endif
