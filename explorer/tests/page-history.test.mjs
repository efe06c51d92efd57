// Tests undo, redo and the browser's Back and Forward.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { brush, CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('history', CASE);
});
after(closeBrowser);

const hashHas = (page, text) => page.waitForFunction((part) => decodeURIComponent(location.hash).includes(part), text);
const hashLacks = (page, text) =>
  page.waitForFunction((part) => !decodeURIComponent(location.hash).includes(part), text);
const set = async (page, name, value) => {
  await page.fill(`#parameter-${name}`, String(value));
  await page.press(`#parameter-${name}`, 'Enter');
  await hashHas(page, `${name}=${value}`);
};
const field = async (page, id, value) => {
  await page.waitForFunction(
    ([name, wanted]) => Math.abs(Number(document.getElementById(name).value) - wanted) < 1e-6,
    [id, value],
  );
};

test('Ctrl+Z takes back, Ctrl+Shift+Z and Ctrl+Y do again', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  const first = await settled(page);
  await hashHas(page, 'units=');
  const reason = await page.textContent('.pane-a .reason');
  const began = await page.evaluate(() => history.length);
  await page.keyboard.press('Control+z'); // there is nothing to undo
  await set(page, 'mu', 0.2);
  await set(page, 'e', 0.8);
  await page.selectOption('select[aria-label="What the diagram shows"]', 'radius');
  await hashHas(page, 'q=radius');
  assert.equal(await page.evaluate(() => history.length), began + 3, 'three entries');
  await page.keyboard.press('Control+z');
  await hashHas(page, 'q=x');
  assert.equal(await page.inputValue('select[aria-label="What the diagram shows"]'), 'x');
  await page.focus('#parameter-e');
  await page.keyboard.press('Control+z');
  await field(page, 'parameter-e', 0.9);
  await page.keyboard.press('Control+z');
  await field(page, 'parameter-mu', 0.05);
  await settled(page);
  assert.equal(await page.textContent('.pane-a .verdict'), first);
  assert.equal(await page.textContent('.pane-a .reason'), reason);
  await page.keyboard.press('Control+z'); // there is nothing more to undo
  assert.match(page.url(), /^file:/);
  await page.keyboard.press('Control+Shift+z');
  await field(page, 'parameter-mu', 0.2);
  await page.keyboard.press('Control+y');
  await field(page, 'parameter-e', 0.8);
  // A new change removes the entries that redo could restore.
  await hashHas(page, 'e=0.8');
  await set(page, 'kappa', 12);
  await page.keyboard.press('Control+y');
  await page.waitForTimeout(400);
  assert.equal(await page.inputValue('select[aria-label="What the diagram shows"]'), 'x');
  assert.deepEqual(complaints, []);
  await close();
});

test('a drag is one step, and Back and Forward of the browser go by steps', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  await hashHas(page, 'units=');
  const began = await page.evaluate(() => history.length);
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  await page.mouse.move(box.x + box.width * 0.3, box.y + 50);
  await page.mouse.down();
  for (let i = 0; i < 4; i++) {
    await page.mouse.move(box.x + box.width * (0.3 + 0.05 * i), box.y + 60, { steps: 3 });
    await page.waitForTimeout(400); // longer than the delay before the address is written
  }
  await page.mouse.up();
  await hashLacks(page, 'at=3.8');
  const dragged = await page.inputValue('#value-a');
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight'); // the diagram has the focus
  const moved = Number(dragged) + (5 * 3) / 200; // five steps, each 1/200 of the range of 3
  await page.waitForFunction(
    (value) => Math.abs(Number(new URLSearchParams(location.hash.slice(1)).get('at')) - value) < 1e-3,
    moved,
  );
  assert.equal(
    await page.evaluate(() => history.length),
    began + 2,
    'a drag and five strokes of a key are two entries',
  );
  await page.goBack();
  await field(page, 'value-a', Number(dragged));
  await page.goBack();
  await field(page, 'value-a', 3.8);
  await page.goForward();
  await field(page, 'value-a', Number(dragged));
  assert.deepEqual(complaints, []);
  await close();
});

test('the way back knows diagrams, comparisons and parameters of the diagram', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  await hashHas(page, 'units=');
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  await page.selectOption('select[aria-label="How well a new diagram is computed"]', 'draft');
  await brush(page, 0.7, 0.8);
  await page.waitForFunction(() =>
    /Computed here, draft: 64 points/.test(document.querySelector('.status').textContent),
  );
  await hashHas(page, 'range=');
  await page.click('button[title="Compare two settings side by side"]');
  await settled(page, 'b');
  await hashHas(page, 'b=');
  await page.selectOption('select[aria-label="Parameter along the diagram"]', 'e');
  await hashHas(page, 'par=e');
  await page.keyboard.press('Control+z');
  await hashHas(page, 'par=omega');
  await page.keyboard.press('Control+z');
  await page.waitForSelector('.pane-b', { state: 'hidden' });
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => /Stored run/.test(document.querySelector('.status').textContent));
  await hashLacks(page, 'range=');
  assert.deepEqual(complaints, []);
  await close();
});
