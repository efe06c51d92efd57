// Typed interface of the C core: handles, texts and numbers. explorer/core/core.h describes its functions.
import createCore, { type CoreModule } from 'whirl-core-glue';
import type {
  CaseInfo,
  ChosenColumn,
  Layout,
  Look,
  MeasuredColumn,
  MeasuredTable,
  Options,
  StationInfo,
  Verdict,
} from './protocol';
import type { Refusal } from './wire';

/// Error of a request that the core rejected, with the core's message.
export class Refused extends Error {
  constructor(readonly refusal: Refusal) {
    super(refusal.message);
  }
}

/// Columns of a row of a measured spectrum.
const COLUMNS = 5;

export interface PlanLayout {
  readonly layout: Layout;
  readonly options: Options;
  /// Revolutions of a whole motion.
  readonly revolutions: number;
  /// Samples of a stored waveform in a revolution.
  readonly waveformSamples: number;
}

export interface Machine {
  readonly lengthScale: number;
  readonly speed: number;
  readonly keyphasor: string;
  readonly stations: readonly StationInfo[];
}

export class Core {
  private constructor(private readonly module: CoreModule) {}

  static async start(binary: Uint8Array): Promise<Core> {
    return new Core(await createCore({ wasmBinary: binary, print: () => {}, printErr: () => {} }));
  }

  // -------------------------------------------------------------- memory

  /// Runs `use` with texts in the core's memory, as pointers.
  private withTexts<T>(texts: readonly string[], use: (...pointers: number[]) => T): T {
    const pointers: number[] = [];
    try {
      for (const text of texts) {
        const size = this.module.lengthBytesUTF8(text) + 1;
        const pointer = this.allocate(size);
        pointers.push(pointer);
        this.module.stringToUTF8(text, pointer, size);
      }
      return use(...pointers);
    } finally {
      for (const pointer of pointers) this.module._free(pointer);
    }
  }

  private allocate(bytes: number): number {
    const pointer = this.module._malloc(bytes);
    if (pointer === 0) throw new Refused({ message: 'there is not enough memory', problems: [] });
    return pointer;
  }

  /// Allocates `count` numbers, which the caller frees.
  numbers(count: number): number {
    return this.allocate(8 * Math.max(count, 1));
  }

  free(pointer: number): void {
    this.module._free(pointer);
  }

  write(pointer: number, values: ArrayLike<number>): void {
    this.module.HEAPF64.set(values, pointer / 8);
  }

  /// Returns a copy of numbers in the core's memory.
  read(pointer: number, count: number): Float64Array {
    return this.module.HEAPF64.slice(pointer / 8, pointer / 8 + count);
  }

  private text(pointer: number): string {
    if (pointer === 0) throw this.refused();
    return this.module.UTF8ToString(pointer);
  }

  private refused(): Refused {
    return new Refused(JSON.parse(this.module.UTF8ToString(this.module._explorer_message())) as Refusal);
  }

  private good(value: number): number {
    if (value === 0) throw this.refused();
    return value;
  }

  // -------------------------------------------------------------- cases

  caseNew(source: string, name: string): number {
    return this.withTexts([source, name], (at, nameAt) =>
      this.good(this.module._explorer_case_new(at!, this.module.lengthBytesUTF8(source), nameAt!)),
    );
  }

  caseFree(object: number): void {
    this.module._explorer_case_free(object);
  }

  assign(object: number, assignment: string): void {
    this.withTexts([assignment], (at) => this.good(this.module._explorer_assign(object, at!)));
  }

  caseText(object: number): string {
    return this.text(this.module._explorer_case_text(object));
  }

  describe(object: number): CaseInfo {
    return JSON.parse(this.text(this.module._explorer_describe(object))) as CaseInfo;
  }

  /// Edits a key of a case; without a value the key is removed.
  edit(source: string, path: string, value: string | undefined): string {
    return this.withTexts(value === undefined ? [source, path] : [source, path, value], (at, pathAt, valueAt) =>
      this.text(this.module._explorer_edit(at!, this.module.lengthBytesUTF8(source), pathAt!, valueAt ?? 0)),
    );
  }

  // -------------------------------------------------------------- measured numbers

  measured(object: number, name: string, bytes: Uint8Array, columns: readonly ChosenColumn[]): MeasuredTable {
    const lines = columns.map((column) => `${column.heading}\t${column.name}\n`).join('');
    return this.withBytes(bytes, (at) =>
      this.withTexts([name, lines], (nameAt, linesAt) =>
        JSON.parse(this.text(this.module._explorer_measured(object, nameAt!, at, bytes.length, linesAt!))),
      ),
    ) as MeasuredTable;
  }

  measuredColumns(name: string, bytes: Uint8Array): readonly MeasuredColumn[] {
    return this.withBytes(bytes, (at) =>
      this.withTexts([name], (nameAt) =>
        JSON.parse(this.text(this.module._explorer_measured_columns(nameAt!, at, bytes.length))),
      ),
    ) as MeasuredColumn[];
  }

  /// Runs `use` with the bytes of a file in the core's memory.
  private withBytes<T>(bytes: Uint8Array, use: (at: number) => T): T {
    const at = this.allocate(Math.max(bytes.length, 1));
    try {
      this.module.HEAPU8.set(bytes, at);
      return use(at);
    } finally {
      this.free(at);
    }
  }

