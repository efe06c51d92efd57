// The page: its parts, and the data of the session that each shows.
import { el } from '../dom';
import type { OrbitOfBranch } from '../data/orbit';
import { setDark, theme } from '../figure/figure';
import { firstQuantityOf } from '../data/map_quantities';
import { shortName } from '../model/machine';
import { methodText, VECTORS, type Change, type Session, type SideName } from '../model/session';
import { assignmentTexts } from '../model/setting';
import type { SideModel } from '../model/side';
import { parameterMeasure, readable, shown } from '../model/units';
import { DocumentView, type DocumentListener } from './document';
import { Help } from './help';
import { MapCard, type MapCardListener } from './map_card';
import { MeasuredBar, type MeasuredListener } from './measured_bar';
import { Pane, type PaneListener } from './pane';
import type { Spot } from './parameter_map';
import { ParameterMapCard, type ParameterMapCardListener } from './parameter_map_card';
import { RestView, type RestListener } from './rest';
import { RunView, type RunListener } from './run';
import { SettingsCard, type SettingsListener } from './settings_card';
import { Topbar, type TopbarListener } from './topbar';

export interface PageListener {
  readonly topbar: TopbarListener;
  readonly card: MapCardListener;
  readonly map: ParameterMapCardListener;
  readonly settings: SettingsListener;
  readonly pane: PaneListener;
  readonly rest: RestListener;
  readonly run: RunListener;
  readonly document: DocumentListener;
  readonly measured: MeasuredListener;
}

export class Page {
  readonly root = el('div', { class: 'app' });
  readonly card: MapCard;
  private readonly mapCard: ParameterMapCard;
  readonly settings: SettingsCard;
  readonly panes: Readonly<Record<SideName, Pane>>;
  private readonly rest: RestView;
  private readonly run: RunView;
  private readonly document: DocumentView;
  private readonly motions: HTMLElement;
  private readonly topbar: Topbar;
  readonly measured: MeasuredBar;
  private readonly help = new Help();
  private readonly footer = el('p');
  private readonly banner = el('p', { class: 'trouble banner', role: 'alert' });

  constructor(
    private readonly session: Session,
    listener: PageListener,
  ) {
    this.panes = { a: new Pane('a', listener.pane), b: new Pane('b', listener.pane) };
    this.topbar = new Topbar(listener.topbar);
    this.card = new MapCard(listener.card);
    this.mapCard = new ParameterMapCard(listener.map);
    this.settings = new SettingsCard(listener.settings);
    this.rest = new RestView(listener.rest);
    this.run = new RunView(listener.run);
    this.document = new DocumentView(listener.document);
    this.measured = new MeasuredBar(listener.measured);
    this.motions = el(
      'div',
      { class: 'live' },
      this.settings.root,
      el('div', { class: 'diagrams' }, this.mapCard.root, this.card.root),
      el('div', { class: 'panes' }, this.panes.a.root, this.panes.b.root),
    );
    this.root.append(
      this.topbar.root,
      this.banner,
      this.document.contents,
      this.measured.root,
      el('main', {}, this.motions, this.rest.root, this.run.root, this.document.root),
      el('footer', {}, this.footer),
      this.help.root,
    );
  }

  /// Shows the name of a missing part of the page; "" hides the message.
  sayMissing(missing: string): void {
    this.banner.textContent = missing;
    this.footer.textContent = missing
      ? ''
      : 'Computed in this page by the C core of whirl; nothing leaves your computer.';
  }

  /// Shows a message about an export.
  say(text: string): void {
    for (const card of [this.settings, this.run.settings]) card.say(text);
  }

  setTheme(dark: boolean): void {
    setDark(dark);
    document.documentElement.classList.toggle('dark', dark);
    theme().classes.forEach((colour, kind) => document.documentElement.style.setProperty(`--class-${kind}`, colour));
    for (const pane of Object.values(this.panes)) pane.redraw();
    this.card.map.refresh();
    this.mapCard.map.refresh();
    this.rest.redraw();
    this.run.redraw();
  }

  openHelp(): void {
    this.help.open(this.session.machine.run?.facts ?? []);
  }

