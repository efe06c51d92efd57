// State of the page: the open machine, the user's settings, the visible part, and everything derived from these.
import { bandOfQuantity, type StoredBand } from '../data/bands';
import { Branches } from '../data/branches';
import { Tori } from '../data/tori';
import { partOf, partsOf, type LiveView, type Part, type StoredFit } from '../data/contents';
import { Diagram } from '../data/diagram';
import { MeasuredData, type Seen } from '../data/measured';
import { storedMotion } from '../data/opening';
import type { OrbitOfBranch } from '../data/orbit';
import { MapPlanes, type ParameterMap } from '../data/parameter_map';
import { AtRest } from '../data/rest';
import type { Run, StoredTable } from '../data/run';
import { RunUp } from '../data/runup';
import type {
  CaseInfo,
  ChosenColumn,
  Engine,
  OrbitRequest,
  Setting,
  StationInfo,
  SweepProgress,
} from '../engine/protocol';
import { introOfPart, machinesOf, scalesOf, type Machine } from './machine';
import { Measured, type NamedFile } from './measured';
import { RunModel } from './run_model';
import { cutOf, plainText, plainValue, type Cut } from './map_cut';
import { canRefine, MapRefinement, type MapPart } from './map_refinement';
import { firstValue, plannedRange, sweptParameter } from './original';
import { assignmentTexts, computationOptions, readAddress, type Address, type Side } from './setting';
import { SideModel } from './side';
import { howOf, Sights, type Sight } from './sights';
import { unitsFor, unitsOfReport, type Scales } from './units';
import { inWordsOfPage } from './words';

type Range = readonly [number, number];

export type SideName = 'a' | 'b';

/// Part to be redrawn: everything, a side, new points of the diagram or of the map, or the cursor of a run-up.
export type Change = 'all' | SideName | 'grow' | 'map' | 'run';

export interface SessionListener {
  changed(what: Change): void;
  progress(now: SweepProgress | undefined): void;
}

/// Quantities of diagrams over which measured vectors lie, with the direction of their probe in degrees.
export const VECTORS: ReadonlyMap<string, { readonly direction: number; readonly lag: boolean }> = new Map([
  ['1x', { direction: 0, lag: false }],
  ['1y', { direction: 90, lag: false }],
  ['1xlag', { direction: 0, lag: true }],
  ['1ylag', { direction: 90, lag: true }],
]);

/// "dop853 (by auto)", where the case leaves the choice.
export function methodText(how: { readonly method: string; readonly method_chosen?: boolean }): string {
  return how.method_chosen ? `${how.method} (by auto)` : how.method;
}

export class Session {
  readonly machines: Machine[];
  machine: Machine;
  address: Address;
  readonly sides: Readonly<Record<SideName, SideModel>>;
  active: SideName = 'a';
  private readonly resting = new Map<Run | undefined, AtRest | undefined>();
  private traced:
    | {
        readonly run: Run | undefined;
        readonly parameter: string;
        readonly branches: Branches | undefined;
        readonly tori: Tori | undefined;
      }
    | undefined;
  private readonly maps = new Map<Run | undefined, MapPlanes | undefined>();
  private refined: MapRefinement | undefined;
  /// Key of the map's cut in the first diagram (`sights.first`).
  private cutKey = '';
  /// Cases by their keys (caseKey).
  readonly originals = new Map<string, CaseInfo>();
  readonly sights: Sights;
  /// The run of a run-up at the setting of side A.
  readonly model: RunModel;
  /// Measured data laid over the machines.
  readonly measured: Measured;
  private storedRun: { readonly run: Run; readonly point: number; readonly up: RunUp } | undefined;
  /// Classes of regimes hidden by the user.
  hidden: ReadonlySet<number> = new Set();
  /// True until units that suit the machine are chosen.
  unitsAwaited = false;

