// Ticks of an axis.

/// Returns a step of 1, 2 or 5 times a power of ten, of which about `wanted` fit into a span.
export function niceStep(span: number, wanted: number): number {
  const raw = span / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(raw));
  const part = raw / power;
  return (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10) * power;
}

/// Returns a tick's text with as many decimals as the step needs.
export function tickText(value: number, step: number): string {
  if (Math.abs(value) < step * 1e-9) return '0';
  const size = Math.max(Math.abs(value), step);
  const minus = (text: string) => text.replace('-', '\u2212');
  if (size >= 1e5 || size < 1e-3) {
    const digits = Math.max(0, Math.round(Math.log10(size / step) - 0.2));
    return minus(value.toExponential(Math.min(digits, 6)).replace('e+', 'e'));
  }
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return minus(value.toFixed(Math.min(decimals, 12)));
}

export function linearTicks(low: number, high: number, wanted: number): number[] {
  if (!(high > low)) return [];
  const step = niceStep(high - low, wanted);
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i++) ticks.push(i * step);
  return ticks;
}
