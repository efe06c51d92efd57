// The application: passes the user's actions to the engine, and the engine's results to the views.
import type { Run } from './data/run';
import { needsSpectra } from './data/quantities';
import { FIELD } from './data/fields';
import { isTyping, releaseFields } from './dom';
import type { ChosenColumn, Engine } from './engine/protocol';
import type { Range } from './figure/chart';
import { anyFollows } from './model/derived';
import { History } from './model/history';
import type { Plan } from './model/recompute';
import type { NamedFile } from './model/measured';
import { Session, type Change, type SideName } from './model/session';
import { assignmentTexts, readAddress, writeAddress, type Address, type Computation } from './model/setting';
import type { SideModel } from './model/side';
import { parameterMeasure, written, type Units } from './model/units';
import { Watches } from './model/watches';
import type { MapCardListener } from './view/map_card';
import { Page } from './view/page';
import type { Spot } from './view/parameter_map';
import type { PaneListener } from './view/pane';
import type { ParameterMapCardListener } from './view/parameter_map_card';
import type { RestListener } from './view/rest';
import type { RunListener } from './view/run';
import type { SettingsListener } from './view/settings_card';
import { Takeaway } from './view/takeaway';
import type { TopbarListener } from './view/topbar';

export class App {
  private readonly session: Session;
  private readonly page: Page;
  private readonly watches: Watches;
  private readonly takeaway: Takeaway;
  private refineTimer = 0;
  private changes = new Set<Change>();
  private readonly history = new History(
    () => writeAddress(this.session.currentAddress()),
    (hash) => this.restore(hash),
  );

  constructor(
    runs: readonly Run[],
    engine: Engine | undefined,
    /// Name of a missing part of the page, or "".
    private missing: string,
  ) {
    this.session = new Session(runs, engine, {
      changed: (what) => this.later(what),
      progress: (now) => this.page.card.progress(now),
    });
    const { session } = this;
    this.page = new Page(session, {
      rest: this.restListener(),
      run: this.runListener(),
      topbar: this.topbarListener(),
      card: this.cardListener(),
      map: this.mapListener(),
      settings: this.settingsListener(),
      pane: this.paneListener(),
      measured: {
        files: (files) => void this.measure(files),
        removed: (name) => session.measured.remove(session.machine.name, name),
        forgiven: () => session.measured.forgive(),
        asked: (name) => void session.measured.ask(session.machine.name, name),
        chosen: (name, columns) => void this.chooseMeasured(name, columns),
        dismissed: (name) => session.measured.dismiss(name),
      },
      document: { part: (id) => this.toPart(id), station: (name) => this.change({ station: name }) },
    });
    this.watches = new Watches(this.session, {
      playing: (name, on) => this.page.panes[name].setPlaying(on),
      trail: (name, trail) => this.page.panes[name].watch(trail),
      changed: (name) => this.later(name),
    });
    this.takeaway = new Takeaway(this.session, {
      say: (text) => this.page.say(text),
      settle: () => this.history.write(),
    });
  }

  get root(): HTMLElement {
    return this.page.root;
  }

  /// Handles the loss of the engine: from now on nothing can be computed.
  lose(why: string): void {
    this.watches.endAll();
    this.session.lose();
    this.missing = why;
    this.page.sayMissing(why);
    this.later('all');
  }

  start(): void {
    this.page.sayMissing(this.missing);
    const dark = window.matchMedia('(prefers-color-scheme: dark)');
    const follow = () => {
      if (!document.documentElement.dataset['theme']) this.setTheme(dark.matches);
    };
    follow();
    dark.addEventListener('change', follow);
    document.addEventListener('keydown', (event) => this.key(event));
    this.receiveFiles();
    void this.open();
  }

  // ---------------------------------------------------------------- actions of the user

  private topbarListener(): TopbarListener {
    return {
      machine: (name) => this.choose(name),
      units: (units) => this.setUnits(units),
      compare: () => this.compare(),
      measured: () => this.page.measured.choose(),
      theme: () => this.toggleTheme(),
      help: () => this.page.openHelp(),
    };
  }

