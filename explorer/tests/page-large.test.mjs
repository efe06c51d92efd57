// Tests how long large diagrams take to appear and to be redrawn. The times are printed; the asserted bounds are wide,
// as the computer may be busy.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { closeBrowser, folder, open, template } from './browser.mjs';

after(closeBrowser);

const base64 = (array) => Buffer.from(array.buffer).toString('base64');

/// Writes a page with a run of `points` x `rows` dots of a noisy logistic map; without a case the page computes
/// nothing.
function largePage(points, rows) {
  const values = Float64Array.from({ length: points }, (_, i) => 2.8 + (1.2 * i) / (points - 1));
  const section = new Float32Array(2 * points * rows);
  values.forEach((a, point) => {
    let x = 0.4;
    for (let i = -500; i < rows; i++) {
      x = a * x * (1 - x);
      if (i >= 0) section[point * rows + i] = section[(points + point) * rows + i] = x;
    }
  });
  const scalar = (name, of) => ({
    name,
    unit: '1',
    meaning: '',
    repeat: 1,
    rows: 1,
    columns: 1,
    data: base64(Float32Array.from(values, of)),
  });
  const run = {
    name: 'large',
    title: 'Large',
    case_name: 'large.yaml',
    case_text: '',
    speed: 1,
    length_scale: 1,
    force_scale: 1,
    parameters: [{ name: 'a', unit: '1', text: '', value: 3 }],
    stations: [{ name: 'disc', clearance: 0, gap: 0 }],
    contacts: [],
    facts: [],
    tables: [
      {
        name: 'sweep',
        parameter: 'a',
        points,
        count: points,
        method: 'map',
        steps_per_revolution: 1,
        transient: 500,
        record: rows,
        values: base64(values),
        branch: Array(points).fill(0),
        done: Array(points).fill(1),
        fields: [
          { name: 'poincare/section', unit: 'length', meaning: '', repeat: 1, rows, columns: 2, data: base64(section) },
          scalar('regime/code', (a) => (a < 3.57 ? 1 : 3)),
          scalar('regime/period', (a) => (a < 3 ? 1 : a < 3.449 ? 2 : 4)),
          scalar('lyapunov/largest', (a) => a - 3.57),
        ],
      },
    ],
  };
  const path = join(folder, `large-${points}.html`);
  // Leave out the engine's parts, as only drawing is measured.
  const page = readFileSync(template, 'utf8')
    .replace(/(id="whirl-(worker|core)">)[^<]*/g, '$1')
    .replace('@WHIRL-RUNS@', () => JSON.stringify([run]));
  writeFileSync(path, page);
  return pathToFileURL(path).href;
}

/// Writes a page with a map of `side` x `side` cells: stripes of P-1 to P-4 with a disc of chaos.
function largeMap(side) {
  const axis = Float64Array.from({ length: side }, (_, i) => 1 + i / (side - 1));
  const cells = { length: side * side };
  const away = (cell) => Math.hypot((cell % side) / side - 0.5, Math.floor(cell / side) / side - 0.5);
  const scalar = (name, of) => ({
    name,
    unit: '1',
    meaning: '',
    extent: 'point',
    repeat: 1,
    rows: 1,
    columns: 1,
    data: base64(Float32Array.from(cells, (_, cell) => of(cell))),
  });
  const run = {
    name: 'map',
    title: 'Large map',
    case_name: 'map.yaml',
    case_text: '',
    speed: 1,
    length_scale: 1,
    force_scale: 1,
    parameters: [
      { name: 'a', unit: '1', text: '', value: 1.5 },
      { name: 'b', unit: '1', text: '', value: 1.5 },
    ],
    stations: [{ name: 'disc', clearance: 0, gap: 0 }],
    contacts: [],
    facts: [],
    tables: [
      {
        name: 'map',
        parameter: 'a',
        points: side * side,
        count: side * side,
        method: 'map',
        steps_per_revolution: 1,
        transient: 500,
        record: 1,
        map: { second: 'b', columns: side, rows: side, x: base64(axis), y: base64(axis) },
        fields: [
          scalar('regime/code', (cell) => (away(cell) < 0.3 ? 3 : 1)),
          scalar('regime/period', (cell) => (away(cell) < 0.3 ? 0 : 1 + (cell % 4))),
          scalar('regime/confidence', () => 2),
          scalar('lyapunov/largest', (cell) => 0.3 - away(cell)),
        ],
      },
    ],
  };
  const path = join(folder, `map-${side}.html`);
  const page = readFileSync(template, 'utf8')
    .replace(/(id="whirl-(worker|core)">)[^<]*/g, '$1')
    .replace('@WHIRL-RUNS@', () => JSON.stringify([run]));
  writeFileSync(path, page);
  return pathToFileURL(path).href;
}