  constructor(
    runs: readonly Run[],
    public engine: Engine | undefined,
    private readonly listener: SessionListener,
  ) {
    this.machines = machinesOf(runs, engine !== undefined);
    this.address = readAddress(location.hash, unitsFor(1));
    this.machine = this.machines.find(({ name }) => name === this.address.run) ?? this.machines[0]!;
    this.readUnits();
    const side = (name: SideName) => new SideModel(name, engine, { changed: () => listener.changed(name) });
    this.sides = { a: side('a'), b: side('b') };
    this.model = new RunModel(engine, { changed: () => listener.changed('all') });
    this.measured = new Measured(engine, { changed: () => listener.changed('all') });
    this.sights = new Sights(engine, {
      changed: () => listener.changed('all'),
      grown: () => listener.changed('grow'),
      progress: (now) => listener.progress(now),
    });
  }

  /// Handles the loss of the engine; its results stay.
  lose(): void {
    this.sights.stop();
    this.refined?.stop();
    this.model.lose();
    this.measured.lose();
    this.engine = undefined;
    for (const side of Object.values(this.sides)) side.lose();
  }

  get sight(): Sight {
    return this.sights.shown!;
  }

  /// The range of the first diagram.
  get whole(): Range {
    return this.sights.first?.diagram?.span ?? plannedRange(this.original, this.address.parameter);
  }

  /// The active side.
  get side(): SideModel {
    return this.sides[this.active];
  }

  /// Text of the case that the engine computes: that of the machine, or with the values of the visible fit.
  get text(): string {
    return this.fit?.case_text ?? this.machine.text;
  }

  /// The visible fit.
  get fit(): StoredFit | undefined {
    return this.part?.fit;
  }

  /// Key of that case in `originals`.
  get caseKey(): string {
    return `${this.machine.name} ${this.fit?.table ?? ''}`;
  }

  /// The case without changes, once the engine has read it.
  get original(): CaseInfo | undefined {
    return this.originals.get(this.caseKey);
  }

  /// Stored results of a machine at rest; undefined for motions.
  get atRest(): AtRest | undefined {
    const { run } = this;
    if (!this.resting.has(run)) this.resting.set(run, AtRest.of(run));
    return this.resting.get(run);
  }

  /// Parts of the machine's result; none if live views show everything.
  get parts(): readonly Part[] {
    return partsOf(this.machine.run);
  }

  /// The visible part.
  get part(): Part | undefined {
    return partOf(this.machine.run, this.address.part);
  }

  /// The stored run of the machine; if a part is open, the run with only the tables that its live view shows.
  get run(): Run | undefined {
    return this.part?.run ?? this.machine.run;
  }

  /// The live view of the visible part; "" for a fit without an engine, as nothing of its motions is stored.
  get view(): LiveView {
    const view = this.part?.view ?? 'motions';
    return view === 'fit' && !this.engine ? '' : view;
  }

  /// True if the page shows motions, which the engine computes.
  get moves(): boolean {
    return !this.atRest && !this.runsUp && ['motions', 'fit'].includes(this.view);
  }

  /// True if a run-up is shown.
  get runsUp(): boolean {
    return RunUp.isIn(this.run);
  }

  /// True if the engine computes what is shown.
  get computes(): boolean {
    return this.moves || this.runsUp;
  }

  /// Diagram of stored run-ups, one point for each value of the varied parameter; undefined for other studies.
  get atRuns(): Diagram | undefined {
    return this.runsUp ? this.storedDiagram : undefined;
  }

  /// The shown run: computed at the present setting, or else the stored one.
  get runUp(): RunUp | undefined {
    const { run } = this;
    if (this.model.run || !run || !this.runsUp) return this.model.run;
    const diagram = this.storedDiagram ?? Diagram.stored(run.tables[0]!, run.length_scale);
    const point = Math.max(0, diagram.nearest(this.side.choice.value));
    if (this.storedRun?.run !== run || this.storedRun.point !== point)
      this.storedRun = { run, point, up: RunUp.stored(run, diagram, point) };
    return this.storedRun.up;
  }

