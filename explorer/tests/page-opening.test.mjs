// Tests that the page opens at a point with high confidence, and shows its motion before anything is computed.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, makePage, open } from './browser.mjs';

// The records are so short that some points are undetermined, also near the middle of the sweep.
const TEXT = CASE.replace(/\n  detail:.*\n/, '\n')
  .replace('transient: 300, record: 100', 'transient: 150, record: 60')
  .replace('points: 61', 'points: 31')
  .replace('spectrum, orbit, rub]', 'spectrum, waveform, orbit, rub]\n  keep: {waveform: 4}');

let address, points, opening;
before(() => {
  address = makePage('opening', TEXT);
  points = JSON.parse(command('show', 'opening.h5', '--json=full')).points;
  const html = readFileSync(fileURLToPath(address), 'utf8');
  opening = JSON.parse(/<script[^>]*id="whirl-runs"[^>]*>([^]*?)<\/script>/.exec(html)[1])[0].opening;
});
after(closeBrowser);

test('it opens at the point nearest to the middle that the run is sure of', () => {
  const sure = ({ regime, confidence }) => regime !== 'undetermined' && confidence !== 'low';
  const away = ({ parameters }) => Math.abs(parameters.omega - 2.5);
  const wanted = points.filter(sure).sort((a, b) => away(a) - away(b))[0];
  assert.ok(
    points.some((point) => !sure(point)),
    'there are points that it is not sure of',
  );
  assert.equal(opening.value, wanted.parameters.omega);
  assert.equal(opening.verdict.name, wanted.verdict);
  assert.equal(opening.verdict.reason, wanted.reason);
});

test('its motion is there without the engine', async () => {
  const path = fileURLToPath(address).replace('.html', '-still.html');
  const html = readFileSync(fileURLToPath(address), 'utf8');
  writeFileSync(path, html.replace(/(<script[^>]*id="whirl-core"[^>]*>)[^]*?<\/script>/, '$1</script>'));
  const { page, close } = await open(address.replace('.html', '-still.html'));
  await page.waitForSelector('.pane-a .verdict:not(:empty)');
  assert.equal(await page.textContent('.pane-a .verdict'), opening.verdict.name);
  assert.match(await page.textContent('.pane-a .how'), /^Stored by the run: 150 \+ 60 revolutions, rk4/);
  const point = points.find(({ parameters }) => parameters.omega === opening.value).stations.disc;
  const size = Number(
    /([\d.]+) \S+ 0-p from the centre/.exec(await page.textContent('.pane-a [class*=panel-orbit] .panel-note'))[1],
  );
  assert.ok(Math.abs(size / point.max_radius - 1) < 1e-2, `${size}, the run says ${point.max_radius}`);
  await close();
});
