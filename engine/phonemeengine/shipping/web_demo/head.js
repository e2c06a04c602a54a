// SPDX-License-Identifier: MIT
/* A head in a GLB file, whose morph targets say what is heard. */
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const BLINK = ["eyeBlinkLeft", "eyeBlinkRight"];
const BLINK_EVERY = 3.7; // seconds
const BLINK_LASTS = 0.16;

export class Head {
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera(28, 1, 0.01, 1000);
  #head = null;
  #faces = []; // meshes with morph targets that have names

  constructor(canvas) {
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    const light = new THREE.DirectionalLight(0xffffff, 2);
    light.position.set(1, 2, 3);
    this.#scene.add(new THREE.HemisphereLight(0xffffff, 0x555566, 1.6), light);
    this.canvas = canvas;
  }

  /** Show the head of a GLB file. */
  async show(bytes) {
    const { scene } = await new GLTFLoader().parseAsync(bytes, "");
    if (this.#head) this.#scene.remove(this.#head);
    this.#head = scene;
    this.#scene.add(scene);
    this.#faces = [];
    scene.traverse((node) => {
      if (node.morphTargetDictionary) this.#faces.push(node);
    });
    const box = new THREE.Box3().setFromObject(scene);
    const middle = box.getCenter(new THREE.Vector3());
    const size = box.getSize(new THREE.Vector3());
    this.#camera.position.set(middle.x, middle.y, box.max.z + (Math.max(size.x, size.y) * 0.55) / Math.tan(0.245));
    this.#camera.lookAt(middle);
  }

  /** The names of what it can move. */
  get movestates() {
    return this.#faces.flatMap((face) => Object.keys(face.morphTargetDictionary));
  }

  /** Draw it with weights by name, at a time in seconds, by which it blinks. */
  draw(weights, time) {
    const since = time % BLINK_EVERY;
    const lid = since < BLINK_LASTS ? Math.sin((Math.PI * since) / BLINK_LASTS) : 0;
    for (const { morphTargetDictionary: targets, morphTargetInfluences: influences } of this.#faces) {
      for (const [name, k] of Object.entries(targets)) {
        influences[k] = BLINK.includes(name) ? lid : (weights.get(name) ?? 0);
      }
    }
    this.#fit();
    this.#renderer.render(this.#scene, this.#camera);
  }

  #fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const density = Math.min(devicePixelRatio, 2);
    const { x, y } = this.#renderer.getSize(new THREE.Vector2());
    if (x === width && y === height) return;
    this.#renderer.setPixelRatio(density);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / Math.max(height, 1);
    this.#camera.updateProjectionMatrix();
  }
}