  private cardListener(): MapCardListener {
    const { session } = this;
    return {
      cursor: (value, settled) => this.cursor(session.active, value, settled),
      orbit: (point) => this.orbit(session.active, point),
      brushed: (range) => this.brushed(range),
      viewed: (range) => {
        session.sights.view(range, session.whole);
        this.refineSoon();
      },
      back: () => session.sights.back(),
      quantity: (id) => this.change({ quantity: id }),
      station: (index) => this.change({ station: session.stations[index]?.name ?? '' }),
      parameter: (name) => void this.setParameter(name),
      hidden: (classes) => {
        session.hidden = classes;
        this.later('all');
      },
      reset: () => session.sights.reset(session.whole),
      recompute: () => void this.recompute(session.sight.range),
      cancel: () => session.sights.stop(),
    };
  }

  private mapListener(): ParameterMapCardListener {
    const { station, parameter } = this.cardListener();
    return {
      ...{ station, parameter },
      cell: (spot, settled) => this.cell(spot, settled),
      plane: (index) => this.toPlane(index),
      refine: (part) => this.session.refineMap(part),
      mapQuantity: (id) => this.change({ mapQuantity: id }),
      mapLines: (shown) => this.change({ mapLines: shown }),
    };
  }

  private restListener(): RestListener {
    const { session } = this;
    const { cursor, brushed, viewed, back, station, reset } = this.cardListener();
    return {
      ...{ cursor, brushed, viewed, back, station, reset },
      chosen: (part) => this.change({ rest: { ...session.address.rest, ...part } }),
    };
  }

  private runListener(): RunListener {
    const { session } = this;
    return {
      settings: this.settingsListener(),
      station: (index) => this.change({ station: session.stations[index]?.name ?? '' }),
      time: (seconds) => {
        session.address.time = Math.max(0, seconds);
        this.later('run');
      },
      run: (value) => {
        session.model.forget();
        this.cursor('a', value, false);
      },
      compute: () => session.wantRun(session.side, true),
      stop: () => session.model.stop(),
    };
  }

  private settingsListener(): SettingsListener {
    return {
      assigned: (name, text, settled, value) => this.assign(name, text, settled, value),
      refused: (sentence) => this.session.side.refuse(sentence),
      computation: (changed) => this.setComputation(changed),
      resetAll: () => this.resetParameters(),
      download: () => void this.takeaway.saveCase(),
      copyCommand: () => void this.takeaway.copyCommand(),
      copyLink: () => void this.takeaway.copyLink(),
    };
  }

  private paneListener(): PaneListener {
    const { session } = this;
    return {
      value: (name, value) => this.cursor(name, value, true),
      spoken: (name, text) => void this.speak(name, text),
      refused: (name, sentence) => session.sides[name].refuse(sentence),
      activated: (name) => {
        if (session.active === name || (name === 'b' && !session.address.b)) return;
        session.active = name;
        this.later('all');
      },
      watch: (name, on, speed) => this.watches.set(name, on, speed),
      close: () => this.closeB(),
    };
  }

  // ---------------------------------------------------------------- a machine is opened

  private async open(): Promise<void> {
    const { session } = this;
    this.watches.endAll();
    for (const side of Object.values(session.sides)) side.forget();
    session.sights.open();
    session.model.forget();
    session.refineMap(undefined);
    session.sides.a.choice = session.address.a;
    if (session.address.b) session.sides.b.choice = session.address.b;
    const { machine, text, caseKey } = session;
    session.openFits();
    // Show stored data at once; the engine takes a moment to start.
    const stored = session.run?.tables[0]?.parameter;
    const early =
      stored !== undefined &&
      stored !== '' &&
      (session.address.parameter === '' ||
        session.address.parameter === stored ||
        session.map?.axis(session.address.parameter) !== undefined);
    if (early) session.openParameter();
    session.openStored();
    if (!session.moves) session.address.b = undefined;
    if (session.engine && !session.original && session.computes) {
      const outcome = await session.engine.describe(
        { text, name: machine.caseName },
        { lane: 'original', priority: 0 },
      );
      if (outcome.ok) session.originals.set(caseKey, outcome.value);
      else if (outcome.why !== 'stale' && session.engine) session.sides.a.trouble = outcome.message;
      if (machine !== session.machine || caseKey !== session.caseKey) return;
    }
    if (session.unitsAwaited && session.original) session.suitUnits(session.original.lengthScale);
    if (!early) session.openParameter();
    session.checkOrbits();
    session.chooseValue();
    this.later('all');
    await this.refreshSides();
    if (!session.moves) return;
    if (!session.sight.diagram) void this.recompute(session.sight.range, true);
    else this.refineSoon(); // the address may name a part of the range
  }

