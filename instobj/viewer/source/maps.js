// Scores as colours on the body: one scale, dark is weak, numbers in the legend.
import { BufferAttribute, Color, DataTexture, LinearFilter, SRGBColorSpace, Vector3 } from "three";
import { numbers } from "./archive.js";

// viridis (Smith and van der Walt, CC0): perceptually uniform, also without red or green.
const VIRIDIS = [
  "440154", "482475", "414487", "355f8d", "2a788e", "21918c", "22a884", "44bf70", "7ad151", "bddf26", "fde725",
].map((hex) => new Color(`#${hex}`));

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

// Place (x, y) on a face of a point in the object's frame: lengths along a curved one.
export function placeOn(face, x, y, z) {
  const [dx, dy, dz] = [x - face.centre_mm[0], y - face.centre_mm[1], z - face.centre_mm[2]];
  return [face.x, face.y].map((a, axis) => along(face.sections?.[axis], "plane_mm", "length_mm", dx * a[0] + dy * a[1] + dz * a[2]));
}

// In-plane x and y of a place.
export function inPlane(face, place) {
  return place.map((length, axis) => along(face.sections?.[axis], "length_mm", "plane_mm", length));
}

// Straight between the knots of a section and beyond its ends; as given where there is none, as on flat faces.
function along(section, from, to, value) {
  if (!section) return value;
  const [xs, ys] = [section[from], section[to]];
  const beyond = xs.findIndex((x) => x > value);
  const k = Math.max(1, beyond < 0 ? xs.length - 1 : beyond);
  return ys[k - 1] + ((value - xs[k - 1]) * (ys[k] - ys[k - 1])) / (xs[k] - xs[k - 1]);
}

export function shownNumber(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  return size >= 1e4 || (size < 1e-3 && size > 0) ? value.toExponential(1) : value.toPrecision(3);
}

// Place of every vertex on its face, in steps of the grid, and the face; −1 where it has none.
function charts({ content, arrays }, owner) {
  const rest = numbers(arrays.silicone_mm);
  const chart = new Float32Array(rest.length).fill(-1);
  const pitch = (nodes) => (nodes.length > 1 ? nodes[1] - nodes[0] : 1);
  const { x_mm: xs, y_mm: ys } = content.grid;
  owner.forEach((index, vertex) => {
    if (index < 0) return;
    const [x, y] = placeOn(content.faces[index], ...rest.subarray(3 * vertex, 3 * vertex + 3));
    chart.set([(x - xs[0]) / pitch(xs), (y - ys[0]) / pitch(ys), index], 3 * vertex);
  });
  return chart;
}

const VERTEX = "attribute vec3 chart; varying vec4 onFace;\n";
const FRAGMENT = `varying vec4 onFace; uniform sampler2D score; uniform vec3 grid; uniform float mapped;
vec3 mapColour(vec3 plain) {
  if (mapped < 0.5) return plain;
  float face = floor(onFace.z + 0.5);
  vec2 last = grid.xy - 1.0;
  bool judged = face >= 0.0 && abs(onFace.z - face) < 0.01 && abs(onFace.w - onFace.z * onFace.z) < 0.01
    && all(greaterThan(onFace.xy, vec2(-0.5))) && all(lessThan(onFace.xy, last + 0.5));
  vec2 at = clamp(onFace.xy, vec2(0.0), last) + 0.5;
  vec4 found = texture2D(score, vec2(at.x, face * grid.y + at.y) / vec2(grid.x, grid.y * grid.z));
  return judged && found.a > 0.5 ? found.rgb / found.a : vec3(0.58);
}
`;

// The material shows the map between the contact locations; triangles between two faces stay grey: there
// the mean of the squared numbers of the faces is not the square of their mean.
function paint(material, uniforms) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = VERTEX + shader.vertexShader.replace("#include <begin_vertex>", "#include <begin_vertex>\nonFace = vec4(chart, chart.z * chart.z);");
    shader.fragmentShader = FRAGMENT + shader.fragmentShader.replace("#include <color_fragment>", "diffuseColor.rgb = mapColour(diffuseColor.rgb);");
  };
  material.needsUpdate = true;
}

export function makeMaps(scene, object, view) {
  const { content, arrays } = scene;
  const owner = facesOfVertices(scene);
  const [wide, high, faces] = [content.grid.x_mm.length, content.grid.y_mm.length, content.faces.length];
  const places = wide * high;
  const texture = new DataTexture(new Uint8Array(4 * places * faces), wide, high * faces);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = SRGBColorSpace;
  const uniforms = { score: { value: texture }, grid: { value: new Vector3(wide, high, faces) }, mapped: { value: 0 } };
  object.silicone.front.geometry.setAttribute("chart", new BufferAttribute(charts(scene, owner), 3));
  paint(object.silicone.front.material, uniforms);
  let shown = null;

  const fixed = {};
  // Smallest and largest value of a map, or the ends that it was given.
  function endsOf(map) {
    if (fixed[map.stem]) return fixed[map.stem];
    const values = Array.from(arrays[`map_${map.stem}`].data).filter((v) => Number.isFinite(v) && (!map.log || v > 0));
    return [Math.min(...values), Math.max(...values)];
  }
  function scaleOf(map) {
    const ends = endsOf(map);
    const [low, high_] = map.log ? ends.map(Math.log) : ends;
    const share = (value) => ((map.log ? Math.log(value) : value) - low) / (high_ - low || 1);
    const at = (part) => { const v = low + part * (high_ - low); return map.log ? Math.exp(v) : v; };
    return { share: (value) => (map.weak === "high" ? 1 - share(value) : share(value)), at };
  }
  function show(stem) {
    shown = content.maps.find((map) => map.stem === stem) ?? null;
    uniforms.mapped.value = shown ? 1 : 0;
    if (shown) fill(scaleOf(shown), arrays[`map_${stem}`].data);
    view.redraw();
    return shown && { map: shown, at: scaleOf(shown).at };
  }
  function fill(scale, values) {
    const colour = new Color();
    const bytes = {};
    values.forEach((value, index) => {
      const [face, place] = [Math.floor(index / places), index % places];
      const pixel = 4 * ((face * high + (place % high)) * wide + Math.floor(place / high));
      texture.image.data.fill(0, pixel, pixel + 4);
      if (!Number.isFinite(value)) return;
      viridis(scale.share(value), colour).getRGB(bytes, SRGBColorSpace);
      texture.image.data.set([bytes.r, bytes.g, bytes.b, 1].map((v) => 255 * v), pixel);
    });
    texture.needsUpdate = true;
  }
  const valueAt = (face, place) => shown && arrays[`map_${shown.stem}`].data[face * places + place];
  const fix = (stem, ends) => (fixed[stem] = ends);
  return { owner, show, valueAt, shown: () => shown, endsOf, fix };
}

export function drawLegend(box, found) {
  box.hidden = !found;
  if (!found) return;
  const stops = VIRIDIS.map((c) => `#${c.getHexString()}`);
  if (found.map.weak === "high") stops.reverse();
  box.querySelector(".scale").style.background = `linear-gradient(to right, ${stops})`;
  const ticks = box.querySelectorAll(".ticks span");
  ticks.forEach((tick, index) => {
    const text = shownNumber(found.at(index / (ticks.length - 1)));
    if (tick.textContent !== text) tick.textContent = text; // a hand that drags redraws it often
  });
  const { title, unit, log, force_n: force } = found.map;
  box.querySelector(".title").textContent = `${title}, ${unit} at ${force} N${log ? ", logarithmic" : ""}. Dark is weak; grey: not judged.`;
}
