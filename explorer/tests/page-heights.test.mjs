// Tests the vertical ranges (heights) of charts over a parameter: wheel, rectangle, keys and fingers enlarge them; the
// labels of the axis show the range.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, fan, makePage, open, saved, settled } from './browser.mjs';

const STUDY = 'unbalance: {parameter: omega, from: 100 rpm, to: 6100 rpm, points: 61}';
const FAN = fan('kxx: 50 MN/m, cxx: 2 kN s/m', 'kxx: 30 MN/m, cxx: 2 kN s/m', STUDY);
const CARD = '.rest .map-card:not([hidden])';

let rub, still;
before(() => {
  rub = makePage('rub', CASE.replace('points: 61', 'points: 13'));
  still = makePage('fan', FAN);
});
after(closeBrowser);

const frame = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/// Reads the ticks of the vertical axis of the upper or lower chart; returns a function from a distance in pixels below
/// the top of the plotting area to the value there.
async function axis(page, card, chart = 'main') {
  await frame(page);
  const svg = (await saved(page, card, 'svg')).bytes.toString('utf8');
  const ticks = await page.evaluate(
    ([text, lower]) =>
      [...new DOMParser().parseFromString(text, 'image/svg+xml').querySelectorAll('text[text-anchor="end"]')]
        .filter((label) => (label.closest('g[transform]') !== null) === lower)
        .map((label) => [Number(label.getAttribute('y')), Number(label.textContent.replace('\u2212', '-'))]),
    [svg, chart !== 'main'],
  );
  assert.ok(ticks.length > 1, `${ticks.length} labels`);
  const above = await page.$eval(`${card} .map-${chart}`, (figure) => {
    const plot = figure.querySelector('.overlay').getBoundingClientRect();
    return [plot.top - figure.getBoundingClientRect().top, plot.height];
  });
  const [[low, from], [high, to]] = [ticks[0], ticks.at(-1)];
  for (const [at] of ticks) assert.ok(at > above[0] - 1 && at < above[0] + above[1] + 1, 'a label beside the axis');
  return (top) => from + ((top + above[0] - low) * (to - from)) / (high - low);
}

const boxOf = async (page, card, chart = 'main') => (await page.$(`${card} .map-${chart} .overlay`)).boundingBox();
async function view(page, card) {
  await frame(page);
  return page.$eval(`${card} .map-main .overlay`, (slider) => [
    Number(slider.getAttribute('aria-valuemin')),
    Number(slider.getAttribute('aria-valuemax')),
  ]);
}

function near(found, expected, most, what) {
  assert.ok(Math.abs(found - expected) <= most, `${what}: ${found}, expected ${expected}`);
}

/// Returns the tolerance of a height: one pixel of the chart's whole vertical range.
const pixel = (at, { height }) => Math.abs(at(0) - at(height)) / height;

async function fanPage(options) {
  const made = await open(still, options);
  await made.page.waitForSelector('.rest .numbers tbody td');
  return made;
}

async function drag(page, box, from, to) {
  await page.mouse.move(box.x + from[0] * box.width, box.y + from[1] * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + to[0] * box.width, box.y + to[1] * box.height, { steps: 4 });
  await page.mouse.up();
}

test('the wheel over the axis, or with Shift, enlarges heights about the pointer', async () => {
  const card = '.map-card';
  const { page, complaints, close } = await open(`${rub}#at=2`);
  await settled(page);
  const range = await view(page, card);
  const [whole, below] = [await axis(page, card), await axis(page, card, 'exponent')];
  const box = await boxOf(page, card);
  const top = 0.25 * box.height;
  await page.mouse.move(box.x - 20, box.y + top);
  await page.mouse.wheel(0, -60); // the page is at its top and cannot scroll further up
  assert.equal((await axis(page, card))(0), whole(0), 'it waits until the diagram is in use');
  await page.focus(`${card} .map-main .overlay`);
  await page.mouse.move(box.x - 20, box.y + top);
  await page.mouse.wheel(0, -60);
  const once = await axis(page, card);
  near(once(top), whole(top), pixel(whole, box), 'the height under the pointer stays');
  near(once(0) - once(box.height), Math.exp(-0.2) * (whole(0) - whole(box.height)), pixel(whole, box), 'the heights');
  await page.focus(`${card} .map-main .overlay`);
  await page.mouse.move(box.x + 0.5 * box.width, box.y + top);
  await page.keyboard.down('Shift');
  await page.mouse.wheel(0, -60);
  await page.keyboard.up('Shift');
  const twice = await axis(page, card);
  near(twice(0) - twice(box.height), Math.exp(-0.4) * (whole(0) - whole(box.height)), pixel(whole, box), 'again');
  assert.deepEqual(await view(page, card), range, 'the parameter stays as it was');
  assert.equal((await axis(page, card, 'exponent'))(0), below(0), 'and so does the other picture');
  await page.mouse.dblclick(box.x + 0.5 * box.width, box.y + top);
  assert.equal((await axis(page, card))(0), whole(0), 'a double click shows all of them');
  // After another quantity is chosen, its whole vertical range is shown.
  await page.press(`${card} .map-main .overlay`, 'v');
  assert.ok((await axis(page, card))(0) < whole(0));
  await page.selectOption('select[aria-label="What the diagram shows"]', 'radius');
  const radius = await axis(page, card);
  await page.dblclick(`${card} .map-main .overlay`);
  assert.equal((await axis(page, card))(0), radius(0));
  assert.deepEqual(complaints, []);
  await close();
});

