// The page of a run-up: its parameters, the run over time and speed, and the turn at the cursor, which can play.
import { FIELD } from '../data/fields';
import type { MeasuredData } from '../data/measured';
import { SHAFT_TORQUES, type RunUp } from '../data/runup';
import { button, el, isTouched, select, setChoices } from '../dom';
import type { Range } from '../figure/chart';
import { shortName } from '../model/machine';
import type { Session } from '../model/session';
import { markField, typedQuantity } from '../model/typed';
import { parameterMeasure, shown, written, type Measure } from '../model/units';
import { chartFrame, dragModes } from './chart_frame';
import { numbersTable } from './numbers';
import type { Panel } from './panel';
import { keyElements } from './rest_subject';
import { RunOverSpeed, RunOverTime, type RunChart } from './run_charts';
import { RunOrbitPanel, RunSpectrumPanel, RunWaterfallPanel } from './run_panels';
import { motionMeasures, type RunSubject } from './run_subject';
import { TurnForcePanel, TurnGapPanel, TurnMotionPanel, TurnPanel, TurnTorquePanel } from './run_turn_panels';
import { SettingsCard, type SettingsListener } from './settings_card';

export interface RunListener {
  readonly settings: SettingsListener;
  station(index: number): void;
  /// Called after the cursor was moved, or while the run plays.
  time(seconds: number): void;
  /// Called after another run of several was chosen, by the value of their parameter.
  run(value: number): void;
  /// Compute the run at the present setting.
  compute(): void;
  /// End that computation.
  stop(): void;
}

/// Speeds of playing: seconds of the run in a second of real time.
const RATES = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64];
/// Seconds in which a whole run plays by default.
const USUAL = 20;

export class RunView {
  readonly root: HTMLElement;
  readonly settings: SettingsCard;
  private readonly overTime: RunOverTime;
  private readonly overSpeed: RunOverSpeed;
  private readonly cards: readonly ChartCard[];
  private readonly turnPanels = [
    new TurnMotionPanel(),
    new TurnForcePanel(),
    new TurnGapPanel(),
    new TurnTorquePanel(),
  ];
  private readonly panels: readonly Panel<RunSubject>[] = [
    new RunOrbitPanel(),
    ...this.turnPanels,
    new RunSpectrumPanel(),
    new RunWaterfallPanel(),
  ];
  private readonly field = el('input', {
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
    class: 'value',
    id: 'value-run',
  });
  private readonly state = el('strong', { class: 'verdict', role: 'status' });
  private readonly how = el('p', { class: 'how' });
  private readonly trouble = el('p', { class: 'trouble', role: 'alert' });
  private readonly numbers = el('div', {
    class: 'numbers',
    role: 'region',
    tabindex: 0,
    'aria-label': 'Numbers at the cursor',
  });
  private readonly bar = el('progress', { max: 1, value: 0, 'aria-label': 'Progress of the run' });
  private readonly runs: HTMLSelectElement;
  private readonly compute: HTMLButtonElement;
  private readonly cancel: HTMLButtonElement;
  private readonly play: HTMLButtonElement;
  private readonly rate: HTMLSelectElement;
  private subject: RunSubject | undefined;
  private playing = false;
  private chosenRate: number | undefined;

