// One of the two settings that the page compares: what the reader chose, and what the engine makes of it.
import type { CaseInfo, Engine, MotionResult, OrbitRequest, Outcome, Setting } from '../engine/protocol';
import { LivePoint, type Wish } from './live';
import type { Side } from './setting';

/// While the cursor moves, motions are this long at most.
const PREVIEW = { transient: 60, record: 40, stepsPerRevolution: 0 } as const;

export interface SideListener {
  changed(): void;
}

export class SideModel {
  choice: Side = { assignments: new Map(), value: NaN };
  /// The case with the assignments in force.
  info: CaseInfo | undefined;
  /// The values of its parameters, in SI, where some of them follow from the one along the diagram.
  following: ReadonlyMap<string, number> = new Map();
  result: MotionResult | undefined;
  /// The result is of a shortened motion.
  preview = false;
  /// The result is what the run has stored.
  stored = false;
  /// What the result is of.
  resultOf: Side | undefined;
  trouble = '';
  /// The result is not of the present setting, which cannot be computed.
  outdated = false;
  /// The case with the assignments cannot be computed.
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

  /// Reads the case with the assignments; false where it is bad, or overtaken.
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

  /// Finds what follows from the value along the diagram, which is spoken as an assignment.
  async follow(setting: Setting, spoken: string): Promise<void> {
    const told = await this.describeAt(setting, spoken, 'follow');
    if (!told?.ok) return;
    this.following = new Map(told.value.parameters.map(({ name, value }) => [name, value]));
    this.listener.changed();
  }

  /// Something was typed that is no setting.
  refuse(sentence: string): void {
    this.trouble = sentence;
    this.outdated = true;
    this.listener.changed();
  }

  /// Asks for the motion at the side's value; `spoken` is that value as an assignment in the unit that the reader sees.
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

  /// Asks for an orbit along a branch.
  wantOrbit(request: OrbitRequest): void {
    if (!this.live || this.bad) return;
    this.trouble = '';
    this.live.want({ request, preview: false, of: this.choice, spoken: '' });
    this.listener.changed();
  }

  /// Shows what the run has stored of the present choice.
  showStored(result: MotionResult): void {
    this.result = result;
    this.resultOf = this.choice;
    this.stored = true;
    this.listener.changed();
  }

  /// The engine is gone; what it has found stays.
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
      this.trouble = outcome.message;
      this.outdated = true;
      void this.speak(wish);
    }
    this.listener.changed();
  }

  /// What cannot be computed was said in SI: the case says it of the value as the reader sees it.
  private async speak({ request, of, spoken }: Wish): Promise<void> {
    const told = spoken ? await this.describeAt(request.setting, spoken, 'speak') : undefined;
    if (!told || told.ok || told.why === 'stale' || of !== this.choice) return;
    this.trouble = told.message;
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
