// Converts rejections of the engine, which name places and keys of a file, to messages about controls of the page.
import type { ParameterInfo } from '../engine/protocol';
import { LENGTHS_OF_RUNS } from './setting';

/// Message of the form "FILE:LINE:COLUMN: KEY: SENTENCE"; a problem of the whole file has no key.
const OF_FILE = /^(?:.*?:)?\d+:\d+: (?:([\w.[\]-]+): )?(.*)$/s;

/// Names of keys that are not parameters on the page.
const CONTROLS: ReadonlyMap<string, string> = new Map([
  ...LENGTHS_OF_RUNS.map(({ option, label }) => [`study.integrate.${option}`, label] as const),
  ['study.integrate.method', 'Method'],
]);

/// Returns the control on which a key of the case depends, with the sentence for it.
function ofControl(key: string, sentence: string, parameters: readonly ParameterInfo[]): string | undefined {
  const named = CONTROLS.get(key) ?? /^parameters\.(\w+)$/.exec(key)?.[1];
  if (named) return `${named}: ${sentence}`;
  const found = parameters.flatMap(({ name, uses }) =>
    uses.filter(({ path }) => path === key).map(({ meaning, alone }) => ({ name, meaning, alone })),
  );
  const [first] = found;
  if (first?.alone) return `${first.name}: ${sentence.replace(/^= \S+ /, '')}`;
  return first && `${found.map(({ name }) => name).join(', ')}: ${first.meaning} ${sentence}`;
}

/// Converts a sentence; sentences without a place in a file are unchanged.
export function inWordsOfPage(sentence: string, parameters: readonly ParameterInfo[]): string {
  const [, key = '', what] = OF_FILE.exec(sentence) ?? [];
  if (what === undefined) return sentence;
  return ofControl(key, what, parameters) ?? ['In the case', key && `, ${key}`, `: ${what}`].join('');
}
