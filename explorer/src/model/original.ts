// Values of a parameter in the case: range of the view, initial value, size of its unit.
import type { CaseInfo } from '../engine/protocol';

type Range = readonly [number, number];

/// Returns the range of the case's sweep; without one, a range around its value.
export function plannedRange(original: CaseInfo | undefined, parameter: string): Range {
  const batch = original?.batches.find((each) => each.parameter === parameter && each.values.length > 1);
  if (batch) return [Math.min(...batch.values), Math.max(...batch.values)];
  const value = original?.parameters.find(({ name }) => name === parameter)?.value ?? 1;
  return value === 0 ? [-1, 1] : [Math.min(value / 2, value * 1.5), Math.max(value / 2, value * 1.5)];
}

/// Returns the initial value: the first detail of the case, else the middle of its sweep; for other parameters the
/// value of the case.
export function firstValue(original: CaseInfo | undefined, parameter: string, [low, high]: Range): number {
  const mine = original?.batches.filter((batch) => batch.parameter === parameter) ?? [];
  const detail = mine.find(({ name }) => name === 'detail')?.values[0];
  const own = original?.parameters.find(({ name }) => name === parameter)?.value;
  return detail ?? (mine.length === 0 ? own : undefined) ?? (low + high) / 2;
}

/// Returns the default parameter of the diagram.
export function sweptParameter(original: CaseInfo | undefined, stored: string | undefined): string {
  const swept = stored || original?.batches.find(({ parameter }) => parameter)?.parameter;
  return swept ?? original?.parameters.find(({ expression }) => !expression)?.name ?? '';
}
