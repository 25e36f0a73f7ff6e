// What a page starts once it is painted, and what a notebook's widget renders.
import { bytesOf, readArchive } from "./archive.js";
import { mountGrasps } from "./grasps.js";
import { mountLayouts } from "./layouts.js";
import { linkViews } from "./linked.js";
import { mountObject } from "./viewer.js";
import { startExplore } from "./explore.js";
import "./live.js";

const SHOWN = "instobj objects shown";
const KINDS = { object: mountObject, layouts: mountLayouts, grasps: mountGrasps };

async function mount(host, packed) {
  try {
    return KINDS[host.dataset.kind](host, await readArchive(packed));
  } catch (error) {
    host.hidden = true;
    host.parentElement.querySelector(".no-viewer").textContent = `No view in three dimensions: ${error.message}.`;
    console.warn(error);
    return null;
  }
}

async function startPage() {
  const hosts = [...document.querySelectorAll(".viewer[data-scene]")];
  const archive = (host) => bytesOf(document.getElementById(host.dataset.scene).textContent);
  const views = await Promise.all(hosts.map((host) => mount(host, archive(host))));
  const objects = views.filter((one) => one?.press);
  if (objects.length > 1) linkViews(objects);
  hosts.forEach((host) => !host.hidden && (host.dataset.ready = "yes"));
  // Pictures are asked for by now: drawn in the next frame, on the screen by the one after it.
  requestAnimationFrame(() => requestAnimationFrame(() => performance.mark(SHOWN)));
}

// anywidget: the markup and the scene are traits of the model.
export async function render({ model, el }) {
  el.innerHTML = model.get("markup");
  if (el.querySelector("#instobj-explore")) {
    el.classList.add("explore-widget");
    return startExplore(el, model);
  }
  const scene = model.get("scene");
  const packed = new Uint8Array(scene.buffer, scene.byteOffset, scene.byteLength);
  const found = await mount(el.querySelector(".viewer"), packed);
  if (found) found.host.dataset.ready = "yes";
}

// After two frames what stands above the view is on the screen.
if (document.querySelector(".viewer[data-scene]")) requestAnimationFrame(() => setTimeout(startPage));
