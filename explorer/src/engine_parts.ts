// The engine's parts lie in the page as inert text: the worker's program, and the C core, packed and as base64.
import { bytesOf } from './data/run';
import { startEngine } from './engine/engine';
import type { Engine } from './engine/protocol';

export interface Waking {
  readonly engine: Engine | undefined;
  /// What is missing, "" when nothing is.
  readonly missing: string;
}

const NOT_BUILT = 'This page was built without the compiled core: it shows what is stored and computes nothing.';
const TOO_OLD = 'This browser is too old for the compiled core: the page shows what is stored and computes nothing.';

function textOf(id: string): string {
  return document.getElementById(id)?.textContent ?? '';
}

async function unpacked(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function wakeEngine(): Promise<Waking> {
  const [worker, core] = [textOf('whirl-worker'), textOf('whirl-core')];
  if (!worker || !core) return { engine: undefined, missing: NOT_BUILT };
  if (typeof WebAssembly === 'undefined' || typeof DecompressionStream === 'undefined') return { engine: undefined, missing: TOO_OLD };
  return { engine: startEngine({ worker, core: await unpacked(bytesOf(core)) }), missing: '' };
}
