// What the page asks of the engine, and what it is told. Lengths are in the case's length scale, velocities in length
// scales per radian of rotation, time in revolutions, forces in newtons; everything else says its unit.

// ---------------------------------------------------------------- cases

/// A case with what the page has changed of it. `text` is YAML as `whirl run` reads it; `assignments` are as those of
/// `whirl run --set`: "r_k=0.45", "omega=6000 rpm", "c== 2*0.1e-3".
export interface Setting {
  readonly text: string;
  /// Stands for the file in messages.
  readonly name?: string;
  readonly assignments?: readonly string[];
  readonly options?: Partial<Options>;
  /// Asks for a first look only.
  readonly look?: Look;
}

/// A motion that is cut short and, by methods of fixed step, coarser; 0: as the setting says. Where that leaves
/// anything out, its verdict is "undetermined" unless the whole motion must have the same.
export interface Look {
  readonly transient: number;
  readonly record: number;
  readonly stepsPerRevolution: number;
}

/// Something wrong in a case. Lines and columns count from 1; 0 where there is no place.
export interface Problem {
  readonly line: number;
  readonly column: number;
  /// "rotor.stations.disc.mass", "" where nothing of the kind is meant.
  readonly key: string;
  /// "is -3 kg, expected a number above 0 kg"
  readonly message: string;
}

/// Where a parameter is used, from the descriptor of the key that stands there.
export interface ParameterUse {
  /// "rotor.elements[2].film.clearance"
  readonly path: string;
  readonly meaning: string;
  /// SI unit of the key, "1" for a plain number.
  readonly unit: string;
  /// The key's range; null where it has no bound. An open bound is itself excluded.
  readonly low: number | null;
  readonly high: number | null;
  readonly lowOpen: boolean;
  readonly highOpen: boolean;
  /// Nothing but the parameter stands there ("= c"), so that the range is the parameter's own.
  readonly alone: boolean;
}

export interface ParameterInfo {
  readonly name: string;
  /// As written, or as assigned: "0.2 mm", "= r_k*k2".
  readonly written: string;
  /// In SI.
  readonly value: number;
  /// SI unit, "1" for a plain number, "SI" for an expression, whose unit is not known.
  readonly unit: string;
  /// The value follows from other parameters.
  readonly expression: boolean;
  /// The comment on its line, "" where there is none.
  readonly comment: string;
  readonly uses: readonly ParameterUse[];
}

export interface StationInfo {
  readonly name: string;
  /// Clearance of the journal bearing here, 0 where there is none.
  readonly clearance: number;
  /// Radius at which the station touches a stator, 0 where there is none.
  readonly gap: number;
  /// Indices of its coordinates in a state.
  readonly x: number;
  readonly y: number;
  /// Number of the shaft of finite elements that it lies on, from 1, and its place along that, m; 0: on none.
  readonly shaft: number;
  readonly position: number;
  /// The rotor turns from y to x.
  readonly clockwise: boolean;
}

/// How points are computed, by the names that results have: all that is in the tables of src/integrate/options.c and
/// src/analyze/record/options.c. The page itself speaks of these.
export interface Options {
  /// A name of CaseInfo.methods.
  readonly method: string;
  /// Of an answer: `method: auto` took it.
  readonly method_chosen: boolean;
  readonly steps_per_revolution: number;
  /// Revolutions that pass before anything is recorded.
  readonly transient: number;
  readonly record: number;
  /// Revolutions before the end over which the motion is watched; 0: chosen by the engine.
  readonly watch: number;
  /// Last revolutions whose waveform is kept; 0: none. A point without a wish keeps at most 20.
  readonly waveform_revolutions: number;
  readonly [name: string]: string | number | boolean;
}

export type Carry = 'none' | 'forward' | 'reverse' | 'both';

/// Points that the case computes alike; "sweep", "detail" or "response".
export interface BatchInfo {
  readonly name: string;
  /// What varies, in SI; "" for a single point.
  readonly parameter: string;
  readonly values: readonly number[];
  readonly carry: Carry;
  readonly options: Options;
}

export interface MethodInfo {
  readonly name: string;
  readonly meaning: string;
  readonly adaptive: boolean;
}

export interface CaseInfo {
  /// Version of the engine.
  readonly version: string;
  readonly title: string;
  readonly parameters: readonly ParameterInfo[];
  readonly stations: readonly StationInfo[];
  readonly contacts: readonly string[];
  /// m
  readonly lengthScale: number;
  /// rad/s, of what revolutions are counted by
  readonly speed: number;
  readonly batches: readonly BatchInfo[];
  readonly methods: readonly MethodInfo[];
}

