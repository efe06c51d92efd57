// A diagram computed in the page: coarse to fine where points do not follow one another, along the parameter where they
// do.
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
  /// With what is found in spectra.
  readonly spectra: boolean;
  /// Points of the diagram that are wanted, along the parameter as the case goes, those of a way back right behind
  /// them; left out: all.
  readonly places?: readonly number[];
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
  // The case's own sweep has the case's own values, to the last bit.
  const swept = plan.batch?.parameter === plan.parameter ? [...plan.batch.values].sort((a, b) => a - b) : [];
  const own = swept.length === points && swept[0] === low && swept.at(-1) === high;
  const even = (i: number) => (points > 1 ? low + ((high - low) * i) / (points - 1) : low);
  const { values, branch } = along(plan, own ? swept : Array.from({ length: points }, (_, i) => even(i)));
  return Diagram.awaited(plan.parameter, values, branch);
}

/// Rising values in the order of the case's own sweep, once for every way that it goes.
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

/// The diagram with what is missing of the plan's points in its range, which lie on halves, quarters, ... of the
/// diagram's own range, so that another zoom finds them again; undefined where nothing is missing or all of it is in
/// view.
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

/// Places of the points of the first branch that have no verdict yet: first those whose evidence is weakest, of these
/// the least stable first.
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
  // Points that follow one another go together.
  const open = (point: number) => !diagram.done[point] || diagram.provisional[point] === 1;
  const back = carryOf(plan) === 'both' ? places.map((place) => place + places.length) : [];
  return !pass.doubtful || [...places, ...back].some(open) ? places : [];
}

/// Fills the diagram; the sentence of what went wrong, "" when all went well or it was stopped.
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