  private choose(name: string): void {
    const { session } = this;
    const machine = session.machines.find((each) => each.name === name);
    if (!machine || machine === session.machine) return;
    session.sights.stop();
    session.machine = machine;
    const { units } = session.address;
    session.address = { ...readAddress('', units), run: name };
    session.suitUnits(machine.run?.length_scale);
    session.active = 'a';
    void this.open();
  }

  /// Shows another part of the same result. The view is reset, except station, units and probes.
  private toPart(id: string): void {
    const { session } = this;
    if (session.part?.id === id) return;
    session.sights.stop();
    const { units, run, station, rest } = session.address;
    session.address = { ...readAddress('', units), run, station, rest: { ...rest, mode: 0 }, part: id };
    session.active = 'a';
    void this.open();
  }

  /// Restores the state of an address: all of it if the machine or the parameter differs, else only the differences.
  private restore(hash: string): void {
    const { session } = this;
    const address = readAddress(hash, session.address.units);
    const machine = session.machines.find(({ name }) => name === address.run) ?? session.machine;
    releaseFields();
    const anew =
      machine !== session.machine ||
      address.part !== session.address.part ||
      (address.parameter !== '' && address.parameter !== session.address.parameter);
    session.address = { ...address, parameter: address.parameter || session.address.parameter };
    session.active = address.b ? session.active : 'a';
    this.watches.endAll();
    if (anew) {
      session.sights.stop();
      session.machine = machine;
      session.address.parameter = address.parameter;
      session.readUnits();
      void this.open();
      return;
    }
    const { a, b } = session.sides;
    a.choice = address.a;
    session.chooseValue();
    if (address.b) b.choice = address.b;
    else b.forget();
    session.checkOrbits();
    session.sights.restore(address.range ?? session.whole, session.whole);
    this.refineSoon();
    void this.refreshSides();
    this.later('all');
  }

  // ---------------------------------------------------------------- settings

  private async refreshSides(): Promise<void> {
    await Promise.all(this.session.shownSides().map((name) => this.refreshSide(this.session.sides[name], true)));
  }

  private async refreshSide(side: SideModel, settled: boolean): Promise<void> {
    if (!this.session.computes) return;
    const setting = this.session.settingOf(side);
    const good = await side.describe(setting);
    this.later('all');
    if (good) this.want(side, settled);
  }

  private want(side: SideModel, settled: boolean): void {
    const { session } = this;
    if (session.runsUp) this.wantRun(side, settled);
    if (!session.moves) return;
    const { parameter, units } = session.address;
    const { factor, unit } = parameterMeasure(session.unit, units);
    const value = written(side.choice.value * factor, 12);
    const setting = session.settingOf(side);
    const spoken = `${parameter}=${value}${unit ? ` ${unit}` : ''}`;
    const orbit = session.orbitOf(side.choice);
    if (orbit) side.wantOrbit(session.orbitRequest(orbit));
    else side.want(setting, parameter, settled, spoken);
    if (settled && anyFollows(side.info?.parameters ?? [], parameter)) void side.follow(setting, spoken);
  }

  /// Computes the run of a changed setting; runs of the case's own settings are stored.
  private wantRun(side: SideModel, settled: boolean): void {
    const { session } = this;
    const { assignments, value } = side.choice;
    const stored = !session.atRuns || session.atRuns.values.includes(value);
    if (assignments.size > 0 || !stored || session.model.run) session.wantRun(side, settled);
  }

  private cursor(name: SideName, value: number, settled: boolean): void {
    const side = this.session.sides[name];
    side.choice = { assignments: side.choice.assignments, value };
    this.watches.end(name);
    this.want(side, settled);
    this.later(name);
  }

  /// Shows the motion at a cell of the map.
  private cell([x, y]: Spot, settled: boolean): void {
    const { session } = this;
    const { map, side } = session;
    if (!map) return;
    session.place(side, [
      [map.x.parameter, x],
      [map.y.parameter, y],
    ]);
    session.enterPlane(side);
    this.watches.end(session.active);
    void this.refreshSide(side, settled);
    this.later(session.active);
  }

