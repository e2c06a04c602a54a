/* The ear in the thread of the sound: each block of samples goes in, and the bytes of each new frame go to the page. */
import { EarModel } from "./ear.js";

class EarProcessor extends AudioWorkletProcessor {
  constructor({ processorOptions: { code, preset } }) {
    super();
    this.ear = new EarModel(new WebAssembly.Module(code), preset).ear(sampleRate);
    this.message = new Uint8Array(this.ear.slots[0].length);
  }

  /* Called for every 128 samples: nothing is allocated here. */
  process(inputs) {
    const channels = inputs[0];
    if (channels.length === 0) return true; // nothing is connected yet
    const n = this.ear.take(channels[0]);
    for (let k = 0; k < n; k++) {
      this.message.set(this.ear.slots[k]);
      this.port.postMessage(this.message);
    }
    return true;
  }
}

registerProcessor("phoneme-ear", EarProcessor);
