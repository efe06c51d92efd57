// Tests the page in Firefox, driven over WebDriver BiDi: it opens, follows a drag, recomputes, saves, and undoes
// changes.
import assert from 'node:assert/strict';
import { readFileSync, existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import puppeteer from 'puppeteer-core';
import { CASE, command, folder, makePage } from './browser.mjs';

const program = process.env.FIREFOX;
const options = program ? {} : { skip: 'Firefox is missing (scripts/install-dependencies.sh browser)' };

let browser;
let page;
const complaints = [];
before(async () => {
  if (!program) return;
  const address = makePage('fire', CASE);
  const extraPrefsFirefox = {
    'browser.download.folderList': 2,
    'browser.download.dir': folder,
    'browser.download.always_ask_before_handling_new_types': false,
  };
  browser = await puppeteer.launch({ browser: 'firefox', executablePath: program, headless: true, extraPrefsFirefox });
  page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  page.on('console', (message) => ['error', 'warn'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(`${address}#at=2.5&units=scale,rad/s,order,0-p`);
});
after(() => browser?.close());

const wait = (test, ...words) => page.waitForFunction(test, { timeout: 60_000 }, ...words);
const textOf = (selector) => page.$eval(selector, (element) => element.textContent);

/// Waits for a whole computation at a value between two bounds; returns the verdict.
async function settled(low, high) {
  await wait(
    (from, to) => {
      const pane = document.querySelector('.pane-a');
      const how = pane?.querySelector('.how').textContent;
      const value = Number(document.querySelector('#value-a')?.value);
      return (
        pane &&
        !pane.classList.contains('busy') &&
        /revolutions by/.test(how) &&
        !/quick look/.test(how) &&
        value >= from &&
        value <= to
      );
    },
    low,
    high,
  );
  return textOf('.pane-a .verdict');
}

test('Firefox opens the page from disk and computes', options, async () => {
  assert.equal(await settled(2.5, 2.5), 'P-1');
  assert.match(await textOf('.status'), /Stored run: 61 points/);
  const colours = await page.$eval('.map-main canvas', (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 200) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  });
  assert.ok(colours > 3, 'the diagram is drawn');
});

test('Firefox follows a drag, and takes it back', options, async () => {
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  await page.mouse.move(box.x + box.width * 0.5, box.y + 60);
  await page.mouse.down();
  const seen = new Set();
  for (let i = 1; i <= 10; i++) {
    await page.mouse.move(box.x + box.width * (0.5 + 0.04 * i), box.y + 60);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    seen.add(await page.$eval('#value-a', (field) => field.value));
  }
  await page.mouse.up();
  assert.ok(seen.size >= 9, `the value follows: ${[...seen]}`);
  const verdict = await settled(3.6, 3.8);
  await wait(() => Number(new URLSearchParams(location.hash.slice(1)).get('at')) > 3.6);
  const at = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('at'));
  writeFileSync(
    join(folder, 'dragged.yaml'),
    CASE.replace(/from: 1.0, to: 4.0, points: 61/, `from: ${at}, to: 4.0, points: 2`).replace(/\n  detail:.*\n/, '\n'),
  );
  assert.equal(verdict, JSON.parse(command('run', 'dragged.yaml', '--json=full', '-q')).points[0].verdict);
  await page.keyboard.down('Control');
  await page.keyboard.press('z');
  await page.keyboard.up('Control');
  assert.equal(await settled(2.5, 2.5), 'P-1');
});

test('Firefox recomputes the diagram and saves it', options, async () => {
  await page.select('select[aria-label="Points of a new diagram"]', '64');
  await page.click('.map-card button.primary');
  await wait(() => /Computed here, quick: 64 points\./.test(document.querySelector('.status').textContent));
  await page.click('.map-card .menu summary');
  await page.click('.map-card [data-save="csv"]');
  const path = join(folder, 'whirl-fire-x-omega.csv');
  for (let i = 0; i < 100 && !(existsSync(path) && readFileSync(path).length > 0); i++)
    await new Promise((done) => setTimeout(done, 100));
  const lines = readFileSync(path, 'utf8').trim().split('\r\n');
  assert.equal(lines.length, 65);
  assert.ok(lines.every((line) => line.split(',').length === lines[0].split(',').length));
  assert.deepEqual(complaints, []);
});
