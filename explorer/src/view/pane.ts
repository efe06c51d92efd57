// A pane: the motion at one setting (A or B), its verdict in words, and its panels.
import { Motion } from '../data/motion';
import { button, el, isTouched, select } from '../dom';
import type { Diagram } from '../data/diagram';
import type { MeasuredMotion } from '../data/measured';
import type { OrbitOfBranch } from '../data/orbit';
import type { MotionResult, StationInfo, Verdict } from '../engine/protocol';
import { regimeClass } from '../data/regimes';
import type { SideName } from '../model/session';
import { markField, typedQuantity } from '../model/typed';
import {
  labelled,
  lengthMeasure,
  parameterMeasure,
  readable,
  shown,
  written,
  type Scales,
  type Units,
} from '../model/units';
import { CentrelinePanel } from './centreline';
import { MultipliersPanel } from './multipliers';
import { numbersTable } from './numbers';
import { OrbitPanel, type Trail } from './orbit';
import type { Panel, Subject } from './panel';
import { PoincarePanel } from './poincare';
import { FullSpectrumPanel, SpectrumPanel } from './spectrum';
import { WaveformPanel } from './waveform';
import { FIELD } from '../data/fields';

export interface PaneSubject {
  readonly result: MotionResult | undefined;
  /// The orbit of a branch that the result shows; undefined for a motion.
  readonly orbit: OrbitOfBranch | undefined;
  readonly parameter: string;
  readonly unit: string;
  readonly value: number;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly units: Units;
  readonly scales: Scales;
  readonly diagram: Diagram | undefined;
  readonly measured: readonly MeasuredMotion[];
  /// Description of a running computation, or "".
  readonly busy: string;
  /// Error message, or "".
  readonly trouble: string;
  /// A sentence on the computation of the motion.
  readonly how: string;
  /// Label of the result's setting if it is not the present one; else "".
  readonly outdated: string;
}

export interface PaneListener {
  value(side: SideName, value: number): void;
  /// Called with a text whose unit only the engine knows: "50 Hz".
  spoken(side: SideName, text: string): void;
  /// Called after a text was typed that is not a value.
  refused(side: SideName, sentence: string): void;
  activated(side: SideName): void;
  /// Starts or ends the animation of the settling motion.
  watch(side: SideName, on: boolean, revolutionsPerSecond: number): void;
  close(side: SideName): void;
}

const SPEEDS = [0.25, 1, 4, 16, 64].map((speed) => ({ value: String(speed), text: `${speed} rev/s` }));

/// Returns "6207 rpm, 1X is 103.5 Hz"; with another keyphasor than the shaft "force at disc: 1860 rpm, 1X is 31 Hz".
function speedText({ speed, keyphasor }: MotionResult, units: Units): string {
  const measure = parameterMeasure('rad/s', units);
  const of = keyphasor && `${keyphasor}: `;
  return `${of}${shown(speed * measure.factor)} ${measure.unit}, 1X is ${shown(speed / (2 * Math.PI))} Hz`;
}

const REGIME_CODES: Record<string, number> = {
  undetermined: 0,
  periodic: 1,
  'quasi-periodic': 2,
  chaotic: 3,
  diverged: 4,
};

export class Pane {
  readonly root: HTMLElement;
  private readonly orbit: OrbitPanel;
  private readonly multipliers = new MultipliersPanel();
  private readonly panels: readonly Panel[];
  private readonly field = el('input', {
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
    class: 'value',
  });
  private readonly name = el('label', { for: '' });
  private readonly unit = el('span', { class: 'unit' });
  private readonly verdict = el('strong', { class: 'verdict' });
  private readonly turning = el('span', { class: 'turning' });
  private readonly confidence = el('span', { class: 'confidence' });
  private readonly reason = el('p', { class: 'reason' });
  private readonly numbers = el('div', { class: 'numbers orbit-numbers', role: 'region', tabindex: 0 });
  private readonly how = el('p', { class: 'how' });
  private readonly trouble = el('p', { class: 'trouble', role: 'alert' });
  private readonly outdated = el('p', { class: 'outdated-note' });
  private readonly play: HTMLButtonElement;
  private playing = false;
  private speed = 4;
  private factor = 1;

