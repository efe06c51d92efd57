// A diagram computed in the page: coarse to fine where points do not follow one another, along the parameter where they do.
import { Diagram } from '../data/diagram';
import type { BatchInfo, Carry, Engine, Setting, SweepProgress } from '../engine/protocol';

export interface Plan {
  readonly setting: Setting;
  readonly parameter: string;
  readonly low: number;
  readonly high: number;
  readonly points: number;
  readonly batch: BatchInfo | undefined;
}

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

/// Fills the diagram; the sentence of what went wrong, "" when all went well or it was stopped.
export async function recompute(engine: Engine, plan: Plan, diagram: Diagram, listener: RecomputeListener, signal: AbortSignal): Promise<string> {
  const carry = carryOf(plan);
  const order = carry === 'none' ? coarseToFine(plan.points) : Array.from({ length: plan.points }, (_, i) => i);
  const values = Float64Array.from(order, (place) => diagram.values[place]!);
  const outcome = await engine.sweep(
    { setting: plan.setting, parameter: plan.parameter, values, carry, ...(plan.batch ? { batch: plan.batch.name } : {}) },
    {
      layout: (layout) => diagram.expect(layout),
      points: (points) => {
        diagram.take(points, (slot) => (slot < plan.points ? order[slot]! : slot));
        listener.grown();
      },
      progress: (progress) => listener.progress(progress),
    },
    { lane: 'sweep', priority: 5, signal },
  );
  return outcome.ok || outcome.why === 'stale' ? '' : outcome.message;
}
