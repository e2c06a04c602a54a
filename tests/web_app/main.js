/* A page of somebody else that listens with the package, for tests: bundled, and run in Node and Chromium. */
import { createRecogniser } from "phoneme-ear";

/* Recognise a sound in the audio thread; gives the phoneme of each frame, and what is said after it was closed. */
globalThis.hear = async (samples, rate) => {
  const context = new OfflineAudioContext(1, samples.length, rate);
  const buffer = context.createBuffer(1, samples.length, rate);
  buffer.copyToChannel(Float32Array.from(samples), 0);
  const source = context.createBufferSource();
  source.buffer = buffer;
  const phonemes = [];
  let widest = 0;
  const onFrame = (frame) => {
    phonemes.push(frame.phoneme);
    widest = Math.max(widest, recogniser.weights().jawOpen);
  };
  const recogniser = await createRecogniser({ source, onFrame });
  source.start();
  await context.startRendering();
  const known = (100 * samples.length) / rate - 12; // the last frames wait for what comes after them
  while (phonemes.length < known) await new Promise((resolve) => setTimeout(resolve, 5)); // messages are on their way
  recogniser.close();
  recogniser.close();
  let refusal = "";
  try {
    recogniser.weights();
  } catch (error) {
    refusal = `${error.name}: ${error.message}`;
  }
  return { phonemes, widest, refusal };
};
