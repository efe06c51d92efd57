// Tests measured data over the model: an orbit and 1X vectors from the closed form of a wheel on a damped spring.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { closeBrowser, folder, makePage, open, saved, settled } from './browser.mjs';

const [MASS, STIFFNESS, DAMPING, ECCENTRICITY] = [30, 1.2e6, 1500, 25e-6];
const WHEEL = `whirl: 1
title: A fan on a support
parameters: {n: 1500 rpm, e: 25 um}
rotor:
  speed: = n
  length_scale: 0.1 mm
  stations:
    disc: {mass: ${MASS} kg, damping: ${DAMPING} N s/m, eccentricity: = e}
  elements:
    - shaft: {between: [disc, ground], k1: ${STIFFNESS} N/m, k2: ${STIFFNESS} N/m}
study:
  sweep: {parameter: n, from: 1000 rpm, to: 3000 rpm, points: 21, start: state}
  integrate: {method: rk4, steps_per_revolution: 256, transient: 200, record: 20}
  analyze: [poincare, regime, orbit, spectrum]
`;

/// Returns the amplitude in um and the lag in degrees of x at a speed in rpm; y lags by 90 degrees more.
function response(rpm) {
  const w = (rpm * Math.PI) / 30;
  const [real, late] = [STIFFNESS - MASS * w * w, DAMPING * w];
  const size = (MASS * ECCENTRICITY * w * w) / Math.hypot(real, late);
  return { size: size * 1e6, lag: (Math.atan2(late, real) * 180) / Math.PI };
}

const INSTANTS = 64;
function orbitTable(rpm, factor = 1) {
  const { size, lag } = response(rpm);
  const rows = Array.from({ length: INSTANTS }, (_, i) => {
    const angle = (360 * i) / INSTANTS;
    const at = ((angle - lag) * Math.PI) / 180;
    return [angle, factor * size * Math.cos(at), factor * size * Math.sin(at)].join(',');
  });
  return ['angle [deg], disc x [um], disc y [um]', ...rows].join('\n');
}

const SPEEDS = [1200, 1500, 1700, 1850, 1950, 2100, 2500];
function bodeTable() {
  const rows = SPEEDS.map((rpm) => {
    const { size, lag } = response(rpm);
    return [rpm, size, lag, size, (lag + 90) % 360].join(',');
  });
  return ['speed [rpm], disc x [um], disc x lag [deg], disc y [um], disc y lag [deg]', ...rows].join('\n');
}

after(closeBrowser);

/// Drops files with these names and contents, texts or bytes, onto the page.
const drop = (page, files) =>
  page.evaluate(
    (all) => {
      const data = new DataTransfer();
      for (const [name, content] of all)
        data.items.add(new File([Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0))], name));
      document.body.dispatchEvent(new DragEvent('dragover', { dataTransfer: data, bubbles: true, cancelable: true }));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
    },
    files.map(([name, content]) => [name, Buffer.from(content).toString('base64')]),
  );
const list = (page) => page.$$eval('.measured li > .key', (all) => all.map((each) => each.textContent));

