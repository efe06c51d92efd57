// Tests parameters that follow from others: they are locked, can be set by hand, and can be reset to their expression.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

/// A case with derived parameters that is the machine of CASE at 3.8 rad/s and mu = 0.05.
const DERIVED = CASE.replace(/kappa: +10 /, 'kappa:     = 200*mu ')
  .replace(/(mu: .*\n)/, '$1  g:         = omega/7.6            # gravity\n')
  .replace('gravity: 0.5 m/s2', 'gravity: = g')
  .replace('points: 61', 'points: 7');

let derived;
before(() => {
  derived = makePage('derived', DERIVED);
});
after(closeBrowser);

const shows = (page, name, value) =>
  page.waitForFunction(
    ([field, wanted]) => Math.abs(Number(document.getElementById(field).value) - wanted) < 1e-9,
    [`parameter-${name}`, value],
  );
const readOnly = (page, name) => page.$eval(`#parameter-${name}`, (field) => field.readOnly);
const hash = (page) => page.evaluate(() => decodeURIComponent(location.hash));
async function type(page, field, text) {
  await page.fill(field, text);
  await page.press(field, 'Enter');
}

test('a derived parameter follows until one asks to set it, and again when that is taken back', async () => {
  const { page, complaints, close } = await open(`${derived}#at=3.8`);
  await settled(page);
  const row = '.parameter:has(#parameter-kappa)';
  assert.equal(await page.textContent(`${row} .expression`), '= 200*mu');
  assert.ok(await readOnly(page, 'kappa'));
  assert.ok(await page.isHidden(`${row} input[type="range"]`));
  await shows(page, 'kappa', 10);
  await type(page, '#parameter-mu', '0.06');
  await shows(page, 'kappa', 12);
  await shows(page, 'g', 0.5);
  await type(page, '#value-a', '1.9');
  await shows(page, 'g', 0.25); // follows from the value along the diagram
  await settled(page);
  assert.doesNotMatch(await hash(page), /kappa|g=/);
  await page.click('button[aria-label="Set kappa by hand"]');
  await page.waitForFunction(() => decodeURIComponent(location.hash).includes('kappa=12'));
  assert.ok(!(await readOnly(page, 'kappa')));
  assert.ok(await page.isVisible(`${row} input[type="range"]`));
  assert.ok(await page.isHidden(`${row} .expression`));
  assert.equal(await page.evaluate(() => document.activeElement.id), 'parameter-kappa');
  await type(page, '#parameter-mu', '0.05');
  await type(page, '#parameter-kappa', '8');
  await page.waitForFunction(() => decodeURIComponent(location.hash).includes('kappa=8'));
  await settled(page);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await shows(page, 'kappa', 10);
  assert.ok(await readOnly(page, 'kappa'));
  await page.waitForFunction(() => !location.hash.includes('kappa'));
  // A parameter that follows from others stays an expression in the saved case.
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  assert.match(readFileSync(await file.path(), 'utf8'), /kappa: +(=|'=) 200\*mu/);
  // The parameter along the diagram has the value of the cursor, so it is not locked.
  await page.selectOption('select[aria-label="Parameter along the diagram"]', 'kappa');
  await page.waitForFunction(() => !document.querySelector('#parameter-kappa').readOnly);
  assert.deepEqual(complaints, []);
  await close();
});