  /// Computes the run at the setting of a side.
  wantRun(side: SideModel, settled: boolean): void {
    const { parameter } = this.address;
    const { value } = side.choice;
    const batch = this.run?.tables[0]?.name;
    this.model.want(
      {
        setting: this.settingOf(side),
        ...(parameter && Number.isFinite(value) ? { parameter, value } : {}),
        ...(batch ? { batch } : {}),
      },
      this.run?.contacts ?? [],
      settled,
    );
  }

  /// Introduction: what to try first.
  get intro(): string {
    const { part, machine } = this;
    return part ? introOfPart({ id: part.id, view: this.view }) : machine.intro;
  }

  /// Planes of the machine's stored map; undefined without one.
  get planes(): MapPlanes | undefined {
    const { run } = this;
    if (!this.maps.has(run)) this.maps.set(run, MapPlanes.of(run));
    return this.maps.get(run);
  }

  /// The plane nearest to the active side.
  get plane(): number {
    const { planes, side } = this;
    return planes?.parameter ? planes.nearest(this.valueOf(side, planes.parameter)) : 0;
  }

  /// The map's plane of the active side; undefined without a map.
  get map(): ParameterMap | undefined {
    return this.planes?.at(this.plane);
  }

  /// Computed finer cells of the map; undefined without any.
  get refinement(): MapRefinement | undefined {
    return this.refined?.map === this.map ? this.refined : undefined;
  }

  /// Computes finer cells of a part of the map, which replace earlier ones; without a part it stops the computation.
  /// The cells have the unchanged machine and the method of the run.
  refineMap(part: MapPart | undefined): void {
    const { map, engine, mapTable: table } = this;
    this.refined?.stop();
    if (!map || !table || !engine || !part || !canRefine(part)) return;
    const { text } = this;
    const { caseName } = this.machine;
    const { computation } = this.address;
    const { transient = table.transient, record = table.record } = computation;
    const { plane } = map;
    const assignments = plane ? [`${plane.parameter}=${plainText(plane.value, this.unitOf(plane.parameter))}`] : [];
    const options = { method: table.method, ...computationOptions(computation) };
    const setting = { text, name: caseName, options, assignments };
    const shorter = transient + record < table.transient + table.record;
    this.refined = new MapRefinement(
      engine,
      {
        map,
        part,
        setting,
        unit: this.unitOf(map.y.parameter),
        revolutions: [transient, record],
        shorter,
        say: (refused) => this.inWords(refused),
      },
      () => this.listener.changed('map'),
    );
    this.listener.changed('map');
  }

  private get mapTable(): StoredTable | undefined {
    return this.run?.tables.find((each) => each.map);
  }

  /// Returns the value of a parameter at a side, in SI.
  valueOf({ choice, info, following }: SideModel, name: string): number {
    if (name === this.address.parameter && Number.isFinite(choice.value)) return choice.value;
    const text = choice.assignments.get(name);
    const known = info?.parameters.find((parameter) => parameter.name === name);
    if (text !== undefined) return plainValue(text, this.unitOf(name)) ?? known?.value ?? this.ownValue(name);
    return known?.expression ? (following.get(name) ?? known.value) : this.ownValue(name);
  }

  /// Returns the value of a parameter in the case, in SI.
  private ownValue(name: string): number {
    const has = (parameter: { readonly name: string }) => parameter.name === name;
    return this.original?.parameters.find(has)?.value ?? this.run?.parameters.find(has)?.value ?? NaN;
  }

  /// Moves a side to parameter values: the parameter along the diagram by the cursor, all others by assignments.
  place(side: SideModel, values: readonly (readonly [string, number])[]): void {
    const assignments = new Map(side.choice.assignments);
    let { value } = side.choice;
    for (const [name, wanted] of values)
      if (name === this.address.parameter) value = wanted;
      else assignments.set(name, plainText(wanted, this.unitOf(name)));
    side.choice = { assignments, value };
  }

