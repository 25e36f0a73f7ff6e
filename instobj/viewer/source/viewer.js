// One view of an object: builds it from its archive, and joins controls, pointer and numbers.
import { Raycaster, Vector2 } from "three";
import { drawBars, fillTable } from "./bars.js";
import { drawLegend, makeMaps, placeOn, shownNumber } from "./maps.js";
import { buildMould, buildObject } from "./object.js";
import { makePress } from "./press.js";
import { makeView } from "./view.js";

const MOVED_PX = 5;
const OPENING_MS = 3000;

let count = 0;

// The view within an element that holds the markup of viewer.html.j2.
export function mountObject(host, scene) {
  const find = (name) => host.querySelector(`[data-name="${name}"]`);
  const { content } = scene;
  host.hidden = false;
  host.querySelectorAll("[type=radio]").forEach((radio) => {
    radio.name = `scene-${count}`; // of this view alone
    radio.checked = radio.value === "object";
  });
  count += 1;
  const view = makeView(find("canvas"), content.size_mm);
  const object = buildObject(scene, view);
  const mould = buildMould(scene, view);
  view.scene.add(object.root, mould.root);
  const maps = makeMaps(scene, object, view);
  const press = makePress(scene, object, view);
  const numberOf = numberedSensors(press.signals());
  const watchers = [];

  function tell() {
    const { face, place, step } = press.state;
    const { x_mm: x, y_mm: y } = content.grid;
    const ny = y.length;
    const depth = step ? press.depths[step - 1] : 0;
    const error = step ? content.press.force_error[step - 1] : null;
    const { most, least } = press.circle(face, place);
    find("place").textContent = `face ${content.faces[face].number} (${x[Math.floor(place / ny)]}, ${y[place % ny]}) mm`;
    find("travel").textContent = `${depth.toFixed(2)} mm`;
    find("force").textContent = `${press.force().toFixed(2)} N`;
    find("error").textContent = error === null ? "" : `± ${(100 * error).toFixed(1)} % by the mesh (rms)`;
    find("bound").textContent = `${shownNumber(most)} × ${shownNumber(least)} mm`;
    find("ring").textContent = press.ringScale > 1 ? `rings drawn ${press.ringScale} times as large` : "";
    find("score").textContent = maps.shown() ? `${shownNumber(maps.valueAt(face, place))} ${maps.shown().unit}` : "–";
    const signals = press.signals().map((one) => ({ ...one, number: numberOf[one.sensor] }));
    drawBars(find("bars"), signals);
    fillTable(find("counts"), signals);
    find("depth").setAttribute("aria-valuetext", `${depth} mm deep`);
  }
  function choose(face, place, step) {
    press.set(face, place, step);
    find("face").value = String(face);
    find("x").value = String(Math.floor(place / content.grid.y_mm.length));
    find("y").value = String(place % content.grid.y_mm.length);
    find("depth").value = String(step);
    tell();
    watchers.forEach((act) => act(press.state));
  }
  fillControls(find, content, press);
  joinControls(find, { scene, object, mould, maps, press, choose, tell, view, content });
  joinPointer(find, { scene, view, object, maps, press, choose });
  const middle = nearestPlace(press, scene, 0, 0, 0);
  choose(0, middle, Math.ceil(press.depths.length / 2));
  object.fade(Number(find("opacity").value) / 100);
  const near = (face, x, y) => nearestPlace(press, scene, face, x, y);
  return { host, find, content, view, maps, press, choose, near, watchers };
}

function numberedSensors(signals) {
  const seen = {};
  return signals.map(({ face }) => (seen[face] = (seen[face] ?? 0) + 1));
}

function fillControls(find, content, press) {
  const option = (value, text) => new Option(text, value);
  find("face").append(...content.faces.map((face, index) => option(index, face.number)));
  find("x").append(...content.grid.x_mm.map((x, index) => option(index, `${x} mm`)));
  find("y").append(...content.grid.y_mm.map((y, index) => option(index, `${y} mm`)));
  find("map").append(...content.maps.map(({ stem, title }) => option(stem, title)));
  find("depth").max = String(press.depths.length);
  find("mould-choice").hidden = !content.mould.length;
}