  show(changes: ReadonlySet<Change>): void {
    const { atRest, moves, runsUp, parts, part } = this.session;
    this.motions.hidden = !moves;
    this.footer.hidden = !moves && !runsUp; // other views compute nothing
    this.rest.root.hidden = atRest === undefined;
    this.run.root.hidden = !runsUp;
    if (!runsUp) this.run.setPlaying(false);
    this.measured.show(this.session);
    this.document.show(parts, part);
    this.document.mark(this.session.stations[this.session.station]?.name ?? '');
    if (!moves) {
      this.showTop();
      if (atRest) this.rest.show(this.session, atRest);
      if (runsUp) this.run.show(this.session);
      return;
    }
    if (changes.has('all')) this.showAll();
    else if (changes.has('map')) this.showMap();
    if (!changes.has('all') && changes.has('grow')) this.card.grow();
    for (const name of this.session.shownSides()) if (changes.has('all') || changes.has(name)) this.showPane(name);
    this.showCursors();
    this.showCells();
    this.showSettings();
  }

  private showCursors(): void {
    const { session } = this;
    const { a, b } = session.sides;
    const orbits = [a, b].map(({ choice }) => session.orbitOf(choice)) as [OrbitOfBranch?, OrbitOfBranch?];
    const comparing = session.address.b !== undefined;
    const { map } = this.card;
    map.stack.setCursors(a.choice.value, comparing ? b.choice.value : NaN, orbits[0]?.label);
    map.setOrbits(
      [orbits[0]?.point, comparing ? orbits[1]?.point : undefined],
      session.orbitOf(session.side.choice)?.point,
      // Orbits can be chosen only for the unchanged machine, to which branches belong.
      session.side.choice.assignments.size === 0,
    );
  }

  /// Shows the positions of the sides in the map.
  private showCells(): void {
    const { session } = this;
    const { map, sides } = session;
    if (!map) return;
    const spot = (name: SideName): Spot => [
      session.valueOf(sides[name], map.x.parameter),
      session.valueOf(sides[name], map.y.parameter),
    ];
    const b = session.address.b ? spot('b') : undefined;
    this.mapCard.setCursors(spot('a'), b, session.active, session.address.parameter);
  }

  private showMap(): void {
    const { session } = this;
    const { map, planes, plane, address, station, stations, scales, refinement } = session;
    this.card.root.classList.toggle('below-map', map !== undefined);
    if (!map) {
      this.mapCard.show(undefined);
      return;
    }
    const [x, y] = [map.x.parameter, map.y.parameter];
    const stale = Array.from(session.side.choice.assignments.keys()).some(
      (name) => ![x, y, map.plane?.parameter].includes(name),
    );
    this.mapCard.show({
      ...{ map, plane, station, stations, scales, stale },
      planes: planes!,
      unitOfPlanes: session.unitOf(planes!.parameter),
      units: address.units,
      quantity: address.mapQuantity || firstQuantityOf(map),
      lines: address.mapLines,
      unitsOfAxes: [session.unitOf(x), session.unitOf(y)],
      along: address.parameter,
      live: refinement?.grids ?? [],
      refining: session.engine && (refinement?.busy ?? false),
      status:
        session.mapText +
        (stale ? ' Other parameters have been changed since: the map does not know.' : '') +
        (refinement ? ` ${refinement.text}` : ''),
      name: shortName(session.machine),
    });
  }

  /// Returns the data that the diagram and the panes share.
  private common() {
    const { sight, address, unit, station, stations, scales } = this.session;
    return {
      diagram: sight.diagram,
      parameter: address.parameter,
      unit,
      station,
      stations,
      units: address.units,
      scales,
    };
  }

  private showTop(): void {
    const { machine, machines, address, scales, moves, intro, view } = this.session;
    this.topbar.show(machine, intro, machines, address.units, scales.symbol, address.b !== undefined, !moves);
    this.topbar.offerMeasured(this.session.engine !== undefined && this.session.measurable);
    // Stored statements and tables keep the units of the report.
    this.topbar.offerUnits(view !== '');
  }

