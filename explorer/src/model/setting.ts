// Settings of the user in the address of the page. The contents of an address are checked, as anybody may have written
// it.
import { MAP_QUANTITIES } from '../data/map_quantities';
import { OF_A_FIELD, QUANTITIES } from '../data/quantities';
import type { Units } from './units';

/// A parameter's new value as `whirl run --set` takes it: "0.45", "6000 rpm".
export type Assignments = ReadonlyMap<string, string>;

export interface Side {
  readonly assignments: Assignments;
  /// Value of the parameter along the diagram, in SI; NaN before the first choice.
  readonly value: number;
  /// The branch point whose orbit is shown in place of a motion; the side has its value.
  readonly orbit?: number;
}

/// Integer options of the computation that the user may change: name in an address, option, label of its field, and
/// limits.
export const LENGTHS_OF_RUNS = [
  { key: 'steps', option: 'steps_per_revolution', label: 'Steps per revolution', low: 8, high: 65536 },
  { key: 'transient', option: 'transient', label: 'Transient, revolutions', low: 0, high: 1_000_000 },
  { key: 'record', option: 'record', label: 'Recorded, revolutions', low: 1, high: 1_000_000 },
] as const;
export type LengthKey = (typeof LENGTHS_OF_RUNS)[number]['key'];

/// Changed options of the computation; absent: as in the case.
export type Computation = { readonly method?: string } & { readonly [K in LengthKey]?: number };

/// Returns the changes as options of the engine, which are also keys of `study.integrate`.
export function computationOptions({ method, ...lengths }: Computation): Record<string, string | number> {
  const options: Record<string, string | number> = method ? { method } : {};
  for (const { key, option } of LENGTHS_OF_RUNS) if (lengths[key] !== undefined) options[option] = lengths[key];
  return options;
}

/// Settings of the view of a machine at rest.
export interface RestChoice {
  /// Selected mode, from 0, by rising frequency.
  readonly mode: number;
  /// True for logarithmic decrements in place of damping ratios.
  readonly decrement: boolean;
  /// True for all modes, not only those near the range of speeds.
  readonly all: boolean;
  /// Angle of the first probe in degrees from the x axis; undefined: as in the case.
  readonly probe: number | undefined;
}

export interface Address {
  /// Name of the run or preset, "" for the first one.
  run: string;
  /// Part of the result that is shown, from its contents; "" for the default.
  part: string;
  parameter: string;
  a: Side;
  b: Side | undefined;
  quantity: string;
  /// Quantity of the map; "": the default.
  mapQuantity: string;
  /// True if the map shows borders between regimes.
  mapLines: boolean;
  station: string;
  range: readonly [number, number] | undefined;
  units: Units;
  computation: Computation;
  rest: RestChoice;
  /// Cursor of a run-up in s; NaN before the first choice.
  time: number;
}

const LENGTHS = ['um', 'mil', 'scale', 'own'] as const;
const SPEEDS = ['rpm', 'rad/s'] as const;
const FREQUENCIES = ['order', 'Hz', 'own'] as const;
const AMPLITUDES = ['0-p', 'p-p', 'rms'] as const;
const NAME = /^[A-Za-z_][A-Za-z0-9_]{0,63}$/;
/// A parameter, or a key of the case: "rub[2].friction".
const SETTABLE = /^[A-Za-z_][A-Za-z0-9_.[\]-]{0,127}$/;
const MAX_TEXT = 128;
const MAX_ORBITS = 1_000_000;

function number(text: string | null): number {
  return text === null || text.trim() === '' ? NaN : Number(text);
}

function oneOf<T extends string>(text: string | null, choices: readonly T[], fallback: T): T {
  return choices.find((choice) => choice === text) ?? fallback;
}

function whole(text: string | null, low: number, high: number): number | undefined {
  const value = number(text);
  return Number.isInteger(value) && value >= low && value <= high ? value : undefined;
}

function angle(text: string | null): number | undefined {
  const value = number(text);
  return Math.abs(value) <= 360 ? value : undefined;
}

function readSide(all: URLSearchParams, value: string, set: string, on: string): Side {
  const assignments = new Map<string, string>();
  for (const text of all.getAll(set)) {
    const [, name = '', written = ''] = /^([^=]*)=(.*)$/s.exec(text) ?? [];
    if (SETTABLE.test(name) && written.trim() && written.length <= MAX_TEXT && !/[\r\n]/.test(written))
      assignments.set(name, written);
  }
  const orbit = whole(all.get(on), 1, MAX_ORBITS);
  return { assignments, value: number(all.get(value)), ...(orbit === undefined ? {} : { orbit: orbit - 1 }) };
}