test('a measured orbit and measured vectors lie over the model, and go again', async () => {
  const { page, complaints, close } = await open(makePage('wheel', WHEEL));
  await page.waitForSelector('.parameter'); // the engine has read the case
  await page.fill('#value-a', '1500');
  await page.press('#value-a', 'Enter');
  await settled(page);

  // The orbit of the closed form equals that of the model; one that is 1.5 times as large differs by half the rms
  // value.
  const { size } = response(1500);
  await drop(page, [
    ['orbit.csv', orbitTable(1500)],
    ['other.csv', orbitTable(1500, 1.5)],
  ]);
  await page.waitForSelector('.measured li:nth-child(2)');
  assert.deepEqual(await list(page), [
    'orbit.csv: orbit of disc, 64 instants',
    'other.csv: orbit of disc, 64 instants',
  ]);
  const differences = await page.$$eval('.panel-waveform .key-measured', (all) =>
    all.map((each) => Number(/differs by (\S+) \u00b5m rms/.exec(each.textContent)[1].replace('\u2212', '-'))),
  );
  assert.ok(differences[0] < 1e-3 * size, `${differences[0]} of ${size}`);
  assert.ok(Math.abs(differences[1] / (size / 2 / Math.SQRT2) - 1) < 5e-3, `${differences[1]} of ${size}`);
  await page.waitForSelector('.panel-spectrum .key-measured:nth-child(3)');

  // Remove the second orbit by its button.
  await page.click('.measured button[title="Remove other.csv"]');
  await page.waitForFunction(() => document.querySelectorAll('.measured li').length === 1);

  // After vectors are dropped, the diagram shows the 1X amplitude with the vectors as dots.
  await drop(page, [['bode.csv', bodeTable()]]);
  await page.waitForSelector('.legend .key-measured');
  assert.equal(await page.inputValue('.map-card select[title="What the diagram shows"]'), '1x');
  assert.deepEqual(await list(page), ['orbit.csv: orbit of disc, 64 instants', 'bode.csv: 1X of disc at 7 speeds']);
  assert.deepEqual(await page.$$eval('.unseen-data:not(:empty)', (all) => all.length), 0);
  await page.selectOption('.map-card select[title="What the diagram shows"]', 'radius');
  await page.waitForSelector('.unseen-data:not(:empty)');
  assert.match(await page.textContent('.measured li:nth-child(2) .unseen-data'), /choose 1X amplitude/);
  await page.selectOption('.map-card select[title="What the diagram shows"]', '1xlag');
  await page.waitForSelector('.legend .key-measured');

  // A file that cannot be read is refused with the place, what was found and what is expected.
  await drop(page, [['bad.csv', 'angle [deg], disk x [um]\n0, 1\n']]);
  await page.waitForSelector('.measured .trouble:not(:empty)');
  assert.equal(await page.textContent('.measured .trouble'), "bad.csv:1:14: 'disk' is no station, did you mean disc?");
  await page.click('.measured .troubles button');
  await page.waitForSelector('.measured .troubles', { state: 'hidden' });
  assert.deepEqual(complaints, []);
  await close();
});

const PYTHON = '/usr/bin/python3';
function pythonLacks() {
  try {
    execFileSync(PYTHON, ['-c', 'import h5py, scipy.io'], { stdio: 'ignore' });
    return false;
  } catch {
    return 'h5py or scipy is missing (scripts/install-dependencies.sh test)';
  }
}

/// Returns a table and files of other formats with its numbers, by their names: NAME.csv, .mat, -7.3.mat, .h5, .uff.
function sameNumbers(name, text) {
  const path = join(folder, `${name}.csv`);
  writeFileSync(path, text);
  execFileSync(PYTHON, [new URL('./measured_files.py', import.meta.url).pathname, path]);
  return ['.csv', '.mat', '-7.3.mat', '.h5', '.uff'].map((end) => [name + end, readFileSync(join(folder, name + end))]);
}

