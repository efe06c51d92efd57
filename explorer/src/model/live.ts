// Requests motions for the cursor: while it moves, one request at a time, always the newest next; when it stops, the
// whole computation.
import type { Engine, MotionResult, OrbitRequest, Outcome, PointRequest } from '../engine/protocol';
import type { Side } from './setting';

export interface Wish {
  readonly request: PointRequest | OrbitRequest;
  /// True for a preview, followed by the whole computation.
  readonly preview: boolean;
  /// The side's choice that is requested.
  readonly of: Side;
  /// The value as an assignment in the shown unit; "" if nothing is varied.
  readonly spoken: string;
}

/// Returns true for brief requests: previews, and orbits along branches, which need no further computation.
function isBrief(wish: Wish): boolean {
  return wish.preview || 'nodes' in wish.request;
}

export class LivePoint {
  private running: Wish | undefined;
  private next: Wish | undefined;

  constructor(
    private readonly engine: Engine,
    private readonly lane: string,
    private readonly done: (wish: Wish, outcome: Outcome<MotionResult>) => void,
  ) {}

  get busy(): boolean {
    return this.running !== undefined;
  }

  /// Requests a motion. A running preview or orbit is allowed to finish, so that a moving cursor shows results; a
  /// running whole computation is overtaken.
  want(wish: Wish): void {
    if (this.running && isBrief(this.running)) this.next = wish;
    else void this.run(wish);
  }

  stop(): void {
    this.next = undefined;
    this.engine.cancel(this.lane);
  }

  private async run(wish: Wish): Promise<void> {
    this.running = wish;
    const manner = { lane: this.lane, priority: isBrief(wish) ? 0 : 1 };
    const outcome =
      'nodes' in wish.request
        ? await this.engine.orbit(wish.request, manner)
        : await this.engine.point(wish.request, manner);
    if (this.running !== wish) return; // a newer request has overtaken this one
    this.running = undefined;
    const next = this.next;
    this.next = undefined;
    this.done(wish, outcome);
    if (next) this.want(next);
  }
}
