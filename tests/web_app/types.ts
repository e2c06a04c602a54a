// What a page in TypeScript writes; it compiles where the package's types are true.
import {
  Ear, EarError, EarModel, EarNode, Mouth, Recogniser, WorkletOptions, createRecogniser, earNode, loadModel, openMicrophone,
} from "phoneme-ear";

export async function listen(context: AudioContext | OfflineAudioContext): Promise<EarNode> {
  const model: EarModel = await loadModel(new URL("ear.wasm", "https://example.org"), "preset.ear");
  const again = new EarModel(model.module, model.preset);
  const options: WorkletOptions = again.forWorklet(context.sampleRate);
  const ear: Ear = again.ear(options.mostSamples);
  const mouth: Mouth = again.mouth("arkit");
  try {
    ear.push(new Float32Array(128)).forEach((frame) => mouth.add(frame.time, frame));
  } catch (error) {
    if (error instanceof EarError) ear.close();
  }
  const node = await earNode(context, model, (frame) => console.log(model.phonemes[frame.phoneme]));
  if (context instanceof AudioContext) context.createMediaStreamSource(await openMicrophone()).connect(node);
  node.close();
  return node;
}

export async function recognise(): Promise<number | undefined> {
  const own: Recogniser = await createRecogniser();
  const source = new OscillatorNode(new AudioContext());
  const onEnd = (error: EarError): void => console.log(error.message);
  const other = await createRecogniser({ source, table: "rhubarb", model: own.model, onFrame: ({ time }) => time, onEnd });
  const made = await createRecogniser({ source: (context) => new OscillatorNode(context) });
  console.log(made.source.context, other.shape(), other.frame?.phoneme, other.node.context, own.movestates.length);
  own.close();
  return other.weights().jawOpen;
}
