// SPDX-License-Identifier: MIT
/* Joins the page: a microphone or a file is recognised, and shown as phonemes, as a spectrum, and by the head. */
import { NO_VISEME, earNode, loadModel, openMicrophone } from "../ear.js";
import { Head } from "./head.js";
import { Spectrum } from "./spectrum.js";

const MOST_ROWS = 1000;
const TABLE = "arkit";
const LONGEST_START = 5000; // milliseconds
const MOUTH_TAKES = 0.12; // seconds until a mouth has moved: a file is played by as much later than it is recognised

const element = (id) => document.getElementById(id);
const seconds = (frames) => (frames / 100).toFixed(2);

let model;
let head = null; // where there is no WebGL
let listening = null; // the current source
let fresh = []; // frames that are not drawn yet

class Listening {
  /** Begins to listen to what `open` makes of an audio context: a source, and whether it is played as well. */
  static async begin(open) {
    const context = new AudioContext();
    let stop = () => {};
    try {
      const node = await earNode(context, model, (frame) => fresh.push(frame));
      const opened = await open(context); // now, since earlier sound is lost
      const { source, audible } = opened;
      stop = opened.stop;
      const analyser = new AnalyserNode(context, { fftSize: 2048, smoothingTimeConstant: 0 });
      source.connect(analyser).connect(node);
      if (audible) source.connect(new DelayNode(context, { delayTime: MOUTH_TAKES })).connect(context.destination);
      await started(context);
      return new Listening(context, new Spectrum(element("spectrum"), analyser), stop);
    } catch (error) {
      stop();
      context.close();
      throw error;
    }
  }

  constructor(context, spectrum, stop) {
    this.context = context;
    this.spectrum = spectrum;
    this.stop = stop;
    this.mouth = model.tables.includes(TABLE) ? model.mouth(TABLE) : null;
    const ear = model.ear(context.sampleRate);
    element("latency").textContent = `latency ${Math.round(1000 * ear.latency)} ms`;
    ear.close();
  }

  end() {
    this.stop();
    this.mouth?.close();
    this.context.close();
  }
}

/* Wait until sound flows, which it does at once, or never where the system has no output. */
async function started(context) {
  const late = new Promise((resolve) => setTimeout(resolve, LONGEST_START));
  await Promise.race([context.resume(), late]);
  if (context.state !== "running") {
    throw new Error("the browser opens no sound output; connect a loudspeaker or headphones, and try again");
  }
}

async function microphone(context) {
  const stream = await openMicrophone();
  const stop = () => stream.getTracks().forEach((track) => track.stop());
  return { source: context.createMediaStreamSource(stream), audible: false, stop };
}

async function soundFile(file, context) {
  let sound;
  try {
    sound = await context.decodeAudioData(await file.arrayBuffer());
  } catch {
    throw new Error(`${file.name}: this is no sound that the browser knows; choose a WAV, MP3, OGG or FLAC file`);
  }
  const source = new AudioBufferSourceNode(context, { buffer: sound });
  source.onended = () => end();
  source.start();
  return { source, audible: true, stop: () => (source.onended = null) };
}

async function begin(words, open) {
  end();
  complain("");
  element("phonemes").replaceChildren();
  try {
    listening = await Listening.begin(open);
    element("state").textContent = words;
    element("stop").disabled = false;
  } catch (error) {
    complain(error.message);
  }
}

function end() {
  listening?.end();
  listening = null;
  fresh = [];
  element("stop").disabled = true;
  element("latency").textContent = "";
  if (model) element("state").textContent = `Preset ${model.name}`;
}

function complain(words) {
  element("trouble").textContent = words;
  element("trouble").hidden = !words;
}

function draw(milliseconds) {
  requestAnimationFrame(draw);
  const frames = fresh;
  fresh = [];
  let weights = new Map();
  if (listening && frames.length) {
    frames.forEach(list);
    listening.spectrum.draw(frames, model.phonemes);
    tell(frames.at(-1));
  }
  if (listening?.mouth) {
    const now = milliseconds / 1000; // the mouth moves on between frames, too
    frames.forEach((frame) => listening.mouth.add(now, frame));
    const values = listening.mouth.weights(now);
    weights = new Map(listening.mouth.movestates.map((name, k) => [name, values[k]]));
  }
  head?.draw(weights, milliseconds / 1000);
}

function tell({ phoneme, viseme, confidence }) {
  element("phoneme").textContent = model.phonemes[phoneme];
  const known = Number.isNaN(confidence) ? "" : ` confidence ${Math.round(100 * confidence)} %`;
  element("viseme").textContent = `${viseme === NO_VISEME ? "" : model.visemes[viseme]}${known}`;
}

/* Lengthen the last row of the table, or begin a new one. */
function list({ number, phoneme }) {
  const rows = element("phonemes");
  const last = rows.lastElementChild;
  if (last?.cells[2].textContent === model.phonemes[phoneme]) {
    last.cells[1].textContent = seconds(number + 1);
    return;
  }
  const row = rows.insertRow();
  for (const words of [seconds(number), seconds(number + 1), model.phonemes[phoneme]]) {
    row.insertCell().textContent = words;
  }
  if (rows.rows.length > MOST_ROWS) rows.deleteRow(0);
  element("list").scrollTop = element("list").scrollHeight;
}

async function showHead(bytes, name) {
  try {
    await head.show(bytes);
  } catch {
    complain(`${name}: this head cannot be read; choose a GLB file with everything in it`);
    return;
  }
  if (model && !head.movestates.some((target) => model.movestates(TABLE).includes(target))) {
    complain(`${name}: it has no morph target of the table ${TABLE}, such as jawOpen; it will not move`);
  }
}

async function load() {
  try {
    model = await loadModel(new URL("../ear.wasm", import.meta.url), new URL("../preset.ear", import.meta.url));
  } catch (error) {
    complain(error.message);
    element("state").textContent = "";
    return;
  }
  element("microphone").disabled = element("file").disabled = false;
  end();
  try {
    head = new Head(element("head"));
  } catch {
    complain("this browser draws no 3D (WebGL), so there is no head; everything else works");
    return;
  }
  const answer = await fetch("head.glb");
  await showHead(await answer.arrayBuffer(), "head.glb");
}

element("microphone").onclick = () => begin("Listening to the microphone", microphone);
element("stop").onclick = end;
element("file").onchange = ({ target }) => {
  const [file] = target.files;
  if (file) begin(`Playing ${file.name}`, (context) => soundFile(file, context));
  target.value = "";
};
element("glb").onchange = async ({ target }) => {
  const [file] = target.files;
  complain("");
  if (file && head) await showHead(await file.arrayBuffer(), file.name);
  target.value = "";
};
navigator.serviceWorker?.register("sw.js").catch(() => {}); // without one the page needs the network, no more
requestAnimationFrame(draw);
load();
