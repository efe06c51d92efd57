// The page: what the reader does goes to the engine, what the engine finds goes to the views.
import { Diagram } from './data/diagram';
import type { Run } from './data/run';
import { needsSpectra } from './data/quantities';
import { copyText, download, el, isTyping, releaseFields } from './dom';
import type { Engine, Setting, StationInfo } from './engine/protocol';
import type { Range } from './figure/chart';
import { setDark, theme } from './figure/figure';
import { History } from './model/history';
import { caseEdits, commandOf } from './model/keep';
import { machinesOf, scalesOf, shortName, type Machine } from './model/machine';
import { firstValue, plannedRange, sweptParameter, valueOf } from './model/original';
import type { Plan } from './model/recompute';
import { assignmentTexts, readAddress, writeAddress, type Address, type Computation } from './model/setting';
import { SideModel, troubleOf } from './model/side';
import { howOf, Sights, type Sight } from './model/sights';
import { parameterMeasure, readable, shown, unitsFor, written, type Scales, type Units } from './model/units';
import { Watch } from './model/watch';
import { Help } from './view/help';
import { MapCard } from './view/map_card';
import { Pane, type PaneListener, type SideName } from './view/pane';
import { fileName } from './view/panel';
import { SettingsCard } from './view/settings_card';
import { Topbar } from './view/topbar';

/// "dop853 (by auto)", where the case leaves the choice.
function methodText(how: { readonly method: string; readonly chosen?: boolean }): string {
  return how.chosen ? `${how.method} (by auto)` : how.method;
}

export class App {
  readonly root = el('div', { class: 'app' });
  private readonly machines: Machine[];
  private machine: Machine;
  private address: Address;
  private readonly sides: Readonly<Record<SideName, SideModel>>;
  private readonly panes: Readonly<Record<SideName, Pane>>;
  private active: SideName = 'a';
  private originals = new Map<string, NonNullable<SideModel['info']>>();
  private readonly sights: Sights;
  private watches: Partial<Record<SideName, Watch>> = {};
  private hidden: ReadonlySet<number> = new Set();
  private readonly topbar: Topbar;
  private readonly card: MapCard;
  private readonly settings: SettingsCard;
  private readonly help = new Help();
  private readonly footer = el('p');
  private readonly banner = el('p', { class: 'trouble banner', role: 'alert' });
  /// The units are still to be those that suit the machine.
  private unitsAwaited = false;
  private refineTimer = 0;
  private dirty = new Set<'all' | SideName | 'grow'>();
  private readonly history = new History(
    () => writeAddress(this.currentAddress()),
    (hash) => this.restore(hash),
  );

  constructor(
    runs: readonly Run[],
    private engine: Engine | undefined,
    /// What is missing, "" when nothing is.
    private missing: string,
  ) {
    this.machines = machinesOf(runs, engine !== undefined);
    this.address = readAddress(location.hash, unitsFor(1));
    this.machine = this.machines.find(({ name }) => name === this.address.run) ?? this.machines[0]!;
    this.readUnits();
    const side = (name: SideName) => new SideModel(name, engine, { changed: () => this.later(name) });
    this.sides = { a: side('a'), b: side('b') };
    this.sights = new Sights(engine, {
      changed: () => this.later('all'),
      grown: () => this.later('grow'),
      progress: (now) => this.card.progress(now),
    });
    const pane = (name: SideName) => new Pane(name, this.paneListener());
    this.panes = { a: pane('a'), b: pane('b') };
    this.topbar = new Topbar({
      machine: (name) => this.choose(name),
      units: (units) => this.setUnits(units),
      compare: () => this.compare(),
      theme: () => this.toggleTheme(),
      help: () => this.openHelp(),
    });
    this.card = new MapCard({
      cursor: (value, settled) => this.cursor(this.active, value, settled),
      brushed: (range) => this.brushed(range),
      viewed: (range) => {
        this.sights.view(range, this.whole);
        this.refineSoon();
      },
      back: () => this.sights.back(),
      quantity: (id) => this.change({ quantity: id }),
      station: (index) => this.change({ station: this.stations[index]?.name ?? '' }),
      parameter: (name) => void this.setParameter(name),
      hidden: (classes) => {
        this.hidden = classes;
        this.later('all');
      },
      reset: () => this.sights.reset(this.whole),
      recompute: () => void this.recompute(this.sight.range),
      cancel: () => this.sights.stop(),
    });
    this.settings = new SettingsCard({
      assigned: (name, text, settled) => this.assign(name, text, settled),
      refused: (sentence) => this.side.refuse(sentence),
      computation: (changed) => this.setComputation(changed),
      resetAll: () => this.resetParameters(),
      download: () => void this.saveCase(),
      copyCommand: () => void this.copyCommand(),
      copyLink: () => void this.copyLink(),
    });
    this.root.append(
      this.topbar.root,
      this.banner,
      el(
        'main',
        {},
        this.card.root,
        this.settings.root,
        el('div', { class: 'panes' }, this.panes.a.root, this.panes.b.root),
      ),
      el('footer', {}, this.footer),
      this.help.root,
    );
  }

