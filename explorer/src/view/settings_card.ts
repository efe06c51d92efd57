// The card of the setting: parameters, options of the computation, and exports.
import { button, el, isTouched, select, setChoices } from '../dom';
import type { CaseInfo } from '../engine/protocol';
import { LENGTHS_OF_RUNS, type Computation, type LengthKey } from '../model/setting';
import { markField, typedWhole } from '../model/typed';
import { ParametersView, type ParametersListener, type ParametersSubject } from './parameters';

export interface SettingsListener extends ParametersListener {
  computation(changed: Computation): void;
  resetAll(): void;
  download(): void;
  copyCommand(): void;
  copyLink(): void;
}

export interface SettingsSubject extends ParametersSubject {
  readonly side: string;
  readonly comparing: boolean;
  readonly computation: Computation;
}

export class SettingsCard {
  readonly root: HTMLElement;
  private readonly title = el('h2');
  private readonly parameters: ParametersView;
  private readonly method: HTMLSelectElement;
  private readonly fields: ReadonlyMap<LengthKey, HTMLInputElement>;
  private readonly trouble = el('p', { class: 'trouble', role: 'alert' });
  private readonly notice = el('p', { class: 'notice', role: 'status' });
  private computation: Computation = {};

  constructor(
    private readonly listener: SettingsListener,
    /// True if the card has the options of motions (method and lengths).
    private readonly moves = true,
  ) {
    this.parameters = new ParametersView(listener);
    this.method = select('Method of integration', [], '', (value) => this.change('method', value));
    this.fields = new Map(LENGTHS_OF_RUNS.map(({ key, low, high }) => [key, this.wholeField(key, low, high)]));
    this.root = el(
      'section',
      { class: 'card settings-card', 'aria-label': 'Parameters' },
      el(
        'header',
        {},
        this.title,
        el(
          'div',
          { class: 'tools' },
          button('Reset all', 'Reset all parameters to the case', () => listener.resetAll()),
        ),
      ),
      this.trouble,
      this.parameters.root,
      ...(moves ? [this.computationFields()] : []),
      el(
        'div',
        { class: 'tools keep' },
        button('Save case', 'Save the present setting as a case file for whirl run', () => listener.download(), {
          'data-save': 'case',
        }),
        button('Copy command', 'Copy a command line that computes the present setting', () => listener.copyCommand()),
        button('Copy link', 'Copy the address of this page with the present setting', () => listener.copyLink()),
      ),
      this.notice,
    );
  }

  /// Builds the fields of method and lengths, in a section that is closed at first.
  private computationFields(): HTMLElement {
    return el(
      'details',
      { class: 'computation' },
      el('summary', {}, 'How motions are computed'),
      el(
        'div',
        { class: 'fields' },
        this.labelled('Method', this.method),
        ...LENGTHS_OF_RUNS.map(({ key, label }) => this.labelled(label, this.fields.get(key)!)),
      ),
    );
  }

  show(subject: SettingsSubject): void {
    this.title.textContent = subject.comparing ? `Parameters of ${subject.side.toUpperCase()}` : 'Parameters';
    this.trouble.textContent = subject.trouble;
    this.parameters.show(subject);
    if (this.moves) this.showComputation(subject.original, subject.computation, subject.trouble);
  }

  say(text: string): void {
    this.notice.textContent = text;
  }

  private showComputation(info: CaseInfo, computation: Computation, trouble: string): void {
    this.computation = computation;
    const batch = info.batches[0];
    setChoices(
      this.method,
      info.methods.map(({ name }) => ({ value: name, text: name })),
      computation.method ?? batch?.options.method ?? '',
    );
    for (const { key, option } of LENGTHS_OF_RUNS) {
      const field = this.fields.get(key)!;
      const refused = field.hasAttribute('aria-invalid') && trouble !== '';
      markField(field, refused);
      if (!isTouched(field) && !refused) field.value = String(computation[key] ?? batch?.options[option] ?? '');
    }
  }

  private wholeField(key: LengthKey, low: number, high: number): HTMLInputElement {
    const field = el('input', { type: 'text', inputmode: 'numeric', autocomplete: 'off' });
    field.addEventListener('change', () => {
      const value = typedWhole(field.value, low, high);
      markField(field, typeof value === 'string');
      if (typeof value === 'string') this.listener.refused(`${field.labels?.[0]?.textContent ?? key}: ${value}`);
      else this.change(key, value);
    });
    return field;
  }

  private change(key: string, value: string | number): void {
    this.listener.computation({ ...this.computation, [key]: value });
  }

  private labelled(text: string, field: HTMLElement): HTMLElement {
    return el('label', {}, el('span', {}, text), field);
  }
}
