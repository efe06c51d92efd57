// The engine's parts lie in the page as inert text: the worker's program, and the C core, packed and as base64.
import type { Engine } from './engine/protocol';

export interface Waking {
  readonly engine: Engine | undefined;
  /// What is missing, "" when nothing is.
  readonly missing: string;
}

const MISSING = 'This page was built without the compiled core: it shows what is stored and computes nothing.';

export async function wakeEngine(): Promise<Waking> {
  return { engine: undefined, missing: MISSING };
}
