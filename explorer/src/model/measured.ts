// Measured data that the user has laid over a machine.
import { MeasuredData, type MeasuredMotion } from '../data/measured';
import type { Spectrum } from '../data/motion';
import type { ChosenColumn, Engine, MeasuredColumn, Setting } from '../engine/protocol';

/// Largest file in bytes.
const MAX_BYTES = 1 << 24;
/// Difference, as part of the speed, up to which a motion was measured at that speed.
const SAME_SPEED = 2e-3;
const MAX_SPECTRA = 64;
const NONE: readonly MeasuredData[] = [];
/// Columns of a row of a spectrum.
const COLUMNS = 5;

export interface NamedFile {
  readonly name: string;
  readonly size: number;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/// A file whose columns the user chooses.
export interface AskedFile {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly columns: readonly MeasuredColumn[];
}

export class Measured {
  /// Bytes of the files that were read, by the name of the machine and of the file.
  private readonly files = new Map<string, Uint8Array>();
  private readonly all = new Map<string, MeasuredData[]>();
  private readonly spectra = new Map<string, Float64Array | undefined>();
  private readonly ids = new WeakMap<MeasuredData, number>();
  private next = 0;
  /// Reasons why files were refused, a sentence each.
  troubles: readonly string[] = [];
  /// Files whose columns are to be chosen before they are shown.
  asked: readonly AskedFile[] = [];

  constructor(
    private engine: Engine | undefined,
    private readonly listener: { changed(): void },
  ) {}

  lose(): void {
    this.engine = undefined;
  }

  /// Returns the data of a machine.
  of(machine: string): readonly MeasuredData[] {
    return this.all.get(machine) ?? NONE;
  }

  /// Adds data that a result stores.
  store(machine: string, data: readonly MeasuredData[]): void {
    if (!this.all.has(machine)) this.all.set(machine, [...data]);
  }

  /// Reads files for the machine of a setting; a file replaces one of the same name. Returns the data that were read.
  async add(machine: string, setting: Setting, files: readonly NamedFile[]): Promise<readonly MeasuredData[]> {
    const read: MeasuredData[] = [];
    const troubles: string[] = [];
    for (const file of files) {
      const bytes = await bytesOf(file);
      const outcome = typeof bytes === 'string' ? bytes : await this.read(machine, setting, file.name, bytes, []);
      if (typeof outcome === 'string') troubles.push(outcome);
      else if (outcome) read.push(outcome);
      // Headings that are not understood are chosen by the user.
      if (typeof outcome === 'string' && typeof bytes !== 'string') await this.list(file.name, bytes);
    }
    this.lay(machine, read);
    this.troubles = troubles;
    this.listener.changed();
    return read;
  }

  /// Reads a file whose columns the user has chosen. Returns the data that were read.
  async choose(
    machine: string,
    setting: Setting,
    name: string,
    columns: readonly ChosenColumn[],
  ): Promise<readonly MeasuredData[]> {
    const file = this.asked.find((each) => each.name === name);
    if (!file) return NONE;
    const outcome = await this.read(machine, setting, name, file.bytes, columns);
    const read = outcome instanceof MeasuredData ? [outcome] : NONE;
    if (outcome instanceof MeasuredData) this.asked = this.asked.filter((each) => each !== file);
    this.lay(machine, read);
    this.troubles = typeof outcome === 'string' ? [outcome] : [];
    this.listener.changed();
    return read;
  }

  /// Lets the user choose the columns of a file that was read.
  async ask(machine: string, name: string): Promise<void> {
    const bytes = this.files.get(keyOf(machine, name));
    if (bytes) await this.list(name, bytes);
    this.listener.changed();
  }

  /// True for a file whose columns can be chosen.
  hasColumns(machine: string, name: string): boolean {
    return this.files.has(keyOf(machine, name));
  }

  /// Ends the choice of the columns of a file.
  dismiss(name: string): void {
    this.asked = this.asked.filter((each) => each.name !== name);
    this.listener.changed();
  }

  /// Adds a file to those whose columns are chosen, unless it has less than two.
  private async list(name: string, bytes: Uint8Array): Promise<void> {
    const outcome = await this.engine?.measuredColumns(name, bytes, { priority: 0 });
    if (!outcome?.ok || outcome.value.length < 2) return;
    this.asked = [...this.asked.filter((each) => each.name !== name), { name, bytes, columns: outcome.value }];
  }

