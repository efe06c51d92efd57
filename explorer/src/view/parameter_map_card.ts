// The card of a map: its quantity, the cell under the cursor, and the parameter of its cut.
import { ATTRACTOR, mapQuantitiesOf, REGIME } from '../data/map_quantities';
import { theme } from '../figure/figure';
import { button, el, Segments, select, setChoices } from '../dom';
import { fileName, saveMenu } from './panel';
import { canRefine, FINE, type MapPart } from '../model/map_refinement';
import { parameterMeasure } from '../model/units';
import { ParameterMapView, type ParameterMapSubject, type Spot } from './parameter_map';

export interface ParameterMapCardListener {
  /// Called after a cell with these values was chosen; `settled` after the pointer was released.
  cell(spot: Spot, settled: boolean): void;
  mapQuantity(id: string): void;
  mapLines(shown: boolean): void;
  /// Called to show another plane; `index`: its number, from 0, along rising values of the third parameter.
  plane(index: number): void;
  /// Called to compute finer cells of a part; undefined: stop.
  refine(part: MapPart | undefined): void;
  station(index: number): void;
  /// Called to cut the map along a parameter.
  parameter(name: string): void;
}

export interface ParameterMapCardSubject extends ParameterMapSubject {
  /// Parameter of the cut, which may be none of the map's parameters.
  readonly along: string;
  /// Number of the shown plane, and the SI unit of the third parameter.
  readonly plane: number;
  readonly unitOfPlanes: string;
  /// A sentence that describes the map.
  readonly status: string;
  /// True while finer cells are being computed; undefined if they cannot be.
  readonly refining: boolean | undefined;
  /// True if the map belongs to other parameters than the present ones.
  readonly stale: boolean;
  readonly name: string;
}

export class ParameterMapCard {
  readonly root: HTMLElement;
  readonly map: ParameterMapView;
  private subject: ParameterMapCardSubject | undefined;
  private hovered: Spot | undefined;
  private readonly quantity: HTMLSelectElement;
  private readonly station: HTMLSelectElement;
  private readonly cut: Segments;
  private readonly lines: HTMLButtonElement;
  private readonly whole = button('whole', 'The whole map', () => this.map.unzoom(), { hidden: true });
  private readonly finer: HTMLButtonElement;
  private readonly place = el('span', { class: 'map-place' });
  private readonly verdict = el('strong', { class: 'verdict' });
  private readonly rest = el('span', { class: 'map-rest' });
  private readonly legend = el('div', { class: 'legend' });
  private readonly status = el('p', { class: 'map-status' });
  private readonly slider = el('input', { type: 'range', min: 0, step: 1 });
  private readonly planeText = el('span', { class: 'plane-value' });
  private readonly planes = el('label', { class: 'planes', hidden: true }, this.planeText, this.slider);

  constructor(listener: ParameterMapCardListener) {
    this.map = new ParameterMapView({
      cell: (spot, settled) => listener.cell(spot, settled),
      hover: (spot) => {
        this.hovered = spot;
        this.tell();
      },
      zoomed: (part) => {
        this.whole.hidden = !part;
        this.allowFiner();
      },
      turn: () => listener.parameter(this.subject!.map.across(this.subject!.along).parameter),
    });
    this.quantity = select('What the map shows', [], '', (value) => listener.mapQuantity(value));
    this.station = select('Station of the map', [], '', (value) => listener.station(Number(value)));
    this.cut = new Segments(
      'Along which parameter the diagram cuts the map',
      [
        { value: 'x', text: 'row', title: 'The diagram is the row of the cursor (key C turns the cut)' },
        { value: 'y', text: 'column', title: 'The diagram is the column of the cursor (key C turns the cut)' },
      ],
      'x',
      (value) => listener.parameter(this.subject!.map[value as 'x' | 'y'].parameter),
    );
    this.lines = button(
      'boundaries',
      'Boundaries: lines where regimes, or attractors, meet',
      () => listener.mapLines(!this.subject!.lines),
      { 'aria-pressed': 'false' },
    );
    this.finer = button('finer', '', () => listener.refine(this.subject!.refining ? undefined : this.map.part));
    this.slider.addEventListener('input', () => listener.plane(Number(this.slider.value)));
    const name = () => fileName('whirl', this.subject?.name ?? '', 'map', this.subject?.quantity ?? '');
    const figure = { root: this.map.root, redraw: () => this.map.refresh(), picture: () => this.map.picture() };
    this.root = el(
      'section',
      { class: 'card parameter-map-card', 'aria-label': 'Map', hidden: true },
      el(
        'header',
        {},
        el('h2', {}, 'Map'),
        el(
          'div',
          { class: 'tools' },
          this.quantity,
          this.station,
          this.lines,
          this.whole,
          this.finer,
          el('span', { class: 'tool-pair' }, el('span', { class: 'over' }, 'cut'), this.cut.root),
          saveMenu(
            'Map',
            name,
            () => figure,
            () => this.map.table(),
          ),
        ),
      ),
      this.planes,
      this.map.root,
      this.legend,
      el('p', { class: 'map-cell' }, this.place, this.verdict, this.rest),
      this.status,
    );
  }

