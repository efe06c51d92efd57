// A diagram computed in the page: coarse to fine where points do not follow one another, along the parameter where they do.
import { Diagram } from '../data/diagram';
import type { BatchInfo, Carry, Engine, Look, Setting, SweepProgress } from '../engine/protocol';

export interface Plan {
  readonly setting: Setting;
  readonly parameter: string;
  readonly low: number;
  readonly high: number;
  readonly points: number;
  readonly batch: BatchInfo | undefined;
  /// With what is found in spectra.
  readonly spectra: boolean;
}

/// One pass over a diagram.
export interface Pass {
  /// What is being done, for the reader; "" at the end.
  readonly text: string;
  /// Undefined: as the setting says.
  readonly look?: Look;
  /// Some points that are spread over all, each alone.
  readonly coarse?: boolean;
  /// Those that have no verdict yet, the most doubtful first.
  readonly doubtful?: boolean;
}

/// Points of a coarse pass.
const COARSE = 32;

export interface RecomputeListener {
  /// Points came in.
  grown(): void;
  progress(progress: SweepProgress): void;
}

/// 0 .. count-1 so that the first few are spread over all: both ends, then halves, quarters, ...
export function coarseToFine(count: number): number[] {
  const order: number[] = [];
  const taken = new Uint8Array(count);
  let step = 1;
  while (step < count) step *= 2;
  for (; step >= 1; step /= 2)
    for (let i = 0; i < count; i += step)
      if (!taken[i]) {
        taken[i] = 1;
        order.push(i);
      }
  if (count > 1) {
    order.splice(order.indexOf(count - 1), 1);
    order.splice(1, 0, count - 1);
  }
  return order;
}

/// The diagram that a plan will fill, points in the order of the case's own sweep.
export function awaitedDiagram(plan: Plan): Diagram {
  const { low, high, points } = plan;
  const falling = plan.batch !== undefined && plan.batch.parameter === plan.parameter && (plan.batch.values[0] ?? 0) > (plan.batch.values.at(-1) ?? 0);
  const [from, to] = falling ? [high, low] : [low, high];
  const carry = carryOf(plan);
  const ways = carry === 'both' ? [1, -1] : [carry === 'forward' ? 1 : carry === 'reverse' ? -1 : 0];
  const values = new Float64Array(points * ways.length);
  const branch = new Int8Array(values.length);
  for (let i = 0; i < values.length; i++) {
    const place = i % points;
    values[i] = points > 1 ? from + ((to - from) * place) / (points - 1) : from;
    branch[i] = ways[Math.floor(i / points)]!;
  }
  return Diagram.awaited(plan.parameter, values, branch);
}

function carryOf(plan: Plan): Carry {
  return plan.batch?.parameter === plan.parameter ? plan.batch.carry : 'none';
}

/// Places of the points of the first branch that have no verdict yet: first those whose evidence is weakest, of these the
/// least stable first.
export function doubtfulFirst(diagram: Diagram, count: number): number[] {
  const agreement = (point: number) => diagram.number(point, 'regime/agreement') || 0;
  const exponent = (point: number) => {
    const { value } = diagram.exponent(point);
    return Number.isFinite(value) ? value : Number.MAX_VALUE;
  };
  const open = coarseToFine(count).filter((point) => !diagram.done[point] || diagram.provisional[point]);
  return open.sort((a, b) => agreement(a) - agreement(b) || exponent(b) - exponent(a) || 0);
}

function orderOf(plan: Plan, pass: Pass, diagram: Diagram): number[] {
  const chained = carryOf(plan) !== 'none';
  if (pass.coarse) return coarseToFine(plan.points).slice(0, COARSE);
  if (!chained) return pass.doubtful ? doubtfulFirst(diagram, plan.points) : coarseToFine(plan.points);
  // Points that follow one another go together.
  const settled = pass.doubtful && diagram.known === diagram.count && !diagram.provisional.includes(1);
  return settled ? [] : Array.from({ length: plan.points }, (_, i) => i);
}

/// Fills the diagram; the sentence of what went wrong, "" when all went well or it was stopped.
export async function recompute(engine: Engine, plan: Plan, pass: Pass, diagram: Diagram, listener: RecomputeListener, signal: AbortSignal): Promise<string> {
  const order = orderOf(plan, pass, diagram);
  if (order.length === 0) return '';
  const outcome = await engine.sweep(
    {
      setting: { ...plan.setting, ...(pass.look ? { look: pass.look } : {}) },
      parameter: plan.parameter,
      values: Float64Array.from(order, (place) => diagram.values[place]!),
      spectra: plan.spectra,
      carry: pass.coarse ? 'none' : carryOf(plan),
      ...(plan.batch ? { batch: plan.batch.name } : {}),
    },
    {
      layout: (layout) => diagram.expect(layout),
      points: (points) => {
        diagram.take(points, (slot) => (slot < order.length ? order[slot]! : slot));
        listener.grown();
      },
      progress: (progress) => listener.progress(progress),
    },
    { lane: 'sweep', priority: 5, signal },
  );
  return outcome.ok || outcome.why === 'stale' ? '' : outcome.message;
}
