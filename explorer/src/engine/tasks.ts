// Tasks of a worker, as generators that yield whenever another task may run first.
import { Refused, type Core } from './core';
import type {
  ChosenColumn,
  Edit,
  MeasuredSpectrumRequest,
  MotionResult,
  Options,
  OrbitRequest,
  PointRequest,
  PointResult,
  RunRequest,
  RunResult,
  Setting,
  TransientRequest,
  TransientResult,
} from './protocol';
import type { Answer, FromWorker, PartRequest, Task } from './wire';

/// Default revolutions of a point's waveform.
const USUAL_WAVEFORM = 20;
const MAX_CASES = 4;
const MAX_CHOICES = 32;
/// Milliseconds between two reports of a diagram's points: about two frames.
const REPORT_EVERY = 30;

type Post = (message: FromWorker, transfer?: Transferable[]) => void;

export type Steps = Generator<void, Answer, void>;

export class Tasks {
  /// Parsed cases by text and assignments, the last used one at the end.
  private readonly cases = new Map<string, number>();
  /// Cases in use by running jobs, with the number of these jobs.
  private readonly inUse = new Map<number, number>();
  /// Recent choices of the method `auto`, by setting and batch, and by the text of the case. A choice takes the time of
  /// some revolutions, so that parts of a diagram and previews reuse it.
  private readonly methods = new Map<string, string>();

  constructor(
    private readonly core: Core,
    private readonly post: Post,
  ) {}

  run(id: number, task: Task): Steps {
    switch (task.kind) {
      case 'describe':
        return this.describe(task.setting);
      case 'point':
        return this.point(task.request);
      case 'orbit':
        return this.orbit(task.request);
      case 'part':
        return this.part(id, task.request);
      case 'transient':
        return this.transient(task.request);
      case 'run':
        return this.runUp(id, task.request);
      case 'measured':
        return this.measured(task.setting, task.name, task.bytes, task.columns);
      case 'measured-columns':
        return this.measuredColumns(task.name, task.bytes);
      case 'measured-spectrum':
        return this.measuredSpectrum(task.request);
      case 'rewrite':
        return this.rewrite(task.setting, task.edits);
    }
  }

  // -------------------------------------------------------------- cases

  private open(setting: Setting): number {
    const assignments = setting.assignments ?? [];
    const key = JSON.stringify([setting.text, setting.name ?? '', assignments]);
    const object = this.cases.get(key) ?? this.parse(setting, assignments);
    this.cases.delete(key);
    this.cases.set(key, object);
    for (const [old, pointer] of this.cases) {
      if (this.cases.size <= MAX_CASES) break;
      if (pointer === object || this.inUse.has(pointer)) continue;
      this.cases.delete(old);
      this.core.caseFree(pointer);
    }
    return object;
  }

  private parse(setting: Setting, assignments: readonly string[]): number {
    const object = this.core.caseNew(setting.text, setting.name ?? 'case.yaml');
    try {
      for (const assignment of assignments) this.core.assign(object, assignment);
      return object;
    } catch (error) {
      this.core.caseFree(object);
      throw error;
    }
  }

  /// Runs `use` with a plan of the setting; keeps the case until it ends.
  private *withPlan<T>(
    setting: Setting,
    batch: string | undefined,
    parameter: string | undefined,
    use: (plan: number) => Generator<void, T, void>,
  ): Generator<void, T, void> {
    const object = this.open(setting);
    const plan = this.core.planNew(object, batch ?? '', parameter);
    this.inUse.set(object, (this.inUse.get(object) ?? 0) + 1);
    try {
      const options: Record<string, Options[string] | undefined> = { ...setting.options };
      // Let the engine choose the observed revolutions, since those of the case were for another length of the motion.
      if (options['transient'] !== undefined || options['record'] !== undefined) options['watch'] ??= 0;
      for (const [option, value] of Object.entries(options))
        if (value !== undefined) this.core.planOption(plan, option, value);
      this.choose(plan, setting, batch);
      if (setting.look) this.core.planLook(plan, setting.look);
      return yield* use(plan);
    } finally {
      this.core.planFree(plan);
      const left = (this.inUse.get(object) ?? 1) - 1;
      if (left > 0) this.inUse.set(object, left);
      else this.inUse.delete(object);
    }
  }

  private choose(plan: number, { text, assignments, options, look }: Setting, batch: string | undefined): void {
    const any = JSON.stringify([text, batch, options?.method]);
    const own = JSON.stringify([any, assignments]);
    const method = this.core.planChoose(plan, this.methods.get(own) ?? (look && this.methods.get(any)) ?? '');
    if (!look) this.methods.set(own, method);
    this.methods.set(any, method);
    for (const old of this.methods.keys()) if (this.methods.size > MAX_CHOICES) this.methods.delete(old);
  }

