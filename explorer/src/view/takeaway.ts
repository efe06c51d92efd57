// Exports of the session: a case file, a command line, the address.
import { copyText, download } from '../dom';
import { caseEdits, commandOf } from '../model/keep';
import { shortName } from '../model/machine';
import type { Session } from '../model/session';
import { assignmentTexts } from '../model/setting';
import { fileName } from './panel';

export interface TakeawayListener {
  /// Shows a message about the export.
  say(text: string): void;
  /// Updates the address to the present state.
  settle(): void;
}

export class Takeaway {
  constructor(
    private readonly session: Session,
    private readonly listener: TakeawayListener,
  ) {}

  /// Returns the case of the active setting; undefined if the engine rejects it.
  private async rewritten(): Promise<string | undefined> {
    const { session } = this;
    const { engine, original, side } = session;
    if (!engine || !original) return undefined;
    const edits = caseEdits(original, session.address, side.choice, session.sight.range, session.whole);
    const setting = {
      text: session.text,
      name: session.machine.caseName,
      assignments: assignmentTexts(side.choice.assignments),
    };
    const outcome = await engine.rewrite(setting, edits, { lane: 'rewrite', priority: 0 });
    if (outcome.ok) return outcome.value;
    if (outcome.why !== 'stale') this.listener.say(session.inWords(outcome.message));
    return undefined;
  }

  private get caseName(): string {
    return `${fileName(shortName(this.session.machine), 'explored')}.yaml`;
  }

  async saveCase(): Promise<void> {
    const text = await this.rewritten();
    if (text === undefined) return;
    download(this.caseName, 'application/yaml', text);
    this.listener.say(`${this.caseName}: whirl run ${this.caseName}`);
  }

  async copyCommand(): Promise<void> {
    const text = await this.rewritten();
    if (text === undefined) return;
    this.said(
      await copyText(commandOf(text, fileName(shortName(this.session.machine), 'explored'))),
      'The command is on the clipboard.',
    );
  }

  async copyLink(): Promise<void> {
    this.listener.settle();
    this.said(await copyText(location.href), 'The address is on the clipboard.');
  }

  private said(done: boolean, text: string): void {
    this.listener.say(done ? text : 'The browser does not let this page use the clipboard.');
  }
}
