// The help overlay.
import { button, el } from '../dom';

const KEYS: readonly (readonly [string, string])[] = [
  ['\u2190 \u2192', 'move the cursor; with Shift ten times as far'],
  ['\u2190 \u2192 on a branch', 'along it, from one stored orbit to the next, through its folds'],
  ['O', 'the orbit of the next branch at the value of the cursor; after the last one the motion'],
  ['Arrows on a map', 'from cell to cell, with Shift ten; Home, End, Page Up and Page Down go to its borders'],
  ['C on a map', 'the diagram is the column of the cursor in place of its row, and back'],
  ['+ \u2212 on a map', 'a smaller or larger part of it, about the cursor; so does the wheel, and Shift and drag'],
  ['Page Up, Page Down', 'a twentieth of the range'],
  ['Home, End', 'to the ends of the range'],
  ['+ \u2212', 'zoom in and out about the cursor; the wheel does the same. Finer points are then computed in the view'],
  [
    'V, Shift+V',
    'enlarge and reduce the heights of the upper picture; so do the wheel over its axis, or with Shift, and Shift ' +
      'and drag, which encloses a rectangle where it goes up or down',
  ],
  ['Alt+\u2191, Alt+\u2193', 'move over enlarged heights; a double click, Back and Reset show all of them again'],
  ['Backspace', 'back to the diagram before'],
  ['Ctrl+Z, Ctrl+Shift+Z', 'undo, redo (also Ctrl+Y, and Back and Forward of the browser), wherever the focus is'],
  ['Esc', 'stops what is being computed, closes this help'],
  ['?', 'this help'],
];

const POINTS: readonly (readonly [string, string])[] = [
  [
    'Diagram',
    'One column of dots for each value of the parameter: the displacement once per revolution. One dot is a ' +
      'motion that repeats itself every revolution, two dots one of two revolutions, a smear is quasi-periodic ' +
      'or chaotic. Colours are verdicts, the ribbon at the bottom repeats them; amber shading means that the ' +
      'rotor touches its stator.',
  ],
  [
    'Map',
    'A cell for each point over two parameters, in the colour of its regime, paler where the verdict can be trusted ' +
      'less, or in that of a number. Below it stands what the result says of the cell under the pointer; a click ' +
      'computes its motion. The diagram is a cut through the map: the row or the column of the cursor.',
  ],
  [
    'Exponent',
    'Below the diagram: the largest Lyapunov exponent per revolution, with its standard error where it can be ' +
      'seen. Above zero small perturbations grow: chaos.',
  ],
  [
    'Touch',
    'Click or drag: the machine is integrated at exactly that value, first briefly, then as long as the case ' +
      'says. The mode Range (or Shift and drag) computes the brushed range anew, coarse to fine; Back returns. ' +
      'Two fingers zoom along the line between them.',
  ],
  [
    'Branches',
    'Lines over the diagram, solid where orbits are stable, dashed where not. Near a line the cursor takes the orbit ' +
      'there, which no motion shows where it is unstable: dashed in the orbit view, with its multipliers; those ' +
      'outside the unit circle are what perturbations grow by, each time round. \u25b6 shows how a motion leaves it.',
  ],
  [
    'Orbit',
    'Seen along the shaft; it turns counter-clockwise, from x to y, unless the case says otherwise. The dot is ' +
      'the once-per-revolution mark (keyphasor); the trace pauses just before it, so blank to bright is the way ' +
      'the shaft moves. Forward means with the rotation.',
  ],
  [
    'Full spectrum',
    'The two circular motions that make up the orbit, forward to the right, backward to the left, both ' +
      'relative to the rotation.',
  ],
  [
    'Centreline',
    'The mean position in the clearance circle, along the diagram and at the cursor. The attitude angle is ' +
      'measured from straight down in the sense of rotation.',
  ],
  [
    'Campbell diagram',
    'Of a machine at rest: natural frequencies over the parameter. Triangles that point up, blue: the whirl goes ' +
      'with the rotation; down, orange: against it; squares, grey: to and fro. Rings mark critical speeds, crosses ' +
      'thresholds of stability, amber is unstable. Damping is below, up to where a mode still resonates.',
  ],
  [
    'Mode shape',
    'The orbits of the stations along the shaft, drawn aslant; each trace ends just before its dot, so blank to ' +
      'bright is the way of the whirl. Only stations are drawn: lines between them are straight.',
  ],
  [
    'Bode and polar',
    'The response to unbalance as two probes see it, the second a right angle further on. The lag is by how much the ' +
      'peak comes after the mark; in the polar diagram it grows against the rotation.',
  ],
  [
    'Amplitudes',
    'Say 0-p (zero to peak), p-p (peak to peak) or rms. Switch units at the top; c is one bearing clearance.',
  ],
  [
    'Measured data',
    'Tables (CSV), HDF5, MAT and universal files that are dropped onto the page, or chosen with Measured\u2026, lie ' +
      'over the model as dots: an orbit over the angle or the time (angle [deg], disc x [um], disc y [um]), or 1X ' +
      'vectors over the speed (speed [rpm], disc x [um], disc x lag [deg]). Columns are those of files for fits. ' +
      'Nothing leaves the computer.',
  ],
  [
    'Keep',
    'Every picture as PNG or SVG and its data as CSV (\u2913); the setting as a case file or a command line ' +
      'for whirl; the address of the page holds the setting too.',
  ],
];

type Facts = readonly { readonly name: string; readonly value: string }[];

export class Help {
  readonly root = el('dialog', { class: 'help', 'aria-label': 'Help' });

  constructor() {
    this.root.addEventListener('click', (event) => {
      if (event.target === this.root) this.root.close();
    });
  }

  /// Opens the help; `facts`: origin of the shown run, empty if the page computed it.
  open(facts: Facts): void {
    const rows = (entries: readonly (readonly [string, string])[]) =>
      entries.flatMap(([term, text]) => [el('dt', {}, term), el('dd', {}, text)]);
    this.root.replaceChildren(
      button('\u00d7', 'Close this help', () => this.root.close(), { class: 'icon close', autofocus: true }),
      el('h2', {}, 'How to read and use this page'),
      el('dl', {}, ...rows(POINTS)),
      el('h2', {}, 'Keys, while the diagram has the focus'),
      el('dl', {}, ...rows(KEYS)),
    );
    if (facts.length)
      this.root.append(
        el('h2', {}, 'How the stored run was made'),
        el('dl', { class: 'facts' }, ...rows(facts.map(({ name, value }) => [name, value] as const))),
      );
    if (!this.root.open) this.root.showModal();
  }
}
