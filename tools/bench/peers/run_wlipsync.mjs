// Recognises sounds with wLipSync's WebAssembly, in Node; see tools/bench/peers/peer.py. The package has no profile, which everybody calibrates for
// a voice: here by the labels of the recordings, of the speaker himself ("own") or of all others ("others").
import fs from "node:fs";
import path from "node:path";

const RATE = 44_100;
const MFCC = 12;
const QUIET = -2.5; // The decadic logarithm of a volume below which the package's node shows nothing.
const [, , jobs, told] = process.argv;
const { profile: whose, names } = JSON.parse(told);
const BLOCK = 512; // Samples between two answers, as in its AudioWorklet.
const L2 = 1; // The norm by which the nearest phoneme is found.
const settings = { targetSampleRate: 16_000, sampleCount: 1024, melFilterBankChannels: 30 };
const wasm = await WebAssembly.compile(fs.readFileSync(path.join(process.env.NODE_PATH, "wlipsync/dist/wlipsync.wasm")));
const sounds = JSON.parse(fs.readFileSync(jobs));

// Gives [time, volume, best phoneme, MFCCs] of each block.
function analyse(sound, profile) {
  const memory = new WebAssembly.Memory({ initial: 4 });
  const { exports } = new WebAssembly.Instance(wasm, { env: { memory } });
  const at = (address, n) => new Float32Array(memory.buffer, address, n);
  const values = exports.load_profile(settings.targetSampleRate, settings.sampleCount, settings.melFilterBankChannels, L2, profile.names.length, 1, 0);
  at(values, profile.values.length).set(profile.values);
  exports.precompute_profile();
  exports.set_input(RATE);
  const size = exports.get_input_buffer_size();
  const ring = at(exports.get_input_buffer(), size);
  const volume = at(exports.get_volume_ptr(), 1);
  const mfcc = at(exports.mfccOut.value, MFCC);
  const bytes = fs.readFileSync(sound.path);
  const samples = Float32Array.from(new Int16Array(bytes.buffer, bytes.byteOffset, bytes.length / 2), (value) => value / 32_768);
  const found = [];
  const began = process.cpuUsage();
  for (let first = 0; first + BLOCK <= samples.length; first += BLOCK) {
    for (let k = 0; k < BLOCK; k++) ring[(first + k) % size] = samples[first + k];
    const best = exports.execute((first + BLOCK) % size);
    found.push([(first + BLOCK) / RATE, volume[0], best, Array.from(mfcc)]);
  }
  const used = process.cpuUsage(began);
  return { found, seconds: (used.user + used.system) / 1e6, length: samples.length / RATE };
}

// What a profile is made of: MFCCs where a label says which sound it is, half a window earlier than they were told.
function takes() {
  const middle = settings.sampleCount / settings.targetSampleRate / 2;
  const blank = { names: ["-"], values: new Array(MFCC).fill(0) };
  return sounds.flatMap((sound) => analyse(sound, blank).found.flatMap(([time, volume, , mfcc]) => {
    const label = sound.labels.find(([start, end]) => start <= time - middle && time - middle < end);
    const usable = label && names.includes(label[2]) && Math.log10(volume) > QUIET && mfcc.every(Number.isFinite);
    return usable ? [{ speaker: sound.speaker, name: label[2], mfcc }] : [];
  }));
}

const mean = (rows) => Array.from({ length: MFCC }, (_, k) => rows.reduce((sum, row) => sum + row[k], 0) / rows.length);

function profileOf(chosen) {
  const here = names.filter((name) => chosen.some((take) => take.name === name));
  const centres = here.map((name) => mean(chosen.filter((take) => take.name === name).map((take) => take.mfcc)));
  return { names: here, values: centres.flat() };
}

const all = takes();
const profiles = new Map();
for (const sound of sounds) {
  if (!profiles.has(sound.speaker)) {
    profiles.set(sound.speaker, profileOf(all.filter((take) => (take.speaker === sound.speaker) === (whose === "own"))));
  }
  const profile = profiles.get(sound.speaker);
  const { found, seconds, length } = analyse(sound, profile);
  const name = ([, volume, best]) => (Math.log10(volume) > QUIET && best >= 0 ? profile.names[best] : "silence");
  const marks = found.map((frame, k) => [frame[0], found[k + 1]?.[0] ?? length, name(frame)]);
  console.log(JSON.stringify({ seconds, marks }));
}
