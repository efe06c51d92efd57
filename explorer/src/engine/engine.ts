// The engine: a pool of workers, each with its own core. Workers are made from the text of their program, so that the
// page works from disk.
import type {
  CaseInfo,
  ChosenColumn,
  Edit,
  Engine,
  EngineParts,
  Layout,
  Manner,
  MeasuredColumn,
  MeasuredSpectrumRequest,
  MeasuredTable,
  MotionResult,
  OrbitRequest,
  Outcome,
  PointRequest,
  PointResult,
  RunRequest,
  RunResult,
  Setting,
  SweepListener,
  SweepRequest,
  SweepResult,
  TransientRequest,
  TransientResult,
} from './protocol';
import { partsOf, type Part } from './sweep';
import type { FromWorker, PartLayout, PartPoints, Refusal, Task, ToWorker } from './wire';

const STALE = { ok: false, why: 'stale' } as const;
const MAX_WORKERS = 16;
/// Priority of sweeps: after all requests for which the user waits.
const SWEEP_PRIORITY = 10;

function failed(message: string): { ok: false; why: 'failed'; message: string; problems: [] } {
  return { ok: false, why: 'failed', message, problems: [] };
}

/// A task that was sent to a worker, with its callbacks.
interface Pending {
  readonly id: number;
  readonly task: Task;
  readonly priority: number;
  readonly lane: string | undefined;
  settle(outcome: Outcome<unknown>): void;
  layout?(layout: PartLayout): void;
  points?(points: PartPoints): void;
  revolutions?(count: number): void;
  run?(so_far: RunResult): void;
}

/// A worker and its tasks.
class Seat {
  readonly pending = new Map<number, Pending>();
  /// Reason why the worker cannot work, or "".
  broken = '';
  private readonly worker: Worker;

  constructor(url: string, core: Uint8Array, hear: (seat: Seat, message: FromWorker) => void) {
    this.worker = new Worker(url);
    this.worker.onmessage = (event: MessageEvent<FromWorker>) => hear(this, event.data);
    this.worker.onerror = (event) =>
      hear(this, { kind: 'failed', id: -1, message: event.message || 'the browser does not let workers start' });
    this.send({ kind: 'start', core });
  }

  private send(message: ToWorker): void {
    this.worker.postMessage(message);
  }

  begin(pending: Pending): void {
    if (this.broken) return pending.settle(failed(this.broken));
    this.pending.set(pending.id, pending);
    this.send({ kind: 'task', id: pending.id, priority: pending.priority, task: pending.task });
  }

  stop(id: number): void {
    if (this.pending.delete(id)) this.send({ kind: 'stop', id });
  }

  /// Returns the number of tasks that precede a task of a priority.
  before(priority: number): number {
    let count = 0;
    for (const one of this.pending.values()) if (one.priority <= priority) count++;
    return count;
  }

  end(): void {
    this.worker.terminate();
  }
}

class Pool implements Engine {
  private readonly seats: Seat[] = [];
  private readonly url: string;
  private readonly core: Uint8Array;
  private readonly broken: ((why: string) => void) | undefined;
  /// The worker of run-ups. It computes a run in one piece; ending the worker ends the run.
  private runner: Seat | undefined;
  private nextId = 0;
  private closed = false;
  /// Parts of sweeps that no worker has started, in their order.
  private readonly waiting: Pending[] = [];

  constructor(parts: EngineParts) {
    this.url = URL.createObjectURL(new Blob([parts.worker], { type: 'text/javascript' }));
    this.core = parts.core;
    this.broken = parts.broken;
    const cores = typeof navigator === 'undefined' ? 1 : navigator.hardwareConcurrency;
    const count = Math.min(Math.max(parts.workers ?? cores ?? 1, 1), MAX_WORKERS);
    for (let i = 0; i < count; i++) this.seats.push(this.newSeat());
  }

  get workers(): number {
    return this.seats.length;
  }

  private newSeat(): Seat {
    return new Seat(this.url, this.core, (seat, message) => this.hear(seat, message));
  }

  // -------------------------------------------------------------- tasks

  private hear(seat: Seat, message: FromWorker): void {
    const pending = seat.pending.get(message.id);
    if (message.kind === 'failed') return this.lose(seat, message.message, pending !== undefined);
    if (!pending) return; // the task is stale
    if (message.kind === 'layout') return pending.layout?.(message.layout);
    if (message.kind === 'points') return pending.points?.(message.points);
    if (message.kind === 'revolutions') return pending.revolutions?.(message.count);
    if (message.kind === 'run') return pending.run?.(message.run);
    seat.pending.delete(message.id);
    this.feed();
    pending.settle(message.kind === 'done' ? { ok: true, value: message.value } : refused(message.refusal));
  }

