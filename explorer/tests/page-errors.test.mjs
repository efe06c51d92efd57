// Tests error messages of the page: they name the control, what was found and what is expected, not a place in a file.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage(
    'product',
    CASE.replace('eccentricity: = e', 'eccentricity: = e*zeta').replace('points: 61', 'points: 7'),
  );
});
after(closeBrowser);

async function type(page, field, text) {
  await page.fill(field, text);
  await page.press(field, 'Enter');
}

/// Waits for a message next to the parameters that begins with `starts`, checks that it names no place in a file, and
/// returns it.
async function problemOf(page, starts) {
  await page.waitForFunction(
    (start) => document.querySelector('.settings-card .trouble').textContent.startsWith(start),
    starts,
    { timeout: 10_000 },
  );
  const sentence = await page.textContent('.settings-card .trouble');
  assert.doesNotMatch(sentence, /\.yaml|\d:\d|rotor\.|study\.|parameters\./);
  assert.equal(await page.textContent('.pane-a .trouble'), sentence);
  return sentence;
}

test('an error names the control, what was found and what is expected', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  await type(page, '#parameter-kappa', '-3');
  assert.match(await problemOf(page, 'kappa: '), /^kappa: is -3 N\/m, expected a number of at least 0 N\/m$/);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await type(page, '#parameter-zeta', '-0.5');
  assert.match(
    await problemOf(page, 'zeta: '),
    /^zeta: \w.* = 2\*zeta is -1 N s\/m, expected a number of at least 0 N s\/m$/,
  );
  await page.click('button[aria-label="Reset zeta to the case"]');
  await type(page, '#parameter-e', '-2');
  assert.match(
    await problemOf(page, 'zeta, e: '),
    /^zeta, e: \w.* = e\*zeta is -0\.2 m, expected a number of at least 0 m$/,
  );
  await page.click('button[aria-label="Reset e to the case"]');
  await type(page, '#value-a', '-1');
  assert.match(await problemOf(page, 'omega: '), /^omega: is -1 rad\/s, expected a number above 0 rad\/s/);
  assert.deepEqual(complaints, []);
  await close();
});

test('so do errors of an address, and of a diagram', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8&set=kappa%3D-3`);
  const sentence = 'kappa: is -3 N/m, expected a number of at least 0 N/m';
  assert.equal(await problemOf(page, 'kappa: '), sentence);
  await page.click('button:text-is("Recompute")');
  await page.waitForTimeout(500);
  assert.equal(await problemOf(page, 'kappa: '), sentence);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await settled(page);
  await type(page, '#parameter-mu', 'few');
  assert.equal(await problemOf(page, 'mu: '), 'mu: few is not a number');
  assert.deepEqual(complaints, []);
  await close();
});
