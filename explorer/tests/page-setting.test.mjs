// Tests settings that are typed, refused or reset; lengths that keep their scale; and a page that cannot compute.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, folder, makePage, open, presets, saved, settled } from './browser.mjs';

/// A journal in a bearing with a clearance of 0.2 mm, which is the length scale; the case runs in a moment.
const BEARING = `whirl: 1
title: Journal in its bearing

parameters:
  omega: 6000 rpm
  c:     0.2 mm                     # clearance
  e:     0.1                        # unbalance over clearance
  F:     300 N                      # load coefficient of the film

rotor:
  speed: = omega
  length_scale: = c
  stations:
    journal: {mass: 10 kg, damping: 2000 N.s/m, eccentricity: = e*c}
  elements:
    - film: {at: journal, clearance: = c, load: = F}
    - gravity: 10 m/s2

study:
  sweep:     {parameter: e, from: 0.05, to: 0.3, points: 6, start: state}
  initial:   {journal: {y: -0.2}}
  integrate: {method: rk4, steps_per_revolution: 256, transient: 60, record: 20}
  analyze:   [poincare, regime, lyapunov, spectrum, orbit]
  detail:    {at: [0.1, 0.2, 0.25], waveform: 10}
`;

let rub, bearing;
before(() => {
  rub = makePage('rub', CASE);
  bearing = makePage('bearing', BEARING);
});
after(closeBrowser);

/// 1 lbf = 0.45359237 kg 9.80665 m/s2; 1 mil = 25.4 um.
const POUND_FORCE = 0.45359237 * 9.80665;

const troubled = (page, where = '.pane-a') =>
  page.waitForSelector(`${where} .trouble:not(:empty)`).then((found) => found.textContent());
const csv = async (page, panel) => (await saved(page, panel, 'csv')).bytes.toString('utf8');
async function type(page, field, text) {
  await page.fill(field, text);
  await page.press(field, 'Enter');
}

test('parameters and axes have the units that the report chose', async () => {
  const study = (words) => BEARING.replace('study:\n', `study:\n  units: ${words}\n`);
  const address = makePage(
    'us',
    study('US')
      .replace('    - gravity', '    - spring: {between: [journal, ground], stiffness: = k}\n    - gravity')
      .replace('  omega:', '  k: 1000 N/m\n  omega:'),
  );
  const { page, complaints, close } = await open(address);
  await settled(page);
  const field = async (name) => [
    Number(await page.inputValue(`#parameter-${name}`)),
    await page.textContent(`.parameter:has(#parameter-${name}) .unit`),
  ];
  for (const [name, unit, value] of [
    ['F', 'lbf', 300 / POUND_FORCE],
    ['k', 'lbf/in', (1000 / POUND_FORCE) * 0.0254],
    ['c', 'mil', 200 / 25.4],
    ['omega', 'rpm', 6000],
  ]) {
    const [shown, own] = await field(name);
    assert.equal(own, unit);
    assert.ok(Math.abs(shown - value) < 1e-5 * value, `${name} is ${shown} ${own}`);
  }
  const pressed = await page.$$eval('.topbar [aria-pressed="true"]', (all) => all.map((one) => one.textContent));
  assert.deepEqual(pressed, ['mil', 'rpm', 'cpm', 'p-p']);
  assert.match(await csv(page, '.panel-spectrum'), /cpm/);
  // The engine reads a typed number in the shown unit; twice the load is typed.
  await type(page, '#parameter-F', (600 / POUND_FORCE).toFixed(6));
  await page.waitForFunction(() => /F%3D[\d.]+(\+|%20)lbf/.test(location.hash));
  await settled(page);
  assert.equal(await page.textContent('.settings-card .trouble'), '');
  await page.click('button[title="Reset F to the case"]');
  await settled(page);
  assert.deepEqual(complaints, []);
  await close();
  // The report chose a unit of length that the page does not offer otherwise.
  const other = await open(makePage('mm', study('mm, N/mm')));
  await settled(other.page);
  assert.equal(await other.page.textContent('.topbar [value="own"][aria-pressed="true"]'), 'mm');
  assert.match(await other.page.textContent('.panel-orbit .panel-note'), / mm 0-p/);
  assert.equal(await other.page.textContent('.parameter:has(#parameter-c) .unit'), 'mm');
  assert.deepEqual(other.complaints, []);
  await other.close();
});

