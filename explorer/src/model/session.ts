// What the page is at: the machine that is open, what the reader has set, what of it is shown, and what follows from
// these.
import { Branches } from '../data/branches';
import { Tori } from '../data/tori';
import { partOf, partsOf, type Part } from '../data/contents';
import { Diagram } from '../data/diagram';
import { storedMotion } from '../data/opening';
import type { OrbitOfBranch } from '../data/orbit';
import { MapPlanes, type ParameterMap } from '../data/parameter_map';
import { AtRest } from '../data/rest';
import type { Run, StoredTable } from '../data/run';
import type { CaseInfo, Engine, OrbitRequest, Setting, StationInfo, SweepProgress } from '../engine/protocol';
import { introOfPart, machinesOf, scalesOf, type Machine } from './machine';
import { cutOf, plainText, plainValue, type Cut } from './map_cut';
import { canRefine, MapRefinement, type MapPart } from './map_refinement';
import { firstValue, plannedRange, sweptParameter } from './original';
import { assignmentTexts, computationOptions, readAddress, type Address, type Side } from './setting';
import { SideModel } from './side';
import { howOf, Sights, type Sight } from './sights';
import { unitsFor, unitsOfWords, type Scales } from './units';
import { inWordsOfPage } from './words';

type Range = readonly [number, number];

export type SideName = 'a' | 'b';

/// What is to be drawn anew: all, a side, the points that the diagram has gained, or those that the map has.
export type Change = 'all' | SideName | 'grow' | 'map';

