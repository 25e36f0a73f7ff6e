// Scores as colours on the body: one scale, dark is weak, numbers in the legend.
import { Color } from "three";
import { numbers } from "./archive.js";
import { COLOURS } from "./object.js";

// viridis (Smith and van der Walt, CC0): perceptually uniform, also without red or green.
const VIRIDIS = [
  "440154", "482475", "414487", "355f8d", "2a788e", "21918c", "22a884", "44bf70", "7ad151", "bddf26", "fde725",
].map((hex) => new Color(`#${hex}`));
const NO_DATA = new Color(0xc9c9c4);
const PLAIN = new Color(COLOURS.silicone);

function viridis(share, into) {
  const at = Math.min(0.9999, Math.max(0, share)) * (VIRIDIS.length - 1);
  return into.lerpColors(VIRIDIS[Math.floor(at)], VIRIDIS[Math.floor(at) + 1], at % 1);
}

// Which face each vertex of the silicone belongs to: the one that looks most its way, −1 for none.
export function facesOfVertices({ content, arrays }) {
  const normals = numbers(arrays.silicone_normals);
  const owner = new Int8Array(normals.length / 3).fill(-1);
  const best = new Float32Array(owner.length).fill(-2);
  const { link_vertex: vertices, link_source: sources } = arrays;
  vertices.data.forEach((vertex, link) => {
    const face = faceOfSource(content, sources.data[link]);
    const n = content.faces[face].normal;
    const facing = n[0] * normals[3 * vertex] + n[1] * normals[3 * vertex + 1] + n[2] * normals[3 * vertex + 2];
    if (facing > Math.max(best[vertex], 0.3)) [owner[vertex], best[vertex]] = [face, facing];
  });
  return owner;
}

function faceOfSource(content, source) {
  let face = 0;
  for (let left = source; left >= content.face_vertices[face]; face++) left -= content.face_vertices[face];
  return face;
}

// In-plane place (x, y) on a face of a point in the object's frame.
export function placeOn(face, x, y, z) {
  const [dx, dy, dz] = [x - face.centre_mm[0], y - face.centre_mm[1], z - face.centre_mm[2]];
  return [face.x, face.y].map((a) => dx * a[0] + dy * a[1] + dz * a[2]);
}

// A score between the contact locations: bilinear over those that have one, NaN beyond half a pitch.
function between(values, first, grid, [x, y]) {
  const [a, b] = [along(grid.x_mm, x), along(grid.y_mm, y)];
  if (!a || !b) return NaN;
  let [sum, weights] = [0, 0];
  for (const [i, wi] of a) {
    for (const [j, wj] of b) {
      const value = values[first + i * grid.y_mm.length + j];
      if (Number.isFinite(value)) [sum, weights] = [sum + wi * wj * value, weights + wi * wj];
    }
  }
  return weights > 0.2 ? sum / weights : NaN;
}

function along(nodes, at) {
  const pitch = nodes.length > 1 ? nodes[1] - nodes[0] : 1;
  const place = (at - nodes[0]) / pitch;
  if (place < -0.51 || place > nodes.length - 0.49) return null;
  const held = Math.min(nodes.length - 1, Math.max(0, place));
  const low = Math.min(Math.floor(held), Math.max(0, nodes.length - 2));
  return [[low, 1 - (held - low)], [Math.min(low + 1, nodes.length - 1), held - low]];
}

export function shownNumber(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  return size >= 1e4 || (size < 1e-3 && size > 0) ? value.toExponential(1) : value.toPrecision(3);
}

export function makeMaps(scene, object, view) {
  const { content, arrays } = scene;
  const owner = facesOfVertices(scene);
  const rest = numbers(arrays.silicone_mm);
  const places = content.grid.x_mm.length * content.grid.y_mm.length;
  const colours = object.silicone.front.geometry.attributes.color;
  let shown = null;

  function scaleOf(map) {
    const values = Array.from(arrays[`map_${map.stem}`].data).filter((v) => Number.isFinite(v) && (!map.log || v > 0));
    const ends = [Math.min(...values), Math.max(...values)];
    const [low, high] = map.log ? ends.map(Math.log) : ends;
    const share = (value) => ((map.log ? Math.log(value) : value) - low) / (high - low || 1);
    const at = (part) => { const v = low + part * (high - low); return map.log ? Math.exp(v) : v; };
    return { share: (value) => (map.weak === "high" ? 1 - share(value) : share(value)), at };
  }
  function show(stem) {
    shown = content.maps.find((map) => map.stem === stem) ?? null;
    const scale = shown && scaleOf(shown);
    const values = shown && arrays[`map_${shown.stem}`].data;
    const colour = new Color();
    for (let vertex = 0; vertex < owner.length; vertex++) {
      let chosen = PLAIN;
      if (shown && owner[vertex] >= 0) {
        const face = content.faces[owner[vertex]];
        const value = between(values, owner[vertex] * places, content.grid, placeOn(face, ...rest.subarray(3 * vertex, 3 * vertex + 3)));
        chosen = Number.isFinite(value) ? viridis(scale.share(value), colour) : NO_DATA;
      }
      colours.setXYZ(vertex, chosen.r, chosen.g, chosen.b);
    }
    colours.needsUpdate = true;
    view.redraw();
    return shown && { map: shown, at: scale.at };
  }
  const valueAt = (face, place) => shown && arrays[`map_${shown.stem}`].data[face * places + place];
  return { owner, show, valueAt, shown: () => shown };
}

export function drawLegend(box, found) {
  box.hidden = !found;
  if (!found) return;
  const stops = VIRIDIS.map((c) => `#${c.getHexString()}`);
  if (found.map.weak === "high") stops.reverse();
  box.querySelector(".scale").style.background = `linear-gradient(to right, ${stops})`;
  const ticks = box.querySelectorAll(".ticks span");
  ticks.forEach((tick, index) => (tick.textContent = shownNumber(found.at(index / (ticks.length - 1)))));
  const { title, unit, log, force_n: force } = found.map;
  box.querySelector(".title").textContent = `${title}, ${unit} at ${force} N${log ? ", logarithmic" : ""}. Dark is weak; grey: not judged.`;
}