  /// Nothing can be computed after all.
  lose(why: string): void {
    this.sights.stop();
    for (const name of ['a', 'b'] as const) this.endWatch(name);
    this.engine = undefined;
    this.missing = why;
    for (const side of Object.values(this.sides)) side.lose();
    this.sayMissing();
    this.later('all');
  }

  private sayMissing(): void {
    this.banner.textContent = this.missing;
    this.footer.textContent = this.missing
      ? ''
      : 'Computed in this page by the C core of whirl; nothing leaves your machine.';
  }

  start(): void {
    this.sayMissing();
    const dark = window.matchMedia('(prefers-color-scheme: dark)');
    const follow = () => {
      if (!document.documentElement.dataset['theme']) this.setTheme(dark.matches);
    };
    follow();
    dark.addEventListener('change', follow);
    document.addEventListener('keydown', (event) => this.key(event));
    void this.open();
  }

  // ---------------------------------------------------------------- what is shown

  private get sight(): Sight {
    return this.sights.shown!;
  }

  /// The range of the first diagram.
  private get whole(): Range {
    return this.sights.first?.diagram?.span ?? plannedRange(this.original, this.address.parameter);
  }

  private get side(): SideModel {
    return this.sides[this.active];
  }

  private get original(): SideModel['info'] {
    return this.originals.get(this.machine.name);
  }

  private get stations(): readonly StationInfo[] {
    return this.machine.run?.stations ?? this.original?.stations ?? [];
  }

  private get scales(): Scales {
    const { run } = this.machine;
    const info = this.sides.a.info ?? this.original;
    return scalesOf(info?.lengthScale ?? run?.length_scale ?? 1, info?.speed ?? run?.speed ?? 1, this.stations);
  }

  private get station(): number {
    return Math.max(
      0,
      this.stations.findIndex(({ name }) => name === this.address.station),
    );
  }

  /// SI unit of the parameter along the diagram.
  private get unit(): string {
    const { parameter } = this.address;
    return (
      this.original?.parameters.find(({ name }) => name === parameter)?.unit ??
      this.machine.run?.parameters.find(({ name }) => name === parameter)?.unit ??
      '1'
    );
  }

  private get storedDiagram(): Diagram | undefined {
    const table = this.machine.run?.tables[0];
    return table?.parameter && table.parameter === this.address.parameter
      ? Diagram.stored(table, this.machine.run!.length_scale)
      : undefined;
  }

  // ---------------------------------------------------------------- a machine is opened

