// Tests the page on a phone: controls are above figures and large enough for fingers, and nothing scrolls sideways.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, makePage, open, settled } from './browser.mjs';

const SMALL = CASE.replace('points: 61', 'points: 7');
const MAP = CASE.replace(
  / {2}sweep:.*/,
  '  map: {x: {parameter: omega, from: 1.5, to: 3.5, points: 5}, y: {parameter: e, from: 0.5, to: 1, points: 3}}',
).replace(/ {2}detail:.*/, '');
const REST = CASE.replace(/study:[^]*/, 'study:\n  modes: {parameter: omega, from: 1, to: 4, points: 7}\n').replace(
  / {4}- rub.*\n/,
  '',
);

const pages = {};
before(() => {
  pages.motions = `${makePage('phone', SMALL.replace(/kappa: +10/, 'kappa: = 200*mu'))}#at=3.8`;
  pages.comparison = `${pages.motions}&b=1.5`;
  pages.map = makePage('phone-map', MAP);
  pages.rest = makePage('phone-rest', REST);
});
after(closeBrowser);

async function opened(name, width) {
  const made = await open(pages[name], { viewport: { width, height: 844 }, hasTouch: true, isMobile: true });
  if (name === 'rest') await made.page.waitForSelector('.rest .numbers tbody td');
  else await settled(made.page);
  if (name !== 'rest') await made.page.click('.computation summary');
  return made;
}

const CONTROLS = 'button, select, input, summary';

/// Returns the visible controls that are smaller than 40 pixels.
const small = (page) =>
  page.$$eval(CONTROLS, (all) =>
    all
      .filter((each) => each.checkVisibility() && !each.closest('.unseen, dialog:not([open])'))
      .map((each) => [each.getBoundingClientRect(), each.outerHTML.slice(0, 100)])
      .filter(([{ width, height }]) => width < 40 || height < 40)
      .map(([{ width, height }, text]) => `${width} x ${height}: ${text}`),
  );

/// Returns the controls of cards that are below the figure of their card, except in legends and tables.
const behind = (page) =>
  page.$$eval(
    '.card',
    (cards, controls) =>
      cards.flatMap((card) => {
        const figure = card.querySelector('.figure');
        if (!figure?.checkVisibility()) return [];
        const { top } = figure.getBoundingClientRect();
        return [...card.querySelectorAll(controls)]
          .filter((each) => each.checkVisibility() && !each.closest('.legend, .numbers'))
          .filter((each) => each.getBoundingClientRect().top > top)
          .map((each) => each.outerHTML.slice(0, 100));
      }),
    CONTROLS,
  );

/// Opens every menu; returns the ranges of menus that extend beyond the page.
const cut = (page) =>
  page.$$eval('.menu', (all) =>
    all
      .filter((menu) => menu.checkVisibility())
      .flatMap((menu) => {
        menu.open = true;
        const { left, right } = menu.querySelector('.menu-items').getBoundingClientRect();
        menu.open = false;
        return left < 0 || right > document.documentElement.clientWidth ? [`${left} to ${right}`] : [];
      }),
  );

for (const name of ['motions', 'comparison', 'map', 'rest'])
  test(`${name} on a phone`, async () => {
    for (const width of name === 'motions' ? [360, 390, 480] : [390]) {
      const { page, complaints, close } = await opened(name, width);
      assert.deepEqual(await small(page), [], `${name} at ${width} px: targets`);
      assert.deepEqual(await behind(page), [], `${name} at ${width} px: controls behind figures`);
      assert.deepEqual(await cut(page), [], `${name} at ${width} px: menus`);
      if (name !== 'rest') {
        const [settings, ...figures] = await page.$$eval('.settings-card, .figure', (all) =>
          all.filter((each) => each.checkVisibility()).map((each) => each.getBoundingClientRect().top),
        );
        assert.ok(
          figures.length > 2 && figures.every((top) => top > settings),
          `parameters at ${settings}, ${figures}`,
        );
      }
      const sideways = await page.evaluate(() => [
        document.documentElement.scrollWidth,
        ...[...document.querySelectorAll('.card, .topbar')]
          .filter((card) => card.checkVisibility() && card.scrollWidth > card.clientWidth + 1)
          .map((card) => card.className),
      ]);
      assert.deepEqual(sideways, [width], `${name} at ${width} px: sideways`);
      assert.deepEqual(complaints, []);
      await close();
    }
  });