function joinControls(find, { scene, object, mould, maps, press, choose, tell, view, content }) {
  const on = (name, event, act) => find(name).addEventListener(event, act);
  const number = (name) => Number(find(name).value);
  on("explode", "input", () => { object.explode(number("explode") / 100); press.follow(); view.look(4.3 + number("explode") / 45, number("explode") / 220, true); });
  on("opacity", "input", () => object.fade(number("opacity") / 100));
  const clip = () => object.clip(find("clip-axis").value, number("clip") / 100);
  on("clip-axis", "change", clip);
  on("clip", "input", clip);
  on("map", "change", () => {
    const found = maps.show(find("map").value);
    drawLegend(find("legend"), found);
    if (found) find("opacity").value = "100";
    object.fade(number("opacity") / 100);
    tell();
  });
  for (const name of ["face", "x", "y"]) {
    on(name, "change", () => {
      const [x, y] = [content.grid.x_mm[number("x")], content.grid.y_mm[number("y")]];
      choose(number("face"), nearestPlace(press, scene, number("face"), x, y), press.state.step);
    });
  }
  on("depth", "input", () => choose(press.state.face, press.state.place, number("depth")));
  const home = () => (mould.root.visible ? view.frame(mould.bounds()) : view.look(4.3));
  on("home", "click", home);
  for (const radio of find("scenes").querySelectorAll("input")) {
    radio.addEventListener("change", () => {
      const which = find("scenes").querySelector("input:checked").value;
      object.root.visible = which === "object";
      mould.root.visible = which === "mould";
      find("object-controls").hidden = which !== "object";
      find("mould-controls").hidden = which !== "mould";
      view.ground.visible = which === "object";
      press.follow();
      home();
    });
  }
  on("opening", "input", () => mould.open(number("opening") / 100));
  on("open", "click", () => playOpening(find, mould));
}

function playOpening(find, mould) {
  const from = performance.now();
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  function go(now) {
    const share = still ? 1 : Math.min(1, (now - from) / OPENING_MS);
    find("opening").value = String(100 * share);
    mould.open(share);
    if (share < 1) requestAnimationFrame(go);
  }
  requestAnimationFrame(go);
}

// Of the contact locations that the face has.
function nearestPlace(press, { arrays }, face, x, y) {
  let [best, least] = [0, Infinity];
  const { data } = arrays.place_xy_mm;
  for (let place = 0; place < press.places; place++) {
    const far = Math.hypot(data[2 * place] - x, data[2 * place + 1] - y);
    if (far < least && Number.isFinite(arrays.force_n.data[(face * press.places + place) * press.depths.length])) [best, least] = [place, far];
  }
  return best;
}

// Whether a place is at most half a pitch beside a contact location, as far as maps reach.
function within({ x_mm: x, y_mm: y }, location, place) {
  return [x, y].every((nodes, axis) => Math.abs(location[axis] - place[axis]) <= (nodes.length > 1 ? nodes[1] - nodes[0] : 1) / 2 + 1e-3);
}

function joinPointer(find, { scene, view, object, maps, press, choose }) {
  const canvas = find("canvas");
  const caster = new Raycaster();
  const { content } = scene;
  const front = object.silicone.front;
  // Face and contact location under the pointer, by the silicone at rest.
  function under(event) {
    if (!object.root.visible) return null;
    const box = canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    caster.setFromCamera(at, view.camera);
    const hit = caster.intersectObject(front, false).find(({ point }) => front.material.clippingPlanes.every((p) => p.distanceToPoint(point) >= 0));
    if (!hit) return null;
    const corners = [hit.face.a, hit.face.b, hit.face.c];
    const face = Math.max(...corners.map((v) => maps.owner[v]));
    if (face < 0) return null;
    const local = hit.point.clone().sub(object.offset());
    const [x, y] = placeOn(content.faces[face], local.x, local.y, local.z);
    const place = nearestPlace(press, scene, face, x, y);
    return { face, x, y, place, judged: within(content.grid, press.xy(place), [x, y]) };
  }
  let down = null;
  canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  canvas.addEventListener("pointerup", (event) => {
    const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < MOVED_PX;
    down = null;
    const found = still && under(event);
    if (found) choose(found.face, found.place, press.state.step || press.depths.length);
  });
  canvas.addEventListener("pointerleave", () => {
    press.hover(null);
    find("under").textContent = "";
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons) return;
    const found = under(event);
    press.hover(found?.judged ? found : null);
    if (!found) return void (find("under").textContent = "");
    const at = `face ${content.faces[found.face].number} (${found.x.toFixed(1)}, ${found.y.toFixed(1)}) mm`;
    if (!found.judged) return void (find("under").textContent = `${at}: not judged`);
    const { most, least } = press.circle(found.face, found.place);
    const value = maps.shown() ? `${maps.shown().title} ${shownNumber(maps.valueAt(found.face, found.place))} ${maps.shown().unit}; ` : "";
    find("under").textContent = `${at}: ${value}σ ${shownNumber(most)} × ${shownNumber(least)} mm`;
  });
}