test('MAT, HDF5 and universal files lie over the model as tables do', { skip: pythonLacks() }, async () => {
  const { page, complaints, close } = await open(makePage('files', WHEEL));
  await page.waitForSelector('.parameter');
  await page.fill('#value-a', '1500');
  await page.press('#value-a', 'Enter');
  await settled(page);

  /// Returns what the page shows of a file, which is removed again: texts and pictures.
  const shownOf = async ([name, bytes], keys, panels) => {
    await drop(page, [[name, bytes]]);
    await page.waitForSelector('.measured li');
    for (const selector of keys) await page.waitForSelector(selector);
    await settled(page);
    const texts = [
      ...(await list(page)),
      ...(await page.$$eval('.key-measured', (all) => all.map((each) => each.textContent))),
    ];
    const shown = [texts.map((text) => text.replaceAll(name, 'FILE'))];
    for (const panel of panels) shown.push((await saved(page, panel, 'svg')).bytes.toString('utf8'));
    await page.click(`.measured button[title="Remove ${name}"]`);
    await page.waitForFunction(() => document.querySelectorAll('.measured li').length === 0);
    return shown;
  };
  const orbits = sameNumbers('orbit', orbitTable(1500, 1.5));
  const key = (panel) => `.panel-${panel} .key-measured`;
  const bodes = sameNumbers('bode', bodeTable());
  for (const [files, keys, panels] of [
    [orbits, [key('orbit'), key('waveform'), key('spectrum')], ['.panel-orbit', '.panel-waveform', '.panel-spectrum']],
    [bodes, ['.legend .key-measured'], ['.map-card']],
  ]) {
    const [table, ...others] = files;
    const expected = await shownOf(table, keys, panels);
    for (const [i, panel] of panels.entries())
      assert.notEqual((await saved(page, panel, 'svg')).bytes.toString('utf8'), expected[i + 1], panel);
    assert.match(expected[0][0], /^FILE: (orbit of disc, 64 instants|1X of disc at 7 speeds)$/);
    for (const file of others) assert.deepEqual(await shownOf(file, keys, panels), expected, file[0]);
  }

  // Damaged files have their sentence, and the page goes on.
  const [, [, mat], , [, hdf5], [, universal]] = orbits;
  const flip = (bytes, from, to) => Buffer.from(bytes.map((byte, i) => (i >= from && i < to ? byte ^ 0xff : byte)));
  const chunk = hdf5.lastIndexOf(Buffer.from([0x78, 0x5e])); // where zlib's bytes of the last chunk begin
  assert.ok(chunk > 0);
  await drop(page, [
    ['cut.mat', mat.subarray(0, 700)],
    ['flipped.mat', flip(mat, 160, 170)],
    ['flipped.h5', flip(hdf5, chunk + 8, chunk + 12)],
    ['cut.uff', universal.subarray(0, 1500)],
    ['empty.mat', ''],
    ['matrix.h5', readFileSync(join(folder, 'orbit-matrix.h5'))],
    ['good.mat', mat],
  ]);
  await page.waitForSelector('.measured .trouble:not(:empty)');
  const sentences = (await page.textContent('.measured .trouble')).split('\n');
  assert.deepEqual(
    sentences.map((sentence) => sentence.replace(/ disc [xy] /, ' ')),
    [
      'cut.mat: is damaged or cut off',
      'flipped.mat: is damaged: what it has compressed cannot be read',
      'flipped.h5: is damaged: a checksum is wrong',
      'cut.uff: dataset 58 number 1, line 13: is cut off',
      'empty.mat: is no HDF5, MAT or universal file',
      'matrix.h5: there is no vector of numbers, expected `columns` that choose some',
    ],
  );
  assert.deepEqual(await list(page), ['good.mat: orbit of disc, 64 instants']);
  assert.deepEqual(complaints, []);
  await close();
});

test('measured vectors lie over a stored Bode diagram', async () => {
  const study = 'study:\n  unbalance: {parameter: n, from: 1000 rpm, to: 3000 rpm, points: 21}\n';
  const { page, complaints, close } = await open(makePage('rest', WHEEL.slice(0, WHEEL.indexOf('study:')) + study));
  await page.waitForSelector('.rest .numbers tbody td');
  const legend = () => page.textContent('.rest .legend:visible');
  assert.doesNotMatch(await legend(), /measured/);
  await page.setInputFiles('.measured input', {
    name: 'bode.csv',
    mimeType: 'text/csv',
    buffer: Buffer.from(bodeTable()),
  });
  await page.waitForSelector('.measured li');
  assert.match(await legend(), /measured, in the colours of the probes/);
  // The picture has the dots of both probes, in amplitudes and in lags: four paths with seven dots each, and their
  // rims.
  const { bytes } = await saved(page, '.rest .map-card:visible', 'svg');
  const rims = bytes
    .toString('utf8')
    .match(/<path[^>]*>/g)
    .filter((path) => (path.match(/A/g) ?? []).length >= 14);
  assert.equal(rims.length, 8);
  // The drawing of the machine shows no motion over which data could lie.
  await page.click('.contents button[title="Go to The machine"]');
  await page.waitForSelector('.rest', { state: 'hidden' });
  await drop(page, [['bode.csv', bodeTable()]]);
  await page.waitForSelector('.measured .trouble:not(:empty)');
  assert.match(await page.textContent('.measured .trouble'), /open such a part of the result first/);
  assert.deepEqual(complaints, []);
  await close();
});