  private async open(): Promise<void> {
    for (const name of ['a', 'b'] as const) {
      this.endWatch(name);
      this.sides[name].forget();
    }
    this.sights.open();
    this.sides.a.choice = this.address.a;
    if (this.address.b) this.sides.b.choice = this.address.b;
    const { machine } = this;
    // What is stored is there at once; the engine takes a moment to wake.
    const stored = machine.run?.tables[0]?.parameter;
    const early =
      stored !== undefined && stored !== '' && (this.address.parameter === '' || this.address.parameter === stored);
    if (early) this.openParameter();
    if (this.engine && !this.original) {
      const outcome = await this.engine.describe(
        { text: machine.text, name: machine.caseName },
        { lane: 'original', priority: 0 },
      );
      if (outcome.ok) this.originals.set(machine.name, outcome.value);
      else if (outcome.why !== 'stale' && this.engine) this.sides.a.trouble = troubleOf(outcome);
      if (machine !== this.machine) return;
    }
    if (this.unitsAwaited && this.original) this.suitUnits(this.original.lengthScale);
    if (!early) this.openParameter();
    this.chooseValue();
    this.later('all');
    await this.refreshSides();
    if (!this.sight.diagram) void this.recompute(this.sight.range, true);
    else this.refineSoon(); // the address may name a part of it
  }

  /// The first sight: the stored diagram, or an empty one over the range of the sweep.
  private openParameter(): void {
    const { run } = this.machine;
    const swept = sweptParameter(this.original, run?.tables[0]?.parameter);
    const known =
      this.original?.parameters.some(({ name }) => name === this.address.parameter) || this.address.parameter === swept;
    if (!known) this.address.parameter = swept;
    const diagram = this.storedDiagram;
    const range = this.address.range ?? diagram?.span ?? plannedRange(this.original, this.address.parameter);
    this.sights.open({ diagram, range, of: '', text: diagram ? this.storedText(diagram) : '', how: howOf({}) });
  }

  private chooseValue(): void {
    const { a } = this.sides;
    if (!Number.isFinite(a.choice.value)) a.choice = { ...a.choice, value: this.firstValue };
  }

  private get firstValue(): number {
    return firstValue(this.original, this.address.parameter, this.whole);
  }

  private storedText(diagram: Diagram): string {
    const table = this.machine.run!.tables[0]!;
    const part =
      table.count < table.points
        ? `every ${Math.round(table.points / table.count)}th of ${table.points} points`
        : `${diagram.count} points`;
    const done = diagram.known < diagram.count ? `, ${diagram.known} of them computed` : '';
    return (
      `Stored run: ${part}${done}, ${table.transient} + ${table.record} revolutions by ` +
      `${methodText(table)} of ${table.steps_per_revolution} steps.`
    );
  }

  private choose(name: string): void {
    const machine = this.machines.find((each) => each.name === name);
    if (!machine || machine === this.machine) return;
    this.sights.stop();
    this.machine = machine;
    const { units } = this.address;
    this.address = { ...readAddress('', units), run: name };
    this.suitUnits(machine.run?.length_scale);
    this.active = 'a';
    void this.open();
  }

  /// Goes to an address: all anew where it is of another machine or parameter, else what differs.
  private restore(hash: string): void {
    const address = readAddress(hash, this.address.units);
    const machine = this.machines.find(({ name }) => name === address.run) ?? this.machine;
    releaseFields();
    const anew = machine !== this.machine || (address.parameter !== '' && address.parameter !== this.address.parameter);
    this.address = { ...address, parameter: address.parameter || this.address.parameter };
    this.active = address.b ? this.active : 'a';
    for (const name of ['a', 'b'] as const) this.endWatch(name);
    if (anew) {
      this.sights.stop();
      this.machine = machine;
      this.address.parameter = address.parameter;
      this.readUnits();
      void this.open();
      return;
    }
    const { a, b } = this.sides;
    a.choice = address.a;
    this.chooseValue();
    if (address.b) b.choice = address.b;
    else b.forget();
    this.sights.restore(address.range ?? this.whole, this.whole);
    this.refineSoon();
    void this.refreshSides();
    this.later('all');
  }

