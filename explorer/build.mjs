// Builds the explorer's template, one self-contained page:  node build.mjs [--worker FILE --core FILE] OUT.html
//
// The page contains everything: the program and the styles, whose hashes the Content-Security-Policy names, and the
// worker's program and the C core (gzip, base64) as inert text. `whirl report` replaces @WHIRL-RUNS@ by results.
// Without --worker and --core the page shows what is stored and computes nothing.
import { createHash } from 'node:crypto';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [`${here}/${entry}`],
    bundle: true,
    minify: true,
    write: false,
    charset: 'utf8',
    target: ['chrome100', 'firefox115', 'safari16.4'],
    loader: { '.yaml': 'text' },
    logLevel: 'warning',
    ...options,
  });
  return result.outputFiles[0].text;
}

const hash = (text) => `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;

/// Returns a text for a script or style element; throws an error if the text would end the element.
function inert(text, what) {
  if (/<\/(script|style)|<!--/i.test(text)) throw new Error(`${what} would end its element in the page`);
  return text;
}

const { values: parts, positionals } = parseArgs({
  options: { worker: { type: 'string' }, core: { type: 'string' } },
  allowPositionals: true,
});
const [out] = positionals;
if (!out || positionals.length > 1 || !parts.worker !== !parts.core) {
  console.error('usage: node build.mjs [--worker FILE --core FILE] OUT.html');
  process.exit(2);
}

const script = inert(await bundle('src/main.ts', { format: 'iife' }), 'the program');
const style = inert(await bundle('src/style.css'), 'the style sheet');
const worker = parts.worker ? inert(await readFile(parts.worker, 'utf8'), 'the worker') : '';
const core = parts.core ? gzipSync(await readFile(parts.core), { level: 9 }).toString('base64') : '';
const pieces = {
  '@SCRIPT-HASH@': hash(script),
  '@STYLE-HASHES@': hash(style),
  '@STYLE@': style,
  '@SCRIPT@': script,
  '@WORKER@': worker,
  '@CORE@': core,
};
// Replace all marks in one pass, so that the inserted texts are not searched for marks.
const page = (await readFile(`${here}/src/page.html`, 'utf8')).replace(/@[A-Z-]+@/g, (mark) => pieces[mark] ?? mark);
if (page.split('@WHIRL-RUNS@').length !== 2) throw new Error('the page must have one place for results');
await mkdir(dirname(out), { recursive: true });
await writeFile(`${out}.part`, page);
await rename(`${out}.part`, out);
console.log(`${out}: ${(page.length / 1e6).toFixed(2)} MB`);
