// The head of the page: machine, units, comparison of two settings, theme.
import { button, el, Segments, select, setChoices } from '../dom';
import type { Machine } from '../model/machine';
import {
  unitsOfReport,
  type AmplitudeUnit,
  type FrequencyUnit,
  type LengthUnit,
  type SpeedUnit,
  type Units,
} from '../model/units';

export interface TopbarListener {
  machine(name: string): void;
  units(units: Units): void;
  compare(): void;
  measured(): void;
  theme(): void;
  help(): void;
}

export class Topbar {
  readonly root: HTMLElement;
  private readonly title = el('h1');
  private readonly intro = el('p', { class: 'intro' });
  private readonly machines: HTMLSelectElement;
  private readonly length: Segments;
  private readonly speed: Segments;
  private readonly frequency: Segments;
  private readonly amplitude: Segments;
  private readonly compare: HTMLButtonElement;
  private readonly measured: HTMLButtonElement;
  private units: Units = { length: 'um', speed: 'rpm', frequency: 'order', amplitude: '0-p' };

  constructor(private readonly listener: TopbarListener) {
    this.machines = select('Machine', [], '', (value) => listener.machine(value));
    this.length = this.unitSegments(
      'Length',
      [
        { value: 'um', text: '\u00b5m' },
        { value: 'mil', text: 'mil' },
        { value: 'scale', text: 'c', title: 'length scales of the case' },
        { value: 'own', text: 'own', title: 'as the report shows it' },
      ],
      (value) => ({ length: value as LengthUnit }),
    );
    this.speed = this.unitSegments(
      'Speed',
      [
        { value: 'rpm', text: 'rpm' },
        { value: 'rad/s', text: 'rad/s' },
      ],
      (value) => ({ speed: value as SpeedUnit }),
    );
    this.frequency = this.unitSegments(
      'Frequency',
      [
        { value: 'order', text: 'X', title: 'orders of the running speed' },
        { value: 'Hz', text: 'Hz' },
        { value: 'own', text: 'own', title: 'as the report shows it' },
      ],
      (value) => ({ frequency: value as FrequencyUnit }),
    );
    this.amplitude = this.unitSegments(
      'Amplitude',
      ['0-p', 'p-p', 'rms'].map((value) => ({ value, text: value })),
      (value) => ({ amplitude: value as AmplitudeUnit }),
    );
    this.compare = button('A | B', 'Compare two settings side by side', () => listener.compare(), {
      'aria-pressed': 'false',
    });
    this.measured = button(
      'Measured\u2026',
      'Measured data: lay an orbit or a Bode plot (CSV, HDF5, MAT, UFF) over the model; files can also be dropped here',
      () => listener.measured(),
    );
    this.root = el(
      'header',
      { class: 'topbar' },
      el('div', { class: 'topbar-title' }, el('span', { class: 'brand', 'aria-hidden': 'true' }, 'whirl'), this.title),
      el(
        'div',
        { class: 'tools topbar-tools' },
        this.machines,
        this.length.root,
        this.speed.root,
        this.frequency.root,
        this.amplitude.root,
        this.compare,
        this.measured,
        button('\u25d0', 'Light or dark', () => listener.theme(), { class: 'icon' }),
        button('?', 'Help', () => listener.help(), { class: 'icon' }),
      ),
      this.intro,
    );
  }

  show(
    machine: Machine,
    intro: string,
    machines: readonly Machine[],
    units: Units,
    lengthSymbol: string,
    comparing: boolean,
    atRest: boolean,
  ): void {
    this.title.textContent = machine.title || machine.name;
    document.title = `${machine.title || machine.name} \u00b7 whirl`;
    this.intro.textContent = intro;
    setChoices(
      this.machines,
      machines.map(({ name, title, run }) => ({
        value: name,
        text: `${name}: ${title}${run ? '' : ' (computed here)'}`,
      })),
      machine.name,
    );
    this.machines.hidden = machines.length < 2;
    this.units = units;
    this.length.rename('scale', lengthSymbol);
    this.length.offer('own', unitsOfReport(units.shown).length === 'own' ? units.shown?.length?.unit : undefined);
    this.frequency.offer(
      'own',
      unitsOfReport(units.shown).frequency === 'own' ? units.shown?.frequency?.unit : undefined,
    );
    this.length.value = units.length;
    this.speed.value = units.speed;
    this.frequency.value = units.frequency;
    this.amplitude.value = units.amplitude;
    this.compare.setAttribute('aria-pressed', String(comparing));
    this.compare.hidden = atRest;
    // Give frequencies of machines at rest the unit of the speed in place of orders.
    this.frequency.rename('order', atRest ? units.speed : 'X');
  }

  /// Shows the button for measured data, or hides it.
  offerMeasured(offered: boolean): void {
    this.measured.hidden = !offered;
  }

  /// Shows the choice of units, or hides it.
  offerUnits(offered: boolean): void {
    for (const choice of [this.length, this.speed, this.frequency, this.amplitude]) choice.root.hidden = !offered;
  }

  private unitSegments(
    label: string,
    choices: readonly { value: string; text: string; title?: string }[],
    part: (value: string) => Partial<Units>,
  ): Segments {
    return new Segments(label, choices, choices[0]!.value, (value) =>
      this.listener.units({ ...this.units, ...part(value) }),
    );
  }
}
