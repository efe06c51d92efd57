// Tests files that the explorer saves, and the cases and commands that it writes, in a real Chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, folder, makePage, open, presets, saved, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('rub', CASE);
});
after(closeBrowser);

test('pictures and data can be saved', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  for (const panel of [
    '.map-card',
    '.panel-orbit',
    '.panel-poincare',
    '.panel-waveform',
    '.panel-spectrum',
    '.panel-full-spectrum',
    '.panel-centreline',
  ]) {
    const png = await saved(page, panel, 'png');
    assert.match(png.name, /^whirl-.*\.png$/);
    assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(png.bytes.length > 3000, `${panel}: a picture of ${png.bytes.length} bytes`);
    const svg = (await saved(page, panel, 'svg')).bytes.toString('utf8');
    assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
    const errors = await page.evaluate(
      (text) => new DOMParser().parseFromString(text, 'image/svg+xml').querySelectorAll('parsererror').length,
      svg,
    );
    assert.equal(errors, 0, `${panel}: the SVG is well-formed`);
    const csv = (await saved(page, panel, 'csv')).bytes.toString('utf8').split('\r\n');
    const columns = csv[0].split(',').length;
    assert.ok(csv.length > 10 && columns > 1, `${panel}: ${csv.length} lines of ${columns} columns`);
    assert.ok(
      csv.slice(1, -1).every((line) => line.split(',').length === columns),
      `${panel}: columns`,
    );
  }
  assert.deepEqual(complaints, []);
  await close();
});

/// Returns the boxes [left, right, top, bottom] of the labels of peaks in an SVG, and the segments of its curves.
async function labelled(page, svg) {
  return page.evaluate((text) => {
    const drawing = document.body.appendChild(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement);
    const size = (label) => Number(label.getAttribute('font-size'));
    const labels = [...drawing.querySelectorAll('text')].filter((label) => /^[\d.]+X$/.test(label.textContent));
    const boxes = labels.map((label) => {
      const [middle, half] = [Number(label.getAttribute('x')), label.getComputedTextLength() / 2];
      const baseline = Number(label.getAttribute('y')) - 0.2 * size(label);
      return [middle - half, middle + half, baseline - 0.72 * size(label), baseline];
    });
    const segments = [];
    for (const path of drawing.querySelectorAll('path[stroke-linejoin="round"]'))
      for (const part of path.getAttribute('d').split('M').slice(1)) {
        const places = part.split('L').map((place) => place.split(' ').map(Number));
        for (let i = 1; i < places.length; i++) segments.push([...places[i - 1], ...places[i]]);
      }
    drawing.remove();
    return { boxes, segments };
  }, svg);
}

/// Returns true if a segment passes through a box (Liang and Barsky 1984).
function crosses([left, right, top, bottom], [x0, y0, x1, y1]) {
  let [from, to] = [0, 1];
  for (const [p, q] of [
    [x0 - x1, x0 - left],
    [x1 - x0, right - x0],
    [y0 - y1, y0 - top],
    [y1 - y0, bottom - y0],
  ]) {
    if (p === 0 && q < 0) return false;
    if (p < 0) from = Math.max(from, q / p);
    if (p > 0) to = Math.min(to, q / p);
  }
  return from < to;
}

