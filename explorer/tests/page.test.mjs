// Tests the explorer in a real Chromium, opened from disk.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('rub', CASE);
});
after(closeBrowser);

/// Returns the number of opaque colours in the first canvas of an element.
const coloursIn = (page, selector) =>
  page.$eval(`${selector} canvas`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 200) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  });

test('it opens from disk without a complaint and without a request', async () => {
  const { page, complaints, close } = await open(address);
  assert.match(await settled(page), /\S/);
  assert.equal(await page.textContent('h1'), 'Jeffcott rotor with rub');
  assert.equal(await page.title(), 'Jeffcott rotor with rub \u00b7 whirl');
  assert.match(await page.textContent('.status'), /Stored run: 61 points, 300 \+ 100 revolutions by rk4 of 256 steps/);
  assert.ok((await coloursIn(page, '.map-main')) > 3, 'the diagram is drawn');
  assert.deepEqual(complaints, []);
  await close();
});

test('a click gives the motion at exactly that value, with the verdict of whirl run', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  const began = Date.now();
  await page.mouse.click(box.x + box.width * 0.4, box.y + box.height / 2);
  const verdict = await settled(page);
  const seconds = (Date.now() - began) / 1000;
  const shown = Number(await page.inputValue('#value-a'));
  assert.ok(Math.abs(shown - (1 + 0.4 * 3)) < 0.02, `the value under the cursor is ${shown}`);
  assert.ok(seconds < 30, `${seconds} s`);
  const exact = await page
    .waitForFunction((near) => {
      const at = new URLSearchParams(location.hash.slice(1)).get('at');
      return Math.abs(Number(at) - near) < 1e-4 && at;
    }, shown)
    .then((handle) => handle.jsonValue());
  const text = CASE.replace(/from: 1.0, to: 4.0, points: 61/, `from: ${exact}, to: 4.0, points: 2`).replace(
    /\n  detail:.*\n/,
    '\n',
  );
  writeFileSync(join(folder, 'one.yaml'), text);
  const [point] = JSON.parse(command('run', 'one.yaml', '--json=full', '-q')).points;
  assert.equal(verdict, point.verdict);
  assert.match(point.reason, /exponent -?[\d.]+ \+- [\d.]+ per/);
  assert.match(await page.textContent('.pane-a .reason'), /exponent -?[\d.]+ \u00b1 [\d.]+ per/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the address holds the setting', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.3&set=mu%3D0.2&q=radius&units=scale,rad/s,Hz,p-p`);
  await settled(page);
  assert.equal(Number(await page.inputValue('#value-a')), 3.3);
  assert.equal(Number(await page.inputValue('#parameter-mu')), 0.2);
  assert.equal(await page.inputValue('select[aria-label="What the diagram shows"]'), 'radius');
  assert.match(await page.textContent('.status'), /parameters have been changed/);
  await page.fill('#parameter-e', '0.8');
  await page.press('#parameter-e', 'Enter');
  await settled(page);
  await page.waitForFunction(() => location.hash.includes('e%3D0.8'));
  const again = await open(page.url());
  await settled(again.page);
  assert.equal(Number(await again.page.inputValue('#parameter-e')), 0.8);
  assert.equal(Number(await again.page.inputValue('#parameter-mu')), 0.2);
  assert.equal(await again.page.textContent('.pane-a .reason'), await page.textContent('.pane-a .reason'));
  assert.deepEqual([...complaints, ...again.complaints], []);
  await again.close();
  await close();
});

test('an address with nonsense does no harm', async () => {
  const { page, complaints, close } = await open(
    `${address}#run=%3Cscript%3E&at=NaN&set=mu&set=%3D3&set=nobody%3D1&q=%22&range=4,1&units=a,b` +
      '&method=%3Cb%3E&steps=-1&b=x',
  );
  await page.waitForSelector('.trouble:not(:empty)');
  assert.match(await page.textContent('.pane-a .trouble'), /nobody/);
  assert.deepEqual(complaints, []);
  await close();
});

test('keys move the cursor, zoom and give help', async () => {
  const { page, complaints, close } = await open(`${address}#at=2.5`);
  await settled(page);
  await page.focus('.map-main .overlay');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => Number(document.querySelector('#value-a').value) > 2.51);
  assert.ok(Math.abs(Number(await page.inputValue('#value-a')) - 2.515) < 1e-3);
  await page.keyboard.press('Home');
  await page.waitForFunction(() => Number(document.querySelector('#value-a').value) === 1);
  assert.equal(Number(await page.getAttribute('.map-main .overlay', 'aria-valuenow')), 1);
  await page.keyboard.press('+');
  await page.waitForFunction(
    () => Number(document.querySelector('.map-main .overlay').getAttribute('aria-valuemax')) < 3.9,
  );
  await page.keyboard.press('?');
  assert.ok(await page.isVisible('dialog.help'));
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('dialog.help')));
  assert.deepEqual(complaints, []);
  await close();
});

test('the orbit goes to the right with x and upwards with y', async () => {
  const { page, complaints, close } = await open(`${address}#at=1.5`);
  await settled(page);
  const svg = (await saved(page, '.pane-a .panel-orbit', 'svg')).bytes.toString('utf8');
  const csv = (await saved(page, '.pane-a .panel-orbit', 'csv')).bytes.toString('utf8');
  const rows = csv
    .trim()
    .split(/\r?\n/)
    .slice(1)
    .map((line) => line.split(',').map(Number));
  // The path with the most points is the orbit; its extremes are compared with those of as many last rows of the table.
  const paths = [...svg.matchAll(/ d="([^"]*)"/g)].map(([, d]) => [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)]);
  const drawn = paths.sort((a, b) => b.length - a.length)[0].map(([, x, y]) => [Number(x), Number(y)]);
  assert.ok(drawn.length > 50, `${drawn.length} points`);
  const extremes = (points, k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))];
  const last = rows.slice(-drawn.length);
  const [[left, right], [top, bottom]] = [extremes(drawn, 0), extremes(drawn, 1)];
  const at = ([, x, y]) => {
    const [[x0, x1], [y0, y1]] = [extremes(last, 1), extremes(last, 2)];
    return [left + ((x - x0) / (x1 - x0)) * (right - left), bottom - ((y - y0) / (y1 - y0)) * (bottom - top)];
  };
  // The path ends at the last sample, which is at the mark.
  const [x, y] = at(last.at(-1));
  assert.ok(Math.hypot(x - drawn.at(-1)[0], y - drawn.at(-1)[1]) < 0.02 * (right - left), `${[x, y]}, ${drawn.at(-1)}`);
  assert.deepEqual(complaints, []);
  await close();
});
