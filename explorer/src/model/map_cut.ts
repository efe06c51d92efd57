// A row or column of a map as a diagram, in which the map's other parameter has an assigned value.
import type { Diagram } from '../data/diagram';
import { nearestOn, type ParameterMap } from '../data/parameter_map';

export interface Cut {
  /// Unique key of the cut.
  readonly key: string;
  diagram(): Diagram;
  /// Place of the cut for display: "rho = 0.08".
  readonly of: string;
  /// Assignments with which its points are computed.
  readonly assignments: readonly string[];
}

/// Relative difference below which numbers count as equal, for the last digits of a text.
const SAME = 1e-9;

/// Returns a value as an assignment with all digits: "0.08", "650 rad/s".
export function plainText(value: number, unit: string): string {
  return unit === '1' || unit === 'SI' ? String(value) : `${value} ${unit}`;
}

/// Returns the value of a text in the form of `plainText`; undefined for another unit.
export function plainValue(text: string, unit: string): number | undefined {
  const [, number = '', of = ''] = /^\s*([-+.\deE]+)\s*(.*?)\s*$/.exec(text) ?? [];
  const plain = unit === '1' || unit === 'SI' ? '' : unit;
  return number !== '' && of === plain && Number.isFinite(Number(number)) ? Number(number) : undefined;
}

/// Position of a machine in the space of a map.
export interface MapPlace {
  /// Assigned texts; other parameters have the value of the case.
  readonly assignments: ReadonlyMap<string, string>;
  /// Returns the value of a parameter in SI.
  valueOf(parameter: string): number;
  /// Returns the SI unit of a parameter.
  unitOf(parameter: string): string;
}

/// Returns the cut along a parameter nearest to the machine's position; the map's other parameters are constant.
export function cutOf(map: ParameterMap, along: string, place: MapPlace): Cut {
  const { parameter, values } = map.across(along);
  const index = nearestOn(map.across(along), place.valueOf(parameter));
  const constant = [{ parameter, value: values[index]! }, ...(map.plane ? [map.plane] : [])];
  const texts = new Map<string, string>();
  for (const { parameter: name, value } of constant) {
    const text = place.assignments.get(name);
    const meets = Math.abs(place.valueOf(name) - value) <= SAME * Math.abs(value);
    if (!meets) texts.set(name, plainText(value, place.unitOf(name)));
    else if (text !== undefined) texts.set(name, text);
  }
  // Keep the order of the user's assignments.
  const order = [...place.assignments.keys(), ...texts.keys()].filter((name, i, all) => all.indexOf(name) === i);
  const assignments = order.flatMap((name) => (texts.has(name) ? [`${name}=${texts.get(name)!}`] : []));
  const of = constant.map(({ parameter: name, value }) => {
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
