// One of the two compared settings: the user's choice, and the engine's results.
import type { CaseInfo, Engine, MotionResult, OrbitRequest, Outcome, Setting } from '../engine/protocol';
import { LivePoint, type Wish } from './live';
import type { Side } from './setting';

/// Limits of a motion while the cursor moves.
const PREVIEW = { transient: 60, record: 40, stepsPerRevolution: 0 } as const;

export interface SideListener {
  changed(): void;
}

export class SideModel {
  choice: Side = { assignments: new Map(), value: NaN };
  /// The case with the assignments in force.
  info: CaseInfo | undefined;
  /// Values of parameters in SI, if some of them depend on the parameter along the diagram.
  following: ReadonlyMap<string, number> = new Map();
  result: MotionResult | undefined;
  /// True if the result is a preview.
  preview = false;
  /// True if the result is stored in the run.
  stored = false;
  /// The choice to which the result belongs.
  resultOf: Side | undefined;
  trouble = '';
  /// True if the result belongs to an earlier setting, because the present one cannot be computed.
  outdated = false;
  /// True if the case with the assignments is invalid.
  private bad = false;
  private live: LivePoint | undefined;

  constructor(
    readonly name: 'a' | 'b',
    private engine: Engine | undefined,
    private readonly listener: SideListener,
  ) {
    this.live = engine && new LivePoint(engine, `point-${name}`, (wish, outcome) => this.take(wish, outcome));
  }

  get busy(): boolean {
    return this.live?.busy ?? false;
  }

  /// Reads the case with the assignments; returns false if it is invalid, or a newer request has overtaken this one.
  async describe(setting: Setting): Promise<boolean> {
    if (!this.engine) return false;
    const outcome = await this.engine.describe(setting, { lane: `describe-${this.name}`, priority: 0 });
    if (!this.engine) return false;
    if (outcome.ok) {
      this.info = outcome.value;
      this.following = new Map();
      this.trouble = '';
      this.bad = false;
      return true;
    }
    if (outcome.why !== 'stale') {
      this.trouble = outcome.message;
      this.bad = this.outdated = true;
    }
    return false;
  }

  /// Finds the parameters that depend on the value along the diagram, which `spoken` gives as an assignment.
  async follow(setting: Setting, spoken: string): Promise<void> {
    const answer = await this.describeAt(setting, spoken, 'follow');
    if (!answer?.ok) return;
    this.following = new Map(answer.value.parameters.map(({ name, value }) => [name, value]));
    this.listener.changed();
  }

  /// Reports a typed text that is not a value.
  refuse(sentence: string): void {
    this.trouble = sentence;
    this.outdated = true;
    this.listener.changed();
  }

  /// Requests the motion at the side's value; `spoken` is that value as an assignment in the shown unit.
  want(setting: Setting, parameter: string, settled: boolean, spoken: string): void {
    if (!this.live || this.bad) return;
    this.trouble = '';
    const { value } = this.choice;
    const batch = this.info?.batches[0];
    const whole = { ...batch?.options, ...setting.options };
    const transient = whole.transient ?? PREVIEW.transient;
    const record = whole.record ?? PREVIEW.record;
    const shortened = !settled && (PREVIEW.transient < transient || PREVIEW.record < record);
    const request = {
      setting: shortened ? { ...setting, look: PREVIEW } : setting,
      ...(parameter && Number.isFinite(value) ? { parameter, value } : {}),
    };
    this.live.want({ request, preview: shortened, of: this.choice, spoken: 'value' in request ? spoken : '' });
    this.listener.changed();
  }

  /// Requests an orbit along a branch.
  wantOrbit(request: OrbitRequest): void {
    if (!this.live || this.bad) return;
    this.trouble = '';
    this.live.want({ request, preview: false, of: this.choice, spoken: '' });
    this.listener.changed();
  }

  /// Shows the stored result of the present choice.
  showStored(result: MotionResult): void {
    this.result = result;
    this.resultOf = this.choice;
    this.stored = true;
    this.listener.changed();
  }

  /// Handles the loss of the engine; its results stay.
  lose(): void {
    this.engine = this.live = undefined;
    this.trouble = '';
  }

  forget(): void {
    this.live?.stop();
    this.result = undefined;
    this.stored = false;
    this.info = undefined;
    this.following = new Map();
    this.resultOf = undefined;
    this.trouble = '';
    this.bad = this.outdated = false;
  }

  private take(wish: Wish, outcome: Outcome<MotionResult>): void {
    if (!this.engine) return;
    if (outcome.ok) {
      this.result = outcome.value;
      this.resultOf = wish.of;
      this.preview = wish.preview;
      this.stored = false;
      this.outdated = this.bad;
    } else if (outcome.why !== 'stale') {
      this.outdated = true;
      void this.explain(wish, outcome.message);
    }
    this.listener.changed();
  }

  /// Shows why a request failed. The request was in SI, so the engine is asked for a message with the value in the
  /// shown unit; `message` is shown if it has none.
  private async explain({ request, of, spoken }: Wish, message: string): Promise<void> {
    const answer = spoken ? await this.describeAt(request.setting, spoken, 'speak') : undefined;
    if (of !== this.choice) return;
    this.trouble = !answer || answer.ok || answer.why === 'stale' ? message : answer.message;
    this.listener.changed();
  }

  private async describeAt(
    { text, name, assignments = [] }: Setting,
    spoken: string,
    lane: string,
  ): Promise<Outcome<CaseInfo> | undefined> {
    const setting = { text, ...(name ? { name } : {}), assignments: [...assignments, spoken] };
    return this.engine?.describe(setting, { lane: `${lane}-${this.name}`, priority: 0 });
  }
}