  /// Handles a broken worker. If its core failed in a task, its tasks fail and a new worker replaces it; a worker that
  /// could not start is not replaced.
  private lose(seat: Seat, message: string, started: boolean): void {
    if (seat === this.runner) return this.dropRunner(failed(message));
    const at = this.seats.indexOf(seat);
    if (at < 0 || this.closed) return;
    const lost = [...seat.pending.values()];
    seat.pending.clear();
    seat.broken = message;
    seat.end();
    if (started) this.seats[at] = this.newSeat();
    for (const pending of lost) pending.settle(failed(message));
    if (!started) while (this.waiting.length > 0) this.waiting.shift()!.settle(failed(message));
    if (this.seats.every((one) => one.broken)) this.broken?.(message);
  }

  /// Ends the worker of run-ups with its runs.
  private dropRunner(outcome: Outcome<never>): void {
    const lost = [...(this.runner?.pending.values() ?? [])];
    this.runner?.end();
    this.runner = undefined;
    for (const pending of lost) pending.settle(outcome);
  }

  private begin(pending: Pending): void {
    let best = this.seats[0];
    for (const seat of this.seats)
      if (best && seat.before(pending.priority) < best.before(pending.priority)) best = seat;
    best?.begin(pending);
  }

  /// Gives parts of sweeps to idle workers.
  private feed(): void {
    for (const seat of this.seats) {
      if (this.waiting.length === 0) return;
      if (![...seat.pending.values()].some((one) => one.task.kind === 'part')) seat.begin(this.waiting.shift()!);
    }
  }

  private overtake(stale: (pending: Pending) => boolean): void {
    const lost = this.waiting.filter(stale);
    for (const one of lost) this.waiting.splice(this.waiting.indexOf(one), 1);
    for (const seat of this.seats)
      for (const one of [...seat.pending.values()].filter(stale)) {
        seat.stop(one.id);
        lost.push(one);
      }
    this.feed();
    for (const one of lost) one.settle(STALE);
  }

  private ask<T>(task: Task, manner: Manner = {}): Promise<Outcome<T>> {
    const { lane, priority = 0, signal } = manner;
    if (this.closed || signal?.aborted) return Promise.resolve(STALE);
    if (lane !== undefined) this.cancel(lane);
    return new Promise((resolve) => {
      const id = this.nextId++;
      const abort = () => this.overtake((one) => one.id === id);
      const settle = (outcome: Outcome<unknown>) => {
        signal?.removeEventListener('abort', abort);
        resolve(outcome as Outcome<T>);
      };
      signal?.addEventListener('abort', abort);
      this.begin({ id, task, priority, lane, settle });
    });
  }

  // -------------------------------------------------------------- requests

  describe(setting: Setting, manner?: Manner): Promise<Outcome<CaseInfo>> {
    return this.ask({ kind: 'describe', setting }, manner);
  }

  point(request: PointRequest, manner?: Manner): Promise<Outcome<PointResult>> {
    return this.ask({ kind: 'point', request }, manner);
  }

  orbit(request: OrbitRequest, manner?: Manner): Promise<Outcome<MotionResult>> {
    return this.ask({ kind: 'orbit', request }, manner);
  }

  transient(request: TransientRequest, manner?: Manner): Promise<Outcome<TransientResult>> {
    return this.ask({ kind: 'transient', request }, manner);
  }

  run(request: RunRequest, part?: (so_far: RunResult) => void): Promise<Outcome<RunResult>> {
    if (this.closed) return Promise.resolve(STALE);
    this.endRun();
    return new Promise((resolve) => {
      this.runner ??= this.newSeat();
      this.runner.begin({
        id: this.nextId++,
        task: { kind: 'run', request },
        priority: 0,
        lane: undefined,
        settle: (outcome) => resolve(outcome as Outcome<RunResult>),
        ...(part ? { run: part } : {}),
      });
    });
  }

  endRun(): void {
    if (this.runner && this.runner.pending.size > 0) this.dropRunner(STALE);
  }

  measured(
    setting: Setting,
    name: string,
    bytes: Uint8Array,
    columns: readonly ChosenColumn[],
    manner?: Manner,
  ): Promise<Outcome<MeasuredTable>> {
    return this.ask({ kind: 'measured', setting, name, bytes, columns }, manner);
  }

  measuredColumns(name: string, bytes: Uint8Array, manner?: Manner): Promise<Outcome<readonly MeasuredColumn[]>> {
    return this.ask({ kind: 'measured-columns', name, bytes }, manner);
  }

