// Contacts on a canvas above the picture of the body: a disc of the 90 % radius, an arrow of the force, its
// number; crosses where labels are. What the body hides is faint and dashed. The picture below stays.
import { Vector3 } from "three";
import { makeDepthMap } from "./depth_map.js";

const COLOUR = "#d81b9a";
const TOLD = "#0b5c3b";
const MM_PER_N = 1.6;
const FAINT = 0.4;
const LEAST_TOLD_N = 0.05; // a load cell at rest
const CORNERS = 40;
const PIECES = 10;
const CIRCLE = Array.from({ length: CORNERS + 1 }, (_, k) => [Math.cos((2 * Math.PI * k) / CORNERS), Math.sin((2 * Math.PI * k) / CORNERS)]);

const along = (from, way, by) => [from[0] + by * way[0], from[1] + by * way[1], from[2] + by * way[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Two directions along the surface.
function tangents([x, y, z]) {
  const first = Math.abs(z) < 0.9 ? [-y, x, 0] : [0, -z, y];
  const length = Math.hypot(...first);
  const [a, b, c] = first.map((one) => one / length);
  return [[a, b, c], [y * c - z * b, z * a - x * c, x * b - y * a]];
}

export function makeContacts(view, canvas, skin) {
  const pen = canvas.getContext("2d");
  const map = makeDepthMap(skin);
  const clear = view.size / 40;
  const eye = new Vector3();
  let [wide, high, ratio, perMm] = [0, 0, 1, 1];
  let matrix = view.camera.projectionMatrix.elements;
  let [contacts, labels] = [[], []];

  // Column and row as shares of the picture, and the distance along the view.
  function project(x, y, z, into) {
    const m = matrix;
    const far = m[3] * x + m[7] * y + m[11] * z + m[15];
    into[0] = 0.5 + (m[0] * x + m[4] * y + m[8] * z + m[12]) / (2 * far);
    into[1] = 0.5 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / (2 * far);
    into[2] = far;
  }
  // A point in pixels, its distance, and whether the body hides it.
  function look(point) {
    const at = [0, 0, 0];
    project(...point, at);
    return { x: at[0] * wide, y: at[1] * high, far: at[2], hidden: map.hides(...at, clear) };
  }
  function follow(camera) {
    camera.updateMatrixWorld();
    matrix = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
    camera.getWorldPosition(eye);
    ratio = Math.min(devicePixelRatio, 2);
    [wide, high] = [canvas.clientWidth, canvas.clientHeight];
    perMm = (camera.projectionMatrix.elements[5] * high) / 2;
    if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(high * ratio)) {
      [canvas.width, canvas.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
    }
    map.draw(project, camera.aspect);
    draw();
  }
  view.before.push(follow);

  // Pieces of a line, those in sight in one stroke and the hidden ones in another.
  function stroke(points, colour, width) {
    const [plain, hidden] = [new Path2D(), new Path2D()];
    let last = null;
    for (let k = 1; k < points.length; k++) {
      const path = points[k - 1].hidden || points[k].hidden ? hidden : plain;
      if (path !== last) path.moveTo(points[k - 1].x, points[k - 1].y);
      path.lineTo(points[k].x, points[k].y);
      last = path;
    }
    [pen.strokeStyle, pen.lineWidth] = [colour, width];
    pen.stroke(plain);
    pen.globalAlpha = FAINT;
    pen.setLineDash([4, 3]);
    pen.stroke(hidden);
    pen.setLineDash([]);
    pen.globalAlpha = 1;
  }
  function turnedAway({ point, normal }) {
    return dot([eye.x - point[0], eye.y - point[1], eye.z - point[2]], normal) < 0;
  }
  function drawDisc(contact) {
    const radius = Number.isFinite(contact.radius) ? Math.max(contact.radius, 0.05) : 0.05;
    const [a, b] = tangents(contact.normal);
    const centre = along(contact.point, contact.normal, 0.15);
    const away = turnedAway(contact);
    const ring = CIRCLE.map(([c, s]) => look(along(along(centre, a, radius * c), b, radius * s)));
    if (away) ring.forEach((one) => (one.hidden = true));
    pen.beginPath();
    ring.forEach(({ x, y }) => pen.lineTo(x, y));
    pen.globalAlpha = away || look(centre).hidden ? 0.12 : 0.3;
    pen.fillStyle = COLOUR;
    pen.fill();
    pen.globalAlpha = 1;
    stroke(ring, COLOUR, 1.5);
  }
  function drawArrow(contact) {
    const size = Math.hypot(...contact.pull);
    if (size < 1e-6) return { ...look(contact.point), left: false };
    const way = contact.pull.map((one) => one / size);
    const length = size * MM_PER_N;
    const thick = view.size / 110;
    const head = Math.min(length, 6 * thick);
    const lifted = along(contact.point, contact.normal, 0.05);
    const points = Array.from({ length: PIECES + 1 }, (_, k) => look(along(lifted, way, -head - ((length - head) * (PIECES - k)) / PIECES)));
    const [tail, base, tip] = [points[0], points[PIECES], look(lifted)];
    const scale = perMm / base.far;
    stroke(points, COLOUR, Math.max(2, 2 * thick * scale));
    const half = 2.6 * thick * scale * (head / (6 * thick));
    const turn = Math.atan2(tip.y - base.y, tip.x - base.x);
    const seen = [eye.x - lifted[0], eye.y - lifted[1], eye.z - lifted[2]];
    const facing = Math.abs(dot(seen, way)) / Math.hypot(...seen);
    pen.globalAlpha = base.hidden || turnedAway(contact) ? FAINT : 1;
    pen.fillStyle = COLOUR;
    pen.beginPath();
    pen.ellipse(base.x, base.y, Math.max(half * facing, 0.1), half, turn, 0, 2 * Math.PI);
    pen.moveTo(base.x - half * Math.sin(turn), base.y + half * Math.cos(turn));
    pen.lineTo(tip.x, tip.y);
    pen.lineTo(base.x + half * Math.sin(turn), base.y - half * Math.cos(turn));
    pen.fill();
    pen.globalAlpha = 1;
    return { ...tail, left: tail.x < tip.x };
  }
  // Beside the arrow's end, away from its tip.
  function drawTag({ force }, { x, y, left }) {
    const text = `${force.toFixed(1)} N`;
    const long = pen.measureText(text).width + 10;
    const from = left ? x - 6 - long : x + 6;
    pen.fillStyle = "#ffffffd8";
    pen.fillRect(from, y - 22, long, 19);
    pen.fillStyle = "#a0126f";
    pen.fillText(text, from + 5, y - 8);
  }
  function drawCross(label) {
    const [a, b] = tangents(label.normal);
    const reach = view.size / 18;
    const centre = along(label.point, label.normal, 0.25);
    for (const way of [a, b]) {
      const ends = [-1, -0.5, 0, 0.5, 1].map((part) => look(along(centre, way, part * reach)));
      if (turnedAway(label)) ends.forEach((one) => (one.hidden = true));
      stroke(ends, TOLD, 2);
    }
  }
  function draw() {
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, wide, high);
    pen.lineCap = "butt";
    pen.font = "600 13px system-ui, sans-serif";
    contacts.forEach(drawDisc);
    labels.forEach(drawCross);
    const tails = contacts.map(drawArrow);
    contacts.forEach((one, k) => drawTag(one, tails[k]));
  }
  function show(found, told) {
    [contacts, labels] = [found, told.filter(({ force }) => force >= LEAST_TOLD_N)];
    draw();
  }
  const hidden = () => contacts.map((one) => turnedAway(one) || look(along(one.point, one.normal, 0.15)).hidden);
  return { show, shown: () => contacts, told: () => labels, hidden };
}