  /// Moves the active side to another plane of the map.
  private toPlane(index: number): void {
    const { session } = this;
    const { planes, side } = session;
    if (!planes?.parameter) return;
    session.place(side, [[planes.parameter, planes.values[index]!]]);
    this.watches.end(session.active);
    this.later('all');
    void this.refreshSide(side, true);
  }

  /// Shows the orbit of a branch point in place of a motion.
  private orbit(name: SideName, point: number): void {
    const { session } = this;
    const side = session.sides[name];
    const { assignments } = side.choice;
    const orbit = session.orbitOf({ ...side.choice, orbit: point });
    if (!orbit || side.choice.orbit === point) return;
    side.choice = { assignments, value: orbit.value, orbit: point };
    this.watches.end(name);
    this.want(side, true);
    this.later(name);
  }

  private assign(name: string, text: string | undefined, settled: boolean, value: number | undefined): void {
    const { session } = this;
    const side = session.side;
    if (name === session.address.parameter) {
      if (text !== undefined && value === undefined) void this.speak(session.active, text);
      else this.cursor(session.active, value ?? session.firstValue, settled);
      return;
    }
    const assignments = new Map(side.choice.assignments);
    if (value === undefined) releaseFields();
    if (text === undefined) assignments.delete(name);
    else assignments.set(name, text);
    // Branches belong to the machine without changes to its case.
    side.choice = { assignments, value: side.choice.value };
    this.watches.end(session.active);
    void this.refreshSide(side, settled);
  }

  /// Sets the value along the diagram from a text with a unit that only the engine can read.
  private async speak(name: SideName, text: string): Promise<void> {
    const value = await this.session.spokenValue(name, text);
    // Show the typed value in the page's unit.
    if (typeof value === 'number') releaseFields();
    if (typeof value === 'number') this.cursor(name, value, true);
    else if (value) this.session.sides[name].refuse(value);
  }

  private setComputation(computation: Computation): void {
    this.session.address.computation = computation;
    void this.refreshSides();
    this.later('all');
  }

  private resetParameters(): void {
    const { session } = this;
    session.side.choice = { ...session.side.choice, assignments: new Map() };
    session.address.computation = {};
    this.watches.end(session.active);
    void this.refreshSide(session.side, true);
  }

  private setUnits(units: Units): void {
    this.session.unitsAwaited = false;
    this.session.address.units = units;
    this.later('all');
  }

  private change(part: Partial<Address>): void {
    Object.assign(this.session.address, part);
    this.later('all');
  }

  private async setParameter(name: string): Promise<void> {
    const { session } = this;
    session.sights.stop();
    const before = session.address.parameter;
    // Keep both values in a map.
    const kept = Object.values(session.sides).map((side) =>
      session.map?.axis(before) ? session.valueOf(side, before) : NaN,
    );
    const own = Object.values(session.sides).map((side) => session.valueOf(side, name));
    session.address.parameter = name;
    session.address.range = undefined;
    Object.values(session.sides).forEach((side, i) => {
      const assignments = new Map(side.choice.assignments);
      assignments.delete(name);
      side.choice = { assignments, value: own[i]! };
      if (Number.isFinite(kept[i])) session.place(side, [[before, kept[i]!]]);
    });
    session.openParameter();
    session.chooseValue();
    await this.refreshSides();
    if (!session.sight.diagram) void this.recompute(session.sight.range, true);
  }

  private compare(): void {
    const { session } = this;
    if (session.address.b) {
      this.closeB();
      return;
    }
    session.address.b = session.sides.b.choice = { ...session.sides.a.choice };
    session.active = 'b';
    this.later('all');
    void this.refreshSide(session.sides.b, true);
  }

  private closeB(): void {
    const { session } = this;
    this.watches.end('b');
    session.sides.b.forget();
    session.address.b = undefined;
    session.active = 'a';
    this.later('all');
  }

  // ---------------------------------------------------------------- the diagram

  private brushed(range: Range): void {
    if (this.session.engine && this.session.moves) void this.recompute(range);
    else this.session.sights.enlarge(range);
  }

