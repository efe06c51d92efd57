// Tests basins in the explorer: attractors with the shares that the command reports, and the borders between them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

// A motion that starts within the gap settles; one that starts far beyond it diverges by dry friction.
const CASE = `whirl: 1
title: A Jeffcott rotor that rubs, and where it begins
parameters: {x0: 0, y0: 0}
rotor:
  speed: 2 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.3 m}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}
    - rub: {at: disc, gap: 1 m, stiffness: 10 N/m, friction: 0.16, law: paper}
    - gravity: 0.5 m/s2
study:
  basin:
    x: {parameter: x0, from: 0, to: 3, points: 7}
    y: {parameter: y0, from: -0.4, to: 0.4, points: 3}
  initial: {disc: {x: = x0, y: = y0}}
  integrate: {transient: 400, record: 20}
  analyze: [poincare, regime, lyapunov, orbit, rub]
`;
const CARD = '.parameter-map-card';

let address, attractors, labels;
before(() => {
  address = makePage('basin', CASE);
  attractors = JSON.parse(command('run', 'basin.yaml', '-q', '--json=full', '-o', 'again.h5')).attractors;
  command('export', 'basin.h5', '--csv', 'csv');
  const [heading, ...lines] = readFileSync(join(folder, 'csv', 'basin.csv'), 'utf8')
    .trim()
    .split(/\r?\n/);
  const verdict = heading.split(',').indexOf('verdict');
  labels = lines.map((line) => line.split(',')[verdict].replace(/ at revolution.*/, ''));
});
after(closeBrowser);

async function opened(hash) {
  const all = await open(`${address}#${hash}`);
  await all.page.waitForSelector(`${CARD} canvas`);
  await settled(all.page);
  return all;
}

test('attractors have the shares that the command tells', { timeout: 300_000 }, async () => {
  assert.ok(attractors.length > 1);
  const { page, complaints, close } = await opened('');
  assert.equal(await page.inputValue('select[aria-label="What the map shows"]'), 'attractor');
  const percent = (share) => `${(100 * share).toFixed(1)} %`;
  const reported = attractors.reduce((sum, { starts }) => sum + starts, 0);
  const entries = await page.$$eval(`${CARD} .legend-entry`, (all) => all.map(({ textContent }) => textContent));
  assert.deepEqual(entries, [
    ...attractors.map(({ regime, period, share, error }) => {
      const name = regime === 'periodic' ? `P-${period}` : regime;
      return `${name} ${percent(share)} \u00b1 ${percent(error)}`;
    }),
    ...(reported < labels.length ? [`unknown ${labels.length - reported}`] : []),
  ]);
  assert.match(await page.textContent('.map-rest'), /^attractor (\d|unknown) of \d/);
  assert.deepEqual(complaints, []);
  await close();
});

test('lines lie where attractors meet', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await opened('ml=1');
  assert.equal(await page.getAttribute(`${CARD} button:has-text("boundaries")`, 'aria-pressed'), 'true');
  const svg = (await saved(page, CARD, 'svg')).bytes.toString('utf8');
  const [columns, rows] = [7, 3];
  let meetings = 0;
  for (let i = 0; i < columns * rows; i++) {
    if (i % columns < columns - 1) meetings += labels[i] !== labels[i + 1];
    if (i + columns < columns * rows) meetings += labels[i] !== labels[i + columns];
  }
  assert.ok(meetings > 0);
  const pieces = [...svg.matchAll(/<path[^>]* d="([^"]*)"/g)].map(([, d]) => (d.match(/M/g) ?? []).length);
  assert.ok(pieces.includes(meetings), `${pieces} has no ${meetings}`);
  await page.click(`${CARD} button:has-text("boundaries")`);
  await page.waitForFunction(() => !new URLSearchParams(location.hash.slice(1)).has('ml'));
  assert.deepEqual(complaints, []);
  await close();
});
