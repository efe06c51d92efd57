// The explorer in a real Chromium, from disk.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { CASE, closeBrowser, command, folder, makePage, open, saved, settled } from './browser.mjs';

let address;
before(() => {
  address = makePage('rub', CASE);
});
after(closeBrowser);

/// Opaque colours in the first canvas of an element.
const coloursIn = (page, selector) =>
  page.$eval(`${selector} canvas`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 200) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  });

test('it opens from disk without a complaint and without a request', async () => {
  const { page, complaints, close } = await open(address);
  assert.match(await settled(page), /\S/);
  assert.equal(await page.textContent('h1'), 'Jeffcott rotor with rub');
  assert.equal(await page.title(), 'Jeffcott rotor with rub \u00b7 whirl');
  assert.match(await page.textContent('.status'), /Stored run: 61 points, 300 \+ 100 revolutions by rk4 of 256 steps/);
  assert.ok((await coloursIn(page, '.map-main')) > 3, 'the diagram is drawn');
  assert.deepEqual(complaints, []);
  await close();
});

test('a click gives the motion at exactly that value, with the verdict of whirl run', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  const began = Date.now();
  await page.mouse.click(box.x + box.width * 0.4, box.y + box.height / 2);
  const verdict = await settled(page);
  const seconds = (Date.now() - began) / 1000;
  const shown = Number(await page.inputValue('#value-a'));
  assert.ok(Math.abs(shown - (1 + 0.4 * 3)) < 0.02, `the value under the cursor is ${shown}`);
  assert.ok(seconds < 30, `${seconds} s`);
  const exact = await page
    .waitForFunction((near) => {
      const at = new URLSearchParams(location.hash.slice(1)).get('at');
      return Math.abs(Number(at) - near) < 1e-4 && at;
    }, shown)
    .then((handle) => handle.jsonValue());
  const text = CASE.replace(/from: 1.0, to: 4.0, points: 61/, `from: ${exact}, to: 4.0, points: 2`).replace(
    /\n  detail:.*\n/,
    '\n',
  );
  writeFileSync(join(folder, 'one.yaml'), text);
  const [point] = JSON.parse(command('run', 'one.yaml', '--json=full', '-q')).points;
  assert.equal(verdict, point.verdict);
  assert.match(point.reason, /exponent -?[\d.]+ \+- [\d.]+ per/);
  assert.match(await page.textContent('.pane-a .reason'), /exponent -?[\d.]+ \u00b1 [\d.]+ per/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the address holds the setting', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.3&set=mu%3D0.2&q=radius&units=scale,rad/s,Hz,p-p`);
  await settled(page);
  assert.equal(Number(await page.inputValue('#value-a')), 3.3);
  assert.equal(Number(await page.inputValue('#parameter-mu')), 0.2);
  assert.equal(await page.inputValue('select[aria-label="What the diagram shows"]'), 'radius');
  assert.match(await page.textContent('.status'), /parameters have been changed/);
  await page.fill('#parameter-e', '0.8');
  await page.press('#parameter-e', 'Enter');
  await settled(page);
  await page.waitForFunction(() => location.hash.includes('e%3D0.8'));
  const again = await open(page.url());
  await settled(again.page);
  assert.equal(Number(await again.page.inputValue('#parameter-e')), 0.8);
  assert.equal(Number(await again.page.inputValue('#parameter-mu')), 0.2);
  assert.equal(await again.page.textContent('.pane-a .reason'), await page.textContent('.pane-a .reason'));
  assert.deepEqual([...complaints, ...again.complaints], []);
  await again.close();
  await close();
});

test('an address with nonsense does no harm', async () => {
  const { page, complaints, close } = await open(
    `${address}#run=%3Cscript%3E&at=NaN&set=mu&set=%3D3&set=nobody%3D1&q=%22&range=4,1&units=a,b` +
      '&method=%3Cb%3E&steps=-1&b=x',
  );
  await page.waitForSelector('.trouble:not(:empty)');
  assert.match(await page.textContent('.pane-a .trouble'), /nobody/);
  assert.deepEqual(complaints, []);
  await close();
});