  /// The map's cut at the active side; undefined if the map does not have the diagram's parameter.
  private get cut(): Cut | undefined {
    const { map, side } = this;
    const { parameter } = this.address;
    if (!map?.axis(parameter)) return undefined;
    return cutOf(map, parameter, {
      assignments: side.choice.assignments,
      valueOf: (name) => this.valueOf(side, name),
      unitOf: (name) => this.unitOf(name),
    });
  }

  /// Shows the cut at the active side, if another one is visible.
  followMap(): void {
    const { cut } = this;
    if (!cut || cut.key === this.cutKey) return;
    const { shown } = this.sights;
    this.sights.stop();
    this.openParameter(this.sights.first?.diagram?.parameter === this.address.parameter ? shown?.range : undefined);
  }

  /// Stored branches and tori of the unchanged machine, over the parameter of the diagram.
  private get followed(): { readonly branches: Branches | undefined; readonly tori: Tori | undefined } {
    const { run } = this;
    const { parameter } = this.address;
    if (!this.traced || this.traced.run !== run || this.traced.parameter !== parameter)
      this.traced = { run, parameter, branches: Branches.of(run, parameter), tori: Tori.of(run, parameter) };
    return this.traced;
  }

  get branches(): Branches | undefined {
    return this.followed.branches;
  }

  get tori(): Tori | undefined {
    return this.followed.tori;
  }

  /// Returns the stored orbit of a choice. Undefined for a motion, for a changed machine (branches belong to the
  /// machine of the case), and for an orbit without data.
  orbitOf({ orbit, assignments }: Side): OrbitOfBranch | undefined {
    return orbit === undefined || assignments.size > 0 ? undefined : this.branches?.orbit(orbit);
  }

  /// Removes orbits from the choices if they do not exist.
  checkOrbits(): void {
    for (const side of Object.values(this.sides)) {
      const { assignments, value } = side.choice;
      const orbit = this.orbitOf(side.choice);
      side.choice = orbit ? { assignments, value: orbit.value, orbit: orbit.point } : { assignments, value };
    }
  }

  /// Makes the request for an orbit: with the method that found it, without the user's options.
  orbitRequest(orbit: OrbitOfBranch): OrbitRequest {
    const { value, revolutions, period, nodes } = orbit;
    const { text } = this;
    const { caseName, run } = this.machine;
    const method = run?.tables.find(({ name }) => name === 'branch')?.method;
    return {
      setting: { text, name: caseName, ...(method ? { options: { method } } : {}) },
      parameter: this.address.parameter,
      ...{ value, revolutions, period, nodes },
    };
  }

  get stations(): readonly StationInfo[] {
    return this.run?.stations ?? this.original?.stations ?? [];
  }

  get scales(): Scales {
    const { run } = this;
    const info = this.sides.a.info ?? this.original;
    return scalesOf(info?.lengthScale ?? run?.length_scale ?? 1, info?.speed ?? run?.speed ?? 1, this.stations);
  }

  /// Index of the visible station; by default the first one with a probe.
  get station(): number {
    const { station } = this.address;
    const probed = [...(this.run?.tables ?? []), ...(this.machine.run?.tables ?? [])].flatMap(({ probes_at: names }) =>
      names ? names.split(' ') : [],
    );
    const indexOf = (wanted: string | undefined) => this.stations.findIndex(({ name }) => name === wanted);
    return Math.max(0, indexOf(this.stations.some(({ name }) => name === station) ? station : probed[0]));
  }

  /// SI unit of the parameter along the diagram.
  get unit(): string {
    return this.unitOf(this.address.parameter);
  }

  /// SI unit of a parameter.
  unitOf(parameter: string): string {
    return (
      this.original?.parameters.find(({ name }) => name === parameter)?.unit ??
      this.run?.parameters.find(({ name }) => name === parameter)?.unit ??
      '1'
    );
  }

