/// Numbers of every point that a part of the study asks for, such as those with limits.
#ifndef CASE_PLAN_ASKED_H
#define CASE_PLAN_ASKED_H

#include "machine.h"
#include "plan_parts.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/study.h"

/// Reads the list of numbers of a setting, each with the keys of a group; nothing for NULL.
void asked_read(case_reader *reader, const setting *of, const whirl_group *group, asked_parts *out);

/// Notes which of the numbers the points of a batch have. Reports a number whose station, row or column the points
/// lack, whose limit has another unit, or which cannot be differentiated (`derived`).
void asked_check(case_reader *reader, asked_parts *asked, const whirl_batch *batch, const whirl_layout *layout,
                 const machine_parts *machine, const whirl_rotor *rotor, bool derived);

/// Reports the numbers that no batch has.
void asked_report_unfound(case_reader *reader, const asked_parts *asked);

#endif