// ---------------------------------------------------------------- points

export type Extent = 'point' | 'station' | 'contact';

/// A group of numbers in the block of a point: for the point, or for every station or contact, [rows][columns].
export interface Field {
  /// "poincare/section", "spectrum/lines", ...
  readonly name: string;
  /// "length", "force", "1", "revolution", "1/revolution", "order"
  readonly unit: string;
  /// What it means; for columns their names, separated by ", ".
  readonly meaning: string;
  readonly extent: Extent;
  readonly rows: number;
  readonly columns: number;
  /// 1, or the number of stations or contacts.
  readonly repeat: number;
  /// Of the first number in the block.
  readonly offset: number;
}

export interface Layout {
  readonly size: number;
  readonly fields: readonly Field[];
}

export type Regime = 'undetermined' | 'periodic' | 'quasi-periodic' | 'chaotic' | 'diverged';

export interface Verdict {
  readonly regime: Regime;
  /// "P-2", "quasi-periodic (1 curve)", ...
  readonly name: string;
  /// One sentence from the evidence.
  readonly reason: string;
  /// A first look: the whole motion has a verdict.
  readonly provisional: boolean;
  readonly period: number;
  readonly curves: number;
  /// Revolution, 0 where the motion did not diverge.
  readonly divergedAt: number;
  /// Largest Lyapunov exponent per revolution with its standard error; null where none was found.
  readonly exponent: number | null;
  readonly exponentError: number | null;
  readonly confidence: 'low' | 'fair' | 'high';
  /// What would settle it, in words; "" where nothing is advised.
  readonly advice: string;
}

export interface PointRequest {
  readonly setting: Setting;
  /// What varies, and its value in SI; left out: as the setting says.
  readonly parameter?: string;
  readonly value?: number;
  /// The batch whose options and start hold ("sweep", "detail", "response"); left out: the case's first one.
  readonly batch?: string;
  /// Where the motion starts, [dimension]; left out: as the case says.
  readonly start?: Float64Array;
}

/// What is known of one motion, by the fields of analyses.
export interface MotionResult {
  readonly value: number | null;
  /// Of orbits along branches there is none.
  readonly verdict?: Verdict;
  readonly layout: Layout;
  readonly block: Float64Array;
  /// m and rad/s, of the machine at this value; the rate of what revolutions are counted by.
  readonly lengthScale: number;
  readonly speed: number;
  /// The element whose phase that is, "" for the shaft.
  readonly keyphasor: string;
  readonly stations: readonly StationInfo[];
  /// Samples of the waveform a revolution; the last one is at the once-per-revolution mark.
  readonly samplesPerRevolution: number;
  readonly options: Options;
  /// Wall-clock seconds in the worker.
  readonly seconds: number;
}

/// Everything about one point: the fields of all analyses, whole spectra and a waveform among them.
export interface PointResult extends MotionResult {
  readonly verdict: Verdict;
  /// The state at the end: x, y of every station, then their velocities; NaN after a divergence.
  readonly end: Float64Array;
}

/// An orbit along a branch, or an equilibrium, stable or not.
export interface OrbitRequest {
  readonly setting: Setting;
  readonly parameter: string;
  readonly value: number;
  /// After which it closes; 0: a time of its own.
  readonly revolutions: number;
  /// Radians of the rotor's clock; 0: an equilibrium.
  readonly period: number;
  /// The states at the beginnings of its segments, one after the other.
  readonly nodes: Float64Array;
}

// ---------------------------------------------------------------- diagrams

export interface SweepRequest {
  readonly setting: Setting;
  readonly parameter: string;
  /// In SI. Points that do not follow one another are computed in this order.
  readonly values: Float64Array;
  /// Left out: 'none'. Carried points follow one another and take one worker (two for 'both').
  readonly carry?: Carry;
  /// As for points.
  readonly batch?: string;
  /// Also what is found in spectra ("spectrum/synchronous", ...), which takes a tenth to a fifth more work.
  readonly spectra?: boolean;
}

/// Points of a sweep that are done. Slots count the values from 0; with carry 'both' the slots values.length and up are
/// those of the way back, in the order of the values too.
export interface SweepPoints {
  readonly slots: Uint32Array;
  /// [slots.length][layout.size]
  readonly blocks: Float64Array;
  readonly verdicts: readonly Verdict[];
  /// [slots.length] m, of the machine at each point: what varies may change it.
  readonly lengthScales: Float64Array;
}

export interface SweepProgress {
  readonly pointsDone: number;
  readonly pointsTotal: number;
  readonly revolutionsDone: number;
  readonly revolutionsTotal: number;
}