test('a stored diagram keeps its own length scale, on screen and in the file', async () => {
  const { page, complaints, close } = await open(`${bearing}#q=radius`);
  await settled(page);
  const before = [await csv(page, '.map-card'), await csv(page, '.panel-centreline')];
  const radius = (text, line) => Number(text.split('\r\n')[line].split(',')[6]);
  const { points } = JSON.parse(command('run', 'bearing.yaml', '--json=full', '-q'));
  const reported = points[0].stations.journal.max_radius * 200;
  assert.ok(Math.abs(radius(before[0], 1) - reported) < 1e-5 * reported, 'micrometres of a clearance of 0.2 mm');
  const [value, x, y, ratio] = before[1].split('\r\n')[2].split(',').map(Number);
  assert.equal(value, 0.1);
  assert.ok(Math.abs(ratio - Math.hypot(x, y) / 200) < 1e-6, 'of the clearance');
  await type(page, '#parameter-c', '0.4');
  await page.waitForFunction(() => location.hash.includes('c%3D0.4'));
  await settled(page);
  assert.match(await page.textContent('.status'), /Stored run/);
  assert.deepEqual([await csv(page, '.map-card'), await csv(page, '.panel-centreline')], before);
  // A new diagram of the changed machine is in micrometres by the length scale of that machine.
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await page.click('button:text-is("Recompute")');
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, { timeout: 60_000 });
  const changed = await csv(page, '.map-card');
  const cursor = Number(await page.inputValue('#value-a'));
  const lines = changed
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(',').map(Number));
  const near = lines.reduce((best, line) => (Math.abs(line[0] - cursor) < Math.abs(best[0] - cursor) ? line : best));
  const orbit = Number(/([\d.]+) \u00b5m 0-p/.exec(await page.textContent('.panel-orbit .panel-note'))[1]);
  assert.ok(Math.abs(near[6] - orbit) < 0.05 * orbit, `${near[6]} of the diagram, ${orbit} of the orbit`);
  assert.deepEqual(complaints, []);
  await close();
});

test('along the clearance every point has its own micrometres', async () => {
  const { page, complaints, close } = await open(`${bearing}#q=radius&par=c&range=0.0002,0.0004`);
  await settled(page);
  await page.waitForFunction(
    () => document.querySelector('.map-card progress').hidden && document.querySelector('.legend-entry'),
    undefined,
    { timeout: 60_000 },
  );
  const wide = (await csv(page, '.map-card'))
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(',').map(Number));
  await page.click('.topbar button[value="scale"]');
  await page.waitForFunction(() => /c 0-p/.test(document.querySelector('.panel-orbit .panel-note').textContent));
  const own = (await csv(page, '.map-card'))
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(',').map(Number));
  assert.ok(wide.length > 60);
  wide.forEach(([c, , , , , , radius], i) =>
    assert.ok(Math.abs(radius - own[i][6] * c * 1e6) < 1e-5 * radius, `at c = ${c}`),
  );
  assert.deepEqual(complaints, []);
  await close();
});

