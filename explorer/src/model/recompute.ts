// Computes a diagram in the page: coarse to fine or, for carried points, along the parameter.
import { Diagram } from '../data/diagram';
import type { BatchInfo, Carry, Engine, Look, Setting, SweepProgress } from '../engine/protocol';
import { FIELD } from '../data/fields';

export interface Plan {
  readonly setting: Setting;
  readonly parameter: string;
  readonly low: number;
  readonly high: number;
  readonly points: number;
  readonly batch: BatchInfo | undefined;
  /// True to compute fields of spectra too.
  readonly spectra: boolean;
  /// Requested points of the diagram, in the case's order along the parameter, followed by the points of the way back;
  /// absent: all points.
  readonly places?: readonly number[];
}

/// One pass over a diagram.
export interface Pass {
  /// Description of the progress for the user; "" at the end.
  readonly text: string;
  /// Preview of the pass; undefined: as in the setting.
  readonly look?: Look;
  /// True for some points spread over the range, each computed alone.
  readonly coarse?: boolean;
  /// True for points without a verdict, the most doubtful first.
  readonly doubtful?: boolean;
}

/// Points of a coarse pass.
const COARSE = 32;

export interface RecomputeListener {
  /// Called after points have arrived.
  grown(): void;
  progress(progress: SweepProgress): void;
}

/// Returns 0 .. count-1 ordered coarse to fine: both ends, then halves, quarters, ...
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

/// Makes the diagram that a plan will fill, with points in the order of the case's sweep.
export function awaitedDiagram(plan: Plan): Diagram {
  const { low, high, points } = plan;
  // Use exactly the case's values for the case's sweep.
  const swept = plan.batch?.parameter === plan.parameter ? [...plan.batch.values].sort((a, b) => a - b) : [];
  const own = swept.length === points && swept[0] === low && swept.at(-1) === high;
  const even = (i: number) => (points > 1 ? low + ((high - low) * i) / (points - 1) : low);
  const { values, branch } = along(plan, own ? swept : Array.from({ length: points }, (_, i) => even(i)));
  return Diagram.awaited(plan.parameter, values, branch);
}

/// Orders rising values as the case's sweep does, once for each of its directions.
function along(plan: Plan, rising: readonly number[]): { values: Float64Array; branch: Int8Array } {
  const falling =
    plan.batch !== undefined &&
    plan.batch.parameter === plan.parameter &&
    (plan.batch.values[0] ?? 0) > (plan.batch.values.at(-1) ?? 0);
  const once = falling ? [...rising].reverse() : rising;
  const carry = carryOf(plan);
  const ways = carry === 'both' ? [1, -1] : [carry === 'forward' ? 1 : carry === 'reverse' ? -1 : 0];
  return {
    values: Float64Array.from(ways.flatMap(() => once)),
    branch: Int8Array.from(ways.flatMap((way) => once.map(() => way))),
  };
}

/// Returns the diagram with the missing points of a plan in its range added. They divide the diagram's own range into
/// halves, quarters, ..., so that other zooms find them again. Undefined if nothing is missing, or the whole range is
/// visible.
export function finerDiagram(
  plan: Plan,
  coarse: Diagram,
): { readonly diagram: Diagram; readonly plan: Plan } | undefined {
  const { points } = plan;
  const [from, to] = coarse.span;
  const [low, high] = [Math.max(plan.low, from), Math.min(plan.high, to)];
  if (!(high > low) || high - low > 0.9 * (to - from)) return undefined;
  const parts = 2 ** Math.ceil(Math.log2((points * (to - from)) / (high - low)));
  const step = (to - from) / parts;
  const inside = (value: number) => value >= low - 0.25 * step && value <= high + 0.25 * step;
  const keep = (point: number) =>
    coarse.done[point] === 1 && !(coarse.provisional[point] && inside(coarse.values[point]!));
  const there = new Set(
    Array.from(coarse.values.keys())
      .filter(keep)
      .map((point) => Math.round((coarse.values[point]! - from) / step)),
  );
  const rising: number[] = [];
  for (let i = Math.ceil((low - from) / step); i <= (high - from) / step; i++)
    if (!there.has(i)) rising.push(from + i * step);
  if (rising.length < 2) return undefined;
  const { values, branch } = along(plan, rising);
  const diagram = coarse.joined(keep, values, branch);
  const first = diagram.count - values.length;
  return { diagram, plan: { ...plan, points: rising.length, places: rising.map((_, i) => first + i) } };
}

function carryOf(plan: Plan): Carry {
  return plan.batch?.parameter === plan.parameter ? plan.batch.carry : 'none';
}

/// Returns the points of the first branch without a verdict: those with the weakest evidence first, among these the
/// least stable first.
export function doubtfulFirst(diagram: Diagram, places: readonly number[]): number[] {
  const agreement = (point: number) => diagram.number(point, FIELD.REGIME_AGREEMENT) || 0;
  const exponent = (point: number) => {
    const { value } = diagram.exponent(point);
    return Number.isFinite(value) ? value : Number.MAX_VALUE;
  };
  const open = spread(places).filter((point) => !diagram.done[point] || diagram.provisional[point]);
  return open.sort((a, b) => agreement(a) - agreement(b) || exponent(b) - exponent(a) || 0);
}

function spread(places: readonly number[]): number[] {
  return coarseToFine(places.length).map((i) => places[i]!);
}

function placesOf(plan: Plan): readonly number[] {
  return plan.places ?? Array.from({ length: plan.points }, (_, i) => i);
}

function orderOf(plan: Plan, pass: Pass, diagram: Diagram): readonly number[] {
  const places = placesOf(plan);
  const chained = carryOf(plan) !== 'none';
  if (pass.coarse) return spread(places).slice(0, COARSE);
  if (!chained) return pass.doubtful ? doubtfulFirst(diagram, places) : spread(places);
  // Compute carried points together.
  const open = (point: number) => !diagram.done[point] || diagram.provisional[point] === 1;
  const back = carryOf(plan) === 'both' ? places.map((place) => place + places.length) : [];
  return !pass.doubtful || [...places, ...back].some(open) ? places : [];
}

/// Fills the diagram; returns an error message, or "" after success or a stop.
export async function recompute(
  engine: Engine,
  plan: Plan,
  pass: Pass,
  diagram: Diagram,
  listener: RecomputeListener,
  signal: AbortSignal,
): Promise<string> {
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
        diagram.take(points, (slot) =>
          slot < order.length ? order[slot]! : order[slot - order.length]! + order.length,
        );
        listener.grown();
      },
      progress: (progress) => listener.progress(progress),
    },
    { lane: 'sweep', priority: 5, signal },
  );
  return outcome.ok || outcome.why === 'stale' ? '' : outcome.message;
}