/// Returns the number of a branch point in tables of the result, from 1.
function numberOf({ orbit }: Side): number | undefined {
  return orbit === undefined ? undefined : orbit + 1;
}

function readComputation(all: URLSearchParams): Computation {
  const method = all.get('method');
  const parts: [string, string | number | undefined][] = LENGTHS_OF_RUNS.map(({ key, low, high }) => [
    key,
    whole(all.get(key), low, high),
  ]);
  if (method && /^[a-z0-9-]{1,32}$/.test(method)) parts.push(['method', method]);
  return Object.fromEntries(parts.filter(([, part]) => part !== undefined));
}

/// Reads the name of a quantity: one of the list, of `others`, or a field.
function readQuantity(text: string | null, others: readonly string[], fallback: string): string {
  if (text && OF_A_FIELD.test(text)) return text;
  return oneOf(text, [...others, ...QUANTITIES.map(({ id }) => id)], fallback);
}

/// Reads an address; `fallback`: units of an address that names none.
export function readAddress(hash: string, fallback: Units): Address {
  const all = new URLSearchParams(hash.replace(/^#/, ''));
  const [low, high] = (all.get('range') ?? '').split(',').map(number);
  const units = (all.get('units') ?? '').split(',');
  return {
    run: (all.get('run') ?? '').slice(0, MAX_TEXT),
    part: (all.get('part') ?? '').slice(0, MAX_TEXT),
    parameter: NAME.test(all.get('par') ?? '') ? all.get('par')! : '',
    a: readSide(all, 'at', 'set', 'orbit'),
    b: all.has('b') ? readSide(all, 'b', 'bset', 'borbit') : undefined,
    quantity: readQuantity(all.get('q'), [], 'x'),
    mapQuantity: readQuantity(all.get('mq'), MAP_QUANTITIES, ''),
    mapLines: all.get('ml') === '1',
    station: (all.get('st') ?? '').slice(0, MAX_TEXT),
    range: Number.isFinite(low) && Number.isFinite(high) && low! < high! ? [low!, high!] : undefined,
    units: {
      ...(fallback.shown && { shown: fallback.shown }),
      length: oneOf(units[0] ?? null, LENGTHS, fallback.length),
      speed: oneOf(units[1] ?? null, SPEEDS, fallback.speed),
      frequency: oneOf(units[2] ?? null, FREQUENCIES, fallback.frequency),
      amplitude: oneOf(units[3] ?? null, AMPLITUDES, fallback.amplitude),
    },
    computation: readComputation(all),
    rest: {
      mode: (whole(all.get('mode'), 1, 1000) ?? 1) - 1,
      decrement: all.get('damping') === 'decrement',
      all: all.get('modes') === 'all',
      probe: angle(all.get('probe')),
    },
    time: number(all.get('t')),
  };
}

export function writeAddress(address: Address): string {
  const all = new URLSearchParams();
  const put = (key: string, value: string | number | undefined) => {
    if (value !== undefined && value !== '' && !Number.isNaN(value)) all.append(key, String(value));
  };
  put('run', address.run);
  put('part', address.part);
  put('par', address.parameter);
  put('at', address.a.value);
  put('orbit', numberOf(address.a));
  for (const [name, text] of address.a.assignments) put('set', `${name}=${text}`);
  if (address.b) {
    all.append('b', Number.isNaN(address.b.value) ? '' : String(address.b.value));
    put('borbit', numberOf(address.b));
    for (const [name, text] of address.b.assignments) put('bset', `${name}=${text}`);
  }
  put('q', address.quantity);
  put('mq', address.mapQuantity);
  put('ml', address.mapLines ? 1 : undefined);
  put('st', address.station);
  if (address.range) put('range', address.range.map((value) => Number(value.toPrecision(9))).join(','));
  const { length, speed, frequency, amplitude } = address.units;
  put('units', [length, speed, frequency, amplitude].join(','));
  put('method', address.computation.method);
  for (const { key } of LENGTHS_OF_RUNS) put(key, address.computation[key]);
  const { mode, decrement, all: every, probe } = address.rest;
  put('mode', mode > 0 ? mode + 1 : undefined);
  put('damping', decrement ? 'decrement' : undefined);
  put('modes', every ? 'all' : undefined);
  put('probe', probe);
  put('t', Number(address.time.toPrecision(6)));
  return `#${all.toString()}`;
}

/// Returns the assignments in the form of the engine and the command.
export function assignmentTexts(assignments: Assignments): string[] {
  return Array.from(assignments, ([name, text]) => `${name}=${text}`);
}
