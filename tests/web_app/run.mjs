/*
 * Runs the bundled page in Node, for tests: node run.mjs FOLDER SCRIPT RATE, with float32 on the standard input. Answers are
 * the phonemes, as JSON. FOLDER is what a web server would serve; what is fetched from elsewhere, or by another name, fails.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, script, rate] = process.argv.slice(2);
const input = readFileSync(0);
const samples = new Float32Array(input.buffer.slice(input.byteOffset, input.byteOffset + input.length));
const fetchBlob = globalThis.fetch;
let Processor;

globalThis.fetch = async (place) => {
  if (String(place).startsWith("blob:")) return fetchBlob(place);
  return new Response(readFileSync(join(folder, new URL(place, "https://page.example/assets/").pathname)));
};
globalThis.document = { createElement: () => ({ relList: { supports: () => true } }) }; // modules can be preloaded
globalThis.AudioWorkletProcessor = class {
  port = Processor.channel;
};
globalThis.registerProcessor = (_, made) => (Processor = made);

/* Runs a worklet as a browser does: from its text alone, in which nothing can be imported by a relative address. */
async function addModule(place) {
  const text = await (await fetch(place)).text();
  await import(`data:text/javascript,${encodeURIComponent(text)}`);
}

globalThis.AudioWorkletNode = class {
  constructor(_context, _name, { processorOptions }) {
    this.port = { postMessage: (message) => this.processor.port.onmessage({ data: message }) };
    Processor.channel = { postMessage: (data) => this.port.onmessage({ data: data.slice() }) };
    this.processor = new Processor({ processorOptions });
  }
  connect() {}
  disconnect() {}
};

globalThis.OfflineAudioContext = class {
  constructor(_channels, _length, sampleRate) {
    globalThis.sampleRate = this.sampleRate = sampleRate;
    this.audioWorklet = { addModule };
  }
  createBuffer(_channels, length) {
    return { samples: new Float32Array(length), copyToChannel(from) { this.samples.set(from); } };
  }
  createBufferSource() {
    return {
      context: this,
      connect: (node) => (this.node = node),
      disconnect: () => {},
      start: () => {},
      set buffer(given) { globalThis.played = given.samples; },
    };
  }
  async startRendering() {
    const { played } = globalThis;
    for (let at = 0; at + 128 <= played.length; at += 128) this.node.processor.process([[played.subarray(at, at + 128)]]);
  }
};

await import(pathToFileURL(join(folder, script)));
console.log(JSON.stringify(await globalThis.hear(samples, Number(rate))));
