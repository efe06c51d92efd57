// A row or column of a map as a diagram: the other parameter is assigned.
import type { Diagram } from '../data/diagram';
import { nearestOn, type ParameterMap } from '../data/parameter_map';

export interface Cut {
  /// Another one for every other cut.
  readonly key: string;
  diagram(): Diagram;
  /// "rho = 0.08": where the map is cut, for the reader.
  readonly of: string;
  /// That its points are computed with.
  readonly assignments: readonly string[];
}

/// What is the same number, but for the last digits of a text.
const SAME = 1e-9;

/// "0.08", "650 rad/s", as assignments take it, with all digits.
export function plainText(value: number, unit: string): string {
  return unit === '1' || unit === 'SI' ? String(value) : `${value} ${unit}`;
}

/// The value of a text that `plainText` may have written; undefined where it has another unit.
export function plainValue(text: string, unit: string): number | undefined {
  const [, number = '', of = ''] = /^\s*([-+.\deE]+)\s*(.*?)\s*$/.exec(text) ?? [];
  const plain = unit === '1' || unit === 'SI' ? '' : unit;
  return number !== '' && of === plain && Number.isFinite(Number(number)) ? Number(number) : undefined;
}

/// Where a machine is in the space of a map.
export interface MapPlace {
  /// Texts that are assigned; parameters without one have the value of the case.
  readonly assignments: ReadonlyMap<string, string>;
  /// The value that a parameter has, in SI.
  valueOf(parameter: string): number;
  /// Its SI unit.
  unitOf(parameter: string): string;
}

/// The cut along a parameter nearest to where the machine is: all others of the map are held.
export function cutOf(map: ParameterMap, along: string, place: MapPlace): Cut {
  const { parameter, values } = map.across(along);
  const index = nearestOn(map.across(along), place.valueOf(parameter));
  const held = [{ parameter, value: values[index]! }, ...(map.plane ? [map.plane] : [])];
  const texts = new Map<string, string>();
  for (const { parameter: name, value } of held) {
    const text = place.assignments.get(name);
    const meets = Math.abs(place.valueOf(name) - value) <= SAME * Math.abs(value);
    if (!meets) texts.set(name, plainText(value, place.unitOf(name)));
    else if (text !== undefined) texts.set(name, text);
  }
  // In the order in which the reader made them.
  const order = [...place.assignments.keys(), ...texts.keys()].filter((name, i, all) => all.indexOf(name) === i);
  const assignments = order.flatMap((name) => (texts.has(name) ? [`${name}=${texts.get(name)!}`] : []));
  const of = held.map(({ parameter: name, value }) => {
    const shown = plainText(Number(value.toPrecision(6)), place.unitOf(name));
    return `${name} = ${shown}`;
  });
  return {
    key: `${along} ${index} ${map.plane?.value ?? ''} ${assignments.join()}`,
    diagram: () => map.cut(along, index),
    of: of.join(' and '),
    assignments,
  };
}
