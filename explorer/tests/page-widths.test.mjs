// Tests in the browser that nothing of report and explorer is cut off at the width of a desktop or a phone.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { closeBrowser, command, folder, open, settled, template } from './browser.mjs';

let address;
before(() => {
  // Take the case of `whirl new` with the most stations and columns; a shorter run has the same tables.
  command('new', 'rotor', '-o', 'wide.yaml');
  const text = readFileSync(join(folder, 'wide.yaml'), 'utf8');
  const short = text.replace(
    /integrate:.*/,
    'integrate: {method: rk4, steps_per_revolution: 256, transient: 40, record: 20}',
  );
  assert.notEqual(short, text);
  writeFileSync(join(folder, 'wide.yaml'), short);
  command('run', 'wide.yaml', '-q', '-o', 'wide.h5');
  command('report', 'wide.h5', '-q', '-o', 'wide', '--explorer', template);
  address = pathToFileURL(join(folder, 'wide', 'report.html')).href;
});
after(closeBrowser);

/// Returns the elements that are wider than the page, except those in a box that scrolls.
const overhang = (page) =>
  page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    const boxed = (element) => element.closest('.scroll, pre');
    const out = [...document.querySelectorAll('body *')].filter(
      (element) => !boxed(element) && element.checkVisibility() && element.getBoundingClientRect().right > width + 0.5,
    );
    return [document.documentElement.scrollWidth - width, out.map((element) => element.outerHTML.slice(0, 80))];
  });

/// Returns for each table the width that it needs, and the width of the box around it.
const tables = (page) =>
  page.$$eval('table', (all) =>
    all.map((table) => {
      const box = table.closest('.scroll');
      return {
        name: table.textContent.slice(0, 60),
        needs: box?.scrollWidth,
        has: box?.clientWidth,
        scrolls: box && ['auto', 'scroll'].includes(getComputedStyle(box).overflowX) && box.tabIndex === 0,
      };
    }),
  );

for (const width of [1280, 390])
  test(`no table or figure of the report is cut at ${width} px`, async () => {
    const { page, complaints, close } = await open(address, { viewport: { width, height: 844 } });
    assert.deepEqual(await overhang(page), [0, []]);
    const found = await tables(page);
    assert.ok(found.length >= 5, `${found.length} tables`);
    for (const { name, needs, has, scrolls } of found) {
      if (width === 1280) assert.ok(needs <= has, `${name}: ${needs} px in ${has}`);
      else assert.ok(needs <= has || scrolls, `${name}: ${needs} px in ${has}, and no way to the rest`);
    }
    const figures = await page.$$eval('figure img', (all) =>
      Promise.all(
        all.map(async (image) => {
          image.loading = 'eager';
          await image.decode();
          return (
            image.naturalWidth > 0 && image.getBoundingClientRect().width <= image.closest('figure').clientWidth + 0.5
          );
        }),
      ),
    );
    assert.ok(figures.length >= 4, `${figures.length} figures`);
    assert.ok(figures.every((whole) => whole));
    // The contents link to the points in detail, and the last cell of the last row can be scrolled into view.
    await page.click('nav a[href="#regimes-detail-1"]');
    const box = await page.evaluate(() => {
      const table = document.querySelector('#regimes-detail-1 ~ .scroll table, #regimes-detail-1 ~ div table');
      const top = document.querySelector('#regimes-detail-1').getBoundingClientRect().top;
      const last = table.rows[table.rows.length - 1].lastElementChild;
      last.scrollIntoView({ block: 'center', inline: 'end' });
      const { left, right, width: size } = last.getBoundingClientRect();
      return { top, left, right, size, page: document.documentElement.clientWidth };
    });
    assert.ok(box.top >= -1 && box.top < 844, `the heading stands at ${box.top}`);
    assert.ok(box.right <= box.page + 0.5 && (box.left >= 0 || box.size > box.page), JSON.stringify(box));
    assert.deepEqual(complaints, []);
    await close();
  });

for (const width of [1280, 390])
  test(`nothing of the explorer is cut at ${width} px`, async () => {
    const { page, complaints, close } = await open(address.replace('report', 'explorer'), {
      viewport: { width, height: 844 },
    });
    await settled(page);
    const [beyond] = await overhang(page);
    assert.equal(beyond, 0);
    const cut = await page.$$eval('.panel, .map-card, .settings-card, .topbar, canvas', (all) =>
      all
        .filter((each) => each.checkVisibility())
        .filter((each) => {
          const { left, right } = each.getBoundingClientRect();
          return left < -0.5 || right > document.documentElement.clientWidth + 0.5;
        })
        .map((each) => each.className),
    );
    assert.deepEqual(cut, []);
    assert.deepEqual(complaints, []);
    await close();
  });
