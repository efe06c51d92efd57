// Tests that zooming adds finer points in the view to the existing points.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('zoom', CASE);
});
after(closeBrowser);

const status = (page) => page.textContent('.map-card .status');
const view = (page) =>
  page.$eval('.map-main .overlay', (slider) => [
    Number(slider.getAttribute('aria-valuemin')),
    Number(slider.getAttribute('aria-valuemax')),
  ]);
const done = (page) =>
  page.waitForFunction(
    () => /\d+ finer points were computed here\./.test(document.querySelector('.map-card .status').textContent),
    undefined,
    { timeout: 120_000 },
  );
const finer = async (page) => Number(/(\d+) finer points/.exec(await status(page))?.[1] ?? 0);

async function openSmall(hash) {
  const opened = await open(address + hash);
  await settled(opened.page);
  await opened.page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await opened.page.focus('.map-main .overlay');
  return opened;
}

/// Zooms in three times; each time it waits until the view has changed.
async function zoomIn(page) {
  for (let i = 0; i < 3; i++) {
    const [low, high] = await view(page);
    await page.keyboard.press('+');
    await page.waitForFunction(
      (span) => {
        const slider = document.querySelector('.map-main .overlay');
        return slider.getAttribute('aria-valuemax') - slider.getAttribute('aria-valuemin') < span;
      },
      0.75 * (high - low),
    );
  }
}

/// Returns [parameter, verdict] of every point of the diagram.
async function points(page) {
  const text = (await saved(page, '.map-card', 'csv')).bytes.toString('utf8');
  return text
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(','))
    .map((cells) => [Number(cells[0]), cells[2]]);
}

test('a zoom fills its range with finer points, which stay', async () => {
  const { page, complaints, close } = await openSmall('#at=3.6');
  await zoomIn(page);
  const [low, high] = await view(page);
  await done(page);
  const inside = (await points(page)).filter(([value]) => value >= low && value <= high);
  assert.ok(inside.length >= 64 && inside.length <= 160, `${inside.length} points in view`);
  const gaps = inside.slice(1).map(([value], i) => value - inside[i][0]);
  assert.ok(Math.max(...gaps) < 1.01 * ((high - low) / 32), `a gap of ${Math.max(...gaps)} in ${high - low}`);
  assert.ok(Math.max(...gaps) < 0.05, 'finer than the stored run');
  // The finer points have the verdicts of the command at their values.
  const some = inside.filter((_, i) => i % 15 === 7);
  for (const [value, verdict] of some) {
    writeFileSync(
      join(folder, 'fine.yaml'),
      CASE.replace(/from: 1.0, to: 4.0, points: 61/, `from: ${value}, to: 4.0, points: 2`).replace(
        /\n  detail:.*\n/,
        '\n',
      ),
    );
    assert.equal(
      verdict,
      JSON.parse(command('run', 'fine.yaml', '--json=full', '-q')).points[0].verdict,
      `at ${value}`,
    );
  }
  // The finer points stay after undo, and are not computed again after another zoom.
  const count = await finer(page);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(
    (before) => Number(document.querySelector('.map-main .overlay').getAttribute('aria-valuemax')) > before,
    high + 0.1,
  );
  assert.equal(await finer(page), count);
  await page.keyboard.press('Control+Shift+z');
  await page.waitForFunction(
    (before) => Number(document.querySelector('.map-main .overlay').getAttribute('aria-valuemax')) < before,
    high + 0.05,
  );
  await page.waitForTimeout(800);
  assert.equal(await finer(page), count);
  assert.ok(await page.$eval('.map-card progress', (bar) => bar.hidden));
  assert.deepEqual(complaints, []);
  await close();
});

test('coarse to fine, and another zoom overtakes', async () => {
  const { page, complaints, close } = await openSmall('#at=2');
  await page.selectOption('select[aria-label="Points of a new diagram"]', '1024');
  await page.focus('.map-main .overlay');
  await zoomIn(page);
  const [low, high] = await view(page);
  await page.waitForFunction(() =>
    /[1-9]\d* finer points were computed here, /.test(document.querySelector('.map-card .status').textContent),
  );
  assert.ok(!(await page.isDisabled('button:text-is("Recompute")')), 'Recompute is enabled while points are computed');
  const first = (await points(page)).map(([value]) => value);
  for (let part = 0; part < 4; part++) {
    const [from, to] = [low + ((high - low) * part) / 4, low + ((high - low) * (part + 1)) / 4];
    assert.ok(
      first.some((value) => value >= from && value <= to),
      `a first point in quarter ${part + 1}`,
    );
  }
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await page.focus('.map-main .overlay');
  await page.keyboard.press('End');
  await zoomIn(page);
  // Points of the first zoom that were only computed as previews stay undetermined.
  await page.waitForFunction(
    () =>
      document.querySelector('.map-card progress').hidden &&
      /finer points were computed here(\.|, \d+ undetermined: they)/.test(
        document.querySelector('.map-card .status').textContent,
      ),
    undefined,
    { timeout: 120_000 },
  );
  assert.ok((await finer(page)) < 1100, 'the first zoom did not run to its end');
  assert.deepEqual(complaints, []);
  await close();
});

test('an address that names a range is refined', async () => {
  const { page, complaints, close } = await open(`${address}#at=2&range=1.8,2.2`);
  await settled(page);
  await done(page);
  assert.ok((await finer(page)) >= 256, await status(page));
  assert.deepEqual(complaints, []);
  await close();
});
