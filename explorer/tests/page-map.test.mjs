// Tests maps in the explorer: the page describes a cell as the result has it, a click computes its motion, keys move
// from cell to cell, and the diagram is the row or column of the cursor.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

// The values of the first parameter fall; those of the second have equal ratios, so that its axis is logarithmic.
const CASE = `whirl: 1
title: A Jeffcott rotor that rubs, over speed and unbalance
parameters: {omega: 2.05 rad/s, e: 0.6 m}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: = e}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}
    - rub: {at: disc, gap: 1 m, stiffness: 10 N/m, friction: 0.05, law: paper}
    - gravity: 0.5 m/s2
study:
  map:
    x: {parameter: omega, from: 3.6, to: 1.5, points: 15}
    y: {parameter: e, values: [0.4, 0.5, 0.625, 0.78125, 0.9765625]}
  initial: {disc: {x: 0.1, y: -0.2}}
  integrate: {transient: 300, record: 60}
  analyze: [poincare, regime, lyapunov, orbit, rub, floquet]
`;
const CARD = '.parameter-map-card';
const UNITS = 'units=scale,rad/s,order,0-p';

let address, points, columns, rows;
before(() => {
  address = makePage('map', CASE);
  command('export', 'map.h5', '--csv', 'csv');
  points = cellsOf(readFileSync(join(folder, 'csv', 'map.csv'), 'utf8')).map((row) => ({
    point: row.point,
    omega: Number(row['omega [rad/s]']),
    e: Number(row['e [m]']),
    verdict: row.verdict,
    exponent: Number(row['lyapunov/largest [1/revolution]']),
    radius: Number(row['orbit/max_radius disc [m 0-p]']),
  }));
  const rising = (key) => [...new Set(points.map((point) => point[key]))].sort((a, b) => a - b);
  [columns, rows] = [rising('omega'), rising('e')];
});
after(closeBrowser);

/// Returns the rows of a CSV text without commas in its cells, as objects with the headings as keys.
function cellsOf(text) {
  const [heading, ...lines] = text.trim().split(/\r?\n/);
  const names = heading.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [names[i], cell])));
}

const csvOf = async (page, card) => cellsOf((await saved(page, card, 'csv')).bytes.toString('utf8'));
const near = (a, b, most = 1e-6) => assert.ok(Math.abs(a - b) < most, `${a} is not ${b}`);
const number = (text) => Number(text.replace('\u2212', '-'));

/// Returns the position of a point's cell on the screen. Speeds are evenly spaced, unbalances by ratio; the map extends
/// half a cell beyond the outer points.
async function placeOf(page, point) {
  const box = await (await page.$(`${CARD} .overlay`)).boundingBox();
  const right = (columns.indexOf(point.omega) + 0.5) / columns.length;
  const up = (rows.indexOf(point.e) + 0.5) / rows.length;
  return [box.x + box.width * right, box.y + box.height * (1 - up)];
}

async function opened(hash = '') {
  const all = await open(`${address}#${hash}${hash && '&'}${UNITS}`);
  await all.page.waitForSelector(`${CARD} canvas`);
  await settled(all.page);
  return all;
}

const cellTexts = async (page) => ({
  place: await page.textContent('.map-place'),
  verdict: await page.textContent('.map-cell .verdict'),
  rest: await page.textContent('.map-rest'),
});

