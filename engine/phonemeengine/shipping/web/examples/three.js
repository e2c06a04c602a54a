// SPDX-License-Identifier: MIT
/* Moves the morph targets of a head in three.js, whose names are ARKit's, by the microphone. Call it after a click. */
import { createRecogniser } from "phoneme-ear";

export async function speakingHead(scene) {
  const recogniser = await createRecogniser({ table: "arkit" });
  const faces = [];
  scene.traverse((node) => node.morphTargetDictionary && faces.push(node));
  return {
    /** Call it for each picture, before the renderer draws it. */
    update() {
      for (const [name, weight] of Object.entries(recogniser.weights())) {
        for (const { morphTargetDictionary: targets, morphTargetInfluences: influences } of faces) {
          if (name in targets) influences[targets[name]] = weight;
        }
      }
    },
    close: () => recogniser.close(),
  };
}