test('a map of a million cells appears, and each of them can be seen', { timeout: 300_000 }, async (context) => {
  const side = 1000;
  const address = largeMap(side);
  const card = '.parameter-map-card';
  await (await open('about:blank')).close();
  const began = Date.now();
  const { page, complaints, close } = await open(address);
  await page.waitForSelector(`${card} .legend-entry`, { timeout: 60_000 });
  const first = Date.now() - began;
  // The legend counts the chaotic cells that were made.
  let chaotic = 0;
  for (let cell = 0; cell < side * side; cell++)
    chaotic += Math.hypot((cell % side) / side - 0.5, Math.floor(cell / side) / side - 0.5) < 0.3;
  const entries = await page.$$eval(`${card} .legend-entry`, (all) => all.map(({ textContent }) => textContent));
  assert.ok(entries.includes(`chaotic ${chaotic}`), entries.join());
  // The wheel zooms to single cells; the page describes neighbouring cells as they were made.
  const overlay = await page.$(`${card} .overlay`);
  await overlay.focus();
  const box = await overlay.boundingBox();
  const [x, y] = [box.x + box.width * 0.02, box.y + box.height * 0.5];
  await page.mouse.move(x, y);
  const times = [];
  for (let i = 0; i < 40; i++) {
    const start = Date.now();
    await page.mouse.wheel(0, -80);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    times.push(Date.now() - start);
  }
  assert.ok(await page.isVisible(`${card} button:has-text("whole")`));
  const columns = new Set();
  for (const part of [0.1, 0.35, 0.6, 0.9]) {
    await page.mouse.move(box.x + box.width * part, y);
    const place = await page.textContent('.map-place');
    const column = Math.round((Number(/^a (\S+), /.exec(place)[1]) - 1) * (side - 1));
    assert.equal(await page.textContent('.map-cell .verdict'), `P-${1 + (column % 4)}`);
    columns.add(column);
  }
  assert.equal(columns.size, 4);
  await page.click(`${card} button:has-text("whole")`);
  assert.ok(await page.isHidden(`${card} button:has-text("whole")`));
  times.sort((a, b) => a - b);
  context.diagnostic(`a million cells: first picture ${first} ms, a frame of zooming ${times[20]} ms (median)`);
  assert.deepEqual(complaints, []);
  await close();
});

for (const [points, rows, most] of [
  [512, 100, 10_000],
  [4096, 200, 30_000],
])
  test(`${points} x ${rows} points appear, and zoom`, async (context) => {
    const address = largePage(points, rows);
    await (await open('about:blank')).close(); // start the browser before the time is taken
    const began = Date.now();
    const { page, complaints, close } = await open(address);
    await page.waitForFunction(
      () => {
        const canvas = document.querySelector('.map-main canvas');
        if (!canvas) return false;
        const { data } = canvas.getContext('2d').getImageData(canvas.width >> 1, 0, 40, canvas.height);
        let coloured = 0;
        for (let i = 0; i < data.length; i += 4)
          if (
            data[i + 3] > 100 &&
            Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60
          )
            coloured++;
        return coloured > 20;
      },
      undefined,
      { timeout: most },
    );
    const first = Date.now() - began;
    await page.focus('.map-main .overlay');
    const frame = await page.evaluate(async () => {
      const overlay = document.querySelector('.map-main .overlay');
      const box = overlay.getBoundingClientRect();
      const next = () => new Promise((done) => requestAnimationFrame(done));
      const times = [];
      for (let i = 0; i < 20; i++) {
        overlay.dispatchEvent(
          new WheelEvent('wheel', {
            deltaY: -30,
            clientX: box.left + box.width * 0.7,
            clientY: box.top + 50,
            bubbles: true,
            cancelable: true,
          }),
        );
        const start = performance.now();
        await next();
        await next();
        times.push((performance.now() - start) / 2);
      }
      return times.sort((a, b) => a - b)[10];
    });
    context.diagnostic(
      `${points} x ${rows}: first picture ${first} ms, a frame of zooming ${frame.toFixed(1)} ms (median)`,
    );
    assert.ok(frame < 500);
    assert.deepEqual(complaints, []);
    await close();
  });
