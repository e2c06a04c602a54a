// SPDX-License-Identifier: MIT
/* The spectrum of the last seconds, a column for each frame of 10 ms, with a band of phonemes beneath. */

const BAND = 26; // pixels of the phonemes
const NAMED = 10; // columns of a phoneme that is long enough for its name
const HIGHEST = 8000; // Hz, at the upper edge
const QUIETEST = -100; // dB that are drawn as nothing
const LOUDEST = -25;

export class Spectrum {
  #context;
  #levels;
  #bins;
  #heard = -1;
  #lasts = 0; // columns of the phoneme that is heard

  constructor(canvas, analyser) {
    this.canvas = canvas;
    this.analyser = analyser;
    this.#context = canvas.getContext("2d", { willReadFrequently: true });
    this.#levels = new Float32Array(analyser.frequencyBinCount);
    this.#bins = (HIGHEST * analyser.fftSize) / analyser.context.sampleRate;
    this.#context.clearRect(0, 0, canvas.width, canvas.height);
  }

  /** Move on by as many columns as there are new frames. */
  draw(frames, names) {
    if (frames.length === 0) return;
    const { width, height } = this.canvas;
    const n = Math.min(frames.length, width);
    const edge = width - n;
    this.#context.globalCompositeOperation = "copy"; // what was there gives way, and is not shone through
    this.#context.drawImage(this.canvas, n, 0, edge, height, 0, 0, edge, height);
    this.#context.globalCompositeOperation = "source-over";
    this.#drawSound(edge, n, height - BAND);
    frames.slice(-n).forEach((frame, k) => this.#drawPhoneme(edge + k, frame, names));
  }

  #drawSound(x, n, height) {
    this.analyser.getFloatFrequencyData(this.#levels);
    for (let y = 0; y < height; y++) {
      const level = this.#levels[Math.floor((1 - y / height) * this.#bins)] ?? QUIETEST;
      const share = Math.min(1, Math.max(0, (level - QUIETEST) / (LOUDEST - QUIETEST)));
      this.#context.fillStyle = `hsl(${260 - 210 * share} 70% ${20 + 55 * share}% / ${share})`;
      this.#context.fillRect(x, y, n, 1);
    }
  }

  #drawPhoneme(x, { phoneme }, names) {
    const { height } = this.canvas;
    this.#lasts = phoneme === this.#heard ? this.#lasts + 1 : 1;
    this.#heard = phoneme;
    if (phoneme === 0) return; // silence is left empty
    this.#context.fillStyle = `hsl(${(phoneme * 360) / names.length} 55% 45%)`;
    this.#context.fillRect(x, height - BAND, 1, BAND);
    if (this.#lasts === NAMED && phoneme > 1) {
      this.#context.fillStyle = "white";
      this.#context.font = "12px system-ui, sans-serif";
      this.#context.textAlign = "right";
      this.#context.fillText(names[phoneme], x, height - 8, NAMED);
    }
  }
}
