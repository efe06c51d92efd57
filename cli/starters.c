#include "starters.h"

static const char rotor[] =
    "whirl: 1                              # version of the format\n"
    "title: A disc between two oil-film bearings\n"
    "\n"
    "# Give a name to whatever you may want to change: --set NAME=VALUE does, and a sweep varies one of them.\n"
    "# A number stands before its unit, with a space between; = begins an expression, whose value is in SI.\n"
    "parameters:\n"
    "  omega: 6000 rpm                     # speed of rotation; a frequency in Hz is refused\n"
    "  c:     0.1 mm                       # radial clearance of the bearings\n"
    "  k:     20 MN/m                      # stiffness of the shaft\n"
    "  oil:   20 mPa.s                     # viscosity\n"
    "  gap:   = 1.3*c                      # radial gap at the seal\n"
    "\n"
    "rotor:\n"
    "  speed: = omega\n"
    "  length_scale: = c                   # displacements are in this length\n"
    "  stations:                           # points of the shaft with a mass; by symmetry one is enough for "
    "both journals\n"
    "    disc:    {mass: 40 kg, damping: 500 N.s/m, eccentricity: 15 um}\n"
    "    journal: {mass: 8 kg}\n"
    "  elements:                           # what joins the stations and acts on them: `whirl describe` lists all\n"
    "    - shaft:   {between: [disc, journal], k1: = k}\n"
    "    - film:    {at: journal, count: 2, clearance: = c, viscosity: = oil, radius: 25 mm, length: 20 mm}\n"
    "    - rub:     {at: disc, gap: = gap, stiffness: 60 MN/m, friction: 0.1, law: slip, radius: 100 mm}\n"
    "    - gravity: 9.81 m/s2\n"
    "\n"
    "study:\n"
    "  sweep:     {parameter: omega, from: 2000 rpm, to: 12000 rpm, step: 1000 rpm}\n"
    "  # response: {}                      # in place of sweep and detail: one point with the parameters as they are\n"
    "  initial:   {journal: {y: -50 um}, disc: {y: -50 um}}\n"
    "  integrate: {transient: 500, record: 200} # revolutions before the record, and in it\n"
    "  detail:    {at: [3000 rpm, 8000 rpm]} # these with waveforms and whole spectra\n";

static const char rub[] =
    "whirl: 1                              # version of the format\n"
    "title: A Jeffcott rotor that rubs its stator\n"
    "\n"
    "parameters:                           # names for what you may want to set (--set) or sweep\n"
    "  omega: 5000 rpm                     # speed of rotation\n"
    "  k:     2 MN/m                       # stiffness of the shaft: its critical speed is sqrt(k/m), 4270 rpm\n"
    "  gap:   0.2 mm                       # radial, half of what a drawing gives for the diameters\n"
    "\n"
    "rotor:\n"
    "  speed: = omega\n"
    "  length_scale: = gap                 # displacements are in gaps: 1 touches\n"
    "  stations:\n"
    "    disc: {mass: 10 kg, damping: 800 N.s/m, eccentricity: 60 um}\n"
    "  elements:\n"
    "    - shaft: {between: [disc, ground], k1: = k}\n"
    "    - rub:   {at: disc, gap: = gap, stiffness: 10 MN/m, friction: 0.05, law: slip, radius: 80 mm}\n"
    "\n"
    "study:                                # up and down: from 5500 rpm on there are two motions, one in contact\n"
    "  sweep:     {parameter: omega, from: 2000 rpm, to: 8000 rpm, points: 13, start: carry, direction: both}\n"
    "  integrate: {method: dop853, transient: 200, record: 100} # steps end where contact begins and ends\n";

static const char bearing[] =
    "whirl: 1                              # version of the format\n"
    "title: A rigid rotor in two equal oil-film bearings\n"
    "\n"
    "parameters:                           # names for what you may want to set (--set) or sweep\n"
    "  omega: 9000 rpm                     # speed of rotation\n"
    "  c:     60 um                        # radial clearance\n"
    "  oil:   15 mPa.s                     # viscosity\n"
    "  e:     3 um                         # distance of the centre of mass from the shaft's centre\n"
    "\n"
    "rotor:\n"
    "  speed: = omega\n"
    "  length_scale: = c                   # a radius of 1 is at the wall\n"
    "  stations:\n"
    "    journal: {mass: 20 kg, eccentricity: = e}\n"
    "  elements:\n"
    "    - film:    {at: journal, count: 2, clearance: = c, viscosity: = oil, radius: 20 mm, length: 16 mm}\n"
    "    - gravity                         # 9.80665 m/s2 downwards\n"
    "\n"
    "study:                                # one point; with -o it is kept: whirl run CASE.yaml -o RESULT.h5\n"
    "  response:  {}\n"
    "  initial:   {journal: {y: -30 um}}\n"
    "  integrate: {transient: 1000, record: 200}\n"
    "  keep:      {waveform: 20}           # the last 20 revolutions\n";

static const starter starters[] = {
    {"rotor", "a disc between two oil-film bearings, with a seal that it may rub; a sweep of the speed", rotor},
    {"rub", "a disc on a shaft that rubs its stator; a sweep up and down", rub},
    {"bearing", "a rigid rotor in two oil-film bearings; one point", bearing},
};

const starter *starter_at(size_t index) {
    return index < sizeof starters / sizeof *starters ? &starters[index] : NULL;
}
