// Machines of the page: runs that a report stored, and presets, which the page computes.
import jeffcott from '../../../cases/jeffcott-rub.yaml';
import paperDerived from '../../../cases/paper-derived.yaml';
import paperLiteral from '../../../cases/paper-literal.yaml';
import paper from '../../../cases/paper.yaml';
import rigid from '../../../cases/rigid-rotor.yaml';
import { AtRest } from '../data/rest';
import { MACHINE, type Part } from '../data/contents';
import { RunUp } from '../data/runup';
import type { Run } from '../data/run';
import type { Scales } from './units';

export interface Machine {
  /// Name in addresses and file names.
  readonly name: string;
  readonly title: string;
  readonly caseName: string;
  readonly text: string;
  readonly intro: string;
  readonly run: Run | undefined;
}

const DRAG =
  'Drag across the diagram: the orbit, its spectrum and its Poincar\u00e9 map are computed on the spot for the ' +
  'value under the cursor.';

/// Introductions for new users: what to try first.
const INTROS: Readonly<Record<string, string>> = {
  paper:
    `${DRAG} Start at r_k = 0.6, where the motion repeats itself every revolution, and go left: below 0.5 the ` +
    'oil film whirls at a frequency of its own, and in the shaded parts the disc rubs its stator. Then press ' +
    '\u25b6 in the orbit at r_k = 0.35, and watch the rotor settle from its start and touch.',
  'paper-derived':
    `${DRAG} This reading has the signs that follow from a shaft that turns; choose the calibrated reading above ` +
    'and compare what is left of the whirl and of the chaos. Then move the slider of the unbalance rho and press ' +
    'Recompute to see how far the answer depends on it.',
  'paper-literal':
    `${DRAG} This reading takes every number as it is printed: the disc rubs nearly everywhere, and most motions ` +
    'are chaotic. Choose the calibrated reading above for the difference that a few fitted numbers make.',
  'jeffcott-rub':
    `${DRAG} At 1.5 times the natural frequency the disc stays in contact, at 3.8 it repeats itself after four ` +
    'revolutions, and at 3.3 it never does. Brush a range around 3.3 (Shift and drag) to compute it more finely, ' +
    'or raise the friction mu to 0.1 there, and the motion does not stay bounded.',
  'rigid-rotor':
    `${DRAG} The journal repeats itself after 2 revolutions at an unbalance rho of 0.2, after 4 at 0.27, and ` +
    'from 0.31 on hardly ever: a cascade of period doublings. Look at the dots of the Poincar\u00e9 map double ' +
    'while you drag, and at the exponent below the diagram touch zero each time.',
};

const OWN =
  `${DRAG} Change a parameter with its slider and press Recompute to see the diagram of the changed machine. ` +
  'Brush a range (Shift and drag) to compute that range more finely, and press \u25b6 in the orbit to watch the ' +
  'rotor settle.';

const AT_REST: Readonly<Record<AtRest['kind'], string>> = {
  modes:
    'Small motions about where the machine rests, as the run has stored them. Drag across the diagram for the modes ' +
    'at the value under the cursor, and press the number of a mode for its shape; a click on a critical speed goes ' +
    'there.',
  unbalance:
    'The synchronous response about where the machine rests, as the run has stored it. Drag across the diagram for ' +
    'the numbers at the value under the cursor; any station and any angle of the probes may be chosen.',
};

const RUN =
  'Play the run, or drag across it: the orbit, the spectrum and the numbers are those of the turn at the cursor. ' +
  'Move a rate, an unbalance, a torque or a friction with its slider, and the run is computed anew in this page.';

const FITTED =
  'The machine with the fitted parameters, computed in this page, and the measured numbers as dots. Move a fitted ' +
  'parameter with its slider: its bar is the standard error. Recompute shows the diagram of the changed machine.';

const MAP =
  'Click on a cell of the map: the orbit, its spectrum and its Poincar\u00e9 map are computed on the spot for both ' +
  'of its parameters. The diagram below is the row of the cursor, or with the key C its column; brush a range of it ' +
  '(Shift and drag) to compute that range more finely, and press \u25b6 in the orbit to watch the rotor settle.';

function introOf(run: Run): string {
  const kind = AtRest.kindOf(run);
  if (run.tables.some(({ map }) => map)) return MAP;
  if (RunUp.isIn(run)) return RUN;
  const preset = PRESETS.find(({ text }) => text === run.case_text);
  return kind ? AT_REST[kind] : ((preset && INTROS[preset.name]) ?? OWN);
}

/// Returns the introduction of a part of a result.
export function introOfPart({ id, view }: Pick<Part, 'id' | 'view'>): string {
  if (id === MACHINE)
    return 'The machine, and what was found of it. The contents lead to all parts of the result and its live views.';
  if (view === 'motions') return OWN;
  if (view === 'fit') return FITTED;
  if (view === 'runup') return RUN;
  return view
    ? AT_REST[view]
    : 'What the run has stored; nothing of it is computed here. Figures and tables can be saved, as can their numbers.';
}

interface Preset {
  readonly name: string;
  readonly text: string;
}

const PRESETS: readonly Preset[] = [
  { name: 'paper', text: paper },
  { name: 'paper-derived', text: paperDerived },
  { name: 'paper-literal', text: paperLiteral },
  { name: 'jeffcott-rub', text: jeffcott },
  { name: 'rigid-rotor', text: rigid },
];

/// Returns the title of a case for a list; the engine reads the case later.
function titleOf(text: string): string {
  return /^title:\s*(.*?)\s*$/m.exec(text)?.[1] ?? '';
}

function baseName(caseName: string): string {
  return caseName.replace(/^.*\//, '').replace(/\.ya?ml$/, '');
}

/// Returns the machines: a report's own results, or without results the presets.
export function machinesOf(runs: readonly Run[], computes: boolean): Machine[] {
  const made: Machine[] = runs.map((run) => ({
    name: run.name,
    title: run.title,
    caseName: run.case_name || `${run.name}.yaml`,
    text: run.case_text,
    intro: introOf(run),
    run,
  }));
  if (computes && runs.length === 0)
    for (const { name, text } of PRESETS)
      made.push({
        name,
        title: titleOf(text),
        caseName: `${name}.yaml`,
        text,
        intro: INTROS[name] ?? OWN,
        run: undefined,
      });
  return made;
}

export function shortName(machine: Machine): string {
  return baseName(machine.caseName) || machine.name;
}

/// Returns the scales, with a symbol of the length scale if it is the clearance or gap of a station.
export function scalesOf(
  length: number,
  speed: number,
  stations: readonly { readonly clearance: number; readonly gap: number }[],
): Scales {
  const near = (value: number) => Math.abs(value - 1) < 1e-9;
  const symbol = stations.some(({ clearance }) => near(clearance))
    ? 'c'
    : stations.some(({ gap }) => near(gap))
      ? 'gap'
      : 'L';
  return { length, speed, symbol };
}