  /// An address that names no units leaves them to the machine.
  private readUnits(): void {
    this.unitsAwaited = false;
    if (!location.hash.includes('units=')) this.suitUnits(this.machine.run?.length_scale);
  }

  /// Units that suit a length scale [m]; of a machine whose scale is not known they are chosen when it is.
  private suitUnits(lengthScale: number | undefined): void {
    this.unitsAwaited = lengthScale === undefined;
    if (lengthScale !== undefined) this.address.units = unitsFor(lengthScale, this.address.units);
  }

  // ---------------------------------------------------------------- settings

  private settingOf(side: SideModel): Setting {
    const { method, steps, transient, record } = this.address.computation;
    const batch = this.original?.batches[0];
    const integrate = { ...(method ? { method } : {}), ...(steps ? { stepsPerRevolution: steps } : {}) };
    const length = { ...(transient !== undefined ? { transient } : {}), ...(record !== undefined ? { record } : {}) };
    const longer = record !== undefined && batch !== undefined && batch.record.watch > 0 ? { watch: 0 } : {};
    return {
      text: this.machine.text,
      name: this.machine.caseName,
      assignments: assignmentTexts(side.choice.assignments),
      integrate,
      record: { ...length, ...longer },
    };
  }

  private async refreshSides(): Promise<void> {
    await Promise.all(this.shownSides().map((name) => this.refreshSide(this.sides[name], true)));
  }

  private async refreshSide(side: SideModel, settled: boolean): Promise<void> {
    const setting = this.settingOf(side);
    const good = await side.describe(setting);
    this.later('all');
    if (good) this.want(side, settled);
  }

  private want(side: SideModel, settled: boolean): void {
    const { parameter, units } = this.address;
    const { factor, unit } = parameterMeasure(this.unit, units);
    const value = written(side.choice.value * factor, 12);
    side.want(this.settingOf(side), parameter, settled, `${parameter}=${value}${unit ? ` ${unit}` : ''}`);
  }

  /// What is still shown of a setting that cannot be computed.
  private outdatedText(side: SideModel): string {
    const { parameter, units } = this.address;
    if (!side.outdated || !side.result || !side.resultOf) return '';
    const { factor, unit } = parameterMeasure(this.unit, units);
    const { value, assignments } = side.resultOf;
    const parts = [
      ...(parameter && Number.isFinite(value) ? [`${parameter} = ${shown(value * factor, 6)} ${unit}`.trim()] : []),
      ...assignmentTexts(assignments),
    ];
    return `Below: the last setting that could be computed${parts.length ? `, ${parts.join('; ')}` : ''}.`;
  }

  private shownSides(): SideName[] {
    return this.address.b ? ['a', 'b'] : ['a'];
  }

  private cursor(name: SideName, value: number, settled: boolean): void {
    const side = this.sides[name];
    side.choice = { ...side.choice, value };
    this.endWatch(name);
    this.want(side, settled);
    this.later(name);
  }

  private assign(name: string, text: string | undefined, settled: boolean): void {
    const side = this.side;
    if (name === this.address.parameter) {
      const value = text === undefined ? this.firstValue : valueOf(this.original, name, text);
      if (Number.isFinite(value)) this.cursor(this.active, value, settled);
      return;
    }
    const assignments = new Map(side.choice.assignments);
    if (text === undefined) assignments.delete(name);
    else assignments.set(name, text);
    side.choice = { ...side.choice, assignments };
    this.endWatch(this.active);
    void this.refreshSide(side, settled);
  }

  private setComputation(computation: Computation): void {
    this.address.computation = computation;
    void this.refreshSides();
    this.later('all');
  }

  private resetParameters(): void {
    this.side.choice = { ...this.side.choice, assignments: new Map() };
    this.address.computation = {};
    this.endWatch(this.active);
    void this.refreshSide(this.side, true);
  }

