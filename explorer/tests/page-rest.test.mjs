// Tests machines at rest in the explorer: Campbell's diagram, shapes and the response to unbalance have the numbers of
// the result file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { axeFindings, beyondWindow, brush, closeBrowser, command, folder, makePage, open, saved } from './browser.mjs';

const FAN = `whirl: 1
title: An overhung fan
parameters: {omega: 1500 rpm}
rotor:
  speed: = omega
  length_scale: 0.1 mm
  stations:
    rear:  {position: 0 m}
    front: {position: 0.6 m}
    wheel: {position: 0.9 m, mass: 40 kg, diametral: 1.1 kg m2, polar: 2 kg m2, eccentricity: 20 um}
    foot:  {mass: 30 kg}
  elements:
    - segment: {length: 0.9 m, outer: 60 mm}
    - bearing: {at: rear, kxx: 50 MN/m, cxx: 2 kN s/m}
    - bearing: {at: front, from: foot, kxx: 50 MN/m, kyy: 30 MN/m, cxx: 2 kN s/m}
    - spring: {between: [foot, ground], stiffness: 400 MN/m, damping: 2 kN s/m}
study:
`;
const MODES = '  modes: {parameter: omega, from: 0 rpm, to: 6000 rpm, points: 61}\n';
const unbalance = (probe) =>
  `  unbalance: {parameter: omega, from: 100 rpm, to: 6000 rpm, points: 60, probe: ${probe} degree}\n`;

let modes, response, turned;
before(() => {
  modes = makePage('modes', FAN + MODES);
  response = makePage('response', FAN + unbalance(0));
  turned = makePage('turned', FAN + unbalance(40));
});
after(closeBrowser);

/// Exports a table of the result file; returns its rows of texts with the column names, without units.
function exported(result, file) {
  command('export', `${result}.h5`, '--csv', `${result}-csv`, '--force');
  return rowsOf(readFileSync(join(folder, `${result}-csv`, file), 'utf8'));
}

function rowsOf(csv) {
  const [heading, ...lines] = csv.trim().split(/\r?\n/);
  const names = heading.split(',').map((name) => name.replace(/ [[(].*/, ''));
  return lines.map((line) => line.split(',').map((text, i) => [names[i], text])).map((cells) => cells);
}

const numbers = (cells, ...columns) => columns.map((column) => Number(cells[column][1]));

function near(found, expected, tolerance, what) {
  assert.ok(Math.abs(found - expected) <= tolerance, `${what}: ${found}, expected ${expected}`);
}

/// Opens a page, and waits until its numbers are shown and its address is written.
async function opened(address, options) {
  const made = await open(address, options);
  await made.page.waitForSelector('.rest .numbers tbody td');
  await made.page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).has('run'));
  return made;
}

const shownValue = (page) => page.inputValue('#value-rest').then(Number);

test('modes are those of the result file, in the diagram, the table and the shape', async () => {
  const { page, complaints, close } = await opened(`${modes}#at=${(3000 * Math.PI) / 30}&mode=2&units=um,rpm,Hz,0-p`);
  assert.equal(await page.textContent('h1'), 'An overhung fan');
  assert.equal(await shownValue(page), 3000);
  assert.ok(await page.isHidden('.map-card >> text=Recompute'), 'motions are not offered');
  const stored = exported('modes', 'modes-modes-frequency.csv');
  const damped = exported('modes', 'modes-modes-damping_ratio.csv');
  const whirl = exported('modes', 'modes-modes-direction.csv');
  const names = JSON.parse(command('show', 'modes.h5', '--json')).points.flatMap((point) => point.modes.name);
  assert.ok(names.includes('1F') && names.includes('1B'));
  const page_rows = rowsOf((await saved(page, '.rest .map-card', 'csv')).bytes.toString('utf8'));
  const finite = stored.map((cells, i) => [cells, i]).filter(([cells]) => Number.isFinite(Number(cells[4][1])));
  assert.equal(page_rows.length, finite.length);
  finite.forEach(([cells, i], row) => {
    const [value, index, frequency] = numbers(cells, 1, 3, 4);
    const found = numbers(page_rows[row], 0, 2, 4, 5, 7);
    near(found[0], value, 1e-9 * 6000, 'the speed, rpm');
    assert.equal(found[1], index);
    assert.equal(page_rows[row][3][1], names[row], 'the name');
    near(found[2], frequency / (2 * Math.PI), 1e-6 * frequency, 'the frequency, Hz');
    near(found[3], Number(damped[i][4][1]), 1e-6, 'the damping ratio');
    near(found[4], Number(whirl[i][4][1]), 1e-6, 'the whirl');
  });
  const at = stored.filter((cells) => Number(cells[1][1]) === 3000);
  const reported = await page.$$eval('.rest .pane .numbers tbody tr', (rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent)),
  );
  assert.ok(reported.length >= 4);
  reported.forEach((cells, i) =>
    near(Number(cells[3]), Number(at[i][4][1]) / (2 * Math.PI), 5e-5 * cells[3], 'reported'),
  );
  const second = exported('modes', 'modes-modes-shape.csv').filter(
    (cells) => cells[1][1] === '3000' && cells[4][1] === '2',
  );
  const rows = rowsOf((await saved(page, '.rest .panel-shape', 'csv')).bytes.toString('utf8'));
  const shape = rows.filter((cells) => cells[0][1]);
  assert.deepEqual(
    shape.map((cells) => cells.slice(0, 3).map(([, text]) => text)),
    [
      ['rear', '1', '0'],
      ['front', '1', '0.6'],
      ['wheel', '1', '0.9'],
      ['foot', '', ''],
    ],
  );
  shape.forEach((cells, station) => {
    assert.equal(second[station][3][1], cells[0][1]);
    numbers(cells, 3, 4, 5, 6).forEach((part, i) => near(part, Number(second[station][5 + i][1]), 1e-6, 'the shape'));
  });
  assert.deepEqual(complaints, []);
  await close();
});

