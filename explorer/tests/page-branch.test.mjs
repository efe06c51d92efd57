// Tests branches of orbits in the explorer: lines and marks over the diagram, and the orbit under the cursor, stable or
// not, with the values of the result.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

const ROTOR = `whirl: 1
title: A Jeffcott rotor that rubs
parameters: {omega: 1.5 rad/s}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}
    - rub: {at: disc, gap: 1 m, stiffness: 10 N/m, friction: 0.05, law: paper}
    - gravity: 0.5 m/s2
study:
  initial: {disc: {x: 0.1, y: -0.2}}
  integrate: {transient: 200, record: 20}
  branch: {parameter: omega, from: 3.0, to: 3.3, at: [3.0]}
`;

let alone, beside;
before(() => {
  alone = makePage('alone', ROTOR);
  beside = makePage(
    'beside',
    ROTOR.replace('parameter: omega, from: 3.0, to: 3.3, at: [3.0]', 'at: [3.0]') +
      '  sweep: {parameter: omega, from: 3.0, to: 3.3, points: 16}\n',
  );
});
after(closeBrowser);

/// Returns the parameter values of the special points of a kind, as the command shows them.
function shown(kind) {
  return command('show', 'alone.h5')
    .split('\n')
    .filter((line) => line.includes(` ${kind} `))
    .map((line) => Number(line.trim().split(' ')[0]));
}

async function picture(address) {
  const { page, complaints, close } = await open(`${address}#units=scale,rad/s,order,0-p`);
  await page.waitForSelector('.map-main canvas');
  const svg = (await saved(page, '.map-card', 'svg')).bytes.toString('utf8');
  const legend = await page.textContent('.map-card .legend');
  assert.deepEqual(complaints, []);
  await close();
  return { svg, legend };
}

test('branches lie over the section of a sweep, and stand alone', { timeout: 300_000 }, async () => {
  const folds = shown('fold');
  assert.equal(folds.length, 2);
  for (const address of [alone, beside]) {
    const { svg, legend } = await picture(address);
    assert.match(legend, /solid stable, dashed not/);
    assert.equal(/confidence/.test(legend), address === beside);
    assert.match(svg, /stroke-dasharray/);
    const labels = [...svg.matchAll(/>(fold|doubling|graze|torus) ([\d.]+)</g)];
    const fold = labels.filter(([, kind]) => kind === 'fold').map(([, , value]) => Number(value));
    assert.ok(fold.length > 0);
    for (const value of fold) assert.ok(folds.some((known) => Math.abs(known - value) < 1e-5 * known));
    assert.ok(!/NaN|Infinity/.test(svg));
  }
});

// ---------------------------------------------------------------- the orbit under the cursor

/// Returns the rows of a CSV text as objects with the headings as keys.
function rowsOf(text) {
  const [heading, ...lines] = text.trim().split(/\r?\n/);
  const names = heading.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [names[i], Number(cell)])));
}

/// Returns the points of the result's branches; `section` and `multipliers` of a point return fields of several rows.
function stored() {
  command('export', 'beside.h5', '--csv', 'csv', '--force');
  const read = (name) => rowsOf(readFileSync(join(folder, 'csv', name), 'utf8'));
  const of = (name, row) => read(name).filter(({ point }) => point === row);
  return read('branch.csv').map((point) => ({
    ...point,
    row: point.point,
    section: () => of('branch-trace-section.csv', point.point),
    multipliers: () => of('branch-trace-multipliers.csv', point.point),
  }));
}

/// Returns the middle one of the unstable orbits with a number of revolutions.
function unstableOf(points, revolutions) {
  const all = points.filter(
    (point) => point['trace/unstable [1]'] > 0 && point['trace/revolutions [revolution]'] === revolutions,
  );
  assert.ok(all.length > 2);
  return all[Math.floor(all.length / 2)];
}

/// Returns the positions on the screen of the rings of setting A.
async function ringsOf(page) {
  await page.waitForSelector('.orbit-mark.side-a');
  return page.evaluate(() =>
    [...document.querySelectorAll('.orbit-mark.side-a')].map((ring) => {
      const box = ring.getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    }),
  );
}

const orbitShown = (page, row) =>
  page.waitForFunction(
    (wanted) =>
      new URLSearchParams(location.hash.slice(1)).get('orbit') === String(wanted) &&
      /stable/.test(document.querySelector('.pane-a .verdict').textContent) &&
      !document.querySelector('.pane-a').classList.contains('busy'),
    row,
    { timeout: 60_000 },
  );

