// The page of a machine at rest: the Campbell diagram and the shapes of modes, or the response to unbalance.
import { ROUNDING, whirlOf, WHIRL_TEXT, type AtRest, type Mode } from '../data/rest';
import { button, el, isTouched } from '../dom';
import { shortName } from '../model/machine';
import type { Session } from '../model/session';
import type { RestChoice } from '../model/setting';
import { markField, typedQuantity } from '../model/typed';
import { amplitudeMeasure, naturalMeasure, parameterMeasure, shown, shownWhole, written } from '../model/units';
import { DisplacementsPanel, ShapePanel, sizeText, type Motion, type SwaySubject } from './along_shaft';
import { BodeView } from './bode';
import { CampbellView, dampingText, topOf } from './campbell';
import { numbersTable } from './numbers';
import type { Panel } from './panel';
import { PolarPanel, RestPanel, seenTexts, SynchronousOrbitPanel } from './response_panels';
import { RestCard, type RestCardListener } from './rest_card';
import { probeOf, WHIRL_MARKS, type RestChart, type RestSubject } from './rest_subject';

export interface RestListener extends RestCardListener {
  station(index: number): void;
  chosen(part: Partial<RestChoice>): void;
}

const SIGNS = { up: '\u25b2', down: '\u25bc', square: '\u25a0' } as const;

function whirlSign(direction: number): HTMLElement {
  const whirl = whirlOf(direction);
  const sign = SIGNS[WHIRL_MARKS[whirl] as keyof typeof SIGNS];
  return el('span', {}, el('span', { class: `sign sign-${whirl}`, 'aria-hidden': 'true' }, sign), WHIRL_TEXT[whirl]);
}

/// Words for the stability of the machine.
const STATES: ReadonlyMap<number, string> = new Map([
  [1, 'unstable'],
  [0, 'undamped'],
  [-1, 'stable'],
]);

/// The card and the panels of one kind of result.
interface Kind {
  readonly chart: RestChart;
  readonly card: RestCard;
  readonly panels: readonly Panel<SwaySubject>[];
}

export class RestView {
  readonly root: HTMLElement;
  private readonly kinds: Readonly<Record<AtRest['kind'], Kind>>;
  private readonly name = el('label', { for: 'value-rest' });
  private readonly field = el('input', {
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
    class: 'value',
    id: 'value-rest',
  });
  private readonly unit = el('span', { class: 'unit' });
  private readonly state = el('strong', { class: 'verdict', role: 'status' });
  private readonly how = el('p', { class: 'how' });
  private readonly numbers = el('div', { class: 'numbers', role: 'region', tabindex: 0 });
  private readonly left = el('p', { class: 'status' });
  private readonly title = el('h3');
  private factor = 1;

  constructor(private readonly listener: RestListener) {
    const kind = (chart: RestChart, panels: readonly Panel<SwaySubject>[]): Kind => ({
      chart,
      card: new RestCard(chart, listener),
      panels,
    });
    this.kinds = {
      modes: kind(new CampbellView(listener), [
        new ShapePanel('Mode shape'),
        new DisplacementsPanel('Mode shape along the shaft'),
      ]),
      unbalance: kind(new BodeView(listener), [
        new PolarPanel(),
        new SynchronousOrbitPanel(),
        new RestPanel(),
        new ShapePanel('Deflected shape'),
        new DisplacementsPanel('Deflection along the shaft'),
      ]),
    };
    this.field.addEventListener('change', () => this.typed());
    const kinds = Object.values(this.kinds);
    const panes = el(
      'div',
      { class: 'panes' },
      el(
        'section',
        { class: 'pane', 'aria-label': 'At the cursor' },
        el(
          'header',
          { class: 'card pane-head' },
          el('div', { class: 'pane-value' }, this.name, this.field, this.unit, this.state),
          this.how,
        ),
        el('section', { class: 'card' }, this.title, this.numbers, this.left),
        el('div', { class: 'panels' }, ...kinds.flatMap(({ panels }) => panels.map(({ root }) => root))),
      ),
    );
    this.root = el('div', { class: 'live rest', hidden: true }, ...kinds.map(({ card }) => card.root), panes);
  }

