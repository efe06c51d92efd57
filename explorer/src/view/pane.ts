// A pane: the motion at one setting (A or B), its verdict in words, and its panels.
import { Motion } from '../data/motion';
import { button, el, isTouched, select } from '../dom';
import type { Diagram } from '../data/diagram';
import type { PointResult, StationInfo, Verdict } from '../engine/protocol';
import { regimeClass } from '../data/regimes';
import type { SideName } from '../model/session';
import { markField, typedQuantity } from '../model/typed';
import { parameterMeasure, readable, shown, written, type Scales, type Units } from '../model/units';
import { CentrelinePanel } from './centreline';
import { OrbitPanel, type Trail } from './orbit';
import type { Panel, Subject } from './panel';
import { PoincarePanel } from './poincare';
import { FullSpectrumPanel, SpectrumPanel } from './spectrum';
import { WaveformPanel } from './waveform';

export interface PaneSubject {
  readonly result: PointResult | undefined;
  readonly parameter: string;
  readonly unit: string;
  readonly value: number;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly units: Units;
  readonly scales: Scales;
  readonly diagram: Diagram | undefined;
  /// What is being done, "" when nothing is.
  readonly busy: string;
  /// What went wrong, "" when nothing did.
  readonly trouble: string;
  /// A sentence on how the motion was computed.
  readonly how: string;
  /// What the result is of, where it is not of the present setting; else "".
  readonly outdated: string;
}

export interface PaneListener {
  value(side: SideName, value: number): void;
  /// The same in a unit that only the engine knows: "50 Hz".
  spoken(side: SideName, text: string): void;
  /// A text that is no value was typed.
  refused(side: SideName, sentence: string): void;
  activated(side: SideName): void;
  /// Starts or ends watching how the motion settles.
  watch(side: SideName, on: boolean, revolutionsPerSecond: number): void;
  close(side: SideName): void;
}

const SPEEDS = [0.25, 1, 4, 16, 64].map((speed) => ({ value: String(speed), text: `${speed} rev/s` }));

/// "6207 rpm, 1X is 103.5 Hz", and "force at disc: 1860 rpm, 1X is 31 Hz" where sections are not the shaft's.
function speedText({ speed, keyphasor }: PointResult, units: Units): string {
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
        el('div', { class: 'pane-foot' }, this.how, this.turning),
      ),
      el('div', { class: 'panels' }, ...this.panels.map((panel) => panel.root)),
    );
    this.verdict.setAttribute('role', 'status');
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
    this.showVerdict(subject.result?.verdict, subject.busy);
    this.how.textContent = subject.busy || subject.how;
    this.turning.textContent = subject.result ? speedText(subject.result, subject.units) : '';
    this.trouble.textContent = subject.trouble;
    this.outdated.textContent = subject.outdated;
    this.root.classList.toggle('outdated', subject.outdated !== '');
    this.root.classList.toggle('busy', subject.busy !== '');
    const info = subject.stations[subject.station];
    if (!info) return;
    const seen: Subject = {
      motion: subject.result && new Motion(subject.result),
      station: subject.station,
      // The gap and the clearance of this very machine: a parameter may have changed them.
      info: subject.result?.stations[subject.station] ?? info,
      units: subject.units,
      scales: subject.result
        ? { ...subject.scales, length: subject.result.lengthScale, speed: subject.result.speed }
        : subject.scales,
      accent: (colours) => colours[this.side],
      diagram: subject.diagram,
      // Of the result: the setting may have moved on.
      label: `${subject.parameter} ${shown((subject.result?.value ?? subject.value) * measure.factor, 6)}`,
    };
    for (const panel of this.panels) panel.update(seen);
  }

  redraw(): void {
    for (const panel of this.panels) panel.redraw();
  }

  watch(trail: Trail | undefined): void {
    this.orbit.watch(trail);
  }

  /// Ends the animation from outside; a click also tells the listener.
  setPlaying(on: boolean, tell = false): void {
    this.playing = on;
    this.play.textContent = on ? '\u25a0' : '\u25b6';
    this.play.setAttribute('aria-pressed', String(on));
    if (!on) this.watch(undefined);
    if (tell) this.listener.watch(this.side, on, this.speed);
  }

  private showVerdict(verdict: Verdict | undefined, busy: string): void {
    this.verdict.textContent = verdict?.name ?? (busy ? '\u2026' : '');
    this.verdict.className = 'verdict';
    if (verdict) this.verdict.classList.add(`class-${regimeClass(REGIME_CODES[verdict.regime] ?? 0, verdict.period)}`);
    this.confidence.textContent = verdict?.confidence ? `confidence ${verdict.confidence}` : '';
    this.reason.textContent = readable(verdict?.reason ?? '');
  }
}
