// The run of a run-up at the user's setting. The engine computes the newest requested setting.
import { RunUp } from '../data/runup';
import type { Engine, Outcome, RunRequest, RunResult } from '../engine/protocol';

/// Milliseconds that a run may continue after a newer request.
const PATIENCE = 400;
/// Computing time of a run in s above which runs during the move of a slider are coarser, and their tolerance.
const LONG = 1;
const QUICK_RTOL = 1e-5;

interface Wish {
  readonly request: RunRequest;
  readonly settled: boolean;
}

export interface RunModelListener {
  changed(): void;
}

export class RunModel {
  /// The newest run, which may not be complete.
  run: RunUp | undefined;
  /// Its result.
  result: RunResult | undefined;
  /// True if the result has the coarser tolerance (QUICK_RTOL).
  quick = false;
  trouble = '';
  /// Computed share of the current run; undefined: none is being computed.
  progress: number | undefined;
  private next: Wish | undefined;
  private timer = 0;
  private lasted = 0;

  constructor(
    private engine: Engine | undefined,
    private readonly listener: RunModelListener,
  ) {}

  /// Requests a run; `settled`: the user has released the slider.
  want(request: RunRequest, contacts: readonly string[], settled: boolean): void {
    if (!this.engine) return;
    this.next = { request, settled };
    if (this.progress === undefined) void this.begin(contacts);
    else if (!this.timer) this.timer = window.setTimeout(() => this.engine?.endRun(), PATIENCE);
  }

  /// Ends the computation; the computed part stays.
  stop(): void {
    this.next = undefined;
    this.engine?.endRun();
  }

  forget(): void {
    this.stop();
    this.run = this.result = undefined;
    this.trouble = '';
  }

  lose(): void {
    this.stop();
    this.engine = undefined;
  }

  private async begin(contacts: readonly string[]): Promise<void> {
    while (this.next && this.engine) {
      const { request, settled } = this.next;
      const quick = !settled && this.lasted > LONG;
      this.next = undefined;
      this.progress = 0;
      this.listener.changed();
      const outcome = await this.engine.run(quick ? quickOf(request) : request, (part) => {
        this.progress = part.duration > 0 ? part.time / part.duration : 0;
        this.take(part, contacts, quick);
      });
      clearTimeout(this.timer);
      this.timer = 0;
      this.finish(outcome, contacts, quick);
    }
    this.progress = undefined;
    this.listener.changed();
  }

  private take(result: RunResult, contacts: readonly string[], quick: boolean): void {
    this.result = result;
    this.quick = quick;
    this.run = RunUp.computed(result, contacts);
    this.trouble = '';
    this.listener.changed();
  }

  private finish(outcome: Outcome<RunResult>, contacts: readonly string[], quick: boolean): void {
    if (outcome.ok) {
      this.take(outcome.value, contacts, quick);
      if (!quick) this.lasted = outcome.value.seconds;
    } else if (outcome.why !== 'stale') this.trouble = outcome.message;
  }
}

function quickOf(request: RunRequest): RunRequest {
  const { setting } = request;
  return { ...request, setting: { ...setting, options: { ...setting.options, runup_rtol: QUICK_RTOL } } };
}
