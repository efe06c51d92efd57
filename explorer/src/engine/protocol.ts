// Requests of the page to the engine, and answers. Lengths are in the case's length scale, velocities in length scales
// per radian of rotation, time in revolutions, forces in newtons; other units are stated.

// ---------------------------------------------------------------- cases

/// A case with the page's changes. `text` is YAML as for `whirl run`; `assignments` are as for `whirl run --set`:
/// "r_k=0.45", "omega=6000 rpm", "c== 2*0.1e-3".
export interface Setting {
  readonly text: string;
  /// Name of the file in messages.
  readonly name?: string;
  readonly assignments?: readonly string[];
  readonly options?: Partial<Options>;
  /// Requests a preview only.
  readonly look?: Look;
}

/// A preview: a shortened motion, with coarser steps for methods of fixed step. A member that is 0 is as in the
/// setting. If it leaves anything out, its verdict is "undetermined" unless the whole motion must have the same
/// verdict.
export interface Look {
  readonly transient: number;
  readonly record: number;
  readonly stepsPerRevolution: number;
}

/// A problem of a case. Lines and columns count from 1; 0 without a place.
export interface Problem {
  readonly line: number;
  readonly column: number;
  /// Path of the key, "rotor.stations.disc.mass"; "" if the problem is not about a key.
  readonly key: string;
  /// "is -3 kg, expected a number above 0 kg"
  readonly message: string;
}

/// A use of a parameter, described by the key that uses it.
export interface ParameterUse {
  /// "rotor.elements[2].film.clearance"
  readonly path: string;
  readonly meaning: string;
  /// SI unit of the key, "1" for a plain number.
  readonly unit: string;
  /// The key's range; null for no bound. An open bound is itself excluded.
  readonly low: number | null;
  readonly high: number | null;
  readonly lowOpen: boolean;
  readonly highOpen: boolean;
  /// True if the value is the parameter alone ("= c"), so that the range applies to the parameter.
  readonly alone: boolean;
}

export interface ParameterInfo {
  readonly name: string;
  /// The text as written or assigned: "0.2 mm", "= r_k*k2".
  readonly written: string;
  /// In SI.
  readonly value: number;
  /// SI unit; "1" for a plain number, "SI" for an expression of unknown unit.
  readonly unit: string;
  /// True if the value follows from other parameters.
  readonly expression: boolean;
  /// The comment on its line, or "".
  readonly comment: string;
  readonly uses: readonly ParameterUse[];
}

export interface StationInfo {
  readonly name: string;
  /// Clearance of the journal bearing at the station, 0 without one.
  readonly clearance: number;
  /// Radius at which the station touches a stator, 0 without one.
  readonly gap: number;
  /// Indices of its coordinates in a state.
  readonly x: number;
  readonly y: number;
  /// Number of its shaft of finite elements, from 1 (0: none), and its position along the shaft, m.
  readonly shaft: number;
  readonly position: number;
  /// True if the station only twists about the shaft's axis: its displacements are those of a point 1 m from the axis.
  readonly twists: boolean;
  /// True if the rotor turns from y to x.
  readonly clockwise: boolean;
}

/// Options of the computation, by their names in results (src/integrate/options.c and src/analyze/record/options.c).
/// The page uses the following.
export interface Options {
  /// One of CaseInfo.methods.
  readonly method: string;
  /// In answers: true if `method: auto` chose the method.
  readonly method_chosen: boolean;
  readonly steps_per_revolution: number;
  /// Revolutions before the record.
  readonly transient: number;
  readonly record: number;
  /// Revolutions before the end in which the motion is observed; 0: chosen by the engine.
  readonly watch: number;
  /// Last revolutions whose waveform is stored; 0: none. By default a point stores at most 20.
  readonly waveform_revolutions: number;
  readonly [name: string]: string | number | boolean;
}

export type Carry = 'none' | 'forward' | 'reverse' | 'both';

