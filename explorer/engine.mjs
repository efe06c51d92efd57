// Builds the program of the explorer's workers:  node engine.mjs OUT
//
// OUT/worker.js holds explorer/src/engine/worker.ts with OUT/glue.cjs, made by explorer/core next to OUT/whirl.wasm.
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2];
if (!out || process.argv.length > 3) {
  console.error('usage: node engine.mjs OUT');
  process.exit(2);
}
await build({
  entryPoints: [`${here}/src/engine/worker.ts`],
  outfile: `${out}/worker.js`,
  alias: { 'whirl-core-glue': resolve(out, 'glue.cjs') },
  bundle: true,
  minify: true,
  format: 'iife',
  charset: 'utf8',
  target: ['chrome100', 'firefox115', 'safari16.4'],
  logLevel: 'warning',
});
