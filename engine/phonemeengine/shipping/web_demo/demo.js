// SPDX-License-Identifier: MIT
/* Joins the page: a microphone or a file is recognised, and shown as phonemes, as a spectrum, and by the head. */
import { NO_VISEME, createRecogniser, loadModel } from "../ear.js";
import { Clip, canRecord } from "./clip.js";
import { Head } from "./head.js";
import { Spectrum } from "./spectrum.js";

const MOST_ROWS = 1000;
const MOUTH_TAKES = 0.12; // seconds until a mouth has moved: sound is played and recorded that much after it is recognised
const REST = { phoneme: 0, viseme: NO_VISEME, intensity: 0 };

const element = (id) => document.getElementById(id);
const seconds = (frames) => (frames / 100).toFixed(2);

let model;
let head = null; // where there is no WebGL
let mouth = null; // that the head moves by
let listening = null; // the current source
let latest; // the last attempt to listen
let clip = null; // that is being recorded
let fresh = []; // frames that are not drawn yet

class Listening {
  constructor(recogniser, audible) {
    const { context, source } = recogniser;
    const analyser = source.connect(new AnalyserNode(context, { fftSize: 2048, smoothingTimeConstant: 0 }));
    this.spectrum = new Spectrum(element("spectrum"), analyser);
    this.sound = source.connect(new DelayNode(context, { delayTime: MOUTH_TAKES }));
    if (audible) this.sound.connect(context.destination);
    this.recogniser = recogniser;
    const ear = model.ear(context.sampleRate);
    element("latency").textContent = `latency ${Math.round(1000 * ear.latency)} ms`;
    ear.close();
  }
}

async function begin(words, source) {
  end();
  complain("");
  element("phonemes").replaceChildren();
  const attempt = (latest = {});
  try {
    const onEnd = (error) => {
      end();
      complain(error.message);
    };
    const recogniser = await createRecogniser({ model, source, onFrame: (frame) => fresh.push(frame), onEnd });
    if (attempt !== latest) return recogniser.close(); // something else was chosen meanwhile
    listening = new Listening(recogniser, Boolean(source));
    if (source) recogniser.source.start();
    tellState(words);
  } catch (error) {
    if (attempt === latest) complain(error.message);
  }
}

function end() {
  latest = null;
  if (clip) saveClip();
  listening?.recogniser.close();
  listening = null;
  fresh = [];
  element("latency").textContent = "";
  if (model) tellState(`Preset ${model.name}`);
}

function tellState(words) {
  element("state").textContent = words;
  element("stop").disabled = !listening;
  const canvas = element("head");
  const why = !canRecord(canvas) ? "This browser records no clips." : !head ? "Without a head there is nothing to record." : "";
  element("why").textContent = why || (listening ? "" : "Clips can be recorded while the microphone or a file is on.");
  element("record").disabled = Boolean(element("why").textContent);
  element("record").textContent = clip ? "End clip" : "Record clip";
}

function complain(words) {
  element("trouble").textContent = words;
  element("trouble").hidden = !words;
}

function play(file) {
  return begin(`Playing ${file.name}`, async (context) => {
    let sound;
    try {
      sound = await context.decodeAudioData(await file.arrayBuffer());
    } catch {
      throw new Error(
        `${file.name}: this is no sound that the browser knows; choose a WAV, MP3, OGG or FLAC file (a head is a GLB or VRM file)`,
      );
    }
    const source = new AudioBufferSourceNode(context, { buffer: sound });
    const over = () => listening?.recogniser.source === source && end();
    source.onended = () => setTimeout(over, 1000 * MOUTH_TAKES);
    return source;
  });
}

function record() {
  if (clip) return saveClip();
  try {
    clip = new Clip(element("head"), listening.sound);
    tellState(element("state").textContent);
  } catch (error) {
    complain(`the clip cannot be recorded (${error.message}); try another browser`);
  }
}

async function saveClip() {
  const ended = clip;
  clip = null;
  if (listening) tellState(element("state").textContent);
  const file = await ended.end();
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = file.name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000); // when the browser has saved it
}

function draw(milliseconds) {
  requestAnimationFrame(draw);
  const frames = fresh;
  const now = milliseconds / 1000; // the mouth moves on between frames, too
  fresh = [];
  if (listening && frames.length) {
    frames.forEach(list);
    listening.spectrum.draw(frames, model.phonemes);
    tell(frames.at(-1));
  }
  (listening ? frames : [REST]).forEach((frame) => mouth?.add(now, frame));
  const values = mouth?.weights(now);
  head?.draw(new Map(mouth?.movestates.map((name, k) => [name, values[k]])), now);
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

/* `read` gives the bytes of a file. */
async function showHead(read, name) {
  try {
    await head.show(await read());
  } catch {
    complain(`${name}: this head cannot be read; choose a GLB or VRM file with everything in it`);
    return;
  }
  element("head").ariaLabel = `${name}, which says what is recognised`;
  const { table, movestates } = head;
  mouth?.close();
  mouth = model.tables.includes(table) ? model.mouth(table) : null;
  if (!mouth) complain(`${name}: the preset was shipped without the table ${table}, so this head does not move; ship it, too`);
  else if (!mouth.movestates.some((target) => movestates.includes(target))) {
    complain(`${name}: it has no morph target of the table ${table}, such as ${mouth.movestates[0]}; it will not move`);
  }
}

async function take(file, isHead = /\.(glb|vrm)$/i.test(file?.name)) {
  if (!file) return;
  complain("");
  if (!model) complain("the recogniser is not there yet; choose the file again when it is");
  else if (!isHead) await play(file);
  else if (head) await showHead(() => file.arrayBuffer(), file.name);
  else complain(`${file.name}: this browser draws no 3D (WebGL), so it shows no head`);
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
  try {
    head = new Head(element("head"));
  } catch {
    complain("this browser draws no 3D (WebGL), so there is no head; everything else works");
  }
  end();
  if (head) await showHead(async () => (await fetch("head.glb")).arrayBuffer(), "head.glb");
}

element("microphone").onclick = () => begin("Listening to the microphone");
element("stop").onclick = end;
element("record").onclick = record;
for (const id of ["file", "glb"]) {
  element(id).onchange = ({ target }) => {
    take(target.files[0], id === "glb");
    target.value = "";
  };
}
document.ondragover = (event) => event.preventDefault();
document.ondrop = (event) => {
  event.preventDefault();
  take(event.dataTransfer.files[0]);
};
navigator.serviceWorker?.register("sw.js").catch(() => {}); // without one the page needs the network, no more
requestAnimationFrame(draw);
load();
