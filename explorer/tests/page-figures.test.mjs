// Tests results without a live view: the page draws their figures from the library's descriptions.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, command, fan, folder, makePage, open, saved } from './browser.mjs';
import { join } from 'node:path';

const STUDY = 'critical_speeds: {parameter: k, from: 0.1 MN/m, to: 100 MN/m, points: 13, scale: log}';
const FAN = fan('kxx: = k', 'kxx: = k', STUDY, ', k: 1 MN/m');
const CARD = '[data-figure="critical-speeds"]';

let page, figure;
before(() => {
  page = makePage('critical', FAN);
  figure = JSON.parse(command('figure', join(folder, 'critical.h5'), '-o', '-'));
});
after(closeBrowser);

test('critical speeds are drawn from the data of the figure', async () => {
  const { page: shown, complaints, close } = await open(page);
  await shown.waitForSelector(`${CARD} svg`);
  assert.equal(await shown.textContent(`${CARD} h2`), figure.title);
  assert.equal(await shown.textContent(`${CARD} > p`), figure.caption);
  const panel = figure.panels[0];
  const drawn = await shown.$eval(`${CARD} svg`, (svg) => ({
    lines: [...svg.querySelectorAll('g[clip-path] path')].map((path) => ({
      colour: path.getAttribute('stroke').toLowerCase(),
      dashed: path.hasAttribute('stroke-dasharray'),
      points: path.getAttribute('d').match(/[ML]/g)?.length ?? 0,
      first: path.getAttribute('d').slice(1).split(/[ML]/)[0].split(',').map(Number),
    })),
    box: ['x', 'y', 'width', 'height'].map((key) => Number(svg.querySelector('clipPath rect').getAttribute(key))),
    texts: [...svg.querySelectorAll('text')].map((text) => text.textContent.replaceAll('\u200b', '')),
  }));
  const lines = panel.series.filter(({ shape, x }) => shape === 'line' && x?.length);
  assert.ok(lines.length >= 6);
  assert.deepEqual(
    drawn.lines.map(({ colour, dashed, points }) => [colour, dashed, points]),
    lines.map(({ colour, dashed, x, y }) => [
      colour.toLowerCase(),
      dashed,
      x.filter((value, i) => value !== null && y[i] !== null).length,
    ]),
  );
  // The first point of every line lies where its axes say.
  const share = ({ low, high, log }, value) =>
    log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  const [left, top, width, height] = drawn.box;
  drawn.lines.forEach(({ first }, i) => {
    const at = lines[i].x.findIndex((value, k) => value !== null && lines[i].y[k] !== null);
    assert.ok(Math.abs(first[0] - (left + share(panel.x, lines[i].x[at]) * width)) < 0.02);
    assert.ok(Math.abs(first[1] - (top + (1 - share(panel.y, lines[i].y[at])) * height)) < 0.02);
  });
  for (const text of [...panel.x.tick_texts, ...panel.y.tick_texts, 'forward', 'backward'])
    assert.ok(drawn.texts.includes(text), text);
  assert.ok(drawn.texts.includes(panel.x.label.replaceAll('$', '')));
  const csv = (await saved(shown, CARD, 'csv')).bytes.toString('utf8').trim().split(/\r?\n/).slice(1);
  assert.equal(
    csv.length,
    panel.series.reduce((sum, { x }) => sum + (x?.length ?? 0), 0),
  );
  assert.deepEqual(complaints, []);
  await close();
});
