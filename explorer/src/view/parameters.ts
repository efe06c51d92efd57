// The parameters of a case: a slider and a number for each, with unit, range and meaning from the engine's descriptors.
import { button, el, isTouched } from '../dom';
import type { FittedParameter } from '../data/contents';
import type { CaseInfo, ParameterInfo } from '../engine/protocol';
import { markField, typedQuantity } from '../model/typed';
import { chosenUnit, labelled, parameterMeasure, shown, written, type Units } from '../model/units';
import type { Assignments } from '../model/setting';

export interface ParametersSubject {
  /// The case without changes.
  readonly original: CaseInfo;
  /// The case with the assignments.
  readonly current: CaseInfo;
  readonly assignments: Assignments;
  /// The parameter along the diagram, whose value the cursor shows.
  readonly swept: string;
  readonly units: Units;
  /// Parameters that a fit has found.
  readonly fitted: readonly FittedParameter[];
  /// Problem of the setting, or "".
  readonly trouble: string;
}

export interface ParametersListener {
  /// Called with a parameter's new value as for `whirl run --set`; undefined: the value of the case. `settled` after
  /// the pointer was released. `value` is the same in SI; undefined for a typed unit that only the engine knows.
  assigned(name: string, text: string | undefined, settled: boolean, value: number | undefined): void;
  /// Called after a text was typed that is not a value.
  refused(sentence: string): void;
}

const STEPS = 1000;

/// Notation of a parameter: its unit, and the unit's size in SI.
interface Notation {
  readonly unit: string;
  /// Factor from SI to shown numbers.
  readonly factor: number;
}

function notationOf(parameter: ParameterInfo, units: Units): Notation {
  const measure = parameterMeasure(parameter.unit, units);
  if (measure.unit === 'rpm' || measure.unit === 'rad/s' || chosenUnit(parameter.unit, units)) return measure;
  const [, figures, unit] = /^\s*([-+0-9.eE]+)\s+(\S.*?)\s*$/.exec(parameter.written) ?? [];
  const number = Number(figures);
  if (!parameter.expression && unit && number !== 0 && parameter.value !== 0 && Number.isFinite(number))
    return { unit, factor: number / parameter.value };
  return measure;
}

interface Bounds {
  readonly low: number;
  readonly high: number;
}

/// Widths of the slider of a fitted parameter on both sides of its value, in half-widths of its 95 % interval: at the
/// ends of the slider the machine no longer agrees with the measurement.
const FITTED_WIDTHS = 10;

/// Returns the range of the slider in SI: the sweep's range, or that around a fitted value, else from 0 to twice the
/// value, within the range of the keys that use the parameter.
function sliderBounds(parameter: ParameterInfo, info: CaseInfo, fitted: FittedParameter | undefined): Bounds {
  const swept = info.batches.find((batch) => batch.parameter === parameter.name && batch.values.length > 1);
  let [low, high] =
    parameter.value === 0 ? [-1, 1] : [Math.min(0, 2 * parameter.value), Math.max(0, 2 * parameter.value)];
  if (swept) [low, high] = [Math.min(...swept.values), Math.max(...swept.values)];
  const wide = FITTED_WIDTHS * (fitted?.half ?? 0);
  if (wide > 0 && wide < high - low && !swept) [low, high] = [parameter.value - wide, parameter.value + wide];
  for (const use of parameter.uses) {
    if (!use.alone) continue;
    const margin = Math.abs(parameter.value) * 1e-3 || 1e-3;
    if (use.low !== null) low = Math.max(low, use.low + (use.lowOpen ? margin : 0));
    if (use.high !== null) high = Math.min(high, use.high - (use.highOpen ? margin : 0));
  }
  return { low: Math.min(low, parameter.value), high: Math.max(high, parameter.value) };
}

function meaningOf(parameter: ParameterInfo): string {
  const use = parameter.uses.find(({ alone }) => alone) ?? parameter.uses[0];
  return parameter.comment || use?.meaning || '';
}