test('fitted parameters are sliders with errors, measured numbers lie over the fitted machine', async () => {
  // Amplitudes are alternately 1 um too large and too small, residuals that no parameter can fit.
  const rows = bodeTable()
    .split('\n')
    .map((row, i) => (i === 0 ? row : row.replace(/,([^,]*)/, (_, size) => `,${Number(size) + (i % 2 ? 1 : -1)}`)));
  writeFileSync(join(folder, 'bode.csv'), rows.join('\n'));
  const fit = `study:
  initial: {disc: {x: 0.01}}
  fit:
    unknown: {k: {from: 0.8 MN/m, to: 2 MN/m}, e: {from: 5 um, to: 60 um}}
    data: {file: bode.csv, noise: 1 um}
`;
  const text = WHEEL.slice(0, WHEEL.indexOf('study:'))
    .replace('e: 25 um', 'k: 1 MN/m, e: 20 um')
    .replace(/k1: .* N\/m, k2: .* N\/m/, 'k1: = k, k2: = k');
  const { page, complaints, close } = await open(makePage('fit', text + fit));
  await settled(page);
  assert.equal(await page.textContent('.contents [aria-current]'), 'Fit to measured motions');
  // The sliders begin at the fitted values, in the case's units; the true values are within the 95 % intervals.
  for (const [name, truth, unit] of [
    ['k', STIFFNESS / 1e6, 'MN/m'],
    ['e', ECCENTRICITY * 1e6, 'um'],
  ]) {
    const shown = await page.textContent(`#parameter-${name}-fit`);
    const [, value, error, low, high] = new RegExp(`fitted (\\S+) \u00b1 (\\S+) ${unit}; 95 %: (\\S+) to (\\S+)$`)
      .exec(shown)
      .map(Number);
    assert.ok(low <= truth && truth <= high && high - low < 5 * error, shown);
    assert.ok(Math.abs(Number(await page.inputValue(`#parameter-${name}`)) - value) < error, shown);
    // The bar is twice the error wide, on a slider whose range is 20 half-widths of the 95 % interval.
    const [bar, slider] = await page.$eval(`.parameter:has(#parameter-${name}) .slider`, (all) =>
      ['.fit-error', 'input'].map((part) => all.querySelector(part).getBoundingClientRect().width),
    );
    const expected = (2 * error) / (10 * (high - low));
    assert.ok(Math.abs(bar / (slider - 16) - expected) < 0.1 * expected, `${bar} of ${slider}, expected ${expected}`);
  }
  assert.deepEqual(await list(page), ['file 1: 1X of disc at 7 speeds']);
  await page.waitForSelector('.legend .key-measured');
  // Reset takes a changed parameter back to the fitted value, which the saved case has.
  await page.fill('#parameter-k', '1.3');
  await page.press('#parameter-k', 'Enter');
  await page.waitForSelector('.parameter.changed');
  await page.click('button[title="Reset k to the case"]');
  await page.waitForSelector('.parameter.changed', { state: 'detached' });
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-save="case"]')]);
  const kept = readFileSync(await file.path(), 'utf8');
  assert.match(kept, /k: 1\.[12]\d+ MN\/m/);
  assert.match(kept, /sweep: \{parameter: n/);
  assert.match(kept, /initial: \{disc: \{x: 0\.01\}\}/);
  assert.deepEqual(complaints, []);
  await close();
});

