// SPDX-License-Identifier: MIT
/*
 * Recognises phonemes and visemes in speech, every 10 ms, and moves a mouth by them: ear.wasm, with a preset.
 *
 *     const recogniser = await createRecogniser({ onFrame: ({ phoneme }) => console.log(recogniser.model.phonemes[phoneme]) });
 */

const FRAME_BYTES = 192;
const MOST_SAMPLES = 4096; // that are handed to the module at once
const LAST_FRAMES = 32; // that a sound's end gives at most
const PHONEMES = 11;
const WORKLET = ""; // the text of ear-worklet.js: `phonemeanalyser ship` puts it in, so that bundles need no other file

/** A frame's viseme where it is unknown. */
export const NO_VISEME = 255;
const VERSION = "0.9.0";

/** What cannot be done, in a sentence. */
export class EarError extends Error {
  name = "EarError";
}

/** Read a frame from the bytes that the module wrote; `visemes`: how many the model tells apart. */
export function readFrame(bytes, visemes = 15) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, FRAME_BYTES);
  const number = view.getUint32(0, true);
  return {
    number,
    time: number / 100,
    phoneme: view.getInt32(4, true),
    viseme: view.getInt32(8, true),
    intensity: view.getFloat32(12, true),
    confidence: view.getFloat32(16, true),
    scores: Float32Array.from({ length: PHONEMES }, (_, k) => view.getFloat32(20 + 4 * k, true)),
    visemeScores: Float32Array.from({ length: visemes }, (_, k) => view.getFloat32(20 + 4 * (PHONEMES + k), true)),
  };
}

/** Open the module and the preset of this package; or fetch others, which are given by address. */
export async function loadModel(wasm, preset) {
  const [code, content] = await Promise.all([
    wasm ? fetchBytes(wasm) : ownBytes(import("./ear-wasm.js")),
    preset ? fetchBytes(preset) : ownBytes(import("./ear-preset.js")),
  ]);
  return new EarModel(await WebAssembly.compile(code), content);
}

async function ownBytes(file) {
  return Uint8Array.from(atob((await file).default), (letter) => letter.charCodeAt(0));
}

async function fetchBytes(place) {
  const answer = await fetch(place);
  if (!answer.ok) throw new EarError(`${place}: it cannot be loaded (${answer.status}); check its address`);
  return new Uint8Array(await answer.arrayBuffer());
}

/** A preset, with the memory of its recognisers. */
export class EarModel {
  #c;
  #model;

