// SPDX-License-Identifier: MIT
/* Moves the mouth of an avatar of @pixiv/three-vrm by the microphone. Call it after a click. */
import { createRecogniser } from "phoneme-ear";

export async function speakingAvatar(vrm) {
  const recogniser = await createRecogniser({ table: "vrm1" }); // aa, ih, ou, ee and oh; three-vrm names those of VRM 0 alike
  return {
    /** Call it for each picture, before vrm.update. */
    update() {
      for (const [name, weight] of Object.entries(recogniser.weights())) vrm.expressionManager.setValue(name, weight);
    },
    close: () => recogniser.close(),
  };
}
