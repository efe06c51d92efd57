// Functions that the browser tests share: they make the page of a small run, open it from disk in Chromium, and collect
// its errors.
//
//   tests/run.sh WHIRL TEMPLATE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

export const whirl = process.env.WHIRL;
export const template = process.env.TEMPLATE;
/// The page without results.
export const presets = template && pathToFileURL(template).href;
const program = process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell';

export const CASE = readFileSync(new URL('./rub.yaml', import.meta.url), 'utf8');

/// Returns a case: a wheel with the keys `wheel` at the end of a shaft, a rear bearing with the keys `rear`, and a
/// study of the machine at rest.
export const fan = (rear, wheel, study, parameters = '') => `whirl: 1
title: A fan
parameters: {omega: 1500 rpm${parameters}}
rotor:
  speed: = omega
  length_scale: 0.1 mm
  stations:
    rear:  {position: 0 m}
    wheel: {position: 0.9 m, mass: 40 kg, diametral: 1.1 kg m2, polar: 2 kg m2, eccentricity: 20 um}
  elements:
    - segment: {length: 0.9 m, outer: 60 mm}
    - bearing: {at: rear, ${rear}}
    - bearing: {at: wheel, ${wheel}}
study:
  ${study}
`;

/// A temporary folder, removed when the process exits.
export const folder = mkdtempSync(join(tmpdir(), 'whirl-explorer-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

/// Runs the command whirl; returns its standard output.
export function command(...words) {
  return execFileSync(whirl, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/// Runs a case and makes its page; returns the address of the page.
export function makePage(name, text) {
  writeFileSync(join(folder, `${name}.yaml`), text);
  command('run', `${name}.yaml`, '-q', '-o', `${name}.h5`);
  // Replace gnuplot by the program `true`: the tests need no figures.
  try {
    command('report', `${name}.h5`, '-o', name, '-q', '--gnuplot', 'true', '--explorer', template);
  } catch (failure) {
    if (!existsSync(join(folder, name, 'explorer.html'))) throw failure;
  }
  return pathToFileURL(join(folder, name, 'explorer.html')).href;
}

let browser;

/// Opens a page; `complaints` gathers errors of the console and the page, and requests of the network.
export async function open(address, options = {}) {
  browser ??= await chromium.launch({ executablePath: program, args: ['--no-sandbox', '--disable-gpu'] });
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    ...options,
  });
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(`page: ${error.message}`));
  page.on('dialog', (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(address);
  return { page, complaints, close: () => context.close() };
}

export async function closeBrowser() {
  await browser?.close();
}

/// Waits until a pane shows a whole computation, not a preview; returns the verdict.
export async function settled(page, side = 'a') {
  // Wait for the next frame, in which the page draws its last change.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForFunction(
    (name) => {
      const pane = document.querySelector(`.pane-${name}`);
      const how = pane?.querySelector('.how').textContent; // empty while the engine starts
      return pane && !pane.classList.contains('busy') && /revolutions by/.test(how) && !/quick look/.test(how);
    },
    side,
    { timeout: 60_000 },
  );
  return page.textContent(`.pane-${side} .verdict`);
}

/// Drags over the upper picture of a card in its mode Range, from one share of its width to another.
export async function brush(page, from, to, card = '.map-card') {
  const box = await (await page.$(`${card} .map-main .overlay`)).boundingBox();
  await page.click(`${card} .segments button[value="range"]`);
  await page.mouse.move(box.x + box.width * from, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * to, box.y + 60, { steps: 5 });
  await page.mouse.up();
}

/// Presses an item of a panel's menu; returns the name and the bytes of the downloaded file.
export async function saved(page, panel, kind) {
  await page.waitForTimeout(120); // Chromium drops downloads beyond ten a second
  await page.click(`${panel} .menu summary`);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(`${panel} [data-save="${kind}"]`)]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/// Returns the findings of axe on the page, one line each, without the elements that `exclude` selects.
export async function axeFindings(page, exclude = []) {
  await page.evaluate(readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8'));
  const { violations, passes } = await page.evaluate(
    (left) => window.axe.run({ exclude: left }, { resultTypes: ['violations', 'passes'] }),
    exclude,
  );
  assert.ok(passes.length > 10, 'axe has looked');
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(' ')}: ${failureSummary.replace(/\s+/g, ' ')}`),
  );
}

/// Returns by how many pixels the page is wider than its window.
export const beyondWindow = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