test('bands of tolerances are shaded in the diagram and in the Bode diagram', async () => {
  const head = WHEEL.slice(0, WHEEL.indexOf('study:'));
  const tolerances = '  tolerances: {parameters: {e: {from: 10 um, to: 40 um}}, samples: 128}\n';
  const { page, complaints, close } = await open(
    makePage('sweep', WHEEL.replace('points: 21', 'points: 5') + tolerances),
  );
  await page.waitForSelector('.parameter');
  // The amplitude is proportional to the eccentricity, whose quantiles between 10 and 40 um are known.
  const [{ bands }] = JSON.parse(await page.textContent('#whirl-runs'));
  const band = bands.find(({ field, column }) => field === 'spectrum/synchronous' && column === 0);
  assert.equal(band.places.length, 5);
  for (const [value, ...quantiles] of band.places)
    [0.05, 0.25, 0.5, 0.75, 0.95].forEach((share, i) => {
      const rpm = (value * 30) / Math.PI;
      const expected = (response(rpm).size * (10 + 30 * share)) / 25;
      // There is one sample in each of 128 equal parts of the range, so a quantile is right to one part on each side.
      const tolerance = (response(rpm).size * 30 * (2 / 128)) / 25;
      assert.ok(Math.abs(quantiles[i] * 1e6 - expected) < tolerance, `${quantiles[i] * 1e6}, expected ${expected}`);
    });
  const choose = (id) => page.selectOption('.map-card select[title="What the diagram shows"]', id);
  await choose('1x');
  await page.waitForSelector('.legend .key-band');
  assert.match(await page.textContent('.legend .key-band'), /median of 128 samples/);
  await choose('1xlag');
  await page.waitForSelector('.legend .key-band', { state: 'detached' });
  assert.deepEqual(complaints, []);
  await close();

  const study = 'study:\n  unbalance: {parameter: n, from: 1000 rpm, to: 3000 rpm, points: 21}\n';
  const turned = head.replace('e: 25 um}', 'e: 25 um, a: 0 deg}').replace('= e}', '= e, eccentricity_angle: = a}');
  const angles = tolerances.replace('40 um}', '40 um}, a: {from: -30 deg, to: 30 deg}');
  const rest = await open(makePage('rest-bands', turned + study + angles) + '#part=unbalance');
  await rest.page.waitForSelector('.rest .numbers tbody td');
  // The lag is that of the response less the angle of the unbalance, whose quantiles are known; below 0 at low speeds.
  const [restRun] = JSON.parse(await rest.page.textContent('#whirl-runs'));
  const lags = restRun.bands.find(({ field, column }) => field === 'unbalance/probe_lag' && column === 0);
  assert.equal(lags.places.length, 21);
  assert.ok(lags.places[0][1] < 0);
  for (const [value, ...quantiles] of lags.places)
    [0.05, 0.25, 0.5, 0.75, 0.95].forEach((share, i) => {
      const expected = response((value * 30) / Math.PI).lag - 30 + 60 * share;
      assert.ok(Math.abs(quantiles[i] - expected) < (60 * 2) / 128, `${quantiles[i]}, expected ${expected}`);
    });
  assert.match(await rest.page.textContent('.rest .legend:visible'), /tolerances, in the colours of the lines/);
  // Probes at other angles have no stored quantiles, so the major axis has the band.
  await rest.page.fill('.rest input.angle', '30');
  await rest.page.press('.rest input.angle', 'Enter');
  await rest.page.waitForFunction(() => location.hash.includes('probe=30'));
  assert.match(await rest.page.textContent('.rest .legend:visible'), /tolerances/);
  assert.deepEqual(rest.complaints, []);
  await rest.close();
});

