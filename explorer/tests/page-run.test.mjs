// Tests a run-up in the explorer: the stored run, a run that the page computes, and the cursor, compared with the
// result file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { axeFindings, beyondWindow, closeBrowser, command, folder, makePage, open, saved } from './browser.mjs';

const RAMP = `whirl: 1
title: A rotor that rubs on its way up
rotor:
  speed: 1 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: 1 m}
  elements:
    - spring: {between: [disc, ground], stiffness: 1 N/m}
    - rub:    {at: disc, gap: 4 m, stiffness: 1 N/m, friction: 0.05, law: paper}
study:
  runup: {rate: 0.003 rad/s2, duration: 700 s}
`;
let ramp;
before(() => {
  ramp = makePage('ramp', RAMP);
});
after(closeBrowser);

function rowsOf(csv) {
  const [heading, ...lines] = csv.trim().split(/\r?\n/);
  return { heading: heading.split(','), rows: lines.map((line) => line.split(',').map(Number)) };
}

const table = async (page, panel) => rowsOf((await saved(page, panel, 'csv')).bytes.toString('utf8'));
const card = (title) => `.run .map-card[aria-label="${title}"]`;

/// Exports a result file; returns the rows of a field of the run.
function exported(name, field) {
  command('export', `${name}.h5`, '--csv', `${name}-csv`, '--force');
  return rowsOf(readFileSync(join(folder, `${name}-csv`, `runup-runup-${field}.csv`), 'utf8'));
}

const opened = async (address, options) => {
  const made = await open(address, options);
  await made.page.waitForSelector('.run .numbers tbody td');
  await made.page.waitForFunction(() => !document.querySelector('.run .settings-card').hidden);
  return made;
};

/// Waits until the run at the present setting is computed.
const computed = (page) =>
  page.waitForFunction(
    () =>
      /^Computed in this page/.test(document.querySelector('.run .how').textContent) &&
      !document.querySelector('.run').classList.contains('busy'),
    undefined,
    { timeout: 60_000 },
  );

test('a stored run is shown over time and speed, with one cursor', async () => {
  const { page, complaints, close } = await opened(`${ramp}#t=300&units=scale,rad/s,order,0-p`);
  assert.match(await page.textContent('.run .how'), /^Stored run; ended as planned/);
  const time = exported('ramp', 'time').rows.map((row) => row.at(-1));
  const speed = exported('ramp', 'speed').rows.map((row) => row.at(-1));
  // The row of an incomplete last turn has no amplitude, so rows are matched by their numbers.
  const amplitude = new Map(exported('ramp', 'amplitude').rows.map((row) => [row[3], row.at(-8)]));
  const numbers = exported('ramp', 'time').rows.map((row) => row[2]);
  const { rows } = await table(page, card('The run over the time'));
  const there = [...time.keys()];
  assert.equal(rows.length, there.length);
  assert.ok(amplitude.size >= there.length - 1);
  there.forEach((i, row) => {
    assert.ok(Math.abs(rows[row][0] - time[i]) <= 1e-6 * 700);
    assert.ok(Math.abs(rows[row][1] - speed[i]) <= 1e-6 * 2.1);
    if (amplitude.has(numbers[i])) assert.ok(Math.abs(rows[row][3] - amplitude.get(numbers[i])) <= 1e-6 * 11);
  });
  // The cursor is at the same row by time and by speed; an arrow key moves it to the next row.
  const at = there.reduce((best, i) => (Math.abs(time[i] - 300) < Math.abs(time[best] - 300) ? i : best), there[0]);
  assert.ok(
    Math.abs(Number.parseFloat(await page.textContent('.run .pane-value .verdict')) - speed[at]) < 1e-4 * speed[at],
  );
  const slider = (title) => page.locator(`${card(title)} [role="slider"]`);
  assert.ok(Math.abs(Number(await slider('The run over the speed').getAttribute('aria-valuenow')) - speed[at]) < 1e-6);
  await slider('The run over the speed').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((before) => document.querySelector('#value-run').value !== before, '300');
  const next = there[there.indexOf(at) + 1];
  assert.ok(Math.abs(Number(await page.inputValue('#value-run')) - time[next]) < 1e-5 * 700);
  assert.match(page.url(), /t=30\d/);
  // The result has no orbits, so the page shows the sum of the orders.
  assert.match(await page.textContent('.panel-run-orbit'), /sum of orders 1 to 4/);
  assert.deepEqual(complaints, []);
  await close();
});