test('labels of spectra lie neither on one another nor on the curves', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.3`);
  let count = 0;
  for (const value of [3.3, 3.4, 3.5, 3.7]) {
    await page.fill('#value-a', String(value));
    await page.press('#value-a', 'Enter');
    await settled(page);
    for (const logarithmic of [false, true])
      for (const panel of ['.panel-spectrum', '.panel-full-spectrum']) {
        if (logarithmic) await page.click(`${panel} button:text-is("log")`);
        const { boxes, segments } = await labelled(page, (await saved(page, panel, 'svg')).bytes.toString('utf8'));
        if (logarithmic) await page.click(`${panel} button:text-is("log")`);
        count += boxes.length;
        assert.ok(boxes.length > 0 && segments.length > 100);
        boxes.forEach((box, i) => {
          const on = boxes.slice(0, i).filter(([l, r, t, b]) => l < box[1] && r > box[0] && t < box[3] && b > box[2]);
          assert.deepEqual(on, [], `${panel} at ${value}: labels on one another`);
          assert.deepEqual(
            segments.filter((segment) => crosses(box, segment)),
            [],
            `${panel} at ${value}${logarithmic ? ', logarithmic' : ''}: the curve runs through a label at ${box}`,
          );
        });
      }
  }
  assert.ok(count >= 32, `${count} labels`);
  assert.deepEqual(complaints, []);
  await close();
});

test('the diagram that is saved is the one of the run', async () => {
  const { page, close } = await open(`${address}#q=radius&units=scale,rad/s,order,0-p`);
  await settled(page);
  const lines = (await saved(page, '.map-card', 'csv')).bytes
    .toString('utf8')
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(','));
  const { points } = JSON.parse(command('run', 'rub.yaml', '--json=full', '-q'));
  assert.equal(lines.length, points.length);
  points.forEach((point, i) => {
    assert.ok(Math.abs(Number(lines[i][0]) - point.parameters.omega) < 1e-12);
    assert.equal(lines[i][2], point.verdict);
    const radius = point.stations.disc.max_radius;
    assert.ok(Math.abs(Number(lines[i][6]) - radius) < 1e-6 * radius); // float32
  });
  await close();
});

test('a setting becomes a case that whirl checks and runs', async () => {
  const { page, complaints, close } = await open(
    `${address}#at=3.3&set=mu%3D0.12&range=3,3.5&steps=128&transient=200&record=100`,
  );
  await settled(page);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  const text = readFileSync(await file.path(), 'utf8');
  assert.match(text, /# friction coefficient/, 'comments are kept');
  writeFileSync(join(folder, 'explored.yaml'), text);
  command('check', 'explored.yaml');
  const result = JSON.parse(command('run', 'explored.yaml', '--json=full', '-q'));
  assert.equal(result.points[0].parameters.mu, 0.12);
  assert.equal(result.points[0].parameters.omega, 3);
  assert.equal(result.points.at(-1).parameters.omega, 3.5);
  assert.equal(result.detail.length, 1);
  assert.equal(result.detail[0].parameters.omega, 3.3);
  assert.deepEqual(complaints, []);
  await close();
});

test('the command that is copied computes the setting', async () => {
  const { page, complaints, close } = await open(`${address}#at=1.5&set=mu%3D0.08`);
  await settled(page);
  await page.evaluate(() => (navigator.clipboard.writeText = async (text) => void (window.copied = text)));
  await page.click('button:text-is("Copy command")');
  await page.waitForFunction(() => window.copied);
  const script = await page.evaluate(() => window.copied);
  assert.match(script, /whirl run rub-explored\.yaml -o rub-explored\.h5 && whirl report/);
  execFileSync('bash', ['-e'], {
    cwd: folder,
    input: script.replace(/^whirl run.*$/m, `"$WHIRL" run rub-explored.yaml -q -o rub-explored.h5`),
  });
  const { detail } = JSON.parse(command('run', 'rub-explored.yaml', '--json=full', '-q'));
  assert.equal(detail[0].parameters.mu, 0.08);
  assert.equal(detail[0].parameters.omega, 1.5);
  assert.deepEqual(complaints, []);
  await close();
});

test('a page without results has the presets, which are computed here', async () => {
  const { page, complaints, close } = await open(`${presets}#run=rigid-rotor`);
  await settled(page);
  assert.equal(await page.textContent('h1'), 'Rigid rotor in an oil film');
  await page.waitForFunction(() => Number(document.querySelector('.legend-entry .count')?.textContent) > 2, undefined, {
    timeout: 60_000,
  });
  assert.equal(await page.$$eval('.parameter', (all) => all.length), 3);
  assert.deepEqual(complaints, []);
  await close();
});
