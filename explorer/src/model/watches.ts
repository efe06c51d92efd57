// Running animations of settling motions, at most one for each side.
import type { Trail } from '../view/orbit';
import type { Session, SideName } from './session';
import { Watch } from './watch';

export interface WatchesListener {
  playing(name: SideName, on: boolean): void;
  trail(name: SideName, trail: Trail): void;
  changed(name: SideName): void;
}

export class Watches {
  private readonly running: Partial<Record<SideName, Watch>> = {};

  constructor(
    private readonly session: Session,
    private readonly listener: WatchesListener,
  ) {}

  /// Starts or ends the animation of a side; for a running one only the speed changes.
  set(name: SideName, on: boolean, speed: number): void {
    const running = this.running[name];
    if (running && on) {
      running.revolutionsPerSecond = speed;
      return;
    }
    this.end(name);
    const { engine, original, stations, station } = this.session;
    const info = stations[station];
    if (!on || !engine || !info) return;
    const side = this.session.sides[name];
    const { parameter } = this.session.address;
    const { value } = side.choice;
    // Begin the animation on the orbit of a branch; the motion leaves it if it is unstable.
    const nodes = this.session.orbitOf(side.choice)?.nodes;
    this.listener.playing(name, true);
    this.running[name] = new Watch(
      engine,
      {
        setting: this.session.settingOf(side),
        ...(parameter && Number.isFinite(value) ? { parameter, value } : {}),
        ...(nodes ? { state: nodes } : {}),
      },
      info,
      original?.contacts ?? [],
      `watch-${name}`,
      speed,
      (trail) => this.listener.trail(name, trail),
      (message) => {
        side.trouble = message;
        this.end(name);
        this.listener.changed(name);
      },
    );
  }

  end(name: SideName): void {
    this.running[name]?.stop();
    delete this.running[name];
    this.listener.playing(name, false);
  }

  endAll(): void {
    for (const name of ['a', 'b'] as const) this.end(name);
  }
}