test('stations that twist are shown in degrees, without an orbit', async () => {
  const train = makePage('train', readFileSync(new URL('../../cases/motor-start.yaml', import.meta.url), 'utf8'));
  const { page, complaints, close } = await opened(`${train}#t=0.4&units=um,rpm,order,0-p`);
  const { heading, rows } = await table(page, card('The run over the time'));
  assert.deepEqual(heading.slice(3, 5), ['twist at 1X (\u00b0 0-p)', 'largest twist (\u00b0)']);
  // The file has twists as displacements of points 1 m from the axis, in mm; the motor is its first station.
  const radius = exported('train', 'radius').rows.map((row) => (row.at(-1) * 1e-3 * 180) / Math.PI);
  rows.forEach((row, i) => assert.ok(Math.abs(row[4] - radius[i]) <= 1e-6 * radius[0], `row ${i}`));
  assert.ok(radius[0] > 3);
  const numbers = await page.textContent('.run .numbers');
  assert.match(numbers, /twist at 1X/);
  assert.doesNotMatch(numbers, /\u00b5m|mean y/);
  assert.equal(await page.isVisible('.panel-run-orbit'), false);
  assert.equal(await page.isVisible('.panel-run-spectrum'), false);
  // Torques of the motor and both couplings are shown over the time and at the cursor.
  const chart = page.locator(card('The run over the time'));
  const below = chart.getByLabel('What the lower chart shows');
  assert.deepEqual((await below.locator('option').allTextContents()).slice(-4), [
    'Torque: induction motor at motor',
    'Torque: motor to wheel',
    'Torque: pinion to compressor',
    'Speeds of the stations',
  ]);
  const course = exported('train', 'torque_course').rows;
  const count = course.length / 3;
  await below.selectOption({ label: 'Torque: motor to wheel' });
  const shaft = await table(page, card('The run over the time'));
  assert.match(shaft.heading.at(-2), /largest in the row/);
  assert.equal(shaft.rows.length, 1000);
  assert.ok(Math.abs(shaft.rows[499][0] - 0.999) < 1e-9, 'the middle of its row');
  const largest = Math.max(...course.slice(count, 2 * count).map((row) => row.at(-1)));
  assert.ok(Math.abs(Math.max(...shaft.rows.map((row) => row.at(-2))) - largest) <= 1e-6 * largest);
  await below.selectOption({ label: 'Speeds of the stations' });
  const speeds = (await table(page, card('The run over the time'))).rows.at(-1).slice(-4);
  assert.ok(Math.abs(speeds[2] / speeds[1] - 2) < 1e-6, 'the gear doubles the speed');
  // Without stored turns the panel says so; a run by torques has no force or gap here.
  assert.match(await page.textContent('.panel-run-torque'), /Compute shows it/);
  assert.equal(await page.isVisible('.panel-run-force'), false);
  const found = await page.textContent('.run .numbers');
  assert.match(found, /Torques at the cursor/);
  assert.match(found, /132\.2/);
  assert.match(found, /57\.92/);
  // The computed run has twist and torques within the turn, as the command's.
  await page.click('.run .pane-value >> text=Compute');
  await computed(page);
  await page
    .locator('.panel-run-torque')
    .getByLabel('Torques', { exact: true })
    .selectOption({ label: 'motor to wheel' });
  const within = await table(page, '.panel-run-torque');
  assert.deepEqual(within.heading.slice(2), ['motor to wheel (N m)']);
  command('run', 'train.yaml', '--set', 'runup.orbits=1000', '-q', '-o', 'turns.h5');
  const times = exported('turns', 'orbit_time').rows;
  const cursor = Number(await page.inputValue('#value-run'));
  const away = (row) => Math.abs(row.at(-1) - cursor);
  const turn = times.reduce((best, row) => (away(row) < away(best) ? row : best))[2] - 1;
  const ofTurn = (field, first) =>
    exported('turns', field).rows.filter((row) => row.at(-2) > first && row.at(-2) <= first + 128);
  const torque = ofTurn('orbit_torque_course', (1000 + turn) * 128).map((row) => row.at(-1));
  assert.equal(torque.length, 128);
  within.rows.forEach((row, k) => assert.ok(Math.abs(row[2] - torque[k]) <= 1e-9 * largest, `instant ${k}`));
  assert.ok(Math.max(...torque) - Math.min(...torque) > 10);
  const twist = await table(page, '.panel-run-motion');
  assert.deepEqual(twist.heading.slice(2), ['twist (\u00b0)']);
  assert.deepEqual(complaints, []);
  await close();
});

