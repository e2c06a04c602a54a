// Recognises sounds with HeadAudio's processor, in Node; see tools/bench/peers/peer.py. It is fed as an AudioWorklet is, and its own visemes are
// told: what its node makes of them, blend shapes with easing, comes later, and leaves aa out.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const BLOCK = 128;
const RATE = 44_100;
const home = path.join(process.env.NODE_PATH, "@met4citizen/headaudio");
const load = (name) => import(pathToFileURL(path.join(home, "modules", name)));
const [{ Processor }, { Training }, parameters] = await Promise.all(["processor.mjs", "training.mjs", "parameters.mjs"].map(load));
const NAMES = ["aa", "E", "I", "O", "U", "PP", "SS", "TH", "DD", "FF", "kk", "nn", "RR", "CH", "sil"];

function prototypes() {
  const file = fs.readFileSync(path.join(home, "dist/model-en-mixed.bin"));
  const training = new Training();
  const found = [];
  for (let at = 0; at + parameters.RECORD_OFFSET <= file.length; at += parameters.RECORD_OFFSET) {
    const record = new Float32Array(parameters.RECORD_LEN);
    new Uint8Array(record.buffer).set(file.subarray(at, at + 4 * parameters.RECORD_LEN));
    found.push(training.decodeBinaryRecord(record));
  }
  return found;
}

const model = prototypes();
for (const sound of JSON.parse(fs.readFileSync(process.argv[2]))) {
  const bytes = fs.readFileSync(sound.path);
  const samples = Float32Array.from(new Int16Array(bytes.buffer, bytes.byteOffset, bytes.length / 2), (value) => value / 32_768);
  const told = [[0, "sil"]];
  const port = { onmessage: null, postMessage: (message) => message.viseme === null || told.push([now(), NAMES[message.viseme] ?? message.event]) };
  const processor = new Processor({ sampleRate: RATE }, { port });
  const now = () => processor.sampleCount / parameters.AUDIO_SAMPLE_RATE;
  processor._onmessage({ data: { event: "model", model } });
  const began = process.cpuUsage();
  for (let at = 0; at < samples.length; at += BLOCK) processor.process(samples.subarray(at, at + BLOCK));
  const used = process.cpuUsage(began);
  const changes = told.filter(([, name]) => name !== "started");
  const marks = changes.map(([start, name], k) => [start, changes[k + 1]?.[0] ?? samples.length / RATE, name === "ended" ? "sil" : name]);
  console.log(JSON.stringify({ seconds: (used.user + used.system) / 1e6, marks }));
}