  /** `module`: ear.wasm, compiled; `preset`: the bytes of an .ear file. */
  constructor(module, preset) {
    this.#c = new WebAssembly.Instance(module, {}).exports;
    const version = this.#c.ear_version ? this.#text(this.#c.ear_version()) : "unknown";
    if (version !== VERSION)
      throw new EarError(`the version of ear.wasm is ${version}, that of ear.js ${VERSION}; take both from one package`);
    this.module = module;
    this.preset = preset;
    const bytes = this.#allocate(preset.length);
    new Uint8Array(this.#c.memory.buffer).set(preset, bytes);
    try {
      this.#model = this.#made((place) => this.#c.ear_model_open(bytes, preset.length, 0, 0, place));
    } finally {
      this.#c.free(bytes);
    }
    this.name = this.#text(this.#c.ear_model_name(this.#model));
    this.lookAhead = this.#c.ear_model_look_ahead(this.#model) / 100;
    this.phonemes = this.#list(PHONEMES, (k) => this.#c.ear_phoneme_name(k));
    const n = this.#c.ear_model_visemes(this.#model);
    this.visemes = this.#list(n, (k) => this.#c.ear_model_viseme(this.#model, k));
    this.tables = this.#list(this.#c.ear_table_count(this.#model), (k) => this.#c.ear_table_name(this.#model, k));
  }

  /** Open a recogniser for one stream of a sample rate. */
  ear(rate) {
    const { ear, room, ...buffers } = this.#opened(rate);
    return new Ear(this.#c, ear, buffers, room, (code) => this.#check(code), this.visemes.length);
  }

  /** What a worklet needs to listen at a sample rate without opening anything: a memory in which a recogniser is open. */
  forWorklet(rate) {
    const fresh = new EarModel(this.module, this.preset); // alone in its memory
    const opened = fresh.#opened(rate);
    const memory = fresh.#c.memory.buffer.slice(0);
    return { module: this.module, memory, mostSamples: MOST_SAMPLES, frameBytes: FRAME_BYTES, ...opened };
  }

  #opened(rate) {
    const room = Math.max(Math.floor((MOST_SAMPLES * 100) / rate) + 2, LAST_FRAMES);
    return {
      ear: this.#made((place) => this.#c.ear_open_sized(this.#model, rate, FRAME_BYTES, 0, 0, place)),
      samples: this.#allocate(4 * MOST_SAMPLES),
      frames: this.#allocate(FRAME_BYTES * room),
      room,
      count: this.#allocate(4),
    };
  }

  /** Open a mouth that moves by a table. */
  mouth(table, seed = 1) {
    const number = this.#numberOf(table);
    const mouth = this.#made((place) => this.#c.ear_mouth_open(this.#model, number, seed, 0, 0, place));
    const movestates = this.movestates(table);
    return new Mouth(this.#c, mouth, movestates, this.#allocate(4 * movestates.length));
  }

  /** The blend shapes that a table moves. */
  movestates(table) {
    const number = this.#numberOf(table);
    const n = this.#c.ear_table_movestates(this.#model, number);
    return this.#list(n, (k) => this.#c.ear_table_movestate(this.#model, number, k));
  }

  /** The name of the shape that a table has for a frame, such as "B". */
  shapeOf(table, { phoneme, viseme }) {
    const number = this.#numberOf(table);
    const shape = this.#c.ear_table_shape(this.#model, number, phoneme, viseme);
    return this.#text(this.#c.ear_table_shape_name(this.#model, number, shape));
  }

  /**
   * The weights of a table's movestates for a frame: the shapes of all visemes, each by how likely it is. They are
   * continuous and not smoothed; a mouth moves smoothly.
   */
  blend(table, { phoneme, intensity, scores, visemeScores }) {
    const number = this.#numberOf(table);
    const n = this.#c.ear_table_movestates(this.#model, number);
    const place = this.#allocate(FRAME_BYTES + 4 * n);
    try {
      const { buffer } = this.#c.memory;
      new Uint8Array(buffer, place, FRAME_BYTES).fill(0);
      const view = new DataView(buffer, place, FRAME_BYTES);
      view.setInt32(4, phoneme, true);
      view.setFloat32(12, intensity, true);
      scores.forEach((score, k) => view.setFloat32(20 + 4 * k, score, true));
      visemeScores.forEach((score, k) => view.setFloat32(20 + 4 * (PHONEMES + k), score, true));
      this.#check(this.#c.ear_table_blend(this.#model, number, place, place + FRAME_BYTES));
      return new Float32Array(buffer, place + FRAME_BYTES, n).slice();
    } finally {
      this.#c.free(place);
    }
  }

  #numberOf(table) {
    const number = this.tables.indexOf(table);
    if (number < 0) {
      throw new EarError(`there is no mouth table ${table}; choose one of ${this.tables.join(", ")}, or ship it`);
    }
    return number;
  }

  #made(open) {
    const place = this.#allocate(4);
    try {
      this.#check(open(place));
      return new Uint32Array(this.#c.memory.buffer, place, 1)[0];
    } finally {
      this.#c.free(place);
    }
  }

  #allocate(n) {
    const place = this.#c.malloc(n);
    if (!place) throw new EarError("there is not enough memory left for a recogniser; close another page");
    return place;
  }

  #check(code) {
    if (code) throw new EarError(this.#text(this.#c.ear_error_text(code)));
  }

  #list(n, at) {
    return Array.from({ length: n }, (_, k) => this.#text(at(k)));
  }

  #text(start) {
    const bytes = new Uint8Array(this.#c.memory.buffer);
    let code = ""; // an audio worklet has no TextDecoder
    for (let at = start; bytes[at]; at++) code += `%${bytes[at].toString(16).padStart(2, "0")}`;
    return decodeURIComponent(code);
  }
}

/** Recognises one stream of sound; made by EarModel.ear. */
export class Ear {
  #c;
  #ear;
  #buffers;
  #room;
  #check;
  #visemes;
  #memory;
  #samples;
  #count;

  constructor(c, ear, buffers, room, check, visemes) {
    this.#c = c;
    this.#ear = ear;
    this.#buffers = buffers;
    this.#room = room;
    this.#check = check;
    this.#visemes = visemes;
    this.latency = c.ear_latency(ear);
    this.#look();
  }

