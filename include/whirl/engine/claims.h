/// Claims: what a paper or a measurement says of a rotor, to be set beside what is found. Nothing is forced to agree.
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

/// The most lines of a spectrum that a claim names, orders of whirl, and kinds of special points of branches.
enum { WHIRL_MAX_CLAIM_LINES = 8, WHIRL_MAX_CLAIM_KINDS = 6 };

/// How long there is contact.
typedef enum whirl_claim_contact {
    WHIRL_CONTACT_NEVER = 0, ///< at no time
    WHIRL_CONTACT_SOME,      ///< at some time or always
    WHIRL_CONTACT_AT_TIMES,  ///< at some time and not always: partial rub
    WHIRL_CONTACT_ALWAYS     ///< always: full annular rub
} whirl_claim_contact;

/// Kinds of special points that a claim names.
typedef struct whirl_claim_kinds {
    size_t count;                              ///< of list
    whirl_special list[WHIRL_MAX_CLAIM_KINDS]; ///< in the order of the file
} whirl_claim_kinds;

/// What somebody (a paper, a measurement) says of a point or of a range of a parameter. What is not said is not
/// compared.
typedef struct whirl_claim {
    char where[WHIRL_NAME_SIZE];          ///< "Fig. 4"
    char says[400];                       ///< in words
    double from, to;                      ///< value or range of the parameter; from = to for one point
    bool has_regime;                      ///< whether it says a regime
    whirl_regime regime;                  ///< that it says
    int period;                           ///< 0: any
    int curves;                           ///< closed curves of a quasi-periodic section; 0: any
    bool has_contact;                     ///< whether it speaks of contact
    whirl_claim_contact contact;          ///< what it says of it
    bool has_dry_whip, dry_whip;          ///< whether it speaks of dry whip, and what it says
    size_t line_count;                    ///< of lines
    double lines[WHIRL_MAX_CLAIM_LINES];  ///< orders that the spectrum shows
    bool only_lines;                      ///< and no others
    bool has_band;                        ///< whether it says a band
    double band[2];                       ///< orders between which the large lines below the running speed lie
    bool has_largest;                     ///< whether it says where the largest line lies
    double largest[2];                    ///< orders between which it lies
    bool has_whirl;                       ///< whether it says a direction
    char whirl[WHIRL_NAME_SIZE];          ///< "forward", "backward"
    whirl_claim_kinds changes;            ///< special points that branches have in the range
    whirl_claim_kinds unchanged;          ///< and such that they have not
    int sense;                            ///< of the first of the changes: -1 supercritical, 1 subcritical, 0 not said
    size_t order_count;                   ///< of orders
    double orders[WHIRL_MAX_CLAIM_LINES]; ///< of the speed, one of which the whirl has that begins there
    int regions;                          ///< parts of one sense of the curve of Hopf points; 0: not said
    char given[WHIRL_NAME_SIZE];          ///< a parameter of the case; "" for results of all its values
    double given_from, given_to;          ///< values of it of which the claim speaks
} whirl_claim;

/// A list of claims with where they come from.
typedef struct whirl_claims {
    char source[400];                ///< the paper or measurement
    char parameter[WHIRL_NAME_SIZE]; ///< that the claims speak of
    char station[WHIRL_NAME_SIZE];   ///< whose spectrum is meant
    size_t count;                    ///< of items
    whirl_claim *items;              ///< [count]
} whirl_claims;

/// Reads a claims file (YAML, see cases/paper-claims.yaml). Problems as for cases. Freed by whirl_claims_free.
whirl_status whirl_claims_load(const char *path, whirl_problems *problems, whirl_claims **claims);

/// Frees claims; NULL is none.
void whirl_claims_free(whirl_claims *claims);

/// The groups of keys of a claims file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_claims_groups(void);

/// How a claim stands beside what is found.
typedef enum whirl_agreement {
    WHIRL_NOT_COMPARED = 0, ///< the result has nothing to compare
    WHIRL_AGREES,           ///< in all that is said
    WHIRL_AGREES_PARTLY,    ///< in some of it, or along some of the range
    WHIRL_DISAGREES         ///< in nothing
} whirl_agreement;

/// Sets a claim beside a result: agreement, and what was found in words (at most `size` bytes).
whirl_agreement whirl_claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                                    char *found, size_t size);

#ifdef __cplusplus
}
#endif
#endif