  private get storedDiagram(): Diagram | undefined {
    const table = this.run?.tables[0];
    if (this.atRest) return this.atRest.diagram;
    if (table?.map) return undefined;
    return table?.parameter && table.parameter === this.address.parameter
      ? Diagram.stored(table, this.run!.length_scale)
      : undefined;
  }

  /// Initial value of the cursor.
  get firstValue(): number {
    // A fit of orbits begins at the speed of the first one.
    const orbit = this.fit && this.measuredData.find(({ kind }) => kind !== 'vectors');
    if (orbit && Number.isFinite(orbit.speed) && this.isSpeed(this.address.parameter)) return orbit.speed;
    const opening = this.run?.opening;
    if (opening?.parameter && opening.parameter === this.address.parameter && !this.map) return opening.value!;
    return firstValue(this.original, this.address.parameter, this.whole);
  }

  shownSides(): SideName[] {
    return this.address.b ? ['a', 'b'] : ['a'];
  }

  /// Measured data of the machine.
  get measuredData(): readonly MeasuredData[] {
    return this.measured.of(this.machine.name);
  }

  /// True if measured data can be laid over what is shown.
  get measurable(): boolean {
    return this.moves || this.runsUp || this.atRest?.kind === 'unbalance';
  }

  /// Reads files of measured data. Shows a station that they measured and, for vectors, an amplitude.
  async addMeasured(files: readonly NamedFile[]): Promise<void> {
    const { machine } = this;
    const read = await this.measured.add(machine.name, { text: this.text, name: machine.caseName }, files);
    if (read.length === 0 || machine !== this.machine) return;
    this.showMeasured(read);
  }

  /// Reads a file whose columns the user has chosen, and shows it likewise.
  async chooseMeasured(name: string, columns: readonly ChosenColumn[]): Promise<void> {
    const { machine } = this;
    const setting = { text: this.text, name: machine.caseName };
    const read = await this.measured.choose(machine.name, setting, name, columns);
    if (read.length > 0 && machine === this.machine) this.showMeasured(read);
  }

  /// Lays the measured numbers of fits over the machine, and shows them where the visible fit is: at a station that was
  /// measured, and for vectors their amplitudes.
  openFits(): void {
    const { machine } = this;
    const files = machine.run?.fits?.flatMap(({ measured }) => measured) ?? [];
    this.measured.store(
      machine.name,
      files.map(({ name, table }) => new MeasuredData(name, table)),
    );
    if (this.fit && !this.address.station) this.showMeasured(this.measuredData);
  }

  private showMeasured(data: readonly MeasuredData[]): void {
    const seen = data.some(({ stations }) => stations.includes(this.station));
    if (!seen) this.address.station = this.stations[data[0]?.stations[0] ?? 0]?.name ?? '';
    const vectors = data.find(({ kind, stations }) => kind === 'vectors' && stations.includes(this.station));
    if (vectors && this.moves && !VECTORS.has(this.address.quantity))
      this.address.quantity = vectors.seen(this.station, 0) ? '1x' : '1y';
  }

  /// Returns vectors over the parameter along the diagram, as a probe of the station sees them.
  seenAlong(data: MeasuredData, direction: number): Seen | undefined {
    const { parameter } = this.address;
    const own = data.parameter ? data.parameter === parameter : this.isSpeed(parameter);
    return data.kind === 'vectors' && own ? data.seen(this.station, direction) : undefined;
  }

  /// The band of tolerances of the shown quantity, for the machine of the case.
  get band(): StoredBand | undefined {
    const { address, station, run } = this;
    if (this.fit || this.sights.shown?.of !== '') return undefined;
    return bandOfQuantity(run?.bands, address.parameter, address.quantity, station);
  }