test('keys move the cursor, zoom and give help', async () => {
  const { page, complaints, close } = await open(`${address}#at=2.5`);
  await settled(page);
  await page.focus('.map-main .overlay');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => Number(document.querySelector('#value-a').value) > 2.51);
  assert.ok(Math.abs(Number(await page.inputValue('#value-a')) - 2.515) < 1e-3);
  await page.keyboard.press('Home');
  await page.waitForFunction(() => Number(document.querySelector('#value-a').value) === 1);
  assert.equal(Number(await page.getAttribute('.map-main .overlay', 'aria-valuenow')), 1);
  await page.keyboard.press('+');
  await page.waitForFunction(
    () => Number(document.querySelector('.map-main .overlay').getAttribute('aria-valuemax')) < 3.9,
  );
  await page.keyboard.press('?');
  assert.ok(await page.isVisible('dialog.help'));
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('dialog.help')));
  assert.deepEqual(complaints, []);
  await close();
});

test('pictures and data can be saved', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  for (const panel of [
    '.map-card',
    '.panel-orbit',
    '.panel-poincare',
    '.panel-waveform',
    '.panel-spectrum',
    '.panel-full-spectrum',
    '.panel-centreline',
  ]) {
    const png = await saved(page, panel, 'png');
    assert.match(png.name, /^whirl-.*\.png$/);
    assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(png.bytes.length > 3000, `${panel}: a picture of ${png.bytes.length} bytes`);
    const svg = (await saved(page, panel, 'svg')).bytes.toString('utf8');
    assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
    const errors = await page.evaluate(
      (text) => new DOMParser().parseFromString(text, 'image/svg+xml').querySelectorAll('parsererror').length,
      svg,
    );
    assert.equal(errors, 0, `${panel}: the SVG is well-formed`);
    const csv = (await saved(page, panel, 'csv')).bytes.toString('utf8').split('\r\n');
    const columns = csv[0].split(',').length;
    assert.ok(csv.length > 10 && columns > 1, `${panel}: ${csv.length} lines of ${columns} columns`);
    assert.ok(
      csv.slice(1, -1).every((line) => line.split(',').length === columns),
      `${panel}: columns`,
    );
  }
  assert.deepEqual(complaints, []);
  await close();
});

/// Boxes of the labels of peaks in an SVG, [left, right, top, bottom] of their letters, and the segments of its curves.
async function labelled(page, svg) {
  return page.evaluate((text) => {
    const drawing = document.body.appendChild(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement);
    const size = (label) => Number(label.getAttribute('font-size'));
    const labels = [...drawing.querySelectorAll('text')].filter((label) => /^[\d.]+X$/.test(label.textContent));
    const boxes = labels.map((label) => {
      const [middle, half] = [Number(label.getAttribute('x')), label.getComputedTextLength() / 2];
      const baseline = Number(label.getAttribute('y')) - 0.2 * size(label);
      return [middle - half, middle + half, baseline - 0.72 * size(label), baseline];
    });
    const segments = [];
    for (const path of drawing.querySelectorAll('path[stroke-linejoin="round"]'))
      for (const part of path.getAttribute('d').split('M').slice(1)) {
        const places = part.split('L').map((place) => place.split(' ').map(Number));
        for (let i = 1; i < places.length; i++) segments.push([...places[i - 1], ...places[i]]);
      }
    drawing.remove();
    return { boxes, segments };
  }, svg);
}

/// Whether a segment passes through a box (Liang and Barsky 1984).
function crosses([left, right, top, bottom], [x0, y0, x1, y1]) {
  let [from, to] = [0, 1];
  for (const [p, q] of [
    [x0 - x1, x0 - left],
    [x1 - x0, right - x0],
    [y0 - y1, y0 - top],
    [y1 - y0, bottom - y0],
  ]) {
    if (p === 0 && q < 0) return false;
    if (p < 0) from = Math.max(from, q / p);
    if (p > 0) to = Math.min(to, q / p);
  }
  return from < to;
}

