// Reads the engine's parts, stored in the page as inert text: the worker's program, and the C core (compressed,
// base64).
import { bytesOf } from './data/run';
import { startEngine } from './engine/engine';
import type { Engine } from './engine/protocol';

export interface Waking {
  readonly engine: Engine | undefined;
  /// Name of a missing part, or "".
  readonly missing: string;
}

const NOT_BUILT = 'This page was built without the compiled core: it shows what is stored and computes nothing.';
const TOO_OLD = 'This browser is too old for the compiled core: the page shows what is stored and computes nothing.';

/// Returns the message of a page whose engine does not start.
function notStarted(why: string): string {
  return (
    `The compiled core does not start (${why}): this page shows what is stored and computes nothing. If a server ` +
    'sent it, the Content-Security-Policy in its answer must allow worker-src blob: and script-src ' +
    `'wasm-unsafe-eval'; saved and opened from disk the page needs nothing.`
  );
}

function textOf(id: string): string {
  return document.getElementById(id)?.textContent ?? '';
}

async function unpacked(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// Starts the engine; `broken` is called later with the reason if the engine fails.
export async function wakeEngine(broken: (why: string) => void): Promise<Waking> {
  const [worker, core] = [textOf('whirl-worker'), textOf('whirl-core')];
  if (!worker || !core) return { engine: undefined, missing: NOT_BUILT };
  if (typeof WebAssembly === 'undefined' || typeof DecompressionStream === 'undefined')
    return { engine: undefined, missing: TOO_OLD };
  try {
    return {
      engine: startEngine({ worker, core: await unpacked(bytesOf(core)), broken: (why) => broken(notStarted(why)) }),
      missing: '',
    };
  } catch (error) {
    return { engine: undefined, missing: notStarted(String(error)) };
  }
}
