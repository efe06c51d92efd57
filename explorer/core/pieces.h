/// Writes pieces of JSON that several answers share.
#ifndef EXPLORER_PIECES_H
#define EXPLORER_PIECES_H

#include "text.h"
#include "whirl/engine/study.h"

void add_stations(text *t, const whirl_probe *stations, size_t count);
void add_scales(text *t, double length_scale, double clock, const char *keyphasor);
void add_options(text *t, const whirl_batch *batch);

#endif
