// Regimes as the diagram shows them: classes with names, as in whirl's reports. Their colours are the theme's.

export const CLASS_NAMES = [
  'P-1',
  'P-2',
  'P-4',
  'other P-k',
  'quasi-periodic',
  'chaotic',
  'undetermined',
  'diverged',
] as const;

/// The last of the periodic classes.
export const OTHER_PERIODS = 3;
export const QUASI_PERIODIC = 4;
export const UNDETERMINED = 6;

/// Returns the class of the engine's fields regime/code and regime/period.
export function regimeClass(code: number, period: number): number {
  switch (code) {
    case 1:
      return period === 1 ? 0 : period === 2 ? 1 : period === 4 ? 2 : 3;
    case 2:
      return QUASI_PERIODIC;
    case 3:
      return 5;
    case 4:
      return 7;
    default:
      return UNDETERMINED;
  }
}

/// Returns the name of a regime, "P-3", "chaotic"; "" without one.
export function regimeName(code: number, period: number): string {
  if (Number.isNaN(code)) return '';
  return code === 1 ? `P-${period}` : CLASS_NAMES[regimeClass(code, period)]!;
}
