// Tests explorer and report with axe-core: names, roles, contrast, order of headings, in the light and the dark theme.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { axeFindings, CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

const MAP = CASE.replace(
  / {2}sweep:.*/,
  '  map: {x: {parameter: omega, from: 1.5, to: 3.5, points: 5}, y: {parameter: e, from: 0.5, to: 1, points: 3}}',
).replace(/ {2}detail:.*/, '');

let address, ofMap;
before(() => {
  address = makePage('access', CASE.replace('points: 61', 'points: 31'));
  ofMap = makePage('access-map', MAP);
});
after(closeBrowser);

for (const colorScheme of ['light', 'dark']) {
  test(`axe finds nothing on the explorer, ${colorScheme}`, async () => {
    const { page, close } = await open(`${address}#at=3.8&b=1.5`, { colorScheme });
    await settled(page);
    await settled(page, 'b');
    assert.deepEqual(await axeFindings(page), []);
    await page.click('button[aria-label="Close setting B"]');
    await page.click('.computation summary');
    await page.fill('#parameter-kappa', '-3');
    await page.press('#parameter-kappa', 'Enter');
    await page.waitForSelector('.settings-card .trouble:not(:empty)');
    await page.click('.map-card .menu summary');
    assert.deepEqual(await axeFindings(page), [], 'with a trouble and an open menu');
    await page.click('button[aria-label="Help"]');
    assert.deepEqual(await axeFindings(page), [], 'with the help');
    await close();
  });

  test(`axe finds nothing on a map, ${colorScheme}`, async () => {
    const { page, close } = await open(`${ofMap}#b=2`, { colorScheme });
    await settled(page);
    assert.deepEqual(await axeFindings(page), []);
    await page.selectOption('select[aria-label="What the map shows"]', 'exponent');
    assert.deepEqual(await axeFindings(page), [], 'with a bar of colours');
    await close();
  });

  test(`axe finds nothing on the report, ${colorScheme}`, async () => {
    const { page, close } = await open(address.replace('explorer.html', 'report.html'), { colorScheme });
    assert.deepEqual(await axeFindings(page), []);
    await close();
  });
}

test('axe finds nothing on the explorer on a phone', async () => {
  const { page, close } = await open(`${address}#at=3.8`, { viewport: { width: 360, height: 780 } });
  await settled(page);
  assert.deepEqual(await axeFindings(page), []);
  await close();
});
