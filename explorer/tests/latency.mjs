// Measures how long the user waits:  WHIRL=... TEMPLATE=... node tests/latency.mjs PAGE.html
//
// It prints milliseconds in Chromium and Firefox, for a page opened from disk: until the stored diagram is drawn; from
// the move of a slider until the pictures of the new value are drawn; until a new diagram shows its first points. For
// each it prints the median and the largest of all tries, up to the end of the frame in which the picture is drawn.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const address = pathToFileURL(resolve(process.argv[2])).href;
const TRIES = 15;
const viewport = { width: 1280, height: 860 };

/// In the page: returns the time from an action (`deed`) to the end of the frame in which `done` returns true.
function timed(deed, done) {
  return new Promise((answer) => {
    const began = performance.now();
    const look = () => (done() ? setTimeout(() => answer(performance.now() - began)) : requestAnimationFrame(look));
    deed();
    requestAnimationFrame(look);
  });
}

/// In the page: moves a slider to a share of its range and waits for pictures of that value.
async function slide(label, share) {
  const slider = document.querySelector(`input[aria-label="${label}"]`);
  const orbit = document.querySelector('.pane-a .panel-orbit canvas');
  const text = () => document.querySelector('.pane-a .how').textContent;
  const before = text();
  const picture = orbit.toDataURL();
  const move = () => {
    slider.value = String(Math.round(Number(slider.max) * share));
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  };
  return window.timed(move, () => text() !== before && /revolutions by/.test(text()) && orbit.toDataURL() !== picture);
}

/// In the page: requests a new diagram and waits for its first points.
async function recompute() {
  const canvas = document.querySelector('.map-main canvas');
  const before = canvas.toDataURL();
  const press = () =>
    [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Recompute').click();
  return window.timed(press, () => canvas.toDataURL() !== before);
}

const settled = (page) =>
  page.waitForFunction(
    () => {
      const pane = document.querySelector('.pane-a');
      const how = pane?.querySelector('.how').textContent;
      return pane && !pane.classList.contains('busy') && /revolutions by/.test(how) && !/quick look/.test(how);
    },
    { timeout: 120_000 },
  );

const summary = (times) => {
  const sorted = [...times].sort((a, b) => a - b);
  return `median ${sorted[sorted.length >> 1].toFixed(0)} ms, worst ${sorted.at(-1).toFixed(0)} ms of ${times.length}`;
};

async function measure(name, options) {
  const browser = await puppeteer.launch({ headless: true, ...options });
  const page = await browser.newPage();
  await page.setViewport(viewport);
  const opened = [];
  for (let i = 0; i < 5; i++) {
    await page.goto('about:blank');
    await page.goto(address);
    await page.waitForFunction(() => /Stored run/.test(document.querySelector('.status')?.textContent ?? ''));
    opened.push(
      await page.evaluate(
        () => new Promise((done) => requestAnimationFrame(() => setTimeout(() => done(performance.now())))),
      ),
    );
  }
  console.log(`${name}: the stored diagram stands after ${summary(opened)}`);
  await settled(page);
  await page.evaluate(`window.timed = ${timed}`);
  // Move the sliders of the parameter along the diagram and of the next parameter.
  const labels = await page.$$eval('input[aria-label$=", slider"]', (all) =>
    all.slice(0, 2).map((slider) => slider.getAttribute('aria-label')),
  );
  for (const label of labels) {
    const slid = [];
    for (let i = 0; i < TRIES; i++) {
      slid.push(await page.evaluate(slide, label, 0.3 + 0.02 * i));
      // Release the slider; the whole motion replaces the preview.
      await page.$eval(`input[aria-label="${label}"]`, (slider) =>
        slider.dispatchEvent(new Event('change', { bubbles: true })),
      );
      await settled(page);
    }
    console.log(`${name}: pictures after the ${label} moved: ${summary(slid)}`);
  }
  await page.$eval(`input[aria-label="${labels[1]}"]`, (slider) =>
    slider.dispatchEvent(new Event('change', { bubbles: true })),
  );
  await settled(page);
  const anew = [];
  for (let i = 0; i < 5; i++) {
    anew.push(await page.evaluate(recompute));
    await page.keyboard.press('Escape');
    await new Promise((done) => setTimeout(done, 1500));
  }
  console.log(`${name}: first points of a new diagram after ${summary(anew)}`);
  await browser.close();
}

await measure('Chromium', {
  browser: 'chrome',
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
await measure('Firefox', { browser: 'firefox', executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr' });
