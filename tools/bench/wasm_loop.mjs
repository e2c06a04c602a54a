/*
 * Has the shipped module listen to blocks of 10 ms: node wasm_loop.mjs FOLDER, with the samples in FOLDER/samples.f32.
 * For each line that comes in it hears all of them, and writes how much of the processor that took, in seconds.
 */
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const HOP = 441;

const place = (name) => join(process.argv[2], name);
const { EarModel } = await import(pathToFileURL(place("ear.js")));
const { buffer, byteOffset, length } = readFileSync(place("samples.f32"));
const samples = new Float32Array(buffer.slice(byteOffset, byteOffset + length));
const hops = Array.from({ length: samples.length / HOP }, (_, k) => samples.subarray(HOP * k, HOP * (k + 1)));
const ear = new EarModel(new WebAssembly.Module(readFileSync(place("ear.wasm"))), readFileSync(place("preset.ear"))).ear(44100);

createInterface({ input: process.stdin }).on("line", () => {
  const began = process.cpuUsage();
  hops.forEach((hop) => ear.take(hop));
  console.log(process.cpuUsage(began).user / 1e6);
});