  private *describe(setting: Setting): Steps {
    return this.core.describe(this.open(setting));
  }

  private *measured(setting: Setting, name: string, bytes: Uint8Array, columns: readonly ChosenColumn[]): Steps {
    return this.core.measured(this.open(setting), name, bytes, columns);
  }

  private *measuredColumns(name: string, bytes: Uint8Array): Steps {
    return this.core.measuredColumns(name, bytes);
  }

  private *measuredSpectrum({ turns, x, y }: MeasuredSpectrumRequest): Steps {
    return this.core.measuredSpectrum(turns, x, y);
  }

  private *rewrite(setting: Setting, edits: readonly Edit[]): Steps {
    const nameOf = (assignment: string) => assignment.slice(0, assignment.indexOf('=')).trim();
    const isKey = (assignment: string) => nameOf(assignment).includes('.');
    const assignments = setting.assignments ?? [];
    let text = this.core.caseText(this.open({ ...setting, assignments: assignments.filter(isKey) }));
    for (const assignment of assignments.filter((each) => !isKey(each)))
      text = this.core.edit(
        text,
        `parameters.${nameOf(assignment)}`,
        assignment.slice(assignment.indexOf('=') + 1).trim(),
      );
    for (const edit of edits) text = this.core.edit(text, edit.path, edit.text);
    yield;
    this.core.caseFree(this.core.caseNew(text, setting.name ?? 'case.yaml'));
    return text;
  }

  // -------------------------------------------------------------- points

  private *point(request: PointRequest): Steps {
    const began = performance.now();
    const core = this.core;
    const value = request.value ?? NaN;
    // Without a value, use that of the case, and vary nothing.
    const parameter = request.value === undefined ? '' : request.parameter;
    return yield* this.withPlan(request.setting, request.batch, parameter, function* (plan) {
      core.planEverything(plan, request.setting.options?.waveform_revolutions ?? USUAL_WAVEFORM);
      const planned = core.planLayout(plan, value);
      const size = planned.layout.size;
      const dimension = core.dimension(plan);
      const room = core.numbers(size + 2 * dimension + 1);
      const end = room + 8 * size;
      const start = end + 8 * dimension;
      let job = 0;
      try {
        core.write(start + 8 * dimension, [value]);
        if (request.start) core.write(start, request.start.subarray(0, dimension));
        job = core.jobNew(plan, start + 8 * dimension, 1, false, request.start ? start : 0);
        while (core.jobTurn(job) > 0) yield;
        core.jobTake(job, room, end);
        return {
          value: Number.isNaN(value) ? null : value,
          verdict: core.verdict(plan, room),
          layout: planned.layout,
          block: core.read(room, size),
          ...core.machine(plan, value),
          samplesPerRevolution: planned.waveformSamples,
          end: core.read(end, dimension),
          options: planned.options,
          seconds: (performance.now() - began) / 1000,
        } satisfies PointResult;
      } finally {
        core.jobFree(job);
        core.free(room);
      }
    });
  }

  private *part(id: number, request: PartRequest): Steps {
    const { core, post } = this;
    const count = request.values.length;
    return yield* this.withPlan(request.setting, request.batch, request.parameter, function* (plan) {
      core.planDiagram(plan);
      if (request.spectra) core.planSpectra(plan);
      const planned = core.planLayout(plan, request.values[0] ?? NaN);
      const size = planned.layout.size;
      post({ kind: 'layout', id, layout: { layout: planned.layout, revolutions: planned.revolutions } });
      const room = core.numbers(size + count);
      let job = 0;
      try {
        core.write(room + 8 * size, request.values);
        job = core.jobNew(plan, room + 8 * size, count, request.carried, 0);
        let unreported = 0;
        let reported = performance.now();
        const report = () => {
          const points = takePoints(core, plan, job, room, size, request.values);
          if (points.indices.length > 0)
            post({ kind: 'points', id, points }, [
              points.indices.buffer,
              points.blocks.buffer,
              points.lengthScales.buffer,
            ]);
          post({ kind: 'revolutions', id, count: unreported });
          unreported = 0;
          reported = performance.now();
        };
        for (let turned = core.jobTurn(job); turned > 0; turned = core.jobTurn(job)) {
          unreported += turned;
          if (performance.now() - reported > REPORT_EVERY) report();
          yield;
        }
        report();
        return null;
      } finally {
        core.jobFree(job);
        core.free(room);
      }
    });
  }

  // -------------------------------------------------------------- orbits along branches