/// Points of the case with common options: "sweep", "detail" or "response".
export interface BatchInfo {
  readonly name: string;
  /// The varied parameter, with values in SI; "" for a single point.
  readonly parameter: string;
  readonly values: readonly number[];
  readonly carry: Carry;
  /// True for a run-up over the time.
  readonly runup: boolean;
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
  /// Other numbers of the case that the user can change while the page shows a run: rates, unbalances, torques,
  /// friction. Their names are those of `whirl run --set`.
  readonly levers: readonly ParameterInfo[];
  readonly stations: readonly StationInfo[];
  readonly contacts: readonly string[];
  /// m
  readonly lengthScale: number;
  /// rad/s of the phase that counts revolutions
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
  /// Meaning of the field; for columns their names, separated by ", ".
  readonly meaning: string;
  readonly extent: Extent;
  readonly rows: number;
  readonly columns: number;
  /// 1, or the number of stations or contacts.
  readonly repeat: number;
  /// Index of the field's first number in the block.
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
  /// True for a preview: only the whole motion decides.
  readonly provisional: boolean;
  readonly period: number;
  readonly curves: number;
  /// Revolution in which the motion diverged; 0 if it did not.
  readonly divergedAt: number;
  /// Largest Lyapunov exponent per revolution with its standard error; null without one.
  readonly exponent: number | null;
  readonly exponentError: number | null;
  readonly confidence: 'low' | 'fair' | 'high';
  /// Advice for settling the verdict, a sentence, or "".
  readonly advice: string;
}

export interface PointRequest {
  readonly setting: Setting;
  /// The varied parameter and its value in SI; absent: as in the setting.
  readonly parameter?: string;
  readonly value?: number;
  /// The batch whose options and start apply ("sweep", "detail", "response"); absent: the case's first batch.
  readonly batch?: string;
  /// Initial state [dimension]; absent: the case's.
  readonly start?: Float64Array;
}

/// Results of one motion, as fields of analyses.
export interface MotionResult {
  readonly value: number | null;
  /// Absent for orbits along branches.
  readonly verdict?: Verdict;
  readonly layout: Layout;
  readonly block: Float64Array;
  /// Length scale (m) of the machine at this value, and speed (rad/s) of the phase that counts its revolutions.
  readonly lengthScale: number;
  readonly speed: number;
  /// The element with that phase, "" for the shaft.
  readonly keyphasor: string;
  readonly stations: readonly StationInfo[];
  /// Samples of the waveform in a revolution; the last sample is at the once-per-revolution mark.
  readonly samplesPerRevolution: number;
  readonly options: Options;
  /// Wall-clock seconds in the worker.
  readonly seconds: number;
}

/// Full result of one point: fields of all analyses, with whole spectra and a waveform.
export interface PointResult extends MotionResult {
  readonly verdict: Verdict;
  /// State [dimension] at the end; StationInfo has the indices of coordinates. NaN after a divergence.
  readonly end: Float64Array;
}

/// An orbit along a branch, or an equilibrium, stable or not.
export interface OrbitRequest {
  readonly setting: Setting;
  readonly parameter: string;
  readonly value: number;
  /// Revolutions after which the orbit closes; 0: an autonomous orbit.
  readonly revolutions: number;
  /// Period in radians of the rotor's clock; 0: an equilibrium.
  readonly period: number;
  /// States at the beginnings of its segments, one after the other.
  readonly nodes: Float64Array;
}

// ---------------------------------------------------------------- diagrams

export interface SweepRequest {
  readonly setting: Setting;
  readonly parameter: string;
  /// Values in SI. Points without carry are computed in this order.
  readonly values: Float64Array;
  /// Absent: 'none'. Carried points follow one another and take one worker (two for 'both').
  readonly carry?: Carry;
  /// As in PointRequest.
  readonly batch?: string;
  /// True to compute fields of spectra too ("spectrum/synchronous", ...), which takes 10 to 20 % more time.
  readonly spectra?: boolean;
}

/// Computed points of a sweep. Slots count the values from 0; with carry 'both' the slots from values.length on belong
/// to the way back, in the order of the values too.
export interface SweepPoints {
  readonly slots: Uint32Array;
  /// [slots.length][layout.size]
  readonly blocks: Float64Array;
  readonly verdicts: readonly Verdict[];
  /// [slots.length] length scale in m at each point: the varied parameter may change it.
  readonly lengthScales: Float64Array;
}

