// SPDX-License-Identifier: MIT
/*
 * Draws a mouth on a canvas by the two parameters that flat avatars have, such as Live2D's: ParamMouthOpenY (0..1) and
 * ParamMouthForm (-1 round, 1 wide). Call it after a click; a Live2D model takes `parameters()` instead of the drawing.
 */
import { createRecogniser } from "phoneme-ear";

export async function speakingDrawing(canvas) {
  const recogniser = await createRecogniser({ table: "vrm1" });
  const draw = canvas.getContext("2d");
  const parameters = () => {
    const { aa, ih, ou, ee, oh } = recogniser.weights();
    const open = aa + 0.3 * ih + 0.3 * ou + 0.6 * ee + 0.7 * oh;
    return { ParamMouthOpenY: Math.min(1, open), ParamMouthForm: Math.max(-1, Math.min(1, ih + 0.6 * ee - ou - 0.6 * oh)) };
  };
  const update = () => {
    const { width, height } = canvas;
    const { ParamMouthOpenY: open, ParamMouthForm: form } = parameters();
    draw.clearRect(0, 0, width, height);
    draw.beginPath();
    draw.ellipse(width / 2, height / 2, width * (0.25 + 0.12 * form), height * (0.02 + 0.35 * open), 0, 0, 2 * Math.PI);
    draw.fill();
  };
  return { parameters, update, close: () => recogniser.close() };
}