  /// Returns true if a parameter is the speed of the shaft.
  isSpeed(name: string): boolean {
    const uses = this.original?.parameters.find((parameter) => parameter.name === name)?.uses ?? [];
    return uses.some(({ path, alone }) => alone && path === 'rotor.speed');
  }

  /// Returns the setting of a side for the engine.
  settingOf(side: SideModel): Setting {
    return {
      text: this.text,
      name: this.machine.caseName,
      assignments: assignmentTexts(side.choice.assignments),
      options: computationOptions(this.address.computation),
    };
  }

  /// Makes the engine read a text as a value of the diagram's parameter. Returns the value in SI, the message of a
  /// rejection, or undefined if a newer request has overtaken this one.
  async spokenValue(name: SideName, text: string): Promise<number | string | undefined> {
    const { parameter } = this.address;
    const setting = this.settingOf(this.sides[name]);
    const assignments = [...(setting.assignments ?? []), `${parameter}=${text}`];
    const answer = await this.engine?.describe({ ...setting, assignments }, { lane: `speak-${name}`, priority: 0 });
    if (!answer?.ok) return answer && answer.why !== 'stale' ? answer.message : undefined;
    return answer.value.parameters.find((each) => each.name === parameter)?.value;
  }

  /// Returns a rejection of the engine in the words of the page.
  inWords(refused: string): string {
    return inWordsOfPage(refused, this.original?.parameters ?? []);
  }

  /// Moves the first cursor to its initial value, unless it has one.
  chooseValue(): void {
    const { a } = this.sides;
    if (Number.isFinite(a.choice.value) || this.view === '') return;
    if (this.runsUp) {
      a.choice = { ...a.choice, value: this.atRuns?.values[0] ?? NaN };
      return;
    }
    const { map } = this;
    if (!map?.axis(this.address.parameter)) {
      a.choice = { ...a.choice, value: this.firstValue };
      return;
    }
    const { x, y } = map;
    const { column, row } = map.nearest(this.valueOf(a, x.parameter), this.valueOf(a, y.parameter));
    this.place(a, [
      [x.parameter, x.values[column]!],
      [y.parameter, y.values[row]!],
    ]);
    this.enterPlane(a);
  }

  /// Shows the stored opening motion, unless another one is requested.
  openStored(): void {
    const { run } = this;
    if (!run?.opening || !this.moves) return;
    const { a } = this.sides;
    if (run.opening.parameter && run.opening.parameter === this.address.parameter) this.chooseValue();
    if (this.isOpening(a)) a.showStored(storedMotion(run, run.opening));
  }

  /// Returns true if a side is at the opening motion, with the machine and the method of the run.
  private isOpening({ choice }: SideModel): boolean {
    const { opening } = this.run ?? {};
    const own = choice.assignments.size === 0 && choice.orbit === undefined;
    if (!opening || !own || Object.keys(this.address.computation).length > 0) return false;
    if (!opening.parameter) return Number.isNaN(choice.value) || choice.value === this.ownValue(this.address.parameter);
    return opening.parameter === this.address.parameter && choice.value === opening.value;
  }

  /// Assigns the third parameter of the visible plane to a side, unless it has that value.
  enterPlane(side: SideModel): void {
    const plane = this.map?.plane;
    if (plane && !(Math.abs(this.valueOf(side, plane.parameter) - plane.value) <= 1e-9 * Math.abs(plane.value)))
      this.place(side, [[plane.parameter, plane.value]]);
  }

