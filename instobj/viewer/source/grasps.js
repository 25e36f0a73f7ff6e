// Grasps as the object felt them: contacts on its skin, frame by frame, played as fast as they were.
import { Mesh, MeshLambertMaterial } from "three";
import { makeContacts } from "./contacts.js";
import { addNumber } from "./layouts.js";
import { numbers } from "./archive.js";
import { COLOURS, geometryOf } from "./object.js";
import { makeView } from "./view.js";

export function mountGrasps(host, { content, arrays }) {
  const find = (name) => host.querySelector(`[data-name="${name}"]`);
  host.hidden = false;
  const view = makeView(find("canvas"), content.size_mm);
  const skin = new MeshLambertMaterial({ color: COLOURS.silicone, transparent: true, opacity: 0.6, depthWrite: false });
  const geometry = geometryOf(arrays, "skin");
  view.scene.add(new Mesh(geometry, skin));
  content.faces.forEach((face) => addNumber(face, view));
  const contacts = makeContacts(view, find("overlay"), geometry);
  const [points, normals, pulls] = ["point_mm", "normal", "pull_n"].map((name) => numbers(arrays[name]));
  const [radii, halfwidths] = ["radius_mm", "halfwidth_n"].map((name) => numbers(arrays[name]));
  const timeS = numbers(arrays.time_s);
  const state = { grasp: 0, frame: 0, playing: 0 };
  const frames = () => content.grasps[state.grasp].frames;
  const vector = (values, k) => values.subarray(3 * k, 3 * k + 3);

  function show(grasp, frame) {
    Object.assign(state, { grasp, frame });
    const at = frames()[0] + frame;
    const first = arrays.first.data[at];
    const found = Array.from({ length: arrays.first.data[at + 1] - first }, (_, k) => {
      const [point, normal, pull] = [points, normals, pulls].map((values) => vector(values, first + k));
      const force = -(pull[0] * normal[0] + pull[1] * normal[1] + pull[2] * normal[2]);
      return { point, normal, pull, force, radius: radii[first + k], halfwidth: halfwidths[first + k] };
    });
    contacts.show(found, []);
    find("grasp").value = String(grasp);
    find("time").max = String(frames()[1] - 1);
    find("time").value = String(frame);
    const sum = found.reduce((total, { force }) => total + force, 0);
    find("felt").textContent = `${timeS[at].toFixed(2)} s: ${found.length} contacts, ${sum.toFixed(1)} N in sum`;
    find("time").setAttribute("aria-valuetext", find("felt").textContent);
  }
  function play() {
    const from = performance.now();
    const begins = timeS[frames()[0]];
    const turn = ++state.playing;
    function go(now) {
      if (turn !== state.playing) return;
      let frame = state.frame;
      while (frame < frames()[1] - 1 && timeS[frames()[0] + frame + 1] - begins <= (now - from) / 1000) frame += 1;
      if (frame !== state.frame) show(state.grasp, frame);
      if (frame < frames()[1] - 1) requestAnimationFrame(go);
    }
    show(state.grasp, 0);
    requestAnimationFrame(go);
  }
  const stop = () => (state.playing += 1);
  find("grasp").append(...content.grasps.map(({ name }, k) => new Option(name, k)));
  find("grasp").addEventListener("change", () => (stop(), show(Number(find("grasp").value), 0)));
  find("time").addEventListener("input", () => (stop(), show(state.grasp, Number(find("time").value))));
  find("play").addEventListener("click", play);
  find("home").addEventListener("click", () => view.look(4.3));
  view.draw(); // contacts follow the camera of the last picture
  // the frame of its strongest press is seen first
  show(0, content.grasps[0].peak);
  return { host, view };
}