  /// Lays data over a machine, in place of those of the same name.
  private lay(machine: string, read: readonly MeasuredData[]): void {
    const names = read.map(({ name }) => name);
    this.all.set(machine, [...this.of(machine).filter(({ name }) => !names.includes(name)), ...read]);
  }

  private async read(
    machine: string,
    setting: Setting,
    name: string,
    bytes: Uint8Array,
    columns: readonly ChosenColumn[],
  ): Promise<MeasuredData | string | undefined> {
    const outcome = await this.engine?.measured(setting, name, bytes, columns, { priority: 0 });
    if (outcome?.ok) {
      this.files.set(keyOf(machine, name), bytes);
      return new MeasuredData(name, outcome.value);
    }
    return outcome && outcome.why !== 'stale' ? outcome.message : undefined;
  }

  remove(machine: string, name: string): void {
    this.files.delete(keyOf(machine, name));
    this.all.set(
      machine,
      this.of(machine).filter((data) => data.name !== name),
    );
    this.listener.changed();
  }

  refuse(sentence: string): void {
    this.troubles = [sentence];
    this.listener.changed();
  }

  /// Removes the sentences on refused files.
  forgive(): void {
    this.troubles = [];
    this.listener.changed();
  }

  /// Returns the motions at a station that were measured at a speed in rad/s, or at an unknown one, in length scales of
  /// so many m. Spectra follow when they are computed.
  motions(machine: string, station: number, speed: number, lengthScale: number): readonly MeasuredMotion[] {
    return this.of(machine).flatMap((data) => {
      const other = Math.abs(data.speed - speed) > SAME_SPEED * speed;
      if (data.kind === 'vectors' || other) return [];
      const { x, y } = data.displacements(station);
      if (!x && !y) return [];
      const scaled = (values: Float64Array | undefined) => values?.map((value) => value / lengthScale);
      const [own, across, turns] = [scaled(x), scaled(y), data.turns(speed)];
      const rows = this.spectrum(data, station, speed);
      const spectrum = rows && spectrumOf(rows, lengthScale);
      return [
        {
          name: data.name,
          turns,
          ...(own && { x: own }),
          ...(across && { y: across }),
          ...(spectrum && { spectrum }),
        },
      ];
    });
  }

  /// Returns the rows of a motion's spectrum in m; undefined while they are being computed, and if they cannot be.
  private spectrum(data: MeasuredData, station: number, speed: number): Float64Array | undefined {
    const id = this.ids.get(data) ?? this.next++;
    this.ids.set(data, id);
    const key = `${id} ${station} ${data.kind === 'waveform' ? speed : ''}`;
    const { x, y } = data.displacements(station);
    if (this.spectra.has(key) || !this.engine || !(x && y)) return this.spectra.get(key);
    if (this.spectra.size >= MAX_SPECTRA) this.spectra.clear();
    this.spectra.set(key, undefined);
    const request = { turns: data.turns(speed), x, y };
    void this.engine.measuredSpectrum(request, { lane: `measured-${id}-${station}`, priority: 5 }).then((outcome) => {
      if (!outcome.ok) {
        if (outcome.why === 'stale') this.spectra.delete(key);
        return;
      }
      this.spectra.set(key, outcome.value);
      this.listener.changed();
    });
    return undefined;
  }
}

const keyOf = (machine: string, name: string) => JSON.stringify([machine, name]);

/// Returns the bytes of a file, or a sentence.
async function bytesOf(file: NamedFile): Promise<Uint8Array | string> {
  if (file.size > MAX_BYTES)
    return `${file.name} has ${Math.ceil(file.size / (1 << 20))} MiB, expected a file of at most 16 MiB`;
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (error) {
    return `${file.name} cannot be read: ${error instanceof Error ? error.message : String(error)}`;
  }
}

function spectrumOf(rows: Float64Array, lengthScale: number): Spectrum {
  const count = rows.length / COLUMNS;
  const column = (which: number, size: number) =>
    Float64Array.from({ length: count }, (_, i) => rows[COLUMNS * i + which]! / size);
  return {
    order: column(0, 1),
    x: column(1, lengthScale),
    y: column(2, lengthScale),
    forward: column(3, lengthScale),
    backward: column(4, lengthScale),
  };
}
