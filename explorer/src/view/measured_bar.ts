// Measured data over the machine: the files, where they can be seen, and the sentences on files that were refused.
import type { MeasuredData } from '../data/measured';
import { button, el } from '../dom';
import type { NamedFile } from '../model/measured';
import { ColumnChooser, type ChooserListener } from './column_chooser';
import { VECTORS, type Session } from '../model/session';
import { parameterMeasure, shownWhole } from '../model/units';

export interface MeasuredListener extends ChooserListener {
  files(files: readonly NamedFile[]): void;
  removed(name: string): void;
  forgiven(): void;
  asked(name: string): void;
}

export class MeasuredBar {
  readonly root: HTMLElement;
  private readonly list = el('ul', { 'aria-label': 'Measured data' });
  private readonly trouble = el('p', { class: 'trouble', role: 'alert' });
  private readonly troubles: HTMLElement;
  private readonly chooser: ColumnChooser;
  private readonly input = el('input', {
    type: 'file',
    accept: '.csv,.txt,.tsv,.h5,.hdf5,.mat,.uff,.unv,text/csv',
    multiple: true,
    hidden: true,
  });
  private text = '';

  constructor(private readonly listener: MeasuredListener) {
    this.chooser = new ColumnChooser(listener);
    this.troubles = el(
      'div',
      { class: 'troubles' },
      this.trouble,
      button('\u00d7', 'Close this message', () => listener.forgiven(), { class: 'icon' }),
    );
    this.input.setAttribute('aria-label', 'Files of measured data');
    this.input.addEventListener('change', () => {
      listener.files([...(this.input.files ?? [])]);
      this.input.value = ''; // the same file may be chosen again
    });
    this.root = el(
      'section',
      { class: 'measured', 'aria-label': 'Measured data' },
      this.list,
      this.troubles,
      this.chooser.root,
      this.input,
    );
  }

  /// Opens the browser's choice of files.
  choose(): void {
    this.input.click();
  }

  show(session: Session): void {
    const { measured, measuredData: data, measurable } = session;
    const more = measured.troubles.length > 0 || measured.asked.length > 0;
    this.root.hidden = !more && !(measurable && data.length > 0);
    this.chooser.show(
      measured.asked,
      session.stations.map(({ name }) => name),
    );
    this.troubles.hidden = measured.troubles.length === 0;
    this.trouble.textContent = measured.troubles.join('\n');
    // Rebuild only after a change, so that the focus stays.
    const rows = data.map(
      (each) =>
        [
          each.name,
          textOf(session, each),
          whereOf(session, each),
          measured.hasColumns(session.machine.name, each.name),
        ] as const,
    );
    const text = JSON.stringify(rows);
    if (text === this.text) return;
    this.text = text;
    this.list.replaceChildren(
      ...rows.map(([name, what, where, columns]) =>
        el(
          'li',
          {},
          el('span', { class: 'key key-measured' }, el('strong', {}, name), `: ${what}`),
          el('span', { class: 'unseen-data' }, where),
          ...(columns ? [button('columns', `Choose the columns of ${name}`, () => this.listener.asked(name))] : []),
          button('\u00d7', `Remove ${name}`, () => this.listener.removed(name), { class: 'icon' }),
        ),
      ),
    );
  }
}

/// "orbit of disc, 64 instants"
function textOf({ stations, address }: Session, data: MeasuredData): string {
  const names = data.stations.map((station) => stations[station]?.name ?? '').join(', ');
  const speed = parameterMeasure('rad/s', address.units);
  const at = Number.isFinite(data.speed) ? ` at ${shownWhole(data.speed * speed.factor)} ${speed.unit}` : '';
  const count = data.at.length;
  if (data.kind === 'orbit') return `orbit of ${names}${at}, ${count} instants`;
  if (data.kind === 'waveform') return `waveform of ${names}${at}, ${count} samples`;
  const orders = [...new Set(data.channels.map(({ order }) => `${order}X`))].join(', ');
  return `${orders} of ${names} at ${count} ${data.parameter ? `values of ${data.parameter}` : 'speeds'}`;
}

/// Says why data cannot be seen, or "" if they can.
function whereOf(session: Session, data: MeasuredData): string {
  const { address, stations, station, side, runsUp, atRest } = session;
  if (!data.stations.includes(station))
    return `choose the station ${data.stations.map((each) => stations[each]?.name ?? '').join(' or ')}`;
  if (data.kind !== 'vectors') {
    if (runsUp || atRest) return 'no picture here shows a motion over its angle';
    const speed = side.result?.speed ?? NaN;
    if (Math.abs(data.speed - speed) > 2e-3 * speed) return 'measured at another speed';
    return '';
  }
  if (runsUp) return data.parameter ? 'the run is over the speed' : '';
  if (atRest)
    return data.parameter && data.parameter !== address.parameter ? `the diagram is over ${address.parameter}` : '';
  const shown = VECTORS.get(address.quantity);
  if (data.parameter ? data.parameter !== address.parameter : !session.isSpeed(address.parameter))
    return `the diagram is over ${address.parameter}, not over ${data.parameter || 'the speed'}`;
  if (!shown) return 'choose 1X amplitude or phase lag in the diagram';
  const seen = data.seen(station, shown.direction);
  return !seen || (shown.lag && !seen.lags) ? 'no probe of it measured what the diagram shows' : '';
}
