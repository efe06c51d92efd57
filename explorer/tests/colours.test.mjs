// Tests the colours of regimes: readers with any colour vision can distinguish them, and page and report have the same.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { contrast, distance, labOf, VISIONS } from './colour.mjs';

/// Least CIEDE2000 distance of any two regimes, and of each regime from the background (paper).
const APART = 16;

const read = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');
const source = read('../src/figure/theme.ts');
const themes = Object.fromEntries(
  ['LIGHT', 'DARK'].map((name) => {
    const [, body] = new RegExp(`export const ${name}: Theme = \\{(.*?)\\n\\};`, 's').exec(source);
    const classes = /classes: \[(.*?)\]/.exec(body)[1].match(/#[0-9a-f]{6}/g);
    return [name, { classes, paper: /paper: '(#[0-9a-f]{6})'/.exec(body)[1] }];
  }),
);
const names = [
  ...read('../src/data/regimes.ts')
    .match(/CLASS_NAMES = \[(.*?)\]/s)[1]
    .matchAll(/'(.*?)'/g),
].map(([, name]) => name);

test('the distance is that of Sharma, Wu and Dalal', () => {
  // G. Sharma, W. Wu, E. N. Dalal, The CIEDE2000 Color-Difference Formula, Color Res. Appl. 30 (2005) 21, table 1.
  for (const [one, other, published] of [
    [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425],
    [[50, -1, 2], [50, 0, 0], 2.3669],
    [[50, 2.5, 0], [50, 0, -2.5], 4.3065],
    [[50, 2.5, 0], [56, -27, -3], 31.903],
    [[22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373],
    [[2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082],
  ])
    assert.ok(Math.abs(distance(one, other) - published) < 5e-5, `${one} and ${other}: ${distance(one, other)}`);
});

for (const [theme, { classes, paper }] of Object.entries(themes))
  for (const vision of Object.keys(VISIONS))
    test(`${theme}: regimes are distinct with ${vision}`, (context) => {
      assert.equal(classes.length, names.length);
      const all = [...classes, paper].map((colour, i) => ({ name: names[i] ?? 'paper', lab: labOf(colour, vision) }));
      const pairs = all.flatMap((one, i) =>
        all
          .slice(0, i)
          .map((other) => ({ pair: `${other.name} and ${one.name}`, apart: distance(one.lab, other.lab) })),
      );
      pairs.sort((a, b) => a.apart - b.apart);
      context.diagnostic(`nearest: ${pairs[0].pair}, ${pairs[0].apart.toFixed(1)}`);
      assert.deepEqual(
        pairs.filter(({ apart }) => apart < APART),
        [],
      );
    });

test('every regime stands out from its paper', () => {
  for (const { classes, paper } of Object.values(themes))
    for (const colour of classes)
      assert.ok(contrast(colour, paper) >= 2.25, `${colour} on ${paper}: ${contrast(colour, paper)}`);
});

test('reports have the colours and names of the light theme', () => {
  const report = [...read('../../src/report/regimes.c').matchAll(/\[CLASS_\w+\] = \{"(.*?)", "(#[0-9A-F]{6})"\}/g)];
  assert.deepEqual(
    report.map(([, name, colour]) => [name, colour.toLowerCase()]).filter(([name]) => name !== 'not judged'),
    names.map((name, i) => [name, themes.LIGHT.classes[i]]),
  );
});

test('confidence takes the same share of a colour in reports and page', () => {
  const numbers = (path, pattern) => pattern.exec(read(path)).slice(1).map(Number);
  const three = '([\\d.]+)[^\\d]+([\\d.]+)[^\\d]+([\\d.]+)';
  const report = numbers('../../src/report/figures/figure_map.c', new RegExp(`\\[WHIRL_LOW\\] = ${three}`));
  assert.deepEqual(numbers('../src/view/parameter_map.ts', new RegExp(`STRENGTH = \\[${three}`)), report);
});

test('Python knows the colours of regimes by their names', () => {
  const [, body] = /^REGIMES = \{\n(.*?)^\}/ms.exec(read('../../bindings/python/whirl/plot.py'));
  assert.deepEqual(
    [...body.matchAll(/"(.*?)": "(#[0-9A-F]{6})"/g)].map(([, name, colour]) => [name, colour.toLowerCase()]),
    names.map((name, i) => [name, themes.LIGHT.classes[i]]),
  );
});