  /// Opens the first diagram: the stored one, or an empty one over the range of the sweep.
  openParameter(view = this.address.range): void {
    const { run } = this;
    const swept = this.runsUp ? run!.tables[0]!.parameter : sweptParameter(this.original, run?.tables[0]?.parameter);
    if (this.runsUp) this.address.parameter = swept;
    const known =
      this.original?.parameters.some(({ name }) => name === this.address.parameter) ||
      this.address.parameter === swept ||
      this.map?.axis(this.address.parameter) !== undefined;
    if (!known) this.address.parameter = swept;
    const { cut } = this;
    this.cutKey = cut?.key ?? '';
    const diagram = cut ? cut.diagram() : this.storedDiagram;
    const range = view ?? diagram?.span ?? plannedRange(this.original, this.address.parameter);
    const text = diagram ? `${this.storedText(diagram)}${cut ? ` A cut through the map at ${cut.of}.` : ''}` : '';
    const assignments = cut?.assignments ?? [];
    this.sights.open({ diagram, range, of: assignments.join('; '), text, how: howOf({ assignments }) });
  }

  /// Possible parameters of a diagram; without the engine only those with stored diagrams.
  get parameterNames(): readonly string[] {
    const { map, original } = this;
    const stored = map ? [map.x.parameter, map.y.parameter] : [this.address.parameter];
    return original?.parameters.map(({ name }) => name) ?? stored;
  }

  /// A sentence that describes the map of the machine.
  get mapText(): string {
    const { map } = this;
    const { mapTable: table } = this;
    if (!map || !table) return '';
    const thinned = table.count < table.points ? ` (of ${table.points} points in the run)` : '';
    const planes = this.planes!.count;
    const missing = map.columns * map.rows * planes - map.diagram.known;
    const over = `${map.x.parameter} and ${map.y.parameter}`;
    const third = map.plane ? ` in each of ${planes} planes of ${map.plane.parameter}` : '';
    return (
      `Stored run: ${map.columns} by ${map.rows} points over ${over}${third}${thinned}` +
      `${missing > 0 ? `, ${missing} of them not computed` : ''}.`
    );
  }

  private storedText(diagram: Diagram): string {
    const table = this.run!.tables[0]!;
    const part =
      table.count < table.points && !table.map
        ? `every ${Math.round(table.points / table.count)}th of ${table.points} points`
        : `${diagram.count} points`;
    if (this.atRest) return `Stored run: ${part} of a machine at rest.`;
    if (table.starts)
      return (
        `Stored run: ${table.places} points from ${table.starts} starts each; ` +
        (table.map ? 'of every point the attractor that most lead to.' : `all ${diagram.count} of their attractors.`)
      );
    if (table.name === 'branch') return `Stored run: ${part} along branches of orbits, stable or not.`;
    const done = diagram.known < diagram.count ? `, ${diagram.known} of them computed` : '';
    return (
      `Stored run: ${part}${done}, ${table.transient} + ${table.record} revolutions by ` +
      `${methodText(table)} of ${table.steps_per_revolution} steps.`
    );
  }

  /// Reads the units of the address; without units in it they are chosen for the machine.
  readUnits(): void {
    this.unitsAwaited = false;
    if (this.run) this.address.units.shown = this.run.shown;
    if (!location.hash.includes('units=')) this.suitUnits(this.run?.length_scale);
  }

  /// Chooses the units of the run, else those that suit a length scale [m]; if the scale is unknown, the choice is made
  /// later.
  suitUnits(lengthScale: number | undefined): void {
    this.unitsAwaited = lengthScale === undefined;
    if (lengthScale === undefined) return;
    const { run } = this;
    this.address.units = { ...unitsFor(lengthScale, this.address.units), ...(run && unitsOfReport(run.shown)) };
  }

  /// Returns the state in the form of the page's address.
  currentAddress(): Address {
    const view = this.sights.shown?.range;
    const { whole } = this;
    const zoomed = view && (view[0] !== whole[0] || view[1] !== whole[1]);
    return {
      ...this.address,
      run: this.machine.name,
      part: this.part === partOf(this.machine.run, '') ? '' : (this.part?.id ?? ''),
      a: this.sides.a.choice,
      b: this.address.b ? this.sides.b.choice : undefined,
      range: zoomed ? view : undefined,
      station: this.stations[this.station]?.name ?? '',
    };
  }
}
