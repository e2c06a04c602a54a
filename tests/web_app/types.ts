// What a page in TypeScript writes; it compiles where the package's types are true.
import { Ear, EarError, EarModel, EarNode, Mouth, WorkletOptions, earNode, loadModel, openMicrophone } from "phoneme-ear";

export async function listen(context: AudioContext | OfflineAudioContext): Promise<EarNode> {
  const model: EarModel = await loadModel(new URL("ear.wasm", "https://example.org"), "preset.ear");
  const again = new EarModel(model.module, model.preset);
  const options: WorkletOptions = again.forWorklet(context.sampleRate);
  const ear: Ear = again.ear(options.mostSamples);
  const mouth: Mouth = again.mouth("arkit");
  try {
    ear.push(new Float32Array(128)).forEach((frame) => mouth.hear(frame.time, frame));
  } catch (error) {
    if (error instanceof EarError) ear.close();
  }
  const node = await earNode(context, model, (frame) => console.log(model.phonemes[frame.phoneme]));
  if (context instanceof AudioContext) context.createMediaStreamSource(await openMicrophone()).connect(node);
  node.close();
  return node;
}
