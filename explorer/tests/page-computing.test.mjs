// Tests computations that the user of the explorer starts, in a real Chromium.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { brush, CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('rub', CASE);
});
after(closeBrowser);

test('a brushed range is computed anew, and Back returns', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await brush(page, 0.7, 0.8);
  await page.waitForFunction(() =>
    /Computed here, quick: 64 points/.test(document.querySelector('.status').textContent),
  );
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, {
    timeout: 120_000,
  });
  const counts = await page.$$eval('.legend-entry .count', (all) =>
    all.reduce((sum, each) => sum + Number(each.textContent), 0),
  );
  assert.equal(counts, 64, 'every point has a verdict');
  await page.click('button:text-is("Back")');
  await page.waitForFunction(() => /Stored run/.test(document.querySelector('.status').textContent));
  assert.deepEqual(complaints, []);
  await close();
});

test('computing a diagram can be cancelled', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.selectOption('select[aria-label="How well a new diagram is computed"]', 'case');
  await page.selectOption('select[aria-label="Points of a new diagram"]', '1024');
  await page.click('button:text-is("Recompute")');
  await page.waitForSelector('.map-card progress:not([hidden])');
  await page.click('button:text-is("Cancel")');
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, { timeout: 20_000 });
  assert.deepEqual(complaints, []);
  await close();
});

test('a bad value is refused with a sentence', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.fill('#parameter-kappa', '-3');
  await page.press('#parameter-kappa', 'Enter');
  await page.waitForSelector('.settings-card .trouble:not(:empty)');
  assert.match(await page.textContent('.settings-card .trouble'), /stiffness.*-3|kappa.*-3/);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await page.waitForSelector('.settings-card .trouble:empty', { state: 'attached' });
  assert.deepEqual(complaints, []);
  await close();
});

test('two settings side by side', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  const first = await settled(page);
  await page.click('button[title="Compare two settings side by side"]');
  await settled(page, 'b');
  assert.equal(await page.textContent('.settings-card h2'), 'Parameters of B');
  await page.fill('#value-b', '1.5');
  await page.press('#value-b', 'Enter');
  await page.waitForFunction((name) => document.querySelector('.pane-b .verdict').textContent !== name, first);
  await settled(page, 'b');
  assert.equal(await page.textContent('.pane-a .verdict'), first, 'A stays as it was');
  await page.click('.pane-b .close');
  await page.waitForSelector('.pane-b', { state: 'hidden' });
  assert.deepEqual(complaints, []);
  await close();
});

test('the rotor can be watched as it settles', async () => {
  const { page, complaints, close } = await open(`${address}#at=1.5`);
  await settled(page);
  const shot = () => page.$eval('.panel-orbit canvas', (canvas) => canvas.toDataURL());
  const still = await shot();
  await page.click('.pane-a .play');
  await page.waitForTimeout(1500);
  const moving = await shot();
  assert.notEqual(moving, still);
  await page.waitForTimeout(300);
  assert.notEqual(await shot(), moving);
  await page.click('.pane-a .play');
  await page.waitForTimeout(200);
  assert.equal(await shot(), still, 'the settled orbit is back');
  assert.deepEqual(complaints, []);
  await close();
});

test('units are switched everywhere', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  const field = () => page.inputValue('#value-a').then(Number);
  const inRadians = await field();
  await page.click('.topbar button[value="rpm"]');
  await page.waitForFunction((before) => Number(document.querySelector('#value-a').value) !== before, inRadians);
  assert.ok(Math.abs((await field()) - (inRadians * 30) / Math.PI) < 1e-2);
  await page.click('.topbar button[value="um"]');
  await page.waitForFunction(() => /\u00b5m/.test(document.querySelector('.panel-orbit .panel-note').textContent));
  for (const unit of ['mil', 'scale']) await page.click(`.topbar button[value="${unit}"]`);
  assert.match(await page.textContent('.panel-orbit .panel-note'), /p-p.*0-p/);
  assert.deepEqual(complaints, []);
  await close();
});
