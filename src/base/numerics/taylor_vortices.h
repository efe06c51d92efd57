/// Flow between cylinders of which the inner one turns.
#ifndef BASE_TAYLOR_VORTICES_H
#define BASE_TAYLOR_VORTICES_H

/// Taylor's number, Re (c/R)^(1/2) with Re = rho Omega R c/mu, at which vortices begin (Taylor 1923).
#define FIRST_VORTICES 41.2

#endif