test('shafts bend between stations as in the figures of the library', async () => {
  const { page, complaints, close } = await opened(`${modes}#at=${(6000 * Math.PI) / 30}&mode=2&units=um,rpm,Hz,0-p`);
  command('figure', 'modes.h5', 'shapes', '-o', 'shapes.json', '--force');
  const { panels } = JSON.parse(readFileSync(join(folder, 'shapes.json'), 'utf8'));
  const panel = panels.find(({ name }) => name === 'mode-2');
  // The first two lines are x and y at the peak, the next two (dashed) x and y a quarter of a period later.
  const lines = panel.series.filter(({ shape, x }) => shape === 'line' && x.length > 20);
  const wanted = [lines[0], lines[1], lines[2], lines[3]].map(({ y }) => y.filter((value) => value !== null));
  const rows = rowsOf((await saved(page, '.rest .panel-shape', 'csv')).bytes.toString('utf8'));
  const places = rows.filter((cells) => !cells[0][1]);
  assert.equal(places.length, wanted[0].length);
  places.forEach((cells, i) => {
    near(Number(cells[2][1]), lines[0].x[i] / 1000, 1e-9, 'the place, m');
    numbers(cells, 3, 4, 5, 6).forEach((part, k) => near(part, wanted[k][i], 1e-6, `part ${k} at place ${i}`));
  });
  // The shaft is bent: between bearing and wheel it deviates from the straight line through both.
  const at = (z) =>
    numbers(
      places.reduce((a, b) => (Math.abs(b[2][1] - z) < Math.abs(a[2][1] - z) ? b : a)),
      5,
    )[0];
  assert.ok(Math.abs(at(0.75) - (at(0.6) + at(0.9)) / 2) > 1e-3);
  assert.deepEqual(complaints, []);
  await close();
});

test('critical speeds stand there with five figures, and are a press away', async () => {
  const { page, complaints, close } = await opened(`${modes}#at=100`);
  const located = exported('modes', 'modes-modes-critical.csv');
  const reported = await page.$$eval('.rest .map-card .numbers tbody tr', (rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent)),
  );
  assert.ok(located.length >= 2);
  assert.equal(reported.length, located.length);
  reported.forEach((cells, i) => {
    const rpm = (Number(located[i][5][1]) * 30) / Math.PI;
    near(Number(cells[1]), rpm, 5e-5 * rpm, 'the critical speed');
    assert.ok(
      cells[1].replace('.', '').length <= Math.max(5, String(Math.round(rpm)).length),
      `five figures: ${cells[1]}`,
    );
    assert.match(cells[0], Number(located[i][9][1]) > 0.05 ? /forward/ : /backward/);
  });
  await page.click('.rest .map-card .numbers button >> nth=0');
  const goal = Number(reported[0][1]);
  await page.waitForFunction((rpm) => Math.abs(Number(document.querySelector('#value-rest').value) - rpm) <= 50, goal);
  assert.deepEqual(complaints, []);
  await close();
});

