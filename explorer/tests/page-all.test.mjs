// Tests that one page shows all of a lateral result: the findings of `whirl show --json` and the figures of `whirl
// figure` for every table, word for word.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { axeFindings, beyondWindow, closeBrowser, command, folder, makePage, open, saved } from './browser.mjs';

// Only the last stations have probes. The page computes the motion of `response`; it does not compute those of
// `motions`.
const COMPRESSOR = `whirl: 1
title: A small compressor
parameters: {omega: 3000 rpm, c: 2 kN.s/m}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    left:  {position: 0 m}
    disc:  {position: 0.5 m, mass: 100 kg}
    right: {position: 1 m}
  elements:
    - segment: {length: 1 m, outer: 100 mm}
    - bearing: {at: left, kxx: 20 MN/m, cxx: = c}
    - bearing: {at: right, kxx: 20 MN/m, cxx: = c}
    - unbalance: {at: disc, moment: 2 kg.mm}
    - rub: {at: disc, gap: 0.5 mm, stiffness: 10 MN/m}
    - stage: {at: disc, power: 10 kW, diameter: 0.5 m, width: 10 mm}
study:
  response: {}
  motions: {unbalance: unbalance, factor: 6, parameter: omega, values: [2900 rpm, 3100 rpm]}
  integrate: {transient: 100, record: 20}
  stability: {}
  statics: {}
  modes: {parameter: omega, from: 1000 rpm, to: 9000 rpm, points: 9}
  unbalance: {parameter: omega, from: 1000 rpm, to: 9000 rpm, points: 81, antinodes_of: 1, running_from: 2900 rpm,
    running_to: 3100 rpm, probes_at: [right, disc]}
  conditions: {low: {}, high: {c: 3 kN.s/m}}
`;

let address, reported, names;
before(() => {
  address = makePage('all', COMPRESSOR);
  reported = JSON.parse(command('show', 'all.h5', '--json'));
  names = command('figure', 'all.h5', '--list')
    .trim()
    .split('\n')
    .map((line) => line.split(' ')[0]);
});
after(closeBrowser);

const PARTS = '.contents ul:first-child button';

async function opened(hash = '', options = {}) {
  const made = await open(address + hash, options);
  await made.page.waitForSelector(`${PARTS}[aria-current]`);
  return made;
}

/// Opens every part of the result in turn.
async function everyPart(page, look) {
  const count = await page.locator(PARTS).count();
  for (let i = 0; i < count; i++) {
    await page.click(`${PARTS} >> nth=${i}`);
    await page.waitForFunction(
      ([where, at]) => document.querySelectorAll(where)[at].getAttribute('aria-current') === 'page',
      [PARTS, i],
    );
    await look(await page.textContent(`${PARTS} >> nth=${i}`));
  }
  return count;
}

const digits = (text) => Number(text.replaceAll(',', ''));

