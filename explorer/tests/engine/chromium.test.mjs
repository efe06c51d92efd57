// Tests the engine in a real Chromium, in a page opened from disk with the strictest Content-Security-Policy under
// which the engine works: its results are compared with those of `whirl run`. Prints how long the page waits.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { chromium } from 'playwright-core';
import { LONG, PARTS, POINTS, SHORT, caseText, run, sectionDifference, withStudy } from './support.mjs';

let browser, page, folder;
const complaints = [];

/// Writes a page that contains only the engine, as window.engine.
async function writePage(file) {
  const program = `
    import { startEngine } from ${JSON.stringify(new URL('../../src/engine/engine.ts', import.meta.url).pathname)};
    import { fieldNumbers } from ${JSON.stringify(new URL('../../src/engine/protocol.ts', import.meta.url).pathname)};
    const text = (id) => document.getElementById(id).textContent;
    const core = Uint8Array.from(atob(text('core')), (c) => c.charCodeAt(0));
    Object.assign(window, { fieldNumbers, engine: startEngine({ worker: text('worker'), core, workers: 2 }) });`;
  const { outputFiles } = await build({
    stdin: { contents: program, resolveDir: '.', loader: 'ts' },
    bundle: true,
    format: 'iife',
    write: false,
  });
  const script = outputFiles[0].text;
  const hash = createHash('sha256').update(script).digest('base64');
  const policy = `default-src 'none'; script-src 'sha256-${hash}' 'wasm-unsafe-eval'; worker-src blob:`;
  writeFileSync(
    file,
    `<!doctype html><meta charset="utf-8"><title>engine</title>
<meta http-equiv="Content-Security-Policy" content="${policy}">
<script type="text/plain" id="worker">${readFileSync(`${PARTS}/worker.js`, 'utf8')}</script>
<script type="text/plain" id="core">${readFileSync(`${PARTS}/whirl.wasm`).toString('base64')}</script>
<script>${script}</script>`,
  );
}

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'whirl-engine-'));
  await writePage(join(folder, 'engine.html'));
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
  page = await browser.newPage();
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) complaints.push(request.url());
  });
  await page.goto(pathToFileURL(join(folder, 'engine.html')).href);
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/// Computes points in the page; returns their numbers.
function compute(text, parameter, values) {
  return page.evaluate(
    async ([text, parameter, values]) => {
      const results = [];
      for (const value of values) {
        const outcome = await window.engine.point({ setting: { text }, parameter, value, batch: 'detail' });
        if (!outcome.ok) throw new Error(JSON.stringify(outcome));
        const { layout, block, stations, verdict } = outcome.value;
        results.push({ layout, block: [...block], stations, verdict });
      }
      return results;
    },
    [text, parameter, values],
  );
}

function fieldNumbers(layout, block, name, which) {
  const field = layout.fields.find((one) => one.name === name);
  const size = field.rows * field.columns;
  return block.slice(field.offset + which * size, field.offset + (which + 1) * size);
}

let compared = 0;
for (const { name, parameter, values } of POINTS)
  test(`${name} from disk: 20 revolutions to 1e-9, the same verdicts`, async () => {
    const short = withStudy(name, parameter, values, SHORT);
    const long = withStudy(name, parameter, values, LONG);
    const [toldShort, toldLong] = [run(short), run(long)];
    (await compute(short, parameter, values)).forEach((result, i) => {
      const difference = sectionDifference(result, fieldNumbers, toldShort.detail[i]);
      assert.ok(difference < 1e-9, `${parameter} = ${values[i]}: sections differ by ${difference}`);
      compared++;
    });
    (await compute(long, parameter, values)).forEach((result, i) =>
      assert.equal(
        result.verdict.name,
        toldLong.detail[i].verdict,
        `${parameter} = ${values[i]}: ${result.verdict.reason}`,
      ),
    );
  });

test('how long the page waits', async (t) => {
  const times = await page.evaluate(async (text) => {
    const timed = async (work) => {
      const began = performance.now();
      const outcome = await work();
      if (!outcome.ok) throw new Error(JSON.stringify(outcome));
      return performance.now() - began;
    };
    const point = { text, options: { steps_per_revolution: 1024, transient: 200, record: 100 } };
    const diagram = { text, options: { steps_per_revolution: 256, transient: 100, record: 50 } };
    const values = Float64Array.from({ length: 256 }, (_, i) => 1 - (0.9 * i) / 255);
    const points = [];
    for (let i = 0; i < 7; i++)
      points.push(await timed(() => window.engine.point({ setting: point, parameter: 'r_k', value: 0.6 - i / 100 })));
    const sweep = await timed(() => window.engine.sweep({ setting: diagram, parameter: 'r_k', values }));
    return { first: points[0], later: Math.min(...points), sweep };
  }, caseText('paper'));
  t.diagnostic(
    `a point of 300 revolutions at 1024 steps: ${times.first.toFixed(0)} ms at first, then ` +
      `${times.later.toFixed(0)} ms`,
  );
  t.diagnostic(
    `a diagram of 256 points, 150 revolutions at 256 steps, two workers: ${(times.sweep / 1000).toFixed(2)} s`,
  );
  // The bounds are far above the times of an idle computer, so that only a gross fault exceeds them.
  assert.ok(times.later < 5000 && times.sweep < 120000);
});

test('the page made no request and no complaint, and at least ten points were compared', () => {
  assert.deepEqual(complaints, []);
  assert.ok(compared >= 10);
});