test('keys go from computed point to computed point; the address holds what is looked at', async () => {
  const { page, complaints, close } = await opened(modes);
  await page.focus('.rest .map-card:not([hidden]) .map-main .overlay');
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.querySelector('#value-rest').value === '0');
  for (const [key, value] of [
    ['ArrowRight', 100],
    ['Shift+ArrowRight', 1100],
    ['ArrowLeft', 1000],
    ['End', 6000],
  ]) {
    await page.keyboard.press(key);
    await page.waitForFunction((rpm) => Number(document.querySelector('#value-rest').value) === rpm, value);
  }
  await page.fill('#value-rest', '2440');
  await page.press('#value-rest', 'Enter');
  await page.waitForFunction(() =>
    /Modes at omega 2400 rpm/.test(document.querySelector('.rest .pane h3').textContent),
  );
  assert.match(await page.textContent('.rest .how'), /nearest point that was computed/);
  const third = page.locator('.rest .pane .numbers button >> nth=2');
  await third.focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() =>
    /^mode 3 \(\d[FBM]\), /.test(document.querySelector('.rest .panel-shape .panel-note').textContent),
  );
  assert.equal(await third.getAttribute('aria-pressed'), 'true');
  assert.ok(await third.evaluate((button) => button === document.activeElement), 'the focus stays at the mode');
  await page.click('.rest [aria-label="Damping as"] button[value="decrement"]');
  await page.click('.rest [aria-label="Frequencies"] button[value="all"]');
  await page.waitForFunction(() => /modes=all/.test(location.hash));
  const words = new URLSearchParams(new URL(page.url()).hash.slice(1));
  assert.deepEqual(
    ['mode', 'damping', 'modes'].map((word) => words.get(word)),
    ['3', 'decrement', 'all'],
  );
  const again = await opened(page.url());
  assert.match(await again.page.textContent('.rest .panel-shape .panel-note'), /^mode 3 \(\d[FBM]\), /);
  assert.equal(await again.page.getAttribute('.rest button[value="decrement"]', 'aria-pressed'), 'true');
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => !/modes=all/.test(location.hash));
  assert.deepEqual([...complaints, ...again.complaints], []);
  await again.close();
  await close();
});

test('a range is enlarged, and left again', async () => {
  const { page, complaints, close } = await opened(modes);
  const overlay = '.rest .map-card:not([hidden]) .map-main .overlay';
  await brush(page, 0.25, 0.5, '.rest .map-card:not([hidden])');
  const highest = (most) =>
    page.waitForFunction(
      ([where, limit]) => Math.abs(Number(document.querySelector(where).getAttribute('aria-valuemax')) - limit) < 40,
      [overlay, most],
    );
  await highest(3000);
  await page.click('.rest .map-card:not([hidden]) button:text-is("Back")');
  await highest(6000);
  assert.deepEqual(complaints, []);
  await close();
});