test('the user chooses the columns of a file, its keyphasor says where the mark is', async () => {
  const { page, complaints, close } = await open(makePage('columns', WHEEL));
  await page.waitForSelector('.parameter');
  await page.fill('#value-a', '1500');
  await page.press('#value-a', 'Enter');
  await settled(page);

  // Raw signals at 1500 rpm that begin 0.3 of a turn after the mark, which is where the edge of the keyphasor rises.
  const { size, lag } = response(1500);
  const rows = Array.from({ length: 2000 }, (_, i) => {
    const time = i / 5000;
    const angle = 2 * Math.PI * (25 * time + 0.3);
    const at = angle - (lag * Math.PI) / 180;
    return [time, Math.asin(Math.sin(angle)), size * Math.cos(at), size * Math.sin(at)].join(',');
  });
  await drop(page, [['raw.csv', ['t,tacho,CH1,CH2', ...rows].join('\n')]]);
  await page.waitForSelector('.chooser');
  assert.match(await page.textContent('.measured .trouble'), /^raw\.csv:1:1: there is no column 'angle/);
  assert.equal(await page.inputValue('[aria-label="Use of t"]'), 'time');
  assert.equal(await page.inputValue('[aria-label="Use of tacho"]'), 'keyphasor');
  assert.deepEqual(await list(page), []);

  // Without probes the choice is refused, and stays.
  await page.click('.chooser button[type="submit"]');
  await page.waitForFunction(() => /no probe/.test(document.querySelector('.measured .trouble').textContent));
  await page.selectOption('[aria-label="Use of CH1"]', 'disc x');
  await page.selectOption('[aria-label="Use of CH2"]', 'other…');
  await page.fill('[aria-label="Heading of CH2"]', 'disc 90');
  assert.equal(await page.inputValue('[aria-label="Unit of CH1"]'), 'um');
  await page.click('.chooser button[type="submit"]');
  await page.waitForSelector('.measured li');
  await page.waitForSelector('.chooser', { state: 'detached' });
  assert.match((await list(page))[0], /^raw\.csv: waveform of disc at 1[,\u202f ]?500 rpm, 2000 samples$/);
  const difference = async () => {
    await page.waitForSelector('.panel-waveform .key-measured');
    const text = await page.textContent('.panel-waveform .key-measured');
    return Number(/differs by (\S+) \u00b5m rms/.exec(text)[1].replace('\u2212', '-'));
  };
  assert.ok((await difference()) < 2e-3 * size, `${await difference()} of ${size}`);

  // The columns of a file that is shown are chosen again: without the keyphasor the mark is elsewhere.
  await page.click('.measured button[title="Choose the columns of raw.csv"]');
  await page.waitForSelector('.chooser');
  await page.selectOption('[aria-label="Use of tacho"]', 'not used');
  await page.selectOption('[aria-label="Use of CH1"]', 'disc x');
  await page.selectOption('[aria-label="Use of CH2"]', 'disc y');
  await page.click('.chooser button[type="submit"]');
  await page.waitForFunction(() => !/rpm/.test(document.querySelector('.measured li > .key').textContent));
  assert.deepEqual(await list(page), ['raw.csv: waveform of disc, 2000 samples']);
  // Two sines that are 0.3 of a turn apart differ by 2 sin(0.3 pi) of their amplitude.
  const apart = (2 * Math.sin(0.3 * Math.PI) * size) / Math.SQRT2;
  await page.waitForFunction((expected) => {
    const text = document.querySelector('.panel-waveform .key-measured')?.textContent ?? '';
    const found = Number(/differs by (\S+) /.exec(text)?.[1] ?? NaN);
    return Math.abs(found / expected - 1) < 5e-3;
  }, apart);
  await page.click('.measured button[title="Choose the columns of raw.csv"]');
  await page.click('.chooser button[title="Cancel the choice of the columns of raw.csv"]');
  await page.waitForSelector('.chooser', { state: 'detached' });
  assert.deepEqual(complaints, []);
  await close();
});
