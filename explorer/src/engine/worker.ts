// A worker: owns a core and runs tasks in time slices, the most urgent first. Between slices it receives messages that
// make tasks stale.
import { Core, Refused } from './core';
import { Tasks, type Steps } from './tasks';
import type { FromWorker, Task, ToWorker } from './wire';

/// Milliseconds of a slice, in which the worker receives no messages.
const SLICE = 10;

interface Scope {
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

interface Underway {
  readonly id: number;
  readonly priority: number;
  readonly task: Task;
  steps: Steps | null;
}

const scope = globalThis as unknown as Scope;
const underway: Underway[] = [];
const bell = new MessageChannel();
let tasks: Tasks | null = null;
let ringing = false;

/// Schedules the next slice after the waiting messages.
function ring(): void {
  if (ringing || underway.length === 0 || !tasks) return;
  ringing = true;
  bell.port2.postMessage(null);
}

function mostUrgent(): Underway | undefined {
  let chosen = underway[0];
  for (const one of underway) if (chosen && one.priority < chosen.priority) chosen = one;
  return chosen;
}

function remove(id: number): Underway | undefined {
  const at = underway.findIndex((one) => one.id === id);
  return at < 0 ? undefined : underway.splice(at, 1)[0];
}

/// Returns the buffers of a result, which are transferred to the page without a copy.
function buffers(value: unknown): Transferable[] {
  if (value === null || typeof value !== 'object') return [];
  return Object.values(value).flatMap((part) => (part instanceof Float64Array ? [part.buffer as ArrayBuffer] : []));
}

function work(): void {
  const one = mostUrgent();
  if (!one || !tasks) return;
  const until = performance.now() + SLICE;
  try {
    one.steps ??= tasks.run(one.id, one.task);
    do {
      const step = one.steps.next();
      if (!step.done) continue;
      remove(one.id);
      scope.postMessage({ kind: 'done', id: one.id, value: step.value }, buffers(step.value));
      return;
    } while (performance.now() < until);
  } catch (error) {
    remove(one.id);
    if (error instanceof Refused) scope.postMessage({ kind: 'bad', id: one.id, refusal: error.refusal });
    else scope.postMessage({ kind: 'failed', id: one.id, message: `the engine broke: ${String(error)}` });
  }
}

bell.port1.onmessage = () => {
  ringing = false;
  work();
  ring();
};

async function start(binary: Uint8Array): Promise<void> {
  try {
    tasks = new Tasks(await Core.start(binary), (message, transfer) => scope.postMessage(message, transfer));
  } catch (error) {
    scope.postMessage({ kind: 'failed', id: -1, message: `the engine cannot start: ${String(error)}` });
  }
  ring();
}

scope.onmessage = (event) => {
  const message = event.data;
  if (message.kind === 'start') void start(message.core);
  else if (message.kind === 'task') underway.push({ ...message, steps: null });
  else remove(message.id)?.steps?.return(null);
  ring();
};
