// Reading of typed numbers.

/// Returns the number, or a sentence why the text is not one. A comma is rejected, since it may separate thousands or
/// decimals.
export function typedNumber(text: string): number | string {
  const plain = text.trim().replace('\u2212', '-');
  if (plain === '') return 'expected a number';
  if (/^[-+]?\d*,\d*$/.test(plain))
    return (
      `${plain} has a comma: write ${plain.replace(',', '.')} with a decimal point, or ${plain.replace(',', '')} ` +
      'without the comma'
    );
  if (plain.includes(','))
    return `${plain} has commas: write it without them, with a decimal point where one is needed`;
  const value = Number(plain);
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) && Number.isFinite(value)
    ? value
    : `${plain} is not a number`;
}

/// A number with its unit, "" without one.
export interface Quantity {
  readonly value: number;
  readonly unit: string;
}

/// Reads "6000 rpm", "0.2 mm" or a plain number; the engine interprets the unit.
export function typedQuantity(text: string): Quantity | string {
  const [, figures = text, unit = ''] =
    /^\s*([-+\u2212]?[\d.,]+(?:e[-+]?\d+)?)\s*([^\d\s.,+-][^\r\n]*?)?\s*$/i.exec(text) ?? [];
  const value = typedNumber(figures);
  return typeof value === 'string' ? value : { value, unit };
}

/// Reads a whole number from `low` to `high`.
export function typedWhole(text: string, low: number, high: number): number | string {
  const value = typedNumber(text);
  if (typeof value === 'string' || (Number.isInteger(value) && value >= low && value <= high)) return value;
  return `${text.trim()} is not a whole number from ${low} to ${high}`;
}

/// Marks a field whose text is rejected, or removes the mark.
export function markField(field: HTMLInputElement, refused: boolean): void {
  if (refused) field.setAttribute('aria-invalid', 'true');
  else field.removeAttribute('aria-invalid');
}