export interface SweepListener {
  /// Once, before the first points.
  layout?(layout: Layout, slots: number): void;
  points?(points: SweepPoints): void;
  progress?(progress: SweepProgress): void;
}

export interface SweepResult {
  readonly layout: Layout;
  readonly seconds: number;
}

// ---------------------------------------------------------------- motions to look at

export interface TransientRequest {
  readonly setting: Setting;
  readonly parameter?: string;
  readonly value?: number;
  readonly batch?: string;
  /// The state to go on from; left out: the case's start.
  readonly state?: Float64Array;
  readonly revolutions: number;
  readonly samplesPerRevolution: number;
}

export interface TransientResult {
  /// The state after the last revolution: hand it to the next request.
  readonly state: Float64Array;
  /// State [dimension] at every sample, oldest first; StationInfo says where its coordinates are. Samples lie at equal
  /// distances; the last of every revolution is at its mark.
  readonly samples: Float64Array;
  /// [samples][contacts] normal forces, 0 while open.
  readonly forces: Float64Array;
  readonly dimension: number;
  readonly contacts: number;
  /// May be more than was asked for: the next divisor of the steps.
  readonly samplesPerRevolution: number;
  /// Whole revolutions done: fewer than asked for where the motion diverged.
  readonly revolutions: number;
  readonly diverged: boolean;
}

// ---------------------------------------------------------------- cases to keep

/// A value in the text of a case. `path` is a key's ("parameters.r_k", "study.sweep.from"), `text` what shall stand
/// there; without a text the key is taken out.
export interface Edit {
  readonly path: string;
  readonly text?: string;
}

// ---------------------------------------------------------------- answers

/// An error is a value: a stale request was overtaken by a later one or cancelled, a bad one names its problems, and a
/// failure is the engine's own.
export type Outcome<T> =
  | { readonly ok: true; readonly value: T }
  | { readonly ok: false; readonly why: 'stale' }
  | {
      readonly ok: false;
      readonly why: 'bad' | 'failed';
      readonly message: string;
      readonly problems: readonly Problem[];
    };

/// How a request stands to others. Requests of one lane overtake each other: a new one makes all that are pending in
/// its lane stale. Requests of lower priority number go first; sweeps take the workers that nothing else needs.
export interface Manner {
  readonly lane?: string;
  readonly priority?: number;
  readonly signal?: AbortSignal;
}

/// The engine: a pool of workers that hold the C core. Every method resolves, none rejects.
export interface Engine {
  readonly workers: number;
  /// Reads and checks a case.
  describe(setting: Setting, manner?: Manner): Promise<Outcome<CaseInfo>>;
  point(request: PointRequest, manner?: Manner): Promise<Outcome<PointResult>>;
  /// The orbit with these nodes: each of its segments is followed from its own, so that an unstable one is not left.
  orbit(request: OrbitRequest, manner?: Manner): Promise<Outcome<MotionResult>>;
  sweep(request: SweepRequest, listener?: SweepListener, manner?: Manner): Promise<Outcome<SweepResult>>;
  transient(request: TransientRequest, manner?: Manner): Promise<Outcome<TransientResult>>;
  /// The text of a case with values written in place, comments and layout kept; checked. A key that is missing is added
  /// where its mapping stands. Assignments of the setting are written in their parameters' places.
  rewrite(setting: Setting, edits: readonly Edit[], manner?: Manner): Promise<Outcome<string>>;
  /// Makes all pending requests of a lane stale; of all lanes without a name.
  cancel(lane?: string): void;
  /// Ends the workers; pending requests become stale.
  close(): void;
}

/// What `make explorer` builds: build/explorer/worker.js as text, and build/explorer/whirl.wasm.
export interface EngineParts {
  readonly worker: string;
  readonly core: Uint8Array;
  /// Left out: as many as the computer has cores.
  readonly workers?: number;
  /// Told why once no worker can start.
  readonly broken?: (why: string) => void;
}

/// `startEngine` of engine.ts.
export type StartEngine = (parts: EngineParts) => Engine;

/// The field of that name, or undefined.
export function findField(layout: Layout, name: string): Field | undefined {
  return layout.fields.find((field) => field.name === name);
}

/// The numbers [rows][columns] of a field for one station or contact (0 for the point's own) in the block that begins
/// at `base` of `blocks`; a view. Empty where there is no such field.
export function fieldNumbers(layout: Layout, blocks: Float64Array, name: string, which = 0, base = 0): Float64Array {
  const field = findField(layout, name);
  if (!field || which >= field.repeat) return blocks.subarray(0, 0);
  const size = field.rows * field.columns;
  const first = base + field.offset + which * size;
  return blocks.subarray(first, first + size);
}