test('a moved rate gives the run that the command gives', async () => {
  const { page, complaints, close } = await opened(`${ramp}#t=80&units=scale,rad/s,order,0-p`);
  assert.deepEqual(await page.$$eval('.run .parameter label', (labels) => labels.map((label) => label.textContent)), [
    'runup.rate',
    'disc.eccentricity',
    'rub.friction',
  ]);
  await page.fill('[id="parameter-runup.rate"]', '0.01');
  await page.keyboard.press('Enter');
  await computed(page);
  command('run', 'ramp.yaml', '--set', 'runup.rate=0.01 rad/s2', '--set', 'runup.orbits=400', '-q', '-o', 'fast.h5');
  const amplitude = exported('fast', 'amplitude').rows.map((row) => row.at(-8));
  const { rows } = await table(page, card('The run over the time'));
  const whole = amplitude.filter(Number.isFinite);
  assert.equal(rows.length, whole.length);
  rows.forEach((row, i) => assert.ok(Math.abs(row[3] - whole[i]) <= 1e-9 * 11, `row ${i}: ${row[3]}, ${whole[i]}`));
  // The panel shows the orbit of the turn at the cursor, which begins at the mark.
  const orbit = await table(page, '.panel-run-orbit');
  const times = exported('fast', 'orbit_time').rows.map((row) => row.at(-1));
  const best = times.reduce((least, at, i) => (Math.abs(at - 80) < Math.abs(times[least] - 80) ? i : least), 0);
  const samples = exported('fast', 'orbit').rows.slice(best * 128, (best + 1) * 128);
  assert.equal(orbit.rows.length, 128);
  orbit.rows.forEach(([, x, y], k) => {
    assert.ok(Math.abs(x - samples[k].at(-2)) <= 1e-9 && Math.abs(y - samples[k].at(-1)) <= 1e-9);
  });
  assert.match(page.url(), /runup\.rate/);
  // The panel shows the spectrum nearest to that time.
  const spectrum = await table(page, '.panel-run-spectrum');
  assert.ok(spectrum.rows.length > 100);
  // Reset the parameters to the case.
  await page.click('.run [aria-label="Reset all parameters to the case"], .run >> text=Reset all');
  await computed(page);
  assert.deepEqual(complaints, []);
  await close();
});

const DRIVEN = `whirl: 1
title: A rotor that a motor drives past a stator
rotor:
  speed: 2 rad/s
  length_scale: 0.5 m
  stations:
    disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: 0.1 m}
  elements:
    - spring: {between: [disc, ground], stiffness: 1 N/m}
    - rub:    {at: disc, gap: 0.12 m, stiffness: 3 N/m, friction: 0.05, law: paper, radius: 0.7 m}
    - gravity: 0.2 m/s2
    - drive:  {inertia: 3 kg.m2, torque: 0.2 N.m, no_load_speed: 2 rad/s, load_quadratic: 0.01 N.m.s2}
study:
  runup: {duration: 100 s, samples: 64, orbits: 10}
`;