  private setUnits(units: Units): void {
    this.unitsAwaited = false;
    this.address.units = units;
    this.later('all');
  }

  private change(part: Partial<Address>): void {
    Object.assign(this.address, part);
    this.later('all');
  }

  private async setParameter(name: string): Promise<void> {
    this.sights.stop();
    this.address.parameter = name;
    this.address.range = undefined;
    for (const side of Object.values(this.sides)) {
      const assignments = new Map(side.choice.assignments);
      assignments.delete(name);
      side.choice = { assignments, value: NaN };
      const own = side.info?.parameters.find((parameter) => parameter.name === name)?.value;
      if (own !== undefined) side.choice = { assignments, value: own };
    }
    this.openParameter();
    this.chooseValue();
    await this.refreshSides();
    if (!this.sight.diagram) void this.recompute(this.sight.range, true);
  }

  private compare(): void {
    if (this.address.b) {
      this.closeB();
      return;
    }
    this.address.b = this.sides.b.choice = { ...this.sides.a.choice };
    this.active = 'b';
    this.later('all');
    void this.refreshSide(this.sides.b, true);
  }

  private closeB(): void {
    this.endWatch('b');
    this.sides.b.forget();
    this.address.b = undefined;
    this.active = 'a';
    this.later('all');
  }

  // ---------------------------------------------------------------- the diagram

  private brushed(range: Range): void {
    if (this.engine) void this.recompute(range);
    else this.sights.enlarge(range);
  }

  /// Computes the diagram over a range with the active setting.
  private async recompute(range: Range, first = false): Promise<void> {
    if (!this.address.parameter || !this.engine) return;
    const of = assignmentTexts(this.side.choice.assignments).join('; ');
    this.report(await this.sights.compute(this.planOf(range), this.card.quality, of, first));
    this.refineSoon(); // the view may have moved meanwhile
  }

  private planOf([low, high]: Range): Plan {
    return {
      setting: this.settingOf(this.side),
      parameter: this.address.parameter,
      low,
      high,
      points: this.card.points,
      batch: this.original?.batches[0],
      spectra: needsSpectra(this.address.quantity),
    };
  }

  /// Computes finer points in the view once it has come to rest.
  private refineSoon(): void {
    clearTimeout(this.refineTimer);
    this.refineTimer = window.setTimeout(async () => {
      const { original, sights } = this;
      if (original && sights.shown)
        this.report(await sights.refine(this.planOf(sights.shown.range), this.card.quality));
    }, 400);
  }

  private report(trouble: string): void {
    if (!trouble) return;
    this.side.trouble = trouble;
    this.later('all');
  }

  // ---------------------------------------------------------------- watching a motion settle

  private paneListener(): PaneListener {
    return {
      value: (name, value) => this.cursor(name, value, true),
      refused: (name, sentence) => this.sides[name].refuse(sentence),
      activated: (name) => {
        if (this.active === name || (name === 'b' && !this.address.b)) return;
        this.active = name;
        this.later('all');
      },
      watch: (name, on, speed) => this.watch(name, on, speed),
      close: () => this.closeB(),
    };
  }

  private watch(name: SideName, on: boolean, speed: number): void {
    const running = this.watches[name];
    if (running && on) {
      running.revolutionsPerSecond = speed;
      return;
    }
    this.endWatch(name);
    if (!on || !this.engine) return;
    const side = this.sides[name];
    const pane = this.panes[name];
    const { parameter } = this.address;
    const { value } = side.choice;
    pane.setPlaying(true);
    this.watches[name] = new Watch(
      this.engine,
      { setting: this.settingOf(side), ...(parameter && Number.isFinite(value) ? { parameter, value } : {}) },
      this.station,
      this.original?.contacts ?? [],
      this.stations[this.station]?.name ?? '',
      `watch-${name}`,
      speed,
      (trail) => pane.watch(trail),
      (message) => {
        side.trouble = message;
        this.endWatch(name);
        this.later(name);
      },
    );
  }