test('labels of spectra lie neither on one another nor on the curves', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.3`);
  let count = 0;
  for (const value of [3.3, 3.4, 3.5, 3.7]) {
    await page.fill('#value-a', String(value));
    await page.press('#value-a', 'Enter');
    await settled(page);
    for (const logarithmic of [false, true])
      for (const panel of ['.panel-spectrum', '.panel-full-spectrum']) {
        if (logarithmic) await page.click(`${panel} button:text-is("log")`);
        const { boxes, segments } = await labelled(page, (await saved(page, panel, 'svg')).bytes.toString('utf8'));
        if (logarithmic) await page.click(`${panel} button:text-is("log")`);
        count += boxes.length;
        assert.ok(boxes.length > 0 && segments.length > 100);
        boxes.forEach((box, i) => {
          const on = boxes.slice(0, i).filter(([l, r, t, b]) => l < box[1] && r > box[0] && t < box[3] && b > box[2]);
          assert.deepEqual(on, [], `${panel} at ${value}: labels on one another`);
          assert.deepEqual(
            segments.filter((segment) => crosses(box, segment)),
            [],
            `${panel} at ${value}${logarithmic ? ', logarithmic' : ''}: the curve runs through a label at ${box}`,
          );
        });
      }
  }
  assert.ok(count >= 32, `${count} labels`);
  assert.deepEqual(complaints, []);
  await close();
});

test('the diagram that is saved is the one of the run', async () => {
  const { page, close } = await open(`${address}#q=radius&units=scale,rad/s,order,0-p`);
  await settled(page);
  const lines = (await saved(page, '.map-card', 'csv')).bytes
    .toString('utf8')
    .trim()
    .split('\r\n')
    .slice(1)
    .map((line) => line.split(','));
  const { points } = JSON.parse(command('run', 'rub.yaml', '--json=full', '-q'));
  assert.equal(lines.length, points.length);
  points.forEach((point, i) => {
    assert.ok(Math.abs(Number(lines[i][0]) - point.parameters.omega) < 1e-12);
    assert.equal(lines[i][2], point.verdict);
    const radius = point.stations.disc.max_radius;
    assert.ok(Math.abs(Number(lines[i][6]) - radius) < 1e-6 * radius); // float32
  });
  await close();
});

test('a setting becomes a case that whirl checks and runs', async () => {
  const { page, complaints, close } = await open(
    `${address}#at=3.3&set=mu%3D0.12&range=3,3.5&steps=128&transient=200&record=100`,
  );
  await settled(page);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  const text = readFileSync(await file.path(), 'utf8');
  assert.match(text, /# friction coefficient/, 'comments are kept');
  writeFileSync(join(folder, 'explored.yaml'), text);
  command('check', 'explored.yaml');
  const result = JSON.parse(command('run', 'explored.yaml', '--json=full', '-q'));
  assert.equal(result.points[0].parameters.mu, 0.12);
  assert.equal(result.points[0].parameters.omega, 3);
  assert.equal(result.points.at(-1).parameters.omega, 3.5);
  assert.equal(result.detail.length, 1);
  assert.equal(result.detail[0].parameters.omega, 3.3);
  assert.deepEqual(complaints, []);
  await close();
});

test('the command that is copied computes the setting', async () => {
  const { page, complaints, close } = await open(`${address}#at=1.5&set=mu%3D0.08`);
  await settled(page);
  await page.evaluate(() => (navigator.clipboard.writeText = async (text) => void (window.copied = text)));
  await page.click('button:text-is("Copy command")');
  await page.waitForFunction(() => window.copied);
  const script = await page.evaluate(() => window.copied);
  assert.match(script, /whirl run rub-explored\.yaml -o rub-explored\.h5 && whirl report/);
  execFileSync('bash', ['-e'], {
    cwd: folder,
    input: script.replace(/^whirl run.*$/m, `"$WHIRL" run rub-explored.yaml -q -o rub-explored.h5`),
  });
  const { detail } = JSON.parse(command('run', 'rub-explored.yaml', '--json=full', '-q'));
  assert.equal(detail[0].parameters.mu, 0.08);
  assert.equal(detail[0].parameters.omega, 1.5);
  assert.deepEqual(complaints, []);
  await close();
});

test('a preset of the gallery is computed here', async () => {
  const { page, complaints, close } = await open(`${address}#run=rigid-rotor`);
  await settled(page);
  assert.equal(await page.textContent('h1'), 'Rigid rotor in an oil film');
  await page.waitForFunction(() => Number(document.querySelector('.legend-entry .count')?.textContent) > 2, undefined, {
    timeout: 60_000,
  });
  assert.equal(await page.$$eval('.parameter', (all) => all.length), 3);
  assert.deepEqual(complaints, []);
  await close();
});

test('a brushed range is computed anew, and Back returns', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.selectOption('select[aria-label="Points of a new diagram"]', '64');
  const box = await (await page.$('.map-main .overlay')).boundingBox();
  await page.click('.map-card .segments button[value="range"]');
  await page.mouse.move(box.x + box.width * 0.7, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, box.y + 60, { steps: 5 });
  await page.mouse.up();
  await page.waitForFunction(() =>
    /Computed here, quick: 64 points/.test(document.querySelector('.status').textContent),
  );
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, {
    timeout: 120_000,
  });
  const counts = await page.$$eval('.legend-entry .count', (all) =>
    all.reduce((sum, each) => sum + Number(each.textContent), 0),
  );
  assert.equal(counts, 64, 'every point has a verdict');
  await page.click('button:text-is("Back")');
  await page.waitForFunction(() => /Stored run/.test(document.querySelector('.status').textContent));
  assert.deepEqual(complaints, []);
  await close();
});