  /// Shows the card; undefined hides it.
  show(subject: ParameterMapCardSubject | undefined): void {
    this.root.hidden = subject === undefined;
    const fresh = subject?.planes !== this.subject?.planes;
    this.subject = subject;
    if (!subject) return;
    const { map, stations, station, quantity, along } = subject;
    const choices = mapQuantitiesOf(map);
    if (fresh)
      setChoices(
        this.quantity,
        choices.map(({ id, text }) => ({ value: id, text })),
        quantity,
      );
    this.quantity.value = quantity;
    setChoices(
      this.station,
      stations.map(({ name }, i) => ({ value: String(i), text: name })),
      String(station),
    );
    this.station.hidden = stations.length < 2 || !choices.find(({ id }) => id === quantity)?.perStation;
    this.cut.rename('x', `along ${map.x.parameter}`);
    this.cut.rename('y', `along ${map.y.parameter}`);
    this.cut.value = along === map.x.parameter ? 'x' : along === map.y.parameter ? 'y' : '';
    this.lines.setAttribute('aria-pressed', String(subject.lines));
    this.finer.textContent = subject.refining ? 'stop' : 'finer';
    this.status.textContent = subject.status;
    this.root.classList.toggle('stale', subject.stale);
    this.showPlanes(subject);
    this.map.show(subject);
    this.allowFiner();
    this.showLegend(quantity === REGIME.id || quantity === ATTRACTOR.id);
    this.tell();
  }

  setCursors(a: Spot, b: Spot | undefined, active: 'a' | 'b', along: string): void {
    this.map.setCursors(a, b, active, along);
    this.tell();
  }

  private showPlanes({ planes, plane, units, unitOfPlanes }: ParameterMapCardSubject): void {
    this.planes.hidden = planes.count < 2;
    if (this.planes.hidden) return;
    const { factor, unit } = parameterMeasure(unitOfPlanes, units);
    const value = `${Number((planes.values[plane]! * factor).toPrecision(6))}${unit ? ` ${unit}` : ''}`;
    this.planeText.textContent = `${planes.parameter} = ${value}`;
    this.slider.max = String(planes.count - 1);
    this.slider.value = String(plane);
    this.slider.setAttribute('aria-label', `Plane of the map, by ${planes.parameter}`);
    this.slider.setAttribute('aria-valuetext', value);
  }

  /// Enables refinement if few cells are visible and the quantity is not that of attractors, which finer cells do not
  /// have.
  private allowFiner(): void {
    const { refining, quantity } = this.subject!;
    this.finer.hidden = refining === undefined;
    if (refining === undefined) return;
    const why = refining
      ? 'Computes no more cells'
      : quantity === ATTRACTOR.id
        ? 'Attractors need all starts of the run; another quantity has finer cells'
        : canRefine(this.map.part)
          ? 'Computes finer cells of what is seen, in this page'
          : `Zoom in: finer cells are computed of at most ${FINE} by ${FINE}`;
    this.finer.title = why;
    this.finer.disabled = !refining && (quantity === ATTRACTOR.id || !canRefine(this.map.part));
  }

  /// Shows the data of the cell under the pointer or, without a pointer, of the setting's cell.
  private tell(): void {
    const spot = this.subject && (this.hovered ?? this.map.cursor);
    if (!spot) return;
    const { verdict, kind, rest } = this.map.describe(spot);
    this.place.textContent = `${this.map.placeText(spot)}:`;
    this.verdict.textContent = verdict;
    this.verdict.className = kind < 0 ? 'verdict' : `verdict class-${kind}`;
    this.rest.textContent = rest;
  }

  private showLegend(shown: boolean): void {
    this.legend.hidden = !shown;
    if (!shown) return;
    const faint = this.subject!.quantity === REGIME.id;
    this.legend.replaceChildren(
      ...this.map.entries().map(({ text, count, colour }) => {
        const sign = el('span', { class: 'swatch' });
        sign.style.background = colour(theme());
        return el('span', { class: 'legend-entry swatched' }, sign, `${text} `, el('span', { class: 'count' }, count));
      }),
      ...(faint ? [el('span', { class: 'legend-note key-confidence' }, 'faint: confidence fair or low')] : []),
    );
  }
}
