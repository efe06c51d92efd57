// The diagrams that were looked at, one behind the other, and the one that is being computed.
import type { Diagram } from '../data/diagram';
import type { Engine, Setting, SweepProgress } from '../engine/protocol';
import { awaitedDiagram, recompute, type Plan } from './recompute';

type Range = readonly [number, number];

export interface Sight {
  readonly diagram: Diagram | undefined;
  readonly range: Range;
  /// The assignments that it was computed with.
  readonly of: string;
  readonly text: string;
}

/// How well a diagram is computed.
export type Quality = 'draft' | 'quick' | 'case';

const LENGTHS = { draft: { transient: 100, record: 50, settle: true }, quick: { transient: 400, record: 100, settle: true } } as const;
const DRAFT_STEPS = 256;

function drafted(setting: Setting, quality: Quality): Setting {
  if (quality === 'case') return setting;
  return { ...setting, integrate: { stepsPerRevolution: DRAFT_STEPS, ...setting.integrate }, record: { ...LENGTHS[quality], ...setting.record } };
}

export interface SightsListener {
  /// Another diagram or range is shown.
  changed(): void;
  /// The diagram that is shown has more points.
  grown(): void;
  progress(now: SweepProgress | undefined): void;
}

export class Sights {
  /// Of the diagram that is being computed.
  progress: SweepProgress | undefined;
  private stack: Sight[] = [];
  private sweeping: AbortController | undefined;

  constructor(
    private readonly engine: Engine | undefined,
    private readonly listener: SightsListener,
  ) {}

  /// The one that is shown; undefined before a machine is open.
  get shown(): Sight | undefined {
    return this.stack.at(-1);
  }

  get first(): Sight | undefined {
    return this.stack[0];
  }

  /// How many lie behind the one that is shown.
  get behind(): number {
    return Math.max(0, this.stack.length - 1);
  }

  /// Begins with `sight`, or with nothing.
  open(sight?: Sight): void {
    this.stack = sight ? [sight] : [];
    this.listener.changed();
  }

  /// Moves the view, which is never wider than three times the `whole` range.
  view(range: Range, whole: Range): void {
    const { shown } = this;
    const span = Math.min(range[1] - range[0], 3 * (whole[1] - whole[0]));
    if (!shown || !(span > Math.abs(range[0]) * 1e-9)) return;
    this.stack[this.behind] = { ...shown, range: [range[0], range[0] + span] };
    this.listener.changed();
  }

  /// Shows a part of the same diagram; the view before stays behind it.
  enlarge(range: Range): void {
    if (!this.shown) return;
    this.stack.push({ ...this.shown, range });
    this.listener.changed();
  }

  back(): void {
    if (this.behind === 0) return;
    this.stop();
    this.stack.pop();
    this.listener.changed();
  }

  /// Back to the first one, all of it.
  reset(whole: Range): void {
    this.stop();
    if (this.first) this.open({ ...this.first, range: whole });
  }

  /// Ends the computation of a diagram; what there is of it stays.
  stop(): void {
    this.sweeping?.abort();
  }

  /// Computes a diagram; the one before stays behind it, unless this is to be the first. Gives the sentence of what went
  /// wrong, "" when nothing did or it was overtaken.
  async compute(plan: Plan, quality: Quality, of: string, first: boolean): Promise<string> {
    if (!this.engine) return '';
    this.stop();
    const mine = (this.sweeping = new AbortController());
    const diagram = awaitedDiagram(plan);
    if (first) this.stack = [];
    this.stack.push({ diagram, range: [plan.low, plan.high], of, text: `Computed here, ${quality}: ${diagram.count} points.` });
    const tell = (now: SweepProgress | undefined) => {
      if (mine !== this.sweeping) return;
      this.progress = now;
      this.listener.progress(now);
    };
    tell({ pointsDone: 0, pointsTotal: diagram.count, revolutionsDone: 0, revolutionsTotal: 0 });
    this.listener.changed();
    const drawn = { ...plan, setting: drafted(plan.setting, quality) };
    const trouble = await recompute(this.engine, drawn, diagram, { grown: () => this.listener.grown(), progress: tell }, mine.signal);
    if (mine !== this.sweeping) return '';
    tell(undefined);
    this.sweeping = undefined;
    this.listener.changed();
    return trouble;
  }
}
