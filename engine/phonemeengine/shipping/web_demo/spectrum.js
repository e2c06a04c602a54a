// SPDX-License-Identifier: MIT
/* The spectrogram of the last seconds, a column for each frame of 10 ms, with axes, and a band of phonemes beneath. */

const BAND = 26; // pixels of the phonemes
const TIMES = 18; // of the seconds below them
const SCALE = 44; // of the frequencies at the left
const NAMED = 10; // columns of a phoneme that is long enough for its name
const HIGHEST = 8000; // Hz, at the upper edge
const STEP = 2000; // Hz between two marks
const QUIETEST = -100; // dB that are drawn as nothing
const LOUDEST = -25;
const FONT = "12px system-ui, sans-serif";

export class Spectrum {
  #context;
  #levels;
  #before; // the levels of the picture before: columns between are in between
  #bins;
  #newest = -1;
  #lasts = 0; // columns of the newest phoneme

  constructor(canvas, analyser) {
    this.canvas = canvas;
    this.analyser = analyser;
    this.#context = canvas.getContext("2d", { willReadFrequently: true });
    this.#levels = new Float32Array(analyser.frequencyBinCount).fill(QUIETEST);
    this.#before = this.#levels.slice();
    this.#bins = (HIGHEST * analyser.fftSize) / analyser.context.sampleRate;
    this.#context.clearRect(0, 0, canvas.width, canvas.height);
    this.#drawScale();
  }

  /** Move on by as many columns as there are new frames. */
  draw(frames, names) {
    const { width, height } = this.canvas;
    const n = Math.min(frames.length, width - SCALE);
    if (n === 0) return;
    const rest = width - SCALE - n;
    this.#context.putImageData(this.#context.getImageData(SCALE + n, 0, rest, height), SCALE, 0);
    this.#context.clearRect(SCALE + rest, 0, n, height);
    this.#drawSound(SCALE + rest, n, height - BAND - TIMES);
    frames.slice(-n).forEach((frame, k) => this.#drawPhoneme(SCALE + rest + k, frame, names));
  }

  #drawScale() {
    const height = this.canvas.height - BAND - TIMES;
    this.#context.fillStyle = getComputedStyle(this.canvas).color;
    this.#context.font = FONT;
    this.#context.textAlign = "right";
    for (let frequency = STEP; frequency <= HIGHEST; frequency += STEP) {
      const y = height * (1 - frequency / HIGHEST);
      this.#context.fillText(`${frequency / 1000} kHz`, SCALE - 8, Math.max(y + 4, 11));
      this.#context.fillRect(SCALE - 5, y, 4, 1);
    }
    this.#context.fillText("time", SCALE - 8, this.canvas.height - 4);
  }

  #drawSound(x, n, height) {
    [this.#before, this.#levels] = [this.#levels, this.#before];
    this.analyser.getFloatFrequencyData(this.#levels);
    const image = this.#context.createImageData(n, height);
    for (let y = 0; y < height; y++) {
      const bin = (1 - (y + 0.5) / height) * this.#bins;
      const [older, newer] = [levelAt(this.#before, bin), levelAt(this.#levels, bin)];
      for (let k = 0; k < n; k++) {
        const level = older + ((newer - older) * (k + 1)) / n;
        const share = Math.min(1, Math.max(0, (level - QUIETEST) / (LOUDEST - QUIETEST)));
        image.data.set([60 + 195 * share, 30 + 160 * share ** 2, 110 - 60 * share, 255 * Math.sqrt(share)], 4 * (y * n + k));
      }
    }
    this.#context.putImageData(image, x, 0);
  }

  #drawPhoneme(x, { number, phoneme }, names) {
    const { height } = this.canvas;
    const top = height - BAND - TIMES;
    this.#lasts = phoneme === this.#newest ? this.#lasts + 1 : 1;
    this.#newest = phoneme;
    this.#context.font = FONT;
    this.#context.textAlign = "right";
    if (number % 100 === 0) {
      this.#context.fillStyle = getComputedStyle(this.canvas).color;
      this.#context.fillRect(x, height - TIMES, 1, 5);
      this.#context.fillText(`${number / 100} s`, x, height - 4);
    }
    if (phoneme === 0) return; // silence is left empty
    this.#context.fillStyle = `hsl(${(phoneme * 360) / names.length} 55% 38%)`;
    this.#context.fillRect(x, top, 1, BAND);
    if (this.#lasts === NAMED && phoneme > 1) {
      this.#context.fillStyle = "white";
      this.#context.fillText(names[phoneme], x, top + 18, NAMED);
    }
  }
}

/* The level between two bins of a spectrum. */
function levelAt(levels, bin) {
  const first = Math.min(Math.floor(bin), levels.length - 2);
  const level = levels[first] + (bin - first) * (levels[first + 1] - levels[first]);
  return Number.isFinite(level) ? level : QUIETEST; // digital silence is -Infinity
}
