/* A page of somebody else that listens with the package, for tests: bundled by vite and esbuild, run in Node and Chromium. */
import { earNode, loadModel } from "phoneme-ear";
import preset from "phoneme-ear/preset.ear?url";
import wasm from "phoneme-ear/ear.wasm?url";

/* Hear a sound in the thread of the sound; gives the phoneme of each frame. */
globalThis.hear = async (samples, rate) => {
  const context = new OfflineAudioContext(1, samples.length, rate);
  const model = await loadModel(wasm, preset);
  const phonemes = [];
  const node = await earNode(context, model, (frame) => phonemes.push(frame.phoneme));
  const buffer = context.createBuffer(1, samples.length, rate);
  buffer.copyToChannel(Float32Array.from(samples), 0);
  const source = context.createBufferSource();
  source.buffer = buffer;
  source.connect(node);
  source.start();
  await context.startRendering();
  const known = (100 * samples.length) / rate - 12; // the last frames wait for what comes after them
  while (phonemes.length < known) await new Promise((resolve) => setTimeout(resolve, 5)); // messages are on their way
  node.close();
  return phonemes;
};
