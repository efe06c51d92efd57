// Exports of a setting: a case file, a command line.
import type { CaseInfo, Edit } from '../engine/protocol';
import { computationOptions, type Address, type Side } from './setting';

type Range = readonly [number, number];

function inUnit(value: number, unit: string): string {
  const number = String(Number(value.toPrecision(12)));
  return unit === '1' || unit === 'SI' || unit === '' ? number : `${number} ${unit}`;
}

/// Returns the edits that make a sweep over the view, with as many points as the case's sweep. They remove other keys
/// that choose values: a list, a step, and a logarithmic scale if the view is linear.
function sweepEdits(parameter: string, unit: string, sweep: CaseInfo['batches'][number], view: Range): Edit[] {
  const falling = (sweep.values[0] ?? 0) > (sweep.values.at(-1) ?? 0);
  const [from, to] = falling ? [view[1], view[0]] : view;
  const edits: Edit[] = [{ path: 'study.sweep.values' }, { path: 'study.sweep.step' }];
  if (sweep.parameter !== parameter || !(from / to > 0)) edits.push({ path: 'study.sweep.scale' });
  const put = (key: string, text: string) => edits.push({ path: `study.sweep.${key}`, text });
  put('parameter', parameter);
  put('points', String(Math.max(sweep.values.length, 2)));
  put('to', inUnit(to, unit));
  put('from', inUnit(from, unit));
  return edits;
}

/// Returns the edits that turn the case into a case with this setting: the view becomes the sweep, the cursor's value
/// its first detail.
export function caseEdits(original: CaseInfo, address: Address, side: Side, view: Range, whole: Range): Edit[] {
  const edits: Edit[] = [];
  const { parameter, computation } = address;
  const info = original.parameters.find(({ name }) => name === parameter);
  const unit = info?.unit ?? '1';
  const sweep = original.batches.find(({ name }) => name === 'sweep');
  const put = (path: string, text: string) => edits.push({ path, text });
  if (sweep) {
    if (sweep.parameter !== parameter || view[0] !== whole[0] || view[1] !== whole[1])
      edits.push(...sweepEdits(parameter, unit, sweep, view));
    // Replace the values of the case's detail, which belong to its swept parameter.
    const detail = original.batches.find(({ name }) => name === 'detail');
    if (detail && detail.parameter !== parameter)
      put('study.detail.at', `[${inUnit(Number.isFinite(side.value) ? side.value : (view[0] + view[1]) / 2, unit)}]`);
    else if (detail && Number.isFinite(side.value)) put('study.detail.at[1]', inUnit(side.value, unit));
  } else if (parameter && Number.isFinite(side.value)) put(`parameters.${parameter}`, inUnit(side.value, unit));
  for (const [option, value] of Object.entries(computationOptions(computation)))
    put(`study.integrate.${option}`, String(value));
  return edits;
}

/// Returns a shell command that computes a case and contains its text.
export function commandOf(text: string, name: string): string {
  let mark = 'CASE';
  while (text.split('\n').includes(mark)) mark += '_';
  return (
    `cat >${name}.yaml <<'${mark}'\n${text.endsWith('\n') ? text : `${text}\n`}${mark}\n` +
    `whirl run ${name}.yaml -o ${name}.h5 && whirl report ${name}.h5 -o ${name}\n`
  );
}