export interface SweepProgress {
  readonly pointsDone: number;
  readonly pointsTotal: number;
  readonly revolutionsDone: number;
  readonly revolutionsTotal: number;
}

export interface SweepListener {
  /// Called once, before the first points.
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
  /// State to continue from; absent: the case's start.
  readonly state?: Float64Array;
  readonly revolutions: number;
  readonly samplesPerRevolution: number;
}

export interface TransientResult {
  /// State after the last revolution, for the next request.
  readonly state: Float64Array;
  /// State [dimension] at every sample, oldest first; StationInfo has the indices of coordinates. Samples are
  /// equidistant in time; the last sample of a revolution is at the mark.
  readonly samples: Float64Array;
  /// [samples][contacts] normal forces, 0 while open.
  readonly forces: Float64Array;
  readonly dimension: number;
  readonly contacts: number;
  /// Samples in a revolution: the smallest divisor of the number of steps that is at least the request.
  readonly samplesPerRevolution: number;
  /// Whole revolutions done: fewer than requested if the motion diverged.
  readonly revolutions: number;
  readonly diverged: boolean;
}

// ---------------------------------------------------------------- run-ups

export interface RunRequest {
  readonly setting: Setting;
  /// As in PointRequest.
  readonly parameter?: string;
  readonly value?: number;
  readonly batch?: string;
}

/// A run-up over the time, as fields of its study. While it is being computed, it is filled in up to `time`.
export interface RunResult {
  readonly layout: Layout;
  readonly block: Float64Array;
  /// Time up to which the block is filled in, and planned length of the run, s.
  readonly time: number;
  readonly duration: number;
  readonly lengthScale: number;
  readonly stations: readonly StationInfo[];
  readonly options: Options;
  /// Wall-clock seconds in the worker.
  readonly seconds: number;
}

// ---------------------------------------------------------------- cases to keep

/// An edit of a case's text. `path` is the path of a key ("parameters.r_k", "study.sweep.from"), `text` its new value;
/// without a text the key is removed.
export interface Edit {
  readonly path: string;
  readonly text?: string;
}

// ---------------------------------------------------------------- measured numbers

/// A table of measured numbers, as `study: fit` reads files.
export interface MeasuredTable {
  /// First comment of the table, or "".
  readonly title: string;
  /// The parameter that varies from row to row of vectors; "" if the speed varies, and for samples of one motion.
  readonly parameter: string;
  /// For vectors the parameter's value or the speed of every row, in SI; for samples one motion, whose value is null
  /// if its speed is not known.
  readonly motions: readonly (number | null)[];
  readonly numbers: readonly MeasuredNumber[];
}

/// Index of the motion, index of the station, direction of the probe in rad from x, quantity (MEASURED), place, and
/// value in m. The place is the order of a part, revolutions since the mark of a sample, seconds of a waveform.
export type MeasuredNumber = readonly [
  motion: number,
  station: number,
  direction: number,
  quantity: number,
  at: number,
  value: number,
];

/// Quantities of measured numbers, as in whirl_fit_quantity. A part with a lag has two numbers: cos, then sin.
export const MEASURED = { sample: 0, cos: 1, sin: 2, amplitude: 3, waveform: 4 } as const;

/// A column of a file, or of a matrix in it, that may be chosen.
export interface MeasuredColumn {
  /// Name in the file: "run/x", "signals[:, 2]", a heading.
  readonly name: string;
  /// "" if the file does not know it.
  readonly unit: string;
  /// Numbers in it.
  readonly count: number;
}

/// A column that is read, under a heading as in tables of a fit: "time [s]", "keyphasor", "disc x [um]".
export interface ChosenColumn {
  readonly heading: string;
  readonly name: string;
}

export interface MeasuredSpectrumRequest {
  /// Revolutions since a mark, growing.
  readonly turns: Float64Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
}

// ---------------------------------------------------------------- answers