test('a stored run along the clearance has the micrometres of each of its machines', async () => {
  const along = makePage(
    'along',
    BEARING.replace(/sweep:.*/, 'sweep: {parameter: c, from: 0.2 mm, to: 0.4 mm, points: 5, start: state}').replace(
      /  detail:.*\n/,
      '',
    ),
  );
  const { page, complaints, close } = await open(`${along}#q=radius&units=um,rpm,order,0-p`);
  await settled(page);
  const { points } = JSON.parse(command('run', 'along.yaml', '--json=full', '-q'));
  const read = async () =>
    (await csv(page, '.map-card'))
      .trim()
      .split('\r\n')
      .slice(1)
      .map((line) => line.split(',').map(Number));
  let lines = await read();
  // Wait for the length scales, which the engine computes after the page has opened.
  for (let i = 0; i < 50 && lines[4][6] < 1.5 * points[4].stations.journal.max_radius * 200; i++) lines = await read();
  points.forEach(({ parameters, stations }, i) => {
    const reported = stations.journal.max_radius * parameters.c * 1e6;
    assert.ok(
      Math.abs(lines[i][6] - reported) < 1e-5 * reported,
      `at c = ${parameters.c}: ${lines[i][6]} and ${reported}`,
    );
  });
  // The page opens at the point nearest to the middle whose verdict has no low confidence.
  const cursor = Number(await page.inputValue('#value-a'));
  const opened = points.findIndex(({ parameters }) => Math.abs(parameters.c - cursor) < 1e-9);
  assert.ok(opened >= 0 && points[opened].confidence !== 'low', `${cursor} in the field`);
  const orbit = Number(/([\d.]+) \u00b5m 0-p/.exec(await page.textContent('.panel-orbit .panel-note'))[1]);
  const drawn = lines[opened][6];
  assert.ok(Math.abs(drawn - orbit) < 0.01 * orbit, `${drawn} of the diagram, ${orbit} of the orbit`);
  assert.deepEqual(complaints, []);
  await close();
});

test('every machine has the units that suit it', async () => {
  const { page, complaints, close } = await open(`${presets}#run=rigid-rotor`);
  await settled(page);
  const unit = () => page.textContent('.panel-orbit .panel-note');
  assert.match(await unit(), / c p-p/, 'the scale of a dimensionless case says nothing in micrometres');
  await page.selectOption('select[aria-label="Machine"]', 'paper');
  await page.waitForFunction(
    () => /\u00b5m p-p/.test(document.querySelector('.panel-orbit .panel-note').textContent),
    undefined,
    { timeout: 60_000 },
  );
  assert.equal(await page.getAttribute('.topbar button[value="rpm"]', 'aria-pressed'), 'true');
  assert.deepEqual(complaints, []);
  await close();
});

test('over another parameter no value of the first one stays in the case', async () => {
  const { page, complaints, close } = await open(`${bearing}#par=omega&at=650&range=500,700`);
  await settled(page);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  const text = readFileSync(await file.path(), 'utf8');
  assert.match(text, /detail: +\{at: \[650 rad\/s\], waveform: 10\}/);
  assert.match(text, /parameter: omega, from: 500 rad\/s, to: 700 rad\/s/);
  writeFileSync(join(folder, 'over-omega.yaml'), text);
  command('check', 'over-omega.yaml');
  const result = JSON.parse(command('run', 'over-omega.yaml', '--json=full', '-q'));
  assert.deepEqual(
    result.detail.map(({ parameters }) => parameters.omega),
    [650],
  );
  await page.evaluate(() => (navigator.clipboard.writeText = async (copied) => void (window.copied = copied)));
  await page.click('button:text-is("Copy command")');
  await page.waitForFunction(() => window.copied);
  assert.match(await page.evaluate(() => window.copied), /at: \[650 rad\/s\]/);
  assert.deepEqual(complaints, []);
  await close();
});

/// Opens a page at an address and saves its case; returns the text of the case.
async function savedCase(address) {
  const { page, complaints, close } = await open(address);
  await settled(page);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  const text = readFileSync(await file.path(), 'utf8');
  assert.deepEqual(complaints, []);
  await close();
  return text;
}