  private endWatch(name: SideName): void {
    this.watches[name]?.stop();
    delete this.watches[name];
    this.panes[name].setPlaying(false);
  }

  // ---------------------------------------------------------------- what can be taken away

  private async rewritten(): Promise<string | undefined> {
    const { engine, original, side } = this;
    if (!engine || !original) return undefined;
    const edits = caseEdits(original, this.address, side.choice, this.sight.range, this.whole);
    const setting = {
      text: this.machine.text,
      name: this.machine.caseName,
      assignments: assignmentTexts(side.choice.assignments),
    };
    const outcome = await engine.rewrite(setting, edits, { lane: 'rewrite', priority: 0 });
    if (outcome.ok) return outcome.value;
    if (outcome.why !== 'stale') this.settings.say(troubleOf(outcome));
    return undefined;
  }

  private get caseName(): string {
    return `${fileName(shortName(this.machine), 'explored')}.yaml`;
  }

  private async saveCase(): Promise<void> {
    const text = await this.rewritten();
    if (text === undefined) return;
    download(this.caseName, 'application/yaml', text);
    this.settings.say(`${this.caseName}: whirl run ${this.caseName}`);
  }

  private async copyCommand(): Promise<void> {
    const text = await this.rewritten();
    if (text === undefined) return;
    this.said(
      await copyText(commandOf(text, fileName(shortName(this.machine), 'explored'))),
      'The command is on the clipboard.',
    );
  }

  private async copyLink(): Promise<void> {
    this.history.write();
    this.said(await copyText(location.href), 'The address is on the clipboard.');
  }

  private said(done: boolean, text: string): void {
    this.settings.say(done ? text : 'The browser does not let this page use the clipboard.');
  }

  // ---------------------------------------------------------------- address, theme, keys

  private currentAddress(): Address {
    const view = this.sights.shown?.range;
    const { whole } = this;
    const zoomed = view && (view[0] !== whole[0] || view[1] !== whole[1]);
    return {
      ...this.address,
      run: this.machine.name,
      a: this.sides.a.choice,
      b: this.address.b ? this.sides.b.choice : undefined,
      range: zoomed ? view : undefined,
      station: this.stations[this.station]?.name ?? '',
    };
  }

  private setTheme(dark: boolean): void {
    setDark(dark);
    document.documentElement.classList.toggle('dark', dark);
    theme().classes.forEach((colour, kind) => document.documentElement.style.setProperty(`--class-${kind}`, colour));
    for (const pane of Object.values(this.panes)) pane.redraw();
    this.card.map.refresh();
    if (this.sights.shown) this.later('all');
  }

  private toggleTheme(): void {
    const dark = !document.documentElement.classList.contains('dark');
    document.documentElement.dataset['theme'] = dark ? 'dark' : 'light';
    this.setTheme(dark);
  }

  private openHelp(): void {
    this.help.open(this.machine.run?.facts ?? []);
  }

  private key(event: KeyboardEvent): void {
    const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (event.key === '?' && !typing) this.openHelp();
    // A field that is being typed into has an undo of its own.
    const command = (event.ctrlKey || event.metaKey) && !event.altKey && !isTyping();
    const key = event.key.toLowerCase();
    if (command && (key === 'z' || key === 'y')) {
      event.preventDefault();
      if (key === 'y' || event.shiftKey) this.history.redo();
      else this.history.undo();
    }
    if (event.key === 'Escape') {
      this.sights.stop();
      for (const name of ['a', 'b'] as const) this.endWatch(name);
    }
  }

  // ---------------------------------------------------------------- drawing, once a frame

  private later(what: 'all' | SideName | 'grow'): void {
    if (this.dirty.size === 0) requestAnimationFrame(() => this.draw());
    this.dirty.add(what);
  }

