// Implements the browser's Worker with node's worker threads, so that tests run the engine without a browser.
import { Worker as Thread } from 'node:worker_threads';

const prelude = `
const { parentPort } = require('node:worker_threads');
globalThis.self = globalThis;
globalThis.location = { href: 'blob:' };
globalThis.postMessage = (message, transfer) => parentPort.postMessage(message, transfer);
// Node handles all messages of one port before those of the next; a browser alternates between ports.
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

/// Installs Worker, and the functions of Blob and URL that make the addresses of workers.
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
