// Motions on demand: while the cursor moves, one request at a time, the newest next; when it rests, the whole
// computation.
import type { Engine, Outcome, PointRequest, PointResult } from '../engine/protocol';
import type { Side } from './setting';

export interface Wish {
  readonly request: PointRequest;
  /// A quick look, to be followed by the whole.
  readonly preview: boolean;
  /// What it is of.
  readonly of: Side;
  /// The value as an assignment in the unit that the reader sees, "" where nothing varies.
  readonly spoken: string;
}

export class LivePoint {
  private running: Wish | undefined;
  private next: Wish | undefined;

  constructor(
    private readonly engine: Engine,
    private readonly lane: string,
    private readonly done: (wish: Wish, outcome: Outcome<PointResult>) => void,
  ) {}

  get busy(): boolean {
    return this.running !== undefined;
  }

  /// A preview that runs is let finish, for else a hand that moves on would never see one; a whole computation is
  /// overtaken.
  want(wish: Wish): void {
    if (this.running?.preview) this.next = wish;
    else void this.run(wish);
  }

  stop(): void {
    this.next = undefined;
    this.engine.cancel(this.lane);
  }

  private async run(wish: Wish): Promise<void> {
    this.running = wish;
    const outcome = await this.engine.point(wish.request, { lane: this.lane, priority: wish.preview ? 0 : 1 });
    if (this.running !== wish) return; // overtaken
    this.running = undefined;
    const next = this.next;
    this.next = undefined;
    this.done(wish, outcome);
    if (next) this.want(next);
  }
}