const SWEEPS = {
  list: '{parameter: e, values: [0.05, 0.1, 0.2, 0.3], start: state}',
  'list-in-dashes':
    '\n    parameter: e\n    values:                         # unbalances\n      - 0.05\n      - 0.1\n      - ' +
    '0.3\n    start: state',
  step: '{parameter: e, from: 0.3, to: 0.1, step: 0.05, start: state}',
  log: '{parameter: e, from: 0.05, to: 0.4, points: 4, scale: log, start: state}',
};
for (const [name, sweep] of Object.entries(SWEEPS))
  test(`a saved case whose sweep was written as ${name} is one that the command takes`, async () => {
    const address = makePage(name, BEARING.replace(/sweep:.*/, `sweep: ${sweep}`).replace(/ {2}detail:.*\n/, ''));
    const original = JSON.parse(command('run', `${name}.yaml`, '--json=full', '-q')).points.length;
    const at = {
      whole: '#at=0.15',
      nearer: '#at=0.15&range=0.1,0.2',
      other: '#par=omega&at=650&range=600,700',
    };
    for (const [what, hash] of Object.entries(at)) {
      const file = `saved-${name}-${what}.yaml`;
      const text = await savedCase(address + hash);
      writeFileSync(join(folder, file), text);
      command('check', file);
      const values = JSON.parse(command('run', file, '--json=full', '-q')).points.map(({ parameters }) =>
        what === 'other' ? parameters.omega : parameters.e,
      );
      assert.equal(values.length, original, `${file}: ${text}`);
      const ends = { whole: undefined, nearer: [0.1, 0.2], other: [600, 700] }[what];
      if (!ends) continue;
      if (name === 'step') ends.reverse();
      assert.ok(
        Math.abs(values[0] - ends[0]) < 1e-9 * ends[0] && Math.abs(values.at(-1) - ends[1]) < 1e-9 * ends[1],
        `${file}: ${values}`,
      );
      if (name === 'log') {
        const [a, b, c] = values;
        const even = what === 'nearer' ? Math.abs(b / a - c / b) : Math.abs(b - a - (c - b)) / b;
        assert.ok(even < 1e-9, `${file}: ${values}`);
      }
    }
  });

test('the parameter that the case sweeps can be set while another one is along the diagram', async () => {
  const { page, complaints, close } = await open(`${bearing}#par=omega&at=650&range=600,700&set=e%3D0.2`);
  await settled(page);
  assert.equal(await page.textContent('.settings-card .trouble'), '');
  assert.equal(await page.inputValue('#parameter-e'), '0.2');
  assert.deepEqual(complaints, []);
  await close();
});

test('an error speaks the unit that was typed, and what is left of the last good value is dimmed', async () => {
  const { page, complaints, close } = await open(`${bearing}#par=omega&at=650&range=600,700&units=um,rpm,order,0-p`);
  const verdict = await settled(page);
  await type(page, '#value-a', '-100');
  await page.waitForFunction(() => /rpm/.test(document.querySelector('.pane-a .trouble').textContent));
  assert.match(await troubled(page), /^omega: is -100 rpm, expected a number above 0 rpm/);
  assert.doesNotMatch(await troubled(page), /rad\/s/);
  assert.equal(await page.textContent('.pane-a .verdict'), verdict);
  assert.match(
    await page.textContent('.outdated-note'),
    /last setting that could be computed, omega = 6207\.\d+ rpm\.$/,
  );
  const opacity = () => page.$eval('.pane-a .panels .figure', (panels) => Number(getComputedStyle(panels).opacity));
  assert.ok((await opacity()) < 0.6);
  assert.match((await saved(page, '.panel-orbit', 'csv')).name, /omega-6207/, 'a file is named after what is in it');
  await type(page, '#value-a', '6000');
  await page.waitForFunction(() => !document.querySelector('.pane-a').classList.contains('outdated'));
  assert.equal(await page.textContent('.pane-a .trouble'), '');
  assert.equal(await opacity(), 1);
  // Test the same with a parameter that is not along the diagram.
  await type(page, '#parameter-c', '-0.4');
  assert.match(await troubled(page, '.settings-card'), /^c: is -0\.4 mm, expected a number above 0 mm/);
  await page.waitForFunction(() => document.querySelector('.pane-a').classList.contains('outdated'));
  await page.click('button[aria-label="Reset c to the case"]');
  await page.waitForFunction(() => !document.querySelector('.pane-a').classList.contains('outdated'));
  assert.deepEqual(complaints, []);
  await close();
});