/// Compares the panels of a turn with the fields of a result file in the turn nearest to a time.
async function compareTurn(page, name, time, tolerance) {
  const SAMPLES = 64;
  // Rows are matched by their numbers: the export leaves out rows without values.
  const away = (row) => Math.abs(row.at(-1) - time);
  const { rows: turns } = exported(name, 'orbit_time');
  const turn = turns.reduce((best, row) => (away(row) < away(best) ? row : best))[2] - 1;
  const part = (field, columns) => {
    const { heading, rows } = exported(name, field);
    const number = heading.indexOf('row');
    const own = rows.filter((row) => row[number] > turn * SAMPLES && row[number] <= (turn + 1) * SAMPLES);
    return own.map((row) => row.slice(-columns));
  };
  const near = (found, expected, scale, what) => {
    assert.equal(found.length, SAMPLES, what);
    assert.equal(expected.length, SAMPLES, what);
    found.forEach((row, k) =>
      row.forEach((value, i) =>
        assert.ok(Math.abs(value - expected[k][i]) <= tolerance * scale, `${what} ${k}: ${row}, ${expected[k]}`),
      ),
    );
  };
  const shown = async (panel) => (await table(page, panel)).rows;
  const motion = await shown('.panel-run-motion');
  near(
    motion.map((row) => row.slice(0, 1)),
    motion.map((row, k) => [(360 * k) / SAMPLES]),
    360,
    'angle',
  );
  near(
    motion.map((row) => row.slice(1, 2)),
    part('orbit_instant', 1),
    10,
    'instants',
  );
  near(
    motion.map((row) => row.slice(2)),
    part('orbit', 2),
    1,
    'motion',
  );
  const force = (await shown('.panel-run-force')).map((row) => row.slice(2));
  near(force, part('orbit_force', 1), 1, 'force');
  near(
    (await shown('.panel-run-gap')).map((row) => row.slice(2)),
    part('orbit_gap', 1),
    1,
    'gap',
  );
  const torques = await table(page, '.panel-run-torque');
  const names = ['motor', 'load', 'friction', 'unbalance and weight'];
  assert.deepEqual(
    torques.heading.slice(2),
    names.map((word) => `${word} (N m)`),
  );
  near(
    torques.rows.map((row) => row.slice(2)),
    part('orbit_torque', 5).map((row) => row.slice(0, 4)),
    0.2,
    'torques',
  );
  // Friction is the radius times its share of the force.
  torques.rows.forEach((row, k) => assert.ok(Math.abs(row[4] + 0.7 * 0.05 * force[k][0]) <= 1e-6));
  assert.ok(force.some(([value]) => value > 0));
  assert.ok(force.some(([value]) => value === 0));
}

test('the turn at the cursor has motion, force, gap and torques', async () => {
  const driven = makePage('driven', DRIVEN);
  // Find a turn in which the contact closes and opens.
  const forces = exported('driven', 'orbit_force').rows;
  const ofTurn = (row) => forces.filter((force) => Math.ceil(force[3] / 64) === row[2]).map((force) => force.at(-1));
  const times = exported('driven', 'orbit_time').rows;
  const which = times.findIndex((row) => ofTurn(row).some((value) => value > 0) && ofTurn(row).includes(0));
  const time = times[which].at(-1);
  assert.ok(which > 0 && time > 10);
  const { page, complaints, close } = await opened(`${driven}#t=${time}&units=scale,rad/s,order,0-p`);
  await compareTurn(page, 'driven', time, 1e-6);
  assert.match(await page.textContent('.panel-run-torque .panel-note'), /unbalance and weight/);
  assert.doesNotMatch(await page.textContent('.panel-run-torque .panel-note'), /films and seals/);
  assert.equal((await saved(page, '.panel-run-torque', 'svg')).bytes.toString('utf8').slice(0, 4), '<svg');
  // A time without a kept turn has the motion as a sum of orders, and says how to see the rest.
  await page.fill('#value-run', String(0.5 * (time + times[which + 1].at(-1))));
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /Compute shows it/.test(document.querySelector('.panel-run-force').textContent));
  assert.match(await page.textContent('.panel-run-torque .panel-note'), /no samples of this turn are stored/);
  assert.match(await page.textContent('.panel-run-motion .panel-note'), /sum of orders 1 to 4/);
  // The page computes all turns, with the digits of the command.
  await page.click('.run .pane-value >> text=Compute');
  await computed(page);
  assert.doesNotMatch(await page.textContent('.panel-run-force'), /Compute shows it/);
  await page.fill('#value-run', String(time));
  await page.keyboard.press('Enter');
  await page.waitForFunction((at) => document.querySelector('#value-run').value === String(at), time);
  command('run', 'driven.yaml', '--set', 'runup.orbits=400', '-q', '-o', 'all.h5');
  await compareTurn(page, 'all', time, 1e-9);
  assert.deepEqual(complaints, []);
  await close();
});