  /** Take samples, at most 4096, and return how many frames became known; their bytes lie in `slots`. Allocates nothing. */
  take(samples) {
    if (samples.length > MOST_SAMPLES) {
      throw new EarError(`take accepts at most ${MOST_SAMPLES} samples at once, got ${samples.length}; push takes any number`);
    }
    checkOpen(this.#ear, "ear");
    if (this.#memory !== this.#c.memory.buffer) this.#look();
    this.#samples.set(samples);
    const { samples: from, frames, count } = this.#buffers;
    const code = this.#c.ear_push(this.#ear, from, samples.length, frames, this.#room, count);
    if (code) this.#check(code);
    return this.#count[0];
  }

  /** Take samples, as many as you like, and return the frames that became known. */
  push(samples) {
    checkOpen(this.#ear, "ear");
    const found = [];
    for (let at = 0; at < samples.length; at += MOST_SAMPLES) {
      const n = this.take(samples.subarray(at, at + MOST_SAMPLES));
      for (let k = 0; k < n; k++) found.push(readFrame(this.slots[k], this.#visemes));
    }
    return found;
  }

  /** The sound is over: return its last frames. Then the recogniser is as new. */
  finish() {
    checkOpen(this.#ear, "ear");
    if (this.#memory !== this.#c.memory.buffer) this.#look();
    this.#check(this.#c.ear_finish(this.#ear, this.#buffers.frames, this.#room, this.#buffers.count));
    return this.slots.slice(0, this.#count[0]).map((bytes) => readFrame(bytes, this.#visemes));
  }

  /** Forget the sound, and begin another one. */
  reset() {
    checkOpen(this.#ear, "ear");
    this.#c.ear_reset(this.#ear);
  }

  /** Give its memory back; it is of no use any more. */
  close() {
    if (!this.#ear) return;
    this.#c.ear_close(this.#ear);
    Object.values(this.#buffers).forEach((place) => this.#c.free(place));
    this.#ear = 0;
  }

  /** Look at the module's memory anew, which moves when it grows. */
  #look() {
    const { samples, frames, count } = this.#buffers;
    this.#memory = this.#c.memory.buffer;
    this.#samples = new Float32Array(this.#memory, samples, MOST_SAMPLES);
    this.#count = new Uint32Array(this.#memory, count, 1);
    const slot = (_, k) => new Uint8Array(this.#memory, frames + FRAME_BYTES * k, FRAME_BYTES);
    this.slots = Array.from({ length: this.#room }, slot);
  }
}

/** Moves smoothly from shape to shape; made by EarModel.mouth. */
export class Mouth {
  #c;
  #mouth;
  #weights;

  constructor(c, mouth, movestates, weights) {
    this.#c = c;
    this.#mouth = mouth;
    this.#weights = weights;
    this.movestates = movestates;
  }

  /** Take a frame that holds from a time on, seconds of a clock of yours, which never goes back. */
  add(time, { phoneme, viseme, intensity }) {
    checkOpen(this.#mouth, "mouth");
    this.#c.ear_mouth_hear(this.#mouth, time, phoneme, viseme, intensity);
  }

  /** The former name of `add`, for one release. */
  hear(time, frame) {
    this.add(time, frame);
  }

  /** The weights of its movestates at a time, 0..1; times never go back. */
  weights(time) {
    checkOpen(this.#mouth, "mouth");
    this.#c.ear_mouth_weights(this.#mouth, time, this.#weights);
    return new Float32Array(this.#c.memory.buffer, this.#weights, this.movestates.length).slice();
  }

  /** Give its memory back; it is of no use any more. */
  close() {
    if (!this.#mouth) return;
    this.#c.ear_mouth_close(this.#mouth);
    this.#c.free(this.#weights);
    this.#mouth = 0;
  }
}

/* What was closed lies in memory that others have by now. */
function checkOpen(handle, name) {
  if (!handle) throw new EarError(`this ${name} was closed; open another one`);
}

let workletPlace; // one for all nodes: a browser runs each address once

/**
 * Make a node that recognises in the audio thread. Connect a source to it; it is silent itself.
 * `onFrame` is called with each frame, in the thread of the page. `close()` ends the node. `worklet`: the address of
 * ear-worklet.js, for pages whose security policy forbids scripts from blob: addresses.
 */
export async function earNode(context, model, onFrame, worklet) {
  if (!context.audioWorklet) {
    throw new EarError("this page may not listen; open it by https or from localhost, in a current browser");
  }
  const processorOptions = model.forWorklet(context.sampleRate); // refuses a rate that no recogniser can have
  workletPlace ??= URL.createObjectURL(new Blob([WORKLET], { type: "text/javascript" }));
  await context.audioWorklet.addModule(worklet ?? workletPlace);
  const node = new AudioWorkletNode(context, "phoneme-ear", {
    channelCount: 1,
    channelCountMode: "explicit",
    processorOptions,
  });
  node.port.onmessage = ({ data }) => onFrame(readFrame(data, model.visemes.length));
  node.connect(context.destination); // what leads nowhere is not asked to listen
  node.close = () => {
    node.port.postMessage("close");
    node.port.onmessage = null;
    node.disconnect();
  };
  return node;
}

/** Ask for a microphone as it is: what browsers do for calls removes what recognition needs. */
export async function openMicrophone() {
  if (!navigator.mediaDevices) {
    throw new EarError("only pages from https or localhost may use a microphone; open this page from there");
  }
  const asIs = { autoGainControl: false, echoCancellation: false, noiseSuppression: false };
  try {
    return await navigator.mediaDevices.getUserMedia({ audio: asIs });
  } catch (error) {
    throw new EarError(REFUSALS[error.name] ?? `the microphone cannot be opened (${error.message}); try another one`);
  }
}

const LONGEST_START = 5000; // milliseconds

/**
 * Recognise a microphone, or another source, and move a mouth by it. Call it after a click, since browsers start no sound
 * before one. All options may be left out; see ear.d.ts.
 */
export async function createRecogniser(options = {}) {
  const { source, onFrame, onEnd, table = "arkit", wasm, preset, worklet } = options;
  const known = options.context ?? source?.context;
  const context = known ?? new AudioContext(); // in the click itself, for Safari
  const undo = [() => known || context.close()];
  const close = () => undo.splice(0).reverse().forEach((step) => step()); // a second call finds nothing to undo
  try {
    const model = options.model ?? (await loadModel(wasm, preset));
    const mouth = model.tables.includes(table) ? model.mouth(table) : null;
    undo.push(() => mouth?.close());
    const recogniser = new Recogniser(model, context, mouth, table, close);
    const take = (frame) => {
      recogniser.take(frame);
      onFrame?.(frame);
    };
    const node = (recogniser.node = await earNode(context, model, take, worklet));
    undo.push(() => node.close());
    const given = typeof source === "function" ? await source(context) : source;
    const stream = given?.context ? null : (given ?? (await openMicrophone()));
    if (stream && !given) undo.push(() => stream.getTracks().forEach((track) => track.stop()));
    const end = (words) => {
      recogniser.close();
      onEnd?.(new EarError(words));
    };
    stream?.getAudioTracks().forEach((track) => {
      track.onended = () => end("the microphone was taken away; connect it, and start again");
      undo.push(() => (track.onended = null));
    });
    node.onprocessorerror = () => end("the recogniser stopped in the audio thread; start it again");
    const opened = (recogniser.source = stream ? context.createMediaStreamSource(stream) : given);
    opened.connect(node);
    undo.push(() => disconnect(opened, node));
    if (!known) await started(context);
    return recogniser;
  } catch (error) {
    close();
    throw error;
  }
}

function disconnect(source, node) {
  try {
    source.disconnect(node);
  } catch {
    // the page has done so itself
  }
}

/* Wait until sound flows, which it does at once, or never where the system has no output or the page got no click. */
async function started(context) {
  const waited = new Promise((resolve) => setTimeout(resolve, LONGEST_START));
  await Promise.race([context.resume(), waited]);
  if (context.state !== "running") {
    throw new EarError(
      "the browser starts no sound; start after a click, connect a loudspeaker or headphones, and try again",
    );
  }
}

/** What createRecogniser makes. */
class Recogniser {
  #mouth;
  #table;
  #close;
  #isOpen = true;

  constructor(model, context, mouth, table, close) {
    this.#mouth = mouth;
    this.#table = table;
    this.#close = close;
    this.model = model;
    this.context = context;
    this.movestates = mouth?.movestates ?? [];
    this.frame = null;
  }

  take(frame) {
    this.frame = frame;
    this.#mouth?.add(frame.time, frame);
  }

  /** The weights of the blend shapes now, 0..1, by name. */
  weights() {
    checkOpen(this.#isOpen, "recogniser");
    const values = this.#mouth?.weights(this.frame?.time ?? 0) ?? [];
    return Object.fromEntries(this.movestates.map((name, k) => [name, values[k]]));
  }

  /** The name of the shape that its table has for the newest frame. */
  shape() {
    checkOpen(this.#isOpen, "recogniser");
    return this.model.shapeOf(this.#table, this.frame ?? { phoneme: 0, viseme: NO_VISEME });
  }

  /** Stop, and release everything that was opened for it. */
  close() {
    this.#isOpen = false;
    this.#close();
  }
}

const REFUSALS = {
  NotAllowedError: "this page may not use the microphone; allow it in the browser's address bar, and try again",
  NotFoundError: "there is no microphone; connect one, and try again",
  NotReadableError: "the microphone cannot be opened; close other programs that may use it, and try again",
};