  show(session: Session, rest: AtRest): void {
    for (const [name, { card, panels }] of Object.entries(this.kinds))
      for (const root of [card.root, ...panels.map((panel) => panel.root)]) root.hidden = name !== rest.kind;
    const { chart, card, panels } = this.kinds[rest.kind];
    const subject = subjectOf(session, rest);
    const { sight, sights, side } = session;
    this.showHead(subject, side.choice.value);
    card.show({ ...subject, depth: sights.behind, status: sight.text });
    chart.stack.setCursors(rest.diagram.values[subject.point] ?? NaN, NaN);
    this.title.textContent = this.showNumbers(subject);
    this.numbers.setAttribute('aria-label', this.title.textContent);
    const motion = motionOf(subject);
    // File names contain the station, or the mode.
    const info = rest.kind === 'modes' ? { ...subject.info, name: `mode-${modeOf(subject) + 1}` } : subject.info;
    for (const panel of panels) panel.update({ ...subject, info, motion });
  }

  redraw(): void {
    for (const { chart, panels } of Object.values(this.kinds)) {
      chart.stack.redraw();
      for (const panel of panels) panel.redraw();
    }
  }

  private typed(): void {
    const typed = typedQuantity(this.field.value);
    const good = typeof typed !== 'string' && (typed.unit === '' || typed.unit === this.unit.textContent);
    markField(this.field, !good);
    if (good) this.listener.cursor(typed.value / this.factor, true);
    else this.how.textContent = typeof typed === 'string' ? typed : `expected a number in ${this.unit.textContent}`;
  }

  private showHead({ rest, point, parameter, unit, units }: RestSubject, value: number): void {
    const measure = parameterMeasure(unit, units);
    this.factor = measure.factor;
    this.name.textContent = parameter || 'one point';
    this.unit.textContent = parameter ? measure.unit : '';
    this.field.hidden = !parameter;
    const exact = rest.diagram.values[point] ?? NaN;
    if (!isTouched(this.field) && !this.field.hasAttribute('aria-invalid'))
      this.field.value = written(exact * measure.factor, 6);
    const growing = rest.kind === 'modes' && point >= 0 ? rest.growing(point) : NaN;
    this.state.textContent = STATES.get(growing) ?? '';
    this.state.className = `verdict ${growing > 0 ? 'class-7' : 'class-0'}`;
    const speed = parameterMeasure('rad/s', units);
    const parts = [`speed of the shaft ${shown(rest.speed(point) * speed.factor, 6)} ${speed.unit}`];
    if (Math.abs(exact - value) > 1e-9 * Math.abs(exact)) parts.push('the nearest point that was computed');
    if (rest.modulo(point) > 0)
      parts.push('coefficients turn with the shaft: frequencies are known but for multiples of the speed');
    const closed = rest.closedContacts(point);
    if (closed.length > 0) parts.push(`rests against ${closed.join(' and ')}, which small motions do not open`);
    this.how.textContent = `${parts.join('; ')}.`;
  }

  /// Fills the table; returns its title.
  private showNumbers(subject: RestSubject): string {
    const { rest, label } = subject;
    const title = rest.kind === 'modes' ? `Modes at ${label}` : `Response at ${label}`;
    const table = rest.kind === 'modes' ? this.modesTable(subject, title) : stationsTable(subject, title);
    const left =
      rest.kind === 'modes' ? rest.modes(subject.point).length - table.querySelectorAll('tbody tr').length : 0;
    this.left.textContent = left > 0 ? `${left} more above the diagram's frequencies: "all" shows them.` : '';
    const focus = this.numbers.contains(document.activeElement) ? modeOf(subject) : -1;
    this.numbers.replaceChildren(table);
    // Rebuilding the table removes the focused button: focus it again.
    if (focus >= 0) this.numbers.querySelectorAll('button')[focus]?.focus({ preventScroll: true });
    return title;
  }