  /// Computes an orbit without yields, as it takes only a few revolutions.
  private *orbit(request: OrbitRequest): Steps {
    const began = performance.now();
    const { core } = this;
    const { value, revolutions, period, nodes } = request;
    return yield* this.withPlan(request.setting, 'branch', request.parameter, function* (plan) {
      core.planOrbit(plan, revolutions);
      const planned = core.planLayout(plan, value);
      const { size } = planned.layout;
      const wanted = core.orbitSize(plan, revolutions, period);
      if (wanted !== nodes.length)
        throw new Refused({ message: `an orbit of ${nodes.length} numbers, expected ${wanted}`, problems: [] });
      const room = core.numbers(size + wanted);
      yield;
      try {
        core.write(room + 8 * size, nodes);
        core.orbit(plan, value, revolutions, period, room + 8 * size, room);
        return {
          value,
          layout: planned.layout,
          block: core.read(room, size),
          ...core.machine(plan, value),
          samplesPerRevolution: planned.waveformSamples,
          options: planned.options,
          seconds: (performance.now() - began) / 1000,
        } satisfies MotionResult;
      } finally {
        core.free(room);
      }
    });
  }

  // -------------------------------------------------------------- run-ups

  /// Computes a run in one piece; the engine ends the worker to stop it.
  private *runUp(id: number, request: RunRequest): Steps {
    const began = performance.now();
    const { core, post } = this;
    const value = request.value ?? NaN;
    const parameter = request.value === undefined ? '' : request.parameter;
    return yield* this.withPlan(request.setting, request.batch, parameter, function* (plan) {
      core.planRun(plan);
      const { layout, options } = core.planLayout(plan, value);
      const { lengthScale, stations } = core.machine(plan, value);
      const duration = core.runDuration(plan);
      const room = core.numbers(layout.size);
      const seconds = () => (performance.now() - began) / 1000;
      const soFar = (time: number): RunResult => ({
        ...{ layout, options, lengthScale, stations, duration, time },
        block: core.read(room, layout.size),
        seconds: seconds(),
      });
      let reported = performance.now();
      yield;
      try {
        core.run(plan, value, room, (time) => {
          if (performance.now() - reported < REPORT_RUN_EVERY) return;
          reported = performance.now();
          const run = soFar(time);
          post({ kind: 'run', id, run }, [run.block.buffer as ArrayBuffer]);
        });
        return soFar(duration);
      } finally {
        core.free(room);
      }
    });
  }

  // -------------------------------------------------------------- motions

  private *transient(request: TransientRequest): Steps {
    const core = this.core;
    const value = request.value ?? NaN;
    const parameter = request.value === undefined ? '' : request.parameter;
    return yield* this.withPlan(request.setting, request.batch, parameter, function* (plan) {
      core.planLayout(plan, value);
      const dimension = core.dimension(plan);
      const state = core.numbers(dimension);
      let motion = 0;
      let room = 0;
      try {
        if (request.state) core.write(state, request.state.subarray(0, dimension));
        motion = core.motionNew(plan, value, request.state ? state : 0, request.samplesPerRevolution);
        const perRevolution = core.motionSamples(motion);
        const contacts = core.motionContacts(motion);
        const total = perRevolution * request.revolutions;
        room = core.numbers(total * (dimension + contacts));
        const forces = room + 8 * total * dimension;
        let revolutions = 0;
        let bounded = true;
        while (bounded && revolutions < request.revolutions) {
          const before = revolutions * perRevolution;
          bounded = core.motionTurn(motion, room + 8 * before * dimension, forces + 8 * before * contacts);
          if (bounded) revolutions++;
          yield;
        }
        const samples = revolutions * perRevolution;
        return {
          state: core.motionState(motion, dimension),
          samples: core.read(room, samples * dimension),
          forces: core.read(forces, samples * contacts),
          dimension,
          contacts,
          samplesPerRevolution: perRevolution,
          revolutions,
          diverged: !bounded,
        } satisfies TransientResult;
      } finally {
        core.motionFree(motion);
        if (room !== 0) core.free(room);
        core.free(state);
      }
    });
  }
}

/// Milliseconds between two reports of a run, whose blocks are large.
const REPORT_RUN_EVERY = 150;

/// Returns all finished points of a job that were not taken yet.
function takePoints(core: Core, plan: number, job: number, room: number, size: number, values: Float64Array) {
  const indices: number[] = [];
  const blocks: Float64Array[] = [];
  const verdicts = [];
  for (let index = core.jobTake(job, room, 0); index >= 0; index = core.jobTake(job, room, 0)) {
    indices.push(index);
    blocks.push(core.read(room, size));
    verdicts.push(core.verdict(plan, room));
  }
  const all = new Float64Array(indices.length * size);
  blocks.forEach((block, i) => all.set(block, i * size));
  const lengthScales = Float64Array.from(indices, (index) => core.machine(plan, values[index]!).lengthScale);
  return { indices: Uint32Array.from(indices), blocks: all, verdicts, lengthScales };
}