  constructor(private readonly listener: RunListener) {
    this.settings = new SettingsCard(listener.settings, false);
    const stackOf = (chart: () => ChartCard) => ({
      brushed: (range: Range) => chart().view(range),
      viewed: (range: Range) => chart().view(range, true),
      back: () => chart().back(),
      station: (index: number) => listener.station(index),
    });
    this.overTime = new RunOverTime({
      ...stackOf(() => this.cards[0]!),
      cursor: (time) => this.go(time),
    });
    this.overSpeed = new RunOverSpeed({
      ...stackOf(() => this.cards[1]!),
      cursor: (speed) => {
        const { run, time } = this.subject ?? {};
        const row = run?.rowAtSpeed(speed, time ?? 0) ?? -1;
        if (run && row >= 0) this.go(run.time[row]!);
      },
    });
    this.cards = [new ChartCard(this.overTime), new ChartCard(this.overSpeed)];
    this.overTime.changed = () => this.cards[0]!.legends();
    this.play = button('\u25b6', 'Play the run', () => this.setPlaying(!this.playing), {
      class: 'icon play',
      'aria-pressed': 'false',
    });
    this.rate = select(
      'Seconds of the run in a second',
      RATES.map((rate) => ({ value: String(rate), text: `${rate} s/s` })),
      '1',
      (value) => (this.chosenRate = Number(value)),
    );
    this.runs = select('Run', [], '', (value) => listener.run(Number(value)));
    this.compute = button('Compute', 'Compute the run in this page, with the orbits of all turns', () =>
      listener.compute(),
    );
    this.cancel = button('Stop', 'Stop computing', () => listener.stop());
    this.field.addEventListener('change', () => this.typed());
    this.root = el(
      'div',
      { class: 'live run', hidden: true },
      this.settings.root,
      el('div', { class: 'diagrams' }, ...this.cards.map(({ root }) => root)),
      el(
        'div',
        { class: 'panes' },
        el(
          'section',
          { class: 'pane', 'aria-label': 'At the cursor' },
          el(
            'header',
            { class: 'card pane-head' },
            el(
              'div',
              { class: 'pane-value' },
              this.play,
              this.rate,
              el('label', { for: 'value-run' }, 'time'),
              this.field,
              el('span', { class: 'unit' }, 's'),
              this.state,
              this.runs,
              this.compute,
              this.bar,
              this.cancel,
            ),
            this.trouble,
            this.how,
          ),
          el('section', { class: 'card' }, this.numbers),
          el('div', { class: 'panels' }, ...this.panels.map(({ root }) => root)),
        ),
      ),
    );
  }

  show(session: Session): void {
    const { model, side } = session;
    const run = session.runUp;
    this.showSettings(session);
    const busy = model.progress !== undefined;
    this.bar.hidden = this.cancel.hidden = !busy;
    this.bar.value = model.progress ?? 0;
    this.compute.hidden = busy || !session.engine;
    this.trouble.textContent = session.inWords(side.trouble || model.trouble);
    this.root.classList.toggle('busy', busy);
    this.showRuns(session);
    if (!run) return;
    const { address, station, stations, scales } = session;
    const time = Number.isFinite(address.time) ? Math.min(address.time, run.duration) : firstTime(run);
    const row = run.rowAt(time);
    this.subject = {
      ...{ run, time, row, station },
      info: run.stations[station] ?? stations[station]!,
      units: address.units,
      scales: { ...scales, length: run.lengthScale, speed: run.speed[row] ?? scales.speed },
      measured: session.measuredData,
      bands: session.run?.bands,
      name: shortName(session.machine),
      label: `${shown(time, 5)} s`,
    };
    for (const card of this.cards) card.show(this.subject);
    this.how.textContent = howText(session);
    this.rate.value = String(this.rateOf(run));
    this.showCursor();
  }

  redraw(): void {
    for (const card of this.cards) card.redraw();
    for (const panel of this.panels) panel.redraw();
  }