test('a drag encloses a rectangle, a range or heights alone; Back returns', async () => {
  const { page, complaints, close } = await fanPage();
  const box = await boxOf(page, CARD);
  const whole = await axis(page, CARD);
  await page.click(`${CARD} .segments button[value="range"]`);
  await drag(page, box, [0.25, 0.3], [0.25, 0.8]);
  const upright = await axis(page, CARD);
  near(upright(0), whole(0.3 * box.height), pixel(whole, box), 'the upper end');
  near(upright(box.height), whole(0.8 * box.height), pixel(whole, box), 'the lower end');
  assert.deepEqual(await view(page, CARD), [100, 6100]);
  await page.click(`${CARD} button:text-is("Reset")`);
  assert.equal((await axis(page, CARD))(0), whole(0));
  await drag(page, box, [0.25, 0.9], [0.5, 0.4]);
  const [low, high] = await view(page, CARD);
  near(low, 1600, 20, 'from the left');
  near(high, 3100, 20, 'to the right');
  const part = await axis(page, CARD);
  near(part(0), whole(0.4 * box.height), pixel(whole, box), 'the upper side');
  near(part(box.height), whole(0.9 * box.height), pixel(whole, box), 'the lower side');
  await page.click(`${CARD} button:text-is("Back")`);
  assert.equal((await axis(page, CARD))(0), whole(0));
  assert.deepEqual(await view(page, CARD), [100, 6100]);
  await drag(page, box, [0.25, 0.5], [0.5, 0.53]);
  near((await view(page, CARD))[1], 3100, 20, 'a level drag is a range');
  // Enlarge the lags, whose ticks are at multiples of 90 degrees as long as two of these are visible.
  const lower = await boxOf(page, CARD, 'exponent');
  const lags = await axis(page, CARD, 'exponent');
  await drag(page, lower, [0.5, 0.3], [0.5, 0.7]);
  near((await axis(page, CARD, 'exponent'))(0), lags(0.3 * lower.height), 2 * pixel(lags, lower), 'a lag');
  assert.deepEqual(complaints, []);
  await close();
});

test('keys and Pan enlarge and shift the vertical range', async () => {
  const { page, complaints, close } = await fanPage();
  const box = await boxOf(page, CARD);
  const whole = await axis(page, CARD);
  const span = whole(0) - whole(box.height);
  const press = (key) => page.press(`${CARD} .map-main .overlay`, key);
  await press('v');
  const once = await axis(page, CARD);
  near(once(0) - once(box.height), 0.7 * span, 2 * pixel(whole, box), 'V');
  await press('Alt+ArrowUp');
  near((await axis(page, CARD))(0) - once(0), 0.07 * span, 2 * pixel(whole, box), 'Alt and an arrow');
  await page.click(`${CARD} .segments button[value="pan"]`);
  await drag(page, box, [0.5, 0.3], [0.5, 0.2]);
  near((await axis(page, CARD))(0), once(0), 2 * pixel(whole, box), 'a drag');
  await press('Shift+V');
  assert.equal((await axis(page, CARD))(0), whole(0), 'no more than there is');
  assert.deepEqual(complaints, []);
  await close();
});

test('two fingers enlarge heights, and one encloses a rectangle', async () => {
  const { page, complaints, close } = await fanPage({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  });
  await page.$eval(`${CARD} .map-main`, (figure) => figure.scrollIntoView({ block: 'center' }));
  const box = await boxOf(page, CARD);
  const whole = await axis(page, CARD);
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    devtools.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x: box.x + x * box.width, y: box.y + y * box.height, id })),
    });
  const middle = box.height / 2;
  await touch('touchStart', [0.5, 0.4], [0.5, 0.6]);
  for (const apart of [0.2, 0.25, 0.3]) await touch('touchMove', [0.5, 0.5 - apart], [0.5, 0.5 + apart]);
  await touch('touchEnd');
  const pinched = await axis(page, CARD);
  near(pinched(middle), whole(middle), 3 * pixel(whole, box), 'between the fingers');
  near((pinched(0) - pinched(box.height)) / (whole(0) - whole(box.height)), 1 / 3, 0.03, 'the heights');
  assert.deepEqual(await view(page, CARD), [100, 6100]);
  await page.tap(`${CARD} button:text-is("Reset")`);
  await page.tap(`${CARD} .segments button[value="range"]`);
  await touch('touchStart', [0.25, 0.3]);
  for (const part of [0.5, 1]) await touch('touchMove', [0.25 + 0.25 * part, 0.3 + 0.4 * part]);
  await touch('touchEnd');
  const part = await axis(page, CARD);
  near(part(0), whole(0.3 * box.height), 3 * pixel(whole, box), 'the upper side');
  near(part(box.height), whole(0.7 * box.height), 3 * pixel(whole, box), 'the lower side');
  near((await view(page, CARD))[1], 3100, 60, 'to the right');
  assert.deepEqual(complaints, []);
  await close();
});
