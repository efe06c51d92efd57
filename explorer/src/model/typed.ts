// Numbers as hands type them.

/// The number, or the sentence that says why it is none. A comma may part thousands or decimals: it is not guessed
/// which.
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

/// The same for a whole number from `low` to `high`.
export function typedWhole(text: string, low: number, high: number): number | string {
  const value = typedNumber(text);
  if (typeof value === 'string' || (Number.isInteger(value) && value >= low && value <= high)) return value;
  return `${text.trim()} is not a whole number from ${low} to ${high}`;
}

/// Marks a field whose text was refused, and one that is good again.
export function markField(field: HTMLInputElement, refused: boolean): void {
  if (refused) field.setAttribute('aria-invalid', 'true');
  else field.removeAttribute('aria-invalid');
}