  constructor(
    readonly side: SideName,
    private readonly listener: PaneListener,
  ) {
    this.play = button('\u25b6', 'Watch the rotor settle from its start', () => this.setPlaying(!this.playing, true), {
      class: 'icon play',
      'aria-pressed': 'false',
    });
    const speed = select('Speed of the animation', SPEEDS, '4', (value) => {
      this.speed = Number(value);
      if (this.playing) this.listener.watch(this.side, true, this.speed);
    });
    this.orbit = new OrbitPanel([this.play, speed]);
    this.panels = [
      this.orbit,
      new PoincarePanel(),
      this.multipliers,
      new WaveformPanel(),
      new SpectrumPanel(),
      new FullSpectrumPanel(),
      new CentrelinePanel(),
    ];
    this.field.id = `value-${side}`;
    this.name.htmlFor = this.field.id;
    this.field.addEventListener('change', () => {
      const typed = typedQuantity(this.field.value);
      markField(this.field, typeof typed === 'string');
      if (typeof typed === 'string') this.listener.refused(this.side, `${this.name.textContent}: ${typed}`);
      else if (typed.unit === '' || typed.unit === this.unit.textContent)
        this.listener.value(this.side, typed.value / this.factor);
      else this.listener.spoken(this.side, `${written(typed.value, 12)} ${typed.unit}`);
    });
    const close = button('\u00d7', 'Close setting B', () => listener.close(side), { class: 'icon close' });
    this.root = el(
      'section',
      { class: `pane pane-${side}`, 'aria-label': `Setting ${side.toUpperCase()}` },
      el(
        'header',
        { class: 'card pane-head' },
        el(
          'div',
          { class: 'pane-value' },
          el('span', { class: 'side', 'aria-hidden': 'true' }, side.toUpperCase()),
          this.name,
          this.field,
          this.unit,
          this.verdict,
          this.confidence,
          ...(side === 'b' ? [close] : []),
        ),
        this.trouble,
        this.outdated,
        this.reason,
        this.numbers,
        el('div', { class: 'pane-foot' }, this.how, this.turning),
      ),
      el('div', { class: 'panels' }, ...this.panels.map((panel) => panel.root)),
    );
    this.verdict.setAttribute('role', 'status');
    this.numbers.setAttribute('aria-label', 'The orbit in numbers');
    this.root.addEventListener('focusin', () => listener.activated(side));
    this.root.addEventListener('pointerdown', () => listener.activated(side));
  }

  set active(active: boolean) {
    this.root.classList.toggle('active', active);
  }

  show(subject: PaneSubject): void {
    const measure = parameterMeasure(subject.unit, subject.units);
    this.factor = measure.factor;
    this.name.textContent = subject.parameter;
    this.unit.textContent = measure.unit;
    const refused = this.field.hasAttribute('aria-invalid') && subject.trouble !== '';
    markField(this.field, refused);
    if (!isTouched(this.field) && !refused)
      this.field.value = Number.isFinite(subject.value) ? written(subject.value * measure.factor, 6) : '';
    if (subject.orbit) this.showOrbit(subject.orbit);
    else this.showVerdict(subject.result?.verdict, subject.busy);
    this.multipliers.root.hidden = this.numbers.hidden = !subject.orbit || !subject.result;
    this.how.textContent = subject.busy || subject.how;
    this.turning.textContent = subject.result ? speedText(subject.result, subject.units) : '';
    this.trouble.textContent = subject.trouble;
    this.outdated.textContent = subject.outdated;
    this.root.classList.toggle('outdated', subject.outdated !== '');
    this.root.classList.toggle('busy', subject.busy !== '');
    const info = subject.stations[subject.station];
    if (!info) return;
    const seen: Subject = {
      motion: subject.result && new Motion(subject.result, subject.orbit),
      station: subject.station,
      // Take gap and clearance from the result's machine, as a parameter may change them.
      info: subject.result?.stations[subject.station] ?? info,
      units: subject.units,
      scales: subject.result
        ? { ...subject.scales, length: subject.result.lengthScale, speed: subject.result.speed }
        : subject.scales,
      accent: (colours) => colours[this.side],
      diagram: subject.diagram,
      measured: subject.measured,
      // Name the value of the result, which may be older than the setting.
      label: `${subject.parameter} ${shown((subject.result?.value ?? subject.value) * measure.factor, 6)}`,
    };
    for (const panel of this.panels) panel.update(seen);
    if (subject.orbit && seen.motion) this.showNumbers(subject, subject.orbit, seen.motion);
  }

