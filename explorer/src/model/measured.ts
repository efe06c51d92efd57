// Measured data that the user has laid over a machine.
import { MeasuredData, type MeasuredMotion } from '../data/measured';
import type { Spectrum } from '../data/motion';
import type { Engine, Setting } from '../engine/protocol';

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

export class Measured {
  private readonly all = new Map<string, MeasuredData[]>();
  private readonly spectra = new Map<string, Float64Array | undefined>();
  private readonly ids = new WeakMap<MeasuredData, number>();
  private next = 0;
  /// Reasons why files were refused, a sentence each.
  troubles: readonly string[] = [];

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
      const outcome = await this.read(setting, file);
      if (typeof outcome === 'string') troubles.push(outcome);
      else if (outcome) read.push(outcome);
    }
    const names = read.map(({ name }) => name);
    this.all.set(machine, [...this.of(machine).filter(({ name }) => !names.includes(name)), ...read]);
    this.troubles = troubles;
    this.listener.changed();
    return read;
  }

  private async read(setting: Setting, file: NamedFile): Promise<MeasuredData | string | undefined> {
    if (file.size > MAX_BYTES)
      return `${file.name} has ${Math.ceil(file.size / (1 << 20))} MiB, expected a file of at most 16 MiB`;
    let bytes: Uint8Array;
    try {
      bytes = new Uint8Array(await file.arrayBuffer());
    } catch (error) {
      return `${file.name} cannot be read: ${error instanceof Error ? error.message : String(error)}`;
    }
    const outcome = await this.engine?.measured(setting, file.name, bytes, { priority: 0 });
    if (outcome?.ok) return new MeasuredData(file.name, outcome.value);
    return outcome && outcome.why !== 'stale' ? outcome.message : undefined;
  }

  remove(machine: string, name: string): void {
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