  /// Computes the diagram over a range with the active setting.
  private async recompute(range: Range, first = false): Promise<void> {
    const { session } = this;
    if (!session.address.parameter || !session.engine || !session.moves) return;
    const of = assignmentTexts(session.side.choice.assignments).join('; ');
    this.report(await session.sights.compute(this.planOf(range), this.page.card.quality, of, first));
    this.refineSoon(); // the view may have moved during the computation
  }

  private planOf([low, high]: Range): Plan {
    const { session } = this;
    return {
      setting: session.settingOf(session.side),
      parameter: session.address.parameter,
      low,
      high,
      points: this.page.card.points,
      batch: session.original?.batches[0],
      spectra: needsSpectra(session.address.quantity),
    };
  }

  /// Computes finer points in the view after it has stopped moving.
  private refineSoon(): void {
    clearTimeout(this.refineTimer);
    this.refineTimer = window.setTimeout(async () => {
      const { original, sights } = this.session;
      if (original && sights.shown)
        this.report(await sights.refine(this.planOf(sights.shown.range), this.page.card.quality));
    }, 400);
  }

  private report(trouble: string): void {
    if (!trouble) return;
    this.session.side.trouble = trouble;
    this.later('all');
  }

  // ---------------------------------------------------------------- measured data

  /// Takes files that are dropped onto the page.
  private receiveFiles(): void {
    const { root } = this.page;
    const { session } = this;
    // Without the engine a dropped file does what it does on any page.
    const wanted = (event: DragEvent) => session.engine !== undefined && event.dataTransfer?.types.includes('Files');
    document.addEventListener('dragover', (event) => {
      if (!wanted(event)) return;
      event.preventDefault();
      root.classList.add('dropping');
    });
    document.addEventListener('dragleave', (event) => {
      if (!event.relatedTarget) root.classList.remove('dropping');
    });
    document.addEventListener('drop', (event) => {
      root.classList.remove('dropping');
      if (!wanted(event)) return;
      event.preventDefault();
      if (session.measurable) void this.measure([...event.dataTransfer!.files]);
      else
        session.measured.refuse(
          'Measured data lie over motions, run-ups and responses to unbalance: open such a part of the result first.',
        );
    });
  }

  private async measure(files: readonly NamedFile[]): Promise<void> {
    const { session } = this;
    if (files.length === 0) return;
    await session.addMeasured(files);
    this.showMeasured();
  }

  private async chooseMeasured(name: string, columns: readonly ChosenColumn[]): Promise<void> {
    await this.session.chooseMeasured(name, columns);
    this.showMeasured();
  }

  private showMeasured(): void {
    const { session } = this;
    this.later('all');
    const { diagram, range } = session.sight;
    // A stored diagram may lack the spectra over which vectors lie.
    const { quantity, parameter } = session.address;
    const lacks = needsSpectra(quantity) && diagram && !diagram.column(FIELD.SPECTRUM_SYNCHRONOUS);
    if (session.moves && lacks && session.measuredData.some(({ kind }) => kind === 'vectors') && parameter)
      void this.recompute(range);
  }

  // ---------------------------------------------------------------- theme and keys

  private setTheme(dark: boolean): void {
    this.page.setTheme(dark);
    if (this.session.sights.shown) this.later('all');
  }

  private toggleTheme(): void {
    const dark = !document.documentElement.classList.contains('dark');
    document.documentElement.dataset['theme'] = dark ? 'dark' : 'light';
    this.setTheme(dark);
  }

  private key(event: KeyboardEvent): void {
    const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (event.key === '?' && !typing) this.page.openHelp();
    // Leave undo to the browser while the user types in a field.
    const command = (event.ctrlKey || event.metaKey) && !event.altKey && !isTyping();
    const key = event.key.toLowerCase();
    if (command && (key === 'z' || key === 'y')) {
      event.preventDefault();
      if (key === 'y' || event.shiftKey) this.history.redo();
      else this.history.undo();
    }
    if (event.key === 'Escape') {
      this.session.sights.stop();
      this.watches.endAll();
    }
  }

  // ---------------------------------------------------------------- drawing, once a frame

  private later(what: Change): void {
    if (this.changes.size === 0) requestAnimationFrame(() => this.draw());
    this.changes.add(what);
  }

  private draw(): void {
    const changes = this.changes;
    this.changes = new Set();
    if (!this.session.sights.shown) return;
    this.session.followMap();
    this.page.show(changes);
    this.history.soon();
  }
}
