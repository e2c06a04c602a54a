/*
 * Has the shipped module listen in Node, for tests: node web_ear.mjs TASK FOLDER RATE, with float32 on the standard input.
 * Answers are float64 on the standard output: of each frame number, phoneme, viseme, intensity, confidence and scores.
 * (32 of visemes, of which those that there are not are 0).
 */
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [task, folder, rate] = process.argv.slice(2);
const place = (name) => join(resolve(folder), name);
const { Ear, EarModel, readFrame } = await import(pathToFileURL(place("ear.js")));
const code = readFileSync(place("ear.wasm"));
const preset = readFileSync(place("preset.ear"));
const input = readFileSync(0);
const samples = new Float32Array(input.buffer.slice(input.byteOffset, input.byteOffset + input.length));
const rows = [];

const model = () => new EarModel(new WebAssembly.Module(code), preset);
const scores = (f) => [...f.scores, ...f.visemeScores, ...new Array(32 - f.visemeScores.length).fill(0)];
const row = (f) => rows.push(f.number, f.phoneme, f.viseme, f.intensity, f.confidence, ...scores(f));

function hear() {
  const ear = model().ear(Number(rate));
  ear.push(samples).forEach(row);
  ear.finish().forEach(row);
}

/* The processor as a browser runs it; the page's other end is a list. */
async function listenInWorklet() {
  let Processor;
  globalThis.sampleRate = Number(rate);
  globalThis.AudioWorkletProcessor = class {
    port = { postMessage: (message) => row(readFrame(message.slice())) };
  };
  globalThis.registerProcessor = (_, made) => (Processor = made);
  await import(pathToFileURL(place("ear-worklet.js")));
  const processor = new Processor({ processorOptions: model().forWorklet(Number(rate)) });
  const blocks = [];
  for (let at = 0; at + 128 <= samples.length; at += 128) blocks.push([[samples.subarray(at, at + 128)]]);
  processor.process([[]]);
  blocks.forEach((block) => processor.process(block));
  processor.port.postMessage = () => {};
  const again = (rounds) => {
    for (let round = 0; round < rounds; round++) for (let k = 0; k < blocks.length; k++) processor.process(blocks[k]);
  };
  again(10); // and all is compiled
  globalThis.gc();
  const before = process.memoryUsage().heapUsed;
  again(80);
  console.error((process.memoryUsage().heapUsed - before) / (80 * blocks.length));
  const idle = processor.process([[]]); // a source may come later
  processor.port.onmessage();
  console.error(idle, processor.process(blocks[0]), processor.process([[]]));
}

/* Times, phonemes, visemes and intensities come in; a mouth's weights at each time go out. */
function move() {
  const mouth = model().mouth("arkit", 7);
  for (let at = 0; at < samples.length; at += 4) {
    const [time, phoneme, viseme, intensity] = samples.subarray(at, at + 4);
    mouth.add(time, { phoneme, viseme, intensity });
    rows.push(...mouth.weights(time));
  }
}

/* Weights of the frames of a sound, by how likely visemes are. */
function blend() {
  const opened = model();
  const ear = opened.ear(Number(rate));
  [...ear.push(samples), ...ear.finish()].forEach((frame) => rows.push(...opened.blend("arkit", frame)));
}

/* Closed twice, which is once. */
function closed(opened) {
  opened.close();
  opened.close();
  return opened;
}

function refuse() {
  const damaged = Uint8Array.from(preset);
  damaged[1000] ^= 1;
  const { version } = JSON.parse(readFileSync(place("package.json")));
  const older = code.toString("latin1").replace(version, version.replace(/\d/g, "0"));
  for (const wrong of [
    () => new EarModel(new WebAssembly.Module(code), damaged),
    () => new EarModel(new WebAssembly.Module(code), code),
    () => new EarModel(new WebAssembly.Module(Buffer.from(older, "latin1")), preset),
    () => new EarModel(new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0)), preset),
    () => model().ear(500),
    () => model().mouth("nothing"),
    () => model().forWorklet(500),
    () => model().ear(44100).take(new Float32Array(4097)),
    ...["push", "take"].map((name) => () => closed(model().ear(44100))[name](new Float32Array(128))),
    ...["finish", "reset"].map((name) => () => closed(model().ear(44100))[name]()),
    () => closed(model().mouth("arkit")).weights(0),
    () => closed(model().mouth("arkit")).add(0, { phoneme: 0, viseme: 0, intensity: 0 }),
  ]) {
    try {
      wrong();
      console.error("nothing was refused");
    } catch (error) {
      console.error(`${error.name}: ${error.message}`);
    }
  }
}

/* What the module knows, and whether an ear still hears after the memory has moved beneath it. */
function tell() {
  const opened = model();
  const first = opened.ear(44100);
  for (let k = 0; k < 40; k++) opened.ear(48000);
  console.error(
    JSON.stringify({
      imports: WebAssembly.Module.imports(new WebAssembly.Module(code)),
      name: opened.name,
      lookAhead: opened.lookAhead,
      phonemes: opened.phonemes,
      visemes: opened.visemes,
      tables: opened.tables,
      shapes: opened.phonemes.map((_, phoneme) => opened.shapeOf("rhubarb", { phoneme, viseme: 255 })),
      frames: first.push(new Float32Array(44100)).length,
    }),
  );
}

await { blend, hear, listenInWorklet, move, refuse, tell }[task]();
process.stdout.write(new Uint8Array(Float64Array.from(rows).buffer));
