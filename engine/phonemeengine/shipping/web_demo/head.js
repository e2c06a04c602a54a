// SPDX-License-Identifier: MIT
/* A head in a GLB file, whose morph targets say what is recognised; or an avatar in a VRM file, whose expressions do. */
import { VRMLoaderPlugin, VRMUtils } from "@pixiv/three-vrm";
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const BLINK = ["eyeBlinkLeft", "eyeBlinkRight"];
const BLINK_EVERY = 3.7; // seconds
const BLINK_LASTS = 0.16;
const LONGEST_STEP = 0.1; // seconds that hair and clothes move on at once, after a pause of the page, too

const still = matchMedia("(prefers-reduced-motion: reduce)");
const dark = matchMedia("(prefers-color-scheme: dark)");

/** How far lids are shut at a time in seconds, 0..1: never, where people asked for less motion. */
export function lidsAt(time) {
  const since = time % BLINK_EVERY;
  return since < BLINK_LASTS && !still.matches ? Math.sin((Math.PI * since) / BLINK_LASTS) : 0;
}

export class Head {
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera(28, 1, 0.01, 1000);
  #loader = new GLTFLoader().register((parser) => new VRMLoaderPlugin(parser));
  #head = null;
  #vrm; // of an avatar
  #faces = []; // meshes with morph targets that have names
  #time = 0;

  constructor(canvas) {
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    const light = new THREE.DirectionalLight(0xffffff, 2);
    light.position.set(1, 2, 3);
    this.#scene.add(new THREE.HemisphereLight(0xffffff, 0x555566, 1.6), light);
    this.canvas = canvas;
    const paint = () => (this.#scene.background = new THREE.Color(getComputedStyle(canvas).backgroundColor));
    dark.addEventListener("change", paint); // not clear, or clips would have a black ground
    paint();
  }

  /** Show the head of a GLB file, or the avatar of a VRM file. */
  async show(bytes) {
    const { scene, userData } = await this.#loader.parseAsync(bytes, "");
    if (this.#head) {
      this.#scene.remove(this.#head);
      VRMUtils.deepDispose(this.#head);
    }
    this.#vrm = userData.vrm;
    if (this.#vrm) VRMUtils.rotateVRM0(this.#vrm); // which look the other way
    this.#head = scene;
    this.#scene.add(scene);
    this.#faces = [];
    scene.traverse((node) => {
      if (node.morphTargetDictionary) this.#faces.push(node);
    });
    scene.updateMatrixWorld(true);
    const box = new THREE.Box3().setFromObject(scene);
    const { middle, height } = this.#vrm ? this.#framedAvatar(box) : this.#framed(box.clone());
    this.#camera.position.set(middle.x, middle.y, box.max.z + (height * 0.5) / Math.tan(THREE.MathUtils.degToRad(14)));
    this.#camera.lookAt(middle);
  }

  /* What is seen of an avatar: from its neck to above its hair. */
  #framedAvatar(box) {
    const middle = this.#vrm.humanoid.getRawBoneNode("head").getWorldPosition(new THREE.Vector3());
    const rest = box.max.y - middle.y; // above the joint of the head
    middle.y += 0.4 * rest;
    return { middle, height: 2 * rest };
  }

  /* What is seen: the face, which is four times as high as what jawOpen moves; or all, where it moves nothing. */
  #framed(all) {
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
    const shown = jaw ? box : all;
    const [middle, size] = [shown.getCenter(point), shown.getSize(way)];
    if (jaw) middle.y += size.y; // the eyes, too
    return { middle, height: jaw ? 4 * size.y : 1.1 * Math.max(size.x, size.y) };
  }

  /** The mouth table by which it moves. */
  get table() {
    return this.#vrm ? "vrm1" : "arkit";
  }

  /** The names of what it can move. */
  get movestates() {
    const expressions = this.#vrm?.expressionManager?.expressions ?? [];
    if (this.#vrm) return expressions.map(({ expressionName }) => expressionName);
    return this.#faces.flatMap((face) => Object.keys(face.morphTargetDictionary));
  }

  /** Draw it with weights by name, at a time in seconds, by which it blinks. */
  draw(weights, time) {
    const lid = lidsAt(time);
    if (this.#vrm) {
      for (const [name, weight] of [...weights, ["blink", lid]]) this.#vrm.expressionManager?.setValue(name, weight);
      this.#vrm.update(Math.min(time - this.#time, LONGEST_STEP));
    } else {
      for (const { morphTargetDictionary: targets, morphTargetInfluences: influences } of this.#faces) {
        for (const [name, k] of Object.entries(targets)) {
          influences[k] = BLINK.includes(name) ? lid : (weights.get(name) ?? 0);
        }
      }
    }
    this.#time = time;
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