  private showAll(): void {
    const { session } = this;
    const comparing = session.address.b !== undefined;
    this.root.classList.toggle('comparing', comparing);
    this.panes.b.root.hidden = !comparing;
    for (const name of ['a', 'b'] as const) this.panes[name].active = comparing && name === session.active;
    this.showTop();
    const { sight } = session;
    const text = [sight.text, sight.note].filter((part) => part).join(' ');
    const stale = sight.of !== assignmentTexts(session.side.choice.assignments).join('; ');
    this.card.show({
      ...this.common(),
      branches: sight.of === '' ? session.branches : undefined,
      tori: sight.of === '' ? session.tori : undefined,
      quantity: session.address.quantity,
      range: sight.range,
      hidden: session.hidden,
      band: session.band,
      measured: session.measuredData.flatMap((data) => {
        const shown = VECTORS.get(session.address.quantity);
        const seen = shown && session.seenAlong(data, shown.direction);
        return seen ? [{ name: data.name, seen, lag: shown.lag }] : [];
      }),
      parameters: session.parameterNames,
      depth: session.sights.behind,
      computes: session.engine !== undefined,
      status: stale
        ? `${text} The parameters have been changed since: Recompute shows the diagram of the changed machine.`
        : text,
      stale,
      name: shortName(session.machine),
    });
    this.card.progress(session.sights.progress);
    this.showMap();
  }

  /// Returns a sentence on the computation of the shown result.
  private howOf(side: SideModel, orbit: OrbitOfBranch | undefined): string {
    const { result, preview, choice } = side;
    if (!result) return orbit ? '' : this.storedVerdict(choice.value);
    const { options } = result;
    if (side.stored)
      return `Stored by the run: ${options.transient} + ${options.record} revolutions, ${methodText(options)}`;
    const time = `${Math.round(result.seconds * 1000)} ms`;
    if (orbit) return `The orbit as the run has stored it, followed from its own states, ${time}`;
    return (
      `${preview ? 'A quick look: ' : ''}${options.transient} + ${options.record} revolutions ` +
      `by ${methodText(options)} of ${options.steps_per_revolution} steps, ${time}`
    );
  }

  private showPane(name: SideName): void {
    const side = this.session.sides[name];
    const { result } = side;
    // Take the choice of the result, which may be older than the side's present choice; without an engine take the
    // present one.
    const of = this.session.engine ? side.resultOf : side.choice;
    const orbit = of && !result?.verdict ? this.session.orbitOf(of) : undefined;
    const { machine, measured, station } = this.session;
    this.panes[name].show({
      ...this.common(),
      result,
      measured: result ? measured.motions(machine.name, station, result.speed, result.lengthScale) : [],
      orbit,
      value: side.choice.value,
      busy: side.busy && !result ? 'computing \u2026' : '',
      trouble: this.session.inWords(side.trouble),
      how: this.howOf(side, orbit),
      outdated: this.outdatedText(side),
    });
    this.panes[name].root.classList.toggle('busy', side.busy);
  }

  /// Returns the label of an outdated result that is still shown.
  private outdatedText(side: SideModel): string {
    const { parameter, units } = this.session.address;
    if (!side.outdated || !side.result || !side.resultOf) return '';
    const { factor, unit } = parameterMeasure(this.session.unit, units);
    const { value, assignments } = side.resultOf;
    const parts = [
      ...(parameter && Number.isFinite(value) ? [`${parameter} = ${shown(value * factor, 6)} ${unit}`.trim()] : []),
      ...assignmentTexts(assignments),
    ];
    return `Below: the last setting that could be computed${parts.length ? `, ${parts.join('; ')}` : ''}.`;
  }

  /// Returns the stored verdict of the nearest point, for a page that cannot compute.
  private storedVerdict(value: number): string {
    const { diagram } = this.session.sight;
    const point = diagram?.nearest(value) ?? -1;
    if (!diagram || point < 0) return '';
    const [verdict, reason] = diagram.verdicts[point]!;
    return (
      `Nearest stored point, ${this.session.address.parameter} = ${Number(diagram.values[point]!.toPrecision(6))}: ` +
      `${verdict}; ${readable(reason)}.`
    );
  }

  private showSettings(): void {
    const { session } = this;
    const { original, side } = session;
    if (!original) return;
    const current = side.info ?? original;
    const swept = session.address.parameter;
    const parameters = current.parameters.map((parameter) =>
      parameter.name === swept || parameter.expression
        ? { ...parameter, value: session.valueOf(side, parameter.name) }
        : parameter,
    );
    this.settings.show({
      original,
      current: { ...current, parameters },
      assignments: side.choice.assignments,
      swept,
      units: session.address.units,
      side: side.name,
      comparing: session.address.b !== undefined,
      computation: session.address.computation,
      fitted: session.fit?.unknowns ?? [],
      trouble: session.inWords(side.trouble),
    });
  }
}
