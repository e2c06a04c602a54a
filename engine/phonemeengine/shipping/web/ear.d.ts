// SPDX-License-Identifier: MIT
/** A frame's viseme where it is unknown. */
export const NO_VISEME = 255;

/** What was recognised in 10 ms. */
export interface Frame {
  /** It lasts from number x 10 ms of the sound to 10 ms later. */
  readonly number: number;
  /** Seconds. */
  readonly time: number;
  /** See EarModel.phonemes. */
  readonly phoneme: number;
  /** See EarModel.visemes; or NO_VISEME. */
  readonly viseme: number;
  /** How loud, 0..1. */
  readonly intensity: number;
  /** The share of such answers that are right, 0..1; NaN where the preset has no such curve. */
  readonly confidence: number;
  /** How likely each phoneme is; all 0 with rules, which name one only. */
  readonly scores: Float32Array;
  /** How likely each viseme is; all 0 where the model tells none apart. */
  readonly visemeScores: Float32Array;
}

/** What cannot be done, in a sentence. */
export class EarError extends Error {}

/** Read a frame from the bytes that the module wrote; `visemes`: how many the model tells apart (15). */
export function readFrame(bytes: Uint8Array, visemes?: number): Frame;

/** Open the module and the preset of this package; or fetch others (ear.wasm, preset.ear), which are given by address. */
export function loadModel(wasm?: string | URL, preset?: string | URL): Promise<EarModel>;

/** Sound that can be recognised. */
export type Source = AudioNode | MediaStream;

/** What createRecogniser can be told; everything may be left out. */
export interface RecogniserOptions {
  /**
   * What is recognised; the microphone unless given. A node of the Web Audio API decides the context, too; a function gets
   * the context, and returns the source, or a promise of it.
   */
  source?: Source | ((context: BaseAudioContext) => Source | Promise<Source>);
  /** Where it runs, such as a context of yours, which you start and close. Unless given, it has one of its own. */
  context?: BaseAudioContext;
  /** Called with each frame, in the thread of the page. */
  onFrame?: (frame: Frame) => void;
  /** Called when recognition ends without `close`, such as when the microphone is taken away. */
  onEnd?: (error: EarError) => void;
  /** The mouth table by which `weights` and `shape` go; "arkit" unless given. */
  table?: string;
  /** A model that is open already, for several recognisers. */
  model?: EarModel;
  /** The address of another preset than the package's, and of ear.wasm. */
  preset?: string | URL;
  wasm?: string | URL;
  /** The address of ear-worklet.js, for pages whose security policy forbids scripts from blob: addresses. */
  worklet?: string | URL;
}

/** Recognises, and moves a mouth; made by createRecogniser. Once it is closed, it throws an EarError. */
export interface Recogniser {
  readonly model: EarModel;
  readonly context: BaseAudioContext;
  readonly node: EarNode;
  /** What is connected to it. */
  readonly source: AudioNode;
  /** The newest frame; null before the first one. */
  readonly frame: Frame | null;
  /** The blend shapes of its table. */
  readonly movestates: readonly string[];
  /** The weights of the blend shapes now, 0..1, by name; call it for each picture. */
  weights(): Record<string, number>;
  /** The name of the shape that its table has for the newest frame, such as "B" of "rhubarb". */
  shape(): string;
  /** Stop, and release everything that was opened for it. */
  close(): void;
}

/**
 * Recognise a microphone, or another source, and move a mouth by it. Call it after a click, since browsers start no sound
 * before one. What cannot be done is an EarError, with a sentence that can be shown in the page.
 */
export function createRecogniser(options?: RecogniserOptions): Promise<Recogniser>;

