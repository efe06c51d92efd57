// Tests maps over three parameters in the explorer: a slider chooses the plane that is shown; the texts of cells, the
// motion of a click and the cut in the diagram belong to that plane.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

// The values of the planes fall, and the friction of the case is not among them.
const CASE = `whirl: 1
title: A Jeffcott rotor that rubs, over speed, unbalance and friction
parameters: {omega: 2.05 rad/s, e: 0.6 m, f: 0.06}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: = e}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}
    - rub: {at: disc, gap: 1 m, stiffness: 10 N/m, friction: = f, law: paper}
    - gravity: 0.5 m/s2
study:
  map:
    x: {parameter: omega, from: 1.5, to: 3.6, points: 8}
    y: {parameter: e, values: [0.4, 0.625, 0.9765625]}
    z: {parameter: f, values: [0.1, 0.05, 0]}
  initial: {disc: {x: 0.1, y: -0.2}}
  integrate: {transient: 300, record: 60}
  analyze: [poincare, regime, lyapunov, orbit, rub, floquet]
`;
const CARD = '.parameter-map-card';
const UNITS = 'units=scale,rad/s,order,0-p';

let address, points;
before(() => {
  address = makePage('planes', CASE);
  command('export', 'planes.h5', '--csv', 'planes-csv');
  points = cellsOf(readFileSync(join(folder, 'planes-csv', 'map.csv'), 'utf8')).map((row) => ({
    omega: Number(row['omega [rad/s]']),
    e: Number(row['e [m]']),
    f: Number(row['f [1]']),
    verdict: row.verdict,
    exponent: Number(row['lyapunov/largest [1/revolution]'] || NaN),
  }));
});
after(closeBrowser);

function cellsOf(text) {
  const [heading, ...lines] = text.trim().split(/\r?\n/);
  const names = heading.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [names[i], cell])));
}

const csvOf = async (page, card) => cellsOf((await saved(page, card, 'csv')).bytes.toString('utf8'));

async function opened(hash = '') {
  const all = await open(`${address}#${hash}${hash && '&'}${UNITS}`);
  await all.page.waitForSelector(`${CARD} canvas`);
  await settled(all.page);
  return all;
}

/// Moves the slider to a plane by its number.
async function toPlane(page, index) {
  await page.$eval(
    `${CARD} .planes input`,
    (input, value) => {
      input.value = String(value);
      input.dispatchEvent(new Event('input', { bubbles: true }));
    },
    index,
  );
}

test('every plane tells what the result holds of it', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened();
  // The page opens at the plane nearest to the friction of the case.
  assert.equal(await page.textContent('.plane-value'), 'f = 0.05');
  assert.match(await page.textContent('.map-status'), /8 by 3 points over omega and e in each of 3 planes of f/);
  for (const [index, f] of [0, 0.05, 0.1].entries()) {
    await toPlane(page, index);
    await page.waitForFunction((text) => document.querySelector('.plane-value').textContent === text, `f = ${f}`);
    const table = await csvOf(page, CARD);
    const mine = points.filter((point) => point.f === f);
    assert.equal(table.length, mine.length);
    assert.equal(mine.length, 24);
    assert.ok(mine.filter(({ exponent }) => Number.isFinite(exponent)).length > 12);
    const reported = await page.$$eval(`${CARD} .legend .count`, (all) => all.map((one) => Number(one.textContent)));
    assert.equal(
      reported.reduce((sum, count) => sum + count, 0),
      24,
    );
    for (const point of mine) {
      const row = table.find((one) => Number(one['omega (rad/s)']) === point.omega && Number(one['e (m)']) === point.e);
      assert.equal(Number(row['f (SI)']), f);
      assert.equal(row.verdict, point.verdict);
      // Motions that diverge have no exponent.
      if (Number.isFinite(point.exponent))
        assert.ok(Math.abs(Number(row['exponent per revolution']) - point.exponent) < 1e-6);
    }
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('a click computes the motion of a cell in its plane, and the cut is in it', { timeout: 300_000 }, async () => {
  const alike = (one, other) => one.omega === other.omega && one.e === other.e;
  const differs = (point) =>
    points.some((one) => alike(one, point) && one.f === 0.05 && Math.abs(one.exponent - point.exponent) > 1e-5);
  const point = points.find((one) => one.f === 0.1 && one.verdict.startsWith('P-') && differs(one));
  const { page, complaints, close } = await opened();
  await toPlane(page, 2);
  await page.waitForFunction(() => document.querySelector('.plane-value').textContent === 'f = 0.1');
  const box = await (await page.$(`${CARD} .overlay`)).boundingBox();
  const [omegas, es] = ['omega', 'e'].map((key) => [...new Set(points.map((one) => one[key]))].sort((a, b) => a - b));
  await page.mouse.click(
    box.x + (box.width * (omegas.indexOf(point.omega) + 0.5)) / omegas.length,
    box.y + box.height * (1 - (es.indexOf(point.e) + 0.5) / es.length),
  );
  await page.waitForFunction(
    ([e]) => new URLSearchParams(location.hash.slice(1)).getAll('set').join().includes(`e=${e} m`),
    [point.e],
  );
  assert.equal(await settled(page), point.verdict);
  assert.ok(page.url().includes('f%3D0.1') || page.url().includes('f=0.1'), page.url());
  // The diagram is a row of that plane.
  await page.waitForFunction(
    (f) => document.body.textContent.includes(`A cut through the map at e = ${f}`),
    `${point.e} m and f = 0.1`,
  );
  const table = await csvOf(page, '.map-card');
  const mine = points.filter((one) => one.e === point.e && one.f === 0.1);
  assert.equal(table.length, mine.length);
  assert.deepEqual(complaints, []);
  await close();
});
