// Tests the engine in node's workers: it has the numbers and verdicts of `whirl run`, and answers all requests of a
// page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { build } from 'esbuild';
import { installWorkers } from './node_worker.mjs';
import { LONG, PARTS, POINTS, SHORT, caseText, run, sectionDifference, withStudy } from './support.mjs';

let engine, startEngine, fieldNumbers;

async function load(entry) {
  const { outputFiles } = await build({
    entryPoints: [new URL(`../../src/engine/${entry}.ts`, import.meta.url).pathname],
    bundle: true,
    format: 'esm',
    write: false,
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

const parts = () => ({
  worker: readFileSync(`${PARTS}/worker.js`, 'utf8'),
  core: new Uint8Array(readFileSync(`${PARTS}/whirl.wasm`)),
  workers: 2,
});

before(async () => {
  installWorkers();
  ({ startEngine } = await load('engine'));
  ({ fieldNumbers } = await load('protocol'));
  engine = startEngine(parts());
});
after(() => engine.close());

async function good(outcome) {
  const result = await outcome;
  assert.ok(result.ok, JSON.stringify(result));
  return result.value;
}

for (const { name, parameter, values } of POINTS) {
  // Results differ only by rounding: the command fuses multiply-adds, a browser does not.
  test(`${name}: 20 revolutions agree to 1e-9`, async () => {
    const text = withStudy(name, parameter, values, SHORT);
    const reported = run(text);
    for (const [i, value] of values.entries()) {
      const result = await good(engine.point({ setting: { text }, parameter, value, batch: 'detail' }));
      const difference = sectionDifference(result, fieldNumbers, reported.detail[i]);
      assert.ok(difference < 1e-9, `${parameter} = ${value}: sections differ by ${difference}`);
    }
  });

  // The command's kernels of 128 bits do not fuse multiply-adds either, so no bit differs, with any method.
  const record = SHORT.record;
  for (const integrate of [
    { method: 'rk4', steps_per_revolution: 512 },
    { method: 'rk4', steps_per_revolution: 256, contacts: 'located' },
    { method: 'dop853', steps_per_revolution: 64, rtol: 1e-9 },
  ])
    test(`${name}: ${integrate.method} ${integrate.contacts ?? ''} has the bits of the command's kernels`, async () => {
      const text = withStudy(name, parameter, values, { integrate, record });
      const reported = run(text, 'simd128');
      for (const [i, value] of values.entries()) {
        const result = await good(engine.point({ setting: { text }, parameter, value, batch: 'detail' }));
        assert.equal(sectionDifference(result, fieldNumbers, reported.detail[i]), 0, `${parameter} = ${value}`);
        assert.equal(result.options.located, integrate.contacts === 'located');
      }
    });

  test(`${name}: verdicts agree, and what settled motions show`, async () => {
    const text = withStudy(name, parameter, values, LONG);
    const reported = run(text);
    for (const [i, value] of values.entries()) {
      const result = await good(engine.point({ setting: { text }, parameter, value, batch: 'detail' }));
      const theirs = reported.detail[i];
      assert.equal(result.verdict.name, theirs.verdict, `${parameter} = ${value}: ${result.verdict.reason}`);
      assert.equal(result.verdict.confidence, theirs.confidence);
      assert.equal(result.speed, parameter === 'omega' ? value : reported.speed);
      if (theirs.regime !== 'periodic') continue;
      assert.ok(sectionDifference(result, fieldNumbers, theirs) < 1e-7, `${parameter} = ${value}: sections differ`);
      result.stations.forEach((station, which) => {
        const [radius] = fieldNumbers(result.layout, result.block, 'orbit/max_radius', which);
        assert.ok(Math.abs(radius - theirs.stations[station.name].max_radius) < 1e-7);
        // Compare the strongest line, and the spectrum at the order of that line.
        const [order, x] = fieldNumbers(result.layout, result.block, 'spectrum/lines', which);
        assert.ok(Math.abs(order - theirs.spectrum[station.name][0].order) < 1e-6);
        assert.ok(Math.abs(x - theirs.spectrum[station.name][0].x) < 1e-6);
      });
    }
  });
}

// A sweep computes points in lanes, in another order, on several workers; each has the numbers of a point that is
// computed alone.
test('points of a sweep are those of the command', async () => {
  const values = [0.9, 0.75, 0.6, 0.4];
  const text = withStudy('paper', 'r_k', values, SHORT);
  const reported = run(text);
  const all = Float64Array.from({ length: 40 }, (_, i) => values[i % 4]);
  const seen = new Map();
  let layout;
  const result = await good(
    engine.sweep(
      { setting: { text }, parameter: 'r_k', values: all },
      {
        layout: (given, slots) => {
          layout = given;
          assert.equal(slots, 40);
        },
        points: ({ slots, blocks, verdicts }) =>
          slots.forEach((slot, i) => {
            assert.ok(!seen.has(slot));
            assert.equal(typeof verdicts[i].name, 'string');
            seen.set(slot, blocks.slice(i * layout.size, (i + 1) * layout.size));
          }),
      },
    ),
  );
  assert.deepEqual(result.layout, layout);
  assert.equal(seen.size, 40);
  for (const [slot, block] of seen)
    assert.ok(
      sectionDifference(
        { stations: [{ name: 'disc' }, { name: 'journal' }], layout, block },
        fieldNumbers,
        reported.detail[slot % 4],
      ) < 1e-9,
    );
});

// Two bearing seats: the first one's damping rate is 1e5 times the speed, so that the system is stiff; the second is
// not.
for (const [damping, method] of [
  ['1e7 N.s/m', 'rodas5p'],
  ['100 N.s/m', 'dop853'],
])
  test(`method auto takes ${method}, as the command does`, async () => {
    const text = `whirl: 1
rotor:
  speed: 100 rad/s
  length_scale: 1 mm
  stations:
    disc: {mass: 10 kg, damping: 100 N.s/m, eccentricity: 0.1 mm}
    seat: {mass: 1 kg, damping: ${damping}}
  elements:
    - shaft: {between: [disc, seat], k1: 0.2 MN/m}
    - spring: {between: [seat, ground], stiffness: 0.5 MN/m}
study:
  response: {}
  integrate: {transient: 0, record: 20}
`;
    const reported = run(text, 'simd128');
    assert.equal(reported.integrated.response.method, method);
    const whole = await good(engine.point({ setting: { text }, parameter: '' }));
    const look = { transient: 0, record: 10, stepsPerRevolution: 64 };
    const looked = await good(engine.point({ setting: { text, look }, parameter: '' }));
    for (const { options } of [whole, looked])
      assert.deepEqual([options.method, options.method_chosen], [method, true]);
    assert.ok(sectionDifference(whole, fieldNumbers, reported.points[0]) < 1e-12);
  });

// Every watched number of stations and contacts can be shown over the parameter.
test('a diagram has a quantity for every number of its stations and contacts', async () => {
  const { Diagram } = await load('../data/diagram');
  const { quantitiesOf, quantityOf } = await load('../data/quantities');
  const text = withStudy('paper', 'r_k', [0.6, 0.45], SHORT);
  const values = Float64Array.of(0.6, 0.45);
  const diagram = Diagram.awaited('r_k', values, new Int8Array(2));
  const { layout } = await good(
    engine.sweep(
      { setting: { text }, parameter: 'r_k', values },
      { layout: (given) => diagram.expect(given), points: (points) => diagram.take(points, (slot) => slot) },
    ),
  );
  const units = { length: 'scale', speed: 'rad/s', frequency: 'order', amplitude: '0-p' };
  const listed = quantitiesOf(diagram);
  assert.equal(new Set(listed.map(({ id }) => id)).size, listed.length);
  const watched = layout.fields.filter(({ name }) => /^(orbit|rub)\//.test(name) && name !== 'rub/contact');
  assert.ok(watched.length >= 10);
  for (const { name, columns, extent } of watched) {
    const found = listed.filter(({ id, field }) => id.split(':')[0] === name || field === name);
    assert.equal(found.length, columns, name);
    found.forEach(({ id, perStation }, column) => {
      assert.equal(perStation, extent === 'station');
      // The second station is the journal: the disc has no eccentricity ratio.
      const shown = quantityOf(diagram, id, 1, [{ name: 'disc' }, { name: 'journal' }], units, 'c');
      for (const point of [0, 1]) {
        const number = diagram.number(point, name, extent === 'station' ? 1 : 0, column);
        // The friction torque is unknown, as the case gives no radius of the shaft.
        const known = !/^rub\/(max_torque|torque|power)$/.test(name);
        assert.equal(Number.isFinite(number), known, `${name} of point ${point}`);
        assert.equal(shown.column.data[point] * shown.factor, number, shown.label);
      }
    });
  }
});

test('a carried sweep follows the attractor there and back, as the command does', async () => {
  const values = [0.1, 0.15, 0.2, 0.25, 0.3];
  const text = withStudy('rigid-rotor', 'rho', values, { ...LONG, start: 'carry, direction: both' });
  const reported = run(text);
  const verdicts = [];
  await good(
    engine.sweep(
      {
        setting: { text },
        parameter: 'rho',
        values: Float64Array.from(reported.points.slice(0, 5), (point) => point.parameters.rho),
        carry: 'both',
      },
      { points: (points) => points.slots.forEach((slot, i) => (verdicts[slot] = points.verdicts[i].name)) },
    ),
  );
  assert.deepEqual(
    verdicts,
    reported.points.map((point) => point.verdict),
  );
});

test('the case layer says what the command says', async () => {
  const wrong = await engine.describe({ text: 'whirl: 1\nrotor: {speed: 3 m}\n', name: 'x.yaml' });
  assert.equal(wrong.ok, false);
  assert.equal(wrong.why, 'bad');
  const speed = wrong.problems.find((problem) => problem.key === 'rotor.speed');
  assert.deepEqual([speed.line, speed.column], [2, 16]);
  assert.equal(speed.message, 'is in m, expected a unit of rad/s');
  const setting = { text: caseText('paper') };
  const far = await engine.describe({ ...setting, assignments: ['r_kk=0.3'] });
  assert.match(far.message, /no parameter is called r_kk, did you mean r_k\?/);
  const unit = await engine.describe({ ...setting, assignments: ['omega=50 Hz'] });
  assert.match(unit.message, /expected a unit of rad\/s, such as rpm/);
});

test('a case tells its parameters, stations and study', async () => {
  const reported = await good(engine.describe({ text: caseText('paper'), assignments: ['omega=6000 rpm'] }));
  const omega = reported.parameters.find((parameter) => parameter.name === 'omega');
  assert.equal(omega.written, '6000 rpm');
  assert.ok(Math.abs(omega.value - 200 * Math.PI) < 1e-10);
  assert.ok(Math.abs(reported.speed - 200 * Math.PI) < 1e-10);
  assert.equal(omega.comment, 'rotation speed');
  assert.equal(omega.uses.find((use) => use.alone).path, 'rotor.speed');
  const common = { shaft: 0, position: 0, along_y: false, twists: false, clockwise: false };
  assert.deepEqual(reported.stations, [
    { ...common, name: 'disc', clearance: 0, gap: 1.2, x: 0, y: 1, vx: 4, vy: 5 },
    { ...common, name: 'journal', clearance: 1, gap: 0, x: 2, y: 3, vx: 6, vy: 7 },
  ]);
  assert.deepEqual(reported.contacts, ['rub at disc']);
  assert.equal(reported.batches[0].parameter, 'r_k');
  assert.equal(reported.batches[0].values.length, 512);
});

test('a motion goes on from where it was, and flashes its contacts', async () => {
  const setting = { text: caseText('paper') };
  const request = { setting, parameter: 'r_k', value: 0.2, samplesPerRevolution: 32 };
  const whole = await good(engine.transient({ ...request, revolutions: 12 }));
  const first = await good(engine.transient({ ...request, revolutions: 5 }));
  const rest = await good(engine.transient({ ...request, revolutions: 7, state: first.state }));
  assert.deepEqual(rest.state, whole.state);
  assert.equal(whole.samples.length, 12 * 32 * 8);
  assert.deepEqual(whole.samples.slice(-8), whole.state);
  const radius = Math.hypot(whole.samples[8 * 40], whole.samples[8 * 40 + 1]);
  assert.equal(whole.forces[40] > 0, radius > 1.2);
});

test('a setting becomes a case that means the same', async () => {
  const setting = { text: caseText('paper'), assignments: ['r_k=0.42', 'c=250 um'] };
  const text = await good(engine.rewrite(setting, [{ path: 'study.sweep.from', text: '0.5' }]));
  assert.match(text, /r_k: {5}0\.42 +# k1\/k2/);
  const reported = await good(engine.describe({ text }));
  assert.equal(reported.parameters.find((parameter) => parameter.name === 'r_k').value, 0.42);
  assert.equal(reported.parameters.find((parameter) => parameter.name === 'c').value, 250e-6);
  assert.equal(reported.batches[0].values[0], 0.5);
  const wrong = await engine.rewrite(setting, [{ path: 'study.sweep.points', text: 'many' }]);
  assert.equal(wrong.why, 'bad');
});

test('a later request makes an earlier one of its lane stale, at once', async () => {
  const setting = { text: caseText('paper'), options: { transient: 1000000 } };
  const values = Float64Array.from({ length: 500 }, (_, i) => 0.1 + i / 1000);
  const sweep = engine.sweep({ setting, parameter: 'r_k', values }, {}, { lane: 'diagram' });
  const point = engine.point({ setting, value: 0.5 }, { lane: 'point' });
  const began = performance.now();
  const reported = engine.describe(setting, { lane: 'point' });
  assert.deepEqual(await point, { ok: false, why: 'stale' });
  await good(reported);
  assert.ok(performance.now() - began < 5000);
  engine.cancel('diagram');
  assert.deepEqual(await sweep, { ok: false, why: 'stale' });
  const aborted = new AbortController();
  const other = engine.point({ setting, value: 0.5 }, { signal: aborted.signal });
  aborted.abort();
  assert.deepEqual(await other, { ok: false, why: 'stale' });
});

test('what cannot be computed is refused with a sentence', async () => {
  const setting = { text: caseText('paper') };
  const cases = [
    [
      { setting: { ...setting, options: { method: 'rk5' } }, value: 0.5 },
      /no method is called 'rk5', did you mean 'rk4'\?/,
    ],
    [{ setting: { ...setting, options: { method: 'cvode-bdf' } }, value: 0.5 }, /SUNDIALS/],
    [
      { setting: { ...setting, options: { steps_per_revolution: 0 } }, value: 0.5 },
      /steps_per_revolution is 0, expected a whole/,
    ],
    [{ setting: { ...setting, options: { record: 2.5 } }, value: 0.5 }, /record is 2.5, expected a whole number/],
    [{ setting: { ...setting, options: { record: -1 } }, value: 0.5 }, /expected/],
    [{ setting, parameter: 'nobody', value: 0.5 }, /no parameter is called nobody/],
    [{ setting, parameter: 'c', value: -1 }, /at c = -1/],
    [{ setting, batch: 'nothing', value: 0.5 }, /no batch/],
  ];
  for (const [request, sentence] of cases) {
    const outcome = await engine.point(request);
    assert.equal(outcome.why, 'bad', JSON.stringify(request.setting.options));
    assert.match(outcome.message, sentence);
  }
  const empty = await engine.sweep({ setting, parameter: 'r_k', values: new Float64Array(0) });
  assert.equal(empty.ok, false);
});

test('an engine that cannot start says so', async () => {
  const broken = startEngine({ ...parts(), core: new Uint8Array(8) });
  const outcome = await broken.describe({ text: '' });
  assert.equal(outcome.why, 'failed');
  assert.match(outcome.message, /cannot start/);
  broken.close();
});

// At these values the paper's rotor has long transients, some of which a run of 400 + 100 revolutions with 256 steps
// judges as chaos.
test('a first look has no verdict where a longer run may have another', async () => {
  const setting = { text: caseText('paper') };
  const short = { transient: 400, record: 100, watch: 0, settle: true };
  const look = { transient: 400, record: 100, stepsPerRevolution: 256 };
  let chaotic = 0;
  for (let i = 0; i < 16; i++) {
    const point = { parameter: 'r_k', value: 0.316 + (0.068 * i) / 15 };
    const hasty = await good(
      engine.point({ setting: { ...setting, options: { steps_per_revolution: 256, ...short } }, ...point }),
    );
    const looked = await good(engine.point({ setting: { ...setting, look }, ...point }));
    chaotic += hasty.verdict.regime === 'chaotic' ? 1 : 0;
    assert.equal(hasty.verdict.provisional, false, 'what was asked for has a verdict');
    assert.deepEqual(
      [looked.verdict.regime, looked.verdict.confidence, looked.verdict.provisional],
      ['undetermined', 'low', true],
    );
    assert.match(
      looked.verdict.reason,
      /400 \+ 100 revolutions of 256 steps; a verdict takes the 1100 \+ 100 of 1024 steps/,
    );
    assert.equal(fieldNumbers(looked.layout, looked.block, 'regime/code')[0], 0);
    // The preview has the motion and the evidence of the short run.
    assert.deepEqual(
      fieldNumbers(looked.layout, looked.block, 'poincare/section'),
      fieldNumbers(hasty.layout, hasty.block, 'poincare/section'),
    );
    assert.deepEqual(
      fieldNumbers(looked.layout, looked.block, 'regime/exponent'),
      fieldNumbers(hasty.layout, hasty.block, 'regime/exponent'),
    );
  }
  assert.ok(chaotic > 0, 'a short run takes some for chaos');
});

// A preview with the steps of the case keeps its verdict if the motion settles early: a longer run would settle alike.
test('a first look keeps the verdict of a motion that has ended by itself', async () => {
  const setting = { text: caseText('paper') };
  const whole = await good(engine.point({ setting, parameter: 'r_k', value: 0.8 }));
  const looked = await good(
    engine.point({
      setting: { ...setting, look: { transient: 400, record: 100, stepsPerRevolution: 0 } },
      parameter: 'r_k',
      value: 0.8,
    }),
  );
  assert.equal(whole.verdict.regime, 'periodic');
  assert.deepEqual([looked.verdict.name, looked.verdict.provisional], [whole.verdict.name, false]);
});

// ---- measured numbers, compared with closed forms

const WHEEL = `whirl: 1
title: A wheel
parameters: {n: 1500 rpm}
rotor:
  speed: = n
  length_scale: 1 mm
  stations:
    disc: {mass: 1 kg}
  elements:
    - shaft: {between: [disc, ground], k1: 1 MN/m, k2: 1 MN/m}
study: {response: {}}
`;
const within = (found, expected, tolerance, what) =>
  assert.ok(Math.abs(found - expected) <= tolerance, `${what} is ${found}, expected ${expected}`);

test('vectors of two probes are what any probe between them sees', async () => {
  const { MeasuredData } = await load('../data/measured');
  // x = 3 cos(t - 20), y = 2 cos(t - 110 deg) by probes at 30 and 100 degrees.
  const seen = (probe) => {
    const at = (degrees) => (degrees * Math.PI) / 180;
    const parts = ['cos', 'sin'].map(
      (part) => 3 * Math.cos(at(probe)) * Math[part](at(20)) + 2 * Math.sin(at(probe)) * Math[part](at(110)),
    );
    return [Math.hypot(...parts), ((Math.atan2(parts[1], parts[0]) * 180) / Math.PI + 360) % 360];
  };
  const text =
    'speed [rpm]; disc 30 [um]; disc 30 lag [deg]; disc 100 [um]; disc 100 lag [deg]\n' +
    `600; ${seen(30).join(';')}; ${seen(100).join(';')}\n`;
  const data = new MeasuredData(
    'm.csv',
    await good(engine.measured({ text: WHEEL }, 'm.csv', new TextEncoder().encode(text), [])),
  );
  assert.deepEqual([data.kind, data.stations], ['vectors', [0]]);
  within(data.at[0], (600 * Math.PI) / 30, 1e-12, 'the speed');
  for (const probe of [0, 45, 90, 30, 210]) {
    const { amplitudes, lags } = data.seen(0, probe);
    within(amplitudes[0], seen(probe)[0] * 1e-6, 1e-16, `the amplitude at ${probe}`);
    within(lags[0], seen(probe)[1], 1e-8, `the lag at ${probe}`);
  }
  assert.equal(data.seen(0, 0, 2), undefined);
});

test('spectra of measured motions have the amplitudes of their parts', async () => {
  // Forward 5 at 1X and backward 2 at 2X, as an orbit of 2 revolutions and as 20 turns over the time at 25 Hz.
  const at = (turn) => {
    const angle = 2 * Math.PI * turn;
    return [5 * Math.cos(angle - 1) + 2 * Math.cos(2 * angle), 5 * Math.sin(angle - 1) - 2 * Math.sin(2 * angle)];
  };
  for (const [turns, tolerance] of [
    [Float64Array.from({ length: 128 }, (_, i) => i / 64), 1e-12],
    [Float64Array.from({ length: 3001 }, (_, i) => (25 * i) / 3750 + 0.013), 1e-4],
  ]) {
    const [x, y] = [0, 1].map((axis) => turns.map((turn) => at(turn)[axis]));
    const rows = await good(engine.measuredSpectrum({ turns, x, y }));
    const row = (order) => {
      const place = Array.from({ length: rows.length / 5 }, (_, i) => i).find((i) => rows[5 * i] === order);
      return rows.subarray(5 * place, 5 * place + 5);
    };
    [
      [1, 5, 5, 5, 0],
      [2, 2, 2, 0, 2],
    ].forEach((expected) =>
      expected.forEach((value, column) => within(row(expected[0])[column], value, tolerance, `column ${column}`)),
    );
  }
  const short = await engine.measuredSpectrum({
    turns: new Float64Array(3),
    x: new Float64Array(3),
    y: new Float64Array(3),
  });
  assert.match(short.message, /fewer than 8 samples/);
});

test('a measured motion of several revolutions is moved to where it differs least', async () => {
  const { alignment } = await load('../data/measured');
  const [per, period] = [64, 3];
  const wave = (turn) => Math.cos(2 * Math.PI * turn) + Math.cos((2 * Math.PI * turn) / 3);
  // Sample i of the computed motion is (i + 1)/per revolutions after a mark.
  const x = Float64Array.from({ length: per * period }, (_, i) => wave((i + 1) / per));
  const turns = Float64Array.from({ length: 96 }, (_, i) => i / 32);
  const measured = { name: '', turns, x: turns.map((turn) => wave(turn + 2) + 0.1) };
  const { moved, rms } = alignment(measured, { x, y: x }, per, period);
  assert.equal(moved, 2);
  within(rms, 0.1, 1e-9, 'the difference');
});