  measuredSpectrum(request: MeasuredSpectrumRequest, manner?: Manner): Promise<Outcome<Float64Array>> {
    return this.ask({ kind: 'measured-spectrum', request }, manner);
  }

  rewrite(setting: Setting, edits: readonly Edit[], manner?: Manner): Promise<Outcome<string>> {
    return this.ask({ kind: 'rewrite', setting, edits }, manner);
  }

  sweep(request: SweepRequest, listener: SweepListener = {}, manner: Manner = {}): Promise<Outcome<SweepResult>> {
    const { lane, priority = SWEEP_PRIORITY, signal } = manner;
    if (this.closed || signal?.aborted) return Promise.resolve(STALE);
    if (lane !== undefined) this.cancel(lane);
    const carry = request.carry ?? 'none';
    const parts = partsOf(request.values.length, carry);
    if (parts.length === 0) return Promise.resolve(failed('the sweep has no points'));
    return new Promise((resolve) => {
      const sweep = new Sweep(request, parts, listener, (outcome) => {
        signal?.removeEventListener('abort', stop);
        this.overtake((one) => sweep.owns(one));
        resolve(outcome);
      });
      const stop = () => sweep.settle(STALE);
      signal?.addEventListener('abort', stop);
      for (const part of parts) this.waiting.push(sweep.pendingFor(part, this.nextId++, priority, lane));
      this.feed();
    });
  }

  cancel(lane?: string): void {
    this.overtake((one) => lane === undefined || one.lane === lane);
  }

  close(): void {
    this.closed = true;
    this.cancel();
    this.dropRunner(STALE);
    for (const seat of this.seats) seat.end();
    URL.revokeObjectURL(this.url);
  }
}

function refused(refusal: Refusal): Outcome<never> {
  return { ok: false, why: 'bad', message: refusal.message, problems: refusal.problems };
}

/// A running sweep; its parts report to it.
class Sweep {
  private readonly began = performance.now();
  private readonly own = new Set<Pending>();
  private layout: Layout | null = null;
  private partsLeft: number;
  private settled = false;
  private pointsDone = 0;
  private revolutionsDone = 0;
  private revolutionsEach = 0;
  private readonly slots: number;

  constructor(
    private readonly request: SweepRequest,
    parts: readonly Part[],
    private readonly listener: SweepListener,
    private readonly over: (outcome: Outcome<SweepResult>) => void,
  ) {
    this.partsLeft = parts.length;
    this.slots = parts.reduce((sum, part) => sum + part.slots.length, 0);
  }

  owns(pending: Pending): boolean {
    return this.own.has(pending);
  }

  settle(outcome: Outcome<SweepResult>): void {
    if (this.settled) return;
    this.settled = true;
    this.over(outcome);
  }

  pendingFor(part: Part, id: number, priority: number, lane: string | undefined): Pending {
    const { setting, parameter, batch, values, spectra = false } = this.request;
    const count = values.length;
    const task: Task = {
      kind: 'part',
      request: {
        setting,
        parameter,
        batch,
        values: Float64Array.from(part.slots, (slot) => values[slot % count]!),
        carried: part.carried,
        spectra,
      },
    };
    const pending: Pending = {
      id,
      task,
      priority,
      lane,
      layout: (layout) => this.hearLayout(layout),
      points: (points) => this.hearPoints(part, points),
      revolutions: (done) => this.hearRevolutions(done),
      settle: (outcome) => {
        if (!outcome.ok) this.settle(outcome);
        else if (--this.partsLeft === 0 && this.layout)
          this.settle({ ok: true, value: { layout: this.layout, seconds: (performance.now() - this.began) / 1000 } });
      },
    };
    this.own.add(pending);
    return pending;
  }

  private hearLayout(part: PartLayout): void {
    if (this.layout || this.settled) return;
    this.layout = part.layout;
    this.revolutionsEach = part.revolutions;
    this.listener.layout?.(part.layout, this.slots);
  }

  private hearPoints(part: Part, points: PartPoints): void {
    if (this.settled) return;
    this.pointsDone += points.indices.length;
    const slots = points.indices.map((index) => part.slots[index]!);
    this.listener.points?.({ ...points, slots });
    this.hearRevolutions(0);
  }

  private hearRevolutions(done: number): void {
    if (this.settled) return;
    this.revolutionsDone += done;
    this.listener.progress?.({
      pointsDone: this.pointsDone,
      pointsTotal: this.slots,
      revolutionsDone: this.revolutionsDone,
      revolutionsTotal: this.slots * this.revolutionsEach,
    });
  }
}

/// Starts the workers; requests may follow at once.
export function startEngine(parts: EngineParts): Engine {
  return new Pool(parts);
}
