// Undo and redo: actions of the user are entries of the browser's history, whose addresses contain the setting. A drag
// is one entry; keys and wheel turns that change the same things within a second are one entry, too.
const PAUSE = 250; // ms without a change before the address is written
const SAME = 1000; // ms in which a change of the same things belongs to the previous entry

/// Returns the keys whose values differ between two addresses.
function difference(one: string, other: string): string {
  const [a, b] = [one, other].map((hash) => new URLSearchParams(hash.slice(1)));
  const keys = new Set([...a!.keys(), ...b!.keys()]);
  const parts = (all: URLSearchParams, key: string) => all.getAll(key).sort();
  return [...keys]
    .flatMap((key) => {
      const [before, after] = [parts(a!, key), parts(b!, key)];
      // Compare the names of changed parameters, not their values.
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
  /// Kind of the user's input since the address was written; '': none, so that a change makes no entry.
  private acted: '' | 'keys' | 'pointer' = '';
  private pressed = false;
  private last = { keys: '', time: -Infinity };
  private timer = 0;

  /// `restore` is called with an address to which the user navigated.
  constructor(
    private readonly address: () => string,
    restore: (hash: string) => void,
  ) {
    this.step = this.newest = Number((history.state as { step?: number } | null)?.step) || 0;
    history.replaceState({ step: this.step }, ''); // otherwise a return to this entry would look like a typed address
    for (const event of ['keydown', 'wheel', 'input', 'change'])
      document.addEventListener(event, () => (this.acted ||= 'keys'), { capture: true, passive: true });
    document.addEventListener('pointerdown', () => ((this.pressed = true), (this.acted = 'pointer')), true);
    for (const event of ['pointerup', 'pointercancel'])
      document.addEventListener(event, () => (this.pressed = false), true);
    window.addEventListener('popstate', (event) => {
      clearTimeout(this.timer);
      const step = (event.state as { step?: number } | null)?.step;
      this.step = step ?? this.step + 1; // a typed address is a new entry
      this.newest = step === undefined ? this.step : Math.max(this.newest, this.step);
      this.acted = '';
      this.last = { keys: '', time: -Infinity };
      restore(location.hash);
      // Changes by the page itself are not actions of the user.
      this.written = this.address();
      history.replaceState({ step: this.step }, '', this.written);
    });
  }

  /// Writes the address after a moment without changes and pressed buttons.
  soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (this.pressed ? this.soon() : this.write()), PAUSE);
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