/// Returns the allowed range in the shown unit, "above 0 rpm"; "" without limits.
function rangeOf(parameter: ParameterInfo, notation: Notation): string {
  const use = parameter.uses.find(({ alone }) => alone);
  if (!use) return '';
  const unit = notation.unit && ` ${notation.unit}`;
  const low =
    use.low === null ? '' : `${use.lowOpen ? 'above' : 'at least'} ${shown(use.low * notation.factor)}${unit}`;
  const high =
    use.high === null ? '' : `${use.highOpen ? 'below' : 'at most'} ${shown(use.high * notation.factor)}${unit}`;
  return [low, high].filter((part) => part).join(', ');
}

class Row {
  readonly root: HTMLElement;
  private readonly slider = el('input', { type: 'range', min: 0, max: STEPS, step: 1 });
  private readonly field = el('input', {
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  private readonly unit = el('span', { class: 'unit' });
  private readonly expression = el('code', { class: 'expression' });
  private readonly meaning = el('p', { class: 'meaning' });
  private readonly fit = el('p', { class: 'meaning fit-text', hidden: true });
  /// The standard error and the 95 % interval over the slider.
  private readonly bars = ['fit-interval', 'fit-error'].map((kind) => el('span', { class: kind, hidden: true }));
  private readonly reset: HTMLButtonElement;
  private readonly unlock: HTMLButtonElement;
  private notation: Notation = { unit: '', factor: 1 };
  /// Value in SI.
  private value = NaN;
  /// True while the field contains a rejected text.
  private refused = false;

  constructor(
    private readonly name: string,
    private readonly bounds: Bounds,
    private readonly original: ParameterInfo,
    private readonly fitted: FittedParameter | undefined,
    private readonly listener: ParametersListener,
  ) {
    const id = `parameter-${name}`;
    this.field.id = id;
    this.meaning.id = `${id}-meaning`;
    this.expression.id = `${id}-expression`;
    this.fit.id = `${id}-fit`;
    this.slider.setAttribute('aria-label', `${name}, slider`);
    this.field.setAttribute('aria-describedby', `${id}-expression ${id}-fit ${id}-meaning`);
    this.reset = button(
      '\u21ba',
      `Reset ${name} to the case`,
      () => {
        this.refused = false;
        listener.assigned(name, undefined, true, undefined);
      },
      { class: 'icon' },
    );
    this.unlock = button(
      '\u270e',
      `Set ${name} by hand`,
      () => {
        this.assign(this.value * this.notation.factor, true);
        this.field.focus();
      },
      { class: 'icon' },
    );
    this.slider.addEventListener('input', () => this.slid(false));
    this.slider.addEventListener('change', () => this.slid(true));
    this.field.addEventListener('change', () => this.typed());
    this.root = el(
      'div',
      { class: 'parameter' },
      el('label', { for: id }, name),
      this.field,
      this.unit,
      this.reset,
      this.unlock,
      el('div', { class: 'slider' }, this.slider, ...this.bars),
      this.fit,
      this.expression,
      this.meaning,
    );
  }

  show(now: ParameterInfo, changed: boolean, units: Units, swept: boolean, trouble: string): void {
    this.notation = notationOf(now, units);
    this.value = now.value;
    // Lock a value that follows from other parameters; the user can unlock it.
    this.lock(now.expression && !swept ? now.written : '');
    this.refused &&= trouble !== '';
    markField(this.field, this.refused);
    this.unit.textContent = this.notation.unit;
    const range = rangeOf(this.original, this.notation);
    this.meaning.textContent = [meaningOf(this.original), range && `(${range})`].filter((part) => part).join(' ');
    const { low, high } = this.bounds;
    if (!isTouched(this.slider)) this.slider.value = String(Math.round(((now.value - low) / (high - low)) * STEPS));
    if (!isTouched(this.field) && !this.refused) this.field.value = written(now.value * this.notation.factor, 7);
    this.field.setAttribute('aria-label', labelled(this.name, this.notation.unit));
    this.slider.setAttribute('aria-valuetext', `${shown(now.value * this.notation.factor)} ${this.notation.unit}`);
    this.showFit();
    this.reset.disabled = !changed && !this.refused;
    this.root.classList.toggle('changed', changed);
    this.root.classList.toggle('swept', swept);
  }

  /// Shows the fitted value with its standard error and its 95 % interval.
  private showFit(): void {
    const { value, error, half, determined } = this.fitted ?? {};
    this.fit.hidden = typeof value !== 'number';
    if (typeof value !== 'number') return;
    const { factor, unit } = this.notation;
    const of = (number: number, digits: number) => shown(number * factor, digits);
    // As many digits as the error has.
    const digits = error ? Math.max(3, Math.min(9, 2 + Math.ceil(Math.log10(Math.abs(value / error) + 1)))) : 5;
    const known = typeof error === 'number' && typeof half === 'number';
    this.fit.textContent = known
      ? `fitted ${of(value, digits)} \u00b1 ${of(error, 2)} ${unit}; ` +
        `95 %: ${of(value - half, digits)} to ${of(value + half, digits)}`
      : `fitted ${of(value, digits)} ${unit}`;
    if (determined !== 'yes') this.fit.append(` (determined: ${determined})`);
    const { low, high } = this.bounds;
    for (const [i, size] of [half, error].entries()) {
      const bar = this.bars[i]!;
      bar.hidden = !known || this.slider.hidden;
      const place = (at: number) => Math.min(1, Math.max(0, (at - low) / (high - low)));
      bar.style.setProperty('--from', String(place(value - (size ?? 0))));
      bar.style.setProperty('--to', String(place(value + (size ?? 0))));
    }
  }

  /// Locks the value; `expression`: its formula; "" unlocks it.
  private lock(expression: string): void {
    this.expression.textContent = expression;
    this.field.readOnly = this.slider.hidden = this.reset.hidden = expression !== '';
    this.unlock.hidden = this.expression.hidden = expression === '';
  }

  private slid(settled: boolean): void {
    const { low, high } = this.bounds;
    const value = low + (Number(this.slider.value) / STEPS) * (high - low);
    const text = written(value * this.notation.factor, 5);
    this.refused = false;
    this.field.value = text;
    this.assign(Number(text), settled);
  }

  private typed(): void {
    const typed = typedQuantity(this.field.value);
    this.refused = typeof typed === 'string';
    if (typeof typed === 'string') this.listener.refused(`${this.name}: ${typed}`);
    else if (typed.unit === '' || typed.unit === this.notation.unit) this.assign(typed.value, true);
    else this.listener.assigned(this.name, `${written(typed.value, 12)} ${typed.unit}`, true, undefined);
  }

  private assign(number: number, settled: boolean): void {
    const { unit, factor } = this.notation;
    const text = written(number, 12);
    this.listener.assigned(this.name, unit ? `${text} ${unit}` : text, settled, number / factor);
  }
}

export class ParametersView {
  readonly root = el('div', { class: 'parameters' });
  private rows = new Map<string, Row>();
  private original: CaseInfo | undefined;

  constructor(private readonly listener: ParametersListener) {}

  show({ original, current, assignments, swept, units, fitted, trouble }: ParametersSubject): void {
    if (original !== this.original) this.build(original, fitted);
    for (const parameter of current.parameters)
      this.rows
        .get(parameter.name)
        ?.show(parameter, assignments.has(parameter.name), units, parameter.name === swept, trouble);
  }

  private build(original: CaseInfo, fitted: readonly FittedParameter[]): void {
    const found = (name: string) => fitted.find((each) => each.name === name);
    this.original = original;
    this.rows = new Map(
      original.parameters.map((parameter) => [
        parameter.name,
        new Row(
          parameter.name,
          sliderBounds(parameter, original, found(parameter.name)),
          parameter,
          found(parameter.name),
          this.listener,
        ),
      ]),
    );
    this.root.replaceChildren(...Array.from(this.rows.values(), (row) => row.root));
  }
}