  setPlaying(on: boolean): void {
    if (on === this.playing) return;
    this.playing = on;
    this.play.textContent = on ? '\u23f8' : '\u25b6';
    this.play.title = on ? 'Pause' : 'Play the run';
    this.play.setAttribute('aria-label', this.play.title);
    this.play.setAttribute('aria-pressed', String(on));
    if (!on) return;
    const { run, time } = this.subject ?? {};
    if (run && time !== undefined && time >= run.reached) this.listener.time(0);
    let before = performance.now();
    const frame = (now: number) => {
      const { run: of, time: at } = this.subject ?? {};
      if (!this.playing || !of || at === undefined) return;
      const next = at + ((now - before) / 1000) * this.rateOf(of);
      before = now;
      // Play a run that is being computed as far as it is computed.
      const done = next >= of.duration;
      this.listener.time(Math.min(next, Math.max(of.reached, at)));
      if (done || (next >= of.reached && this.bar.hidden)) this.setPlaying(false);
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  private rateOf({ duration }: RunUp): number {
    return (
      this.chosenRate ?? RATES.reduce((best, rate) => (rate <= (1.01 * duration) / USUAL ? rate : best), RATES[0]!)
    );
  }

  private go(time: number): void {
    this.setPlaying(false);
    this.listener.time(time);
  }

  private typed(): void {
    const typed = typedQuantity(this.field.value);
    const good = typeof typed !== 'string' && (typed.unit === '' || typed.unit === 's');
    markField(this.field, !good);
    if (good) this.go(typed.value);
    else this.trouble.textContent = `time: ${typeof typed === 'string' ? typed : 'expected a number of seconds'}`;
  }

  private showRuns(session: Session): void {
    const { atRuns: diagram, unit, address } = session;
    const { factor, unit: name } = parameterMeasure(unit, address.units);
    const points = diagram ? Array.from(diagram.values.keys()).filter((point) => diagram.done[point]) : [];
    this.runs.hidden = points.length < 2;
    if (!diagram || points.length < 2) return;
    const choices = points.map((point) => ({
      value: String(diagram.values[point]),
      text: `${address.parameter} ${shown(diagram.values[point]! * factor, 5)} ${name}`.trim(),
    }));
    setChoices(this.runs, choices, String(diagram.values[diagram.nearest(session.side.choice.value)]));
  }

  private showSettings(session: Session): void {
    const { original, side } = session;
    this.settings.root.hidden = !original || !session.engine;
    if (!original || !session.engine) return;
    const withLevers = (info: typeof original) => ({ ...info, parameters: [...info.levers, ...info.parameters] });
    const current = side.info ?? original;
    this.settings.show({
      original: withLevers(original),
      current: withLevers({
        ...current,
        parameters: current.parameters.map((parameter) =>
          parameter.expression ? parameter : { ...parameter, value: session.valueOf(side, parameter.name) },
        ),
      }),
      assignments: side.choice.assignments,
      swept: session.address.parameter,
      units: session.address.units,
      side: side.name,
      comparing: false,
      computation: {},
      fitted: [],
      trouble: session.inWords(side.trouble),
    });
  }

  private showCursor(): void {
    const subject = this.subject!;
    const { run, time, row, units } = subject;
    if (!isTouched(this.field)) {
      markField(this.field, false);
      this.field.value = written(time, 6);
    }
    const speed = parameterMeasure('rad/s', units);
    this.state.textContent = row < 0 ? '' : `${shown(run.speed[row]! * speed.factor, 5)} ${speed.unit}`;
    for (const chart of [this.overTime, this.overSpeed]) chart.cursor(subject);
    // Hide panels that have nothing to show: a station that only twists has neither orbit nor spectra.
    for (const panel of this.panels) {
      panel.root.hidden = !(panel instanceof TurnPanel ? panel.shows(subject) : !subject.info.twists);
      if (!panel.root.hidden) panel.update(subject);
    }
    this.numbers.replaceChildren(
      ...stationsTable(subject, false),
      ...stationsTable(subject, true),
      ...contactsTable(subject),
      ...torquesTable(subject),
      turnTable(subject),
    );
  }
}

/// Returns the time that is shown first: that of the largest motion of the first station.
function firstTime(run: RunUp): number {
  const radius = run.column(FIELD.RUNUP_RADIUS, 0);
  const best = run.rows.reduce(
    (most, row) => ((radius[row] ?? 0) > (radius[most] ?? 0) ? row : most),
    run.rows[0] ?? 0,
  );
  return run.time[best] ?? 0;
}

/// Makes a table of the stations that only twist (`twists`), or of the other stations; returns no table if there are
/// none.
function stationsTable({ run, row, station, units, scales }: RunSubject, twists: boolean): HTMLElement[] {
  const which = Array.from(run.stations.keys()).filter((i) => run.stations[i]!.twists === twists);
  if (which.length === 0) return [];
  const { length, amplitude } = motionMeasures(run.stations[which[0]!]!, units, scales);
  const lag: Measure = { factor: 1, unit: '\u00b0' };
  // Heading, field and its column, measure.
  const columns: readonly (readonly [string, string, number, Measure])[] = twists
    ? [
        ['twist at 1X', FIELD.RUNUP_AMPLITUDE, 0, amplitude],
        ['lag', FIELD.RUNUP_LAG, 0, lag],
        ['largest', FIELD.RUNUP_RADIUS, 0, length],
        ['mean', FIELD.RUNUP_CENTRE, 0, length],
      ]
    : [
        ['x at 1X', FIELD.RUNUP_AMPLITUDE, 0, amplitude],
        ['lag', FIELD.RUNUP_LAG, 0, lag],
        ['y at 1X', FIELD.RUNUP_AMPLITUDE, 1, amplitude],
        ['lag', FIELD.RUNUP_LAG, 1, lag],
        ['largest radius', FIELD.RUNUP_RADIUS, 0, length],
        ['mean x', FIELD.RUNUP_CENTRE, 0, length],
        ['mean y', FIELD.RUNUP_CENTRE, 1, length],
      ];
  const heading = columns.map(([text, , , { unit }]) => `${text} (${unit})`);
  const rows = which.map((i) => [
    run.stations[i]!.name,
    ...columns.map(([, field, column, { factor }]) => shown((run.column(field, i, column)[row] ?? NaN) * factor)),
  ]);
  const caption = twists ? 'Twist at the cursor' : 'Motion at the cursor';
  return [numbersTable(caption, ['station', ...heading], rows, which.indexOf(station))];
}

function contactsTable({ run, row }: RunSubject): HTMLElement[] {
  if (run.contacts.length === 0) return [];
  const rows = run.contacts.map((name, i) => {
    const [force, share] = [FIELD.RUNUP_FORCE, FIELD.RUNUP_SHARE].map((field) => run.column(field, i)[row] ?? NaN);
    return [name, force! > 0 ? 'closed' : 'open', shown(force!), shown(100 * share!, 3)];
  });
  return [numbersTable('Contacts at the cursor', ['contact', 'now', 'largest force (N)', 'of the turn (%)'], rows)];
}

/// Makes a table of the torques of motors and shafts: within the row of the cursor, and in the whole run.
function torquesTable({ run, row, units }: RunSubject): HTMLElement[] {
  const { factor, unit } = parameterMeasure('N m', units);
  const { torques } = run;
  if (torques.length === 0) return [];
  const inRun = (i: number, column: number) => run.column(FIELD.RUNUP_TORQUE_EXTREME, 0, column)[i] ?? NaN;
  const rows = torques.map(({ name, least, largest }, i) => [
    name,
    ...[largest[row] ?? NaN, least[row] ?? NaN, inRun(i, 0), inRun(i, 2)].map((value) => shown(value * factor)),
    shown(inRun(i, 1)),
  ]);
  const heading = [
    'torque',
    ...['largest', 'least', 'largest of the run', 'least of the run'].map((text) => `${text} (${unit})`),
    'largest at (s)',
  ];
  return [numbersTable('Torques at the cursor', heading, rows)];
}

/// Makes a table of the turns so far, and of the torques, which a run with a prescribed rate does not have.
function turnTable({ run, row, units }: RunSubject): HTMLElement {
  const torque = parameterMeasure('N m', units);
  const torques = SHAFT_TORQUES.flatMap((name, i) => {
    const value = run.column(FIELD.RUNUP_TORQUE, 0, i)[row] ?? NaN;
    return Number.isFinite(value) ? [{ heading: `${name} (${torque.unit})`, text: shown(value * torque.factor) }] : [];
  });
  return numbersTable(
    'The shaft at the cursor',
    ['turns', ...torques.map(({ heading }) => heading)],
    [[shown(run.column(FIELD.RUNUP_TURNS)[row] ?? NaN, 6), ...torques.map(({ text }) => text)]],
  );
}

const ENDS = ['as planned', 'the shaft stood still', 'the motion left all bounds', 'the solver could not go on'];

function howText(session: Session): string {
  const { model, runUp } = session;
  const { result } = model;
  const stored = !model.run;
  const end = stored || model.progress === undefined ? ENDS[runUp?.number(FIELD.RUNUP_END) ?? 0] : undefined;
  const ended = end ? `; ended ${end === ENDS[0] ? end : `because ${end}`}` : '';
  if (stored) return `Stored run${ended}. Compute shows all turns.`;
  if (model.progress !== undefined) return `${model.quick ? 'A quick look' : 'The run'}, computed so far\u2026`;
  const { options, seconds } = result!;
  return (
    `${model.quick ? 'A quick look' : 'Computed in this page'} by ${options['runup_method']}, tolerance ` +
    `${options['runup_rtol']}, ${shown(seconds, 3)} s${ended}.`
  );
}

/// The card of a pair of charts with its own view.
class ChartCard {
  readonly root: HTMLElement;
  private readonly legend = el('div', { class: 'legend' });
  private readonly backButton: HTMLButtonElement;
  private views: Range[] = [];
  private subject: RunSubject | undefined;
  private shown: { readonly run: RunUp; readonly of: string; readonly measured: readonly MeasuredData[] } | undefined;

  constructor(private readonly chart: RunChart) {
    const { stack } = chart;
    const modes = dragModes(stack, 'the turn');
    this.backButton = button('Back', 'Back to the view before', () => stack.back());
    const reset = button('Reset', 'The whole run', () => {
      stack.fit();
      this.views = [];
      this.refresh();
    });
    this.root = chartFrame(
      chart,
      () => this.subject?.name ?? '',
      el('div', { class: 'tools' }, modes.root, this.backButton, reset),
      stack.root,
      this.legend,
    );
  }

  /// Redraws only if the lines change; the cursor moves over them.
  show(subject: RunSubject): void {
    this.subject = subject;
    const of = JSON.stringify([subject.units, subject.station]);
    if (this.shown?.run === subject.run && this.shown.of === of && this.shown.measured === subject.measured) return;
    this.shown = { run: subject.run, of, measured: subject.measured };
    this.refresh();
  }

  redraw(): void {
    this.chart.stack.redraw();
  }

  legends(): void {
    this.legend.replaceChildren(...keyElements(this.chart.keys()));
  }

  /// Shows a range of the axis, within the whole range; `moved`: it replaces the present view, without a step to go
  /// back.
  view([low, high]: Range, moved = false): void {
    const [from, to] = this.whole;
    const size = Math.min(high - low, to - from);
    if (!(size > 1e-6 * (to - from))) return;
    const start = Math.min(Math.max(low, from), to - size);
    this.views = [...this.views.slice(0, moved ? -1 : undefined), [start, start + size]];
    this.refresh();
  }

  back(): void {
    this.views = this.views.slice(0, -1);
    this.refresh();
  }

  private get whole(): Range {
    return this.subject ? this.chart.whole(this.subject.run) : [0, 1];
  }

  private refresh(): void {
    if (!this.subject) return;
    this.backButton.disabled = this.views.length === 0;
    this.chart.show(this.subject, this.views.at(-1) ?? this.whole);
    this.chart.cursor(this.subject);
    this.legends();
  }
}
