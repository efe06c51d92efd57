// What the engine refuses, in the words of the page: it speaks of places and keys of a file, the page has controls.
import type { ParameterInfo } from '../engine/protocol';
import { LENGTHS_OF_RUNS } from './setting';

/// "FILE:LINE:COLUMN: KEY: SENTENCE"; a problem with all of the file has no key.
const OF_FILE = /^(?:.*?:)?\d+:\d+: (?:([\w.[\]-]+): )?(.*)$/s;

/// What the page calls keys that are no parameter's.
const CONTROLS: ReadonlyMap<string, string> = new Map([
  ...LENGTHS_OF_RUNS.map(({ option, label }) => [`study.integrate.${option}`, label] as const),
  ['study.integrate.method', 'Method'],
]);

/// The control that a key of the case follows from, and what is said of it there.
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

/// Sentences that name no place of a file stay as they are.
export function inWordsOfPage(sentence: string, parameters: readonly ParameterInfo[]): string {
  const [, key = '', what] = OF_FILE.exec(sentence) ?? [];
  if (what === undefined) return sentence;
  return ofControl(key, what, parameters) ?? ['In the case', key && `, ${key}`, `: ${what}`].join('');
}