  measuredSpectrum(turns: Float64Array, x: Float64Array, y: Float64Array): Float64Array {
    const count = turns.length;
    const most = this.module._explorer_measured_orders();
    const at = this.numbers(3 * count + COLUMNS * most);
    try {
      this.write(at, turns);
      this.write(at + 8 * count, x);
      this.write(at + 16 * count, y);
      const rows = at + 24 * count;
      return this.read(
        rows,
        COLUMNS * this.good(this.module._explorer_measured_spectrum(at, at + 8 * count, count, rows)),
      );
    } finally {
      this.free(at);
    }
  }

  // -------------------------------------------------------------- plans

  planNew(object: number, batch: string, parameter: string | undefined): number {
    return this.withTexts([batch, parameter ?? ''], (batchAt, parameterAt) =>
      this.good(this.module._explorer_plan_new(object, batchAt!, parameter === undefined ? 0 : parameterAt!)),
    );
  }

  planFree(plan: number): void {
    this.module._explorer_plan_free(plan);
  }

  planOption(plan: number, option: string, value: string | number | boolean): void {
    this.withTexts([option, String(value)], (optionAt, valueAt) =>
      this.good(
        typeof value === 'string'
          ? this.module._explorer_plan_method(plan, valueAt!)
          : this.module._explorer_plan_number(plan, optionAt!, Number(value)),
      ),
    );
  }

  /// Sets the method of a plan with `auto` to `known`, or lets the core choose; returns the method.
  planChoose(plan: number, known: string): string {
    return this.withTexts([known], (at) => this.text(this.module._explorer_plan_choose(plan, at!)));
  }

  planLook(plan: number, look: Look): void {
    this.module._explorer_plan_look(plan, look.transient, look.record, look.stepsPerRevolution);
  }

  planEverything(plan: number, waveform: number): void {
    this.module._explorer_plan_everything(plan, waveform);
  }

  planDiagram(plan: number): void {
    this.module._explorer_plan_diagram(plan);
  }

  planSpectra(plan: number): void {
    this.module._explorer_plan_spectra(plan);
  }

  planLayout(plan: number, value: number): PlanLayout {
    return JSON.parse(this.text(this.module._explorer_plan_layout(plan, value))) as PlanLayout;
  }

  dimension(plan: number): number {
    return this.module._explorer_dimension(plan);
  }

  machine(plan: number, value: number): Machine {
    return JSON.parse(this.text(this.module._explorer_machine(plan, value))) as Machine;
  }

  verdict(plan: number, block: number): Verdict {
    return JSON.parse(this.text(this.module._explorer_verdict(plan, block))) as Verdict;
  }

  // -------------------------------------------------------------- points

  /// Starts a job for some values, which it copies; `start` may be 0 (no start).
  jobNew(plan: number, values: number, count: number, carried: boolean, start: number): number {
    return this.good(this.module._explorer_job_new(plan, values, count, carried ? 1 : 0, start));
  }

  jobFree(job: number): void {
    this.module._explorer_job_free(job);
  }

  /// Advances a job; returns the number of revolutions computed, 0 at the end.
  jobTurn(job: number): number {
    const turned = this.module._explorer_job_turn(job);
    if (turned < 0) throw this.refused();
    return turned;
  }

  /// Takes a finished point; returns its index, or -1.
  jobTake(job: number, block: number, end: number): number {
    return this.module._explorer_job_take(job, block, end);
  }

  // -------------------------------------------------------------- orbits

  planOrbit(plan: number, revolutions: number): void {
    this.module._explorer_plan_orbit(plan, revolutions);
  }

  orbitSize(plan: number, revolutions: number, period: number): number {
    return this.module._explorer_orbit_size(plan, revolutions, period);
  }

  orbit(plan: number, value: number, revolutions: number, period: number, nodes: number, block: number): void {
    this.good(this.module._explorer_orbit(plan, value, revolutions, period, nodes, block));
  }

  // -------------------------------------------------------------- run-ups

  planRun(plan: number): void {
    this.module._explorer_plan_run(plan);
  }

  runDuration(plan: number): number {
    return this.module._explorer_run_duration(plan);
  }

  /// Computes a run to its end; `passed` is called after every turn with the time up to which the block is filled in.
  run(plan: number, value: number, block: number, passed: (time: number) => void): void {
    this.module.passed = passed;
    try {
      this.good(this.module._explorer_run(plan, value, block));
    } finally {
      this.module.passed = undefined;
    }
  }

  // -------------------------------------------------------------- motions

  motionNew(plan: number, value: number, state: number, samples: number): number {
    return this.good(this.module._explorer_motion_new(plan, value, state, samples));
  }

  motionFree(motion: number): void {
    this.module._explorer_motion_free(motion);
  }

  motionSamples(motion: number): number {
    return this.module._explorer_motion_samples(motion);
  }

  motionContacts(motion: number): number {
    return this.module._explorer_motion_contacts(motion);
  }

  motionTurn(motion: number, states: number, forces: number): boolean {
    return this.module._explorer_motion_turn(motion, states, forces) !== 0;
  }

  motionState(motion: number, dimension: number): Float64Array {
    return this.read(this.module._explorer_motion_state(motion), dimension);
  }
}