export interface SessionListener {
  changed(what: Change): void;
  progress(now: SweepProgress | undefined): void;
}

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
  /// Of the cut of a map that the first sight shows.
  private cutKey = '';
  /// By the names of their machines.
  readonly originals = new Map<string, CaseInfo>();
  readonly sights: Sights;
  /// Classes of regimes that are not drawn.
  hidden: ReadonlySet<number> = new Set();
  /// The units are still to be those that suit the machine.
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
    this.sights = new Sights(engine, {
      changed: () => listener.changed('all'),
      grown: () => listener.changed('grow'),
      progress: (now) => listener.progress(now),
    });
  }

  /// The engine is gone; what it has found stays.
  lose(): void {
    this.sights.stop();
    this.refined?.stop();
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

  /// The side that the reader works at.
  get side(): SideModel {
    return this.sides[this.active];
  }

  /// The case as it is written, once the engine has read it.
  get original(): CaseInfo | undefined {
    return this.originals.get(this.machine.name);
  }

  /// What is stored of a machine whose motions are not followed; undefined of all others.
  get atRest(): AtRest | undefined {
    const { run } = this;
    if (!this.resting.has(run)) this.resting.set(run, AtRest.of(run));
    return this.resting.get(run);
  }

  /// The parts of the machine's result; none where live views show all of it.
  get parts(): readonly Part[] {
    return partsOf(this.machine.run);
  }

  /// The part that is looked at.
  get part(): Part | undefined {
    return partOf(this.machine.run, this.address.part);
  }

  /// What is stored of the machine; in a part, with the tables of its live view alone.
  get run(): Run | undefined {
    return this.part?.run ?? this.machine.run;
  }

  /// Whether motions are shown, which the engine computes.
  get moves(): boolean {
    return !this.atRest && (this.part?.view ?? 'motions') === 'motions';
  }

  /// What to try first.
  get intro(): string {
    const { part, machine } = this;
    return part ? introOfPart(part) : machine.intro;
  }

  /// The planes of the map that is stored of the machine; undefined where there is none.
  get planes(): MapPlanes | undefined {
    const { run } = this;
    if (!this.maps.has(run)) this.maps.set(run, MapPlanes.of(run));
    return this.maps.get(run);
  }

  /// Which of them is nearest to where the active side is.
  get plane(): number {
    const { planes, side } = this;
    return planes?.parameter ? planes.nearest(this.valueOf(side, planes.parameter)) : 0;
  }

  /// The plane of the map that the active side is in; undefined where there is no map.
  get map(): ParameterMap | undefined {
    return this.planes?.at(this.plane);
  }

  /// Finer cells of the map that were computed; undefined where there are none.
  get refinement(): MapRefinement | undefined {
    return this.refined?.map === this.map ? this.refined : undefined;
  }

  /// Computes finer cells of a part of the map in place of other ones; without a part no more are computed. They are of
  /// the machine as it stands, by the method of the run.
  refineMap(part: MapPart | undefined): void {
    const { map, engine, mapTable: table } = this;
    this.refined?.stop();
    if (!map || !table || !engine || !part || !canRefine(part)) return;
    const { text, caseName } = this.machine;
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

  /// The value that a side gives a parameter, in SI.
  valueOf({ choice, info, following }: SideModel, name: string): number {
    if (name === this.address.parameter && Number.isFinite(choice.value)) return choice.value;
    const text = choice.assignments.get(name);
    const known = info?.parameters.find((parameter) => parameter.name === name);
    if (text !== undefined) return plainValue(text, this.unitOf(name)) ?? known?.value ?? this.ownValue(name);
    return known?.expression ? (following.get(name) ?? known.value) : this.ownValue(name);
  }

  /// The value that the case gives a parameter, in SI.
  private ownValue(name: string): number {
    const has = (parameter: { readonly name: string }) => parameter.name === name;
    return this.original?.parameters.find(has)?.value ?? this.run?.parameters.find(has)?.value ?? NaN;
  }

  /// Puts a side where parameters have these values: the one along the diagram there, all others by assignments.
  place(side: SideModel, values: readonly (readonly [string, number])[]): void {
    const assignments = new Map(side.choice.assignments);
    let { value } = side.choice;
    for (const [name, wanted] of values)
      if (name === this.address.parameter) value = wanted;
      else assignments.set(name, plainText(wanted, this.unitOf(name)));
    side.choice = { assignments, value };
  }

  /// The cut of the map that the active side is at; undefined where the diagram runs along neither of its parameters.
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

  /// Shows the cut that the active side is at in place of another.
  followMap(): void {
    const { cut } = this;
    if (!cut || cut.key === this.cutKey) return;
    const { shown } = this.sights;
    this.sights.stop();
    this.openParameter(this.sights.first?.diagram?.parameter === this.address.parameter ? shown?.range : undefined);
  }

  /// The branches and tori that are stored of the machine as it stands, over the parameter of the diagram.
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

  /// The orbit that a choice is of; undefined of motions, and of orbits that there are not: branches are of the machine
  /// as it stands.
  orbitOf({ orbit, assignments }: Side): OrbitOfBranch | undefined {
    return orbit === undefined || assignments.size > 0 ? undefined : this.branches?.orbit(orbit);
  }

  /// What an address says of orbits, as far as there are such.
  checkOrbits(): void {
    for (const side of Object.values(this.sides)) {
      const { assignments, value } = side.choice;
      const orbit = this.orbitOf(side.choice);
      side.choice = orbit ? { assignments, value: orbit.value, orbit: orbit.point } : { assignments, value };
    }
  }

  /// What the engine is asked to follow an orbit with: the method that found it, and no other wish of the reader's.
  orbitRequest(orbit: OrbitOfBranch): OrbitRequest {
    const { value, revolutions, period, nodes } = orbit;
    const { text, caseName, run } = this.machine;
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

  /// Index of the station that is shown: without a choice the first one with a probe.
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

  /// Where the cursor begins.
  get firstValue(): number {
    const opening = this.run?.opening;
    if (opening?.parameter && opening.parameter === this.address.parameter && !this.map) return opening.value!;
    return firstValue(this.original, this.address.parameter, this.whole);
  }

  shownSides(): SideName[] {
    return this.address.b ? ['a', 'b'] : ['a'];
  }

  /// What the engine is asked to compute with.
  settingOf(side: SideModel): Setting {
    return {
      text: this.machine.text,
      name: this.machine.caseName,
      assignments: assignmentTexts(side.choice.assignments),
      options: computationOptions(this.address.computation),
    };
  }

  /// A text of the parameter along the diagram in SI, as the engine reads it; the sentence that refuses it, or
  /// undefined where something else was asked meanwhile.
  async spokenValue(name: SideName, text: string): Promise<number | string | undefined> {
    const { parameter } = this.address;
    const setting = this.settingOf(this.sides[name]);
    const assignments = [...(setting.assignments ?? []), `${parameter}=${text}`];
    const told = await this.engine?.describe({ ...setting, assignments }, { lane: `speak-${name}`, priority: 0 });
    if (!told?.ok) return told && told.why !== 'stale' ? told.message : undefined;
    return told.value.parameters.find((each) => each.name === parameter)?.value;
  }

  /// What the engine has refused, as the reader is told.
  inWords(refused: string): string {
    return inWordsOfPage(refused, this.original?.parameters ?? []);
  }

  /// Puts the first cursor where it begins, unless it is somewhere.
  chooseValue(): void {
    const { a } = this.sides;
    if (Number.isFinite(a.choice.value) || this.part?.view === '') return;
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

  /// Shows the motion that the run has stored of where the page opens, unless another one is asked for.
  openStored(): void {
    const { run } = this;
    if (!run?.opening || !this.moves) return;
    const { a } = this.sides;
    if (run.opening.parameter && run.opening.parameter === this.address.parameter) this.chooseValue();
    if (this.isOpening(a)) a.showStored(storedMotion(run, run.opening));
  }

  /// Whether a side is where the page opens, of the machine and by the method of the run.
  private isOpening({ choice }: SideModel): boolean {
    const { opening } = this.run ?? {};
    const own = choice.assignments.size === 0 && choice.orbit === undefined;
    if (!opening || !own || Object.keys(this.address.computation).length > 0) return false;
    if (!opening.parameter) return Number.isNaN(choice.value) || choice.value === this.ownValue(this.address.parameter);
    return opening.parameter === this.address.parameter && choice.value === opening.value;
  }

  /// Gives a side the third parameter of the plane that is shown, unless it has it.
  enterPlane(side: SideModel): void {
    const plane = this.map?.plane;
    if (plane && !(Math.abs(this.valueOf(side, plane.parameter) - plane.value) <= 1e-9 * Math.abs(plane.value)))
      this.place(side, [[plane.parameter, plane.value]]);
  }

  /// The first sight: the stored diagram, or an empty one over the range of the sweep.
  openParameter(view = this.address.range): void {
    const { run } = this;
    const swept = sweptParameter(this.original, run?.tables[0]?.parameter);
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

  /// Along which a diagram may run: without the engine those that are stored.
  get parameterNames(): readonly string[] {
    const { map, original } = this;
    const stored = map ? [map.x.parameter, map.y.parameter] : [this.address.parameter];
    return original?.parameters.map(({ name }) => name) ?? stored;
  }

  /// What the map of the machine is, in a sentence.
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

  /// An address that names no units leaves them to the machine.
  readUnits(): void {
    this.unitsAwaited = false;
    if (!location.hash.includes('units=')) this.suitUnits(this.run?.length_scale);
  }

  /// Units that the run asks for, else those that suit a length scale [m]; of a machine whose scale is not known they
  /// are chosen when it is.
  suitUnits(lengthScale: number | undefined): void {
    this.unitsAwaited = lengthScale === undefined;
    if (lengthScale === undefined) return;
    const { run } = this;
    const words = [run?.facts.find(({ name }) => name === 'units')?.value, run?.units].filter(Boolean).join(',');
    this.address.units = { ...unitsFor(lengthScale, this.address.units), ...unitsOfWords(words) };
  }

  /// As it stands in the address of the page.
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