const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} is not ${b}`);

/// Checks that the page shows the numbers of an orbit that the result has.
async function expectOrbit(page, point) {
  const revolutions = point['trace/revolutions [revolution]'];
  const unstable = point['trace/unstable [1]'];
  const label = await page.textContent('.pane-a .reason');
  assert.match(label, new RegExp(`^branch ${point['trace/number [1]']}: P-${revolutions}, unstable \\(${unstable} `));
  assert.equal(await page.textContent('.pane-a .verdict'), `P-${revolutions}, unstable`);
  const head = await page.evaluate(() => {
    const cells = (kind) => [...document.querySelectorAll(`.pane-a .orbit-numbers ${kind}`)].map((c) => c.textContent);
    return [cells('thead th'), [...cells('tbody th'), ...cells('tbody td')]];
  });
  const number = (name) => Number(head[1][head[0].findIndex((text) => text.startsWith(name))].replace('\u2212', '-'));
  const span = (axis) => point[`trace/high disc ${axis} [m]`] - point[`trace/low disc ${axis} [m]`];
  near(number('X'), span('x'));
  near(number('Y'), span('y'));
  assert.equal(number('outside'), unstable);
  const csv = async (panel) => (await saved(page, `.pane-a .panel-${panel}`, 'csv')).bytes.toString('utf8');
  // The path stays within the bounds of the orbit, nearly reaches them, and ends where it began.
  const path = rowsOf(await csv('orbit'));
  const section = point.section();
  for (const axis of ['x', 'y']) {
    const along = path.map((sample) => sample[`${axis} [gap]`]);
    const [low, high] = ['low', 'high'].map((bound) => point[`trace/${bound} disc ${axis} [m]`]);
    assert.ok(Math.min(...along) > low - 1e-6 && Math.max(...along) < high + 1e-6);
    assert.ok(Math.max(...along) - Math.min(...along) > 0.99 * (high - low));
    near(along.at(-1), section[0][`${axis} [m]`]);
  }
  // The Poincare map has the mark of every revolution, repeated over the record.
  const marks = rowsOf(await csv('poincare'));
  assert.ok(marks.length >= 32 && marks.length % revolutions === 0);
  marks.forEach((mark, i) => {
    for (const axis of ['x', 'y']) near(mark[`${axis} [gap]`], section[(i + 1) % revolutions][`${axis} [m]`]);
  });
  const multipliers = rowsOf(await csv('multipliers'));
  point.multipliers().forEach((kept, i) => {
    near(multipliers[i].real, kept['real [1]']);
    near(multipliers[i].imaginary, kept['imaginary [1]']);
  });
}

test('near a branch the cursor takes its orbit, stable or not', { timeout: 300_000 }, async () => {
  const points = stored();
  for (const revolutions of [1, 2]) {
    const point = unstableOf(points, revolutions);
    const { page, complaints, close } = await open(`${beside}#orbit=${point.row}&units=scale,rad/s,order,0-p`);
    await orbitShown(page, point.row);
    const rings = await ringsOf(page);
    assert.equal(rings.length, revolutions);
    // A click far from the branch shows the motion.
    const box = await (await page.$('.map-main .overlay')).boundingBox();
    const [x, y] = rings[0];
    await page.mouse.click(x, y > box.y + 60 ? box.y + 20 : box.y + box.height - 60);
    await settled(page);
    await page.waitForFunction(() => !location.hash.includes('orbit='));
    assert.ok(await page.isHidden('.pane-a .panel-multipliers'));
    // With the pointer over the line, the hint names the orbit that a click selects.
    await page.mouse.move(x, y);
    await page.waitForSelector('.orbit-hint:not([hidden])');
    const hint = await page.textContent('.orbit-hint');
    await page.mouse.down();
    await page.mouse.up();
    await orbitShown(page, point.row);
    assert.equal(await page.textContent('.pane-a .reason'), hint);
    await expectOrbit(page, point);
    const svg = (await saved(page, '.pane-a .panel-orbit', 'svg')).bytes.toString('utf8');
    assert.match(svg, new RegExp(`branch ${point['trace/number [1]']}: P-${revolutions}, unstable`));
    assert.match(svg, /stroke-dasharray="7[ ,]4"/);
    assert.ok(!/NaN|Infinity/.test(svg));
    assert.deepEqual(complaints, []);
    await close();
  }
});

test(
  'keys walk along a branch and through those at a value, and the address holds it',
  { timeout: 300_000 },
  async () => {
    const points = stored();
    const point = unstableOf(points, 1);
    const { page, complaints, close } = await open(`${beside}#orbit=${point.row}`);
    await orbitShown(page, point.row);
    await page.focus('.map-main .overlay');
    await page.keyboard.press('ArrowRight');
    const mine = points.filter((other) => other['trace/number [1]'] === point['trace/number [1]']);
    const rising = mine.at(-1)['omega [rad/s]'] >= mine[0]['omega [rad/s]'];
    await orbitShown(page, point.row + (rising ? 1 : -1));
    await page.keyboard.press('ArrowLeft');
    await orbitShown(page, point.row);
    const spoken = await page.getAttribute('.map-main .overlay', 'aria-valuetext');
    assert.match(spoken, /branch \d+: P-1, unstable/);
    // The key O selects each branch at this value in turn, then the motion.
    const seen = [];
    for (let i = 0; i < 12; i++) {
      const before = page.url();
      await page.keyboard.press('o');
      await page.waitForFunction((url) => location.href !== url, before);
      const orbit = new URL(page.url()).hash.match(/orbit=(\d+)/)?.[1];
      if (orbit === undefined) break;
      seen.push(Number(orbit));
    }
    assert.ok(seen.length < 12 && new Set(seen).size === seen.length);
    await settled(page);
    // The address selects the orbit again, and a comparison shows it as setting B.
    await page.evaluate((row) => (location.hash = `#orbit=${row}`), point.row);
    await orbitShown(page, point.row);
    await page.click('text=A | B');
    await page.waitForFunction(() => /unstable/.test(document.querySelector('.pane-b .verdict').textContent));
    await page.waitForFunction((row) => location.hash.includes(`borbit=${row}`), point.row);
    assert.deepEqual(complaints, []);
    await close();
  },
);
