// SPDX-License-Identifier: MIT
/*
 * The recogniser in the audio thread: each block of samples goes in, and the bytes of each new frame go to the page. It
 * compiles and opens nothing: the page hands over the module, compiled, and the memory of one in which a recogniser is open.
 * Needs no other file; ear.js holds a copy of it, and fetches this one only where a page asks for it by its address.
 */
class EarProcessor extends AudioWorkletProcessor {
  constructor({ processorOptions: { module, memory, ear, samples, mostSamples, frames, frameBytes, room, count } }) {
    super();
    const c = new WebAssembly.Instance(module, {}).exports;
    c.memory.grow((memory.byteLength - c.memory.buffer.byteLength) / 65536);
    const bytes = new Uint8Array(c.memory.buffer);
    bytes.set(new Uint8Array(memory));
    this.push = (n) => c.ear_push(ear, samples, n, frames, room, count);
    this.samples = new Float32Array(bytes.buffer, samples, mostSamples);
    this.count = new Uint32Array(bytes.buffer, count, 1);
    const slot = (_, k) => new Uint8Array(bytes.buffer, frames + frameBytes * k, frameBytes);
    this.slots = Array.from({ length: room }, slot);
    this.message = new Uint8Array(frameBytes);
    this.isOpen = true;
    this.port.onmessage = () => (this.isOpen = false); // the page has closed the node
  }

  /* Called for every 128 samples: nothing is allocated here. */
  process(inputs) {
    const channels = inputs[0];
    if (!this.isOpen || channels.length === 0) return this.isOpen; // nothing is connected yet
    this.samples.set(channels[0]);
    this.push(channels[0].length);
    for (let k = 0; k < this.count[0]; k++) {
      this.message.set(this.slots[k]);
      this.port.postMessage(this.message);
    }
    return true;
  }
}

registerProcessor("phoneme-ear", EarProcessor);