test('cells show the numbers of the result', { timeout: 300_000 }, async () => {
  assert.ok(new Set(points.map(({ verdict }) => verdict)).size > 3);
  const { page, complaints, close } = await opened();
  const table = await csvOf(page, CARD);
  assert.equal(table.length, points.length);
  for (const point of points) {
    const mine = table.filter(
      (row) => Number(row['omega (rad/s)']) === point.omega && Number(row['e (m)']) === point.e,
    );
    assert.equal(mine.length, 1);
    assert.equal(mine[0].verdict, point.verdict);
    near(Number(mine[0]['exponent per revolution']), point.exponent);
  }
  for (const point of points.filter((_, i) => i % 7 === 0)) {
    await page.mouse.move(...(await placeOf(page, point)));
    const { place, verdict, rest } = await cellTexts(page);
    const [, omega, e] = /^omega (\S+) rad\/s, e (\S+) m:$/.exec(place);
    near(Number(omega), point.omega, 1e-5);
    near(Number(e), point.e, 1e-5);
    assert.equal(verdict, point.verdict);
    near(number(/exponent (\S+) per revolution$/.exec(rest)[1]), point.exponent);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('a click computes the motion of a cell, as the result has it', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened();
  const sections = cellsOf(readFileSync(join(folder, 'csv', 'map-poincare-section.csv'), 'utf8'));
  for (const wanted of ['P-2', 'P-3']) {
    const point = points.find(({ verdict }) => verdict === wanted);
    await page.mouse.click(...(await placeOf(page, point)));
    await page.waitForFunction((name) => document.querySelector('.pane-a .verdict').textContent === name, wanted, {
      timeout: 60_000,
    });
    assert.equal(await settled(page), wanted);
    // Wait for both parameters, since the cell before may have had the same speed.
    await page.waitForFunction(
      ([at, set]) => {
        const hash = new URLSearchParams(location.hash.slice(1));
        return hash.get('at') === at && hash.get('set') === set;
      },
      [String(point.omega), `e=${point.e} m`],
    );
    const stored = sections.filter((row) => row.point === point.point);
    const shown = await csvOf(page, '.pane-a .panel-poincare');
    assert.ok(shown.length > 8);
    const away = (a, b) => Math.hypot(a['x [gap]'] - b['x [m]'], a['y [gap]'] - b['y [m]']);
    for (const mark of shown) near(Math.min(...stored.map((kept) => away(mark, kept))), 0);
    const period = Number(wanted.slice(2));
    // The marks repeat after the orbit's number of revolutions.
    shown.slice(period).forEach((mark, i) => near(Number(mark['x [gap]']), Number(shown[i]['x [gap]'])));
    assert.ok(Math.abs(shown[0]['x [gap]'] - shown[1]['x [gap]']) > 1e-3);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('keys walk from cell to cell; the address holds the cell, and is undone', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened();
  // The page opens at the cell nearest to the values of the case, 2.05 rad/s and 0.6 m.
  const reaches = (cell) =>
    page.waitForFunction(
      ([omegas, es, wanted]) => {
        const hash = new URLSearchParams(location.hash.slice(1));
        if (!hash.has('set')) return false;
        const values = { [hash.get('par')]: Number(hash.get('at')) };
        const [name, text] = hash.get('set').split('=');
        values[name] = Number.parseFloat(text);
        return omegas.indexOf(values.omega) === wanted[0] && es.indexOf(values.e) === wanted[1];
      },
      [columns, rows, cell],
      { timeout: 20_000 },
    );
  const [column, row] = [4, 2];
  near(columns[column], 2.1);
  near(rows[row], 0.625);
  await reaches([column, row]);
  await page.focus(`${CARD} .overlay`);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  await reaches([column + 1, row + 1]);
  await page.keyboard.press('Shift+ArrowRight');
  await reaches([Math.min(columns.length - 1, column + 11), row + 1]);
  await page.keyboard.press('Home');
  await page.keyboard.press('PageDown');
  await reaches([0, 0]);
  const spoken = await page.getAttribute(`${CARD} .overlay`, 'aria-valuetext');
  const first = points.find(({ omega, e }) => omega === columns[0] && e === rows[0]);
  assert.equal(spoken, `omega 1.5 rad/s, e 0.4 m: ${first.verdict}`);
  // The key C changes the cut from the row of the cursor to its column.
  await page.keyboard.press('c');
  await reaches([0, 0]);
  await page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).get('par') === 'e');
  await settled(page);
  const reached = page.url();
  await page.keyboard.press('ArrowUp');
  await reaches([0, 1]);
  await page.keyboard.press('Control+z');
  await page.waitForFunction((url) => location.href === url, reached);
  assert.deepEqual(complaints, []);
  await close();
  const again = await open(reached);
  await settled(again.page);
  assert.equal((await cellTexts(again.page)).place, 'omega 1.5 rad/s, e 0.4 m:');
  assert.deepEqual(again.complaints, []);
  await again.close();
});

test('the diagram is the row or the column of the cursor', { timeout: 300_000 }, async () => {
  const point = points.find(({ verdict }) => verdict === 'P-2');
  const cuts = {
    omega: `par=omega&at=${point.omega}&set=${encodeURIComponent(`e=${point.e} m`)}&q=radius`,
    e: `par=e&at=${point.e}&set=${encodeURIComponent(`omega=${point.omega} rad/s`)}&q=radius`,
  };
  for (const [along, hash] of Object.entries(cuts)) {
    const { page, complaints, close } = await opened(hash);
    const other = along === 'e' ? 'omega' : 'e';
    const mine = points.filter((each) => each[other] === point[other]);
    const table = await csvOf(page, '.map-card');
    assert.equal(table.length, mine.length);
    for (const row of table) {
      const kept = mine.find((each) => each[along] === Number(row[along === 'e' ? 'e (m)' : 'omega (rad/s)']));
      assert.equal(row.verdict, kept.verdict);
      near(Number(row['exponent per revolution']), kept.exponent);
      near(Number(row['largest radius of disc (gap 0-p)']), kept.radius);
    }
    assert.match(
      await page.textContent('.map-card .status'),
      new RegExp(`A cut through the map at ${other} = ${Number(point[other].toPrecision(6))} `),
    );
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('quantities have colours and a bar, and can be taken away', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened();
  const regimes = (await saved(page, CARD, 'svg')).bytes.toString('utf8');
  assert.match(regimes, />P-2</);
  assert.match(regimes, />e \(m\)</);
  assert.ok(await page.isHidden(`${CARD} .colour-bar`));
  for (const [id, label] of [
    ['exponent', 'exponent per revolution'],
    ['period', 'k of P-k'],
    ['radius', 'largest radius of disc'],
    ['contact', 'share of the time in contact'],
  ]) {
    await page.selectOption('select[aria-label="What the map shows"]', id);
    await page.waitForSelector(`${CARD} .colour-bar:not([hidden])`);
    const svg = (await saved(page, CARD, 'svg')).bytes.toString('utf8');
    assert.ok(svg.includes(label), id);
    assert.ok(!/NaN|Infinity/.test(svg));
    await page.waitForFunction((mq) => new URLSearchParams(location.hash.slice(1)).get('mq') === mq, id);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('finer cells are computed where one looks, and are those of a run there', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened();
  const box = await (await page.$(`${CARD} .overlay`)).boundingBox();
  const at = (right, up) => [box.x + box.width * right, box.y + box.height * (1 - up)];
  await page.keyboard.down('Shift');
  await page.mouse.move(...at(0.3, 0.05));
  await page.mouse.down();
  await page.mouse.move(...at(0.55, 0.35));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const finer = (text) => page.waitForSelector(`${CARD} button:text-is("${text}")`, { timeout: 60_000 });
  await (await finer('finer')).click();
  // The first grid halves every cell in both directions; it is complete when the next grid begins.
  await page.waitForFunction(
    () => {
      const [, columns, , known] =
        /frame: (\d+) by (\d+) cells, (\d+) of them/.exec(document.querySelector('.map-status').textContent) ?? [];
      return Number(columns) >= 20 && Number(known) > 0;
    },
    undefined,
    { timeout: 120_000 },
  );
  await (await finer('stop')).click();
  await finer('finer');
  const status = () => page.textContent('.map-status');
  assert.match(await status(), /each from 300 \+ 60 revolutions; no result holds them\.$/);
  const stopped = await status();
  const cells = [];
  for (const [right, up] of [
    [0.1, 0.1],
    [0.5, 0.3],
    [0.7, 0.6],
    [0.9, 0.8],
  ]) {
    await page.mouse.click(...at(right, up));
    const own = await cellTexts(page);
    // Wait for the verdict of the motion itself: the pane shows the one before until the engine has read the new
    // setting.
    await page.waitForFunction((name) => document.querySelector('.pane-a .verdict').textContent === name, own.verdict, {
      timeout: 60_000,
    });
    const verdict = await settled(page);
    assert.match(own.rest, /^computed in this page; confidence /);
    assert.equal(own.verdict, verdict);
    const [, omega] = /^omega (\S+) /.exec(own.place);
    const hash = await page.waitForFunction((wanted) => {
      const value = Number(new URLSearchParams(location.hash.slice(1)).get('at'));
      return Number(value.toPrecision(6)) === wanted && location.hash;
    }, Number(omega));
    const now = new URLSearchParams((await hash.jsonValue()).slice(1));
    cells.push({
      omega: Number(now.get('at')),
      e: Number(/^e=(\S+) m$/.exec(now.get('set'))[1]),
      verdict,
      exponent: number(/exponent (\S+) per revolution$/.exec(own.rest)[1]),
    });
  }
  assert.equal(await status(), stopped);
  // Compare with a run of the command at the same values. Its bits must be those of the page, since chaotic motions
  // separate after differences in the last bit.
  const list = (key) => cells.map((cell) => cell[key]).join(', ');
  writeFileSync(
    join(folder, 'finer.yaml'),
    CASE.replace(/x: .*/, `x: {parameter: omega, values: [${list('omega')}]}`).replace(
      / y: .*/,
      ` y: {parameter: e, values: [${list('e')}]}`,
    ),
  );
  process.env.WHIRL_ISA = 'simd128'; // gives the bits of the page
  try {
    command('run', 'finer.yaml', '-q', '-o', 'finer.h5');
  } finally {
    delete process.env.WHIRL_ISA;
  }
  command('export', 'finer.h5', '--csv', 'finer');
  const run = cellsOf(readFileSync(join(folder, 'finer', 'map.csv'), 'utf8'));
  for (const { omega, e, verdict, exponent } of cells) {
    const same = (row) =>
      Math.abs(Number(row['omega [rad/s]']) - omega) < 1e-12 && Math.abs(Number(row['e [m]']) - e) < 1e-12;
    const mine = run.find(same);
    assert.equal(mine.verdict, verdict);
    near(Number(mine['lyapunov/largest [1/revolution]']), exponent);
  }
  // Finer cells are drawn in every view, but are not part of the saved data of the run.
  await page.click(`${CARD} button:text-is("whole")`);
  const svg = (await saved(page, CARD, 'svg')).bytes.toString('utf8');
  assert.match(svg, /stroke-dasharray/);
  assert.equal((await csvOf(page, CARD)).length, points.length);
  assert.deepEqual(complaints, []);
  await close();
});
