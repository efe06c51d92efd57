/// The benchmark's rotors as whirl has them: the paper's, chains of more stations, and one of finite elements.
#ifndef BENCH_MACHINES_H
#define BENCH_MACHINES_H

#include "whirl/engine.h"

/// Stops the program with the sentence of a failure.
void must(whirl_status status);

/// Makes the rotor of rotor.h from elements, in SI with omega = 1, c = 1 and m2 = 1. Freed by whirl_rotor_free.
whirl_rotor *paper_rotor(double r_k);

/// Makes the rotor of paper_rotor with its stations and the ends of its shaft in the other order.
whirl_rotor *paper_rotor_journal_first(double r_k);

/// Makes the rotor of paper_rotor with one element more, which does nothing: the structure then has no loops of its
/// own.
whirl_rotor *paper_rotor_listed(double r_k);

/// Makes a shaft of `stations` equal discs, each joined to the next; the middle one is out of balance and may rub; both
/// ends run in an oil film. Scaled so that 1024 steps per revolution carry it stably. Freed by whirl_rotor_free.
whirl_rotor *chain_rotor(size_t stations, double r_k);

/// Makes ten journals of 20 kg, each by itself in an element film with this law; NULL: without films. `length` in m.
/// Freed by whirl_rotor_free.
whirl_rotor *films_rotor(const char *law, double length);

/// Makes the overhung rotor of overhung.h at a speed (rad/s): 20 finite elements, reduced. Freed by whirl_rotor_free.
whirl_rotor *overhung_rotor(double speed);

/// Makes the rotor of overhung_rotor without films and rub; `station` (NULL: none) stands on a spring (N/m, the same
/// along x and y).
whirl_rotor *overhung_free_rotor(double speed, const char *station, double stiffness);

#endif