test('computing a diagram can be cancelled', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.selectOption('select[aria-label="How well a new diagram is computed"]', 'case');
  await page.selectOption('select[aria-label="Points of a new diagram"]', '1024');
  await page.click('button:text-is("Recompute")');
  await page.waitForSelector('.map-card progress:not([hidden])');
  await page.click('button:text-is("Cancel")');
  await page.waitForFunction(() => document.querySelector('.map-card progress').hidden, undefined, { timeout: 20_000 });
  assert.deepEqual(complaints, []);
  await close();
});

test('a bad value is refused with a sentence', async () => {
  const { page, complaints, close } = await open(address);
  await settled(page);
  await page.fill('#parameter-kappa', '-3');
  await page.press('#parameter-kappa', 'Enter');
  await page.waitForSelector('.settings-card .trouble:not(:empty)');
  assert.match(await page.textContent('.settings-card .trouble'), /stiffness.*-3|kappa.*-3/);
  await page.click('button[aria-label="Reset kappa to the case"]');
  await page.waitForSelector('.settings-card .trouble:empty', { state: 'attached' });
  assert.deepEqual(complaints, []);
  await close();
});

test('two settings side by side', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  const first = await settled(page);
  await page.click('button[title="Compare two settings side by side"]');
  await settled(page, 'b');
  assert.equal(await page.textContent('.settings-card h2'), 'Parameters of B');
  await page.fill('#value-b', '1.5');
  await page.press('#value-b', 'Enter');
  await page.waitForFunction((name) => document.querySelector('.pane-b .verdict').textContent !== name, first);
  await settled(page, 'b');
  assert.equal(await page.textContent('.pane-a .verdict'), first, 'A stays as it was');
  await page.click('.pane-b .close');
  await page.waitForSelector('.pane-b', { state: 'hidden' });
  assert.deepEqual(complaints, []);
  await close();
});

test('the rotor can be watched as it settles', async () => {
  const { page, complaints, close } = await open(`${address}#at=1.5`);
  await settled(page);
  const shot = () => page.$eval('.panel-orbit canvas', (canvas) => canvas.toDataURL());
  const still = await shot();
  await page.click('.pane-a .play');
  await page.waitForTimeout(1500);
  const moving = await shot();
  assert.notEqual(moving, still);
  await page.waitForTimeout(300);
  assert.notEqual(await shot(), moving);
  await page.click('.pane-a .play');
  await page.waitForTimeout(200);
  assert.equal(await shot(), still, 'the settled orbit is back');
  assert.deepEqual(complaints, []);
  await close();
});

test('units are switched everywhere', async () => {
  const { page, complaints, close } = await open(`${address}#at=3.8`);
  await settled(page);
  const field = () => page.inputValue('#value-a').then(Number);
  const inRadians = await field();
  await page.click('.topbar button[value="rpm"]');
  await page.waitForFunction((before) => Number(document.querySelector('#value-a').value) !== before, inRadians);
  assert.ok(Math.abs((await field()) - (inRadians * 30) / Math.PI) < 1e-2);
  await page.click('.topbar button[value="um"]');
  await page.waitForFunction(() => /\u00b5m/.test(document.querySelector('.panel-orbit .panel-note').textContent));
  for (const unit of ['mil', 'scale']) await page.click(`.topbar button[value="${unit}"]`);
  assert.match(await page.textContent('.panel-orbit .panel-note'), /p-p.*0-p/);
  assert.deepEqual(complaints, []);
  await close();
});

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