/** A preset, with the memory of its recognisers. */
export class EarModel {
  /** `module`: ear.wasm, compiled; `preset`: the bytes of an .ear file. */
  constructor(module: WebAssembly.Module, preset: Uint8Array);
  readonly module: WebAssembly.Module;
  readonly preset: Uint8Array;
  readonly name: string;
  /** For how long it waits before it says what a frame is, seconds. */
  readonly lookAhead: number;
  readonly phonemes: readonly string[];
  readonly visemes: readonly string[];
  /** The names of its mouth tables. */
  readonly tables: readonly string[];
  /** Open a recogniser for one stream of a sample rate, 1000..768000 Hz. */
  ear(rate: number): Ear;
  /** What a worklet of your own needs to recognise at a sample rate; see ear-worklet.js. */
  forWorklet(rate: number): WorkletOptions;
  /** Open a mouth that moves by a table; equal seeds make equal mouths. */
  mouth(table: string, seed?: number): Mouth;
  /** The blend shapes that a table moves. */
  movestates(table: string): string[];
  /** The name of the shape that a table has for a frame, such as "B". */
  shapeOf(table: string, frame: Pick<Frame, "phoneme" | "viseme">): string;
  /** The weights of a table's movestates for a frame: all visemes, each by how likely it is; not smoothed. */
  blend(table: string, frame: Pick<Frame, "phoneme" | "intensity" | "scores" | "visemeScores">): Float32Array;
}

/** The module, and a memory in which a recogniser is open: `ear` and what follows are places in it, `room` is in frames. */
export interface WorkletOptions {
  readonly module: WebAssembly.Module;
  readonly memory: ArrayBuffer;
  readonly frameBytes: number;
  readonly ear: number;
  readonly samples: number;
  readonly mostSamples: number;
  readonly frames: number;
  readonly room: number;
  readonly count: number;
}

/** Recognises one stream of sound; made by EarModel.ear. Once it is closed, it throws an EarError. */
export class Ear {
  private constructor();
  /** Mean time from the middle of a frame until it is recognised, seconds. */
  readonly latency: number;
  /** The bytes of the frames that `take` found, for readFrame. */
  readonly slots: readonly Uint8Array[];
  /** Take samples, at most 4096 (more throw an EarError), and return how many frames were recognised. Allocates nothing. */
  take(samples: Float32Array): number;
  /** Take samples, as many as you like, and return the frames that were recognised. */
  push(samples: Float32Array): Frame[];
  /** The sound is over: return its last frames. Then the recogniser is as new. */
  finish(): Frame[];
  /** Forget the sound, and begin another one. */
  reset(): void;
  /** Give its memory back; it is of no use any more. */
  close(): void;
}

/** Moves smoothly from shape to shape; made by EarModel.mouth. Once it is closed, it throws an EarError. */
export class Mouth {
  private constructor();
  readonly movestates: readonly string[];
  /** Take a frame that holds from a time on, seconds of a clock of yours, which never goes back. */
  add(time: number, frame: Pick<Frame, "phoneme" | "viseme" | "intensity">): void;
  /** @deprecated The former name of `add`, for one release. */
  hear(time: number, frame: Pick<Frame, "phoneme" | "viseme" | "intensity">): void;
  /** The weights of its movestates at a time, 0..1; times never go back. */
  weights(time: number): Float32Array;
  /** Give its memory back; it is of no use any more. */
  close(): void;
}

/** Recognises in the audio thread; made by earNode. */
export interface EarNode extends AudioWorkletNode {
  /** Stop, and release the node and its memory. */
  close(): void;
}

/**
 * Make a node that recognises in the audio thread. Connect a source to it; it is silent itself.
 * `onFrame` is called with each frame, in the thread of the page. `worklet`: the address of ear-worklet.js, for pages whose
 * security policy forbids scripts from blob: addresses.
 */
export function earNode(
  context: BaseAudioContext,
  model: EarModel,
  onFrame: (frame: Frame) => void,
  worklet?: string | URL,
): Promise<EarNode>;

/** Ask for a microphone as it is, without what browsers do to a voice in calls. */
export function openMicrophone(): Promise<MediaStream>;
