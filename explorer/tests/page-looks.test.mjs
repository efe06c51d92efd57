// Tests the explorer with other themes and screens, and its protection against foreign content, in a real Chromium.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, makePage, open, saved, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('rub', CASE);
});
after(closeBrowser);

test('titles and names that look like markup stay text', async () => {
  const evil = '</script><script>alert(1)</script><img src=x onerror=alert(2)>';
  const text = CASE.replace(/title: .*/, `title: '${evil}'`)
    .replace('# friction coefficient', `# ${evil}`)
    .replace('points: 61', 'points: 5');
  const { page, complaints, close } = await open(makePage('hostile', text));
  await settled(page);
  assert.equal(await page.textContent('h1'), evil);
  assert.match(await page.textContent('#parameter-mu-meaning'), /<img src=x/);
  assert.equal(await page.$$eval('img', (all) => all.length), 0);
  const svg = (await saved(page, '.panel-orbit', 'svg')).bytes.toString('utf8');
  assert.ok(!/<(script|img)/.test(svg));
  assert.deepEqual(complaints, []);
  await close();
});

test('no other script runs and nothing reaches the network', async () => {
  const { page, close } = await open(address);
  await settled(page);
  const outcome = await page.evaluate(async () => {
    const script = document.createElement('script');
    script.textContent = 'window.intruder = true';
    document.head.append(script);
    const image = document.createElement('div');
    image.innerHTML = '<img src="x" onerror="window.intruder = true">';
    document.body.append(image);
    const fetched = await fetch('https://example.org/').then(
      () => true,
      () => false,
    );
    await new Promise((done) => setTimeout(done, 200));
    return { intruder: window.intruder === true, fetched };
  });
  assert.deepEqual(outcome, { intruder: false, fetched: false });
  await close();
});

test('a run of one point is shown at its own parameters', async () => {
  const text = CASE.replace(/  sweep:.*\n/, '  response: {}\n').replace(/  detail:.*\n/, '');
  const { page, complaints, close } = await open(makePage('point', text));
  const verdict = await settled(page);
  const [point] = JSON.parse(command('run', 'point.yaml', '--json=full', '-q')).points;
  assert.equal(verdict, point.verdict);
  assert.equal(Number(await page.inputValue('#value-a')), 3.8);
  await page.waitForFunction(() => document.querySelectorAll('.legend-entry').length > 0, undefined, {
    timeout: 60_000,
  });
  assert.deepEqual(complaints, []);
  await close();
});

test('light and dark', async () => {
  const background = (page) => page.$eval('.card', (card) => getComputedStyle(card).backgroundColor);
  const light = await open(address, { colorScheme: 'light' });
  await settled(light.page);
  const bright = await background(light.page);
  await light.page.click('button[aria-label="Light or dark"]');
  const toggled = await background(light.page);
  const dark = await open(address, { colorScheme: 'dark' });
  await settled(dark.page);
  assert.notEqual(bright, toggled);
  assert.equal(await background(dark.page), toggled);
  assert.deepEqual([...light.complaints, ...dark.complaints], []);
  await light.close();
  await dark.close();
});

test('nothing is wider than the screen, from a phone to 4K, and every control has a name', async () => {
  for (const width of [360, 768, 1280, 2560, 3840]) {
    const { page, complaints, close } = await open(`${address}#at=3.8&b=1.5`, { viewport: { width, height: 900 } });
    await settled(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `at ${width} px`);
    const spilled = await page.$$eval('.card', (cards) =>
      cards.filter((card) => card.scrollWidth > card.clientWidth + 1).map((card) => card.className),
    );
    assert.deepEqual(spilled, [], `at ${width} px`);
    const nameless = await page.$$eval('button, select, input, summary', (all) =>
      all
        .filter((each) => !(each.getAttribute('aria-label') || each.textContent.trim() || each.labels?.length))
        .map((each) => each.outerHTML.slice(0, 120)),
    );
    assert.deepEqual(nameless, []);
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('parameters, diagram and verdict are seen together at 1280 x 800', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`, { viewport: { width: 1280, height: 800 } });
  await settled(page);
  for (const part of [
    '.parameter',
    '.settings-card .keep button',
    '.pane-a .verdict',
    '.pane-a .reason',
    '.map-main canvas',
    '.map-card .primary',
  ]) {
    const boxes = await page.$$eval(part, (all) =>
      all.map((each) => each.getBoundingClientRect()).map(({ left, right, top, bottom }) => [left, right, top, bottom]),
    );
    assert.ok(boxes.length > 0, part);
    for (const [left, right, top, bottom] of boxes)
      assert.ok(left >= 0 && right <= 1280 && top >= 0 && bottom <= 800, `${part} is at ${[left, right, top, bottom]}`);
  }
  assert.deepEqual(complaints, []);
  await close();
});
