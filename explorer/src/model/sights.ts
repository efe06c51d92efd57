// History of visible diagrams (sights), and the diagram that is being computed.
import type { Diagram } from '../data/diagram';
import type { Engine, Setting, SweepProgress } from '../engine/protocol';
import { awaitedDiagram, finerDiagram, recompute, type Pass, type Plan } from './recompute';

type Range = readonly [number, number];

export interface Sight {
  readonly diagram: Diagram | undefined;
  readonly range: Range;
  /// The assignments with which it was computed.
  readonly of: string;
  readonly text: string;
  /// Its setting, in the form of `howOf`.
  readonly how: string;
  /// Points before the first refinement.
  readonly coarse?: number;
  /// Note on finer points, or "".
  readonly note?: string;
}

/// Returns the common setting of a diagram's points; points of other settings cannot be added.
export function howOf({ assignments, options }: Partial<Setting>): string {
  return JSON.stringify([assignments ?? [], options ?? {}]);
}

/// Quality of a diagram's computation.
export type Quality = 'draft' | 'quick' | 'case';

const MAX_LEFT = 16;
const COARSE_STEPS = 256;
const GLIMPSE: Pass = {
  text: 'a first glimpse',
  look: { transient: 24, record: 12, stepsPerRevolution: COARSE_STEPS },
  coarse: true,
};
const DRAFT: Pass = {
  text: 'undetermined until they run at full length',
  look: { transient: 100, record: 50, stepsPerRevolution: COARSE_STEPS },
};
const QUICK: Pass = {
  text: 'undetermined until they run at full length',
  look: { transient: 400, record: 100, stepsPerRevolution: COARSE_STEPS },
};
const WHOLE: Pass = { text: 'now at full length, the doubtful ones first', doubtful: true };

/// Passes of each quality, coarse to fine: points are visible soon, and verdicts are final.
const PASSES: Readonly<Record<Quality, readonly Pass[]>> = {
  draft: [GLIMPSE, DRAFT],
  quick: [GLIMPSE, QUICK, WHOLE],
  case: [GLIMPSE, WHOLE],
};

export interface SightsListener {
  /// Called after another diagram or range is shown.
  changed(): void;
  /// Called after the visible diagram has got more points.
  grown(): void;
  progress(now: SweepProgress | undefined): void;
}

export class Sights {
  /// Progress of the diagram that is being computed.
  progress: SweepProgress | undefined;
  private stack: Sight[] = [];
  /// Sights after the visible one, to which the user can go forward.
  private left: Sight[] = [];
  private sweeping: AbortController | undefined;
  /// True while finer points of a diagram are being computed.
  private refining = false;

  constructor(
    private readonly engine: Engine | undefined,
    private readonly listener: SightsListener,
  ) {}

  /// The visible sight; undefined before a machine is open.
  get shown(): Sight | undefined {
    return this.stack.at(-1);
  }

  get first(): Sight | undefined {
    return this.stack[0];
  }

  /// Number of sights behind the visible one.
  get behind(): number {
    return Math.max(0, this.stack.length - 1);
  }

  /// Starts a new history with `sight`, or empty.
  open(sight?: Sight): void {
    this.stack = sight ? [sight] : [];
    this.left = [];
    this.listener.changed();
  }

  /// Moves the view, which is at most three times as wide as the `whole` range.
  view(range: Range, whole: Range): void {
    const { shown } = this;
    const span = Math.min(range[1] - range[0], 3 * (whole[1] - whole[0]));
    if (!shown || !(span > Math.abs(range[0]) * 1e-9)) return;
    this.stack[this.behind] = { ...shown, range: [range[0], range[0] + span] };
    this.listener.changed();
  }

  /// Shows a part of the same diagram; the earlier view stays in the history.
  enlarge(range: Range): void {
    if (!this.shown) return;
    this.stack.push({ ...this.shown, range });
    this.listener.changed();
  }

  back(): void {
    if (this.behind === 0) return;
    this.stop();
    this.leave(this.behind);
    this.listener.changed();
  }

  /// Removes all sights from an index on.
  private leave(from: number): void {
    this.left = [...this.stack.splice(from).reverse(), ...this.left].slice(0, MAX_LEFT);
  }

