// Tests quasi-periodic motions in the explorer: bands over the diagram begin at the orbit at which the tori begin, and
// have the rotation numbers and bounds of the result.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, command, makePage, open, saved } from './browser.mjs';

const ROTOR = `whirl: 1
title: A rotor on two oil films
parameters: {r_k: 0.6, omega: 650 rad/s, c: 0.2 mm, k2: = 50*(650/0.2)^2}
rotor:
  speed: = omega
  length_scale: = c
  stations:
    disc:    {mass: 420 kg, damping: 4300 N.s/m, eccentricity: = 0.08*c}
    journal: {mass: 100 kg, damping: 9300 N.s/m}
  elements:
    - shaft:   {between: [disc, journal], k1: = r_k*k2, k2: = k2, signs: paper}
    - film:    {at: journal, count: 2, law: capone, clearance: = c, load: = 0.0045*50*c*omega^2}
    - gravity: 9.8 m/s2
study:
  initial: {disc: {y: -0.9}, journal: {y: -0.8}}
  branch: {parameter: r_k, from: 0.48, to: 0.38, rtol: 1e-9, tori: yes, torus_accuracy: 1e-4}
`;

let address;
before(() => (address = makePage('tori', ROTOR)));
after(closeBrowser);

/// Returns the points of a closed path of an SVG.
function pointsOf(path) {
  return [...path.matchAll(/(-?[\d.]+)[ ,](-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
}

test('bands of tori lie over the diagram with their rotation numbers', { timeout: 300_000 }, async () => {
  const { page, complaints, close } = await open(`${address}#units=scale,rad/s,order,0-p`);
  await page.waitForSelector('.map-main canvas');
  assert.match(await page.textContent('.map-card .legend'), /tori: bands/);
  const svg = (await saved(page, '.map-card', 'svg')).bytes.toString('utf8');
  await close();
  assert.deepEqual(complaints, []);
  assert.ok(!/NaN|Infinity/.test(svg));
  const shown = command('show', 'tori.h5').match(/rotation number +([\d.]+) to ([\d.]+)/);
  const label = svg.match(/>rotation ([\d.]+) to ([\d.]+)</);
  for (const i of [1, 2]) assert.ok(Math.abs(Number(shown[i]) - Number(label[i])) < 1e-5);
  // One filled path goes through the edges of all tori and the orbits at which the tori begin and end.
  const { columns, rows } = JSON.parse(command('show', 'tori.h5', '--json')).sheets.find(({ name }) => name === 'tori');
  const tori = rows[0][columns.findIndex(({ key }) => key === 'points')];
  const filled = [...svg.matchAll(/<path[^>]*?\bd="([^"]*)"[^>]*>/g)]
    .filter(([whole]) => /opacity="0?\.28"/.test(whole))
    .map(([, path]) => pointsOf(path));
  assert.equal(filled.length, 1);
  assert.equal(filled[0].length, 2 * (tori + 2));
  // The band has no width at its beginning and its end, and is wide between them.
  const heights = filled[0].slice(0, tori + 2).map(([, y], i) => filled[0][2 * tori + 3 - i][1] - y);
  const widest = Math.max(...heights);
  assert.ok(widest > 50 && heights[0] === 0 && heights.at(-1) === 0);
});
