// Undo and redo: what the reader does becomes entries of the browser's history, whose addresses hold the setting. A
// drag is one entry, and so are keys and turns of the wheel that change the same things again within a second.
const PAUSE = 250; // ms without a change before the address is written
const SAME = 1000; // ms in which a change of the same things goes on with the entry before

/// The keys whose values differ between two addresses.
function difference(one: string, other: string): string {
  const [a, b] = [one, other].map((hash) => new URLSearchParams(hash.slice(1)));
  const keys = new Set([...a!.keys(), ...b!.keys()]);
  const parts = (all: URLSearchParams, key: string) => all.getAll(key).sort();
  return [...keys]
    .flatMap((key) => {
      const [before, after] = [parts(a!, key), parts(b!, key)];
      // Which parameters are set counts, not to what.
      const changed = [
        ...before.filter((text) => !after.includes(text)),
        ...after.filter((text) => !before.includes(text)),
      ];
      return changed.map((text) => (key.endsWith('set') ? `${key}:${text.split('=')[0]}` : key));
    })
    .filter((key, i, all) => all.indexOf(key) === i)
    .join();
}

export class History {
  private step: number;
  private newest: number;
  private written = location.hash;
  /// The reader has done something since the address was written; what the page itself fills in is no entry.
  private acted: '' | 'keys' | 'pointer' = '';
  private held = false;
  private last = { keys: '', time: -Infinity };
  private timer = 0;

  /// `restore` is given an address that the reader went to.
  constructor(
    private readonly address: () => string,
    restore: (hash: string) => void,
  ) {
    this.step = this.newest = Number((history.state as { step?: number } | null)?.step) || 0;
    history.replaceState({ step: this.step }, ''); // else the way back to here looks like an address that was typed in
    for (const event of ['keydown', 'wheel', 'input', 'change'])
      document.addEventListener(event, () => (this.acted ||= 'keys'), { capture: true, passive: true });
    document.addEventListener('pointerdown', () => ((this.held = true), (this.acted = 'pointer')), true);
    for (const event of ['pointerup', 'pointercancel'])
      document.addEventListener(event, () => (this.held = false), true);
    window.addEventListener('popstate', (event) => {
      clearTimeout(this.timer);
      const step = (event.state as { step?: number } | null)?.step;
      this.step = step ?? this.step + 1; // an address that was typed in is a new entry
      this.newest = step === undefined ? this.step : Math.max(this.newest, this.step);
      this.acted = '';
      this.last = { keys: '', time: -Infinity };
      restore(location.hash);
      // What the page makes of it is no deed of the reader's.
      this.written = this.address();
      history.replaceState({ step: this.step }, '', this.written);
    });
  }

  /// Writes the address once nothing has changed for a moment and no button is held.
  soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (this.held ? this.soon() : this.write()), PAUSE);
  }

  write(): void {
    clearTimeout(this.timer);
    const hash = this.address();
    if (hash === this.written) return;
    const [keys, time] = [difference(this.written, hash), performance.now()];
    const goesOn = this.acted === 'keys' && keys === this.last.keys && time - this.last.time < SAME;
    if (this.acted && !goesOn) {
      this.newest = ++this.step;
      history.pushState({ step: this.step }, '', hash);
    } else history.replaceState({ step: this.step }, '', hash);
    if (this.acted) this.last = { keys, time: this.acted === 'keys' ? time : -Infinity };
    this.written = hash;
    this.acted = '';
  }

  undo(): void {
    this.write();
    if (this.step > 0) history.back();
  }

  redo(): void {
    this.write();
    if (this.step < this.newest) history.forward();
  }
}
