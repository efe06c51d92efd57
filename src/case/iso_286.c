// Tolerance classes of sizes up to 500 mm: limits after ISO 286-1:2010, tables 1 to 3.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "iso_286.h"

enum { RANGES = 13, FINE = 25, GRADES = 18 };

/// Upper ends of the ranges of sizes, mm.
static const double ends[RANGES] = {3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};

/// Upper ends of the finer ranges of the deviations c, r and s, mm.
static const double fine_ends[FINE] = {3,   6,   10,  14,  18,  24,  30,  40,  50,  65,  80,  100, 120,
                                       140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500};

/// Standard tolerances IT1 to IT18 in um (table 1).
static const double grades[GRADES][RANGES] = {
    {.8, 1, 1, 1.2, 1.5, 1.5, 2, 2.5, 3.5, 4.5, 6, 7, 8},
    {1.2, 1.5, 1.5, 2, 2.5, 2.5, 3, 4, 5, 7, 8, 9, 10},
    {2, 2.5, 2.5, 3, 4, 4, 5, 6, 8, 10, 12, 13, 15},
    {3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20},
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970},
    {250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550},
    {400, 480, 580, 700, 840, 1000, 1200, 1400, 1600, 1850, 2100, 2300, 2500},
    {600, 750, 900, 1100, 1300, 1600, 1900, 2200, 2500, 2900, 3200, 3600, 4000},
    {1000, 1200, 1500, 1800, 2100, 2500, 3000, 3500, 4000, 4600, 5200, 5700, 6300},
    {1400, 1800, 2200, 2700, 3300, 3900, 4600, 5400, 6300, 7200, 8100, 8900, 9700},
};

/// The fundamental deviation of a letter in um, by its size: the distance between zero and the nearer limit (tables 2
/// and 3). Shafts up to the letter h are below zero, the others above.
typedef struct deviation {
    char letter;
    bool fine;
    double of[FINE];
} deviation;

static const deviation deviations[] = {
    {'c', true, {60,  70,  80,  95,  95,  110, 110, 120, 130, 140, 150, 170, 180,
                 200, 210, 230, 240, 260, 280, 300, 330, 360, 400, 440, 480}},
    {'d', false, {20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230}},
    {'e', false, {14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135}},
    {'f', false, {6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68}},
    {'g', false, {2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20}},
    {'h', false, {0}},
    {'k', false, {0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5}},
    {'m', false, {2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23}},
    {'n', false, {4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40}},
    {'p', false, {6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68}},
    {'r', true, {10, 15, 19, 23, 23, 28, 28, 34, 34,  41,  43,  51, 54,
                 63, 65, 68, 77, 80, 84, 94, 98, 108, 114, 126, 132}},
    {'s', true, {14, 19,  23,  28,  28,  35,  35,  43,  43,  53,  59,  71, 79,
                 92, 100, 108, 122, 130, 140, 158, 170, 190, 208, 232, 252}},
};

static size_t iso_range(const double *upper, double millimetres) {
    size_t i = 0;
    while (millimetres > upper[i] * (1.0 + 1e-12)) i++;
    return i;
}

/// Returns the lower deviation of a shaft of the letters k to s, or the upper deviation of a hole K to S, in um.
static double iso_inward(const deviation *own, bool hole, size_t grade, size_t range, size_t place) {
    // Holes K, M and N have the rule with the difference of two grades up to IT8, other holes up to IT7. Shafts k have
    // a deviation from IT4 to IT7 alone.
    const bool k = own->letter == 'k', early = k || own->letter == 'm' || own->letter == 'n';
    const double value = k && !hole && (grade < 4 || grade > 7) ? 0.0 : own->of[place];
    if (!hole) return value;
    const bool small = range == 0;
    const double delta = small || grade < 3 ? 0.0 : grades[grade - 1][range] - grades[grade - 2][range];
    if (own->letter == 'm' && grade == 6 && range == 10) return -9.0; // as the table has it
    if (k && grade > 8) return 0.0;
    if (own->letter == 'n' && grade > 8) return small ? -value : 0.0;
    return grade <= (early ? 8 : 7) ? delta - value : -value;
}

bool iso_286_limits(const char *name, double size, double *lower, double *upper, char why[WHY_SIZE]) {
    const double millimetres = size * 1e3;
    const bool hole = isupper((unsigned char)name[0]),
               symmetric = tolower((unsigned char)name[0]) == 'j' && tolower((unsigned char)name[1]) == 's';
    const size_t grade = strtoul(name + 1 + symmetric, NULL, 10);
    const deviation *own = NULL;
    for (size_t i = 0; i < sizeof deviations / sizeof *deviations; i++)
        if (deviations[i].letter == tolower((unsigned char)name[0]) && isdigit((unsigned char)name[1]))
            own = &deviations[i];
    if (!(own || symmetric) || grade < 1 || grade > GRADES) {
        snprintf(why, WHY_SIZE,
                 "has the class %.8s, expected one of the letters c to h, js, k, m, n, p, r and s of a shaft, or "
                 "capitals of a hole, and a grade of 1 to %d: 40 mm H7",
                 name, GRADES);
        return false;
    }
    if (!(millimetres > 0.0 && millimetres <= ends[RANGES - 1] * (1.0 + 1e-12))) {
        snprintf(why, WHY_SIZE, "has a class at a size of %.10g mm, expected one above 0 and up to 500 mm",
                 millimetres);
        return false;
    }
    const size_t range = iso_range(ends, millimetres);
    const double width = grades[grade - 1][range];
    double low = -0.5 * width, high = 0.5 * width;
    if (own) {
        const size_t place = own->fine ? iso_range(fine_ends, millimetres) : range;
        const bool outward = own->letter <= 'h';
        const double near = outward ? own->of[place] : iso_inward(own, hole, grade, range, place);
        // `near` is the upper deviation for holes K to S, and the distance below the size for shafts up to h.
        const bool up = hole == outward;
        low = up ? near : hole ? near - width : -near - width;
        high = low + width;
    }
    *lower = size + low * 1e-6;
    *upper = size + high * 1e-6;
    return true;
}
