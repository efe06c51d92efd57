// The motion with which the page opens: it is stored, so that it is visible before the engine has computed anything.
import { findField, type Field, type MotionResult } from '../engine/protocol';
import { float32Of, type Run, type StoredOpening } from './run';
import { FIELD } from './fields';

/// Returns the stored motion in the form of the engine's results.
export function storedMotion(run: Run, opening: StoredOpening): MotionResult {
  const fields: Field[] = [];
  let size = 0;
  for (const { data: _, ...field } of opening.fields) {
    fields.push({ ...field, offset: size });
    size += field.repeat * field.rows * field.columns;
  }
  const block = new Float64Array(size);
  opening.fields.forEach(({ data, rows, columns, repeat }, i) => {
    const numbers = float32Of(data); // [repeat][columns][rows]
    for (let at = 0; at < numbers.length; at++) {
      const [row, column, which] = [at % rows, Math.floor(at / rows) % columns, Math.floor(at / rows / columns)];
      if (which < repeat) block[fields[i]!.offset + (which * rows + row) * columns + column] = numbers[at]!;
    }
  });
  const layout = { size, fields };
  const { method, method_chosen, steps_per_revolution, transient, record, watch, waveform_revolutions } = opening;
  const waveform = findField(layout, FIELD.WAVEFORM_SAMPLES)?.rows ?? 0;
  return {
    value: opening.value,
    verdict: { ...opening.verdict, provisional: false, divergedAt: 0 },
    layout,
    block,
    lengthScale: opening.length_scale,
    speed: opening.speed,
    keyphasor: opening.keyphasor,
    stations: run.stations,
    samplesPerRevolution: waveform / (waveform_revolutions || 1) || 1,
    options: { method, method_chosen, steps_per_revolution, transient, record, watch, waveform_revolutions },
    seconds: 0,
  };
}
