// Animation of a settling motion: revolutions are computed ahead and shown at the chosen speed.
import type { Engine, StationInfo, TransientRequest, TransientResult } from '../engine/protocol';
import type { Trail } from '../view/orbit';

const SAMPLES = 64;
/// Revolutions of a request, and revolutions computed ahead.
const CHUNK = 32;
const AHEAD = 128;
/// Revolutions of the trail.
const TRAIL = 1.5;

/// A sample of one station, and whether a contact was closed.
interface Sample {
  readonly x: number;
  readonly y: number;
  readonly touching: boolean;
}

export class Watch {
  private readonly samples: Sample[] = [];
  /// Number of samples dropped at the front, which is the index of the first sample kept.
  private dropped = 0;
  private state: Float64Array | undefined;
  private per = SAMPLES;
  private ended = '';
  private fetching = false;
  private stopped = false;
  private at = 0;
  /// The last shown sample.
  private shown = -1;
  private before = NaN;
  private speed: number;
  private frame = 0;

  constructor(
    private readonly engine: Engine,
    /// The motion to show. Without `state` it starts as the case does.
    private readonly request: Omit<TransientRequest, 'revolutions' | 'samplesPerRevolution'>,
    private readonly station: StationInfo,
    private readonly contactNames: readonly string[],
    private readonly lane: string,
    revolutionsPerSecond: number,
    private readonly show: (trail: Trail) => void,
    private readonly fail: (message: string) => void,
  ) {
    this.speed = revolutionsPerSecond;
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  set revolutionsPerSecond(speed: number) {
    this.speed = speed;
  }

  stop(): void {
    this.stopped = true;
    cancelAnimationFrame(this.frame);
    this.engine.cancel(this.lane);
  }

  private tick(now: number): void {
    if (this.stopped) return;
    const seconds = Number.isNaN(this.before) ? 0 : Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    const ready = this.dropped + this.samples.length;
    this.at = Math.min(this.at + seconds * this.speed * this.per, Math.max(0, ready - 1));
    if (!this.fetching && !this.ended && ready - this.at < AHEAD * this.per) void this.fetch();
    if (ready > 0) this.show(this.trail());
    this.drop();
    this.frame = requestAnimationFrame((later) => this.tick(later));
  }

  private async fetch(): Promise<void> {
    this.fetching = true;
    const outcome = await this.engine.transient(
      {
        ...this.request,
        ...(this.state ? { state: this.state } : {}),
        revolutions: CHUNK,
        samplesPerRevolution: SAMPLES,
      },
      { lane: this.lane, priority: 0 },
    );
    this.fetching = false;
    if (this.stopped) return;
    if (outcome.ok) this.take(outcome.value);
    else if (outcome.why !== 'stale') this.fail(outcome.message);
  }

  private take(result: TransientResult): void {
    const { samples, forces, dimension, contacts } = result;
    const mine = this.contactNames.map((name) => name.endsWith(` ${this.station.name}`));
    for (let i = 0; i < samples.length / dimension; i++) {
      let touching = false;
      for (let contact = 0; contact < contacts; contact++)
        touching ||= mine[contact] === true && forces[i * contacts + contact]! > 0;
      this.samples.push({
        x: samples[i * dimension + this.station.x]!,
        y: samples[i * dimension + this.station.y]!,
        touching,
      });
    }
    this.state = result.state;
    this.per = result.samplesPerRevolution;
    if (result.diverged) this.ended = 'diverged';
  }

  private trail(): Trail {
    const now = Math.floor(this.at) - this.dropped;
    const first = Math.max(0, now - Math.round(TRAIL * this.per));
    const shown = this.samples.slice(first, now + 1);
    const marks: number[] = [];
    for (let i = first; i <= now; i++) if ((i + this.dropped + 1) % this.per === 0) marks.push(i - first);
    const revolution = Math.floor(this.at / this.per);
    // Include contacts between the last frame and this one.
    const fresh = this.samples.slice(Math.max(first, Math.min(now, this.shown + 1 - this.dropped)), now + 1);
    this.shown = Math.floor(this.at);
    return {
      x: shown.map((sample) => sample.x),
      y: shown.map((sample) => sample.y),
      marks,
      touching: fresh.some(({ touching }) => touching),
      text:
        this.ended && now === this.samples.length - 1
          ? `diverged after ${revolution} revolutions`
          : `revolution ${revolution}`,
    };
  }

  private drop(): void {
    const old = Math.floor(this.at) - this.dropped - Math.round(2 * TRAIL * this.per);
    if (old < 4096) return;
    this.samples.splice(0, old);
    this.dropped += old;
  }
}
