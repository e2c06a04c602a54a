// SPDX-License-Identifier: MIT
/* Keeps the page for when there is no network: what the server gives is shown first, and what is kept where it gives nothing. */
const KEPT = "phonemes";
const FILES = [
  "./",
  "clip.js",
  "demo.css",
  "demo.js",
  "head.glb",
  "head.js",
  "spectrum.js",
  "three-vrm/lib/three-vrm.module.min.js",
  "three/build/three.core.js",
  "three/build/three.module.js",
  "three/examples/jsm/loaders/GLTFLoader.js",
  "three/examples/jsm/utils/BufferGeometryUtils.js",
  "three/examples/jsm/utils/SkeletonUtils.js",
  "../ear.js",
  "../ear.wasm",
  "../preset.ear",
];

self.addEventListener("install", (event) => event.waitUntil(caches.open(KEPT).then((cache) => cache.addAll(FILES))));
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", (event) => {
  if (event.request.method === "GET" && event.request.url.startsWith("http")) event.respondWith(answer(event.request));
});

async function answer(request) {
  const cache = await caches.open(KEPT);
  try {
    const found = await fetch(request);
    if (found.ok) await cache.put(request, found.clone());
    return found;
  } catch {
    return (await cache.match(request)) ?? Response.error();
  }
}
