// SPDX-License-Identifier: MIT
/* A head in a GLB file, whose morph targets say what is recognised. */
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
    const { middle, height } = this.#framed(scene);
    const front = new THREE.Box3().setFromObject(scene).max.z;
    this.#camera.position.set(middle.x, middle.y, front + (height * 0.5) / Math.tan(THREE.MathUtils.degToRad(14)));
    this.#camera.lookAt(middle);
  }

  /* What is seen: the face, which is four times as high as what jawOpen moves; or all, where it moves nothing. */
  #framed(scene) {
    scene.updateMatrixWorld(true);
    const box = new THREE.Box3();
    const [point, way] = [new THREE.Vector3(), new THREE.Vector3()];
    for (const face of this.#faces) {
      const target = face.geometry.morphAttributes.position?.[face.morphTargetDictionary.jawOpen];
      const { position } = face.geometry.attributes;
      const ways = Array.from({ length: target?.count ?? 0 }, (_, k) => way.fromBufferAttribute(target, k).length());
      const much = 0.3 * ways.reduce((most, one) => Math.max(most, one), 0); // the neck moves a little, too
      for (let k = 0; k < ways.length; k++) {
        if (ways[k] <= much) continue;
        box.expandByPoint(face.localToWorld(point.fromBufferAttribute(position, k)));
      }
    }
    const jaw = !box.isEmpty();
    const shown = jaw ? box : box.setFromObject(scene);
    const [middle, size] = [shown.getCenter(point), shown.getSize(way)];
    if (jaw) middle.y += size.y; // the eyes, too
    return { middle, height: jaw ? 4 * size.y : 1.1 * Math.max(size.x, size.y) };
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
