// Branches of orbits in the explorer: lines and marks over the diagram, with values as the result has them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, command, makePage, open, saved } from './browser.mjs';

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

/// The values of special points, as the command shows them, by their kinds.
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