  redraw(): void {
    for (const panel of this.panels) panel.redraw();
  }

  watch(trail: Trail | undefined): void {
    this.orbit.watch(trail);
  }

  /// Sets the state of the button; `tell`: calls the listener, as a click does.
  setPlaying(on: boolean, tell = false): void {
    this.playing = on;
    this.play.textContent = on ? '\u25a0' : '\u25b6';
    this.play.setAttribute('aria-pressed', String(on));
    if (!on) this.watch(undefined);
    if (tell) this.listener.watch(this.side, on, this.speed);
  }

  private showOrbit(orbit: OrbitOfBranch): void {
    this.verdict.textContent = orbit.verdict;
    const kind = orbit.stable ? `class-${regimeClass(1, Math.max(1, orbit.revolutions))}` : 'unstable';
    this.verdict.className = `verdict ${kind}`;
    this.confidence.textContent = '';
    this.reason.textContent = orbit.label;
  }

  /// Shows the orbit as a row of a table.
  private showNumbers(subject: PaneSubject, orbit: OrbitOfBranch, motion: Motion): void {
    const value = parameterMeasure(subject.unit, subject.units);
    const length = lengthMeasure(subject.units, { ...subject.scales, length: motion.result.lengthScale });
    const span = (column: number) =>
      motion.number(FIELD.ORBIT_HIGH, subject.station, column) -
      motion.number(FIELD.ORBIT_LOW, subject.station, column);
    const turns = orbit.period / (2 * Math.PI);
    const row: readonly (readonly [string, string])[] = [
      [labelled(subject.parameter, value.unit), written(orbit.value * value.factor, 9)],
      ...(orbit.rests ? [] : [['revolutions', shown(turns, 7)] as const]),
      [orbit.rests ? 'growing' : 'outside', String(orbit.unstable)],
      [orbit.rests ? 'growth per rad' : 'largest modulus', shown(orbit.largest, 6)],
      [`X (${length.unit} p-p)`, shown(span(0) * length.factor, 7)],
      [`Y (${length.unit} p-p)`, shown(span(1) * length.factor, 7)],
      ['residual', shown(orbit.residual, 2)],
    ];
    this.numbers.replaceChildren(
      numbersTable(
        'The orbit in numbers',
        row.map(([heading]) => heading),
        [row.map(([, cell]) => cell)],
      ),
    );
  }

  private showVerdict(verdict: Verdict | undefined, busy: string): void {
    this.verdict.textContent = verdict?.name ?? (busy ? '\u2026' : '');
    this.verdict.className = 'verdict';
    if (verdict) this.verdict.classList.add(`class-${regimeClass(REGIME_CODES[verdict.regime] ?? 0, verdict.period)}`);
    this.confidence.textContent = verdict?.confidence ? `confidence ${verdict.confidence}` : '';
    this.reason.textContent = readable(verdict?.reason ?? '');
  }
}
