/* Runs the shipped examples, for tests: each for some seconds by the microphone, gives how far it moved. */
import { VRMExpression, VRMExpressionManager } from "@pixiv/three-vrm-core";
import { createElement } from "react";
import { createRoot } from "react-dom/client";
import * as THREE from "three";
import { speakingDrawing } from "./examples/flat.js";
import { Phoneme } from "./examples/react.jsx";
import { speakingHead } from "./examples/three.js";
import { speakingAvatar } from "./examples/vrm.js";

const MOST = 12_000; // milliseconds of a recording that begins after two seconds of silence

function face() {
  const geometry = new THREE.BufferGeometry();
  const corners = new THREE.Float32BufferAttribute(9, 3);
  geometry.setAttribute("position", corners);
  const target = corners.clone();
  target.name = "jawOpen";
  geometry.morphAttributes.position = [target];
  return new THREE.Mesh(geometry);
}

function avatar() {
  const expressionManager = new VRMExpressionManager();
  for (const name of ["aa", "ih", "ou", "ee", "oh"]) {
    expressionManager.registerExpression(new VRMExpression(name));
  }
  return { expressionManager };
}

async function widest({ update, close }, measured) {
  let most = 0;
  for (const begun = performance.now(); most <= 0.1 && performance.now() < begun + MOST; ) {
    await new Promise(requestAnimationFrame);
    update();
    most = Math.max(most, measured());
  }
  close();
  return most;
}

async function shown() {
  const place = document.getElementById("root");
  const root = createRoot(place);
  root.render(createElement(Phoneme));
  const words = new Set();
  for (const begun = performance.now(); words.size < 4 && performance.now() < begun + MOST; ) {
    await new Promise(requestAnimationFrame);
    words.add(place.textContent);
  }
  root.unmount();
  return [...words].filter(Boolean);
}

globalThis.tryExamples = async () => {
  const mesh = face();
  const vrm = avatar();
  const [head, drawing, person] = await Promise.all([
    speakingHead(mesh), speakingDrawing(document.querySelector("canvas")), speakingAvatar(vrm),
  ]);
  const [three, flat, vrmWidest, react] = await Promise.all([
    widest(head, () => mesh.morphTargetInfluences[0]),
    widest(drawing, () => drawing.parameters().ParamMouthOpenY),
    widest(person, () => Math.max(...vrm.expressionManager.expressions.map(({ weight }) => weight))),
    shown(),
  ]);
  return { three, flat, vrm: vrmWidest, react };
};