test('every statement, every cell of every sheet and every figure is there', async () => {
  const { page, complaints, close } = await opened();
  const [words, sheets, figures] = [[], new Map(), new Set()];
  const parts = await everyPart(page, async () => {
    words.push(...(await page.$$eval('.statements li', (all) => all.map((each) => each.textContent))));
    for (const [name, rows] of await page.$$eval('[data-sheet]', (all) =>
      all.map((each) => [
        each.dataset.sheet,
        [...each.querySelectorAll('tr')].map((row) => [...row.cells].map((cell) => cell.textContent)),
      ]),
    ))
      sheets.set(name, rows);
    for (const name of await page.$$eval('[data-figure]', (all) => all.map((each) => each.dataset.figure)))
      figures.add(name);
  });
  assert.ok(parts >= 9, `${parts} parts`);
  assert.ok(reported.statements.length >= 10 && reported.sheets.length >= 10);
  for (const { what, station, at, asked, found, judged: verdict, clause } of reported.statements) {
    const wanted = [at?.text, what, station, asked.text, found.text, verdict.text, clause].filter(Boolean);
    assert.ok(
      words.some((text) => wanted.every((part) => text.includes(part))),
      `${wanted.join(' | ')} in none of\n${words.join('\n')}`,
    );
  }
  for (const { table, name, columns, rows } of reported.sheets) {
    const [heading, ...seen] = sheets.get(`${table}/${name}`) ?? [[]];
    const empty = (cell) => cell === null || cell === '' || cell.length === 0;
    const kept = columns.map((_, c) => c).filter((c) => rows.some((row) => !empty(row[c])));
    assert.equal(heading.length, kept.length, `columns of ${table}/${name}`);
    assert.equal(seen.length, rows.length, `rows of ${table}/${name}`);
    kept.forEach((c, i) => assert.ok(heading[i].replaceAll('\u2011', '-').startsWith(columns[c].heading), heading[i]));
    rows.forEach((row, r) =>
      kept.forEach((c, i) => {
        const [cell, text, column] = [row[c], seen[r][i], columns[c]];
        const where = `${table}/${name}, row ${r + 1}, ${column.heading}: ${text}`;
        if (empty(cell)) assert.equal(text, '', where);
        else if (typeof cell === 'string') assert.equal(text, cell, where);
        else if (typeof cell === 'number') {
          const shown = cell / column.size;
          const last = 0.51 * 10 ** (Math.floor(Math.log10(Math.abs(shown) || 1)) + 1 - column.digits);
          assert.ok(Math.abs(digits(text) - shown) <= last, `${where}, expected ${shown}`);
        }
      }),
    );
  }
  assert.deepEqual([...figures].sort(), names.sort());
  assert.deepEqual(complaints, []);
  await close();
});

test('the page begins with the drawing of this machine alone; live views begin at a station with a probe', async () => {
  const { page, complaints, close } = await opened();
  assert.equal(await page.getAttribute('.document > .card >> nth=0', 'data-figure'), 'rotor');
  assert.equal(await page.locator('.topbar select[aria-label="Machine"] option').count(), 1);
  await page.click(`${PARTS}:has-text("unbalance_high")`);
  await page.waitForSelector('.rest .numbers tbody tr');
  assert.equal(
    await page.$eval('.rest .map-card:not([hidden]) select', (list) => list.selectedOptions[0].textContent),
    'right',
  );
  await page.waitForFunction(() => /part=unbalance_high/.test(location.hash));
  // The live view shows the numbers of that condition.
  const csv = (await saved(page, '.rest .map-card:not([hidden])', 'csv')).bytes.toString('utf8').trim().split(/\r?\n/);
  const largest = Math.max(...csv.slice(1).map((line) => Number(line.split(',').at(-1))));
  const sheet = reported.sheets.find(({ table, name }) => table === 'unbalance_high' && name === 'largest');
  const [, peak] = sheet.rows.find(([station]) => station === 'right'); // m; the page shows um
  assert.ok(Math.abs(1e-6 * largest - peak) <= 1e-4 * peak, `${largest} um, expected ${peak} m`);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => !/part=/.test(location.hash));
  await page.waitForSelector('.document [data-figure="rotor"]');
  assert.deepEqual(complaints, []);
  await close();
});

test('an address leads to a part; one without such a part to the first', async () => {
  const stability = await opened('#part=stability_low');
  assert.match(await stability.page.textContent(`${PARTS}[aria-current]`), /stability_low/);
  assert.ok(await stability.page.isHidden('.rest'));
  const nonsense = await opened('#part=%3Cb%3E');
  assert.equal(await nonsense.page.textContent(`${PARTS}[aria-current]`), 'The machine');
  assert.deepEqual([...stability.complaints, ...nonsense.complaints], []);
  await stability.close();
  await nonsense.close();
});

test('the numbers of a sheet are saved with all digits', async () => {
  const { page, complaints, close } = await opened('#part=modes_low');
  const sheet = reported.sheets.find(({ table, name }) => table === 'modes_low' && name === 'lowest');
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.click('[data-sheet="modes_low/lowest"] [data-save="csv"]'),
  ]);
  assert.equal(file.suggestedFilename(), 'modes_low-lowest.csv');
  const [, ...lines] = readFileSync(await file.path(), 'utf8')
    .trim()
    .split(/\r?\n/);
  assert.equal(lines.length, sheet.rows.length);
  lines.forEach((line, r) =>
    line.split(',').forEach((text, c) => {
      const [cell, { size }] = [sheet.rows[r][c], sheet.columns[c]];
      if (typeof cell === 'number') assert.ok(Math.abs(Number(text) * size - cell) <= 1e-14 * Math.abs(cell), line);
    }),
  );
  assert.deepEqual(complaints, []);
  await close();
});