test('a value may be typed with a unit that is not the one shown', async () => {
  const { page, complaints, close } = await open(`${bearing}#par=omega&at=650&range=600,700&units=um,rpm,order,0-p`);
  await settled(page);
  const shows = (field, text) =>
    page.waitForFunction(([at, value]) => document.querySelector(at).value === value, [field, text]);
  await type(page, '#value-a', '640 rad/s');
  await shows('#value-a', '6111.55'); // 640 rad/s times 60/(2 pi)
  await page.waitForFunction(() => /[#&]at=640(&|$)/.test(location.hash));
  await type(page, '#parameter-omega', '0.66 rad/ms');
  await shows('#value-a', '6302.54');
  await type(page, '#parameter-c', '180 um');
  await shows('#parameter-c', '180'); // the row adopts the typed unit
  assert.match(await page.textContent('.parameter:has(#parameter-c) .unit'), /um/);
  await settled(page);
  assert.equal(await page.textContent('.pane-a .trouble'), '');
  await type(page, '#value-a', '3 kg');
  assert.match(await troubled(page), /omega: is in kg, expected a unit of rad\/s/);
  assert.deepEqual(complaints, []);
  await close();
});

/// A disc on a bearing whose coefficients are tables over the speed.
const TABLES = `whirl: 1
title: Tables over the speed
parameters: {w: 5000 rpm, m: 20 kg}
rotor:
  speed: = w
  length_scale: 0.1 mm
  stations: {disc: {mass: = m, eccentricity: 10 um}}
  elements:
    - bearing:
        at: disc
        speeds: [3000 rpm, 6000 rpm, 9000 rpm]
        kxx: [4 MN/m, 6 MN/m, 9 MN/m]
        cxx: [20 kN.s/m, 16 kN.s/m, 12 kN.s/m]
study:
  sweep:     {parameter: w, from: 3000 rpm, to: 9000 rpm, points: 7}
  integrate: {method: rk4, steps_per_revolution: 256, transient: 100, record: 20}
  analyze:   [poincare, regime, lyapunov, spectrum, orbit]
`;

test('tables over the speed are computed with, and stay as they are in a saved case', async () => {
  const address = makePage('tables', TABLES);
  const { page, complaints, close } = await open(
    `${address}#par=w&at=${200 * Math.PI}&q=radius&units=um,rpm,order,0-p`,
  );
  assert.match(await settled(page), /P-1/);
  // The tables contain 6000 rpm, at which the amplitude in um is e m w^2 / |k - m w^2 + i c w|.
  const [w, m, k, c] = [200 * Math.PI, 20, 6e6, 16e3];
  const expected = (10 * m * w * w) / Math.hypot(k - m * w * w, c * w);
  const rows = (await csv(page, '.panel-orbit')).trim().split('\r\n').slice(1);
  const radii = rows.map((row) => Math.hypot(...row.split(',').slice(-2).map(Number)));
  assert.ok(radii.length > 100 && radii.every((radius) => Math.abs(radius / expected - 1) < 1e-4), `${radii[0]}`);
  assert.deepEqual(complaints, []);
  await close();
  const text = await savedCase(`${address}#at=${200 * Math.PI}`);
  assert.match(text, /kxx: \[4 MN\/m, 6 MN\/m, 9 MN\/m\]/);
  writeFileSync(join(folder, 'saved-tables.yaml'), text);
  command('check', 'saved-tables.yaml');
});

test('a comma is refused with a sentence, and nothing is guessed', async () => {
  const { page, complaints, close } = await open(`${rub}#at=3.8`);
  await settled(page);
  const before = await page.textContent('.pane-a .reason');
  await page.click('#parameter-kappa');
  await page.fill('#parameter-kappa', '');
  await page.keyboard.type('5,5');
  await page.keyboard.press('Enter');
  assert.match(
    await troubled(page, '.settings-card'),
    /^kappa: 5,5 has a comma: write 5\.5 with a decimal point, or 55 without the comma$/,
  );
  assert.equal(await page.inputValue('#parameter-kappa'), '5,5');
  assert.equal(await page.getAttribute('#parameter-kappa', 'aria-invalid'), 'true');
  assert.doesNotMatch(page.url(), /kappa/);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await page.waitForSelector('.settings-card .trouble:empty', { state: 'attached' });
  await page.waitForFunction(() => document.querySelector('#parameter-kappa').value === '10');
  await type(page, '#value-a', '3,8');
  assert.match(await troubled(page), /^omega: 3,8 has a comma/);
  await type(page, '#value-a', 'fast');
  await page.waitForFunction(() => /fast is not a number/.test(document.querySelector('.pane-a .trouble').textContent));
  await type(page, '#value-a', '3.8');
  await settled(page);
  assert.equal(await page.textContent('.pane-a .trouble'), '');
  assert.equal(await page.textContent('.pane-a .reason'), before);
  await page.click('.computation summary');
  const steps = page.getByLabel('Steps per revolution');
  for (const [text, sentence] of [
    ['1,024', /1,024 has a comma/],
    ['12.5', /12\.5 is not a whole number from 8 to 65536/],
  ]) {
    await steps.fill(text);
    await steps.press('Enter');
    await page.waitForFunction(
      (words) => new RegExp(words).test(document.querySelector('.settings-card .trouble').textContent),
      sentence.source,
    );
  }
  assert.doesNotMatch(page.url(), /steps/);
  assert.deepEqual(complaints, []);
  await close();
});

/// Serves a page with a Content-Security-Policy in the server's answer.
async function served(address, policy) {
  const page = readFileSync(fileURLToPath(address));
  const server = createServer((_, answer) =>
    answer.writeHead(200, { 'content-type': 'text/html; charset=utf-8', 'content-security-policy': policy }).end(page),
  );
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  server.unref(); // a test that fails must not wait for it
  return { at: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() };
}

test('a page whose workers or core are forbidden shows what is stored, and says what is wrong', async () => {
  for (const policy of ["worker-src 'none'", "script-src 'unsafe-inline'; worker-src blob:"]) {
    const { at, end } = await served(rub, policy);
    const { page, close } = await open(at);
    await page.waitForSelector('.banner:not(:empty)');
    assert.match(
      await page.textContent('.banner'),
      /The compiled core does not start \(.+\): this page shows what is stored.*worker-src blob:/s,
      policy,
    );
    assert.match(await page.textContent('.status'), /Stored run: 61 points/);
    assert.ok(await page.isHidden('button:text-is("Recompute")'));
    assert.match(await page.textContent('.pane-a .how'), /^Stored by the run: 500 \+ 200 revolutions, rk4/);
    assert.equal(await page.textContent('.pane-a .trouble'), '');
    await close();
    end();
  }
});

test('a browser without workers is told of, too', async () => {
  const { page, close } = await open('about:blank');
  await page.addInitScript(() => {
    window.Worker = class {
      constructor() {
        throw new DOMException('not allowed', 'SecurityError');
      }
    };
  });
  await page.goto(rub);
  await page.waitForSelector('.banner:not(:empty)');
  assert.match(await page.textContent('.banner'), /SecurityError|not allowed/);
  assert.match(await page.textContent('.status'), /Stored run: 61 points/);
  await close();
});

test('a page whose program is forbidden says so', async () => {
  for (const policy of ["script-src 'none'", "default-src 'none'"]) {
    const { at, end } = await served(rub, policy);
    const { page, close } = await open(at);
    await page.waitForSelector('#whirl-silent', { state: 'visible', timeout: 10_000 });
    assert.match(
      await page.textContent('#whirl-silent'),
      /program of this page does not run.*Content-Security-Policy/s,
    );
    await close();
    end();
  }
});