test('the cursor stands at its value, however wide the page becomes', async () => {
  const { page, complaints, close } = await opened(`${modes}#at=${(1500 * Math.PI) / 30}`);
  const overlay = '.rest .map-card:not([hidden]) .map-main .overlay';
  for (const width of [1280, 1000, 1600]) {
    await page.setViewportSize({ width, height: 800 });
    await page.waitForFunction(
      (where) => {
        const box = document.querySelector(where).getBoundingClientRect();
        const cursor = document.querySelector(`${where} .cursor-a`).getBoundingClientRect();
        return Math.abs((cursor.left + cursor.width / 2 - box.left) / box.width - 0.25) < 0.01;
      },
      overlay,
      { timeout: 5000 },
    );
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('an address with nonsense does no harm', async () => {
  const { page, complaints, close } = await opened(
    `${response}#at=NaN&mode=-3&probe=1e9&modes=%3Cb%3E&damping=x&b=2&st=%22&range=4,1&par=nobody`,
  );
  assert.equal(Number(await page.inputValue('.rest input.angle')), 0);
  await page.fill('.rest input.angle', 'forty');
  await page.press('.rest input.angle', 'Enter');
  assert.equal(await page.getAttribute('.rest input.angle', 'aria-invalid'), 'true');
  assert.match(await page.textContent('.rest .map-card:not([hidden]) .trouble'), /forty is not a number/);
  await page.fill('.rest input.angle', '700');
  await page.press('.rest input.angle', 'Enter');
  assert.match(await page.textContent('.rest .map-card:not([hidden]) .trouble'), /degrees from -360 to 360/);
  await page.fill('#value-rest', '3,5');
  await page.press('#value-rest', 'Enter');
  assert.match(await page.textContent('.rest .how'), /3,5 has a comma/);
  assert.deepEqual(complaints, []);
  await close();
});

test('any angle of the probes gives what a case with that angle computes', async () => {
  const { page, complaints, close } = await opened(`${response}#st=wheel&units=scale,rpm,Hz,0-p`);
  await page.fill('.rest input.angle', '40');
  await page.press('.rest input.angle', 'Enter');
  await page.waitForFunction(() => /probe=40/.test(location.hash));
  const found = rowsOf((await saved(page, '.rest .map-card:not([hidden])', 'csv')).bytes.toString('utf8'));
  const all = exported('turned', 'unbalance.csv');
  const column = (name) => all[0].findIndex(([heading]) => heading === name);
  const places = [
    'probe wheel first',
    'probe_lag wheel first',
    'probe wheel second',
    'probe_lag wheel second',
    'axes wheel major',
  ];
  const columns = places.map((name) => column(`unbalance/${name}`));
  assert.ok(
    columns.every((each) => each >= 0),
    `${columns} of ${all[0].map(([name]) => name)}`,
  );
  assert.equal(found.length, all.length);
  found.forEach((cells, i) => {
    const [value, , ...seen] = numbers(cells, 0, 1, 2, 3, 4, 5, 6);
    const expected = numbers(all[i], ...columns);
    near(value, Number(all[i][1][1]), 1e-6, 'rpm');
    for (const which of [0, 2, 4]) near(seen[which], expected[which], 2e-6 * expected[4], 'an amplitude');
    for (const which of [1, 3]) near((seen[which] - expected[which] + 540) % 360, 180, 2e-4, 'a lag');
  });
  // At first the field shows the angle of the case.
  const other = await opened(`${turned}#st=wheel`);
  near(Number(await other.page.inputValue('.rest input.angle')), 40, 1e-4, 'degrees');
  assert.deepEqual([...complaints, ...other.complaints], []);
  await other.close();
  await close();
});

test('pictures and data can be saved', async () => {
  for (const [address, panels] of [
    [modes, ['.panel-shape', '.panel-displacements']],
    [response, ['.panel-polar', '.panel-synchronous', '.panel-rest', '.panel-shape', '.panel-displacements']],
  ]) {
    const { page, complaints, close } = await opened(`${address}#st=wheel`);
    for (const panel of ['.map-card', ...panels].map((name) => `.rest ${name}:not([hidden])`)) {
      const png = await saved(page, panel, 'png');
      assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
      assert.ok(png.bytes.length > 3000, `${panel}: a picture of ${png.bytes.length} bytes`);
      const svg = (await saved(page, panel, 'svg')).bytes.toString('utf8');
      const drawn = await page.evaluate((text) => {
        const parsed = new DOMParser().parseFromString(text, 'image/svg+xml');
        return parsed.querySelectorAll('parsererror').length === 0 && parsed.querySelectorAll('path').length;
      }, svg);
      assert.ok(drawn > 3, `${panel}: ${drawn} paths`);
      if (panel.includes('map-card')) {
        const beyond = await page.evaluate((text) => {
          const host = document.body.appendChild(document.createElement('div'));
          host.innerHTML = text;
          const right = host.firstElementChild.getBoundingClientRect().right;
          const ends = [...host.querySelectorAll('text')].map((each) => each.getBoundingClientRect().right);
          host.remove();
          return ends.filter((end) => end > right + 0.5).length;
        }, svg);
        assert.equal(beyond, 0, 'texts of the picture that are cut');
      }
      assert.ok(!/NaN|Infinity/.test(svg), `${panel} has places that are no numbers`);
      const csv = (await saved(page, panel, 'csv')).bytes.toString('utf8');
      assert.ok(csv.split('\r\n').length > 4, `${panel}: ${csv}`);
    }
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('one point without a parameter has its modes and no diagram; what it rests against is named', async () => {
  const stator = '    - rub: {at: wheel, gap: 1 um, stiffness: 1 MN/m, friction: 0}\n    - gravity\n';
  const address = makePage('point', FAN.replace('study:\n', `${stator}study:\n  modes: {}\n`));
  const { page, complaints, close } = await opened(address);
  assert.match(await page.textContent('.rest .pane h3'), /Modes at rest/);
  assert.ok(await page.isHidden('.rest .map-main >> nth=0'));
  assert.match(await page.textContent('.rest .panel-shape .panel-note'), /^mode 1, /);
  assert.match(await page.textContent('.rest .how'), /; rests against rub at wheel, which small motions do not open/);
  assert.deepEqual(complaints, []);
  await close();
});

for (const colorScheme of ['light', 'dark'])
  test(`axe finds nothing, and nothing is cut, ${colorScheme}`, async () => {
    for (const [address, viewport] of [
      [modes, { width: 1280, height: 800 }],
      [response, { width: 1280, height: 800 }],
      [modes, { width: 360, height: 780 }],
    ]) {
      const { page, complaints, close } = await opened(address, { colorScheme, viewport });
      assert.deepEqual(await axeFindings(page), []);
      assert.equal(await beyondWindow(page), 0);
      assert.deepEqual(complaints, []);
      await close();
    }
  });
