// The 95 % ellipse of the position bound as a line on the body.
import { BufferGeometry, Float32BufferAttribute, Group, Line, LineBasicMaterial, Raycaster, Vector3 } from "three";
import { row } from "./archive.js";
import { inPlane } from "./maps.js";

const SIGMAS_95 = Math.sqrt(-2 * Math.log(0.05));
const SIDES = 64;
const ABOVE_MM = 0.15;
const [HALO, HALO_LARGER] = [0xffffff, 1.06];
const LARGER = [1, 2, 5, 10, 20, 50, 100];

// Transparent, so that it is drawn after the silicone, which would cover it.
function lineOf(colour) {
  const line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: colour, depthTest: false, transparent: true }));
  line.renderOrder = 6;
  return line;
}

// Half axes and direction of one standard deviation, from a covariance; none where its first entry is null.
export function circleOf(xx, xy, yy) {
  if (xx === null) return { most: NaN, least: NaN, turn: 0 };
  const [half, apart] = [(xx + yy) / 2, Math.hypot((xx - yy) / 2, xy)];
  return { most: Math.sqrt(half + apart), least: Math.sqrt(Math.max(0, half - apart)), turn: Math.atan2(2 * xy, xx - yy) / 2 };
}

// Bounds are in x and y along a face: on a curved one the ellipse is taken down onto the body along the
// normal at the face's middle.
export function makeEllipse({ content, arrays }, object, circle, view, colour) {
  const line = new Group();
  line.add(...[HALO, colour].map(lineOf)); // one of the two stands out on every colour of the map
  line.visible = false;
  const caster = new Raycaster();
  const places = arrays.place_xy_mm.shape[0];
  const scale = scaleOf(content, arrays, circle, view.size);
  let drawn = null;

  function draw(face, place) {
    const { most } = circle(face, place);
    line.visible = Number.isFinite(most);
    const key = `${face} ${place}`;
    if (!line.visible || (drawn === key && content.faces[face].flat)) return;
    drawn = key;
    const origin = new Vector3(...row(arrays.place_mm, face * places + place, 3));
    const [x, y, normal] = ["x", "y", "normal"].map((axis) => new Vector3(...content.faces[face][axis]));
    object.silicone.front.updateWorldMatrix(true, false);
    line.children.forEach((one, index) => {
      const larger = scale * (index ? 1 : HALO_LARGER);
      const points = pointsOf(face, place, origin, [x, y, normal], larger);
      one.geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
      one.geometry.computeBoundingSphere();
    });
  }
  function pointsOf(face, place, origin, [x, y, normal], larger) {
    const { most, least, turn } = circle(face, place);
    const points = [];
    const here = row(arrays.place_xy_mm, place, 2);
    const from = inPlane(content.faces[face], here);
    for (let k = 0; k <= SIDES; k++) {
      const angle = (2 * Math.PI * k) / SIDES;
      const [u, v] = [larger * SIGMAS_95 * most * Math.cos(angle), larger * SIGMAS_95 * least * Math.sin(angle)];
      const moved = [here[0] + u * Math.cos(turn) - v * Math.sin(turn), here[1] + u * Math.sin(turn) + v * Math.cos(turn)];
      const to = inPlane(content.faces[face], moved);
      const at = origin.clone().addScaledVector(x, to[0] - from[0]).addScaledVector(y, to[1] - from[1]);
      const down = content.faces[face].flat ? at : ontoBody(at, normal, 2 * larger * SIGMAS_95 * most + 1);
      if (down) points.push(...down.addScaledVector(normal, ABOVE_MM).toArray());
    }
    return points;
  }
  // null beside the body
  function ontoBody(point, normal, reach) {
    caster.set(point.clone().addScaledVector(normal, reach).add(object.offset()), normal.clone().negate());
    caster.far = 2 * reach;
    const [hit] = caster.intersectObject(object.silicone.front, false);
    return hit ? hit.point.sub(object.offset()) : null;
  }
  return { line, scale, draw, hide: () => (line.visible = false) };
}

// By how much ellipses are drawn larger than they are, so that the middle one can be seen.
function scaleOf({ faces }, { place_xy_mm: xy }, circle, size) {
  const places = xy.shape[0];
  const radii = faces.flatMap((_, face) => Array.from({ length: places }, (__, place) => SIGMAS_95 * circle(face, place).most))
    .filter(Number.isFinite)
    .sort((a, b) => a - b);
  const middle = radii[Math.floor(radii.length / 2)] ?? size;
  return LARGER.find((factor) => factor * middle >= size / 45) ?? LARGER.at(-1);
}