test('the drawing is a map: a click or a key on a station selects it in all views', async () => {
  const { page, complaints, close } = await opened();
  const drawing = page.locator('[data-figure="rotor"]');
  const spot = (name) => drawing.getByRole('button', { name: `Select station ${name}`, exact: true });
  const pressed = () =>
    drawing.locator('[aria-pressed="true"]').evaluateAll((all) => all.map((each) => each.dataset.station));
  assert.deepEqual(await drawing.locator('.spot').evaluateAll((all) => all.map((each) => each.dataset.station)), [
    'left',
    'disc',
    'right',
  ]);
  assert.deepEqual(await pressed(), ['right']); // the first station with a probe
  await spot('disc').click();
  await page.waitForFunction(() => /st=disc/.test(location.hash));
  assert.deepEqual(await pressed(), ['disc']);
  await spot('left').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /st=left/.test(location.hash));
  assert.deepEqual(await pressed(), ['left']);
  await page.click(`${PARTS}:has-text("unbalance_high")`);
  await page.waitForSelector('.rest .numbers tbody tr');
  assert.equal(
    await page.$eval('.rest .map-card:not([hidden]) select', (list) => list.selectedOptions[0].textContent),
    'left',
  );
  // The saved file contains the drawing without its hot spots.
  await page.click(`${PARTS} >> nth=0`);
  const svg = (await saved(page, '[data-figure="rotor"]', 'svg')).bytes.toString('utf8');
  assert.ok(svg.includes('<svg') && !svg.includes('spot'), 'no button in the file');
  assert.deepEqual(complaints, []);
  await close();
});

test('marks at the ends of a sweep are drawn whole', async () => {
  const { page, close } = await opened('#part=modes_low');
  // In figures, marks are not among the parts that are clipped at the frame.
  const cut = await page.$$eval(
    '[data-figure^="campbell"] svg',
    (all) => all.flatMap((svg) => [...svg.querySelectorAll('[clip-path] circle')]).length,
  );
  assert.equal(cut, 0);
  // In the live view, the mark of the first point extends over the frame's left edge and is not clipped.
  const svg = (await saved(page, '.rest .map-card:not([hidden])', 'svg')).bytes.toString('utf8');
  const found = await page.evaluate((text) => {
    const host = document.body.appendChild(document.createElement('div'));
    host.innerHTML = text;
    const clip = host.querySelector('clipPath path').getBBox();
    const marks = [...host.querySelectorAll('path')].filter(
      (path) => !path.closest('clipPath') && /Z\s*$/i.test(path.getAttribute('d')) && path.getBBox().width < 12,
    );
    const at = marks.filter((path) => {
      const box = path.getBBox();
      return box.x < clip.x && box.x + box.width > clip.x;
    });
    const whole = at.filter((path) => !path.closest('[clip-path]'));
    host.remove();
    return { at: at.length, whole: whole.length };
  }, svg);
  assert.ok(found.at > 0, 'marks lie at the left edge');
  assert.equal(found.whole, found.at);
  await close();
});

for (const [colorScheme, width] of [
  ['light', 390],
  ['dark', 1280],
])
  test(`axe finds nothing, and nothing is cut, ${colorScheme}, ${width} pixels`, async () => {
    const { page, complaints, close } = await opened('', { colorScheme, viewport: { width, height: 780 } });
    await everyPart(page, async (part) => {
      assert.equal(await beyondWindow(page), 0, part);
      if (!/machine|modes_low/.test(part)) return;
      // Exclude drawings, which have thousands of parts that screen readers do not read.
      assert.deepEqual(await axeFindings(page, ['svg']), [], part);
    });
    assert.deepEqual(complaints, []);
    await close();
  });
