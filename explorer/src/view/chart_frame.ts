// The frame of a card with charts: title, choices of the charts, menu to save, and buttons for the effect of dragging.
import { el, Segments } from '../dom';
import { fileName, saveMenu } from './panel';
import type { RestChart } from './rest_subject';
import type { Mode, Stack } from './stack';

/// Charts in a frame.
export type FramedChart = Pick<RestChart, 'title' | 'stack' | 'tools' | 'picture' | 'table'>;

/// Makes buttons for the effect of dragging in charts; `point`: the object that charts show at the cursor, for the
/// title.
export function dragModes(stack: Stack, point: string): Segments {
  return new Segments(
    'What dragging does',
    [
      { value: 'point', text: 'Point', title: `Drag: ${point} under the cursor` },
      { value: 'range', text: 'Range', title: 'Drag: enlarge that range, or that rectangle' },
      { value: 'pan', text: 'Pan', title: 'Drag: move the view; the wheel zooms' },
    ],
    'point',
    (value) => (stack.mode = value as Mode),
  );
}

/// Makes a card with charts; `name`: returns the stem of names of saved files, `content`: elements below the head.
export function chartFrame(chart: FramedChart, name: () => string, ...content: readonly HTMLElement[]): HTMLElement {
  const { title, stack, tools } = chart;
  const figure = { root: stack.root, redraw: () => stack.redraw(), picture: () => chart.picture() };
  const save = saveMenu(
    title,
    () => fileName('whirl', name(), title),
    () => figure,
    () => chart.table(),
  );
  return el(
    'section',
    { class: 'card map-card', 'aria-label': title },
    el('header', {}, el('h2', {}, title), el('div', { class: 'tools' }, ...tools, save)),
    ...content,
  );
}
