// SPDX-License-Identifier: MIT
/* Records a canvas and a sound as a film. */
const RATE = 30; // pictures a second
const KINDS = ["video/mp4;codecs=avc1.42E01F,mp4a.40.2", "video/webm;codecs=vp9,opus", "video/webm", "video/mp4"];

const kind = () => globalThis.MediaRecorder && KINDS.find((name) => MediaRecorder.isTypeSupported(name));

/** Whether this browser can record one. */
export const canRecord = (canvas) => Boolean(canvas.captureStream && kind());

export class Clip {
  #recorder;
  #pictures;
  #release;
  #parts = [];

  /** Begin to record a canvas, and a node of the Web Audio API. */
  constructor(canvas, sound) {
    const heard = sound.connect(new MediaStreamAudioDestinationNode(sound.context));
    this.#release = () => sound.disconnect(heard);
    this.#pictures = canvas.captureStream(RATE);
    const tracks = [...this.#pictures.getTracks(), ...heard.stream.getTracks()];
    this.#recorder = new MediaRecorder(new MediaStream(tracks), { mimeType: kind() });
    this.#recorder.ondataavailable = ({ data }) => this.#parts.push(data);
    this.#recorder.start();
  }

  /** End it, and give it as a file. */
  async end() {
    await new Promise((resolve) => {
      this.#recorder.onstop = resolve;
      if (this.#recorder.state === "inactive") resolve(); // it broke off by itself: what there is counts
      else this.#recorder.stop();
    });
    this.#pictures.getTracks().forEach((track) => track.stop());
    this.#release();
    const type = this.#recorder.mimeType.split(";")[0];
    return new File(this.#parts, `clip.${type.split("/")[1]}`, { type });
  }
}