  private modesTable(subject: RestSubject, title: string): HTMLElement {
    const { rest, point, units } = subject;
    const frequency = naturalMeasure(units);
    const chosen = modeOf(subject);
    const modes = rest.modes(point);
    const named = modes.some(({ name }) => name);
    const row = (mode: Mode, i: number) => [
      button(`${i + 1}`, `Show the shape of mode ${i + 1}`, () => this.listener.chosen({ mode: i }), {
        'aria-pressed': String(i === chosen),
      }),
      ...(named ? [mode.name] : []),
      whirlSign(mode.direction),
      shownWhole(mode.frequency * frequency.factor, 5),
      dampingText(mode.ratio),
      dampingText(mode.decrement),
      Math.abs(mode.growth) <= ROUNDING * mode.frequency ? '0' : shown(mode.growth, 3),
    ];
    const heading = [
      'mode',
      ...(named ? ['name'] : []),
      'whirl',
      `damped frequency (${frequency.unit})`,
      'damping ratio',
      'log. decrement',
      'growth (1/s)',
    ];
    // Leave out the modes that the diagram leaves out.
    const top = topOf(subject);
    const rows = modes.map(row).filter((_, i) => modes[i]!.frequency <= top || i <= chosen);
    return numbersTable(title, heading, rows, chosen);
  }
}

function stationsTable(subject: RestSubject, title: string): HTMLElement {
  const { rest, station, units, scales } = subject;
  const { unit } = amplitudeMeasure(units, scales);
  const probe = probeOf(subject);
  const heading = [
    'station',
    ...[probe, probe + 90].flatMap((angle) => [`at ${written(angle, 4)}\u00b0 (${unit})`, 'lag (\u00b0)']),
    `major axis (${unit})`,
    'whirl',
  ];
  const rows = rest.stations.map(({ name }, i) => [name, ...seenTexts(subject, i)]);
  return numbersTable(title, heading, rows, station);
}

/// Returns the shown mode: the chosen mode, or the last one if there are fewer modes.
function modeOf({ rest, point, choice }: RestSubject): number {
  return Math.min(choice.mode, Math.max(0, rest.modes(point).length - 1));
}

function motionOf(subject: RestSubject): Motion {
  const { rest, point, units, scales } = subject;
  if (rest.kind === 'unbalance') {
    const sways = rest.stations.map((_, station) => rest.response(point, station));
    const { factor, unit } = amplitudeMeasure(units, scales);
    const text = `${sizeText({ sways, factor, unit })}; the dot: at the mark`;
    return { sways, factor, unit, text, line: rest.shafts(point) };
  }
  const index = modeOf(subject);
  const mode = rest.modes(point)[index];
  const frequency = naturalMeasure(units);
  return {
    sways: rest.shape(point, index),
    factor: 1,
    unit: '',
    line: rest.shafts(point, index),
    text: mode
      ? `mode ${index + 1}${mode.name && ` (${mode.name})`}, ${WHIRL_TEXT[whirlOf(mode.direction)]}, ` +
        `${shownWhole(mode.frequency * frequency.factor, 5)} ${frequency.unit}; the dots move from blank to bright`
      : '',
  };
}

function subjectOf(session: Session, rest: AtRest): RestSubject {
  const { address, sight, unit, station, stations, scales, side } = session;
  const { parameter, units } = address;
  const point = parameter ? rest.diagram.nearest(side.choice.value) : (rest.order[0] ?? -1);
  const measure = parameterMeasure(unit, units);
  return {
    ...{ rest, point, parameter, unit, units, station },
    name: shortName(session.machine),
    range: sight.range,
    info: stations[station]!,
    scales: { ...scales, length: rest.diagram.lengthScales[point] ?? scales.length, speed: rest.speed(point) },
    choice: address.rest,
    measured: session.measuredData,
    bands: session.run?.bands,
    label: parameter
      ? `${parameter} ${shown((rest.diagram.values[point] ?? NaN) * measure.factor, 6)} ${measure.unit}`.trim()
      : 'rest',
  };
}