test('a run is played, paused and stopped', async () => {
  const { page, complaints, close } = await opened(`${ramp}#t=100&units=scale,rad/s,order,0-p`);
  await page.selectOption('.run [aria-label="Seconds of the run in a second"]', '64');
  await page.click('.run .play');
  await page.waitForFunction(() => Number(document.querySelector('#value-run').value) > 120);
  await page.click('.run .play');
  await page.waitForTimeout(300); // a frame that was already requested is still drawn
  const paused = await page.inputValue('#value-run');
  await page.waitForTimeout(200);
  assert.equal(await page.inputValue('#value-run'), paused);
  // Stop ends a run of many turns.
  await page.fill('[id="parameter-runup.rate"]', '40');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.run.busy');
  await page.click('.run >> text=Stop');
  await page.waitForSelector('.run:not(.busy)');
  await page.fill('[id="parameter-runup.rate"]', '-1');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /number/.test(document.querySelector('.run .settings-card .trouble').textContent));
  assert.deepEqual(complaints, []);
  await close();
});

for (const colorScheme of ['light', 'dark'])
  test(`axe finds nothing, and nothing is cut, ${colorScheme}`, async () => {
    for (const viewport of [
      { width: 1280, height: 800 },
      { width: 390, height: 780 },
    ]) {
      const { page, complaints, close } = await opened(`${ramp}#t=300`, { colorScheme, viewport });
      await page.click('.run .pane-value >> text=Compute');
      await computed(page);
      assert.deepEqual(await axeFindings(page), []);
      assert.equal(await beyondWindow(page), 0);
      assert.deepEqual(complaints, []);
      await close();
    }
  });

test('bands of tolerances are shaded over the time', async () => {
  const [FROM, TO, SAMPLES] = [0.5, 1.5, 128];
  const text = RAMP.replace('rotor:', 'parameters: {e: 1 m}\nrotor:')
    .replace('eccentricity: 1 m', 'eccentricity: = e')
    .replace(/ {4}- rub.*\n/, '')
    .replace('700 s}', '700 s, rows: 40}');
  const study = `  tolerances: {parameters: {e: {from: ${FROM} m, to: ${TO} m}}, samples: ${SAMPLES}}\n`;
  const { page, complaints, close } = await opened(makePage('ramp-bands', text + study) + '#part=runup');
  const [{ bands }] = JSON.parse(await page.textContent('#whirl-runs'));
  assert.deepEqual(
    bands.map(({ parameter, field, column }) => [parameter, field, column]),
    [
      ['time', 'runup/amplitude', 0],
      ['time', 'runup/amplitude', 1],
      ['time', 'runup/radius', 0],
    ],
  );
  // Without a rub the motion is proportional to the eccentricity, whose quantiles are known. The run of the case itself
  // has the eccentricity 1 m.
  const { heading, rows } = exported('ramp-bands', 'amplitude');
  const [number, first] = ['row', 'x1'].map((word) => heading.findIndex((name) => name.startsWith(word)));
  assert.equal(bands[0].places.length, 40);
  assert.ok(rows.length > 30);
  for (const row of rows) {
    const [time, ...quantiles] = bands[0].places[row[number] - 1];
    [0.05, 0.25, 0.5, 0.75, 0.95].forEach((share, i) => {
      const expected = row[first] * (FROM + share * (TO - FROM));
      const tolerance = row[first] * (2 / SAMPLES) * (TO - FROM) + 1e-6;
      assert.ok(Math.abs(quantiles[i] - expected) < tolerance, `at ${time} s ${quantiles[i]}, expected ${expected}`);
    });
  }
  assert.match(await page.textContent(`${card('The run over the time')} .legend`), /tolerances.*median of 128 samples/);
  assert.doesNotMatch(await page.textContent(`${card('The run over the speed')} .legend`), /tolerances/);
  assert.deepEqual(complaints, []);
  await close();
});
