// Contents of a result: the drawing of the machine, then every table with its findings (statements, sheets and figures)
// and the tables of its live view (src/report/explorer_contents.c writes them).
import type { MeasuredTable } from '../engine/protocol';
import type { Described } from '../figure/described';
import type { Run, StoredTable } from './run';

export interface Statement {
  readonly table: string;
  readonly what: string;
  readonly station?: string;
  readonly clause?: string;
  readonly verdict: string;
  /// The whole sentence.
  readonly text: string;
}

export interface Column {
  readonly heading: string;
  readonly unit: string;
  readonly size: number;
  /// Offset of temperature units, subtracted from a number over `size`.
  readonly zero?: number;
  readonly digits: number;
}

export interface Sheet {
  readonly table: string;
  readonly name: string;
  readonly title: string;
  readonly about?: string;
  /// Numbers to look up, which are folded at first.
  readonly looked_up?: boolean;
  readonly columns: readonly Column[];
  /// Numbers in SI (several in some cells) or texts; null for an empty cell.
  readonly rows: readonly (readonly (number | string | null | readonly (number | null)[])[])[];
  /// The cells as documents show them.
  readonly shown: readonly (readonly string[])[];
}

/// Stored contents of a result whose live views do not show all of it.
export interface StoredContents {
  readonly parts?: readonly {
    readonly table: string;
    readonly title: string;
    readonly view: LiveView;
  }[];
  readonly statements?: readonly Statement[];
  readonly sheets?: readonly Sheet[];
  /// Figures of the machine have the table "".
  readonly figures?: readonly { readonly table: string; readonly figure: Described }[];
  /// Titles of figures that are too large for the page.
  readonly left_out?: readonly string[];
  readonly warnings?: readonly string[];
  readonly fits?: readonly StoredFit[];
  /// Shaft lines between stations, of modes and responses of few points.
  readonly lines?: readonly StoredLines[];
}

/// A fitted parameter; numbers are in SI, null if they are not known.
export interface FittedParameter {
  readonly name: string;
  readonly value: number | null;
  /// Standard error, and half the width of the 95 % interval.
  readonly error: number | null;
  readonly half: number | null;
  /// "yes", "at its bound", "hardly", "no"
  readonly determined: string;
}

/// A fit whose machine the page computes (src/report/explorer_fit.c).
export interface StoredFit {
  readonly table: string;
  /// The case with the fitted values, and with motions.
  readonly case_text: string;
  readonly unknowns: readonly FittedParameter[];
  readonly measured: readonly { readonly name: string; readonly table: MeasuredTable }[];
}

/// Places along shafts, and how they move at every point in every mode (one "mode" for a response), as finite elements
/// bend.
export interface StoredLines {
  readonly table: string;
  readonly modes: number;
  /// [places] number of the shaft, from 1.
  readonly shaft: readonly number[];
  /// [places] m along the shaft, float64, little-endian, base64.
  readonly position: string;
  /// [points][modes][places][4] x cos, x sin, y cos, y sin in the units of shapes, or in length scales; float32,
  /// little-endian, base64; NaN where a line is not known.
  readonly moved: string;
}

export type LiveView = 'modes' | 'unbalance' | 'motions' | 'fit' | 'runup' | '';

export interface Part {
  /// Name in addresses: MACHINE, or the name of the part's first table.
  readonly id: string;
  readonly title: string;
  readonly view: LiveView;
  /// The run with only the tables of the live view.
  readonly run: Run;
  /// The fit whose machine is live; undefined for other views.
  readonly fit: StoredFit | undefined;
  /// Warnings of the run; empty but for the machine.
  readonly notes: readonly string[];
  readonly statements: readonly Statement[];
  readonly sheets: readonly Sheet[];
  readonly figures: readonly Described[];
}

export const MACHINE = 'machine';

const known = new WeakMap<Run, readonly Part[]>();

/// Returns the parts of a result in the order of its tables, the machine first; none if live views show everything.
export function partsOf(run: Run | undefined): readonly Part[] {
  if (!run?.parts) return [];
  const found = known.get(run) ?? readParts(run, run.parts);
  known.set(run, found);
  return found;
}

function readParts(run: Run, parts: NonNullable<StoredContents['parts']>): readonly Part[] {
  const { statements = [], sheets = [], figures = [], warnings = [], left_out = [] } = run;
  const made = (id: string, title: string, view: LiveView, names: readonly string[]): Part => {
    const of = <T extends { readonly table: string }>(list: readonly T[]) =>
      list.filter(({ table }) => names.includes(table));
    const fit = view === 'fit' ? run.fits?.find(({ table }) => table === id) : undefined;
    // The fitted machine differs from that of the case, to which stored tables and motions belong: leave them out.
    const { opening, ...rest } = run;
    const tables: StoredTable[] = view && !fit ? run.tables.filter(({ name }) => names.includes(name)) : [];
    return {
      ...{ id, title, view, fit },
      run: { ...rest, tables, ...(opening && !fit && { opening }) },
      notes: [],
      statements: of(statements),
      sheets: of(sheets),
      figures: of(figures).map(({ figure }) => figure),
    };
  };
  // All tables of motions share one live view.
  const motions = parts.filter(({ view }) => view === 'motions').map(({ table }) => table);
  const machine = made(MACHINE, 'The machine', '', ['']);
  const left = left_out.map((title) => `${title}: this figure is too large for the page; the report has it.`);
  return [
    { ...machine, notes: [...warnings, ...left] },
    ...parts
      .filter(({ table, view }) => view !== 'motions' || table === motions[0])
      .map(({ table, title, view }) => {
        const alone = parts.filter((other) => other.title === title && other.view === view).length === 1;
        const names = view === 'motions' ? motions : [table];
        return made(table, alone || view === 'motions' ? title : `${title}: ${table}`, view, names);
      }),
  ];
}

/// Returns the part that an address names; without a name the machine or, if there is exactly one other part, that
/// part.
export function partOf(run: Run | undefined, id: string): Part | undefined {
  const parts = partsOf(run);
  return parts.find((part) => part.id === id) ?? parts[parts.length === 2 ? 1 : 0];
}

/// Returns the heading of a column with its unit.
export const headingOf = ({ heading, unit }: Column): string => (unit ? `${heading} (${unit})` : heading);

/// Returns the sentence of a statement in pieces: the place, the subject, and the rest.
export function piecesOf({ text, what, station }: Statement): readonly [string, string, string] {
  const name = what + (station ? ` at ${station}` : '');
  const begins = text.indexOf(name);
  return [text.slice(0, begins), name, text.slice(begins + name.length)];
}
