// Workers of a browser on top of node's, so that the engine runs in tests without one.
import { Worker as Thread } from 'node:worker_threads';

const prelude = `
const { parentPort } = require('node:worker_threads');
globalThis.self = globalThis;
globalThis.location = { href: 'blob:' };
globalThis.postMessage = (message, transfer) => parentPort.postMessage(message, transfer);
// Node empties one port before it looks at the next; a browser takes turns.
globalThis.MessageChannel = class {
  port1 = {};
  port2 = { postMessage: () => setImmediate(() => this.port1.onmessage()) };
};
parentPort.on('message', (data) => globalThis.onmessage({ data }));
`;

const programs = new Map();

export class Worker {
  constructor(url) {
    this.thread = new Thread(prelude + programs.get(url), { eval: true });
    this.thread.on('message', (data) => this.onmessage?.({ data }));
    this.thread.on('error', (error) => this.onerror?.({ message: String(error) }));
  }
  postMessage(message) {
    this.thread.postMessage(message);
  }
  terminate() {
    void this.thread.terminate();
  }
}

/// Puts Worker and what makes their URLs in place.
export function installWorkers() {
  globalThis.Worker = Worker;
  globalThis.Blob = class {
    constructor(parts) {
      this.text = parts.join('');
    }
  };
  URL.createObjectURL = (blob) => {
    const url = `blob:${programs.size}`;
    programs.set(url, blob.text);
    return url;
  };
  URL.revokeObjectURL = (url) => programs.delete(url);
}
