// Tests diagrams that the page computes: coarse to fine, and without a verdict that a longer run would change.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { build } from 'esbuild';
import { CASE, closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

/// A case with longer motions and finer steps than a preview.
const LONG = CASE.replace('points: 61', 'points: 64').replace(
  'steps_per_revolution: 256, transient: 300',
  'steps_per_revolution: 512, transient: 600',
);

let address;
before(() => {
  address = makePage('long', LONG);
});
after(closeBrowser);

/// Returns the points of a case, computed by the kernels of 128 bits, which give the bits of the page.
function pointsOf(file) {
  process.env.WHIRL_ISA = 'simd128';
  try {
    return JSON.parse(command('run', file, '--json=full', '-q')).points;
  } finally {
    delete process.env.WHIRL_ISA;
  }
}

/// Records, in every frame after the click, the text of the diagram's card and whether dots are drawn.
async function watchFrames(page) {
  await page.evaluate(() => {
    const canvas = document.querySelector('.map-main canvas');
    const undetermined = parseInt(
      getComputedStyle(document.documentElement).getPropertyValue('--class-6').trim().slice(1),
      16,
    );
    const copy = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const dots = () => {
      [copy.canvas.width, copy.canvas.height] = [canvas.width, canvas.height];
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(canvas.width * 0.2, 0, canvas.width * 0.6, canvas.height * 0.8);
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      return seen.has(undetermined);
    };
    window.frames = [];
    let began;
    const note = () => {
      const counts = Object.fromEntries(
        [...document.querySelectorAll('.legend-entry')].map((entry) => [
          entry.firstChild.textContent.trim(),
          Number(entry.querySelector('.count').textContent),
        ]),
      );
      window.frames.push({
        time: performance.now() - began,
        status: document.querySelector('.status').textContent,
        empty: document.querySelector('.map .empty').textContent,
        counts,
        dots: window.frames.some((frame) => frame.dots) || dots(),
      });
      requestAnimationFrame(note);
    };
    document.querySelector('.map-card button.primary').addEventListener(
      'click',
      () => {
        began = performance.now();
        note();
      },
      { once: true },
    );
  });
}

test('Recompute paints few points at once, then more; no verdict before the length of the case', async (context) => {
  const { page, complaints, close } = await open(address, { colorScheme: 'light' });
  await settled(page);
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await watchFrames(page);
  await page.click('button:text-is("Recompute")');
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, {
    timeout: 120_000,
  });
  const frames = (await page.evaluate(() => window.frames)).filter(({ status }) =>
    /Computed here, quick: 64 points/.test(status),
  );
  assert.ok(
    frames.every(({ empty }) => empty === ''),
    'never is a quantity said to be missing',
  );
  const early = frames.filter(({ status }) => /first glimpse|undetermined until/.test(status));
  assert.ok(early.length > 0);
  for (const { counts } of early)
    assert.deepEqual(
      Object.keys(counts).filter((name) => name !== 'undetermined'),
      [],
    );
  const first = frames.find(({ dots }) => dots);
  context.diagnostic(
    `first points on the screen ${first.time.toFixed(0)} ms after the click, ${frames.indexOf(first)} frames`,
  );
  assert.ok(first.counts.undetermined <= 32, `the first picture has ${first.counts.undetermined} points`);
  const total = Object.values(frames.at(-1).counts).reduce((sum, count) => sum + count, 0);
  assert.equal(total, 64);
  // The final diagram has the numbers of the command.
  const mine = (await saved(page, '.map-card', 'csv')).bytes
    .toString('utf8')
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(',')[2]);
  const points = pointsOf('long.yaml');
  assert.deepEqual(
    mine,
    points.map(({ verdict }) => verdict),
  );
  assert.deepEqual(complaints, []);
  await close();
});

test('points that follow one another end with the verdicts of the case, there and back', async () => {
  const carried = makePage(
    'carried',
    LONG.replace('points: 64, start: state', 'points: 64, start: carry, direction: both').replace(
      'transient: 600, record: 100',
      'transient: 150, record: 60',
    ),
  );
  const { page, complaints, close } = await open(carried);
  await settled(page);
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await page.click('button:text-is("Recompute")');
  await page.waitForFunction(
    () =>
      /Computed here, quick: 128 points/.test(document.querySelector('.status').textContent) &&
      document.querySelector('.map-card progress').hidden,
    undefined,
    { timeout: 120_000 },
  );
  const mine = (await saved(page, '.map-card', 'csv')).bytes
    .toString('utf8')
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(','));
  const points = pointsOf('carried.yaml');
  assert.equal(mine.length, points.length);
  const reported = points.map(({ parameters, verdict }) => `${parameters.omega.toPrecision(6)} ${verdict}`).sort();
  assert.deepEqual(mine.map(([omega, , verdict]) => `${Number(omega).toPrecision(6)} ${verdict}`).sort(), reported);
  assert.deepEqual(complaints, []);
  await close();
});

test('a draft has no verdicts, and says so', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await page.selectOption('select[aria-label="How well a new diagram is computed"]', 'draft');
  await page.click('button:text-is("Recompute")');
  await page.waitForFunction(
    () => /64 undetermined: they have not run at full length/.test(document.querySelector('.status').textContent),
    undefined,
    { timeout: 60_000 },
  );
  assert.deepEqual(await page.$$eval('.legend-entry', (all) => all.map((entry) => entry.textContent.trim())), [
    'undetermined 64',
  ]);
  assert.deepEqual(complaints, []);
  await close();
});

test('a dragged cursor gives no verdict before it rests', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.4`);
  const verdict = await settled(page);
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  const at = (omega) => box.x + (box.width * (omega - 1)) / 3;
  await page.mouse.move(at(3.45), box.y + 80);
  await page.mouse.down();
  await page.mouse.move(at(3.4), box.y + 80, { steps: 3 });
  await page.waitForFunction(() => /quick look/.test(document.querySelector('.pane-a .how').textContent));
  assert.equal(await page.textContent('.pane-a .verdict'), 'undetermined');
  assert.match(await page.textContent('.pane-a .reason'), /first look of 60 \+ 40 revolutions.*takes the 600 \+ 100/);
  await page.mouse.up();
  assert.equal(await settled(page), verdict);
  assert.deepEqual(complaints, []);
  await close();
});

test('the weakest evidence goes first', async () => {
  const { outputFiles } = await build({
    entryPoints: [new URL('../src/model/recompute.ts', import.meta.url).pathname],
    bundle: true,
    format: 'esm',
    write: false,
  });
  const { doubtfulFirst } = await import(
    `data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`
  );
  const agreement = [2, 0, 1, 1, 2, NaN];
  const exponent = [-0.1, -0.2, 0.3, 0.5, 0, NaN];
  const diagram = {
    done: [1, 1, 1, 1, 1, 0],
    provisional: [1, 1, 1, 1, 0, 0],
    number: (point) => agreement[point],
    exponent: (point) => ({ value: exponent[point] }),
  };
  // Point 5 is not computed, point 4 has its final verdict.
  assert.deepEqual(doubtfulFirst(diagram, [0, 1, 2, 3, 4, 5]), [5, 1, 3, 2, 0]);
});
