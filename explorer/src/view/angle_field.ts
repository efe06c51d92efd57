// A field for the angle of a probe.
import { el, isTouched } from '../dom';
import { markField, typedQuantity } from '../model/typed';
import { written } from '../model/units';

const UNITS = ['', '\u00b0', 'deg', 'degree', 'degrees'];

export class AngleField {
  readonly root: HTMLElement;
  private readonly field = el('input', {
    type: 'text',
    inputmode: 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
    class: 'angle',
    title: 'Angle of the first probe from the x axis towards y, degrees; the second stands a right angle further on',
  });

  constructor(chosen: (degrees: number) => void) {
    const trouble = el('span', { class: 'trouble', role: 'alert' });
    const label = el('label', { class: 'over' }, 'Probe at ', this.field, ' \u00b0');
    this.root = el('span', { class: 'tools' }, label, trouble);
    this.field.addEventListener('change', () => {
      const typed = typedQuantity(this.field.value);
      const good = typeof typed !== 'string' && UNITS.includes(typed.unit) && Math.abs(typed.value) <= 360;
      markField(this.field, !good);
      trouble.textContent = good ? '' : typeof typed === 'string' ? typed : 'expected degrees from -360 to 360';
      if (good) chosen(typed.value);
    });
  }

  show(degrees: number): void {
    if (!isTouched(this.field) && !this.field.hasAttribute('aria-invalid')) this.field.value = written(degrees, 6);
  }
}