  /// Shows an earlier range: the sight with that range if the history has it, else that part of the present diagram.
  restore(range: Range, whole: Range): void {
    const shows = (sight: Sight) =>
      sight.range.every((end, i) => Math.abs(end - range[i]!) < 1e-6 * (range[1] - range[0]));
    const at = this.stack.map(shows).lastIndexOf(true);
    if (at >= 0 && at === this.behind) return;
    this.stop();
    const again = this.left.find(shows);
    if (at >= 0) this.leave(at + 1);
    else if (again) {
      this.left = this.left.filter((sight) => sight !== again);
      this.stack.push(again);
    } else this.view(range, whole);
    this.listener.changed();
  }

  /// Returns to the first sight with its whole range.
  reset(whole: Range): void {
    this.stop();
    const { first } = this;
    if (!first) return;
    this.leave(1);
    this.stack = [{ ...first, range: whole }];
    this.listener.changed();
  }

  /// Ends the computation of a diagram; computed points stay.
  stop(): void {
    this.sweeping?.abort();
  }

  /// Computes a diagram; the earlier one stays in the history, unless `first`. Returns an error message, or "" after
  /// success or if overtaken.
  async compute(plan: Plan, quality: Quality, of: string, first: boolean): Promise<string> {
    if (!this.engine) return '';
    this.stop();
    const diagram = awaitedDiagram(plan);
    if (first) this.stack = [];
    this.stack.push({ diagram, range: [plan.low, plan.high], of, text: '', how: howOf(plan.setting) });
    return this.fill(plan, quality, diagram, false, (sight, text) => ({
      ...sight,
      text: `Computed here, ${quality}: ${diagram.count} points${text && `, ${text}`}.`,
    }));
  }

  /// True while a whole diagram is being computed.
  private get computing(): boolean {
    return this.sweeping !== undefined && !this.refining && !this.sweeping.signal.aborted;
  }

  /// Adds finer points to the visible diagram, in the visible range if that is a part of it.
  async refine(plan: Plan, quality: Quality): Promise<string> {
    if (!this.engine || this.computing) return '';
    this.stop(); // a refinement of another range may be running
    const { shown } = this;
    if (!shown?.diagram || shown.how !== howOf(plan.setting)) return '';
    const finer = finerDiagram(plan, shown.diagram);
    if (!finer) return '';
    const { diagram } = finer;
    const replace = (sight: Sight): Sight =>
      sight.diagram === shown.diagram ? { ...sight, diagram, coarse: sight.coarse ?? sight.diagram!.count } : sight;
    [this.stack, this.left] = [this.stack.map(replace), this.left.map(replace)];
    return this.fill(finer.plan, quality, diagram, true, (sight, text) => ({
      ...sight,
      note: `${diagram.known - sight.coarse!} finer points were computed here${text && `, ${text}`}.`,
    }));
  }

  /// Computes the points of a plan in passes; `say` writes the progress into the texts of its sights.
  private async fill(
    plan: Plan,
    quality: Quality,
    diagram: Diagram,
    refining: boolean,
    say: (sight: Sight, text: string) => Sight,
  ): Promise<string> {
    const mine = (this.sweeping = new AbortController());
    this.refining = refining;
    const tell = (now: SweepProgress | undefined) => {
      if (mine !== this.sweeping) return;
      this.progress = now;
      this.listener.progress(now);
    };
    const report = (text: string) => {
      this.stack = this.stack.map((sight) => (sight.diagram === diagram ? say(sight, text) : sight));
      this.listener.changed();
    };
    let trouble = '';
    for (const pass of PASSES[quality]) {
      report(pass.text);
      tell({ pointsDone: 0, pointsTotal: plan.points, revolutionsDone: 0, revolutionsTotal: 0 });
      trouble ||= await recompute(
        this.engine!,
        plan,
        pass,
        diagram,
        { grown: () => this.listener.grown(), progress: tell },
        mine.signal,
      );
      if (mine !== this.sweeping || mine.signal.aborted || trouble) break;
    }
    if (mine !== this.sweeping) return '';
    tell(undefined);
    this.sweeping = undefined;
    const open = diagram.provisional.reduce((sum, one) => sum + one, 0);
    report(open > 0 ? `${open} undetermined: they have not run at full length` : '');
    return trouble;
  }
}