/// Outcome of a request; errors are values. stale: overtaken by a later request or cancelled; bad: the case has the
/// named problems; failed: a fault of the engine.
export type Outcome<T> =
  | { readonly ok: true; readonly value: T }
  | { readonly ok: false; readonly why: 'stale' }
  | {
      readonly ok: false;
      readonly why: 'bad' | 'failed';
      readonly message: string;
      readonly problems: readonly Problem[];
    };

/// Lane and priority of a request. A new request makes all pending requests of its lane stale. Requests with a lower
/// priority number run first; sweeps take the workers that are idle.
export interface Manner {
  readonly lane?: string;
  readonly priority?: number;
  readonly signal?: AbortSignal;
}

/// The engine: a pool of workers with the C core. All promises resolve; none rejects.
export interface Engine {
  readonly workers: number;
  /// Reads and checks a case.
  describe(setting: Setting, manner?: Manner): Promise<Outcome<CaseInfo>>;
  point(request: PointRequest, manner?: Manner): Promise<Outcome<PointResult>>;
  /// Computes the orbit with these nodes, each segment from its own node, so that unstable orbits are not left.
  orbit(request: OrbitRequest, manner?: Manner): Promise<Outcome<MotionResult>>;
  sweep(request: SweepRequest, listener?: SweepListener, manner?: Manner): Promise<Outcome<SweepResult>>;
  transient(request: TransientRequest, manner?: Manner): Promise<Outcome<TransientResult>>;
  /// Computes a run in a worker of its own; `part` receives the part of the run that is computed. A new run, or endRun,
  /// ends the earlier run, whose outcome is stale.
  run(request: RunRequest, part?: (so_far: RunResult) => void): Promise<Outcome<RunResult>>;
  endRun(): void;
  /// Reads the bytes of a file of measured numbers for the machine of a case: chosen columns, or all if there are none.
  measured(
    setting: Setting,
    name: string,
    bytes: Uint8Array,
    columns: readonly ChosenColumn[],
    manner?: Manner,
  ): Promise<Outcome<MeasuredTable>>;
  /// Lists the columns of the bytes of a file.
  measuredColumns(name: string, bytes: Uint8Array, manner?: Manner): Promise<Outcome<readonly MeasuredColumn[]>>;
  /// Computes the spectrum of a measured motion: rows of order, amplitudes of x, y, forward and backward whirl, in the
  /// unit of x and y. Below 4 revolutions rows are exact parts of the whole revolutions.
  measuredSpectrum(request: MeasuredSpectrumRequest, manner?: Manner): Promise<Outcome<Float64Array>>;
  /// Writes values into the text of a case, keeps comments and layout, and checks the result. Missing keys are added to
  /// their mapping. Assignments of the setting replace the values of their parameters.
  rewrite(setting: Setting, edits: readonly Edit[], manner?: Manner): Promise<Outcome<string>>;
  /// Makes all pending requests of a lane stale; without a name, of all lanes.
  cancel(lane?: string): void;
  /// Ends the workers; pending requests become stale.
  close(): void;
}

/// Parts built by `make explorer`: build/explorer/worker.js as text, and build/explorer/whirl.wasm.
export interface EngineParts {
  readonly worker: string;
  readonly core: Uint8Array;
  /// Number of workers; absent: one for each core of the computer.
  readonly workers?: number;
  /// Called with the reason once no worker can start.
  readonly broken?: (why: string) => void;
}

/// `startEngine` of engine.ts.
export type StartEngine = (parts: EngineParts) => Engine;

/// Returns the field of a name, or undefined.
export function findField(layout: Layout, name: string): Field | undefined {
  return layout.fields.find((field) => field.name === name);
}

/// Returns the numbers [rows][columns] of a field for one station or contact (0 for fields of the point) in the block
/// at `base` of `blocks`, as a view. Empty without such a field.
export function fieldNumbers(layout: Layout, blocks: Float64Array, name: string, which = 0, base = 0): Float64Array {
  const field = findField(layout, name);
  if (!field || which >= field.repeat) return blocks.subarray(0, 0);
  const size = field.rows * field.columns;
  const first = base + field.offset + which * size;
  return blocks.subarray(first, first + size);
}
