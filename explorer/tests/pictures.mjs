// Makes pictures of every view for inspection:  WHIRL=... TEMPLATE=... node tests/pictures.mjs PAGE.html OUT
//
// PAGE.html is an explorer of the paper's case, or of modes and the response to unbalance of the gallery's overhung
// rotor. The pictures are written to OUT as PNG at three widths, in the light and the dark theme.
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { brush, closeBrowser, open, settled } from './browser.mjs';

const [file, out] = process.argv.slice(2);
const address = pathToFileURL(resolve(file)).href;
const SIZES = [
  [360, 780],
  [1280, 860],
  [2560, 1440],
];

const LINEAR = /-linear\.html$/.test(address);

async function picture(name, hash, [width, height], colorScheme, act = async () => {}, whole = false) {
  const { page, complaints, close } = await open(address + hash, { viewport: { width, height }, colorScheme });
  if (LINEAR) await page.waitForSelector('.rest .numbers tbody td');
  else await settled(page);
  await act(page);
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(out, `${name}-${width}-${colorScheme}.png`), fullPage: whole });
  if (complaints.length) console.log(name, complaints);
  await close();
}

const watch = async (page) => {
  await page.selectOption('select[aria-label="Speed of the animation"]', '16');
  await page.click('.pane-a .play');
  await page.waitForTimeout(4000);
};
const brushed = async (page) => {
  await brush(page, 0.33, 0.46);
  await page.waitForSelector('.map-card progress:not([hidden])');
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, {
    timeout: 300_000,
  });
};

async function motions() {
  for (const scheme of ['light', 'dark'])
    for (const size of SIZES) await picture('page', '#at=0.35', size, scheme, undefined, size[0] === 360);
  for (const size of SIZES)
    await picture(
      'compare',
      '#at=0.46&b=0.25&q=radius&st=journal',
      size,
      size[0] === 1280 ? 'light' : 'dark',
      undefined,
      size[0] === 360,
    );
  await picture('help', '#at=0.35', SIZES[1], 'light', (page) => page.click('button[aria-label="Help"]'));
  await picture('watch', '#at=0.35', SIZES[1], 'dark', watch);
  await picture('range', '#at=0.44&q=y&st=journal', SIZES[1], 'light', brushed);
}

async function linear() {
  for (const scheme of ['light', 'dark'])
    for (const size of SIZES)
      for (const [name, hash] of [
        ['campbell', '#run=overhung-rotor-modes&at=497.4'],
        ['bode', '#run=overhung-rotor-unbalance&st=disc&at=429.4'],
      ])
        await picture(name, hash, size, scheme, undefined, size[0] === 360);
}

await (LINEAR ? linear() : motions());
await closeBrowser();
