#include "mineral_oil.h"

#include <math.h>

static const double mm2 = 1e-6;

static double mineral_oil_walther(double nu) {
    return log10(log10(nu / mm2 + 0.7));
}

double mineral_oil_viscosity(const double *temperatures, const double *viscosities, size_t count, double temperature) {
    size_t i = 1;
    while (i + 1 < count && temperature > temperatures[i]) i++;
    const double low = mineral_oil_walther(viscosities[i - 1]), high = mineral_oil_walther(viscosities[i]);
    const double slope = (high - low) / log10(temperatures[i] / temperatures[i - 1]);
    return (pow(10.0, pow(10.0, low + slope * log10(temperature / temperatures[i - 1]))) - 0.7) * mm2;
}

double mineral_oil_at_100(double at_40) {
    static const double table[][2] = {{2.0, 6.394},  {3.0, 12.15},  {4.0, 19.56},  {5.0, 28.49},  {6.0, 38.19},
                                      {7.0, 48.57},  {8.0, 59.6},   {10.0, 82.87}, {12.0, 108.0}, {15.0, 149.7},
                                      {20.0, 229.5}, {30.0, 421.7}, {40.0, 651.8}, {50.0, 919.6}, {70.0, 1558.0}};
    size_t i = 1;
    const size_t last = sizeof table / sizeof *table - 1;
    while (i < last && at_40 / mm2 > table[i][1]) i++;
    const double *low = table[i - 1], *high = table[i];
    return low[0] * pow(high[0] / low[0], log(at_40 / mm2 / low[1]) / log(high[1] / low[1])) * mm2;
}
