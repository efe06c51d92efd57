// Figures that the report put into the page as data, of results that have no view of their own.
import { el } from '../dom';
import { pictureOfDescribed, tableOfDescribed, type Described } from '../figure/described';
import { fileName, saveMenu } from './panel';

/// A card with the picture, its caption, and what can be taken away.
function cardOf(figure: Described): HTMLElement {
  const picture = pictureOfDescribed(figure);
  const drawn = new DOMParser().parseFromString(picture.svg, 'image/svg+xml').documentElement;
  const frame = el('figure', { class: 'described' });
  frame.append(document.importNode(drawn, true));
  const whole = { root: frame, redraw: () => undefined, picture: () => picture };
  const name = () => fileName(figure.name);
  return el(
    'section',
    { class: 'card map-card', 'aria-label': figure.title },
    el(
      'header',
      {},
      el('h2', {}, figure.title),
      saveMenu(
        figure.title,
        name,
        () => whole,
        () => tableOfDescribed(figure),
      ),
    ),
    frame,
    el('p', { class: 'how' }, figure.caption),
  );
}

export class FiguresView {
  readonly root = el('div', { class: 'figures' });
  private shown: readonly Described[] | undefined;

  show(figures: readonly Described[]): void {
    if (figures !== this.shown) this.root.replaceChildren(...figures.map(cardOf));
    this.shown = figures;
  }
}