  private draw(): void {
    const dirty = this.dirty;
    this.dirty = new Set();
    if (!this.sights.shown) return;
    if (dirty.has('all')) this.showAll();
    else if (dirty.has('grow')) this.card.grow();
    for (const name of this.shownSides()) if (dirty.has('all') || dirty.has(name)) this.showPane(name);
    this.card.map.setCursors(this.sides.a.choice.value, this.address.b ? this.sides.b.choice.value : NaN);
    this.showSettings();
    this.history.soon();
  }

  private showAll(): void {
    const comparing = this.address.b !== undefined;
    this.root.classList.toggle('comparing', comparing);
    this.panes.b.root.hidden = !comparing;
    for (const name of ['a', 'b'] as const) this.panes[name].active = comparing && name === this.active;
    this.topbar.show(this.machine, this.machines, this.address.units, this.scales.symbol, comparing);
    const { sight } = this;
    const text = [sight.text, sight.note].filter((part) => part).join(' ');
    const stale = sight.of !== assignmentTexts(this.side.choice.assignments).join('; ');
    this.card.show({
      diagram: sight.diagram,
      parameter: this.address.parameter,
      unit: this.unit,
      quantity: this.address.quantity,
      station: this.station,
      stations: this.stations,
      units: this.address.units,
      scales: this.scales,
      range: sight.range,
      hidden: this.hidden,
      parameters: this.original?.parameters.map(({ name }) => name) ?? [this.address.parameter],
      depth: this.sights.behind,
      computes: this.engine !== undefined,
      status: stale
        ? `${text} The parameters have been changed since: Recompute shows the diagram of the changed machine.`
        : text,
      stale,
      name: shortName(this.machine),
    });
    this.card.progress(this.sights.progress);
  }

  private showPane(name: SideName): void {
    const side = this.sides[name];
    const { result } = side;
    const how = result
      ? `${side.preview ? 'A quick look: ' : ''}${result.record.transient} + ${result.record.record} revolutions ` +
        `by ${methodText(result.integrate)} of ${result.integrate.stepsPerRevolution} steps, ` +
        `${Math.round(result.seconds * 1000)} ms`
      : this.storedVerdict(side.choice.value);
    this.panes[name].show({
      result,
      parameter: this.address.parameter,
      unit: this.unit,
      value: side.choice.value,
      station: this.station,
      stations: this.stations,
      units: this.address.units,
      scales: this.scales,
      diagram: this.sight.diagram,
      busy: side.busy && !result ? 'computing \u2026' : '',
      trouble: side.trouble,
      how,
      outdated: this.outdatedText(side),
    });
    this.panes[name].root.classList.toggle('busy', side.busy);
  }

  /// What the diagram knows of the nearest point, where nothing can be computed.
  private storedVerdict(value: number): string {
    const { diagram } = this.sight;
    const point = diagram?.nearest(value) ?? -1;
    if (!diagram || point < 0) return '';
    const [verdict, reason] = diagram.verdicts[point]!;
    return (
      `Nearest stored point, ${this.address.parameter} = ${Number(diagram.values[point]!.toPrecision(6))}: ` +
      `${verdict}; ${readable(reason)}.`
    );
  }

  private showSettings(): void {
    const { original, side } = this;
    if (!original) return;
    const current = side.info ?? original;
    const swept = this.address.parameter;
    const { value } = side.choice;
    const parameters = current.parameters.map((parameter) =>
      parameter.name === swept && Number.isFinite(value) ? { ...parameter, value } : parameter,
    );
    this.settings.show({
      original,
      current: { ...current, parameters },
      assignments: side.choice.assignments,
      swept,
      units: this.address.units,
      side: side.name,
      comparing: this.address.b !== undefined,
      computation: this.address.computation,
      trouble: side.trouble,
    });
  }
}
