// Functions that the tests of the engine share: test points, the results of `whirl run`, and comparisons with them.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/// The build directory, with the command and the engine's parts.
export const BUILD = process.env.WHIRL_BUILD ?? join(root, 'build');
export const WHIRL = process.env.WHIRL ?? join(BUILD, 'whirl');
export const PARTS = join(BUILD, 'explorer');

export const caseText = (name) => readFileSync(join(root, 'cases', `${name}.yaml`), 'utf8');

/// Returns the text of a case whose study is replaced by a sweep over `values` of a parameter; the initial state is
/// kept. The same values are points in detail, which are computed alone and keep whole spectra and waveforms.
export function withStudy(name, parameter, values, { integrate, record, start = 'state' }) {
  const text = caseText(name);
  const initial = /\n  initial:.*\n(?:    .*\n)*/.exec(text)[0];
  const options = Object.entries({ ...integrate, ...record }).map(([key, value]) => `${key}: ${value}`);
  const range = `from: ${values[0]}, to: ${values.at(-1)}, points: ${values.length}`;
  return `${text.slice(0, text.indexOf('\nstudy:'))}
study:
  sweep: {parameter: ${parameter}, ${range}, start: ${start}}${initial}\
  integrate: {${options.join(', ')}}
  analyze: [poincare, regime, lyapunov, spectrum, orbit, rub]
  detail: {at: [${values.join(', ')}], waveform: ${Math.min(record.record, 20)}}
`;
}

/// Runs `whirl run --json` on a case's text with an instruction set ("": the widest); returns the document.
export function run(text, isa = '') {
  const folder = mkdtempSync(join(tmpdir(), 'whirl-'));
  try {
    const file = join(folder, 'case.yaml');
    writeFileSync(file, text);
    const options = {
      maxBuffer: 1 << 28,
      stdio: ['ignore', 'pipe', 'ignore'],
      env: { ...process.env, WHIRL_ISA: isa },
    };
    return JSON.parse(execFileSync(WHIRL, ['run', file, '--json=full'], options));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/// Points with all kinds of motion: periods 1 to 4, closed curves, chaos with and without contact.
export const POINTS = [
  { name: 'paper', parameter: 'r_k', values: [1.0, 0.7, 0.6, 0.48, 0.46, 0.45, 0.4, 0.25, 0.15] },
  { name: 'paper-derived', parameter: 'r_k', values: [0.9, 0.5] },
  { name: 'jeffcott-rub', parameter: 'omega', values: [1.5, 2.2, 3.3, 3.8] },
  { name: 'rigid-rotor', parameter: 'rho', values: [0.1, 0.2, 0.4, 0.5] },
];

/// Options of a run of 20 revolutions from the start, in which every state must agree.
export const SHORT = { integrate: { method: 'rk4', steps_per_revolution: 512 }, record: { transient: 0, record: 20 } };
/// Options of a run that is long enough for verdicts.
export const LONG = {
  integrate: { method: 'rk4', steps_per_revolution: 256 },
  record: { transient: 400, record: 200 },
};

/// Returns the largest difference between the sections of a result of the engine and of the command, in length scales.
export function sectionDifference(result, fieldNumbers, reported) {
  let worst = 0;
  result.stations.forEach((station, which) => {
    const mine = fieldNumbers(result.layout, result.block, 'poincare/section', which);
    const theirs = reported.poincare[station.name];
    if (mine.length !== 4 * theirs.length)
      throw new Error(`${mine.length / 4} and ${theirs.length} points of a section`);
    theirs.forEach(([x, y], n) => {
      worst = Math.max(worst, Math.abs(mine[4 * n] - x), Math.abs(mine[4 * n + 1] - y));
    });
  });
  return worst;
}
