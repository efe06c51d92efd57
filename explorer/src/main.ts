// Starts the page: reads the runs, wakes the engine, hands over.
import { App } from './app';
import { readRuns } from './data/run';
import { el } from './dom';
import { wakeEngine } from './engine_parts';

async function main(): Promise<void> {
  const runs = readRuns(document.getElementById('whirl-runs')?.textContent ?? '');
  const { engine, missing } = await wakeEngine();
  if (runs.length === 0 && !engine) {
    document.body.append(el('p', { class: 'empty' }, 'This page holds no run and nothing to compute one with: it is a template for `whirl report`.'));
    return;
  }
  const app = new App(runs, engine, missing);
  document.body.append(app.root);
  app.start();
}

void main();
