// The frame of a card with charts: title, choices of the charts, menu to save; and what dragging does in them.
import { el, Segments } from '../dom';
import { fileName, saveMenu } from './panel';
import type { RestChart } from './rest_subject';
import type { Mode, Stack } from './stack';

/// Charts in a frame.
export type FramedChart = Pick<RestChart, 'title' | 'stack' | 'tools' | 'picture' | 'table'>;

/// What dragging does in charts; `point`: what it shows at the cursor.
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

/// A card with charts; `name`: what saved files are named after, `content`: below the head.
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
