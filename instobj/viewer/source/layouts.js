// Layouts of a search: the start's parts move over into those of a found layout.
import {
  BoxGeometry, BufferGeometry, CylinderGeometry, EdgesGeometry, Float32BufferAttribute, Group, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, MeshLambertMaterial, Quaternion, Vector3,
} from "three";
import { drawFront } from "./front.js";
import { shownNumber } from "./maps.js";
import { COLOURS, geometryOf } from "./object.js";
import { facing, label, makeView } from "./view.js";

const PLAYED_MS = 2500;

export function mountLayouts(host, { content, arrays }) {
  const find = (name) => host.querySelector(`[data-name="${name}"]`);
  host.hidden = false;
  const view = makeView(find("canvas"), content.size_mm);
  const [start] = content.layouts;
  const box = !arrays.body_mm;
  const shells = [["body", COLOURS.silicone, 0.18], ["core", COLOURS.core, 0.4]]
    .filter(([name]) => box || arrays[`${name}_mm`])
    .map(([name, ...look]) => ({ name, ...makeShell(box ? new BoxGeometry(2, 2, 2) : geometryOf(arrays, name), ...look, view) }));
  const magnets = makePool(view, () => makeMagnet());
  const chips = makePool(view, () => boxOf(COLOURS.chip));
  const boards = makePool(view, () => boxOf(COLOURS.board));
  const ways = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: 0xd81b9a, depthTest: false, transparent: true }));
  ways.renderOrder = 4;
  view.scene.add(ways);
  content.faces.forEach((face) => addNumber(face, view));
  const state = { shown: Math.min(1, content.layouts.length - 1), share: 1 };
  const front = find("front") && drawFront(find("front"), content, (index) => choose(index, 1));

  function draw() {
    const after = content.layouts[state.shown];
    const part = state.share;
    shells.forEach((one) => one.place(between(start[one.name], after[one.name], part)));
    magnets.place(pairs(start.magnets, after.magnets, after.magnet_from, part));
    chips.place(pairs(start.chips, after.chips, after.sensor_from, part));
    boards.place(pairs(start.boards, after.boards, after.sensor_from, part));
    const ends = after.magnets.flatMap((one, k) => (after.magnet_from[k] < 0 ? [] : [...start.magnets[after.magnet_from[k]].at, ...one.at]));
    ways.geometry.setAttribute("position", new Float32BufferAttribute(ends, 3));
    ways.geometry.computeBoundingSphere();
    view.redraw();
  }
  function tell() {
    const after = content.layouts[state.shown];
    find("scores").replaceChildren(...content.objectives.map((objective, k) => {
      const line = document.createElement("tr");
      [objective, shownNumber(start.scores[k]), shownNumber(after.scores[k])].forEach((cell) => line.insertCell().append(cell));
      return line;
    }));
    find("after").textContent = after.label;
    find("share").setAttribute("aria-valuetext", `${Math.round(100 * state.share)} % of the way to ${after.label}`);
    front?.mark(state.shown);
  }
  function choose(shown, share) {
    Object.assign(state, { shown, share });
    find("layout").value = String(shown);
    find("share").value = String(100 * share);
    tell();
    draw();
  }
  find("layout").append(...content.layouts.slice(1).map((one, k) => new Option(one.label, k + 1)));
  find("layout").addEventListener("change", () => choose(Number(find("layout").value), state.share));
  find("share").addEventListener("input", () => choose(state.shown, Number(find("share").value) / 100));
  find("opacity").addEventListener("input", () => shells.forEach((one) => one.fade(Number(find("opacity").value) / 100)));
  find("home").addEventListener("click", () => view.look(4.3));
  find("play").addEventListener("click", () => play((share) => choose(state.shown, share)));
  choose(state.shown, 1);
  return { host, view };
}

function play(show) {
  const from = performance.now();
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  function go(now) {
    const share = still ? 1 : Math.min(1, Math.max(0, (now - from) / PLAYED_MS));
    show(share);
    if (share < 1) requestAnimationFrame(go);
  }
  requestAnimationFrame(go);
}

const mix = (a, b, share) => a.map((value, k) => value + share * (b[k] - value));

export function quaternionOf(axes) {
  const [a, b, c, d, e, f, g, h, i] = axes;
  return new Quaternion().setFromRotationMatrix(new Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1));
}

// A part on its way: centre, axes as columns, half edges (of a magnet: radius, radius, half its height).
function between(from, to, share) {
  const turn = quaternionOf(from.axes).slerp(quaternionOf(to.axes), share);
  return { at: mix(from.at, to.at, share), turn, half: mix(from.half, to.half, share) };
}

// Parts of both layouts; those that only one of them has grow or shrink where they are.
function pairs(before, after, origin, share) {
  const grown = (one, by) => ({ ...one, half: one.half.map((half) => half * by) });
  const alone = before.filter((_, index) => !origin.includes(index));
  return [
    ...after.map((one, k) => between(origin[k] < 0 ? grown(one, 0) : before[origin[k]], one, share)),
    ...alone.map((one) => between(one, grown(one, 0), share)),
  ];
}

export function makePool(view, make) {
  const made = [];
  function place(parts) {
    while (made.length < parts.length) {
      made.push(make());
      view.scene.add(made.at(-1));
    }
    made.forEach((object, k) => {
      object.visible = k < parts.length && Math.min(...parts[k].half) > 1e-4;
      if (!object.visible) return;
      object.position.set(...parts[k].at);
      object.quaternion.copy(parts[k].turn);
      object.scale.set(...parts[k].half);
    });
  }
  return { place };
}

export const boxOf = (colour) => new Mesh(new BoxGeometry(2, 2, 2), new MeshLambertMaterial({ color: colour }));

export function makeMagnet() {
  const group = new Group();
  for (const [colour, side] of [[COLOURS.north, 0.5], [COLOURS.south, -0.5]]) {
    const half = new Mesh(new CylinderGeometry(1, 1, 1, 32), new MeshLambertMaterial({ color: colour }));
    half.rotation.x = Math.PI / 2;
    half.position.z = side;
    group.add(half);
  }
  return group;
}

function makeShell(geometry, colour, opacity, view) {
  const material = new MeshLambertMaterial({ color: colour, transparent: true, opacity, depthWrite: false });
  const shell = new Mesh(geometry, material);
  shell.add(new LineSegments(new EdgesGeometry(geometry, 35), new LineBasicMaterial({ color: 0x30373f })));
  const pool = makePool(view, () => shell);
  const fade = (share) => {
    material.opacity = opacity * 2 * share;
    view.redraw();
  };
  return { place: (one) => pool.place([one]), fade };
}

export function addNumber(face, view) {
  const sprite = label(String(face.number), view.size / 8);
  sprite.position.set(...face.centre_mm).addScaledVector(new Vector3(...face.normal), view.size * 0.09);
  view.scene.add(sprite);
  view.before.push((camera) => (sprite.visible = facing(face, camera)));
}
