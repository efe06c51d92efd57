// Starts the page: reads the runs, starts the engine and the application.
import { App } from './app';
import { readRuns } from './data/run';
import { el } from './dom';
import { wakeEngine } from './engine_parts';

async function main(): Promise<void> {
  document.getElementById('whirl-silent')?.remove();
  const runs = readRuns(document.getElementById('whirl-runs')?.textContent ?? '');
  let app: App | undefined;
  let broken = '';
  const { engine, missing } = await wakeEngine((why) => {
    broken = why;
    app?.lose(why);
  });
  if (runs.length === 0 && !engine) {
    document.body.append(
      el(
        'p',
        { class: 'empty' },
        'This page holds no run and nothing to compute one with: it is a template for `whirl report`.',
      ),
    );
    return;
  }
  app = new App(runs, engine, missing);
  document.body.append(app.root);
  app.start();
  if (broken) app.lose(broken);
}

main().catch((error: unknown) =>
  document.body.append(el('p', { class: 'empty', role: 'alert' }, `This page cannot start: ${String(error)}`)),
);
