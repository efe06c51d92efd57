// The card of a pair of charts of a machine at rest: choice of quantities, mode of dragging, located points.
import type { MeasuredData } from '../data/measured';
import type { AtRest } from '../data/rest';
import { button, el } from '../dom';
import { naturalMeasure, parameterMeasure, shownWhole } from '../model/units';
import { criticalText, dampingText } from './campbell';
import { chartFrame, dragModes } from './chart_frame';
import { keyElements, type RestChart, type RestSubject } from './rest_subject';
import type { StackListener } from './stack';
import { numbersTable } from './numbers';

export interface RestCardSubject extends RestSubject {
  readonly depth: number;
  readonly status: string;
}

export interface RestCardListener extends StackListener {
  reset(): void;
}

export class RestCard {
  readonly root: HTMLElement;
  private readonly legend = el('div', { class: 'legend' });
  private readonly status = el('p', { class: 'status', role: 'status' });
  private readonly critical = el('div', { class: 'numbers', role: 'region', tabindex: 0 });
  private readonly back: HTMLButtonElement;
  private readonly reset: HTMLButtonElement;
  private readonly tools: HTMLElement;
  private name = '';
  private shown:
    { readonly rest: AtRest; readonly text: string; readonly measured: readonly MeasuredData[] } | undefined;

  constructor(
    private readonly chart: RestChart,
    private readonly listener: RestCardListener,
  ) {
    const { stack } = chart;
    const modes = dragModes(stack, 'the numbers at the value');
    this.back = button('Back', 'Back to the view before', () => stack.back());
    this.reset = button('Reset', 'The whole diagram', () => {
      stack.fit();
      listener.reset();
    });
    this.tools = el('div', { class: 'tools' }, modes.root, this.back, this.reset);
    this.critical.setAttribute('aria-label', 'Located values of the parameter, to go to');
    this.root = chartFrame(chart, () => this.name, this.tools, stack.root, this.legend, this.critical, this.status);
  }

  show(subject: RestCardSubject): void {
    const { rest, range, depth } = subject;
    this.name = subject.name;
    this.back.disabled = depth === 0;
    this.status.textContent = subject.status;
    // Hide the diagram of a single point.
    const drawn = subject.parameter !== '' && range[1] > range[0];
    this.chart.stack.root.hidden = this.legend.hidden = this.tools.hidden = !drawn;
    if (drawn) this.draw(subject);
    this.critical.hidden = rest.kind !== 'modes' || !drawn;
  }

  /// Redraws only if the picture changes, not for the cursor, which is an element above it.
  private draw(subject: RestSubject): void {
    const { rest, range, parameter, units, station, choice, measured } = subject;
    const text = JSON.stringify([range, parameter, units, station, { ...choice, mode: 0 }]);
    if (this.shown?.rest === rest && this.shown.text === text && this.shown.measured === measured) return;
    this.shown = { rest, text, measured };
    this.chart.show(subject);
    this.legend.replaceChildren(...keyElements(this.chart.keys()));
    if (rest.kind === 'modes') this.showCritical(subject);
  }

  private goal(text: string, value: number): HTMLElement {
    return button(text, `Go to ${text}`, () => this.listener.cursor(value, true));
  }

  private showCritical({ rest, parameter, unit, units }: RestSubject): void {
    if (rest.critical.length === 0) {
      this.critical.replaceChildren(
        el(
          'p',
          { class: 'panel-note' },
          rest.order.some((point) => rest.modulo(point) > 0)
            ? 'Coefficients turn with the shaft: critical speeds are not defined. No threshold of stability was found.'
            : 'No critical speed and no threshold of stability was found.',
        ),
      );
      return;
    }
    const [value, frequency] = [parameterMeasure(unit, units), naturalMeasure(units)];
    const heading = [
      'located',
      value.unit ? `${parameter} (${value.unit})` : parameter,
      `frequency (${frequency.unit})`,
      'damping ratio',
    ];
    const rows = rest.critical.map((found) => [
      criticalText(found),
      this.goal(shownWhole(found.value * value.factor, 5), found.value),
      shownWhole(found.frequency * frequency.factor, 5),
      found.kind === 'critical' ? dampingText(found.ratio) : '0',
    ]);
    this.critical.replaceChildren(numbersTable('Critical speeds and thresholds of stability', heading, rows));
  }
}
