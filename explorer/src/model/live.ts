// Motions on demand: while the cursor moves, one request at a time, the newest next; when it rests, the whole
// computation.
import type { Engine, MotionResult, OrbitRequest, Outcome, PointRequest } from '../engine/protocol';
import type { Side } from './setting';

export interface Wish {
  readonly request: PointRequest | OrbitRequest;
  /// A quick look, to be followed by the whole.
  readonly preview: boolean;
  /// What it is of.
  readonly of: Side;
  /// The value as an assignment in the unit that the reader sees, "" where nothing varies.
  readonly spoken: string;
}

/// An orbit along a branch is as brief as a quick look, and all there is to it.
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

  /// A preview or an orbit that is under way is let finish, for else a hand that moves on would never see one; a whole
  /// computation is overtaken.
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
    if (this.running !== wish) return; // overtaken
    this.running = undefined;
    const next = this.next;
    this.next = undefined;
    this.done(wish, outcome);
    if (next) this.want(next);
  }
}
